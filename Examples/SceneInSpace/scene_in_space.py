"""A registered case in space: scene_in_space.py case.json folder.

The parts come as arrays, and as vtk or pyvista objects where these are installed. Writes scene.vtp, and with pyvista the
picture scene.png, which needs a screen (or xvfb-run) with VTK before 9.4.
"""
import pathlib
import sys

import numpy as np

import dentalscr as ds


def largest_bend(rays):
    """How far apart the ray through a landmark and the landmark's image are, on the detector, mm."""
    source, on_scan, end = (rays.points[i::3].astype(float) for i in range(3))
    to_scan, to_end = on_scan - source, end - source
    return np.max(np.linalg.norm(np.cross(to_scan, to_end), axis=1) / np.linalg.norm(to_scan, axis=1))


def draw(blocks, file):
    """With pyvista: each block has its colour with it, and the radiograph is an image in its place."""
    import pyvista

    plotter = pyvista.Plotter(off_screen=True, window_size=(1200, 900))
    for name, block in zip(blocks.keys(), blocks):
        if name.endswith(" radiograph"):
            plotter.add_mesh(block, cmap="gray", show_scalar_bar=False, lighting=False)
        elif not name.endswith(" detector"):
            *color, opacity = block.field_data["Color"][0]
            plotter.add_mesh(block, color=color, opacity=opacity, line_width=3)
    plotter.camera_position = [(500, -700, 250), (20, 40, -30), (0, 0, 1)]
    plotter.screenshot(file)


def main(case_file, folder):
    result = ds.register(case_file)

    # 1. The scene: named parts in the cephalostat frame, as arrays.
    parts = {part.name: part for part in result.scene("arrays")}
    print(f"parts: {len(parts)}")
    source, _ = parts["lateral central ray"].points
    print(f"source mm: {source[1]}")
    print(f"largest bend of a ray mm: {largest_bend(parts['lateral upper rays'])}")
    print(f"triangles: {len(parts['upper scan'].triangles)}")

    # 2. The same as blocks of VTK or PyVista.
    try:
        blocks = result.scene("pyvista")
    except ds.ArgumentError as problem:
        print(problem, file=sys.stderr)
        return
    blocks["upper scan"].save(folder / "scene.vtp")
    if "--picture" in sys.argv:
        draw(blocks, folder / "scene.png")


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]))
