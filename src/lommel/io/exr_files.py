"""OpenEXR files of photographs in linear light and of depth maps, by the library of that name."""

from __future__ import annotations

import io
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from lommel.base import reading
from lommel.base.optional import library, version
from lommel.io.registry import Values

START = (b"\x76\x2f\x31\x01",)
"""The first bytes of files."""


@contextmanager
def _opened(data: bytes) -> Iterator[dict[str, Any]]:
    """Yield the channels of a file of one flat part whose size is within limits, by name."""
    exr = library("OpenEXR", "EXR files need", "exr")
    with exr.File(io.BytesIO(data), header_only=True) as file:
        if len(file.parts) != 1:
            raise ValueError(f"it has {len(file.parts)} parts; give a file of one")
        header = dict(file.header())  # which the library empties when it closes the file
    if header.get("type", exr.scanlineimage) not in (exr.scanlineimage, exr.tiledimage):
        raise ValueError("it is a deep image; flatten it first")
    window, shown = (
        [np.asarray(corner, dtype=np.int64).tolist() for corner in header[name]]
        for name in ("dataWindow", "displayWindow")
    )
    if window != shown:
        raise ValueError(f"it holds the pixels {window} of {shown} (corners x, y); save it uncropped")
    (left, top), (right, bottom) = window
    width, height = right - left + 1, bottom - top + 1
    reading.pixels(width, height)
    reading.afford(4.0 * width * height * len(header["channels"]), len(data))
    if any((each.xSampling, each.ySampling) != (1, 1) for each in header["channels"]):
        raise ValueError("some of its channels are subsampled; save it as RGB or grey")
    with exr.File(io.BytesIO(data), separate_channels=True) as file:
        yield {name: channel.pixels for name, channel in file.channels().items()}


def read_photo(data: bytes) -> tuple[Values, Any, bytes | None]:
    """Return the values of a photograph in float32, no tags and no profile."""
    from PIL import Image

    with _opened(data) as channels:
        alpha = channels.pop("A", None)
        if alpha is not None and not (alpha == 1.0).all():
            raise ValueError("it has alpha that is not 1 everywhere: put it on a background first")
        names = set(channels) - {"Z"}  # depth beside
        if names == {"R", "G", "B"}:
            values = np.stack([channels[name] for name in "RGB"], axis=-1)
        elif names == {"Y"}:
            values = channels["Y"]
        else:
            raise ValueError(f"its channels are {', '.join(sorted(names))}, neither R, G, B nor Y; save these alone")
    if values.dtype.kind != "f":
        raise ValueError(f"it holds {values.dtype}, not floats")
    return values.astype(np.float32), Image.Exif(), None


def read_depth(data: bytes, _scale: float | None) -> Values:
    """Return the channel Z of a depth map, also of a layer, or its only one, which may be stored as three."""
    with _opened(data) as channels:
        found = [name for name in channels if name.split(".")[-1] == "Z"]
        if len(found) != 1:
            found = [name for name in channels if name != "A"]
        if set(found) == {"R", "G", "B"} and all(
            np.array_equal(channels[name], channels["R"], equal_nan=True) for name in "GB"
        ):
            found = ["R"]
        if len(found) != 1:
            raise ValueError(f"its channels are {', '.join(sorted(channels))}; a depth map has one, or one named Z")
        return np.array(channels[found[0]])


def _written(channels: dict[str, Values]) -> bytes:
    exr = library("OpenEXR", "EXR files need", "exr")
    header = {"compression": exr.ZIP_COMPRESSION, "type": exr.scanlineimage, "software": f"lommel {version()}"}
    made = io.BytesIO()
    with exr.File(header, {name: np.ascontiguousarray(plane) for name, plane in channels.items()}) as file:
        file.write(made)
    return made.getvalue()


def write_photo(values: Values, _quality: int, profile: bytes | None) -> bytes:
    """Return a file, lossless."""
    if profile is not None:
        raise ValueError("EXR files have no ICC profile; write .tif, or leave the profile out")
    return _written({"RGB" if values.ndim == 3 else "Y": values})


def write_depth(values: Values) -> bytes:
    """Return a file with the channel Z."""
    return _written({"Z": values})
