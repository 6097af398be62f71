"""Images as a sensor recorded them, from files: values as they are stored, neither turned nor decoded."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import reading, validation
from lommel.io import fits_images, photo_formats, registry
from lommel.io.photos import PNG, TIFF, PhotoError, told
from lommel.io.registry import Format


def read_images(paths: Sequence[str | PathLike[str]]) -> NDArray[Any]:
    """Read images of one size from TIFF (every page is one), NPY and FITS (one image or a stack) or 16-bit PNG files.

    Parameters
    ----------
    paths : sequence of path
        Of one or several files; their images follow each other.

    Returns
    -------
    ndarray, shape (n, height, width)
        Of the type that is stored, integers or floats.

    Raises
    ------
    PhotoError
        If a file is damaged, of another format, has colours, or its images are of another size or type.
    OSError
        If one cannot be read.
    """
    found: list[NDArray[Any]] = []
    for path in paths:
        source = validation.path("paths", path)
        data = reading.contents(source)
        with told(source, "images", data) as form:
            values = form.read(data)
            if values.ndim == 2:
                values = values[None]
            if values.ndim != 3 or 0 in values.shape or values.dtype.kind not in "iuf":
                raise ValueError(f"it holds {values.dtype} of the shape {values.shape}, no grey images")
        if found and (found[0].shape[1:], found[0].dtype) != (values.shape[1:], values.dtype):
            (_, height, width), (_, other, across) = found[0].shape, values.shape
            raise PhotoError(
                f"{validation.line(source)} has images of {other} x {across} {values.dtype}, those before are of "
                f"{height} x {width} {found[0].dtype}"
            )
        found.append(values)
    if not found:
        raise ValueError("paths must name a file or several, got none")
    return np.concatenate(found)


def _npy(data: bytes) -> NDArray[Any]:
    return reading.npy(data, reading.MAX_PIXELS)[0]


def _png(data: bytes) -> NDArray[Any]:
    return photo_formats.read_png(data)[0]


def _fits(data: bytes) -> NDArray[Any]:
    return fits_images.read(data, reading.MAX_PIXELS)[0].values


def _tiff(data: bytes) -> NDArray[Any]:
    with reading.tiff(data) as file:
        pages = [page for page in list[Any](file.pages) if not page.is_reduced]
        if wrong := [page.axes for page in pages if page.axes not in ("YX", "SYX")]:
            raise ValueError(f"a page has the axes {wrong[0]}, which is no grey image")
        # Three images that were written without a word are planes of one page.
        images = [page.asarray().reshape(-1, *page.shape[-2:]) for page in pages]
    if len({image.shape[1:] for image in images}) > 1:
        raise ValueError("its pages are of several sizes")
    values = np.concatenate(images)
    return values.astype(values.dtype.newbyteorder("="), copy=False)


registry.register(
    Format("images", (".npy",), read=_npy, starts=(b"\x93NUMPY",)),
    Format("images", (".tif", ".tiff"), read=_tiff, starts=TIFF, library="tifffile", extra="images"),
    Format("images", (".png",), read=_png, starts=PNG, library="PIL.Image", extra="images"),
    Format("images", fits_images.SUFFIXES, read=_fits, starts=(b"SIMPLE  =",), library="astropy", extra="fits"),
)
