"""Fisher scoring: damped steps to the parameters of maximum likelihood, and standard errors there."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.estimation.star_images import SURE, Scores, StarImages

_SETTLED = 1e-2  # squared length of a step, in deviations, that is not worth taking
_FAR = 2.0  # radians rms: no step changes the wavefront by more
_DAMPING = 1e-2, 1e-6, 1e8  # at first, at least, and where a search gives up
_STRETCH = 16.0  # times the length of a step, at most
_IDLE = 1e-4  # of the excess deviance: steps that gain less lead to a local minimum that does not fit
_PATIENCE = 3  # such steps one after the other


@dataclass
class Fits:
    """Ends of several searches: parameters (s, p), scores, whether the steps settled, and their numbers."""

    x: Array
    scores: Scores
    settled: NDArray[np.bool_]
    steps: NDArray[np.intp]

    def __getitem__(self, index: Sequence[int]) -> Fits:
        """Return some of them."""
        return Fits(self.x[index], self.scores.of(index), self.settled[index], self.steps[index])


def climb(model: StarImages, x: Array, most: int, report: Callable[[int, float], object]) -> Fits:
    """Take damped steps from starts `x` until they settle or one fits; `report` gets number and best chi2."""
    # Steps grow where the last one gained nearly all that its slope promised: far from the answer the information
    # overstates the curvature of the likelihood.
    count = len(x)
    now = model.scores(x)
    damping, stretch = np.full(count, _DAMPING[0]), np.ones(count)
    settled, moving = np.zeros(count, dtype=bool), np.ones(count, dtype=bool)
    steps, idle = np.zeros(count, dtype=int), np.zeros(count, dtype=int)
    for turn in range(most + 1):
        report(turn, float(now.chi2.min()))
        at = np.flatnonzero(moving)
        there = now if at.size == count else now.of(at)
        step = damped(there.information, there.slope, damping[at])
        promised = np.einsum("si,si->s", step, there.slope)
        done = (promised < _SETTLED) & (damping[at] <= 1.0)
        settled[at] = done
        moving[at] = ~done & (damping[at] < _DAMPING[2]) & (idle[at] < _PATIENCE)
        if turn == most or not moving.any() or (done & (there.chi2 < model.limit(there, SURE))).any():
            break
        go = moving[at]
        at, step, promised = at[go], step[go], promised[go]
        reach = np.minimum(stretch[at], _FAR / np.maximum(model.rms(step), 1e-300))
        tried = model.within(x[at] + reach[:, None] * step, x[at])
        new = model.scores(tried)
        steps[at] += 1
        gain = now.deviance[at] - new.deviance
        promised *= reach
        better = gain > 0.0
        stretched = stretch[at] > 1.0
        straight, bent = gain > 0.65 * promised, gain < 0.3 * promised
        longer = np.minimum(2.0 * np.maximum(reach, 1.0), _STRETCH)
        stretch[at] = np.where(straight, longer, np.where(bent, 1.0, stretch[at]))
        damping[at] *= np.where(better, 0.1, np.where(stretched, 1.0, 6.0))
        np.maximum(damping, _DAMPING[1], out=damping)
        slow = better & (gain < _IDLE * model.tested * (now.chi2[at] - model.limit(now)[at]))
        idle[at] = np.where(slow, idle[at] + 1, np.where(better, 0, idle[at]))
        x[at[better]] = tried[better]
        for mine, theirs in zip(now, new, strict=True):
            mine[at[better]] = theirs[better]
    return Fits(x, now, settled, steps)


def damped(information: Array, slope: Array, damping: Array) -> Array:
    """Return Levenberg-Marquardt steps (s, p) for information (s, p, p), slopes (s, p) and dampings (s,)."""
    scale = deviations(information)
    matrix = information / (scale[:, :, None] * scale[:, None, :])
    diagonal = np.arange(scale.shape[-1])
    matrix[:, diagonal, diagonal] += damping[:, None]
    return np.asarray(np.linalg.solve(matrix, (slope / scale)[..., None])[..., 0] / scale)


def covariance(information: Array) -> Array:
    """Return the inverse (p, p) of an information matrix, with infinite variances of undetermined parameters."""
    scale = deviations(information[None])[0]
    values, vectors = np.linalg.eigh(information / np.outer(scale, scale))
    # Derivatives in error by 1e-6 of the peak make of an eigenvalue 0 one as small as this.
    blind = values < 1e-10
    unknown = (np.abs(vectors[:, blind]) > 1e-3).any(axis=1)
    values = np.where(blind, np.inf, values)
    found = (vectors / values) @ vectors.T / np.outer(scale, scale)
    found[unknown] = found[:, unknown] = 0.0
    found[unknown, unknown] = np.inf
    return np.asarray(found)


def deviations(information: Array) -> Array:
    """Return the roots (s, p) of the diagonal of information (s, p, p), or 1 where that is 0."""
    diagonal = np.einsum("sii->si", information)
    return np.where(diagonal > 0.0, np.sqrt(diagonal), 1.0)


CERTAIN = 0.25
"""Radians rms: where phases are known less well, other minima of the likelihood are often as deep."""

STEADY = 1.125
"""Factor by which a standard error may change within one standard deviation of the answer."""


def uncertainty(model: StarImages, inverse: Array) -> tuple[float, Array]:
    """Return the largest rms error of the phase of an image, radians, and the principal axes (k, p) of a covariance.

    Each axis is one standard deviation long; parameters of infinite variance are held.
    """
    known = np.isfinite(np.diag(inverse))
    scale = np.sqrt(np.diag(inverse)[known])
    values, vectors = np.linalg.eigh(inverse[np.ix_(known, known)] / np.outer(scale, scale))
    # An eigenvector has no sign: its largest component is made positive.
    vectors *= np.sign(vectors[np.abs(vectors).argmax(axis=0), np.arange(len(values))])
    axes = np.zeros((len(values), model.size))
    axes[:, known] = (vectors * np.sqrt(np.maximum(values, 0.0))).T * scale
    # The mean square of a tilt over the pupil is a quarter of that at its edge.
    tilts = 0.25 * (model.per_image(axes)[:, : len(model.tilts)] ** 2).sum(axis=(0, 1))
    return float(np.sqrt((model.rms(axes) ** 2).sum() + tilts.max())), axes


def changes(model: StarImages, x: Array, inverse: Array, axes: Array) -> Array:
    """Return the factor by which the standard error of each shared parameter changes near the answer `x`, (1, p)."""
    # The geometric rms of those at two opposite points, one standard deviation away along all principal axes.
    found = np.ones(model.shared)
    known = np.isfinite(np.diag(inverse)[: model.shared])
    if known.any():
        points = [model.within(x + step, x) for step in (axes.sum(axis=0), -axes.sum(axis=0))]
        # A stack of pupils has one f-number, wavelength and obscuration.
        stacks = points if model.unknowns.pupil else [np.concatenate(points)]
        squares = [one for stack in stacks for one in model.scores(stack, np.float64).information]
        there = np.array([np.diag(covariance(one))[: model.shared][known] for one in squares])
        ratios = 0.5 * np.log(there / np.diag(inverse)[: model.shared][known])
        found[known] = np.exp(np.sqrt((ratios**2).mean(axis=0)))
    return found
