"""What the tests of many registrations and those of faults share."""
import os
import pathlib
import shlex
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
def program_of_slicer(program, is_sanitized, tmp_path_factory):
    """The program as the modules of Slicer run it: without LD_LIBRARY_PATH, which is of Slicer's libraries."""
    if not is_sanitized:
        return program
    # A sanitizer's dlopen() looks there alone for the libraries that the program loads when it needs them.
    wrapper = tmp_path_factory.mktemp("slicer") / "dentalscr"
    path = shlex.quote(os.environ["LD_LIBRARY_PATH"])
    wrapper.write_text(f'#!/bin/sh\nLD_LIBRARY_PATH={path} exec {shlex.quote(str(program))} "$@"\n')
    wrapper.chmod(0o755)
    return wrapper


@pytest.fixture(scope="session")
def faults(is_sanitized, tmp_path_factory):
    """The environment of a program that meets a fault (Support/dentalscrFaults.c says which there are)."""
    compiler = shutil.which("cc") or shutil.which("gcc")
    assert compiler, "no C compiler, which has built the program"
    source = pathlib.Path(__file__).resolve().parent.parent / "Support" / "dentalscrFaults.c"
    library = tmp_path_factory.mktemp("faults") / "faults.so"
    subprocess.run([compiler, "-O2", "-shared", "-fPIC", "-o", str(library), str(source), "-ldl"], check=True)
    preload = [str(library)]
    if is_sanitized:
        # A sanitizer wants to be the first; what it calls then is what the faults stand before.
        sanitizer = subprocess.run([compiler, "-print-file-name=libasan.so"], check=True, capture_output=True, text=True)
        preload.insert(0, sanitizer.stdout.strip())

    def environment(**variables):
        return dict(os.environ, LD_PRELOAD=":".join(preload), **{f"DENTALSCR_{key}": str(value) for key, value in variables.items()})

    return environment


@pytest.fixture
def small_disk(tmp_path):
    """A file system of as many KiB as are asked for; only root may mount one."""
    if os.geteuid() != 0:
        pytest.skip("a small file system can be mounted by root only")
    mounted = []

    def mount(size):
        folder = tmp_path / f"disk{len(mounted)}"
        folder.mkdir()
        done = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}k", "none", str(folder)], capture_output=True)
        if done.returncode != 0:
            pytest.skip("this system lets nobody mount a small file system: " + done.stderr.decode().strip())
        mounted.append(folder)
        return folder

    yield mount
    for folder in mounted:
        subprocess.run(["umount", str(folder)], check=True)
