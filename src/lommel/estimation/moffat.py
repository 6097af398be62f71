"""Fit of Moffat's profile to the image of a star: its width, shape, place and light, with standard errors."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.engine import star_likelihood
from lommel.estimation.star_images import background_level
from lommel.fit.findings import Findings, FitReport
from lommel.fit.goodness_of_fit import chi2_findings
from lommel.fit.scoring import Policy, RowModel, Scores, covariance, reduced_chi2, search_rows
from lommel.recorded.counts import Counts, recording_findings
from lommel.recorded.noise import Noise
from lommel.special.legendre import gauss_legendre

_NAMES = ("flux", "row", "column", "fwhm", "beta", "background")
_STEPS = 200
_POLICY = Policy(settled=1e-9, patience=math.inf)  # nearer than a standard error by far, and of misfits too
_DARK = 1e-3  # electrons squared: the smallest variance of reading
_BETA = (1.05, 100.0)  # of less the light is infinite; of more it is a Gaussian
_NARROWEST = 0.2  # fwhm, pixels
_HOLD_BETA, _HOLD_SKY = "beta= (4.765 of seeing)", "background="


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class MoffatFit(FitReport):
    r"""Moffat's profile of a star, ``I = I_0 (1 + r^2 / alpha^2)^{-beta}`` plus a background.

    Attributes
    ----------
    flux : float
        All light of the profile, electrons, to infinity: ``pi alpha^2 I_0 / (beta - 1)``. It is less than that of a
        star whose halo falls more slowly, as of seeing: see the notes of :func:`fit_moffat`.
    row, column : float
        Centre, pixels, 0 in the middle of the first.
    fwhm : float
        Full width at half maximum, in the unit of the pixel pitch: ``2 alpha sqrt(2^(1/beta) - 1)``.
    beta : float
        Exponent: 4.765 for the atmosphere without outer scale, 2 to 4 as measured; at most 100, a Gaussian.
    background : float
        Electrons a pixel.
    errors : dict of str to float
        Standard errors of all these, from Fisher's information; the errors of `beta` and `flux` go together. They are
        0 of numbers that were held, and infinite of the exponent of a Gaussian.
    chi2 : float
        Sum of squared residuals over their variances, over what noise leaves of it: near 1 where the profile fits.
    findings, summary, converged, reliable, status, message
        As of :class:`lommel.fit.FitReport`: whether the profile explains the image, and pixels left out.
    """

    flux: float
    row: float
    column: float
    fwhm: float
    beta: float
    background: float
    errors: dict[str, float]
    chi2: float

    def __repr__(self) -> str:
        words = {0.0: "held", math.inf: "a Gaussian"}
        errors = {n: f"({words[e]})" if e in words else f"+- {e:.2g}" for n, e in self.errors.items()}
        listed = ", ".join(f"{n}={getattr(self, n):.6g} {errors[n]}" for n in _NAMES)
        return f"<MoffatFit {listed}, {self.status}, chi2 {self.chi2:.3g}>"


def fit_moffat(
    image: ArrayLike,
    noise: Noise,
    *,
    pixel: float = 1.0,
    beta: float | None = None,
    background: float | None = None,
    mask: ArrayLike | None = None,
    saturation: float | None = None,
) -> MoffatFit:
    """Fit Moffat's profile, averaged over pixels, and a background to the image of a star.

    The parameters of maximum likelihood for Poisson's photons and Gaussian read noise, by damped steps of Fisher
    scoring.

    Parameters
    ----------
    image : array_like, shape (height, width)
        A window around the star, at least 5 x 5; NaN marks pixels that do not count.
    noise : Noise
        Of the sensor.
    pixel : float, default 1
        Pixel pitch, the unit of `fwhm`: metres, arcseconds or pixels.
    beta : float, optional
        Exponent that is held, from 1.05 to 100; by default it is fitted. Dim stars, and windows of less than about
        five widths, determine flux, exponent and background only together.
    background : float, optional
        Background that is held, electrons a pixel, as measured beside the star; by default it is fitted.
    mask : array_like of bool, shape (height, width), optional
        True for pixels that do not count, as NaN.
    saturation : float, optional
        Value from which on pixels are full and do not count; by default what the image tells.

    Returns
    -------
    MoffatFit

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, too few pixels count, the flux is below two standard errors, or the fit has
        not settled or ends at a limit: a centre beyond the window, a width below 0.2 pixels or above 4 windows, an
        exponent of 1.05.

    Notes
    -----
    A star seen through Kolmogorov's turbulence has a halo that falls as ``r^(-11/3)``, more slowly than the profile,
    whose background takes a part of it. In windows of 3, 5 and 8 widths the flux of the fit is too small by 8, 5 and
    4 % where read noise or sky dominate, by 6, 3 and 2 % where the star's photon noise does, and with ``beta=4.765``
    by 3 to 5 %, beside standard errors that assume the profile. The width is within 2 % where read noise or sky
    dominate, and up to 7 % too small for bright stars in wide windows. The table is in the
    guide, "Seeing, jitter and pixels".

    References
    ----------
    A. F. J. Moffat, Astron. Astrophys. 3, 455 (1969). I. Trujillo, J. A. L. Aguerri, J. Cepa and C. M. Gutierrez,
    "The effects of seeing on Sersic profiles II: the Moffat PSF", Mon. Not. R. Astron. Soc. 328, 977 (2001),
    doi:10.1046/j.1365-8711.2001.04937.x.
    """
    counts = Counts.of("image", image, sides=(2,), shape="(height, width)", mask=mask, saturation=saturation)
    shape = counts.values.shape
    if min(shape) < 5:
        raise ValueError(f"image must be at least 5 x 5, got shape {shape}")
    validation.instance("noise", noise, Noise)
    pitch = validation.real("pixel", pixel, above=0.0)
    known = counts.known
    if known.sum() < 3 * len(_NAMES):
        raise ValueError(
            f"image must have {3 * len(_NAMES)} pixels that count at least, neither NaN, masked nor full, got "
            f"{int(known.sum())}"
        )
    gain, camera = noise.excess, noise.poisson
    data = np.where(known, camera.electrons(counts.filled()), 0.0)
    if background is not None:
        background = validation.real("background", background) / gain
    start = _start(data, known, background)
    if beta is not None:
        start[4] = validation.real("beta", beta, least=_BETA[0], most=_BETA[1])
    held = np.array([False] * 4 + [beta is not None, background is not None])
    star = _StarProfile(data, camera.variance(np.zeros(shape)), known, held)
    x, scores, stopped, _ = search_rows(star, start[None], _STEPS, lambda *_: None, fast=False, policy=_POLICY)
    p, settled, low, high = x[0], bool(stopped[0]), *star.limits
    errors = np.zeros(len(p))
    errors[~held] = np.sqrt(np.diag(covariance(star.information(p)[np.ix_(~held, ~held)])))
    choices = [text for text, is_held in zip((_HOLD_BETA, _HOLD_SKY), held[4:].tolist(), strict=True) if not is_held]
    advice = f". Give {' or '.join(choices)} to hold it, or take a larger window" if choices else ""
    if not p[0] > 2.0 * errors[0]:
        raise ValueError(
            f"image must show a star above its background, got a flux of {p[0]:.3g} +- {errors[0]:.2g} electrons"
            + advice
        )
    gaussian = p[4] == _BETA[1] and not held[4]
    at_end = ((p == low) | (p == high)) & ~held
    at_end[4] &= not gaussian
    if at_end.any() or not settled:
        ends = ", ".join(f"{_NAMES[i]} at its limit {p[i]:.4g}" for i in np.flatnonzero(at_end))
        raise ValueError(
            f"image must show a star that the profile fits; the fit ended with {ends or 'no solution'}{advice}"
        )
    if gaussian:
        errors[4] = math.inf
    scale = np.array([gain, 1.0, 1.0, pitch, 1.0, gain])
    chi2 = float(scores.chi2[0])
    causes = "the star is not of this profile: a companion, a halo, trailing, or gain and read noise are others"
    return MoffatFit(
        **dict(zip(_NAMES, (p * scale).tolist(), strict=True)),
        errors=dict(zip(_NAMES, (errors * scale).tolist(), strict=True)),
        chi2=chi2,
        findings=Findings(
            [*chi2_findings(chi2, float(scores.spread[0]), causes), *recording_findings([counts], noise, "image")]
        ),
        summary=f"chi2 {chi2:.4g}",
    )


class _StarProfile(RowModel):
    """The profile of a star averaged over pixels, as a function of rows of flux, centre, width, exponent, background.

    Parameters at a limit, towards which the likelihood rises, and those `held` stay where they are.
    """

    alternatives = False
    size = len(_NAMES)

    def __init__(self, data: Array, reading: Array, known: NDArray[np.bool_], held: NDArray[np.bool_]) -> None:
        self.shape, self.held = data.shape, held
        rows, columns = data.shape
        least = [-math.inf, -0.5, -0.5, _NARROWEST, _BETA[0], -math.inf]
        most = [math.inf, rows - 0.5, columns - 0.5, 4.0 * max(rows, columns), _BETA[1], math.inf]
        self.limits = np.array(least), np.array(most)
        parts = data, reading, np.maximum(reading, _DARK), known
        self.star = np.stack([np.asarray(part, dtype=np.float64).reshape(1, -1) for part in parts])
        self.free = int((~held).sum())
        self.tested = int(known.sum()) - self.free

    def images(self, x: Array, *, fast: bool = False) -> tuple[Array, list[Array]]:
        """Return profiles of unit flux (s, height, width), and their derivatives by centre, width and exponent."""
        values, slopes = zip(*(_profile(row[1:5], self.shape) for row in x), strict=True)
        return np.stack(values), list(np.stack(slopes, axis=1))

    def scores_of(self, x: Array, values: Array, slopes: Sequence[Array]) -> Scores:
        """Return the same from profiles and their derivatives."""
        numbers, products = self._products(x, values, slopes)
        _, total, spread = numbers[..., 0]
        # Less that of the counts themselves, or sums of bright stars are rounded by more than steps gain at the end.
        counted, _, read, known = self.star[:, 0]
        mean = x[:, :1] * values.reshape(len(x), -1) + x[:, 5:]
        counts = np.maximum(counted + read, 1e-300)
        over = np.maximum(mean + read, 0.25 * read) / counts - 1.0
        deviance = (counts * (over - np.log1p(over))) @ known
        share = self.tested / (self.tested + self.free)
        quality = reduced_chi2(products[:, -1, -1], total, spread, share, 1e-300)
        slope, information = products[:, :-1, -1], products[:, :-1, :-1]
        free = np.where(slope > 0.0, x < self.limits[1], x > self.limits[0]) & ~self.held
        information = np.where(free[:, :, None] & free[:, None, :], information, 0.0)
        return Scores(deviance, slope * free, information, *quality)

    def information(self, x: Array) -> Array:
        """Return Fisher's information (6, 6) for one row of parameters."""
        return np.asarray(self._products(x[None], *self.images(x[None]))[1][0, :-1, :-1])

    def _products(self, x: Array, values: Array, slopes: Sequence[Array]) -> tuple[Array, Array]:
        """Return the numbers and products of :func:`star_likelihood`, by parameters in their order and residual."""
        light = np.ascontiguousarray(x[:, (0, 5)])[:, :, None]
        numbers, products = star_likelihood([values, *slopes], light, self.star, 1)
        factors = np.ones((len(x), self.size + 1))
        factors[:, 1:5] = x[:, :1]
        order = [4, 0, 1, 2, 3, 5, 6]
        found = products[:, 0][:, order][:, :, order] * factors[:, :, None] * factors[:, None, :]
        return numbers, np.asarray(found)

    def within(self, x: Array, before: Array) -> Array:
        """Limit parameters in place."""
        return np.clip(x, *self.limits, out=x)


def _start(data: Array, counts: NDArray[np.bool_], background: float | None) -> Array:
    """Return parameters to begin with: of the profile of exponent 3 that stands out most above the median edge."""
    level = float(background_level(data, counts)) if background is None else background
    # Matched filters: the brightest pixel of a window is often not that of a dim star.
    size = tuple(2 * side for side in data.shape)
    light = np.fft.rfft2(np.where(counts, data - level, 0.0), size)
    y, x = (np.fft.fftfreq(side, 1.0 / side) for side in size)
    best, found = -math.inf, np.empty(len(_NAMES))
    for fwhm in 2.0 ** np.arange(0.0, math.log2(max(data.shape)), 0.5):
        square = fwhm**2 / (4.0 * (2.0 ** (1.0 / 3.0) - 1.0))  # alpha^2
        profile = (1.0 + (y[:, None] ** 2 + x**2) / square) ** -3.0
        norm = float((profile**2).sum())
        sums = np.fft.irfft2(light * np.fft.rfft2(profile), size)[: data.shape[0], : data.shape[1]]
        row, column = divmod(int(sums.argmax()), data.shape[1])
        if (score := sums[row, column] / math.sqrt(norm)) > best:
            flux = max(float(sums[row, column]) / norm, 1e-6) * math.pi * square / 2.0
            best, found = score, np.array([flux, row, column, fwhm, 3.0, level])
    return found


def _profile(p: Array, shape: tuple[int, ...]) -> tuple[Array, Array]:
    """Return the profile of unit flux averaged over each pixel, and its derivatives (4, height, width).

    `p` is its row, column, width and exponent.
    """
    row, column, fwhm, beta = p
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
    slopes = [
        mean(unit * fall * square * 2.0 * u * np.ones_like(v)),
        mean(unit * fall * square * 2.0 * v * np.ones_like(u)),
        mean(by_square) * (-2.0 / fwhm),
        mean(unit * (1.0 / (beta - 1.0) - log) + by_square * turn),
    ]
    return mean(unit), np.stack(slopes)
