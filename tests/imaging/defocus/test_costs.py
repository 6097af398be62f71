"""What depth costs are made of: transforms, filters orthogonal to transfer functions, windows, levels."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.estimation.pixel_transfer import squared_frequency
from lommel.imaging.defocus_depth import Costs, Transform, Weights, residuals

DRAW = np.random.default_rng(0)


@pytest.mark.parametrize("shape", [(8, 12), (9, 15), (10, 7)])
def test_a_sum_of_filtered_images_is_that_of_the_discrete_fourier_transform(shape):
    images = DRAW.normal(size=(3, *shape))
    filters = DRAW.normal(size=(3, shape[0] // 2 + 1, shape[1] // 2 + 1)).astype(np.float32)
    found = Transform(images).sum(filters)
    rows, columns = (np.minimum(np.arange(side), side - np.arange(side)) for side in shape)
    whole = filters[:, rows[:, None], columns]
    expected = np.fft.ifft2((np.fft.fft2(images) * whole).sum(axis=0)).real
    assert found == pytest.approx(expected, abs=1e-5)


@pytest.mark.parametrize("count", [2, 3, 4])
def test_residuals_are_unit_vectors_orthogonal_to_the_transfer_functions_and_to_one_another(count):
    h = DRAW.normal(size=(count, 5, 7))
    filters = list(residuals(h))
    assert len(filters) == count - 1
    for k, one in enumerate(filters):
        assert (one * h).sum(axis=0) == pytest.approx(0.0, abs=1e-9)
        for other in filters[: k + 1]:
            assert (one * other).sum(axis=0) == pytest.approx(float(one is other), abs=1e-9)


def test_residuals_do_not_jump_where_a_transfer_function_changes_its_sign():
    f = np.linspace(-1.0, 1.0, 401)
    h = np.stack([f, 0.5 + 0.1 * f, 0.3 - f])
    for one in residuals(h):
        assert np.abs(np.diff(one, axis=1)).max() < 0.05


def test_windows_are_gaussian_and_sum_to_one():
    weigh = Weights((40, 50), 8, (24, 34), 3.0)
    image = np.zeros((40, 50), dtype=np.float32)
    image[20, 25] = 1.0
    found = weigh(image)
    row, column = np.indices(found.shape) - np.array([12, 17])[:, None, None]
    gauss = np.exp(-0.5 * (row**2 + column**2) / 9.0)
    inner = np.s_[4:20, 8:28]  # further out windows end with the tile
    assert found[inner] == pytest.approx((gauss / (2.0 * np.pi * 9.0))[inner], rel=2e-2)
    assert weigh(np.ones((40, 50), dtype=np.float32)) == pytest.approx(1.0, rel=1e-6)


def scene(power, shape=(96, 96), seed=1):
    """Two images of a texture of this power over their noise, 1, and constant transfer functions but for depth."""
    draw = np.random.default_rng(seed)
    f = np.sqrt(squared_frequency(shape)).astype(np.float32)
    u = np.linspace(-1.0, 1.0, 13)[:, None, None]
    transfers = np.stack([np.exp(-((3.0 * (1.0 + u) * f) ** 2)), np.exp(-((3.0 * (1.0 - u) * f) ** 2))])
    spectrum = f**2
    spectrum[0, 0] = np.inf
    white = Transform(draw.normal(size=(1, *shape)))
    at = 8
    images = [
        white.sum((np.sqrt(power / spectrum) * transfers[k, at])[None].astype(np.float32)) + draw.normal(size=shape)
        for k in range(2)
    ]
    return np.array(images), transfers.astype(np.float32), at


def test_the_level_of_the_texture_and_its_depth_are_found():
    for power in (3.0, 100.0):
        images, transfers, at = scene(power)
        transform = Transform(images)
        assert transform.level(transfers) == pytest.approx(power, rel=0.8)  # about, whatever the depth
        assert transform.level(transfers[:, at : at + 1]) == pytest.approx(power, rel=0.1)
    weigh = Weights((96, 96), 16, (64, 64), 4.0)
    valid = np.ones((96, 96), dtype=np.float32)
    costs = Costs(images, np.ones_like(images), valid, transfers, weigh)
    assert np.mean(costs.values[0].argmin(axis=0) == at) > 0.99
    independent = 4.0 * np.pi * 16.0 * np.ones((64, 64))
    place = np.full((64, 64), at)
    assert not costs.choose(place, independent).any()
    assert len(costs.values) == 1
    costs._level()
    # At the depth, what is left is noise, by either weight.
    for k in range(2):
        chance = np.sqrt(costs.spread[k, at] / independent.mean())
        assert abs(costs.values[k][at].mean()) < chance
        assert costs.values[k][at].std() == pytest.approx(chance, rel=0.3)
        texture, sure = costs.texture(place, np.full((64, 64), k), np.ones((64, 64)), independent)
        assert sure.all()
        assert texture.mean() * costs.power == pytest.approx(power, rel=0.15)


def test_noise_is_no_texture():
    images, transfers, at = scene(100.0)
    noise = DRAW.normal(size=images.shape)
    images[:, :, 40:] = noise[:, :, 40:]  # and the edge is sharp in both: some texture beside it
    weigh = Weights((96, 96), 16, (64, 64), 4.0)
    valid = np.ones((96, 96), dtype=np.float32)
    costs = Costs(images, np.ones_like(images), valid, transfers, weigh)
    place, independent = np.full((64, 64), at), 4.0 * np.pi * 16.0 * np.ones((64, 64))
    level = costs.choose(place, independent)
    assert level[:, 44:].all()
    assert not level[:, :8].any()
    texture, sure = costs.texture(place, level, np.ones((64, 64)), independent)
    assert np.all(sure[:, :8])
    assert np.mean(sure[:, 44:]) < 0.02
    assert texture[:, 44:].max() < 0.1
    assert np.array_equal(costs.of_level(level)[:, :, 50], costs.values[1][:, :, 50])
    assert np.array_equal(costs.of_level(level)[:, :, 4], costs.values[0][:, :, 4])
