"""The derivative by the obscuration: its rules against their bounds, and against quadrature over the pupil."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from disk_quadrature import exact_lattice
from lommel.methods.derivatives import obscuration_derivative
from lommel.optics.grid import Grid


def pupil(rng: np.random.Generator) -> lm.Pupil:
    nonradial = {t: float(rng.normal()) for t in ((1, 1), (2, 2), (3, -1), (3, 3), (5, 1))}
    return lm.Pupil(
        lm.Wavefront(float(rng.uniform(-6, 6)), 1.0, nonradial=nonradial),
        obscuration=float(rng.uniform(0.05, 0.9)),
        apodization=float(rng.uniform(0.0, 1.0)),
    )


def rim(of: lm.Pupil, vx: np.ndarray, vy: np.ndarray, nodes: int) -> np.ndarray:
    """Return the mean of the integrand over so many angles around the rim."""
    theta, eps = 2.0 * math.pi * (np.arange(nodes) + 0.5) / nodes, of.obscuration
    wave = np.exp(1j * of.wavefront.phase(np.full(nodes, eps), theta))
    kernel = np.multiply.outer(vx, np.cos(theta)) + np.multiply.outer(vy, np.sin(theta))
    return np.exp(-1j * eps * kernel) @ wave / nodes


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize("error", [1e-5, 1e-11])
@pytest.mark.parametrize("seed", range(3))
def test_the_derivative_is_that_of_quadrature(integrate, error, seed):
    one = pupil(np.random.default_rng(seed))
    grid = Grid((4, 5), 0.55, center=(1.3, 2.6), integrate=integrate)
    step = grid.step(one)
    rule, weight = np.polynomial.legendre.leggauss(9) if integrate else (np.zeros(1), np.array([2.0]))
    across, down = (
        step * (np.arange(side)[:, None] - c + 0.5 * rule) for side, c in ((5, grid.axis[1]), (4, grid.axis[0]))
    )
    vx, vy = (part.ravel() for part in np.meshgrid(across.ravel(), down.ravel()))
    eps = one.obscuration
    lost = -2.0 * eps * math.exp(-one.apodization * eps**2) * rim(one, vx, vy, 400)
    change = 2.0 * (np.conj(exact_lattice(one, across.ravel(), down.ravel()).ravel()) * lost).real
    weights = 0.25 * np.multiply.outer(weight, weight)
    exact = np.einsum("iajb,ab->ij", change.reshape(4, rule.size, 5, rule.size), weights)
    found, bound = obscuration_derivative(one, grid, error)
    assert np.abs(found[0] - exact).max() <= bound[0] + 1e-13
    assert bound[0] <= error
