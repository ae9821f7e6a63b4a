"""A NIfTI-1 file, written without any library."""
import gzip
import struct

# Letters of struct: the header's number of the type.
TYPES = {"B": 2, "h": 4, "i": 8, "f": 16, "d": 64, "b": 256, "H": 512, "I": 768, "q": 1024, "Q": 1280}
# As ITK writes a picture: columns run to the patient's left, rows to the back.
PICTURE = ((-1, 0, 0, 0), (0, -1, 0, 0), (0, 0, 1, 0))


def nifti(rows, kind="B", order="<", affine=PICTURE, code=1, slices=1, spacing=(1, 1), slope=1, intercept=0, packed=False):
    """The file's bytes; of several slices each is the same."""
    width, height = len(rows[0]), len(rows)
    pixels = b"".join(struct.pack(f"{order}{width}{kind}", *row) for row in rows) * slices
    header = struct.pack(order + "i36x", 348)
    header += struct.pack(order + "8h14x", 3, width, height, slices, 1, 1, 1, 1)
    header += struct.pack(order + "hhh", TYPES[kind], 8 * struct.calcsize("=" + kind), 0)
    header += struct.pack(order + "8f", 1, *spacing, 1, 0, 0, 0, 0)
    header += struct.pack(order + "fff3xB128x", 352, slope, intercept, 10)
    header += struct.pack(order + "hh24x", 0, code)
    header += b"".join(struct.pack(order + "4f", *row) for row in affine)
    header += bytes(16) + b"n+1\0" + bytes(4)
    assert len(header) == 352
    content = header + pixels
    # With a time of its own each file would be another one.
    return gzip.compress(content, mtime=0) if packed else content
