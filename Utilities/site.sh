#!/usr/bin/env bash
# Builds the site of the project in build/site from the pages, the program and the Python package of the build tree.
# A warning is an error, every link within the site is followed, and nothing in it is asked of the network: open
# build/site/index.html from the disk.
#   Utilities/site.sh [--build-dir build/test]
# Ends with 5 where no package index is reachable for what is listed in Documentation/requirements.txt.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/test
case "${1:-}" in
  --build-dir) build="$2" ;;
  "") ;;
  *) sed -n '2,6s/^# \?//p' "Utilities/${0##*/}"; [ "$1" = --help ] && exit 0; exit 2 ;;
esac
for file in "$build/bin/dentalscr" "$build/python/dentalscr/__init__.py"; do
  [ -e "$file" ] || { echo "$file is missing: cmake --preset test && cmake --build --preset test" >&2; exit 2; }
done

# First, because it needs no package: its warnings are found where Sphinx can't be installed, too.
Utilities/doxygen.sh

venv=build/site-venv
if ! cmp -s Documentation/requirements.txt "$venv/requirements.txt"; then
  rm -rf "$venv"
  # Debian's Python: the package of the build tree is compiled for it.
  /usr/bin/python3 -m venv "$venv"
  if ! "$venv/bin/python" -m pip install -q --disable-pip-version-check --only-binary :all: \
    -r Documentation/requirements.txt > build/site-venv.log 2>&1; then
    echo "The site is not built, because Sphinx can't be installed; see build/site-venv.log" >&2
    exit 5
  fi
  cp Documentation/requirements.txt "$venv/requirements.txt"
fi

pages=build/site-pages
rm -rf build/site
export PYTHONPATH="$PWD/$build/python" PYTHONDONTWRITEBYTECODE=1
"$venv/bin/python" Utilities/site_pages.py "$pages" --program "$build/bin/dentalscr"
"$venv/bin/python" -m sphinx -W --keep-going -q -j 2 -c Documentation -d build/site-doctrees "$pages" build/site
cp -r build/doxygen/html build/site/cpp
"$venv/bin/python" Utilities/check_site.py build/site
echo "build/site/index.html"
