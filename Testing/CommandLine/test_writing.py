"""What the program does where its output is lost or would do harm: full disks, devices, signals, other runs. Exit code 2
with words, nothing half written, nothing of another's replaced."""
import hashlib
import json
import os
import pathlib
import shutil
import signal
import stat
import subprocess
import time

import pytest


def digests(folder):
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def fails_in_words(done, *words):
    assert done.returncode == 2, (done.returncode, done.stderr)
    lines = [line for line in done.stderr.splitlines() if not line.startswith("dentalscr: warning:")]
    assert len(lines) == 1, done.stderr
    for word in words:
        assert word in lines[0], (word, lines[0])


@pytest.fixture(scope="module")
def result(run, sample, tmp_path_factory):
    folder = tmp_path_factory.mktemp("result") / "out"
    done = run("register", sample / "case.json", "--output", folder, "--quiet")
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture
def small_disk(tmp_path):
    """A file system of as many KiB as are asked for; only root may mount one."""
    if os.geteuid() != 0:
        pytest.skip("a small file system can be mounted by root only")
    mounted = []

    def mount(size):
        folder = tmp_path / f"disk{len(mounted)}"
        folder.mkdir()
        done = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}k", "none", str(folder)], capture_output=True)
        if done.returncode != 0:
            pytest.skip("this system lets nobody mount a small file system: " + done.stderr.decode().strip())
        mounted.append(folder)
        return folder

    yield mount
    for folder in mounted:
        subprocess.run(["umount", str(folder)], check=True)


# Sizes from one that takes nothing to one that takes nearly all: another file is the one that fails each time.
@pytest.mark.parametrize("size", [4, 40, 200, 1000, 3000, 9000])
def test_register_on_a_full_disk(run, sample, result, small_disk, size):
    disk = small_disk(size)
    output = disk / "out"
    done = run("register", sample / "case.json", "--output", output, "--quiet")
    if done.returncode == 0:
        assert set(digests(output)) == set(digests(result))
        assert size == 9000, "the case's files became smaller: sizes that test nothing"
    else:
        fails_in_words(done, "No space left")
        assert not list(disk.rglob("*")), "nothing half written, and the space is free again"


def test_register_on_a_disk_that_is_full_but_for_an_earlier_result(run, sample, small_disk, result):
    disk = small_disk(sum(path.stat().st_size for path in result.iterdir()) // 1024 + 200)
    shutil.copytree(result, disk / "out")
    before = digests(disk / "out")
    done = run("register", sample / "case.json", "--output", disk / "out", "--quiet", "--option", "useRobustKernel=off")
    fails_in_words(done, "No space left")
    assert digests(disk / "out") == before


@pytest.mark.parametrize("extension", ["mha", "nrrd", "tif", "png", "jpg", "bmp"])
def test_render_on_a_full_disk(run, sample, small_disk, extension):
    disk = small_disk(4)
    arguments = ("render", "--case", sample / "case.json", "--output")
    picture = disk / f"drr.{extension}"
    picture.write_text("mine")
    fails_in_words(run(*arguments, picture), picture.name, "No space left")
    assert picture.read_text() == "mine" and len(list(disk.iterdir())) == 1


@pytest.mark.parametrize("extension", ["mha", "nrrd", "tif", "png", "jpg", "bmp"])
def test_render_writes_what_can_be_read(run, sample, tmp_path, extension):
    picture = tmp_path / f"drr.{extension}"
    done = run("render", "--case", sample / "case.json", "--output", picture)
    assert done.returncode == 0, done.stderr
    magic = {"mha": b"ObjectType", "nrrd": b"NRRD", "tif": b"II*", "png": b"\x89PNG", "jpg": b"\xff\xd8", "bmp": b"BM"}
    assert picture.read_bytes().startswith(magic[extension])
    assert [path.name for path in tmp_path.iterdir()] == [picture.name]


def test_a_failed_render_leaves_what_was_there(run, case):
    scan = case.folder / "upper.stl"
    before = scan.read_bytes()
    fails_in_words(run("render", "--case", case.file, "--output", scan), "upper.stl", ".png")
    assert scan.read_bytes() == before


@pytest.mark.parametrize("verb", ["phantom", "axis", "experiment", "batch"])
def test_folders_on_a_full_disk(run, sample, small_disk, verb):
    disk = small_disk(8)
    words = {
        "phantom": ("--seed", 3),
        "axis": ("--case", sample / "case.json"),
        "experiment": ("--cases", 1),
        "batch": (sample / "case.json",),
    }[verb]
    done = run(verb, *words, "--output", disk / "out")
    assert done.returncode == 2 and "No space left" in done.stderr, done.stderr
    assert not list(disk.rglob(".dentalscr-*")), "no leftover"


def test_lost_standard_output_is_an_error(program, sample, result):
    words = {
        "evaluate": [result / "result.json", "--landmarks", sample / "landmarks2d.json"],
        "help": ["--help"],
        "version": ["--version"],
        "xml": ["--xml"],
    }
    for verb, arguments in words.items():
        command = [str(program), *([verb] if verb == "evaluate" else []), *map(str, arguments)]
        with open("/dev/full", "w") as full:
            done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True)
        fails_in_words(done, "standard output")
        # A pipe that nobody reads any more, and a stream that was closed.
        reader, writer = os.pipe()
        os.close(reader)
        done = subprocess.run(command, stdout=writer, stderr=subprocess.PIPE, text=True)
        os.close(writer)
        fails_in_words(done, "standard output")
        done = subprocess.run(["sh", "-c", 'exec "$@" >&-', "sh", *command], stderr=subprocess.PIPE, text=True)
        fails_in_words(done, "standard output")
        assert subprocess.run(command, capture_output=True).returncode == 0


def test_what_is_said_is_not_written_into_a_file_that_takes_the_place_of_a_closed_stream(program, sample, tmp_path):
    command = [str(program), "register", str(sample / "case.json"), "--output", str(tmp_path / "out")]
    subprocess.run(["sh", "-c", 'exec "$@" <&- >&- 2>&-', "sh", *command])
    json.loads((tmp_path / "out" / "result.json").read_text())


def test_devices_are_not_replaced(run, sample, result, tmp_path):
    device = tmp_path / "null"
    try:
        os.mknod(device, stat.S_IFCHR | 0o666, os.makedev(1, 3))
    except PermissionError:
        pytest.skip("only root makes devices")
    reference = sample / "landmarks2d.json"
    assert run("evaluate", result / "result.json", "--landmarks", reference, "--csv", device).returncode == 0
    assert run("render", "--case", sample / "case.json", "--output", device.with_name("null")).returncode == 2
    assert run("register", sample / "case.json", "--output", device).returncode == 2
    assert stat.S_ISCHR(device.stat().st_mode)


def test_folder_names_may_be_long(run, sample, tmp_path):
    for length in (240, 255):
        output = tmp_path / ("n" * length)
        done = run("register", sample / "case.json", "--output", output, "--no-report")
        assert done.returncode == 0, done.stderr
        assert (output / "result.json").exists()
    assert run("phantom", "--no-radiograph", "--output", tmp_path / ("p" * 250)).returncode == 0


def test_one_run_owns_a_folder(program, run, sample, tmp_path):
    """Four at once, again and again: one has it, the others are told, and what is there is of one run."""
    output = tmp_path / "out"
    for _ in range(4):
        runs = [
            subprocess.Popen(
                [str(program), "register", str(sample / "case.json"), "--output", str(output), "--quiet", *options],
                stderr=subprocess.PIPE,
                text=True,
            )
            for options in ([], ["--exclude", "UR1"], ["--option", "useRobustKernel=off"], ["--fix", "scale"])
        ]
        said = [(process.communicate(timeout=300)[1], process.returncode) for process in runs]
        winners = [errors for errors, code in said if code == 0]
        assert winners, said
        for errors, code in said:
            assert code == 0 or (code == 2 and "another run is at work" in errors), (code, errors)
        json.loads((output / "result.json").read_text())
        assert len(list(output.iterdir())) == 11, sorted(output.iterdir())
        assert not list(tmp_path.glob(".*"))


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGPIPE])
def test_signals_that_ask_to_end(program, sample, tmp_path, number):
    output = tmp_path / "out"
    process = subprocess.Popen(
        [str(program), "experiment", "--cases", "50", "--output", str(output), "--quiet"],
        stderr=subprocess.PIPE,
        text=True,
        restore_signals=True,
    )
    while not (output / "experiment.json").exists():
        time.sleep(0.01)
    process.send_signal(number)
    errors = process.communicate(timeout=60)[1]
    assert process.returncode == 2 and "interrupted" in errors, (process.returncode, errors)
    assert not list(tmp_path.rglob(".dentalscr-*"))


def test_nohup_is_heeded(program, sample, tmp_path):
    process = subprocess.Popen(
        ["sh", "-c", 'trap "" HUP; exec "$@"', "sh", str(program), "register", str(sample / "case.json"), "--output", str(tmp_path / "out")],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    for _ in range(20):
        time.sleep(0.05)
        if process.poll() is not None:
            break
        process.send_signal(signal.SIGHUP)
    assert process.wait(timeout=60) == 0


def test_killed_at_any_moment_nothing_is_half_written(program, run, sample, tmp_path):
    """A result.json beside which everything is of its run, or none; and the next run sweeps up."""
    output = tmp_path / "out"
    command = [str(program), "register", str(sample / "case.json"), "--output", str(output), "--quiet"]
    start = time.monotonic()
    assert subprocess.run(command).returncode == 0
    duration = time.monotonic() - start
    whole = set(digests(output))
    for k in range(12):
        process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
        time.sleep(duration * (0.4 + 0.6 * k / 12))
        process.kill()
        process.wait()
        if (output / "result.json").exists():
            json.loads((output / "result.json").read_text())
            assert whole <= {name for name in digests(output) if ".part" not in name}
    assert run(*command[1:]).returncode == 0
    assert set(digests(output)) == whole and len(list(output.iterdir())) == len(whole)


def test_control_characters_are_shown_and_not_sent(run, case, tmp_path):
    """As names of files, of verbs and of what is in the files: no escape sequence reaches the terminal."""
    evil = "\x1b]0;owned\x07\x1b[2Jé\x9b31m\u202e"
    outputs = [run(evil), run("register", tmp_path / (evil + ".json"), "--output", tmp_path / "out")]
    (case.folder / (evil + ".stl")).write_bytes(b"nothing")
    case.change(upper=evil + ".stl")
    outputs.append(run("register", case.file, "--output", tmp_path / "out"))
    case.change(**{evil: 1})
    outputs.append(run("register", case.file, "--output", tmp_path / "out"))
    for done in outputs:
        assert done.returncode == 2
        said = done.stdout + done.stderr
        assert not [letter for letter in said if letter not in "\n\t" and not letter.isprintable()], repr(said)
        assert "\\x1b" in said, said
    # Letters of other languages are no control characters.
    assert "é" in outputs[0].stderr
