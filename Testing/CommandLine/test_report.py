"""The page that a result is judged by: what register and report write, and what they leave out."""
import base64
import json
import re
import shutil

import pytest

from dicom_file import dicom


@pytest.fixture(scope="module")
def result(run, sample, tmp_path_factory):
    folder = tmp_path_factory.mktemp("report") / "result"
    done = run("register", sample / "case.json", "--output", folder)
    assert done.returncode == 0, done.stderr
    return folder


def data_of(page):
    found = re.search(r'<script type="application/json" id="report-data">(.*?)</script>', page, re.S)
    return json.loads(found.group(1))


def test_register_writes_one_page_with_everything_in_it(result):
    page = (result / "report.html").read_text()
    assert len(page) < 5_000_000
    assert "data:image/jpeg;base64," in page
    # Nothing that a browser would fetch: no script, style, picture or frame by an address.
    outside = re.sub(r'<script type="module">.*?</script>', "", page, flags=re.S)
    assert not re.search(r'(src|href)="(?!#|data:)', outside)
    data = data_of(page)
    assert data["result"] == json.loads((result / "result.json").read_text())
    assert data["details"] == json.loads((result / "report.json").read_text())
    assert set(data["scans"]) == {"upper", "lower"}


def test_numbers_on_the_page_are_those_of_the_result(result):
    page = (result / "report.html").read_text()
    found = json.loads((result / "result.json").read_text())
    for jaw in found["jaws"].values():
        for tooth in jaw["residuals_px"]:
            assert f'data-tooth="{tooth["tooth"]}"' in page
            assert f'<td class="number">{tooth["rms"]:.2f}</td>' in page
        for name, (u, v) in jaw["landmarks_px"].items():
            row = re.search(rf'<tr><th scope="row">{name}</th>.*?</tr>', page).group()
            assert f">{u:.1f}<" in row and f">{v:.1f}<" in row
            assert f'>{jaw["landmark_sigma_px"][name]:.2f}<' in row
            if name in jaw["error"]["landmarks"]:
                assert f'>{jaw["error"]["landmarks"][name]:.2f}<' in row


def test_result_says_what_each_stage_did(result):
    found = json.loads((result / "result.json").read_text())
    details = json.loads((result / "report.json").read_text())
    jaw = found["jaws"]["upper"]
    stages = [stage["stage"] for stage in jaw["course"]]
    assert stages == ["start", "candidates", "refinement"] == [stage["stage"] for stage in jaw["stages"]]
    for stage, single in zip(jaw["course"], details["course"][0]["stages"]):
        steps = [step for candidate in single["candidates"] for step in candidate["accepted"]]
        assert stage["steps"] == len(steps) and stage["accepted"] == sum(steps) > 0
        assert stage["candidates"] == len(single["candidates"])
        assert sum(candidate["chosen"] for candidate in single["candidates"]) == 1
    assert jaw["course"][-1]["stop"]
    # The stages come nearer: how far a landmark was from where it ended.
    name, point = next(iter(json.loads((result / "result.json").read_text())["jaws"]["upper"]["landmarks_px"].items()))
    assert name and len(point) == 2
    distances = []
    scan = details["views"][0]["jaws"]["upper"]["outline_3d"]
    for projection in [stage["projection_3x4"] for stage in jaw["stages"]] + [jaw["projection_3x4"]]:
        places = []
        for x in scan[:: max(1, len(scan) // 20)]:
            q = [sum(row[i] * value for i, value in enumerate([*x, 1])) for row in projection]
            places.append((q[0] / q[2], q[1] / q[2]))
        distances.append(places)
    far = [
        sum(abs(a[0] - b[0]) + abs(a[1] - b[1]) for a, b in zip(stage, distances[-1])) / len(stage) for stage in distances
    ]
    assert far[0] > far[2] >= 0 == far[3]


def test_residuals_are_the_distances_of_the_points(result):
    found = json.loads((result / "result.json").read_text())
    details = json.loads((result / "report.json").read_text())
    for name, jaw in found["jaws"].items():
        drawn = details["views"][0]["jaws"][name]["tracing"]
        for tooth in jaw["residuals_px"]:
            distances = [
                distance
                for stretch in drawn
                if stretch["tooth"] == tooth["tooth"]
                for distance in stretch["distance_px"]
                if distance is not None
            ]
            assert len(distances) == tooth["points"]
            assert sum(distances) / len(distances) == pytest.approx(tooth["mean"], abs=1e-3)
            assert max(distances) == pytest.approx(tooth["max"], abs=1e-3)


def test_page_says_how_the_program_was_called(result, sample):
    words = json.loads((result / "report.json").read_text())["command_line"]
    assert words == ["dentalscr", "register", str(sample / "case.json"), "--output", str(result)]
    assert f"dentalscr register {sample / 'case.json'} --output {result}" in (result / "report.html").read_text()


def test_priors_say_how_far_each_pulls(result):
    for jaw in json.loads((result / "result.json").read_text())["jaws"].values():
        for prior in jaw["priors"].values():
            assert abs(prior["value"]) / prior["sigma"] == pytest.approx(prior["tension_sd"], rel=1e-9)
        assert max(prior["tension_sd"] for prior in jaw["priors"].values()) == pytest.approx(
            jaw["details"]["prior_tension_sd"]
        )


def test_errors_have_their_places(result):
    for jaw in json.loads((result / "result.json").read_text())["jaws"].values():
        for name, place in jaw["error"]["places_px"].items():
            (u, v), (a, b) = place["marked"], place["predicted"]
            assert ((u - a) ** 2 + (v - b) ** 2) ** 0.5 == pytest.approx(jaw["error"]["landmarks"][name])


def test_no_page_and_no_report_leave_out_what_they_say(run, sample, tmp_path):
    run("register", sample / "case.json", "--output", tmp_path / "out")
    assert (tmp_path / "out/report.html").exists()
    done = run("register", sample / "case.json", "--output", tmp_path / "out", "--no-page")
    assert done.returncode == 0, done.stderr
    # The page of the earlier run is not left beside another result.
    assert not (tmp_path / "out/report.html").exists()
    assert (tmp_path / "out/report.json").exists() and (tmp_path / "out/overlay_upper.png").exists()
    run("register", sample / "case.json", "--output", tmp_path / "out", "--no-report")
    names = {file.name for file in (tmp_path / "out").iterdir()}
    assert not {name for name in names if name.startswith(("report", "overlay")) or name.endswith("stl")}, names


def test_report_makes_the_page_again(run, result, tmp_path):
    done = run("report", result, "--output", tmp_path / "again.html")
    assert done.returncode == 0 and done.stderr == "", done.stderr
    first, again = (result / "report.html").read_text(), (tmp_path / "again.html").read_text()
    # Scans are read back from their files; all else is the same.
    first_data, again_data = data_of(first), data_of(again)
    assert first_data["result"] == again_data["result"] and first_data["details"] == again_data["details"]
    start = first.index("<main>")
    assert first[start : first.index("report-data")] == again[again.index("<main>") : again.index("report-data")]


def test_report_says_what_is_missing(run, case, tmp_path):
    run("register", case.file, "--output", tmp_path / "out", "--no-report")
    (case.folder / "ceph.png").unlink()
    done = run("report", tmp_path / "out" / "result.json")
    assert done.returncode == 0
    assert "no report.json" in done.stderr and "--image" in done.stderr
    assert "Nothing is drawn here" in (tmp_path / "out/report.html").read_text()


def test_report_of_something_else_is_told(run, tmp_path):
    (tmp_path / "result.json").write_text('{"schema": "other/1"}')
    done = run("report", tmp_path)
    assert done.returncode == 2 and "schema" in done.stderr and done.stderr.count("\n") == 1
    assert run("report", tmp_path / "nowhere").returncode == 2


def test_image_that_changed_is_told(run, case, sample, tmp_path):
    run("register", case.file, "--output", tmp_path / "out", "--no-page")
    image = (case.folder / "ceph.png").read_bytes()
    (case.folder / "ceph.png").write_bytes(image + b"\0")
    assert "has changed" in run("report", tmp_path / "out").stderr
    other = tmp_path / "film.png"
    other.write_bytes(image)
    assert run("report", tmp_path / "out", "--image", other).stderr == ""


@pytest.fixture(scope="module")
def patient(sample, tmp_path_factory):
    """A case whose names are those of a person, wherever one can stand; with a warning and a finding that name files."""
    folder = tmp_path_factory.mktemp("archive") / "Musterfrau_Erika_1964"
    shutil.copytree(sample, folder)
    case = json.loads((folder / "case.json").read_text())
    for field in ("upper", "lower", "contours", "landmarks_3d", "landmarks_2d"):
        new = "Musterfrau-" + case[field]
        (folder / case[field]).rename(folder / new)
        case[field] = new
    (folder / case["cephalogram"]["image"]).rename(folder / "Musterfrau-ceph.png")
    case["cephalogram"]["image"] = "Musterfrau-ceph.png"
    case["unknown_field"] = 1
    (folder / "Musterfrau.json").write_text(json.dumps(case))
    (folder / "case.json").unlink()
    return folder


def test_anonymous_names_nobody(run, patient, tmp_path):
    done = run("register", patient / "Musterfrau.json", "--output", tmp_path / "open")
    assert done.returncode == 0, done.stderr
    assert "Musterfrau" in (tmp_path / "open/report.html").read_text(), "the test looks for something that could be there"
    # The warning of the unknown field names the file.
    assert any("Musterfrau" in text for text in json.loads((tmp_path / "open/result.json").read_text())["warnings"])

    done = run("register", patient / "Musterfrau.json", "--output", tmp_path / "shared", "--anonymous")
    assert done.returncode == 0, done.stderr
    files = [file for file in (tmp_path / "shared").iterdir()]
    assert {file.name for file in files} == {file.name for file in (tmp_path / "open").iterdir()}
    for file in files:
        for word in (b"musterfrau", b"erika_1964", str(patient.parent).lower().encode()):
            assert word not in file.read_bytes().lower(), (file.name, word)
    found = json.loads((tmp_path / "shared/result.json").read_text())
    assert found["anonymous"] is True 
    assert "command_line" not in json.loads((tmp_path / "shared/report.json").read_text())
    assert all(set(entry) == {"sha256"} for entry in found["inputs"].values())
    assert any("unknown_field" in text for text in found["warnings"])
    # And the same numbers.
    named = json.loads((tmp_path / "open/result.json").read_text())
    assert found["jaws"]["upper"]["projection_3x4"] == named["jaws"]["upper"]["projection_3x4"]

    done = run("report", tmp_path / "open", "--anonymous", "--output", tmp_path / "page.html")
    assert done.returncode == 0 and done.stderr == "", done.stderr
    page = (tmp_path / "page.html").read_text().lower()
    assert "musterfrau" not in page and "erika_1964" not in page and str(patient.parent).lower() not in page


def test_identifiers_of_a_dicom_file_are_nowhere(run, case, tmp_path):
    width, height = case.load("contours.json")["image_size"]
    pixels = b"".join(bytes((u + v) % 256 for u in range(width)) for v in range(height))
    (case.folder / "film.dcm").write_bytes(dicom(height, width, pixels, patient=(b"Musterfrau^Erika", b"PAT-4711")))
    content = case.load()
    content["cephalogram"]["image"] = "film.dcm"
    case.save(content)
    done = run("register", case.file, "--output", tmp_path / "out", "--anonymous")
    assert done.returncode in (0, 1), done.stderr
    for file in (tmp_path / "out").iterdir():
        for word in (b"Musterfrau", b"PAT-4711"):
            assert word not in file.read_bytes(), (file.name, word)


def test_hostile_names_stay_text(run, sample, tmp_path):
    folder = tmp_path / "<script>alert(1)<" / 'a"b\'c&amp;'
    shutil.copytree(sample, folder)
    done = run("register", folder / "case.json", "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    page = (tmp_path / "out/report.html").read_text()
    assert "<script>alert" not in page
    assert page.count("</script>") == 2
    assert "a&quot;b&apos;c&amp;amp;" in page


def test_pictures_in_the_page_are_whole(result):
    page = (result / "report.html").read_text()
    picture = base64.b64decode(re.search(r"data:image/jpeg;base64,([^\"]+)", page).group(1))
    assert picture[:3] == b"\xff\xd8\xff" and picture[-2:] == b"\xff\xd9"


def test_paper_preset_has_a_page_of_its_own_stages(run, sample, tmp_path):
    done = run("register", sample / "case.json", "--output", tmp_path / "out", "--preset", "paper")
    assert done.returncode == 0, done.stderr
    found = json.loads((tmp_path / "out/result.json").read_text())["jaws"]["upper"]
    assert [stage["stage"] for stage in found["course"]] == [stage["stage"] for stage in found["stages"]]
    assert found["course"][0]["stage"] == "level 1" and found["course"][0]["stop"]
    assert 'data-layer="stage-level 1"' in (tmp_path / "out/report.html").read_text()


def test_batch_links_to_the_pages_that_are_there(run, sample, tmp_path):
    shutil.copytree(sample, tmp_path / "cases/one")
    done = run("batch", tmp_path / "cases", "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    rows = json.loads(
        re.search(r'id="data">(.*?)</script>', (tmp_path / "out/index.html").read_text(), re.S).group(1)
    )["rows"]
    assert rows and all(row["page"] for row in rows)
    assert (tmp_path / "out" / rows[0]["case"] / "report.html").exists()
