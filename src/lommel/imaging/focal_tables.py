r"""Filters that tell depth from frames of different focus, as few polynomials of one small filter.

With the names of :mod:`lommel.estimation.focal_model`, let ``q = sum of h_i^2 / N_i`` and W = S q / (1 + S q), times
a high pass. At the vergence u the residual of the frames i < j is

    e_ij = sqrt(W) (h_j Y_i - h_i Y_j) / sqrt(N_i N_j q) :

noise at the true u, whatever the texture; by Lagrange's identity the energies of all pairs add up to that of the
frames orthogonal to h. Common factors of the frames, such as the pixel, drop out of the direction, and so filters are
functions of \|f\| alone but for the weight. They are made as

    e = sum over i, m of c_im T_m(2 B - 1) Y_i ,    B(f) = b(fx) b(fy) ,

T_m being Chebyshev polynomials, by a recursion of M steps for each frame that serves all vergences, pairs and sharp
images (compare McClellan, 7th Princeton Conference on Information Sciences, 1973). Coefficients are least squares in
the metric of the data: what leaks of a scene through a null that is not perfect costs as much as it does in use. Of
their matrix a few singular vectors are kept, so that energies at all vergences are quadratic forms of few images.

The standard error follows from the filters as they are. With S_ee, S_dd and S_ed the spectra of e, of its derivative
by u, and between them, and N the pixels of a window, half of the energy's derivative has the variance
``mean of (S_ee S_dd + S_ed^2) / N``, less where the images are correlated over as much as the window; one part of it
grows as the curvature kappa of the energy and the other is of noise alone:
``sigma_u^2 = (by_texture kappa + by_noise) / (kappa^2 N)``. Where there is little texture noise bends the least of
the energy: kappa is then what the depth of the valley tells, for the texture that the filters are made for.
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

_HIGH_PASS = 0.012  # cycles per pixel: slower changes are of exposures, shading and offsets
_BLIND = 1e4  # power of a scene at frequency 0, over the noise, that filters are to withstand
_SHARED_ALIASES = 0.4  # of those of textures whose spectrum goes on beyond the Nyquist frequency; many fall off
_SHARP_LOSS = 0.01  # of the squared error of Wiener's filter, likewise
_BEYOND = 0.08  # of the range, by which candidates reach beyond either end of it
_VALLEY = 61  # candidates that the depth of a valley is taken from
_WORTH = 1.25  # standard errors may grow so much by squares of pixels, which take a quarter of the work
# Taps, degree, the share of the norm of all filters that the singular vectors left out may have together, and what
# the filters' standard errors over the bound may be for these to do: their median, and the most. Short filters are
# tried first, for long ones bring light from afar.
_TRIED = ((3, 8, 1e-2, 1.08, math.inf), (5, 12, 1e-2, 1.08, 1.45), (5, 12, 5e-3, math.inf, math.inf))
_MEAN = 1e7  # power at frequency 0 of an image that is to keep its mean


class Taps(NamedTuple):
    """The filter b along one axis: its value at 0, 1, ... pixels from the middle."""

    values: tuple[float, ...]

    @classmethod
    def of(cls, count: int) -> Self:
        """Return three taps, cos^2(w / 2), or five, whose contours are circles to one more order.

        With s = sin(w / 2) these are ``1 - (4 / 3) s^2 + (4 / 9) s^4``, where the fourth order of log b vanishes.
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
        """Return three values, the last 0 where there are two."""
        first, second, *rest = self.values
        return first, second, rest[0] if rest else 0.0

    def chebyshev(self, fx: Array, fy: Array, degree: int) -> Array:
        """Return T_0 to T_degree of 2 B - 1, shape (degree + 1, frequencies)."""
        t = 2.0 * self(fx) * self(fy) - 1.0
        terms = [np.ones_like(t), t]
        while len(terms) <= degree:
            terms.append(2.0 * t * terms[-1] - terms[-2])
        return np.stack(terms[: degree + 1])


@dataclass(frozen=True)
class FocalTables:
    """What the stream of frames takes: filters, energies and their statistics at each candidate vergence.

    Attributes
    ----------
    vergence : ndarray, shape (c,)
        Candidates, equally spaced, 1 / m; they reach beyond the range.
    binning : int
        Pixels a side of the squares that are summed first.
    taps : Taps
    basis : ndarray, shape (rank, frames, degree + 1)
        Images e_k as sums of T_m y_i.
    mixes : ndarray, shape (c, pairs, rank)
        Residuals as sums of these.
    noise : ndarray, shape (c,)
        Energy of the residuals of white noise of variance 1.
    by_texture, by_noise : ndarray, shape (c,)
        Variance of half of the energy's derivative by candidate: the part that grows as its curvature, and the rest.
    steepness : ndarray, shape (c,)
        Half of the energy's second derivative over how far the mean of all energies is above it, of a texture as
        designed for.
    of_curvature : ndarray, shape (c,)
        Variance of half of the second derivative by noise alone.
    bias, errors, bound : ndarray, shape (c,)
        Of a texture as designed for, in candidates, by one pixel's information: bias, standard error, Cramér-Rao
        bound.
    light : FocalLight
        That the tables were made for.
    white : ndarray, shape (frames,)
        Variance of each frame over that of one of exposure 1.
    left : float
        Share of the norm of all filters that was left out.
    """

    vergence: Array
    binning: int
    taps: Taps
    basis: Array
    mixes: Array
    noise: Array
    by_texture: Array
    by_noise: Array
    steepness: Array
    of_curvature: Array
    bias: Array
    errors: Array
    bound: Array
    light: FocalLight
    white: Array
    left: float

    @property
    def degree(self) -> int:
        """The number of steps of the recursion."""
        return int(self.basis.shape[2]) - 1

    @property
    def rank(self) -> int:
        """The number of images whose products make all energies."""
        return len(self.basis)

    @property
    def step(self) -> float:
        """The vergence from one candidate to the next."""
        return float(self.vergence[1] - self.vergence[0])

    def statistics(self) -> Array:
        """Return the rows that the search for the least energy takes."""
        return np.stack([self.noise, self.by_texture, self.by_noise, self.steepness, self.of_curvature])

    def forms(self, rank: int) -> Array:
        """Return the energies as quadratic forms, factors of e_k e_l for k <= l, as if there were `rank` images."""
        k, l = np.triu_indices(rank)
        mixes = np.zeros((*self.mixes.shape[:2], rank))
        mixes[..., : self.rank] = self.mixes
        products = np.einsum("cpk,cpl->ckl", mixes, mixes)[:, k, l]
        return np.asarray(products * np.where(k == l, 1.0, 2.0))


def candidates(between: tuple[float, float], count: int, lenses: Sequence[Lens]) -> Array:
    """Return equally spaced vergences, which reach beyond a range of distances as far as there is focus."""
    far, near = 1.0 / between[1], 1.0 / between[0]
    more = _BEYOND * (near - far)
    nearest = 0.9 / max(lens.focal_length for lens in lenses)
    return np.linspace(max(far - more, 0.0), max(near, min(near + more, nearest)), count)


def focal_tables(
    model_of: Callable[[int], FocalModel],
    light: FocalLight,
    blocks: tuple[Array, int],
    *,
    like: FocalTables | None = None,
) -> FocalTables:
    """Return the tables for windows of weights of blocks, from the middle on, of some pixels a side.

    `model_of` returns the model of squares of so many pixels a side. By the largest squares that cost little
    precision, up to a block, and as few terms as will do; or by the squares and polynomials of others.
    """
    weights, block = blocks

    def made_of(model: FocalModel, taps: Taps, degree: int, left: float, binning: int) -> FocalTables:
        return _tables(model, taps, degree, left, binning, light, _overlap(weights, block // binning))

    if like is not None:
        return made_of(model_of(like.binning), like.taps, like.degree, like.left, like.binning)
    squares = [s for s in (1, 2, 4) if s <= block]
    models = [model_of(s) for s in squares]
    tenth = len(models[0].vergence) // 10
    inner = slice(tenth, -tenth or None)
    bounds = [_bound(model)[inner] * s for model, s in zip(models, squares, strict=True)]
    best = max(k for k, each in enumerate(bounds) if (each / bounds[0]).max() <= _WORTH)
    for taps, degree, left, median, most_over in _TRIED:
        made = made_of(models[best], Taps.of(taps), degree, left, squares[best])
        over = (made.errors / made.bound)[inner]
        if np.median(over) <= median and over.max() <= most_over:
            break
    return made


def _bound(model: FocalModel) -> Array:
    """Return the Cramér-Rao bound of one pixel, in candidates."""
    step = model.vergence[1] - model.vergence[0]
    slope = np.gradient(model.transfer, float(step), axis=0)
    return np.asarray(1.0 / (step * np.sqrt(np.maximum(model.information(slope), 1e-300))))


def residual_filters(model: FocalModel) -> Array:
    """Return the filters of all pairs of frames, shape (c, pairs, frames, frequencies)."""
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
    """Return by how many candidates depth is off, to first order, if data have one model and filters are of another.

    `model` is of threes: the candidate before, that itself, and the one after; `other` is of those in the middle. The
    energy's derivative by the vergence vanishes where ``<e' (e + de)> = 0``: the shift is ``-<e' de> / <e' e'>``, e'
    being the derivative of the residual and de what the other filters leave of the scene, in the mean over a texture
    as designed for.
    """
    h, share, filters = model.transfer[1::3], model.texture * model.band.share, residual_filters(model)
    slopes = 0.5 * np.einsum("cpif,cif->cpf", filters[2::3] - filters[::3], h)
    left = np.einsum("cpif,cif->cpf", residual_filters(other), h)
    return np.asarray(-((slopes * left) @ share).sum(axis=1) / ((slopes**2) @ share).sum(axis=1))


class _Fit:
    """Least squares of filters by Chebyshev polynomials, in the metric of the data."""

    def __init__(self, model: FocalModel, terms: Array, mean: float, ridge: float) -> None:
        self._model, self._terms, self._mean, self._ridge = model, terms, mean, ridge
        self._share = model.band.share.copy()
        self._share[0] = 1.0

    def coefficients(self, filters: Array) -> tuple[Array, Array]:
        """Return those of filters (c, pairs, frames, frequencies), and the mean metric of all candidates."""
        count, pairs, frames = filters.shape[:3]
        terms, size = self._terms, len(self._terms)
        made, mean = np.empty((count, pairs, frames * size)), np.zeros((frames * size, frames * size))
        for c in range(count):
            metric = self._metric(c) * self._share
            gram = np.einsum("mf,ijf,nf->imjn", terms, metric, terms, optimize=True).reshape(mean.shape)
            gram[np.diag_indices(len(gram))] += self._ridge * np.trace(gram) / len(gram)
            right = np.einsum("mf,ijf,pjf->imp", terms, metric, filters[c], optimize=True).reshape(len(gram), pairs)
            made[c] = np.linalg.solve(gram, right).T
            mean += gram / count
        return made, mean

    def _metric(self, c: int) -> Array:
        """Return the power of the data of a candidate, (frames, frames, frequencies)."""
        h = self._model.transfer[c]
        metric = self._model.texture * h[:, None] * h[None]
        for i, noise in enumerate(self._model.noise[c]):
            metric[i, i] += noise
        # A mean that all frames share, or, blind to it, one of each.
        metric[:, :, 0] = _BLIND * np.eye(len(h)) if not self._mean else self._mean + np.eye(len(h))
        return np.asarray(metric)


def _overlap(weights: Array, side: int) -> Array:
    """Return how far a window overlaps with itself at 0, 1, ... squares along an axis, over that at 0."""
    along = np.repeat(np.append(weights[:0:-1], weights), side)
    whole = np.correlate(along, along, "full")[len(along) - 1 :]
    return np.asarray(whole / whole[0])


def _tables(
    model: FocalModel, taps: Taps, degree: int, left: float, binning: int, light: FocalLight, overlap: Array
) -> FocalTables:
    """Return the tables of a model, by polynomials of a degree."""
    band = model.band
    terms = taps.chebyshev(band.fx, band.fy, degree)
    filters = residual_filters(model)
    fitted, metric = _Fit(model, terms, 0.0, 1e-9).coefficients(filters)
    count, pairs, frames = filters.shape[:3]
    mixes, basis = _few(fitted.reshape(count * pairs, -1), metric, np.ones(count * pairs), left, 0.0)
    mixes = mixes.reshape(count, pairs, -1)
    basis = basis.reshape(-1, frames, degree + 1)
    found = _Statistics.of(model, np.einsum("cpr,rim,mf->cpif", mixes, basis, terms, optimize=True), overlap)
    return FocalTables(
        model.vergence,
        binning,
        taps,
        basis,
        mixes,
        found.noise,
        found.by_texture,
        found.by_noise,
        found.steepness,
        found.of_curvature,
        found.bias,
        found.errors,
        _bound(model),
        light,
        model.white,
        left,
    )


def _few(rows: Array, metric: Array, weights: Array, share: float, each: float) -> tuple[Array, Array]:
    """Return rows as products of few vectors.

    In a metric weighted rows lose less than a `share` of their norm, or less than `each` a row.
    """
    root = np.linalg.cholesky(metric)
    left, values, right = np.linalg.svd((rows @ root) * weights[:, None], full_matrices=False)
    lost = np.sqrt(np.append(np.cumsum((values**2)[::-1])[::-1], 0.0))
    rank = int(np.argmax(lost < max(share * lost[0], each * math.sqrt(len(rows)), 1e-300)))
    return left[:, :rank] * values[:rank] / weights[:, None], np.linalg.solve(root.T, right[:rank].T).T


class _Statistics(NamedTuple):
    """What filters do with noise and with textures: arrays of candidates."""

    noise: Array
    by_texture: Array
    by_noise: Array
    steepness: Array
    of_curvature: Array
    bias: Array
    errors: Array

    @classmethod
    def of(cls, model: FocalModel, filters: Array, overlap: Array) -> Self:
        """Return that of filters as they are, (c, pairs, frames, frequencies), in windows of an overlap."""
        correlated = _Correlation(model.band, overlap)
        share, texture, count = model.band.share, model.texture, len(filters)
        slopes = np.gradient(filters, axis=0)
        noise = np.einsum("cpif,i,f->c", filters**2, model.white, share)
        found = np.zeros((6, count))
        some = np.unique(np.linspace(0, count - 1, _VALLEY).astype(int))
        second = np.array([0.5, -1.0, 0.5])

        def energy_of(which: slice | Array, c: int) -> Array:
            # The mean energy at some candidates, of a texture at the candidate c.
            h, g = model.transfer[c], filters[which]
            leak = (np.einsum("cpif,if->cpf", g, h, optimize=True) ** 2).sum(axis=1) @ (share * texture)
            rest = np.einsum("cpif,if->c", g**2, model.noise[c] * share, optimize=True)
            return np.asarray(leak + rest - noise[which])

        for c in range(count):
            h, n = model.transfer[c], model.noise[c]
            g, d = filters[c], slopes[c]
            start = max(0, c - 6)
            energy = energy_of(slice(start, c + 7), c)
            k = min(max(int(np.argmin(energy)), 1), len(energy) - 2)
            before, here, after = energy[k - 1 : k + 2]
            found[0, c] = start + k + 0.5 * (before - after) / (before - 2.0 * here + after) - c
            own = min(max(c, 1), count - 2) - start
            curvature = float(second @ energy[own - 1 : own + 2])
            e, slope = np.einsum("pif,if->pf", g, h), np.einsum("pif,if->pf", d, h)
            ee = texture * e[:, None] * e[None] + np.einsum("pif,qif,if->pqf", g, g, n)
            dd = texture * slope[:, None] * slope[None] + np.einsum("pif,qif,if->pqf", d, d, n)
            ed = texture * e[:, None] * slope[None] + np.einsum("pif,qif,if->pqf", g, d, n)
            flat = float((ee * dd + ed * ed.swapaxes(0, 1)).sum(axis=(0, 1)) @ share)
            variance = correlated(ee, dd) + correlated(ed, ed.swapaxes(0, 1))
            plain = [np.einsum("pif,qif,i->pqf", a, b, model.white) for a, b in ((g, g), (d, d), (g, d))]
            alone = correlated(plain[0], plain[1]) + correlated(plain[2], plain[2].swapaxes(0, 1))
            found[1, c] = (variance - alone) / max(float((slope**2).sum(axis=0) @ (share * texture)), 1e-300)
            found[2, c] = alone
            found[3, c] = math.sqrt(flat) / max(curvature, 1e-300)
            found[4, c] = curvature / max(float(energy_of(some, c).mean() - energy[c - start]), 1e-300)
            three = filters[start + own - 1 : start + own + 2]
            spectra = np.einsum("apif,bqif,i->abpqf", three, three, model.white, optimize=True)
            found[5, c] = 2.0 * correlated(np.einsum("abpqf,a,b->abpqf", spectra, second, second), spectra)
        return cls(noise, found[1], found[2], found[4], found[5], found[0], found[3])


class _Correlation:
    """Variances of windowed products of two images, from their spectra, times the pixels of a window.

    The sum over lags of the covariances' product, each lag as much as the window overlaps with itself there.
    """

    def __init__(self, band: Band, overlap: Array) -> None:
        self._places = band.places()
        count = len(self._places)
        lags = np.arange(min(count, len(overlap)))
        self._cosines = np.cos(2.0 * math.pi * lags[:, None] * band.fx[self._places[:, -1]]) / count
        both = np.where(lags == 0, 1.0, 2.0) * overlap[: len(lags)]
        self._weights = both[:, None] * both

    def __call__(self, a: Array, b: Array) -> float:
        """Return the variance that two spectra (..., frequencies) have, summed over the rest of their axes."""
        first, second = (self._cosines @ one[..., self._places] @ self._cosines.T for one in (a, b))
        return float((first * second * self._weights).sum())


class SharpTables:
    """Wiener's filters at each candidate, by polynomials of one small filter, for a sharp image and other foci.

    Parameters
    ----------
    model : FocalModel
        Of pixels that are not binned.
    taps, degree
        Of the polynomials.
    foci : sequence of ndarray, shape (c, frequencies)
        What other images are to transfer, which share the basis.

    Attributes
    ----------
    basis : ndarray, shape (rank, frames, degree + 1)
        Images as sums of T_m y_i.
    """

    def __init__(self, model: FocalModel, taps: Taps, degree: int, foci: Sequence[Array] = ()) -> None:
        self.model, self.taps = replace(model, folded=_SHARED_ALIASES * model.folded), taps
        band = model.band
        self._terms = taps.chebyshev(band.fx, band.fy, degree)
        self._fit = _Fit(model, self._terms, _MEAN, 1e-12)
        self.pixel = np.broadcast_to(np.sinc(band.fx) * np.sinc(band.fy), model.transfer[:, 0].shape)
        filters = [self._filters(target) for target in (self.pixel, *foci)]
        fitted, self._metric = self._fit.coefficients(np.stack(filters, axis=1))
        targets = zip((self.pixel, *foci), filters, strict=True)
        weights = np.stack(
            [1.0 / np.sqrt(np.maximum(self._errors(target, each), 1e-12)) for target, each in targets], axis=1
        )
        rows = fitted.reshape(-1, fitted.shape[2])
        _, basis = _few(rows, self._metric, weights.ravel(), 0.0, math.sqrt(_SHARP_LOSS))
        self.basis = basis.reshape(-1, model.transfer.shape[1], degree + 1)

    @property
    def degree(self) -> int:
        """The number of steps of the recursion."""
        return int(self.basis.shape[2]) - 1

    def _filters(self, target: Array) -> Array:
        """Return Wiener's filters, (c, frames, frequencies)."""
        model, h = self.model, self.model.transfer
        # What the image and the frames share, aliases of the sharp scene included, which are seen in frames in focus.
        shared = (target * model.texture)[:, None] * h
        if target is self.pixel:
            shared = shared + model.folded[:, :-1]
        over = shared / model.noise
        gain = model.texture * (h * over).sum(axis=1) / (1.0 + model.texture * model.signal())
        filters = over - gain[:, None] * h / model.noise
        # The mean is kept: shares of the frames by their noise.
        filters[:, :, 0] = (1.0 / model.white) / (1.0 / model.white).sum()
        return np.asarray(filters)

    def _errors(self, target: Array, filters: Array) -> Array:
        """Return the mean squared error of images, over the variance of a pixel."""
        model = self.model
        left = target - np.einsum("cif,cif->cf", filters, model.transfer)
        power = model.texture * left**2 + (filters**2 * model.noise).sum(axis=1)
        if target is self.pixel:
            power += model.folded[:, -1] - 2.0 * (filters * model.folded[:, :-1]).sum(axis=1)
        return np.asarray(power @ model.band.share)

    def mixes(self, target: Array) -> Array:
        """Return an image as sums of those of the basis, (c, rank)."""
        rows = self._fit.coefficients(self._filters(target)[:, None])[0][:, 0]
        flat = self.basis.reshape(len(self.basis), -1)
        return np.asarray(np.linalg.solve(flat @ self._metric @ flat.T, flat @ self._metric @ rows.T).T)

    def errors(self, target: Array) -> Array:
        """Return the mean squared errors of Wiener's filters and of those made, (2, c)."""
        made = np.einsum("cr,rim,mf->cif", self.mixes(target), self.basis, self._terms, optimize=True)
        return np.stack([self._errors(target, self._filters(target)), self._errors(target, made)])

    def stream(self, size: tuple[int, int], threads: int) -> FocalStream:
        """Return what makes images of one frame of a height and width."""

        def single(values: ArrayLike) -> NDArray[np.float32]:
            return np.ascontiguousarray(values, dtype=np.float32)

        none = single(np.zeros((1, 0, *self.basis.shape[1:])))
        forms, statistics = single(np.zeros((0, 0))), single(np.zeros((5, 0)))
        taps, basis, window = single(self.taps.values), single(self.basis), single([1.0])
        numbers = (0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0)
        return FocalStream((*size, 1, 4, 1, 0, threads), taps, none, basis, window, forms, statistics, numbers)
