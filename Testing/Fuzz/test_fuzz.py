"""Every input that once failed is read or refused, every seed too, and so are some mutants of each reader; more of them by
Utilities/fuzz.sh."""
import pathlib
import subprocess
import sys

import pytest

from make_seeds import TARGETS

HERE = pathlib.Path(__file__).resolve().parent


@pytest.fixture(scope="session")
def inputs(program, tmp_path_factory):
    folder = tmp_path_factory.mktemp("fuzz")
    done = subprocess.run(
        [sys.executable, str(HERE / "make_seeds.py"), str(folder), "--program", str(program)], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture
def fuzz(build_dir, target, tmp_path):
    program = build_dir / "bin" / "dentalscr-fuzz"
    assert program.exists(), f"{program} is not built"

    def call(*arguments):
        done = subprocess.run([str(program), target, *map(str, arguments)], capture_output=True, text=True, errors="replace", timeout=300)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    return call


@pytest.mark.parametrize("target", TARGETS)
def test_what_once_failed_is_read_or_refused(inputs, fuzz, target):
    files = [*(inputs / "corpus" / target).iterdir(), *(inputs / "seeds" / target).iterdir()]
    assert " 0 failed" in fuzz("--replay", *files)


@pytest.mark.parametrize("target", TARGETS)
def test_seeds_are_what_their_reader_reads(inputs, fuzz, target):
    """Mutants of what is refused would never come far."""
    files = list((inputs / "seeds" / target).iterdir())
    told = fuzz("--replay", *files)
    read = int(told.split(": ")[-1].split(" read")[0])
    # Some radiographs are no label maps, nor masks of one tooth.
    least = 1 if target in ("labelmap", "mask", "toothlabels") else (len(files) + 1) // 2
    assert read >= least, told


@pytest.mark.parametrize("target", ["transform"])
def test_transforms_of_a_result_are_read(inputs, fuzz, target):
    files = list((inputs / "case" / "result").glob("*.tfm"))
    assert len(files) == 4 and "4 read, 0 refused" in fuzz("--replay", *files)


@pytest.mark.parametrize("target", TARGETS)
def test_some_mutants_are_read_or_refused(inputs, fuzz, target, tmp_path):
    # As many on each machine, however busy it is.
    told = fuzz("--mutants", 60, "--seed", 1, "--findings", tmp_path, *sorted((inputs / "seeds" / target).iterdir()))
    assert f"{target}: 60 mutants" in told and " 0 failed" in told, told
