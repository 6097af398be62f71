"""Masks: where their samples lie, what they keep, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy import integrate, special

import lommel as lm
from lommel import Mask, Pupil


def test_the_rows_of_a_mask_rise_with_y_and_its_columns_with_x():
    mask = Mask([[0.1, 0.2], [0.3, 0.4]])
    pupil = Pupil(mask=mask)
    assert pupil.values([-0.5, 0.5, -0.5, 0.5], [-0.5, -0.5, 0.5, 0.5])[0].real.tolist() == [0.1, 0.2, 0.3, 0.4]
    assert mask.at(np.array([-1.0, 1.0, 1.001]), np.array([-1.0, 1.0, 0.0])).tolist() == [0.1, 0.4, 0.0]
    assert np.array_equal(Mask.sample(lambda x, y: 0.25 + 0.1 * (x > 0) + 0.2 * (y > 0), 2).values.round(3),
                          [[0.25, 0.35], [0.45, 0.55]])  # fmt: skip


def test_a_mask_keeps_values_of_its_own():
    values = np.ones((3, 3))
    mask = Mask(values)
    values[:] = 0.0
    assert mask.values.min() == 1.0
    with pytest.raises(ValueError, match="read-only"):
        mask.values[0, 0] = 0.5


@pytest.mark.parametrize(
    ("make", "error", "message"),
    [
        (lambda: Mask([[0.0, 1.01], [1.0, 1.0]]), ValueError, "values must have a modulus from 0 to 1, got 1.01"),
        (lambda: Mask([[0.0, -0.1], [1.0, 1.0]]), ValueError, "amplitudes from 0 to 1, got -0.1; .* np.exp"),
    ],
)  # fmt: skip
def test_what_is_no_mask_is_refused(make, error, message):
    with pytest.raises(error, match=message):
        make()


def test_cells_are_means_of_their_points():
    mask = lm.Mask.sample(lambda x, y: 0.5 + 0.3 * x + 0.1 * y * y, side=6, oversample=4)
    fine = lm.Mask.sample(lambda x, y: 0.5 + 0.3 * x + 0.1 * y * y, side=24)
    np.testing.assert_allclose(mask.values, fine.values.reshape(6, 4, 6, 4).mean(axis=(1, 3)))
    assert lm.Mask.sample(lambda x, y: np.exp(1j * x), side=6, oversample=2).values.dtype.kind == "c"
    assert lm.Mask.sample(lambda x, y: x > y, side=4, oversample=1) == lm.Mask.sample(lambda x, y: x > y, side=4)


@pytest.mark.parametrize(("angle", "most"), [(0.2, 1e-5), (0.0, 2e-4)])
def test_partly_clear_cells_bring_a_hexagon_of_pixels_closer(angle, most):
    shape = lm.Polygon.regular(6, radius=0.9, angle=angle)
    exact = lm.psf(lm.Pupil(stop=shape), 33, 0.25, normalize="strehl")

    def error(oversample: int) -> float:
        mask = lm.Mask.sample(lambda x, y: shape.margin(x, y) >= 0.0, side=512, oversample=oversample)
        return lm.peak_error(lm.psf(lm.Pupil(mask=mask), 33, 0.25, normalize="strehl"), exact)

    assert error(8) < most
    assert error(8) < 0.2 * error(1)


def test_a_double_helix_turns_with_defocus():
    def zones(x, y):
        zone = np.floor(5.0 * np.minimum(x**2 + y**2, 0.999))
        return np.exp(1j * (2.0 * zone + 1.0) * np.arctan2(y, x))

    helix = Mask.sample(zones, 128)
    y, x = np.mgrid[-24:25, -24:25]
    angles = []
    for defocus in (-4.0, 0.0, 4.0):
        values = lm.psf(lm.Pupil(lm.Wavefront(defocus), mask=helix), 49, 0.33).values
        assert values == pytest.approx(values[::-1, ::-1], abs=1e-6 * float(values.max()))
        lobes = values * (values > 0.5 * values.max())
        angles.append(0.5 * math.atan2(2.0 * (lobes * x * y).sum(), (lobes * (x * x - y * y)).sum()))
    # Along y in focus, and a turn the other way on its other side.
    assert abs(angles[1]) == pytest.approx(0.5 * math.pi, abs=1e-3)
    assert angles[0] == pytest.approx(-angles[2], abs=1e-3)
    assert 0.5 < abs(angles[2]) < 1.0


def test_a_cubic_phase_plate_and_a_vortex_have_the_psfs_of_their_wavefronts():
    # x^3 = (rho^3 cos 3 theta + 3 rho^3 cos theta) / 4, and R_3^1 = 3 rho^3 - 2 rho.
    terms = {(3, 1): 5.0, (3, -1): 5.0, (3, 3): 5.0, (3, -3): -5.0, (1, 1): 10.0, (1, -1): 10.0}
    exact = lm.psf(lm.Pupil(lm.Wavefront.zernike(terms, normalization="edge")), 49, 0.5, normalize="strehl")
    plate = Mask.sample(lambda x, y: np.exp(20j * (x**3 + y**3)), 256)
    assert lm.peak_error(lm.psf(lm.Pupil(mask=plate), 49, 0.5, normalize="strehl"), exact) < 1e-3
    vortex = Mask.sample(lambda x, y: np.exp(1j * np.arctan2(y, x)), 256)
    found = lm.psf(lm.Pupil(mask=vortex), 49, 0.25, normalize="strehl")
    # |U| = 2 int J_1(v rho) rho d rho.
    v = math.pi * 0.25 * np.arange(25)
    known = [(2.0 * integrate.quad(lambda t, k=k: special.j1(k * t) * t, 0.0, 1.0)[0]) ** 2 for k in v]
    assert found.values[24, 24:] == pytest.approx(known, abs=1e-3)


def test_without_aberration_a_mask_with_phases_is_its_moduli():
    values = np.exp(1j * np.linspace(0.0, 3.0, 4096).reshape(64, 64))
    assert np.abs(values).max() > 1.0  # rounded
    ideal = lm.Pupil(mask=lm.Mask(values)).unaberrated()
    np.testing.assert_allclose(ideal.mask.values, 1.0, rtol=1e-15)
    assert ideal.mask.values.max() == 1.0


@pytest.mark.parametrize("side", [8, 64])
@pytest.mark.parametrize("squares", [False, True])
def test_a_mask_within_parts_is_one_within_the_rim_that_they_are(side, squares):
    mask = lm.Mask(np.exp(1j * np.random.default_rng(2).normal(size=(side, side))), squares=squares)
    window = {"shape": (7, 5), "pixel": 0.5, "tol": 1e-9}
    for round_one, parts in (
        ({}, {"stop": lm.Disc()}),
        ({"obscuration": 0.3}, {"stop": lm.Disc() - lm.Disc(0.3)}),
        ({"vignetting": lm.Ellipse(0.8, 0.5)}, {"stop": lm.Disc() & lm.Ellipse(0.8, 0.5)}),
        (
            {"spider": lm.Spider.equal(2, 0.01)},
            {"stop": lm.Disc() - lm.Polygon([(-1, -5e-3), (1, -5e-3), (1, 5e-3), (-1, 5e-3)])},
        ),
    ):
        one, other = (lm.psf(lm.Pupil(mask=mask, **each), **window) for each in (round_one, parts))
        # Areas of cells are differences: rounding of 1e-16 over their area, in a few of many cells.
        assert np.abs(one.values - other.values).max() <= one.error_bound + other.error_bound
