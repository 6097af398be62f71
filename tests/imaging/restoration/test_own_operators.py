"""Restoration with any linear blur."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from lommel import Lens, Noise
from lommel.imaging import DepthBlur, LinearBlur, RichardsonLucy, TotalVariation, restore

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


def test_what_is_told_is_what_happened() -> None:
    lens = Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
    blur = DepthBlur(np.full((40, 48), 2.3), lens, 8e-6, channels=(600e-9, 500e-9))
    scene = np.kron(np.random.default_rng(1).uniform(0.1, 0.8, (5, 6, 2)), np.ones((8, 8, 1))).astype(np.float32)
    photo = np.moveaxis(NOISE.record(np.moveaxis(4000.0 * blur.forward(scene), 2, 0), seed=2), 0, 2)
    photo[5:9, 7:11, 0] = np.nan
    told: list[tuple[int, float, float]] = []
    found = restore(photo, None, blur, encoding="linear", noise=NOISE, progress=lambda *at: told.append(at))
    assert found.stopped == "noise"
    assert (found.steps, found.discrepancy) == (told[-1][0], pytest.approx(told[-1][1], rel=1e-5))
    assert found.unknown == pytest.approx(16 / photo.size)
    assert found.strength is None
    assert found.light.dtype == np.float32
    np.testing.assert_array_equal(np.asarray(found, dtype=np.float64), found.values)
    # What the sensor did not see is filled by what lies around it.
    assert np.isfinite(found.light).all()
    assert abs(found.light[5:9, 7:11, 0] - scene[5:9, 7:11, 0]).mean() < 0.15
