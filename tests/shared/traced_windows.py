"""Float32 traced plans of sampled windows, as the compiled core sums them and as their framework does."""

from __future__ import annotations

from typing import Any

import numpy as np

import lommel as lm
from lommel.traced.traced_psf import TracedPSF

WHITE = lm.methods.Polychromatic([450e-9, 550e-9, 650e-9], [1.0, 2.0, 1.0])
SENSOR = {"wavelength": 550e-9, "f_number": 8.0}
# Window, options of the plan, the pupil besides its wavefront.
CASES = {
    "odd": (9, {"pixel": 0.5}, {}),
    "even and oblong": ((8, 5), {"pixel": 0.5}, {"obscuration": 0.4, "apodization": 0.7}),
    "off the axis": ((5, 6), {"pixel": 0.5, "center": (1.3, 7.0)}, {}),
    "white": (5, {"pixel": 2e-6, "method": WHITE, "integrate": False}, SENSOR),
}
TERMS = ((2, 0), (4, 0), (1, 1), (2, -2), (3, 1), (3, -3))
EDGE = np.array([[0.5, 0.2, 1.0, -0.7, 0.4, 0.3], [-1.0, -0.3, 0.2, 0.8, -0.9, 0.0], [0.0] * 6])


def pupils(c: np.ndarray, **options: Any) -> lm.Pupil:
    """Return those of coefficients of the terms."""
    return lm.Pupil(lm.Wavefront.zernike(dict(zip(TERMS, c.T, strict=True)), normalization="edge"), **options)


def traced(case: tuple[Any, ...], c: np.ndarray, xp: Any = None) -> TracedPSF:
    """Return the traced plan for coefficients."""
    shape, options, light = case
    return lm.Plan(shape, tol=2e-3, **options).traced(pupils(c, **light), xp, precision="float32")


def by_steps(f: TracedPSF) -> TracedPSF:
    """Return the traced plan without sums of the compiled core."""
    lights = tuple((weight, light._replace(sums=None)) for weight, light in f._static.lights)
    return TracedPSF(f._static._replace(lights=lights), f.tables)
