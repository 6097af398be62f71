r"""Deblurring in one pass: the Wiener filter of each depth, for the texture and the noise of the photograph.

Let h be the transfer function of optics and pixel at one depth, P the transfer function of the pixel alone, nu the
variance of white noise / its stated variance, and ``S(f) = c f^-s`` the power spectrum of the texture. The filter
``P S h / (S h^2 + nu)`` estimates the pixel-averaged scene. It is approximated by polynomials of one small filter
(:mod:`lommel.imaging.focal_tables`). The coefficients of the polynomials are computed at a few depths, as one table
for each depth, and interpolated between these depths.

The estimates of c, s and nu are those of :mod:`lommel.imaging.blur_spectrum`, for the mean of h^2 over all pixels.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.deconvolve.algorithms import ONE_PASS, ProgressCallback, silent
from lommel.deconvolve.iterations import Solution
from lommel.deconvolve.likelihood import PhotographLikelihood
from lommel.deconvolve.linear import LinearBlur
from lommel.estimation.focal_model import LARGEST, FocalLight, FocalModel, transfer_curve
from lommel.imaging.blur import DepthBlur
from lommel.imaging.blur_spectrum import FREQUENCIES, BlurSpectrum, Texture
from lommel.imaging.focal_engine import processors
from lommel.imaging.focal_tables import SharpTables, Taps
from lommel.imaging.occlusion import Occlusion

_STEP = 0.75  # radians of defocus between tables
_MAX_TABLES = 961  # largest number of tables
_DEGREES, _GOOD_LOSS = (12, 24, 48), 0.1  # polynomial degrees in the order tried; loss (dB) at which the search stops
_MIN_ERROR = 0.01  # mean squared error / pixel variance, added to errors before losses are computed
_EDGE_POWER = 4.0  # power of texture at depth edges / power elsewhere
_EDGE_STEP = 1.5  # depth difference, in units of the table spacing, that counts as a depth edge
_LOCAL_RMS = 3.0  # rms width, in pixels, of the Gaussian that averages residuals locally
_DISTANCES = (2, 6, 16)  # distances in pixels from which a filter collects light
_MIN_SIDE, _MULTIPLE = 160, 16  # smallest side of a filtered image; every side is a multiple of _MULTIPLE (pixels)


@dataclass(frozen=True)
class _Light(FocalLight):
    """Light in units in which the noise of a pixel has the variance 1."""

    texture: Texture

    def binned(self, pixels: int) -> Self:
        """Return this object unchanged: the method does not bin pixels."""
        return self

    def power(self, f: Array) -> Array:
        """Return the power of the texture, in units of the noise variance."""
        return self.texture.spectrum(np.maximum(f, 1.0 / LARGEST)) / self.texture.noise


_MAX_LOSS = 1.0  # largest loss (dB), over all distances, of the polynomials relative to the exact Wiener filter


@dataclass(frozen=True)
class OnePass:
    """Deblurring in one pass by the Wiener filter of each depth, for the texture and noise of the photograph.

    The filters are those of :class:`lommel.imaging.LiveSharpen`: polynomials of one small filter, interpolated in
    depth. They take much less time than iterative deblurring. Occlusion is not modelled. The result estimates the
    pixel-averaged scene, and keeps its mean. The pupil must be circular or annular. A blur that is too wide for the
    filters raises ValueError.
    """

    def solve(
        self, observed: PhotographLikelihood, tell: ProgressCallback, textures: Sequence[Texture] | None = None
    ) -> Solution:
        """Return the sharp image of the counts `observed`, and call `tell` once; ValueError for other blurs.

        `textures` are those of the channels; by default they are estimated from the photograph.
        """
        blur = lens_blur(observed.blur)
        if blur is None:
            raise ValueError(
                "method=OnePass() needs a lens with a circular or annular pupil and a depth map, got the blur "
                f"{type(observed.blur).__name__}; use RichardsonLucy() for this blur"
            )
        scene = _Scene(observed, blur)
        light = np.empty((*blur.shape, blur.channels), dtype=blur.dtype)
        of_channels = textures or tuple(scene.texture(c) for c in range(blur.channels))
        for c, texture in enumerate(of_channels):
            tables = self._tables(scene.model(c, texture))
            light[..., c] = _filter_plane(tables, scene.planes[c], scene.places, blur.threads)
        # Light is not negative, but the output of a linear filter can be negative.
        sharp = np.maximum(light, 0.0).reshape(observed.counts.shape)
        # Filters assume one depth: near depth edges they include light with another blur.
        at_edges = _near_edges(scene.places)
        if at_edges.any():
            sharp = _blend_at_edges(observed, sharp, at_edges, [texture.noise for texture in of_channels])
        tell(1, math.nan, 0.0)
        return Solution(sharp, 1, ONE_PASS, lambda other: self.solve(other, silent, of_channels).light)

    def _tables(self, model: FocalModel) -> SharpTables:
        """Return filters of the lowest degree with a small loss; ValueError if all losses exceed `_MAX_LOSS`."""
        for degree in _DEGREES:
            tables = SharpTables(model, Taps.of(5), degree)
            exact, approximate = tables.errors(tables.pixel)
            losses = 10.0 * np.log10((approximate + _MIN_ERROR) / (exact + _MIN_ERROR))
            if losses.max() <= _GOOD_LOSS:
                return tables
        if losses.max() > _MAX_LOSS:
            k = int(np.argmax(losses))
            with np.errstate(divide="ignore"):
                distance = 1.0 / model.vergence[k]
            raise ValueError(
                f"method=OnePass() loses {losses[k]:.2g} dB at {distance:.4g} m, "
                "because the blur is too wide for its polynomial filters; use RichardsonLucy()"
            )
        return tables


class _Scene:
    """A photograph taken with a lens: its channels, and the vergences (1 / distance) of the tables."""

    def __init__(self, observed: PhotographLikelihood, blur: DepthBlur) -> None:
        self._blur = blur
        self.vergence, self.places = _vergences(blur)
        shape = (*blur.shape, blur.channels)
        known = (observed.weight > 0.0).reshape(shape)
        background = np.broadcast_to(observed.added, observed.counts.shape).reshape(shape)
        # Clipping at 0 would bias the mean.
        light = observed.counts.reshape(shape) - background
        self.planes = [fill_unknown(light[..., c], known[..., c]) for c in range(blur.channels)]
        self._variances = [
            # Noise variance in units of light: the mean count plus the read-noise variance, divided by white.
            float(np.mean(plane) + np.mean(background[..., c])) / observed.white
            for c, plane in enumerate(self.planes)
        ]
        self._neighbour_shares = _neighbour_shares(self.places, len(self.vergence))
        curves = {
            spectrum: transfer_curve(blur.lens, self.vergence, spectrum, blur.pixel) for spectrum in set(blur.spectra)
        }
        self._curves = [curves[spectrum] for spectrum in blur.spectra]

    def texture(self, channel: int) -> Texture:
        """Return the estimated texture of a channel, which includes the noise."""
        return self._spectrum(channel).texture(self._transmitted(channel), 0)

    def _spectrum(self, channel: int) -> BlurSpectrum:
        """Return the power spectrum of a channel."""
        return BlurSpectrum.cosine(self.planes[channel][None], np.array(self._variances[channel]))

    def _transmitted(self, channel: int) -> Array:
        """Return the rms transfer function of all pixels at FREQUENCIES."""
        count = len(self.vergence)
        weights = np.bincount(np.rint(self.places).astype(int).ravel(), minlength=count) / self.places.size
        return np.asarray(np.sqrt(weights @ np.square(self._curves[channel](FREQUENCIES))))

    def model(self, channel: int, texture: Texture) -> FocalModel:
        """Return the model of a channel. Light with the blur of other depths is treated as noise."""
        blur, curve = self._blur, self._curves[channel]
        light = _Light(1.0, 0.0, (1.0,), 0.0, texture)
        model = FocalModel.of(
            [blur.lens], self.vergence, blur.spectra[channel], blur.pixel, light, transfer=lambda *_: curve
        )
        stray_power = _stray_power(model.transfer[:, 0], model.texture, self._neighbour_shares)[:, None]
        return replace(model, noise=model.noise + stray_power)

    def target(self, channel: int) -> float:
        """Return the residual power of a channel expected of the Wiener filter, in units of the stated variance."""
        spectrum, transmitted = self._spectrum(channel), self._transmitted(channel)
        return spectrum.residual(transmitted, spectrum.texture(transmitted, 0))


def wiener_target(observed: PhotographLikelihood) -> tuple[float, float] | None:
    """Return the residual power expected of the Wiener filter, and the noise variance, both / the stated variance.

    Return None if the blur is too wide for the transfer functions, or is not the blur of a lens and a depth map.
    """
    blur = lens_blur(observed.blur)
    if blur is None:
        return None
    try:
        scene = _Scene(observed, blur)
    except ValueError:
        return None
    noise = [scene.texture(c).noise for c in range(blur.channels)]
    return observed.mean(np.array([scene.target(c) for c in range(blur.channels)])), observed.mean(np.array(noise))


def lens_blur(blur: LinearBlur) -> DepthBlur | None:
    """Return the DepthBlur of a DepthBlur or Occlusion; None for other operators."""
    return blur if isinstance(blur, DepthBlur) else blur.blur if isinstance(blur, Occlusion) else None


def _vergences(blur: DepthBlur) -> tuple[Array, NDArray[np.float32]]:
    """Return the vergence (1 / distance) of each table, and the position of each pixel as an index of a table."""
    # C_d is linear in 1 / distance (paper, Eq. 3): two distances determine the line.
    at_half_metre, at_metre = (float(defocus) for defocus in blur.lens.defocus([0.5, 1.0]))
    slope = at_half_metre - at_metre  # C_d per unit of vergence
    low, high = float(blur.defocus.min()), float(blur.defocus.max())
    count = min(max(2, math.ceil((high - low) / _STEP) + 1), _MAX_TABLES)
    defocus = np.linspace(low, max(high, low + 1e-3), count)
    # Rounding could make the vergence of an infinite distance negative.
    vergence = np.maximum(1.0 + (defocus - at_metre) / slope, 0.0)
    return vergence, np.asarray((blur.defocus - low) / (defocus[1] - low), dtype=np.float32)


def _neighbour_shares(places: NDArray[np.float32], count: int) -> Array:
    """Return a matrix: for pixels with table i, the fraction [i, j] of neighbours at `_DISTANCES` with table j."""
    index = np.rint(places).astype(np.int64)
    pairs = np.zeros((count, count))
    for distance in _DISTANCES:
        for a, b in ((index[distance:], index[:-distance]), (index[:, distance:], index[:, :-distance])):
            counts = np.bincount((a * count + b).ravel(), minlength=count**2)
            pairs += counts.reshape(count, count)
    pairs += pairs.T
    # For tables without pixels, the fractions are those of all pixels of the photograph.
    pairs[pairs.sum(axis=1) == 0.0] = np.bincount(index.ravel(), minlength=count)
    return np.asarray(pairs / pairs.sum(axis=1, keepdims=True))


def _stray_power(transfer: Array, power: Array, shares: Array) -> Array:
    """Return the power of light with the blur of other depths, in units of the noise, (tables, frequencies)."""
    # Expansion of the mean over neighbours of (h_neighbour - h)^2.
    difference = shares @ transfer**2 - 2.0 * transfer * (shares @ transfer) + transfer**2
    return np.asarray(_EDGE_POWER * power * np.maximum(difference, 0.0))


def _near_edges(places: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Return a map of the pixels near depth edges, where filters collect light from other depths."""
    side = 2 * max(_DISTANCES) + 1
    return np.asarray(
        scipy.ndimage.maximum_filter(places, side) - scipy.ndimage.minimum_filter(places, side) > _EDGE_STEP
    )


def _blend_at_edges(
    observed: PhotographLikelihood, light: Values, at_edges: NDArray[np.bool_], noise: list[float]
) -> Values:
    """Return `light`, blended with the photograph near depth edges where the blend explains the counts better.

    The fraction of the photograph is smaller where noise explains a part of the residual.
    """
    shape = (*observed.blur.shape, -1)
    photo = observed.image
    model = observed.model(light)
    scale = np.sqrt(observed.weight * observed.white / model)
    residual = (observed.counts - model) * scale
    # A saturated count is a lower limit: a brighter model has no residual.
    if observed.full is not None:
        residual = np.where(observed.full, np.maximum(residual, 0.0), residual)
    change = (observed.model(photo) - model) * scale

    def local(values: Values) -> Values:
        return np.asarray(scipy.ndimage.gaussian_filter(values.reshape(shape), (_LOCAL_RMS, _LOCAL_RMS, 0.0)))

    # Local least-squares fraction of the photograph: projection of the residual on the change.
    power, product, square = local(residual**2), local(residual * change), local(change**2)
    fraction = np.clip(product / np.maximum(square, 1e-30), 0.0, 1.0)
    fraction *= at_edges[..., None] * np.maximum(1.0 - np.asarray(noise) / np.maximum(power, 1e-30), 0.0)
    fraction = fraction.reshape(light.shape)
    return np.asarray(light + fraction * (photo - light), dtype=light.dtype)


def fill_unknown(plane: Values, known: NDArray[np.bool_]) -> Array:
    """Return a plane in which each unknown pixel has the value of the nearest known pixel."""
    if known.all():
        return np.asarray(plane, dtype=np.float64)
    nearest = scipy.ndimage.distance_transform_edt(~known, return_distances=False, return_indices=True)
    return np.asarray(plane[tuple(nearest)], dtype=np.float64)


def _filter_plane(tables: SharpTables, plane: Array, places: NDArray[np.float32], threads: int) -> Values:
    """Return `plane`, each pixel filtered for its depth; `places` are depths as indices of tables."""
    sides = [max(_MIN_SIDE, -(-side // _MULTIPLE) * _MULTIPLE) for side in plane.shape]
    margins = [(0, side - length) for side, length in zip(sides, plane.shape, strict=True)]
    stream = tables.stream((sides[0], sides[1]), threads or processors())
    gains = np.array([[1.0, 0.0, 0.0, 0.0, 0.0, 0.0]], dtype=np.float32)
    stream.take([np.pad(plane.astype(np.float32), margins, mode="symmetric")], gains, 0.0, math.inf, None)
    result = np.empty(sides, dtype=np.float32)
    factors = np.ascontiguousarray(tables.mixes(tables.pixel), dtype=np.float32)
    stream.mix(np.pad(places, margins, mode="edge"), 1, factors, result)
    return result[: plane.shape[0], : plane.shape[1]]
