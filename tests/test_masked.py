"""Masked arrays: the fit to a map takes the mask as its own, everything else refuses, for arrays lose it silently."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel import imaging

PUPIL = lm.Pupil(lm.Wavefront(1.0))
PSF = lm.psf(PUPIL, 5, 0.5)
LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
PAIR = np.ma.masked_array([0.3, 0.4], mask=[False, True])
SQUARE = np.ma.masked_array(np.full((24, 24), 0.5), mask=np.eye(24, dtype=bool))
PLAIN = np.full((24, 24), 0.5)


@pytest.fixture
def interferogram():
    y, x = np.mgrid[-1:1:65j, -1:1:65j]
    hole = x * x + y * y < 0.1
    return np.where(hole, 1e3, 0.3 * (2 * (x * x + y * y) - 1)), hole


def test_the_fit_to_a_map_takes_its_mask(interferogram):
    values, hole = interferogram
    masked = lm.fit_opd(np.ma.masked_array(values, mask=hole), unit="waves")
    told = lm.fit_opd(values, unit="waves", mask=~hole)
    assert masked.wavefront == told.wavefront
    assert masked.samples == told.samples
    assert masked.rms < 1e-3


def test_the_mask_of_a_map_and_the_mask_beside_it_both_count(interferogram):
    values, hole = interferogram
    upper = np.arange(65)[:, None] < 50
    both = lm.fit_opd(np.ma.masked_array(values, mask=hole), unit="waves", mask=np.broadcast_to(upper, hole.shape))
    told = lm.fit_opd(values, unit="waves", mask=~hole & upper)
    assert both.wavefront == told.wavefront
    with pytest.raises(TypeError, match="mask must not be masked"):
        lm.fit_opd(values, unit="waves", mask=np.ma.masked_array(~hole, mask=hole))


def test_a_masked_array_that_masks_nothing_is_an_array():
    assert lm.Wavefront(np.ma.masked_array([1.0, 2.0])) == lm.Wavefront([1.0, 2.0])


@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("defocus", lambda: lm.Wavefront(PAIR)),
        ("defocus", lambda: lm.Wavefront([PAIR, PAIR])),
        ("higher", lambda: lm.Wavefront(higher=[0.0, PAIR])),
        ("nonradial", lambda: lm.Wavefront(nonradial={(2, 2): PAIR})),
        ("W020", lambda: lm.Wavefront.from_seidel(PAIR)),
        ("rms", lambda: lm.Wavefront.balanced_spherical(PAIR)),
        ("rho", lambda: lm.Wavefront().phase(PAIR)),
        ("angle", lambda: lm.Wavefront().rotated(PAIR)),
        ("radius", lambda: lm.Wavefront().scaled(PAIR)),
        ("x", lambda: PUPIL.values(PAIR, 0.0)),
        ("radius", lambda: PUPIL.v(PAIR)),
        ("values", lambda: lm.Mask(SQUARE)),
        ("function", lambda: lm.Mask.sample(lambda x, y: SQUARE, 24)),
        ("object_distance", lambda: LENS.pupil(PAIR)),
        ("object_distance", lambda: LENS.defocus(PAIR)),
        ("radius", lambda: PSF.encircled_energy(PAIR)),
        ("half_width", lambda: PSF.ensquared_energy(PAIR)),
        ("radius", lambda: PSF.profile(PAIR)),
        ("fx", lambda: PSF.otf(PAIR)),
        ("fx", lambda: lm.mtf(PUPIL, PAIR)),
        ("fy", lambda: lm.otf(PUPIL, 0.1, PAIR)),
        ("v", lambda: lm.NijboerZernike().field(PUPIL, PAIR)),
        ("values", lambda: lm.mse(SQUARE, PLAIN)),
        ("reference", lambda: lm.peak_error(PLAIN, SQUARE)),
        ("phase", lambda: lm.fit_radial(SQUARE[0], PLAIN[0])),
        ("opd", lambda: lm.fit_opd([SQUARE, SQUARE], unit="waves")),
        ("x", lambda: lm.FieldMap.scattered(PAIR, PLAIN[0, :2], lm.Wavefront([1.0, 2.0]))),
        ("image", lambda: imaging.depth_of_field(SQUARE, PLAIN, LENS, 8e-6, encoding="linear")),
        ("depth", lambda: imaging.depth_of_field(PLAIN, 4 * SQUARE, LENS, 8e-6, encoding="linear")),
        ("image", lambda: imaging.depth_of_field(SQUARE, PLAIN, LENS, 8e-6, encoding="linear", tile=16)),
        ("depth", lambda: imaging.depth_of_field(PLAIN, 4 * SQUARE, LENS, 8e-6, encoding="linear", tile=16)),
        ("depth", lambda: imaging.DepthBlur(4 * SQUARE, LENS, 8e-6)),
        ("image", lambda: imaging.DepthBlur(4 * PLAIN, LENS, 8e-6).forward(SQUARE)),
    ],
)
def test_everything_else_refuses_what_is_masked_by_name(name, call):
    with pytest.raises(TypeError, match=rf"^{name}.* must not be masked; fill it"):
        call()
