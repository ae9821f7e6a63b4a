#!/usr/bin/env bash
# Installs what building and testing need from Debian's packages. Does nothing where all of it is there.
#   Utilities/install-dependencies.sh [build] [test] [browser] [slurm] [threads]
# build: what compiling the program, the libraries and the Python package needs, and nothing else.
# test: that, and what the tests, the benchmarks and the pages of the site need; this is what is installed without a word.
# browser: also a browser, for the tests of pages. slurm: also Slurm, for Utilities/test-cohort.sh. threads: also valgrind, for
# Utilities/sanitize.sh threads.
set -euo pipefail

build=(
  g++ cmake ninja-build ccache pkg-config
  libinsighttoolkit5-dev libvtk9-dev libopenmesh-dev libeigen3-dev
  libexpat1-dev libtiff-dev zlib1g-dev nlohmann-json3-dev libcli11-dev libcairo2-dev nettle-dev libcsv-dev libminizip-dev
  libmeshoptimizer-dev libkainjow-mustache-dev libcpp-httplib-dev fonts-dejavu-core
  python3 python3-dev python3-venv pybind11-dev
)
tests=(
  libgtest-dev python3-pytest python3-pytest-xdist python3-numpy
  xvfb xauth python3-matplotlib python3-scipy
  libbenchmark-dev libnanoflann-dev
  doxygen
)

packages=("${build[@]}")
[ $# -gt 0 ] || set -- test
for part in "$@"; do
  case "$part" in
    build) ;;
    test) packages+=("${tests[@]}") ;;
    browser)
      packages+=("${tests[@]}")
      command -v chromium chromium-browser google-chrome >/dev/null || packages+=(chromium)
      ;;
    slurm) packages+=("${tests[@]}" slurmctld slurmd slurm-client munge) ;;
    threads) packages+=("${tests[@]}" valgrind) ;;
    *) sed -n '2,7s/^# \?//p' "${BASH_SOURCE[0]}"; [ "$part" = --help ] && exit 0; exit 2 ;;
  esac
done

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

sudo=()
if [ "$(id -u)" -ne 0 ]; then
  sudo=(sudo)
fi
echo "Installing ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${sudo[@]}" apt-get update -qq
"${sudo[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
