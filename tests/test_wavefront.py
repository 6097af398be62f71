"""The phase across the pupil: what it is made of, how it adds, and how stacks of it behave."""

from __future__ import annotations

import copy
import json
import math
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lommel import Wavefront

radians = st.floats(-1e3, 1e3)
wavefronts = st.builds(Wavefront, radians, radians, st.lists(radians, max_size=3).map(tuple))
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


@given(wavefronts, wavefronts)
def test_addition_commutes_and_subtraction_undoes_itself(one, two):
    assert one + two == two + one
    assert one - one == Wavefront()
    assert one + Wavefront() == one


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


def test_iterating_a_stack_gives_its_wavefronts():
    assert list(Wavefront([1.0, 2.0])) == [Wavefront(1.0), Wavefront(2.0)]


def test_a_single_wavefront_cannot_be_indexed():
    with pytest.raises(TypeError, match="single wavefront"):
        Wavefront(1.0)[0]


def test_wavefronts_share_no_memory_with_the_arrays_they_were_made_from():
    defocus = np.array([1.0, 2.0])
    stack = Wavefront(defocus)
    defocus[0] = 99.0
    assert stack.defocus.tolist() == [1.0, 2.0]
    with pytest.raises(ValueError, match="read-only"):
        stack.defocus[0] = 99.0
    with pytest.raises(AttributeError):
        stack.defocus = defocus


@pytest.mark.parametrize("other", [Wavefront(1.0, 0.1), Wavefront([1.0]), Wavefront(1.0, 0.0, [1e-300]), 1.0, "W"])
def test_wavefronts_differ_where_any_coefficient_or_the_shape_does(other):
    assert Wavefront(1.0) != other


def test_wavefronts_are_equal_where_their_coefficients_are():
    assert Wavefront(1.0) == Wavefront(1, 0.0, [0.0])
    assert Wavefront([1.0, 1.0]) == Wavefront([1.0, 1.0], [0.0, 0.0])


def test_a_wavefront_of_arrays_has_no_hash():
    with pytest.raises(TypeError, match="unhashable"):
        hash(Wavefront())


@given(wavefronts)
def test_the_repr_of_a_wavefront_is_an_expression_for_it(wavefront):
    assert eval(repr(wavefront)) == wavefront


def test_the_repr_of_a_stack_says_its_shape_and_range():
    assert repr(Wavefront([1.0, 2.0, 4.0], 0.5)) == "Wavefront(defocus=<array (3,) from 1 to 4>, spherical=0.5)"


@given(wavefronts)
def test_a_wavefront_survives_json_pickling_and_copying(wavefront):
    assert Wavefront(**json.loads(json.dumps(wavefront.to_dict()))) == wavefront
    assert pickle.loads(pickle.dumps(wavefront)) == wavefront
    assert copy.deepcopy(wavefront) == wavefront


def test_numbers_of_numpy_scale_a_wavefront_too():
    assert np.float64(2.0) * Wavefront(1.0) == Wavefront(2.0)
    assert Wavefront(1.0) * np.int64(2) == Wavefront(2.0)


@pytest.mark.parametrize("factor", [np.array([1.0, 2.0]), [1.0, 2.0], "2", None, 1j, math.nan, math.inf], ids=repr)
@pytest.mark.parametrize("left", [True, False], ids=["factor times wavefront", "wavefront times factor"])
def test_only_a_finite_number_scales_a_wavefront(factor, left):
    with pytest.raises((TypeError, ValueError)):
        factor * Wavefront(1.0) if left else Wavefront(1.0) * factor


@pytest.mark.parametrize("other", [1, 1.0, np.ones(2), None, "W"], ids=repr)
def test_only_wavefronts_are_added_to_wavefronts(other):
    with pytest.raises(TypeError):
        Wavefront(1.0) + other
    with pytest.raises(TypeError):
        Wavefront(1.0) - other
    with pytest.raises(TypeError):
        other + Wavefront(1.0)
