"""Damaged files, each in the place of a good one of a case. Each ends in words that name it, or in a result that
is whole; none in a crash, a hang or a half-written folder. That a file is refused is expected where nothing else would
do: what is left of half a scan must be no scan."""
import gzip
import json
import random
import shutil
import struct

import pytest

from program_faults import measure


def overwritten(data, at, new):
    return data[:at] + new + data[at + len(new) :]


def noise(seed, count):
    return random.Random(seed).randbytes(count)


# What is done to a file, and whether it has to be refused for it. Of the others some formats keep enough to be read: a few
# bits, a line's end, something behind the end.
DAMAGES = {
    "nothing is left": (lambda data: b"", True),
    "its first byte is left": (lambda data: data[:1], True),
    "its first 16 bytes are left": (lambda data: data[:16], True),
    "a tenth is left": (lambda data: data[: len(data) // 10], True),
    "half is left": (lambda data: data[: len(data) // 2], True),
    "its last byte is lost": (lambda data: data[:-1], False),
    "its last 100 bytes are lost": (lambda data: data[:-100], False),
    "its first byte is lost": (lambda data: data[1:], False),
    "its first 100 bytes are lost": (lambda data: data[100:], False),
    "all is zero": (lambda data: bytes(len(data)), True),
    "all is 0xff": (lambda data: b"\xff" * len(data), True),
    "all is noise": (lambda data: noise(1, len(data)), True),
    "its beginning is noise": (lambda data: noise(2, 64) + data[64:], True),
    "a block in its middle is zero": (lambda data: overwritten(data, len(data) // 2, bytes(min(512, len(data) // 8))), False),
    "a block in its middle is noise": (lambda data: overwritten(data, len(data) // 2, noise(3, min(512, len(data) // 8))), False),
    "a block in its middle is lost": (lambda data: data[: len(data) // 2] + data[len(data) // 2 + 77 :], False),
    "it is there twice": (lambda data: data + data, False),
    "a block is there twice": (lambda data: data[: len(data) // 2] + data[len(data) // 3 :], False),
    "noise follows it": (lambda data: data + noise(4, 1000), False),
    "a bit in its beginning is another": (lambda data: overwritten(data, 9, bytes([data[9] ^ 16])), False),
    "bits all over are others": (
        lambda data: bytes(byte ^ (1 << k % 8) if k % 997 == 5 else byte for k, byte in enumerate(data)),
        False,
    ),
    "it was sent as text": (lambda data: data.replace(b"\n", b"\r\n"), False),
    "its eighth bits are lost": (lambda data: bytes(byte & 127 for byte in data), False),
    "it is packed": (lambda data: gzip.compress(data), True),
    "it is a ZIP archive": (lambda data: b"PK\x03\x04" + data, True),
    "it is a web page": (lambda data: b"<!DOCTYPE html><html><body>404</body></html>", True),
    "it is UTF-16": (lambda data: data.decode("latin-1").encode("utf-16"), True),
}

FILES = {"upper.obj": "upper", "upper.vtk": "upper", "contours.json": "contours"}


@pytest.fixture(scope="module")
def good(run, tmp_path_factory):
    """A case, and its upper scan as text, too."""
    folder = tmp_path_factory.mktemp("good") / "case"
    done = run("phantom", "--seed", 11, "--triangles", 3000, "--output", folder)
    assert done.returncode == 0, done.stderr
    data = (folder / "upper.stl").read_bytes()
    numbers, faces = {}, []
    for at in range(84, len(data), 50):
        corners = [data[at + 12 + 12 * k : at + 24 + 12 * k] for k in range(3)]
        faces.append([numbers.setdefault(corner, len(numbers)) for corner in corners])
    points = ["%.9g %.9g %.9g" % struct.unpack("<3f", corner) for corner in numbers]
    lines = ["3 %d %d %d" % tuple(face) for face in faces]
    (folder / "upper.obj").write_text(
        "".join(f"v {point}\n" for point in points) + "".join("f %d %d %d\n" % tuple(k + 1 for k in face) for face in faces)
    )
    (folder / "upper.vtk").write_text(
        f"# vtk DataFile Version 3.0\nscan\nASCII\nDATASET POLYDATA\nPOINTS {len(points)} float\n"
        + "\n".join(points)
        + f"\nPOLYGONS {len(faces)} {4 * len(faces)}\n"
        + "\n".join(lines)
        + "\n"
    )
    return folder


@pytest.mark.parametrize("file_name", FILES)
def test_damaged_files_end_in_words_or_in_a_whole_result(program, good, tmp_path, file_name):
    case = tmp_path / "case"
    case.mkdir()
    content = json.loads((good / "case.json").read_text())
    content["cephalogram"].pop("image", None)
    content[FILES[file_name]] = file_name
    for name in ("lower.stl", "upper.stl", "contours.json", "landmarks3d.json", file_name):
        shutil.copy(good / name, case / name)
    content = {key: value for key, value in content.items() if not isinstance(value, str) or (case / value).exists() or "/" not in value and "." not in value}
    (case / "case.json").write_text(json.dumps(content))
    data = (good / file_name).read_bytes()
    output = tmp_path / "out"
    command = [program, "register", case / "case.json", "--output", output, "--no-report"]

    done = measure(command)
    assert done.returncode in (0, 1), done.stderr
    whole = {path.name for path in output.iterdir()}
    assert "result.json" in whole
    for what, (damage, is_refused) in DAMAGES.items():
        shutil.rmtree(output, ignore_errors=True)
        damaged = damage(data)
        (case / file_name).write_bytes(damaged)
        done = measure(command)
        said = f"{file_name}, {what}: {done.returncode}: {done.stderr}"
        assert done.seconds < 20, said
        assert done.returncode == 2 or (done.returncode in (0, 1) and not is_refused), said
        if done.returncode == 2:
            errors = [line for line in done.stderr.splitlines() if not line.startswith("dentalscr: warning:")]
            assert len(errors) == 1 and errors[0].startswith("dentalscr: "), said
            assert file_name in errors[0] or "upper" in errors[0], said
            assert not output.exists(), said
        else:
            assert {path.name for path in output.iterdir()} == whole, said
            assert json.loads((output / "result.json").read_text())["schema"] == "dentalscr-result/1", said
        assert not list(tmp_path.rglob(".dentalscr-*")), said
