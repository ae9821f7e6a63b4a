#!/usr/bin/env bash
# Installs, builds and runs every test: ctest for the toolkit, pytest for the program and what is installed, doxygen and
# the site for the words. Two tests at a time, as most of them keep one core busy.
set -euo pipefail
[ "${1:-}" != --help ] || { sed -n '2,3s/^# \?//p' "${BASH_SOURCE[0]}"; exit 0; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Paths relative to the tree, so that the wheel's objects are those of the build tree.
export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1

Utilities/install-dependencies.sh browser
Utilities/python-venv.sh &
venv=$!
cmake --preset test >/dev/null
cmake --build --preset test

status=0
ctest --preset test || status=1
wait $venv || true
# The files of the slowest tests are one group, and each other file is one (Testing/conftest.py).
/usr/bin/python3 -m pytest -q -p no:cacheprovider -n 2 --dist loadgroup Testing --ignore Testing/Browser \
  --build-dir build/test || status=1
python=build/python-venv/bin/python
[ -x "$python" ] || python=/usr/bin/python3
# The page in a browser needs packages of the Python environment; without them it says that it is skipped.
"$python" -m pytest -q -rs -p no:cacheprovider Testing/Browser --build-dir build/test || status=1
"$python" -m pytest -q -p no:cacheprovider Wrapping/Python/tests --build-dir build/test || status=1
# Pages of the classes, and the site, which needs packages as well; without them it says that it is not built.
Utilities/site.sh || site=$?
[ "${site:-0}" -eq 0 ] || [ "$site" -eq 5 ] || status=1
exit $status
