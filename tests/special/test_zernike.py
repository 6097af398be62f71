"""The circle polynomials and their orders."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from scipy.special import eval_legendre

from lommel.special import zernike

# R. J. Noll, J. Opt. Soc. Am. 66, 207 (1976), Table I.
NOLL = [(0, 0), (1, 1), (1, -1), (2, 0), (2, -2), (2, 2), (3, -1), (3, 1), (3, -3), (3, 3), (4, 0), (4, 2), (4, -2)]
# ANSI Z80.28, Table 1.
ANSI = [(0, 0), (1, -1), (1, 1), (2, -2), (2, 0), (2, 2), (3, -3), (3, -1), (3, 1), (3, 3), (4, -4), (4, -2), (4, 0)]
# University of Arizona.
FRINGE = [(0, 0), (1, 1), (1, -1), (2, 0), (2, 2), (2, -2), (3, 1), (3, -1), (4, 0), (3, 3), (3, -3), (4, 2), (4, -2)]


def test_the_first_terms_are_those_of_the_published_tables():
    assert [zernike.term(j, "noll") for j in range(1, 14)] == NOLL
    assert [zernike.term(j, "ansi") for j in range(13)] == ANSI
    assert [zernike.term(j, "fringe") for j in range(1, 14)] == FRINGE
    assert zernike.term(37, "fringe") == (12, 0)


@pytest.mark.parametrize(("order", "first", "last"), [("noll", 1, 1891), ("ansi", 0, 1890), ("fringe", 1, 37)])
def test_every_index_leads_to_a_term_and_back(order, first, last):
    terms = [zernike.term(j, order) for j in range(first, last + 1)]
    assert len(set(terms)) == len(terms)
    assert [zernike.index_of(n, m, order) for n, m in terms] == list(range(first, last + 1))


@pytest.mark.parametrize("m", [0, 1, 2, 7, 20])
def test_radial_polynomials_are_orthogonal_and_one_at_the_edge(m):
    x, w = np.polynomial.legendre.leggauss(64)
    t, w = 0.5 * (x + 1.0), 0.5 * w
    degrees = range(m, m + 30, 2)
    rows = np.array([zernike.radial(n, m, np.sqrt(t)) for n in degrees])
    # int R_n R_k rho d rho = delta / (2 (n + 1))
    assert np.abs(0.5 * (rows * w) @ rows.T - np.diag([0.5 / (n + 1) for n in degrees])).max() < 1e-13
    assert all(zernike.radial(n, m, np.ones(1))[0] == pytest.approx(1.0, abs=1e-12) for n in degrees)


def test_the_first_polynomials_are_the_familiar_ones():
    rho, theta = np.linspace(0, 1, 11), np.linspace(-3, 3, 11)
    assert zernike.polynomial(2, 0, rho, theta) == pytest.approx(2 * rho**2 - 1)
    assert zernike.polynomial(3, 1, rho, theta) == pytest.approx((3 * rho**3 - 2 * rho) * np.cos(theta))
    assert zernike.polynomial(2, -2, rho, theta) == pytest.approx(rho**2 * np.sin(2 * theta))
    assert zernike.polynomial(4, 0, rho, theta) == pytest.approx(6 * rho**4 - 6 * rho**2 + 1)


def test_powers_of_rho_squared_become_legendre_terms_and_come_back():
    both = zernike.powers_to_legendre(10)[1:] @ zernike.legendre_to_powers(10)
    assert np.abs(both - np.eye(10)).max() < 1e-9
    t, c = np.linspace(0, 1, 9), np.arange(1.0, 5.0)
    edge = zernike.powers_to_legendre(4) @ c
    total = sum(b * zernike.radial(2 * k, 0, np.sqrt(t)) for k, b in enumerate(edge))
    assert total == pytest.approx(sum(a * t ** (k + 1) for k, a in enumerate(c)))


@mp.workdps(60)
def exact_edge(powers: list[float]) -> list[mp.mpf]:
    """Return the coefficients of R_2^0, ...: t^k = sum_j (2j + 1) k!^2 / ((k - j)! (k + j + 1)!) R_2j^0."""
    f, count = mp.factorial, len(powers)
    return [
        sum(mp.mpf(powers[k - 1]) * (2 * j + 1) * f(k) ** 2 / f(k - j) / f(k + j + 1) for k in range(j, count + 1))
        for j in range(1, count + 1)
    ]


def cancelling(terms: int) -> list[float]:
    return zernike.powers_of_edge(np.linspace(1.0, -2.0, terms) ** 3).tolist()


@given(st.lists(st.floats(-1e6, 1e6), min_size=2, max_size=12))
@example(cancelling(3))
@example(cancelling(10))
@example(cancelling(20))
@example(cancelling(30))
def test_powers_become_terms_within_their_bound(powers):
    c = np.array(powers)
    found, exact = zernike.edge_of_powers(c), exact_edge(powers)
    missed = sum(abs(mp.mpf(a) - b) for a, b in zip(found.tolist(), exact, strict=True))
    # That, and the last rounding of each, of which two powers have a second.
    last = mp.mpf(2) ** -53 * (2 if len(powers) == 2 else 1) * sum(map(abs, exact)) + mp.mpf("1e-320")
    bound = float(zernike.conversion_error(c))
    assert missed <= last + mp.mpf(bound)
    sizes = (len(powers) + 3) * float(np.finfo(np.longdouble).eps) * sum(map(abs, powers))
    assert bound == pytest.approx(sizes, rel=1e-12, abs=0.0)
    assert np.array_equal(zernike.edge_of_powers(np.stack([c, -c])), np.stack([found, -found]))


def test_what_powers_lose_where_they_cancel_is_much_of_its_bound():
    """Thirty terms lose all digits: a bound that were a thousandth would be broken."""
    powers = cancelling(30)
    missed = sum(
        abs(mp.mpf(a) - b) for a, b in zip(zernike.edge_of_powers(np.array(powers)), exact_edge(powers), strict=True)
    )
    assert missed > 1e-3 * zernike.conversion_error(np.array(powers))


@pytest.mark.parametrize("terms", [1, 2, 3, 10, 30])
def test_sums_of_legendre_polynomials_and_their_slopes(terms):
    a, x = np.random.default_rng(terms).normal(size=(2, terms)), np.linspace(-1.0, 1.0, 41)
    # By SciPy, and (1 - x^2) P_j' = j (P_(j-1) - x P_j).
    degrees = np.arange(terms + 1)[:, None]
    p = eval_legendre(degrees, x)
    assert np.abs(zernike.legendre_sum(a, x) - a @ (p - p[:, :1])[1:]).max() < 1e-13 * terms**2
    found = zernike.legendre_slope(a, x)
    slopes = a @ (degrees[1:] * (p[:-1] - x * p[1:]))
    assert np.abs((1.0 - x * x) * found - slopes).max() < 1e-13 * terms**4
    # P_j'(+-1) = (+-1)^(j+1) j (j + 1) / 2
    steepest = a * (degrees * (degrees + 1))[1:, 0] / 2.0
    assert np.abs(found[:, -1] - steepest.sum(axis=1)).max() < 1e-13 * terms**4
    assert np.abs(found[:, 0] - steepest @ (-1.0) ** degrees[:-1, 0]).max() < 1e-13 * terms**4


@pytest.mark.parametrize("angle", [0.3, -2.0])
def test_terms_turn_from_x_towards_y(angle):
    terms = {(3, 1): np.array(1.5), (3, -1): np.array(-0.5), (4, -2): np.array(2.0), (6, 0): np.array(1.0)}
    rho, theta = np.linspace(0.0, 1.0, 9)[:, None], np.linspace(-3.0, 3.0, 11)

    def value(parts, at):
        return sum(c * zernike.polynomial(*t, rho, at) for t, c in parts.items())

    turned = zernike.rotated(terms, np.array(angle))
    assert np.abs(value(turned, theta) - value(terms, theta - angle)).max() < 1e-14 * 20


@pytest.mark.parametrize(
    ("index", "order", "message"),
    [
        ((3, 2), "nm", r"\(n, m\) = \(3, 2\)"),
        ((2, 4), "nm", r"\(n, m\) = \(2, 4\)"),
        ((-1, 1), "nm", r"\(n, m\) = \(-1, 1\)"),
        ((61, 1), "nm", "from 0 to 60"),
        (0, "noll", "from 1 to"),
        (-1, "ansi", "from 0 to"),
        (38, "fringe", "from 1 to 37"),
        (0, "fringe", "from 1 to 37"),
    ],
)
def test_terms_that_do_not_exist_are_named(index, order, message):
    with pytest.raises(ValueError, match=message):
        zernike.term(index, order)


def test_terms_have_the_names_that_opticians_use():
    names = {(n, m): zernike.name(n, m) for n in range(16) for m in range(-n, n + 1, 2)}
    assert len(set(names.values())) == len(names)
    assert [names[term] for term in NOLL[:11]] == [
        "piston", "tilt x", "tilt y", "defocus", "astigmatism 45", "astigmatism 0", "coma y", "coma x",
        "trefoil y", "trefoil x", "spherical",
    ]  # fmt: skip
    assert names[4, 2] == "secondary astigmatism 0"
    assert names[5, -1] == "secondary coma y"
    assert names[6, 0] == "secondary spherical"
    assert names[4, -4] == "tetrafoil y"
    assert names[12, 0] == "5th spherical"
    assert names[9, 9] == "9-foil x"
