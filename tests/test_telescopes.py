"""Apertures of telescopes: published areas and dimensions, and exact areas of what they are made of."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel import telescopes

NAMES = sorted(telescopes.DIAMETERS)


def area(stop: object, diameter: float) -> float:
    """Return the clear area, square metres."""
    return lm.Pupil(stop=stop).area * math.pi * (0.5 * diameter) ** 2


def segments(behind: lm.Segments) -> lm.Segments:
    """Return the segments without what is in front of them."""
    return lm.Segments(tuple(part.parts[0] for part in behind.shapes))


@pytest.mark.parametrize("name", NAMES)
def test_every_aperture_has_a_psf_with_a_bound_and_is_the_same_after_a_round_trip(name):
    pupil = lm.Pupil(stop=getattr(telescopes, name)())
    psf = lm.psf(pupil, 33, 0.5)
    assert psf.error_bound <= 1e-6
    assert lm.Pupil.from_dict(pupil.to_dict()) == pupil


def test_webb_has_its_published_areas():
    # McElwain et al. 2023, doi:10.1088/1538-3873/acada0: 25.4 m^2 clear; struts obscure 0.9 m^2 of the segments.
    clear, bare = area(telescopes.jwst(), 6.603464), area(segments(telescopes.jwst()), 6.603464)
    assert clear == pytest.approx(25.4, rel=0.02)
    assert bare - clear == pytest.approx(0.9, abs=0.05)
    # The formula of Gauss for the areas of the published corners.
    corners = (np.array(c) for c in telescopes._JWST)
    exact = sum(
        6 * 0.5 * abs(np.sum(c[:, 0] * np.roll(c[:, 1], -1) - c[:, 1] * np.roll(c[:, 0], -1))) for c in corners
    )
    assert bare == pytest.approx(exact, rel=1e-10)


def test_the_segments_of_webb_are_in_their_published_places():
    # Centres of A1, A2, B2 and C2, V2 and V3 in metres.
    centers = telescopes.jwst().centers * 0.5 * telescopes.DIAMETERS["jwst"]
    published = {0: (0.0, 1.3235), 1: (1.146185, 0.66175), 7: (2.281734, 1.31736), 13: (2.285926, 0.0)}
    for k, place in published.items():
        assert centers[k] == pytest.approx(place, abs=6e-3)


def test_the_elt_has_798_segments_within_its_published_width_and_hole():
    diameter = telescopes.DIAMETERS["elt"]
    bare = segments(telescopes.elt())
    assert len(bare.shapes) == 798
    assert area(bare, diameter) == pytest.approx(798 * 1.5 * math.sqrt(3.0) * 0.725**2, rel=1e-5)
    corners = np.concatenate([part.corners for part in bare.shapes]) * 0.5 * diameter
    # The construction proposal has 39.146 m between sides, and a hexagon of 9.4136 m in the middle.
    assert 2 * corners[:, 1].max() == pytest.approx(39.146, rel=0.005)
    assert 2 * np.hypot(*corners.T).min() == pytest.approx(9.4136, rel=0.02)
    vanes = area(bare, diameter) - area(telescopes.elt(), diameter)
    assert vanes == pytest.approx(6 * 0.4 * (19.5 - 4.9), rel=0.15)


def test_keck_has_36_segments_of_0_9_m_and_its_published_area():
    diameter = telescopes.DIAMETERS["keck"]
    whole = lm.Segments.hexagonal(3, 0.003 / (0.5 * diameter))
    assert area(whole, diameter) == pytest.approx(75.76, abs=0.01)  # 36 hexagons of 0.9 m
    side = np.diff(whole.shapes[0].corners[:2], axis=0)
    assert np.hypot(*side[0]) * 0.5 * diameter == pytest.approx(0.9, abs=2e-5)
    behind, bare = area(telescopes.keck(), diameter), area(whole - lm.Disc(2.65 / diameter), diameter)
    assert len(telescopes.keck().shapes) == 36
    # The secondary hides its disc less the hexagon that has no segment, whose sides gaps make longer.
    hole = 1.5 * math.sqrt(3.0) * (0.9 + 0.003 / math.sqrt(3.0)) ** 2
    gaps = 6 * 0.003 * (1.325 - 0.9)
    assert 75.76 - bare == pytest.approx(math.pi * 1.325**2 - hole - gaps, abs=0.02)
    # Vanes along x end at corners 4.507 m from the axis, and cover gaps that hide nothing more.
    assert bare - behind == pytest.approx(6 * (0.0254 * (4.507 - 1.325) - 0.003 * (0.9 + 1.803 - 1.325)), rel=0.01)


def test_hubble_loses_the_parts_of_tiny_tim():
    lost = 1.0 - 0.33**2 - lm.Pupil(stop=telescopes.hst()).area
    # Of three pads, all within the rim, one lies behind a vane.
    hidden = 2 * 0.065 * 0.022 * (1.0 - (0.011 / 0.065) ** 2 / 6.0) / math.pi
    assert (lost - 3 * 0.065**2 + hidden) * math.pi == pytest.approx(4 * 0.022 * (1.0 - 0.33), rel=1e-3)


@pytest.mark.parametrize(
    ("name", "radius", "hole", "width"), [("vlt", 4.0, 0.558, 0.040), ("subaru", 3.96, 1.15, 0.1735)]
)
def test_vanes_beside_the_axis_hide_about_their_length_times_their_width(name, radius, hole, width):
    clear, bare = lm.Pupil(stop=getattr(telescopes, name)()).area, 1.0 - (hole / radius) ** 2
    assert (bare - clear) * math.pi * radius**2 == pytest.approx(4 * width * (radius - hole), rel=0.09)


def test_the_vanes_of_the_vlt_meet_at_101_degrees_beside_the_axis():
    stop = telescopes.vlt()
    # From 0.4045 m / cos(39.5 deg) beside the axis at half of 101 degrees, as the pupil documentation has it.
    start = 0.4045 / math.cos(math.radians(39.5))
    for along in (0.8, 2.0, 3.2):
        x, y = start + along * math.cos(math.radians(50.5)), along * math.sin(math.radians(50.5))
        for sx, sy in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            assert float(stop.margin(np.array(sx * x / 4), np.array(sy * y / 4))) == pytest.approx(-0.005, abs=1e-9)
