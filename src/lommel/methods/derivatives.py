r"""Images and the derivatives of :mod:`lommel.methods.derivative_names`, each with a proven error bound.

Radially symmetric phases of circular and annular pupils are differentiated by the radial series, which also gives
the derivatives with respect to position and scale; others of these apertures by the chordal rule, those of all other
apertures by the quadrature along rows. Polychromatic derivatives are sums over the wavelengths.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import NamedTuple, cast

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Images, Pixels, Wanted
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

TILTS = SHIFTS["column"], SHIFTS["row"]  # Zernike terms from which derivatives by the scale are made

_FINER = 0.1  # tolerance of samples over that of the derivative: filters multiply their errors by some 4

# Signature: method, pupils, pixels, specification -> samples with bounds.
Ask = Callable[[Method, BasePupil, Grid, Wanted], Images]

# In a pixel around ``v_c`` the position is ``v_c + u``. The average of ``v . grad I`` is ``v_c`` times the average
# of ``grad I``, given by derivatives by tilts, plus the average of ``u . grad I``, the change of the average as the
# pixel itself grows. Along x the latter multiplies the transfer function by ``cos(a w / 2) - sinc(a w / 2)``, the
# derivative of the sinc by ln a, and along y by the sinc; there are two such terms.


def _images(method: Method, pupil: BasePupil, grid: Grid, wanted: Wanted) -> Images:
    return method.images(pupil, grid, wanted)  # looked up on the instance: subclasses override it


def scaling_derivative(
    engine: Method,
    pupil: BasePupil,
    grid: Grid,
    tilts: Sequence[tuple[Array, Array]],
    threads: int = 0,
    ask: Ask = _images,
) -> tuple[Array, Array]:
    """Return ``v . grad I``, or its averages, from the derivatives of I by the :data:`TILTS`."""
    count, step = math.prod(pupil.shape), grid.step(pupil)
    total, error = np.zeros((count, *grid.shape)), np.zeros(count)
    across, down = (step / grid.side * part for part in grid.positions(pupil.shape))
    for v, (slope, off) in zip((across[:, None, :], down[:, :, None]), tilts, strict=True):
        total -= v * slope
        # An error of grad I counts times the largest v of the window.
        far = np.abs(v).max(axis=(1, 2))
        error += far * (off + 8.0 * 2.0**-53 * np.abs(slope).max(axis=(1, 2)))
    if grid.integrate:
        values, off = _strain(engine, pupil, grid, threads, ask)
        total += values
        error += off
    return total, error


def _strain(engine: Method, pupil: BasePupil, grid: Grid, threads: int, ask: Ask) -> tuple[Array, Array]:
    """Return averages of ``u . grad I``, u the position within the pixel, and absolute bounds on their errors."""
    step = grid.step(pupil)
    # The filter may add a thousandth of the tolerance; below 1e-13 rounding prevails.
    response = max(1e-3 * engine.tol * least_average(step), 1e-13)
    plain, growing = pad_filters(averaging_filter(step, response), averaging_filter(step, response, growing=True))
    # 2 (2 eps + (1 + eps) eps_T) A^2 for both terms: certificate, section 12, "Growth".
    # Neither response is larger than 2.
    missed = 2.0 * (2.0 * plain.error + growing.error * (1.0 + plain.error)) * pupil.amplitude**2
    # A phase or amplitude off by e changes U and its gradient by at most e int A; abs(u) <= a / sqrt(2).
    of_phase, of_light = pupil.left_out
    left = of_phase + 2.0 * of_light
    missed += math.sqrt(8.0) * step * left * (2.0 + left) * pupil.amplitude**2
    count = math.prod(pupil.shape)
    total, error = np.empty((count, *grid.shape)), np.empty(count)
    for part, values, off in _sampled(engine, pupil, grid, plain, threads, ask):
        total[part] = filter_axes(values, plain, growing, threads)
        total[part] += filter_axes(values, growing, plain, threads)
        error[part] = 2.0 * plain.gain * growing.gain * off + missed
    return total, error


def tilted(
    engine: Method, pupil: BasePupil, grid: Grid, threads: int = 0, ask: Ask = _images
) -> list[tuple[Array, Array]]:
    """Return the derivatives of I by the :data:`TILTS`, ``-grad I``, from samples of I alone."""
    step = grid.step(pupil)
    response = max(1e-3 * engine.tol * (least_average(step) if grid.integrate else 1.0), 1e-13)
    slope = slope_filter(step, response, averages=grid.integrate)
    plain = averaging_filter(step, response) if grid.integrate else Taps(slope.stride, np.ones(1), 0.0, 1.0)
    slope, plain = pad_filters(slope, plain)
    # The response to slopes is at most 2 within the band, that of averages 1: section 12, "Shifts".
    missed = (slope.error * (1.0 + plain.error) + 2.0 * plain.error) * pupil.amplitude**2
    count = math.prod(pupil.shape)
    (across, down), error = np.empty((2, count, *grid.shape)), np.empty(count)
    for part, values, off in _sampled(engine, pupil, grid, plain, threads, ask):
        across[part], down[part] = (
            filter_axes(values, plain, slope, threads),
            filter_axes(values, slope, plain, threads),
        )
        error[part] = plain.gain * slope.gain * off + missed
    return [(-across, error), (-down, error)]


def _sampled(
    engine: Method, pupil: BasePupil, grid: Grid, taps: Taps, threads: int, ask: Ask
) -> Iterator[tuple[slice, Array, Array]]:
    """Yield samples of I for these filters, a few pupils at a time, and bounds with the rounding errors of sums."""
    fine, rounded = engine.tightened(_FINER * engine.tol), (4 * taps.weights.size + 16) * 2.0**-53
    for part, one, pixels in blocks(pupil, grid, taps):
        question = one, sample_grid(pixels, taps), Wanted(threads=threads)
        # If the finer tolerance is beyond double precision, the method's own is used.
        _, made = first_within_tolerance((fine, engine), lambda way: ask(way, *question))  # noqa: B023
        yield part, made.values, made.brightest * (made.bound + rounded)


# ``dU/d eps = -(eps / pi) A(eps) int_0^2pi P(eps, theta) exp(-i eps v cos(theta - psi)) d theta``, minus the field of
# the rim, by the trapezoidal rule, which converges geometrically for a periodic entire integrand. U is that of the
# product rule of the aperture, exact for polynomials up to a degree. Both are products of two matrices, one for rows
# and one for columns.
#
# References
# ----------
# L. N. Trefethen and J. A. C. Weideman, "The exponentially convergent trapezoidal rule", SIAM Review 56, 385 (2014),
# doi:10.1137/130932132: Theorem 3.2.

_B = np.geomspace(1e-3, 8.0, 128)  # displacements of the path of integration
_NODES = 512  # nodes summed at once
_UNIT = 2.0**-53


def obscuration_derivative(pupil: Pupil, grid: Grid, error: float) -> tuple[Array, Array]:
    """Return the derivative of I by the obscuration, or its averages over pixels."""
    count = math.prod(pupil.shape)
    if not grid.integrate:
        return _samples(pupil, grid, error)
    step = grid.step(pupil)
    taps = averaging_filter(step, max(0.1 * error * least_average(step), 1e-13))
    total, off = np.empty((count, *grid.shape)), np.empty(count)
    # Bound on the integral of the modulus of the transfer function of the product of two fields.
    most = 2.0 * pupil.amplitude * _light(pupil)
    for part, one, pixels in blocks(pupil, grid, taps):
        values, wrong = _samples(one, sample_grid(pixels, taps), 0.3 * error)
        total[part] = filter_axes(values, taps, taps)
        off[part] = taps.gain**2 * (wrong + (2 * taps.weights.size + 8) * _UNIT * most)
    return total, off + (2.0 + taps.error) * taps.error * most


def _light(pupil: Pupil) -> float:
    """Return the largest field of the rim, ``2 eps A(eps)``."""
    eps = pupil.obscuration
    return 2.0 * eps * float(pupil.illumination.at(np.array(eps * eps)))


def _samples(pupil: Pupil, grid: Grid, error: float) -> tuple[Array, Array]:
    amplitude, light, eps = pupil.amplitude, _light(pupil), pupil.obscuration
    across, down = (grid.step(pupil) / grid.side * part for part in grid.positions(pupil.shape))
    reach = float(np.hypot(np.abs(across).max(axis=1), np.abs(down).max(axis=1)).max())
    # A tenth of the error for each of the two fields in the product.
    aim = max(0.1 * error / (amplitude + light), 1e-15)
    terms = pupil.wavefront.amplitudes()
    x, y, weight = pupil.rule(degree_needed([(n, w) for (n, _), w in terms.items()], reach, pupil.illumination, aim))
    disk = _fields(pupil, x, y, weight, across, down)
    nodes = _nodes(terms, eps, reach, aim / light)
    # The trapezoidal rule, by midpoints.
    theta = (np.arange(nodes) + 0.5) * (2.0 * math.pi / nodes)
    rim = _fields(pupil, eps * np.cos(theta), eps * np.sin(theta), np.full(nodes, 2.0 * eps / nodes), across, down)
    # A phase or amplitude off by e changes both fields by e times their largest value; roundings count likewise.
    left = pupil.wavefront.left_out + 2.0 * pupil.illumination.error
    # Roundings over the integral of the amplitude; certificate, section 8.
    of_terms = np.array([n * n + 10.0 + len(pupil.wavefront.terms) for n, _ in pupil.wavefront.terms])
    phases = float((np.abs(pupil.wavefront.edge) @ of_terms).max())
    left += _UNIT * (phases + 12.0 * reach + 3.0 * _NODES + max(nodes, weight.size) / _NODES + 40.0)
    of_disk, of_rim = aim + left * amplitude, aim + left * light
    off = np.full(len(across), 2.0 * (amplitude * of_rim + light * of_disk + of_rim * of_disk))
    return -2.0 * (disk.real * rim.real + disk.imag * rim.imag), off


def _nodes(terms: dict[tuple[int, int], float], eps: float, reach: float, error: float) -> int:
    """Return the number of equal angles that integrate the field of the rim to an error over its largest value."""
    # At ``theta + i b`` the integrand is at most ``exp(sum_j W_j |R_j(eps)| sinh(m_j b) + eps v sinh b)``; k nodes
    # err by twice that over ``e^(k b) - 1``, for every b > 0.
    size = eps * reach * np.sinh(_B)
    for (n, m), w in terms.items():
        size = size + w * abs(float(zernike.radial(n, m, np.array(eps)))) * np.sinh(np.minimum(m * _B, 700.0))
    return max(1, math.ceil(float(((size + math.log(2.0 / error + 1.0)) / _B).min())))


def _fields(pupil: Pupil, x: Array, y: Array, weight: Array, across: Array, down: Array) -> NDArray[np.complex128]:
    """Return ``sum weight P exp(-i (v_x x + v_y y))`` over nodes, for each pupil of the flattened stack."""
    rho, theta = np.hypot(x, y), np.arctan2(y, x)
    light = weight * pupil.illumination.at(rho * rho)
    wavefronts, shared = pupil.wavefront.flattened(), bool(np.all(across == across[0]) and np.all(down == down[0]))
    total = np.zeros((len(across), down.shape[1], across.shape[1]), dtype=np.complex128)
    for first in range(0, x.size, _NODES):
        part = slice(first, first + _NODES)
        for i in range(len(total)):
            if i == 0 or not shared:
                rows, columns = np.exp(-1j * np.outer(down[i], y[part])), np.exp(-1j * np.outer(x[part], across[i]))
            wave = light[part] * np.exp(1j * wavefronts[i].phase(rho[part], theta[part]))
            total[i] += (rows * wave) @ columns
    return total


Key = int | Term  # variable of an engine's derivative: k for the coefficient of rho^(2k), or a Zernike term

_MOST_POWERS = 4  # powers of rho^2 up to which radial terms are converted: their sums cancel
_MOST_CANCELLED = 321.0  # sum of the moduli of powers of the term of degree 8


class Slope(NamedTuple):
    """Derivative of images."""

    values: Pixels  # (n, height, width)
    error: Array  # (n,), bound over the peak of the images


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
) -> tuple[Method, Images, list[Slope]]:
    """Return the method, images, and their derivatives by checked names."""
    if (rule := _rule_of_terms(method, pupil, names, tol)) is not None:
        terms = cast("tuple[Term, ...]", tuple(names))
        made = with_model_error(rule.images(pupil, grid, wanted._replace(terms=terms)), pupil, rule, normalized=False)
        assert made.slopes is not None
        return rule, made, list(map(Slope, *made.slopes))
    sums = [parts(name, pupil, grid.step(pupil), energy=energy) for name in names]
    way, engine = engines(method, pupil, names, sums, tol)
    radial = isinstance(engine, NijboerZernike)
    sums = [each._replace(phases=translated(each.phases, powers=radial)) for each in sums]

    def simple(each: Parts) -> bool:
        """Return whether a derivative is a factor times one by a single coefficient, computed with the images."""
        tilt = radial and any(key in TILTS for key in each.phases)
        more = tilt or np.any(each.own) or np.any(each.scaling) or each.obscuration
        return way is engine and len(each.phases) == 1 and not more

    # Simple derivatives are stored with the images; all others are summed in double precision.
    stored, others = [each for each in sums if simple(each)], [each for each in sums if not simple(each)]
    keys = _keys(stored)
    made = with_model_error(_asked(way, pupil, grid, wanted, keys), pupil, way, normalized=False)
    taken = iter(_taken(made, stored, keys))
    pieces = _pieces(way, engine, pupil, grid, made, wanted, others) if others else {}
    slopes = [next(taken) if simple(each) else _combined(each, made, pieces, wanted.dtype) for each in sums]
    return way, made, slopes


def _keys(sums: Sequence[Parts]) -> tuple[Key, ...]:
    """Return the distinct variables of derivatives."""
    return tuple(dict.fromkeys(key for each in sums for key in each.phases))


def single_light(method: Method | None) -> Method | None:
    """Return the method for each wavelength; None if none was named."""
    return method.method if isinstance(method, Polychromatic) else method


def engines(
    method: Method | None, pupil: Pupil, names: Sequence[Name], sums: Sequence[Parts], tol: float
) -> tuple[Method, Method]:
    """Return the method of images, and that of their derivatives at each wavelength."""
    if not pupil.circular:
        _require_other(pupil, names, sums)
    engine, radial = single_light(method), pupil.radial and all(map(_radial, sums))
    if engine is None and not pupil.circular:
        engine = NonuniformFFT(tol)
    elif engine is None:
        engine = NijboerZernike(tol) if radial else ChordalGauss(tol)
    elif isinstance(engine, NijboerZernike) and not radial:
        listed = ", ".join(map(repr, names))
        raise ValueError(
            f"derivatives by {listed} are not available from NijboerZernike, which has those by radially symmetric "
            "terms and by shifts, of pupils that are radially symmetric too; use ChordalGauss, or name no method"
        )
    elif not isinstance(engine, NijboerZernike | ChordalGauss | NonuniformFFT):
        raise ValueError(
            f"derivatives are not available from {type(engine).__name__}; use NijboerZernike, ChordalGauss or "
            "NonuniformFFT, or name no method"
        )
    return (method if isinstance(method, Polychromatic) else engine), engine


def _require_other(pupil: Pupil, names: Sequence[Name], sums: Sequence[Parts]) -> None:
    """Raise ValueError for derivatives that are not available for apertures other than circular ones."""
    differences = "take differences, (psf(a + h) - psf(a - h)) / (2 h)"
    for name, each in zip(names, sums, strict=True):
        if each.obscuration:
            raise ValueError(f"derivatives by {name!r} are those of circular and annular apertures; {differences}")
        if each.unknown and pupil.segmented:
            raise ValueError(
                f"derivatives by {name!r} are those of apertures whose segments are in phase; {differences}"
            )
        if pupil.mask is not None and pupil.mask.squares and (name in SHIFTS or np.any(each.scaling)):
            raise ValueError(
                f"derivatives by {name!r} are not those of a mask with squares=True, whose cells spread light about "
                f"the axis; {differences}"
            )


def _rule_of_terms(
    method: Method | None, pupil: Pupil, names: Sequence[Name], tol: float
) -> ChordalGauss | NonuniformFFT | None:
    """Return a rule that computes all the derivatives, by distinct Zernike terms, itself; otherwise None."""
    if len({*names}) < len(names) or str in map(type, names):
        return None
    if method is not None:
        return method if isinstance(method, ChordalGauss | NonuniformFFT) else None
    if not pupil.circular:
        return NonuniformFFT(tol)
    return None if pupil.radial and all(map(_radial_key, cast("Sequence[Term]", names))) else ChordalGauss(tol)


def _radial_key(key: Key) -> bool:
    """Return whether the radial series can differentiate by a key: powers of rho, low radial terms, tilts."""
    return isinstance(key, int) or key in TILTS or (key[1] == 0 and key[0] <= 2 * _MOST_POWERS)


def _radial(each: Parts) -> bool:
    """Return whether the radial series can compute a derivative."""
    return all(map(_radial_key, each.phases)) and not each.obscuration


def translated(phases: Mapping[Key, Factor], *, powers: bool) -> dict[Key, Factor]:
    """Return factors by powers of rho as factors by Zernike terms (sums of powers), or the other way round."""
    found: dict[Key, Factor] = {}
    for key, factor in phases.items():
        shares: dict[Key, float] = {key: 1.0}
        if powers and isinstance(key, tuple) and key not in TILTS:
            column = zernike.legendre_to_powers(key[0] // 2)[:, -1]
            shares = {k: float(share) for k, share in enumerate(column, 1)}
        elif not powers and isinstance(key, int):
            column = zernike.powers_to_legendre(key)[1:, -1]
            shares = {(2 * j, 0): float(share) for j, share in enumerate(column, 1)}
        for other, share in shares.items():
            found[other] = found.get(other, 0.0) + share * factor
    return found


def _asked(engine: Method, pupil: Pupil, grid: Grid, wanted: Wanted, keys: tuple[Key, ...] = ()) -> Images:
    """Return images and their derivatives by coefficients of powers of rho or of Zernike terms."""
    powers = tuple(key for key in keys if isinstance(key, int))
    terms = tuple(key for key in keys if isinstance(key, tuple))
    return engine.images(pupil, grid, wanted._replace(powers=powers, terms=terms))


def _brightest(made: Images) -> Array:
    """Return a lower bound on the peak of each image, shape (n,)."""
    top = made.values.reshape(len(made.values), -1).max(axis=1).astype(np.float64)
    if made.peak is not None:
        top = np.maximum(top, made.peak * made.scale)
    return np.asarray(top / (1.0 + made.bound))


def _taken(made: Images, sums: Sequence[Parts], keys: tuple[Key, ...]) -> list[Slope]:
    """Return derivatives that are a factor times one by a single coefficient."""
    found, taken = [], set[int]()
    for each in sums:
        assert made.slopes is not None
        ((key, factor),) = each.phases.items()
        at = keys.index(key)
        values, error, by = made.slopes.values[at], made.slopes.error[at], _each(factor, len(made.values))
        if not np.all(by == 1.0):
            values = (values * by[:, None, None]).astype(values.dtype)
            rounded = _most(values) * storing(values.dtype) * (by != 2.0)  # powers of two are exact
            error = np.abs(by) * error + rounded / _brightest(made)
        # Two names may have the same derivative: each gets an array of its own.
        elif at in taken:
            values = values.copy()
        taken.add(at)
        found.append(Slope(values, error))
    return found


def _each(factor: Factor, count: int) -> Array:
    """Return a factor for each pupil, shape (count,)."""
    return np.broadcast_to(np.asarray(factor, dtype=np.float64), (count,))


def _most(values: Pixels) -> Array:
    """Return the largest modulus in each image."""
    return np.asarray(np.abs(values).reshape(len(values), -1).max(axis=1), dtype=np.float64)


def _pieces(
    way: Method, engine: Method, pupil: Pupil, grid: Grid, made: Images, wanted: Wanted, sums: Sequence[Parts]
) -> dict[object, Piece]:
    """Return the terms of derivatives of images, in double precision, over all light."""
    # Powers of rho in a radial term cancel: the sum of their moduli is up to 321.
    size = max(
        sum(float(np.abs(by).max()) for key, by in each.phases.items() if isinstance(key, int)) for each in sums
    )
    # Certificate, section 12, "Powers of rho^2": 3, 12, 63 and 321 for the terms up to degree 8.
    closer = engine.tightened(engine.tol / min(size, _MOST_CANCELLED)) if size > 2.0 else engine
    scales, obscures = (any(np.any(getattr(each, part)) for each in sums) for part in ("scaling", "obscuration"))
    keys = _keys(sums)
    asked = tuple(dict.fromkeys((*keys, *TILTS))) if scales else keys
    by_samples = isinstance(engine, NijboerZernike)  # tilts are not radial: they come from samples of I
    assert isinstance(wanted.scale, float)
    faintest = float(_brightest(made).min()) / wanted.scale
    found: dict[object, Piece] = {}

    def add(key: object, values: Array, error: Array, factor: float) -> None:
        before = found.get(key, Piece(np.zeros((1, 1, 1)), np.zeros(1)))
        found[key] = Piece(before.values + factor * values, before.error + factor * error)

    for part in way.components(pupil):
        scale, threads = wanted.scale * part.weight, wanted.threads
        left = (part.pupil.wavefront.left_out + 2.0 * part.pupil.illumination.error) * part.pupil.amplitude**2
        add("unknown", np.zeros((1, 1, 1)), np.full(1, 2.0 * left), scale)
        slopes: dict[Key, Piece] = {}
        if by_samples and any(key in TILTS for key in asked):
            for term, (values, error) in zip(TILTS, tilted(engine, part.pupil, grid, threads), strict=True):
                slopes[term] = Piece(values, error + 4.0 * left)
        if rest := tuple(key for key in asked if key not in slopes):
            ask = partial(_asked, pupil=part.pupil, grid=grid, wanted=Wanted(threads=threads), keys=rest)
            _, here = first_within_tolerance((closer, engine), ask)
            assert here.slopes is not None
            for key, values, error in zip(rest, *here.slopes, strict=True):
                slopes[key] = Piece(values, error * here.brightest + 4.0 * left)
        for key in keys:
            # Phases are path differences: in radians they grow as the wavelength falls.
            add(key, *slopes[key], scale * part.stretch)
        if scales:
            tilts = [slopes[key] for key in TILTS]
            add("scaling", *scaling_derivative(engine, part.pupil, grid, tilts, threads), scale)
        if obscures:
            add("obscuration", *obscuration_derivative(part.pupil, grid, 0.1 * engine.tol * faintest), scale)
    return found


def _combined(each: Parts, made: Images, pieces: Mapping[object, Piece], dtype: DTypeLike) -> Slope:
    """Return the stored sum of terms times their factors, and of the images themselves."""
    count, bright = len(made.values), _brightest(made)
    factors: list[tuple[object, Factor]] = [*each.phases.items()]
    factors += [(name, getattr(each, name)) for name in ("scaling", "obscuration", "unknown")]
    total = made.values * _each(each.own, count)[:, None, None].astype(np.float64)
    error = np.abs(_each(each.own, count)) * made.bound * bright * (1.0 + made.bound)
    size = _most(total)
    for key, factor in factors:
        by = _each(factor, count)
        if by.any():
            total += by[:, None, None] * pieces[key].values
            error = error + np.abs(by) * pieces[key].error
            size = size + np.abs(by) * _most(pieces[key].values)
    values = total.astype(dtype)
    # Certificate, section 12: k + 8 roundings of the sum of the largest magnitudes.
    error = error + (len(factors) + 8) * 2.0**-53 * size + storing(dtype) * _most(total)
    return Slope(values, error / bright)


def gradient(
    method: Method, pupil: Pupil, grid: Grid, names: Sequence[Name], weights: Array, scale: float, *, energy: bool
) -> dict[Name, Array]:
    """Return the derivatives of sums of `weights`, (n, height, width), times values, by checked names, each (n,).

    Values are `scale` times the intensity. Derivatives by phases use reverse mode where the chordal rule applies
    (certificate, section 8, "Derivatives"), all others are sums over images of derivatives.
    """
    tol, free = method.tol, _with_derivatives(method)
    sums = {name: parts(name, pupil, grid.step(pupil), energy=energy) for name in names}
    way, engine = engines(free, pupil, names, list(sums.values()), tol)
    found: dict[Name, Array] = {}
    if isinstance(engine, ChordalGauss):
        factors = {name: translated(each.phases, powers=False) for name, each in sums.items() if _by_phase(each)}
        terms = tuple(dict.fromkeys(t for phases in factors.values() for t in phases if isinstance(t, tuple)))
        each = np.zeros((len(weights), len(terms)))
        for part in way.components(pupil) if terms else ():
            rate = scale * part.weight * part.stretch  # phases grow as the wavelength falls
            each += rate * engine.gradient(part.pupil, grid, weights, terms)
        for name, phases in factors.items():
            found[name] = np.sum([by * each[:, terms.index(term)] for term, by in phases.items()], axis=0)
    if others := [name for name in names if name not in found]:
        _, _, slopes = differentiated(free, pupil, grid, others, Wanted(scale), tol, energy=energy)
        for name, slope in zip(others, slopes, strict=True):
            found[name] = np.einsum("nij,nij->n", weights, slope.values)
    return found


def _by_phase(each: Parts) -> bool:
    """Return whether a derivative is by coefficients of the phase alone."""
    return not (np.any(each.own) or np.any(each.scaling) or each.obscuration)


def _with_derivatives(method: Method) -> Method | None:
    """Return the method, or the default choice if another method has more derivatives."""
    # Both have equal images within the tolerance.
    if not isinstance(single_light(method), NijboerZernike | ChordalGauss):
        return method
    if isinstance(method, Polychromatic):
        return Polychromatic(method.wavelengths, method.weights, tol=method.tol)
    return None
