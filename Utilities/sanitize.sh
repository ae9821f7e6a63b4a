#!/usr/bin/env bash
# Tests under the address and undefined-behaviour sanitizers.
#
#     Utilities/sanitize.sh           the whole suite, in build/sanitize; hours on two cores
#     Utilities/sanitize.sh readers   the readers' and kernels' tests of build/test, every input that once failed and 39 s of
#                                     mutants, with sanitized libraries of these (build/sanitize-readers); 106 files to compile
set -euo pipefail
[ "${1:-}" != --help ] || { sed -n '2,6s/^# \?//p' "${BASH_SOURCE[0]}"; exit 0; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."

export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1
# A report ends the test. fontconfig never lets go of what it has read; decoders leak what they refuse, and end.
export ASAN_OPTIONS=detect_stack_use_after_return=1:allocator_may_return_null=1
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
export LSAN_OPTIONS="suppressions=$PWD/Utilities/leak-suppressions.txt:print_suppressions=0"

status=0
if [ "${1:-}" = readers ]; then
  libraries=(DentalCommon Annotation Cephalogram MeshOpenMesh MeshVTK ContourMetric RegistrationCommon)
  cmake --preset sanitize-readers >/dev/null
  cmake --build --preset sanitize-readers --target "${libraries[@]}" dentalscr-decode
  cmake --build --preset test --target "${libraries[@]/%/GTestDriver}" dentalscr dentalscr-fuzz
  # Tests of the release build, with these libraries in the place of its own: they are what is looked at, and tests take longer to compile
  # than they do. The sanitizers' own libraries have to be the first.
  preload="$(c++ -print-file-name=libasan.so):$(c++ -print-file-name=libubsan.so)"
  sanitized() { env LD_PRELOAD="$preload" LD_LIBRARY_PATH="$PWD/build/sanitize-readers/lib" "$@"; }
  export preload
  export -f sanitized
  loaded="$(LD_LIBRARY_PATH="$PWD/build/sanitize-readers/lib" ldd build/test/bin/AnnotationGTestDriver)"
  [[ "$loaded" == *build/sanitize-readers/lib/libDentalSCRAnnotation* ]] || { echo "the sanitized libraries are not loaded" >&2; exit 2; }
  for library in "${libraries[@]}"; do
    # The sanitizer takes the signal by which a decoder would end.
    sanitized "build/test/bin/${library}GTestDriver" --gtest_brief=1 \
      --gtest_filter=-DecoderProcess.DiesAloneAndIsToldByItsSignal || status=1
  done
  # Three seconds for each of the 13 readers.
  FUZZ_RUNNER=sanitized Utilities/fuzz.sh 0.65 build/test || status=1
else
  cmake --preset sanitize >/dev/null
  cmake --build --preset sanitize
  ctest --preset sanitize || status=1
  /usr/bin/python3 -m pytest -q -p no:cacheprovider Testing/CommandLine --build-dir build/sanitize || status=1
  Utilities/fuzz.sh 5 build/sanitize || status=1
fi
exit $status
