"""Restoration by total variation."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize

from lommel import Lens, Noise
from lommel.deconvolve.algorithms import NOISE, STEPS, search
from lommel.deconvolve.iterations import Background, VariationIteration, iterated
from lommel.deconvolve.likelihood import PhotographLikelihood
from lommel.imaging import DepthBlur, TotalVariation

LENS = Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)


def _blur(shape: tuple[int, int], depth: float = 2.3, channels: int = 1, pixel: float = 8e-6) -> DepthBlur:
    return DepthBlur(np.full(shape, depth), LENS, pixel, channels=(550e-9,) * channels, dtype=np.float64)


def _silent(*_: object) -> None:
    return None


def _blocks(seed: int = 0) -> np.ndarray:
    return np.kron(np.random.default_rng(seed).uniform(0.1, 0.9, (6, 7)), np.ones((8, 8)))


@pytest.mark.parametrize("channels", [1, 3])
def test_it_finds_the_minimum_that_another_solver_finds(channels: int) -> None:
    strength, white, s = 0.02, 300.0, 4.0 / 300.0
    shape = (8, 7, channels)[: 2 + (channels > 1)]
    blur = _blur((8, 7), 2.05, channels, pixel=16e-6)
    matrix = blur.as_linear_operator() @ np.eye(56 * channels)
    photo = np.clip(np.random.default_rng(2).random(shape), 0.05, None)
    photo[4, 4] = np.nan
    counts = PhotographLikelihood(blur, photo, Noise(white=white, read=2.0))
    iteration = VariationIteration(counts.operator, counts, background=Background(0.0))
    iteration._converge(strength, 3000, _silent, final=True)
    light = counts.operator.image(iteration.inside(0, 0))
    rounding = 0.01 * np.nanmean(photo)
    known = np.isfinite(photo).ravel()
    y = np.where(known, photo.ravel() + s, 0.0)

    def value(x: np.ndarray) -> float:
        m = matrix @ x + s
        squares = np.zeros((8, 7))
        for axis in (0, 1):
            steps = np.diff(x.reshape(8, 7, channels), axis=axis)
            squares += np.pad((steps**2).sum(axis=2), [(0, int(k == axis)) for k in (0, 1)])
        rough = np.sqrt(squares + rounding**2).sum()
        return float(np.where(known, m - y * np.log(m), 0.0).sum() + strength * rough)

    start = np.full(photo.size, 0.5)
    best = minimize(value, start, method="L-BFGS-B", bounds=[(1e-9, None)] * photo.size,
                    options={"maxiter": 2000, "maxfun": 10**6, "ftol": 1e-13, "gtol": 1e-8}).x  # fmt: skip
    assert value(light.ravel()) <= value(best) + 2e-3
    assert value(light.ravel()) < value(np.full(photo.size, np.nanmean(photo))) - 0.01


def test_great_strength_leaves_a_flat_scene() -> None:
    observed = PhotographLikelihood(
        _blur((10, 12)), np.random.default_rng(3).random((10, 12)), Noise(white=500.0, read=0.0)
    )
    light = iterated(TotalVariation(strength=1.0, steps=1500), observed, _silent).light
    # Columns of a blur with mirrored edges sum to 1, so that a flat scene has the light of the photograph.
    # Gradients below 0.01 of it count by their squares, so that it is flat to within that.
    np.testing.assert_allclose(light, observed.counts.mean(), rtol=1e-2)


def test_the_noise_says_how_strong_it_is() -> None:
    blur, scene = _blur((48, 56)), _blocks()
    for white in (500.0, 20000.0):
        noise = Noise(white=white, read=3.0)
        observed = PhotographLikelihood(blur, noise.record(white * blur.forward(scene), seed=4), noise)
        told: list[tuple[int, float, float]] = []
        found = iterated(TotalVariation(), observed, lambda *at, told=told: told.append(at))
        assert observed.mean(observed.discrepancies_of(found.light)) == pytest.approx(0.9, abs=0.06)
        assert (found.stopped, found.steps) == (NOISE, len(told) - 1)
        assert [at[0] for at in told] == list(range(len(told)))
        assert found.strength == pytest.approx(0.15 / np.sqrt(white * scene.mean()), rel=0.8)
        error, before = (np.sqrt(np.mean((light - scene) ** 2)) for light in (found.light, observed.image))
        assert error < 0.85 * before


def test_a_flat_scene_stays_flat() -> None:
    noise = Noise(white=1000.0, read=3.0)
    observed = PhotographLikelihood(_blur((48, 56)), noise.record(np.full((48, 56), 400.0), seed=6), noise)
    found = iterated(TotalVariation(), observed, _silent)
    assert (found.steps, found.stopped, found.strength) == (0, NOISE, None)
    assert not np.ptp(found.light)


def test_what_is_smoothed_beyond_the_noise_is_not_stopped_by_it() -> None:
    noise, scene = Noise(white=20000.0, read=3.0), _blocks()
    blur = _blur((48, 56))
    observed = PhotographLikelihood(blur, noise.record(20000.0 * blur.forward(scene), seed=4), noise)
    found = iterated(TotalVariation(strength=4.0 * 0.15 / np.sqrt(20000.0 * scene.mean())), observed, _silent)
    assert 1.0 + observed.slack < observed.mean(observed.discrepancies_of(found.light)) < 1.5
    assert found.stopped == STEPS


@pytest.mark.parametrize(
    "discrepancy", [lambda s: 1.5 if s > 0.45 else 0.2, lambda s: 0.2 + s], ids=["a step", "a line"]
)
def test_the_strength_that_is_reported_is_that_of_the_last_steps(discrepancy):
    tried = []

    def settle(strength):
        tried.append(strength)
        return discrepancy(strength)

    found, strength = search(settle, 1.0, 0.9, 1e-3)
    assert strength == tried[-1]
    assert found == discrepancy(strength)
    assert len(tried) <= 6
