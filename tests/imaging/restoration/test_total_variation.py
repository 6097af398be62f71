"""Restoration by total variation."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize

from lommel import Lens, Noise
from lommel.imaging import DepthBlur, TotalVariation
from lommel.imaging.deconvolution import MISFIT, NOISE, STEPS, Observed, _gradient, _gradient_transposed, _shorten

LENS = Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)


def _blur(shape: tuple[int, int], depth: float = 2.3, channels: int = 1, pixel: float = 8e-6) -> DepthBlur:
    return DepthBlur(np.full(shape, depth), LENS, pixel, channels=(550e-9,) * channels, dtype=np.float64)


def _silent(*_: object) -> None:
    return None


def _blocks(seed: int = 0) -> np.ndarray:
    return np.kron(np.random.default_rng(seed).uniform(0.1, 0.9, (6, 7)), np.ones((8, 8)))


@pytest.mark.parametrize("shape", [(5, 7), (1, 6), (6, 1), (5, 4, 3)])
def test_the_gradient_has_its_transpose(shape: tuple[int, ...]) -> None:
    rng = np.random.default_rng(0)
    image, slopes = rng.random(shape), rng.random((2, *shape))
    assert np.vdot(_gradient(image), slopes) == pytest.approx(np.vdot(image, _gradient_transposed(slopes)), rel=1e-12)
    ramp = np.multiply.outer(np.arange(5.0), np.ones(4))
    np.testing.assert_array_equal(_gradient(ramp)[:, :-1], [np.ones((4, 4)), np.zeros((4, 4))])
    assert not _gradient(ramp)[:, -1].any()


def test_vectors_of_all_channels_together_are_shortened() -> None:
    slopes = np.random.default_rng(1).normal(size=(2, 6, 5, 3))
    before = slopes.copy()
    _shorten(slopes, 1.5)
    length, was = (np.sqrt((part**2).sum(axis=(0, 3))) for part in (slopes, before))
    np.testing.assert_allclose(length, np.minimum(was, 1.5), rtol=1e-12)
    np.testing.assert_allclose(slopes * was[..., None], before * length[..., None], atol=1e-12)


def test_it_finds_the_minimum_that_another_solver_finds() -> None:
    shape, strength, white, s = (8, 7), 0.02, 300.0, 4.0 / 300.0
    blur = _blur(shape, 2.05, pixel=16e-6)
    matrix = blur.as_linear_operator() @ np.eye(56)
    photo = np.clip(np.random.default_rng(2).random(shape), 0.05, None)
    photo[4, 4] = np.nan
    observed = Observed.of(blur, photo, Noise(white=white, read=2.0))
    found = TotalVariation(strength=strength, steps=4000)
    light = found.solve(observed, _silent).light
    known = np.isfinite(photo).ravel()
    y = np.where(known, photo.ravel() + s, 0.0)

    def value(x: np.ndarray, soft: float = 0.0) -> float:
        m = matrix @ x + s
        down, right = np.diff(x.reshape(shape), axis=0, append=0.0), np.diff(x.reshape(shape), axis=1, append=0.0)
        down[-1], right[:, -1] = 0.0, 0.0
        rough = np.sqrt(down**2 + right**2 + soft).sum()
        return float(np.where(known, m - y * np.log(m), 0.0).sum() + strength * rough)

    start = np.full(56, 0.5)
    for soft in (1e-4, 1e-6, 1e-8, 1e-10):
        start = minimize(value, start, (soft,), "L-BFGS-B", bounds=[(0.0, None)] * 56,
                         options={"maxiter": 2000, "maxfun": 10**6, "ftol": 1e-14, "gtol": 1e-9}).x  # fmt: skip
    assert value(light.ravel()) <= value(start) + 1e-5
    assert value(light.ravel()) < value(np.full(56, np.nanmean(photo))) - 0.01


def test_great_strength_leaves_a_flat_scene() -> None:
    observed = Observed.of(_blur((10, 12)), np.random.default_rng(3).random((10, 12)), Noise(white=500.0, read=0.0))
    light = TotalVariation(strength=1.0, steps=1500).solve(observed, _silent).light
    # Columns of a blur with mirrored edges sum to 1, so that a flat scene has the light of the photograph.
    np.testing.assert_allclose(light, observed.counts.mean(), rtol=5e-3)


def test_the_noise_says_how_strong_it_is() -> None:
    blur, scene = _blur((48, 56)), _blocks()
    for white in (500.0, 20000.0):
        noise = Noise(white=white, read=3.0)
        observed = Observed.of(blur, noise.record(white * blur.forward(scene), seed=4), noise)
        told: list[tuple[int, float, float]] = []
        found = TotalVariation().solve(observed, lambda *at, told=told: told.append(at))
        model = observed.model(found.light)
        assert observed.discrepancy(model, observed.ratio(model)) == pytest.approx(0.9, abs=0.06)
        assert (found.stopped, found.steps) == (NOISE, len(told))
        assert [at[0] for at in told] == list(range(1, len(told) + 1))
        assert found.strength == pytest.approx(0.15 / np.sqrt(white * scene.mean()), rel=0.8)
        error, before = (np.sqrt(np.mean((light - scene) ** 2)) for light in (found.light, observed.image))
        assert error < 0.85 * before


def test_a_wrong_depth_is_told_and_the_result_stays_smooth() -> None:
    blur, scene, noise = _blur((48, 56), 2.5), _blocks(), Noise(white=40000.0, read=3.0)
    photo = noise.record(40000.0 * blur.forward(scene), seed=5)
    found = TotalVariation().solve(Observed.of(_blur((48, 56), 2.8), photo, noise), _silent)
    assert found.stopped == MISFIT
    assert found.strength == pytest.approx(0.15 / np.sqrt(40000.0 * photo.mean()), rel=0.01)


def test_a_flat_scene_stays_flat() -> None:
    noise = Noise(white=1000.0, read=3.0)
    observed = Observed.of(_blur((48, 56)), noise.record(np.full((48, 56), 400.0), seed=6), noise)
    found = TotalVariation().solve(observed, _silent)
    assert (found.steps, found.stopped, found.strength) == (0, NOISE, None)
    assert not np.ptp(found.light)


@pytest.mark.parametrize(("name", "value"), [("steps", 0), ("strength", 0.0), ("strength", "much"), ("target", 0.0)])
def test_arguments_out_of_range_are_refused(name: str, value: object) -> None:
    with pytest.raises((TypeError, ValueError), match=name):
        TotalVariation(**{name: value})


def test_what_is_smoothed_beyond_the_noise_is_not_stopped_by_it() -> None:
    noise, scene = Noise(white=20000.0, read=3.0), _blocks()
    blur = _blur((48, 56))
    observed = Observed.of(blur, noise.record(20000.0 * blur.forward(scene), seed=4), noise)
    found = TotalVariation(strength=4.0 * 0.15 / np.sqrt(20000.0 * scene.mean())).solve(observed, _silent)
    model = observed.model(found.light)
    assert 1.0 + observed.slack < observed.discrepancy(model, observed.ratio(model)) < 1.5
    assert found.stopped == STEPS
