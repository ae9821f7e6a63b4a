"""The wheel of Utilities/wheel.sh: what is in it, and that it works where there is nothing but Python."""
import ast
import os
import pathlib
import re
import shutil
import stat
import subprocess
import sys
import sysconfig
import zipfile

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
# What Utilities/repair_wheel.py leaves to the system, and the loader itself.
SYSTEM = ast.literal_eval(
    re.search(r"^SYSTEM = (\{.*?^\})", (ROOT / "Utilities/repair_wheel.py").read_text(), re.M | re.S).group(1)
)


def call(*arguments, **keywords):
    environment = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "LD_LIBRARY_PATH")}
    environment.update(keywords.pop("env", {}))
    done = subprocess.run(
        [str(a) for a in arguments], capture_output=True, text=True, timeout=3000, env=environment, **keywords
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
    return done.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory, pytestconfig):
    """Made from an sdist, for the Python that runs this."""
    if not pytestconfig.getoption("--at-length"):
        pytest.skip("to make a wheel takes minutes: --at-length")
    for name in ("auditwheel", "scikit_build_core"):
        pytest.importorskip(name)
    folder = tmp_path_factory.mktemp("wheel")
    call(ROOT / "Utilities/wheel.sh", "--output", folder, sys.executable)
    (file,) = folder.glob("*.whl")
    return file


@pytest.fixture(scope="module")
def python(wheel, tmp_path_factory):
    """A new environment with the wheel and numpy alone."""
    folder = tmp_path_factory.mktemp("clean") / "venv"
    call(sys.executable, "-m", "venv", folder)
    call(folder / "bin" / "python", "-m", "pip", "install", "-q", "--disable-pip-version-check", wheel)
    return folder / "bin" / "python"


@pytest.fixture(scope="module")
def site(python):
    return pathlib.Path(call(python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))").strip())


def compiled_files(folder):
    return [path for path in folder.rglob("*") if path.is_file() and path.read_bytes()[:4] == b"\x7fELF"]


def loaded_by(path):
    """Where the loader finds each library, by its name."""
    return dict(re.findall(r"^\t(\S+) => (\S+)", call("ldd", path), re.M))


def test_wheel_says_for_which_systems_it_is(wheel, ds):
    tag = sysconfig.get_config_var("py_version_nodot")
    found = re.fullmatch(rf"dentalscr-{ds.__version__}-cp{tag}-cp{tag}-manylinux_2_(\d+)_x86_64\.whl", wheel.name)
    assert found, wheel.name
    # No promise of an older C library than that of this machine could have been tried.
    needed = {
        int(minor)
        for path in compiled_files_of_wheel(wheel)
        for minor in re.findall(r"GLIBC_2\.(\d+)", call("objdump", "-T", path))
    }
    assert max(needed) <= int(found.group(1)) <= int(os.confstr("CS_GNU_LIBC_VERSION").split(".")[1])


def compiled_files_of_wheel(wheel):
    folder = wheel.parent / "unpacked"
    if not folder.exists():
        zipfile.ZipFile(wheel).extractall(folder)
    return compiled_files(folder)


def test_wheel_holds_the_package_its_libraries_and_their_licences(wheel):
    names = zipfile.ZipFile(wheel).namelist()
    assert sum(name.startswith("dentalscr/") and name.endswith(".so") for name in names) == 1
    assert {"dentalscr/py.typed", "dentalscr/_core.pyi", "dentalscr/__init__.py", "dentalscr/dentalscr-decode"} <= set(names)
    libraries = [name.split("/")[1] for name in names if name.startswith("dentalscr.libs/") and not name.endswith("/")]
    for part in ("ITKCommon", "OpenMeshCore", "cairo", "gdcmMSFF", "X11", "expat", "nettle", "csv"):
        assert any(name.startswith(f"lib{part}") for name in libraries), part
    assert not any("vtk" in name.lower() or "DentalSCR" in name for name in libraries)
    (contents,) = (name for name in names if name.endswith("/licenses/CONTENTS.txt"))
    rows = dict(re.findall(r"^(\S+\.so\S*): (\S+)$", zipfile.ZipFile(wheel).read(contents).decode(), re.M))
    assert sorted(rows) == sorted(libraries)
    for licence in [*rows.values(), "libeigen3-dev.txt", "fonts-dejavu-core.txt", "pybind11.txt"]:
        assert contents.replace("CONTENTS.txt", licence) in names, licence
    assert wheel.stat().st_size < 30 << 20


def test_compiled_module_shows_nothing_of_ours_and_no_path(wheel):
    (module,) = (path for path in compiled_files_of_wheel(wheel) if path.name.startswith("_core"))
    dynamic = call("readelf", "-d", module)
    assert "libDentalSCR" not in dynamic and "libITKCommon" in dynamic and str(ROOT) not in dynamic
    exported = [line for line in call("nm", "-D", "--defined-only", module).splitlines() if " T " in line]
    assert [line.split()[-1] for line in exported] == ["PyInit__core"]


def test_installed_files_load_the_c_library_of_the_system_and_nothing_else_of_it(site):
    files = compiled_files(site / "dentalscr") + compiled_files(site / "dentalscr.libs")
    assert len(files) > 30
    for file in files:
        for name, path in loaded_by(file).items():
            ours = pathlib.Path(path).resolve().parent == (site / "dentalscr.libs").resolve()
            assert name in SYSTEM or ours, (file.name, name, path)


def test_installed_package_registers_away_from_the_sources(python, sample, tmp_path, result):
    code = f"import dentalscr as ds; r = ds.register({str(sample / 'case.json')!r}); print(ds.__file__); print(r.status)"
    out = call(python, "-c", code, cwd=tmp_path).splitlines()
    assert str(ROOT) not in out[0] and out[1] == result.status


def test_installed_program_registers(python, sample, tmp_path):
    program = python.parent / "dentalscr"
    assert call(program, "--version", cwd=tmp_path).startswith("dentalscr ")
    call(program, "register", sample / "case.json", "--output", tmp_path / "out", "--quiet", cwd=tmp_path)
    assert (tmp_path / "out" / "result.json").exists()
    done = subprocess.run([program, "register", "nowhere.json", "--output", tmp_path / "o"], capture_output=True, text=True)
    assert done.returncode == 2 and "nowhere.json" in done.stderr
    assert "complete -F" in call(program, "--completion", "bash")


@pytest.fixture(scope="module")
def empty_root(python, site, tmp_path_factory):
    """A root with an interpreter, its modules and what the loader finds for them: no library of ours, no font, no /etc."""
    if os.geteuid() != 0:
        pytest.skip("only root may enter a root of its own")
    root = tmp_path_factory.mktemp("root")

    def copy(path):
        target = root / str(path).lstrip("/")
        if not target.exists():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, target)

    interpreter = pathlib.Path(call(python, "-c", "import sys; print(sys._base_executable)").strip()).resolve()
    modules = pathlib.Path(call(python, "-c", "import sysconfig; print(sysconfig.get_path('stdlib'))").strip())
    shutil.copytree(
        modules, root / str(modules).lstrip("/"), symlinks=True,
        ignore=shutil.ignore_patterns("__pycache__", "test", "site-packages", "dist-packages", "idlelib", "config-*", "*.a"),
    )
    shutil.copytree(site, root / "site", ignore=shutil.ignore_patterns("__pycache__", "pip*", "setuptools*"))
    (root / "tmp").mkdir()
    (root / "proc").mkdir()
    (root / "dev").mkdir()
    os.mknod(root / "dev" / "null", 0o666 | stat.S_IFCHR, os.makedev(1, 3))
    copy(interpreter)
    wanted = [interpreter, *compiled_files(root / str(modules).lstrip("/"))]
    for file in [*wanted, *compiled_files(root / "site" / "numpy"), site / "dentalscr" / "dentalscr-decode"]:
        for name, path in re.findall(r"^\t(\S+)(?: => (\S+))? \(", call("ldd", file), re.M):
            # The interpreter's own, and those that every system has.
            if name.startswith("/") or (path.startswith("/") and (name in SYSTEM or file in wanted)):
                copy(path or name)
    return root, interpreter


def test_wheel_registers_where_there_is_nothing_but_python(empty_root, sample, tmp_path, result):
    root, interpreter = empty_root
    assert not [path for path in root.glob("usr/**/*") if re.match(r"lib(ITK|cairo|X11|gdcm|OpenMesh|fontconfig)", path.name)]
    shutil.copytree(sample, root / "case", dirs_exist_ok=True)
    # With /proc, as every system has it, mounted for these processes alone.
    enter = ["unshare", "--mount", "sh", "-c", 'mount -t proc proc "$0/proc" && exec chroot "$0" "$@"', root, interpreter]
    inside = {"env": {"PYTHONPATH": "/site", "HOME": "/tmp"}}
    # NRRD is decoded by the program beside the module.
    call(*enter, "-m", "dentalscr", "render", "--case", "/case/case.json", "--output", "/tmp/drr.nrrd", **inside)
    code = (
        "import dentalscr as ds; print(ds.register('/case/case.json', output='/tmp/out').status); "
        "print(min(ds.ReadCephalogram('/tmp/drr.nrrd').GetSize()) > 100)"
    )
    assert call(*enter, "-c", code, **inside).splitlines() == [result.status, "True"]
    # The letters of the pictures are the wheel's: there are no fonts here.
    result.Write(tmp_path / "here")
    for name in ("overlay_upper.png", "overlay_lower.png"):
        assert (root / "tmp/out" / name).read_bytes() == (tmp_path / "here" / name).read_bytes()


@pytest.mark.parametrize("order", ["dentalscr SimpleITK itk", "itk SimpleITK dentalscr", "vtk dentalscr", "dentalscr vtk"])
def test_wheel_stands_beside_other_builds_of_itk_and_vtk(site, sample, order, result):
    """In this environment, which has them, with the wheel put before the build tree's package."""
    for name in set(order.split()) - {"dentalscr"}:
        pytest.importorskip(name)
    # The wheel's folder alone: beside it lies another numpy.
    code = f"""
import importlib.util, sys
sys.path = [path for path in sys.path if {str(site)!r} != path]
spec = importlib.util.spec_from_file_location("dentalscr", {str(site / "dentalscr" / "__init__.py")!r})
def load(name):
    if name != "dentalscr":
        return __import__(name)
    module = importlib.util.module_from_spec(spec)
    sys.modules["dentalscr"] = module
    spec.loader.exec_module(module)
    return module
for name in {order.split()!r}:
    load(name)
import dentalscr as ds
print(ds.register({str(sample / "case.json")!r}).status)
"""
    assert call(sys.executable, "-c", code).strip() == result.status
