"""Photons of a part of a stack that are held out: they tell when to stop, which background and which PSF is right.

Counts are divided between two halves. Counts plus the variance of reading are close to ``Poisson(mu + read^2)``
(Snyder et al. 1993, doi:10.1364/JOSAA.10.001014): of the nearest integer each half gets a binomial share, and half of
the rest. As the variance of what is divided is its mean, the halves are uncorrelated, as far as gain, offset and read
noise are right. One half is restored; steps end where the deviance of the other one is the least.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.deconvolve.algorithms import RichardsonLucy, TotalVariation
from lommel.deconvolve.iterations import Background, Iteration, State, StepSettings
from lommel.deconvolve.linear import PlaneOperator
from lommel.deconvolve.poisson_counts import TINY, PoissonCounts
from lommel.fit.findings import Finding
from lommel.microscopy.depth_model import DepthModel
from lommel.microscopy.refinement import StackContext, Tell, TrialDeconvolution, Work, brightest
from lommel.recorded.noise import Noise

SIDE = 40
"""Pixels of the side of the part in which PSFs are compared."""
WHOLE = 500_000
"""Voxels of a stack, up to which its background is estimated by photons that are held out of all of it."""
_STEPS, _PATIENCE = 150, 6  # largest number of steps of a walk, and steps after the best one
_USUAL = 55  # usual number of steps of a walk
_RISE, _LEVELS, _SETTLE = 0.0065, 8, 3  # relative rise of the background, largest number of rises, steps of each
_WITHIN = 2.0  # of lnL: largest loss of a background against the best one
_APART, _FARTHER = 0.005, 4  # change of the sample's index that is tried, and number of further ones
_SURE = 2.5  # standard errors from which on another PSF agrees better
_OPEN = -1.0, 4.0  # standard errors between which the other half is used as well
_WALKS = 8.0  # usual number of walks
_ESTIMATED, _FLAT = Background(None), State()


class Best(NamedTuple):
    """The step of a walk whose light agrees best with the photons that were held out."""

    loss: float  # minus the logarithm of their likelihood, but for a constant
    steps: int
    losses: Values  # of each voxel
    electrons: Values  # that are expected in each voxel
    level: float  # background of a half
    state: State
    course: list[StepSettings]  # of the whole walk


class _Half(PoissonCounts):
    """Counts of one half, and the agreement of their model with the other half."""

    def __init__(self, recorded: Values, held: Values, noise: Noise) -> None:
        self._held: Values | None = None
        super().__init__(recorded, noise)
        self._held = held
        self._losses, self._electrons = (np.zeros(held.shape, np.float32) for _ in range(2))
        self.best = Best(math.inf, 0, self._losses, self._electrons, 0.0, State(), [])

    def _deviance_sums(self, plane: int, rows: slice, columns: slice, light: Values, misfit: Values | None) -> Array:
        found = super()._deviance_sums(plane, rows, columns, light, misfit)
        if self._held is not None:
            at = plane, rows, columns
            _, weight = self.part(*at)
            seen = np.maximum(self._held[at] + self._added_at(rows, columns), np.float32(0.0))
            known = np.isfinite(seen) & (weight > 0.0)
            seen = np.where(known, seen, light)  # the light has become the model
            # The Poisson deviance m - y + y ln(y / m) of the held-out counts y.
            loss = light - seen + seen * np.log(np.maximum(seen, TINY) / light)
            self._losses[at] = np.where(known, self.white * weight * loss, 0.0)
            self._electrons[at] = self.white * weight * light
        return found

    def past(self, step: int, walk: Iteration) -> bool:
        """Return whether the best step of a walk is _PATIENCE or more steps ago."""
        loss = float(self._losses.sum(dtype=np.float64))
        if loss < self.best.loss:
            self.best = Best(
                loss,
                step,
                self._losses.copy(),
                self._electrons.copy(),
                float(self.background),
                walk.state,
                walk.course,
            )
        return step - self.best.steps >= _PATIENCE


class Halves:
    """Counts (planes, height, width) divided between two halves: one is restored, the other says how well."""

    def __init__(self, values: Values, camera: Noise, limit: float = math.inf) -> None:
        gain = np.asarray(1.0 if camera.white is None else camera.white)
        spread = np.asarray(camera.read) ** 2
        recorded = values.astype(np.float64)
        with np.errstate(invalid="ignore"):
            known = np.isfinite(recorded) & (recorded < limit)
        given = np.where(known, gain * (recorded - camera.offset) + spread, 0.0)
        whole = np.maximum(np.rint(given), 0.0)
        # Each photon goes to either half with the same chance: shares of a Poisson variable are independent.
        draw = np.random.default_rng(0).binomial(whole.astype(np.int64), 0.5)
        self.parts = [
            # Each half has half of the variance of reading, which was added to the counts.
            np.where(known, (each + 0.5 * (given - whole) - 0.5 * spread) / gain, np.nan).astype(np.float32)
            for each in (draw, whole - draw)
        ]
        # Half of the variance each.
        self.noise = Noise(white=camera.white, read=np.asarray(camera.read) / math.sqrt(2.0))

    def walked(
        self, blur: PlaneOperator, told: Callable[[int, float, float], object], *, fold: int = 0,
        background: Background = _ESTIMATED, start: State = _FLAT, steps: int = _STEPS,
        course: list[StepSettings] | None = None,
    ) -> Best:  # fmt: skip
        """Restore a half, and return the step that agrees best with the other one."""
        half = _Half(self.parts[fold], self.parts[1 - fold], self.noise)
        walk = Iteration(blur, half, course, background=background)
        walk.start_from(start)
        walk.enough = lambda step, _: half.past(step, walk)
        walk.solve(RichardsonLucy(steps=steps, target=0.0), told)
        return half.best


def enough(
    method: RichardsonLucy | TotalVariation, steps: int, counted: PoissonCounts
) -> Callable[[int, float], bool] | None:
    """Return the rule that ends an iteration at the step that agreed best with held-out photons, None without one.

    Nor before its discrepancy is what noise may leave; methods with a target below 1 go on to that.
    """
    if not (isinstance(method, RichardsonLucy) and method.target >= 1.0 and steps):
        return None
    most = max(method.target, 1.0 + counted.slack)
    return lambda step, discrepancy: step >= steps and discrepancy <= most


def highest_level(free: Best, walked: Callable[[Background, State, int], Best]) -> float:
    """Return the background of the counts: the highest that held-out photons agree with.

    Light of a flat specimen and that of a background are the same to a stack, and a walk keeps what it began with.
    Less background than there is leaves a floor of light, which agrees little worse; more is contradicted by dark
    voxels. From the `free` walk, which estimated it with the specimen, the background is raised by what is taken from
    the specimen everywhere, and a few steps follow: `walked` takes the background, the state and their number.
    """
    places: list[float] = []
    losses: list[float] = []
    for raised in range(_LEVELS + 1):
        places.append(free.level * (1.0 + _RISE) ** raised)
        start = free.state.less(places[-1] - free.level)
        losses.append(walked(Background(places[-1]), start, _SETTLE).loss)
        most = min(losses) + _WITHIN
        if losses[-1] > most:
            # Between the last two.
            share = (most - losses[-2]) / (losses[-1] - losses[-2])
            # Two halves make the counts.
            return 2.0 * (places[-2] + share * (places[-1] - places[-2]))
    return 2.0 * places[-1]


class HeldOut(TrialDeconvolution):
    """A part of a stack in two halves."""

    def __init__(self, context: StackContext, tell: Tell, *, side: int = SIDE) -> None:
        super().__init__(context, brightest(context.stack, side, context.saturation))
        self._model, self._work = context.model, Work(tell, _WALKS * _USUAL)
        self._halves = Halves(self._values, self._camera, context.saturation)

    @property
    def plain(self) -> bool:
        """Whether a flat scene explains the stack."""
        return self._counted.flat() <= 1.0 + self._counted.slack

    def best(self, words: str, model: DepthModel, fold: int = 0, course: list[StepSettings] | None = None) -> Best:
        """Restore a half, and return the step that agrees best with the other one.

        With the `course` of another PSF steps are extrapolated as far as with that: lnL is then smooth in the index.
        """
        told = self._work(f"held-out photons, {words}", _USUAL)
        return self._halves.walked(self.blur(model, len(self._values)), told, fold=fold, course=course)

    def level(self, free: Best) -> float:
        """Return the background of the stack, of a `free` walk that estimated it with the specimen."""

        def walked(background: Background, start: State, steps: int) -> Best:
            blur, told = self.blur(self._model, len(self._values)), self._work("held-out photons, background", steps)
            return self._halves.walked(blur, told, background=background, start=start, steps=steps)

        return highest_level(free, walked)

    def finding(self, own: Best) -> Finding | None:
        """Return what held-out photons say of the PSF: of other indices of the sample, of which `own` has the given.

        None where no other index is possible.
        """
        start = self._model.objective.sample
        tried: dict[float, Best] = {start: own}

        def index(change: float, like: Best, fold: int = 0) -> Best | None:
            value = start + change
            try:
                model = self._model.changed("sample", value)
            except ValueError:
                return None
            return self.best(f"index of the sample {value:.4g}", model, fold, like.course)

        for change in (-_APART, _APART):
            if found := index(change, own):
                tried[start + change] = found
        gains = {value: _gain(own, each) for value, each in tried.items() if value != start}
        if not gains:
            return None
        value = max(gains, key=lambda each: gains[each][0] / gains[each][1])
        gain, error = gains[value]
        if _OPEN[0] < gain / error < _OPEN[1]:
            given = self.best("the PSF as given", self._model, 1)
            other = index(value - start, given, 1)
            assert other is not None
            more, off = _gain(given, other)
            gains[value] = gain, error = gain + more, math.hypot(error, off)
        numbers: dict[str, float] = {"sample": start, "lnL": gain, "lnL_error": error}
        if gain <= _SURE * error:
            words = " and ".join(f"{by:+.0f} +- {off:.0f} with {each:.4g}" for each, (by, off) in gains.items())
            text = (
                f"held-out photons prefer no other index of the sample to {start:.4g}: their lnL changes by {words}"
            )
            return Finding("psf_compared", "note", text, numbers)
        way, best = value - start, tried[value]
        for farther in range(2, 2 + _FARTHER):
            following = index(farther * way, own)
            if following is None:
                break
            tried[start + farther * way] = following
            if following.loss > best.loss:
                break
            best = following
        found_at, off = _least({each: one.loss for each, one in tried.items()})
        numbers |= {"preferred": found_at, "preferred_error": off}
        about = f"about {found_at:.4f} +- {off:.4f}" if math.isfinite(off) else f"{found_at:.4g} or beyond"
        text = (
            f"held-out photons agree better with an index of the sample of {value:.4g} than of {start:.4g} (lnL by "
            f"{gain:.0f} +- {error:.0f}), and best with {about}: the PSF may be wrong; an error of the depth, or "
            "spherical aberration, is much like one of the index"
        )
        return Finding("psf_doubtful", "doubt", text, numbers)


def estimated_held_out_steps(shape: tuple[int, ...]) -> float:
    """Return about how many steps of the whole stack the comparison of PSFs takes."""
    return _WALKS * _USUAL * math.prod(min(side, SIDE) for side in shape[1:]) / math.prod(shape[1:])


def _gain(own: Best, other: Best) -> tuple[float, float]:
    """Return by how much lnL of held-out photons is larger with another PSF, voxel by voxel, and its standard error.

    That of ``sum y ln(m'/m)``, whose variance is ``m ln(m'/m)^2`` of each voxel.
    """
    gain = float((own.losses.astype(np.float64) - other.losses).sum())
    known = (own.electrons > 0.0) & (other.electrons > 0.0)
    one, two = own.electrons[known].astype(np.float64), other.electrons[known].astype(np.float64)
    return gain, max(math.sqrt(float((0.5 * (one + two) * np.log(one / two) ** 2).sum())), 1e-9)


def _least(losses: dict[float, float]) -> tuple[float, float]:
    """Return where a parabola through the least loss and its neighbours is the least, and twice its standard error.

    In simulated stacks that is what it was off by; inf where the least is the outermost.
    """
    places = sorted(losses)
    at = min(range(len(places)), key=lambda k: losses[places[k]])
    if not 0 < at < len(places) - 1:
        return places[at], math.inf
    near = places[at - 1 : at + 2]
    bend, slope, _ = np.polyfit(np.array(near) - places[at], [losses[each] for each in near], 2)
    # The minimum of b x^2 + s x is at -s / (2 b); lnL falls by 1/2 at 1 / sqrt(2 b), and twice that is returned.
    return float(places[at] - 0.5 * slope / bend), float(2.0 / math.sqrt(2.0 * bend))
