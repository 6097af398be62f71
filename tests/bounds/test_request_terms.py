"""What is asked of samples and methods, and what is done with an answer, number by number."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel import methods
from lommel.blur import convolution, recorded
from lommel.blur.convolution import Gate, Halo, Short
from lommel.blur.recorded import Band, BlurredStack, Request
from lommel.blur.transfer_integral import Fading, Slopes, TransferIntegral
from lommel.core.answers import Samples, Wanted, not_met
from lommel.optics.grid import Grid

VANES = lm.Pupil(lm.Wavefront(1.0), spider=lm.Spider.equal(3, 0.04))
LENS = lm.Pupil(lm.Wavefront(1.0), obscuration=0.6)
LOOSE = methods.Hankel()


class Asked(Exception):  # noqa: N818 (no error: it tells what was asked for)
    pass


def stop(*arguments, **options):
    raise Asked(arguments)


def asked(function, *arguments):
    with pytest.raises(Asked) as told:
        function(*arguments)
    return told.value.args[0]


@pytest.mark.parametrize("error", [1e-7, 1e-13])
def test_a_table_of_a_halo_is_asked_for_a_tenth_of_the_error_of_the_gate_up_to_the_corner(error, monkeypatch):
    gate = Gate.of(0.8, error)
    halo = Halo.of((lm.Seeing(0.3),), 1.0, 550e-9, gate)
    monkeypatch.setattr(convolution, "table", stop)
    _, radius, off = asked(convolution._kernel, halo, (40, 37))
    w = np.linspace(0.0, gate.end, 4001)
    peak = np.trapezoid(halo.response(w) * gate.round(w) * w, w) / (2.0 * math.pi)
    assert (radius, off) == pytest.approx(
        (0.8 * math.hypot(21, 19), max(0.1 * error / peak, 1e-12)), rel=1e-4, abs=0.0
    )


def test_bands_are_shared_unless_asked_for_alone_and_lattices_extend_as_far_as_motion_does():
    own, shared = (Band.of(LENS, (lm.Seeing(0.05),), 1e-6, **given).share for given in ({"shared": False}, {}))
    assert shared == 2.0 ** (math.ceil(8.0 * math.log2(own)) / 8.0) != own
    gate, request = Gate.of(0.8, 1e-7), Request(None, 1, 1e-6, 1e-7, 0.0, False)
    pixels = (convolution.readout((0.0,), 0.0, gate),) * 2
    short = Short.of((lm.Motion(9.0),), 1.0)
    made = recorded.Lattice.of(request, Band(1.0, 0.0, 1.0, 1.0), short, Halo.of((), 1.0, None, gate), pixels)
    far = (convolution.ends(gate)[0] + np.array([0.0, 4.5 * math.pi])) / 0.8
    assert made.first == tuple(pixels[0].first - np.ceil(far))


@pytest.mark.parametrize(("pupil", "tol", "least"), [(LENS, 1e-14, 1e-12), (LENS, 0.06, 0.05), (VANES, 1e-14, 1e-11)])
def test_samples_are_asked_for_within_what_methods_can(pupil, tol, least, monkeypatch):
    for name in ("candidates", "first_within_tolerance"):
        monkeypatch.setattr(recorded, name, stop)
    assert asked(recorded._sampled, Request(None, 1, tol, 1e-9, 0.0), pupil, Grid(5, 0.5))[2] == least
    for own in (1e-3, 0.09):
        given = Request(methods.ChordalGauss(own), 1, tol, 1e-9, 0.0), LENS, Grid(5, 0.5)
        assert [one.tol for one in asked(recorded._sampled, *given)[0]] == [min(own, max(tol, 1e-12))]


def test_samples_are_off_by_their_bound_times_the_peak_with_what_the_wavefront_leaves_out():
    pupil, request = lm.Pupil(lm.Wavefront(1.0, error=1e-4), obscuration=0.6), Request(None, 1, 1e-3, 1e-9, 0.0)
    _, values, off = recorded._sampled(request, pupil, Grid(5, 0.5))
    peak, left = values.max(), 0.64 * 1e-4
    root = math.sqrt(peak)
    assert 1.0 <= off[0] / ((2.0 * root * left + left**2) * peak / (root - left) ** 2) < 1.4
    assert np.isnan(recorded._sampled(request._replace(method=methods.MatrixFourier()), LENS, Grid(5, 0.5))[2]).all()


def test_a_stack_by_transfer_functions_has_the_scale_and_the_bound_of_each_image():
    request, blur = Request(None, 1, 1e-7, 1e-9, 0.0), (lm.Seeing(0.02),)
    assert recorded.of_transfer(request, 3e-6, LENS, Grid(9, 0.5), blur) == TransferIntegral(3e-6, blur)
    made = [Samples(np.zeros(1), np.array([k]), np.array([0.1 * k])) for k in (1.0, 2.0)]
    grid = type("Stack", (dict,), {"stack": (2,), "shape": (3, 3)})({(0,): 0, (1,): 1})
    method = SimpleNamespace(images=lambda pupil, grid, wanted: made[pupil])
    found = recorded.transferred(method, grid, grid, Wanted())
    assert (found.scale.tolist(), found.error.tolist()) == ([1.0, 2.0], [0.1, 0.2])


@pytest.mark.parametrize(("scale", "dtype"), [(None, np.float64), (1.0, np.float64), (None, np.float32)])
def test_errors_are_aimed_at_nine_tenths_of_the_tolerance_and_half_of_that_of_its_own_peak(scale, dtype, monkeypatch):
    monkeypatch.setattr(recorded, "_first_request", stop)
    wanted = Wanted(scale, dtype)
    aim = asked(recorded.recorded_images, None, 1e-6, LENS, Grid(3, 0.5), (lm.Jitter(1.0),), wanted)[4]
    stored = 6.0 * 2.0**-53 + (2.0**-24 if dtype is np.float32 else 0.0)
    assert aim == pytest.approx((0.9 if scale else 0.45) * (1e-6 - 1.1 * stored), rel=1e-9, abs=0.0)


@pytest.mark.parametrize(("method", "errors", "answered"), [
    (None, [3e-5, 3e-5], True), (None, [1e-5, 3e-4], False), (LOOSE, [3e-4, 1e-5], True), (LOOSE, None, False),
    (methods.ChordalGauss(), [1e-5, 3e-4], False), (None, None, False),
])  # fmt: skip
def test_every_image_is_within_the_tolerance_where_the_method_keeps_one(method, errors, answered, monkeypatch):
    """Where samples have no bound, what blur adds to them is within it for any method."""
    off = np.array(errors or [math.nan] * 2)
    stack = BlurredStack(np.ones((2, 3, 3)), off, np.array([0.0, 0.0 if errors else 3e-4]), np.zeros(2), LOOSE)
    for name, made in (("summed", lambda *_: stack), ("of_transfer", lambda *_: None), ("_refined_request", stop)):
        monkeypatch.setattr(recorded, name, made)
    given = recorded.recorded_images, method, 1e-4, LENS, Grid(3, 0.5), (lm.Jitter(1.0),), Wanted(1.0)
    if answered:
        assert given[0](*given[1:])[1].bound == pytest.approx(off / (1.0 - off), rel=1e-6, abs=0.0)
    else:
        asked(*given)


@pytest.mark.parametrize("tol", [1e-9, 1e-3])
def test_beside_the_axis_errors_are_relative_to_at_least_the_brightest_pixel_on_it(tol, monkeypatch):
    requests, values = [], np.array([[[0.2, 0.7]], [[0.4, 0.1]], [[0.01, 0.02]]])
    stack = BlurredStack(values, np.array([0.01, np.nan, 0.01]), np.full(3, 0.02), np.full(3, 0.03), None)
    monkeypatch.setattr(recorded, "summed", lambda *of: requests.append(of[0]) or stack)
    request, beside = Request(None, 1, tol, tol / 100.0, 0.0), Grid(3, 0.5, center=(9.0, 1.0))
    assert recorded._axis_level(request, LENS, beside, ()) == pytest.approx([0.64, 0.35, 0.0])
    assert requests == [request._replace(tol=max(tol, 1e-6), error=max(tol / 100.0, 1e-9))]


@pytest.mark.parametrize("used", [TransferIntegral(1e-6), methods.ChordalGauss(1e-9)])
@pytest.mark.parametrize("given", [None, methods.Polychromatic([500e-9], [1.0])])
def test_the_method_that_is_told_is_the_last_of_those_that_could_be(used, given, monkeypatch):
    places, images = [], Samples(np.ones((1, 4, 5)), np.ones(1), None if given else np.array([3e-5]))
    last = methods.NijboerZernike(1e-3)
    monkeypatch.setattr(recorded, "candidates", lambda *of: places.append(of) or (None, None, last))
    monkeypatch.setattr(recorded, "output_spec", lambda grid, pupil, method, *_: places.append(method) or Wanted(1.0))
    monkeypatch.setattr(recorded, "recorded_images", lambda *_: (used, images))
    pupil = lm.Pupil(lm.Wavefront(1.0), wavelength=500e-9, f_number=4.0)
    found = recorded.recorded(pupil, Grid((4, 5), (3e-6, 2e-6)), (), (given, 1e-5, "peak", np.float64, 1))
    if given:
        assert (found["error_bound"], found["method"], places) == (None, given, [given])
    else:
        assert (places[0][1].pitch, places[0][2], places[1]) == ((2e-6, 2e-6), 1e-5, last)
        assert found["method"] == (last if isinstance(used, TransferIntegral) else used).with_tol(1e-5)
        assert found["error_bound"] == 3e-5


@pytest.mark.parametrize(("x", "radius"), [(0.5 + 0.05j, 0.02), (0.9 + 0.1j, 0.05)])
def test_an_outer_scale_is_bounded_on_discs_of_cube_roots_of_frequencies(x, radius):
    end, fading, bound = (
        0.4,
        Fading.of((lm.Seeing(0.3, outer_scale=2.0), lm.Seeing(0.5, outer_scale=1.0)), 1.3, 550e-9),
        0,
    )
    for term in fading.karman:
        z, most = term.rate * end * x**3, term.rate * end * (abs(x) + radius) ** 3
        bound -= float(term.least(np.array(z), np.array(z ** (5 / 3)), np.array(most)))
    assert float(fading.log_bound(np.array(x), np.array(radius), end)) == pytest.approx(bound, rel=1e-9, abs=0.0)
    stack = lm.Pupil(lm.Wavefront([1.0, -3.0, 2.0], [2.0, 0.1, -0.5]))
    assert Slopes.of(stack).terms[1:] == tuple(np.abs(stack.radial_terms()).T.max(axis=-1))


@pytest.mark.parametrize(("bound", "tol", "other", "told"), [
    (0.03, 1e-6, "", "is 0.03 of the peak; give tol=0.06"), (0.0231, 1e-6, "Other", "tol=0.047 or method=Other"),
    (0.05, 1e-6, "Other", "is 0.05 of the peak; give method=Other"),
    (0.06, 1e-6, "", "is 0.06 of the peak"), (0.04, 0.08, "", "is 0.04 of the peak"),
    (0.04, 0.079, "", "give tol=0.08"), (0.049, 1e-6, "", "give tol=0.098"),
    (0.99, 1e-6, "", "is 0.99 of the peak"), (1.0, 1e-6, "", "is as large as the peak"),
])  # fmt: skip
def test_a_tolerance_that_is_not_met_is_told_with_twice_the_bound_that_was_reached(bound, tol, other, told):
    error = not_met(tol, bound, "the peak", other=other)
    assert str(error).endswith(told)
    assert error.bound == bound
