r"""Images of pinholes and of checkerboard corners ("crossings") from sampled PSFs, and their derivatives.

An image is the object convolved with the PSF, the pixel area and a blur, which is a mixture of Gaussians. The
spectrum of a PSF's intensity is 0 above the frequency 1 / (lambda*N). Therefore only frequencies of the object up to
1 / (lambda*N) are needed, and sums over samples less than 1/2 lambda*N apart equal the convolution integrals.

The spectrum of a pinhole, a uniform disc, is known in closed form. A crossing has the value -1/2 in black squares and
1/2 in white squares. It is convolved with a narrow Gaussian and sampled; its spectrum is divided by the Gaussian's.
The edges of a crossing are the lines ``p = x cos a + y sin a = 0`` and ``q = x cos b + y sin b = 0``, where a and b
are the angles of their normals. Twice the convolved crossing, with p and q in units of the standard deviation of the
Gaussian, is

.. math:: \mathrm{E}[\mathrm{sgn}(p + \nu_p)\, \mathrm{sgn}(q + \nu_q)]
          = e(p)\, e(q) + 4 \rho\, g(p)\, g(q) + 2 \rho^2\, g_1(p)\, g_1(q) + O(\rho^3),

with :math:`e(p) = \mathrm{erf}(p / \sqrt{2})`, the normal density g and :math:`g_1(p) = p\, g(p)`. The noise
:math:`\nu_p, \nu_q` is standard normal; its correlation :math:`\rho`, near 0, is the cosine of the angle between the
normals. Parallel edges of a checkerboard, one square apart, alternate in sign, and e, g and g_1 are summed over them.

The uneven illumination of a chart is estimated from the white squares of all windows, as a smooth function of
position.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.base.threads import side_by_side
from lommel.blur.mixtures import BlurProfile
from lommel.estimation.field_signs import highest_degree, monomials
from lommel.measures.transfer import disc_transfer

_STEP = 0.45  # largest distance between samples of PSFs, lambda*N
_OBJECT_STEP = 0.285  # largest distance between samples of objects, lambda*N
_MARGIN = 8.0  # lambda*N by which the samples of PSFs extend beyond the outer pixels
_PAD = 5.0  # lambda*N of zero padding on each side: light that wraps around must not reach the pixels
_ALIAS = 12.0  # -log(transfer function of the narrow Gaussian) at the lowest frequency that is aliased below 1
_SEPARATE = 12.0  # standard deviations of the Gaussian: parallel edges farther apart do not overlap
_FLAT_DISTANCE = 6.5  # standard deviations of the Gaussian: at larger distances from an edge, e is 1 or -1
_SINGLE_SIDE = 1e30  # lambda*N: side of squares that represents a single crossing
_DIRECTIONS = 90  # number of trial angles, in half a turn, for the initial estimate of a crossing
_LIGHT_DEGREE, _LIGHT_ITERATIONS = 4, 10  # polynomial of the illumination: degree, iterations of its robust fit
_EDGE_PIXELS = 2  # width of the border that is excluded from white squares
_MIN_WHITE = 10  # smallest number of white pixels of a window


class Target(NamedTuple):
    """Kind of object ("pinhole" or "crossing") and its size in pixels.

    The size is the diameter of a pinhole, or the side of the squares of a checkerboard (inf: a single crossing).
    """

    kind: str
    size: float

    @property
    def angle_count(self) -> int:
        """Number of unknown angles."""
        return 2 if self.kind == "crossing" else 0


class TargetReadout:
    """Map from samples of PSFs on a lattice to the pixels of a window whose middle pixel is near the target.

    Parameters
    ----------
    window : (int, int)
        Height and width in pixels.
    pixel : float
        Pixel pitch, lambda*N.
    target : Target
    blur : BlurProfile
        Blur as a mixture of Gaussians.
    integrate : bool
        Whether images are pixel-integrated; if False, they are point-sampled.
    """

    def __init__(
        self, window: tuple[int, int], pixel: float, target: Target, blur: BlurProfile, *, integrate: bool
    ) -> None:
        self.pixel, self.target, self._window, self.blur = pixel, target, window, blur
        self._samples_per_pixel = math.ceil(pixel / _STEP)
        self.step = pixel / self._samples_per_pixel
        half_sides = [math.ceil(((side // 2) * pixel + _MARGIN) / self.step) for side in window]
        self.shape = (2 * half_sides[0] + 1, 2 * half_sides[1] + 1)
        pad = 2 * math.ceil(_PAD / self.step)
        self._fft_sides = [
            scipy.fft.next_fast_len(side * self._samples_per_pixel + samples + pad, real=True)
            for side, samples in zip(window, self.shape, strict=True)
        ]
        f_row = scipy.fft.fftfreq(self._fft_sides[0], self.step)[:, None]
        f_column = scipy.fft.rfftfreq(self._fft_sides[1], self.step)[None]
        f_squared = f_row**2 + f_column**2
        in_band = f_squared <= 1.1  # the spectrum of the PSF is 0 beyond the frequency 1; 0.1 is for rounding
        # Single precision is sufficient: errors of images are 1e-6 of the peak, and noise is a thousand times larger.
        # The derivative of the log of a Gaussian's transfer function with respect to its variance in pixels^2:
        self._log_derivative: Values = np.float32(-2.0 * (math.pi * pixel) ** 2) * f_squared.astype(np.float32)
        pixel_transfer = np.sinc(pixel * f_row) * np.sinc(pixel * f_column) if integrate else np.ones(f_squared.shape)
        # The origin is shifted from the first sample of a PSF to the centre of the first pixel: pixel k is then
        # sample k * samples_per_pixel.
        corner = [half - (side // 2) * self._samples_per_pixel for half, side in zip(half_sides, window, strict=True)]
        shift = np.exp(2j * math.pi * self.step * (f_row * corner[0] + f_column * corner[1]))
        transfer = in_band * pixel_transfer * shift
        if target.kind == "pinhole":
            disc = disc_transfer(target.size * pixel, np.sqrt(f_squared))
            self._transfer: Values = (transfer * disc * self._samples_per_pixel**2).astype(np.complex64)
            return
        self._object_samples = math.ceil(self.step / _OBJECT_STEP)  # number per PSF sample, along each axis
        object_step = self.step / self._object_samples
        variance = _ALIAS / (2.0 * (math.pi * (1.0 / object_step - 1.0)) ** 2)
        self._width = math.sqrt(variance)
        # Division by the transfer function of the narrow Gaussian.
        transfer *= np.exp(2.0 * math.pi**2 * variance * np.where(in_band, f_squared, 0.0)) / self._object_samples**2
        self._transfer = transfer.astype(np.complex64)
        y, x = (
            object_step * self._object_samples * side * scipy.fft.fftfreq(self._object_samples * side)
            for side in self._fft_sides
        )
        self._x, self._y = x[None].astype(np.float32), y[:, None].astype(np.float32)

    def _edge_terms(self, angle: float) -> tuple[Values, Values, Values, Values]:
        """Return e(p), g(p) and g1(p) (module docstring), summed over parallel edges, and the derivative of p."""
        p = self._x * math.cos(angle) + self._y * math.sin(angle)
        derivative = self._y * math.cos(angle) - self._x * math.sin(angle)
        pitch = min(self.target.size * self.pixel, _SINGLE_SIDE)
        e, g, g1 = (np.zeros_like(p) for _ in range(3))
        if pitch > _SEPARATE * self._width:  # at each point, only the nearest edge contributes
            k = np.rint(p / pitch)
            distance, sign = (p - k * pitch) / self._width, 1.0 - 2.0 * (k - 2.0 * np.floor(0.5 * k))
            is_near = np.abs(distance) < _FLAT_DISTANCE
            e = np.copysign(sign, sign * distance)
            e[is_near], g[is_near], g1[is_near] = _edge(distance[is_near], sign[is_near])
            return e, g, g1, derivative / self._width
        last_edge = math.ceil(1.5 * float(np.abs(p).max()) / pitch)
        for k in range(-last_edge, last_edge + 1):
            terms = _edge((p - k * pitch) / self._width, -1.0 if k % 2 else 1.0)
            for total, term in zip((e, g, g1), terms, strict=True):
                total += term
        return e, g, g1, derivative / self._width

    def _corner_spectra(self, angles: Array) -> list[Values]:
        """Return the spectrum of a crossing, -1/2 in black and 1/2 in white squares, and its derivatives by angle."""
        (e, g, g1, dp), (other_e, other_g, other_g1, dq) = (self._edge_terms(float(angle)) for angle in angles)
        difference = float(angles[0] - angles[1])
        rho, sine = math.cos(difference), math.sin(difference)
        value = e * other_e + 4.0 * rho * g * other_g + 2.0 * rho**2 * g1 * other_g1
        # p and q depend on one angle each; rho depends on both: d(rho) = -sine d(difference).
        by_rho = -4.0 * sine * (g * other_g + rho * g1 * other_g1)
        by_first = 2.0 * g * dp * other_e - 4.0 * rho * g1 * dp * other_g + by_rho
        by_second = 2.0 * other_g * dq * e - 4.0 * rho * other_g1 * dq * g - by_rho
        return [self._coarse_spectrum(0.5 * part) for part in (value, by_first, by_second)]

    def _coarse_spectrum(self, fine_object: Values) -> Values:
        """Return the spectrum of a finely sampled object at the frequencies of the coarser lattice of PSF samples."""
        spectrum = scipy.fft.rfft2(fine_object)
        rows, columns = self._fft_sides
        half = (rows + 1) // 2
        coarse_rows = np.concatenate([spectrum[:half], spectrum[len(spectrum) - (rows - half) :]])
        return np.asarray(coarse_rows[:, : columns // 2 + 1])

    def _spectra(self, squared_widths: Array, angles: Array, *, derivatives: bool) -> list[Values]:
        """Return the transfer function from the samples of a PSF to the image, followed by its derivatives.

        The derivatives are first, if `derivatives`, by the `squared_widths` (b,) of the blur, pixels^2, and then by
        the `angle_count`.
        """
        profile = self.blur
        gaussians = [
            np.float32(weight) * np.exp(np.float32(variance) * self._log_derivative)
            for weight, variance in zip(profile.weights, profile.variances(squared_widths), strict=True)
        ]
        blurs = [np.sum(gaussians, axis=0)]
        if derivatives:
            blurs += [
                self._log_derivative * sum(np.float32(r) * g for r, g in zip(rates, gaussians, strict=True))
                for rates in profile.rates.T
            ]
        objects = [self._transfer]
        if self.target.kind != "pinhole":
            objects = [self._transfer * spectrum for spectrum in self._corner_spectra(angles)]
        return [objects[0] * blur for blur in blurs] + [by_angle * blurs[0] for by_angle in objects[1:]]

    def read(
        self, samples: Sequence[Values], squared_widths: Array, angles: Array, *, derivatives: bool, threads: int = 0
    ) -> list[Values]:
        """Return images and their derivatives, each of shape (r, height, width).

        1. Images from each array in `samples`: PSFs (r, ...), and any derivatives of the PSFs. 2. If `derivatives`,
        derivatives of the first image by the `squared_widths` (r, b) of the blur, pixels^2. 3. Derivatives of the
        first image by the `angle_count` (r, a).
        """
        count = len(samples) + (self.blur.unknown if derivatives else 0) + self.target.angle_count
        images: list[Values] = [np.empty((len(squared_widths), *self._window), np.float32) for _ in range(count)]

        def read_one(k: int) -> None:
            transfer, *transfer_derivatives = self._spectra(squared_widths[k], angles[k], derivatives=derivatives)
            sample_spectra = [
                scipy.fft.rfft2(np.asarray(values[k], np.float32), self._fft_sides) for values in samples
            ]
            spectra = [transfer * spectrum for spectrum in sample_spectra]
            spectra += [sample_spectra[0] * derivative for derivative in transfer_derivatives]
            for image, spectrum in zip(images, spectra, strict=True):
                fine_image = scipy.fft.irfft2(spectrum, self._fft_sides)
                step = self._samples_per_pixel
                image[k] = fine_image[tuple(slice(0, side * step, step) for side in self._window)]

        side_by_side(read_one, range(len(squared_widths)), threads)
        return images


def _edge(distance: Values, sign: Values | float) -> tuple[Values, Values, Values]:
    """Return e, g, g1 (module docstring) of an edge at a distance in standard deviations of the narrow Gaussian."""
    density = np.exp(-0.5 * distance * distance) * (sign / math.sqrt(2.0 * math.pi))
    return sign * scipy.special.erf(distance * math.sqrt(0.5)), density, distance * density


def start_of_crossing(image: Array) -> tuple[float, float, float, float]:
    """Return initial estimates of a crossing: row and column relative to the middle pixel, and two angles."""
    height, width = image.shape
    y, x = (np.arange(side) - side // 2 for side in (height, width))
    x, y = x[None].astype(float), y[:, None].astype(float)
    window = np.exp(-0.5 * (x**2 + y**2) / (0.3 * min(height, width)) ** 2)
    # Matched filter. Patterns are odd about each edge: the median, a level between black and white, is subtracted.
    contrast = image - np.median(image)
    patterns = []
    for angle in np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS:
        p, q = x * math.cos(angle) + y * math.sin(angle), y * math.cos(angle) - x * math.sin(angle)
        pattern = np.tanh(p) * np.tanh(q) * window
        # The filter must not respond to a uniform image.
        patterns.append(pattern - pattern.mean())
    pattern_stack = np.array(patterns)
    # Zero padding to twice the sides: the correlation must not wrap around.
    size = [scipy.fft.next_fast_len(2 * side, real=True) for side in (height, width)]
    correlation = scipy.fft.irfft2(
        scipy.fft.rfft2(contrast, size) * np.conj(scipy.fft.rfft2(pattern_stack, size)), size
    )
    largest_shift = [max(2, side // 5) for side in (height, width)]
    rows, columns = (np.arange(-n, n + 1) for n in largest_shift)
    central_correlation = correlation[:, rows[:, None], columns]
    direction, row, column = np.unravel_index(int(central_correlation.argmax()), central_correlation.shape)
    angle = math.pi * direction / _DIRECTIONS
    return float(rows[row]), float(columns[column]), angle, angle + 0.5 * math.pi


def relative_light(electrons: Array, valid: NDArray[np.bool_], u: Array, v: Array) -> Array:
    """Return the illumination of each pixel divided by that in the middle of its window, shape of `electrons`.

    `electrons` and `valid` have the shape (windows, exposures, height, width). `u` (windows, width) and `v` (windows,
    height) are positions of pixels on the sensor, from -1 to 1. The logarithm of the illumination is a polynomial in
    u and v, of the highest degree up to 4 for which there are at least 1.5 windows per coefficient.
    """
    count, exposures, height, width = electrons.shape
    degree = highest_degree(_LIGHT_DEGREE, 4 * count // 3)
    illumination = np.ones(electrons.shape)
    if degree == 0:
        return illumination
    powers = monomials(np.repeat(u[:, None], height, axis=1), np.repeat(v[:, :, None], width, axis=2), degree)
    for e in range(exposures):
        is_white = np.array([_white_pixels(*pair) for pair in zip(electrons[:, e], valid[:, e], strict=True)])
        basis, log_light = powers[is_white], np.log(electrons[:, e][is_white])
        if np.linalg.matrix_rank(basis) < basis.shape[1]:
            continue
        weight = np.ones(len(log_light))
        # Robust fit with the weights of Geman and McClure: dirt and uneven print are outliers.
        for _ in range(_LIGHT_ITERATIONS):
            root = np.sqrt(weight)
            coefficients = np.linalg.lstsq(root[:, None] * basis, root * log_light, rcond=None)[0]
            distance = np.abs(log_light - basis @ coefficients)
            weight = 1.0 / (1.0 + (distance / max(3.0 * float(np.median(distance)), 1e-6)) ** 2) ** 2
        log_illumination = powers @ coefficients
        illumination[:, e] = np.exp(log_illumination - log_illumination[:, height // 2, width // 2, None, None])
    return illumination


def _white_pixels(image: Array, valid: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return a mask of the pixels in white squares away from edges; all False if these are too few."""
    dark_level, bright_level = np.percentile(image[valid], [5.0, 95.0])
    is_bright = scipy.ndimage.median_filter(image, size=3, mode="nearest") > 0.5 * (dark_level + bright_level)
    is_white = (
        scipy.ndimage.binary_erosion(is_bright, iterations=_EDGE_PIXELS, border_value=True) & valid & (image > 0.0)
    )
    return is_white if is_white.sum() >= _MIN_WHITE else np.zeros_like(is_white)
