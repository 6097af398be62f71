"""Light of several wavelengths: the weighted sum of what each makes, by any method."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.core.answers import Images, Intensities, ToleranceError, Wanted, not_met
from lommel.methods.choice import candidates, first_proven, of_profiles
from lommel.methods.method import Method, RadialMethod, painted, storing
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.optics.spectrum import Component, Spectrum


@dataclass(frozen=True, init=False)
class Polychromatic(Spectrum, RadialMethod):
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
        supported.
    tol : float, optional
        Tolerance of the sum, over its peak: where all parts have a bound it is a contract, as theirs are. By default
        that of the method, or 1e-6.

    Raises
    ------
    TypeError, ValueError
        On what is no wavelength, if the weights are not one for each, negative or all 0, or if `method` is none of
        one wavelength, or has no such tolerance.

    Notes
    -----
    Each wavelength is sampled or averaged over the pixels on its own, and asked for a smaller error where the errors
    together would exceed the tolerance. ``normalize="strehl"`` is relative to the same spectrum without aberration.
    """

    layered: ClassVar[bool | None] = None
    apodized: ClassVar[bool] = True
    nonradial: ClassVar[bool] = True
    any_aperture: ClassVar[bool] = True
    method: Method | None = None
    tol: float = Method.tol

    def __init__(
        self,
        wavelengths: Sequence[float],
        weights: Sequence[float],
        method: Method | None = None,
        tol: float | None = None,
    ) -> None:
        super().__init__(wavelengths, weights)
        if not (method is None or isinstance(method, Method)) or isinstance(method, Polychromatic):
            raise TypeError(
                f"method must be a Method of one wavelength such as NijboerZernike(), got {validation.shown(method)}"
            )
        if method is not None and tol is not None and tol != method.tol:
            method = method.with_tol(tol)
        tol = (method or Method).tol if tol is None else tol
        if method is None:
            tol = validation.real("tol", tol, least=self.least_tol, below=1e-1)
        object.__setattr__(self, "method", method)
        object.__setattr__(self, "tol", tol)

    @property
    def keeps_tol(self) -> bool:  # type: ignore[override]
        """That of the method."""
        return (self.method or Method).keeps_tol

    @property
    def sampling(self) -> str:  # type: ignore[override]
        """That of the method."""
        return (self.method or Method).sampling

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
        return pupil.amplitude**2 * sum(part.weight for part in self.components(pupil))

    def stretch(self, pupil: Pupil) -> float:
        """Return the reference wavelength over the shortest."""
        return max(part.stretch for part in self.components(pupil))

    def along_radius(self, pupil: Pupil) -> RadialMethod | None:
        """Return the sum itself where pupil and method are radial."""
        return self if pupil.radial and isinstance(self.method, RadialMethod | None) else None

    def profile(self, pupil: Pupil, v: NDArray[np.float64]) -> Intensities:
        """Return the weighted sum of I at rising v (of the reference wavelength)."""

        def ask(part: Component, tol: float) -> Intensities:
            way = of_profiles(tol) if self.method is None else self.method.tightened(tol)
            if not isinstance(way, RadialMethod):
                raise ValueError(
                    f"{type(way).__name__} has no radial profile; name a RadialMethod such as NijboerZernike()"
                )
            return way.profile(part.pupil, v * part.stretch)

        return self._summed(pupil, ask, self.tol)

    def intensity(self, pupil: Pupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return the weighted sum of I at the distinct radii of `grid`, or on its pixels where these share none."""
        return self._recorded(pupil, grid, threads, self.tol)

    def images(self, pupil: Pupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see :meth:`Method.images`."""
        if wanted.powers or wanted.terms:
            raise ValueError(
                "derivatives of white light are sums of those of its components; ask lommel.psf for them"
            )
        aim = self.tol - 1.1 * storing(wanted.dtype)
        # Values divided by their own largest one are off by twice as much, and by nothing over the peak elsewhere.
        aim = aim if wanted.scale is not None else 0.48 * aim
        made = self._recorded(pupil, grid, wanted.threads, aim, window=wanted.scale is None)
        return painted(made, grid, wanted)

    def _recorded(self, pupil: Pupil, grid: Grid, threads: int, tol: float, *, window: bool = False) -> Intensities:
        def ask(part: Component, tol: float) -> Intensities:
            ways = candidates(part.pupil, grid, tol) if self.method is None else (self.method.tightened(tol),)
            return first_proven(ways, lambda way: way.intensity(part.pupil, grid, threads))[1]

        return self._summed(pupil, ask, tol, window=window)

    def _summed(
        self, pupil: Pupil, ask: Callable[[Component, float], Intensities], tol: float, *, window: bool = False
    ) -> Intensities:
        """Return the sum of what is asked for each wavelength, to `tol` of its peak or of its largest value."""
        parts, asked = self.components(pupil), tol
        least = (self.method or Method).least_tol
        while True:
            try:
                made = _sum(parts, [ask(part, asked) for part in parts], window=window)
            except ToleranceError as fault:
                raise ToleranceError(
                    f"tol={self.tol:g} cannot be met by a sum over wavelengths each of which must be exact to "
                    f"{asked:.2g} of its peak: {fault}"
                ) from None
            if made.error is None or not self.keeps_tol or (worst := float(made.error.max())) <= tol:
                return made
            # Each part is within the tolerance of its own peak; that of the sum may be lower than theirs together.
            if asked <= least:
                raise not_met(self.tol, worst, "the largest value in the window" if window else "the peak")
            asked = max(least, asked * max(1e-3, min(0.5, 0.5 * tol / worst)))


def _sum(parts: list[Component], found: list[Intensities], *, window: bool) -> Intensities:
    """Return the sum of weighted intensities, and its error over what its peak is at least.

    Or, with `window`, over what the largest value in the window is at least.
    """
    weights = [part.weight for part in parts]
    values = np.sum([weight * made.values for weight, made in zip(weights, found, strict=True)], axis=0)
    highest = values.reshape(len(values), -1).max(axis=1)
    peak, off = highest, (len(parts) + 8) * 2.0**-53 * highest  # what weights, products and the sum are rounded by
    for weight, made in zip(weights, found, strict=True):
        if made.error is None:
            return Intensities(values, None, highest)
        top = made.values.reshape(len(values), -1).max(axis=1) if made.peak is None else made.peak
        off = off + weight * made.error * top
        if not window:
            # Nothing is negative, so the sum is at least as bright as any part of it.
            peak = np.maximum(peak, weight * top)
    least = peak - off
    return Intensities(values, np.divide(off, least, out=np.full(off.shape, np.inf), where=least > 0), least)
