"""Zernike and Seidel coefficients become wavefronts and come back, in every order, unit and normalisation."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lommel import Wavefront
from lommel.special import zernike

ORDERS = st.sampled_from(zernike.ORDERS)
UNITS = st.sampled_from(["radians", "waves", "metres"])
NORMALIZATIONS = st.sampled_from(["rms", "edge"])
# All that Fringe has too.
TERMS = [zernike.term(j, "fringe") for j in range(2, 38)]
number = st.floats(-10, 10).filter(lambda c: c == 0 or abs(c) > 1e-3)
coefficients = st.dictionaries(st.sampled_from(TERMS), number, min_size=1, max_size=8)
unit_field = st.tuples(st.floats(-1.5, 1.5), st.floats(-1.5, 1.5))
THETA = np.linspace(-3.0, 3.1, 13)
RHO = np.linspace(0.0, 1.0, 13)


@given(coefficients, ORDERS, UNITS, NORMALIZATIONS)
def test_zernike_coefficients_come_back_in_every_order_unit_and_normalization(terms, order, unit, normalization):
    size = 1e-7 if unit == "metres" else 1.0
    given_terms = {zernike.index_of(n, m, order): size * c for (n, m), c in terms.items()}
    options = {"order": order, "unit": unit, "normalization": normalization, "wavelength": 633e-9}
    back = Wavefront.zernike(given_terms, **options).to_zernike(**options)
    # Radial terms up to n = 12 pass through powers of rho, up to 924 times as large.
    atol = 1e-11 * size * max(map(abs, terms.values()))
    for index in given_terms.keys() | back.keys():
        assert float(back.get(index, 0.0)) == pytest.approx(given_terms.get(index, 0.0), rel=0, abs=atol)


@given(coefficients, NORMALIZATIONS)
def test_the_phase_is_the_sum_of_the_terms_but_for_a_constant(terms, normalization):
    phase = Wavefront.zernike(terms, normalization=normalization).phase(RHO, THETA)
    expected = np.zeros(RHO.size)
    for (n, m), c in terms.items():
        factor = zernike.rms_factor(n, m) if normalization == "rms" else 1.0
        expected += c * factor * zernike.polynomial(n, m, RHO, THETA)
    np.testing.assert_allclose(phase - phase[0], expected - expected[0], atol=1e-9)


def test_metres_are_spelt_in_both_ways():
    metres, meters = (Wavefront.zernike({(2, 0): 5e-8}, unit=u, wavelength=5e-7) for u in ("metres", "meters"))
    assert metres == meters


def test_a_radial_coefficient_of_the_highest_order_comes_back_to_1e_8():
    rng = np.random.default_rng(1)
    terms = {(n, 0): rng.normal() for n in range(2, 21, 2)}
    back = Wavefront.zernike(terms).to_zernike()
    assert max(abs(back[t] - c) for t, c in terms.items()) < 1e-8
    terms = {(n, 0): c for (n, _), c in terms.items() if n <= 10}
    back = Wavefront.zernike(terms).to_zernike()
    assert max(abs(back[t] - c) for t, c in terms.items()) < 1e-12


@given(unit_field, st.tuples(*[number] * 6))
def test_seidel_coefficients_are_the_polynomial_in_rho_field_and_angle(field, waves):
    names = ("W020", "W040", "W131", "W222", "W220", "W311")
    w = dict(zip(names, waves, strict=True))
    found = Wavefront.from_seidel(**w, field=field).phase(RHO, THETA) / (2 * math.pi)
    h, phi = math.hypot(*field), THETA - math.atan2(field[1], field[0])
    expected = (
        w["W020"] * RHO**2
        + w["W040"] * RHO**4
        + w["W131"] * h * RHO**3 * np.cos(phi)
        + w["W222"] * h**2 * RHO**2 * np.cos(phi) ** 2
        + w["W220"] * h**2 * RHO**2
        + w["W311"] * h**3 * RHO * np.cos(phi)
    )
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * (1 + sum(map(abs, waves))) * (1 + h) ** 3)


def test_coefficients_describe_stacks_that_broadcast():
    stack = Wavefront.zernike({4: np.arange(3.0)[:, None], 7: np.arange(2.0), 11: 1.0}, order="noll")
    assert stack.shape == (3, 2)
    back = stack.to_zernike(order="noll")
    assert {c.shape for c in back.values()} == {(3, 2)}
    np.testing.assert_allclose(back[4], np.broadcast_to(np.arange(3.0)[:, None], (3, 2)), atol=1e-15)
    assert Wavefront.from_seidel(W131=1.0, field=(np.linspace(0, 1, 5), 0.0)).shape == (5,)


@pytest.mark.parametrize(
    "stack",
    [
        Wavefront.zernike({(0, 0): np.ones(3)}),
        Wavefront.zernike({(3, 1): np.zeros(3)}),
        Wavefront.from_seidel(W131=np.zeros(3)),
        Wavefront.from_seidel(W060=np.zeros(3)),
        Wavefront.from_seidel(W131=1.0, field=(np.zeros(3), 0.0)),
    ],
    ids=["piston", "zernike", "W131", "W060", "field"],
)
def test_a_stack_keeps_its_axes_where_its_coefficients_are_zero(stack):
    assert stack.shape == (3,)


def test_piston_is_left_out():
    assert Wavefront.zernike({1: 5.0, 4: 1.0}, order="noll") == Wavefront.zernike({4: 1.0}, order="noll")
    assert Wavefront.zernike({}) == Wavefront()


def test_metres_are_waves_at_the_wavelength():
    two = Wavefront.zernike({(3, 1): 0.1}, unit="waves")
    for unit, value in (("metres", 50e-9), ("nm", 50.0), ("um", 0.05)):
        one = Wavefront.zernike({(3, 1): value}, unit=unit, wavelength=500e-9)
        assert float(one.nonradial[3, 1]) == pytest.approx(float(two.nonradial[3, 1]), rel=1e-14)
        assert one.to_zernike(unit=unit, wavelength=500e-9)[3, 1] == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"terms": {7: 1.0}}, r'a pair \(n, m\), got 7; for terms by number use order="noll", "ansi" or "fringe"$'),
        ({"terms": [(4, 1.0), (4, 2.0)], "order": "noll"}, r"term 4, \(n, m\) = \(2, 0\), occurs twice"),
        ({"terms": [([3, 1], 1.0), ((3, 1), 2.0)]}, r"\(n, m\) = \(3, 1\), occurs twice"),
        ({"terms": {(3, 1): [1.0, 2.0], (2, 0): [1.0, 2.0, 3.0]}}, r"must broadcast, got .*\(2, 0\): \(3,\)"),
    ],
)  # fmt: skip
def test_bad_zernike_terms_are_named(options, message):
    with pytest.raises((ValueError, TypeError), match=message):
        Wavefront.zernike(**options)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"unit": "metres"}, 'unit="metres" needs the wavelength'),
        ({"unit": "metres", "wavelength": 550}, "for 550 nm give 550e-9"),
    ],
)
def test_a_bad_unit_or_normalization_is_refused_both_ways(options, message):
    with pytest.raises(ValueError, match=message):
        Wavefront.zernike({(3, 1): 1.0}, **options)
    with pytest.raises(ValueError, match=message):
        Wavefront(1.0).to_zernike(**options)


def test_a_term_without_an_index_in_an_order_is_named():
    with pytest.raises(ValueError, match=r'"fringe" ends with 37 terms and has no \(n, m\) = \(7, 7\)'):
        Wavefront(nonradial={(7, 7): 1.0}).to_zernike(order="fringe", normalization="edge")


@pytest.mark.parametrize(
    ("name", "here"), [("osa", "OSA's is 'ansi'"), ("standard", "Standard is 'noll'"), ("x", "'x'")]
)
def test_an_order_by_another_name_is_told_the_name_it_has_here(name, here):
    with pytest.raises(ValueError, match=f"order must be one of 'nm', .*, got '{name}'.*") as caught:
        Wavefront.zernike({4: 0.1}, order=name)
    assert str(caught.value).endswith(here)


def test_fringe_terms_need_a_normalization():
    with pytest.raises(ValueError, match='normalization must be given for the order "fringe": "edge"'):
        Wavefront.zernike({4: 0.1}, order="fringe")
    with pytest.raises(ValueError, match='normalization must be given for the order "fringe": "edge"'):
        Wavefront(1.0).to_zernike(order="fringe")
