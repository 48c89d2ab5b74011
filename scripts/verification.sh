#!/usr/bin/env bash
# Run the verification cases, compare them with their references and draw them:
#   scripts/verification.sh [--slow] [NAME...]
# Results and pictures (run.png): output/verification/NAME.
set -euo pipefail
source "$(dirname "$0")/prepare.sh"
install_missing $build_packages $test_packages $picture_packages
build "$root/build" Release all -- -DMORTAR_CONTACT_TESTS=ON
folders=("$root/prm/verification")
if [ "${1:-}" = --slow ]; then
  folders+=("$root/prm/verification/slow")
  shift
fi
failed=0
for folder in "${folders[@]}"; do
  for expected in "$folder"/*.expected; do
    name=$(basename "$expected" .expected)
    if [ $# -gt 0 ] && ! printf '%s\n' "$@" | grep -qx "$name"; then continue; fi
    out="$root/output/verification/$name"
    mkdir -p "$(dirname "$out")"
    echo "== $name"
    "$root/tests/prm/run_case.sh" mpiexec 1 "$root/build/contact_scene" \
      "$folder/${name%%-*}.prm" "$out" "$root/build/tests/check_numbers" \
      "$expected" || failed=1
    "$root/scripts/plot_run.py" "$out"
  done
done
exit $failed
