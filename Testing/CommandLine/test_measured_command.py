"""What the tests of memory and time measure is the command and not what started it."""
import os
import signal
import sys

import pytest
from program_faults import measure


def python(code):
    return [sys.executable, "-I", "-S", "-c", code]


def test_the_memory_of_the_process_that_starts_a_command_is_not_the_commands():
    # As large as pytest after many tests.
    block = b"\1" * (512 << 20)
    assert measure(python("pass")).kibibytes < 1 << 16
    assert 1 << 18 < measure(python("block = b'1' * (256 << 20)")).kibibytes < 1 << 19
    del block


def test_what_a_command_prints_returns_and_is_given_comes_back():
    done = measure(python("import os, sys; print(os.environ['WORD']); sys.exit('no')"), env=dict(os.environ, WORD="tooth"))
    assert (done.returncode, done.stdout, done.stderr) == (1, "tooth\n", "no\n")
    done = measure(python("import os, signal; os.kill(os.getpid(), signal.SIGSEGV)"))
    assert done.returncode == -signal.SIGSEGV
    done = measure(python("import time\nwhile time.process_time() < 0.3: pass"))
    assert done.seconds > 0.25


def test_a_command_that_hangs_is_ended_and_said():
    with pytest.raises(AssertionError, match="hangs: it was ended after 0.2 seconds"):
        measure(python("import time; time.sleep(600)"), timeout=0.2)
