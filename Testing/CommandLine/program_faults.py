"""What the tests of faults share: a moment that is waited for and not guessed, what one run used, and faults at a moment
that is chosen (Support/dentalscrFaults.c)."""
import dataclasses
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
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


def measure(command, timeout=120, **keywords):
    """Runs a command. Unlike RUSAGE_CHILDREN, what it used is its own and not the most of all that ran before."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        process = subprocess.Popen([*map(str, command)], stdout=out, stderr=err, **keywords)
        late = threading.Event()

        def end():
            late.set()
            os.kill(process.pid, signal.SIGKILL)

        timer = threading.Timer(timeout, end)
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        assert not late.is_set(), f"{command} hangs: it was ended after {timeout} seconds"
        texts = []
        for stream in (out, err):
            stream.seek(0)
            texts.append(stream.read().decode(errors="replace"))
    return Measured(process.returncode, *texts, usage.ru_utime + usage.ru_stime, usage.ru_maxrss)


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
