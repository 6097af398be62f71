"""What chi2 noise alone explains, beside draws of chi2 and of counts of few electrons."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from lommel.fit import goodness_of_fit


@pytest.mark.parametrize("freedom", [5, 40, 1500, 2e4])
def test_limits_are_quantiles_of_chi2_for_its_degrees_of_freedom(freedom):
    spread = np.sqrt(2.0 / freedom)
    for share in (1e-2, 1e-4):
        above, below = stats.chi2.isf(share, freedom) / freedom, stats.chi2.ppf(share, freedom) / freedom
        np.testing.assert_allclose(goodness_of_fit.most(spread, share), above, rtol=1e-9)
        np.testing.assert_allclose(goodness_of_fit.least(spread, share), below, rtol=1e-9)
        assert goodness_of_fit.chance(above, spread) == pytest.approx(share)


def test_limits_hold_for_counts_of_few_electrons():
    draw, mean, read, pixels = np.random.default_rng(1), 0.4, 0.25, 150
    counts = draw.poisson(mean, (100_000, pixels)) + np.sqrt(read) * draw.normal(size=(100_000, pixels))
    chi2 = ((counts - mean) ** 2).mean(axis=1) / (mean + read)
    spread = np.sqrt((mean + 2.0 * (mean + read) ** 2) / pixels) / (mean + read)
    for share in (1e-2, 1e-3):
        assert 0.4 < (chi2 > goodness_of_fit.most(spread, share)).mean() / share < 2.5
    # So many standard deviations of a normal distribution would be passed several times as often.
    assert (chi2 > 1.0 + stats.norm.isf(1e-3) * spread).mean() > 4e-3


def test_a_chi2_that_noise_seldom_exceeds_is_remarked_on():
    spread = np.sqrt(2.0 / 1500)
    assert goodness_of_fit.chi2_findings(1.05, spread, "why") == []
    (found,) = goodness_of_fit.chi2_findings(1.13, spread, "why")
    assert (found.code, found.severity, found.text) == (
        "rare_chi2", "note", "noise alone exceeds this chi2 in 0.03 % of fits"
    )  # fmt: skip
    assert 1.13 < goodness_of_fit.most(spread) < 1.15
