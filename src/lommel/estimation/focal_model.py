r"""Frames of one scene that differ in focus: transfer functions, noise, and what they tell of depth.

A sensor samples a scene that is continuous. At the frequency f, in cycles per pixel, frame i is

    Y_i = h_i(f, u) X + n_i ,   h_i = OTF_i(f, u) sinc(fx) sinc(fy) ,   u = 1 / distance ,

with the transfer function of optics and pixel without its aliases: texture beyond the Nyquist frequency comes down to
f from elsewhere, and is as noise. Over the variance of a pixel's noise in the first frame it has the power

    N_i(f, u) = nu_i + sum over k != 0 of S(f - k) h_i(f - k, u)^2 ,

S being the power of the texture and nu_i the variance of frame i, over the same. The information of a pixel about u,
of Gaussian textures (Whittle 1953, doi:10.1007/BF02590998), with h over the root of N, is

    J = mean over f of [ 2 S^2 (h.h')^2 / (1 + S h.h)^2  +  S^2 h.h h'_^2 / (1 + S h.h) ] ,

where ``h'_^2 = h'.h' - (h.h')^2 / h.h`` is the part of the derivative orthogonal to h. The second term compares
frames and needs no knowledge of S; the first compares the blur of each with a known S.

The transfer function of a defocused circular pupil: H. H. Hopkins 1955, doi:10.1098/rspa.1955.0158.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Self

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.measures.transfer import otf
from lommel.optics.lens import Lens

Spectrum = Sequence[tuple[float, float]]  # wavelengths in metres, and weights
# A lens, vergences, a spectrum and a pitch in metres, to transfer functions of |f| in cycles per pixel.
Transfer = Callable[[Lens, Array, Spectrum, float], Callable[[Array], Array]]

LARGEST = 128.0
"""Pixels: the largest structures of the texture whose contrast is given; those of 2 pixels are the smallest."""

_FARTHEST = 1.5 * math.sqrt(2.0)  # cycles per pixel: largest frequency of aliases next to the band
_STEP = 0.25  # radians by which the overlap of the pupils turns between nodes of a transfer function
_LEAST_NODES, _MOST_NODES = 160, 20_000
_TOL = 1e-7


@dataclass(frozen=True)
class Band:
    """Frequencies of pixel images, up to half a cycle a pixel: an octant, with the share of each in the plane."""

    fx: Array
    fy: Array
    share: Array

    @classmethod
    def of(cls, count: int) -> Self:
        """Return the middles of `count` intervals along either axis, and first frequency 0, whose share is 0."""
        axis = 0.5 * (np.arange(count) + 0.5) / count
        i, j = np.triu_indices(count)
        # Frequencies off the diagonal stand for two of the quadrant.
        share = np.where(i == j, 1.0, 2.0) / count**2
        return cls(np.append(0.0, axis[i]), np.append(0.0, axis[j]), np.append(0.0, share))

    def places(self) -> NDArray[np.intp]:
        """Return the indices of frequencies whose values are at the interval midpoints of the quadrant."""
        # The octant has n (n + 1) / 2 frequencies and one more: solved for n.
        count = round(math.sqrt(2.0 * len(self.fx) - 1.75) - 0.5)
        whole = np.zeros((count, count), dtype=np.intp)
        upper = np.triu_indices(count)
        whole[upper] = whole.T[upper] = 1 + np.arange(len(upper[0]))
        return whole


def texture_power(f: Array, contrast: float) -> Array:
    """Return the power of a texture of mean 1, falling as the inverse square of f in cycles per pixel.

    Its structures of 2 to 128 pixels have the rms `contrast`; beyond these it is constant.
    """
    # The integral of the power over the ring from 1 / 128 to 1 / 2 cycles a pixel is contrast^2.
    scale = contrast**2 / (2.0 * math.pi * math.log(0.5 * LARGEST))
    return np.asarray(scale / np.maximum(f, 1.0 / LARGEST) ** 2)


@dataclass(frozen=True)
class FocalLight:
    """Mean light of a frame and its noise: electrons of a pixel, rms read noise, and relative exposures."""

    mean: float
    read: float
    exposures: tuple[float, ...]
    contrast: float

    def binned(self, pixels: int) -> Self:
        """Return the light of squares of `pixels` a side."""
        # Sums of n pixels have n times the light, and sqrt(n) times the rms noise of reading.
        return type(self)(self.mean * pixels**2, self.read * pixels, self.exposures, self.contrast)

    @property
    def variance(self) -> float:
        """Variance of a pixel in a frame of exposure 1."""
        return self.mean + self.read**2

    def relative(self) -> Array:
        """Return the variance of each frame, divided by its exposure, over that of a frame of exposure 1."""
        e = np.asarray(self.exposures)
        # A frame of exposure e is divided by e, its variance by e^2.
        return np.asarray((self.mean * e + self.read**2) / e**2 / self.variance)

    def power(self, f: Array) -> Array:
        """Return the power of the texture over the variance, at f in cycles per pixel."""
        return texture_power(f, self.contrast) * (self.mean**2 / self.variance)


@dataclass(frozen=True)
class FocalModel:
    """Transfer functions, texture and noise of frames for each of several vergences, at the frequencies of a band.

    `transfer` and `noise` have the shape (vergences, frames, frequencies); `texture`, (frequencies,), and `noise` are
    over the variance of a pixel of a frame of exposure 1, of which `white`, (frames,), is the part of electrons.
    `folded` is the power that the aliases of a frame and of the pixel-averaged scene have in common; its last index
    of frames stands for that scene itself: shape (vergences, frames + 1, frequencies).
    """

    vergence: Array
    band: Band
    texture: Array
    transfer: Array
    noise: Array
    white: Array
    folded: Array

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
        """Return the model of squares of `binning` pixels a side, of a pitch in metres.

        Frames may have been resampled about their middle: `scales` are the pitches, in pixels, that they have since.
        """
        band, binned = Band.of(count), light.binned(binning)
        fx, fy = band.fx, band.fy
        pitches = scales or (1.0,) * len(lenses)
        curves = [
            (transfer or transfer_curve)(lens, vergence, spectrum, binning * pixel * pitch)
            for lens, pitch in zip(lenses, pitches, strict=True)
        ]

        def transfers(x: Array, y: Array) -> Array:
            f, seen = np.hypot(x, y), zip(curves, pitches, strict=True)
            return np.stack([curve(f) * (np.sinc(x / pitch) * np.sinc(y / pitch)) for curve, pitch in seen], axis=1)

        def power(x: Array, y: Array) -> Array:
            # Squares have the variance of as many pixels, and textures of the power that these have.
            return light.power(np.hypot(x, y) / binning)

        white = binned.relative()
        noise = np.broadcast_to(white[:, None], (len(vergence), len(lenses), fx.size)).copy()
        folded = np.zeros((len(vergence), len(lenses) + 1, fx.size))
        # The eight copies of the band next to it; texture beyond falls as the inverse square of the frequency.
        for across, down in product((-1.0, 0.0, 1.0), repeat=2):
            if across or down:
                x, y = fx - across, fy - down
                seen, pixel_alone, strength = transfers(x, y), np.sinc(x) * np.sinc(y), power(x, y)
                noise += strength * seen**2
                folded[:, :-1] += strength * pixel_alone * seen
                folded[:, -1] += strength * pixel_alone**2
        return cls(np.asarray(vergence), band, power(fx, fy), transfers(fx, fy), noise, white, folded)

    def at(self, places: slice) -> Self:
        """Return the model of some of the vergences."""
        parts = {name: getattr(self, name)[places] for name in ("vergence", "transfer", "noise", "folded")}
        return replace(self, **parts)

    def uncertain(self, errors: Array) -> Self:
        """Return the model of frames of which depth is known within a standard error, in candidates, (vergences,).

        Transfer functions are means over it, and how far they differ from these is noise.
        """
        places = np.arange(len(self.vergence))
        away = (places - places[:, None]) / np.maximum(errors, 1e-3)[:, None]
        share = np.exp(-0.5 * away**2)
        share /= share.sum(axis=1, keepdims=True)

        def mean(values: Array) -> Array:
            return np.asarray(np.einsum("cd,dif->cif", share, values, optimize=True))

        transfer = mean(self.transfer)
        spread = np.maximum(mean(self.transfer**2) - transfer**2, 0.0)
        noise = mean(self.noise) + self.texture * spread
        return replace(self, transfer=transfer, noise=noise, folded=mean(self.folded))

    def signal(self) -> Array:
        """Return ``h.h`` over the noise, (vergences, frequencies)."""
        return np.asarray((self.transfer**2 / self.noise).sum(axis=1))

    def information(self, slope: Array) -> Array:
        """Return J of each vergence, from the derivatives of `transfer` by vergence."""
        root = np.sqrt(self.noise)
        h, d = self.transfer / root, slope / root
        hh, along, whole = (h * h).sum(axis=1), (h * d).sum(axis=1), (d * d).sum(axis=1)
        # The part of the slope orthogonal to h; rounding may make it negative.
        across = np.maximum(whole - along**2 / np.maximum(hh, 1e-300), 0.0)
        # The second term of J alone: it needs no known power of the texture.
        signal = 1.0 + self.texture * hh
        return np.asarray((self.texture**2 * hh * across / signal) @ self.band.share)


def transfer_curve(lens: Lens, vergence: Array, spectrum: Spectrum, pixel: float) -> Callable[[Array], Array]:
    """Return the OTF of a lens at each vergence as a function of frequency, cycles per pixel, without the pixel.

    The function takes an array of frequencies, up to 2.1, and returns one of shape (vergences,) and theirs.
    """
    from scipy.interpolate import CubicSpline

    with np.errstate(divide="ignore"):
        pupil = lens.pupil(1.0 / np.asarray(vergence))
    total = sum(weight for _, weight in spectrum)
    parts = []
    for wavelength, weight in spectrum:
        there = pupil.in_light(wavelength)
        cutoff = pixel / there.scale
        end = min(cutoff, _FARTHEST)
        # Points of the overlap of two pupils see phases that differ by up to the slope of the wavefront times the
        # shift.
        swing = 4.0 * math.pi * float(there.geometric_radius().max()) / pixel * end
        if not swing / _STEP <= _MOST_NODES:
            raise ValueError(
                f"distance: light is spread over {float(there.geometric_radius().max()) / pixel:.4g} pixels, too "
                "many for depth from defocus: stop down, take larger pixels, or distances nearer to the focus"
            )
        nodes = np.linspace(0.0, end, max(_LEAST_NODES, math.ceil(swing / _STEP)))
        values = otf(there, nodes / pixel, tol=_TOL).real
        parts.append((end, CubicSpline(nodes, values, axis=1), weight / total))

    def curve(f: Array) -> Array:
        """Return the sum of cubic splines up to a cut-off, 0 beyond."""
        each = (weight * np.where(f < end, spline(np.minimum(f, end)), 0.0) for end, spline, weight in parts)
        return sum(each, np.zeros((len(vergence), *f.shape)))

    return curve
