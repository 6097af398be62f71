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
)  # fmt: skip
from lommel.methods import method as base
from lommel.methods.averaging import Taps, averaging_filter, fit_taps
from lommel.methods.method import with_model_error
from lommel.methods.question import checked_method, output_type
from lommel.optics.aperture.opening import Opening
from lommel.optics.grid import Grid
from lommel.paper import Geometric, TunedClosedForm

U, SINGLE = 2.0**-53, 2.0**-24
STORED = {np.float64: 6.0 * U, np.float32: 6.0 * U + SINGLE}


@pytest.fixture
def swap(monkeypatch):
    return lambda module, **made: [monkeypatch.setattr(module, name, one) for name, one in made.items()]


def roots(peak, e):
    """Return what an error of the field makes of the intensity, over its exact peak."""
    return (2.0 * np.sqrt(peak) * e + e * e) / (np.sqrt(peak) - e) ** 2


@pytest.mark.parametrize(("scale", "count"), [(1.0, 3), (1.0, 6), (1.0, 30), (1e-2, 24), (1e-17, 3)])
def test_the_mean_error_of_a_response_is_that_of_its_weighted_least_squares(scale, count):
    """Of two responses of the mean error m the product is off by m (2 + e) on average, e the largest error."""

    def response(w):
        return scale * np.sinc(w / math.pi)

    x = 0.8 * np.arange(count)
    c, error, _ = fit_taps(response, np.cos, x, in_mean=True)
    twice, points = np.where(x > 0.0, 2.0, 1.0), band_points(x[-1])
    nodes, weights = transfer_rule(points.size)
    off, mean = (np.cos(np.outer(w, x)) @ (twice * c) - response(w) for w in (points, nodes))
    rounding = 2.0 * U * (count + 3) * (twice * np.abs(c)).sum()
    largest = math.sqrt(2.0) * (np.abs(off).max() + rounding) + 1e-17
    expected = (1.0 + 0.5 * largest) * (math.sqrt((weights * mean**2).sum()) + 2.0 * rounding + 1e-17)
    # What rounding leaves is known no better than a hundredth of the bound.
    assert error == pytest.approx(expected, rel=1e-2 if count > 6 else 1e-6, abs=0.0)


def test_dark_samples_are_as_bright_as_their_rounding_allows():
    """2 (n + 4) roundings of the squared gain; where all samples are dark enough, no sample is too bright."""
    rounded, taps = 2.0 * (9 + 4) * SINGLE * 1.3**2, Taps(3, np.ones(9), 0.0, 1.3)
    for share in (1e-3, 0.999):
        assert averaging._dark_samples(taps, share * rounded) == pytest.approx((share * rounded, share), rel=1e-12)
    error, limit = averaging._dark_samples(taps, 1.001 * rounded)
    assert (error, limit >= 1e30) == (pytest.approx(rounded, rel=1e-12), True)


@pytest.mark.parametrize(("tol", "kind"), [(1e-12, np.float64), (1e-6, np.float32), (0.05, np.float32)])
def test_what_averages_may_be_off_by_is_what_storing_leaves(tol, kind):
    allowed = averaging.error_before_storing(tol, Wanted(1.0, kind))
    kept = averaging.stored_error(np.array([allowed]), Wanted(1.0, kind))[0]
    assert kept <= tol <= kept * (1.0 + (STORED[kind] / tol) ** 2 + 2.0 * STORED[kind] ** 2 / tol + 1e-12)
    assert averaging.error_before_storing(tol, Wanted(None, kind)) == pytest.approx(0.4 * allowed, abs=0.0)


@pytest.mark.parametrize(("tol", "times", "value", "scale"), [
    (1e-9, 7.0, 0.5, 1.0), (1e-4, 7.0, 0.5, 1.0), (1e-6, 1e-3, 1e-3, None),
])  # fmt: skip
def test_samples_and_filters_are_each_asked_for_as_much_more_as_they_exceed_their_share(
    tol, times, value, scale, swap
):
    """Of samples half of the tolerance, of a filter and roundings a fifth of it, over the largest average."""
    pupil, grid, top, asked, filters = lm.Pupil(obscuration=0.3), Grid(3, 0.4), 0.6, [], []
    choose, step = averaging._choose_filters, grid.step(pupil)
    swap(averaging, _choose_filters=lambda *of, **more: filters.append(of[1]) or choose(*of, **more))

    def sample(one, fine, least, request):
        asked.append((least, request.dtype == np.float32))
        off = np.full(1, (times if len(asked) == 1 else 0.1) * least)
        return Samples(np.full((1, *fine.shape), value), np.ones(1), off, None, np.array([top]))

    made = averaging.pixel_averages(sample, pupil, grid, tol, Wanted(scale))
    own, lowest = (1.0 if scale else 0.4) * (tol - (1.0 + tol) * STORED[np.float64]), least_average(step)
    taps, then = (choose(step, one, 1.05, (3, 3), gradients=False, in_mean=True)[0] for one in filters[:2])
    first = 0.5 * own * min(4.0 * lowest, 1.0)
    assert asked[0][0] == pytest.approx(first / taps.gain**2, rel=1e-9, abs=0.0)
    ease = 2.0 ** math.floor(math.log2(64.0 * pupil.amplitude**2))
    assert filters[0] == pytest.approx(2e-3 * own * lowest * ease, rel=1e-9, abs=0.0)
    light = top * (1.0 - times * asked[0][0])
    peak = value if scale is None else max(value, lowest * light)
    excess = times * first * top / peak / (0.5 * own)
    # In single precision once more, as exact as it may be; in double by what it was too much.
    second = first if excess < 1.0 else 0.9 * 2e-7 if tol > 1e-6 else first / excess
    assert asked[1] == (pytest.approx(second / then.gain**2, rel=1e-9, abs=0.0), False)
    assert asked[0][1] == (tol > 1e-6)
    added = (2 * taps.weights.shape[-1] + 8) * U * taps.gain**2 + (1.01 * 0.1 * own * lowest if tol > 1e-6 else 0.0)
    added = ((2.0 + taps.error) * taps.error + added * light) / peak
    assert filters[1] == pytest.approx(filters[0] * min(1.0, 0.2 * own / added), rel=1e-3, abs=0.0)
    assert (filters[1] < filters[0]) == (excess < 1.0)
    assert made.error[0, 0] <= tol


@pytest.mark.parametrize("bound", [None, 1e-3])
def test_a_bound_of_samples_is_told_as_that_of_averages(bound):
    asked, tol, fault = [], 1e-5, ToleranceError("no")
    fault.bound = bound

    def sample(one, fine, least, wanted):
        asked.append(least)
        raise fault

    with pytest.raises(ToleranceError, match="cannot be met by averages") as refused:
        averaging.pixel_averages(sample, lm.Pupil(), Grid(3, 0.4), tol, Wanted(1.0))
    assert len(asked) == 2
    assert refused.value.bound == (math.inf if bound is None else pytest.approx(tol * bound / asked[-1], rel=1e-12))


def test_dark_is_what_is_dark_for_the_faintest_pupil_and_single_precision_serves_from_2e_7_on(swap):
    taps, pupil, asked, dark = averaging_filter(1.3, 1e-6), lm.Pupil(lm.Wavefront([0.0, 1.0])), [], []
    swap(averaging, average_samples=lambda *_, **of: dark.append(of["dark"]))

    def sample(one, fine, least, wanted):
        asked.append(wanted.dtype)
        return Samples(np.ones((2, *fine.shape)), np.ones(2), np.array([0.1, 0.2]), None, np.array([3.0, 0.5]))

    for tol in (2e-7, 0.999 * 2e-7):
        _, error, peaks = averaging._average_stack(sample, pupil, Grid(3, 0.4), tol, taps, Wanted(), 0.25)
        assert error[0] == pytest.approx(taps.gain**2 * np.array([0.3, 0.1]), rel=1e-12)
        assert peaks[0] == pytest.approx([2.7, 0.4], rel=1e-12)
    assert (asked, dark) == ([np.float32, np.float64], [0.125, 0.125])


@pytest.mark.parametrize("tol", [1e-12, 1e-6])
def test_gradients_ask_filters_and_samples_for_what_averages_do_first(tol, swap):
    pupil, grid, asked, made = lm.Pupil(obscuration=0.3), Grid(3, 0.4), [], averaging_filter
    swap(averaging, averaging_filter=lambda step, error, spacing: asked.append(error) or made(step, error, spacing))

    def gradient(one, fine, least, weights):
        asked.append(least)
        return np.zeros((1, 2))

    averaging.averaged_gradient(gradient, pupil, grid, tol, np.ones((1, 3, 3)))
    own, lowest = tol - (1.0 + tol) * STORED[np.float64], least_average(grid.step(pupil))
    first = [2e-3 * own * lowest, 0.5 * own * min(4.0 * lowest, 1.0) / made(grid.step(pupil), asked[0]).gain ** 2]
    assert asked == pytest.approx(first, rel=1e-9, abs=0.0)


def test_what_storing_adds_to_derivatives_is_of_what_they_may_be():
    made = averaging.Averages(np.array([[[[2.0]]], [[[-0.6]]]]), np.array([[0.1], [0.5]]), np.array([2.0]))
    found = averaging.to_images(made, Wanted(3.0, np.float32)).slopes
    assert found.values == pytest.approx(-1.8, rel=1e-6)
    assert found.error - 0.5 == pytest.approx((0.3 + 0.5) * STORED[np.float32], rel=1e-6)


@pytest.mark.parametrize(("side", "wanted"), [
    (2000, Wanted(terms=((2, 0),))), (2000, Wanted(powers=(1,))), (9, Wanted()), (2000, Wanted(1.0, np.float32)),
])  # fmt: skip
def test_far_pixels_are_of_intensities_in_large_windows_that_storing_leaves_room_for(side, wanted):
    assert averaging._near_and_far(None, None, lm.Pupil(), Grid(side, 1.0, integrate=True), 1e-9, wanted) is None


@pytest.mark.parametrize(("kind", "default", "least", "most", "kept"), [
    (NijboerZernike, 1e-6, 1e-12, 1e-1, True), (ChordalGauss, 1e-6, 1e-12, 1e-1, True),
    (NonuniformFFT, 1e-6, 1e-12, 1e-1, True), (Hankel, 1e-14, 1e-15, 1e-2, False),
    (TunedClosedForm, 1e-4, 1e-6, 1e-1, True),
])  # fmt: skip
def test_tolerances_go_from_the_least_to_below_the_largest(kind, default, least, most, kept):
    assert (kind().tol, kind.keeps_tol, kind(least).tol) == (default, kept, least)
    assert kind(0.999 * most).tol == 0.999 * most
    for tol in (0.999 * least, most):
        with pytest.raises(ValueError, match="tol must be"):
            kind(tol)
    assert type(kind(np.float32(1e-3)).tol) is float
    # Halved, or as they are told to be, but none below the least; where they promise nothing they stay as they are.
    asked = [kind(1e-3).tightened(*of).tol for of in ((), (1e-5,), (0.1 * least,))]
    assert asked == pytest.approx([5e-4, 1e-5, least] if kept else [1e-3] * 3, abs=0.0)
    assert kind(least).tightened() == kind(least)
    assert Geometric().tightened(1e-3) == Geometric()


def test_questions_have_the_tolerance_of_their_method_and_the_type_that_holds_it():
    of_coarse = [checked_method(Hankel(1e-3), tol, None) for tol in (None, 1e-4)]
    assert [checked_method(None, None, None), *of_coarse] == [
        (None, 1e-6),
        (Hankel(1e-3), 1e-3),
        (Hankel(1e-4), 1e-4),
    ]
    for tol_of in (lambda tol: checked_method(None, tol, None)[1], lambda tol: Polychromatic([5e-7], tol=tol).tol):
        assert [tol_of(tol) for tol in (1e-12, 0.0999)] == [1e-12, 0.0999]
        for tol in (0.999e-12, 0.1):
            with pytest.raises(ValueError, match="tol must be"):
                tol_of(tol)
    assert [output_type(None, tol) for tol in (1e-6, 0.999e-6)] == [np.float32, np.float64]
    assert [output_type(np.float32, 2.0**-22), output_type(np.float64, 1e-12)] == [np.float32, np.float64]
    with pytest.raises(ValueError, match="float32 cannot hold"):
        output_type(np.float32, 0.999 * 2.0**-22)
    assert Polychromatic([5e-7], method=Geometric(), tol=1e-6).method == Geometric()
    assert Polychromatic([5e-7], method=NijboerZernike(1e-3)).tol == 1e-3


@dataclass(frozen=True)
class Known(lm.methods.Method):
    """Errs by what it is told to, and by a thousandth of it the second time."""

    tol: float = 1e-6
    errors: tuple[float, ...] | None = None
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
    tol *= 1.0 if over == 0 and scale else 1.0 - 1e-6 * (over or -1)
    ask = (lm.Pupil(), Grid(1, 0.5), Wanted(scale, np.float64))
    found, vague = Known(tol, (1e-9, 1e-7)), Vague(tol, (1e-9, 1e-3))
    assert found.images(*ask).error[1] == pytest.approx(tol * (1e-3 if over > 0 else 1.0), rel=1e-5, abs=0.0)
    again = [tol / (2.0 if scale else 4.0)] if over > 0 else []
    assert found.asked == pytest.approx([tol, *again], rel=1e-12, abs=0.0)
    assert vague.images(*ask).error[1] > tol
    assert len(vague.asked) == 1
    assert Known(tol).images(*ask).error is None
    with pytest.raises(ToleranceError, match="cannot be met"):
        Known(1e-12, (1e-9, 1e-7)).images(*ask)


@pytest.mark.parametrize(("side", "center", "edges", "period"), [
    (5, None, False, 2.0), (5, None, True, 2.5), (4, None, False, 1.5), (4, None, True, 2.0), (5, (2, 3), False, 3.0),
    (4, (1.5, 1.5), False, 1.5), (4, (1.5, 1.5), True, 2.0), (4, (2, 3), False, 2.5), (5, (2, 3), True, 3.5),
])  # fmt: skip
def test_windows_may_be_as_wide_as_the_period(side, center, edges, period):
    """Pixels of half a unit: none twice, and none farther out than half a period; even windows half a pixel more."""
    pupil, grid = SimpleNamespace(scale=2.0), Grid(side, 1.0, center=center)
    base.require_period(period * (1.0 - 0.8e-9), pupil, grid, edges=edges)
    with pytest.raises(ValueError, match="stay within half"):
        base.require_period(period * (1.0 - 1.9e-9), pupil, grid, edges=edges)


@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_a_window_divided_by_its_largest_value_is_asked_for_half_of_what_storing_leaves(kind, swap):
    asked, answer = [], Intensities(np.ones((1, 4, 5)), np.full(1, 1e-9), np.ones(1))
    swap(Hankel, on_pixels=lambda self, *_, **of: asked.append((of["tol"], of["window"])) or answer)
    swap(polychromatic, sum_wavelengths=lambda *of: asked.append(of[4:]) or [answer])
    white, pupil, grid = Polychromatic([5e-7]), lm.Pupil(wavelength=5e-7, f_number=4.0), Grid((4, 5), 1e-6)
    Hankel(1e-3).images(lm.Pupil(), Grid((4, 5), 0.5, center=(1.3, 2.2)), Wanted(None, kind))
    white.images(pupil, grid, Wanted(None, kind))
    white.images(pupil, grid, Wanted(1.0, kind))
    white.intensity(pupil, grid, 1)
    left = [tol - 1.1 * STORED[kind] for tol in (1e-3, 1e-6)]
    assert [tol for tol, _ in asked] == pytest.approx([0.48 * left[0], 0.48 * left[1], left[1], 1e-6], rel=1e-12)
    assert [window for _, window in asked] == [True, True, False, False]


@pytest.mark.parametrize("own", [None, 4e-6])
@pytest.mark.parametrize(("profile", "of_sums", "plane", "levels", "eighth"), [
    (0.999e-7, 2e-6, 0.1, 2, 0), (1.001e-7, 2e-6, 0.1, 2, 1), (2e-6, 0.999e-7, 0.1, 0, 1),
    (2e-6, 1.001e-7, 0.1, 1, 1), (1.79e-7, 3e-6, 0.9, 2, 0), (1.81e-7, 3e-6, 0.9, 2, 1),
    (1.99e-7, 1e9, 0.0, 99, 0), (2.01e-7, 1e9, 0.0, 99, 1), (None, 0.0, 0.0, 0, 0),
])  # fmt: skip
def test_what_adds_more_than_a_fifth_of_the_tolerance_is_reduced(own, profile, of_sums, plane, levels, eighth, swap):
    """By digits, or to an eighth of the tolerance; the peak is looked for where the window alone is not enough."""
    tol, asked, looked, worse = own or 1e-6, [], [], np.array([1.0, 0.01])
    parts = [*([(profile, of_sums)] if profile else []), (4.9e-8, 4.4e-7)]

    def sums(method, pupil, grid, level, threads):
        asked.append((level, method.tol))
        error, other = (1e6 * tol * one * worse for one in parts[len(asked) - 1])
        return np.full((2, 2, 2), 0.5), error, np.where(other > 10.0, 1000.0, other)

    swap(base, _pixel_sums=sums, _peak_at_least=lambda *_: looked.append(1) or np.full(2, plane))
    found = NijboerZernike(1e-6).on_pixels(lm.Pupil(lm.Wavefront(np.zeros(2))), Grid(2, 0.5), 1, tol=own)
    off = 0.489 * tol * worse
    top = np.maximum(0.5 - off, plane)
    assert (found.error, found.peak) == (pytest.approx(off / top, rel=1e-9), pytest.approx(top))
    assert (len(looked), len(asked)) == (len(parts) - 1, len(parts))
    # A fifth of the tolerance, of half the range of the intensity.
    assert asked[0][0] == math.ceil(-math.log10(0.2 * tol / 0.5))
    assert asked[-1] == (min(15, asked[0][0] + levels), pytest.approx(1e-6 * 0.125**eighth, abs=0.0))


def test_profiles_without_a_bound_are_interpolated_to_ten_digits(swap):
    asked, values = [], np.full((1, 2, 2), 0.5)
    swap(base, _pixel_sums=lambda *of: asked.append(of[3]) or (values, None, np.full(1, 1e-9)))
    swap(NijboerZernike, profile=lambda *_: Intensities(np.ones((1, 1)), None, None))
    assert NijboerZernike(1e-3).on_pixels(lm.Pupil(), Grid(2, 0.5), 1).error is None
    assert asked == [10]


def test_a_profile_is_asked_for_more_to_a_hundred_thousandth_of_the_tolerance(swap):
    asked = []
    parts = np.full((1, 2, 2), 0.5), np.full(1, 0.2), np.full(1, 1e-9)
    swap(base, _pixel_sums=lambda method, *_: asked.append(method.tol) or parts)
    with pytest.raises(ToleranceError, match=r"is bounded by 0\.67 of the largest"):
        NijboerZernike(1e-6).on_pixels(lm.Pupil(), Grid(2, 0.5), 1, window=True)
    assert asked == pytest.approx([1e-6 / 8.0**k for k in range(6)], abs=0.0)


@pytest.mark.parametrize("peak", [None, 0.9])
@pytest.mark.parametrize("ceiling", [0.25, 4.0])
def test_the_error_of_pixels_is_that_of_their_table_and_that_of_the_profile(ceiling, peak, swap):
    v, error, nodes, grid, rounding, size = np.array([0.0, 2.5]), 1e-15, 1.3, 1.7, 40.0, 0.8
    swap(base, pixel_radii=lambda *_: (v, error, nodes, grid, rounding))
    swap(base, pixel_values=lambda *_: (np.array([[[0.5, -0.1]]]), np.array([7.0])))
    given = Intensities(np.array([[size, 0.1]]), np.array([1e-9]), None if peak is None else np.array([peak]))
    made = SimpleNamespace(stretch=lambda _: 1.0, _ceiling=lambda _: ceiling, profile=lambda *_: given)
    values, of_profile, of_sums = base._pixel_sums(made, lm.Pupil(), Grid((1, 2), 0.5), 9, 1)
    assert values.tolist() == [[[0.5, 0.0]]]
    assert of_profile == pytest.approx(grid * nodes * 1e-9 * (peak or size), rel=1e-12, abs=0.0)
    places = 2.5 * math.sqrt(nodes * size * max(1.0, ceiling)) * (3.0 * grid * nodes + 6.0 * grid + 4.0)
    assert of_sums == pytest.approx(0.5 * ceiling * error + U * (rounding * size + 7.0 + places), rel=1e-9, abs=0.0)
    swap(base, _pixel_sums=lambda *_: (np.array([[[0.5, 0.2]]]), 0.1, 0.03))
    assert base._peak_at_least(made, lm.Pupil(), Grid(3, 0.5), 9, 1) == pytest.approx([0.37])


def test_a_field_as_wrong_as_it_is_large_tells_nothing_and_a_disk_without_a_bound_leaves_none():
    """The largest exact modulus is that computed less its error: from 1e-150 on it divides."""
    assert base.relative_error(np.array([[1.21e-300], [0.81e-300]]), np.zeros(2)).tolist() == [0.0, math.inf]
    for missing in (0, 1):
        disks = [FieldValues(np.ones((1, 2)) + 0j, None if k == missing else np.ones(1)) for k in range(2)]
        made = base.annulus(lambda *_, disks=disks: disks.pop(0), lm.Pupil(obscuration=0.5), np.zeros(2))
        assert made.error is None


@pytest.mark.parametrize(("phase", "light"), [(1e-5, 0.0), (0.0, 1e-5)])
@pytest.mark.parametrize(("tol", "kept", "refused"), [(1.001, 1, 0), (0.999, 0, 0), (0.999, 1, 1), (1e-2, 1, 0)])
def test_either_of_what_phase_and_light_leave_out_counts_and_is_refused_where_it_exceeds_the_tolerance(
    phase, light, tol, kept, refused
):
    """Unless the tolerance was exceeded before."""
    pupil = SimpleNamespace(left_out=(phase, light), amplitude=1.0)
    images = Samples(np.ones((2, 1, 1)), np.ones(2), np.array([1e-9, 2e-6]), None, None)
    worst = 2e-6 + roots(1.0, phase + 2.0 * light)
    asked = SimpleNamespace(stretch=lambda _: 1.0, keeps_tol=kept, tol=tol * worst)
    assert with_model_error(images._replace(error=None), pupil, asked, normalized=False).error is None
    if refused:
        with pytest.raises(ToleranceError, match="leave"):
            with_model_error(images, pupil, asked, normalized=False)
    else:
        assert with_model_error(images, pupil, asked, normalized=False).error[1] == pytest.approx(worst, rel=1e-9)


@pytest.mark.parametrize(("names", "normalize"), [
    ((), "energy"), ((), "peak"), (((3, 1), (2, 2)), "strehl"), (("defocus",), "energy"),
    (("defocus", "column", (3, 1)), "energy"),
])  # fmt: skip
@pytest.mark.parametrize("error", [1e-6, 1e-4])
def test_a_phase_in_error_widens_the_bound_by_what_it_changes_the_peak_at_most(names, normalize, error):
    """Twice where values are divided by their largest one, and no more where there are derivatives."""
    asked = {"tol": 1e-2, "dtype": np.float64, "normalize": normalize, "derivatives": names}
    exact, wrong = (lm.psf(lm.Pupil(lm.Wavefront(1.0, error=e)), 5, 0.5, **asked) for e in (0.0, error))
    off = roots(float(exact.values.max() / exact.scale), error)
    off = 2.0 * off / (1.0 - off) if normalize == "peak" else off
    assert wrong.error_bound - exact.error_bound == pytest.approx(off, rel=1e-3, abs=0.0)


def aperture(count=1):
    wavefront = lm.Wavefront(np.linspace(0.5, 1.0, count), nonradial={(3, 1): 0.7})
    return lm.Pupil(wavefront, spider=lm.Spider.equal(3, width=0.1), apodization=0.4)


@pytest.mark.parametrize(("scale", "everywhere", "times", "share", "outer", "asked_for", "looked_for"), [
    (1.0, False, 0.1, 0.3, 9.0, 1, 0), (1.0, False, 6.0, 0.3, 0.0, 2, 1), (1.0, False, 6.0, 0.3, 9.0, 1, 1),
    (1.0, True, 0.1, 0.99, 9.0, 1, 1), (1.0, True, 0.1, 1.01, 9.0, 1, 0), (None, True, 6.0, 0.3, 9.0, 2, 0),
    (1.0, False, 6.0, 9.0, 0.0, 2, 1),
])  # fmt: skip
@pytest.mark.parametrize(("tol", "kind"), [(1e-2, np.float32), (1e-9, np.float64)])
def test_samples_of_any_aperture_are_asked_for_until_a_peak_that_is_known_allows_their_error(
    tol, kind, scale, everywhere, times, share, outer, asked_for, looked_for, swap
):
    """First as of light that is spread over the blur, then as of the peak there is, and at most half as wrong."""
    pupil, grid, asked, looked, wanted = aperture(2), Grid((3, 4), 0.5), [], [], Wanted(scale, kind)
    likely = 0.5 * pupil.amplitude * math.sqrt(pupil.likely_strehl)
    values = np.full((2, 3, 4), share * likely**2) * np.array([1.0, 4.0])[:, None, None]

    def sums(pupil, grid, error, wanted):
        asked.append(error)
        return values, None, np.full(2, error * (times if len(asked) == 1 else 0.1)), None

    swap(nonuniform_fft, _sums=sums, _peak_bound=lambda *of: looked.append(of[1]) or np.array([outer, outer]))
    where = {"everywhere": True} if everywhere else {}
    found = nonuniform_fft._sample_images(pupil, grid, tol, wanted, **where)
    budget = (tol - (1.0 + tol) * STORED[kind]) * (1.0 if scale else 0.49)
    first = 0.45 * budget * likely / pupil.amplitude
    peak = np.maximum(np.array([1.0, 4.0]) * share * likely**2, outer if looked_for else 0.0)
    second = 0.45 * budget * min(0.9 * math.sqrt(peak[0]), 0.5 * likely) / pupil.amplitude
    assert asked == pytest.approx([first, second][:asked_for], rel=1e-9, abs=0.0)
    assert looked == pytest.approx([max(first, 1e-4 * likely / pupil.amplitude)] * looked_for, rel=1e-9, abs=0.0)
    e = asked[-1] * (times if asked_for == 1 else 0.1)
    off = roots(peak, e) if scale else 2.0 * roots(peak, e) / (1.0 - roots(peak, e))
    assert found.error == pytest.approx(off + (1.0 + off) * STORED[kind], rel=1e-9, abs=0.0)
    assert found.peak == pytest.approx(peak)
    assert found.error.max() <= tol


def test_samples_that_rounding_does_not_allow_are_refused_after_a_last_attempt(swap):
    """At 4e-15 of the largest field there is; and what a lattice over the blur finds is less by its error."""
    asked, values = [], np.full((1, 2, 2), 0.25)
    swap(nonuniform_fft, _sums=lambda *of: asked.append(of[2]) or (values, None, np.full(1, 0.1), None))
    assert nonuniform_fft._peak_bound(aperture(), 1e-9, 1) == pytest.approx([0.16], rel=1e-12)
    with pytest.raises(ToleranceError, match="cannot be met in double precision"):
        nonuniform_fft._sample_images(aperture(), Grid(2, 0.5), 1e-12, Wanted(1.0))
    assert (asked[-1], asked.count(4e-15)) == (4e-15, 1)


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
    assert (rule.rows, rule.edge_error) == (18, pytest.approx(4e-13))
    assert [nonuniform_fft._round_up_degrees(25, 7, e) for e in (1e-7, 1e-6, 9e-7)] == [
        (32, 32, -8), (32, 32, -6), (32, 32, -8)
    ]  # fmt: skip
    pupil = aperture(3)
    terms, edge = pupil.wavefront.terms, pupil.wavefront.flattened().edge
    phases = max(
        sum(abs(c) * (4 * (n * n + 1) + len(terms) + 10) for (n, _), c in zip(terms, row, strict=True))
        for row in edge
    )
    for rows in (18, 62, 64, 66):
        # Every sum of 16 terms, or of fewer than 32, is rounded once a term; and once more for each sum that follows.
        half, blocks = rows // 2, math.ceil(rows / 32)
        steps = [
            half - i if half < 32 else min(16, half - i // 16 * 16) - i % 16 + blocks - i // 16 for i in range(half)
        ]
        np.testing.assert_array_equal(nonuniform_fft._steps(rows), steps + steps[::-1])
    assert rule.steps == pytest.approx(
        sum(
            abs(rule.weight[i, k]) * (1.5 * (9 - min(i, 17 - i)) + 2.0 * (9 - min(k, 17 - k)))
            for i in range(18)
            for k in range(18)
        ),
        rel=1e-12,
    )
    for rows in (18, 66):
        units = phases + 6.0 * 7.5 + 20.0 * rows + pupil.illumination.slope + 40.0
        more = (SINGLE * 36.0 + 7.4e-10 * (len(terms) + 6)) * rule.total + SINGLE * rule.steps
        expected = U * units * rule.total + single * more + rule.edge_error
        found = nonuniform_fft.roundings(
            rule._replace(weight=np.zeros((rows, rows))), pupil, 7.5, single_precision=single
        )
        assert found == pytest.approx(expected, rel=1e-9, abs=0.0)


@pytest.mark.parametrize("way", ["moments", "single", "rows", "mask"])
def test_sums_over_any_aperture_add_what_polynomials_sums_and_roundings_are_off_by(way, swap):
    segments = lm.Segments.hexagonal(1, 0.01).phased(np.arange(6.0), 0.1, 0.2)
    pupil = lm.Pupil(lm.Wavefront(1.0), stop=segments, mask=lm.Mask(np.ones((8, 8))) if way == "mask" else None)
    error, asked, made, amplitude = 1e-6, {}, np.ones((1, 3, 4)), pupil.amplitude
    moments = way in ("moments", "single")
    allowed = (0.2 if moments else 0.3) * error * amplitude
    in_single = (0.99 if way == "single" else 1.01) * error * amplitude
    swap(
        nonuniform_fft,
        moment_rule_is_faster=lambda *of: asked.update(pays=of[5]) or moments,
        moment_rule=lambda *of: asked.update(rule=of[3]),
        roundings=lambda *_, single_precision=False: in_single if single_precision else 2e-8,
        _moment_images=lambda *_, single_precision: asked.update(single=single_precision) or (made, None),
        row_images=lambda *of: asked.update(sums=of[4], regions=len(of[1])) or (made, made, 3e-7),
    )
    swap(Opening, rows=lambda *of: asked.update(rows=of[2]))
    wanted = Wanted(1.0, dtype=np.float32, terms=((3, 1),))
    _, _, *bounds = nonuniform_fft._sums(pupil, Grid((3, 4), 0.5), error, wanted)
    rounded = 8.0 * U * np.abs(pupil.opening.phases).sum(axis=1).max() * math.sqrt(amplitude)
    polynomials = 1.1 * allowed + (1.0 + allowed) * allowed + rounded
    if moments:
        assert (asked["pays"], asked["rule"], asked["single"]) == (allowed, allowed, way == "single")
        field = polynomials + 1.1 * allowed + (in_single if asked["single"] else 2e-8)
        expected = [field, field + 60.0 * U + (7.0 * SINGLE if asked["single"] else 0.0)]
        asked.clear()
        nonuniform_fft._sums(pupil, Grid((3, 4), 0.5), error, wanted._replace(dtype=np.float64))
        assert not asked["single"]
    else:
        assert asked["sums"] == pytest.approx(0.5 * 0.25 * error, rel=1e-12, abs=0.0)
        assert asked["regions"] == (1 if way == "mask" else 6)
        assert way == "mask" or asked["rows"] == allowed
        expected = [(rounded if way == "mask" else polynomials) + 3e-7] * 2
    assert [float(np.max(bound)) for bound in bounds] == pytest.approx(expected, rel=1e-9, abs=0.0)


@pytest.mark.parametrize("single", [False, True])
@pytest.mark.parametrize(("room", "image"), [(6.0001, 1e-3), (5.9999, 1e-3), (1.0, 9.99e-5), (1.0, 1.01e-4)])
def test_averages_of_any_aperture_are_off_by_polynomials_and_roundings_that_single_may_not_meet(
    single, room, image, swap
):
    pupil, asked, tol = aperture(4), [], 1e-5
    swap(
        nonuniform_fft,
        aperture_averages=lambda *of: asked.append(of[6]),
        moment_rule=lambda *of: asked.append(of[3]),
        quadrant_weights=lambda *_: None,
        _nodes_are_faster=lambda *_: True,
        roundings=lambda *_, single_precision=False: room * tol if single_precision else 1e-9,
    )
    assert nonuniform_fft.averaged_apertures(pupil, Grid(5, 1.0, integrate=True), image, Wanted(1.0)) is None
    _, error, taken = asked[0](3.0, 2.0, tol, single, 5, 5)
    a = 0.15 * tol
    assert asked[1] == pytest.approx(a, rel=1e-12)
    assert taken == (single and room < 6.0 and room * tol < 0.1 * image)
    expected = 2.2 * a + (1.0 + a) * a + (room * tol if taken else 1e-9)
    assert error == pytest.approx(expected, rel=1e-9, abs=0.0)
