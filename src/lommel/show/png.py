"""Small pictures for notebooks without a library: colours, and PNG files by zlib."""

from __future__ import annotations

import base64
import struct
import zlib

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array

# Nine of the colours of each map, evenly spaced. "light" is magma of matplotlib (S. van der Walt and N. Smith, CC0),
# "phase" ColorBrewer's RdBu, reversed (C. Brewer and M. Harrower, Apache 2.0).
_ANCHORS = {
    "light": "000004 1c1044 4f127b 812581 b5367a e55964 fb8761 fec287 fcfdbf",
    "phase": "2166ac 4393c3 92c5de d1e5f0 f7f7f7 fddbc7 f4a582 d6604d b2182b",
}
_SIDE = 160  # pixels that a picture has at most
_NOTHING = (128, 128, 128, 70)  # to be seen on pages of any colour


def colored(values: Array, kind: str) -> NDArray[np.uint8]:
    """Return the colours of values from 0 to 1, red, green, blue and opacity; NaN is a shade, infinity clear.

    Parameters
    ----------
    values : ndarray, shape (height, width)
    kind : {"light", "phase"}

    Returns
    -------
    ndarray of uint8, shape (height, width, 4)
    """
    anchors = np.array([[int(each[k : k + 2], 16) for k in (0, 2, 4)] for each in _ANCHORS[kind].split()], float)
    known = np.isfinite(values)
    at = np.where(known, np.clip(values, 0.0, 1.0), 0.0)
    steps = np.linspace(0.0, 1.0, len(anchors))
    rgb = [np.interp(at, steps, channel) for channel in anchors.T]
    pixels: NDArray[np.uint8] = np.rint(np.stack([*rgb, np.where(known, 255.0, 0.0)], axis=-1)).astype(np.uint8)
    pixels[np.isnan(values)] = _NOTHING
    return pixels


def encoded(pixels: NDArray[np.uint8]) -> bytes:
    """Return a PNG file of pixels, shape (height, width, 4); see the specification, ISO/IEC 15948."""
    height, width = pixels.shape[:2]
    rows = np.zeros((height, 1 + 4 * width), np.uint8)  # each begins with its filter, none
    rows[:, 1:] = pixels.reshape(height, -1)

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    parts = chunk(b"IHDR", head), chunk(b"IDAT", zlib.compress(rows.tobytes())), chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def smaller(values: Array, most: int = _SIDE) -> Array:
    """Return values averaged over squares, so that no side is longer than `most`; what is over is left."""
    times = -(-max(values.shape) // most)
    if times == 1:
        return values
    height, width = (max(side // times, 1) for side in values.shape)
    parts = values[: height * times, : width * times]
    tall, wide = (min(times, side) for side in parts.shape)
    return np.asarray(parts.reshape(height, tall, width, wide).mean(axis=(1, 3)))


def image(values: Array, kind: str, words: str, side: int) -> str:
    """Return an element of HTML with a picture of values from 0 to 1, `side` pixels long; `words` describe it."""
    height, width = values.shape
    scale = side / max(height, width)
    data = base64.b64encode(encoded(colored(values, kind))).decode()
    size = f"width:{max(round(scale * width), 1)}px;height:{max(round(scale * height), 1)}px"
    return f'<img alt="{words}" style="{size};image-rendering:pixelated" src="data:image/png;base64,{data}">'
