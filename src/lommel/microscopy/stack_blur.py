"""A specimen as a microscope records it plane by plane, as a linear operator."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.imaging.linear import LinearBlur
from lommel.measures.axial import stage
from lommel.psf import PSF


class StackBlur(LinearBlur):
    """What a microscope makes of a specimen: each point spread by one PSF, along z too; its planes are channels.

    Parameters
    ----------
    psf : PSF
        A stack over z in even steps, those of the recording, one plane of which is at z = 0; its pixels are those of
        the recording. It holds at all depths. Values are divided by their sum, so that light is kept but for what
        leaves through the faces of the recording, outside of which there is nothing.
    shape : (int, int, int)
        Planes, height and width of the recording.
    dtype : float32 or float64, default float32
        Of the sums, done by FFTs that are padded, so that nothing wraps around.

    Raises
    ------
    TypeError, ValueError
        If one of them is none of these.
    """

    def __init__(self, psf: PSF, shape: tuple[int, int, int], dtype: DTypeLike = np.float32) -> None:
        from scipy.fft import next_fast_len, rfftn

        values, middle = kernel_of(psf)
        if not isinstance(shape, tuple | list) or len(shape) != 3:
            raise ValueError(f"shape must be (planes, height, width), got {validation.shown(shape)}")
        sides = [validation.integer("shape", side, least=1, most=validation.MAX_SIDE) for side in shape]
        self.dtype = validation.kind("dtype", dtype, np.float32, np.float64)
        self._planes, self._side = sides[0], (sides[1], sides[2])
        size = [next_fast_len(n + k - 1, real=True) for n, k in zip(sides, values.shape, strict=True)]
        kernel = np.zeros(size, self.dtype)
        kernel[tuple(slice(k) for k in values.shape)] = values
        self._size, self._transfer = size, rfftn(np.roll(kernel, [-m for m in middle], axis=(0, 1, 2)))

    @property
    def shape(self) -> tuple[int, int]:
        """Height and width of the planes."""
        return self._side

    @property
    def channels(self) -> int:
        """How many planes there are."""
        return self._planes

    def forward(self, image: NDArray[Any]) -> NDArray[Any]:
        """Return the recording of a specimen, both (height, width, planes).

        See :meth:`lommel.imaging.LinearBlur.forward`.
        """
        return self._filtered(image, self._transfer)

    def adjoint(self, image: NDArray[Any]) -> NDArray[Any]:
        """Return the transpose of :meth:`forward` applied to a recording.

        See :meth:`lommel.imaging.LinearBlur.adjoint`.
        """
        return self._filtered(image, self._transfer.conj())

    def _filtered(self, image: NDArray[Any], transfer: NDArray[Any]) -> NDArray[Any]:
        from scipy.fft import irfftn, rfftn

        made = irfftn(rfftn(self.planes(image), self._size) * transfer, self._size)
        made = made[: self._planes, : self._side[0], : self._side[1]]
        return np.ascontiguousarray(np.moveaxis(made, 0, 2), self.dtype).reshape(image.shape)


def kernel_of(psf: PSF) -> tuple[Array, tuple[int, int, int]]:
    """Return the share of the light of a point that each voxel receives, and which of these is that of the point.

    Parameters
    ----------
    psf : PSF
        As :class:`StackBlur` takes it.

    Returns
    -------
    kernel : ndarray, shape (planes, height, width)
        Its sum is 1.
    middle : (int, int, int)

    Raises
    ------
    TypeError, ValueError
        As :class:`StackBlur`.
    """
    validation.instance("psf", psf, PSF)
    z = stage(psf)
    steps = np.diff(z)
    if z.ndim != 1 or np.ptp(steps) > 1e-6 * np.abs(steps).max():
        raise ValueError(f"psf must be one stack over even steps of z, got steps {np.unique(steps)[:3]} metres")
    origin = int(np.abs(z).argmin())
    if abs(z[origin]) > 1e-6 * abs(steps[0]):
        raise ValueError(f"psf must have a plane at z = 0, the nearest is at {z[origin]:g} metres")
    if not psf.grid.centered:
        raise ValueError(f"psf must have its axis in the middle pixel, got center={psf.grid.center}")
    values = psf.values / psf.values.sum(dtype=np.float64)
    return values.astype(np.float64), (origin, values.shape[1] // 2, values.shape[2] // 2)
