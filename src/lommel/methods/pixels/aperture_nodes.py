"""Averages over pixels of apertures of any shape: nodes of the window, and a rule with the moments of the aperture.

The nodes of the rule are those of the chordal rule of the disk, its weights complex numbers of either sign, see
:mod:`lommel.methods.moment_rule`: pupils stand side by side in vector lanes, as those of round apertures do.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Images, Pixels, Slopes, Wanted
from lommel.core.engine import DiskStack, Window, aperture_averages
from lommel.methods.moment_rule import MomentRule, degrees_and_error, moment_rule, nodes, roundings
from lommel.methods.nijboer_zernike import disk_stack, window_of
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil

_FEWEST = 4  # pupils and their derivatives, in whose lanes work is shared
_STEPS = 8  # stacks, or steps of a fit, that take the same rule
_MAKING, _SUMS, _SAMPLE = 2.4e-5, 5.5e-8, 1.15e-4  # ms by cubes of rows, by products, and of a sample of a filter
_LARGEST = 400  # degree
_SINGLE = 0.5  # of an error, what sums in single precision may lose
_LEAST = 1e-12  # error of the field, below which roundings are in the way


def averaged_apertures(pupil: Pupil, grid: Grid, tol: float, wanted: Wanted) -> Images | None:
    """Return the intensity averaged over each pixel with bounds below `tol`; None where that does not serve."""
    highest = max((n for n, _ in wanted.terms), default=0)
    fields = math.prod(pupil.shape) * (1 + len(wanted.terms))
    if pupil.mask is not None or wanted.powers or fields < _FEWEST:
        return None
    stack, window = disk_stack(pupil), window_of(pupil, grid)

    def rule(reach: float, tol: float, single: bool, rows: int, columns: int) -> tuple[Array, float, bool] | None:
        aim = 0.15 * tol
        if aim < _LEAST:
            return None
        degree, fine, missed = degrees_and_error(pupil, reach, aim)
        sums = _SUMS * columns * (degree + highest + 20.0) * (degree + highest + 20.0 + rows)
        if degree + highest > _LARGEST or not _pays(fields, degree + highest + 20.0, sums, window):
            return None
        made = moment_rule(pupil.opening, degree + highest, fine + highest, aim)
        lost = roundings(made, pupil, reach, single=True)
        single = single and lost < _SINGLE * tol
        off = missed + 1.1 * aim + (lost if single else roundings(made, pupil, reach))
        return of_quadrant(made, pupil), off, single

    # Chords of the rule are rows of the aperture, and those of the core are columns.
    by, signs = exchanged(wanted.terms)
    images = aperture_averages(
        turned(stack),
        window._replace(shape=window.shape[::-1], center=window.center[::-1]),
        pupil.likely_strehl,
        pupil.transmission,
        tol,
        wanted._replace(out=None, terms=tuple((int(n), int(m)) for n, m in by)),
        rule,
    )
    return None if images is None else _turned_back(images, signs, wanted.out)


def _turned_back(images: Images, signs: Array, out: Pixels | None) -> Images:
    """Return images with x and y exchanged, and derivatives with signs."""
    values = np.empty_like(images.values.swapaxes(1, 2), order="C") if out is None else out
    values[...] = images.values.swapaxes(1, 2)
    slopes = images.slopes
    if slopes is not None:
        turned_slopes = slopes.values.swapaxes(2, 3) * signs[:, None, None, None].astype(slopes.values.dtype)
        slopes = Slopes(np.ascontiguousarray(turned_slopes), slopes.error)
    return images._replace(values=values, slopes=slopes)


def _pays(count: int, rows: float, sums: float, window: Window) -> bool:
    """Return whether sums over nodes are likely to take less time than a filter of samples, the rule made once."""
    samples = _SAMPLE * math.prod(window.step / 1.2 * n + 20.0 for n in window.shape)
    return _MAKING * rows**3 < _STEPS * count * (samples - sums)


def exchanged(terms: Sequence[tuple[int, int]] | NDArray[np.int32]) -> tuple[NDArray[np.int32], Array]:
    """Return terms with x and y exchanged, cosines of odd orders being sines then, and their signs."""
    n, m = np.reshape(np.asarray(terms, dtype=np.int32), (-1, 2)).T
    odd, order = m % 2 != 0, np.abs(m)
    # cos(m (pi / 2 - theta)), and sin of that.
    half = np.where(order // 2 % 2 == 0, 1.0, -1.0)
    other = np.stack([n, np.where(odd, -m, m)], axis=1)
    return np.ascontiguousarray(other, dtype=np.int32), np.where(odd, half, np.where(m < 0, -half, half))


def turned(stack: DiskStack) -> DiskStack:
    """Return the same with x and y exchanged."""
    terms, signs = exchanged(stack.terms)
    return stack._replace(terms=terms, edge=stack.edge * signs)


def of_quadrant(rule: MomentRule, pupil: Pupil) -> Array:
    """Return the weights of a rule, with the amplitude of a pupil, as the core takes them, (chords, nodes, 8)."""
    weight, half = rule.weight, rule.rows // 2
    if not pupil.illumination.uniform:
        at = nodes(rule.rows)
        weight = weight * pupil.illumination.at(at.x**2 + at.y[:, None] ** 2)
    # Rows fall from the top, nodes along them rise.
    top, bottom = weight[:half], weight[: half - 1 : -1]
    parts = [part for rows in (top, bottom) for part in (rows[:, : half - 1 : -1], rows[:, :half])]
    return np.stack([part for each in parts for part in (each.real, each.imag)], axis=2)
