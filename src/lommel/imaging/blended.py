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

import math
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import NamedTuple, Self

import numpy as np
import scipy

from lommel.base.arrays import Array, Values
from lommel.deconvolve.algorithms import ONE_PASS, ProgressCallback, silent
from lommel.deconvolve.iterations import Solution
from lommel.deconvolve.likelihood import PhotographLikelihood
from lommel.deconvolve.linear import LinearBlur
from lommel.estimation.focal_model import Spectrum, pupil_curve
from lommel.imaging.blur_spectrum import FREQUENCIES, BlurSpectrum
from lommel.imaging.one_pass import fill_unknown
from lommel.optics.pupil import Pupil

_PILOT_NOISE = 0.5  # noise for which the filter before shrinkage is computed / noise
_OCTAVES, _DIRECTIONS = 4, 4  # of the frame
_LOCAL_RMS = 1.2, 0.72  # rms of the Gaussians that average energies, first and second time, / 2^octave pixels
_STRENGTH = 0.5  # lambda times the mean gradient of a channel
_STEPS, _RENEWED, _TUNED = (
    30,
    3,
    12,
)  # steps of the total variation; steps between renewals of lambda; last of the penalty
_FILLING_STEPS = 60  # steps of the total variation that fills saturated and unknown pixels
_PROBE = 0.3  # change of the photograph / noise, for the derivative of the estimates
_WEIGHT_STEPS = 10  # steps of the weights from 0 to 1
_VARIANCE_RMS = 2.0  # rms width (pixels) of the Gaussian that smooths the light of which the noise is computed
_BORDER = 3.0  # width of the border that does not test the blur, whose light comes from beyond / radius of the blur
_TILE, _OVERLAP = 512, 128  # stride and overlap (pixels) of the tiles of large images

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
        return self.curve(_frequency(shape)).astype(_Real)

    def forward(self, image: Values) -> Values:
        """Return the blurred image."""
        return self.by_channel(image, lambda c, plane: _inverse(self.transfer[c] * _cosines(plane)))

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward`, which is equal to it."""
        return self.forward(image)


class Blend:
    """Deblurring of one uniform blur by a Wiener filter, a local Wiener filter and total variation, blended.

    The weights of the three minimise the predicted squared error. The result estimates the pixel-averaged scene. The
    whole scene must have one distance.
    """

    def solve(self, observed: PhotographLikelihood, tell: ProgressCallback) -> Solution:
        """Return the sharp image of the counts `observed`, and call `tell` once; ValueError for other blurs."""
        blur = observed.blur
        if not isinstance(blur, UniformBlur):
            raise ValueError(
                "method=Blend() needs a lens and one distance of the whole scene, got the blur "
                f"{type(blur).__name__}; use RichardsonLucy() for this blur"
            )
        photo = _Photo.of(observed)
        light, change = np.zeros_like(photo.light), np.zeros_like(photo.light)
        fits = []
        signs = np.random.default_rng(0).choice(np.array([-1.0, 1.0], _Real), photo.light.shape)
        for rows, columns, share in _tiles(blur.shape):
            part = photo.part(rows, columns)
            problem = _Problem.of(part, blur)
            step = _PROBE * signs[:, rows, columns] * np.sqrt(problem.variances)
            sharp, probed = problem.blended(part, step)
            light[:, rows, columns] += share * sharp
            fits.append(problem.fit(part, sharp, math.ceil(_BORDER * blur.radius)))
            # The derivative times the variance, by Stein's lemma.
            change[:, rows, columns] += share * step * (probed - sharp - step) / _PROBE**2
        certain = observed.certain
        tell(1, math.nan, 0.0)
        # Light is not negative, but the output of a linear filter can be negative.
        result = _image(np.maximum(light, 0.0), certain.shape)
        product = float(_image(change, certain.shape)[certain].sum(dtype=np.float64))
        chi2, count = np.sum(fits, axis=0)
        return Solution(
            result, 1, ONE_PASS, lambda other: self.solve(other, silent).light,
            noise_product=product, least_discrepancy=float(chi2 / max(count, 1.0)),
        )  # fmt: skip


def _cosines(planes: Values) -> Values:
    return np.asarray(scipy.fft.dctn(planes, axes=(-2, -1), norm="ortho"))


def _inverse(planes: Values) -> Values:
    return np.asarray(scipy.fft.idctn(planes, axes=(-2, -1), norm="ortho"))


def _axes(shape: tuple[int, int]) -> tuple[Array, Array]:
    return np.arange(shape[0])[:, None] / (2.0 * shape[0]), np.arange(shape[1]) / (2.0 * shape[1])


def _frequency(shape: tuple[int, int]) -> Array:
    return np.asarray(np.hypot(*_axes(shape)))


def _smooth(plane: Values, rms: float) -> Values:
    return np.asarray(scipy.ndimage.gaussian_filter(plane, rms, truncate=2.5))


def _image(planes: Values, shape: tuple[int, ...]) -> Values:
    return np.ascontiguousarray(np.moveaxis(planes, 0, 2)).reshape(shape)


def _tiles(shape: tuple[int, int]) -> list[tuple[slice, slice, Values]]:
    """Return rows, columns and weights of overlapping tiles; the weights sum to 1 at each pixel."""
    sides = []
    for side in shape:
        count = max(1, round(side / _TILE))
        ends = np.linspace(0, side, count + 1)
        parts = []
        for k in range(count):
            first, last = max(round(ends[k]) - _OVERLAP // 2, 0), min(round(ends[k + 1]) + _OVERLAP // 2, side)
            place = np.arange(first, last) + 0.5
            rise = np.ones_like(place) if k == 0 else (place - round(ends[k])) / _OVERLAP + 0.5
            fall = np.ones_like(place) if k == count - 1 else (round(ends[k + 1]) - place) / _OVERLAP + 0.5
            parts.append((slice(first, last), np.clip(np.minimum(rise, fall), 0.0, 1.0).astype(_Real)))
        sides.append(parts)
    return [(rows, columns, down[:, None] * across) for rows, down in sides[0] for columns, across in sides[1]]


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

    def part(self, rows: slice, columns: slice) -> Self:
        """Return a part of the planes."""
        return type(self)(*(values[:, rows, columns] for values in self))


class _Problem:
    """Transfer functions, texture and noise of a part of a photograph, and its estimates."""

    def __init__(self, part: _Photo, transfer: Values, curve: Array) -> None:
        self.h, self._curve = transfer, curve
        self.shape = part.light.shape[1], part.light.shape[2]
        self._stated = np.maximum(part.variances.mean((1, 2), keepdims=True), 1e-30)
        self._describe(part.light, part.variances)

    @classmethod
    def of(cls, part: _Photo, blur: UniformBlur) -> Self:
        """Return the problem of a part, after filling its unknown and saturated pixels."""
        shape = part.light.shape[1], part.light.shape[2]
        transfer = blur.transfer if shape == blur.shape else blur.on(shape)
        problem = cls(part, transfer, blur.curve(FREQUENCIES))
        if part.full.any() or part.unknown.any():
            problem._fill(part)
        return problem

    def _describe(self, light: Values, variances: Values) -> None:
        """Estimate texture and noise of the light."""
        f = _frequency(self.shape)
        power = np.square(_cosines(light), dtype=np.float64) / self._stated
        spectrum = BlurSpectrum.cosine(power, f)
        textures = [spectrum.texture(curve, c) for c, curve in enumerate(self._curve)]
        noise = np.array([texture.noise for texture in textures], _Real)[:, None, None]
        self.light, self.variances = light, variances * noise
        self.mean = self._stated.astype(_Real) * noise
        f = np.maximum(f, 0.5 / max(self.shape))
        self._power = np.array([t.spectrum(f) / t.noise for t in textures], _Real)

    def _fill(self, part: _Photo) -> None:
        """Replace unknown pixels and raise saturated ones by the blurred total variation, and describe the result."""
        filled = part.light.copy()

        def raised(spectrum: Values) -> Values:
            model = _inverse(self.h * spectrum)
            np.copyto(filled, model, where=part.unknown)
            np.copyto(filled, np.maximum(part.light, model), where=part.full)
            return _cosines(filled)

        spectrum = _cosines(filled)
        self._variation(spectrum, _inverse(self._wiener() * spectrum), _FILLING_STEPS, raised)
        self._describe(filled, part.variances)

    def blended(self, part: _Photo, step: Values) -> tuple[Values, Values]:
        """Return the blend of the estimates for the light, and with the same weights for the light plus `step`."""
        estimates, probed = self._estimates(self.light), self._estimates(self.light + step)
        weights = self._weights(estimates, probed, step, ~(part.unknown | part.full))
        return np.tensordot(weights, estimates, 1), np.tensordot(weights, probed, 1)

    def fit(self, part: _Photo, light: Values, border: int) -> tuple[float, float]:
        """Return the sum of chi-squared of the pixels inside a border, and their number, where `light` fits best.

        The result is smoother than the scene. What is left of the photograph is therefore filtered once more.
        """
        for _ in range(2):
            residual = self.light - _inverse(self.h * _cosines(light))
            light = light + _inverse(self._wiener() * _cosines(residual))
        inside = tuple(slice(min(border, side // 4), side - min(border, side // 4)) for side in self.shape)
        terms = np.where(part.unknown | part.full, 0.0, np.square(residual) / part.variances)[:, *inside]
        return float(terms.sum(dtype=np.float64)), float(np.count_nonzero(terms))

    def _weights(self, estimates: Values, probed: Values, step: Values, certain: Values) -> Values:
        """Return the weights of the smallest risk, averaged with equal weights."""
        scale = np.broadcast_to(1.0 / np.sqrt(self.mean), certain.shape)[certain]

        def blurred(images: Values) -> Array:
            seen = [_inverse(self.h * _cosines(image))[certain] * scale for image in images]
            return np.asarray(seen, dtype=np.float64)

        q = blurred(estimates)
        covariance = (blurred(probed) - q) @ (step[certain] * scale).astype(np.float64) / _PROBE**2
        squares, product = q @ q.T, q @ (self.light[certain] * scale).astype(np.float64) - covariance
        n = _WEIGHT_STEPS
        weights = np.array([(i, j, n - i - j) for i in range(n + 1) for j in range(n + 1 - i)]) / n
        risk = np.einsum("vi,ij,vj->v", weights, squares, weights) - 2.0 * weights @ product
        return (0.5 * weights[np.argmin(risk)] + 0.5 / len(q)).astype(_Real)

    def _estimates(self, light: Values) -> Values:
        """Return the three estimates, (3, channels, height, width)."""
        spectrum = _cosines(light)
        wiener = _inverse(self._wiener() * spectrum)
        local = np.stack([self._local_wiener(c, plane) for c, plane in enumerate(spectrum)])
        return np.stack([wiener, local, self._variation(spectrum, wiener, _STEPS)])

    def _wiener(self, noise: float = 1.0) -> Values:
        """Return the Wiener filter for a fraction of the noise; it keeps the mean."""
        gain = self._power * self.h / (self._power * np.square(self.h) + _Real(noise))
        gain[:, 0, 0] = 1.0
        return gain

    def _local_wiener(self, channel: int, spectrum: Values) -> Values:
        """Return the plane of a `spectrum`, filtered and shrunk twice in the frame."""
        bands, low = _frame(self.shape)
        filtered = self._wiener(_PILOT_NOISE)[channel]
        transmitted, start = filtered * self.h[channel], filtered * spectrum
        relative = self.variances[channel] / self.mean[channel]
        variances = {count: _reduced(relative, count) for count in {band.count for band in bands}}
        result, coefficients = low * start, []
        for b in bands:
            values = _inverse(b.gain * start[b.part])
            noise = variances[b.count] * (self.mean[channel] * np.mean(np.square(b.gain * filtered[b.part])))
            energy = _smooth(np.square(values), _LOCAL_RMS[0] * b.scale)
            shrunk = values * np.maximum(energy - noise, 0.0) / np.maximum(energy, 1e-30)
            result[b.part] += b.gain * _cosines(shrunk)
            coefficients.append((values, noise))
        pilot, result = result, low * start
        for b, (values, noise) in zip(bands, coefficients, strict=True):
            sharp = _inverse(b.gain * pilot[b.part])
            seen = _inverse(b.gain * transmitted[b.part] * pilot[b.part])
            energy, product = (_smooth(seen * other, _LOCAL_RMS[1] * b.scale) for other in (seen, sharp))
            result[b.part] += b.gain * _cosines(values * product / np.maximum(energy + noise, 1e-30))
        return _inverse(result)

    def _variation(
        self, spectrum: Values, start: Values, steps: int, renewed: Callable[[Values], Values] | None = None
    ) -> Values:
        """Return the minimum of the total variation of all channels together; `renewed` replaces the `spectrum`."""
        fy, fx = _axes(self.shape)
        laplacian = (4.0 * np.sin(np.pi * fy) ** 2 + 4.0 * np.sin(np.pi * fx) ** 2).astype(_Real)
        precision = np.square(self.h) / self.mean
        data = self.h * spectrum / self.mean
        light, penalty, target = start, _Real(0.0), len(start) * _STRENGTH
        gradient = _gradient(light)
        dual = np.zeros_like(gradient)
        for k in range(steps):
            if k % _RENEWED == 0:
                mean = max(float(np.sqrt(np.square(gradient).sum((0, 1))).mean(dtype=np.float64)), 1e-9)
                strength = target / mean
                if k < _TUNED:
                    before, penalty = penalty, _Real(2.0 * strength / mean)
                    dual *= before / penalty
                    inverse = 1.0 / (precision + penalty * laplacian + _Real(1e-12))
                if renewed is not None and k:
                    data = self.h * renewed(_cosines(light)) / self.mean
            # Shrinkage of the gradient by lambda / penalty, for all channels together.
            dual += gradient
            norm = np.sqrt(np.square(dual).sum((0, 1)))
            split = dual * np.maximum(1.0 - _Real(strength / penalty) / np.maximum(norm, 1e-12), 0.0)
            dual -= split
            light = _inverse((data + penalty * _cosines(_divergence(split - dual))) * inverse)
            gradient = _gradient(light)
        return light


def _gradient(planes: Values) -> Values:
    """Return the differences to the next row and to the next column, 0 at the last ones."""
    gradient = np.zeros((2, *planes.shape), planes.dtype)
    np.subtract(planes[:, 1:], planes[:, :-1], out=gradient[0, :, :-1])
    np.subtract(planes[:, :, 1:], planes[:, :, :-1], out=gradient[1, :, :, :-1])
    return gradient


def _divergence(field: Values) -> Values:
    """Return the transpose of `_gradient`."""
    planes = -field[0] - field[1]
    planes[:, 1:] += field[0, :, :-1]
    planes[:, :, 1:] += field[1, :, :, :-1]
    return np.asarray(planes)


class _Band(NamedTuple):
    """Part of the frame: its gain at the low frequencies that it contains, and its scale in pixels of that part."""

    part: tuple[slice, slice]
    gain: Values
    scale: float

    @property
    def count(self) -> tuple[int, ...]:
        """Shape of the part."""
        return self.gain.shape


@lru_cache(maxsize=4)
def _frame(shape: tuple[int, int]) -> tuple[list[_Band], Values]:
    """Return bands of a tight frame, one octave wide and of one direction, and the low pass beside them.

    The sum of all squares is 1. Bands of low frequencies are sampled more coarsely: a part of a cosine transform is
    that of a smaller image.
    """
    fy, fx = _axes(shape)
    octave = np.log2(np.maximum(np.hypot(fy, fx), 1e-6) / 0.5)
    direction = np.arctan2(fy, fx) * (_DIRECTIONS - 1) / (0.5 * np.pi)
    bands, above = [], np.ones(shape)
    for k in range(_OCTAVES):
        low = np.cos(0.5 * np.pi * np.clip(octave + k + 1.0, 0.0, 1.0))
        ring = above * np.sqrt(1.0 - np.square(low))
        above = above * low
        stride = 2 ** max(k - 1, 0)
        part = np.s_[: -(-shape[0] // stride), : -(-shape[1] // stride)]
        for j in range(_DIRECTIONS):
            gain = ring * np.cos(0.5 * np.pi * np.clip(np.abs(direction - j), 0.0, 1.0))
            bands.append(_Band(part, gain[part].astype(_Real), 2.0 ** min(k, 1)))
    return bands, above.astype(_Real)


def _reduced(plane: Values, shape: tuple[int, ...]) -> Values:
    """Return a plane of positive values at the coarser sampling of `shape`."""
    if plane.shape == shape:
        return plane
    coarse = _inverse(_cosines(plane)[: shape[0], : shape[1]]) * math.sqrt(math.prod(shape) / plane.size)
    return np.maximum(coarse, plane.min()).astype(_Real)
