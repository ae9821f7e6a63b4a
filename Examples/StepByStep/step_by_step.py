"""Each step of the chain alone, with its picture: step_by_step.py case.json folder."""
import copy
import pathlib
import sys

import numpy as np

import dentalscr as ds


def move(contour, transform):
    polylines = contour.polylines
    return ds.Contour([ds.Polyline(transform.TransformPoints(p.points), closed=p.closed) for p in polylines])


def write(picture, path):
    path.write_bytes(picture._repr_png_())


def radiograph(mesh, geometry):
    return ds.SurfaceDRR(mesh, geometry, margin=5.0, outputMode="InvertedIntensity", sourceIntensity=255.0)


def main(case_file, folder):
    # 0. What a case holds: scans in mm, tracing in pixels, radiograph, geometry.
    case = ds.ReadCase(case_file)

    # 1. The anatomical frame. Its axes as rods, to look at, from a source far above: z becomes y.
    axis = ds.UMidlineDentalAxisFilter()
    axis.EmbedAxesOn()
    axis.SetAxesLength(25.0)
    from_above = ds.CephalometricGeometry()
    from_above.SetPixelSpacing(case.geometry.GetPixelSpacing())
    from_above.SetPose(np.array([[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0]], float))
    write(radiograph(axis.Execute(case.upper).upper, from_above), folder / "1-axes.png")
    print(f"arch width mm: {axis.GetArchWidth('Upper')}")

    # 2. The simulated lateral radiograph: central ray through the origin of the frame.
    axis.EmbedAxesOff()
    upper = axis.Execute(case.upper).upper
    write(radiograph(upper, case.geometry), folder / "2-radiograph.png")

    # 3. The contour: from the thickness at half a shell as the paper does, and exactly from the mesh.
    nominal = copy.deepcopy(case.geometry)
    nominal.SetPrincipalPoint((0, 0))
    drr = ds.SurfaceDRR(upper, nominal)
    moving = ds.ContourResample(ds.SilhouetteContour(drr, level="Absolute", levelValue=0.5), numberOfPoints=441)
    exact = ds.MeshSilhouetteContour(upper, nominal)
    label = "at half a shell of the radiograph"
    write(ds.RegistrationOverlay(fixed=exact, moving={label: moving}, title="Contours"), folder / "3-contour.png")
    print(f"contour length px: {moving.GetLength()}")
    print(f"exact contour length px: {exact.GetLength()}")

    # 4. The registration, and where it put the contour.
    registration = ds.SilhouetteToContourRegistrationMethod()
    registration.SetPixelSpacing(case.geometry.GetPixelSpacing()[0])
    transform = registration.Execute(case.upperContour, moving)
    moved = move(moving, transform)
    picture = ds.RegistrationOverlay(case.image, case.upperContour, {"aligned contour": moved}, title="Registration")
    write(picture, folder / "4-registration.png")
    print(f"scale: {transform.GetScale()}")
    print(f"metric px: {registration.GetMetricValue()}")


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]))
