"""A radiograph as a DICOM file, written byte by byte."""
import struct

LITTLE_ENDIAN = b"1.2.840.10008.1.2.1"


def element(group, number, kind, value):
    """Of an explicit value representation, in little endian; padded as its kind has it."""
    value += (b"\0" if kind in (b"OB", b"OW", b"UI") else b" ") * (len(value) % 2)
    head = struct.pack("<HH2s", group, number, kind)
    return head + (struct.pack("<HI", 0, len(value)) if kind in (b"OB", b"OW", b"SQ") else struct.pack("<H", len(value))) + value


def dicom(rows, columns, pixels, syntax=LITTLE_ENDIAN, behind=b"", bits=8, patient=None, tags=()):
    """Grey pixels, compressed ones in a fragment where the transfer syntax is another one.

    patient: name and number, where it has them. tags: (group, element, kind, value) between 0018 and 0020, in order."""
    short = lambda number: struct.pack("<H", number)
    digital = b"1.2.840.10008.5.1.4.1.1.1"
    meta = element(2, 2, b"UI", digital) + element(2, 3, b"UI", b"1.2.3") + element(2, 0x10, b"UI", syntax)
    meta = element(2, 0, b"UL", struct.pack("<I", len(meta))) + meta
    image = element(8, 0x16, b"UI", digital) + element(8, 0x18, b"UI", b"1.2.3") + element(8, 0x60, b"CS", b"DX")
    if patient is not None:
        image += element(0x10, 0x10, b"PN", patient[0]) + element(0x10, 0x20, b"LO", patient[1])
    image += b"".join(element(*tag) for tag in tags)
    image += element(0x28, 2, b"US", short(1)) + element(0x28, 4, b"CS", b"MONOCHROME2")
    image += element(0x28, 0x10, b"US", short(rows)) + element(0x28, 0x11, b"US", short(columns))
    image += element(0x28, 0x100, b"US", short(bits)) + element(0x28, 0x101, b"US", short(bits))
    image += element(0x28, 0x102, b"US", short(bits - 1)) + element(0x28, 0x103, b"US", short(0))
    if syntax == LITTLE_ENDIAN:
        data = element(0x7FE0, 0x10, b"OW", pixels)
    else:
        item = lambda content: struct.pack("<HHI", 0xFFFE, 0xE000, len(content)) + content
        pixels += b"\0" * (len(pixels) % 2)
        data = struct.pack("<HH", 0x7FE0, 0x10) + b"OB" + struct.pack("<HI", 0, 0xFFFFFFFF)
        data += item(b"") + item(pixels) + struct.pack("<HHI", 0xFFFE, 0xE0DD, 0)
    return bytes(128) + b"DICM" + meta + image + data + behind
