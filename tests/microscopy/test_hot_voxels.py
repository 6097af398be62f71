"""Hot pixels are told from points of light by what the PSF lets a point exceed its neighbours by."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import j1

import lommel as lm
from lommel.recorded.camera_noise import LeftOut, hot_pixels, hot_voxels, sharpness

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


def in_depth(step, planes, column=False):
    """Return light of a bead that is in focus in the middle plane, or of a line along z, and 20 electrons."""
    y, x = np.indices((32, 32)) - 16
    wide = 1.0 + (0.0 if column else 1.0) * np.abs(np.arange(planes) - planes // 2)[:, None, None] / 3.0
    return 20.0 + 3e3 * airy(step * np.hypot(y, x) / wide) / wide**2


@pytest.mark.parametrize("excess", [25.0, 400.0, 2e4])
def test_hot_pixels_are_those_above_their_neighbours_in_most_planes(excess):
    planes, step = 24, 1.2
    y, x = np.indices((9, 9)) - 4
    sharpest = sharpness(airy(step * np.hypot(y, x))[None])
    places = [(3, 5), (3, 6), (0, 31), (20, 9), (28, 28)]  # two beside each other, one in a corner
    for light in (in_depth(step, planes), in_depth(step, planes, column=True)):
        clean = NOISE.record(light, seed=1)
        assert not hot_pixels(clean, NOISE, sharpest).any()
        for place in places:
            light[:, *place] += excess
        spoilt = NOISE.record(light, seed=1)
        found = hot_pixels(spoilt, NOISE, sharpest)
        assert [tuple(each) for each in np.argwhere(found)] == sorted(places)
        spoilt[:, 16, 17] = np.nan
        assert not hot_pixels(spoilt, NOISE, sharpest)[16, 17]
    assert not hot_pixels(spoilt[:4], NOISE, sharpest).any()  # too few planes tell nothing


def test_what_is_left_out_is_unknown():
    voxels = np.array([[1, 2, 3]])
    whole = LeftOut(np.full((2, 4, 5), 7, np.uint16), 4000.0, voxels=voxels)
    assert whole.limit == 4000.0
    assert whole[1, 1:3, 2:].tolist() == [[7, 7, 7], [7, 4000, 7]]
    assert (whole[0] == 7).all()
    assert LeftOut(np.zeros((2, 4, 5), np.uint16), np.inf, voxels=voxels).limit == 65535
    assert np.isnan(LeftOut(np.zeros((2, 4, 5), np.float32), np.inf, voxels=voxels)[1][2, 3])
    mask = np.zeros((4, 5), bool)
    mask[2, 3] = True
    for given in (mask, np.stack([mask, mask])):
        assert np.argwhere(LeftOut(whole, 4000.0, mask=given)[0, 1:, 2:] == 4000).tolist() == [[1, 1]]
