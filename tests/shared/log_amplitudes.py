"""How much an amplitude exp(-(g_0 + g_1 t + ...)) of t in [0, 1] grows in the complex plane, in many digits."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import mpmath as mp


@cache
@mp.workdps(40)
def _parts(light: tuple[float, ...]) -> list[mp.mpf]:
    """Return minus the first Chebyshev coefficient of the sum, and the magnitudes of the others."""
    count = len(light) + 1
    angles = [mp.pi * (j + mp.mpf(1) / 2) / count for j in range(count)]
    values = [sum(mp.mpf(g) * ((1 + mp.cos(a)) / 2) ** k for k, g in enumerate(light)) for a in angles]
    sums = [sum(f * mp.cos(k * a) for f, a in zip(values, angles, strict=True)) for k in range(1, len(light))]
    return [-sum(values) / count, *(2 * abs(one) / count for one in sums)]


@mp.workdps(40)
def log_amplitude(light: Sequence[float], cosh: mp.mpf) -> mp.mpf:
    """Return the largest logarithm of the amplitude on an ellipse, by the sum of its Chebyshev coefficients."""
    first, *parts = _parts(tuple(light))
    return sum((part * mp.cosh(k * mp.acosh(cosh)) for k, part in enumerate(parts, 1)), first)
