r"""Frames of one scene that differ in focus: transfer functions, noise, and Fisher information about depth.

At the frequency f, in cycles per pixel, and the vergence u = 1 / distance, frame i of a scene X is

    Y_i = h_i(f, u) X + n_i ,   h_i = OTF_i(f, u) sinc(fx) sinc(fy) ,

where h_i is the transfer function of optics and pixel. The noise n_i includes aliases: texture beyond the Nyquist
frequency that appears at f because the sensor samples the image. The power of n_i is

    N_i(f, u) = nu_i + sum over k != 0 of S(f - k) h_i(f - k, u)^2 ,

where S is the power of the texture and nu_i the variance of a pixel in frame i. All of these are divided by the
variance of a pixel in a frame of relative exposure 1. For Gaussian textures (Whittle 1953, doi:10.1007/BF02590998),
the information of a pixel about u is

    J = mean over f of [ 2 S^2 (g.g')^2 / (1 + S g.g)^2  +  S^2 g.g q / (1 + S g.g) ] ,   g_i = h_i / sqrt(N_i) ,

where ``g'_i = (dh_i / du) / sqrt(N_i)``, dots are sums over frames, and ``q = g'.g' - (g.g')^2 / g.g`` is the squared
length of the part of g' orthogonal to g. The first term compares the blur of the frames with a known S. The second
term compares the frames with each other: its estimate of u does not require S.

The transfer function of a defocused circular pupil: H. H. Hopkins 1955, doi:10.1098/rspa.1955.0158.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Self

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.measures.transfer import otf
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil

Spectrum = Sequence[tuple[float, float]]  # wavelengths in metres, and weights
# Function of a lens, vergences, a spectrum and a pixel pitch (metres), such as `transfer_curve`. It returns the OTF
# as a function of the absolute value of the frequency, in cycles per pixel.
Transfer = Callable[[Lens, Array, Spectrum, float], Callable[[Array], Array]]

LARGEST = 128.0
"""Largest period of the structures whose rms is the contrast of a texture, pixels; the smallest is 2 pixels."""

_MAX_FREQUENCY = 1.5 * math.sqrt(2.0)  # cycles per pixel: largest frequency of the aliases that are computed
_STEP = 0.25  # radians: largest phase change of the OTF integrand between interpolation nodes of the OTF
_MIN_NODES, _MAX_NODES = 160, 20_000  # number of interpolation nodes of the OTF
_TOL = 1e-7


@dataclass(frozen=True)
class Band:
    """Frequencies up to half a cycle per pixel in the octant 0 <= fx <= fy.

    `share` is the weight of each frequency in a mean over all frequencies of the sensor; the weights sum to 1.
    """

    fx: Array
    fy: Array
    share: Array

    @classmethod
    def of(cls, count: int) -> Self:
        """Return the frequency 0 with weight 0, followed by the midpoints of `count` intervals along each axis."""
        axis = 0.5 * (np.arange(count) + 0.5) / count
        i, j = np.triu_indices(count)
        # A frequency off the diagonal represents two frequencies of the quadrant, which are mirror images.
        share = np.where(i == j, 1.0, 2.0) / count**2
        return cls(np.append(0.0, axis[i]), np.append(0.0, axis[j]), np.append(0.0, share))

    def places(self) -> NDArray[np.intp]:
        """Return the index of the frequency for each midpoint of the quadrant, shape (count, count)."""
        # n intervals give n (n + 1) / 2 + 1 frequencies, solved for n.
        count = round(math.sqrt(2.0 * len(self.fx) - 1.75) - 0.5)
        indices = np.zeros((count, count), dtype=np.intp)
        upper = np.triu_indices(count)
        indices[upper] = indices.T[upper] = 1 + np.arange(len(upper[0]))
        return indices


def texture_power(f: Array, contrast: float) -> Array:
    """Return the power spectrum, at f in cycles per pixel, of a texture of mean 1 and rms `contrast`.

    The rms includes periods of 2 to 128 pixels (`LARGEST`). The power is proportional to 1 / f^2, and constant for
    periods above 128 pixels.
    """
    # The integral of the power over the frequencies from 1 / 128 to 1 / 2 cycles per pixel is contrast^2.
    scale = contrast**2 / (2.0 * math.pi * math.log(0.5 * LARGEST))
    return np.asarray(scale / np.maximum(f, 1.0 / LARGEST) ** 2)


@dataclass(frozen=True)
class FocalLight:
    """Mean electrons per pixel in a frame of exposure 1, rms read noise, relative exposures and texture contrast."""

    mean: float
    read: float
    exposures: tuple[float, ...]
    contrast: float

    def binned(self, pixels: int) -> Self:
        """Return the light of sums over squares of `pixels` by `pixels`."""
        # The sum of n pixels has n times the light, and sqrt(n) times the rms read noise.
        return type(self)(self.mean * pixels**2, self.read * pixels, self.exposures, self.contrast)

    @property
    def variance(self) -> float:
        """Variance of a pixel in a frame of exposure 1."""
        return self.mean + self.read**2

    def relative_variances(self) -> Array:
        """Return the variance of a pixel of each frame relative to that of a frame of exposure 1.

        Each frame is first divided by its exposure e, and so its variance by e^2.
        """
        e = np.asarray(self.exposures)
        return np.asarray((self.mean * e + self.read**2) / e**2 / self.variance)

    def power(self, f: Array) -> Array:
        """Return the power of the texture divided by the variance of a pixel, at f in cycles per pixel."""
        return texture_power(f, self.contrast) * (self.mean**2 / self.variance)


@dataclass(frozen=True)
class FocalModel:
    """Transfer functions, texture and noise of frames for each of several vergences, at the frequencies of a band.

    `transfer` (h) and `noise` (N) have the shape (vergences, frames, frequencies), `texture` (S) has the shape
    (frequencies,), and `white` (nu) has the shape (frames,). Powers are divided by the variance of a pixel in a frame
    of exposure 1. `alias_power`, shape (vergences, frames + 1, frequencies), is the cross power of the aliases of a
    frame and of the sharp scene averaged over pixels; the last of the frames + 1 values is the power of the aliases
    of that scene.
    """

    vergence: Array
    band: Band
    texture: Array
    transfer: Array
    noise: Array
    white: Array
    alias_power: Array

    @classmethod
    def of(
        cls,
        lenses: Sequence[Lens],
        vergence: Array,
        spectrum: Spectrum,
        pixel: float,
        light: FocalLight,
        *,
        transfer: Transfer | None = None,
        binning: int = 1,
        count: int = 48,
        scales: Sequence[float] = (),
    ) -> Self:
        """Return the model of frames of a pixel pitch (metres) that are binned in squares of `binning` x `binning`.

        If the frames were resampled about their centres, `scales` are their sample pitches, in pixels of the sensor.
        """
        band, binned = Band.of(count), light.binned(binning)
        fx, fy = band.fx, band.fy
        pitches = scales or (1.0,) * len(lenses)
        curves = [
            (transfer or transfer_curve)(lens, vergence, spectrum, binning * pixel * pitch)
            for lens, pitch in zip(lenses, pitches, strict=True)
        ]

        def transfers(x: Array, y: Array) -> Array:
            f, frames = np.hypot(x, y), zip(curves, pitches, strict=True)
            return np.stack([curve(f) * (np.sinc(x / pitch) * np.sinc(y / pitch)) for curve, pitch in frames], axis=1)

        def power(x: Array, y: Array) -> Array:
            # At a given frequency, binning does not change the ratio of texture power and noise variance.
            return light.power(np.hypot(x, y) / binning)

        white = binned.relative_variances()
        noise = np.broadcast_to(white[:, None], (len(vergence), len(lenses), fx.size)).copy()
        alias_power = np.zeros((len(vergence), len(lenses) + 1, fx.size))
        # Aliases from the eight adjacent bands; texture of higher frequencies is weak, by 1 / f^2, and neglected.
        for across, down in product((-1.0, 0.0, 1.0), repeat=2):
            if across or down:
                x, y = fx - across, fy - down
                h, pixel_transfer, strength = transfers(x, y), np.sinc(x) * np.sinc(y), power(x, y)
                noise += strength * h**2
                alias_power[:, :-1] += strength * pixel_transfer * h
                alias_power[:, -1] += strength * pixel_transfer**2
        return cls(np.asarray(vergence), band, power(fx, fy), transfers(fx, fy), noise, white, alias_power)

    def at(self, places: slice) -> Self:
        """Return the model for the vergences at the indices `places`."""
        parts = {name: getattr(self, name)[places] for name in ("vergence", "transfer", "noise", "alias_power")}
        return replace(self, **parts)

    def uncertain(self, errors: Array) -> Self:
        """Return the model of frames whose depth has standard errors, in steps of `vergence`, shape (vergences,).

        Transfer functions are averaged over normal distributions of these widths; their variance is added to the
        noise.
        """
        places = np.arange(len(self.vergence))
        sigmas = (places - places[:, None]) / np.maximum(errors, 1e-3)[:, None]
        weight = np.exp(-0.5 * sigmas**2)
        weight /= weight.sum(axis=1, keepdims=True)

        def mean(values: Array) -> Array:
            return np.asarray(np.einsum("cd,dif->cif", weight, values, optimize=True))

        transfer = mean(self.transfer)
        variance = np.maximum(mean(self.transfer**2) - transfer**2, 0.0)
        noise = mean(self.noise) + self.texture * variance
        return replace(self, transfer=transfer, noise=noise, alias_power=mean(self.alias_power))

    def signal(self) -> Array:
        """Return ``g.g``, the sum over frames of ``h^2 / N``, shape (vergences, frequencies)."""
        return np.asarray((self.transfer**2 / self.noise).sum(axis=1))

    def information(self, slope: Array) -> Array:
        """Return the second term of J for each vergence, given the derivatives of `transfer` by vergence.

        The first term is left out because the power of the texture is assumed to be unknown.
        """
        root = np.sqrt(self.noise)
        g, d = self.transfer / root, slope / root
        gg, gd, dd = (g * g).sum(axis=1), (g * d).sum(axis=1), (d * d).sum(axis=1)
        q = np.maximum(dd - gd**2 / np.maximum(gg, 1e-300), 0.0)  # rounding may make it negative
        return np.asarray((self.texture**2 * gg * q / (1.0 + self.texture * gg)) @ self.band.share)


def transfer_curve(lens: Lens, vergence: Array, spectrum: Spectrum, pixel: float) -> Callable[[Array], Array]:
    """Return the OTF of a lens (without pixel area) at each vergence, as a function of frequency in cycles per pixel.

    The argument of the function is an array of frequencies up to `_MAX_FREQUENCY`. The result has the shape
    (vergences,) followed by the shape of this array.
    """
    with np.errstate(divide="ignore"):
        return pupil_curve(lens.pupil(1.0 / np.asarray(vergence)), spectrum, pixel)


def pupil_curve(pupil: Pupil, spectrum: Spectrum, pixel: float) -> Callable[[Array], Array]:
    """Return the OTF of a stack of pupils (without pixel area); see `transfer_curve`, which does so for a lens."""
    total = sum(weight for _, weight in spectrum)
    parts = []
    for wavelength, weight in spectrum:
        coloured = pupil.in_light(wavelength)
        cutoff = pixel / coloured.scale
        end = min(cutoff, _MAX_FREQUENCY)
        # The OTF integrates the phase difference of two shifted pupils, at most the shift times the wavefront slope.
        radius = float(coloured.geometric_radius().max())
        phase_change = 4.0 * math.pi * radius / pixel * end
        if not phase_change / _STEP <= _MAX_NODES:
            raise ValueError(
                f"distance: the blur has a radius of {radius / pixel:.4g} pixels, too large for depth from defocus: "
                "stop down, bin pixels, or choose distances nearer to the focus"
            )
        nodes = np.linspace(0.0, end, max(_MIN_NODES, math.ceil(phase_change / _STEP)))
        values = otf(coloured, nodes / pixel, tol=_TOL).real
        parts.append((end, scipy.interpolate.CubicSpline(nodes, values, axis=1), weight / total))

    def curve(f: Array) -> Array:
        """Return the weighted sum of the splines of all wavelengths, each 0 beyond its last node."""
        terms = (weight * np.where(f < end, spline(np.minimum(f, end)), 0.0) for end, spline, weight in parts)
        return sum(terms, np.zeros((*pupil.shape, *f.shape)))

    return curve
