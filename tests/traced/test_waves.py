"""Waves, phases and folded sums in frameworks."""

from __future__ import annotations

import math

import numpy as np
import pytest

from lommel.traced import chordal
from lommel.traced.chordal import waves
from lommel.traced.namespaces import Namespace

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


@pytest.mark.parametrize("name", ["jax", "numpy"])
def test_of_two_parts_the_first_loses_its_whole_turns(name):
    parts = np.array([100_000.0, -7.5], dtype=np.float32), np.array([0.1259, 0.1259], dtype=np.float32)
    found = np.stack(waves(Namespace.of(name), parts))
    angle = 2 * np.pi * (0.1259 + np.array([0.0, 0.5]))
    assert np.abs(found - [np.cos(angle), np.sin(angle)]).max() < 5e-7


@pytest.mark.parametrize("pupils_last", [False, True])
@pytest.mark.parametrize("precision", ["float32", "float64"])
@pytest.mark.parametrize("largest", [1.0, 40.0, 900.0])
def test_turns_are_off_by_no_more_than_is_said(largest, precision, pupils_last):
    draw = np.random.default_rng(int(largest))
    basis = draw.uniform(-1.0, 1.0, (6, 500))
    rule, tables = chordal.phase_tables(basis, 16, largest, precision, pupils_last=pupils_last)
    c = draw.normal(size=(60, 6))
    c *= (largest / (np.abs(c) @ np.abs(basis).max(axis=1)))[:, None]
    size = np.abs(c) @ np.abs(basis).max(axis=1)
    made = {name: np.asarray(table, dtype=precision) for name, table in tables.items()}
    first, *rest = chordal.phase_turns(Namespace.of(None), rule, made, c)
    total = (first - np.round(first)) + rest[0] if rest else first
    assert total.dtype == precision
    off = (total.T if pupils_last else total) - (c @ basis) / math.tau
    off = math.tau * np.abs(off - np.round(off)).max(axis=1)
    said = rule.relative * size + rule.absolute
    assert np.all(off <= said)
    # Of 900 rad that float32 rounds as a whole, 5e-5 would be lost.
    assert np.all(said <= (1e-11 if precision == "float64" else 2e-6))


STEP = 0.7
PLACES = {
    "odd": np.arange(-3, 4) * STEP,
    "even": np.arange(-3, 3) * STEP,
    "samples of pixels": (np.arange(-2, 2)[:, None] + [-0.3, 0.3]).ravel(),
    "off the middle": np.arange(-3, 4) - 0.3,
    "on one side": np.arange(2, 5) * STEP,
    "one": np.zeros(1),
}


@pytest.mark.parametrize("columns", PLACES.values(), ids=PLACES)
@pytest.mark.parametrize("rows", PLACES.values(), ids=PLACES)
def test_a_folded_sum_is_that_over_all_nodes(columns, rows):
    draw = np.random.default_rng(3)
    x, y, weights = draw.uniform(0, 1, 4), draw.uniform(0, 1, (4, 3)), draw.uniform(0, 1, (4, 3))
    phase = draw.uniform(0, 6, (len(chordal.IMAGES), 4, 3, 2))
    exact = 0.0
    for (right, below), one in zip(chordal.IMAGES, phase, strict=True):
        across = np.exp(-1j * right * np.multiply.outer(columns, x))
        down = np.exp(-1j * below * np.multiply.outer(rows, y))
        exact = exact + np.einsum("ck,rkl,kl,kln->ncr", across, down, weights, np.exp(1j * one))
    (over, kept), (along, held) = chordal.axis_of(columns), chordal.axis_of(rows)
    waves = [(np.cos(one).reshape(12, 2), np.sin(one).reshape(12, 2)) for one in phase]
    kernels = chordal.folded_tables(x, y, weights, kept, held)
    found = chordal.folded_intensity(Namespace.of(None), kernels, waves, (over, along))
    assert np.abs(found - np.abs(exact).reshape(2, -1) ** 2).max() < 1e-13 * np.abs(exact).max() ** 2
