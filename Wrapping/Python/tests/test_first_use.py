"""What a first user stumbled over, and must not stumble over again."""
import copy
import json
import pickle
import shutil

import numpy as np
import pytest

POINTS = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])


def test_case_of_parts_pickles_and_copies(ds, case, result):
    made = ds.Case(
        upper=case.upper, lower=case.lower, upperContour=case.upperContour, lowerContour=case.lowerContour,
        geometry=case.geometry, imageSize=case.imageSize, landmarks3D=case.landmarks3D, exclude=["UR8"],
        cephalometricLandmarks={"U1_tip": {"position": (300.0, 400.0), "sigma_px": 3.0}},
        views=[{"geometry": ds.CephalometricGeometry(pixelSpacing=0.25, direction="Frontal"), "imageSize": (800, 900),
                "cephalometricLandmarks": {"UR1_tip": (400.0, 500.0)}}],
    )
    for other in (pickle.loads(pickle.dumps(made)), copy.copy(made), copy.deepcopy(made)):
        assert repr(other) == repr(made) and other.imageSize == made.imageSize
        np.testing.assert_array_equal(other.upper.points, made.upper.points)
        np.testing.assert_array_equal(other.lowerContour.points, made.lowerContour.points)
        assert other.cephalometricLandmarks["U1_tip"]["sigma_px"] == 3.0
        assert other.geometry.GetPixelSpacing() == made.geometry.GetPixelSpacing()
    assert copy.copy(made).upper is made.upper and copy.deepcopy(made).upper is not made.upper


def test_case_of_files_pickles_by_their_names_and_registers_alike(ds, sample, case, result):
    for other in (pickle.loads(pickle.dumps(case)), copy.copy(case), copy.deepcopy(case)):
        np.testing.assert_array_equal(other.upper.points, case.upper.points)
        assert other.landmarks3D.keys() == case.landmarks3D.keys()
    again = ds.register(pickle.loads(pickle.dumps(ds.ReadCase(sample / "case.json", exclude=["UR3"]))))
    np.testing.assert_array_equal(
        again.upper.P_pixel_from_mesh, ds.register(sample / "case.json", exclude=["UR3"]).upper.P_pixel_from_mesh
    )


def test_a_pickled_case_whose_files_have_changed_is_refused(ds, sample, tmp_path):
    shutil.copytree(sample, tmp_path / "case")
    pickled = pickle.dumps(ds.ReadCase(tmp_path / "case" / "case.json"))
    content = json.loads((tmp_path / "case" / "contours.json").read_text())
    content["contours"]["upper"][0]["points"][0][0] += 1.0
    (tmp_path / "case" / "contours.json").write_text(json.dumps(content))
    with pytest.raises(ds.ArgumentError, match="contours.json has changed"):
        pickle.loads(pickled)


def test_options_and_levels_pickle_and_copy(ds):
    options = ds.PoseRegistrationOptions()
    options.useRobustKernel = False
    level = ds.RegistrationLevel(scaleBound=0.2, rotationBound=0.1, translationBound=3.0, numberOfStarts=4, numberOfIterations=9)
    for make in (copy.copy, copy.deepcopy, lambda value: pickle.loads(pickle.dumps(value))):
        assert make(options).GetChanges() == options.GetChanges() != []
        names = ("scaleBound", "rotationBound", "translationBound", "numberOfScales", "numberOfRotations", "numberOfTranslations",
                 "numberOfStarts", "numberOfIterations")
        assert [getattr(make(level), name) for name in names] == [getattr(level, name) for name in names]
        assert make(level) is not level


def test_every_transform_has_its_matrix(ds, case):
    similarity = ds.Similarity2DTransform(2.0, 0.5, (3.0, 4.0))
    rigid = ds.VersorRigid3DTransform(np.vstack([np.eye(3, 4), [0, 0, 0, 1]]) + np.eye(4, k=3) * 5.0)
    pose = ds.CephalometricPoseTransform(ds.CephalometricGeometry(pixelSpacing=0.25), [0.1, 0.2, -0.1, 1.0, 2.0, 3.0, 0.01])
    assert similarity.matrix.shape == (3, 3) and rigid.matrix.shape == pose.matrix.shape == (4, 4)
    np.testing.assert_allclose((similarity.matrix @ [1.0, 2.0, 1.0])[:2], similarity.TransformPoint((1.0, 2.0)))
    np.testing.assert_allclose((rigid.matrix @ [1.0, 2.0, 3.0, 1.0])[:3], rigid.TransformPoint((1.0, 2.0, 3.0)))
    np.testing.assert_allclose((pose.matrix @ [1.0, 2.0, 3.0, 1.0])[:3], pose.GetRigidTransform().TransformPoint((1.0, 2.0, 3.0)))
    # All that there are, so that another one is not forgotten.
    kinds = [kind for kind in vars(ds).values() if isinstance(kind, type) and issubclass(kind, ds.Transform) and kind is not ds.Transform]
    assert len(kinds) == 3 and all(hasattr(kind, "matrix") for kind in kinds)


@pytest.mark.parametrize("triangles", [[[0.0, 1.0, 2.0]], [[0, 1.5, 2]], np.array([[True, False, True]]), np.array([["0", "1", "2"]])])
def test_triangles_that_are_no_integers_are_refused(ds, triangles):
    with pytest.raises(ds.ArgumentError, match="triangles are .* integers are needed"):
        ds.Mesh(POINTS, triangles)
    with pytest.raises(ds.ArgumentError, match="integers"):
        ds.UMidlineDentalAxis((POINTS, triangles))
    # Nothing has no kind.
    assert ds.Mesh(POINTS, np.zeros((0, 3))).GetNumberOfTriangles() == 0


@pytest.mark.parametrize("labels, word", [([11.5, 0, 0, 0], "integers"), ([300, 0, 0, 0], "label 300 of point 0"), ([0, -1, 0, 0], "label -1 of point 1")])
def test_labels_that_are_none_are_refused(ds, labels, word):
    with pytest.raises(ds.ArgumentError, match=word):
        ds.Mesh(POINTS, [[0, 1, 2]], labels)


@pytest.mark.parametrize("spacing", [(1, 2, 3), "0.25", (0.25, "a"), (0.25, 0.0), -1.0, float("nan"), []])
def test_a_spacing_that_is_none_gets_our_error(ds, spacing):
    with pytest.raises(ds.ArgumentError, match="pixelSpacing is .*; give mm a pixel"):
        ds.CephalometricGeometry(pixelSpacing=spacing)


def test_a_principal_point_that_is_none_gets_our_error(ds):
    with pytest.raises(ds.ArgumentError, match="principalPoint is .*two numbers"):
        ds.CephalometricGeometry(principalPoint=(1, 2, 3))


def test_a_missing_file_is_a_file_not_found_error_too(ds, sample, tmp_path):
    missing = tmp_path / "nowhere.json"
    readers = (
        ds.ReadCase, ds.ReadMesh, ds.ReadContours, ds.ReadCephalogram, ds.ReadTransform, ds.ReadCephalometricLandmarks, ds.register,
    )
    for read in readers:
        with pytest.raises(FileNotFoundError, match="nowhere.json") as caught:
            read(missing)
        assert isinstance(caught.value, ds.InputError) and isinstance(caught.value, RuntimeError), read
        assert str(caught.value).startswith(str(missing)) and caught.value.remedy
    # One that a case file names.
    shutil.copytree(sample, tmp_path / "case")
    (tmp_path / "case" / "upper.stl").unlink()
    with pytest.raises(FileNotFoundError, match='upper: there is no file "upper.stl"'):
        ds.ReadCase(tmp_path / "case" / "case.json")
    # A file that is there and unusable is none.
    (tmp_path / "broken.stl").write_text("solid nonsense")
    with pytest.raises(ds.InputError) as caught:
        ds.ReadMesh(tmp_path / "broken.stl")
    assert not isinstance(caught.value, FileNotFoundError)
    # It comes out of a worker process.
    with pytest.raises(FileNotFoundError, match="nowhere"):
        try:
            ds.ReadMesh("nowhere.stl")
        except ds.Error as error:
            raise pickle.loads(pickle.dumps(error)) from None


def test_reprs_are_short(ds, sample, case, result, tmp_path):
    axes = ds.UMidlineDentalAxis(case.upper, case.lower)
    solution = ds.PoseRegistration(case.geometry, case.upper, case.upperContour, case.lower, case.lowerContour, frames=axes)
    shown = [
        case, result, result.upper, axes, axes.frames, solution, case.upper, case.upperContour, case.geometry,
        ds.PoseRegistrationOptions(), ds.RegistrationLevel(), ds.RegistrationVerdict(solution).upper,
        ds.LandmarkProjection(solution, case.landmarks3D), ds.ReadContours(sample / "contours.json"),
        *ds.batch([sample / "case.json"], tmp_path / "results"),
    ]
    assert "fit" in repr(result.upper) and repr(axes) == "<dentalscr.DentalAxes upper, lower, joint>"
    for value in shown:
        assert len(repr(value)) < 500, (type(value), repr(value)[:2000])


def test_silhouette_of_a_drr_that_came_back_from_simpleitk(ds, case):
    """Its first index has become a part of its origin: right in the radiograph's pixels, or it is said that it isn't."""
    pytest.importorskip("SimpleITK")
    placed = case.geometry
    placed.SetPose(ds.UMidlineDentalAxis(case.upper).upperTransform.matrix)
    drr = ds.SurfaceDRR(case.upper, placed)
    assert tuple(drr.GetIndex()) != (0, 0)
    expected = ds.SilhouetteContour(drr, levelValue=0.5).points
    theirs = ds.to_sitk(drr)
    for image in (theirs, ds.from_sitk(theirs)):
        with pytest.warns(UserWarning, match="PhysicalOverSpacing"):
            own = ds.SilhouetteContour(image, levelValue=0.5).points
        np.testing.assert_allclose(own + drr.GetIndex(), expected, atol=1e-3)
        right = ds.SilhouetteContour(image, levelValue=0.5, outputCoordinates="PhysicalOverSpacing").points
        np.testing.assert_allclose(right, expected, atol=1e-3)


def test_global_threads_are_set_where_the_page_says(ds):
    before = ds.ProcessObject.GetGlobalDefaultNumberOfThreads()
    try:
        ds.ProcessObject.SetGlobalDefaultNumberOfThreads(3)
        assert ds.ProcessObject.GetGlobalDefaultNumberOfThreads() == 3
    finally:
        ds.ProcessObject.SetGlobalDefaultNumberOfThreads(before)
