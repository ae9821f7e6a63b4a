"""Images made to break their decoders: an error in words, within seconds and 1 GB, whatever the decoder does. Those that
need one run it in a process of its own (dentalscr-decode, Documentation/Robustness.md)."""
import gzip
import io
import os
import random
import resource
import shutil
import struct
import subprocess
import zlib

import pytest

from dicom_file import dicom
from jpeg_file import progressive
from nifti_file import nifti
from png_file import png as grey_png
from program_faults import measure


def bitmap(compression=1, bits=8, width=64, height=64, data=b""):
    offset = 54 + 1024
    palette = b"".join(bytes((i, i, i, 0)) for i in range(256))
    head = b"BM" + struct.pack("<IHHI", offset + len(data), 0, 0, offset)
    info = struct.pack("<IiiHHIIiiII", 40, width, height, 1, bits, compression, len(data), 2835, 2835, 256, 0)
    return head + info + palette + data


def png(width, height, rows=None):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    packer = zlib.compressobj(9)
    data = b""
    for _ in range(height if rows is None else rows):
        data += packer.compress(bytes(width + 1))
    data += packer.flush()
    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def tiff(width, height, coding, data):
    """Grey, of 8 bits, in one strip."""
    entries = ((256, 4, width), (257, 4, height), (258, 3, 8), (259, 3, coding), (262, 3, 1), (273, 4, 122), (277, 3, 1), (278, 4, height), (279, 4, len(data)))
    directory = b"".join(struct.pack("<HHII", tag, kind, 1, value) for tag, kind, value in entries)
    return struct.pack("<2sHIH", b"II", 42, 8, len(entries)) + directory + bytes(4) + data


def tiles(width, height, side, coding, data):
    """Grey, of 8 bits, in square tiles that all have the same bytes."""
    count = -(-width // side) * -(-height // side)
    offsets, lengths = 8 + len(data), 8 + len(data) + 4 * count
    entries = ((256, width), (257, height), (258, 8), (259, coding), (262, 1), (277, 1), (322, side), (323, side))
    entries = [struct.pack("<HHII", tag, 4, 1, value) for tag, value in entries]
    entries += [struct.pack("<HHII", tag, 4, count, at) for tag, at in ((324, offsets), (325, lengths))]
    lists = struct.pack(f"<{count}I", *[8] * count) + struct.pack(f"<{count}I", *[len(data)] * count)
    directory = struct.pack("<H", len(entries)) + b"".join(entries) + bytes(4)
    return struct.pack("<2sHI", b"II", 42, 8 + len(data) + len(lists)) + data + lists + directory


def jpeg2000(width, height):
    image = pytest.importorskip("PIL.Image")
    stream = io.BytesIO()
    image.new("L", (width, height), 77).save(stream, "JPEG2000", no_jp2=True)
    return stream.getvalue()


def put_size(content, *size):
    """A NIfTI with another size in its header."""
    return content[:42] + struct.pack("<3h", *size) + content[48:]


J2K = b"1.2.840.10008.1.2.4.90"

# From bytes to a file's name, and whether the file is refused.
HOSTILE = {
    "RLE8 that writes behind its row": ("a.bmp", lambda: bitmap(data=b"\xff\x07" * 400)),
    "RLE8 that jumps out": ("a.bmp", lambda: bitmap(data=b"\x00\x02\xff\xff" * 400 + b"\x00\xff" + b"\x07" * 300)),
    "RLE8 without an end": ("a.bmp", lambda: bitmap(data=b"\x00\xfe")),
    "BMP of 2 billion pixels": ("a.bmp", lambda: bitmap(compression=0, width=46000, height=46000, data=bytes(100))),
    "NRRD with a long header word": ("a.nrrd", lambda: b"NRRD0004\ntype: " + b"x" * 100000 + b"\ndimension: 2\n\n"),
    "NRRD with a long kind": (
        "a.nrrd",
        lambda: b"NRRD0004\ntype: uint8\ndimension: 2\nsizes: 9 9\nkinds: " + b"k" * 5000 + b" x\nencoding: raw\n\n" + bytes(81),
    ),
    "NRRD of a petabyte": ("a.nrrd", lambda: b"NRRD0004\ntype: double\ndimension: 2\nsizes: 9000000 9000000\nencoding: gzip\n\nx"),
    "NRRD bomb": (
        "a.nrrd",
        lambda: b"NRRD0004\ntype: double\ndimension: 3\nsizes: 8192 8192 8\nencoding: gzip\nendian: little\n\n"
        + zlib.compressobj(9, zlib.DEFLATED, 31).compress(bytes(1 << 20)),
    ),
    "DICOM with bytes behind the pixels": ("a.dcm", lambda: dicom(8, 8, bytes(64), behind=b"\xfe\xff\x0d\xe0\xff\xff\xff\x7f" * 9)),
    "DICOM of JPEG 2000 larger than it says": ("a.dcm", lambda: dicom(8, 8, jpeg2000(2000, 2000), J2K)),
    "DICOM of JPEG 2000 that takes gigabytes": (
        "a.dcm",
        # The size in its header, and nothing that would fill it.
        lambda: dicom(65535, 1000, (lambda j: j[:8] + struct.pack(">II", 60000, 60000) + j[16:24] + struct.pack(">II", 60000, 60000) + j[32:])(jpeg2000(64, 64)), J2K),
    ),
    "two bytes": ("a.jpg", lambda: b"\xff\xd8"),
    "JPEG signature": ("a.jpg", lambda: b"\xff\xd8\xff"),
    # Without a bound a minute for each 0.4 MB.
    "JPEG of a thousand scans": ("a.jpg", lambda: progressive(11000, 11000, 1000)),
    "JPEG of 4 colours in steps": ("a.jpg", lambda: progressive(16384, 8192, 1, colours=4)),
    "PNG signature": ("a.png", lambda: b"\x89PNG\r\n\x1a\n"),
    "PNG of 30000 x 30000": ("a.png", lambda: png(30000, 30000, 200)),
    "TIFF of nothing": ("a.tif", lambda: b"II*\0\x08\0\0\0\0\0"),
    "TIFF of a rare codec": ("a.tif", lambda: tiff(50, 50, 34712, bytes(2500))),
    # Minutes, of 5 MB: each tile is a megabyte of codes for nothing, and the same one.
    "TIFF of tiles that share their bytes": ("a.tif", lambda: tiles(16384, 8192, 16, 32773, b"\x80" * 1000000 + b"\x81\0" * 2)),
    "TIFF in the corner of a tile": ("a.tif", lambda: tiles(1024, 1024, 20480, 8, zlib.compress(bytes(20480 * 20480)))),
    "MetaImage that names another's file": (
        "a.mha",
        lambda: b"ObjectType = Image\nNDims = 2\nDimSize = 8 8\nElementType = MET_UCHAR\nElementDataFile = ../../../../etc/passwd\n",
    ),
    "MetaImage that names a file of the root": (
        "a.mhd",
        lambda: b"ObjectType = Image\nNDims = 2\nDimSize = 8 8\nElementType = MET_UCHAR\nElementDataFile = /etc/passwd\n",
    ),
    "NRRD that names another's file": (
        "a.nhdr",
        lambda: b"NRRD0004\ntype: uint8\ndimension: 2\nsizes: 8 8\nencoding: raw\ndata file: /etc/passwd\n\n",
    ),
    "NIfTI bomb": ("a.nii.gz", lambda: gzip.compress(nifti([[0] * 8] * 8) + bytes(1 << 29), 9)),
    # Each of a million parts cleared a megabyte.
    "NIfTI of parts without a byte": ("a.nii.gz", lambda: gzip.compress(put_size(nifti([[0] * 8] * 8), 8000, 8000, 1)) + gzip.compress(b"") * 1000000),
    "NIfTI of many slices": ("a.nii.gz", lambda: gzip.compress(put_size(nifti([[0] * 8] * 8), 32767, 32767, 32767), 9)),
    "NIfTI of a gigabyte": ("a.nii", lambda: put_size(nifti([[0] * 8] * 8), 32767, 32767, 1)),
    "NIfTI of more than is read": ("a.nii.gz", lambda: gzip.compress(put_size(nifti([[0] * 8] * 8, "d"), 10000, 10000, 1), 9)),
    "NRRD that lists files": (
        "a.nhdr",
        lambda: b"NRRD0004\ntype: uint8\ndimension: 2\nsizes: 8 8\nencoding: raw\ndata file: LIST\n/etc/passwd\n\n",
    ),
}


def limit():
    # Of the program and of its decoder each. Two and a half GiB of addresses are far less than 1 GB of memory in use.
    resource.setrlimit(resource.RLIMIT_AS, (5 << 29, 5 << 29))


@pytest.fixture
def read(program, is_sanitized):
    """Runs the program where an image may use so much and no more."""

    def call(*arguments):
        # The sanitizer keeps its books in terabytes of addresses, and its memory several times.
        done = measure([program, *arguments, "--quiet"], preexec_fn=None if is_sanitized else limit)
        assert done.seconds < (300 if is_sanitized else 30)
        assert is_sanitized or done.kibibytes < 1 << 20, f"{done.kibibytes} KiB"
        return done

    return call


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_image_is_an_error(read, is_sanitized, case, tmp_path, name):
    file_name, make = HOSTILE[name]
    image = case.folder / file_name
    image.write_bytes(make())
    case.change(cephalogram=dict(case.load()["cephalogram"], image=file_name))
    for arguments in (
        ("register", case.file, "--output", tmp_path / "out"),
        ("contour", "--labels", image, "--output", tmp_path / "out"),
    ):
        done = read(*arguments)
        # What a decoder makes a picture of all the same is a picture, of the wrong size for this case and without a label.
        assert done.returncode == 2, (done.returncode, done.stderr)
        # A decoder that writes behind its buffer ends by it; not in the sanitizer's heap, where nothing stands behind a buffer.
        pictures = ("the image is 8 x 8", "the image is 64 x 64") if is_sanitized else ("the image is 8 x 8",)
        assert file_name in done.stderr or any(picture in done.stderr for picture in pictures), done.stderr


def test_scans_of_a_jpeg_are_counted(read, tmp_path, case):
    """As many as pictures have are read; one more than the bound is an error that says what is too many."""
    for scans, words in ((63, "the image is 80 x 80"), (64, "more than 64 scans")):
        (case.folder / "a.jpg").write_bytes(progressive(80, 80, scans))
        case.change(cephalogram=dict(case.load()["cephalogram"], image="a.jpg"))
        done = read("register", case.file, "--output", tmp_path / "out")
        assert done.returncode == 2 and words in done.stderr, done.stderr


def test_what_is_no_pixel_of_a_png_is_not_looked_at(read, tmp_path):
    """Libpng prints the name of a profile as it is, and unpacks megabytes of each of many texts."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    whole = grey_png([[11 if 10 < x < 40 and 10 < y < 40 else 0 for x in range(50)] for y in range(50)])
    outlines = []
    text = chunk(b"zTXt", b"Comment\0\0" + zlib.compress(bytes(1 << 26), 9))
    profile = chunk(b"iCCP", b"\x1b]0;mine\x07\0\0" + zlib.compress(bytes(5)))
    # Of these, too, libpng prints what it thinks: 100,000 lines of the same.
    spacing = chunk(b"pHYs", bytes(9)) * 100000
    for name, more in {"plain": b"", "talk": chunk(b"PLTE", bytes(9)) + spacing + chunk(b"tRNS", b"\xff\xff"), "odd": profile + chunk(b"tRNS", b"\0") + text * 40 + chunk(b"tRNS", b"\0\x0b") * 1000}.items():
        image = tmp_path / f"{name}.png"
        image.write_bytes(whole[:33] + more + whole[33:])
        done = read("contour", "--labels", image, "--output", tmp_path / f"{name}.json")
        assert done.returncode == 0 and done.stderr == "", done.stderr
        outlines.append((tmp_path / f"{name}.json").read_text().replace(name, ""))
    assert outlines[0] == outlines[1] == outlines[2]
    # A chunk longer than all pixels; and what stands behind them.
    for name, data, code in (("long", zlib.compress(bytes(51 * 50)) + bytes(9000000), 2), ("late", whole[41:-16], 0)):
        content = whole[:33] + chunk(b"IDAT", data) + spacing + chunk(b"tRNS", b"\0\x0b") + chunk(b"IEND", b"")
        (tmp_path / "a.png").write_bytes(content)
        done = read("contour", "--labels", tmp_path / "a.png", "--output", tmp_path / f"{name}.json")
        assert done.returncode == code and done.stderr.count("\n") == code // 2 and "libpng" not in done.stderr, done.stderr


def test_a_tiff_of_a_usual_codec_is_read(read, tmp_path):
    """By the decoder's process, as all others are."""
    rows = bytes(11 if 10 < x < 40 and 10 < y < 40 else 0 for y in range(50) for x in range(50))
    # Rows as they are: 50 bytes, with a number before them that says so.
    packed = b"".join(b"\x31" + rows[i : i + 50] for i in range(0, len(rows), 50))
    for coding, data in ((1, rows), (8, zlib.compress(rows)), (32946, zlib.compress(rows)), (32773, packed)):
        (tmp_path / "a.tif").write_bytes(tiff(50, 50, coding, data))
        done = read("contour", "--labels", tmp_path / "a.tif", "--output", tmp_path / "out.json")
        assert done.returncode == 0, (coding, done.stderr)


def test_a_pipe_beside_a_header_is_not_waited_for(read, case, tmp_path):
    os.mkfifo(case.folder / "a.raw")
    for file_name, header in {
        "a.mhd": b"ObjectType = Image\nNDims = 2\nDimSize = 8 8\nElementType = MET_UCHAR\nElementDataFile = a.raw\n",
        "a.nhdr": b"NRRD0004\ntype: uint8\ndimension: 2\nsizes: 8 8\nencoding: raw\ndata file: a.raw\n\n",
    }.items():
        (case.folder / file_name).write_bytes(header)
        done = read("contour", "--labels", case.folder / file_name, "--output", tmp_path / "out")
        assert done.returncode == 2 and "a.raw" in done.stderr, done.stderr


def test_detached_pixels_beside_their_header_are_read(read, tmp_path):
    labels = bytes(11 if 10 < x < 40 and 10 < y < 40 else 0 for y in range(50) for x in range(50))
    (tmp_path / "a.raw").write_bytes(labels)
    (tmp_path / "a.mhd").write_bytes(
        b"ObjectType = Image\nNDims = 2\nBinaryData = True\nDimSize = 50 50\nElementType = MET_UCHAR\nElementDataFile = a.raw\n"
    )
    (tmp_path / "a.nhdr").write_bytes(
        b"NRRD0004\ntype: uint8\ndimension: 2\nsizes: 50 50\nencoding: raw\ndata file: a.raw\n\n"
    )
    for name in ("a.mhd", "a.nhdr"):
        done = read("contour", "--labels", tmp_path / name, "--output", tmp_path / (name + ".json"))
        assert done.returncode == 0, done.stderr


def seeds():
    nrrd = b"NRRD0004\ntype: uint8\ndimension: 2\nsizes: 32 32\nencoding: raw\n\n" + bytes(range(256)) * 4
    mha = b"ObjectType = Image\nNDims = 2\nBinaryData = True\nDimSize = 32 32\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + bytes(range(256)) * 4
    found = {
        "a.nrrd": nrrd,
        "a.mha": mha,
        "a.dcm": dicom(32, 32, bytes(range(256)) * 4),
        "a.bmp": bitmap(compression=1, width=32, height=32, data=(b"\x20\x07\x00\x00" * 32) + b"\x00\x01"),
        "a.nii": nifti([range(32 * row % 256, 32 * row % 256 + 32) for row in range(32)]),
        "a.nii.gz": nifti([range(32 * row % 256, 32 * row % 256 + 32) for row in range(32)], "h", packed=True),
        "b.bmp": bitmap(compression=0, width=32, height=32, data=bytes(range(256)) * 4),
    }
    return found


def test_mutants_of_images_never_end_the_program(read, tmp_path):
    """A few of each kind; Utilities/fuzz.sh has as many as there is time for."""
    random.seed(20)
    for name, data in seeds().items():
        for k in range(12):
            mutant = bytearray(data)
            for _ in range(random.choice((1, 3, 20))):
                mutant[random.randrange(len(mutant) if k % 2 else min(len(mutant), 400))] = random.randrange(256)
            if k % 5 == 4:
                del mutant[random.randrange(len(mutant)) :]
            image = tmp_path / name
            image.write_bytes(mutant)
            done = read("contour", "--labels", image, "--output", tmp_path / "out.json")
            assert done.returncode in (0, 2), (name, k, done.returncode, done.stderr)


def test_a_missing_decoder_is_told(run, program, build_dir, tmp_path):
    """Nothing is decoded in the program itself when its decoder is missing. It is looked for beside the program and the
    libraries: in a copy of them that has none, as other tests use that of the build."""
    image = tmp_path / "a.bmp"
    image.write_bytes(seeds()["b.bmp"])
    copy = tmp_path / "copy"
    (copy / "bin").mkdir(parents=True)
    shutil.copy(program, copy / "bin")
    if (build_dir / "lib").is_dir():
        shutil.copytree(build_dir / "lib", copy / "lib", symlinks=True)
    command = [copy / "bin" / program.name, "contour", "--labels", image, "--output", tmp_path / "out.json"]
    environment = dict(os.environ, LD_LIBRARY_PATH=str(copy / "lib"))
    # The libraries of the copy, whatever paths the program has of the build.
    loaded = subprocess.run(["ldd", str(command[0])], env=environment, capture_output=True, text=True, check=True).stdout
    assert str(build_dir / "lib") not in loaded, loaded
    done = measure(command, env=environment)
    assert done.returncode == 2 and "dentalscr-decode, which decodes such files, is missing" in done.stderr, done.stderr
    shutil.copy(build_dir / "bin" / "dentalscr-decode", copy / "bin")
    done = measure(command, env=environment)
    assert "is missing" not in done.stderr, done.stderr


def test_a_bomb_in_a_scan_is_an_error(read, tmp_path):
    """1 MB of zlib that becomes 1 GB."""
    import base64

    block = 16 << 20
    packed = zlib.compress(bytes(block), 9)
    blocks = 64
    head = struct.pack(f"<{3 + blocks}I", blocks, block, block, *[len(packed)] * blocks)
    points = base64.b64encode(head) + base64.b64encode(packed * blocks)
    count = block * blocks // 12
    scan = tmp_path / "bomb.vtp"
    scan.write_bytes(
        b'<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian" header_type="UInt32" compressor="vtkZLibDataCompressor">'
        b'<PolyData><Piece NumberOfPoints="%d" NumberOfPolys="1"><Points><DataArray type="Float32" NumberOfComponents="3" '
        b'format="binary">%s</DataArray></Points><Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2'
        b'</DataArray><DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Polys></Piece></PolyData></VTKFile>'
        % (count, points)
    )
    done = read("axis", "--upper", scan, "--output", tmp_path / "out")
    assert done.returncode == 2 and "512 MiB as numbers" in done.stderr, done.stderr


def test_a_film_of_a_hundred_million_pixels_registers_within_a_gigabyte(program, is_sanitized, case, tmp_path):
    """8 x 10 inches at 1200 dots per inch are 115 million; the same drawing, as many times as large."""
    side = 10000
    (case.folder / "film.png").write_bytes(png(side, side))
    contours = case.load("contours.json")
    factor = side / max(contours["image_size"])
    # A pixel's middle is its index.
    larger = lambda point: [factor * value + (factor - 1) / 2 for value in point]  # noqa: E731
    for polylines in contours["contours"].values():
        for polyline in polylines:
            polyline["points"] = [larger(point) for point in polyline["points"]]
    contours["image_size"] = [side, side]
    case.save(contours, "contours.json")
    content = case.load()
    content["cephalogram"].update(image="film.png", pixel_spacing_mm=[value / factor for value in content["cephalogram"]["pixel_spacing_mm"]])
    if "principal_point_px" in content["geometry"]:
        content["geometry"]["principal_point_px"] = larger(content["geometry"]["principal_point_px"])
    content.pop("landmarks_2d", None)
    case.save(content)
    done = measure([program, "register", case.file, "--output", tmp_path / "out", "--quiet"])
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out" / "report.html").exists() and (tmp_path / "out" / "overlay_upper.png").exists()
    assert is_sanitized or done.kibibytes < 10**9 / 1024, f"{done.kibibytes} KiB"


def test_a_picture_of_more_bytes_than_are_read_is_refused(read, case, tmp_path):
    """Its pixels are few enough, not their values."""
    image = case.folder / "deep.nrrd"
    image.write_bytes(b"NRRD0004\ntype: double\ndimension: 2\nsizes: 10000 10000\nencoding: gzip\nendian: little\n\n" + zlib.compress(bytes(1000)))
    case.change(cephalogram=dict(case.load()["cephalogram"], image="deep.nrrd"))
    done = read("register", case.file, "--output", tmp_path / "out")
    assert done.returncode == 2 and "10000 x 10000 pixels of 8 bytes, too many to be read" in done.stderr, done.stderr
