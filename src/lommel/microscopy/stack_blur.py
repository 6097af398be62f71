"""A specimen as a microscope records it plane by plane, as a linear operator, and the way back."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import validation
from lommel.estimation.noise import Noise
from lommel.imaging.linear import LinearBlur
from lommel.imaging.restoration.restore_with import Progress, Restoration, restore_with
from lommel.imaging.restoration.richardson_lucy import RichardsonLucy
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
        if not isinstance(shape, tuple | list) or len(shape) != 3:
            raise ValueError(f"shape must be (planes, height, width), got {validation.shown(shape)}")
        sides = [validation.integer("shape", side, least=1, most=validation.MAX_SIDE) for side in shape]
        self.dtype = validation.kind("dtype", dtype, np.float32, np.float64)
        self._planes, self._side = sides[0], (sides[1], sides[2])
        values = psf.values / psf.values.sum(dtype=np.float64)
        size = [next_fast_len(n + k - 1, real=True) for n, k in zip(sides, values.shape, strict=True)]
        kernel = np.zeros(size, self.dtype)
        kernel[tuple(slice(k) for k in values.shape)] = values
        middle = (origin, values.shape[1] // 2, values.shape[2] // 2)
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


def deconvolve(
    stack: ArrayLike,
    psf: PSF,
    noise: Noise,
    *,
    method: RichardsonLucy | None = None,
    margin: tuple[int, int] | None = None,
    progress: Progress | None = None,
) -> Restoration:
    """Restore a stack of planes that a microscope recorded, by its PSF and its noise.

    Parameters
    ----------
    stack : array_like of float, shape (planes, height, width)
        As it was recorded, in the unit of `noise`; NaN where a value is unknown.
    psf : PSF
        As :class:`lommel.microscopy.StackBlur` takes it, in the steps and pixels of the recording.
    noise : Noise
        Of one number each: maps of pixels have no margin.
    method : RichardsonLucy, optional
        By default ``lm.imaging.RichardsonLucy()``, which the noise stops.
    margin : (int, int), optional
        How many planes and pixels are restored beyond each face of the recording, of which nothing is known but the
        light that comes in; by default half of those of the PSF. With (0, 0) all outside is dark, and light that
        comes from there a misfit.
    progress : callable, optional
        As of :func:`lommel.imaging.restore_with`.

    Returns
    -------
    Restoration
        Its `values` and `light` are of the shape of the stack.

    Raises
    ------
    TypeError, ValueError
        If an argument is none of these.
    """
    validation.optional("method", method, RichardsonLucy)
    recorded = validation.array("stack", stack)
    if recorded.dtype.kind != "f" or recorded.ndim != 3:
        raise TypeError(f"stack must hold floats, (planes, height, width), got {validation.shown(stack)}")
    validation.instance("psf", psf, PSF)
    asked = (psf.shape[0] // 2, max(psf.grid.shape) // 2) if margin is None else margin
    if not isinstance(asked, tuple | list) or len(asked) != 2:
        raise ValueError(f"margin must be (planes, pixels), got {validation.shown(margin)}")
    planes, pixels = (validation.integer("margin", side, least=0, most=validation.MAX_SIDE) for side in asked)
    sides = [(planes, planes), (pixels, pixels), (pixels, pixels)]
    wide = np.moveaxis(np.pad(recorded, sides, constant_values=np.nan), 0, -1)
    blur = StackBlur(psf, (wide.shape[-1], *wide.shape[:2]))
    found = restore_with(wide if blur.channels > 1 else wide[..., 0], blur, noise, method=method, progress=progress)
    whole = np.moveaxis(found.values.reshape(*blur.shape, blur.channels), -1, 0)
    inside = tuple(slice(low, size - low) for (low, _), size in zip(sides, whole.shape, strict=True))
    return replace(found, values=whole[inside], light=whole[inside])
