#!/usr/bin/env bash
# Build everything in Release and run all tests but those labelled slow:
#   scripts/test.sh [options of ctest]
# Installs what is missing (Debian 12).
set -euo pipefail
source "$(dirname "$0")/prepare.sh"
install_missing $build_packages $test_packages
build "$root/build" Release all -- -DMORTAR_CONTACT_TESTS=ON \
  -DMORTAR_CONTACT_WERROR="${WERROR:-OFF}"
cd "$root/build"
ctest --output-on-failure -j 2 -LE slow "$@"
