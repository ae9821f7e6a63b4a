"""Utilities/one_wrong_number.py: what it tells of is what the program does."""
import csv
import json
import pathlib
import subprocess
import sys

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "one_wrong_number.py"


def test_mistakes_are_counted_by_what_came_of_them(program, case, tmp_path):
    table = tmp_path / "mistakes.csv"
    call = [sys.executable, SCRIPT, case.folder, "--program", program, "--mistakes", 16, "--seed", 2, "--csv", table]
    done = subprocess.run([*map(str, call)], capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stdout + done.stderr
    with table.open() as file:
        rows = list(csv.DictReader(file))
    # A mistake that leaves a number as it was is none.
    assert 8 <= len(rows) <= 16
    assert {row["outcome"] for row in rows} <= {"refused", "not ok", "warned", "ok"}
    assert all(float(row["before"]) != float(row["after"]) for row in rows)
    assert all((row["moved_px"] == "") == (row["outcome"] == "refused") for row in rows)
    total = [cell.strip() for cell in done.stdout.splitlines()[-1].strip("|").split("|")]
    counts = [sum(row["outcome"] == outcome for row in rows) for outcome in ("refused", "not ok", "warned", "ok")]
    assert total[0] == "all" and [int(cell) for cell in total[1:6]] == [len(rows), *counts]
    silent = [float(row["moved_px"]) for row in rows if row["outcome"] == "ok" and float(row["moved_px"]) > 1.0]
    assert int(total[6]) == len(silent)


def test_a_case_that_is_not_ok_as_it_is_ends_it(program, case, tmp_path):
    contours = case.load("contours.json")
    for polyline in contours["contours"]["upper"]:
        polyline["points"] = [[x, 2 * y] for x, y in polyline["points"]]
    contours["image_size"][1] *= 2
    case.save(contours, "contours.json")
    content = case.load()
    content["cephalogram"].pop("image", None)
    case.save(content)
    done = subprocess.run([sys.executable, str(SCRIPT), str(case.folder), "--program", str(program)], capture_output=True, text=True, timeout=600)
    assert done.returncode == 1 and "is not ok as it is" in done.stderr, done.stdout + done.stderr
    assert json.loads((case.folder / "case.json").read_text()) == content
