"""Pixels, and where their centres are."""

from __future__ import annotations

from dataclasses import FrozenInstanceError

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm
from lommel.optics.grid import Grid

sides = st.integers(1, 40)
grids = st.builds(lambda h, w, pixel: Grid((h, w), pixel), sides, sides, st.floats(1e-9, 1e3))


def distances(grid: Grid) -> np.ndarray:
    return np.hypot(grid.y[:, None], grid.x)


@given(grids)
def test_positions_are_whole_pixels_from_the_centre(grid):
    height, width = grid.shape
    assert (len(grid.y), len(grid.x)) == (height, width)
    assert grid.y[height // 2] == 0.0
    assert grid.x[width // 2] == 0.0
    np.testing.assert_allclose(np.diff(grid.x), grid.pixel)
    np.testing.assert_allclose(np.diff(grid.y), grid.pixel)


@given(grids)
def test_the_radii_are_the_distinct_distances_of_pixel_centres(grid):
    radii = grid.radii
    assert radii[0] == 0.0
    assert np.all(np.diff(radii) > 0)
    rows, columns = np.arange(grid.height) - grid.height // 2, np.arange(grid.width) - grid.width // 2
    squares = np.unique(rows[:, None] ** 2 + columns**2)
    np.testing.assert_allclose(radii, np.sqrt(squares) * grid.pixel, rtol=1e-14)


@given(grids)
def test_values_at_the_radii_are_painted_onto_every_pixel_at_that_distance(grid):
    image = np.empty((2, *grid.shape))
    grid.paint(np.stack([grid.radii, 1 + grid.radii]), np.array([1.0, 2.0]), image)
    np.testing.assert_allclose(image[0], distances(grid), rtol=1e-12)
    np.testing.assert_allclose(image[1], 2 * (1 + distances(grid)), rtol=1e-12)


def test_a_grid_cannot_be_changed_and_can_be_a_key():
    grid = Grid(3, 1.0)
    with pytest.raises(FrozenInstanceError):
        grid.pixel = 2.0
    assert {grid: "here"}[Grid(3, 1.0)] == "here"


@given(grids)
def test_the_multiplicity_counts_the_pixels_at_each_radius(grid):
    counted = np.unique(np.round(distances(grid) / grid.pixel, 9), return_counts=True)[1]
    assert np.array_equal(grid.multiplicity, counted)


def test_several_axes_are_read_only_and_one_of_them_is_a_grid_of_its_own():
    rows, columns = [1.0, -0.0, 2.5], 0.5
    grid = Grid((3, 4), 2.0, center=(rows, columns), integrate=True)
    assert grid.stack == (3,)
    assert grid.x.shape == (3, 4)
    assert grid.y.shape == (3, 3)
    assert not grid.centered
    assert not grid.symmetric
    for part in grid.center:
        assert part.shape == (3,)
        with pytest.raises(ValueError, match="read-only"):
            part[0] = 7.0
    one = grid[2]
    assert one == Grid((3, 4), 2.0, center=(2.5, 0.5), integrate=True)
    assert one.stack == ()
    np.testing.assert_array_equal(one.y, grid.y[2])
    np.testing.assert_array_equal(one.x, grid.x[2])
    same = Grid((3, 4), 2.0, center=([1.0, 0.0, 2.5], [0.5] * 3), integrate=True)
    assert grid == same
    assert hash(grid) == hash(same)
    assert grid == grid[[0, 1, 2]]
    for other in (grid[::-1], grid[:1], one, Grid((3, 4), 2.0), 5):
        assert grid != other
    assert grid.broadcast((2, 3))[1, 2] == one
    with pytest.raises(TypeError, match="a grid around one axis cannot be indexed"):
        one[0]
    with pytest.raises(ValueError, match="center must be one"):
        _ = grid.axis


def test_of_several_axes_the_farthest_counts():
    pupil = lm.Pupil()
    with pytest.raises(ValueError, match=r"around the farthest center=\(1.0, 400000.0\) reaches v = 1.26e\+06"):
        Grid((3, 4), 1.0, center=(1.0, [0.0, 4e5, -3e5])).require_reach(pupil)
    Grid((3, 4), 1.0, center=(1.0, [0.0, 3e5, -3e5])).require_reach(pupil)
