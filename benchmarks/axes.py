"""What an axis for each pupil of a stack costs beside the centred stack."""

from __future__ import annotations

import math

import numpy as np

import lommel as lm
from benchmarks.averages import average
from benchmarks.engine import through_focus
from benchmarks.settings import Settings
from benchmarks.targets import Measured
from benchmarks.timing import Contender, race
from benchmarks.truth import exact, intensity

_COUNT, _SIDE = 1000, 25
_LOOKED = np.array([0, 9, 12, 13, 20])  # pixels on the diagonal


def over_centred(settings: Settings, *, pixel: float, integrate: bool) -> Measured:
    """Measure 1000 of 25², each around its own axis, against the same stack around pixels."""
    centers = _SIDE // 2 + np.random.default_rng(1900).uniform(-0.5, 0.5, (2, _COUNT))
    fresh = through_focus(6.0, _COUNT, 1.5)

    def contender(name: str, **options: object) -> Contender:
        plan = lm.Plan(_SIDE, pixel, integrate=integrate, threads=1, **options)  # type: ignore[arg-type]
        out = np.zeros((_COUNT, _SIDE, _SIDE), np.float32)
        return Contender(name, lambda pupil: plan(pupil, out=out), fresh=fresh, values=intensity)

    result = race([contender("own", center=centers), contender("centred")], settings.rounds)
    made, pupil, worst = result.values["own"], fresh(1)[0], 0.0
    for i in range(0, _COUNT, 111):
        y, x = _LOOKED - centers[:, i, None]
        truth = (average if integrate else exact)(pupil[i], y, x, math.pi * pixel)
        worst = max(worst, float(np.abs(made[i][_LOOKED, _LOOKED] - truth).max() / made[i].max()))
    note = f"abs(C_d) <= 6, C_s = 1.5, pixel {pixel:g} λN; a Plan, float32, `out=` given, one thread"
    return Measured(result.ratio("own", "centred"), worst, note)
