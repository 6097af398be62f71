r"""Derivatives of microscope stacks by stage, depth and position of the axis, with error bounds.

Fields are sums of ``exp(i psi)``, so that derivatives by a parameter in which psi is linear are sums over the same
angles with a factor ``i dpsi/dx``. When the axis moves, samples change by ``dI/dv``, and averages by the difference
of line averages along two sides of each pixel. The light collected from an emitter near the cover glass depends on
depth.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from types import MappingProxyType
from typing import TYPE_CHECKING, cast

import numpy as np

from lommel.base.arrays import Array
from lommel.core import engine
from lommel.core.answers import Declined, Samples, Slopes, Wanted
from lommel.methods.averaging import averaged_images, pixel_averages, to_images
from lommel.methods.derivative_names import SHIFTS, Term, term_of
from lommel.methods.derivatives import Slope, tilted
from lommel.methods.layers import chordal_debye
from lommel.methods.layers.chordal_debye import ChordalDebye
from lommel.methods.layers.debye_rings import DebyeRings
from lommel.methods.layers.stratified import By, Stratified, differentiated, is_supported
from lommel.methods.method import Method, storing, with_model_error
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid
from lommel.optics.layers import debye
from lommel.optics.layers.objective_pupil import ObjectivePupil

if TYPE_CHECKING:
    from lommel.methods.derivative_names import Name


Rates = Callable[[ObjectivePupil], Sequence[By]]  # signature: planes -> derivatives of their images


def sampled_slopes(
    method: Method,
    pupil: ObjectivePupil,
    grid: Grid,
    rates: Rates,
    wanted: Wanted,
    terms: tuple[tuple[int, int], ...] = (),
    *,
    by_axis: bool = False,
) -> Samples:
    """Return images and their derivatives; derivatives by Zernike `terms`, from ChordalDebye, follow the others.

    With `by_axis`, which requires pixel averages, the last two derivatives are by the row and the column of the axis.
    """
    by = rates(pupil)
    largest_rates = debye.steepest(pupil.layers, pupil.light.model)
    # Divisors with which OTFs have at most twice the modulus of the OTF of the aperture, as averages assume:
    # certificate, section 15, "Light that depends on the azimuth".
    divisors = [largest_rates[d.variable] + 0.5 * _largest(d.image_factor) for d in by]
    divisors += [1.0] * len(terms)

    def sample(pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Samples:
        pairs, images_only = list(zip(rates(pupil), divisors, strict=False)), wanted._replace(terms=())
        if isinstance(method, ChordalDebye):
            return _by_chords(method, pupil, grid, pairs, terms, tol, images_only)
        if isinstance(method, DebyeRings):
            return method._samples(pupil, grid, tol, images_only)
        return _by_engine(pupil, grid, pairs, tol, images_only)

    request = wanted._replace(terms=((0, 0),) * len(divisors))  # placeholders: only their number matters
    if by_axis:
        images = to_images(pixel_averages(sample, pupil, grid, method.tol, request, gradients=True), request)
        divisors += [-grid.step(pupil)] * 2
    else:
        images = averaged_images(sample, pupil, grid, method.tol, request)
    images = with_model_error(images, pupil, method, normalized=False)
    assert images.slopes is not None
    values, error = images.slopes
    for array, divisor in zip(values, divisors, strict=True):
        array *= divisor
    error *= np.abs(divisors)[:, None]
    return images._replace(slopes=Slopes(values, error))


def _largest(values: Array | float) -> float:
    return float(np.abs(values).max(initial=0.0)) if isinstance(values, np.ndarray) else abs(values)


def engine_slopes(
    pupil: ObjectivePupil,
    grid: Grid,
    by: Sequence[By],
    tol: float,
    wanted: Wanted,
    compute: Callable[[], Samples] | None,
) -> Samples | None:
    """Return images and derivatives by the engine, or None if it does not support the window."""
    # Derivatives have bounds but no tolerance. If rounding prevents the tolerance of the images, a larger one is used
    # for the derivatives; the images are then computed by `compute` or, if this is None, with the larger tolerance.
    for loosening in (1.0, 10.0, 100.0, 1000.0):
        if (result := differentiated(pupil, grid, by, loosening * tol, wanted)) is not None:
            return result if loosening == 1.0 or compute is None else compute()._replace(slopes=result.slopes)
    return None


def _by_engine(
    pupil: ObjectivePupil, grid: Grid, pairs: Sequence[tuple[By, float]], tol: float, wanted: Wanted
) -> Samples:
    """Return samples by Stratified, and derivatives, divided by the divisors in `pairs`."""
    by = [d._replace(factor=1.0 / divisor, image_factor=np.asarray(d.image_factor) / divisor) for d, divisor in pairs]
    method = Stratified(max(tol, Stratified.least_tol))
    result = engine_slopes(pupil, grid, by, method.tol, wanted, lambda: method._samples(pupil, grid, tol, wanted))
    if result is None:
        raise Declined(
            "derivatives of light that depends on the azimuth are available in windows up to "
            f"{110.0 / grid.step(pupil):.0f} pixels from each axis; use a smaller shape, or a larger tol"
        )
    return result


def _by_chords(
    method: ChordalDebye,
    pupil: ObjectivePupil,
    grid: Grid,
    pairs: Sequence[tuple[By, float]],
    terms: tuple[tuple[int, int], ...],
    tol: float,
    wanted: Wanted,
) -> Samples:
    """Return samples by ChordalDebye, and derivatives, divided by the divisors in `pairs`; Zernike terms are last."""
    by = chordal_debye.By(tuple(d.variable for d, _ in pairs), terms)
    images, values, error_bound, largest = method.differentiated(pupil, grid, tol, wanted, by)
    largest_rates = debye.steepest(pupil.layers, pupil.light.model)
    factors = np.ones(len(values))
    factors[: len(pairs)] = [largest_rates[d.variable] / divisor for d, divisor in pairs]
    values *= (factors[:, None] * images.scale)[:, :, None, None]
    error, largest = (factors[:, None] * bounds for bounds in (error_bound, largest))
    for k, (d, divisor) in enumerate(pairs):
        if _largest(d.image_factor) > 0.0:
            offset = np.asarray(d.image_factor) / divisor
            values[k] += np.broadcast_to(offset, images.scale.shape)[:, None, None] * images.values
            error[k] += np.abs(offset) * (images.bound + 1e-12) * images.brightest
            largest[k] += np.abs(offset) * (1.0 + 2.0 * images.bound) * images.brightest
    # Rounding errors of storing and of the products with the factors above.
    error += (storing(wanted.dtype) + 2.0**-48) * largest
    error /= images.brightest
    return images._replace(slopes=Slopes(values.astype(wanted.dtype, copy=False), error))


_BY_CHORDS_ONLY = (
    "derivatives by Zernike terms and, with aberrations, by 'z' and 'depth' are available from ChordalDebye only, "
    "for small windows and aberrations; use a smaller shape"
)
LAYERED = (Stratified, DebyeRings, ChordalDebye)  # methods with derivatives: DebyeRings by the axis alone
_AXIS = ("row", "column")  # derivatives by the position of the axis
_PARAMETERS = ("z", "depth")  # derivatives by parameters of the planes


def layered_slopes(
    method: Method, pupil: ObjectivePupil, grid: Grid, names: Sequence[Name], wanted: Wanted
) -> tuple[Method, Samples, list[Slope]]:
    """Return the method, images and their derivatives by checked names."""
    zernike_names = {name: term for name in names if (term := term_of(name)) is not None}
    terms = tuple(dict.fromkeys(zernike_names.values()))
    kinds = [str(name) for name in dict.fromkeys(names) if name in _PARAMETERS]
    _require_available(method, pupil, names, zernike_names)
    axis = any(name in _AXIS for name in names)
    far, by_engine = isinstance(wanted.scale, np.ndarray), pupil.radial and isinstance(method, Stratified)

    def rates(planes: ObjectivePupil) -> list[By]:
        return [by_name(name, planes, far=far) for name in kinds]

    if by_engine:
        images = _radial(method, pupil, grid, kinds, rates(pupil), wanted, axis)
    elif kinds or terms or (axis and grid.integrate and not isinstance(method, Stratified)):
        images = sampled_slopes(method, pupil, grid, rates, wanted, terms, by_axis=axis and grid.integrate)
    else:
        images = with_model_error(method.images(pupil, grid, wanted), pupil, method, normalized=False)
    slopes: dict[Name, Slope] = {}
    if images.slopes is not None:  # derivatives by the axis, if present, are last
        slopes |= zip((*kinds, *terms, *_AXIS), map(Slope, *images.slopes), strict=False)
    if axis and "row" not in slopes:
        slopes |= _axis_slopes(method, pupil, grid, images, wanted)
    return method.reported, images, [slopes[zernike_names.get(name, name)] for name in names]


def _require_available(
    method: Method, pupil: ObjectivePupil, names: Sequence[Name], zernike_names: Mapping[Name, Term]
) -> None:
    """Raise ValueError for unavailable derivatives, or Declined if another method may have them."""
    if not isinstance(method, LAYERED):
        raise ValueError(
            f"derivatives are not available from {type(method).__name__} for an Objective; use Stratified, "
            "ChordalDebye or, with aberrations, DebyeRings"
        )
    if unknown := [name for name in names if name not in (*_PARAMETERS, *_AXIS, *zernike_names)]:
        raise ValueError(
            "derivatives of the pupils of an Objective are by 'z', 'depth', 'row', 'column' or Zernike "
            f"terms, got {unknown[0]!r}"
        )
    inner = names if isinstance(method, DebyeRings) else zernike_names
    if not isinstance(method, ChordalDebye) and any(name not in _AXIS for name in inner):
        raise Declined(_BY_CHORDS_ONLY)
    if isinstance(method, Stratified) and not is_supported(pupil.light):
        raise ValueError(
            f"derivatives are not available for the light of {pupil.emitter!r} from Stratified; use "
            "method=ChordalDebye(), in small windows"
        )


def _axis_slopes(
    method: Method, pupil: ObjectivePupil, grid: Grid, images: Samples, wanted: Wanted
) -> dict[Name, Slope]:
    """Return derivatives by the axis: section 12."""
    step = grid.step(pupil)
    # A phase that the Zernike terms omit changes fields and their gradients by at most the same amount.
    omitted = 4.0 * pupil.left_out[0]
    tilts = tilted(method, pupil, grid, wanted.threads, _samples)
    return {
        name: _stored(step * values, step * (error + omitted), images, wanted)
        for name, (values, error) in zip(("column", "row"), tilts, strict=True)
    }


def _radial(
    method: Method, pupil: ObjectivePupil, grid: Grid, kinds: list[str], by: Sequence[By], wanted: Wanted, axis: bool
) -> Samples:
    """Return images and the derivatives that the engine supports in this window."""
    for rates in ([*by, By(engine.BY_AXIS)], by) if axis else (by,):
        if rates:
            result = engine_slopes(pupil, grid, rates, method.tol, wanted, lambda: method.images(pupil, grid, wanted))
            if result is not None:
                return result
    if kinds:
        raise ValueError(
            f"derivatives by {kinds[0]!r} are available for samples in windows up to {110.0 / grid.step(pupil):.0f} "
            "pixels from each axis, and for averages around the middle pixel; use a smaller shape, or a larger tol"
        )
    return method.images(pupil, grid, wanted)


def _samples(method: Method, pupil: BasePupil, grid: Grid, wanted: Wanted) -> Samples:
    """Return samples with bounds; the engine may use a larger tolerance, to avoid the slow reference method."""
    if isinstance(method, Stratified):
        result = engine_slopes(cast("ObjectivePupil", pupil), grid, (), method.tol, wanted, None)
        if result is not None:
            return result
    return method.images(pupil, grid, wanted)


def by_name(name: str, pupil: ObjectivePupil, *, far: bool) -> By:
    """Return the derivative of values / scale as a sum of derivatives of I at fixed power.

    With `far`, values are relative to the light that an emitter far from the glass sends to the objective.
    """
    if name == "z":
        return By(engine.BY_FOCUS)
    if far:
        return By(engine.BY_DEPTH)
    # Values are divided by the collected light, which also depends on depth.
    rates, _ = debye.power(pupil.layers, pupil.depth.ravel(), pupil.light.model, by_depth=True)
    return By(engine.BY_DEPTH, -(rates @ pupil.light.shares) / pupil.power)


def _stored(values: Array, error_bound: Array, images: Samples, wanted: Wanted) -> Slope:
    """Return the derivative of stored images from `values`, the derivative of I, with its `error_bound`."""
    scale = np.broadcast_to(np.asarray(images.scale, dtype=np.float64), error_bound.shape)
    # Derivatives have the scale of the images.
    stored = np.empty(values.shape, wanted.dtype)
    np.multiply(values, scale[:, None, None], out=stored, casting="same_kind")
    largest = np.maximum(values.max(axis=(1, 2)), -values.min(axis=(1, 2)))
    return Slope(stored, (error_bound + (storing(wanted.dtype) + 2.0**-48) * largest) / images.brightest)


def layered_gradient(
    method: Method,
    pupil: ObjectivePupil,
    grid: Grid,
    names: Sequence[Name],
    weights: Array,
    scale: Array,
    *,
    far: bool,
) -> dict[Name, Array]:
    """Return derivatives of ``sum(weights * values)`` by checked names, each (n,), with weights (n, height, width).

    Values are `scale`, (n,), times the intensity, relative to light emitted at the depth or `far` from the glass.
    Raises ValueError if a derivative is not available.
    """
    results: dict[Name, Array] = {}
    by_term = any(name not in SHIFTS for name in _terms_of(tuple(names)))
    if isinstance(method, LAYERED) and (by_term or not isinstance(method, Stratified)):
        results = _gradient_by_chords(method, pupil, grid, names, weights, scale, far=far)
    if others := [name for name in names if name not in results]:
        wanted = Wanted(scale if far else float(scale[0]))
        slopes = layered_slopes(method, pupil, grid, others, wanted)[2]
        results |= {
            name: np.einsum("nij,nij->n", weights, slope.values) for name, slope in zip(others, slopes, strict=True)
        }
    return results


def _gradient_by_chords(
    method: Method,
    pupil: ObjectivePupil,
    grid: Grid,
    names: Sequence[Name],
    weights: Array,
    scale: Array,
    *,
    far: bool,
) -> dict[Name, Array]:
    """Return derivatives by ChordalDebye.gradient(); {} if it declines, and all are by the axis."""
    terms = _terms_of(tuple(names))
    kinds: dict[Name, By] = {name: by_name(str(name), pupil, far=far) for name in names if name in _PARAMETERS}
    index = {term: k for k, term in enumerate(dict.fromkeys(terms.values()))}
    by = chordal_debye.By(tuple(d.variable for d in kinds.values()), tuple(index))
    if not (terms or kinds):
        return {}
    try:
        sums = ChordalDebye(method.tol).gradient(pupil, grid, weights, by).T
    except Declined:
        if kinds or isinstance(method, ChordalDebye) or any(name not in SHIFTS for name in terms):
            raise ValueError(_BY_CHORDS_ONLY) from None
        return {}
    largest_rates = debye.steepest(pupil.layers, pupil.light.model)
    results: dict[Name, Array] = {}
    for (name, d), sums_by in zip(kinds.items(), sums[1:], strict=False):
        results[name] = scale * (largest_rates[d.variable] * sums_by + d.image_factor * sums[0])
    by_term = scale * sums[1 + len(kinds) :]
    results |= {name: by_term[index[term]] for name, term in terms.items()}
    for name in SHIFTS.keys() & terms.keys():
        results[name] = grid.step(pupil) * results[name]
    return results


@lru_cache(maxsize=64)
def _terms_of(names: tuple[Name, ...]) -> Mapping[Name, Term]:
    """Return the Zernike terms by which the names differentiate: a shift is a tilt."""
    terms = {name: name if isinstance(name, tuple) else SHIFTS.get(name) or term_of(name) for name in names}
    return MappingProxyType({name: term for name, term in terms.items() if term})
