"""The same anatomy on both sides of the metric: same_anatomy.py folder [triangles]."""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

import dentalscr as ds

TOOTH, GINGIVA, OTHER = (0.93, 0.90, 0.82), (0.85, 0.58, 0.56), (0.45, 0.47, 0.50)
TAKEN, MISSED, OUTLINE = (0.95, 0.55, 0.10), (0.20, 0.40, 0.85), (0.05, 0.45, 0.75)


def draw(axes, mesh, places, depth, eye, colours):
    """A surface, far triangles first, with light from where the eye is."""
    corners = mesh.points[mesh.triangles].astype(float)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    light = np.abs(normals @ eye) / np.maximum(np.linalg.norm(normals, axis=1), 1e-12)
    order = np.argsort(depth[mesh.triangles].sum(axis=1))
    shades = (colours * (0.35 + 0.65 * light)[:, np.newaxis])[order]
    axes.add_collection(PolyCollection(places[mesh.triangles][order], facecolors=shades, edgecolors=shades, linewidths=0.1))
    axes.set_aspect("equal")
    axes.set_axis_off()


def draw_from_occlusal(axes, mesh, jaw, colours):
    """Anterior up, the patient's right on the left."""
    x, y, z = mesh.points.astype(float).T
    draw(axes, mesh, np.c_[y, x], -z if jaw == "upper" else z, np.array([0.0, 0.0, 1.0]), colours)
    axes.autoscale_view()


def parameters(triangles, base):
    drawn = ds.DentalPhantomParameters.Draw(7)
    drawn.frame = ds.PhantomFrame.Anatomical
    drawn.numberOfTriangles = triangles
    drawn.stoneBase = base
    drawn.SetMissingTeeth([45])
    return drawn


def main(folder, triangles=120000):
    phantom = ds.DentalPhantomMesh(parameters=parameters(triangles, base=True))
    frames = ds.UMidlineDentalAxis(phantom["upper"].mesh, phantom["lower"].mesh, refineMidline=True)
    # The same without a base for the outline: of a base, the front would stay as well.
    scan = ds.DentalPhantomMesh(parameters=parameters(triangles, base=False))
    scan_frames = ds.UMidlineDentalAxis(scan["upper"].mesh, scan["lower"].mesh, refineMidline=True)

    # Lateral radiograph of a head that is turned up by 8 degrees.
    geometry = ds.CephalometricGeometry(pixelSpacing=0.11, principalPoint=(170.0, 205.0))
    c, s = np.cos(0.14), np.sin(0.14)
    geometry.SetPose(np.array([[c, 0, s, 0], [0, 1, 0, 0], [-s, 0, c, 0]]))

    sides, side_axes = plt.subplots(1, 2, figsize=(9.2, 4))
    regions, region_axes = plt.subplots(1, 2, figsize=(9.2, 4))
    outline, axes = plt.subplots(figsize=(7, 4.3))
    for number, jaw in enumerate(("upper", "lower")):
        mesh = phantom[jaw].mesh
        side = ds.MidlineSideMeshFilter()
        side.SetSide("right")
        side.Execute(mesh, frames[2 + number])
        masks = []
        for use_labels in (False, True):
            crowns = ds.CrownRegionMeshFilter()
            crowns.SetJaw(jaw)
            crowns.SetUseLabels(use_labels)
            crowns.Execute(mesh, frames[2 + number])
            masks.append(crowns.GetTriangleMask() != 0)
        kept, (found, truth) = side.GetTriangleMask() != 0, masks
        print(f"{jaw} share of the right side: {kept.mean()}")
        print(f"{jaw} crowns as labelled: {(found == truth).mean()}")
        shade = np.where(truth[:, np.newaxis], TOOTH, GINGIVA)
        wrong = np.where(found[:, np.newaxis], TAKEN, MISSED)
        draw_from_occlusal(side_axes[number], mesh, jaw, np.where(kept[:, np.newaxis], shade, OTHER))
        draw_from_occlusal(region_axes[number], mesh, jaw, np.where((found == truth)[:, np.newaxis], shade, wrong))

        half = ds.MidlineSideMesh(scan[jaw].mesh, scan_frames[2 + number])
        open_outline = ds.OpenSilhouetteContourSource()
        open_outline.SetJaw(jaw)
        line = open_outline.Execute(half, geometry, scan_frames[2 + number])
        print(f"{jaw} open outline px: {line.GetLength()}")
        # The side as the X-rays see it, from the patient's right.
        teeth = (half.labels[half.triangles[:, 0]] != 0)[:, np.newaxis]
        places = geometry.ProjectPoints(half.points)
        draw(axes, half, places, -half.points[:, 1], np.array([0.0, 1.0, 0.0]), np.where(teeth, TOOTH, GINGIVA))
        for polyline in ds.MeshSilhouetteContour(half, geometry).polylines:
            axes.plot(*np.vstack([polyline.points, polyline.points[:1]]).T, color=OTHER, linewidth=0.7)
        for polyline in line.polylines:
            axes.plot(*polyline.points.T, color=OUTLINE, linewidth=2)
        points, normals = line.points[12::24], open_outline.GetNormals()[12::24]
        axes.quiver(*points.T, *normals.T, color=OUTLINE, angles="xy", scale_units="xy", scale=0.1, width=0.002)
    axes.invert_yaxis()
    for figure, name in ((sides, "midline-side"), (regions, "crown-region"), (outline, "open-silhouette")):
        figure.savefig(folder / f"{name}.png", dpi=100, bbox_inches="tight")
        print(folder / f"{name}.png")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "."), *map(int, sys.argv[2:]))
