#!/usr/bin/env bash
# Install the build tree into a fresh prefix, build the program of the README
# against it, outside the tree, and run it.
#   run.sh BUILD_TREE BUILD_TYPE WORK_FOLDER
set -euo pipefail
source_dir=$(cd "$(dirname "$0")" && pwd)
rm -rf "$3"
mkdir -p "$3"
cmake --install "$1" --prefix "$3/prefix" > "$3/install.log"
cmake -S "$source_dir" -B "$3/build" -G Ninja -DCMAKE_BUILD_TYPE="$2" \
  -DCMAKE_PREFIX_PATH="$3/prefix" > "$3/configure.log"
cmake --build "$3/build"
LD_LIBRARY_PATH="$3/prefix/lib:$3/prefix/lib/$(uname -m)-linux-gnu:${LD_LIBRARY_PATH:-}" \
  "$3/build/punch"
