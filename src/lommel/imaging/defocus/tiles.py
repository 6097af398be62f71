"""Depth from defocus by tiles of a photograph, which overlap by as far as blur and windows reach."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.estimation.pixel_transfer import half_window
from lommel.imaging.defocus.costs import Found, Tile, Weights, search, sharpen
from lommel.imaging.defocus.photos import Exposures
from lommel.optics.lens import Lens

_CORE = 256
"""Most that a tile answers for, pixels a side."""
_LEAST_MARGIN = 24

Places = NDArray[np.int64]
Transfer = Callable[[Lens, Array, Sequence[tuple[float, float]], float, tuple[int, int], int], NDArray[np.float32]]


@dataclass(frozen=True, eq=False)
class Tiling:
    """Photographs cut into tiles.

    Attributes
    ----------
    exposed : Exposures
    transfers : list of ndarray
        As :func:`lommel.imaging.defocus.costs.search` takes them.
    core, margin, sides : int and (int, int)
        Pixels that a tile answers for, down and across, and beyond these on either side; those transformed.
    blur : float
        Largest radius of the blur, pixels.
    """

    exposed: Exposures
    transfers: list[NDArray[np.float32]]
    core: tuple[int, int]
    margin: int
    sides: tuple[int, int]
    blur: float
    window: float

    @classmethod
    def of(
        cls,
        exposed: Exposures,
        lenses: Sequence[Lens],
        distances: Array,
        spectra: Sequence[Sequence[tuple[float, float]]],
        pixel: float,
        window: float,
        transfer: Transfer,
    ) -> Tiling:
        """Return tiles, with the transfer functions of all lenses at all distances in all channels."""
        from scipy.fft import next_fast_len

        blur = max(float(lens.pupil(distances).geometric_radius().max()) for lens in lenses) / pixel
        half = half_window(lenses, distances, pixel)
        margin = max(_LEAST_MARGIN, math.ceil(2.0 * blur + 3.0 * window))
        shape = exposed.valid.shape
        core = tuple(math.ceil(side / math.ceil(side / _CORE)) for side in shape)
        sides = tuple(next_fast_len(max(side + 2 * margin, 2 * half + 1), real=True) for side in core)
        known: dict[tuple[tuple[float, float], ...], NDArray[np.float32]] = {}
        for spectrum in map(tuple, spectra):
            if spectrum not in known:
                known[spectrum] = np.stack(
                    [transfer(lens, distances, spectrum, pixel, sides, half) for lens in lenses]
                )
        return cls(
            exposed, [known[tuple(spectrum)] for spectrum in spectra], core, margin, sides, blur, window
        )  # fmt: skip

    def search(self, progress: Callable[[int, int], object] | None = None) -> Found:
        """Return what all tiles tell."""
        shape = self.exposed.valid.shape
        out = Found(*(np.empty(shape, dtype=np.float64) for _ in Found._fields))
        trust = self._trusted()
        weigh = Weights.of(self.sides, self.margin, self.core, self.window)
        tiles = list(self._tiles())
        for done, (inside, at, within) in enumerate(tiles, 1):
            own = self._own(inside)
            tile = Tile(self.exposed.images[:, :, *at], self.exposed.variances[:, :, *at], trust[at] * own, own)
            for whole, part in zip(out, search(tile, self.transfers, weigh, self.window), strict=True):
                whole[inside] = part[within]
            if progress is not None:
                progress(done, len(tiles))
        return out

    def sharp(self, position: Array, level: float) -> NDArray[np.float64]:
        """Return the electrons of the scene in focus, shape (channels, height, width).

        Parameters
        ----------
        position : ndarray, shape (height, width)
            Of each pixel among the candidates.
        level : float
            Power of the texture at 1 cycle a pixel over that of noise.
        """
        out = np.empty((len(self.transfers), *position.shape))
        rows, columns = (slice(self.margin, self.margin + side) for side in self.core)
        inner = rows, columns
        for inside, at, within in self._tiles():
            place = position[at][inner]
            for channel, transfer in enumerate(self.transfers):
                images, variances = (part[channel][:, *at] for part in (self.exposed.images, self.exposed.variances))
                out[channel][inside] = sharpen(images, variances, transfer, place, level, inner)[within]
        return out

    def _tiles(self) -> Iterator[tuple[tuple[slice, slice], tuple[Places, Places], tuple[slice, slice]]]:
        """Yield where each tile answers, the pixels that it is made of, mirrored, and what of it is used."""
        height, width = self.exposed.valid.shape
        for top in range(0, height, self.core[0]):
            for left in range(0, width, self.core[1]):
                rows, columns = (
                    _mirrored(np.arange(side) + first - self.margin, whole)
                    for side, first, whole in zip(self.sides, (top, left), (height, width), strict=True)
                )
                inside = slice(top, min(top + self.core[0], height)), slice(left, min(left + self.core[1], width))
                within = slice(inside[0].stop - top), slice(inside[1].stop - left)
                yield inside, (rows[:, None], columns), within

    def _own(self, inside: tuple[slice, slice]) -> NDArray[np.float32]:
        """Return 1 where a tile that answers there is made of the image, 0 where it is made of mirrored copies."""
        own = np.zeros(self.sides, dtype=np.float32)
        first = [part.start - self.margin for part in inside]
        rows, columns = (
            slice(max(0, -start), whole - start) for start, whole in zip(first, self.exposed.valid.shape, strict=True)
        )
        own[rows, columns] = 1.0
        return own

    def _trusted(self) -> NDArray[np.float32]:
        """Return 1 where pixels are known as far as light is spread, 0 elsewhere."""
        valid = self.exposed.valid
        if valid.all():
            return valid.astype(np.float32)
        from scipy.ndimage import distance_transform_edt

        return np.asarray(distance_transform_edt(valid) > self.blur + 1.0, dtype=np.float32)


def _mirrored(index: NDArray[np.int64], count: int) -> NDArray[np.int64]:
    """Return pixels of a side of an image for those beyond its ends."""
    turned = index % (2 * count)
    return np.where(turned < count, turned, 2 * count - 1 - turned)
