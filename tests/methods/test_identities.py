"""What mathematics says about the field of any pupil, asked of every exact method."""

from __future__ import annotations

import math
from collections.abc import Callable

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import special

from lommel import Pupil, Wavefront
from lommel.methods import Hankel, NijboerZernike, RadialMethod
from lommel.paper import LommelSeries

GENERAL = [pytest.param(Hankel(), id="hankel"), pytest.param(NijboerZernike(tol=1e-12), id="nijboer-zernike")]
EXACT = [*GENERAL, pytest.param(LommelSeries(), id="lommel-series")]

V = np.concatenate([np.linspace(0.0, 12.0, 49), np.linspace(15.0, 300.0, 39)])

amounts = st.floats(-60, 60)
obscurations = st.one_of(st.just(0.0), st.floats(0.01, 0.95))


def _slope(function: Callable[[float], np.ndarray], x: float, step: float) -> np.ndarray:
    """Return the derivative at x by central differences, wrong by ``step^4 / 30`` times the fifth derivative."""
    near = function(x + step) - function(x - step)
    far = function(x + 2 * step) - function(x - 2 * step)
    return (8 * near - far) / (12 * step)


@pytest.mark.parametrize("obscuration", [0.0, 0.1, 0.33, 0.9])
@pytest.mark.parametrize("method", EXACT)
def test_without_aberration_the_field_is_the_airy_pattern(method: RadialMethod, obscuration: float) -> None:
    v = V[1:]
    airy = 2 * special.j1(v) / v
    if obscuration:
        airy -= obscuration**2 * 2 * special.j1(obscuration * v) / (obscuration * v)
    field = method.field(Pupil(obscuration=obscuration), v)
    assert np.abs(field - airy).max() <= 5e-15
    assert np.all(np.abs(field.imag) <= 1e-16)


@pytest.mark.parametrize("obscuration", [0.0, 0.5])
@pytest.mark.parametrize("defocus", [1e-12, 1e-3, 0.7, math.pi, -math.pi, 10.0, -77.7, 200.0])
@pytest.mark.parametrize("method", EXACT)
def test_on_axis_a_defocused_field_is_a_sinc_turned_by_its_mean_phase(
    method: RadialMethod, defocus: float, obscuration: float
) -> None:
    area = 1 - obscuration**2
    expected = np.exp(1j * defocus * (1 + obscuration**2)) * math.sin(defocus * area) / defocus
    field = method.field(Pupil(Wavefront(defocus), obscuration=obscuration), 0.0)
    assert abs(field - expected) <= 1e-14
    if not obscuration:
        assert abs(abs(field) - abs(math.sin(defocus) / defocus)) <= 1e-14


@pytest.mark.parametrize(
    ("defocus", "spherical"),
    [(0.0, 3.0), (5.0, 3.0), (-5.0, 3.0), (-20.0, 40.0), (30.0, -200.0), (-200.0, 200.0), (200.0, -7.0), (0.3, 0.01)],
)
@pytest.mark.parametrize("method", GENERAL)
def test_on_axis_spherical_aberration_is_a_pair_of_fresnel_integrals(
    method: RadialMethod, defocus: float, spherical: float
) -> None:
    with mp.workdps(40):
        size = mp.mpf(abs(spherical))
        ratio = mp.mpf(defocus) / mp.mpf(spherical)

        def integral(t: float) -> mp.mpc:
            s = mp.sqrt(2 * size / mp.pi) * (t + ratio)
            return mp.sqrt(mp.pi / 2) * (mp.fresnelc(s) + 1j * mp.fresnels(s))

        whole = (integral(1) - integral(0)) / mp.sqrt(size)
        if spherical < 0:
            whole = mp.conj(whole)
        expected = complex(mp.expj(-mp.mpf(defocus) * ratio) * whole)
    assert abs(method.field(Pupil(Wavefront(defocus, spherical)), 0.0) - expected) <= 1e-13


@pytest.mark.parametrize("obscuration", [0.0, 0.33, 0.9])
@pytest.mark.parametrize("wavefront", [Wavefront(), Wavefront(25.0), Wavefront(-25.0, 15.0), Wavefront(3, -2, [4.0])])
@pytest.mark.parametrize("method", GENERAL)
def test_all_the_light_of_the_aperture_arrives(
    method: RadialMethod, wavefront: Wavefront, obscuration: float
) -> None:
    pupil = Pupil(wavefront, obscuration=obscuration)
    reach = 2000.0
    # I v is of exponential type 2: 20 nodes for every 5 of v.
    x, w = np.polynomial.legendre.leggauss(20)
    v = (np.arange(0.0, reach, 5.0)[:, None] + 2.5 * (1 + x)).ravel()
    within = np.sum(np.tile(2.5 * w, v.size // 20) * v * np.abs(method.field(pupil, v)) ** 2)
    # Beyond, only the two edges send light, each with the slope of the phase there (method of stationary phase).
    orders = np.arange(1, 1 + pupil.coefficients().shape[1])
    beyond = 0.0
    for edge in (1.0, obscuration):
        slope = 2 * edge * np.sum(orders * pupil.coefficients()[0] * edge ** (2.0 * (orders - 1)))
        beyond += 4 / math.pi * edge * reach / (reach**2 - slope**2)
    # What is left oscillates: like cos(2 v) from each edge, like cos((1 - eps) v) where both interfere.
    left = 2 + 8 * math.sqrt(obscuration) / (math.pi * (1 - obscuration))
    assert within + beyond == pytest.approx(2 * pupil.area, abs=left / reach**2, rel=0)


@given(amounts, amounts, st.floats(1, 100))
@pytest.mark.parametrize("method", GENERAL)
def test_the_edge_identity_holds_by_central_differences(
    method: RadialMethod, defocus: float, spherical: float, v: float
) -> None:
    """``2 U + v U_v + 2 C_d U_Cd + 4 C_s U_Cs`` is the wave from the rim, ``2 exp(i (2 C_d + C_s)) J0(v)``."""
    field = method.field(Pupil(Wavefront(defocus, spherical)), v)
    by_v = _slope(lambda x: method.field(Pupil(Wavefront(defocus, spherical)), x), v, 2e-3)
    by_defocus = _slope(lambda x: method.field(Pupil(Wavefront(x, spherical)), v), defocus, 2e-3)
    by_spherical = _slope(lambda x: method.field(Pupil(Wavefront(defocus, x)), v), spherical, 2e-3)
    left = 2 * field + v * by_v + 2 * defocus * by_defocus + 4 * spherical * by_spherical
    # Derivatives by C_d grow like 2^n, the others do not grow: 2e-11 times 2 C_d, and rounding over the step.
    assert abs(left - 2 * np.exp(1j * (2 * defocus + spherical)) * special.j0(v)) <= 5e-9


@given(amounts, amounts, amounts, obscurations, st.floats(0, 100, allow_subnormal=False))
@pytest.mark.parametrize("method", GENERAL)
def test_widening_the_aperture_adds_the_wave_from_its_rim(
    method: RadialMethod, defocus: float, spherical: float, sixth: float, obscuration: float, v: float
) -> None:
    def widened(a: float) -> np.ndarray:
        wavefront = Wavefront(defocus * a**2, spherical * a**4, [sixth * a**6])
        # The hole keeps its size.
        return a**2 * method.field(Pupil(wavefront, obscuration=obscuration / a), a * v)

    rim = 2 * np.exp(1j * (2 * defocus + spherical + sixth)) * special.j0(v)
    rate = 4 * abs(defocus) + 4 * abs(spherical) + 6 * abs(sixth) + v + 8
    assert abs(_slope(widened, 1.0, 5e-3 / rate) - rim) <= 2e-9


@given(amounts, amounts, amounts, obscurations, st.floats(0, 300, allow_subnormal=False))
@pytest.mark.parametrize("method", GENERAL)
def test_the_opposite_wavefront_makes_the_conjugate_field(
    method: RadialMethod, defocus: float, spherical: float, sixth: float, obscuration: float, v: float
) -> None:
    wavefront = Wavefront(defocus, spherical, [sixth])
    one, other = (method.field(Pupil(w, obscuration=obscuration), v) for w in (wavefront, -wavefront))
    assert abs(one - np.conj(other)) <= 1e-14


@given(amounts, amounts, amounts, st.floats(0.01, 0.95), st.floats(0, 300, allow_subnormal=False))
@pytest.mark.parametrize("other", GENERAL)
@pytest.mark.parametrize("method", GENERAL)
def test_an_annulus_and_the_disk_inside_make_the_whole_disk(
    method: RadialMethod,
    other: RadialMethod,
    defocus: float,
    spherical: float,
    sixth: float,
    obscuration: float,
    v: float,
) -> None:
    annulus = method.field(Pupil(Wavefront(defocus, spherical, [sixth]), obscuration=obscuration), v)
    area = obscuration**2
    inner = other.field(Pupil(Wavefront(defocus * area, spherical * area**2, [sixth * area**3])), obscuration * v)
    whole = other.field(Pupil(Wavefront(defocus, spherical, [sixth])), v)
    assert abs(annulus + area * inner - whole) <= 2e-14
