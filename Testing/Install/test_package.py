"""The packages for Debian, as CPack makes them of the build tree: what they hold and need, and that they work where they are unpacked.

Utilities/package.sh makes those that are given away and has lintian look at them, Utilities/test-packages.sh installs them by apt.
"""
import os
import re
import shutil
import subprocess

import pytest


def call(*arguments, **keywords):
    environment = {k: v for k, v in os.environ.items() if k != "LD_LIBRARY_PATH"}
    environment.update(keywords.pop("env", {}))
    done = subprocess.run(
        [str(a) for a in arguments], capture_output=True, text=True, timeout=600, env=environment, **keywords
    )
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr[-4000:]
    return done.stdout


@pytest.fixture(scope="module")
def packages(build_dir, tmp_path_factory, pytestconfig):
    if not pytestconfig.getoption("--at-length"):
        pytest.skip("packing takes minutes: --at-length, or Utilities/package.sh")
    for tool in ("dpkg-deb", "dpkg-shlibdeps"):
        if shutil.which(tool) is None:
            pytest.skip(f"{tool} is not installed (apt-get install dpkg-dev)")
    folder = tmp_path_factory.mktemp("packages")
    call(
        "cpack", "-G", "DEB", "--config", build_dir / "CPackConfig.cmake", "-D", "CPACK_PACKAGING_INSTALL_PREFIX=/usr",
        # Most of the time would go into packing tightly.
        "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip", "-B", folder,
    )
    return {path.name.split("_")[0]: path for path in folder.glob("*.deb")}


@pytest.fixture(scope="module")
def unpacked(packages, tmp_path_factory):
    prefix = tmp_path_factory.mktemp("unpacked")
    for package in packages.values():
        call("dpkg-deb", "-x", package, prefix)
    return prefix / "usr"


def read_field(package, field):
    return call("dpkg-deb", "-f", package, field).strip()


def test_packages_need_what_they_load_and_no_more(packages, build_dir):
    assert set(packages) == {"dentalscr", "libdentalscr-dev"} | (
        {"dentalscr-view"} if (build_dir / "bin" / "dentalscr-view").exists() else set()
    )
    version = read_field(packages["dentalscr"], "Version")
    depends = read_field(packages["dentalscr"], "Depends")
    for name in ("libinsighttoolkit5.2", "libcairo2", "libopenmesh1", "libcpp-httplib0.11", "libnettle8", "libc6"):
        assert re.search(rf"(^|, ){re.escape(name)}( |,|$)", depends), (name, depends)
    # A compiler's packages, and VTK, are of the others.
    assert "-dev" not in depends and "vtk" not in depends
    depends = read_field(packages["libdentalscr-dev"], "Depends")
    assert f"dentalscr (= {version})" in depends and "libinsighttoolkit5-dev (>= 5.2.1)" in depends
    if "dentalscr-view" in packages:
        depends = read_field(packages["dentalscr-view"], "Depends")
        assert f"dentalscr (= {version})" in depends and "libvtk9.1" in depends
    for package in packages.values():
        words = read_field(package, "Description").splitlines()
        assert len(words[0]) < 80 and all(line.startswith(" ") for line in words[1:]) and len(words) > 1


def test_packages_hold_the_files_of_the_install_tree(unpacked, packages, build_dir, tmp_path):
    def files(folder):
        return {path.relative_to(folder) for path in folder.rglob("*") if not path.is_dir() or path.is_symlink()}

    call("cmake", "--install", build_dir, "--prefix", tmp_path)
    own = {path for path in files(unpacked) if path.name in ("copyright", "changelog.Debian.gz") or "lintian" in path.parts}
    assert len(own) == 2 * len(packages) + 1
    assert files(unpacked) - own == files(tmp_path)
    listed = [line.split()[-1] for package in packages.values() for line in call("dpkg-deb", "-c", package).splitlines()]
    names = [name for name in listed if not name.endswith("/")]
    assert len(names) == len(set(names)), "a file is in two packages"


def test_unpacked_program_registers(unpacked, sample, tmp_path):
    program = unpacked / "bin" / "dentalscr"
    # As the loader does with the system's folders.
    (library,) = unpacked.rglob("libDentalSCRCommandLine.so.*.*.*")
    env = {"LD_LIBRARY_PATH": str(library.parent)}
    call(program, "register", sample / "case.json", "--output", tmp_path / "result", "--quiet", env=env)
    assert (tmp_path / "result" / "report.html").exists()
    assert list((tmp_path / "result").glob("*.tfm"))
    # Nothing in it is found by a path of the build tree.
    assert "not found" not in call("ldd", program, env=env)
    for path in re.findall(r"=> (\S*libDentalSCR\S*)", call("ldd", program, env=env)):
        assert os.path.realpath(path).startswith(os.path.realpath(unpacked)), path
