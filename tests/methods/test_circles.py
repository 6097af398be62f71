"""Large windows of general wavefronts, interpolated between circles: docs/certificate.md 11."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from disk_quadrature import exact_intensity
from lommel import _core

TERMS = [(1, -1), (2, 0), (2, 2), (2, -2), (3, 1), (3, -1), (3, 3), (3, -3), (4, 0), (5, 3), (6, -2)]
FINE = 1e-9


@pytest.fixture(autouse=True)
def where_it_pays():
    yield
    _core.interpolation_worth(1.0)


def both_ways(pupil: lm.Pupil, shape: tuple[int, int], pixel: float, **options) -> tuple[lm.PSF, lm.PSF]:
    """Return the PSF as interpolation, wherever it succeeds, and the series alone make it, in single precision."""
    answers = []
    for share in (1e300, 0.0):
        _core.interpolation_worth(share)
        series = lm.methods.NijboerZernike(options.get("tol", 1e-6))
        given = {"dtype": np.float32, "threads": 1, **options, "method": series}
        answers.append(lm.psf(pupil, shape, pixel, **given))
    _core.interpolation_worth(1.0)
    return answers[0], answers[1]


def random_pupil(rng: np.random.Generator, size: float) -> lm.Pupil:
    parts = rng.uniform(-1.0, 1.0, len(TERMS)) * (rng.random(len(TERMS)) < 0.6)
    parts[4] += 0.3
    parts *= size / np.abs(parts).sum()
    return lm.Pupil(
        lm.Wavefront(
            nonradial={term: float(c) for term, c in zip(TERMS, parts, strict=True) if term[1] != 0},
            defocus=float(2.0 * parts[1]),
        ),
        obscuration=float(rng.choice([0.0, 0.0, 0.3, 0.62])),
        apodization=float(rng.choice([0.0, 0.0, 1.5])),
    )


@pytest.mark.parametrize(
    ("seed", "least", "most"), [*((k, -6.0, -4.0) for k in range(8)), *((k, -4.0, -1.0) for k in range(8, 16))]
)
def test_errors_stay_below_the_bound_and_the_bound_below_the_tolerance(seed, least, most):
    rng = np.random.default_rng(seed)
    pupil = random_pupil(rng, float(rng.uniform(5.0, 30.0)))
    shape = (int(rng.integers(128, 257)), int(rng.integers(128, 257)))
    center = (0.5 * shape[0] + rng.uniform(-40.0, 40.0), 0.5 * shape[1] + rng.uniform(-40.0, 40.0))
    pixel, tol = float(rng.choice([0.25, 0.5, 1.0])), float(10.0 ** rng.uniform(least, most))
    answer, series = both_ways(pupil, shape, pixel, center=center, tol=tol)
    assert not np.array_equal(answer.values, series.values)  # else it was the series that answered
    fine = lm.psf(pupil, shape, pixel, center=center, tol=FINE, dtype=np.float64)
    assert answer.scale == fine.scale
    peak = float(fine.values.max())
    error = float(np.abs(answer.values - fine.values).max()) / peak
    assert error <= answer.error_bound + FINE
    assert answer.error_bound <= tol
    rows, columns = rng.integers(0, shape[0], 20), rng.integers(0, shape[1], 20)
    rows[0], columns[0] = np.unravel_index(fine.values.argmax(), shape)
    exact = exact_intensity(pupil, answer, rows, columns)
    assert np.abs(answer.values[rows, columns] - exact).max() <= (answer.error_bound + 1e-12) * peak


def coma(size: float, **options) -> lm.Pupil:
    return lm.Pupil(lm.Wavefront(size, nonradial={(3, 1): size, (2, -2): 0.7 * size}), **options)


@pytest.mark.parametrize("normalize", ["energy", "strehl", "peak"])
@pytest.mark.parametrize("level", ["avx512", "avx2", "portable"])
def test_every_instruction_set_and_normalization_keeps_the_bound(level, normalize):
    pupil = coma(9.0, obscuration=0.25)
    fine = lm.psf(pupil, 140, 0.5, tol=FINE, dtype=np.float64, normalize=normalize)
    _core.limit_instructions(level)
    try:
        answer, series = both_ways(pupil, (140, 140), 0.5, tol=2e-6, normalize=normalize)
    finally:
        _core.limit_instructions("avx512")
    assert not np.array_equal(answer.values, series.values)
    error = np.abs(answer.values - fine.values).max() / fine.values.max()
    assert error <= answer.error_bound + FINE
    assert answer.error_bound <= 2e-6
    assert answer.scale == pytest.approx(float(series.scale), rel=4e-6)


def test_bits_depend_on_no_threads_and_on_no_tables_that_are_kept():
    # An obscuration that no other test has: its tables are made here.
    pupil = coma(6.0, obscuration=0.21351)
    first, series = both_ways(pupil, (320, 320), 0.5)
    assert not np.array_equal(first.values, series.values)
    both_ways(coma(12.0, obscuration=0.21351), (460, 460), 1.0)
    for threads in (1, 2, 3):
        again, _ = both_ways(pupil, (320, 320), 0.5, threads=threads)
        np.testing.assert_array_equal(first.values, again.values)
        assert first.error_bound == again.error_bound


def test_where_it_does_not_prove_its_tolerance_the_series_answers():
    # All is dim there, beside what the expansion is off by.
    answer, series = both_ways(coma(4.0), (100, 100), 0.5, center=(-300.0, 50.0))
    np.testing.assert_array_equal(answer.values, series.values)
    assert answer.error_bound == series.error_bound


@pytest.mark.parametrize(("obscuration", "pixel"), [(0.0, 0.5), (0.3, 1.2)])
def test_it_serves_double_precision_to_its_limit(obscuration, pixel):
    pupil = coma(8.0, obscuration=obscuration)
    reference = lm.psf(pupil, 128, pixel, tol=5e-11, dtype=np.float64, method=lm.methods.ChordalGauss(5e-11))
    exact, scale = reference.values, reference.values.max()
    bounds = []
    for tol in (3e-8, 1e-8, 3e-9, 1e-9, 1e-10):
        answer, series = both_ways(pupil, (128, 128), pixel, tol=tol, dtype=np.float64)
        assert np.abs(answer.values - exact).max() <= (answer.error_bound + reference.error_bound) * scale
        assert answer.error_bound <= tol
        assert np.array_equal(answer.values, series.values) == (tol == 1e-10)
        bounds.append(answer.error_bound)
    assert bounds == sorted(bounds, reverse=True)  # by more taps, ten to fourteen


def test_it_serves_all_tolerances_that_single_precision_holds():
    answer, series = both_ways(coma(8.0), (128, 128), 0.5, tol=2.5e-7)
    assert not np.array_equal(answer.values, series.values)
    assert answer.error_bound <= 2.5e-7
    exact = lm.psf(coma(8.0), 128, 0.5, tol=1e-10, dtype=np.float64).values
    assert np.abs(answer.values - exact).max() <= answer.error_bound * exact.max()


def test_it_is_tried_where_it_is_predicted_to_be_faster():
    used = {}
    for size in (0.5, 10.0):
        answer, series = both_ways(coma(size), (256, 256), 0.5)
        chosen = lm.psf(coma(size), 256, 0.5, method="nijboer-zernike", dtype=np.float32, threads=1).values
        assert not np.array_equal(answer.values, series.values)
        used[size] = np.array_equal(chosen, answer.values)
        assert used[size] or np.array_equal(chosen, series.values)
    assert used == {0.5: False, 10.0: True}
