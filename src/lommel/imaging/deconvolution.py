"""Deconvolution of photographs in electrons: Poisson likelihood, Richardson-Lucy, total variation."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.imaging.linear import LinearBlur
from lommel.recorded.noise import Noise

# Why a method stopped.
NOISE, STEPS, MISFIT, ONE_PASS = "noise", "steps", "misfit: depth, lens or noise do not fit", "one pass"

# Takes the number of a step, its discrepancy, and about how many seconds are left.
Tell = Callable[[int, float, float], object]

TINY = 1e-30  # keeps what is divided by from 0: an observed 0 has then a ratio of 0


class Solution(NamedTuple):
    """The result of a method: light, number of steps, why it stopped, the strength of the regularization.

    `alike` is the method that does the same to other parts of the photograph.
    """

    light: Values
    steps: int
    stopped: str
    alike: Method
    strength: float | None = None


class Method(Protocol):
    """A method of restoration."""

    def solve(self, observed: Observed, tell: Tell) -> Solution:
        """Return the sharp light behind an observation."""


class Counts:
    """Known pixels and gain of what a sensor counted, and the discrepancies that follow from sums over them."""

    known: NDArray[np.int64]  # number of pixels of each channel, or plane, that are known and not saturated
    white: float  # mean gain, electrons a unit of light

    @property
    def slack(self) -> float:
        """Three standard deviations of the discrepancy of the true scene, by which it may exceed 1."""
        return 3.0 * math.sqrt(2.0 / float(self.known.sum()))

    def per_pixel(self, sums: Array) -> Array:
        """Return the Poisson deviance per known pixel from its sums over each channel, in units of light."""
        return np.asarray(2.0 * self.white * sums / np.maximum(self.known, 1))

    def mean(self, discrepancies: Array) -> float:
        """Return the discrepancy of all channels together."""
        return float((discrepancies * self.known).sum() / self.known.sum())


@dataclass(frozen=True, eq=False)
class Observed(Counts):
    r"""Counts of a blurred scene and what is known of their noise, all in units of light.

    A pixel whose gain is g electrons a unit of light has ``g y + read^2`` close to ``Poisson(g (A x) + read^2)``
    (Snyder et al. 1993, doi:10.1364/JOSAA.10.001014): `counts` are ``y + read^2 / g``, `added` is ``read^2 / g``.
    """

    blur: LinearBlur
    counts: Values  # y + read^2 / g, never negative, and 0 where nothing is known
    added: Values  # read^2 / g
    weight: Values  # gain over its mean, `white`; 0 of unknown pixels
    white: float
    full: NDArray[np.bool_] | None = None  # saturated pixels, which counted at least so much

    @classmethod
    def of(cls, blur: LinearBlur, light: Values, noise: Noise, saturation: float = math.inf) -> Self:
        """Return the observation of recorded light, NaN where it is unknown; ValueError if none of it is known."""
        known = np.isfinite(light)
        full = known & (light >= saturation)
        if not (known & ~full).any():
            raise ValueError("no pixel of the photograph is known: all are NaN or saturated")
        # Channels come last in images and first in what a sensor's maps are made for.
        planes = np.moveaxis(np.where(known, np.minimum(light, saturation), 0.0).reshape(*light.shape[:2], -1), 2, 0)
        noise = noise.poisson
        electrons = noise.electrons(planes)
        gain = np.broadcast_to(1.0 if noise.white is None else noise.white, planes.shape)
        added = (noise.variance(np.zeros(planes.shape)) / gain).astype(blur.dtype)

        def image(plane: Values) -> Values:
            return np.ascontiguousarray(np.moveaxis(plane, 0, 2), dtype=blur.dtype).reshape(light.shape)

        weight = np.where(known, image(gain), 0.0)
        white = float(weight.sum(dtype=np.float64) / known.sum())
        counts = np.where(known, np.maximum(image(electrons / gain + added), 0.0), 0.0)
        parts = counts.astype(blur.dtype), image(added), (weight / white).astype(blur.dtype), white
        return cls(blur, *parts, full if full.any() else None)

    def __post_init__(self) -> None:
        known = self.weight > 0.0
        if self.full is not None:
            known &= ~self.full
        count = np.count_nonzero(known.reshape(*self.blur.shape, -1), axis=(0, 1))
        object.__setattr__(self, "known", np.asarray(count))

    @cached_property
    def seen(self) -> Values:
        """The transpose of the blur applied to the weights: how much of each point was seen."""
        return np.asarray(np.maximum(self.blur.adjoint(self.weight), 0.0))

    @cached_property
    def flat(self) -> Values:
        """A uniform scene, as bright in each channel as the photograph."""
        return np.broadcast_to(self._means(np.maximum(self.counts - self.added, 0.0)), self.counts.shape).copy()

    @property
    def smallest(self) -> float:
        """Light that replaces zeros, so that it may grow."""
        return 1e-6 * max(float(self._means(self.counts).max()), TINY)

    @property
    def image(self) -> Values:
        """The photograph as light, unknown pixels as bright as the mean."""
        return np.where(self.weight > 0.0, np.maximum(self.counts - self.added, 0.0), self.flat)

    def model(self, light: Values) -> Values:
        """Return the expected counts of a scene."""
        made = self.blur.forward(light)
        made += self.added
        np.maximum(made, TINY, out=made)
        return made

    def ratio(self, model: Values) -> Values:
        """Return counts over those of a model; 1 of a saturated pixel for which the model has enough."""
        found = np.divide(self.counts, model)
        if self.full is not None:
            np.maximum(found, 1.0, out=found, where=self.full)
        return np.asarray(found)

    def discrepancies(self, model: Values, ratio: Values) -> Array:
        """Return the Poisson deviance per known pixel of each channel: about 1 where the model is right."""
        terms = np.maximum(ratio, TINY)
        np.log(terms, out=terms)
        # m - y + y ln(y/m), by q = y/m: what cancels, 1 - q, is exact where q is near 1.
        terms *= ratio
        terms += 1.0 - ratio
        terms *= model
        terms *= self.weight
        return self.per_pixel(terms.reshape(*self.blur.shape, -1).sum(axis=(0, 1), dtype=np.float64))

    def discrepancy(self, model: Values, ratio: Values) -> float:
        """Return the Poisson deviance per pixel (Bertero et al. 2010, doi:10.1088/0266-5611/26/10/105004)."""
        return self.mean(self.discrepancies(model, ratio))

    def discrepancies_of(self, light: Values) -> Array:
        """Return the Poisson deviance per known pixel of each channel, of a scene."""
        model = self.model(light)
        return self.discrepancies(model, self.ratio(model))

    def _means(self, image: Values) -> Values:
        """Return the weighted mean of each channel; of an unknown one the mean of the others."""
        planes = (image * self.weight).reshape(*self.blur.shape, -1)
        weights = self.weight.reshape(*self.blur.shape, -1)
        total, seen = planes.sum(axis=(0, 1), dtype=np.float64), weights.sum(axis=(0, 1), dtype=np.float64)
        # Not 0, which steps that multiply would never leave.
        each = np.where(seen > 0.0, total / np.maximum(seen, TINY), total.sum() / seen.sum())
        means = np.asarray(each, dtype=self.counts.dtype)
        return means if image.ndim == 3 else means.reshape(())


EARLIEST = 20  # steps after which a misfit can be told


@dataclass(frozen=True, kw_only=True)
class RichardsonLucy:
    r"""Richardson-Lucy deconvolution: ``x <- x / (A^T w) * A^T[w (y + s) / (A x + s)]``, from a uniform scene.

    Each step raises the likelihood; since late steps fit the noise, stopping early keeps the result smooth. It stops
    when the discrepancy (about 1 for the true scene) reaches `target`. A discrepancy that stays above 1 shows a
    misfit of depth, lens or noise, which further steps would turn into artefacts. The discrepancy D falls less at
    each doubling of the number k of steps: a misfit is detected from step 20 on where it would stay above 1, by more
    than its own noise s, until the last of n steps if it fell as much at each, and at one more at least,
    ``D(k) - (D(k/2) - D(k)) max(log2(n/k), 1) > 1 + s``.

    Parameters
    ----------
    steps : int, default 200
        Maximum number of steps, 1 to 100000.
    target : float, default 0.9
        Discrepancy at which to stop. The default is below 1 because the result also fits part of the noise. 0 takes
        all `steps`.
    accelerate : bool, default True
        Whether to extrapolate the steps, which saves about two thirds of them.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.

    Notes
    -----
    Richardson 1972, doi:10.1364/JOSA.62.000055; Lucy 1974, doi:10.1086/111605; s, the read variance, after
    Snyder et al. 1993, doi:10.1364/JOSAA.10.001014; acceleration after Biggs and Andrews 1997,
    doi:10.1364/AO.36.001766; stopping after Bertero et al. 2010, doi:10.1088/0266-5611/26/10/105004.
    """

    steps: int = 200
    target: float = 0.9
    accelerate: bool = True

    def __post_init__(self) -> None:
        validation.integer("steps", self.steps, least=1, most=100_000)
        validation.real("target", self.target, least=0.0)
        validation.truth("accelerate", self.accelerate)

    def solve(self, observed: Observed, tell: Tell) -> Solution:
        """Return the restored light from the counts `observed`; `tell` gets step, discrepancy and seconds left."""
        light = before = observed.flat
        # What no known pixel sees stays as it is.
        unseen = observed.seen <= 1e-6
        per = 1.0 / np.where(unseen, 1.0, observed.seen)
        some_unseen, smallest = bool(unseen.any()), observed.smallest
        # Kept for all steps: new memory costs more than what is done in it.
        extrapolated, change, earlier = (np.empty_like(light) for _ in range(3))
        course = Course(self, observed.slack, tell)
        while True:
            guess = light
            if course.pace > 0.0:
                guess = np.subtract(light, before, out=extrapolated)
                guess *= course.pace
                guess += light
                np.maximum(guess, smallest, out=guess)
            model = observed.model(guess)
            ratio = observed.ratio(model)
            if stopped := course.judge(observed.discrepancy(model, ratio)):
                alike = replace(self, steps=course.steps, target=0.0) if course.steps else self
                return Solution(guess, course.steps, stopped, alike)
            ratio *= observed.weight
            found = observed.blur.adjoint(ratio)
            found *= per
            found *= guess
            if some_unseen:
                np.copyto(found, guess, where=unseen)
            np.maximum(found, 0.0, out=found)
            before, light = light, found
            if self.accelerate:
                earlier, change = change, np.subtract(found, guess, out=earlier)
                if course.steps > 0:
                    course.go_on(float(np.vdot(earlier, earlier)), float(np.vdot(change, earlier)))


class Course:
    """The course of an iteration: its discrepancies, whether to stop, and how far steps are extrapolated."""

    def __init__(self, method: RichardsonLucy, slack: float, tell: Tell) -> None:
        self._method, self._slack, self._tell = method, slack, tell
        self._history: list[float] = []
        self._start = time.perf_counter()
        self.pace = 0.0

    @property
    def steps(self) -> int:
        """Number of steps."""
        return len(self._history) - 1

    def judge(self, discrepancy: float) -> str | None:
        """Return the reason to stop at this discrepancy, if there is one, and call `tell`."""
        self._history.append(discrepancy)
        self._tell(self.steps, discrepancy, self._left(time.perf_counter() - self._start))
        step, target, most = self.steps, self._method.target, 1.0 + self._slack
        # A flat scene that explains all has nothing to be found in it.
        if target > 0.0 and (discrepancy <= target or (step == 0 and discrepancy <= most)):
            return NOISE
        if target > 0.0 and step >= EARLIEST and discrepancy > most:
            # It falls the less the longer it goes on: at no doubling of the steps by more than at the last one.
            fall = self._history[step // 2] - discrepancy
            if discrepancy - fall * max(math.log2(self._method.steps / step), 1.0) > most:
                return MISFIT
        return STEPS if step == self._method.steps else None

    def go_on(self, size: float, overlap: float) -> None:
        """Set the pace, from the square of the last change but one, and its product with the last."""
        self.pace = min(max(overlap / size, 0.0), 0.999) if size > 0.0 else 0.0

    def _left(self, spent: float) -> float:
        """Return about how many seconds the rest takes, as the discrepancy fell until now."""
        step, history, target = self.steps, self._history, self._method.target
        total = float(self._method.steps)
        if step >= 2 and target > 0.0 and history[step] < history[step // 2]:
            rate = np.log(history[step // 2] / history[step]) / np.log(step / (step // 2))
            total = min(total, step * max(history[step] / target, 1.0) ** min(1.0 / rate, 8.0))
        return max(total - step, 0.0) * spent / max(step, 1)


_STEP = 40.0  # of the light over that of its dual, over the rms of the light
_SEARCHES = 6  # strengths that are tried at most
_NEAR = (-0.1, 0.03)  # logarithms of the discrepancy over the target that are near enough
_WEAKEST = 8.0  # of what noise asks for over what is tried; right depths take half to double of it
_SETTLED, _EVERY = 3e-3, 25  # change of the discrepancy over so many steps


@dataclass(frozen=True, kw_only=True)
class TotalVariation:
    r"""Deblurring with total variation, which preserves edges.

    The minimum of ``sum w (m - y ln m) + strength * sum |grad x|`` over ``x >= 0``, with ``m = A x + s``. The
    gradient is that of all channels together, so that they share their edges. The `strength` is found from the noise,
    such that the discrepancy of the result is `target`.

    Parameters
    ----------
    strength : float, optional
        Dimensionless weight of the total variation, typically ``0.15 / sqrt(electrons per pixel)``.
    steps : int, default 150
        Number of steps for a given `strength`, 1 to 100000; fewer for each one tried, if it converges.
    target : float, default 0.9
        Discrepancy to reach, above 0. Less than 1, since the result follows some of the noise.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.

    Notes
    -----
    Primal-dual steps of Chambolle and Pock 2011, doi:10.1007/s10851-010-0251-1, with the diagonal step sizes of Pock
    and Chambolle 2011, doi:10.1109/ICCV.2011.6126441. Each strength starts from the result of the last one. Gradient
    steps on the likelihood would be limited by the darkest pixel.
    """

    strength: float | None = None
    steps: int = 150
    target: float = 0.9

    def __post_init__(self) -> None:
        if self.strength is not None:
            validation.real("strength", self.strength, above=0.0)
        validation.integer("steps", self.steps, least=1, most=100_000)
        validation.real("target", self.target, above=0.0)

    def solve(self, observed: Observed, tell: Tell) -> Solution:
        """Return the restored light from the counts `observed`; `tell` gets step, discrepancy and seconds left."""
        walk = _Walk(observed, tell, self.steps)
        if self.strength is not None:
            found = walk.settle(self.strength, last=True)
            reason = NOISE if found <= 1.0 + observed.slack else STEPS
            return Solution(walk.light, walk.taken, reason, self, self.strength)
        if observed.mean(observed.discrepancies_of(observed.flat)) <= 1.0 + observed.slack:
            return Solution(observed.flat, 0, NOISE, self)
        electrons = observed.white * float(np.mean(observed.counts, dtype=np.float64))
        first = 0.15 / math.sqrt(max(electrons, 1e-6))
        kept = walk.light

        def settle(strength: float) -> float:
            nonlocal kept
            found = walk.settle(strength)
            if strength == first:
                kept = walk.light
            return found

        found, strength = search(settle, first, self.target, first / _WEAKEST)
        if found > 1.0 + observed.slack and strength <= first / _WEAKEST * 1.001:
            # Hardly smoothed it fits no better: what is left is no noise, and must not be drawn into the picture.
            return Solution(kept, walk.taken, MISFIT, replace(self, strength=first), first)
        reason = NOISE if found <= 1.0 + observed.slack else STEPS
        return Solution(walk.light, walk.taken, reason, replace(self, strength=strength), strength)


def search(settle: Callable[[float], float], first: float, target: float, least: float) -> tuple[float, float]:
    """Return the discrepancy nearest to the target and its strength: `settle` returns that of a strength.

    It is sought on a line of their logarithms, from the `first` one on, between the `least` and 64 times the first.
    """
    tried: list[tuple[float, float]] = []
    strength = first
    for _ in range(_SEARCHES):
        found = settle(strength)
        tried.append((math.log(strength), math.log(found / target)))
        if _NEAR[0] <= tried[-1][1] <= _NEAR[1]:
            break
        following = min(max(_next(tried), least), 64.0 * first)
        if math.isclose(following, strength, rel_tol=1e-6):
            break
        strength = following
    return found, strength


def _next(tried: list[tuple[float, float]]) -> float:
    """Return the strength to try, from logarithms of strengths and of discrepancies over the target, which rise."""
    at, off = tried[-1]
    below = [point for point in tried if point[1] < 0.0]
    above = [point for point in tried if point[1] >= 0.0]
    if below and above:
        (a, u), (b, v) = max(below), min(above)
        share = min(max(-u / (v - u), 0.3), 0.7) if b > a else 0.5
        return math.exp(a + share * (b - a))
    slope = 0.3  # usually
    if len(tried) > 1 and tried[-1][0] != tried[-2][0]:
        slope = max((off - tried[-2][1]) / (at - tried[-2][0]), 1e-3)
    return math.exp(at - min(max(off / slope, -math.log(4.0)), math.log(4.0)))


class _Walk:
    """State of the primal-dual steps: light, and the duals of the likelihood and of the gradient."""

    def __init__(self, observed: Observed, tell: Tell, most: int) -> None:
        self.observed, self.tell, self.most = observed, tell, most
        self.light = observed.image.astype(observed.counts.dtype)
        self.ahead = self.light
        self.fit = np.zeros_like(self.light)
        self.slopes = np.zeros((2, *self.light.shape), dtype=self.light.dtype)
        size = _STEP * max(math.sqrt(float(np.mean(np.square(observed.image), dtype=np.float64))), 1e-12)
        known = observed.weight > 0.0
        # Rows and columns of the blur, in which pixels that are not known have no part.
        rows = observed.blur.forward(np.ones_like(self.light))
        columns = observed.blur.adjoint(known.astype(self.light.dtype))
        self.pace = size / (np.maximum(columns, 0.0) + 4.0)
        self.pace_fit = known / (size * np.maximum(rows, 1e-3))
        self.pace_slopes = self.light.dtype.type(1.0 / (2.0 * size))
        self.taken = 0
        self.settled: list[int] = []
        self.start = time.perf_counter()

    def settle(self, strength: float, last: bool = False) -> float:
        """Iterate with one strength, the last one to the end, and return the discrepancy of the light."""
        history: list[float] = []
        for step in range(1, self.most + 1):
            history.append(self._step(strength))
            self.tell(self.taken, history[-1], self._left(self.most - step, last))
            if not last and step > 2 * _EVERY and abs(history[-1] / history[-1 - _EVERY] - 1.0) < _SETTLED:
                break
        self.settled.append(len(history))
        return self.observed.mean(self.observed.discrepancies_of(self.light))

    def _step(self, strength: float) -> float:
        """Take one step, and return the discrepancy of the light ahead of it."""
        observed = self.observed
        model = observed.model(self.ahead)
        found = observed.discrepancy(model, observed.ratio(model))
        # The minimum of what stands for w (m - y ln m), in closed form.
        model *= self.pace_fit
        model += self.fit
        down = model - observed.weight
        fit = down * down
        fit += 4.0 * self.pace_fit * observed.weight * observed.counts
        np.sqrt(fit, out=fit)
        np.subtract(model + observed.weight, fit, out=fit)
        fit *= 0.5
        if observed.full is not None:
            np.minimum(fit, 0.0, out=fit, where=observed.full)
        self.fit = fit
        self.slopes += self.pace_slopes * _gradient(self.ahead)
        _shorten(self.slopes, strength)
        back = observed.blur.adjoint(fit)
        back += _gradient_transposed(self.slopes)
        back *= self.pace
        light = np.maximum(self.light - back, 0.0)
        self.ahead = 2.0 * light - self.light
        self.light = light
        self.taken += 1
        return found

    def _left(self, here: int, last: bool) -> float:
        """Return about how many seconds are left: a search tries three or four strengths, later ones for shorter."""
        more = 0 if last else max(3 - len(self.settled), 0) * 2 * _EVERY
        return (here + more) * (time.perf_counter() - self.start) / self.taken


def _gradient(image: Values) -> Values:
    """Return differences to the next row and to the next column, 0 at the last ones."""
    slopes = np.zeros((2, *image.shape), dtype=image.dtype)
    np.subtract(image[1:], image[:-1], out=slopes[0, :-1])
    np.subtract(image[:, 1:], image[:, :-1], out=slopes[1, :, :-1])
    return slopes


def _gradient_transposed(slopes: Values) -> Values:
    """Return the transpose of the gradient."""
    image = np.zeros(slopes.shape[1:], dtype=slopes.dtype)
    down, right = slopes[0, :-1], slopes[1, :, :-1]
    image[:-1] -= down
    image[1:] += down
    image[:, :-1] -= right
    image[:, 1:] += right
    return image


def _shorten(slopes: Values, most: float) -> None:
    """Limit the length of the vectors of all channels together to `most`."""
    squares = np.square(slopes)
    length = squares[0] + squares[1]
    if length.ndim == 3:
        length = length.sum(axis=2, keepdims=True)
    np.sqrt(length, out=length)
    np.maximum(length / most, 1.0, out=length)
    slopes /= length
