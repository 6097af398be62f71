"""What is asked of methods and samples, what is done with an answer, and what is told of it, number by number."""

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
from lommel.core.answers import Samples, ToleranceError, Wanted, not_met
from lommel.detection.molecules import Spots
from lommel.localize import MovieInfo, checks, movie_fits
from lommel.localize import table as tables
from lommel.localize.fitting import MoleculeErrors, Molecules
from lommel.localize.table import Bounds, Table
from lommel.measures import continuous_image, energy, overlap, transfer
from lommel.measures.psf_like import ColourPSFLike
from lommel.optics.grid import Grid
from lommel.special import interpolation
from objectives import OIL

RNG = np.random.default_rng(3)
OBJECTIVE = OIL.pupil(depth=0.0, wavelength=600e-9)
VANES = lm.Pupil(lm.Wavefront(1.0), spider=lm.Spider.equal(3, 0.04))
LENS = lm.Pupil(lm.Wavefront(1.0), obscuration=0.6)
COMA = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0}), obscuration=0.4)
LOOSE = methods.Hankel()


class Asked(Exception):  # noqa: N818 (no error: it tells what was asked for)
    pass


def stop(*arguments, **options):
    raise Asked(arguments)


def asked(function, *arguments):
    with pytest.raises(Asked) as told:
        function(*arguments)
    return told.value.args[0]


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


@pytest.mark.parametrize("tol", [1e-9, 1e-3])
def test_beside_the_axis_errors_are_relative_to_at_least_the_brightest_pixel_on_it(tol, monkeypatch):
    requests, values = [], np.array([[[0.2, 0.7]], [[0.4, 0.1]], [[0.01, 0.02]]])
    stack = BlurredStack(values, np.array([0.01, np.nan, 0.01]), np.full(3, 0.02), np.full(3, 0.03), None)
    monkeypatch.setattr(recorded, "summed", lambda *of: requests.append(of[0]) or stack)
    request, beside = Request(None, 1, tol, tol / 100.0, 0.0), Grid(3, 0.5, center=(9.0, 1.0))
    assert recorded._axis_level(request, LENS, beside, ()) == pytest.approx([0.64, 0.35, 0.0])
    assert requests == [request._replace(tol=max(tol, 1e-6), error=max(tol / 100.0, 1e-9))]


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


@pytest.mark.parametrize(("error", "bias", "stated"), [
    (0.02e-6, 13.0, 0.04e-6), (0.02e-6, 12.0, None), (0.08e-6, 13.0, 0.1e-6), (None, 4.9, None), (None, 5.1, 0.1e-6),
])  # fmt: skip
def test_an_error_of_a_constant_is_told_that_molecules_leave_open_and_that_matters(error, bias, stated):
    """Twice what the molecules tell, and no more than half of what is expected; from a bias of one half on."""
    per_unit = np.zeros((2, 4, 3))
    per_unit[0, 1, 2], per_unit[:, 2, 2] = bias * 1e6 * math.sqrt(2.0), 1e5
    made = SimpleNamespace(_bias=per_unit, _images=SimpleNamespace(columns={"a": [0], "b": [1], "depth": [2]}))
    made.tests = lambda: [SimpleNamespace(name="depth", errors=(error, 1e9))] if error else []
    expected = (pytest.approx(stated), "column", pytest.approx(stated * bias * 1e6)) if stated else None
    assert checks.TableTest.untested.fget(made).get("depth") == expected


@pytest.mark.parametrize(("bounds", "tries"), [([0.99e-3], 1), ([2e-3, 1.79e-3, 1e-3], 3), ([2e-3, 1.81e-3], 0)])
def test_a_table_is_made_again_until_its_bound_is_below_the_tolerance(bounds, tries, monkeypatch):
    """Parts of the tolerance: 0.2 for taps, 0.15 for series, 0.3 for samples, all of them relative to the peak."""
    asked, planes, peaks = [], [], [0.31, 0.27, 0.22]

    class Made(Table):
        def _fill(self, sampling, exact):
            asked[-1] += (exact, sampling.per)
            self.error_bound = bounds[len(asked) - 1]
            return peaks[len(asked) - 1]

    def psf(pupil, shape, pixel, **options):
        planes.append((len(pupil.z), options))
        return SimpleNamespace(
            values=np.linspace(0.8, 0.4, 9)[:, None, None] * np.linspace(0.1, 1.0, 49).reshape(7, 7)
        )

    monkeypatch.setattr(tables, "psf", psf)
    taps, series = SimpleNamespace(gain=1.3), SimpleNamespace(gain=Bounds(1.7, 9.0))
    monkeypatch.setattr(tables.interpolation, "filtered_taps", lambda *of: asked.append(of) or taps)
    monkeypatch.setattr(tables, "pieces", lambda *of: asked.append((*asked.pop(), of[-1])) or series)
    with pytest.MonkeyPatch.context() if tries else pytest.raises(ToleranceError, match="dimmest plane"):
        Made(OBJECTIVE, 7, 6.5e-6, z=(-1e-7, 1e-7), tol=1e-3)
    assert planes == [(9, {"normalize": "strehl", "tol": 1e-2, "integrate": True})]
    assert len(asked) == len(bounds)
    step, peak = math.pi * 6.5e-6 / OBJECTIVE.scale, 0.95 * 0.4
    per = max(2, math.ceil(2.0 * step / 1.75))
    for found, bound, actual in zip(asked, bounds, peaks, strict=False):
        allowed = 1e-3 * peak
        expected = 2 * step / per, 0.2 * allowed, per, 0.15 * allowed / 1.69, 0.3 * allowed / (1.69 * 1.7), per
        assert found == pytest.approx(expected, rel=1e-9, abs=0.0)
        peak = min(0.7 * peak, 0.95 * actual * 1e-3 / bound)


@pytest.mark.parametrize("exact", [1.5e-4, 1e-13])
def test_samples_of_a_table_are_computed_again_until_each_block_is_exact_enough(exact, monkeypatch):
    """A bound e relative to the exact peak is e / (1 - e) of that which was computed."""
    asked, bright, expected, worst = [], {0: 0.7, 2: 0.9, 4: 0.2}, [], 0.0
    monkeypatch.setattr(tables, "_BLOCK_SAMPLES", 2 * 3 * 4)

    def render(part, shape, pixel, tol, **_):
        asked.append((part[0], len(part), pytest.approx(tol, rel=1e-9, abs=0.0)))
        return SimpleNamespace(values=np.full((len(part), *shape), bright[part[0]]), error_bound=0.9 * tol)

    series, waves = SimpleNamespace(places=np.arange(5)), SimpleNamespace(at=lambda places: places)
    sampling = SimpleNamespace(planes=series, per=3, waves=waves)
    given = SimpleNamespace(_render=render, pixel=6.0, tol=1e-4), sampling, (3, 4), (1, 2), exact
    for first, most in bright.items():
        tol = 1e-3
        while (bound := most * 0.9 * tol / (1.0 - 0.9 * tol)) > exact and tol > 1e-12:
            expected.append((first, min(2, 5 - first), tol))
            tol = max(1e-12, min(tol / 2.0, 0.8 * tol * exact / bound))
        expected.append((first, min(2, 5 - first), tol))
        worst = max(worst, bound)
        if bound > exact:
            with pytest.raises(ToleranceError, match="dimmest plane"):
                Table._samples(*given)
            break
    else:
        values, error = Table._samples(*given)
        assert (error, values[:, 0, 0].tolist()) == (pytest.approx(worst), [0.7, 0.7, 0.9, 0.9, 0.2])
    assert expected == asked


def test_limits_of_tables_are_those_of_the_page_and_the_tolerance_is_1e_4(monkeypatch):
    monkeypatch.setattr(Table, "_build", lambda self: None)
    assert [Table(OBJECTIVE, z=(0.0, 1e-4), **of).tol for of in ({}, {"tol": 1e-5}, {"tol": 0.1})] == [
        1e-4,
        1e-5,
        0.1,
    ]
    for z, tol, told in (
        ((0.0, 1e-6), 0.99e-5, "tol must be"), ((0.0, 1e-6), 0.101, "tol must be"), ((0.0,), 1e-4, r"got \(0"),
        ((0.0, 0.9e-9), 1e-4, "got 0 .*m and"),
    ):  # fmt: skip
        with pytest.raises(ValueError, match=told):
            Table(OBJECTIVE, z=z, tol=tol)


@pytest.mark.parametrize(("error", "kind"), [(2e-7, True), (math.nan, True), (2e-7, False)])
def test_energies_are_off_by_the_errors_of_all_samples_within_the_circle_and_the_cut(error, kind, monkeypatch):
    image = continuous_image.CartesianImage(np.zeros((2, 2), complex), *np.eye(2), 1.0, error)
    other = SimpleNamespace(circles=lambda radii: radii, error=error)
    monkeypatch.setattr(energy, "energy_images", lambda *_: [image if kind else other])
    expected = 2e-8 + continuous_image.KERNEL_NORM * 9.0 * math.pi * 2e-7
    found = energy.encircled(COMA, [1.0, 3.0]).error
    assert found == (pytest.approx(expected, rel=1e-9, abs=0.0) if kind and error == 2e-7 else None)


@pytest.mark.parametrize(("bounds", "expected"), [((1e-3, 3e-3, 2e-3), 3e-3), ((1e-3, None, 2e-3), None)])
def test_the_bound_of_a_colour_image_is_the_largest_of_its_channels_if_all_have_one(bounds, expected):
    made = SimpleNamespace(psfs=[SimpleNamespace(error_bound=one) for one in bounds])
    assert ColourPSFLike.error_bound.fget(made) == expected


def test_focus_is_tolerated_where_the_lower_contrast_of_both_directions_falls_to_the_least(monkeypatch):
    """With C_d = -pi z / (8 lambda N^2) for a displacement z of the sensor."""
    asked, at_half = [], 0.4039728  # of a disc, in any direction
    assert lm.mtf_frequency(lm.Pupil(), 0.5, angle=1.1) == pytest.approx(at_half, abs=1e-6)
    assert lm.mtf_frequency(lm.Pupil(), 0.9) < at_half

    def mtf(pupil, fx, fy, *, pixel, tol):
        c = pupil.radial_terms()[:, 0]
        asked.append((fx.tolist(), fy.tolist(), pixel, tol))
        values = np.stack([1.0 - 0.11 * np.abs(2.0 * c - 0.6), 1.0 - 0.09 * np.abs(2.0 * c + 0.8)], axis=-1)
        return values.reshape(*pupil.shape, 2)

    monkeypatch.setattr(transfer, "mtf", mtf)
    pupil = lm.Pupil(wavelength=500e-9, f_number=4.0)
    found = lm.focus_tolerance(pupil, 1e5, least=0.4, pixel=2e-6)
    ends = [(-(0.6 / 0.11) + 0.6) / 2.0, (0.6 / 0.09 - 0.8) / 2.0]
    assert sorted(found) == pytest.approx(sorted(-8.0 * 500e-9 * 16.0 / math.pi * c for c in ends), rel=1e-4, abs=0.0)
    assert set(map(str, asked)) == {str(([1e5, 0.0], [0.0, 1e5], 2e-6, 1e-8))}
    for least in (0.0, 1.0):
        with pytest.raises(ValueError, match="least must be"):
            lm.focus_tolerance(pupil, 1e5, least=least)
        with pytest.raises(ValueError, match="level must be"):
            lm.mtf_frequency(pupil, least)


@pytest.mark.parametrize(("tol", "share"), [(1e-6, None), (1e-15, 2e-15), (0.1, 0.05)])
def test_rules_over_an_overlap_have_45_hundredths_of_the_tolerance_that_pairs_of_segments_share(
    tol, share, monkeypatch
):
    asked, f = [], np.array([0.5, 0.0]) if share != 0.05 else np.array([0.98, 0.0])
    rule = SimpleNamespace(nodes=(np.zeros(0),) * 3)
    region = SimpleNamespace(rule=lambda *of: asked.append(of) or rule)
    mapped = type("Mapped", (), {"__and__": lambda *_: region})()
    regions = (SimpleNamespace(mapped=lambda *_: mapped),) * 2
    parts = overlap._ClearParts(regions, np.zeros((2, 3)), np.zeros((2, 2)), np.full(2, 2.0))
    monkeypatch.setattr(overlap, "degree_needed", lambda *of, **rest: asked.append((of[3], *rest.values())) or 7)
    overlap._general_otf(COMA, parts, f, f[0], tol)
    width = 1.0 - f[0]
    expected = share or 0.45 * tol * COMA.transmission / (width * math.sqrt(width * (1.0 + f[0])))
    assert asked[0] == pytest.approx((expected, 2.0, math.sqrt(1.0 + 0.5 * f[0] * width)), rel=1e-9, abs=0.0)
    assert asked[1:] == [(7, pytest.approx(expected / 4.0, rel=1e-9, abs=0.0))] * 4


@pytest.mark.parametrize("own", [1e-3, 1e-8])
def test_samples_of_a_continuous_image_are_as_exact_as_the_method_and_the_default(own, monkeypatch):
    monkeypatch.setattr(continuous_image, "candidates", stop)
    with pytest.raises(Asked) as told:
        continuous_image._sample(COMA, methods.ChordalGauss(own), Grid(3, 0.2), sum_spectrum=True)
    assert told.value.args[0][2] == min(own, 1e-6)
    monkeypatch.undo()
    left = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0}, error=2e-8), obscuration=0.4)
    found = continuous_image._sample(left, methods.ChordalGauss(1e-6), Grid(9, 0.2), sum_spectrum=True)
    plain = continuous_image._sample(COMA, methods.ChordalGauss(1e-6), Grid(9, 0.2), sum_spectrum=True)
    e = 2e-8 * left.amplitude / math.sqrt(found.peak[0])
    assert found.error[0] - plain.error[0] == pytest.approx(2.0 * e, rel=1e-2, abs=0.0)


@pytest.mark.parametrize("off", [np.array([3e-4]), None])
def test_the_error_of_a_continuous_image_is_that_of_its_samples_per_light_and_area(off, monkeypatch):
    """The light of the plane is 4 pi times the transmission, an area of (lambda N)^2 is pi^2."""
    images = Samples(np.full((1, 1, 1), 0.2), np.ones(1), off, None, None)

    def sample(pupil, method, grid, **_):
        return images._replace(values=np.full((1, *grid.shape), 0.2))

    monkeypatch.setattr(continuous_image, "_sample", sample)
    model = continuous_image.ImageModel(COMA, methods.ChordalGauss())
    (found,) = continuous_image.cartesian_images(model, 3.0)
    assert (
        found.error == pytest.approx(math.pi / 4.0 / COMA.transmission * 3e-4 * 0.2, rel=1e-9, abs=0.0) or off is None
    )
    assert math.isnan(found.error) == (off is None)
    texts = [str(continuous_image._radius_error(COMA, 9.0, most)) for most in (None, 0.0, 2.0)]
    assert [text.partition("use a smaller distance")[2] for text in texts] == ["", "", " of at most 2 lambda*N"]


@pytest.mark.parametrize(("band", "tol"), [(1.2, 1e-4), (0.4, 2e-13)])
def test_interpolation_errs_by_its_largest_wave_at_points_what_polynomials_do_between_them_and_rounding(band, tol):
    """At n points a polynomial of degree n / 2 is within sqrt(2) of its largest value, in t and in w."""
    made, t = interpolation.filtered_taps(band, tol), 0.5 + 0.5 * np.cos((np.arange(80) + 0.5) * math.pi / 80)
    size, side, u = made.taps.size, made.filter.size - 1, 2.0**-53
    n = 2 * math.ceil(1.18 * (size + 2 * side) * band + 48)
    w = band * np.cos((np.arange(n) + 0.5) * math.pi / n)
    whole = np.concatenate([made.filter[:0:-1], made.filter])
    gains = np.real(np.exp(1j * np.outer(w, np.arange(-side, side + 1))) @ whole)
    for weights, factor, error, gain in (
        (made.taps.at(t), np.ones(n), made.error, made.gain),
        (made.taps.slopes(t), 1j * w, made.slope_error, made.slope_gain),
    ):
        waves, most = np.exp(1j * np.outer(w, made.taps.places)) @ weights.T, np.abs(weights).sum(axis=1).max()
        off = np.abs(factor[:, None] * np.exp(1j * np.outer(w, t)) - gains[:, None] * waves)
        of_taps = (off + (u * (size + 16) * math.sqrt(2.0) * most * np.abs(gains))[:, None]).max()
        of_filter = u * (2 * side + 8) * math.sqrt(2.0) * most * np.abs(whole).sum()
        assert error == pytest.approx(
            2.0 * of_taps + math.sqrt(2.0) * of_filter, rel=1e-6 if tol > 1e-9 else 0.03, abs=0.0
        )
        sums = max(np.abs(np.convolve(row, whole)).sum() for row in weights)
        assert gain == pytest.approx(sums / math.cos(math.pi / 10.0), rel=1e-9, abs=0.0)
    assert made.error <= tol


def test_taps_around_a_circle_are_the_fewest_for_the_largest_error_of_an_order():
    t = 0.5 + 0.5 * np.cos((np.arange(80) + 0.5) * math.pi / 80)
    found = interpolation.circular_taps(20, 64, 1e-5)
    for order in (0, 9, 20):
        turned = np.exp(1j * order * math.pi / 32.0 * found.taps.places) @ found.taps.at(t).T
        off = np.abs(np.exp(1j * order * math.pi / 32.0 * t) - found.gains[order] * turned).max()
        assert found.errors[order] == pytest.approx(math.sqrt(2.0) * off, rel=1e-6, abs=0.0)
    assert found.errors.min() < 0.5 * found.errors.max() <= 0.5e-5


def test_errors_of_places_are_in_metres_and_those_of_z_are_left_out_where_it_is():
    one, states, errors = np.ones(1), np.zeros(1, np.int32), MoleculeErrors(*np.arange(1.0, 6.0)[:, None])
    molecules = Molecules(*[one] * 5, errors, one, one, states, states)
    spots, table = (
        Spots(*[states] * 3, one, np.zeros((1, 5, 5)), 0, 0, 0, 0, 0.0, one > 0.0),
        SimpleNamespace(z=(-1.0, 2.0)),
    )
    for along in ("z", "none"):
        recording = MovieInfo(1, 9, 9, 2e-7, (5, 5), along)
        found = movie_fits._localizations(spots, molecules, recording, (one, one, one), table)
        off = [float(found.table[f"{name}_error"][0]) for name in ("y", "x", "photons", "background")]
        assert off == pytest.approx([2e-7, 4e-7, 4.0, 5.0], rel=1e-9)
        assert found.to_dict()["medians"].get("z_error") == {"z": 3.0, "none": None}[along]
