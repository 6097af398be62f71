"""Numbers of instruments of files, and how they are shown."""

from __future__ import annotations

import dataclasses
import json
import math

import pytest

import lommel as lm
from lommel.lensfiles.microscope_files import Microscope
from lommel.report.image_quality import DEPTHS, ImageQuality, microscope_quality
from objectives import MATCHED


@pytest.fixture(scope="module")
def quality(lenses):
    phone = dataclasses.replace(lm.load_instrument(lenses["phone"]), object_distance=1.2, pixel=(2e-6, 3e-6))
    return ImageQuality(phone)


def test_attributes_are_those_of_the_library_in_both_directions(quality):
    pupil = quality.instrument.pupil()
    assert quality.strehl == float(lm.strehl(pupil))
    assert quality.rms_waves == float(lm.rms(pupil, unit="waves"))
    assert quality.mtf50(0.5 * math.pi) == pytest.approx(float(lm.mtf_frequency(pupil, angle=0.5 * math.pi)))
    along_x, along_y = (quality.mtf(1e5, angle, pixel=True) for angle in (0.0, 0.5 * math.pi))
    assert along_x / along_y == pytest.approx(math.sin(0.3 * math.pi) / 1.5 / math.sin(0.2 * math.pi), rel=1e-6)
    near, far = quality.depth_of_field
    blur = [2.0 * float(quality.lens.pupil(end).geometric_radius()) for end in (near, far)]
    assert blur == pytest.approx([6e-6, 6e-6])


def test_plain_data_have_the_attributes_and_the_reasons_of_what_is_missing(quality, monkeypatch):
    def refuse(self, angle=0.0):
        raise ValueError("takes too long")

    monkeypatch.setattr(ImageQuality, "mtf50", refuse)
    found = json.loads(json.dumps(quality.to_dict(), allow_nan=False))
    assert found["refused"] == ["takes too long"]
    assert found["mtf50"] is found["mtf50_y"] is None
    assert found["strehl_at_peak"] == quality.strehl_at_peak
    assert found["fwhm_with_pixel"] == quality.fwhm(pixel=True) != quality.fwhm()
    assert found["in_focus"] == {"near": quality.depth_of_field[0], "far": quality.depth_of_field[1], "blur": 6e-6}
    assert [row["fraction"] for row in found["encircled_energy"]] == quality.encircled_energy()[0]
    assert found["wavelength"] == quality.lens.wavelength


def test_telescopes_and_microscopes_have_no_depth_of_field(lenses):
    for name in ("hubble-1990", "microscope-20x"):
        quality = ImageQuality(lm.load_instrument(lenses[name]))
        assert quality.depth_of_field is quality.hyperfocal_distance is None


def microscope(**changes) -> Microscope:
    plain = Microscope(MATCHED, 610e-9, 6.5e-6, depth=5e-6, shape=(5, 6), name="oil")
    return dataclasses.replace(plain, **changes)


@pytest.fixture(scope="module")
def facts():
    return microscope_quality(microscope(planes=3, step=0.3e-6))


def test_the_foci_are_those_of_the_objective_and_of_its_published_table(facts):
    rows = {row["depth"]: row for row in facts["focus"]}
    assert list(rows) == sorted(DEPTHS)
    at = rows[5e-6]
    assert (at["brightest"], at["ratio"]) == (pytest.approx(6.342e-6, abs=1e-9), pytest.approx(0.788, abs=1e-3))
    assert (at["axial_fwhm"], at["peak"]) == (pytest.approx(1131e-9, abs=1e-9), pytest.approx(0.466, abs=1e-3))
    found = MATCHED.focus(5e-6, wavelength=610e-9)
    assert (at["paraxial"], at["lateral_fwhm"]) == (found.paraxial, found.lateral_fwhm)
    assert at["peak_of_surface"] == pytest.approx(at["peak"] / rows[0.0]["peak"])
    assert (rows[0.0]["ratio"], rows[0.0]["peak_of_surface"]) == (None, 1.0)
    assert rows[0.0]["collected"] == MATCHED.collected(0.0, wavelength=610e-9) > 1.3


def test_angles_and_sampling_are_those_of_the_objective(facts):
    assert math.sin(facts["critical_angle"]) == pytest.approx(1.33 / 1.515)
    assert math.sin(facts["rim_angle"]) == pytest.approx(1.4 / 1.515)
    assert facts["nyquist"]["lateral"] == pytest.approx(610e-9 / 5.6)
    assert facts["pixel_in_sample"] == 6.5e-6 / 63


@pytest.mark.parametrize(
    ("changes", "coarse"),
    [
        ({}, []),
        ({"pixel": 7e-6}, ["pixel"]),
        ({"planes": 3, "step": 0.4e-6}, ["step"]),
        ({"planes": 3, "step": -0.4e-6, "pixel": 7e-6}, ["pixel", "step"]),
        ({"planes": 1, "step": 0.4e-6}, []),
    ],
)
def test_what_is_sampled_too_coarsely_is_named(changes, coarse):
    assert microscope_quality(microscope(**changes))["too_coarse"] == coarse


def test_depths_out_of_reach_are_left_out_with_the_reason():
    near = dataclasses.replace(MATCHED, working_distance=10e-6)
    found = microscope_quality(microscope(objective=near))
    assert [row["depth"] for row in found["focus"]] == [0.0, 1e-6, 5e-6]
    assert len(found["refused"]) == 2
    assert found["refused"][0].startswith(
        "20 um deep: the stage position, set by focus or by depth and z, must be at most 10 um, where"
    )


def test_what_differs_from_the_design_is_told():
    thick = dataclasses.replace(MATCHED, coverslip=lm.Layer(1.52, 180e-6))
    found = microscope_quality(microscope(objective=thick))
    assert found["coverslip"] == {"index": 1.52, "thickness": 180e-6}
    assert found["design"] == {"immersion": 1.515, "coverslip": {"index": 1.515, "thickness": 170e-6}}
    assert microscope_quality(microscope())["design"] is None


def test_what_cannot_be_computed_does_not_raise(lenses):
    instrument = lm.load_instrument(lenses["nifty-fifty"])
    near = dataclasses.replace(instrument, object_distance=-1.0)
    page = near._repr_html_()
    assert "object_distance must be" in page
    assert "<img" not in page


def test_a_blurred_image_has_no_focus_tolerance_and_the_reason_names_its_mtf(lenses):
    quality = ImageQuality(dataclasses.replace(lm.load_instrument(lenses["nifty-fifty"]), object_distance=1.5))
    with pytest.raises(
        ValueError, match=r"the focus tolerance needs an MTF of 0\.3 or more at half the Nyquist .* 0\.00296$"
    ):
        quality.focus_tolerance()
