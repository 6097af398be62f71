"""Fit of Moffat's profile to the image of a star: its width, shape, place and light, with standard errors."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.estimation.noise import Noise
from lommel.special.legendre import gauss_legendre

_NAMES = ("flux", "row", "column", "fwhm", "beta", "background")
_STEPS = 200
_BETA = (1.05, 100.0)  # of less the light is infinite; of more it is a Gaussian
_NARROWEST = 0.2  # fwhm, pixels


@dataclass(frozen=True, eq=False)
class MoffatFit:
    r"""Moffat's profile of a star, ``I = I_0 (1 + r^2 / alpha^2)^{-beta}`` plus a background.

    Attributes
    ----------
    flux : float
        All light of the star, electrons, to infinity: ``pi alpha^2 I_0 / (beta - 1)``.
    row, column : float
        Centre, pixels, 0 in the middle of the first.
    fwhm : float
        Full width at half maximum, in the unit of the pixel pitch: ``2 alpha sqrt(2^(1/beta) - 1)``.
    beta : float
        Exponent: 4.765 for the atmosphere without outer scale, 2 to 4 as measured; at most 100, nearly a Gaussian.
    background : float
        Electrons a pixel.
    deviations : dict of str to float
        Standard errors of all these, from Fisher's information; the errors of `beta` and `flux` go together.
    chi2 : float
        Sum of squared residuals over their variances, per degree of freedom: near 1 where the profile fits.
    """

    flux: float
    row: float
    column: float
    fwhm: float
    beta: float
    background: float
    deviations: dict[str, float]
    chi2: float

    def __repr__(self) -> str:
        listed = ", ".join(f"{n}={getattr(self, n):.6g} +- {self.deviations[n]:.2g}" for n in _NAMES)
        return f"<MoffatFit {listed}, chi2 {self.chi2:.3g}>"


def fit_moffat(image: ArrayLike, noise: Noise, *, pixel: float = 1.0) -> MoffatFit:
    """Fit Moffat's profile, averaged over pixels, and a background to the image of a star.

    The parameters of least squares weighted by the variance of the model (iteratively, which for photon noise is
    maximum likelihood), by damped steps (Levenberg and Marquardt).

    Parameters
    ----------
    image : array_like, shape (height, width)
        A window around the star, at least 5 x 5; NaN marks pixels that do not count.
    noise : Noise
        Of the sensor.
    pixel : float, default 1
        Pixel pitch, the unit of `fwhm`: metres, arcseconds or pixels.

    Returns
    -------
    MoffatFit

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, too few pixels count, no star stands out of the background, or the fit has not
        settled or ends at a limit: a centre beyond the window, a width below 0.2 pixels or above 4 windows, an
        exponent of 1.05.

    References
    ----------
    A. F. J. Moffat, Astron. Astrophys. 3, 455 (1969). I. Trujillo, J. A. L. Aguerri, J. Cepa and C. M. Gutierrez,
    "The effects of seeing on Sersic profiles II: the Moffat PSF", Mon. Not. R. Astron. Soc. 328, 977 (2001),
    doi:10.1046/j.1365-8711.2001.04937.x.
    """
    given = validation.number_array("image", image)
    if given.ndim != 2 or min(given.shape) < 5:
        raise ValueError(f"image must be at least 5 x 5, got shape {given.shape}")
    validation.instance("noise", noise, Noise)
    pitch = validation.real("pixel", pixel, above=0.0)
    counts = np.isfinite(given)
    if np.isinf(given).any() or counts.sum() < 3 * len(_NAMES):
        raise ValueError(
            f"image must be finite but for NaN, with {3 * len(_NAMES)} pixels that count at least, "
            f"got {int(counts.sum())}"
        )
    data = noise.electrons(np.where(counts, given, 0.0))
    p = _start(data, counts)
    low, high = _limits(given.shape)
    step, best, settled = 1e-3, math.inf, False
    for _ in range(_STEPS):
        model, slopes = _model(p, given.shape)
        variance = np.maximum(noise.variance(np.maximum(model, 0.0)), 1e-3)
        weight = np.where(counts, 1.0 / variance, 0.0)
        information = np.einsum("iyx,yx,jyx->ij", slopes, weight, slopes)
        score = np.einsum("iyx,yx,yx->i", slopes, weight, data - model)
        chi2 = float((weight * (data - model) ** 2).sum())
        size = np.sqrt(np.maximum(np.diag(information), 1e-300))
        scaled = information / np.outer(size, size)
        free = np.where(score > 0.0, p < high, p > low)  # others stay at their limit
        while True:
            system = np.where(np.outer(free, free), scaled, 0.0) + step * np.eye(len(p)) + np.diag(1.0 * ~free)
            tried = np.clip(p + np.linalg.solve(system, free * score / size) / size, low, high)
            there = _model(tried, given.shape)[0]
            if float((weight * (data - there) ** 2).sum()) <= chi2 or step > 1e12:
                break
            step *= 8.0
        settled = float(np.abs((tried - p) * size).max()) < 1e-6 and abs(best - chi2) <= 1e-9 * chi2
        p, step, best = tried, max(0.1 * step, 1e-12), chi2
        if settled:
            break
    covariance = np.linalg.pinv(scaled) / np.outer(size, size)
    errors = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    if not p[0] > 2.0 * errors[0]:
        raise ValueError(
            f"image must show a star above its background, got a flux of {p[0]:.3g} +- {errors[0]:.2g} electrons"
        )
    at_end = (p == low) | (p == high)
    at_end[4] = p[4] == low[4]  # of more it is a Gaussian
    if at_end.any() or not settled:
        ends = ", ".join(f"{_NAMES[i]} at its limit {p[i]:.4g}" for i in np.flatnonzero(at_end))
        raise ValueError(f"image must show a star that the profile fits; the fit ended with {ends or 'no solution'}")
    scale = np.array([1.0, 1.0, 1.0, pitch, 1.0, 1.0])
    numbers, errors = p * scale, errors * scale
    found = dict(zip(_NAMES, numbers.tolist(), strict=True))
    return MoffatFit(
        **found, deviations=dict(zip(_NAMES, errors.tolist(), strict=True)), chi2=best / (int(counts.sum()) - len(p))
    )


def _start(data: Array, counts: Array) -> Array:
    """Return parameters to begin with: from the median of the edge and the moments of what is above it."""
    edge = counts.copy()
    edge[1:-1, 1:-1] = False
    background = float(np.median(data[edge if edge.any() else counts]))
    above = np.where(counts, data - background, 0.0)
    row, column = np.unravel_index(int(above.argmax()), above.shape)
    peak = max(float(above.max()), 1e-6)
    wide = max(1.0, math.sqrt(float((above > 0.5 * peak).sum()) * 4.0 / math.pi))
    alpha = 0.5 * wide / math.sqrt(2.0 ** (1.0 / 3.0) - 1.0)
    return np.array([peak * math.pi * alpha**2 / 2.0, float(row), float(column), wide, 3.0, background])


def _limits(shape: tuple[int, ...]) -> tuple[Array, Array]:
    """Return the least and the largest parameters that a fit may find."""
    least = [-math.inf, -0.5, -0.5, _NARROWEST, _BETA[0], -math.inf]
    return np.array(least), np.array([math.inf, shape[0] - 0.5, shape[1] - 0.5, 4.0 * max(shape), _BETA[1], math.inf])


def _model(p: Array, shape: tuple[int, ...]) -> tuple[Array, Array]:
    """Return the average over each pixel, and its derivatives by the parameters, shape (6, height, width)."""
    flux, row, column, fwhm, beta, background = p
    root = 2.0 ** (1.0 / beta) - 1.0
    # Poles at i alpha: Gauss's rule of n nodes is off by about exp(-2 n arsinh(2 alpha)), here 1e-7.
    nodes = max(4, math.ceil(8.0 / math.asinh(fwhm / math.sqrt(root))))
    at, w = gauss_legendre(nodes, -0.5, 0.5)
    y, x = (np.arange(side)[:, None] + at - middle for side, middle in zip(shape, (row, column), strict=True))
    u, v = y[:, None, :, None], x[None, :, None, :]
    square = 4.0 * root / fwhm**2  # 1 / alpha^2
    q = square * (u * u + v * v)
    log = np.log1p(q)
    unit = (beta - 1.0) * square / math.pi * np.exp(-beta * log)

    def mean(values: Array) -> Array:
        return np.asarray(np.einsum("yxab,a,b->yx", values, w, w, optimize=True))

    # d ln(unit) by r^2, by ln(square), by beta at a fixed alpha; and ln(square) by beta.
    fall = beta / (1.0 + q)
    by_square = unit * (1.0 - q * fall)
    turn = -math.log(2.0) * (root + 1.0) / (beta**2 * root)
    star = mean(unit)
    slopes = [
        star,
        flux * mean(unit * fall * square * 2.0 * u * np.ones_like(v)),
        flux * mean(unit * fall * square * 2.0 * v * np.ones_like(u)),
        flux * mean(by_square) * (-2.0 / fwhm),
        flux * mean(unit * (1.0 / (beta - 1.0) - log) + by_square * turn),
        np.ones(star.shape),
    ]
    return flux * star + background, np.stack(slopes)
