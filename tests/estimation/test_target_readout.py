"""Pinholes and corners of checkerboards read from samples of PSFs, beside objects drawn and convolved finely."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
import simulated_fields as simulated
from lommel.blur.mixtures import BlurProfile
from lommel.estimation.target_readout import Target, TargetReadout, relative_light, start_of_crossing

WAVES = np.array([0.4, 0.3, -0.2, 0.3, -0.25])
PLACE = 0.3, -0.2
SQUARE, PAIR = np.pi / 2, 2


def samples(reader, pixel):
    """Return samples of the PSF on the lattice of a reader, the axis at PLACE."""
    pupil = lm.Pupil(lm.Wavefront.zernike(dict(enumerate(WAVES, 4)), order="noll"))
    center = [side // 2 + part * pixel / reader.step for side, part in zip(reader.shape, PLACE, strict=True)]
    return lm.psf(pupil, reader.shape, reader.step, integrate=False, center=tuple(center)).values


@pytest.mark.parametrize(
    ("pixel", "pitch", "sigma", "angles"),
    [
        (0.9, 25.0, 0.3, (1.0, 1.0 + SQUARE)),
        (0.5, 40.0, 0.6, (0.2, 0.24 + SQUARE)),
        (0.9, math.inf, 0.0, (0.1, 1.65)),
    ],
)
def test_corners_are_boards_convolved_with_psf_blur_and_pixel(pixel, pitch, sigma, angles):
    side = 13
    drawn = simulated.board(PLACE, angles, pitch if math.isfinite(pitch) else 1e4)
    exact = simulated.extended(drawn, simulated.Telescope(5, side=96), WAVES, pixel, side, sigma)
    reader = TargetReadout((side, side), pixel, Target("crossing", pitch), BlurProfile.gaussian(), integrate=True)
    light = samples(reader, pixel)
    value, *slopes = reader.read([light[None]], np.array([[sigma**2]]), np.array([angles]), derivatives=True)
    # Light far from the axis, of which both leave out some, sees a mean of many squares.
    np.testing.assert_allclose(2.0 * value[0], exact, atol=3e-3)
    assert np.abs(exact).max() > 0.8
    both = np.array([light, light])
    for k, slope in enumerate(slopes):
        square, turned = np.full(PAIR, sigma**2), np.tile(angles, (PAIR, 1))
        step = np.array([1e-3, -1e-3])
        if k == 0:
            square += step
        else:
            turned[:, k - 1] += step
        up, down = reader.read([both], square[:, None], turned, derivatives=True)[0]
        change = (up - down) / 2e-3
        np.testing.assert_allclose(slope[0], change, atol=2e-3 * np.abs(change).max())


def test_pinholes_are_sums_of_psfs_over_their_discs():
    pixel, side, size = 0.5, 13, 3.0
    reader = TargetReadout((side, side), pixel, Target("pinhole", size), BlurProfile.gaussian(), integrate=True)
    found = reader.read([samples(reader, pixel)[None]], np.zeros((1, 1)), np.zeros((1, 0)), derivatives=False)[0][0]

    def disc(y, x):
        return ((y - PLACE[0]) ** 2 + (x - PLACE[1]) ** 2 < (size / 2) ** 2) / (np.pi * (size / 2) ** 2)

    exact = simulated.extended(disc, simulated.Telescope(5, side=96), WAVES, pixel, side, 0.0)
    np.testing.assert_allclose(found, exact, atol=0.01 * exact.max())


@pytest.mark.parametrize("angle", [0.03, 1.2, 2.5])
def test_a_search_begins_where_lines_cross(angle):
    board = simulated.board((1.6, -0.8), (angle, angle + SQUARE), 40.0)
    image = simulated.extended(board, simulated.Telescope(5, side=64), WAVES, 0.7, 21, 0.5, over=3, reach=8.0)
    row, column, first, second = start_of_crossing(3e3 + 2e3 * image)
    assert max(abs(row - 1.6), abs(column + 0.8)) < 1.1
    assert abs((first - angle + SQUARE) % np.pi - SQUARE) < 0.06
    assert second == pytest.approx(first + SQUARE)


def test_light_over_windows_is_that_of_the_chart_however_some_squares_are_printed():
    draw = np.random.default_rng(1)
    middle = np.stack(np.meshgrid(*(np.linspace(-0.9, 0.9, 7),) * 2), axis=-1).reshape(-1, 2)
    offset = (np.arange(15) - 7) * 0.008
    u, v = middle[:, :1] + offset, middle[:, 1:] + offset
    square = u[:, None] ** 2 + v[:, :, None] ** 2
    true = (1.0 - 0.2 * square + 0.03 * square**2) * (1.0 + 0.05 * u[:, None])
    pattern = np.where(np.sign(offset[:, None] * offset) > 0.0, 5000.0, 500.0)
    mean = true * pattern
    mean[::11] *= draw.uniform(0.7, 0.95, mean[::11].shape[0])[:, None, None]  # dirt
    images = draw.poisson(mean).astype(float)[:, None]
    found = relative_light(images, np.ones(images.shape, dtype=bool), u, v)
    exact = true / true[:, 7:8, 7:8]
    assert np.abs(exact - 1.0).max() > 0.02
    np.testing.assert_allclose(found[:, 0], exact, atol=5e-3)
    assert np.sqrt(((found[:, 0] - exact) ** 2).mean()) < 1e-3
    few = relative_light(images[:2], np.ones(images[:2].shape, dtype=bool), u[:2], v[:2])
    assert (few == 1.0).all()
