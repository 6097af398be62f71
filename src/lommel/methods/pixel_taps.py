r"""Taps of a filter with a response, found by least squares, with a proven bound on what it is off by.

A filter for pixels side by side need not have whole samples a pixel: two pixels of pitch a may share s samples, an
odd number, ``h = 2 a / s`` apart. The middle of the one is a sample then, that of the other half way between two.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

_FARTHEST = 1.27  # v between samples that two pixels share: of pi/2, where no filter is long enough, four fifths
_WORTH = 0.85  # of the samples that whole ones a pixel take


def fitted(response: Any, wave: Any, x: NDArray[Any]) -> tuple[NDArray[np.float64], float, float]:
    """Return weights of samples at rising distances `x` on either side, a bound on what they are off by, their gain.

    Weights by least squares at Chebyshev points of the band. The error of the response is even or odd, and entire, of
    type ``T = x[-1]``; all but 1e-17 of it is a polynomial in w of degree ``M = 2.36 T + 48`` (its Chebyshev series
    falls below ``e^-48`` there). As a trigonometric polynomial of the angle it falls from its largest value no faster
    than ``cos(M s)`` (Duffin and Schaeffer, Bull. Amer. Math. Soc. 44, 236, 1938), and one of 2 M Chebyshev points is
    within ``pi / (4 M)`` of that: it is at most sqrt(2) times as large as at these points.

    Parameters
    ----------
    response : callable
        What is wanted of angular frequencies in v, up to 2.
    wave : callable
        ``np.cos`` of even responses, ``np.sin`` of odd ones.
    x : ndarray, shape (k,)
        In v; a sample at 0 counts once.

    Returns
    -------
    weights : ndarray, shape (k,)
    error : float
        At most this far is the response, for ``|w| <= 2``.
    gain : float
        Sum of the magnitudes of all weights.
    """
    degree = math.ceil(2.36 * float(x[-1])) + 48
    w = 2.0 * np.cos((np.arange(degree) + 0.5) * (0.5 * math.pi / degree))
    times = np.where(x > 0.0, 2.0, 1.0)
    basis = times * wave(np.outer(w, x))
    wanted = response(w)
    c, *_ = np.linalg.lstsq(basis, wanted, rcond=1e-13)
    c *= (x > 0.0) | (wave is np.cos)  # which no odd response tells
    gain = float((times * np.abs(c)).sum())
    rounding = 2.0**-52 * (x.size + 3) * gain
    return c, math.sqrt(2.0) * (float(np.abs(basis @ c - wanted).max()) + rounding) + 1e-17, gain


def shared(step: float, error: float, across: int, sides: tuple[int, ...]) -> int:
    """Return how many samples two pixels had best share along an axis; twice `across`, where that is as good.

    Fewer samples take longer filters, and so more of them beyond the edges of a window of few pixels.

    Parameters
    ----------
    step : float
        Pitch in v.
    error : float
        Of the filter.
    across : int
        Samples a pixel that are known to do.
    sides : tuple of int
        Of the window, in pixels.
    """

    def samples(s: int) -> float:
        return math.prod(0.5 * s * side + 2.0 * _half(step, error, s) for side in sides)

    fewest = min(range(math.ceil(2.0 * step / _FARTHEST), 2 * across + 1), key=samples)
    return fewest if samples(fewest) < _WORTH * samples(2 * across) else 2 * across


def _half(step: float, error: float, s: int) -> int:
    """Return how many samples on either side a filter takes, likely."""
    room = 1.0 - 4.0 * step / (s * math.pi)
    return max(s // 4 + 2, int(0.25 * s + math.log(0.1 / error) / (3.4 * room)) - 2)


def paired(response: Any, step: float, error: float, s: int) -> tuple[NDArray[np.float64], float, float]:
    """Return weights for two pixels that share `s` samples, odd, off by `error`; both from the first sample on.

    Parameters
    ----------
    response, error
        As of :func:`fitted`.
    step : float
        Pitch in v.
    s : int

    Returns
    -------
    weights : ndarray, shape (2, 2 k + s // 2 + 1)
        The middle of the first pixel is sample k; that of the second is half a step beyond sample ``k + s // 2``.
    error, gain : float
        The larger one of both.
    """
    h, half = 2.0 * step / s, _half(step, error, s)
    while True:
        even, off, gain = fitted(response, np.cos, h * np.arange(half + 1))
        odd, *worse = fitted(response, np.cos, h * (np.arange(half) + 0.5))
        off, gain = max(off, worse[0]), max(gain, worse[1])
        if (off <= error and gain <= 1.5) or half > s + 60:
            weights = np.zeros((2, 2 * half + s // 2 + 1))
            weights[0, : 2 * half + 1] = np.concatenate([even[:0:-1], even])
            weights[1, s // 2 + 1 :] = np.concatenate([odd[::-1], odd])
            return weights, off, gain
        half += 1
