r"""Pixel values of stars from samples of their images, with pixel area and blur, and the slopes by its widths.

The intensity holds no frequency above 1 / (lambda*N): from samples h < 1/2 apart (units of lambda*N), images are

.. math:: I_i = p \sum_j k(x_i - h j)\, s_j, \qquad
          k(x) = \int T(f)\, \mathrm{sinc}(p f)\, e^{-2 \pi^2 \sigma^2 f^2} \cos(2 \pi f x)\, df

along rows and columns, ``s_j`` being fractions of light per sample; T is 1 up to f = 1 and falls to 0 at ``1/h - 1``,
where copies of the spectrum begin. Pixels may be of any size, and blur of any width: nothing is blurred on pixels.
Blur of another shape is a mixture of Gaussians: a sum of such images.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from scipy import special

from lommel.base.arrays import Array, Values
from lommel.blur.mixtures import Shape
from lommel.special.legendre import gauss_legendre

STEP = 0.45  # lambda*N from sample to sample
_MARGIN = 3.0  # lambda*N of samples beyond the outer pixels
_WIDTHS = 4.5  # standard deviations of blur beyond them
_EDGE = 1.0 / STEP - 1.0
_ALONE = 2**18  # multiplications up to which BLAS uses one thread
_WIDER = (3.0, 15.0)  # times the middle variance of a blur, by which Gaussians are wider that it may lack
_LEAST = 0.05  # pixels^2 of that variance
OTHER_BLURS = ("Gaussian", "along rows", "oblique", "wings", "halo")
"""Blurs of which images have derivatives, beside that of their shape."""
_FALL = 2.2  # of the error function, in half the width of the fall of T


class StarReadout:
    """From samples on a lattice around the axis to the pixels of a window, for blur of a shape up to `widest` pixels.

    `pixel` is in lambda*N; pixels that do not `integrate` are points.
    """

    step = STEP

    def __init__(
        self, window: tuple[int, int], pixel: float, widest: float, shape: Shape, *, integrate: bool
    ) -> None:
        self.blur = shape
        self.pixel, self.widest = pixel, widest
        margin = _MARGIN + pixel * (0.5 * integrate + _WIDTHS * widest)
        halves = [math.ceil(((side // 2) * pixel + margin) / STEP) for side in window]
        self.shape = (2 * halves[0] + 1, 2 * halves[1] + 1)
        length = STEP * max(halves)
        nodes, weights = gauss_legendre(math.ceil(0.5 * math.pi * _EDGE * (2.0 * length)) + 30)
        self._f: Array = _EDGE * nodes
        middle = 0.5 * (1.0 + _EDGE)
        taper = 0.5 * special.erfc(_FALL * (self._f - middle) / (_EDGE - middle))
        area = np.sinc(pixel * self._f) if integrate else 1.0
        self._weights = 2.0 * pixel * _EDGE * weights * taper * area
        self._sides = [
            (self._waves(pixel, side - side // 2 - 1, side // 2), self._waves(STEP, half, half))
            for side, half in zip(window, halves, strict=True)
        ]

    def _waves(self, pitch: float, last: int, before: int) -> tuple[Array, Array]:
        angle = np.multiply.outer(pitch * np.arange(-before, last + 1.0), 2.0 * math.pi * self._f)
        return np.cos(angle), np.sin(angle)

    def matrices(self, variances: Array) -> tuple[list[Array], list[Array]]:
        """Return matrices of rows and columns (r, pixels, samples) for variances (r,), and slopes by these."""
        rate = -2.0 * (math.pi * self.pixel * self._f) ** 2
        faded = self._weights * np.exp(np.multiply.outer(variances, rate))
        return self._even(faded), self._even(faded * rate)

    def _even(self, faded: Array) -> list[Array]:
        """Return matrices of rows and columns of weights (r, f)."""
        return [
            np.asarray(_products(cos * faded[:, None], along) + _products(sin * faded[:, None], across), np.float32)
            for (cos, sin), (along, across) in self._sides
        ]

    def _odd(self, faded: Array) -> list[Array]:
        """Return derivatives by the place of a pixel of matrices of rows and columns of weights (r, f)."""
        faded = 2.0 * math.pi * self.pixel * self._f * faded
        return [
            np.asarray(_products(cos * faded[:, None], across) - _products(sin * faded[:, None], along), np.float32)
            for (cos, sin), (along, across) in self._sides
        ]

    def read(self, samples: Sequence[Values], squares: Array, *, slopes: bool) -> list[Values]:
        """Return images (r * e, height, width) of samples of PSFs and of their slopes, for squared blurs (r, e, b).

        And, if there are to be `slopes`, those by the b squares.
        """
        one = bool((squares == squares[:1]).all())
        variances = self.blur.variances(squares[:1] if one else squares).reshape(-1, len(self.blur.weights))
        size = tuple(len(cos) for (cos, _), _ in self._sides)
        more = self.blur.unknown if slopes else 0
        found: list[Values] = [np.zeros((len(samples[0]), *size), np.float32) for _ in range(len(samples) + more)]
        for weight, rates, variance in zip(self.blur.weights, self.blur.rates, variances.T, strict=True):
            (down, across), (down_slope, across_slope) = self.matrices(variance)
            down, down_slope = np.float32(weight) * down, np.float32(weight) * down_slope
            if (apart := len(down)) == len(samples[0]):  # each image has a blur of its own
                parts = [(slice(None), (down, across), (down_slope, across_slope))]
            else:  # images that many apart have the same
                parts = [
                    (slice(k, None, apart), (down[k], across[k]), (down_slope[k], across_slope[k]))
                    for k in range(apart)
                ]
            for each, (rows, columns), (by_rows, by_columns) in parts:
                halves = [_products(one[each], columns) for one in samples]
                for place, half in zip(found, halves, strict=False):
                    place[each] += _down(half, rows)
                if more:
                    slope = _down(halves[0], by_rows) + _down(_products(samples[0][each], by_columns), rows)
                    for place, rate in zip(found[-more:], rates, strict=True):
                        place[each] += np.float32(rate) * slope
        return found

    def other_blurs(self, samples: Values, squares: Array) -> dict[str, Values]:
        """Return derivatives (r * e, height, width) of images of samples by blurs that the shape does not have.

        Of squared blurs (e, b): by the variance of a Gaussian besides, pixels^2; by half of what that along rows
        exceeds that along columns, and by what both have in common, pixels^2; by the shares of wider Gaussians.
        """
        apart, rate = len(squares), -2.0 * (math.pi * self.pixel * self._f) ** 2
        size = tuple(len(cos) for (cos, _), _ in self._sides)
        found = {name: np.empty((len(samples), *size), np.float32) for name in OTHER_BLURS}
        for k, variances in enumerate(self.blur.variances(squares)):
            middle = math.exp(float(self.blur.weights @ np.log(variances + _LEAST)))
            faded = self._weights * np.exp(np.multiply.outer(variances, rate))
            plain, slope, odd = self._even(faded), self._even(faded * rate), self._odd(faded)
            image, along, across, oblique = (
                self._mixed(samples[k::apart], rows, columns)
                for rows, columns in (plain, (slope[0], plain[1]), (plain[0], slope[1]), odd)
            )
            made = [along + across, along - across, oblique]
            for times in _WIDER:
                wide = self._weights * np.exp(np.multiply.outer(variances + times * middle, rate))
                made.append(self._mixed(samples[k::apart], *self._even(wide)) - image)
            for place, each in zip(found.values(), made, strict=True):
                place[k::apart] = each
        return found

    def _mixed(self, samples: Values, rows: Array, columns: Array) -> Values:
        """Return images behind the mixture of Gaussians of matrices of rows and columns (c, pixels, samples)."""
        each = zip(self.blur.weights, rows, columns, strict=True)
        parts = [np.float32(weight) * _down(_products(samples, across), down) for weight, down, across in each]
        return np.asarray(sum(parts))


def _products(images: Values, matrix: Array) -> Values:
    """Return products (r, h, m) of the rows of images (r, h, n) with a matrix (m, n), or one for each (r, m, n)."""
    # Of larger products that are still small, threads of BLAS wait for each other far longer than they take.
    turned, rows = matrix.swapaxes(-1, -2).astype(images.dtype, copy=False), images.shape[-2]
    many = max(1, _ALONE // max(turned.shape[-2] * turned.shape[-1], 1))
    if many >= rows:
        return np.asarray(images @ turned)
    return np.concatenate([images[:, k : k + many] @ turned for k in range(0, rows, many)], axis=1)


def _down(images: Values, matrix: Array) -> Values:
    """Return the same along the columns of images (r, n, width)."""
    return _products(images.swapaxes(1, 2), matrix).swapaxes(1, 2)
