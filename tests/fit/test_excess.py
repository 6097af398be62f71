"""The score test of excess noise: right on a register's counts, silent where means or noise are otherwise wrong."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.fit.excess import excess_test
from lommel.recorded.noise import Noise

Y, X = np.mgrid[:21, :21] - 10.0
READ = 0.2


def spot(width: float, flux: float = 2000.0, background: float = 8.0) -> np.ndarray:
    return flux * np.exp(-0.5 * (X**2 + Y**2) / width**2) / (2.0 * np.pi * width**2) + background


def outcome(mean: np.ndarray, model: np.ndarray, noise: Noise, images: int = 40, seed: int = 1):
    seen = noise.electrons(noise.record(np.broadcast_to(mean, (images, *mean.shape)), seed))
    return excess_test(seen - model, model, READ**2)


@pytest.mark.parametrize("seed", range(4))
def test_a_register_is_told_with_its_share(seed):
    found = outcome(spot(2.0), spot(2.0), Noise(read=READ, excess=2.0), seed=seed)
    assert found.share == pytest.approx(1.0, abs=0.06)
    assert found.found
    said = found.finding()
    assert said is not None
    assert (said.code, said.severity) == ("excess_noise", "error")
    assert "state excess=2" in said.text
    assert said.numbers["factor"] == pytest.approx(2.0, abs=0.06)
    assert found.finding(excess=2.0) is None


def test_where_the_noise_is_right_the_share_is_0_within_its_error():
    sizes = np.array([outcome(spot(2.0), spot(2.0), Noise(read=READ), 4, seed).sigmas for seed in range(100)])
    assert 0.8 < sizes.std() < 1.2
    assert abs(sizes.mean()) < 0.4


@pytest.mark.parametrize("width", [1.7, 1.8, 2.3])
def test_a_wrong_mean_is_not_taken_for_it(width):
    found = outcome(spot(2.0), spot(width), Noise(read=READ))
    assert found.sigmas > 5.0
    assert not found.found
    assert found.finding() is None


@pytest.mark.parametrize("excess", [1.3, 4.0])
def test_other_factors_are_not_called_a_register(excess):
    assert not outcome(spot(2.0), spot(2.0), Noise(read=READ, excess=excess)).found


def test_read_noise_says_nothing_of_it():
    found = excess_test(np.random.default_rng(1).normal(0, 5.0, 1000), 0.5, 4.0)
    assert found.share > 1.0
    found = excess_test(np.full(100, np.nan), 1.0, 1.0)
    assert (found.sigmas, found.found) == (0.0, False)
