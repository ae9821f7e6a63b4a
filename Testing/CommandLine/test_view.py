"""The verb view: a registered case in space, as a picture without a screen and as files for other programs."""
import base64
import json
import os
import re
import shutil
import signal
import struct
import subprocess
import time
import zlib

import pytest

from program_faults import wait_until


@pytest.fixture(scope="session")
def view(program):
    """Runs the verb without a screen of its own."""
    if not program.with_name("dentalscr-view").exists():
        pytest.skip("DentalSCR was built without VTK")
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}

    def call(*arguments, **changes):
        return subprocess.run(
            [str(program), "view", *map(str, arguments)],
            capture_output=True,
            text=True,
            timeout=300,
            cwd=changes.pop("cwd", None),
            env={**environment, **changes},
        )

    return call


@pytest.fixture(scope="session")
def result(run, sample, tmp_path_factory):
    folder = tmp_path_factory.mktemp("view") / "result"
    done = run("register", sample / "case.json", "--output", folder)
    assert done.returncode == 0, done.stderr
    return folder


needs_xvfb = pytest.mark.skipif(shutil.which("Xvfb") is None, reason="Xvfb is not installed")


def pixels_of(path):
    """Rows of (r, g, b) of an 8-bit PNG, decoded here: by none of the libraries that are tested."""
    data = path.read_bytes()
    width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
    assert depth == 8
    channels = {0: 1, 2: 3, 6: 4}[kind]
    packed, place = b"", 8
    while place < len(data):
        (length,) = struct.unpack(">I", data[place : place + 4])
        if data[place + 4 : place + 8] == b"IDAT":
            packed += data[place + 8 : place + 8 + length]
        place += length + 12
    raw, stride = zlib.decompress(packed), width * channels
    rows, before = [], bytearray(stride)
    for v in range(height):
        mode, line = raw[v * (stride + 1)], bytearray(raw[v * (stride + 1) + 1 : (v + 1) * (stride + 1)])
        for i in range(stride):
            left = line[i - channels] if i >= channels else 0
            up, corner = before[i], before[i - channels] if i >= channels else 0
            guess = left + up - corner
            nearest = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            line[i] = (line[i] + (0, left, up, (left + up) // 2, nearest)[mode]) & 255
        rows.append(line)
        before = line
    return [[tuple(row[u * channels : u * channels + 3]) for u in range(width)] for row in rows]


@needs_xvfb
def test_snapshot_needs_no_screen_and_leaves_no_server(program, view, result, tmp_path):
    # In a session of its own: what it has left behind is still of that session.
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    child = subprocess.Popen(
        [str(program), "view", str(result), "--snapshot", str(tmp_path / "scene.png"), "--size", "320", "240"],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True, env=environment,
    )
    output, errors = child.communicate(timeout=300)
    assert child.returncode == 0, errors
    assert output == f"written to {tmp_path / 'scene.png'}\n"
    assert errors == ""
    assert os.listdir(tmp_path) == ["scene.png"]
    assert subprocess.run(["ps", "-o", "args=", "--sid", str(child.pid)], capture_output=True, text=True).stdout == ""
    rows = pixels_of(tmp_path / "scene.png")
    assert (len(rows[0]), len(rows)) == (320, 240)
    # Radiograph, tracing and outline are in it: grey from black to white, blue, orange.
    colours = [pixel for row in rows for pixel in row]
    assert min(max(c) for c in colours) < 30 and max(min(c) for c in colours) > 200
    assert sum(b > r + 60 and b > 150 for r, g, b in colours) > 10
    assert sum(r > b + 100 and g > b + 40 for r, g, b in colours) > 10


@needs_xvfb
def test_from_the_source_the_picture_is_the_radiograph(view, result, sample, tmp_path):
    """Its pixels are where the radiograph's are: all of geometry, texture and camera is in that."""
    case = json.loads((sample / "case.json").read_text())
    radiograph = pixels_of(sample / case["cephalogram"]["image"])
    height, width = len(radiograph), len(radiograph[0])
    done = view(result, "--snapshot", tmp_path / "s.png", "--camera", "source", "--size", width, height)
    assert done.returncode == 0, done.stderr
    rows = pixels_of(tmp_path / "s.png")
    # The margin is 4 %. Above the teeth there is nothing but the radiograph.
    differences, bright = [], []
    for v in range(40, height // 3, 10):
        for u in range(40, width - 40, 10):
            seen = rows[round((v - height / 2) / 1.04 + height / 2)][round((u - width / 2) / 1.04 + width / 2)]
            differences.append(seen[0] - radiograph[v][u][0])
            bright.append(radiograph[v][u][0])
    assert max(bright) - min(bright) > 100
    # The picture's black and white are those of its half percents: a straight line leads from one grey to the other.
    mean = sum(bright) / len(bright)
    slope = sum((b - mean) * d for b, d in zip(bright, differences)) / sum((b - mean) ** 2 for b in bright)
    offset = sum(differences) / len(differences)
    rest = [abs(d - offset - slope * (b - mean)) for b, d in zip(bright, differences)]
    assert sorted(rest)[int(0.9 * len(rest))] < 15


def test_gltf_holds_all_in_mm_in_one_file(view, result, sample, tmp_path):
    done = view(result, "--export", tmp_path / "scene.gltf")
    assert done.returncode == 0, done.stderr
    assert os.listdir(tmp_path) == ["scene.gltf"]
    scene = json.loads((tmp_path / "scene.gltf").read_text())
    assert scene["asset"]["version"] == "2.0"
    for buffer in scene["buffers"]:
        assert buffer["uri"].startswith("data:application/octet-stream;base64,")
    (image,) = scene["images"]
    assert image["mimeType"] == "image/png"
    (tmp_path / "texture.png").write_bytes(read_view(scene, image["bufferView"]))
    lows = [a["min"] for a in scene["accessors"] if a["type"] == "VEC3" and "min" in a]
    highs = [a["max"] for a in scene["accessors"] if a["type"] == "VEC3" and "max" in a]
    # From the ball of the source, 1524 mm to the right, to the detector, 150 mm to the left.
    assert min(low[1] for low in lows) == pytest.approx(-1532, abs=1)
    assert max(high[1] for high in highs) == pytest.approx(150, abs=1)
    # glTF counts in metres, and its y is upward: a node says so.
    (root,) = (scene["nodes"][i] for i in scene["scenes"][scene["scene"]]["nodes"])
    assert root["matrix"][:3] == [0.001, 0, 0] and root["matrix"][8:11] == [0, 0.001, 0]
    named = {scene["nodes"][i]["name"]: scene["nodes"][i]["mesh"] for i in root["children"]}
    assert {"upper scan", "lateral detector", "lateral upper tracing", "lateral central ray"} <= set(named)
    material = scene["materials"][scene["meshes"][named["upper axial plane"]]["primitives"][0]["material"]]
    assert material["alphaMode"] == "BLEND" and material["doubleSided"]
    # The radiograph stands on its feet: glTF's places in pictures count from the upper left corner.
    (textured,) = scene["meshes"][named["lateral detector"]]["primitives"]
    points, places = (read_accessor(scene, textured["attributes"][name]) for name in ("POSITION", "TEXCOORD_0"))
    top = max(range(4), key=lambda i: points[i][2])
    bottom = min(range(4), key=lambda i: points[i][2])
    assert abs(points[top][2] - points[bottom][2]) > 100
    assert sorted(place[1] for place in places) == [0.0, 0.0, 1.0, 1.0]
    texture = pixels_of(tmp_path / "texture.png")
    case = json.loads((sample / "case.json").read_text())
    radiograph = pixels_of(sample / case["cephalogram"]["image"])
    assert len(texture) == len(radiograph)

    def difference(row, other):
        return sum(abs(a[0] - b[0]) for a, b in zip(row, other)) / len(row)

    def row_of(point, depth):
        """That far from the picture's edge at which a point is, as the file counts."""
        return texture[depth] if places[point][1] == 0.0 else texture[-1 - depth]

    # A twentieth from the upper edge; contrast is stretched a little.
    depth = len(texture) // 20
    assert difference(row_of(top, depth), radiograph[depth]) < 40
    assert difference(row_of(top, depth), radiograph[depth]) < 0.7 * difference(row_of(top, depth), radiograph[-1 - depth])


def read_view(scene, index):
    piece = scene["bufferViews"][index]
    data = base64.b64decode(scene["buffers"][piece["buffer"]]["uri"].split(",")[1])
    start = piece.get("byteOffset", 0)
    return data[start : start + piece["byteLength"]]


def read_accessor(scene, index):
    accessor = scene["accessors"][index]
    columns = {"VEC2": 2, "VEC3": 3}[accessor["type"]]
    data = read_view(scene, accessor["bufferView"])
    numbers = struct.unpack_from(f"<{columns * accessor['count']}f", data, accessor.get("byteOffset", 0))
    return [numbers[i : i + columns] for i in range(0, len(numbers), columns)]


def test_blocks_and_one_surface_are_written(view, result, tmp_path):
    for name in ("scene.vtm", "scene.vtp"):
        done = view(result, "--export", tmp_path / name)
        assert done.returncode == 0, done.stderr
    names = re.findall(r'name="([^"]+)"', (tmp_path / "scene.vtm").read_text())
    assert names[0] == "upper scan" and "lateral radiograph" in names and "lateral lower tracing" in names
    assert sorted(os.listdir(tmp_path)) == ["scene", "scene.vtm", "scene.vtp"]


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["--export", "scene.glb"], "scene.glb: VTK 9.1"),
        (["--export", "scene.obj"], "Name it .gltf"),
        (["--snapshot", "scene.jpg"], "Name it .png"),
        (["--camera", "behind", "--snapshot", "scene.png"], "overview, front, side, above, all, source, teeth, lateral"),
        (["--size", "0", "9", "--snapshot", "scene.png"], "--size"),
        ([], "--snapshot FILE.png"),
    ],
)
def test_unusable_arguments_are_one_line(view, result, tmp_path, arguments, words):
    done = view(result, *arguments, cwd=tmp_path)
    assert done.returncode == 2
    assert words in done.stderr and done.stderr.count("\n") == 1 and done.stderr.startswith("dentalscr: ")
    assert os.listdir(tmp_path) == []


def test_an_export_replaces_blocks_of_its_own_and_nobody_elses_folder(view, result, tmp_path):
    for _ in range(2):
        assert view(result, "--export", tmp_path / "scene.vtm").returncode == 0
    mine = tmp_path / "mine"
    mine.mkdir()
    (mine / "thesis.tex").write_text("years of work")
    done = view(result, "--export", tmp_path / "mine.vtm")
    assert done.returncode != 0 and "holds something else" in done.stderr, done.stderr
    assert (mine / "thesis.tex").read_text() == "years of work"
    assert sorted(os.listdir(tmp_path)) == ["mine", "scene", "scene.vtm"]



def snapshot_of(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


# Blocks of 1 KiB: one that cuts all off, and others of which the first blocks have room and a later one has not.
@pytest.mark.parametrize("option, name, limits", [
    ("--export", "scene.gltf", (4, 400)),
    ("--export", "scene.vtp", (4, 400)),
    ("--export", "scene.vtm", (1, 8, 100, 400)),
    # Below some 10 KiB Xvfb itself cannot start.
    pytest.param("--snapshot", "scene.png", (20,), marks=needs_xvfb),
])
def test_files_that_may_not_grow_keep_what_was_there(program, view, result, tmp_path, option, name, limits):
    """ulimit -f, as of a quota or a full disk."""
    assert view(result, option, tmp_path / name, "--size", 320, 240).returncode == 0
    before = snapshot_of(tmp_path)
    environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
    for limit in limits:
        assert max(map(len, before.values())) > 1024 * limit, "a limit that tests nothing"
        done = subprocess.run(
            ["bash", "-c", f'ulimit -f {limit}; exec "$@"', "bash", str(program.with_name("dentalscr-view")),
             option, str(tmp_path / name), "--size", "320", "240", str(result)],
            capture_output=True, text=True, timeout=300, env=environment,
        )
        assert done.returncode == 2, (limit, done)
        # Files in memory are of that size, too: a radiograph that has no room is warned of.
        said = [line for line in done.stderr.splitlines() if not line.startswith("dentalscr: warning:")]
        assert len(said) == 1 and str(tmp_path / name) in said[0] and "ulimit -f" in said[0], done
        assert snapshot_of(tmp_path) == before and not list(tmp_path.rglob("*.part")), limit


def test_a_full_disk_keeps_what_was_there(view, result, small_disk):
    disk = small_disk(1500)
    for name in ("scene.gltf", "scene.vtm"):
        (disk / name).write_text("mine")
        done = view(result, "--export", disk / name)
        assert done.returncode == 2 and name in done.stderr and "space" in done.stderr, done
        assert done.stderr.count("\n") == 1, done.stderr
        assert {path.name for path in disk.iterdir()} == {name} and (disk / name).read_text() == "mine"
        (disk / name).unlink()


def test_what_a_killed_export_has_left_is_removed_by_the_next(program, view, result, tmp_path):
    left = tmp_path / "left"
    left.mkdir()
    environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
    child = subprocess.Popen(
        [str(program.with_name("dentalscr-view")), "--export", str(left / "scene.vtm"), str(result)], env=environment
    )
    try:
        wait_until(lambda: list(left.glob(".dentalscr-*.part/*")) or child.poll() is not None, "the first block")
        child.send_signal(signal.SIGSTOP)
        # It may have come to its end meanwhile: then there is nothing to be swept.
        if not list(left.glob(".dentalscr-*.part")):
            pytest.skip("it was too fast to be killed half-way")
    finally:
        child.kill()
        child.wait()
    assert list(left.glob(".dentalscr-*.part"))
    assert view(result, "--export", left / "scene.vtp").returncode == 0
    assert os.listdir(left) == ["scene.vtp"]


def test_lost_standard_output_of_the_viewer_is_an_error(program, result, tmp_path):
    command = [str(program.with_name("dentalscr-view")), "--export", str(tmp_path / "scene.vtp"), str(result)]
    if not program.with_name("dentalscr-view").exists():
        pytest.skip("DentalSCR was built without VTK")
    with open("/dev/full", "w") as full:
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 2 and "standard output can't be written" in done.stderr
    # Nobody reads any more.
    reader, writer = os.pipe()
    os.close(reader)
    done = subprocess.run(command, stdout=writer, stderr=subprocess.PIPE, text=True)
    os.close(writer)
    assert done.returncode == 2 and "standard output can't be written" in done.stderr
    # With all streams closed the file holds the scene and nothing that was said.
    (tmp_path / "scene.vtp").unlink()
    subprocess.run(["sh", "-c", 'exec "$@" <&- >&- 2>&-', "sh", *command])
    content = (tmp_path / "scene.vtp").read_bytes()
    assert content.startswith(b"<?xml") and content.rstrip().endswith(b"</VTKFile>")


def test_the_viewer_sends_no_control_bytes_to_a_terminal(program, tmp_path):
    if not program.with_name("dentalscr-view").exists():
        pytest.skip("DentalSCR was built without VTK")
    done = subprocess.run(
        [str(program.with_name("dentalscr-view")), "--export", str(tmp_path / "s.vtp"), "\033[31mred\nline"],
        capture_output=True, text=True,
    )
    assert done.returncode == 2 and done.stderr.count("\n") == 1
    assert "\033" not in done.stderr and "\\x1b[31mred" in done.stderr


def test_only_the_viewer_fills_a_pool_of_threads(program, tmp_path):
    """A viewer that counts the threads of the program that waits for it."""
    shutil.copy2(program, tmp_path / "dentalscr")
    viewer = tmp_path / "dentalscr-view"
    viewer.write_text("#!/bin/sh\nls /proc/$PPID/task | wc -l\n")
    viewer.chmod(0o755)
    done = subprocess.run([str(tmp_path / "dentalscr"), "--threads", "8", "view", str(tmp_path)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip() == "1"


def test_what_is_no_result_is_named(view, sample, tmp_path):
    for file, words in (("nothing", "nothing"), (sample / "case.json", "no result of dentalscr")):
        done = view(file, "--export", tmp_path / "scene.vtp")
        assert done.returncode == 2 and words in done.stderr, done.stderr
    assert os.listdir(tmp_path) == []


def test_a_picture_without_xvfb_says_what_to_install(view, result, program, tmp_path):
    done = view(result, "--snapshot", tmp_path / "scene.png", PATH=str(program.parent))
    assert done.returncode == 2 and "apt-get install xvfb" in done.stderr
    assert os.listdir(tmp_path) == []


def test_without_the_viewer_the_verb_says_what_to_install(program, result, tmp_path):
    alone = tmp_path / "bin" / "dentalscr"
    alone.parent.mkdir()
    shutil.copy(program, alone)
    environment = {"PATH": "/nowhere", "LD_LIBRARY_PATH": str(program.parent.parent / "lib")}
    done = subprocess.run(
        [str(alone), "view", str(result), "--export", "scene.vtp"], capture_output=True, text=True, env=environment
    )
    assert done.returncode == 2 and done.stderr.count("\n") == 1
    assert "built without VTK" in done.stderr and "libvtk9-dev" in done.stderr


def test_a_changed_or_lost_case_still_shows_the_scans(view, run, case, tmp_path):
    done = run("register", case.file, "--output", tmp_path / "result")
    assert done.returncode == 0, done.stderr
    shown = {}
    for name, gone in (("contours.json", "tracing"), ("ceph.png", "radiograph"), ("upper.stl", "upper rays")):
        kept = (case.folder / name).read_bytes()
        # White space, a comment of the STL's head, or bytes behind a picture's end: still readable, but another file.
        (case.folder / name).write_bytes(b"x" + kept[1:] if name.endswith(".stl") else kept + b"\n")
        done = view(tmp_path / "result", "--export", tmp_path / "scene.vtm")
        assert done.returncode == 0, done.stderr
        assert f"{name}: has changed since it was registered" in done.stderr
        (case.folder / name).write_bytes(kept)
        shown[name] = set(re.findall(r'name="([^"]+)"', (tmp_path / "scene.vtm").read_text()))
        assert {"upper scan", "lower scan", "lateral upper silhouette", "lateral lower silhouette"} <= shown[name]
        assert not any(gone in part for part in shown[name])
    assert "lateral radiograph" in shown["contours.json"] and "lateral upper tracing" in shown["ceph.png"]
    assert "lateral lower rays" in shown["upper.stl"] and "lateral upper tracing" in shown["upper.stl"]
    # Moved: with --case it is found again, as it was.
    moved = tmp_path / "moved"
    case.folder.rename(moved)
    done = view(tmp_path / "result", "--export", tmp_path / "scene.vtm")
    assert done.returncode == 0 and "--case" in done.stderr
    done = view(tmp_path / "result", "--case", moved / "case.json", "--export", tmp_path / "scene.vtm")
    assert done.returncode == 0
    assert "tracing" in (tmp_path / "scene.vtm").read_text()


def test_exclusions_of_the_run_are_not_drawn(view, run, sample, tmp_path):
    done = run("register", sample / "case.json", "--output", tmp_path / "result", "--exclude", "UR1,UR2,UR3", "--no-report")
    assert done.returncode in (0, 1), done.stderr
    sizes = []
    for folder in (tmp_path / "result",):
        done = view(folder, "--export", tmp_path / "scene.vtm")
        assert done.returncode == 0 and done.stderr == "", done.stderr
        text = (tmp_path / "scene.vtm").read_text()
        file = re.search(r'name="lateral upper tracing" file="([^"]+)"', text).group(1)
        points = re.search(r'NumberOfPoints="(\d+)"', (tmp_path / file).read_text(errors="replace")).group(1)
        sizes.append(int(points))
    contours = json.loads((sample / "contours.json").read_text())["contours"]["upper"]
    left = sum(len(c["points"]) for c in contours if c["code"] not in ("UR1", "UR2", "UR3"))
    assert sizes == [left] and left > 0


def test_register_does_not_load_vtk(program):
    """What starts the program must not wait for VTK: none of its libraries is among those that the loader maps."""
    done = subprocess.run(["ldd", str(program)], capture_output=True, text=True)
    libraries = [line.split()[0] for line in done.stdout.splitlines()]
    assert any(name.startswith("libDentalSCRRegistrationScene.") for name in libraries), done.stderr
    assert [name for name in libraries if name.startswith(("libvtk", "libDentalSCRRegistrationSceneVTK"))] == []


@needs_xvfb
@pytest.mark.skipif(shutil.which("xvfb-run") is None, reason="xvfb-run is not installed")
def test_a_window_opens_and_ends_with_its_program(program, result):
    """There it is until it is ended; the verb says that it was."""
    child = subprocess.Popen(
        ["xvfb-run", "-a", str(program), "view", str(result), "--size", "320", "240"],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
    )
    try:
        viewer, deadline = [], time.time() + 60
        while not viewer and time.time() < deadline and child.poll() is None:
            time.sleep(0.2)
            listing = subprocess.run(["ps", "-o", "pid=,args=", "--sid", str(child.pid)], capture_output=True, text=True)
            viewer = [line.split()[0] for line in listing.stdout.splitlines() if "/dentalscr-view " in line]
        assert viewer
        time.sleep(3.0)
        assert child.poll() is None, child.communicate()
        os.kill(int(viewer[0]), signal.SIGTERM)
        _, errors = child.communicate(timeout=60)
        assert child.returncode == 2 and 'ended with "Terminated"' in errors
    finally:
        if child.poll() is None:
            os.killpg(child.pid, signal.SIGKILL)
