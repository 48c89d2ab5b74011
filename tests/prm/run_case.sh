#!/usr/bin/env bash
# Run a parameter file and compare its numbers with references:
#   run_case.sh MPIEXEC RANKS DRIVER FILE.prm FOLDER CHECKER REFERENCE [TOLERANCE]
#     [SETTING]
# Lines "#set ENTRY=VALUE" of the reference change entries of the file. With a
# SETTING of its own the run may take other steps than the reference.
set -euo pipefail
mpiexec=$1 ranks=$2 driver=$3 file=$4 folder=$5 checker=$6 reference=$7
settings=()
while IFS= read -r line; do
  settings+=(--set "${line#\#set }")
done < <(grep '^#set ' "$reference" || true)
[ -z "${9:-}" ] || settings+=(--set "$9")
rm -rf "$folder"
"$mpiexec" -n "$ranks" "$driver" "$file" --output "$folder" --quiet \
  "${settings[@]}"
"$checker" "$folder/summary.json" "$reference" ${8:+"$8"} ${9:+any-steps}
