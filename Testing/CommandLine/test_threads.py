"""More threads than the system gives: fewer are used, it is said once, and the result is the same."""
import os
import pathlib
import shutil
import subprocess

import pytest

from result_files import poses_of


@pytest.fixture
def limited(program):
    """Runs the program where a user may have few processes. Root has no such limit, and goes to another user."""

    def call(limit, *arguments, folder):
        words = ["bash", "-c", f'ulimit -u {limit} && exec "$@"', "bash", str(program), *map(str, arguments)]
        if os.geteuid() == 0:
            if shutil.which("setpriv") is None:
                pytest.skip("root has no limit of processes, and there is no setpriv to be another user")
            # A number that no other user of this machine has, so that its processes are those of this test.
            os.chown(folder, 54321, 54321)
            words = ["setpriv", "--reuid", "54321", "--regid", "54321", "--clear-groups", *words]
        return subprocess.run(words, capture_output=True, text=True, timeout=120)

    return call


VERBS = {
    "register": ("register", "{case}", "--no-report"),
    "axis": ("axis", "--case", "{case}"),
    "render": ("render", "--case", "{case}"),
    "experiment": ("experiment", "--cases", "1", "--no-figures"),
}


@pytest.mark.parametrize("verb", VERBS)
@pytest.mark.parametrize("limit", [1, 4, 20])
def test_fewer_threads_than_were_asked_for(program, limited, sample, verb, limit):
    # Not tmp_path, whose parents other users may not enter.
    folder = pathlib.Path(os.path.realpath("/tmp")) / f"dentalscr-threads-{os.getpid()}-{verb}-{limit}"
    folder.mkdir(mode=0o755)
    try:
        shutil.copytree(sample, folder / "case")
        subprocess.run(["chmod", "-R", "a+rX", str(folder)], check=True)
        arguments = [word.format(case=folder / "case" / "case.json") for word in VERBS[verb]]
        output = folder / ("out.mha" if verb == "render" else "out")
        done = limited(limit, "--threads", 1024, *arguments, "--output", output, "--quiet", folder=folder)
        if "Permission denied" in done.stderr and not done.stdout:
            pytest.skip("another user can't run the program where it was built")
        assert done.returncode == 0, done.stderr
        assert done.stderr.count("DentalSCR: the system gave") == 1, done.stderr
        assert output.exists()
        if verb == "register" and limit < 20:
            free = subprocess.run(
                [str(program), *arguments, "--output", str(folder / "free"), "--quiet"]
            )
            assert free.returncode == 0

            assert poses_of(folder / "out") == poses_of(folder / "free")
    finally:
        shutil.rmtree(folder)
