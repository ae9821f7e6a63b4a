"""What the tests of faults share: a moment that is waited for and not guessed, what one run used, and faults at a moment
that is chosen (Support/dentalscrFaults.c)."""
import dataclasses
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time


def wait_until(holds, what, seconds=120):
    """Waits for something that has to come; how long that takes is the machine's business and not the test's."""
    deadline = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < deadline, f"{what}: not within {seconds} seconds"
        time.sleep(0.01)


def processes_of(folder):
    """Those of which an argument lies in the folder, and which have not ended."""
    found = []
    for process in pathlib.Path("/proc").iterdir():
        if process.name.isdigit() and int(process.name) != os.getpid():
            try:
                arguments = (process / "cmdline").read_bytes().split(b"\0")
            except OSError:
                # It has ended meanwhile.
                continue
            if any(argument.startswith(os.fsencode(folder)) for argument in arguments):
                found.append(int(process.name))
    return found


@dataclasses.dataclass
class Measured:
    returncode: int
    stdout: str
    stderr: str
    # Of the process and of those that it has waited for, which its decoder is one of: the time of the processor, which a
    # busy machine doesn't lengthen, and the most memory that one of them had.
    seconds: float
    kibibytes: int


def measure(command, timeout=120, env=None, **keywords):
    """Runs a command. Unlike RUSAGE_CHILDREN, what it used is its own and not the most of all that ran before, nor what the
    process had that started it (measured_command.py)."""
    job = json.dumps({"command": [*map(str, command)], "env": dict(os.environ if env is None else env), "timeout": timeout})
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err, tempfile.TemporaryFile() as usage:
        subprocess.run(
            # Itself it has none of the faults, which are the command's.
            [sys.executable, "-I", "-S", pathlib.Path(__file__).with_name("measured_command.py"), str(usage.fileno()), job],
            stdout=out,
            stderr=err,
            pass_fds=[usage.fileno()],
            check=True,
            **keywords,
        )
        texts = []
        for stream in (out, err, usage):
            stream.seek(0)
            texts.append(stream.read().decode(errors="replace"))
    used = json.loads(texts.pop())
    assert not used["late"], f"{command} hangs: it was ended after {timeout} seconds"
    return Measured(used["returncode"], *texts, used["seconds"], used["kibibytes"])


# By these a user, a terminal or a system asks a program to end.
ASKING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def start_as_a_user_does(command):
    """A program that heeds all signals, also where the tests were started in the background or with nohup, which has theirs
    ignored. Its own session: what it starts can be told from what other tests have."""

    def heed():
        for number in ASKING:
            signal.signal(number, signal.SIG_DFL)

    return subprocess.Popen(
        [*map(str, command)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True, preexec_fn=heed
    )
