"""Files of depth maps in metres: TIFF, NPY, PFM, and 16-bit PNG for reading."""

from __future__ import annotations

import re
from functools import partial
from os import PathLike

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import atomic, reading, validation
from lommel.base.arrays import Array
from lommel.io import registry
from lommel.io.photos import JPEG, PNG, TIFF, PhotoError, told, upright, write_tiff
from lommel.io.registry import Format, Values

_PFM = re.compile(rb"(P[fF])\s+(\d{1,9})\s+(\d{1,9})\s+([+-]?[0-9.]+(?:[eE][+-]?\d+)?)\s")


def read_depth(path: str | PathLike[str], *, scale: float | None = None, zero_is_unknown: bool = False) -> Array:
    """Read a depth map: the distance of every point from the lens, NaN where it is unknown.

    Parameters
    ----------
    path : path
        NPY, PFM, or a grey TIFF or PNG, recognized by its content.
    scale : float, optional
        Metres per level of integers, which need it; floats are metres without it. A PFM file whose header states a
        scale other than 1 needs it too, since programs disagree on its meaning.
    zero_is_unknown : bool, default False
        Whether 0 means unknown.

    Returns
    -------
    ndarray, shape (height, width)
        Metres; may hold infinity and NaN.

    Raises
    ------
    PhotoError
        If the file is damaged, of another format, has several channels, or has levels and no `scale` is given.
    ValueError
        If it holds a distance that is not positive, or 0 without `zero_is_unknown`.
    OSError
        If it cannot be read.
    """
    source = validation.path("path", path)
    factor = 1.0 if scale is None else validation.real("scale", scale, above=0.0, unit="metres per level")
    data = reading.contents(source)
    if data.startswith(JPEG):
        raise PhotoError(
            f"{validation.line(source)} is a JPEG, which does not preserve depth; save it as TIFF or 16-bit PNG"
        )
    with told(source, "depth map", data) as form:
        values = form.read(data, scale)
    del data  # to save memory
    return _metres(validation.line(source), values, scale is not None, factor, zero_is_unknown)


def write_depth(path: str | PathLike[str], depth: ArrayLike) -> None:
    """Write a depth map, or its standard deviation, in single precision, for :func:`lommel.imaging.read_depth`.

    The file is written under a temporary name and moved into place.

    Parameters
    ----------
    path : path
        .tif, .npy or .pfm.
    depth : array_like, shape (height, width)
        Metres; NaN where it is not known, may be infinite.

    Raises
    ------
    TypeError, ValueError
        If `depth` is not a map of this shape or holds negative values, or `path` has another suffix.
    OSError
        If the file cannot be written.
    """
    target = validation.path("path", path)
    write = find(target).write
    metres = validation.array("depth", depth)
    if metres.dtype.kind not in "iuf" or metres.ndim != 2 or 0 in metres.shape:
        raise ValueError(f"depth must be numbers of the shape (height, width), got {metres.dtype} {metres.shape}")
    if np.any(metres < 0.0):
        raise ValueError(f"depth must be >= 0 metres, got {metres[metres < 0.0].flat[0]:g}")
    with np.errstate(over="ignore"):
        data: bytes = write(np.asarray(metres, dtype=np.float32))
    atomic.write(target, data)


def _metres(source: str, values: Values, scaled: bool, factor: float, zero_is_unknown: bool) -> Array:
    if values.ndim != 2 or 0 in values.shape:
        raise PhotoError(f"{source} has the shape {values.shape}; a depth map has (height, width)")
    if values.dtype.kind not in "iuf":
        raise PhotoError(f"{source} holds {values.dtype}; a depth map holds numbers")
    if values.dtype.kind != "f" and not scaled:
        raise PhotoError(f"{source} is an integer image; give the scale, e.g. scale=0.001 for millimetres")
    with np.errstate(over="ignore", invalid="ignore"):  # of a NaN that signals
        metres = values.astype(np.float64)
        metres *= factor
    zeros = values.size - np.count_nonzero(values)
    if zeros:
        if not zero_is_unknown:
            raise ValueError(
                f"{source} is 0 at {zeros} of {values.size} points; if that means unknown, give `zero_is_unknown`"
            )
        metres[values == 0] = np.nan
    if (least := np.fmin.reduce(metres, axis=None)) < 0.0:
        raise ValueError(f"{source} must hold distances > 0 metres, got {least:g}")
    return metres


def _pfm(data: bytes, scale: float | None) -> Values:
    """Return the values of a portable float map: rows run upwards, a negative scale means little-endian."""
    found = _PFM.match(data)
    if not found:
        raise ValueError("its header is not that of a PFM file")
    if found[1] != b"Pf":
        raise ValueError("it is in colour")
    width, height, unit = int(found[2]), int(found[3]), float(found[4])
    reading.pixels(width, height)
    if unit == 0.0 or (abs(unit) != 1.0 and scale is None):
        raise ValueError(f"its header states the scale {unit:g}; give `scale`, the metres per unit")
    body = data[found.end() :]
    if len(body) != 4 * width * height:
        raise ValueError(f"{width} x {height} values take {4 * width * height} bytes, got {len(body)}")
    return np.frombuffer(body, dtype="<f4" if unit < 0.0 else ">f4").reshape(height, width)[::-1]


def _npy(data: bytes, _scale: float | None) -> Values:
    return reading.npy(data, reading.MAX_PIXELS)[0]


def _raster(data: bytes, _scale: float | None) -> Values:
    return upright(registry.identify("photo", data), data)[0]


def _write_pfm(values: NDArray[np.float32]) -> bytes:
    height, width = values.shape
    return f"Pf\n{width} {height}\n-1.0\n".encode() + values[::-1].astype("<f4").tobytes()


_form, _write_npy = partial(Format, "depth map"), partial(atomic.contents, np.save)
registry.register(
    _form((".npy",), _write_npy, _npy, (b"\x93NUMPY",)),
    _form((".pfm",), _write_pfm, _pfm, (b"Pf", b"PF")),
    _form((".tif", ".tiff"), partial(write_tiff, _quality=100, profile=None), _raster, TIFF, library="tifffile"),
    _form((".png",), read=_raster, starts=PNG),
)
find = partial(registry.find, "depth map")
