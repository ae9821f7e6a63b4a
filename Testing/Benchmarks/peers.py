"""Peers in Python. PEERS maps the name of a peer, as registered by a benchmark, to a function that reads the arrays in
a folder and returns what is timed."""
import numpy
from scipy import ndimage, spatial


def numpy_splats(folder):
    """From points and areas, as ours: projection, nearest pixels in an array of the default type, then the filter at its
    default reach of four standard deviations."""
    x, y, z, area = numpy.load(folder / "points.npy").T.copy()
    m = numpy.load(folder / "projection.npy")
    sigma, width, height, u0, v0, slope, magnification = numpy.load(folder / "frame.npy")[0]
    width, height = int(width), int(height)

    def run():
        u, v, depth = (row[0] * x + row[1] * y + row[2] * z + row[3] for row in m)
        u = u / depth
        v = v / depth
        obliquity = numpy.sqrt(1.0 + ((u - u0) * slope) ** 2 + ((v - v0) * slope) ** 2)
        weight = area * (magnification / depth) ** 2 * obliquity / sigma**2
        columns = numpy.rint(u).astype(numpy.intp)
        rows = numpy.rint(v).astype(numpy.intp)
        inside = (columns >= 0) & (columns < width) & (rows >= 0) & (rows < height)
        image = numpy.zeros((height, width))
        numpy.add.at(image, (rows[inside], columns[inside]), weight[inside])
        return ndimage.gaussian_filter(image, sigma, mode="constant")

    return run


def scipy_trees(folder):
    """Symmetric Chamfer value and gradient; neither tree moves, fixed points are mapped by the inverse similarity."""
    fixed, moving = numpy.load(folder / "fixed.npy"), numpy.load(folder / "moving.npy")
    poses = numpy.load(folder / "poses.npy")
    fixed_tree, moving_tree = spatial.cKDTree(fixed), spatial.cKDTree(moving)

    def add(rotated, difference, scale, gradient):
        distance = numpy.sqrt((difference * difference).sum(1))
        normal = difference / numpy.maximum(distance, 1e-300)[:, None]
        gradient[0] += (normal * rotated).sum(1).mean() / scale
        gradient[1] += (normal[:, 1] * rotated[:, 0] - normal[:, 0] * rotated[:, 1]).mean()
        gradient[2:] += normal.mean(0)
        return distance.mean()

    def run():
        for scale, angle, tx, ty in poses:
            shift = numpy.array((tx, ty))
            rotation = numpy.array(((numpy.cos(angle), -numpy.sin(angle)), (numpy.sin(angle), numpy.cos(angle))))
            gradient = numpy.zeros(4)
            rotated = scale * moving @ rotation.T
            mapped = rotated + shift
            value = add(rotated, mapped - fixed[fixed_tree.query(mapped)[1]], scale, gradient)
            back = (fixed - shift) @ rotation / scale
            rotated = scale * moving[moving_tree.query(back)[1]] @ rotation.T
            value += add(rotated, rotated + shift - fixed, scale, gradient)
        return value, gradient

    return run


PEERS = {
    "scipy cKDTree": scipy_trees,
    "numpy projection + add.at + gaussian_filter": numpy_splats,
}
