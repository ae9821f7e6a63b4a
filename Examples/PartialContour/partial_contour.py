"""What each part of PartialContourMetricv4 does: partial_contour.py ideal|typical|hard firstSeed numberOfCases.

The moving contour is the open occlusal and anterior part of the right half's outline, projected twice: with the central
ray through the jaw, and again from where a first registration puts the jaw.
"""
import copy
import math
import sys
import time

import numpy as np

import dentalscr as ds


def open_outline(source, contour, labels, upper, facing):
    """What faces occlusally or to the front: one polyline a tooth; where two meet they share a point."""
    points, samples = contour.points, source.GetSamples()
    occlusal = samples.normals[:, 1] if upper else -samples.normals[:, 1]
    keep = (occlusal > -0.5) & ((occlusal > 0.2) | (facing * samples.normals[:, 0] > 0.2))
    code = np.zeros(len(points), int)
    for i in np.flatnonzero(keep):
        squared = ((labels.points - samples.rim[i]) ** 2).sum(axis=1)
        nearest = squared.argmin()
        code[i] = labels.labels_of_points[nearest] if squared[nearest] < 1.0 else 0
    start = 0
    while start < len(keep) and keep[start]:
        start += 1
    result = ds.Contour()
    line, tooth = [], 0
    for k in range(len(points) + 1):
        i = (start + k) % len(points)
        on = k < len(points) and bool(keep[i])
        if line and (not on or code[i] != tooth):
            if on:
                line.append(points[i])
            if len(line) > 1:
                result.AddPolyline(np.array(line), ds.tooth_name(int(tooth)) if tooth else "")
            line = []
        if on:
            tooth = code[i]
            line.append(points[i])
    return result


class Labels:
    """Copies of a mesh's points and labels, made once."""

    def __init__(self, mesh):
        self.points = np.asarray(mesh.points, float)
        self.labels_of_points = mesh.labels


def place(similarity, nominal, geometry):
    """Moves the jaw to where the similarity shows it: turned about y, shifted in the midsagittal plane."""
    f = 1.0 if nominal.GetFacing() == ds.CephalometricGeometry.Facing.Right else -1.0
    magnification = nominal.GetSourceToDetectorDistance() / nominal.GetSourceToMidsagittalDistance()
    offset = similarity.TransformPoint((0.0, 0.0))
    c, s = math.cos(similarity.GetAngle()), f * math.sin(similarity.GetAngle())
    turn = np.eye(4)
    turn[:3, :3] = [[c, 0, s], [0, 1, 0], [-s, 0, c]]
    pose = turn @ geometry.GetPose()
    principal, spacing = nominal.GetPrincipalPoint(), nominal.GetPixelSpacing()
    pose[0, 3] += f * (offset[0] - principal[0]) * spacing[0] / magnification
    pose[2, 3] -= (offset[1] - principal[1]) * spacing[1] / magnification
    geometry.SetPrincipalPoint(principal)
    geometry.SetPose(pose)


def make_case(seed, cohort):
    phantom = ds.DentalPhantomCase(seed, cohort, makeRadiograph=False)
    axes = ds.UMidlineDentalAxis(phantom.upper.mesh, phantom.lower.mesh, refineMidline=True)
    facing = 1.0 if phantom.geometry.GetFacing() == ds.CephalometricGeometry.Facing.Right else -1.0
    jaws = []
    for jaw, to_frame in ((phantom.upper, axes.upperTransform), (phantom.lower, axes.lowerTransform)):
        # The central ray through the frame's origin: its projection is q.
        geometry = copy.deepcopy(phantom.geometry)
        geometry.SetPrincipalPoint((0.0, 0.0))
        geometry.SetPose(to_frame.matrix)
        right = ds.MidlineSideMesh(jaw.mesh, to_frame)
        source = ds.MeshSilhouetteContourSource()
        source.SetNumberOfPoints(800)
        labels = Labels(jaw.mesh)
        for step in range(2):
            outline = open_outline(source, source.Execute(right, geometry), labels, jaw is phantom.upper, facing)
            if step == 0:
                first = ds.SilhouetteToContourRegistrationMethod()
                first.SetMetric(make_chamfer("FixedToMoving"))
                place(first.Execute(jaw.tracing, outline), phantom.geometry, geometry)
        whole = ds.MeshSilhouetteContour(jaw.mesh, geometry, numberOfPoints=441)
        names = sorted(jaw.landmarks2D)
        moving = geometry.ProjectPoints(np.array([jaw.landmarks3D[name] for name in names]))
        jaws.append((jaw.tracing, outline, whole, moving, np.array([jaw.landmarks2D[name] for name in names])))
    return jaws


def make_chamfer(direction):
    metric = ds.ContourChamferMetricv4()
    metric.SetDirection(direction)
    metric.SetDistance("PointToSegment")
    return metric


def partial(**settings):
    """The metric with everything that a setting then takes away or adds."""

    def make():
        metric = ds.PartialContourMetricv4()
        metric.SetScalePrior(1.0, metric.GetScaleSigma("Given"))
        metric.SetRotationPrior(0.0, 0.35)
        for name, value in settings.items():
            getattr(metric, f"Set{name}")(*value if isinstance(value, tuple) else (value,))
        return metric

    return make


SETTINGS = [  # name, whole outline, metric, optimizer
    ("symmetric Chamfer, whole outline", True, lambda: make_chamfer("Symmetric"), "LBFGSB"),
    ("symmetric Chamfer", False, lambda: make_chamfer("Symmetric"), "LBFGSB"),
    ("one-sided Chamfer", False, lambda: make_chamfer("FixedToMoving"), "LBFGSB"),
    ("**all** (below: all but)", False, partial(), "LevenbergMarquardt"),
    ("no robust kernel (squares)", False, partial(RobustKernel="Squares"), "LevenbergMarquardt"),
    ("Huber", False, partial(RobustKernel="Huber"), "LevenbergMarquardt"),
    ("no annealing", False, partial(Annealing=False), "LevenbergMarquardt"),
    ("no directions", False, partial(DirectionWeight=0.0), "LevenbergMarquardt"),
    ("no tooth gate", False, partial(GateByTooth=False), "LevenbergMarquardt"),
    ("tooth gate without neighbours", False, partial(ToothRange=0), "LevenbergMarquardt"),
    ("no scale prior", False, partial(ScalePrior=(1.0, math.inf)), "LevenbergMarquardt"),
    ("and reverse direction, 0.1", False, partial(ReverseWeight=0.1), "LevenbergMarquardt"),
    ("and reverse direction, 0.5", False, partial(ReverseWeight=0.5), "LevenbergMarquardt"),
    ("and correlated noise", False, partial(CorrelatedNoise=True), "LevenbergMarquardt"),
    ("and correlated noise, no directions", False, partial(CorrelatedNoise=True, DirectionWeight=0.0), "LevenbergMarquardt"),
    ("and correlated noise, levels not estimated", False, partial(CorrelatedNoise=True, EstimateNoise=False),
     "LevenbergMarquardt"),
    ("all, LBFGSB", False, partial(), "LBFGSB"),
    ("all, Amoeba", False, partial(), "Amoeba"),
]


def predicted_variance(metric, transform, moving):
    """Mean variance of a landmark that the metric's covariance predicts, px^2 (both coordinates)."""
    linear = np.array(transform.GetMatrix()).reshape(2, 2)
    r = (moving - metric.GetPivot()) @ linear.T / metric.GetReferenceLength()
    ones, zeros = np.ones(len(r)), np.zeros(len(r))
    rows = np.stack([np.c_[r[:, 0], -r[:, 1], ones, zeros], np.c_[r[:, 1], r[:, 0], zeros, ones]])
    return np.einsum("cia,ab,cib->", rows, metric.ComputeCovariance(), rows) / len(r)


def best_similarity_error(moving, fixed):
    """The best that any similarity does: least squares to the landmarks themselves."""
    q, p = (points @ (1.0, 1.0j) for points in (moving, fixed))
    factor = np.vdot(q - q.mean(), p - p.mean()) / np.vdot(q - q.mean(), q - q.mean())
    return np.abs(factor * (q - q.mean()) + p.mean() - p).mean()


def run(setting, jaws, figures):
    _, whole, make_metric, optimizer = setting
    for j, (tracing, outline, whole_outline, moving, fixed) in enumerate(jaws):
        method = ds.SilhouetteToContourRegistrationMethod()
        metric = make_metric()
        method.SetMetric(metric)
        getattr(method, f"SetOptimizerAs{optimizer}")()
        method.SetNumberOfLevels(5)
        begin = time.process_time()
        transform = method.Execute(tracing, whole_outline if whole else outline)
        figures["seconds"] += time.process_time() - begin
        for level in method.GetLevelResults():
            figures["iterations"] += level.numberOfIterations
            figures["evaluations"] += level.numberOfEvaluations
        errors = np.linalg.norm(transform.TransformPoints(moving) - fixed, axis=1)
        figures["errors"][j].append(errors.mean())
        if isinstance(metric, ds.PartialContourMetricv4):
            figures["naive"] += predicted_variance(metric, transform, moving)
            metric.UpdateNoiseModel()
            figures["predicted"] += predicted_variance(metric, transform, moving)
            figures["actual"] += (errors**2).mean()


def row(name, figures):
    cells = [name]
    for errors in figures["errors"]:
        cells += [f"{value:.2f}" for value in (np.mean(errors), sorted(errors)[len(errors) // 2], max(errors))]
    count = sum(map(len, figures["errors"]))
    cells += [f"{figures['iterations'] / count:.0f}", f"{figures['evaluations'] / count:.0f}"]
    cells.append(f"{1000 * figures['seconds'] / count:.1f}")
    sigma = [math.sqrt(figures[key] / figures["actual"]) for key in ("predicted", "naive") if figures["actual"] > 0]
    cells.append("{:.2f} ({:.2f})".format(*sigma) if sigma else "")
    return "| " + " | ".join(cells) + " |"


def main(cohort, first, count):
    def empty():
        return {"errors": ([], []), **dict.fromkeys(("iterations", "evaluations", "seconds", "naive", "predicted", "actual"), 0.0)}

    best, all_figures = empty(), [empty() for _ in SETTINGS]
    for seed in range(first, first + count):
        jaws = make_case(seed, cohort)
        for setting, figures in zip(SETTINGS, all_figures):
            run(setting, jaws, figures)
        for errors, (_, _, _, moving, fixed) in zip(best["errors"], jaws):
            errors.append(best_similarity_error(moving, fixed))
    print(f"| {count} {cohort} cases from seed {first} | upper: mean | median | worst | lower: mean | median | worst"
          " | iterations | evaluations | ms | sigma |\n|---|---|---|---|---|---|---|---|---|---|---|")
    print(row("best similarity to the landmarks", best))
    for (name, *_), figures in zip(SETTINGS, all_figures):
        print(row(name, figures))
    print()
    for name, figures in (("best similarity", best), ("Chamfer", all_figures[0]), ("all", all_figures[3])):
        print(f"{name} px: {np.mean(figures['errors'])}")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(f"Usage: {sys.argv[0]} ideal|typical|hard firstSeed numberOfCases")
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
