"""Tables of the images of a molecule, from which its image anywhere follows in microseconds with a proven error.

Along z they hold Chebyshev series in pieces, whose errors are proven from the waves that images are made of. Along
the stage an image is a sum of waves ``exp(i w z)``, ``abs(w) <= k (n_i - sqrt(n_i^2 - NA^2))``, whose moduli add up
to at most the light collected; along the depth one of ``exp(i k n_s d (c - c'*))``, over the light there, which falls
as that beyond the critical angle fades. Both are analytic in ellipses, on which they are bounded: L. N. Trefethen,
Approximation Theory and Approximation Practice, theorem 8.2.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import ndimage

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
_LEAST_SIDE, _MOST_SIDE, _MOST_REACH = 5, 64, 16.0
_BAND = 1.75  # largest band limit of images, radians a sample
_AT_ONCE = 40000  # samples computed together
_MOST_BYTES = 1 << 28
_EPS = 2.0**-24  # unit roundoff of float32
# How often each term along z is rounded: stored, times a stored polynomial, and added to all that follow it, the last
# first. The first polynomial is 1.
_OF_TERMS = np.array([2.0, *np.arange(5.0, engine.MoleculeTable.terms + 4.0)])
# Of the planes that values are computed at, and the pieces of the range.
_MOST_PLANES, _MOST_PIECES = 400, 200
_INNER = 24  # Chebyshev points of a piece
_ETA = np.geomspace(0.02, 6.0, 300)  # tried ellipses: semi-axes cosh and sinh of these


class Bounds(NamedTuple):
    """Bounds on an error of images and of their slopes along z, over the collected light."""

    value: float
    slope: float


@dataclass(frozen=True)
class Waves:
    """What images of a pupil are made of along "z" or "depth": how large they are away from the real axis.

    Intensities are over the light collected, as of an :class:`ObjectivePupil`.
    """

    pupil: ObjectivePupil
    along: str

    def at(self, places: Array) -> ObjectivePupil:
        """Return a stack of the pupil at positions along this axis, metres."""
        pupil, still = self.pupil, np.zeros(places.shape)
        if self.along == "depth":
            return replace(pupil, depth=places, focus=pupil.focus + still, z=pupil.z + still)
        return replace(pupil, depth=pupil.depth + still, z=places, focus=pupil.focus + (places - pupil.z))

    @cached_property
    def rate(self) -> float:
        """Largest rate of a phase difference, radians a metre."""
        layers = self.pupil.layers
        index = layers.immersion if self.along == "z" else layers.sample
        # The phase rates of the extreme rays: along the axis and at the edge of the aperture (or the critical angle).
        return layers.wavenumber * (index - math.sqrt(max(0.0, index**2 - layers.NA**2)))

    @cached_property
    def fading(self) -> float:
        """Largest rate at which light fades with the depth, nepers a metre; 0 along z."""
        layers = self.pupil.layers
        if self.along == "z":
            return 0.0
        # Beyond the critical angle waves decay with exp(-k sqrt(NA^2 - n_s^2) d); their products twice as fast.
        return 2.0 * layers.wavenumber * math.sqrt(max(0.0, layers.NA**2 - layers.sample**2))

    def light(self, places: Array) -> Array:
        """Return the collected light at positions, over that far from the glass; 1 along z."""
        if self.fading == 0.0:
            return np.ones(places.shape)
        shares = self.pupil.light.shares
        near, far = debye.power(self.pupil.layers, places.ravel(), self.pupil.light.model)
        return np.asarray((near @ shares) / float(far @ shares)).reshape(places.shape)

    def most(self, low: float, high: float) -> Array:
        """Return the logarithm of the bound of intensities times :meth:`light` on ellipses around `low` to `high`."""
        half, middle = 0.5 * (high - low), 0.5 * (high + low)
        nearest = middle - half * np.cosh(_ETA)
        # Above the glass fading light grows.
        above = np.maximum(0.0, -nearest) * self.fading
        return np.asarray(self.rate * half * np.sinh(_ETA) + above + np.log(self.light(np.maximum(0.0, nearest))))

    def most_of_quotients(self, low: float, high: float) -> Array:
        """Return the logarithm of the bound of intensities there; infinite where light might be 0."""
        # Where what fades turns by less than a quarter its real part is positive, and light at least what stays.
        turned = self.fading * 0.5 * (high - low) * np.sinh(_ETA)
        return np.asarray(np.where(turned <= 0.5 * math.pi, self.most(low, high), np.inf))

    @property
    def steepest(self) -> float:
        """Bound on the sum of moduli of the derivative, 1 / metre, over the collected light."""
        # Of waves exp((i a - b) d), and of 1 over the light, which changes by the part that fades.
        return (self.rate + self.fading) + self.fading


def _tail(most: Array, count: int) -> Bounds:
    """Return bounds on the sum of Chebyshev coefficients from `count` on, and of slopes over half the length."""
    # |a_k| <= 2 M exp(-k eta) (Trefethen, theorem 8.1): geometric sums of it, and of k^2 times it for slopes.
    x = np.exp(-_ETA)
    left = 1.0 - x
    # 600 keeps the exponential from overflowing; such ellipses are of no use.
    size = np.exp(np.minimum(most - count * _ETA, 600.0)) * 2.0
    slope = count**2 / left + 2.0 * count * x / left**2 + x * (1.0 + x) / left**3
    return Bounds(float((size / left).min()), float((size * slope).min()))


class Pieces(NamedTuple):
    """Chebyshev series in pieces from values at `places`, whole-range Chebyshev points.

    Coefficients (pieces, terms) are `matrix` times values, shape (pieces, terms, places); errors of what they are of
    exact values, and what errors of values grow by in images and slopes.
    """

    places: Array
    matrix: Array
    error: Bounds
    gain: Bounds


def pieces(waves: Waves, low: float, high: float, error: float) -> Pieces:
    """Return the fewest pieces with an error of at most `error`; ValueError if too many are needed."""
    terms, length = engine.MoleculeTable.terms, high - low
    for count in range(1, _MOST_PIECES + 1):
        half = 0.5 * length / count
        # Along the depth light of the first piece fades, and grows above it, most.
        most = waves.most_of_quotients(low, low + length / count)
        local = _tail(most, terms)
        # The truncated series may take 90 % of the error, what it is interpolated from the rest.
        if local.value <= 0.9 * error:
            break
    else:
        raise ValueError(f"z must span less: {length:.3g} m take more than {_MOST_PIECES} pieces")
    whole = waves.most(low, high)
    for planes in range(terms, _MOST_PLANES):
        if (first := 2.0 * _tail(whole, planes).value) * terms * 2.0 <= 0.05 * error:
            break
    else:
        raise ValueError(f"z must span less: {length:.3g} m take more than {_MOST_PLANES} planes")
    # Coefficients of what the interpolating polynomial is off by are at most twice that, light being at least 1.
    through = first * 2.0 + _tail(most, _INNER).value
    value = local.value + through * terms
    # |T_k'| <= k^2 on the interval (Markov), over half the length of a piece.
    slope = local.slope / half + through * sum(k * k for k in range(terms)) / half
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
    """Return the matrix from values at the planes to coefficients of the pieces, through one polynomial."""
    vander, whole = np.polynomial.chebyshev.chebvander, _series(planes)
    cut = _series(_INNER)[: engine.MoleculeTable.terms]
    length = (high - low) / pieces
    made = []
    for k in range(pieces):
        inner = _nodes(_INNER, low + k * length, low + (k + 1) * length)
        x = (2.0 * inner - (low + high)) / (high - low)
        made.append((cut / waves.light(inner)) @ vander(x, planes - 1) @ whole)
    # The polynomial is that of intensity times light, which is entire along the depth, too.
    return np.stack(made) * waves.light(_nodes(planes, low, high))


def _gains(matrix: Array, half: float) -> Bounds:
    """Return the largest sums of absolute weights of the values, from polynomials at four times as many points."""
    terms = matrix.shape[1]
    x = _nodes(8 * terms, -1.0, 1.0)
    values = np.polynomial.chebyshev.chebvander(x, terms - 1)
    slopes = np.polynomial.chebyshev.chebval(x, np.polynomial.chebyshev.chebder(np.eye(terms), axis=1).T).T
    # Ehlich and Zeller: the largest value between 8 n points is at most that at them over cos(pi / 16).
    between = 1.0 / math.cos(math.pi / 16.0)
    value, slope = (between * float(np.abs(at @ matrix).sum(axis=2).max()) for at in (values, slopes))
    return Bounds(value, slope / half)


class _Sampling(NamedTuple):
    """Sampling: waves along z, taps along rows and columns, planes, v of a pixel, samples in a pixel."""

    waves: Waves
    taps: interpolation.FilteredTaps
    planes: Pieces
    step: float
    per: int


class Table:
    """Images of a molecule by a microscope objective, for any place in a range, with their slopes.

    Interpolates samples of the PSF, filtered so that pixels are averages over their area: 15 x 15 pixels with slopes
    by row, column and z take about two microseconds. For :func:`lommel.localize.fit`.

    Parameters
    ----------
    pupil : ObjectivePupil
        Of one plane, by :meth:`lommel.Objective.pupil`, aberrations and orientation of the emitter included.
    shape : int or (int, int), default 15
        Pixels of an image, 5 to 64 a side: smaller ones do not hold the image of a molecule.
    pixel : float
        Pixel pitch on the camera, metres.
    z : (float, float)
        Range, metres: positions of the stage from the origin of the pupil or, with ``along="depth"``, depths below
        the glass.
    along : {"z", "depth"}, default "z"
        What z is: the position of the stage, the emitter's depth fixed; or the depth, the stage fixed.
    offset : float, default 0
        For the second camera of a biplane, metres, up to 10 um either way: the image of a molecule at z is that of
        the pupil with the stage at ``z + offset``; along the depth, with the stage moved by it.
    reach : float, default 3
        How far the molecule may be from the middle of pixel ``(height // 2, width // 2)`` along rows and columns,
        pixels, 0.5 to 16.
    tol : float, default 1e-4
        Tolerance of values, 1e-5 to 0.1, over the largest value of the dimmest plane with the molecule in the middle
        of a pixel.
    threads : int, optional
        Maximum number of threads; by default the number of processors.

    Attributes
    ----------
    pupil, shape, pixel, z, along, reach, tol
        As the arguments; the pupil with the stage moved by the offset.
    error_bound : float
        Proven bound on the error of values, over the same value as `tol`; at most `tol`.
    slope_bounds : dict
        The same of slopes by "row" and "column", per pixel, and by "z" or "depth", per metre.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, if z spans too much, or pixels are larger than lambda*N.
    ToleranceError
        If `tol` cannot be met.

    Notes
    -----
    Along rows and columns an image has no frequencies beyond twice the aperture: filtered samples, two to four a
    pixel, are interpolated by a Kaiser-Bessel kernel (J. I. Jackson et al., IEEE Trans. Med. Imaging 10, 473 (1991),
    doi:10.1109/42.97598), whose error is judged at all frequencies. Along z there are Chebyshev series of 8
    terms. Values are stored as float32. See docs/certificate.md, section 19.

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
        offset: float = 0.0,
        reach: float = 3.0,
        tol: float = 1e-4,
        threads: int | None = None,
    ) -> None:
        moved = validation.real("offset", offset, least=-1e-5, most=1e-5)
        if not isinstance(pupil, ObjectivePupil):
            raise TypeError(f"pupil must be one of an Objective (Objective.pupil), got {validation.shown(pupil)}")
        if pupil.shape or (pupil.aberrations is not None and pupil.aberrations.shape):
            raise ValueError(f"pupil must be of one plane, got a stack of shape {pupil.shape}; z makes the planes")
        side = validation.image_shape(shape)
        if min(side) < _LEAST_SIDE or max(side) > _MOST_SIDE:
            raise ValueError(f"shape must be {_LEAST_SIDE} to {_MOST_SIDE} pixels a side, 15 is usual, got {side}")
        self.pupil, self.shape = replace(pupil, focus=pupil.focus + moved), side
        self.pixel = validation.pixel(pixel, metric=True)
        self.along = validation.choice("along", along, ("z", "depth"))
        self.reach = validation.real("reach", reach, least=0.5, most=_MOST_REACH)
        self.tol = validation.real("tol", tol, least=1e-5, most=0.1)
        ends = validation.real_array("z", z)
        if ends.shape != (2,) or not 1e-9 <= ends[1] - ends[0] <= 1e-4:
            given = " and ".join(map(format_length, ends.tolist())) if ends.shape == (2,) else validation.shown(z)
            raise ValueError(f"z must be (lowest, highest) in metres, 1 nm to 100 um apart, got {given}")
        low, high = ends.tolist()
        if self.along == "depth" and low < 0.0:
            raise ValueError(f"z must be depths >= 0 metres with along='depth', got {format_length(low)}")
        self.z = (low, high)
        first, last = ([side // 2 + sign * self.reach for side in self.shape] for sign in (-1.0, 1.0))
        self.limits = np.array([[*first, low], [*last, high]])  # least and largest row, column and z of places
        self._make(0 if threads is None else validation.integer("threads", threads, least=1, most=1024))

    def _make(self, threads: int) -> None:
        waves, step = Waves(self.pupil, self.along), Grid(self.shape, self.pixel).step(self.pupil)
        self.rate = waves.rate  # radians per metre: the fastest change along z of what images are made of
        # Images have twice the band of the field.
        per = max(2, math.ceil(2.0 * step / _BAND))
        if per > 4:
            most = 3.5 * self.pixel / step
            raise ValueError(f"pixel must be at most {most:.3g} m with this pupil, got {self.pixel:g}")
        self._render = partial(psf, normalize="strehl", threads=threads or None)
        rough = self._render(waves.at(np.linspace(*self.z, 9)), self.shape, self.pixel, tol=1e-2, integrate=True)
        # About the largest average of the dimmest plane, over the light collected as intensities are.
        peak, before = 0.95 * float(rough.values.max(axis=(1, 2)).min()), math.inf
        while True:
            # Shares of the kernel twice, of the planes, and of samples; what is stored has the rest.
            allowed = self.tol * peak
            try:
                taps = interpolation.filtered_taps(2.0 * step / per, 0.2 * allowed, per)
                planes = pieces(waves, *self.z, 0.15 * allowed / taps.gain**2)
            except ValueError as failure:
                raise ValueError(f"tol={self.tol:g} cannot be met: {failure}") from None
            exact = 0.3 * allowed / (taps.gain**2 * planes.gain.value)
            made = self._filled(_Sampling(waves, taps, planes, step, per), exact)
            if self.error_bound <= self.tol:
                return
            if self.error_bound > 0.9 * before:
                break
            before = self.error_bound
            # The peak that was aimed at was too high, or rounding took more than its share: the aim becomes smaller.
            peak = min(0.7 * peak, 0.95 * made * self.tol / self.error_bound)
        raise not_met(self.tol, self.error_bound, "the largest value of the dimmest plane", "in single precision")

    def _filled(self, sampling: _Sampling, exact: float) -> float:
        """Compute the coefficients and their bounds; return the peak that these are relative to."""
        _, taps, planes, _, per = sampling
        margin = len(taps.filter) - 1
        # The first row and column that are needed, how many of each, and columns of each phase.
        half, middle = taps.taps.size // 2, [side // 2 for side in self.shape]
        first = [-math.ceil(per * (at + self.reach)) - half for at in middle]
        last = [math.ceil(per * (n - 1 - at + self.reach)) + half for n, at in zip(self.shape, middle, strict=True)]
        rows, columns = (b - a + 1 for a, b in zip(first, last, strict=True))
        wide = math.ceil(columns / per)
        # Rows of whole vectors of 16 floats.
        wide += -wide % (16 // math.gcd(16, per))
        shape, center = (rows + 2 * margin, columns + 2 * margin), (margin - first[0], margin - first[1])
        samples, error = self._samples(sampling, shape, center, exact)
        whole = np.concatenate([taps.filter[:0:-1], taps.filter])
        filtered = ndimage.correlate1d(ndimage.correlate1d(samples, whole, axis=1), whole, axis=2)
        filtered = filtered[:, margin : margin + rows, margin : margin + columns]
        series = np.einsum("pkz,zyx->pkyx", planes.matrix, filtered, optimize=True)
        # A value is the light of a pixel over all that is collected, as of lommel.psf.
        light = Grid(self.shape, self.pixel).cell(self.pupil) / (4.0 * math.pi)
        # Neighbouring samples of a row in different phases, in rows of whole vectors.
        padded = np.zeros((*series.shape[:2], rows, wide * per), np.float32)
        padded[..., :columns] = light * series
        if padded.nbytes > _MOST_BYTES:
            large = f"the table would take {padded.nbytes} bytes"
            raise ValueError(f"z must span less, or shape and reach be smaller: {large}")
        phases = np.swapaxes(padded.reshape(*series.shape[:2], rows, wide, per), -1, -2)
        flat = np.concatenate([phases.ravel(), np.zeros(engine.MoleculeTable.beyond, np.float32)])
        self._parts: dict[str, Any] = {
            "coefficients": flat,
            "polynomials": np.ascontiguousarray(taps.taps.polynomials[:, : taps.taps.size]),
            "sizes": [len(planes.matrix), rows, per, wide, *self.shape],
            "numbers": [*map(float, first), *self.z, *self.limits[:, :2].T.ravel().tolist()],
        }
        self.core = engine.MoleculeTable(**self._parts)
        sizes = np.abs(series)
        largest = float(sizes.sum(axis=1).max())
        summed = float(np.einsum("k,pkyx->pyx", _OF_TERMS, sizes).max())
        return self._bound(sampling, error, (largest, summed), light)

    def _samples(
        self, sampling: _Sampling, shape: tuple[int, int], center: tuple[int, int], exact: float
    ) -> tuple[Array, float]:
        """Return samples over the light collected, (planes, rows, columns), and a bound on their errors.

        `center` is that of the molecule.
        """
        places, pixel = sampling.planes.places, self.pixel / sampling.per
        pupil, at_once = sampling.waves.at(places), max(1, _AT_ONCE // (shape[0] * shape[1]))
        render = partial(self._render, center=tuple(map(float, center)), integrate=False, dtype=np.float64)
        values, error = np.empty((len(places), *shape)), 0.0
        for k in range(0, len(places), at_once):
            tol = 1e-3
            while True:
                made = render(pupil[k : k + at_once], shape, pixel, tol=tol)
                assert made.error_bound is not None
                # The bound is over the exact peak, which may be less than the computed one by the error itself.
                off = made.error_bound * float(made.values.max()) / (1.0 - made.error_bound)
                if off <= exact:
                    break
                if tol <= 1e-12:
                    raise not_met(self.tol, off / exact * self.tol, "the largest value of the dimmest plane")
                # Errors go about with the tolerance; at least a factor of two each time.
                tol = max(1e-12, min(0.5 * tol, 0.8 * tol * exact / off))
            values[k : k + at_once], error = made.values, max(error, off)
        return values, error

    def _bound(self, sampling: _Sampling, error: float, sizes: tuple[float, float], light: float) -> float:
        """Set the bounds; return the peak that they are relative to."""
        # docs/certificate.md, section 19. Intensities are over the light collected: all moduli add up to at most 1.
        waves, taps, planes, step, per = sampling
        band, both = 2.0 * step / per, taps.gain**2
        # Taps along rows and along columns: (1 + e)^2 - 1.
        kernel = (1.0 + taps.error) ** 2 - 1.0
        size, sums, moves = taps.taps.size, taps.taps.gain, taps.taps.slope_gain
        terms = engine.MoleculeTable.terms
        largest, summed = sizes
        rounding = _EPS * (2 * size + terms + 8) * largest * sums
        # Of values each term counts as often as it is rounded: the middle taps, which are the largest, half as often.
        often = taps.taps.weighted(2.0 + size - np.maximum(np.arange(size), 1))
        rounded = 1.001 * _EPS * sums * (sums * summed + 2.0 * often * largest)
        half = 0.5 * (self.z[1] - self.z[0]) / len(planes.matrix)
        value = kernel + both * (planes.error.value + planes.gain.value * error) + rounded
        moved = (1.0 + taps.error) * taps.slope_error + band * taps.error
        across = taps.slope_gain * taps.gain * (planes.error.value + planes.gain.value * error)
        lateral = per * (moved + across + rounding * moves)
        steep = waves.steepest * kernel + both * (planes.error.slope + planes.gain.slope * error)
        steep += rounding * sums * (terms - 1) ** 2 / half
        # The dimmest of many planes, the molecule in the middle of a pixel.
        row, column = (side // 2 for side in self.shape)
        images = np.asarray(self(row, column, np.linspace(*self.z, 4 * terms * len(planes.matrix) + 1)))
        peak = float(images.max(axis=(1, 2)).min()) / light - value
        if peak <= 0.0:
            self.error_bound, self.slope_bounds = math.inf, {}
            return max(peak, 0.0)
        self.error_bound = value / peak
        self.slope_bounds = {"row": lateral / peak, "column": lateral / peak, self.along: steep / peak}
        return peak

    def __call__(
        self, row: ArrayLike, column: ArrayLike, z: ArrayLike, *, derivatives: bool = False
    ) -> Floats | tuple[Floats, dict[str, Floats]]:
        """Return images of molecules at places.

        Parameters
        ----------
        row, column : array_like
            Of the molecule, pixels, 0 being the middle of the first pixel, as `center` of :func:`lommel.psf`.
        z : array_like
            Metres: position of the stage, or depth. All three broadcast.
        derivatives : bool, default False
            Whether to return derivatives, too.

        Returns
        -------
        values : ndarray of float32, shape ``(..., height, width)``
            The fraction of the collected light in each pixel, as of :func:`lommel.psf` with ``normalize="energy"``.
        slopes : dict of ndarray
            With `derivatives`: those by "row" and "column", per pixel, and by "z" or "depth", per metre.

        Raises
        ------
        TypeError, ValueError
            If a place is not within the table.
        """
        names, limits = ("row", "column", "z"), self.limits
        given = [validation.real_array(name, part) for name, part in zip(names, (row, column, z), strict=True)]
        for name, part, low, high in zip(names, given, *limits, strict=True):
            if part.size and not low <= part.min() <= part.max() <= high:
                at = part.min() if part.min() < low else part.max()
                raise ValueError(f"{name} must be {low:g} to {high:g} with this table, got {at:g}")
        validation.truth("derivatives", derivatives)
        parts = validation.broadcast("row, column and z", *given)
        places = np.stack([part.ravel() for part in parts], axis=-1).reshape(-1, 3)
        made = self.core.images(np.ascontiguousarray(places), 0)
        values, *slopes = (made[:, k].reshape(*parts[0].shape, *self.shape) for k in range(4))
        return (values, dict(zip(("row", "column", self.along), slopes, strict=True))) if derivatives else values

    def __repr__(self) -> str:
        low, high = (format_length(end, like=max(map(abs, self.z)), digits=3) for end in self.z)
        sides = "x".join(map(str, self.shape))
        return f"<Table of {sides} pixels, {self.along} {low} to {high}, within {self.error_bound:.2g} of the peak>"
