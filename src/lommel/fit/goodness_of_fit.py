r"""The verdict on residuals: which chi2 noise explains, whether the variance is that of photons, and stripes in them.

Pearson's chi2 over its expectation, with a standard deviation s, follows closely a gamma distribution of that mean
and standard deviation: the chi2 distribution of 2 / s^2 degrees of freedom over their number (Satterthwaite 1946,
doi:10.2307/3002019). Few pixels have a longer tail above than a normal distribution, and counts of few electrons
have fewer degrees of freedom than pixels.

The score test of excess noise is of a variance that is a multiple of the light, as of electron multiplication. With
the mean m of a pixel in electrons, the variance v = m + read^2 that was taken, the residual r and s = m / v, the
slope of the log-likelihood by the share f, of a variance ``v + f m``, is half of ``sum s (r^2 / v - 1)``, which has
the variance ``sum s^2 (2 + 1 / v)`` of Poisson numbers. A wrong mean makes large residuals, too, but where there is
much light: the test asks that these are as large where there is little.

The score test of a wave of wave vector k that is added to an image, of any phase, is of ``F(k) = sum r exp(-i k x) /
v``, whose mean square is ``W(0)`` and whose square has the mean ``W(2 k)``, where W is the transform of 1 / v. The
squares of real and imaginary part over their covariance follow chi2 of two degrees of freedom (of one where F is
real), those of several images add up. Dim pixels count most: a wrong PSF is seen by chi2 long before.
"""

from __future__ import annotations

import math
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
_DOUBTED = 1e-2  # chance below which a chi2 is reported
_EXCEEDS = 5.0  # standard deviations from which on an excess is reported
_RANGE = 0.8, 1.4  # of the share: 1 for a register of high gain, and more where there is a misfit as well
_CELLS = 8  # groups of pixels, in the order of their light
_FLAT = 0.3  # largest difference of a cell's share from that of all, besides five standard deviations
_OF_LIGHT = 0.1  # s above which a pixel has information on the variance of light
_REAL = 1e-6  # of the variance of both parts: below, the transform is real
_LEAST_SIDE = 6  # pixels of windows in which stripes are looked for


def most(spread: Any, probability: float = BY_CHANCE) -> Array:
    """Return the chi2 that noise exceeds with a probability, for standard deviations `spread` of chi2."""
    # The gamma distribution of mean 1 and standard deviation s has the shape 1 / s^2.
    shape = 1.0 / np.square(np.maximum(spread, 1e-9))
    return np.asarray(special.gammainccinv(shape, probability) / shape)


def least(spread: Any, probability: float = BY_CHANCE) -> Array:
    """Return the chi2 below which noise stays with a probability."""
    shape = 1.0 / np.square(np.maximum(spread, 1e-9))
    return np.asarray(special.gammaincinv(shape, probability) / shape)


def chance(chi2: float, spread: float) -> float:
    """Return the probability that noise alone makes a chi2 as large."""
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
        """Whether it is the noise of an electron-multiplying register: near 1, beyond chance, and flat."""
        return self.flat and self.sigmas > _EXCEEDS and _RANGE[0] <= self.share <= _RANGE[1]

    def findings(self, excess: float) -> list[Finding]:
        """Return the finding on a register; none if an `excess` above 1 was stated."""
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


def stripe_findings(residual: Array, variance: Array, excess: float = 1.0) -> list[Finding]:
    """Return the finding of stripes, or of rows or columns with offsets, in residuals beyond chance.

    Parameters
    ----------
    residual, variance : ndarray, shape (images, height, width)
        Electrons and their squares, over `excess`; pixels of a residual that is NaN do not count.
    excess : float, default 1
        Factor of the variance of an electron-multiplying camera.
    """
    weight = np.where(np.isfinite(residual) & (variance > 0.0), 1.0 / np.maximum(variance, 1e-9), 0.0)
    seen = (weight > 0.0).sum(axis=(1, 2)) > _LEAST_SIDE**2 // 2
    weight, residual = weight[seen], residual[seen]
    height, width = residual.shape[1:]
    if not len(weight) or min(height, width) < _LEAST_SIDE:
        return []
    # Backgrounds that slope are no stripes: a plane is taken from each window.
    plane = np.stack([np.ones((height, width)), *np.mgrid[:height, :width]])
    normal = np.einsum("iyx,nyx,jyx->nij", plane, weight, plane)
    pull = np.einsum("iyx,nyx->ni", plane, weight * np.nan_to_num(residual))
    residual = residual - np.tensordot(np.linalg.solve(normal, pull[..., None])[..., 0], plane, 1)
    half = width // 2 + 1  # of opposite wave vectors one is enough
    pull, both = np.fft.rfft2(np.nan_to_num(residual) * weight), np.fft.fft2(weight)
    total = both[:, :1, :1].real
    twice = both[:, (2 * np.arange(height) % height)[:, None], 2 * np.arange(half) % width]
    spread = total**2 - np.abs(twice) ** 2
    real = spread < _REAL * total**2
    # The inverse of the 2 x 2 covariance of real and imaginary part, in complex form.
    parts = 2.0 * (total * np.abs(pull) ** 2 - (pull**2 * twice.conj()).real) / np.where(real, 1.0, spread)
    squares = np.where(real, np.abs(pull) ** 2 / total, parts).sum(axis=0)
    freedom = np.where(real, 1.0, 2.0).sum(axis=0)
    # Where the noise is larger than stated, all wave vectors have more.
    squares /= max(1.0, float(np.median(squares / (2.0 * special.gammaincinv(0.5 * freedom, 0.5)))))
    alone = special.gammaincc(0.5 * freedom, 0.5 * squares)
    alone[:2, :2] = alone[-1, :2] = 1.0  # as wide as the window are backgrounds and their slopes
    i, j = np.unravel_index(int(alone.argmin()), alone.shape)
    power = {"stripes": (squares[i, j] - freedom[i, j], len(weight) / freedom[i, j])}
    # The least of so many independent chances is as rare as one that is their number times smaller.
    chances = {"stripes": float(alone[i, j]) * height * half}
    for name, at, side in (("rows", np.s_[2 : height // 2 + 1, 0], height), ("columns", np.s_[0, 2:half], width)):
        found, of = float(squares[at].sum()), float(freedom[at].sum())
        chances[name] = float(special.gammaincc(0.5 * of, 0.5 * found))
        power[name] = found - of, 2.0 * len(squares[at]) / side
    kind = min(chances, key=chances.__getitem__)
    if (chance := len(chances) * chances[kind]) >= SURE:
        return []
    beyond, share = power[kind]
    # The mean square of F is W(0) for noise alone: what is beyond, as the mean square of an offset.
    size = excess * math.sqrt(beyond / (share * float(total.sum())))
    numbers: dict[str, float] = {"size": size, "chance": chance}
    text = f"{kind} of pixels have offsets of {size:.2g} electrons rms"
    if kind == "stripes":
        up, across = float(np.fft.fftfreq(height)[i]), j / width
        period, angle = 1.0 / math.hypot(up, across), math.degrees(math.atan2(up, across))
        numbers |= {"period": period, "angle": angle}
        way = {0: "along x", 90: "along y"}.get(round(abs(angle)), f"{angle:.0f} deg from x to y")
        text = f"stripes of +-{size:.2g} electrons, every {period:.3g} pixels {way}"
    text = f"the residuals have a pattern: {text}, as of pick-up, readout, fringes, or light that is not in the model"
    return [Finding("pattern", "doubt", text, numbers)]
