"""Colour of lenses: each wavelength has a focal length and a size of the image of its own."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm

WAVES = (450e-9, 550e-9, 650e-9)
COLOUR = lm.Colour(WAVES, [60e-6, 0.0, 40e-6], [4e-6, 0.0, -3e-6], 20e-3)
MODELS = (
    {},
    {"model": "aplanatic"},
    {"model": "aplanatic", "corrected_for": "focus", "apodization": "aplanatic"},
)


def lens(**changes) -> lm.Lens:
    parts = {"focal_length": 50e-3, "f_number": 2.8, "focus_distance": 2.0, "wavelength": 550e-9, "colour": COLOUR}
    return lm.Lens(**parts | changes)


def test_the_defocus_of_a_colour_is_equation_3_with_its_focal_length():
    camera = lens()
    for wavelength, shift in zip(WAVES, COLOUR.focus_shift, strict=True):
        for s in (1.0, 2.0, math.inf):
            d, f, radius = camera.sensor_distance, 50e-3 + shift, 25e-3 / 2.8
            expected = math.pi / (2.0 * wavelength) * (1.0 / d - 1.0 / f + 1.0 / s) * radius**2
            assert camera.pupil(s).in_light(wavelength).wavefront.defocus == pytest.approx(expected, abs=1e-9)


def test_a_longer_focal_length_leaves_the_sensor_before_the_focus():
    assert lens().pupil().in_light(650e-9).wavefront.defocus > 1.0


@pytest.mark.parametrize("model", MODELS)
def test_a_pupil_in_other_light_is_that_of_the_lens_in_other_light(model):
    camera = lens(aberrations=lm.Wavefront(0.5, 2.0), **model)
    stack = camera.pupil([1.5, 2.0, math.inf])
    for wavelength in (450e-9, 512e-9, 650e-9):
        found, expected = stack.in_light(wavelength), camera.in_light(wavelength).pupil([1.5, 2.0, math.inf])
        assert np.abs((found.wavefront - expected.wavefront).edge).max() < 1e-9
        assert found.illumination == expected.illumination
        assert found.geometry.focal_length == pytest.approx(expected.geometry.focal_length, rel=1e-14)
        back = found.in_light(550e-9)
        assert np.abs((back.wavefront - stack.wavefront).edge).max() < 1e-9


@pytest.mark.parametrize(
    ("model", "f_number", "off"), [({}, 16.0, 1e-3), *((model, 2.8, 1e-8) for model in MODELS[1:])]
)
def test_huygens_sum_of_the_lens_in_other_light_agrees(model, f_number, off):
    camera = lens(f_number=f_number, **model)
    for wavelength in (450e-9, 650e-9):
        there, exact = camera.in_light(wavelength).pupil(1.9), lm.paper.HuygensFresnel()
        known = lm.psf(there, 9, 4e-6, method=exact, integrate=False, dtype=np.float64)
        found = lm.psf(camera.pupil(1.9).in_light(wavelength), 9, 4e-6, tol=1e-9, integrate=False)
        assert lm.peak_error(found, known.values) < off


def test_lateral_colour_moves_the_image_away_from_the_axis():
    field = lm.FieldMap.from_seidel(20e-3, W222=0.3, aperture=lens().pupil(2.0).unaberrated())
    x, y = np.array([10e-3, -12e-3]), np.array([0.0, 16e-3])
    for wavelength, shift in ((450e-9, 4e-6), (650e-9, -3e-6)):
        pupil = field.pupil(x, y).in_light(wavelength)
        assert np.array(lm.centroid(pupil)) == pytest.approx(shift / 20e-3 * np.stack([x, y], axis=-1), abs=1e-11)
    # By way of another colour, where the shift is not 0.
    twice = field.pupil(x, y).in_light(450e-9).in_light(650e-9)
    assert np.abs((twice.wavefront - field.pupil(x, y).in_light(650e-9).wavefront).edge).max() < 1e-9
    assert lm.centroid(field.pupil(10e-3, 0.0)) == pytest.approx([0.0, 0.0], abs=1e-15)


def test_positions_stay_with_the_pupils_of_a_stack():
    field = lm.FieldMap.from_seidel(20e-3, W222=0.3, aperture=lens().pupil(2.0).unaberrated())
    x, y = np.array([0.0, 5e-3, 10e-3]), np.array([[0.0], [8e-3]])
    stack = field.pupil(x, y)
    expected = stack.in_light(450e-9).wavefront
    assert stack[1, 2].in_light(450e-9).wavefront == expected[1, 2]
    assert stack[:, 1].in_light(450e-9).wavefront == expected[:, 1]
    assert stack[0].broadcast((4, 3)).in_light(450e-9).wavefront == expected[0].broadcast((4, 3))
    again = lm.Pupil.from_dict(stack.to_dict())
    assert again.in_light(450e-9).wavefront == expected


def test_lateral_colour_is_odd_in_the_height_and_meets_what_is_known():
    colour = lm.Colour(WAVES, None, [[1e-6, 0, 0], [5e-6, 0, 0]], [10e-3, 20e-3])
    assert colour.shift_across([0.0, 10e-3, 20e-3], 450e-9) == pytest.approx([0.0, 1e-6, 5e-6], abs=1e-20)
    assert colour.shift_across([0.0, 10e-3, 20e-3], 550e-9) == pytest.approx(0.0, abs=1e-20)
    # A line where one height is known.
    assert COLOUR.shift_across(5e-3, 450e-9) == pytest.approx(1e-6, rel=1e-12)
    with pytest.raises(ValueError, match=r"known up to 0.02 m from the axis, got 0.021 m"):
        COLOUR.shift_across(21e-3, 450e-9)


def test_only_differences_of_the_focal_shift_count():
    other = lm.Colour(WAVES, np.array(COLOUR.focus_shift) + 1e-3)
    for wavelength in (450e-9, 600e-9):
        found = lens(colour=other).pupil(1.5).in_light(wavelength).wavefront
        assert found.defocus == pytest.approx(lens().pupil(1.5).in_light(wavelength).wavefront.defocus, abs=1e-9)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([550, 650], [0.0, 0.0]), "550e-9"),
        ((WAVES, None, [0.0, 0.0, 0.0]), "lateral and heights"),
    ],
)
def test_what_is_no_table_is_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        lm.Colour(*arguments)


def test_what_is_not_known_is_not_guessed():
    with pytest.raises(ValueError, match="known from 450 to 650 nm, got 700"):
        lens().pupil(1.0).in_light(700e-9)
    with pytest.raises(ValueError, match="known from 450 to 650 nm, got 400"):
        lens(wavelength=400e-9)
    with pytest.raises(TypeError, match="colour must be of the type Colour"):
        lens(colour=[1, 2])
    aplanatic = lens(model="aplanatic")
    field = lm.FieldMap.from_seidel(20e-3, W222=0.3, aperture=aplanatic.pupil(2.0).unaberrated())
    with pytest.raises(ValueError, match='model="paraxial"'):
        field.pupil(1e-3, 0.0).in_light(450e-9)


def test_an_answer_keeps_the_colour_of_its_pupil_in_files(tmp_path):
    light = lm.methods.Polychromatic(WAVES, (1.0, 2.0, 1.0))
    answer = lm.psf(lens().pupil(2.0), 9, 3e-6, method=light)
    answer.save(tmp_path / "p.npz")
    again = lm.PSF.load(tmp_path / "p.npz")
    assert again.pupil == answer.pupil
    assert again.strehl == answer.strehl < 0.5
