"""The sums of float32 traced plans by the compiled core: those of the framework, within its bounds."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel import _core
from lommel.optics.grid import Grid
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre
from lommel.traced import chordal
from traced_windows import CASES, EDGE, by_steps, pupils, traced

KINDS = pytest.mark.parametrize("case", CASES.values(), ids=CASES)
NOLL = [zernike.term(j, "noll") for j in range(2, 46)]  # n from 1 to 8


@KINDS
def test_the_core_takes_the_same_chords_and_nodes_as_images_of_too_few_of_them_show(case):
    f = traced(case, 0.1 * EDGE)
    shape, options, light = case
    far = pupils(4.0 * EDGE, **light)
    for c in (0.25 * far.wavefront.edge, far.wavefront.edge):
        told, bound = f.error(c), by_steps(f).error(c)
        values, expect = f.evaluated(c)[0], by_steps(f).evaluated(c)[0]
        assert np.abs(values - expect).max() < 2e-6 * expect.max()
        assert np.allclose(told, bound, rtol=1e-4)
    right = lm.psf(far, shape, tol=1e-9, dtype=np.float64, **options).values
    wrong = np.abs(values - right.transpose(0, 2, 1).reshape(len(right), -1)).max()
    assert wrong > 1e-4 * right.max()


def test_only_what_the_core_has_is_asked_of_it():
    def sums(case, **options):
        return traced((case[0], case[1] | options, case[2]), EDGE)._static.lights[0][1].sums

    assert sums(CASES["odd"]) is not None
    assert sums(CASES["odd"], integrate=True) is None
    assert sums(CASES["white"]).stretch != 1.0
    assert lm.Plan(5, 0.5).traced(pupils(EDGE))._static.lights[0][1].sums is None
    pupil, terms = pupils(EDGE), ((2, 0),)
    assert chordal.compiled_sums(pupil, Grid(3, 0.5), 1.0, terms, (4, 4)) is not None
    assert chordal.compiled_sums(pupil, Grid(3, (0.5, 0.6)), 1.0, terms, (4, 4)) is None
    assert chordal.compiled_sums(pupil, Grid(3, 0.5), 1.0, ((32, 0),), (4, 4)) is None
    assert chordal.compiled_sums(pupil, Grid(3, 0.5), 1.0, ((0, 0),), (4, 4)) is None


def polar(pupil, grid):
    """Return I over the strength of the light, by a rule in the radius and the angle."""
    r, w = gauss_legendre(90, pupil.obscuration, 1.0)
    theta = 2.0 * math.pi * (np.arange(240) + 0.5) / 240
    x, y = np.outer(r, np.cos(theta)).ravel(), np.outer(r, np.sin(theta)).ravel()
    values = pupil.values(x, y) * np.repeat(2.0 / 240 * w * r, 240)
    across, down = np.exp(-1j * np.pi * np.outer(x, grid.x)), np.exp(-1j * np.pi * np.outer(grid.y, y))
    return np.abs(np.stack([(down * one) @ across for one in values])) ** 2 / pupil.amplitude**2


def test_no_error_of_random_pupils_exceeds_what_the_framework_proves():
    draw, close = np.random.default_rng(4), []
    for _ in range(12):
        terms = [NOLL[i] for i in draw.choice(len(NOLL), size=12, replace=False)]
        c = draw.normal(size=(20, 12)) * draw.uniform(0.1, 0.6, (20, 1))
        low, light = float(draw.choice([0.0, 0.4])), float(draw.choice([0.0, 1.5]))
        grid = Grid(tuple(map(int, draw.integers(4, 20, 2))), 0.5)
        wavefront = lm.Wavefront.zernike(dict(zip(terms, c.T, strict=True)))
        pupil = lm.Pupil(wavefront, obscuration=low, apodization=light)
        plan = lm.Plan(grid.shape, 0.5, tol=10.0 ** -draw.uniform(1.0, 2.5), normalize="strehl")
        images, bound = plan.traced(pupil, precision="float32").certified(pupil.wavefront.edge)
        exact = polar(pupil, grid)
        error = np.abs(images - exact).max(axis=(1, 2)) / exact.max(axis=(1, 2))
        assert np.all(error <= bound)
        close += (error / bound).tolist()
    assert max(close) > 1e-3


def test_gradients_are_those_of_the_rule_in_double_precision():
    grid, pupil = Grid((5, 6), 0.5, center=(1.3, 4.0)), pupils(EDGE[:2], obscuration=0.3, apodization=0.7)
    c = pupil.wavefront.edge
    sums = chordal.compiled_sums(pupil, grid, 1.0, tuple(map(tuple, pupil.wavefront.indices.tolist())), (40, 40))
    weights = np.random.default_rng(0).normal(size=(2, 5, 6))
    by_column = weights.transpose(0, 2, 1).reshape(2, -1)
    exact = lm.methods.ChordalGauss(1e-9).gradient(pupil, grid, weights, sums.terms)
    assert np.abs(sums.gradient(c, by_column, 1) - exact).max() < 1e-5 * np.abs(exact).max()
    wide = sums._replace(stretch=1.3).gradient(c, by_column, 1)
    expect = 1.3 * sums._replace(step=1.3 * sums.step).gradient(1.3 * c, by_column, 1)
    assert np.abs(wide - expect).max() < 1e-6 * np.abs(expect).max()


@pytest.mark.parametrize("level", ["portable", "avx2", "avx512"])
def test_sums_do_not_depend_on_threads_and_hardly_on_instructions(level):
    f = traced(CASES["even and oblong"], EDGE)
    sums, c = f._static.lights[0][1].sums, np.random.default_rng(1).normal(size=(37, 6))
    weights = np.random.default_rng(2).normal(size=(37, 40))
    images, slopes = sums.intensity(c, 1), sums.gradient(c, weights, 1)
    _core.limit_instructions(level)
    try:
        there, turned = sums.intensity(c, 1), sums.gradient(c, weights, 1)
        assert np.array_equal(sums.intensity(c, 3), there)
        assert np.array_equal(sums.gradient(c, weights, 3), turned)
    finally:
        _core.limit_instructions("avx512")
    assert np.abs(there - images).max() < 2e-6 * images.max()
    assert np.abs(turned - slopes).max() < 1e-5 * np.abs(slopes).max()


def test_coefficients_that_are_no_numbers_leave_their_neighbours_alone():
    f = traced(CASES["odd"], EDGE)
    c = np.concatenate([EDGE, np.full((4, 6), [[np.nan], [np.inf], [1e30], [-1e9]])])
    with np.errstate(invalid="ignore", over="ignore"):
        images, bound = f.certified(c, check=False)
    assert np.array_equal(images[:3], f(EDGE))
    assert np.isnan(images[3:]).all()
    assert np.isinf(bound[3:]).all()
    assert f(np.zeros((0, 6))).shape == (0, 9, 9)
