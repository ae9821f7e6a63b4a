"""Files as people have them: every form of one tracing gives the answer that contours.json gives."""
import gzip
import io
import json
import struct
import zipfile
import zlib

import matplotlib.image
import matplotlib.path
import numpy
import pytest

from nifti_file import nifti
from png_file import png

WIDTH, HEIGHT = 703, 938


def tiff_int32(rows):
    """A TIFF of signed whole numbers of 32 bits, as NumPy's default type is written."""
    width, height = len(rows[0]), len(rows)
    pixels = b"".join(struct.pack(f"<{width}i", *row) for row in rows)
    tags = [
        (256, 4, width), (257, 4, height), (258, 3, 32), (259, 3, 1), (262, 3, 1), (273, 4, 8), (277, 3, 1),
        (278, 4, height), (279, 4, len(pixels)), (339, 3, 2),
    ]
    directory = struct.pack("<H", len(tags))
    for tag, kind, value in tags:
        directory += struct.pack("<HHI", tag, kind, 1)
        directory += struct.pack("<HH", value, 0) if kind == 3 else struct.pack("<I", value)
    return b"II*\0" + struct.pack("<I", 8 + len(pixels)) + pixels + directory + struct.pack("<I", 0)


def two_discs():
    """FDI 11 at (30, 40) and 81 at (70, 40), radius 12."""
    rows = [[0] * 100 for _ in range(80)]
    for v in range(80):
        for u in range(100):
            for label, centre in ((11, 30), (81, 70)):
                if (u - centre) ** 2 + (v - 40) ** 2 <= 144:
                    rows[v][u] = label
    return rows


def contours_of(run, tmp_path, name, content):
    (tmp_path / name).write_bytes(content)
    done = run("contour", "--labels", tmp_path / name, "--output", tmp_path / "c.json")
    assert done.returncode == 0, done.stderr
    return json.loads((tmp_path / "c.json").read_text())


def test_labels_are_numbers_whatever_the_file_keeps_them_in(run, tmp_path):
    rows = two_discs()
    grey = contours_of(run, tmp_path, "grey.png", png(rows))
    assert [polyline["code"] for polyline in grey["contours"]["upper"]] == ["UR1"]
    assert [polyline["code"] for polyline in grey["contours"]["lower"]] == ["LRA"]
    # A palette's colours are for the eye: its index is the label.
    palette = [((37 * i) % 256, (91 * i) % 256, (13 * i) % 256) for i in range(256)]
    assert contours_of(run, tmp_path, "palette.png", png(rows, palette)) == grey
    assert contours_of(run, tmp_path, "int32.tif", tiff_int32(rows)) == grey
    nrrd = b"NRRD0004\ntype: uint16\ndimension: 2\nsizes: 100 80\nencoding: raw\nendian: little\n\n"
    nrrd += b"".join(struct.pack("<100H", *row) for row in rows)
    assert contours_of(run, tmp_path, "labels.nrrd", nrrd) == grey


@pytest.mark.parametrize("kind", "BhifdbHIqQ")
def test_labels_of_nifti_are_those_of_the_picture(run, tmp_path, kind):
    """As nnU-Net, ITK-SNAP, 3D Slicer and SimpleITK write them: one slice, columns to the left, rows to the back."""
    rows = two_discs()
    grey = contours_of(run, tmp_path, "grey.png", png(rows))
    assert contours_of(run, tmp_path, "labels.nii", nifti(rows, kind)) == grey
    assert contours_of(run, tmp_path, "labels.nii.gz", nifti(rows, kind, packed=True)) == grey
    # With another name, in the other byte order, and of a program that says nothing about directions.
    assert contours_of(run, tmp_path, "labels.dat", nifti(rows, kind, ">")) == grey
    assert contours_of(run, tmp_path, "none.nii.gz", nifti(rows, kind, code=0, spacing=(0.2, 0.3), packed=True)) == grey
    # Turned over by a program that has all volumes run to the right and to the front.
    turned = ((1, 0, 0, -99), (0, 1, 0, -79), (0, 0, 1, 0))
    assert contours_of(run, tmp_path, "turned.nii.gz", nifti([row[::-1] for row in rows[::-1]], kind, affine=turned)) == grey


def test_nifti_that_is_no_label_map_of_a_picture_is_refused_in_words(run, tmp_path):
    rows = two_discs()
    elsewhere = ((1, 0, 0, 40), (0, 1, 0, 0), (0, 0, 1, 0))
    whole = nifti(rows, packed=True)
    for name, content, words in (
        ("a.nii.gz", nifti(rows, affine=elsewhere, packed=True), "columns run to R and rows to A"),
        ("a.nii", nifti(rows, slices=40), "has 40 frames, pages or slices"),
        ("a.nii.gz", whole[:-30], "truncated or damaged"),
        ("a.nii", gzip.decompress(whole)[:-1], "8351 of 8352 bytes are there"),
        ("a.nii", nifti([[0.0, 0.5]], "f"), "value 0.5, which is no label"),
        ("a.hdr", nifti(rows)[:344] + b"ni1\0", "no radiograph; save it as NIfTI-1 in one file (.nii, .nii.gz)"),
    ):
        (tmp_path / name).write_bytes(content)
        done = run("contour", "--labels", tmp_path / name, "--output", tmp_path / "c.json")
        assert done.returncode == 2 and name in done.stderr and words in done.stderr, (words, done.stderr)
        assert "Traceback" not in done.stderr and done.stderr.count("\n") == 1, done.stderr


def test_an_array_that_nibabel_wrote_without_directions_is_taken_as_it_is_stored(run, case, tmp_path):
    """numpy.eye(4): whether a row of the array is one of the picture only the radiograph's size tells."""
    identity = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0))
    rows = two_discs()
    grey = contours_of(run, tmp_path, "grey.png", png(rows))
    assert contours_of(run, tmp_path, "plain.nii.gz", nifti(rows, affine=identity, packed=True)) == grey
    labels = numpy.array(as_labels(*tracing_of(case)))
    answers = []
    for name, array in (
        ("labels.png", None),
        ("columns_rows.nii", labels.tolist()),
        ("rows_columns.nii", labels.T.tolist()),
        ("upside_down.nii", labels[::-1].tolist()),
    ):
        (case.folder / name).write_bytes(png(labels.tolist()) if array is None else nifti(array, affine=identity))
        case.change(contours=name)
        done = run("register", case.file, "--output", tmp_path / name, "--no-report")
        assert (array is None) != ("say nothing of how the picture lies" in done.stderr), done.stderr
        jaws = json.loads((tmp_path / name / "result.json").read_text())["jaws"]
        assert (name == "rows_columns.nii") == ("taken for an array [row, column]" in done.stderr)
        answers.append([(jaw["status"], jaw["projection_3x4"]) for jaw in jaws.values()])
    assert answers[1] == answers[0] and answers[2] == answers[0]
    # What was turned over is no answer that anybody takes.
    assert all(status != "ok" for status, _ in answers[3])


def test_labels_that_are_none_are_refused_in_words(run, tmp_path):
    nothing = [[0] * 10] * 10
    negative = [[-1] * 10] * 10
    for name, content, words in (
        ("empty.png", png(nothing), "all its pixels are 0"),
        ("negative.tif", tiff_int32(negative), "value -1"),
        ("cut.tif", tiff_int32(negative)[:100], "truncated"),
        ("scan.stl", b"solid x\nendsolid x\n", "STL mesh"),
    ):
        (tmp_path / name).write_bytes(content)
        done = run("contour", "--labels", tmp_path / name, "--output", tmp_path / "c.json")
        assert done.returncode == 2, done.stdout
        assert words in done.stderr, done.stderr


@pytest.fixture(scope="module")
def landmarks(run, sample, tmp_path_factory):
    """Of the sample as it is."""
    output = tmp_path_factory.mktemp("files") / "out"
    done = run("register", sample / "case.json", "--output", output, "--no-report")
    assert done.returncode == 0, done.stderr
    return {name: jaw["landmarks_px"] for name, jaw in json.loads((output / "result.json").read_text())["jaws"].items()}


def difference(landmarks, result):
    """Largest distance of a landmark's place from the sample's own, pixels."""
    return max(
        ((place[0] - here[0]) ** 2 + (place[1] - here[1]) ** 2) ** 0.5
        for name, jaw in landmarks.items()
        for place, here in ((jaw[point], result["jaws"][name]["landmarks_px"][point]) for point in jaw)
    )


def tracing_of(case):
    tracing = json.loads((case.folder / "contours.json").read_text())
    return tracing["image_size"], [
        (polyline["code"], polyline["points"])
        for jaw in tracing["contours"].values()
        for polyline in jaw
        if polyline["points"]
    ]


def from_corner(points):
    return [[u + 0.5, v + 0.5] for u, v in points]


def as_cvat(size, polylines):
    shapes = "".join(
        f'<polyline label="tooth {code}" points="{";".join(f"{u!r},{v!r}" for u, v in from_corner(points))}"/>'
        for code, points in polylines
    )
    return (
        '<?xml version="1.0" encoding="utf-8"?><annotations><version>1.1</version>'
        f'<image id="0" name="ceph.png" width="{size[0]}" height="{size[1]}">{shapes}'
        '<polyline label="soft tissue" points="1.0,1.0;2.0,2.0"/></image></annotations>'
    )


def as_via(size, polylines):
    regions = [
        {
            "shape_attributes": {
                "name": "polyline",
                "all_points_x": [u for u, _ in from_corner(points)],
                "all_points_y": [v for _, v in from_corner(points)],
            },
            "region_attributes": {"tooth": code},
        }
        for code, points in polylines
    ]
    return json.dumps({"ceph.png1": {"filename": "ceph.png", "size": 1, "regions": regions, "file_attributes": {}}})


def as_label_studio(size, polylines):
    result = [
        {
            "original_width": size[0],
            "original_height": size[1],
            "image_rotation": 0,
            "type": "polygonlabels",
            "value": {
                "points": [[100.0 * u / size[0], 100.0 * v / size[1]] for u, v in from_corner(points)],
                "closed": False,
                "polygonlabels": [code.lower()],
            },
        }
        for code, points in polylines
    ]
    return json.dumps([{"data": {"image": "ceph.png"}, "annotations": [{"result": result}]}])


def as_supervisely(size, polylines):
    objects = [
        {"classTitle": code, "geometryType": "line", "points": {"exterior": from_corner(points), "interior": []}}
        for code, points in polylines
    ]
    return json.dumps({"size": {"width": size[0], "height": size[1]}, "objects": objects})


def as_german_table(size, polylines):
    # Of a single column that is no coordinate the name does not matter.
    lines = ["Zahn;x (px);y (px)"]
    lines += [f"{code};{u!r};{v!r}".replace(".", ",") for code, points in polylines for u, v in points]
    return "\n".join(lines) + "\n"


def as_excel_table(size, polylines):
    return "sep=;\r\n" + as_german_table(size, polylines).replace("\n", "\r\n")


def as_coco(size, polylines):
    """As outlines of what each line encloses, with a slip of the mouse among them."""
    categories = [{"id": i, "name": code} for i, (code, _) in enumerate(polylines)]
    annotations = [
        {"id": i, "image_id": 1, "category_id": i, "segmentation": [[x for point in from_corner(there_and_back(points)) for x in point]]}
        for i, (_, points) in enumerate(polylines)
    ]
    annotations.append({"id": 999, "image_id": 1, "category_id": 0, "segmentation": [[5.0, 5.0, 6.0, 6.0]]})
    images = [{"id": 1, "file_name": "ceph.png", "width": size[0], "height": size[1]}]
    return json.dumps({"images": images, "annotations": annotations, "categories": categories})


def there_and_back(points):
    """A polygon that lies on a line: what a program that has polygons alone makes of it."""
    return points + points[-2:0:-1]


def as_via3(size, polylines):
    """Version 3 numbers pictures, views and attributes; 6 is a polyline."""
    shapes = {
        f"1_{i}": {"vid": "1", "flg": 0, "z": [], "xy": [6] + [x for point in from_corner(points) for x in point], "av": {"1": code}}
        for i, (code, points) in enumerate(polylines)
    }
    return json.dumps(
        {
            "project": {"pname": "c", "vid_list": ["1"]},
            "config": {},
            "attribute": {"1": {"aname": "tooth", "anchor_id": "FILE1_Z0_XY1", "type": 1, "options": {}}},
            "file": {"1": {"fid": "1", "fname": "ceph.png", "type": 2, "loc": 1, "src": ""}},
            "metadata": shapes,
            "view": {"1": {"fid_list": ["1"]}},
        }
    )


def as_export_with_a_title(size, polylines):
    """Lines about the patient, a count of the lines, and rows as wide as the widest one."""
    lines = ["Patient:;Test, A;;;", "Date:;2024-01-02;;;", ";;;;", "No;tooth_code;x_px;y_px;"]
    rows = [(code, u, v) for code, points in polylines for u, v in points]
    lines += [f"{i};{code};{u!r};{v!r};" for i, (code, u, v) in enumerate(rows)]
    return "\ufeff" + "\r\n".join(lines + [";;;;", ""])


def as_words_and_blanks(size, polylines):
    return "".join(f"tooth {code}   {u!r} {v!r}\n" for code, points in polylines for u, v in points)


FORMS = {
    "cvat.xml": as_cvat,
    "via3.json": as_via3,
    "title.csv": as_export_with_a_title,
    "blanks.txt": as_words_and_blanks,
    "via.json": as_via,
    "label_studio.json": as_label_studio,
    "supervisely.json": as_supervisely,
    "table.csv": as_german_table,
    "excel.csv": as_excel_table,
}


@pytest.mark.parametrize("name", FORMS)
def test_a_tracing_gives_one_answer_in_every_form(run, case, tmp_path, landmarks, name):
    size, polylines = tracing_of(case)
    (case.folder / name).write_text(FORMS[name](size, polylines))
    case.change(contours=name)
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    # The same numbers but for the last digits that per cent and half pixels cost.
    assert difference(landmarks, result) < 1e-3


def curve_of_slicer(points):
    """As 3D Slicer saves a curve: without its name, which is the file's and the beginning of its points' labels."""
    control = [{"id": str(i + 1), "label": f"C-{i + 1}", "position": [0.25 * u, 0.25 * v, 0.0]} for i, (u, v) in enumerate(points)]
    return {"markups": [{"type": "Curve", "coordinateSystem": "LPS", "coordinateUnits": "mm", "labelFormat": "%N-%d", "controlPoints": control}]}


def test_curves_of_slicer_a_file_each_are_one_tracing(run, case, tmp_path, landmarks):
    _, polylines = tracing_of(case)
    files = {}
    for code, points in polylines:
        files[code] = f"curve_{code}.mrk.json"
        (case.folder / files[code]).write_text(json.dumps(curve_of_slicer(points)))
    case.change(contours=files, markups_spacing_mm=[0.25, 0.25])
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    assert difference(landmarks, result) < 1e-3
    assert result["inputs"]["contours.UR1"]["path"] == "curve_UR1.mrk.json"


def as_labels(size, polylines):
    """What each line encloses, filled with the tooth's FDI number."""
    quadrants = {"UR": 10, "UL": 20, "LL": 30, "LR": 40}
    grid = numpy.stack(numpy.meshgrid(numpy.arange(size[0]), numpy.arange(size[1])), axis=-1).reshape(-1, 2)
    labels = numpy.zeros(size[0] * size[1], int)
    for code, points in polylines:
        labels[matplotlib.path.Path(points).contains_points(grid)] = quadrants[code[:2]] + int(code[2])
    return labels.reshape(size[1], size[0]).tolist()


def test_a_label_map_and_a_radiograph_of_nifti_register_as_those_of_png_do(run, case, tmp_path):
    rows = as_labels(*tracing_of(case))
    picture = [[int(round(255 * value)) for value in row] for row in matplotlib.image.imread(case.folder / "ceph.png").tolist()]
    cephalogram = case.load()["cephalogram"]
    results = {}
    for name, image, content in (
        ("labels.png", "ceph.png", png(rows)),
        ("labels.nii", "ceph.png", nifti(rows, "i")),
        ("labels.nii.gz", "ceph.nii.gz", nifti(rows, "f", packed=True)),
    ):
        (case.folder / name).write_bytes(content)
        if image != "ceph.png":
            (case.folder / image).write_bytes(nifti(picture, packed=True))
        case.change(contours=name, cephalogram=dict(cephalogram, image=image))
        done = run("register", case.file, "--output", tmp_path / name, "--no-report")
        assert done.returncode in (0, 1), done.stderr
        results[name] = json.loads((tmp_path / name / "result.json").read_text())["jaws"]
        for jaw in results[name].values():
            jaw.pop("seconds")
    assert results["labels.nii"] == results["labels.png"]
    assert results["labels.nii.gz"] == results["labels.png"]
    assert len(results["labels.png"]["upper"]["landmarks_px"]) > 5
    (case.folder / "labels.nii").write_bytes(nifti([row[:-1] for row in rows]))
    case.change(contours="labels.nii")
    done = run("register", case.file, "--output", tmp_path / "small", "--no-report")
    assert done.returncode == 2 and "labels.nii" in done.stderr and "702" in done.stderr, done.stderr


def test_a_slip_of_the_mouse_does_not_refuse_the_file(run, case, tmp_path):
    size, polylines = tracing_of(case)
    (case.folder / "coco.json").write_text(as_coco(size, [(code, points) for code, points in polylines if len(points) > 2]))
    case.change(contours="coco.json")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode in (0, 1), done.stderr
    assert done.stderr.count("is no outline: left out") == 1, done.stderr
    # In our own format somebody has written it, and means something else.
    content = case.load("contours.json")
    content["contours"]["upper"][0].update(closed=True, points=[[5, 5], [6, 6]])
    case.save(content, "contours.json")
    case.change(contours="contours.json")
    done = run("register", case.file, "--output", tmp_path / "own", "--no-report")
    assert done.returncode == 2 and "give it at least 3 points" in done.stderr, done.stderr


def test_a_header_without_a_column_of_labels_is_an_error_that_names_it(run, case, tmp_path):
    # Of several columns the one that names teeth is theirs; where none does, which it is has to be said.
    (case.folder / "table.csv").write_text("Patient,Nummer,x,y\nA,1,5,6\n")
    case.change(contours="table.csv")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 2 and 'name that column "label"' in done.stderr, done.stderr


def wceph(landmarks, **picture):
    """An archive as WebCeph writes it, with the pictures before the index."""
    landmarks = {name: {"x": u + 0.5, "y": v + 0.5} for name, (u, v) in landmarks.items()}
    entry = {"name": "ceph.png", "type": "ceph_lateral", "flipX": False, "flipY": False, **picture}
    entry["tracing"] = {"mode": "assisted", "scaleFactor": None, "manualLandmarks": landmarks, "skippedSteps": {}}
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("images/image_1", bytes(range(256)) * 40)
        archive.writestr("index.json", json.dumps({"version": 1, "refs": {"images": {}}, "data": {"image_1": entry}}))
    return content.getvalue()


@pytest.mark.parametrize("flipped", [False, True])
def test_webcephs_archive_registers_as_its_landmarks_do(run, standard_case, tmp_path, flipped):
    case = standard_case
    marks = {name: point["position"] if isinstance(point, dict) else point for name, point in case.load("cephalometric.json").items()}
    case.save(marks, "cephalometric.json")
    done = run("register", case.file, "--output", tmp_path / "json", "--no-report")
    names = {"U1_tip": "U1 Incisal Edge", "L1_tip": "L1 Incisal Edge", "U6_MB": "U6 MB", "L6_MB": "L6 MB"}
    (case.folder / "patient.wceph").write_bytes(
        wceph({"S": [9, 9], **{names[name]: point for name, point in marks.items()}}, flipX=flipped)
    )
    case.change(cephalometric_landmarks="patient.wceph")
    archive = run("register", case.file, "--output", tmp_path / "wceph", "--no-report")
    assert archive.returncode == done.returncode, archive.stderr
    assert ("shows this picture mirrored" in archive.stderr) == flipped
    result = json.loads((tmp_path / "wceph" / "result.json").read_text())
    plain = json.loads((tmp_path / "json" / "result.json").read_text())
    assert difference({name: jaw["landmarks_px"] for name, jaw in plain["jaws"].items()}, result) < 1e-3


def test_webcephs_archive_is_no_tracing_and_says_what_it_is(run, case, tmp_path):
    (case.folder / "patient.wceph").write_bytes(wceph({"U1": [5, 5]}))
    case.change(contours="patient.wceph")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 2 and "WebCeph" in done.stderr and "cephalometric_landmarks" in done.stderr, done.stderr


def markups(polylines, spacing, system="LPS"):
    sign = 1.0 if system == "LPS" else -1.0
    return json.dumps(
        {
            "markups": [
                {
                    "type": "Curve",
                    "name": code,
                    "coordinateSystem": system,
                    "coordinateUnits": "mm",
                    "controlPoints": [
                        {"position": [sign * u * spacing, sign * v * spacing, 0.0], "positionStatus": "defined"}
                        for u, v in points
                    ],
                }
                for code, points in polylines
            ]
        }
    )


def test_markups_in_millimetres_need_the_spacing_that_they_were_made_with(run, case, tmp_path, landmarks):
    size, polylines = tracing_of(case)
    (case.folder / "ceph.mrk.json").write_text(markups(polylines, 0.25, "RAS"))
    case.change(contours="ceph.mrk.json")
    done = run("register", case.file, "--output", tmp_path / "none", "--no-report")
    assert done.returncode == 2, done.stdout
    assert "markups_spacing_mm" in done.stderr
    case.change(markups_spacing_mm=[0.25, 0.25])
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    assert difference(landmarks, json.loads((tmp_path / "out" / "result.json").read_text())) < 1e-3


def test_markups_take_the_spacing_of_an_image_that_has_one(run, case, tmp_path, landmarks):
    size, polylines = tracing_of(case)
    header = (
        f"NRRD0004\ntype: uchar\ndimension: 2\nsizes: {size[0]} {size[1]}\nspacings: 0.2 0.2\nencoding: raw\n\n"
    ).encode()
    (case.folder / "ceph.nrrd").write_bytes(header + bytes(size[0] * size[1]))
    (case.folder / "ceph.mrk.json").write_text(markups(polylines, 0.2))
    cephalogram = dict(case.load()["cephalogram"], image="ceph.nrrd")
    case.change(contours="ceph.mrk.json", cephalogram=cephalogram)
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    assert difference(landmarks, json.loads((tmp_path / "out" / "result.json").read_text())) < 1e-3


def test_a_ruler_in_the_tracing_is_the_spacing_where_none_is_given(run, case, tmp_path):
    content = case.load()
    geometry = content["geometry"]
    spacing = content["cephalogram"]["pixel_spacing_mm"][0]
    magnification = geometry["source_to_detector_mm"] / geometry["source_to_midsagittal_mm"]
    size, polylines = tracing_of(case)
    # 30 mm in the midsagittal plane, which the rays enlarge on the detector.
    length = 30.0 * magnification / spacing
    ruler = ("Calibration_30mm", [[20.0, 20.0], [20.0, 20.0 + length]])
    text = as_cvat(size, polylines).replace("</image>", "")
    text = text.replace(
        "</annotations>",
        f'<polyline label="{ruler[0]}" points="20.5,20.5;20.5,{20.5 + length!r}"/></image></annotations>',
    )
    (case.folder / "cvat.xml").write_text(text)
    unknown = {"pixel_spacing_mm", "spacing_plane"}
    cephalogram = {key: value for key, value in content["cephalogram"].items() if key not in unknown}
    for plane, expected in ((None, spacing), ("detector", spacing / magnification)):
        case.change(contours="cvat.xml", cephalogram=dict(cephalogram, **({"spacing_plane": plane} if plane else {})))
        output = tmp_path / f"out-{plane}"
        done = run("register", case.file, "--output", output, "--no-report")
        assert done.returncode in (0, 1), done.stderr
        said = json.loads((output / "result.json").read_text())["geometry"]["pixel_spacing_mm"]
        assert said["value"] == pytest.approx([expected, expected], rel=1e-6)
        assert said["verdict"] == "Calibrated"
        assert "Calibration_30mm" in json.dumps(said)
    # One that the case gives goes before, and a ruler that is far off it is said.
    far = dict(content["cephalogram"], pixel_spacing_mm=[2.0 * spacing, 2.0 * spacing])
    case.change(cephalogram=far)
    done = run("register", case.file, "--output", tmp_path / "far", "--no-report")
    assert "Calibration_30mm" in done.stderr, done.stderr


def filled(size, points):
    """A mask of what a closed polyline encloses, by crossings of each row."""
    rows = [[0] * size[0] for _ in range(size[1])]
    for v in range(size[1]):
        crossings = sorted(
            a[0] + (v - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
            for a, b in zip(points, points[1:] + points[:1])
            if (a[1] <= v) != (b[1] <= v)
        )
        for left, right in zip(crossings[::2], crossings[1::2]):
            for u in range(max(0, int(left) + 1), min(size[0], int(right) + 1)):
                rows[v][u] = 255
    return rows


def test_one_mask_a_tooth_and_drawn_lines_are_read_by_the_case(run, case, tmp_path):
    size, polylines = tracing_of(case)
    files = {}
    for code, points in polylines:
        # The line as a pen of one pixel would draw it, black on white.
        rows = [[255] * size[0] for _ in range(size[1])]
        for a, b in zip(points, points[1:]):
            steps = max(1, int(2 * max(abs(b[0] - a[0]), abs(b[1] - a[1]))))
            for k in range(steps + 1):
                u = round(a[0] + k / steps * (b[0] - a[0]))
                v = round(a[1] + k / steps * (b[1] - a[1]))
                rows[v][u] = 0
        files[code] = f"line_{code}.png"
        (case.folder / files[code]).write_bytes(png(rows))
    case.change(contours=files)
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    # Half a pixel of a line's pixels, and the two ends: the landmarks stay within what the answer itself claims.
    for jaw in result["jaws"].values():
        assert jaw["status"] in ("ok", "suspect"), jaw["reasons"]
        assert jaw["error"]["mean_px"] < 2.5, jaw["error"]

    case.change(contours={"UR1": files[polylines[0][0]], "chin": files[polylines[0][0]]})
    done = run("register", case.file, "--output", tmp_path / "bad")
    assert done.returncode == 2
    assert "contours.chin" in done.stderr
    (case.folder / "small.png").write_bytes(png(filled([40, 40], [[5, 5], [30, 5], [30, 30], [5, 30]])))
    case.change(contours={"UR1": "small.png"})
    done = run("register", case.file, "--output", tmp_path / "bad")
    assert done.returncode == 2
    assert "40 x 40" in done.stderr


def test_a_scan_that_is_none_is_named_for_what_it_is(run, case, tmp_path):
    for name, content, words in (
        ("upper.dcm", b'<?xml version="1.0"?><HPS version="1.1"></HPS>', "3Shape"),
        ("upper.zip", b"PK\x03\x04\x14\0\0\0upper.stl", "ZIP"),
        ("upper.pdf", b"%PDF-1.4\n", "PDF"),
    ):
        (case.folder / name).write_bytes(content)
        case.change(upper=name)
        done = run("register", case.file, "--output", tmp_path / "out")
        assert done.returncode == 2
        assert words in done.stderr, done.stderr
        assert "STL" in done.stderr or "unpack" in done.stderr, done.stderr


def test_a_tracing_of_no_known_form_is_named_for_how_it_begins(run, case, tmp_path):
    """"JSON syntax error" helps nobody who named a file of another program."""
    for name, content, words in (
        ("t.tps", "LM=2\n1 2\n3 4\nIMAGE=ceph.png\nID=0\n", "lower one"),
        ("t.yaml", "UR1:\n  - [1, 2]\n", 'begins with "UR1:"'),
        ("t.bin", "\x01\x02\x03", "nor is it text"),
        ("t.txt", "0 0.71 0.52 0.72 0.53 0.74 0.52\n", "YOLO"),
        ("t.geojson", '{"type": "FeatureCollection", "features": []}', "is GeoJSON, as QuPath writes it"),
        ("t.json", '[{"Labeled Data": "ceph.png", "Label": {}}]', "is JSON of Labelbox"),
        ("t.json", '[{"drawn": "ceph.png", "Lines": {}}]', "drawn, Lines"),
    ):
        (case.folder / name).write_text(content)
        case.change(contours=name)
        done = run("register", case.file, "--output", tmp_path / "out")
        assert done.returncode == 2
        assert words in done.stderr and "JSON syntax error" not in done.stderr, done.stderr
        assert len(done.stderr.splitlines()) == 1
    (case.folder / "landmarks.tps").write_text("LM=2\n1 2\n3 4\n")
    case.change(contours="contours.json", cephalometric_landmarks="landmarks.tps")
    done = run("register", case.file, "--output", tmp_path / "out")
    assert done.returncode == 2 and "tpsDig" in done.stderr, done.stderr


def with_orientation(content, orientation):
    """A PNG with the chunk that tells viewers how to turn it."""
    exif = b"II*\0\x08\0\0\0\x01\0" + struct.pack("<HHII", 274, 3, 1, orientation) + b"\0\0\0\0"
    chunk = b"eXIf" + exif
    chunk = struct.pack(">I", len(exif)) + chunk + struct.pack(">I", zlib.crc32(chunk))
    end = 8 + 25
    return content[:end] + chunk + content[end:]


@pytest.mark.parametrize(("orientation", "stored"), [(3, lambda rows: rows[::-1, ::-1]), (6, lambda rows: numpy.rot90(rows))])
def test_a_png_is_turned_as_its_orientation_says(run, case, tmp_path, landmarks, orientation, stored):
    file = case.folder / "ceph.png"
    rows = numpy.rint(255.0 * matplotlib.image.imread(file)).astype(numpy.uint8)
    file.write_bytes(with_orientation(png(numpy.ascontiguousarray(stored(rows))), orientation))
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    assert f"orientation: {orientation} in the file turns the picture upright" in done.stderr
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    assert difference(landmarks, result) == 0.0
    assert all(jaw["status"] == "ok" for jaw in result["jaws"].values()), done.stderr


def test_numbers_that_no_radiograph_has_are_warned_of(run, case, tmp_path):
    content = case.load()
    content["cephalogram"]["pixel_spacing_mm"][1] *= 1.1
    content["geometry"]["principal_point_px"] = [1407.0, 185.0]
    case.save(content)
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert "no squares" in done.stderr and "lies outside the radiograph" in done.stderr, done.stderr


def test_a_case_that_was_written_on_windows_parts_folders_by_backslashes(run, case, tmp_path, landmarks):
    (case.folder / "scans").mkdir()
    (case.folder / "upper.stl").rename(case.folder / "scans" / "upper.stl")
    case.change(upper="scans\\upper.stl")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    assert difference(landmarks, json.loads((tmp_path / "out" / "result.json").read_text())) == 0.0
    case.change(upper="scans\\lower.stl")
    done = run("register", case.file, "--output", tmp_path / "no", "--no-report")
    assert done.returncode == 2 and 'there is no file "scans\\lower.stl"' in done.stderr, done.stderr


def test_bytes_behind_a_binary_stl_are_left_alone_and_named(run, case, tmp_path, landmarks):
    path = case.folder / "upper.stl"
    path.write_bytes(path.read_bytes() + b"COLOR=\x01\x02")
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    assert "8 bytes behind its" in done.stderr
    assert difference(landmarks, json.loads((tmp_path / "out" / "result.json").read_text())) == 0.0


def test_codes_in_words_and_without_a_side(run, case, tmp_path, landmarks):
    tracing = json.loads((case.folder / "contours.json").read_text())
    spelled = {"U": "1.", "L": "4."}
    for jaw in tracing["contours"].values():
        for polyline in jaw:
            code = polyline["code"]
            polyline["code"] = f" tooth {spelled[code[0]]}{code[2]}" if code[1] == "R" else code.lower()
    (case.folder / "contours.json").write_text(json.dumps(tracing))
    done = run("register", case.file, "--output", tmp_path / "out", "--no-report")
    assert done.returncode == 0, done.stderr
    assert difference(landmarks, json.loads((tmp_path / "out" / "result.json").read_text())) == 0.0

    for jaw in tracing["contours"].values():
        for polyline in jaw:
            polyline["code"] = "U" if jaw is tracing["contours"]["upper"] else "L"
            polyline["code"] += "1"
    (case.folder / "contours.json").write_text(json.dumps(tracing))
    case.change(traced_side="both")
    done = run("register", case.file, "--output", tmp_path / "bad")
    assert done.returncode == 2
    assert "traced_side" in done.stderr
