r"""Derivatives of microscope stacks by stage, depth, wavelength and position, with error bounds.

Fields are sums of ``exp(i psi)``, so that derivatives by a parameter in which psi is linear are sums over the same
angles with a factor ``i dpsi/dx``. Phases are proportional to the wavenumber, and so is v at a position in metres.
When the axis moves, samples change by ``dI/dv``, and averages by the difference of line averages along two sides of
each pixel. The light lost by an emitter near the cover glass depends on its depth and on the wavelength.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple, cast

import numpy as np

from lommel.base.arrays import Array
from lommel.core import engine
from lommel.core.answers import Images, Pixels, Slopes, Wanted
from lommel.methods.derivatives import Slope, scaling_derivative, tilted
from lommel.methods.layers.debye_rings import DebyeRings, Turn, ringed
from lommel.methods.layers.stratified import By, Stratified, differentiated, known
from lommel.methods.method import Method, storing, widened
from lommel.methods.pixels.averaging import Sample, averaged_images
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid
from lommel.optics.layers import debye
from lommel.optics.layers.objective_pupil import ObjectivePupil

if TYPE_CHECKING:
    from lommel.methods.derivative_names import Name


# Fixed dipoles and beams have the engine of :mod:`lommel.methods.layers.stratified`. With a measured wavefront fields
# E are sums over circles (:mod:`lommel.methods.layers.debye_rings`); with waves times ``(1 +- i s dpsi/dx) / 2``
# these are ``(E +- s G) / 2``, G being the derivative of E, and the difference of their intensities is ``s Re(E conj
# G)``, half
# of s times the derivative of ``abs(E)^2``: no difference quotient, whatever s is.

Rates = Callable[[ObjectivePupil], Sequence[By]]
"""From planes to the derivatives that are wanted of these."""


class Sampled(NamedTuple):
    """Images, with derivatives as these are stored."""

    images: Images
    values: Pixels
    error: Array


def sampled_slopes(method: Method, pupil: ObjectivePupil, grid: Grid, rates: Rates, wanted: Wanted) -> Sampled:
    """Return images by DebyeRings or Stratified and their derivatives."""
    by = rates(pupil)
    most = debye.steepest(pupil.layers, pupil.light.model, pupil.depth.ravel(), pupil.focus.ravel())
    # What derivatives are divided by, so that their transfer functions are at most twice that of the aperture.
    sizes = [abs(one.factor) * most[min(one.which, 2)] + 0.5 * float(np.abs(one.own).max(initial=0.0)) for one in by]
    sample = _by_circles(method, rates, sizes, most) if isinstance(method, DebyeRings) else _by_engine(rates, sizes)
    question = wanted._replace(terms=((0, 0),) * len(by))  # as many
    make = averaged_images if grid.integrate else _at_centres
    made = widened(make(sample, pupil, grid, method.tol, question), pupil, method, normalized=False)
    assert made.slopes is not None
    count = np.array(sizes)
    for values, size in zip(made.slopes.values, sizes, strict=True):
        values *= size
    return Sampled(made._replace(slopes=None), made.slopes.values, count[:, None] * made.slopes.error)


def engine_slopes(
    pupil: ObjectivePupil,
    grid: Grid,
    by: Sequence[By],
    tol: float,
    wanted: Wanted,
    otherwise: Callable[[], Images] | None,
) -> Sampled | None:
    """Return images and derivatives by the engine, or None where it has no such windows.

    Derivatives have bounds and no tolerance: where rounding keeps the engine from that of the images, they come with
    a looser one, and images are those that `otherwise` returns, or of a looser one too.
    """
    for looser in (1.0, 10.0, 100.0, 1000.0):
        if (found := differentiated(pupil, grid, by, looser * tol, wanted)) is not None:
            images, values, wrong = found
            error = wrong / images.brightest
            return Sampled(images if looser == 1.0 or otherwise is None else otherwise(), values, error)
    return None


def _at_centres(
    sample: Sample[ObjectivePupil], pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted
) -> Images:
    return sample(pupil, grid, tol, wanted)


def _by_engine(rates: Rates, sizes: Sequence[float]) -> Sample[ObjectivePupil]:
    """Return samples by Stratified, with derivatives over `sizes`."""

    def sample(pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
        by = [
            one._replace(factor=one.factor / size, own=np.asarray(one.own) / size)
            for one, size in zip(rates(pupil), sizes, strict=True)
        ]
        question, way = wanted._replace(terms=()), Stratified(max(tol, Stratified.least_tol))
        found = engine_slopes(pupil, grid, by, way.tol, question, lambda: way._samples(pupil, grid, tol, question))
        if found is None:
            raise ValueError(
                "derivatives of light that depends on the azimuth are in windows up to "
                f"{110.0 / grid.step(pupil):.0f} pixels from each axis; ask for a smaller shape, or a larger tol"
            )
        return found.images._replace(slopes=Slopes(found.values, found.error))

    return sample


def _by_circles(
    method: DebyeRings, rates: Rates, sizes: Sequence[float], most: tuple[float, float, float]
) -> Sample[ObjectivePupil]:
    """Return samples by DebyeRings, with derivatives over `sizes`; `most` is what factors are at most."""

    def sample(pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
        made, accuracy = method.refined(pupil, grid, tol, wanted._replace(terms=()))
        plain = Wanted(threads=wanted.threads)
        values = np.empty((len(sizes), *made.values.shape), wanted.dtype)
        error = np.empty((len(sizes), len(made.values)))
        for k, (one, size) in enumerate(zip(rates(pupil), sizes, strict=True)):
            steep, middle = most[one.which], pupil.layers.middle_rates()[1 + one.which]
            up, down = (
                ringed(pupil, grid, accuracy, plain, Turn(one.which + 1, sign * 1j / steep, middle))
                for sign in (1.0, -1.0)
            )
            share = 2.0 * one.factor * steep / size
            own = np.broadcast_to(np.asarray(one.own) / size, made.scale.shape)
            slope = share * (up.values - down.values) * made.scale[:, None, None] + own[:, None, None] * made.values
            off = _absolute(up) + _absolute(down)
            largest = np.abs(slope).reshape(len(slope), -1).max(axis=1) / made.scale
            wrong = abs(share) * off + (storing(wanted.dtype) + 2.0**-48) * largest
            values[k], error[k] = slope, wrong / made.brightest + np.abs(own) * (made.bound + 1e-12)
        return made._replace(slopes=Slopes(values, error))

    return sample


def _absolute(made: Images) -> Array:
    """Return the bound on the error of I."""
    return made.bound * made.brightest


_AXIS = ("row", "column")
_OWN = ("z", "depth", "wavelength")


def layered_slopes(
    method: Method, pupil: ObjectivePupil, grid: Grid, names: Sequence[Name], wanted: Wanted, *, energy: bool
) -> tuple[Method, Images, list[Slope]]:
    """Return the method, images and their derivatives by checked names."""
    if not known(pupil.light):
        raise ValueError(f"derivatives are not available of the light of {pupil.emitter!r}")
    if not isinstance(method, Stratified | DebyeRings):
        raise ValueError(
            f"derivatives are not available from {type(method).__name__} of an Objective; use Stratified, or "
            "DebyeRings with aberrations"
        )
    if unknown := [name for name in names if name not in (*_OWN, *_AXIS)]:
        raise ValueError(
            "derivatives of the pupils of an Objective are by 'z', 'depth', 'wavelength', 'row' and 'column', "
            f"got {unknown[0]!r}"
        )
    if "wavelength" in names and pupil.aberrated:
        raise ValueError(
            "derivatives by 'wavelength' are not available of an Objective with aberrations; take differences of the "
            "PSFs of pupil.in_light(w)"
        )
    kinds = [str(name) for name in dict.fromkeys(names) if name in _OWN]
    axis = any(name in _AXIS for name in names)

    def rates(planes: ObjectivePupil) -> list[By]:
        return [_by(name, planes, far=isinstance(wanted.scale, np.ndarray), energy=energy) for name in kinds]

    if pupil.radial:
        made, each = _radial(method, pupil, grid, kinds, rates, wanted, axis=axis)
    else:
        made, each = _any(method, pupil, grid, kinds, rates, wanted)
    grows = "wavelength" in kinds and not pupil.radial
    if (axis and "row" not in each) or grows:
        # What is left out of the phase moves fields and their gradients by as much.
        left = 4.0 * pupil.left_out[0]
        tilts = [(values, off + left) for values, off in tilted(method, pupil, grid, wanted.threads, _samples)]
        for name, (values, off) in zip(("column", "row"), tilts, strict=True):
            each[name] = _stored(grid.step(pupil) * values, grid.step(pupil) * off, made, wanted)
        if grows:
            values, off = scaling_derivative(method, pupil, grid, tilts, wanted.threads, _samples)
            of_place = _stored(values / -pupil.wavelength, off / pupil.wavelength, made, wanted)
            each["wavelength"] = _sum(each["wavelength"], of_place, made, wanted)
    return method, made, [each[name] for name in names]


def _radial(
    method: Method,
    pupil: ObjectivePupil,
    grid: Grid,
    kinds: Sequence[str],
    rates: Rates,
    wanted: Wanted,
    *,
    axis: bool,
) -> tuple[Images, dict[Name, Slope]]:
    """Return images and the derivatives that the engine has in such windows."""
    by = rates(pupil)
    moved = [By(engine.BY_AXIS)] if axis else []
    for asked in ([*by, *moved], by) if moved else (by,):
        if not asked:
            continue
        found = engine_slopes(pupil, grid, asked, method.tol, wanted, lambda: method.images(pupil, grid, wanted))
        if found is not None:
            names = [*kinds, *(_AXIS if len(asked) > len(by) else ())]
            return found.images, dict(zip(names, map(Slope, found.values, found.error), strict=True))
    if by:
        raise ValueError(
            f"derivatives by {kinds[0]!r} are of samples in windows up to {110.0 / grid.step(pupil):.0f} pixels from "
            "each axis, or of averages in any around their middle pixel; ask for a smaller shape, or a larger tol"
        )
    return method.images(pupil, grid, wanted), {}


def _any(
    method: Method, pupil: ObjectivePupil, grid: Grid, kinds: Sequence[str], rates: Rates, wanted: Wanted
) -> tuple[Images, dict[Name, Slope]]:
    """Return images of light that depends on the azimuth, and what derivatives these have at a fixed v."""
    if not kinds:
        return widened(method.images(pupil, grid, wanted), pupil, method, normalized=False), {}
    found = sampled_slopes(method, pupil, grid, rates, wanted)
    return found.images, dict(zip(kinds, map(Slope, found.values, found.error), strict=True))


def _samples(method: Method, pupil: BasePupil, grid: Grid, wanted: Wanted) -> Images:
    """Return samples with bounds, which need not be the tolerance that only the reference reaches."""
    if isinstance(method, Stratified):
        found = engine_slopes(cast("ObjectivePupil", pupil), grid, (), method.tol, wanted, None)
        if found is not None:
            return found.images
    return method.images(pupil, grid, wanted)


def _by(name: str, pupil: ObjectivePupil, *, far: bool, energy: bool) -> By:
    """Return a derivative of the values, over their scale, from those of I at fixed power and a fixed pixel in v.

    What is over the light `far` from the glass does not change with the light that is collected near it.
    """
    if name == "z":
        return By(engine.BY_FOCUS)
    of_near, of_far = _power_rates(pupil, "depth" if name == "depth" else "wavenumber")
    rate = of_far if far else of_near
    if name == "depth":
        return By(engine.BY_DEPTH, 1.0, -rate)
    # By ln k. The pixel is a larger part of the plane as v grows.
    return By(
        engine.BY_WAVENUMBER, -1.0 / pupil.wavelength, ((-2.0 if energy or far else 0.0) + rate) / pupil.wavelength
    )


def _power_rates(pupil: ObjectivePupil, by: str) -> tuple[Array, Array]:
    """Return the derivatives of the light that is collected over itself, of each plane, and far from the glass."""
    model, shares = pupil.light.model, pupil.light.shares
    near, far = debye.power(pupil.layers, pupil.depth.ravel(), model, by=by)
    _, whole = debye.power(pupil.layers, np.zeros(0), model)
    return near @ shares / pupil.power, np.full(pupil.power.shape, far @ shares / (whole @ shares))


def _stored(values: Array, wrong: Array, made: Images, wanted: Wanted) -> Slope:
    """Return a derivative of images from that of I, as they are stored."""
    scale = np.broadcast_to(np.asarray(made.scale, dtype=np.float64), wrong.shape)
    kept = np.empty(values.shape, wanted.dtype)
    np.multiply(values, scale[:, None, None], out=kept, casting="same_kind")
    largest = np.maximum(values.max(axis=(1, 2)), -values.min(axis=(1, 2)))
    return Slope(kept, (wrong + (storing(wanted.dtype) + 2.0**-48) * largest) / made.brightest)


def _sum(one: Slope, other: Slope, made: Images, wanted: Wanted) -> Slope:
    """Return the sum of two derivatives, as it is stored."""
    values = one.values.astype(np.float64) + other.values
    largest = np.abs(values).reshape(len(values), -1).max(axis=1) / made.scale / made.brightest
    return Slope(values.astype(wanted.dtype), one.error + other.error + storing(wanted.dtype) * largest)
