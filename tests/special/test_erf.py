"""Error functions and Fresnel integrals."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

from lommel.paper import AbramowitzErf, FresnelErf, TableErf
from lommel.special.erf import HALF, Erf, fresnel_auxiliary

ALL = [FresnelErf(), TableErf(), TableErf(64), AbramowitzErf(), AbramowitzErf(40)]


def _erf(z: complex) -> complex:
    with mp.workdps(40):
        return complex(mp.erf(mp.mpc(z)))


def _on_ray(s: float) -> complex:
    with mp.workdps(40):
        return complex(mp.erf(mp.expj(-mp.pi / 4) * mp.mpf(s)))


@pytest.mark.parametrize("s", [0.0, 1e-300, 1e-9, 0.01, 0.5, 1.0, 1.7, 3.3, 10.0, 47.0, 300.0])
def test_the_fresnel_form_is_the_error_function(s: float) -> None:
    assert abs(complex(FresnelErf().on_ray(s)) - _on_ray(s)) <= 1e-13
    assert abs(complex(FresnelErf().on_ray(-s)) + _on_ray(s)) <= 1e-13


@pytest.mark.parametrize("samples", [16, 64, 256, 1024, 4096, 65536])
def test_the_error_of_the_table_falls_with_the_square_of_its_length(samples: int) -> None:
    s = np.concatenate([np.linspace(0.0, 20.0, 4001), np.geomspace(20.0, 1e4, 500)])
    error = np.abs(TableErf(samples).on_ray(s) - FresnelErf().on_ray(s)).max()
    assert 0.5 <= error * (samples - 1) ** 2 <= 0.6


@pytest.mark.parametrize("terms", [10, 20, 30, 60])
@pytest.mark.parametrize("x", [0.0, 1e-8, 0.3, 1.0, 2.5, 5.0, -0.7, -3.0])
def test_the_series_is_the_complex_error_function_up_to_the_terms_left_out(x: float, terms: int) -> None:
    """Term n is at most ``exp(y^2 - x^2 - (n/2 - |y|)^2) / (pi n)``: it peaks at n = 2 |y|."""
    for y in np.linspace(3 - terms / 2, terms / 2 - 3, 13):
        if y * y - x * x > 700:
            continue
        left_out = (terms + 1) / 2 - abs(y)
        scale = math.exp(y * y - x * x)
        exact = _erf(complex(x, y))
        tolerance = 1.1 * scale * math.exp(-(left_out**2)) / (math.pi * (terms + 1)) + 1e-14 * (1 + scale)
        assert abs(complex(AbramowitzErf(terms)(complex(x, y))) - exact) <= tolerance


@pytest.mark.parametrize("terms", [10, 20, 30, 40])
def test_on_the_ray_the_series_is_exact_inside_its_strip_and_goes_over_to_a_step_outside(terms: int) -> None:
    """That step is where the paper's outer rings come from."""
    s = np.linspace(0.0, math.sqrt(2) * (terms / 2 - 3), 401)
    assert np.abs(AbramowitzErf(terms).on_ray(s) - FresnelErf().on_ray(s)).max() <= 2e-7
    s = np.linspace(0.0, math.sqrt(2) * max(0.0, terms / 2 - 6), 401)
    assert np.abs(AbramowitzErf(terms).on_ray(s) - FresnelErf().on_ray(s)).max() <= 1e-14 + 1e-19 * 10 ** (
        22 - terms / 5
    )
    s = np.linspace(math.sqrt(2) * (terms / 2 + 8), 1000.0, 401)
    assert np.abs(AbramowitzErf(terms).on_ray(s) - 1).max() <= 1e-12
    assert np.all(np.abs(FresnelErf().on_ray(s) - 1) >= 0.5 / s)


@pytest.mark.parametrize("x", [0.0, 1e-300, 0.3, 2.0, 30.0, -1.0])
def test_on_the_real_axis_the_series_is_the_real_error_function(x: float) -> None:
    assert complex(AbramowitzErf(10)(x)) == pytest.approx(math.erf(x), rel=1e-15, abs=0)


@pytest.mark.parametrize("y", [1e-300, 1e-10, 0.1, 3.0, 12.0, 26.0])
def test_next_to_the_imaginary_axis_nothing_is_divided_by_zero(y: float) -> None:
    erf, exact = AbramowitzErf(100), _erf(1j * y)
    for x in (0.0, 1e-320, 1e-200, 1e-140, 1e-20):
        value = complex(erf(complex(x, y)))
        assert abs(value - exact) <= 1e-13 * max(1.0, abs(exact))


@pytest.mark.parametrize("z", [27j, 30j, 1 + 28j, -1 - 28j, 400j])
def test_a_value_beyond_the_range_of_doubles_is_an_error_and_no_infinity(z: complex) -> None:
    with pytest.raises(OverflowError, match=r"Eq. \(14\) overflows doubles at z="):
        AbramowitzErf(100)(np.array([0.0, z]))


@pytest.mark.parametrize("z", [30 + 30j, 1e3 + 1e3j, 1e5 - 1e5j, 40 + 1j])
def test_a_value_within_range_is_found_though_its_factors_are_not(z: complex) -> None:
    value = complex(AbramowitzErf(200)(z))
    assert math.isfinite(value.real)
    assert abs(value - 1) <= 0.05


@pytest.mark.parametrize("erf", ALL, ids=repr)
def test_the_auxiliary_is_the_complement_without_its_oscillation(erf: Erf) -> None:
    s = np.linspace(0.0, 4.0, 81)
    expected = HALF * (1 - erf.on_ray(s)) * np.exp(-1j * s * s)
    assert erf.auxiliary(s) == pytest.approx(expected, rel=0, abs=1e-14)
    # AbramowitzErf(10) and TableErf(64) are the least exact.
    assert erf.auxiliary(s[:20]) == pytest.approx(fresnel_auxiliary(s[:20]), rel=0, abs=2e-4)


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
