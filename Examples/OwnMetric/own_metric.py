"""A metric of one's own: 1 - exp(-d^2 / 2 sigma^2), averaged over the traced points."""
import numpy as np

import dentalscr as ds

SIGMA = 4.0


def exponential(fixed, moved):
    """From the tracing and the silhouette as it is tried, (N, 2) each, to the value and its derivatives by `moved`."""
    difference = moved[np.newaxis] - fixed[:, np.newaxis]
    squared = np.einsum("ijk,ijk->ij", difference, difference)
    nearest = squared.argmin(axis=1)
    rows = np.arange(len(fixed))
    weight = np.exp(-0.5 * squared[rows, nearest] / SIGMA**2)
    gradient = np.zeros_like(moved)
    np.add.at(gradient, nearest, (weight / (SIGMA**2 * len(fixed)))[:, np.newaxis] * difference[rows, nearest])
    return float(np.mean(1.0 - weight)), gradient


def main():
    # A phantom whose tracing is known; the true geometry projects its silhouette onto the tracing.
    phantom = ds.DentalPhantomCase(3, "Ideal", frame="Anatomical", makeRadiograph=False)
    upper = phantom.upper
    silhouette = ds.MeshSilhouetteContour(upper.mesh, upper.trueGeometry, numberOfPoints=2000)
    points = silhouette.points

    # From 20 px, 3 degrees and 4 % off.
    start = ds.Similarity2DTransform()
    start.SetCenter(points.mean(axis=0))
    start.SetScale(1.04)
    start.SetAngle(0.05)
    start.SetTranslation((16.0, 12.0))

    for name in ("chamfer", "own"):
        registration = ds.SilhouetteToContourRegistrationMethod()
        registration.SetPixelSpacing(upper.trueGeometry.GetPixelSpacing()[0])
        registration.SetInitialTransform(start)
        if name == "own":
            registration.SetMetricAsFunction(exponential)
        transform = registration.Execute(upper.tracing, silhouette)
        # The truth is the identity: how far are the silhouette's points moved?
        moved = transform.TransformPoints(points)
        print(f"{name} error px: {np.linalg.norm(moved - points, axis=1).mean()}")


if __name__ == "__main__":
    main()
