"""Sums of weighted convolutions by FFTs, against sums over points."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.imaging import field_blur
from lommel.imaging.field_blur import MixedBlur, Nodes

HEIGHT, WIDTH, SIDE = 23, 31, 5


def made(deep: bool, dtype: type = np.float64, threads: int = 2) -> tuple[MixedBlur, np.ndarray, np.ndarray]:
    """Points of the left half take the first window over defocus alone, others a mixture, which varies."""
    windows = np.random.default_rng(0).standard_normal((5, 7, 3, SIDE, SIDE)).astype(dtype)
    down, across = (
        Nodes(0.0, 1.0, count).weights(np.linspace(0.0, 1.0, n)) for count, n in ((5, HEIGHT), (7, WIDTH))
    )
    column = np.arange(WIDTH) + 0.0 * np.arange(HEIGHT)[:, None]
    defocus = np.where(column < WIDTH / 2, 0.0, column / WIDTH)
    focus, defocus = (Nodes(0.0, 1.0, 3), defocus) if deep else (Nodes(0.0, 0.0, 1), 0.0 * defocus)
    return MixedBlur(windows, (down, across), focus, defocus, border="zero", threads=threads), down, across


def direct(engine: MixedBlur, down: np.ndarray, across: np.ndarray, light: np.ndarray) -> np.ndarray:
    out = np.zeros((HEIGHT + SIDE - 1, WIDTH + SIDE - 1))
    for y in range(HEIGHT):
        for x in range(WIDTH):
            shares = engine.focus.weights(engine.defocus[y, x, None])[0]
            window = np.einsum("a,b,k,abkuv->uv", down[y], across[x], shares, engine.windows[:, :, : len(shares)])
            out[y : y + SIDE, x : x + SIDE] += light[y, x] * window
    return out[SIDE // 2 :, SIDE // 2 :][:HEIGHT, :WIDTH]


@pytest.mark.parametrize("deep", [False, True])
@pytest.mark.parametrize("kept", [True, False])
@pytest.mark.parametrize("longest", [9, 16, 512])
def test_blocks_of_any_size_add_up_to_the_sum_over_points(monkeypatch, deep, kept, longest):
    monkeypatch.setattr(field_blur, "_OVERHEAD", 0 if longest < 100 else 20_000)
    monkeypatch.setattr(field_blur, "_LONGEST", longest)
    monkeypatch.setattr(field_blur, "_KEPT", field_blur._KEPT if kept else 0)
    engine, down, across = made(deep)
    light, image = np.random.default_rng(1).standard_normal((2, HEIGHT, WIDTH))
    out, exact = engine.spread(light), direct(engine, down, across, light)
    assert np.abs(out - exact).max() < 1e-12 * np.abs(exact).max()
    assert np.vdot(out, image) == pytest.approx(np.vdot(light, engine.collect(image)), rel=1e-12)


def test_threads_do_not_change_a_bit():
    light = np.random.default_rng(1).random((HEIGHT, WIDTH)).astype(np.float32)
    one, other = (made(True, np.float32, threads)[0].spread(light) for threads in (1, 5))
    assert one.dtype == np.float32
    assert one.tobytes() == other.tobytes()
