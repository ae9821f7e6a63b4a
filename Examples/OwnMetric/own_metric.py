"""A metric of one's own joins the sum that PoseRegistrationMethod minimizes: the incisal edge of the upper scan lies on a
horizontal plane of the cephalostat whose height somebody has measured, as far as that measurement goes."""
import dentalscr as ds


class PlaneMetric(ds.LeastSquaresMetric):
    """One residual: (z of a point under the pose - height of the plane) / sigma, in the cephalostat frame."""

    def __init__(self, point, height, sigma):
        super().__init__()
        # The point is in the dental frame that the pose is of, mm.
        self.point, self.height, self.sigma = point, height, sigma

    def blocks(self):
        return ["pose"]

    def residuals(self, values):
        # The pose is pitch, roll, yaw, tx, ty, tz; the seventh parameter, the scale, is not of this block.
        pose = ds.CephalometricPoseTransform(parameters=[*values["pose"], 0.0])
        return [(pose.GetRigidTransform().TransformPoint(self.point)[2] - self.height) / self.sigma]


def main():
    # A simulated case with a known answer.
    phantom = ds.DentalPhantomCase(8, makeRadiograph=False)
    upper = phantom.upper
    axis = ds.UMidlineDentalAxisFilter()
    axis.RefineMidlineOn()
    frames = axis.Execute(upper.mesh)
    registration = ds.PoseRegistrationMethod()
    registration.SetFrames(frames)

    # The plane goes through the place where the incisal edge truly is, and is known to a tenth of a millimetre.
    edge = axis.GetIncisalEdge("upper")
    height = upper.trueGeometry.TransformToCephalostat(edge)[2]
    plane = PlaneMetric(frames.upperTransform.TransformPoint(edge), height, 0.1)

    for name in ("without", "with"):
        if name == "with":
            registration.AddMetric(plane)
        solution = registration.Execute(phantom.geometry, upper.mesh, upper.tracing)
        parameters = ("pitch rad", "roll rad", "yaw rad", "tx mm", "ty mm", "tz mm", "kappa")
        for parameter, value in zip(parameters, solution.GetPose("upper")):
            print(f"{name} {parameter}: {value}")
        placed = solution.GetTransform("upper").TransformPoint(edge)
        print(f"{name} edge to plane mm: {abs(placed[2] - height)}")


if __name__ == "__main__":
    main()
