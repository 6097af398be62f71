"""The iteration of Richardson and Lucy."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from lommel import Lens, Noise
from lommel.deconvolve.algorithms import MISFIT, NOISE, STEPS, StoppingRule, is_misfit
from lommel.deconvolve.iterations import Solution, iterated
from lommel.deconvolve.likelihood import PhotographLikelihood
from lommel.imaging import DepthBlur, Occlusion, RichardsonLucy

LENS = Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
DEPTH = np.full((48, 56), 2.5)
DEPTH[:, 24:] = 2.1


def _blur(scale: float = 1.0) -> Occlusion:
    return Occlusion(DepthBlur(scale * DEPTH, LENS, 8e-6, dtype=np.float64))


def _scene(seed: int = 0) -> np.ndarray:
    """Return a scene with edges and fine bars."""
    scene = np.kron(np.random.default_rng(seed).uniform(0.1, 0.8, (6, 7)), np.ones((8, 8)))
    scene[20:28] *= 1.0 + 0.5 * (-1.0) ** (np.arange(56) // 2)
    return np.clip(scene, 0.02, 1.0)


def _observed(blur: Occlusion, scene: np.ndarray, white: float = 4000.0, read: float = 3.0) -> PhotographLikelihood:
    noise = Noise(white=white, read=read)
    return PhotographLikelihood(blur, noise.record(white * blur.forward(scene), seed=1), noise)


def _solve(method: RichardsonLucy, observed: PhotographLikelihood) -> tuple[Solution, list[tuple[int, float, float]]]:
    told: list[tuple[int, float, float]] = []
    return iterated(method, observed, lambda *at: told.append(at)), told


def test_a_step_is_the_quotient_of_two_products_with_a_matrix() -> None:
    blur = DepthBlur(np.full((9, 8), 2.1), LENS, 16e-6, dtype=np.float64)
    matrix = blur.as_linear_operator() @ np.eye(72)
    rng = np.random.default_rng(2)
    photo, noise = rng.random((9, 8)), Noise(white=50.0, read=2.0)
    photo[2, 3] = np.nan
    observed = PhotographLikelihood(blur, photo, noise)
    found, _ = _solve(RichardsonLucy(steps=2, target=0.0, accelerate=False), observed)
    known = np.isfinite(photo).ravel()
    y, s = np.where(known, photo.ravel(), 0.0), 4.0 / 50.0
    x = np.full(72, photo.ravel()[known].mean())
    for _ in range(2):
        x = x * (matrix.T @ np.where(known, (y + s) / (matrix @ x + s), 0.0)) / (matrix.T @ known)
    np.testing.assert_allclose(found.light.ravel(), x, rtol=1e-12)
    assert (found.steps, found.stopped) == (2, STEPS)


def test_the_scene_itself_is_where_steps_end() -> None:
    blur, scene = _blur(), _scene()
    observed = PhotographLikelihood(blur, blur.forward(scene), Noise(white=1e7, read=1.0))
    misfit = np.empty((1, *scene.shape))
    observed.discrepancies(observed.operator, observed.operator.planes(scene), misfit)
    np.testing.assert_allclose(misfit, 0.0, atol=1e-12)


def test_without_read_noise_every_step_keeps_what_was_counted() -> None:
    observed = _observed(_blur(), _scene(), read=0.0)
    for steps in (1, 2, 7):
        light = _solve(RichardsonLucy(steps=steps, target=0.0, accelerate=False), observed)[0].light
        seen = observed.blur.adjoint(observed.weight)
        assert np.vdot(seen, light) == pytest.approx(observed.counts.sum(), rel=1e-12)


def test_steps_explain_ever_more_and_acceleration_needs_fewer_of_them() -> None:
    observed = _observed(_blur(), _scene(), white=40000.0)
    plain = [told[1] for told in _solve(RichardsonLucy(steps=60, target=0.0, accelerate=False), observed)[1]]
    assert all(later < before for before, later in pairwise(plain))
    fast = [told[1] for told in _solve(RichardsonLucy(steps=30, target=0.0), observed)[1]]
    assert fast[30] < plain[60]


def test_the_noise_stops_it_nearer_to_the_scene_than_many_steps_come() -> None:
    blur, scene = _blur(), _scene()
    observed = _observed(blur, scene)
    found, told = _solve(RichardsonLucy(), observed)
    assert (found.stopped, found.steps) == (NOISE, told[-1][0])
    assert told[-1][1] <= 0.9 < told[-2][1]
    late = _solve(RichardsonLucy(steps=200, target=0.0), observed)[0]

    def error(light: np.ndarray) -> float:
        return float(np.sqrt(np.mean((light - scene) ** 2)))

    assert error(found.light) < 0.85 * error(observed.image)
    assert error(found.light) < 0.6 * error(late.light)
    # It ends at the first step that is asked for, and says how long it will take: never less than nothing.
    assert all(left >= 0.0 for _, _, left in told)
    assert told[-1][2] == 0.0


@pytest.mark.parametrize("white", [100.0, 4e3, 1e5, 3e6])
def test_a_right_depth_is_never_called_wrong(white: float) -> None:
    assert _solve(RichardsonLucy(), _observed(_blur(), _scene(), white=white))[0].stopped in (NOISE, STEPS)


def test_a_flat_scene_stays_flat() -> None:
    found, told = _solve(RichardsonLucy(), _observed(_blur(), np.full(DEPTH.shape, 0.4)))
    assert (found.steps, found.stopped, len(told)) == (0, NOISE, 1)
    assert not np.ptp(found.light)


@pytest.mark.parametrize(("power", "stopped"), [(0.7, None), (4.0, MISFIT)])
def test_a_run_is_no_misfit_while_more_steps_may_reach_the_noise(power: float, stopped: str | None) -> None:
    course = StoppingRule(RichardsonLucy(steps=200, target=1.0), 0.01, lambda *_: None)
    # One that falls to 1.0 at 200 steps, and one that stays at 1.3.
    falls = [0.95 + 0.05 * (k / 200.0) ** -power if power < 1.0 else 1.3 + (k / 4.0) ** -power for k in range(1, 100)]
    reasons = [course.judge(discrepancy) for discrepancy in [5.0, *falls]]
    assert next((why for why in reasons if why), None) == stopped


@pytest.mark.parametrize(
    ("last", "steps", "found"),
    [
        (1.30, 20, True),  # falls by 0.1 in a doubling: to 1.2 after 40 steps
        (1.30, 160, False),  # to 1.0 after three doublings
        (1.05, 20, False),
    ],
)
def test_a_misfit_is_what_no_forecast_brings_to_the_noise(last, steps, found):
    history = [5.0] * 10 + [1.4] * 10 + [last]
    assert is_misfit(history, steps, 1.1) is found
    assert not is_misfit(history[1:], steps, 1.1)  # too early to tell
