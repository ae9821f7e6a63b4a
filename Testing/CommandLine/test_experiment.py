"""The verb experiment as a user sees it; methods that take no time, tiny cohorts."""
import base64
import csv
import json
import re
import shutil
import signal
import subprocess
import time

import pytest

FAST = ("--methods", "bounding-box,paper,icp")


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def tables(folder):
    """Every file that must hold the same bits."""
    return {
        path.name: path.read_bytes()
        for path in folder.iterdir()
        if path.suffix in (".csv", ".md", ".json", ".png", ".html") and path.name != "times.csv"
    }


@pytest.fixture(scope="module")
def experiment(run, tmp_path_factory):
    folder = tmp_path_factory.mktemp("experiment") / "out"
    done = run("experiment", "--cases", 2, "--seed", 3, *FAST, "--output", folder)
    assert done.returncode == 0, done.stderr
    assert "tables.md" in done.stdout
    return folder


def test_writes_the_papers_tables_with_its_figures_beside(experiment):
    table = rows(experiment / "table1_landmarks.csv")
    assert {(row["jaw"], row["method"]) for row in table} == {
        (jaw, method) for jaw in ("upper", "lower") for method in ("bounding-box", "paper", "icp")
    }
    paper = next(row for row in table if row["jaw"] == "upper" and row["method"] == "paper")
    assert float(paper["paper_mean_px"]) == 17.546
    assert float(paper["mean_low95_px"]) <= float(paper["mean_px"]) <= float(paper["mean_high95_px"])
    text = (experiment / "tables.md").read_text()
    assert "other, private data" in text and "/ 17.546" in text
    assert (experiment / "figure_median_upper.png").stat().st_size > 10000


def page_data(folder):
    text = (folder / "index.html").read_text()
    return text, json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.DOTALL).group(1))


def test_page_holds_the_tables_and_the_pictures(experiment):
    """One file that asks for nothing: what stands in the folder's tables, and every picture, byte by byte."""
    text, data = page_data(experiment)
    assert dict(data["settings"])["study"] == "tables" and dict(data["settings"])["methods"] == "bounding-box, paper, icp"
    held = {table["file"]: [table["header"], *table["rows"]] for table in data["tables"]}
    # Curves are drawn of these, and times are never the same.
    left_out = {"calibration.csv", "landmarks.csv", "times.csv"}
    assert set(held) == {path.name for path in experiment.glob("*.csv")} - left_out
    for name, table in held.items():
        with open(experiment / name, newline="") as file:
            assert table == list(csv.reader(file)), name
    pictures = {base64.b64decode(figure["uri"].split(",")[1]) for figure in data["figures"]}
    drawn = [*experiment.glob("figure_*.png"), *experiment.glob("plots/*.png")]
    assert pictures == {path.read_bytes() for path in drawn} and len(drawn) >= 4
    assert data["text"] == "tables.md" and (experiment / data["text"]).exists()
    head = text.split("<body>")[0]
    assert "default-src 'none'" in text and "http:" not in head and "https:" not in head


def test_page_shows_no_picture_of_other_cases(run, tmp_path):
    """One case with its pictures, then two without: the tables are of two, and so is the page."""
    options = ("experiment", "--methods", "bounding-box", "--output", tmp_path / "out")
    assert run(*options, "--cases", 1).returncode == 0
    assert len(page_data(tmp_path / "out")[1]["figures"]) >= 2
    assert run(*options, "--cases", 2, "--no-figures").returncode == 0
    _, data = page_data(tmp_path / "out")
    (cases,) = (table for table in data["tables"] if table["file"] == "cases.csv")
    assert len({row[0] for row in cases["rows"]}) == 2
    assert data["figures"] == []


def test_every_figure_follows_from_the_landmarks(experiment):
    landmarks = rows(experiment / "landmarks.csv")
    for row in rows(experiment / "table1_landmarks.csv"):
        errors = [
            float(each["error_px"])
            for each in landmarks
            if each["jaw"] == row["jaw"] and each["method"] == row["method"]
        ]
        assert len(errors) == int(row["landmarks"])
        assert float(row["mean_px"]) == pytest.approx(sum(errors) / len(errors), abs=1e-5)


def test_same_bits_for_one_thread(run, experiment, tmp_path):
    done = run("--threads", 1, "experiment", "--cases", 2, "--seed", 3, *FAST, "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert tables(tmp_path / "out") == tables(experiment)


def test_case_is_that_of_phantom_and_register(run, experiment, tmp_path):
    assert run("phantom", "--seed", 4, "--output", tmp_path / "case").returncode == 0
    done = run("register", tmp_path / "case" / "case.json", "--output", tmp_path / "out", "--preset", "paper")
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    for row in rows(experiment / "cases.csv"):
        if row["case"] == "typical-0004" and row["method"] == "paper":
            # Files round the tracing to 0.001 px, and the optimizer feels it.
            assert float(row["mean_px"]) == pytest.approx(result["jaws"][row["jaw"]]["error"]["mean_px"], abs=0.5)


def test_runs_on_annotated_cases(run, sample, tmp_path):
    for name in ("one", "two"):
        shutil.copytree(sample, tmp_path / "cases" / name)
    (tmp_path / "cases" / "broken").mkdir()
    (tmp_path / "cases" / "broken" / "case.json").write_text("{")
    done = run("experiment", "--from", tmp_path / "cases", *FAST, "--no-figures", "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert {row["case"] for row in rows(tmp_path / "out" / "cases.csv")} == {"one", "two"}
    failures = rows(tmp_path / "out" / "failures.csv")
    assert any(row["case"] == "broken" and row["what"] == "unusable case" for row in failures)


def test_nothing_to_measure_with_is_said(run, case, tmp_path):
    content = case.load()
    content.pop("landmarks_2d")
    case.save(content)
    done = run("experiment", "--from", case.folder, *FAST, "--no-figures", "--output", tmp_path / "out")
    assert done.returncode == 2
    assert "landmarks_2d" in done.stderr and done.stderr.count("\n") == 1
    assert not (tmp_path / "out" / "tables.md").exists()


@pytest.mark.parametrize(
    "arguments, word",
    [
        (["--cases", "0"], "--cases"),
        (["--methods", "magic"], "magic"),
        (["--level", "absurd"], "--level"),
        (["--study", "everything"], "--study"),
        (["--from", "/nowhere"], "/nowhere"),
        (["--from", "/nowhere", "--cases", "3"], "--cases"),
        (["--study", "capture", "--methods", "bounding-box"], "bounding-box"),
        (["--study", "sensitivity", "--from", "/nowhere"], "--from"),
        (["--study", "coverage", "--methods", "paper"], "--methods"),
        (["--study", "ablation", "--level", "hard"], "--level"),
        (["--study", "practice", "--level", "standard"], "--level"),
        (["--from", "/nowhere", "--parameters", __file__], "--parameters"),
        (["--parameters", "/nowhere.json"], "/nowhere.json"),
        (["--parameters", __file__], "test_experiment.py"),
    ],
)
def test_bad_options_are_one_line(run, tmp_path, arguments, word):
    done = run("experiment", *arguments, "--output", tmp_path / "out")
    assert done.returncode == 2
    assert word in done.stderr and done.stderr.count("\n") == 1
    assert not (tmp_path / "out").exists()


def test_draws_cohorts_of_any_parameters(run, tmp_path):
    """The same cases as `phantom --parameters` makes, kept in the experiment's settings, and no other ones in its folder."""
    mine = tmp_path / "mine.json"
    mine.write_text(
        '{"level": "real", "traits": {"third_molar_probability": 1},'
        ' "scan": {"triangles": 12000, "decimate_to": 0, "frame": "shared"}}'
    )
    command = ("experiment", "--parameters", mine, "--cases", 1, "--seed", 7, "--methods", "bounding-box", "--no-figures")
    done = run(*command, "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    settings = json.loads((tmp_path / "out" / "experiment.json").read_text())
    assert settings["level"] == "real" and settings["parameters"]["traits"]["third_molar_probability"] == 1
    assert settings["parameters"]["traits"]["wear_probability"] == 0.15
    assert "level real, parameters of its own" in (tmp_path / "out" / "tables.md").read_text()
    assert run("phantom", "--parameters", mine, "--seed", 7, "--no-radiograph", "--output", tmp_path / "case").returncode == 0
    done = run("register", tmp_path / "case" / "case.json", "--preset", "bounding-box", "--output", tmp_path / "result")
    assert done.returncode in (0, 1), done.stderr
    result = json.loads((tmp_path / "result" / "result.json").read_text())
    for row in rows(tmp_path / "out" / "cases.csv"):
        assert row["case"] == "real-0007"
        assert float(row["mean_px"]) == pytest.approx(result["jaws"][row["jaw"]]["error"]["mean_px"], abs=0.05)

    # Neither other parameters nor the level's own go on in that folder.
    before = tables(tmp_path / "out")
    mine.write_text(mine.read_text().replace('"third_molar_probability": 1', '"third_molar_probability": 0'))
    for options in (command, ("experiment", "--level", "real", *command[3:])):
        done = run(*options, "--output", tmp_path / "out")
        assert done.returncode == 2 and "parameters" in done.stderr and done.stderr.count("\n") == 1
    assert tables(tmp_path / "out") == before

    # What such cases can't have is said, and so is a study with levels of its own.
    mine.write_text('{"frontal": {"given": true}}')
    for options, words in (((), ("frontal.given", "--from")), (("--study", "coverage"), ("--parameters", "coverage"))):
        done = run("experiment", "--parameters", mine, *options, "--output", tmp_path / "other")
        assert done.returncode == 2 and done.stderr.count("\n") == 1
        assert all(word in done.stderr for word in words), done.stderr


def test_unwritable_folder_is_named(run, tmp_path):
    (tmp_path / "file").write_text("x")
    for folder in (tmp_path / "file", tmp_path / "file" / "below"):
        done = run("experiment", "--cases", 1, *FAST, "--output", folder)
        assert done.returncode == 2
        assert str(folder) in done.stderr and done.stderr.count("\n") == 1


def test_folder_of_another_experiment_is_refused(run, experiment):
    before = tables(experiment)
    done = run("experiment", "--cases", 2, "--seed", 4, *FAST, "--output", experiment)
    assert done.returncode == 2
    assert "seed" in done.stderr and "experiment.json" in done.stderr
    assert tables(experiment) == before


def test_interrupted_run_resumes(program, run, tmp_path):
    folder = tmp_path / "out"
    command = [str(program), "--threads", "1", "experiment", "--cases", "12", *FAST, "--no-figures", "--output", str(folder)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    for _ in range(600):
        if (folder / "cases").is_dir() and any((folder / "cases").glob("*.json")):
            break
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 2
    assert "goes on" in errors and errors.count("\n") == 1
    assert not (folder / "tables.md").exists()
    assert 0 < len(list((folder / "cases").iterdir())) < 12
    done = run(*command[1:])
    assert done.returncode == 0, done.stderr
    assert "there already" in done.stdout
    assert len(rows(folder / "cases.csv")) == 12 * 2 * 3


def test_study_of_the_sensitivity_has_every_factor(run, tmp_path):
    done = run(
        "experiment", "--study", "sensitivity", "--cases", 1, "--methods", "bounding-box", "--no-figures", "--output", tmp_path
    )
    assert done.returncode == 0, done.stderr
    table = rows(tmp_path / "sensitivity.csv")
    factors = {row["factor"] for row in table}
    for word in ("noise", "drop-out", "source", "spacing", "yaw", "roll", "missing", "trimmed"):
        assert any(word in factor for factor in factors), word
    assert (tmp_path / "sensitivity.md").read_text().count("## ") == len(factors)


def test_edited_case_is_run_again(run, sample, tmp_path):
    for name in ("one", "two"):
        shutil.copytree(sample, tmp_path / "cases" / name)
    command = ("experiment", "--from", tmp_path / "cases", *FAST, "--no-figures", "--output", tmp_path / "out")
    assert run(*command).returncode == 0
    before = rows(tmp_path / "out" / "cases.csv")
    # Not the case file itself: a file that it names.
    marked = tmp_path / "cases" / "two" / "landmarks2d.json"
    content = {name: [u + 5.0, v] for name, (u, v) in json.loads(marked.read_text()).items()}
    marked.write_text(json.dumps(content))
    done = run(*command)
    assert done.returncode == 0, done.stderr
    assert "1 cases were there already" in done.stdout
    changed = {a["case"] for a, b in zip(before, rows(tmp_path / "out" / "cases.csv")) if a != b}
    assert changed == {"two"}


def test_cases_without_landmarks_are_listed(run, sample, tmp_path):
    for name in ("good", "bare", "half"):
        shutil.copytree(sample, tmp_path / "cases" / name)
    case = tmp_path / "cases" / "bare" / "case.json"
    content = json.loads(case.read_text())
    content.pop("landmarks_3d")
    case.write_text(json.dumps(content))
    marked = tmp_path / "cases" / "half" / "landmarks2d.json"
    content = {name: place for name, place in json.loads(marked.read_text()).items() if name.startswith("U")}
    marked.write_text(json.dumps(content))
    done = run("experiment", "--from", tmp_path / "cases", *FAST, "--no-figures", "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    failures = rows(tmp_path / "out" / "failures.csv")
    assert any(row["case"] == "bare" and "landmarks_3d" in row["reason"] for row in failures)
    half = [row for row in failures if row["case"] == "half" and row["what"] == "no error known"]
    assert [row["jaw"] for row in half] == ["lower"]


def test_folder_and_subfolder_of_one_name_are_two_cases(run, sample, tmp_path):
    shutil.copytree(sample, tmp_path / "same")
    shutil.copytree(sample, tmp_path / "same" / "same")
    done = run("experiment", "--from", tmp_path / "same", *FAST, "--no-figures", "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert {row["case"] for row in rows(tmp_path / "out" / "cases.csv")} == {"same", "same-2"}
    assert len(list((tmp_path / "out" / "cases").iterdir())) == 2


def test_study_of_the_capture_range_survives_a_broken_case(run, sample, tmp_path):
    shutil.copytree(sample, tmp_path / "cases" / "good")
    (tmp_path / "cases" / "broken").mkdir()
    (tmp_path / "cases" / "broken" / "case.json").write_text("{")
    arguments = ("--study", "capture", "--starts", 10, "--methods", "bounding-box,icp-rigid,parallel", "--no-figures")
    done = run("experiment", "--from", tmp_path / "cases", *arguments, "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    ranges = rows(tmp_path / "out" / "capture_range.csv")
    # Ten starts a jaw; the bounding box is none that starts.
    assert {(row["method"], row["starts"]) for row in ranges} == {("icp-rigid", "20"), ("parallel", "20")}
    assert "* broken: " in (tmp_path / "out" / "capture.md").read_text()


def test_study_of_the_coverage_has_every_kind_of_case(run, tmp_path):
    done = run("experiment", "--study", "coverage", "--cases", 14, "--no-figures", "--output", tmp_path)
    assert done.returncode == 0, done.stderr
    cohorts = rows(tmp_path / "cohorts.csv")
    assert len(cohorts) == 2 * 14
    coverage = {row["stratum"]: row for row in rows(tmp_path / "coverage.csv")}
    assert int(coverage["all"]["cases"]) == 14
    assert {row["cohort"] for row in cohorts} < set(coverage)
    # 16 landmarks a case, both sides' in one.
    assert int(coverage["all"]["landmarks"]) == 15 * 16
    assert all(0.5 < float(row["coverage_95"]) <= 1.0 for row in coverage.values())


def test_study_of_the_practice_has_every_kind_of_input(run, tmp_path):
    done = run("experiment", "--study", "practice", "--cases", 1, "--no-figures", "--output", tmp_path)
    assert done.returncode == 0, done.stderr
    table = rows(tmp_path / "practice.csv")
    # One case is reported, none is left to set limits by.
    report = {(row["level"], row["input"]): row for row in table if row["part"] == "report"}
    assert len(table) == 2 * len(report) == 2 * 2 * 5
    assert all(row["jaws"] == "0" for row in table if row["part"] == "calibration")
    for (level, name), row in report.items():
        assert row["jaws"] == "2", (level, name)
        if "landmarks" in name:
            # The middles are measured whether or not the case was given landmarks of the scan.
            assert row["registered"] == "2", (level, name)
            # Eight pairs a jaw of regular arches; real ones lack teeth or have more.
            assert int(row["middles"]) == 16 if level == "standard" else int(row["middles"]) >= 8, (level, name)
            assert 0.0 < float(row["mean_px"]) <= float(row["worst_px"]), (level, name)
    assert "1.83 / 4.2" in (tmp_path / "practice.md").read_text()


def test_study_of_the_verdict_finds_what_is_wrong(run, tmp_path):
    done = run("experiment", "--study", "verdict", "--cases", 1, "--no-figures", "--output", tmp_path)
    assert done.returncode == 0, done.stderr
    inputs = {row["input"]: row for row in rows(tmp_path / "verdict_inputs.csv") if row["jaws"] != "0"}
    for word in ("scans exchanged", "facing", "cm", "mirrored", "other side", "spacing", "incisors", "another patient"):
        assert any(word in name for name in inputs), word
    assert inputs["wrong facing"]["ok"] == "0" and inputs["scans exchanged"]["ok"] == "0"
    assert inputs["nothing: cases of every kind"]["ok"] == "2"


def test_study_of_the_ablation_switches_every_ingredient(run, tmp_path):
    done = run("experiment", "--study", "ablation", "--cases", 1, "--no-figures", "--output", tmp_path)
    assert done.returncode == 0, done.stderr
    table = rows(tmp_path / "ablation.csv")
    means = {(row["variant"], row["level"], row["jaw"]): row["mean_px"] for row in table}
    variants = {row["variant"] for row in table}
    assert "robust" in variants and len(means) == 4 * len(variants)
    for variant in variants - {"robust"}:
        row = next(row for row in table if row["variant"] == variant)
        # Options, or the calls that exchange a part.
        assert "=" in row["options"] or "()" in row["options"]
    assert means["no-side-selection", "typical", "upper"] != means["robust", "typical", "upper"]


def test_study_of_the_views_measures_each_degree_of_freedom(run, tmp_path):
    done = run("experiment", "--study", "views", "--cases", 2, "--no-figures", "--output", tmp_path)
    assert done.returncode == 0, done.stderr
    table = {(row["variant"], row["freedom"]): row for row in rows(tmp_path / "views.csv")}
    assert len(table) == 10 * 6
    assert all(row["jaws"] == "4" for row in table.values())
    # What is predicted of what a lateral radiograph does not see shrinks with a frontal one.
    for freedom in ("roll_deg", "yaw_deg", "y_mm"):
        alone = float(table["lateral radiograph alone", freedom]["rms_sigma"])
        assert float(table["landmarks and tracing", freedom]["rms_sigma"]) < 0.9 * alone, freedom
    assert "Dai 2022" in (tmp_path / "views.md").read_text()
