"""The verdict on a fit: which values of chi2 noise explains, by its distribution for the degrees of freedom.

Pearson's chi2 over its expectation, with a standard deviation s, follows closely a gamma distribution of that mean
and standard deviation: the chi2 distribution of 2 / s^2 degrees of freedom over their number (Satterthwaite 1946,
doi:10.2307/3002019). Few pixels have a longer tail above than a normal distribution, and counts of few electrons
have fewer degrees of freedom than pixels.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy import special

from lommel.base.arrays import Array
from lommel.fit.findings import Finding

BY_CHANCE = 1e-4
"""Probability with which noise alone makes a fit a misfit."""
SURE = 1e-3
"""The same with which a search goes on although its fit is right."""
_DOUBTED = 1e-2


def most(spread: Any, probability: float = BY_CHANCE) -> Array:
    """Return the chi2 that noise exceeds with a probability, for standard deviations `spread` of chi2."""
    shape = 1.0 / np.square(np.maximum(spread, 1e-9))
    return np.asarray(special.gammainccinv(shape, probability) / shape)


def least(spread: Any, probability: float = BY_CHANCE) -> Array:
    """Return the chi2 below which noise is with a probability."""
    shape = 1.0 / np.square(np.maximum(spread, 1e-9))
    return np.asarray(special.gammaincinv(shape, probability) / shape)


def chance(chi2: float, spread: float) -> float:
    """Return the probability with which noise alone makes a chi2 as large."""
    shape = 1.0 / max(spread, 1e-9) ** 2
    return float(special.gammaincc(shape, shape * chi2))


def chi2_findings(chi2: float, spread: float, causes: str) -> list[Finding]:
    """Return the finding of a chi2 that noise does not explain, or seldom; `causes` of a misfit in words."""
    limit, floor, rare = float(most(spread)), float(least(spread)), chance(chi2, spread)
    numbers = {"chi2": chi2, "limit": limit, "least": floor, "chance": rare}
    if chi2 >= limit:
        return [Finding("misfit", "error", f"noise alone stays below {limit:.3g}; {causes}", numbers)]
    if chi2 < floor:
        text = "the images are less noisy than gain, read noise and offset state, so that standard errors do not hold"
        return [Finding("too_quiet", "doubt", text, numbers)]
    if rare < _DOUBTED:
        return [Finding("rare_chi2", "note", f"noise alone exceeds this chi2 in {_percent(rare)} % of fits", numbers)]
    return []


def _percent(share: float) -> str:
    return f"{100.0 * max(share, 1e-6):.1g}"
