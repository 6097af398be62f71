"""Images along z: bounds of Chebyshev pieces against the waves, and the images, that they are of."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.core import engine
from lommel.localize.table import Pieces, Waves, pieces
from objectives import OIL

TIRF = lm.Objective(NA=1.49, magnification=100, immersion=1.518, sample=1.33)
TERMS = engine.MoleculeTable.terms


def of(made: Pieces, values: np.ndarray, low: float, high: float, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """What pieces make of values at their places, and the slope."""
    count = len(made.matrix)
    length = (high - low) / count
    which = np.clip(((z - low) / length).astype(int), 0, count - 1)
    x = 2.0 * (z - low - which * length) / length - 1.0
    series = made.matrix @ values
    vander = np.polynomial.chebyshev.chebvander(x, TERMS - 1)
    slopes = np.stack(
        [np.polynomial.chebyshev.chebval(x, np.polynomial.chebyshev.chebder(row)) for row in np.eye(TERMS)], axis=1
    )
    return np.einsum("zk,zk...->z...", vander, series[which]), (2.0 / length) * np.einsum(
        "zk,zk...->z...", slopes, series[which]
    )


@pytest.mark.parametrize("error", [1e-3, 1e-5, 1e-8])
def test_waves_up_to_the_rate_are_within_the_error(error):
    waves = Waves(OIL.pupil(depth=1e-6, wavelength=600e-9), "z")
    low, high = -0.7e-6, 0.4e-6
    made = pieces(waves, low, high, error)
    z = np.linspace(low, high, 777)
    w = waves.rate * np.append(np.linspace(-1.0, 1.0, 41), 0.999)
    values, slopes = of(made, np.exp(1j * np.outer(made.places, w)), low, high, z)
    exact = np.exp(1j * np.outer(z, w))
    assert np.abs(values - exact).max() <= made.error.value <= error
    assert np.abs(slopes - 1j * w * exact).max() <= made.error.slope
    # Not so wide that they say nothing.
    assert np.abs(values - exact).max() >= 1e-4 * made.error.value
    # Fewer pieces would not do.
    assert len(made.matrix) == 1 or np.abs(values - exact).max() >= 1e-3 * error


@pytest.mark.parametrize("low", [0.0, 0.15e-6])
@pytest.mark.parametrize("error", [1e-4, 1e-6])
def test_light_that_fades_with_the_depth_is_within_the_error(low, error):
    # Of one pair of waves, propagating and fading, over the light of all: what intensities are sums of.
    waves = Waves(TIRF.pupil(depth=0.2e-6, wavelength=600e-9), "depth")
    high = low + 0.5e-6
    made = pieces(waves, low, high, error)
    z = np.linspace(low, high, 501)
    k = 2.0 * np.pi / 600e-9 * 1.33
    kappa = np.sqrt((1.49 / 1.33) ** 2 - 1.0)
    for first, second in ((1.0, 0.0), (1.0, 1j * kappa), (1j * kappa, 1j * kappa), (0.3, 0.5j * kappa)):
        rate = 1j * k * (first - np.conj(second))

        def share(at, rate=rate):
            return np.exp(rate * at) / waves.light(at)

        values, slopes = of(made, share(made.places), low, high, z)
        assert np.abs(values - share(z)).max() <= made.error.value <= error
        step = 1e-11
        exact = (share(z[1:-1] + step) - share(z[1:-1] - step)) / (2.0 * step)
        assert np.abs(slopes[1:-1] - exact).max() <= made.error.slope + 1e-4 * np.abs(exact).max()
        assert np.abs(exact).max() <= waves.max_slope * 1.001


def test_a_range_too_long_is_refused():
    waves = Waves(OIL.pupil(depth=1e-6, wavelength=600e-9), "z")
    with pytest.raises(ValueError, match=r"z must span less: a range of 0\.0001 m needs more than 200 series"):
        pieces(waves, -5e-5, 5e-5, 1e-6)
