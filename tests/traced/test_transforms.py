"""Transforms of a traced plan: gradients of any order, vmap, jit, trees, poison where nothing can be raised."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import lommel as lm
from frameworks import hasty_programs

jax = pytest.importorskip("jax")
jnp = jax.numpy

RANGE = lm.Pupil(lm.Wavefront([-10.0, 10.0], [-1.0, 1.0]))
C = np.array([[3.0, 0.5], [-9.0, -1.0], [0.1, 0.0]])


@pytest.fixture(scope="module", autouse=True)
def double():
    with jax.enable_x64(True):
        yield


@pytest.fixture
def hasty():
    with hasty_programs():
        yield


@pytest.fixture(scope="module")
def f():
    with jax.enable_x64(True):
        return lm.Plan(9, 0.5, tol=1e-9).traced(RANGE, jnp)


def test_derivatives_are_those_of_the_core_forward_and_reverse(f, hasty):
    found = jax.jit(jax.jacfwd(f))(C[0])
    exact = lm.psf(lm.Pupil(lm.Wavefront(*C[0])), 9, 0.5, tol=1e-12, derivatives=("defocus", "spherical"))
    peak = exact.values.max()
    for j, name in enumerate(("defocus", "spherical")):
        assert np.abs(found[..., j] - exact.derivatives[name]).max() < 1e-12 * peak
    assert np.abs(found - jax.jit(jax.jacrev(f))(C[0])).max() < 1e-14 * peak


def test_second_derivatives_are_symmetric_and_differences_of_first_ones(f, hasty):
    def loss(c):
        return 1e4 * jnp.sum(f(c) ** 2)

    hessian = jax.jit(jax.hessian(loss))(C[0])
    assert np.abs(hessian - hessian.T).max() < 1e-13 * np.abs(hessian).max()
    gradient, h = jax.jit(jax.grad(loss)), 1e-5
    steps = [(gradient(C[0] + h * e) - gradient(C[0] - h * e)) / (2 * h) for e in np.eye(2)]
    assert np.abs(np.stack(steps) - hessian).max() < 1e-7 * np.abs(hessian).max()


def test_derivatives_of_wavefronts_of_any_terms_are_those_of_the_core(hasty):
    terms, c = ((2, 0), (4, 0), (2, 2), (3, 1)), np.array([0.7, -0.3, 0.5, 0.8])

    def pupil(scale):
        return lm.Pupil(lm.Wavefront.zernike(dict(zip(terms, scale * c, strict=True)), normalization="edge"))

    f = lm.Plan(7, 0.5, tol=1e-9).traced(pupil(1.5), jnp)
    assert f.terms == terms
    found = jax.jit(jax.jacfwd(f))(c)
    exact = lm.psf(pupil(1.0), 7, 0.5, tol=1e-11, derivatives=((2, 2), (3, 1)))
    for j, term in ((2, (2, 2)), (3, (3, 1))):
        assert np.abs(found[..., j] - exact.derivatives[term]).max() < 1e-10 * exact.values.max()


def test_float32_has_the_same_derivatives_but_for_its_rounding(hasty):
    f = lm.Plan(9, 0.5, tol=2e-3).traced(RANGE, jnp, precision="float32")
    found = jax.jit(jax.jacrev(lambda c: f(c)[4, 5]))(jnp.asarray(C[0], dtype=jnp.float32))
    exact = lm.psf(lm.Pupil(lm.Wavefront(*C[0])), 9, 0.5, derivatives=("defocus", "spherical"))
    told = np.array([exact.derivatives[name][4, 5] for name in ("defocus", "spherical")])
    assert np.abs(found - told).max() < 3e-6 * exact.values.max()


def test_vmap_jit_scan_and_checkpoint_change_nothing(f, hasty):
    plain = f(C)
    for made in (
        jax.vmap(f)(C),
        jax.jit(jax.vmap(f))(C),
        jax.lax.scan(lambda carry, c: (carry, f(c)), 0, C)[1],
        jax.checkpoint(f)(jnp.asarray(C)),
        jax.jit(lambda plan, c: plan(c))(f, C),
    ):
        assert np.abs(made - plain).max() < 1e-15
    assert f(C.reshape(3, 1, 2)).shape == (3, 1, 9, 9)
    assert f(np.zeros((0, 2))).shape == (0, 9, 9)


def test_one_program_serves_all_coefficients_and_another_plan_of_the_same_kind(f):
    count = []

    @jax.jit
    def images(plan, c):
        count.append(1)
        return plan(c)

    for k in range(3):
        images(f, C + 0.01 * k)
    images(pickle.loads(pickle.dumps(f)), C)
    assert len(count) == 1
    # And a second program that closes over it finds no tracer of the first.
    assert jax.jit(lambda c: f(c) + 0.0)(C).shape == (3, 9, 9)


def test_traced_within_a_program_a_plan_leaks_nothing():
    plan, kept = lm.Plan(5, 0.5), []

    def inside(c):
        kept.append(plan.traced(RANGE, jnp))
        return kept[-1](c)

    jax.jit(inside)(C)
    assert np.isfinite(kept[0](C)).all()


def test_what_is_not_proven_is_poisoned_and_its_neighbours_are_not(f):
    c = np.array([[3.0, 0.5], [-900.0, 0.0], [np.nan, 0.0], [np.inf, 1.0], [1.0, 1.0]])
    images, bound = jax.jit(f.certified)(c)
    bad = np.array([False, True, True, True, False])
    assert np.array_equal(np.isnan(images).all(axis=(1, 2)), bad)
    assert np.array_equal(np.isinf(bound), bad)
    # A graphics processor rounds products of another size otherwise.
    np.testing.assert_allclose(images[0], f(c[0]), rtol=0.0, atol=1e-13)
    gradient = jax.jit(jax.grad(lambda c: jnp.sum(f(c)[0] ** 2) + jnp.sum(f(c)[4] ** 2)))(c)
    alone = jax.jit(jax.grad(lambda c: jnp.sum(f(c) ** 2)))(c[:1])
    assert np.isfinite(gradient[~bad]).all()
    assert np.allclose(gradient[0], alone[0], rtol=1e-12)
    assert np.array_equal(f(c, check=False)[0], images[0])
    for rows, message in (((0, 1), r"\(1,\), defocus = -900 \(traced for -10 to 10\)"), ((2,), "nan"), ((3,), "inf")):
        with pytest.raises(lm.ToleranceError, match=message):
            f(c[list(rows)])


def test_the_bound_has_no_gradient_and_gradients_of_images_have_their_own(f):
    assert np.array_equal(jax.jit(jax.grad(lambda c: f.certified(c)[1]))(C[0]), [0.0, 0.0])


def test_without_float64_bounds_are_those_of_float32():
    with jax.enable_x64(False):
        with pytest.raises(ValueError, match="jax_enable_x64"):
            lm.Plan(9, 0.5).traced(RANGE, jnp, precision="float64")
        with pytest.raises(ValueError, match="dtype must be float32"):
            lm.Plan(9, 0.5, tol=1e-9).traced(RANGE, jnp)
        with pytest.raises(lm.ToleranceError, match="jax_enable_x64"):
            lm.Plan(9, 0.5, tol=1e-6).traced(RANGE, jnp)
        f = lm.Plan(9, 0.5, tol=1e-3).traced(RANGE, jnp)
        assert f.precision == "float32"
        assert f.error(C).max() > 1e-6
    with jax.enable_x64(True):
        f = lm.Plan(9, 0.5, tol=1e-6).traced(RANGE, jnp)
        assert (f.precision, str(f(C).dtype)) == ("float64", "float32")
        with jax.enable_x64(False), pytest.raises(TypeError, match="trace a new plan"):
            jax.jit(f)(C.astype(np.float32))
