"""What methods for the pupils of objectives share: a tolerance, and how it is met over peaks yet unknown."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Intensities, not_met
from lommel.methods.method import Method
from lommel.optics.layers.objective_pupil import ObjectivePupil

LEAST = 1e-15
"""What fields are asked for at the finest."""

BRIGHT_RING = 1.8412
"""The maximum of J1 in v: light that is dark on the axis is bright here."""


def likely_peak(pupil: ObjectivePupil) -> float:
    """Return about what light is at its peak in the darkest plane, spread over where paraxial rays arrive."""
    layers = pupil.layers
    away = np.abs(pupil.focus - (layers.immersion / layers.sample) * pupil.depth).max()
    blur = layers.wavenumber * float(away) * layers.NA**2 / layers.immersion
    return min(0.25, 2.0 / (1.0 + blur**2))


def settled(
    made_of: Callable[[float], tuple[Array, Array]], tol: float, *, first: float, least: float, named: float
) -> Intensities:
    """Return values whose error is at most `tol` of the peak that is found.

    `made_of` gives them, shape ``(n, ...)``, and what they are off by at most, ``(n,)``, for an accuracy, of which
    `first` is tried first and none below `least`; then ToleranceError says that the tolerance `named` is not met.
    """
    asked = first
    while True:
        values, error = made_of(asked)
        lowest = values.reshape(len(values), -1).max(axis=1) - error
        relative = np.divide(error, lowest, out=np.full(lowest.shape, np.inf), where=lowest > 0.0)
        if (worst := float(relative.max(initial=0.0))) <= tol:
            return Intensities(values, relative, lowest)
        if asked <= least:
            raise not_met(named, worst, "the peak")
        asked = max(least, asked * max(1e-4, min(0.5, 0.5 * tol / worst)))


class LayeredMethod(Method[ObjectivePupil]):
    """A method for the pupils of objectives; dataclasses of it have a `tol`."""

    pupils = "objective"
    apodized = True
    nonradial = True

    def __post_init__(self) -> None:
        self._check_tol()
