"""`pip install .` into a clean environment: what is in the wheel, and that it works away from the source tree."""
import os
import pathlib
import subprocess
import sys
import zipfile

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]


def call(*arguments, **keywords):
    environment = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "LD_LIBRARY_PATH")}
    environment.update(keywords.pop("env", {}))
    done = subprocess.run(
        [str(a) for a in arguments], capture_output=True, text=True, timeout=3000, env=environment, **keywords
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
    return done.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    pytest.importorskip("scikit_build_core")
    folder = tmp_path_factory.mktemp("wheel")
    # The compiler's name as CMake has it by default, so that objects of the other build are found in ccache.
    call(
        sys.executable, "-m", "pip", "wheel", ROOT, "--no-build-isolation", "--no-deps", "-w", folder,
        env={"CC": "/usr/bin/cc", "CXX": "/usr/bin/c++", "CCACHE_BASEDIR": str(ROOT), "CCACHE_NOHASHDIR": "1"},
    )
    (file,) = folder.glob("*.whl")
    return file


@pytest.fixture(scope="module")
def python(wheel, tmp_path_factory):
    """A new environment with the wheel and numpy alone."""
    folder = tmp_path_factory.mktemp("clean") / "venv"
    call(sys.executable, "-m", "venv", folder)
    call(folder / "bin" / "python", "-m", "pip", "install", "-q", "--disable-pip-version-check", wheel)
    return folder / "bin" / "python"


def test_wheel_holds_one_compiled_file_its_stub_and_the_version(wheel, ds):
    names = zipfile.ZipFile(wheel).namelist()
    assert wheel.name.startswith(f"dentalscr-{ds.__version__}-cp3")
    assert sum(name.endswith(".so") for name in names) == 1
    assert {"dentalscr/py.typed", "dentalscr/_core.pyi", "dentalscr/__init__.py"} <= set(names)
    # All of DentalSCR stripped of what only linkers need; ITK stays with the system.
    assert wheel.stat().st_size < 8 << 20


def test_compiled_file_names_no_library_of_ours_and_no_path(wheel, tmp_path):
    zipfile.ZipFile(wheel).extractall(tmp_path)
    (module,) = (tmp_path / "dentalscr").glob("_core*.so")
    dynamic = call("readelf", "-d", module)
    assert "libDentalSCR" not in dynamic and "libITKCommon" in dynamic and str(ROOT) not in dynamic
    exported = [line for line in call("nm", "-D", "--defined-only", module).splitlines() if " T " in line]
    assert [line.split()[-1] for line in exported] == ["PyInit__core"]


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
