"""Factors of the transfer function: densities by their transforms, and what is refused."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest
from mpmath import mp

import lommel as lm
from lommel.blur.blurs import FWHM, KOLMOGOROV, Blur, blurs_from_dicts

SEVERAL = [
    lm.Seeing(0.2),
    lm.Seeing(0.1, focal_length=4.0, wavelength=500e-9, outer_scale=25.0),
    lm.Jitter(0.3, 0.1, angle=0.7),
    lm.Jitter(0.2),
    lm.Motion(1.5, -0.4),
]


@pytest.mark.parametrize("blur", SEVERAL, ids=lambda blur: type(blur).__name__)
def test_light_is_kept_and_nothing_is_sharpened(blur):
    rate = 1e5 if blur.metric else 1.0
    f = rate * np.linspace(-2.0, 2.0, 41)
    found = blur.transfer(f[None], f[:, None])
    assert found.shape == (41, 41)
    assert blur.transfer(0.0) == 1.0
    assert np.abs(found).max() <= 1.0
    assert found == pytest.approx(found[::-1, ::-1])


@pytest.mark.parametrize("blur", SEVERAL, ids=lambda blur: type(blur).__name__)
def test_descriptions_are_plain_and_come_back(blur):
    told = json.loads(json.dumps(blur.to_dict(), allow_nan=False))
    assert blurs_from_dicts([told]) == (blur,)


def test_the_constants_of_kolmogorov_s_turbulence_have_all_the_digits_that_are_printed():
    assert round(KOLMOGOROV, 6) == 3.441939
    assert round(2.0 * KOLMOGOROV, 6) == 6.883877
    with mp.workdps(18):
        constant = (mp.mpf(24) / 5 * mp.gamma(mp.mpf(6) / 5)) ** (mp.mpf(5) / 6)

        def image(x):  # q = s^3, so that the integrand is analytic
            def at(s):
                return 3 * s**5 * mp.exp(-constant * s**5) * mp.besselj(0, 2 * mp.pi * x * s**3)

            return mp.quad(at, [0, 0.7, 1.4, 2.1])

        peak = image(0)
        width = 2 * mp.findroot(lambda x: image(x) / peak - mp.mpf(1) / 2, (0.48, 0.49), solver="secant", tol=1e-24)
    assert float(width) == pytest.approx(FWHM, abs=5e-11)
    air = lm.Seeing.from_fwhm(1e-6, focal_length=1.0, wavelength=500e-9)
    assert air.r0 == pytest.approx(0.5 * float(width), rel=1e-10)
    page = (Path(__file__).parents[2] / "docs" / "sensor.md").read_text(encoding="utf-8")
    for printed in (round(KOLMOGOROV, 6), round(2.0 * KOLMOGOROV, 6), FWHM):
        assert str(printed) in page


def test_fried_s_exponential_has_his_constant_and_his_colour():
    air = lm.Seeing(0.1, focal_length=4.0, wavelength=500e-9)
    f = 2e4
    for wavelength in (400e-9, 500e-9, 800e-9):
        r0 = 0.1 * (wavelength / 500e-9) ** 1.2
        expected = math.exp(-KOLMOGOROV * (wavelength * 4.0 * f / r0) ** (5.0 / 3.0))
        assert air.transfer(f, wavelength=wavelength) == pytest.approx(expected)
    assert air.transfer(f) == air.transfer(0.6 * f, 0.8 * f) == air.transfer(f, wavelength=500e-9)


@pytest.mark.parametrize("q", [1e-4, 0.03, 0.4, 1.591, 1.592, 5.0, 40.0])
def test_an_outer_scale_is_that_of_von_karman(q):
    mp.dps = 40
    scales, third = mp.mpf(10), mp.mpf(1) / 3
    z = 2 * mp.pi * mp.mpf(q) / scales
    front = scales ** (5 * third) * mp.mpf(2) ** (third / 2) * mp.gamma(11 * third / 2) / mp.pi ** (8 * third)
    front *= (mp.mpf(24) / 5 * mp.gamma(mp.mpf(6) / 5)) ** (5 * third / 2)
    structure = front * (
        mp.gamma(5 * third / 2) / mp.mpf(2) ** (third / 2) - z ** (5 * third / 2) * mp.besselk(5 * third / 2, z)
    )
    found = -math.log(lm.Seeing(1.0, outer_scale=10.0).transfer(q))
    assert found == pytest.approx(float(structure / 2), rel=1e-9)


def test_an_outer_scale_is_so_many_r0_of_the_colour_at_hand():
    air = lm.Seeing(0.1, focal_length=4.0, wavelength=500e-9, outer_scale=2.0)
    redder = lm.Seeing(0.1 * 1.6**1.2, focal_length=4.0, wavelength=800e-9, outer_scale=2.0)
    f = np.array([1e3, 1e4, 5e4])
    assert air.transfer(f, wavelength=800e-9) == pytest.approx(redder.transfer(f), rel=1e-9)


def test_gaussians_and_lines_turn_with_their_angle():
    f = np.linspace(0.0, 1.0, 5)
    jitter, motion = lm.Jitter(0.4, 0.1, angle=0.5), lm.Motion(2.0, 0.5)
    along, across = (math.cos(0.5), math.sin(0.5)), (-math.sin(0.5), math.cos(0.5))
    assert jitter.transfer(f * along[0], f * along[1]) == pytest.approx(np.exp(-2.0 * (math.pi * 0.4 * f) ** 2))
    assert jitter.transfer(f * across[0], f * across[1]) == pytest.approx(np.exp(-2.0 * (math.pi * 0.1 * f) ** 2))
    assert motion.transfer(f * along[0], f * along[1]) == pytest.approx(np.sinc(2.0 * f))
    assert motion.transfer(f * across[0], f * across[1]) == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: lm.Seeing(0.1, focal_length=2.0), "given together"),
        (lambda: lm.Seeing.from_fwhm(1.0, 8.0), "fwhm must be > 0 and < 0.1 radians"),
    ],
)
def test_what_is_none_is_refused(make, message):
    with pytest.raises((TypeError, ValueError), match=message):
        make()


def test_a_kind_of_blur_that_psfs_would_not_see_is_refused():
    with pytest.raises(TypeError, match="Ring must define covariance and streak"):

        class Ring(Blur):
            def transfer(self, fx, fy=0.0, *, wavelength=None):
                return np.exp(-np.hypot(fx, fy))


def test_a_kind_of_blur_names_its_lengths_so_that_their_unit_is_checked():
    kinds = lm.Seeing(0.1), lm.Jitter(1e-6, 2e-6), lm.Motion(4e-6)
    assert [kind.lengths for kind in kinds] == [(), (1e-6, 2e-6), (4e-6,)]
    with pytest.raises(TypeError, match="Ring must define length_names"):

        class Ring(Blur):
            pass
