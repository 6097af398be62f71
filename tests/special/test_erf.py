"""Error functions and Fresnel integrals."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from numpy.typing import NDArray

from lommel import _core
from lommel.paper import AbramowitzErf, FresnelErf, TableErf
from lommel.special.erf import HALF, Erf, fresnel_auxiliary


def on_ray(erf: Erf, s: NDArray[np.float64]) -> NDArray[np.complex128]:
    """Return ``erf(e^{-i pi/4} s)`` as the closed form has it, by an integral up to s, at least 0.32."""
    zeros = np.zeros(s.shape)
    return np.asarray(_core.chirp_moments(1.0, zeros, zeros, s, *erf.compiled)[0] / HALF)


@pytest.mark.parametrize("s", [0.32, 0.5, 1.0, 1.7, 3.3, 10.0, 47.0, 300.0])
def test_the_fresnel_form_is_the_error_function(s: float) -> None:
    with mp.workdps(40):
        exact = complex(mp.erf(mp.expj(-mp.pi / 4) * mp.mpf(s)))
    assert abs(on_ray(FresnelErf(), np.array([s]))[0] - exact) <= 1e-13


@pytest.mark.parametrize("samples", [16, 64, 256, 1024, 4096, 65536])
def test_the_error_of_the_table_falls_with_the_square_of_its_length(samples: int) -> None:
    s = np.concatenate([np.linspace(0.32, 20.0, 4001), np.geomspace(20.0, 1e4, 500)])
    error = np.abs(on_ray(TableErf(samples), s) - on_ray(FresnelErf(), s)).max()
    assert 0.3 <= error * (samples - 1) ** 2 <= 0.6


@pytest.mark.parametrize("terms", [10, 20, 30, 40])
def test_on_the_ray_the_series_is_exact_inside_its_strip_and_goes_over_to_a_step_outside(terms: int) -> None:
    """That step is where the paper's outer rings come from."""
    erf = AbramowitzErf(terms)
    s = np.linspace(0.32, math.sqrt(2) * (terms / 2 - 3), 401)
    assert np.abs(on_ray(erf, s) - on_ray(FresnelErf(), s)).max() <= 2e-7
    s = np.linspace(0.32, math.sqrt(2) * max(0.3, terms / 2 - 6), 401)
    assert np.abs(on_ray(erf, s) - on_ray(FresnelErf(), s)).max() <= 1e-13 + 1e-19 * 10 ** (22 - terms / 5)
    s = np.linspace(math.sqrt(2) * (terms / 2 + 8), 1000.0, 401)
    assert np.abs(on_ray(erf, s) - 1).max() <= 1e-12
    assert np.all(np.abs(on_ray(FresnelErf(), s) - 1) >= 0.5 / s)


def _exact(s: float) -> complex:
    """Return G(s) from Fresnel's own integrals, with digits to spare for their cancellation."""
    with mp.workdps(60):
        x = mp.mpf(s) * mp.sqrt(2 / mp.pi)
        half = mp.mpc(0.5, 0.5)
        rest = mp.sqrt(mp.pi / 2) * (half - mp.fresnelc(x) - 1j * mp.fresnels(x))
        return complex(mp.expj(-(mp.mpf(s) ** 2)) * rest)


@pytest.mark.parametrize("s", [1e-300, 1e-6, 0.1, 0.5, 1.0, 1.3, 2.0, 4.0, 7.5, 20.0, 100.0, 3e3])
def test_it_agrees_with_the_fresnel_integrals(s: float) -> None:
    exact = _exact(s)
    assert abs(complex(fresnel_auxiliary(s)) - exact) <= 1e-13 * abs(exact)
