"""What each command-line module of Slicer does with the files that Slicer gives it, a function a verb of the program."""
import argparse
import json
import pathlib
import sys
import tempfile

import numpy

import DentalSCRLib as lib


def pair(text):
    """Slicer writes a vector as u,v; nothing, or zeros, where it is not known."""
    numbers = [float(word) for word in text.split(",") if word.strip()]
    if not numbers or not any(numbers):
        return []
    if len(numbers) != 2:
        raise argparse.ArgumentTypeError(f"{text!r} are no two numbers u,v")
    return [repr(number) for number in numbers]


def scan_arguments(options):
    arguments = []
    for jaw in ("upper", "lower"):
        if getattr(options, jaw):
            arguments += [f"--{jaw}", getattr(options, jaw)]
    return arguments


def landmarks_of(file, convert):
    points = [point for _, kind, points in lib.read_markups(file) if kind == "Fiducial" for point in points]
    return {label: convert(position) for label, position in points}


def case_of(options, folder):
    """Writes a case file into the folder from what Slicer gave."""
    case = {jaw: getattr(options, jaw) for jaw in ("upper", "lower") if getattr(options, jaw)}
    if not options.image:
        raise lib.ProgramError("no radiograph was chosen")
    grid = lib.ImageGrid.read(options.image)
    case["cephalogram"] = {"image": options.image, "facing": options.facing}
    if options.spacing:
        case["cephalogram"]["pixel_spacing_mm"] = [float(number) for number in options.spacing]
    if options.principalPoint:
        case["geometry"] = {"principal_point_px": [float(number) for number in options.principalPoint]}
    if options.tracing and options.contours:
        raise lib.ProgramError("a label map and a file with the tracing were chosen; take one of them")
    if options.tracing or options.contours:
        case["contours"] = options.tracing or options.contours
    if options.landmarks:
        case["cephalometric_landmarks"] = landmarks_of(
            options.landmarks, lambda position: [float(value) for value in grid.to_pixels(position)[0]]
        )
    if options.scanLandmarks:
        file = folder / "landmarks3d.json"
        file.write_text(json.dumps(landmarks_of(options.scanLandmarks, lambda position: [float(value) for value in position])))
        case["landmarks_3d"] = str(file)
    path = folder / "case.json"
    path.write_text(json.dumps(case))
    return path, grid


def places_of(jaw):
    """Predicted landmarks, pixels; of a scan without any the tips and cusps that were found on it."""
    return jaw.get("landmarks_px") or {name: middle["position"] for name, middle in jaw.get("middles", {}).items()}


def register(options):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        grid = None
        if options.case:
            given = [n for n in ("upper", "lower", "tracing", "contours", "landmarks", "scanLandmarks") if getattr(options, n)]
            if given:
                raise lib.ProgramError(f"a case file was chosen, and {given[0]} beside it; take one or the other")
            case = options.case
        else:
            case, grid = case_of(options, folder)
        output = pathlib.Path(options.output) if options.output else folder / "result"
        # 1: a jaw failed; the result says which.
        lib.run(
            ["register", case, "--output", output, "--preset", options.preset, "--threads", options.threads], accept=(0, 1)
        )
        result = lib.read_result(output)
        returned = {"status": result["status"]}
        for jaw in ("upper", "lower"):
            entry = result["jaws"].get(jaw, {"status": "skipped"})
            returned[f"{jaw}Status"] = entry["status"]
            returned[f"{jaw}ExpectedError"] = f"{entry['expected_error_px']:.2f}" if "expected_error_px" in entry else ""
            matrix = lib.placement(result, jaw)
            moved, transform = getattr(options, f"{jaw}Moved"), getattr(options, f"{jaw}Transform")
            if matrix is None:
                if moved or transform:
                    sys.stderr.write(f"the {jaw} jaw was not registered: it has no model and no transform\n")
                continue
            if moved:
                scan = lib.read_stl(output / f"{jaw}_ceph.stl")
                lib.write_stl(moved, lib.move(scan, lib.LPS_FROM_CEPHALOSTAT))
            if transform:
                lib.write_transform(transform, matrix)
        if options.predicted:
            if grid is None:
                raise lib.ProgramError("predicted landmarks need the radiograph to be chosen here, and not in a case file")
            points = [
                (name, grid.from_pixels(place)[0])
                for jaw in result["jaws"].values()
                for name, place in sorted(places_of(jaw).items())
            ]
            lib.write_markups(options.predicted, "Fiducial", points)
    return returned


def render(options):
    arguments = ["render", *scan_arguments(options), "--output", options.output, "--mode", options.mode]
    arguments += ["--sigma", options.sigma, "--facing", options.facing, "--threads", options.threads]
    if not options.spacing:
        raise lib.ProgramError("the pixel spacing is needed: mm a pixel in the detector plane, as 0.25,0.25")
    lib.run([*arguments, "--spacing", *options.spacing])
    return {}


def axis(options):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        lib.run(["axis", *scan_arguments(options), "--output", folder, "--threads", options.threads])
        for jaw in ("upper", "lower"):
            moved, transform = getattr(options, f"{jaw}Moved"), getattr(options, f"{jaw}Transform")
            if not getattr(options, jaw):
                continue
            if moved:
                lib.write_stl(moved, lib.move(lib.read_stl(folder / f"{jaw}_umda.stl"), lib.LPS_FROM_CEPHALOSTAT))
            if transform:
                lib.write_transform(transform, lib.LPS_FROM_CEPHALOSTAT @ lib.read_versor(folder / f"{jaw}_umda.tfm"))
    return {}


def contour(options):
    arguments = ["contour", "--labels", options.labels, "--output", options.output, "--threads", options.threads]
    lib.run([*arguments, "--whole", "--jaw", options.jaw] if options.whole else arguments)
    return {}


def project(options):
    with tempfile.TemporaryDirectory() as name:
        points, places = pathlib.Path(name) / "points.json", pathlib.Path(name) / "places.json"
        points.write_text(json.dumps(landmarks_of(options.points, lambda position: [float(value) for value in position])))
        arguments = ["project", options.result, "--points", points, "--output", places]
        lib.run(arguments if options.jaw == "by name" else [*arguments, "--jaw", options.jaw])
        rows = ["name\tu\tv\tsigma_px"]
        for label, place in json.loads(places.read_text()).items():
            rows.append("\t".join([label, *(repr(value) for value in place["position"]), repr(place["sigma_px"])]))
        pathlib.Path(options.table).write_text("\n".join(rows) + "\n", encoding="utf-8")
    return {}


def parser_of(verb):
    parser = argparse.ArgumentParser(prog=f"DentalSCR {verb}", description="A module of 3D Slicer; its .xml says what it takes.")
    parser.add_argument("--returnparameterfile")
    parser.add_argument("--processinformationaddress")
    parser.add_argument("--threads", default="0")
    add = parser.add_argument
    if verb in ("register", "render", "axis"):
        add("--upper")
        add("--lower")
    if verb in ("register", "axis"):
        for jaw in ("upper", "lower"):
            add(f"--{jaw}Moved")
            add(f"--{jaw}Transform")
    if verb in ("register", "render"):
        add("--spacing", type=pair, default=[])
        add("--facing", choices=("right", "left"), default="right")
    if verb == "register":
        for name in ("case", "image", "tracing", "contours", "landmarks", "scanLandmarks", "output", "predicted"):
            add(f"--{name}")
        add("--principalPoint", type=pair, default=[])
        add("--preset", default="robust")
    elif verb == "render":
        add("--mode", default="radiograph")
        add("--sigma", default="0.5")
        add("output")
    elif verb == "contour":
        add("--whole", action="store_true")
        add("--jaw", choices=("upper", "lower"), default="upper")
        add("labels")
        add("output")
    elif verb == "project":
        add("--jaw", choices=("by name", "upper", "lower"), default="by name")
        add("result")
        add("points")
        add("table")
    return parser


def main(verb, arguments=None):
    """What a module's script calls. Ends with 0, or with 1 and one line that says what is wrong, which Slicer shows."""
    options = parser_of(verb).parse_args(arguments)
    try:
        returned = {"register": register, "render": render, "axis": axis, "contour": contour, "project": project}[verb](options)
    except (lib.ProgramError, OSError, ValueError, KeyError, numpy.linalg.LinAlgError) as error:
        sys.stderr.write(f"{error}\n")
        return 1
    if options.returnparameterfile:
        text = "".join(f"{name} = {value}\n" for name, value in returned.items())
        pathlib.Path(options.returnparameterfile).write_text(text, encoding="utf-8")
    return 0
