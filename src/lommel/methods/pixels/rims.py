r"""Far pixels from the rim of the pupil: averages of stacks whose light is in a small box around the axis.

By Gauss's theorem on the disk the field of a pupil function P is, with :math:`\bar\partial = \partial_x +
i \partial_y`, exactly

.. math:: U = -\sum_{k<K} \frac{b_k}{(i v e^{i \psi})^{k+1}} + \frac{U_K}{(i v e^{i \psi})^K},

b_k integrals of :math:`\bar\partial^k P` along the rim and U_K the field of :math:`\bar\partial^K P`. So a pixel
farther from the axis than rays reach needs the rim alone; the core averages its light by tables that pupils share.
The pixels of the box around the axis have nodes, see :mod:`lommel.methods.pixels.window_nodes`.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Wanted
from lommel.core.engine import Window, rim_averages, rim_boxes
from lommel.methods.pixels.averaging import (
    Averages,
    Disks,
    averaged_at_nodes,
    before_storing,
    least_average,
    once_stored,
)
from lommel.optics.base_pupil import BasePupil

_TRIES = 3  # boxes of a pupil
_POWER = 4.0  # of the side of a box, with which errors fall at the least
_WORTH = 0.9  # of the tolerance, what larger boxes aim at
_FARTHEST = 16.0  # times the tolerance, from where on larger boxes are no surer


def averaged_disks(disks: Disks, pupil: BasePupil, tol: float, wanted: Wanted) -> Averages | None:
    """Return the intensity averaged over each pixel, of far ones from rims where that takes less time.

    None where the window has no nodes. Rims have no derivatives.
    """
    if wanted.powers or not pupil.within_disc:
        return None
    made = None if wanted.terms else averaged_from_rims(disks, pupil, tol, wanted)
    return averaged_at_nodes(disks, pupil, tol, wanted) if made is None else made


def averaged_from_rims(disks: Disks, pupil: BasePupil, tol: float, wanted: Wanted) -> Averages | None:
    """Return the intensity averaged over each pixel, of far ones from rims, with bounds below `tol`.

    None where that is not likely to take less time, or fails.
    """
    stack, window, normalize = disks.stack, disks.window, wanted.scale is None
    count, step = len(stack.edge), window.step
    room = before_storing(tol, wanted)
    chosen = None if room <= 0.0 else rim_boxes(stack, window, room, least_average(step), wanted.threads)
    if chosen is None:
        return None
    sides, most, axes, remainders, tolerances = chosen
    given = window.center[0] if len(window.center) == 1 else np.array([window.center])
    values, error, peak = np.empty((count, *window.shape)), np.full(count, np.inf), np.empty(count)
    for _ in range(_TRIES):
        for box in sorted({*sides.tolist()} - {0}):
            which = np.flatnonzero(sides == box)
            some = _of_part(disks, which)
            centers = given[which if len(given) > 1 else 0] - axes[which] + box // 2
            center = tuple(centers[0].tolist()) if (centers == centers[0]).all() else (centers,)
            near = averaged_at_nodes(some._replace(window=Window((box, box), center, step)), pupil, tol, wanted)
            if near is None:
                continue
            # Rounded, so that stacks with about the same peaks share tables.
            least = 2.0 ** (0.5 * math.floor(2.0 * math.log2(float(tolerances[which].min()))))
            off, top = rim_averages(
                some.stack, some.window, remainders[which], near.values[0], least, wanted.threads, which, values
            )
            peak[which] = np.maximum(near.peak, top) if normalize else near.peak
            error[which] = np.maximum(near.error[0], once_stored(off / near.peak, wanted))
        failed = ~(error <= tol)
        if not failed.any():
            break
        sides = np.where(failed, _larger(sides, error / tol, most), 0)
    rest = np.flatnonzero(failed)
    if rest.size:
        some = _of_part(disks, rest)
        made = averaged_at_nodes(some._replace(sole=rest.size == count), pupil, tol, wanted)
        if made is None:
            return None
        values[rest], error[rest], peak[rest] = made.values[0], made.error[0], made.peak
    return Averages(values[None], error[None], peak)


def _larger(sides: NDArray[np.int64], times: Array, most: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return the next boxes of pupils whose averages are off by so many times the tolerance, 0 where none is."""
    grown = sides * (np.fmin(times, _FARTHEST) / _WORTH) ** (1.0 / _POWER)
    larger = sides + 2 * np.maximum(1, np.ceil(0.5 * (grown - sides))).astype(np.int64)
    return np.where((sides > 0) & (larger <= most), larger, 0)


def _of_part(disks: Disks, which: NDArray[np.intp]) -> Disks:
    """Return some of the pupils, with their axes."""
    stack, window = disks.stack, disks.window
    if which.size == len(stack.edge):
        return disks
    if len(window.center) == 1:
        window = window._replace(center=(window.center[0][which],))
    return disks._replace(stack=stack._replace(edge=stack.edge[which]), window=window)
