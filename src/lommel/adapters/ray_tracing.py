"""Pupils and field maps from traced rays, shared by the adapters.

The phase of a ray is ``2 pi (OPL - OPL_chief) / lambda``, with the optical path length OPL up to the reference sphere
around the image point of the chief ray. A longer path delays the wave, which has the factor ``exp(+i phase)``.

Pupil points (x, y) are fractions of the radius of the entrance pupil. Under the sine condition they are proportional
to the direction cosines from the reference sphere to the image point, which are the variables of Debye's integral.
Off the axis the factors differ between x and y, so that the pupil seen from the image is an ellipse: a linear map,
fitted by least squares, maps the entrance pupil to this ellipse. A circle instead, as in the FFT PSFs of ray tracers,
is less accurate. Its f-number is 1 / (2 s), where s is the geometric mean of n sin(angle) at the edge in x
and in y.

In ray tracers y points upwards, in images of lommel downwards. Pupils and positions are therefore mirrored: they are
seen from behind the sensor.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
import scipy

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.field.maps import FieldMap, Foreshortening, foreshortened
from lommel.measures.aperture_means import rms
from lommel.optics.aperture.shapes import Ellipse
from lommel.optics.colour.dispersion import TracedColour
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

MAX_DEGREE = 20
"""Maximum degree of the Zernike terms, equal to the maximum degree of the radial terms of a wavefront."""

# Accepted tilt between phases and rays: the sum of a constant (rad), a fraction of the steepest slope, and a multiple
# of the fit residual. For five lenses, up to the edge of the field, the tilt is at most 1e-4 of the steepest slope.
# If the degree is too low, the fit residual is up to a sixth of the tilt.
_TILT, _TILT_OF_SLOPES, _TILT_OF_RESIDUAL = 0.1, 0.01, 10.0
_HEIGHT_COUNTS = (5, 9, 17, 33, 65, 129)  # numbers of heights tried for a map
_BAND_COUNTS = (3, 5, 9, 17, 33)  # numbers of wavelengths tried for a band
_MIN_ELLIPTICITY = 1e-5  # a pupil with smaller ellipticity is treated as a circle, which all methods support


@dataclass(frozen=True)
class TracedField:
    """Rays from one object point in the frame of the ray tracer: z along the light, y upwards."""

    x: Array  # fractions of the entrance pupil
    y: Array
    phase: Array  # radians, NaN for a blocked ray
    direction_x: Array  # direction cosines towards the image times its refractive index, relative to the chief ray
    direction_y: Array
    missed_x: Array  # intersections with the sensor relative to the chief ray, metres
    missed_y: Array
    position: tuple[float, float]  # intersection of the chief ray with the sensor, metres

    def along_light(self, chief_z: float) -> TracedField:
        """Return the rays in a frame whose z runs along the light; `chief_z` is that of the chief ray's direction."""
        # After an odd number of mirrors light travels along -z: seen along it, x runs the other way.
        if chief_z > 0.0:
            return self
        x, y = self.position
        return replace(self, x=-self.x, direction_x=-self.direction_x, missed_x=-self.missed_x, position=(-x, y))


Trace = Callable[[float, float, Array, Array], TracedField]
"""Function that traces rays from a field point (hx, hy), in fractions of the largest field, through pupil points."""


def sample_points(degree: int, tol: float = 0.01) -> tuple[Array, Array]:
    """Return x and y of pupil points that determine Zernike terms up to `degree` and the residual of their fit."""
    validation.real("tol", tol, above=0.0)
    validation.integer("degree", degree, least=2, most=MAX_DEGREE)
    # Gauss-Legendre points in rho^2 at equal angles, at which a least-squares fit is close to a fit over the disc.
    nodes = gauss_legendre(degree // 2 + 4)[0]
    rho = np.sqrt(nodes)
    theta = 2.0 * math.pi / (2 * degree + 5) * np.arange(2 * degree + 5)
    return np.outer(rho, np.cos(theta)).ravel(), np.outer(rho, np.sin(theta)).ravel()


def fit(traced: TracedField, degree: int, tol: float) -> tuple[dict[tuple[int, int], float], float]:
    """Return Zernike coefficients (radians at the edge) and f-number; ValueError for blocked rays or a poor fit."""
    slopes = _fit_slopes(traced)
    # If the slopes are negative (a relay inverts the image of the pupil), rotate the pupil by pi.
    sign = math.copysign(1.0, slopes[0])
    terms = _fit_terms(traced.phase, sign * traced.x, -sign * traced.y, degree, tol)
    # The slopes are n sin(angle) at the pupil edge in x and y; the f-number is 1 / (2 * their geometric mean).
    return terms, 0.5 / math.sqrt(slopes[0] * slopes[1])


def tilt_off_rays(traced: TracedField, wavelength: float) -> float:
    """Return the tilt (radians per pupil radius) by which phases differ from ray positions; 0 if it is negligible.

    A ray that meets the sensor at a distance d from the chief ray has the phase gradient
    ``-2 pi / wavelength * d * gradient(direction)`` over the pupil.
    """
    if not np.isfinite(traced.phase).all():
        return 0.0  # blocked rays raise an error later
    degree = min(12, math.isqrt(traced.x.size) // 2)
    matrix = _zernike_matrix(traced.x, traced.y, degree)[1]
    to_coefficients = np.linalg.pinv(matrix)
    # A degree that is too low raises an error later.
    residual = float(np.std(traced.phase - matrix @ (to_coefficients @ traced.phase)))
    # The derivatives of the polynomials are central differences.
    step = 1e-4
    largest_slope, mean = 0.0, []
    for dx, dy in ((step, 0.0), (0.0, step)):
        shifted = (_zernike_matrix(traced.x + k * dx, traced.y + k * dy, degree)[1] for k in (1, -1))
        derivative = (next(shifted) - next(shifted)) / (2.0 * step) @ to_coefficients
        rate_x, rate_y = derivative @ traced.direction_x, derivative @ traced.direction_y
        by_rays = -2.0 * math.pi / wavelength * (traced.missed_x * rate_x + traced.missed_y * rate_y)
        largest_slope = max(largest_slope, float(np.abs(by_rays).max()))
        # The mean over the pupil of the difference between the slopes is the tilt.
        mean.append(float((derivative @ traced.phase - by_rays).mean()))
    tilt = math.hypot(*mean)
    return tilt if tilt > _TILT + _TILT_OF_SLOPES * largest_slope + _TILT_OF_RESIDUAL * residual else 0.0


def _check_phases(trace: Trace, wavelength: float) -> Trace:
    """Return a function that calls `trace`, and raises ValueError if phases and rays disagree at a field point."""

    def checked(hx: float, hy: float, x: Array, y: Array) -> TracedField:
        traced = trace(hx, hy, x, y)
        if tilt := tilt_off_rays(traced, wavelength):
            u, v = _fit_slopes(traced)
            moved = tilt * wavelength / (2.0 * math.pi * math.sqrt(abs(u * v)))  # the f-number is 1 / (2 slope)
            raise ValueError(
                f"the lens must have phases that agree with its rays; at the field ({hx:g}, {hy:g}) they differ by "
                f"a tilt of {tilt:.3g} radians over the radius of the pupil, which would move the image by "
                f"{1e6 * moved:.2g} um"
            )
        return traced

    return checked


def _fit_slopes(traced: TracedField) -> list[float]:
    """Return -d direction / d pupil point in x and y; ValueError if rays are blocked or do not converge."""
    blocked = ~np.isfinite(traced.phase)
    if blocked.any():
        raise ValueError(
            f"{blocked.sum()} of {blocked.size} rays do not reach the image; vignetting of a traced lens is not "
            "supported: remove its clear apertures, and give lommel.field.maps.Vignetting or a mask to the pupils"
        )
    slopes = [
        -float(u @ v) / float(u @ u) for u, v in ((traced.x, traced.direction_x), (traced.y, traced.direction_y))
    ]
    if slopes[0] * slopes[1] <= 0.0:
        raise ValueError(
            "the rays do not converge towards an image in both directions; afocal lenses are not supported"
        )
    return slopes


def _zernike_matrix(x: Array, y: Array, degree: int) -> tuple[list[tuple[int, int]], Array]:
    """Return the Zernike terms up to a degree, and the matrix (points, terms) of their values."""
    rho, theta = np.hypot(x, y), np.arctan2(y, x)
    terms = [(n, m) for n in range(degree + 1) for m in range(-n, n + 1, 2)]
    return terms, np.stack([zernike.polynomial(n, m, rho, theta) for n, m in terms], axis=1)


def _fit_terms(phase: Array, x: Array, y: Array, degree: int, tol: float) -> dict[tuple[int, int], float]:
    """Fit Zernike coefficients (radians at the edge) to a phase; ValueError if the rms residual exceeds `tol`."""
    terms, matrix = _zernike_matrix(x, y, degree)
    coefficients = np.linalg.lstsq(matrix, phase, rcond=None)[0]
    residual = float(np.sqrt(np.mean((matrix @ coefficients - phase) ** 2)))
    if not residual <= tol:
        raise ValueError(
            f"degree must be higher: Zernike terms up to {degree} leave {residual:.3g} rad rms, more than tol={tol:g}"
        )
    return {t: float(c) for t, c in zip(terms, coefficients, strict=True) if t != (0, 0)}


def _pupil_from_image(traced: TracedField, wavelength: float, degree: int, tol: float, obscuration: float) -> Pupil:
    """Return the pupil seen from the image, an ellipse off the axis."""
    transform = _fit_transform(traced)
    # The semi-axes are n sin(angle) at the ends of the axes of the ellipse.
    axes, (semi_major, semi_minor), _ = np.linalg.svd(transform)
    ellipse = None
    if semi_minor > (1.0 - _MIN_ELLIPTICITY) * semi_major:
        semi_major = math.sqrt(semi_major * semi_minor)
    else:
        ellipse = Ellipse(1.0, float(semi_minor / semi_major), math.atan2(axes[1, 0], axes[0, 0]))
    x, y = transform @ np.stack([traced.x, traced.y]) / semi_major
    wavefront = Wavefront.zernike(_fit_terms(traced.phase, x, y, degree, tol), normalization="edge")
    pupil = Pupil(
        wavefront,
        obscuration=obscuration,
        wavelength=wavelength,
        f_number=0.5 / float(semi_major),
        colour=TracedColour((wavelength,)),
    )
    return pupil if ellipse is None else foreshortened(pupil, ellipse)


def _fit_transform(traced: TracedField) -> Array:
    """Return the matrix from entrance pupil coordinates to direction cosines seen from the image."""
    _fit_slopes(traced)
    # A pupil point is seen opposite to the direction of its ray; the view from behind the sensor mirrors x again.
    directions = np.stack([-traced.direction_x, traced.direction_y], axis=1)
    return np.linalg.lstsq(np.stack([traced.x, traced.y], axis=1), directions, rcond=None)[0].T


def single_pupil(
    tracer: Callable[[float], Trace],
    field: object,
    wavelength: float,
    degree: int,
    tol: float,
    obscuration: float = 0.0,
    *,
    circular: bool,
    band: tuple[float, float] | None = None,
) -> Pupil:
    """Return the pupil, with its f-number, at one point of the field; `tracer` returns the trace at a wavelength.

    The pupil is known at its wavelength only, or over a `band`, from the shortest wavelength to the longest (metres).
    """
    as_circle = validation.truth("circular", circular)
    point, points = _check_point("field", field), sample_points(degree, tol)

    def trace_at(wave: float) -> TracedField:
        return _check_phases(tracer(wave), wave)(*point, *points)

    traced = trace_at(wavelength)
    if as_circle:
        terms, f_number = fit(traced, degree, tol)
        wavefront, colour = Wavefront.zernike(terms, normalization="edge"), TracedColour((wavelength,))
        pupil = Pupil(wavefront, obscuration=obscuration, wavelength=wavelength, f_number=f_number, colour=colour)
    else:
        pupil = _pupil_from_image(traced, wavelength, degree, tol, obscuration)
    if band is None:
        return pupil
    limits = validation.rising("band", band, count=2).tolist()
    if len(limits) != 2 or not limits[0] <= wavelength <= limits[1]:
        raise ValueError(
            f"band must be the shortest and longest wavelength, about the {wavelength:g} m of the pupil, got {band}"
        )
    return replace(pupil, colour=_trace_band(trace_at, traced, pupil, limits, degree, tol, as_circle))


def _trace_band(
    trace_at: Callable[[float], TracedField],
    reference: TracedField,
    pupil: Pupil,
    band: Sequence[float],
    degree: int,
    tol: float,
    circular: bool,
) -> TracedColour:
    """Return path differences over a band of wavelengths, in the coordinates and about the image point of a pupil.

    Wavelengths are added until path differences between them, interpolated, agree with traced ones.
    """
    scale = 2.0 * float(pupil.f_number or 0.0)
    sign = math.copysign(1.0, _fit_slopes(reference)[0])
    cone = _fit_transform(reference) * scale

    @cache
    def paths_at(wave: float) -> dict[tuple[int, int], float]:
        """Return the coefficients of the path difference at the edge, metres; ValueError if the cone differs."""
        traced = trace_at(wave)
        transform = _fit_transform(traced) * scale
        # An error e of the edge of the pupil changes amplitudes by up to 2 e.
        if 2.0 * (change := float(np.linalg.norm(transform - cone, 2))) > tol:
            raise ValueError(
                f"band must be narrower: at {wave:g} m the cone of light differs by {change:.2g} of its radius, more "
                f"than half of tol={tol:g}; trace a pupil for each wavelength"
            )
        x, y = (sign * traced.x, -sign * traced.y) if circular else transform @ np.stack([traced.x, traced.y])
        paths = {t: wave / (2.0 * math.pi) * c for t, c in _fit_terms(traced.phase, x, y, degree, tol).items()}
        # A shift of the image by d is a path difference of d / (2 N) at the edge; y is upwards in traced fields.
        for term, new, old in zip(((1, 1), (1, -1)), traced.position, reference.position, strict=True):
            paths[term] += math.copysign(1.0, term[1]) * (new - old) / scale
        return paths

    for count in _BAND_COUNTS:
        waves = np.linspace(band[0], band[-1], count)
        fits = [paths_at(float(wave)) for wave in waves]
        terms = tuple(fits[0])
        colour = TracedColour(tuple(waves.tolist()), terms, tuple(tuple(paths[t] for t in terms) for paths in fits))
        coloured, differences = replace(pupil, colour=colour), []
        for wave in (0.5 * (waves[1:] + waves[:-1])).tolist():
            phases = {t: 2.0 * math.pi / wave * path for t, path in paths_at(wave).items()}
            differences.append(_difference(coloured.in_light(wave), phases))
        if max(differences) <= tol:
            return colour
    raise ValueError(
        f"band must be narrower: between {count} traced wavelengths, interpolated wavefronts differ by up to "
        f"{max(differences):.3g} rad rms from traced ones, more than tol={tol:g}"
    )


def field_map(
    trace: Trace,
    heights: int | None,
    fields: Sequence[object] | None,
    wavelength: float,
    degree: int,
    tol: float,
    obscuration: float = 0.0,
    ideal: Callable[[float], float] | None = None,
    *,
    circular: bool = False,
) -> FieldMap:
    """Return the field map; without `fields` the lens must be rotationally symmetric.

    If `circular`, the map has the f-number on the axis. Otherwise pupils off the axis are ellipses, and the map has
    the f-number of the longest axis of all ellipses.

    `ideal` is a function that returns the image height without distortion (metres, upwards) for a fraction of the
    largest field. With it, these heights are the positions of the map, and tilts shift the light to actual positions.

    The lens is also traced between the positions of the map. ValueError if the interpolated pupils there differ from
    the traced pupils by more than `tol` (radians rms); if `heights` is None, it is increased until they agree.
    """
    as_circle = validation.truth("circular", circular)
    points, trace = sample_points(degree, tol), _check_phases(trace, wavelength)
    if fields is None:
        return _radial_map(trace, points, heights, wavelength, degree, tol, obscuration, ideal, circular=as_circle)
    if ideal is not None:
        raise ValueError("fields must be left out with distortion, which needs a rotationally symmetric lens")
    if not as_circle:
        raise ValueError(
            "fields need circular=True, circular pupils, which are less accurate off the axis: a map of elliptical "
            "pupils needs a rotationally symmetric lens; pupil() has the ellipse of one field point of any lens"
        )
    if not isinstance(fields, Sequence | np.ndarray):
        raise TypeError(f"fields must be a sequence of pairs (hx, hy), got {validation.shown(fields)}")
    f_number = fit(trace(0.0, 0.0, *points), degree, tol)[1]
    field_points = [_check_point(f"fields[{k}]", field) for k, field in enumerate(fields)]
    traced_fields = [trace(hx, hy, *points) for hx, hy in field_points]
    wavefront = _stack_fits([fit(traced, degree, tol)[0] for traced in traced_fields])
    x, y = np.array([traced.position for traced in traced_fields]).reshape(-1, 2).T
    colour = TracedColour((wavelength,))
    aperture = Pupil(obscuration=obscuration, wavelength=wavelength, f_number=f_number, colour=colour)
    scattered = FieldMap.scattered(x, -y, wavefront, aperture=aperture)
    _check_between_fields(scattered, trace, points, np.array(field_points), np.stack([x, y], axis=1), degree, tol)
    return scattered


def _check_between_fields(
    field_map: FieldMap,
    trace: Trace,
    points: tuple[Array, Array],
    fields: Array,
    positions: Array,
    degree: int,
    tol: float,
) -> None:
    """Raise ValueError if the map differs from traced wavefronts at the centres of triangles of field points."""
    extent = np.ptp(positions, axis=0).max()
    triangulation = scipy.spatial.Delaunay(positions / extent)
    for hx, hy in fields[triangulation.simplices].mean(axis=1):
        traced = trace(float(hx), float(hy), *points)
        x, y = traced.position
        if triangulation.find_simplex(np.array([x, y]) / extent) < 0:
            continue  # distortion moves the centre of a narrow triangle at the border out of the map
        difference = _difference(field_map.pupil(x, -y), fit(traced, degree, tol)[0])
        if difference > tol:
            raise ValueError(
                f"fields must be closer together: at ({hx:.3g}, {hy:.3g}), between them, the interpolated wavefront "
                f"differs by {difference:.3g} rad rms from the traced one, more than tol={tol:g}"
            )


def _difference(pupil: Pupil, terms: dict[tuple[int, int], float]) -> float:
    """Return the rms difference in radians between the phase of a pupil and the phase of Zernike coefficients."""
    return float(rms(pupil.wavefront - Wavefront.zernike(terms, normalization="edge")))


def _semi_axes(traced: TracedField) -> Array:
    """Return n sin(angle) at the edge of the pupil in x and in y, its semi-axes for a field point along y."""
    return np.abs(np.diag(_fit_transform(traced)))


def _radial_map(
    trace: Trace,
    points: tuple[Array, Array],
    heights: int | None,
    wavelength: float,
    degree: int,
    tol: float,
    obscuration: float,
    ideal: Callable[[float], float] | None,
    *,
    circular: bool,
) -> FieldMap:
    """Return the map of a rotationally symmetric lens from `heights` field points along y."""
    trace_height = cache(lambda fraction: trace(0.0, fraction, *points))
    axis, edge = trace_height(0.0), trace_height(1.0)
    f_number = fit(axis, degree, tol)[1]
    upwards = math.copysign(1.0, edge.position[1] - axis.position[1])

    def distance(fraction: float) -> float:
        return upwards * (trace_height(fraction).position[1] - axis.position[1])

    if not distance(1.0) > 0.0:
        raise ValueError("the largest field of the lens must be off the axis, but its image is on the axis")
    along_x = trace(1.0, 0.0, *points)

    def build(count: int) -> tuple[FieldMap, float]:
        """Return the map of `count` heights, and its largest difference from pupils traced between them."""
        fractions = np.linspace(0.0, 1.0, count).tolist()
        distances = [distance(h) for h in fractions]
        # n sin(angle) at the edge of each pupil, perpendicular (x) and parallel (y) to the direction of the field.
        axes = np.array([_semi_axes(trace_height(h)) for h in fractions])
        longest = 0.5 / f_number if circular else float(axes.max())
        colour = TracedColour((wavelength,))
        aperture = Pupil(obscuration=obscuration, wavelength=wavelength, f_number=0.5 / longest, colour=colour)

        def terms(traced: TracedField) -> dict[tuple[int, int], float]:
            if circular:
                return fit(traced, degree, tol)[0]
            x, y = _fit_transform(traced) @ np.stack([traced.x, traced.y]) / longest
            return _fit_terms(traced.phase, x, y, degree, tol)

        terms_at = cache(lambda fraction: terms(trace_height(fraction)))

        def shifted_terms(fraction: float) -> dict[tuple[int, int], float]:
            fitted = dict(terms_at(fraction))
            if ideal is not None:
                # A tilt of c radians at the edge moves the image by c lambda N / pi.
                shift = distance(fraction) - upwards * ideal(fraction)
                fitted[1, -1] = fitted.get((1, -1), 0.0) - upwards * math.pi / aperture.scale * shift
            return fitted

        azimuth = -0.5 * math.pi * upwards
        wavefront = _stack_fits([terms_at(h) for h in fractions])
        radial_map = FieldMap.radial(distances, wavefront, azimuth=azimuth, aperture=aperture)
        _require_symmetry(radial_map, terms(along_x), along_x.position, distances[-1], tol)
        if ideal is not None:
            distances = [upwards * ideal(h) for h in fractions]
            wavefront = _stack_fits([shifted_terms(h) for h in fractions])
            radial_map = FieldMap.radial(distances, wavefront, azimuth=azimuth, aperture=aperture)
        foreshortening = None if circular else Foreshortening(distances, *(axes.T / longest)[::-1])
        differences = []
        for fraction in np.mean([fractions[1:], fractions[:-1]], axis=0).tolist():
            height = distance(fraction) if ideal is None else upwards * ideal(fraction)
            differences.append(_difference(radial_map.pupil(0.0, -upwards * height), shifted_terms(fraction)))
            if foreshortening is not None:
                # An error e of a semi-axis changes amplitudes by up to 2 e, as a phase error of 2 e rad rms does.
                ellipse = foreshortening.at(height, 0.0) or Ellipse(1.0, 1.0)
                semi_x, semi_y = _semi_axes(trace_height(fraction)) / longest
                differences.append(2.0 * max(abs(ellipse.a - semi_y), abs(ellipse.b - semi_x)))
        return radial_map if foreshortening is None else radial_map.seen_through(foreshortening), max(differences)

    counts = _HEIGHT_COUNTS if heights is None else (validation.integer("heights", heights, least=2, most=1000),)
    for count in counts:
        radial_map, difference = build(count)
        if difference <= tol:
            return radial_map
    raise ValueError(
        f"heights must be more: between {count} heights of the field, interpolated pupils differ by up to "
        f"{difference:.3g} rad rms from traced pupils, more than tol={tol:g}"
        + ("" if heights is None else "; leave heights out to have as many as tol requires")
    )


def _require_symmetry(
    radial_map: FieldMap,
    along_x: dict[tuple[int, int], float],
    position: tuple[float, float],
    edge: float,
    tol: float,
) -> None:
    """Raise ValueError if the terms at the edge of the field along x disagree with the map of fields along y."""
    x, y = position
    is_asymmetric = abs(math.hypot(x, y) - edge) > 1e-6 * edge
    if not is_asymmetric:
        factor = edge / math.hypot(x, y)
        expected = replace(radial_map, vignetting=None).pupil(x * factor, -y * factor).wavefront
        difference = expected - Wavefront.zernike(along_x, normalization="edge")
        is_asymmetric = any(abs(float(c)) > 10.0 * tol for c in difference.edge_terms().values())
    if is_asymmetric:
        raise ValueError("the lens is not rotationally symmetric; give fields, the points of the field to trace")


def _stack_fits(fits: Sequence[dict[tuple[int, int], float]]) -> Wavefront:
    """Return the stack of wavefronts from their Zernike coefficients (radians at the edge)."""
    stacked = {t: np.array([terms[t] for terms in fits]) for t in fits[0]}
    return Wavefront.zernike(stacked, normalization="edge")


def _check_point(name: str, value: object) -> tuple[float, float]:
    """Return a checked field point (hx, hy)."""
    if not isinstance(value, tuple | list | np.ndarray) or len(value) != 2:
        raise TypeError(f"{name} must be a pair (hx, hy), got {validation.shown(value)}")
    hx, hy = (validation.real(f"{name}[{k}]", part) for k, part in enumerate(value))
    if math.hypot(hx, hy) > math.sqrt(2.0) + 1e-9:
        raise ValueError(f"{name} must be fractions of the largest field, from -1 to 1, got {(hx, hy)}")
    return hx, hy
