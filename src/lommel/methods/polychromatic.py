"""Light of several wavelengths: the weighted sum of what each makes, by any method."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.core.answers import Images, Intensities, Wanted
from lommel.methods.choice import candidates, first_proven, of_profiles
from lommel.methods.method import Method, RadialMethod, painted, storing
from lommel.methods.mixing import Contract, mixed
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
    weights : sequence of float, optional
        Share of the light at each wavelength, >= 0; made to sum to 1. By default all are equal.
    method : Method, optional
        By default what :func:`lommel.psf` would take for the pupil at each wavelength, so that every pupil is
        supported.
    tol : float, optional
        Tolerance of the sum, over its peak: where all parts have a bound it is a contract, as theirs are. By default
        that of the method, or 1e-6.

    Raises
    ------
    TypeError, ValueError
        On what is no wavelength or none at all, if the weights are not one for each, negative or all 0, or if
        `method` is none of one wavelength, or has no such tolerance.

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
        """Return the sum itself where method and pupil are radial, in every light."""
        radial = pupil.radial and isinstance(self.method, RadialMethod | None)
        return self if radial and all(part.pupil.radial for part in self.components(pupil)) else None

    def profile(self, pupil: Pupil, v: NDArray[np.float64]) -> Intensities:
        """Return the weighted sum of I at rising v (of the reference wavelength)."""

        def ask(part: Component, tol: float) -> Intensities:
            way = of_profiles(tol) if self.method is None else self.method.tightened(tol)
            if not isinstance(way, RadialMethod):
                raise ValueError(
                    f"{type(way).__name__} has no radial profile; name a RadialMethod such as NijboerZernike()"
                )
            return way.profile(part.pupil, v * part.stretch)

        parts = self.components(pupil)
        return mixed(parts, np.array([self.weights]), ask, self.contract(self.tol))[0]

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
        return together((self,), pupil, grid, threads, tol, window=window)[0]

    def contract(self, tol: float, *, window: bool = False) -> Contract:
        """Return what is promised of the sum: `tol` over its peak, or over its largest value in the `window`."""
        return Contract(tol, self.tol, (self.method or Method).least_tol, self.keeps_tol, window)


def together(
    sums: Sequence[Polychromatic], pupil: Any, grid: Grid, threads: int, tol: float, *, window: bool = False
) -> list[Intensities]:
    """Return the intensities of several sums, each wavelength computed once for all of them.

    Parameters
    ----------
    sums : sequence of Polychromatic
        By one method, to one tolerance.
    pupil : Pupil
    grid : Grid
    threads : int
    tol : float
        Over the peak of each sum.
    window : bool, default False
        Whether over its largest value in the window instead.

    Returns
    -------
    list of Intensities
        At the distinct radii of `grid`, or on its pixels.

    Raises
    ------
    ToleranceError
        If the tolerance cannot be met.
    """
    places = {w: k for k, w in enumerate(dict.fromkeys(w for each in sums for w in each.wavelengths))}
    parts = Spectrum(tuple(places), np.ones(len(places))).components(pupil)
    shares = np.zeros((len(sums), len(parts)))
    for row, each in zip(shares, sums, strict=True):
        np.add.at(row, [places[w] for w in each.wavelengths], each.weights)
    method = sums[0].method
    # Colours of which some lie beside the axis have no radii in common.
    alike = all(part.pupil.radial == pupil.radial for part in parts)

    def ask(part: Component, tol: float) -> Intensities:
        ways = candidates(part.pupil, grid, tol) if method is None else (method.tightened(tol),)
        made = first_proven(ways, lambda way: way.intensity(part.pupil, grid, threads))[1]
        if alike or made.values.ndim == 3:
            return made
        values = np.empty((len(made.values), *grid.shape))
        grid.paint(made.values, np.ones(len(values)), values)
        return made._replace(values=values)

    return mixed(parts, shares, ask, sums[0].contract(tol, window=window))
