"""Preset "robust" of the program, step by step: scans and tracing in, pose, verdict, landmarks and a picture out. The
numbers are those of ds.register() and of "dentalscr register", to the last bit."""
import pathlib
import sys

import dentalscr as ds


def robust_by_hand(upper_file, lower_file, contours_file, landmarks_file, geometry):
    upper, lower = ds.ReadMesh(upper_file), ds.ReadMesh(lower_file)
    tracing = ds.ReadContours(contours_file)
    # The frames of the teeth: one of each jaw, and one of both where they are in occlusion.
    frames = ds.UMidlineDentalAxis(upper, lower, refineMidline=True, transformMeshes=False)
    solution = ds.PoseRegistration(geometry, upper, tracing.upper, lower, tracing.lower, frames=frames)
    landmarks = ds.LandmarkProjection(solution, ds.ReadLandmarks(landmarks_file))
    return tracing, solution, ds.RegistrationVerdict(solution), landmarks


def main(upper, lower, contours, landmarks, image, spacing, u, v, picture):
    # The patient faces right and the source is on the right unless said otherwise.
    geometry = ds.CephalometricGeometry(pixelSpacing=float(spacing), principalPoint=(float(u), float(v)))
    tracing, solution, verdict, placed = robust_by_hand(upper, lower, contours, landmarks, geometry)
    overlay = ds.RegistrationOverlay(
        image, tracing.upper, {"outline of the upper scan": solution.GetMovingContour("upper")}, placed.positions,
        status=verdict.upper.status, pixelSpacing=geometry.GetPixelSpacing(),
    )
    pathlib.Path(picture).write_bytes(overlay._repr_png_())
    for jaw in ("upper", "lower"):
        found = getattr(verdict, jaw)
        print(f"{jaw} verdict: {found.status}")
        for finding in found.findings:
            print(f"{jaw} reason: {finding.code}, {finding.text}")
    for name, (u, v) in placed.positions.items():
        print(f"{name} u: {u}\n{name} v: {v}\n{name} sigma px: {placed.sigmas[name]}")


if __name__ == "__main__":
    main(*sys.argv[1:])
