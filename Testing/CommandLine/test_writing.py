"""What the program does where its output is lost or would do harm: full disks, devices, signals, other runs. Exit code 2
with words, nothing half written, nothing of another's replaced."""
import hashlib
import json
import os
import pathlib
import resource
import shutil
import signal
import stat
import subprocess
import time

import pytest

from program_faults import wait_until
from result_files import poses_in, poses_of


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


def files_of_at_most(size):
    """For preexec_fn: as ulimit -f, a quota or a file system sets it."""
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))


@pytest.fixture(scope="module")
def result(run, sample, tmp_path_factory):
    folder = tmp_path_factory.mktemp("result") / "out"
    done = run("register", sample / "case.json", "--output", folder, "--quiet")
    assert done.returncode == 0, done.stderr
    return folder


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


def test_a_disk_that_is_read_only_is_told_and_keeps_what_it_has(run, sample, small_disk, result):
    disk = small_disk(20000)
    shutil.copytree(result, disk / "out")
    before = digests(disk)
    subprocess.run(["mount", "-o", "remount,ro", str(disk)], check=True)
    for output in (disk / "out", disk / "new"):
        fails_in_words(run("register", sample / "case.json", "--output", output, "--quiet"), str(disk), "Read-only file system")
    fails_in_words(run("render", "--case", sample / "case.json", "--output", disk / "a.png", "--quiet"), "a.png", "Read-only file system")
    fails_in_words(run("batch", sample / "case.json", "--output", disk / "batch", "--quiet"), str(disk), "Read-only file system")
    assert digests(disk) == before


# Of the memory that a run needs, from what loads the program and no more to nearly all.
@pytest.mark.parametrize("verb", ["register", "render"])
def test_where_memory_is_short_a_run_ends_in_words_or_is_whole(program, sample, result, is_sanitized, tmp_path, verb):
    if is_sanitized:
        pytest.skip("the sanitizer takes terabytes of addresses")
    output = tmp_path / ("out" if verb == "register" else "out.png")
    arguments = [sample / "case.json"] if verb == "register" else ["--case", sample / "case.json"]
    outcomes = []
    for megabytes in (60, 90, 120, 160, 400):
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, resource.RLIM_INFINITY))  # noqa: E731
        done = subprocess.run(
            [str(program), verb, *map(str, arguments), "--output", str(output), "--quiet"],
            capture_output=True, text=True, timeout=300, preexec_fn=limit,
        )
        # What the loader of the system says of a program that it can't load is not ours.
        if done.returncode == 127 and "loading shared libraries" in done.stderr:
            continue
        outcomes.append(done.returncode)
        assert done.returncode in (0, 2), (megabytes, done.returncode, done.stderr)
        if done.returncode == 2:
            assert done.stderr.splitlines()[-1].startswith("dentalscr: "), done.stderr
            assert not list(tmp_path.iterdir()), (megabytes, done.stderr)
        elif verb == "register":
            assert poses_of(output) == poses_of(result), megabytes
            shutil.rmtree(output)
        else:
            assert output.read_bytes().startswith(b"\x89PNG")
            output.unlink()
    assert set(outcomes) == {0, 2}, "limits that try nothing"


@pytest.mark.parametrize("extension", ["mha", "nrrd", "tif", "png", "jpg", "bmp"])
def test_render_on_a_full_disk(run, sample, small_disk, extension):
    disk = small_disk(4)
    arguments = ("render", "--case", sample / "case.json", "--output")
    picture = disk / f"drr.{extension}"
    picture.write_text("mine")
    fails_in_words(run(*arguments, picture), picture.name, "No space left")
    assert picture.read_text() == "mine" and len(list(disk.iterdir())) == 1


# A limit on the size of files is one on those in memory, into which libraries write that don't survive it: libpng freed twice.
@pytest.mark.parametrize("extension", ["mha", "nrrd", "tif", "png", "jpg", "bmp"])
def test_render_where_files_may_not_be_large(program, small_case, tmp_path, extension):
    picture = tmp_path / f"drr.{extension}"
    picture.write_text("mine")
    command = [str(program), "render", "--case", str(small_case), "--output", str(picture)]
    for size in (0, 1, 100, 5000, 20000):
        done = subprocess.run(command, capture_output=True, text=True, preexec_fn=files_of_at_most(size))
        fails_in_words(done, picture.name, "too large", "ulimit -f")
        assert picture.read_text() == "mine" and len(list(tmp_path.iterdir())) == 1


@pytest.mark.parametrize("verb", ["register", "phantom", "experiment", "report"])
def test_folders_of_pictures_where_files_may_not_be_large(program, run, small_case, tmp_path, verb):
    words = {
        "register": (small_case, "--quiet"),
        "phantom": ("--seed", 3, "--level", "ideal"),
        "experiment": ("--cases", 1, "--methods", "bounding-box", "--quiet"),
    }
    if verb == "report":
        done = run("register", *words["register"], "--no-report", "--output", tmp_path / "result")
        assert done.returncode == 0, done.stderr
        command = [str(program), "report", str(tmp_path / "result"), "--output", str(tmp_path / "page.html")]
    else:
        command = [str(program), verb, *map(str, words[verb]), "--output", str(tmp_path / "out")]
    before = digests(tmp_path)
    codes = []
    for size in (10, 1000, 30000, 100000, 300000):
        done = subprocess.run(command, capture_output=True, text=True, preexec_fn=files_of_at_most(size))
        codes.append(done.returncode)
        if done.returncode not in (0, 1):
            assert done.returncode == 2 and "ulimit -f" in done.stderr, (size, done.returncode, done.stderr)
            if verb != "experiment":
                assert digests(tmp_path) == before, size
    assert codes[:2] == [2, 2], codes


def test_a_radiograph_that_is_longer_than_files_may_be_is_told_so(program, sample, tmp_path):
    command = [str(program), "register", str(sample / "case.json"), "--quiet", "--output", str(tmp_path / "out")]
    done = subprocess.run(command, capture_output=True, text=True, preexec_fn=files_of_at_most(20000))
    fails_in_words(done, "ceph.png", "cannot be read", "ulimit -f")
    assert "damaged" not in done.stderr


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
        # Tests that were started with nohup would have the program ignore hangups, on purpose.
        preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL),
    )
    wait_until(lambda: (output / "experiment.json").exists() or process.poll() is not None, "the experiment begins")
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
    # Of the program and not of the shell before it, and each time again until it ends.
    wait_until(lambda: pathlib.Path(f"/proc/{process.pid}/exe").resolve() == program, "the program starts")
    sent = 0
    while process.poll() is None:
        process.send_signal(signal.SIGHUP)
        sent += 1
        time.sleep(0.05)
    assert process.returncode == 0 and sent > 0


@pytest.fixture(scope="module")
def small_case(run, tmp_path_factory):
    """One that is registered in half a second, into files that say which of two runs they are of."""
    folder = tmp_path_factory.mktemp("small") / "case"
    done = run("phantom", "--seed", 11, "--triangles", 6000, "--no-radiograph", "--output", folder)
    assert done.returncode == 0, done.stderr
    return folder / "case.json"


def test_killed_at_each_change_of_its_folder_nothing_is_half_written(program, run, small_case, faults, tmp_path):
    """Over an earlier result, and before each file that is made, renamed or removed: what is there then is all of the
    earlier run, all of this one, or without the result.json that says that the others belong together."""
    commands, wholes = {}, {}
    for name, options in {"earlier": ["--fix", "scale"], "this": []}.items():
        commands[name] = ["register", str(small_case), "--quiet", "--no-report", *options, "--output"]
        assert run(*commands[name], tmp_path / name).returncode == 0
        wholes[name] = {path.name: path.read_bytes() for path in (tmp_path / name).iterdir()}
    assert set(wholes["earlier"]) == set(wholes["this"])
    # Every file says of which run it is; the result's times are of no run alone.
    for name in wholes["this"]:
        if name.endswith("similarity2d.tfm"):
            assert wholes["earlier"][name] != wholes["this"][name], name
    assert poses_in(wholes["earlier"]["result.json"]) != poses_in(wholes["this"]["result.json"])

    def is_of(name, files):
        whole = wholes[name]
        return set(files) == set(whole) and all(
            poses_in(files[file]) == poses_in(whole[file]) if file == "result.json" else files[file] == whole[file] for file in files
        )

    output = tmp_path / "out"
    found = []
    for change in range(1, 200):
        shutil.rmtree(output, ignore_errors=True)
        shutil.copytree(tmp_path / "earlier", output)
        done = subprocess.run([str(program), *commands["this"], str(output)], env=faults(KILL_AT=change))
        files = {path.name: path.read_bytes() for path in output.iterdir() if not path.name.startswith(".dentalscr-")}
        if is_of("earlier", files):
            found.append("earlier")
        elif is_of("this", files):
            found.append("this")
        else:
            assert "result.json" not in files, (change, sorted(files))
            found.append("none")
        if done.returncode == 0:
            assert found[-1] == "this"
            break
        assert done.returncode == -signal.SIGKILL
    else:
        pytest.fail("it never came to its end")
    # First the one, at last the other, and there are moments between: it is these that the test is about.
    order = [state for i, state in enumerate(found) if i == 0 or state != found[i - 1]]
    assert order == ["earlier", "none", "this"], order
    assert found.count("earlier") > 5 and found.count("none") >= len(wholes["this"]) - 1, found
    # And the next run sweeps up what the last killed one has left.
    (output / "result.json").unlink()
    subprocess.run([str(program), *commands["this"], str(output)], env=faults(KILL_AT=4))
    assert [path for path in output.iterdir() if path.name.startswith(".dentalscr-")], "nothing is left to be swept up"
    assert run(*commands["this"], output).returncode == 0
    assert is_of("this", {path.name: path.read_bytes() for path in output.iterdir()})


def test_a_sweep_that_is_faster_than_its_owner_takes_nothing(program, small_case, faults, tmp_path):
    """Between the making of a temporary folder and its locking another process may find it and remove it."""
    command = [str(program), "register", str(small_case), "--quiet", "--no-report", "--output", str(tmp_path / "out")]
    done = subprocess.run(command, env=faults(SWEEP=3), capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out" / "result.json").exists()
    # Where it is removed each time, whoever does it, there is an end, and it is told.
    done = subprocess.run(command, env=faults(SWEEP=10**6), capture_output=True, text=True)
    fails_in_words(done, "out", "can't be written")


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
