"""Maximum-likelihood search for stacks of beads: Fisher scoring, starts, and rejection of inconsistent beads.

Flux and background of each plane (`light`) are eliminated: they have their maximum-likelihood values for given other
parameters.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import NamedTuple, TypeAlias

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Declined
from lommel.core.engine import star_likelihood
from lommel.estimation import bead_images
from lommel.estimation.bead_images import AMPLITUDES, CONSTANTS, DYE, GRADIENT, BeadImages, Part, Place, Setup, Stack
from lommel.fit.goodness_of_fit import BY_CHANCE, SURE, largest_plausible_chi2
from lommel.fit.scoring import Report, Rows, Scores, damped_steps, fisher_scoring, reduced_chi2

Derivatives: TypeAlias = tuple[list[Array], Array]

POSITION = ("row", "column", "focus")
DRIFT = ("drift_row", "drift_column")
_MAX_NA = 1.0 - 1e-5  # largest NA relative to the index of the immersion
_MAX_WAVE_STEP = 1.0  # radians rms: largest change of the wavefront in a step
_SAME_MAXIMUM = 1.0  # difference of log-posterior below which two starts are assumed to end at the same maximum
_SAME_MISFIT = 0.01  # the same for bad fits: difference of chi2, relative to chi2 in excess of 1
MIN_FLUX_SIGMAS = 10.0
"""Smallest total flux of a visible bead in all planes, in standard deviations."""
_DARK_SIGMAS = 5.0  # the same before the search, in which aberrations are not known yet
_SMALL_GAIN = 3.0  # predicted increase of the log-posterior of a step after which derivatives are kept
_PLACE_STEPS = 20  # largest number of steps of a search for the place of a bead
_PILOTS = 2  # number of beads with which the search for a misfit begins
_PROBES = 5  # number of beads that are fitted alone before the others: if all are a misfit, so are the others
_MISFIT_STEPS = 10  # largest number of steps with all beads, if the pilots are a misfit for all constants
GROSS_CHI2 = 20.0
"""Chi2 above which an image is not taken for that of a bead: no usual error of a constant is the cause."""
MAX_CHI2_RATIO = 1.5
"""Beads whose chi2 exceeds this times the median of all beads are left out."""
ORIGINS = (0.0, -0.35e-6, 0.35e-6, -0.7e-6, 0.7e-6)
"""Shift of the initial focus, metres of the stage, for each start."""
# Largest changes in a step: focus and depth in metres, the others in pixels.
_MAX_STEPS = {"focus": 0.3e-6, "row": 1.0, "column": 1.0, "drift_row": 1.0, "drift_column": 1.0, "depth": 0.3e-6}
_MAX_STEPS |= dict.fromkeys(GRADIENT, math.inf)


class Prior(NamedTuple):
    """Normal prior of a constant: value, and standard error (inf without prior knowledge)."""

    value: float
    error: float

    def score(self, estimate: float) -> tuple[float, float, float]:
        """Return -ln(prior), the derivative of ln(prior), and the information, if the constant is `estimate`."""
        information = 1.0 / self.error**2
        difference = self.value - estimate
        return 0.5 * difference * difference * information, difference * information, information


@dataclass(frozen=True, eq=False)
class State:
    """A set of parameters of a model.

    `waves` are the coefficients of the wavefront (radians rms), `setup` are the constants of the microscope, `places`
    the positions of the beads, and `light` flux and background of each plane, an array (2, planes) for each bead.
    """

    setup: Setup
    waves: Array
    places: tuple[Place, ...]
    light: tuple[Array, ...] = ()


@dataclass(frozen=True, eq=False)
class Evaluation:
    """A state with its images and scores, the number of steps of the search, and whether the search settled.

    `values` are the PSFs of each stack, and `parts` the contributions of each stack to the scores. `scores` include
    the priors and have one row: first the common parameters, then the parameters of each bead. `derivatives` are
    those of the images of each stack, with the chain rule, in a search only: they are large.
    """

    state: State
    values: list[Array]
    parts: list[Part]
    scores: Scores
    settled: bool = False
    steps: int = 0
    derivatives: list[Derivatives] | None = None

    @property
    def log_posterior(self) -> float:
        """Logarithm of the product of likelihood and priors."""
        return -float(self.scores.deviance[0])

    @property
    def quality(self) -> tuple[float, float]:
        """Chi2 and the standard deviation of chi2."""
        return float(self.scores.chi2[0]), float(self.scores.spread[0])

    def fits(self, probability: float) -> bool:
        """Whether noise alone exceeds chi2 with at least this probability."""
        chi2, deviation = self.quality
        return bool(chi2 < largest_plausible_chi2(deviation, probability))


@dataclass(eq=False)
class BeadModel:
    """A model of several stacks of beads with common parameters and parameters of each bead, for `fisher_scoring`.

    `names` are the common parameters (terms of the wavefront and constants with a prior), and `bead_parameters` the
    parameters of each bead.
    """

    images: BeadImages
    stacks: tuple[Stack, ...]
    priors: dict[str, Prior]
    depths: tuple[Prior, ...]
    drifts: bool  # estimate lateral drift
    gradients: bool = False  # estimate the gradient of each background
    bead_parameters: tuple[str, ...] = field(init=False)
    names: tuple[object, ...] = field(init=False)
    size: int = field(init=False)  # number of parameters
    degrees_of_freedom: int = field(init=False)
    alternatives, rms = False, None  # see `scoring.Problem`: a single set of parameters; steps are not lengthened

    def __post_init__(self) -> None:
        depth = ("depth",) if self.depths[0].error > 0.0 else ()
        gradient = GRADIENT if self.gradients else ()
        self.bead_parameters = (*POSITION, *depth, *(DRIFT if self.drifts else ()), *gradient)
        self.names = (*self.images.estimated_terms, *self.priors)
        self.size = len(self.names) + len(self.bead_parameters) * len(self.stacks)
        # Flux and background of each plane are two more parameters, which `size` does not include.
        self.degrees_of_freedom = (
            sum(int(stack.pixel_data[3].sum()) - 2 * len(stack.z) for stack in self.stacks) - self.size
        )

    def single_bead(self, k: int) -> BeadModel:
        """Return the model of a single bead, with constants and depth fixed."""
        return replace(self, stacks=self.stacks[k : k + 1], priors={}, depths=(Prior(self.depths[k].value, 0.0),))

    def with_beads(self, beads: Sequence[int]) -> BeadModel:
        """Return the model of the beads with these indices."""
        return replace(self, stacks=tuple(self.stacks[k] for k in beads), depths=tuple(self.depths[k] for k in beads))

    def level_stacks(self, state: State) -> list[Stack]:
        """Return the stacks without the gradients of their backgrounds."""
        return [stack.without_gradient(place)[0] for stack, place in zip(self.stacks, state.places, strict=True)]

    def brightest_first(self) -> list[int]:
        """Return the indices of the beads in the order of decreasing light."""
        planes = [stack.planes[0] for stack in self.stacks]
        light = [float((images - np.median(images, axis=(1, 2), keepdims=True)).sum()) for images in planes]
        return sorted(range(len(light)), key=lambda k: -light[k])

    def columns(self, bead: int, common_count: int) -> range:
        """Return the columns of the parameters of a bead, which follow the common parameters."""
        count = len(self.bead_parameters)
        return range(common_count + bead * count, common_count + (bead + 1) * count)

    def _prior_terms(self, state: State, names: Sequence[object]) -> Iterator[tuple[int, Prior, float]]:
        """Yield column, prior and value of each parameter with a prior; `names` are the common parameters."""
        for name, prior in self.priors.items():
            yield names.index(name), prior, state.setup.value(name)
        if "depth" in self.bead_parameters:
            index = self.bead_parameters.index("depth")
            for j, (prior, place) in enumerate(zip(self.depths, state.places, strict=True)):
                yield self.columns(j, len(names))[index], prior, place.depth

    def evaluate(self, state: State, limit: float = math.inf, kept: list[Derivatives] | None = None) -> Evaluation:
        """Return a state with its images and scores, and with maximum-likelihood flux and background.

        Raise Declined or ValueError if the deviance is not below `limit`, if the aberrations are too strong, or if
        the constants are impossible. Derivatives take far longer than images: they are computed only if the deviance
        is below `limit`. An empty list `kept` is filled with them; otherwise it has those of a state nearby.
        """
        light, values = [], []
        total = sum(prior.score(value)[0] for _, prior, value in self._prior_terms(state, self.names))
        for k, (stack, place) in enumerate(zip(self.level_stacks(state), state.places, strict=True)):
            psf = self.images.values(state.setup, state.waves, place, stack)
            values.append(psf)
            light.append(bead_images.flux_background(psf, stack.pixel_data, state.light[k] if state.light else None))
            total += float(star_likelihood([psf], light[-1][None], stack.pixel_data, self.images.threads)[0][0].sum())
        if not -math.inf < total < limit:
            raise Declined("the likelihood is not finite, or not higher than before")
        state = replace(state, light=tuple(light))
        parts, information, gradient = self.normal_equations(state, values, kept=kept)
        chi2, deviation = (np.array([value]) for value in self.chi2_of(parts))
        scores = Scores(np.array([total]), gradient[None], information[None], chi2, deviation)
        return Evaluation(state, values, parts, scores, derivatives=kept)

    def normal_equations(
        self,
        state: State,
        values: list[Array],
        added: Sequence[str] = (),
        *,
        whole: bool = True,
        kept: list[Derivatives] | None = None,
    ) -> tuple[list[Part], Array, Array]:
        """Return the contributions of all stacks, and information and gradient of all parameters, priors included.

        Order of the parameters: common parameters `names`, the constants `added`, parameters of each bead. Unless
        `whole`, the information of single planes is that with the focus, (planes, 1, parameters), which is smaller.
        For `kept` see :meth:`evaluate`.
        """
        is_known = bool(kept)
        names, parts = (*self.names, *added), list[Part]()
        k, size = len(names), self.size + len(added)
        information, gradient = np.zeros((size, size)), np.zeros(size)
        for j, (psf, stack) in enumerate(zip(values, self.level_stacks(state), strict=True)):
            derivatives, chain = kept[j] if kept and is_known else self._derivatives(state, j, names, psf)
            if kept is not None and not is_known:
                kept.append((derivatives, chain))
            parts.append(bead_images.part_of(psf, derivatives, chain, stack, state.light[j], self.images.threads))
            del derivatives  # before those of the next bead
            columns = [*range(k), *self.columns(j, k)]
            information[np.ix_(columns, columns)] += parts[-1].total
            gradient[columns] += parts[-1].gradient.sum(axis=0)
            if not whole:
                focus = k + self.bead_parameters.index("focus")
                parts[-1] = parts[-1]._replace(information=parts[-1].information[:, focus : focus + 1].copy())
        for column, prior, value in self._prior_terms(state, names):
            _, prior_gradient, prior_information = prior.score(value)
            gradient[column] += prior_gradient
            information[column, column] += prior_information
        return parts, information, gradient

    def _derivatives(self, state: State, bead: int, names: Sequence[object], psf: Array) -> tuple[list[Array], Array]:
        """Return k derivatives of the images of a bead, and the chain rule, shape (planes, parameters, k).

        For each plane, the derivatives by the parameters are linear combinations of the k derivatives.
        """
        images, setup, waves = self.images, state.setup, state.waves
        stack, place, light = self.stacks[bead], state.places[bead], state.light[bead]
        amplitudes, k = [str(name) for name in names if name in AMPLITUDES], len(images.estimated_terms)
        derivatives, ones = [*images.derivatives(setup, waves, place, stack, amplitudes)], np.ones(len(stack.z))
        order = (*images.estimated_terms, "focus", "row", "column", *amplitudes)
        # Index of the derivative for each parameter, and its factor in each plane.
        chain_rule: dict[object, tuple[int, Array]] = {name: (j, ones) for j, name in enumerate(order)}
        # Drift shifts rows and columns in proportion to time; the step shifts the focus in proportion to z.
        chain_rule |= {DRIFT[0]: (k + 1, stack.times), DRIFT[1]: (k + 2, stack.times), "step": (k, stack.z)}
        chain_rule["jump"] = k, ones * stack.displaced
        for name in (*GRADIENT, bead_images.NONLINEAR):
            if name in (*names, *self.bead_parameters):
                # This derivative is in electrons: it is divided by the flux, because `part_of` multiplies by it.
                chain_rule[name] = len(derivatives), 1.0 / light[0]
                derivative = _camera_derivative(name, bead_images.expected(light, psf))
                derivatives.append(derivative.astype(derivatives[0].dtype))
        for name in map(str, (*names, *self.bead_parameters)):
            if name in {**CONSTANTS, **DYE} and name not in chain_rule:
                chain_rule[name] = len(derivatives), ones
                derivatives.append(images.differences(setup, waves, place, stack, name).astype(derivatives[0].dtype))
        chain = np.zeros((len(stack.z), len(names) + len(self.bead_parameters), len(derivatives)))
        for row, parameter in enumerate((*names, *self.bead_parameters)):
            column, factor = chain_rule[parameter]
            chain[:, row, column] = factor
        return derivatives, chain

    def step(self, x: Evaluation, scores: Scores, rows: Rows, damping: Array) -> tuple[Array, Array]:
        """Return a damped step (1, parameters), and the predicted decrease of the deviance."""
        state = x.state
        step = damped_steps(scores, damping)
        if "depth" in self.bead_parameters:
            depth_index = self.bead_parameters.index("depth")
            for j, place in enumerate(state.places):
                column = self.columns(j, len(self.names))[depth_index]
                # A bead that would sink into the glass is set to the depth 0; the steps of all other parameters are
                # computed again for this depth.
                if place.depth + step[0][0, column] < 0.0:
                    scores = _with_fixed_step(scores, column, -place.depth)
            step = damped_steps(scores, damping)
        return step

    def attempt(
        self, x: Evaluation, scores: Scores, rows: Rows, step: Array, factor: Array
    ) -> tuple[Evaluation, Scores | None]:
        """Return the state after a step and its scores; the old state and None if the deviance does not decrease."""
        # Derivatives take most of the time; a small step hardly changes them.
        is_small = 0.5 * float(scores.slope[0] @ step[0]) < _SMALL_GAIN
        if (kept := x.derivatives) and not is_small:
            kept.clear()
        with suppress(Declined, ValueError):  # the step is too long: aberrations too strong, or constants impossible
            evaluation = self.evaluate(self.after_step(x.state, step[0]), float(scores.deviance[0]), kept)
            return evaluation, evaluation.scores
        return x, None

    def after_step(self, state: State, step: Array) -> State:
        """Return the parameters after a step, which is shortened such that no change exceeds its limit."""
        k, common_count, setup = len(self.images.estimated_terms), len(self.names), state.setup
        bead_steps = step[common_count:].reshape(-1, len(self.bead_parameters))
        constants = [CONSTANTS[name] for name in self.priors]
        constant_values = np.array([setup.value(name) for name in self.priors])
        limits = [
            constant.max_step * (value if constant.relative else 1.0)
            for constant, value in zip(constants, constant_values, strict=True)
        ]
        # Changes divided by their largest allowed values.
        ratios = [math.sqrt(float(step[:k] @ step[:k])) / _MAX_WAVE_STEP, *(np.abs(step[k:common_count]) / limits)]
        ratios += [*(np.abs(bead_steps) / [_MAX_STEPS[name] for name in self.bead_parameters]).ravel()]
        # A common factor for all parameters keeps the direction of the step.
        factor = 1.0 / max(1.0, *ratios)
        for name, value in zip(self.priors, (constant_values + factor * step[k:common_count]).tolist(), strict=True):
            setup = setup.with_constant(name, value)
        # Because of noise, the estimated variance of the blur may be slightly negative.
        if setup.blur < -0.2 or setup.diameter < 0.0:
            raise Declined("the variance of the blur, or the diameter of the bead, is negative")
        if _MAX_NA * min(setup.objective.immersion, setup.objective.design.immersion) < setup.objective.NA:
            raise Declined("NA is so near the index of the immersion that no image of a proven error is possible")
        places = []
        for stack, place, bead_step in zip(self.stacks, state.places, factor * bead_steps, strict=True):
            changes = zip(self.bead_parameters, bead_step.tolist(), strict=True)
            new_place = place._replace(**{name: getattr(place, name) + change for name, change in changes})
            half_sides = 0.5 * np.array(stack.shape)
            row, column = np.clip([new_place.row, new_place.column], -half_sides, half_sides).tolist()
            places.append(new_place._replace(row=row, column=column, depth=max(new_place.depth, 0.0)))
        return replace(state, setup=setup, waves=state.waves + factor * step[:k], places=tuple(places))

    def chi2_of(self, parts: Sequence[Part]) -> tuple[float, float]:
        """Return Pearson's chi2 per degree of freedom from the parts of all stacks, and its standard deviation."""
        sums = [(part.chi2, part.chi2_expectation, part.chi2_variance) for part in parts]
        total, expectation, variance = np.sum(sums, axis=0).tolist()
        pixels = self.degrees_of_freedom + self.size + 2 * sum(len(s.z) for s in self.stacks)
        chi2, deviation = reduced_chi2(total, expectation, variance, max(self.degrees_of_freedom, 1) / pixels)
        return float(chi2), float(deviation)


def _with_fixed_step(scores: Scores, index: int, step: float) -> Scores:
    """Return scores from which damped steps have a prescribed `step` of the parameter with index `index`."""
    information, gradient = scores.information.copy(), scores.slope - scores.information[:, index] * step
    information[:, index] = information[:, :, index] = 0.0
    information[:, index, index], gradient[:, index] = 1.0, step
    return scores._replace(slope=gradient, information=information)


def _camera_derivative(name: str, mean: Array) -> Array:
    """Return the derivative of electrons (planes, height, width) by the camera's nonlinearity or a gradient.

    `mean` are the expected electrons.
    """
    if name == bead_images.NONLINEAR:
        # With nonlinearity x, m electrons decrease by the fraction x m / 10^4.
        return -(mean**2) / 1e4
    axis = 1 + GRADIENT.index(name)
    coordinate = np.linspace(-0.5, 0.5, mean.shape[axis])
    return np.broadcast_to(np.expand_dims(coordinate, (0, 3 - axis)), mean.shape)


def climb(model: BeadModel, start: State, max_steps: int, report: Report = lambda *_: None) -> Evaluation:
    """Return the end of at most `max_steps` damped steps, from a start until convergence."""
    steps, stores = 0, list[list[Derivatives] | None]([[], None])
    for kept in stores:  # a search that derivatives of states nearby do not settle is continued without them
        evaluation = model.evaluate(start, kept=kept)
        # At the rate `stalled` a good fit would take 500 steps.
        ascent = fisher_scoring(
            model, evaluation, evaluation.scores, max_steps - steps, report, max_damping=1e7, stalled=1e-3
        )
        last_evaluation: Evaluation = ascent.x
        steps += ascent.steps
        # A misfit whose steps gain no more is at its maximum.
        is_stalled = steps < max_steps and not last_evaluation.fits(BY_CHANCE)
        is_settled = bool(ascent.settled[0]) or is_stalled
        if is_settled or steps >= max_steps:
            break
        start = last_evaluation.state
    return replace(last_evaluation, settled=is_settled, steps=steps, derivatives=None)


def place_bead(model: BeadModel, common: State) -> Evaluation:
    """Return the fit of the place of a single bead, with the wavefront and the constants of a state."""
    fixed = replace(model, images=model.images.without_terms(common.waves), priors={})
    best: Evaluation | None = None
    for origin in ORIGINS:
        place = start_of(model.stacks[0], common.setup, model.depths[0].value, origin)
        fit = climb(fixed, State(common.setup, np.zeros(0), (place,)), _PLACE_STEPS)
        best = fit if best is None or fit.log_posterior > best.log_posterior else best
        if best.settled and best.fits(SURE):
            break
    assert best is not None
    return best


@dataclass(eq=False)
class Search:
    """Search for the maximum likelihood: first for single beads from several starts, then for all beads jointly."""

    model: BeadModel
    setup: Setup
    waves: Array  # initial coefficients of the wavefront
    starts: int  # largest number of starts
    max_steps: int  # largest number of steps of a search
    report: Report
    steps: int = 0  # number of steps of all completed searches
    few: Sequence[int] = ()  # beads of the fit, if it has not all of them

    def is_dark(self) -> bool:
        """Return whether noise and sloping backgrounds explain all stacks, and no start has significant light."""
        for k, stack in enumerate(self.model.stacks):
            chi2, deviation, gradient = stack.background_fit()
            if chi2 >= largest_plausible_chi2(deviation, BY_CHANCE):
                return False
            model = self.model.single_bead(k)
            for origin in ORIGINS:
                place = start_of(stack, self.setup, model.depths[0].value, origin)._replace(**gradient)
                part = model.evaluate(State(self.setup, self.waves, (place,))).parts[0]
                if part.flux_sigmas >= _DARK_SIGMAS:
                    return False
        return True

    def fit_all(self) -> tuple[Evaluation, list[bool]]:
        """Fit all beads jointly, except beads with a bad individual fit; return the fit, and whether each is used.

        If no bead fits with the constants as stated, the fit is that of some of the beads, `few`.
        """
        model, count = self.model, len(self.model.stacks)
        brightest_first = model.brightest_first()
        fits: dict[int, Evaluation] = {}
        # The brightest objects may be clumps: probes are of all brightnesses, the brightest first.
        probes = [brightest_first[round(k)] for k in np.linspace(0.0, count - 1.0, min(count, _PROBES)).tolist()]
        for k in [*probes, *(k for k in brightest_first if k not in probes)]:
            fits[k] = self.fit_one(model.single_bead(k), [*fits.values()])
            if len(fits) == _PROBES < count and not any(fit.fits(SURE) for fit in fits.values()):
                # Constants are wrong: with more beads, the search for them would only take longer.
                self.few = sorted(probes)
                fits = {index: fits[k] for index, k in enumerate(self.few)}
                model, count = model.with_beads(self.few), _PROBES
                brightest_first = model.brightest_first()
                break
        single_fits = [fits[k] for k in range(count)]
        median = float(np.median([fit.quality[0] for fit in single_fits]))
        chi2_limits = [float(largest_plausible_chi2(fit.quality[1])) for fit in single_fits]
        limits = [max(MAX_CHI2_RATIO * median, limit) for limit in chi2_limits]
        is_used = [fit.quality[0] < limit for fit, limit in zip(single_fits, limits, strict=True)]
        used_indices = [k for k in range(count) if is_used[k]]
        if count == 1 and not model.priors and "depth" not in model.bead_parameters:
            return single_fits[0], is_used
        # The median is robust against a bead that ended in another local maximum.
        waves = np.median([single_fits[k].state.waves for k in used_indices], axis=0)
        start = State(self.setup, waves, tuple(single_fits[k].state.places[0] for k in used_indices))
        joint_model, pilots = model.with_beads(used_indices), [k for k in brightest_first if is_used[k]][:_PILOTS]
        if len(used_indices) == len(pilots) or all(single_fits[k].fits(SURE) for k in pilots):
            if min(single_fits[k].quality[0] for k in used_indices) < GROSS_CHI2:
                return self.climb(joint_model, start), is_used
            return replace(self.climb(joint_model, start, _MISFIT_STEPS), settled=True), is_used
        # If constants are wrong, the search takes many steps: it begins with few beads, for which a step is faster.
        places = tuple(single_fits[k].state.places[0] for k in pilots)
        pilot_fit = self.climb(model.with_beads(pilots), replace(start, places=places))
        if self.few and not pilot_fit.fits(BY_CHANCE):
            self.few = [self.few[k] for k in pilots]
            return pilot_fit, [True] * len(pilots)
        pilot = pilot_fit.state
        single_starts = [State(pilot.setup, pilot.waves, single_fits[k].state.places) for k in used_indices]
        placed_fits = [
            self.climb(model.single_bead(k), single_start)
            for k, single_start in zip(used_indices, single_starts, strict=True)
        ]
        start = State(pilot.setup, pilot.waves, tuple(fit.state.places[0] for fit in placed_fits))
        joint_fit = self.climb(joint_model, start, None if pilot_fit.fits(BY_CHANCE) else _MISFIT_STEPS)
        if not joint_fit.fits(BY_CHANCE):
            return replace(joint_fit, settled=True), is_used
        return joint_fit if joint_fit.settled else self.climb(joint_model, joint_fit.state), is_used

    def fit_one(self, model: BeadModel, earlier: Sequence[Evaluation]) -> Evaluation:
        """Return the best fit of a single stack from several starts.

        The first start has the wavefront of the best of the `earlier` fits of other beads, if there are any.
        """
        best_fit: Evaluation | None = None
        starts = [(self.waves, origin) for origin in ORIGINS[: self.starts]]
        if earlier:
            best_waves = min(earlier, key=lambda fit: fit.quality[0]).state.waves
            starts = [(best_waves, 0.0), *starts][: self.starts]
        # If several beads fit badly from several starts, the model is wrong, and more starts do not help.
        worst_chi2 = max((fit.quality[0] for fit in earlier), default=0.0)
        is_wrong = len(earlier) >= _PILOTS and not any(fit.fits(SURE) for fit in earlier)
        for waves, origin in starts:
            place = start_of(model.stacks[0], self.setup, model.depths[0].value, origin)
            fit = self.climb(model, State(self.setup, waves, (place,)))
            same_maximum = best_fit is not None and _same_maximum(fit, best_fit)
            if best_fit is None or fit.log_posterior > best_fit.log_posterior:
                best_fit = fit
            if same_maximum or (best_fit.settled and best_fit.fits(SURE)):
                break
            if is_wrong and best_fit.quality[0] <= worst_chi2:
                break
        assert best_fit is not None
        return best_fit

    def climb(self, model: BeadModel, start: State, max_steps: int | None = None) -> Evaluation:
        """Return the end of one search."""
        fit = climb(model, start, min(self.max_steps, max_steps or self.max_steps), self.report)
        self.steps += fit.steps
        return fit


def _same_maximum(fit: Evaluation, other: Evaluation) -> bool:
    """Return whether two starts are assumed to have ended at the same maximum."""
    chi2, other_chi2 = fit.quality[0], other.quality[0]
    difference = abs(fit.log_posterior - other.log_posterior)
    is_misfit = not fit.fits(BY_CHANCE) and abs(chi2 - other_chi2) < _SAME_MISFIT * (chi2 - 1.0)
    return difference < _SAME_MAXIMUM or (fit.settled and other.settled and is_misfit)


def start_of(stack: Stack, setup: Setup, depth: float, origin: float) -> Place:
    """Return the initial place of a bead: the centroid in the sharpest planes, and the sharpest focus plus `origin`.

    The sharpest focus is the mean of z, weighted by sharpness; `origin` is in metres.
    """
    counted, _, valid = stack.planes
    images = np.where(valid, counted, np.nan)
    excess = np.nan_to_num(images - np.nanmedian(images, axis=(1, 2), keepdims=True))
    # Squares are multiplied by the sign of the light: the mean contribution of noise is 0.
    sharpness = (excess * np.abs(excess)).sum(axis=(1, 2))
    sharpness = np.clip(sharpness - np.median(sharpness), 0.0, None)
    total = float(sharpness.sum())
    focus = float(sharpness @ stack.z) / total if total > 0.0 else float(stack.z.mean())
    sharpest = excess[np.argsort(-sharpness)[:5]].mean(axis=0)
    # Noise in dark pixels would shift the centroid to the middle of the window.
    sharpest = np.where(sharpest > 0.2 * sharpest.max(), sharpest, 0.0)
    row, column = (
        float((sharpest.sum(axis=1 - axis) * (np.arange(side) - side // 2)).sum() / max(sharpest.sum(), 1e-300))
        for axis, side in enumerate(stack.shape)
    )
    return Place(row, column, brightest(setup, depth) - setup.step * focus + origin, depth)


def brightest(setup: Setup, depth: float) -> float:
    """Return the stage position (m), without aberrations, at which an emitter at a depth (m) is brightest."""
    return float(setup.pupil(None, depth).focus)
