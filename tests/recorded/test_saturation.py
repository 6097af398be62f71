"""Flat tops of images: saturation that was not stated."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.recorded.counts import flat_top, full_value

AIRY = lm.psf(lm.Pupil(), 31, 0.5).values


def counts(flux, white, seed):
    """Return a stack of stars in counts and its noise."""
    noise = lm.Noise(white=white, read=1.6, offset=100.0)
    return noise.record(np.repeat(flux * AIRY[None] + 20.0, 8, axis=0), seed=seed).round(), noise


@pytest.mark.parametrize("share", [0.9, 0.5, 0.1])
@pytest.mark.parametrize("white", [0.1, 1.0, 5.0])
def test_a_flat_top_is_found_with_its_value(share, white):
    values, noise = counts(1e5, white, 1)
    limit = np.round(100.0 + share * (values.max() - 100.0))
    top, count = flat_top(np.minimum(values, limit), np.ones(values.shape, dtype=bool), noise)
    assert top == limit
    assert count == (values >= limit).sum()
    valid = values < limit
    assert flat_top(values, valid, noise)[1] == 0  # saturation that was stated


@pytest.mark.parametrize("white", [0.1, 1.0, 30.0])
def test_noise_alone_has_no_flat_top_even_if_few_counts_are_many_electrons(white):
    for flux in (0.0, 30.0, 300.0, 1e5):
        for seed in range(10):
            values, noise = counts(flux, white, seed)
            assert flat_top(values, np.ones(values.shape, dtype=bool), noise)[1] == 0


def test_full_is_what_is_stated_else_the_largest_of_the_type_or_of_the_bits_of_a_camera():
    values, _ = counts(1e5, 5.0, 3)
    stored = values.astype(np.uint16)
    for bits in (8, 10):
        for made in (np.minimum(stored, 2**bits - 1), np.minimum(values, 2**bits - 1)):
            limit, said = full_value(list(made), None)
            assert limit == 2**bits - 1
            assert said.startswith(
                f"{(made == limit).sum()} pixels have exactly the largest value, {limit:.10g}, that of"
            )
            assert full_value([made], 999.0) == (999.0, "")
            assert full_value([made], np.inf)[0] == np.inf
    assert full_value([stored], None) == (65535, "")
    assert full_value([values], None) == (np.inf, "")
    assert full_value([np.minimum(values, 4000.0)], None) == (np.inf, "")  # which flat_top asks about


@pytest.mark.parametrize("white", [0.1, 1.0, 30.0])
def test_noise_that_ends_at_a_power_of_two_is_not_saturated(white):
    for flux in (30.0, 300.0, 1e5):
        for seed in range(5):
            values, _ = counts(flux, white, seed)
            for shift in (0, 1023 - values.max()):  # its largest value is that of ten bits
                assert full_value([values + shift], None)[0] == np.inf
