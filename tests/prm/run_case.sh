#!/usr/bin/env bash
# Run a parameter file and compare its numbers with references:
#   run_case.sh MPIEXEC RANKS DRIVER FILE.prm FOLDER CHECKER REFERENCE [TOLERANCE]
set -euo pipefail
mpiexec=$1 ranks=$2 driver=$3 file=$4 folder=$5 checker=$6 reference=$7
rm -rf "$folder"
"$mpiexec" -n "$ranks" "$driver" "$file" --output "$folder" --quiet
"$checker" "$folder/summary.json" "$reference" ${8:+"$8"}
