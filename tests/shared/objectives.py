"""Objectives that most tests of microscopes ask about, a wavefront of five terms, and emitters."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm


def oil(**more: Any) -> lm.Objective:
    """Return one in oil before a sample in water, with what else it has or has in place of that."""
    usual = {"NA": 1.4, "magnification": 63, "immersion": 1.518, "working_distance": 0.19e-3, "sample": 1.33}
    return lm.Objective(**usual | {"coverslip": lm.Layer(1.5255, 170e-6)} | more)


def phase(
    objective: lm.Objective, rho: NDArray[np.float64], *, depth: float, focus: float, wavelength: float
) -> NDArray[np.complex128]:
    """Return the phase of plane waves from an emitter, without that of films."""
    layers = objective._layers(wavelength)
    constant, by_depth, by_focus = layers.rates(layers.cosine(rho))
    return np.asarray(constant + depth * by_depth + focus * by_focus)


def transmission(
    objective: lm.Objective, rho: NDArray[np.float64], wavelength: float
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Return the amplitudes of s and p waves in the sample."""
    layers = objective._layers(wavelength)
    found = layers.amplitudes(layers.cosine(rho), ((objective.NA * rho) ** 2).astype(np.complex128))
    return found.s, found.p


OIL = oil()
TIRF = dataclasses.replace(OIL, NA=1.45)
# Of the index of the oil is the cover glass.
MATCHED = oil(immersion=1.515, coverslip=lm.Layer(1.515, 170e-6))
OIL_FILE = """name = "mine"
[objective]
NA = 1.4
magnification = 63
working_distance = "0.19 mm"
immersion = 1.518
[coverslip]
index = 1.5255
thickness = "170 um"
[sample]
index = 1.33
depth = "2 um"
[emission]
wavelength = "600 nm"
[sensor]
pixel = "6.5 um"
"""
OIL_60X = oil(NA=1.3, magnification=60, immersion=1.515, working_distance=0.2e-3)
WATER_60X = oil(NA=1.2, magnification=60, immersion=1.333, working_distance=0.28e-3, sample=1.36)
WATER_40X = lm.Objective(
    NA=1.1, magnification=40, immersion=1.333, working_distance=0.3e-3, coverslip=lm.Layer(1.5255, 17e-5), sample=1.38
)
FIVE = lm.Wavefront.zernike({5: 0.1, 6: -0.05, 7: 0.1, 9: 0.08, 11: 0.1}, unit="waves", order="noll")
EMITTERS = [
    "isotropic",
    lm.Dipole(0.7, 0.4),
    lm.Dipole(1.2, -2.0, wobble=0.3),
    lm.Scalar("aplanatic"),
    lm.Beam(),
    lm.Beam((0.3, 0.8 - 0.2j)),
    lm.Beam("radial"),
    lm.Beam("azimuthal"),
    lm.Beam("vortex"),
]
