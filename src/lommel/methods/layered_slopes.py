r"""Derivatives of stacks through layers, each with a bound: by stage, depth, wavelength and place of the axis.

Fields are sums of ``exp(i psi)``, so that derivatives by what psi is linear in are sums over the same angles with a
factor ``i dpsi/dx``. Phases are proportional to the wavenumber, and so is v at a place in metres. Samples move with
the axis by ``dI/dv``, averages by the difference of those along two sides of each pixel. Light that an emitter near
the glass loses changes with its depth and with the wavelength.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.base.arrays import Array
from lommel.core import engine
from lommel.core.answers import Images, Wanted
from lommel.methods.debye_rings import DebyeRings
from lommel.methods.growth import growth, tilted
from lommel.methods.layered_samples import Rates, engine_slopes, sampled_slopes
from lommel.methods.method import Method, storing, widened
from lommel.methods.slopes import Slope
from lommel.methods.stratified import By, Stratified, known
from lommel.optics import debye
from lommel.optics.grid import Grid
from lommel.optics.objective_pupil import ObjectivePupil

if TYPE_CHECKING:
    from lommel.methods.derivatives import Name

_AXIS = ("row", "column")
_OWN = ("z", "depth", "wavelength")


def layered_slopes(
    method: Method, pupil: ObjectivePupil, grid: Grid, names: Sequence[Name], wanted: Wanted, *, energy: bool
) -> tuple[Method, Images, list[Slope]]:
    """Return the method, images and their derivatives by checked names.

    Parameters
    ----------
    method : Method
    pupil, grid
    names : sequence
    wanted : Wanted
        With a scale.
    energy : bool
        Whether that is of fractions of all light.

    Returns
    -------
    method : Method
    images : Images
    slopes : list of Slope
        One for each name.

    Raises
    ------
    ValueError
        If the method has no such derivatives.
    ToleranceError
        If the tolerance cannot be met.
    """
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
            values, off = growth(method, pupil, grid, tilts, wanted.threads, _samples)
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
) -> tuple[Images, dict[Any, Slope]]:
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
) -> tuple[Images, dict[Any, Slope]]:
    """Return images of light that depends on the azimuth, and what derivatives these have at a fixed v."""
    if not kinds:
        return widened(method.images(pupil, grid, wanted), pupil, method, normalized=False), {}
    found = sampled_slopes(method, pupil, grid, rates, wanted)
    return found.images, dict(zip(kinds, map(Slope, found.values, found.error), strict=True))


def _samples(method: Method, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Images:
    """Return samples with bounds, which need not be the tolerance that only the reference reaches."""
    if isinstance(method, Stratified):
        found = engine_slopes(pupil, grid, (), method.tol, wanted, None)
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
    assert made.peak is not None
    scale = np.broadcast_to(np.asarray(made.scale, dtype=np.float64), wrong.shape)
    kept = np.empty(values.shape, wanted.dtype)
    np.multiply(values, scale[:, None, None], out=kept, casting="same_kind")
    largest = np.maximum(values.max(axis=(1, 2)), -values.min(axis=(1, 2)))
    return Slope(kept, (wrong + (storing(wanted.dtype) + 2.0**-48) * largest) / made.peak)


def _sum(one: Slope, other: Slope, made: Images, wanted: Wanted) -> Slope:
    """Return the sum of two derivatives, as it is stored."""
    assert made.peak is not None
    values = one.values.astype(np.float64) + other.values
    largest = np.abs(values).reshape(len(values), -1).max(axis=1) / made.scale / made.peak
    return Slope(values.astype(wanted.dtype), one.error + other.error + storing(wanted.dtype) * largest)
