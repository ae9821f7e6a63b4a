#!/usr/bin/env bash
# Makes build/python-venv with the packages that the Python tests work with. Where no package index is reachable it says so and
# leaves a file with the reason: the tests that need it are skipped.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=build/python-venv
# Debian's pybind11, with which the build tree's package is made, knows no numpy 2; the wheel is tested with it.
packages=("numpy<2" SimpleITK itk trimesh pyvista meshio mypy pybind11-stubgen==3.0.0 pytest
  "pybind11>=2.13,<3" scikit-build-core nbclient ipykernel playwright)
stamp="$folder/packages.txt"
[ -f "$stamp" ] && [ "$(cat "$stamp")" = "${packages[*]}" ] && exit 0
rm -rf "$folder"
mkdir -p build
/usr/bin/python3 -m venv "$folder"
if "$folder/bin/python" -m pip install -q --disable-pip-version-check --only-binary :all: "${packages[@]}" > build/python-venv.log 2>&1; then
  echo "${packages[*]}" > "$stamp"
  rm -f build/python-venv.log
else
  echo "The packages for the Python tests can't be installed; see build/python-venv.log" >&2
  rm -rf "$folder"
fi
