"""Crossings of checkerboards in images of charts, and the reasons why others are refused."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage

import lommel as lm
from lommel.detection import find_crossings, grid_indices

NOISE = lm.Noise(read=2.0)


def board(shape=(180, 240), pitch=30.0, angle=0.1, sigma=0.8, perspective=0.0, squares=None):
    """Return the electrons of a checkerboard, and the places of its crossings: lines p and q at whole numbers."""
    fine = [(np.arange(4 * side) + 0.5) / 4 - 0.5 - (side - 1) / 2 for side in shape]
    y, x = fine[0][:, None], fine[1][None]
    scale = (1.0 + perspective * x / shape[1]) * pitch
    p, q = (
        (x * np.cos(angle) + y * np.sin(angle)) / scale + 0.3,
        (y * np.cos(angle) - x * np.sin(angle)) / scale + 0.2,
    )
    white = (np.floor(p) + np.floor(q)) % 2 == 1
    if squares:
        white |= (np.abs(p) > squares) | (np.abs(q) > squares)
    mean = np.where(white, 5000.0, 500.0).reshape(shape[0], 4, shape[1], 4).mean((1, 3))
    steps = np.arange(-30, 31) if squares is None else np.arange(np.ceil(-squares), squares)
    a, b = (part.ravel() for part in np.meshgrid(steps - 0.3, steps - 0.2))
    u, v = pitch * (a * np.cos(angle) - b * np.sin(angle)), pitch * (a * np.sin(angle) + b * np.cos(angle))
    u, v = (part / (1.0 - perspective * u / shape[1]) for part in (u, v))
    places = np.column_stack([v + (shape[0] - 1) / 2, u + (shape[1] - 1) / 2])
    return ndimage.gaussian_filter(mean, sigma), places


@pytest.mark.parametrize("angle", [0.0, 0.1, np.pi / 4, 2.0])
@pytest.mark.parametrize("perspective", [0.0, 0.3])
def test_all_crossings_are_found_where_lines_meet(angle, perspective):
    mean, places = board(angle=angle, perspective=perspective)
    found = find_crossings(NOISE.record(mean, seed=1), noise=NOISE)
    inside = ((places > 11) & (places < np.array(mean.shape) - 12)).all(axis=1)
    distance = np.abs(places[inside][:, None] - found.centers).max(axis=-1)
    assert (distance.min(axis=1) < 0.5).all()
    assert (np.abs(places - found.centers[:, None]).max(axis=-1).min(axis=1) < 0.5).all()
    assert abs(found.square - 30.0) < 4.0
    np.testing.assert_allclose(np.median(found.contrast), 4500.0, rtol=0.15)
    np.testing.assert_array_equal(np.abs(found.places - found.centers).max(axis=1) <= 0.5, True)
    # Windows do not overlap.
    apart = np.abs(found.places[:, None] - found.places[None]).max(axis=-1) + 1000 * np.eye(len(found))
    assert apart.min() >= found.windows.shape[-1]


def test_only_crossings_of_four_squares_are_taken():
    mean, places = board(pitch=24.0, squares=2.5)
    found = find_crossings(NOISE.record(mean, seed=2), noise=NOISE)
    assert len(found) == len(places) == 25
    assert found.refused == ()
    assert found.message == "25 crossings found, 24 pixels apart; refused: none"
    many = find_crossings(NOISE.record(mean, seed=2), noise=NOISE, most=4)
    outer = places[np.abs(places - places.mean(axis=0)).sum(axis=1) > 55.0]
    assert len(many) == 4
    assert (np.abs(outer - many.centers[:, None]).max(axis=-1).min(axis=1) < 1.0).all()


def test_reasons_of_refusal():
    mean, _ = board()
    image = NOISE.record(mean, seed=3)
    whole = find_crossings(image, noise=NOISE, window=21)
    assert "edge" in {each.reason for each in whole.refused}
    glare = image.copy()
    row, column = whole.places[7]
    glare[row + 9, column - 9] = 51_000.0
    told = find_crossings(lm.Counts.of(glare, noise=NOISE, saturation=50_000), window=21)
    assert [(row, column)] == [(each.row, each.column) for each in told.refused if each.reason == "saturated"]
    close = find_crossings(image, noise=NOISE, window=41)
    assert "neighbor" in {each.reason for each in close.refused}
    assert len(close) > 3
    stack = find_crossings(np.stack([image, image]), noise=NOISE, window=21)
    assert stack.windows.shape == (len(whole), 2, 21, 21)
    np.testing.assert_array_equal(stack.windows[:, 1], whole.windows)
    assert stack.plot().get_title().replace("\n", " ") == stack.message


def test_stars_edges_and_noise_are_no_crossings():
    draw = np.random.default_rng(4)
    stars = np.full((160, 160), 20.0)
    stars[30::40, 30::40] += 4e4
    slanted = np.where(np.mgrid[:160, :160].sum(axis=0) > 150, 4000.0, 400.0)
    corner = np.full((160, 160), 400.0)
    corner[40:90, 50:120] = 4000.0
    for mean in (np.full((160, 160), 1000.0), ndimage.gaussian_filter(stars, 1.5), slanted, corner):
        found = find_crossings(NOISE.record(mean, seed=int(draw.integers(99))), noise=NOISE)
        assert found.message == "0 crossings found; refused: none"


def test_crossings_whose_windows_are_masked_are_refused_and_holes_do_not_hide_others():
    image = NOISE.record(board()[0], seed=1)
    plain = find_crossings(image, noise=NOISE)
    (row, column), (hole, beside) = plain.places[3], plain.places[7]
    out = np.zeros(image.shape, dtype=bool)
    out[row - 4 : row + 5, column - 4 : column + 5] = out[hole, beside] = True
    found = find_crossings(np.where(out, np.nan, image), noise=NOISE)
    assert found.left_out == 82
    assert "masked" in {each.reason for each in found.refused}
    near = np.abs(found.places - [hole, beside]).max(axis=1)
    assert near.min() <= 1
    assert np.ma.getmaskarray(found.windows)[near.argmin()].sum() == 1
    assert np.abs(found.places - [row, column]).max(axis=1).min() > 4


def bent(angle, missing=(), stray=0):
    """Return indices and places of a grid of 9 x 12 points through a lens, in random order."""
    draw = np.random.default_rng(3)
    true = np.stack(np.meshgrid(np.arange(9), np.arange(12), indexing="ij"), axis=-1).reshape(-1, 2).astype(float)
    true = np.delete(true, list(missing), axis=0)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    at = 40.0 * (true - [4.0, 5.5]) @ turn.T
    at *= 1.0 - 1.5e-6 * (at**2).sum(axis=1, keepdims=True)
    at += draw.normal(size=at.shape)
    extra = 200.0 * np.ones((stray, 2)) + [57.0, 61.0]
    order = draw.permutation(len(true) + stray)
    return np.concatenate([true, np.full((stray, 2), np.nan)])[order], np.concatenate([at, extra])[order] + 500.0


@pytest.mark.parametrize("angle", [0.0, -0.3, 0.7])
def test_points_have_their_row_and_column_from_the_first_on(angle):
    true, at = bent(angle, missing=(40, 41, 55))
    np.testing.assert_array_equal(grid_indices(at), true)


def test_points_beside_the_grid_have_none():
    true, at = bent(0.1, stray=1)
    found = grid_indices(at)
    assert np.isnan(true).any()
    np.testing.assert_array_equal(found, true)


@pytest.mark.parametrize(
    ("places", "message"),
    [
        (np.column_stack([np.zeros(8), np.arange(8.0)]), "places must be on a square grid"),
    ],
)
def test_what_is_no_grid_is_told(places, message):
    with pytest.raises(ValueError, match=message):
        grid_indices(places)
