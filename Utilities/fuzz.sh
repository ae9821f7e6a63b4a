#!/usr/bin/env bash
# Mutants for every reader, for so many minutes in all; before it every input that once failed. What fails is kept, made
# smaller, in build/fuzz/findings, and the exit code is 1.
#
#     Utilities/fuzz.sh MINUTES [BUILD-DIR [TARGET...]]
#
# BUILD-DIR: build/test, or build/sanitize for mutants under the sanitizers.
# FUZZ_RUNNER, a variable: a command, or a function that is exported, by which dentalscr-fuzz is called in place of directly.
set -euo pipefail
[ "${1:-}" != --help ] || { sed -n '2,8s/^# \?//p' "${BASH_SOURCE[0]}"; exit 0; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."

minutes=${1:?"how many minutes? e.g. Utilities/fuzz.sh 10"}
build=${2:-build/test}
shift $(($# > 2 ? 2 : $#))
fuzz=(${FUZZ_RUNNER:+"$FUZZ_RUNNER"} "$build/bin/dentalscr-fuzz")
[ -x "${fuzz[-1]}" ] || { echo "${fuzz[-1]} is not built: cmake --build $build --target dentalscr-fuzz dentalscr" >&2; exit 2; }

folder=build/fuzz
/usr/bin/python3 Testing/Fuzz/make_seeds.py "$folder" --program "$build/bin/dentalscr"
if [ $# -eq 0 ]; then
  set -- $(cd "$folder/seeds" && echo *)
fi
seconds=$(awk "BEGIN { print $minutes * 60 / $# }")
seed=$(date +%s)
status=0
for target in "$@"; do
  corpus=("$folder/corpus/$target"/*)
  if [ -e "${corpus[0]}" ]; then
    "${fuzz[@]}" "$target" --replay "${corpus[@]}" || status=1
  fi
  # The newest seed is told, so that a run can be repeated.
  "${fuzz[@]}" "$target" --seconds "$seconds" --seed "$seed" --findings "$folder/findings" "$folder/seeds/$target"/* || {
    status=1
    "${fuzz[@]}" "$target" --minimise "$folder/findings/$target-$seed"-* || true
  }
done
exit $status
