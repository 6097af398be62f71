"""Restoration with any linear blur."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from lommel import Noise
from lommel.imaging import LinearBlur, RichardsonLucy, TotalVariation, restore

NOISE = Noise(white=4000.0, read=3.0)


class Shift(LinearBlur):
    """Moves light by some rows, around the edge; of one's own making."""

    def __init__(self, shape: tuple[int, int], channels: int) -> None:
        self.shape, self.channels, self.dtype = shape, channels, np.dtype(np.float64)

    def forward(self, image: np.ndarray) -> np.ndarray:
        return self.by_channel(image, lambda _, plane: np.roll(plane, 3, axis=0))

    def adjoint(self, image: np.ndarray) -> np.ndarray:
        return self.by_channel(image, lambda _, plane: np.roll(plane, -3, axis=0))


@pytest.mark.parametrize("channels", [1, 3])
@pytest.mark.parametrize("method", [RichardsonLucy(steps=60, target=1e-9), TotalVariation(strength=1e-6, steps=2000)])
def test_an_operator_of_ones_own_is_undone(channels: int, method: Any) -> None:
    blur = Shift((16, 12), channels)
    scene = (
        np.random.default_rng(0)
        .uniform(0.1, 0.9, (16, 12, channels))
        .reshape((16, 12, channels)[: 2 + (channels > 1)])
    )
    found = restore(blur.forward(scene), None, blur, encoding="linear", noise=NOISE, method=method)
    np.testing.assert_allclose(found.light, scene, rtol=1e-3)
    np.testing.assert_array_equal(found.values, found.light)
    assert len(found.by_channel) == channels
    assert found.discrepancy == pytest.approx(np.mean(found.by_channel), abs=1e-12)
    assert found.discrepancy < 1e-3 < found.before
