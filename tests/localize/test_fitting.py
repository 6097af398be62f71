"""Fits of molecules: the Cramer-Rao bound is reached, states are true, channels and maps are what they say."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
import simulated_movies as simulated
from cases import each
from lommel.localize import Table, fit

ASTIGMATISM = lm.Wavefront.zernike({6: 0.15}, order="noll", unit="waves")
OBJECTIVE = lm.Objective(NA=1.4, magnification=63, immersion=1.518, sample=1.33)
LIGHT = {"wavelength": 600e-9, "aberrations": ASTIGMATISM}
RANGE = (-0.7e-6, 0.7e-6)


@pytest.fixture(scope="module")
def table() -> Table:
    return Table(OBJECTIVE.pupil(depth=1e-6, **LIGHT), shape=15, pixel=6.5e-6, z=RANGE, reach=2.0)


def places(count: int, seed: int, spread: float = 1.0, most: float = 0.6e-6) -> tuple[np.ndarray, ...]:
    rng = np.random.default_rng(seed)
    return (*(7.0 + rng.uniform(-spread, spread, (2, count))), rng.uniform(-most, most, count))


def images(row: np.ndarray, column: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Exact images, which no table is in."""
    pupil = OBJECTIVE.pupil(depth=1e-6, z=z, **LIGHT)
    return lm.psf(pupil, 15, 6.5e-6, center=(row, column), tol=1e-5, dtype=np.float64).values


@pytest.fixture(scope="module")
def many() -> tuple[tuple[np.ndarray, ...], np.ndarray]:
    """Places of 1200 molecules, and their images."""
    at = places(1200, 1)
    return at, images(*at)


def bound(
    table: Table, at: tuple[np.ndarray, ...], photons: float, background: float, read: float = 0.0
) -> np.ndarray:
    """The Cramer-Rao bound on row, column, z, photons and background, (n, 5)."""
    values, slopes = table(*at, derivatives=True)
    ones = np.ones_like(values)
    parts = [photons * slopes["row"], photons * slopes["column"], photons * 1e-6 * slopes["z"], values, ones]
    root = np.stack(parts, axis=1).reshape(len(values), 5, -1).astype(float)
    mean = (photons * values + background + read**2).reshape(len(values), 1, -1)
    covariance = np.linalg.inv(np.einsum("nap,nbp->nab", root / mean, root))
    return np.sqrt(np.diagonal(covariance, axis1=1, axis2=2)) * [1.0, 1.0, 1e-6, 1.0, 1.0]


@pytest.mark.parametrize(
    ("photons", "background", "read"), [(1000.0, 5.0, 0.0), (5000.0, 10.0, 0.0), (1000.0, 5.0, 2.0)]
)
def test_estimates_scatter_by_the_cramer_rao_bound_without_bias(table, many, photons, background, read):
    at, exact = many
    mean = photons * exact + background
    rng = np.random.default_rng(2)
    counts = rng.poisson(mean) + rng.normal(0.0, read, mean.shape)
    found = fit(table, counts, noise=lm.Noise(read=read))
    least = bound(table, at, photons, background, read)
    off = np.stack([found.row, found.column, found.z, found.photons, found.background], axis=1)
    off -= np.stack([*at, np.full(1200, photons), np.full(1200, background)], axis=1)
    off /= least
    assert found.converged.mean() > 0.98
    assert set(np.unique(found.state)) <= {0, 1}  # all that are not at a limit end
    assert (np.abs(off[:, :3]) < 6.0).all()
    # Five standard errors of a mean and of a standard deviation of so many.
    np.testing.assert_allclose(off[:, :3].mean(axis=0), 0.0, atol=5.0 / math.sqrt(1200))
    np.testing.assert_allclose(np.sqrt((off**2).mean(axis=0)), 1.0, atol=0.12)
    # The estimated standard errors are those at the estimates, and the discrepancies those of the right model.
    np.testing.assert_allclose(np.median(found.errors.z / least[:, 2]), 1.0, atol=0.02)
    assert abs(found.discrepancy.mean()) < 0.15
    assert 0.9 < found.discrepancy.std() < 1.1


def test_discrepancies_are_those_of_few_electrons_too(table, many):
    counts = np.random.default_rng(31).poisson(400.0 * many[1] + 0.2)
    found = fit(table, counts)
    assert 0.9 < found.discrepancy[found.converged].std() < 1.1


def test_fits_of_dim_molecules_end(table):
    at = places(6000, 33)
    found = fit(table, np.random.default_rng(34).poisson(400.0 * table(*at) + 5.0), starts=1)
    assert found.converged.mean() > 0.97
    assert (found.state == 2).mean() < 0.001


def test_without_noise_the_estimates_are_the_truth(table):
    at = places(60, 3)
    found = fit(table, 5000.0 * images(*at) + 10.0)
    # Within 0.005 of a standard error, as fits end, and on the whole far less: 0.1 nm along z of 10 nm.
    least = bound(table, at, 5000.0, 10.0)
    for values, truth, errors in zip((found.row, found.column, found.z), at, least.T, strict=False):
        assert (np.abs(values - truth) < 0.005 * errors).all()
        assert np.sqrt((((values - truth) / errors) ** 2).mean()) < 5e-4
    np.testing.assert_allclose(found.photons, 5000.0, rtol=1e-4)
    np.testing.assert_allclose(found.background, 10.0, rtol=1e-4)
    assert found.converged.all()
    assert np.abs(found.log_likelihood).max() < 1e-3


def test_the_likelihood_is_that_of_poisson(table):
    rng = np.random.default_rng(4)
    at = places(5, 5)
    counts = rng.poisson(1000.0 * images(*at) + 3.0)
    found = fit(table, counts)
    for k in range(5):
        mean = found.photons[k] * table(found.row[k], found.column[k], found.z[k]) + found.background[k]
        safe = np.maximum(counts[k], 1)
        best = (safe * np.log(safe / mean) * (counts[k] > 0) - counts[k] + mean).sum()
        assert found.log_likelihood[k] == pytest.approx(-best, abs=2e-3)
        # No place nearby is likelier.
        for by in ((0.05, 0, 0), (-0.05, 0, 0), (0, 0.05, 0), (0, -0.05, 0), (0, 0, 2e-8), (0, 0, -2e-8)):
            there = found.photons[k] * table(*(np.array([found.row[k], found.column[k], found.z[k]]) + by))
            there = there + found.background[k]
            assert (safe * np.log(safe / there) * (counts[k] > 0) - counts[k] + there).sum() > best - 1e-3


def test_wrong_starts_are_found_again_in_strong_aberrations():
    rng = np.random.default_rng(2)
    terms = rng.normal(size=7)
    terms *= 0.3 / np.sqrt((terms**2).sum())
    wavefront = lm.Wavefront.zernike(
        dict(zip((5, 6, 7, 8, 11, 12, 22), terms, strict=True)), order="noll", unit="waves"
    )
    strong = Table(
        OBJECTIVE.pupil(depth=1e-6, wavelength=600e-9, aberrations=wavefront), 15, 6.5e-6, z=(-0.95e-6, 0.95e-6)
    )
    row, column, z = places(500, 6, most=0.85e-6)
    pupil = OBJECTIVE.pupil(depth=1e-6, z=z, wavelength=600e-9, aberrations=wavefront)
    exact = lm.psf(pupil, 15, 6.5e-6, center=(row, column), tol=1e-4).values
    for photons, background, most in ((1000.0, 5.0, 0.015), (5000.0, 10.0, 0.002)):
        counts = np.random.default_rng(7).poisson(photons * exact + background)
        found = fit(strong, counts)
        least = bound(strong, (row, column, z), photons, background)
        off = np.stack([found.row - row, found.column - column, found.z - z], axis=1) / least[:, :3]
        lost = (np.abs(off) > 6.0).any(axis=1)
        assert lost.mean() <= most
        # What is lost is likelier than the truth: no fit by likelihood could find it.
        mean = photons * exact + background
        truth = -(np.where(counts > 0, counts * np.log(np.maximum(counts, 1) / mean), 0.0) - counts + mean).sum(
            axis=(1, 2)
        )
        assert (found.log_likelihood[lost] > truth[lost] - 0.01).all()


def test_starts_in_doubt_are_tried_elsewhere(table):
    # A molecule at a limit of the table is in doubt: more starts do not make it less likely.
    row, column, _ = places(100, 8)
    counts = np.random.default_rng(9).poisson(300.0 * images(row, column, np.full(100, 0.69e-6)) + 20.0)
    one, four = fit(table, counts, starts=1), fit(table, counts, starts=4)
    assert (four.steps >= one.steps).all()
    assert four.steps.sum() > one.steps.sum()
    assert four.converged.sum() >= one.converged.sum()
    known = one.converged & four.converged
    assert (four.log_likelihood[known] >= one.log_likelihood[known] - 0.01).all()


def test_states_are_told(table):
    beyond = images(np.array([7.0, 4.0]), np.array([7.0, 7.0]), np.array([0.95e-6, 0.0]))
    found = fit(table, 20000.0 * beyond + 5.0)
    assert [found.states[k] for k in found.state] == ["border", "border"]
    assert found.z[0] == pytest.approx(0.7e-6)
    assert found.row[1] == pytest.approx(5.0)
    empty = np.full((1, 15, 15), np.nan)
    empty[0, 7, 5:8] = 9.0
    found = fit(table, empty)
    assert [found.states[k] for k in found.state] == ["undetermined"]
    assert np.isinf(found.errors.z[0])


def test_what_is_dark_has_no_place(table):
    rng = np.random.default_rng(37)
    found = fit(table, rng.normal(-5.0, 1.0, (20, 15, 15)), noise=lm.Noise(read=1.0))
    assert not found.converged.any()
    dark = found.state == 3
    assert dark.sum() >= 15
    assert np.isinf(found.errors.photons[dark]).all()


def test_two_molecules_in_a_box_are_told_by_the_discrepancy(table):
    two = images(np.array([5.0, 9.0]), np.array([6.0, 8.0]), np.array([-0.2e-6, 0.3e-6])).sum(axis=0)
    counts = np.random.default_rng(0).poisson(3000.0 * two + 10.0)
    assert fit(table, counts[None]).discrepancy[0] > 10.0


def test_pixels_that_are_nan_do_not_count(table):
    at = places(40, 10)
    counts = np.random.default_rng(11).poisson(3000.0 * images(*at) + 10.0).astype(float)
    spoilt = counts.copy()
    spoilt[:, 3:6, 4] = 60000.0
    masked = spoilt.copy()
    masked[:, 3:6, 4] = np.nan
    found = fit(table, masked)
    least = bound(table, at, 3000.0, 10.0)
    assert (np.abs(found.z - at[2]) < 6.0 * least[:, 2]).all()
    assert (np.abs(fit(table, spoilt).z - at[2]) > 6.0 * least[:, 2]).any()
    assert (found.errors.z >= 0.99 * fit(table, counts).errors.z).all()


def test_maps_of_the_camera_are_those_of_each_box(table):
    rng = np.random.default_rng(14)
    shape = (60, 70)
    noise = lm.Noise(
        white=rng.uniform(0.3, 0.6, shape), offset=rng.uniform(90.0, 110.0, shape), read=rng.exponential(1.6, shape)
    )
    row, column, z = places(50, 15)
    corners = np.stack([rng.integers(0, 45, 50), rng.integers(0, 55, 50)], axis=1)
    boxes, plain = [], []
    for (y, x), mean in zip(corners, 2000.0 * images(row, column, z) + 8.0, strict=True):
        cut = np.s_[y : y + 15, x : x + 15]
        own = lm.Noise(white=noise.white[cut], offset=noise.offset[cut], read=noise.read[cut])
        boxes.append(own.record(mean, rng))
        plain.append((own.electrons(boxes[-1]), own))
    found = fit(table, boxes, noise=noise, corners=corners)
    for k in (0, 17, 49):
        electrons, own = plain[k]
        alone = fit(table, electrons[None], noise=lm.Noise(read=own.read))
        assert found.row[k] == pytest.approx(alone.row[0] + corners[k, 0], abs=1e-4)
        assert found.z[k] == pytest.approx(alone.z[0], abs=1e-10)
        assert found.errors.z[k] == pytest.approx(alone.errors.z[0], rel=1e-4)
    assert (np.abs(found.row - corners[:, 0] - row) < 6.0 * found.errors.row).all()
    assert (np.abs(found.column - corners[:, 1] - column) < 6.0 * found.errors.column).all()


@pytest.mark.parametrize("maps", [False, True])
def test_what_is_found_is_fitted_where_it_is(table, maps):
    rng = np.random.default_rng(30)
    shape = (64, 80)
    noise = lm.Noise(white=0.5, offset=100.0, read=rng.uniform(1.0, 2.5, shape) if maps else 1.5)
    row, column, z = np.array([20.3, 44.8]), np.array([30.4, 50.1]), np.array([-0.1e-6, 0.2e-6])
    mean = np.full(shape, 8.0)
    for k in range(2):
        y, x = round(row[k]) - 7, round(column[k]) - 7
        mean[y : y + 15, x : x + 15] += 4000.0 * images(row[k : k + 1] - y, column[k : k + 1] - x, z[k : k + 1])[0]
    frame = noise.record(mean, rng)
    spots = lm.localize.find(frame, 15, noise=noise)
    found = fit(table, spots.images, noise=noise, corners=spots.corners)
    order = np.argsort(found.row)
    for values, truth, errors in (
        (found.row, row, found.errors.row),
        (found.column, column, found.errors.column),
        (found.z, z, found.errors.z),
    ):
        assert (np.abs(values[order] - truth) < 6.0 * errors[order]).all()


def test_any_number_of_threads_says_the_same(table):
    counts = np.random.default_rng(19).poisson(800.0 * images(*places(300, 20)) + 5.0)
    one = fit(table, counts, threads=1)
    np.testing.assert_array_equal(one.z, fit(table, counts, threads=2).z)


def test_excess_noise_multiplies_photons_and_their_errors_alone(table):
    counts = np.random.default_rng(21).poisson(800.0 * images(*places(5, 22)) + 5.0)
    one, other = fit(table, counts), fit(table, 2.0 * counts, noise=lm.Noise(read=0.0, excess=2.0))
    for name, factor in {"row": 1.0, "column": 1.0, "z": 1.0, "photons": 2.0, "background": 2.0}.items():
        for found, plain in ((other, one), (other.errors, one.errors)):
            assert getattr(found, name) == pytest.approx(factor * getattr(plain, name), rel=1e-4, abs=0.0)
    fit(table, ONE, noise=lm.Noise(read=np.ones((60, 60))), corners=[[0, 45], [45, 0]])


ONE = np.ones((2, 15, 15))
BAD = [
    ({"noise": lm.Noise(read=np.ones((60, 60)))}, ValueError, "corners must be given for a camera"),
    ({"noise": lm.Noise(read=np.ones((60, 60))), "corners": [[0, 0], [46, 0]]}, ValueError, "corners must be"),
    ({"noise": lm.Noise(read=np.ones((60, 60))), "corners": [[0, 0], [0, -1]]}, ValueError, "corners must be"),
]


@each("case", BAD)
def test_bad_input_is_refused(case, table):
    changes, kind, message = case
    with pytest.raises(kind, match=message):
        fit(**({"table": table, "images": ONE} | changes))


def test_a_tilted_background_does_not_shift_positions():
    rng = np.random.default_rng(4)
    table = Table(simulated.pupil(), shape=15, pixel=simulated.PIXEL, z=(-0.6e-6, 0.6e-6), tol=1e-3)
    z, column = rng.uniform(-0.4e-6, 0.4e-6, 200), 7.0 + rng.uniform(-0.5, 0.5, 200)
    images = lm.psf(simulated.pupil(z=z), 15, simulated.PIXEL, center=(np.full(200, 7.0), column), tol=1e-4).values
    seen = rng.poisson(1500.0 * images + 15.0 + 0.6 * (np.arange(15) - 7.0))
    flat, tilted = (lm.localize.fit(table, seen, background=kind) for kind in ("flat", "tilted"))
    off = [(each.column - column) / each.errors.column for each in (flat, tilted)]
    assert np.mean(off[0]) > 1.0
    assert abs(np.mean(off[1])) < 0.3
    assert 0.85 < np.std(off[1]) < 1.15
    assert 1.0 < np.median(tilted.errors.column / flat.errors.column) < 1.06
