"""What is kept of a run's result, and when two such records are the same answer."""
import json
import math
import re

# Half a unit of the last digit is nothing beside the tolerances below.
DECIMALS = {"landmarks_px": 5}
OTHER_DECIMALS = 6

# A quarter of a micrometre on the detector: nobody sees it. Tracings moved by 1e-9 px at random, which is far more than
# another processor's exp and sin or another order of summation do, move the answers of robust and of the bounding boxes
# by less. The paper's search does not end in a point: 1e-9 px move its answer by up to 2 px. Its records hold since the
# same operations give the same bits, also without the processor's fused multiplication; a change of their order moves
# them, and is then said to be no more than that.
LANDMARK_PX = 1e-3
# The other figures of the fit: largest difference, absolute and relative to the frozen value.
FIGURE = (1e-6, 1e-3)
FIGURES = {
    # A thousandth of a pixel on landmarks 100 px apart.
    "scale": (2e-5, 0.0),
    "scale_factor": (2e-5, 0.0),
    "rotation_rad": (2e-5, 0.0),
    # That rotation on the 500 px from the image's corner.
    "translation_px": (1e-2, 0.0),
    # Roll and yaw move landmarks by a pixel a degree or two: a thousandth of a pixel is 3e-5 rad.
    "pitch_rad": (5e-5, 0.0),
    "roll_rad": (5e-5, 0.0),
    "yaw_rad": (5e-5, 0.0),
    # Lengths on the image are as exact as the landmarks they follow from, or a thousandth.
    "px": (LANDMARK_PX, 1e-3),
}
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
FOLDERS = re.compile(r"(?:/[^\s/:\"]+)+/")


def rounded(value, decimals=OTHER_DECIMALS):
    if isinstance(value, dict):
        return {key: rounded(each, DECIMALS.get(key, decimals)) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(each, decimals) for each in value]
    if isinstance(value, float):
        # No -0.0.
        return round(value, decimals) + 0.0
    return FOLDERS.sub("", value) if isinstance(value, str) else value


def record_of_jaw(jaw):
    record = {"status": jaw["status"], "reasons": jaw["reasons"], "arch": jaw["arch"]}
    if "landmarks_px" in jaw:
        # u, v and sigma, where there is one.
        sigmas = jaw.get("landmark_sigma_px", {})
        record["landmarks_px"] = {
            name: [*place, *([sigmas[name]] if name in sigmas else [])] for name, place in jaw["landmarks_px"].items()
        }
        record["error_mean_px"] = jaw.get("error", {}).get("mean_px")
        # Score and distance from the best.
        record["candidates_px"] = [[each["score"], each["distance_px"]] for each in jaw.get("candidates", [])]
        record["similarity"] = jaw["similarity"]
        for field in ("metrics", "metrics_matched"):
            # The Chamfer distance is the mean of the two directions.
            figures = jaw.get(field, {})
            record[field] = {name: figures[name] for name in ("cr_to_ios_px", "ios_to_cr_px", "hausdorff_px") if figures}
        record["details"] = dict(jaw.get("details", {}))
    return record


def record_of(outcome):
    if outcome.result is None:
        return rounded({"exit_code": outcome.exit_code, "errors": outcome.errors.splitlines()})
    result = outcome.result
    record = {"exit_code": outcome.exit_code}
    for field in ("status", "options", "skipped", "warnings", "not_checkable", "jaws_share_frame", "overjet_mm", "overbite_mm"):
        # Most of them are empty most of the time.
        if result.get(field) not in (None, [], {}):
            record[field] = result[field]
    # The rest of the geometry is the case file's, whatever the registration does.
    for field in ("pixel_spacing_mm", "principal_point_px"):
        record[field] = {name: result["geometry"][field][name] for name in ("value", "source")}
    record["jaws"] = {name: record_of_jaw(jaw) for name, jaw in result["jaws"].items()}
    return rounded(record)


def to_text(records):
    """JSON with a line a landmark and a line a small list or object, little indented: most of it is white else."""
    text = json.dumps(records, indent=1, ensure_ascii=False, sort_keys=True)
    text = re.sub(r"([\[{])\s+([^\[\]{}]*?)\s+([\]}])", fold, text)
    return re.sub(r"^ {4,}", "   ", text, flags=re.MULTILINE) + "\n"


def fold(match):
    """The innermost brackets in one line, but for lists of sentences."""
    opening, inner, closing = match.groups()
    return match.group(0) if opening == "[" and '"' in inner else opening + re.sub(r",\n\s+", ", ", inner) + closing


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def tolerance_of(path):
    for name in reversed(path):
        if name in FIGURES:
            return FIGURES[name]
        if isinstance(name, str) and name.endswith("_px"):
            return FIGURES["px"]
    return FIGURE


def say(path, what):
    return f"{' '.join(str(part) for part in path)}: {what}"


def differences(frozen, now, path=()):
    """A line for each difference that counts, the path to it first; none where the answer is the same."""
    if isinstance(frozen, dict) and isinstance(now, dict):
        lines = [say((*path, key), f"frozen {frozen[key]!r}, now not there") for key in frozen if key not in now]
        lines += [say((*path, key), f"frozen not there, now {now[key]!r}") for key in now if key not in frozen]
        for key in frozen:
            if key in now:
                compare = landmark_differences if path[-1:] == ("landmarks_px",) else differences
                lines += compare(frozen[key], now[key], (*path, key))
        return lines
    if isinstance(frozen, list) and isinstance(now, list) and len(frozen) == len(now):
        return [line for i, pair in enumerate(zip(frozen, now)) for line in differences(*pair, (*path, i))]
    if isinstance(frozen, str) and isinstance(now, str):
        return text_differences(frozen, now, path)
    if is_number(frozen) and is_number(now):
        absolute, relative = tolerance_of(path)
        limit = max(absolute, relative * abs(frozen))
        if not abs(now - frozen) <= limit:
            return [say(path, f"frozen {frozen}, now {now}, difference {now - frozen:.3g} (at most {limit:.3g})")]
        return []
    return [] if frozen == now else [say(path, f"frozen {frozen!r}, now {now!r}")]


def landmark_differences(frozen, now, path):
    """Of [u, v] or [u, v, sigma]."""
    if len(frozen) != len(now):
        return [say(path, f"frozen {frozen}, now {now}")]
    lines = []
    apart = math.dist(frozen[:2], now[:2])
    # Not the other way round, here and below: nothing is near a NaN.
    if not apart <= LANDMARK_PX:
        lines.append(say(path, f"frozen {frozen[:2]}, now {now[:2]}, {apart:.3g} px apart (at most {LANDMARK_PX})"))
    for old, new in zip(frozen[2:], now[2:]):
        if not abs(new - old) <= LANDMARK_PX:
            lines.append(say(path, f"sigma: frozen {old}, now {new}, difference {new - old:.3g} (at most {LANDMARK_PX})"))
    return lines


def text_differences(frozen, now, path):
    """Texts are the same where their words are, and each number is within a unit of its last digit: that is how far a
    number goes that lay beside the edge of a rounding."""
    same = NUMBER.sub("#", frozen) == NUMBER.sub("#", now)
    for old, new in zip(NUMBER.findall(frozen), NUMBER.findall(now)):
        unit = 10.0 ** -len(old.partition(".")[2]) if "e" not in old.lower() else 0.0
        same = same and abs(float(new) - float(old)) <= 1.001 * unit
    return [] if same else [say(path, f"frozen {frozen!r}, now {now!r}")]
