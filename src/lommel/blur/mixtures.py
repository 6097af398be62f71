r"""Isotropic blurs as mixtures of Gaussians; each Gaussian is a product of factors along rows and columns.

A transfer function that is completely monotone in the squared frequency is a mixture of Gaussians with positive
weights (Bernstein's theorem). Examples are Kolmogorov's ``exp(-c q^(5/3))``, and von Karman's transfer function,
because ``limit - z^nu K_nu(z)`` is a Bernstein function of ``z^2``. With 6 terms, the error for Kolmogorov is 1.4e-4.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.blur.blurs import FWHM, Blur, Seeing

TERMS = 6
SIGMAS = 2.0 * math.sqrt(2.0 * math.log(2.0))  # full width at half maximum / standard deviation of a Gaussian
_MIN_RATE, _MAX_RATE, _RATES = 0.3, 3e4, 120  # smallest and largest rate of the candidate Gaussians, and their number
_MIN_WEIGHT = 1e-7  # smallest weight of a term

#: Results of `turbulence` (weights, rates, error) for (outer scale / r0, number of terms), stored to save time.
_STORED: dict[tuple[float | None, int], tuple[tuple[float, ...], tuple[float, ...], float]] = {
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
"""Values of (outer scale / r0) that fits compare; None is an infinite outer scale (Kolmogorov)."""


class Mixture(NamedTuple):
    """``T = sum(weights * exp(-rates q^2))`` for q = frequency / coherence frequency; `error`: largest error of T."""

    weights: Array
    rates: Array
    error: float


@lru_cache(maxsize=32)
def turbulence(outer: float | None = None, terms: int = TERMS) -> Mixture:
    """Return seeing as a mixture of at most `terms` Gaussians; `outer` is outer scale / r0, None for infinity."""
    if (stored := _STORED.get((outer, terms))) is not None:
        return Mixture(np.array(stored[0]), np.array(stored[1]), stored[2])

    # Above q = 2.6 Kolmogorov's T is below 1e-7, and von Karman's T is nearly at its limit.
    q = np.append(np.linspace(1e-3, 2.6, 400), np.geomspace(2.6, 30.0, 40)[1:])
    goal = np.asarray(Seeing(1.0, outer_scale=outer).transfer(q))
    # The rate 0 is a constant term: von Karman's T decreases to a positive limit.
    rates = np.append(np.geomspace(_MIN_RATE, _MAX_RATE, _RATES), 0.0)

    def gaussians(r: Array) -> Array:
        return np.exp(-np.multiply.outer(q * q, r))

    sum_weight = 30.0  # weight of the equation sum(weights) = 1, relative to the equations of the 439 frequencies
    design = np.vstack([gaussians(rates), np.full(len(rates), sum_weight)])
    # Non-negative least squares: negative weights could make images negative.
    weights, _ = scipy.optimize.nnls(design, np.append(goal, sum_weight))
    indices = np.flatnonzero(weights > _MIN_WEIGHT)
    indices = indices[np.argsort(rates[indices])]
    w, r = _merge_terms(weights[indices], rates[indices], terms)
    w, r = _reduce_error(goal, q * q, w, r)
    return Mixture(w, r, float(np.abs(gaussians(r) @ w - goal).max()))


def _merge_terms(w: Array, r: Array, terms: int) -> tuple[Array, Array]:
    """Return at most `terms` terms: merge the two most similar neighbouring terms, repeatedly."""
    while len(r) > terms:
        total = w[:-1] + w[1:]
        # Cost of merging two terms: w1 w2 / (w1 + w2) times the squared difference of the logarithms of their rates.
        cost = w[:-1] * w[1:] / total * np.diff(np.log(r + 0.05)) ** 2
        i = int(cost.argmin())
        # The merged rate conserves sum(weights * rates), which is -dT / d(q^2) at q = 0.
        r = np.concatenate([r[:i], [(w[i] * r[i] + w[i + 1] * r[i + 1]) / total[i]], r[i + 2 :]])
        w = np.concatenate([w[:i], [total[i]], w[i + 2 :]])
    return w / w.sum(), r


def _reduce_error(goal: Array, square: Array, w: Array, r: Array) -> tuple[Array, Array]:
    """Return terms with a smaller maximum error, by least squares with weights that increase with the error."""
    count = len(w)

    def parts(x: Array) -> tuple[Array, Array, Array]:
        # Softmax: weights are positive and sum to 1 for any parameters, and the search requires no bounds.
        powers = np.exp(x[:count] - x[:count].max())
        rates = np.exp(np.clip(x[count:], -30.0, 30.0))
        return powers / powers.sum(), rates, np.exp(-np.multiply.outer(square, rates))

    def weighted_error(x: Array, weight: Array) -> Array:
        w, _, gaussians = parts(x)
        return weight * (gaussians @ w - goal)

    def jacobian(x: Array, weight: Array) -> Array:
        w, rates, gaussians = parts(x)
        # The derivative of a softmax is d w_i / d x_j = w_i (delta_ij - w_j).
        by_weight = (gaussians - (gaussians @ w)[:, None]) * w
        return np.asarray(weight[:, None] * np.hstack([by_weight, -gaussians * w * rates * square[:, None]]))

    best_x = np.concatenate([np.log(w), np.log(np.maximum(r, 1e-6))])
    weight, least = np.ones(len(goal)), np.inf
    for _ in range(30):
        # Lawson's method: with weights that increase with the error, least squares approach the minimax fit.
        x = scipy.optimize.least_squares(
            weighted_error, best_x, jacobian, args=(weight,), method="lm", max_nfev=200
        ).x
        error = np.abs(weighted_error(x, np.ones(1)))
        if not error.max() < least:
            break
        best_x, least = x, float(error.max())
        weight = np.sqrt(error / least + 0.1)
    w, rates, _ = parts(best_x)
    order = np.argsort(rates)
    return w[order], rates[order]


@dataclass(frozen=True, eq=False)
class BlurProfile:
    """Blur as a mixture of c Gaussians with `weights` (c,) and variances ``fixed + rates @ squares``.

    `squares` are the b unknown squared widths (pixels^2), and `names` their kinds: "seeing" for ``(FWHM / 2.355)^2``,
    "Gaussian" for the variance. `rates` has the shape (c, b). `outer` is (outer scale of the seeing) / r0.
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
    def gaussian(cls) -> BlurProfile:
        """Return a Gaussian of unknown width."""
        return cls(np.ones(1), np.ones((1, 1)), np.zeros(1), ("Gaussian",))

    @classmethod
    def turbulent(cls, outer: float | None = None, terms: int = TERMS, *, alone: bool = False) -> BlurProfile:
        """Return seeing of unknown width, convolved with a Gaussian of unknown width unless `alone`."""
        mixture = turbulence(outer, terms)
        # The variance of exp(-rate q^2) is rate / (2 pi^2) * (wavelength / r0)^2; FWHM is in wavelength / r0.
        rates = mixture.rates * (SIGMAS / FWHM) ** 2 / (2.0 * math.pi**2)
        columns = [rates] if alone else [rates, np.ones(len(rates))]
        names = ("seeing",) if alone else ("seeing", "Gaussian")
        return cls(mixture.weights, np.stack(columns, axis=1), np.zeros(len(rates)), names, outer)

    @classmethod
    def known(cls, blurs: tuple[Blur, ...], pixel: float, wavelength: float | None) -> BlurProfile:
        """Return the profile of known isotropic blurs, at most one a Seeing, for the pixel pitch `pixel`."""
        squares = sum(float(blur.covariance[0, 0]) for blur in blurs) / pixel**2
        weights, rates = np.ones(1), np.zeros(1)
        for seeing in (blur for blur in blurs if isinstance(blur, Seeing)):
            q = seeing.coherence(wavelength) * pixel
            outer = None if seeing.outer_scale is None else seeing.outer_scale / seeing.r0
            if outer is not None and wavelength is not None and seeing.wavelength is not None:
                outer *= (seeing.wavelength / wavelength) ** 1.2
            weights, rates, _ = turbulence(outer, 8)
            rates = rates / (2.0 * math.pi**2 * q * q)
        return cls(weights, np.empty((len(weights), 0)), rates + squares)
