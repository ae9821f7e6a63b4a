"""What the tests of the package share: the package of the build tree and a sample case that it makes itself."""
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]


def pytest_addoption(parser):
    parser.addoption("--build-dir", default=str(ROOT / "build" / "test"), help="build tree with python/dentalscr")
    parser.addoption("--installed", action="store_true", help="test the package that is installed, not the build tree's")
    parser.addoption("--at-length", action="store_true", help="make and try a wheel, too, which takes minutes")


def pytest_configure(config):
    if not config.getoption("--installed"):
        sys.path.insert(0, str(pathlib.Path(config.getoption("--build-dir")).resolve() / "python"))


@pytest.fixture(scope="session")
def ds():
    import dentalscr

    return dentalscr


@pytest.fixture(scope="session")
def sample(tmp_path_factory):
    """Folder of a phantom case; read it, don't write to it."""
    import subprocess

    folder = tmp_path_factory.mktemp("sample") / "case"
    environment = {"PYTHONPATH": ":".join(path for path in sys.path if path)}
    done = subprocess.run(
        [sys.executable, "-m", "dentalscr", "phantom", "--level", "typical", "--seed", "11", "--output", str(folder)],
        capture_output=True,
        text=True,
        timeout=300,
        env={**__import__("os").environ, **environment},
    )
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture(scope="session")
def case(ds, sample):
    return ds.ReadCase(sample / "case.json")


@pytest.fixture(scope="session")
def result(ds, sample):
    return ds.register(sample / "case.json")
