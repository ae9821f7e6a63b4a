#!/usr/bin/env bash
# Builds DentalSCR with static libraries in build/static, installs it, and builds and runs Examples/InstalledPackage against it: the
# test of a configuration that the other tests do not have.
#   Utilities/static.sh
# What build/test has compiled is taken from ccache: the commands are the same.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
case "${1:-}" in
  "") ;;
  *) sed -n '2,5s/^# \?//p' "Utilities/${0##*/}"; [ "$1" = --help ] && exit 0; exit 2 ;;
esac
export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1
Utilities/install-dependencies.sh build
cmake --preset static >/dev/null
cmake --build --preset static

prefix=$PWD/build/static/prefix
rm -rf "$prefix" build/static/consumer
cmake --install build/static --prefix "$prefix" >/dev/null
shared=$(find "$prefix" -name 'libDentalSCR*.so*')
[ -z "$shared" ] || { echo "static.sh: shared libraries were installed: $shared" >&2; exit 1; }
cmake -S Examples/InstalledPackage -B build/static/consumer -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
cmake --build build/static/consumer
build/static/consumer/InstalledPackage | grep shift
# A command behind "!" never ends a script of "set -e".
if ldd build/static/consumer/InstalledPackage "$prefix/bin/dentalscr" | grep libDentalSCR; then
  echo "static.sh: a shared library of ours is loaded" >&2
  exit 1
fi
"$prefix/bin/dentalscr" phantom --level typical --seed 7 --output build/static/case --quiet
"$prefix/bin/dentalscr" register build/static/case/case.json --output build/static/result
rm -rf build/static/case build/static/result
ls -l "$prefix/bin/dentalscr" build/static/consumer/InstalledPackage | awk '{ printf "%s: %.1f MB\n", $NF, $5 / 1e6 }'
