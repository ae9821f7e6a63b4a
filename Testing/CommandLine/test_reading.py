"""What is no regular file, what changes while it is read, and numbers that no case has: an error, and at once."""
import json
import os
import pathlib
import shutil
import subprocess
import threading
import time

import pytest

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
def test_pipes_and_what_the_kernel_makes_up_are_refused_at_once(run, case, tmp_path, field):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for path in (pipe, "/dev/zero", "/proc/kmsg", "/proc/self/pagemap", tmp_path):
        start = time.monotonic()
        done = run(*command_that_reads(field, path, case, tmp_path))
        assert done.returncode == 2 and done.stderr.startswith("dentalscr: "), (path, done.stderr)
        assert time.monotonic() - start < 10
        assert not (tmp_path / "out").exists()


def test_a_scan_that_is_cut_short_while_it_is_read_is_an_error(program, case, tmp_path):
    """Mapped it was SIGBUS, in 12 of 25 trials."""
    scan = case.folder / "upper.stl"
    # Long enough to be met while it is read: the same triangles again and again.
    data = scan.read_bytes()
    count = int.from_bytes(data[80:84], "little")
    times = 100_000_000 // len(data)
    scan.write_bytes(data[:80] + (count * times).to_bytes(4, "little") + data[84:] * times)
    whole = scan.stat().st_size
    codes = []
    for k in range(12):
        process = subprocess.Popen(
            [str(program), "axis", "--upper", str(scan), "--output", str(tmp_path / "out"), "--quiet"],
            stderr=subprocess.PIPE,
            text=True,
        )
        time.sleep(0.03 + 0.01 * k)
        os.truncate(scan, whole // 3)
        errors = process.communicate(timeout=120)[1]
        codes.append(process.returncode)
        assert process.returncode in (0, 2), (process.returncode, errors)
        os.truncate(scan, whole)
        os.utime(scan)
    assert 2 in codes, "nothing was met: this tests nothing"


@pytest.mark.parametrize("value", [4e9, -4e9, 1e18, 1e300])
def test_a_coordinate_that_no_radiograph_has(run, case, tmp_path, value):
    content = case.load("contours.json")
    content["contours"]["upper"][0]["points"][3][1] = value
    case.save(content, "contours.json")
    start = time.monotonic()
    done = run("register", case.file, "--output", tmp_path / "out")
    assert done.returncode == 2 and "contours.json" in done.stderr and "coordinate" in done.stderr, done.stderr
    assert time.monotonic() - start < 5


@pytest.mark.parametrize("value", [1e12, -1e30, 1e38])
def test_a_point_of_a_scan_that_no_scan_has(run, case, tmp_path, value):
    (case.folder / "upper.obj").write_text(f"v 0 0 0\nv 1 0 0\nv 0 1 0\nv {value:.0f} 0 1\nf 1 2 3\nf 2 3 4\n")
    case.change(upper="upper.obj")
    start = time.monotonic()
    done = run("register", case.file, "--output", tmp_path / "out")
    # As a finding or as an error: what counts is that it is told, and at once.
    assert done.returncode in (1, 2) and "upper" in done.stderr, done.stderr
    assert time.monotonic() - start < 5


def test_a_file_that_changes_is_noticed(program, case, tmp_path):
    """While it is written to without a pause: an error that says so, or a result of one state; never something else."""
    contours = case.folder / "contours.json"
    text = contours.read_text()
    stop = threading.Event()

    def disturb():
        while not stop.is_set():
            with open(contours, "w") as file:
                file.write(text[: len(text) // 2])
                file.flush()
                file.write(text[len(text) // 2 :])

    thread = threading.Thread(target=disturb)
    thread.start()
    try:
        for _ in range(4):
            done = subprocess.run(
                [str(program), "register", str(case.file), "--output", str(tmp_path / "out"), "--quiet", "--no-report"],
                capture_output=True,
                text=True,
                timeout=60,
            )
            assert done.returncode in (0, 2), done.stderr
            if done.returncode == 2:
                assert "contours.json" in done.stderr, done.stderr
    finally:
        stop.set()
        thread.join()
