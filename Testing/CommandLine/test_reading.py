"""What is no regular file, what changes while it is read, and numbers that no case has: an error, and at once."""
import json
import os

import pytest

from program_faults import measure

FIELDS = ["upper", "contours", "image", "landmarks_3d", "cephalometric_landmarks", "case", "init", "result", "points", "labels"]


def command_that_reads(field, path, case, folder):
    """A command that reads the path in the place of a case's file."""
    output = ["--output", str(folder / "out")]
    if field == "case":
        return ["register", str(path), *output]
    if field == "init":
        return ["register", str(case.file), "--init", str(path), *output]
    if field == "result":
        return ["evaluate", str(path), "--landmarks", str(case.folder / "landmarks2d.json")]
    if field == "points":
        return ["project", str(folder / "none.json"), "--points", str(path)]
    if field == "labels":
        return ["contour", "--labels", str(path), *output]
    content = case.load()
    if field == "image":
        content["cephalogram"]["image"] = str(path)
    else:
        content[field] = str(path)
    case.save(content)
    return ["register", str(case.file), *output]


@pytest.mark.parametrize("field", FIELDS)
def test_pipes_and_what_the_kernel_makes_up_are_refused_at_once(program, case, tmp_path, field):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for path in (pipe, "/dev/zero", "/proc/kmsg", "/proc/self/pagemap", tmp_path):
        done = measure([program, *command_that_reads(field, path, case, tmp_path)])
        assert done.returncode == 2 and done.stderr.startswith("dentalscr: "), (path, done.stderr)
        assert done.seconds < 10
        assert not (tmp_path / "out").exists()


READ = ["upper.stl", "upper.obj", "upper.vtk", "contours.json", "landmarks3d.json", "cephalogram.png", "case.json"]


def make_read(case, name):
    """Has the case read a file of that name. \return its path"""
    path = case.folder / name
    if name == "upper.obj":
        path.write_text("v 0 0 0\nv 9 0 0\nv 0 9 0\nv 9 0 1\nf 1 2 3\nf 2 3 4\n")
        case.change(upper=name)
    elif name == "upper.vtk":
        path.write_text(
            "# vtk DataFile Version 3.0\nscan\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 9 0 0 0 9 0\nPOLYGONS 1 4\n3 0 1 2\n"
        )
        case.change(upper=name)
    elif name == "cephalogram.png":
        path = case.folder / case.load()["cephalogram"]["image"]
    if path.suffix in (".json", ".obj", ".vtk"):
        # Longer than the head by which formats are told.
        path.write_text(path.read_text() + "\n" * 5000)
    return path


@pytest.mark.parametrize("fault", ["TRUNCATE", "OVERWRITE", "TOUCH"])
@pytest.mark.parametrize("name", READ)
def test_a_file_that_becomes_another_while_it_is_read_is_an_error(program, case, tmp_path, faults, name, fault):
    """Mapped, a scan that was cut short was SIGBUS. The moment is made and not hoped for: between opening
    and reading it, between its halves, or between reading and closing it."""
    path = make_read(case, name)
    command = [program, "register", case.file, "--output", tmp_path / "out", "--quiet", "--no-report"]
    done = measure(command, env=faults(**{fault: path}))
    assert done.returncode == 2, (done.returncode, done.stderr)
    assert path.name in done.stderr and "was changed while it was read" in done.stderr, done.stderr
    assert not (tmp_path / "out" / "result.json").exists()


@pytest.mark.parametrize("value", [4e9, -4e9, 1e18, 1e300])
def test_a_coordinate_that_no_radiograph_has(program, case, tmp_path, value):
    content = case.load("contours.json")
    content["contours"]["upper"][0]["points"][3][1] = value
    case.save(content, "contours.json")
    done = measure([program, "register", case.file, "--output", tmp_path / "out"])
    assert done.returncode == 2 and "contours.json" in done.stderr and "coordinate" in done.stderr, done.stderr
    assert done.seconds < 5


@pytest.mark.parametrize("value", [1e12, -1e30, 1e38])
def test_a_point_of_a_scan_that_no_scan_has(program, case, tmp_path, value):
    (case.folder / "upper.obj").write_text(f"v 0 0 0\nv 1 0 0\nv 0 1 0\nv {value:.0f} 0 1\nf 1 2 3\nf 2 3 4\n")
    case.change(upper="upper.obj")
    done = measure([program, "register", case.file, "--output", tmp_path / "out"])
    # As a finding or as an error: what counts is that it is told, and at once.
    assert done.returncode in (1, 2) and "upper" in done.stderr, done.stderr
    assert done.seconds < 5


def test_a_file_that_is_replaced_after_it_was_read_is_the_one_that_was_read(program, case, tmp_path, faults):
    """Another file that takes its name is another file: the result, and the sum by which `batch --resume` knows its input
    again, are of the one that was read, or it is an error. Never a result of the one beside the sum of the other."""
    contours = case.folder / "contours.json"
    text = contours.read_text()
    other = json.loads(text)
    other["contours"]["upper"].pop()
    command = [program, "register", case.file, "--quiet", "--no-report", "--output"]
    landmarks = {}
    for name, content in {"other": json.dumps(other), "first": text}.items():
        contours.write_text(content)
        assert measure([*command, tmp_path / name]).returncode == 0
        result = json.loads((tmp_path / name / "result.json").read_text())
        landmarks[result["inputs"]["contours"]["sha256"]] = result["jaws"]["upper"]["landmarks_px"]
    assert len(landmarks) == 2 and len(set(map(str, landmarks.values()))) == 2
    contours.with_name("contours.json.other").write_text(json.dumps(other))
    done = measure([*command, tmp_path / "out"], env=faults(REPLACE=contours))
    assert not contours.with_name("contours.json.other").exists(), "the file was never read whole"
    if done.returncode == 2:
        assert "contours.json" in done.stderr and "changed" in done.stderr, done.stderr
    else:
        result = json.loads((tmp_path / "out" / "result.json").read_text())
        assert result["jaws"]["upper"]["landmarks_px"] == landmarks[result["inputs"]["contours"]["sha256"]]
