"""What is known of microscopes: the numbers are those of the objective."""

from __future__ import annotations

import dataclasses
import math

import pytest

import lommel as lm
from lommel.lensfiles.microscope_files import Microscope
from lommel.lensfiles.microscope_quality import DEPTHS, microscope_quality
from objectives import MATCHED


def microscope(**changes) -> Microscope:
    plain = Microscope("oil", "", MATCHED, 610e-9, 5e-6, 6.5e-6, lm.Dipole(0.0, 0.0, wobble=1.0), shape=(5, 6))
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
        "20 um deep: focus, or where depth and z lead, must be at most 10 um, where"
    )


def test_what_differs_from_the_design_is_told():
    thick = dataclasses.replace(MATCHED, coverslip=lm.Layer(1.52, 180e-6))
    found = microscope_quality(microscope(objective=thick))
    assert found["coverslip"] == {"index": 1.52, "thickness": 180e-6}
    assert found["design"] == {"immersion": 1.515, "coverslip": {"index": 1.515, "thickness": 170e-6}}
    assert microscope_quality(microscope())["design"] is None


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"planes": 0}, "planes must be from 1 to 4096, got 0"),
        ({"planes": 2}, "step must be of the stage, not 0 and below 10 mm, got 0 m"),
        ({"planes": 2, "step": 1.0}, "got 1 m"),
        ({"planes": 2, "step": math.nan}, "step must be finite"),
        ({"planes": 2.5}, "planes must be an integer"),
    ],
)
def test_a_microscope_without_planes_or_steps_is_refused(changes, said):
    with pytest.raises((TypeError, ValueError), match=said):
        microscope(**changes)
