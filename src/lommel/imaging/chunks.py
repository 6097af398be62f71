"""Photographs of scenes held by dask: lazily, chunk by chunk, on threads, processes or a cluster."""

from __future__ import annotations

import math
from typing import Any, Unpack

from lommel.base import validation
from lommel.base.optional import library
from lommel.base.options import shares
from lommel.imaging.blur import require_lens
from lommel.imaging.scene import fill_missing
from lommel.imaging.settings import Keywords, Settings
from lommel.imaging.tiles import TileBlur
from lommel.optics.lens import Lens


@shares(Keywords, Settings, threads=1)
def depth_of_field_of_chunks(
    image: Any,
    depth: Any,
    lens: Lens,
    pixel: float,
    *,
    encoding: str,
    depths: tuple[float, float] | None = None,
    side: int | None = None,
    **options: Unpack[Keywords],
) -> Any:
    """Do as :func:`lommel.imaging.depth_of_field_by_tiles` for dask arrays; the same but for rounding.

    The windows are made at once, for all chunks; all else when the result is computed. Where `missing` is "nearest",
    one task holds all depths. Needs dask,
    ``pip install "dask[array]"``. One thread for each chunk by default, since chunks are computed side by side.

    Parameters
    ----------
    image : dask.array.Array, shape (height, width) or (height, width, channels)
    depth : dask.array.Array, shape (height, width)
        Distances, metres.
    lens, pixel, encoding
        As of :func:`lommel.imaging.depth_of_field`.
    depths : (float, float), optional
        Nearest and farthest distance in the scene, metres. By default they are computed at once.
    side : int, optional
        Of the chunks that the image is cut into, pixels, at least 16; by default they stay as they are. Chunks grow
        by half a window on every side, with `occlusion` as tiles do; those of 1024 by 1024 pixels take some tenths
        of a second.
    {options}

    Returns
    -------
    dask.array.Array
        Of the shape and type of `image`.

    Raises
    ------
    ImportError
        If dask is missing.
    TypeError, ValueError
        As :func:`lommel.imaging.depth_of_field`; when it is computed, if an image or a depth is not what it must be.
    """
    # Typed in part only.
    dask, da = (library(name, "chunks need", "dask") for name in ("dask", "dask.array"))

    settings = Settings.of(depth_of_field_of_chunks, options, Keywords)
    require_lens(lens, "image, depth, lens, pixel")
    for name, array in (("image", image), ("depth", depth)):
        if not isinstance(array, da.Array):
            raise TypeError(f"{name} must be a dask array, got {type(array).__name__}")
    if image.ndim not in (2, 3) or 0 in image.shape:
        raise ValueError(f"image must have the shape (height, width) or (height, width, channels), got {image.shape}")
    if depth.shape != image.shape[:2]:
        raise ValueError(f"depth must have the shape of the image, {image.shape[:2]}, got {depth.shape}")
    if side is not None:
        tile = validation.integer("side", side, least=16, most=validation.MAX_SIDE)
        image = image.rechunk({0: tile, 1: tile})
    if image.ndim == 3:
        image = image.rechunk({2: -1})
    if settings.missing == "nearest":
        # The nearest depth may lie in any chunk.
        depth = depth.rechunk(-1).map_blocks(fill_missing, "nearest", dtype=depth.dtype, meta=depth._meta)
    if depths is None:
        known = da.where(da.isnan(depth), float("inf"), depth) if settings.missing == "infinity" else depth
        low, high = dask.compute(known.min(), known.max())
        depths = (float(low), float(high))
        if math.isnan(depths[0]):
            raise ValueError("depth is NaN at some points; say what is there by `missing`")
    given: Keywords = {"threads": 1, **options}
    blur = TileBlur(image.shape, depths, lens, pixel, encoding=encoding, **given)
    distances = depth.rechunk(image.chunks[:2])
    around = {axis: min(blur.overlap, image.shape[axis]) for axis in (0, 1)}
    if image.ndim == 3:
        # Chunks of the two arrays are matched by their axes, counted from the last.
        distances, around = distances[..., None], around | {2: 0}
    return da.map_overlap(
        blur.chunk,
        image,
        distances,
        depth=[around, around],
        boundary="none",
        align_arrays=False,
        dtype=image.dtype,
        meta=image._meta,
    )
