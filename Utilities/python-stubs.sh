#!/usr/bin/env bash
# Makes the stub of the Python package's compiled part from the build tree, Wrapping/Python/dentalscr/_core.pyi, and of it and the
# package that of the twins' keywords, _settings.pyi; or the first alone, in the file that is named. Needs pybind11-stubgen.
set -euo pipefail
[ "${1:-}" != --help ] || { sed -n '2,3s/^# \?//p' "${BASH_SOURCE[0]}"; exit 0; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."
python="${PYTHON:-build/python-venv/bin/python}"
output="${1:-Wrapping/Python/dentalscr/_core.pyi}"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
PYTHONPATH="${BUILD_DIR:-build/test}/python" "$python" -m pybind11_stubgen dentalscr._core --exit-code \
  --numpy-array-remove-parameters -o "$folder" >&2
"$python" Wrapping/Python/finish_stub.py "$folder/dentalscr/_core.pyi" > "$output"
[ $# -gt 0 ] || "$python" Wrapping/Python/settings_stub.py Wrapping/Python/dentalscr > "$folder/settings.pyi"
[ $# -gt 0 ] || cp "$folder/settings.pyi" Wrapping/Python/dentalscr/_settings.pyi
