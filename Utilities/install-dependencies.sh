#!/usr/bin/env bash
# Installs what building and testing need from Debian's packages. Does nothing where all of it is there.
# With "browser" also a browser, which the tests of pages need and nothing else; with "slurm" also Slurm, for Utilities/test-cohort.sh.
set -euo pipefail

packages=(
  g++ cmake ninja-build ccache pkg-config
  libinsighttoolkit5-dev libvtk9-dev libopenmesh-dev libeigen3-dev
  libexpat1-dev libtiff-dev zlib1g-dev nlohmann-json3-dev libcli11-dev libcairo2-dev nettle-dev libcsv-dev libminizip-dev
  libmeshoptimizer-dev libkainjow-mustache-dev libcpp-httplib-dev fonts-dejavu-core
  libgtest-dev python3 python3-pytest python3-numpy
  python3-dev python3-venv pybind11-dev
  xvfb xauth python3-matplotlib python3-scipy
  libbenchmark-dev libnanoflann-dev
  doxygen
)

if [ "${1:-}" = browser ] && ! command -v chromium chromium-browser google-chrome >/dev/null; then
  packages+=(chromium)
elif [ "${1:-}" = slurm ]; then
  packages+=(slurmctld slurmd slurm-client munge)
fi

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
