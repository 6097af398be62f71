"""Indices of the points of a square grid, such as pinholes or crossings of a checkerboard, that a lens has bent."""

from __future__ import annotations

from collections import deque

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial import cKDTree

from lommel.base import validation
from lommel.base.arrays import Array

_STEPS = ((1, 0), (-1, 0), (0, 1), (0, -1))
_NEAR = 0.25  # of a step: how far a point may be from where its neighbour says
_SEEDS = 20


def grid_indices(places: ArrayLike) -> Array:
    """Return the row and column, on a square grid, of points in an image.

    Parameters
    ----------
    places : array_like, shape (n, 2)
        Row and column of each point, such as `centers` of :func:`lommel.find_spots`, in any order; n at least 4.

    Returns
    -------
    ndarray, shape (n, 2)
        Whole numbers from 0 on, that grow downwards and to the right in an image turned by less than 45 degrees; NaN
        of points without a neighbour on the grid.

    Raises
    ------
    TypeError, ValueError
        If there are fewer points, they are not finite, or no two steps of a grid are among them.

    Notes
    -----
    From a point in the middle each neighbour is looked for a step away, and steps are measured anew there: distortion
    and perspective may change them slowly. Points may be missing, as long as there is a way around.

    Examples
    --------
    >>> import lommel as lm
    >>> lm.grid_indices([[11.0, 20.0], [10.0, 10.2], [20.1, 9.8], [20.3, 20.0]]).tolist()
    [[0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]
    """
    at = validation.real_array("places", places)
    if at.ndim != 2 or at.shape[1] != 2 or len(at) < 4:
        raise ValueError(f"places must be the rows and columns of at least 4 points, got shape {at.shape}")
    tree = cKDTree(at)
    best: dict[int, tuple[int, int]] = {}
    for seed in np.argsort(((at - np.median(at, axis=0)) ** 2).sum(axis=1))[:_SEEDS].tolist():
        if seed in best or (steps := _steps(at, tree, seed)) is None:
            continue
        found = _grown(at, tree, seed, steps)
        if len(found) > len(best):
            best = found
        if len(best) > len(at) // 2:
            break
    if len(best) < 4:
        raise ValueError(f"places must be of a square grid, got {len(at)} points of which no 4 are")
    known = np.full(at.shape, np.nan)
    known[list(best)] = list(best.values())
    return np.asarray(known - np.nanmin(known, axis=0))


def _steps(places: Array, tree: cKDTree, seed: int) -> Array | None:
    """Return the steps (2, 2) downwards and to the right beside a point, None without two at about right angles."""
    away, near = tree.query(places[seed], k=min(5, len(places)))
    offsets = (places[near] - places[seed])[away > 0.0]
    unit = offsets / np.linalg.norm(offsets, axis=1)[:, None]
    down = int(np.argmax(np.abs(unit[:, 0])))
    across = int(np.argmin(np.abs(unit @ unit[down])))
    if abs(unit[across] @ unit[down]) > 0.4:
        return None
    steps = np.stack([offsets[down] * np.sign(unit[down, 0]), offsets[across]])
    if np.linalg.det(steps) < 0.0:
        steps[1] *= -1.0
    return np.asarray(steps)


def _grown(places: Array, tree: cKDTree, seed: int, steps: Array) -> dict[int, tuple[int, int]]:
    """Return the indices of points that steps lead to."""
    found, taken = {seed: (0, 0)}, {(0, 0)}
    waiting = deque([(seed, steps)])
    while waiting:
        point, own = waiting.popleft()
        for step in _STEPS:
            index = (found[point][0] + step[0], found[point][1] + step[1])
            away = np.asarray(step) @ own
            distance, other = tree.query(places[point] + away)
            if index in taken or other in found or distance > _NEAR * np.linalg.norm(away):
                continue
            found[int(other)] = index
            taken.add(index)
            changed = own.copy()
            changed[0 if step[0] else 1] = sum(step) * (places[other] - places[point])
            waiting.append((int(other), changed))
    return found
