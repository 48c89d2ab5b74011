#!/usr/bin/env bash
# Whether Doxygen finds every member of the public headers described, and every link
# of the pages good:
#   check.sh DOXYFILE PARAMETERS.md DRIVER...
set -euo pipefail
doxyfile=$1
shift
"$(dirname "$0")/parameters.sh" "$@"
warnings=$(doxygen "$doxyfile" 2>&1 > /dev/null)
echo "$warnings"
[ -z "$warnings" ]
