#!/usr/bin/env python-real
"""The verb axis of DentalSCR as a command-line module of 3D Slicer; DentalSCRAxis.xml describes it."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from DentalSCRLib.modules import main  # noqa: E402

if __name__ == "__main__":
    sys.exit(main("axis"))
