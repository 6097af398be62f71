r"""Depth from defocus: filters by which two frames cancel at the true depth, as polynomials of one small filter.

The symbols are those of :mod:`lommel.estimation.focal_model`: h_i, N_i and Y_i are transfer function, noise and
spectrum of frame i, S is the power of the texture and u the vergence (1 / distance). Let ``q = sum of h_i^2 / N_i``,
and let W be S q / (1 + S q) times a high-pass filter. At the vergence u the residual of the frames i < j is

    e_ij = sqrt(W) (h_j Y_i - h_i Y_j) / sqrt(N_i N_j q) .

At the true u the scene cancels, whatever its texture, and the residual is noise. The energy, the mean of e_ij^2 over
a window, is lowest at this u. By Lagrange's identity the sum of the energies of all pairs is the energy of the
component of the vector of all Y_i orthogonal to the vector of all h_i. The transfer function of the pixel is a common
factor of all h_i and cancels: except for W, filters depend on \|f\| alone. They are approximated by

    e = sum over i, m of c_im T_m(2 B - 1) Y_i ,    B(f) = b(fx) b(fy) ,

with Chebyshev polynomials T_m, m = 0 to M, of a small filter b. Their recursion, M steps for each frame, is computed
once for all vergences, pairs and sharp images (compare McClellan, 7th Princeton Conference on Information Sciences,
1973). The coefficients c_im are a least-squares fit weighted by the power of scene and noise, because a filter that
does not vanish exactly lets the scene through in proportion to its power. The matrix of coefficients is reduced to a
few singular vectors, so that energies at all vergences are quadratic forms of few images.

The standard error sigma_u of the vergence is computed for the fitted filters. Let kappa be half of the second
derivative of the energy with respect to u, and n the number of pixels of a window. Half of the first derivative has
the variance ``mean of (S_ee S_dd + S_ed^2) / n``, or less if images are correlated over the size of a window. S_ee,
S_dd and S_ed are the spectrum of e, the spectrum of its derivative de/du, and their cross-spectrum. One part of the
variance is proportional to kappa, the other part is due to noise alone: ``sigma_u^2 = (texture_ratio kappa +
noise_variance) / (kappa^2 n)``. With little texture, noise dominates the measured curvature; kappa is then estimated
as ``curvature_ratio`` times (mean energy - minimum energy), where the ratio is computed for the model's texture.

A single frequency determines only the ratio of two transfer functions, which several vergences can share. Their
energies then differ by what the fitted filters let through, the ``leak``, whatever the light, and the lowest can be
that of another vergence. How few frequencies a texture has is measured by its ``concentration``, tr(P^2) / (tr P)^2
for the matrix P of the mean products of basis images: it is 1 for a single frequency. Basis images of the model's
texture are uncorrelated and of equal power: P is then about a multiple of the identity, and the concentration about
1 / (number of basis images).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base.arrays import Array
from lommel.core.engine import FocalStream
from lommel.estimation.focal_model import Band, FocalLight, FocalModel
from lommel.optics.lens import Lens

_HIGH_PASS = 0.012  # cycles per pixel: slower variations are due to exposure, shading and offsets
_MEAN_REJECTION = 1e4  # power / noise at frequency 0, assumed for each frame: residuals then ignore the mean
_SHARED_ALIASES = 0.4  # fraction of the model's alias power that is assumed: many scenes have less
_SHARP_LOSS = 0.01  # relative increase of the squared error of the Wiener filter by discarded singular vectors
_MARGIN = 0.08  # extension of the candidates at each end of the vergence range, as a fraction of this range
_MAX_AVERAGED = 61  # largest number of candidates over which energies are averaged; `curvature_ratio` uses this mean
_VISIBLE_CONTRAST, _VISIBLE = (
    0.3,
    9.0,
)  # a frequency is visible if its sine of this contrast drops log-likelihood by more
_SAMPLED = 13  # number of candidates for which the variance of products is computed; it is interpolated between them
_LEAKING = 90.0  # percentile over visible frequencies whose median over candidates is the leak
_MAX_BINNING_LOSS = 1.25  # largest factor by which binning may increase standard errors
# Designs in the order tried: taps, degree, discarded fraction of the norm of all filters, and the largest accepted
# median and maximum of standard error / Cramér-Rao bound. Short filters come first, because their residual at a pixel
# depends on fewer neighbouring pixels.
_DESIGNS = ((3, 8, 1e-2, 1.08, math.inf), (5, 12, 1e-2, 1.08, 1.45), (5, 12, 5e-3, math.inf, math.inf))
_MEAN_POWER = 1e7  # power / noise at frequency 0, assumed for sharp images: their filters then keep the mean


class Taps(NamedTuple):
    """The symmetric filter b along one axis: tap values at 0, 1, ... pixels from the middle."""

    values: tuple[float, ...]

    @classmethod
    def of(cls, count: int) -> Self:
        """Return the filter of three or five taps, with frequency w in radians per pixel.

        Three taps: ``b = cos^2(w / 2)``. Five taps: ``b = 1 - (4 / 3) s^2 + (4 / 9) s^4`` with s = sin(w / 2), for
        which the fourth order of log b vanishes, so that contours of B are circles to one more order.
        """
        if count == 3:
            return cls((0.5, 0.25))
        p, q = 4.0 / 3.0, 4.0 / 9.0
        return cls((1.0 - p / 2.0 + 3.0 * q / 8.0, (p - q) / 4.0, q / 16.0))

    def __call__(self, f: Array) -> Array:
        """Return b at frequencies in cycles per pixel."""
        w = 2.0 * math.pi * f
        return np.asarray(self.values[0] + 2.0 * sum(v * np.cos(k * w) for k, v in enumerate(self.values) if k))

    def padded(self) -> tuple[float, float, float]:
        """Return three values; the third is 0 for a filter of three taps."""
        centre, neighbour, *outer = self.values
        return centre, neighbour, outer[0] if outer else 0.0

    def chebyshev(self, fx: Array, fy: Array, degree: int) -> Array:
        """Return T_0 to T_degree of 2 B - 1, shape (degree + 1, frequencies)."""
        t = 2.0 * self(fx) * self(fy) - 1.0
        terms = [np.ones_like(t), t]
        while len(terms) <= degree:
            terms.append(2.0 * t * terms[-1] - terms[-2])
        return np.stack(terms[: degree + 1])


@dataclass(frozen=True)
class FocalTables:
    """Filters of the frames, energies of residuals and their statistics, at each of c candidate vergences.

    Attributes
    ----------
    vergence : ndarray, shape (c,)
        Candidate vergences, 1 / m, equally spaced. They extend beyond the range of distances to be measured.
    binning : int
        Side in pixels of the squares that are summed before filtering.
    taps : Taps
        The filter b.
    basis : ndarray, shape (rank, frames, degree + 1)
        Basis images e_k: coefficients of T_m Y_i.
    mixes : ndarray, shape (c, pairs, rank)
        Coefficients of the basis images e_k in each residual.
    noise : ndarray, shape (c,)
        Energy of the residuals of white noise of variance 1.
    texture_ratio, noise_variance : ndarray, shape (c,)
        Parts of n times the variance of half of the energy's derivative, for n pixels in a window: first (part due to
        texture) / kappa, second the part due to noise alone.
    curvature_ratio : ndarray, shape (c,)
        kappa / (mean energy of all candidates - energy at the true candidate), for the texture of the model.
    curvature_variance : ndarray, shape (c,)
        Variance of kappa due to noise alone, times the pixels of a window.
    concentration : ndarray, shape (c,)
        Concentration of the model's texture with noise in a window: tr(P^2) / (tr P)^2 of the mean products P of the
        basis images, with the variance of P.
    leak : ndarray, shape (c,)
        Energy at the true candidate / mean energy of all candidates, of single frequencies without noise.
    bias, errors, bound : ndarray, shape (c,)
        Bias, standard error and Cramér-Rao bound of the vergence from the texture of a single pixel, in units of
        `step`, the difference between neighbouring candidates.
    light : FocalLight
        Light per pixel for which the tables were computed.
    white : ndarray, shape (frames,)
        Noise variance of each frame / noise variance of a frame of exposure 1.
    discarded : float
        Fraction of the norm of all filters in the discarded singular vectors.

    Derivatives are with respect to the index of the candidate; kappa is half of the energy's second derivative.
    """

    vergence: Array
    binning: int
    taps: Taps
    basis: Array
    mixes: Array
    noise: Array
    texture_ratio: Array
    noise_variance: Array
    curvature_ratio: Array
    curvature_variance: Array
    concentration: Array
    leak: Array
    bias: Array
    errors: Array
    bound: Array
    light: FocalLight
    white: Array
    discarded: float

    @property
    def degree(self) -> int:
        """Degree of the polynomials, the number of steps of the recursion."""
        return int(self.basis.shape[2]) - 1

    @property
    def rank(self) -> int:
        """Number of basis images, from whose products all energies are computed."""
        return len(self.basis)

    @property
    def step(self) -> float:
        """Difference of vergence between neighbouring candidates, 1 / m."""
        return float(self.vergence[1] - self.vergence[0])

    def statistics(self) -> Array:
        """Return the statistics in the order that :class:`FocalStream` expects, shape (8, c)."""
        return np.stack(
            [
                self.noise,
                self.texture_ratio,
                self.noise_variance,
                self.curvature_ratio,
                self.curvature_variance,
                self.concentration,
                self.leak,
                self.bias,
            ]
        )

    def forms(self, rank: int) -> Array:
        """Return the energies as quadratic forms: factors of e_k e_l for k <= l, shape (c, rank (rank + 1) / 2).

        If `rank` exceeds the rank of the tables, the additional factors are 0.
        """
        k, l = np.triu_indices(rank)
        mixes = np.zeros((*self.mixes.shape[:2], rank))
        mixes[..., : self.rank] = self.mixes
        products = np.einsum("cpk,cpl->ckl", mixes, mixes)[:, k, l]
        return np.asarray(products * np.where(k == l, 1.0, 2.0))


def candidates(between: tuple[float, float], count: int, lenses: Sequence[Lens]) -> Array:
    """Return `count` equally spaced vergences (1 / m) that extend a little beyond a range of distances (m).

    The extension ends at 0 (infinite distance), and at 0.9 / (focal length): an object at the focal length would have
    its image at infinity.
    """
    min_vergence, max_vergence = 1.0 / between[1], 1.0 / between[0]
    margin = _MARGIN * (max_vergence - min_vergence)
    limit = 0.9 / max(lens.focal_length for lens in lenses)
    return np.linspace(max(min_vergence - margin, 0.0), max(max_vergence, min(max_vergence + margin, limit)), count)


def focal_tables(
    model_of: Callable[[int], FocalModel],
    light: FocalLight,
    blocks: tuple[Array, int],
    *,
    like: FocalTables | None = None,
) -> FocalTables:
    """Return the tables of a channel, with the largest binning and the shortest filters that lose little precision.

    ``model_of(n)`` returns the model of frames binned in squares of n x n pixels. `blocks` describes the windows over
    which energies are averaged: weights of blocks along an axis, from the central block outwards, and the side of a
    block in pixels. With `like`, the tables of another channel, binning, filter b and degree are copied from it.
    """
    weights, block = blocks

    def design(model: FocalModel, taps: Taps, degree: int, discarded: float, binning: int) -> FocalTables:
        return _tables(model, taps, degree, discarded, binning, light, _overlap(weights, block // binning))

    if like is not None:
        return design(model_of(like.binning), like.taps, like.degree, like.discarded, like.binning)
    binnings = [side for side in (1, 2, 4) if side <= block]
    models = [model_of(side) for side in binnings]
    # Exclude a tenth of the candidates at each end: most of them are outside the range of distances.
    tenth = len(models[0].vergence) // 10
    inner = slice(tenth, -tenth or None)
    # Binning divides the number of pixels in a window by side^2: errors per window are proportional to bound * side.
    bounds = [_bound(model)[inner] * side for model, side in zip(models, binnings, strict=True)]
    choice = max(k for k, bound in enumerate(bounds) if (bound / bounds[0]).max() <= _MAX_BINNING_LOSS)
    for taps, degree, discarded, largest_median, largest in _DESIGNS:
        tables = design(models[choice], Taps.of(taps), degree, discarded, binnings[choice])
        ratios = (tables.errors / tables.bound)[inner]
        if np.median(ratios) <= largest_median and ratios.max() <= largest:
            break
    return tables


def _bound(model: FocalModel) -> Array:
    """Return the Cramér-Rao bound of the vergence from a single pixel, in steps between candidates, shape (c,)."""
    step = model.vergence[1] - model.vergence[0]
    slope = np.gradient(model.transfer, float(step), axis=0)
    return np.asarray(1.0 / (step * np.sqrt(np.maximum(model.information(slope), 1e-300))))


def residual_filters(model: FocalModel) -> Array:
    """Return the factors of Y_i in e_ij for all pairs of frames, shape (c, pairs, frames, frequencies)."""
    h, noise, q = model.transfer, model.noise, model.signal()
    f = np.hypot(model.band.fx, model.band.fy)
    weight = model.texture * q / (1.0 + model.texture * q) * -np.expm1(-0.5 * (f / _HIGH_PASS) ** 2)
    pairs = list(combinations(range(h.shape[1]), 2))
    filters = np.zeros((len(h), len(pairs), *h.shape[1:]))
    for p, (i, j) in enumerate(pairs):
        scale = np.sqrt(weight / np.maximum(noise[:, i] * noise[:, j] * q, 1e-18))
        filters[:, p, i], filters[:, p, j] = h[:, j] * scale, -h[:, i] * scale
    return filters


def shifts(model: FocalModel, other: FocalModel) -> Array:
    """Return the first-order error of the vergence, in steps between candidates, by filters computed for `other`.

    The frames are those of `model`, which has three vergences for each candidate: of the previous candidate, of this
    candidate and of the next candidate; `other` has one. Let e' be the derivative of the residual with respect to the
    index of the candidate, de the residual of the scene in the filters of `other`, and <> the mean over the texture
    of the model. At the minimum of the energy ``<e' (e + de)> = 0``: it is shifted by ``-<e' de> / <e' e'>``.
    """
    h, power, filters = model.transfer[1::3], model.texture * model.band.share, residual_filters(model)
    derivatives = 0.5 * np.einsum("cpif,cif->cpf", filters[2::3] - filters[::3], h)
    residual = np.einsum("cpif,cif->cpf", residual_filters(other), h)
    return np.asarray(-((derivatives * residual) @ power).sum(axis=1) / ((derivatives**2) @ power).sum(axis=1))


class _Fit:
    """Least-squares fit of filters by Chebyshev polynomials, weighted by the cross-spectra of the frames.

    Parameters
    ----------
    model : FocalModel
    terms : ndarray, shape (degree + 1, frequencies)
        Polynomials T_m at the frequencies of the model.
    mean_power : float
        Power at frequency 0 of a mean that is common to all frames. With 0, filters ignore the mean of each frame.
    ridge : float
        Ridge added to the normal equations, relative to their mean diagonal element.
    """

    def __init__(self, model: FocalModel, terms: Array, mean_power: float, ridge: float) -> None:
        self._model, self._terms, self._mean_power, self._ridge = model, terms, mean_power, ridge
        self._share = model.band.share.copy()
        self._share[0] = 1.0

    def coefficients(self, filters: Array) -> tuple[Array, Array]:
        """Return the coefficients of filters (c, pairs, frames, frequencies), and the mean normal matrix.

        Coefficients have the shape (c, pairs, frames * (degree + 1)). The normal matrix is the mean over candidates,
        with one row and column for each of the frames * (degree + 1) coefficients.
        """
        count, pairs, frames = filters.shape[:3]
        terms, size = self._terms, len(self._terms)
        coefficients = np.empty((count, pairs, frames * size))
        mean_normal = np.zeros((frames * size, frames * size))
        for c in range(count):
            spectra = self._cross_spectra(c) * self._share
            normal = np.einsum("mf,ijf,nf->imjn", terms, spectra, terms, optimize=True).reshape(mean_normal.shape)
            normal[np.diag_indices(len(normal))] += self._ridge * np.trace(normal) / len(normal)
            right_sides = np.einsum("mf,ijf,pjf->imp", terms, spectra, filters[c], optimize=True)
            coefficients[c] = np.linalg.solve(normal, right_sides.reshape(len(normal), pairs)).T
            mean_normal += normal / count
        return coefficients, mean_normal

    def _cross_spectra(self, c: int) -> Array:
        """Return the cross-spectra of the frames, scene plus noise, at candidate c, (frames, frames, frequencies)."""
        h = self._model.transfer[c]
        spectra = self._model.texture * h[:, None] * h[None]
        for i, noise in enumerate(self._model.noise[c]):
            spectra[i, i] += noise
        # Frequency 0: a mean common to all frames, or independent means of the frames, which filters then reject.
        mean = self._mean_power + np.eye(len(h)) if self._mean_power else _MEAN_REJECTION * np.eye(len(h))
        spectra[:, :, 0] = mean
        return np.asarray(spectra)


def _overlap(weights: Array, side: int) -> Array:
    """Return the autocorrelation of a window along an axis, 1 at lag 0, at lags of 0, 1, ... binned pixels.

    `weights` are the weights of blocks, from the central block outwards; `side` is the side of a block in binned
    pixels.
    """
    along = np.repeat(np.append(weights[:0:-1], weights), side)
    autocorrelation = np.correlate(along, along, "full")[len(along) - 1 :]
    return np.asarray(autocorrelation / autocorrelation[0])


def _tables(
    model: FocalModel, taps: Taps, degree: int, discarded: float, binning: int, light: FocalLight, overlap: Array
) -> FocalTables:
    """Return the tables of a model with polynomials of a degree; `overlap` is the autocorrelation of a window."""
    band = model.band
    terms = taps.chebyshev(band.fx, band.fy, degree)
    filters = residual_filters(model)
    coefficients, normal = _Fit(model, terms, 0.0, 1e-9).coefficients(filters)
    count, pairs, frames = filters.shape[:3]
    rows = coefficients.reshape(count * pairs, -1)
    mixes, basis = _low_rank(rows, normal, np.ones(count * pairs), discarded, 0.0)
    mixes = mixes.reshape(count, pairs, -1)
    basis = basis.reshape(-1, frames, degree + 1)
    fitted = np.einsum("cpr,rim,mf->cpif", mixes, basis, terms, optimize=True)
    statistics = _Statistics.of(model, fitted, overlap)
    basis, mixes, concentration = _uncorrelated(model, basis, terms, mixes, overlap)
    return FocalTables(
        model.vergence,
        binning,
        taps,
        basis,
        mixes,
        statistics.noise,
        statistics.texture_ratio,
        statistics.noise_variance,
        statistics.curvature_ratio,
        statistics.curvature_variance,
        concentration,
        _leak(model, fitted, light.binned(binning), overlap),
        statistics.bias,
        statistics.errors,
        _bound(model),
        light,
        model.white,
        discarded,
    )


def _uncorrelated(
    model: FocalModel, basis: Array, terms: Array, mixes: Array, overlap: Array
) -> tuple[Array, Array, Array]:
    """Return the basis and mixes of uncorrelated basis images, and the concentration of the texture, shape (c,).

    The covariances of texture and noise in these basis images have the identity as their mean over candidates.
    """
    share, count = model.band.share, len(model.transfer)

    def covariances(filters: Array) -> Array:
        texture = np.einsum("rif,cif->crf", filters, model.transfer, optimize=True)
        noise = np.einsum("rif,sif,i,f->rs", filters, filters, model.white, share, optimize=True)
        return np.asarray((texture * share * model.texture) @ texture.swapaxes(1, 2) + noise)

    root = np.linalg.cholesky(covariances(basis @ terms).mean(axis=0))
    even = np.asarray(np.einsum("rs,sim->rim", np.linalg.inv(root), basis))
    filters = even @ terms
    each = covariances(filters)
    squares, squared = (each**2).sum(axis=(1, 2)), np.trace(each, axis1=1, axis2=2) ** 2
    # P is a mean over a window: by spectra S of images, the variance of P_kl is (S_kk S_ll + S_kl S_lk) / pixels.
    correlated, pixels = _WindowVariance(model.band, overlap), (2.0 * overlap.sum() - 1.0) ** 2
    sampled, (k, l) = np.unique(np.linspace(0, count - 1, _SAMPLED).astype(int)), np.triu_indices(len(filters))
    noise = np.einsum("pif,pif,i->pf", filters[k], filters[l], model.white)
    times = np.where(k == l, 1.0, 2.0)[:, None]
    variances = np.empty((2, len(sampled)))
    for place, c in enumerate(sampled):
        texture = np.einsum("rif,if->rf", filters, model.transfer[c])
        spectra = model.texture * texture[k] * texture[l] + noise
        total = spectra[k == l].sum(axis=0)
        variances[:, place] = correlated(times * spectra, spectra), correlated(total, total)
    crossed, own = (
        np.interp(np.arange(count), sampled, variance / (pixels * squared[sampled])) for variance in variances
    )
    return even, mixes @ root, (squares / squared + own + crossed) / (1.0 + 2.0 * crossed)


def _leak(model: FocalModel, filters: Array, light: FocalLight, overlap: Array) -> Array:
    """Return the leak of fitted filters, the same for all candidates, shape (c,): see :class:`FocalTables`."""
    f, count = np.hypot(model.band.fx, model.band.fy), len(filters)
    pixels = (2.0 * overlap.sum() - 1.0) ** 2  # effective number in a window
    through, mean = np.empty((2, count, f.size))
    averaged = filters[np.unique(np.linspace(0, count - 1, _MAX_AVERAGED).astype(int))]
    for c, h in enumerate(model.transfer):
        through[c] = (np.einsum("pif,if->pf", filters[c], h) ** 2).sum(axis=0)
        mean[c] = (np.einsum("cpif,if->cpf", averaged, h, optimize=True) ** 2).sum(axis=1).mean(axis=0)
    power = 0.5 * (_VISIBLE_CONTRAST * light.mean) ** 2 / light.variance
    visible = (0.5 * pixels * power * mean > _VISIBLE) & (f > _HIGH_PASS)
    leaks = [
        np.percentile(q[seen] / m[seen], _LEAKING)
        for q, m, seen in zip(through, mean, visible, strict=True)
        if seen.any()
    ]
    return np.full(count, np.median(leaks) if leaks else 1.0)


def _low_rank(rows: Array, metric: Array, weights: Array, fraction: float, per_row: float) -> tuple[Array, Array]:
    """Return factors (rows, rank) and (rank, columns) whose product approximates rows of coefficients.

    The norm of the approximation error, with the `metric` over columns and `weights` of rows, is below `fraction` of
    the rows' norm, or below `per_row` in the root mean square over rows, whichever allows the lower rank.
    """
    root = np.linalg.cholesky(metric)
    left, values, right = np.linalg.svd((rows @ root) * weights[:, None], full_matrices=False)
    errors = np.sqrt(np.append(np.cumsum((values**2)[::-1])[::-1], 0.0))  # norm of the error of each rank
    rank = int(np.argmax(errors < max(fraction * errors[0], per_row * math.sqrt(len(rows)), 1e-300)))
    return left[:, :rank] * values[:rank] / weights[:, None], np.linalg.solve(root.T, right[:rank].T).T


class _Statistics(NamedTuple):
    """Statistics of fitted filters at each candidate, shape (c,): see the attributes of :class:`FocalTables`."""

    noise: Array
    texture_ratio: Array
    noise_variance: Array
    curvature_ratio: Array
    curvature_variance: Array
    bias: Array
    errors: Array

    @classmethod
    def of(cls, model: FocalModel, filters: Array, overlap: Array) -> Self:
        """Return the statistics of filters (c, pairs, frames, frequencies) for windows with this `overlap`."""
        correlated = _WindowVariance(model.band, overlap)
        share, texture, count = model.band.share, model.texture, len(filters)
        derivatives = np.gradient(filters, axis=0)
        noise_energy = np.einsum("cpif,i,f->c", filters**2, model.white, share)
        bias, errors, texture_ratio, noise_variance, curvature_ratio, curvature_variance = np.zeros((6, count))
        averaged = np.unique(np.linspace(0, count - 1, _MAX_AVERAGED).astype(int))
        half_second_difference = np.array([0.5, -1.0, 0.5])
        through_five = np.linalg.inv(np.vander(np.arange(-2.0, 3.0), increasing=True))

        def mean_energies(candidates: slice | Array, c: int) -> Array:
            """Return the mean energies, minus noise, of texture at depth c, by the filters of these `candidates`."""
            h, g = model.transfer[c], filters[candidates]
            scene = (np.einsum("cpif,if->cpf", g, h, optimize=True) ** 2).sum(axis=1) @ (share * texture)
            noise = np.einsum("cpif,if->c", g**2, model.noise[c] * share, optimize=True)
            return np.asarray(scene + noise - noise_energy[candidates])

        for c in range(count):
            h, n = model.transfer[c], model.noise[c]
            g, d = filters[c], derivatives[c]
            # Bias: position of the minimum of the quartic through the lowest energy and its four neighbours.
            start = max(0, c - 6)
            energy = mean_energies(slice(start, c + 7), c)
            k = min(max(int(np.argmin(energy)), 2), len(energy) - 3)
            roots = np.polynomial.Polynomial(through_five @ energy[k - 2 : k + 3]).deriv().roots()
            bias[c] = start + k + roots[np.argmin(np.abs(roots))].real - c
            index = min(max(c, 1), count - 2) - start  # index of c in `energy`, not the first or last candidate
            curvature = float(half_second_difference @ energy[index - 1 : index + 2])
            # Cross-spectra S_ee, S_dd and S_ed of the residuals p and q, for scene plus noise.
            e, slope = np.einsum("pif,if->pf", g, h), np.einsum("pif,if->pf", d, h)
            ee = texture * e[:, None] * e[None] + np.einsum("pif,qif,if->pqf", g, g, n)
            dd = texture * slope[:, None] * slope[None] + np.einsum("pif,qif,if->pqf", d, d, n)
            ed = texture * e[:, None] * slope[None] + np.einsum("pif,qif,if->pqf", g, d, n)
            pixel_variance = float((ee * dd + ed * ed.swapaxes(0, 1)).sum(axis=(0, 1)) @ share)
            variance = correlated(ee, dd) + correlated(ed, ed.swapaxes(0, 1))
            # S_ee, S_dd and S_ed for white noise alone.
            n_ee, n_dd, n_ed = (np.einsum("pif,qif,i->pqf", a, b, model.white) for a, b in ((g, g), (d, d), (g, d)))
            noise_alone = correlated(n_ee, n_dd) + correlated(n_ed, n_ed.swapaxes(0, 1))
            kappa = float((slope**2).sum(axis=0) @ (share * texture))
            texture_ratio[c] = (variance - noise_alone) / max(kappa, 1e-300)
            noise_variance[c] = noise_alone
            errors[c] = math.sqrt(pixel_variance) / max(curvature, 1e-300)
            energy_drop = float(mean_energies(averaged, c).mean() - energy[c - start])
            curvature_ratio[c] = curvature / max(energy_drop, 1e-300)
            neighbours = filters[start + index - 1 : start + index + 2]
            spectra = np.einsum("apif,bqif,i->abpqf", neighbours, neighbours, model.white, optimize=True)
            weighted = np.einsum("abpqf,a,b->abpqf", spectra, half_second_difference, half_second_difference)
            curvature_variance[c] = 2.0 * correlated(weighted, spectra)
        return cls(noise_energy, texture_ratio, noise_variance, curvature_ratio, curvature_variance, bias, errors)


class _WindowVariance:
    """Variance of the windowed mean of a product of two images, from their spectra, times the pixels of a window.

    By Isserlis's theorem this is a sum over lags of products of covariances, weighted by the autocorrelation
    `overlap` of the window.
    """

    def __init__(self, band: Band, overlap: Array) -> None:
        self._places = band.places()
        count = len(self._places)
        lags = np.arange(min(count, len(overlap)))
        self._cosines = np.cos(2.0 * math.pi * lags[:, None] * band.fx[self._places[:, -1]]) / count
        both_signs = np.where(lags == 0, 1.0, 2.0) * overlap[: len(lags)]  # positive and negative lags together
        self._weights = both_signs[:, None] * both_signs

    def __call__(self, a: Array, b: Array) -> float:
        """Return the variance for two spectra (..., frequencies), summed over all axes but the last."""
        covariance_a, covariance_b = (
            self._cosines @ spectra[..., self._places] @ self._cosines.T for spectra in (a, b)
        )
        return float((covariance_a * covariance_b * self._weights).sum())


class SharpTables:
    """Wiener filters for sharp and refocused images at each candidate vergence, as polynomials of one small filter.

    Parameters
    ----------
    model : FocalModel
        Model of pixels that are not binned.
    taps : Taps
        The filter b.
    degree : int
        Degree of its Chebyshev polynomials.
    foci : sequence of ndarray, shape (c, frequencies)
        Transfer functions of additional images, for example at another focus. All images share one basis.

    Attributes
    ----------
    basis : ndarray, shape (rank, frames, degree + 1)
        Basis images: coefficients of T_m Y_i.
    pixel : ndarray, shape (c, frequencies)
        Transfer function of the sharp image: that of a square pixel, without the lens.
    """

    def __init__(self, model: FocalModel, taps: Taps, degree: int, foci: Sequence[Array] = ()) -> None:
        self.model, self.taps = replace(model, alias_power=_SHARED_ALIASES * model.alias_power), taps
        band = model.band
        self._terms = taps.chebyshev(band.fx, band.fy, degree)
        self._fit = _Fit(model, self._terms, _MEAN_POWER, 1e-12)
        self.pixel = np.broadcast_to(np.sinc(band.fx) * np.sinc(band.fy), model.transfer[:, 0].shape)
        filters = [self._filters(target) for target in (self.pixel, *foci)]
        coefficients, self._normal = self._fit.coefficients(np.stack(filters, axis=1))
        targets = zip((self.pixel, *foci), filters, strict=True)
        # Rows are weighted by 1 / rms error: the lower rank then causes the same relative loss in each image.
        weights = np.stack(
            [1.0 / np.sqrt(np.maximum(self._errors(target, exact), 1e-12)) for target, exact in targets], axis=1
        )
        rows = coefficients.reshape(-1, coefficients.shape[2])
        _, basis = _low_rank(rows, self._normal, weights.ravel(), 0.0, math.sqrt(_SHARP_LOSS))
        self.basis = basis.reshape(-1, model.transfer.shape[1], degree + 1)

    @property
    def degree(self) -> int:
        """Degree of the polynomials, the number of steps of the recursion."""
        return int(self.basis.shape[2]) - 1

    def _filters(self, target: Array) -> Array:
        """Return the Wiener filters for a target transfer function (c, frequencies), (c, frames, frequencies)."""
        model, h = self.model, self.model.transfer
        # Cross-spectra of the target image and the frames. The sharp image contains aliases of the scene, and frames
        # in focus contain them as well.
        cross = (target * model.texture)[:, None] * h
        if target is self.pixel:
            cross = cross + model.alias_power[:, :-1]
        # Inverse of the covariance S h h^T + N by the Sherman-Morrison formula.
        weighted = cross / model.noise
        gain = model.texture * (h * weighted).sum(axis=1) / (1.0 + model.texture * model.signal())
        filters = weighted - gain[:, None] * h / model.noise
        # Frequency 0: the mean of the frames, weighted by 1 / noise.
        filters[:, :, 0] = (1.0 / model.white) / (1.0 / model.white).sum()
        return np.asarray(filters)

    def _errors(self, target: Array, filters: Array) -> Array:
        """Return (mean squared error of filtered images) / (variance of a pixel), (c,)."""
        model = self.model
        unresolved = target - np.einsum("cif,cif->cf", filters, model.transfer)
        power = model.texture * unresolved**2 + (filters**2 * model.noise).sum(axis=1)
        if target is self.pixel:
            power += model.alias_power[:, -1] - 2.0 * (filters * model.alias_power[:, :-1]).sum(axis=1)
        return np.asarray(power @ model.band.share)

    def mixes(self, target: Array) -> Array:
        """Return the image of a target transfer function as coefficients of the basis images, (c, rank)."""
        rows = self._fit.coefficients(self._filters(target)[:, None])[0][:, 0]
        vectors = self.basis.reshape(len(self.basis), -1)
        return np.asarray(np.linalg.solve(vectors @ self._normal @ vectors.T, vectors @ self._normal @ rows.T).T)

    def errors(self, target: Array) -> Array:
        """Return the mean squared errors of the Wiener filters and of their fits by polynomials, (2, c)."""
        fitted = np.einsum("cr,rim,mf->cif", self.mixes(target), self.basis, self._terms, optimize=True)
        return np.stack([self._errors(target, self._filters(target)), self._errors(target, fitted)])

    def stream(self, size: tuple[int, int], threads: int) -> FocalStream:
        """Return the stream that computes the basis images of single frames of the height and width `size`."""

        def float32(values: ArrayLike) -> NDArray[np.float32]:
            return np.ascontiguousarray(values, dtype=np.float32)

        no_mixes = float32(np.zeros((1, 0, *self.basis.shape[1:])))
        forms, statistics = float32(np.zeros((0, 0))), float32(np.zeros((8, 0)))
        taps, basis, window = float32(self.taps.values), float32(self.basis), float32([1.0])
        numbers = (0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0)
        return FocalStream((*size, 1, 4, 1, 0, threads), taps, no_mixes, basis, window, forms, statistics, numbers)
