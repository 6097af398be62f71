"""Steps of a deconvolution of Poisson counts: Richardson-Lucy steps, and steps with a penalty on total variation."""

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
    ProgressCallback,
    RichardsonLucy,
    StoppingRule,
    TotalVariation,
    search,
    silent,
)
from lommel.deconvolve.likelihood import PhotographLikelihood, PoissonLikelihood, at_least
from lommel.deconvolve.linear import PartConsumer, PlaneOperator, Result

STRIDE = 2  # stride along each axis of the voxels from which the extrapolation factor is computed
MAX_GROWTH = 4.0  # largest factor by which extrapolation multiplies the light of a voxel
_DIM_START = 0.01  # smallest initial light of the specimen, relative to the mean light


class Background(NamedTuple):
    """Uniform or slowly varying light in addition to the light of the specimen.

    `level` is the known light of each voxel, or None to estimate the background at a grid of `points` by `points`
    points over the field, the same in all planes.
    """

    level: float | None
    points: int = 1


_NO_BACKGROUND = Background(0.0)


class StepSettings(NamedTuple):
    """Settings of a step that another part of the same recording can repeat.

    `extrapolation` is the factor of the extrapolation before the step (0: none), `background` the levels at the grid
    points, shape (points, points), and `strength` the weight of the total variation.
    """

    extrapolation: float
    background: Array
    strength: float = 0.0


class State(NamedTuple):
    """Light from which an iteration starts; None for uniform light.

    `light` has the shape of the specimen with its margin; `outside` is the light beyond it, one value for each plane.
    """

    light: Values | None = None
    outside: Values | None = None

    def subtract(self, level: float) -> State:
        """Return the state with `level` subtracted from the light everywhere."""
        light, outside = (None if values is None else values - np.float32(level) for values in self)
        return State(light, outside)


class _Estimate:
    """A quantity that steps change, and its extrapolation `guess`, from which the next step starts."""

    def __init__(self, start: Values) -> None:
        self._now = self._before = self.guess = start

    def extrapolate(self, factor: float, least: float) -> None:
        """Set `guess` from the last two steps."""
        self.guess = _extrapolate(self._now, self._before, factor, least)

    def step(self, ratio: Values, least: float) -> None:
        """Multiply `guess` by a ratio."""
        self._before, self._now = self._now, np.maximum(self.guess * ratio, least)


class Iteration:
    """Richardson-Lucy steps with memory for two specimens and one recording.

    An unknown `background` is estimated together with the specimen. A uniform background and a uniform specimen have
    the same image. Each step multiplies light by a factor, so that uniform light is assigned to whichever starts
    brighter: the specimen therefore starts at `_DIM_START` of the mean light.

    `course`, the settings of the steps of another part of the same stack, prescribes the number of steps, their
    extrapolation factors and, for a background of a single level, that level.
    """

    def __init__(
        self,
        blur: PlaneOperator,
        counted: PoissonLikelihood,
        course: Sequence[StepSettings] | None = None,
        *,
        background: Background = _NO_BACKGROUND,
    ) -> None:
        self._blur, self._counted = blur, counted
        self._prescribed = None if course is None else list(course)
        dim_level = _DIM_START * counted.level
        level, self._background_unknown = background.level, background.level is None
        start = np.maximum(counted.start - level, dim_level) if level is not None else np.asarray(dim_level)
        if level is None:
            # If a uniform scene agrees with the recording within the noise, all light is background.
            # Otherwise the background starts from the light of the darkest parts, which contain little specimen.
            counted.background = 0.0
            darkest = counted.level if counted.flat() <= 1.0 + counted.slack else counted.darkest()
            level = max(min(darkest, counted.level - dim_level), counted.smallest)
        levels = np.full((background.points, background.points), level)
        self._background_prescribed = bool(self._prescribed) and background.points == 1
        self._background = _Estimate(
            self._prescribed[0].background if self._prescribed and self._background_prescribed else levels
        )
        counted.set_background(self._background.guess)
        self._light = np.full(blur.whole, start, dtype=counted.dtype)  # result of the last step
        # Result of the step before the last; the extrapolated light then overwrites it.
        self._before: Values | None = None
        self._misfit = np.empty(blur.shape, dtype=counted.dtype)  # weighted ratio of counts to model, less 1
        blur.weigh(counted.most_weight)
        # Light of the specimen beyond its margin, one value for each plane, if the blur models it.
        self._outside = None if blur.outside is None else _Estimate(np.full(blur.whole[0], start, counted.dtype))
        self.strength: float | None = None  # estimated weight of the total variation
        # Last change of the light, sampled with stride STRIDE.
        self._last_change = np.zeros([-(-side // STRIDE) for side in blur.whole], dtype=counted.dtype)
        self.course: list[StepSettings] = []  # settings of all steps so far
        self._specimen_discrepancies: list[float] = []  # of the voxels lit by the specimen, after each step
        self.discrepancies = np.full(len(counted.known), np.inf)  # of each plane
        self.enough: Callable[[int, float], bool] | None = None  # additional stopping rule of step and discrepancy

    @property
    def state(self) -> State:
        """Copy of the extrapolated light, from which another iteration may start."""
        return State(self.guess.copy(), None if self._blur.outside is None else self._blur.outside.copy())

    @property
    def guess(self) -> Values:
        """Extrapolated light, from which the next step starts."""
        return self._light if self._before is None else self._before

    def start_from(self, state: State) -> None:
        """Start from the light of another iteration, if `state` contains light."""
        if state.light is not None:
            self._light = at_least(state.light, self._counted.smallest)
        if state.outside is not None:
            self._outside = _Estimate(np.maximum(state.outside, self._counted.smallest))

    def solve(self, method: RichardsonLucy | TotalVariation, report: ProgressCallback) -> tuple[int, str, Array]:
        """Iterate until a stopping rule applies; return the number of steps, the reason and the discrepancies."""
        assert isinstance(method, RichardsonLucy)
        if self._prescribed is not None:
            method = replace(method, steps=max(len(self._prescribed), 1), target=0.0)
        rule = StoppingRule(method, self._counted.slack, report)
        previous = np.inf
        while True:
            discrepancy = self._evaluate(rule.extrapolation)
            stopped = rule.judge(discrepancy)
            # In a nearly empty stack the background alone reaches the target: the specimen must agree as well.
            if self._background_unknown and stopped in (None, NOISE) and rule.steps < method.steps:
                stopped = NOISE if self._specimen_settled(discrepancy, method.target) else None
            if stopped is None and self.enough is not None and self.enough(rule.steps, discrepancy):
                stopped = NOISE
            if stopped or (self._prescribed is not None and rule.steps == len(self._prescribed) - 1):
                return rule.steps, stopped or STEPS, self.discrepancies
            square = self._product(self._last_change, self._last_change)
            overlap = self._step()
            if method.accelerate and rule.steps > 0:
                rule.update_extrapolation(square, overlap)
                if discrepancy > previous:  # extrapolated too far: continue without extrapolation
                    rule.extrapolation = 0.0
            previous = discrepancy

    def _evaluate(self, extrapolation: float, strength: float = 0.0) -> float:
        """Extrapolate the last step, compute its image and misfit, and return the discrepancy."""
        settings = StepSettings(extrapolation, self._background.guess, strength)
        if self._prescribed:
            settings = self._prescribed[min(len(self.course), len(self._prescribed) - 1)]
        self._extrapolate(settings)
        self.discrepancies = self._compare()
        self.course.append(settings._replace(background=self._background.guess))
        self._specimen_discrepancies.append(self._counted.of_specimen[0])
        return self._counted.mean(self.discrepancies)

    def _compare(self) -> Array:
        """Compute the misfit of the extrapolated light, and return its discrepancies."""
        return self._counted.discrepancies(self._blur, self.guess, self._misfit)

    def _specimen_settled(self, discrepancy: float, target: float) -> bool:
        """Check that the whole recording has reached the target, and the specimen has reached it or improves no more.

        A stack that is mostly background may reach the target long before the voxels lit by its specimen do.
        """
        limit = max(target, 1.0 + self._counted.slack) if target >= 1.0 else target
        history, slack = self._specimen_discrepancies, self._counted.of_specimen[1]
        if target == 0.0 or discrepancy > limit:
            return False
        # Compare with half as many steps, so that even a slow improvement is detected.
        return history[-1] <= target or history[(len(history) - 1) // 2] - history[-1] < slack

    def _extrapolate(self, settings: StepSettings) -> None:
        """Extrapolate light and background; the light overwrites the result of the step before the last."""
        factor, smallest = settings.extrapolation, self._counted.smallest
        if self._outside is not None:
            self._outside.extrapolate(factor, smallest)
            self._blur.outside = self._outside.guess
        if self._background_unknown:
            self._background.extrapolate(factor, smallest)
            if self._background_prescribed:
                self._background.guess = settings.background
            self._counted.set_background(self._background.guess)
        self._extrapolate_light(factor)

    def _extrapolate_light(self, factor: float) -> None:
        if self._before is None:
            return
        smallest = self._counted.smallest
        for light, before in zip(self._light, self._before, strict=True):
            if factor == 0.0:
                before[...] = light
                continue
            _extrapolate(light, before, factor, smallest, out=before)

    def _step(self) -> float:
        """Take a step, and return the scalar product of its sampled change and the change before."""
        next_light = np.empty_like(self._light) if self._before is None else self._before
        light, smallest = self.guess, np.full(self._light.shape[-1], self._counted.smallest, self._light.dtype)

        def step_part(plane: int, rows: slice, columns: slice, correction: Values) -> float:
            guess = light[plane, rows, columns]
            # x (1 + A^T[w (ratio - 1)] / A^T w). Light that is not recorded stays the same, because per_seen is 0.
            stepped = np.multiply(correction, self._blur.per_seen(plane, rows, columns), out=correction)
            stepped += 1.0
            stepped *= guess
            np.maximum(stepped, smallest[columns], out=stepped)  # a row of limits: see `at_least`
            overlap = self._update_change(plane, rows, columns, stepped, guess)
            next_light[plane, rows, columns] = stepped
            return overlap

        overlap = sum(self._back_projected(step_part))
        self._before, self._light = self._light, next_light
        return overlap

    def _back_projected(self, consume: PartConsumer[Result]) -> list[Result]:
        """Call `consume` with the parts of A^T of the misfit; update the background and the light beyond margins."""
        smallest = self._counted.smallest
        if self._background_unknown:
            self._background.step(1.0 + self._means(len(self._background.guess)), smallest)
        results = self._adjoint(consume)
        if self._outside is not None:
            ratio = np.maximum(1.0 + self._blur.outside_back * self._blur.per_outside, 0.0)
            self._outside.step(ratio, smallest)
        return results

    def _means(self, points: int) -> Array:
        return self._counted.means(self._misfit, points)

    def _adjoint(self, consume: PartConsumer[Result]) -> list[Result]:
        return self._blur.adjoint(self._misfit, consume)

    def _product(self, a: Values, b: Values) -> float:
        return float(np.vdot(a, b))

    def _update_change(self, plane: int, rows: slice, columns: slice, stepped: Values, guess: Values) -> float:
        """Replace the sampled change of a part by the change of this step, and return the scalar product of both."""
        if plane % STRIDE:
            return 0.0
        offset = -rows.start % STRIDE, -columns.start % STRIDE
        sampled = np.s_[offset[0] :: STRIDE, offset[1] :: STRIDE]
        change = stepped[sampled] - guess[sampled]
        start = (rows.start + offset[0]) // STRIDE, (columns.start + offset[1]) // STRIDE
        stored = self._last_change[plane // STRIDE, start[0] :, start[1] :][: change.shape[0], : change.shape[1]]
        overlap = self._product(change, stored)
        stored[...] = change
        return overlap

    def inside(self, planes: int, pixels: int) -> Values:
        """Return the light without its margin of `planes` and `pixels`; the iteration ends, as memory is freed."""
        self._misfit = np.empty((0, 0, 0), self._counted.dtype)
        self._blur.release()
        count, height, width = self._blur.whole
        return self.guess[planes : count - planes, pixels : height - pixels, pixels : width - pixels].copy()


def _extrapolate(light: Values, before: Values, factor: float, least: float, out: Values | None = None) -> Values:
    """Return ``light / (factor before / light + 1 - factor)``, extrapolated by a ratio to stay positive, or `least`.

    The ratio is a weighted harmonic mean of light / before and 1. It agrees with ``(light / before)^factor`` to first
    order, and is faster to compute.
    """
    result = np.multiply(before, factor, out=out)
    result += (1.0 - factor) * light
    result = np.divide(light, result, out=out)
    # A row of limits: NumPy compares two arrays much faster than an array and a number here (see `at_least`).
    result = np.minimum(result, np.full(np.shape(result)[-1:], MAX_GROWTH, np.asarray(result).dtype), out=out)
    result *= light
    return np.maximum(result, np.full(np.shape(result)[-1:], least, np.asarray(result).dtype), out=out)


_ROUNDING = 0.01  # gradient, relative to the mean light, below which the norm of the total variation is rounded
# An iteration has converged if the objective fell by less than _CONVERGED times the likelihood term in these steps.
_CONVERGENCE_STEPS, _CONVERGED = 20, 1e-3


class VariationIteration(Iteration):
    r"""Steps to the minimum of ``sum w (m - y ln m) + strength * sum abs(grad x)``, for light x above 0.

    Each step minimizes a separable surrogate: a sum of functions of one voxel each, nowhere below the objective and
    equal to it at the current light x', so that the objective never rises (De Pierro 1995, doi:10.1109/42.370409).

    - Likelihood: the surrogate of Richardson and Lucy, ``s x - e ln x`` with ``s = A^T w`` and
      ``e = x' A^T[w y / m]``.
    - Total variation: ``abs(g) <= (abs(g)^2 / abs(g') + abs(g')) / 2`` for the gradient g of x and g' of x'. Each
      squared difference of voxels i and j has a bound that is a function of x_i plus a function of x_j:
      ``(x_i - x_j)^2 <= ((2 x_i - c)^2 + (2 x_j - c)^2) / 2`` with ``c = x'_i + x'_j``.

    With ``P = strength * sum 1 / abs(g')`` and ``Q = strength * sum c / abs(g')`` over the differences of a voxel
    with its neighbours, the minimum is the positive root of ``2 P x^2 + (s - Q) x = e``. Steps are extrapolated as in
    :class:`Iteration`, except for the step after one that raised the objective.

    Memory: one specimen more than :class:`Iteration`. `aspect` is the pixel size divided by the step along z.
    Differences between planes are multiplied by it, so that all differences are per pixel. Without `aspect` planes
    are channels: the norm of the gradient is taken over all channels together, so that channels share edges.
    """

    def __init__(
        self,
        blur: PlaneOperator,
        counted: PoissonLikelihood,
        course: Sequence[StepSettings] | None = None,
        *,
        background: Background,
        aspect: float | None = None,
        threads: int = 0,
    ) -> None:
        super().__init__(blur, counted, course, background=background)
        self._aspect = None if aspect is None else np.float32(aspect)
        self._threads = threads
        self._spare: Values | None = None  # memory for the next step
        self._likelihood = self._strength = 0.0
        self._rounding = counted.dtype.type(max(_ROUNDING * counted.level, counted.smallest))
        self.objectives: list[float] = []  # at the start of each step with the current strength
        self.strength = self._prescribed[-1].strength if self._prescribed else 0.0
        self._start_time = time.perf_counter()

    def solve(self, method: RichardsonLucy | TotalVariation, report: ProgressCallback) -> tuple[int, str, Array]:
        """Iterate with the strength of the method, or search the strength whose result has its target discrepancy."""
        assert isinstance(method, TotalVariation)
        counted = self._counted
        largest_fitting = 1.0 + counted.slack
        electrons = counted.white * counted.level
        first_strength = 0.15 / math.sqrt(max(electrons, 1e-6))
        # If a uniform scene agrees with the recording within the noise, there is no detail to restore.
        if self._prescribed:
            is_flat = len(self._prescribed) == 1
        else:
            is_flat = method.strength is None and counted.flat() <= largest_fitting
        if is_flat:
            self._evaluate(0.0)
            self.strength = None
            return 0, NOISE, self.discrepancies
        self.start_from(State(counted.estimate))
        if self._prescribed:
            self._converge(0.0, len(self._prescribed), report, final=True)
            return len(self.course) - 1, STEPS, self.discrepancies

        def discrepancy_at(strength: float) -> float:
            return self._converge(strength, method.steps, report, final=method.strength is not None)

        if method.strength is not None:
            discrepancy, self.strength = discrepancy_at(method.strength), method.strength
        else:
            weakest = first_strength * counted.weakest
            discrepancy, self.strength = search(discrepancy_at, first_strength, method.target, weakest)
        stopped = NOISE if discrepancy <= largest_fitting else STEPS
        # A discrepancy that stays above 1 even at the weakest strength is not due to smoothing.
        at_weakest = method.strength is None and self.strength <= 1.001 * first_strength * counted.weakest
        if discrepancy > largest_fitting and at_weakest:
            stopped = MISFIT
        return len(self.course) - 1, stopped, self.discrepancies

    def _converge(self, strength: float, steps: int, report: ProgressCallback, *, final: bool) -> float:
        """Take at most `steps` steps with one strength, until they converge, and return the discrepancy.

        With `final`, no other strength follows. Convergence is then tested for stacks only (`settles`).
        """
        self._strength, extrapolation = strength, 0.0
        self.objectives = []
        while True:
            if self.course:
                if self._prescribed:
                    self._strength = self._prescribed[len(self.course)].strength
                square = self._product(self._last_change, self._last_change)
                overlap = self._step()
                count = len(self.objectives)
                extrapolation = min(max(overlap / square, 0.0), 0.999) if square > 0.0 and count > 1 else 0.0
                if count > 1 and self.objectives[-1] > self.objectives[-2]:
                    extrapolation = 0.0
                if self._prescribed is None and count > _CONVERGENCE_STEPS and (self._counted.settles or not final):
                    fall = self.objectives[-1 - _CONVERGENCE_STEPS] - self.objectives[-1]
                    steps = count if fall < _CONVERGED * self._likelihood else steps
            discrepancy = self._evaluate(extrapolation, self._strength)
            seconds_per_step = (time.perf_counter() - self._start_time) / len(self.course)
            count = len(self.objectives)
            # Another strength starts near its result, and takes about twice the steps of a test of convergence.
            steps_left = max(steps - count, 0) + (0 if final else 2 * _CONVERGENCE_STEPS)
            report(len(self.course) - 1, discrepancy, seconds_per_step * steps_left)
            if count >= steps or (self._prescribed and len(self.course) >= len(self._prescribed)):
                return discrepancy

    def _evaluate(self, extrapolation: float, strength: float = 0.0) -> float:
        discrepancy = super()._evaluate(extrapolation, strength)
        self._strength = self.course[-1].strength
        # Half of the deviance, in units of light: sum w (m - y ln m) up to a constant.
        sums = self.discrepancies * np.maximum(self._counted.known, 1) / (2.0 * self._counted.white)
        self._likelihood = float(sums.sum()) * self._counted.expected
        return discrepancy

    def _step(self) -> float:
        """Take a step, record the objective at its start, and return the scalar product of the last two changes."""
        guess = self.guess
        next_light = np.empty_like(guess) if self._spare is None else self._spare
        smallest = self._counted.smallest

        def step_part(plane: int, rows: slice, columns: slice, correction: Values) -> None:
            # e / s: the step of Richardson and Lucy.
            stepped = np.multiply(correction, self._blur.per_seen(plane, rows, columns), out=correction)
            stepped += 1.0
            stepped *= guess[plane, rows, columns]
            next_light[plane, rows, columns] = at_least(stepped, smallest)

        self._back_projected(step_part)
        plane_slices = slice(0, guess.shape[1]), slice(0, guess.shape[2])
        strength = self._counted.dtype.type(self._strength)

        def smooth(plane: int) -> tuple[float, float]:
            weights, weighted_sums, variation = self._neighbours(guess, plane)
            scale = strength * self._blur.per_seen(plane, *plane_slices)
            next_light[plane] = at_least(_root(next_light[plane], scale * weights, scale * weighted_sums), smallest)
            return variation, self._update_change(plane, *plane_slices, next_light[plane], guess[plane])

        pairs = side_by_side(smooth, range(len(guess)), self._threads)
        self.objectives.append(self._likelihood + self._strength * sum(variation for variation, _ in pairs))
        self._spare, self._before, self._light = self._before, self._light, next_light
        return sum(overlap for _, overlap in pairs)

    def _gradient_norms(self, light: Values, plane: int) -> Values:
        """Return the rounded norm of the gradient at each voxel of a plane; planes that are channels share it."""
        squares = np.full(light.shape[1:], self._rounding * self._rounding, light.dtype)
        for values in light if self._aspect is None else light[plane : plane + 1]:
            squares[:-1] += np.square(values[1:] - values[:-1])
            squares[:, :-1] += np.square(values[:, 1:] - values[:, :-1])
        if self._aspect is not None and plane + 1 < len(light):
            squares += np.square(self._aspect * (light[plane + 1] - light[plane]))
        return np.sqrt(squares, out=squares)

    def _neighbours(self, light: Values, plane: int) -> tuple[Values, Values, float]:
        """Return P/strength and Q/strength (class docstring) at each voxel of a plane, and its total variation.

        Channels have the total variation in common: an equal part of it is returned for each.
        """
        values, norms = light[plane], self._gradient_norms(light, plane)
        variation = float(norms.sum(dtype=np.float64))
        weight = light.dtype.type(1.0) / norms
        weights, weighted_sums = np.zeros_like(values), np.zeros_like(values)
        for low, high in ((np.s_[:-1], np.s_[1:]), (np.s_[:, :-1], np.s_[:, 1:])):
            weighted_sum = weight[low] * (values[low] + values[high])
            for side in (low, high):
                weights[side] += weight[low]
                weighted_sums[side] += weighted_sum
        if self._aspect is None:
            return weights, weighted_sums, variation / len(light)
        aspect_squared = self._aspect * self._aspect
        if plane + 1 < len(light):
            weight *= aspect_squared
            weights += weight
            weighted_sums += weight * (values + light[plane + 1])
        if plane > 0:
            weight = aspect_squared / self._gradient_norms(light, plane - 1)
            weights += weight
            weighted_sums += weight * (values + light[plane - 1])
        return weights, weighted_sums, variation


def _root(e: Values, p: Values, q: Values) -> Values:
    """Return the positive root of ``2 p x^2 + (1 - q) x = e``, without cancellation.

    This is the equation of :class:`VariationIteration` divided by s.
    """
    linear = q - 1.0
    root = np.sqrt(linear * linear + 8.0 * p * e)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(linear > 0.0, (linear + root) / (4.0 * p), 2.0 * e / (root - linear))


def iteration_of(
    method: RichardsonLucy | TotalVariation,
    blur: PlaneOperator,
    counted: PoissonLikelihood,
    course: Sequence[StepSettings] | None = None,
    *,
    background: Background,
    aspect: float | None = None,
    threads: int = 0,
) -> Iteration:
    """Return the iteration of a method; see :class:`Iteration` and :class:`VariationIteration` for the arguments."""
    if isinstance(method, RichardsonLucy):
        return Iteration(blur, counted, course, background=background)
    return VariationIteration(blur, counted, course, background=background, aspect=aspect, threads=threads)


class Solution(NamedTuple):
    """Result of a method for a photograph: light, number of steps, reason to stop, weight of the total variation.

    `alike` repeats the same steps for other counts, for example of another part of the photograph, and returns their
    light. `noise_product` is the expected sum, over the certain pixels, of noise times (light - photograph), if
    the method knows it; `least_discrepancy` is the discrepancy of less smooth light.
    """

    light: Values
    steps: int
    stopped: str
    alike: Callable[[PhotographLikelihood], Values]
    strength: float | None = None
    noise_product: float | None = None
    least_discrepancy: float | None = None


def iterated(
    method: RichardsonLucy | TotalVariation,
    counts: PhotographLikelihood,
    report: ProgressCallback,
    course: Sequence[StepSettings] | None = None,
) -> Solution:
    """Deblur the counts of a photograph, with the steps of the `course` of another part if one is given."""
    iteration = iteration_of(method, counts.operator, counts, course, background=_NO_BACKGROUND)
    steps, stopped, _ = iteration.solve(method, report)
    light = counts.operator.image(iteration.inside(0, 0))

    def alike(other: PhotographLikelihood) -> Values:
        return iterated(method, other, silent, iteration.course).light

    return Solution(light, steps, stopped, alike, iteration.strength)
