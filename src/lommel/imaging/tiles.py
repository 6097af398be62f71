"""Photographs of scenes that do not fit into memory: by tiles that overlap, with one bank for all."""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.encoding import to_light
from lommel.base.options import shares
from lommel.imaging.blur import DepthBlur, require_lens
from lommel.imaging.linear import LinearBlur
from lommel.imaging.occlusion import Occlusion, reach_behind
from lommel.imaging.scene import Photograph, fill_missing, photograph, stored
from lommel.imaging.settings import Keywords, Settings
from lommel.optics.lens import Lens

_STRIP = 2**20  # points whose depths are looked at together


@shares(Keywords, Settings)
class TileBlur:
    """:func:`lommel.imaging.depth_of_field` of any part of a scene, with windows that are made once for all parts.

    Can be sent to other processes. What is `missing` is filled beforehand where it is "nearest": the nearest depth
    may lie in another part.

    Parameters
    ----------
    shape : tuple of int
        Of the whole image, (height, width) or (height, width, channels).
    depths : (float, float)
        Nearest and farthest distance in the scene, metres; may be infinite.
    lens, pixel, encoding
        As of :func:`lommel.imaging.depth_of_field`.
    {options}

    Attributes
    ----------
    overlap : int
        How many pixels a tile must know beyond those that it answers for, where the image goes on.
    """

    def __init__(
        self,
        shape: tuple[int, ...],
        depths: tuple[float, float],
        lens: Lens,
        pixel: float,
        *,
        encoding: str,
        **options: Unpack[Keywords],
    ) -> None:
        require_lens(lens, "shape, depths, lens, pixel")
        settings = Settings.of(TileBlur, options, Keywords)
        if settings.energy == 1.0:
            raise ValueError(
                "energy must be below 1 for tiles and chunks, since with all of its light a point reaches the whole "
                "image: ask for 0.9999, or for the whole image at once"
            )
        self.missing = "raise" if settings.missing == "nearest" else settings.missing
        self.encoding = encoding
        keywords = settings.of_blur | {"largest": settings.largest or max(1, min(shape[:2]) // 2)}
        extremes = np.array([depths], dtype=np.float64)
        self._whole = DepthBlur(extremes, lens, pixel, channels=settings.channels(shape, lens.wavelength), **keywords)
        self._reach = (float(self._whole.defocus.min()), float(self._whole.defocus.max()))
        self.overlap = self.half
        self._occlusion = settings.occlusion
        if self._occlusion:
            self.overlap += reach_behind(self._whole, self._reach)

    @property
    def half(self) -> int:
        """Pixels from the middle of the largest window to its edge."""
        return max(bank.half for bank in self._whole.banks)

    def __call__(self, image: NDArray[Any], depth: NDArray[Any]) -> NDArray[Any]:
        """Return the photograph of a part, stored as the image is; see :meth:`light`."""
        return stored(self.light(image, depth), self.encoding, image.dtype, self._whole.threads)[0]

    def light(self, image: NDArray[Any], depth: NDArray[Any]) -> NDArray[Any]:
        """Return the light of a part; within `overlap` of a side where the image goes on it is not complete.

        Raises
        ------
        TypeError, ValueError
            If a depth is beyond the range that was named, or missing; if something is masked.
        """
        image, depth = validation.array("image", image), validation.array("depth", depth)
        return self.operator(depth).forward(to_light("image", image, self.encoding, self._whole.dtype))

    def operator(self, depth: NDArray[Any]) -> LinearBlur:
        """Return the operator of a part, whose points hide one another as they do in the whole.

        Raises
        ------
        TypeError, ValueError
            If a depth is beyond the range that was named, or missing; if something is masked.
        """
        blur = copy.copy(self._whole)
        blur.place(fill_missing(depth, self.missing))
        low, high = self._reach
        if blur.defocus.min() < low or blur.defocus.max() > high:
            raise ValueError(
                f"depth must give C_d from {low:.6g} to {high:.6g} rad, as the depths named for the whole image, "
                f"got {blur.defocus.min():.6g} to {blur.defocus.max():.6g}"
            )
        return Occlusion(blur, self._reach) if self._occlusion else blur

    def chunk(self, image: NDArray[Any], depth: NDArray[Any]) -> NDArray[Any]:
        """Return the photograph of a part whose depth has as many axes as the image."""
        return self(image, depth.reshape(depth.shape[:2]))

    def photograph(self, values: NDArray[Any], clipped: float) -> Photograph:
        """Return values as a photograph, with what is known of their error and the share that was clipped."""
        return photograph(values, self._whole, clipped)


@shares(Keywords, Settings)
def depth_of_field_by_tiles(
    image: NDArray[Any],
    depth: NDArray[Any],
    lens: Lens,
    pixel: float,
    *,
    encoding: str,
    side: int = 1024,
    out: NDArray[Any] | None = None,
    progress: Callable[[int, int], object] | None = None,
    **options: Unpack[Keywords],
) -> Photograph:
    """Do as :func:`lommel.imaging.depth_of_field` in little memory; equal but for rounding.

    With `occlusion` tiles overlap by twice the range of radii of the blur more: so far from its edge what a near
    surface hides is looked for. Where `missing` is "nearest", all depths are read at once: the nearest one may lie in
    any tile.

    Parameters
    ----------
    image, depth : ndarray
        May be memory maps, of which no more than a tile is read at a time; depth is read once more before.
    lens, pixel, encoding
        As of :func:`lommel.imaging.depth_of_field`.
    side : int, default 1024
        Of the tiles, pixels, 16 to 16384. Memory beyond input and output is some hundred bytes a pixel of a tile, and
        with `occlusion` several hundred a channel.
    out : ndarray, optional
        Where to write the values, of the shape and type of `image`; may be a memory map. Shares none with them.
    progress : callable, optional
        Called as ``progress(done, tiles)`` after each tile.
    {options}

    Returns
    -------
    Photograph

    Raises
    ------
    TypeError, ValueError
        As :func:`lommel.imaging.depth_of_field`, and if `out` does not fit. What had been written by then stays.
    """
    require_lens(lens, "image, depth, lens, pixel")
    # Refuses what is masked before anything is written.
    shapes = [validation.array(name, given).shape for name, given in (("image", image), ("depth", depth))]
    if not isinstance(image, np.ndarray) or image.ndim not in (2, 3) or 0 in image.shape:
        raise ValueError(
            f"image must be an array of the shape (height, width) or (height, width, channels), got {np.shape(image)}"
        )
    if not isinstance(depth, np.ndarray) or depth.shape != image.shape[:2]:
        raise ValueError(f"depth must have the shape of the image, {image.shape[:2]}, got {shapes[1]}")
    tile = validation.integer("side", side, least=16, most=validation.MAX_SIDE)
    out = output(out, "image", image, depth)
    settings = Settings.of(depth_of_field_by_tiles, options, Keywords)
    if progress is not None and not callable(progress):
        raise TypeError(f"progress must be callable, got {validation.shown(progress)}")
    if settings.missing == "nearest":
        depth = fill_missing(depth, "nearest")
    depths = depth_range(depth, settings.missing)
    blur = TileBlur(image.shape, depths, lens, pixel, encoding=encoding, **options)
    tiles = list(parts_of(image.shape[:2], tile, blur.overlap))
    clipped = 0.0
    for done, (inside, around, within) in enumerate(tiles, 1):
        seen = blur.light(image[around], np.asarray(depth[around]))[within]
        out[inside], share = stored(seen, encoding, image.dtype, settings.threads or 0)
        clipped += share * seen.size / out.size
        if progress is not None:
            progress(done, len(tiles))
    return blur.photograph(out, clipped)


def output(out: NDArray[Any] | None, name: str, image: NDArray[Any], depth: NDArray[Any]) -> NDArray[Any]:
    """Return where values are written: `out`, or by default a new array.

    Parameters
    ----------
    out : ndarray, optional
    name : str
        Of the image.
    image, depth : ndarray
        What is read while it is written.

    Returns
    -------
    ndarray
        Of the shape and type of `image`.

    Raises
    ------
    ValueError
        If `out` is of another shape or type, cannot be written to, or shares memory with what is read.
    """
    if out is None:
        return np.empty(image.shape, dtype=image.dtype)
    if not isinstance(out, np.ndarray) or out.shape != image.shape or out.dtype != image.dtype:
        raise ValueError(f"out must be an array of the shape and type of the {name}, {image.shape} and {image.dtype}")
    if not out.flags.writeable or np.may_share_memory(out, image) or np.may_share_memory(out, depth):
        raise ValueError(f"out must be writeable, and must not share memory with {name} or depth")
    return out


def depth_range(depth: NDArray[Any], missing: str = "raise") -> tuple[float, float]:
    """Return the nearest and the farthest distance, metres, looking at some rows at a time.

    Raises
    ------
    TypeError, ValueError
        If a distance is not a number above 0, or missing where none may be.
    """
    if depth.dtype.kind not in "iuf":
        raise TypeError(f"depth must hold metres, got {depth.dtype}")
    rows = max(1, _STRIP // depth.shape[1])
    low, high = np.inf, -np.inf
    for first in range(0, depth.shape[0], rows):
        part = fill_missing(np.asarray(depth[first : first + rows]), missing)
        low, high = np.minimum(low, part.min()), np.maximum(high, part.max())
    if np.isnan(low):
        raise ValueError("depth is NaN at some points; say what is there by `missing`")
    return float(low), float(high)


def parts_of(
    shape: tuple[int, ...], side: int, overlap: int
) -> Iterator[tuple[tuple[slice, slice], tuple[slice, slice], tuple[slice, slice]]]:
    """Yield, for each tile of an image, its place in it, what it must know, and its place in that."""
    for top in range(0, shape[0], side):
        for left in range(0, shape[1], side):
            inside, around, within = [], [], []
            for start, size in ((top, shape[0]), (left, shape[1])):
                stop = min(size, start + side)
                first, last = max(0, start - overlap), min(size, stop + overlap)
                inside.append(slice(start, stop))
                around.append(slice(first, last))
                within.append(slice(start - first, stop - first))
            yield (inside[0], inside[1]), (around[0], around[1]), (within[0], within[1])
