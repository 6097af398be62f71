"""The instruments of the examples: that they are what they claim to be."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path

import numpy as np
import pytest

import lommel as lm
from lommel.methods import METHODS
from lommel.methods.choice import references
from lommel.report.image_quality import compare_methods, other_model


@pytest.fixture(scope="module")
def hubble(lenses: dict[str, Path]) -> lm.Instrument:
    return lm.load_instrument(lenses["hubble-1990"])


def test_hubble_put_an_eighth_to_a_fifth_of_the_light_of_a_star_within_a_tenth_of_an_arcsecond(hubble):
    within = hubble.radii["0.1 arcsec"]
    assert within == pytest.approx(57.6 * 0.1 * math.pi / 180 / 3600)
    as_launched = lm.psf(hubble.pupil(), 9, hubble.pixel)
    as_designed = lm.psf(hubble.pupil().unaberrated(), 9, hubble.pixel)
    assert 0.12 < as_launched.encircled_energy(within) < 0.20
    assert as_designed.encircled_energy(within) > 0.60


def test_hubble_is_at_the_focus_that_puts_most_light_within_a_tenth_of_an_arcsecond(hubble):
    # Balanced spherical aberration of 0.265 um rms over the annulus, and no further defocus.
    balanced = lm.Wavefront.balanced_spherical(2 * math.pi * 0.265 / 0.55, obscuration=0.33)
    pupil = lm.Pupil(balanced, obscuration=0.33, wavelength=0.55e-6, f_number=24.0)
    best = lm.best_focus(pupil, hubble.radii["0.1 arcsec"]) / math.pi
    in_the_file = (hubble.pupil().wavefront - balanced).waves["W020"]
    assert in_the_file == pytest.approx(best, abs=0.01)
    assert (hubble.pupil().wavefront - balanced).waves["W040"] == pytest.approx(0.0, abs=1e-9)


def test_hubble_has_the_rms_of_its_mirror(hubble):
    t, weights = np.polynomial.legendre.leggauss(40)
    rho = np.sqrt(0.5 * (1 + 0.33**2) + 0.5 * (1 - 0.33**2) * t)
    without_further_defocus = hubble.pupil().wavefront - lm.Wavefront.from_seidel(W020=3.697)
    phase = without_further_defocus.phase(rho)
    rms = math.sqrt(0.5 * weights @ (phase - 0.5 * weights @ phase) ** 2)
    assert rms * 0.55 / (2 * math.pi) == pytest.approx(0.265)


def test_the_nifty_fifty_is_as_far_out_of_focus_as_equation_3_says(lenses):
    # With the sensor where an object at 2 m is sharp, 1/d - 1/f = -1/2, hence
    # 2 C_d = pi / lambda (1/1.5 - 1/2) R^2 with R = 50 mm / 3.6, by hand 183.64.
    radius = 0.050 / 3.6
    by_hand = math.pi / 550e-9 * (1 / 1.5 - 1 / 2) * radius**2 / 2
    assert by_hand == pytest.approx(91.82, abs=0.01)
    instrument = lm.load_instrument(lenses["nifty-fifty"])
    assert instrument.pupil().wavefront.defocus == pytest.approx(by_hand)
    assert instrument.pupil().wavefront.spherical == 0.0


def test_the_blur_of_the_nifty_fifty_is_that_of_similar_triangles(lenses):
    instrument = lm.load_instrument(lenses["nifty-fifty"])
    lens = instrument.lens
    image = 1 / (1 / 0.05 - 1 / 1.5)
    blur = lens.aperture_diameter / 2 * (image - lens.sensor_distance) / image
    assert instrument.pupil().geometric_radius() == pytest.approx(blur)


def test_the_phone_sees_its_background_out_of_focus_beyond_the_plane_in_focus(lenses):
    instrument = lm.load_instrument(lenses["phone"])
    assert instrument.object_distance > instrument.lens.focus_distance
    assert instrument.pupil().wavefront.defocus < 0


def test_the_microscope_has_the_working_f_number_of_its_magnification_and_aperture(lenses):
    instrument = lm.load_instrument(lenses["microscope-20x"])
    lens = instrument.lens
    assert lens.working_f_number == pytest.approx(20 / (2 * 0.75), abs=0.005)
    assert lens.sensor_distance / lens.focus_distance == pytest.approx(20.0)
    assert lens.aperture_diameter / 2 / lens.focus_distance == pytest.approx(0.75)


def test_the_microscope_is_two_micrometres_out_of_focus_with_a_quarter_wave_of_spherical(lenses):
    instrument = lm.load_instrument(lenses["microscope-20x"])
    lens, distance = instrument.lens, instrument.object_distance
    assert (lens.model, lens.corrected_for) == ("aplanatic", "focus")
    assert lens.defocus(distance) / np.pi == pytest.approx(-0.5 * 0.75**2 * 2e-6 / 515e-9, rel=1e-3)
    waves = (instrument.pupil().wavefront - lens.phase(lens.defocus(distance))).waves
    assert waves["W040"] == pytest.approx(0.25)
    assert waves["W020"] == pytest.approx(-0.25)


def test_what_the_other_model_would_change_is_told_of_every_example(lenses):
    names = ("nifty-fifty", "microscope-20x")
    told = {name: other_model(lm.load_instrument(lenses[name])) for name in names}
    assert told["nifty-fifty"]["reason"] is None
    assert 0.2 < told["nifty-fifty"]["peak_error"] < 0.6
    assert told["nifty-fifty"]["geometric_radius"] == pytest.approx(123.4e-6, rel=1e-3)
    assert told["microscope-20x"]["model"] == "paraxial"
    assert told["microscope-20x"]["peak_error"] > 0.3
    oil = dataclasses.replace(lm.load_instrument(lenses["microscope-20x"]))
    wide = dataclasses.replace(oil.lens, model="paraxial", aperture_diameter=29.4e-3)
    refused = other_model(dataclasses.replace(oil, lens=wide))
    assert "the sine of the angle of the marginal ray would be 1.4" in refused["reason"]
    # A paraxial objective is no flat thin lens, which is what the reference would take it for.
    plain = dataclasses.replace(oil, lens=dataclasses.replace(oil.lens, model="paraxial"), shape=(7, 7))
    (row,), _ = compare_methods(plain, [lm.paper.HuygensFresnel()])
    assert row["reason"].startswith('needs model = "aplanatic"')
    (row,), _ = compare_methods(dataclasses.replace(oil, shape=(7, 7)), [lm.paper.HuygensFresnel()])
    assert row["peak_error"] < 1e-6


def test_the_newtonian_has_the_coma_and_astigmatism_of_a_paraboloid(lenses):
    instrument = lm.load_instrument(lenses["newtonian-off-axis"])
    a, f, theta, wavelength = 0.1, 0.8, math.radians(0.25), 550e-9
    coma, astigmatism = a * theta / (16 * 4.0**2) / wavelength, -(a**2) * theta**2 / (2 * f) / wavelength
    of_the_figure = {4: 15.0, 6: -22.0, 9: 30.0, 11: -18.0}
    expected = lm.Wavefront.from_seidel(W131=coma, W222=astigmatism, field=(0.6, 0.8)) + lm.Wavefront.zernike(
        {j: c * 1e-9 for j, c in of_the_figure.items()}, order="noll", unit="metres", wavelength=wavelength
    )
    difference = (instrument.pupil().wavefront - expected).to_zernike(unit="waves")
    assert max(abs(float(c)) for c in difference.values()) < 5e-4
    # Away from the axis: where the field points, there is light; opposite, there is none.
    image = lm.psf(instrument.pupil(), instrument.shape, instrument.pixel).values
    middle = instrument.shape[0] // 2
    assert image[middle:, middle:].sum() > 5 * image[:middle, :middle].sum()


def test_every_method_has_a_row_in_the_comparison_of_every_example(lens_file):
    instrument = dataclasses.replace(lm.load_instrument(lens_file), shape=(7, 7))
    pupil = instrument.pupil()
    methods = [kind() for kind in METHODS.values()]
    started: list[str] = []
    rows, answers = compare_methods(instrument, methods, started.append)
    assert [row["method"] for row in rows] == [type(method).__name__ for method in methods]
    assert [row["options"] for row in rows] == [method.to_dict() for method in methods]
    assert next(iter(answers)) == started[0] == ("Hankel" if pupil.radial else repr(references(pupil)[0]))
    if not pupil.circular:
        kinds = {type(method).__name__: method for method in methods}
        assert {row["method"] for row in rows if row["reason"] is None} == {
            n for n, m in kinds.items() if m.any_aperture or (m.cut_aperture and pupil.strips is not None)
        }
        return
    wavefront = instrument.pupil().wavefront
    refused = {"LommelSeries"} if np.any(wavefront.coefficients[..., 1:]) else set()
    if wavefront.symmetric > 10:  # an expansion whose powers cancel
        refused |= {"ClosedForm", "TunedClosedForm"}
    for row in rows:
        expected = row["method"].split(".")[0] not in refused
        assert (row["reason"] is None) == expected
        assert (row["method"] in answers) == (expected and row["method"] != "HuygensFresnel")
    certified = {row["method"]: row for row in rows}["NijboerZernike"]
    assert certified["peak_error"] <= certified["error_bound"] <= 1e-6
