"""register, render and experiment that are killed, asked to end, or out of space at random moments and places, again and
again over what the last one has left: what was whole stays whole, and a result is of one run. A few of each here; before a
release Utilities/faults.sh. Batches: test_interruptions.py."""
import json
import random
import resource
import signal
import subprocess
import time

import pytest

from program_faults import ASKING, start_as_a_user_does
from result_files import poses_in


def files_in(folder):
    """What is there under its own name: temporaries of runs that were killed wait for the next one."""
    if not folder.is_dir():
        return {}
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file() and not path.relative_to(folder).parts[0].startswith(".dentalscr-")
    }


class Register:
    """Two runs that differ in each file that says where a jaw is, into one folder."""

    name = "out"

    def __init__(self, run, case, folder):
        begin = ["register", str(case), "--quiet", "--output"]
        self.commands = {"free": (begin, []), "held": (begin, ["--fix", "scale"])}
        self.variants = list(self.commands)
        self.wholes = {}
        for variant in self.variants:
            assert run(*self.command(variant, folder / variant)).returncode == 0
            self.wholes[variant] = files_in(folder / variant)
        first, second = self.wholes.values()
        assert set(first) == set(second) and poses_in(first["result.json"]) != poses_in(second["result.json"])
        # These say when they were made.
        self.timed = {"result.json", "report.json", "report.html"}
        self.told_apart = [file for file in first if file not in self.timed and first[file] != second[file]]
        assert len(self.told_apart) >= 4, self.told_apart

    def command(self, variant, output):
        begin, end = self.commands[variant]
        return [*begin, str(output), *end]

    def kept(self, output):
        files = files_in(output)
        if "result.json" not in files:
            return None
        for variant, whole in self.wholes.items():
            if poses_in(files["result.json"]) == poses_in(whole["result.json"]):
                assert set(files) == set(whole), sorted(files)
                mixed = [file for file in whole if file not in self.timed and files[file] != whole[file]]
                assert not mixed, f"of another run than result.json: {mixed}"
                return variant
        raise AssertionError("poses of neither run")

    @staticmethod
    def follows(before, after, variant, is_told):
        """A run that was killed may have no result.json; one that could say a word leaves what was there, or has done it."""
        return after in (before, variant) or (after is None and not is_told)

    @staticmethod
    def is_done(kept, variant):
        return kept == variant


class Render:
    """Two pictures of one name."""

    name = "picture.png"

    def __init__(self, run, case, folder):
        self.case = case
        self.options = {"thickness": [], "radiograph": ["--mode", "radiograph"]}
        self.variants = list(self.options)
        self.wholes = {}
        for variant in self.variants:
            output = folder / f"{variant}.png"
            assert run(*self.command(variant, output)).returncode == 0
            self.wholes[variant] = output.read_bytes()
        assert len(set(self.wholes.values())) == 2

    def command(self, variant, output):
        return ["render", "--case", str(self.case), *self.options[variant], "--output", str(output)]

    def kept(self, output):
        if not output.exists():
            return None
        found = [variant for variant, whole in self.wholes.items() if output.read_bytes() == whole]
        assert found, "neither picture"
        return found[0]

    @staticmethod
    def follows(before, after, variant, is_told):
        return after in (before, variant)

    @staticmethod
    def is_done(kept, variant):
        return kept == variant


def without_seconds(value):
    if isinstance(value, dict):
        return {key: without_seconds(item) for key, item in value.items() if key != "seconds"}
    return [without_seconds(item) for item in value] if isinstance(value, list) else value


class Experiment:
    """One that goes on where it was interrupted."""

    name = "out"
    variants = ["the one"]
    cases = 4

    def __init__(self, run, case, folder):
        assert run(*self.command(self.variants[0], folder / "whole")).returncode == 0
        files = files_in(folder / "whole")
        self.records = {name: without_seconds(json.loads(text)) for name, text in files.items() if name.startswith("cases/")}
        self.tables = {name: text for name, text in files.items() if not name.startswith("cases/")}
        assert len(self.records) == self.cases and "tables.md" in self.tables

    def command(self, variant, output):
        methods = ["--methods", "bounding-box,single-stage", "--no-figures", "--quiet"]
        return ["experiment", "--cases", str(self.cases), *methods, "--output", str(output)]

    def kept(self, output):
        files = files_in(output)
        # Of each case that is there all, as it is of an experiment that nothing disturbs, and its time: it isn't done again.
        for name, text in files.items():
            if name.startswith("cases/"):
                assert without_seconds(json.loads(text)) == self.records[name], name
            elif name != "times.csv":
                assert text == self.tables[name], name
        return files

    @staticmethod
    def follows(before, after, variant, is_told):
        records = {name: text for name, text in before.items() if name.startswith("cases/")}
        return all(after.get(name) == text for name, text in records.items())

    def is_done(self, kept, variant):
        return set(kept) == {*self.records, *self.tables}


@pytest.fixture(scope="module", params=[Register, Render, Experiment], ids=lambda verb: verb.__name__.lower())
def verb(request, run, tmp_path_factory):
    folder = tmp_path_factory.mktemp("whole")
    done = run("phantom", "--seed", 11, "--triangles", 3000, "--no-radiograph", "--output", folder / "p")
    assert done.returncode == 0, done.stderr
    return request.param(run, folder / "p" / "case.json", folder)


def temporaries(folder):
    return list(folder.rglob(".dentalscr-*"))


def test_ended_at_random_moments(request, program, run, verb, tmp_path):
    kills = request.config.getoption("--kills")
    seed = int(time.time())
    chance = random.Random(seed)
    begin = time.monotonic()
    run(*verb.command(verb.variants[0], tmp_path / verb.name))
    seconds = time.monotonic() - begin
    made = asked = told = ends = 0
    folder = tmp_path / "0"
    folder.mkdir()
    before = verb.kept(folder / verb.name)
    while made < kills or ends == 0:
        variant = chance.choice(verb.variants)
        number = signal.SIGKILL if chance.random() < 0.7 else chance.choice(ASKING)
        process = start_as_a_user_does([program, *verb.command(variant, folder / verb.name)])
        try:
            # The moment of the last files comes now and then, however long the machine takes today.
            errors = process.communicate(timeout=chance.uniform(0.0, 1.2 * seconds) if made < kills else 300)[1]
        except subprocess.TimeoutExpired:
            process.send_signal(number)
            errors = process.communicate(timeout=120)[1]
        code = process.returncode
        after = verb.kept(folder / verb.name)
        context = (seed, verb.__class__.__name__, variant, number, code, errors)
        assert verb.follows(before, after, variant, code >= 0), context
        if code == -signal.SIGKILL:
            made += 1
        elif code == -number or (code == 2 and "interrupted" in errors):
            # Before the program looks out for signals it ends by them; from then on it says so.
            asked += 1
            told += code == 2
        else:
            assert code in (0, 1) and verb.is_done(after, variant), context
            assert not temporaries(folder), "what was killed before is swept up by the one that comes to its end"
            ends += 1
            if chance.random() < 0.5 or isinstance(verb, Experiment):
                # An experiment that is done has nothing left that could be interrupted.
                folder = tmp_path / str(ends)
                folder.mkdir()
                after = verb.kept(folder / verb.name)
        before = after
    print(f"\nseed {seed}: {made} kills, {asked} asked to end, {told} of which said so, {ends} came to their end", end="")


@pytest.mark.parametrize("kind", ["disk", "file"])
def test_no_space_at_random_places(request, program, run, verb, small_disk, tmp_path, kind):
    """A disk that is full, and files that may not grow as long (of a quota, or by ulimit -f)."""
    rounds = request.config.getoption("--full-disks")
    seed = int(time.time())
    chance = random.Random(seed)
    undisturbed = tmp_path / "undisturbed" / verb.name
    undisturbed.parent.mkdir()
    run(*verb.command(verb.variants[0], undisturbed))
    files = [undisturbed] if undisturbed.is_file() else [path for path in undisturbed.rglob("*") if path.is_file()]
    longest = max(path.stat().st_size for path in files)
    kibibytes = sum(-(-path.stat().st_size // 4096) * 4 for path in files)
    failed = over = 0
    for k in range(rounds // 2 + rounds % 2):
        first, second = chance.sample(verb.variants * 2, 2)
        limit = None
        if kind == "disk":
            folder = small_disk(100 * 1024)
        else:
            folder = tmp_path / f"limited{k}"
            folder.mkdir()
        # Half of them over what another run has left, which has to be there afterwards.
        is_over = first != second and chance.random() < 0.7
        if is_over:
            over += 1
            assert run(*verb.command(first, folder / verb.name)).returncode in (0, 1)
        if kind == "disk":
            used = sum(-(-path.stat().st_size // 4096) * 4 for path in folder.rglob("*") if path.is_file())
            # From nothing to nearly all of it: too little each time. Folders take nothing of a tmpfs.
            size = used + chance.randrange(0, max(4, kibibytes - 4), 4)
            subprocess.run(["mount", "-o", f"remount,size={max(4, size)}k", str(folder)], check=True)
        else:
            size = chance.randrange(1, longest)
            limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))  # noqa: E731
        before = verb.kept(folder / verb.name)
        command = [str(program), *verb.command(second, folder / verb.name)]
        done = subprocess.run(command, capture_output=True, text=True, preexec_fn=limit, timeout=300)
        after = verb.kept(folder / verb.name)
        context = (seed, k, size, done.returncode, done.stderr)
        assert verb.follows(before, after, second, True), context
        assert not temporaries(folder), "what could not be written is taken away again"
        if done.returncode != 2:
            assert verb.is_done(after, second), context
            continue
        failed += 1
        assert after == before or isinstance(verb, Experiment), context
        assert "No space left" in done.stderr or "too large" in done.stderr.lower(), context
        if kind == "disk":
            subprocess.run(["mount", "-o", "remount,size=100m", str(folder)], check=True)
        assert run(*verb.command(second, folder / verb.name)).returncode in (0, 1)
        assert verb.is_done(verb.kept(folder / verb.name), second), context
    print(f"\nseed {seed}: {failed} of {k + 1} ran out of space, {over} over what another run had left", end="")
    assert failed > 0
