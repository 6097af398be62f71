r"""Pixel values of star images from samples of their PSFs, with pixel area and blur, and derivatives by blur widths.

Lengths are in units of lambda*N, frequencies in cycles per lambda*N. The intensity of a PSF has no frequencies above
1. From samples with a spacing h < 1/2, the image along one axis is

.. math:: I_i = p \sum_j k(x_i - h j)\, s_j, \qquad
          k(x) = \int T(f)\, \mathrm{sinc}(p f)\, e^{-2 \pi^2 \sigma^2 f^2} \cos(2 \pi f x)\, df

where ``x_i`` are pixel centres, p is the pixel pitch, sigma the rms width of a Gaussian blur and ``s_j`` the
fractions of light per sample. The low-pass filter T is 1 up to the frequency F and falls to 0 at ``1/h - 1``, where
aliases begin. F is 1, or smaller if pixels and blur suppress higher frequencies; with a wide blur h may be nearly 1.
Pixel size and blur width are not limited, because blur is applied before sampling by pixels. Other blur shapes are
mixtures of Gaussians, whose images are summed. In this file, r stars in e exposures have r * e images.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np
import scipy

from lommel.base import threads
from lommel.base.arrays import Array, Values
from lommel.blur.mixtures import BlurProfile
from lommel.special.legendre import gauss_legendre

_TAPER = 1.0 / 0.45 - 1.0  # (frequency at which T reaches 0) / F: without blur h is 0.45 lambda*N
_NEGLIGIBLE = 1e-5  # largest transfer function of pixels and blur above F
_BANDS = np.linspace(0.02, 1.0, 50)  # candidates for F
ROOM = 0.25  # increase of the blur width, pixels, up to which the sample lattice is kept
_MARGIN = 3.0  # lambda*N by which the samples extend beyond the outer pixels
_BLUR_MARGIN = 3.7  # standard deviations of the blur by which the samples extend farther
_BATCH = 3  # number of images computed together, so that their samples stay in the cache
# Additional variances of wings and halo, divided by the geometric mean variance of the blur.
_WIDER_VARIANCES = (3.0, 15.0)
_MIN_VARIANCE = 0.05  # pixels^2: added to the variances of the blur before that mean
OTHER_BLURS = ("Gaussian", "along rows", "oblique", "wings", "halo")
"""Blurs in addition to that of the model, with respect to which derivatives of images are available."""
_ERF_ARGUMENT = 2.2  # argument of the error function at the ends of T's fall from 1 to 0


class StarReadout:
    """Linear map from samples on a lattice around the axis to the pixels of a window, with pixel area and blur.

    `pixel` is the pixel pitch (lambda*N) and `widest` the largest blur width (pixels). `smallest_variances` are those
    of the Gaussians of the narrowest blur (pixels^2), by default 0. If `integrate` is False, pixels are
    point-sampled. The attribute `step` is the sample spacing (lambda*N).
    """

    def __init__(
        self,
        window: tuple[int, int],
        pixel: float,
        widest: float,
        blur: BlurProfile,
        *,
        integrate: bool,
        smallest_variances: Array | None = None,
    ) -> None:
        self.blur = blur
        self.pixel, self.widest = pixel, widest
        self.smallest_variances = np.zeros(len(blur.weights)) if smallest_variances is None else smallest_variances
        band = self._band(integrate)
        cutoff = _TAPER * band
        self.step = 1.0 / (1.0 + cutoff)
        # Light farther than half a window outside the window is neglected.
        blur_margins = [min(_BLUR_MARGIN * widest, 0.5 * side) for side in window]
        half_sides = [
            math.ceil((_MARGIN + pixel * (side // 2 + 0.5 * integrate + blur_margin)) / self.step)
            for side, blur_margin in zip(window, blur_margins, strict=True)
        ]
        self.shape = (2 * half_sides[0] + 1, 2 * half_sides[1] + 1)
        length = self.step * max(half_sides)
        # A Gauss rule integrates cos(w t), abs(t) <= 1, up to rounding with w / 2 + 30 nodes; here w is that of the
        # fastest cosine.
        nodes, weights = gauss_legendre(math.ceil(0.5 * math.pi * cutoff * (2.0 * length)) + 30)
        self._f: Array = cutoff * nodes
        middle = 0.5 * (band + cutoff)
        taper = 0.5 * scipy.special.erfc(_ERF_ARGUMENT * (self._f - middle) / (cutoff - middle))
        area = np.sinc(pixel * self._f) if integrate else 1.0
        self._f_weights = 2.0 * pixel * cutoff * weights * taper * area
        self._window = window
        self._kernels: tuple[bytes, list[list[Values]]] = b"", []
        #: For rows, then columns: pairs (pixels, samples) of cosines and of sines, shape (positions, frequencies).
        self._axis_waves = [
            list(zip(self._waves(pixel, side // 2), self._waves(self.step, half), strict=True))
            for side, half in zip(window, half_sides, strict=True)
        ]

    def suffices_for(self, width: float, variances: Array) -> bool:
        """Return whether the samples suffice for a blur of this width (pixels), whose Gaussians have these variances.

        Samples for much wider blurs are not used either, because there are more of them than necessary.
        """
        in_range = self.widest - 2.0 * ROOM <= width <= self.widest
        return in_range and bool((variances >= self.smallest_variances).all())

    def _band(self, integrate: bool) -> float:
        """Return F, cycles per lambda*N, above which pixels and the narrowest blur suppress the image."""
        rate = 2.0 * (math.pi * self.pixel * _BANDS) ** 2
        transfer = np.exp(-np.multiply.outer(rate, self.smallest_variances)) @ self.blur.weights
        if integrate:
            transfer /= np.maximum(math.pi * self.pixel * _BANDS, 1.0)  # the envelope of the sinc
        negligible = transfer < _NEGLIGIBLE
        return float(_BANDS[negligible.argmax()]) if negligible.any() else 1.0

    def _waves(self, pitch: float, last_index: int) -> tuple[Array, Array]:
        angle = np.multiply.outer(pitch * np.arange(last_index + 1.0), 2.0 * math.pi * self._f)
        return np.cos(angle), np.sin(angle)

    def _matrices(self, variances: Array, *, derivatives: bool) -> Iterator[list[list[Values]]]:
        """Yield matrices [rows, columns][even, odd part] (r, g, pixels, samples) for variances (r, g).

        If `derivatives`, also yield the derivatives of the matrices by the variance. The kernel k is even: the even
        and odd parts of an image are computed from samples and pixels on one side of the axis.
        """
        # The derivative of exp(rate s) by the variance s (pixels^2) is rate exp(rate s).
        rate = -2.0 * (math.pi * self.pixel * self._f) ** 2
        blurred = self._f_weights * np.exp(np.multiply.outer(variances, rate))
        for weights in (blurred, blurred * rate) if derivatives else (blurred,):
            yield [
                [products(pixels * weights[:, :, None], samples).astype(np.float32) for pixels, samples in axis]
                for axis in self._axis_waves
            ]

    def read(self, samples: Sequence[Values], squared_widths: Array, *, derivatives: bool) -> list[Values]:
        """Return images (r * e, height, width) from samples of PSFs and of their derivatives.

        `squared_widths` (r, e, b) are those of the blur. If `derivatives`, the derivatives of the first image by the
        squared widths follow.
        """
        equal_stars = bool((squared_widths == squared_widths[:1]).all())
        variances = self.blur.variances(squared_widths[:1] if equal_stars else squared_widths)
        variances = variances.reshape(-1, len(self.blur.weights))
        period, count = len(variances), len(samples[0])  # the blurs repeat after `period` images
        width_count = self.blur.unknown if derivatives else 0
        matrices = list(self._matrices(variances, derivatives=width_count > 0))
        images = np.empty((len(samples) + width_count, count, *self._window), np.float32)
        batch_size = _BATCH if period == count else period * max(1, _BATCH // period)
        for rows in (slice(start, start + batch_size) for start in range(0, count, batch_size)):
            variance_rows = rows if period == count else slice(None)
            batch = [[[part[variance_rows] for part in axis] for axis in axes] for axes in matrices]
            batch_samples = np.stack([values[rows] for values in samples]).astype(np.float32, copy=False)
            images[:, rows] = self._read_batch(batch_samples, batch, width_count)
        return list(images)

    def _read_batch(self, samples: Values, matrices: list[list[list[Values]]], derivative_count: int) -> Values:
        """Return images from samples (n, r, h, w), and then derivatives of the first image by squared blur widths.

        `derivative_count` is their number; `matrices` are those of all Gaussians of the mixture.
        """
        (by_row, by_column), *derivative_matrices = matrices
        parts = _even_odd_parts(samples.reshape(len(samples), -1, len(by_row[0]), *self.shape))
        size = len(samples) + derivative_count, *parts[0][0].shape[1:3], *(side // 2 + 1 for side in self._window)
        images = [[np.empty(size, np.float32) for _ in range(2)] for _ in range(2)]
        for y, x in product(range(2), range(2)):
            part, image = parts[y][x], images[y][x]
            row_images = _row_images(part, by_column[x])
            image[: len(samples)] = _weighted_sums(row_images, by_row[y], self.blur.weights)
            for by_rows, by_columns in derivative_matrices:
                changed_rows = _row_images(part[0], by_columns[x])
                for derivative, rates in zip(image[len(samples) :], self.blur.rates.T, strict=True):
                    weights = self.blur.weights * rates
                    derivative[...] = _weighted_sums(changed_rows, by_row[y], weights)
                    derivative += _weighted_sums(row_images[0], by_rows[y], weights)
        return unfolded(images, self._window).reshape(len(images[0][0]), -1, *self._window)

    def trailed(self, samples: Sequence[Values], trails: Array) -> list[Values]:
        """Return samples (r * e, h, w) blurred by a line in each exposure; `trails` (e, 2) as in :func:`lines_of`."""
        lengths, angles = (part[:, None, None] for part in lines_of(trails))
        sides = [
            scipy.fft.next_fast_len(side + math.ceil(float(lengths.max()) * self.pixel / self.step), real=True)
            for side in self.shape
        ]
        # Frequencies in cycles per pixel; the spectrum of the samples has no aliases.
        frequencies = np.fft.fftfreq(sides[0])[:, None], np.fft.rfftfreq(sides[1])
        along = (frequencies[0] * np.sin(angles) + frequencies[1] * np.cos(angles)) * self.pixel / self.step
        transfer = np.sinc(lengths * along).astype(np.float32)
        spectra = (scipy.fft.rfft2(part.reshape(-1, len(trails), *self.shape), sides) for part in samples)
        blurred = (scipy.fft.irfft2(spectrum * transfer, sides) for spectrum in spectra)
        return [part[..., : self.shape[0], : self.shape[1]].reshape(-1, *self.shape) for part in blurred]

    def other_blurs(self, samples: Values, squared_widths: Array) -> dict[str, Values]:
        """Return derivatives (r * e, height, width) of images by the parameters of OTHER_BLURS.

        "Gaussian": additional variance (pixels^2). "along rows" and "oblique": half the difference between the
        variances along rows and columns, and the covariance (pixels^2). "wings" and "halo": fraction of light in a
        wider blur. `squared_widths` (e, b) are those of the blur of each exposure.
        """
        exposures = len(squared_widths)
        derivatives = {name: np.empty((len(samples), *self._window), np.float32) for name in OTHER_BLURS}
        for k, variances in enumerate(self.blur.variances(squared_widths)):
            # Kernels of the last blur are kept: without blur, those of all images are the same.
            if self._kernels[0] != (key := variances.tobytes()):
                self._kernels = key, self._other_kernels(variances)
            parts = ((_row_images(samples[k::exposures, None], x), y) for y, x in self._kernels[1])
            blurred = (_weighted_sums(rows, y, self.blur.weights)[:, 0] for rows, y in parts)
            image, along, across, oblique, *wider = blurred
            blur_derivatives = [along + across, along - across, oblique, *(wide - image for wide in wider)]
            for images, values in zip(derivatives.values(), blur_derivatives, strict=True):
                images[k::exposures] = values
        return derivatives

    def _other_kernels(self, variances: Array) -> list[list[Values]]:
        """Return kernels [rows, columns] (1, c, pixels, samples) of an image, and of its changes by other blurs."""
        phases = [
            [2.0 * math.pi * pitch * np.multiply.outer(np.arange(n) - n // 2, self._f) for pitch, n in side]
            for side in zip(
                ((self.pixel, n) for n in self._window), ((self.step, n) for n in self.shape), strict=True
            )
        ]
        rate = -2.0 * (math.pi * self.pixel * self._f) ** 2

        def kernels(weights: Array, *, odd: bool = False) -> list[Values]:
            """Return the kernel k of rows and columns; if `odd`, the integral with sines."""
            first, second, sign = (np.sin, np.cos, -1.0) if odd else (np.cos, np.sin, 1.0)
            return [
                np.asarray(
                    products(np.cos(x) * weights[:, None], first(y))
                    + sign * products(np.sin(x) * weights[:, None], second(y)),
                    np.float32,
                )[None]
                for x, y in phases
            ]

        mean_variance = math.exp(float(self.blur.weights @ np.log(variances + _MIN_VARIANCE)))
        blurred = self._f_weights * np.exp(np.multiply.outer(variances, rate))
        kernel, derivative = kernels(blurred), kernels(blurred * rate)
        # The derivative by the covariance is a product of first derivatives, which are odd.
        odd_kernels = kernels(2.0 * math.pi * self.pixel * self._f * blurred, odd=True)
        wide_weights = (
            self._f_weights * np.exp(np.multiply.outer(variances + factor * mean_variance, rate))
            for factor in _WIDER_VARIANCES
        )
        mixed = [derivative[0], kernel[1]], [kernel[0], derivative[1]], odd_kernels
        return [kernel, *mixed, *map(kernels, wide_weights)]


def lines_of(trails: Array) -> tuple[Array, Array]:
    """Return the lengths (pixels) and angles (radians, from the x axis towards the y axis) of lines.

    `trails` (..., 2) are half the difference between the variances along y and x, and their covariance (pixels^2):
    the covariance of a line of length L is L^2 / 12 along it, and 0 across.
    """
    return np.sqrt(24.0 * np.hypot(trails[..., 0], trails[..., 1])), 0.5 * np.arctan2(trails[..., 1], -trails[..., 0])


def _row_images(part: Values, matrices: Values) -> Values:
    """Return products (..., g, h, m) of rows of images (..., r, h, n) with matrices (r, g, m, n) of g Gaussians."""
    r, g, _, n = matrices.shape
    rows = products(part, matrices.reshape(r, -1, n))  # all Gaussians in one product: short ones are slow
    return rows.reshape(*part.shape[:-1], g, -1).swapaxes(-2, -3)


def _weighted_sums(row_images: Values, matrices: Values, weights: Array) -> Values:
    """Return weighted sums over Gaussians of column products, from results of :func:`_row_images`."""
    r, _, m, _ = matrices.shape
    weighted: Values = (weights.astype(np.float32)[:, None, None] * matrices).swapaxes(1, 2).reshape(r, m, -1)
    stacked = row_images.reshape(*row_images.shape[:-3], -1, row_images.shape[-1])
    return column_products(stacked, weighted)


def _even_odd_parts(images: Values) -> list[list[Values]]:
    """Return even and odd parts of images, [parity along y][parity along x], for positions >= 0."""
    parts = [images]
    for _ in range(2):
        parts = [part for part_of_image in parts for part in _halves(part_of_image.swapaxes(-1, -2))]
    return [parts[:2], parts[2:]]


def _halves(images: Values) -> tuple[Values, Values]:
    """Return sums and differences of samples and their mirror images along the last axis; the central one once."""
    middle = images.shape[-1] // 2
    after, before = images[..., middle:], images[..., middle::-1]
    even = after + before
    even[..., 0] *= 0.5
    return even, after - before


def unfolded(parts: list[list[Values]], window: tuple[int, int]) -> Values:
    """Return images (..., height, width) from their even and odd parts."""
    (even, odd_x), (odd_y, odd_both) = parts
    images = np.empty((*even.shape[:-2], *window), np.float32)
    (y, x), (height, width) = (side // 2 for side in window), window
    for sign, rows, count in ((1.0, slice(y, None), height - y), (-1.0, slice(y, None, -1), y + 1)):
        even_part, odd_part = even + sign * odd_y, odd_x + sign * odd_both
        images[..., rows, x:] = (even_part + odd_part)[..., :count, : width - x]
        images[..., rows, x::-1] = (even_part - odd_part)[..., :count, : x + 1]
    return images


def products(images: Values, matrix: Array) -> Values:
    """Return products (..., h, m) of the rows of images (..., h, n) with a matrix (m, n) or matrices (..., m, n)."""
    return threads.product(images, matrix.swapaxes(-1, -2).astype(images.dtype, copy=False))


def column_products(images: Values, matrix: Array) -> Values:
    """Return products (..., m, width) of the columns of images (..., n, width) with a matrix (m, n) or matrices."""
    return products(images.swapaxes(-1, -2), matrix).swapaxes(-1, -2)
