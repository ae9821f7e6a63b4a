#!/usr/bin/env bash
# Makes the packages for Debian in build/packages: dentalscr, dentalscr-view (where VTK is found) and libdentalscr-dev.
#   Utilities/package.sh
# Ends with an error where lintian finds one; without lintian it says so. What build/test has compiled is taken from ccache.
# DEBFULLNAME and DEBEMAIL say who makes them. Utilities/test-packages.sh installs and uses them in a fresh root.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
case "${1:-}" in
  "") ;;
  *) sed -n '2,6s/^# \?//p' "Utilities/${0##*/}"; [ "$1" = --help ] && exit 0; exit 2 ;;
esac
for tool in dpkg-shlibdeps dpkg-deb; do
  command -v $tool >/dev/null || { echo "package.sh: $tool is missing: apt-get install dpkg-dev" >&2; exit 2; }
done

export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1
Utilities/install-dependencies.sh build
cmake --preset package >/dev/null
cmake --build --preset package
rm -rf build/packages
cpack --config build/package/CPackConfig.cmake -B build/packages > build/package.log || { cat build/package.log >&2; exit 1; }
rm -rf build/packages/_CPack_Packages
ls -l build/packages/*.deb | awk '{ printf "%s: %.1f MB\n", $NF, $5 / 1e6 }'
if command -v lintian >/dev/null; then
  # Nobody uploads them: they close no report of a wish for them. Without DEBEMAIL nobody signs them, either.
  suppressed=initial-upload-closes-no-bugs
  [ -n "${DEBEMAIL:-}" ] || suppressed+=,bogus-mail-host,bogus-mail-host-in-debian-changelog
  lintian --fail-on error --suppress-tags $suppressed build/packages/*.deb
else
  echo "package.sh: not looked through: apt-get install lintian" >&2
fi
