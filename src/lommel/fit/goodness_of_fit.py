r"""Goodness of fit: tests of chi2, of the variance of photon noise, and of stripes in residuals.

`chi2` is Pearson's sum divided by its expectation, and s the standard deviation of chi2. Its distribution is close to
a gamma distribution of mean 1 and standard deviation s, that of a chi-squared variable divided by its 2 / s^2 degrees
of freedom (Satterthwaite 1946, doi:10.2307/3002019). Counts of few electrons yield fewer degrees of freedom than
pixels.

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
"""Probability that a correct fit is reported as a misfit."""
SURE = 1e-3
"""Probability that a search continues although its fit is correct."""
_RARE = 1e-2  # probability below which a chi2 is reported
_EXCEEDS = 5.0  # smallest significance of excess noise that is reported, standard deviations
_RANGE = 0.8, 1.4  # range of `share` for electron multiplication: 1 at high gain, more if there is also a misfit
_CELLS = 8  # number of groups of pixels of similar light
_FLAT = 0.3  # largest difference of the share of a cell from that of all pixels, plus five standard deviations
_MIN_PHOTON_PART = 0.1  # smallest s = m / v of a pixel that is used to test the variance of photons
_REAL = 1e-6  # relative variance of the imaginary part below which a transform counts as real
_LEAST_SIDE = 6  # smallest side of windows for the test of stripes, pixels


def most(spread: Any, probability: float = BY_CHANCE) -> Array:
    """Return the chi2 that noise exceeds with this probability, for a standard deviation `spread` of chi2."""
    # The gamma distribution of mean 1 and standard deviation s has the shape 1 / s^2.
    shape = 1.0 / np.square(np.maximum(spread, 1e-9))
    return np.asarray(special.gammainccinv(shape, probability) / shape)


def least(spread: Any, probability: float = BY_CHANCE) -> Array:
    """Return the chi2 that noise falls below with this probability."""
    shape = 1.0 / np.square(np.maximum(spread, 1e-9))
    return np.asarray(special.gammaincinv(shape, probability) / shape)


def chance(chi2: float, spread: float) -> float:
    """Return the probability that noise alone causes a chi2 of this value or more."""
    shape = 1.0 / max(spread, 1e-9) ** 2
    return float(special.gammaincc(shape, shape * chi2))


def chi2_findings(chi2: float, spread: float, causes: str) -> list[Finding]:
    """Return the finding of a chi2 that noise does not explain or explains rarely; a doubt below a probability SURE.

    `causes` is a text on possible causes of a misfit, or "" if another finding has them.
    """
    limit, floor, rare = float(most(spread)), float(least(spread)), chance(chi2, spread)
    numbers = {"chi2": chi2, "limit": limit, "least": floor, "chance": rare}
    if chi2 >= limit:
        text = "; ".join(filter(None, (f"noise alone stays below {limit:.3g}", causes)))
        return [Finding("misfit", "error", text, numbers)]
    if chi2 < floor:
        text = "the images are less noisy than gain, read noise and offset state, so that standard errors do not hold"
        return [Finding("too_quiet", "doubt", text, numbers)]
    if rare < _RARE:
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
        (actual variance - assumed variance) / light: ``excess - 1``, or 0 if the assumed noise is right.
    error : float
        Standard error of `share` if the assumed noise is right.
    flat : bool
        Whether dim and bright pixels have the same share, which indicates the camera and not wrong means.
    """

    share: float
    error: float
    flat: bool

    @property
    def sigmas(self) -> float:
        """`share` divided by its standard error; 0 if the error is infinite."""
        return self.share / self.error if np.isfinite(self.error) else 0.0

    @property
    def found(self) -> bool:
        """Whether there is noise of electron multiplication: `share` is flat, significant and near 1."""
        return self.flat and self.sigmas > _EXCEEDS and _RANGE[0] <= self.share <= _RANGE[1]

    def findings(self, excess: float) -> list[Finding]:
        """Return the finding on electron multiplication; none if an `excess` above 1 was stated."""
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
        For each pixel, in electrons: counts minus mean; mean; read variance. Pixels with a residual of NaN are
        ignored. Residuals of fits with few pixels per parameter are too small: multiply them by
        ``sqrt(pixels / degrees of freedom)``.

    Returns
    -------
    ExcessTest
    """
    off, mean, added = (np.asarray(each, float).ravel() for each in np.broadcast_arrays(residual, light, read))
    variance = np.maximum(mean + added, 1e-9)
    s = np.maximum(mean, 0.0) / variance
    known = np.flatnonzero(np.isfinite(off) & (s > _MIN_PHOTON_PART))
    if not known.size:
        return ExcessTest(0.0, np.inf, flat=False)
    known = known[np.argsort(mean[known], kind="stable")]
    off, mean, variance, s = off[known], mean[known], variance[known], s[known]
    sums = np.stack([s * (off**2 / variance - 1.0), s * s, s * s * (2.0 + 1.0 / variance)])
    # Sums over all pixels, and over cells of pixels of similar light, each with an equal part of the total light.
    starts = np.unique(np.searchsorted(np.cumsum(mean), mean.sum() * np.arange(_CELLS) / _CELLS))
    beyond, information, spread = np.column_stack([sums.sum(axis=1), np.add.reduceat(sums, starts, axis=1)])
    shares, errors = beyond / information, np.sqrt(spread) / information
    # With the excess the variance of the statistic is about its square as large.
    share = float(shares[0])
    slack = _FLAT * max(share, 1.0) + 5.0 * (1.0 + max(share, 0.0)) * errors[1:]
    return ExcessTest(share, float(errors[0]), bool((np.abs(shares[1:] - share) <= slack).all()))


def stripe_findings(residual: Array, variance: Array, excess: float = 1.0) -> list[Finding]:
    """Return the finding of significant stripes, or offsets of rows or columns, in residuals.

    Parameters
    ----------
    residual, variance : ndarray, shape (images, height, width)
        Residuals (electrons) and variances (electrons^2), both for electrons divided by `excess`.
    excess : float, default 1
        Factor of the variance of an electron-multiplying camera.
    """
    weight = np.where(np.isfinite(residual) & (variance > 0.0), 1.0 / np.maximum(variance, 1e-9), 0.0)
    seen = (weight > 0.0).sum(axis=(1, 2)) > _LEAST_SIDE**2 // 2
    weight, residual = weight[seen], residual[seen]
    height, width = residual.shape[1:]
    if not len(weight) or min(height, width) < _LEAST_SIDE:
        return []
    # Subtract a plane from each window, because sloping backgrounds are not stripes.
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
    # If the noise is larger than stated, the power of all wave vectors is increased: normalize by the median.
    squares /= max(1.0, float(np.median(squares / (2.0 * special.gammaincinv(0.5 * freedom, 0.5)))))
    alone = special.gammaincc(0.5 * freedom, 0.5 * squares)
    alone[:2, :2] = alone[-1, :2] = 1.0  # as wide as the window are backgrounds and their slopes
    i, j = np.unravel_index(int(alone.argmin()), alone.shape)
    power = {"stripes": (squares[i, j] - freedom[i, j], len(weight) / freedom[i, j])}
    # The smallest of n independent probabilities is multiplied by n (Bonferroni).
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
