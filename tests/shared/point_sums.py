"""Images as the sum of what points, and their mirror images beyond the edges, spread."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np


def sum_over_points(image: np.ndarray, window_of: Callable[[int, int], np.ndarray], side: int) -> np.ndarray:
    """Return the sum of windows (side, side) of all points, which their mirror images spread too, point by point."""
    half, (height, width) = side // 2, image.shape
    rows, columns = (np.pad(np.arange(length), half, mode="symmetric") for length in image.shape)
    total = np.zeros((height + 4 * half, width + 4 * half))
    for y, row in enumerate(rows):
        for x, column in enumerate(columns):
            if image[row, column]:
                total[y : y + side, x : x + side] += image[row, column] * window_of(row, column)
    return total[2 * half : 2 * half + height, 2 * half : 2 * half + width]
