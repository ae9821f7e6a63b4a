#!/usr/bin/env bash
# Tests under the sanitizers: of addresses and undefined behaviour, or of threads.
#
#     Utilities/sanitize.sh [whole [MODULE...]]
#                                     the whole suite, tests and all, in build/sanitize: hours on two cores; or the tests of these modules
#                                     alone, in build/sanitize-modules
#     Utilities/sanitize.sh libraries the whole suite, with the program and all libraries sanitized (build/sanitize-libraries) and the
#                                     tests' own files as they are in build/test; an hour
#     Utilities/sanitize.sh readers   the readers' and kernels' tests of build/test, every input that once failed and 30 s of
#                                     mutants, with sanitized libraries of these (build/sanitize-readers); CI runs it
#     Utilities/sanitize.sh threads   the tests of what works in threads, and a registration in four, of build/test under
#                                     helgrind (valgrind); five minutes
#
# Exit code: 1 where there is a report or a test fails.
set -euo pipefail
[ "${1:-}" != --help ] || { sed -n '2,14s/^# \?//p' "${BASH_SOURCE[0]}"; exit 0; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."

export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1
# A report ends the test. fontconfig never lets go of what it has read; decoders leak what they refuse, and end.
export ASAN_OPTIONS=detect_stack_use_after_return=1:allocator_may_return_null=1
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
export LSAN_OPTIONS="suppressions=$PWD/Utilities/leak-suppressions.txt:print_suppressions=0"

# The sanitizer takes the signal by which a decoder would end, and its memory beside each thread is more than a limit leaves.
unfit="DecoderProcess.DiesAloneAndIsToldByItsSignal:ParallelFor.WhereThreadsCannotBeStarted*"

status=0
if [ "${1:-}" = threads ]; then
  command -v valgrind >/dev/null || Utilities/install-dependencies.sh threads
  tests=(
    # The first has a limit of processes, which helgrind's own threads take.
    "DentalCommon:ParallelFor.*-*WhereThreadsCannotBeStarted*"
    "SurfaceDRR:*Thread*:*Abort*"
    "SilhouetteContour:*Thread*:*Strips*"
    "UMidlineDentalAxis:*Thread*:*WorkUnits*"
    "Batch:*Runner*:*Queue*"
  )
  drivers=("${tests[@]%%:*}")
  cmake --build --preset test --target "${drivers[@]/%/GTestDriver}" dentalscr
  # Helgrind and not the compiler's sanitizer: it needs no build of its own, and sees ITK and Eigen as well.
  watched() {
    valgrind -q --tool=helgrind --history-level=approx --error-exitcode=66 --suppressions=Utilities/thread-suppressions.txt "$@"
  }
  for test in "${tests[@]}"; do
    watched "build/test/bin/${test%%:*}GTestDriver" --gtest_brief=1 --gtest_filter="${test#*:}" || status=1
  done
  folder="$(mktemp -d)"
  trap 'rm -rf "$folder"' EXIT
  build/test/bin/dentalscr phantom --triangles 3000 --seed 1 --output "$folder/case" --quiet
  # 1 is a jaw that is not ok.
  watched build/test/bin/dentalscr register "$folder/case/case.json" --threads 4 --output "$folder/result" --quiet || [ $? -eq 1 ] || status=1
elif [ "${1:-}" = readers ] || [ "${1:-}" = libraries ]; then
  # Of a name that fuzz.sh, which gets it, has for nothing else.
  sanitized_build="$PWD/build/sanitize-$1"
  cmake --preset "sanitize-$1" >/dev/null
  if [ "$1" = readers ]; then
    libraries=(DentalCommon Annotation Cephalogram MeshOpenMesh MeshVTK ContourMetric RegistrationCommon)
    cmake --build --preset sanitize-readers --target "${libraries[@]}" dentalscr-decode
    cmake --build --preset test --target "${libraries[@]/%/GTestDriver}" dentalscr dentalscr-fuzz
    drivers=("${libraries[@]/%/GTestDriver}")
  else
    cmake --build --preset sanitize-libraries
    cmake --build --preset test
    drivers=(build/test/bin/*GTestDriver)
    drivers=("${drivers[@]##*/}")
  fi
  # Beside them: an Xvfb that is none of what is looked at (under the sanitizer the compiler of its keyboard leaks, which it takes for a
  # failure), and libraries that stay loaded (what a driver of OpenGL has when it is unloaded is nobody's any more, and told as a leak).
  beside="$(mktemp -d)"
  trap 'rm -rf "$beside"' EXIT
  if screen="$(command -v Xvfb)"; then
    printf '#!/bin/sh\nunset LD_PRELOAD LD_LIBRARY_PATH\nexec %s "$@"\n' "$screen" >"$beside/Xvfb"
    chmod +x "$beside/Xvfb"
    export PATH="$beside:$PATH"
  fi
  echo 'int dlclose(void *library) { return library == 0; }' | cc -shared -fPIC -x c -o "$beside/stay.so" -
  # Tests of the release build, with these libraries in the place of its own: they are what is looked at, and tests take longer to compile
  # than they do. The sanitizers' own libraries have to be the first.
  preload="$(c++ -print-file-name=libasan.so):$(c++ -print-file-name=libubsan.so):$beside/stay.so"
  sanitized() { env LD_PRELOAD="$preload" LD_LIBRARY_PATH="$sanitized_build/lib" "$@"; }
  export preload sanitized_build
  export -f sanitized
  loaded="$(LD_LIBRARY_PATH="$sanitized_build/lib" ldd build/test/bin/AnnotationGTestDriver)"
  [[ "$loaded" == *"$sanitized_build"/lib/libDentalSCRAnnotation* ]] || { echo "the sanitized libraries are not loaded" >&2; exit 2; }
  for driver in "${drivers[@]}"; do
    sanitized "build/test/bin/$driver" --gtest_brief=1 --gtest_filter="-$unfit" || status=1
  done
  if [ "$1" = readers ]; then
    # Three seconds for each reader that is in these libraries; the others are read by the release build alone.
    FUZZ_RUNNER=sanitized Utilities/fuzz.sh 0.5 build/test \
      archive cephalometric contours image labelmap landmarks2d landmarks3d mask scan session || status=1
  else
    # With a path of libraries: the sanitizer's dlopen() knows nothing of the run path of who has called it.
    # Of pictures in space without leaks: the program, which has the sanitizer in it, lets the driver of OpenGL go (stay.so is
    # of the drivers alone, which look for leaks of these libraries), and VTK leaks what it can't write.
    export LD_LIBRARY_PATH="$sanitized_build/lib"
    commands=(/usr/bin/python3 -m pytest -q -p no:cacheprovider --build-dir "$sanitized_build")
    "${commands[@]}" Testing/CommandLine --ignore Testing/CommandLine/test_view.py || status=1
    ASAN_OPTIONS="$ASAN_OPTIONS:detect_leaks=0" "${commands[@]}" Testing/CommandLine/test_view.py || status=1
    unset LD_LIBRARY_PATH
    FUZZ_RUNNER=sanitized Utilities/fuzz.sh 5 build/test || status=1
  fi
else
  [ "${1:-whole}" = whole ] || { echo "$1: whole, libraries, readers or threads" >&2; exit 2; }
  shift $(($# > 0 ? 1 : 0))
  build=build/sanitize
  if [ $# -gt 0 ]; then
    build=build/sanitize-modules
    modules="$(IFS=';'; echo "$*")"
  fi
  cmake --preset sanitize -B "$build" -DDENTALSCR_ONLY_MODULES="${modules:-}" >/dev/null
  cmake --build "$build"
  # The sanitizer's dlopen() knows nothing of the run path of who has called it.
  export LD_LIBRARY_PATH="$PWD/$build/lib"
  unfit="${unfit//:/|}"
  ctest --test-dir "$build" --output-on-failure -j 2 -E "${unfit//\*/}" || status=1
  if [ -z "${modules:-}" ]; then
    /usr/bin/python3 -m pytest -q -p no:cacheprovider Testing/CommandLine --build-dir "$build" || status=1
    Utilities/fuzz.sh 5 "$build" || status=1
  fi
fi
exit $status
