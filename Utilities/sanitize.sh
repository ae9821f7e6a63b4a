#!/usr/bin/env bash
# The whole test suite under the address and undefined-behaviour sanitizers: build/sanitize.
#
#     Utilities/sanitize.sh           everything; an hour and more on two cores
#     Utilities/sanitize.sh readers   the readers' and kernels' tests, and a minute of mutants
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1
# A report ends the test. fontconfig never lets go of what it has read; decoders leak what they refuse, and end.
export ASAN_OPTIONS=detect_stack_use_after_return=1:allocator_may_return_null=1
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
export LSAN_OPTIONS="suppressions=$PWD/Utilities/leak-suppressions.txt:print_suppressions=0"

cmake --preset sanitize >/dev/null
status=0
if [ "${1:-}" = readers ]; then
  drivers=(DentalCommon Annotation Cephalogram MeshOpenMesh MeshVTK ContourMetric RegistrationCommon)
  cmake --build --preset sanitize --target "${drivers[@]/%/GTestDriver}" dentalscr dentalscr-fuzz
  for driver in "${drivers[@]}"; do
    "build/sanitize/bin/${driver}GTestDriver" --gtest_brief=1 || status=1
  done
  Utilities/fuzz.sh 1 build/sanitize || status=1
else
  cmake --build --preset sanitize
  ctest --preset sanitize || status=1
  /usr/bin/python3 -m pytest -q -p no:cacheprovider Testing/CommandLine --build-dir build/sanitize || status=1
  Utilities/fuzz.sh 5 build/sanitize || status=1
fi
exit $status
