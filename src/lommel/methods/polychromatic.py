"""Polychromatic images: the weighted sum over wavelengths, by any method."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import Declined, Intensities, Samples, ToleranceError, Wanted, not_met
from lommel.methods.choice import candidates, first_within_tolerance, of_profiles
from lommel.methods.method import Method, RadialMethod, storing, to_images
from lommel.optics.base_pupil import BasePupil
from lommel.optics.colour.spectrum import Component, Spectrum
from lommel.optics.grid import Grid


def sum_wavelengths(
    parts: Sequence[Component],
    shares: Array,
    compute: Callable[[Component, float], Intensities],
    method: Polychromatic,
    tol: float,
    window: bool = False,
) -> list[Intensities]:
    """Return sums over wavelengths of the intensities that `compute` returns, with errors of at most `tol`.

    Errors are relative to the peak of the sum or, with `window`, to its largest value in the window. The tolerance is
    guaranteed if `method.keeps_tol`.
    """
    # At a shorter wavelength light falls on a smaller area: I is proportional to 1 / wavelength^2.
    weights = shares * np.array([part.stretch**2 for part in parts])
    part_tol, least_tol = tol, (method.method or Method).least_tol
    while True:
        try:
            sums = _sums(parts, weights, compute, part_tol, window)
        except ToleranceError as fault:
            raise ToleranceError(
                f"tol={method.tol:g} cannot be met by a sum over wavelengths, whose images must each be accurate to "
                f"{part_tol:.2g} of the peak: {fault}"
            ) from None
        errors = [float(result.error.max()) for result in sums if result.error is not None]
        if not errors or not method.keeps_tol or (worst_error := max(errors)) <= tol:
            return sums
        # The error of each part is relative to the peak of the part; the peak of the sum may be below the sum of the
        # peaks.
        if part_tol <= least_tol:
            raise not_met(method.tol, worst_error, "the largest value in the window" if window else "the peak")
        # The next tolerance is reduced by the excess of the error, and halved for safety.
        part_tol = max(least_tol, part_tol * max(1e-3, 0.5 * tol / worst_error))


def _sums(
    parts: Sequence[Component],
    weights: Array,
    compute: Callable[[Component, float], Intensities],
    part_tol: float,
    window: bool,
) -> list[Intensities]:
    """Return weighted sums of intensities, and error bounds divided by lower bounds on the peaks of the sums.

    With `window`, peaks are the largest values in the window. Only one wavelength is in memory at a time.
    """
    sums: list[Array | None] = [None] * len(weights)
    tops, errors, bounded = [], [], [True] * len(weights)
    for k, part in enumerate(parts):
        result = compute(part, part_tol)
        tops.append(result.values.reshape(len(result.values), -1).max(axis=1) if result.peak is None else result.peak)
        errors.append(np.zeros(len(result.values)) if result.error is None else result.error)
        for c in np.flatnonzero(weights[:, k]):
            bounded[c] &= result.error is not None
            term, previous = weights[c, k] * result.values, sums[c]
            sums[c] = term if previous is None else np.add(previous, term, out=previous)
    results = []
    for row, values, has_bound in zip(weights, sums, bounded, strict=True):
        assert values is not None  # each sum has a wavelength with a positive weight
        highest = values.reshape(len(values), -1).max(axis=1)
        if not has_bound:
            results.append(Intensities(values, None, highest))
            continue
        indices = np.flatnonzero(row)
        # Certificate, section 9, last paragraph.
        error = (len(indices) + 8) * 2.0**-53 * highest  # roundings of weights, products and the sum
        error = error + sum(row[k] * errors[k] * tops[k] for k in indices)
        # Intensities are not negative: the sum is at least as bright as any of its parts.
        peak = highest if window else np.maximum(highest, np.max([row[k] * tops[k] for k in indices], axis=0))
        least_peak = peak - error
        relative = np.divide(error, least_peak, out=np.full(error.shape, np.inf), where=least_peak > 0)
        results.append(Intensities(values, relative, least_peak))
    return results


@dataclass(frozen=True, init=False)
class Polychromatic(Spectrum, RadialMethod[BasePupil]):
    r"""Incoherent sum over a spectrum, with another method for each wavelength.

    Supports pupils with a wavelength, the reference wavelength. The phases of a pupil are optical path differences:
    at another wavelength w, the phases and the v of a given radius are multiplied by ``wavelength / w``.

    Parameters
    ----------
    wavelengths : sequence of float
        Wavelengths in metres.
    weights : sequence of float, optional
        Fraction of the light at each wavelength, >= 0; normalized to a sum of 1. By default all are equal.
    method : Method, optional
        Method for each wavelength, by default chosen as by :func:`lommel.psf`, so that every pupil is supported.
    tol : float, optional
        Tolerance of the sum relative to its peak; guaranteed if the method of each wavelength has an error bound. By
        default the tolerance of `method`, or 1e-6.

    Raises
    ------
    TypeError, ValueError
        If a wavelength is invalid or none is given, if weights are negative, all 0 or of another number than the
        wavelengths, if `method` is polychromatic itself, or if `method` does not accept `tol`.

    Notes
    -----
    Each wavelength is computed separately, with a smaller tolerance if the error of the sum would otherwise exceed
    `tol`. ``normalize="strehl"`` is relative to the peak of the same spectrum without aberration.
    """

    pupils = "any"
    apodized = nonradial = any_aperture = True
    method: Method | None = None
    tol: float = Method.tol

    def __init__(
        self,
        wavelengths: Sequence[float],
        weights: Sequence[float] | None = None,
        method: Method | None = None,
        tol: float | None = None,
    ) -> None:
        super().__init__(wavelengths, weights)
        if not (method is None or isinstance(method, Method)) or isinstance(method, Polychromatic):
            raise TypeError(
                f"method must be a Method of one wavelength such as NijboerZernike(), got {validation.shown(method)}"
            )
        tol = None if tol is None else validation.real("tol", tol)
        if method is not None and tol is not None and tol != method.tol:
            method = method.with_tol(tol)
        tol = (method or Method).tol if tol is None else tol
        if method is None:
            tol = validation.real("tol", tol, least=self.least_tol, below=1e-1)
        object.__setattr__(self, "method", method)
        object.__setattr__(self, "tol", tol)

    @property
    def keeps_tol(self) -> bool:  # type: ignore[override]
        """True if error bounds never exceed `tol`, as with the method for each wavelength."""
        return (self.method or Method).keeps_tol

    @property
    def sampling(self) -> str:  # type: ignore[override]
        """Sampling of the method for each wavelength."""
        return (self.method or Method).sampling

    def unsupported(self, pupil: BasePupil) -> str | None:
        """Return the reason if the wavelength is unknown or the method does not support `pupil`, else None."""
        if pupil.wavelength is None:
            return "needs a pupil with a wavelength, the reference for the other wavelengths"
        if self.method is None:
            return None
        try:
            self.method.require(pupil)
        except Declined as fault:
            # The message begins with the name of the method; the remainder becomes a relative clause.
            name, reason = str(fault).split(" ", 1)
            return f"sums {name}, which {reason}"
        return None

    def unaberrated_peak(self, pupil: BasePupil) -> float:
        """Return the peak of the image of the same spectrum without aberration."""
        return pupil.amplitude**2 * sum(part.weight for part in self.components(pupil))

    def stretch(self, pupil: BasePupil) -> float:
        """Return the reference wavelength divided by the shortest wavelength."""
        return max(part.stretch for part in self.components(pupil))

    def along_radius(self, pupil: BasePupil) -> RadialMethod | None:
        """Return the sum itself if method and pupil are radial at every wavelength, else None."""
        radial = pupil.radial and isinstance(self.method, RadialMethod | None)
        return self if radial and all(part.pupil.radial for part in self.components(pupil)) else None

    def period(self, pupil: BasePupil) -> float:
        """Return the shortest period of the components of `pupil`; the sum of the components has no period."""
        period = Method.period if self.method is None else type(self.method).period
        return min(period(self.method or self, part.pupil) / part.stretch for part in self.components(pupil))

    def profile(self, pupil: BasePupil, v: Array) -> Intensities:
        """Return the weighted sum of I at rising v (of the reference wavelength)."""

        def compute(part: Component, tol: float) -> Intensities:
            method = of_profiles(tol) if self.method is None else self.method.tightened(tol)
            if not isinstance(method, RadialMethod):
                raise ValueError(
                    f"{type(method).__name__} has no radial profile; name a RadialMethod such as NijboerZernike()"
                )
            return method.profile(part.pupil, v * part.stretch)

        parts = self.components(pupil)
        return sum_wavelengths(parts, np.array([self.weights]), compute, self, self.tol)[0]

    def intensity(self, pupil: BasePupil, grid: Grid, threads: int) -> Intensities:
        """Return the weighted sum of I at the distinct radii or, if the grid is not symmetric, on the pixels."""
        return sum_spectra((self,), pupil, grid, threads, self.tol)[0]

    def images(self, pupil: BasePupil, grid: Grid, wanted: Wanted) -> Samples:
        """Return the images of the flattened stack; see :meth:`lommel.methods.Method.images`."""
        if wanted.powers or wanted.terms:
            raise ValueError(
                "derivatives are not available from Polychromatic.images; use derivatives= of lommel.psf"
            )
        target = self.tol - 1.1 * storing(wanted.dtype)
        # Division of values by their own largest value doubles the error; 0.48 instead of 0.5 leaves a reserve.
        target = target if wanted.scale is not None else 0.48 * target
        result = sum_spectra((self,), pupil, grid, wanted.threads, target, window=wanted.scale is None)
        return to_images(result[0], grid, wanted)


def sum_spectra(
    sums: Sequence[Polychromatic], pupil: BasePupil, grid: Grid, threads: int, tol: float, *, window: bool = False
) -> list[Intensities]:
    """Return the intensities of several sums, with each wavelength computed once for all sums."""
    columns = {w: k for k, w in enumerate(dict.fromkeys(w for spectrum in sums for w in spectrum.wavelengths))}
    parts = Spectrum(tuple(columns), np.ones(len(columns))).components(pupil)
    shares = np.zeros((len(sums), len(parts)))
    for row, spectrum in zip(shares, sums, strict=True):
        # A wavelength that a sum has twice counts twice: += on repeated indices would count it once.
        np.add.at(row, [columns[w] for w in spectrum.wavelengths], spectrum.weights)
    method = sums[0].method
    # With lateral colour some components are off the axis, and share no radii with the others.
    equal_symmetry = all(part.pupil.radial == pupil.radial for part in parts)

    def compute(part: Component, tol: float) -> Intensities:
        methods = candidates(part.pupil, grid, tol) if method is None else (method.tightened(tol),)
        result = first_within_tolerance(methods, lambda candidate: candidate.intensity(part.pupil, grid, threads))[1]
        if equal_symmetry or result.values.ndim == 3:
            return result
        values = np.empty((len(result.values), *grid.shape))
        grid.paint(result.values, np.ones(len(values)), values)
        return result._replace(values=values)

    return sum_wavelengths(parts, shares, compute, sums[0], tol, window)
