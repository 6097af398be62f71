"""Tables of the images of a molecule: interpolation of the image at any position, with a proven error bound.

Along z a table has piecewise Chebyshev series: the range of z is divided into pieces, with a series in each of them.
As a function of the stage position z, an image is a sum of waves ``exp(i w z)`` with ``abs(w) <= k (n_i - sqrt(n_i^2
- NA^2))``; k is the wavenumber in vacuum, n_i the index of the immersion, and the sum of the moduli of the waves is
at most the collected light. As a function of the depth d, an image is a sum of waves ``exp(i k n_s d (c - c'*))``
divided by the collected light; n_s is the index of the sample, and c, c' are cosines of angles in the sample,
imaginary beyond the critical angle. The collected light decreases with d because light beyond the critical angle
decays. These functions are analytic and bounded on ellipses in the complex plane. This yields a bound on the error of
the series (L. N. Trefethen, Approximation Theory and Approximation Practice, theorem 8.2). A plane is an image at one
position z.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.units import format_length
from lommel.core import engine
from lommel.core.answers import not_met
from lommel.optics.grid import Grid
from lommel.optics.layers import debye
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.psf import psf
from lommel.special import interpolation

Floats = NDArray[np.float32]
_MIN_SIDE, _MAX_SIDE, _MAX_REACH = 5, 64, 16.0
_BAND = 1.75  # largest band limit of images, radians per sample
_BLOCK_SAMPLES = 40000  # number of samples that are computed together
_MAX_BYTES = 1 << 28
_EPS = 2.0**-24  # unit roundoff of float32
# Number of rounding errors of each term of a series along z: from storing it, from the product with a stored
# polynomial, and from sums (which start at the last term). The first polynomial is 1.
_TERM_ROUNDINGS = np.array([2.0, *np.arange(5.0, engine.MoleculeTable.terms + 4.0)])
_MAX_PLANES, _MAX_PIECES = 400, 200  # largest numbers of planes at which images are computed, and of pieces
_CACHED = ("_fitter", "_rival", "_changes")  # attributes that fits and checks add
_INNER = 24  # number of Chebyshev points in a piece
# Ellipses on which functions are bounded have the semi-axes cosh(eta) and sinh(eta), multiplied by half the range.
_ETA = np.geomspace(0.02, 6.0, 300)


class Bounds(NamedTuple):
    """Bounds on an error of images (`value`) and of their derivatives along z, relative to the collected light."""

    value: float
    slope: float


@dataclass(frozen=True)
class Waves:
    """Bounds on intensities of images as functions of complex z, for `along` "z" or "depth" (module docstring).

    Intensities are relative to the light collected from a molecule at the same depth.
    """

    pupil: ObjectivePupil
    along: str

    def at(self, places: Array) -> ObjectivePupil:
        """Return a stack of pupils at stage positions or depths `places`, metres."""
        pupil, zeros = self.pupil, np.zeros(places.shape)
        if self.along == "depth":
            return replace(pupil, depth=places, focus=pupil.focus + zeros, z=pupil.z + zeros)
        return replace(pupil, depth=pupil.depth + zeros, z=places, focus=pupil.focus + (places - pupil.z))

    @cached_property
    def rate(self) -> float:
        """Largest rate of change of a phase difference, radians per metre."""
        layers = self.pupil.layers
        index = layers.immersion if self.along == "z" else layers.sample
        # The extreme rays are those along the axis and at the edge of the aperture (or at the critical angle).
        return layers.wavenumber * (index - math.sqrt(max(0.0, index**2 - layers.NA**2)))

    @cached_property
    def decay_rate(self) -> float:
        """Largest decay rate of intensities with the depth, nepers per metre; 0 along z."""
        layers = self.pupil.layers
        if self.along == "z":
            return 0.0
        # Beyond the critical angle waves decay as exp(-k sqrt(NA^2 - n_s^2) d), and intensities twice as fast.
        return 2.0 * layers.wavenumber * math.sqrt(max(0.0, layers.NA**2 - layers.sample**2))

    def light(self, places: Array) -> Array:
        """Return the light collected at each depth, relative to the light far from the cover glass; 1 along "z"."""
        if self.decay_rate == 0.0:
            return np.ones(places.shape)
        weights = self.pupil.light.shares
        at_depth, far_away = debye.power(self.pupil.layers, places.ravel(), self.pupil.light.model)
        return np.asarray((at_depth @ weights) / float(far_away @ weights)).reshape(places.shape)

    def log_bound(self, low: float, high: float) -> Array:
        """Return logs of bounds on (intensity times :meth:`light`), on the ellipses of `_ETA` for `low` to `high`."""
        half, middle = 0.5 * (high - low), 0.5 * (high + low)
        nearest = middle - half * np.cosh(_ETA)
        # At negative depths, decaying light increases exponentially.
        growth = np.maximum(0.0, -nearest) * self.decay_rate
        return np.asarray(self.rate * half * np.sinh(_ETA) + growth + np.log(self.light(np.maximum(0.0, nearest))))

    def log_bound_of_quotients(self, low: float, high: float) -> Array:
        """Return logs of bounds on intensities, on the ellipses of :meth:`log_bound`; inf if light may be 0 there."""
        # If the phase of decaying light is at most pi / 2, its real part is not negative: the modulus of the light
        # is at least the modulus of the constant part.
        decay_phase = self.decay_rate * 0.5 * (high - low) * np.sinh(_ETA)
        return np.asarray(np.where(decay_phase <= 0.5 * math.pi, self.log_bound(low, high), np.inf))

    @property
    def max_slope(self) -> float:
        """Bound on the sum of moduli of the derivatives of waves, per metre, relative to the collected light."""
        # Derivatives of waves exp((i a - b) d), and of 1 / light, which depends on decaying light only.
        return (self.rate + self.decay_rate) + self.decay_rate


def _tail(log_bounds: Array, count: int) -> Bounds:
    """Return bounds on the error of a Chebyshev series of `count` terms, and on its derivative times half the range.

    `log_bounds` are logarithms of bounds M on the function, for each ellipse of `_ETA`.
    """
    # Sums over k >= count of 2 M exp(-k eta), a bound on the coefficients (Trefethen, theorem 8.1), and of k^2 times
    # this bound for derivatives.
    x = np.exp(-_ETA)
    gap = 1.0 - x
    # The limit of 600 prevents overflow; such ellipses do not yield the smallest bound.
    size = np.exp(np.minimum(log_bounds - count * _ETA, 600.0)) * 2.0
    slope = count**2 / gap + 2.0 * count * x / gap**2 + x * (1.0 + x) / gap**3
    return Bounds(float((size / gap).min()), float((size * slope).min()))


class Pieces(NamedTuple):
    """Piecewise Chebyshev series from values at `places`, the Chebyshev points of the whole range.

    `matrix` (pieces, terms, places) maps values to coefficients (pieces, terms). `error` bounds the error of the
    series for exact values, and `gain` the factor by which errors of the values are amplified.
    """

    places: Array
    matrix: Array
    error: Bounds
    gain: Bounds


def pieces(waves: Waves, low: float, high: float, error: float) -> Pieces:
    """Return series with the fewest pieces for an error of at most `error`; ValueError if there are too many."""
    terms, length = engine.MoleculeTable.terms, high - low
    for count in range(1, _MAX_PIECES + 1):
        half = 0.5 * length / count
        # Along the depth, decaying light is strongest in the first piece, which has the largest bound.
        log_bounds = waves.log_bound_of_quotients(low, low + length / count)
        truncation = _tail(log_bounds, terms)
        # Truncation of the series may cause 90 % of the error, interpolation of the values the remainder.
        if truncation.value <= 0.9 * error:
            break
    else:
        raise ValueError(f"z must span less: a range of {length:.3g} m needs more than {_MAX_PIECES} series")
    whole_bounds = waves.log_bound(low, high)
    for planes in range(terms, _MAX_PLANES):
        if (plane_error := 2.0 * _tail(whole_bounds, planes).value) * terms * 2.0 <= 0.05 * error:
            break
    else:
        raise ValueError(f"z must span less: a range of {length:.3g} m needs more than {_MAX_PLANES} planes")
    # A coefficient of the error of the interpolating polynomial is at most twice this error, because light >= 1.
    interpolation_error = plane_error * 2.0 + _tail(log_bounds, _INNER).value
    value = truncation.value + interpolation_error * terms
    # Derivatives of Chebyshev polynomials are at most k^2 (Markov), divided by half the length of a piece.
    slope = truncation.slope / half + interpolation_error * sum(k * k for k in range(terms)) / half
    matrix = _matrix(waves, low, high, planes, count)
    return Pieces(_nodes(planes, low, high), matrix, Bounds(value, slope), _gains(matrix, half))


def _nodes(count: int, low: float, high: float) -> Array:
    x = np.cos((np.arange(count) + 0.5) * (math.pi / count))[::-1]
    return np.asarray(0.5 * (low + high) + 0.5 * (high - low) * x)


def _series(count: int) -> Array:
    """Return the matrix from values at Chebyshev points to coefficients."""
    angles = (np.arange(count)[::-1] + 0.5) * (math.pi / count)
    matrix = np.cos(np.outer(np.arange(count), angles)) * (2.0 / count)
    # The coefficient of order 0 is the mean of the values.
    matrix[0] *= 0.5
    return matrix


def _matrix(waves: Waves, low: float, high: float, planes: int, pieces: int) -> Array:
    """Return the matrix from values at the planes to coefficients of the pieces.

    A single polynomial, through the values at all planes, is evaluated at the Chebyshev points of each piece.
    """
    vander, series = np.polynomial.chebyshev.chebvander, _series(planes)
    truncated_series = _series(_INNER)[: engine.MoleculeTable.terms]
    length = (high - low) / pieces
    matrices = []
    for k in range(pieces):
        places = _nodes(_INNER, low + k * length, low + (k + 1) * length)
        x = (2.0 * places - (low + high)) / (high - low)
        matrices.append((truncated_series / waves.light(places)) @ vander(x, planes - 1) @ series)
    # The polynomial interpolates the product of intensity and light, which is an entire function of the depth.
    return np.stack(matrices) * waves.light(_nodes(planes, low, high))


def _gains(matrix: Array, half: float) -> Bounds:
    """Return bounds on sums of absolute weights of the values, from evaluation at 8 points per term."""
    terms = matrix.shape[1]
    x = _nodes(8 * terms, -1.0, 1.0)
    values = np.polynomial.chebyshev.chebvander(x, terms - 1)
    derivatives = np.polynomial.chebyshev.chebval(x, np.polynomial.chebyshev.chebder(np.eye(terms), axis=1).T).T
    # Ehlich and Zeller: between 8 n points, the maximum is at most the largest value there, divided by cos(pi / 16).
    factor = 1.0 / math.cos(math.pi / 16.0)
    value, slope = (factor * float(np.abs(basis @ matrix).sum(axis=2).max()) for basis in (values, derivatives))
    return Bounds(value, slope / half)


class _Sampling(NamedTuple):
    """Sampling of images: `step` is the pixel pitch in v = 2 pi NA r / lambda, `per` the samples per pixel."""

    waves: Waves
    taps: interpolation.FilteredTaps
    planes: Pieces
    step: float
    per: int


class Table:
    """Images of a molecule at any position in a range, with derivatives, for :func:`lommel.localize.fit`.

    Images are pixel-integrated, and interpolated from filtered samples of the PSF. An image of 15 x 15 pixels with
    derivatives with respect to row, column and z takes about two microseconds.

    Parameters
    ----------
    pupil : ObjectivePupil
        Pupil of a single plane, by :meth:`lommel.Objective.pupil`, with aberrations and orientation of the emitter.
    shape : int or (int, int), default 15
        Rows and columns of an image, 5 to 64.
    pixel : float
        Pixel pitch on the camera, metres.
    z : (float, float)
        Range, metres: positions of the stage from the origin of the pupil or, with ``along="depth"``, depths below
        the cover glass.
    along : {"z", "depth"}, default "z"
        Meaning of z: position of the stage, for a fixed depth of the emitter; or depth, for a fixed stage.
    reach : float, default 3
        Largest distance of the molecule from the middle of pixel ``(height // 2, width // 2)`` along rows and
        columns, pixels, 0.5 to 16.
    tol : float, default 1e-4
        Tolerance of values, 1e-5 to 0.1, relative to the peak: the largest value of the dimmest plane, with the
        molecule in the middle of a pixel.

    Attributes
    ----------
    pupil, shape, pixel, z, along, reach, tol
        The arguments.
    error_bound : float
        Proven bound on the error of values, relative to the peak (see `tol`); at most `tol`.
    slope_bounds : dict
        Proven bounds on the errors of derivatives with respect to "row" and "column", per pixel, and "z" or "depth",
        per metre; relative to the peak.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, the range of z is too large, or pixels are larger than lambda*N.
    ToleranceError
        If `tol` cannot be met.

    Notes
    -----
    Along rows and columns an image is band-limited to twice the aperture. Filtered samples, two to four per pixel,
    are interpolated by a Kaiser-Bessel kernel (J. I. Jackson et al., IEEE Trans. Med. Imaging 10, 473 (1991),
    doi:10.1109/42.97598), whose error is bounded at all frequencies of the band. Along z images are Chebyshev series
    of 8 terms. Values are stored as float32. See docs/certificate.md, section 19.

    Examples
    --------
    >>> import lommel as lm
    >>> objective = lm.Objective(NA=1.4, magnification=63, immersion=1.518, sample=1.33)
    >>> astigmatism = lm.Wavefront.zernike({6: 0.15}, order="noll")
    >>> pupil = objective.pupil(depth=1e-6, wavelength=600e-9, aberrations=astigmatism)
    >>> table = lm.localize.Table(pupil, shape=15, pixel=6.5e-6, z=(-0.6e-6, 0.6e-6))
    >>> table(7.2, 6.9, 0.1e-6).shape
    (15, 15)
    """

    def __init__(
        self,
        pupil: ObjectivePupil,
        shape: int | tuple[int, int] = 15,
        pixel: float = 6.5e-6,
        *,
        z: tuple[float, float],
        along: str = "z",
        reach: float = 3.0,
        tol: float = 1e-4,
    ) -> None:
        if not isinstance(pupil, ObjectivePupil):
            raise TypeError(f"pupil must be from Objective.pupil, got {validation.shown(pupil)}")
        if pupil.shape or (pupil.aberrations is not None and pupil.aberrations.shape):
            raise ValueError(f"pupil must be a single pupil, got a stack of shape {pupil.shape}; z is a range")
        side = validation.image_shape(shape)
        if min(side) < _MIN_SIDE or max(side) > _MAX_SIDE:
            raise ValueError(f"shape must be {_MIN_SIDE} to {_MAX_SIDE} pixels a side, 15 is usual, got {side}")
        self.pupil, self.shape = pupil, side
        self.pixel = validation.pixel(pixel, metric=True)
        self.along = validation.choice("along", along, ("z", "depth"))
        self.reach = validation.real("reach", reach, least=0.5, most=_MAX_REACH)
        self.tol = validation.real("tol", tol, least=1e-5, most=0.1)
        ends = validation.real_array("z", z, unit="metres")
        if ends.shape != (2,) or not 1e-9 <= ends[1] - ends[0] <= 1e-4:
            stated = " and ".join(map(format_length, ends.tolist())) if ends.shape == (2,) else validation.shown(z)
            raise ValueError(f"z must be (lowest, highest) in metres, 1 nm to 100 um apart, got {stated}")
        low, high = ends.tolist()
        if self.along == "depth" and low < 0.0:
            raise ValueError(f"z must be depths >= 0 metres with along='depth', got {format_length(low)}")
        self.z = (low, high)
        smallest, largest = ([side // 2 + sign * self.reach for side in self.shape] for sign in (-1.0, 1.0))
        self.limits = np.array([[*smallest, low], [*largest, high]])  # smallest and largest row, column and z
        self._build()

    def __getstate__(self) -> dict[str, Any]:
        """Return the attributes without what is computed from them again (copy, pickle)."""
        return {name: value for name, value in vars(self).items() if name not in ("core", *_CACHED)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Set the attributes."""
        vars(self).update(state)
        self.core = engine.MoleculeTable(**self._parts)

    def _build(self) -> None:
        waves, step = Waves(self.pupil, self.along), Grid(self.shape, self.pixel).step(self.pupil)
        self.rate = waves.rate
        # The band limit of images is twice the band limit of the field.
        per = max(2, math.ceil(2.0 * step / _BAND))
        if per > 4:
            max_pixel = 3.5 * self.pixel / step
            raise ValueError(f"pixel must be at most {max_pixel:.3g} m with this pupil, got {self.pixel:g}")
        self._render = partial(psf, normalize="strehl")
        coarse = self._render(waves.at(np.linspace(*self.z, 9)), self.shape, self.pixel, tol=1e-2, integrate=True)
        # Estimate of the largest value of the dimmest plane, relative to the collected light.
        peak, previous_bound = 0.95 * float(coarse.values.max(axis=(1, 2)).min()), math.inf
        while True:
            # Fractions of the tolerance: 0.2 for the kernel along each axis, 0.15 for the series along z, 0.3 for the
            # samples, and the remainder for rounding.
            allowed = self.tol * peak
            try:
                taps = interpolation.filtered_taps(2.0 * step / per, 0.2 * allowed, per)
                planes = pieces(waves, *self.z, 0.15 * allowed / taps.gain**2)
            except ValueError as failure:
                raise ValueError(f"tol={self.tol:g} cannot be met: {failure}") from None
            exact = 0.3 * allowed / (taps.gain**2 * planes.gain.value)
            actual = self._fill(_Sampling(waves, taps, planes, step, per), exact)
            if self.error_bound <= self.tol:
                return
            if self.error_bound > 0.9 * previous_bound:
                break
            previous_bound = self.error_bound
            # The estimated peak was too large, or rounding errors were larger than assumed: use a smaller peak.
            peak = min(0.7 * peak, 0.95 * actual * self.tol / self.error_bound)
        raise not_met(self.tol, self.error_bound, "the largest value of the dimmest plane", "in single precision")

    def _fill(self, sampling: _Sampling, exact: float) -> float:
        """Compute coefficients and error bounds; return the peak to which the bounds are relative.

        `exact` is the largest allowed error of the samples.
        """
        _, taps, planes, _, per = sampling
        margin = len(taps.filter) - 1
        # First and last row and column of the samples, numbers of rows and columns, and columns of each phase.
        half, middle = taps.taps.size // 2, [side // 2 for side in self.shape]
        first = [-math.ceil(per * (pixel + self.reach)) - half for pixel in middle]
        last = [
            math.ceil(per * (n - 1 - pixel + self.reach)) + half for n, pixel in zip(self.shape, middle, strict=True)
        ]
        rows, columns = (b - a + 1 for a, b in zip(first, last, strict=True))
        phase_columns = math.ceil(columns / per)
        # The length of a row is a multiple of 16 floats, a vector.
        phase_columns += -phase_columns % (16 // math.gcd(16, per))
        shape, center = (rows + 2 * margin, columns + 2 * margin), (margin - first[0], margin - first[1])
        samples, error = self._samples(sampling, shape, center, exact)
        kernel = np.concatenate([taps.filter[:0:-1], taps.filter])
        filtered = scipy.ndimage.correlate1d(scipy.ndimage.correlate1d(samples, kernel, axis=1), kernel, axis=2)
        filtered = filtered[:, margin : margin + rows, margin : margin + columns]
        series = np.einsum("pkz,zyx->pkyx", planes.matrix, filtered, optimize=True)
        # A value is the fraction of the collected light in a pixel, as in lommel.psf.
        light = Grid(self.shape, self.pixel).cell(self.pupil) / (4.0 * math.pi)
        # Sample k of a row belongs to phase k % per; the samples of each phase are stored in separate rows.
        padded = np.zeros((*series.shape[:2], rows, phase_columns * per), np.float32)
        padded[..., :columns] = light * series
        if padded.nbytes > _MAX_BYTES:
            size = f"the table would need {padded.nbytes} bytes, more than {_MAX_BYTES}"
            raise ValueError(f"z must span less, or shape and reach must be smaller: {size}")
        phases = np.swapaxes(padded.reshape(*series.shape[:2], rows, phase_columns, per), -1, -2)
        coefficients = np.concatenate([phases.ravel(), np.zeros(engine.MoleculeTable.beyond, np.float32)])
        self._parts: dict[str, Any] = {
            "coefficients": coefficients,
            "polynomials": np.ascontiguousarray(taps.taps.polynomials[:, : taps.taps.size]),
            "sizes": [len(planes.matrix), rows, per, phase_columns, *self.shape],
            "numbers": [*map(float, first), *self.z, *self.limits[:, :2].T.ravel().tolist()],
        }
        self.core = engine.MoleculeTable(**self._parts)
        sizes = np.abs(series)
        largest = float(sizes.sum(axis=1).max())
        weighted = float(np.einsum("k,pkyx->pyx", _TERM_ROUNDINGS, sizes).max())
        return self._bound(sampling, error, (largest, weighted), light)

    def _samples(
        self, sampling: _Sampling, shape: tuple[int, int], center: tuple[int, int], exact: float
    ) -> tuple[Array, float]:
        """Return samples relative to the collected light, (planes, rows, columns), and a bound on their errors.

        `center` is the row and column of the molecule, and `exact` the largest allowed bound.
        """
        places, pixel = sampling.planes.places, self.pixel / sampling.per
        pupil, block = sampling.waves.at(places), max(1, _BLOCK_SAMPLES // (shape[0] * shape[1]))
        render = partial(self._render, center=tuple(map(float, center)), integrate=False, dtype=np.float64)
        values, error = np.empty((len(places), *shape)), 0.0
        for k in range(0, len(places), block):
            tol = 1e-3
            while True:
                images = render(pupil[k : k + block], shape, pixel, tol=tol)
                assert images.error_bound is not None
                # The error bound is relative to the exact peak, at least (1 - error_bound) times the computed peak:
                # the division is on the safe side.
                error_bound = images.error_bound * float(images.values.max()) / (1.0 - images.error_bound)
                if error_bound <= exact:
                    break
                if tol <= 1e-12:
                    raise not_met(self.tol, error_bound / exact * self.tol, "the largest value of the dimmest plane")
                # Errors are about proportional to the tolerance, which decreases by a factor of two or more.
                tol = max(1e-12, min(0.5 * tol, 0.8 * tol * exact / error_bound))
            values[k : k + block], error = images.values, max(error, error_bound)
        return values, error

    def _bound(self, sampling: _Sampling, error: float, sizes: tuple[float, float], light: float) -> float:
        """Set the error bounds; return the peak to which they are relative.

        `error` is the error of the samples, `sizes` are sums of moduli of coefficients, `light` converts intensities.
        """
        # See docs/certificate.md, section 19. The moduli of waves add up to at most 1, the collected light.
        waves, taps, planes, step, per = sampling
        band, both = 2.0 * step / per, taps.gain**2
        # With the relative error e of the taps along rows and along columns, the total is (1 + e)^2 - 1.
        kernel = (1.0 + taps.error) ** 2 - 1.0
        size, sums, slope_sums = taps.taps.size, taps.taps.gain, taps.taps.slope_gain
        terms = engine.MoleculeTable.terms
        largest, weighted = sizes
        rounding = _EPS * (2 * size + terms + 8) * largest * sums
        # In values, each term is weighted with its number of rounding errors, which is smallest for the middle taps.
        roundings = taps.taps.weighted(2.0 + size - np.maximum(np.arange(size), 1))
        rounded = 1.001 * _EPS * sums * (sums * weighted + 2.0 * roundings * largest)
        half = 0.5 * (self.z[1] - self.z[0]) / len(planes.matrix)
        value = kernel + both * (planes.error.value + planes.gain.value * error) + rounded
        tap_slope_error = (1.0 + taps.error) * taps.slope_error + band * taps.error
        sample_error = taps.slope_gain * taps.gain * (planes.error.value + planes.gain.value * error)
        lateral_slope = per * (tap_slope_error + sample_error + rounding * slope_sums)
        z_slope = waves.max_slope * kernel + both * (planes.error.slope + planes.gain.slope * error)
        z_slope += rounding * sums * (terms - 1) ** 2 / half
        # Peak of the dimmest of many planes, with the molecule in the middle of a pixel.
        row, column = (side // 2 for side in self.shape)
        images = np.asarray(self(row, column, np.linspace(*self.z, 4 * terms * len(planes.matrix) + 1)))
        peak = float(images.max(axis=(1, 2)).min()) / light - value
        if peak <= 0.0:
            self.error_bound, self.slope_bounds = math.inf, {}
            return max(peak, 0.0)
        self.error_bound = value / peak
        self.slope_bounds = {"row": lateral_slope / peak, "column": lateral_slope / peak, self.along: z_slope / peak}
        return peak

    def __call__(
        self, row: ArrayLike, column: ArrayLike, z: ArrayLike, *, derivatives: bool = False
    ) -> Floats | tuple[Floats, dict[str, Floats]]:
        """Return the images of molecules.

        Parameters
        ----------
        row, column : array_like
            Position of the molecule, pixels; 0 is the middle of the first pixel, like `center` of :func:`lommel.psf`.
        z : array_like
            Position of the stage, or depth, metres. Arrays `row`, `column` and `z` broadcast.
        derivatives : bool, default False
            Also return derivatives.

        Returns
        -------
        values : ndarray of float32, shape ``(..., height, width)``
            The fraction of the collected light in each pixel, like :func:`lommel.psf` with ``normalize="energy"``.
        slopes : dict of ndarray
            Only if `derivatives`: derivatives by "row" and "column", per pixel, and by "z" or "depth", per metre.

        Raises
        ------
        TypeError, ValueError
            If a position is outside the range of the table.
        """
        names, limits = ("row", "column", "z"), self.limits
        units = ("pixels", "pixels", "metres")
        arrays = [
            validation.real_array(name, part, unit=unit)
            for name, part, unit in zip(names, (row, column, z), units, strict=True)
        ]
        for name, part, low, high in zip(names, arrays, *limits, strict=True):
            if part.size and not low <= part.min() <= part.max() <= high:
                outside = part.min() if part.min() < low else part.max()
                raise ValueError(f"{name} must be from {low:g} to {high:g}, the range of the table, got {outside:g}")
        validation.truth("derivatives", derivatives)
        parts = validation.broadcast("row, column and z", *arrays)
        places = np.stack([part.ravel() for part in parts], axis=-1).reshape(-1, 3)
        images = self.core.images(np.ascontiguousarray(places), 0)
        values, *slopes = (images[:, k].reshape(*parts[0].shape, *self.shape) for k in range(4))
        return (values, dict(zip(("row", "column", self.along), slopes, strict=True))) if derivatives else values

    def __repr__(self) -> str:
        low, high = (format_length(end, like=max(map(abs, self.z)), digits=3) for end in self.z)
        sides = "x".join(map(str, self.shape))
        return f"<Table of {sides} pixels, {self.along} {low} to {high}, within {self.error_bound:.2g} of the peak>"
