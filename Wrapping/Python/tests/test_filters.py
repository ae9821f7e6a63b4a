"""Each step against what the phantom knows, and against the other ways to the same answer."""
import numpy as np
import pytest


@pytest.fixture(scope="module")
def jaws(ds):
    """Average jaws in the anatomical frame: x anterior, y left, z superior."""
    return ds.DentalPhantomMesh()


@pytest.fixture(scope="module")
def geometry(ds):
    return ds.CephalometricGeometry(pixelSpacing=0.25, principalPoint=(200.0, 300.0))


def test_axes_of_a_phantom_are_its_own(ds, jaws):
    axes = ds.UMidlineDentalAxis(jaws["upper"].mesh, jaws["lower"].mesh, refineMidline=True)
    for transform in (axes.upperTransform, axes.lowerTransform):
        # An average pair has no irregularity: what is left is the pitch of the occlusal plane.
        cosines = np.diag(transform.matrix[:3, :3])
        assert cosines[1] > np.cos(np.radians(1.0)) and cosines.min() > np.cos(np.radians(8.0))
    moved = axes.upperTransform.TransformPoints(jaws["upper"].mesh.points)
    assert np.allclose(moved, axes.upper.points, atol=1e-4)


def test_axes_of_one_jaw_leave_the_other_empty(ds, jaws):
    axes = ds.UMidlineDentalAxis(lower=jaws["lower"].mesh)
    assert axes.upper is None and axes.upperTransform is None and axes.lowerTransform is not None


def test_axis_filter_tells_widths_and_confidence(ds, jaws):
    process = ds.UMidlineDentalAxisFilter()
    process.Execute(jaws["upper"].mesh, jaws["lower"].mesh)
    assert 30 < process.GetArchWidth("upper") < 70 and process.GetConfidence("upper") > 0.5
    assert process.GetJawsAreInOneFrame()
    with pytest.raises(ds.ArgumentError, match="upper or the lower"):
        process.GetArchDepth("unknown")


def test_mirror_plane_of_a_symmetric_phantom(ds, jaws):
    plane = ds.MidsagittalPlane(jaws["upper"].mesh, jaws["lower"].mesh)
    assert abs(plane.normal[1]) > np.cos(np.radians(1.0)) and abs(plane.offset) < 0.3 and plane.inlierFraction > 0.9


def test_drr_of_a_scan_covers_its_exact_silhouette(ds, jaws, geometry):
    mesh = jaws["upper"].mesh
    drr = ds.SurfaceDRR(mesh, geometry, sigma=0.25, margin=3.0)
    exact = ds.MeshSilhouetteContour(mesh, geometry)
    traced = ds.SilhouetteContour(drr, levelValue=0.5)
    distances = ds.ContourDistance(exact, traced, distance="PointToSegment")
    # Rays graze the rim, so that half a shell lies up to two and a half widths, of 1 px, outside of it.
    assert distances.movingToFixed < 2.5
    first, size = np.array(drr.GetIndex()), np.array(drr.GetSize())
    assert (exact.points.min(axis=0) >= first).all() and (exact.points.max(axis=0) <= first + size - 1).all()


def test_drr_in_strips_is_the_same_bits(ds, jaws, geometry):
    process = ds.SurfaceDRRImageSource()
    process.SetSize((320, 400))
    whole = np.array(process.Execute(jaws["upper"].mesh, geometry))
    strips = list(process.ExecuteInStrips(jaws["upper"].mesh, geometry, 7))
    assert [strip.GetIndex()[1] for strip in strips] == [400 * i // 7 for i in range(7)]
    assert np.array_equal(np.concatenate([np.array(strip) for strip in strips]), whole)
    assert process.GetNumberOfProjections() <= 2


def test_earlier_pictures_stay_as_they_were(ds, jaws, geometry):
    process = ds.SurfaceDRRImageSource()
    process.SetSize((200, 200))
    first = process.Execute(jaws["upper"].mesh, geometry)
    before = np.array(first)
    process.SetDensity(3.0)
    second = process.Execute(jaws["upper"].mesh, geometry)
    assert np.array_equal(np.array(first), before)
    assert np.allclose(np.array(second), 3.0 * before)


def test_drr_of_several_scans_is_their_sum(ds, jaws, geometry):
    meshes = [jaws["upper"].mesh, jaws["lower"].mesh]
    both = np.array(ds.SurfaceDRR(meshes, geometry, size=(300, 400)))
    apart = [np.array(ds.SurfaceDRR(mesh, geometry, size=(300, 400))) for mesh in meshes]
    assert np.allclose(both, apart[0] + apart[1], atol=1e-3 * both.max())


def test_samples_of_a_silhouette_project_to_its_points(ds, jaws, geometry):
    process = ds.MeshSilhouetteContourSource()
    process.SetNumberOfPoints(200)
    contour = process.Execute(jaws["lower"].mesh, geometry)
    samples = process.GetSamples()
    assert np.allclose(geometry.ProjectPoints(samples.rim), contour.points, atol=1e-3)
    assert np.allclose(np.linalg.norm(samples.normals, axis=1), 1.0)


def test_label_map_becomes_contours_by_tooth(ds):
    labels = np.zeros((60, 80), np.uint8)
    labels[10:30, 10:25] = 11
    labels[10:30, 30:50] = 46
    contour = ds.SilhouetteContour(labels, content="ToothLabels")
    assert [polyline.code for polyline in contour.polylines] == ["UR1", "LR6"]
    # Half-way between pixel centres.
    assert contour.polylines[0].points.min() == 9.5 and contour.polylines[0].points[:, 0].max() == 24.5
    whole = ds.SilhouetteContour(labels, content="MergedLabels", largestPartOnly=False)
    assert len(whole) == 2 and whole.polylines[0].code == ""


def test_mask_keeps_the_stretches_that_run_through_it(ds):
    mask = np.zeros((20, 20))
    mask[:, 5:10] = 1
    line = ds.Contour([ds.Polyline(np.c_[np.arange(15.0), np.full(15, 3.0)], "UR1")])
    kept = ds.ContourMask(line, mask)
    assert len(kept) == 1 and kept.polylines[0].code == "UR1"
    assert list(kept.points[:, 0]) == [5, 6, 7, 8, 9]


def test_resampled_contour_has_equal_steps(ds):
    square = ds.Contour([ds.Polyline([[0, 0], [10, 0], [10, 10], [0, 10]], closed=True)])
    points = ds.ContourResample(square, numberOfPoints=40).points
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    assert len(points) == 40 and np.allclose(steps, 1.0)


def test_distances_of_two_lines(ds):
    a = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]
    b = [[0.0, 3.0], [1.0, 3.0]]
    figures = ds.ContourDistance(a, b)
    assert figures.movingToFixed == 3.0
    assert figures.fixedToMoving == pytest.approx((3 + 3 + 10**0.5) / 3)
    assert figures.hausdorff == pytest.approx(10**0.5)
    shifted = ds.ContourDistance(a, b, ds.Similarity2DTransform(translation=(0.0, -3.0)))
    assert shifted.movingToFixed == 0.0


def test_overlap_of_two_lines(ds):
    tracing = [[float(x), 2.0] for x in range(101)]
    outline = [[float(x), 0.0] for x in range(25, 251)]
    figures = ds.ContourOverlap(tracing, outline, maximumDistance=3.0)
    assert figures.fixedShare == pytest.approx(76 / 101)
    assert figures.movingShare == pytest.approx(75 / 225, abs=0.01)
    assert figures.rootMeanSquare == pytest.approx(2.0)
    assert figures.largestDistance == pytest.approx(2.0)
    away = ds.ContourOverlap(tracing, outline, ds.Similarity2DTransform(translation=(0.0, 50.0)))
    assert away.fixedShare == 0.0


def test_crowns_by_labels_are_the_labelled_points(ds, jaws):
    mesh = jaws["upper"].mesh
    process = ds.CrownRegionMeshFilter()
    crowns = process.Execute(mesh)
    assert process.GetLabelsWereUsed()
    labelled = mesh.labels[mesh.triangles] > 0
    assert labelled[process.GetTriangleMask() == 1].any(axis=1).all()
    assert (crowns.labels > 0).mean() > 0.9


def test_crowns_by_shape_agree_with_the_labels(ds, jaws):
    mesh = jaws["upper"].mesh
    process = ds.CrownRegionMeshFilter()
    process.UseLabelsOff()
    process.Execute(mesh)
    found, true = process.GetPointMask() == 1, mesh.labels > 0
    # Documentation/CrownRegion.md: 0.85 to 0.95 on phantoms.
    assert (found & true).sum() / (found | true).sum() > 0.8


def test_side_of_a_jaw(ds, jaws):
    mesh = jaws["upper"].mesh
    transform = ds.UMidlineDentalAxis(mesh, refineMidline=True).upperTransform
    right = ds.MidlineSideMesh(mesh, transform, "right", margin=0.0)
    left = ds.MidlineSideMesh(mesh, transform, "left", margin=0.0)
    assert right.GetNumberOfTriangles() + left.GetNumberOfTriangles() == mesh.GetNumberOfTriangles()
    # The incisors meet at the plane, which is off by some hundredths of a mm.
    assert (right.labels // 10 == 2).mean() < 0.01 and (left.labels // 10 == 1).mean() < 0.01


def test_open_outline_is_a_part_of_the_whole(ds, jaws, geometry):
    outline = ds.OpenSilhouetteContour(jaws["upper"].mesh, geometry, jaw="upper")
    whole = ds.MeshSilhouetteContour(jaws["upper"].mesh, geometry)
    figures = ds.ContourDistance(whole, outline, distance="PointToSegment")
    assert figures.movingToFixed < 0.01 and outline.GetLength() < 0.7 * whole.GetLength()
    assert not any(polyline.closed for polyline in outline.polylines)


def test_points_of_a_silhouette_know_rim_normal_and_tooth(ds, jaws, geometry):
    process = ds.MeshSilhouetteContourSource()
    process.SetNumberOfPoints(200)
    process.UseLabelsOn()
    polyline = process.Execute(jaws["lower"].mesh, geometry).polylines[0]
    assert np.allclose(geometry.ProjectPoints(polyline.rimPoints), polyline.points, atol=1e-3)
    assert np.allclose(np.linalg.norm(polyline.normals, axis=1), 1)
    assert {name for name in polyline.teeth if name} and all(name[:1] in ("L", "") for name in polyline.teeth)
    turned = ds.ContourTransform(ds.Contour([polyline]), ds.Similarity2DTransform(scale=2.0, angle=np.pi / 2))
    assert np.allclose(turned.polylines[0].rimPoints, polyline.rimPoints)
    assert np.allclose(turned.polylines[0].normals, np.c_[-polyline.normals[:, 1], polyline.normals[:, 0]])


def test_landmark_errors_in_pixels_and_millimetres(ds):
    reference = {"UR1_tip": (10.0, 10.0), "UR6_MB": (50.0, 50.0), "UR3_tip": (0.0, 0.0)}
    predicted = {"UR1_tip": (13.0, 14.0), "16_MB": (50.0, 60.0)}
    errors = ds.LandmarkError(predicted, reference, pixelSpacing=0.25)
    assert errors.errors == {"UR1_tip": 5.0, "UR6_MB": 10.0} and errors.unpaired == ("UR3_tip",)
    assert errors.statistics["mean"] == 7.5 and errors.statistics["mean_mm"] == 7.5 * 0.25
    assert errors.statistics["success_detection_rate"][2.0] == 0.5
    assert ds.LandmarkError({}, reference).statistics == {"count": 0}


def test_overlay_is_a_picture(ds, tmp_path):
    picture = ds.RegistrationOverlay(
        np.arange(10000.0).reshape(100, 100), {"UR1": [[10, 10], [20, 30]]}, {"aligned": [[11, 10], [21, 30]]},
        {"UR1_tip": (10, 10)}, {"UR1_tip": (12, 10)}, title="A case", pixelSpacing=(0.25, 0.25),
    )
    assert np.asarray(picture).shape == (900, 1400, 3) and picture._repr_png_().startswith(b"\x89PNG")
    picture.Write(str(tmp_path / "p.png"))
    read = np.asarray(ds.ReadCephalogram(tmp_path / "p.png"))
    assert read.shape == (900, 1400)


def test_phantom_case_is_the_same_for_the_same_seed(ds):
    cases = [ds.DentalPhantomCase(5, "hard", makeRadiograph=False, numberOfTriangles=4000) for _ in range(2)]
    assert np.array_equal(cases[0].upper.mesh.points, cases[1].upper.mesh.points)
    assert np.array_equal(cases[0].lower.tracing.points, cases[1].lower.tracing.points)
    jaw = cases[0].upper
    names = list(jaw.landmarks2D)
    projected = jaw.trueGeometry.ProjectPoints(np.array([jaw.landmarks3D[name] for name in names]))
    assert np.allclose(projected, [jaw.landmarks2D[name] for name in names], atol=1e-6)


@pytest.mark.parametrize("level", ["ideal", "typical", "hard", "real", "real-hard", "standard", "practice"])
def test_phantom_has_the_levels_of_the_program(ds, level):
    phantom = ds.DentalPhantomCase(2, level, makeRadiograph=False, numberOfTriangles=4000)
    assert (phantom.cephalometricLandmarks is not None) == (level in ("standard", "practice"))
    with pytest.raises(ValueError, match="RealHard, Standard"):
        ds.DentalPhantomCase(2, "worse")


def test_standard_phantom_registers_by_what_its_analysis_drew(ds):
    phantom = ds.DentalPhantomCase(9101, "standard", makeRadiograph=False, numberOfTriangles=12000)
    result = ds.register(phantom.to_case())
    for name, jaw in result.jaws.items():
        assert jaw.status != "failed", name
        true = getattr(phantom, name).landmarks2D
        errors = [np.hypot(*np.subtract(jaw.landmarks[mark], true[mark])) for mark in true]
        # Documentation/RobustStudies.md: 1.6 px by both on average, 4.5 at worst; errors of a side besides.
        assert np.mean(errors) < 8.0, (name, errors)


def test_outlines_of_another_patient_tell_templates(ds):
    phantom = ds.DentalPhantomCase(9101, "standard", makeRadiograph=False, numberOfTriangles=12000)
    case = phantom.to_case()
    drawn = case.upperContour
    # A larger picture of it, as another patient's tracing by the same stock would be.
    stock = ds.Contour()
    for polyline in drawn.polylines:
        stock.AddPolyline(2.5 * np.asarray(polyline.points) + 40.0, polyline.code, closed=True)
    assert len(stock) == 2
    parts = {
        "upper": case.upper, "upperContour": drawn, "geometry": case.geometry, "imageSize": case.imageSize,
        "landmarks3D": case.landmarks3D, "tracedSide": "standard",
    }
    told = [ds.register(ds.Case(**parts, **more)).to_dict() for more in ({}, {"stockOutlines": [stock]})]
    used = [result["jaws"]["upper"]["outlines_used"] for result in told]
    assert set(used[0]) == {"U1", "U6"} and not any("template_of" in outline for outline in used[0].values())
    assert {outline["template_of"] for outline in used[1].values()} <= {"UR1 of the stock", "UL1 of the stock", "UR6 of the stock", "UL6 of the stock"}
    assert all(outline["template"] and outline["template_distance_mm"] < 0.01 for outline in used[1].values())


def test_experiment_runs_and_resumes(ds, tmp_path):
    settings = {"numberOfCases": 2, "methods": ["bounding-box"], "drawFigures": False}
    if "bounding-box" not in dict(ds.experiment_methods()):
        settings["methods"] = [ds.experiment_methods()[0][0]]
    files = ds.RunCohortExperiment(tmp_path / "e", level="ideal", **settings)
    assert files and all((tmp_path / "e" / name).exists() for name in files)
    again = ds.CohortExperiment()
    again.SetNumberOfCases(2)
    again.SetLevel("ideal")
    again.SetMethods(settings["methods"])
    again.DrawFiguresOff()
    again.Execute(tmp_path / "e")
    assert again.GetNumberOfResumedCases() == 2


def test_missing_input_says_what_to_call(ds, geometry):
    with pytest.raises(ds.FilterError, match="SetUpperMesh"):
        ds.UMidlineDentalAxis()
    triangle = ([[0.0, 0, 0], [1, 0, 0], [0, 0, 1]], [[0, 1, 2]])
    with pytest.raises(ds.FilterError, match="SetPixelSpacing"):
        ds.MeshSilhouetteContour(triangle, ds.CephalometricGeometry())
    with pytest.raises(ds.ArgumentError, match="frameTransform"):
        ds.MidlineSideMesh(triangle, None)


def test_settings_of_a_twin_are_by_default_those_of_its_class(ds, case):
    mesh = case.upper
    frame = ds.UMidlineDentalAxis(mesh).upperTransform
    assert len(ds.MidlineSideMesh(mesh, frame).triangles) == len(ds.MidlineSideMeshFilter().Execute(mesh, frame).triangles)


def test_word_that_is_no_value_of_a_setting_names_those_that_are(ds):
    with pytest.raises(ds.ArgumentError, match="outputMode.*'foo'.*Thickness"):
        ds.SurfaceDRR((np.eye(3), [[0, 1, 2]]), ds.CephalometricGeometry(pixelSpacing=0.25), outputMode="foo")


@pytest.mark.parametrize("spacing", [0.0, -0.1, float("nan"), (0.1, 0.0)])
def test_spacing_that_is_none_is_refused(ds, spacing):
    with pytest.raises(ds.ArgumentError, match="pixelSpacing.*> 0"):
        ds.CephalometricGeometry(pixelSpacing=spacing)


def test_numbers_in_a_row_are_a_contour(ds):
    assert np.array_equal(ds.as_contour([1.0, 2.0, 3.0, 4.0]).points, [[1.0, 2.0], [3.0, 4.0]])
    with pytest.raises(ds.ArgumentError, match="3 numbers"):
        ds.as_contour([1.0, 2.0, 3.0])


def test_missing_teeth_of_a_phantom_have_no_labels(ds):
    parameters = ds.DentalPhantomParameters()
    parameters.numberOfTriangles = 8000
    parameters.SetMissingTeeth([26, 45])
    assert parameters.GetMissingTeeth() == [26, 45]
    jaws = ds.DentalPhantomMesh(parameters=parameters)
    assert 26 not in jaws["upper"].mesh.labels and 25 in jaws["upper"].mesh.labels
    assert 45 not in jaws["lower"].mesh.labels and 44 in jaws["lower"].mesh.labels
    with pytest.raises(ds.ArgumentError, match="no tooth 18"):
        parameters.SetMissingTeeth([18])


def test_the_papers_chain_can_be_put_together_by_hand(ds):
    geometry = ds.CephalometricGeometry(pixelSpacing=0.25, principalPoint=(100.0, 50.0))
    frame = ds.VersorRigid3DTransform()
    similarity = ds.Similarity2DTransform()
    similarity.SetParameters([1.0, 0.0, 100.0, 50.0])
    placed = ds.SimilarityPlacement(similarity, frame, geometry)
    assert np.allclose(placed.transform.TransformPoint((1.0, 2.0, 3.0)), (1.0, 2.0, 3.0))
    centred = ds.GeometryPlacement(geometry, frame, centralRayThroughOrigin=True)
    point = (10.0, 5.0, -4.0)
    seen = np.array(centred.ProjectPoint(point)) + (100.0, 50.0)
    found = ds.LandmarkMatrixProjection({"UR6_MB": point, "LR6_MB": point}, placed.projectionMatrix, jaw="upper")
    assert list(found) == ["UR6_MB"] and np.allclose(found["UR6_MB"], seen)
    moved = ds.ContourTransform(np.array([(0.0, 0.0), (3.0, 4.0)]), similarity)
    assert np.allclose(moved.points, [(100.0, 50.0), (103.0, 54.0)])
    mesh = (np.array([[0, 0, 0], [60, 0, 0], [0, 0, 1]], float), [[0, 1, 2]])
    width = 60.0 * 1674.0 / 1524.0
    rough = ds.TracingPixelSpacing(geometry, mesh, np.array([(0.0, 0.0), (width * 5.0, 1.0)]), frame)
    assert np.allclose(rough.GetPixelSpacing(), 0.2)
    assert ds.SurfaceSplatWidth(mesh, geometry) > 0.25
    with pytest.raises(ds.Error, match="frame is needed"):
        ds.GeometryPlacement(geometry, None)
