#!/usr/bin/env bash
# Sourced by the other scripts: installs what is missing (Debian), says what it
# does, and sets what OpenMPI wants. Does nothing where all is there.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

# install_missing PACKAGE...: with apt, only those that are not there
install_missing() {
  local missing=()
  for package in "$@"; do
    if ! dpkg-query -W -f='${Status}' "$package" 2>/dev/null |
      grep -q "install ok installed"; then
      missing+=("$package")
    fi
  done
  [ ${#missing[@]} = 0 ] && return 0
  if ! command -v apt-get > /dev/null; then
    echo "ERROR: these Debian packages (or what they hold) are missing, and" \
      "there is no apt-get to install them: ${missing[*]}" >&2
    exit 1
  fi
  echo "Installing ${missing[*]}"
  as_root apt-get update -qq
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" > /dev/null
}

# An optimised serial BLAS: the reference one makes direct solves 3 to 4 times
# slower, and a threaded one gets in the way of MPI ranks.
build_packages="g++ cmake ninja-build ccache libdeal.ii-dev libmumps-dev libopenblas0-serial \
  nlohmann-json3-dev libcli11-dev"
test_packages="libgtest-dev"
picture_packages="python3-vtk9 python3-matplotlib"

# OpenMPI refuses to run as root, and more ranks than cores, unless told.
if [ "$(id -u)" = 0 ]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
export OMPI_MCA_rmaps_base_oversubscribe=1
# Quiet where containers forbid the kernel's copy between processes.
export OMPI_MCA_btl_vader_single_copy_mechanism=none
export OMP_NUM_THREADS=1 DEAL_II_NUM_THREADS=1

# build TARGETS FOLDER TYPE [CMAKE OPTIONS]: configure once, build on two cores
build() {
  local folder=$1 type=$2
  shift 2
  local targets=()
  while [ $# -gt 0 ] && [ "$1" != -- ]; do
    targets+=("$1")
    shift
  done
  [ "${1:-}" = -- ] && shift
  local launcher=()
  if command -v ccache > /dev/null; then
    launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  local log
  log=$(mktemp)
  if ! cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE="$type" \
    "${launcher[@]}" "$@" > "$log" 2>&1; then
    cat "$log" >&2
    exit 1
  fi
  rm -f "$log"
  cmake --build "$folder" -j 2 --target "${targets[@]}"
}
