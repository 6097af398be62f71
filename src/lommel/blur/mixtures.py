r"""Isotropic blurs as mixtures of Gaussians, whose products along rows and columns are those of images.

A transfer function that is completely monotone in the squared frequency is a positive mixture of Gaussians
(Bernstein's theorem). Kolmogorov's ``exp(-c q^(5/3))`` is, and von Karman's: ``1 - z^nu K_nu(z)`` is a Bernstein
function of ``z^2``. Few terms come near: 6 of Kolmogorov's within 1.3e-4.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.blur.blurs import FWHM, Blur, Seeing

TERMS = 6
SIGMAS = 2.0 * math.sqrt(2.0 * math.log(2.0))  # standard deviations in the full width at half maximum of a Gaussian
_FINEST, _WIDEST, _NODES = 0.3, 3e4, 120  # rates of the Gaussians from which the terms are selected, and their number
_LEAST = 1e-7  # least weight of a term

#: Weights, rates and error of the mixtures in fits, by outer scale over r0 and number of terms, computed as below.
_STATED: dict[tuple[float | None, int], tuple[tuple[float, ...], tuple[float, ...], float]] = {
    (None, 3): ((0.662778, 0.296069, 0.041153), (3.05998, 9.35535, 101.599), 2.3e-3),
    (None, 6): (
        (0.370949, 0.44304, 0.135663, 0.037594, 0.010529, 0.002225),
        (2.58907, 4.66534, 12.4933, 46.7151, 251.244, 3050.4),
        1.4e-4,
    ),
    (1000.0, 6): (
        (0.305619, 0.466566, 0.165369, 0.04668, 0.013007, 0.002759),
        (1.98525, 3.71798, 9.8806, 36.588, 195.494, 2356.3),
        1.7e-4,
    ),
    (240.0, 6): (
        (0.256616, 0.477516, 0.192022, 0.05528, 0.015333, 0.003233),
        (1.60507, 3.11647, 8.24684, 30.3082, 161.543, 1956.97),
        1.9e-4,
    ),
    (60.0, 6): (
        (0.165909, 0.471961, 0.256906, 0.079005, 0.021683, 0.004536),
        (0.996234, 2.13916, 5.65943, 20.4337, 108.186, 1306.57),
        2.5e-4,
    ),
}
OUTER = (None, 1000.0, 240.0, 60.0)
"""Outer scales over r0 that fits compare; None is Kolmogorov's infinite one."""


class Mixture(NamedTuple):
    """``T(q) = sum weights exp(-rates q^2)``, weights of sum 1, within `error`; q is over the coherence frequency."""

    weights: Array
    rates: Array
    error: float


@lru_cache(maxsize=32)
def turbulence(outer: float | None = None, terms: int = TERMS) -> Mixture:
    """Return seeing as a mixture of at most `terms` Gaussians; `outer` is the outer scale over r0, None infinite."""
    if (stated := _STATED.get((outer, terms))) is not None:
        return Mixture(np.array(stated[0]), np.array(stated[1]), stated[2])
    from scipy import optimize

    # Beyond q = 2.6 Kolmogorov's T is below 1e-7, and von Karman's has reached its limit.
    q = np.append(np.linspace(1e-3, 2.6, 400), np.geomspace(2.6, 30.0, 40)[1:])
    goal = np.asarray(Seeing(1.0, outer_scale=outer).transfer(q))
    # A rate of 0 is a constant: von Karman's T falls to exp(-limit) above 0, and not to 0.
    rates = np.append(np.geomspace(_FINEST, _WIDEST, _NODES), 0.0)

    def light(r: Array) -> Array:
        return np.exp(-np.multiply.outer(q * q, r))

    heavy = 30.0  # weight of the equation sum = 1, which keeps the light, against those of the 439 frequencies
    design = np.vstack([light(rates), np.full(len(rates), heavy)])
    # Non-negative least squares: weights below 0 would make images negative.
    weights, _ = optimize.nnls(design, np.append(goal, heavy))
    kept = np.flatnonzero(weights > _LEAST)
    kept = kept[np.argsort(rates[kept])]
    w, r = _merged(weights[kept], rates[kept], terms)
    w, r = _polished(goal, q * q, w, r)
    return Mixture(w, r, float(np.abs(light(r) @ w - goal).max()))


def _merged(w: Array, r: Array, terms: int) -> tuple[Array, Array]:
    """Return `terms` terms, merging the most similar neighbours one pair at a time."""
    while len(r) > terms:
        both = w[:-1] + w[1:]
        # Loss of a merge: the reduced weight times the squared distance of the logarithms of both rates.
        cost = w[:-1] * w[1:] / both * np.diff(np.log(r + 0.05)) ** 2
        i = int(cost.argmin())
        # The merged rate keeps sum weights * rates, the second moment of the transfer function at q = 0.
        r = np.concatenate([r[:i], [(w[i] * r[i] + w[i + 1] * r[i + 1]) / both[i]], r[i + 2 :]])
        w = np.concatenate([w[:i], [both[i]], w[i + 2 :]])
    return w / w.sum(), r


def _polished(goal: Array, square: Array, w: Array, r: Array) -> tuple[Array, Array]:
    """Return terms with a smaller largest error, by least squares reweighted towards large errors."""
    from scipy import optimize

    count = len(w)

    def parts(x: Array) -> tuple[Array, Array, Array]:
        # Softmax: positive weights of sum 1 for any parameters, so that the search needs no bounds.
        raised = np.exp(x[:count] - x[:count].max())
        rates = np.exp(np.clip(x[count:], -30.0, 30.0))
        return raised / raised.sum(), rates, np.exp(-np.multiply.outer(square, rates))

    def off(x: Array, weight: Array) -> Array:
        shares, _, each = parts(x)
        return weight * (each @ shares - goal)

    def slope(x: Array, weight: Array) -> Array:
        shares, rates, each = parts(x)
        # d share_i / d x_j of a softmax is share_i (delta_ij - share_j).
        by_weight = (each - (each @ shares)[:, None]) * shares
        return np.asarray(weight[:, None] * np.hstack([by_weight, -each * shares * rates * square[:, None]]))

    best = np.concatenate([np.log(w), np.log(np.maximum(r, 1e-6))])
    weight, least = np.ones(len(goal)), np.inf
    for _ in range(30):
        # Lawson's idea: weights that grow with the error turn least squares into the minimax fit.
        tried = optimize.least_squares(off, best, slope, args=(weight,), method="lm", max_nfev=200).x
        error = np.abs(off(tried, np.ones(1)))
        if not error.max() < least:
            break
        best, least = tried, float(error.max())
        weight = np.sqrt(error / least + 0.1)
    shares, rates, _ = parts(best)
    order = np.argsort(rates)
    return shares[order], rates[order]


@dataclass(frozen=True, eq=False)
class Shape:
    """Shape of blur: Gaussians with `weights` (c,) and variances ``fixed + rates @ squares`` (pixels^2).

    `rates` (c, b) multiply the b unknown squared widths, called by `names`: ``(FWHM / 2.355)^2`` of "seeing", the
    variance of a "Gaussian". `outer` is the outer scale of the seeing over r0.
    """

    weights: Array
    rates: Array
    fixed: Array
    names: tuple[str, ...] = ()
    outer: float | None = None

    @property
    def unknown(self) -> int:
        """Number of unknown widths."""
        return int(self.rates.shape[1])

    def variances(self, squares: Array) -> Array:
        """Return the variances (..., c) of the Gaussians for squared widths (..., b)."""
        return np.asarray(self.fixed + squares @ self.rates.T)

    @classmethod
    def gaussian(cls) -> Shape:
        """Return a Gaussian of unknown width."""
        return cls(np.ones(1), np.ones((1, 1)), np.zeros(1), ("Gaussian",))

    @classmethod
    def turbulent(cls, outer: float | None = None, terms: int = TERMS, *, alone: bool = False) -> Shape:
        """Return seeing of unknown width, convolved with a Gaussian of unknown width unless `alone`."""
        made = turbulence(outer, terms)
        # exp(-rate q^2) has the variance rate / (2 pi^2) over (r0 / wavelength)^2; FWHM converts that to the width.
        rates = made.rates * (SIGMAS / FWHM) ** 2 / (2.0 * math.pi**2)
        columns = [rates] if alone else [rates, np.ones(len(rates))]
        names = ("seeing",) if alone else ("seeing", "Gaussian")
        return cls(made.weights, np.stack(columns, axis=1), np.zeros(len(rates)), names, outer)

    @classmethod
    def known(cls, several: tuple[Blur, ...], pixel: float, wavelength: float | None) -> Shape:
        """Return known isotropic blurs, at most one of them seeing, for pixels of the pitch `pixel`."""
        squares = sum(float(each.covariance[0, 0]) for each in several) / pixel**2
        weights, rates = np.ones(1), np.zeros(1)
        for air in (each for each in several if isinstance(each, Seeing)):
            q = air.coherence(wavelength) * pixel
            outer = None if air.outer_scale is None else air.outer_scale / air.r0
            if outer is not None and wavelength is not None and air.wavelength is not None:
                outer *= (air.wavelength / wavelength) ** 1.2
            weights, rates, _ = turbulence(outer, 8)
            rates = rates / (2.0 * math.pi**2 * q * q)
        return cls(weights, np.empty((len(weights), 0)), rates + squares)
