"""What excitation and depletion are relative to, the light in the plane of the emitter: by plain quadrature."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.special import jv

import lommel as lm
from lommel.methods.layers.scanning import crest

OIL = lm.Objective(
    NA=1.4,
    magnification=60,
    immersion=1.518,
    working_distance=0.19e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.33,
)
WAVELENGTH = 775e-9
Complex = NDArray[np.complex128]


def angles(objective: lm.Objective) -> tuple[NDArray[np.float64], NDArray[np.float64], list[Complex]]:
    """Nodes in rho that crowd at the critical angle, weights with rho, and the amplitudes of K0, K1 and K2."""
    x, w = np.polynomial.legendre.leggauss(800)
    s, w = 0.5 * (x + 1.0), 0.5 * w
    critical = min(1.0, objective.sample / objective.NA)
    below, above = critical * (1.0 - (1.0 - s) ** 2), critical + (1.0 - critical) * s**2
    rho = np.append(below, above)
    weight = rho * np.append(2.0 * critical * (1.0 - s) * w, 2.0 * (1.0 - critical) * s * w)
    t_s, t_p = objective.transmission(rho, wavelength=WAVELENGTH)
    sample = np.sqrt((1.0 - (objective.NA * rho / objective.sample) ** 2).astype(complex))
    a = (1.0 - (objective.NA * rho / objective.immersion) ** 2) ** -0.25
    return (
        rho,
        weight,
        [a * (t_s + t_p * sample), a * t_p * objective.NA * rho / objective.sample, a * (t_s - t_p * sample)],
    )


def total(parts: list[Complex], weight: NDArray[np.float64], fading: NDArray[np.float64]) -> float:
    """``(k NA)^2 / (4 pi) int I d^2r`` over a plane, by Parseval."""
    each = [np.abs(part) ** 2 * fading**2 for part in parts]
    return float(0.5 * weight @ (each[0] + 2.0 * each[1] + each[2]))


@pytest.mark.parametrize("depth", [0.3e-6, 3e-6])
def test_two_photons_are_excited_by_light_over_that_in_the_plane_of_the_emitter(depth):
    pupil = OIL.pupil(depth=depth, wavelength=WAVELENGTH, emitter=lm.Beam("circular"))
    found = lm.microscopy.two_photon(pupil, (1, 9), 6e-6)
    field = OIL.fields(np.abs(found.grid.x) / 60, depth=depth, focus=float(pupil.focus), wavelength=WAVELENGTH)
    light = np.abs(field.K0) ** 2 + 2.0 * np.abs(field.K1) ** 2 + np.abs(field.K2) ** 2
    rho, weight, parts = angles(OIL)
    psi = OIL.phase(rho, depth=depth, focus=float(pupil.focus), wavelength=WAVELENGTH)
    held = total(parts, weight, np.exp(-psi.imag))
    assert found.values[0] == pytest.approx((light / held) ** 2, abs=2e-6 * float(found.values.max()))
    # Far from the glass less light is in the plane, by what is collected of such light: one power of the laser.
    far = total([part * (rho < OIL.sample / OIL.NA) for part in parts], weight, np.ones(rho.shape))
    assert float(pupil.collected) == pytest.approx(held / far, rel=1e-6)
    if depth < 1e-6:
        assert float(pupil.collected) > 1.05


def test_the_crest_is_that_of_a_doughnut_whose_waves_have_lost_their_phase():
    pupil = OIL.pupil(depth=2e-6, wavelength=WAVELENGTH, emitter=lm.Beam("vortex"))
    rho, weight, parts = angles(OIL)
    psi = OIL.phase(rho, depth=2e-6, focus=float(pupil.focus), wavelength=WAVELENGTH)
    fading = np.exp(-psi.imag)
    v = np.linspace(1.0, 3.0, 401)
    K = [(weight * part * fading) @ jv(n + 1, np.outer(rho, v)) for n, part in enumerate(parts)]
    light = np.abs(K[0]) ** 2 + 2.0 * np.abs(K[1]) ** 2 + np.abs(K[2]) ** 2
    assert crest(pupil) == pytest.approx(float(light.max()) / total(parts, weight, fading), rel=1e-5)
