#!/usr/bin/env bash
# Mistakes on purpose: applies each mutation of Utilities/mutations.txt to a tree of its own, builds and runs the tests beside
# it, and lists what no test notices. What is committed is mutated, in build/mutate, so that nothing of this tree is touched.
#
#     Utilities/mutate.sh [--check] [PATTERN...]
#
# PATTERN: mutations whose file or words contain one of these alone. --check: only whether each still stands in its file once.
# Exit code: 1 where a mutation survives that isn't told to be equivalent, or where the list is not true.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [ "${1:-}" = --check ]; then
  shift
  exec /usr/bin/python3 Utilities/mutate.py --check "$PWD" "$@"
fi
tree="$PWD/build/mutate"
list="$PWD/Utilities/mutations.txt"
program="$PWD/Utilities/mutate.py"
if [ ! -e "$tree/.git" ]; then
  git worktree prune
  git worktree add --force --detach "$tree" HEAD
fi
# Of a run that was killed a mutation may be left; builds stay.
git -C "$tree" checkout --force --detach "$(git rev-parse HEAD)"
trap 'git -C "$tree" checkout --force -- . ' EXIT
export CCACHE_BASEDIR="$tree" CCACHE_NOHASHDIR=1
# A test that is linked with a shared library isn't linked anew where that alone has changed.
cmake -S "$tree" -B "$tree/build/test" -G Ninja -DCMAKE_BUILD_TYPE=Release -DDENTALSCR_BUILD_TESTING=ON \
  -DCMAKE_LINK_DEPENDS_NO_SHARED=ON -Wno-dev >/dev/null
/usr/bin/python3 "$program" --list "$list" "$tree" "$@"
