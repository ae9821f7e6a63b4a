"""What the black-box tests share: the built program and a sample case that the toolkit makes itself."""
import json
import pathlib
import shutil
import signal
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parent.parent


def pytest_addoption(parser):
    parser.addoption("--build-dir", default=str(ROOT / "build" / "test"), help="build tree with bin/dentalscr")
    parser.addoption("--at-length", action="store_true", help="run what takes minutes, too: Utilities/test-cohort.sh")
    parser.addoption("--kills", type=int, default=5, help="how often test_interrup*.py kill each verb: Utilities/faults.sh")
    parser.addoption("--full-disks", type=int, default=4, help="how often each has no space")
    parser.addoption("--refreeze", action="store_true", help="freeze the results anew instead of comparing with them")


def pytest_configure(config):
    # A shell that starts something in the background has it ignore SIGINT, and so would every program that is tested for it.
    if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_collection_modifyitems(config, items):
    """In several processes (-n 2 --dist loadgroup) a file stays in one, with what it has made for all of its tests. The files
    whose tests share registrations are one group as well, and the first, since they take longest."""
    if not hasattr(config, "workerinput"):
        return
    shared = [item for item in items if item.path.name in ("test_frozen_results.py", "test_accuracy_gate.py")]
    first = set(shared)
    items[:] = shared + [item for item in items if item not in first]
    for item in items:
        item.add_marker(pytest.mark.xdist_group("runs" if item in first else str(item.path.relative_to(ROOT))))


@pytest.fixture(scope="session")
def build_dir(request):
    return pathlib.Path(request.config.getoption("--build-dir")).resolve()


@pytest.fixture(scope="session")
def program(build_dir):
    path = build_dir / "bin" / "dentalscr"
    assert path.exists(), f"{path} is not built"
    return path


@pytest.fixture(scope="session")
def run(program):
    """Runs the program; returns the completed process with text output."""

    def call(*arguments, **keywords):
        return subprocess.run(
            [str(program), *map(str, arguments)], capture_output=True, text=True, timeout=300, **keywords
        )

    return call


@pytest.fixture(scope="session")
def sample(run, tmp_path_factory):
    """A phantom case; read it, don't write to it."""
    folder = tmp_path_factory.mktemp("sample") / "case"
    done = run("phantom", "--level", "typical", "--seed", 11, "--output", folder)
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture
def case(sample, tmp_path):
    """A copy of the sample that a test may spoil."""
    folder = tmp_path / "case"
    shutil.copytree(sample, folder)
    return CaseFolder(folder)


@pytest.fixture(scope="session")
def shared_folder():
    """Where the shared sample cases are, if they are there."""
    return ROOT.parent / "shared" / "cases"


@pytest.fixture(scope="session")
def shared_cases(shared_folder):
    if not shared_folder.is_dir():
        pytest.skip("the shared sample cases are not here")
    return shared_folder


@pytest.fixture(scope="session")
def standard_sample(run, tmp_path_factory):
    """A phantom with the standard tracing and the four landmarks of every analysis; read it, don't write to it."""
    folder = tmp_path_factory.mktemp("standard") / "case"
    done = run("phantom", "--level", "standard", "--seed", 9105, "--output", folder)
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture
def standard_case(standard_sample, tmp_path):
    """A copy of it that a test may spoil, with its landmarks alone."""
    folder = tmp_path / "standard"
    shutil.copytree(standard_sample, folder)
    case = CaseFolder(folder)
    content = case.load("case-landmarks.json")
    case.save(content)
    return case


class CaseFolder:
    """A case on disk with its JSON files at hand."""

    def __init__(self, folder):
        self.folder = folder
        self.file = folder / "case.json"

    def load(self, name="case.json"):
        return json.loads((self.folder / name).read_text())

    def save(self, content, name="case.json"):
        (self.folder / name).write_text(json.dumps(content))

    def change(self, name="case.json", **members):
        content = self.load(name)
        content.update(members)
        self.save(content, name)
