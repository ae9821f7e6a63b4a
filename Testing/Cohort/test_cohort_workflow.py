"""Examples/Cohort: a cohort in parts by Snakemake, on this machine and on a Slurm of this machine alone.

Needs snakemake 9 (Utilities/python-venv.sh). What takes minutes, and Slurm, is run by Utilities/test-cohort.sh (--at-length), which
installs slurmctld, slurmd, slurm-client and munge; what is missing is said where a test is skipped."""
import csv
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import one_machine_slurm  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORKFLOW = ROOT / "Examples" / "Cohort"
SNAKEMAKE = shutil.which("snakemake", path=f"{ROOT}/build/cohort-venv/bin:{os.environ.get('PATH', '')}")
if SNAKEMAKE is None:
    pytest.skip("snakemake is not installed (Utilities/python-venv.sh)", allow_module_level=True)
VERSION = subprocess.run([SNAKEMAKE, "--version"], capture_output=True, text=True, timeout=120).stdout.strip()
if int((VERSION or "0").split(".")[0]) < 9:
    pytest.skip(f"snakemake 9 is needed, {SNAKEMAKE} is {VERSION or 'not usable'}", allow_module_level=True)

NAMES = ["a", "b", "c", "d", "e", "bad", "g"]


class Cohort:
    """A table of cases and the workflow over it; the program is called by a script that counts and, as told, fails."""

    def __init__(self, folder, case, program, names=NAMES):
        self.folder = folder
        self.case = case
        self.table = folder / "cases.csv"
        self.table.write_text("id,case,ward\n")
        self.add(*names)
        self.output = folder / "results"
        self.script = folder / "dentalscr"
        self.script.write_text(
            f"""#!/bin/sh
echo "$*" >> "{folder}/calls"
range=$(echo "$*" | sed -n 's/.*--range \\([0-9-]*\\).*/\\1/p')
if [ -n "$range" ] && [ -e "{folder}/fail-$range" ]; then
  [ -s "{folder}/fail-$range" ] && rm "{folder}/fail-$range"
  echo "dentalscr: the machine has lost its power" >&2
  exit 137
fi
exec "{program}" "$@"
"""
        )
        self.script.chmod(0o755)

    def add(self, *names):
        with open(self.table, "a") as file:
            for name in names:
                file.write(f"{name},{self.case.parent / 'nothing.json' if name == 'bad' else self.case},=ward {name}\n")

    def command(self, *arguments, **config):
        config = {"cases": self.table, "output": self.output, "dentalscr": self.script, "part_size": 2, "workers": 1, **config}
        config.setdefault("options", "--no-report")
        return [
            SNAKEMAKE,
            "--snakefile",
            str(WORKFLOW / "Snakefile"),
            "--directory",
            str(self.folder),
            "--nocolor",
            "--retries",
            "1",
            *arguments,
            "--config",
            *[f"{key}={value}" for key, value in config.items()],
        ]

    def run(self, *arguments, environment=None, **config):
        arguments = arguments or ("--profile", str(WORKFLOW / "local"), "--cores", "2")
        return subprocess.run(
            self.command(*arguments, **config), capture_output=True, text=True, timeout=400, env=environment, stdin=subprocess.DEVNULL
        )

    def ranges(self):
        """Of the calls so far; they are forgotten."""
        calls = self.folder / "calls"
        found = re.findall(r"--range (\S+)", calls.read_text()) if calls.exists() else []
        calls.unlink(missing_ok=True)
        return sorted(found)

    def rows(self):
        with open(self.output / "summary.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def summary(self):
        return json.loads((self.output / "summary.json").read_text())

    def times(self):
        return {path.parent.name: path.stat().st_mtime_ns for path in self.output.glob("parts/*/*/result.json")}


@pytest.fixture(scope="module")
def one_case(run, tmp_path_factory):
    folder = tmp_path_factory.mktemp("phantom") / "case"
    done = run("phantom", "--level", "typical", "--seed", 41, "--triangles", 6000, "--no-radiograph", "--output", folder)
    assert done.returncode == 0, done.stderr
    return folder / "case.json"


@pytest.fixture(scope="module")
def single(run, one_case, program, tmp_path_factory):
    """The same cases in one batch: what the parts must come to."""
    cohort = Cohort(tmp_path_factory.mktemp("single"), one_case, program)
    done = run("batch", cohort.table, "--output", cohort.output, "--no-report")
    assert done.returncode == 2, done.stderr
    return cohort


@pytest.fixture(scope="session")
def at_length(request):
    if not request.config.getoption("--at-length"):
        pytest.skip("takes minutes: Utilities/test-cohort.sh")


@pytest.fixture
def cohort(one_case, program, tmp_path):
    return Cohort(tmp_path, one_case, program)


def without_times(rows):
    return [{key: value for key, value in row.items() if key not in ("seconds", "folder")} for row in rows]


def check_same(cohort, single):
    assert without_times(cohort.rows()) == without_times(single.rows())
    ours, theirs = cohort.summary(), single.summary()
    assert without_times(ours["rows"]) == without_times(theirs["rows"])
    assert ours["complete"] is True and ours["cases"] == len(NAMES)
    page = (cohort.output / "index.html").read_text()
    data = json.loads(page.split('<script type="application/json" id="data">')[1].split("</script>")[0])
    assert without_times([{k: v for k, v in row.items() if k != "page"} for row in data["rows"]]) == without_times(ours["rows"])
    for row in data["rows"]:
        # Links of the page lead to what is there.
        assert (cohort.output / row["folder"] / "result.json").exists() == (row["status"] != "unusable"), row


@pytest.mark.usefixtures("at_length")
def test_parts_come_to_what_one_batch_does(cohort, single):
    done = cohort.run()
    assert done.returncode == 0, done.stdout + done.stderr
    assert cohort.ranges() == ["1-2", "3-4", "5-6", "7-8"]
    check_same(cohort, single)
    (bad,) = [row for row in cohort.rows() if row["status"] == "unusable"]
    assert bad["case"] == "bad" and "nothing.json" in bad["message"] and bad["ward"] == "'=ward bad"
    before = cohort.times()
    done = cohort.run()
    assert done.returncode == 0 and "Nothing to be done" in done.stdout + done.stderr
    assert cohort.ranges() == [] and cohort.times() == before
    # A scan that was edited is no row that has changed: asked for, all parts look, and run what has changed.
    shutil.copytree(cohort.case.parent, cohort.folder / "own")
    cohort.table.write_text(cohort.table.read_text().replace(f"b,{cohort.case}", "b,own/case.json"))
    assert cohort.run().returncode == 0 and cohort.ranges() == ["1-2"]
    changed = cohort.times()
    assert {name for name in changed if changed[name] != before[name]} == {"b"}
    tracing = json.loads((cohort.folder / "own/contours.json").read_text())
    tracing["contours"]["upper"].pop()
    (cohort.folder / "own/contours.json").write_text(json.dumps(tracing))
    done = cohort.run("--cores", "2", "--forcerun", "part")
    assert done.returncode == 0 and cohort.ranges() == ["1-2", "3-4", "5-6", "7-8"]
    again = cohort.times()
    assert {name for name in again if again[name] != changed[name]} == {"b"}


@pytest.mark.usefixtures("at_length")
def test_failed_part_is_retried(cohort, single):
    (cohort.folder / "fail-3-4").write_text("once")
    done = cohort.run()
    assert done.returncode == 0, done.stdout + done.stderr
    assert cohort.ranges() == ["1-2", "3-4", "3-4", "5-6", "7-8"]
    check_same(cohort, single)


def test_part_that_fails_is_listed_and_alone_run_again(cohort, single):
    (cohort.folder / "fail-3-4").write_text("")
    done = cohort.run()
    assert done.returncode == 1
    said = done.stdout + done.stderr
    assert "1 of 4 parts were not run to their end: 000003-000004" in said and "lost its power" in said, said
    assert cohort.ranges() == ["1-2", "3-4", "3-4", "5-6", "7-8"]
    # The others are in the tables, and of those that it had what is missing.
    assert not cohort.summary()["complete"]
    rows = {row["case"]: row for row in cohort.rows()}
    assert set(rows) == set(NAMES)
    for name in "cd":
        assert rows[name]["status"] == "unusable" and "no part of the cohort" in rows[name]["message"]
    assert rows["a"]["status"] == "ok" and rows["g"]["status"] == "ok"
    before = cohort.times()
    (cohort.folder / "fail-3-4").unlink()
    done = cohort.run()
    assert done.returncode == 0, done.stdout + done.stderr
    assert cohort.ranges() == ["3-4"]
    check_same(cohort, single)
    after = cohort.times()
    assert {name: after[name] for name in before} == before


@pytest.mark.usefixtures("at_length")
def test_table_that_grows_runs_its_last_part_alone(cohort):
    assert cohort.run().returncode == 0
    cohort.ranges()
    before = cohort.times()
    cohort.add("h", "i")
    done = cohort.run()
    assert done.returncode == 0, done.stdout + done.stderr
    assert cohort.ranges() == ["7-8", "9-10"]
    after = cohort.times()
    assert set(after) - set(before) == {"h", "i"} and {name: after[name] for name in before} == before
    assert cohort.summary()["cases"] == 9


@pytest.mark.usefixtures("at_length")
@pytest.mark.parametrize(
    ("config", "word"),
    [
        ({"part_sise": 3}, "part_sise: not known"),
        ({"cases": "nowhere.csv"}, "nowhere.csv: can't be read"),
        ({"part_size": 0}, "part_size: is below 1"),
    ],
)
def test_bad_configuration_is_named(cohort, config, word):
    done = cohort.run(**config)
    assert done.returncode != 0 and word in done.stdout + done.stderr


def wait_for_part(cohort, process, seconds=240):
    """Until one part is done and another is not."""
    deadline = time.monotonic() + seconds
    while not list(cohort.output.glob("parts/*.done")):
        assert process.poll() is None and time.monotonic() < deadline, "no part was ever done"
        time.sleep(0.02)
    assert len(list(cohort.output.glob("parts/*.done"))) < 4


@pytest.mark.usefixtures("at_length")
def test_killed_engine_goes_on_where_it_was(cohort, single):
    arguments = ("--profile", str(WORKFLOW / "local"), "--cores", "1")
    with open(cohort.folder / "said", "w") as said:
        process = subprocess.Popen(cohort.command(*arguments), stdout=said, stderr=said, stdin=subprocess.DEVNULL)
        wait_for_part(cohort, process)
        process.send_signal(signal.SIGKILL)
        process.wait()
    done_parts = {path.stem for path in cohort.output.glob("parts/*.done")}
    before = {path.parent.name: path.stat().st_mtime_ns for part in done_parts for path in cohort.output.glob(f"parts/{part}/*/result.json")}
    assert before
    cohort.ranges()
    assert cohort.run("--unlock").returncode == 0
    done = cohort.run(*arguments)
    assert done.returncode == 0, done.stdout + done.stderr
    check_same(cohort, single)
    after = cohort.times()
    assert {name: after[name] for name in before} == before, "what was done stands"


@pytest.fixture(scope="module")
def slurm(at_length):
    try:
        with one_machine_slurm.OneMachineSlurm() as started:
            yield started
    except one_machine_slurm.Unavailable as reason:
        pytest.skip(f"no Slurm of this machine: {reason}")


def test_on_slurm_killed_once(cohort, single, slurm):
    """Jobs of a queue go on when the engine is killed; started again it waits for them and repeats nothing."""
    arguments = (
        "--profile",
        str(WORKFLOW / "slurm"),
        "--jobs",
        "2",
        # The cluster has no database of jobs: squeue knows what has ended, for MinJobAge.
        "--slurm-status-command",
        "squeue",
        "--slurm-init-seconds-before-status-checks",
        "2",
        "--slurm-no-account",
        "--latency-wait",
        "10",
    )
    (cohort.folder / "fail-5-6").write_text("once")
    logs = [cohort.folder / "first", cohort.folder / "second"]
    with open(logs[0], "w") as said:
        process = subprocess.Popen(
            cohort.command(*arguments, mem_mb_per_worker=200),
            stdout=said,
            stderr=said,
            stdin=subprocess.DEVNULL,
            env=slurm.environment,
            cwd=cohort.folder,
        )
        try:
            wait_for_part(cohort, process)
        finally:
            process.send_signal(signal.SIGKILL)
            process.wait()
    assert cohort.run("--unlock").returncode == 0
    done = cohort.run(*arguments, mem_mb_per_worker=200, environment=slurm.environment)
    logs[1].write_text(done.stdout + done.stderr)
    said = [log.read_text() for log in logs]
    assert done.returncode == 0, "\n".join(said) + slurm.said()
    ids = [re.findall(r"SLURM jobid (\d+)", text) for text in said]
    print("jobs of Slurm before and after the engine was killed:", ids)
    assert ids[0] and ids[1] and not set(ids[0]) & set(ids[1]), said
    known = slurm.call("squeue", "--states=all", "--noheader", "--format=%i %T")
    for number in ids[0] + ids[1]:
        assert re.search(rf"^{number} (COMPLETED|FAILED)$", known, re.MULTILINE), known
    # The part that failed once was run twice, whichever engine saw it.
    assert cohort.ranges().count("5-6") >= 2
    check_same(cohort, single)
