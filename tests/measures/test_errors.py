"""The error measures, against their definition."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm
from lommel import ClosedForm, Hankel, Pupil, Wavefront

images = st.lists(st.floats(0.0, 10.0), min_size=4, max_size=4)


@given(images, images)
def test_the_error_measures_are_what_the_paper_defines(one: list[float], other: list[float]) -> None:
    values, reference = np.array(one).reshape(2, 2), np.array(other).reshape(2, 2) + 0.5
    peak = max(other) + 0.5
    squares = [(a - b - 0.5) ** 2 for a, b in zip(one, other, strict=True)]
    assert lm.mse(values, reference) == pytest.approx(sum(squares) / 4 / peak**2, rel=1e-12)
    assert lm.peak_error(values, reference) == pytest.approx(math.sqrt(max(squares)) / peak, rel=1e-12)
    assert lm.mse(values, reference) <= lm.peak_error(values, reference) ** 2 * (1 + 1e-12)
    assert lm.mse(reference, reference) == lm.peak_error(reference, reference) == 0.0


def test_the_error_measures_take_psfs_and_do_not_depend_on_their_scale() -> None:
    pupil, method = Pupil(Wavefront(5.0)), ClosedForm()
    pairs = [
        [lm.psf(pupil, 33, 0.4, method=m, normalize=n, dtype=np.float64) for m in (method, Hankel())]
        for n in ("energy", "strehl")
    ]
    for measure in (lm.mse, lm.peak_error):
        assert measure(*pairs[0]) == pytest.approx(measure(*pairs[1]), rel=1e-12)
        assert measure(*pairs[0]) > 1e-4


@pytest.mark.parametrize(
    ("values", "reference", "message"),
    [
        ([1.0, 2.0], [1.0], "must have the same shape"),
        ([1.0, math.nan], [1.0, 2.0], "must be finite"),
        ([1.0, 2.0], [1.0, math.inf], "must be finite"),
        ([1.0, 2.0], [0.0, 0.0], "positive peak"),
    ],
)
def test_errors_of_nothing_are_refused(values: list[float], reference: list[float], message: str) -> None:
    for measure in (lm.mse, lm.peak_error):
        with pytest.raises(ValueError, match=message):
            measure(values, reference)
