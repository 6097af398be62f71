"""Where rays meet the sensor."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.show import plot

METRIC = {"wavelength": 500e-9, "f_number": 4.0}


def test_rays_of_defocus_meet_the_sensor_as_far_out_as_they_leave_the_aperture():
    # v = dPhi / drho = 4 C_d rho, and r = v / pi in units of lambda*N.
    at = plot.ray_positions(lm.Pupil(lm.Wavefront(3.0)), 4)
    assert at.shape == (1 + 6 * (1 + 2 + 3 + 4), 2)
    found = np.unique(np.round(np.hypot(*at.T), 9))
    np.testing.assert_allclose(found, 12.0 / math.pi * np.arange(5) / 4, atol=1e-7)


def test_marginal_rays_and_those_of_the_edge_of_an_obscuration_are_among_them():
    pupil = lm.Pupil(lm.Wavefront.from_seidel(W020=-1.0, W040=2.0), obscuration=0.35)
    radius = np.hypot(*plot.ray_positions(pupil, 7).T)
    for rho in (0.35, 1.0):  # 2 dW/drho, lambda*N
        assert np.abs(radius - abs(2 * (-2.0 * rho + 8.0 * rho**3))).min() == pytest.approx(0, abs=1e-9)
    far = lm.Pupil(lm.Wavefront.from_seidel(W040=2.0))
    assert np.hypot(*plot.ray_positions(far).T).max() == pytest.approx(16.0)


def test_a_tilt_moves_all_of_them_to_higher_columns_in_metres():
    tilt = lm.Wavefront(nonradial={(1, 1): 2.0})
    at = plot.ray_positions(lm.Pupil(tilt, **METRIC), 3)
    np.testing.assert_allclose(at, np.broadcast_to([2.0 / math.pi * 2e-6, 0.0], at.shape), atol=1e-15)


@pytest.mark.parametrize("options", [{}, {"obscuration": 0.4}, {"vignetting": lm.Ellipse(0.8, 0.6)}], ids=str)
def test_their_rms_radius_is_that_of_all_rays(options):
    pupil = lm.Pupil(lm.Wavefront(1.0, 0.5, nonradial={(3, 1): 1.0, (2, 2): -0.7}), **options)
    at = plot.ray_positions(pupil, 60)
    away = at - at.mean(axis=0)
    assert math.sqrt((away**2).sum(axis=1).mean()) == pytest.approx(float(lm.spot_radius(pupil)), rel=0.02)
    np.testing.assert_allclose(at.mean(axis=0), lm.centroid(pupil), atol=0.02)


def test_rays_that_are_stopped_do_not_count():
    flat = lm.Wavefront(1.0)
    whole = len(plot.ray_positions(lm.Pupil(flat), 10))
    assert len(plot.ray_positions(lm.Pupil(flat, obscuration=0.5), 10)) < 0.85 * whole
    half = lm.Mask(np.repeat([[1.0, 0.0]], 2, axis=0))
    at = plot.ray_positions(lm.Pupil(flat, mask=half), 10)
    assert 0.45 * whole < len(at) < 0.55 * whole
    assert at[:, 0].max() <= 1e-6


def test_what_has_no_rays_is_refused():
    with pytest.raises(ValueError, match="pupil must be a single one"):
        plot.ray_positions(lm.Pupil(lm.Wavefront([1.0, 2.0])))
    with pytest.raises(ValueError, match="rings must be from 1 to 100, got 0"):
        plot.ray_positions(lm.Pupil(), 0)
    with pytest.raises(TypeError, match="pupil must be a Pupil"):
        plot.ray_positions(lm.Wavefront())
