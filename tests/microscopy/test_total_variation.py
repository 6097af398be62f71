"""Total variation of stacks: the minimum of the objective, edges at low light, voxels that are longer than wide."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize

import lommel as lm
from lommel.microscopy.stack_blur import TiledBlur
from lommel.microscopy.stack_steps import Background, Counted
from lommel.microscopy.total_variation import VariationWalk

NOISE = lm.Noise(read=1.0)
SHAPE = (4, 6, 7)
KERNEL = np.exp(-np.add.reduce(np.square(np.indices((3, 3, 3)) - 1.0)))
KERNEL /= KERNEL.sum()


def small(aspect=0.5, seed=0):
    """Return steps on a stack so small that other methods can be asked, and the stack."""
    truth = np.full(SHAPE, 5.0)
    truth[1:3, 2:5, 1:4] = 60.0
    stack = np.random.default_rng(seed).poisson(truth).astype(np.float32)
    blur, counted = TiledBlur([KERNEL], SHAPE, (0, 0)), Counted(stack, NOISE)
    return VariationWalk(blur, counted, background=Background(0.0), aspect=aspect), stack


def matrix():
    """Return the blur as a matrix."""
    blur, columns = TiledBlur([KERNEL], SHAPE, (0, 0)), []
    for one in np.eye(int(np.prod(SHAPE)), dtype=np.float32).reshape(-1, *SHAPE):
        made = np.zeros(SHAPE)
        blur.forward(lambda *at, one=one: one[at], lambda p, r, c, v, made=made: made.__setitem__((p, r, c), v))
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
    best = minimum(stack, strength, aspect, float(walk._round))
    assert walk.objectives[-1] == pytest.approx(best, rel=2e-3)
    plain, _ = small(aspect)
    plain._strength = strength
    for _ in range(30):
        plain._look(0.0)
        plain._step()
    assert np.diff(plain.objectives).max() < 1e-6 * plain.objectives[0]
    assert best < plain.objectives[-1] < 1.05 * best
