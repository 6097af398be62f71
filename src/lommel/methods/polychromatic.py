"""Polychromatic images: the weighted sum over wavelengths, by any method."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import Declined, Images, Intensities, ToleranceError, Wanted, not_met
from lommel.methods.choice import candidates, first_within_tolerance, of_profiles
from lommel.methods.method import Method, RadialMethod, storing, to_images
from lommel.optics.base_pupil import BasePupil
from lommel.optics.colour.spectrum import Component, Spectrum
from lommel.optics.grid import Grid


def mixed(
    parts: Sequence[Component],
    shares: Array,
    ask: Callable[[Component, float], Intensities],
    way: Polychromatic,
    tol: float,
    window: bool = False,
) -> list[Intensities]:
    """Return sums over wavelengths of the answers of `ask`, each to `tol` over its peak.

    With `window`, over its largest value in the window; this is a contract if `way` keeps its tolerance.
    """
    # At a shorter wavelength the same light falls on a smaller area: I relative to the reference grows as 1 /
    # lambda^2.
    weights = shares * np.array([part.stretch**2 for part in parts])
    asked, least = tol, (way.method or Method).least_tol
    while True:
        try:
            made = _sums(parts, weights, ask, asked, window)
        except ToleranceError as fault:
            raise ToleranceError(
                f"tol={way.tol:g} cannot be met by a sum over wavelengths each of which must be exact to "
                f"{asked:.2g} of its peak: {fault}"
            ) from None
        errors = [float(each.error.max()) for each in made if each.error is not None]
        if not errors or not way.keeps_tol or (worst := max(errors)) <= tol:
            return made
        # Each part is within the tolerance of its own peak; the peak of the sum may be below the sum of their peaks.
        if asked <= least:
            raise not_met(way.tol, worst, "the largest value in the window" if window else "the peak")
        # The next tolerance follows the excess of the error, halved for safety.
        asked = max(least, asked * max(1e-3, min(0.5, 0.5 * tol / worst)))


def _sums(
    parts: Sequence[Component],
    weights: Array,
    ask: Callable[[Component, float], Intensities],
    asked: float,
    window: bool,
) -> list[Intensities]:
    """Return weighted sums of intensities, and their errors over lower bounds on their peaks.

    With `window`, over lower bounds on their largest values in the window. Only one part is in memory at a time.
    """
    sums: list[Array | None] = [None] * len(weights)
    tops, errors, bounded = [], [], [True] * len(weights)
    for k, part in enumerate(parts):
        made = ask(part, asked)
        tops.append(made.values.reshape(len(made.values), -1).max(axis=1) if made.peak is None else made.peak)
        errors.append(np.zeros(len(made.values)) if made.error is None else made.error)
        for c in np.flatnonzero(weights[:, k]):
            bounded[c] &= made.error is not None
            term, before = weights[c, k] * made.values, sums[c]
            sums[c] = term if before is None else np.add(before, term, out=before)
    found = []
    for row, values, known in zip(weights, sums, bounded, strict=True):
        assert values is not None  # each sum has light at some wavelength
        highest = values.reshape(len(values), -1).max(axis=1)
        if not known:
            found.append(Intensities(values, None, highest))
            continue
        used = np.flatnonzero(row)
        # Certificate, section 9, last paragraph.
        off = (len(used) + 8) * 2.0**-53 * highest  # roundings of weights, products and the sum
        off = off + sum(row[k] * errors[k] * tops[k] for k in used)
        # Intensities are not negative: the sum is at least as bright as any of its parts.
        peak = highest if window else np.maximum(highest, np.max([row[k] * tops[k] for k in used], axis=0))
        least = peak - off
        relative = np.divide(off, least, out=np.full(off.shape, np.inf), where=least > 0)
        found.append(Intensities(values, relative, least))
    return found


@dataclass(frozen=True, init=False)
class Polychromatic(Spectrum, RadialMethod[BasePupil]):
    r"""Incoherent sum over a spectrum, each wavelength by another method.

    Supports pupils with a wavelength, the reference: their phases are optical path differences, which at another
    wavelength are ``wavelength / other`` times as many radians, and v at a given radius scales alike.

    Parameters
    ----------
    wavelengths : sequence of float
        Metres.
    weights : sequence of float, optional
        Share of the light at each wavelength, >= 0; made to sum to 1. By default all are equal.
    method : Method, optional
        By default chosen for the pupil at each wavelength as by :func:`lommel.psf`, so that every pupil is supported.
    tol : float, optional
        Tolerance of the sum relative to its peak: a contract if all parts have a bound. By default that of the
        method, or 1e-6.

    Raises
    ------
    TypeError, ValueError
        If a wavelength is invalid or none is given, if weights are negative, all 0 or not one for each wavelength, or
        if `method` is not for one wavelength, or has no such tolerance.

    Notes
    -----
    Each wavelength is computed separately, with a smaller tolerance if the errors together would exceed that of the
    sum. ``normalize="strehl"`` is relative to the same spectrum without aberration.
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
        """Tolerance contract of the method."""
        return (self.method or Method).keeps_tol

    @property
    def sampling(self) -> str:  # type: ignore[override]
        """Sampling of the method."""
        return (self.method or Method).sampling

    def unsupported(self, pupil: BasePupil) -> str | None:
        """Return the reason if the reference wavelength is unknown, or if the method gives one."""
        if pupil.wavelength is None:
            return "needs a pupil with a wavelength, to which the others are related"
        if self.method is None:
            return None
        try:
            self.method.require(pupil)
        except Declined as fault:
            # The message of the method begins with its name; it becomes a relative clause.
            name, reason = str(fault).split(" ", 1)
            return f"sums {name}, which {reason}"
        return None

    def unaberrated_peak(self, pupil: BasePupil) -> float:
        """Return the peak of the same spectrum without aberration."""
        return pupil.amplitude**2 * sum(part.weight for part in self.components(pupil))

    def stretch(self, pupil: BasePupil) -> float:
        """Return the reference wavelength over the shortest."""
        return max(part.stretch for part in self.components(pupil))

    def along_radius(self, pupil: BasePupil) -> RadialMethod | None:
        """Return the sum itself if method and pupil are radial at every wavelength, else None."""
        radial = pupil.radial and isinstance(self.method, RadialMethod | None)
        return self if radial and all(part.pupil.radial for part in self.components(pupil)) else None

    def period(self, pupil: BasePupil) -> float:
        """Return the shortest period of the components of `pupil`; their sum has none."""
        way = Method.period if self.method is None else type(self.method).period
        return min(way(self.method or self, part.pupil) / part.stretch for part in self.components(pupil))

    def profile(self, pupil: BasePupil, v: Array) -> Intensities:
        """Return the weighted sum of I at rising v (of the reference wavelength)."""

        def ask(part: Component, tol: float) -> Intensities:
            way = of_profiles(tol) if self.method is None else self.method.tightened(tol)
            if not isinstance(way, RadialMethod):
                raise ValueError(
                    f"{type(way).__name__} has no radial profile; name a RadialMethod such as NijboerZernike()"
                )
            return way.profile(part.pupil, v * part.stretch)

        parts = self.components(pupil)
        return mixed(parts, np.array([self.weights]), ask, self, self.tol)[0]

    def intensity(self, pupil: BasePupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return the weighted sum of I at the distinct radii of `grid`, or on its pixels where these share none."""
        return together((self,), pupil, grid, threads, self.tol)[0]

    def images(self, pupil: BasePupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see :meth:`lommel.Method.images`."""
        if wanted.powers or wanted.terms:
            raise ValueError(
                "derivatives of white light are sums of those of its components; ask lommel.psf for them"
            )
        aim = self.tol - 1.1 * storing(wanted.dtype)
        # Values divided by their own largest one have twice the error; 0.48 leaves a reserve.
        aim = aim if wanted.scale is not None else 0.48 * aim
        made = together((self,), pupil, grid, wanted.threads, aim, window=wanted.scale is None)
        return to_images(made[0], grid, wanted)


def together(
    sums: Sequence[Polychromatic], pupil: BasePupil, grid: Grid, threads: int, tol: float, *, window: bool = False
) -> list[Intensities]:
    """Return the intensities of several sums, each wavelength computed once for all of them."""
    places = {w: k for k, w in enumerate(dict.fromkeys(w for each in sums for w in each.wavelengths))}
    parts = Spectrum(tuple(places), np.ones(len(places))).components(pupil)
    shares = np.zeros((len(sums), len(parts)))
    for row, each in zip(shares, sums, strict=True):
        # A wavelength that a sum names twice counts twice: += on repeated indices would count it once.
        np.add.at(row, [places[w] for w in each.wavelengths], each.weights)
    method = sums[0].method
    # With lateral colour some components are off the axis, and have no radii in common with the others.
    alike = all(part.pupil.radial == pupil.radial for part in parts)

    def ask(part: Component, tol: float) -> Intensities:
        ways = candidates(part.pupil, grid, tol) if method is None else (method.tightened(tol),)
        made = first_within_tolerance(ways, lambda way: way.intensity(part.pupil, grid, threads))[1]
        if alike or made.values.ndim == 3:
            return made
        values = np.empty((len(made.values), *grid.shape))
        grid.paint(made.values, np.ones(len(values)), values)
        return made._replace(values=values)

    return mixed(parts, shares, ask, sums[0], tol, window)
