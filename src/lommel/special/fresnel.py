"""The Fresnel integral in the form that neither oscillates nor cancels."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

HALF = 0.5 * math.sqrt(math.pi) * np.exp(0.25j * math.pi)
"""``int_0^inf exp(i tau^2) d tau``."""


def fresnel_auxiliary(s: ArrayLike) -> NDArray[np.complex128]:
    """Return ``G(s) = exp(-i s^2) int_s^inf exp(i tau^2) d tau`` for ``s >= 0``.

    ``G(s) = (sqrt(pi)/2) e^{i pi/4} w(e^{i pi/4} s)`` with the Faddeeva function w (DLMF 7.5.8-10);
    smooth, ``~ i / (2s)`` at large s. Relative error about 1e-13.

    Parameters
    ----------
    s : array_like
        >= 0.

    Returns
    -------
    ndarray of complex
    """
    from scipy.special import wofz

    return np.asarray(HALF * wofz(np.exp(0.25j * math.pi) * np.asarray(s, dtype=np.float64)))
