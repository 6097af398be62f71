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
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Wanted
from lommel.core.engine import RIM_ORDERS, DiskStack, Window, rim_averages, rim_remainders
from lommel.methods.pixels.averaging import (
    Averages,
    Disks,
    averaged_at_nodes,
    before_storing,
    least_average,
    once_stored,
)
from lommel.optics.base_pupil import BasePupil
from lommel.special.zernike import rms_factor

_Size = TypeVar("_Size", float, Array)

_PROBED = 16  # pupils that stand for a stack
_REACH = 48.0  # pixels from corner to corner, per root of the pupils that share the tables of a window
# Pairs of nodes that take as long: rims of one edge and of two; and each call.
_RIMS, _CALL = (2500.0, 5500.0), 9000.0
_TOGETHER = 8  # pupils of one box at the least, where others have a larger one
_WIDEST = 0.7  # of a window, what a box may take
_NARROWEST = 18.0  # v around the axis
_FIELD = 0.4  # of the tolerance, what may be left of the field
_TRIES = 3  # boxes of a pupil
_WORTH = 0.85  # of the time that nodes of the whole window take, for some pupils fail


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
    if room <= 0.0:
        return None
    asked = room * _likely_largest(stack, step)
    chosen = _chosen(disks, asked, wanted.threads)
    if chosen is None:
        return None
    boxes, remainders, axes = chosen
    given = window.center[0] if len(window.center) == 1 else np.broadcast_to(window.center, (count, 2))
    values, error, peak = np.empty((count, *window.shape)), np.full(count, np.inf), np.empty(count)
    for _ in range(_TRIES):
        for box in sorted({*boxes.tolist()} - {0}):
            which = np.flatnonzero(boxes == box)
            some = _of_part(disks, which)
            centers = given[which] - axes[which] + box // 2
            center = tuple(centers[0].tolist()) if (centers == centers[0]).all() else (centers,)
            near = averaged_at_nodes(some._replace(window=Window((box, box), center, step)), pupil, tol, wanted)
            if near is None:
                continue
            # Rounded, so that stacks with about the same peaks share tables.
            least = 2.0 ** (0.5 * math.floor(2.0 * math.log2(float(asked[which].min()))))
            off, top = rim_averages(
                some.stack, some.window, remainders[which], near.values[0], least, wanted.threads, which, values
            )
            peak[which] = np.maximum(near.peak, top) if normalize else near.peak
            error[which] = np.maximum(near.error[0], once_stored(off / near.peak, wanted))
        # Where light is fainter than it was likely to be, the next larger boxes.
        larger = boxes + 2
        fits = (larger < _WIDEST * min(window.shape)) & (larger // 2 <= _beside(axes, window))
        boxes = np.where((error > tol) & (boxes > 0) & fits, larger, 0)
    rest = np.flatnonzero(~(error <= tol))
    if rest.size:
        made = averaged_at_nodes(_of_part(disks, rest), pupil, tol, wanted)
        if made is None:
            return None
        values[rest], error[rest], peak[rest] = made.values[0], made.error[0], made.peak
    return Averages(values[None], error[None], peak)


def _chosen(disks: Disks, asked: Array, threads: int) -> tuple[NDArray[np.intp], Array, Array] | None:
    """Return a box for each pupil, 0 for none, with what rims leave and the pixels of axes; None where few pay."""
    stack, window = disks.stack, disks.window
    count, step, (height, width) = len(stack.edge), window.step, window.shape
    rims, whole = _RIMS[stack.obscuration > 0.0] + _CALL / count, _nodes(step, height) * _nodes(step, width)
    least = max(5, 2 * math.ceil(_NARROWEST / step) + 1)
    sizes = np.arange(least, math.ceil(_WIDEST * min(height, width)), 2)
    wide = math.hypot(height, width) > _REACH * math.sqrt(count)
    if wide or not sizes.size or _nodes(step, least) ** 2 + rims > whole:
        return None
    # Of many, some stand for all at first.
    for every in (-(-count // _PROBED), 1) if count > _PROBED else (1,):
        some = _of_part(disks, np.arange(0, count, every))
        remainders, axes = rim_remainders(some.stack, some.window, threads)
        boxes = _smallest(sizes, remainders, asked[::every], step)
        # Tables grow with the way to the farthest pixel; and boxes are within the window, as its peak is.
        reach = np.maximum(axes, np.array([height - 1, width - 1]) - axes).max(axis=1)
        far = math.sqrt(2.0) * (2.0 * reach + 1.0) > _REACH * math.sqrt(count)
        boxes[far | (_beside(axes, window) < boxes // 2)] = 0
        if np.where(boxes > 0, _nodes(step, boxes.astype(np.float64)) ** 2 + rims, whole).mean() > _WORTH * whole:
            return None
    return boxes, remainders, axes


def _beside(axes: Array, window: Window) -> Array:
    """Return how many pixels there are at the least between each axis and the edges of the window."""
    return np.asarray(np.minimum(axes, np.array(window.shape) - 1.0 - axes).min(axis=1))


def _nodes(step: float, pixels: _Size) -> _Size:
    """Return about how many nodes so many pixels have along an axis."""
    return 2.0 * step / math.pi * pixels + 9.0


def _of_part(disks: Disks, which: NDArray[np.intp]) -> Disks:
    """Return some of the pupils, with their axes."""
    stack, window = disks.stack, disks.window
    if which.size == len(stack.edge):
        return disks
    if len(window.center) == 1:
        window = window._replace(center=(window.center[0][which],))
    return disks._replace(stack=stack._replace(edge=stack.edge[which]), window=window)


def _likely_largest(stack: DiskStack, step: float) -> Array:
    """Return about the largest average of each pupil."""
    edge = np.clip(stack.edge, -1e6, 1e6)
    # But for piston and tilt.
    variance = (edge * edge) @ [rms_factor(n, m) ** -2.0 * (n > 1) for n, m in stack.terms.tolist()]
    return np.asarray(np.minimum(4.4 * least_average(step) / (1.0 + 0.5 * variance), 0.9 / (1.0 + variance)))


def _smallest(sizes: NDArray[np.intp], remainders: Array, asked: Array, step: float) -> NDArray[np.intp]:
    """Return the smallest box of each pupil outside of which rims are likely to give what is asked, 0 for none."""
    nearest = 0.5 * step * sizes
    field = np.minimum(1.0, math.sqrt(4.0 * math.pi) / step) * remainders[:, None] * nearest**-RIM_ORDERS
    off = field * (2.0 * np.sqrt(1.7 * nearest**-3.0) + field)
    found = off <= _FIELD * asked[:, None]
    boxes = np.where(found.any(axis=1), sizes[found.argmax(axis=1)], 0)
    # Few of a box go with the next larger one.
    if len(boxes) <= _TOGETHER:
        return np.where(boxes > 0, boxes.max(), 0)
    present, counts = np.unique(boxes[boxes > 0], return_counts=True)
    for box, larger, many in zip(present[:-1], present[1:], counts[:-1], strict=True):
        if many < _TOGETHER:
            boxes[boxes == box] = larger
    return boxes
