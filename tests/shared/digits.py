"""Terms of bounds to many digits, and their comparison with those of the package."""

from __future__ import annotations

import mpmath as mp
import pytest


def same(found: float, expected: mp.mpf) -> bool:
    """Compare to nine digits, where neither has left the range of double precision: logarithms are cut off."""
    if not mp.mpf("1e-290") < expected < mp.mpf("1e230"):
        return found <= 1e-280 or found >= 1e220
    return found == pytest.approx(float(expected), rel=1e-9, abs=0.0)
