"""Crowns as filled regions, as segmentations of radiographs have them: registered as one label map, and as masks of one
tooth each."""
import collections
import json
import math

import numpy
import pytest

from png_file import png
from program_runs import STL_RECORD

Crown = collections.namedtuple("Crown", "first region")

# Quadrants of FDI.
QUADRANTS = {"UR": 1, "UL": 2, "LL": 3, "LR": 4}
# Of the grid that regions are made on, an image pixel.
FINE = 4
# As far from the tip as crowns go, and from the middle of a tooth, mm.
CROWN_HEIGHT = 7.0
CROWN_RADIUS = 6.5
# A reader's own from tooth to tooth, px.
TOOTH_ERROR = 0.5


def fill(corners):
    """A filled region of triangles of shape n x 3 x 2 in continuous pixel indices, with the edge that a brush leaves."""
    first = numpy.floor(corners.reshape(-1, 2).min(0)).astype(int) - 4
    size = numpy.ceil(corners.reshape(-1, 2).max(0)).astype(int) + 5 - first
    fine = numpy.zeros((size[1] * FINE, size[0] * FINE))
    # Pixel (0, 0) has its centre there. Holes in the few longest triangles the brush closes.
    scaled = (corners - first + 0.5) * FINE
    lengths = numpy.linalg.norm(scaled - numpy.roll(scaled, 1, 1), axis=2)
    steps = math.ceil(1.5 * numpy.percentile(lengths, 95))
    for i in range(steps + 1):
        for j in range(steps + 1 - i):
            points = (i * scaled[:, 0] + j * scaled[:, 1] + (steps - i - j) * scaled[:, 2]) / steps
            fine[tuple(points.astype(int).T[::-1])] = 1.0
    radius = 3 * FINE
    kernel = numpy.exp(-0.5 * (numpy.arange(-radius, radius + 1) / (1.2 * FINE)) ** 2)
    kernel /= kernel.sum()
    for axis in (0, 1):
        fine = numpy.apply_along_axis(numpy.convolve, axis, fine, kernel, mode="same")
    share = (fine > 0.5).reshape(size[1], FINE, size[0], FINE).mean((1, 3))
    return Crown(first, share > 0.5)


def find_crowns(folder, jaw, numbers):
    """Regions of the crowns of the right side by their FDI codes, where the true projection puts them."""
    landmarks = json.loads((folder / "landmarks3d.json").read_text())
    matrix = numpy.array(json.loads((folder / "truth.json").read_text())["projection_3x4"][jaw])
    data = (folder / f"{jaw}.stl").read_bytes()
    corners = numpy.frombuffer(data, STL_RECORD, offset=84)["corners"].astype(float)
    centres = corners.mean(1)
    teeth = collections.defaultdict(list)
    for name, place in landmarks.items():
        if (name[0] == "U") == (jaw == "upper"):
            teeth[name.split("_")[0]].append(place)
    middles = numpy.array([numpy.mean(places, 0) for places in teeth.values()])
    # The occlusal plane, and the way from it to the roots.
    origin = middles.mean(0)
    plane = numpy.linalg.svd(middles - origin)[2]
    rootward = plane[2] * numpy.sign((centres.mean(0) - origin) @ plane[2])
    along = plane[:2].T
    distances = numpy.linalg.norm(((centres - origin) @ along)[:, None] - ((middles - origin) @ along)[None], axis=2)
    depths = (centres - origin) @ rootward
    found = {}
    for i, (code, places) in enumerate(teeth.items()):
        if code[1] != "R":
            continue
        tip = min((numpy.array(place) - origin) @ rootward for place in places)
        is_crown = (distances.argmin(1) == i) & (distances[:, i] < CROWN_RADIUS) & (depths < tip + CROWN_HEIGHT)
        homogeneous = numpy.concatenate([corners[is_crown], numpy.ones((is_crown.sum(), 3, 1))], 2) @ matrix.T
        projected = homogeneous[..., :2] / homogeneous[..., 2:]
        found[QUADRANTS[code[:2]] * 10 + int(code[2])] = fill(projected + numbers.normal(0.0, TOOTH_ERROR, 2))
    return found


def paint(image, crown, value):
    """Over what is there, as programs with one label a pixel do."""
    rows, columns = crown.region.shape
    part = image[crown.first[1] : crown.first[1] + rows, crown.first[0] : crown.first[0] + columns]
    part[crown.region[: part.shape[0], : part.shape[1]]] = value


@pytest.fixture(scope="module", params=[4201, 4203])
def drawn(run, request, tmp_path_factory):
    """A phantom with crowns for its tracing."""
    folder = tmp_path_factory.mktemp("crowns") / "case"
    arguments = ("--level", "typical", "--seed", request.param, "--triangles", 30000, "--no-radiograph")
    done = run("--threads", 1, "phantom", *arguments, "--output", folder)
    assert done.returncode == 0, done.stderr
    numbers = numpy.random.default_rng(request.param)
    crowns = {**find_crowns(folder, "lower", numbers), **find_crowns(folder, "upper", numbers)}
    assert len(crowns) >= 12
    return folder, crowns


def check_registration(run, folder, output, **fields):
    case = json.loads((folder / "case.json").read_text())
    file = folder / f"{output.name}.json"
    file.write_text(json.dumps({**case, **fields}))
    done = run("--threads", 1, "register", file, "--output", output, "--no-report")
    assert done.returncode == 0, done.stderr
    jaws = json.loads((output / "result.json").read_text())["jaws"]
    for name in ("upper", "lower"):
        figures = (name, jaws[name]["error"]["mean_px"], jaws[name]["reasons"])
        assert jaws[name]["status"] == "ok", figures
        # 0.14 to 0.75 px of six such cases.
        assert jaws[name]["error"]["mean_px"] < 1.5, figures


def image_size(folder):
    return json.loads((folder / "contours.json").read_text())["image_size"]


def test_a_label_map_of_the_crowns_of_both_jaws_registers(run, drawn, tmp_path):
    """Where the front teeth overlap in the bite the jaw that is painted last has the pixels."""
    folder, crowns = drawn
    width, height = image_size(folder)
    labels = numpy.zeros((height, width), numpy.uint8)
    for code, crown in crowns.items():
        paint(labels, crown, code)
    assert set(numpy.unique(labels)) == {0, *crowns}
    (folder / "labels.png").write_bytes(png(labels))
    check_registration(run, folder, tmp_path / "labels", contours="labels.png")


def test_masks_of_one_crown_each_register(run, drawn, tmp_path):
    folder, crowns = drawn
    width, height = image_size(folder)
    files = {}
    for code, crown in crowns.items():
        mask = numpy.zeros((height, width), numpy.uint8)
        paint(mask, crown, 255)
        files[str(code)] = f"mask{code}.png"
        (folder / files[str(code)]).write_bytes(png(mask))
    check_registration(run, folder, tmp_path / "masks", contours=files, numbering="FDI")
