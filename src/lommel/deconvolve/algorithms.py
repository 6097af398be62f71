"""Methods of deconvolution: their options, stopping rules, progress and result."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Json, Values, fields_of, plain
from lommel.fit.findings import Findings, Judged

# Reasons to stop.
NOISE, STEPS, MISFIT, ONE_PASS = "noise", "steps", "misfit: depth, lens or noise do not fit", "one pass"
UNDETERMINED = "undetermined: the photograph does not show its blur"

# Arguments: number of steps taken, discrepancy, estimated remaining time (s).
ProgressCallback = Callable[[int, float, float], object]


def silent(*_: object) -> None:
    """Report no progress."""


EARLIEST = 20  # first step at which a misfit can be detected


@dataclass(frozen=True, kw_only=True)
class RichardsonLucy:
    r"""Richardson-Lucy deconvolution: ``x <- x / (A^T w) * A^T[w (y + s) / (A x + s)]``, from a uniform scene.

    Each step raises the likelihood; since late steps fit the noise, stopping early keeps the result smooth. The
    iteration stops when the discrepancy D (Poisson deviance per pixel, about 1 for the true scene) reaches `target`.
    A discrepancy that stays above 1 shows a misfit of depth, lens or noise, which further steps would turn into
    artefacts. Each doubling of the number of steps k lowers D by less than the doubling before. A step k >= 20 is
    therefore a misfit if a forecast of D after all n steps exceeds 1 + d, where d is three standard deviations of D.
    The forecast assumes that each remaining doubling (at least one) lowers D as much as the last:
    ``D(k) - (D(k/2) - D(k)) max(log2(n/k), 1) > 1 + d``.

    Parameters
    ----------
    steps : int, default 200
        Maximum number of steps, 1 to 100000.
    target : float, default 0.9
        Discrepancy at which to stop. The default is below 1 because the result also fits part of the noise. With 0
        all `steps` are taken.
    accelerate : bool, default True
        Whether to extrapolate the steps, which saves about two thirds of them.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.

    Notes
    -----
    In the formula x is the scene, y the image, A the blur, w the weights of the pixels and s the read variance.
    Richardson 1972, doi:10.1364/JOSA.62.000055; Lucy 1974, doi:10.1086/111605; read variance after
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


def is_misfit(history: Sequence[float], steps: int, most: float) -> bool:
    """Check whether the discrepancy after `steps` steps, by an optimistic forecast, exceeds `most`.

    `history` has the discrepancy after each step so far; for the forecast see :class:`RichardsonLucy`.
    """
    step, discrepancy = len(history) - 1, history[-1]
    if step < EARLIEST or discrepancy <= most:
        return False
    fall = history[step // 2] - discrepancy
    return discrepancy - fall * max(math.log2(steps / step), 1.0) > most


class StoppingRule:
    """Stopping criterion of Richardson-Lucy steps, with the history of discrepancies and the extrapolation factor.

    `slack` is three standard deviations of the discrepancy of the true scene.
    """

    def __init__(self, method: RichardsonLucy, slack: float, report: ProgressCallback) -> None:
        self._method, self._slack, self._report = method, slack, report
        self._history: list[float] = []
        self._start = time.perf_counter()
        self.extrapolation = 0.0  # factor alpha of Biggs and Andrews, 0 to below 1, for the next step

    @property
    def steps(self) -> int:
        """Number of steps taken; the history starts with the discrepancy of the initial scene."""
        return len(self._history) - 1

    def judge(self, discrepancy: float) -> str | None:
        """Record and report the discrepancy of a step, and return the reason to stop, or None to continue."""
        self._history.append(discrepancy)
        self._report(self.steps, discrepancy, self._remaining_seconds(time.perf_counter() - self._start))
        step, target, largest_fitting = self.steps, self._method.target, 1.0 + self._slack
        # If a uniform scene already agrees with the image within the noise, no detail can be restored.
        if target > 0.0 and (discrepancy <= target or (step == 0 and discrepancy <= largest_fitting)):
            return NOISE
        if target > 0.0 and is_misfit(self._history, self._method.steps, largest_fitting):
            return MISFIT
        return STEPS if step == self._method.steps else None

    def update_extrapolation(self, square: float, overlap: float) -> None:
        """Set the extrapolation factor from successive changes g' and g: ``overlap = g.g'``, ``square = g'.g'``."""
        # Below 1: at 1 a geometric series of changes would diverge.
        self.extrapolation = min(max(overlap / square, 0.0), 0.999) if square > 0.0 else 0.0

    def _remaining_seconds(self, elapsed: float) -> float:
        """Return the estimated remaining time (s), from the fall of the discrepancy so far."""
        step, history, target = self.steps, self._history, self._method.target
        total = float(self._method.steps)
        if step >= 2 and target > 0.0 and history[step] < history[step // 2]:
            # D falls about as steps^-rate: minus the slope of log D over log steps in the last doubling.
            rate = np.log(history[step // 2] / history[step]) / np.log(step / (step // 2))
            total = min(total, step * max(history[step] / target, 1.0) ** min(1.0 / rate, 8.0))
        return max(total - step, 0.0) * elapsed / max(step, 1)


_MAX_TRIALS = 6  # number of total variation strengths tried by a search
_CLOSE_ENOUGH = (-0.1, 0.03)  # range of ln(discrepancy / target) that ends a search


@dataclass(frozen=True, kw_only=True)
class TotalVariation:
    r"""Deblurring with total variation, which preserves edges.

    Minimizes ``sum w (m - y ln m) + strength * sum abs(grad x)`` over ``x >= 0``, with ``m = A x + s``, for a scene
    x, image y, blur A, pixel weights w and read variance s. The norm of the gradient is taken over all channels
    together, so that channels share edges. By default the `strength` is chosen so that the discrepancy of the result
    (Poisson deviance per pixel) is `target`.

    Parameters
    ----------
    strength : float, optional
        Dimensionless weight of the total variation, typically ``0.15 / sqrt(electrons per pixel)``. Chosen from the
        noise by default.
    steps : int, default 150
        Maximum number of steps for each `strength` tried, 1 to 100000. The steps end earlier once the objective
        hardly falls.
    target : float, default 0.9
        Discrepancy to reach, above 0. The default is below 1 because the result also fits part of the noise.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.

    Notes
    -----
    Extrapolated steps of De Pierro 1995, doi:10.1109/42.370409, which have a closed form for each pixel. The norm is
    rounded, ``sqrt(abs(grad x)^2 + e^2)`` with e = 0.01 of the mean light. Each strength starts from the result of
    the strength before.
    """

    strength: float | None = None
    steps: int = 150
    target: float = 0.9

    def __post_init__(self) -> None:
        if self.strength is not None:
            validation.real("strength", self.strength, above=0.0)
        validation.integer("steps", self.steps, least=1, most=100_000)
        validation.real("target", self.target, above=0.0)


def search(
    discrepancy_at: Callable[[float], float], first: float, target: float, smallest: float
) -> tuple[float, float]:
    """Find the strength of the total variation whose result has the target discrepancy.

    `discrepancy_at` iterates with a strength and returns the discrepancy of the result. The search solves
    ``ln(discrepancy / target) = 0`` for ln(strength), from strength `first` on, between `smallest` and 64 times
    `first`. Returns the discrepancy and the strength of the last call.
    """
    trials: list[tuple[float, float]] = []  # ln(strength), ln(discrepancy / target)
    strength = first
    while True:
        discrepancy = discrepancy_at(strength)
        trials.append((math.log(strength), math.log(discrepancy / target)))
        if len(trials) == _MAX_TRIALS or _CLOSE_ENOUGH[0] <= trials[-1][1] <= _CLOSE_ENOUGH[1]:
            return discrepancy, strength
        next_strength = min(max(_next_strength(trials), smallest), 64.0 * first)
        if math.isclose(next_strength, strength, rel_tol=1e-6):
            return discrepancy, strength
        strength = next_strength


def _next_strength(trials: list[tuple[float, float]]) -> float:
    """Return the next strength to try, given pairs ln(strength), ln(discrepancy / target).

    The discrepancy rises with the strength.
    """
    below = [trial for trial in trials if trial[1] < 0.0]
    above = [trial for trial in trials if trial[1] >= 0.0]
    if below and above:
        (a, u), (b, v) = max(below), min(above)
        # Secant in the bracket [a, b], kept away from its ends so that the bracket shrinks by at least 30 %.
        fraction = min(max(-u / (v - u), 0.3), 0.7) if b > a else 0.5
        return math.exp(a + fraction * (b - a))
    log_strength, excess = trials[-1]
    slope = 0.3  # typical d ln(discrepancy) / d ln(strength)
    if len(trials) > 1 and log_strength != trials[-2][0]:
        slope = max((excess - trials[-2][1]) / (log_strength - trials[-2][0]), 1e-3)
    # Without a bracket the strength changes by a factor of 4 at most: the slope is a local estimate.
    return math.exp(log_strength - min(max(excess / slope, -math.log(4.0)), math.log(4.0)))


Pixels = NDArray[np.generic]  # stored values, unsigned integers or floats


@dataclass(frozen=True, eq=False, repr=False)
class Restoration(Judged):
    """Result of :func:`lommel.imaging.restore`; converts to an array of its values.

    Attributes
    ----------
    values : ndarray
        Restored image, of the shape, type and encoding of the photograph, without the offset of its noise.
    light : ndarray of float
        Restored image in linear light, not clipped at white.
    discrepancy : float
        Poisson deviance per pixel between the photograph and the blurred result: about 1 if the result is the true
        scene, and a little less for a good result, which also fits some of the noise.
    by_channel : tuple of float
        Discrepancy of each channel.
    before : float
        Discrepancy before the restoration, with the photograph itself as the result.
    steps : int
        Total number of steps; each applies the blur and its transpose once.
    stopped : str
        Reason to stop: "noise" if the result agrees with the photograph within its noise, "steps" at the maximum
        number of steps, "one pass", "misfit: ..." where depth, lens or noise do not fit, "undetermined: ..." where
        the photograph does not determine an unknown blur.
    strength : float or None
        Weight of the total variation.
    unknown : float
        Fraction of the values of the photograph that were NaN or saturated.
    clipped : float
        Fraction of the values that were clipped at white; 0 for floats.
    photograph : float
        Weight of the photograph in the result, 0 to 1. It is 1 if the result of the method would be farther from the
        scene, because depth, lens or noise do not fit; between 0 and 1 if the blur is hardly larger than the noise;
        else 0.
    findings : Findings
        Problems found: the codes "misfit", "too_quiet" and, if more steps would fit better, "not_settled"; for one
        distance also "blur_doubtful", "sharpened", and "undetermined" if an unknown distance remains so.
    distances, distance_errors : tuple of float
        Estimates of an unknown distance, metres, the likeliest first, and their standard errors: by their blur, the
        two sides of the focus are alike without aberrations. Empty if the distance was stated.
    blocks : tuple of mappings
        Where an unknown distance varies, for each overlapping block of the photograph its centre, "row" and "column"
        (pixels), the diameter of its blur, "blur_pixels" (None if it is not known), "distances" and "distance_errors"
        as above. Else empty.
    """

    values: Pixels
    light: Values
    discrepancy: float
    by_channel: tuple[float, ...]
    before: float
    steps: int
    stopped: str
    strength: float | None = None
    unknown: float = 0.0
    clipped: float = 0.0
    photograph: float = 0.0
    findings: Findings = field(default_factory=Findings)
    distances: tuple[float, ...] = ()
    distance_errors: tuple[float, ...] = ()
    blocks: tuple[Mapping[str, Any], ...] = ()

    @property
    def message(self) -> str:
        """Status, discrepancy, number of steps, and the texts of all findings."""
        return self._message(f"discrepancy {self.discrepancy:.3g} after {self.steps} step{'s' * (self.steps != 1)}")

    def to_dict(self) -> Json:
        """Return the result as data that can be written as JSON, without images.

        Returns
        -------
        dict
            Status, converged, reliable, and all attributes except arrays; numbers that are not finite are None.
        """
        verdict = {name: getattr(self, name) for name in ("status", "converged", "reliable")}
        numbers = {name: value for name, value in fields_of(self).items() if not isinstance(value, np.ndarray)}
        data: Json = plain(verdict | numbers)
        return data

    def __repr__(self) -> str:
        return f"<Restoration: {self.message}>"

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> Pixels:
        """Return the values."""
        return np.array(self.values, dtype=dtype, copy=copy)
