#!/usr/bin/env bash
# Install the build tree into a fresh prefix, build the programs of the README and of
# examples/ against it, outside the tree, and run them.
#   run.sh BUILD_TREE BUILD_TYPE WORK_FOLDER
set -euo pipefail
source_dir=$(cd "$(dirname "$0")" && pwd)
type=$2 work=$3
rm -rf "$work"
mkdir -p "$work"
cmake --install "$1" --prefix "$work/prefix" > "$work/install.log"
library_path="$work/prefix/lib:$work/prefix/lib/$(uname -m)-linux-gnu:${LD_LIBRARY_PATH:-}"

# build_and_run SOURCE PROGRAM...
build_and_run() {
  local build
  build=$work/$(basename "$1")
  cmake -S "$1" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE="$type" \
    -DCMAKE_PREFIX_PATH="$work/prefix" > "$build.log"
  cmake --build "$build"
  shift
  for program in "$@"; do
    (cd "$build" && LD_LIBRARY_PATH=$library_path "./$program")
  done
}

build_and_run "$source_dir" punch

# the tutorial's programs, whose difference its page shows
example=$source_dir/../../examples/two_beams
build_and_run "$example" plain with_contact
bash "$example/make_readme.sh" | diff - "$example/README.md"
