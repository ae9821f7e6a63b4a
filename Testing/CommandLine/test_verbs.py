"""The verbs beside register, on files that they can use."""
import json
import math
import pathlib
import struct
import zlib

import pytest

from transform_file import is_anatomical, read_transform


def png_size(path):
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", data[16:24])


def write_grey_png(path, rows):
    """An 8-bit grey PNG without any library."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    pixels = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", pixels) + chunk(b"IEND", b""))


@pytest.fixture(scope="module")
def result(run, sample, tmp_path_factory):
    folder = tmp_path_factory.mktemp("verbs") / "out"
    assert run("register", sample / "case.json", "--output", folder).returncode == 0
    return folder / "result.json"


@pytest.fixture
def labels(tmp_path):
    """Two discs: FDI 11 at (30, 40) and 41 at (70, 40), radius 12."""
    rows = [[0] * 100 for _ in range(80)]
    for v in range(80):
        for u in range(100):
            if (u - 30) ** 2 + (v - 40) ** 2 <= 144:
                rows[v][u] = 11
            if (u - 70) ** 2 + (v - 40) ** 2 <= 144:
                rows[v][u] = 41
    write_grey_png(tmp_path / "labels.png", rows)
    return tmp_path / "labels.png"


def test_axis_writes_frames_in_which_the_arch_is_symmetric(run, sample, tmp_path):
    done = run("axis", "--case", sample / "case.json", "--embed-axes", "--output", tmp_path / "axes")
    assert done.returncode == 0, done.stderr
    names = {path.name for path in (tmp_path / "axes").iterdir()}
    assert names == {"axis.json", "upper_umda.stl", "lower_umda.stl", "upper_umda.tfm", "lower_umda.tfm"}
    axis = json.loads((tmp_path / "axes" / "axis.json").read_text())
    landmarks = json.loads((sample / "landmarks3d.json").read_text())
    for jaw, side in (("upper", "U"), ("lower", "L")):
        x, y, z, origin = (axis[jaw][key] for key in ("x_anterior", "y_left", "z_superior", "origin_mm"))

        def along(axis_row, name):
            return sum(a * (p - o) for a, p, o in zip(axis_row, landmarks[name], origin))

        assert along(y, f"{side}R6_MB") < -10 and along(y, f"{side}L6_MB") > 10
        assert along(x, f"{side}R1_tip") > along(x, f"{side}R6_MB") + 10
        assert (along(z, f"{side}R1_tip") < 0) == (jaw == "upper")
        assert 30 < axis[jaw]["arch_width_mm"] < 120

        transform = read_transform(tmp_path / "axes" / f"{jaw}_umda.tfm")
        places = {name: transform(landmarks[name]) for name in landmarks if name.startswith(side)}
        assert is_anatomical(places, side)
        for name, place in places.items():
            expected = [along(axis_row, name) for axis_row in (x, y, z)]
            # A square root of 1 - |v|^2 loses half of the digits where the rotation is near half a turn.
            assert place == pytest.approx(expected, abs=1e-6)


def test_render_makes_a_picture_that_covers_the_scans(run, sample, tmp_path):
    for mode in ("thickness", "intensity", "radiograph"):
        done = run("render", "--case", sample / "case.json", "--mode", mode, "--output", tmp_path / f"{mode}.png")
        assert done.returncode == 0, done.stderr
        width, height = png_size(tmp_path / f"{mode}.png")
        assert 100 < width < 1000 and 40 < height < 1000


def test_render_of_a_result_has_the_radiographs_grid(run, sample, result, tmp_path):
    done = run("render", "--case", sample / "case.json", "--result", result, "--output", tmp_path / "drr.png")
    assert done.returncode == 0, done.stderr
    contours = json.loads((sample / "contours.json").read_text())
    assert list(png_size(tmp_path / "drr.png")) == contours["image_size"]


def test_render_and_contour_of_a_result_are_where_the_case_was_registered(run, sample, result, tmp_path):
    """With the scale that was estimated: places on the scan are drawn where the result has them."""
    content = json.loads(result.read_text())
    done = run("contour", "--case", sample / "case.json", "--result", result, "--output", tmp_path / "c.json")
    assert done.returncode == 0, done.stderr
    whole = json.loads((result.parent / "report.json").read_text())["views"][0]["jaws"]["upper"]["contours"]["whole"]
    drawn = json.loads((tmp_path / "c.json").read_text())["contours"]["upper"]

    def box(polylines):
        points = [point for polyline in polylines for point in polyline["points"]]
        return [f(point[d] for point in points) for d in (0, 1) for f in (min, max)]

    assert box(drawn) == pytest.approx(box(whole), abs=0.5)
    # The same of a result that says another scale: it is heeded.
    for jaw in content["jaws"].values():
        principal = content["geometry"]["principal_point_px"]["value"]
        rows = jaw["projection_3x4"]
        for row in (0, 1):
            rows[row] = [principal[row] * depth + 1.1 * (x - principal[row] * depth) for x, depth in zip(rows[row], rows[2])]
    (tmp_path / "larger.json").write_text(json.dumps(content))
    done = run("contour", "--case", sample / "case.json", "--result", tmp_path / "larger.json", "--output", tmp_path / "l.json")
    assert done.returncode == 0, done.stderr
    larger = box(json.loads((tmp_path / "l.json").read_text())["contours"]["upper"])
    assert larger[1] - larger[0] == pytest.approx(1.1 * (box(drawn)[1] - box(drawn)[0]), rel=0.01)


def test_a_result_is_named_by_its_folder_as_well(run, sample, result, tmp_path):
    for name, place in (("file", result), ("folder", result.parent)):
        done = run("contour", "--case", sample / "case.json", "--result", place, "--output", tmp_path / f"{name}.json")
        assert done.returncode == 0, done.stderr
    assert (tmp_path / "file.json").read_bytes() == (tmp_path / "folder.json").read_bytes()


WRONG_RESULTS = {
    "schema": (lambda content: content.update(schema="dentalscr-result/99"), "schema: ", "register the case again"),
    "no schema": (lambda content: content.pop("schema"), "schema: ", "name a result.json"),
    "unit": (lambda content: content.update(mesh_unit="ell"), "mesh_unit: ", "register the case again"),
    "jaw": (lambda content: content["jaws"].pop("lower"), "jaws.lower: ", "reasons"),
    "failed jaw": (lambda content: content["jaws"]["lower"].pop("projection_3x4"), "jaws.lower.projection_3x4: ", "reasons"),
    "rows": (lambda content: content["jaws"]["upper"]["projection_3x4"].pop(), "jaws.upper.projection_3x4: ", "register the case again"),
    "no projection": (
        lambda content: content["jaws"]["upper"].update(projection_3x4=[[0] * 4] * 3),
        "jaws.upper.projection_3x4: ",
        "register the case again",
    ),
    "distance": (
        lambda content: content["geometry"]["source_to_detector_mm"].update(value=-1),
        "geometry: ",
        "register the case again",
    ),
}


@pytest.mark.parametrize("verb", ["render", "contour"])
@pytest.mark.parametrize("wrong", WRONG_RESULTS)
def test_a_wrong_result_is_an_error_that_names_file_and_field(run, sample, result, tmp_path, verb, wrong):
    change, field, remedy = WRONG_RESULTS[wrong]
    content = json.loads(result.read_text())
    change(content)
    (tmp_path / "wrong.json").write_text(json.dumps(content))
    done = run(verb, "--case", sample / "case.json", "--result", tmp_path / "wrong.json", "--output", tmp_path / ("x.mha" if verb == "render" else "x.json"))
    assert done.returncode == 2
    assert f"wrong.json: {field}" in done.stderr and remedy in done.stderr, done.stderr
    assert not (tmp_path / ("x.mha" if verb == "render" else "x.json")).exists()


def test_render_without_a_spacing_says_what_to_give(run, sample, tmp_path):
    done = run("render", "--upper", sample / "upper.stl", "--output", tmp_path / "drr.png")
    assert done.returncode == 2 and "--spacing" in done.stderr
    assert not (tmp_path / "drr.png").exists()


def test_contour_of_scans_alone(run, sample, tmp_path):
    done = run(
        "contour", "--upper", sample / "upper.stl", "--spacing", 0.25, 0.25, "--points", 200, "--output", tmp_path / "c.json"
    )
    assert done.returncode == 0, done.stderr
    contours = json.loads((tmp_path / "c.json").read_text())
    (upper,) = contours["contours"]["upper"]
    assert upper["closed"] and len(upper["points"]) == 200
    width, height = contours["image_size"]
    assert all(0 <= u < width and 0 <= v < height for u, v in upper["points"])


def test_contour_of_a_result_encloses_the_landmarks(run, sample, result, tmp_path):
    done = run("contour", "--case", sample / "case.json", "--result", result, "--output", tmp_path / "c.json")
    assert done.returncode == 0, done.stderr
    contours = json.loads((tmp_path / "c.json").read_text())["contours"]
    landmarks = json.loads(result.read_text())["jaws"]["upper"]["landmarks_px"]
    points = contours["upper"][0]["points"]
    box = [(min(p[d] for p in points) - 1, max(p[d] for p in points) + 1) for d in (0, 1)]
    for position in landmarks.values():
        assert all(low <= c <= high for c, (low, high) in zip(position, box))


@pytest.mark.parametrize("points", [None, 50])
def test_contour_of_labels_knows_teeth_and_jaws(run, labels, tmp_path, points):
    more = [] if points is None else ["--points", points]
    done = run("contour", "--labels", labels, "--output", tmp_path / "c.json", *more)
    assert done.returncode == 0, done.stderr
    contours = json.loads((tmp_path / "c.json").read_text())
    assert contours["image_size"] == [100, 80]
    (upper,) = contours["contours"]["upper"]
    (lower,) = contours["contours"]["lower"]
    assert upper["code"] == "UR1" and lower["code"] == "LR1" and upper["closed"]
    for tooth, centre in ((upper, 30), (lower, 70)):
        radii = [((u - centre) ** 2 + (v - 40) ** 2) ** 0.5 for u, v in tooth["points"]]
        assert min(radii) > 11 and max(radii) < 13.5


def test_contour_of_other_labels_says_whole(run, labels, tmp_path):
    write_grey_png(labels, [[0] * 20] * 5 + [[0] * 5 + [200] * 10 + [0] * 5] * 10 + [[0] * 20] * 5)
    done = run("contour", "--labels", labels, "--output", tmp_path / "c.json")
    assert done.returncode == 2 and "--whole" in done.stderr
    done = run("contour", "--labels", labels, "--whole", "--jaw", "lower", "--output", tmp_path / "c.json")
    assert done.returncode == 0, done.stderr
    contours = json.loads((tmp_path / "c.json").read_text())["contours"]
    assert contours["upper"] == [] and len(contours["lower"]) == 1


def test_evaluate_agrees_with_the_result(run, sample, result, tmp_path):
    landmarks = sample / "landmarks2d.json"
    done = run("evaluate", result, result, "--landmarks", landmarks, "--landmarks", landmarks, "--csv", tmp_path / "t.csv")
    assert done.returncode == 0, done.stderr
    rows = [line.split(",") for line in (tmp_path / "t.csv").read_text().splitlines()]
    assert rows[0][:4] == ["case", "jaw", "landmarks", "mean_px"]
    jaws = json.loads(result.read_text())["jaws"]
    for row in rows[1:]:
        assert float(row[3]) == pytest.approx(jaws[row[1]]["error"]["mean_px"], abs=1e-5)
    # Twice the same case: the pooled rows have twice the landmarks.
    assert [int(row[2]) for row in rows[-2:]] == [2 * int(row[2]) for row in rows[1:3]]


def test_evaluate_takes_folders_and_the_landmarks_that_the_case_names(run, sample, result, tmp_path):
    by_name = run("evaluate", result, "--landmarks", sample / "landmarks2d.json", "--csv", tmp_path / "named.csv")
    assert by_name.returncode == 0, by_name.stderr
    assert run("evaluate", result.parent, "--csv", tmp_path / "folder.csv").returncode == 0
    assert (tmp_path / "folder.csv").read_text() == (tmp_path / "named.csv").read_text()
    # A folder of results, one of which has no marks: it is named and left out.
    for name in ("b", "a"):
        (tmp_path / "results" / name).mkdir(parents=True)
        content = json.loads(result.read_text())
        (tmp_path / "results" / name / "result.json").write_text(json.dumps(content))
    (tmp_path / "results" / "c").mkdir()
    content["inputs"].pop("landmarks_2d")
    (tmp_path / "results" / "c" / "result.json").write_text(json.dumps(content))
    done = run("evaluate", tmp_path / "results", "--csv", tmp_path / "all.csv")
    assert done.returncode == 0 and "c/result.json is left out" in done.stderr
    rows = [line.split(",") for line in (tmp_path / "all.csv").read_text().splitlines()[1:]]
    assert [pathlib.Path(row[0]).parent.name for row in rows] == ["a", "a", "b", "b", "", ""]
    assert [int(row[2]) for row in rows[-2:]] == [2 * int(row[2]) for row in rows[:2]]
    for folder, words in ((tmp_path / "results" / "c", "names landmarks"), (sample, "no result.json")):
        done = run("evaluate", folder)
        assert done.returncode == 2 and words in done.stderr


@pytest.mark.parametrize("name", ["x.csv", "x.mrk.json", "x.png"])
def test_json_is_written_under_a_name_of_json_only(run, labels, result, sample, tmp_path, name):
    """Who asks for a table must not get JSON under its name."""
    for words in (
        ("contour", "--labels", labels), ("project", result, "--points", sample / "landmarks3d.json"), ("new", sample),
    ):
        done = run(*words, "--output", tmp_path / name)
        assert done.returncode == 2 and "ends in .json" in done.stderr, words
        assert not (tmp_path / name).exists()


def test_width_of_the_splats_is_mm_as_everywhere(run, sample, tmp_path):
    """The same width in mm: half as many pixels where they are twice as large, and the default is that of the filter."""
    for name, words in (("default", ()), ("half", ("--sigma", "0.5"))):
        done = run("render", "--upper", sample / "upper.stl", "--spacing", 0.25, 0.25, *words, "--output", tmp_path / f"{name}.mha")
        assert done.returncode == 0, done.stderr
    assert (tmp_path / "default.mha").read_bytes() == (tmp_path / "half.mha").read_bytes()
    done = run("render", "--upper", sample / "upper.stl", "--spacing", 0.25, 0.25, "--sigma", "30", "--output", tmp_path / "x.mha")
    assert done.returncode == 2


def test_phantom_has_the_same_bits_for_the_same_seed(run, tmp_path):
    for name, threads in (("a", 1), ("b", 2)):
        done = run(
            "phantom", "--seed", 5, "--triangles", 6000, "--threads", threads, "--output", tmp_path / name
        )
        assert done.returncode == 0, done.stderr
    for path in (tmp_path / "a").iterdir():
        assert path.read_bytes() == (tmp_path / "b" / path.name).read_bytes(), path.name
    done = run("phantom", "--seed", 5, "--output", tmp_path / "a")
    assert done.returncode == 2 and "already" in done.stderr


def test_phantom_without_a_radiograph_is_the_same_case(run, tmp_path):
    for name, options in (("with", ()), ("without", ("--no-radiograph",))):
        done = run("phantom", "--seed", 5, "--triangles", 6000, *options, "--output", tmp_path / name)
        assert done.returncode == 0, done.stderr
    names = {path.name for path in (tmp_path / "with").iterdir()}
    assert names - {path.name for path in (tmp_path / "without").iterdir()} == {"ceph.png"}
    for name in names - {"ceph.png", "case.json"}:
        assert (tmp_path / "with" / name).read_bytes() == (tmp_path / "without" / name).read_bytes(), name
    case = json.loads((tmp_path / "with" / "case.json").read_text())
    assert case["cephalogram"].pop("image") == "ceph.png"
    assert json.loads((tmp_path / "without" / "case.json").read_text()) == case


@pytest.mark.parametrize("side", ["left", "mean", "both"])
def test_every_traced_side(run, tmp_path, side):
    made = run("phantom", "--seed", 4, "--triangles", 12000, "--traced-side", side, "--output", tmp_path / "case")
    assert made.returncode == 0, made.stderr
    done = run("register", tmp_path / "case" / "case.json", "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    for jaw in json.loads((tmp_path / "out" / "result.json").read_text())["jaws"].values():
        # Twice the limit of method.md for the worst case of a bisected tracing: a coarse mesh.
        assert jaw["error"]["mean_px"] < 2.6


def test_real_phantom_registers_and_tells_its_traits(run, tmp_path):
    parameters = tmp_path / "mine.json"
    parameters.write_text('{"level": "real", "traits": {"open_bite_probability": 1}, "scan": {"frame": "shared"}}')
    done = run("phantom", "--parameters", parameters, "--seed", 2, "--no-radiograph", "--output", tmp_path / "case")
    assert done.returncode == 0, done.stderr
    truth = json.loads((tmp_path / "case" / "truth.json").read_text())
    assert truth["cohort"] == "real"
    assert "open_bite" in [trait["name"] for trait in truth["traits"]]
    assert truth["parameters"]["traits"]["open_bite_probability"] == 1
    done = run("register", tmp_path / "case" / "case.json", "--output", tmp_path / "out")
    # The reader takes it; how well it registers is a matter of studies.
    assert done.returncode in (0, 1), done.stderr
    assert set(json.loads((tmp_path / "out" / "result.json").read_text())["jaws"]) == {"upper", "lower"}


def test_parameters_of_a_phantom_are_printed_and_read_back(run, tmp_path):
    shown = run("phantom", "--level", "practice", "--show-parameters")
    assert shown.returncode == 0, shown.stderr
    (tmp_path / "practice.json").write_text(shown.stdout)
    again = run("phantom", "--parameters", tmp_path / "practice.json", "--show-parameters")
    assert again.stdout == shown.stdout


@pytest.mark.parametrize(
    "text, words",
    [
        ('{"traits": {"open_bite": 1}}', ["traits.open_bite", "open_bite_probability"]),
        ('{"scan": {"triangles": 5}}', ["scan.triangles"]),
        ('{"tracing": {"side": "up"}}', ["tracing.side", "standard"]),
        ('{"level": "awful"}', ["level", "practice"]),
        ('{"traits": ', ["line 1"]),
    ],
)
def test_wrong_parameters_of_a_phantom_are_named(run, tmp_path, text, words):
    (tmp_path / "mine.json").write_text(text)
    done = run("phantom", "--parameters", tmp_path / "mine.json", "--output", tmp_path / "case")
    assert done.returncode == 2
    assert "mine.json" in done.stderr
    for word in words:
        assert word in done.stderr
    assert not (tmp_path / "case").exists()


def test_practice_phantom_has_outlines_landmarks_and_a_frontal_view(run, tmp_path):
    parameters = tmp_path / "mine.json"
    parameters.write_text(
        '{"level": "practice", "frontal": {"given": true}, "tracing": {"confidence": "informative"},'
        ' "landmarks": {"form": "sigma", "apices": true}}'
    )
    done = run("phantom", "--parameters", parameters, "--seed", 8, "--no-radiograph", "--output", tmp_path / "case")
    assert done.returncode == 0, done.stderr
    files = {path.name: json.loads(path.read_text()) for path in (tmp_path / "case").glob("*.json")}
    case = files["case.json"]
    assert case["traced_side"] == "standard"
    outlines = files[case["contours"]]["contours"]
    assert [outline["code"] for outline in outlines["upper"] + outlines["lower"]] == ["UR1", "UR6", "LR1", "LR6"]
    for outline in outlines["upper"] + outlines["lower"]:
        assert outline["closed"] and outline["outline"] == "tooth" and outline["sigma_px"] > 0
    landmarks = files[case["cephalometric_landmarks"]]
    assert set(landmarks) == {"U1_tip", "U1A", "U6_MB", "L1_tip", "L1A", "L6_MB"}
    for name, landmark in landmarks.items():
        # 0.45 and 0.6 mm at 0.25 mm a pixel, a spread of lognormal 0.4; one in a hundred is grossly off.
        exact = files["truth.json"]["cephalometric_landmarks"][name]
        if not exact["gross"]:
            error = math.dist(landmark["position"], exact["exact"])
            assert error < 5 * exact["sigma_px"] + 3
    assert "contours" not in files["case-landmarks.json"]
    assert "cephalometric_landmarks" not in files["case-outlines.json"]
    view = case["views"][0]
    assert view["direction"] == "frontal" and view["cephalogram"]["patient_left"] == "right"
    assert files["truth.json"]["views"]["frontal"]["noise_px"]["correlation_length"] == 15.0
    matrices = files["truth.json"]["views"]["frontal"]["projection_3x4"]
    for name, (u, v) in files[view["cephalometric_landmarks"]].items():
        point = files["landmarks3d.json"][name] + [1]
        h = [sum(a * b for a, b in zip(row, point)) for row in matrices["upper" if name[0] == "U" else "lower"]]
        # 0.5 mm an axis.
        assert math.dist((h[0] / h[2], h[1] / h[2]), (u, v)) < 4 * 0.5 / 0.24 * 1.5


def test_experiment_draws_the_phantoms_levels(run, tmp_path):
    done = run(
        "experiment", "--level", "practice", "--cases", 1, "--methods", "robust", "--no-figures", "--output", tmp_path
    )
    assert done.returncode == 0, done.stderr
    assert "practice-0001" in (tmp_path / "cases.csv").read_text()
