"""Base class of the methods for microscope objectives, and refinement to a tolerance relative to the peak."""

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


def refine_until(
    compute: Callable[[float], tuple[Array, Array]], tol: float, *, start: float, floor: float, named: float
) -> Intensities:
    """Return intensities of accuracies from `start` down to `floor`, the first whose error over the peak is `tol`.

    `compute` returns values, (n, ...), and bounds on their errors, (n,). ToleranceError names the tolerance `named`.
    """
    accuracy = start
    while True:
        values, error = compute(accuracy)
        lowest = values.reshape(len(values), -1).max(axis=1) - error
        relative = np.divide(error, lowest, out=np.full(lowest.shape, np.inf), where=lowest > 0.0)
        if (worst := float(relative.max(initial=0.0))) <= tol:
            return Intensities(values, relative, lowest)
        if accuracy <= floor:
            raise not_met(named, worst, "the peak")
        accuracy = max(floor, accuracy * max(1e-4, min(0.5, 0.5 * tol / worst)))


class LayeredMethod(Method[ObjectivePupil]):
    """A method for the pupils of objectives; dataclasses of it have a `tol`."""

    pupils = "objective"
    apodized = True
    nonradial = True
