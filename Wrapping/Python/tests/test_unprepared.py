"""Calls that come too early or with what makes no sense: an exception of Python, never the end of the process."""
import math
import os
import pathlib
import subprocess
import sys

import pytest

import dentalscr

# Each class in a process of its own, forked from one that has loaded the package: a signal ends that one alone.
CALLS = r"""
import os, random, sys
import numpy
import dentalscr

nothing = os.open(os.devnull, os.O_WRONLY)
values = [None, 0, -1, 2**31, 2**70, float("nan"), float("inf"), "", "\0", [], [float("nan")] * 3, numpy.zeros((0, 3)),
          numpy.full((5, 3), float("nan")), numpy.full((4, 3), -1), numpy.zeros((100, 100))[::7, ::-3], numpy.eye(4), object()]
for name in sorted(vars(dentalscr)):
    kind = getattr(dentalscr, name)
    if name.startswith("_") or not isinstance(kind, type):
        continue
    child = os.fork()
    if child == 0:
        os.dup2(nothing, 1)
        os.dup2(nothing, 2)
        try:
            draw = random.Random(name)
            made = kind()
            methods = [method for method in dir(made) if not method.startswith("_") and callable(getattr(made, method, None))]
            # Fresh, then with what was set to something odd.
            for round in range(3):
                for method in methods:
                    for arguments in ([], draw.choices(values, k=1 + round)) if round else ([],):
                        try:
                            getattr(made, method)(*arguments)
                        except BaseException:
                            pass
            repr(made)
        except BaseException:
            pass
        os._exit(0)
    status = os.waitpid(child, 0)[1]
    if os.WIFSIGNALED(status):
        print(name, "was ended by signal", os.WTERMSIG(status))
print("done")
"""


def test_no_call_ends_the_process():
    folder = pathlib.Path(dentalscr.__file__).parent.parent
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    done = subprocess.run([sys.executable, "-c", CALLS], env=environment, capture_output=True, text=True, timeout=600)
    assert done.stdout == "done\n", done.stdout + done.stderr


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_a_transform_is_of_finite_numbers(value):
    """VNL ends the process where it inverts a matrix of what is none."""
    transform = dentalscr.Similarity2DTransform(scale=2.0)
    for call in (
        lambda: transform.SetScale(value),
        lambda: transform.SetAngle(value),
        lambda: transform.SetTranslation([0.0, value]),
        lambda: transform.SetCenter([value, 0.0]),
        lambda: transform.SetParameters([1.0, 0.0, value, 0.0]),
        lambda: dentalscr.Similarity2DTransform(scale=value),
        lambda: dentalscr.VersorRigid3DTransform([[1, 0, 0, value], [0, 1, 0, 0], [0, 0, 1, 0]]),
    ):
        with pytest.raises(ValueError, match="finite numbers"):
            call()
    assert transform.GetInverse().GetScale() == pytest.approx(0.5)
    transform.SetScale(1e308)
    transform.SetAngle(0.1)
    transform.SetScale(0.0)
    with pytest.raises(ValueError, match="no inverse"):
        transform.GetInverse()


def test_residuals_of_outlines_before_there_is_a_pose():
    with pytest.raises(Exception, match="not prepared: call Initialize"):
        dentalscr.ToothOutlinePoseMetricv4().GetOutlineResiduals()
