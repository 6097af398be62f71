"""Straight motion during the exposure: its likelihood by the power spectrum in sectors of directions.

A motion by L pixels along a unit vector u has the transfer function sinc(L f.u), whose zeros are parallel lines;
those of defocus are rings. Scenes have directions, too: each sector of frequencies therefore has a texture
``c f^-s`` of its own, and scenes may be softer in one direction than across it. Scenes of few directions, such as
stripes, have their light in few sectors: those in which motion gains most do not count.

Scenes of equal rectangles have parallel zeros, too. A step of the light along the motion to the next pixel is,
however, at most 1 / L of the range of the scene, which is about that of the photograph. Where such a scene was moved,
both have zeros: a second motion then explains them, too, and neither is told.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.fit.findings import Findings
from lommel.imaging.blur_spectrum import FREQUENCIES, SOFT, BlurSpectrum
from lommel.imaging.measured_blur import MeasuredBlur
from lommel.measures.measured_psf import MeasuredPSF

_SECTORS, _UNCOUNTED = 24, 4  # sectors of half a turn; those of the largest gains, which do not count
_WIDTH = math.pi / _SECTORS
_LENGTHS = np.geomspace(3.5, 30.0, 16)  # pixels
_LARGEST = 0.25  # largest of them / shorter side of the photograph
_FINER, _TURNS = np.linspace(0.92, 1.08, 5), np.linspace(-0.5, 0.5, 3)  # around the best: factors, and sectors
_INSIDE = (np.arange(9) - 4.0) / 9.0  # directions within a sector, over its width
_SOFT_MOVED = 5  # widths of scenes behind motion
_MOST_MORE = 3.0  # pixels: largest width along one direction beyond that across it
# Frequencies, cycles per pixel, between which power is compared, and ln of its ratio that motion exceeds.
_BANDS, _DIRECTED = (0.12, 0.18, 0.26), 2.0
_SEARCHED = 40.0  # gain in log-likelihood by few sectors from which motion is searched
_POINTS = 4096  # along a motion, of its PSF
# Gains in log-likelihood, over soft scenes and over blurs, from which a photograph was moved; that over blurs from
# which no other blur is known.
_MIN_GAIN, _MIN_OVER, _DOUBTED = 15.0, 60.0, 10.0
# Limits of the range of a photograph, quantile of its steps, and their largest ratio times the length of a motion; it
# was at most 1.5 in photographs that were moved.
_RANGE, _STEPS, _STEEPEST = (1e-3, 0.999), 0.99, 1.8
_STEP_NOISE = 3.6  # that quantile of steps by noise, over the rms noise of a pixel
_MOST_SECOND = 25.0  # largest gain of a second motion of a photograph that was moved
_SHORTEST, _LONGEST = 1.05 * _LENGTHS[0], 0.9 * _LENGTHS[-1]


class Motion(NamedTuple):
    """The most likely motion: length (pixels), angle (radians, from rows towards lower ones), and its gains.

    `gain` is that in log-likelihood over other blurs of soft scenes, `over_blurs` that over other blurs alone. A
    photograph is `steep` if it has larger steps along the motion than that leaves. `second` is the gain of another
    motion beside this one.
    """

    length: float
    angle: float
    gain: float
    over_blurs: float
    steep: bool = False
    second: float = 0.0

    @property
    def words(self) -> str:
        """Length and angle in words, as seen."""
        angle = round(180.0 - math.degrees(self.angle)) % 180
        return (
            f"a straight motion by about {self.length:.2g} pixels at {angle} degrees to the rows, counter-clockwise"
        )

    def blur(self, shape: tuple[int, int], channels: int) -> MeasuredBlur:
        """Return the blur of an image by this motion."""
        half = math.ceil(0.5 * self.length) + 1
        along = ((np.arange(_POINTS) + 0.5) / _POINTS - 0.5) * self.length
        places = (
            np.rint(along * part).astype(np.intp) + half for part in (math.sin(self.angle), math.cos(self.angle))
        )
        values = np.zeros((1, 2 * half + 1, 2 * half + 1))
        np.add.at(values[0], tuple(places), 1.0 / _POINTS)
        return MeasuredBlur(shape, [MeasuredPSF(values, 1.0, 1.0, 1, Findings([]))] * channels)

    @property
    def likely(self) -> bool:
        """True if the photograph agrees better with motion than with any other blur."""
        gains = self.gain > _MIN_GAIN or self.over_blurs > _MIN_OVER
        alone = not self.steep and self.second <= _MOST_SECOND
        return gains and _SHORTEST < self.length < _LONGEST and alone

    @property
    def possible(self) -> bool:
        """True if no other blur is known, since motion explains the photograph better."""
        return self.over_blurs > _DOUBTED


def likely_motion(curves: Array, plane: Array, variance: Array) -> Motion | None:
    """Return the likeliest motion if a photograph was moved; only where its power depends on direction."""
    sectors = BlurSpectrum.sectors(plane, variance, _SECTORS // 2)
    powers = np.log([sector.mean_powers(_BANDS) for sector in sectors])
    if not np.ptp(powers, axis=0).max() > _DIRECTED:
        return None
    # A search by few sectors, lengths and exponents takes little time.
    still = BlurSpectrum.of_parts(sectors, curves, 3)[0].sum(axis=0).max()
    if not _turned(sectors, _lengths(plane)[::2], 3).max() > still + _SEARCHED:
        return None
    motion = likeliest_motion(curves, plane, variance)
    return motion if motion.likely else None


def likeliest_motion(curves: Array, plane: Array, variance: Array) -> Motion:
    """Return the likeliest motion, and its gain over blurs with transfer `curves` (blurs, frequencies).

    `variance` is that of the noise of each pixel of the `plane`.
    """
    sectors = BlurSpectrum.sectors(plane, variance, _SECTORS)
    falls = np.exp(-0.5 * np.square(2.0 * np.pi * SOFT[:, None, None] * FREQUENCIES))
    shapes = np.concatenate([curves[None], curves * falls])
    others, scatter = BlurSpectrum.of_parts(sectors, shapes.reshape(-1, len(FREQUENCIES)))
    others = others.reshape(_SECTORS, len(shapes), -1)
    few = [1.0, *falls[:_SOFT_MOVED, 0]]
    moved, scatters, length, angles = _searched(sectors, _lengths(plane), few, [1.0] * _SECTORS)
    total = moved.sum(axis=0).reshape(-1, len(length), len(angles))
    best = int(total.argmax())
    soft, *place = np.unravel_index(best, total.shape)
    sides = total[soft, :, place[1]], total[soft, place[0]]
    moved_by, turned = (
        float(np.interp(i + _vertex(side, int(i)), np.arange(len(x)), x))
        for i, side, x in zip(place, sides, (length, angles), strict=True)
    )
    scale = np.maximum(np.minimum(scatter, scatters), 1.0)
    gains = []
    for rival in (_directed(others), others[:, 0]):
        each = (moved[:, best] - rival[:, int(rival.sum(axis=0).argmax())]) / scale
        gains.append(float(np.sort(each)[: _SECTORS - _UNCOUNTED].sum()))
    motion = Motion(moved_by, turned % math.pi, gains[0], gains[1], _steep(plane, variance, moved_by, turned))
    if not motion.likely:
        return motion
    first = [
        few[soft] * _curves(length[place[0]], np.array([(j + 0.5) * _WIDTH - angles[place[1]]]))
        for j in range(_SECTORS)
    ]
    found, _, length, angles = _searched(sectors, _lengths(plane), [1.0], first)
    both = found.sum(axis=0).reshape(len(length), -1)
    at, turn = np.unravel_index(int(both.argmax()), both.shape)
    if _steep(plane, variance, float(length[at]), float(angles[turn])):
        return motion
    return motion._replace(second=float((both.max() - total.max()) / scale.mean()))


def _searched(
    sectors: list[BlurSpectrum], lengths: Array, falls: Sequence[Array | float], first: Sequence[Array | float]
) -> tuple[Array, Array, Array, Array]:
    """Return the log-likelihood of motions around the likeliest one in each sector, which has a `first` blur besides.

    Its axis of motions has each of the `falls`, lengths and angles. Dispersions, lengths and angles follow.
    """
    coarse = _turned(sectors, lengths, first=first)
    at, turn = np.unravel_index(int(coarse.argmax()), coarse.shape)
    length, angles = lengths[at] * _FINER, (turn + 0.5 + _TURNS) * _WIDTH
    found, scatters = zip(
        *(
            BlurSpectrum.of_parts([x], np.concatenate([fall * h * c for fall in falls]))
            for j, (x, h) in enumerate(zip(sectors, first, strict=True))
            for c in [_curves(length[:, None], (j + 0.5) * _WIDTH - angles)]
        ),
        strict=True,
    )
    return np.concatenate(found), np.concatenate(scatters), length, angles


def _steep(plane: Array, variance: Array, length: float, angle: float) -> bool:
    """Return True if a plane has larger steps to the next pixel along a direction than a motion along it leaves."""
    beside = scipy.ndimage.shift(plane, (-math.sin(angle), -math.cos(angle)), order=1, mode="nearest")
    low, high = np.quantile(plane, _RANGE)
    step = float(np.quantile(np.abs(beside - plane), _STEPS))
    noise = _STEP_NOISE * math.sqrt(float(variance.mean()))
    return step > math.hypot(_STEEPEST * float(high - low) / length, noise)


def _lengths(plane: Array) -> Array:
    return _LENGTHS[: max(int(np.count_nonzero(_LARGEST * min(plane.shape) >= _LENGTHS)), 1)]


def _turned(
    sectors: list[BlurSpectrum], lengths: Array, every: int = 1, first: Sequence[Array | float] = (1.0,)
) -> Array:
    """Return the log-likelihood of motions along the middle of each sector, (lengths, sectors).

    With `first` each sector has a blur of its own besides.
    """
    number = len(sectors)
    turns = math.pi / number * np.arange(number // 2 + 1, dtype=np.float64)
    curves = _curves(lengths[:, None], turns, math.pi / number)
    if np.ndim(first[0]):
        pairs = zip(sectors, first, strict=True)
        found = np.concatenate([BlurSpectrum.of_parts([x], h * curves, every)[0] for x, h in pairs])
    else:
        found, _ = BlurSpectrum.of_parts(sectors, curves, every)
    k = np.arange(number)
    apart = np.abs((k[:, None] - k + number // 2) % number - number // 2)
    return np.asarray(np.sum([x.reshape(-1, len(turns))[:, apart[j]] for j, x in enumerate(found)], axis=0))


def _vertex(values: Array, at: int) -> float:
    """Return how far the summit of a parabola lies from the highest of equidistant values."""
    if not 0 < at < len(values) - 1:
        return 0.0
    low, middle, high = values[at - 1 : at + 2]
    return 0.5 * float((low - high) / min(low - 2.0 * middle + high, -1e-12))


def _directed(likelihood: Array) -> Array:
    """Return the log-likelihood, (sectors, blurs), of scenes that are softer in one direction than across it.

    `likelihood` has that of each width of a Gaussian, the first of which is 0, (sectors, widths, blurs).
    """
    widths, turns = np.append(0.0, SOFT), np.arange(_SECTORS) * _WIDTH
    along = np.square(np.cos(turns[:, None] - turns))  # directions of the scene, sectors
    across, more, _ = (x.ravel() for x in np.meshgrid(widths, widths[widths <= _MOST_MORE], turns, indexing="ij"))
    along = np.tile(along, (len(across) // _SECTORS, 1))
    width = np.minimum(np.sqrt(across[:, None] ** 2 + more[:, None] ** 2 * along), widths[-1])
    place = np.interp(width, widths, np.arange(len(widths)))
    low = np.minimum(place.astype(np.intp), len(widths) - 2)
    part, k = (place - low)[..., None], np.arange(_SECTORS)
    found = (1.0 - part) * likelihood[k, low] + part * likelihood[k, low + 1]
    best = found.sum(axis=1).argmax(axis=0)
    return np.asarray(np.take_along_axis(found, best[None, None], 0)[0])


def _curves(length: Array, turn: Array, width: float = _WIDTH) -> Array:
    """Return the rms transfer functions of motions in sectors at an angle, (lengths times turns, frequencies)."""
    means = np.mean(
        [np.square(np.sinc((length * np.cos(turn + x * width))[..., None] * FREQUENCIES)) for x in _INSIDE], axis=0
    )
    return np.asarray(np.sqrt(means).reshape(-1, len(FREQUENCIES)))
