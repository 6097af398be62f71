"""A photograph as counted light: what a model of it is worth, whatever method makes the model."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from lommel.estimation.noise import Noise
from lommel.imaging.linear import LinearBlur

NOISE, STEPS, MISFIT = "noise", "steps", "misfit: depth, lens or noise do not fit"
"""Why a method stopped."""

Tell = Callable[[int, float, float], object]
"""Takes the number of a step, its discrepancy, and about how many seconds are left."""

TINY = 1e-30
"""Keeps what is divided by from 0: an observed 0 has then a ratio of 0."""


class Solution(NamedTuple):
    """What a method found: light, after how many steps, why it stopped, and the strength of what kept it smooth."""

    light: NDArray[Any]
    steps: int
    stopped: str
    strength: float | None = None


class Method(Protocol):
    """A way to restore."""

    def solve(self, observed: Observed, tell: Tell) -> Solution:
        """Return the sharp light behind what was observed."""


@dataclass(frozen=True, eq=False)
class Observed:
    r"""Counts of a blurred scene and what is known of their noise, all in units of light.

    A pixel whose gain is g electrons a unit of light has ``g y + read^2`` close to ``Poisson(g (A x) + read^2)``
    (Snyder et al. 1993, doi:10.1364/JOSAA.10.001014): `counts` are ``y + read^2 / g``, `added` is ``read^2 / g``.

    Attributes
    ----------
    blur : LinearBlur
    counts, added : ndarray
        Of the shape of the photograph; counts are never negative, and 0 where nothing is known.
    weight : ndarray
        Gain over its mean, `white`; 0 of a pixel that is not known.
    white : float
    full : ndarray of bool, or None
        Pixels that are saturated: they counted at least so much.
    """

    blur: LinearBlur
    counts: NDArray[Any]
    added: NDArray[Any]
    weight: NDArray[Any]
    white: float
    full: NDArray[np.bool_] | None = None

    @classmethod
    def of(cls, blur: LinearBlur, light: NDArray[Any], noise: Noise, saturation: float = math.inf) -> Self:
        """Return what was observed of light as it was recorded, NaN where it is unknown.

        Parameters
        ----------
        blur : LinearBlur
        light : ndarray of float, shape (height, width) or (height, width, channels)
        noise : Noise
        saturation : float
            Light from which on pixels are saturated.

        Returns
        -------
        Observed

        Raises
        ------
        ValueError
            If no pixel is known, or parameters of the noise fit no image of this shape.
        """
        known = np.isfinite(light)
        full = known & (light >= saturation)
        if not (known & ~full).any():
            raise ValueError("no pixel of the photograph is known: all are NaN or saturated")
        # Channels come last in images and first in what a sensor's maps are made for.
        planes = np.moveaxis(np.where(known, np.minimum(light, saturation), 0.0).reshape(*light.shape[:2], -1), 2, 0)
        electrons = noise.electrons(planes)
        gain = np.broadcast_to(1.0 if noise.white is None else noise.white, planes.shape)
        added = (noise.variance(np.zeros(planes.shape)) / gain).astype(blur.dtype)

        def image(plane: NDArray[Any]) -> NDArray[Any]:
            return np.ascontiguousarray(np.moveaxis(plane, 0, 2), dtype=blur.dtype).reshape(light.shape)

        weight = np.where(known, image(gain), 0.0)
        white = float(weight.sum(dtype=np.float64) / known.sum())
        counts = np.where(known, np.maximum(image(electrons / gain + added), 0.0), 0.0)
        parts = counts.astype(blur.dtype), image(added), (weight / white).astype(blur.dtype), white
        return cls(blur, *parts, full if full.any() else None)

    @cached_property
    def known(self) -> NDArray[np.int64]:
        """How many pixels of each channel are known and not saturated."""
        known = self.weight > 0.0
        if self.full is not None:
            known &= ~self.full
        return np.asarray(np.count_nonzero(known.reshape(*self.blur.shape, -1), axis=(0, 1)))

    @cached_property
    def seen(self) -> NDArray[Any]:
        """The transpose of the blur applied to the weights: how much of each point was seen."""
        return np.asarray(np.maximum(self.blur.adjoint(self.weight), 0.0))

    @cached_property
    def flat(self) -> NDArray[Any]:
        """A scene without anything in it, as bright in each channel as the photograph."""
        return np.broadcast_to(self._means(np.maximum(self.counts - self.added, 0.0)), self.counts.shape).copy()

    @property
    def smallest(self) -> float:
        """Light that takes the place of none, so that it may grow."""
        return 1e-6 * max(float(self._means(self.counts).max()), TINY)

    @property
    def slack(self) -> float:
        """By how much the discrepancy of what is right may exceed 1."""
        return slack_of(self.known)

    @property
    def image(self) -> NDArray[Any]:
        """The photograph as light, what is unknown as bright as the rest."""
        return np.where(self.weight > 0.0, np.maximum(self.counts - self.added, 0.0), self.flat)

    def model(self, light: NDArray[Any]) -> NDArray[Any]:
        """Return what would be counted of light on average."""
        made = self.blur.forward(light)
        made += self.added
        np.maximum(made, TINY, out=made)
        return made

    def ratio(self, model: NDArray[Any]) -> NDArray[Any]:
        """Return counts over those of a model; 1 of a saturated pixel for which the model has enough."""
        found = np.divide(self.counts, model)
        if self.full is not None:
            np.maximum(found, 1.0, out=found, where=self.full)
        return np.asarray(found)

    def discrepancies(self, model: NDArray[Any], ratio: NDArray[Any]) -> NDArray[np.float64]:
        """Return the Poisson deviance a known pixel of each channel: about 1 where the model is right."""
        terms = np.maximum(ratio, TINY)
        np.log(terms, out=terms)
        # m - y + y ln(y/m), by q = y/m: what cancels, 1 - q, is exact where q is near 1.
        terms *= ratio
        terms += 1.0 - ratio
        terms *= model
        terms *= self.weight
        sums = terms.reshape(*self.blur.shape, -1).sum(axis=(0, 1), dtype=np.float64)
        return np.asarray(2.0 * self.white * sums / np.maximum(self.known, 1))

    def discrepancy(self, model: NDArray[Any], ratio: NDArray[Any]) -> float:
        """Return the Poisson deviance a pixel (Bertero et al. 2010, doi:10.1088/0266-5611/26/10/105004)."""
        return float((self.discrepancies(model, ratio) * self.known).sum() / self.known.sum())

    def _means(self, image: NDArray[Any]) -> NDArray[Any]:
        """Return the weighted mean of each channel; of one of which nothing is known that of the others."""
        planes = (image * self.weight).reshape(*self.blur.shape, -1)
        weights = self.weight.reshape(*self.blur.shape, -1)
        total, seen = planes.sum(axis=(0, 1), dtype=np.float64), weights.sum(axis=(0, 1), dtype=np.float64)
        # Not 0, which steps that multiply would never leave.
        each = np.where(seen > 0.0, total / np.maximum(seen, TINY), total.sum() / seen.sum())
        means = np.asarray(each, dtype=self.counts.dtype)
        return means if image.ndim == 3 else means.reshape(())


def slack_of(known: NDArray[np.int64]) -> float:
    """Return three times the deviation of the discrepancy of what is right, of so many known pixels a channel."""
    return 3.0 * math.sqrt(2.0 / float(known.sum()))
