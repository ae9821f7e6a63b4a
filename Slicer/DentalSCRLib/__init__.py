"""What the modules for 3D Slicer share. It needs Python and numpy, and nothing of Slicer, so that it can be tested without it.

Slicer's world is LPS, mm: left, posterior, superior. The program's is the cephalostat frame, x anterior, y to the patient's left,
z superior, and for a radiograph its continuous pixel indices (Documentation/Geometry.md). All that crosses is converted here.
"""
import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import numpy

#: (x, y, z) of the cephalostat frame to (L, P, S).
LPS_FROM_CEPHALOSTAT = numpy.array([[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], dtype=float)

# As Slicer writes them.
MARKUPS_SCHEMA = (
    "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json#"
)


class ProgramError(RuntimeError):
    """The program could not do what was asked; the message is its own."""


def find_program():
    """The words that start the program: DENTALSCR_PROGRAM, that beside these modules, of this Python's package, or on the PATH."""
    named = os.environ.get("DENTALSCR_PROGRAM")
    if named:
        if not pathlib.Path(named).is_file():
            raise ProgramError(f"DENTALSCR_PROGRAM is {named}, and there is no such file")
        return [named]
    # Installed they are in PREFIX/share/dentalscr/slicer.
    folder = pathlib.Path(__file__).resolve().parents[1]
    installed = folder.parents[2] / "bin" / "dentalscr" if folder.parts[-3:] == ("share", "dentalscr", "slicer") else None
    if installed and installed.is_file():
        return [str(installed)]
    if importlib.util.find_spec("dentalscr") is not None:
        return [sys.executable, "-m", "dentalscr"]
    found = shutil.which("dentalscr")
    if found:
        return [found]
    raise ProgramError(
        "the program dentalscr was not found: install its package, or its wheel in Slicer's Python "
        "(slicer.util.pip_install), or name the program in the environment variable DENTALSCR_PROGRAM"
    )


def clean_environment(program):
    """Slicer's own libraries must not take the place of the program's; its own Python still needs them."""
    environment = dict(os.environ, DENTALSCR_PROGRESS="slicer")
    if program[0] != sys.executable:
        for name in ("LD_LIBRARY_PATH", "PYTHONHOME", "PYTHONPATH"):
            environment.pop(name, None)
    return environment


def run(arguments, accept=(0,)):
    """Runs the program. Its progress goes on to our own standard output, and what it says to standard error.

    Returns the exit code; raises ProgramError with the last line that it said where that is none of `accept`.
    """
    program = find_program()
    process = subprocess.Popen(
        [*program, *map(str, arguments)], stderr=subprocess.PIPE, text=True, env=clean_environment(program)
    )
    said = []
    for line in process.stderr:
        said.append(line.strip())
        sys.stderr.write(line)
    code = process.wait()
    if code not in accept:
        raise ProgramError(said[-1] if said else f"dentalscr ended with {code}")
    return code


class ImageGrid:
    """Where the pixels of a radiograph are in Slicer, from the head of the NRRD file that Slicer has written of it."""

    def __init__(self, directions, origin, size):
        #: Columns are the steps of u, v and the slices, mm, LPS.
        self.directions = numpy.asarray(directions, dtype=float)
        self.origin = numpy.asarray(origin, dtype=float)
        #: (width, height).
        self.size = tuple(size)

    @classmethod
    def read(cls, file):
        head = {}
        with open(file, "rb") as stream:
            if not stream.readline().startswith(b"NRRD"):
                raise ProgramError(f"{file} is no NRRD file")
            for raw in stream:
                line = raw.decode("utf-8", "replace").strip()
                if not line:
                    break
                key, colon, value = line.partition(":")
                if colon and not line.startswith("#"):
                    head[key.strip().lower()] = value.lstrip("=").strip()
        sizes = [int(word) for word in head["sizes"].split()]
        vectors = [[float(word) for word in group.split(",")] for group in re.findall(r"\(([^)]*)\)", head.get("space directions", ""))]
        if not vectors:
            vectors = numpy.diag([float(word) for word in head.get("spacings", "1 " * len(sizes)).split()]).tolist()
        origin = [float(word) for word in re.sub(r"[()]", "", head.get("space origin", "0,0,0")).split(",")]
        # Of a picture in the plane, too.
        directions = numpy.eye(3)
        for column, vector in enumerate(vectors[:3]):
            directions[: len(vector), column] = vector
        origin = numpy.array((origin + [0.0, 0.0])[:3])
        if head.get("space", "left-posterior-superior").lower() in ("right-anterior-superior", "ras"):
            flip = numpy.diag([-1.0, -1.0, 1.0])
            directions, origin = flip @ directions, flip @ origin
        return cls(directions, origin, sizes[:2])

    def to_pixels(self, points):
        """LPS, mm, to continuous pixel indices (u, v)."""
        rows = numpy.atleast_2d(numpy.asarray(points, dtype=float))
        return numpy.linalg.solve(self.directions, (rows - self.origin).T).T[:, :2]

    def from_pixels(self, pixels):
        """Continuous pixel indices (u, v) to LPS, mm."""
        rows = numpy.atleast_2d(numpy.asarray(pixels, dtype=float))
        return (self.directions[:, :2] @ rows.T).T + self.origin


def read_markups(file):
    """Every markup of a .mrk.json: (name, type, [(label, (L, P, S))])."""
    content = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
    found = []
    for markup in content["markups"]:
        flip = numpy.array([-1.0, -1.0, 1.0]) if markup.get("coordinateSystem", "LPS").upper() in ("RAS", "0") else numpy.ones(3)
        points = [
            (point.get("label", ""), flip * numpy.asarray(point["position"], dtype=float))
            for point in markup.get("controlPoints", [])
            if point.get("positionStatus", "defined") == "defined"
        ]
        found.append((markup.get("name", ""), markup["type"], points))
    return found


def write_markups(file, kind, points, name=None):
    """Writes one markup of named points in LPS, mm."""
    markup = {
        "type": kind,
        "coordinateSystem": "LPS",
        "coordinateUnits": "mm",
        "locked": False,
        "labelFormat": "%N-%d",
        "controlPoints": [
            {
                "id": str(number),
                "label": label,
                "position": [float(value) for value in position],
                "selected": True,
                "locked": False,
                "visibility": True,
                "positionStatus": "defined",
            }
            for number, (label, position) in enumerate(points, 1)
        ],
    }
    if name:
        markup["name"] = name
    pathlib.Path(file).write_text(json.dumps({"@schema": MARKUPS_SCHEMA, "markups": [markup]}, indent=1), encoding="utf-8")


def contours_from_curves(curves, grid):
    """The content of contours.json from curves [(name, closed, (N, 3) LPS)], whose names are codes of teeth or jaws."""
    jaws = {"upper": [], "lower": []}
    for name, closed, points in curves:
        code = "" if name.lower() in jaws else name
        lower = name.lower() == "lower" or code.upper().startswith("L") or code[:1] in ("3", "4")
        entry = {"code": code, "points": [[float(u), float(v)] for u, v in grid.to_pixels(points)]}
        if closed:
            entry["closed"] = True
        jaws["lower" if lower else "upper"].append(entry)
    return {"image_size": list(grid.size), "contours": {jaw: lines for jaw, lines in jaws.items() if lines}}


def read_stl(file):
    """Corners of a binary STL, (M, 3, 3)."""
    data = pathlib.Path(file).read_bytes()
    record = numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attributes", "<u2")])
    return numpy.frombuffer(data, record, offset=84)["corners"].astype(float)


def write_stl(file, corners):
    """A binary STL that says to Slicer in which space it is."""
    corners = numpy.asarray(corners, dtype=float)
    record = numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attributes", "<u2")])
    triangles = numpy.zeros(len(corners), record)
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = numpy.linalg.norm(normals, axis=1, keepdims=True)
    triangles["normal"] = numpy.divide(normals, lengths, out=numpy.zeros_like(normals), where=lengths > 0)
    triangles["corners"] = corners
    head = b"DentalSCR. SPACE=LPS".ljust(80)
    pathlib.Path(file).write_bytes(head + numpy.uint32(len(triangles)).tobytes() + triangles.tobytes())


def move(points, matrix):
    """Points (..., 3) by a 4x4 or 3x4."""
    matrix = numpy.asarray(matrix, dtype=float)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def to_4x4(rows):
    return numpy.vstack([numpy.asarray(rows, dtype=float), [0.0, 0.0, 0.0, 1.0]])


def write_transform(file, matrix):
    """A .tfm by which Slicer moves a model as `matrix` does: it takes a transform file for one from the parent, and so it
    is the inverse that stands in it."""
    inverse = numpy.linalg.inv(matrix)
    numbers = [*inverse[:3, :3].reshape(-1), *inverse[:3, 3]]
    pathlib.Path(file).write_text(
        "#Insight Transform File V1.0\n#Transform 0\nTransform: AffineTransform_double_3_3\nParameters: "
        + " ".join(repr(float(number)) for number in numbers)
        + "\nFixedParameters: 0 0 0\n",
        encoding="utf-8",
    )


def read_transform(file):
    """The 4x4 by which Slicer moves models with a file of write_transform()."""
    numbers = [float(word) for word in re.search(r"^Parameters: (.*)$", pathlib.Path(file).read_text(), re.M).group(1).split()]
    matrix = numpy.eye(4)
    matrix[:3, :3] = numpy.reshape(numbers[:9], (3, 3))
    matrix[:3, 3] = numbers[9:]
    return numpy.linalg.inv(matrix)


def read_result(folder):
    return json.loads((pathlib.Path(folder) / "result.json").read_text(encoding="utf-8"))


def placement(result, jaw):
    """Scan, mm, to LPS, 4x4; None where the jaw was not registered."""
    entry = result["jaws"].get(jaw)
    if entry is None or entry["status"] == "failed" or "mesh_to_cephalostat_mm" not in entry:
        return None
    return LPS_FROM_CEPHALOSTAT @ to_4x4(entry["mesh_to_cephalostat_mm"])




def read_versor(file):
    """The 4x4 of a VersorRigid3DTransform, as the program writes it: points of a scan to its frame."""
    numbers = [float(word) for word in re.search(r"^Parameters: (.*)$", pathlib.Path(file).read_text(), re.M).group(1).split()]
    x, y, z = numbers[:3]
    w = numpy.sqrt(max(0.0, 1.0 - x * x - y * y - z * z))
    rotation = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return to_4x4(numpy.column_stack([rotation, numbers[3:6]]))


def is_code(name):
    """Whether a curve is named after a tooth (UR1, 11) or a jaw."""
    return bool(re.fullmatch(r"(?i:[UL][RL][1-8]|upper|lower)|[1-4][1-8]", name))


def outlines_of(result, page):
    """Aligned outlines that were matched, for drawing on the radiograph: (name, closed, (N, 2) pixels).

    `page` is the content of report.json, which is written beside result.json.
    """
    found = []
    for jaw, entry in page["views"][0]["jaws"].items():
        for outline in entry["contours"].get("matched") or entry["contours"].get("whole", []):
            found.append((f"{jaw} outline, {result['jaws'][jaw]['status']}", bool(outline["closed"]), outline["points"]))
    return found


def describe(result):
    """What a person is told of a result: a line a jaw, and why it is suspect."""
    lines = []
    for jaw, entry in result["jaws"].items():
        text = f"{jaw}: {entry['status']}"
        if "expected_error_px" in entry and entry["status"] != "failed":
            text += f", expected error {entry['expected_error_px']:.1f} px"
        lines += [text, *(f"  {reason}" for reason in entry["reasons"])]
    lines += [f"{jaw}: skipped, {reason}" for jaw, reason in result["skipped"].items()]
    return "\n".join([*lines, *result["warnings"]])
