"""Pictures for notebooks, without a plotting package."""
from __future__ import annotations

import struct
import zlib
from typing import Any

import numpy as np

from . import _core


def encode_png(array: Any) -> bytes:
    """An 8-bit array, (h, w) or (h, w, 3), as the bytes of a PNG."""
    pixels = np.ascontiguousarray(array, dtype=np.uint8)
    height, width = pixels.shape[:2]
    colour = 2 if pixels.ndim == 3 else 0
    rows = np.zeros((height, 1 + width * (3 if colour else 1)), np.uint8)
    rows[:, 1:] = pixels.reshape(height, -1)

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, colour, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(rows.tobytes(), 6))
        + chunk(b"IEND", b"")
    )


def grey_png(array: Any) -> bytes:
    """A grey picture from any values: smallest black, largest white, at most some 1000 pixels wide."""
    values = np.asarray(array, dtype=np.float64)
    if values.size == 0:
        return encode_png(np.zeros((1, 1)))
    step = max(1, -(-max(values.shape) // 1200))
    values = values[::step, ::step]
    low, high = float(np.min(values)), float(np.max(values))
    scale = 255.0 / (high - low) if high > low else 0.0
    return encode_png(np.rint((values - low) * scale))


def contour_svg(contour: _core.Contour) -> str:
    """The polylines of a contour, v downwards as in the radiograph."""
    polylines = contour.polylines
    if not polylines:
        return '<svg xmlns="http://www.w3.org/2000/svg" width="10" height="10"></svg>'
    points = np.concatenate([polyline.points for polyline in polylines])
    low, high = points.min(axis=0), points.max(axis=0)
    margin = 0.05 * float((high - low).max()) + 1.0
    x, y = low - margin
    width, height = high - low + 2.0 * margin
    stroke = max(width, height) / 300.0
    paths = []
    for polyline in polylines:
        text = "M" + "L".join(f"{u:.2f},{v:.2f}" for u, v in polyline.points) + ("Z" if polyline.closed else "")
        paths.append(f'<path d="{text}"><title>{polyline.code}</title></path>')
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{x:.2f} {y:.2f} {width:.2f} {height:.2f}" width="480" '
        f'fill="none" stroke="#0072b2" stroke-width="{stroke:.3f}">{"".join(paths)}</svg>'
    )
