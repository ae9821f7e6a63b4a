"""A case through the whole chain, from files and from memory."""
import copy
import json
import os
import pathlib
import pickle
import shutil
import subprocess
import sys

import numpy as np
import pytest


def without_times(value):
    if isinstance(value, dict):
        return {k: without_times(v) for k, v in value.items() if k not in ("seconds", "total_seconds")}
    return value


def test_result_equals_the_file_that_it_writes(ds, sample, tmp_path):
    result = ds.register(sample / "case.json", output=tmp_path / "out")
    assert result.to_dict() == json.loads((tmp_path / "out" / "result.json").read_text())


def test_landmark_error_is_that_of_the_truth(result, sample, ds):
    marked = ds.ReadLandmarks(sample / "landmarks2d.json")
    for name, jaw in result.jaws.items():
        errors = [np.linalg.norm(jaw.landmarks[k] - marked[k]) for k in marked if k in jaw.landmarks]
        assert jaw.error["mean_px"] == pytest.approx(np.mean(errors), abs=1e-6)
        # What the method reaches on typical phantoms (Documentation/Robust.md): 0.7 px, worst jaw 1.4.
        assert jaw.error["mean_px"] < 2.5, name


def test_projection_maps_the_landmarks(result, case):
    for jaw in result.jaws.values():
        points = np.array([case.landmarks3D[name] for name in jaw.landmarks])
        assert np.allclose(jaw.project(points), np.array(list(jaw.landmarks.values())), atol=1e-6)


def test_meshes_and_arrays_in_memory_register_like_the_files(ds, sample, case, result):
    memory = ds.Case(
        upper=(case.upper.points, case.upper.triangles),
        lower=sample / "lower.stl",
        contours=sample / "contours.json",
        geometry=case.geometry,
        image=sample / "ceph.png",
        landmarks3D=sample / "landmarks3d.json",
        landmarks2D=sample / "landmarks2d.json",
    )
    other = ds.register(memory)
    for name, jaw in result.jaws.items():
        assert np.array_equal(jaw.P_pixel_from_mesh, other.jaws[name].P_pixel_from_mesh)
        assert jaw.error == other.jaws[name].error


def test_nothing_that_registers_sees_the_marked_landmarks(ds, sample, case, result):
    moved = {name: point + 50.0 for name, point in ds.ReadLandmarks(sample / "landmarks2d.json").items()}
    memory = ds.Case(
        upper=case.upper, lower=case.lower, contours=sample / "contours.json", geometry=case.geometry,
        landmarks3D=case.landmarks3D, landmarks2D=moved,
    )
    other = ds.register(memory)
    for name, jaw in result.jaws.items():
        assert np.array_equal(jaw.P_pixel_from_mesh, other.jaws[name].P_pixel_from_mesh)
        assert other.jaws[name].error["mean_px"] > 50.0


def test_middles_of_a_scan_without_landmarks(ds, sample, case, result):
    """Tips and cusps that the scan's shape shows, where nobody marked the scan; of one that is marked all are landmarks."""
    assert result.middles == {} and set(result.upper.landmarks) > {"UR1_tip", "UL6_MB"}
    memory = ds.Case(
        upper=case.upper, lower=case.lower, contours=sample / "contours.json", geometry=case.geometry,
        landmarks2D=sample / "landmarks2d.json",
    )
    other = ds.register(memory)
    assert list(other.middles) == ["U1_tip", "U6_MB", "L1_tip", "L6_MB"]
    assert list(other.upper.middles) == ["U1_tip", "U6_MB"]
    for name, middle in other.middles.items():
        # The pose is the same: what is left is how far the points that were found are from those that were clicked.
        clicked = result.upper.landmarks if name[0] == "U" else result.lower.landmarks
        place = 0.5 * (clicked[name[0] + "R" + name[1:]] + clicked[name[0] + "L" + name[1:]])
        assert middle.found_by == (
            "its place along the arch" if name[1] == "1" else "the traced tooth and its place on the other side"
        )
        assert np.linalg.norm(middle.position - place) < 2.448 * middle.sigma, name
        assert 0.5 < middle.sigma < 12.0
    # One side was marked to measure by, which is no middle.
    assert other.upper.error is None
    assert pickle.loads(pickle.dumps(other)).middles["U6_MB"].sigma == other.middles["U6_MB"].sigma


def test_a_jaw_without_a_drawing_says_which_placed_it(ds, sample, case, result):
    """Jaws in occlusion: the lower one goes along with the upper one's tracing."""
    assert result.upper.placed_by is None and result.lower.placed_by is None
    contours = ds.ReadContours(sample / "contours.json", imageSize=(703, 938))
    memory = ds.Case(
        upper=case.upper, lower=case.lower, upperContour=contours.upper, geometry=case.geometry, imageSize=(703, 938),
        occlusion="true",
    )
    other = ds.register(memory)
    assert other.upper.placed_by is None and other.lower.placed_by == "upper"
    assert other.lower.status != "failed" and "placed by the upper jaw" in repr(other.lower)
    assert other.lower.expected_error is None or other.lower.expected_error > other.upper.expected_error
    assert pickle.loads(pickle.dumps(other)).lower.placed_by == "upper"


def test_result_pickles_with_its_pictures(result):
    copy = pickle.loads(pickle.dumps(result))
    assert copy.to_dict() == result.to_dict()
    assert copy.overlay_png("upper") == result.overlay_png("upper")
    assert np.array_equal(copy.upper.T_umda_from_mesh, result.upper.T_umda_from_mesh)
    assert np.array_equal(copy.upper.contours["whole"].points, result.upper.contours["whole"].points)


def test_notebook_shows_status_and_pictures(result):
    page = result._repr_html_()
    assert result.status in page and page.count("data:image/png;base64,") == len(result.jaws)
    assert "landmark error" in repr(result)


def test_jaw_without_tracing_is_skipped_with_its_reason(ds, sample, case):
    memory = ds.Case(
        upper=case.upper, lower=case.lower, upperContour=case.upperContour, geometry=case.geometry, imageSize=(703, 938)
    )
    result = ds.register(memory, preset="bounding-box")
    assert list(result.jaws) == ["upper"] and "lower" in result.skipped
    with pytest.raises(ds.ArgumentError, match="no lower jaw"):
        result.lower


@pytest.mark.parametrize("preset", ["paper", "bounding-box", "single-stage"])
def test_presets_are_those_of_the_program(ds, case, preset):
    assert ds.register(case, preset=preset).to_dict()["preset"] == preset


def test_options_of_the_robust_preset(ds, case):
    result = ds.register(case, options={"useRobustKernel": False, "yawStarts": [-0.1, 0.1]})
    assert "useRobustKernel=off" in str(result.to_dict())
    with pytest.raises(ds.ArgumentError, match="useMagic"):
        ds.register(case, options={"useMagic": True})
    with pytest.raises(ds.ArgumentError, match="no options"):
        ds.register(case, preset="paper", options={"useRobustKernel": False})


def test_a_control_that_changes_nothing_is_said(ds, sample, case):
    held = ds.register(sample / "case.json", preset="bounding-box", fix=["scale"])
    assert any('"fix" changes nothing with preset bounding-box' in warning for warning in held.warnings)
    assert any("not used by preset robust" in warning for warning in ds.register(case, silhouette="mesh").warnings)
    registration = ds.CaseRegistration()
    registration.SetPreset(ds.Preset.Paper)
    registration.SetOption("useRobustKernel=off")
    assert any("useRobustKernel=off: options of preset robust" in warning for warning in registration.Execute(case).warnings)
    for preset in ("bounding-box", "robust"):
        assert not ds.register(case, preset=preset).warnings


def test_unusable_case_names_file_field_and_remedy(ds, sample, tmp_path):
    content = json.loads((sample / "case.json").read_text())
    content["contours"] = "nowhere.json"
    (tmp_path / "case.json").write_text(json.dumps(content))
    with pytest.raises(ds.InputError) as error:
        ds.register(tmp_path / "case.json")
    assert isinstance(error.value, RuntimeError)
    assert error.value.file.endswith("case.json") and error.value.field and error.value.problem


def test_reader_and_writer_of_a_case(ds, sample, result, tmp_path):
    case = ds.DentalCaseReader().Execute(sample / "case.json")
    assert case.upper.points.shape == ds.ReadMesh(sample / "upper.stl").points.shape and "case.json" in repr(case)
    ds.WriteCaseResult(result, tmp_path / "lean", writeReport=False)
    result.Write(tmp_path / "full")
    names = [{path.name for path in (tmp_path / folder).iterdir()} for folder in ("lean", "full")]
    assert "result.json" in names[0] and names[0] < names[1] and "report.html" in names[1]
    ds.WriteCaseResult(result, tmp_path / "pageless", writePage=False)
    assert {path.name for path in (tmp_path / "pageless").iterdir()} == names[1] - {"report.html"}
    assert ds.WriteReportPage(tmp_path / "pageless", tmp_path / "page.html") == []
    assert result.status in (tmp_path / "page.html").read_text()
    result.Write(tmp_path / "shared", anonymous=True)
    shared = json.loads((tmp_path / "shared/result.json").read_text())
    assert shared["anonymous"] and not any("path" in entry for entry in shared["inputs"].values())
    with pytest.raises(ds.ArgumentError, match="pickled"):
        ds.WriteCaseResult(pickle.loads(pickle.dumps(result)), tmp_path / "none")


def test_landmarks_to_register_with_from_memory_and_from_a_file(ds, sample, tmp_path):
    (tmp_path / "aariz.json").write_text(
        json.dumps({"ceph_id": "x", "landmarks": [
            {"title": "Upper Incisor Tip", "symbol": "UIT", "value": {"x": 570, "y": 643}},
            {"title": "Sella", "symbol": "S", "value": {"x": 1, "y": 2}},
        ]})
    )
    read = ds.ReadCephalometricLandmarks(tmp_path / "aariz.json")
    assert list(read) == ["UIT"] and np.array_equal(read["UIT"]["position"], [570.0, 643.0])

    def make(landmarks, **more):
        return ds.Case(upper=sample / "upper.stl", cephalometricLandmarks=landmarks, imageSize=(703, 938), **more)

    memory = make({"U1_tip": (570, 643), "Ms": {"position": (464, 613), "sigma_px": 2.0, "confidence": 0.5}})
    taken = memory.cephalometricLandmarks
    assert np.array_equal(taken["U1_tip"]["position"], [570.0, 643.0]) and "sigma_px" not in taken["U1_tip"]
    assert taken["Ms"]["sigma_px"] == 2.0 and taken["Ms"]["confidence"] == 0.5
    # Names of an analysis are its own convention, unless something else is said.
    assert memory.tracedSide == "standard" and memory.warnings == []
    # Beside names without sides, those with sides are taken for the middle: that is said.
    mixed = make({"U1_tip": (570, 643), "UR6_MB": (464, 613)})
    assert mixed.tracedSide == "standard" and "traced_side" in mixed.warnings[0]
    assert make({"U1_tip": (570, 643)}, tracedSide="right").tracedSide == "right"
    assert make({"U1_tip": (570, 643)}, tracedSide="standard").warnings == []
    file = make(tmp_path / "aariz.json")
    assert list(file.cephalometricLandmarks) == ["UIT"] and "Sella" not in file.cephalometricLandmarks
    assert make(read).cephalometricLandmarks["UIT"]["position"][0] == 570.0


def test_landmarks_that_are_none_are_named(ds, sample):
    def make(landmarks):
        return ds.Case(upper=sample / "upper.stl", cephalometricLandmarks=landmarks, imageSize=(703, 938))

    with pytest.raises(ds.ArgumentError, match="Sella"):
        make({"Sella": (1, 2)})
    with pytest.raises(ds.ArgumentError, match="same point"):
        make({"Is": (1, 2), "U1_tip": (1, 2)})
    with pytest.raises(ds.ArgumentError, match="sigma"):
        make({"U1_tip": {"position": (1, 2), "sigma": 2.0}})
    with pytest.raises(ds.ArgumentError, match="sigma_px of landmark U1_tip"):
        make({"U1_tip": {"position": (1, 2), "sigma_px": 0}})
    with pytest.raises(ds.InputError, match="U1_tip"):
        make({"U1_tip": (5700, 6430)})
    with pytest.raises(TypeError, match="landmarks"):
        make(3)


def test_case_without_a_word_about_its_side_is_of_the_right(ds, sample, case):
    assert case.tracedSide == "right"
    assert ds.Case(upper=case.upper, upperContour=case.upperContour, imageSize=(703, 938)).tracedSide == "right"


def test_counterparts_of_landmarks_tell_how_they_were_found(ds, case):
    """By the scan's landmarks where they are given, else along the arch; an apex is on no scan."""
    axes = ds.UMidlineDentalAxis(case.upper, case.lower)
    marks = {"U1_tip": (100, 100), "Ms": {"position": (50, 90), "sigma_px": 2.0}, "UIA": (90, 40)}
    process = ds.LandmarkCounterpartFilter()
    found = process.Execute(marks, case.upper, upperFrame=axes.upperTransform)
    assert set(found) == {"U1_tip", "U6_mesial"}
    assert found["U1_tip"].rule == "foremost" and found["U1_tip"].points.shape == (2, 3)
    assert found["U6_mesial"].rule == "middle" and found["U6_mesial"].source == "its place along the arch"
    assert [name for name, _ in process.GetUnused()] == ["UIA"]
    click = case.upper.points[17]
    clicked = ds.FindLandmarkCounterparts(marks, upperMesh=case.upper, scanLandmarks={"UR1_tip": tuple(click)})
    assert clicked["U1_tip"].source == "landmarks_3d" and np.allclose(clicked["U1_tip"].points, [click])
    # What lies elsewhere is none of this scan, whatever its name is.
    assert ds.FindLandmarkCounterparts(marks, upperMesh=case.upper, scanLandmarks={"UR1_tip": (500, 2, 3)}) == {}


def test_a_molar_s_counterpart_is_that_of_the_traced_tooth(ds, sample, case):
    """With a solution and its tracings; by a textbook's place without them, which is another point of the scan."""
    axes = ds.UMidlineDentalAxis(case.upper, case.lower)
    solution = ds.PoseRegistration(case.geometry, case.upper, case.upperContour, case.lower, case.lowerContour, frames=axes)
    marks = {"U6_MB": (100, 100), "L6_MB": (100, 100), "U1_tip": (100, 100)}
    inputs = {
        "upperMesh": case.upper,
        "lowerMesh": case.lower,
        "upperFrame": axes.upperTransform,
        "lowerFrame": axes.lowerTransform,
    }
    tracings = {"upperTracing": case.upperContour, "lowerTracing": case.lowerContour}
    by_place = ds.FindLandmarkCounterparts(marks, **inputs)
    by_tooth = ds.FindLandmarkCounterparts(marks, **inputs, solution=solution, **tracings)
    places = json.loads((sample / "landmarks3d.json").read_text())
    for name, jaw in (("U6_MB", "U"), ("L6_MB", "L")):
        assert by_place[name].source == "its place along the arch"
        assert "the traced tooth" in by_tooth[name].source and by_tooth[name].rule == "middle"
        assert by_tooth[name].sigmaAlong < by_place[name].sigmaAlong
        truth = [places[f"{jaw}{side}6_MB"] for side in "RL"]
        # The right side was traced. The left one's cusp is as far along the arch, and in the error that is stated.
        right, left = by_tooth[name].points - truth
        assert np.linalg.norm(right) < 0.5
        assert np.linalg.norm(0.5 * (right + left)) < 2.448 * by_tooth[name].sigmaAlong
    # A front tooth is no matter of the traced tooth, and neither the solution nor a tracing alone tells of one.
    assert by_tooth["U1_tip"].source == by_place["U1_tip"].source
    for alone in ({"solution": solution}, tracings):
        found = ds.FindLandmarkCounterparts(marks, **inputs, **alone)
        assert found["U6_MB"].source == "its place along the arch"
        assert np.array_equal(found["U6_MB"].points, by_place["U6_MB"].points)
    # What was set before does not stay.
    process = ds.LandmarkCounterpartFilter()
    process.Execute(marks, **inputs, solution=solution, **tracings)
    assert process.Execute(marks, **inputs)["U6_MB"].source == "its place along the arch"


@pytest.fixture
def two_views():
    """A sample with a radiograph from the front, beside the project."""
    folder = pathlib.Path(__file__).resolve().parents[3].parent / "shared/cases/two-views-1"
    if not folder.is_dir():
        pytest.skip("there are no shared cases beside the project")
    return folder


def test_a_second_view_by_file_and_by_hand(ds, two_views):
    folder = two_views
    result = ds.register(folder / "case-both.json")
    view = result.views["frontal"]
    assert view.direction == "frontal" and view.status == "ok" and view.findings == ()
    truth = json.loads((folder / "truth.json").read_text())["frontal_landmarks_px"]
    marks = json.loads((folder / "landmarks3d.json").read_text())
    places = marks.get("upper", marks)
    errors = [
        np.linalg.norm(view.project("upper", [places[name]])[0] - truth[name]) for name in places if name in truth
    ]
    assert len(errors) > 10 and np.mean(errors) < 3.0
    assert ds.register(folder / "case.json").views == {}

    geometry = ds.CephalometricGeometry(pixelSpacing=0.25, principalPoint=(10, 20), direction="Frontal", patientLeft="Left")
    assert geometry.GetDirection() == ds.CephalometricGeometry.Direction.Frontal
    for other in (copy.copy(geometry), pickle.loads(pickle.dumps(geometry))):
        assert np.array_equal(other.GetProjectionMatrix(), geometry.GetProjectionMatrix())
    u, v = geometry.ProjectPoint((0.0, 30.0, -10.0))
    assert u == pytest.approx(10 - 1674 / 1524 * 30 / 0.25) and v == pytest.approx(20 + 1674 / 1524 * 10 / 0.25)
    assert "frontal" in repr(geometry)


def test_the_page_s_lines_about_views_run(ds, two_views, monkeypatch):
    page = pathlib.Path(__file__).resolve().parents[3] / "Documentation/Python.md"
    lines = page.read_text().split("## Further radiographs")[1].split("```python")[1].split("```")[0]
    case = ds.ReadCase(two_views / "case.json")
    monkeypatch.chdir(two_views)
    names = {
        "ds": ds,
        "upper": case.upper,
        "lower": case.lower,
        "geometry": case.geometry,
        "tracing": ds.ReadContours("contours.json"),
        "frames": ds.UMidlineDentalAxis(case.upper, case.lower, refineMidline=True),
        "marks": json.loads((two_views / "frontal.json").read_text()),
    }
    exec(lines, names)
    assert names["view"].status == "ok" and names["solution"].GetViewNames() == ["frontal"]


def test_a_view_joins_the_method(ds, two_views):
    folder = two_views
    case = ds.ReadCase(folder / "case.json")
    description = json.loads((folder / "case-both.json").read_text())["views"][0]
    marks = json.loads((folder / "frontal.json").read_text())
    axes = ds.UMidlineDentalAxis(case.upper, case.lower, refineMidline=True)
    counterparts = ds.FindLandmarkCounterparts(
        {name: tuple(place) for name, place in marks.items()},
        upperMesh=case.upper,
        lowerMesh=case.lower,
        upperFrame=axes.upperTransform,
        lowerFrame=axes.lowerTransform,
        scanLandmarks=case.landmarks3D,
        direction="Frontal",
    )
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    method.AddView(
        ds.CephalometricGeometry(
            sourceToMidsagittal=description["geometry"]["source_to_midcoronal_mm"],
            sourceToDetector=description["geometry"]["source_to_detector_mm"],
            pixelSpacing=description["cephalogram"]["pixel_spacing_mm"],
            principalPoint=description["geometry"]["principal_point_px"],
            direction="Frontal",
        ),
        cephalometricLandmarks={name: tuple(place) for name, place in marks.items()},
        counterparts=counterparts,
    )
    solution = method.Execute(case.geometry, case.upper, case.upperContour, case.lower, case.lowerContour)
    assert solution.GetViewNames() == ["frontal"]
    by_hand = ds.RegistrationVerdict(solution)
    assert by_hand.status == "ok" and by_hand.views["frontal"].status == "ok"
    # The same in one call, of a case in memory.
    view = {
        "geometry": ds.CephalometricGeometry(
            sourceToMidsagittal=description["geometry"]["source_to_midcoronal_mm"],
            sourceToDetector=description["geometry"]["source_to_detector_mm"],
            pixelSpacing=description["cephalogram"]["pixel_spacing_mm"],
            principalPoint=description["geometry"]["principal_point_px"],
            direction="Frontal",
        ),
        "cephalometricLandmarks": marks,
        "imageSize": tuple(description["cephalogram"]["image_size"]),
    }
    whole = ds.Case(
        case.upper,
        case.lower,
        case.upperContour,
        case.lowerContour,
        geometry=case.geometry,
        imageSize=case.imageSize,
        tracedSide=case.tracedSide,
        landmarks3D=case.landmarks3D,
        views=[view],
    )
    assert ds.register(whole).views["frontal"].status == "ok"
    with pytest.raises(ValueError, match="no name of a further view"):
        ds.Case(case.upper, imageSize=(10, 10), views=[{**view, "name": "../evil"}])
    # What is not known of its geometry is likely, as in a file.
    bare = ds.CephalometricGeometry(direction="Frontal")
    unknown = ds.Case(
        case.upper, case.lower, case.upperContour, case.lowerContour, geometry=case.geometry, imageSize=case.imageSize,
        tracedSide=case.tracedSide, landmarks3D=case.landmarks3D, views=[{**view, "geometry": bare}],
    )
    result = ds.register(unknown)
    assert sum("views.frontal" in warning for warning in result.warnings) == 2
    assert all(jaw.status == "ok" or jaw.findings[0].code == "view" for jaw in (result.upper, result.lower))
    with pytest.raises(ValueError, match="nothing was drawn"):
        ds.Case(case.upper, imageSize=(10, 10), views=[{**view, "cephalometricLandmarks": None}])
    with pytest.raises(ValueError, match="two views"):
        ds.Case(case.upper, imageSize=(10, 10), views=[view, view])
    # By hand a view that contradicts is told as it is by register(): of itself, and of each jaw.
    wrong = ds.CephalometricGeometry(
        sourceToMidsagittal=description["geometry"]["source_to_midcoronal_mm"],
        sourceToDetector=description["geometry"]["source_to_detector_mm"],
        pixelSpacing=description["cephalogram"]["pixel_spacing_mm"],
        principalPoint=description["geometry"]["principal_point_px"],
        direction="Frontal",
        patientLeft="Left",
    )
    other = ds.PoseRegistrationMethod()
    other.SetFrames(axes)
    other.AddView(
        wrong, cephalometricLandmarks={name: tuple(place) for name, place in marks.items()}, counterparts=counterparts
    )
    verdict = ds.RegistrationVerdict(
        other.Execute(case.geometry, case.upper, case.upperContour, case.lower, case.lowerContour)
    )
    assert verdict.views["frontal"].status == "suspect"
    assert [finding.code for finding in verdict.views["frontal"].findings][0] == "view-sides"
    for jaw in (verdict.upper, verdict.lower):
        assert jaw.status == "suspect" and "view" in [finding.code for finding in jaw.findings]
    frontal = solution.MakeViewSolution("frontal")
    truth = json.loads((folder / "truth.json").read_text())["frontal_landmarks_px"]
    place = frontal.ProjectPoint("Upper", case.landmarks3D["UR2_tip"])
    assert np.linalg.norm(np.subtract(place, truth["UR2_tip"])) < 4.0
    with pytest.raises(Exception, match="frontal"):
        method.AddView(case.geometry)


def moved(first, second):
    """How far landmarks have moved from a result to another, pixels."""
    return max(
        np.linalg.norm(second.jaws[name].landmarks[mark] - place)
        for name, jaw in first.jaws.items()
        for mark, place in jaw.landmarks.items()
    )


def keywords(sample, case):
    return {
        "upper": case.upper,
        "lower": case.lower,
        "contours": sample / "contours.json",
        "geometry": case.geometry,
        "imageSize": case.imageSize,
        "landmarks3D": case.landmarks3D,
        "tracedSide": "right",
    }


def test_a_result_is_gone_on_from_on_disk_and_in_memory(ds, sample, case, result, tmp_path):
    result.Write(tmp_path / "first", report=False)
    again = {
        name: ds.register_from(first, exclude=["UR6", "LR6"])
        for name, first in (("disk", tmp_path / "first"), ("file", tmp_path / "first" / "result.json"), ("memory", result))
    }
    nothing = ds.register(ds.Case(**keywords(sample, case), exclude=["UR6", "LR6"]))
    for other in again.values():
        assert other.to_dict()["control"] == {"exclude": ["UR6", "LR6"], "init": True}
        assert any("not searched beside a given start" in line for line in other.to_dict()["not_checkable"])
        # A start says which place is meant: the answer there is that of a run from nothing.
        assert 0.01 < moved(result, other) and moved(nothing, other) < 0.02
        assert moved(again["disk"], other) == 0.0
    # What it was told holds on; an empty list takes it back, and so it is where it was.
    third = ds.register_from(again["memory"], fix=["scale"], output=tmp_path / "third")
    assert third.to_dict()["control"] == {"exclude": ["UR6", "LR6"], "fix": ["scale"], "init": True}
    for first in (third, tmp_path / "third"):
        freed = ds.register_from(first, exclude=[], fix=[])
        assert freed.to_dict()["control"] == {"init": True}
        # Given back, the teeth leave no trace.
        assert moved(result, freed) < 0.02


def test_a_case_of_options_is_gone_on_from(ds, sample, tmp_path):
    """The program's result holds what its options said."""
    folder = tmp_path / "case"
    shutil.copytree(sample, folder)
    content = json.loads((folder / "case.json").read_text())
    options = [word for field in ("upper", "lower", "contours") for word in (f"--{field}", str(folder / content[field]))]
    options += ["--landmarks-3d", str(folder / content["landmarks_3d"]), "--facing", content["cephalogram"]["facing"]]
    options += ["--image", str(folder / content["cephalogram"]["image"]), "--traced-side", "right", "--numbering", "UR"]
    options += ["--spacing", *map(str, content["cephalogram"]["pixel_spacing_mm"])]
    words = ["register", *options, "--no-report", "--output", str(tmp_path / "first")]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    done = subprocess.run([sys.executable, "-m", "dentalscr", *words], capture_output=True, text=True, env=environment)
    assert done.returncode == 0, done.stderr
    first = json.loads((tmp_path / "first" / "result.json").read_text())
    again = ds.register_from(tmp_path / "first", exclude=["UR6"], output=tmp_path / "second")
    made = again.to_dict()
    assert made["case_fields"] == first["case_fields"] and made["case_fields"]["numbering"] == "UR"
    assert made["inputs"] == first["inputs"] and made["control"] == {"exclude": ["UR6"], "init": True}
    assert made["geometry"]["pixel_spacing_mm"] == first["geometry"]["pixel_spacing_mm"]
    # From there on in memory, and from the folder that Python has written.
    third = {name: ds.register_from(start, exclude=[]) for name, start in (("memory", again), ("disk", tmp_path / "second"))}
    for one in third.values():
        assert one.to_dict()["case_fields"] == first["case_fields"] and one.to_dict()["control"] == {"init": True}
    assert moved(third["memory"], third["disk"]) == 0.0
    copied = pickle.loads(pickle.dumps(again._case))
    assert moved(ds.register(copied), again) == 0.0
    (folder / content["lower"]).unlink()
    with pytest.raises(ds.InputError, match=r"inputs\.lower\.path"):
        ds.register_from(tmp_path / "first")


def test_a_case_in_memory_is_gone_on_with_and_may_be_corrected(ds, sample, case):
    first = ds.register(ds.Case(**keywords(sample, case), exclude=["UR6", "LR6"]))
    again = ds.register_from(first, fix=["scale", "rotation", "translation"])
    assert again.to_dict()["control"] == {"exclude": ["UR6", "LR6"], "fix": ["scale", "rotation", "translation"], "init": True}
    assert moved(first, again) < 1e-6
    back = ds.register_from(first, exclude=[])
    assert back.to_dict()["control"] == {"init": True} and moved(first, back) > 0.001
    # A tooth's line is corrected: what was learnt of the rest is the start.
    contours = ds.ReadContours(sample / "contours.json")
    corrected = ds.register_from(first, case={**keywords(sample, case), "contours": contours}, exclude=[])
    assert moved(back, corrected) < 0.05
    assert ds.register(ds.Case(**keywords(sample, case), init=first)).to_dict()["control"] == {"init": True}
    started = ds.register(keywords(sample, case), init=first)
    assert started.to_dict()["control"] == {"init": True}


def test_a_start_without_a_pixel_spacing_is_the_estimate(ds, sample, case):
    first = ds.register({**keywords(sample, case), "geometry": None})
    assert first.to_dict()["geometry"]["pixel_spacing_mm"]["source"] == "estimated"
    again = ds.register_from(first, exclude=["UR6"])
    assert not any("is not used" in line for line in again.warnings)
    # The estimate of the first is a start and no fact: what is estimated anew is what a run from nothing estimates.
    nothing = ds.register({**keywords(sample, case), "geometry": None}, exclude=["UR6"])
    assert again.to_dict()["geometry"] == nothing.to_dict()["geometry"]
    assert 0.001 < moved(first, again) < 4.0 and moved(nothing, again) < 0.02
    # With nothing changed it is the first's, and where something is held what is held is held in the first's.
    same = ds.register_from(first)
    assert same.to_dict()["geometry"] == first.to_dict()["geometry"] and moved(first, same) < 0.02
    held = ds.register_from(first, exclude=["UR6"], fix=["scale"])
    assert held.to_dict()["geometry"]["pixel_spacing_mm"] == first.to_dict()["geometry"]["pixel_spacing_mm"]


def test_what_cannot_be_gone_on_from_is_said(ds, sample, result, tmp_path):
    pickled = pickle.loads(pickle.dumps(result))
    with pytest.raises(ValueError, match="pickled"):
        ds.register_from(pickled)
    assert moved(result, ds.register_from(pickled, case=sample / "case.json")) < 0.05
    with pytest.raises(ds.InputError, match="result.json"):
        ds.register_from(tmp_path)
    with pytest.raises(ds.InputError, match="pose"):
        ds.register_from(ds.register(sample / "case.json", preset="bounding-box"))
    started = ds.ReadCase(sample / "case.json", init=result)
    copied = pickle.loads(pickle.dumps(started))
    assert moved(ds.register(started), ds.register(copied)) == 0.0
