"""Hot pixels are told from points of light by what the PSF lets a point exceed its neighbours by."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import j1

import lommel as lm
from lommel.microscopy.hot_voxels import LeftOut, hot_voxels, sharpness

NOISE = lm.Noise(white=0.5, read=1.6, offset=100.0)


def airy(v):
    v = np.maximum(v, 1e-9)
    return (2.0 * j1(v) / v) ** 2


def beads(step, peak):
    """Return counts of beads anywhere within a voxel, in planes of 32 x 32; step is that of v in Airy's pattern."""
    draw = np.random.default_rng(3)
    y, x = np.indices((32, 32))
    light = [
        peak * airy(step * np.hypot(y - 16 - draw.uniform(-0.5, 0.5), x - 16 - draw.uniform(-0.5, 0.5)))
        for _ in range(40)
    ]
    electrons = draw.poisson(20.0 + np.array(light)) + draw.normal(0.0, 1.6, (40, 32, 32))
    return np.clip(np.round(100.0 + electrons / 0.5), 0, 65535).astype(np.uint16)


@pytest.mark.parametrize("step", [0.6, 1.2, 2.5])
@pytest.mark.parametrize("peak", [30.0, 3e3, 2e4])
def test_points_of_light_are_not_hot_and_hot_pixels_are_found(step, peak):
    stack = beads(step, peak)
    y, x = np.indices((9, 9)) - 4
    sharpest = sharpness(airy(step * np.hypot(y, x))[None])
    assert sharpest == pytest.approx(1.0 / float(airy(step)))
    assert len(hot_voxels(stack, NOISE, sharpest)) == 0
    stack[7, 3, 5], stack[20, 0, 31] = 3000, 65535
    assert hot_voxels(stack, NOISE, sharpest).tolist() == [[7, 3, 5], [20, 0, 31]]


def test_what_is_left_out_is_unknown():
    voxels = np.array([[1, 2, 3]])
    whole = LeftOut(np.full((2, 4, 5), 7, np.uint16), voxels, 4000.0)
    assert whole.limit == 4000.0
    assert whole[1, 1:3, 2:].tolist() == [[7, 7, 7], [7, 4000, 7]]
    assert (whole[0] == 7).all()
    assert LeftOut(np.zeros((2, 4, 5), np.uint16), voxels, np.inf).limit == 65535
    assert np.isnan(LeftOut(np.zeros((2, 4, 5), np.float32), voxels, np.inf)[1][2, 3])
