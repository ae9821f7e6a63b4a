"""Many cases from Python."""
import json
import os
import shutil
import subprocess
import sys

import numpy as np
import pytest


def program(*arguments):
    """``python -m dentalscr``, which finds the package where this process has it."""
    return subprocess.run(
        [sys.executable, "-m", "dentalscr", *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=300,
        env={**os.environ, "PYTHONPATH": ":".join(path for path in sys.path if path)},
    )


@pytest.fixture(scope="module")
def cohort(ds, tmp_path_factory):
    """Two good cases and one whose tracing is missing."""
    folder = tmp_path_factory.mktemp("cohort")
    for seed, name in ((51, "a"), (52, "b")):
        done = program("phantom", "--seed", seed, "--triangles", 6000, "--no-radiograph", "--output", folder / name)
        assert done.returncode == 0, done.stderr
    (folder / "bad").mkdir()
    case = json.loads((folder / "a" / "case.json").read_text())
    case = {"upper": "../a/" + case["upper"], "contours": "missing.json"}
    (folder / "bad" / "case.json").write_text(json.dumps(case))
    return folder


@pytest.mark.parametrize("processes", [True, False])
def test_results_come_one_by_one_and_a_bad_case_stops_none(ds, cohort, tmp_path, processes):
    told = []
    items = {}
    for item in ds.batch(
        cohort, tmp_path / "out", jobs=2, processes=processes, progress=lambda done, count, item: told.append((done, count))
    ):
        items[item.id] = item
    assert set(items) == {"a", "b", "bad"} and told == [(1, 3), (2, 3), (3, 3)]
    assert "missing.json" in str(items["bad"].error) and items["bad"].result is None
    for name in ("a", "b"):
        assert items[name].error is None and items[name].seconds > 0.0
        single = ds.register(cohort / name / "case.json")
        for mark, place in single.upper.landmarks.items():
            assert np.array_equal(items[name].result.upper.landmarks[mark], place)
        assert (tmp_path / "out" / name / "result.json").exists()


def test_the_program_of_the_package_starts_itself_again(cohort, tmp_path):
    done = program("batch", cohort, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 2 and "3 cases: " in done.stdout and "1 unusable" in done.stdout, done.stderr
    assert (tmp_path / "out" / "a" / "result.json").exists()


def test_names_and_arguments_are_checked(ds, cohort, tmp_path):
    with pytest.raises(ValueError, match="two cases"):
        list(ds.batch([cohort / "a" / "case.json", cohort / "a" / "case.json"]))
    with pytest.raises(ds.InputError, match="holds no case"):
        list(ds.batch(tmp_path))
    with pytest.raises(ValueError, match="processes=False"):
        list(ds.batch({"x": ds.ReadCase(cohort / "a" / "case.json")}))
    with pytest.raises(ValueError, match="jobs"):
        list(ds.batch(cohort, jobs=0))


class Death:
    """Ends the process that unpacks it."""

    def __reduce__(self):
        return os._exit, (3,)


def test_a_worker_that_dies_takes_its_own_case_alone(ds, cohort):
    cases = {"a": cohort / "a" / "case.json", "death": {"upper": Death()}, "b": cohort / "b" / "case.json", "later": {"upper": Death()}}
    items = {item.id: item for item in ds.batch(cases, jobs=2)}
    assert set(items) == set(cases)
    for name in ("a", "b"):
        assert items[name].error is None, items[name].error
    for name in ("death", "later"):
        assert items[name].result is None and "terminated" in str(items[name].error)


def test_folders_are_searched_as_the_program_does(ds, cohort, tmp_path, monkeypatch):
    """Below hidden folders and up a level as well, of which only those within the folder hide a case."""
    hidden = tmp_path / ".cache" / "cohort"
    for name in ("a/x", "b", ".old/c"):
        shutil.copytree(cohort / "a", hidden / name)
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    for folder in (hidden, "../.cache/cohort"):
        assert {item.id for item in ds.batch(folder, processes=False)} == {"a_x", "b"}
    shutil.copytree(cohort / "a", hidden / "a_x")
    with pytest.raises(ds.InputError, match="name of two cases"):
        list(ds.batch(hidden))


def test_it_can_be_left_in_the_middle(ds, cohort):
    for item in ds.batch(cohort, jobs=1, processes=False):
        assert item.id in ("a", "b", "bad")
        break
