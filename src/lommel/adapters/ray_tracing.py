"""Pupils and field maps from traced rays, shared by the adapters.

The phase at a point of the pupil is that of its ray on the reference sphere around the chief ray's image point,
``2 pi (OPL - OPL_chief) / lambda``: a longer path is a later wave, ``exp(+i phase)``. Pupil points are fractions of
the entrance pupil; under the sine condition they are proportional to the direction cosines from the reference sphere
to that image point, the variables of Debye's integral. Off the axis the factors of both directions differ: the pupil
of a point is the ellipse that a linear map, by least squares, makes of the entrance pupil. Of a field map, and as in
the packages' own FFT PSFs, it is a circle, with ``1 / (2 n NA)`` of the geometric mean as f-number.

Ray tracers have y upwards, images here downwards: pupil and position are mirrored, seen from behind the sensor.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.field.maps import FieldMap, Foreshortening, foreshortened
from lommel.optics.aperture.mask import Mask
from lommel.optics.aperture.shapes import Ellipse
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

MAX_DEGREE = 20
"""Highest degree of the Zernike terms: that of the radial terms of a wavefront."""

# Fits of phase and rays differ by up to 1e-4 of the steepest slope in five lenses, fields of their edges included.
# What terms of too low a degree leave is up to a sixth of the tilt that they seem to have.
_TILT, _TILT_OF_SLOPES, _TILT_OF_REST = 0.1, 0.01, 10.0
_DARK = 1e-9  # amplitude of a component of the electric field that is left out
_ROUND = 1e-5  # below this ellipticity a pupil is a circle, for which all methods are


@dataclass(frozen=True)
class TracedField:
    """Rays from one object point in the frame of the ray tracer: z along the light, y upwards.

    Fractions x and y of the entrance pupil, phase (radians, NaN where blocked), direction cosines from the reference
    sphere (or of the rays) to the image times its index relative to the chief ray, where rays meet the sensor
    relative to the chief ray (metres), the chief ray there, and where light is polarised the amplitude of each
    component of the electric field, a column each.
    """

    x: Array
    y: Array
    phase: Array
    direction_x: Array
    direction_y: Array
    missed_x: Array
    missed_y: Array
    position: tuple[float, float]
    field: NDArray[np.complex128] | None = None


Trace = Callable[[float, float, Array, Array], TracedField]
"""From a field point, as fractions of its edge, and points of the pupil to their rays."""


def sample_points(degree: int, tol: float = 0.01) -> tuple[Array, Array]:
    """Return x and y of pupil points that determine Zernike terms up to `degree` and show residuals."""
    validation.real("tol", tol, above=0.0)
    validation.integer("degree", degree, least=2, most=MAX_DEGREE)
    # Gauss's rule in rho^2 and equal angles: least squares there are close to the integrals of the Zernike terms.
    nodes = gauss_legendre(degree // 2 + 4)[0]
    rho = np.sqrt(nodes)
    theta = 2.0 * math.pi / (2 * degree + 5) * np.arange(2 * degree + 5)
    return np.outer(rho, np.cos(theta)).ravel(), np.outer(rho, np.sin(theta)).ravel()


def fit(traced: TracedField, degree: int, tol: float) -> tuple[dict[tuple[int, int], float], float]:
    """Return Zernike coefficients (radians at the edge) and the f-number; ValueError beyond `tol` or if blocked."""
    slopes = _slopes(traced)
    # A pupil that is imaged upside down, as by a relay, is rotated by half a turn.
    turn = math.copysign(1.0, slopes[0])
    terms = _terms(traced.phase, turn * traced.x, -turn * traced.y, degree, tol)
    # f / # = 1 / (2 n sin): slopes are n sin over the pupil radius; the geometric mean of both directions.
    return terms, 0.5 / math.sqrt(slopes[0] * slopes[1])


def tilt_off_rays(traced: TracedField, wavelength: float) -> float:
    """Return the slope of the phase (radians over the pupil's radius) that the rays' positions do not show.

    Along where a ray misses the chief ray on the sensor the phase changes by -2 pi / wavelength times that and the
    change of its direction. 0 if the difference is that of fits.
    """
    if not np.isfinite(traced.phase).all():
        return 0.0  # which is told later
    degree = min(12, math.isqrt(traced.x.size) // 2)
    matrix = _zernike(traced.x, traced.y, degree)[1]
    fitted = np.linalg.pinv(matrix)
    rest = float(np.std(traced.phase - matrix @ (fitted @ traced.phase)))  # of too low a degree, which is told later
    # Derivatives of polynomials by central differences.
    step = 1e-4
    largest, mean = 0.0, []
    for dx, dy in ((step, 0.0), (0.0, step)):
        ends = (_zernike(traced.x + k * dx, traced.y + k * dy, degree)[1] for k in (1, -1))
        slope = (next(ends) - next(ends)) / (2.0 * step) @ fitted
        along = traced.missed_x * (slope @ traced.direction_x) + traced.missed_y * (slope @ traced.direction_y)
        by_rays = -2.0 * math.pi / wavelength * along
        largest = max(largest, float(np.abs(by_rays).max()))
        # The mean slope over the pupil is a tilt.
        mean.append(float((slope @ traced.phase - by_rays).mean()))
    off = math.hypot(*mean)
    return off if off > _TILT + _TILT_OF_SLOPES * largest + _TILT_OF_REST * rest else 0.0


def _checked_trace(trace: Trace, wavelength: float) -> Trace:
    """Return a trace whose phases agree with its rays; ValueError for a field where they do not."""

    def made(hx: float, hy: float, x: Array, y: Array) -> TracedField:
        traced = trace(hx, hy, x, y)
        if off := tilt_off_rays(traced, wavelength):
            raise ValueError(
                f"the lens must have phases that agree with its rays; those of the field ({hx:g}, {hy:g}) differ by "
                f"a tilt of {off:.3g} radians over the radius of the pupil"
            )
        return traced

    return made


def _slopes(traced: TracedField) -> list[float]:
    """Return the convergence of the rays in both directions; ValueError if some are blocked or it has no sign."""
    blocked = ~np.isfinite(traced.phase)
    if blocked.any():
        raise ValueError(
            f"{blocked.sum()} of {blocked.size} rays do not reach the image; vignetting and obscurations "
            "of a traced lens are not supported"
        )
    slopes = [
        -float(u @ v) / float(u @ u) for u, v in ((traced.x, traced.direction_x), (traced.y, traced.direction_y))
    ]
    if slopes[0] * slopes[1] <= 0.0:
        raise ValueError(
            "the rays do not converge towards an image in both directions; afocal lenses are not supported"
        )
    return slopes


def _zernike(x: Array, y: Array, degree: int) -> tuple[list[tuple[int, int]], Array]:
    """Return the Zernike terms up to a degree, and their values at points, in columns."""
    rho, theta = np.hypot(x, y), np.arctan2(y, x)
    terms = [(n, m) for n in range(degree + 1) for m in range(-n, n + 1, 2)]
    return terms, np.stack([zernike.polynomial(n, m, rho, theta) for n, m in terms], axis=1)


def _terms(phase: Array, x: Array, y: Array, degree: int, tol: float) -> dict[tuple[int, int], float]:
    """Return the Zernike coefficients (radians at the edge) of a phase; ValueError beyond `tol`."""
    terms, matrix = _zernike(x, y, degree)
    found = np.linalg.lstsq(matrix, phase, rcond=None)[0]
    rest = float(np.sqrt(np.mean((matrix @ found - phase) ** 2)))
    if not rest <= tol:
        raise ValueError(
            f"degree must be higher: Zernike terms up to {degree} leave {rest:.3g} rad rms, more than tol={tol:g}"
        )
    return {t: float(c) for t, c in zip(terms, found, strict=True) if t != (0, 0)}


def _seen_from_image(
    traced: TracedField, wavelength: float, degree: int, tol: float, obscuration: float = 0.0
) -> tuple[Pupil, Array]:
    """Return the pupil, an ellipse off the axis, and the matrix from the entrance pupil to its coordinates."""
    transform = _transform(traced)
    axes, (half, across), _ = np.linalg.svd(transform)
    ellipse = None
    if across > (1.0 - _ROUND) * half:
        half = math.sqrt(half * across)
    else:
        ellipse = Ellipse(1.0, float(across / half), math.atan2(axes[1, 0], axes[0, 0]))
    x, y = transform @ np.stack([traced.x, traced.y]) / half
    wavefront = Wavefront.zernike(_terms(traced.phase, x, y, degree, tol), normalization="edge")
    made = Pupil(wavefront, obscuration=obscuration, wavelength=wavelength, f_number=0.5 / float(half))
    return made if ellipse is None else foreshortened(made, ellipse), transform / half


def _transform(traced: TracedField) -> Array:
    """Return the matrix from points of the entrance pupil to the direction cosines at which the image sees them."""
    _slopes(traced)
    # Light travels against the place that it comes from, which is seen from behind the sensor.
    places = np.stack([-traced.direction_x, traced.direction_y], axis=1)
    return np.linalg.lstsq(np.stack([traced.x, traced.y], axis=1), places, rcond=None)[0].T


def single_pupil(
    trace: Trace,
    field: object,
    wavelength: float,
    degree: int,
    tol: float,
    obscuration: float = 0.0,
    *,
    circular: bool,
) -> Pupil:
    """Return the pupil at one point of the field, with the f-number there."""
    round_ = validation.truth("circular", circular)
    hx, hy = _point("field", field)
    traced = _checked_trace(trace, wavelength)(hx, hy, *sample_points(degree, tol))
    if not round_:
        return _seen_from_image(traced, wavelength, degree, tol, obscuration)[0]
    terms, f_number = fit(traced, degree, tol)
    wavefront = Wavefront.zernike(terms, normalization="edge")
    return Pupil(wavefront, obscuration=obscuration, wavelength=wavelength, f_number=f_number)


def polarized_pupils(
    trace: Trace, field: object, wavelength: float, degree: int, tol: float, side: int
) -> list[Pupil]:
    """Return a pupil of each component of the electric field that has light, with its amplitude as a mask."""
    hx, hy = _point("field", field)
    traced = _checked_trace(trace, wavelength)(hx, hy, *sample_points(degree, tol))
    pupil, transform = _seen_from_image(traced, wavelength, degree, tol)
    assert traced.field is not None
    _, matrix = _zernike(traced.x, traced.y, degree)
    found = np.linalg.lstsq(matrix, traced.field, rcond=None)[0]
    largest = float(np.abs(traced.field).max())
    rest = float(np.abs(matrix @ found - traced.field).max())
    if not rest <= tol * largest:
        raise ValueError(
            f"degree must be higher: Zernike terms up to {degree} leave {rest / largest:.3g} of the electric field, "
            f"more than tol={tol:g}"
        )
    at = (2.0 * np.arange(side) + 1.0 - side) / side
    place = np.stack([part.ravel() for part in np.meshgrid(at, at)])
    # A cell more than the radius: cells at the edge are partly inside.
    inside = np.hypot(*place) <= 1.0 + 2.0 / side
    x, y = np.linalg.solve(transform, place[:, inside])
    beyond = np.maximum(np.hypot(x, y), 1.0)  # of cells at the edge, and between the ellipse and the circle
    values = np.zeros((found.shape[1], side * side), dtype=np.complex128)
    values[:, inside] = (_zernike(x / beyond, y / beyond, degree)[1] @ found).T
    values /= max(1.0, np.abs(values).max())
    masks = [Mask(part.reshape(side, side)) for part in values if np.abs(part).max() > _DARK]
    return [replace(pupil, mask=mask) for mask in masks]


def field_map(
    trace: Trace,
    heights: int,
    fields: Sequence[object] | None,
    wavelength: float,
    degree: int,
    tol: float,
    obscuration: float = 0.0,
    ideal: Callable[[float], float] | None = None,
    *,
    circular: bool = True,
) -> FieldMap:
    """Return the map over the field, with the f-number on the axis; without `fields` a symmetric lens is required.

    Not `circular`, pupils are ellipses off the axis, and the f-number is that of the longest of their axes.

    `ideal` is where light arrives without distortion (metres, upwards), of a fraction of the edge of the field:
    positions are then these, and tilts move the light to where chief rays meet the sensor.
    """
    round_ = validation.truth("circular", circular)
    points, trace = sample_points(degree, tol), _checked_trace(trace, wavelength)
    if fields is None:
        return _radial_map(trace, points, heights, wavelength, degree, tol, obscuration, ideal, circular=round_)
    if ideal is not None:
        raise ValueError("fields must be left out with distortion, which is that of a rotationally symmetric lens")
    if not round_:
        raise ValueError("fields must be left out for elliptical pupils, which follow the symmetry of the lens")
    if not isinstance(fields, Sequence | np.ndarray):
        raise TypeError(f"fields must be a sequence of pairs (hx, hy), got {validation.shown(fields)}")
    f_number = fit(trace(0.0, 0.0, *points), degree, tol)[1]
    at = [_point(f"fields[{k}]", field) for k, field in enumerate(fields)]
    several = [trace(hx, hy, *points) for hx, hy in at]
    wavefront = _stack([fit(one, degree, tol)[0] for one in several])
    x, y = np.array([one.position for one in several]).reshape(-1, 2).T
    aperture = Pupil(obscuration=obscuration, wavelength=wavelength, f_number=f_number)
    return FieldMap.scattered(x, -y, wavefront, aperture=aperture)


def _radial_map(
    trace: Trace,
    points: tuple[Array, Array],
    heights: int,
    wavelength: float,
    degree: int,
    tol: float,
    obscuration: float,
    ideal: Callable[[float], float] | None,
    *,
    circular: bool,
) -> FieldMap:
    """Return the map of a rotationally symmetric lens from rays along y at `heights` image heights."""
    f_number = fit(trace(0.0, 0.0, *points), degree, tol)[1]
    count = validation.integer("heights", heights, least=2, most=1000)
    shares = np.linspace(0.0, 1.0, count)
    along = [trace(0.0, float(hy), *points) for hy in shares]
    position = np.array([one.position for one in along]) - along[0].position
    upwards = math.copysign(1.0, position[-1, 1])
    distances = upwards * position[:, 1]
    if not distances[-1] > 0.0:
        raise ValueError("the field of the lens must not be a single point: its edge is imaged onto the axis")
    axes = np.abs([np.diag(_transform(one)) for one in along])  # across the direction of the field, and along it
    half = 0.5 / f_number if circular else float(axes.max())
    aperture = Pupil(obscuration=obscuration, wavelength=wavelength, f_number=0.5 / half)

    def terms(traced: TracedField) -> dict[tuple[int, int], float]:
        if circular:
            return fit(traced, degree, tol)[0]
        x, y = _transform(traced) @ np.stack([traced.x, traced.y]) / half
        return _terms(traced.phase, x, y, degree, tol)

    azimuth = -0.5 * math.pi * upwards
    wavefront = _stack([terms(one) for one in along])
    made = FieldMap.radial(distances, wavefront, azimuth=azimuth, aperture=aperture)
    across = trace(1.0, 0.0, *points)
    _require_symmetry(made, terms(across), across.position, distances[-1], tol)
    if ideal is not None:
        straight = np.array([upwards * ideal(float(h)) for h in shares])
        # A tilt of c radians at the edge moves the image by c lambda N / pi.
        tilt = -upwards * math.pi / aperture.scale * (distances - straight)
        bent = wavefront + Wavefront.zernike({(1, -1): tilt}, normalization="edge")
        made, distances = FieldMap.radial(straight, bent, azimuth=azimuth, aperture=aperture), straight
    return made if circular else made.seen_through(Foreshortening(distances, *(axes.T / half)[::-1]))


def _require_symmetry(
    made: FieldMap, across: dict[tuple[int, int], float], position: tuple[float, float], reach: float, tol: float
) -> None:
    """Raise ValueError if the terms of rays at the edge of the field along x do not agree with those along y."""
    x, y = position
    asymmetric = abs(math.hypot(x, y) - reach) > 1e-6 * reach
    if not asymmetric:
        factor = reach / math.hypot(x, y)
        found = replace(made, vignetting=None).pupil(x * factor, -y * factor).wavefront
        rest = found - Wavefront.zernike(across, normalization="edge")
        asymmetric = any(abs(float(c)) > 10.0 * tol for c in rest.edge_terms().values())
    if asymmetric:
        raise ValueError("the lens is not rotationally symmetric; give fields, the points of the field to trace")


def _stack(several: Sequence[dict[tuple[int, int], float]]) -> Wavefront:
    terms = {t: np.array([one[t] for one in several]) for t in several[0]}
    return Wavefront.zernike(terms, normalization="edge")


def _point(name: str, value: object) -> tuple[float, float]:
    if not isinstance(value, tuple | list | np.ndarray) or len(value) != 2:
        raise TypeError(f"{name} must be a pair (hx, hy), got {validation.shown(value)}")
    hx, hy = (validation.real(f"{name}[{k}]", part) for k, part in enumerate(value))
    if math.hypot(hx, hy) > math.sqrt(2.0) + 1e-9:
        raise ValueError(f"{name} must be fractions of the edge of the field, from -1 to 1, got {(hx, hy)}")
    return hx, hy
