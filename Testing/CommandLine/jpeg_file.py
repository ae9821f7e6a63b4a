"""A JPEG that comes in steps, written without any library."""
import struct

LONGEST_RUN = (1 << 15) - 1


def _pack(codes):
    """The bytes of codes, each a value and its bits, as a scan holds them."""
    bits = "".join(format(value, f"0{count}b") for value, count in codes)
    bits += "1" * (-len(bits) % 8)
    return int(bits, 2).to_bytes(len(bits) // 8, "big").replace(b"\xff", b"\xff\x00")


def _table(kind, *symbols):
    """Codes of two bits, or of one where there is one symbol."""
    lengths = [0] * 16
    lengths[0 if len(symbols) == 1 else 1] = len(symbols)
    return b"\xff\xc4" + struct.pack(">HB", 19 + len(symbols), kind) + bytes(lengths) + bytes(symbols)


def _scan(first, last, data):
    return b"\xff\xda" + struct.pack(">HBBBBBB", 8, 1, 1, 0, first, last, 0) + data


def progressive(width, height, scans, colours=1):
    """A picture, all of it 128, grey if it has one colour, with so many scans behind the first that change nothing."""
    blocks = -(-width // 8) * -(-height // 8)
    runs = []
    left = blocks
    while left > 0:
        # EOB14, a run of 2^14 and more blocks without a value; EOB0, of one.
        long = min(left, LONGEST_RUN)
        runs += [(0, 2), (long - (1 << 14), 14)] if long >= 1 << 14 else [(1, 2)]
        left -= long if long >= 1 << 14 else 1
    return (
        b"\xff\xd8\xff\xdb" + struct.pack(">HB", 67, 0) + bytes([1] * 64)
        + b"\xff\xc2" + struct.pack(">HBHHB", 8 + 3 * colours, 8, height, width, colours)
        + b"".join(bytes((colour, 0x11, 0)) for colour in range(1, colours + 1))
        + _table(0x00, 0) + _table(0x10, 0xE0, 0x00)
        + _scan(0, 0, _pack([(0, 1)] * blocks))
        + _scan(1, 63, _pack(runs)) * scans
        + b"\xff\xd9"
    )
