"""Cross-validation with held-out photons: stopping rule, background level and comparison of PSFs for a stack.

Counts are split into two halves. Counts plus the read-noise variance are close to ``Poisson(mu + read^2)`` (Snyder et
al. 1993, doi:10.1364/JOSAA.10.001014): each half receives a binomial share of the nearest integer, and half of the
rounding remainder. The halves are uncorrelated if gain, offset and read noise are correct. One half is deconvolved;
the iteration stops at the minimum of the Poisson deviance of the other half.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple, cast

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.deconvolve.algorithms import RichardsonLucy, TotalVariation, silent
from lommel.deconvolve.iterations import Background, Iteration, State, StepSettings
from lommel.deconvolve.likelihood import TINY, PoissonLikelihood
from lommel.deconvolve.linear import PlaneOperator
from lommel.fit.findings import Finding
from lommel.microscopy.depth_model import DepthModel, GivenPSF
from lommel.microscopy.refinement import NARROWEST, Progress, StackContext, TrialDeconvolution, Work, brightest
from lommel.recorded.noise import Noise

SIDE = 40
"""Side, in pixels, of the region in which PSFs are compared."""
MAX_VOXELS = 500_000
"""Largest number of voxels of a stack whose background is estimated from held-out photons of the whole stack."""
_STEPS, _PATIENCE = 150, 6  # largest number of iterations, and of iterations after the best one
_USUAL_STEPS = 55  # typical number of iterations
_RISE, _LEVELS, _SETTLE = 0.0065, 8, 3  # background steps: relative size, largest number, iterations after each
_MAX_LOSS = 2.0  # accepted decrease of lnL (log likelihood), relative to the best background
_INDEX_STEP, _MORE_CHANGES = 0.005, 4  # tested change of the sample index, and number of further changes
_SIGNIFICANT, _MIN_GAIN = 3.0, 5.0  # least increase of lnL by a better PSF: standard errors, and absolute
_UNCERTAIN = -1.0, 4.0  # significance range, standard errors, in which the halves are exchanged for a second test
_USUAL_RUNS = 8.0  # typical number of deconvolutions
_ESTIMATED, _UNIFORM = Background(None), State()


class Best(NamedTuple):
    """The iteration whose estimate agrees best with the held-out photons."""

    loss: float  # negative log likelihood of the held-out photons, up to a constant
    steps: int
    losses: Values  # loss of each voxel
    electrons: Values  # expected electrons of each voxel
    level: float  # estimated background of the half that was deconvolved
    state: State
    course: list[StepSettings]  # settings of all iterations


class _Half(PoissonLikelihood):
    """Counts of one half, and the deviance of its model from the other half."""

    def __init__(self, recorded: Values, validation: Values, noise: Noise) -> None:
        self._validation: Values | None = None
        super().__init__(recorded, noise)
        self._validation = validation
        self._losses, self._electrons = (np.zeros(validation.shape, np.float32) for _ in range(2))
        self.best = Best(math.inf, 0, self._losses, self._electrons, 0.0, State(), [])

    def _deviance_sums(self, plane: int, rows: slice, columns: slice, light: Values, misfit: Values | None) -> Array:
        sums = super()._deviance_sums(plane, rows, columns, light, misfit)
        if self._validation is not None:
            position = plane, rows, columns
            _, weight = self.part(*position)
            counts = np.maximum(self._validation[position] + self._added_at(rows, columns), np.float32(0.0))
            valid = np.isfinite(counts) & (weight > 0.0)
            counts = np.where(valid, counts, light)  # `light` now holds the model
            # The Poisson deviance m - y + y ln(y / m) of the held-out counts y.
            loss = light - counts + counts * np.log(np.maximum(counts, TINY) / light)
            self._losses[position] = np.where(valid, self.white * weight * loss, 0.0)
            self._electrons[position] = self.white * weight * light
        return sums

    def is_past_best(self, step: int, iteration: Iteration) -> bool:
        """Update the best iteration; return whether it was _PATIENCE or more iterations ago."""
        loss = float(self._losses.sum(dtype=np.float64))
        if loss < self.best.loss:
            self.best = Best(
                loss,
                step,
                self._losses.copy(),
                self._electrons.copy(),
                float(self.background),
                iteration.state,
                iteration.course,
            )
        return step - self.best.steps >= _PATIENCE


class Halves:
    """Counts (planes, height, width) split into two halves, one to deconvolve and one to validate the result."""

    def __init__(self, values: Values, camera: Noise, limit: float = math.inf) -> None:
        gain = np.asarray(1.0 if camera.white is None else camera.white)
        variance = np.asarray(camera.read) ** 2
        recorded = values.astype(np.float64)
        with np.errstate(invalid="ignore"):
            valid = np.isfinite(recorded) & (recorded < limit)
        electrons = np.where(valid, gain * (recorded - camera.offset) + variance, 0.0)
        integers = np.maximum(np.rint(electrons), 0.0)
        # Each photon goes to either half with probability 1/2: the two parts of a Poisson variable are independent.
        draw = np.random.default_rng(0).binomial(integers.astype(np.int64), 0.5)
        self.parts = [
            # Subtract half of the read-noise variance, which was added to the counts.
            np.where(valid, (share + 0.5 * (electrons - integers) - 0.5 * variance) / gain, np.nan).astype(np.float32)
            for share in (draw, integers - draw)
        ]
        # Each half has half of the read-noise variance.
        self.noise = Noise(white=camera.white, read=np.asarray(camera.read) / math.sqrt(2.0))

    def deconvolve_half(
        self, blur: PlaneOperator, progress: Callable[[int, float, float], object], *, fold: int = 0,
        background: Background = _ESTIMATED, start: State = _UNIFORM, steps: int = _STEPS,
        course: list[StepSettings] | None = None,
    ) -> Best:  # fmt: skip
        """Deconvolve a half, and return the iteration that agrees best with the other half."""
        half = _Half(self.parts[fold], self.parts[1 - fold], self.noise)
        iteration = Iteration(blur, half, course, background=background)
        iteration.start_from(start)
        iteration.enough = lambda step, _: half.is_past_best(step, iteration)
        iteration.solve(RichardsonLucy(steps=steps, target=0.0), progress)
        return half.best


def stopping_rule(
    method: RichardsonLucy | TotalVariation, steps: int, counted: PoissonLikelihood
) -> Callable[[int, float], bool] | None:
    """Return a stopping rule: at least `steps` iterations (best for held-out photons), and a residual within noise.

    Return None if `steps` is 0, or the method is not Richardson-Lucy with a target discrepancy of at least 1.
    """
    if not (isinstance(method, RichardsonLucy) and method.target >= 1.0 and steps):
        return None
    max_discrepancy = max(method.target, 1.0 + counted.slack)
    return lambda step, discrepancy: step >= steps and discrepancy <= max_discrepancy


def highest_level(joint: Best, continue_iteration: Callable[[Background, State, int], Best]) -> float:
    """Return the background of the counts: the highest level that agrees with the held-out photons.

    Background and a uniform specimen have the same image, and the iteration does not redistribute light between them.
    Too low a background adds a pedestal to the specimen and reduces the likelihood only slightly; too high a
    background contradicts dark voxels. From `joint`, the result with background and specimen estimated together, the
    background is raised in steps, and the increase is subtracted from the specimen. After each increase
    ``continue_iteration(background, state, steps)`` continues the iteration.
    """
    levels: list[float] = []
    losses: list[float] = []
    for increases in range(_LEVELS + 1):
        levels.append(joint.level * (1.0 + _RISE) ** increases)
        start = joint.state.subtract(levels[-1] - joint.level)
        losses.append(continue_iteration(Background(levels[-1]), start, _SETTLE).loss)
        max_loss = min(losses) + _MAX_LOSS
        if losses[-1] > max_loss:
            # The levels refer to half of the counts. Interpolate linearly between the last two, and double.
            fraction = (max_loss - losses[-2]) / (losses[-1] - losses[-2])
            return 2.0 * (levels[-2] + fraction * (levels[-1] - levels[-2]))
    return 2.0 * levels[-1]


def held_out_background(context: StackContext, model: GivenPSF, margin: tuple[int, int]) -> tuple[float | None, int]:
    """Return the flat background and the number of steps for one PSF, by held-out photons of the whole stack.

    Return None and 0 if a uniform specimen agrees with the stack within its noise.
    """
    values = np.stack([np.asarray(context.stack[plane]) for plane in range(len(context.stack))])
    counted = PoissonLikelihood(values, context.camera, context.saturation)
    if counted.flat() <= 1.0 + counted.slack:
        return None, 0
    halves, blur = Halves(values, context.camera.poisson, context.saturation), model.blur(values.shape, margin)

    def continue_iteration(background: Background, start: State, steps: int) -> Best:
        return halves.deconvolve_half(blur, silent, background=background, start=start, steps=steps)

    joint = halves.deconvolve_half(blur, silent)
    return highest_level(joint, continue_iteration), joint.steps


class HeldOut(TrialDeconvolution):
    """Region of a stack with its counts split into two halves."""

    def __init__(self, context: StackContext, progress: Progress, *, side: int = SIDE) -> None:
        # Light beyond is blurred on a coarse grid: halves of few photons do not show the difference.
        super().__init__(context, brightest(context.stack, side, context.saturation), widest=NARROWEST)
        self._model, self._work = cast("DepthModel", context.model), Work(progress, _USUAL_RUNS * _USUAL_STEPS)
        self._halves = Halves(self._values, self._camera, context.saturation)

    @property
    def is_uniform(self) -> bool:
        """Whether a uniform specimen agrees with the counts of the region within their noise."""
        return self._counted.flat() <= 1.0 + self._counted.slack

    def best(self, label: str, model: DepthModel, fold: int = 0, similar: Best | None = None) -> Best:
        """Deconvolve a half, and return the iteration that agrees best with the other half.

        With the result of a `similar` PSF its steps are taken, with its extrapolation: lnL is then a smooth function
        of the index.
        """
        progress = self._work(f"held-out photons, {label}", _USUAL_STEPS)
        blur = self.blur(model, len(self._values))
        if similar is None:
            return self._halves.deconvolve_half(blur, progress, fold=fold)
        steps = max(similar.steps, 1)
        return self._halves.deconvolve_half(blur, progress, fold=fold, course=similar.course, steps=steps)

    def level(self, joint: Best) -> float:
        """Return the background of the stack from `joint`, its estimate together with the specimen."""
        blur = self.blur(self._model, len(self._values))

        def continue_iteration(background: Background, start: State, steps: int) -> Best:
            progress = self._work("held-out photons, background", steps)
            return self._halves.deconvolve_half(blur, progress, background=background, start=start, steps=steps)

        return highest_level(joint, continue_iteration)

    def finding(self, reference: Best) -> Finding | None:
        """Compare PSFs for other refractive indices of the sample with `reference`, the result for the given index.

        Return None if no other index is valid.
        """
        start = self._model.objective.sample
        results: dict[float, Best] = {start: reference}

        def result_for(change: float, similar: Best, fold: int = 0) -> Best | None:
            value = start + change
            try:
                model = self._model.changed("sample", value)
            except ValueError:
                return None
            return self.best(f"index of the sample {value:.4g}", model, fold, similar)

        for change in (-_INDEX_STEP, _INDEX_STEP):
            if result := result_for(change, reference):
                results[start + change] = result
        gains = {value: _gain(reference, result) for value, result in results.items() if value != start}
        if not gains:
            return None
        value = max(gains, key=lambda value: gains[value][0] / gains[value][1])
        gain, error = gains[value]
        if _UNCERTAIN[0] < gain / error < _UNCERTAIN[1]:
            second = self.best("the PSF as given", self._model, 1)
            second_other = result_for(value - start, second, 1)
            assert second_other is not None
            more_gain, more_error = _gain(second, second_other)
            gains[value] = gain, error = gain + more_gain, math.hypot(error, more_error)
        numbers: dict[str, float] = {"sample": start, "lnL": gain, "lnL_error": error}
        if gain <= max(_SIGNIFICANT * error, _MIN_GAIN):
            changes = " and ".join(f"{x:+.0f} +- {sigma:.0f} with {index:.4g}" for index, (x, sigma) in gains.items())
            text = (
                f"held-out photons prefer no other index of the sample to {start:.4g}: their lnL changes by {changes}"
            )
            excluded = [f"{i:.4g}" for i, (x, sigma) in gains.items() if x <= -max(_SIGNIFICANT * sigma, _MIN_GAIN)]
            text += f", which excludes {' and '.join(excluded)}" if excluded else ""
            return Finding("psf_compared", "note", text, numbers)
        change, best = value - start, results[value]
        for farther in range(2, 2 + _MORE_CHANGES):
            farther_result = result_for(farther * change, reference)
            if farther_result is None:
                break
            results[start + farther * change] = farther_result
            if farther_result.loss > best.loss:
                break
            best = farther_result
        preferred, width = _least({index: result.loss for index, result in results.items()})
        numbers |= {"preferred": preferred, "preferred_error": width}
        farthest = "" if math.isfinite(width) else " or beyond"
        text = (
            f"held-out photons agree better with an index of the sample of {value:.4g} than of {start:.4g} (lnL by "
            f"{gain:.0f} +- {error:.0f}), and of the indices tried best with one near {preferred:.4g}{farthest}: the "
            "PSF may be wrong; only the index was varied, and another depth, spherical aberration, pixel or NA has a "
            "similar effect"
        )
        return Finding("psf_doubtful", "doubt", text, numbers)


def estimated_held_out_steps(shape: tuple[int, ...]) -> float:
    """Return the cost of the comparison of PSFs, in iterations on the whole stack."""
    return _USUAL_RUNS * _USUAL_STEPS * math.prod(min(side, SIDE) for side in shape[1:]) / math.prod(shape[1:])


def _gain(reference: Best, other: Best) -> tuple[float, float]:
    """Return the increase of lnL of the held-out photons with another PSF, and its standard error.

    For counts y and expected counts m and m' the increase is ``sum y ln(m'/m)``, with variance ``sum m ln(m'/m)^2``.
    """
    gain = float((reference.losses.astype(np.float64) - other.losses).sum())
    valid = (reference.electrons > 0.0) & (other.electrons > 0.0)
    a, b = reference.electrons[valid].astype(np.float64), other.electrons[valid].astype(np.float64)
    return gain, max(math.sqrt(float((0.5 * (a + b) * np.log(a / b) ** 2).sum())), 1e-9)


def _least(losses: dict[float, float]) -> tuple[float, float]:
    """Return the minimum of a parabola through the smallest loss and its neighbours, and twice its standard error.

    In simulated stacks twice the standard error was the actual error. It is inf if the smallest loss is at an end.
    """
    values = sorted(losses)
    k = min(range(len(values)), key=lambda index: losses[values[index]])
    if not 0 < k < len(values) - 1:
        return values[k], math.inf
    nearest = values[k - 1 : k + 2]
    curvature, slope, _ = np.polyfit(np.array(nearest) - values[k], [losses[value] for value in nearest], 2)
    # The minimum of b x^2 + s x is at -s / (2 b), and lnL falls by 1/2 at 1 / sqrt(2 b) from it.
    return float(values[k] - 0.5 * slope / curvature), float(2.0 / math.sqrt(2.0 * curvature))
