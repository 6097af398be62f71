"""The compiled kernel that spreads windows: a matrix and its transpose, on all instructions, and what it refuses."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest

from lommel import _core
from lommel.imaging.bank import Bank
from lommel.imaging.blur import parts
from lommel.imaging.sensor_light import pixel_factors

LEVELS = ["portable", "avx2", "avx512"]
SIZES = [(1, 1, 0), (1, 7, 1), (9, 1, 3), (5, 4, 8), (40, 3, 2), (33, 35, 5), (2, 70, 17), (137, 2, 70)]


@pytest.fixture(params=LEVELS)
def level(request: pytest.FixtureRequest) -> Iterator[str]:
    """Limit the instructions; above those of the processor the limit does nothing."""
    _core.limit_instructions(request.param)
    yield request.param
    _core.limit_instructions("avx512")


def bank(
    rng: np.random.Generator, half: int, count: int = 6, dtype: type = np.float64, cuts: np.ndarray | None = None
) -> Bank:
    """A bank of noise, without symmetries that would hide a fault but those that banks build on."""
    if cuts is None:
        cuts = np.minimum(rng.integers(0, half + 1, count) + rng.choice([0.0, 0.3, 0.9], count), half)
    away = np.abs(np.arange(-half, half + 1))
    values = rng.uniform(0.5, 1.5, (count, half + 1, half + 1)) * pixel_factors(cuts, half)
    windows = np.zeros((count + 1, half + 1, margin(half)), dtype)
    windows[:-1, :, : half + 1] = values
    energies = values[:, away[:, None], away].sum(axis=(1, 2))
    return Bank(0.0, 1.0, windows, cuts, energies, 0.0, 0.0)


def margin(half: int) -> int:
    """Columns that the kernel may touch on either side of a pixel."""
    return (half // 16 + 1) * 16


def room(b: Bank, image: np.ndarray) -> np.ndarray:
    """What the kernel writes to: larger by a window, and by columns that it may touch."""
    return np.zeros((image.shape[0] + 2 * b.half, image.shape[1] + 2 * margin(b.half)), image.dtype)


def spread(b: Bank, positions: np.ndarray, image: np.ndarray, threads: int = 0) -> np.ndarray:
    out, beyond = room(b, image), margin(b.half) - b.half
    _core.spread(parts(b), positions, image, threads, out)
    assert not out[:, :beyond].any()
    assert not out[:, -beyond:].any()
    return out[:, beyond:-beyond]


def collect(b: Bank, positions: np.ndarray, image: np.ndarray, threads: int = 0) -> np.ndarray:
    out, beyond = np.full(positions.shape, np.nan, image.dtype), margin(b.half) - b.half
    larger = np.pad(image, ((0, 0), (beyond, beyond)), constant_values=1e3)
    _core.collect(parts(b), positions, larger, threads, out)
    return out


def some_positions(rng: np.random.Generator, height: int, width: int) -> np.ndarray:
    """Inside the bank, at its ends, beyond it, and left out."""
    positions = rng.uniform(0.0, 5.0, (height, width))
    positions[rng.random((height, width)) < 0.2] = -1.0
    positions[rng.random((height, width)) < 0.1] = 5.0
    positions[rng.random((height, width)) < 0.1] = 0.0
    positions[rng.random((height, width)) < 0.1] = 17.0
    return positions


@pytest.mark.parametrize(("height", "width", "half"), SIZES)
def test_every_pixel_adds_its_window(level, height, width, half):
    rng = np.random.default_rng(height + width)
    b, positions, image = bank(rng, half), some_positions(rng, height, width), rng.standard_normal((height, width))
    total = np.zeros((height + 2 * half, width + 2 * half))
    for y in range(height):
        for x in range(width):
            if positions[y, x] >= 0.0:
                total[y : y + 2 * half + 1, x : x + 2 * half + 1] += image[y, x] * b.window(positions[y, x])
    assert np.abs(spread(b, positions, image) - total).max() <= 1e-12 * max(1.0, np.abs(total).max())
    single = spread(
        bank(np.random.default_rng(height + width), half, dtype=np.float32), positions, image.astype("f4")
    )
    assert np.abs(single - total).max() <= 1e-5 * max(1.0, np.abs(total).max())


@pytest.mark.parametrize(("height", "width", "half"), SIZES)
@pytest.mark.parametrize("threads", [1, 3])
def test_collecting_is_the_transpose_of_spreading(level, height, width, half, threads):
    rng = np.random.default_rng(height * width + half)
    b, positions = bank(rng, half, count=4 + half), some_positions(rng, height, width)
    a, c = rng.standard_normal((height, width)), rng.standard_normal((height + 2 * half, width + 2 * half))
    forth, back = spread(b, positions, a, threads), collect(b, positions, c, threads)
    size = np.linalg.norm(forth) * np.linalg.norm(c) + 1e-300
    assert abs(np.vdot(forth, c) - np.vdot(a, back)) <= 1e-10 * size
    assert np.all(back[positions < 0.0] == 0.0)


def test_threads_add_up_in_the_same_sequence_however_wide_the_windows():
    """Windows wider than the narrowest tiles: side by side on threads, nothing is lost and nothing added in turn."""
    rng = np.random.default_rng(1)
    b, positions, image = bank(rng, 100), rng.uniform(0.0, 5.0, (8, 448)), rng.standard_normal((8, 448))
    b = replace(b, cuts=np.full(6, 100.0))
    alone, together = spread(b, positions, image, 1), spread(b, positions, image, 2)
    assert np.array_equal(alone, together)


def check_layers(b: Bank, positions: np.ndarray, layers: np.ndarray, seen: np.ndarray, image: np.ndarray) -> None:
    """Hold both directions to sums, point by point, of what pixels see: `seen` is as large as what is written to."""
    (height, width), half, beyond, dtype = positions.shape, b.half, margin(b.half) - b.half, image.dtype
    used = seen[:, beyond:-beyond].astype(np.float64)
    other = np.random.default_rng(height).standard_normal(used.shape).astype(dtype)
    total, back = np.zeros(used.shape), np.zeros((height, width))
    for y, x in zip(*np.nonzero(positions >= 0.0), strict=True):
        at = np.s_[y : y + 2 * half + 1, x : x + 2 * half + 1]
        shown = np.clip(used[at] - layers[y, x], 0.0, 1.0) * b.window(positions[y, x])
        total[at] += image[y, x] * shown
        back[y, x] = (shown * other[at]).sum()
    out, taken = room(b, image), np.empty_like(image)
    _core.spread(parts(b), positions, image, 2, out, layers, seen)
    larger = np.ascontiguousarray(np.pad(other, ((0, 0), (beyond, beyond)), constant_values=1e3))
    _core.collect(parts(b), positions, larger, 2, taken, layers, seen)
    allowed = 1e-5 if dtype == np.float32 else 1e-12
    assert np.abs(out[:, beyond:-beyond] - total).max() <= allowed * max(1.0, np.abs(total).max())
    assert np.abs(taken - back).max() <= allowed * max(1.0, np.abs(back).max())


@pytest.mark.parametrize(("height", "width", "half"), SIZES)
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_pixels_see_points_by_their_layers(level, height, width, half, dtype):
    """All of the layers before the number that they see, a part of one, nothing of those behind."""
    rng = np.random.default_rng(height + width)
    b, positions = bank(rng, half, dtype=dtype), some_positions(rng, height, width)
    image = rng.standard_normal((height, width)).astype(dtype)
    layers = rng.integers(-2, 3, (height, width)).astype(dtype)
    layers[: height // 2] = 0
    seen = room(b, image)
    seen[:] = rng.uniform(-2.5, 3.5, seen.shape) if height % 2 else np.where(np.arange(seen.shape[1]) < 40, 0.0, 2.4)
    check_layers(b, positions, layers, seen, image)


@pytest.mark.parametrize("half", [1, 2, 4, 8, 16])
@pytest.mark.parametrize("every", [5, 40])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_columns_may_be_hidden_here_and_there(level, half, every, dtype):
    """Runs of one layer are put together, beside points that all pixels see and others that spread nothing."""
    rng, height, width = np.random.default_rng(half), 143, 3
    b = bank(rng, half, dtype=dtype, cuts=np.linspace(half if every == 5 else half // 2, half, 6))
    positions = rng.uniform(0.0, 5.0, (height, width))
    positions[(np.arange(height) // 9) % 4 == 1] = -1.0
    image = rng.standard_normal((height, width)).astype(dtype)
    layers = ((np.arange(height)[:, None] + np.arange(width)) // every % 3).astype(dtype)
    seen = room(b, image)
    row = np.arange(len(seen))
    seen[:] = np.where(row[:, None] // 20 % 2 == 0, 4.0, rng.uniform(0.5, 2.5, seen.shape))
    check_layers(b, positions, layers, seen, image)


def test_light_is_held():
    rng = np.random.default_rng(2)
    b, image = bank(rng, 4), rng.random((50, 30))
    out = spread(b, rng.uniform(0.0, 5.0, (50, 30)), image)
    assert out.sum() == pytest.approx(image.sum(), rel=1e-12)


def test_spreading_adds_to_what_is_there():
    rng = np.random.default_rng(3)
    b, positions, image = bank(rng, 2), rng.uniform(0.0, 5.0, (6, 7)), rng.random((6, 7))
    out = room(b, image) + 1.0
    _core.spread(parts(b), positions, image, 0, out)
    beyond = margin(b.half) - b.half
    assert out[:, beyond:-beyond] == pytest.approx(1.0 + spread(b, positions, image), rel=1e-14)


def test_values_need_not_lie_next_to_each_other(level):
    rng = np.random.default_rng(5)
    b, positions, image = bank(rng, 3), rng.uniform(0.0, 5.0, (6, 7)), rng.standard_normal((6, 7, 3))[:, ::-1, 1]
    assert np.array_equal(spread(b, positions, image), spread(b, positions, image.copy()))
