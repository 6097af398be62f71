"""Light of several wavelengths: the weighted sum of what each makes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.core.answers import Intensities, not_met
from lommel.methods.choice import SERIES, choose
from lommel.methods.method import Method, RadialMethod
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil


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
    method : Method, optional
        By default what :func:`lommel.psf` would take for the pupil at each wavelength, so that every pupil is
        supported. Its tolerance is that of the sum.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    Each wavelength is sampled or averaged over the pixels on its own. ``normalize="strehl"`` is relative to the same
    spectrum without aberration.
    """

    apodized: ClassVar[bool] = True
    nonradial: ClassVar[bool] = True
    any_aperture: ClassVar[bool] = True
    wavelengths: tuple[float, ...]
    weights: tuple[float, ...]
    method: Method | None = None

    def __init__(self, wavelengths: Sequence[float], weights: Sequence[float], method: Method | None = None) -> None:
        waves = tuple(validation.wavelength(w) for w in np.atleast_1d(validation.array("wavelengths", wavelengths)))
        shares = validation.real_array("weights", weights, least=0.0)
        if shares.shape != (len(waves),) or not waves or not shares.max() > 0:
            raise ValueError(
                f"weights must be one for each of the {len(waves)} wavelengths, and not all 0, "
                f"got {validation.shown(weights)}"
            )
        if not (method is None or isinstance(method, Method)) or isinstance(method, Polychromatic):
            raise TypeError(
                f"method must be a Method of one wavelength such as NijboerZernike(), got {validation.shown(method)}"
            )
        shares = shares / shares.max()  # whose sum cannot overflow
        object.__setattr__(self, "wavelengths", waves)
        object.__setattr__(self, "weights", tuple((shares / shares.sum()).tolist()))
        object.__setattr__(self, "method", method)

    @property
    def keeps_tol(self) -> bool:  # type: ignore[override]
        """That of the method."""
        return (self.method or SERIES).keeps_tol

    @property
    def tol(self) -> float:  # type: ignore[override]
        """Tolerance of the method."""
        return (self.method or SERIES).tol

    @property
    def sampling(self) -> str:  # type: ignore[override]
        """That of the method."""
        return (self.method or SERIES).sampling

    def tightened(self) -> Polychromatic:
        """Return the same sum with half the tolerance; by the series, if no method was named."""
        return replace(self, method=(self.method or SERIES).tightened())

    def unsupported(self, pupil: Pupil) -> str | None:
        """Return the reason where the reference wavelength is unknown, or where the method gives one."""
        if pupil.wavelength is None:
            return "needs a pupil with a wavelength, to which the others are related"
        if self.method is None:
            return None
        try:
            self.method.require(pupil)
        except ValueError as fault:
            name, reason = str(fault).split(" ", 1)
            return f"sums {name}, which {reason}"
        return None

    def unaberrated_peak(self, pupil: Pupil) -> float:
        """Return the peak of the same spectrum without aberration."""
        return pupil.amplitude**2 * sum(share * scale**2 for share, scale, _ in self.parts(pupil))

    def stretch(self, pupil: Pupil) -> float:
        """Return the reference wavelength over the shortest."""
        return max(scale for _, scale, _ in self.parts(pupil))

    def along_radius(self, pupil: Pupil) -> RadialMethod | None:
        """Return the sum itself where pupil and method are radial."""
        return self if pupil.radial and isinstance(self.method or SERIES, RadialMethod) else None

    def parts(self, pupil: Pupil) -> list[tuple[float, float, Pupil]]:
        """Return the share of each wavelength, the reference over it, and the pupil there.

        ValueError if `pupil` has no wavelength.

        Phases are path differences: in radians they grow as the wavelength falls.
        """
        if pupil.wavelength is None:
            raise ValueError(f"pupil {self.unsupported(pupil)}")
        wavefront = pupil.wavefront
        return [
            (share, pupil.wavelength / w, replace(pupil, wavefront=pupil.wavelength / w * wavefront, wavelength=w))
            for w, share in zip(self.wavelengths, self.weights, strict=True)
        ]

    def profile(self, pupil: Pupil, v: NDArray[np.float64]) -> Intensities:
        """Return the weighted sum of I at rising v (of the reference wavelength)."""
        way = self.method or SERIES
        if not isinstance(way, RadialMethod):
            raise ValueError(
                f"{type(way).__name__} has no radial profile; name a RadialMethod such as NijboerZernike()"
            )
        made = _summed((share * scale**2, way.profile(part, v * scale)) for share, scale, part in self.parts(pupil))
        return self._proven(made)

    def intensity(self, pupil: Pupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return the weighted sum of I at the distinct radii of `grid`, or on its pixels where these share none."""
        for halvings in range(8):
            made = self._sum(pupil, grid, threads, halvings)
            # Each part is within the tolerance of its own peak; that of the sum may be lower than theirs together.
            if made.error is None or made.error.max() <= self.tol:
                break
        return self._proven(made)

    def window_intensity(self, pupil: Pupil, grid: Grid, threads: int, tol: float) -> Intensities:
        """Return the sum on the pixels of `grid`, to `tol` of the largest value in the window."""
        for halvings in range(12):
            made = self._sum(pupil, grid, threads, halvings)
            if made.error is None or made.peak is None:
                return made
            off = made.error * made.peak
            least = made.values.max(axis=(1, 2)) - off
            relative = np.divide(off, least, out=np.full(off.shape, np.inf), where=least > 0)
            if relative.max() <= tol:
                return Intensities(made.values, relative, least)
        raise not_met(self.tol, float(relative.max()), "the largest value in the window")

    def _sum(self, pupil: Pupil, grid: Grid, threads: int, halvings: int) -> Intensities:
        return _summed(
            (share * scale**2, self._way(part, grid, halvings).intensity(part, grid, threads))
            for share, scale, part in self.parts(pupil)
        )

    def _way(self, part: Pupil, grid: Grid, halvings: int) -> Method:
        way = choose(part, grid) if self.method is None else self.method
        for _ in range(halvings):
            way = way.tightened()
        return way

    def _proven(self, made: Intensities) -> Intensities:
        if made.error is not None and made.error.max() > self.tol:
            raise not_met(self.tol, float(made.error.max()), "the peak")
        return made


def _summed(parts: Iterable[tuple[float, Intensities]]) -> Intensities:
    """Return the sum of weighted intensities, its error over a lower bound on its peak, and that."""
    values: Any = 0.0
    error: Any = 0.0
    peak: Any = 0.0
    for weight, part in parts:
        top = weight * (part.values.reshape(len(part.values), -1).max(axis=1) if part.peak is None else part.peak)
        values = values + weight * part.values
        # Nothing is negative, so the sum is at least as bright as any part of it.
        peak = np.maximum(peak, top)
        error = None if error is None or part.error is None else error + part.error * top
    peak = np.maximum(peak, values.reshape(len(values), -1).max(axis=1))
    if error is not None:
        error = np.divide(error, peak, out=np.full(peak.shape, np.inf), where=peak > 0)
    return Intensities(values, error, peak)
