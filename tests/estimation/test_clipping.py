"""Flat tops of images: saturation that was not stated."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.estimation.clipping import flat_top, left_out

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


def test_pixels_left_out_are_counted_over_all_images():
    valid = np.ones((2, 3, 4), dtype=bool)
    assert left_out([valid, valid]) == ""
    valid[0, 0] = False
    assert left_out([valid, valid]).startswith("; 8 of 48 pixels left out")
