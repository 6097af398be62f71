"""Sums of weighted convolutions by FFTs, against sums over points."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.imaging import field_blur
from lommel.imaging.field_bank import Nodes
from lommel.imaging.field_blur import Blocks

HEIGHT, WIDTH, SIDE = 23, 31, 5


def made(dtype: type = np.float64, threads: int = 2) -> tuple[Blocks, np.ndarray, np.ndarray]:
    rng = np.random.default_rng(0)
    windows = rng.standard_normal((5, 7, 3, SIDE, SIDE)).astype(dtype)
    down, across = (
        Nodes(0.0, 1.0, count).weights(np.linspace(0.0, 1.0, n)) for count, n in ((5, HEIGHT), (7, WIDTH))
    )
    return Blocks(windows, down, across, threads), down, across


def shares(down: slice, across: slice) -> list[tuple[int, np.ndarray]]:
    """Points of the left half take the first window alone, others some of the last two."""
    columns = np.arange(WIDTH)[across] + 0.0 * np.arange(HEIGHT)[down, None]
    left = (columns < WIDTH / 2).astype(float)
    return [(k, part) for k, part in ((0, left), (1, 0.3 * (1 - left)), (2, 0.7 - 0.7 * left)) if part.any()]


def direct(windows: np.ndarray, down: np.ndarray, across: np.ndarray, light: np.ndarray, deep: bool) -> np.ndarray:
    whole = dict(shares(slice(None), slice(None))) if deep else {0: np.ones_like(light)}
    out = np.zeros((HEIGHT + SIDE - 1, WIDTH + SIDE - 1))
    for y in range(HEIGHT):
        for x in range(WIDTH):
            for k, share in whole.items():
                window = np.einsum("a,b,abuv->uv", down[y], across[x], windows[:, :, k])
                out[y : y + SIDE, x : x + SIDE] += share[y, x] * light[y, x] * window
    return out


@pytest.mark.parametrize("deep", [False, True])
@pytest.mark.parametrize("kept", [True, False])
@pytest.mark.parametrize("longest", [9, 16, 512])
def test_blocks_of_any_size_add_up_to_the_sum_over_points(monkeypatch, deep, kept, longest):
    monkeypatch.setattr(field_blur, "_OVERHEAD", 0 if longest < 100 else 20_000)
    monkeypatch.setattr(field_blur, "_LONGEST", longest)
    monkeypatch.setattr(field_blur, "_KEPT", field_blur._KEPT if kept else 0)
    engine, down, across = made()
    rng = np.random.default_rng(1)
    light, room = rng.standard_normal((HEIGHT, WIDTH)), rng.standard_normal((HEIGHT + SIDE - 1, WIDTH + SIDE - 1))
    which = shares if deep else None
    out = engine.spread(light, which)
    exact = direct(engine.windows, down, across, light, deep)
    assert np.abs(out - exact).max() < 1e-12 * np.abs(exact).max()
    assert np.vdot(out, room) == pytest.approx(np.vdot(light, engine.collect(room, which)), rel=1e-12)


def test_threads_do_not_change_a_bit():
    light = np.random.default_rng(1).random((HEIGHT, WIDTH)).astype(np.float32)
    one, other = (made(np.float32, threads)[0].spread(light, shares) for threads in (1, 5))
    assert one.dtype == np.float32
    assert one.tobytes() == other.tobytes()
