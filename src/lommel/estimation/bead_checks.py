"""Checks of a fit of beads: what the model lacks, planes in reversed order or moved, a bead that was left out."""

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
from lommel.estimation.bead_search import DRIFT, BeadModel, Evaluated, Prior, State, climb, lowest, start_of
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

_REVERSED = 12.0  # of log-likelihood, by which a reversed stack has to fit better
_FAR_BETTER = 0.25  # of chi2 - 1: a reversed stack that leaves more is not the only fault
_HELD = 3  # beads, from which on one is left out for a test
_STEPS = 20  # largest number of steps of a search that starts at the answer
_TERM = 0.1  # radians rms: expected size of a missing term
_AMPLITUDE = "apodization_2"  # the only amplitude term that is tested where it is not estimated
_TRIED, _LIKELY = 4, 0.4  # candidates that are fitted, and their least log of the Bayes factor over the largest
_WIDER = 3.0  # standard deviations of a prior that a tested constant may be off
_NEIGHBOR = 0.3  # of the light of a bead: expected light of a second one beside it
_BESIDE = 2.0  # Rayleigh distances: a nearer neighbour counts as another shape of the bead
_JUMP = 4.0  # times the median shift of the planes, from which on a plane has moved
_MOVED = 5.0  # standard deviations of the same
_CONTRADICTED = 3.5  # standard deviations of both, by which the beads contradict a prior
_NEVER = "wavelength", "dye that does not radiate alike in all directions"  # which look like other constants


def available_constants(setup: Setup) -> list[str]:
    """Return the constants that this microscope has."""
    one = setup.objective
    lacks = {"coverslip": one.coverslip is None, "diameter": setup.diameter == 0.0, "sample": one.sample == 1.0}
    lacks["immersion"] = one.working_distance is None or one.immersion == 1.0  # air
    return [name for name in CONSTANTS if not lacks.get(name, False)]


def possible(setup: Setup, name: str, value: float) -> bool:
    """Return whether a microscope with this value of a constant exists."""
    least = {"depth": lowest(setup), "diameter": 0.0, "blur": 0.0, "coverslip": 0.0}
    if name in least:
        return value >= least[name]
    if name in ("pixel", "step"):
        return value > 0.0
    with suppress(ValueError):
        setup.having(name, value)
        return True
    return False


def _held_constants(joint: BeadModel, setup: Setup) -> list[str]:
    """Return the constants that the fit holds and its stacks may test."""
    unheld = {*joint.priors, *joint.own, *AMPLITUDES} - ({_AMPLITUDE} - {*joint.priors})
    # Beyond a wavelength from the glass no light of larger NA than the sample's index arrives: NA leaves no trace.
    if min(d.value for d in joint.depths) > setup.wavelength and setup.objective.sample < setup.objective.NA:
        unheld.add("NA")
    return [name for name in available_constants(setup) if name not in unheld]


def _prior_candidates(joint: BeadModel, found: Evaluated, names: Sequence[object]) -> list[Candidate]:
    """Return candidates for priors that are too narrow, at the columns of the `names` of all parameters."""
    setup, candidates = found.state.setup, []
    for name, (value, known) in joint.priors.items():
        if math.isfinite(known):
            candidates.append(Candidate(name, (names.index(name),), _WIDER * known, known, setup.value(name) - value))
    if "depth" in joint.own:
        at = joint.own.index("depth")
        columns = tuple(joint.columns(j, len(names))[at] for j in range(len(joint.stacks)))
        off = [place.depth - prior.value for place, prior in zip(found.state.places, joint.depths, strict=True)]
        known = joint.depths[0].error
        candidates.append(Candidate("depth", columns, _WIDER * known, known, np.array(off)))
    return candidates


def missing_tests(joint: BeadModel, found: Evaluated) -> tuple[tuple[ScoreTest, ...], Marginal | None, list[Finding]]:
    """Return score tests of what the model may lack: further terms, other constants, drift, background, gain.

    And steps of the shared parameters that allow for those that the stacks favour, where there are such; and the
    finding of constants that are held and that the stacks do not test.
    """
    setup, images = found.state.setup, joint.images
    more_terms = next_terms(images.solved, ((2, 0), *images.fixed))
    wide = replace(joint, images=images.with_terms(more_terms))
    waves = np.concatenate([found.state.waves, np.zeros(len(more_terms))])
    constants = _held_constants(joint, setup)
    drift = () if joint.drifts else DRIFT
    more = [*constants, *drift, *GRADIENT, NONLINEAR]
    _, information, slope = wide.normal(replace(found.state, waves=waves), found.values, more)
    names = [*wide.names, *more]
    unknowns = [*map(names.index, joint.names), *range(len(names), len(slope))]
    candidates = [Candidate(label(term), (names.index(term),), _TERM) for term in more_terms]
    candidates += _prior_candidates(joint, found, names)
    held = [Candidate(n, (names.index(n),), setup.scale(n) * CONSTANTS[n].size) for n in constants]
    candidates += held
    # Sizes in pixels over half the stack, in electrons over the window, and in the share that is lost at 10^4.
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
    unseen = untested(information, unknowns, shown, held, tests)
    errors = {test.name: float(test.errors.max()) for test in tests}
    priors = [one.name for one in candidates if 0.0 < one.known < errors.get(one.name, math.inf)]
    sizes = {one.name: f"{_size(one.name, one.scale)} of it" for one in held}
    notes = untested_findings(unseen, sizes, priors, _NEVER)
    return tuple(sorted(tests, key=lambda test: -test.log_bayes)), marginal, notes


def _size(name: str, value: float) -> str:
    """Return a difference of a constant with its unit: "0.05 um"."""
    factor, unit = UNITS[CONSTANTS[name].unit]
    return f"{factor * value:.3g}{unit}"


def _neighbor_tests(joint: BeadModel, found: Evaluated) -> list[ScoreTest]:
    """Return a test for a second bead at the same focus beside each one, where it is likeliest."""
    setup, made = found.state.setup, []
    # Rayleigh's distance, 0.61 lambda / NA, in pixels of the camera.
    least = _BESIDE * 0.61 * setup.wavelength * setup.objective.magnification / (setup.objective.NA * setup.pixel)
    for k, (stack, values, light) in enumerate(zip(joint.stacks, found.values, found.state.light, strict=True)):
        bead, mean = light[0][:, None, None] * values, expected(light, values)
        counted, read, valid = stack.planes
        # Variance of a Poisson count is the mean; not below a quarter of that of reading, where the model is
        # negative.
        weight = valid / np.maximum(mean + read, 0.25 * read)
        # Twice the sides: the correlation of images with the bead must not wrap around.
        size = tuple(2 * side for side in stack.shape)
        turned = np.conj(np.fft.rfft2(bead, size))
        # Slope and information for a copy of the bead at every shift, as correlations: sums of weight (counts - mean)
        # times the shifted bead, and of weight times its square.
        slope = np.fft.irfft2((np.fft.rfft2(weight * (counted - mean), size) * turned).sum(axis=0), size)
        squares = np.fft.rfft2(weight, size) * np.conj(np.fft.rfft2(bead**2, size))
        square = np.fft.irfft2(squares.sum(axis=0), size)
        down, across = (np.fft.fftfreq(side, 1.0 / side) for side in size)
        inside = (np.abs(down) <= stack.shape[0] / 2.0)[:, None] & (np.abs(across) <= stack.shape[1] / 2.0)
        beside = inside & (np.hypot(down[:, None], across) >= least) & (slope > 0.0) & (square > 1e-12 * square.max())
        if not beside.any():
            continue
        sigmas = np.where(beside, slope, 0.0) / np.sqrt(np.where(beside, square, 1.0))
        row, column = np.unravel_index(int(sigmas.argmax()), sigmas.shape)
        share, error = slope[row, column] / square[row, column], 1.0 / math.sqrt(square[row, column])
        chance = math.log(beside.sum() / max(math.pi * (least / _BESIDE) ** 2, 1.0) + 1.0)  # of so many places
        evidence = log_bayes_factor(np.array([share]), np.array([[error**2]]), 0.0, _NEIGHBOR) - chance
        name = f"a neighbor of bead {k} by {down[row]:.0f} rows and {across[column]:.0f} columns, share of its light"
        made.append(ScoreTest(name, np.array([share]), np.array([error]), float(sigmas.max()), evidence))
    return made


def missing_findings(
    joint: BeadModel, found: Evaluated, tests: Sequence[ScoreTest], stated: Setup
) -> tuple[list[Finding], float | None]:
    """Return the finding of what the data favour, and the log-posterior of a fit with the first of it unknown.

    Steps of tests are linear: the likeliest are ranked by fits with each of them unknown, where there is such a fit.
    """
    likely = seen(tests)
    if not likely:
        # Of few constants with priors the chance of these is small, though all candidates together may be as likely.
        against = [test for test in tests if test.name in joint.priors and abs(test.sigmas) > _CONTRADICTED]
        words = [f"{_in_words(test, joint, stated, None)}, against its prior" for test in against]
        return [other_explanation(against, words)] if against else [], None
    least = min(_LIKELY * tests[0].log_bayes, likely[-1].log_bayes)
    likely = tuple(test for test in tests[:_TRIED] if test.log_bayes >= least)
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
    """Return the result of a test in words, from a fit with it free if any: "sample = 1.379 +- 0.005"."""
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
    """Return the fit with a constant or a term free and without prior; None if it is neither."""
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
    """Return the finding of planes in reversed order, where they fit far better than a log-posterior of `best`.

    And fit well: where chi2 is little nearer to 1 than `chi2` was, the step or the objective is wrong.
    """
    turned = tuple(replace(stack, z=-stack.z) for stack in joint.stacks)
    places = tuple(start_of(s, start.setup, d.value, 0.0) for s, d in zip(turned, joint.depths, strict=True))
    try:
        there = climb(replace(joint, stacks=turned), State(start.setup, start.waves, places), _STEPS)
    except (Declined, ValueError):
        return []
    (turned_chi2, spread), gain = there.quality, there.log_posterior - best
    # Chi2 well below what it was is enough: another fault may be left.
    well = turned_chi2 < goodness_of_fit.most(spread) or turned_chi2 - 1.0 < _FAR_BETTER * (chi2 - 1.0)
    if gain < _REVERSED or not well:
        return []
    text = (
        f"planes in reversed order fit far better, chi2 {turned_chi2:.4g}; z increases towards the sample, change "
        "the sign of the step"
    )
    return [Finding("reversed_z", "error", text, {"chi2": turned_chi2, "log_likelihood": gain})]


def held_out(joint: BeadModel, found: Evaluated) -> tuple[float, list[Finding]]:
    """Return chi2 of the last bead with the answer of a fit of the others, and the finding if it differs."""
    count, state = len(joint.stacks), found.state
    if count < _HELD:
        return math.nan, []
    others, out = joint.having(range(count - 1)), joint.having([count - 1])
    try:
        start = replace(state, places=state.places[:-1], light=state.light[:-1])
        rest = climb(others, start, _STEPS).state
        held = replace(out, images=joint.images.without_terms(rest.waves), priors={})
        end = climb(held, State(rest.setup, np.zeros(0), state.places[-1:], state.light[-1:]), _STEPS)
    except (Declined, ValueError):
        return math.nan, []
    chi2, limit = end.quality[0], float(goodness_of_fit.most(end.quality[1]))
    text = f"noise alone keeps chi2 of the held-out bead below {limit:.4g}: beads differ, in size or depth"
    return chi2, [Finding("held_out", "doubt", text, {"chi2": chi2, "limit": limit})] if chi2 >= limit else []


def moved_planes(shifts: Array, sigmas: Array) -> dict[int, tuple[float, float]]:
    """Return the planes whose shifts are beyond chance and beyond those of the others."""
    far = np.flatnonzero(sigmas > max(_MOVED, _JUMP * float(np.median(sigmas))))
    return {int(k): (float(shifts[k, 0]), float(shifts[k, 1])) for k in far}


def moved_findings(moved: Sequence[dict[int, tuple[float, float]]], planes: int) -> list[Finding]:
    """Return the finding on moved planes, of each bead."""
    each = [(math.hypot(*by), plane, j) for j, one in enumerate(moved) for plane, by in one.items()]
    if not each:
        return []
    numbers = {f"bead {j}": dict(one) for j, one in enumerate(moved) if one}
    if len(each) > planes // 4:
        return [Finding("moved", "doubt", "planes are shifted beside each other: estimate drift", numbers)]
    each.sort(reverse=True)
    named = ", ".join(f"plane {plane} of bead {j} by {by:.2g} pixels" for by, plane, j in each[:3])
    more = f" and {len(each) - 3} more" if len(each) > 3 else ""
    return [Finding("moved", "note", f"moved: {named}{more}", numbers)]


def model_error(model: BeadModel, state: State) -> float:
    """Return the error of the search's images against certified ones of a point, over the peak; inf without these."""
    # Of a point: certified images are those of points.
    setup, place, stack = replace(state.setup, diameter=0.0, blur=0.0), state.places[0], model.stacks[0]
    wave = Wavefront.zernike(model.images.edge(state.waves), normalization="edge")
    # Both ends of the stack, where defocus is largest, and the middle.
    ends = np.unique([0, len(stack.z) // 2, len(stack.z) - 1])
    pupil = setup.pupil(wave, place.depth, place.focus + setup.step * stack.z[ends], "coverslip")
    center = (stack.shape[0] // 2 + place.row, stack.shape[1] // 2 + place.column)
    try:
        true = psf(pupil, stack.shape, setup.pixel, tol=1e-4, integrate=setup.integrate, center=center)
    except ValueError:  # aberrations beyond what is certified
        return math.inf
    few = Stack(stack.star[:, ends], stack.shape, stack.z[ends])
    quick = model.images.values(setup, state.waves, place._replace(drift_row=0.0, drift_column=0.0), few)
    return float(np.abs(quick - true.values).max() / true.values.max())
