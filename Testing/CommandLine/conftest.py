"""What the tests of many registrations share."""
import os
import subprocess

import pytest

from program_runs import ProgramRuns


@pytest.fixture(scope="session")
def runs(program, shared_folder, tmp_path_factory):
    made = ProgramRuns(program, tmp_path_factory.mktemp("runs"), shared_folder)
    yield made
    made.close()


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
