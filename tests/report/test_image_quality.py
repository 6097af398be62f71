"""Numbers of instruments of files, and how they are shown."""

from __future__ import annotations

import dataclasses
import json
import math
import re

import pytest

import lommel as lm
from lommel.lensfiles.microscope_files import Microscope
from lommel.report.image_quality import DEPTHS, image_quality, microscope_quality, setup
from objectives import MATCHED


@pytest.fixture(scope="module")
def phone(lenses):
    return dataclasses.replace(lm.load_instrument(lenses["phone"]), object_distance=1.2, pixel=(2e-6, 3e-6))


def test_numbers_are_those_of_the_library_in_both_directions(phone):
    quality, pupil = image_quality(phone), phone.pupil()
    assert quality["mtf50_y"] == pytest.approx(float(lm.mtf_frequency(pupil, angle=0.5 * math.pi)))
    assert quality["mtf_at_nyquist_with_pixel"] == float(lm.mtf(pupil, quality["nyquist"], pixel=(2e-6, 3e-6)))
    in_y = float(lm.mtf(pupil, 0.0, quality["nyquist_y"], pixel=(2e-6, 3e-6)))
    assert quality["mtf_at_nyquist_with_pixel_y"] == pytest.approx(in_y)
    ends = [quality["in_focus"][name] for name in ("near", "far")]
    blur = [2.0 * float(phone.lens.pupil(end).geometric_radius()) for end in ends]
    assert blur == pytest.approx([6e-6, 6e-6])


def test_what_is_missing_has_a_reason(phone, monkeypatch):
    def refuse(pupil, angle):
        raise ValueError("takes too long")

    monkeypatch.setattr("lommel.report.image_quality.mtf50", refuse)
    found = json.loads(json.dumps(image_quality(phone), allow_nan=False))
    assert found["refused"] == ["takes too long"]
    assert found["mtf50"] is found["mtf50_y"] is None


def test_telescopes_and_microscopes_have_no_depth_of_field(lenses):
    for name in ("hubble-1990", "microscope-20x"):
        found = setup(lm.load_instrument(lenses[name]))
        assert found["in_focus"] is found["hyperfocal_distance"] is None


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


def test_a_blurred_image_has_no_focus_tolerance_and_the_reason_names_its_mtf(lenses):
    found = image_quality(dataclasses.replace(lm.load_instrument(lenses["nifty-fifty"]), object_distance=1.5))
    assert found["focus_tolerance"] is None
    (reason,) = found["refused"]
    assert re.search(r"the focus tolerance needs an MTF of 0\.3 or more at half the Nyquist .* 0\.00296$", reason)
