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
from lommel.methods.growth import tilted
from lommel.methods.method import Method, storing
from lommel.methods.slopes import Slope
from lommel.methods.stratified import By, Stratified, differentiated
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
        If the method is another than Stratified, or there are no such derivatives.
    ToleranceError
        If the tolerance cannot be met.
    """
    if not isinstance(method, Stratified):
        raise ValueError(
            f"derivatives are not available from {type(method).__name__} of an Objective; use Stratified"
        )
    if unknown := [name for name in names if name not in (*_OWN, *_AXIS)]:
        raise ValueError(
            "derivatives of the pupils of an Objective are by 'z', 'depth', 'wavelength', 'row' and 'column', "
            f"got {unknown[0]!r}"
        )
    kinds = [str(name) for name in dict.fromkeys(names) if name in _OWN]
    axis = any(name in _AXIS for name in names)
    found, each = None, dict[Any, Slope]()
    if "wavelength" in kinds and not pupil.radial:
        raise ValueError(
            f"derivatives by 'wavelength' are of light that is radially symmetric, got {pupil.emitter!r}; take "
            "differences of PSFs with a small tol"
        )
    by = [_by(name, pupil, wanted, energy=energy) for name in kinds]
    moved = [By(engine.BY_AXIS)] if axis and pupil.radial else []
    for asked in ([*by, *moved], by) if moved else (by,):
        if asked and (found := differentiated(pupil, grid, asked, method.tol, wanted)) is not None:
            assert found[0].peak is not None
            slopes = map(Slope, found[1], found[2] / found[0].peak)
            each = dict(zip([*kinds, *(_AXIS if len(asked) > len(by) else ())], slopes, strict=True))
            break
    if found is None and by:
        raise ValueError(
            f"derivatives by {kinds[0]!r} are of light that is radially symmetric, in windows up to "
            f"{110.0 / grid.step(pupil):.0f} pixels from each axis, or averages in any around their middle pixel"
        )
    made = method.images(pupil, grid, wanted) if found is None else found[0]
    if axis and "row" not in each:
        for name, (values, off) in zip(("column", "row"), tilted(method, pupil, grid, wanted.threads), strict=True):
            each[name] = _stored(grid.step(pupil) * values, grid.step(pupil) * off, made, wanted)
    return method, made, [each[name] for name in names]


def _by(name: str, pupil: ObjectivePupil, wanted: Wanted, *, energy: bool) -> By:
    """Return a derivative of the values, over their scale, from those of I at fixed power and a fixed pixel in v."""
    if name == "z":
        return By(engine.BY_FOCUS)
    # What is over the light far from the glass does not change with the light that is collected near it.
    far = isinstance(wanted.scale, np.ndarray)
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
