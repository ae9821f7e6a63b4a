"""Three optimizers on one registration, and observers: optimizer_and_observer.py convergence.csv [convergence.png]."""
import csv
import sys

import dentalscr as ds


class Patience(ds.Command):
    """Ends a registration when the metric's value hardly falls any more."""

    def __init__(self, registration):
        super().__init__()
        self.registration = registration
        self.best = float("inf")
        self.waited = 0

    def Execute(self):
        value = self.registration.GetMetricValue()
        self.waited = 0 if value < self.best - 1e-3 else self.waited + 1
        self.best = min(self.best, value)
        if self.waited > 400:
            self.registration.Abort()


def main(table, picture=None):
    phantom = ds.DentalPhantomCase(3, "Ideal", frame="Anatomical", makeRadiograph=False)
    silhouette = ds.MeshSilhouetteContour(phantom.upper.mesh, phantom.geometry, numberOfPoints=441)
    rows = []
    for name in ("LBFGSB", "Amoeba", "OnePlusOne"):
        registration = ds.SilhouetteToContourRegistrationMethod()
        if name == "Amoeba":
            registration.SetOptimizerAsAmoeba()
        elif name == "OnePlusOne":
            registration.SetOptimizerAsOnePlusOneEvolutionary()
        mine = []
        registration.AddCommand(
            ds.sitkIterationEvent,
            lambda: mine.append((name, registration.GetCurrentLevel(), len(mine), registration.GetMetricValue())),
        )
        registration.AddCommand(ds.sitkIterationEvent, Patience(registration))
        try:
            registration.Execute(phantom.upper.tracing, silhouette)
        except ds.AbortedError:
            pass  # our observer ended it
        print(f"{name} metric px: {min(row[3] for row in mine)}")
        print(f"{name}: {len(mine)} steps, {registration.GetOptimizerStopConditionDescription()}", file=sys.stderr)
        rows += mine
    with open(table, "w", newline="") as file:
        csv.writer(file).writerows([("optimizer", "level", "step", "value"), *rows])
    if picture:
        from plot import plot

        plot(rows, picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
