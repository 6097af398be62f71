"""Deconvolution of a stack with total variation: steps that lower the objective, with little memory."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.base.threads import side_by_side
from lommel.imaging.deconvolution import MISFIT, NOISE, STEPS, RichardsonLucy, Tell, TotalVariation, search
from lommel.microscopy.stack_blur import TiledBlur, WideBlur
from lommel.microscopy.stack_steps import Background, Counted, Move, Walk, at_least

_ROUND = 0.01  # of the mean light, over which the edge of the total variation is rounded
_EVERY, _SETTLED = 20, 1e-3  # steps, and the change of the objective over these, relative to the likelihood
_FALL = 1.0 / 512.0  # of the usual strength, below which none is tried


class VariationWalk(Walk):
    r"""Steps to the minimum of ``sum w (m - y ln m) + strength * sum |grad x|``, for light x above 0.

    Each step minimizes a function of one voxel at a time that is nowhere below the objective and equal to it at the
    light of before, so that the objective never rises (De Pierro 1995, doi:10.1109/42.370409): that of the likelihood
    is that of Richardson and Lucy, ``s x - e ln x``, and ``|g| <= (|g|^2 / |g'| + |g'|) / 2`` of the gradients, with
    squares ``(x - x')^2`` of which each voxel gets its half. With P and Q the sums over neighbours of weights, and of
    weights times the light of both, the root of ``2 P x^2 + (s - Q) x = e`` is in closed form. Steps are extrapolated
    as those of Richardson and Lucy, and one that raised the objective is followed by a plain one.

    Memory: one specimen more than :class:`Walk`. Differences along z are per pixel too: `aspect` is pixel over step.
    """

    def __init__(
        self,
        blur: TiledBlur | WideBlur,
        counted: Counted,
        course: Sequence[Move] | None = None,
        *,
        background: Background,
        aspect: float,
        threads: int = 0,
    ) -> None:
        super().__init__(blur, counted, course, background=background)
        self._aspect, self._threads = np.float32(aspect), threads
        self._spare: Values | None = None
        self._likelihood = 0.0
        self._round = np.float32(max(_ROUND * counted.level, counted.smallest))
        self.objectives: list[float] = []
        self.strength = self._given[-1].strength if self._given else 0.0
        self._begun = time.perf_counter()

    def solve(self, method: RichardsonLucy | TotalVariation, tell: Tell) -> tuple[int, str, Array]:
        """Iterate with the strength that was asked for, or to the one that the noise asks for."""
        assert isinstance(method, TotalVariation)
        counted = self._counted
        most = 1.0 + counted.slack
        if self._given:
            self._settle(0.0, len(self._given), tell, last=True)
            return len(self.course) - 1, STEPS, self.discrepancies
        electrons = counted.white * counted.level
        first = 0.15 / math.sqrt(max(electrons, 1e-6))
        if method.strength is None and counted.flat() <= most:
            self._look(0.0)
            return 0, NOISE, self.discrepancies

        def found_at(strength: float) -> float:
            return self._settle(strength, method.steps, tell, last=method.strength is not None)

        if method.strength is not None:
            found, self.strength = found_at(method.strength), method.strength
        else:
            found, self.strength = search(found_at, first, method.target, first * _FALL)
        stopped = NOISE if found <= most else STEPS
        if method.strength is None and found > most and self.strength <= 1.001 * first * _FALL:
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
                if self._given is None and here > _EVERY:
                    fall = self.objectives[-1 - _EVERY] - self.objectives[-1]
                    most = here if fall < _SETTLED * self._likelihood else most
            found = self._look(pace)
            each = (time.perf_counter() - self._begun) / len(self.course)
            done = len(self.objectives)
            tell(len(self.course) - 1, found, each * (max(most - done, 0) + (0 if last else 2 * _EVERY)))
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
        strength = np.float32(self._strength)

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
        """Return the magnitude of the gradient at each voxel of a plane, rounded."""
        here = light[plane]
        squares = np.full(here.shape, self._round * self._round, np.float32)
        squares[:-1] += np.square(here[1:] - here[:-1])
        squares[:, :-1] += np.square(here[:, 1:] - here[:, :-1])
        if plane + 1 < len(light):
            squares += np.square(self._aspect * (light[plane + 1] - here))
        return np.sqrt(squares, out=squares)

    def _neighbours(self, light: Values, plane: int) -> tuple[Values, Values, float]:
        """Return sums over the neighbours of each voxel, of weights and of these times both, and the variation."""
        here, slopes = light[plane], self._slopes(light, plane)
        total = float(slopes.sum(dtype=np.float64))
        one = np.float32(1.0) / slopes
        weights, both = np.zeros_like(here), np.zeros_like(here)
        for low, high in ((np.s_[:-1], np.s_[1:]), (np.s_[:, :-1], np.s_[:, 1:])):
            shared = one[low] * (here[low] + here[high])
            for side in (low, high):
                weights[side] += one[low]
                both[side] += shared
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


def walk_of(
    method: RichardsonLucy | TotalVariation,
    blur: TiledBlur | WideBlur,
    counted: Counted,
    course: Sequence[Move] | None = None,
    *,
    background: Background,
    aspect: float,
    threads: int = 0,
) -> Walk:
    """Return the steps of a method."""
    if isinstance(method, RichardsonLucy):
        return Walk(blur, counted, course, background=background)
    return VariationWalk(blur, counted, course, background=background, aspect=aspect, threads=threads)
