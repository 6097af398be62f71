"""Calibration of lenses for depth from defocus: f-number and foci from planes at known distances.

At the true depth the residual of two frames, each filtered by the transfer function of the other, is noise. Here the
depth is known and the lens is not: the estimate minimises the sum over tiles of log(energy / energy of noise), the
likelihood of residuals whose variance is unknown in each tile. Strong texture, which shows errors of the model
(sharpening, glare, compression) best, counts no more than its tile. The filters are exact and act on whole frames, by
cosine transforms. Standard errors are those of the sandwich H^-1 V H^-1, with V from the scatter of the gradients of
tiles (Huber 1967, White 1982, doi:10.2307/1912526).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from os import PathLike
from typing import Literal, NamedTuple

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import atomic, reading, validation
from lommel.base.arrays import Array, Json
from lommel.base.encoding import Encoding
from lommel.base.units import format_length, percent, with_error
from lommel.estimation.focal_model import FocalLight, Spectrum, transfer_curve
from lommel.fit.findings import Finding, Findings, FitReport, untested_finding
from lommel.imaging.defocus_depth import counts_in_electrons, list_photographs
from lommel.imaging.focal_engine import (
    CONTRAST,
    UNMEASURED,
    Magnification,
    Registration,
    checked_magnification,
    processors,
)
from lommel.imaging.frame_phases import frame_scales, frame_shift
from lommel.imaging.pair_noise import is_compressed
from lommel.imaging.settings import channel_spectra, spectra
from lommel.optics.lens import Lens, pixel_of
from lommel.recorded.noise import Noise

_SIDE = 32  # pixels: side of a tile
_LOG = 0.5 * _SIDE**2  # factor of log(energy) in -log(likelihood)
_MIN_TILES = 8  # least number of tiles of a plane
_MIN_SHARE = 0.5  # least share of the pixels of a tile that are used
_BORDER = 16  # pixels between tiles and the border, in addition to the blur radius
_RADII = np.linspace(0.0, math.sqrt(0.5) + 1e-4, 2048)  # cycles per pixel, at which filters are computed
_TABLE_RADII = np.linspace(0.0, 1.4, 4096)  # cycles per pixel, at which transfer functions are tabulated
_LOWEST = 0.012  # cycles per pixel: lower frequencies, of uneven light, are suppressed
_EDGE = 0.3  # pixels: a change of the blur radius by this much, or one radian of defocus, is the unit of shifts
# Shifts of foci that are searched, in these units, and steps of this search and of the table of transfer functions in
# focus; with defocus both grow.
_RANGE, _SCAN, _TABLE, _NEAR = (8.0, 64.0), 0.4, 0.25, 30.0
_PRIORS = 4.0  # shifts that are searched / standard errors of what is stated
_LEAST = 0.01  # least vergence / range of vergences, at which transfer functions are computed
_SCANNED = 128  # number of tiles of a plane in this search
_UNLIKELY_START = 50.0  # -log(likelihood) above that of the best start, from which no lens is refined
# chi2 above that of the likeliest lens, above which another one is excluded; and below which the other order, or the
# plane without which the others agree, is told.
_EVIDENCE, _PLAUSIBLE = 9.0, 25.0
_FAR = 0.01  # relative change of a focus above which another answer is told, and not only part of the errors
_STARTS = 6  # largest number of minima from which lenses are refined
_STEP, _MAX_STEP, _TOLERANCE = 0.01, 2.0, 1e-3  # finite difference, largest step and last step, in these units
# Difference of parameters, in these units, below which lenses are the same; and above which a twin is a start.
_SAME, _TWIN = 0.3, 0.5
_BEYOND = 2.0  # least distance of a plane that is proposed from the foci, in these units
_COARSE = 0.1  # last step of the search by coarse details, in these units
_MAX_STEPS, _GAIN_STEPS = 12, 8  # steps of the search, and of the gain
# Metres: standard error of an origin that is held. Entrance pupils lie 0 to 4 cm behind the front rim of lenses of up
# to 85 mm, which is 2.3 cm rms from the default of 0.
_ORIGIN_ERROR = 0.02
_RULER = 0.5e-3  # metres: standard error of distances, that of a tape read to a millimetre
_PUPIL = 1e-3  # metres: standard error of an origin that is stated
_FLOOR = 0.002  # units: standard error of each plane that tiles do not show
_EXCESS, _CHANGE = 300.0, 0.1  # assumed power of noise of finished photographs / that of `_ASSUMED`, and its change
_MAX_ERROR = 4.0  # units: standard error of the shift of foci above which planes do not determine it
# Standard error of what is stated after calibration / before: above these, planes determine it in part, or hardly.
_PART, _HELD = 0.5, 0.9
_DOUBTFUL, _WRONG = 4.0, 6.0  # deviations, in standard errors
# Deviation of the lens of one plane, of two, and of more from the stated one, standard errors, that is a doubt.
_UNLIKELY = 3.0, 5.0, 10.0
# chi2 by which the likelihood may rise at a saddle, at the standard errors of what is stated.
_SADDLE = 4.0
_MIN_TILT = 0.02  # change of distance across a plane / distance that is not told
_MAX_SHIFT = 0.1  # shift of a focus / its vergence above which exchanged photographs are likelier
_MAX_MISFIT, _WRONG_MISFIT = 1.8, 6.0  # misfits above which the photographs do not follow the noise, and the lens
_MIN_CHANGE = 0.2  # least change of the mean log(energy) of tiles by shifts of the foci
_ASSUMED = Noise(white=5e3, read=3.0)  # for the weights of frequencies, where no noise is stated


def _tiled(values: NDArray[np.generic]) -> NDArray[np.generic]:
    """Return an image as tiles, (rows of tiles, side, columns of tiles, side); the last pixels are left out."""
    height, width = (side // _SIDE for side in values.shape)
    return values[: height * _SIDE, : width * _SIDE].reshape(height, _SIDE, width, _SIDE)


def _filled(images: NDArray[np.float32], valid: NDArray[np.bool_]) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
    """Return frames, (frames, height, width), and known pixels, cropped to these; unknown ones as the nearest known.

    Filters reach far beyond the blur: a border of zeros, as of a magnified frame, would be part of all tiles.
    """
    if not valid.any() or valid.all():
        return images, valid
    known = [np.flatnonzero(valid.any(axis=axis)) for axis in (1, 0)]
    rows, columns = (slice(int(places[0]), int(places[-1]) + 1) for places in known)
    images, valid = images[:, rows, columns], valid[rows, columns]
    if not valid.all():
        row, column = scipy.ndimage.distance_transform_edt(~valid, return_distances=False, return_indices=True)
        images = images[:, row, column]
    return images, valid


def _relative_energies(a: Array, b: Array, c: Array, first: ArrayLike, second: ArrayLike) -> Array:
    """Return mean squares a + 2 g b + g^2 c of tiles (last axis) over those of noise, first + g^2 second.

    g is the likeliest gain of the second frame, found by Newton steps.
    """
    first, second = (np.asarray(noise)[..., None] for noise in (first, second))
    gain = np.ones((*b.shape[:-1], 1))
    for _ in range(_GAIN_STEPS):
        energy, variance = a + gain * (2.0 * b + gain * c), first + gain**2 * second
        slope = ((b + gain * c) / energy).mean(axis=-1, keepdims=True) - gain * second / variance
        mean = (c / energy).mean(axis=-1, keepdims=True) - second / variance
        gain = gain - slope / np.maximum(mean, 0.5 * (mean + second / variance))
    return np.asarray((a + gain * (2.0 * b + gain * c)) / (first + gain**2 * second))


def _spread(ends: ArrayLike, step: float) -> Array:
    """Return numbers between ends, `step` apart where they are below `_NEAR`, and farther apart beyond."""
    low, high = np.arcsinh(np.divide(ends, _NEAR)) * _NEAR
    return np.asarray(_NEAR * np.sinh(np.linspace(low, high, math.ceil((high - low) / step) + 1) / _NEAR))


def _tabulate(lens: Lens, vergences: Array, spectrum: Spectrum, pitch: float) -> scipy.interpolate.CubicSpline:
    """Return the transfer function of a lens at `_TABLE_RADII`, by vergence, which may be negative."""
    # A lens focused nearer has the same transfer functions of nearer planes, in units of the cutoff.
    nearer = max(0.0, _LEAST * float(np.ptp(vergences)) - float(vergences[0]))
    changed = _Changed(lens, 1.0 / lens.focus_distance + nearer, 1.0).lens
    pitch *= changed.sensor_distance / lens.sensor_distance
    parts = np.array_split(vergences, math.ceil(len(vergences) / 16))  # blurs of a part are of similar width
    values = [transfer_curve(changed, part + nearer, spectrum, pitch)(_TABLE_RADII) for part in parts]
    return scipy.interpolate.CubicSpline(vergences, np.concatenate(values), extrapolate=False)


def _scatter(tiles: Array) -> float:
    """Return the variance of gradients / curvature at the minimum of costs, (places, places, tiles), at least 1."""
    costs = tiles.sum(axis=2)
    i, j = (
        min(max(k, 1), side - 2)
        for k, side in zip(np.unravel_index(np.argmin(costs), costs.shape), costs.shape, strict=True)
    )
    ratios = []
    for behind, here, ahead in (
        (tiles[i - 1, j], tiles[i, j], tiles[i + 1, j]),
        (tiles[i, j - 1], tiles[i, j], tiles[i, j + 1]),
    ):
        curvature = max(float((ahead + behind - 2.0 * here).sum()), 1e-9)
        ratios.append(float(np.var(0.5 * (ahead - behind)) * len(here) / curvature))
    return max(1.0, float(np.median(ratios)))


class _Changed(NamedTuple):
    """A lens whose f-number is `scale` times the stated one, and which is focused at the vergence `focus`, 1/m."""

    stated: Lens
    focus: float
    scale: float

    @property
    def lens(self) -> Lens:
        """The lens; its aberrations, in radians at the edge of the aperture, do not change."""
        distance = 1.0 / (1.0 / self.stated.focal_length - self.focus)
        diameter = self.stated.aperture_diameter / self.scale
        return replace(self.stated, sensor_distance=distance, aperture_diameter=diameter)


class _Plane:
    """Spectra of two photographs of a plane, with tiles in which their residual is evaluated."""

    tables: list[
        scipy.interpolate.CubicSpline
    ]  # transfer functions of the stated lenses by vergence, at _TABLE_RADII

    def __init__(self, images: Array, valid: NDArray[np.bool_], distance: float, blur: float, read: float) -> None:
        self.distance = distance
        reach = math.ceil(blur) + _BORDER
        frame = np.pad(np.ones([max(side - 2 * reach, 0) for side in valid.shape], dtype=np.bool_), reach)
        known = scipy.ndimage.minimum_filter(valid, 2 * math.ceil(blur) + 5)
        self._inner = inner = known & frame[: valid.shape[0], : valid.shape[1]]
        shares = _tiled(inner).mean(axis=(1, 3))
        self._tiles = shares >= _MIN_SHARE
        self._shares = shares[self._tiles]
        if np.count_nonzero(self._tiles) < _MIN_TILES:
            raise ValueError(
                f"photographs of the plane at {format_length(distance)} must have {_MIN_TILES} tiles of {_SIDE} x "
                f"{_SIDE} known pixels, {reach} pixels from the border, got {np.count_nonzero(self._tiles)}"
            )
        means = images[:, inner].mean(axis=1)
        if not (means > 0.0).all():
            raise ValueError(f"photographs must have a mean above 0, got {means[0]:.4g} and {means[1]:.4g} electrons")
        self._light = FocalLight(float(means[0]), read, (1.0, float(means[1] / means[0])), CONTRAST)
        self._spectra = scipy.fft.dctn(images * (means[0] / means)[:, None, None], axes=(1, 2), norm="ortho")
        self._f = np.hypot(*np.meshgrid(*(np.arange(side) / (2.0 * side) for side in valid.shape), indexing="ij"))
        edges = [-1.0, *(0.5 * (_RADII[1:] + _RADII[:-1])), 1.0]
        self._density = np.histogram(self._f, edges)[0] / self._f.size
        # Centres of tiles, relative to the middle of the frame, in halves of its diagonal.
        centres = (np.argwhere(self._tiles) + 0.5) * _SIDE - 0.5 * np.array(valid.shape)
        self.places = centres / (0.5 * math.hypot(*valid.shape))

    def _transfer(self, lenses: Sequence[_Changed], vergence: float, f: Array) -> Array:
        """Return transfer functions, (frames, frequencies), without the area of a pixel."""
        result = []
        for (stated, focus, scale), table in zip(lenses, self.tables, strict=True):
            # The same defocus in radians at the radius R / scale of the pupil, and the same fraction of the cutoff.
            place = 1.0 / stated.focus_distance + (vergence - focus) / scale**2
            cutoff = stated.sensor_distance / scale * (1.0 / stated.focal_length - focus)
            result.append(np.interp(f / cutoff, _TABLE_RADII, table(place)))
        return np.array(result)

    def weigh(self, lenses: Sequence[_Changed], vergence: float, excess: float) -> None:
        """Set the weights of frequencies to those of the Wiener filter for lenses and a vergence.

        `excess` is the assumed power of noise / that of the noise of the photographs.
        """
        h = self._transfer(lenses, vergence, _RADII)
        # Two of the four nearest aliases count on an axis.
        beyond = self._transfer(lenses, vergence, 1.0 - _RADII) * np.sinc(1.0 - _RADII)
        noise = self._light.relative_variances()[:, None] + 2.0 * self._light.power(1.0 - _RADII) * beyond**2
        pixel = np.sinc(_RADII / math.sqrt(2.0)) ** 2
        signal = self._light.power(_RADII) / excess * ((h * pixel) ** 2 / noise).sum(axis=0)
        wiener = signal / (1.0 + signal) * -np.expm1(-0.5 * (_RADII / _LOWEST) ** 2)
        self._weights = np.sqrt(wiener / np.maximum((h[::-1] ** 2 * noise).sum(axis=0), 1e-12))

    def energies(self, lenses: Sequence[_Changed], vergence: float) -> Array:
        """Return the mean square of the residual in each tile, relative to that of noise, at the likeliest gain."""
        filters = self._weights * self._transfer(lenses, vergence, _RADII)[::-1] * [[1.0], [-1.0]]
        noise = self._light.variance * self._light.relative_variances() * (filters**2 @ self._density)
        first, second = (
            scipy.fft.idctn(np.interp(self._f, _RADII, values) * spectrum, norm="ortho")
            for values, spectrum in zip(filters, self._spectra, strict=True)
        )
        products = (first**2, first * second, second**2)
        a, b, c = (_tiled(p * self._inner).mean(axis=(1, 3))[self._tiles] / self._shares for p in products)
        return _relative_energies(a, b, c, noise[0], noise[1])

    def scan(self, places: Sequence[Array]) -> Array:
        """Return costs of tiles as of :meth:`_Search.costs`, (places, places, tiles), with defocus on a grid.

        `places` are vergences that focus the stated lenses as :meth:`_transfer` computes them, for each photograph.
        """
        few = np.linspace(0, len(self.places) - 1, min(_SCANNED, len(self.places))).astype(int)
        images, noises = [], []
        for table, at, values in zip(self.tables[::-1], places[::-1], self._spectra, strict=True):
            curves = self._weights * np.array([np.interp(_RADII, _TABLE_RADII, table(place)) for place in at])
            tiles = [
                _tiled(scipy.fft.idctn(np.interp(self._f, _RADII, curve) * values, norm="ortho") * self._inner)
                .transpose(0, 2, 1, 3)[self._tiles][few]
                .reshape(len(few), -1)
                for curve in curves
            ]
            images.append(np.array(tiles, dtype=np.float32))  # (places, tiles, pixels)
            noises.append(curves**2 @ self._density)
        first, second = images
        pixels = self._shares[few] * _SIDE**2
        a, c = (np.einsum("itp,itp->it", x, x) / pixels for x in images)
        b = -np.matmul(second.transpose(1, 0, 2), first.transpose(1, 2, 0)).transpose(1, 2, 0) / pixels
        variances = self._light.variance * self._light.relative_variances()
        first_noise, second_noise = variances[0] * noises[0], (variances[1] * noises[1])[:, None]
        energies = _relative_energies(a, b, c[:, None], first_noise, second_noise)
        return _LOG * np.log(energies) * (len(self.places) / len(few))


class _Search:
    """Search for lenses that explain planes: shift of 1 / focus, f-number, difference of foci, origin of distances.

    Parameters are in units that change the blur by about one radian of defocus, or 0.3 pixels.
    """

    def __init__(
        self,
        lenses: Sequence[Lens],
        planes: Sequence[_Plane],
        pixel: float,
        origin: float | None,
        scales: Sequence[float],
        spectrum: Spectrum,
        excess: float,
    ) -> None:
        self.lenses, self.planes, self._origin, self._excess = lenses, planes, origin or 0.0, excess
        shift = math.inf
        for lens in lenses:
            radian = 2.0 * lens.wavelength / (math.pi * (0.5 * lens.aperture_diameter) ** 2)
            radius_rate = 4.0 * lens.wavelength * lens.working_f_number / (math.pi * pixel)
            shift = min(shift, radian / min(1.0, radius_rate / _EDGE))
        distances = np.array([plane.distance + self._origin for plane in planes])
        self.unit, self.foci = shift, [1.0 / lens.focus_distance for lens in lenses]
        defocus = max(float(np.abs(1.0 / distances - focus).max()) for focus in self.foci)
        by_origin = _ORIGIN_ERROR / distances.min() ** 2 if origin is None else 0.0
        expected = math.hypot(UNMEASURED[1] * max(self.foci), 2.0 * UNMEASURED[0] * defocus, by_origin) / shift
        self.reach = float(np.clip(_PRIORS * expected, *_RANGE))
        beyond = shift * (self.reach + 4.0)
        ends = np.array([1.0 / distances.max() - beyond, 1.0 / distances.min() + beyond])
        tables = [
            _tabulate(lens, focus + shift * _spread((ends - focus) / shift, _TABLE), spectrum, pixel * scale)
            for lens, focus, scale in zip(lenses, self.foci, scales, strict=True)
        ]
        for plane in planes:
            plane.tables = tables
        # Changes of log f-number, of both foci (1/m), and of the origin (metres) by a unit of each parameter, in the
        # order in which planes determine them.
        self.basis = {"shift": [0.0, shift, shift, 0.0], "f-number": [0.5 * shift / defocus, 0.0, 0.0, 0.0]}
        if self.foci[0] != self.foci[1]:
            self.basis["difference"] = [0.0, shift, -shift, 0.0]
        if origin is None:
            self.basis["origin"] = [0.0, 0.0, 0.0, shift * float(np.median(distances)) ** 2]
        self.rows = np.array(list(self.basis.values()))
        # Standard errors of what is stated, in units. Both foci may be off by one cause, with opposite signs: half of
        # their difference then has the error of each.
        errors = {"shift": math.inf, "f-number": UNMEASURED[0], "origin": _ORIGIN_ERROR}
        errors["difference"] = 0.5 * UNMEASURED[1] * sum(self.foci)
        self.stated = np.array([errors[name] / max(row) for name, row in self.basis.items()])
        # The second direction in which a plane measures is that of the blur at a depth that does not change.
        self._measured = [0, list(self.basis).index("difference" if "difference" in self.basis else "f-number")]
        self._ends = np.cumsum([len(plane.places) for plane in planes])[:-1]

    def calibrated(self, changes: Array) -> tuple[list[_Changed], float]:
        """Return the changed lenses, and the origin of distances, metres."""
        foci, scale = np.add(self.foci, changes[1:3]), math.exp(float(changes[0]))
        return [_Changed(*one, scale) for one in zip(self.lenses, foci, strict=True)], self._origin + float(
            changes[3]
        )

    def weigh(self, changes: Array, excess: float) -> None:
        """Set new weights of frequencies for an assumed power of noise, as of :meth:`_Plane.weigh`."""
        lenses, origin = self.calibrated(changes)
        for plane in self.planes:
            plane.weigh(lenses, 1.0 / (plane.distance + origin), excess)

    def costs(self, changes: Array) -> Array:
        """Return -log(likelihood) of each tile."""
        lenses, origin = self.calibrated(changes)
        energies = [plane.energies(lenses, 1.0 / (plane.distance + origin)) for plane in self.planes]
        costs = _LOG * np.log(np.concatenate(energies))
        return np.where(np.isnan(costs), math.inf, costs)  # beyond the tables

    def derivatives(self, at: Array) -> tuple[Array, Array]:
        """Return gradients, (parameters, tiles), and Hessians, (parameters, parameters, tiles), of relative energies.

        Energies, times _LOG over those at `at`, are parabolas: their minimum is near that of their logarithms.
        """
        middle, steps = self.costs(at), [_STEP * row for row in self.rows]
        with np.errstate(invalid="ignore", over="ignore"):  # infinite costs
            ahead, behind = (
                [_LOG * np.exp((self.costs(at + sign * step) - middle) / _LOG) for step in steps]
                for sign in (1.0, -1.0)
            )
            hessian = np.empty((len(steps), len(steps), len(middle)))
            for i, step in enumerate(steps):
                hessian[i, i] = ahead[i] + behind[i] - 2.0 * _LOG
                for j in range(i):
                    both = _LOG * np.exp((self.costs(at + step + steps[j]) - middle) / _LOG)
                    hessian[i, j] = hessian[j, i] = both - ahead[i] - ahead[j] + _LOG
            return np.subtract(ahead, behind) / (2.0 * _STEP), hessian / _STEP**2

    def starts(self) -> tuple[list[Array], float]:
        """Return the likeliest minima of a search by coarse details, best first, and the scatter of its tiles.

        Minima are parameters, the scatter is as of :func:`_scatter`; ValueError if there are none.
        """
        self.weigh(np.zeros(4), _EXCESS)
        vergences = np.array([1.0 / (plane.distance + self._origin) for plane in self.planes])
        tables, scatters, spans = [], [], 0.0
        for plane, vergence in zip(self.planes, vergences, strict=True):
            ends = vergence + self.unit * self.reach * np.array([-1.0, 1.0])
            places = [f + self.unit * _spread((ends - f) / self.unit, _SCAN) for f in self.foci]
            tiles = plane.scan(places)
            shifts = [(some - vergence) / self.unit for some in places]
            count = _LOG * len(plane.places)
            # Geometric means of the energies of tiles are nearly parabolas, their logarithms narrow valleys.
            means = np.exp(tiles.sum(axis=2) / count)
            spans += float(np.log(np.ptp(means) / means.min() + 1.0))
            spline = scipy.interpolate.RectBivariateSpline(*shifts, means)
            scatters.append(_scatter(tiles))
            tables.append((spline, [some[[0, -1]] for some in shifts], 0.5 * means.min(), count / scatters[-1]))
        if spans < _MIN_CHANGE * len(self.planes):
            raise self._undetermined()

        def posterior(first: Array, second: Array, log_scale: Array) -> Array:
            """Return -log(likelihood), and of what is stated, by shifts of foci (units) and log of f-number."""
            total = self.stated_cost(self.unit * first, self.unit * second, log_scale)
            for vergence, (spline, ends, least, count) in zip(vergences, tables, strict=True):
                places, away = [], False
                for focus, shift, (low, high) in zip(self.foci, (first, second), ends, strict=True):
                    defocus = (vergence - focus) / self.unit
                    places.append((defocus - shift) * np.exp(-2.0 * log_scale) - defocus)
                    away = away | (places[-1] < low) | (places[-1] > high)
                total = np.where(away, math.inf, total + count * np.log(np.maximum(spline.ev(*places), least)))
            return total

        axis = np.linspace(-self.reach, self.reach, 2 * math.ceil(self.reach / (2.0 * _SCAN)) + 1)
        widest = _PRIORS * UNMEASURED[0]
        defocus = max(float(np.abs(vergences - focus).max()) for focus in self.foci) / self.unit
        step = _SCAN / max(defocus, 4.0)  # of log(f-number), by which defocus changes as by that of foci
        scales = np.linspace(-widest, widest, 2 * math.ceil(widest / step) + 1)
        one = self.foci[0] == self.foci[1]
        first, second, scale = np.meshgrid(axis, np.zeros(1) if one else axis, scales, indexing="ij")
        values = posterior(first, first if one else second, scale)
        found: list[tuple[float, Array]] = []
        lowest = (values == scipy.ndimage.minimum_filter(values, 3, mode="nearest")) & np.isfinite(values)
        for place in sorted(np.argwhere(lowest).tolist(), key=lambda k: float(values[tuple(k)]))[: 4 * _STARTS]:
            at = np.array([first[tuple(place)], (first if one else second)[tuple(place)], scale[tuple(place)]])
            turn = np.array([[1.0, 1.0, 0.0], [0.0, 0.0, 1.0]] if one else np.eye(3)) * [_SCAN, _SCAN, step]

            def cost(step: Array, at: Array = at, turn: Array = turn) -> float:
                return float(posterior(*(at + step @ turn)))

            simplex = {"initial_simplex": 0.5 * np.eye(len(turn) + 1, len(turn), -1), "fatol": 0.01}
            best = scipy.optimize.minimize(cost, np.zeros(len(turn)), method="Nelder-Mead", options=simplex)
            found.append((float(best.fun), at + best.x @ turn))
        found.sort(key=lambda each: each[0])
        kept: list[Array] = []
        for value, at in found:
            if value < found[0][0] + _UNLIKELY_START and all(np.abs(at - o)[:2].max() > 0.5 for o in kept):
                kept.append(at)
        # Parameters from changes of log f-number and foci; the origin is held.
        inverse = np.linalg.pinv(self.rows[[name != "origin" for name in self.basis]])
        changes = [np.array([at[2], self.unit * at[0], self.unit * at[1], 0.0]) @ inverse for at in kept[:_STARTS]]
        starts = [np.append(change, np.zeros(len(self.rows) - len(change))) for change in changes]
        return starts, float(np.mean(scatters))

    def stated_cost(self, first: ArrayLike, second: ArrayLike, log_scale: ArrayLike) -> Array:
        """Return half the squares of changes of foci (1/m) and log(f-number) over their variances as stated."""
        origin = _ORIGIN_ERROR / min(p.distance for p in self.planes) ** 2 if "origin" in self.basis else 0.0
        errors = [math.hypot(max(UNMEASURED[1] * focus, 0.25 * self.unit), origin) for focus in self.foci]
        if self.foci[0] == self.foci[1]:
            errors[1] = math.inf
        parts = zip((first, second, log_scale), (*errors, UNMEASURED[0]), strict=True)
        return np.asarray(0.5 * sum(np.square(np.divide(change, error)) for change, error in parts))

    def _disagreement(self) -> ValueError:
        """Return the error where no lens near the stated one agrees."""
        ends = sorted({min(p.distance for p in self.planes), max(p.distance for p in self.planes)})
        return ValueError(
            f"no lens with foci within {self.reach * self.unit:.2g} dioptres of the stated ones explains planes at "
            f"{' to '.join(map(format_length, ends))}: check pixel pitch (of reduced photographs larger), f-number, "
            "focal length and foci, then the distances, and that nothing but the focus changed in a pair"
        )

    def _undetermined(self) -> ValueError:
        """Return the error where planes do not determine a lens, with distances beyond the foci that would."""
        low, high = min(self.foci), max(self.foci)
        beyond = max(0.5 * (high - low), _BEYOND * self.unit)
        places = [1.0 / focus - self._origin for focus in (high + beyond, low - beyond) if focus > 0.0]
        return ValueError(
            "photographs do not determine the focus: use a plane at about "
            f"{' or '.join(format_length(place, digits=2) for place in places)}, beyond the foci, or one more there, "
            "with texture of many sizes, such as print or leaves, and more light"
        )

    def _scores(self, at: Array) -> Iterator[_Score]:
        """Yield gradients and Hessians of `costs` of each plane, in the directions that planes measure."""
        gradients, hessians = self.derivatives(at @ self.rows)
        if not np.isfinite(hessians).all():
            raise self._disagreement()
        parts = (np.split(part[self._measured], self._ends, axis=-1) for part in (gradients, hessians))
        for tiles, curvatures in zip(*parts, strict=True):
            slopes = curvatures.sum(axis=2)
            scales = np.abs(np.diag(slopes[:, self._measured]))
            # Scatter of the gradients of tiles, less those of the changes that their sums ask for.
            scatter = tiles - np.einsum("iit,i->it", curvatures[:, self._measured], tiles.sum(axis=1) / scales)
            variance = scatter @ scatter.T * (tiles.shape[1] / (tiles.shape[1] - 1.0))
            yield _Score(tiles, curvatures, tiles.sum(axis=1), slopes, scales, variance)

    def likeliest(self, at: Array, excess: float, scatter: float) -> Array:
        """Return parameters near a greatest likelihood; valleys of coarse details (large `excess`) are wide.

        `scatter` is the variance of gradients of tiles / curvature, by which what is stated weighs.
        """
        for _ in range(_MAX_STEPS):
            self.weigh(at @ self.rows, excess)
            gradients, hessians = self.derivatives(at @ self.rows)
            if not np.isfinite(hessians).all():
                break
            gradient = gradients.sum(axis=1) + scatter * at / self.stated**2
            values, axes = np.linalg.eigh(hessians.sum(axis=2) + scatter * np.diag(self.stated**-2.0))
            step = -axes @ (axes.T @ gradient / np.maximum(np.abs(values), 1.0))
            step *= min(1.0, _MAX_STEP / float(np.abs(step).max()))
            cost = self._posterior(at, scatter)
            while self._posterior(at + step, scatter) > cost and np.abs(step).max() > _COARSE:
                step *= 0.5
            at = at + step
            if np.abs(step).max() <= _COARSE:
                break
        return at

    def _posterior(self, at: Array, scatter: float) -> float:
        """Return -log(likelihood) of all tiles and of the changes of what is stated."""
        return float(self.costs(at @ self.rows).sum() + 0.5 * scatter * np.square(at / self.stated).sum())

    def minimum(self, at: Array, floors: Array, steady: bool = False) -> tuple[Array, list[_Score], Array, Array]:
        """Return parameters, scores of planes, the weight of gradients, and the precision; ValueError if none.

        Parameters minimise the squares of gradients over their variances plus those of the changes of what is stated.
        `floors` are standard errors that tiles do not show, units, (planes, directions). With `steady`, slopes and
        variances are those of the start: gradients vanish at saddles, too, where a plane is in focus.
        """
        first: list[_Score] = []
        for _ in range(_MAX_STEPS):
            self.weigh(at @ self.rows, self._excess)
            scores = list(self._scores(at))
            if steady:
                first = first or scores
                scores = [
                    new._replace(slopes=old.slopes, scales=old.scales, variance=old.variance)
                    for new, old in zip(scores, first, strict=True)
                ]
            slopes = np.vstack([score.slopes for score in scores])
            more = [np.diag((score.scales * floor) ** 2) for score, floor in zip(scores, floors, strict=True)]
            variance = scipy.linalg.block_diag(*(score.variance + x for score, x in zip(scores, more, strict=True)))
            # Errors of the distances, and of the origin where it is stated, which all planes share.
            by_origin = slopes[:, 0] * np.repeat([plane.distance**-2.0 for plane in self.planes], 2) / self.unit
            shared = np.outer(by_origin, by_origin)
            own = scipy.linalg.block_diag(*np.ones((len(scores), 2, 2)))
            variance += _RULER**2 * own * shared + (0.0 if "origin" in self.basis else _PUPIL**2) * shared
            weight = np.linalg.inv(variance)
            precision = slopes.T @ weight @ slopes + np.diag(self.stated**-2.0)
            if not np.linalg.eigvalsh(precision)[0] > _MAX_ERROR**-2.0:
                raise self._undetermined()
            gradient = slopes.T @ weight @ np.concatenate([score.gradient for score in scores])
            step = -np.linalg.solve(precision, gradient + at / self.stated**2)
            step *= min(1.0, _MAX_STEP / float(np.abs(step).max()))
            at = at + step
            if np.abs(step).max() <= _TOLERANCE:
                break
        return at, scores, weight, precision

    def best(self) -> list[_Solution]:
        """Return lenses that explain the planes, the likeliest first; ValueError if planes do not determine one."""
        found, contrary, error = list[_Solution](), list[_Solution](), None
        starts, scatter = self.starts()
        for start in starts:
            at = self.likeliest(start, _EXCESS, scatter)
            at = self.likeliest(at, self._excess, scatter) if self._excess < _EXCESS else at
            starts.extend(twin for twin in self._twins(at) if all(np.abs(twin - s).max() > _TWIN for s in starts))
            for steady in (False, True):
                try:
                    one = self._solution(at, steady)
                except ValueError as failure:
                    error = error or failure
                    continue
                # At the minimum, and not at a saddle: not less likely, or less by part of the errors. Print of high
                # contrast tells the f-number, which one plane holds, by diffraction: the likelier is taken.
                lost = self._cost(one.at, [at]) - self._cost(at, [at])
                less, step = 2.0 * lost / one.scale >= _EVIDENCE, one.at - at
                if not less or step @ np.linalg.solve(one.covariance, step) < _EVIDENCE:
                    # Errors contain both.
                    likelier = at if less and len(self.planes) == 1 else one.at
                    one = one._replace(at=likelier, covariance=one.covariance + float(less) * np.outer(step, step))
                    if all(np.abs(one.at - other.at).max() > _SAME for other in found):
                        found.append(one._replace(minimum=at))
                    break
                if max(map(_deviation, one.seen)) > _DOUBTFUL:
                    contrary.append(one)
                error = error or self._undetermined()  # of one plane: lenses far from the stated one are likelier
        found = found or (contrary[:1] if len(self.planes) < 3 else [])  # of more, the caller names the plane
        if not found:
            raise self._disagreement() if error is None or len(self.planes) > 1 else error
        minima = [one.minimum for one in found]
        costs = [self._cost(at, minima) for at in minima]
        scale = found[int(np.argmin(costs))].scale
        chi2 = np.multiply(2.0 / scale, costs) + [
            one.chi2 + 2.0 * float(self.stated_cost(*(one.at @ self.rows)[[1, 2, 0]])) for one in found
        ]
        best = float(chi2.min())
        ranked = [one._replace(chi2=float(x) - best) for one, x in zip(found, chi2, strict=True)]
        return sorted(ranked, key=lambda one: one.chi2)

    def _defocus(self, at: Array) -> Array:
        """Return the defocus of both photographs of the first plane in units, by the stated f-number."""
        lenses, origin = self.calibrated(at @ self.rows)
        vergence = 1.0 / (self.planes[0].distance + origin)
        return np.array([(vergence - lens.focus) / lens.scale**2 / self.unit for lens in lenses])

    def _twins(self, at: Array) -> Iterator[Array]:
        """Yield parameters of likely lenses by which one plane has the same blur, on other sides of the foci."""
        for sides in (
            ((1.0, 0.0), (0.0, 1.0), (1.0, 1.0)) if len(self.planes) == 1 and "difference" in self.basis else ()
        ):
            changes = at @ self.rows
            changes[1:3] += 2.0 * self.unit * math.exp(2.0 * changes[0]) * self._defocus(at) * sides
            if self.stated_cost(*changes[[1, 2, 0]]) < _UNLIKELY_START / 4.0:
                yield np.linalg.lstsq(self.rows.T, changes, rcond=None)[0]

    def _cost(self, at: Array, others: Sequence[Array]) -> float:
        """Return -log(likelihood) by the weights of frequencies of all `others`, of which none is favoured.

        Errors of distances do not count: each plane is at its own minimum, to second order.
        """
        total = 0.0
        for other in others:
            self.weigh(other @ self.rows, self._excess)
            total += float(self.costs(at @ self.rows).sum())
            for score in self._scores(at):
                slopes = score.slopes[:, self._measured]
                total -= max(0.0, float(score.gradient @ np.linalg.solve(slopes + slopes.T, score.gradient)))
        return total / len(others)

    def moved(self, at: Array) -> float:
        """Return the deviation of the lens from what is stated, standard errors."""
        return float(np.linalg.norm(at / self.stated))

    def _solution(self, at: Array, steady: bool) -> _Solution:
        """Return the lens found from a start; `steady` as of :meth:`minimum`."""
        floors = np.full((len(self.planes), 2), _FLOOR)
        at, scores, weight, precision = self.minimum(at, floors, steady)
        if self._excess > 1.0:
            # What other weights change is the error of what cameras do to fine details.
            self.weigh(at @ self.rows, _CHANGE * self._excess)
            changes = [
                one.gradient / one.scales - other.gradient / other.scales
                for one, other in zip(scores, self._scores(at), strict=True)
            ]
            at, scores, weight, precision = self.minimum(at, np.hypot(floors, changes), steady)
        measured = [score.slopes[:, self._measured] for score in scores]
        # At a saddle which the likelihood leaves by more than what is stated allows, as told by the scatter of tiles.
        held = _SADDLE * np.diag(np.diag(scores[0].variance) / scores[0].scales / self.stated[self._measured] ** 2)
        saddle = len(scores) == 1 and np.linalg.eigvalsh(0.5 * (measured[0] + measured[0].T) + held)[0] <= 0.0
        if saddle or any(score.slopes[0, 0] <= 0.0 for score in scores):
            raise self._undetermined()
        slopes, covariance = np.vstack([score.slopes for score in scores]), np.asarray(np.linalg.inv(precision))
        left = weight - weight @ slopes @ covariance @ slopes.T @ weight
        gradient = np.concatenate([score.gradient for score in scores])
        origin, seen = self.calibrated(at @ self.rows)[1], []
        for k, (plane, score) in enumerate(zip(self.planes, scores, strict=True)):
            # Generalised least squares of the distance of this plane, by the others and by what is stated.
            moved = np.zeros(len(gradient))
            moved[2 * k : 2 * k + 2] = score.slopes[:, 0]
            information, away = float(moved @ left @ moved), plane.distance + origin
            metres, known = self.unit * away**2, len(scores) > 1 and information > 0.0
            shift = float(moved @ left @ gradient) / information if known else 0.0
            error = metres / math.sqrt(information) if known else math.inf
            found = 1.0 / (1.0 / away - self.unit * shift) - origin
            numbers = *self._tilt(plane, score, metres), self._misfit(k, at)
            seen.append(CalibratedPlane(plane.distance, found, error, *numbers))
        ratios = [
            0.5 * np.trace(np.linalg.solve(m, score.variance)) for m, score in zip(measured, scores, strict=True)
        ]
        return _Solution(
            at, covariance, seen, at, max(1.0, float(np.mean(ratios))), float(gradient @ weight @ gradient)
        )

    def _misfit(self, plane: int, at: Array) -> float:
        """Return the median of the energies of the tiles of a plane, relative to those of noise."""
        return math.exp(float(np.median(np.split(self.costs(at @ self.rows), self._ends)[plane])) / _LOG)

    def _tilt(self, plane: _Plane, score: _Score, metres: float) -> tuple[float, float]:
        """Return the change of distance across a plane, and its standard error, metres; `metres` is one unit."""
        gradient, curvature = score.tiles[0], score.curvatures[0, 0]
        # Weighted least squares of the shifts of tiles, -gradient / curvature: a constant, and a slope.
        terms = np.column_stack([np.ones(len(gradient)), plane.places])
        inverse = np.linalg.pinv(terms.T @ (curvature[:, None] * terms), hermitian=True)
        fit = -inverse @ (terms.T @ gradient)
        scatter = terms * (gradient + curvature * (terms @ fit))[:, None] @ inverse
        covariance = scatter.T @ scatter * (len(gradient) / (len(gradient) - 3.0))
        tilt = math.hypot(*fit[1:])
        error = math.sqrt(fit[1:] @ covariance[1:, 1:] @ fit[1:]) / max(tilt, 1e-300)
        return 2.0 * metres * tilt, 2.0 * metres * error


class _Score(NamedTuple):
    """Derivatives of -log(likelihood) of a plane, by tiles and in all, with the variance of the gradient."""

    tiles: Array  # gradients, (directions, tiles)
    curvatures: Array  # Hessians, (directions, parameters, tiles)
    gradient: Array
    slopes: Array  # Hessian, (directions, parameters)
    scales: Array  # its diagonal
    variance: Array


class _Solution(NamedTuple):
    """A lens that explains the planes."""

    at: Array  # parameters
    covariance: Array
    seen: list[CalibratedPlane]
    minimum: Array  # parameters of the least -log(likelihood) of all tiles
    scale: float  # variance of gradients / curvature: of -log(likelihood), by which its differences are too large
    chi2: float  # of planes and their distances, and of what is stated; less that of the best


class CalibratedPlane(NamedTuple):
    """A plane of known distance, as the calibrated lenses see it.

    Attributes
    ----------
    distance : float
        Stated distance, metres.
    found, error : float
        Distance that these photographs, all other planes and the stated lens determine, and its standard error,
        metres: infinite for one plane.
    tilt, tilt_error : float
        Difference of the distances of opposite corners, at most, and its standard error, metres.
    misfit : float
        Median of (difference of the photographs) / (difference expected of noise) at the stated distance.
    """

    distance: float
    found: float
    error: float
    tilt: float
    tilt_error: float
    misfit: float


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class FocalCalibration(FitReport):
    """Lenses calibrated by :func:`lommel.imaging.calibrate_focus`.

    The findings have the codes "exchanged", "contradiction" (of planes, or of one or two and the stated lens),
    "undetermined" (another lens explains the planes as well), "not_flat", "misfit", "compressed", "stated", and
    "untested" (the order of the photographs of one plane about midway between the foci).
    ``print(found)`` prints a table.

    Attributes
    ----------
    lenses : tuple of Lens
        The calibrated lenses, in the order of the photographs.
    f_number_scale : float
        True f-number / stated f-number; 1 where it is held as stated.
    f_number_error : float
        Standard error of log(f-number); 0.03 where it is held as stated.
    focus_shifts : (float, float)
        True less stated 1 / focus distance of each photograph, 1/m.
    focus_error : float
        Larger standard error of `focus_shifts`, with that of a held f-number and origin, 1/m.
    origin : float
        Position of the point from which `distances` count, in front of the lens (its entrance pupil), metres.
    origin_error : float
        Standard error of `origin`, metres: 0.02 where it is held at 0, and 0 where it is stated.
    covariance : ndarray, shape (4, 4)
        Covariance of log(f-number), `focus_shifts` and `origin`.
    planes : tuple of CalibratedPlane
        The planes as these lenses see them.
    findings : Findings
        Planes that contradict each other or are tilted, exchanged photographs, and numbers that are held as stated.
    summary : str
        Numbers of planes and tiles.
    """

    lenses: tuple[Lens, ...]
    f_number_scale: float
    f_number_error: float
    focus_shifts: tuple[float, float]
    focus_error: float
    origin: float
    origin_error: float
    covariance: Array
    planes: tuple[CalibratedPlane, ...]

    @property
    def errors(self) -> dict[str, float]:
        """Standard errors as keywords of :func:`lommel.imaging.depth_from_defocus`: f_number_error, focus_error."""
        return {"f_number_error": self.f_number_error, "focus_error": self.focus_error}

    def to_dict(self) -> Json:
        """Return the result as plain data for JSON.

        Returns
        -------
        dict
            Verdict, findings and attributes; of lenses the focus distances (metres) and f-numbers.
        """
        lenses = [{"focus_distance": lens.focus_distance, "f_number": lens.f_number} for lens in self.lenses]
        return {**super().to_dict(), "lenses": lenses}

    def __str__(self) -> str:
        rows = [("f-number, true / stated", self.f_number_scale, self.f_number_error, "")]
        foci = dict.fromkeys(lens.focus_distance for lens in self.lenses)
        names = ("focus",) if len(foci) == 1 else ("focus, first photo", "focus, second photo")
        rows += [(name, focus, self.focus_error * focus**2, " m") for name, focus in zip(names, foci, strict=True)]
        if self.origin_error:
            rows += [("origin before the lens", self.origin, self.origin_error, " m")]
        planes = [plane for plane in self.planes if plane.error < math.inf]
        rows += [(f"plane at {plane.distance:.4g} m", plane.found, plane.error, " m") for plane in planes]
        lines = [f"{name:<25}{' +- '.join(with_error(value, error))}{unit}" for name, value, error, unit in rows]
        if not self.origin_error:
            stated = f"{self.origin:.4g} m, as stated (taken as right within {format_length(_PUPIL)})"
            lines.insert(1 + len(names), f"{'origin before the lens':<25}{stated}")
        return "\n".join(lines if len(lines) <= 12 else [*lines[:11], f"and {len(lines) - 11} planes more"])

    def save(self, path: str | PathLike[str], lens_file: str | PathLike[str]) -> None:
        """Write a lens file with a section [calibration], which ``lommel depth`` and ``lommel watch`` use.

        Parameters
        ----------
        path : path
            File to write: .toml.
        lens_file : path
            Lens file of the lens before calibration, whose text is copied.

        Raises
        ------
        ValueError
            If `path` does not end in .toml, `lens_file` is no TOML or has a section [calibration], or a finding is an
        error: depth of this lens would be wrong.
        OSError
            If a file cannot be read or written.
        """
        target, source = validation.path("path", path), validation.path("lens_file", lens_file)
        if not self.converged:
            raise ValueError(f"a lens that contradicts its planes is not written: {self.message}")
        text = reading.decoded(reading.contents(source, reading.MAX_TOML))
        if target.suffix.lower() != ".toml" or "calibration" in reading.toml(text):
            raise ValueError(f"path must end in .toml, and {source} have no [calibration], got {target}")
        section = [
            "[calibration]",
            f"focus_distances = {[f'{lens.focus_distance:.9g} m' for lens in self.lenses]}",
            f"f_numbers = {[float(f'{lens.f_number / self.f_number_scale:.9g}') for lens in self.lenses]}",
            f"f_number_scale = {self.f_number_scale:.9g}",
            *(f"{name} = {value:.3g}" for name, value in self.errors.items()),
        ]
        atomic.write(target, "\n".join([text.rstrip(), "", *section, ""]).encode())


def calibrate_focus(
    photographs: Sequence[Sequence[ArrayLike]],
    distances: Sequence[float],
    lenses: Sequence[Lens],
    pixel: float,
    *,
    encoding: Encoding,
    noise: Noise | None = None,
    origin: float | None = None,
    magnification: Magnification = "registered",
) -> FocalCalibration:
    """Calibrate f-number and focus of two lens settings from planes at known distances.

    Parameters
    ----------
    photographs : sequence of pairs of array_like, each of shape (height, width) or (height, width, channels)
        Two photographs of each plane, one with each of `lenses`, as for
        :func:`lommel.imaging.depth_from_defocus`: a flat textured surface, parallel to the sensor, that fills the
        frame. Photographs of a camera that sharpens or compresses can be used, too.
    distances : sequence of float
        Distance of each plane, metres. Choose distances on both sides of the foci.
    lenses : sequence of two Lens
        The lens at the stated foci and f-numbers, which differ in focus or in f-number.
    pixel : float
        Pixel pitch, metres.
    encoding : {"srgb", "linear"} or float
        Encoding of the photographs; a number states ``light = value ** number``.
    noise : Noise, optional
        Noise of the linear photographs, where white is 1, with which `misfit` is judged. Estimates depend little on
        it: the variance of each tile is estimated.
    origin : float, optional
        Position of the point from which `distances` count, in front of the lens (its entrance pupil), metres: some
        0.02 for those from the front rim of a lens of 50 mm; negative for distances from the sensor. By default it is
        estimated where the planes determine it, and else 0 with a standard error of 2 cm.
    magnification : {"registered", "lens"} or float, default "registered"
        As for :func:`lommel.imaging.depth_from_defocus`.

    Returns
    -------
    FocalCalibration

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of another shape; if photographs of a plane are shifted or magnified
        otherwise than stated; if they do not determine the focus; or if no lens near the stated one agrees with
        distances and photographs.

    Notes
    -----
    One plane determines one number, the shift of 1 / focus that both photographs share; the f-number is then held,
    with a standard error of 3 % that `focus_error` includes, as it does 2 % of each focus for a difference that is
    held, and 2 cm of an origin that is neither stated nor estimated. A second plane adds the f-number, a third the
    foci of both photographs, a further one the origin of distances: each is estimated only where its standard error
    is below 5 % of the f-number or 2 cm of the origin. Photographs do not tell the sign of defocus: all lenses near
    the stated one are searched, and standard errors contain those that explain the planes about as well.
    They follow from the scatter between tiles of 32 x 32 pixels, and do not include errors of the model that all
    tiles share, such as spherical aberration that the lens does not state.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=35e-3, f_number=4.0, focus_distance=1.35, wavelength=540e-9)
    >>> true = [lens, lens.focused(1.8)]
    >>> scene = np.random.default_rng(0).random((224, 224))
    >>> def shoot(distance):
    ...     flat = np.full(scene.shape, distance)
    ...     return [lm.imaging.depth_of_field(scene, flat, one, 4e-6, encoding="linear").values for one in true]
    >>> found = lm.imaging.calibrate_focus(
    ...     [shoot(1.25)],
    ...     [1.25],
    ...     [lens.focused(1.33), lens.focused(1.77)],
    ...     4e-6,
    ...     encoding="linear",
    ...     noise=lm.Noise(white=1e4, read=3),
    ... )
    >>> [round(one.focus_distance, 2) for one in found.lenses]
    [1.35, 1.8]
    """
    pitch = pixel_of(lenses, pixel)
    if len(lenses) != 2 or lenses[0] == lenses[1]:
        raise ValueError(f"lenses must be two that differ in focus or f-number, got {validation.shown(lenses)}")
    if not all(lens.focus_distance > 0.0 for lens in lenses):
        raise ValueError("lenses must be focused at a distance or at infinity: state focus_distance")
    metres = np.atleast_1d(validation.real_array("distances", distances, unit="metres"))
    if metres.ndim != 1 or not len(metres) or len(photographs) != len(metres):
        raise ValueError(f"distances must be one for each of {len(photographs)} pairs, got shape {metres.shape}")
    zero = 0.0 if origin is None else validation.real("origin", origin, unit="metres")
    if not (metres + zero > lenses[0].focal_length).all():
        raise ValueError(f"distances from the lens must be above its focal length, got {metres.min() + zero:g} m")
    used = _ASSUMED if noise is None else validation.instance("noise", noise, Noise).poisson
    stated = checked_magnification("magnification", magnification)
    planes, compressed, magnified = [], False, list[float]()
    for pair, distance in zip(photographs, metres.tolist(), strict=True):
        electrons, valid, shape, _ = counts_in_electrons(list_photographs(pair, lenses), encoding, used)
        images = electrons.sum(axis=0, dtype=np.float32)
        if np.array_equal(*images):
            raise ValueError(f"photographs of the plane at {format_length(distance)} must differ, got one twice")
        compressed |= any(map(is_compressed, images))
        registered = Registration(stated, lenses, valid.shape, processors())
        if registered:
            images = np.stack(registered(list(images), math.inf, valid.view(np.uint8)))
            valid, images = valid & np.isfinite(images).all(axis=0), np.nan_to_num(images)
        images, valid = _filled(images, valid)
        blur = max(float(lens.pupil(distance + zero).geometric_radius()) for lens in lenses) / pitch
        if len(shift := frame_shift(images, valid, blur)):
            raise ValueError(
                "the second photograph of the plane at {} is shifted by {:.1f} pixels down and {:.1f} right: "
                "align the photographs (lommel align)".format(format_length(distance), *shift)
            )
        if scales := frame_scales(images, valid, blur):
            magnified.append(scales[-1] * registered.scales[-1])
        read = math.sqrt(float(np.mean(np.square(used.read))) * len(electrons))
        planes.append(_Plane(images.astype(np.float64), valid, distance, blur, read))
    if magnified:
        raise ValueError(
            f"the second photographs are magnified {np.median(magnified):.4f} times the first, not as stated (focus "
            "breathing): state this magnification, or align the photographs (lommel align)"
        )
    colours = spectra("channels", channel_spectra(shape, lenses[0].wavelength))
    spectrum = [line for colour in colours for line in colour]  # channels are summed
    # Fine details, which cameras sharpen, denoise and compress, count little in photographs that are finished.
    excess = _EXCESS if noise is None or compressed else 1.0
    more = planes, pitch, origin, registered.scales, spectrum, excess
    search, other = _Search(lenses, *more), partial(_Search, lenses[::-1], *more)
    try:
        solutions = search.best()
    except ValueError as error:
        away = 1.0 / (planes[0].distance + zero)
        midway = len(planes) == 1 and min(search.foci) < away < max(search.foci)  # either order has the same blur
        if not midway and _contradiction(other()) < _PLAUSIBLE:
            raise ValueError(f"{error}; in the other order they agree: check the order of photographs") from None
        rest = range(len(planes) if len(planes) > 2 else 0)
        found = [_contradiction(_Search(lenses, [*planes[:k], *planes[k + 1 :]], *more[1:])) for k in rest]
        if found and min(found) < _PLAUSIBLE:
            wrong = format_length(planes[int(np.argmin(found))].distance)
            raise ValueError(
                f"distances contradict each other, and least without the plane at {wrong}: measure them again, from "
                "one point, and check its photographs"
            ) from None
        raise
    at, covariance, seen = solutions[0][:3]
    others = [(one.at - at, one.chi2) for one in solutions[1:] if one.chi2 < _EVIDENCE]
    total = 1.0 + sum(math.exp(-0.5 * chi2) for _, chi2 in others)
    for change, chi2 in others:  # errors contain all answers
        covariance = covariance + max(math.exp(-0.5 * chi2) / total, 1.0 / 9.0) * np.outer(change, change)
    ratios = dict(zip(search.basis, (np.sqrt(np.diag(covariance)) / search.stated).tolist(), strict=True))
    moved = search.moved(at)
    # The errors of a doubtful lens contain the stated one: two standard errors.
    covariance = covariance + float(moved > _UNLIKELY[min(len(planes), 3) - 1]) * np.outer(at, at) / 4.0
    at, covariance = at @ search.rows, search.rows.T @ covariance @ search.rows
    findings = [
        *_findings(ratios, moved, seen, covariance, noise is not None),
        *_other_answers(search, at, [(change @ search.rows, chi2) for change, chi2 in others]),
        *_exchanged(search, at, seen, other()),
    ]
    if compressed:
        text = (
            "the photographs are compressed (JPEG), which looks like blur: numbers may be off by more than their "
            "standard errors; use raw images or PNG, or check depth with a plane at another distance"
        )
        findings.append(Finding("compressed", "doubt", text, {}))
    f_number_error, *focus_errors, origin_error = np.sqrt(np.diag(covariance)).tolist()
    changed, origin = search.calibrated(at)
    return FocalCalibration(
        findings=Findings(findings),
        summary=f"{len(planes)} planes, {sum(len(plane.places) for plane in planes)} tiles",
        lenses=tuple(one.lens for one in changed),
        f_number_scale=changed[0].scale,
        f_number_error=f_number_error,
        focus_shifts=(float(at[1]), float(at[2])),
        focus_error=max(focus_errors),
        origin=origin,
        origin_error=origin_error,
        covariance=covariance,
        planes=tuple(seen),
    )


def _other_answers(search: _Search, at: Array, others: Sequence[tuple[Array, float]]) -> Iterator[Finding]:
    """Yield the finding on lenses that explain the planes as well; `others` are their changes, and chi2."""
    foci = np.add(search.foci, at[1:3])
    far = [(change, chi2) for change, chi2 in others if (np.abs(change[1:3]) > _FAR * np.abs(foci)).any()]
    if not far:
        return
    change, chi2 = far[0]
    # Defocus at a further plane, whose sign no photograph tells, differs most between the answers.
    plane = 1.0 / (search.planes[0].distance + search.calibrated(at)[1])
    places = plane * np.linspace(0.4, 1.6, 121)[:, None]
    differs = np.square(np.abs(places - foci) - np.abs(places - foci - change[1:3])).sum(axis=1)
    enough = places[differs > 0.8 * differs.max(), 0]
    distance = 1.0 / float(enough[np.argmin(np.abs(enough - plane))])
    one, other = (
        ", ".join(format_length(1.0 / focus) for focus in dict.fromkeys(each)) for each in (foci, foci + change[1:3])
    )
    more = f" ({len(far) - 1} more)" if len(far) > 1 else ""
    text = (
        f"two answers fit: foci {one} and foci {other}{more}, with chi2 that differ by {chi2:.2g}; a further plane "
        f"at about {distance:.2g} m decides"
    )
    yield Finding(
        "undetermined", "doubt", text, {"chi2": chi2, "foci": list(1.0 / (foci + change[1:3])), "plane": distance}
    )


def _findings(
    ratios: Mapping[str, float], moved: float, planes: Sequence[CalibratedPlane], covariance: Array, stated: bool
) -> Iterator[Finding]:
    """Yield the findings on planes, on noise if it was stated, and on what is stated.

    `ratios` are standard errors of parameters after calibration / before, `moved` as of :meth:`_Search.moved`.
    """
    kind = min(len(planes), 3) - 1
    limit, decide = _UNLIKELY[kind], ("use a second plane", "use three planes", "measure them again")[kind]
    if moved > limit:
        text = (
            f"the lens is {moved:.2g} standard errors from the stated one ({percent(UNMEASURED[0])} of the f-number, "
            f"{percent(UNMEASURED[1])} of each focus), farther than {len(planes)} plane{'s' * (len(planes) > 1)} can "
            f"show; standard errors contain both: check lens file, pixel and distances, or {decide}"
        )
        wrong = moved > _WRONG / _DOUBTFUL * limit
        yield Finding("contradiction", "error" if wrong else "doubt", text, {"deviation": moved, "limit": limit})
    for plane in planes:
        name, (found, error) = f"the plane at {format_length(plane.distance)}", with_error(plane.found, plane.error)
        if (deviation := _deviation(plane)) > _DOUBTFUL:
            text = (
                f"distances contradict each other: by the other planes and the stated lens {name} is at {found} +- "
                f"{error} m; measure the distances again, from one point, and check the order of the photographs"
            )
            yield Finding("contradiction", "error" if deviation > _WRONG else "doubt", text, plane._asdict())
        if plane.tilt > max(_WRONG * plane.tilt_error, _MIN_TILT * plane.distance):
            text = f"{name} is tilted: its distance changes by {format_length(plane.tilt)} across the photographs"
            yield Finding("not_flat", "doubt", text, plane._asdict())
    misfit = max(plane.misfit for plane in planes)
    if stated and misfit > _MAX_MISFIT:
        text = (
            f"photographs differ by {misfit:.3g} times their noise (sharpened, compressed, moved): standard errors "
            "follow from the scatter of tiles, but do not include what all tiles share"
        )
        severity: Literal["doubt", "note"] = "doubt" if misfit > _WRONG_MISFIT else "note"
        yield Finding("misfit", severity, text, {"misfit": misfit, "limit": _MAX_MISFIT, "wrong": _WRONG_MISFIT})
    error = max(covariance[3, 3] ** 0.5, 1e-9)
    shift = float(np.abs(covariance[1:3, 3]).max() / error)  # 1/m, by the error of the origin
    texts = {
        "f-number": f"the f-number (+- {percent(UNMEASURED[0])})",
        "difference": f"the difference of the foci (+- {percent(UNMEASURED[1])} of each)",
        "origin": f"the origin of distances (+- {format_length(error)}, {shift:.2g} dioptre of foci: state origin)",
    }
    held = [name for name, ratio in ratios.items() if ratio > _HELD]
    part = [name for name, ratio in ratios.items() if _PART < ratio <= _HELD]
    groups = {"held": held, "determined in part, and by what is stated": part}
    if words := [f"{word}: {', '.join(texts[name] for name in names)}" for word, names in groups.items() if names]:
        text = f"{'; '.join(words)}; planes at other distances determine more"
        yield Finding("stated", "note", text, {"held": held, "part": part})


def _deviation(plane: CalibratedPlane) -> float:
    """Return the deviation of a plane from its stated distance, standard errors."""
    return abs(plane.found - plane.distance) / plane.error


def _contradiction(search: _Search) -> float:
    """Return squares of deviations of the planes and of what is stated of the lens; inf where no lens agrees."""
    try:
        best = search.best()[0]
    except ValueError:
        return math.inf
    deviation = max(map(_deviation, best.seen))
    stated = 2.0 * float(search.stated_cost(*(best.at @ search.rows)[[1, 2, 0]]))
    return stated + deviation**2 if deviation < _DOUBTFUL else math.inf


def _exchanged(search: _Search, at: Array, seen: Sequence[CalibratedPlane], other: _Search) -> Iterator[Finding]:
    """Yield a finding if planes or foci are off, and less in the other order of the photographs."""
    stated = np.abs(at[1:3] / search.foci).max()
    one = len(search.planes) == 1 and search.foci[0] != search.foci[1]
    if one:  # the other order has the same blur with foci on the other side of the plane
        mirrored = 2.0 / (seen[0].distance + search.calibrated(at)[1]) - np.add(search.foci, at[1:3])[::-1]
        shift = float(np.abs(mirrored / search.foci - 1.0).max())
        if shift < _MAX_SHIFT:
            text = (
                f"the order of the photographs (in the other one foci off by {percent(shift, 1)} agree as well; use "
                "a plane nearer to one of the foci)"
            )
            yield untested_finding([text], {"other": shift})
    misfit = max(plane.misfit for plane in seen) > _WRONG_MISFIT
    if stated < _MAX_SHIFT and max(map(_deviation, seen)) < _DOUBTFUL and not misfit:
        return
    try:
        best = other.best()[0].at @ other.rows
    except ValueError:
        return
    change = search.costs(at) - other.costs(best)
    deviation = float(change.sum() / max(float(np.std(change)) * math.sqrt(len(change)), 1e-12))
    needed = np.abs(best[1:3] / other.foci).max()
    # One plane between two foci agrees about as well in either order, with another shift of the foci.
    nearer = stated > max(_MAX_SHIFT, 1.5 * needed) if one else needed < stated
    # A misfit that only a far lens reduces is of the photographs, such as those that a camera has sharpened.
    misfit &= needed < max(stated, _MAX_SHIFT)
    if (nearer and one) or (deviation > _DOUBTFUL and (misfit or (nearer and not one))):
        text = (
            f"the photographs seem exchanged: in the other order foci are off by {percent(needed, 1)}, in this order "
            f"by {percent(stated, 1)}"
        )
        yield Finding("exchanged", "error", text, {"deviation": deviation, "stated": stated, "other": needed})
