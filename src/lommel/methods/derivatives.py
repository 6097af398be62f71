r"""Images and the derivatives of :mod:`lommel.methods.derivative_names`, each with a proven error bound.

NijboerZernike computes derivatives by radially symmetric phases of circular and annular pupils, also by position and
scale; ChordalGauss by other phases of these pupils, and NonuniformFFT by all phases of other apertures. Polychromatic
derivatives are sums over the wavelengths.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import NamedTuple, cast

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Pixels, Samples, Wanted
from lommel.core.engine import least_average
from lommel.methods.averaging import (
    Taps,
    averaging_filter,
    blocks,
    filter_axes,
    pad_filters,
    sample_grid,
    slope_filter,
)
from lommel.methods.choice import first_within_tolerance
from lommel.methods.chordal_gauss import ChordalGauss
from lommel.methods.derivative_names import SHIFTS, Factor, Name, Parts, Term, parts
from lommel.methods.method import Method, storing, with_model_error
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.methods.nonuniform_fft import NonuniformFFT
from lommel.methods.polychromatic import Polychromatic
from lommel.optics.aperture.opening import degree_needed
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.special import zernike

TILTS = SHIFTS["column"], SHIFTS["row"]  # tilts along x and y; the derivatives of I by them are -grad I

_SAMPLE_TOL = 0.1  # tolerance of samples / tolerance of the derivative, since filters multiply errors by about 4

# Signature: method, pupils, pixels, specification -> samples with error bounds.
Sampler = Callable[[Method, BasePupil, Grid, Wanted], Samples]

# A position in the pixel with the centre ``v_c`` is ``v_c + u``. The average of ``v . grad I`` is ``v_c`` times the
# average of ``grad I`` plus the average of ``u . grad I``. Derivatives by tilts determine the first average. The
# second one is the derivative of the average of I by ln a, with the pixel pitch a: a sum of two terms, one for each
# axis. The term of x multiplies the transfer function by ``cos(a w / 2) - sinc(a w / 2)`` along x and by the sinc
# along y.


def _images(method: Method, pupil: BasePupil, grid: Grid, wanted: Wanted) -> Samples:
    return method.images(pupil, grid, wanted)  # a function, since subclasses override `images`


def scaling_derivative(
    engine: Method,
    pupil: BasePupil,
    grid: Grid,
    tilts: Sequence[tuple[Array, Array]],
    threads: int = 0,
) -> tuple[Array, Array]:
    """Return ``v . grad I``, or its averages, from the derivatives of I by :data:`TILTS`, with absolute bounds."""
    count, step = math.prod(pupil.shape), grid.step(pupil)
    total, error = np.zeros((count, *grid.shape)), np.zeros(count)
    vx, vy = (step / grid.side * part for part in grid.positions(pupil.shape))
    for v, (slope, bound) in zip((vx[:, None, :], vy[:, :, None]), tilts, strict=True):
        total -= v * slope
        # Errors of grad I are multiplied by v, at most the largest v of the window.
        largest_v = np.abs(v).max(axis=(1, 2))
        error += largest_v * (bound + 8.0 * 2.0**-53 * np.abs(slope).max(axis=(1, 2)))
    if grid.integrate:
        values, bound = _average_growth(engine, pupil, grid, threads)
        total += values
        error += bound
    return total, error


def _average_growth(engine: Method, pupil: BasePupil, grid: Grid, threads: int) -> tuple[Array, Array]:
    """Return averages of ``u . grad I``, u the position within the pixel, with absolute error bounds."""
    step = grid.step(pupil)
    # The filter may add an error of a thousandth of the tolerance; below 1e-13 rounding errors dominate.
    response = max(1e-3 * engine.tol * least_average(step), 1e-13)
    mean, scaling = pad_filters(averaging_filter(step, response), averaging_filter(step, response, by_pitch=True))
    # Bound for both terms, as responses are at most 2: 2 (2 eps + (1 + eps) eps_T) A^2 (section 12, "Growth").
    truncation = 2.0 * (2.0 * mean.error + scaling.error * (1.0 + mean.error)) * pupil.amplitude**2
    # A phase (or relative amplitude) error e changes U and grad U by at most e int A; abs(u) <= a / sqrt(2).
    phase_error, light_error = pupil.left_out
    omitted = phase_error + 2.0 * light_error
    truncation += math.sqrt(8.0) * step * omitted * (2.0 + omitted) * pupil.amplitude**2
    count = math.prod(pupil.shape)
    total, error = np.empty((count, *grid.shape)), np.empty(count)
    for part, values, bound in _sample_blocks(engine, pupil, grid, mean, threads):
        total[part] = filter_axes(values, mean, scaling, threads)
        total[part] += filter_axes(values, scaling, mean, threads)
        error[part] = 2.0 * mean.gain * scaling.gain * bound + truncation
    return total, error


def tilted(
    engine: Method, pupil: BasePupil, grid: Grid, threads: int = 0, compute: Sampler = _images
) -> list[tuple[Array, Array]]:
    """Return the derivatives by :data:`TILTS`, ``-grad I``, from samples of I alone, with absolute error bounds."""
    step = grid.step(pupil)
    response = max(1e-3 * engine.tol * (least_average(step) if grid.integrate else 1.0), 1e-13)
    slope = slope_filter(step, response, averages=grid.integrate)
    mean = averaging_filter(step, response) if grid.integrate else Taps(slope.stride, np.ones(1), 0.0, 1.0)
    slope, mean = pad_filters(slope, mean)
    # The responses of the derivative and averaging filters are at most 2 and 1 within the band: section 12, "Shifts".
    truncation = (slope.error * (1.0 + mean.error) + 2.0 * mean.error) * pupil.amplitude**2
    count = math.prod(pupil.shape)
    (dx, dy), error = np.empty((2, count, *grid.shape)), np.empty(count)
    for part, values, bound in _sample_blocks(engine, pupil, grid, mean, threads, compute):
        dx[part], dy[part] = (
            filter_axes(values, mean, slope, threads),
            filter_axes(values, slope, mean, threads),
        )
        error[part] = mean.gain * slope.gain * bound + truncation
    return [(-dx, error), (-dy, error)]


def _sample_blocks(
    engine: Method, pupil: BasePupil, grid: Grid, taps: Taps, threads: int, compute: Sampler = _images
) -> Iterator[tuple[slice, Array, Array]]:
    """Yield blocks of pupils: slice, samples of I for the filter, absolute bounds (with rounding of filter sums)."""
    finer, rounding = engine.tightened(_SAMPLE_TOL * engine.tol), (4 * taps.weights.size + 16) * 2.0**-53
    for part, pupils, pixels in blocks(pupil, grid, taps):
        arguments = pupils, sample_grid(pixels, taps), Wanted(threads=threads)
        # If double precision does not allow the smaller tolerance, the tolerance of the method is used.
        _, images = first_within_tolerance((finer, engine), lambda method: compute(method, *arguments))  # noqa: B023
        yield part, images.values, images.brightest * (images.bound + rounding)


# The field of the rim of the obscuration, equal to ``-dU/d eps``, is
# ``(eps / pi) A(eps) int_0^2pi P(eps, theta) exp(-i eps v cos(theta - psi)) d theta``. It is integrated by the
# trapezoidal rule, which converges geometrically for a periodic entire integrand. U is integrated by the product rule
# of the aperture, exact for polynomials up to a required degree. Both fields are computed as products of two
# matrices, one for rows and one for columns.
#
# References
# ----------
# L. N. Trefethen and J. A. C. Weideman, "The exponentially convergent trapezoidal rule", SIAM Review 56, 385 (2014),
# doi:10.1137/130932132: Theorem 3.2.

_B = np.geomspace(1e-3, 8.0, 128)  # displacements b of the path of integration into the complex plane
_NODES = 512  # number of nodes in one matrix product
_UNIT = 2.0**-53  # unit roundoff of double precision


def obscuration_derivative(pupil: Pupil, grid: Grid, error: float) -> tuple[Array, Array]:
    """Return the derivative of I by the obscuration, or its averages over pixels, with absolute error bounds."""
    count = math.prod(pupil.shape)
    if not grid.integrate:
        return _sample_slopes(pupil, grid, error)
    step = grid.step(pupil)
    taps = averaging_filter(step, max(0.1 * error * least_average(step), 1e-13))
    total, bounds = np.empty((count, *grid.shape)), np.empty(count)
    # Bound on the integral of the modulus of the transfer function of the product of two fields.
    ceiling = 2.0 * pupil.amplitude * _rim_maximum(pupil)
    for part, pupils, pixels in blocks(pupil, grid, taps):
        values, sample_error = _sample_slopes(pupils, sample_grid(pixels, taps), 0.3 * error)
        total[part] = filter_axes(values, taps, taps)
        bounds[part] = taps.gain**2 * (sample_error + (2 * taps.weights.size + 8) * _UNIT * ceiling)
    return total, bounds + (2.0 + taps.error) * taps.error * ceiling


def _rim_maximum(pupil: Pupil) -> float:
    """Return the largest modulus of the field of the rim, ``2 eps A(eps)``."""
    eps = pupil.obscuration
    return 2.0 * eps * float(pupil.illumination.at(np.array(eps * eps)))


def _sample_slopes(pupil: Pupil, grid: Grid, error: float) -> tuple[Array, Array]:
    amplitude, rim_peak, eps = pupil.amplitude, _rim_maximum(pupil), pupil.obscuration
    vx, vy = (grid.step(pupil) / grid.side * part for part in grid.positions(pupil.shape))
    largest_v = float(np.hypot(np.abs(vx).max(axis=1), np.abs(vy).max(axis=1)).max())
    # The error of each of the two fields in the product is a tenth of the allowed error.
    allowed = max(0.1 * error / (amplitude + rim_peak), 1e-15)
    terms = pupil.wavefront.amplitudes()
    degree = degree_needed([(n, w) for (n, _), w in terms.items()], largest_v, pupil.illumination, allowed)
    x, y, weight = pupil.rule(degree)
    disk = _fields(pupil, x, y, weight, vx, vy)
    nodes = _nodes(terms, eps, largest_v, allowed / rim_peak)
    # Trapezoidal rule, with nodes at midpoints.
    theta = (np.arange(nodes) + 0.5) * (2.0 * math.pi / nodes)
    rim = _fields(pupil, eps * np.cos(theta), eps * np.sin(theta), np.full(nodes, 2.0 * eps / nodes), vx, vy)
    # A phase error or relative amplitude error e, like rounding, changes a field by at most e times its maximum.
    omitted = pupil.wavefront.left_out + 2.0 * pupil.illumination.error
    # Rounding errors divided by the integral of the amplitude: certificate, section 8.
    per_term = np.array([n * n + 10.0 + len(pupil.wavefront.terms) for n, _ in pupil.wavefront.terms])
    phases = float((np.abs(pupil.wavefront.edge) @ per_term).max())
    omitted += _UNIT * (phases + 12.0 * largest_v + 3.0 * _NODES + max(nodes, weight.size) / _NODES + 40.0)
    disk_error, rim_error = allowed + omitted * amplitude, allowed + omitted * rim_peak
    bounds = np.full(len(vx), 2.0 * (amplitude * rim_error + rim_peak * disk_error + rim_error * disk_error))
    return -2.0 * (disk.real * rim.real + disk.imag * rim.imag), bounds


def _nodes(terms: dict[tuple[int, int], float], eps: float, largest_v: float, error: float) -> int:
    """Return the number of equally spaced angles for an `error` of the field of the rim, relative to its maximum."""
    # At ``theta + i b`` the integrand is at most ``exp(sum_j W_j abs(R_j(eps)) sinh(m_j b) + eps v sinh b)``. The
    # error of k nodes is at most twice this bound divided by ``e^(k b) - 1``, for every b > 0.
    growth = eps * largest_v * np.sinh(_B)
    for (n, m), w in terms.items():
        growth = growth + w * abs(float(zernike.radial(n, m, np.array(eps)))) * np.sinh(np.minimum(m * _B, 700.0))
    return math.ceil(float(((growth + math.log(2.0 / error + 1.0)) / _B).min()))


def _fields(pupil: Pupil, x: Array, y: Array, weight: Array, vx: Array, vy: Array) -> NDArray[np.complex128]:
    """Return ``sum weight P exp(-i (v_x x + v_y y))`` over nodes, for each pupil of the flattened stack."""
    rho, theta = np.hypot(x, y), np.arctan2(y, x)
    weighted = weight * pupil.illumination.at(rho * rho)
    wavefronts, same_axis = pupil.wavefront.flattened(), bool(np.all(vx == vx[0]) and np.all(vy == vy[0]))
    total = np.zeros((len(vx), vy.shape[1], vx.shape[1]), dtype=np.complex128)
    for start in range(0, x.size, _NODES):
        part = slice(start, start + _NODES)
        for i in range(len(total)):
            if i == 0 or not same_axis:
                rows, columns = np.exp(-1j * np.outer(vy[i], y[part])), np.exp(-1j * np.outer(x[part], vx[i]))
            wave = weighted[part] * np.exp(1j * wavefronts[i].phase(rho[part], theta[part]))
            total[i] += (rows * wave) @ columns
    return total


Key = int | Term  # variable of a derivative by an engine (method): k for the coefficient of rho^(2k), or a term

_MOST_POWERS = 4  # largest k of rho^(2k) in conversions of radial terms; terms of higher powers cancel
_MOST_CANCELLED = 321.0  # sum of the moduli of the coefficients of powers of rho, for the radial term of degree 8


class Slope(NamedTuple):
    """Derivative of images."""

    values: Pixels  # (n, height, width)
    error: Array  # (n,), bound relative to the peak of the images


class Piece(NamedTuple):
    """Term of a derivative, in double precision."""

    values: Array  # (n, height, width)
    error: Array  # (n,), absolute bound


def differentiated(
    method: Method | None,
    pupil: Pupil,
    grid: Grid,
    names: Sequence[Name],
    wanted: Wanted,
    tol: float,
    *,
    energy: bool,
) -> tuple[Method, Samples, list[Slope]]:
    """Return the method, the images, and their derivatives by checked `names`."""
    if method is None and pupil.strips is not None:
        compute = partial(differentiated, pupil=pupil, grid=grid, names=names, wanted=wanted, tol=tol, energy=energy)
        return first_within_tolerance((ChordalGauss(tol), NonuniformFFT(tol)), compute)[1]
    if (rule := _rule_of_terms(method, pupil, names, tol)) is not None:
        terms = cast("tuple[Term, ...]", tuple(names))
        images = rule.images(pupil, grid, wanted._replace(terms=terms))
        images = with_model_error(images, pupil, rule, normalized=False)
        assert images.slopes is not None
        return rule, images, list(map(Slope, *images.slopes))
    sums = [parts(name, pupil, grid.step(pupil), energy=energy) for name in names]
    method_used, engine = engines(method, pupil, names, sums, tol)
    radial = isinstance(engine, NijboerZernike)
    sums = [item._replace(phases=translated(item.phases, powers=radial)) for item in sums]

    def is_single(item: Parts) -> bool:
        """Return whether a derivative is a multiple of the derivative by one coefficient, without other parts."""
        tilt = radial and any(key in TILTS for key in item.phases)
        extra = tilt or np.any(item.image) or np.any(item.scaling) or item.obscuration
        return method_used is engine and len(item.phases) == 1 and not extra

    # Derivatives by one coefficient are computed with the images; others are summed in double precision.
    direct, summed = [item for item in sums if is_single(item)], [item for item in sums if not is_single(item)]
    keys = _keys(direct)
    images = with_model_error(_compute(method_used, pupil, grid, wanted, keys), pupil, method_used, normalized=False)
    singles = iter(_single_slopes(images, direct, keys))
    pieces = _sum_terms(method_used, engine, pupil, grid, images, wanted, summed) if summed else {}
    slopes = [next(singles) if is_single(item) else _combine(item, images, pieces, wanted.dtype) for item in sums]
    return method_used, images, slopes


def _keys(sums: Sequence[Parts]) -> tuple[Key, ...]:
    """Return the distinct variables of derivatives: powers of rho^2 and Zernike terms."""
    return tuple(dict.fromkeys(key for item in sums for key in item.phases))


def single_light(method: Method | None) -> Method | None:
    """Return the method for each wavelength; None for the automatic choice."""
    return method.method if isinstance(method, Polychromatic) else method


def engines(
    method: Method | None, pupil: Pupil, names: Sequence[Name], sums: Sequence[Parts], tol: float
) -> tuple[Method, Method]:
    """Return the method of the images, and the method of their derivatives at each wavelength."""
    if not pupil.circular:
        _require_available(pupil, names, sums)
    engine, radial = single_light(method), pupil.radial and all(map(_is_radial, sums))
    if engine is None and not pupil.circular:
        engine = NonuniformFFT(tol)
    elif engine is None:
        engine = NijboerZernike(tol) if radial else ChordalGauss(tol)
    elif isinstance(engine, NijboerZernike) and not radial:
        listed = ", ".join(map(repr, names))
        raise ValueError(
            f"derivatives by {listed} are not available from NijboerZernike, which supports radially symmetric terms "
            "and shifts, of radially symmetric pupils only; use ChordalGauss, or leave method out"
        )
    elif not isinstance(engine, NijboerZernike | ChordalGauss | NonuniformFFT):
        raise ValueError(
            f"derivatives are not available from {type(engine).__name__}; use NijboerZernike, ChordalGauss or "
            "NonuniformFFT, or leave method out"
        )
    return (method if isinstance(method, Polychromatic) else engine), engine


def _require_available(pupil: Pupil, names: Sequence[Name], sums: Sequence[Parts]) -> None:
    """Raise ValueError for derivatives that are not available for apertures other than circular ones."""
    differences = "take differences, (psf(a + h) - psf(a - h)) / (2 h)"
    for name, item in zip(names, sums, strict=True):
        if item.obscuration:
            raise ValueError(f"derivatives by {name!r} need a circular or annular aperture; {differences}")
        if item.unknown and pupil.segmented:
            raise ValueError(f"derivatives by {name!r} need an aperture with segments in phase; {differences}")
        if pupil.mask is not None and pupil.mask.squares and (name in SHIFTS or np.any(item.scaling)):
            raise ValueError(
                f"derivatives by {name!r} are not available for masks with squares=True, whose cells spread light "
                f"about the axis; {differences}"
            )


def _rule_of_terms(
    method: Method | None, pupil: Pupil, names: Sequence[Name], tol: float
) -> ChordalGauss | NonuniformFFT | None:
    """Return a method that computes all derivatives directly, if all are by distinct Zernike terms; else None."""
    if len({*names}) < len(names) or str in map(type, names):
        return None
    if method is not None:
        return method if isinstance(method, ChordalGauss | NonuniformFFT) else None
    if not pupil.circular:
        return NonuniformFFT(tol)
    return None if pupil.radial and all(map(_is_radial_key, cast("Sequence[Term]", names))) else ChordalGauss(tol)


def _is_radial_key(key: Key) -> bool:
    """Return whether NijboerZernike has the derivative by a power of rho, or by a term: low radial terms, tilts."""
    return isinstance(key, int) or key in TILTS or (key[1] == 0 and key[0] <= 2 * _MOST_POWERS)


def _is_radial(item: Parts) -> bool:
    """Return whether NijboerZernike can compute a derivative."""
    return all(map(_is_radial_key, item.phases)) and not item.obscuration


def translated(phases: Mapping[Key, Factor], *, powers: bool) -> dict[Key, Factor]:
    """Convert radial Zernike terms to powers of rho or, without `powers`, powers of rho to radial Zernike terms."""
    converted: dict[Key, Factor] = {}
    for key, factor in phases.items():
        coefficients: dict[Key, float] = {key: 1.0}
        if powers and isinstance(key, tuple) and key not in TILTS:
            column = zernike.legendre_to_powers(key[0] // 2)[:, -1]
            coefficients = {k: float(coefficient) for k, coefficient in enumerate(column, 1)}
        elif not powers and isinstance(key, int):
            column = zernike.powers_to_legendre(key)[1:, -1]
            coefficients = {(2 * j, 0): float(coefficient) for j, coefficient in enumerate(column, 1)}
        for new_key, coefficient in coefficients.items():
            converted[new_key] = converted.get(new_key, 0.0) + coefficient * factor
    return converted


def _compute(engine: Method, pupil: Pupil, grid: Grid, wanted: Wanted, keys: tuple[Key, ...] = ()) -> Samples:
    """Return images and their derivatives by coefficients of powers of rho or of Zernike terms."""
    powers = tuple(key for key in keys if isinstance(key, int))
    terms = tuple(key for key in keys if isinstance(key, tuple))
    return engine.images(pupil, grid, wanted._replace(powers=powers, terms=terms))


def _least_peak(images: Samples) -> Array:
    """Return a lower bound on the peak of each image, shape (n,), in the scale of the values."""
    largest = images.values.reshape(len(images.values), -1).max(axis=1).astype(np.float64)
    if images.peak is not None:
        largest = np.maximum(largest, images.peak * images.scale)
    return np.asarray(largest / (1.0 + images.bound))


def _single_slopes(images: Samples, sums: Sequence[Parts], keys: tuple[Key, ...]) -> list[Slope]:
    """Return the derivatives that are multiples of the derivative by one coefficient."""
    results, seen = [], set[int]()
    for item in sums:
        assert images.slopes is not None
        ((key, factor),) = item.phases.items()
        k = keys.index(key)
        values, error, c = images.slopes.values[k], images.slopes.error[k], _per_pupil(factor, len(images.values))
        if not np.all(c == 1.0):
            values = (values * c[:, None, None]).astype(values.dtype)
            rounded = _largest_moduli(values) * storing(values.dtype) * (c != 2.0)  # multiplication by 2 is exact
            error = np.abs(c) * error + rounded / _least_peak(images)
        # Two names may denote the same derivative: the second one is a copy.
        elif k in seen:
            values = values.copy()
        seen.add(k)
        results.append(Slope(values, error))
    return results


def _per_pupil(factor: Factor, count: int) -> Array:
    """Return a factor for each pupil, shape (count,)."""
    return np.broadcast_to(np.asarray(factor, dtype=np.float64), (count,))


def _largest_moduli(values: Pixels) -> Array:
    """Return the largest modulus of the values of each image."""
    return np.asarray(np.abs(values).reshape(len(values), -1).max(axis=1), dtype=np.float64)


def _sum_terms(
    method: Method, engine: Method, pupil: Pupil, grid: Grid, images: Samples, wanted: Wanted, sums: Sequence[Parts]
) -> dict[object, Piece]:
    """Return the terms of sums of derivatives, in double precision, each summed over the wavelengths."""
    # Powers of rho in a radial term cancel: the moduli of their coefficients have a sum of up to 321.
    cancellation = max(
        sum(float(np.abs(factor).max()) for key, factor in item.phases.items() if isinstance(key, int))
        for item in sums
    )
    # Certificate, section 12, "Powers of rho^2": the sums are 3, 12, 63 and 321 for the terms of degrees 2 to 8.
    finer_engine = engine.tightened(engine.tol / min(cancellation, _MOST_CANCELLED)) if cancellation > 2.0 else engine
    scaling, obscuration = (any(np.any(getattr(item, part)) for item in sums) for part in ("scaling", "obscuration"))
    keys = _keys(sums)
    engine_keys = tuple(dict.fromkeys((*keys, *TILTS))) if scaling else keys
    by_samples = isinstance(engine, NijboerZernike)  # tilts are not radial: filters compute them from samples of I
    assert isinstance(wanted.scale, float)
    least_peak = float(_least_peak(images).min()) / wanted.scale
    results: dict[object, Piece] = {}

    def add(key: object, values: Array, error: Array, factor: float) -> None:
        previous = results.get(key, Piece(np.zeros((1, 1, 1)), np.zeros(1)))
        results[key] = Piece(previous.values + factor * values, previous.error + factor * error)

    for part in method.components(pupil):
        scale, threads = wanted.scale * part.weight, wanted.threads
        omitted = (part.pupil.wavefront.left_out + 2.0 * part.pupil.illumination.error) * part.pupil.amplitude**2
        add("unknown", np.zeros((1, 1, 1)), np.full(1, 2.0 * omitted), scale)
        slopes: dict[Key, Piece] = {}
        if by_samples and any(key in TILTS for key in engine_keys):
            for term, (values, error) in zip(TILTS, tilted(engine, part.pupil, grid, threads), strict=True):
                slopes[term] = Piece(values, error + 4.0 * omitted)
        if other_keys := tuple(key for key in engine_keys if key not in slopes):
            derivative_images = partial(
                _compute, pupil=part.pupil, grid=grid, wanted=Wanted(threads=threads), keys=other_keys
            )
            _, part_images = first_within_tolerance((finer_engine, engine), derivative_images)
            assert part_images.slopes is not None
            for key, values, error in zip(other_keys, *part_images.slopes, strict=True):
                slopes[key] = Piece(values, error * part_images.brightest + 4.0 * omitted)
        for key in keys:
            # Optical path differences are constant: phases in radians are proportional to 1 / wavelength.
            add(key, *slopes[key], scale * part.stretch)
        if scaling:
            tilts = [slopes[key] for key in TILTS]
            add("scaling", *scaling_derivative(engine, part.pupil, grid, tilts, threads), scale)
        if obscuration:
            add("obscuration", *obscuration_derivative(part.pupil, grid, 0.1 * engine.tol * least_peak), scale)
    return results


def _combine(item: Parts, images: Samples, pieces: Mapping[object, Piece], dtype: DTypeLike) -> Slope:
    """Return the sum of images and terms, multiplied by their factors, rounded to `dtype`."""
    count, peak = len(images.values), _least_peak(images)
    factors: list[tuple[object, Factor]] = [*item.phases.items()]
    factors += [(name, getattr(item, name)) for name in ("scaling", "obscuration", "unknown")]
    total = images.values * _per_pupil(item.image, count)[:, None, None].astype(np.float64)
    error = np.abs(_per_pupil(item.image, count)) * images.bound * peak * (1.0 + images.bound)
    size = _largest_moduli(total)
    for key, factor in factors:
        weights = _per_pupil(factor, count)
        if weights.any():
            total += weights[:, None, None] * pieces[key].values
            error = error + np.abs(weights) * pieces[key].error
            size = size + np.abs(weights) * _largest_moduli(pieces[key].values)
    values = total.astype(dtype)
    # Certificate, section 12: at most k + 8 roundings of the sum of the largest moduli.
    error = error + (len(factors) + 8) * 2.0**-53 * size + storing(dtype) * _largest_moduli(total)
    return Slope(values, error / peak)


def gradient(
    method: Method, pupil: Pupil, grid: Grid, names: Sequence[Name], weights: Array, scale: float, *, energy: bool
) -> dict[Name, Array]:
    """Return derivatives of ``sum(weights * values)`` by checked names, each of shape (n,).

    `weights` are (n, height, width), values are `scale` times the intensity. Derivatives by phases use reverse mode
    if the chordal rule applies (certificate, section 8, "Derivatives"); others are sums over derivative images.
    """
    tol, candidate = method.tol, _with_derivatives(method)
    sums = {name: parts(name, pupil, grid.step(pupil), energy=energy) for name in names}
    method_used, engine = engines(candidate, pupil, names, list(sums.values()), tol)
    results: dict[Name, Array] = {}
    if isinstance(engine, ChordalGauss):
        factors = {name: translated(item.phases, powers=False) for name, item in sums.items() if _is_by_phase(item)}
        terms = tuple(dict.fromkeys(t for phases in factors.values() for t in phases if isinstance(t, tuple)))
        gradients = np.zeros((len(weights), len(terms)))
        for part in method_used.components(pupil) if terms else ():
            rate = scale * part.weight * part.stretch  # phases are proportional to 1 / wavelength
            gradients += rate * engine.gradient(part.pupil, grid, weights, terms)
        for name, phases in factors.items():
            results[name] = np.sum([c * gradients[:, terms.index(term)] for term, c in phases.items()], axis=0)
    if remaining := [name for name in names if name not in results]:
        _, _, slopes = differentiated(candidate, pupil, grid, remaining, Wanted(scale), tol, energy=energy)
        for name, slope in zip(remaining, slopes, strict=True):
            results[name] = np.einsum("nij,nij->n", weights, slope.values)
    return results


def _is_by_phase(item: Parts) -> bool:
    """Return whether a derivative is by coefficients of the phase only."""
    return not (np.any(item.image) or np.any(item.scaling) or item.obscuration)


def _with_derivatives(method: Method) -> Method | None:
    """Return the method, or None for the automatic choice if another method may have more derivatives."""
    # The images of both methods agree within the tolerance.
    if not isinstance(single_light(method), NijboerZernike | ChordalGauss):
        return method
    if isinstance(method, Polychromatic):
        return Polychromatic(method.wavelengths, method.weights, tol=method.tol)
    return None
