"""Pixel-integrated PSFs at any defocus with a proven error bound, and their windows (squares of pixels)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.core import engine
from lommel.methods.choice import of_profiles
from lommel.methods.pixel_rule import local_rule, pixel_rule, quarters, sums_of_windows
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special.chebyshev import chebyshev, chebyshev_nodes

_METHOD = of_profiles(1e-7)
_LOCAL = 600.0  # half width of a window, in v, above which a sparse quadrature rule is faster than a dense one


@dataclass(frozen=True)
class SensorLight:
    """The pixel-integrated PSF of one channel at any defocus: the share of a point's light on each pixel."""

    pupil: Pupil  # in focus, radially symmetric, at the wavelength of the lens
    phase: Callable[[Array], Wavefront]  # Lens.phase: wavefronts for values of the defocus C_d
    spectrum: Sequence[tuple[float, float]]  # pairs of a wavelength (metres) and a weight
    pixel: float  # pixel pitch, metres
    threads: int = 0
    rate: Callable[[float], float] | None = None  # Lens.phase_rate; None for the constant rate 2 of a paraxial lens

    @classmethod
    def of(cls, lens: Lens, spectrum: Sequence[tuple[float, float]], pixel: float, threads: int = 0) -> Self:
        """Return the PSF model of one channel for a lens with radially symmetric aberrations."""
        pupil = Pupil(
            lens.aberrations,
            obscuration=lens.obscuration,
            wavelength=lens.wavelength,
            f_number=lens.working_f_number,
            apodization=lens.illumination,
            colour=lens.pupil_colour,
        )
        return cls(pupil, lens.phase, spectrum, pixel, threads, lens.phase_rate)

    def defocused(self, defocus: Array) -> Pupil:
        """Return the stack of pupils at values of the defocus C_d, radians at the wavelength of the pupil."""
        return self.pupil.carrying(self.phase(defocus) + self.pupil.wavefront, None)

    def shares(self, pupil: Pupil, half: int) -> Array:
        """Return the share of the light in each pixel of the octant, shape (n, cells), up to `half` pixels."""
        total: Array | float = 0.0
        for wavelength, weight in self.spectrum:
            coloured = pupil.in_light(wavelength)
            step = math.pi * self.pixel / coloured.scale
            # I is relative to the peak without aberrations. The share of the light on a pixel is the integral of I
            # over the pixel's square in v, divided by 4 pi times the transmission.
            share = weight * step**2 / (4.0 * math.pi * coloured.transmission)
            if half * step > _LOCAL:
                local = local_rule(half, step)
                total += share * (local.matrix @ _METHOD.profile(coloured, local.v).values.T).T
                continue
            rule = pixel_rule(half, step)
            total += share * _METHOD.means(coloured, step * rule.radii, rule.matrix, self.threads)
        return np.asarray(total)

    def sufficient_half(self, defocus: tuple[float, float], energy: float, largest: int) -> tuple[int, Parabola]:
        """Return the half width of windows that hold the share `energy`, and a parabola that estimates 1 / peak."""
        # Three values of defocus determine the parabola.
        ends = np.linspace(*defocus, 3)
        pupil = self.defocused(ends)
        half = math.ceil(float(pupil.geometric_radius().max()) / self.pixel) + 1
        if half > largest:
            raise too_large(largest, energy)
        while True:
            shares = self.shares(pupil, half)
            sums = sums_of_windows(shares, half)
            enclosed = float(sums[:, -1].min())
            if enclosed >= energy:
                half = int((sums >= energy).argmax(axis=1).max()) + 1
                return half, Parabola.through(ends, shares.max(axis=1))
            # Outside the geometric shadow, the light farther than r from the centre falls like 1 / r or faster.
            # `_enclosed` computes the light in a square much faster than `shares` the light on each of its pixels.
            likely_half = (half + 0.5) * (1.0 - enclosed) / (1.0 - energy)
            if half == largest or (likely_half > largest and (enclosed := self._enclosed(pupil, largest)) < energy):
                raise too_large(largest, energy, enclosed)
            # Growth by 30 %: few iterations, and few pixels that are not needed.
            half = min(math.ceil(1.3 * half) + 1, largest)

    def _enclosed(self, pupil: Pupil, half: int) -> float:
        """Return the smallest share of light, over a stack of pupils, in a window of half width `half`."""
        from lommel.measures.energy import radial_square_energy  # imported here, since few scenes need it

        side = np.array((half + 0.5) * self.pixel)
        pupils = ((weight, pupil.in_light(wavelength)) for wavelength, weight in self.spectrum)
        return float(np.min(sum(weight * radial_square_energy(_METHOD, light, side) for weight, light in pupils)))


def too_large(largest: int, energy: float, enclosed: float | None = None) -> ValueError:
    """Return the ValueError for windows of the `largest` half width, which hold only `enclosed` of the light."""
    share = "" if enclosed is None else f" (windows of this size hold {math.floor(1e6 * enclosed) / 1e6:g})"
    return ValueError(
        f"the blur needs windows of more than {2 * largest + 1} pixels a side to hold {energy:g} of the light{share}"
        "; stop down, or reduce this fraction (energy=)"
    )


_ERROR = 1e-9  # error bound of the interpolation polynomial, for windows scaled to a peak of about 1
_MAX_NODES = 20_000  # largest number of Chebyshev nodes


@dataclass(frozen=True)
class Parabola:
    """Parabola ``curvature (C - middle)^2 + least`` in the defocus C, curvature >= 0 and least > 0."""

    curvature: float
    middle: float
    least: float

    @classmethod
    def through(cls, defocus: Array, values: Array) -> Parabola:
        """Return the parabola through 1 / `values` (<= 1) at three equally spaced `defocus`, raised to at least 1."""
        step, (before, middle, after) = 0.5 * float(defocus[2] - defocus[0]), (1.0 / values).tolist()
        bend = 0.5 * (before + after) - middle
        # Almost equal peaks need no parabola, and the division by bend would amplify rounding.
        if not bend > 1e-3 * middle:
            return cls(0.0, 0.0, 1.0)
        shift = 0.25 * (after - before) / bend
        return cls(bend / step**2, float(defocus[1]) - shift * step, max(1.0, middle - bend * shift**2))

    def __call__(self, defocus: Array) -> Array:
        """Return the values of the parabola."""
        return self.curvature * (defocus - self.middle) ** 2 + self.least


# The field U at an image point is the integral of A exp(i Phi) over the pupil, A real. For a complex defocus C the
# intensity is I(C) = U(C) conj(U(conj(C))). Im Phi varies over the pupil by at most rate |Im C|. By the
# Cauchy-Schwarz inequality, I is at most exp(rate |Im C|) times the light that the pupil transmits, and the share of
# the light on a pixel is at most `bound` exp(rate |Im C|). Let M be the maximum of this bound on the ellipse with the
# foci -1 and 1 (the ends of the defocus range) and semi-axes of the sum rho. The error of the polynomial through n
# Chebyshev nodes is at most 4 M rho^(1 - n) / (rho - 1) (Trefethen, Approximation Theory and Approximation Practice,
# 2013, Theorem 8.2). A number n slightly above rate times half of the range is enough. Interpolation amplifies
# errors of the windows at the nodes by at most 1 + 2 log(n) / pi. The peak of a defocused PSF is much lower than the
# peak in focus, and errors must be small relative to both. Therefore the polynomial interpolates the windows times a
# parabola that approximates 1 / peak, and its values are divided by the parabola.
@dataclass(frozen=True)
class DefocusNodes:
    """Windows at any defocus in a range: Chebyshev interpolation with an error bound."""

    low: float
    high: float
    parabola: Parabola  # the windows are multiplied by it before interpolation
    coefficients: Array  # (n, cells): Chebyshev coefficients of parabola * windows
    threads: int = 0

    @classmethod
    def of(
        cls,
        windows: Callable[[Array], Array],
        low: float,
        high: float,
        parabola: Parabola,
        *,
        rate: Callable[[float], float],
        bound: float,
        threads: int = 0,
    ) -> DefocusNodes:
        """Return the interpolation of `windows`; `bound` and `rate` at abs(C) are those of the error bound above."""
        middle, half_range = 0.5 * (low + high), 0.5 * (high - low)
        axis = np.geomspace(1e-3, max(1.0, 20.0 / half_range), 200)  # major semi-axis - 1
        # rho = sum of the semi-axes of the ellipse with foci -1 and 1 whose major semi-axis is 1 + axis.
        rho = 1.0 + axis + np.sqrt(axis * (axis + 2.0))
        extent = half_range * (1.0 + float(axis[-1]))
        max_rate = rate(abs(middle) + extent)
        # |Im C| is at most the minor semi-axis, (rho - 1 / rho) / 2, times half of the range.
        growth = max_rate * half_range * 0.5 * (rho - 1.0 / rho)
        factor = parabola.curvature * (abs(middle - parabola.middle) + extent) ** 2 + parabola.least
        # 4 M rho^(1 - n) / (rho - 1) = _ERROR, solved for n, at the rho for which n is smallest.
        count = float((1.0 + (np.log(4.0 * bound * factor / (_ERROR * (rho - 1.0))) + growth) / np.log(rho)).min())
        if not count <= _MAX_NODES:
            raise ValueError(
                f"depth spans C_d from {low:.4g} to {high:.4g} rad, which needs {count:.4g} PSFs, more than "
                f"{_MAX_NODES}; stop down or reduce the range of depth"
            )
        x, transform = chebyshev_nodes(math.ceil(count))
        nodes = middle + half_range * x
        scaled = parabola(nodes)[:, None] * windows(nodes)
        return cls(low, high, parabola, engine.product(transform, scaled, threads), threads)

    def __call__(self, defocus: Array) -> tuple[Array, float]:
        """Return the windows at values of the defocus, and a bound on their errors relative to their peaks."""
        windows = self.values(defocus)
        return windows, _ERROR / float((self.parabola(defocus) * windows.max(axis=1)).min())

    def values(self, defocus: Array) -> Array:
        """Return the windows at values of the defocus."""
        x = (2.0 * defocus - self.low - self.high) / (self.high - self.low)
        basis = chebyshev(x, len(self.coefficients)) / self.parabola(defocus)[:, None]
        return engine.product(basis, self.coefficients, self.threads)


# Let h be the half width of a window, a real number of pixels. The ring of pixels at the Chebyshev distance k is
# multiplied by h + 1 - k, clipped to [0, 1] and averaged over adjacent windows: the blur is continuous in defocus.
def find_cuts(octants: Array, half: int, energy: float) -> Array:
    """Return the half width h of each window, so that windows, also if interpolated, hold the share `energy`."""
    sums = sums_of_windows(octants, half)
    sufficient = sums >= np.clip(energy, sums[:, :1], sums[:, -1:])
    rows, outer = np.arange(len(sums)), sufficient.argmax(axis=1)
    ring = sums[rows, outer] - sums[rows, outer - 1]
    surplus = np.maximum(0.0, sums[rows, outer] - energy)
    half_widths = outer - np.divide(surplus, ring, out=np.zeros(len(sums)), where=outer > 0)
    # Maximum over neighbours: windows interpolated between them must hold enough light as well.
    return neighbour_maxima(half_widths)


def neighbour_maxima(values: Array) -> Array:
    """Return the maximum of each value (or row) and its two neighbours."""
    padded = np.concatenate([values[:1], values, values[-1:]])
    return np.asarray(np.maximum(np.maximum(padded[:-2], padded[2:]), values))


def ring_factors(cuts: Array, half: int) -> Array:
    """Return the factor of each ring of pixels, 0 to 1, averaged over adjacent windows by 1/6, 2/3, 1/6."""
    padded, distance = np.pad(cuts, 1, mode="edge"), np.arange(half + 1)
    ring = np.clip(padded[:, None] + 1.0 - distance, 0.0, 1.0)
    return np.asarray((ring[:-2] + 4.0 * ring[1:-1] + ring[2:]) / 6.0)


def pixel_factors(cuts: Array, half: int) -> Array:
    """Return the factor of each pixel, 0 to 1, for one quadrant of each window, from the centre on."""
    distance = np.arange(half + 1)
    return ring_factors(cuts, half)[:, np.maximum(distance[:, None], distance)]


def cut(octants: Array, cuts: Array) -> Array:
    """Return one quadrant of each window, from the centre on, truncated to the half widths `cuts`."""
    half = math.ceil(cuts.max())
    return np.asarray(quarters(octants, half) * pixel_factors(cuts, half))


def sums_of_quarters(quarter: Values) -> Array:
    """Return the sums of whole windows, each represented by one quadrant that begins at the centre."""
    # Rows and columns other than the central ones count twice, for their mirror images.
    row_factors, column_factors = (np.where(np.arange(side) == 0, 1.0, 2.0) for side in quarter.shape[1:])
    return np.asarray(quarter @ column_factors @ row_factors)
