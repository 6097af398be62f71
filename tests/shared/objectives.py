"""The objective that most tests of microscopes ask about."""

from __future__ import annotations

from typing import Any

import lommel as lm


def oil(**more: Any) -> lm.Objective:
    """Return one in oil before a sample in water, with what else it has."""
    return lm.Objective(
        NA=1.4,
        magnification=63,
        immersion=1.518,
        working_distance=0.19e-3,
        coverslip=lm.Layer(1.5255, 170e-6),
        sample=1.33,
        **more,
    )


OIL = oil()
OIL_60X = lm.Objective(
    NA=1.3,
    magnification=60,
    immersion=1.515,
    working_distance=0.2e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.33,
)
