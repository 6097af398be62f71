"""What the stage of a microscope does between planes."""

from __future__ import annotations

import numpy as np


def positions(planes: int, step: float, jitter: float = 0.0, seed: int = 0) -> np.ndarray:
    """Return where the stage is in each plane, metres, with jitter (rms)."""
    return (np.arange(planes) - planes // 2) * step + np.random.default_rng(seed).normal(size=planes) * jitter


def drift(planes: int, row: float = 0.0, column: float = 0.0, walk: float = 0.0, seed: int = 0) -> np.ndarray:
    """Return (planes, 2) pixels that the sample moved: so many a plane, and a random walk."""
    line = np.outer(np.arange(planes) - planes // 2, (row, column))
    return line + np.cumsum(np.random.default_rng(seed).normal(size=(planes, 2)) * walk, axis=0)


def backwards(stack: np.ndarray) -> np.ndarray:
    """Return the planes in the other order."""
    return stack[::-1].copy()
