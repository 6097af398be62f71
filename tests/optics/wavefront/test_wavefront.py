"""The phase across the pupil: what it is made of, how it adds, and how stacks of it behave."""

from __future__ import annotations

import copy
import json
import math
import pickle

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

import lommel as lm
from lommel import Wavefront
from lommel.special import zernike

radians = st.floats(-1e3, 1e3)
NONRADIAL = [(n, m) for n in range(1, 9) for m in range(-n, n + 1, 2) if m]
wavefronts = st.builds(
    Wavefront,
    radians,
    radians,
    st.lists(radians, max_size=3).map(tuple),
    st.dictionaries(st.sampled_from(NONRADIAL), radians, max_size=4),
)
angles = st.floats(-3.0, 3.0)
RHO = np.linspace(0.0, 1.0, 11)


def annulus_rule(eps: float) -> tuple[np.ndarray, np.ndarray]:
    """Radii and weights that average over the annulus, by area."""
    x, weights = np.polynomial.legendre.leggauss(40)
    t = 0.5 * (1 + eps**2) + 0.5 * (1 - eps**2) * x
    return np.sqrt(t), 0.5 * weights


def rms_over(wavefront: Wavefront, eps: float) -> float:
    rho, weights = annulus_rule(eps)
    phase = wavefront.phase(rho)
    return math.sqrt(weights @ (phase - weights @ phase) ** 2)


@given(defocus=radians, spherical=radians, higher=st.lists(radians, max_size=8))
def test_the_phase_is_the_polynomial_that_the_coefficients_say(defocus, spherical, higher):
    phase = Wavefront(defocus, spherical, higher).phase(RHO)
    terms = [2 * defocus, spherical, *higher]
    expected = sum(c * RHO ** (2 * k) for k, c in enumerate(terms, 1))
    np.testing.assert_allclose(phase, expected, rtol=0, atol=1e-13 * (1 + sum(map(abs, terms))))


@given(wavefronts, wavefronts, st.floats(-10, 10))
def test_wavefronts_add_and_scale_as_their_phases_do(one, two, factor):
    size = 1 + sum(np.abs(w.coefficients).sum() for w in (one, two)) * (1 + abs(factor))
    for combined, expected in [
        (one + two, one.phase(RHO) + two.phase(RHO)),
        (one - two, one.phase(RHO) - two.phase(RHO)),
        (factor * one, factor * one.phase(RHO)),
        (one * factor, factor * one.phase(RHO)),
        (-one, -one.phase(RHO)),
    ]:
        np.testing.assert_allclose(combined.phase(RHO), expected, rtol=0, atol=1e-12 * size)


def size_of(wavefront: Wavefront) -> float:
    return 1.0 + sum(float(np.abs(c).sum()) for c in (wavefront.coefficients, *wavefront.nonradial.values()))


def at(wavefront: Wavefront, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    return wavefront.phase(np.hypot(x, y), np.arctan2(y, x))


@given(wavefronts, angles, angles)
def test_a_rotated_wavefront_has_the_phase_of_points_turned_back(wavefront, angle, theta):
    turned = wavefront.rotated(angle).phase(RHO, theta)
    np.testing.assert_allclose(turned, wavefront.phase(RHO, theta - angle), rtol=0, atol=1e-12 * size_of(wavefront))


@given(wavefronts, angles)
def test_a_mirrored_wavefront_has_the_phase_of_mirrored_points(wavefront, theta):
    x, y = RHO * math.cos(theta), RHO * math.sin(theta)
    atol = 1e-12 * size_of(wavefront)
    np.testing.assert_allclose(at(wavefront.flipped("x"), x, y), at(wavefront, -x, y), rtol=0, atol=atol)
    np.testing.assert_allclose(at(wavefront.flipped("y"), x, y), at(wavefront, x, -y), rtol=0, atol=atol)


@given(wavefronts, st.floats(0.05, 1.0), angles)
def test_a_smaller_pupil_sees_the_middle_of_the_wavefront(wavefront, radius, theta):
    small = wavefront.scaled(radius).phase(RHO, theta)
    np.testing.assert_allclose(small, wavefront.phase(radius * RHO, theta), rtol=0, atol=1e-12 * size_of(wavefront))


def test_rotation_and_scaling_broadcast_with_stacks():
    stack = Wavefront(np.arange(3.0), nonradial={(3, 1): 1.0, (4, -2): np.arange(3.0)})
    assert stack.rotated(np.zeros((2, 1))).shape == (2, 3)
    assert Wavefront(1.0).rotated(np.zeros(4)).shape == (4,)
    assert stack.scaled(np.array([[0.5], [1.0]])).shape == (2, 3)
    np.testing.assert_allclose(stack.scaled(np.array([[0.5], [1.0]]))[1].phase(RHO, 0.3), stack.phase(RHO, 0.3))
    for call in (stack.rotated, stack.scaled):
        with pytest.raises(ValueError, match=r"and the stack must broadcast, got shapes .*\(2,\).*\(3,\)"):
            call(np.array([0.5, 0.6]))


@pytest.mark.parametrize(
    ("refused", "message"),
    [
        (lambda: Wavefront(nonradial={(2, 0): 1.0}), r"m != 0, got \(2, 0\)"),
        (lambda: np.array([1.0, 2.0]) * Wavefront(1.0), "."),
        (lambda: Wavefront(1.0) * 1j, "."),
        *((lambda x=x: Wavefront(1.0) + x, ".") for x in (1.0, np.ones(2))),
        *((lambda x=x: x - Wavefront(1.0), ".") for x in (1.0, np.ones(2))),
    ],
)
def test_what_makes_no_wavefront_is_refused(refused, message):
    with pytest.raises((TypeError, ValueError), match=message):
        refused()


def test_a_description_with_a_term_twice_is_refused():
    description = Wavefront(1.0, nonradial={(3, 1): 2.0}).to_dict()
    description["nonradial"] *= 2
    with pytest.raises(ValueError, match=r"once, got \[\(3, 1\), \(3, 1\)\]"):
        Wavefront.from_dict(description)


@given(st.tuples(radians, radians, radians, radians))
def test_seidel_coefficients_come_back_as_waves(given_waves):
    waves = Wavefront.from_seidel(*given_waves).waves
    for name, value in zip(("W020", "W040", "W060", "W080"), given_waves, strict=True):
        assert float(waves.get(name, 0.0)) == pytest.approx(value)


@given(rms=st.floats(-50, 50), eps=st.floats(0, 0.95))
def test_balanced_spherical_has_the_rms_asked_for_over_the_annulus(rms, eps):
    wavefront = Wavefront.balanced_spherical(rms, eps)
    assert rms_over(wavefront, eps) == pytest.approx(abs(rms), rel=1e-9, abs=1e-9)
    assert np.sign(wavefront.spherical) == np.sign(rms)


@pytest.mark.parametrize("eps", [0.0, 0.33, 0.8])
@pytest.mark.parametrize("more", [-0.01, 0.01])
def test_no_other_defocus_gives_balanced_spherical_less_variance(eps, more):
    balanced = Wavefront.balanced_spherical(3.0, eps)
    assert rms_over(balanced + Wavefront(defocus=more), eps) > rms_over(balanced, eps)


def test_arrays_of_coefficients_broadcast_to_a_stack():
    stack = Wavefront(np.arange(3.0)[:, None], np.arange(4.0), [np.arange(2.0)[:, None, None]])
    assert stack.shape == (2, 3, 4)
    assert stack.coefficients.shape == (2, 3, 4, 3)
    assert stack.coefficients[1, 2, 3].tolist() == [4.0, 3.0, 1.0]
    assert stack.phase(RHO).shape == (2, 3, 4, 11)
    assert stack.phase(0.5).shape == (2, 3, 4)
    assert Wavefront(1.0).shape == ()


@pytest.mark.parametrize(
    "index",
    [0, -1, slice(1, None), (slice(None), 2), (..., 0), [2, 0], (1, 3), np.array([True, False, True]), None],
    ids=repr,
)
def test_a_stack_is_indexed_as_numpy_indexes_its_phases(index):
    stack = Wavefront(np.arange(3.0)[:, None], np.arange(4.0), [5.0])
    np.testing.assert_array_equal(stack[index].phase(0.7), stack.phase(0.7)[index])


def test_wavefronts_share_no_memory_with_the_arrays_they_were_made_from():
    defocus = np.array([1.0, 2.0])
    stack = Wavefront(defocus)
    defocus[0] = 99.0
    assert stack.defocus.tolist() == [1.0, 2.0]
    with pytest.raises(ValueError, match="read-only"):
        stack.defocus[0] = 99.0
    with pytest.raises(AttributeError):
        stack.defocus = defocus
    with pytest.raises(TypeError, match="does not support item assignment"):
        stack.nonradial[3, 1] = defocus


def test_wavefronts_are_equal_where_their_coefficients_are():
    assert Wavefront(1.0) == Wavefront(1, 0.0, [0.0])
    assert Wavefront([1.0, 1.0]) == Wavefront([1.0, 1.0], [0.0, 0.0])
    assert (Wavefront(-0.0), hash(-Wavefront())) == (Wavefront(0.0), hash(Wavefront()))
    waves = Wavefront(), Wavefront(1.0), Wavefront(0.0, 1.0), Wavefront(error=1e-3), Wavefront([0.0])
    assert [wave.flat for wave in waves] == [True, False, False, False, False]
    for other in (Wavefront(1.0, 0.1), Wavefront([1.0]), Wavefront(1.0, 0.0, [1e-300]), 1.0, "W"):
        assert Wavefront(1.0) != other


@given(radians, radians, st.lists(radians, max_size=8), st.dictionaries(st.sampled_from(NONRADIAL), radians))
@example(0.1, 0.3, [0.7, 1e-3, 123.456], {(3, 1): 0.1})
def test_what_is_given_comes_back_exactly(defocus, spherical, higher, nonradial):
    given_one = Wavefront(defocus, spherical, higher, nonradial)
    stack = Wavefront([defocus, 1.0], spherical, [[c, 2.0] for c in higher], nonradial)
    for one in (
        given_one,
        pickle.loads(pickle.dumps(given_one)),
        copy.deepcopy(given_one),
        Wavefront.from_dict(json.loads(json.dumps(given_one.to_dict()))),
        stack[0],
        stack.flattened()[0],
        pickle.loads(pickle.dumps(stack))[0],
        given_one.flattened()[0],
        given_one + Wavefront(),
        Wavefront() + given_one,
        1.0 * given_one,
        -1.0 * (-1.0 * given_one),
        given_one.flipped("x").flipped("x"),
        given_one + Wavefront.zernike({(3, 3): 0.0, (0, 0): 5.0}, normalization="edge"),
    ):
        assert one.defocus == defocus
        assert one.spherical == spherical
        assert [float(c) for c in one.higher] == higher
        for term, c in nonradial.items():
            assert one.nonradial[term] == c
        assert np.array_equal(one.edge[: one.symmetric], given_one.edge[: one.symmetric])
        assert one == given_one


EDGE = {(2, 0): 0.1, (6, 0): -0.7, (20, 0): 3.3, (60, 0): 0.123456789, (3, -1): 0.1, (7, 5): 1e-9}


@given(st.dictionaries(st.sampled_from([*EDGE, (58, 0), (60, 58)]), radians, min_size=1))
@example(EDGE)
def test_terms_at_the_edge_come_back_exactly(edge):
    one = Wavefront.zernike(edge, normalization="edge")
    stack = Wavefront.zernike({term: np.array([c, 1.0]) for term, c in edge.items()}, normalization="edge")
    for found in (
        one,
        pickle.loads(pickle.dumps(one)),
        Wavefront.from_dict(json.loads(json.dumps(one.to_dict()))),
        stack[0],
        stack.flattened()[0],
        one + Wavefront(),
        Wavefront() + one,
        one.rotated(0.0),
        eval(repr(one)),
    ):
        assert found == one
        assert {term: float(c) for term, c in found.edge_terms().items() if c} == {t: c for t, c in edge.items() if c}
        assert found.left_out == 0.0


def test_powers_of_high_degree_that_cancel_are_counted():
    # R_20^0 as powers of up to 4e6; those of low degree lose nothing but a rounding of each term.
    powers = 8.0 * zernike.powers_of_edge(np.eye(10)[9])
    one = Wavefront(0.5 * powers[0], powers[1], powers[2:].tolist(), error=1e-12)
    lost = 13 * float(np.finfo(np.longdouble).eps) * np.abs(powers).sum()
    assert one.left_out == pytest.approx(1e-12 + lost, rel=1e-12)
    for plain in (Wavefront(1e3, -1e3), Wavefront(3.0, 1.0, [0.5]), Wavefront.trusted(one.terms, one.edge.copy())):
        assert plain.left_out == 0.0
    # A stack has the largest; others of it do not take that away.
    pair = Wavefront([0.5 * powers[0], 1.0], [powers[1], 0.0], [[c, 0.0] for c in powers[2:]])
    assert pair.left_out == pytest.approx(lost, rel=1e-12)
    assert pair[1].left_out == 0.0


def test_numbers_of_numpy_scale_a_wavefront_too():
    assert np.float64(2.0) * Wavefront(1.0) == Wavefront(2.0)
    assert Wavefront(1.0) * np.int64(2) == Wavefront(2.0)


def mahajan(n: int, m: int, rho: np.ndarray, eps: float) -> np.ndarray:
    """Return the radial factor of an annular term of rms 1: V. N. Mahajan, JOSA 71, 75 (1981), Table I."""
    e = eps * eps
    two, four = 1 + e + e**2, 1 + 4 * e + e**2
    return {
        (1, 1): 2 * rho / math.sqrt(1 + e),
        (2, 0): math.sqrt(3) * (2 * rho**2 - 1 - e) / (1 - e),
        (2, 2): math.sqrt(6) * rho**2 / math.sqrt(two),
        (3, 1): math.sqrt(8) * (3 * (1 + e) * rho**3 - 2 * two * rho) / ((1 - e) * math.sqrt((1 + e) * four)),
        (3, 3): math.sqrt(8) * rho**3 / math.sqrt(1 + e + e**2 + e**3),
        (4, 0): math.sqrt(5) * (6 * rho**4 - 6 * (1 + e) * rho**2 + four) / (1 - e) ** 2,
    }[n, m]


@pytest.mark.parametrize("eps", [0.2, 0.61, 0.9])
@pytest.mark.parametrize("term", [(1, 1), (2, 0), (2, 2), (3, 1), (3, 3), (4, 0)])
def test_annular_terms_are_those_of_mahajans_table(term, eps):
    rho = np.linspace(eps, 1, 40)
    found = Wavefront.zernike({term: 0.7}, obscuration=eps).phase(rho, 0.0)
    exact = 0.7 * mahajan(*term, rho, eps)
    np.testing.assert_allclose(found - found[0], exact - exact[0], atol=1e-11 / (1 - eps))
    edge = Wavefront.zernike({term: 0.7}, obscuration=eps, normalization="edge").phase(rho, 0.0)
    scaled = exact / mahajan(*term, np.ones(1), eps)
    np.testing.assert_allclose(edge - edge[0], scaled - scaled[0], atol=1e-11 / (1 - eps))


@given(
    st.floats(0.05, 0.8),
    st.dictionaries(st.sampled_from([(n, m) for n in range(1, 9) for m in range(-n, n + 1, 2)]), st.floats(-3, 3)),
    st.sampled_from(["rms", "edge"]),
)
def test_annular_coefficients_come_back(eps, terms, normalization):
    asked = {"obscuration": eps, "normalization": normalization, "unit": "waves"}
    made = Wavefront.zernike(terms, **asked)
    found = made.to_zernike(**asked)
    for term in {*terms, *found}:
        assert float(found.get(term, 0.0)) == pytest.approx(terms.get(term, 0.0), abs=1e-8)
    if normalization == "rms":
        pupil = lm.Pupil(made, obscuration=eps)
        assert float(lm.rms(pupil, unit="waves")) == pytest.approx(math.hypot(*terms.values()), abs=1e-7)


def test_annular_terms_may_be_a_stack_and_have_limits():
    stack = Wavefront.zernike({7: [0.1, 0.2], 11: 0.3}, order="noll", unit="waves", obscuration=0.5)
    assert stack.shape == (2,)
    np.testing.assert_allclose(stack.to_zernike(order="noll", unit="waves", obscuration=0.5)[7], [0.1, 0.2])
    for size in (1e6, 1e-6):  # without terms that are roundings of this size
        large = Wavefront.zernike({(8, 0): size, (2, 0): 1e-12 * size}, obscuration=0.5)
        assert {*large.to_zernike(obscuration=0.5)} == {(8, 0), (2, 0)}
    with pytest.raises(ValueError, match="obscuration must be"):
        Wavefront.zernike({(2, 0): 1.0}, obscuration=1.0)
    with pytest.raises(ValueError, match=r"order m = 0 up to n = 60 over an .* are nearly linearly"):
        Wavefront.zernike({(60, 0): 1.0}, obscuration=0.9)
