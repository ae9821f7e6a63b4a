#!/usr/bin/env bash
# Mistakes on purpose: applies each mutation of Utilities/mutations.txt to a tree of its own, builds and runs the tests beside
# it, and lists what no test notices. What is committed is mutated, in build/mutate, so that nothing of this tree is touched.
#
#     Utilities/mutate.sh [--check] [--tests BUILD] [PATTERN...]
#
# PATTERN: mutations whose file or words contain one of these alone. --check: only whether each still stands in its file once.
# BUILD: whose tests are run, build/test, which has to be built of what is committed. They are linked with shared libraries, and
# so a mutation takes one file to compile and one library to link.
# Exit code: 1 where a mutation survives that isn't told to be equivalent, or where the list is not true.
set -euo pipefail
[ "${1:-}" != --help ] || { sed -n '2,10s/^# \?//p' "${BASH_SOURCE[0]}"; exit 0; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [ "${1:-}" = --check ]; then
  shift
  exec /usr/bin/python3 Utilities/mutate.py --check "$PWD" "$@"
fi
tests="$PWD/build/test"
if [ "${1:-}" = --tests ]; then
  tests="$(realpath "$2")"
  shift 2
fi
[ -x "$tests/bin/dentalscr" ] || { echo "$tests is not built" >&2; exit 2; }
tree="$PWD/build/mutate"
list="$PWD/Utilities/mutations.txt"
program="$PWD/Utilities/mutate.py"
if [ ! -e "$tree/.git" ]; then
  git worktree prune
  git worktree add --quiet --force --detach "$tree" HEAD
fi
# Of a run that was killed a mutation may be left; builds stay.
git -C "$tree" checkout --quiet --force --detach "$(git rev-parse HEAD)"
trap 'git -C "$tree" checkout --quiet --force -- .' EXIT
export CCACHE_BASEDIR="$tree" CCACHE_NOHASHDIR=1
# What is linked with a shared library isn't linked anew where that alone has changed.
cmake -S "$tree" -B "$tree/build/test" -G Ninja -DCMAKE_BUILD_TYPE=Release -DDENTALSCR_BUILD_TESTING=OFF \
  -DDENTALSCR_BUILD_EXAMPLES=OFF -DCMAKE_LINK_DEPENDS_NO_SHARED=ON -Wno-dev >/dev/null
/usr/bin/python3 "$program" --list "$list" --tests "$tests" "$tree" "$@"
