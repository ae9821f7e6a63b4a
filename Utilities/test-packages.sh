#!/usr/bin/env bash
# Installs and uses what Utilities/wheel.sh and Utilities/package.sh have made in a fresh Debian root, in which there is nothing but
# the base system (and Python, for the wheel): what a user's machine must have, the packages must bring or name.
#   Utilities/test-packages.sh [wheel] [deb] [dev]
# wheel: installs it with numpy 1 and 2, beside SimpleITK, itk and vtk, and runs all examples and the package's tests.
# deb: installs dentalscr and dentalscr-view by apt, makes a case, registers it, completes, reads the manual page.
# dev: installs libdentalscr-dev with a compiler, and builds Examples/InstalledPackage against it.
# As root, with debootstrap; some minutes each, most of which is fetching. The roots stay in build/roots until the next run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(wheel deb dev)
for part in "${parts[@]}"; do
  case "$part" in
    wheel | deb | dev) ;;
    *) sed -n '2,9s/^# \?//p' "Utilities/${0##*/}"; [ "$part" = --help ] && exit 0; exit 2 ;;
  esac
done
[ "$(id -u)" -eq 0 ] || { echo "test-packages.sh: a root of its own can be entered by root alone" >&2; exit 2; }
command -v debootstrap >/dev/null || { echo "test-packages.sh: apt-get install debootstrap" >&2; exit 2; }

mkdir -p build/roots
base=build/roots/base.tar
if [ ! -f $base ]; then
  rm -rf build/roots/base
  debootstrap --variant=minbase --include=python3,python3-venv bookworm build/roots/base > build/roots/debootstrap.log
  # It gets packages from where this machine gets them.
  rm -rf build/roots/base/etc/apt/sources.list
  for part in sources.list sources.list.d apt.conf.d keyrings trusted.gpg.d; do
    [ ! -e /etc/apt/$part ] || cp -a /etc/apt/$part build/roots/base/etc/apt/
  done
  cp /etc/resolv.conf /etc/hosts build/roots/base/etc/
  mkdir -p build/roots/base/etc/ssl build/roots/base/usr/share/keyrings
  cp -a /etc/ssl/certs build/roots/base/etc/ssl/
  cp -a /usr/share/keyrings/. build/roots/base/usr/share/keyrings/
  cp -aL /usr/share/ca-certificates build/roots/base/usr/share/ 2>/dev/null || true
  tar -cf $base.part -C build/roots/base .
  mv $base.part $base
  rm -rf build/roots/base
fi

# fresh NAME: a root like new.
fresh() {
  root=build/roots/$1
  ! mountpoint -q "$root/proc" || umount "$root/proc"
  rm -rf "$root"
  mkdir -p "$root"
  tar -xf $base -C "$root"
  mount -t proc proc "$root/proc"
  trap 'umount "$PWD/$root/proc" 2>/dev/null || true' EXIT
}
inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
leave() { umount "$root/proc"; }
# refuse WHAT PATH...: ends where one of these paths is there. (A command behind "!" never ends a script of "set -e".)
refuse() {
  local what=$1 path
  shift
  for path in "$@"; do
    [ ! -e "$path" ] || { echo "test-packages.sh: $what: $path" >&2; exit 1; }
  done
}

test_wheel() {
  local tag wheel
  fresh wheel
  tag=$(inside python3 -c 'import sys; print("cp%d%d" % sys.version_info[:2])')
  wheel=$(ls -t build/wheels/dentalscr-*-"$tag"-*manylinux*.whl 2>/dev/null | head -1)
  [ -n "$wheel" ] || { echo "test-packages.sh: no wheel for $tag in build/wheels: Utilities/wheel.sh" >&2; exit 2; }
  # pip needs an index, the root has none: fetched here for its Python.
  mkdir -p build/roots/index
  local get=(/usr/bin/python3 -m pip download -q --disable-pip-version-check --only-binary :all: -d build/roots/index)
  "${get[@]}" "numpy<2" && "${get[@]}" "numpy>=2" SimpleITK itk vtk pytest pillow
  mkdir -p "$root/trial/index"
  cp build/roots/index/*.whl "$wheel" "$root/trial/index/"
  cp -r Examples Wrapping Documentation Modules README.md CMakeLists.txt "$root/trial/"
  mkdir "$root/trial/Testing" && cp -r Testing/conftest.py Testing/Examples "$root/trial/Testing/"
  # What the page of the wheel says that it needs: the C and C++ libraries alone.
  refuse "the root is not a bare one" "$root"/usr/lib/*/libITK* "$root"/usr/lib/libITK* "$root"/usr/lib/*/libcairo* \
    "$root"/usr/lib/*/libX11* "$root"/usr/share/fonts/truetype/*
  local begin=$SECONDS numpy
  for numpy in "numpy<2" "numpy>=2"; do
    inside rm -rf /trial/venv
    inside python3 -m venv /trial/venv
    inside /trial/venv/bin/pip install -q --no-index --find-links /trial/index dentalscr "$numpy"
    inside /trial/venv/bin/python -c 'import time; begin = time.process_time(); import dentalscr, numpy
print("imported with numpy", numpy.__version__, "in %.2f s of CPU" % (time.process_time() - begin))'
    inside /trial/venv/bin/dentalscr phantom --level typical --seed 7 --output /trial/case --quiet
    inside /trial/venv/bin/dentalscr register /trial/case/case.json --output /trial/result
    test -s "$root/trial/result/report.html"
    inside rm -rf /trial/result /trial/case
  done
  inside /trial/venv/bin/pip install -q --no-index --find-links /trial/index "dentalscr[scene]" SimpleITK itk vtk pytest
  # Every order of import: each has an ITK or a VTK of its own.
  for order in "dentalscr, SimpleITK, itk, vtk" "vtk, itk, SimpleITK, dentalscr"; do
    inside /trial/venv/bin/python -c "import $order
import numpy
a = dentalscr.from_sitk(SimpleITK.GetImageFromArray(numpy.ones((4, 5), numpy.float32)))
b = dentalscr.from_itk(itk.image_from_array(numpy.ones((4, 5), numpy.float32)))
assert a.array.shape == b.array.shape == (4, 5)"
  done
  inside sh -c 'cd /trial && venv/bin/python -m pytest -q -p no:cacheprovider --installed Wrapping/Python/tests \
    --ignore Wrapping/Python/tests/test_wheel.py --ignore Wrapping/Python/tests/test_tutorials.py \
    --ignore Wrapping/Python/tests/test_package.py'
  # The examples' own test, which finds the installed program where it would find that of a build tree.
  inside sh -c 'mkdir -p /trial/build/bin && ln -s /trial/venv/bin/dentalscr /trial/build/bin/ && cd /trial &&
    venv/bin/python -m pytest -q -p no:cacheprovider Testing/Examples/test_examples.py -k python_twin --build-dir build'
  echo "wheel: $((SECONDS - begin)) s"
  leave
}

test_deb() {
  fresh deb
  mkdir "$root/packages" && cp build/packages/dentalscr*.deb "$root/packages/"
  local begin=$SECONDS
  inside apt-get update -qq
  inside sh -c 'apt-get install -y -qq --no-install-recommends /packages/*.deb > /packages/log 2>&1 || { tail /packages/log; exit 1; }'
  echo "deb: installed in $((SECONDS - begin)) s, $(inside sh -c 'dpkg-query -W -f="\${Package}\n" | wc -l') packages in the root"
  inside dentalscr --version
  inside dentalscr phantom --level typical --seed 7 --output /trial/case --quiet
  inside dentalscr register /trial/case/case.json --output /trial/result
  inside dentalscr-view --help | grep -q -- --snapshot
  test -s "$root/trial/result/report.html" && test -s "$root/usr/share/man/man1/dentalscr-register.1.gz"
  inside bash -c 'source /usr/share/bash-completion/completions/dentalscr && complete -p dentalscr'
  # The modules for 3D Slicer find the program that they are installed with; python-real is Slicer's.
  inside apt-get install -y -qq --no-install-recommends python3-numpy >/dev/null 2>&1
  inside python3 /usr/share/dentalscr/slicer/DentalSCRRegister.py --case /trial/case/case.json --output /trial/slicer \
    --returnparameterfile /trial/returned >/dev/null
  grep -q '^status = ' "$root/trial/returned"
  # Nothing is left of it.
  inside apt-get purge -y -qq dentalscr dentalscr-view >/dev/null 2>&1
  refuse "left after a purge" "$root"/usr/lib/*/libDentalSCR* "$root"/usr/bin/dentalscr* "$root"/usr/share/doc/dentalscr* \
    "$root"/usr/share/dentalscr "$root"/usr/share/man/man1/dentalscr*
  echo "deb: $((SECONDS - begin)) s"
  leave
}

test_dev() {
  fresh dev
  mkdir "$root/packages" && cp build/packages/*.deb "$root/packages/"
  local begin=$SECONDS
  inside apt-get update -qq
  inside sh -c 'apt-get install -y -qq --no-install-recommends /packages/dentalscr_*.deb /packages/libdentalscr-dev_*.deb \
    g++ cmake ninja-build > /packages/log 2>&1 || { tail /packages/log; exit 1; }'
  echo "dev: installed in $((SECONDS - begin)) s"
  inside sh -c 'cmake -S /usr/share/doc/dentalscr/examples/InstalledPackage -B /trial -G Ninja -DCMAKE_BUILD_TYPE=Release > /packages/log &&
    cmake --build /trial >> /packages/log || { tail -n 40 /packages/log; exit 1; }'
  inside /trial/InstalledPackage | tee "$root/trial/said"
  grep -q shift "$root/trial/said"
  echo "dev: $((SECONDS - begin)) s"
  leave
}

for part in "${parts[@]}"; do
  test_"$part"
done
