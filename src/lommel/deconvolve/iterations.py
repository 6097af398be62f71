"""Steps of a deconvolution of Poisson counts: Richardson and Lucy's, and those with a penalty on total variation."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.base.threads import side_by_side
from lommel.deconvolve.algorithms import (
    MISFIT,
    NOISE,
    STEPS,
    RichardsonLucy,
    StoppingRule,
    Tell,
    TotalVariation,
    search,
    silent,
)
from lommel.deconvolve.linear import Made, PlaneOperator, Take
from lommel.deconvolve.poisson_counts import PhotographCounts, PoissonCounts, at_least

_EVERY = 2  # stride along each axis of the voxels that determine the extrapolation
_MOST_AHEAD = 4.0  # largest factor by which a step is extrapolated
_DIM = 0.01  # of the mean light: start of a specimen whose flat part is left to the background


class Background(NamedTuple):
    """Light besides that of the specimen: a known level, or None to estimate it at `points` by `points` places."""

    level: float | None
    points: int = 1


_NONE = Background(0.0)


class Move(NamedTuple):
    """Extrapolation of a step, levels of the background, and the weight of the total variation."""

    pace: float
    background: Array
    strength: float = 0.0


class State(NamedTuple):
    """Light of a specimen, and of each plane beyond its margin; None where an iteration begins flat."""

    light: Values | None = None
    outside: Values | None = None

    def less(self, level: float) -> State:
        """Return the state with `level` less light everywhere."""
        light, outside = (None if each is None else each - np.float32(level) for each in self)
        return State(light, outside)


class Iteration:
    """Richardson-Lucy steps with memory for twice the specimen and once the recording.

    An unknown `background` (light of each voxel besides that of the specimen) is estimated along. A flat specimen
    and a background have the same image; as steps multiply, flat light goes to what starts bright. So the specimen
    starts with next to nothing.

    With the `course` of another part of the same stack as many steps are taken, with the same extrapolations and,
    if it has one level, the same background.
    """

    def __init__(
        self,
        blur: PlaneOperator,
        counted: PoissonCounts,
        course: Sequence[Move] | None = None,
        *,
        background: Background = _NONE,
    ) -> None:
        self._blur, self._counted = blur, counted
        self._given = None if course is None else list(course)
        least = _DIM * counted.level
        level, self._estimated = background.level, background.level is None
        start = np.maximum(counted.start - level, least) if level is not None else np.asarray(least)
        self._like = self._given is not None and background.points == 1
        if level is None:
            # A flat recording needs no specimen: the background takes all of it.
            counted.background = 0.0
            # Otherwise it starts from the darkest parts, which hold little else.
            dark = counted.level if counted.flat() <= 1.0 + counted.slack else counted.darkest()
            level = max(min(dark, counted.level - least), counted.smallest)
        self._background = np.full((background.points, background.points), level)
        if self._given and self._like:
            self._background = self._given[0].background
        self._background_before = self._levels = self._background
        counted.set_background(self._levels)
        self._light = np.full(blur.whole, start, dtype=counted.dtype)
        self._before: Values | None = None
        self._misfit = np.empty(blur.shape, dtype=counted.dtype)
        blur.weigh(counted.most_weight)
        # Light of the specimen beyond its margin, if the blur has any.
        self._outside = None if blur.outside is None else np.full(blur.whole[0], start, dtype=counted.dtype)
        self._outside_before = self._outside
        self._pace = 0.0
        self._strength = 0.0
        self.strength: float | None = None  # estimated weight of the total variation
        self._earlier = np.zeros([-(-side // _EVERY) for side in blur.whole], dtype=counted.dtype)
        self.course: list[Move] = []
        self._of_specimen: list[float] = []
        self.discrepancies = np.full(len(counted.known), np.inf)
        self.enough: Callable[[int, float], bool] | None = None  # further criterion to stop: step and discrepancy

    @property
    def state(self) -> State:
        """Copy of the extrapolated light, from which another iteration may start."""
        ahead = self._light if self._before is None else self._before
        return State(ahead.copy(), None if self._blur.outside is None else self._blur.outside.copy())

    def start_from(self, state: State) -> None:
        """Start from the light of another iteration, if there is any."""
        if state.light is not None:
            self._light = at_least(state.light, self._counted.smallest)
        if state.outside is not None:
            self._outside = self._outside_before = np.maximum(state.outside, self._counted.smallest)

    def solve(self, method: RichardsonLucy | TotalVariation, tell: Tell) -> tuple[int, str, Array]:
        """Iterate until a stopping rule applies; return the number of steps, the reason and the discrepancies."""
        assert isinstance(method, RichardsonLucy)
        if self._given is not None:
            method = replace(method, steps=max(len(self._given), 1), target=0.0)
        rule = StoppingRule(method, self._counted.slack, tell)
        last = np.inf
        while True:
            found = self._look(rule.pace)
            stopped = rule.judge(found)
            # A background explains a nearly empty stack before its specimen is there: that must fit, too.
            if self._estimated and stopped in (None, NOISE) and rule.steps < method.steps:
                stopped = NOISE if self._explained(found, method.target) else None
            if stopped is None and self.enough is not None and self.enough(rule.steps, found):
                stopped = NOISE
            if stopped or (self._given is not None and rule.steps == len(self._given) - 1):
                return rule.steps, stopped or STEPS, self.discrepancies
            size = float(np.vdot(self._earlier, self._earlier))
            overlap = self._step()
            if method.accelerate and rule.steps > 0:
                rule.extrapolate_by(size, overlap)
                if found > last:  # extrapolated too far: continue with a plain step
                    rule.pace = 0.0
            last = found

    def _look(self, pace: float) -> float:
        """Extrapolate the last step, and return the discrepancy of the result."""
        move = Move(pace, self._levels, self._strength)
        if self._given:
            move = self._given[min(len(self.course), len(self._given) - 1)]
        self._pace, self._strength = move.pace, move.strength
        self._extrapolate(move.background)
        self.discrepancies = self._counted.discrepancies(self._blur, self.guess, self._misfit)
        self.course.append(move._replace(background=self._levels))
        self._of_specimen.append(self._counted.of_specimen[0])
        return self._counted.mean(self.discrepancies)

    def _explained(self, discrepancy: float, target: float) -> bool:
        """Return whether all agrees with its noise, and the light of the specimen does or hardly changes any more."""
        # A stack that is mostly background may agree with its noise long before its specimen does.
        most = max(target, 1.0 + self._counted.slack) if target >= 1.0 else target
        found, slack = self._of_specimen, self._counted.of_specimen[1]
        if target == 0.0 or discrepancy > most:
            return False
        # Compared with half as many steps: a slow improvement is not mistaken for none.
        return found[-1] <= target or found[(len(found) - 1) // 2] - found[-1] < slack

    def guess(self, plane: int, rows: slice, columns: slice) -> Values:
        """Return the extrapolated light."""
        ahead = self._light if self._before is None else self._before
        return ahead[plane, rows, columns]

    def _extrapolate(self, levels: Array) -> None:
        """Replace the light of the previous step by the extrapolation to the next."""
        pace, least = self._pace, self._counted.smallest
        if self._outside is not None and self._outside_before is not None:
            self._blur.outside = np.maximum(_ahead(self._outside, self._outside_before, pace), least)
        if self._estimated:
            ahead = np.maximum(_ahead(self._background, self._background_before, pace), least)
            self._levels = levels if self._like else ahead
            self._counted.set_background(self._levels)
        if self._before is None:
            return
        for light, before in zip(self._light, self._before, strict=True):
            if pace == 0.0:
                before[...] = light
                continue
            at_least(_ahead(light, before, pace, out=before), least)

    def _step(self) -> float:
        """Take a step, update the sampled change, and return the product of this change and the one before."""
        following = np.empty_like(self._light) if self._before is None else self._before
        least = self._counted.smallest

        def stepped(plane: int, rows: slice, columns: slice, back: Values) -> float:
            guess = self.guess(plane, rows, columns)
            # Light that no voxel of the recording sees stays as it is: per_seen is 0 there.
            found = np.multiply(back, self._blur.per_seen(plane, rows, columns), out=back)
            found += 1.0
            found *= guess
            at_least(found, least)
            overlap = self._moved(plane, rows, columns, found, guess)
            following[plane, rows, columns] = found
            return overlap

        overlap = sum(self._returned(stepped))
        self._before, self._light = self._light, following
        return overlap

    def _returned(self, take: Take[Made]) -> list[Made]:
        """Pass the correction of the light to `take`, and update background and outside light."""
        misfit, least = self._misfit, self._counted.smallest
        if self._estimated:
            means = self._counted.means(misfit, len(self._levels))
            self._background_before = self._background
            self._background = np.maximum(self._levels * (1.0 + means), least)
        made = self._blur.adjoint(lambda plane, *part: misfit[(plane, *part)], take)
        if self._outside is not None:
            guess = self._blur.outside
            found = guess * np.maximum(1.0 + self._blur.outside_back * self._blur.per_outside, 0.0)
            self._outside_before, self._outside = self._outside, np.maximum(found, least)
        return made

    def _moved(self, plane: int, rows: slice, columns: slice, found: Values, guess: Values) -> float:
        """Replace the sampled change of a part by the new one, and return their product."""
        if plane % _EVERY:
            return 0.0
        first = -rows.start % _EVERY, -columns.start % _EVERY
        here = np.s_[first[0] :: _EVERY, first[1] :: _EVERY]
        moved = found[here] - guess[here]
        at = (rows.start + first[0]) // _EVERY, (columns.start + first[1]) // _EVERY
        kept = self._earlier[plane // _EVERY, at[0] :, at[1] :][: moved.shape[0], : moved.shape[1]]
        overlap = float(np.vdot(moved, kept))
        kept[...] = moved
        return overlap

    def inside(self, planes: int, pixels: int) -> Values:
        """Return the light without margins; ends the iteration."""
        self._misfit = np.empty((0, 0, 0), self._counted.dtype)
        self._blur.release()
        rows, columns = (slice(pixels, side - pixels) for side in self._blur.whole[1:])
        out = np.empty(self._blur.shape, self._counted.dtype)
        for plane, values in enumerate(out):
            values[...] = self.guess(planes + plane, rows, columns)
        return out


def _ahead(light: Values, before: Values, pace: float, out: Values | None = None) -> Values:
    """Return light extrapolated beyond that of the step before, by a ratio, so that it stays positive.

    The harmonic mean of the ratio and 1 stands for a power of the ratio, which would be slower.
    """
    made = np.multiply(before, pace, out=out)
    made += (1.0 - pace) * light
    made = np.divide(light, made, out=out)
    # A row of limits: NumPy compares two arrays much faster than an array and a number here (see `at_least`).
    made = np.minimum(made, np.full(np.shape(made)[-1:], _MOST_AHEAD, np.asarray(made).dtype), out=out)
    made *= light
    return made


_ROUND = 0.01  # of the mean light, over which the edge of the total variation is rounded
_STEPS_BETWEEN, _SETTLED = 20, 1e-3  # steps between tests for convergence, and the relative change that ends them


class VariationIteration(Iteration):
    r"""Steps to the minimum of ``sum w (m - y ln m) + strength * sum |grad x|``, for light x above 0.

    Each step minimizes a function of one voxel at a time that is nowhere below the objective and equal to it at the
    light of before, so that the objective never rises (De Pierro 1995, doi:10.1109/42.370409): that of the likelihood
    is that of Richardson and Lucy, ``s x - e ln x``, and ``|g| <= (|g|^2 / |g'| + |g'|) / 2`` of the gradients, with
    squares ``(x - x')^2`` of which each voxel gets its half. With P and Q the sums over neighbours of weights, and of
    weights times the light of both, the root of ``2 P x^2 + (s - Q) x = e`` is in closed form. Steps are extrapolated
    as those of Richardson and Lucy, and one that raised the objective is followed by a plain one.

    Memory: one specimen more than the iteration of Richardson and Lucy. Differences along z are per pixel too:
    `aspect` is pixel over step. Without it planes are channels, whose gradient is one vector: they share their edges.
    """

    def __init__(
        self,
        blur: PlaneOperator,
        counted: PoissonCounts,
        course: Sequence[Move] | None = None,
        *,
        background: Background,
        aspect: float | None = None,
        threads: int = 0,
    ) -> None:
        super().__init__(blur, counted, course, background=background)
        self._aspect = None if aspect is None else np.float32(aspect)
        self._threads = threads
        self._spare: Values | None = None
        self._likelihood = 0.0
        self._round = counted.dtype.type(max(_ROUND * counted.level, counted.smallest))
        self.objectives: list[float] = []
        self.strength = self._given[-1].strength if self._given else 0.0
        self._begun = time.perf_counter()

    def solve(self, method: RichardsonLucy | TotalVariation, tell: Tell) -> tuple[int, str, Array]:
        """Iterate with the strength that was asked for, or to the one that the noise asks for."""
        assert isinstance(method, TotalVariation)
        counted = self._counted
        most = 1.0 + counted.slack
        electrons = counted.white * counted.level
        first = 0.15 / math.sqrt(max(electrons, 1e-6))
        is_flat = len(self._given) == 1 if self._given else method.strength is None and counted.flat() <= most
        if is_flat:
            self._look(0.0)
            self.strength = None
            return 0, NOISE, self.discrepancies
        self.start_from(State(counted.estimate))
        if self._given:
            self._settle(0.0, len(self._given), tell, last=True)
            return len(self.course) - 1, STEPS, self.discrepancies

        def found_at(strength: float) -> float:
            return self._settle(strength, method.steps, tell, last=method.strength is not None)

        if method.strength is not None:
            found, self.strength = found_at(method.strength), method.strength
        else:
            found, self.strength = search(found_at, first, method.target, first * counted.weakest)
        stopped = NOISE if found <= most else STEPS
        if method.strength is None and found > most and self.strength <= 1.001 * first * counted.weakest:
            stopped = MISFIT
        return len(self.course) - 1, stopped, self.discrepancies

    def _settle(self, strength: float, most: int, tell: Tell, *, last: bool) -> float:
        """Iterate with one strength until it changes little, and return the discrepancy."""
        self._strength, pace = strength, 0.0
        self.objectives, found = [], math.inf
        while True:
            if self.course:
                if self._given:
                    self._strength = self._given[len(self.course)].strength
                size = float(np.vdot(self._earlier, self._earlier))
                overlap = self._step()
                here = len(self.objectives)
                pace = min(max(overlap / size, 0.0), 0.999) if size > 0.0 and here > 1 else 0.0
                if here > 1 and self.objectives[-1] > self.objectives[-2]:
                    pace = 0.0
                if self._given is None and here > _STEPS_BETWEEN and (self._counted.settles or not last):
                    fall = self.objectives[-1 - _STEPS_BETWEEN] - self.objectives[-1]
                    most = here if fall < _SETTLED * self._likelihood else most
            found = self._look(pace)
            each = (time.perf_counter() - self._begun) / len(self.course)
            done = len(self.objectives)
            tell(len(self.course) - 1, found, each * (max(most - done, 0) + (0 if last else 2 * _STEPS_BETWEEN)))
            if done >= most or (self._given and len(self.course) >= len(self._given)):
                return found

    def _look(self, pace: float) -> float:
        found = super()._look(pace)
        # Half of the deviance, in units of light.
        sums = self.discrepancies * np.maximum(self._counted.known, 1) / (2.0 * self._counted.white)
        self._likelihood = float(sums.sum()) * self._counted.expected
        return found

    def _step(self) -> float:
        """Take a step, and keep the objective that it started from."""
        guess = self._light if self._before is None else self._before
        following = np.empty_like(guess) if self._spare is None else self._spare
        least = self._counted.smallest

        def stepped(plane: int, rows: slice, columns: slice, back: Values) -> None:
            found = np.multiply(back, self._blur.per_seen(plane, rows, columns), out=back)
            found += 1.0
            found *= guess[plane, rows, columns]
            following[plane, rows, columns] = at_least(found, least)

        self._returned(stepped)
        whole = slice(0, guess.shape[1]), slice(0, guess.shape[2])
        strength = self._counted.dtype.type(self._strength)

        def smoothed(plane: int) -> tuple[float, float]:
            weights, both, total = self._neighbours(guess, plane)
            per = strength * self._blur.per_seen(plane, *whole)
            following[plane] = at_least(_root(following[plane], per * weights, per * both), least)
            return total, self._moved(plane, *whole, following[plane], guess[plane])

        made = side_by_side(smoothed, range(len(guess)), self._threads)
        self.objectives.append(self._likelihood + self._strength * sum(total for total, _ in made))
        self._spare, self._before, self._light = self._before, self._light, following
        return sum(overlap for _, overlap in made)

    def _slopes(self, light: Values, plane: int) -> Values:
        """Return the magnitude of the gradient at each voxel of a plane, rounded; channels have it in common."""
        squares = np.full(light.shape[1:], self._round * self._round, light.dtype)
        for here in light if self._aspect is None else light[plane : plane + 1]:
            squares[:-1] += np.square(here[1:] - here[:-1])
            squares[:, :-1] += np.square(here[:, 1:] - here[:, :-1])
        if self._aspect is not None and plane + 1 < len(light):
            squares += np.square(self._aspect * (light[plane + 1] - light[plane]))
        return np.sqrt(squares, out=squares)

    def _neighbours(self, light: Values, plane: int) -> tuple[Values, Values, float]:
        """Return sums over the neighbours of each voxel, of weights and of these times both, and the variation."""
        here, slopes = light[plane], self._slopes(light, plane)
        total = float(slopes.sum(dtype=np.float64))
        one = light.dtype.type(1.0) / slopes
        weights, both = np.zeros_like(here), np.zeros_like(here)
        for low, high in ((np.s_[:-1], np.s_[1:]), (np.s_[:, :-1], np.s_[:, 1:])):
            shared = one[low] * (here[low] + here[high])
            for side in (low, high):
                weights[side] += one[low]
                both[side] += shared
        if self._aspect is None:
            return weights, both, total / len(light)
        square = self._aspect * self._aspect
        if plane + 1 < len(light):
            one *= square
            weights += one
            both += one * (here + light[plane + 1])
        if plane > 0:
            one = square / self._slopes(light, plane - 1)
            weights += one
            both += one * (here + light[plane - 1])
        return weights, both, total


def _root(found: Values, weights: Values, both: Values) -> Values:
    """Return the positive root of ``2 P x^2 + (1 - Q) x = e``, without cancellation."""
    over = both - 1.0
    root = np.sqrt(over * over + 8.0 * weights * found)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(over > 0.0, (over + root) / (4.0 * weights), 2.0 * found / (root - over))


def iteration_of(
    method: RichardsonLucy | TotalVariation,
    blur: PlaneOperator,
    counted: PoissonCounts,
    course: Sequence[Move] | None = None,
    *,
    background: Background,
    aspect: float | None = None,
    threads: int = 0,
) -> Iteration:
    """Return the steps of a method."""
    if isinstance(method, RichardsonLucy):
        return Iteration(blur, counted, course, background=background)
    return VariationIteration(blur, counted, course, background=background, aspect=aspect, threads=threads)


class Solution(NamedTuple):
    """The result of a method for a photograph: light, number of steps, why it stopped, weight of the total variation.

    `alike` does the same to other counts, as of other parts of the photograph, and returns their light.
    """

    light: Values
    steps: int
    stopped: str
    alike: Callable[[PhotographCounts], Values]
    strength: float | None = None


def iterated(
    method: RichardsonLucy | TotalVariation,
    counts: PhotographCounts,
    tell: Tell,
    course: Sequence[Move] | None = None,
) -> Solution:
    """Return the sharp light behind the counts of a photograph, by the `course` of another part if it is given."""
    iteration = iteration_of(method, counts.operator, counts, course, background=_NONE)
    steps, stopped, _ = iteration.solve(method, tell)
    light = counts.operator.image(iteration.inside(0, 0))

    def alike(other: PhotographCounts) -> Values:
        return iterated(method, other, silent, iteration.course).light

    return Solution(light, steps, stopped, alike, iteration.strength)
