"""Cosine and sine of turns, as JAX has them here: how far off they are, and that their derivatives are their own."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.traced.namespaces import Namespace
from lommel.traced.phases import waves

jax = pytest.importorskip("jax")
jnp = jax.numpy
LONG_TAU = 2 * np.arccos(np.longdouble(-1.0))


@pytest.mark.parametrize(("kind", "unit"), [("float32", 2.0**-24), ("float64", 2.0**-53)])
def test_waves_are_off_by_a_few_units(kind, unit):
    draw = np.random.default_rng(0)
    exactly = [-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 1.0]
    turns = np.concatenate([draw.uniform(-0.6, 0.6, 200_000), exactly]).astype(kind)
    with jax.enable_x64(True):
        cos, sin = map(np.asarray, jax.jit(lambda t: waves(Namespace.of("jax"), (t,)))(jnp.asarray(turns)))
    assert cos.dtype == sin.dtype == kind
    angle = LONG_TAU * turns.astype(np.longdouble)
    assert np.abs(cos - np.cos(angle)).max() < 5.0 * unit
    # The sine is the cosine of a sum, rounded.
    assert np.abs(sin - np.sin(angle)).max() < 8.2 * unit
    assert np.array_equal(cos[-8:] == 0.0, [False, True, False, True, False, True, False, False])


def test_derivatives_of_any_order_are_those_of_waves_also_where_polynomials_meet():
    at = jnp.asarray([0.0, 0.25, 0.5, 0.1, -0.3], dtype=jnp.float32)
    made = jax.vmap(jax.jacfwd(jax.jacrev(lambda t: jnp.stack(waves(Namespace.of("jax"), (t,))))))(at)
    angle = 2 * np.pi * np.asarray(at, dtype=np.float64)
    expected = -4 * np.pi**2 * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    assert np.abs(made - expected).max() < 1e-4


def test_other_frameworks_use_their_own():
    cos, sin = waves(Namespace.of(None), (np.array([0.125, 100.25]),))
    assert np.allclose([cos, sin], [[0.5**0.5, 0.0], [0.5**0.5, 1.0]], atol=1e-12)


@pytest.mark.parametrize("name", ["jax", "numpy"])
def test_of_two_parts_the_first_loses_its_whole_turns(name):
    parts = np.array([100_000.0, -7.5], dtype=np.float32), np.array([0.1259, 0.1259], dtype=np.float32)
    found = np.stack(waves(Namespace.of(name), parts))
    angle = 2 * np.pi * (0.1259 + np.array([0.0, 0.5]))
    assert np.abs(found - [np.cos(angle), np.sin(angle)]).max() < 5e-7
