"""What crosses the edges of an image, and what copies of its edges take: sums over rows that stand for others."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray


def folded(room: NDArray[Any], beyond: int, count: int) -> NDArray[Any]:
    """Return rows of an image between two mirrors, from what its points alone spread.

    The mirrored points send in what leaves the image, mirrored too.

    Parameters
    ----------
    room : ndarray, shape (beyond + count + beyond, any)
        Is written to.
    beyond : int
        Rows that are known before the image and after it.
    count : int
        Rows of the image.

    Returns
    -------
    ndarray, shape (count, any)
        A part of `room`.
    """
    image = room[beyond : beyond + count]
    for first in range(beyond % count - count, len(room), count):  # So many lie between two mirrors.
        if first != beyond:
            part = room[max(0, first) : first + count]
            onto = image[::-1] if (first - beyond) // count % 2 else image
            onto[max(0, -first) :][: len(part)] += part
    return image


def gathered(taken: NDArray[Any], places: NDArray[np.int64], count: int) -> NDArray[Any]:
    """Return the sum of all rows that have the same place.

    Parameters
    ----------
    taken : ndarray, shape (n, any)
    places : ndarray of int, shape (n,)
        Each of the places at least once.
    count : int
        How many places there are.

    Returns
    -------
    ndarray, shape (count, any)
    """
    if len(places) == count:
        return taken
    total = np.zeros((count, taken.shape[1]), dtype=taken.dtype)
    for place, row in zip(places, np.ascontiguousarray(taken), strict=True):
        total[place] += row
    return total
