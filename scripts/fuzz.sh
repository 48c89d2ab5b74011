#!/usr/bin/env bash
# Fuzz the readers of parameter files, meshes and checkpoints with libFuzzer:
#   scripts/fuzz.sh [RUNS]
# RUNS inputs each (10000), always the same ones: the seed is fixed. Needs the Release
# build of scripts/test.sh; the readers are compiled again by clang with coverage and
# address sanitizer, the rest is linked as it is. Installs what is missing (Debian 12).
set -euo pipefail
source "$(dirname "$0")/prepare.sh"
runs=${1:-10000}
install_missing clang-14 libclang-rt-14-dev
build=$root/build
work=$build/fuzz
mkdir -p "$work"

# what the build itself compiles and links with
objects=applications/CMakeFiles/structure.dir
flags=$(ninja -C "$build" -t commands "$objects/structure/scene.cc.o" | tail -1 |
  grep -oE ' (-D|-I|-isystem )[^ ]+' | tr '\n' ' ')
libraries=$(ninja -C "$build" -t commands contact_scene | tail -1 |
  sed 's/.* -o contact_scene//; s/ && .*//')

compile() { # SOURCE OBJECT
  clang++-14 $flags "-I$root/applications" -std=c++17 -O1 -w \
    -fsanitize=fuzzer-no-link,address -c "$1" -o "$2"
}
readers=(structure/scene structure/scene_source structure/suggestion structure/checkpoint
  geometry/mesh_maker geometry/mesh_parameters geometry/gmsh_check geometry/shell_file
  geometry/surface_reader)
targets=(parameters meshes checkpoints)
made=() compilers=()
for reader in "${readers[@]}"; do
  object=$work/$(basename "$reader").o
  made+=("$object")
  while [ "$(jobs -rp | wc -l)" -ge 2 ]; do sleep 1; done
  compile "$root/applications/$reader.cc" "$object" &
  compilers+=($!)
done
for target in "${targets[@]}"; do
  while [ "$(jobs -rp | wc -l)" -ge 2 ]; do sleep 1; done
  compile "$root/tests/fuzz/$target.cc" "$work/$target.o" &
  compilers+=($!)
done
for compiler in "${compilers[@]}"; do wait "$compiler"; done

# first inputs; the first byte chooses a reader, see tests/fuzz
seeds=$work/seeds
rm -rf "$seeds"
mkdir -p "$seeds"/{parameters,meshes,checkpoints}
for file in "$root"/prm/tutorial/0[1367]*.prm; do
  { printf '#'; cat "$file"; } > "$seeds/parameters/$(basename "$file")"
done
printf '%s' '{{"Driver": "contact_scene", "Bodies": {"Names": "b"}}' > "$seeds/parameters/json"
{ printf 'i'; cat "$root/prm/verification/shell_mixed.inp"; } > "$seeds/meshes/inp"
{ printf 'm'; cat "$root/prm/tutorial/08_hook.msh"; } > "$seeds/meshes/msh"
printf 'ssolid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n' \
  > "$seeds/meshes/stl"
"$build/contact_scene" "$root/prm/tutorial/01_two_blocks.prm" --quiet \
  --output "$work/run" --set "Output/Every=0"
cp "$work/run/checkpoint/state" "$seeds/checkpoints/"

# containers cross between code with and without the sanitizer
export ASAN_OPTIONS=detect_leaks=0:detect_container_overflow=0:abort_on_error=0
export FUZZ_FOLDER=$work/files
mkdir -p "$FUZZ_FOLDER"
for target in "${targets[@]}"; do
  (cd "$build" && clang++-14 -fsanitize=fuzzer,address "$work/$target.o" "${made[@]}" \
    $libraries -o "$work/$target")
  echo "== fuzzing $target, $runs inputs"
  (cd "$work" && "./$target" -seed=1 -runs="$runs" -timeout=20 -rss_limit_mb=4096 \
    -max_len=20000 -print_final_stats=1 -artifact_prefix="$work/$target-" \
    "$seeds/$target" > "$target.log" 2>&1) || {
    tail -40 "$work/$target.log"
    echo "FAILED: see $work/$target-*"
    exit 1
  }
  grep -E "^stat::number_of_executed_units|^Done" "$work/$target.log"
done
