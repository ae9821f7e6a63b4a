"""A batch that is killed or asked to end at random moments, or meets the end of its disk at random places, and is started
again: nothing is lost, nothing half written, nothing done twice. A few of each here; before a release Utilities/faults.sh.
"""
import json
import os
import random
import resource
import signal
import subprocess
import time

import pytest

from program_faults import ASKING, processes_of, start_as_a_user_does, wait_until
from result_files import poses_of, rows_of

FAST = ("--no-report", "--no-page", "--preset", "bounding-box", "--jobs", "2")
CASES = 8


@pytest.fixture(scope="module")
def table(run, tmp_path_factory):
    folder = tmp_path_factory.mktemp("cohort")
    done = run("phantom", "--seed", 11, "--triangles", 3000, "--no-radiograph", "--output", folder / "p")
    assert done.returncode == 0, done.stderr
    table = folder / "cases.csv"
    table.write_text("id,case\n" + "".join(f"c{k},p/case.json\n" for k in range(CASES)))
    return table


class Whole:
    """What a batch that nothing disturbs leaves, and how long it takes."""

    def __init__(self, run, table, output):
        start = time.monotonic()
        done = run("batch", table, "--output", output, *FAST)
        self.seconds = time.monotonic() - start
        assert done.returncode == 0, done.stderr
        self.rows = rows_of(output, "seconds")
        self.files = {path.name for path in (output / "c0").iterdir()}
        self.poses = poses_of(output / "c0")
        # Where one byte less is too little: for the longest file, and for all of them on a disk.
        self.longest = max(path.stat().st_size for path in (output / "c0").iterdir())
        self.kibibytes = sum(-(-path.stat().st_size // 4096) * 4 for path in output.rglob("*") if path.is_file())


@pytest.fixture(scope="module")
def whole(run, table, tmp_path_factory):
    return Whole(run, table, tmp_path_factory.mktemp("whole") / "out")


def check(output, whole):
    """Whatever is there is whole. \\return the moment at which each recorded case was written"""
    done = {}
    for record in output.glob(".batch/c*.json"):
        json.loads(record.read_text())
    for folder in output.glob("c*"):
        found = {path.name for path in folder.iterdir() if not path.name.startswith(".dentalscr-")}
        if "result.json" not in found:
            continue
        assert found == whole.files, (folder, sorted(found))
        assert poses_of(folder) == whole.poses
        if (output / ".batch" / (folder.name + ".json")).exists():
            done[folder.name] = (folder / "result.json").stat().st_mtime_ns
    for summary in output.glob("summary.json"):
        json.loads(summary.read_text())
    return done


def check_end(output, whole, done, before):
    assert done.returncode == 0, done.stderr
    after = check(output, whole)
    assert len(after) == CASES and rows_of(output, "seconds") == whole.rows
    assert {name: after[name] for name in before} == before, "what was recorded is done once"
    # Of every process that was killed everything is swept up by the one that did its case.
    assert not list(output.rglob(".dentalscr-*")), list(output.rglob(".dentalscr-*"))


def test_ended_at_random_moments(request, program, run, table, whole, tmp_path):
    kills = request.config.getoption("--kills")
    seed = int(time.time())
    chance = random.Random(seed)
    print(f"\nseed {seed}, {whole.seconds:.1f} s undisturbed", end="")
    made = asked = ends = kept = 0
    output, before = tmp_path / "0", {}
    command = ["batch", table, "--resume", *FAST]
    while made < kills:
        process = start_as_a_user_does([program, *command, "--output", output])
        number = signal.SIGKILL if chance.random() < 0.7 else chance.choice(ASKING)
        try:
            process.communicate(timeout=chance.uniform(0.0, 0.7 * whole.seconds))
            is_killed = False
        except subprocess.TimeoutExpired:
            is_killed = True
        if is_killed and number != signal.SIGKILL:
            # It ends what it has started, and says so; before it looks out for signals it ends by them. Or it was done.
            process.send_signal(number)
            errors = process.communicate(timeout=120)[1]
            assert process.returncode in (0, -number) or (process.returncode == 2 and "interrupted" in errors), (number, errors)
            wait_until(lambda: not processes_of(output), "what it has started ends")
            after = check(output, whole)
            assert {name: after.get(name) for name in before} == before, "what was recorded is neither lost nor repeated"
            asked += 1
            before = after
        elif is_killed:
            made += 1
            # What it has started ends by itself, or at once with it.
            started = [number for number in processes_of(output) if number != process.pid] if chance.random() < 0.5 else []
            process.kill()
            for number in started:
                try:
                    os.kill(number, signal.SIGKILL)
                except ProcessLookupError:
                    continue
            process.communicate()
            if chance.random() < 0.5:
                # Else the next one is started while they are still ending, and waits for them.
                wait_until(lambda: not processes_of(output), "what it has started ends")
                after = check(output, whole)
                assert {name: after.get(name) for name in before} == before, "what was recorded is neither lost nor repeated"
                kept += len(after)
                before = after
        if not is_killed or made == kills:
            check_end(output, whole, run(*command, "--output", output), before)
            ends += 1
            output, before = tmp_path / str(ends), {}
    print(f"; {made} kills, {asked} asked to end, {ends} batches that came to their end, {kept} times a recorded case was found as it was", end="")
    assert ends > 0


@pytest.mark.parametrize("kind", ["disk", "file"])
def test_no_space_at_random_places(request, program, run, table, whole, small_disk, tmp_path, kind):
    """A disk that is full, and files that may not grow as long (of a quota, or by ulimit -f)."""
    rounds = request.config.getoption("--full-disks")
    seed = int(time.time())
    chance = random.Random(seed)
    failed = kept = 0
    limit = None
    for k in range(rounds // 2 + rounds % 2):
        if kind == "disk":
            # From nothing to nearly all of it, less the page to which a size is rounded up: too little each time.
            disk = small_disk(chance.randrange(8, whole.kibibytes - 4))
            output = disk / "out"
        else:
            output = tmp_path / f"limited{k}"
            # Too short for the longest file each time, and half of the times for others, too.
            size = chance.randrange(1, 4096 if chance.random() < 0.5 else whole.longest)
            limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))  # noqa: E731
        command = ["batch", str(table), "--output", str(output), "--resume", *FAST]
        done = subprocess.run([str(program), *command], capture_output=True, text=True, preexec_fn=limit, timeout=300)
        before = check(output, whole)
        assert not list(output.rglob(".dentalscr-*")), "what could not be written is taken away again"
        if done.returncode == 0:
            assert len(before) == CASES
            continue
        failed += 1
        kept += len(before)
        assert done.returncode == 2, (done.returncode, done.stderr)
        assert "No space left" in done.stderr or "too large" in done.stderr.lower(), done.stderr
        if kind == "disk":
            subprocess.run(["mount", "-o", "remount,size=100m", str(disk)], check=True)
        check_end(output, whole, run(*command), before)
    print(f"\nseed {seed}: {failed} of {k + 1} ran out of space, with {kept} cases done before that were kept", end="")
    assert failed > 0
