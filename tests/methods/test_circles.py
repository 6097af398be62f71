"""Images of general wavefronts by interpolation between circles: docs/certificate.md 11."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import j0

import lommel as lm
from disk_quadrature import exact_intensity
from lommel import _core
from lommel.methods.nijboer_zernike import disk_stack, window_of
from lommel.optics.grid import Grid
from lommel.special.legendre import gauss_legendre

TERMS = [(1, -1), (2, 0), (2, 2), (2, -2), (3, 1), (3, -1), (3, 3), (3, -3), (4, 0), (5, 3), (6, -2)]
FINE = 1e-9


def circles(pupil: lm.Pupil, shape: int | tuple[int, int], pixel: float, **options) -> lm.PSF:
    """Return the PSF by interpolation between circles, in single precision unless `options` say otherwise."""
    given = {
        "dtype": np.float32,
        "threads": 1,
        **options,
        "method": lm.methods.NijboerZernike(options.get("tol", 1e-6)),
    }
    return lm.psf(pupil, shape, pixel, **given)


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
    answer = circles(pupil, shape, pixel, center=center, tol=tol)
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
        answer = circles(pupil, 140, 0.5, tol=2e-6, normalize=normalize)
    finally:
        _core.limit_instructions("avx512")
    error = np.abs(answer.values - fine.values).max() / fine.values.max()
    assert error <= answer.error_bound + FINE
    assert answer.error_bound <= 2e-6
    assert answer.scale == pytest.approx(float(fine.scale), rel=4e-6)


def test_bits_depend_on_no_threads_and_on_no_tables_that_are_kept():
    # An obscuration that no other test has: its tables are made here.
    pupil = coma(6.0, obscuration=0.21351)
    first = circles(pupil, 320, 0.5)
    circles(coma(12.0, obscuration=0.21351), 460, 1.0)
    for threads in (1, 2, 3):
        again = circles(pupil, 320, 0.5, threads=threads)
        np.testing.assert_array_equal(first.values, again.values)
        assert first.error_bound == again.error_bound


@pytest.mark.parametrize("tol", [1e-3, 1e-6])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_errors_in_a_dim_window_are_relative_to_the_peak_outside(tol, dtype):
    pupil = coma(4.0)
    answer = circles(pupil, (30, 40), 0.5, center=(-300.0, 50.0), tol=tol, dtype=dtype, normalize="strehl")
    peak = lm.psf(pupil, 65, 0.25, normalize="strehl").values.max()
    chords = {
        "center": (-300.0, 50.0),
        "method": lm.methods.ChordalGauss(1e-4),
        "dtype": np.float64,
        "normalize": "strehl",
    }
    exact = lm.psf(pupil, (30, 40), 0.5, **chords).values
    assert exact.max() < 1e-4 * peak
    assert np.abs(answer.values - exact).max() <= answer.error_bound * peak + 1e-4 * exact.max()
    assert answer.error_bound <= tol


@pytest.mark.parametrize("factor", [1e-30, 1e30])
def test_values_beyond_the_range_of_single_precision_are_scaled_after_they_are_summed(factor):
    stack, window, numbers = disk_stack(coma(2.0)), window_of(coma(2.0), Grid(9, 0.5)), np.empty((3, 1))
    plain, scaled = np.empty((1, 9, 9), np.float32), np.empty((1, 9, 9), np.float32)
    assert _core.series_images(stack, window, (1e-6, 1, 1.0), plain, numbers) == 0.0
    assert _core.series_images(stack, window, (1e-6, 1, factor), scaled, numbers) == 0.0
    np.testing.assert_allclose(scaled, factor * plain.astype(float), rtol=2e-7)
    assert numbers[1, 0] <= 1e-6


@pytest.mark.parametrize(("obscuration", "pixel"), [(0.0, 0.5), (0.3, 1.2)])
def test_it_serves_double_precision_to_its_limit(obscuration, pixel):
    pupil = coma(8.0, obscuration=obscuration)
    reference = lm.psf(pupil, 128, pixel, tol=5e-11, dtype=np.float64, method=lm.methods.ChordalGauss(5e-11))
    exact, scale = reference.values, reference.values.max()
    bounds = []
    for tol in (3e-8, 1e-8, 3e-9, 1e-9):
        answer = circles(pupil, 128, pixel, tol=tol, dtype=np.float64)
        assert np.abs(answer.values - exact).max() <= (answer.error_bound + reference.error_bound) * scale
        assert answer.error_bound <= tol
        bounds.append(answer.error_bound)
    assert bounds == sorted(bounds, reverse=True)  # by more taps, ten to fourteen
    with pytest.raises(
        lm.ToleranceError, match=r"tol=1e-11 cannot be met .*; give tol=.*e-10 or method=ChordalGauss\(1e-11\)"
    ):
        circles(pupil, 128, pixel, tol=1e-11, dtype=np.float64)


def test_it_serves_all_tolerances_that_single_precision_holds():
    answer = circles(coma(8.0), 128, 0.5, tol=2.5e-7)
    assert answer.error_bound <= 2.5e-7
    exact = lm.psf(coma(8.0), 128, 0.5, tol=1e-10, dtype=np.float64).values
    assert np.abs(answer.values - exact).max() <= answer.error_bound * exact.max()


def test_far_pixels_are_right_where_circles_up_to_them_are_too_many():
    """With coma alone the integral over angles is a Bessel function, which leaves the one over radii."""
    size, center = 2.0, (-30_000.0, 7_000.0)
    pupil = lm.Pupil(lm.Wavefront(1.5, nonradial={(3, 1): size}), obscuration=0.3)
    answer = circles(pupil, 3, 0.5, center=center, tol=1e-3, dtype=np.float64, normalize="strehl")
    nodes, weights = gauss_legendre(24, 0.0, 1.0)
    edges = np.linspace(0.3, 1.0, 5001)
    rho = (edges[:-1, None] + np.diff(edges)[:, None] * nodes).ravel()
    weight = (np.diff(edges)[:, None] * weights).ravel() * 2.0 * rho * np.exp(1.5j * rho**2)
    v = 0.5 * np.pi
    for row, column in ((0, 0), (1, 2), (2, 1)):
        x, y = v * (column - center[1]), v * (row - center[0])
        exact = abs(weight @ j0(np.hypot(size * (3 * rho**3 - 2 * rho) - x * rho, y * rho))) ** 2
        assert answer.values[row, column] / answer.scale == pytest.approx(exact, rel=1e-3)
    assert answer.error_bound <= 1e-3


@pytest.mark.quick
@pytest.mark.parametrize("center", [(0.0, 0.0), (0.3, -0.2), (-7.0, 3.0), (-40.5, 12.0)])
def test_one_pixel_has_circles_of_its_own(center):
    pupil = coma(3.0, obscuration=0.2)
    answer = circles(pupil, 1, 0.5, center=center, tol=1e-8, dtype=np.float64, normalize="strehl")
    method = lm.methods.ChordalGauss(1e-9)
    chords = lm.psf(pupil, 1, 0.5, center=center, method=method, dtype=np.float64, normalize="strehl")
    peak = lm.psf(pupil, 65, 0.25, normalize="strehl").values.max()
    assert abs(answer.values - chords.values).max() <= (answer.error_bound + 1e-9) * peak
