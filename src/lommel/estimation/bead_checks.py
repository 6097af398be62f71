"""Checks of a fit of beads: neglected effects, planes in reversed order or displaced, a bead held out of the fit.

A constant is fixed, or estimated with a prior. A score test estimates the size of a neglected effect without a new
fit. `model` is the model of all used beads, `fit` is the fit of this model, and `stated` is the microscope with the
user's constants.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from typing import Any, TypeAlias

import numpy as np

from lommel.base.arrays import Array
from lommel.base.units import with_error
from lommel.core.answers import Declined
from lommel.estimation import bead_images
from lommel.estimation.bead_images import AMPLITUDES, CONSTANTS, DIPOLE, DYE, GRADIENT, UNITS, Setup, Stack, expected
from lommel.estimation.bead_search import (
    DRIFT,
    GROSS_CHI2,
    BeadModel,
    Evaluation,
    Prior,
    State,
    climb,
    start_of,
)
from lommel.estimation.favoured_effects import Estimate, Round, estimated_findings, rounds_of
from lommel.estimation.star_images import label, next_terms
from lommel.fit import goodness_of_fit
from lommel.fit.findings import Finding, Findings
from lommel.fit.model_error import jackknife
from lommel.fit.score_tests import (
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
from lommel.fit.scoring import Report, covariance
from lommel.methods.derivative_names import Term
from lommel.optics.layers.emitter import Dipole, emitter_of
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import psf

Pair: TypeAlias = tuple[BeadModel, Evaluation]

_REVERSED_GAIN = 12.0  # smallest increase of the log-posterior at which planes are reported as reversed
_REVERSED_CHI2 = 0.25  # largest ratio of chi2 - 1 of a reversed stack that fits badly to chi2 - 1 of the original
_GRADIENT = "background gradient"
_MIN_BEADS = 3  # smallest number of beads at which a bead is held out of the fit
STEPS = 20
"""Maximum number of steps of a search that starts at a fit."""
_TERM = 0.1  # expected size of a missing term, radians rms
_AMPLITUDE = "apodization_2"  # the only amplitude term that is tested if it is not estimated
_LINEAR_CHI2 = 1.5  # largest chi2 of a fit from which a step leaves out a bead
_MISFIT_BEADS = 2  # largest number of beads in further searches after a misfit
_MEDIA = {"coverslip", "immersion", "sample"}  # whose differences from the design are spherical aberration
_MAX_SIZES = 6.0  # largest plausible error of a stated constant, in expected sizes (`Constant.size`)
_MOST = {"step": 0.4}  # largest plausible errors of other constants: of steps that are those of another stack
_RIVAL_SIZES = 3.0  # standard error of the priors of constants that the data do not tell apart, in expected sizes
_ISOTROPIC = emitter_of("isotropic")
_POLARIZED = "a dye that keeps polarization"
# Effects that are parameters of each bead.
_BEAD_EFFECTS: Mapping[str, tuple[str, ...]] = {"depth": ("depth",), "drift": DRIFT, _GRADIENT: GRADIENT}
_SPANS = {"drift": " pixels from the middle to the end of the stack", _GRADIENT: " electrons from edge to edge"}
_DISPLACED = "displaced along z"
_UNLIKE = "unlike that of the other beads"
_MAX_ESTIMATES = 3  # largest number of estimates of an effect in a message
_MIN_BAYES_RATIO = 0.4  # smallest ln(Bayes factor) of a refitted candidate, divided by the largest ln(Bayes factor)
_WIDER_FACTOR = 3.0  # expected error of a constant whose prior is too narrow, in standard deviations of the prior
_STATED_SIGMAS, _STATED_SHARE = (
    3.0,
    0.02,
)  # difference from a stated constant that is reported: errors, and share of it
_NEIGHBOR = 0.3  # expected light of a neighbour, divided by the light of the bead
_MIN_DISTANCE = 2.0  # smallest distance of a neighbour, Rayleigh distances; a nearer bead would look like a wide one
_MOVED_RATIO = 4.0  # smallest significance of a displaced plane, divided by the median of all planes
_MOVED_SIGMAS = 5.0  # smallest significance of a displaced plane, standard deviations
_FAR = 5.0  # distance of an estimate from the mean of its prior, standard deviations, that is reported
_CONTRADICTED = 3.5  # smallest significance (standard deviations) at which the beads contradict a prior


def available_constants(setup: Setup) -> list[str]:
    """Return the names of the constants that may be estimated for this microscope; an index of 1 (air) is exact."""
    objective = setup.objective
    absent = {"coverslip": objective.coverslip is None, "diameter": setup.diameter == 0.0}
    absent |= dict.fromkeys(("jump", *DIPOLE), True)  # only estimated besides
    absent["sample"] = objective.sample == 1.0
    absent["immersion"] = objective.working_distance is None or objective.immersion == 1.0
    return [name for name in CONSTANTS if not absent.get(name, False)]


def is_possible(setup: Setup, name: str, value: float) -> bool:
    """Return whether a microscope with this value of a constant exists."""
    # The centre of a bead on the glass has a depth of half a diameter: errors of both allow for half of that.
    smallest = {"depth": 0.25 * setup.diameter, "diameter": 0.0, "blur": 0.0, "coverslip": 0.0}
    if name in smallest:
        return value >= smallest[name]
    if name in ("pixel", "step", "wavelength"):
        return value > 0.0
    with suppress(ValueError):
        setup.with_constant(name, value)
        return True
    return False


def _largest_error(stated: Setup, name: str) -> float:
    """Return the largest plausible error of a stated constant."""
    return _MOST.get(name, _MAX_SIZES * CONSTANTS[name].size * (1.0 if name == "depth" else stated.scale(name)))


def _is_plausible(model: BeadModel, stated: Setup, name: str, value: float) -> bool:
    """Return whether a constant may have this value although another one is stated."""
    reference = model.depths[0].value if name == "depth" else stated.value(name)
    return is_possible(stated, name, value) and abs(value - reference) <= _largest_error(stated, name)


def _displacements(planes: int) -> dict[str, Array]:
    """Return which planes (planes,) are displaced by a jump of the stage: a single plane, or all before the jump."""
    index = np.arange(planes)
    single = {f"plane {k} {_DISPLACED}": 1.0 * (index == k) for k in range(planes)}
    return single | {f"planes 0 to {k} {_DISPLACED}": 1.0 * (index <= k) for k in range(1, planes - 2)}


def _displacement_tests(
    model: BeadModel, parts: Sequence[bead_images.Part], information: Array, gradient: Array, unknowns: Sequence[int]
) -> list[ScoreTest]:
    """Return the test of the most likely displacement of planes along z, common to all beads."""
    masks, p = _displacements(len(model.stacks[0].z)), len(gradient)
    common_count = p - len(model.bead_parameters) * len(model.stacks)
    focus = common_count + model.bead_parameters.index("focus")
    planes = np.array([*masks.values()])
    mixed, diagonal, slope = np.zeros((p, len(masks))), *np.zeros((2, planes.shape[1]))
    # The focus of each plane is a parameter: its derivatives are those of the focus of the bead, plane by plane.
    for j, part in enumerate(parts):
        mixed[[*range(common_count), *model.columns(j, common_count)]] += (planes @ part.information[:, 0]).T
        diagonal, slope = diagonal + part.information[:, 0, focus], slope + part.gradient[:, focus]
    square = np.block([[information, mixed], [mixed.T, planes * diagonal @ planes.T]])
    candidates = [Candidate(name, (p + k,), CONSTANTS["jump"].size) for k, name in enumerate(masks)]
    tests = score_tests(square, np.concatenate([gradient, planes @ slope]), unknowns, candidates)
    # The penalty is for the search over planes.
    return [replace(test, log_bayes=test.log_bayes - math.log(len(masks))) for test in tests[:1]]


def _fixed_constants(model: BeadModel, setup: Setup) -> list[str]:
    """Return the names of the constants that are fixed in the fit and can be tested."""
    excluded_names = {*model.priors, *model.bead_parameters, *AMPLITUDES} - ({_AMPLITUDE} - {*model.priors})
    # Deeper than a wavelength, light does not reach an NA above the index of the sample: images do not depend on NA.
    if min(d.value for d in model.depths) > setup.wavelength and setup.objective.sample < setup.objective.NA:
        excluded_names.add("NA")
    return [name for name in available_constants(setup) if name not in excluded_names]


def _prior_candidates(model: BeadModel, fit: Evaluation, names: Sequence[object]) -> list[Candidate]:
    """Return a candidate for each prior that may be too narrow; `names` are the names of the common columns."""
    setup, candidates = fit.state.setup, []
    for name, (value, sigma) in model.priors.items():
        if math.isfinite(sigma):
            deviation = setup.value(name) - value
            candidates.append(Candidate(name, (names.index(name),), _WIDER_FACTOR * sigma, sigma, deviation))
    if "depth" in model.bead_parameters:
        columns = _bead_columns(model, ("depth",), len(names))
        deviations = [place.depth - prior.value for place, prior in zip(fit.state.places, model.depths, strict=True)]
        sigma = model.depths[0].error
        candidates.append(Candidate("depth", columns, _WIDER_FACTOR * sigma, sigma, np.array(deviations)))
    return candidates


def _bead_columns(model: BeadModel, parameters: Sequence[str], common_count: int) -> tuple[int, ...]:
    """Return the columns of some parameters of all beads."""
    indices = [model.bead_parameters.index(name) for name in parameters]
    return tuple(model.columns(j, common_count)[index] for j in range(len(model.stacks)) for index in indices)


def missing_tests(model: BeadModel, fit: Evaluation) -> tuple[tuple[ScoreTest, ...], Marginal | None, list[Finding]]:
    """Return tests of neglected effects, a marginalized correction, and findings on untested constants.

    1. Score tests of further terms, other constants, drift, background gradients, a nonlinear gain and neighbouring
    beads, the most likely first. 2. Shift and covariance of the common parameters after marginalizing favoured
    effects; None without favoured effects. 3. Findings on fixed constants that the stacks do not test.
    """
    setup, images = fit.state.setup, model.images
    added_terms = next_terms(images.estimated_terms, ((2, 0), *images.fixed_terms))
    wider_model = replace(model, images=images.with_terms(added_terms), gradients=True)
    waves = np.concatenate([fit.state.waves, np.zeros(len(added_terms))])
    constants = _fixed_constants(model, setup)
    drift = () if model.drifts else DRIFT
    dye = tuple(DYE) if setup.emitter == _ISOTROPIC else ()
    added_names = [*constants, *drift, *dye, bead_images.NONLINEAR]  # columns after the common parameters
    parts, information, gradient = wider_model.normal_equations(
        replace(fit.state, waves=waves), fit.values, added_names, whole=False
    )
    names = [*wider_model.names, *added_names]
    gradients = () if model.gradients else _bead_columns(wider_model, GRADIENT, len(names))
    unknowns = [*map(names.index, model.names), *(k for k in range(len(names), len(gradient)) if k not in gradients)]
    candidates = [Candidate(label(term), (names.index(term),), _TERM) for term in added_terms]
    candidates += _prior_candidates(wider_model, fit, names)
    constant_candidates = [Candidate(n, (names.index(n),), setup.scale(n) * CONSTANTS[n].size) for n in constants]
    candidates += constant_candidates
    # Expected sizes: drift, pixels over half the stack; gradient, electrons over the window; fraction lost at 10^4.
    groups = {"drift": (tuple(map(names.index, drift)), 0.3), _GRADIENT: (gradients, 5.0)}
    groups["non-linear gain"] = (names.index(bead_images.NONLINEAR),), 0.05
    groups[_POLARIZED] = tuple(map(names.index, dye)), 0.3  # fractions that prefer an axis
    candidates += [Candidate(name, columns, size) for name, (columns, size) in groups.items() if columns]
    tests = (*score_tests(information, gradient, unknowns, candidates), *_neighbor_tests(model, fit))
    if "jump" not in model.priors:
        tests += (*_displacement_tests(wider_model, parts, information, gradient, unknowns),)
    if images.estimated_terms and len(model.stacks) > 1:
        parts_of_fit = parts, information, gradient, unknowns
        tests += (*_differing_tests(wider_model, images.estimated_terms, *parts_of_fit),)
    favoured_candidates = [candidate for candidate in candidates if candidate.name in favoured(tests)]
    for candidate in favoured_candidates:
        if candidate.known:  # a prior that is too narrow
            information, gradient = candidate.widened(information, gradient)
    missing_candidates = [candidate for candidate in favoured_candidates if not candidate.known]
    marginal = None
    if favoured_candidates:
        marginal = marginalized(information, gradient, unknowns, missing_candidates, len(model.names))
        # Of n candidates, one has a Bayes factor of n by chance: models with and without the effects are averaged.
        chosen, count = {candidate.name for candidate in favoured_candidates}, len(model.names)
        odds = sum(math.exp(min(test.log_bayes, 20.0)) for test in tests if test.name in chosen) / len(tests)
        without, weight = covariance(fit.scores.information[0])[:count, :count], odds / (1.0 + odds)
        spread = weight * (marginal.covariance + (1.0 - weight) * np.outer(marginal.shift, marginal.shift))
        marginal = marginal._replace(shift=weight * marginal.shift, covariance=(1.0 - weight) * without + spread)
    columns_of_terms = {label(name): index for index, name in enumerate(images.estimated_terms)}
    effects = untested(information, unknowns, columns_of_terms, constant_candidates, tests)
    errors = {test.name: float(test.errors.max()) for test in tests}
    priors = [c.name for c in candidates if 0.0 < c.known < errors.get(c.name, math.inf)]
    units = [(c.name, c.scale, *_unit(c.name)) for c in constant_candidates]
    sizes = {name: f"{factor * scale:.3g}{unit} of it" for name, scale, factor, unit in units}
    notes = untested_findings(effects, sizes, priors)
    return tuple(sorted(tests, key=lambda test: -test.log_bayes)), marginal, notes


def _differing_tests(
    model: BeadModel, terms: Sequence[Term], parts: Sequence[bead_images.Part], information: Array, gradient: Array,
    unknowns: Sequence[int],
) -> list[ScoreTest]:  # fmt: skip
    """Return the test of the term that most likely differs between a bead and the other beads, as over a field."""
    p, count, beads = len(gradient), len(terms), len(model.stacks)
    common_count, size = p - len(model.bead_parameters) * beads, p + count * beads
    square, slope = np.zeros((size, size)), np.concatenate([gradient, np.zeros(count * beads)])
    square[:p, :p] = information
    for j, part in enumerate(parts):
        own, columns = part.total[:count], [*range(common_count), *model.columns(j, common_count)]
        rows = np.arange(p + j * count, p + (j + 1) * count)
        square[np.ix_(rows, columns)], square[np.ix_(columns, rows)] = own, own.T
        square[np.ix_(rows, rows)], slope[rows] = own[:, :count], part.gradient.sum(axis=0)[:count]
    names = [f"{label(term)} of bead {j} {_UNLIKE}" for j in range(beads) for term in terms]
    tests = score_tests(square, slope, unknowns, [Candidate(name, (p + k,), _TERM) for k, name in enumerate(names)])
    return [replace(test, log_bayes=test.log_bayes - math.log(len(names))) for test in tests[:1]]


def beads_differ(tests: Sequence[ScoreTest]) -> bool:
    """Return whether a term that differs between beads is the most likely of the significant effects."""
    return bool(likely := seen(tests)) and likely[0].name.endswith(_UNLIKE)


def _neighbor_tests(model: BeadModel, fit: Evaluation) -> list[ScoreTest]:
    """Return a test for a second bead near each bead, at the same focus and at the most likely position."""
    setup, tests, stacks = fit.state.setup, [], model.level_stacks(fit.state)
    # Rayleigh's distance, 0.61 lambda / NA, in pixels of the camera.
    min_distance = (
        _MIN_DISTANCE * 0.61 * setup.wavelength * setup.objective.magnification / (setup.objective.NA * setup.pixel)
    )
    for k, (stack, values, flux_background) in enumerate(zip(stacks, fit.values, fit.state.light, strict=True)):
        bead, mean = flux_background[0][:, None, None] * values, expected(flux_background, values)
        counted, read, valid = stack.planes
        # The variance is the mean of the Poisson counts plus read noise; the lower limit is for a negative `mean`.
        weight = valid / np.maximum(mean + read, 0.25 * read)
        # Arrays with twice the sides of the images: correlations do not wrap around.
        size = tuple(2 * side for side in stack.shape)
        conjugate = np.conj(np.fft.rfft2(bead, size))
        # Slope and information for a copy of the bead at every shift are correlations: sums over pixels of
        # weight * (counted - mean) * (shifted bead), and of weight * (shifted bead)^2.
        gradient = np.fft.irfft2((np.fft.rfft2(weight * (counted - mean), size) * conjugate).sum(axis=0), size)
        spectra = np.fft.rfft2(weight, size) * np.conj(np.fft.rfft2(bead**2, size))
        information = np.fft.irfft2(spectra.sum(axis=0), size)
        rows, columns = (np.fft.fftfreq(side, 1.0 / side) for side in size)
        inside_window = (np.abs(rows) <= stack.shape[0] / 2.0)[:, None] & (np.abs(columns) <= stack.shape[1] / 2.0)
        far_enough = inside_window & (np.hypot(rows[:, None], columns) >= min_distance)
        allowed = far_enough & (gradient > 0.0) & (information > 1e-12 * information.max())
        if not allowed.any():
            continue
        sigmas = np.where(allowed, gradient, 0.0) / np.sqrt(np.where(allowed, information, 1.0))
        row, column = np.unravel_index(int(sigmas.argmax()), sigmas.shape)
        ratio, error = gradient[row, column] / information[row, column], 1.0 / math.sqrt(information[row, column])
        # The penalty for the search over positions is the log of the number of independent positions.
        penalty = math.log(allowed.sum() / max(math.pi * (min_distance / _MIN_DISTANCE) ** 2, 1.0) + 1.0)
        evidence = log_bayes_factor(np.array([ratio]), np.array([[error**2]]), 0.0, _NEIGHBOR) - penalty
        name = f"a neighbor of bead {k} by {rows[row]:.0f} rows and {columns[column]:.0f} columns, share of its light"
        tests.append(ScoreTest(name, np.array([ratio]), np.array([error]), float(sigmas.max()), evidence))
    return tests


def rounds(model: BeadModel, fit: Evaluation, stated: Setup, report: Report) -> list[Round]:
    """Return the round of a fit with its checks, and rounds with further effects, up to the last that fits well."""
    whole = dict[tuple[str, ...], Pair]()  # refits with all beads

    def refit(pair: Pair, test: ScoreTest) -> tuple[Pair, float] | None:
        few = pair if pair[1].fits(goodness_of_fit.BY_CHANCE) else brightest_beads(*pair)
        freed = _refit_with_free(*few, [test.name], stated, report)
        if freed is not None and few[1] is pair[1] and freed[1].settled:
            whole[(test.name,)] = freed
        return freed and (freed, freed[1].log_posterior - few[1].log_posterior)

    def jointly(pair: Pair, names: Sequence[str]) -> Pair | None:
        freed = whole.get(tuple(names)) or _refit_with_free(*pair, names, stated, report, 3 * STEPS)
        whole.clear()
        if freed is None or not freed[1].settled:
            return None
        state = freed[1].state
        values = [("depth", place.depth) for place in state.places if "depth" in names]
        values += [(name, state.setup.value(name)) for name in names if name in freed[0].priors]
        return freed if all(_is_plausible(pair[0], stated, *value) for value in values) else None

    found = rounds_of(
        (model, fit), lambda pair, *_: missing_tests(*pair), refit, partial(likely_tests, model), jointly
    )
    good = [k for k, one in enumerate(found) if one.fit[1].fits(goodness_of_fit.BY_CHANCE)]
    return found[: max(good, default=0) + 1]


def likely_tests(model: BeadModel, tests: Sequence[ScoreTest]) -> Sequence[ScoreTest]:
    """Return tests of effects that may be the cause; score tests are linear approximations, which refits rank."""
    if not (significant := seen(tests)):
        # There are few priors: a contradiction is significant even if it is not among all candidates.
        return [test for test in tests if test.name in model.priors and abs(test.sigmas) > _CONTRADICTED]
    limit = min(_MIN_BAYES_RATIO * tests[0].log_bayes, significant[-1].log_bayes)
    return [test for test in tests if test.log_bayes >= limit]


def missing_findings(last: Round, stated: Setup, known: BeadModel) -> tuple[list[Finding], float]:
    """Return the finding on significant effects, and the gain of log-posterior by the best one.

    Where the best is a constant that the fit estimates far from its prior in the model `known`, this is the finding.
    """
    (model, fit), (tests, *_), tried = last.fit, last.checks, last.tried
    tried = tried or [(test, None, test.log_bayes) for test in likely_tests(model, tests)]
    suffix = "" if seen(tests) else ", against its prior"
    words = [_in_words(test, model, stated, refit and refit[1]) + suffix for test, refit, _ in tried]
    finding = [other_explanation([test for test, *_ in tried], words)] if tried else []
    if tried and tried[0][0].name in (far := _far_from_priors(known, fit.state, last.names)):
        rivals = [text for text, one in zip(words, tried, strict=True) if one[0].name not in far]
        finding = prior_findings(known, fit.state, last.names, rivals)
    return finding, max((gain for *_, gain in tried), default=0.0)


def brightest_beads(model: BeadModel, fit: Evaluation) -> tuple[BeadModel, Evaluation]:
    """Return model and fit of the brightest beads alone, for searches in which more beads only take time."""
    if len(model.stacks) <= _MISFIT_BEADS:
        return model, fit
    beads = model.brightest_first()[:_MISFIT_BEADS]
    few_model = model.with_beads(beads)
    return few_model, few_model.evaluate(_restricted(fit.state, beads))


def _restricted(state: State, beads: Sequence[int]) -> State:
    """Return the state of the beads with these indices."""
    return replace(state, places=tuple(state.places[k] for k in beads), light=tuple(state.light[k] for k in beads))


def _in_words(test: ScoreTest, model: BeadModel, stated: Setup, refit: Evaluation | None) -> str:
    """Return the result of a test as text, like "sample = 1.379 +- 0.005"; the fit `refit` estimates the effect."""
    name, values, sigmas = test.name, test.size, f"({abs(test.sigmas):.2g} sigma)"
    if name == _POLARIZED:
        weights = 1.0 + np.array([[2.0, -1.0, 0.5], [-1.0, 2.0, 0.5], [-1.0, -1.0, -1.0]]) @ values
        return f"{name}, dipole weights {' : '.join(f'{weight:.2f}' for weight in weights)} along x, y, z {sigmas}"
    if name in CONSTANTS:
        is_depth = name == "depth"
        stated_value = model.depths[0].value if is_depth else stated.value(name)
        values = values + ([prior.value for prior in model.depths][: values.size] if is_depth else stated_value)
        if refit is not None:
            places = refit.state.places
            new = np.array([one.depth for one in places] if is_depth else [refit.state.setup.value(name)])
            values = new if new.size == values.size and is_possible(stated, name, new.min()) else values
        if not all(_is_plausible(model, stated, name, value) for value in values.tolist()):
            direction, (factor, unit) = "lower" if values[0] < stated_value else "higher", _unit(name, model)
            beyond = f"by more than {factor * _largest_error(stated, name):.3g}{unit}"
            if not all(is_possible(stated, name, value) for value in values.tolist()):
                beyond = "beyond what is possible"
            return f"{name} {direction} than {factor * stated_value:.6g}{unit}, {beyond} {sigmas}"
    elif refit is not None and len(refit.state.waves) > len(model.images.estimated_terms):
        values = refit.state.waves[-1:]
    return f"{_estimate(name, values, test.errors, model, stated)} {sigmas}"


def _unit(name: str, model: BeadModel | None = None) -> tuple[float, str]:
    """Return the factor to the unit of an effect in messages, and its name; of the step of a `model`, nanometres."""
    if name == "step" and model is not None:
        z = model.stacks[0].z
        return 1e9 * abs(float(z[-1] - z[0])) / (len(z) - 1), " nm"
    if name in CONSTANTS:
        return UNITS[CONSTANTS[name].unit]
    if name.endswith(_DISPLACED):
        return 1e9, " nm"
    return 1.0, " rad" if name.startswith("noll") else _SPANS.get(name, "")


def _estimate(name: str, values: Array, errors: Array, model: BeadModel, stated: Setup) -> str:
    """Return estimates of an effect and their standard errors as text; only the first if there are many."""
    (factor, unit), suffix = _unit(name, model), ""
    if name in CONSTANTS:
        suffix = f", stated {factor * (model.depths[0].value if name == 'depth' else stated.value(name)):.6g}"
    texts = [" +- ".join(with_error(factor * v, factor * e)) for v, e in zip(values, errors, strict=True)]
    more = ", ..." if len(texts) > _MAX_ESTIMATES else ""
    return f"{name} = {', '.join(texts[:_MAX_ESTIMATES])}{more}{unit}{suffix}"


def _with_free(model: BeadModel, state: State, names: Sequence[str], stated: Setup) -> tuple[BeadModel, State] | None:
    """Return model and start in which the effects `names` are estimated; None if one of them cannot be.

    A single constant has no prior. Several constants, which the data do not tell apart, have wide priors.
    """
    for name in names:
        priors, images, width = dict(model.priors), model.images, _RIVAL_SIZES if len(names) > 1 else math.inf
        if name == "depth":
            error = width * CONSTANTS[name].size
            model = replace(model, depths=tuple(Prior(prior.value, error) for prior in model.depths))
        elif name in CONSTANTS:
            priors[name] = Prior(stated.value(name), width * CONSTANTS[name].size * stated.scale(name))
            model = replace(model, priors=priors)
        elif name.endswith(_DISPLACED):
            mask = _displacements(len(model.stacks[0].z))[name]
            stacks = tuple(replace(stack, displaced=mask) for stack in model.stacks)
            model = replace(model, stacks=stacks, priors=priors | {"jump": Prior(0.0, math.inf)})
        elif name == _POLARIZED:
            model = replace(model, priors=priors | dict.fromkeys(DIPOLE, Prior(0.0, math.inf)))
            # Lateral dipoles at four azimuths: the search starts at the most likely.
            dipoles = (Dipole(0.5 * math.pi, 0.25 * math.pi * k, wobble=0.7) for k in range(4))
            states = [replace(state, setup=replace(state.setup, emitter=dipole)) for dipole in dipoles]
            state = max(states, key=lambda one: model.evaluate(one).log_posterior)
        elif name in ("drift", _GRADIENT):
            drifts = model.drifts or name == "drift"
            model = replace(model, drifts=drifts, gradients=model.gradients or name == _GRADIENT)
        else:
            candidates = next_terms(images.estimated_terms, ((2, 0), *images.fixed_terms))
            terms = [term for term in candidates if label(term) == name]
            if not terms:
                return None
            model = replace(model, images=images.with_terms(terms))
            state = replace(state, waves=np.append(state.waves, np.zeros(len(terms))))
    return model, state


def _refit_with_free(
    model: BeadModel, fit: Evaluation, names: Sequence[str], stated: Setup, report: Report, steps: int = STEPS
) -> tuple[BeadModel, Evaluation] | None:
    """Return model and fit with the effects `names` estimated without narrow priors; None if not possible."""
    freed = _with_free(model, fit.state, names, stated) if fit.quality[0] < GROSS_CHI2 else None
    with suppress(Declined, ValueError):
        return None if freed is None else (freed[0], climb(*freed, steps, report))
    return None


def estimates_of(first: Round, last: Round, stated: Setup) -> list[Finding]:
    """Return the finding on effects that the last round estimates besides."""
    (model, fit), before = last.fit, first.fit[1]
    errors, first_errors = (np.sqrt(np.diag(covariance(one.scores.information[0]))) for one in (fit, before))
    values = [*fit.state.waves, *map(fit.state.setup.value, model.priors)]
    keys, estimates = [name if isinstance(name, str) else label(name) for name in model.names], list[Estimate]()
    for name in last.names:
        factor, unit = _unit(name, model)
        for j, place in enumerate(fit.state.places):
            for key in _BEAD_EFFECTS.get(name, ()):
                column, known = model.columns(j, len(keys))[model.bead_parameters.index(key)], model.depths[j].value
                pair, zero = (getattr(place, key), float(errors[column])), known if name == "depth" else 0.0
                estimates.append(Estimate(f"{key} of bead {j}", *pair, zero, unit, factor))
        if name not in _BEAD_EFFECTS:
            key = DIPOLE[0] if name == _POLARIZED else name if name in keys else "jump"
            column, known = keys.index(key), stated.value(key) if key in CONSTANTS and key != "jump" else 0.0
            shown = f"{name}, {key}" if name == _POLARIZED else name
            estimates.append(Estimate(shown, float(values[column]), float(errors[column]), known, unit, factor))
    estimates.sort(key=lambda one: -abs(one.value - one.stated) / one.error)
    count = len(before.state.waves)
    moves = np.abs(fit.state.waves[:count] - before.state.waves) / first_errors[:count]
    return estimated_findings(estimates, dict(zip(keys, moves.tolist(), strict=False)))


def stated_findings(
    stated: Setup, values: Mapping[Any, float], errors: Mapping[Any, float], named: Sequence[str]
) -> list[Finding]:
    """Return the finding on estimated constants that differ from the stated ones and are not `named` elsewhere."""
    found = list[Estimate]()
    for name in values.keys() - {*named, *DIPOLE}:
        known = stated.value(name) if name in CONSTANTS else 0.0
        far = abs(values[name] - known) > max(_STATED_SIGMAS * errors[name], _STATED_SHARE * abs(known))
        if known and far and math.isfinite(errors[name]):
            factor, unit = _unit(name)
            found.append(Estimate(name, values[name], errors[name], known, unit, factor))
    found.sort(key=lambda one: -abs(one.value - one.stated) / one.error)
    text = f"estimated unlike stated: {', '.join(map(str, found))}: terms allow for it, and the file may be wrong"
    return [Finding("estimated", "note", text, {one.name: one.numbers for one in found})] if found else []


def _far_from_priors(model: BeadModel, state: State, freed: Sequence[str]) -> dict[str, float]:
    """Return estimated constants far from their priors in `model`, unless `freed` from them, in prior errors."""
    priors = {name: prior for name, prior in model.priors.items() if name not in freed}
    sizes = {n: (state.setup.value(n) - prior.value) / prior.error for n, prior in priors.items()}
    return {n: sizes[n] for n in sorted(sizes, key=lambda n: -abs(sizes[n])) if abs(sizes[n]) > _FAR}


def prior_findings(
    model: BeadModel, state: State, freed: Sequence[str] = (), rivals: Sequence[str] = ()
) -> list[Finding]:
    """Return the finding on estimated constants that lie many standard deviations from the priors of `model`.

    Those that are `freed` from their priors have another finding. `rivals` are other explanations, in words.
    """
    far, texts = _far_from_priors(model, state, freed), list[str]()
    for name in far:
        (factor, unit), prior = _unit(name, model), model.priors[name]
        pair = (
            f"{factor * state.setup.value(name):.4g}{unit}",
            f"{factor * prior.value:.4g} +- {factor * prior.error:.2g}",
        )
        texts.append(f"{name} {pair[0]} is {abs(far[name]):.2g} prior errors from {pair[1]}")
    instead = f", or as well {' or '.join(rivals[:3])}, which the data cannot tell apart" if rivals else ""
    text = f"{', '.join(texts)}{instead}: a stated value is wrong, or these stand for another error of the model"
    return [Finding("contradiction", "doubt", text, far)] if far else []


def with_strehl(findings: Findings, strehl: tuple[float, float]) -> Findings:
    """Return findings in which media far from their priors are spherical aberration, with its Strehl ratio."""
    told = findings.get("contradiction")
    if told is None or not _MEDIA & told.numbers.keys():
        return findings
    cost = " +- ".join(with_error(*strehl))
    cause = f"they stand for spherical aberration: the Strehl ratio is {cost}"
    text = told.text.replace("these stand for another error of the model", cause)
    changed = replace(told, text=text, numbers={**told.numbers, "strehl": strehl[0], "strehl_error": strehl[1]})
    return Findings([changed if one is told else one for one in findings])


def reversed_findings(
    model: BeadModel, start: State, best_posterior: float, chi2: float, report: Report
) -> list[Finding]:
    """Return the finding of planes in reversed order, if these fit well and better than `best_posterior`.

    If the chi2 of reversed planes is nearly `chi2`, not the order but the step or the objective is wrong. The search
    starts from `start`, with the even terms of the opposite sign: in a symmetric set-up, this is the same fit.
    """
    even = np.array([n % 2 == 0 for n, _ in model.images.estimated_terms], dtype=bool)
    waves = np.where(even, -start.waves, start.waves)
    stacks = tuple(replace(stack, z=-stack.z) for stack in model.stacks)
    places = tuple(start_of(s, start.setup, d.value, 0.0) for s, d in zip(stacks, model.depths, strict=True))
    try:
        steps = STEPS if chi2 < GROSS_CHI2 else STEPS // 2
        reversed_fit = climb(replace(model, stacks=stacks), State(start.setup, waves, places), steps, report)
    except (Declined, ValueError):
        return []
    (reversed_chi2, deviation), gain = reversed_fit.quality, reversed_fit.log_posterior - best_posterior
    # If the model has another error as well, chi2 remains large: then a much smaller chi2 than before suffices.
    limit = max(float(goodness_of_fit.largest_plausible_chi2(deviation)), 1.0 + _REVERSED_CHI2 * (chi2 - 1.0))
    good_fit = reversed_chi2 < limit
    if gain < _REVERSED_GAIN or not good_fit:
        return []
    text = (
        f"planes in reversed order fit far better, chi2 {reversed_chi2:.4g}; z must increase towards the sample: "
        "change the sign of the step"
    )
    return [Finding("reversed_z", "error", text, {"chi2": reversed_chi2, "log_likelihood": gain})]


def held_out(model: BeadModel, fit: Evaluation, report: Report) -> tuple[float, list[Finding]]:
    """Return chi2 of the last bead with common parameters of the other beads, and a finding if it is too large."""
    count, state = len(model.stacks), fit.state
    if count < _MIN_BEADS:
        return math.nan, []
    others: Sequence[int] = range(count - 1)
    if not fit.fits(goodness_of_fit.BY_CHANCE):  # a misfit: few beads suffice
        others = [k for k in model.brightest_first() if k < count - 1][:_MISFIT_BEADS]
    others_model, held_out_model = model.with_beads(others), model.with_beads([count - 1])
    try:
        start = _restricted(state, others)
        others_state = _without_last(model, fit) or climb(others_model, start, STEPS, report).state
        fixed_model = replace(held_out_model, images=model.images.without_terms(others_state.waves), priors={})
        start = State(others_state.setup, np.zeros(0), state.places[-1:], state.light[-1:])
        held_out_fit = climb(fixed_model, start, STEPS, report)
    except (Declined, ValueError):
        return math.nan, []
    chi2, limit = held_out_fit.quality[0], float(goodness_of_fit.largest_plausible_chi2(held_out_fit.quality[1]))
    text = f"chi2 of the held-out bead is above {limit:.4g}, the limit for noise alone: beads differ in size or depth"
    return chi2, [Finding("held_out", "doubt", text, {"chi2": chi2, "limit": limit})] if chi2 >= limit else []


def _without_last(model: BeadModel, fit: Evaluation) -> State | None:
    """Return the state without the last bead, by one step from a settled fit; None if that is a clear misfit."""
    if not fit.settled or fit.quality[0] > _LINEAR_CHI2:
        return None
    part, size, k = fit.parts[-1], model.size, len(model.names)
    kept = np.arange(size - len(model.bead_parameters))
    information, slope = fit.scores.information[0][np.ix_(kept, kept)].copy(), fit.scores.slope[0][kept].copy()
    information[:k, :k] -= part.total[:k, :k]
    slope[:k] -= part.gradient.sum(axis=0)[:k]
    variance, beads = covariance(information), range(len(model.stacks) - 1)
    step = np.where(np.isfinite(variance), variance, 0.0) @ slope
    return model.with_beads(beads).after_step(_restricted(fit.state, beads), step)


def plane_jackknife(model: BeadModel, fit: Evaluation) -> Array:
    """Return the covariance (p, p) of all parameters by the jackknife over planes, each left out of all stacks."""
    k, planes = len(model.names), len(model.stacks[0].z)
    information, slope = np.zeros((planes, model.size, model.size)), np.zeros((planes, model.size))
    for j, part in enumerate(fit.parts):
        columns = [*range(k), *model.columns(j, k)]
        information[np.ix_(range(planes), columns, columns)] += part.information
        slope[:, columns] += part.gradient
    return jackknife(information, slope, (fit.scores.information[0], fit.scores.slope[0]))


def moved_planes(shifts: Array, sigmas: Array) -> dict[int, tuple[float, float]]:
    """Return the indices and shifts of planes whose shift is more significant than the limits."""
    indices = np.flatnonzero(sigmas > max(_MOVED_SIGMAS, _MOVED_RATIO * float(np.median(sigmas))))
    return {int(k): (float(shifts[k, 0]), float(shifts[k, 1])) for k in indices}


def moved_findings(moved: Sequence[dict[int, tuple[float, float]]], planes: int) -> list[Finding]:
    """Return the finding on displaced planes: `moved` are those of each bead, `planes` is the total number."""
    moves = [(math.hypot(*shift), plane, j) for j, shifts in enumerate(moved) for plane, shift in shifts.items()]
    if not moves:
        return []
    numbers = {f"bead {j}": dict(shifts) for j, shifts in enumerate(moved) if shifts}
    if len(moves) > planes // 4:
        return [Finding("moved", "doubt", "planes are shifted relative to each other: estimate drift", numbers)]
    moves.sort(reverse=True)
    examples = ", ".join(f"plane {plane} of bead {j} by {shift:.2g} pixels" for shift, plane, j in moves[:3])
    suffix = f" and {len(moves) - 3} more" if len(moves) > 3 else ""
    return [Finding("moved", "note", f"moved: {examples}{suffix}", numbers)]


def model_error(model: BeadModel, state: State) -> float:
    """Return the largest difference between images of the search and PSFs with a proven bound, relative to the peak.

    Both are images of a point. The result is inf if the aberrations are too strong for :func:`lommel.psf`.
    """
    planes = len(model.stacks[0].z)
    # Compare the middle plane, and the first and the last, in which defocus is largest.
    pair = _point_images(model, state, sorted({0, planes // 2, planes - 1}))
    return math.inf if pair is None else float(np.abs(pair[0] - pair[1]).max() / pair[1].max())


def moved_by_model_error(model: BeadModel, fit: Evaluation) -> tuple[str, float]:
    """Return the estimate that the error of the images of the search moves most, and by how many standard errors.

    It is one step of Fisher scoring from images that differ by that error. That of the first bead stands for others.
    """
    pair = _point_images(model, fit.state, range(len(model.stacks[0].z)))
    if pair is None:
        return "estimates", math.inf
    error, stacks = (pair[1] - pair[0]).reshape(len(pair[0]), -1), list[Stack]()
    for stack, light in zip(model.stacks, fit.state.light, strict=True):
        data = stack.pixel_data.copy()
        data[0] += light[0][:, None] * error
        stacks.append(replace(stack, pixel_data=data))
    gradient = replace(model, stacks=tuple(stacks)).normal_equations(fit.state, fit.values)[2]
    spread = covariance(fit.scores.information[0])
    moves = np.abs(spread @ (gradient - fit.scores.slope[0])) / np.sqrt(np.diag(spread))
    names = [name if isinstance(name, str) else label(name) for name in model.names]
    names += [
        f"{'z' if name == 'focus' else name} of bead {k}"
        for k in range(len(stacks))
        for name in model.bead_parameters
    ]
    return names[int(moves.argmax())], float(moves.max())


def _point_images(model: BeadModel, state: State, planes: Sequence[int]) -> tuple[Array, Array] | None:
    """Return images of a point in planes by the search and by :func:`lommel.psf`; None if that declines them."""
    index = np.array(planes)
    setup, place, stack = replace(state.setup, diameter=0.0, blur=0.0, jump=0.0), state.places[0], model.stacks[0]
    wave = Wavefront.zernike(model.images.edge(state.waves), normalization="edge")
    pupil = setup.pupil(wave, place.depth, place.focus + setup.step * stack.z[index], "coverslip")
    center = (stack.shape[0] // 2 + place.row, stack.shape[1] // 2 + place.column)
    try:
        proven = psf(pupil, stack.shape, setup.pixel, tol=1e-4, integrate=setup.integrate, center=center)
    except ValueError:  # the aberrations are too strong
        return None
    shown = Stack(stack.pixel_data[:, index], stack.shape, stack.z[index])
    search_images = model.images.values(setup, state.waves, place._replace(drift_row=0.0, drift_column=0.0), shown)
    return search_images, proven.values
