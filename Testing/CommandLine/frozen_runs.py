"""The registrations whose results are frozen: cases of every kind, every ingredient switched, what a user can hold, the
forms of a tracing, and the mistakes that preset robust looks for.

Names are "group: what", a group a file in Frozen/. A new run is frozen by --refreeze; a seed that is changed is another
case. The seeds from 71001 on are of these tests alone: neither the settings of robust nor the documentation's figures
come from them.
"""
import json
import math

import numpy

from program_runs import Phantom, Run, Shared

IDEAL = Phantom(71001, "ideal")
TYPICAL = Phantom(71101)
HARD = Phantom(71203, "hard")
LEFT = Phantom(71301, options=("--traced-side", "left"))
BISECTED = Phantom(71401, options=("--traced-side", "mean"))
BOTH_SIDES = Phantom(71501, options=("--traced-side", "both"))
BIASED = Phantom(71601, options=("--tooth-bias", 1.0))
CLOSED = Phantom(71707, options=("--stone-base",))
REAL = Phantom(71801, "real")
REAL_HARD = Phantom(71802, "real-hard")
PRACTICE = Phantom(71803, "practice")
STANDARD = Phantom(71804, "standard")


def each(*changes):
    """One change after the other."""

    def change(case):
        for one in changes:
            one(case)

    return change


def fields(**values):
    return lambda case: case.content.update(values)


def members(field, **values):
    return lambda case: case.content[field].update(values)


def without(field, member=None):
    def change(case):
        (case.content[field] if member else case.content).pop(member or field)

    return change


def tracing(function, *jaws):
    return lambda case: case.change_tracing(function, jaws or ("upper", "lower"))


# --- what a user knows or holds ---


def centroid(corners):
    """Area-weighted, as the origin of the dental frame."""
    areas = numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return (areas[:, None] * corners.mean(axis=1)).sum(axis=0) / areas.sum()


def similarity_near_the_truth(case, jaw, pitch_error, shift):
    """What the true pitch and the true place of the scan's centroid amount to, with an error (rad, px) of both."""
    truth = json.loads(case.truth.read_text())
    image = numpy.array(truth["projection_3x4"][jaw]) @ [*centroid(case.corners(jaw)), 1.0]
    return {
        "similarity": {
            "scale": 1.0,
            "rotation_rad": truth["pitch_rad"] + pitch_error,
            "translation_px": [float(image[d] / image[2] + shift[d]) for d in range(2)],
        }
    }


def starts_from_similarity(pitch_error, shift, jaws=("upper", "lower")):
    def change(case):
        case.content["init"] = {jaw: similarity_near_the_truth(case, jaw, pitch_error, shift) for jaw in jaws}

    return change


def starts_from_pose(degrees, shift):
    """The true pose of the scans, turned about the axes' sum and moved (mm)."""

    def change(case):
        truth = json.loads(case.truth.read_text())
        geometry = case.content["geometry"]
        spacing = case.content["cephalogram"]["pixel_spacing_mm"]
        principal = geometry["principal_point_px"]
        distance, detector = truth["source_to_midsagittal_mm"], truth["source_to_detector_mm"]
        # P = K [R | t] with w = S + y, u w = pp_u w + D x / sp_u, v w = pp_v w - D z / sp_v (source and face right).
        matrix = numpy.array(truth["projection_3x4"]["upper"])
        matrix = matrix / numpy.linalg.norm(matrix[2, :3])
        y = matrix[2] - [0.0, 0.0, 0.0, distance]
        x = (matrix[0] - principal[0] * matrix[2]) * spacing[0] / detector
        z = (principal[1] * matrix[2] - matrix[1]) * spacing[1] / detector
        pose = numpy.array([x, y, z])
        u, _, v = numpy.linalg.svd(pose[:, :3])
        pose[:, :3] = u @ v
        angle = math.radians(degrees)
        axis = numpy.ones(3) / math.sqrt(3.0)
        cross = numpy.cross(numpy.eye(3), axis)
        turn = numpy.eye(3) - math.sin(angle) * cross + (1.0 - math.cos(angle)) * cross @ cross
        pose = turn @ pose
        pose[:, 3] += shift
        case.content["init"] = {"pose": pose.tolist()}

    return change


# --- the forms of a tracing ---


def points_of(outline, function):
    return {**outline, "points": [function(point) for point in outline["points"]]}


def with_other_pixels(case):
    """Pixels half as high: the same radiograph at another spacing."""
    u, v = case.content["cephalogram"]["pixel_spacing_mm"]
    case.content["cephalogram"]["pixel_spacing_mm"] = [u, v / 2]
    u, v = case.content["geometry"]["principal_point_px"]
    case.content["geometry"]["principal_point_px"] = [u, 2 * v + 0.5]
    case.content.pop("landmarks_2d")
    case.change_tracing(lambda outlines: [points_of(o, lambda p: [p[0], 2 * p[1] + 0.5]) for o in outlines])
    content = case.load("contours")
    content["image_size"][1] *= 2
    case.replace("contours", content)


def reversed_directions(outlines):
    return [{**outline, "points": outline["points"][::-1]} for outline in outlines]


def without_codes(outlines):
    return [{**outline, "code": ""} for outline in outlines]


def in_one_line(outlines):
    """As somebody draws who does not lift the pen."""
    return [{"code": "", "points": [point for outline in outlines for point in outline["points"]]}]


def with_fdi_codes(case):
    quadrants = {"UR": "1", "UL": "2", "LL": "3", "LR": "4"}
    case.change_tracing(lambda outlines: [{**o, "code": quadrants[o["code"][:2]] + o["code"][2:]} for o in outlines])
    case.content["numbering"] = "FDI"


def with_weights(outlines):
    """The ends of an outline count half: where hands are least sure."""
    changed = []
    for outline in outlines:
        last = len(outline["points"]) - 1
        changed.append({**outline, "weights": [0.5 if min(i, last - i) < 2 else 1.0 for i in range(last + 1)]})
    return changed


def incisors_and_canines(outlines):
    return [outline for outline in outlines if outline["code"][2:] in "123"]


def first_points(number):
    return lambda outlines: [{**outlines[0], "points": outlines[0]["points"][:number]}]


# --- mistakes ---


def exchange_scans(case):
    case.content["upper"], case.content["lower"] = case.content["lower"], case.content["upper"]


def exchange_tracings(case):
    content = case.load("contours")
    upper, lower = content["contours"]["upper"], content["contours"]["lower"]
    rename = {"U": "L", "L": "U"}
    content["contours"] = {
        jaw: [{**outline, "code": rename[outline["code"][0]] + outline["code"][1:]} for outline in outlines]
        for jaw, outlines in (("upper", lower), ("lower", upper))
    }
    case.replace("contours", content)


def other_sides_codes(outlines):
    rename = {"R": "L", "L": "R"}
    return [{**outline, "code": outline["code"][0] + rename[outline["code"][1]] + outline["code"][2:]} for outline in outlines]


def slipped_by_a_tooth(outlines):
    return [{**outline, "code": f"{outline['code'][:2]}{int(outline['code'][2:]) + 1}"} for outline in outlines]


def mirror_scans(wound_outward):
    """As a viewer of another handedness saves them; the landmarks get the names of what they look like."""

    def mirror(corners):
        mirrored = corners * [-1.0, 1.0, 1.0]
        return mirrored[:, ::-1] if wound_outward else mirrored

    def change(case):
        for jaw in ("upper", "lower"):
            case.change_scan(jaw, mirror)
        rename = {"R": "L", "L": "R"}
        landmarks = case.load("landmarks_3d").items()
        case.replace(
            "landmarks_3d", {f"{name[0]}{rename[name[1]]}{name[2:]}": [-x, y, z] for name, (x, y, z) in landmarks}
        )

    return change


def scans_in_centimetres(case):
    for jaw in ("upper", "lower"):
        case.change_scan(jaw, lambda corners: corners / 10.0)
    landmarks = case.load("landmarks_3d").items()
    case.replace("landmarks_3d", {name: [value / 10.0 for value in point] for name, point in landmarks})


def wrong_spacing(case):
    case.content["cephalogram"]["pixel_spacing_mm"] = [1.3 * value for value in case.content["cephalogram"]["pixel_spacing_mm"]]


def same_scan_twice(case):
    case.content["lower"] = case.content["upper"]


def option(*assignments):
    return tuple(word for assignment in assignments for word in ("--option", assignment))


def typical(change=None, *arguments):
    return Run(TYPICAL, change, arguments)


RUNS = {
    # Kinds of cases; the first six are those of the accuracy gate.
    "cases: ideal": Run(IDEAL),
    "cases: typical": Run(TYPICAL),
    "cases: hard": Run(HARD),
    "cases: left": Run(LEFT),
    "cases: bisected": Run(BISECTED),
    "cases: both sides": Run(BOTH_SIDES),
    "cases: bias of each tooth": Run(BIASED),
    "cases: buccal outline": Run(Phantom(71702, options=("--buccal",))),
    "cases: facing left, source left": Run(Phantom(71703, options=("--facing", "left", "--source-side", "left"))),
    "cases: facing left, bisected": Run(Phantom(71704, options=("--facing", "left", "--traced-side", "mean"))),
    "cases: source left": Run(Phantom(71705, options=("--source-side", "left"))),
    "cases: separate frames": Run(Phantom(71706, options=("--frame", "separate"))),
    "cases: closed casts": Run(CLOSED),
    "cases: hard, drop-out": Run(Phantom(71708, "hard", ("--drop-out", 0.4))),
    "cases: hard, both sides, separate frames": Run(
        Phantom(71709, "hard", ("--traced-side", "both", "--frame", "separate"))
    ),
    "cases: coarse scans": Run(Phantom(71710, triangles=6000)),
    "cases: fine scans": Run(Phantom(71711, triangles=120000)),
    # The levels that are as bad as reality: arches with traits, whole teeth and landmarks, errors tooth by tooth.
    "levels: real": Run(REAL),
    "levels: real, upper jaw alone": Run(REAL, without("lower")),
    "levels: real-hard, jaws apart": Run(REAL_HARD, fields(occlusion=False)),
    "levels: practice": Run(PRACTICE),
    "levels: practice, landmarks alone": Run(
        PRACTICE, each(without("contours"), members("cephalogram", image_size=[703, 938]))
    ),
    "levels: standard": Run(STANDARD),
    # The case file's statements.
    "known: spacing not": typical(without("cephalogram", "pixel_spacing_mm")),
    "known: principal point not": typical(without("geometry", "principal_point_px")),
    "known: neither, bisected": Run(
        BISECTED, each(without("cephalogram", "pixel_spacing_mm"), without("geometry", "principal_point_px"))
    ),
    "known: no geometry": typical(without("geometry")),
    "known: spacing of the midsagittal plane": typical(members("cephalogram", spacing_plane="midsagittal")),
    "known: jaws apart": typical(fields(occlusion=False)),
    "known: jaws in occlusion": typical(fields(occlusion=True)),
    "known: upper jaw alone": typical(without("lower")),
    "known: lower jaw alone": typical(without("upper")),
    "known: hard, upper jaw alone": Run(HARD, without("lower")),
    "known: left, lower jaw alone": Run(LEFT, without("upper")),
    "known: bisected, upper jaw alone": Run(BISECTED, without("lower")),
    "known: crowns by shape": typical(fields(crowns="shape")),
    "known: crowns by shape, closed casts": Run(CLOSED, fields(crowns="shape")),
    # What a user holds, leaves out or starts from. No start from which the search is lost: where it then ends hangs on
    # the last bits.
    "held: scale": typical(None, "--fix", "scale"),
    "held: rotation": typical(None, "--fix", "rotation"),
    "held: translation": typical(None, "--fix", "translation"),
    "held: scale and rotation from a similarity": typical(
        starts_from_similarity(0.02, [6.0, -4.0]), "--fix", "scale,rotation"
    ),
    "held: rotation and translation from a pose": typical(
        starts_from_pose(1.0, [1.0, 0.0, -1.0]), "--fix", "rotation,translation"
    ),
    "held: start from a similarity": typical(starts_from_similarity(0.04, [12.0, -8.0])),
    "held: start from the upper jaw's similarity": typical(starts_from_similarity(0.04, [12.0, -8.0], ("upper",))),
    "held: jaws apart, start from a similarity": typical(
        each(fields(occlusion=False), starts_from_similarity(0.04, [12.0, -8.0]))
    ),
    "held: start from a pose": typical(starts_from_pose(1.0, [2.0, 1.0, -1.5])),
    "held: start without spacing": typical(
        each(starts_from_similarity(0.04, [12.0, -8.0]), without("cephalogram", "pixel_spacing_mm"))
    ),
    "held: teeth left out": typical(None, "--exclude", "UR6,UR7,LR4"),
    "held: teeth of one jaw left out": typical(fields(exclude=[f"LR{i}" for i in range(1, 9)])),
    # Forms of the tracing.
    "tracing: reversed": typical(tracing(reversed_directions)),
    "tracing: without codes": typical(tracing(without_codes)),
    "tracing: one line": typical(tracing(in_one_line)),
    "tracing: FDI": typical(with_fdi_codes),
    "tracing: weights": typical(tracing(with_weights)),
    "tracing: pixels not square": typical(with_other_pixels),
    "tracing: of one jaw": typical(tracing(lambda outlines: [], "lower")),
    "tracing: three points": typical(tracing(first_points(3), "lower")),
    "tracing: eight points": typical(tracing(first_points(8), "lower")),
    # Presets.
    "presets: paper": typical(None, "--preset", "paper"),
    "presets: paper, exact silhouette": typical(None, "--preset", "paper", "--silhouette", "mesh"),
    "presets: paper, hard": Run(HARD, None, ("--preset", "paper")),
    "presets: paper, bisected": Run(BISECTED, None, ("--preset", "paper")),
    "presets: paper, start and held": typical(
        starts_from_similarity(0.02, [6.0, -4.0]), "--preset", "paper", "--fix", "scale"
    ),
    "presets: bounding box": typical(None, "--preset", "bounding-box"),
    "presets: bounding box, nothing known": typical(
        each(without("cephalogram", "pixel_spacing_mm"), without("geometry")), "--preset", "bounding-box"
    ),
    "presets: single stage": typical(None, "--preset", "single-stage"),
    # Mistakes.
    "mistakes: scans exchanged": typical(exchange_scans),
    "mistakes: scans exchanged, no landmarks": typical(each(exchange_scans, without("landmarks_3d"), without("landmarks_2d"))),
    "mistakes: tracings exchanged": typical(exchange_tracings),
    "mistakes: wrong facing": typical(members("cephalogram", facing="left")),
    "mistakes: wrong facing, bisected": Run(BISECTED, members("cephalogram", facing="left")),
    "mistakes: other side said": typical(fields(traced_side="left")),
    "mistakes: other side coded": typical(tracing(other_sides_codes)),
    "mistakes: other side said and coded": typical(each(fields(traced_side="left"), tracing(other_sides_codes))),
    "mistakes: bisected said": typical(fields(traced_side="mean")),
    "mistakes: slipped by a tooth": typical(tracing(slipped_by_a_tooth)),
    "mistakes: scans mirrored": typical(mirror_scans(True)),
    "mistakes: scans mirrored, wound inward": typical(mirror_scans(False)),
    "mistakes: cm said to be mm": typical(scans_in_centimetres),
    "mistakes: spacing x 1.3": typical(wrong_spacing),
    "mistakes: incisors and canines alone": typical(tracing(incisors_and_canines)),
    "mistakes: another patient": Run(TYPICAL, scans_of=BIASED),
    "mistakes: one scan twice": typical(same_scan_twice),
    # The sample cases that this version reads.
    "shared: casts": Run(Shared("casts")),
    "shared: casts, jaws in occlusion": Run(Shared("casts"), fields(occlusion=True)),
    "shared: casts, crowns by shape": Run(Shared("casts"), fields(crowns="shape")),
    "shared: casts, paper": Run(Shared("casts"), None, ("--preset", "paper")),
    "shared: phantom-ideal-1": Run(Shared("phantom-ideal-1")),
    "shared: phantom-typical-2": Run(Shared("phantom-typical-2")),
    "shared: phantom-typical-3": Run(Shared("phantom-typical-3")),
    "shared: phantom-hard-5": Run(Shared("phantom-hard-5")),
    "shared: phantom-mean-6": Run(Shared("phantom-mean-6")),
    "shared: two-views-1, lateral": Run(Shared("two-views-1")),
    **{
        f"shared: standard-{i}, {evidence}": Run(Shared(f"standard-{i}", f"case-{evidence}.json"))
        for i in (1, 2, 3)
        for evidence in ("both", "landmarks", "outlines")
    },
}

# One ingredient of robust at a time, as in the study of the ablation, and the options of the kind "how many".
for assignments in (
    ["refineMidline=off"],
    ["useSideSelection=off"],
    ["useFacingFilter=off"],
    ["useOrientation=off"],
    ["useCorrelatedNoise=off"],
    ["estimateNoise=off"],
    ["useRobustKernel=off"],
    ["useFullPose=off"],
    ["useJointPose=off"],
    ["regenerateOutline=off"],
    ["checkHypotheses=off"],
    ["codeWeight=0"],
    ["yawStarts=0"],
    ["startsPerYaw=1"],
    ["rotationPriorFreedom=0"],
    ["rollSigma=1.4", "yawSigma=1.4", "tySigma=40", "kappaSigma=0.32"],
    ["rollSigma=0", "yawSigma=0", "tySigma=0", "kappaSigma=0"],
    ["maximumTracingPoints=40"],
    ["maximumEvaluations=4"],
):
    RUNS["options: " + " ".join(assignments)] = typical(None, *option(*assignments))
RUNS["options: hard, useJointPose=off"] = Run(HARD, None, option("useJointPose=off"))
RUNS["options: bisected, useFullPose=off"] = Run(BISECTED, None, option("useFullPose=off"))
RUNS["options: both sides, useSideSelection=off"] = Run(BOTH_SIDES, None, option("useSideSelection=off"))
