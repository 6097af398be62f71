"""The search for stacks of beads: Fisher scoring with the light of each plane eliminated, starts, beads left out."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Declined
from lommel.core.engine import star_likelihood
from lommel.estimation import bead_images
from lommel.estimation.bead_images import AMPLITUDES, CONSTANTS, GRADIENT, BeadImages, Part, Place, Setup, Stack
from lommel.fit import goodness_of_fit
from lommel.fit.scoring import Policy, Report, Rows, Scores, damped_steps, fisher_scoring, reduced_chi2

OWN = ("row", "column", "focus")
DRIFT = ("drift_row", "drift_column")
_FAR = 1.0  # radians rms: largest change of the wavefront in a step
_ALIKE = 1.0  # of log-likelihood: starts that end this close have found the same minimum
_LEFT = 1.5  # times the median chi2: beads above it are left out
ORIGINS = (0.0, -0.35e-6, 0.35e-6, -0.7e-6, 0.7e-6)  # metres of the stage: foci that starts are shifted by
_REACH = {"focus": 0.3e-6, "row": 1.0, "column": 1.0, "drift_row": 1.0, "drift_column": 1.0, "depth": 0.3e-6}


def lowest(setup: Setup) -> float:
    """Return the least depth of a bead on the glass, within the uncertainty of its size and of the glass."""
    return 0.25 * setup.diameter


class Prior(NamedTuple):
    """Prior knowledge of a constant: its value and standard error, inf if unknown."""

    value: float
    error: float

    def pull(self, at: float) -> tuple[float, float, float]:
        """Return the deviance, the slope towards the value, and the information, of a normal prior."""
        square = 1.0 / self.error**2
        away = self.value - at
        return 0.5 * away * away * square, away * square, square


@dataclass(frozen=True, eq=False)
class State:
    """A set of parameters: waves (radians rms), constants in a setup, place and light of each bead."""

    setup: Setup
    waves: Array
    places: tuple[Place, ...]
    light: tuple[Array, ...] = ()


@dataclass(frozen=True, eq=False)
class Evaluated:
    """A state with its images, what stacks and priors say there, and how a search came to it.

    `scores`, arrays of one, are of the shared parameters, then of those of each bead; the deviance is with priors.
    """

    state: State
    values: list[Array]
    parts: list[Part]
    scores: Scores
    settled: bool = False
    steps: int = 0

    @property
    def log_posterior(self) -> float:
        """Logarithm of the likelihood and of the priors."""
        return -float(self.scores.deviance[0])

    @property
    def quality(self) -> tuple[float, float]:
        """Chi2 and its standard deviation."""
        return float(self.scores.chi2[0]), float(self.scores.spread[0])


@dataclass(eq=False)
class BeadModel:
    """Several stacks of beads as functions of shared and own parameters, for `fisher_scoring`."""

    images: BeadImages
    stacks: tuple[Stack, ...]
    priors: dict[str, Prior]
    depths: tuple[Prior, ...]
    drifts: bool
    own: tuple[str, ...] = field(init=False)
    names: tuple[object, ...] = field(init=False)
    size: int = field(init=False)
    tested: int = field(init=False)
    alternatives, rms = False, None  # as of a `Problem`: one set of parameters, and steps that do not stretch

    def __post_init__(self) -> None:
        depth = ("depth",) if self.depths[0].error > 0.0 else ()
        self.own = (*OWN, *depth, *(DRIFT if self.drifts else ()))
        self.names = (*self.images.solved, *self.priors)
        self.size = len(self.names) + len(self.own) * len(self.stacks)
        # Degrees of freedom: two for the light of each plane.
        self.tested = sum(int(stack.star[3].sum()) - 2 * len(stack.z) for stack in self.stacks) - self.size

    def alone(self, k: int) -> BeadModel:
        """Return the model of one bead, with fixed constants and depth."""
        return replace(self, stacks=self.stacks[k : k + 1], priors={}, depths=(Prior(self.depths[k].value, 0.0),))

    def having(self, kept: Sequence[int]) -> BeadModel:
        """Return the model of some of the beads."""
        return replace(self, stacks=tuple(self.stacks[k] for k in kept), depths=tuple(self.depths[k] for k in kept))

    def columns(self, bead: int, shared: int) -> range:
        """Return the columns of the parameters of a bead, after the `shared` ones."""
        return range(shared + bead * len(self.own), shared + (bead + 1) * len(self.own))

    def _prior_terms(self, state: State, names: Sequence[object]) -> Iterator[tuple[int, Prior, float]]:
        """Yield the priors, each with its column and the present value of its constant."""
        for name, prior in self.priors.items():
            yield names.index(name), prior, state.setup.value(name)
        if "depth" in self.own:
            at = self.own.index("depth")
            for j, (prior, place) in enumerate(zip(self.depths, state.places, strict=True)):
                yield self.columns(j, len(names))[at], prior, place.depth

    def evaluated(self, state: State, most: float = math.inf) -> Evaluated:
        """Return a state evaluated: its deviance, priors included, with flux and background of maximum likelihood.

        Declined or ValueError where its deviance is not below `most`, before slopes, which take far longer than
        images; where the aberrations are too strong; or where there is no such microscope.
        """
        light, values = [], []
        total = sum(prior.pull(at)[0] for _, prior, at in self._prior_terms(state, self.names))
        for k, (stack, place) in enumerate(zip(self.stacks, state.places, strict=True)):
            psf = self.images.values(state.setup, state.waves, place, stack)
            values.append(psf)
            light.append(bead_images.flux_background(psf, stack.star, state.light[k] if state.light else None))
            total += float(star_likelihood([psf], light[-1][None], stack.star, self.images.threads)[0][0].sum())
        if not -math.inf < total < most:
            raise Declined("the likelihood is not finite, or no better")
        state = replace(state, light=tuple(light))
        parts, information, slope = self.normal(state, values)
        chi2, spread = (np.array([each]) for each in self.chi2_of(parts))
        scores = Scores(np.array([total]), slope[None], information[None], chi2, spread)
        return Evaluated(state, values, parts, scores)

    def normal(self, state: State, values: list[Array], more: Sequence[str] = ()) -> tuple[list[Part], Array, Array]:
        """Return the parts of all stacks, and information and slope of all parameters, priors included.

        Constants `more`, of all beads alike, follow what is shared.
        """
        names, parts = (*self.names, *more), list[Part]()
        k, size = len(names), self.size + len(more)
        information, slope = np.zeros((size, size)), np.zeros(size)
        for j, psf in enumerate(values):
            slopes, chain = self._slopes(state, j, names, psf)
            parts.append(bead_images.part_of(psf, slopes, chain, self.stacks[j], state.light[j], self.images.threads))
            at = [*range(k), *self.columns(j, k)]
            information[np.ix_(at, at)] += parts[-1].information.sum(axis=0)
            slope[at] += parts[-1].slope.sum(axis=0)
        for column, prior, value in self._prior_terms(state, names):
            _, pull, square = prior.pull(value)
            slope[column] += pull
            information[column, column] += square
        return parts, information, slope

    def _slopes(self, state: State, bead: int, names: Sequence[object], psf: Array) -> tuple[Array, Array]:
        """Return derivatives of images, and the matrix from these to parameters in each plane."""
        images, setup, waves = self.images, state.setup, state.waves
        stack, place, light = self.stacks[bead], state.places[bead], state.light[bead]
        amplitudes, k = [str(name) for name in names if name in AMPLITUDES], len(images.solved)
        found, ones = [*images.slopes(setup, waves, place, stack, amplitudes)], np.ones(len(stack.z))
        order = (*images.solved, "focus", "row", "column", *amplitudes)
        at: dict[object, tuple[int, Array]] = {name: (j, ones) for j, name in enumerate(order)}
        # Drift moves rows and columns in proportion to time, a longer step the focus in proportion to z.
        at |= {DRIFT[0]: (k + 1, stack.times), DRIFT[1]: (k + 2, stack.times), "step": (k, stack.z)}
        for name in (*GRADIENT, bead_images.NONLINEAR):
            if name in names:
                at[name] = len(found), 1.0 / light[0]  # no part of the light, which slopes are multiplied by
                found.append(_of_camera(name, bead_images.expected(light, psf)).astype(found[0].dtype))
        for name in map(str, (*names, *self.own)):
            if name in CONSTANTS and name not in at:
                at[name] = len(found), ones
                found.append(images.differences(setup, waves, place, stack, name).astype(found[0].dtype))
        chain = np.zeros((len(stack.z), len(names) + len(self.own), len(found)))
        for row, parameter in enumerate((*names, *self.own)):
            column, factor = at[parameter]
            chain[:, row, column] = factor
        return np.stack(found), chain

    def step(self, x: Evaluated, now: Scores, at: Rows, damping: Array) -> tuple[Array, Array]:
        """Return a damped step, (1, parameters), and its predicted gain."""
        scores, state = now, x.state
        found = damped_steps(scores, damping)
        if "depth" in self.own:
            depth, least = self.own.index("depth"), lowest(state.setup)
            for j, place in enumerate(state.places):
                column = self.columns(j, len(self.names))[depth]
                # The bead would sink into the glass: its depth goes to the least one, and the others follow it.
                if place.depth + found[0][0, column] < least:
                    scores = _holding(scores, column, least - place.depth)
            found = damped_steps(scores, damping)
        return found

    def attempt(
        self, x: Evaluated, now: Scores, at: Rows, step: Array, factor: Array
    ) -> tuple[Evaluated, Scores | None]:
        """Return the state after a step and its scores, if these are better than before."""
        with suppress(Declined, ValueError):  # a step too long: aberrations too strong, or no such microscope
            tried = self.evaluated(self.moved(x.state, step[0]), float(now.deviance[0]))
            return tried, tried.scores
        return x, None

    def moved(self, state: State, step: Array) -> State:
        """Return the parameters after a step, shortened to the largest allowed change."""
        k, shared, setup = len(self.images.solved), len(self.names), state.setup
        each = step[shared:].reshape(-1, len(self.own))
        given = [CONSTANTS[name] for name in self.priors]
        constants = np.array([setup.value(name) for name in self.priors])
        reach = [one.reach * (at if one.relative else 1.0) for one, at in zip(given, constants, strict=True)]
        longest = [math.sqrt(float(step[:k] @ step[:k])) / _FAR, *(np.abs(step[k:shared]) / reach)]
        longest += [*(np.abs(each) / [_REACH[name] for name in self.own]).ravel()]
        # One factor for all parameters keeps the direction of the step.
        cut = 1.0 / max(1.0, *longest)
        for name, value in zip(self.priors, (constants + cut * step[k:shared]).tolist(), strict=True):
            setup = setup.having(name, value)
        # Noise may make the estimated blur a little negative.
        if setup.blur < -0.2 or setup.diameter < 0.0:
            raise Declined("no such blur or bead")
        places = []
        for stack, place, own in zip(self.stacks, state.places, cut * each, strict=True):
            to = place._replace(**{n: getattr(place, n) + by for n, by in zip(self.own, own.tolist(), strict=True)})
            half = 0.5 * np.array(stack.shape)
            row, column = np.clip([to.row, to.column], -half, half).tolist()
            places.append(to._replace(row=row, column=column, depth=max(to.depth, lowest(setup))))
        return replace(state, setup=setup, waves=state.waves + cut * step[:k], places=tuple(places))

    def chi2_of(self, parts: Sequence[Part]) -> tuple[float, float]:
        """Return Pearson's chi2 per degree of freedom of what stacks say, and its standard deviation."""
        total, expected, spread = np.sum([(part.chi2, part.expected, part.spread) for part in parts], axis=0).tolist()
        pixels = self.tested + self.size + 2 * sum(len(s.z) for s in self.stacks)
        chi2, width = reduced_chi2(total, expected, spread, max(self.tested, 1) / pixels)
        return float(chi2), float(width)


def _holding(scores: Scores, at: int, step: float) -> Scores:
    """Return the scores with the step of one parameter fixed."""
    information, slope = scores.information.copy(), scores.slope - scores.information[:, at] * step
    information[:, at] = information[:, :, at] = 0.0
    information[:, at, at], slope[:, at] = 1.0, step
    return scores._replace(slope=slope, information=information)


_POLICY = Policy(max_damping=1e7, patience=math.inf)


def _of_camera(name: str, mean: Array) -> Array:
    """Return the derivative of electrons (planes, height, width) by a property of the camera or the background."""
    if name == bead_images.NONLINEAR:
        # Counts lack the share x m / 10^4 of m electrons.
        return -(mean**2) / 1e4
    axis = 1 + GRADIENT.index(name)
    along = np.linspace(-0.5, 0.5, mean.shape[axis])
    return np.broadcast_to(np.expand_dims(along, (0, 3 - axis)), mean.shape)


def climb(model: BeadModel, start: State, most: int, report: Report = lambda *_: None) -> Evaluated:
    """Return the end of damped steps from a start, when they settle."""
    begin = model.evaluated(start)
    end = fisher_scoring(model, begin, begin.scores, most, report, _POLICY)
    best: Evaluated = end.x
    return replace(best, settled=bool(end.settled[0]), steps=end.steps)


@dataclass(eq=False)
class Search:
    """Searches for the answer of a model from several starts, first for single beads."""

    model: BeadModel
    setup: Setup
    waves: Array
    starts: int
    most: int
    progress: Callable[[float, float], object] | None
    steps: int = 0
    _done: float = 0.0

    def all(self) -> tuple[Evaluated, list[bool]]:
        """Return the best fit of all beads, and which beads are part of it."""
        model, count = self.model, len(self.model.stacks)
        singles = [self.one(model.alone(k), 0.6 / count) for k in range(count)]
        middle = float(np.median([one.quality[0] for one in singles]))
        most = [max(_LEFT * middle, float(goodness_of_fit.most(one.quality[1]))) for one in singles]
        used = [one.quality[0] < limit for one, limit in zip(singles, most, strict=True)]
        kept = [k for k in range(count) if used[k]]
        if count == 1 and not model.priors and "depth" not in model.own:
            return singles[0], used
        # A median: a bead that found another minimum does not shift it.
        waves = np.median([singles[k].state.waves for k in kept], axis=0)
        start = State(self.setup, waves, tuple(singles[k].state.places[0] for k in kept))
        return self.climb(model.having(kept), start, 0.4), used

    def one(self, model: BeadModel, share: float) -> Evaluated:
        """Return the best fit of one stack."""
        best: Evaluated | None = None
        for origin in ORIGINS[: self.starts]:
            place = start_of(model.stacks[0], self.setup, model.depths[0].value, origin)
            found = self.climb(model, State(self.setup, self.waves, (place,)), share)
            alike = best is not None and abs(found.log_posterior - best.log_posterior) < _ALIKE
            if best is None or found.log_posterior > best.log_posterior:
                best = found
            fits = best.quality[0] < goodness_of_fit.most(best.quality[1], goodness_of_fit.SURE)
            if best.settled and (alike or fits):
                break
            # Only the first start counts for the progress.
            share = 0.0
        assert best is not None
        return best

    def climb(self, model: BeadModel, start: State, share: float) -> Evaluated:
        """Return the end of one search; it takes a `share` of the progress."""
        before = self._done

        def report(step: int, chi2: float) -> None:
            # The number of steps is not known before: each takes a fifth of what is left.
            if self.progress is not None:
                self.progress(min(before + share * (1.0 - 0.8**step), 1.0), chi2)

        found = climb(model, start, self.most, report)
        self.steps += found.steps
        self._done = before + share
        return found


def start_of(stack: Stack, setup: Setup, depth: float, origin: float) -> Place:
    """Return the start: the centroid of the sharpest planes, and the focus at the mean of squared light."""
    counted, _, valid = stack.planes
    images = np.where(valid, counted, np.nan)
    light = np.nan_to_num(images - np.nanmedian(images, axis=(1, 2), keepdims=True))
    # Squares with their sign: noise adds nothing on average.
    sharp = (light * np.abs(light)).sum(axis=(1, 2))
    sharp = np.clip(sharp - np.median(sharp), 0.0, None)
    total = float(sharp.sum())
    middle = float(sharp @ stack.z) / total if total > 0.0 else float(stack.z.mean())
    best = light[np.argsort(-sharp)[:5]].mean(axis=0)
    # Pixels of noise would pull the centroid to the middle of the window.
    best = np.where(best > 0.2 * best.max(), best, 0.0)
    row, column = (
        float((best.sum(axis=1 - axis) * (np.arange(side) - side // 2)).sum() / max(best.sum(), 1e-300))
        for axis, side in enumerate(stack.shape)
    )
    return Place(row, column, brightest(setup, depth) - setup.step * middle + origin, depth)


def brightest(setup: Setup, depth: float) -> float:
    """Return the position of the stage at which an emitter at a depth is brightest, without aberrations."""
    return float(setup.pupil(None, depth).focus)
