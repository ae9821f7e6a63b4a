"""Peers in Python. PEERS maps the name of a peer, as registered by a benchmark, to a function that reads the arrays in
a folder and returns what is timed."""
import numpy
from scipy import ndimage


def numpy_splats(folder):
    """Nearest pixels in an array of the default type, then the filter at its default reach of four standard deviations."""
    splats = numpy.load(folder / "splats.npy")
    sigma, width, height = numpy.load(folder / "frame.npy")[0]
    width, height = int(width), int(height)
    u, v, weight = splats.T.copy()

    def run():
        columns = numpy.rint(u).astype(numpy.intp)
        rows = numpy.rint(v).astype(numpy.intp)
        inside = (columns >= 0) & (columns < width) & (rows >= 0) & (rows < height)
        image = numpy.zeros((height, width))
        numpy.add.at(image, (rows[inside], columns[inside]), weight[inside])
        return ndimage.gaussian_filter(image, sigma, mode="constant")

    return run


PEERS = {
    "numpy add.at + gaussian_filter": numpy_splats,
}
