"""The paper's closed form: its six integrals against quadrature, its errata, and the errors the paper reports."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

import lommel as lm
from lommel import Pupil, Wavefront, _core
from lommel.measures.errors import mse
from lommel.methods import Hankel
from lommel.paper import AbramowitzErf, ClosedForm, FresnelErf, TableErf
from lommel.special.bessel import j0_series, tangent_line
from lommel.special.erf import Erf
from lommel.special.legendre import gauss_legendre
from lommel.special.piecewise import fit_quadratics

DEFOCUS = [0.0, 1e-6, 1e-3, 0.049, 0.051, 0.1, 1.0, 10.0, 50.0, -50.0, 200.0]
V = np.array([1e-8, 1e-3, 0.5, 1.0, 1.0001, 2.9, 7.9, 8.1, 20.0, 57.3, 145.0, 333.3, 569.0, 800.0])


def formed(transition: float, terms: int, segments: int = 16) -> type[ClosedForm]:
    """Return the closed form with other constants, with which it tends to the exact integral."""
    return type("Formed", (ClosedForm,), {"transition": transition, "terms": terms, "segments": segments})


def _panels(low: float, high: float, rate: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return nodes and weights of a composite rule: 20 points for every three radians of phase."""
    x, w = np.polynomial.legendre.leggauss(20)
    edges = np.linspace(low, high, 3 + int(rate * (high - low) / 3))
    half = 0.5 * np.diff(edges)[:, None]
    return (edges[:-1, None] + half * (1 + x)).ravel(), (half * w).ravel()


def _integrals(defocus: float, v: float, method: ClosedForm) -> NDArray[np.complex128]:
    """Return the integrals of Eq. (12) with the factor of Eq. (7), by quadrature of their integrands."""
    split = min(method.transition / v, 1.0)
    r, w = _panels(0.0, split, 4 * abs(defocus))
    wave = w * r * np.exp(2j * defocus * r * r)
    inner = [np.sum(wave * (-0.25 * (v * r) ** 2) ** m) / math.factorial(m) ** 2 for m in range(method.terms)]
    r, w = _panels(split, 1.0, 4 * abs(defocus) + v)
    wave = w * r * np.exp(2j * defocus * r * r) * math.sqrt(2 / math.pi) * np.cos(v * r - math.pi / 4)
    slope, offset = -0.5 * method.tangent**-1.5, 1.5 * method.tangent**-0.5
    return np.array([*inner, np.sum(wave * slope * v * r), np.sum(wave * offset), np.sum(wave / (v * r))])


def sum_of_integrals(method: ClosedForm, defocus: float, at: NDArray[np.float64]) -> NDArray[np.complex128]:
    return 2.0 * np.array([_integrals(defocus, v, method).sum() for v in at])


@pytest.mark.parametrize("defocus", DEFOCUS)
@pytest.mark.parametrize(
    "method",
    [
        *(ClosedForm(tangent=t) for t in (50, 100, 200)),
        formed(3, 10)(),
        formed(8, 28)(),
        formed(8, 10)(tangent=50),
    ],
    ids=lambda m: f"tangent={m.tangent:g},transition={m.transition:g},terms={m.terms}",
)
def test_the_field_is_the_sum_of_the_integrals_of_eq_12(method: ClosedForm, defocus: float) -> None:
    field = method.field(Pupil(Wavefront(defocus)), V)
    assert np.abs(field - sum_of_integrals(method, defocus, V)).max() <= 1e-10


@pytest.mark.parametrize("defocus", [0.0, 0.049, 10.0, -50.0])
def test_as_printed_the_outer_integrals_lack_a_factor_and_nothing_else(defocus: float) -> None:
    exact = np.stack([_integrals(defocus, v, ClosedForm()) for v in V], axis=1)
    printed = ClosedForm(variant="printed").field(Pupil(Wavefront(defocus)), V)
    expected = 2 * (exact[:3].sum(axis=0) + exact[3:].sum(axis=0) / math.sqrt(2 / math.pi))
    assert np.abs(printed - expected).max() <= 1e-10
    assert np.abs(exact[3:]).max() > 1e-3


@pytest.mark.parametrize("defocus", DEFOCUS)
def test_on_the_axis_nothing_is_approximated(defocus: float) -> None:
    pupil = Pupil(Wavefront(defocus))
    assert abs(ClosedForm().field(pupil, 0.0) - Hankel().field(pupil, 0.0)) <= 1e-13


@pytest.mark.parametrize("defocus", DEFOCUS)
def test_a_long_power_series_is_exact_up_to_the_transition(defocus: float) -> None:
    pupil, v = Pupil(Wavefront(defocus)), np.linspace(0.0, 8.0, 33)
    difference = formed(8, 28)().field(pupil, v) - Hankel().field(pupil, v)
    assert np.abs(difference).max() <= 1e-12


def test_a_series_too_long_for_the_powers_of_a_double_stays_finite() -> None:
    method, pupil = formed(20, 60)(), Pupil(Wavefront(5.0))
    assert np.all(np.isfinite(method.field(pupil, np.array([800.0, 1200.0, 5000.0]))))


@given(st.floats(-100, 100), st.floats(0.05, 0.95), st.floats(0, 500, allow_subnormal=False))
def test_an_obscured_aperture_is_the_difference_of_two(defocus: float, obscuration: float, v: float) -> None:
    area = obscuration**2
    whole = ClosedForm().field(Pupil(Wavefront(defocus)), v)
    hole = ClosedForm().field(Pupil(Wavefront(defocus * area)), obscuration * v)
    field = ClosedForm().field(Pupil(Wavefront(defocus), obscuration=obscuration), v)
    assert abs(field - (whole - area * hole)) <= 1e-13


FORMS = [
    ClosedForm(),
    formed(8, 28, 5)(tangent=40),
]


@pytest.mark.parametrize("wavefront", [Wavefront(10.0), Wavefront(-30.0, 60.0), Wavefront(200.0, 10.0)])
@pytest.mark.parametrize("method", FORMS, ids=["paper", "tuned"])
def test_many_radii_are_interpolated_to_rounding(method: ClosedForm, wavefront: Wavefront) -> None:
    """By polynomials of values at fewer; the closed form itself serves where few are asked for."""
    pupil, v = Pupil(wavefront), np.linspace(0.0, 400.0, 5001)
    many = method.field(pupil, v)
    few = np.concatenate([method.field(pupil, part) for part in np.array_split(v, 200)])
    assert 0.0 < np.abs(many - few).max() <= 3e-15


@pytest.mark.parametrize("erf", [FresnelErf(), TableErf(64), AbramowitzErf(30)], ids=lambda e: type(e).__name__)
def test_a_stack_is_its_members_with_any_instructions_and_threads(erf: Erf) -> None:
    """Among them some of defocus alone, of one piece."""
    method, v = ClosedForm(erf=erf), np.linspace(0.0, 60.0, 700)
    defocus, spherical = [0.0, 0.01, 10.0, -20.0, 3.0], [0.0, 0.0, 0.0, 5.0, -30.0]
    stack = Pupil(Wavefront(defocus, spherical), obscuration=0.2)
    values = method.profile(stack, v).values
    assert np.array_equal(method._threaded_profile(stack, v, threads=2).values, values)
    members = np.stack([method.profile(stack[i], v).values[0] for i in range(5)])
    assert np.abs(values - members).max() <= 1e-13
    try:
        for level in ("portable", "avx2"):
            _core.limit_instructions(level)
            assert np.abs(method.profile(stack, v).values - values).max() <= 1e-13
    finally:
        _core.limit_instructions("avx512")


@pytest.mark.parametrize(("terms", "reported"), [(10, 2.7e-3), (20, 1.9e-3), (30, 1.0e-3), (40, 8.8e-4)])
def test_as_printed_it_makes_the_mean_squared_errors_of_the_paper(terms: int, reported: float) -> None:
    """C_d = 10, tangent at 100, a window of v = 145, 512 x 512; the paper has 0.0009 at N = 30."""
    pupil, pixel = Pupil(Wavefront(10.0)), 145 / (256 * math.pi)
    method = ClosedForm(tangent=100, erf=AbramowitzErf(terms), variant="printed")
    answer = lm.psf(pupil, 512, pixel, method=method, normalize="strehl", dtype=np.float64)
    exact = lm.psf(pupil, 512, pixel, method=Hankel(), normalize="strehl")
    assert mse(answer, exact) == pytest.approx(reported, rel=0.02)


@pytest.mark.parametrize(("tangent", "reported"), [(100, 0.0138), (200, 0.0020)])
def test_as_printed_the_error_falls_with_the_tangent_as_in_the_paper(tangent: float, reported: float) -> None:
    """C_d = 23, a window of v = 140; the paper has 0.0196 and 0.00199."""
    pupil, pixel = Pupil(Wavefront(23.0)), 140 / (256 * math.pi)
    method = ClosedForm(tangent=tangent, variant="printed")
    answer = lm.psf(pupil, 512, pixel, method=method, normalize="strehl", dtype=np.float64)
    exact = lm.psf(pupil, 512, pixel, method=Hankel(), normalize="strehl")
    assert mse(answer, exact) == pytest.approx(reported, rel=0.03)


@pytest.mark.parametrize("wavefront", [Wavefront(0.0, 10.0), Wavefront(-20.0, 20.0), Wavefront(50.0, -100.0)])
def test_piecewise_phases_are_integrated_exactly(wavefront: Wavefront) -> None:
    """Against quadrature of the surrogate of J0 with the same pieces, inflection points included."""
    method = formed(2, 6, 7)(tangent=60.0)
    c = wavefront.coefficients
    pieces = fit_quadratics(c.tolist(), 7)
    v = np.array([0.0, 0.3, 1.9999, 2.5, 17.0, 90.0, 250.0])
    a, b = tangent_line(60.0)
    for at, value in zip(v, method.field(Pupil(wavefront), v), strict=True):
        transition = min(1.0, 2.0 / at) if at else 1.0
        breaks = np.unique(np.concatenate([pieces.edges, [transition]]))
        total = 0.0j
        for low, high in itertools.pairwise(breaks):
            x, w = gauss_legendre(260, low, high)
            phase = pieces.phase(x)
            if high <= transition:
                kernel = j0_series(at * x, 6)
            else:
                amplitude = a * at * x + b + 1.0 / (at * x)
                kernel = math.sqrt(2 / math.pi) * amplitude * np.cos(at * x - math.pi / 4)
            total += 2 * np.sum(w * x * kernel * np.exp(1j * phase))
        assert abs(value - total) <= 1e-10
