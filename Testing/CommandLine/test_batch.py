"""Many cases at once: what breaks one leaves the others alone, and nothing is done twice."""
import json
import os
import pty
import shutil
import signal
import subprocess
import time

import pytest

from program_faults import wait_until
from result_files import rows_of

FAST = ("--no-report", "--no-page", "--preset", "bounding-box")
COLUMNS = ["case", "jaw", "status", "findings", "matched_px", "expected_error_px", "seconds", "message"]


def times_of(folder):
    return {path.parent.name: path.stat().st_mtime_ns for path in folder.glob("*/result.json")}


@pytest.fixture(scope="module")
def patients(run, tmp_path_factory):
    """Three good cases in folders of two clinics, one of which lies deeper, and one whose scan is no scan."""
    folder = tmp_path_factory.mktemp("cohort") / "patients"
    for i, name in enumerate(("north/p1", "north/p2", "south/p1")):
        done = run(
            "phantom", "--level", "typical", "--seed", 40 + i, "--triangles", 6000, "--no-radiograph", "--output", folder / name
        )
        assert done.returncode == 0, done.stderr
    shutil.copytree(folder / "north/p1", folder / "south/=cmd|bad")
    (folder / "south/=cmd|bad/upper.stl").write_bytes(b"PK\x03\x04 a zip")
    return folder


@pytest.fixture(scope="module")
def batch(run, patients, tmp_path_factory):
    output = tmp_path_factory.mktemp("batch") / "out"
    done = run("batch", patients, "--output", output, "--jobs", 2, "--no-report")
    assert done.returncode == 2, done.stderr
    assert "zip" in done.stderr.lower() and "4 cases: 3 ok" in done.stdout, (done.stdout, done.stderr)
    return output


def test_summaries_have_a_row_a_case_and_jaw(batch):
    rows = rows_of(batch)
    assert list(rows[0]) == COLUMNS
    # What a spreadsheet would run has an apostrophe before it; the files below have their names as they are.
    assert [(row["case"], row["jaw"]) for row in rows if row["status"] != "unusable"] == [
        (case, jaw) for case in ("north_p1", "north_p2", "south_p1") for jaw in ("upper", "lower")
    ]
    (bad,) = [row for row in rows if row["status"] == "unusable"]
    assert bad["case"] == "south_=cmd|bad" and bad["jaw"] == "" and "upper.stl" in bad["message"]
    summary = json.loads((batch / "summary.json").read_text())
    assert summary["schema"] == "dentalscr-batch/1" and summary["cases"] == 4
    for row, other in zip(rows, summary["rows"]):
        assert row["status"] == other["status"] and row["findings"].split() == other["findings"]
        if row["matched_px"]:
            result = json.loads((batch / row["case"] / "result.json").read_text())["jaws"][row["jaw"]]
            assert float(row["matched_px"]) == result["metrics_matched"]["chamfer_px"] == other["matched_px"]
            assert float(row["expected_error_px"]) == result["expected_error_px"] == other["expected_error_px"]
    assert not list(batch.glob("**/.*part*"))


def test_page_holds_the_rows_and_asks_nothing_of_the_network(batch):
    page = (batch / "index.html").read_text()
    data = page.split('<script type="application/json" id="data">')[1].split("</script>")[0]
    rows = json.loads(data)["rows"]
    # Whether a case has a page of its own is seen from the folder, and said on the page alone.
    assert all(row.pop("page") == (batch / row["case"] / "report.html").exists() for row in rows)
    assert rows == json.loads((batch / "summary.json").read_text())["rows"]
    assert "http" not in page.replace("http://www.w3.org/2000/svg", "")


def test_result_is_that_of_a_single_run(run, patients, batch, tmp_path):
    done = run("register", patients / "north/p2/case.json", "--output", tmp_path / "one", "--no-report")
    assert done.returncode == 0
    one = json.loads((tmp_path / "one/result.json").read_text())
    many = json.loads((batch / "north_p2/result.json").read_text())
    for jaw in ("upper", "lower"):
        assert one["jaws"][jaw]["landmarks_px"] == many["jaws"][jaw]["landmarks_px"]


def test_resumed_it_repeats_nothing_but_what_has_changed(run, patients, batch, tmp_path):
    cases, output = tmp_path / "patients", tmp_path / "out"
    shutil.copytree(patients, cases)
    shutil.rmtree(cases / "south" / "=cmd|bad")
    arguments = ("batch", cases, "--output", output, "--no-report")
    assert run(*arguments).returncode == 0
    before = times_of(output)
    # How many run at once changes no result, so it is no reason to run them again.
    for more in ([], ["--jobs", 3]):
        done = run(*arguments, "--resume", *more)
        assert done.returncode == 0 and "3 kept from before" in done.stdout
    assert times_of(output) == before
    contours = json.loads((cases / "north/p2/contours.json").read_text())
    contours["contours"]["upper"].pop()
    (cases / "north/p2/contours.json").write_text(json.dumps(contours))
    assert "2 kept from before" in run(*arguments, "--resume").stdout
    after = times_of(output)
    assert {name for name in after if after[name] != before[name]} == {"north_p2"}
    # Of a case that has become unusable nothing is left that could be taken for its result.
    (cases / "north/p1/upper.stl").write_bytes(b"PK\x03\x04")
    assert run(*arguments, "--resume").returncode == 2
    assert not list((output / "north_p1").iterdir())
    shutil.copy(patients / "north/p1/upper.stl", cases / "north/p1/upper.stl")
    # Other arguments are another question.
    assert "kept" not in run(*arguments, "--resume", "--option", "useRobustKernel=off").stdout


def test_killed_and_started_again_it_loses_nothing(program, run, patients, tmp_path):
    output = tmp_path / "out"
    arguments = ["batch", str(patients), "--output", str(output), "--jobs", "1", "--no-report", "--quiet"]
    process = subprocess.Popen([str(program), *arguments], stderr=subprocess.DEVNULL)
    wait_until(lambda: list(output.glob(".batch/*.json")), "a case is recorded")
    process.send_signal(signal.SIGKILL)
    process.wait()
    recorded = {path.stem for path in output.glob(".batch/*.json")}
    before = times_of(output)
    assert recorded and len(recorded) < 3
    # At once: the process that it has started ends a moment later, and is waited for.
    done = run(*arguments[:-1], "--resume")
    assert done.returncode == 2
    after = times_of(output)
    assert set(after) == {"north_p1", "north_p2", "south_p1"}
    for name in recorded:
        assert after[name] == before[name], "what was recorded stands"


def test_stopped_it_tells_of_no_case_that_failed(program, run, patients, tmp_path):
    """Ctrl-C goes to every process of the terminal's group: what it ends has not failed."""
    output = tmp_path / "out"
    process = subprocess.Popen(
        [str(program), "batch", str(patients / "north"), "--output", str(output), "--jobs", "1", "--no-report", "--quiet"],
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    wait_until(lambda: list(output.glob(".batch/*.log")), "a case is begun")
    os.killpg(process.pid, signal.SIGINT)
    said = process.communicate(timeout=60)[1]
    assert process.returncode == 2 and "interrupted" in said, said
    assert "north_" not in said and not [row for row in rows_of(output) if row["status"] == "unusable"]


def test_on_a_terminal_what_is_said_has_a_line_of_its_own(program, patients, tmp_path):
    """The line that tells how far it is is rewritten: what stays must not stand behind it."""
    terminal, other_end = pty.openpty()
    process = subprocess.Popen(
        [str(program), "batch", str(patients / "south"), "--output", str(tmp_path / "out"), "--jobs", "1", *FAST],
        stderr=other_end,
        stdout=subprocess.DEVNULL,
    )
    os.close(other_end)
    said = b""
    try:
        while part := os.read(terminal, 4096):
            said += part
    except OSError:
        # So it ends, where the other end is closed.
        pass
    os.close(terminal)
    assert process.wait(timeout=60) == 2
    seen = [line.split("\r\x1b[K")[-1] for line in said.decode().split("\r\n")]
    assert b"2 cases" in said and b" left" in said, said
    (bad,) = [line for line in seen if "upper.stl" in line]
    assert bad.startswith("dentalscr: =cmd|bad: ") and seen[-1] == "", seen


def test_a_scan_that_cases_share_is_known_again(run, patients, tmp_path, monkeypatch):
    """Names in a case file lead from it, also out of its folder, and wherever it is named from."""
    shutil.copytree(patients / "north" / "p1", tmp_path / "shared")
    case = json.loads((tmp_path / "shared" / "case.json").read_text())
    for field in ("upper", "lower", "contours"):
        case[field] = "../../shared/" + case[field]
    for field in ("landmarks_3d", "landmarks_2d"):
        case.pop(field, None)
    case["cephalogram"].pop("image", None)
    (tmp_path / "cohort" / "p").mkdir(parents=True)
    (tmp_path / "cohort" / "p" / "case.json").write_text(json.dumps(case))
    monkeypatch.chdir(tmp_path)
    arguments = ("batch", "cohort", "--output", "out", "--no-report")
    assert run(*arguments).returncode == 0
    result = json.loads((tmp_path / "out" / "p" / "result.json").read_text())
    assert result["inputs"]["upper"]["path"] == case["upper"]
    assert "1 kept from before" in run(*arguments, "--resume").stdout
    (tmp_path / "shared" / "contours.json").write_text((patients / "north/p2/contours.json").read_text())
    assert "kept" not in run(*arguments, "--resume").stdout


def test_one_owner_of_a_folder_at_a_time(program, run, patients, tmp_path):
    output = tmp_path / "out"
    process = subprocess.Popen(
        [str(program), "batch", str(patients), "--output", str(output), "--jobs", "1", "--no-report", "--quiet"],
        stderr=subprocess.DEVNULL,
    )
    wait_until(lambda: (output / ".batch").exists(), "the first owner is at work")
    done = run("batch", patients, "--output", output)
    assert done.returncode == 2 and "another run is at work" in done.stderr
    process.send_signal(signal.SIGINT)
    process.wait(timeout=60)
    assert run("batch", patients, "--output", output, "--no-report", "--resume").returncode == 2


def test_tables_name_cases_by_file_or_by_options(run, patients, tmp_path):
    case = json.loads((patients / "north/p1/case.json").read_text())
    table = tmp_path / "cases.csv"
    rows = ["id;case;age", f"first;{patients}/north/p1/case.json;\"say \"\"12\"\", twice\"", f"=2+3;{patients}/north/p2/case.json;-1"]
    table.write_text("\n".join(rows))
    done = run("batch", table, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0 and 'column "age" is not known' in done.stderr
    found = rows_of(tmp_path / "out")
    assert {(row["case"], row["age"]) for row in found} == {("first", 'say "12", twice'), ("'=2+3", "-1")}
    assert (tmp_path / "out" / "=2+3" / "result.json").exists()
    spacing = " ".join(str(value) for value in case["cephalogram"]["pixel_spacing_mm"])
    relative = os.path.relpath(patients / "north/p1", tmp_path)
    table.write_text(
        "id,upper,lower,contours,spacing\n"
        f'a,"{relative}/{case["upper"]}",{relative}/{case["lower"]},{relative}/{case["contours"]},{spacing}\n'
    )
    done = run("batch", table, "--output", tmp_path / "fields", "--no-report")
    assert done.returncode == 0, done.stderr
    assert "kept" in run("batch", table, "--output", tmp_path / "fields", "--no-report", "--resume").stdout
    # Where one stands beside the table, its name has no folder.
    again = run("batch", "cases.csv", "--output", "fields", "--no-report", "--resume", cwd=tmp_path)
    assert again.returncode == 0 and "kept" in again.stdout, again.stderr


def test_what_is_said_of_a_case_as_a_whole_is_in_its_rows(run, patients, tmp_path):
    """A misspelt field changes what is registered, and nobody reads a log a case."""
    shutil.copytree(patients / "north/p1", tmp_path / "cases/p1")
    case = json.loads((tmp_path / "cases/p1/case.json").read_text())
    (tmp_path / "cases/p1/case.json").write_text(json.dumps({**case, "traced_sides": "left"}))
    (tmp_path / "cases/p2").mkdir()
    done = run("batch", tmp_path / "cases", "--output", tmp_path / "out", *FAST)
    assert done.returncode == 0 and "no case.json is in p2" in done.stderr, done.stderr
    for _ in range(2):
        rows = rows_of(tmp_path / "out")
        assert len(rows) == 2 and all("traced_sides: unknown field" in row["message"] for row in rows)
        # Of a result that is kept, too.
        assert "1 kept" in run("batch", tmp_path / "cases", "--output", tmp_path / "out", "--resume", *FAST).stdout


@pytest.mark.parametrize(
    ("content", "word"),
    [
        ("", "is empty"),
        ("a,b\n1,2\n", 'neither a column "case"'),
        ("case\n\n", "no row of a case"),
        ("case\na.json,b\n", "2 cells under 1"),
        ("id,case\nx,a.json\nx,b.json\n", "name of two cases"),
        ("id,case\na/b,a.json\n", "can't be a folder's name"),
    ],
)
def test_bad_tables_are_one_line(run, tmp_path, content, word):
    (tmp_path / "cases.csv").write_text(content)
    done = run("batch", tmp_path / "cases.csv", "--output", tmp_path / "out")
    assert done.returncode == 2 and word in done.stderr, done.stderr
    assert len([line for line in done.stderr.splitlines() if "warning" not in line]) == 1
    assert not (tmp_path / "out" / "summary.csv").exists()


def test_nothing_to_do_is_said(run, tmp_path):
    (tmp_path / "empty").mkdir()
    for what, word in ((tmp_path / "empty", "holds no case"), (tmp_path / "none*", "matches no case")):
        done = run("batch", what, "--output", tmp_path / "out")
        assert done.returncode == 2 and word in done.stderr


def test_a_pattern_finds_cases(run, patients, tmp_path):
    done = run("batch", f"{patients}/north/*", "--output", tmp_path / "out", "--no-report", "--no-page")
    assert done.returncode == 0, done.stderr
    assert {row["case"] for row in rows_of(tmp_path / "out")} == {"p1", "p2"}
    assert not (tmp_path / "out" / "index.html").exists()


@pytest.fixture(scope="module")
def same(patients, tmp_path_factory):
    """A table of 12 cases, all of them the same phantom, two of which have names and words that a spreadsheet would run."""
    table = tmp_path_factory.mktemp("table") / "cases.csv"
    names = [f"p{i:02d}" for i in range(10)] + ["=HYPERLINK(1)", "@SUM(A1)"]
    words = {"p00": "+1+cmd|' /C calc'!A0", "p01": "\tx", "p02": "-3.5"}
    rows = [f'"{name}",{patients}/north/p1/case.json,"{words.get(name, "plain")}"' for name in names]
    table.write_text('id,case,"=note"\n' + "\n".join(rows) + "\n")
    return table


@pytest.fixture(scope="module")
def whole(run, same, tmp_path_factory):
    output = tmp_path_factory.mktemp("whole") / "out"
    done = run("batch", same, "--output", output, *FAST)
    assert done.returncode == 0, done.stderr
    return output


def without_times(folder):
    return rows_of(folder, "seconds", "folder")


def test_disk_that_is_full_in_the_middle(run, same, whole, small_disk):
    """Whatever is there is whole; with space again the same command repeats nothing that was done."""
    files = sorted(path.name for path in (whole / "p00").iterdir())
    size = sum(-(-path.stat().st_size // 4096) * 4 for path in (whole / "p00").iterdir())
    # Three cases or so, with a page each for the folder, record and log of a case.
    disk = small_disk(4 * size + 60)
    output = disk / "out"
    done = run("batch", same, "--output", output, "--jobs", 2, *FAST)
    assert done.returncode == 2 and "No space left" in done.stderr, done.stderr
    assert not list(disk.rglob("*.part"))
    kept = []
    for name in [path.name for path in output.iterdir() if path.is_dir() and path.name != ".batch"]:
        found = sorted(path.name for path in (output / name).iterdir())
        assert found in ([], files), name
        if found:
            json.loads((output / name / "result.json").read_text())
            kept.append(name)
    assert 1 <= len(kept) < 12
    for record in output.glob(".batch/*.json"):
        json.loads(record.read_text())
    for table in output.glob("summary.json"):
        # What could not be registered says why.
        assert all(row["message"] for row in json.loads(table.read_text())["rows"] if row["status"] == "unusable")
    recorded = {path.stem for path in output.glob(".batch/*.json")} & set(kept)
    before = times_of(output)
    subprocess.run(["mount", "-o", "remount,size=100m", str(disk)], check=True)
    done = run("batch", same, "--output", output, "--resume", *FAST)
    assert done.returncode == 0, done.stderr
    assert without_times(output) == without_times(whole)
    after = times_of(output)
    assert {name for name in recorded if after[name] == before[name]} == recorded and recorded


def test_files_that_may_not_grow_are_told_of(program, run, same, tmp_path):
    """ulimit -f, as of a quota: a result is longer, what a case has said is not."""
    output = tmp_path / "out"
    done = subprocess.run(
        ["bash", "-c", 'ulimit -f 2; exec "$@"', "bash", str(program), "batch", str(same), "--output", str(output), *FAST],
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 2 and "too large" in done.stderr.lower(), (done.returncode, done.stderr[-2000:])
    assert not list(output.rglob("result.json")) and not list(output.rglob("*.part"))
    assert run("batch", same, "--output", output, "--resume", *FAST).returncode == 0
    assert len(list(output.glob("*/result.json"))) == 12


def test_every_table_defuses_what_a_spreadsheet_would_run(run, same, whole, tmp_path):
    for line, rows in (("one batch", rows_of(whole)), ("parts", None)):
        if rows is None:
            for first, last in ((1, 6), (7, 12)):
                done = run("batch", same, "--range", f"{first}-{last}", "--output", tmp_path / f"parts/=part{first}", *FAST)
                assert done.returncode == 0, done.stderr
            done = run("batch", same, "--collect", tmp_path / "parts", "--output", tmp_path)
            assert done.returncode == 0, done.stderr
            rows = rows_of(tmp_path)
        for row in rows:
            for cell in [*row.keys(), *row.values()]:
                if cell[:1] in ("=", "+", "-", "@", "\t", "\r"):
                    float(cell)
        by_name = {row["case"]: row for row in rows}
        assert {"'=HYPERLINK(1)", "'@SUM(A1)"} <= set(by_name), line
        assert by_name["p00"]["'=note"].startswith("'+1") and by_name["p01"]["'=note"] == "'\tx", line
        assert by_name["p02"]["'=note"] == "-3.5", "a number is one"
    # The folders are beside the page, so what a spreadsheet is told of them begins with a word.
    assert {row["folder"].split("/")[0] for row in rows} == {"parts"}
    assert without_times(tmp_path) == without_times(whole)


def test_parts_that_are_missing_are_named(run, same, tmp_path):
    parts = tmp_path / "parts"
    assert run("batch", same, "--range", "1-6", "--output", parts / "1", *FAST).returncode == 0
    (parts / "2" / ".batch").mkdir(parents=True)
    done = run("batch", same, "--collect", parts, "--output", tmp_path / "all")
    assert done.returncode == 2
    assert "part 2 was not run to its end" in done.stderr and "6 cases have no result" in done.stderr, done.stderr
    summary = json.loads((tmp_path / "all" / "summary.json").read_text())
    assert summary["complete"] is False and summary["cases"] == 12
    bad = [row for row in summary["rows"] if row["status"] == "unusable"]
    assert len(bad) == 6 and all("no part of the cohort" in row["message"] for row in bad)
    # Both parts have cases 5 and 6.
    assert run("batch", same, "--range", "5-12", "--output", parts / "2", *FAST).returncode == 0
    done = run("batch", same, "--collect", parts, "--output", tmp_path / "twice")
    assert done.returncode == 2 and "is a case of two parts: " in done.stderr, done.stderr
    assert not (tmp_path / "twice").exists()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--range", "0-3"], "--range"),
        (["--range", "3-2"], "--range"),
        (["--range", "-3-5"], "--range"),
        (["--range", "3"], "first and last"),
        (["--range", "13-14"], "there are 12"),
        (["--range", "99999999999999999999999-5"], "--range"),
        (["--collect", "nowhere"], "nowhere"),
        (["--collect", ".", "--resume"], "--resume"),
    ],
)
def test_bad_parts_are_one_line(run, same, tmp_path, words, said):
    done = run("batch", same, "--output", tmp_path / "out", *words, cwd=tmp_path)
    assert done.returncode == 2 and said in done.stderr, done.stderr
    assert not (tmp_path / "out").exists()


def test_range_past_the_end_is_the_last_part(run, same, tmp_path):
    done = run("batch", same, "--range", "11-20", "--output", tmp_path / "out", *FAST)
    assert done.returncode == 0 and "2 cases" in done.stdout, done.stdout + done.stderr


def test_waits_for_a_batch_at_work_and_repeats_nothing(program, run, patients, tmp_path):
    output = tmp_path / "out"
    arguments = ["batch", str(patients / "north"), "--output", str(output), "--no-report"]
    first = subprocess.Popen([str(program), *arguments, "--quiet"], stderr=subprocess.DEVNULL)
    wait_until(lambda: list(output.glob(".batch/*.log")), "a case is begun")
    assert first.poll() is None
    done = run(*arguments, "--resume", "--wait")
    assert first.wait(timeout=60) == 0
    assert done.returncode == 0 and "2 kept from before" in done.stdout, done.stdout + done.stderr
