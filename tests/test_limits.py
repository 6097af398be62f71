"""Limits and fine print, each on both sides of where it is said to be."""

from __future__ import annotations

import inspect
import itertools
import math

import numpy as np
import pytest

import lommel as lm
from lommel.base import validation
from lommel.base.encoding import clipped_fraction
from lommel.core import engine
from lommel.measures import aperture_means
from lommel.methods import NijboerZernike
from lommel.optics.grid import Grid


def test_a_pixel_may_be_as_wide_and_as_narrow_as_the_message_says():
    for good in (1e-4, 1.0, 1e6):
        validation.pixel_on(good, 1.0, metric=False)
    for bad in (0.99e-4, 1.01e6):
        with pytest.raises(ValueError, match="from 1e-4 to 1e6"):
            validation.pixel_on(bad, 1.0, metric=False)
    validation.pixel(0.1, metric=True)
    with pytest.raises(ValueError, match=r"at most 0\.1"):
        validation.pixel(0.1001, metric=True)


def test_an_answer_may_have_as_many_values_as_the_docstring_says(monkeypatch):
    assert validation.MAX_VALUES == 2**31
    assert "2^31 values" in lm.psf.__doc__
    monkeypatch.setattr(validation, "MAX_VALUES", 100)
    assert lm.psf(lm.Pupil(), (10, 10), 0.5).values.size == 100
    with pytest.raises(ValueError, match="makes 110 values, more than the limit of 100"):
        lm.psf(lm.Pupil(), (10, 11), 0.5)
    with pytest.raises(ValueError, match="makes 108 values"):
        lm.psf(lm.Pupil(lm.Wavefront([1.0, 2.0])), (9, 6), 0.5)


def test_a_series_takes_6000_nodes_and_no_more():
    assert lm.psf(lm.Pupil(lm.Wavefront(1e4)), 1, 0.5, method=NijboerZernike(1e-4)).values.shape == (1, 1)
    with pytest.raises(ValueError, match=r"[67]\d{3} nodes, more than the limit of 6000"):
        lm.psf(lm.Pupil(lm.Wavefront(1.4e4)), 1, 0.5, method=NijboerZernike(1e-4))


def test_the_strehl_ratio_is_refined_by_two_fifths_until_two_quadratures_agree_to_1e_12(monkeypatch):
    """Quadratures that are off by less and less, put before the true ones: the last two must agree."""
    rule, seen, off = aperture_means._rule, [], [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 0.0, 0.0]

    def worse(pupil, power, radial, around):
        seen.append(radial)
        nodes = rule(pupil, power, radial, around)
        return nodes._replace(weight=nodes.weight * (1.0 + off[len(seen) - 1]))

    exact = lm.strehl(lm.Pupil(lm.Wavefront(0.7)))
    assert exact == pytest.approx(np.sinc(0.7 / np.pi) ** 2, rel=1e-13)
    monkeypatch.setattr(aperture_means, "_rule", worse)
    assert lm.strehl(lm.Pupil(lm.Wavefront(0.7))) == pytest.approx(exact, rel=1e-14)
    assert len(seen) == len(off)
    assert all(later >= 1.39 * earlier for earlier, later in itertools.pairwise(seen))


@pytest.mark.parametrize(("a", "b"), [(1.0, 0.6), (0.15, 0.1)])
def test_the_rms_over_an_ellipse_counts_the_middle_as_it_is(a, b):
    pupil = lm.Pupil(lm.Wavefront(3.0), vignetting=lm.Ellipse(a, b))
    variance = (a**4 + b**4) / 8 + a**2 * b**2 / 12 - (a**2 + b**2) ** 2 / 16
    assert lm.rms(pupil) == pytest.approx(6.0 * math.sqrt(variance), rel=1e-11)


def test_the_axis_of_a_window_that_is_not_square_is_centred_where_both_coordinates_are():
    assert Grid((8, 5), 1.0).centered
    assert Grid((8, 5), 1.0, center=(4, 2)).centered
    for center in ((2, 4), (4, 4), (2, 2), (4, 2.5)):
        assert not Grid((8, 5), 1.0, center=center).centered


def test_images_unfold_around_the_middle_of_even_and_odd_sides():
    quadrant = np.arange(9.0).reshape(3, 3)
    expected = [[8, 7, 6, 7, 8], [5, 4, 3, 4, 5], [2, 1, 0, 1, 2], [5, 4, 3, 4, 5]]
    assert np.array_equal(Grid((4, 5), 1.0).unfold(quadrant), expected)
    assert np.array_equal(Grid((5, 4), 1.0).unfold(quadrant.T).T, expected)


def test_light_counts_as_clipped_from_a_whole_level_on():
    for kind in (np.uint8, np.uint16):
        level = 1.0 / np.iinfo(kind).max
        light = np.array([0.5, 1.0 + 0.9 * level, 1.0 + 1.1 * level, -0.9 * level, -1.1 * level])
        assert clipped_fraction(light, kind) == 0.4
    assert clipped_fraction(np.array([-5.0, 5.0]), np.float32) == 0.0


@pytest.mark.parametrize(("far", "hidden"), [(3.0, 2), (1.0, 4), (-3.0, 8)])
def test_what_a_near_edge_hides_is_as_wide_as_the_radii_differ(far, hidden):
    radius = np.full((3, 30), 6.0)
    radius[:, 15:] = far
    layers, behind = np.empty(radius.shape, np.uint8), np.empty(radius.shape, np.int32)
    # Defocus stands for the radius here; layers are half a pixel of it thick.
    ends = np.array([-10.0, 10.0])
    assert engine.depth_layers(radius, *ends, ends, 0.5, 64, 1, layers, behind) == (2, 3 * hidden)
    # The nearest far point is a pixel beyond the last near one.
    assert np.array_equal(behind[1] >= 0, (np.arange(30) >= 15 - hidden) & (np.arange(30) < 15))


def test_transfer_functions_are_exact_to_the_tolerance_that_is_named_and_that_is_1e_10():
    pupil = lm.Pupil(lm.Wavefront(3.0, -2.0, nonradial={(3, 1): 1.0}))
    f = np.linspace(0.05, 0.9, 9) * pupil.cutoff
    exact = lm.otf(pupil, f, 0.3 * f, tol=1e-13)
    assert np.abs(lm.otf(pupil, f, 0.3 * f) - exact).max() <= 1e-10
    for function in (lm.otf, lm.mtf):
        assert inspect.signature(function).parameters["tol"].default == 1e-10


@pytest.mark.parametrize(("defocus", "level"), [(12.0, 0.1), (40.0, 0.05)])
def test_the_lowest_frequency_is_found_of_many_at_which_the_contrast_falls_to_a_level(defocus, level):
    pupil = lm.Pupil(lm.Wavefront(defocus))
    f = np.linspace(0.0, 0.5, 501) * pupil.cutoff
    below = np.flatnonzero(lm.mtf(pupil, f, tol=1e-6) <= level)
    assert below[-1] + 1 - below[0] > 1
    found = lm.mtf_frequency(pupil, level)
    assert f[below[0] - 1] <= found <= f[below[0]]


@pytest.mark.parametrize("center", [(4.0, 14.0), (-6.0, 4.0), (-5.0, -7.0)])
def test_the_light_in_a_window_beside_the_axis_is_that_of_its_pixels(center):
    answer = lm.psf(lm.Pupil(lm.Wavefront(9.0)), (9, 9), 0.4, center=center, dtype=np.float64)
    assert answer.energy == pytest.approx(answer.values.sum(), rel=0.01)
