"""Deblurring with total variation, which preserves edges; its weight is chosen from the noise."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Values
from lommel.imaging.observed import MISFIT, NOISE, STEPS, Observed, Solution, Tell

_STEP = 40.0  # of the light over that of its dual, over the rms of the light
_SEARCHES = 6  # strengths that are tried at most
_NEAR = (-0.1, 0.03)  # logarithms of the discrepancy over the target that are near enough
_WEAKEST = 8.0  # of what noise asks for over what is tried; right depths take half to double of it
_SETTLED, _EVERY = 3e-3, 25  # change of the discrepancy over so many steps


@dataclass(frozen=True, kw_only=True)
class TotalVariation:
    r"""Deblurring with total variation, which keeps edges.

    The minimum of ``sum w (m - y ln m) + strength * sum |grad x|`` over ``x >= 0``, with ``m = A x + s``. The
    gradient is that of all channels together, so that they share their edges. The `strength` is found from the noise,
    such that the discrepancy of the result is `target`.

    Parameters
    ----------
    strength : float, optional
        Dimensionless weight of the total variation, which depends on the noise: about ``0.15 / sqrt(electrons a
        pixel)``.
    steps : int, default 150
        Number of steps for a `strength` that is given, 1 to 100000; fewer for each that is tried, where it converges.
    target : float, default 0.9
        Discrepancy to be reached, above 0. Less than 1, since the result follows some of the noise.

    Raises
    ------
    TypeError, ValueError
        If one of them is of another type or out of range.

    Notes
    -----
    Primal-dual steps of Chambolle and Pock 2011, doi:10.1007/s10851-010-0251-1, with the diagonal step sizes of Pock
    and Chambolle 2011, doi:10.1109/ICCV.2011.6126441. Each strength begins where the last one ended. Steps by
    gradients of the likelihood would have to be as small as the darkest pixel wants them.
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
        """Return the light behind the counts `observed`; `tell` gets step, discrepancy and seconds left."""
        walk = _Walk(observed, tell, self.steps)
        if self.strength is not None:
            found = walk.settle(self.strength, last=True)
            return Solution(walk.light, walk.taken, NOISE if found <= 1.0 + observed.slack else STEPS, self.strength)
        if observed.mean(observed.discrepancies_of(observed.flat)) <= 1.0 + observed.slack:
            return Solution(observed.flat, 0, NOISE)
        return self._search(walk, observed)

    def _search(self, walk: _Walk, observed: Observed) -> Solution:
        """Return the solution of the strength whose discrepancy is the target, on a line of their logarithms."""
        electrons = observed.white * float(np.mean(observed.counts, dtype=np.float64))
        first = 0.15 / math.sqrt(max(electrons, 1e-6))
        least, most = first / _WEAKEST, 64.0 * first
        tried: list[tuple[float, float]] = []
        strength, kept = first, walk.light
        for _ in range(_SEARCHES):
            tried.append((math.log(strength), math.log(walk.settle(strength) / self.target)))
            if strength == first:
                kept = walk.light
            if _NEAR[0] <= tried[-1][1] <= _NEAR[1]:
                break
            following = min(max(_next(tried), least), most)
            if math.isclose(following, strength, rel_tol=1e-6):
                break
            strength = following
        found = self.target * math.exp(tried[-1][1])
        if found > 1.0 + observed.slack and strength <= least * 1.001:
            # Hardly smoothed it fits no better: what is left is no noise, and must not be drawn into the picture.
            return Solution(kept, walk.taken, MISFIT, first)
        return Solution(walk.light, walk.taken, NOISE if found <= 1.0 + observed.slack else STEPS, strength)


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
