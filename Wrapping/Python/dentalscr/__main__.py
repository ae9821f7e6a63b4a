"""``python -m dentalscr``: the program, with its verbs and exit codes."""
from __future__ import annotations

import signal
import sys

from . import _core


def main() -> int:
    """Runs the program on the command line's arguments; returns its exit code."""
    # The program has its own way with Ctrl-C.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _core._Main(["dentalscr", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
