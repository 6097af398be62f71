"""Pictures of localised molecules: where their light is, how wide, and its colour."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np
import pytest

from lommel.localize.localizations import columns
from lommel.show.estimates import rendered


@pytest.fixture(autouse=True)
def _closed():
    yield
    plt.close("all")


def molecules(*places: tuple[float, float, float, float]) -> np.ndarray:
    """Rows at x, y, z with a standard error, nanometres."""
    rows = np.zeros(len(places), columns())
    rows["x"], rows["y"], rows["z"], rows["x_error"] = 1e-9 * np.array(places).reshape(-1, 4).T
    rows["y_error"] = rows["x_error"]
    return rows


def test_each_molecule_is_a_gaussian_of_its_deviation_where_it_is():
    rows = molecules((305.0, 105.0, 0.0, 20.0))
    image = rendered(rows, (400e-9, 600e-9), 10e-9, np.ones((1, 3)))
    assert image.shape == (40, 60, 3)
    light = image[..., 0] ** 2  # brightness is the root of light
    y, x = np.mgrid[:40, :60]
    assert (light * y).sum() / light.sum() == pytest.approx(10.0, abs=0.01)
    assert (light * x).sum() / light.sum() == pytest.approx(30.0, abs=0.01)
    light = np.where(np.hypot(y - 10, x - 30) < 8, light, 0.0)
    below = light < 0.99 * light.max()  # the brightest hundredth is clipped
    expected = np.exp(-((y - 10.0) ** 2 + (x - 30.0) ** 2) / (2.0 * 2.0**2))
    np.testing.assert_allclose(
        light[below & (expected > 0.05)] / light.max(), expected[below & (expected > 0.05)], rtol=0.2
    )


def test_colours_are_those_of_the_molecules_and_mix_by_light():
    rows = molecules((100.0, 100.0, 0.0, 10.0), (300.0, 100.0, 1.0, 10.0))
    image = rendered(rows, (200e-9, 400e-9), 10e-9, np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]))
    assert image[10, 10, 0] > 0.9
    assert image[10, 10, 2] < 1e-6
    assert image[10, 30, 2] > 0.9
    assert image.min() >= 0.0
    assert image.max() <= 1.0
    same = rendered(molecules((100.0, 100.0, 0.0, 10.0), (100.0, 100.0, 1.0, 10.0)), (200e-9, 400e-9), 10e-9,
                    np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]))  # fmt: skip
    assert same[10, 10, 0] == pytest.approx(same[10, 10, 2])


def test_no_molecules_are_black_and_those_outside_are_left_out():
    assert not rendered(molecules(), (1e-7, 1e-7), 1e-8, np.zeros((0, 3))).any()
    assert not rendered(molecules((-50.0, 50.0, 0.0, 5.0)), (1e-7, 1e-7), 1e-8, np.ones((1, 3))).any()
