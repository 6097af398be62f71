"""The non-oscillating part of the Fresnel integral, against mpmath."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lommel.special.erf import HALF, fresnel_auxiliary


def _exact(s: float) -> complex:
    """Return G(s) from Fresnel's own integrals, with digits to spare for their cancellation."""
    with mp.workdps(60):
        x = mp.mpf(s) * mp.sqrt(2 / mp.pi)
        half = mp.mpc(0.5, 0.5)
        rest = mp.sqrt(mp.pi / 2) * (half - mp.fresnelc(x) - 1j * mp.fresnels(x))
        return complex(mp.expj(-(mp.mpf(s) ** 2)) * rest)


def test_half_of_the_whole_integral() -> None:
    assert complex(HALF) == pytest.approx(math.sqrt(math.pi / 8) * (1 + 1j), rel=1e-15)
    assert complex(fresnel_auxiliary(0.0)) == pytest.approx(complex(HALF), rel=1e-15)


@pytest.mark.parametrize("s", [1e-300, 1e-6, 0.1, 0.5, 1.0, 1.3, 2.0, 4.0, 7.5, 20.0, 100.0, 3e3])
def test_it_agrees_with_the_fresnel_integrals(s: float) -> None:
    exact = _exact(s)
    assert abs(complex(fresnel_auxiliary(s)) - exact) <= 1e-13 * abs(exact)


@given(st.floats(30, 1e12))
def test_it_falls_off_as_half_the_inverse(s: float) -> None:
    """The next term of the asymptotic series is ``1 / (4 s^3)``."""
    assert abs(complex(fresnel_auxiliary(s)) - 0.5j / s) <= 0.26 / s**3 + 1e-15 / s


@given(st.floats(0.01, 50))
def test_its_derivative_is_that_of_the_integral(s: float) -> None:
    """``G' = -2 i s G - 1``."""
    step = 1e-3 / (1 + s)
    near, far = (fresnel_auxiliary(s + k * step) - fresnel_auxiliary(s - k * step) for k in (1, 2))
    slope = (8 * near - far) / (12 * step)
    assert abs(slope - (-2j * s * fresnel_auxiliary(s) - 1)) <= 1e-9


def test_it_never_rises() -> None:
    sizes = np.abs(fresnel_auxiliary(np.linspace(0.0, 50.0, 5001)))
    assert np.all(np.diff(sizes) < 0)
