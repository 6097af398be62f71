"""Derivatives of images by Zernike coefficients keep their bounds, and their reverse is the sum over them."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import lommel as lm
from lommel import _core
from lommel.core.answers import Wanted
from lommel.core.engine import DiskStack, Window, chordal_gradient, chordal_images
from lommel.methods import ChordalGauss
from lommel.optics.grid import Grid
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

TERMS = [zernike.term(j, "noll") for j in range(2, 29)]  # n from 1 to 6
LEVELS = ["portable", "avx2", "avx512"]


@pytest.fixture
def instructions():
    yield _core.limit_instructions
    _core.limit_instructions("avx512")


def quadrature(stack: DiskStack, window: Window, terms: list[tuple[int, int]]) -> tuple[np.ndarray, np.ndarray]:
    """Return I and its derivatives, by direct quadrature of P and of i Z P in polar coordinates."""
    r, w = gauss_legendre(60, stack.obscuration, 1.0)
    theta = 2.0 * math.pi * (np.arange(180) + 0.5) / 180
    rho, angle = np.broadcast_arrays(r[:, None], theta)
    light = (2.0 / 180 * w * r)[:, None] * np.exp(-np.polynomial.polynomial.polyval(rho**2, stack.amplitude))
    x, y = (rho * np.cos(angle)).ravel(), (rho * np.sin(angle)).ravel()
    count, (height, width) = len(stack.edge), window.shape
    centers = window.center if isinstance(window.center, np.ndarray) else np.tile(window.center, (count, 1))

    @cache
    def waves(row: float, column: float) -> tuple[np.ndarray, np.ndarray]:
        across = np.exp(-1j * np.outer(x, window.step * (np.arange(width) - column)))
        return np.exp(-1j * np.outer(y, window.step * (np.arange(height) - row))), across

    own = np.array([zernike.polynomial(n, m, rho, angle) for n, m in stack.terms.tolist()])
    factors = np.array([np.ones_like(rho), *(1j * zernike.polynomial(n, m, rho, angle) for n, m in terms)])
    found = []
    for coefficients, (row, column) in zip(stack.edge, centers, strict=True):
        pupil = factors * light * np.exp(1j * np.tensordot(coefficients, own, 1))
        down, across = waves(row, column)
        fields = np.array([(each.ravel()[:, None] * down).T @ across for each in pupil])
        found.append(fields)
    fields = np.swapaxes(found, 0, 1)
    return np.abs(fields[0]) ** 2, 2.0 * (fields[0].conj() * fields[1:]).real


def question(seed: int, obscuration: float, own_axes: bool) -> tuple[DiskStack, Window, list[tuple[int, int]]]:
    rng = np.random.default_rng(seed)
    count, shape = int(rng.integers(1, 20)), tuple(rng.integers(1, 12, 2).tolist())
    chosen = [TERMS[i] for i in rng.choice(len(TERMS), int(rng.integers(1, 7)), replace=False)]
    wanted = [TERMS[i] for i in rng.choice(len(TERMS), int(rng.integers(1, 16)), replace=False)]
    edge = rng.normal(size=(count, len(chosen))) * rng.choice([0.0, 0.3, 1.0, 2.0])
    stack = DiskStack(np.array(chosen, np.int32), edge, obscuration, np.array([0.0, rng.choice([0.0, 1.5])]))
    # In the middle of the window, between pixels, or beside.
    center = rng.uniform(0.0, 8.0, (count, 2)) if own_axes else rng.choice([1.0, 2.5, rng.uniform(0.0, 8.0)], 2)
    return stack, Window(shape, center if own_axes else tuple(center.tolist()), rng.uniform(0.3, 1.6)), wanted


@settings(max_examples=60)
@example(8, 0.0, False, 1e-6, np.float32, "avx512")
@example(9, 0.7, True, 1e-9, np.float64, "avx2")
@given(
    seed=st.integers(0, 2**32 - 1),
    obscuration=st.sampled_from([0.0, 0.3, 0.7]),
    own_axes=st.booleans(),
    tol=st.sampled_from([1e-4, 1e-6, 1e-9]),
    dtype=st.sampled_from([np.float32, np.float64]),
    level=st.sampled_from(LEVELS),
)
def test_derivatives_agree_with_direct_quadrature_within_bounds_that_are_of_use(
    seed, obscuration, own_axes, tol, dtype, level
):
    stack, window, terms = question(seed, obscuration, own_axes)
    tol = max(tol, 1e-6 if dtype == np.float32 else 0.0)
    _core.limit_instructions(level)
    try:
        made = chordal_images(stack, window, tol, Wanted(2.0, dtype, threads=1, terms=tuple(terms)))
    except lm.ToleranceError:
        return  # a window that no light reaches
    finally:
        _core.limit_instructions("avx512")
    exact, slopes = quadrature(stack, window, terms)
    peak = exact.max(axis=(1, 2))
    error = np.abs(0.5 * made.slopes.values.astype(float) - slopes).max(axis=(2, 3)) / peak
    assert np.all(error <= made.slopes.error + 1e-13)
    # By |D| over the root of the peak, which is large of windows that are dark.
    sizes = np.maximum(1.0, 1.0 / np.sqrt(peak))
    assert np.all(made.slopes.error <= 4.0 * tol * sizes)
    assert np.all(made.error <= tol)
    assert np.all(np.abs(0.5 * made.values.astype(float) - exact).max(axis=(1, 2)) <= (made.error + 1e-13) * peak)


@settings(max_examples=40)
@given(st.integers(0, 2**32 - 1), st.sampled_from([0.0, 0.4]), st.booleans(), st.sampled_from(LEVELS))
def test_the_gradient_is_the_sum_over_derivatives(seed, obscuration, own_axes, level):
    stack, window, terms = question(seed, obscuration, own_axes)
    weights = np.random.default_rng(seed).normal(size=(len(stack.edge), *window.shape))
    _core.limit_instructions(level)
    try:
        slopes = chordal_images(stack, window, 1e-5, Wanted(threads=1, terms=tuple(terms))).slopes.values
        found = chordal_gradient(stack, window, 1e-5, weights, tuple(terms), 1)
    except lm.ToleranceError:
        return
    finally:
        _core.limit_instructions("avx512")
    size = np.abs(weights).sum(axis=(1, 2)).max()
    assert found == pytest.approx(np.einsum("knyx,nyx->nk", slopes, weights), rel=0, abs=1e-14 * size)


def differences(images, edge: dict, term: tuple[int, int], step: float = 0.01) -> np.ndarray:
    """Return the derivative by a coefficient by central differences of fourth and, once extrapolated, sixth order."""

    def at(h: float) -> np.ndarray:
        return images(edge | {term: edge.get(term, 0.0) + h})

    def slope(h: float) -> np.ndarray:
        return (8.0 * (at(h) - at(-h)) - at(2.0 * h) + at(-2.0 * h)) / (12.0 * h)

    return (16.0 * slope(step) - slope(2.0 * step)) / 15.0


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize("kind", ["plain", "obscured", "apodized", "own axes"])
@pytest.mark.parametrize("pixel", [0.4, 1.7])
def test_derivatives_agree_with_differences_of_exact_images(kind, integrate, pixel):
    rng = np.random.default_rng([int(integrate), len(kind), int(10 * pixel)])
    edge = {TERMS[i]: rng.normal(size=3) for i in rng.choice(len(TERMS), 6, replace=False)}
    edge = {term: 3.0 * c / math.sqrt(len(edge)) / zernike.rms_factor(*term) for term, c in edge.items()}
    light = {"obscured": {"obscuration": 0.4}, "apodized": {"apodization": 2.0}}.get(kind, {})
    center = (np.array([4.0, 4.3, 5.0]), np.array([3.0, 3.6, 2.0])) if kind == "own axes" else (4.2, 3.0)
    grid = Grid((9, 8), pixel, center=center, integrate=integrate)
    # Of the wavefront and not, tilts among them.
    terms = (*list(edge)[:2], *(t for t in [(1, 1), (1, -1), (2, 0), (5, 3)] if t not in edge))

    def pupil(edge: dict) -> lm.Pupil:
        return lm.Pupil(wavefront=lm.Wavefront.zernike(edge, normalization="edge"), **light)

    def images(edge: dict) -> np.ndarray:
        return ChordalGauss(2e-11).images(pupil(edge), grid, Wanted(1.5)).values

    exact = np.array([differences(images, edge, term) for term in terms])
    for tol, dtype in ((1e-9, np.float64), (1e-4, np.float32), (1e-4, np.float64)):
        made = ChordalGauss(tol).images(pupil(edge), grid, Wanted(1.5, dtype, terms=terms))
        peak = 1.5 * images(edge).max(axis=(1, 2)) / 1.5
        error = np.abs(made.slopes.values.astype(float) - exact).max(axis=(2, 3)) / peak
        assert np.all(error <= made.slopes.error + 2e-9)
        assert np.all(made.slopes.error <= 6.0 * tol)


@pytest.mark.parametrize("integrate", [False, True])
def test_the_gradient_of_averages_is_the_sum_over_derivatives_too(integrate):
    rng = np.random.default_rng(5)
    terms = ((2, 0), (3, -1), (4, 4), (1, 1))
    wavefront = lm.Wavefront.zernike({t: rng.normal(size=4) for t in terms[:3]}, normalization="edge")
    pupil, grid = lm.Pupil(wavefront=wavefront, obscuration=0.3), Grid((7, 9), 1.1, integrate=integrate)
    weights, method = rng.normal(size=(4, 7, 9)), ChordalGauss(1e-10)
    slopes = method.images(pupil, grid, Wanted(terms=terms)).slopes.values
    found = method.gradient(pupil, grid, weights, terms)
    assert found == pytest.approx(np.einsum("knyx,nyx->nk", slopes, weights), rel=0, abs=1e-9)


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.parametrize("count", [1, 2, 3, 5, 8, 9, 16, 17, 33])
def test_derivatives_do_not_depend_on_who_is_beside(count, level, instructions):
    instructions(level)
    rng = np.random.default_rng(count)
    stack = DiskStack(np.array(TERMS[:8], np.int32), rng.normal(size=(count, 8)), 0.2, np.zeros(1))
    window, terms = Window((6, 7), (2.0, 3.3), 0.8), tuple(TERMS[1:14])
    for dtype, tol, near in ((np.float64, 1e-8, 1e-8), (np.float32, 1e-4, 1e-4)):
        every = chordal_images(stack, window, tol, Wanted(1.0, dtype, terms=terms))
        for p in {0, count // 2, count - 1}:
            one = chordal_images(
                stack._replace(edge=stack.edge[p : p + 1].copy()), window, tol, Wanted(1.0, dtype, terms=terms)
            )
            assert every.slopes.values[:, p] == pytest.approx(one.slopes.values[:, 0], rel=0, abs=near)
        for k, term in enumerate(terms):
            alone = chordal_images(stack, window, tol, Wanted(1.0, dtype, terms=(term,)))
            assert every.slopes.values[k] == pytest.approx(alone.slopes.values[0], rel=0, abs=near)


@pytest.mark.parametrize(
    ("terms", "message"),
    [
        (((2, 1),), "no such Zernike term"),
        (((2, 0), (2, 0)), "a Zernike term comes twice"),
        (((0, 0),), "no image depends on a constant"),
    ],
)
def test_terms_that_are_none_are_refused(terms, message):
    stack, window = (
        DiskStack(np.array([[2, 0]], np.int32), np.ones((1, 1)), 0.0, np.zeros(1)),
        Window((3, 3), (1.0, 1.0), 1.0),
    )
    with pytest.raises(ValueError, match=message):
        chordal_images(stack, window, 1e-6, Wanted(terms=terms))
    with pytest.raises(ValueError, match=message):
        chordal_gradient(stack, window, 1e-6, np.ones((1, 3, 3)), terms, 0)


def test_values_that_are_divided_by_their_largest_one_have_no_derivatives():
    with pytest.raises(ValueError, match="derivatives of values divided by their largest one"):
        ChordalGauss().images(lm.Pupil(), Grid(3, 1.0), Wanted(None, terms=((2, 0),)))
