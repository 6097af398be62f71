r"""Sums over whole images, of even kernels that reach beyond them: by cosine transforms, in which mirrors are exact.

Of an image between two mirrors, half a pixel beyond its first and its last pixel, a convolution with an even kernel
is diagonal in the discrete cosine transform of type II, whatever the reach of the kernel: it multiplies by
``sum_q g(q) cos(pi k q / n)``, the transform of the kernel at the frequencies ``k / 2 n``. Where no mirror is wanted,
an image is continued first, and the mirror is farther away.

References
----------
S. A. Martucci, "Symmetric convolution and the discrete sine and cosine transforms", IEEE Trans. Signal Process. 42,
1038 (1994), doi:10.1109/78.295213.
"""

from __future__ import annotations

import math
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.imaging.whole.remainder import Remainder, smooth_transforms

_COPIES = 9.04
"""Sum of 1 over the cubed distances from one point of a square lattice to the others: 9.0336."""


class MirroredKernels:
    """The g_r of a remainder, as they act on images of one shape.

    Parameters
    ----------
    remainder : Remainder
    shape : (int, int)
        Height and width of the image.
    border : {"reflect", "extend", "zero"}
        What lies beyond its edges. The last pixels go on for half of the height and the width, and are mirrored
        there. Darkness is as wide as it takes for light from its mirrors to be less than half of `tol` of white.
    dtype : dtype
        Of the sums.
    tol : float

    Attributes
    ----------
    error : float
        Light from mirrors beyond darkness, of white: what is off beside the remainder.
    """

    def __init__(
        self, remainder: Remainder, shape: tuple[int, int], border: str, dtype: np.dtype[Any], tol: float
    ) -> None:
        self.remainder, self.border, self.dtype, self.error = remainder, border, dtype, 0.0
        self._around = [(0, 0), (0, 0)]
        if border == "extend":
            self._around = [(max(1, side // 2),) * 2 for side in shape]
        elif border == "zero":
            from scipy.fft import next_fast_len

            tail = float(np.abs(remainder.knots @ remainder.smooth[:, 0]).max())
            light = _COPIES * math.prod(shape) * tail
            dark = max(math.ceil(0.5 * math.cbrt(light / (0.5 * tol))), remainder.table.shape[1])
            self._around = [(dark, next_fast_len(side + 2 * dark, real=True) - side - dark) for side in shape]
            self.error = light / (2.0 * dark) ** 3
        (top, _), (left, _) = self._around
        self._image = slice(top, top + shape[0]), slice(left, left + shape[1])
        self._sides = [side + sum(more) for side, more in zip(shape, self._around, strict=True)]

    @cached_property
    def eigenvalues(self) -> NDArray[Any]:
        """Transforms of the g_r, shape (rank, height, width) of the image as it is continued; kept."""
        table, scale = self.remainder.table.astype(self.dtype), self.remainder.scale
        down, across = (_cosines(side, table.shape[1] - 1, self.dtype.char) for side in self._sides)
        made = down @ table @ across.T
        known = _smooth(*self._sides, scale, self.dtype.char)
        for each, parts in zip(made, self.remainder.smooth.astype(self.dtype), strict=True):
            for part, transform in zip(parts, known, strict=True):
                each += part * transform
        return np.asarray(made)

    def transformed(self, r: int, plane: NDArray[Any]) -> NDArray[Any]:
        """Return the transform of what g_r makes of a plane."""
        from scipy.fft import dctn

        if self.border != "reflect":
            plane = np.pad(plane, self._around, mode="edge" if self.border == "extend" else "constant")
        made = dctn(plane, overwrite_x=True)
        made *= self.eigenvalues[r]
        return np.asarray(made)

    def image(self, transform: NDArray[Any], threads: int = 1) -> NDArray[Any]:
        """Return the image of a transform."""
        from scipy.fft import idctn

        return np.asarray(idctn(transform, overwrite_x=True, workers=threads)[self._image])

    def known(self, plane: NDArray[Any], threads: int = 1) -> NDArray[Any]:
        """Return the transform of a plane with darkness around it: the transpose of :meth:`image` but for a scale."""
        from scipy.fft import dctn

        return np.asarray(dctn(np.pad(plane, self._around), workers=threads))

    def taken(self, r: int, known: NDArray[Any]) -> NDArray[Any]:
        """Return the transpose of :meth:`transformed`, but for that scale, of a transform."""
        from scipy.fft import idctn

        taken = idctn(self.eigenvalues[r] * known, overwrite_x=True)
        if self.border == "extend":
            # What copies of the edges took goes to these.
            for lines, (before, after) in zip((taken, taken.T), self._around, strict=True):
                lines[before] += lines[:before].sum(axis=0)
                lines[-after - 1] += lines[-after:].sum(axis=0)
        return np.asarray(taken[self._image])


@lru_cache(maxsize=8)
def _cosines(side: int, reach: int, kind: str) -> NDArray[Any]:
    """Return the cosines that an even kernel is multiplied by, and 2 where a value stands for two."""
    turns = np.outer(np.arange(side), np.arange(reach + 1)) % (2 * side)
    made = 2.0 * np.cos((math.pi / side) * turns)
    made[:, 0] = 1.0
    made.flags.writeable = False
    return np.asarray(made.astype(kind))


@lru_cache(maxsize=4)
def _smooth(height: int, width: int, scale: float, kind: str) -> NDArray[Any]:
    """Return the transforms of the smooth parts, shape (3, height, width)."""
    down, across = ((np.arange(side) / (2.0 * side)).astype(kind) for side in (height, width))
    return smooth_transforms(np.hypot(down[:, None], across), scale)
