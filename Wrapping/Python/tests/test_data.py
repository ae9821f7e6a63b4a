"""Meshes, images, contours, transforms, geometry: what is copied, what is a view, what is refused."""
import copy
import json
import pickle

import numpy as np
import pytest

POINTS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
TRIANGLES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])


@pytest.fixture
def mesh(ds):
    return ds.Mesh(POINTS, TRIANGLES, labels=[0, 11, 21, 0])


def test_mesh_copies_what_it_is_given(ds):
    points = POINTS.copy()
    mesh = ds.Mesh(points, TRIANGLES)
    points[:] = 7
    assert np.array_equal(mesh.points, POINTS) and np.array_equal(mesh.triangles, TRIANGLES)


def test_points_are_a_read_only_view_that_outlives_the_mesh(ds):
    mesh = ds.Mesh(POINTS, TRIANGLES)
    view = mesh.points
    assert view.__array_interface__["data"][0] == mesh.points.__array_interface__["data"][0]
    with pytest.raises(ValueError):
        view[0, 0] = 1
    del mesh
    assert np.array_equal(view, POINTS)


@pytest.mark.parametrize(
    "points, triangles, word",
    [
        (POINTS[:, :2], TRIANGLES, r"\(N, 3\)"),
        (POINTS, [[0, 1, 4]], "names point 4 of 4"),
        (POINTS, [[0, 1, -1]], "names point -1"),
        (POINTS * np.nan, TRIANGLES, "not finite"),
        (POINTS, [[0, 1]], r"\(N, 3\)"),
    ],
)
def test_broken_arrays_are_refused_with_the_reason(ds, points, triangles, word):
    with pytest.raises(ds.ArgumentError, match=word):
        ds.Mesh(points, triangles)


def test_mesh_pickles_with_labels(ds, mesh):
    other = pickle.loads(pickle.dumps(mesh))
    assert np.array_equal(other.points, mesh.points) and np.array_equal(other.triangles, mesh.triangles)
    assert list(other.labels) == [0, 11, 21, 0]


def test_mesh_file_round_trip_keeps_every_triangle(ds, mesh, tmp_path):
    for extension in ("stl", "ply", "obj", "off"):
        ds.WriteMesh(mesh, tmp_path / f"m.{extension}")
        other = ds.ReadMesh(tmp_path / f"m.{extension}")
        assert np.allclose(other.points[other.triangles], mesh.points[mesh.triangles]), extension


def test_image_is_rows_and_columns_and_sizes_are_u_v(ds):
    array = np.arange(6, dtype=np.float32).reshape(2, 3)
    image = ds.GetImageFromArray(array, spacing=(0.25, 0.5))
    assert image.GetSize() == (3, 2) and image.GetSpacing() == (0.25, 0.5)
    assert np.array_equal(np.asarray(image), array)
    view = ds.GetArrayViewFromImage(image)
    assert np.asarray(image).__array_interface__["data"] == view.__array_interface__["data"]
    assert not view.flags.writeable
    assert ds.GetArrayFromImage(image).flags.writeable
    assert np.array_equal(np.asarray(pickle.loads(pickle.dumps(image))), array)
    assert image._repr_png_().startswith(b"\x89PNG")


def test_view_of_an_image_outlives_it(ds):
    image = ds.Image(np.ones((300, 400)))
    view = np.asarray(image)
    del image
    assert view.sum() == 120000


def test_contour_keeps_codes_gaps_and_weights(ds):
    contour = ds.Contour()
    contour.AddPolyline([[0, 0], [1, 0], [2, 1]], "UR1", weights=[1, 0.5, 0])
    contour.AddPolyline([[5, 5], [6, 5], [6, 6]], 46, closed=True)
    for other in (contour, pickle.loads(pickle.dumps(contour)), copy.deepcopy(contour)):
        first, second = other.polylines
        assert (first.code, first.fdi, first.closed) == ("UR1", 11, False)
        assert (second.code, second.closed) == ("LR6", True)
        assert list(first.weights) == [1, 0.5, 0]
        assert len(other.points) == 6
    assert contour.GetLength() == pytest.approx(1 + 2**0.5 + 2 + 2**0.5)
    assert "<svg" in contour._repr_svg_()


@pytest.mark.parametrize("weights", [[1.0], [1.0, 2.0]])
def test_wrong_weights_are_refused(ds, weights):
    with pytest.raises(ds.Error, match="weight"):
        ds.Contour().AddPolyline([[0, 0], [1, 0]], weights=weights)


def test_contours_are_taken_from_arrays_dictionaries_and_lists(ds):
    assert len(ds.as_contour(np.zeros((4, 2)))) == 1
    assert [p.code for p in ds.as_contour({"UR1": [[0, 0], [1, 1]], "UR2": [[2, 2]]}).polylines] == ["UR1", "UR2"]
    assert len(ds.as_contour([np.zeros((2, 2)), np.ones((3, 2))])) == 2
    assert ds.as_contour([(0, 0), (1, 1), (2, 2)]).GetNumberOfPoints() == 3
    with pytest.raises(TypeError, match="no contour"):
        ds.as_contour(3.0)


def test_what_is_no_mesh_or_image_is_named(ds):
    with pytest.raises(TypeError, match="builtins.int is no mesh"):
        ds.as_mesh(3)
    with pytest.raises(TypeError, match="2-D"):
        ds.as_image(np.zeros((2, 2, 3)))


def test_mesh_objects_are_taken_by_what_they_have(ds):
    class Trimesh:
        vertices, faces = POINTS, TRIANGLES

    class Open3D:
        vertices, triangles = POINTS, TRIANGLES

    class Meshio:
        points, cells_dict = POINTS, {"triangle": TRIANGLES}

    dictionary = {"points": POINTS.reshape(-1), "cells": np.c_[np.full(4, 2), np.full(4, 3), TRIANGLES].reshape(-1)}
    for given in (Trimesh(), Open3D(), Meshio(), dictionary, (POINTS, TRIANGLES)):
        mesh = ds.as_mesh(given)
        assert np.array_equal(mesh.points, POINTS) and np.array_equal(mesh.triangles, TRIANGLES)

    class Quads:
        points, cells_dict = POINTS, {"quad": TRIANGLES}

    with pytest.raises(ds.ArgumentError, match="quad"):
        ds.as_mesh(Quads())


def test_similarity_maps_as_its_formula(ds):
    transform = ds.Similarity2DTransform(scale=2.0, angle=0.3, translation=(4.0, -1.0))
    q = np.array([[1.0, 2.0], [-3.0, 0.5]])
    rotation = np.array([[np.cos(0.3), -np.sin(0.3)], [np.sin(0.3), np.cos(0.3)]])
    expected = 2.0 * q @ rotation.T + [4.0, -1.0]
    assert np.allclose(transform.TransformPoints(q), expected)
    assert np.allclose(transform.TransformPoint(q[0]), expected[0])
    homogeneous = transform.matrix @ np.array([q[1, 0], q[1, 1], 1.0])
    assert np.allclose(homogeneous[:2], expected[1])
    assert np.allclose(transform.GetInverse().TransformPoints(expected), q)


def test_transforms_pickle_copy_and_travel_by_file(ds, tmp_path):
    similarity = ds.Similarity2DTransform(1.1, 0.2, (3.0, 4.0), center=(5.0, 6.0))
    angle = 0.4
    matrix = np.eye(4)
    matrix[:3, :3] = [[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]]
    matrix[:3, 3] = [1, 2, 3]
    rigid = ds.VersorRigid3DTransform(matrix)
    assert np.allclose(rigid.matrix, matrix)
    for transform in (similarity, rigid):
        assert pickle.loads(pickle.dumps(transform)) == transform
        assert copy.deepcopy(transform) == transform
        ds.WriteTransform(transform, tmp_path / "t.tfm")
        assert np.allclose(ds.ReadTransform(tmp_path / "t.tfm").matrix, transform.matrix, atol=1e-12)
    with pytest.raises(ds.Error):
        ds.VersorRigid3DTransform(np.diag([2.0, 1.0, 1.0, 1.0]))
    with pytest.raises(ds.ArgumentError, match="4 parameters, not 3"):
        similarity.SetParameters([1, 2, 3])


@pytest.mark.parametrize("source_side", ["right", "left"])
@pytest.mark.parametrize("facing", ["right", "left"])
def test_geometry_projects_by_the_formula_of_the_documentation(ds, source_side, facing):
    geometry = ds.CephalometricGeometry(
        1500.0, 1660.0, pixelSpacing=(0.2, 0.25), principalPoint=(170.0, 420.0), sourceSide=source_side, facing=facing
    )
    points = np.array([[40.0, 12.0, -30.0], [10.0, -25.0, 5.0]])
    k = 1 if source_side == "right" else -1
    f = 1 if facing == "right" else -1
    m = 1660.0 / (1500.0 + k * points[:, 1])
    expected = np.c_[170.0 + f * m * points[:, 0] / 0.2, 420.0 - m * points[:, 2] / 0.25]
    assert np.allclose(geometry.ProjectPoints(points), expected)
    for other in (pickle.loads(pickle.dumps(geometry)), copy.deepcopy(geometry)):
        assert np.allclose(other.ProjectPoints(points), expected)
    source, direction = geometry.BackProject(expected[0])
    offset = points[0] - np.array(source)
    assert np.allclose(np.cross(offset, direction), 0.0, atol=1e-6)


def test_projecting_without_a_spacing_says_what_to_call(ds):
    with pytest.raises(ds.FilterError, match="SetPixelSpacing"):
        ds.CephalometricGeometry().ProjectPoint((0, 0, 0))


def test_tooth_codes(ds):
    assert ds.tooth_fdi("UR1") == 11 and ds.tooth_name(46) == "LR6"
    with pytest.raises(ds.ArgumentError):
        ds.tooth_fdi("UR9")


def test_universal_numbers_become_fdi():
    from dentalscr._inputs import universal_to_fdi

    assert list(universal_to_fdi([0, 1, 8, 9, 16, 17, 24, 25, 32, 33])) == [0, 18, 11, 21, 28, 38, 31, 41, 48, 0]


def test_landmarks_and_contours_travel_by_file(ds, tmp_path):
    landmarks = {"UR1_tip": [1.5, 2.25], "UR6_MB": [3.0, 4.0]}
    ds.WriteLandmarks(landmarks, tmp_path / "l.json")
    read = ds.ReadLandmarks(tmp_path / "l.json")
    assert list(read) == list(landmarks) and np.array_equal(read["UR1_tip"], [1.5, 2.25])
    ds.WriteLandmarks({"UR1_tip": [1, 2, 3]}, tmp_path / "l3.json")
    assert np.array_equal(ds.ReadLandmarks(tmp_path / "l3.json")["UR1_tip"], [1, 2, 3])
    ds.WriteContours(tmp_path / "c.json", (100, 80), upper={"UR1": [[1, 2], [3, 4]]})
    contours = ds.ReadContours(tmp_path / "c.json")
    assert contours.imageSize == (100, 80) and contours.upper.polylines[0].code == "UR1"
    assert contours.lower.GetNumberOfPoints() == 0


def test_files_that_are_not_there_are_named(ds, tmp_path):
    for read in (ds.ReadMesh, ds.ReadContours, ds.ReadLandmarks, ds.ReadCephalogram, ds.ReadToothLabels, ds.ReadCase):
        with pytest.raises(ds.InputError) as error:
            read(tmp_path / "nothing.here")
        assert "nothing.here" in str(error.value)


def test_contour_carries_drawing_errors_and_what_it_shows(ds):
    contour = ds.Contour()
    contour.AddPolyline([[1, 1], [2, 2], [3, 1]], "11", closed=True, sigmas=1.5, outline="tooth")
    contour.AddPolyline([[5, 5], [6, 6]], "URA", sigmas=[0.5, 2.0], drafted=True)
    assert ds.Polyline([[1, 1]], drafted=True).drafted and not ds.Polyline([[1, 1]]).drafted
    for other in (contour, pickle.loads(pickle.dumps(contour))):
        first, second = other.polylines
        assert first.outline == "tooth" and second.outline is None
        assert first.sigmas.tolist() == [1.5, 1.5, 1.5] and second.sigmas.tolist() == [0.5, 2.0]
        assert second.fdi == 51
        assert second.drafted and not first.drafted and other.GetDraftedShare() == 2 / 5
    with pytest.raises((ValueError, ds.Error), match="root"):
        ds.Polyline([[1, 1]], "11", outline="root")


def test_contour_carries_what_a_silhouette_knows(ds):
    contour = ds.Contour()
    contour.AddPolyline(
        [[0, 0], [1, 0]], normals=[[0, -1], [0.6, -0.8]], rimPoints=[[1, 2, 3], [4, 5, 6]], teeth=["UR1", 12]
    )
    contour.AddPolyline([[5, 5], [6, 6]], "UR3")
    for other in (contour, pickle.loads(pickle.dumps(contour)), copy.deepcopy(contour)):
        first, second = other.polylines
        assert first.normals.tolist() == [[0, -1], [0.6, -0.8]] and first.rimPoints.tolist() == [[1, 2, 3], [4, 5, 6]]
        assert first.teeth == ["UR1", "UR2"] and first.code == "UR1"
        assert second.normals is None and second.rimPoints is None and second.teeth is None
    with pytest.raises(ds.Error, match="normals"):
        ds.Contour().AddPolyline([[0, 0], [1, 0]], normals=[[1, 0]])
    with pytest.raises(ValueError, match="rimPoints"):
        ds.Polyline([[0, 0]], rimPoints=[[1, 2]])


def test_contours_of_other_programs_and_of_masks(ds, tmp_path):
    (tmp_path / "cvat.xml").write_text(
        '<annotations><image name="ceph.png" width="100" height="200">'
        '<polyline label="tooth 11" points="1.5,1.5;2.5,2.5"/>'
        '<polyline label="Calibration_30mm" points="0,0;0,120"/></image></annotations>'
    )
    contours = ds.ReadContours(tmp_path / "cvat.xml")
    assert contours.imageSize == (100, 200)
    assert contours.upper.points.tolist() == [[1.0, 1.0], [2.0, 2.0]]
    reader = ds.DentalContourFileReader()
    reader.Execute(tmp_path / "cvat.xml")
    assert reader.GetCalibrations() == [("Calibration_30mm", 30.0, 120.0)]

    mask = "NRRD0004\ntype: uchar\ndimension: 2\nsizes: 9 9\nencoding: ascii\n\n"
    mask += "\n".join(" ".join("1" if 1 <= u <= 6 and 1 <= v <= 6 else "0" for u in range(9)) for v in range(9)) + "\n"
    # The rarer of two tones is what is drawn: 36 of 81 pixels.
    (tmp_path / "mask.nrrd").write_text(mask)
    contours = ds.ReadContours({"UR1": tmp_path / "mask.nrrd"})
    assert contours.upper.polylines[0].code == "UR1" and contours.upper.polylines[0].closed

    # A curve of 3D Slicer, which saves each in a file of its own and without its name.
    control = [{"label": f"C-{i}", "position": [i, 2 * i, 0]} for i in range(1, 4)]
    (tmp_path / "curve.mrk.json").write_text(json.dumps({"markups": [{"type": "Curve", "controlPoints": control}]}))
    curves = ds.ReadContours({"LR6": tmp_path / "curve.mrk.json"}, imageSize=(100, 200), markupsSpacing=(0.5, 0.5))
    assert curves.lower.polylines[0].code == "LR6" and curves.lower.points[0].tolist() == [2.0, 4.0]

    # As a spreadsheet of western Europe saves it: neither a warning nor an error has bytes that are no text.
    (tmp_path / "marks.csv").write_bytes("Punkt;X;Y\nHöcker;1,5;2,5\nU1_tip;10,0;20,0\n".encode("latin-1"))
    marks = ds.CephalometricLandmarkFileReader()
    assert len(marks.Execute(tmp_path / "marks.csv")) == 1
    assert "Höcker" in marks.GetWarnings()[0]
    (tmp_path / "teeth.csv").write_bytes("Zähne,1,2\n".encode("latin-1"))
    with pytest.raises(ds.InputError, match="Zähne"):
        ds.ReadContours(tmp_path / "teeth.csv", imageSize=(100, 200))

    # A file that is named afterwards is what is read.
    reader.SetClassFiles([("UR1", str(tmp_path / "mask.nrrd"))])
    assert reader.Execute().upper.polylines[0].closed
    assert reader.Execute(tmp_path / "cvat.xml").upper.points.tolist() == [[1.0, 1.0], [2.0, 2.0]]
