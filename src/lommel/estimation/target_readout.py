r"""Pixel values of pinholes and of crossings of a checkerboard from samples of PSFs, and slopes by blur and angles.

An image is the object convolved with the PSF, the pixel and a mixture of Gaussians. The intensity of a PSF holds no
frequency above 1 / (lambda*N): from samples ``h < 1/2`` apart (units of lambda*N) sums over samples are the
convolution, and frequencies of the object above 1 are of no account. The spectrum of a disc is known. The corners of
a checkerboard are sampled after a narrow Gaussian, which is then divided out: with lines at
``p = x cos a + y sin a = 0`` and ``q = 0`` likewise,

.. math:: \mathrm{E}[\mathrm{sgn}(p + \nu_p)\, \mathrm{sgn}(q + \nu_q)]
          = \mathrm{erf}\,\mathrm{erf} + 4 \rho\, \varphi\varphi + 2 \rho^2\, pq\, \varphi\varphi + O(\rho^3),

where :math:`\rho` is the cosine of the angle between the normals of the lines, near 0, and further lines a square
apart alternate in sign.

Uneven light on a chart is a smooth function of the position, from the white squares of all windows.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import fft, ndimage, special

from lommel.base.arrays import Array, Values
from lommel.base.threads import side_by_side
from lommel.blur.mixtures import Shape
from lommel.estimation.field_signs import highest_degree, monomials

_STEP = 0.45  # largest distance of samples, lambda*N
_FINE = 0.285  # largest distance of samples of objects, lambda*N
_MARGIN = 8.0  # lambda*N of samples of PSFs beyond the outer pixels
_PAD = 5.0  # lambda*N in which what the transforms cut off at their edge fades
_ALIAS = 12.0  # minus the logarithm of the Gaussian where copies of the spectrum begin
_APART = 12.0  # standard deviations of the Gaussian: lines farther apart are separate
_FLAT = 6.5  # standard deviations from an edge beyond which it is flat
_ENDLESS = 1e30  # lambda*N: side of the squares of a single crossing
_TURNS = 90  # directions, over half a turn, in which a crossing is searched
_LIGHT_DEGREE, _LIGHT_TURNS = 4, 10  # of the polynomial of uneven light, and iterations of its fit
_BLURRED = 2  # pixels beside lines that are left out
_LEAST = 10  # least number of white pixels of a window


class Target(NamedTuple):
    """A kind of object, and its size in pixels: diameter of pinholes, side of squares (inf: one crossing alone)."""

    kind: str
    size: float

    @property
    def angles(self) -> int:
        """Number of unknown angles."""
        return 2 if self.kind == "crossing" else 0


class TargetReadout:
    """From samples of PSFs on a lattice to the pixels of a window, for objects around its middle pixel.

    `pixel` is in lambda*N; pixels that do not `integrate` are points.
    """

    widest = math.inf  # pixels of blur

    def __init__(
        self, window: tuple[int, int], pixel: float, target: Target, shape: Shape, *, integrate: bool
    ) -> None:
        self.pixel, self.target, self._pixels, self.blur = pixel, target, window, shape
        self._every = math.ceil(pixel / _STEP)
        self.step = pixel / self._every
        halves = [math.ceil(((side // 2) * pixel + _MARGIN) / self.step) for side in window]
        self.shape = (2 * halves[0] + 1, 2 * halves[1] + 1)
        pad = 2 * math.ceil(_PAD / self.step)
        self._sides = [
            fft.next_fast_len(side * self._every + samples + pad, real=True)
            for side, samples in zip(window, self.shape, strict=True)
        ]
        f_row = fft.fftfreq(self._sides[0], self.step)[:, None]
        f_column = fft.rfftfreq(self._sides[1], self.step)[None]
        square = f_row**2 + f_column**2
        inside = square <= 1.1
        # Single precision: images err by 1e-6 of the peak, noise is a thousand times that.
        self._rate: Values = np.float32(-2.0 * (math.pi * pixel) ** 2) * square.astype(np.float32)
        area = np.sinc(pixel * f_row) * np.sinc(pixel * f_column) if integrate else np.ones(square.shape)
        # Sample 0 of a PSF is its corner, the middle of the first pixel is half a window before the axis.
        corner = [half - (side // 2) * self._every for half, side in zip(halves, window, strict=True)]
        turned = np.exp(2j * math.pi * self.step * (f_row * corner[0] + f_column * corner[1]))
        plain = inside * area * turned
        if target.kind == "pinhole":
            reach = math.pi * target.size * pixel * np.sqrt(square)
            # The spectrum of a uniform disc: 2 J1(x) / x, 1 in the middle.
            disc = np.where(reach > 1e-6, 2.0 * special.j1(reach) / np.maximum(reach, 1e-6), 1.0)
            self._plain: Values = (plain * disc * self._every**2).astype(np.complex64)
            return
        self._finer = math.ceil(self.step / _FINE)
        step = self.step / self._finer
        variance = _ALIAS / (2.0 * (math.pi * (1.0 / step - 1.0)) ** 2)
        self._width = math.sqrt(variance)
        # The narrow Gaussian that objects are sampled with is divided out.
        plain *= np.exp(2.0 * math.pi**2 * variance * np.where(inside, square, 0.0)) / self._finer**2
        self._plain = plain.astype(np.complex64)
        y, x = (step * self._finer * side * fft.fftfreq(self._finer * side) for side in self._sides)
        self._x, self._y = x[None].astype(np.float32), y[:, None].astype(np.float32)

    def _lines(self, angle: float) -> tuple[Values, Values, Values, Values]:
        """Return e, g, g1 of the module's formula along the normal of a line, summed over lines, and dp/da."""
        p = self._x * math.cos(angle) + self._y * math.sin(angle)
        along = self._y * math.cos(angle) - self._x * math.sin(angle)
        pitch = min(self.target.size * self.pixel, _ENDLESS)
        even, density, first = (np.zeros_like(p) for _ in range(3))
        if pitch > _APART * self._width:  # at each point the nearest line, for the others are straight edges
            k = np.rint(p / pitch)
            at, sign = (p - k * pitch) / self._width, 1.0 - 2.0 * (k - 2.0 * np.floor(0.5 * k))
            near = np.abs(at) < _FLAT
            even = np.copysign(sign, sign * at)
            even[near], density[near], first[near] = _line(at[near], sign[near])
            return even, density, first, along / self._width
        most = math.ceil(1.5 * float(np.abs(p).max()) / pitch)
        for k in range(-most, most + 1):
            parts = _line((p - k * pitch) / self._width, -1.0 if k % 2 else 1.0)
            for total, part in zip((even, density, first), parts, strict=True):
                total += part
        return even, density, first, along / self._width

    def _corners(self, angles: Array) -> list[Values]:
        """Return spectra of the corner between two lines, black and white at -1/2 and 1/2, and slopes by angles."""
        (e, g, e1, along), (other, h, h1, across) = (self._lines(float(angle)) for angle in angles)
        between = float(angles[0] - angles[1])
        cosine, sine = math.cos(between), math.sin(between)
        value = e * other + 4.0 * cosine * g * h + 2.0 * cosine**2 * e1 * h1
        # By the angles: of each line, and of the cosine between them.
        turned = -4.0 * sine * (g * h + cosine * e1 * h1)
        one = 2.0 * g * along * other - 4.0 * cosine * e1 * along * h + turned
        two = 2.0 * h * across * e - 4.0 * cosine * h1 * across * g - turned
        return [self._coarse(0.5 * part) for part in (value, one, two)]

    def _coarse(self, fine: Values) -> Values:
        """Return the part of a spectrum that the lattice of the samples holds."""
        whole = fft.rfft2(fine)
        rows, columns = self._sides
        half = (rows + 1) // 2
        kept = np.concatenate([whole[:half], whole[len(whole) - (rows - half) :]])
        return np.asarray(kept[:, : columns // 2 + 1])

    def _spectra(self, squares: Array, angles: Array, *, slopes: bool) -> list[Values]:
        """Return spectra that samples are multiplied with, and slopes by the squares (b,) and by the angles."""
        shape = self.blur
        each = [
            np.float32(weight) * np.exp(np.float32(variance) * self._rate)
            for weight, variance in zip(shape.weights, shape.variances(squares), strict=True)
        ]
        faded = [np.sum(each, axis=0)]
        if slopes:
            faded += [
                self._rate * sum(np.float32(rate) * one for rate, one in zip(rates, each, strict=True))
                for rates in shape.rates.T
            ]
        objects = [self._plain]
        if self.target.kind != "pinhole":
            objects = [self._plain * part for part in self._corners(angles)]
        return [objects[0] * one for one in faded] + [one * faded[0] for one in objects[1:]]

    def read(
        self, samples: Sequence[Values], squares: Array, angles: Array, *, slopes: bool, threads: int = 0
    ) -> list[Values]:
        """Return images (r, height, width) of samples of PSFs and of their slopes, and slopes of the images.

        If there are to be `slopes`, by the squared blurs (r, b), pixels^2; and by the angles (r, a).
        """
        count = len(samples) + (self.blur.unknown if slopes else 0) + self.target.angles
        found: list[Values] = [np.empty((len(squares), *self._pixels), np.float32) for _ in range(count)]

        def one(k: int) -> None:
            first, *others = self._spectra(squares[k], angles[k], slopes=slopes)
            light = [fft.rfft2(np.asarray(each[k], np.float32), self._sides) for each in samples]
            spectra = [*(first * each for each in light), *(light[0] * other for other in others)]
            for place, spectrum in zip(found, spectra, strict=True):
                image = fft.irfft2(spectrum, self._sides)
                place[k] = image[tuple(slice(0, side * self._every, self._every) for side in self._pixels)]

        side_by_side(one, range(len(squares)), threads)
        return found


def _line(at: Values, sign: Values | float) -> tuple[Values, Values, Values]:
    """Return e, g, g1 of the module's formula for one line, `at` standard deviations of the Gaussian from it."""
    bell = np.exp(-0.5 * at * at) * (sign / math.sqrt(2.0 * math.pi))
    return sign * special.erf(at * math.sqrt(0.5)), bell, at * bell


def start_of_crossing(image: Array) -> tuple[float, float, float, float]:
    """Return row and column of a crossing from the middle pixel, and the angles of the normals of its two lines."""
    height, width = image.shape
    y, x = (np.arange(side) - side // 2 for side in (height, width))
    x, y = x[None].astype(float), y[:, None].astype(float)
    window = np.exp(-0.5 * (x**2 + y**2) / (0.3 * min(height, width)) ** 2)
    # A crossing is odd about each line: the level between black and white must be 0.
    plain = image - np.median(image)
    patterns = []
    for turn in np.pi * np.arange(_TURNS) / _TURNS:
        p, q = x * math.cos(turn) + y * math.sin(turn), y * math.cos(turn) - x * math.sin(turn)
        pattern = np.tanh(p) * np.tanh(q) * window
        # A flat image must not match.
        patterns.append(pattern - pattern.mean())
    stack = np.array(patterns)
    # Twice the sides: the correlation must not wrap around.
    size = [fft.next_fast_len(2 * side, real=True) for side in (height, width)]
    matched = fft.irfft2(fft.rfft2(plain, size) * np.conj(fft.rfft2(stack, size)), size)
    near = [max(2, side // 5) for side in (height, width)]
    rows, columns = (np.arange(-n, n + 1) for n in near)
    part = matched[:, rows[:, None], columns]
    turn, row, column = np.unravel_index(int(part.argmax()), part.shape)
    angle = math.pi * turn / _TURNS
    return float(rows[row]), float(columns[column]), angle, angle + 0.5 * math.pi


def relative_light(electrons: Array, valid: NDArray[np.bool_], u: Array, v: Array) -> Array:
    """Return light in each pixel over that in the middle of its window, shape of `electrons` (n, e, height, width).

    `u` (n, width) and `v` (n, height) are positions of pixels over the sensor, from -1 to 1. The logarithm of the
    light is a polynomial of these: of degree 4, or less where windows are fewer than one and a half for each
    coefficient.
    """
    count, exposures, height, width = electrons.shape
    degree = highest_degree(_LIGHT_DEGREE, 4 * count // 3)
    found = np.ones(electrons.shape)
    if degree == 0:
        return found
    over = monomials(np.repeat(u[:, None], height, axis=1), np.repeat(v[:, :, None], width, axis=2), degree)
    for e in range(exposures):
        white = np.array([_white(*pair) for pair in zip(electrons[:, e], valid[:, e], strict=True)])
        basis, light = over[white], np.log(electrons[:, e][white])
        if np.linalg.matrix_rank(basis) < basis.shape[1]:
            continue
        weight = np.ones(len(light))
        for _ in range(_LIGHT_TURNS):  # robustly (Geman and McClure): dirt, print
            root = np.sqrt(weight)
            share = np.linalg.lstsq(root[:, None] * basis, root * light, rcond=None)[0]
            distance = np.abs(light - basis @ share)
            weight = 1.0 / (1.0 + (distance / max(3.0 * float(np.median(distance)), 1e-6)) ** 2) ** 2
        smooth = over @ share
        found[:, e] = np.exp(smooth - smooth[:, height // 2, width // 2, None, None])
    return found


def _white(image: Array, valid: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return the pixels in white squares, away from lines."""
    low, high = np.percentile(image[valid], [5.0, 95.0])
    bright = ndimage.median_filter(image, size=3, mode="nearest") > 0.5 * (low + high)
    inside = ndimage.binary_erosion(bright, iterations=_BLURRED, border_value=True) & valid & (image > 0.0)
    return inside if inside.sum() >= _LEAST else np.zeros_like(inside)
