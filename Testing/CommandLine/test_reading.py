"""What is no regular file, what changes while it is read, and numbers that no case has: an error, and at once."""
import json
import os
import random
import struct

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


def scribble(count):
    """Points all over the radiograph, each line of which crosses a third of the others."""
    places = random.Random(1)
    return [[places.randrange(700), places.randrange(900)] for _ in range(count)]


def test_a_tracing_of_more_points_than_any_has_is_an_error(program, case, tmp_path):
    content = case.load("contours.json")
    content["contours"]["upper"][0]["points"] += scribble(200000)
    case.save(content, "contours.json")
    done = measure([program, "register", case.file, "--output", tmp_path / "out"])
    assert done.returncode == 2 and "contours.json: has 200" in done.stderr and "more than the 200000" in done.stderr, done.stderr


@pytest.mark.parametrize("count", [19000, 199000])
def test_a_scribble_is_drawn_as_well(program, is_sanitized, case, tmp_path, count):
    """Cairo looks for all crossings of a path's lines: a million points took hours, after the registration had ended, and
    20,000 minutes."""
    content = case.load("contours.json")
    content["contours"]["upper"][0]["points"] += scribble(count)
    case.save(content, "contours.json")
    done = measure([program, "register", case.file, "--output", tmp_path / "out", "--quiet"], timeout=600 if is_sanitized else 120)
    assert done.returncode == 1, done.stderr
    assert is_sanitized or done.seconds < 30, f"{done.seconds} s"
    assert (tmp_path / "out" / "overlay_upper.png").stat().st_size > 10000


def test_a_file_of_a_million_odd_rows_is_warned_of_in_a_page(program, is_sanitized, case, tmp_path):
    """Each row had a line of its own on the terminal, and copies of all of them took 7 GB."""
    rows = "".join(f"L{i},1,2,3\n" for i in range(300000))
    (case.folder / "odd.csv").write_text("label,x,y,z\n" + rows)
    case.change(landmarks_3d="odd.csv")
    done = measure([program, "register", case.file, "--output", tmp_path / "out", "--quiet"])
    lines = [line for line in done.stderr.splitlines() if "odd.csv" in line]
    assert len(lines) == 101 and "line 2:" in lines[0] and "more to say than these 100 warnings" in lines[100], lines[-2:]
    assert is_sanitized or done.kibibytes < 1 << 19, done.kibibytes


def test_a_file_of_millions_of_empty_arrays_is_an_error(program, is_sanitized, case, tmp_path):
    (case.folder / "contours.json").write_text('{"contours":[' + "[]," * 11000000 + "1]}")
    done = measure([program, "register", case.file, "--output", tmp_path / "out", "--quiet"])
    assert done.returncode == 2 and "contours.json: contours: has more than 3000000" in done.stderr, done.stderr
    assert is_sanitized or done.kibibytes < 1 << 19, done.kibibytes


# What stands in the table, and what is said of it as a tracing and as a list of cases.
LARGE_TABLES = {
    "commas": (lambda: "," * 30000000, "30000001 columns", "cells"),
    "a comment of commas": (lambda: "#" + "," * 30000000, "30000001 columns", "cells"),
    "rows": (lambda: "a,b\n" * 300000, "columns", "300001 rows"),
}


@pytest.mark.parametrize("name", LARGE_TABLES)
def test_a_table_of_empty_cells_is_an_error(program, is_sanitized, case, tmp_path, name):
    """Each cell takes memory, empty or not: 32 MiB of commas took 2 GB."""
    make, *words = LARGE_TABLES[name]
    table = case.folder / "table.csv"
    table.write_text("label,x,y\n" + make())
    case.change(contours="table.csv")
    for arguments, word in zip((["register", case.file], ["batch", table]), words):
        done = measure([program, *arguments, "--output", tmp_path / "out", "--quiet"])
        assert done.returncode == 2 and "table.csv" in done.stderr and word in done.stderr and len(done.stderr) < 600, done.stderr
        assert is_sanitized or done.kibibytes < 1 << 19, done.kibibytes


def test_a_scan_whose_edges_cross_all_over_is_none(program, is_sanitized, case, tmp_path):
    """Where its outline is looked for each edge was held against all that cross it: 10 MB took 6 GB and minutes."""
    places = random.Random(1)
    triangles = b"".join(
        struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 10, 0, 0, 40 * places.random(), 40 * places.random(), 10 * places.random(), 0)
        for _ in range(100000)
    )
    (case.folder / "fan.stl").write_bytes(bytes(80) + struct.pack("<I", 100000) + triangles)
    case.change(upper="fan.stl")
    done = measure([program, "register", case.file, "--output", tmp_path / "out", "--quiet"])
    assert done.returncode == 1 and "upper: failed: the edges of its outline cross each other all over" in done.stderr, done.stderr
    assert is_sanitized or (done.seconds < 20 and done.kibibytes < 1 << 19), (done.seconds, done.kibibytes)
    scan = case.folder / "fan.stl"
    done = measure([program, "contour", "--upper", scan, "--spacing", "0.25", "0.25", "--output", tmp_path / "out.json", "--quiet"])
    assert done.returncode == 2 and f"{scan}: the edges of its outline cross" in done.stderr, done.stderr


@pytest.mark.parametrize("value", [1e12, -1e30, 1e38])
def test_a_point_of_a_scan_that_no_scan_has(program, case, tmp_path, value):
    (case.folder / "upper.obj").write_text(f"v 0 0 0\nv 1 0 0\nv 0 1 0\nv {value:.0f} 0 1\nf 1 2 3\nf 2 3 4\n")
    case.change(upper="upper.obj")
    done = measure([program, "register", case.file, "--output", tmp_path / "out"])
    # As a finding or as an error: what counts is that it is told, and at once.
    assert done.returncode in (1, 2) and "upper" in done.stderr, done.stderr
    assert done.seconds < 5


def other_file(field, content):
    """A file of the same kind that gives another result."""
    if field == "upper":
        # A part of the arch fewer: who reads it twice reads it wholly twice.
        facets = len(content) // 50 * 9 // 10
        return content[:80] + facets.to_bytes(4, "little") + content[84 : 84 + 50 * facets]
    other = json.loads(content)
    if field == "contours":
        other["contours"]["upper"].pop()
    else:
        other["fix"] = ["scale", "rotation"]
    return json.dumps(other).encode()


@pytest.mark.parametrize("field", ["upper", "contours", "case"])
def test_a_file_that_is_replaced_after_it_was_read_is_the_one_that_was_read(program, case, tmp_path, faults, field):
    """Another file that takes its name is another file: the result, and the sum by which `batch --resume` knows its input
    again, are of the one that was read, or it is an error. Never a result of the one beside the sum of the other. The case
    file is read before anybody can look at what it names."""
    file = case.folder / (case.load()[field] if field != "case" else "case.json")
    content = file.read_bytes()
    other = other_file(field, content)
    command = [program, "register", case.file, "--quiet", "--no-report", "--output"]
    landmarks = {}
    for name, written in {"other": other, "first": content}.items():
        file.write_bytes(written)
        assert measure([*command, tmp_path / name]).returncode in (0, 1)
        result = json.loads((tmp_path / name / "result.json").read_text())
        landmarks[result["inputs"][field]["sha256"]] = result["jaws"]["upper"]["landmarks_px"]
    assert len(landmarks) == 2 and len(set(map(str, landmarks.values()))) == 2
    replacement = file.with_name(file.name + ".other")
    replacement.write_bytes(other)
    done = measure([*command, tmp_path / "out"], env=faults(REPLACE=file))
    assert not replacement.exists(), "the file was never read whole"
    if done.returncode == 2:
        assert file.name in done.stderr and "changed" in done.stderr, done.stderr
    else:
        result = json.loads((tmp_path / "out" / "result.json").read_text())
        assert result["jaws"]["upper"]["landmarks_px"] == landmarks[result["inputs"][field]["sha256"]]


@pytest.mark.parametrize("name", ["upper.stl", "upper.ply", "upper.vtk"])
def test_a_scan_larger_than_a_bound_is_not_read(program, is_sanitized, case, tmp_path, name):
    """The bound can be moved; without one a file of holes takes the memory of the machine."""
    path = case.folder / name
    path.write_bytes(b"\0")
    os.truncate(path, (1 << 30) + 1)
    case.change(upper=name)
    command = [program, "register", case.file, "--output", tmp_path / "out"]
    done = measure(command)
    # A sanitizer keeps some 50 MiB of its own; the file would be 1024.
    assert done.returncode == 2 and done.kibibytes < (1 << 19 if is_sanitized else 1 << 18), (done.returncode, done.kibibytes)
    assert name in done.stderr and "has 1073741825 bytes, more than the 1024 MiB" in done.stderr and "DENTALSCR_LARGEST_SCAN_MIB" in done.stderr, done.stderr
    os.truncate(path, 1 << 20)
    for bound, words in (("0", "has 1048576 bytes, more than the 0 MiB"), ("1", ""), ("many", 'is "many", no whole number of MiB')):
        done = measure(command, env=dict(os.environ, DENTALSCR_LARGEST_SCAN_MIB=bound))
        assert done.returncode == 2 and words in done.stderr, done.stderr
        assert ("may have" in done.stderr) == (bound == "0"), done.stderr
