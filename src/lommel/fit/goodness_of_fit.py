r"""Goodness of fit: tests of chi2, of the variance of photon noise, and of stripes in residuals.

`chi2` is Pearson's sum of squares divided by its expectation; s is the standard deviation of chi2. Its distribution
is close to that of a chi-squared variable divided by its number of degrees of freedom, 2 / s^2: a gamma distribution
of mean 1 and standard deviation s (Satterthwaite 1946, doi:10.2307/3002019). For images of few electrons, 2 / s^2 is
less than the number of pixels.

Excess noise: electron multiplication increases the variance of a pixel from ``v = m + read^2`` to ``v + f m``, where
m is the mean in electrons. With the residual r, the score test of f uses the statistic ``sum (m / v) (r^2 / v - 1)``,
twice the derivative of the log-likelihood at f = 0. For Poisson counts its variance is ``sum (m / v)^2 (2 + 1 / v)``.
A wrong mean also increases residuals, but mainly in bright pixels. Excess noise is therefore reported only if f is
about equal for dim and bright pixels.

Stripes: the score test of a sinusoid of wave vector k and any phase uses the statistic ``F(k) = sum r exp(-i k x) /
v``. With the Fourier transform W of 1 / v, the mean of ``abs(F)^2`` is ``W(0)``, and the mean of ``F^2`` is ``W(2
k)``. These means determine the covariance matrix of real and imaginary part. The squared length of (real, imaginary)
in the metric of its inverse has a chi-squared distribution with two degrees of freedom (one if F is real). Sums over
images are chi-squared, too. Wave vectors are half a period per window apart: at steps of a whole one, a wave between
them keeps as little as a sixth of its power. Dim pixels have the largest weight: for a wrong PSF, chi2 is the more
sensitive test.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base.arrays import Array
from lommel.fit.findings import Finding, Severity

BY_CHANCE = 1e-4
"""Probability that a correct fit is reported as a misfit."""
SURE = 1e-3
"""Probability that a search continues although its fit is correct."""
_RARE_CHANCE = 1e-2  # probability below which a chi2 is reported
_MIN_SIGMAS = 5.0  # smallest significance of excess noise that is reported, standard deviations
_RANGE = 0.8, 1.4  # range of f (`share`) for electron multiplication: 1 at high gain, more if there is also a misfit
_MIN_GAIN = 1.25  # smallest factor of a gain that is reported
_CELLS = 8  # number of groups of pixels of similar light
# Largest difference between f of a group and f of all pixels, in addition to five standard errors.
_MAX_VARIATION = 0.3
_MIN_PHOTON_PART = 0.1  # smallest m / v of pixels in the test of excess noise
_MAX_DEFECT = 1e-6  # 1 - (abs(W(2 k)) / W(0))^2 below which F counts as real
# Smallest deviation of an outlier, standard errors, and its smallest part of the sum of (squared deviation - 1).
_MIN_OUTLIER, _OUTLIER_SHARE = 8.0, 0.5
# A second star: smallest distance in pixels, and smallest part of (chi2 - 1) and gain in chi2 that it explains.
_NEAREST, _NEIGHBOUR_SHARE, _NEIGHBOUR_GAIN = 3.0, 0.5, 100.0
# Smallest ratio of an outlier to its neighbours but one, and number of places that are told.
_ALONE, _MOST_PLACES = 3.0, 4
_FINE_STEPS = np.linspace(-0.5, 0.5, 9)  # wave vectors about the most significant one, periods in the window
# Smallest part of a misfit that a pattern explains, and the misfit, standard deviations, from which this is required.
_PATTERN_SHARE, _LARGE_MISFIT = 0.3, 4.0
_LEAST_SIDE = 6  # smallest side of windows for the test of stripes, pixels
_TOGETHER = 64  # number of images whose Fourier transforms are in memory at a time


def largest_plausible_chi2(spread: Any, probability: float = BY_CHANCE) -> Array:
    """Return the chi2 that noise exceeds with this probability, for a standard deviation `spread` of chi2."""
    # The gamma distribution of mean 1 and standard deviation s has the shape 1 / s^2.
    shape = 1.0 / np.square(np.maximum(spread, 1e-9))
    return np.asarray(scipy.special.gammainccinv(shape, probability) / shape)


def smallest_plausible_chi2(spread: Any, probability: float = BY_CHANCE) -> Array:
    """Return the chi2 that noise falls below with this probability."""
    shape = 1.0 / np.square(np.maximum(spread, 1e-9))
    return np.asarray(scipy.special.gammaincinv(shape, probability) / shape)


def chance(chi2: float, spread: float) -> float:
    """Return the probability that noise alone causes a chi2 of this value or more."""
    shape = 1.0 / max(spread, 1e-9) ** 2
    return float(scipy.special.gammaincc(shape, shape * chi2))


def chi2_findings(chi2: float, spread: float, causes: str, *, freed: bool = False) -> list[Finding]:
    """Return the finding on a chi2 that noise does not explain, or explains only with a small probability.

    `causes` is a text on possible causes of a misfit, or "" if another finding has them. Effects that are `freed`
    besides those asked for may stand for another one, which they do not quite explain: a rare chi2 is then a doubt.
    """
    limit, floor = float(largest_plausible_chi2(spread)), float(smallest_plausible_chi2(spread))
    probability = chance(chi2, spread)
    numbers = {"chi2": chi2, "limit": limit, "least": floor, "chance": probability}
    if chi2 >= limit:
        text = "; ".join(filter(None, (f"noise alone keeps chi2 below {limit:.3g}", causes)))
        return [Finding("misfit", "error", text, numbers)]
    if chi2 < floor:
        text = "the images are less noisy than gain, read noise and offset imply: standard errors are not valid"
        return [Finding("too_quiet", "doubt", text, numbers)]
    if probability < _RARE_CHANCE:
        percent = f"{100.0 * max(probability, 1e-6):.1g}"
        severity: Severity = "doubt" if freed or probability < SURE else "note"
        return [Finding("rare_chi2", severity, f"noise alone exceeds this chi2 in {percent} % of fits", numbers)]
    return []


@dataclass(frozen=True)
class ExcessTest:
    """Result of :func:`excess_test`.

    Attributes
    ----------
    share : float
        f = (actual variance - assumed variance) / light: ``excess - 1``, or 0 if the assumed noise is right.
    error : float
        Standard error of `share` if the assumed noise is right.
    flat : bool
        Whether `share` is about equal for dim and bright pixels: the cause is then the camera, not a wrong mean.
    gain : float
        Stated gain / the gain that explains the variance of dim and bright pixels alike; 1 if none does, or if the
        stated one does.
    """

    share: float
    error: float
    flat: bool
    gain: float = 1.0

    @property
    def sigmas(self) -> float:
        """`share` divided by its standard error; 0 if the error is infinite."""
        return self.share / self.error if np.isfinite(self.error) else 0.0

    @property
    def found(self) -> bool:
        """Whether there is noise of electron multiplication: `share` is significant, near 1, and `flat`."""
        return self.flat and self.sigmas > _MIN_SIGMAS and _RANGE[0] <= self.share <= _RANGE[1]

    def findings(self, excess: float) -> list[Finding]:
        """Return the finding on electron multiplication or another gain; none if an `excess` above 1 was stated."""
        if excess > 1.0 or not (self.found or self.gain != 1.0):
            return []
        if not self.found:
            text = f"the gain (electrons per count) is probably {1.0 / self.gain:.2g} times the stated gain"
            text = (
                f"dim and bright pixels are {'more' if self.gain > 1.0 else 'less'} noisy than photons alike: {text}"
            )
            text += ", or the images are averages" * (self.gain < 1.0)
            return [Finding("gain", "error" if self.gain > 1.0 else "doubt", text, {"factor": self.gain})]
        factor = 1.0 + self.share
        gain = factor if self.gain == 1.0 else self.gain
        text = (
            f"the variance is {factor:.2f} times that of photons, at dim and bright pixels alike: state excess=2 if "
            f"the camera multiplies electrons; otherwise the gain may be {1.0 / gain:.2g} times the stated gain"
        )
        numbers = {"factor": factor, "error": self.error, "sigmas": self.sigmas}
        return [Finding("excess_noise", "error", text, numbers)]


def excess_test(residual: ArrayLike, light: ArrayLike, read: ArrayLike) -> ExcessTest:
    """Test whether residuals have the excess noise of electron multiplication.

    Parameters
    ----------
    residual, light, read : array_like, which broadcast
        Counts minus mean (electrons), mean (electrons) and read variance (electrons^2) of each pixel. Pixels with a
        residual of NaN are ignored. A fit reduces residuals: multiply them by ``sqrt(pixels / degrees of freedom)``
        if there are few pixels per parameter.

    Returns
    -------
    ExcessTest
    """
    r, mean, read_variance = (np.asarray(part, float).ravel() for part in np.broadcast_arrays(residual, light, read))
    variance = np.maximum(mean + read_variance, 1e-9)
    photon_part = np.maximum(mean, 0.0) / variance
    indices = np.flatnonzero(np.isfinite(r) & (photon_part > _MIN_PHOTON_PART))
    if not indices.size:
        return ExcessTest(0.0, np.inf, flat=False)
    indices = indices[np.argsort(mean[indices], kind="stable")]
    r, mean, variance, photon_part = r[indices], mean[indices], variance[indices], photon_part[indices]
    read_variance = variance - mean
    plain, more = (_share(r, mean, variance, photon_part, read_variance, square) for square in (1.0, 2.0))
    # The share falls linearly with the square of the gain; both agree at the positive root of a quadratic equation.
    per_square = plain.share - more.share
    squares = 1.0 + plain.share + per_square
    gain = 2.0 * squares / (1.0 + math.sqrt(1.0 + 4.0 * per_square * squares))
    scaled = _share(r, mean, variance, photon_part, read_variance, gain**2)
    is_other = scaled.flat and abs(scaled.sigmas) > _MIN_SIGMAS and not 1.0 / _MIN_GAIN < gain < _MIN_GAIN
    return replace(plain, gain=gain if is_other else 1.0)


def _share(r: Array, mean: Array, variance: Array, photon_part: Array, read: Array, square: float) -> ExcessTest:
    """Return the test of pixels in the order of their light, for `square` times the read variance."""
    squared = photon_part * photon_part
    excess = (r**2 - (square - 1.0) * read) / variance - 1.0
    terms = np.stack([photon_part * excess, squared, squared * (2.0 + 1.0 / variance)])
    # Sums over all pixels, and over groups of pixels of similar light, each with an equal part of the total light.
    starts = np.unique(np.searchsorted(np.cumsum(mean), mean.sum() * np.arange(_CELLS) / _CELLS))
    statistic, information, variances = np.column_stack([terms.sum(axis=1), np.add.reduceat(terms, starts, axis=1)])
    shares, errors = statistic / information, np.sqrt(variances) / information
    # Excess noise increases the standard errors by about the factor 1 + share.
    share = float(shares[0])
    slack = _MAX_VARIATION * max(share, 1.0) + 5.0 * (1.0 + max(share, 0.0)) * errors[1:]
    return ExcessTest(share, float(errors[0]), bool((np.abs(shares[1:] - share) <= slack).all()))


def outlier_findings(residual: Array) -> list[Finding]:
    """Return the finding on single pixels that explain more than half of a chi2 above 1.

    Such pixels deviate far more than all but one of their neighbours do.

    Parameters
    ----------
    residual : ndarray, shape (images, height, width)
        Residuals in standard errors; NaN where unknown.
    """
    known = np.nan_to_num(residual)
    sizes, squares = np.abs(known), np.nan_to_num(residual**2 - 1.0)
    ring = np.ones((1, 3, 3), dtype=bool)
    ring[0, 1, 1] = False
    neighbours = scipy.ndimage.rank_filter(sizes, -2, footprint=ring, mode="constant")
    is_single = (sizes > _MIN_OUTLIER) & (sizes > _ALONE * neighbours)
    if squares[is_single].sum() < max(_OUTLIER_SHARE * squares.sum(), 1.0):
        return []
    places = np.argwhere(is_single)
    places = places[np.argsort(-sizes[is_single], kind="stable")]
    most = places[0].tolist()
    sigmas = float(known[tuple(most)])
    side, worst = "brighter" if sigmas > 0.0 else "darker", f"{abs(sigmas):.3g} standard errors"
    texts = [f"row {row} column {column} of image {image + 1}" for image, row, column in places.tolist()]
    text = f"pixel (row {most[1]}, column {most[2]}) of image {most[0] + 1} is {worst} {side} than the fit: "
    advice = "a defective pixel or a cosmic ray; mask it"
    if len(places) > 1:
        listed = ", ".join(texts[:_MOST_PLACES]) + ", ..." * (len(texts) > _MOST_PLACES)
        text = f"{len(places)} single pixels differ from the fit by up to {worst} ({listed}): "
        advice = "defective pixels or cosmic rays, to be masked"
    numbers = {"place": tuple(most), "sigmas": sigmas, "pixels": len(places)}
    return [Finding("hot_pixels", "doubt", text + advice, numbers)]


def spot_findings(findings: Sequence[Finding], residual: Array, variance: Array, light: Array) -> list[Finding]:
    """Return findings on single pixels or, if a misfit in `findings` is not due to these, on a second star.

    Arrays are those of :func:`neighbour_findings`.
    """
    found = outlier_findings(residual / np.sqrt(variance))
    is_misfit = any(finding.code == "misfit" for finding in findings)
    return neighbour_findings(residual, variance, light) if is_misfit and not found else found


def neighbour_findings(residual: Array, variance: Array, light: Array) -> list[Finding]:
    """Return the finding on a second star beside the first that explains a large part of a misfit.

    Parameters
    ----------
    residual, variance, light : ndarray, shape (images, height, width)
        Residuals (electrons, NaN where unknown), variances, and light of the star in each image.
    """
    weight = np.where(np.isfinite(residual), 1.0 / variance, 0.0)
    known = np.nan_to_num(residual)

    def matched(part: Array, star: Array) -> Array:
        # scipy.signal is slow to import.
        lags = [2 * side - 1 for side in part.shape[1:]]
        sides = [scipy.fft.next_fast_len(count, real=True) for count in lags]
        spectra = scipy.fft.rfft2(part, sides) * scipy.fft.rfft2(star[:, ::-1, ::-1], sides)
        return np.asarray(scipy.fft.irfft2(spectra.sum(axis=0), sides)[: lags[0], : lags[1]], np.float64)

    # For each displacement, the light of a second star relative to the first, by least squares.
    gradient, information = matched(weight * known, light), np.maximum(matched(weight, light**2), 1e-9)
    height, width = residual.shape[1:]
    rows, columns = np.ogrid[1 - height : height, 1 - width : width]
    inside = (np.abs(rows) < height // 2) & (np.abs(columns) < width // 2) & (np.hypot(rows, columns) > _NEAREST)
    gain = np.where(inside & (gradient > 0.0), gradient**2 / information, 0.0)
    row, column = map(int, np.unravel_index(int(gain.argmax()), gain.shape))
    excess = float((weight * known**2 - (weight > 0.0)).sum())
    if gain[row, column] < max(_NEIGHBOUR_SHARE * excess, _NEIGHBOUR_GAIN):
        return []
    share, place = float(gradient[row, column] / information[row, column]), (row + 1 - height, column + 1 - width)
    text = (
        f"another star of about {100.0 * share:.2g} % of the light, {place[0]:+d} rows and {place[1]:+d} columns "
        f"away, explains {100.0 * gain[row, column] / excess:.0f} % of the misfit: mask it, or cut it off"
    )
    return [Finding("other_explanation", "doubt", text, {"share": share, "place": place})]


def stripe_findings(residual: Array, variance: Array, excess: float = 1.0) -> list[Finding]:
    """Return the finding on significant stripes, or offsets of rows or columns, in residuals.

    Parameters
    ----------
    residual, variance : ndarray, shape (images, height, width)
        Residuals (electrons) and variances (electrons^2), both for electrons divided by `excess`.
    excess : float, default 1
        Excess noise factor: the factor by which electron multiplication increases the variance of the light.
    """
    weight = np.where(np.isfinite(residual) & (variance > 0.0), 1.0 / np.maximum(variance, 1e-9), 0.0)
    usable = (weight > 0.0).sum(axis=(1, 2)) > _LEAST_SIDE**2 // 2
    if not usable.all():
        weight, residual = weight[usable], residual[usable]
    height, width = residual.shape[1:]
    if not len(weight) or min(height, width) < _LEAST_SIDE:
        return []
    # Subtract a plane from each window, because sloping backgrounds are not stripes.
    plane = np.stack([np.ones((height, width)), *np.mgrid[:height, :width]])
    normal = np.einsum("iyx,nyx,jyx->nij", plane, weight, plane)
    residual = np.nan_to_num(residual)
    pull = np.einsum("iyx,nyx,nyx->ni", plane, weight, residual)
    residual -= np.tensordot(np.linalg.solve(normal, pull[..., None])[..., 0], plane, 1)
    # One of each pair of opposite wave vectors is sufficient.
    rows, columns = 0.5 * np.arange(2 * height), 0.5 * np.arange(width + 1)
    score, total = residual * weight, weight.sum(axis=(1, 2))
    squares, freedom = np.zeros((2, len(rows), len(columns)))
    for first in range(0, len(score), _TOGETHER):
        part = slice(first, first + _TOGETHER)
        f = np.fft.rfft2(score[part], (2 * height, 2 * width))
        w_2k = np.fft.fft2(weight[part])[:, np.arange(2 * height)[:, None] % height, np.arange(width + 1) % width]
        sums = _wave_squares(f, w_2k, total[part])
        squares, freedom = squares + sums[0], freedom + sums[1]
    # If the noise is larger than stated, the power of all wave vectors is increased: normalize by the median.
    levels, level = np.unique(freedom, return_inverse=True)  # few: special functions of all waves would take longer
    medians = 2.0 * scipy.special.gammaincinv(0.5 * levels, 0.5)
    dispersion = max(1.0, float(np.median(squares / medians[level].reshape(squares.shape))))
    squares /= dispersion
    searched = squares.copy()
    # Periods as long as the window are backgrounds, not stripes.
    searched[np.ix_(np.minimum(rows, height - rows) < 2.0, columns < 2.0)] = 0.0
    # The least probable wave of each number of degrees of freedom; of strong stripes, several probabilities are 0.
    largest = [int(np.where(freedom == number, searched, -1.0).argmax()) for number in levels]
    probabilities = scipy.special.gammaincc(0.5 * levels, 0.5 * searched.flat[largest])
    probability, _, place = min(zip(probabilities, -searched.flat[largest], largest, strict=True))
    i, j = np.unravel_index(place, squares.shape)
    # The smallest of n probabilities is multiplied by n (Bonferroni).
    chances, power = {"stripes": float(probability) * squares.size}, {}
    for name, line, side in (("rows", np.s_[4 : height + 1 : 2, 0], height), ("columns", np.s_[0, 4::2], width)):
        square_sum, degrees = float(squares[line].sum()), float(freedom[line].sum())
        chances[name] = float(scipy.special.gammaincc(0.5 * degrees, 0.5 * square_sum))
        power[name] = square_sum - degrees, 2.0 * len(squares[line]) / side
    kind = min(chances, key=chances.__getitem__)
    if (chance := len(chances) * chances[kind]) >= SURE:
        return []
    wave: dict[str, float] = {}
    if kind == "stripes":
        # Near every second pixel, a period and an amplitude cannot be told apart within a window.
        steps = _FINE_STEPS if freedom[i, j] > len(weight) else np.zeros(1)
        rows, columns = rows[i] + steps, columns[j] + steps
        f, w_2k = _transform(score, rows, columns), _transform(weight, 2.0 * rows, 2.0 * columns)
        squares, freedom = _wave_squares(f, w_2k, total)
        excess_squares = squares / dispersion - freedom
        p, q = np.unravel_index(int(excess_squares.argmax()), excess_squares.shape)
        power[kind] = float(excess_squares[p, q]), len(weight) / float(freedom[p, q])
        # Of opposite wave vectors, the one that is at most 90 deg from x.
        fy, fx = math.copysign(1.0, columns[q]) * float(rows[p]) / height, abs(float(columns[q])) / width
        fy = (fy + 0.5) % 1.0 - 0.5
        wave = {"period": 1.0 / math.hypot(fy, fx), "angle": math.degrees(math.atan2(fy, fx))}
    excess_power, factor = power[kind]
    # Of a large misfit, a pattern is a name only if it explains a good part.
    rest = float((residual * score).sum()) / dispersion - (count := float((weight > 0.0).sum()))
    if rest > _LARGE_MISFIT * math.sqrt(2.0 * count) and excess_power < _PATTERN_SHARE * rest:
        return []
    # The power in excess of that of noise is converted to an rms offset in electrons.
    size = excess * math.sqrt(dispersion * excess_power / (factor * float(total.sum())))
    text = f"{kind} of pixels have offsets of {size:.2g} electrons rms"
    if wave:
        angle = wave["angle"]
        direction = {0: "along x", 90: "along y"}.get(round(abs(angle)), f"{angle:.0f} deg from x to y")
        text = f"stripes of +-{size:.2g} electrons, every {wave['period']:.3g} pixels {direction}"
    text = f"the residuals have a pattern: {text}; causes may be pick-up, readout, fringes, or light not in the model"
    return [Finding("pattern", "doubt", text, {"size": size, "chance": chance} | wave)]


def _transform(images: Array, rows: Array, columns: Array) -> NDArray[np.complex128]:
    """Return Fourier transforms at the wave vectors of these numbers of periods in the height and in the width."""
    height, width = images.shape[1:]
    along_y = np.exp(-2j * np.pi / height * np.outer(rows, np.arange(height)))
    along_x = np.exp(-2j * np.pi / width * np.outer(np.arange(width), columns))
    return np.asarray(np.tensordot(np.tensordot(images, along_x, 1), along_y, (1, 1)).swapaxes(1, 2))


def _wave_squares(f: NDArray[np.complex128], w_2k: NDArray[np.complex128], total: Array) -> tuple[Array, Array]:
    """Return the squares of waves, summed over images, and their numbers of degrees of freedom.

    Parameters
    ----------
    f, w_2k : ndarray, shape (images, m, n)
        F at each wave vector k, and the Fourier transform of 1 / v at 2 k.
    total : ndarray, shape (images,)
        W(0).

    Returns
    -------
    squares, freedom : ndarray, shape (m, n)
        Chi-squared distributed for noise alone.
    """
    total = total[:, None, None]
    determinant = total**2 - np.abs(w_2k) ** 2
    is_real = determinant < _MAX_DEFECT * total**2
    # The squared length in the metric of the inverse covariance, written with complex F.
    complex_squares = 2.0 * (total * np.abs(f) ** 2 - (f**2 * w_2k.conj()).real) / np.where(is_real, 1.0, determinant)
    squares = np.where(is_real, np.abs(f) ** 2 / total, complex_squares).sum(axis=0)
    return squares, np.where(is_real, 1.0, 2.0).sum(axis=0)
