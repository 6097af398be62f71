"""Which method answers where none is named."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.methods import choice

COMA = lm.Pupil(lm.Wavefront(1.0, nonradial={(3, 1): 2.0}))
STACK = lm.Pupil(lm.Wavefront(np.zeros(8), nonradial={(3, 1): np.linspace(1, 2, 8)}))
TILTED = lm.Pupil(lm.Wavefront(nonradial={(1, 1): 4000.0, (3, 1): 1.0}))


@pytest.mark.parametrize(
    ("pupil", "shape", "options", "method"),
    [
        (lm.Pupil(lm.Wavefront(9.0), obscuration=0.3), 33, {}, lm.NijboerZernike),
        (COMA, 33, {}, lm.ChordalGauss),
        (COMA, 33, {"integrate": True}, lm.NijboerZernike),
        (COMA, 100, {}, lm.NijboerZernike),
        (STACK, 100, {}, lm.ChordalGauss),
        (STACK, (20, 200), {}, lm.NijboerZernike),
        (lm.Pupil(vignetting=lm.Ellipse(0.9, 0.6)), 17, {}, lm.NonuniformFFT),
    ],
)
def test_every_pupil_and_window_goes_to_the_method_that_serves_it(pupil, shape, options, method):
    answer = lm.psf(pupil, shape, 0.5, **options)
    assert type(answer.method) is method
    assert lm.Plan(shape, 0.5, **options)(pupil).values.tobytes() == answer.values.tobytes()


def test_a_small_window_that_the_light_misses_goes_to_the_series():
    answer = lm.psf(TILTED, 17, 0.5, normalize="strehl")
    assert type(answer.method) is lm.NijboerZernike
    assert answer.values.max() < 1e-4
    with pytest.raises(ValueError, match="chords"):
        lm.psf(TILTED, 17, 0.5, method=lm.ChordalGauss())


def test_a_method_that_was_named_is_not_replaced():
    assert type(lm.psf(COMA, 33, 0.5, method=lm.NijboerZernike()).method) is lm.NijboerZernike


def test_both_methods_for_general_wavefronts_agree():
    series = lm.psf(COMA, 33, 0.5, method=lm.NijboerZernike(1e-9), dtype=np.float64)
    matrix = lm.psf(COMA, 33, 0.5, method=lm.ChordalGauss(1e-9), dtype=np.float64)
    assert lm.peak_error(series, matrix) <= series.error_bound + matrix.error_bound


def test_other_apertures_without_finufft_are_refused_with_what_to_do(monkeypatch):
    monkeypatch.setattr(choice, "find_spec", lambda _: None)
    with pytest.raises(ValueError, match="MatrixFourier"):
        lm.psf(lm.Pupil(spider=lm.Spider.equal(3, width=0.05)), 33, 0.5)
