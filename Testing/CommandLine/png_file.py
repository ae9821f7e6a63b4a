"""A PNG, written without any library."""
import struct
import zlib


def png(rows, palette=None):
    """A grey PNG of 8 bits, or one with a palette, without any library."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    colours = b"" if palette is None else chunk(b"PLTE", bytes(value for colour in palette for value in colour))
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0 if palette is None else 3, 0, 0, 0)
    pixels = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))
    return (
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + colours + chunk(b"IDAT", pixels) + chunk(b"IEND", b"")
    )
