"""What says whether a fit of beads may be believed, a second time: errors by brute force, limits on both sides."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace as Made

import numpy as np
import pytest

import lommel as lm
import searches
from lommel.estimation import bead_checks, bead_search, beads
from lommel.estimation.bead_images import BeadImages, Place, Setup, Stack
from lommel.estimation.bead_search import BeadModel, Evaluation, Prior, Search, State
from lommel.estimation.beads import BeadFit
from lommel.estimation.star_images import pixel_data
from lommel.fit.goodness_of_fit import largest_plausible_chi2
from lommel.fit.score_tests import ScoreTest
from lommel.recorded.counts import counts_of
from objectives import OIL

WAVE, PIXEL, Z, SIDE = 600e-9, 6.5e-6, np.linspace(-0.5e-6, 0.5e-6, 5), 9
SETUP = Setup(OIL, WAVE, OIL.pupil(depth=0.0, wavelength=WAVE).emitter, PIXEL, 0.1e-6, step=1.25)
POINT = replace(SETUP, diameter=0.0)  # of which derivatives are exact
PLACE = Place(0.3, -0.2, 0.1e-6, 80e-9, gradient_row=8.0, gradient_column=-4.0)
RNG, MID = np.random.default_rng(0), SIDE // 2
LIMIT = float(largest_plausible_chi2(0.1))


def model_of(count, depth_error=0.0, gradients=False, priors=(), data=None):
    data = RNG.uniform(5.0, 50.0, (5, SIDE, SIDE)) if data is None else data
    stack = Stack(pixel_data(data, np.full(data.shape, 2.0), np.full(data.shape, True)), (SIDE, SIDE), Z)
    depths = tuple(Prior(80e-9, depth_error) for _ in range(count))
    return BeadModel(BeadImages(((2, -2),), {}, 1), (stack,) * count, dict(priors), depths, False, gradients)


def electrons(x, z=Z):
    """Return expected electrons (planes, ...) for a term, row, column, focus, depth, slopes, and light of planes."""
    place, flux, level = Place(*x[1:5]), *x[7:].reshape(2, 5, 1, 1)
    stack = Stack(np.ones((4, 5, SIDE**2)), (SIDE, SIDE), z)
    slope = np.linspace(-0.5, 0.5, SIDE)
    images = BeadImages(((2, -2),), {}, 1).values(POINT, x[:1], place, stack)
    return flux * images + level + x[5] * slope[:, None] + x[6] * slope


def test_standard_errors_of_beads_are_those_of_all_unknowns_together():
    """Bead 1 is left out: of it there are no errors."""
    excess = 2.0
    x = np.array([0.2, *PLACE[:4], *PLACE[6:], *RNG.uniform(3e3, 6e3, 5), *RNG.uniform(5.0, 9.0, 5)])
    true, noise = electrons(x), lm.Noise(read=1.6, excess=excess)
    data = true + RNG.normal(size=true.shape) * np.sqrt(true + 2.0)
    used = model_of(1, 20e-9, gradients=True, data=data)
    fit = used.evaluate(State(POINT, x[:1], (PLACE,)))
    both = replace(used, stacks=used.stacks * 2, depths=used.depths * 2)
    recorded = [counts_of("stack", data, noise, sides=(3,), shape="")] * 2
    inverse = beads._inverse(fit.scores.information[0])
    slope = beads._height_jacobian(used, fit.state)
    variances = np.array([(slope @ inverse @ slope.T)[0, 0], np.nan])
    found, other = beads._beads(both, fit, inverse, variances, [True, False], recorded, noise)
    x[7:] = fit.state.light[0].ravel()
    steps = np.array([0.02, 0.02, 0.02, 4e-9, 4e-9, *[1.0] * 12])
    changes = [(electrons(x + h) - electrons(x - h)) / (2.0 * h.max()) for h in np.diag(steps)]
    mean = electrons(x) + 6.0  # half the sum of the slopes is no part of the level background
    root = np.stack([(one / np.sqrt(mean + 2.0)).ravel() for one in changes], axis=1)
    scale = np.sqrt((root**2).sum(axis=0))
    information = (root / scale).T @ (root / scale)
    information[4, 4] += 1.0 / (20e-9 * scale[4]) ** 2
    covariance = np.linalg.inv(information) / np.outer(scale, scale)
    errors = np.sqrt(np.diag(covariance))
    # z is the focus of the objective at the depth of the bead, less that of the fit.
    near, far = (OIL.pupil(depth=depth, wavelength=WAVE).focus for depth in (79e-9, 81e-9))
    z_slope = np.zeros(len(x))
    z_slope[3:5] = -1.0 / 1.25, (far - near) / 2e-9 / 1.25
    z_error = math.sqrt(z_slope @ covariance @ z_slope)
    means = [math.sqrt(covariance[a : a + 5, a : a + 5].mean()) * excess for a in (7, 12)]
    expected = [errors[1], errors[2], z_error, errors[4], *(excess * errors[5:7]), *means]
    names = ["row", "column", "z", "depth", "gradient_row", "gradient_column", "flux", "background"]
    assert [found.errors[name] for name in names] == pytest.approx(expected, rel=2e-3)
    assert found.flux_errors == pytest.approx(excess * errors[7:12], rel=2e-3)
    assert found.background_errors == pytest.approx(excess * errors[12:], rel=2e-3)
    chi2 = ((data - mean) ** 2 / (mean + 2.0)).sum() / (mean.size - 10 - 1 - 6)
    assert found.chi2 == pytest.approx(chi2, rel=1e-4)
    assert (other.errors, other.used) == ({}, False)
    assert np.isnan([other.flux_errors, other.background_errors]).all()
    assert math.sqrt(inverse[0, 0]) == pytest.approx(errors[0], rel=2e-3)


@pytest.mark.parametrize(("excess", "steps", "wave", "told"), [(1.0, 20, 0.0, []), (2.0, 20, 0.0, ["excess_noise",
    "misfit"]), (1.0, 1, 0.6, ["not_settled"])])  # fmt: skip
def test_a_fit_of_beads_is_judged_by_its_noise_and_its_steps(excess, steps, wave, told, monkeypatch):
    nothing = {"missing_tests": ((), None, []), "missing_findings": ([], 0.0), "reversed_findings": []}
    for name, found in (nothing | {"model_error": 0.0}).items():
        monkeypatch.setattr(bead_checks, name, lambda *_, found=found: found)
    place = OIL.pupil(depth=80e-9, wavelength=WAVE).focus
    image = electrons(np.array([wave, 0.3, -0.2, place, 80e-9, 0.0, 0.0, *[2e4] * 5, *[10.0] * 5]), Z / 1.25)
    stack = lm.Noise(read=1.6, excess=excess).record(image, seed=1)
    microscope = lm.Microscope(OIL, WAVE, PIXEL)
    fit = searches.fit_beads([stack], microscope, z=Z, noise=lm.Noise(read=1.6), diameter=0.0, depth=80e-9,
        terms=((2, -2),), starts=1, steps=steps, threads=1, priors={})  # fmt: skip
    assert [one.code for one in fit.findings if one.severity == "error"] == told
    if not told:
        assert fit.errors[2, -2] == pytest.approx(math.sqrt(fit.covariance[0, 0]))


def test_widths_of_a_gaussian_and_their_errors_are_those_of_its_deviations(monkeypatch):
    z, y, x = np.mgrid[-40:41, -16:17, -16:17].astype(float)
    sigma, covariance = np.array([3.0, 2.5, 4.0]), np.diag([0.1, 0.2, 0.3]) ** 2

    def gaussian(sigma):
        return np.exp(-0.5 * ((x / sigma[0]) ** 2 + (y / sigma[1]) ** 2 + (z / sigma[2]) ** 2))

    step = 0.1 * float(OIL.focus(1e-6, wavelength=WAVE).axial_fwhm)

    def images(_, __, place, stack):
        """Return a Gaussian whose maximum is off the middle, of steps of 1."""
        planes, rows, columns = (
            (stack.z / step - 0.3)[:, None, None],
            (np.arange(stack.shape[0]) - stack.shape[0] // 2 - place.row - 0.4)[:, None],
            np.arange(stack.shape[1]) - stack.shape[1] // 2 - place.column + 0.2,
        )
        return np.exp(-0.5 * ((columns / sigma[0]) ** 2 + (rows / sigma[1]) ** 2 + (planes / sigma[2]) ** 2))

    def jacobian(*given, **_):
        asked.append(given)
        return rows if len(given) == 3 else np.zeros((2, 1, 1, 1))  # of the PSF without terms, a point

    asked, rows = [], np.array([(gaussian(sigma + h) - gaussian(sigma - h)) / 2e-3 for h in 1e-3 * np.eye(3)])
    fit = Made(objective=OIL, wavelength=WAVE, pupil=lambda **_: None, _state=Made(setup=SETUP, waves=None),
        _images=Made(values=images, estimated_terms=[(2, 2)], threads=1), _jacobian=jacobian, _measures={},
        _media_slopes=lambda _: [0.0, 0.0], wavefront_variance=0.0,
        status="", chi2=1.0, covariance=covariance, coefficients={(2, 2): 0.3, "NA": 1.3}, errors={(2, 2): 0.1,
        "NA": 0.02}, beads=[Made(images=np.zeros((5, 3, 3)), model=np.zeros((5, 3, 3)), residual=np.zeros((5, 3,
        3)))])  # fmt: skip
    changes = np.sqrt(np.einsum("kpyx,k->pyx", rows**2, np.diag(covariance)))
    np.testing.assert_allclose(BeadFit.psf_errors(fit, depth=1e-7), changes, rtol=1e-9)
    assert (asked[0][2].shape, asked[0][2].z.tolist()) == ((31, 31), [0.0])
    fit._focus = lambda *given: BeadFit._focus(fit, *given)
    fit._focal_measures = lambda depth: BeadFit._focal_measures(fit, depth)
    widths, errors = BeadFit.fwhm(fit, depth=1e-6)
    pixel = 0.25 * OIL.nyquist(wavelength=WAVE).pixel / OIL.magnification
    units = np.array([pixel, pixel, step])
    full = math.sqrt(8.0 * math.log(2.0))
    assert widths == pytest.approx(full * units * sigma, rel=1e-2)
    assert errors == pytest.approx(full * units * [0.1, 0.2, 0.3], rel=5e-2)
    monkeypatch.setattr(beads.show.estimates, "fit", lambda *parts: parts[3])
    assert BeadFit.plot(fit)[1:3] == (pytest.approx([0.3 / (2 * math.pi)]), pytest.approx([0.1 / (2 * math.pi)]))


def test_priors_have_errors_above_0_that_may_be_infinite_where_images_tell_the_constant():
    def priors(given, depth=1e-7):
        _, found, error, notes = beads._priors(given, replace(SETUP, objective=OIL), [depth])
        return {name: tuple(one) for name, one in found.items()}, error, len(notes)

    assert priors({}) == ({}, 0.0, 0)
    assert priors({"depth": 2e-8, "sample": (1.34, math.inf)}) == ({"sample": (1.34, math.inf)}, 2e-8, 0)
    assert priors({"sample": 0.5})[0] == {"sample": (OIL.sample, 0.5)}
    for immersion, coverslip in ((0.01, 5e-6), (0.01, math.inf), (math.inf, 5e-6)):
        assert len(priors({"immersion": immersion, "coverslip": coverslip})[0]) == 2
    assert len(priors({"immersion": math.inf})[0]) == len(priors({"coverslip": math.inf})[0]) == 1
    assert priors({"NA": 0.01}, 1e-6)[2] == 1
    assert priors({"NA": math.inf})[2] == 0
    for given in ({"immersion": math.inf, "coverslip": math.inf}, {"NA": math.inf}, {"sample": 0.0}):
        with pytest.raises(ValueError, match="priors"):
            priors(given, 1e-6)
    assert Prior(2.0, 0.5).score(2.3) == pytest.approx((0.5 * (0.3 / 0.5) ** 2, -0.3 / 0.25, 4.0))


@pytest.mark.parametrize(("index", "step", "factor"), [(0, -2.0, 0.5), (1, 0.1, 0.5), (2, 0.2 * PIXEL, 0.25), (3,
    4.0, 0.25), (5, 0.6e-6, 0.5), (4, -0.5, 1.0)])  # fmt: skip
def test_steps_of_beads_are_shortened_to_the_largest_change_and_end_within_the_window(index, step, factor):
    model = model_of(1, priors={"sample": Prior(1.33, 0.01), "pixel": Prior(PIXEL, 1e-7)})
    steps = np.array([0.1, 1e-3, 1e-3 * PIXEL, 0.9, -0.3, 1e-8])
    steps[index] = step
    place = PLACE._replace(row=4.0, column=-3.0)
    found = model.after_step(State(SETUP, np.array([0.2]), (place,)), steps)
    x = np.array([0.2, SETUP.value("sample"), PIXEL, 4.0, -3.0, 1e-7]) + factor * steps
    x[3] = min(x[3], 0.5 * SIDE)
    at = found.places[0]
    values = [found.waves[0], *map(found.setup.value, ("sample", "pixel")), at.row, at.column, at.focus]
    assert values == pytest.approx(x, rel=1e-9)


def test_chi2_of_beads_is_of_a_degree_of_freedom_and_fits_below_its_limit():
    parts = [Made(chi2=2.0, chi2_expectation=90.0, chi2_variance=5.0), Made(chi2=8.0, chi2_expectation=110.0,
        chi2_variance=7.0)]  # fmt: skip
    for degrees in (1, 0, -3, 20):
        model = Made(degrees_of_freedom=degrees, size=4, stacks=[Made(z=Z), Made(z=Z)])
        share = max(degrees, 1) / (degrees + 4 + 20)
        expected = 10.0 / (200.0 * share), math.sqrt(12.0 * share) / (200.0 * share)
        assert BeadModel.chi2_of(model, parts) == pytest.approx(expected, rel=1e-9)
    assert [Evaluation.fits(Made(quality=(LIMIT * side, 0.1)), 1e-4) for side in (0.999, 1.0)] == [True, False]
    assert [model_of(1, error).bead_parameters[3:] for error in (0.0, 1e-8)] == [(), ("depth",)]


def test_sloping_backgrounds_fit_by_weighted_squares():
    data = RNG.poisson(20.0, (5, SIDE, SIDE)).astype(float)
    chi2, spread, slopes = model_of(1, data=data).stacks[0].background_fit()
    axis = np.linspace(-0.5, 0.5, SIDE)
    design = np.array([[1.0, row, column] for row in axis for column in axis])
    total = moments = 0.0
    mean_fit = np.zeros(3)
    for plane in data:
        best = np.linalg.lstsq(design, plane.ravel(), rcond=None)[0]
        mean, mean_fit = design @ best, mean_fit + best / 5
        total += ((plane.ravel() - mean) ** 2 / (mean + 2.0)).sum()
        moments += (2.0 + mean / (mean + 2.0) ** 2).sum()
    degrees = 5 * SIDE**2 - 15
    assert (chi2, spread) == pytest.approx((total / degrees, math.sqrt(moments) / degrees), rel=1e-6)
    assert slopes == pytest.approx({"gradient_row": mean_fit[1], "gradient_column": mean_fit[2]})
    edge = BeadImages(((2, -2), (3, 1)), {(4, 0): 0.5}, 1).edge(np.array([0.3, 0.2]))
    assert edge == pytest.approx({(2, -2): 0.3 * math.sqrt(6.0), (3, 1): 0.2 * math.sqrt(8.0), (4, 0): 0.5})


@pytest.mark.parametrize(("chi2", "used"), [([2.0, 2.0, 3.0], [1, 1, 0]), ([2.0, 2.0, 2.999], [1, 1, 1]), ([0.8, 0.9,
    LIMIT * 0.999], [1, 1, 1]), ([0.8, 0.9, LIMIT], [1, 1, 0])])  # fmt: skip
def test_beads_are_left_out_that_fit_far_worse_than_most(chi2, used):
    fits = [Made(quality=(one, 0.1), state=Made(waves=np.zeros(1), places=(None,)),
        fits=lambda _: True) for one in chi2]  # fmt: skip
    model = Made(stacks=[0] * 3, priors={}, bead_parameters=(), brightest_first=lambda: [0, 1, 2],
        single_bead=lambda k: k, with_beads=lambda _: None)  # fmt: skip
    self = Made(model=model, setup=None, fit_one=lambda k, _: fits[k], climb=lambda *_: None)
    assert Search.fit_all(self)[1] == [bool(one) for one in used]


@pytest.mark.parametrize("side", [0.999, 1.0])
def test_light_is_told_from_noise_and_a_held_out_bead_from_others_at_the_limit_of_chi2(side, monkeypatch):
    stack, part = Made(background_fit=lambda: (LIMIT * side, 0.1, {})), Made(flux_sigmas=0.0)
    monkeypatch.setattr(bead_search, "start_of", lambda *_: PLACE)
    single = Made(depths=[Prior(0.0, 0.0)], evaluate=lambda _: Made(parts=[part]))
    self = Made(model=Made(stacks=[stack], single_bead=lambda k: single), setup=None, waves=None)
    assert Search.is_dark(self) == (side < 1.0)
    ends = iter([Made(state=Made(setup=None, waves=None)), Made(quality=(LIMIT * side, 0.1))])
    for name, made in (("climb", lambda *_: next(ends)), ("replace", lambda one, **_: one), ("_restricted", len)):
        monkeypatch.setattr(bead_checks, name, made if name != "_restricted" else lambda *_: None)
    model = Made(stacks=[0] * 3, with_beads=lambda _: None, images=Made(without_terms=lambda _: None))
    fit = Made(state=Made(places=[None], light=[None]), fits=lambda _: True, settled=False)
    chi2, found = bead_checks.held_out(model, fit, None)
    assert (chi2, [one.code for one in found]) == (LIMIT * side, ["held_out"] * (side == 1.0))


def score(name, log_bayes, size=(1.0,), errors=(0.1,), sigmas=9.0):
    return ScoreTest(name, np.array(size), np.array(errors), sigmas, log_bayes)


@pytest.mark.parametrize("fits", [True, False])
@pytest.mark.parametrize(("evidence", "count"), [([20.0, 16.0, 8.0, 7.99], 3), ([6.0, 5.0, 1.5, 1.0], 4)])
def test_effects_are_fitted_that_are_nearly_as_likely_as_the_best(evidence, count, fits, monkeypatch):
    """At least 0.4 of the largest evidence, or within 5 of it; the brightest beads suffice for a misfit."""
    asked, fewer = [], []
    fit = Made(quality=(1.0, 0.1), log_posterior=0.0, fits=lambda _: fits, state=None)
    tests = [score(str(k), one) for k, one in enumerate(evidence)]
    monkeypatch.setattr(bead_checks, "missing_tests", lambda *_: (tests, None, []))
    free = lambda model, fit, names, *_: asked.append([*names]) or (model, Made(log_posterior=2.0, settled=False))  # noqa: E731
    monkeypatch.setattr(bead_checks, "_refit_with_free", lambda *a: free(*a) if len(a) == 5 else None)
    monkeypatch.setattr(bead_checks, "brightest_beads", lambda *pair: fewer.append(pair) or pair)
    monkeypatch.setattr(bead_checks, "_in_words", lambda *_: "")
    (only,) = bead_checks.rounds(None, fit, None, None)
    assert asked == [[str(k)] for k in range(count)]
    assert len(fewer) == count * (not fits)
    monkeypatch.setattr(bead_checks, "_far_from_priors", lambda *_: {})
    findings, gain = bead_checks.missing_findings(only, None, None)
    assert ([*findings[0].numbers], gain) == ([str(k) for k in range(count)], 2.0)


@pytest.mark.parametrize(
    ("fits", "names"), [((0, 1), ["a"]), ((0, 0, 1, 1), ["a", "b"]), ((0, 0, 0, 1), []), ((0,), [])]
)
def test_effects_are_added_in_at_most_two_rounds_and_only_if_the_fit_is_then_good(fits, names, monkeypatch):
    place = {"settled": True, "state": Made(places=(), setup=None), "log_posterior": 1.0}
    chain = [Made(index=k, fits=lambda _, good=good: bool(good), **place) for k, good in enumerate(fits)]
    monkeypatch.setattr(bead_checks, "missing_tests", lambda _, fit: ([score(chr(97 + fit.index), 9.0)], None, []))
    more = lambda model, fit, *_: None if fit.index + 1 == len(chain) else (model, chain[fit.index + 1])  # noqa: E731
    monkeypatch.setattr(bead_checks, "_refit_with_free", more)
    monkeypatch.setattr(bead_checks, "brightest_beads", lambda *pair: pair)
    last = bead_checks.rounds(Made(priors={}), chain[0], None, None)[-1]
    assert ([*last.names], last.fit[1].index) == (names, len(names))


def test_priors_are_told_that_beads_do_not_test_better(monkeypatch):
    model, told = (model_of(2, 20e-9, priors={"sample": Prior(1.33, 0.01), "pixel": Prior(PIXEL, 1e-8),
        "coverslip": Prior(1.7e-4, 5e-6)}), [])  # fmt: skip
    tests = [score("sample", 0.0, errors=(0.0101,)), score("coverslip", 0.0, errors=(4.9e-6,)),
             score("depth", 0.0, (1.0, 1.0), (1e-9, 21e-9)), score("drift", 0.0, errors=(9.0,))]  # fmt: skip
    for name, made in (("score_tests", lambda *_: tests), ("_neighbor_tests", lambda *_: []), ("untested",
        lambda *_: {}), ("untested_findings", lambda effects, sizes, priors,
        *_: told.extend(priors))):  # fmt: skip
        monkeypatch.setattr(bead_checks, name, made)
    fit = model.evaluate(State(SETUP, np.zeros(1), (PLACE, PLACE)))
    bead_checks.missing_tests(model, fit)
    assert told == ["sample", "pixel", "depth"]
