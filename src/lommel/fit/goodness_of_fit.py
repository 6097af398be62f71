r"""The verdict on a fit: which values of chi2 noise explains, and whether the variance is that of photons.

Pearson's chi2 over its expectation, with a standard deviation s, follows closely a gamma distribution of that mean
and standard deviation: the chi2 distribution of 2 / s^2 degrees of freedom over their number (Satterthwaite 1946,
doi:10.2307/3002019). Few pixels have a longer tail above than a normal distribution, and counts of few electrons
have fewer degrees of freedom than pixels.

The score test of excess noise is of a variance that is a multiple of the light, as of electron multiplication. With
the mean m of a pixel in electrons, the variance v = m + read^2 that was taken, the residual r and s = m / v, the
slope of the log-likelihood by the share f, of a variance ``v + f m``, is half of ``sum s (r^2 / v - 1)``, which has
the variance ``sum s^2 (2 + 1 / v)`` of Poisson numbers. A wrong mean makes large residuals, too, but where there is
much light: the test asks that these are as large where there is little.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from scipy import special

from lommel.base.arrays import Array
from lommel.fit.findings import Finding, Severity

BY_CHANCE = 1e-4
"""Probability with which noise alone makes a fit a misfit."""
SURE = 1e-3
"""The same with which a search goes on although its fit is right."""
_DOUBTED = 1e-2
_EXCEEDS = 5.0  # standard deviations from which on an excess is spoken of
_RANGE = 0.8, 1.4  # of the share: that of a register of high gain is 1, and a misfit may add to it
_CELLS = 8  # of pixels ordered by their light
_FLAT = 0.3  # largest difference of a cell's share from that of all, besides five of its standard deviations
_OF_LIGHT = 0.1  # s, from which on a pixel says something of the variance of light


def most(spread: Any, probability: float = BY_CHANCE) -> Array:
    """Return the chi2 that noise exceeds with a probability, for standard deviations `spread` of chi2."""
    shape = 1.0 / np.square(np.maximum(spread, 1e-9))
    return np.asarray(special.gammainccinv(shape, probability) / shape)


def least(spread: Any, probability: float = BY_CHANCE) -> Array:
    """Return the chi2 below which noise is with a probability."""
    shape = 1.0 / np.square(np.maximum(spread, 1e-9))
    return np.asarray(special.gammaincinv(shape, probability) / shape)


def chance(chi2: float, spread: float) -> float:
    """Return the probability with which noise alone makes a chi2 as large."""
    shape = 1.0 / max(spread, 1e-9) ** 2
    return float(special.gammaincc(shape, shape * chi2))


def chi2_findings(chi2: float, spread: float, causes: str) -> list[Finding]:
    """Return the finding of a chi2 that noise does not explain, or seldom, once in 1000 fits a doubt.

    `causes` of a misfit in words, "" where another finding names them.
    """
    limit, floor, rare = float(most(spread)), float(least(spread)), chance(chi2, spread)
    numbers = {"chi2": chi2, "limit": limit, "least": floor, "chance": rare}
    if chi2 >= limit:
        text = "; ".join(filter(None, (f"noise alone stays below {limit:.3g}", causes)))
        return [Finding("misfit", "error", text, numbers)]
    if chi2 < floor:
        text = "the images are less noisy than gain, read noise and offset state, so that standard errors do not hold"
        return [Finding("too_quiet", "doubt", text, numbers)]
    if rare < _DOUBTED:
        percent = f"{100.0 * max(rare, 1e-6):.1g}"
        severity: Severity = "doubt" if rare < SURE else "note"
        return [Finding("rare_chi2", severity, f"noise alone exceeds this chi2 in {percent} % of fits", numbers)]
    return []


@dataclass(frozen=True)
class ExcessTest:
    """Result of :func:`excess_test`.

    Attributes
    ----------
    share : float
        The variance beyond what was taken, over the light: ``excess - 1``; 0 where the noise is right.
    error : float
        Standard error of `share` where the noise is right.
    flat : bool
        Whether pixels of little and of much light have the same share, as of a camera, not of wrong means.
    """

    share: float
    error: float
    flat: bool

    @property
    def sigmas(self) -> float:
        """`share` over its error; 0 where nothing is known."""
        return self.share / self.error if np.isfinite(self.error) else 0.0

    @property
    def found(self) -> bool:
        """Whether it is that of an electron-multiplying register: near 1, beyond chance, and flat."""
        return self.flat and self.sigmas > _EXCEEDS and _RANGE[0] <= self.share <= _RANGE[1]

    def findings(self, excess: float) -> list[Finding]:
        """Return the finding of a register; none where its `excess`, above 1, was stated."""
        if not self.found or excess > 1.0:
            return []
        factor = 1.0 + self.share
        text = (
            f"the variance is {factor:.2f} times that of photons, at dim pixels as at bright ones: an "
            "electron-multiplying camera doubles the variance: state excess=2; or the gain is half of that stated"
        )
        numbers = {"factor": factor, "error": self.error, "sigmas": self.sigmas}
        return [Finding("excess_noise", "error", text, numbers)]


def excess_test(residual: ArrayLike, light: ArrayLike, read: ArrayLike) -> ExcessTest:
    """Test whether residuals have the excess noise of electron multiplication.

    Parameters
    ----------
    residual, light, read : array_like, of one shape or broadcast to one
        Of each pixel, in electrons: the difference of counts and mean; the mean; the variance of reading. Pixels of a
        residual that is NaN do not count. Residuals of fits with few pixels a parameter are too small: multiply them
        by the root of the pixels over the degrees of freedom.

    Returns
    -------
    ExcessTest
    """
    off, mean, added = (np.asarray(each, float).ravel() for each in np.broadcast_arrays(residual, light, read))
    variance = np.maximum(mean + added, 1e-9)
    s = np.maximum(mean, 0.0) / variance
    known = np.flatnonzero(np.isfinite(off) & (s > _OF_LIGHT))
    if not known.size:
        return ExcessTest(0.0, np.inf, flat=False)
    known = known[np.argsort(mean[known], kind="stable")]
    off, mean, variance, s = off[known], mean[known], variance[known], s[known]
    sums = np.stack([s * (off**2 / variance - 1.0), s * s, s * s * (2.0 + 1.0 / variance)])
    # All pixels, and cells of like light, each of as much of all light.
    starts = np.unique(np.searchsorted(np.cumsum(mean), mean.sum() * np.arange(_CELLS) / _CELLS))
    beyond, information, spread = np.column_stack([sums.sum(axis=1), np.add.reduceat(sums, starts, axis=1)])
    shares, errors = beyond / information, np.sqrt(spread) / information
    # With the excess the variance of the statistic is about its square as large.
    share = float(shares[0])
    slack = _FLAT * max(share, 1.0) + 5.0 * (1.0 + max(share, 0.0)) * errors[1:]
    return ExcessTest(share, float(errors[0]), bool((np.abs(shares[1:] - share) <= slack).all()))
