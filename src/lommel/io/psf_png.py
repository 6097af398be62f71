"""PSFs as pictures: 16-bit grey, the square root of the values over their peak, enlarged."""

from __future__ import annotations

import json
import math

import numpy as np

from lommel.base import atomic, reading, validation
from lommel.base.checksums import sealed
from lommel.io.registry import Arrays, Description, Values
from lommel.measures.psf_like import PSFLike

LEVELS = 65535
"""The value of the peak."""

_SIDE = 512
"""Smaller PSFs are enlarged to this side or more, by an integer factor."""


def scale(psf: PSFLike) -> int:
    """Return the factor by which the picture of a PSF is enlarged."""
    return -(-_SIDE // max(psf.shape[-2:]))


def write(psf: PSFLike, description: Description) -> bytes:
    """Return a picture, with the description and the scale of the values as texts in it."""
    from PIL import Image, PngImagePlugin

    if psf.values.ndim != 2:
        raise ValueError(
            f"a .png holds a single PSF, got a stack of shape {psf.shape}; index it, or draw it by plot()"
        )
    peak = float(psf.values.max())
    if peak <= 0:
        raise ValueError("a .png needs a positive value; every value of this PSF is 0")
    shares = np.maximum(psf.values.astype(np.float64), 0.0) / peak
    grey = np.rint(np.sqrt(shares) * LEVELS).astype(np.uint16)
    picture = {"png": {"peak": peak, "stretch": "sqrt", "levels": LEVELS, "scale": scale(psf)}}
    info = PngImagePlugin.PngInfo()
    info.add_text("Software", description["software"])
    info.add_text("lommel", json.dumps(sealed(description | picture, {"values": grey})))
    image = Image.fromarray(_enlarged(grey, scale(psf)))
    small = atomic.contents(image.save, format="png", pnginfo=info)
    if reading.affords(reading.png_takes(math.prod(image.size), 16, colour=False), len(small)):
        return small
    return atomic.contents(image.save, format="png", pnginfo=info, compress_level=0)


def read(data: bytes) -> tuple[Arrays, str]:
    """Return one grey value for each pixel of the PSF, and the description."""
    with reading.png(data) as file:
        text = str(file.info["lommel"])  # which stands before the picture
        description = reading.json(text)
        times = validation.integer("scale", description["png"]["scale"], least=1, most=_SIDE)
        if list(file.size[::-1]) != [times * side for side in description["shape"]]:
            raise ValueError(f"it has {file.size[0]} x {file.size[1]} pixels, other than it says")
        file.load()
        grey = np.asarray(file, dtype=np.uint16)
    values = np.ascontiguousarray(grey[::times, ::times])
    if not np.array_equal(_enlarged(values, times), grey):
        raise ValueError("its pixels are not enlarged as it says")
    return {"values": values}, text


def _enlarged(grey: Values, times: int) -> Values:
    return np.repeat(np.repeat(grey, times, axis=0), times, axis=1)
