#!/usr/bin/env bash
# Makes build/python-venv with the packages that the Python tests work with, and build/cohort-venv with the workflow engine of
# Examples/Cohort, whose packages are locked to versions of their own. Where no package index is reachable it says so and leaves a
# file with the reason: the tests that need one are skipped.
set -euo pipefail
[ "${1:-}" != --help ] || { sed -n '2,4s/^# \?//p' "${BASH_SOURCE[0]}"; exit 0; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# make FOLDER WORD...: an environment with what pip installs of these words.
make() {
  local folder=build/$1 log=build/$1.log stamp=build/$1/packages.txt wanted
  shift
  # A list in a file counts by what is in it.
  wanted="$* $(for word in "$@"; do [ ! -f "$word" ] || cat "$word"; done)"
  [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$wanted" ] && return 0
  rm -rf "$folder"
  mkdir -p build
  /usr/bin/python3 -m venv "$folder"
  if "$folder/bin/python" -m pip install -q --disable-pip-version-check --only-binary :all: "$@" > "$log" 2>&1; then
    echo "$wanted" > "$stamp"
    rm -f "$log"
  else
    echo "The packages of $folder can't be installed; see $log" >&2
    rm -rf "$folder"
  fi
}

make python-venv -r Wrapping/Python/tests/requirements.txt
# connection_pool comes as source alone.
make cohort-venv --no-binary connection_pool -r Examples/Cohort/requirements.txt
