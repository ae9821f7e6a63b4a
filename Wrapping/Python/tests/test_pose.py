"""The robust registration by its parts, its data and what a user adds to it."""
import copy
import gc
import importlib.util
import io
import json
import pathlib
import pickle
import re
import threading
import weakref

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]


@pytest.fixture(scope="module")
def phantom(ds):
    return ds.DentalPhantomCase(3, "ideal", makeRadiograph=False)


@pytest.fixture(scope="module")
def axes(ds, phantom):
    return ds.UMidlineDentalAxis(phantom.upper.mesh, phantom.lower.mesh, refineMidline=True)


def inputs(case):
    return case.geometry, case.upper.mesh, case.upper.tracing, case.lower.mesh, case.lower.tracing


@pytest.fixture(scope="module")
def solution(ds, phantom, axes):
    return ds.PoseRegistration(*inputs(phantom), frames=axes)


def make_quick_options(ds):
    options = ds.PoseRegistrationOptions()
    options.yawStarts = [0.0]
    options.startsPerYaw = 1
    options.checkHypotheses = False
    return options


# What comes out ------------------------------------------------------------------------------------------------------


def test_registration_finds_the_true_projection(ds, phantom, solution):
    verdict = ds.RegistrationVerdict(solution)
    assert verdict.status == "ok" and verdict.notCheckable
    assert solution.GetJawsShareFrame() and solution.HasConverged("upper")
    for jaw, true in (("upper", phantom.upper), ("lower", phantom.lower)):
        assert solution.IsRegistered(jaw) and solution.GetFailure(jaw) == "" and solution.GetStatus(jaw) == "ok"
        assert getattr(verdict, jaw) == ("ok", ())
        names = list(true.landmarks2D)
        points = np.array([true.landmarks3D[name] for name in names])
        projected = solution.ProjectPoints(jaw, points)
        errors = np.linalg.norm(projected - np.array([true.landmarks2D[name] for name in names]), axis=1)
        # Documentation/Robust.md: ideal cases 0.1 px, worst 0.5.
        assert errors.mean() < 1.0
        matrix = solution.GetProjectionMatrix(jaw)
        rows = points @ matrix[:, :3].T + matrix[:, 3]
        assert np.allclose(rows[:, :2] / rows[:, 2:], projected, atol=1e-9)
        assert np.allclose(solution.GetGeometry(jaw).ProjectPoints(points), projected, atol=1e-6)
        dental = points @ solution.GetFrame(jaw)[:3, :3].T + solution.GetFrame(jaw)[:3, 3]
        assert np.allclose(solution.GetPoseTransform(jaw).TransformPoints(dental), projected, atol=1e-6)
        assert np.allclose(solution.ProjectPoint(jaw, points[0]), projected[0])


def test_solution_has_covariance_candidates_and_fit(ds, phantom, solution):
    point = next(iter(phantom.upper.landmarks3D.values()))
    covariance = solution.ComputeCovariance("upper", point)
    assert covariance.shape == (2, 2) and np.linalg.eigvalsh(covariance).min() > 0
    assert solution.GetPoseCovariance("upper").shape == (7, 7)
    candidates = solution.GetCandidates("upper")
    assert candidates[0].parameters == solution.GetPose("upper") and candidates[0].distance == 0.0
    assert [c.deviance for c in candidates] == sorted(c.deviance for c in candidates)
    assert solution.GetScore("upper") == candidates[0].score
    assert solution.GetFit("upper")["inlierShare"] > 0.9
    contour = solution.GetMovingContour("upper")
    assert contour.points.shape[0] == solution.GetMovingContourPoints("upper").shape[0]
    assert np.allclose(
        solution.ProjectPoints("upper", solution.GetMovingContourPoints("upper")), contour.points, atol=1e-3
    )
    assert len(solution.GetNoiseLevels("upper")) == 2 and len(solution.GetPriorTension("upper")) == 7
    assert "Converged" in solution.GetStopConditionDescription("upper") and solution.GetNumberOfEvaluations("upper") > 10


def test_solution_is_the_callers_own(ds, phantom, axes):
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    method.SetOptions(make_quick_options(ds))
    first = method.Execute(*inputs(phantom))
    pose = first.GetPose("upper")
    second = method.Execute(phantom.geometry, phantom.lower.mesh, phantom.lower.tracing)
    assert first.GetPose("upper") == pose and first is not second and not second.HasJaw("lower")


def test_a_pickled_solution_knows_which_jaw_the_other_placed(ds, phantom, axes):
    """The bite counts in such a jaw's uncertainty, and its verdict is by the middles of both sides."""
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    method.SetOptions(make_quick_options(ds))
    solution = method.Execute(phantom.geometry, phantom.upper.mesh, phantom.upper.tracing, phantom.lower.mesh, None)
    again = pickle.loads(pickle.dumps(solution))
    point = next(iter(phantom.lower.landmarks3D.values()))
    assert np.array_equal(again.ComputeCovariance("lower", point), solution.ComputeCovariance("lower", point))
    assert ds.RegistrationVerdict(again).lower == ds.RegistrationVerdict(solution).lower


def test_solution_and_options_pickle(ds, phantom, solution):
    other = pickle.loads(pickle.dumps(solution))
    assert pickle.dumps(other) == pickle.dumps(solution)
    point = next(iter(phantom.lower.landmarks3D.values()))
    for jaw in ("upper", "lower"):
        assert np.array_equal(other.ComputeCovariance(jaw, point), solution.ComputeCovariance(jaw, point))
        assert np.array_equal(other.GetMovingContour(jaw).points, solution.GetMovingContour(jaw).points)
        assert other.GetFit(jaw) == solution.GetFit(jaw)
        assert repr(other.GetCandidates(jaw)) == repr(solution.GetCandidates(jaw))
    assert ds.RegistrationVerdict(other) == ds.RegistrationVerdict(solution)
    options = ds.PoseRegistrationOptions()
    options.yawStarts, options.excludedTeeth, options.tracedSide, options.initialPose = [0.1], [11], "left", POSE
    copied = pickle.loads(pickle.dumps(options))
    assert copied.GetChanges() == options.GetChanges() == ["yawStarts=0.1"]
    assert copied.excludedTeeth == [11] and copied.tracedSide == ds.TracedSide.Left
    assert tuple(copied.initialPose) == POSE


def test_solution_of_one_jaw_says_what_the_other_lacks(ds, phantom):
    found = ds.PoseRegistration(phantom.geometry, phantom.upper.mesh, phantom.upper.tracing)
    assert found.IsRegistered("upper") and not found.HasJaw("lower") and not found.IsRegistered("lower")
    assert ds.RegistrationVerdict(found).lower is None
    with pytest.raises(ds.Error, match="lower jaw had no input"):
        found.GetPose("lower")
    with pytest.raises(ds.ArgumentError, match="Upper or Lower"):
        found.GetPose(ds.Jaw.Unknown)


def test_landmarks_have_the_solutions_places_and_covariances(ds, phantom, solution):
    landmarks = {**phantom.upper.landmarks3D, **phantom.lower.landmarks3D}
    projected = ds.LandmarkProjection(solution, landmarks)
    name = next(iter(phantom.upper.landmarks3D))
    assert set(projected.positions) == set(landmarks)
    assert np.array_equal(projected.positions[name], solution.ProjectPoint("upper", landmarks[name]))
    covariance = solution.ComputeCovariance("upper", landmarks[name])
    assert np.array_equal(projected.covariances[name], covariance)
    assert projected.sigmas[name] == pytest.approx(np.sqrt(0.5 * np.trace(covariance)))
    assert projected.middleCovariances
    metres = {key: point / 1000.0 for key, point in landmarks.items()}
    assert np.allclose(ds.LandmarkProjection(solution, metres, 1000.0).positions[name], projected.positions[name])


def test_matched_contour_is_part_of_the_moving_one(ds, phantom, solution):
    moving = solution.GetMovingContour("upper")
    matched = ds.MatchedContour(phantom.upper.tracing, moving)
    assert 0 < matched.GetNumberOfPoints() <= moving.GetNumberOfPoints()
    assert ds.MatchedContour(phantom.upper.tracing, moving, maximumDistance=1e-6).GetNumberOfPoints() == 0


def test_expected_error_is_the_mean_of_the_sigmas(ds, phantom, solution):
    process = ds.LandmarkProjectionFilter()
    landmarks = {**phantom.upper.landmarks3D, **phantom.lower.landmarks3D}
    found = process.Execute(solution, landmarks)
    of_upper = [sigma for name, sigma in found.sigmas.items() if name.startswith("U")]
    assert process.HasExpectedError("Upper")
    assert process.GetExpectedError("Upper") == pytest.approx(np.sqrt(np.pi / 2) * np.mean(of_upper))
    process.Execute(solution, {"UR1_tip": landmarks["UR1_tip"]})
    assert not process.HasExpectedError("Lower")
    with pytest.raises(ds.FilterError, match="HasExpectedError"):
        process.GetExpectedError("Lower")


def test_distances_of_teeth_are_those_of_their_points(ds):
    tracing = ds.Contour()
    tracing.AddPolyline([[1, 3], [2, 5]], "UR1")
    tracing.AddPolyline([[3, 2]], "UR2")
    process = ds.ContourDistanceFilter()
    process.SetDistance("PointToSegment")
    process.Execute(tracing, np.array([[0, 0], [10, 0]]))
    assert process.GetFixedToMovingDistancesByTooth() == {
        "UR1": {"count": 2, "mean": 4.0, "rms": pytest.approx(np.sqrt(17.0)), "maximum": 5.0},
        "UR2": {"count": 1, "mean": 2.0, "rms": 2.0, "maximum": 2.0},
    }


def test_traced_side_is_found_out_of_the_drawing(ds):
    stretches = [[0, 0], [1, 1], [2, 0]]
    both = ds.FindTracedSide({"UR3": stretches, "UL3": stretches}, {"LR6": stretches, "LL6": stretches})
    assert both.side == ds.TracedSide.Both and "both sides" in both.reason and both.leftOut == ()
    one = ds.FindTracedSide({"UR1": stretches, "UL1": stretches})
    assert one.side == ds.TracedSide.Right and one.leftOut == ("UL1",)
    assert [polyline.code for polyline in one.upper.polylines] == ["UR1"] and len(one.lower) == 0
    left = ds.FindTracedSide({"UR1": stretches, "UL1": stretches}, tracedSide="Left", tracedSideIsGiven=True)
    assert left.side == ds.TracedSide.Left and left.leftOut == ("UR1",) and left.reason == "it was given"
    assert ds.FindTracedSide(cephalometricLandmarks={"U1_tip": (3, 4)}).side == ds.TracedSide.Standard
    assert ds.FindTracedSide({"UR1": stretches}, codesHaveSides=False).side == ds.TracedSide.Standard


def test_similarity_of_a_pose_leaves_parallax(ds, phantom, axes, solution):
    found = ds.ProjectionSimilarity(solution, phantom.upper.mesh, axes.upperTransform)
    assert 0.0 < found.rms < 30.0 and found.transform.GetScale() == pytest.approx(1.0, abs=0.1)


def test_verdict_takes_thresholds(ds, solution):
    thresholds = ds.RegistrationVerdictThresholds()
    thresholds.suspectP90 = 1e-9
    verdict = ds.RegistrationVerdict(solution, thresholds=thresholds)
    assert verdict.status == "suspect"
    assert verdict.upper.findings and all(
        f.severity == "suspect" and f.code and f.text for f in verdict.upper.findings
    )


def test_scans_are_judged_before_a_registration(ds, phantom):
    meshes = (phantom.upper.mesh, phantom.lower.mesh)
    marks = {**phantom.upper.landmarks3D, **phantom.lower.landmarks3D}
    axes = ds.UMidlineDentalAxis(*meshes, requireArches=False)
    assert ds.ScanCheck(axes, *meshes, landmarks=marks) == ((), (), ())
    wrong = {**marks, "UR1_tip": (300.0, 0.0, 0.0)}
    found = ds.ScanCheck(axes, *meshes, landmarks=wrong)
    (finding,) = found.upper
    assert isinstance(finding, ds.RegistrationFinding) and found.lower == ()
    assert (finding.code, finding.severity, finding.limit, finding.unit) == ("landmarks-off-scan", "suspect", 3.0, "mm")
    assert finding.value > 100.0 and "UR1_tip" in finding.text
    with pytest.raises(ValueError, match="UMidlineDentalAxis"):
        ds.ScanCheck(axes._replace(frames=None), *meshes)


def test_middles_are_between_the_sides(ds, phantom, solution):
    process = ds.LandmarkProjectionFilter()
    marks = {**phantom.upper.landmarks3D, **phantom.lower.landmarks3D}
    process.Execute(solution, marks)
    middles = process.GetMiddles()
    places = ds.LandmarkProjection(solution, marks)[0]
    assert "U6_MB" in middles
    place, covariance = middles["U6_MB"]
    assert np.allclose(place, 0.5 * (np.array(places["UR6_MB"]) + np.array(places["UL6_MB"])))
    assert np.array_equal(covariance, process.GetMiddleCovariance("UR6_MB"))


def test_middles_of_points_that_were_found(ds, phantom, axes, solution):
    """Without landmarks of the scan, by the scan's shape: where these are, within what the covariance says."""
    found = ds.FindLandmarkCounterparts(
        {"U1_tip": (0, 0), "U6_MB": (0, 0)},
        upperMesh=phantom.upper.mesh,
        upperFrame=axes.upperTransform,
    )
    process = ds.LandmarkProjectionFilter()
    projected = process.Execute(solution, counterparts=found)
    assert projected.positions == {}
    middles = process.GetMiddles()
    assert list(middles) == ["U1_tip", "U6_MB"]
    assert set(process.GetMiddleSources().values()) == {"its place along the arch"}
    process.Execute(solution, phantom.upper.landmarks3D)
    clicked = process.GetMiddles()
    assert process.GetMiddleSources()["U6_MB"] == "landmarks_3d"
    for name, (place, covariance) in middles.items():
        # The pose is the same: what is left are the places on the scan, in the ellipse of 99 %.
        difference = np.subtract(place, clicked[name][0])
        assert difference @ np.linalg.solve(covariance, difference) < 9.21, name
        assert np.trace(covariance) > np.trace(clicked[name][1])
    # What was clicked goes before what was found.
    process.Execute(solution, phantom.upper.landmarks3D, counterparts=found)
    assert set(process.GetMiddleSources().values()) == {"landmarks_3d"}
    with pytest.raises(ds.ArgumentError, match="nothing to project"):
        process.Execute(solution)


def test_landmarks_alone_register_by_hand_as_the_case_does(ds, phantom, axes, solution):
    """Middles of tips and cusps where the tracing's registration has them, and no tracing."""
    meshes = (phantom.upper.mesh, phantom.lower.mesh)
    scan = {**phantom.upper.landmarks3D, **phantom.lower.landmarks3D}
    places = ds.LandmarkProjection(solution, scan)[0]
    marks = {}
    for jaw in "UL":
        for kind in ("1_tip", "6_MB"):
            right, left = (np.array(places[jaw + side + kind]) for side in "RL")
            marks[jaw + kind] = tuple(0.5 * (right + left))
    counterparts = ds.FindLandmarkCounterparts(
        marks,
        upperMesh=meshes[0],
        lowerMesh=meshes[1],
        upperFrame=axes.upperTransform,
        lowerFrame=axes.lowerTransform,
        scanLandmarks=scan,
    )
    assert set(counterparts) == set(marks)
    solution = ds.PoseRegistration(
        phantom.geometry,
        meshes[0],
        None,
        meshes[1],
        None,
        frames=axes,
        tracedSide="Standard",
        cephalometricLandmarks=marks,
        counterparts=counterparts,
    )
    case = ds.Case(
        *meshes,
        geometry=phantom.geometry,
        imageSize=phantom.imageSize,
        tracedSide="standard",
        cephalometricLandmarks=marks,
        landmarks3D=scan,
    )
    result = ds.register(case)
    found = ds.LandmarkProjection(solution, scan)[0]
    for jaw in result.jaws.values():
        for name, place in jaw.landmarks.items():
            assert np.allclose(found[name], place, atol=1e-9), name
    with pytest.raises(ValueError, match="FindLandmarkCounterparts"):
        ds.PoseRegistration(phantom.geometry, meshes[0], cephalometricLandmarks=marks)


def test_every_threshold_of_the_verdict_can_be_set(ds):
    header = ROOT / "Modules/Registration/PoseRegistration/include/itkRegistrationVerdict.h"
    body = re.search(r"struct Thresholds\n *{(.*?)\n *};", header.read_text(), re.S).group(1)
    names = re.findall(r"double\s+(\w+)\{", body)
    assert len(names) > 25
    thresholds = ds.RegistrationVerdictThresholds()
    for name in names:
        setattr(thresholds, name, getattr(thresholds, name) + 1.0)


def test_a_mirrored_picture_is_told_by_its_edges(ds):
    case = ds.DentalPhantomCase(3, numberOfTriangles=20000)
    drawn = (case.geometry, case.upper.tracing, case.lower.tracing)
    assert ds.PictureCheck(case.image, *drawn) == ds.PictureFindings((), ())
    found = ds.PictureCheck(np.asarray(case.image)[:, ::-1], *drawn)
    assert [finding.code for finding in found.findings] == ["picture"] and "mirrored" in found.findings[0].text
    assert "no picture" in ds.PictureCheck(None, *drawn).notCheckable[0]
    with pytest.raises(ds.Error, match=r"SetGeometry\(\)"):
        ds.PictureCheckFilter()._Update()


# How it is set up ------------------------------------------------------------------------------------------------------


def test_landmarks_of_a_view_may_be_a_file(ds, phantom, tmp_path):
    method = ds.PoseRegistrationMethod()
    (tmp_path / "frontal.json").write_text('{"UR1_tip": [10, 20], "UL1_tip": [14, 20]}')
    method.AddView(phantom.geometry, cephalometricLandmarks=tmp_path / "frontal.json", name="frontal")
    with pytest.raises(ds.InputError, match="nothing.json"):
        method.AddView(phantom.geometry, cephalometricLandmarks=tmp_path / "nothing.json", name="other")


def test_given_frames_are_those_that_are_estimated(ds, phantom, axes, solution):
    assert axes.jointTransform is not None
    estimated = ds.PoseRegistration(*inputs(phantom))
    # The origin of a frame differs by rounding.
    assert np.allclose(estimated.GetPose("upper"), solution.GetPose("upper"), atol=1e-9)
    lean = ds.UMidlineDentalAxis(phantom.upper.mesh, refineMidline=True, transformMeshes=False)
    assert lean.upper is None and lean.jointTransform is None and lean.upperTransform is not None
    method = ds.PoseRegistrationMethod()
    method.SetUpperFrame(axes.upperTransform)
    method.SetLowerFrame(axes.lowerTransform)
    separate = method.Execute(*inputs(phantom))
    assert not separate.GetJawsShareFrame() and not method.GetJawsShareFrame()
    assert separate.GetPose("upper") != separate.GetPose("lower")


def test_every_option_is_an_attribute_with_its_default(ds):
    options = ds.PoseRegistrationOptions()
    entries = options.GetEntries()
    assert len(entries) >= 40
    stub = pathlib.Path(ds.__file__).resolve().with_name("_core.pyi").read_text().partition("class PoseRegistrationOptions:")[2].partition("\nclass ")[0]
    for name, description in entries:
        prop = getattr(ds.PoseRegistrationOptions, name)
        assert isinstance(prop, property) and prop.__doc__ == description
        value = getattr(options, name)
        written = options.GetOption(name)
        if isinstance(value, bool):
            assert written == ("on" if value else "off")
        else:
            assert [float(part) for part in written.split(",")] == [float(v) for v in np.atleast_1d(value)]
        assert f"def {name}(self) -> " in stub
    assert options.GetChanges() == []


def test_every_option_can_be_set(ds):
    options = ds.PoseRegistrationOptions()
    for name, _ in options.GetEntries():
        value = getattr(options, name)
        changed = not value if isinstance(value, bool) else [0.5, 0.25] if isinstance(value, list) else value + 1
        setattr(options, name, changed)
        assert getattr(options, name) == changed
    assert len(options.GetChanges()) == len(options.GetEntries())
    options.SetOption("rollSigma=0.25")
    assert options.rollSigma == 0.25
    with pytest.raises(ds.ArgumentError, match="0.001 to"):
        options.SetOption("correlationLength=-1")
    with pytest.raises(AttributeError):
        options.rolSigma = 1.0
    other = copy.deepcopy(options)
    other.rollSigma = 0.5
    assert options.rollSigma == 0.25


def test_initial_transform_says_which_place_is_meant(ds, phantom, axes, solution):
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    method.SetInitialTransform("upper", solution.GetTransform("upper"), np.exp(solution.GetPose("upper")[6]))
    started = method.Execute(*inputs(phantom))
    assert np.allclose(started.GetPose("upper"), solution.GetPose("upper"), atol=1e-9)
    method.ClearInitialTransforms()
    assert method.Execute(*inputs(phantom)).GetPose("upper") == solution.GetPose("upper")


def test_hypotheses_are_what_was_added(ds, phantom, axes):
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    seen = []
    method.AddCommand(ds.sitkIterationEvent, lambda: seen.append(method.GetCurrentIteration().hypothesis))
    method.ClearHypotheses()
    method.Execute(*inputs(phantom))
    assert seen and not any(seen)
    method.AddHypothesis(ds.OtherSideHypothesis())
    solution = method.Execute(*inputs(phantom))
    assert any(seen)
    outcomes = solution.GetOutcomes("upper")
    assert list(outcomes) == ["other-side"] and outcomes["other-side"].deviance != 0.0
    assert 0.0 < outcomes["other-side"].score <= 1.0
    again = pickle.loads(pickle.dumps(solution)).GetOutcomes("upper")
    assert again["other-side"].deviance == outcomes["other-side"].deviance
    with pytest.raises(RuntimeError, match="ClearHypotheses"):
        method.AddHypothesis(ds.OtherSideHypothesis())
    assert solution.GetUntried("upper") == {}
    # Alone, beside the solution that stands: the same outcome, and the solution is not made anew.
    pose = solution.GetPose("upper")
    alone = method.TryHypothesis(ds.OtherSideHypothesis(), "lower")
    assert (alone.score, alone.deviance) == (outcomes["other-side"].score, outcomes["other-side"].deviance)
    facing = method.TryHypothesis(ds.OtherFacingHypothesis(), "upper")
    assert facing.score > solution.GetScore("upper") + 0.1
    assert solution.GetPose("upper") == pose and list(solution.GetOutcomes("upper")) == ["other-side"]
    assert ds.OtherFacingHypothesis().GetCode() == "facing"
    assert ds.ExchangedJawsHypothesis().GetCode() == "jaws-exchanged"
    assert ds.ExchangedLandmarksHypothesis().GetCode() == "landmarks-exchanged"
    assert ds.MillimetreLandmarksHypothesis().GetCode() == "landmarks-mm"
    assert ds.OtherSpacingHypothesis().GetCode() == "pixel-spacing"
    assert ds.UpwardDrawingHypothesis().GetCode() == "upward-drawing"
    turned = ds.TurnedDrawingHypothesis()
    turned.SetQuarterTurns(3)
    assert (turned.GetQuarterTurns(), turned.GetCode()) == (3, "turned-270")


def test_hypothesis_that_a_term_of_ones_own_forbids_says_so(ds, phantom, axes, HeightOfPoint):
    geometry, *rest = inputs(phantom)
    turned = copy.deepcopy(geometry)
    turned.SetFacing("left")
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    method.AddMetric(HeightOfPoint((0.0, 0.0, 0.0), 1.0, 50.0))
    solution = method.Execute(turned, *rest)
    others = {"pixel-spacing", "turned-90", "turned-180", "turned-270", "upward-drawing"}
    assert set(solution.GetOutcomes("upper")) == {"other-side", "facing"} | others
    assert "dental frame, which turns over" in solution.GetUntried("upper")["jaws-exchanged"]
    assert pickle.loads(pickle.dumps(solution)).GetUntried("upper") == solution.GetUntried("upper")
    with pytest.raises(RuntimeError, match="dental frame, which turns over"):
        method.TryHypothesis(ds.ExchangedJawsHypothesis(), "upper")


def test_ready_command_logs_any_registration(ds, phantom, axes):
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    method.ClearHypotheses()
    command = ds.RegistrationIterationCommand()
    command.Observe(method)
    steps = []
    method.AddCommand(ds.sitkIterationEvent, lambda: steps.append(method.GetCurrentIteration()))
    text = io.StringIO()
    command.SetStream(text)
    command.SetWriteEvery(1000)
    method.Execute(*inputs(phantom))
    kind = ds.RegistrationEventKind
    records = command.GetRecords()
    assert records[0].kind == kind.Start and records[-1].kind == kind.End and records[-1].stopReason
    assert sum(record.kind == kind.Level for record in records) == 4
    # A command of sitkIterationEvent hears of levels too.
    iterations = [record for record in records if record.kind == kind.Iteration]
    assert len(iterations) == len(steps) - 4
    assert {record.accepted for record in iterations} == {True, False}
    assert len(iterations[-1].parameters) == 7
    lines = text.getvalue().splitlines()
    assert lines[0] == "start" and lines[-1].startswith("end level 3") and len(lines) < len(iterations)
    table = command.GetTable().splitlines()
    assert table[0].startswith("level,candidate,iteration,value,step_length,accepted,p0")
    assert len(table) == len(iterations) + 1
    command.SetStream(None)
    with pytest.raises(TypeError):
        command.Observe(None)


def test_what_a_stream_raises_ends_the_run(ds, phantom, axes):
    class Full:
        def write(self, text):
            raise OSError("no space left")

    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    command = ds.RegistrationIterationCommand()
    command.SetStream(Full())
    command.Observe(method)
    with pytest.raises(OSError, match="no space left"):
        method.Execute(*inputs(phantom))


def test_a_term_may_be_of_one_jaw(ds, phantom, axes):
    options = ds.PoseRegistrationOptions()
    options.useJointPose = False
    options.checkHypotheses = False
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    method.SetOptions(options)
    plain = method.Execute(*inputs(phantom))
    prior = ds.ParameterPriorMetricv4()
    prior.SetBlock(ds.PoseStateBlocks.MakePose())
    prior.SetPriors([ds.ParameterPrior(0.0, np.inf)] * 4 + [ds.ParameterPrior(1.5, 0.02), ds.ParameterPrior(0.0, np.inf)])
    method.AddMetric(prior, "lower")
    solution = method.Execute(*inputs(phantom))
    assert solution.GetPose("upper") == plain.GetPose("upper")
    assert abs(solution.GetPose("lower")[4] - 1.5) < 0.05


def test_start_search_can_be_set(ds, phantom, axes, solution):
    search = ds.PoseStartSearch()
    search.SetShiftStep(6.0)
    search.SetKappas([0.0, -0.1, 0.1])
    assert search.GetKappas() == [0.0, -0.1, 0.1]
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    method.SetStart(search)
    assert np.allclose(method.Execute(*inputs(phantom)).GetPose("upper"), solution.GetPose("upper"), atol=0.05)


def test_spacing_source_is_the_prior_of_the_scale(ds, phantom, axes):
    kappas = []
    for source in ("given", "estimated"):
        method = ds.PoseRegistrationMethod()
        method.SetFrames(axes)
        method.SetSpacingSource(source)
        kappas.append(method.Execute(*inputs(phantom)).GetPriorTension("upper")[6])
    method.ClearSpacingSource()
    kappas.append(method.Execute(*inputs(phantom)).GetPriorTension("upper")[6])
    assert kappas[0] == kappas[2] != kappas[1]


def test_kernel_and_noise_model_are_objects(ds, phantom, axes, solution):
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    method.SetRobustKernel(ds.SquaresKernel())
    options = ds.PoseRegistrationOptions()
    options.useRobustKernel = False
    squares = method.Execute(*inputs(phantom)).GetPose("upper")
    assert squares == ds.PoseRegistration(*inputs(phantom), frames=axes, options=options).GetPose("upper")
    method.SetRobustKernel(None)
    white = ds.CorrelatedNoiseModel()
    white.SetCorrelationLength(0.0)
    method.SetCovarianceNoiseModel(white)
    other = method.Execute(*inputs(phantom))
    assert other.GetPose("upper") == solution.GetPose("upper")
    assert not np.array_equal(other.GetPoseCovariance("upper"), solution.GetPoseCovariance("upper"))
    method.SetNoiseModel(white)
    assert method.Execute(*inputs(phantom)).GetPose("upper") != solution.GetPose("upper")


@pytest.mark.parametrize("name", ["LBFGSB", "LBFGS2"])
def test_another_optimizer_ends_in_the_same_place(ds, phantom, axes, solution, name):
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    method.SetOptions(make_quick_options(ds))
    getattr(method, f"SetOptimizerAs{name}")()
    assert name in method.GetOptimizer().GetName()
    found = method.Execute(*inputs(phantom))
    points = list(phantom.upper.landmarks3D.values())
    difference = found.ProjectPoints("upper", points) - solution.ProjectPoints("upper", points)
    assert np.linalg.norm(difference, axis=1).mean() < 2.0


# While it runs --------------------------------------------------------------------------------------------------------


def test_commands_see_every_step_in_the_calling_thread(ds, phantom, axes):
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    optimizer = ds.LevenbergMarquardtOptimizerv4()
    method.SetOptimizer(optimizer)
    assert method.GetOptimizer() is optimizer
    steps, values, levels, threads = [], [], [], set()

    def watch():
        threads.add(threading.get_ident())
        steps.append(method.GetCurrentIteration())
        metric = method.GetMetric()
        if not steps[-1].hypothesis:
            assert np.allclose(metric.GetBlockValues("pose"), steps[-1].pose[:6])

    method.AddCommand(ds.sitkMultiResolutionIterationEvent, lambda: levels.append(method.GetCurrentLevel()))
    optimizer.AddCommand(ds.sitkIterationEvent, lambda: values.append(optimizer.GetCurrentMetricValue()))
    # A level is an iteration event as well: the steps alone come from the optimizer.
    method.AddCommand(ds.sitkIterationEvent, watch)
    method.Execute(*inputs(phantom))
    assert threads == {threading.get_ident()}
    assert levels == [0, 1, 2, 3] and method.GetNumberOfLevels() == 4
    step = next(step for step in steps if step.stage == ds.PoseStage.Refinement and step.accepted)
    assert step.level == 2 and len(step.pose) == 7 and step.value == step.trialValue > 0.0
    assert step.kernelWidth > 0.0 and step.smoothNoise > 0.0 and step.whiteNoise > 0.0 and step.stepLength > 0.0
    assert len(step.position) == 7 and step.iteration >= 1 and step.evaluations >= 1
    assert method.GetStepAccepted() in (True, False) and method.GetCurrentCandidate() >= 0
    assert {s.candidate for s in steps} > {0} and any(s.hypothesis for s in steps)
    assert len(values) == len(steps) - len(levels)
    assert "accepted" in repr(step)


def test_abort_in_a_command_ends_the_run(ds, phantom, axes):
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    count = []

    def stop():
        count.append(1)
        if len(count) == 5:
            method.Abort()

    number = method.AddCommand(ds.sitkIterationEvent, stop)
    with pytest.raises(ds.AbortedError):
        method.Execute(*inputs(phantom))
    assert len(count) == 5
    method.RemoveCommand(number)
    assert method.Execute(*inputs(phantom)).IsRegistered("upper")


def test_stop_in_a_command_of_the_optimizer_ends_the_run(ds, phantom, axes):
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    optimizer = ds.LevenbergMarquardtOptimizerv4()
    optimizer.AddCommand(ds.sitkIterationEvent, optimizer.StopOptimization)
    method.SetOptimizer(optimizer)
    with pytest.raises(ds.AbortedError):
        method.Execute(*inputs(phantom))


@pytest.mark.parametrize("of_the_optimizer", [False, True])
def test_exception_in_a_command_comes_out_unchanged(ds, phantom, axes, of_the_optimizer):
    class Mine(Exception):
        pass

    def fail():
        raise Mine("no")

    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    optimizer = ds.LevenbergMarquardtOptimizerv4()
    method.SetOptimizer(optimizer)
    (optimizer if of_the_optimizer else method).AddCommand(ds.sitkIterationEvent, fail)
    with pytest.raises(Mine, match="no"):
        method.Execute(*inputs(phantom))
    optimizer.RemoveAllCommands()
    method.RemoveAllCommands()
    assert method.Execute(*inputs(phantom)).IsRegistered("upper")


# The transform of a pose ------------------------------------------------------------------------------------------------


POSE = (0.2, 0.03, -0.05, 2.0, 1.0, -4.0, 0.02)


@pytest.fixture
def transform(ds):
    geometry = ds.CephalometricGeometry(pixelSpacing=(0.25, 0.24), principalPoint=(400.0, 300.0), facing="left")
    return ds.CephalometricPoseTransform(geometry, POSE)


def test_pose_transform_projects_as_its_geometry(ds, transform):
    placed = ds.CephalometricGeometry()
    transform.CopyToGeometry(placed)
    points = np.array([[30.0, 5.0, -4.0], [-10.0, -20.0, 3.0]])
    assert np.allclose(transform.TransformPoints(points), placed.ProjectPoints(points), atol=1e-9)
    assert np.allclose(transform.TransformPoint(points[0]), transform.TransformPoints(points)[0])
    assert transform.GetScaleFactor() == pytest.approx(np.exp(0.02))
    rigid = transform.GetRigidTransform()
    assert np.allclose(rigid.matrix[:3, 3], POSE[3:6])
    other = ds.CephalometricPoseTransform()
    other.SetGeometry(ds.CephalometricGeometry(pixelSpacing=0.25))
    other.SetParametersFromRotation(rigid.matrix[:3, :3], POSE[3:6], 0.02)
    assert np.allclose(other.GetParameters(), POSE)


def test_jacobians_of_a_pose_transform_are_its_differences(transform):
    point = np.array([30.0, 5.0, -4.0])
    by_parameters = transform.ComputeJacobianWithRespectToParameters(point)
    by_position = transform.ComputeJacobianWithRespectToPosition(point)
    assert by_parameters.shape == (2, 7) and by_position.shape == (2, 3)
    for k in range(7):
        places = []
        for step in (-1e-6, 1e-6):
            transform.SetParameters(np.array(POSE) + step * np.eye(7)[k])
            places.append(np.array(transform.TransformPoint(point)))
        assert np.allclose((places[1] - places[0]) / 2e-6, by_parameters[:, k], rtol=1e-6, atol=1e-4)
    transform.SetParameters(POSE)
    for d in range(3):
        moved = [np.array(transform.TransformPoint(point + step * np.eye(3)[d])) for step in (-1e-6, 1e-6)]
        assert np.allclose((moved[1] - moved[0]) / 2e-6, by_position[:, d], rtol=1e-6, atol=1e-4)


def test_pose_transform_is_kept_whole(ds, transform, tmp_path):
    for other in (copy.copy(transform), copy.deepcopy(transform), pickle.loads(pickle.dumps(transform))):
        assert other == transform and other is not transform
    ds.WriteTransform(transform, tmp_path / "pose.tfm")
    assert ds.ReadTransform(tmp_path / "pose.tfm") == transform
    # Files from before there were frontal radiographs have no direction: they are of lateral ones.
    text = (tmp_path / "pose.tfm").read_text()
    (tmp_path / "lateral.tfm").write_text(text.rstrip().removesuffix(" 0") + "\n")
    assert len((tmp_path / "lateral.tfm").read_text()) < len(text)
    assert ds.ReadTransform(tmp_path / "lateral.tfm") == transform
    assert pickle.loads(pickle.dumps(ds.CephalometricPoseTransform())).GetParameters() == (0.0,) * 7


@pytest.mark.parametrize("package, convert", [("SimpleITK", "to_sitk"), ("itk", "to_itk")])
def test_pose_transform_has_no_counterpart_elsewhere(ds, transform, package, convert):
    pytest.importorskip(package)
    with pytest.raises(TypeError, match="no counterpart"):
        getattr(ds, convert)(transform)


def test_pose_transform_without_geometry_says_what_to_call(ds):
    empty = ds.CephalometricPoseTransform()
    with pytest.raises(ds.Error, match="SetGeometry"):
        empty.TransformPoint((0.0, 0.0, 0.0))
    with pytest.raises(ds.Error, match="SetPixelSpacing"):
        empty.SetGeometry(ds.CephalometricGeometry())
    with pytest.raises(ds.Error):
        empty.SetParameters([0.0] * 6)
    with pytest.raises(ds.Error):
        empty.SetFixedParameters([1.0] * 8)


# Metrics by hand ------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def Line(ds):
    class Line(ds.LeastSquaresMetric):
        """y = a + b x through points, with or without derivatives."""

        def __init__(self, x, y, derivatives=None):
            super().__init__()
            self.x, self.y, self.derivatives, self.calls = np.asarray(x), np.asarray(y), derivatives, 0

        def blocks(self):
            return ds.StateBlock("line", [ds.StateParameter("a"), ds.StateParameter("b", 1.0, scale=10.0)])

        def residuals(self, values):
            self.calls += 1
            a, b = values["line"]
            return a + b * self.x - self.y

        def jacobian(self, values):
            both = np.c_[np.ones_like(self.x), self.x]
            return {None: None, "dict": {"line": both}, "array": both}[self.derivatives]

    return Line


@pytest.fixture
def points():
    x = np.linspace(-1.0, 2.0, 7)
    return x, 0.5 - 2.0 * x + 0.1 * np.sin(5.0 * x)


@pytest.mark.parametrize("derivatives", [None, "dict", "array"])
def test_own_metric_is_minimized(ds, Line, points, derivatives):
    metric = Line(*points, derivatives)
    metric.Initialize()
    assert metric.GetNumberOfParameters() == 2 and metric.GetNumberOfResiduals() == 7
    assert np.array_equal(metric.GetParameters(), [0.0, 10.0])
    optimizer = ds.LevenbergMarquardtOptimizerv4()
    optimizer.SetMetric(metric)
    values = []
    optimizer.AddCommand(ds.sitkIterationEvent, lambda: values.append(optimizer.GetCurrentMetricValue()))
    optimizer.StartOptimization()
    b, a = np.polyfit(*points, 1)
    assert np.allclose(metric.GetBlockValues("line"), [a, b], atol=1e-6)
    assert np.allclose(optimizer.GetCurrentPosition(), [a, 10.0 * b], atol=1e-5)
    assert values == sorted(values, reverse=True) and optimizer.HasConverged()
    assert optimizer.GetStopCondition() in (ds.StopCondition.StepTolerance, ds.StopCondition.ValueTolerance)


def test_own_metric_has_value_derivative_and_residuals(ds, Line, points):
    metric = Line(*points)
    metric.SetBlockValues("line", [0.3, -1.0])
    metric.Initialize()
    residuals, jacobian = metric.GetResidualsAndJacobian()
    assert np.allclose(residuals, 0.3 - points[0] - points[1])
    # By the optimizer's parameters: the slope is ten times as large there.
    assert np.allclose(jacobian, np.c_[np.ones(7), points[0] / 10.0], atol=1e-7)
    value, derivative = metric.GetValueAndDerivative()
    assert value == metric.GetValue() == pytest.approx(residuals @ residuals)
    assert np.allclose(derivative, -2.0 * jacobian.T @ residuals) and np.allclose(metric.GetDerivative(), derivative)
    metric.SetParameters([0.1, 5.0])
    assert np.allclose(metric.GetValues(), [0.1, 0.5])
    metric.SetBlockFree("line", [True, False])
    assert metric.GetNumberOfParameters() == 1 and metric.GetFreeIndices() == [0]
    with pytest.raises(ds.ArgumentError, match="1 free parameters, not 2"):
        metric.SetParameters([0.1, 5.0])
    metric.SetBlockFree("line", False)
    with pytest.raises(ds.Error, match="SetBlockFree"):
        metric.Initialize()


def test_clones_share_the_python_object(Line, points):
    metric = Line(*points)
    metric.Initialize()
    calls = metric.calls
    clone = metric.Clone()
    clone.SetBlockValues("line", [5.0, 5.0])
    clone.GetValue()
    assert metric.calls == calls + 1 and np.array_equal(metric.GetBlockValues("line"), [0.0, 1.0])


def test_own_metric_lives_as_long_as_what_holds_it_and_no_longer(ds, Line, points):
    total = ds.LeastSquaresSumMetricv4()
    total.AddMetric(Line(*points))
    gc.collect()
    total.Initialize()
    assert total.GetValue() > 0.0 and type(total.GetMetric(0)).__name__ == "Line"
    watcher = weakref.ref(total.GetMetric(0))
    gc.collect()
    assert watcher() is not None
    clone = total.Clone()
    del total
    gc.collect()
    assert clone.GetValue() > 0.0
    del clone
    gc.collect()
    assert watcher() is None


def test_collector_may_come_while_an_own_metric_is_made(ds):
    thresholds = gc.get_threshold()
    gc.set_threshold(1)
    try:
        for _ in range(10):
            # The first object of a class is where pybind11 looks into the class.
            class Mine(ds.LeastSquaresMetric):
                def blocks(self):
                    return "scale"

                def residuals(self, values):
                    return values["scale"]

            metric = Mine()
            metric.Initialize()
            assert metric.GetValue() == 0.0
    finally:
        gc.set_threshold(*thresholds)


@pytest.mark.parametrize(
    "method, answer, error, words",
    [
        ("residuals", "text", TypeError, "array of numbers"),
        ("residuals", [1.0, float("nan")], ValueError, "finite"),
        ("residuals", np.zeros((2, 2)), ValueError, "one dimension"),
        ("jacobian", np.zeros((7, 3)), ValueError, "a row a residual"),
        ("jacobian", {"lime": np.zeros((7, 2))}, ValueError, "does not name"),
        ("jacobian", {"line": np.full((7, 2), np.inf)}, ValueError, "finite"),
        ("blocks", ["posse"], ValueError, "StateBlock"),
        ("blocks", [3], TypeError, "StateBlock"),
        ("blocks", 3, TypeError, "iterable"),
    ],
)
def test_own_metric_that_returns_nonsense_is_told_so(ds, Line, points, method, answer, error, words):
    metric = Line(*points)
    setattr(metric, method, lambda *values: answer)
    with pytest.raises(error, match=words):
        metric.Initialize()
        metric.GetResidualsAndJacobian()


def test_own_metric_keeps_its_number_of_residuals(Line, points):
    metric = Line(*points)
    metric.Initialize()
    metric.GetValue()
    metric.x, metric.y = metric.x[:3], metric.y[:3]
    with pytest.raises(ValueError, match="7 residuals before and gives 3 now"):
        metric.GetValue()
    metric.Initialize()
    assert metric.GetNumberOfResiduals() == 3


def test_own_metric_without_its_methods_says_which(ds):
    class Empty(ds.LeastSquaresMetric):
        pass

    with pytest.raises(NotImplementedError, match="Empty needs blocks"):
        Empty().Initialize()

    class Forgetful(ds.LeastSquaresMetric):
        def __init__(self):
            pass

    with pytest.raises(TypeError, match="__init__"):
        Forgetful().Initialize()


def test_exception_in_an_own_metric_leaves_the_optimizer_at_its_best(ds, Line, points):
    class Mine(Exception):
        pass

    metric = Line(*points)

    def residuals(values):
        if values["line"][1] < 0.0:
            raise Mine("no")
        return Line.residuals(metric, values)

    metric.residuals = residuals
    metric.Initialize()
    optimizer = ds.LevenbergMarquardtOptimizerv4()
    optimizer.SetMetric(metric)
    with pytest.raises(Mine, match="no"):
        optimizer.StartOptimization()
    assert np.array_equal(metric.GetBlockValues("line"), [0.0, 1.0])
    assert optimizer.GetStopCondition() == ds.StopCondition.Exception


def test_prior_pulls_towards_its_mean(ds, Line, points):
    metric = Line(*points)
    block = metric.GetBlocks()[0]
    prior = ds.ParameterPriorMetricv4()
    prior.SetBlock(block)
    prior.SetPriors([ds.ParameterPrior(), ds.ParameterPrior(3.0, 1e-4)])
    assert prior.GetBlock().name == "line" and prior.GetPriors()[1].mean == 3.0
    total = ds.LeastSquaresSumMetricv4()
    total.AddMetric(metric)
    total.AddMetric(prior)
    total.Initialize()
    assert total.GetNumberOfResiduals() == 9 and [b.name for b in total.GetBlocks()] == ["line"]
    optimizer = ds.LevenbergMarquardtOptimizerv4()
    optimizer.SetMetric(total)
    optimizer.StartOptimization()
    assert total.GetBlockValues("line")[1] == pytest.approx(3.0, abs=1e-4)
    total.RemoveMetric(prior)
    total.Initialize()
    optimizer.StartOptimization()
    assert total.GetBlockValues("line")[1] == pytest.approx(np.polyfit(*points, 1)[0], abs=1e-6)


def test_metrics_that_are_not_ready_say_what_to_call(ds):
    for metric, words in (
        (ds.SilhouettePoseMetricv4(), "Initialize"),
        (ds.LeastSquaresSumMetricv4(), "Initialize"),
        (ds.ParameterPriorMetricv4(), "Initialize"),
    ):
        for call in (
            metric.GetValue, metric.GetDerivative, metric.GetResiduals, metric.GetResidualsAndJacobian,
            metric.GetNumberOfResiduals, metric.EstimateNoise, lambda: metric.Hold("Matches"),
        ):
            with pytest.raises(ds.Error, match=words):
                call()
        with pytest.raises(ds.Error):
            metric.Initialize()
        with pytest.raises(ds.Error):
            metric.SetValues([1.0, 2.0])
        assert metric.GetName() and str(metric)
    prior = ds.ParameterPriorMetricv4()
    prior.SetBlock(ds.PoseStateBlocks.MakeScale())
    prior.SetPriors([ds.ParameterPrior()] * 300)
    with pytest.raises(ds.Error, match="SetPriors"):
        prior.GetValue()
    with pytest.raises(ds.Error, match="No metric"):
        ds.LevenbergMarquardtOptimizerv4().StartOptimization()


def test_what_has_no_residuals_is_told_where_it_goes(ds):
    between_contours = ds.ContourChamferMetricv4()
    for call in (ds.LevenbergMarquardtOptimizerv4().SetMetric, ds.PoseRegistrationMethod().AddMetric):
        with pytest.raises(TypeError, match=r"a LeastSquaresMetric of your own.* ContourChamferMetricv4 has none.*"
                                            r"SilhouetteToContourRegistrationMethod\.SetMetric\(\)"):
            call(between_contours)
    with pytest.raises(TypeError, match=r"ContourChamferMetricv4 is no optimizer.*SetOptimizerAsLBFGSB\(\)"):
        ds.PoseRegistrationMethod().SetOptimizer(between_contours)


@pytest.fixture
def silhouettes(ds, phantom, axes):
    """The terms of both jaws, in their common frame."""
    transform = ds.CephalometricPoseTransform(phantom.geometry)
    frame = axes.jointTransform
    terms = []
    for jaw, given in (("upper", phantom.upper), ("lower", phantom.lower)):
        mesh = ds.Mesh(frame.TransformPoints(given.mesh.points), given.mesh.triangles)
        metric = ds.SilhouettePoseMetricv4()
        metric.SetTransform(transform)
        metric.SetMovingMesh(mesh)
        metric.SetFixedContour(given.tracing)
        metric.SetJaw(jaw)
        terms.append(metric)
    return terms


def test_sum_by_hand_ends_where_the_registration_does(ds, phantom, axes, silhouettes, solution):
    total = ds.LeastSquaresSumMetricv4()
    for metric in silhouettes:
        total.AddMetric(metric)
    prior = ds.ParameterPriorMetricv4()
    prior.SetBlock(ds.PoseStateBlocks.MakePose())
    options = ds.PoseRegistrationOptions()
    nothing = float("inf")
    prior.SetPriors(
        [
            ds.ParameterPrior(sigma=sigma, degreesOfFreedom=freedom)
            for sigma, freedom in (
                (nothing, 0), (options.rollSigma, 4), (options.yawSigma, 4), (nothing, 0), (options.tySigma, 0), (nothing, 0),
            )
        ]
    )
    scale = ds.ParameterPriorMetricv4()
    scale.SetBlock(ds.PoseStateBlocks.MakeScale())
    scale.SetPriors([ds.ParameterPrior(sigma=options.kappaSigma)])
    total.AddMetric(prior)
    total.AddMetric(scale)
    total.SetNoiseLevels(options.initialSmoothSigma, options.initialWhiteSigma)
    assert total.GetNoiseLevels() == (options.initialSmoothSigma, options.initialWhiteSigma)
    # From a pose that is 4 degrees and 3 mm off.
    pose = np.array(solution.GetPose("upper"))
    total.SetBlockValues("pose", pose[:6] + [0.07, 0.0, 0.0, 3.0, 0.0, -3.0])
    total.Initialize()
    start = total.GetValues()
    optimizer = ds.LevenbergMarquardtOptimizerv4()
    optimizer.SetMetric(total)
    # As a similarity first, as the registration does.
    total.SetBlockFree("pose", [True, False, False, True, False, True])
    for width in (10.0, 8.0, 6.0, 5.0, 4.0):
        total.SetKernelWidth(width)
        total.UpdateNoiseCorrelation()
        optimizer.StartOptimization()
    total.SetBlockFree("pose", True)
    assert total.GetNumberOfParameters() == 7
    total.SetKernelWidth(3.0)
    for _ in range(4):
        deviance = total.EstimateNoise()
        optimizer.StartOptimization()
    assert optimizer.HasConverged()
    # The registration refines many starts, and others: one alone ends near its solution.
    points = axes.jointTransform.TransformPoints(list(phantom.upper.landmarks3D.values()))
    expected = solution.GetPoseTransform("upper").TransformPoints(points)
    errors = [
        np.linalg.norm(ds.CephalometricPoseTransform(phantom.geometry, x).TransformPoints(points) - expected, axis=1)
        for x in (start, total.GetValues())
    ]
    assert errors[0].mean() > 10.0 and errors[1].max() < 2.0
    # The tracing of an ideal phantom has no noise to speak of.
    assert np.isfinite(deviance) and 0.0 < max(total.GetNoiseLevels()) < options.initialSmoothSigma


def test_landmarks_alone_determine_a_pose(ds, phantom, axes):
    frame = axes.jointTransform
    moving = {name: frame.TransformPoint(point) for name, point in phantom.upper.landmarks3D.items()}
    true = ds.CephalometricPoseTransform(phantom.geometry, (0.2, 0.02, 0.04, -1.0, 0.0, 0.5, 0.0))
    metric = ds.LandmarkPoseMetricv4()
    metric.SetTransform(ds.CephalometricPoseTransform(phantom.geometry))
    metric.SetMovingLandmarks(moving)
    metric.SetFixedLandmarks({name: true.TransformPoint(point) for name, point in moving.items()} | {"LR1_tip": (0, 0)})
    metric.SetSigma(0.5)
    metric.SetCovariance("UR1_tip", np.eye(2))
    metric.SetBlockFree("scale", False)
    metric.Initialize()
    assert sorted(metric.GetMatchedNames()) == sorted(moving)
    assert metric.GetNumberOfResiduals() == 2 * len(moving) and metric.GetPoseBlock() == "pose"
    optimizer = ds.LevenbergMarquardtOptimizerv4()
    optimizer.SetMetric(metric)
    optimizer.StartOptimization()
    assert metric.GetValue() < 1e-6
    places = ds.CephalometricPoseTransform(phantom.geometry, metric.GetValues()).TransformPoints(list(moving.values()))
    assert np.allclose(places, true.TransformPoints(list(moving.values())), atol=1e-3)
    with pytest.raises(ValueError, match="2 x 2"):
        metric.SetCovariance("UR1_tip", [1.0, 1.0])


def test_outlines_of_whole_teeth_alone_determine_a_pose(ds):
    case = ds.DentalPhantomCase(3, "standard", makeRadiograph=False)
    frame = ds.UMidlineDentalAxis(case.upper.mesh, case.lower.mesh, refineMidline=True).jointTransform
    found = ds.FindToothCrowns(
        upperContour=case.upper.tracing,
        lowerContour=case.lower.tracing,
        upperMesh=case.upper.mesh,
        lowerMesh=case.lower.mesh,
        upperFrame=frame,
        lowerFrame=frame,
        scanLandmarks={**case.upper.landmarks3D, **case.lower.landmarks3D},
    )
    crowns = {name: crown._replace(points=frame.TransformPoints(crown.points)) for name, crown in found.items()}
    total = ds.LeastSquaresSumMetricv4()
    terms = []
    for jaw, given in (("upper", case.upper), ("lower", case.lower)):
        metric = ds.ToothOutlinePoseMetricv4()
        metric.SetTransform(ds.CephalometricPoseTransform(case.geometry))
        with pytest.raises(ds.Error, match=r"SetCrowns\(\)|SetFixedContour\(\)"):
            metric.Initialize()
        metric.SetCrowns(crowns)
        metric.SetFixedContour(given.tracing)
        metric.SetJaw(jaw)
        terms.append(metric)
        total.AddMetric(metric)
    prior = ds.ParameterPriorMetricv4()
    prior.SetBlock(ds.PoseStateBlocks.MakePose())
    # What one side's outlines hardly tell: roll, yaw, shift across the picture.
    sigmas = [np.inf, 0.05, 0.05, np.inf, 1.0, np.inf]
    prior.SetPriors([ds.ParameterPrior(0.0, sigma) for sigma in sigmas])
    total.AddMetric(prior)
    total.SetBlockFree("scale", False)
    # True marks of the right side give the pose; half a degree of tip and two millimetres are put beside it.
    marks = ds.LandmarkPoseMetricv4()
    marks.SetTransform(ds.CephalometricPoseTransform(case.geometry))
    marks.SetMovingLandmarks(
        {name: frame.TransformPoint(point) for name, point in case.upper.landmarks3D.items()}
    )
    marks.SetFixedLandmarks(case.upper.landmarks2D)
    marks.SetBlockFree("scale", False)
    marks.Initialize()
    optimizer = ds.LevenbergMarquardtOptimizerv4()
    optimizer.SetMetric(marks)
    optimizer.StartOptimization()
    total.SetBlockValues("pose", np.array(marks.GetBlockValues("pose")) + [0.01, 0.0, 0.0, 1.5, 0.0, -1.5])
    total.Initialize()
    assert terms[0].GetFailure() == "" and terms[0].GetOutlinedTeeth()

    def outlines():
        # The sum owns the state: a term by itself is where it is put.
        for term in terms:
            term.SetBlockValues("pose", total.GetBlockValues("pose"))
        return [residual for term in terms for residual in term.GetOutlineResiduals()]

    before = [np.linalg.norm(residual.shift) for residual in outlines()]
    optimizer.SetMetric(total)
    for _ in range(3):
        total.UpdateNoiseCorrelation()
        optimizer.StartOptimization()
    residuals = outlines()
    after = [np.linalg.norm(residual.shift) for residual in residuals]
    assert np.mean(after) < 0.5 * np.mean(before)
    assert all(residual.crown.shape[1] == 2 and 0.0 <= residual.weight <= 1.0 for residual in residuals)


@pytest.mark.parametrize(
    "name", ["SilhouettePoseMetricv4", "LandmarkPoseMetricv4", "ToothOutlinePoseMetricv4", "ViewPoseMetricv4",
             "ParameterPriorMetricv4", "LeastSquaresSumMetricv4"]
)
def test_a_metric_that_is_not_prepared_says_what_to_call(ds, name):
    """Each ended the process or not, as what it read first was there or not."""
    for call in ("GetValue", "GetValueAndDerivative", "GetResiduals", "Initialize"):
        with pytest.raises((ds.Error, ValueError), match=r"Initialize\(\)|Set\w+\(\)|AddMetric\(\)"):
            getattr(getattr(ds, name)(), call)()


def test_errors_of_outlines_are_taken_and_given_back(ds):
    metric = ds.ToothOutlinePoseMetricv4()
    errors = metric.GetErrors()
    assert errors.along == 0.52 and errors.across == 0.70
    errors.along = 0.8
    metric.SetErrors(errors)
    assert metric.GetErrors().along == 0.8 and ds.ToothOutlineErrors().along == 0.52
    metric.SetMaximumCutSigma(1.0)
    assert metric.GetMaximumCutSigma() == 1.0


def test_a_term_of_another_view_moves_with_the_body_and_by_itself(ds):
    places = {
        "UR1_tip": (24.0, -4.0, 1.0),
        "UR3_cusp": (18.0, -14.0, 0.0),
        "UR5_B": (2.0, -20.0, -1.0),
        "UR6_MB": (-18.0, -25.0, 2.0),
        "UL1_tip": (24.5, 4.0, 1.0),
        "UL6_MB": (-17.0, 25.0, 1.5),
    }
    geometry = ds.CephalometricGeometry(direction="Frontal", pixelSpacing=0.25, principalPoint=(500.0, 400.0))
    term = ds.LandmarkPoseMetricv4()
    term.SetTransform(ds.CephalometricPoseTransform(geometry))
    view = ds.ViewPoseMetricv4()
    with pytest.raises(ds.Error, match=r"SetTerm\(\)"):
        view.Initialize()
    view.SetTerm(term)
    view.SetView("frontal")
    assert view.GetView() == "frontal" and isinstance(view.GetTerm(), ds.LandmarkPoseMetricv4)
    term.SetMovingLandmarks(places)
    true = (0.05, -0.03, 0.08, 1.0, 2.0, -1.0, 0.01)
    seen = ds.CephalometricPoseTransform(geometry, true)
    term.SetFixedLandmarks({name: seen.TransformPoint(point) for name, point in places.items()})
    names = [block.name for block in view.GetBlocks()]
    assert names[0] == "pose" and len(names) == 3 and all("frontal" in name for name in names[1:])
    # The body stays where it is: the head has moved for the view.
    view.SetBlockFree("pose", False)
    view.Initialize()
    assert view.GetNumberOfResiduals() == 12
    optimizer = ds.LevenbergMarquardtOptimizerv4()
    optimizer.SetMetric(view)
    optimizer.StartOptimization()
    assert view.GetValue() < 1e-6
    assert np.allclose(view.GetBlockValues("pose"), 0.0)
    found = ds.CephalometricPoseTransform(geometry, view.GetTermValues())
    points = list(places.values())
    assert np.allclose(found.TransformPoints(points), seen.TransformPoints(points), atol=1e-3)


def test_gradient_of_a_silhouette_is_that_of_its_differences(silhouettes, solution):
    metric = silhouettes[0]
    metric.SetBlockValues("pose", np.array(solution.GetPose("upper"))[:6] + [0.0, 0.0, 0.0, 0.3, 0.0, 0.3])
    metric.SetBlockFree("pose", [False, False, False, True, False, True])
    metric.SetBlockFree("scale", False)
    metric.Initialize()
    assert metric.GetFit()[0]["inlierShare"] > 0.5
    start = metric.GetParameters()
    # Matches that move on their own jump from point to point of an outline with corners.
    metric.Hold("Matches")
    metric.GetValue()
    gradient = -metric.GetDerivative()
    assert gradient.shape == start.shape == (2,)
    for k in range(2):
        values = []
        for step in (-1e-3, 1e-3):
            metric.SetParameters(start + step * np.eye(2)[k])
            values.append(metric.GetValue())
        # Of second order, and of a function without jumps.
        assert (values[1] - values[0]) / 2e-3 == pytest.approx(gradient[k], rel=1e-4, abs=1e-4 * np.linalg.norm(gradient))
    metric.Hold("Nothing")


def test_silhouette_takes_kernel_and_noise_model(ds, silhouettes):
    metric = silhouettes[0]
    metric.Initialize()
    robust = metric.GetValue()
    metric.SetRobustKernel(ds.SquaresKernel())
    squares = metric.GetValue()
    model = ds.CorrelatedNoiseModel()
    model.SetCorrelationLength(0.0)
    metric.SetNoiseModel(model)
    white = metric.GetValue()
    assert len({robust, squares, white}) == 3
    assert ds.GemanMcClureKernel().GetWeight(0.0, 3.0) == 1.0 and model.GetCorrelation(1.0) == 0.0


# In the registration --------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def HeightOfPoint(ds):
    class HeightOfPoint(ds.LeastSquaresMetric):
        """A point of the dental frame has a height in the cephalostat: z = z0 +- sigma mm."""

        def __init__(self, point, height, sigma):
            super().__init__()
            self.point, self.height, self.sigma = np.asarray(point), height, sigma
            self.threads = set()

        def blocks(self):
            return ["pose"]

        def residuals(self, values):
            self.threads.add(threading.get_ident())
            pitch, roll, yaw, tx, ty, tz = values["pose"]
            rotate = ds.CephalometricPoseTransform(parameters=[pitch, roll, yaw, tx, ty, tz, 0.0]).GetRigidTransform()
            return [(rotate.TransformPoint(self.point)[2] - self.height) / self.sigma]

    return HeightOfPoint


def test_own_metric_joins_the_registration(ds, phantom, axes, solution, HeightOfPoint):
    point = axes.jointTransform.TransformPoint(phantom.upper.landmarks3D["UR1_tip"])
    height = solution.GetPoseTransform("upper").GetRigidTransform().TransformPoint(point)[2]
    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    metric = HeightOfPoint(point, height + 2.0, 1e-3)
    method.AddMetric(metric)
    assert method.GetMetrics() == [metric]
    found = method.Execute(*inputs(phantom))
    assert metric.threads
    moved = found.GetPoseTransform("upper").GetRigidTransform().TransformPoint(point)[2]
    assert moved == pytest.approx(height + 2.0, abs=0.02)
    # One that agrees changes nothing to speak of.
    method.ClearMetrics()
    method.AddMetric(HeightOfPoint(point, height, 1.0))
    agreed = method.Execute(*inputs(phantom))
    assert np.allclose(agreed.GetPose("upper"), solution.GetPose("upper"), atol=0.02)
    method.ClearMetrics()
    assert method.Execute(*inputs(phantom)).GetPose("upper") == solution.GetPose("upper")


def test_own_metric_gives_the_same_bits_for_any_number_of_threads(ds, phantom, axes, HeightOfPoint):
    poses, threads = [], []
    for count in (1, 2, 5):
        method = ds.PoseRegistrationMethod()
        method.SetNumberOfWorkUnits(count)
        method.SetFrames(axes)
        metric = HeightOfPoint((0.0, 0.0, 0.0), 1.0, 0.5)
        method.AddMetric(metric)
        poses.append(method.Execute(*inputs(phantom)).GetPose("upper"))
        threads.append(len(metric.threads))
    assert poses[0] == poses[1] == poses[2]
    assert threads[0] == 1 and threads[2] > 1


def test_own_block_is_estimated_beside_the_pose(ds, phantom, axes):
    class Offset(ds.LeastSquaresMetric):
        def blocks(self):
            return ["scale", ds.StateBlock("offset", [ds.StateParameter("d")])]

        def residuals(self, values):
            return (values["offset"] - values["scale"] - 3.0) / 0.1

    method = ds.PoseRegistrationMethod()
    method.SetFrames(axes)
    method.AddMetric(Offset())
    found = method.Execute(*inputs(phantom))
    metric = method.GetMetric()
    assert found.IsRegistered("upper")
    assert metric.GetBlockValues("offset") == pytest.approx(3.0, abs=0.1) or "offset" in [b.name for b in metric.GetBlocks()]


@pytest.mark.parametrize("threads", [1, 4])
def test_exception_in_an_own_metric_comes_out_of_the_registration(ds, phantom, axes, HeightOfPoint, threads):
    class Mine(Exception):
        pass

    class Failing(HeightOfPoint):
        def residuals(self, values):
            if len(self.threads) >= (2 if threads > 1 else 1):
                raise Mine("no")
            return super().residuals(values)

    method = ds.PoseRegistrationMethod()
    method.SetNumberOfWorkUnits(threads)
    method.SetFrames(axes)
    method.AddMetric(Failing((0.0, 0.0, 0.0), 1.0, 0.5))
    with pytest.raises(Mine, match="no"):
        method.Execute(*inputs(phantom))
    method.ClearMetrics()
    assert method.Execute(*inputs(phantom)).IsRegistered("upper")


# The whole by hand ----------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def by_hand():
    path = pathlib.Path(__file__).resolve().parents[3] / "Examples" / "RobustByHand" / "robust_by_hand.py"
    spec = importlib.util.spec_from_file_location("robust_by_hand", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_robust_by_hand_has_the_bits_of_register(ds, sample, result, by_hand):
    description = json.loads((sample / "case.json").read_text())
    geometry = ds.CephalometricGeometry(
        pixelSpacing=description["cephalogram"]["pixel_spacing_mm"],
        principalPoint=description["geometry"]["principal_point_px"],
        sourceToMidsagittal=description["geometry"]["source_to_midsagittal_mm"],
        sourceToDetector=description["geometry"]["source_to_detector_mm"],
        sourceSide=description["geometry"]["source_side"],
        facing=description["cephalogram"]["facing"],
    )
    names = ("upper", "lower", "contours", "landmarks_3d")
    _, solution, verdict, landmarks = by_hand.robust_by_hand(*(sample / description[name] for name in names), geometry)
    for jaw in ("upper", "lower"):
        registered = result.jaws[jaw]
        assert registered.landmarks and registered.landmark_covariance
        for name, place in registered.landmarks.items():
            assert np.array_equal(landmarks.positions[name], place), name
            assert np.array_equal(landmarks.covariances[name], registered.landmark_covariance[name]), name
        assert np.array_equal(solution.GetProjectionMatrix(jaw), registered.P_pixel_from_mesh)
        assert getattr(verdict, jaw).status == registered.status
        assert getattr(verdict, jaw).reasons == registered.reasons


def test_outline_in_place_of_a_scan_registers_by_a_similarity(ds):
    center = np.array([400.0, 300.0])
    geometry = ds.CephalometricGeometry(pixelSpacing=(0.25, 0.25), principalPoint=tuple(center))
    transform = ds.CephalometricPoseTransform(geometry)
    part = np.linspace(0.0, 1.0, 250)
    outline = center + np.c_[160.0 - 320.0 * part, 45.0 * np.cos(2.8 * part) + 9.0 * np.abs(np.sin(7.0 * np.pi * part))]
    angle, scale, shift = 0.04, 1.03, (9.0, -6.0)
    turn = scale * np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    # Half of the outline was traced.
    tracing = center + (outline[60:190:3] - center) @ turn.T + shift
    metric = ds.SilhouettePoseMetricv4()
    metric.SetTransform(transform)
    metric.SetMovingContour(outline)
    metric.SetFixedContour(tracing)
    metric.SetReverseWeight(0.3)
    metric.GateByToothOn()
    assert metric.GetReverseWeight() == 0.3 and metric.GetGateByTooth()
    metric.SetBlockFree("pose", [True, False, False, True, False, True])
    optimizer = ds.LevenbergMarquardtOptimizerv4()
    optimizer.SetMetric(metric)
    for width in (20.0, 12.0, 8.0, 5.0, 3.0):
        metric.SetKernelWidth(width)
        metric.Initialize()
        optimizer.StartOptimization()
    assert abs(metric.GetBlockValues("pose")[0]) == pytest.approx(angle, abs=2e-3)
    assert metric.GetBlockValues("scale")[0] == pytest.approx(np.log(scale), abs=2e-3)
    with pytest.raises(ds.Error, match="-1"):
        metric.SetReverseWeight(-1.0)
