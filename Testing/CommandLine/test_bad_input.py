"""Unusable input: exit code 2, one line that names the file, the field and the remedy, and nothing written."""
import shutil
import struct

import pytest


def reject(run, case, tmp_path, *words, arguments=()):
    output = tmp_path / "out"
    done = run("register", case.file, "--output", output, *arguments)
    assert done.returncode == 2, (done.returncode, done.stderr)
    lines = [line for line in done.stderr.splitlines() if not line.startswith("dentalscr: warning:")]
    assert len(lines) == 1, done.stderr
    for word in words:
        assert word in lines[0], (word, lines[0])
    assert not output.exists()
    assert not list(tmp_path.glob(".out*"))


def change_stl(case, function, name="upper.stl"):
    path = case.folder / name
    path.write_bytes(function(path.read_bytes()))


STL_CHANGES = {
    "truncated": lambda data: data[: len(data) // 2],
    "a facet too many": lambda data: data + b"\0" * 50,
    "wrong count": lambda data: data[:80] + struct.pack("<I", 12345678) + data[84:],
    "header only": lambda data: data[:84],
    "short header": lambda data: data[:40],
    "empty": lambda data: b"",
    "nan": lambda data: data[:96] + struct.pack("<f", float("nan")) + data[100:],
    "infinity": lambda data: data[:96] + struct.pack("<f", float("inf")) + data[100:],
    "no triangles": lambda data: data[:80] + struct.pack("<I", 0),
}


@pytest.mark.parametrize("change", STL_CHANGES)
def test_broken_stl(run, case, tmp_path, change):
    change_stl(case, STL_CHANGES[change])
    reject(run, case, tmp_path, "upper.stl")


def test_mesh_that_is_a_folder(run, case, tmp_path):
    (case.folder / "upper.stl").unlink()
    (case.folder / "upper.stl").mkdir()
    reject(run, case, tmp_path, "case.json", "upper", "folder")


def test_missing_mesh(run, case, tmp_path):
    (case.folder / "upper.stl").unlink()
    reject(run, case, tmp_path, "case.json", "upper", "no file")


def test_unknown_mesh_format(run, case, tmp_path):
    (case.folder / "upper.xyz").write_text("nothing that anybody reads\n")
    case.change(upper="upper.xyz")
    reject(run, case, tmp_path, "upper.xyz")


def test_obj_index_out_of_range(run, case, tmp_path):
    (case.folder / "upper.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")
    case.change(upper="upper.obj")
    reject(run, case, tmp_path, "upper.obj", "4")


def test_missing_case(run, tmp_path):
    done = run("register", tmp_path / "none.json", "--output", tmp_path / "out")
    assert done.returncode == 2 and "none.json" in done.stderr and len(done.stderr.splitlines()) == 1


def test_json_syntax_error_has_line_and_column(run, case, tmp_path):
    case.file.write_text('{\n "upper": "upper.stl",\n "lower" "lower.stl"\n}')
    reject(run, case, tmp_path, "case.json", "line 3", "column")


def test_contours_syntax_error_has_line_and_column(run, case, tmp_path):
    (case.folder / "contours.json").write_text('{"image_size": [703, 938],\n "contours": [}')
    reject(run, case, tmp_path, "contours.json", "line 2", "column")


@pytest.mark.parametrize("field", ["contours"])
def test_missing_field(run, case, tmp_path, field):
    content = case.load()
    content.pop(field)
    case.save(content)
    reject(run, case, tmp_path, "case.json", field)


def use_landmarks(case, landmarks):
    """Landmarks in a file of their own, and no tracing."""
    case.save(landmarks, "cephalometric.json")
    content = case.load()
    content.pop("contours")
    content["cephalometric_landmarks"] = "cephalometric.json"
    case.save(content)


def test_landmarks_of_another_copy_of_the_image(run, case, tmp_path):
    use_landmarks(case, {"U1_tip": [1139, 1287], "L1_tip": [1114, 1244]})
    reject(run, case, tmp_path, "cephalometric.json", "U1_tip", "outside", "mm", "copy")


def test_landmarks_that_are_not_dental(run, case, tmp_path):
    use_landmarks(case, {"Sella": [100, 200], "Nasion": [200, 200]})
    reject(run, case, tmp_path, "cephalometric.json", "Sella", "U1_tip")


def test_two_names_of_one_landmark(run, case, tmp_path):
    use_landmarks(case, {"Is": [569, 643], "U1_tip": [569, 643]})
    reject(run, case, tmp_path, "cephalometric.json", "U1_tip", "Is", "keep one")


def test_landmarks_in_the_case_file_itself(run, case, tmp_path):
    case.change(cephalometric_landmarks={"U1_tip": [569]})
    reject(run, case, tmp_path, "case.json", "cephalometric_landmarks.U1_tip")


@pytest.mark.parametrize("preset", ["paper", "bounding-box", "single-stage"])
def test_presets_that_register_tracings_refuse_landmarks_alone(run, case, tmp_path, preset):
    use_landmarks(case, {"U1_tip": [569, 643], "L1_tip": [557, 622]})
    reject(run, case, tmp_path, "case.json", "contours", f"preset {preset}", arguments=("--preset", preset))


def test_landmarks_of_an_option_are_read_in_place_of_the_cases(run, case, tmp_path):
    case.save({"U1_tip": [569, 643]}, "good.json")
    case.save({"U1_tip": [5690, 6430]}, "bad.json")
    case.change(cephalometric_landmarks="good.json")
    option = ("--cephalometric-landmarks", case.folder / "bad.json")
    reject(run, case, tmp_path, "bad.json", "U1_tip", arguments=option)


def test_image_size_of_the_case_that_contradicts_the_image(run, case, tmp_path):
    content = case.load()
    content["cephalogram"]["image_size"] = [800, 900]
    case.save(content)
    reject(run, case, tmp_path, "case.json", "cephalogram.image_size", "800 x 900")


def test_no_scan_at_all(run, case, tmp_path):
    content = case.load()
    content.pop("upper")
    content.pop("lower")
    case.save(content)
    reject(run, case, tmp_path, "case.json", "upper", "lower")


def test_a_number_of_300_digits_is_shown_by_its_first_ones(run, case, tmp_path):
    for arguments, words in (
        (("register", case.file, "--threads", "9" * 300), "Value 999999999999... (300 digits) not in range 0 to 1024"),
        (("phantom", "--seed", "0." + "1" * 300), "--seed = 0.1111111111... (302 digits)"),
        (("render", "--upper", case.folder / "upper.stl", "--attenuation", "-1"), "Value -1 not in range"),
    ):
        done = run(*arguments, "--output", tmp_path / "out")
        assert done.returncode == 2 and words in done.stderr and len(done.stderr) < 400, done.stderr
    # The name of a file may be as long: it is said whole.
    name = "1.2.840.113619.2.55.3.604688119.868.1249343483.504.png"
    done = run("contour", "--labels", tmp_path / name, "--output", tmp_path / "out.json")
    assert done.returncode == 2 and name in done.stderr, done.stderr


def test_unknown_field_is_a_warning(run, case, tmp_path):
    case.change(colour="blue")
    done = run("register", case.file, "--output", tmp_path / "out", "--preset", "bounding-box")
    assert done.returncode == 0 and "colour" in done.stderr


@pytest.mark.parametrize(
    "member, value",
    [
        ("upper", 3),
        ("mesh_unit", "foot"),
        ("traced_side", "middle"),
        ("numbering", "palmer"),
        ("occlusion", "maybe"),
        ("fix", ["everything"]),
        ("exclude", ["UR9"]),
        ("init", {"pose": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 2, 0]]}),
        ("init", {"upper": {"similarity": {"scale": -1, "translation_px": [0, 0]}}}),
    ],
)
def test_wrong_value_names_the_field(run, case, tmp_path, member, value):
    case.change(**{member: value})
    reject(run, case, tmp_path, "case.json", member)


@pytest.mark.parametrize(
    "group, member, value",
    [
        ("cephalogram", "pixel_spacing_mm", [0, 0.25]),
        ("cephalogram", "pixel_spacing_mm", [0.25]),
        ("cephalogram", "pixel_spacing_mm", 0.25),
        ("cephalogram", "facing", "up"),
        ("cephalogram", "image", "none.png"),
        ("cephalogram", "spacing_plane", "film"),
        ("geometry", "source_to_detector_mm", 1000.0),
        ("geometry", "source_to_midsagittal_mm", -5),
        ("geometry", "source_side", "front"),
        ("geometry", "principal_point_px", ["a", 2]),
    ],
)
def test_wrong_nested_value_names_the_field(run, case, tmp_path, group, member, value):
    content = case.load()
    content[group][member] = value
    case.save(content)
    reject(run, case, tmp_path, "case.json", f"{group}.{member}")


def test_image_of_another_size(run, case, tmp_path):
    case.change("contours.json", image_size=[800, 900])
    reject(run, case, tmp_path, "contours.json", "image_size", "800")


def test_image_that_is_none(run, case, tmp_path):
    (case.folder / "ceph.png").write_bytes(b"this is no picture")
    reject(run, case, tmp_path, "ceph.png")


def test_truncated_image(run, case, tmp_path):
    data = (case.folder / "ceph.png").read_bytes()
    (case.folder / "ceph.png").write_bytes(data[: len(data) // 3])
    reject(run, case, tmp_path, "ceph.png")


def test_tracing_outside_the_image(run, case, tmp_path):
    contours = case.load("contours.json")
    for tooth in contours["contours"]["upper"]:
        tooth["points"] = [[u + 600, v] for u, v in tooth["points"]]
    case.save(contours, "contours.json")
    reject(run, case, tmp_path, "contours.json", "outside")


def test_a_few_points_outside_are_a_warning(run, case, tmp_path):
    contours = case.load("contours.json")
    contours["contours"]["upper"][0]["points"][0][0] = -3.0
    case.save(contours, "contours.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--preset", "bounding-box")
    assert done.returncode == 0 and "outside" in done.stderr


def test_code_that_the_numbering_has_not(run, case, tmp_path):
    contours = case.load("contours.json")
    contours["contours"]["upper"][0]["code"] = "19"
    case.save(contours, "contours.json")
    reject(run, case, tmp_path, "contours.json", "contours.upper[0].code", "19")


def test_too_short_a_tracing_fails_that_jaw_alone(run, case, tmp_path):
    contours = case.load("contours.json")
    tooth = contours["contours"]["upper"][0]
    contours["contours"]["upper"] = [{"code": tooth["code"], "points": tooth["points"][:4]}]
    case.save(contours, "contours.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--preset", "bounding-box")
    assert done.returncode == 1
    assert "4 points" in done.stderr
    import json

    result = json.loads((tmp_path / "out" / "result.json").read_text())
    assert result["status"] == "failed"
    assert result["jaws"]["upper"]["status"] == "failed" and result["jaws"]["upper"]["reasons"]
    assert result["jaws"]["lower"]["status"] != "failed"


def test_wrong_unit_is_suspect_and_names_the_right_one(run, case, tmp_path):
    case.change(mesh_unit="cm")
    done = run("register", case.file, "--output", tmp_path / "out", "--preset", "bounding-box")
    assert done.returncode in (0, 1)
    assert '"mesh_unit": "mm" would fit' in done.stderr


def test_exchanged_scans_are_noticed_by_the_landmarks(run, case, tmp_path):
    case.change(upper="lower.stl", lower="upper.stl")
    done = run("register", case.file, "--output", tmp_path / "out", "--preset", "bounding-box")
    assert done.returncode in (0, 1)
    assert "exchanged" in done.stderr


def test_exchanged_scans_without_landmarks_are_noticed_or_said_to_be_uncheckable(run, case, tmp_path):
    case.change(upper="lower.stl", lower="upper.stl")
    content = case.load()
    content.pop("landmarks_3d")
    content.pop("landmarks_2d")
    case.save(content)
    done = run("register", case.file, "--output", tmp_path / "out", "--preset", "bounding-box")
    assert done.returncode in (0, 1)
    noted = (tmp_path / "out" / "result.json").read_text()
    assert "exchanged" in noted


def test_output_that_is_a_file(run, case, tmp_path):
    (tmp_path / "out").write_text("mine")
    done = run("register", case.file, "--output", tmp_path / "out", "--preset", "bounding-box")
    assert done.returncode == 2 and "out" in done.stderr
    assert (tmp_path / "out").read_text() == "mine"


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["register"],
        ["register", "case.json"],
        ["register", "case.json", "--output", "out", "--preset", "magic"],
        ["register", "case.json", "--output", "out", "--frobnicate"],
        ["frobnicate"],
        ["phantom", "--output", "x", "--level", "easy"],
        ["render", "--output", "x.png"],
        ["axis", "--output", "x"],
        ["evaluate", "none.json", "--landmarks", "none2.json"],
    ],
)
def test_unusable_arguments(run, sample, tmp_path, arguments):
    shutil.copy(sample / "case.json", tmp_path / "case.json")
    for name in ("upper.stl", "lower.stl", "contours.json", "ceph.png", "landmarks2d.json", "landmarks3d.json"):
        (tmp_path / name).symlink_to(sample / name)
    done = run(*arguments, cwd=tmp_path)
    assert done.returncode == 2, done.stderr
    assert len(done.stderr.splitlines()) == 1, done.stderr
    assert not (tmp_path / "out").exists()
