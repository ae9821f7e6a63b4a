"""Utilities/one_wrong_number.py: what it tells of is what the program does."""
import csv
import json
import pathlib
import struct
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


def test_a_corner_of_a_scan_that_lost_its_sign_is_told(run, case, tmp_path):
    """It moved landmarks by 3 px, and both jaws were ok."""
    scan = case.folder / "upper.stl"
    content = bytearray(scan.read_bytes())
    (triangles,) = struct.unpack_from("<I", content, 80)
    places = [84 + 50 * t + 12 + 4 for t in range(triangles)]
    at = max(places, key=lambda place: abs(struct.unpack_from("<f", content, place)[0]))
    struct.pack_into("<f", content, at, -struct.unpack_from("<f", content, at)[0])
    scan.write_bytes(content)
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    (finding,) = [finding for finding in result["jaws"]["upper"]["findings"] if finding["code"] == "spikes"]
    assert finding["value"] > 20.0 and result["jaws"]["upper"]["status"] == "suspect", finding
    assert "a point stands" in done.stdout + done.stderr
    assert not [finding for finding in result["jaws"]["lower"]["findings"] if finding["code"] == "spikes"]


def test_numbers_of_scans_are_mistaken_too(program, case, tmp_path):
    table = tmp_path / "mistakes.csv"
    call = [sys.executable, SCRIPT, case.folder, "--program", program, "--mistakes", 6, "--files", "upper.stl", "--csv", table]
    done = subprocess.run([*map(str, call)], capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stdout + done.stderr
    with table.open() as file:
        rows = list(csv.DictReader(file))
    assert rows and {row["field"] for row in rows} <= {"scan.x", "scan.y", "scan.z"}
