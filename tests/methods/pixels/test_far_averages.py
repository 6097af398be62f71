"""Averages over pixels far from the axis of pupils of any wavefront, without samples: docs/certificate.md 10."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from disk_quadrature import exact_lattice
from lommel.core.engine import FarPixels, far_averages
from lommel.methods import averaging, nijboer_zernike
from lommel.methods.nijboer_zernike import disk_stack, window_of
from lommel.optics.grid import Grid


def random_pupil(rng: np.random.Generator, size: float, *, tilt: float = 0.0) -> lm.Pupil:
    terms = {(n, m): size * rng.normal() for n in range(2, 5) for m in range(-n, n + 1, 2)}
    terms |= {(1, 1): tilt * rng.normal(), (1, -1): tilt * rng.normal()}
    obscuration = rng.choice([0.0, 0.0, 0.2, 0.45])
    return lm.Pupil(lm.Wavefront.zernike(terms), obscuration=obscuration, apodization=rng.choice([0.0, 0.0, 0.8]))


def far(pupil: lm.Pupil, grid: Grid, tol: float) -> FarPixels:
    return far_averages(disk_stack(pupil), window_of(pupil, grid), 1e6, tol, 1)


def exact_average(pupil: lm.Pupil, grid: Grid, row: int, column: int) -> float:
    """Return the average of the intensity over a pixel by Gauss's rule, of direct sums over the pupil."""
    step = grid.step(pupil)
    x, w = np.polynomial.legendre.leggauss(int(0.7 * step) + 12)
    vx = step * (column - grid.center[1] + 0.5 * x)
    vy = step * (row - grid.center[0] + 0.5 * x)
    turns = math.hypot(np.abs(vx).max(), np.abs(vy).max()) + np.abs(pupil.wavefront.edge).sum() * 4.0
    field = exact_lattice(pupil, vx, vy, int(0.45 * turns) + 30, int(1.1 * turns) + 60)
    return float(0.25 * w @ np.abs(field) ** 2 @ w)


def exact_light(pupil: lm.Pupil, answer: lm.PSF, row: int, column: int) -> float:
    return exact_average(pupil, answer.grid, row, column) * float(answer.scale)


@pytest.mark.parametrize("seed", range(24))
def test_averages_far_from_the_axis_are_within_their_bound(seed):
    rng = np.random.default_rng(seed)
    pupil = random_pupil(rng, 10.0 ** rng.uniform(-2.0, -0.8), tilt=(0.0, 2.0)[seed % 2])
    tol, pixel = 10.0 ** rng.uniform(-5.5, -3), 10.0 ** rng.uniform(0.0, 0.9)
    step = math.pi * pixel
    side = int(min(400, 2 * 450 / step)) + 1
    center = (side / 2 - 0.5, side / 2) if seed % 3 else (rng.uniform(-0.2, 0.3) * side, rng.uniform(0, 1) * side)
    grid = Grid((side, side + 3), pixel, center=center, integrate=True)
    found = far(pupil, grid, tol)
    values = found.values[0]
    rows, columns = np.indices(values.shape)
    away = np.hypot(rows - found.axes[0, 0], columns - found.axes[0, 1])
    there = away >= found.nearest[0] * (1.0 + 1e-12)
    assert there.any()
    assert not values[away < found.nearest[0] * (1.0 - 1e-12)].any()
    # The nearest one, on an axis of the pixels and anywhere, and some others.
    nearest = np.argmin(np.where(there, away, np.inf))
    on_axis = np.argmin(np.where(there, away + 100.0 * np.abs(rows - round(found.axes[0, 0])), np.inf))
    for place in (nearest, on_axis, *rng.choice(np.flatnonzero(there), 2)):
        row, column = np.unravel_index(place, values.shape)
        if math.hypot(row - grid.center[0], column - grid.center[1]) * step > 700.0:
            continue
        exact = exact_average(pupil, grid, int(row), int(column))
        assert abs(values[row, column] - exact) <= found.error[0] + 1e-15
        # Half of it at least is there, where it is no less than what rings may be.
        assert values[row, column] == pytest.approx(exact, rel=0.5, abs=found.error[0])


def test_the_error_is_mostly_that_of_rings_as_they_cross_edges():
    # Along an axis of the pixels the bound on what two opposite edges leave is reached, but for the square root of 2,
    # that between points where waves are looked at, and where the phase of the rings happens to be.
    pupil = lm.Pupil(lm.Wavefront.zernike({(3, 1): 0.001}))
    grid = Grid((1, 161), 3.3, center=(0.0, 0.0), integrate=True)
    found = far(pupil, grid, 3e-8)
    first = math.ceil(found.nearest[0])
    off = [abs(found.values[0, 0, k] - exact_average(pupil, grid, 0, k)) for k in range(first, first + 4)]
    assert 0.25 * found.error[0] < max(off) <= found.error[0]


def test_a_mirrored_pupil_has_a_mirrored_image():
    grid = Grid((61, 71), 4.0, center=(30.0, 35.0), integrate=True)
    terms = {(2, -2): 0.2, (3, 1): 0.3, (3, -1): -0.2, (4, -2): 0.1}
    plain = far(lm.Pupil(lm.Wavefront.zernike(terms)), grid, 1e-5).values[0]
    flipped = lm.Wavefront.zernike({(n, m): math.copysign(c, c * m) for (n, m), c in terms.items()})
    mirrored = far(lm.Pupil(flipped), grid, 1e-5).values[0]
    assert plain.any()
    np.testing.assert_allclose(mirrored[::-1], plain, rtol=1e-9)
    assert np.abs(plain[::-1] / np.where(plain, plain, 1.0) - 1.0).max() > 1e-4


def test_the_side_with_more_of_the_light_far_away_is_that_of_samples(without_far):
    pupil = random_pupil(np.random.default_rng(5), 0.3)
    grid = Grid(161, 4.0, center=(80.0, 80.0), integrate=True)
    found = far(pupil, grid, 1e-5).values[0]
    fine = without_far(pupil, 161, 4.0, integrate=True, center=(80.0, 80.0), dtype=np.float64, tol=1e-8)
    exact = np.where(found, fine.values / fine.scale, 0.0)
    sides = [values[81:].sum() - values[:80].sum() for values in (found, exact)]
    assert sides[0] == pytest.approx(sides[1], rel=0.02)


@pytest.fixture
def without_far(monkeypatch):
    """Return a function that computes a PSF by samples all over."""

    def psf(*args, **options):
        with monkeypatch.context() as patch:
            patch.setattr(averaging, "largest_far_start", lambda *_: 0.0)
            return lm.psf(*args, **options)

    return psf


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("normalize", ["energy", "peak"])
@pytest.mark.parametrize(("tol", "pixel"), [(1e-3, 2.5), (1e-5, 4.0), (1e-6, 3.0), (3e-7, 8.0)])
def test_both_parts_of_a_window_are_within_the_bound(without_far, dtype, normalize, tol, pixel):
    rng = np.random.default_rng(int(10 * pixel))
    pupil = random_pupil(rng, 0.3, tilt=3.0)
    shape, options = (150, 170), {"integrate": True, "normalize": normalize, "center": (60.3, 80.0)}
    answer = lm.psf(pupil, shape, pixel, tol=tol, dtype=dtype, **options)
    finest = 8e-8 if (normalize, pixel) == ("peak", 8.0) else 2e-8  # averages over the largest pixels end there
    fine = without_far(pupil, shape, pixel, tol=finest, dtype=np.float64, **options)
    peak = fine.values.max()
    # What no sample was taken for is not what the filter makes of samples, to the last digit.
    assert (np.abs(answer.values / fine.values - 1.0) > 1e-9).any()
    assert np.abs(answer.values - fine.values).max() <= (answer.error_bound + finest) * peak
    assert answer.error_bound <= tol
    if normalize == "energy":
        far_pixels = without_far(pupil, shape, pixel, tol=tol, dtype=dtype, **options).values != answer.values
        border = np.argwhere(far_pixels & ~np.roll(far_pixels, 1, axis=1))[:2]
        for row, column in [(60, 80), (63, 79), *border, *(border - [0, 1])]:
            if math.hypot(row - 60.3, column - 80.0) * pixel > 200.0:
                continue
            exact = exact_light(pupil, answer, int(row), int(column))
            assert abs(answer.values[row, column] - exact) <= 1.001 * answer.error_bound * peak + 6e-8 * exact


def test_pupils_of_a_stack_have_axes_of_their_own(without_far):
    tilts = np.array([0.0, 40.0, -25.0])
    pupils = lm.Pupil(lm.Wavefront.zernike({(1, 1): tilts, (3, 1): 0.2, (2, 2): [0.1, 0.5, 0.3]}), obscuration=0.2)
    for center in (None, (np.array([64.0, 60.2, 70.0]), np.array([60.0, 64.0, 75.5]))):
        options = {"integrate": True, "center": center, "dtype": np.float64}
        answer = lm.psf(pupils, 140, 4.0, tol=1e-5, **options)
        fine = without_far(pupils, 140, 4.0, tol=1e-7, **options)
        assert (np.abs(answer.values / fine.values - 1.0) > 1e-5).any(axis=(1, 2)).all()
        for one, other in zip(answer.values, fine.values, strict=True):
            assert np.abs(one - other).max() <= (float(answer.error_bound) + 1e-7) * other.max()


def test_windows_beside_the_light_take_samples(without_far):
    pupil = random_pupil(np.random.default_rng(3), 0.2)
    options = {"integrate": True, "center": (-200.0, 40.0), "dtype": np.float64}
    answer = lm.psf(pupil, 128, 4.0, tol=1e-4, **options)
    np.testing.assert_array_equal(answer.values, without_far(pupil, 128, 4.0, tol=1e-4, **options).values)


def test_where_too_few_samples_are_spared_there_are_samples():
    assert averaging.largest_far_start(math.pi, (129, 129)) == 0.0
    assert averaging.largest_far_start(4.0 * math.pi, (33, 33)) == 0.0
    most = averaging.largest_far_start(4.0 * math.pi, (129, 129))
    inside = (2.0 * most / (4.0 * math.pi)) ** 2
    assert (129**2 - inside) * (4.0 * math.pi / 1.27) ** 2 == pytest.approx(250000)
    # A narrow window's box is as long as that leaves room for.
    most = averaging.largest_far_start(4.0 * math.pi, (9, 2000))
    assert (9 * 2000 - 9 * 2.0 * most / (4.0 * math.pi)) * (4.0 * math.pi / 1.27) ** 2 == pytest.approx(250000)
    pupil = lm.Pupil(lm.Wavefront.zernike({(3, 1): 0.1}))
    grid = Grid(129, 4.0, integrate=True)
    found = far_averages(disk_stack(pupil), window_of(pupil, grid), 50.0, 1e-6, 1)
    assert not found.values.any()
    assert found.nearest[0] > 64.0 * math.sqrt(2.0)


def test_where_many_samples_are_near_the_axis_the_chordal_rule_is_not_asked_first(monkeypatch):
    asked = []
    monkeypatch.setattr(
        nijboer_zernike,
        "far_averages",
        lambda stack, *args: asked.append(len(stack.edge)) or far_averages(stack, *args),
    )
    pupil = lm.Pupil(lm.Wavefront.zernike({(3, 1): 0.1}))
    assert lm.psf(pupil, 129, 4.0, integrate=True, tol=1e-6).method == lm.methods.NijboerZernike(1e-6)
    assert asked == [1]
    assert lm.psf(pupil, 129, 4.0, integrate=True, tol=1e-3).method == lm.methods.ChordalGauss(1e-3)
    # Nowhere nearer than it is likely.
    grid = Grid(129, 4.0, integrate=True)
    for tol in (1e-4, 1e-6):
        assert averaging.estimate_far_start(pupil, grid, tol) < 4.0 * math.pi * far(pupil, grid, tol).nearest[0]
    assert averaging.estimate_far_start(pupil, grid, 1e-6) == pytest.approx(
        10.0 ** (1 / 3) * averaging.estimate_far_start(pupil, grid, 1e-5)
    )
    assert averaging.estimate_far_start(pupil, Grid(33, 4.0, integrate=True), 1e-6) == 0.0


def test_windows_of_more_samples_than_an_image_may_have_are_averaged():
    pupil = lm.Pupil(
        lm.Wavefront.zernike({(3, 1): 0.5}, unit="waves", normalization="edge"), wavelength=550e-9, f_number=4.0
    )
    made = lm.psf(pupil, 512, 50e-6)  # 29000 samples across
    assert made.error_bound <= 1e-6
    few = lm.psf(pupil, 5, 50e-6, tol=1e-8, dtype=np.float64)
    assert np.abs(made.values[254:259, 254:259] - few.values).max() <= made.error_bound * few.values.max() + 1e-8
