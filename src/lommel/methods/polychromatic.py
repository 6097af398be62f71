"""Light of several wavelengths: the weighted sum of what each makes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from lommel import validation
from lommel.grid import Grid
from lommel.methods.method import Intensities, RadialMethod, ToleranceError
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.pupil import Pupil


@dataclass(frozen=True, init=False)
class Polychromatic(RadialMethod):
    r"""Incoherent sum over a spectrum, each wavelength by another method.

    Supports pupils with a wavelength, the reference: their phases are optical path differences, which at another
    wavelength are ``wavelength / other`` times as many radians, and v at a given radius scales alike.

    Parameters
    ----------
    wavelengths : sequence of float
        Metres.
    weights : sequence of float
        Share of the light at each wavelength, >= 0; made to sum to 1.
    method : RadialMethod, default NijboerZernike()
        Its tolerance is that of the sum.

    Notes
    -----
    ``normalize="strehl"`` is relative to the same spectrum without aberration.
    """

    apodized: ClassVar[bool] = True
    nonradial: ClassVar[bool] = True
    wavelengths: tuple[float, ...]
    weights: tuple[float, ...]
    method: RadialMethod = field(default_factory=NijboerZernike)

    def __init__(
        self, wavelengths: Sequence[float], weights: Sequence[float], method: RadialMethod | None = None
    ) -> None:
        waves = tuple(validation.wavelength(w) for w in np.atleast_1d(wavelengths))
        shares = validation.real_array("weights", weights, least=0.0)
        if shares.shape != (len(waves),) or not waves or not shares.sum() > 0:
            raise ValueError(
                f"weights must be one for each of the {len(waves)} wavelengths, and not all 0, "
                f"got {validation.shown(weights)}"
            )
        way = NijboerZernike() if method is None else method
        if not isinstance(way, RadialMethod):
            raise TypeError(f"method must be a RadialMethod such as NijboerZernike(), got {validation.shown(way)}")
        object.__setattr__(self, "wavelengths", waves)
        object.__setattr__(self, "weights", tuple((shares / shares.sum()).tolist()))
        object.__setattr__(self, "method", way)

    @property
    def tol(self) -> float:  # type: ignore[override]
        """Tolerance of the method."""
        return self.method.tol

    def tightened(self) -> Polychromatic:
        """Return the same sum with half the tolerance."""
        return replace(self, method=self.method.tightened())

    def unsupported(self, pupil: Pupil) -> str | None:
        """Return the reason where the reference wavelength is unknown, or where the method gives one."""
        if pupil.wavelength is None:
            return "needs a pupil with a wavelength, to which the others are related"
        if pupil.apodization and not self.method.apodized:
            return f"sums {type(self.method).__name__}, which supports uniform illumination only"
        if not pupil.radial and not self.method.nonradial:
            return f"sums {type(self.method).__name__}, which supports radially symmetric pupils only"
        return self.method.unsupported(pupil)

    def unaberrated_peak(self, pupil: Pupil) -> float:
        """Return the peak of the same spectrum without aberration."""
        return pupil.amplitude**2 * sum(w * s**2 for w, s in zip(self.weights, self._scales(pupil), strict=True))

    def profile(self, pupil: Pupil, v: NDArray[np.float64]) -> Intensities:
        """Return the weighted sum of I at rising v (of the reference wavelength)."""
        total = np.zeros((len(pupil.coefficients()), v.size))
        error: NDArray[np.float64] | None = np.zeros(len(total))
        for weight, scale in zip(self.weights, self._scales(pupil), strict=True):
            values, bound, peak = self.method.profile(_at(pupil, scale), v * scale)
            total += weight * scale**2 * values
            if error is None or bound is None or peak is None:
                error = None
            else:
                error = error + weight * scale**2 * bound * peak
        top = total.max(axis=1)
        if error is None:
            return Intensities(total, None, top)
        relative = np.divide(error, top, out=np.full(top.shape, np.inf), where=top > 0)
        return Intensities(total, self._proven(relative), top)

    def intensity(self, pupil: Pupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return the weighted sum of I at the distinct radii of `grid`, or on its pixels where these share none."""
        if pupil.radial:
            return super().intensity(pupil, grid, threads)
        total = np.zeros((math.prod(pupil.shape), *grid.shape))
        error = np.zeros(len(total))
        for weight, scale in zip(self.weights, self._scales(pupil), strict=True):
            # Divided by the largest value in the window, which then is what the bounds are related to.
            made = self.method.images(_at(pupil, scale), grid, None, np.float64, threads=threads)
            bright = weight * scale**2 / made.scale
            total += bright[:, None, None] * made.values
            error += bright * (np.inf if made.error is None else made.error)
        relative = error / total.max(axis=(1, 2))
        return Intensities(total, self._proven(relative))

    def _proven(self, relative: NDArray[np.float64]) -> NDArray[np.float64]:
        if relative.max() > self.tol:
            raise ToleranceError(
                f"tol={self.tol:g} cannot be met: the bound on the error is {relative.max():.2g} of the largest "
                "value in the window"
            )
        return relative

    def _scales(self, pupil: Pupil) -> list[float]:
        assert pupil.wavelength is not None
        return [pupil.wavelength / w for w in self.wavelengths]


def _at(pupil: Pupil, scale: float) -> Pupil:
    """Return the pupil at the reference wavelength over `scale`."""
    assert pupil.wavelength is not None
    wavefront = scale * pupil.wavefront.flattened()
    return replace(pupil, wavefront=wavefront, wavelength=pupil.wavelength / scale)
