"""Cross-validation with held-out photons: stopping rule, background level and comparison of PSFs for a stack.

Counts are split into two halves. Counts plus the read-noise variance are close to ``Poisson(mu + read^2)`` (Snyder et
al. 1993, doi:10.1364/JOSAA.10.001014): each half receives a binomial share of the nearest integer, and half of the
rounding remainder. The halves are uncorrelated if gain, offset and read noise are correct. One half is deconvolved;
the iteration stops at the minimum of the Poisson deviance of the other half.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cached_property
from typing import NamedTuple, cast

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.base.units import format_length
from lommel.deconvolve.algorithms import RichardsonLucy, TotalVariation, is_misfit, silent
from lommel.deconvolve.iterations import Background, Iteration, State
from lommel.deconvolve.likelihood import TINY, PoissonLikelihood
from lommel.deconvolve.linear import PlaneOperator
from lommel.fit.findings import Finding
from lommel.microscopy.depth_model import DepthModel, GivenPSF
from lommel.microscopy.psf_scores import PSFScores, Score
from lommel.microscopy.refinement import NARROWEST, Progress, StackContext, TrialDeconvolution, Work, brightest
from lommel.recorded.noise import Noise

SIDE = 64
"""Side, in pixels, of the region in which PSFs are compared: light beyond a smaller one imitates another index."""
MAX_VOXELS = 500_000
"""Largest number of voxels of a stack whose background is estimated from held-out photons of the whole stack."""
_STEPS, _PATIENCE = 150, 6  # largest number of iterations, and of iterations after the best one
_USUAL_STEPS = 55  # typical number of iterations
_RISE, _LEVELS, _SETTLE = 0.0065, 8, 3  # background steps: relative size, largest number, iterations after each
_MAX_LOSS = 2.0  # accepted decrease of lnL (log likelihood), relative to the best background
_INDEX_STEP = 0.005  # tested change of the sample index
_SIGNIFICANT, _MIN_GAIN = 3.0, 5.0  # least increase of lnL by a better PSF: standard errors, and absolute
_USUAL_RUNS = 2.5  # typical number of deconvolutions
# Alternatives after a misfit: a change of each parameter, and its name in words. Where the immersion has the larger
# index, these changes of index, depth and step have similar images: a score of the first gives the sign of the rest.
_ALTERNATIVES = {
    "sample": (6e-3, "index of the sample"),
    "NA": (0.02, "NA"),
    "depth": (-6e-7, "depth"),
    "wavelength": (0.03, "wavelength"),
    "step": (0.03, "step of z"),
}
_MEDIA, _FARTHEST_INDEX = (1.28, 1.6), 0.15  # indices of liquids and mounting media; largest change that is named
_FARTHEST = 0.25  # largest relative change of NA, wavelength and step: 525 nm is not light of 273 nm
_REVERSED_STEPS = 5, 20  # iterations with reversed planes, and of these if the first ones agree better
_SCORE_STEPS = 10  # steps that take as long as a score test, for the progress
_MIN_EXPLAINED = 0.03  # least decrease of the deviance by a better PSF, as a fraction of its excess
_COMPARABLE = 0.5  # PSFs whose decrease is at least this fraction of the largest decrease are reported, too
_ESTIMATED, _UNIFORM = Background(None), State()


class Best(NamedTuple):
    """The iteration whose estimate agrees best with the held-out photons."""

    loss: float  # negative log likelihood of the held-out photons, up to a constant
    steps: int
    level: float  # estimated background of the half that was deconvolved
    state: State
    losses: list[float]  # after each iteration so far


class _Half(PoissonLikelihood):
    """Counts of one half, and the deviance of its model from the other half."""

    judges_specimen = False

    def __init__(self, recorded: Values, validation: Values, noise: Noise) -> None:
        self._validation: Values | None = None
        super().__init__(recorded, noise)
        self._validation = validation
        self._parts: dict[tuple[int, int, int], float] = {}  # loss in each part of a plane
        self.losses: list[float] = []
        self._discrepancies: list[float] = []
        self.best = Best(math.inf, 0, 0.0, State(), self.losses)

    def _deviance_sums(self, plane: int, rows: slice, columns: slice, light: Values, misfit: Values | None) -> Array:
        sums = super()._deviance_sums(plane, rows, columns, light, misfit)
        if self._validation is not None:
            position = plane, rows, columns
            _, weight = self.part(*position)
            counts = np.maximum(self._validation[position] + self.added_at(rows, columns), np.float32(0.0))
            valid = np.isfinite(counts) & (weight > 0.0)
            counts = np.where(valid, counts, light)  # `light` now holds the model
            # The Poisson deviance m - y + y ln(y / m) of the held-out counts y.
            loss = light - counts + counts * np.log(np.maximum(counts, TINY) / light)
            loss = np.where(valid, weight * loss, 0.0)
            self._parts[plane, rows.start, columns.start] = self.white * float(loss.sum(dtype=np.float64))
        return sums

    def is_past_best(self, step: int, discrepancy: float, iteration: Iteration) -> bool:
        """Update the best iteration; return whether it was _PATIENCE or more iterations ago, or none can fit."""
        self._discrepancies.append(discrepancy)
        loss = math.fsum(self._parts.values())
        self.losses.append(loss)
        if loss < self.best.loss:
            self.best = Best(loss, step, float(self.background), iteration.state, self.losses)
        return step - self.best.steps >= _PATIENCE or is_misfit(self._discrepancies, _STEPS, 1.0 + self.slack)


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
        self, blur: PlaneOperator, progress: Callable[[int, float, float], object], *, reverse: bool = False,
        background: Background = _ESTIMATED, start: State = _UNIFORM, steps: int = _STEPS,
    ) -> Best:  # fmt: skip
        """Deconvolve a half, and return the iteration that agrees best with the other half.

        The planes are reversed if `reverse`.
        """
        recorded, validation = (part[::-1] if reverse else part for part in self.parts)
        half = _Half(recorded, validation, self.noise)
        iteration = Iteration(blur, half, background=background)
        iteration.start_from(start)
        iteration.enough = lambda step, discrepancy: half.is_past_best(step, discrepancy, iteration)
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
        self._scores: dict[str, Score | None] = {}

    @property
    def is_uniform(self) -> bool:
        """Whether a uniform specimen agrees with the counts of the region within their noise."""
        return self._counted.flat() <= 1.0 + self._counted.slack

    @cached_property
    def best(self) -> Best:
        """Iteration with the stated PSF that agrees best with the held-out photons."""
        progress = self._work("held-out photons, the PSF as given", _USUAL_STEPS)
        return self._halves.deconvolve_half(self._stated_blur, progress)

    @cached_property
    def _stated_blur(self) -> PlaneOperator:
        return self.blur(self._model, len(self._values))

    @cached_property
    def _tests(self) -> PSFScores:
        counted = PoissonLikelihood(self._halves.parts[1], self._halves.noise)
        return PSFScores(self._stated_blur, counted, self.best.state, self.best.level)

    def score(self, name: str) -> Score | None:
        """Return the score of the held-out photons along a parameter, None if it does not change the image.

        It is that of `changed` of the model: depth and index have values, all others are changed by a factor. Images
        are not linear in a parameter: differences towards the side of the estimate are preferred.
        """
        if name not in self._scores:
            change, title = _ALTERNATIVES[name]
            if (index := self._scores.get("sample")) is not None:
                change = math.copysign(change, change * index.slope)
            self._work(f"held-out photons, another {title}", _SCORE_STEPS)
            found: list[Score] = []
            for step in (change, -change):
                if (model := self._changed(name, step)) is not None:
                    score = self._tests.of(self.blur(model, len(self._values)), step)
                    if score is None:
                        break
                    found.append(score)
                    if score.slope * step > 0.0:
                        break
            self._scores[name] = max(found, key=lambda score: score.deviance, default=None)
        return self._scores[name]

    def _changed(self, name: str, change: float) -> DepthModel | None:
        """Return the model with a changed parameter, None if it is out of range."""
        try:
            return self._model.changed(name, _start(self._model, name) + change)
        except ValueError:
            return None

    def level(self) -> float:
        """Return the background of the stack from that of the best iteration."""

        def continue_iteration(background: Background, start: State, steps: int) -> Best:
            progress = self._work("held-out photons, background", steps)
            return self._halves.deconvolve_half(
                self._stated_blur, progress, background=background, start=start, steps=steps
            )

        return highest_level(self.best, continue_iteration)

    def finding(self) -> Finding | None:
        """Compare PSFs for other refractive indices of the sample with that of the given one.

        Return None if no other index is valid, or if none changes the images.
        """
        score, start = self.score("sample"), self._model.objective.sample
        if score is None:
            return None
        changes = (step for step in (-_INDEX_STEP, _INDEX_STEP) if self._changed("sample", step) is not None)
        gains = {start + change: score.gain(change) for change in changes}
        value = max(gains, key=lambda value: gains[value][0] / gains[value][1])
        gain, error = gains[value]
        preferred = start + score.change
        numbers = {
            "sample": start, "lnL": gain, "lnL_error": error,
            "preferred": preferred, "preferred_error": 2.0 * score.error,
        }  # fmt: skip
        if gain <= max(_SIGNIFICANT * error, _MIN_GAIN):
            parts = " and ".join(f"{x:+.0f} +- {sigma:.0f} with {index:.4g}" for index, (x, sigma) in gains.items())
            text = (
                f"held-out photons prefer no other index of the sample to {start:.4g}: their lnL changes by {parts}"
            )
            excluded = [f"{i:.4g}" for i, (x, sigma) in gains.items() if x <= -max(_SIGNIFICANT * sigma, _MIN_GAIN)]
            text += f", which excludes {' and '.join(excluded)}" if excluded else ""
            return Finding("psf_compared", "note", text, numbers)
        best = f", and best with one near {preferred:.4g}" if _is_medium(start, preferred) else ""
        text = (
            f"held-out photons agree better with an index of the sample of {value:.4g} than of {start:.4g} (lnL by "
            f"{gain:.0f} +- {error:.0f}){best}: the PSF may be wrong; only the index was varied, and another depth, "
            "spherical aberration, pixel or NA has a similar effect"
        )
        return Finding("psf_doubtful", "doubt", text, numbers)

    def alternatives(self, progress: Progress, *, try_reversed: bool) -> list[str]:
        """Return descriptions of PSFs with one changed parameter that fit held-out photons better, the best first.

        Points between voxels cause a misfit with any PSF, but hardly change which PSF is the best. Reversed planes
        are tried if `try_reversed`. Spherical aberration is not tried: its effect is similar to another index. Errors
        of index, depth and step have similar effects: all PSFs are returned that lower the deviance by at least half
        as much as the best PSF. An index that no medium has is left out: it stands for another error.
        """
        self._work = Work(
            progress, _USUAL_STEPS + _REVERSED_STEPS[0] * try_reversed + _SCORE_STEPS * len(_ALTERNATIVES)
        )
        decreases: dict[str, float] = {}  # decrease of the deviance by each change
        if try_reversed:
            model = replace(self._model, is_reversed=not self._model.is_reversed)
            label, blur = "planes in reverse order", self.blur(model, len(self._values))
            for steps in _REVERSED_STEPS:
                other = self._halves.deconvolve_half(blur, self._work(label, steps), reverse=True, steps=steps)
                if other.losses[-1] > self.best.losses[min(len(other.losses), len(self.best.losses)) - 1]:
                    break
            decreases[label] = 2.0 * (self.best.loss - other.loss)
        chi2 = self._tests.chi2
        excess = (chi2 - 1.0) * self.known
        # Reversed planes that explain most of the misfit are its cause: no other PSF is tried.
        is_explained = max(decreases.values(), default=0.0) > _COMPARABLE * excess > 0.0
        for name, (_, title) in _ALTERNATIVES.items():
            if not is_explained and (score := self.score(name)) is not None:
                start = _start(self._model, name)
                if name == "sample" and not _is_medium(start, start + score.change):
                    continue
                label = f"a {'smaller' if score.change < 0.0 else 'larger'} {title}"
                value = _value_in_words(self._model, name, start + score.change)
                decreases[f"{label} (about {value})"] = score.deviance
        largest = max(decreases.values(), default=0.0)
        least = max(_SIGNIFICANT**2 * chi2, _MIN_EXPLAINED * excess, _COMPARABLE * largest)
        return sorted((label for label in decreases if decreases[label] > least), key=lambda label: -decreases[label])


def _start(model: DepthModel, name: str) -> float:
    """Return the value of a parameter from which it is changed; 1 where it is changed by a factor."""
    if name == "depth":
        return model.depth
    return model.objective.sample if name == "sample" else 1.0


def _is_medium(start: float, index: float) -> bool:
    """Return whether a medium has the `index`, near enough to the index at the `start` for a linear estimate."""
    least, most = _MEDIA
    return min(start, least) <= index <= max(start, most) and abs(index - start) <= _FARTHEST_INDEX


def _value_in_words(model: DepthModel, name: str, value: float) -> str:
    """Return a parameter in words; for wavelength, step and NA `value` is a factor of the value of the model."""
    if name == "depth":
        return format_length(max(value, 0.0), digits=3)
    if name == "sample":
        return f"{value:.4g}"
    factor = min(max(value, 1.0 - _FARTHEST), 1.0 + _FARTHEST)
    return (
        f"{min(factor * model.objective.NA, model.objective.immersion):.4g}"
        if name == "NA"
        else format_length(factor * getattr(model, name), digits=3)
    )


def estimated_held_out_steps(shape: tuple[int, ...]) -> float:
    """Return the cost of the comparison of PSFs, in iterations on the whole stack."""
    return _USUAL_RUNS * _USUAL_STEPS * math.prod(min(side, SIDE) for side in shape[1:]) / math.prod(shape[1:])
