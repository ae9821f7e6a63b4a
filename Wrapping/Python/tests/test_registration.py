"""Registration of contours and of scans, with every metric and optimizer."""
import numpy as np
import pytest

TRUE = dict(scale=1.05, angle=0.06, translation=(300.0, 420.0))


def make_curves(ds, count):
    """A curve without symmetry, and the same moved by a known similarity."""
    t = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    radius = 60.0 + 12.0 * np.cos(2 * t + 0.4) + 6.0 * np.sin(3 * t)
    moving = ds.Contour([ds.Polyline(np.c_[radius * np.cos(t), 0.6 * radius * np.sin(t)], closed=True)])
    truth = ds.Similarity2DTransform(**TRUE)
    fixed = ds.Contour([ds.Polyline(truth.TransformPoints(moving.points), closed=True)])
    return fixed, moving, truth


@pytest.fixture(scope="module")
def curves(ds):
    """Points 0.5 px apart: distances to points have minima half such a step apart."""
    return make_curves(ds, 800)


@pytest.fixture(scope="module")
def coarse_curves(ds):
    """Points 2.5 px apart: less to compute for metrics written in Python."""
    return make_curves(ds, 160)


STEP, COARSE_STEP = 0.5, 2.5


def worst_shift(transform, truth, moving):
    return np.linalg.norm(transform.TransformPoints(moving.points) - truth.TransformPoints(moving.points), axis=1).max()


def test_recovers_a_known_similarity(ds, curves):
    fixed, moving, truth = curves
    transform = ds.SilhouetteToContourRegistration(fixed, moving)
    assert worst_shift(transform, truth, moving) < STEP


OPTIMIZERS = {
    "LBFGSB": {}, "LBFGS2": {}, "Amoeba": {}, "Powell": {},
    "GradientDescent": {"learningRate": 1.0, "numberOfIterations": 200},
    "RegularStepGradientDescent": {"learningRate": 2.0, "minStep": 1e-4, "numberOfIterations": 300},
    "GradientDescentLineSearch": {"learningRate": 1.0, "numberOfIterations": 60},
    "OnePlusOneEvolutionary": {"numberOfIterations": 2000, "seed": 3},
    "Exhaustive": {"numberOfSteps": [3, 3, 3, 3], "stepLength": 1 / 3},
}


@pytest.mark.parametrize("name", OPTIMIZERS)
def test_every_optimizer_lowers_the_metric(ds, curves, name):
    fixed, moving, truth = curves
    method = ds.SilhouetteToContourRegistrationMethod()
    getattr(method, "SetOptimizerAs" + name)(**OPTIMIZERS[name])
    transform = method.Execute(fixed, moving)
    start = ds.SilhouetteToContourRegistrationMethod.ComputeBoundingBoxTransform(fixed, moving)
    chamfer = ds.SilhouetteToContourRegistrationMethod()
    assert chamfer.MetricEvaluate(fixed, moving, transform) < chamfer.MetricEvaluate(fixed, moving, start)
    # Three steps to each side of the last level's bounds reach less far than an iteration.
    assert worst_shift(transform, truth, moving) < (8.0 if name == "Exhaustive" else 2.0)
    assert method.GetOptimizerStopConditionDescription()


def test_metric_object_with_settings(ds, curves):
    fixed, moving, truth = curves
    metric = ds.ContourChamferMetricv4()
    metric.SetDirection("FixedToMoving")
    metric.SetDistance("PointToSegment")
    method = ds.SilhouetteToContourRegistrationMethod()
    method.SetMetric(metric)
    assert worst_shift(method.Execute(fixed, moving), truth, moving) < 0.1


def nearest_squares(fixed, moved):
    """Mean squared distance of the tracing to the nearest moved point, and its derivatives."""
    difference = moved[None, :, :] - fixed[:, None, :]
    nearest = (difference**2).sum(axis=2).argmin(axis=1)
    rows = difference[np.arange(len(fixed)), nearest]
    gradient = np.zeros_like(moved)
    np.add.at(gradient, nearest, 2.0 * rows / len(fixed))
    return (rows**2).sum() / len(fixed), gradient


@pytest.mark.parametrize("with_gradient", [True, False])
def test_own_metric_as_a_function(ds, coarse_curves, with_gradient):
    fixed, moving, truth = coarse_curves
    calls = []

    def metric(fixed_points, moved_points):
        calls.append(fixed_points.shape)
        value = nearest_squares(fixed_points, moved_points)
        return value if with_gradient else value[0]

    method = ds.SilhouetteToContourRegistrationMethod()
    method.SetMetricAsFunction(metric)
    method.SetNumberOfLevels(1)
    method.SetLevel(0, ds.RegistrationLevel(scaleBound=0.2, rotationBound=0.2, translationBound=5.0))
    transform = method.Execute(fixed, moving)
    assert worst_shift(transform, truth, moving) < COARSE_STEP
    assert calls and set(calls) == {(160, 2)}


def test_gradient_of_an_own_metric_is_that_of_its_differences(ds, coarse_curves):
    """The chain rule from the moved points to the similarity, seen through the path of a descent."""
    fixed, moving, _ = coarse_curves
    paths = []
    for with_gradient in (True, False):
        method = ds.SilhouetteToContourRegistrationMethod()
        method.SetMetricAsFunction(lambda f, m: nearest_squares(f, m)[slice(None) if with_gradient else 0])
        method.SetOptimizerAsGradientDescent(learningRate=0.3, numberOfIterations=4)
        method.SetNumberOfLevels(1)
        method.SetLevel(0, ds.RegistrationLevel(0.2, 0.2, 5.0))
        path = []
        method.AddCommand(ds.sitkIterationEvent, lambda: path.append(method.GetOptimizerPosition()))
        method.Execute(fixed, moving)
        paths.append(np.array(path))
    assert len(paths[0]) >= 4
    # Central differences of steps of a thousandth of a pixel.
    assert np.allclose(paths[0], paths[1], rtol=1e-5, atol=1e-4)


def test_own_metric_that_raises_ends_the_registration_with_its_exception(ds, curves):
    class Mine(Exception):
        pass

    def metric(fixed, moved):
        raise Mine("no")

    method = ds.SilhouetteToContourRegistrationMethod()
    method.SetMetricAsFunction(metric)
    with pytest.raises(Mine, match="no"):
        method.Execute(curves[0], curves[1])
    method.SetMetric(None)
    assert worst_shift(method.Execute(curves[0], curves[1]), curves[2], curves[1]) < STEP


@pytest.mark.parametrize("answer", ["text", (1.0, np.zeros((3, 2))), (1.0, 2.0, 3.0)])
def test_own_metric_that_returns_nonsense_is_an_error(ds, curves, answer):
    method = ds.SilhouetteToContourRegistrationMethod()
    method.SetMetricAsFunction(lambda fixed, moved: answer)
    method.SetOptimizerAsGradientDescent(1.0, 2)
    with pytest.raises(Exception) as error:
        method.Execute(curves[0], curves[1])
    assert isinstance(error.value, (ValueError, RuntimeError, TypeError))


def test_levels_are_the_papers_and_can_be_changed(ds, curves):
    method = ds.SilhouetteToContourRegistrationMethod()
    assert [round(method.GetLevel(i).scaleBound, 3) for i in range(method.GetNumberOfLevels())] == [0.35, 0.1, 0.03]
    level = method.GetLevel(1)
    level.rotationBound = 0.5
    method.SetLevel(1, level)
    assert method.GetLevel(1).rotationBound == 0.5
    method.Execute(curves[0], curves[1])
    results = method.GetLevelResults()
    assert len(results) == 3
    assert all(result.finalValue <= result.initialValue for result in results)
    with pytest.raises(ds.Error):
        method.GetLevel(7)


def test_global_preset_finds_a_far_start(ds, curves):
    fixed, moving, truth = curves
    method = ds.SilhouetteToContourRegistrationMethod()
    method.SetPresetToGlobal()
    method.SetInitialTransform(ds.Similarity2DTransform(0.85, 0.5, (320.0, 400.0)))
    assert worst_shift(method.Execute(fixed, moving), truth, moving) < STEP


def test_fixed_scale_stays(ds, curves):
    fixed, moving, _ = curves
    start = ds.Similarity2DTransform(1.0, 0.0, (300.0, 420.0))
    transform = ds.SilhouetteToContourRegistration(fixed, moving, initialTransform=start, fixScale=True)
    assert transform.GetScale() == pytest.approx(1.0, abs=1e-9)


def test_residual_distances_belong_to_the_tracing(ds, curves):
    fixed, moving, _ = curves
    method = ds.SilhouetteToContourRegistrationMethod()
    with pytest.raises(ds.ArgumentError, match="Execute"):
        method.GetResidualDistances()
    method.Execute(fixed, moving)
    assert method.GetResidualDistances().shape == (800,) and method.GetResidualDistances().max() < STEP


@pytest.mark.parametrize(
    "twin", ["IterativeClosestPointContourRegistration", "CoherentPointDriftContourRegistration"]
)
def test_baselines_recover_the_similarity(ds, curves, twin):
    fixed, moving, truth = curves
    assert worst_shift(getattr(ds, twin)(fixed, moving), truth, moving) < 2.0 * STEP


def test_intensity_registration_of_a_shifted_picture(ds):
    v, u = np.mgrid[0:160, 0:200]

    def blobs(du, dv):
        return sum(
            np.exp(-((u - x - du) ** 2 / a + (v - y - dv) ** 2 / b) / 2)
            for x, y, a, b in ((80, 70, 300, 150), (120, 95, 200, 400), (95, 105, 90, 90))
        )

    box = np.array([[60.0, 50.0], [140.0, 50.0], [140.0, 120.0], [60.0, 120.0]])
    transform = ds.IntensityRegistration(
        blobs(3.0, -2.0), blobs(0.0, 0.0), ds.Contour([ds.Polyline(box, closed=True)]),
        ds.Contour([ds.Polyline(box, closed=True)]), measure="NormalizedCorrelation",
    )
    assert np.allclose(transform.TransformPoint((100.0, 85.0)), (103.0, 83.0), atol=0.3)


@pytest.mark.parametrize("value, error", [(None, TypeError), ("x", TypeError), (float("nan"), ValueError)])
def test_metric_that_gives_no_number_is_told_so(ds, curves, value, error):
    method = ds.SilhouetteToContourRegistrationMethod()
    method.SetMetricAsFunction(lambda fixed, moved: value)
    with pytest.raises(error, match="a metric return"):
        method.Execute(curves[0], curves[1])
