"""What methods ask of one another, where they accept it, and the terms of their bounds, a second time."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import NamedTuple

import numpy as np
import pytest

import lommel as lm
from lommel.core.answers import FieldValues, Intensities, Samples, ToleranceError, Wanted
from lommel.core.engine import band_points, least_average, transfer_rule
from lommel.methods import (
    ChordalGauss,
    Hankel,
    NijboerZernike,
    NonuniformFFT,
    Polychromatic,
    averaging,
    nonuniform_fft,
    polychromatic,
)
from lommel.methods import method as method_module
from lommel.methods.averaging import Taps, averaging_filter, fit_pair_weights, fit_taps, slope_filter
from lommel.methods.method import annulus, relative_error, with_model_error
from lommel.methods.question import checked_method, output_type
from lommel.optics.grid import Grid
from lommel.paper import Geometric

U, SINGLE = 2.0**-53, 2.0**-24
STORED = {np.float64: 6.0 * U, np.float32: 6.0 * U + SINGLE}


def sinc(step):
    return lambda w: np.sinc(0.5 * step / math.pi * w)


@pytest.mark.parametrize(("scale", "count"), [(1.0, 3), (1.0, 6), (1.0, 30), (1e-2, 24), (1e-17, 3)])
def test_the_mean_error_of_a_response_is_that_of_its_weighted_least_squares(scale, count):
    """Of two responses of the mean error m the product is off by m (2 + e) on average, e the largest error."""
    x, root2 = 0.8 * np.arange(count), math.sqrt(2.0)
    c, error, gain = fit_taps(lambda w: scale * sinc(2.0)(w), np.cos, x, in_mean=True)
    twice = np.where(x > 0.0, 2.0, 1.0)
    assert gain == pytest.approx((twice * np.abs(c)).sum(), rel=1e-12)

    def missed(w):
        return np.cos(np.outer(w, x)) @ (twice * c) - scale * sinc(2.0)(w)

    rounding, points = 2.0 * U * (count + 3) * gain, band_points(x[-1])
    nodes, weights = transfer_rule(points.size)
    mean = math.sqrt((weights * missed(nodes) ** 2).sum())
    largest = root2 * (np.abs(missed(points)).max() + rounding) + 1e-17
    # What rounding leaves is known no better than a hundredth of the bound.
    close = {30: 1e-2, 24: 1e-2}.get(count, 1e-6)
    assert error == pytest.approx((1.0 + 0.5 * largest) * (mean + 2.0 * rounding + 1e-17), rel=close, abs=0.0)


@pytest.mark.parametrize(("made", "most", "start"), [
    (lambda: averaging_filter(3.3, 1e-4), 1.5, 4), (lambda: averaging_filter(3.3, 1e-4, by_pitch=True), 3.0, 4),
    (lambda: slope_filter(3.3, 1e-4, averages=True), 6.0, 4),
    (lambda: fit_pair_weights(sinc(3.3), 3.3, 1e-4, 7), 1.5, None),
])  # fmt: skip
@pytest.mark.parametrize(("error", "gain", "taken"), [
    (1e-4, 1.0, True), (1.001e-4, 1.0, False), (1e-4, 1.001, False), (0.5e-4, 0.5, True),
])  # fmt: skip
def test_filters_are_made_longer_until_error_and_gain_are_within_their_limits(
    made, most, start, error, gain, taken, monkeypatch
):
    sides = []

    def fit(response, wave, x, **_):
        sides.append(x.size - 1 if x[0] == 0.0 else x.size)
        return np.ones(x.size), error, gain * most

    monkeypatch.setattr(averaging, "fit_taps", fit)
    averaging_filter.cache_clear()
    slope_filter.cache_clear()
    found = made()
    averaging_filter.cache_clear()
    slope_filter.cache_clear()
    # Half of the samples per pixel and two more; given up 60 samples beyond a pixel, or beyond two.
    stride, most_side = (7, 68) if start is None else (4, 65)
    assert start is None or (sides[0], found.stride, found.error, found.gain) == (start, stride, error, gain * most)
    assert sides[-1] == sides[0] if taken else sides[-1] == most_side
    assert np.unique(sides).tolist() == list(range(sides[0], sides[-1] + 1))


@pytest.mark.parametrize("in_mean", [False, True])
@pytest.mark.parametrize(("step", "error", "s"), [
    (1.0, 1e-12, 2), (3.0, 1e-9, 6), (3.0, 1e-11, 5), (9.0, 1e-11, 15), (30.0, 0.02, 58), (9.0, 1e-12, 16),
])  # fmt: skip
def test_the_first_length_of_a_filter_is_about_the_shortest_that_serves(step, error, s, in_mean):
    h, side = 2.0 * step / s, s // 4
    halves = (0.0, 0.5) if s % 2 else (0.0,)
    fits = [(math.inf, 0.0)]
    while max(e for e, _ in fits) > error or max(g for _, g in fits) > 1.5:
        side += 1
        fits = [
            fit_taps(sinc(step), np.cos, h * (np.arange(side + (not half)) + half), in_mean=in_mean)[1:]
            for half in halves
        ]
    assert abs(averaging._half_length(step, error, s, in_mean=in_mean) - side) <= 2 + side // 8


@pytest.mark.parametrize("in_mean", [False, True])
@pytest.mark.parametrize("step", [0.2, 0.63, 1.0, 1.9, 3.0, 4.9, 6.2])
@pytest.mark.parametrize("side", [4, 60, 400])
def test_pixels_share_as_many_samples_as_are_cheapest(step, side, in_mean):
    error, most, stride = 1e-7, 0.5 * math.pi if in_mean else 1.27, math.ceil(step / 1.05)
    costs = {}
    for count in range(2, 2 * stride + 1):
        if 2.0 * step / count <= most and (count % 2 == 0 or 2.0 * step / count <= 1.27):
            taps = 2 * averaging._half_length(step, error, count, in_mean=in_mean)
            across = 0.5 * count * side + taps
            # Samples, and a fiftieth for each weight of each pixel along both axes.
            costs[count] = across**2 + (0.02 * taps * side * (across + side) if in_mean else 0.0)
    best = min(costs, key=costs.get)
    found = averaging.pair_stride(step, error, stride, (side, side), in_mean=in_mean)
    assert found == (best if costs[best] < (1.0 if in_mean else 0.85) * costs[2 * stride] else 2 * stride)


def test_an_even_number_of_shared_samples_is_twice_that_of_a_pixel(monkeypatch):
    for step in (0.4, 1.1, 2.9, 4.7, 6.0, 9.3):
        for half in range(math.ceil(step / 1.05), 12):
            monkeypatch.setattr(averaging, "pair_stride", lambda *_, half=half, **__: 2 * half)
            averaging._cheapest_filter.cache_clear()
            assert averaging._cheapest_filter(step, 1e-3, (5, 5), in_mean=False).stride == half
    averaging._cheapest_filter.cache_clear()


def test_dark_samples_are_as_bright_as_their_rounding_allows():
    """2 (n + 4) roundings of the squared gain; where all samples are dark enough, no sample is too bright."""
    rounded = 2.0 * (9 + 4) * SINGLE * 1.3**2
    taps = Taps(3, np.ones(9), 0.0, 1.3)
    for share in (1e-3, 0.999):
        assert averaging._dark_samples(taps, share * rounded) == pytest.approx((share * rounded, share), rel=1e-12)
    error, limit = averaging._dark_samples(taps, 1.001 * rounded)
    assert error == pytest.approx(rounded, rel=1e-12)
    assert limit >= 1e30


@pytest.mark.parametrize("kind", [np.float64, np.float32])
@pytest.mark.parametrize("scale", [None, 1.0])
@pytest.mark.parametrize("tol", [1e-12, 1e-6, 0.05])
def test_what_averages_may_be_off_by_is_what_storing_leaves(tol, scale, kind):
    if tol < STORED[kind]:
        return
    wanted = Wanted(scale, kind)
    allowed = averaging.error_before_storing(tol, wanted)
    kept = averaging.stored_error(np.array([allowed]), wanted)[0]
    assert kept <= tol
    assert scale is None or kept == pytest.approx(tol, rel=1e-9 if kind is np.float64 else 1e-6)
    assert scale is not None or allowed == pytest.approx(0.4 * averaging.error_before_storing(tol, Wanted(1.0, kind)))


def asked_of_samples(pupil, grid, tol, errors, value=0.5, top=0.6, wanted=None):
    """Return averages of samples that err by these multiples of what is asked of each, and what that was."""
    asked, wanted = [], Wanted(scale=1.0) if wanted is None else wanted

    def sample(one, fine, least, request):
        asked.append((least, request.dtype))
        off = np.full(1, errors[min(len(asked), len(errors)) - 1] * least)
        return Samples(np.full((1, *fine.shape), value), np.ones(1), off, None, np.array([top]))

    return averaging.pixel_averages(sample, pupil, grid, tol, wanted), asked


@pytest.mark.parametrize(("tol", "times"), [(1e-9, 7.0), (1e-4, 7.0)])
def test_samples_are_asked_for_as_much_more_as_their_error_exceeds_its_half(tol, times):
    pupil, grid, value, top = lm.Pupil(obscuration=0.3), Grid(3, 0.4), 0.5, 0.6
    made, asked = asked_of_samples(pupil, grid, tol, [times, 0.1])
    step, own = grid.step(pupil), tol - (1.0 + tol) * STORED[np.float64]
    lowest = least_average(step)
    ease = 2.0 ** math.floor(math.log2(64.0 * pupil.amplitude**2))
    first = 0.5 * own * min(4.0 * lowest, 1.0)
    taps = averaging._cheapest_filter(step, ease * 2e-3 * own * lowest, (3, 3), in_mean=True)
    assert asked[0][0] == pytest.approx(first / taps.gain**2, rel=1e-9)
    excess = times * first * top / max(value, lowest * top * (1.0 - times * asked[0][0])) / (0.5 * own)
    # In single precision once more, as exact as it may be; in double by what it was too much.
    second = 0.9 * 2e-7 if tol > 1e-6 else first / excess
    assert asked[1][0] == pytest.approx(second / taps.gain**2, rel=1e-4)
    assert [kind == np.float32 for _, kind in asked] == [tol > 1e-6, False]
    assert len(asked) == 2
    assert made.error[0, 0] <= tol


def test_a_filter_is_made_a_fifth_as_wrong_as_the_dimmest_average_allows(monkeypatch):
    """Averages of 1e-3 of the peak, for which the first filter is too coarse."""
    pupil, grid, tol, asked = lm.Pupil(obscuration=0.3), Grid(3, 0.4), 1e-6, []
    choose = averaging._choose_filters
    monkeypatch.setattr(
        averaging,
        "_choose_filters",
        lambda step, error, *more, **one: asked.append(error) or choose(step, error, *more, **one),
    )
    made, _ = asked_of_samples(pupil, grid, tol, [1e-3], 1e-3, 0.6, Wanted(None))
    step, own = grid.step(pupil), 0.4 * (tol - (1.0 + tol) * STORED[np.float64])
    taps = choose(step, asked[0], 1.05, (3, 3), gradients=False, in_mean=True)[0]
    rounding = (2 * taps.weights.shape[-1] + 8) * U * taps.gain**2
    added = ((2.0 + taps.error) * taps.error + rounding * 0.6) / made.peak[0]
    assert asked[1] == pytest.approx(asked[0] * 0.2 * own / added, rel=1e-3)
    assert asked[1] < asked[0]


@pytest.mark.parametrize("bound", [None, 1e-3])
def test_a_bound_of_samples_is_told_as_that_of_averages(bound):
    asked, tol = [], 1e-5

    def sample(one, fine, least, wanted):
        asked.append(least)
        fault = ToleranceError("no")
        fault.bound = bound
        raise fault

    with pytest.raises(ToleranceError, match="cannot be met by averages") as refused:
        averaging.pixel_averages(sample, lm.Pupil(), Grid(3, 0.4), tol, Wanted(1.0))
    assert len(asked) == 2
    assert refused.value.bound == (math.inf if bound is None else pytest.approx(tol * bound / asked[-1], rel=1e-12))


def test_all_the_light_that_a_stack_is_made_of_counts(monkeypatch):
    """Dark is what is dark for the faintest pupil; single precision serves from 2e-7 on."""
    taps, pupil, asked, dark = averaging_filter(1.3, 1e-6), lm.Pupil(lm.Wavefront([0.0, 1.0])), [], []
    monkeypatch.setattr(averaging, "average_samples", lambda *_, dark=0.0: seen.append(dark))

    def sample(one, fine, least, wanted):
        asked.append(wanted.dtype)
        return Samples(np.ones((2, *fine.shape)), np.ones(2), np.array([0.1, 0.2]), None, np.array([3.0, 0.5]))

    for tol in (2e-7, 0.999 * 2e-7):
        seen = dark
        _, error, peaks = averaging._average_stack(sample, pupil, Grid(3, 0.4), tol, taps, Wanted(), 0.25)
        assert error[0] == pytest.approx(taps.gain**2 * np.array([0.3, 0.1]), rel=1e-12)
        assert peaks[0] == pytest.approx([2.7, 0.4], rel=1e-12)
    assert asked == [np.float32, np.float64]
    assert dark == pytest.approx([0.125, 0.125])


@pytest.mark.parametrize("tol", [1e-12, 1e-6, 0.09])
def test_gradients_ask_samples_for_what_averages_do_first(tol):
    pupil, grid, asked = lm.Pupil(obscuration=0.3), Grid(3, 0.4), []

    def gradient(one, fine, least, weights):
        asked.append(least)
        return np.zeros((1, 2))

    averaging.averaged_gradient(gradient, pupil, grid, tol, np.ones((1, 3, 3)))
    own, lowest = tol - (1.0 + tol) * STORED[np.float64], least_average(grid.step(pupil))
    taps = averaging_filter(grid.step(pupil), 2e-3 * own * lowest)
    assert asked == [pytest.approx(0.5 * own * min(4.0 * lowest, 1.0) / taps.gain**2, rel=1e-9)]


@pytest.mark.parametrize("pixel", [0.2, 3.0, 40.0])
@pytest.mark.parametrize("tol", [1e-4, 1e-7])
def test_far_pixels_begin_where_rings_are_what_they_may_be_off_by(pixel, tol, monkeypatch):
    """Averages of rings 4 / (pi v^3), as light as A(1)^2, against seven tenths of the tolerance."""
    monkeypatch.setattr(averaging, "largest_far_start", lambda *_: 1.0)
    pupil, grid = lm.Pupil(obscuration=0.3, apodization=0.5), Grid(9, pixel)
    v, step = averaging.estimate_far_start(pupil, grid, tol), grid.step(pupil)
    rings = 4.0 / math.pi * math.exp(-1.0) / v**3 * min(1.0, math.sqrt(2.0) / step)
    peak = min(1.0, 4.0 * math.pi * pupil.transmission / step**2)
    assert rings == pytest.approx(0.7 * tol * peak, rel=1e-9)


@pytest.mark.parametrize("wanted", [Wanted(terms=((2, 0),)), Wanted(powers=(1,)), Wanted(), Wanted(1.0, np.float32)])
def test_far_pixels_are_of_intensities_in_large_windows(wanted):
    """Neither of derivatives nor where they would save nothing; nor where storing alone exceeds the tolerance."""
    side, tol = (2000, 1e-12) if wanted != Wanted() else (9, 1e-6)
    assert averaging._near_and_far(None, None, lm.Pupil(), Grid(side, 1.0, integrate=True), tol, wanted) is None


OF_TOLERANCES = [(NijboerZernike, 1e-6, 1e-12, 1e-1), (ChordalGauss, 1e-6, 1e-12, 1e-1)]
OF_TOLERANCES += [(NonuniformFFT, 1e-6, 1e-12, 1e-1), (Hankel, 1e-14, 1e-15, 1e-2)]


@pytest.mark.parametrize(("kind", "default", "least", "most"), OF_TOLERANCES)
def test_tolerances_go_from_the_least_to_below_the_largest(kind, default, least, most):
    kept = kind is not Hankel
    assert (kind().tol, kind.keeps_tol, kind(least).tol, kind(0.999 * most).tol) == (
        default,
        kept,
        least,
        0.999 * most,
    )
    for tol in (0.999 * least, most):
        with pytest.raises(ValueError, match="tol must be"):
            kind(tol)
    assert type(kind(np.float32(1e-3)).tol) is float
    # Halved, or as they are told to be, but none below the least; where they promise nothing they stay as they are.
    asked = [kind(1e-3).tightened(*of).tol for of in ((), (1e-5,), (0.1 * least,))]
    assert asked == pytest.approx([5e-4, 1e-5, least] if kept else [1e-3] * 3)
    assert kind(least).tightened() == kind(least)
    assert Geometric().tightened(1e-3) == Geometric()


def test_questions_have_the_tolerance_of_their_method_and_the_type_that_holds_it():
    assert checked_method(None, None, None) == (None, 1e-6)
    assert checked_method(Hankel(1e-3), None, None) == (Hankel(1e-3), 1e-3)
    assert checked_method(Hankel(1e-3), 1e-4, None) == (Hankel(1e-4), 1e-4)
    made = (lambda tol: checked_method(None, tol, None)[1], lambda tol: Polychromatic([5e-7], tol=tol).tol)
    for tol_of in made:
        assert [tol_of(tol) for tol in (1e-12, 0.0999)] == [1e-12, 0.0999]
        for tol in (0.999e-12, 0.1):
            with pytest.raises(ValueError, match="tol must be"):
                tol_of(tol)
    assert [output_type(None, tol) for tol in (1e-6, 0.999e-6)] == [np.float32, np.float64]
    assert [output_type(kind, 2.0**-22) for kind in (np.float32, np.float64)] == [np.float32, np.float64]
    assert output_type(np.float64, 1e-12) == np.float64
    with pytest.raises(ValueError, match="float32 cannot hold"):
        output_type(np.float32, 0.999 * 2.0**-22)
    assert Polychromatic([5e-7], method=Geometric(), tol=1e-6).method == Geometric()
    assert Polychromatic([5e-7], method=NijboerZernike(1e-3)).tol == 1e-3


@dataclass(frozen=True)
class Known(lm.methods.Method):
    """Errs by what it is told to."""

    tol: float = 1e-6
    errors: tuple[float, ...] | None = (1e-7, 1e-6)
    asked: list[float] = field(default_factory=list)

    def intensity(self, pupil, grid, threads):
        self.asked.append(self.tol)
        errors = None if self.errors is None else np.array(self.errors) * (1.0 if len(self.asked) == 1 else 1e-3)
        return Intensities(np.full((2, 1), 0.5), errors, np.ones(2))


class Vague(Known):
    keeps_tol = False


@pytest.mark.parametrize("scale", [None, 1.0])
@pytest.mark.parametrize("over", [-1, 0, 1])
def test_images_are_done_again_where_the_worst_of_them_exceeds_the_tolerance(scale, over):
    """A value divided by the largest one is off twice as far, so that it has to be a quarter rather than half."""
    once = 1e-7 if scale else 2e-7 / (1.0 - 1e-7)
    tol = float(once + (1.0 + once) * STORED[np.float64])
    tol = tol if over == 0 and scale else tol * (1.0 - 1e-6 * over)
    grid, wanted = Grid(1, 0.5), Wanted(scale, np.float64)
    found, pupil = Known(tol, (1e-9, 1e-7)), lm.Pupil()
    images = found.images(pupil, grid, wanted)
    again = over > 0
    assert images.error[1] == pytest.approx(tol * (1e-3 if again else 1.0), rel=1e-5)
    assert found.asked == pytest.approx([tol, tol / (2.0 if scale else 4.0)] if again else [tol], rel=1e-12)
    vague = Vague(tol, (1e-9, 1e-3))
    assert vague.images(pupil, grid, wanted).error[1] > tol
    assert len(vague.asked) == 1
    assert Known(tol, None).images(pupil, grid, wanted).error is None
    with pytest.raises(ToleranceError, match="cannot be met"):
        Known(1e-12, (1e-9, 1e-7)).images(pupil, grid, wanted)


@pytest.mark.parametrize(("side", "center", "edges", "period"), [
    (5, None, False, 2.0), (5, None, True, 2.5), (4, None, False, 1.5), (4, None, True, 2.0), (5, (2, 3), False, 3.0),
    (4, (1.5, 1.5), False, 1.5), (4, (1.5, 1.5), True, 2.0), (4, (2, 3), False, 2.5), (5, (2, 3), True, 3.5),
])  # fmt: skip
def test_windows_may_be_as_wide_as_the_period(side, center, edges, period):
    """Pixels of half a unit: none twice, and none farther out than half a period; even windows half a pixel more."""
    pupil, grid = SimpleNamespace(scale=2.0), Grid(side, 1.0, center=center)
    method_module.require_period(period * (1.0 - 0.8e-9), pupil, grid, edges=edges)
    with pytest.raises(ValueError, match="stay within half"):
        method_module.require_period(period * (1.0 - 1.9e-9), pupil, grid, edges=edges)


@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_a_window_divided_by_its_largest_value_is_asked_for_half_of_what_storing_leaves(kind, monkeypatch):
    asked, pupil, grid = [], lm.Pupil(), Grid((4, 5), 0.5, center=(1.3, 2.2))
    answer = Intensities(np.ones((1, 4, 5)), np.full(1, 1e-9), np.ones(1))
    monkeypatch.setattr(Hankel, "on_pixels", lambda self, *_, **of: asked.append((of["tol"], of["window"])) or answer)
    monkeypatch.setattr(polychromatic, "sum_wavelengths", lambda *of: asked.append((of[4], *of[5:])) or [answer])
    white, coloured = Polychromatic([5e-7]), lm.Pupil(wavelength=5e-7, f_number=4.0)
    grid5 = Grid((4, 5), 1e-6)
    Hankel(1e-3).images(pupil, grid, Wanted(None, kind))
    white.images(coloured, grid5, Wanted(None, kind))
    white.images(coloured, grid5, Wanted(1.0, kind))
    white.intensity(coloured, grid5, 1)
    stored = 1.1 * STORED[kind]
    halves = [(0.48 * (1e-3 - stored), True), (0.48 * (1e-6 - stored), True), (1e-6 - stored, False), (1e-6, False)]
    assert [tol for tol, _ in asked] == pytest.approx([tol for tol, _ in halves], rel=1e-12)
    assert [window for _, window in asked] == [window for _, window in halves]


@pytest.mark.parametrize("own", [None, 4e-6])
@pytest.mark.parametrize(("parts", "plane", "levels", "eighth"), [
    ([(0.999e-7, 2e-6)], 0.1, 2, 0), ([(1.001e-7, 2e-6)], 0.1, 2, 1), ([(2e-6, 0.999e-7)], 0.1, 0, 1),
    ([(2e-6, 1.001e-7)], 0.1, 1, 1), ([(1.79e-7, 3e-6)], 0.9, 2, 0), ([(1.81e-7, 3e-6)], 0.9, 2, 1),
    ([(1.99e-7, 1000.0)], 0.0, 99, 0), ([(2.01e-7, 1000.0)], 0.0, 99, 1), ([], 0.1, 0, 0),
])  # fmt: skip
def test_what_adds_more_than_a_fifth_of_the_tolerance_is_reduced(own, parts, plane, levels, eighth, monkeypatch):
    """By digits, or to an eighth of the tolerance; the peak is looked for where the window alone is not enough."""
    tol, asked, looked = own or 1e-6, [], []
    times = tol / 1e-6
    errors = [*parts, (4.9e-8, 4.4e-7)]

    def sums(method, pupil, grid, level, threads):
        asked.append((level, method.tol))
        profile, of_sums = errors[len(asked) - 1]
        profile, of_sums = profile * times, of_sums * (times if of_sums < 1.0 else 1.0)
        return np.full((1, 2, 2), 0.5), np.full(1, profile), np.full(1, of_sums)

    monkeypatch.setattr(method_module, "_pixel_sums", sums)
    monkeypatch.setattr(method_module, "_peak_at_least", lambda *_: looked.append(1) or np.full(1, plane))
    found = NijboerZernike(1e-6).on_pixels(lm.Pupil(), Grid(2, 0.5), 1, tol=own)
    top = max(0.5 - 4.89e-7 * times, plane) if parts else 0.5 - 4.89e-7 * times
    assert found.error == pytest.approx(4.89e-7 * times / top, rel=1e-9)
    assert found.peak == pytest.approx(top)
    assert len(looked) == len(parts)
    assert len(asked) == 1 + len(parts)
    first = asked[0][0]
    assert asked[-1] == (min(15, first + levels), pytest.approx(1e-6 * 0.125**eighth))


def test_a_profile_is_asked_for_more_to_a_hundred_thousandth_of_the_tolerance(monkeypatch):
    asked = []

    def sums(method, *_):
        asked.append(method.tol)
        return np.full((1, 2, 2), 0.5), np.full(1, 0.2), np.full(1, 1e-9)

    monkeypatch.setattr(method_module, "_pixel_sums", sums)
    with pytest.raises(ToleranceError, match=r"is bounded by 0\.67 of the largest"):
        NijboerZernike(1e-6).on_pixels(lm.Pupil(), Grid(2, 0.5), 1, window=True)
    assert asked == pytest.approx([1e-6 / 8.0**k for k in range(6)])


@pytest.mark.parametrize("peak", [None, 0.9])
@pytest.mark.parametrize("ceiling", [0.25, 4.0])
def test_the_error_of_pixels_is_that_of_their_table_and_that_of_the_profile(ceiling, peak, monkeypatch):
    v, error, nodes, grid, rounding, size = np.array([0.0, 2.5]), 1e-15, 1.3, 1.7, 40.0, 0.8
    monkeypatch.setattr(method_module, "pixel_radii", lambda *_: (v, error, nodes, grid, rounding))
    monkeypatch.setattr(method_module, "pixel_values", lambda *_: (np.array([[[0.5, -0.1]]]), np.array([7.0])))
    given = Intensities(np.array([[size, 0.1]]), np.array([1e-9]), None if peak is None else np.array([peak]))
    made = SimpleNamespace(stretch=lambda _: 1.0, _ceiling=lambda _: ceiling, profile=lambda *_: given)
    values, of_profile, of_sums = method_module._pixel_sums(made, lm.Pupil(), Grid((1, 2), 0.5), 9, 1)
    assert values.tolist() == [[[0.5, 0.0]]]
    assert of_profile == pytest.approx(grid * nodes * 1e-9 * (peak or size), rel=1e-12)
    places = 2.5 * math.sqrt(nodes * size * max(1.0, ceiling)) * (3.0 * grid * nodes + 6.0 * grid + 4.0)
    assert of_sums == pytest.approx(0.5 * ceiling * error + U * (rounding * size + 7.0 + places), rel=1e-9)
    monkeypatch.setattr(method_module, "_pixel_sums", lambda *_: (np.array([[[0.5, 0.2]]]), 0.1, 0.03))
    assert method_module._peak_at_least(made, lm.Pupil(), Grid(3, 0.5), 9, 1) == pytest.approx([0.37])


def test_a_field_as_wrong_as_it_is_large_tells_nothing_and_a_disk_without_a_bound_leaves_none():
    """The largest exact modulus is that computed less its error: from 1e-150 on it divides."""
    found = relative_error(np.array([[1.21e-300], [0.81e-300]]), np.zeros(2))
    assert found.tolist() == [0.0, math.inf]
    for missing in (0, 1):
        disks = [FieldValues(np.ones((1, 2)) + 0j, None if k == missing else np.ones(1)) for k in range(2)]
        made = annulus(lambda *_, disks=disks: disks.pop(0), lm.Pupil(obscuration=0.5), np.zeros(2))
        assert made.error is None


@pytest.mark.parametrize(("phase", "light"), [(1e-5, 0.0), (0.0, 1e-5)])
def test_either_of_what_phase_and_light_leave_out_counts_and_is_refused_where_it_exceeds_the_tolerance(phase, light):
    pupil = SimpleNamespace(left_out=(phase, light), amplitude=1.0)
    images = Samples(np.ones((2, 1, 1)), np.ones(2), np.array([1e-6, 2e-6]), None, None)
    e = phase + 2.0 * light
    worst = 2e-6 + (2.0 * e + e * e) / (1.0 - e) ** 2
    assert with_model_error(images._replace(error=None), pupil, None, normalized=False).error is None
    for tol, kept, error in ((1.001, True, None), (0.999, False, None), (0.999, True, "leave"), (1e-2, True, None)):
        # What exceeded the tolerance before is told as it is.
        asked = SimpleNamespace(stretch=lambda _: 1.0, keeps_tol=kept, tol=tol * worst)
        made = images._replace(error=np.array([1e-9, 2e-6]))
        if error:
            with pytest.raises(ToleranceError, match=error):
                with_model_error(made, pupil, asked, normalized=False)
        else:
            assert with_model_error(made, pupil, asked, normalized=False).error[1] == pytest.approx(worst, rel=1e-9)


def aperture(count=1, **more):
    wavefront = lm.Wavefront(np.linspace(0.5, 1.0, count), nonradial={(3, 1): 0.7})
    return lm.Pupil(wavefront, spider=lm.Spider.equal(3, width=0.1), apodization=0.4, **more)


@pytest.mark.parametrize(("scale", "everywhere", "times", "share", "outer", "asked_for", "looked_for"), [
    (1.0, False, 0.1, 0.3, 9.0, 1, 0), (1.0, False, 6.0, 0.3, 0.0, 2, 1), (1.0, False, 6.0, 0.3, 9.0, 1, 1),
    (1.0, True, 0.1, 0.99, 9.0, 1, 1), (1.0, True, 0.1, 1.01, 9.0, 1, 0), (None, True, 6.0, 0.3, 9.0, 2, 0),
    (1.0, False, 6.0, 9.0, 0.0, 2, 1),
])  # fmt: skip
@pytest.mark.parametrize(("tol", "kind"), [(1e-2, np.float32), (1e-9, np.float64)])
def test_samples_of_any_aperture_are_asked_for_until_a_peak_that_is_known_allows_their_error(
    tol, kind, scale, everywhere, times, share, outer, asked_for, looked_for, monkeypatch
):
    """First as of light that is spread over the blur, then as of the peak there is, and at most half as wrong."""
    pupil, grid, asked, looked, wanted = aperture(2), Grid((3, 4), 0.5), [], [], Wanted(scale, kind)
    slopes = sum(n * w for (n, _), w in pupil.wavefront.amplitudes().items() if n > 1)
    likely = pupil.amplitude / (1.0 + slopes)
    values = np.full((2, 3, 4), share * likely**2) * np.array([1.0, 4.0])[:, None, None]

    def sums(pupil, grid, error, wanted):
        asked.append(error)
        return values, None, np.full(2, error * (times if len(asked) == 1 else 0.1)), None

    monkeypatch.setattr(nonuniform_fft, "_sums", sums)
    monkeypatch.setattr(nonuniform_fft, "_peak_bound", lambda *of: looked.append(of[1]) or np.array([outer, outer]))
    found = nonuniform_fft._sample_images(pupil, grid, tol, wanted, everywhere=everywhere)
    budget = (tol - (1.0 + tol) * STORED[kind]) * (1.0 if scale else 0.49)
    first = 0.45 * budget * likely / pupil.amplitude
    peak = np.maximum(np.array([1.0, 4.0]) * share * likely**2, outer if looked_for else 0.0)
    second = 0.45 * budget * min(0.9 * math.sqrt(peak[0]), 0.5 * likely) / pupil.amplitude
    assert asked == pytest.approx([first, second][:asked_for], rel=1e-9)
    assert looked == pytest.approx([max(first, 1e-4 * likely / pupil.amplitude)] * looked_for, rel=1e-9)
    e = asked[-1] * (times if asked_for == 1 else 0.1)
    off = (2.0 * np.sqrt(peak) * e + e * e) / (np.sqrt(peak) - e) ** 2
    off = off if scale else 2.0 * off / (1.0 - off)
    assert found.error == pytest.approx(off + (1.0 + off) * STORED[kind], rel=1e-9)
    assert found.peak == pytest.approx(peak)
    assert found.error.max() <= tol


def test_samples_that_rounding_does_not_allow_are_refused_after_a_last_attempt(monkeypatch):
    """At 4e-15 of the largest field there is; and what a lattice over the blur finds is less by its error."""
    asked, values = [], np.full((1, 2, 2), 0.25)
    monkeypatch.setattr(
        nonuniform_fft, "_sums", lambda *of: asked.append(of[2]) or (values, None, np.full(1, 0.1), None)
    )
    assert nonuniform_fft._peak_bound(aperture(), 1e-9, 1) == pytest.approx([0.16], rel=1e-12)
    with pytest.raises(ToleranceError, match="cannot be met in double precision"):
        nonuniform_fft._sample_images(aperture(), Grid(2, 0.5), 1e-12, Wanted(1.0))
    assert asked[-1] == 4e-15
    assert asked.count(4e-15) == 1


class Edges(NamedTuple):
    """An opening of two rules, which rounding displaces."""

    phases: tuple[tuple[float, ...], ...] = ((0.0,) * 3,) * 2

    def rows(self, degree, error):
        assert (degree, error) == (64, pytest.approx(1e-8, rel=1e-12))
        nodes = np.array([[0.1, 0.3], [0.2, 0.2], [0.3, 0.2]])
        return SimpleNamespace(nodes=nodes, lost=1e-13), SimpleNamespace(nodes=nodes, lost=3e-13)


@pytest.mark.parametrize("single", [False, True])
def test_moments_are_off_by_their_roundings_and_by_edges(single):
    rule = nonuniform_fft.moment_rule(Edges(), 9, 33, 1e-7)
    assert (rule.rows, rule.edge_error) == (34, pytest.approx(4e-13))
    assert [nonuniform_fft._round_up_degrees(32, 7, e) for e in (1e-7, 1e-6, 9e-7)] == [
        (32, 32, -8), (32, 32, -6), (32, 32, -8)
    ]  # fmt: skip
    pupil = aperture(3)
    terms, edge = pupil.wavefront.terms, pupil.wavefront.flattened().edge
    phases = max(
        sum(abs(c) * (4 * (n * n + 1) + len(terms) + 10) for (n, _), c in zip(terms, row, strict=True))
        for row in edge
    )
    units = phases + 6.0 * 7.5 + 20.0 * 34 + pupil.illumination.slope + 40.0
    more = SINGLE * (36.0 + 0.875 * 34) + 7.4e-10 * (len(terms) + 6)
    expected = (U * units + single * more) * rule.total + rule.edge_error
    found = nonuniform_fft.roundings(rule, pupil, 7.5, single_precision=single)
    assert found == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("way", ["moments", "rows", "mask"])
def test_sums_over_any_aperture_add_what_polynomials_sums_and_roundings_are_off_by(way, monkeypatch):
    segments = lm.Segments.hexagonal(1, 0.01).phased(np.arange(6.0), 0.1, 0.2)
    pupil = lm.Pupil(lm.Wavefront(1.0), stop=segments, mask=lm.Mask(np.ones((8, 8))) if way == "mask" else None)
    error, grid, asked, made = 1e-6, Grid((3, 4), 0.5), {}, np.ones((1, 3, 4))
    allowed, amplitude = 0.3 * error * pupil.amplitude, pupil.amplitude
    monkeypatch.setattr(
        nonuniform_fft, "moment_rule_is_faster", lambda *of: asked.update(pays=of[5]) or way == "moments"
    )
    monkeypatch.setattr(nonuniform_fft, "moment_rule", lambda *of: asked.update(rule=of[3]))
    monkeypatch.setattr(nonuniform_fft, "field_sums", lambda *_: (made, None, np.array([2e-8, 5e-8])))
    monkeypatch.setattr(nonuniform_fft, "row_images", lambda *of: asked.update(sums=of[4]) or (made, made, 3e-7))
    monkeypatch.setattr(lm.optics.aperture.opening.Opening, "rows", lambda *of: asked.update(rows=of[2]))
    _, _, *bounds = nonuniform_fft._sums(pupil, grid, error, Wanted(1.0, terms=((2, 0),)))
    rounded = 8.0 * U * np.abs(pupil.opening.phases).sum(axis=1).max() * math.sqrt(amplitude)
    polynomials = 1.1 * allowed + (1.0 + allowed) * allowed + rounded
    if way == "moments":
        assert (asked["pays"], asked["rule"]) == (allowed, allowed)
        expected = [polynomials + 1.1 * allowed + 2e-8, polynomials + 1.1 * allowed + 5e-8]
    else:
        assert asked["sums"] == pytest.approx(0.5 * 0.25 * error, rel=1e-12)
        assert way == "mask" or asked["rows"] == allowed
        expected = [(rounded if way == "mask" else polynomials) + 3e-7] * 2
    assert [float(np.max(bound)) for bound in bounds] == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("single", [False, True])
@pytest.mark.parametrize("room", [0.5001, 0.4999])
def test_averages_of_any_aperture_are_off_by_polynomials_and_roundings_of_which_single_may_take_half(
    single, room, monkeypatch
):
    pupil, asked, tol = aperture(4), [], 1e-5
    monkeypatch.setattr(nonuniform_fft, "aperture_averages", lambda *of: asked.append(of[6]))
    monkeypatch.setattr(nonuniform_fft, "moment_rule", lambda *of: asked.append(of[3]))
    monkeypatch.setattr(nonuniform_fft, "quadrant_weights", lambda *_: None)
    monkeypatch.setattr(nonuniform_fft, "_nodes_are_faster", lambda *_: True)
    monkeypatch.setattr(
        nonuniform_fft, "roundings", lambda *_, single_precision=False: room * tol if single_precision else 1e-9
    )
    assert nonuniform_fft.averaged_apertures(pupil, Grid(5, 1.0, integrate=True), tol, Wanted(1.0)) is None
    _, error, taken = asked[0](3.0, tol, single, 5, 5)
    a = 0.15 * tol
    assert asked[1] == pytest.approx(a, rel=1e-12)
    assert taken == (single and room < 0.5)
    expected = 2.2 * a + (1.0 + a) * a + (room * tol if taken else 1e-9)
    assert error == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize(("count", "terms", "error", "pays"), [
    (4, (), 1e-6, True), (3, (), 1e-6, False), (2, ((12, 0),), 1e-6, True), (1, ((12, 0),), 1e-6, False),
    (2, ((13, 1),), 1e-6, False), (4, (), 3.001e-12, True), (4, (), 2.999e-12, False),
])  # fmt: skip
def test_moments_are_taken_for_four_fields_of_degrees_to_12_where_rounding_allows(
    count, terms, error, pays, monkeypatch
):
    pupil = aperture(count)
    monkeypatch.setattr(nonuniform_fft, "_count_nodes", lambda *_: 10**9)
    found = nonuniform_fft.moment_rule_is_faster(pupil, Grid(5, 0.5), terms, 20, 20, error * pupil.amplitude)
    assert found == pays
