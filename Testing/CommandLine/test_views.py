"""Further radiographs of a case: what a second view tells, and what is said of one that contradicts."""
import json
import math
import shutil
import subprocess

import pytest


@pytest.fixture(scope="module")
def frontal_phantom(program, tmp_path_factory):
    """A typical patient with a radiograph from the front."""
    folder = tmp_path_factory.mktemp("frontal")
    parameters = folder / "parameters.json"
    parameters.write_text('{"level": "typical", "frontal": {"given": true}}')
    done = subprocess.run(
        [program, "phantom", "--parameters", parameters, "--seed", "12", "--output", folder / "case"],
        capture_output=True, text=True, timeout=120,
    )
    assert done.returncode == 0, done.stderr
    return folder / "case"


def register(run, case, output, *options):
    done = run("register", case, "--output", output, *options)
    return done, json.loads((output / "result.json").read_text()) if (output / "result.json").exists() else None


def changed(source, target, change):
    shutil.copytree(source, target)
    case = json.loads((target / "case.json").read_text())
    change(case)
    (target / "case.json").write_text(json.dumps(case))
    return target / "case.json"


def test_a_frontal_view_tells_what_a_lateral_one_cannot(run, frontal_phantom, tmp_path):
    alone = changed(frontal_phantom, tmp_path / "alone", lambda case: case.pop("views"))
    done, one = register(run, alone, tmp_path / "one")
    assert done.returncode == 0, done.stderr
    done, two = register(run, frontal_phantom / "case.json", tmp_path / "two")
    assert done.returncode == 0, done.stderr
    assert "views" not in one
    for jaw in ("upper", "lower"):
        for parameter, share in (("roll_deg", 1.0), ("yaw_deg", 0.9), ("y_mm", 0.7)):
            assert two["jaws"][jaw]["pose_sigma"][parameter] < share * one["jaws"][jaw]["pose_sigma"][parameter]
    view = two["views"]["frontal"]
    assert view["direction"] == "frontal" and view["status"] == "ok" and view["findings"] == []
    assert view["geometry"]["patient_left"] == {"value": "right", "source": "given"}
    truth = json.loads((frontal_phantom / "truth.json").read_text())["views"]["frontal"]["landmarks_px"]
    errors = []
    for jaw in view["jaws"].values():
        errors += [math.dist(place, truth[name]) for name, place in jaw["landmarks_px"].items() if name in truth]
        assert set(jaw["landmark_sigma_px"]) == set(jaw["landmarks_px"])
        assert set(jaw["head_moved"]) == {"pitch_deg", "roll_deg", "yaw_deg", "x_mm", "y_mm", "z_mm"}
        # Both were taken at once.
        assert jaw["head_moved"]["yaw_deg"] == 0.0
    # Twelve marks of half a millimetre, which is two pixels.
    assert len(errors) > 20 and sum(errors) / len(errors) < 3.0
    for name in ("overlay_frontal_upper.png", "overlay_frontal_lower.png"):
        assert (tmp_path / "two" / name).read_bytes().startswith(b"\x89PNG")
    assert {"views.frontal.contours", "views.frontal.cephalometric_landmarks"} <= set(two["inputs"])
    # Registered again without the view nothing of it is left.
    done, _ = register(run, alone, tmp_path / "two")
    assert done.returncode == 0 and not (tmp_path / "two" / "overlay_frontal_upper.png").exists()


def test_the_shared_sample_is_closer_with_its_second_view(run, shared_cases, tmp_path):
    done, result = register(run, shared_cases / "two-views-1" / "case-both.json", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    truth = json.loads((shared_cases / "two-views-1" / "truth.json").read_text())["frontal_landmarks_px"]
    view = result["views"]["frontal"]
    assert view["status"] == "ok"
    errors = [
        math.dist(place, truth[name])
        for jaw in view["jaws"].values()
        for name, place in jaw["landmarks_px"].items()
        if name in truth
    ]
    assert len(errors) == 32 and sum(errors) / len(errors) < 2.0


@pytest.mark.parametrize(
    "field, value, code",
    [("cephalogram.patient_left", "left", "view-sides"), ("geometry.principal_point_px", [20.0, 800.0], None)],
)
def test_what_was_said_wrong_of_a_view_is_named(run, frontal_phantom, tmp_path, field, value, code):
    def change(case):
        group, name = field.split(".")
        case["views"][0][group][name] = value
        case["views"][0].pop("contours")

    done, result = register(run, changed(frontal_phantom, tmp_path / "case", change), tmp_path / "out")
    assert done.returncode == 0, done.stderr
    view = result["views"]["frontal"]
    assert view["status"] == "suspect"
    codes = [finding["code"] for finding in view["findings"]]
    assert code in codes if code else codes
    for jaw in result["jaws"].values():
        assert jaw["status"] == "suspect" and "view" in [finding["code"] for finding in jaw["findings"]]


def test_errors_of_a_view_are_measured_by_landmarks_of_its_own(run, frontal_phantom, tmp_path):
    def change(case):
        truth = json.loads((frontal_phantom / "truth.json").read_text())["views"]["frontal"]["landmarks_px"]
        (tmp_path / "case" / "marked.json").write_text(json.dumps({"UR2_tip": truth["UR2_tip"], "UR1_tip": truth["UR1_tip"]}))
        case["views"][0]["landmarks_2d"] = "marked.json"

    done, result = register(run, changed(frontal_phantom, tmp_path / "case", change), tmp_path / "out")
    assert done.returncode == 0, done.stderr
    error = result["views"]["frontal"]["jaws"]["upper"]["error"]
    # UR1_tip was registered with and does not score.
    assert list(error["landmarks"]) == ["UR2_tip"]
    assert "views.frontal.landmarks_2d" in result["inputs"]


@pytest.mark.parametrize(
    "change, words",
    [
        (lambda view: view.pop("direction"), ["views", "direction"]),
        (lambda view: view.update(direction="oblique"), ["oblique", "lateral", "frontal"]),
        (lambda view: view.update(name="a b"), ["short name"]),
        (lambda view: view.update(name="lateral"), ["already"]),
        (lambda view: [view.pop("contours"), view.pop("cephalometric_landmarks")], ["neither contours nor"]),
        (lambda view: view["cephalogram"].update(facing="left"), ["facing", "patient_left"]),
        (lambda view: view["geometry"].update(source="above"), ["above", "behind"]),
        (lambda view: view["geometry"].update(source_to_detector_mm=1000), ["source_to_midcoronal_mm"]),
        (lambda view: view["geometry"].update(principal_point_sigma_px=-1), ["principal_point_sigma_px"]),
        (lambda view: view.update(contours="gone.json"), ["gone.json"]),
        (lambda view: view.update(same_head_position="yes"), ["same_head_position"]),
    ],
)
def test_a_view_that_cannot_be_read_is_an_error_in_words(run, frontal_phantom, tmp_path, change, words):
    case = changed(frontal_phantom, tmp_path / "case", lambda case: change(case["views"][0]))
    done, _ = register(run, case, tmp_path / "out")
    assert done.returncode == 2
    for word in words:
        assert word in done.stderr, done.stderr
    assert not (tmp_path / "out").exists()


def test_views_are_a_list_of_a_few(run, frontal_phantom, tmp_path):
    for number, (views, word) in enumerate([({}, "no list"), ([{"direction": "frontal"}] * 9, "at most 8")]):
        case = changed(frontal_phantom, tmp_path / str(number), lambda case: case.update(views=views))
        done, _ = register(run, case, tmp_path / "out")
        assert done.returncode == 2 and word in done.stderr
