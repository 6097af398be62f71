"""Light beyond windows, kernels between mirrors, and borders."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

import lommel as lm
from lommel.deconvolve.linear import folded, without_copies
from lommel.imaging.bank import (
    Bank,
    MirroredKernels,
    Remainder,
    build_bank,
    inner_energy,
    reach_of,
    smooth_transforms,
)
from lommel.imaging.sensor_light import SensorLight, pixel_factors

PIXEL = 6e-6
PUPIL = lm.Pupil(wavelength=540e-9, f_number=8.0)


def bank(low: float = -4.0, high: float = 1.0, tol: float = 1e-4, **more: object) -> Bank:
    given = {"tol": tol, "energy": 1.0, "largest": 60, "dtype": np.float64} | more
    return build_bank(SensorLight(PUPIL, lm.Wavefront, ((540e-9, 1.0),), PIXEL), (low, high), **given)


def whole(made: Bank, defocus: float, half: int) -> np.ndarray:
    """What a bank says of a point, on a window of this half."""
    values = np.tensordot(made.remainder.factors(made.positions(defocus)), made.remainder.values(half), axes=1)
    away = np.abs(np.arange(-half, half + 1))
    kernel = values[away[:, None], away]
    inside = slice(half - made.half, half + made.half + 1)
    kernel[inside, inside] += made.window(defocus)
    return kernel


@pytest.mark.parametrize("tol", [1e-3, 1e-5])
def test_windows_and_remainder_are_the_psf_wherever_the_two_meet(tol):
    made = bank(tol=tol)
    for defocus in np.random.default_rng(0).uniform(-4.0, 1.0, 6):
        pupil = lm.Pupil(lm.Wavefront(defocus), wavelength=540e-9, f_number=8.0)
        true = lm.psf(
            pupil, 161, PIXEL, integrate=True, method=lm.methods.NijboerZernike(1e-9), dtype=np.float64
        ).values
        off = whole(made, defocus, 80) - true
        position = made.positions(defocus)
        assert np.abs(off).sum() <= made.remainder.error(position) <= made.remainder.error()
        # Of a smaller image less counts, and that is what it says: within ten times.
        for side in (9, 30, 81):
            part = slice(80 - (side - 1), 80 + side)
            bound = made.remainder.error(position, (side, side))
            assert np.abs(off[part, part]).sum() <= bound <= 10.0 * np.abs(off[part, part]).sum()
        assert np.abs(off).max() <= tol * true.max()


def test_all_of_the_light_is_held():
    made = bank()
    # Transforms at the frequency 0 are sums over all pixels.
    sums = MirroredKernels(made.remainder, (8, 8), "reflect", np.dtype(np.float64), 1e-4).eigenvalues[:, 0, 0]
    for defocus in (-4.0, -1.3, 0.0, 0.9):
        factors = made.remainder.factors(made.positions(defocus))
        assert made.window(defocus).sum() + factors @ sums == pytest.approx(1.0, abs=1e-8)
    # The sums are those of values on pixels for ever: beyond h they fall as 1 / h.
    found = []
    for half in (200, 400):
        once = np.where(np.arange(half + 1) == 0, 1.0, 2.0)
        found.append(np.einsum("rij,i,j->r", made.remainder.values(half), once, once))
    # Richardson's extrapolation, of squares of 2 h + 1 pixels.
    limit = (801 * found[1] - 401 * found[0]) / 400
    np.testing.assert_allclose(limit, sums, rtol=1e-4)


def test_far_away_there_is_what_a_round_aperture_diffracts():
    """Beyond v in focus there are ``J_0(v)^2 + J_1(v)^2`` of the light, 2 / (pi v) in the mean."""
    made = bank(0.0, 0.0)
    factor = made.remainder.factors(made.positions(0.0)) @ made.remainder.smooth[:, 0]
    # Light beyond r is 2 pi a / r for a / r^3 a pixel; v is pi r PIXEL / (lambda N).
    assert 2.0 * math.pi * factor == pytest.approx(2.0 * 540e-9 * 8.0 / (math.pi**2 * PIXEL), rel=5e-3)


def test_one_distance_takes_one_product_and_a_smaller_tolerance_more():
    assert len(bank(2.0, 2.0).remainder.table) == 1
    ranks = [len(bank(tol=tol).remainder.table) for tol in (1e-2, 1e-4, 1e-6)]
    assert ranks == sorted(ranks)
    assert ranks[0] < ranks[-1] <= 6


def test_factors_go_through_the_windows_and_their_slopes_are_theirs():
    made = bank(tol=1e-5)
    remainder = made.remainder
    np.testing.assert_allclose(remainder.factors(np.arange(made.count)).T, remainder.knots, atol=1e-14)
    at = np.random.default_rng(1).uniform(1.0, made.count - 2.0, (4, 5))
    assert remainder.factors(at, np.float32).shape == (len(remainder.table), 4, 5)
    assert remainder.factors(at, np.float32).dtype == np.float32
    step = 1e-3
    difference = (remainder.factors(at + step) - remainder.factors(at - step)) / (2.0 * step)
    scale = np.abs(remainder.factors(np.linspace(1.0, made.count - 2.0, 500), slopes=True)).max()
    assert np.abs(remainder.factors(at, slopes=True) - difference).max() <= 0.02 * scale
    assert np.abs(difference).max() > 0.1 * scale
    # A position beyond the windows is one at their end.
    np.testing.assert_array_equal(remainder.factors(-1.0), remainder.factors(0.0))


def test_smooth_parts_have_the_transforms_that_sums_over_pixels_have():
    scale, away = 3.0, np.arange(-300, 301)
    squared = away[:, None] ** 2 + away**2 + scale**2
    for frequency in (0.07, 0.21):
        wave = np.cos(2.0 * np.pi * frequency * away)
        sums = [(wave @ (scale ** (2 * j) * squared ** (-1.5 - j))).sum() for j in range(3)]
        np.testing.assert_allclose(smooth_transforms(np.array([frequency]), scale)[:, 0], sums, atol=2e-4, rtol=0)
    assert smooth_transforms(np.zeros(1), scale)[0, 0] == pytest.approx(2.0 * math.pi / scale)


def test_windows_end_where_the_tail_is_smooth_and_fine_pixels_are_known_farther_away():
    energies = [inner_energy(step) for step in (1.0, 4.0, 10.0, 20.0, 100.0)]
    assert energies == sorted(energies)
    assert (energies[0], energies[-1]) == (0.98, 0.9975)
    assert [reach_of(4, step) for step in (0.5, 4.4, 30.0, 200.0)] == [96, 71, 19, 12]
    assert reach_of(200, 1.0) == 306


def test_windows_hold_less_than_without_a_remainder_and_are_divided_by_nothing():
    made = bank()
    assert np.all(made.energies == 1.0)
    assert made.lost == 0.0
    assert 0.0 < made.window(0.5).sum() < 0.98
    within = made.windows + made.remainder_windows
    pupil = lm.Pupil(lm.Wavefront(made.start), wavelength=540e-9, f_number=8.0)
    true = lm.psf(pupil, 2 * made.half + 1, PIXEL, integrate=True, dtype=np.float64).values
    kept = pixel_factors(made.cuts, made.half)[0] * true[made.half :, made.half :]
    np.testing.assert_allclose(within[0, : made.half + 1, : made.half + 1], kept, atol=2e-6 * true.max())


@pytest.mark.parametrize("shape", [(80, 80), (45, 200), (20, 90), (1, 150), (130, 400)])
def test_of_the_rings_an_image_has_what_falls_as_the_cube_within_its_sides(shape):
    remainder = bank().remainder
    reach = remainder.table.shape[1] - 1
    assert max(shape) - 1 > reach
    row, column = np.mgrid[: shape[0], : shape[1]]
    many = np.where(row == 0, 1, 2) * np.where(column == 0, 1, 2) * (np.maximum(row, column) > reach)
    inside = (many / np.maximum(np.hypot(row, column), 1.0) ** 3).sum()
    everywhere = 4.0 * math.sqrt(2.0) / (reach + 0.5)  # the integral outside of the square that is known
    near = replace(remainder, ring_error=0.0).error(shape=shape)
    assert remainder.error(shape=shape) - near == pytest.approx(remainder.ring_error * inside / everywhere, rel=0.05)
    known = (reach + 1, reach + 1)
    assert remainder.error(shape=known) == replace(remainder, ring_error=1.0, tail_error=1.0).error(shape=known)


@pytest.fixture(scope="module")
def remainder() -> Remainder:
    """That of a small lens over some radians."""
    pupil = lm.Pupil(wavelength=540e-9, f_number=8.0)
    given = {"tol": 1e-4, "energy": 1.0, "largest": 60}
    made = build_bank(SensorLight(pupil, lm.Wavefront, ((540e-9, 1.0),), 6e-6), (-4.0, 1.0), **given).remainder
    assert made is not None
    return made


@pytest.mark.parametrize("shape", [(6, 9), (7, 7), (1, 5), (1, 1), (13, 2)])
def test_a_kernel_acts_on_an_image_between_mirrors_that_are_mirrored_without_end(remainder, shape):
    kernels = MirroredKernels(remainder, shape, "reflect", np.dtype(np.float64), 1e-4)
    assert kernels.error == 0.0
    image = np.random.default_rng(0).random(shape)
    half = 160
    away = np.abs(np.arange(-half, half + 1))
    endless = np.pad(image, half, mode="symmetric")
    for r, quarter in enumerate(remainder.values(half)):
        kernel = quarter[away[:, None], away]
        made = kernels.image(kernels.transformed(r, image.copy()))
        # So far away the mirrored image is as bright as it is in the mean.
        rest = (kernels.eigenvalues[r, 0, 0] - kernel.sum()) * image.mean()
        wanted = np.array(
            [
                [(endless[y : y + 2 * half + 1, x : x + 2 * half + 1] * kernel).sum() + rest for x in range(shape[1])]
                for y in range(shape[0])
            ]
        )
        assert np.abs(made - wanted).max() <= 1e-4 * np.abs(wanted).max()


@pytest.mark.parametrize("border", ["reflect", "extend", "zero"])
def test_what_is_taken_is_the_transpose_of_what_is_spread(remainder, border):
    rng = np.random.default_rng(1)
    kernels = MirroredKernels(remainder, (6, 9), border, np.dtype(np.float64), 1e-4)
    a, b = rng.standard_normal((2, 6, 9))
    for r in range(len(remainder.table)):
        spread = kernels.image(kernels.transformed(r, a.copy()))
        taken = kernels.transposed(r, kernels.padded_transform(b))
        assert np.vdot(spread, b) == pytest.approx(np.vdot(a, taken), rel=1e-12)


def test_darkness_is_as_wide_as_the_tolerance_asks_for(remainder):
    sides = {}
    for tol in (1e-3, 1e-5):
        kernels = MirroredKernels(remainder, (40, 50), "zero", np.dtype(np.float32), tol)
        assert 0.05 * tol < kernels.error <= 0.5 * tol
        sides[tol] = kernels.eigenvalues.shape
    assert sides[1e-5][1] > 2 * sides[1e-3][1] > 200
    assert sides[1e-3][0] == len(remainder.table)


@pytest.mark.parametrize(("beyond", "count"), [(0, 3), (2, 5), (5, 5), (7, 5), (13, 4), (6, 1)])
def test_mirrors_fold_what_leaves_as_they_unfold_what_is_seen(beyond, count):
    """The transpose of an image with its mirrored copies around it."""
    room = np.random.default_rng(beyond).integers(0, 99, (count + 2 * beyond, 3)).astype(np.float64)
    seen = np.pad(np.eye(count), ((0, 0), (beyond, beyond)), mode="symmetric")
    wanted = seen @ room
    assert np.array_equal(folded(room, beyond, count), wanted)


@pytest.mark.parametrize("places", [[0, 0, 0, 1, 2, 2], [1, 0, 2, 2, 2, 1, 0], [0, 1, 2]])
def test_copies_give_what_they_took_to_what_they_are_copies_of(places):
    taken = np.random.default_rng(0).integers(0, 99, (len(places), 4)).astype(np.float64)
    wanted = np.eye(3)[:, places] @ taken
    assert np.array_equal(without_copies(taken, np.array(places), np.arange(4), (3, 4)), wanted)
