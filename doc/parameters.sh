#!/usr/bin/env bash
# All entries of the drivers with their help, as a page:
#   parameters.sh OUTPUT.md DRIVER...
set -euo pipefail
page=$1
shift
{
  echo "# Parameters"
  echo
  echo "What each driver says to \`--print-parameters\`: all entries with their"
  echo "defaults, units in brackets."
  for driver in "$@"; do
    echo
    echo "## $(basename "$driver")"
    echo
    echo '```'
    "$driver" --print-parameters
    echo '```'
  done
} > "$page"
