"""Whether the files of a case belong together: one thing of a right case is changed, and it is right all the same, or said."""
import hashlib
import json
import math
import struct

import matplotlib.image
import numpy
import pytest

from nifti_file import nifti
from png_file import png


def load(folder):
    return json.loads((folder / "result.json").read_text())


def codes_of(result, jaw):
    return {finding["code"] for finding in result["jaws"][jaw]["findings"]}


@pytest.fixture(scope="module")
def plain(run, sample, tmp_path_factory):
    folder = tmp_path_factory.mktemp("plain") / "out"
    done = run("register", sample / "case.json", "--output", folder, "--no-report")
    assert done.returncode == 0, done.stderr
    return folder


def read_stl(path):
    data = path.read_bytes()
    (count,) = struct.unpack_from("<I", data, 80)
    return [struct.unpack_from("<9f", data, 84 + 50 * i + 12) for i in range(count)]


def write_stl(path, triangles):
    body = b"".join(struct.pack("<3f9fH", 0.0, 0.0, 0.0, *triangle, 0) for triangle in triangles)
    path.write_bytes(b"\0" * 80 + struct.pack("<I", len(triangles)) + body)


def move_tracing(case, move):
    contours = case.load("contours.json")
    for jaw in contours["contours"].values():
        for tooth in jaw:
            tooth["points"] = [list(move(u, v)) for u, v in tooth["points"]]
    return contours


def test_findings_say_what_reasons_say(run, case, tmp_path):
    case.change(mesh_unit="cm")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode in (0, 1)
    for jaw in load(tmp_path / "out")["jaws"].values():
        assert [finding["text"] for finding in jaw["findings"]] == jaw["reasons"]
        (width,) = [finding for finding in jaw["findings"] if finding["code"] == "arch-width"]
        assert width["value"] > width["limit"] == 120.0 and width["unit"] == "mm"
        assert '"mesh_unit": "mm" would fit' in width["text"]
        worst = {"ok": 0, "suspect": 1, "failed": 2}
        assert worst[jaw["status"]] == max(worst[finding["severity"]] for finding in jaw["findings"])


def test_a_third_of_the_landmarks_at_the_origin_is_said(run, case, tmp_path):
    landmarks = case.load("landmarks3d.json")
    wrong = [name for i, name in enumerate(landmarks) if i % 3 == 0]
    case.save({name: [0.0, 0.0, 0.0] if name in wrong else place for name, place in landmarks.items()}, "landmarks3d.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    result = load(tmp_path / "out")
    for jaw in ("upper", "lower"):
        assert result["jaws"][jaw]["status"] == "suspect"
        assert codes_of(result, jaw) == {"landmarks-coincide"}
        (finding,) = result["jaws"][jaw]["findings"]
        assert any(name in finding["text"] for name in wrong)
        # What is none of the scan measures no error.
        assert not set(result["jaws"][jaw]["error"]["landmarks"]) & set(wrong)
        assert result["jaws"][jaw]["error"]["mean_px"] < 5.0


def test_two_landmarks_of_the_scan_exchanged_are_said_and_not_used(run, case, tmp_path):
    """On the scan and on their side, each at the other's tooth."""
    landmarks = case.load("landmarks3d.json")
    landmarks["UR6_MB"], landmarks["UR4_B"] = landmarks["UR4_B"], landmarks["UR6_MB"]
    case.save(landmarks, "landmarks3d.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    result = load(tmp_path / "out")
    assert codes_of(result, "upper") == {"landmarks-order"} and codes_of(result, "lower") == set()
    (finding,) = result["jaws"]["upper"]["findings"]
    assert "UR4_B, UR6_MB do not stand along the arch" in finding["text"] and finding["text"] in done.stderr
    assert not set(result["jaws"]["upper"]["error"]["landmarks"]) & {"UR6_MB", "UR4_B"}
    assert "UR5_B" in result["jaws"]["upper"]["error"]["landmarks"]
    assert result["jaws"]["upper"]["error"]["mean_px"] < 5.0


def test_a_tooth_marked_as_the_one_before_it_is_told_by_the_tracing(run, case, plain, tmp_path):
    """In order along the arch, and without the other side there is no step to compare: the tracing has the tooth elsewhere."""
    landmarks = {name: place for name, place in case.load("landmarks3d.json").items() if name[1] == "R"}
    shift = [b - a for a, b in zip(landmarks["UR6_MB"], landmarks["UR7_MB"], strict=True)]
    for name in ("UR6_MB", "UR6_DB"):
        landmarks[name] = [a + b for a, b in zip(landmarks[name], shift, strict=True)]
    case.save({name: place for name, place in landmarks.items() if not name.startswith("UR7")}, "landmarks3d.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    said = [line for line in load(tmp_path / "out")["warnings"] if line.startswith("landmarks_3d: ")]
    assert len(said) == 1 and said[0] in done.stderr, said
    assert "the result puts UR6_MB" in said[0] and "UR5" not in said[0] and "LR" not in said[0]
    assert not any(line.startswith("landmarks_3d: ") for line in load(plain)["warnings"])


@pytest.mark.parametrize("name", ["upper", "lower"])
@pytest.mark.parametrize(("factor", "words"), [(None, "is it in mm? Give pixels"), (0.5, "on a copy of the radiograph")])
def test_one_jaw_drawn_on_another_copy_is_named(run, case, plain, tmp_path, name, factor, words):
    """Both jaws fail, and what the fit says of it is of the wrong place."""
    contours = case.load("contours.json")
    factor = factor or case.load()["cephalogram"]["pixel_spacing_mm"][0]
    for tooth in contours["contours"][name]:
        tooth["points"] = [[factor * u, factor * v] for u, v in tooth["points"]]
    case.save(contours, "contours.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    said = [line for line in load(tmp_path / "out")["warnings"] if line.startswith("contours: what was drawn of")]
    assert len(said) == 1 and said[0] in done.stderr, done.stderr
    assert f"of the {name} jaw is 0." in said[0] and words in said[0], said
    assert not any(line.startswith("contours: what was drawn of") for line in load(plain)["warnings"])


def test_inches(run, case, plain, tmp_path):
    for name in ("upper", "lower"):
        triangles = read_stl(case.folder / f"{name}.stl")
        write_stl(case.folder / f"{name}.stl", [[x / 25.4 for x in triangle] for triangle in triangles])
    landmarks = case.load("landmarks3d.json")
    case.save({name: [x / 25.4 for x in place] for name, place in landmarks.items()}, "landmarks3d.json")
    done = run("register", case.file, "--output", tmp_path / "mm", "--no-report")
    assert '"mesh_unit": "inch" would fit' in done.stderr
    case.change(mesh_unit="inch")
    done = run("register", case.file, "--output", tmp_path / "inch", "--no-report")
    assert done.returncode == 0, done.stderr
    for name, jaw in load(tmp_path / "inch")["jaws"].items():
        before = load(plain)["jaws"][name]
        assert jaw["status"] == before["status"]
        for landmark, (u, v) in jaw["landmarks_px"].items():
            assert math.hypot(u - before["landmarks_px"][landmark][0], v - before["landmarks_px"][landmark][1]) < 0.2


def test_millimetres_said_to_be_inches_fail_with_a_word(run, case, tmp_path):
    case.change(mesh_unit="inch")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 1, done.stderr
    for jaw in load(tmp_path / "out")["jaws"].values():
        assert jaw["status"] == "failed"
        # Before what comes of it: no arch is recognised in a scan of three metres.
        width = jaw["findings"][0]
        assert width["code"] == "arch-width" and '"mesh_unit": "mm" would fit' in width["text"], jaw["findings"]
        assert width["text"] == jaw["reasons"][0]
    assert done.stderr.index("would fit") < done.stderr.index("no recognisable dental arch")


def test_a_speck_far_away_is_not_the_scan(run, case, plain, tmp_path):
    for name in ("upper", "lower"):
        triangles = read_stl(case.folder / f"{name}.stl")
        write_stl(case.folder / f"{name}.stl", [*triangles, (200.0, 200.0, 200.0, 201.0, 200.0, 200.0, 200.0, 201.0, 200.0)])
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    for name, jaw in load(tmp_path / "out")["jaws"].items():
        assert jaw["status"] == load(plain)["jaws"][name]["status"], jaw["reasons"]


@pytest.mark.parametrize("factor", [4.0, 2.0, 0.5])
def test_a_wrong_spacing_is_told_with_the_right_one(run, case, tmp_path, factor):
    content = case.load()
    right = content["cephalogram"]["pixel_spacing_mm"][0]
    content["cephalogram"]["pixel_spacing_mm"] = [right * factor, right * factor]
    case.save(content)
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 1
    for jaw in load(tmp_path / "out")["jaws"].values():
        finding = jaw["findings"][0]
        assert [each["code"] for each in jaw["findings"]].count("pixel-spacing") == 1
        assert finding["code"] == "pixel-spacing" and jaw["reasons"][0] == finding["text"]
        assert "jaws-exchanged" not in [each["code"] for each in jaw["findings"]]
        assert finding["value"] == pytest.approx(right, rel=0.03)
        assert finding["limit"] == pytest.approx(right * factor)


@pytest.mark.parametrize("seed", [91101, 91105, 91106])
def test_a_spacing_that_is_a_quarter_too_small_is_told(run, tmp_path, seed):
    """Worn and crowded teeth: with the molars on the teeth before their own both jaws were ok, 4 to 6 px off."""
    (tmp_path / "mine.json").write_text(json.dumps({"scan": {"triangles": 20000, "decimate_to": 0}}))
    made = run("phantom", "--level", "real", "--parameters", tmp_path / "mine.json", "--frame", "shared", "--seed", seed,
               "--no-radiograph", "--output", tmp_path / "case")
    assert made.returncode == 0, made.stderr
    path = tmp_path / "case" / "case.json"
    content = json.loads(path.read_text())
    for name in ("landmarks_2d", "landmarks_3d"):
        content.pop(name)
    right = content["cephalogram"]["pixel_spacing_mm"]
    for factor in (1.0, 0.77):
        content["cephalogram"]["pixel_spacing_mm"] = [factor * s for s in right]
        path.write_text(json.dumps(content))
        assert run("register", path, "--output", tmp_path / f"{factor}", "--no-report").returncode in (0, 1)
    for jaw in ("upper", "lower"):
        assert codes_of(load(tmp_path / "1.0"), jaw) == set()
        assert "pixel-spacing" in codes_of(load(tmp_path / "0.77"), jaw)


@pytest.mark.parametrize(("millimetres", "unit"), [(10.0, "cm"), (25.4, "inches")])
def test_a_spacing_in_another_unit_is_told(run, case, tmp_path, millimetres, unit):
    content = case.load()
    content["cephalogram"]["pixel_spacing_mm"] = [s / millimetres for s in content["cephalogram"]["pixel_spacing_mm"]]
    case.save(content)
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 1 and f"mm were pixel_spacing_mm in {unit}" in done.stderr
    assert "expected error" not in done.stdout
    # What explains the others is read first.
    for jaw in load(tmp_path / "out")["jaws"].values():
        assert jaw["findings"][0]["code"] in ("film-size", "pixel-spacing"), jaw["reasons"]


def test_a_tracing_of_a_smaller_copy_is_told(run, case, tmp_path):
    """Neither spacing nor picture: the radiograph would be twice as long as any."""
    content = case.load()
    content["cephalogram"].pop("pixel_spacing_mm")
    content["cephalogram"].pop("image")
    content["geometry"].pop("principal_point_px")
    case.save(content)
    case.save(move_tracing(case, lambda u, v: (0.5 * u, 0.5 * v)), "contours.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 1
    result = load(tmp_path / "out")
    for jaw in ("upper", "lower"):
        assert "film-size" in codes_of(result, jaw)


def change_picture(case, change):
    """The picture alone becomes another one; what was drawn stays what it was."""
    file = case.folder / "ceph.png"
    rows = numpy.rint(255.0 * matplotlib.image.imread(file)).astype(numpy.uint8)
    file.write_bytes(png(change(rows)))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda rows: rows[::-1, ::-1], "turned by 180 degrees"),
        (lambda rows: rows[:, ::-1], "left and right exchanged"),
        (lambda rows: rows[::-1], "above and below exchanged"),
    ],
)
def test_a_picture_that_was_turned_alone_is_told(run, case, plain, tmp_path, change, words):
    assert not any("one that was drawn on" in line for line in load(plain)["not_checkable"])
    change_picture(case, change)
    run("register", case.file, "--output", tmp_path / "out", "--no-report")
    for name, jaw in load(tmp_path / "out")["jaws"].items():
        finding = jaw["findings"][0]
        assert finding["code"] == "picture" and words in finding["text"], jaw["reasons"]
        assert jaw["status"] == "suspect"
        # The drawing is where it was.
        assert jaw["landmarks_px"] == load(plain)["jaws"][name]["landmarks_px"]


def test_a_picture_without_edges_tells_nothing_and_it_is_said(run, case, tmp_path):
    change_picture(case, lambda rows: 0 * rows + 90)
    run("register", case.file, "--output", tmp_path / "flat", "--no-report")
    lines = load(tmp_path / "flat")["not_checkable"]
    assert any("no edges under the drawing" in line for line in lines), lines
    content = case.load()
    content["cephalogram"].pop("image")
    case.save(content)
    run("register", case.file, "--output", tmp_path / "none", "--no-report")
    assert any("there is no picture of it" in line for line in load(tmp_path / "none")["not_checkable"])


@pytest.mark.parametrize(
    ("size", "words"),
    [
        (lambda w, h: [h, w], "turned by 90 degrees"),
        (lambda w, h: [w * 2, h * 2], "a copy 2 times as large"),
        (lambda w, h: [w // 2, h // 2], "a copy 0.499 times as large"),
        (lambda w, h: [w + 50, h], "trace on this image"),
    ],
)
def test_another_size_says_what_may_have_become_of_the_picture(run, case, tmp_path, size, words):
    contours = case.load("contours.json")
    contours["image_size"] = size(*contours["image_size"])
    case.save(contours, "contours.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 2 and words in done.stderr, done.stderr


def test_a_turned_radiograph_is_told(run, case, tmp_path):
    content = case.load()
    content["cephalogram"].pop("image")
    case.save(content)
    width, height = case.load("contours.json")["image_size"]
    contours = move_tracing(case, lambda u, v: (v, width - 1 - u))
    contours["image_size"] = [height, width]
    case.save(contours, "contours.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 1
    for jaw in load(tmp_path / "out")["jaws"].values():
        finding = jaw["findings"][0]
        assert finding["code"] == "turned-image" and "turned by 90 degrees" in finding["text"]


@pytest.mark.parametrize("mirror", ["height", "middle"])
@pytest.mark.parametrize("spacing", [True, False], ids=["spacing", "no-spacing"])
def test_a_drawing_whose_rows_were_counted_from_below_is_told(run, case, tmp_path, mirror, spacing):
    content = case.load()
    content["cephalogram"].pop("image")
    if not spacing:
        content["cephalogram"].pop("pixel_spacing_mm")
    case.save(content)
    contours = case.load("contours.json")
    places = [v for jaw in contours["contours"].values() for tooth in jaw for _, v in tooth["points"]]
    foot = contours["image_size"][1] if mirror == "height" else min(places) + max(places)
    case.save(move_tracing(case, lambda u, v: (u, foot - v)), "contours.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 1
    for jaw in load(tmp_path / "out")["jaws"].values():
        finding = jaw["findings"][0]
        assert finding["code"] == "upward-drawing" and "count v from its top" in finding["text"], jaw["reasons"]


@pytest.mark.parametrize(("detector", "midsagittal"), [(1500.0, 1350.0), (1530.0, 1380.0), (1700.0, 1524.0)])
def test_a_detectors_distance_alone_takes_the_head_with_it(run, case, tmp_path, detector, midsagittal):
    content = case.load()
    content["geometry"].pop("source_to_midsagittal_mm", None)
    content["geometry"]["source_to_detector_mm"] = detector
    case.save(content)
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    geometry = load(tmp_path / "out")["geometry"]
    assert geometry["source_to_midsagittal_mm"] == {"value": midsagittal, "source": "default"}
    assert ("150 mm before the detector" in done.stderr) == (midsagittal != 1524.0)


def both_sides(case):
    """The tracing with every posterior tooth drawn of the other side as well, some pixels away, as magnification has it."""
    contours = case.load("contours.json")
    for jaw in contours["contours"].values():
        for tooth in list(jaw):
            if int(tooth["code"][2]) > 2:
                other = tooth["code"][0] + "L" + tooth["code"][2]
                jaw.append({"code": other, "points": [[u - 12.0, v + 6.0] for u, v in tooth["points"]]})
    return contours


def test_teeth_of_the_other_side_do_not_pull(run, case, plain, tmp_path):
    case.change(traced_side="right")
    case.save(both_sides(case), "contours.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    assert "UL6" in done.stderr and "left out" in done.stderr
    for name, jaw in load(tmp_path / "out")["jaws"].items():
        assert jaw["landmarks_px"] == load(plain)["jaws"][name]["landmarks_px"]


def test_both_sides_are_both_where_nobody_says(run, case, tmp_path):
    content = case.load()
    content.pop("traced_side", None)
    case.save(content)
    case.save(both_sides(case), "contours.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert 'taken as "both"' in done.stderr
    assert load(tmp_path / "out")["traced_side"] == "both"


@pytest.mark.parametrize(
    ("place", "code"),
    [
        (lambda u, v, s: (u / 2, v / 2), "pixel-spacing"),
        (lambda u, v, s: (u * s, v * s), "landmarks-mm"),
    ],
)
def test_landmarks_of_another_copy_are_told_as_such(run, standard_case, tmp_path, place, code):
    case = standard_case
    spacing = case.load()["cephalogram"]["pixel_spacing_mm"][0]
    case.save({name: place(u, v, spacing) for name, (u, v) in case.load("cephalometric.json").items()}, "cephalometric.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 1
    for jaw in load(tmp_path / "out")["jaws"].values():
        finding = jaw["findings"][0]
        assert finding["code"] == code, jaw["reasons"]
        if code == "pixel-spacing":
            assert "a copy of the radiograph 0.5" in finding["text"] and finding["value"] == pytest.approx(2 * spacing, rel=0.05)


def test_landmarks_in_per_cent_are_asked_for(run, standard_case, tmp_path):
    case = standard_case
    height, width = matplotlib.image.imread(case.folder / "ceph.png").shape[:2]
    places = case.load("cephalometric.json")
    case.save({name: [100.0 * u / width, 100.0 * v / height] for name, (u, v) in places.items()}, "cephalometric.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 1
    assert any("are they per cent of the picture's size" in line for line in load(tmp_path / "out")["warnings"]), done.stderr


def test_a_molar_marked_at_its_other_end_is_no_other_spacing(run, standard_case, tmp_path):
    """The mesial cusps called mesial contacts: all distances from the incisors are a tenth too short, as at another scale."""
    case = standard_case
    names = {"U6_MB": "Ms", "L6_MB": "Mi"}
    case.save({names.get(name, name): place for name, place in case.load("cephalometric.json").items()}, "cephalometric.json")
    run("register", case.file, "--output", tmp_path / "out", "--no-report")
    result = load(tmp_path / "out")
    for jaw in ("upper", "lower"):
        assert "pixel-spacing" not in codes_of(result, jaw)


def test_a_quadrant_is_no_exchange_of_the_scans(run, case, tmp_path):
    """In occlusion the landmarks of the half that is missing lie near to the other jaw."""
    landmarks = case.load("landmarks3d.json")
    right, left = landmarks["UR6_MB"], landmarks["UL6_MB"]
    middle = [(a + b) / 2 for a, b in zip(right, left)]
    to_right = [a - b for a, b in zip(right, left)]
    inside = [
        triangle
        for triangle in read_stl(case.folder / "upper.stl")
        if sum(n * (sum(triangle[d::3]) / 3 - m) for d, (n, m) in enumerate(zip(to_right, middle))) > 0
    ]
    write_stl(case.folder / "upper.stl", inside)
    run("register", case.file, "--output", tmp_path / "out", "--no-report")
    result = load(tmp_path / "out")
    assert "partial-arch" in codes_of(result, "upper")
    for jaw in ("upper", "lower"):
        assert "jaws-exchanged" not in codes_of(result, jaw)


def test_exchanged_scans_are_said_once(run, case, tmp_path):
    case.change(upper=case.load()["lower"], lower=case.load()["upper"])
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    for jaw in load(tmp_path / "out")["jaws"].values():
        codes = [finding["code"] for finding in jaw["findings"]]
        assert codes[0] == "jaws-exchanged" and codes.count("jaws-exchanged") == 1
        assert "sides-exchanged" not in codes
    assert done.returncode in (0, 1)


def test_both_jaws_in_one_scan_are_not_said_to_be_a_turned_drawing(run, case, tmp_path):
    write_stl(case.folder / "upper.stl", read_stl(case.folder / "upper.stl") + read_stl(case.folder / "lower.stl"))
    run("register", case.file, "--output", tmp_path / "out", "--no-report")
    findings = load(tmp_path / "out")["jaws"]["upper"]["findings"]
    assert findings[0]["code"] == "both-jaws"
    assert not {"turned-image", "pixel-spacing", "facing"} & {finding["code"] for finding in findings}


def test_strict_ends_with_one_where_a_jaw_is_suspect(run, case, tmp_path):
    landmarks = case.load("landmarks3d.json")
    first = next(iter(landmarks))
    case.save({**landmarks, first: [0.0, 0.0, 0.0]}, "landmarks3d.json")
    assert run("register", case.file, "--output", tmp_path / "a", "--no-report").returncode == 0
    assert run("register", case.file, "--output", tmp_path / "b", "--no-report", "--strict").returncode == 1


def test_inputs_are_recorded_with_what_they_hold(sample, plain):
    inputs = load(plain)["inputs"]
    case = json.loads((sample / "case.json").read_text())
    named = {"upper": case["upper"], "contours": case["contours"], "landmarks_2d": case["landmarks_2d"]}
    named["cephalogram.image"] = case["cephalogram"]["image"]
    for field, name in named.items():
        assert inputs[field]["path"] == name
        assert inputs[field]["sha256"] == hashlib.sha256((sample / name).read_bytes()).hexdigest()
    assert inputs["case"]["path"] == str(sample / "case.json")


def test_summary_has_fit_and_expected_error(run, sample, tmp_path):
    done = run("register", sample / "case.json", "--output", tmp_path / "out", "--no-report")
    result = load(tmp_path / "out")
    for name, jaw in result["jaws"].items():
        fit, error = jaw["metrics_matched"]["chamfer_px"], jaw["expected_error_px"]
        assert f"{name}: {jaw['status']}, fit {fit:.1f} px, expected error {error:.1f} px" in done.stdout
        sigmas = jaw["landmark_sigma_px"].values()
        assert error == pytest.approx(math.sqrt(math.pi / 2) * sum(sigmas) / len(sigmas))


def options_of(case, folder):
    """A case file's fields as options."""
    options = []
    for option, value in (
        ("--upper", folder / case["upper"]),
        ("--lower", folder / case["lower"]),
        ("--contours", folder / case["contours"]),
        ("--landmarks-3d", folder / case["landmarks_3d"]),
        ("--landmarks-2d", folder / case["landmarks_2d"]),
        ("--image", folder / case["cephalogram"]["image"]),
        ("--mesh-unit", case.get("mesh_unit", "mm")),
        ("--facing", case["cephalogram"]["facing"]),
        ("--source-side", case["geometry"]["source_side"]),
    ):
        options += [option, value]
    geometry = case["geometry"]
    options += ["--spacing", *case["cephalogram"]["pixel_spacing_mm"]]
    options += ["--distances", geometry["source_to_midsagittal_mm"], geometry["source_to_detector_mm"]]
    return [*options, "--principal-point", *geometry["principal_point_px"]]


def test_options_make_the_same_case_as_a_file(run, sample, plain, tmp_path):
    case = json.loads((sample / "case.json").read_text())
    done = run("register", *options_of(case, sample), "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    made = load(tmp_path / "out")
    for name, jaw in load(plain)["jaws"].items():
        assert made["jaws"][name]["landmarks_px"] == jaw["landmarks_px"]
        assert made["jaws"][name]["error"] == jaw["error"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], ["case", "--upper"]),
        (["--upper", "missing.stl", "--contours", "c.json"], ["missing.stl", "upper"]),
        (["--contours", "c.json"], ["neither", "upper"]),
        (["--upper", "u.stl", "--spacing", "a", "0.1"], ["--spacing", "number"]),
        (["CASE", "--facing", "left"], ["--facing", "case file"]),
    ],
)
def test_bad_options_name_what_to_give(run, sample, tmp_path, arguments, words):
    given = [str(sample / "case.json") if argument == "CASE" else argument for argument in arguments]
    done = run("register", *given, "--output", tmp_path / "out", cwd=tmp_path)
    assert done.returncode == 2
    assert len(done.stderr.strip().splitlines()) == 1
    for word in words:
        assert word in done.stderr
    assert not (tmp_path / "out").exists()


def test_project_places_points_as_the_registration_did(run, sample, plain, tmp_path):
    landmarks = json.loads((sample / "landmarks3d.json").read_text())
    done = run("project", plain, "--points", sample / "landmarks3d.json")
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert set(found) == set(landmarks)
    for jaw, values in load(plain)["jaws"].items():
        for name, place in values["landmarks_px"].items():
            assert found[name]["jaw"] == jaw and found[name]["status"] == values["status"]
            assert found[name]["position"] == pytest.approx(place, abs=1e-6)
            assert found[name]["sigma_px"] == pytest.approx(values["landmark_sigma_px"][name], rel=1e-6)
    own = {"apex of a root": landmarks["UR1_tip"]}
    (tmp_path / "points.json").write_text(json.dumps(own))
    done = run("project", plain / "result.json", "--points", tmp_path / "points.json")
    assert done.returncode == 2 and "--jaw" in done.stderr
    out = tmp_path / "places.json"
    done = run("project", plain / "result.json", "--points", tmp_path / "points.json", "--jaw", "upper", "--output", out)
    assert done.returncode == 0 and done.stdout == ""
    assert json.loads(out.read_text())["apex of a root"]["position"] == found["UR1_tip"]["position"]


def test_project_refuses_what_is_no_result_of_this_version(run, sample, plain, tmp_path):
    result = load(plain)
    for change, word in (
        ({"schema": "dentalscr-result/0"}, "dentalscr-result/0"),
        ({"schema": None}, "no result"),
        ({"jaws": {"upper": {**result["jaws"]["upper"], "pose": None}}}, "pose"),
    ):
        (tmp_path / "result.json").write_text(json.dumps({**result, **change}))
        done = run("project", tmp_path, "--points", sample / "landmarks3d.json")
        assert done.returncode == 2 and word in done.stderr, done.stderr
    done = run("project", sample / "case.json", "--points", sample / "landmarks3d.json")
    assert done.returncode == 2 and "no result" in done.stderr


def test_a_second_run_goes_on_from_the_first(run, sample, plain, tmp_path):
    done = run("register", "--from", plain, "--exclude", "UR6,LR6", "--output", tmp_path / "second", "--no-report")
    assert done.returncode == 0, done.stderr
    second = load(tmp_path / "second")
    assert second["control"] == {"exclude": ["UR6", "LR6"], "init": True}
    assert any("not searched beside a given start" in line for line in second["not_checkable"])
    for name, jaw in second["jaws"].items():
        before = load(plain)["jaws"][name]
        moved = [math.dist(jaw["landmarks_px"][mark], place) for mark, place in before["landmarks_px"].items()]
        assert 0.01 < max(moved) < 3.0
    # What the second was given stands on, until something else is said.
    done = run("register", "--from", tmp_path / "second", "--fix", "scale", "--output", tmp_path / "third", "--no-report")
    assert done.returncode == 0, done.stderr
    assert load(tmp_path / "third")["control"] == {"exclude": ["UR6", "LR6"], "fix": ["scale"], "init": True}
    freed = tmp_path / "freed"
    done = run(
        "register", "--from", tmp_path / "third" / "result.json", "--exclude", "none", "--fix", "none", "--output", freed,
        "--no-report",
    )
    assert done.returncode == 0, done.stderr
    assert load(freed)["control"] == {"init": True}
    for name, jaw in load(freed)["jaws"].items():
        for mark, place in load(plain)["jaws"][name]["landmarks_px"].items():
            assert math.dist(jaw["landmarks_px"][mark], place) < 0.05


@pytest.mark.parametrize("teeth", ["UR6,LR6", "UR1", "LR3"])
def test_a_tooth_that_is_given_back_leaves_no_trace(run, sample, plain, tmp_path, teeth):
    """Minima lie a fraction of a pixel apart: where the jaws are must not tell which way a person came there."""
    for name, start, excluded in (("without", plain, teeth), ("back", tmp_path / "without", "none")):
        done = run("register", "--from", start, "--exclude", excluded, "--output", tmp_path / name, "--no-report")
        assert done.returncode == 0, done.stderr
    done = run("register", sample / "case.json", "--exclude", teeth, "--output", tmp_path / "nothing", "--no-report")
    assert done.returncode == 0, done.stderr
    # The tooth that is left out moves the jaws, and so the test can fail.
    assert max(moved(load(plain), load(tmp_path / "without"))) > 0.1
    assert max(moved(load(plain), load(tmp_path / "back"))) < 0.02
    assert max(moved(load(tmp_path / "nothing"), load(tmp_path / "without"))) < 0.02


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda u, v, size: [v, u], "were its two numbers exchanged?"),
        (lambda u, v, size: [0.24 * u, 0.24 * v], "and not in mm or of another copy?"),
        (lambda u, v, size: [0.5 * size[1], 0.5 * size[0]], "with its two numbers exchanged it is the middle of the radiograph"),
        (lambda u, v, size: [2.0 * u, 2.0 * v], "where no ear rods are"),
    ],
    ids=["exchanged", "mm", "middle-exchanged", "copy"],
)
def test_a_principal_point_where_no_ear_rods_are_is_told(run, case, plain, tmp_path, change, words):
    """The pose makes up for it, and the jaws fit as well: what lies before and behind the tracing is pixels off."""
    content = case.load()
    size = case.load("contours.json")["image_size"]
    content["geometry"]["principal_point_px"] = change(*content["geometry"]["principal_point_px"], size)
    case.save(content)
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    for name, jaw in load(tmp_path / "out")["jaws"].items():
        assert "principal-point" not in codes_of(load(plain), name)
        assert jaw["status"] == "suspect"
        finding = next(each for each in jaw["findings"] if each["code"] == "principal-point")
        assert words in finding["text"] and "jaw" in finding["text"], finding


@pytest.mark.parametrize("middle", ["picture", "jaws", "absent"])
def test_a_principal_point_that_says_nothing_of_ear_rods_is_none_of_them(run, case, tmp_path, middle):
    content = case.load()
    if middle == "absent":
        content["geometry"].pop("principal_point_px")
    else:
        points = [p for jaw in case.load("contours.json")["contours"].values() for tooth in jaw for p in tooth["points"]]
        size = case.load("contours.json")["image_size"]
        content["geometry"]["principal_point_px"] = (
            [0.5 * size[0], 0.5 * size[1]] if middle == "picture" else numpy.mean(points, axis=0).tolist()
        )
    case.save(content)
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    for jaw in load(tmp_path / "out")["jaws"]:
        assert "principal-point" not in codes_of(load(tmp_path / "out"), jaw)


@pytest.mark.parametrize(
    ("move", "words"),
    [
        (lambda name, u, v: [0.5 * u, 0.5 * v], "were they divided by 0.50: were they marked on a copy"),
        (lambda name, u, v: [0.25 * u, 0.25 * v], "are they in mm? Give pixels"),
        (lambda name, u, v: [u - 60.0 * (name == "UR6_MB"), v], "landmarks_2d: UR6_MB was marked "),
    ],
    ids=["copy", "mm", "one"],
)
def test_marks_that_only_measure_are_said_to_be_of_another_picture(run, case, plain, tmp_path, move, words):
    marks = case.load("landmarks2d.json")
    case.save({name: move(name, u, v) for name, (u, v) in marks.items()}, "landmarks2d.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    result = load(tmp_path / "out")
    said = [line for line in result["warnings"] if line.startswith("landmarks_2d: ")]
    assert len(said) == 1 and words in said[0] and said[0] in done.stderr, result["warnings"]
    assert not any(line.startswith("landmarks_2d: ") for line in load(plain)["warnings"])
    for name, jaw in result["jaws"].items():
        # They measure, and nothing else.
        assert jaw["status"] == load(plain)["jaws"][name]["status"]
        assert jaw["landmarks_px"] == load(plain)["jaws"][name]["landmarks_px"]


def test_going_on_without_a_principal_point_is_a_run_from_nothing_at_that_place(run, case, tmp_path):
    """A pose means something in its own geometry alone, and without a principal point each tracing has one of its own."""
    content = case.load()
    content["geometry"].pop("principal_point_px")
    case.save(content)
    assert run("register", case.file, "--output", tmp_path / "first", "--no-report").returncode == 0
    done = run("register", "--from", tmp_path / "first", "--exclude", "UR1", "--output", tmp_path / "again", "--no-report")
    assert done.returncode == 0, done.stderr
    assert "is not used" not in done.stderr, done.stderr
    done = run("register", case.file, "--exclude", "UR1", "--output", tmp_path / "nothing", "--no-report")
    assert done.returncode == 0, done.stderr
    first, again, nothing = (load(tmp_path / name) for name in ("first", "again", "nothing"))
    assert again["geometry"] == nothing["geometry"]
    assert max(moved(nothing, again)) < 0.02
    assert max(moved(first, again)) < 4.0


def moved(first, second):
    """How far each landmark of each jaw has moved from a result to another, pixels."""
    return [
        math.dist(jaw["landmarks_px"][mark], place)
        for name, jaw in second["jaws"].items()
        for mark, place in first["jaws"][name]["landmarks_px"].items()
    ]


@pytest.mark.parametrize("tooth", ["UR6", "UR1", "LR6"])
def test_going_on_without_a_pixel_spacing_is_a_run_from_nothing_at_that_place(run, case, tmp_path, tooth):
    """An earlier estimate of spacing and principal point is a start and no fact: what is estimated is estimated anew."""
    content = case.load()
    content["cephalogram"].pop("pixel_spacing_mm")
    content["geometry"].pop("principal_point_px")
    case.save(content)
    assert run("register", case.file, "--output", tmp_path / "first", "--no-report").returncode == 0
    done = run("register", "--from", tmp_path / "first", "--exclude", tooth, "--output", tmp_path / "again", "--no-report")
    assert done.returncode == 0, done.stderr
    assert "is not used" not in done.stderr and "taken with the start" not in done.stderr, done.stderr
    done = run("register", case.file, "--exclude", tooth, "--output", tmp_path / "nothing", "--no-report")
    assert done.returncode == 0, done.stderr
    first, again, nothing = (load(tmp_path / name) for name in ("first", "again", "nothing"))
    assert again["geometry"] == nothing["geometry"]
    assert again["geometry"]["pixel_spacing_mm"]["source"] == "estimated"
    assert any("not searched beside a given start" in line for line in again["not_checkable"])
    assert max(moved(nothing, again)) < 0.02
    # The farthest are molars of the side that was not traced.
    assert 0.01 < max(moved(first, again)) < 4.0
    assert numpy.mean(moved(first, again)) < 2.0


def test_what_is_held_without_a_pixel_spacing_is_held_in_the_geometry_of_the_start(run, case, tmp_path):
    content = case.load()
    content["cephalogram"].pop("pixel_spacing_mm")
    content["geometry"].pop("principal_point_px")
    case.save(content)
    assert run("register", case.file, "--output", tmp_path / "first", "--no-report").returncode == 0
    # A tooth that is left out moves every estimate.
    done = run(
        "register", "--from", tmp_path / "first", "--exclude", "UR1", "--fix", "scale,rotation,translation", "--output",
        tmp_path / "held", "--no-report",
    )
    assert done.returncode == 0, done.stderr
    assert "principal point and pixel spacing taken with the start" in done.stderr, done.stderr
    first, held = load(tmp_path / "first"), load(tmp_path / "held")
    assert held["geometry"] == first["geometry"]
    assert max(moved(first, held)) < 0.01


@pytest.mark.parametrize(
    "change",
    [
        {"cephalogram": {"pixel_spacing_mm": [0.2, 0.2]}},
        {"geometry": {"principal_point_px": [120.0, 300.0]}},
        {"geometry": {"source_to_midsagittal_mm": 1400.0, "source_to_detector_mm": 1600.0}},
    ],
    ids=["spacing", "principal-point", "distances"],
)
def test_a_start_of_another_geometry_keeps_its_place_on_the_radiograph(run, case, plain, tmp_path, change):
    content = case.load()
    for field, values in change.items():
        content[field].update(values)
    case.save(content)
    done = run(
        "register", case.file, "--from", plain, "--fix", "scale,rotation,translation", "--output", tmp_path / "held", "--no-report"
    )
    assert done.returncode in (0, 1), done.stderr
    # The jaws' middle keeps its place exactly, what lies before and behind it by how the rays spread.
    assert max(moved(load(plain), load(tmp_path / "held"))) < 6.0


def test_what_has_failed_is_searched_anew(run, case, plain, tmp_path):
    content = case.load()
    right = content["cephalogram"]["pixel_spacing_mm"]
    content["cephalogram"]["pixel_spacing_mm"] = [0.4 * right[0], 0.4 * right[1]]
    case.save(content)
    assert run("register", case.file, "--output", tmp_path / "first", "--no-report").returncode == 1
    content["cephalogram"]["pixel_spacing_mm"] = right
    case.save(content)
    done = run("register", "--from", tmp_path / "first", "--output", tmp_path / "again", "--no-report")
    assert done.returncode == 0, done.stderr
    assert "failed, and is no start" in done.stderr
    assert max(moved(load(plain), load(tmp_path / "again"))) < 0.05


def test_going_on_has_the_landmarks_that_stood_in_place_of_the_cases(run, standard_case, tmp_path):
    other = json.loads((standard_case.folder / "cephalometric.json").read_text())
    other.pop("U6_MB")
    (tmp_path / "other.json").write_text(json.dumps(other))
    done = run(
        "register", standard_case.file, "--cephalometric-landmarks", tmp_path / "other.json", "--output", tmp_path / "first",
        "--no-report",
    )
    assert done.returncode in (0, 1), done.stderr
    done = run("register", "--from", tmp_path / "first", "--output", tmp_path / "again", "--no-report")
    assert done.returncode in (0, 1), done.stderr
    hashes = [load(tmp_path / name)["inputs"]["cephalometric_landmarks"]["sha256"] for name in ("first", "again")]
    assert hashes[0] == hashes[1]


def test_a_tracing_of_another_radiograph_is_told_by_the_picture(run, case, tmp_path):
    """It fits the scans, as dentitions are alike, and lies on no edges of the picture but elsewhere."""
    other = run("phantom", "--seed", "3", "--no-radiograph", "--output", tmp_path / "other")
    assert other.returncode == 0, other.stderr
    content = case.load()
    (case.folder / content["contours"]).write_bytes((tmp_path / "other" / "contours.json").read_bytes())
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode in (0, 1), done.stderr
    found = [each for each in load(tmp_path / "out")["jaws"]["upper"]["findings"] if each["code"] == "picture"]
    assert found and "another patient's radiograph" in found[0]["text"], done.stderr
    assert found[0]["value"] >= found[0]["limit"] + 2.0


def test_a_picture_that_was_cut_after_it_was_drawn_on_is_told(run, case, plain, tmp_path):
    cut = (37, 52)

    def move(pixels):
        grey = numpy.full_like(pixels, pixels[0, 0])
        grey[: -cut[1], : -cut[0]] = pixels[cut[1] :, cut[0] :]
        return grey

    change_picture(case, move)
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    for name, jaw in load(tmp_path / "out")["jaws"].items():
        finding = next(each for each in jaw["findings"] if each["code"] == "picture")
        assert "px to the left" in finding["text"] and "px above" in finding["text"], finding
        said = [int(word) for word in finding["text"].split() if word.isdigit()]
        assert abs(said[0] - cut[0]) <= 4 and abs(said[1] - cut[1]) <= 4, finding
        assert jaw["landmarks_px"] == load(plain)["jaws"][name]["landmarks_px"]


def test_going_on_says_what_it_misses(run, case, plain, tmp_path):
    done = run("register", "--from", tmp_path, "--output", tmp_path / "out")
    assert done.returncode == 2 and "result.json" in done.stderr
    assert run("register", case.file, "--output", tmp_path / "first", "--no-report").returncode == 0
    case.change(traced_side="right", numbering="UR")
    done = run("register", "--from", tmp_path / "first", "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0 and "has changed since" in done.stderr
    case.file.rename(case.folder / "moved.json")
    done = run("register", "--from", tmp_path / "first", "--output", tmp_path / "again", "--no-report")
    assert done.returncode == 2 and "inputs.case.path" in done.stderr
    done = run(
        "register", case.folder / "moved.json", "--from", tmp_path / "first", "--output", tmp_path / "again", "--no-report"
    )
    assert done.returncode == 0, done.stderr


def test_a_case_of_options_is_gone_on_from_without_them(run, case, tmp_path):
    """result.json holds what they said; the case's files are where they were, or the one that is not is named."""
    options = options_of(case.load(), case.folder)
    done = run("register", *options, "--exclude", "UR8", "--output", tmp_path / "first", "--no-report")
    assert done.returncode == 0, done.stderr
    first = load(tmp_path / "first")
    assert "case" not in first["inputs"] and not any(str(case.folder) in str(value) for value in first["case_fields"].values())
    for name, start in (("second", "first"), ("third", "second")):
        done = run("register", "--from", tmp_path / start, "--exclude", "UR6", "--output", tmp_path / name, "--no-report")
        assert done.returncode == 0 and "has changed" not in done.stderr, done.stderr
        made = load(tmp_path / name)
        assert made["case_fields"] == first["case_fields"] and made["inputs"] == first["inputs"]
        assert made["control"] == {"exclude": ["UR6"], "init": True}
        assert made["geometry"] == first["geometry"] and made["traced_side"] == first["traced_side"]
    # As with all that the options said, given again.
    done = run(
        "register", *options, "--from", tmp_path / "first", "--exclude", "UR6", "--output", tmp_path / "given", "--no-report"
    )
    assert done.returncode == 0, done.stderr
    assert max(moved(load(tmp_path / "given"), load(tmp_path / "second"))) == 0.0
    assert max(moved(first, load(tmp_path / "second"))) > 0.01
    # A tracing may be corrected: it is used as it is now, and that is said.
    case.change("contours.json", corrected=True)
    done = run("register", "--from", tmp_path / "first", "--output", tmp_path / "corrected", "--no-report")
    assert done.returncode == 0, done.stderr
    (said,) = [line for line in load(tmp_path / "corrected")["warnings"] if "has changed since" in line]
    assert said.startswith("contours: ") and "contours.json" in said and said in done.stderr
    (case.folder / "lower.stl").rename(case.folder / "moved.stl")
    done = run("register", "--from", tmp_path / "first", "--output", tmp_path / "none", "--no-report")
    assert done.returncode == 2 and "inputs.lower.path" in done.stderr and "lower.stl" in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1 and not (tmp_path / "none").exists()


def test_a_case_of_options_that_cannot_be_made_again_is_said(run, sample, tmp_path):
    options = options_of(json.loads((sample / "case.json").read_text()), sample)
    done = run("register", *options, "--anonymous", "--output", tmp_path / "first", "--no-report")
    assert done.returncode == 0, done.stderr
    done = run("register", "--from", tmp_path / "first", "--output", tmp_path / "second", "--no-report")
    assert done.returncode == 2 and "anonymous" in done.stderr, done.stderr
    done = run("register", *options, "--from", tmp_path / "first", "--output", tmp_path / "second", "--no-report")
    assert done.returncode == 0, done.stderr
    # As versions without the field have written them.
    result = {name: value for name, value in load(tmp_path / "first").items() if name != "case_fields"}
    (tmp_path / "first" / "result.json").write_text(json.dumps(result))
    done = run("register", "--from", tmp_path / "first", "--output", tmp_path / "third", "--no-report")
    assert done.returncode == 2 and "case_fields" in done.stderr, done.stderr


@pytest.mark.parametrize(
    "names",
    [
        ("4711_shell_occlusion_u.stl", "4711_shell_occlusion_l.stl"),
        ("Smith UpperJawScan.stl", "Smith LowerJawScan.stl"),
        ("case-upperjaw.stl", "case-lowerjaw.stl"),
        ("MAXILLA.stl", "Unterkiefer.stl"),
    ],
)
def test_new_makes_a_case_of_a_folder(run, sample, plain, tmp_path, names):
    folder = tmp_path / "Müller, 17"
    folder.mkdir()
    case = json.loads((sample / "case.json").read_text())
    for source, name in (
        (case["upper"], names[0]),
        (case["lower"], names[1]),
        (case["contours"], "tracing.json"),
        (case["landmarks_3d"], "a.json"),
        (case["landmarks_2d"], "b.json"),
        (case["cephalogram"]["image"], "picture.png"),
    ):
        (folder / name).write_bytes((sample / source).read_bytes())
    (folder / "4711_shell_lockedocclusion_ul.ply").write_bytes(b"ply")
    (folder / "bill.pdf").write_bytes(b"%PDF-1.4")
    done = run("new", folder)
    assert done.returncode == 0, done.stderr
    made = json.loads((folder / "case.json").read_text())
    notes = made.pop("_notes")
    assert made == {
        "upper": names[0],
        "lower": names[1],
        "cephalogram": {"image": "picture.png"},
        "contours": "tracing.json",
        "landmarks_3d": "a.json",
        "landmarks_2d": "b.json",
    }
    for name in (*names, "tracing.json", "a.json", "b.json", "picture.png", "4711_shell_lockedocclusion_ul.ply", "bill.pdf"):
        assert any(note.startswith(name + ": ") for note in notes), name
    assert any("pixel_spacing_mm" in note for note in notes)
    # It registers, with a warning about what nobody knows and none about the notes.
    done = run("register", folder / "case.json", "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    assert "_notes" not in done.stderr
    done = run("new", folder)
    assert done.returncode == 2 and "--force" in done.stderr
    assert run("new", folder, "--force", "--output", tmp_path / "other.json").returncode == 0
    assert json.loads((tmp_path / "other.json").read_text())["upper"] == f"Müller, 17/{names[0]}"


def test_new_guesses_no_jaw(run, sample, tmp_path):
    """A public tool that looked for a u took lower jaws for upper ones."""
    stl = (sample / "upper.stl").read_bytes()
    for name in ("uno.stl", "lu.stl", "u.stl", "jaw_l.stl", "upper_lower.stl"):
        (tmp_path / name).write_bytes(stl)
    done = run("new", tmp_path)
    assert done.returncode == 2 and "no scan whose jaw is known" in done.stderr
    assert not (tmp_path / "case.json").exists()
    for name in ("upper.stl", "upper2-maxilla.stl", "lower situ.stl"):
        (tmp_path / name).write_bytes(stl)
    assert run("new", tmp_path).returncode == 0
    made = json.loads((tmp_path / "case.json").read_text())
    assert "upper" not in made and made["lower"] == "lower situ.stl"
    assert any(note.startswith("upper.stl: not used: one of 2") for note in made["_notes"])
    assert any("still to be given" in note for note in made["_notes"])


def test_new_names_what_it_cannot_use_and_takes_a_label_map(run, sample, tmp_path):
    for name in ("upper.stl", "ceph.png"):
        (tmp_path / name).write_bytes((sample / name).read_bytes())
    (tmp_path / "points.xlsx").write_bytes(b"PK\x03\x04" + bytes(26) + b"xl/workbook.xml")
    (tmp_path / "F.fcsv").write_text("# Markups fiducial file version = 4.11\n")
    (tmp_path / "u.dcm").write_text('<?xml version="1.0"?><HPS version="1.1"></HPS>')
    (tmp_path / "photo.jpg").write_bytes(b"GIF89a")
    (tmp_path / "points.csv").write_text("UR1,1,2\nUR1,1,zwei\n")
    height, width = matplotlib.image.imread(sample / "ceph.png").shape[:2]
    labels = numpy.zeros((height, width), dtype=int)
    labels[300:340, 400:430] = 16
    (tmp_path / "segmentation.png").write_bytes(png(labels.tolist()))
    (tmp_path / "mask.png").write_bytes(png((255 * (labels > 0)).tolist()))
    (tmp_path / "cut_label.nii.gz").write_bytes(nifti(labels.tolist(), packed=True)[:-10])
    assert run("new", tmp_path).returncode == 0
    made = json.loads((tmp_path / "case.json").read_text())
    assert made["contours"] == "segmentation.png" and made["cephalogram"]["image"] == "ceph.png"
    for note in (
        "points.xlsx: not used: it is an Excel workbook; save the sheet as CSV",
        "F.fcsv: not used: it is Slicer's old .fcsv table; save the markups as .mrk.json",
        "u.dcm: not used: it is a 3Shape scan (HPS; no DICOM in spite of its name); export the scan",
        "photo.jpg: not used: it is a GIF picture; save it as PNG",
        "mask.png: not used: by its name it was made of a radiograph",
        "segmentation.png: a tracing: a label map with teeth",
        "cut_label.nii.gz: not used: by its name it was made of a radiograph and is none; as a label map it has this fault: the NIfTI file is truncated",
        "points.csv: not used: neither a tracing nor landmarks can be read from it; as a tracing it has this fault: line 2",
    ):
        assert any(line.startswith(note) for line in made["_notes"]), (note, made["_notes"])


@pytest.mark.parametrize("name", ["labels.nii", "ceph.nii.gz", "patient_017.nii.gz", "ceph.seg.NII.GZ"])
def test_new_takes_a_label_map_of_nifti_whatever_it_is_called(run, sample, tmp_path, name):
    """nnU-Net gives what it makes of a picture the name of the picture."""
    for file in ("upper.stl", "ceph.png"):
        (tmp_path / file).write_bytes((sample / file).read_bytes())
    height, width = matplotlib.image.imread(sample / "ceph.png").shape[:2]
    labels = numpy.zeros((height, width), dtype=int)
    labels[300:340, 400:430] = 16
    (tmp_path / name).write_bytes(nifti(labels.tolist(), packed=name.lower().endswith(".gz")))
    assert run("new", tmp_path).returncode == 0
    made = json.loads((tmp_path / "case.json").read_text())
    assert made["contours"] == name and made["cephalogram"]["image"] == "ceph.png", made["_notes"]
    assert any(line.startswith(name + ": a tracing: a label map with teeth") for line in made["_notes"])


def test_landmarks_at_another_tooth_are_told_beside_others_that_cannot_be_used(run, case, tmp_path):
    """A jaw that is suspect for some landmarks alone stands where it stands, and the others are looked at one by one."""
    landmarks = case.load("landmarks3d.json")
    # Each a tooth too far back, so that the last two have one place.
    moved = {**landmarks, "UR4_B": landmarks["UR5_B"], "UR5_B": landmarks["UR6_MB"], "UR6_MB": landmarks["UR7_MB"]}
    case.save(moved, "landmarks3d.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    assert result["jaws"]["upper"]["status"] == "suspect"
    assert all(finding["code"].startswith("landmarks-") for finding in result["jaws"]["upper"]["findings"]), done.stderr
    told = [line for line in result["warnings"] if "traced tooth of that code" in line]
    named = told[0] if told else ""
    named += " ".join(finding["text"] for finding in result["jaws"]["upper"]["findings"])
    assert told and all(name in named for name in ("UR4_B", "UR5_B", "UR6_MB")), (result["warnings"], result["jaws"]["upper"]["reasons"])
    # One whose place is in doubt says nothing of names.
    case.save({**case.load("case.json"), "cephalogram": {**case.load("case.json")["cephalogram"], "facing": "left"}})
    done = run("register", case.file, "--output", tmp_path / "other", "--no-report")
    assert "traced tooth of that code" not in done.stderr, done.stderr


def test_new_puts_files_of_one_tooth_each_together(run, sample, tmp_path):
    """As 3D Slicer saves curves, and programs of segmentation masks; of two files of one tooth neither is taken."""
    tracing = json.loads((sample / "contours.json").read_text())["contours"]
    for name in ("upper.stl", "ceph.png"):
        (tmp_path / name).write_bytes((sample / name).read_bytes())

    def save(name, points):
        control = [{"label": f"C-{i}", "position": [u, v, 0]} for i, (u, v) in enumerate(points)]
        (tmp_path / name).write_text(json.dumps({"markups": [{"type": "Curve", "controlPoints": control}]}))

    teeth = [(polyline["code"], polyline["points"]) for polyline in tracing["upper"] if polyline["points"]]
    for code, points in teeth:
        save(f"{code}.mrk.json", points)
    assert run("new", tmp_path).returncode == 0
    made = json.loads((tmp_path / "case.json").read_text())
    assert made["contours"] == {code: f"{code}.mrk.json" for code, _ in teeth}, made["_notes"]
    # Their unit is one thing that only a person knows.
    assert any("still to be given: \"markups_spacing_mm\"" in note for note in made["_notes"])
    save("tooth.mrk.json", teeth[0][1])
    (tmp_path / "tooth.mrk.json").write_text((tmp_path / "tooth.mrk.json").read_text().replace("C-", teeth[0][0] + "-"))
    assert run("new", tmp_path, "--force").returncode == 0
    made = json.loads((tmp_path / "case.json").read_text())
    assert "contours" not in made and any(f"one of {len(teeth) + 1} that could be" in note for note in made["_notes"])


def test_new_takes_masks_whose_names_tell_their_teeth(run, sample, tmp_path):
    for name in ("upper.stl", "ceph.png"):
        (tmp_path / name).write_bytes((sample / name).read_bytes())
    height, width = matplotlib.image.imread(sample / "ceph.png").shape[:2]

    def save(name, left):
        mask = numpy.zeros((height, width), dtype=int)
        mask[300:340, left : left + 30] = 255
        (tmp_path / name).write_bytes(png(mask.tolist()))

    save("mask_11.png", 400)
    assert run("new", tmp_path).returncode == 0
    assert json.loads((tmp_path / "case.json").read_text())["contours"] == {"UR1": "mask_11.png"}
    save("LR6-mask.png", 440)
    save("seg_tooth.png", 500)
    assert run("new", tmp_path, "--force").returncode == 0
    made = json.loads((tmp_path / "case.json").read_text())
    assert made["contours"] == {"UR1": "mask_11.png", "LR6": "LR6-mask.png"}, made["_notes"]
    assert any(note.startswith("seg_tooth.png: not used") for note in made["_notes"])


def test_new_takes_a_radiograph_of_nifti(run, sample, tmp_path):
    (tmp_path / "upper.stl").write_bytes((sample / "upper.stl").read_bytes())
    picture = (255 * matplotlib.image.imread(sample / "ceph.png")).round().astype(int).tolist()
    (tmp_path / "lateral.nii.gz").write_bytes(nifti(picture, spacing=(0.1, 0.1), packed=True))
    assert run("new", tmp_path).returncode == 0
    made = json.loads((tmp_path / "case.json").read_text())
    assert made["cephalogram"]["image"] == "lateral.nii.gz", made["_notes"]
    # Its header tells how long a pixel is.
    assert not any("pixel_spacing_mm" in note for note in made["_notes"]), made["_notes"]


def test_new_leaves_out_the_spacing_that_a_ruler_tells(run, sample, tmp_path):
    for name in ("upper.stl", "ceph.png"):
        (tmp_path / name).write_bytes((sample / name).read_bytes())
    height, width = matplotlib.image.imread(sample / "ceph.png").shape[:2]
    (tmp_path / "annotations.xml").write_text(
        f'<annotations><version>1.1</version><image id="0" name="ceph.png" width="{width}" height="{height}">'
        '<polyline label="UR1" points="10,10;20,20;30,35"/><polyline label="Calibration_30mm" points="5,5;5,125"/></image></annotations>'
    )
    assert run("new", tmp_path).returncode == 0
    notes = json.loads((tmp_path / "case.json").read_text())["_notes"]
    assert not any("pixel_spacing_mm" in note for note in notes), notes


def test_axis_and_render_warn_as_register_does(run, case, tmp_path):
    landmarks = case.load("landmarks3d.json")
    case.save({**landmarks, "UR1_tip": [0.0, 0.0, 300.0]}, "landmarks3d.json")
    sentence = "UR1_tip lies"
    assert sentence in run("register", case.file, "--output", tmp_path / "out", "--no-report").stderr
    assert sentence in run("axis", "--case", case.file, "--output", tmp_path / "axes").stderr
    findings = json.loads((tmp_path / "axes" / "axis.json").read_text())["upper"]["findings"]
    assert [finding["code"] for finding in findings] == ["landmarks-off-scan"]
    assert sentence in run("render", "--case", case.file, "--output", tmp_path / "drr.png").stderr
