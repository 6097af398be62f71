"""Total variation of stacks: the minimum of the objective, edges at low light, voxels that are longer than wide."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize

import lommel as lm
from lommel.deconvolve.iterations import Background, VariationIteration, iteration_of
from lommel.deconvolve.likelihood import PoissonLikelihood
from lommel.microscopy.stack_blur import TiledBlur

NOISE = lm.Noise(read=1.0)
SHAPE = (4, 6, 7)
KERNEL = np.exp(-np.add.reduce(np.square(np.indices((3, 3, 3)) - 1.0)))
KERNEL /= KERNEL.sum()


def small(aspect=0.5, seed=0):
    """Return steps on a stack so small that other methods can be asked, and the stack."""
    truth = np.full(SHAPE, 5.0)
    truth[1:3, 2:5, 1:4] = 60.0
    stack = np.random.default_rng(seed).poisson(truth).astype(np.float32)
    blur, counted = TiledBlur([KERNEL], SHAPE, (0, 0)), PoissonLikelihood(stack, NOISE)
    return VariationIteration(blur, counted, background=Background(0.0), aspect=aspect), stack


def matrix():
    """Return the blur as a matrix."""
    blur, columns = TiledBlur([KERNEL], SHAPE, (0, 0)), []
    for one in np.eye(int(np.prod(SHAPE)), dtype=np.float32).reshape(-1, *SHAPE):
        made = np.zeros(SHAPE)
        blur.forward(one, lambda p, r, c, v, made=made: made.__setitem__((p, r, c), v))
        columns.append(made.ravel())
    return np.array(columns).T


def minimum(stack, strength, aspect, rounding):
    """Return the least objective, from its definition and by another method."""
    blur, counts = matrix(), stack.ravel() + 1.0  # with the variance of reading
    rows = [np.zeros((0, counts.size))]
    for axis, per in enumerate((aspect, 1.0, 1.0)):
        each = np.eye(counts.size).reshape(*SHAPE, -1)
        rows.append(per * np.diff(each, axis=axis, append=np.take(each, [-1], axis)).reshape(-1, counts.size))
    slopes = np.concatenate(rows)

    def objective(light):
        model, steep = blur @ light + 1.0, slopes @ light
        long = np.sqrt(np.square(steep.reshape(3, -1)).sum(axis=0) + rounding**2)
        value = (model - counts + counts * np.log(counts / model)).sum() + strength * long.sum()
        return value, blur.T @ (1.0 - counts / model) + strength * slopes.T @ (steep / np.tile(long, 3))

    start, bounds = np.full(counts.size, stack.mean()), [(1e-6, None)] * counts.size
    options = {"maxiter": 3000, "ftol": 1e-13}
    return minimize(objective, start, jac=True, method="L-BFGS-B", bounds=bounds, options=options).fun


@pytest.mark.parametrize("aspect", [0.4, 1.0])
def test_steps_reach_the_minimum_and_plain_ones_never_go_up(aspect):
    strength = 0.05
    walk, stack = small(aspect)
    walk.solve(lm.imaging.TotalVariation(strength=strength, steps=400), lambda *_: None)
    best = minimum(stack, strength, aspect, float(walk._rounding))
    assert walk.objectives[-1] == pytest.approx(best, rel=2e-3)
    plain, _ = small(aspect)
    for _ in range(30):
        plain._evaluate(0.0, strength)
        plain._step()
    assert np.diff(plain.objectives).max() < 1e-6 * plain.objectives[0]
    assert best < plain.objectives[-1] < 1.05 * best


def test_edges_at_low_light_are_restored_better_than_at_the_best_of_richardson_lucy_steps():
    shape, width = (10, 24, 24), np.exp(-np.square(np.arange(-4, 5)) / 6.0)
    kernel = width[2:7, None, None] * width[:, None] * width / (width[2:7].sum() * width.sum() ** 2)
    z, y, x = np.indices(shape) - np.array([5, 12, 11])[:, None, None, None]
    away = np.sqrt((2.0 * z) ** 2 + y**2 + x**2)
    truth = np.where((away < 9.0) & (away > 4.0), 40.0, 0.0).astype(np.float32)
    blur = TiledBlur([kernel], shape, (0, 0))
    image = np.zeros(shape)
    blur.forward(truth, lambda p, r, c, v: image.__setitem__((p, r, c), v))
    counted = PoissonLikelihood(NOISE.record(np.maximum(image, 0.0) + 1.0, seed=1), NOISE)

    def error(method):
        walk = iteration_of(method, blur, counted, background=Background(1.0), aspect=0.5)
        _, stopped, _ = walk.solve(method, lambda *_: None)
        return float(np.linalg.norm(walk.inside(0, 0) - truth) / np.linalg.norm(truth)), stopped, walk

    best = min(error(lm.imaging.RichardsonLucy(steps=n, target=0.0))[0] for n in (3, 5, 8, 12, 18, 27))
    found, stopped, walk = error(lm.imaging.TotalVariation(target=1.0))
    assert stopped == "noise"
    assert walk.strength is not None
    assert found < 0.9 * best


def test_another_part_follows_the_course_of_the_first_to_the_last_bit():
    walk, _ = small()
    walk.solve(lm.imaging.TotalVariation(strength=0.05, steps=8), lambda *_: None)
    blur, counted = TiledBlur([KERNEL], SHAPE, (0, 0)), walk._counted
    again = VariationIteration(blur, counted, walk.course, background=Background(0.0), aspect=0.5)
    steps, _, _ = again.solve(lm.imaging.TotalVariation(), lambda *_: None)
    assert (steps, again.strength) == (8, 0.05)
    np.testing.assert_array_equal(again.inside(0, 0), walk.inside(0, 0))
