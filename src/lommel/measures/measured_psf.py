"""Measured PSFs: values on the voxels of a recording, without an optical model."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.base.units import format_length
from lommel.fit.findings import Finding, Findings

_LEAST_HALF = 2  # voxels on either side of the point
_EQUAL = 1e-3  # relative difference of voxels below which a PSF is not resampled


@dataclass(frozen=True, eq=False)
class MeasuredPSF:
    """A measured PSF of sum 1; :meth:`lommel.PSF.measured` makes it. That of a photograph has one plane.

    Attributes
    ----------
    values : ndarray, shape (planes, height, width)
        Fraction of the light in each voxel. The point lies in the middle voxel, ``planes // 2`` and so on.
    pixel, step : float
        Pixel in the sample (of a photograph: on the sensor) and step between planes, metres.
    beads : int
        Number of beads in the mean.
    findings : Findings
        Number of beads, noise, voxel, peak, light on the rim, and what was left out.
    magnification : float or None
        Magnification of the objective that was given.
    """

    values: Array = field(repr=False)
    pixel: float
    step: float
    beads: int
    findings: Findings = field(repr=False)
    magnification: float | None = None

    @property
    def point(self) -> tuple[int, int, int]:
        """Index of the voxel in which the point lies."""
        planes, height, width = self.values.shape
        return planes // 2, height // 2, width // 2

    def resampled(self, pixel: float, step: float) -> MeasuredPSF:
        """Return the PSF of a recording with other voxels: pixels in the sample and step, metres."""
        ratios = [new / old for new, old in zip((step, pixel, pixel), self._voxel, strict=True)]
        if max(abs(ratio - 1.0) for ratio in ratios) < _EQUAL:
            return self
        halves = [int((side // 2 + 0.49) / ratio) for side, ratio in zip(self.values.shape, ratios, strict=True)]
        flat = len(self.values) == 1
        if min(halves[flat:]) < _LEAST_HALF:
            voxels = f"pixels or more in each direction of the photograph's {format_length(pixel)}"
            if not flat:
                voxels = (
                    f"voxels or more in each direction of the recording's {format_length(pixel)} and "
                    f"{format_length(step)}"
                )
            sides = " x ".join(str(2 * half + 1) for half in halves[flat:])
            raise ValueError(f"psf must have 5 {voxels}, got {sides}")
        places = [
            np.asarray(middle + ratio * np.arange(-half, half + 1), np.float64)
            for middle, ratio, half in zip(self.point, ratios, halves, strict=True)
        ]
        axes = frequencies(self.values.shape, self._voxel)
        # Light averaged over another pixel; a coarser grid has no frequencies beyond half of one per voxel.
        gain = np.ones(self.values.shape)
        for axis, (f, new, old) in enumerate(zip(axes, (step, pixel, pixel), self._voxel, strict=True)):
            one = np.where(f * new <= 0.5, np.sinc(f * new) / np.sinc(f * old) if axis else 1.0, 0.0)
            gain *= np.expand_dims(one, tuple(k for k in range(3) if k != axis))
        text = f"the PSF was resampled from voxels of {voxel_text(self.pixel, self.step)} to those of the stack"
        if flat:
            text = f"the PSF was resampled from pixels of {format_length(self.pixel)} to those of the photograph"
        finding = Finding("measured_psf", "note", text, {"pixel": self.pixel, "step": self.step})
        values = np.maximum(sampled(self.values, places, gain), 0.0)
        findings = Findings([*self.findings, finding])
        return replace(self, values=values / values.sum(), pixel=pixel, step=step, findings=findings)

    @property
    def _voxel(self) -> tuple[float, float, float]:
        return self.step, self.pixel, self.pixel


def voxel_text(pixel: float, step: float) -> str:
    """Return the sizes of a voxel in words."""
    return f"{format_length(pixel, digits=4)} and planes {format_length(step, digits=4)} apart"


def frequencies(shape: tuple[int, ...], voxel: tuple[float, ...]) -> list[Array]:
    """Return the frequencies, cycles per metre, of the cosine transform along each axis."""
    return [np.arange(side) / (2.0 * side * size) for side, size in zip(shape, voxel, strict=True)]


def places_of(shape: tuple[int, ...], shift: Array) -> list[Array]:
    """Return the places of all voxels, displaced by a shift."""
    return [np.arange(side) + by for side, by in zip(shape, shift, strict=True)]


def sampled(values: Array, places: list[Array], gain: Array | None = None) -> Array:
    """Return filtered values at other places of each axis, in voxels: the series of the cosine transform (DCT-II).

    Values beyond the faces are those of the mirror image, so that no edge rings.
    """
    series = scipy.fft.dctn(values, norm="forward")
    if gain is not None:
        series *= gain
    for place in places:  # each product moves the first axis to the end
        side = series.shape[0]
        basis = np.cos(np.pi / side * np.outer(np.arange(side), place + 0.5))
        basis[1:] *= 2.0
        series = np.tensordot(series, basis, (0, 0))
    return np.asarray(series)
