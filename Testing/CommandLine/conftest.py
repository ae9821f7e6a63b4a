"""What the tests of many registrations and those of faults share."""
import os
import pathlib
import shutil
import subprocess

import pytest

from program_runs import ProgramRuns


@pytest.fixture(scope="session")
def runs(program, shared_folder, tmp_path_factory):
    made = ProgramRuns(program, tmp_path_factory.mktemp("runs"), shared_folder)
    yield made
    made.close()


@pytest.fixture(scope="session")
def is_sanitized(build_dir):
    """Whether the program keeps its books in terabytes of addresses, and its memory several times."""
    return "-fsanitize" in (build_dir / "CMakeCache.txt").read_text()


@pytest.fixture(scope="session")
def faults(is_sanitized, tmp_path_factory):
    """The environment of a program that meets a fault (Support/dentalscrFaults.c says which there are)."""
    if is_sanitized:
        pytest.skip("the sanitizer has to be loaded first, where the faults are")
    compiler = shutil.which("cc") or shutil.which("gcc")
    assert compiler, "no C compiler, which has built the program"
    source = pathlib.Path(__file__).resolve().parent.parent / "Support" / "dentalscrFaults.c"
    library = tmp_path_factory.mktemp("faults") / "faults.so"
    subprocess.run([compiler, "-O2", "-shared", "-fPIC", "-o", str(library), str(source), "-ldl"], check=True)

    def environment(**variables):
        return dict(os.environ, LD_PRELOAD=str(library), **{f"DENTALSCR_{key}": str(value) for key, value in variables.items()})

    return environment
