"""The light of a point on the pixels of a sensor, anywhere in the field of a lens, at any defocus."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.field.maps import FieldMap
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import psf

CORE = 0.9
"""Share of the light whose changes tell how close nodes must be."""

_AT_ONCE = 2**24  # values that are computed at once

Spectrum = Sequence[tuple[float, float]]
Span = tuple[float, float]


@dataclass(frozen=True)
class PointLight:
    """The light of a point on the pixels of a sensor, anywhere in the field, at any defocus.

    Attributes
    ----------
    field_map : FieldMap
    phase : callable, optional
        Makes wavefronts of defocus, as :meth:`lommel.Lens.phase`.
    spectrum : sequence of (wavelength, weight), optional
        Metres; weights sum to 1. By default the wavelength of the map.
    pixel : float
        In the unit of the map.
    tol : float
        Of each PSF, over its peak.
    threads : int, optional
    """

    field_map: FieldMap
    phase: Callable[[NDArray[np.float64]], Wavefront] | None
    spectrum: Spectrum | None
    pixel: float
    tol: float
    threads: int | None

    def pupil(self, y: NDArray[np.float64], x: NDArray[np.float64], defocus: NDArray[np.float64]) -> Pupil:
        """Return what some places see at a defocus each, arrays of one shape: a stack."""
        pupil = self.field_map.pupil(x, y)
        return pupil if self.phase is None else pupil.carrying(pupil.wavefront + self.phase(defocus), None)

    def windows(self, places: NDArray[np.float64], half: int) -> NDArray[np.float64]:
        """Return the share of light in each pixel of windows of points.

        Parameters
        ----------
        places : ndarray, shape (n, 3)
            y and x in the field, and the defocus C_d, radians.
        half : int
            Pixels from the middle of a window to its edge.

        Returns
        -------
        ndarray, shape (n, 2 half + 1, 2 half + 1)
        """
        side = 2 * half + 1
        out = np.zeros((len(places), side, side))
        step = max(1, _AT_ONCE // side**2)
        for first in range(0, len(places), step):
            part = slice(first, first + step)
            pupil = self.pupil(*places[part].T)
            for wavelength, weight in self.spectrum or ((None, 1.0),):
                light = pupil if wavelength is None else pupil.in_light(wavelength)
                given: dict[str, Any] = {"integrate": True, "dtype": np.float64, "threads": self.threads}
                out[part] += weight * psf(light, side, self.pixel, tol=self.tol, **given).values
        return out

    def enough(self, spans: Sequence[Span], energy: float, largest: int) -> tuple[int, int]:
        """Return half of a window that holds `energy` of the light at places all over the spans, and of its core."""
        places = overview(spans)
        half = math.ceil(float(self.pupil(*places.T).geometric_radius().max()) / self.pixel) + 1
        while True:
            half = min(half, largest)
            windows = self.windows(places, half)
            if windows.sum(axis=(1, 2)).min() >= energy:
                return _least(windows, energy), _least(windows, min(energy, CORE))
            if half == largest:
                raise too_large(largest, energy)
            half = math.ceil(1.3 * half) + 1


def too_large(largest: int, energy: float) -> ValueError:
    """Return what tells that windows would be too large."""
    return ValueError(
        f"the blur takes windows of more than {2 * largest + 1} pixels a side to hold {energy:g} of the light; stop "
        f"down, allow larger windows (largest={largest + 1} or more), or ask for less of it (energy=)"
    )


def lattice(ticks: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
    """Return all places of a lattice, shape (n, 3), the last coordinate fastest."""
    return np.stack([part.ravel() for part in np.meshgrid(*ticks, indexing="ij")], axis=1)


def overview(spans: Sequence[Span]) -> NDArray[np.float64]:
    """Return places all over the spans, shape (n, 3)."""
    return lattice([np.unique(np.linspace(*span, 5 if axis < 2 else 3)) for axis, span in enumerate(spans)])


def _least(windows: NDArray[np.float64], energy: float) -> int:
    """Return half of the least windows, of the same middles, that hold so much."""
    half = int(windows.shape[-1]) // 2
    while half > 0:
        inner = windows[:, 1:-1, 1:-1]
        if inner.sum(axis=(1, 2)).min() < energy:
            break
        windows, half = inner, half - 1
    return half
