#!/usr/bin/env bash
# Installs, builds and runs every test: ctest for the toolkit, pytest for the program and what is installed, doxygen for
# the words on the classes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

Utilities/install-dependencies.sh
cmake --preset test >/dev/null
cmake --build --preset test

status=0
ctest --preset test || status=1
/usr/bin/python3 -m pytest -q -p no:cacheprovider Testing --build-dir build/test || status=1
/usr/bin/python3 -m pytest -q -p no:cacheprovider Wrapping/Python/tests --build-dir build/test || status=1
Utilities/doxygen.sh || status=1
exit $status
