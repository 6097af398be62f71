"""A lens while its sensor moves: where it has been moved to, and the light there."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.show.curves import moved, section

X = np.linspace(-3.0, 3.0, 13)


def test_the_light_on_the_axis_is_that_of_defocus():
    through = moved(lm.Pupil(), reach=6.0, count=25)
    values = section(through, X)
    assert values.shape == (25, 13)
    np.testing.assert_array_equal(through.at, np.linspace(-6.0, 6.0, 25))
    assert not through.metric
    np.testing.assert_allclose(values[:, 6], np.sinc(through.at / math.pi) ** 2, atol=2e-6)
    airy = lm.psf(lm.Pupil(), (1, 13), 0.5, normalize="strehl").values[0]
    np.testing.assert_allclose(values[12], airy, atol=2e-6)


def test_the_defocus_of_a_moved_sensor_is_that_of_the_lens(camera):
    through = moved(camera, 1.9, reach=50e-6, count=5)
    assert through.metric
    for z, pupil in zip(through.at, through.pupils, strict=True):
        # C_d = (pi / (2 lambda)) (1/d - 1/f + 1/s) R^2 with the sensor at d + z.
        d, radius = camera.sensor_distance + z, 0.5 * camera.aperture_diameter
        expected = math.pi / (2.0 * 550e-9) * (1.0 / d - 1.0 / 50e-3 + 1.0 / 1.9) * radius**2
        assert float(pupil.wavefront.defocus) == pytest.approx(expected, rel=1e-9)
        assert pupil.f_number == pytest.approx(d / camera.aperture_diameter, rel=1e-12)
    values = section(through, 1e-6 * X)
    expected = [
        float(lm.strehl(pupil)) * (through.pupils[2].f_number / pupil.f_number) ** 2 for pupil in through.pupils
    ]
    np.testing.assert_allclose(values[:, 6], expected, atol=2e-6)


def test_a_pupil_and_its_lens_agree_where_the_sensor_moves_little(camera):
    of_lens = moved(camera, reach=20e-6, count=9)
    of_pupil = moved(camera.pupil(), reach=20e-6, count=9)
    np.testing.assert_allclose(of_lens.at, of_pupil.at)
    (stack,) = of_pupil.pupils
    exact = [float(pupil.wavefront.defocus) for pupil in of_lens.pupils]
    np.testing.assert_allclose(stack.wavefront.defocus, exact, rtol=1e-3, atol=1e-9)
    np.testing.assert_allclose(section(of_lens, 1e-6 * X), section(of_pupil, 1e-6 * X), atol=2e-3)


@pytest.mark.parametrize("options", [{}, {"spider": lm.Spider.equal(3, width=0.1)}], ids=["round", "spider"])
def test_light_of_any_wavefront_is_that_of_its_psf(options):
    coma = lm.Pupil(lm.Wavefront(0.5, nonradial={(3, 1): 1.0}), wavelength=500e-9, f_number=4.0, **options)
    through = moved(coma, reach=40e-6, count=3)
    values = section(through, 1e-6 * X)
    (stack,) = through.pupils
    exact = lm.psf(stack, (1, 13), 0.5e-6, integrate=False, normalize="strehl").values[:, 0]
    np.testing.assert_allclose(values, exact, atol=3e-6)
    # The focus of the sensor moved away from the lens is that of more defocus.
    np.testing.assert_allclose(
        stack.wavefront.defocus, 0.5 + np.array([1, 0, -1]) * math.pi * 40e-6 / (8 * 5e-7 * 16)
    )


@pytest.mark.parametrize("wavefront", [lm.Wavefront(), lm.Wavefront(20.0), lm.Wavefront(-15.0, 10.0)], ids=str)
def test_by_default_each_zone_has_its_focus_in_between_and_so_has_the_sensor(wavefront):
    (stack,) = moved(lm.Pupil(wavefront), count=41).pupils
    added = stack.wavefront.defocus - wavefront.defocus
    assert added.min() < 0.0 < added.max()
    middle, rim = -wavefront.defocus, -wavefront.defocus - wavefront.spherical
    assert added.min() < min(middle, rim)
    assert added.max() > max(middle, rim)


def test_the_sensor_goes_to_where_the_lens_focuses_but_not_into_the_lens():
    lens = lm.Lens(focal_length=50e-3, f_number=8.0, sensor_distance=45e-3, wavelength=550e-9)
    through = moved(lens, 2.0, count=7)
    assert through.at[0] < 0.0
    assert through.at[-1] > 1.0 / (1.0 / 50e-3 - 1.0 / 2.0) - 45e-3
    slow = lm.Lens(focal_length=50e-3, f_number=400.0, focus_distance=2.0, wavelength=10e-6)
    ends = moved(slow, count=7).at[[0, -1]]
    np.testing.assert_allclose(ends, slow.sensor_distance * np.array([-0.95, 2.0]))


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"reach": 0.0}, "reach must be > 0, got 0"),
        ({"reach": 1.0}, "reach must be below the distance of the sensor, 0.0512821 m, got 1"),
        ({"count": 2}, "count must be from 3 to 4096, got 2"),
        ({"object_distance": [1.0, 2.0]}, r"there must be a single pupil, got a stack of shape \(2,\)"),
    ],
)
def test_what_is_out_of_range_is_refused(camera, options, told):
    with pytest.raises(ValueError, match=told):
        moved(camera, **options)


def test_a_pupil_has_its_object():
    with pytest.raises(ValueError, match="object_distance must be None for a pupil"):
        moved(lm.Pupil(), 1.0)
