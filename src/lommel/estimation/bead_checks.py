"""Checks of a fit of beads: neglected effects, planes in reversed order or displaced, a bead held out of the fit.

A constant is fixed, or estimated with a prior. A score test estimates the size of a neglected effect without a new
fit. `joint` is the model of all used beads, `found` its fit, `stated` the microscope with the user's constants.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np

from lommel.base.arrays import Array
from lommel.base.units import with_error
from lommel.core.answers import Declined
from lommel.estimation.bead_images import AMPLITUDES, CONSTANTS, GRADIENT, NONLINEAR, UNITS, Setup, Stack, expected
from lommel.estimation.bead_search import DRIFT, BeadModel, Evaluated, Prior, State, climb, min_depth, start_of
from lommel.estimation.star_images import label, next_terms
from lommel.fit import goodness_of_fit
from lommel.fit.findings import Finding
from lommel.fit.score_tests import (
    RIVAL,
    Candidate,
    Marginal,
    ScoreTest,
    favoured,
    log_bayes_factor,
    marginalized,
    other_explanation,
    score_tests,
    seen,
    untested,
    untested_findings,
)
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import psf

_REVERSED_GAIN = 12.0  # smallest increase of the log-posterior at which planes are reported as reversed
_REVERSED_CHI2 = 0.25  # largest ratio of chi2 - 1 of a reversed stack that fits badly to chi2 - 1 of the original
_MIN_BEADS = 3  # smallest number of beads at which a bead is held out of the fit
_STEPS = 20  # maximum number of steps of a search that starts at a fit
_TERM = 0.1  # expected size of a missing term, radians rms
_AMPLITUDE = "apodization_2"  # the only amplitude term that is tested if it is not estimated
_MAX_REFITS = 4  # maximum number of candidates that are estimated in a new fit
_MIN_BAYES_RATIO = 0.4  # smallest ln(Bayes factor) of a refitted candidate, divided by the largest ln(Bayes factor)
_WIDER = 3.0  # expected error of a constant whose prior is too narrow, in standard deviations of the prior
_NEIGHBOR = 0.3  # expected light of a neighbour, divided by the light of the bead
_MIN_DISTANCE = 2.0  # smallest distance of a neighbour, Rayleigh distances; a nearer bead would look like a wide one
_MOVED_RATIO = 4.0  # smallest significance of a displaced plane, divided by the median of all planes
_MOVED_SIGMAS = 5.0  # smallest significance of a displaced plane, standard deviations
_CONTRADICTED = 3.5  # smallest significance (standard deviations) at which the beads contradict a prior
_NEVER_TESTED = "wavelength", "dye that does not radiate alike in all directions"  # equivalent to other constants


def available_constants(setup: Setup) -> list[str]:
    """Return the names of the constants that may be estimated for this microscope; an index of 1 (air) is exact."""
    one = setup.objective
    absent = {"coverslip": one.coverslip is None, "diameter": setup.diameter == 0.0, "sample": one.sample == 1.0}
    absent["immersion"] = one.working_distance is None or one.immersion == 1.0
    return [name for name in CONSTANTS if not absent.get(name, False)]


def possible(setup: Setup, name: str, value: float) -> bool:
    """Return whether a microscope with this value of a constant exists."""
    least = {"depth": min_depth(setup), "diameter": 0.0, "blur": 0.0, "coverslip": 0.0}
    if name in least:
        return value >= least[name]
    if name in ("pixel", "step"):
        return value > 0.0
    with suppress(ValueError):
        setup.having(name, value)
        return True
    return False


def _fixed_constants(joint: BeadModel, setup: Setup) -> list[str]:
    """Return the names of the constants that are fixed in the fit and can be tested."""
    excluded = {*joint.priors, *joint.own, *AMPLITUDES} - ({_AMPLITUDE} - {*joint.priors})
    # Deeper than a wavelength, light does not reach an NA above the index of the sample: images do not depend on NA.
    if min(d.value for d in joint.depths) > setup.wavelength and setup.objective.sample < setup.objective.NA:
        excluded.add("NA")
    return [name for name in available_constants(setup) if name not in excluded]


def _prior_candidates(joint: BeadModel, found: Evaluated, names: Sequence[object]) -> list[Candidate]:
    """Return a candidate for each prior that may be too narrow; `names` are the names of all parameter columns."""
    setup, candidates = found.state.setup, []
    for name, (value, sigma) in joint.priors.items():
        if math.isfinite(sigma):
            candidates.append(Candidate(name, (names.index(name),), _WIDER * sigma, sigma, setup.value(name) - value))
    if "depth" in joint.own:
        at = joint.own.index("depth")
        columns = tuple(joint.columns(j, len(names))[at] for j in range(len(joint.stacks)))
        off = [place.depth - prior.value for place, prior in zip(found.state.places, joint.depths, strict=True)]
        sigma = joint.depths[0].error
        candidates.append(Candidate("depth", columns, _WIDER * sigma, sigma, np.array(off)))
    return candidates


def missing_tests(joint: BeadModel, found: Evaluated) -> tuple[tuple[ScoreTest, ...], Marginal | None, list[Finding]]:
    """Return score tests of neglected effects: further terms, other constants, drift, background, nonlinear gain.

    Also return the shift and covariance of the shared parameters after marginalizing favoured effects (None without
    favoured effects), and the finding on fixed constants that the stacks do not test.
    """
    setup, images = found.state.setup, joint.images
    more_terms = next_terms(images.solved, ((2, 0), *images.fixed))
    wide = replace(joint, images=images.with_terms(more_terms))
    waves = np.concatenate([found.state.waves, np.zeros(len(more_terms))])
    constants = _fixed_constants(joint, setup)
    drift = () if joint.drifts else DRIFT
    more = [*constants, *drift, *GRADIENT, NONLINEAR]  # columns after the shared parameters
    _, information, slope = wide.normal(replace(found.state, waves=waves), found.values, more)
    names = [*wide.names, *more]
    unknowns = [*map(names.index, joint.names), *range(len(names), len(slope))]
    candidates = [Candidate(label(term), (names.index(term),), _TERM) for term in more_terms]
    candidates += _prior_candidates(joint, found, names)
    fixed = [Candidate(n, (names.index(n),), setup.scale(n) * CONSTANTS[n].size) for n in constants]
    candidates += fixed
    # Expected sizes: drift, pixels over half the stack; gradient, electrons over the window; fraction lost at 10^4.
    groups = {"drift": (drift, 0.3), "background gradient": (GRADIENT, 5.0), "non-linear gain": ((NONLINEAR,), 0.05)}
    for name, (group, size) in groups.items():
        if group:
            candidates.append(Candidate(name, tuple(map(names.index, group)), size))
    tests = (*score_tests(information, slope, unknowns, candidates), *_neighbor_tests(joint, found))
    likely = [one for one in candidates if one.name in favoured(tests)]
    for one in likely:
        if one.known:  # a prior that is too narrow
            information, slope = one.widened(information, slope)
    lacking = [one for one in likely if not one.known]
    marginal = marginalized(information, slope, unknowns, lacking, len(joint.names)) if likely else None
    shown = {label(name): at for at, name in enumerate(images.solved)}
    unseen = untested(information, unknowns, shown, fixed, tests)
    errors = {test.name: float(test.errors.max()) for test in tests}
    priors = [one.name for one in candidates if 0.0 < one.known < errors.get(one.name, math.inf)]
    sizes = {one.name: f"{_size(one.name, one.scale)} of it" for one in fixed}
    notes = untested_findings(unseen, sizes, priors, _NEVER_TESTED)
    return tuple(sorted(tests, key=lambda test: -test.log_bayes)), marginal, notes


def _size(name: str, value: float) -> str:
    """Return the difference `value` of a constant with its unit, such as "0.05 um"."""
    factor, unit = UNITS[CONSTANTS[name].unit]
    return f"{factor * value:.3g}{unit}"


def _neighbor_tests(joint: BeadModel, found: Evaluated) -> list[ScoreTest]:
    """Return a test for a second bead near each bead, at the same focus and at the most likely position."""
    setup, tests = found.state.setup, []
    # Rayleigh's distance, 0.61 lambda / NA, in pixels of the camera.
    least = (
        _MIN_DISTANCE * 0.61 * setup.wavelength * setup.objective.magnification / (setup.objective.NA * setup.pixel)
    )
    for k, (stack, values, light) in enumerate(zip(joint.stacks, found.values, found.state.light, strict=True)):
        bead, mean = light[0][:, None, None] * values, expected(light, values)
        counted, read, valid = stack.planes
        # The variance is the mean of the Poisson counts plus read noise; the lower limit is for a negative `mean`.
        weight = valid / np.maximum(mean + read, 0.25 * read)
        # Arrays with twice the sides of the images: correlations do not wrap around.
        size = tuple(2 * side for side in stack.shape)
        conjugate = np.conj(np.fft.rfft2(bead, size))
        # Slope and information for a copy of the bead at every shift are correlations: sums over pixels of
        # weight * (counted - mean) * (shifted bead), and of weight * (shifted bead)^2.
        slope = np.fft.irfft2((np.fft.rfft2(weight * (counted - mean), size) * conjugate).sum(axis=0), size)
        squares = np.fft.rfft2(weight, size) * np.conj(np.fft.rfft2(bead**2, size))
        square = np.fft.irfft2(squares.sum(axis=0), size)
        down, across = (np.fft.fftfreq(side, 1.0 / side) for side in size)
        inside = (np.abs(down) <= stack.shape[0] / 2.0)[:, None] & (np.abs(across) <= stack.shape[1] / 2.0)
        beside = inside & (np.hypot(down[:, None], across) >= least) & (slope > 0.0) & (square > 1e-12 * square.max())
        if not beside.any():
            continue
        sigmas = np.where(beside, slope, 0.0) / np.sqrt(np.where(beside, square, 1.0))
        row, column = np.unravel_index(int(sigmas.argmax()), sigmas.shape)
        ratio, error = slope[row, column] / square[row, column], 1.0 / math.sqrt(square[row, column])
        # The penalty for the search over positions is the log of the number of independent positions.
        penalty = math.log(beside.sum() / max(math.pi * (least / _MIN_DISTANCE) ** 2, 1.0) + 1.0)
        evidence = log_bayes_factor(np.array([ratio]), np.array([[error**2]]), 0.0, _NEIGHBOR) - penalty
        name = f"a neighbor of bead {k} by {down[row]:.0f} rows and {across[column]:.0f} columns, share of its light"
        tests.append(ScoreTest(name, np.array([ratio]), np.array([error]), float(sigmas.max()), evidence))
    return tests


def missing_findings(
    joint: BeadModel, found: Evaluated, tests: Sequence[ScoreTest], stated: Setup
) -> tuple[list[Finding], float | None]:
    """Return the finding on significant effects, and the log-posterior of a fit that estimates the best effect.

    Score tests are linear approximations: each of the most likely effects is estimated by a new fit, which ranks it.
    """
    likely = seen(tests)
    if not likely:
        # There are few priors: a contradiction is significant even if it is not among all candidates.
        against = [test for test in tests if test.name in joint.priors and abs(test.sigmas) > _CONTRADICTED]
        words = [f"{_in_words(test, joint, stated, None)}, against its prior" for test in against]
        return [other_explanation(against, words)] if against else [], None
    least = min(_MIN_BAYES_RATIO * tests[0].log_bayes, likely[-1].log_bayes)
    likely = tuple(test for test in tests[:_MAX_REFITS] if test.log_bayes >= least)
    ends = [_refit_with_free(joint, found, test.name, stated) for test in likely]
    gains = [
        test.log_bayes if end is None else end.log_posterior - found.log_posterior
        for test, end in zip(likely, ends, strict=True)
    ]
    order = [k for k in np.argsort(-np.array(gains), kind="stable") if gains[k] >= max(gains) - RIVAL]
    words = [_in_words(likely[k], joint, stated, ends[k]) for k in order]
    best = ends[order[0]]
    return [other_explanation([likely[k] for k in order], words)], None if best is None else best.log_posterior


def _in_words(test: ScoreTest, joint: BeadModel, stated: Setup, solved: Evaluated | None) -> str:
    """Return the result of a test as text, like "sample = 1.379 +- 0.005"; the fit `solved` estimates the effect."""
    name, size, error = test.name, float(test.size[0]), float(test.errors[0])
    sigmas = f"({abs(test.sigmas):.2g} sigma)"
    if len(test.size) > 1 and name in CONSTANTS:
        factor, unit = UNITS[CONSTANTS[name].unit]
        beads = zip(test.size, joint.depths, test.errors, strict=True)
        shown = ", ".join(" +- ".join(with_error(factor * (by + at.value), factor * off)) for by, at, off in beads)
        return f"{name} of each bead = {shown}{unit} {sigmas}"
    if name not in CONSTANTS:
        if solved is not None and len(solved.state.waves) > len(joint.images.solved):
            size = float(solved.state.waves[-1])
        unit = {"non-linear gain": "", "drift": " pixels"}.get(name, " rad" if name.startswith("noll") else "")
        each = [size] if len(test.size) == 1 else test.size.tolist()
        shown = ", ".join(" +- ".join(with_error(one, own)) for one, own in zip(each, test.errors, strict=True))
        return f"{name} = {shown}{unit} {sigmas}"
    given = joint.depths[0].value if name == "depth" else stated.value(name)
    factor, unit = UNITS[CONSTANTS[name].unit]
    value = given + size
    if not possible(stated, name, value):
        way = "lower" if size < 0.0 else "higher"
        return f"{name} {way} than {factor * given:.6g}{unit}, beyond what is possible {sigmas}"
    if solved is not None:
        there = solved.state.places[0].depth if name == "depth" else solved.state.setup.value(name)
        value = there if possible(stated, name, there) else value
    shown = " +- ".join(with_error(factor * value, factor * error))
    return f"{name} = {shown}{unit}, stated {factor * given:.6g} {sigmas}"


def _refit_with_free(joint: BeadModel, found: Evaluated, name: str, stated: Setup) -> Evaluated | None:
    """Fit with the constant, term or drift `name` estimated without prior; return None if not possible."""
    state, depths, priors, images = found.state, joint.depths, dict(joint.priors), joint.images
    if name == "depth":
        depths = tuple(Prior(prior.value, math.inf) for prior in depths)
    elif name in CONSTANTS:
        priors[name] = Prior(stated.value(name), math.inf)
    else:
        terms = [term for term in next_terms(images.solved, ((2, 0), *images.fixed)) if label(term) == name]
        if not terms and name != "drift":
            return None
        images = images.with_terms(terms)
        state = replace(state, waves=np.concatenate([state.waves, np.zeros(len(terms))]))
    drifts = joint.drifts or name == "drift"
    try:
        return climb(replace(joint, images=images, priors=priors, depths=depths, drifts=drifts), state, _STEPS)
    except (Declined, ValueError):
        return None


def reversed_findings(joint: BeadModel, start: State, best: float, chi2: float) -> list[Finding]:
    """Return the finding of planes in reversed order, if these fit well and with a log-posterior higher than `best`.

    If the chi2 of reversed planes is nearly `chi2`, not the order but the step or the objective is wrong.
    """
    stacks = tuple(replace(stack, z=-stack.z) for stack in joint.stacks)
    places = tuple(start_of(s, start.setup, d.value, 0.0) for s, d in zip(stacks, joint.depths, strict=True))
    try:
        end = climb(replace(joint, stacks=stacks), State(start.setup, start.waves, places), _STEPS)
    except (Declined, ValueError):
        return []
    (reversed_chi2, spread), gain = end.quality, end.log_posterior - best
    # If the model has another error as well, chi2 remains large: then a much smaller chi2 than before suffices.
    good = reversed_chi2 < goodness_of_fit.largest_plausible_chi2(spread) or reversed_chi2 - 1.0 < _REVERSED_CHI2 * (
        chi2 - 1.0
    )
    if gain < _REVERSED_GAIN or not good:
        return []
    text = (
        f"planes in reversed order fit far better, chi2 {reversed_chi2:.4g}; z must increase towards the sample: "
        "change the sign of the step"
    )
    return [Finding("reversed_z", "error", text, {"chi2": reversed_chi2, "log_likelihood": gain})]


def held_out(joint: BeadModel, found: Evaluated) -> tuple[float, list[Finding]]:
    """Return chi2 of the last bead with common parameters of the other beads, and a finding if it is too large."""
    count, state = len(joint.stacks), found.state
    if count < _MIN_BEADS:
        return math.nan, []
    others, out = joint.having(range(count - 1)), joint.having([count - 1])
    try:
        start = replace(state, places=state.places[:-1], light=state.light[:-1])
        rest = climb(others, start, _STEPS).state
        fixed = replace(out, images=joint.images.without_terms(rest.waves), priors={})
        end = climb(fixed, State(rest.setup, np.zeros(0), state.places[-1:], state.light[-1:]), _STEPS)
    except (Declined, ValueError):
        return math.nan, []
    chi2, limit = end.quality[0], float(goodness_of_fit.largest_plausible_chi2(end.quality[1]))
    text = f"chi2 of the held-out bead is above {limit:.4g}, the limit for noise alone: beads differ in size or depth"
    return chi2, [Finding("held_out", "doubt", text, {"chi2": chi2, "limit": limit})] if chi2 >= limit else []


def moved_planes(shifts: Array, sigmas: Array) -> dict[int, tuple[float, float]]:
    """Return the indices and shifts of planes whose shift is more significant than the limits."""
    far = np.flatnonzero(sigmas > max(_MOVED_SIGMAS, _MOVED_RATIO * float(np.median(sigmas))))
    return {int(k): (float(shifts[k, 0]), float(shifts[k, 1])) for k in far}


def moved_findings(moved: Sequence[dict[int, tuple[float, float]]], planes: int) -> list[Finding]:
    """Return the finding on displaced planes: `moved` are those of each bead, `planes` is the total number."""
    each = [(math.hypot(*by), plane, j) for j, one in enumerate(moved) for plane, by in one.items()]
    if not each:
        return []
    numbers = {f"bead {j}": dict(one) for j, one in enumerate(moved) if one}
    if len(each) > planes // 4:
        return [Finding("moved", "doubt", "planes are shifted relative to each other: estimate drift", numbers)]
    each.sort(reverse=True)
    named = ", ".join(f"plane {plane} of bead {j} by {by:.2g} pixels" for by, plane, j in each[:3])
    more = f" and {len(each) - 3} more" if len(each) > 3 else ""
    return [Finding("moved", "note", f"moved: {named}{more}", numbers)]


def model_error(model: BeadModel, state: State) -> float:
    """Return the largest difference between images of the search and PSFs with a proven bound, relative to the peak.

    Both are images of a point. The result is inf if the aberrations are too strong for :func:`lommel.psf`.
    """
    setup, place, stack = replace(state.setup, diameter=0.0, blur=0.0), state.places[0], model.stacks[0]
    wave = Wavefront.zernike(model.images.edge(state.waves), normalization="edge")
    # Compare the middle plane, and the first and the last, in which defocus is largest.
    ends = np.unique([0, len(stack.z) // 2, len(stack.z) - 1])
    pupil = setup.pupil(wave, place.depth, place.focus + setup.step * stack.z[ends], "coverslip")
    center = (stack.shape[0] // 2 + place.row, stack.shape[1] // 2 + place.column)
    try:
        true = psf(pupil, stack.shape, setup.pixel, tol=1e-4, integrate=setup.integrate, center=center)
    except ValueError:  # the aberrations are too strong
        return math.inf
    planes = Stack(stack.star[:, ends], stack.shape, stack.z[ends])
    quick = model.images.values(setup, state.waves, place._replace(drift_row=0.0, drift_column=0.0), planes)
    return float(np.abs(quick - true.values).max() / true.values.max())
