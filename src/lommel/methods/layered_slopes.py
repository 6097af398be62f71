r"""Derivatives of stacks through layers, each with a proven bound: by the stage, the emitter's depth and its place.

Fields are sums of ``exp(i psi)``, so that derivatives by what psi is linear in are sums over the same angles with a
factor ``i dpsi/dx``. Samples move with the axis by ``dI/dv``, averages by filters of finer samples
(:func:`lommel.methods.growth.tilted`). Light that an emitter near the glass loses changes with its depth.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from lommel.base.arrays import Array
from lommel.core import engine
from lommel.core.answers import Images, Wanted
from lommel.methods.growth import TILTS, tilted
from lommel.methods.method import Method, storing
from lommel.methods.slopes import Slope
from lommel.methods.stratified import Stratified, differentiated, known
from lommel.optics import debye
from lommel.optics.grid import Grid
from lommel.optics.objective_pupil import ObjectivePupil

if TYPE_CHECKING:
    from lommel.methods.derivatives import Name

_BY = {"depth": engine.BY_DEPTH, "z": engine.BY_FOCUS}
_AXIS = ("row", "column")


def layered_slopes(
    method: Method, pupil: ObjectivePupil, grid: Grid, names: Sequence[Name], wanted: Wanted
) -> tuple[Method, Images, list[Slope]]:
    """Return the method, images and their derivatives by checked names.

    Parameters
    ----------
    method : Method
    pupil, grid
    names : sequence
    wanted : Wanted
        With a scale.

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
    if not known(pupil.light):
        raise ValueError(f"derivatives are not available of the light of {pupil.emitter!r}")
    if not isinstance(method, Stratified):
        raise ValueError(
            f"derivatives are not available from {type(method).__name__} of an Objective; use Stratified"
        )
    if unknown := [name for name in names if name not in (*_BY, *_AXIS)]:
        raise ValueError(
            f"derivatives of the pupils of an Objective are by 'z', 'depth', 'row' and 'column', got {unknown[0]!r}"
        )
    by = [_BY[name] for name in dict.fromkeys(names) if isinstance(name, str) and name in _BY]
    axis = any(name in _AXIS for name in names)
    sampled = axis and not grid.integrate and pupil.radial
    engines = [*by, *([engine.BY_AXIS] if sampled else [])]
    found = differentiated(pupil, grid, engines, method.tol, wanted) if engines else None
    if found is None and by:
        raise ValueError(
            "derivatives by 'z' and 'depth' are of light that is radially symmetric, in windows up to "
            f"{110.0 / grid.step(pupil):.0f} pixels from each axis, or averages in any around their middle pixel"
        )
    made = method.images(pupil, grid, wanted) if found is None else found[0]
    each: dict[Name, tuple[Array, Array]] = {}
    if found is not None:
        kinds = [name for name in dict.fromkeys(names) if name in _BY] + list(_AXIS if sampled else ())
        each = {name: (found[1][k], found[2][k]) for k, name in enumerate(kinds)}
    if axis and "row" not in each:
        step = grid.step(pupil)
        for name, term in zip(("column", "row"), tilted(method, pupil, grid, wanted.threads), strict=True):
            assert len(TILTS) == 2  # in this sequence
            each[name] = step * term[0], step * term[1]
    return method, made, [_stored(name, *each[name], pupil, made, wanted) for name in names]


def _stored(name: Name, values: Array, wrong: Array, pupil: ObjectivePupil, made: Images, wanted: Wanted) -> Slope:
    """Return a derivative of images from that of I at a fixed power, as they are stored."""
    assert made.peak is not None
    scale = np.broadcast_to(np.asarray(made.scale, dtype=np.float64), wrong.shape)
    error = wrong / made.peak
    # What is over the light far from the glass does not change with the light that is collected.
    if name == "depth" and not isinstance(wanted.scale, np.ndarray):
        slope, _ = debye.power(pupil.layers, pupil.depth.ravel(), pupil.light.model, slope=True)
        rate = slope @ pupil.light.shares / pupil.power
        values = values - made.values * (rate / scale)[:, None, None]
        assert made.error is not None
        error = error + np.abs(rate) * (made.error + 1e-12)
    kept = np.empty(values.shape, wanted.dtype)
    np.multiply(values, scale[:, None, None], out=kept, casting="same_kind")
    largest = np.maximum(values.max(axis=(1, 2)), -values.min(axis=(1, 2)))
    return Slope(kept, error + (storing(wanted.dtype) + 2.0**-48) * largest / made.peak)
