"""A photograph in electrons, and the Poisson likelihood of a model of it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.estimation.noise import Noise
from lommel.imaging.linear import LinearBlur

NOISE, STEPS, MISFIT = "noise", "steps", "misfit: depth, lens or noise do not fit"  # why a method stopped

# Takes the number of a step, its discrepancy, and about how many seconds are left.
Tell = Callable[[int, float, float], object]

TINY = 1e-30  # keeps what is divided by from 0: an observed 0 has then a ratio of 0


class Solution(NamedTuple):
    """The result of a method: light, number of steps, why it stopped, and the strength of the regularization."""

    light: Values
    steps: int
    stopped: str
    strength: float | None = None


class Method(Protocol):
    """A method of restoration."""

    def solve(self, observed: Observed, tell: Tell) -> Solution:
        """Return the sharp light behind an observation."""


@dataclass(frozen=True, eq=False)
class Observed:
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

    @cached_property
    def known(self) -> NDArray[np.int64]:
        """Number of pixels of each channel that are known and not saturated."""
        known = self.weight > 0.0
        if self.full is not None:
            known &= ~self.full
        return np.asarray(np.count_nonzero(known.reshape(*self.blur.shape, -1), axis=(0, 1)))

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
    def slack(self) -> float:
        """Amount by which the discrepancy of the true scene may exceed 1."""
        return slack_of(self.known)

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
        sums = terms.reshape(*self.blur.shape, -1).sum(axis=(0, 1), dtype=np.float64)
        return np.asarray(2.0 * self.white * sums / np.maximum(self.known, 1))

    def discrepancy(self, model: Values, ratio: Values) -> float:
        """Return the Poisson deviance per pixel (Bertero et al. 2010, doi:10.1088/0266-5611/26/10/105004)."""
        return self.mean(self.discrepancies(model, ratio))

    def discrepancies_of(self, light: Values) -> Array:
        """Return the Poisson deviance per known pixel of each channel, of a scene."""
        model = self.model(light)
        return self.discrepancies(model, self.ratio(model))

    def mean(self, discrepancies: Array) -> float:
        """Return the discrepancy of all channels together."""
        return float((discrepancies * self.known).sum() / self.known.sum())

    def _means(self, image: Values) -> Values:
        """Return the weighted mean of each channel; of an unknown one the mean of the others."""
        planes = (image * self.weight).reshape(*self.blur.shape, -1)
        weights = self.weight.reshape(*self.blur.shape, -1)
        total, seen = planes.sum(axis=(0, 1), dtype=np.float64), weights.sum(axis=(0, 1), dtype=np.float64)
        # Not 0, which steps that multiply would never leave.
        each = np.where(seen > 0.0, total / np.maximum(seen, TINY), total.sum() / seen.sum())
        means = np.asarray(each, dtype=self.counts.dtype)
        return means if image.ndim == 3 else means.reshape(())


def slack_of(known: NDArray[np.int64]) -> float:
    """Return three standard deviations of the discrepancy of the true scene, of so many known pixels per channel."""
    return 3.0 * math.sqrt(2.0 / float(known.sum()))
