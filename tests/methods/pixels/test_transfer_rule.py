"""Quadrature over the transfer function of a disc: against closed forms and adaptive quadrature."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
import scipy.linalg
from scipy.integrate import quad
from scipy.special import eval_chebyu, j1

from lommel.methods.pixels.transfer_rule import modulus_rule, transfer_rule


def chords(w: float) -> float:
    """Return the autocorrelation of the chords of the disc, whose integral is 1."""

    def product(turn: float) -> float:
        s = 0.5 * w + (1.0 - 0.5 * w) * math.sin(turn)
        both = max(0.0, 1.0 - s * s) * max(0.0, 1.0 - (s - w) ** 2)
        return math.sqrt(both) * (1.0 - 0.5 * w) * math.cos(turn)

    return 4.0 / math.pi**2 * quad(product, -0.5 * math.pi, 0.5 * math.pi, epsabs=1e-13)[0]


@pytest.mark.parametrize("degree", [2, 32, 64, 128, 256])
def test_waves_have_the_image_of_a_point_as_their_mean(degree):
    """The transform of the transfer function, along one axis, as long as waves are polynomials of the degree."""
    w, weights = transfer_rule(degree)
    assert weights.min() > 0.0
    assert w.size == degree // 2 + 1
    for x in np.linspace(0.1, max(0.1, (2 * degree - 48) / 2.36), 7):
        # x multiplies what nodes are off by and what x w is rounded by: w by two units of its last place at most.
        rounding = 2.0**-52 * (2.0 * x * float(weights @ w) + 4.0)
        allowed = 1e-2 if degree == 2 else rounding
        assert weights @ np.cos(x * w) == pytest.approx((2.0 * j1(x) / x) ** 2, rel=0.0, abs=allowed)


def recurrence(degree: int) -> list[mp.mpf]:
    """Return the off-diagonal of the Jacobi matrix of m, to 40 digits, by Stieltjes's procedure on all pairs."""
    angles = [mp.pi * k / (degree + 2) for k in range(1, degree + 2)]
    w = [mp.cos(a) - mp.cos(b) for a in angles for b in angles if a <= b]
    p = [mp.sin(a) * mp.sin(b) * mp.sqrt(2 - (a == b)) for a in angles for b in angles if a <= b]
    before, beside = [mp.mpf(0)] * len(p), [mp.norm(p)]
    for _ in range(degree + 2):
        p = [x / beside[-1] for x in p]
        after = [at * x - (beside[-1] if len(beside) > 1 else 0) * y for at, x, y in zip(w, p, before, strict=True)]
        before, p = p, after
        beside.append(mp.norm(after))
    return beside[1:]


def test_nodes_and_weights_are_those_of_40_digits():
    w, weights = transfer_rule(32)
    with mp.workdps(40):
        beside = recurrence(32)

        def polynomials(x: mp.mpf) -> list[mp.mpf]:
            p = [mp.mpf(0), mp.mpf(1)]
            for k, after in enumerate(beside):
                p.append((x * p[-1] - (beside[k - 1] if k else 0) * p[-2]) / after)
            return p[1:]

        for node, weight in zip(w, weights, strict=True):
            exact = mp.findroot(lambda x: polynomials(x)[-1], (node, node * (1 + 1e-9)))
            assert node == pytest.approx(float(exact), rel=4 * 2.0**-53, abs=0.0)
            assert weight == pytest.approx(float(2 / sum(p * p for p in polynomials(exact)[:-1])), rel=1e-13, abs=0.0)


@pytest.mark.parametrize("degree", [34, 258])
def test_nodes_do_not_depend_on_what_libraries_round(degree, monkeypatch):
    """Not more than by its last places: their eigenvalues are off by parts in the 16th place, of the largest one."""
    w, weights = transfer_rule(degree)
    of_library = scipy.linalg.eigvalsh_tridiagonal

    def otherwise(*matrix: np.ndarray) -> np.ndarray:
        found = of_library(*matrix)
        return found + 4e-15 * np.cos(7.0 * np.arange(found.size))

    monkeypatch.setattr(scipy.linalg, "eigvalsh_tridiagonal", otherwise)
    other, of_other = transfer_rule.__wrapped__(degree)
    assert other == pytest.approx(w, rel=2e-15, abs=0.0)
    assert of_other == pytest.approx(weights, rel=0.0, abs=1e-15)


@pytest.mark.parametrize("degree", [34, 130, 386])
@pytest.mark.parametrize("power", [2, 4, 6])
def test_squares_have_their_means_relative_to_themselves(degree, power):
    """Where they are largest at the end of the band, too, where m falls to 0 and what nodes are off by counts most.

    docs/certificate.md, 10, has 4e-6 for it.
    """
    w, weights = transfer_rule(degree)
    angles = np.arange(1, degree + 2) * (math.pi / (degree + 2))
    at = 2.0 * np.abs(np.sin(0.5 * np.add.outer(angles, angles)) * np.sin(0.5 * np.subtract.outer(angles, angles)))
    product = np.multiply.outer(np.sin(angles) ** 2, np.sin(angles) ** 2) * (2.0 / (degree + 2)) ** 2

    def square(w: np.ndarray) -> np.ndarray:
        return eval_chebyu(2 * degree // power, 0.5 * w) ** power

    assert weights @ square(w) == pytest.approx((product * square(at)).sum(), rel=1e-11, abs=0.0)


def test_powers_have_their_moments():
    w, weights = transfer_rule(4)
    for power in (0, 2, 4, 6, 8):
        expected = 2.0 * quad(lambda x, k=power: x**k * chords(x), 0.0, 2.0, epsabs=1e-12)[0]
        assert weights @ w**power == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("power", [0, 1, 2])
def test_the_mean_of_a_modulus_is_bounded_and_hardly_more(power):
    """Of errors that rise towards the end of the band, as those of filters do."""
    w, weights = modulus_rule(32)
    bound = math.sqrt(weights @ (w**power) ** 2)
    mean = 2.0 * quad(lambda x: x**power * chords(x), 0.0, 2.0, epsabs=1e-12)[0]
    assert mean <= bound <= 1.6 * mean


def test_the_bound_is_reached_by_what_it_is_made_for():
    """By an error proportional to 1 over the weight q, by the constant, which is the integral of m / q."""
    share = 2.0 * quad(lambda x: chords(x) / (1.0 - 0.25 * x * x) ** 2, 0.0, 2.0, epsabs=1e-9)[0]
    w, weights = modulus_rule(32)
    of_q = weights / transfer_rule(34)[1]
    assert of_q == pytest.approx(1.69766 * (1.0 - 0.25 * w * w) ** 2)
    # Above it by more than rules are off by.
    assert 1e-6 < 1.69766 / share - 1.0 < 1e-5
