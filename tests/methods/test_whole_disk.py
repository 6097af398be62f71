"""The spectral engine on pupils that are not radially symmetric, against direct quadrature over the aperture."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

import lommel as lm
from disk_quadrature import exact_intensity, exact_lattice
from lommel import _core
from lommel.methods import NijboerZernike
from lommel.optics.grid import Grid
from lommel.special import zernike

TERMS = [(n, m) for n in range(1, 9) for m in range(-n, n + 1, 2)]


def assert_within_bound(pupil: lm.Pupil, answer: lm.PSF, count: int = 12, seed: int = 0) -> None:
    """Compare random pixels, the brightest and the corners."""
    rng = np.random.default_rng(seed)
    height, width = answer.shape
    brightest = np.unravel_index(answer.values.argmax(), answer.shape)
    rows = np.array([*rng.integers(0, height, count), brightest[0], 0, height - 1])
    columns = np.array([*rng.integers(0, width, count), brightest[1], 0, width - 1])
    error = np.abs(answer.values[rows, columns] - exact_intensity(pupil, answer, rows, columns)).max()
    assert answer.error_bound is not None
    assert error / answer.values.max() <= answer.error_bound <= answer.method.tol


@pytest.mark.parametrize(
    "term", [(1, 1), (1, -1), (2, 2), (2, -2), (3, 1), (3, -1), (3, 3), (4, -4), (7, 5), (8, -8)]
)
@pytest.mark.parametrize("shape", [(17, 17), (16, 21)])
def test_a_single_term_of_either_sign_is_what_quadrature_says(term, shape):
    pupil = lm.Pupil(lm.Wavefront(nonradial={term: 2.5}))
    assert_within_bound(pupil, lm.psf(pupil, shape, 0.4, method=NijboerZernike(1e-9)))


@pytest.mark.parametrize("seed", range(200))
def test_two_hundred_random_sets_of_terms_up_to_degree_8_keep_the_contract(seed):
    rng = np.random.default_rng(seed)
    chosen = [TERMS[i] for i in rng.permutation(len(TERMS))[: rng.integers(1, 16)]]
    strength = rng.choice([0.2, 1.0, 3.0]) / np.sqrt(len(chosen))
    wavefront = lm.Wavefront.zernike({term: strength * rng.normal() for term in chosen}) + lm.Wavefront(
        rng.choice([0.0, 4.0]) * rng.normal()
    )
    pupil = lm.Pupil(
        wavefront,
        obscuration=float(rng.choice([0.0, 0.0, 0.3, 0.7])),
        apodization=float(rng.choice([0.0, 0.0, 1.5])),
    )
    tol = 10.0 ** -rng.uniform(3, 9)
    shape = (int(rng.integers(5, 60)), int(rng.integers(5, 60)))
    center = None if seed % 3 else (shape[0] * rng.random(), shape[1] * rng.random())
    answer = lm.psf(
        pupil, shape, float(rng.uniform(0.1, 1.0)), method=NijboerZernike(tol), dtype=np.float64, center=center
    )
    assert_within_bound(pupil, answer, seed=seed)


@pytest.mark.parametrize("digits", np.arange(3.0, 9.51, 0.125))
def test_the_tolerance_is_a_contract(digits):
    pupil = lm.Pupil(lm.Wavefront(3.0, 2.0, nonradial={(3, 1): 4.0, (2, -2): 3.0, (3, 3): 2.0}), obscuration=0.2)
    answer = lm.psf(pupil, 33, 0.5, method=NijboerZernike(10.0**-digits), dtype=np.float64)
    assert_within_bound(pupil, answer)


@given(st.floats(-60, 60), st.floats(-40, 40), st.sampled_from([0.0, 0.35, 0.8]), st.floats(0.1, 1.5))
@example(50.0, 0.0, 0.0, 0.5)
def test_a_term_too_small_to_matter_gives_what_the_radial_engine_gives(defocus, spherical, obscuration, pixel):
    radial = lm.Pupil(lm.Wavefront(defocus, spherical), obscuration=obscuration)
    general = lm.Pupil(lm.Wavefront(defocus, spherical, nonradial={(2, 2): 1e-14}), obscuration=obscuration)
    a = lm.psf(radial, (30, 41), pixel, dtype=np.float64)
    b = lm.psf(general, (30, 41), pixel, dtype=np.float64)
    assert lm.peak_error(b, a) <= a.error_bound + b.error_bound


def test_all_light_is_counted():
    pupil = lm.Pupil(lm.Wavefront(2.0, nonradial={(3, 1): 3.0}), obscuration=0.3)
    assert lm.psf(pupil, 801, 0.5).values.sum(dtype=np.float64) == pytest.approx(1.0, abs=3e-3)


@pytest.mark.parametrize("level", ["portable", "avx2"])
def test_other_instructions_give_the_same_to_rounding(level):
    pupil = lm.Pupil(lm.Wavefront(5.0, nonradial={(3, 1): 6.0, (2, -2): 4.0}), obscuration=0.3)
    widest = lm.psf(pupil, 120, 0.4, method="nijboer-zernike", dtype=np.float64)
    _core.limit_instructions(level)
    try:
        other = lm.psf(pupil, 120, 0.4, method="nijboer-zernike", dtype=np.float64)
    finally:
        _core.limit_instructions("avx512")
    # Dark parts are summed in single precision where there are such vectors, to fit in the tolerance.
    assert lm.peak_error(other, widest) <= 0.05 * widest.error_bound


@given(st.sampled_from(TERMS), st.floats(0.05, 1.0))
def test_terms_scale_to_smaller_disks_without_loss(term, radius):
    rho, theta = np.linspace(0, 1, 7), np.linspace(-3, 3, 7)
    parts = zernike.scaled({term: np.array(1.0)}, radius)
    total = sum(c * zernike.polynomial(*t, rho, theta) for t, c in parts.items())
    assert total == pytest.approx(zernike.polynomial(*term, radius * rho, theta), abs=1e-13)


def exact_averages(
    pupil: lm.Pupil, grid: Grid, pixels: list[tuple[int, int]], nodes: int = 14, rule: tuple[int, int] = (40, 160)
) -> np.ndarray:
    """Return I averaged over some pixels, (row, column) each, by Gauss nodes in each and direct sums for U."""
    x, w = np.polynomial.legendre.leggauss(nodes)
    found = []
    for row, column in pixels:
        down, across = (
            grid.step(pupil) * (at + 0.5 * x - c) for at, c in zip((row, column), grid.center, strict=True)
        )
        found.append(0.25 * w @ (np.abs(exact_lattice(pupil, across, down, *rule)) ** 2) @ w)
    return np.array(found)


@pytest.mark.parametrize("center", [(8.3, -4.2), (2.5, 2.5), (-7.0, 1.0)])
@pytest.mark.parametrize("normalize", ["strehl", "peak"])
@pytest.mark.parametrize("tol", [1e-3, 1e-6])
def test_averages_of_a_window_far_from_the_light_are_within_a_bound_related_to_the_peak(center, normalize, tol):
    pupil = lm.Pupil(lm.Wavefront(1.5, nonradial={(3, -1): 1.0, (2, 2): 0.6}), apodization=3.0)
    answer = lm.psf(
        pupil,
        (4, 3),
        1.1,
        center=center,
        integrate=True,
        normalize=normalize,
        method=NijboerZernike(tol),
        dtype=np.float64,
    )
    pixels = [(0, 0), (3, 2), (1, 1), tuple(map(int, np.unravel_index(answer.values.argmax(), answer.shape)))]
    found = np.array([answer.values[pixel] for pixel in pixels])
    error = np.abs(found - float(answer.scale) * exact_averages(pupil, answer.grid, pixels)).max()
    # A pixel around the axis is nearly the best placed one.
    best = float(answer.scale) * exact_averages(pupil, Grid(1, 1.1), [(0, 0)])[0]
    peak = answer.values.max() if normalize == "peak" else max(best, answer.values.max())
    assert error / peak <= answer.error_bound <= tol


@pytest.mark.parametrize("center", [(12.3, -4.2), (40.0, -12.0), (3000.0, 0.7)])
def test_averages_where_it_is_dark_relate_to_the_light_elsewhere(center):
    pupil = lm.Pupil(lm.Wavefront(0.5, nonradial={(3, -1): 0.3}), apodization=20.0)
    grid = Grid((4, 3), 1.1, center=center)
    answer = lm.psf(pupil, (4, 3), 1.1, center=center, integrate=True, dtype=np.float64, normalize="strehl")
    peak = exact_averages(pupil, Grid(1, 1.1), [(0, 0)])[0]
    if center[0] < 100.0:
        exact = float(answer.scale) * exact_averages(pupil, grid, [(0, 0), (3, 2)], rule=(80, 400))
        error = np.abs(answer.values[[0, 3], [0, 2]] - exact).max()
        assert error <= answer.error_bound * float(answer.scale) * peak
    assert answer.error_bound <= 1e-6
    assert answer.values.max() < 1e-6
    with pytest.raises(lm.ToleranceError, match="tol=1e-06 cannot be met"):
        lm.psf(pupil, (4, 3), 1.1, center=center, integrate=True, method=NijboerZernike(1e-6), normalize="peak")


def test_pixels_so_large_that_their_samples_miss_the_peak_are_averaged():
    pupil = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 2.0}))
    answer = lm.psf(pupil, 9, 5.0, integrate=True, method=NijboerZernike(1e-6), dtype=np.float64)
    exact = exact_averages(pupil, answer.grid, [(4, 4), (4, 5)], 40)
    found = answer.values[4, [4, 5]] / float(answer.scale)
    assert np.abs(found - exact).max() / exact.max() <= answer.error_bound <= 1e-6


@pytest.mark.parametrize("tol", [1e-3, 1e-8])
def test_a_window_of_pixels_that_all_miss_the_peak_can_be_divided_by_its_largest_value(tol):
    pupil = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 2.0}))
    answer = lm.psf(
        pupil, 5, 5.0, center=(2.49, 2.49), normalize="peak", method=NijboerZernike(tol), dtype=np.float64
    )
    rows, columns = (part.ravel() for part in np.indices(answer.shape))
    exact = exact_intensity(pupil, answer, rows, columns) / float(answer.scale)
    assert np.abs(answer.values.ravel() - exact / exact.max()).max() <= answer.error_bound <= tol


@pytest.mark.parametrize(
    ("method", "tol"),
    [(lm.methods.NijboerZernike, 1e-6), (lm.methods.NijboerZernike, 1e-9), (lm.methods.ChordalGauss, 1e-11)],
)
def test_radial_terms_of_high_degree_whose_powers_cancel_are_certified(method, tol):
    # R_20^0 has powers of rho of up to 1e6, which cancel to 1.
    wavefront = lm.Wavefront.zernike({(20, 0): 8.0, (3, 1): 1.0}, normalization="edge")
    pupil = lm.Pupil(wavefront, obscuration=0.2)
    assert_within_bound(pupil, lm.psf(pupil, 17, 0.4, method=method(tol), dtype=np.float64))
