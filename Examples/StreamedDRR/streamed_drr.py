"""A simulated radiograph larger than memory, strip by strip: streamed_drr.py pixelSpacing_mm strips drr.mha."""
import sys

import numpy as np

import dentalscr as ds


def make_source():
    source = ds.SurfaceDRRImageSource()
    source.SetOutputMode("InvertedIntensity")
    source.SetSourceIntensity(255.0)
    return source


def main(spacing, strips, file_name):
    mesh = ds.DentalPhantomMesh()["upper"].mesh
    geometry = ds.CephalometricGeometry()
    geometry.SetPixelSpacing((spacing, spacing))

    # A strip is written before the next is made: MetaImage is a text header and the rows. File and memory hold a byte a pixel.
    source = make_source()
    raw = file_name.removesuffix(".mha") + ".raw"
    largest = rows = 0
    with open(raw, "wb") as file:
        for strip in source.ExecuteInStrips(mesh, geometry, strips):
            pixels = np.rint(np.asarray(strip)).astype(np.uint8)
            file.write(pixels.tobytes())
            largest = max(largest, pixels.size)
            rows += len(pixels)
            width = pixels.shape[1]
    header = {
        "ObjectType": "Image", "NDims": 2, "DimSize": f"{width} {rows}", "ElementSpacing": f"{spacing} {spacing}",
        "ElementType": "MET_UCHAR", "ElementDataFile": "LOCAL",
    }
    with open(file_name, "wb") as file, open(raw, "rb") as data:
        file.write("".join(f"{key} = {value}\n" for key, value in header.items()).encode())
        while block := data.read(1 << 24):
            file.write(block)
    print(f"megapixels: {1e-6 * rows * width}")
    print(f"largest part in memory: {largest / (rows * width)}")
    print(f"projections of the mesh: {source.GetNumberOfProjections()}")

    # Another number of strips: the same bits.
    written = np.memmap(raw, np.uint8, "r", shape=(rows, width))
    different = first = 0
    for strip in make_source().ExecuteInStrips(mesh, geometry, 7):
        pixels = np.rint(np.asarray(strip)).astype(np.uint8)
        different += int(np.count_nonzero(pixels != written[first : first + len(pixels)]))
        first += len(pixels)
    print(f"different pixels: {different}")


if __name__ == "__main__":
    main(float(sys.argv[1]), int(sys.argv[2]), sys.argv[3])
