#!/usr/bin/env bash
# Installs, builds, makes a sample case with the toolkit's own phantom, registers it and names the picture to look at.
#   Utilities/demo.sh
# Into out/sample and out/result. What build/demo or a compiler cache has is not compiled again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
case "${1:-}" in
  "") ;;
  *) sed -n '2,4s/^# \?//p' "Utilities/${0##*/}"; [ "$1" = --help ] && exit 0; exit 2 ;;
esac

Utilities/install-dependencies.sh build
cmake --preset demo >/dev/null
cmake --build --preset demo

rm -rf out/sample out/result
mkdir -p out
build/demo/bin/dentalscr phantom --level typical --seed 7 --output out/sample
build/demo/bin/dentalscr register out/sample/case.json --output out/result
echo
echo "Look at $PWD/out/result/report.html, or at overlay_upper.png and overlay_lower.png beside it;"
echo "the numbers are in $PWD/out/result/result.json."
