"""Plane layers between a microscope's objective and its sample, and the phase and amplitude of plane waves.

A plane wave has ``NA rho = n sin(theta)`` in every layer and ``c_m = cos(theta_m) = sqrt(1 - (NA rho / n_m)^2)`` in
layer m. The imaginary part of c_m is not negative: with the time factor ``exp(-i omega t)``, light beyond the
critical angle decays with the distance from the glass. All formulas accept arrays and, for error bounds,
:class:`lommel.special.disc_arithmetic.Disc`.

References
----------
S. F. Gibson and F. Lanni, J. Opt. Soc. Am. A 9, 154 (1992), doi:10.1364/JOSAA.9.000154: the phase.
P. Torok, P. Varga, Z. Laczik and G. R. Booker, J. Opt. Soc. Am. A 12, 325 (1995), doi:10.1364/JOSAA.12.000325: the
amplitudes of the vectorial integrals.
M. Born and E. Wolf, *Principles of Optics*, 7th ed., section 1.6: characteristic matrices of films.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.special import disc_arithmetic

# An array of complex numbers or a Disc.
Values = Any


class Amplitudes(NamedTuple):
    """Amplitudes of s and p waves transmitted to the sample, and the denominators of their formulas."""

    s: Values
    p: Values
    denominators: tuple[Values, ...]
    """The amplitudes are analytic at all points at which no denominator is 0."""


@dataclass(frozen=True)
class Layers:
    """NA, refractive indices, films and paths of a microscope, at a wavelength in vacuum (metres).

    Films and paths are pairs (index, thickness in metres). Films are listed from the glass to the sample. Paths do
    not depend on depth and focus; the thicknesses of the objective's design are negative. The objective has the
    amplitude ``exp(-(g_0 + g_1 rho^2 + ...))`` with the coefficients g in `exponent`.
    """

    NA: float
    immersion: float
    glass: float
    sample: float
    films: tuple[tuple[float, float], ...]
    paths: tuple[tuple[float, float], ...]
    wavelength: float
    exponent: tuple[float, ...] = ()

    @property
    def wavenumber(self) -> float:
        """``2 pi / lambda``, 1/metres."""
        return 2.0 * math.pi / self.wavelength

    def cosine(self, rho: NDArray[np.float64]) -> Callable[[float], NDArray[np.complex128]]:
        """Return the function that computes the cosine c_m at rho from the index of a layer."""
        return lambda index: cosines(self.NA, rho, index)

    def rates(self, cosine: Callable[[float], Values]) -> tuple[Values, Values, Values]:
        """Return the phase at depth 0 and focus 0, and its derivatives by depth and focus, 1/metres.

        The phase of a plane wave from the emitter, ``exp(i psi - i omega t)``, without the phase due to films, is
        ``psi = k (d n_s c_s + t_g n_g c_g - t_g0 n_g0 c_g0 + t_i n_i c_i - t_i0 n_i0 c_i0)``, with ``t_i = n_i (t_g0
        / n_g0 + t_i0 / n_i0 - t_g / n_g) - f``, where d is the depth, f the focus, t a thickness and 0 marks the
        design.
        """
        k = self.wavenumber
        by_focus = cosine(self.immersion) * (-k * self.immersion)
        phase0 = by_focus * 0.0
        for index, thickness in self.paths:
            phase0 = phase0 + cosine(index) * (k * index * thickness)
        return phase0, cosine(self.sample) * (k * self.sample), by_focus

    def middle_rates(self) -> tuple[float, float]:
        """Return the means of the real parts of the derivatives in :meth:`rates` at rho = 0 and rho = 1."""
        # Constants change no intensity; subtracting the middle of the range makes bounds smaller.
        _, *rates = self.rates(self.cosine(np.array([0.0, 1.0])))
        by_depth, by_focus = (0.5 * float(rate.real.sum()) for rate in rates)
        return by_depth, by_focus

    def amplitudes(self, cosine: Callable[[float], Values], square: Values) -> Amplitudes:
        """Return the amplitudes at `square` = ``(NA rho)^2``; waves interfere in films, not in the thick glass."""
        indices = (self.immersion, self.glass, self.sample)
        # Fresnel amplitudes; glass and immersion of equal index have no surface between them.
        c_i, c_g, c_s = (cosine(index) for index in indices)
        n_i, n_g, n_s = indices
        if n_g == n_i:
            t_s, t_p = 1.0, 1.0
            surface: tuple[Values, ...] = ()
        else:
            surface = (c_i * n_i + c_g * n_g, c_i * n_g + c_g * n_i)
            t_s, t_p = (c_i * (2.0 * n_i) / denominator for denominator in surface)
        at_s = self._denominator(square, c_g * n_g, c_s * n_s, "s")
        at_p = self._denominator(square, c_g / n_g, c_s / n_s, "p")
        incident = c_g * (2.0 * n_g)
        # The matrices of p waves apply to the magnetic field H; the electric field E is H divided by the index.
        return Amplitudes(t_s * incident / at_s, t_p * incident / (at_p * (n_g * n_s)), (*surface, at_s, at_p))

    def apodization(self, square: Values) -> Values:
        """Return minus the logarithm of the amplitude of the objective at `square`; 0 without `exponent`."""
        # Horner's rule, also in disc arithmetic: docs/certificate.md, section 14, "Apodization".
        t, total = square * self.NA**-2, square * 0.0
        for g in reversed(self.exponent):
            total = total * t + g
        return total

    def _denominator(self, square: Values, p_1: Values, p_l: Values, polarisation: str) -> Values:
        """Return ``(m11 + m12 p_l) p_1 + m21 + m22 p_l``: M is the product of the films' matrices, l the sample."""
        # M (1, p_l), multiplied from the sample to the glass (Born and Wolf, section 1.6).
        fields = (p_l * 0.0 + 1.0, p_l)
        for matrix in self._matrices(square, polarisation):
            fields = _apply(matrix, fields)
        return fields[0] * p_1 + fields[1]

    def _matrices(self, square: Values, polarisation: str) -> Iterator[_Matrix]:
        """Yield the matrix of each film, from the sample to the glass."""
        k = self.wavenumber
        for index, thickness in reversed(self.films):
            # c^2 in the film. cos and sinc are even functions, so that films cause no branch points (certificate,
            # section 14, "Variables").
            square_cosine = 1.0 - square * index**-2
            square_phase = square_cosine * (k * index * thickness) ** 2
            cosine, sinc = cosine_and_sinc(square_phase)
            weight = 1.0 if polarisation == "s" else index**2
            along, back = -1j * k * thickness * weight, -1j * k * thickness * (index**2 / weight)
            yield _Matrix(cosine, sinc * along, sinc * square_cosine * back)


class _Matrix(NamedTuple):
    """Characteristic matrix of a film, ``((same, along), (back, same))``."""

    same: Values
    along: Values
    back: Values


def _apply(matrix: _Matrix, fields: tuple[Values, Values]) -> tuple[Values, Values]:
    """Return the fields on one side of a film from the fields on the other side (Born and Wolf, section 1.6)."""
    top, bottom = fields
    return matrix.same * top + matrix.along * bottom, matrix.back * top + matrix.same * bottom


def cosine_and_sinc(square: Values) -> tuple[Values, Values]:
    """Return ``cos(z)`` and ``sin(z) / z`` from z^2."""
    if isinstance(square, disc_arithmetic.Disc):
        return disc_arithmetic.cosine_and_sinc(square)
    z = np.sqrt(np.asarray(square, dtype=np.complex128))
    return np.cos(z), np.sinc(z / math.pi)


def cosines(NA: float, rho: NDArray[np.float64], index: float) -> NDArray[np.complex128]:
    """Return the cosine c_m at rho in a layer; the imaginary part is not negative."""
    # A product, because 1 - sine^2 would cancel near the critical angle.
    sine = NA * rho / index
    return np.sqrt(((1.0 - sine) * (1.0 + sine)).astype(np.complex128))


INDEX_MOST = 4.0
"""Largest refractive index."""
DEPTH_MOST = 1e-2
"""Largest depth of an emitter, metres."""
_GLASS_MOST, _FILM_MOST = 1e-2, 2e-6  # largest thickness of a layer and of a film, metres


@dataclass(frozen=True)
class Layer:
    """A plane layer of one refractive index: a cover glass, or a film.

    Parameters
    ----------
    index : float
        Refractive index, 1 to 4, without absorption.
    thickness : float
        Thickness, metres, up to 0.01.

    Raises
    ------
    TypeError, ValueError
        If an argument is not a finite number in range.

    Examples
    --------
    >>> Layer(1.5255, 170e-6)
    Layer(index=1.5255, thickness=0.00017)
    """

    index: float
    thickness: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "index", refractive_index("index", self.index))
        object.__setattr__(self, "thickness", length("thickness", self.thickness, _GLASS_MOST))


@dataclass(frozen=True)
class Design:
    """The immersion and cover glass that an objective was corrected for.

    Parameters
    ----------
    immersion : float
        Refractive index of the immersion medium.
    coverslip : Layer or None
        Cover glass; None for a dipping objective.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    """

    immersion: float
    coverslip: Layer | None

    def __post_init__(self) -> None:
        object.__setattr__(self, "immersion", refractive_index("immersion", self.immersion))
        validation.optional("coverslip", self.coverslip, Layer)


def refractive_index(name: str, value: object) -> float:
    """Return a refractive index from 1 to 4; TypeError or ValueError otherwise."""
    index = validation.real(name, value)
    if not 1.0 <= index <= INDEX_MOST:
        raise ValueError(f"{name} must be a refractive index from 1 to {INDEX_MOST:g}, got {index:g}")
    return index


def length(name: str, value: object, most: float, *, positive: bool = False) -> float:
    """Return a length from 0 to `most`, metres; ValueError, with a hint if it seems to be in um or mm."""
    metres = validation.real(name, value, unit="metres")
    if not (0.0 <= metres <= most) or (positive and metres == 0.0):
        other_unit = metres > max(most, 1e-3)  # probably a number in um or mm
        hint = f"; for {metres:g} um give {metres:g}e-6, for {metres:g} mm {metres:g}e-3" if other_unit else ""
        least = "above 0" if positive else "at least 0"
        raise ValueError(f"{name} is in metres and must be {least} and at most {most:g}, got {metres:g}{hint}")
    return metres


def film_stack(value: object) -> tuple[Layer, ...]:
    """Return films as a tuple; TypeError or ValueError if an item is not a Layer or is too thick."""
    if isinstance(value, Layer) or not isinstance(value, Iterable):
        raise TypeError(f"films must be a sequence of Layer, got {validation.shown(value)}")
    films = tuple(value)
    for k, film in enumerate(films):
        validation.instance(f"films[{k}]", film, Layer)
        length(f"films[{k}].thickness", film.thickness, _FILM_MOST)
    return films


def depths(value: ArrayLike) -> Array:
    """Return depths below the glass, 0 to 0.01 metres; TypeError or ValueError for other values."""
    metres = validation.real_array("depth", value, unit="metres")
    if not metres.size:
        raise ValueError(f"depth must not be empty, got shape {metres.shape}")
    for extreme in (metres.min(), metres.max()):
        length("depth", float(extreme), DEPTH_MOST)
    return metres
