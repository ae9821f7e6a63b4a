"""Numbers that the documentation repeats from the code."""
import math
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def verdict_thresholds():
    header = ROOT / "Modules/Registration/PoseRefinement/include/itkRegistrationVerdict.h"
    body = re.search(r"struct Thresholds\n *{(.*?)\n *};", header.read_text(), re.S).group(1)
    return {name: float(value) for name, value in re.findall(r"double\s+(\w+)\{\s*(-?[\d.]+)\s*\}", body)}


def test_verdicts_table_has_the_codes_thresholds():
    """Each rule of the table as it stands there, with the header's number in its place."""
    rules = (ROOT / "Documentation/Robust.md").read_text().split("## Verdict")[1]
    rules = dict(re.findall(r"^\| `([\w-]+)`(?:, `facing`)? \| (.*?) \|", rules, re.M))
    t = verdict_thresholds()
    written = {
        "no-fit": [f"cost > {t['failedCost']:.2f} or < {100 * t['failedInlierShare']:.0f} % of the tracing within 4 px"],
        "poor-fit": [
            f"cost > {t['suspectCost']:.2f}",
            f"p90 > {t['suspectP90']:g}",
            f"median > {t['suspectMedian']:g}",
            f"inliers < {100 * t['suspectInlierShare']:.0f} %",
        ],
        "rough-tracing": [f"drift s_c > {t['suspectSmoothSigma']:g}"],
        "uncertain": [
            f"predicted σ > {t['suspectPredictedSigma']:g} at the tracing or > {t['suspectExtrapolatedSigma']:g} anywhere"
        ],
        "ambiguous": [f"within {t['suspectMargin']:g} of the score"],
        "prior-tension": [
            f"κ or ty > {t['suspectPriorTension']:g} sd, roll or yaw > {t['suspectRotationTension']:g} sd (17.5°)"
        ],
        "other-side": [f"lower by {-t['suspectOtherSideDeviance']:g}"],
        "inward-winding": [f"< −{-t['suspectWinding']:g} of the area"],
        "arch-width": [f"not {t['minimumArchWidth']:g}–{t['maximumArchWidth']:g} mm"],
        "undetermined": [f"> {t['failedPredictedSigma']:g} "],
        "code-offset": [f"> {t['suspectCodeOffset']:g} mm along the arch"],
        "search-limit": [f"pitch > {math.degrees(t['suspectPitch']):.0f}°"],
        "jaws-exchanged": [f"scores better by {t['hypothesisGain']:g}"],
    }
    for rule, parts in written.items():
        for part in parts:
            assert part in rules[rule], rule
    # None of the thresholds is left out above.
    assert len(t) == 20
