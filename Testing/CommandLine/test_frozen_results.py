"""The answers of the program are those that were frozen.

A registration may be computed in another way; its answers change on purpose only. Then

    /usr/bin/python3 -m pytest -q Testing/CommandLine/test_frozen_results.py --build-dir build/test --refreeze

writes Frozen/*.json anew (with -k, or without the sample cases beside the project, the other records stay what they
are), in a commit of its own that says what changed and why. The files' difference is part of what is reviewed: a number
that moves where nothing was meant to is a fault.

Not kept are times and paths, projections and covariances: the landmarks and their sigma are what these amount to.
"""
import json
import os
import pathlib

import pytest

from frozen_records import differences, record_of, to_text
from frozen_runs import RUNS
from program_runs import Shared

FOLDER = pathlib.Path(__file__).resolve().parent / "Frozen"


def group_of(name):
    return name.partition(": ")[0]


def read_records():
    return {name: record for path in FOLDER.glob("*.json") for name, record in json.loads(path.read_text()).items()}


@pytest.fixture(scope="module")
def records(request):
    """Those that are frozen; written back where they are to be frozen anew."""
    kept = read_records()
    refreeze = request.config.getoption("--refreeze")
    # Each would write what the others have not frozen.
    assert not refreeze or int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", 1)) == 1, "--refreeze with one process: without -n"
    if refreeze:
        kept = {name: record for name, record in kept.items() if name in RUNS}
    yield kept
    if refreeze:
        FOLDER.mkdir(exist_ok=True)
        for path in FOLDER.glob("*.json"):
            path.unlink()
        for group in sorted({group_of(name) for name in kept}):
            of_group = {name: record for name, record in kept.items() if group_of(name) == group}
            (FOLDER / f"{group}.json").write_text(to_text(of_group))


@pytest.fixture(scope="module")
def outcomes(request, runs, shared_folder):
    """Futures of what the tests that were selected need: started at once, since two run at a time."""
    selected = [item.callspec.params for item in request.session.items if hasattr(item, "callspec")]
    wanted = {parameters["name"] for parameters in selected if parameters.get("name") in RUNS}
    there = [n for n in RUNS if n in wanted and (shared_folder.is_dir() or not isinstance(RUNS[n].case, Shared))]
    return {name: runs.start(RUNS[name]) for name in there}


@pytest.mark.parametrize("name", RUNS)
def test_answer_is_the_frozen_one(request, outcomes, records, name):
    if isinstance(RUNS[name].case, Shared):
        request.getfixturevalue("shared_cases")
    now = record_of(outcomes[name].result())
    if request.config.getoption("--refreeze"):
        records[name] = now
        pytest.skip("frozen anew, compared with nothing")
    assert name in records, "there is no frozen answer of this run: --refreeze"
    lines = differences(records[name], now)
    assert not lines, f"{name}\n" + "\n".join(lines)


@pytest.mark.parametrize("name", ["cases: hard", "mistakes: wrong facing", "presets: paper"])
def test_rerun_and_other_threads_give_the_same_bits(runs, name):
    """What is frozen is an answer of the case, not of a run. A rerun with one thread is another process."""
    results = []
    for future in [runs.start(RUNS[name]), runs.start(RUNS[name], 1, again=True), runs.start(RUNS[name], 3)]:
        result = json.loads(json.dumps(future.result().result))
        result.pop("total_seconds")
        # Each run has a copy of the case in a folder of its own, and files beside it.
        result.pop("inputs")
        for jaw in result["jaws"].values():
            jaw.pop("seconds")
        results.append(json.dumps(result))
    assert results[0] == results[1]
    assert results[0] == results[2]


def test_every_frozen_answer_has_its_run(records):
    assert set(records) <= set(RUNS)


RECORD = {
    "exit_code": 0,
    "jaws": {
        "upper": {
            "status": "ok",
            "reasons": ["the fit is poor: 90 % below 3.1 px"],
            "landmarks_px": {"UR1_tip": [500.0, 600.0, 0.8]},
            "candidates_px": [[0.12, 0.0]],
            "details": {"fit_cost": 0.12, "yaw_rad": 0.01},
        }
    },
}


@pytest.mark.parametrize(
    "path, value, word",
    [
        (("exit_code",), 1, "exit_code: frozen 0, now 1"),
        (("jaws", "upper", "status"), "suspect", "jaws upper status: frozen 'ok', now 'suspect'"),
        (("jaws", "upper", "reasons"), [], "reasons: frozen ['the fit"),
        (("jaws", "upper", "reasons"), ["the fit is poor: 90 % below 3.3 px"], "below 3.3 px"),
        (("jaws", "upper", "reasons"), ["the fit is good: 90 % below 3.1 px"], "the fit is good"),
        (("jaws", "upper", "landmarks_px", "UR1_tip"), [500.0, 600.002, 0.8], "upper landmarks_px UR1_tip: frozen [500.0, 600.0]"),
        (("jaws", "upper", "landmarks_px", "UR1_tip"), [500.0, float("nan"), 0.8], "nan px apart"),
        (("jaws", "upper", "landmarks_px", "UR1_tip"), [500.0, 600.0], "now [500.0, 600.0]"),
        (("jaws", "upper", "landmarks_px", "UR1_tip"), [500.0, 600.0, 0.802], "sigma: frozen 0.8, now 0.802, difference 0.002"),
        (("jaws", "upper", "landmarks_px"), {}, "UR1_tip: frozen [500.0, 600.0, 0.8], now not there"),
        (("jaws", "upper", "candidates_px"), [], "candidates_px: frozen [["),
        (("jaws", "upper", "details", "fit_cost"), 0.1203, "details fit_cost: frozen 0.12"),
        (("jaws", "upper", "details", "yaw_rad"), 0.0102, "details yaw_rad: frozen 0.01"),
        (("jaws", "lower"), {}, "jaws lower: frozen not there"),
    ],
)
def test_difference_is_named(path, value, word):
    lines = differences(RECORD, changed(path, value))
    assert len(lines) == 1 and word in lines[0]


@pytest.mark.parametrize(
    "path, value",
    [
        (("jaws", "upper", "reasons"), ["the fit is poor: 90 % below 3.2 px"]),
        (("jaws", "upper", "landmarks_px", "UR1_tip"), [500.0005, 599.9995, 0.8005]),
        (("jaws", "upper", "details", "fit_cost"), 0.12001),
    ],
)
def test_rounding_is_no_difference(path, value):
    assert differences(RECORD, changed(path, value)) == []


def changed(path, value):
    record = json.loads(json.dumps(RECORD))
    place = record
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = value
    return record
