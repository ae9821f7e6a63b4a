"""The paper's chain in ten lines: registration_pipeline.py upper.stl contours.json pixelSpacing_mm."""
import sys

import dentalscr as ds


def main(upper, contours, spacing):
    geometry = ds.CephalometricGeometry()
    geometry.SetPixelSpacing((spacing, spacing))
    axes = ds.UMidlineDentalAxis(upper=ds.ReadMesh(upper))
    drr = ds.SurfaceDRR(axes.upper, geometry)
    silhouette = ds.SilhouetteContour(drr, level="Absolute", levelValue=0.5)  # half a shell
    moving = ds.ContourResample(silhouette, numberOfPoints=441)
    tracing = ds.ReadContours(contours).upper

    registration = ds.SilhouetteToContourRegistrationMethod()
    registration.AddCommand(
        ds.sitkMultiResolutionIterationEvent,
        lambda: print("level", registration.GetCurrentLevel(), file=sys.stderr),
    )
    transform = registration.Execute(tracing, moving)
    print(f"scale: {transform.GetScale()}")
    print(f"angle: {transform.GetAngle()}")
    print(f"translation u: {transform.GetTranslation()[0]}")
    print(f"translation v: {transform.GetTranslation()[1]}")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], float(sys.argv[3]))
