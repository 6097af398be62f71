"""Tables of the engine of microscopes: what lies between radii, one asked for after another, and what is stored."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.core.answers import Wanted
from lommel.core.engine import Window, layered_images
from lommel.methods.layers.stratified import layered
from objectives import OIL


def planes(**given):
    return OIL.pupil(depth=2e-6, z=[-0.6e-6, 0.1e-6], wavelength=520e-9, **given)


def corner(side, step):
    """How far the corner of a window is from its middle."""
    return float(np.hypot(side // 2, side // 2)) * step


def test_what_is_between_radii_is_off_by_no_more_than_is_said():
    # Of fields that are exact all error is that of polynomials.
    pupil, side, step = planes(), 65, 0.61
    asked = layered(pupil, corner(side, step), 1e-13)
    made = layered_images(asked, Window((side, side), (32.0, 32.0), step), 3e-2, Wanted(1.0, np.float64))
    line = lm.DebyeWolf(1e-12).profile(pupil, step * np.arange(33.0)).values
    off = np.abs(made.values[:, 32, 32:] - line).max(axis=1)
    assert np.all(off <= made.error * made.peak)
    assert off.max() > 1e-8


def test_windows_of_two_pitches_do_not_share_what_is_between_their_radii():
    pupil = planes()
    for pixel in (6.5e-6, 6.49e-6, 6.5e-6):
        made = lm.psf(pupil, 65, pixel, integrate=False, normalize="strehl", dtype=np.float64)
        exact = lm.DebyeWolf(1e-9).profile(pupil, pupil.v(pixel * np.arange(33.0))).values
        assert np.all(np.abs(made.values[:, 32, 32:] - exact).max(axis=1) <= 1e-6 * exact.max(axis=1))


def test_the_last_radius_is_in_the_last_piece_however_it_rounds():
    pupil, side = planes()[:1], 49
    steps = 0.55 + 0.0137 * np.arange(60)
    asked = layered(pupil, corner(side, steps[-1]), 1e-9)
    exact = lm.DebyeWolf(1e-9).profile(pupil, np.array([corner(side, step) for step in steps])).values[0]
    for step, known in zip(steps, exact, strict=True):
        window = Window((side, side), (24.0, 24.0), float(step))
        made = layered_images(asked, window, 1e-9, Wanted(1.0, np.float64))
        assert abs(made.values[0, 0, 0] - known) <= 1e-8


def test_a_longer_table_of_bessel_functions_follows_a_shorter_one():
    pupil = planes()
    for far in (600.0, 1500.0):
        v = np.array([0.0, 0.9 * far, far])
        made, exact = (way(1e-9).profile(pupil, v).values for way in (lm.Stratified, lm.DebyeWolf))
        assert made == pytest.approx(exact, abs=1e-10)
        assert exact[:, 2].min() > 1e-9


def test_what_storing_adds_is_counted():
    made = {kind: lm.psf(planes(), 33, 6.5e-6, integrate=False, dtype=kind).error_bound for kind in ("f4", "f8")}
    assert made["f4"] >= made["f8"] + 2.0**-24
