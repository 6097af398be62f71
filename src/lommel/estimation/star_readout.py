r"""Pixel values of stars from samples of their images, with pixel area and blur, and the slopes by its widths.

The intensity holds no frequency above 1 / (lambda*N): from samples h < 1/2 apart (units of lambda*N), images are

.. math:: I_i = p \sum_j k(x_i - h j)\, s_j, \qquad
          k(x) = \int T(f)\, \mathrm{sinc}(p f)\, e^{-2 \pi^2 \sigma^2 f^2} \cos(2 \pi f x)\, df

along rows and columns, ``s_j`` being fractions of light per sample; T is 1 up to a frequency F and falls to 0 at
``1/h - 1``, where copies of the spectrum begin. F is 1, or less where pixels and blur leave nothing above it: behind
wide blur samples may be nearly 1 apart. Pixels may be of any size, and blur of any width: nothing is blurred on
pixels. Blur of another shape is a mixture of Gaussians: a sum of such images.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np
from scipy import special

from lommel.base.arrays import Array, Values
from lommel.blur.mixtures import Shape
from lommel.special.legendre import gauss_legendre

_TAPER = 1.0 / 0.45 - 1.0  # frequency at which T reaches 0, over F: samples of sharp images are 0.45 lambda*N apart
_FAINT = 1e-6  # largest transfer of pixels and blur above F
_BANDS = np.linspace(0.02, 1.0, 50)  # values of F
ROOM = 0.5  # pixels by which blur may widen before samples are chosen anew
_MARGIN = 3.0  # lambda*N of samples beyond the outer pixels
_WIDTHS = 3.7  # standard deviations of blur: further samples beyond them
_ALONE = 2**18  # multiplications up to which BLAS uses a single thread
_TOGETHER = 6  # images read together, so that their samples stay in the cache
_WIDER = (3.0, 15.0)  # times the mean variance of a blur: Gaussians of wings and of a halo
_LEAST = 0.05  # pixels^2 added to that variance
OTHER_BLURS = ("Gaussian", "along rows", "oblique", "wings", "halo")
"""Blurs of which images have derivatives, beside that of their shape."""
_FALL = 2.2  # argument of the error function in half the width of the fall of T


class StarReadout:
    """From samples on a lattice around the axis to the pixels of a window, for blur of a shape up to `widest` pixels.

    `pixel` is in lambda*N; pixels that do not `integrate` are points. `narrowest` are the least variances of the
    Gaussians of the blur (pixels^2), by default 0. Samples are `step` apart, lambda*N.
    """

    def __init__(
        self,
        window: tuple[int, int],
        pixel: float,
        widest: float,
        shape: Shape,
        *,
        integrate: bool,
        narrowest: Array | None = None,
    ) -> None:
        self.blur = shape
        self.pixel, self.widest = pixel, widest
        self.narrowest = np.zeros(len(shape.weights)) if narrowest is None else narrowest
        band = self._band(integrate)
        edge = _TAPER * band
        self.step = 1.0 / (1.0 + edge)
        # Hardly any light is half a window beyond its rim, from where wider blur would bring it.
        blurred = [min(_WIDTHS * widest, 0.5 * side) for side in window]
        halves = [
            math.ceil((_MARGIN + pixel * (side // 2 + 0.5 * integrate + more)) / self.step)
            for side, more in zip(window, blurred, strict=True)
        ]
        self.shape = (2 * halves[0] + 1, 2 * halves[1] + 1)
        length = self.step * max(halves)
        # Nodes for the fastest cosine, half a turn each two nodes, and 30 more.
        nodes, weights = gauss_legendre(math.ceil(0.5 * math.pi * edge * (2.0 * length)) + 30)
        self._f: Array = edge * nodes
        middle = 0.5 * (band + edge)
        taper = 0.5 * special.erfc(_FALL * (self._f - middle) / (edge - middle))
        area = np.sinc(pixel * self._f) if integrate else 1.0
        self._weights = 2.0 * pixel * edge * weights * taper * area
        self._window = window
        #: Of rows and columns, cosines and sines at pixels and samples from the axis on, (places, frequencies).
        self._sides = [
            list(zip(self._waves(pixel, side // 2), self._waves(self.step, half), strict=True))
            for side, half in zip(window, halves, strict=True)
        ]

    def serves(self, width: float, variances: Array) -> bool:
        """Return whether samples suffice for blur of this width, pixels, and of these least variances (c,)."""
        in_range = self.widest - 2.0 * ROOM <= width <= self.widest
        return in_range and bool((variances >= self.narrowest).all())

    def _band(self, integrate: bool) -> float:
        """Return the frequency F, cycles per lambda*N, above which the narrowest blur and the pixels pass nothing."""
        rate = 2.0 * (math.pi * self.pixel * _BANDS) ** 2
        passed = np.exp(-np.multiply.outer(rate, self.narrowest)) @ self.blur.weights
        if integrate:
            passed /= np.maximum(math.pi * self.pixel * _BANDS, 1.0)  # the envelope of the sinc
        faint = passed < _FAINT
        return float(_BANDS[faint.argmax()]) if faint.any() else 1.0

    def _waves(self, pitch: float, last: int) -> tuple[Array, Array]:
        angle = np.multiply.outer(pitch * np.arange(last + 1.0), 2.0 * math.pi * self._f)
        return np.cos(angle), np.sin(angle)

    def _matrices(self, variances: Array, *, slopes: bool) -> Iterator[list[list[Values]]]:
        """Yield matrices of rows and columns (r, pixels, samples) for variances (r,), and `slopes` by these.

        For both sides, that of the even and of the odd parts of images: k is even, and sums over both sides of the
        axis are those over one, of half as many samples.
        """
        # d/ds exp(-2 pi^2 s p^2 f^2), s the variance in pixels^2.
        rate = -2.0 * (math.pi * self.pixel * self._f) ** 2
        faded = self._weights * np.exp(np.multiply.outer(variances, rate))
        for weights in (faded, faded * rate) if slopes else (faded,):
            yield [
                [products(pixels * weights[:, None], samples).astype(np.float32) for pixels, samples in side]
                for side in self._sides
            ]

    def read(self, samples: Sequence[Values], squares: Array, *, slopes: bool) -> list[Values]:
        """Return images (r * e, height, width) of samples of PSFs and of their slopes, for squared blurs (r, e, b).

        And, if there are to be `slopes`, those by the b squares.
        """
        one = bool((squares == squares[:1]).all())
        variances = self.blur.variances(squares[:1] if one else squares).reshape(-1, len(self.blur.weights))
        apart, count = len(variances), len(samples[0])  # images that many apart have the same blur
        more = self.blur.unknown if slopes else 0
        made = [list(self._matrices(variance, slopes=more > 0)) for variance in variances.T]
        found = np.empty((len(samples) + more, count, *self._window), np.float32)
        step = _TOGETHER if apart == count else apart * max(1, _TOGETHER // apart)
        for at in (slice(first, first + step) for first in range(0, count, step)):
            own = at if apart == count else slice(None)
            mine = [[[[each[own] for each in side] for side in sides] for sides in one] for one in made]
            here = np.stack([each[at] for each in samples]).astype(np.float32, copy=False)
            found[:, at] = self._read(here, mine, more)
        return list(found)

    def _read(self, samples: Values, made: list[list[list[list[Values]]]], more: int) -> Values:
        """Return images and so many slopes of samples (n, r, h, w), with the matrices of each Gaussian."""
        parts = _folded(samples.reshape(len(samples), -1, len(made[0][0][0][0]), *self.shape))
        size = len(samples) + more, *parts[0][0].shape[1:3], *(side // 2 + 1 for side in self._window)
        found = [[np.zeros(size, np.float32) for _ in range(2)] for _ in range(2)]
        for weight, rates, ((down, across), *changes) in zip(self.blur.weights, self.blur.rates, made, strict=True):
            for y, x in product(range(2), range(2)):
                part, place = parts[y][x], found[y][x]
                half = np.float32(weight) * products(part, across[x])
                place[: len(samples)] += _down(half, down[y])
                for by_rows, by_columns in changes:
                    slope = _down(half[0], by_rows[y])
                    slope += np.float32(weight) * _down(products(part[0], by_columns[x]), down[y])
                    place[len(samples) :] += rates.astype(np.float32)[:, None, None, None, None] * slope
        return unfolded(found, self._window).reshape(len(found[0][0]), -1, *self._window)

    def other_blurs(self, samples: Values, squares: Array) -> dict[str, Values]:
        """Return derivatives (r * e, height, width) of images of samples by blurs that the shape does not have.

        Of squared blurs (e, b): by the variance of a Gaussian besides, pixels^2; by half of what that along rows
        exceeds that along columns, and by what both have in common, pixels^2; by the shares of wider Gaussians.
        """
        sides = [
            [2.0 * math.pi * pitch * np.multiply.outer(np.arange(n) - n // 2, self._f) for pitch, n in side]
            for side in zip(
                ((self.pixel, n) for n in self._window), ((self.step, n) for n in self.shape), strict=True
            )
        ]
        apart, rate = len(squares), -2.0 * (math.pi * self.pixel * self._f) ** 2

        def kernels(weights: Array, *, odd: bool = False) -> list[Array]:
            """Return k of rows and columns (c, pixels, samples), or its slope by the place of a pixel."""
            one, other, sign = (np.sin, np.cos, -1.0) if odd else (np.cos, np.sin, 1.0)
            return [
                np.asarray(
                    products(np.cos(x) * weights[:, None], one(y))
                    + sign * products(np.sin(x) * weights[:, None], other(y)),
                    np.float32,
                )
                for x, y in sides
            ]

        found = {name: np.empty((len(samples), *self._window), np.float32) for name in OTHER_BLURS}
        for k, variances in enumerate(self.blur.variances(squares)):
            middle = math.exp(float(self.blur.weights @ np.log(variances + _LEAST)))
            faded = self._weights * np.exp(np.multiply.outer(variances, rate))
            plain, slope = kernels(faded), kernels(faded * rate)
            odd = kernels(2.0 * math.pi * self.pixel * self._f * faded, odd=True)
            image, along, across, oblique = (
                self._mixed(samples[k::apart], rows, columns)
                for rows, columns in (plain, (slope[0], plain[1]), (plain[0], slope[1]), odd)
            )
            made = [along + across, along - across, oblique]
            for times in _WIDER:
                wide = self._weights * np.exp(np.multiply.outer(variances + times * middle, rate))
                made.append(self._mixed(samples[k::apart], *kernels(wide)) - image)
            for place, each in zip(found.values(), made, strict=True):
                place[k::apart] = each
        return found

    def _mixed(self, samples: Values, rows: Array, columns: Array) -> Values:
        """Return images behind the mixture of Gaussians, from matrices of rows and columns (c, pixels, samples)."""
        each = zip(self.blur.weights, rows, columns, strict=True)
        parts = [np.float32(weight) * _down(products(samples, across), down) for weight, down, across in each]
        return np.asarray(sum(parts))


def _folded(images: Values) -> list[list[Values]]:
    """Return the parts of images that are even and odd along columns, and each along rows, from the axis on."""
    found = [images]
    for _ in range(2):
        found = [part for each in found for part in _halves(each.swapaxes(-1, -2))]
    return [found[:2], found[2:]]


def _halves(images: Values) -> tuple[Values, Values]:
    """Return sums and differences of both sides of the axis along the last one; the axis itself counts once."""
    middle = images.shape[-1] // 2
    beyond, before = images[..., middle:], images[..., middle::-1]
    even = beyond + before
    even[..., 0] *= 0.5
    return even, beyond - before


def unfolded(parts: list[list[Values]], window: tuple[int, int]) -> Values:
    """Return images (..., height, width) from their even and odd parts."""
    (even, right), (down, both) = parts
    found = np.empty((*even.shape[:-2], *window), np.float32)
    (y, x), (height, width) = (side // 2 for side in window), window
    for sign, rows, below in ((1.0, slice(y, None), height - y), (-1.0, slice(y, None, -1), y + 1)):
        one, other = even + sign * down, right + sign * both
        found[..., rows, x:] = (one + other)[..., :below, : width - x]
        found[..., rows, x::-1] = (one - other)[..., :below, : x + 1]
    return found


def products(images: Values, matrix: Array) -> Values:
    """Return products (..., h, m) of the rows of images (..., h, n) with a matrix (m, n), or some (..., m, n)."""
    # Of larger products that are still small, threads of BLAS wait for each other far longer than they take.
    turned, rows = matrix.swapaxes(-1, -2).astype(images.dtype, copy=False), images.shape[-2]
    many = max(1, _ALONE // max(turned.shape[-2] * turned.shape[-1], 1))
    if many >= rows:
        return np.asarray(images @ turned)
    return np.concatenate([images[..., k : k + many, :] @ turned for k in range(0, rows, many)], axis=-2)


def _down(images: Values, matrix: Array) -> Values:
    """Return the same along the columns of images (..., n, width)."""
    return products(images.swapaxes(-1, -2), matrix).swapaxes(-1, -2)
