r"""Deblurring of one uniform blur: Wiener filter, local Wiener filter and total variation, blended by their risk.

With symmetric borders (half-sample), the discrete cosine transform diagonalises a symmetric blur H and gradients. The
unknown x is the scene averaged over pixels, so that H is the transfer function of the lens alone. Three estimates:

- Wiener filter for a texture of power ``c f^-s``, by :mod:`lommel.imaging.blur_spectrum`.
- Local Wiener filter: a Wiener filter for less noise, then shrinkage of the coefficients of a tight frame (octaves
  times directions) by their local energy E and noise n, ``E / (E + n)``, repeated with the energy of the result.
- Total variation: the minimum of ``|H x - y|^2 / (2 sigma^2) + lambda sum |grad x|`` by the alternating direction
  method of multipliers (Boyd et al. 2011, doi:10.1561/2200000016); lambda is the scale of a Laplacian prior.

The weights v of the result ``sum v_i x_i`` minimise the predicted risk ``|sum v_i H x_i|^2 - 2 sum v_i (<H x_i, y> -
E<H x_i, n>)``. The last term follows from a derivative, here along one random direction (Stein 1981,
doi:10.1214/aos/1176345632; Ramani et al. 2008, doi:10.1109/TIP.2008.2001404). The weights are averaged with equal
weights, since this risk does not see what the blur removes.

Saturated pixels are raised, and unknown ones replaced, by the blurred total variation while it is computed.
"""

from __future__ import annotations

import itertools
import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache, partial
from typing import NamedTuple, Self, TypeGuard

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.core import engine
from lommel.deconvolve.algorithms import ONE_PASS, ProgressCallback, silent
from lommel.deconvolve.iterations import Solution
from lommel.deconvolve.likelihood import PhotographLikelihood
from lommel.deconvolve.linear import LinearBlur, copies
from lommel.estimation.focal_model import Spectrum, pupil_curve
from lommel.imaging.blur_spectrum import FREQUENCIES, BlurSpectrum, cosine_axes
from lommel.imaging.field_blur import FieldBlur
from lommel.imaging.measured_blur import MeasuredBlur
from lommel.imaging.one_pass import fill_unknown
from lommel.optics.pupil import Pupil

_PILOT_NOISE = 0.5  # noise for which the filter before shrinkage is computed / noise
_OCTAVES, _DIRECTIONS = 4, 4  # of the frame
_LOCAL_RMS = 1.2, 0.72  # rms of the Gaussians that average energies, first and second time, / 2^octave pixels
_STRENGTH = 0.5  # lambda times the mean gradient of a channel
_STEPS = 30  # of the total variation
_RENEWED, _TUNED = 3, 12  # steps between renewals of lambda; steps after which the penalty stays
_FILLING_STEPS = 60  # steps of the total variation that fills saturated and unknown pixels
_PROBE = 0.3  # change of the photograph / noise, for the derivative of the estimates
_WEIGHT_STEPS = 10  # steps of the weights from 0 to 1
_VARIANCE_RMS = 2.0  # rms width (pixels) of the Gaussian that smooths the light of which the noise is computed
_BORDER = 3.0  # width of the border that does not test the blur, whose light comes from beyond / radius of the blur
_TILE, _OVERLAP = 512, 128  # stride and overlap (pixels) of the tiles of large images
_CORE, _CORE_MARGIN = 192, 16  # side of the part of a large tile that chooses weights, and what is not counted of it
_FIELD_TILE, _FIELD_MARGIN = 64, 24  # stride of tiles with one PSF; smallest margin around them (pixels)

_Real = np.float32


class UniformBlur(LinearBlur):
    """Blur by one transfer function of each channel, all over an image that is mirrored at its edges.

    Parameters
    ----------
    shape : (int, int)
    curve : callable
        Real transfer functions (channels, ...) of the frequency in cycles per pixel, without that of the pixel.
    radius : float
        Radius of the blur, pixels.
    """

    dtype = np.dtype(_Real)

    def __init__(self, shape: tuple[int, int], curve: Callable[[Array], Array], radius: float) -> None:
        self.shape, self.curve, self.radius = shape, curve, radius
        self.transfer = self.on(shape)
        self.channels = len(self.transfer)

    @classmethod
    def of(cls, shape: tuple[int, int], pupil: Pupil, pixel: float, spectra: Sequence[Spectrum]) -> Self:
        """Return the blur of a pupil, pixels being `pixel` metres wide; `spectra` are those of the channels."""
        radius = float(pupil.geometric_radius()) / pixel
        if radius > max(1, min(shape) // 2):
            raise ValueError(
                f"the blur has a radius of {radius:.4g} pixels, more than half of the photograph: stop down the lens"
            )
        curves = {of: pupil_curve(pupil, of, pixel) for of in dict.fromkeys(spectra)}
        return cls(shape, lambda f: np.stack([curves[of](f) for of in spectra]), radius)

    def on(self, shape: tuple[int, int]) -> Values:
        """Return the transfer functions at the frequencies of the cosine transform of another shape."""
        return self.curve(np.hypot(*cosine_axes(shape))).astype(_Real)

    def forward(self, image: Values) -> Values:
        """Return the blurred image."""
        return self.by_channel(image, lambda c, plane: _inverse(self.transfer[c] * _cosines(plane)))

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward`, which is equal to it."""
        return self.forward(image)


class TiledBlur(LinearBlur):
    """Blur by a uniform blur in each of overlapping tiles, whose images are added by their shares.

    Parameters
    ----------
    shape : (int, int)
    parts : sequence of (Tile, UniformBlur)
        Tiles by :func:`tiles_of`, each with a blur of its shape.
    """

    dtype = np.dtype(_Real)

    def __init__(self, shape: tuple[int, int], parts: Sequence[tuple[Tile, UniformBlur]]) -> None:
        self.shape, self.parts, self.channels = shape, parts, parts[0][1].channels

    def forward(self, image: Values) -> Values:
        """Return the blurred image."""
        return self._summed(image, lambda share, plane, blur: share * blur.forward(plane))

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` applied to an image."""
        return self._summed(image, lambda share, plane, blur: blur.adjoint(share * plane))

    def _summed(self, image: Values, seen: Callable[[Values, Values, UniformBlur], Values]) -> Values:
        total = np.zeros(image.shape, self.dtype)
        for tile, blur in self.parts:
            share = tile.share.reshape(*tile.share.shape, *[1] * (image.ndim - 2))
            total[tile.rows, tile.columns] += seen(share, image[tile.rows, tile.columns], blur)
        return total


@dataclass(frozen=True)
class Blend:
    """Deblurring by a Wiener filter, a local Wiener filter and total variation, blended.

    The weights of the three minimise the predicted squared error. The result estimates the pixel-averaged scene. The
    whole scene must have one distance. A :class:`FieldBlur` is uniform in tiles, of which neighbours are blended; the
    local Wiener filter is then left out.
    """

    def solve(self, observed: PhotographLikelihood, tell: ProgressCallback) -> Solution:
        """Return the sharp image of the counts `observed`; ValueError for other blurs.

        `tell` is called after each tile.
        """
        blur, photo = observed.blur, _Photo.of(observed)
        parts: list[tuple[Tile, Callable[[Tile], _Problem]]]
        if isinstance(blur, UniformBlur | TiledBlur):
            blurs = (
                blur.parts
                if isinstance(blur, TiledBlur)
                else [(tile, blur) for tile in tiles_of(blur.shape, _TILE, _OVERLAP)]
            )
            parts = [(tile, partial(_Problem.uniform, photo, part)) for tile, part in blurs]
        elif uniform_over_field(blur):
            stride, overlap = (_TILE, _OVERLAP) if isinstance(blur, MeasuredBlur) else (_FIELD_TILE, _FIELD_TILE)
            tiles = tiles_of(blur.shape, stride, overlap, beyond=_FIELD_TILE // 2)
            parts = [(tile, partial(_FieldProblem.at_centre, photo, blur)) for tile in tiles]
        else:
            raise ValueError(
                "method=Blend() needs a lens and one distance of the whole scene, got the blur "
                f"{type(blur).__name__}; use RichardsonLucy() for this blur"
            )
        light, product = np.zeros_like(photo.light), 0.0
        fits, start = [], time.perf_counter()
        signs = np.random.default_rng(0).choice(np.array([-1.0, 1.0], _Real), photo.light.shape)
        for k, (tile, problem_of) in enumerate(parts):
            problem, core = problem_of(tile), _core(tile)
            estimates = problem.estimates(problem.light)
            if core is None:
                weights, change = problem.weighed(signs, estimates)
            else:
                probed = problem_of(core)
                weights, change = probed.weighed(signs, probed.estimates(probed.light))
            sharp = np.tensordot(weights, estimates, 1)
            fits.append(problem.fit(sharp))
            light[:, tile.rows, tile.columns] += tile.share * sharp[:, *problem.inside]
            product += change * float((tile.share * problem.certain[:, *problem.inside]).sum(dtype=np.float64))
            tell(k + 1, math.nan, (time.perf_counter() - start) * (len(parts) / (k + 1) - 1.0))
        # Light is not negative, but the output of a linear filter can be negative.
        result = _image(np.maximum(light, 0.0), observed.certain.shape)
        chi2, count = np.sum(fits, axis=0)
        return Solution(
            result, 1, ONE_PASS, lambda other: self.solve(other, silent).light,
            noise_product=product, least_discrepancy=float(chi2 / max(count, 1.0)),
        )  # fmt: skip


def uniform_over_field(blur: LinearBlur) -> TypeGuard[FieldBlur | MeasuredBlur]:
    """Return True for a blur that may vary over the field, but not with depth."""
    return isinstance(blur, MeasuredBlur) or (isinstance(blur, FieldBlur) and float(np.ptp(blur.defocus)) == 0.0)


def _cosines(planes: Values, overwrite: bool = False) -> Values:
    return np.asarray(scipy.fft.dctn(planes, axes=(-2, -1), norm="ortho", overwrite_x=overwrite))


def _inverse(spectra: Values) -> Values:
    """Return the planes of cosine spectra, which are overwritten."""
    return np.asarray(scipy.fft.idctn(spectra, axes=(-2, -1), norm="ortho", overwrite_x=True))


@cache
def _taps(rms: float) -> Values:
    """Return the weights of a Gaussian at distances from 0, pixels."""
    weights = np.exp(-0.5 * np.square(np.arange(int(2.5 * rms + 0.5) + 1) / rms))
    return np.asarray(weights / (2.0 * weights.sum() - 1.0), dtype=_Real)


def _smooth(planes: Values, rms: float) -> Values:
    widths = [0.0] * (planes.ndim - 2) + [rms, rms]
    return np.asarray(scipy.ndimage.gaussian_filter(planes, widths, truncate=2.5))


def _image(planes: Values, shape: tuple[int, ...]) -> Values:
    return np.ascontiguousarray(np.moveaxis(planes, 0, 2)).reshape(shape)


class Tile(NamedTuple):
    """Rows and columns of a tile in the image, and the share of each pixel of the image that it contributes.

    `first` and `last` are the corners of the tile, which may lie beyond the image.
    """

    rows: slice
    columns: slice
    share: Values
    first: tuple[int, int]
    last: tuple[int, int]


def tiles_of(shape: tuple[int, int], stride: int, overlap: int, beyond: int = 0) -> list[Tile]:
    """Return overlapping tiles of at least `stride`, whose shares sum to 1 at each pixel of an image.

    With `beyond`, the outer tiles extend beyond the image by this number of pixels.
    """
    axes = []
    for side in shape:
        count = max(1, (side + 2 * beyond) // stride)
        ends = np.rint(np.linspace(-beyond, side + beyond, count + 1)).astype(int)
        parts = []
        for k, (first, last) in enumerate(itertools.pairwise(ends.tolist())):
            place = np.arange(side) + 0.5
            rise = np.ones(side) if k == 0 else (place - first) / overlap + 0.5
            fall = np.ones(side) if k == count - 1 else (last - place) / overlap + 0.5
            share = np.clip(np.minimum(rise, fall), 0.0, 1.0).astype(_Real)
            start, stop = first - overlap // 2, last + overlap // 2
            if not beyond:
                start, stop = max(start, 0), min(stop, side)
            inside = slice(max(start, 0), min(stop, side))
            parts.append((inside, share[inside], start, stop))
        axes.append(parts)
    return [
        Tile(rows, columns, down[:, None] * across, (top, left), (bottom, right))
        for (rows, down, top, bottom), (columns, across, left, right) in itertools.product(*axes)
    ]


def _core(tile: Tile) -> Tile | None:
    """Return the middle of a tile, which stands for it in the choice of weights; None if it saves little time."""
    if min(stop - start for start, stop in zip(tile.first, tile.last, strict=True)) < 2 * _CORE:
        return None
    first = tuple((start + stop - _CORE) // 2 for start, stop in zip(tile.first, tile.last, strict=True))
    rows, columns = (slice(start + _CORE_MARGIN, start + _CORE - _CORE_MARGIN) for start in first)
    share = np.ones((rows.stop - rows.start, columns.stop - columns.start), _Real)
    return Tile(rows, columns, share, (first[0], first[1]), (first[0] + _CORE, first[1] + _CORE))


class _Photo(NamedTuple):
    """Planes (channels, height, width): light, stated noise variance, unknown pixels, saturated pixels."""

    light: Values
    variances: Values
    unknown: Values
    full: Values

    @classmethod
    def of(cls, observed: PhotographLikelihood) -> Self:
        """Return the planes of a photograph; unknown pixels have the light of the nearest known ones."""
        shape = (*observed.blur.shape, observed.blur.channels)
        known = (observed.weight > 0.0).reshape(shape)
        added = np.broadcast_to(observed.added, observed.counts.shape).reshape(shape)
        light = observed.counts.reshape(shape) - added
        planes = np.stack([fill_unknown(light[..., c], known[..., c]) for c in range(shape[2])]).astype(_Real)
        added = np.moveaxis(added, 2, 0)
        smooth = np.stack([_smooth(plane, _VARIANCE_RMS) for plane in planes])
        gain = np.moveaxis(np.where(known, observed.weight.reshape(shape), 1.0) * observed.white, 2, 0)
        variances = (np.maximum(smooth, 0.0) + added) / gain
        full = np.zeros(shape, dtype=bool) if observed.full is None else observed.full.reshape(shape) & known
        return cls(planes, variances.astype(_Real), ~np.moveaxis(known, 2, 0), np.moveaxis(full, 2, 0))

    def part(self, place: tuple[NDArray[np.int64], NDArray[np.int64]]) -> Self:
        """Return the part of the planes at these rows and columns."""
        return type(self)(*(values[:, *place] for values in self))


class _Problem:
    """Transfer functions, texture and noise of a part of a photograph, and its estimates.

    `inside` is the part without the margin beyond its tile, and `border` the width (pixels) of what does not test the
    blur.
    """

    _periodic = False

    def __init__(
        self, photo: _Photo, tile: Tile, margin: int, transfer: Callable[[tuple[int, int]], Values], curve: Array
    ) -> None:
        sides = photo.light.shape[1:]
        ends = zip(tile.first, tile.last, strict=True)
        width = margin + max(0, -min(tile.first), *(e - side for e, side in zip(tile.last, sides, strict=True)))
        rows, columns = (
            copies(side, width)[start - margin + width : stop + margin + width]
            for side, (start, stop) in zip(sides, ends, strict=True)
        )
        self.place = rows[:, None], columns
        part = photo.part(self.place)
        self.shape = len(rows), len(columns)
        self.inside = tuple(
            slice(part.start - start + margin, part.stop - start + margin)
            for part, start in zip((tile.rows, tile.columns), tile.first, strict=True)
        )
        self.h, self._curve, self._part = transfer(self.shape), curve, part
        self._squared = np.square(self.h.real) + np.square(self.h.imag)
        self.certain = ~(part.unknown | part.full)
        self.border = margin
        self._stated = np.maximum(part.variances.mean((1, 2), keepdims=True), 1e-30)
        self._describe(part.light)
        if not self.certain.all():
            self._fill()

    @classmethod
    def uniform(cls, photo: _Photo, blur: UniformBlur, tile: Tile) -> Self:
        """Return the problem of a tile of a photograph."""
        problem = cls(photo, tile, 0, blur.on, blur.curve(FREQUENCIES))
        problem.border = math.ceil(_BORDER * blur.radius)
        return problem

    def taken(self, planes: Values) -> Values:
        """Return the part of other planes."""
        return np.asarray(planes[:, *self.place])

    def _transformed(self, planes: Values, overwrite: bool = False) -> Values:
        return _cosines(planes, overwrite)

    def _inverted(self, spectra: Values) -> Values:
        return _inverse(spectra)

    def _axes(self) -> tuple[Array, Array]:
        return cosine_axes(self.shape)

    def _tapered(self, light: Values) -> Values:
        """Return the light with borders that suit the transform."""
        return light

    def _spectrum(self, light: Values) -> BlurSpectrum:
        """Return the power spectrum of the light."""
        return BlurSpectrum.cosine(light, self._stated)

    def _blurred(self, planes: Values) -> Values:
        return self._inverted(self.h * self._transformed(planes))

    def _describe(self, light: Values) -> None:
        """Estimate texture and noise of the light."""
        spectrum = self._spectrum(light)
        textures = [spectrum.texture(curve, c) for c, curve in enumerate(self._curve)]
        noise = np.array([texture.noise for texture in textures], _Real)[:, None, None]
        self.light, self.variances = light, self._part.variances * noise
        self.mean = self._stated.astype(_Real) * noise
        f = np.maximum(np.hypot(*self._axes()), 0.5 / max(self.shape))
        self._power = np.array([t.spectrum(f) / t.noise for t in textures], _Real)

    def _fill(self) -> None:
        """Replace unknown pixels and raise saturated ones by the blurred total variation, and describe the result."""
        part, filled = self._part, self._part.light.copy()

        def raised(spectrum: Values) -> Values:
            model = self._inverted(self.h * spectrum)
            np.copyto(filled, model, where=part.unknown)
            np.copyto(filled, np.maximum(part.light, model), where=part.full)
            return self._transformed(self._tapered(filled))

        spectrum = self._transformed(self._tapered(filled))
        self._variation(spectrum, self._inverted(self._wiener() * spectrum), _FILLING_STEPS, raised)
        self._describe(filled)

    def weighed(self, signs: Values, estimates: Values) -> tuple[Values, float]:
        """Return the weights of the estimates for the light, and the mean product of noise and change by the blend.

        `signs` of the whole photograph are those of a random direction.
        """
        step = _PROBE * self.taken(signs) * np.sqrt(self.variances)
        probed = self.estimates(self.light + step)
        weights = self._weights(estimates, probed, step)
        # The derivative times the variance, by Stein's lemma.
        product = step * (np.tensordot(weights, probed - estimates, 1) - step) / _PROBE**2
        certain = self.certain[:, *self.inside]
        return weights, float(product[:, *self.inside][certain].sum(dtype=np.float64) / max(certain.sum(), 1))

    def fit(self, light: Values) -> tuple[float, float]:
        """Return the sum of chi-squared of the pixels inside the border, and their number, where `light` fits best.

        The result is smoother than the scene. What is left of the photograph is therefore filtered once more.
        """
        residual = self._tapered(self.light) - self._blurred(light)
        light = light + self._inverted(self._wiener() * self._transformed(residual))
        residual = self.light - self._blurred(light)
        widths = (min(self.border, side // 4) for side in self.shape)
        inside = tuple(slice(width, side - width) for width, side in zip(widths, self.shape, strict=True))
        terms = np.where(self.certain, np.square(residual) / self._part.variances, 0.0)[:, *inside]
        return float(terms.sum(dtype=np.float64)), float(np.count_nonzero(terms))

    def _weights(self, estimates: Values, probed: Values, step: Values) -> Values:
        """Return the weights of the smallest risk, averaged with equal weights."""
        certain = np.zeros_like(self.certain)
        certain[:, *self.inside] = self.certain[:, *self.inside]
        scale = np.broadcast_to(1.0 / np.sqrt(self.mean), certain.shape)[certain]

        def blurred(images: Values) -> Array:
            return np.array([self._blurred(image)[certain] * scale for image in images], dtype=np.float64)

        q = blurred(estimates)
        covariance = (blurred(probed) - q) @ (step[certain] * scale).astype(np.float64) / _PROBE**2
        squares, product = q @ q.T, q @ (self.light[certain] * scale).astype(np.float64) - covariance
        steps = range(_WEIGHT_STEPS + 1)
        weights = np.array([w for w in itertools.product(steps, repeat=len(q)) if sum(w) == _WEIGHT_STEPS])
        weights = weights / _WEIGHT_STEPS
        risk = np.einsum("vi,ij,vj->v", weights, squares, weights) - 2.0 * weights @ product
        return np.asarray(0.5 * weights[np.argmin(risk)] + 0.5 / len(q), dtype=_Real)

    def estimates(self, light: Values) -> Values:
        """Return the estimates, (number, channels, height, width)."""
        spectrum = self._transformed(self._tapered(light))
        wiener = self._inverted(self._wiener() * spectrum)
        return np.stack([wiener, *self._local(spectrum), self._variation(spectrum, wiener, _STEPS)])

    def _local(self, spectrum: Values) -> list[Values]:
        """Return the local Wiener filter of a `spectrum`."""
        return [np.stack([self._local_wiener(c, plane) for c, plane in enumerate(spectrum)])]

    def _wiener(self, noise: float = 1.0) -> Values:
        """Return the Wiener filter for a fraction of the noise; it keeps the mean."""
        gain = self._power * self.h.conj() / (self._power * self._squared + _Real(noise))
        gain[:, 0, 0] = 1.0
        return np.asarray(gain)

    def _local_wiener(self, channel: int, spectrum: Values) -> Values:
        """Return the plane of a `spectrum`, filtered and shrunk twice in the frame."""
        bands, low = _frame(self.shape)
        filtered = self._wiener(_PILOT_NOISE)[channel]
        transmitted, start = filtered * self.h[channel], filtered * spectrum
        relative = self.variances[channel] / self.mean[channel]
        variances = {sides: _reduced(relative, sides) for sides in {band.sides for band in bands}}
        result, coefficients = low * start, []
        for b in bands:
            values = _inverse(b.gain * start[b.part])
            noise = self.mean[channel, 0, 0] * np.square(b.gain * filtered[b.part]).mean((1, 2))
            shrunk = values.copy()
            engine.shrink_bands(shrunk, variances[b.sides], noise, _taps(_LOCAL_RMS[0] * b.scale))
            result[b.part] += b.joined(_cosines(shrunk, overwrite=True))
            coefficients.append((values, noise))
        pilot, result = result, low * start
        for b, (values, noise) in zip(bands, coefficients, strict=True):
            sharp = _inverse(b.gain * pilot[b.part])
            seen = _inverse(b.gain * transmitted[b.part] * pilot[b.part])
            engine.shrink_bands(values, variances[b.sides], noise, _taps(_LOCAL_RMS[1] * b.scale), seen, sharp)
            result[b.part] += b.joined(_cosines(values, overwrite=True))
        return _inverse(result)

    def _variation(
        self, spectrum: Values, start: Values, steps: int, renewed: Callable[[Values], Values] | None = None
    ) -> Values:
        """Return the minimum of the total variation of all channels together; `renewed` replaces the `spectrum`."""
        fy, fx = self._axes()
        laplacian = (4.0 * np.sin(np.pi * fy) ** 2 + 4.0 * np.sin(np.pi * fx) ** 2).astype(_Real)
        precision, weighted = self._squared / self.mean, self.h.conj() / self.mean
        data = weighted * spectrum
        light, penalty, target = start, _Real(0.0), len(start) * _STRENGTH
        dual = np.zeros((2, *light.shape), light.dtype)
        before, strength = _Real(1.0), 0.0
        for k in range(steps):
            factor = 1.0
            if k % _RENEWED == 0:
                mean = max(engine.gradient_sum(light, self._periodic) / light[0].size, 1e-9)
                strength = target / mean
                if k < _TUNED:
                    before, penalty = penalty, _Real(2.0 * strength / mean)
                    factor = float(before / penalty)
                    inverse = 1.0 / (precision + penalty * laplacian + _Real(1e-12))
                if renewed is not None and k:
                    data = weighted * renewed(self._transformed(light))
                fixed, share = data * inverse, penalty * inverse
            # Shrinkage of the gradient by lambda / penalty, for all channels together.
            field = engine.shrink_gradient(light, dual, factor, float(strength / penalty), self._periodic)
            spectrum = self._transformed(field, overwrite=True)
            spectrum *= share
            spectrum += fixed
            light = self._inverted(spectrum)
        return light


class _FieldProblem(_Problem):
    """A part with any PSF, by Fourier transforms; its borders are tapered."""

    _periodic = True

    @classmethod
    def at_centre(cls, photo: _Photo, blur: FieldBlur | MeasuredBlur, tile: Tile) -> Self:
        """Return the problem of a tile, with the PSF of its centre."""
        row, column = (
            min(max((start + stop) // 2, 0), side - 1)
            for start, stop, side in zip(tile.first, tile.last, blur.shape, strict=True)
        )
        windows = [blur.window(row, column, c) for c in range(blur.channels)]
        half = max(len(window) for window in windows) // 2
        transfer = partial(_window_transfer, windows)
        return cls(photo, tile, max(2 * half, _FIELD_MARGIN), transfer, _radial(transfer, half))

    def _transformed(self, planes: Values, overwrite: bool = False) -> Values:
        return np.asarray(scipy.fft.rfft2(planes, overwrite_x=overwrite))

    def _inverted(self, spectra: Values) -> Values:
        return np.asarray(scipy.fft.irfft2(spectra, self.shape))

    def _axes(self) -> tuple[Array, Array]:
        return _fourier_axes(self.shape)

    def _tapered(self, light: Values) -> Values:
        down, across = (
            np.minimum((np.minimum(np.arange(side), np.arange(side)[::-1]) + 1.0) / (0.6 * self.border), 1.0)
            for side in self.shape
        )
        share = np.multiply.outer(down, across).astype(_Real)
        return share * light + (1.0 - share) * self._blurred(light)

    def _spectrum(self, light: Values) -> BlurSpectrum:
        return BlurSpectrum.windowed(light, self._part.variances)

    def _local(self, spectrum: Values) -> list[Values]:
        return []


def _fourier_axes(shape: tuple[int, int]) -> tuple[Array, Array]:
    return np.asarray(np.fft.fftfreq(shape[0]))[:, None], np.asarray(np.fft.rfftfreq(shape[1]))


def _window_transfer(windows: Sequence[Array], shape: tuple[int, int]) -> Values:
    """Return the transfer functions of windows on real Fourier transforms of an image, without that of the pixel."""
    half = max(len(window) for window in windows) // 2
    planes = np.zeros((len(windows), *shape), _Real)
    for plane, window in zip(planes, windows, strict=True):
        first = half - len(window) // 2
        plane[first : first + len(window), first : first + len(window)] = window
    fy, fx = _fourier_axes(shape)
    # Windows include the pixel, which is a part of the scene that is estimated.
    spectra = scipy.fft.rfft2(np.roll(planes, (-half, -half), (1, 2)))
    return np.asarray(spectra / (np.sinc(fy) * np.sinc(fx)).astype(_Real))


def radial_curve(blur: MeasuredBlur, channel: int) -> Array:
    """Return the rms of the transfer function of a PSF over all directions at FREQUENCIES."""
    window = blur.window(0, 0, channel)
    return np.asarray(_radial(partial(_window_transfer, [window]), len(window) // 2)[0])


def _radial(transfer: Callable[[tuple[int, int]], Values], half: int) -> Array:
    """Return the rms of transfer functions over all directions at FREQUENCIES, 0 beyond those of pixels."""
    side = max(256, 4 * half)
    values = np.square(np.abs(transfer((side, side)), dtype=np.float64))
    spacing = FREQUENCIES[1] - FREQUENCIES[0]
    ring = (np.hypot(*_fourier_axes((side, side))) / spacing).astype(np.intp).ravel()
    counts = np.bincount(ring, minlength=len(FREQUENCIES))
    sums = np.array([np.bincount(ring, plane.ravel(), len(FREQUENCIES)) for plane in values])
    return np.asarray(np.sqrt(sums / np.maximum(counts, 1))[:, : len(FREQUENCIES)])


class _Band(NamedTuple):
    """An octave of the frame: gains of its directions at the frequencies of its part, and scale in pixels of that."""

    part: tuple[slice, slice]
    gain: Values
    scale: float

    @property
    def sides(self) -> tuple[int, ...]:
        """Shape of the part."""
        return self.gain.shape[1:]

    def joined(self, spectra: Values) -> Values:
        """Return the part of a spectrum of which these are the directions."""
        return np.asarray(np.einsum("dyx,dyx->yx", self.gain, spectra))


@lru_cache(maxsize=4)
def _frame(shape: tuple[int, int]) -> tuple[list[_Band], Values]:
    """Return the octaves of a tight frame, in all directions, and the low pass beside them.

    The sum of all squares is 1. Bands of low frequencies are sampled more coarsely: a part of a cosine transform is
    that of a smaller image.
    """
    fy, fx = cosine_axes(shape)
    octave = np.log2(np.maximum(np.hypot(fy, fx), 1e-6) / 0.5)
    direction = np.arctan2(fy, fx) * (_DIRECTIONS - 1) / (0.5 * np.pi)
    bands, above = [], np.ones(shape)
    for k in range(_OCTAVES):
        low = np.cos(0.5 * np.pi * np.clip(octave + k + 1.0, 0.0, 1.0))
        ring = above * np.sqrt(1.0 - np.square(low))
        above = above * low
        stride = 2 ** max(k - 1, 0)
        part = np.s_[: -(-shape[0] // stride), : -(-shape[1] // stride)]
        centres = np.arange(_DIRECTIONS)[:, None, None]
        gains = ring[part] * np.cos(0.5 * np.pi * np.clip(np.abs(direction[part] - centres), 0.0, 1.0))
        bands.append(_Band(part, gains.astype(_Real), 2.0 ** min(k, 1)))
    return bands, above.astype(_Real)


def _reduced(plane: Values, shape: tuple[int, ...]) -> Values:
    """Return a plane of positive values at the coarser sampling of `shape`."""
    if plane.shape == shape:
        return plane
    coarse = _inverse(_cosines(plane)[: shape[0], : shape[1]]) * math.sqrt(math.prod(shape) / plane.size)
    return np.asarray(np.maximum(coarse, plane.min()), dtype=_Real)
