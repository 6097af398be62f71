"""The field of an obscured aperture, of two full ones."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from lommel.core.answers import FieldValues
from lommel.methods.method import AnyPupil


def annulus(
    disk: Callable[[NDArray[np.float64], NDArray[np.float64]], FieldValues],
    pupil: AnyPupil,
    v: NDArray[np.float64],
) -> FieldValues:
    """Build the field of an obscured aperture from that of full ones.

    ``U(v) = U_disk(v) - eps^2 U_inner(eps v)``, where the inner disk carries the phase of rho < eps, that is
    coefficients ``c_k eps^(2k)``. `disk` maps coefficients and v to a field.
    """
    coefficients = pupil.coefficients()
    outer = disk(coefficients, v)
    if pupil.obscuration == 0.0:
        return outer
    area = pupil.obscuration**2
    powers = area ** np.arange(1, 1 + coefficients.shape[1])
    inner = disk(coefficients * powers, pupil.obscuration * v)
    error = None if outer.error is None or inner.error is None else outer.error + area * inner.error
    return FieldValues(outer.values - area * inner.values, error)
