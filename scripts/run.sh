#!/usr/bin/env bash
# Run the driver that a parameter file belongs to:
#   scripts/run.sh FILE.prm [options of the driver]
# Installs what is missing (Debian 12), builds in Release, runs on two ranks
# where there are two cores. RANKS=n chooses the number.
set -euo pipefail
source "$(dirname "$0")/prepare.sh"

if [ $# = 0 ] || [ "$1" = --help ]; then
  sed -n '2,5s/^# //p' "$0"
  exit 1
fi
file=$1
if [ ! -r "$file" ]; then
  echo "ERROR: the parameter file '$file' cannot be read." >&2
  exit 1
fi
# in a .prm or a .json file
driver=$(sed -n -e 's/^[[:space:]]*set[[:space:]]\+Driver[[:space:]]*=[[:space:]]*\([a-z_]*\).*/\1/p' \
  -e 's/.*"Driver"[[:space:]]*:[[:space:]]*"\([a-z_]*\)".*/\1/p' "$file" | head -1)
if [ -z "$driver" ] || [ ! -f "$root/applications/$driver.cc" ]; then
  known=$(cd "$root/applications" && ls ./*.cc | sed 's/^\.\///; s/\.cc$//' | tr '\n' ' ')
  echo "ERROR: '$file' says 'set Driver = $driver'; expected one of: $known" >&2
  exit 1
fi

install_missing $build_packages
build "$root/build" Release "$driver" -- -DMORTAR_CONTACT_TESTS=OFF

# nproc listens to OMP_NUM_THREADS
ranks=${RANKS:-$(env -u OMP_NUM_THREADS nproc)}
[ -z "${RANKS:-}" ] && [ "$ranks" -gt 2 ] && ranks=2
[ "$driver" = immersed_leaflets ] && ranks=1 # it is not parallel
# Pictures, and a page with all of the run, where there is one.
pictures=(--pictures)
case " $* " in
  *" --check "* | *" --print-parameters "* | *" --help "* | *" --version "*) pictures=() ;;
  *)
    if ! (install_missing $picture_packages); then
      echo "WARNING: there will be no pictures." >&2
      pictures=()
    fi
    ;;
esac
# Colours for terminals only: the ranks write to one that mpirun makes.
[ -t 1 ] || export NO_COLOR=1
# Memory in large pages: a loop that reads a matrix was a quarter faster with them.
export GLIBC_TUNABLES=${GLIBC_TUNABLES:-glibc.malloc.hugetlb=1}
# Ctrl-C goes to this script, which asks the ranks to finish their step and save;
# mpirun would end them within two seconds.
set -m
mpirun --quiet -np "$ranks" "$root/build/$driver" "$@" "${pictures[@]}" &
run=$!
trap 'echo "Stopping after this step (again: at once) ..." >&2
  trap "kill -KILL $run" INT
  kill -USR1 $run' INT TERM
code=0
wait $run || code=$?
while kill -0 $run 2> /dev/null; do
  code=0
  wait $run || code=$?
done
exit $code
