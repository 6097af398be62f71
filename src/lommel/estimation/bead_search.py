"""The search for stacks of beads: Fisher scoring with places eliminated bead by bead, starts, beads left out."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Declined
from lommel.estimation.bead_images import (
    AMPLITUDES,
    CONSTANTS,
    GRADIENT,
    NONLINEAR,
    BeadImages,
    Part,
    Place,
    Setup,
    Stack,
    light_of,
    likelihood,
    part_of,
)
from lommel.fit import goodness_of_fit
from lommel.fit.goodness_of_fit import SURE
from lommel.fit.scoring import Policy, Report, Rows, fisher_scoring

OWN = ("row", "column", "focus")
DRIFT = ("drift_row", "drift_column")
_FAR = 1.0  # radians rms: no step changes the wavefront by more
_ALIKE = 1.0  # of minus the log-likelihood: starts that end so near have found one minimum
_LEFT = 1.5  # times the median chi2, from which a bead is left out
ORIGINS = (0.0, -0.35e-6, 0.35e-6, -0.7e-6, 0.7e-6)  # metres of the stage, where restarts begin
_REACH = {"focus": 0.3e-6, "row": 1.0, "column": 1.0, "drift_row": 1.0, "drift_column": 1.0, "depth": 0.3e-6}


def lowest(setup: Setup) -> float:
    """Return the least depth of a bead: it lies on the glass, within what its size and the glass are known."""
    return 0.25 * setup.diameter


class Prior(NamedTuple):
    """What is known of a constant before: its value and standard deviation, inf for nothing."""

    value: float
    deviation: float

    def pull(self, at: float) -> tuple[float, float, float]:
        """Return the deviance, the slope towards the value, and the information."""
        square = 1.0 / self.deviation**2
        away = self.value - at
        return 0.5 * away * away * square, away * square, square


@dataclass(frozen=True, eq=False)
class State:
    """A set of parameters: waves (radians rms), constants in a setup, a place and light of each bead."""

    setup: Setup
    waves: Array
    places: tuple[Place, ...]
    light: tuple[Array, ...] = ()


class Normal(NamedTuple):
    """What all stacks and priors say about shared parameters, then about those of each bead."""

    shared: Array  # (k, k)
    slope: Array  # (k,)
    across: tuple[Array, ...]  # (k, q) each
    own: tuple[Array, ...]  # (q, q) each
    own_slope: tuple[Array, ...]  # (q,) each
    parts: tuple[Part, ...]

    def reduced(self, damping: float = 0.0) -> tuple[Array, Array]:
        """Return information and slope of the shared parameters, places being eliminated."""
        square, slope = _damped(self.shared, damping), self.slope.copy()
        for cross, own, by in zip(self.across, self.own, self.own_slope, strict=True):
            carried = _solved(_damped(own, damping), np.column_stack([cross.T, by]))
            square = square - cross @ carried[:, :-1]
            slope -= cross @ carried[:, -1]
        return square, slope

    def step(self, damping: float) -> tuple[Array, list[Array], float]:
        """Return a damped step, of what is shared and of each bead, and twice the gain that it promises."""
        shared = _solved(*self.reduced(damping))
        promised, each = float(shared @ self.slope), []
        for cross, own, by in zip(self.across, self.own, self.own_slope, strict=True):
            each.append(_solved(_damped(own, damping), by - cross.T @ shared))
            promised += float(each[-1] @ by)
        return shared, each, promised

    def holding(self, bead: int, at: int, step: float) -> Normal:
        """Return the same with a step of a parameter of a bead given."""
        across, own, slopes = ([part.copy() for part in each] for each in (self.across, self.own, self.own_slope))
        slope = self.slope - across[bead][:, at] * step
        slopes[bead] -= own[bead][:, at] * step
        across[bead][:, at] = 0.0
        own[bead][at] = own[bead][:, at] = 0.0
        own[bead][at, at], slopes[bead][at] = 1.0, step
        return self._replace(slope=slope, across=tuple(across), own=tuple(own), own_slope=tuple(slopes))


def _damped(square: Array, damping: float) -> Array:
    return np.asarray(square + np.diag(damping * np.diag(square)))


def _solved(square: Array, by: Array) -> Array:
    """Return the solution of scaled equations; unknowns that nothing depends on stay."""
    diagonal = np.diag(square)
    scale = np.where(diagonal > 0.0, np.sqrt(np.maximum(diagonal, 1e-300)), 1.0)
    alike = square / np.outer(scale, scale) + 1e-11 * np.eye(len(scale))
    right = by / (scale if by.ndim == 1 else scale[:, None])
    return np.asarray(np.linalg.solve(alike, right) / (scale if by.ndim == 1 else scale[:, None]))


class BeadModel:
    """Several stacks of beads as functions of shared and own parameters."""

    def __init__(
        self,
        images: BeadImages,
        stacks: Sequence[Stack],
        priors: dict[str, Prior],
        depths: Sequence[Prior],
        *,
        drift: bool,
    ) -> None:
        self.images, self.stacks, self.priors, self.depths = images, tuple(stacks), priors, tuple(depths)
        self.own = (*OWN, *(("depth",) if depths and depths[0].deviation > 0.0 else ()), *(DRIFT if drift else ()))
        self.names: tuple[object, ...] = (*images.solved, *priors)
        self.size = len(self.names) + len(self.own) * len(self.stacks)
        self.tested = sum(stack.tested for stack in stacks) - self.size - 2 * sum(len(s.z) for s in stacks)

    @property
    def drifts(self) -> bool:
        """Whether beads move from plane to plane."""
        return DRIFT[0] in self.own

    def alone(self, k: int) -> BeadModel:
        """Return the model of one bead, with the constants of the microscope and its depth fixed."""
        depth = Prior(self.depths[k].value, 0.0)
        return BeadModel(self.images, [self.stacks[k]], {}, [depth], drift=self.drifts)

    def having(self, kept: Sequence[int]) -> BeadModel:
        """Return the model of some of the beads."""
        stacks, depths = [self.stacks[k] for k in kept], [self.depths[k] for k in kept]
        return BeadModel(self.images, stacks, self.priors, depths, drift=self.drifts)

    def prior_deviance(self, state: State) -> float:
        """Return what priors add to the deviance."""
        total = sum(prior.pull(state.setup.value(name))[0] for name, prior in self.priors.items())
        if "depth" in self.own:
            total += sum(p.pull(at.depth)[0] for p, at in zip(self.depths, state.places, strict=True))
        return total

    def lit(self, state: State) -> tuple[State, list[Array], float]:
        """Return a state with the light of maximum likelihood, the images, and its deviance with priors.

        Declined or ValueError where the aberrations are too strong or there is no such microscope.
        """
        light, values, total = [], [], self.prior_deviance(state)
        for k, (stack, place) in enumerate(zip(self.stacks, state.places, strict=True)):
            psf = self.images.values(state.setup, state.waves, place, stack)
            values.append(psf)
            light.append(light_of(psf, stack.star, state.light[k] if state.light else None))
            total += likelihood(psf, stack, light[-1], self.images.threads)[0]
        if not math.isfinite(total):
            raise Declined("the likelihood is not finite")
        return replace(state, light=tuple(light)), values, total

    def normal(self, state: State, values: Sequence[Array], more: Sequence[str] = ()) -> Normal:
        """Return slope and information; those by constants `more`, of all beads alike, follow what is shared."""
        k, names = len(self.names) + len(more), (*self.names, *more)
        shared, slope = np.zeros((k, k)), np.zeros(k)
        across, own, own_slope, parts = [], [], [], []
        for stack, place, psf, light in zip(self.stacks, state.places, values, state.light, strict=True):
            mean = light[0][:, None, None] * psf + light[1][:, None, None]
            slopes, chain = self._slopes(state, place, stack, names, mean, light)
            part = part_of(psf, slopes, chain, stack, light, self.images.threads)
            parts.append(part)
            shared += part.information[:k, :k]
            slope += part.slope[:k]
            across.append(part.information[:k, k:])
            own.append(part.information[k:, k:].copy())
            own_slope.append(part.slope[k:].copy())
        for name, prior in self.priors.items():
            at = names.index(name)
            _, pull, square = prior.pull(state.setup.value(name))
            slope[at] += pull
            shared[at, at] += square
        if "depth" in self.own:
            at = self.own.index("depth")
            for j, (prior, place) in enumerate(zip(self.depths, state.places, strict=True)):
                _, pull, square = prior.pull(place.depth)
                own_slope[j][at] += pull
                own[j][at, at] += square
        return Normal(shared, slope, tuple(across), tuple(own), tuple(own_slope), tuple(parts))

    def _slopes(
        self, state: State, place: Place, stack: Stack, names: Sequence[object], mean: Array, light: Array
    ) -> tuple[Array, Array]:
        """Return derivatives of images, and of images by parameters by these in each plane."""
        images, setup, waves = self.images, state.setup, state.waves
        amplitudes, k = [str(name) for name in names if name in AMPLITUDES], len(images.solved)
        plain = images.slopes(setup, waves, place, stack, amplitudes)
        found = [plain]
        at: dict[object, tuple[int, Array]] = {}
        ones, count = np.ones(len(stack.z)), len(plain)
        for j, term in enumerate(images.solved):
            at[term] = j, ones
        for j, name in enumerate(OWN):
            at[name] = k + (1, 2, 0)[j], ones
        for j, name in enumerate(DRIFT):
            at[name] = k + 1 + j, stack.times
        at["step"] = k, stack.z
        for j, amplitude in enumerate(amplitudes):
            at[amplitude] = k + 3 + j, ones
        wanted = (*(name for name in names if name in CONSTANTS), *(("depth",) if "depth" in self.own else ()))
        for name in (*GRADIENT, NONLINEAR):
            if name in names:
                at[name] = count, 1.0 / light[0]  # they are no part of the light, which slopes are multiplied by
                found.append(_of_camera(name, plain[0].shape, mean)[None].astype(plain.dtype))
                count += 1
        for name in dict.fromkeys(map(str, wanted)):
            if name in at:
                continue
            found.append(images.differences(setup, waves, place, stack, name)[None].astype(plain.dtype))
            at[name] = count, ones
            count += 1
        chain = np.zeros((len(stack.z), len(names) + len(self.own), count))
        for row, name in enumerate((*names, *self.own)):
            column, factor = at[name]
            chain[:, row, column] = factor
        return np.concatenate(found), chain

    def step(self, state: State, normal: Normal, damping: float) -> tuple[Array, list[Array], float]:
        """Return a damped step, of what is shared and of each bead, and twice the gain that it promises."""
        found = normal.step(damping)
        if "depth" in self.own:
            at, least = self.own.index("depth"), lowest(state.setup)
            for j, place in enumerate(state.places):
                if place.depth + found[1][j][at] < least:
                    normal = normal.holding(j, at, least - place.depth)
            found = normal.step(damping)
        return found

    def moved(self, state: State, shared: Array, each: Sequence[Array]) -> State:
        """Return the parameters after a step, cut to what it may change at most."""
        k = len(self.images.solved)
        longest = [math.sqrt(float(shared[:k] @ shared[:k])) / _FAR]
        for own in each:
            longest += [abs(own[j]) / _REACH[name] for j, name in enumerate(self.own)]
        setup = state.setup
        for name, step in zip(self.priors, shared[k:], strict=True):
            given = CONSTANTS[name]
            longest.append(abs(float(step)) / (given.reach * (setup.value(name) if given.relative else 1.0)))
        cut = 1.0 / max(1.0, *longest)
        for name, step in zip(self.priors, shared[k:], strict=True):
            setup = setup.having(name, setup.value(name) + cut * float(step))
        if setup.blur < -0.2 or setup.diameter < 0.0:
            raise Declined("no such blur or bead")
        places = []
        for stack, place, own in zip(self.stacks, state.places, each, strict=True):
            by = {name: cut * float(own[j]) for j, name in enumerate(self.own)}
            height, width = (0.5 * side for side in stack.shape)
            places.append(
                Place(
                    float(np.clip(place.row + by["row"], -height, height)),
                    float(np.clip(place.column + by["column"], -width, width)),
                    place.focus + by["focus"],
                    max(place.depth + by.get("depth", 0.0), lowest(setup)),
                    (place.drift[0] + by.get("drift_row", 0.0), place.drift[1] + by.get("drift_column", 0.0)),
                )
            )
        return replace(state, setup=setup, waves=state.waves + cut * shared[:k], places=tuple(places))

    def chi2(self, state: State, values: Sequence[Array]) -> tuple[float, float]:
        """Return Pearson's chi2 per degree of freedom, and its standard deviation."""
        each = [
            likelihood(psf, stack, light, self.images.threads)[1:]
            for psf, stack, light in zip(values, self.stacks, state.light, strict=True)
        ]
        total, expected, spread = np.sum(each, axis=0)
        return self._over(float(total), float(expected), float(spread))

    def chi2_of(self, parts: Sequence[Part]) -> tuple[float, float]:
        """Return the same from what stacks say."""
        return self._over(sum(p.chi2 for p in parts), sum(p.expected for p in parts), sum(p.spread for p in parts))

    def _over(self, total: float, expected: float, spread: float) -> tuple[float, float]:
        pixels = self.tested + self.size + 2 * sum(len(s.z) for s in self.stacks)
        share = max(self.tested, 1) / pixels
        most = max(expected * share, 1.0)
        return total / most, math.sqrt(spread * share) / most


@dataclass(frozen=True, eq=False)
class Evaluated:
    """A state with its images, its deviance with priors, slopes and information: as arrays of one."""

    state: State
    values: list[Array]
    normal: Normal
    deviance: Array
    chi2: Array
    spread: Array

    @staticmethod
    def of(model: BeadModel, state: State, values: list[Array], deviance: float) -> Evaluated:
        """Return what a state with its light is worth."""
        normal = model.normal(state, values)
        chi2, spread = model.chi2_of(normal.parts)
        return Evaluated(state, values, normal, np.array([deviance]), np.array([chi2]), np.array([spread]))


BeadStep: TypeAlias = tuple[Array, list[Array]]
"""A step of what is shared, and of each bead."""


class _BeadProblem:
    """The search for the state of a model, as :func:`lommel.fit.scoring.fisher_scoring` asks."""

    def __init__(self, model: BeadModel) -> None:
        self.model, self.tested = model, model.tested

    def step(self, x: State, now: Evaluated, at: Rows, damping: Array) -> tuple[BeadStep, Array]:
        shared, each, promised = self.model.step(now.state, now.normal, float(damping[0]))
        return (shared, each), np.array([promised])

    def of(self, step: BeadStep, moving: NDArray[np.bool_]) -> BeadStep:
        return step

    def rms(self, step: BeadStep) -> Array:
        return np.array([math.sqrt(float(step[0] @ step[0]))])

    def attempt(
        self, x: State, now: Evaluated, at: Rows, step: BeadStep, factor: Array
    ) -> tuple[State, Evaluated | None]:
        with suppress(Declined, ValueError):  # a step too long: aberrations too strong, or no such microscope
            tried, values, deviance = self.model.lit(self.model.moved(now.state, *step))
            if deviance < now.deviance[0]:  # slopes take far longer than images
                return tried, Evaluated.of(self.model, tried, values, deviance)
        return x, None

    def merged(
        self, x: State, now: Evaluated, tried: State, new: Evaluated, at: Rows, better: NDArray[np.bool_]
    ) -> tuple[State, Evaluated]:
        return tried, new

    def enough(self, done: NDArray[np.bool_], now: Evaluated, at: Rows) -> bool:
        return bool(done.all())


_POLICY = Policy(most=1e7, stretch=False, patience=None, interruptible=True)


def _of_camera(name: str, shape: tuple[int, ...], mean: Array) -> Array:
    """Return the derivative of electrons (planes, height, width) by what is of the camera or the background."""
    if name == NONLINEAR:
        return -(mean**2) / 1e4
    axis = 1 + GRADIENT.index(name)
    along = np.linspace(-0.5, 0.5, shape[axis])
    return np.broadcast_to(np.expand_dims(along, (0, 3 - axis)), shape)


class Climbed(NamedTuple):
    """The end of a search."""

    state: State
    values: list[Array]
    deviance: float
    normal: Normal
    settled: bool
    steps: int
    interrupted: bool


def climb(model: BeadModel, start: State, most: int, report: Report) -> Climbed:
    """Take damped steps from a start until they settle; an interrupt ends the search with the best so far."""
    now = Evaluated.of(model, *model.lit(start))
    end = fisher_scoring(_BeadProblem(model), now.state, now, most, report, _POLICY)
    best = end.now
    deviance, settled = float(best.deviance[0]), bool(end.settled[0])
    return Climbed(best.state, best.values, deviance, best.normal, settled, end.steps, end.interrupted)


class Search:
    """Searches for the answer of a model, from several starts, of single beads first."""

    def __init__(
        self,
        model: BeadModel,
        setup: Setup,
        waves: Array,
        starts: int,
        most: int,
        progress: Callable[[float, float], object] | None,
    ) -> None:
        self.model, self.setup, self.waves, self.starts, self.most = model, setup, waves, starts, most
        self.steps, self._done, self._progress, self.interrupted = 0, 0.0, progress, False

    def all(self) -> tuple[Climbed, list[bool]]:
        """Return the best fit of all beads, and which are part of it."""
        model, count = self.model, len(self.model.stacks)
        singles = [self.one(model.alone(k), 0.6 / count) for k in range(count)]
        scores = np.array([model.alone(k).chi2_of(one.normal.parts) for k, one in enumerate(singles)])
        middle = float(np.median(scores[:, 0]))
        used = [bool(chi2 < _LEFT * middle or chi2 < goodness_of_fit.most(spread)) for chi2, spread in scores]
        kept = [k for k in range(count) if used[k]]
        joint = model.having(kept)
        if count == 1 and not model.priors and "depth" not in model.own:
            return singles[0], used
        waves = np.median([singles[k].state.waves for k in kept], axis=0)
        start = State(self.setup, waves, tuple(singles[k].state.places[0] for k in kept))
        return self.climb(joint, start, 0.4), used

    def one(self, model: BeadModel, share: float) -> Climbed:
        """Return the best fit of one stack."""
        best: Climbed | None = None
        for origin in ORIGINS[: self.starts]:
            place = start_of(model.stacks[0], self.setup, model.depths[0].value, origin)
            found = self.climb(model, State(self.setup, self.waves, (place,)), share)
            alike = best is not None and abs(found.deviance - best.deviance) < _ALIKE
            if best is None or found.deviance < best.deviance:
                best = found
            chi2, spread = model.chi2_of(best.normal.parts)
            if self.interrupted or (best.settled and (alike or chi2 < goodness_of_fit.most(spread, SURE))):
                break
            share = 0.0
        assert best is not None
        return best

    def climb(self, model: BeadModel, start: State, share: float) -> Climbed:
        """Return the end of one search; `share` of the progress."""
        before = self._done

        def report(step: int, chi2: float) -> None:
            if self._progress is not None:
                self._progress(min(before + share * (1.0 - 0.8**step), 1.0), chi2)

        found = climb(model, start, self.most, report)
        self.steps += found.steps
        self._done, self.interrupted = before + share, found.interrupted
        return found


def start_of(stack: Stack, setup: Setup, depth: float, origin: float) -> Place:
    """Return where to begin: centroid of the sharpest planes, and the focus where squares are centred."""
    counted, _, _, valid = stack.star
    images = np.where(valid > 0.0, counted, np.nan).reshape(len(stack.z), *stack.shape)
    light = np.nan_to_num(images - np.nanmedian(images, axis=(1, 2), keepdims=True))
    sharp = (light * np.abs(light)).sum(axis=(1, 2))
    sharp = np.clip(sharp - np.median(sharp), 0.0, None)
    total = float(sharp.sum())
    middle = float(sharp @ stack.z) / total if total > 0.0 else float(stack.z.mean())
    best = light[np.argsort(-sharp)[:5]].mean(axis=0)
    best = np.where(best > 0.2 * best.max(), best, 0.0)
    row, column = (
        float((best.sum(axis=1 - axis) * (np.arange(side) - side // 2)).sum() / max(best.sum(), 1e-300))
        for axis, side in enumerate(stack.shape)
    )
    return Place(row, column, brightest(setup, depth) - setup.step * middle + origin, depth)


def brightest(setup: Setup, depth: float) -> float:
    """Return the position of the stage at which an emitter at a depth is brightest, without aberrations."""
    made = setup.objective.pupil(depth=depth, wavelength=setup.wavelength, emitter=setup.emitter)
    return float(made.focus)
