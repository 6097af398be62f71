"""The search of depth: a valley that leak could have made is not taken for the true one."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.core.engine import FocalStream

COUNT, IMAGES, SIDE, PIXELS = 41, 3, 4, 4000.0
K, L = np.triu_indices(IMAGES)
ROUGH = np.arange(0, COUNT, 4)
USUAL, LEAK = 0.4, 0.004  # concentration of a texture of all frequencies, and leak
NOISE = 0.01


def directions() -> np.ndarray:
    """Filters whose energies are 0 for a texture across them: for a single frequency at one or more candidates."""
    angle = np.linspace(0.0, 1.2 * np.pi, COUNT)
    return np.stack([np.cos(angle), np.sin(angle) * np.cos(0.4 * angle), np.sin(angle) * np.sin(0.4 * angle)], axis=1)


FORMS = directions()[:, K] * directions()[:, L] * np.where(K == L, 1.0, 2.0)


def textures(seed: int) -> np.ndarray:
    """Blocks of pixels of three images, (40, 40, images, 16): textures of one frequency to all, and some noise."""
    draw = np.random.default_rng(seed)
    first = draw.standard_normal((40, 40, IMAGES, 1)) * draw.standard_normal((40, 40, 1, SIDE**2))
    broad = 10.0 ** draw.uniform(-2.5, 0.0, (40, 40, 1, 1)) * draw.standard_normal((40, 40, IMAGES, SIDE**2))
    # The filter at a drawn candidate rejects the texture.
    rejecting = directions()[draw.integers(4, COUNT - 4, (40, 40))]
    across = np.eye(IMAGES) - rejecting[..., :, None] * rejecting[..., None, :]
    return across @ (first + broad) + 0.03 * draw.standard_normal((40, 40, IMAGES, SIDE**2))


def searched(
    blocks: np.ndarray, leak: float, low: float = 0.0, weights: tuple[float, ...] = (1.0, 0.0)
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Position, standard error and misfit of blocks in windows of these weights."""
    down, across = blocks.shape[:2]
    frames = blocks.reshape(down, across, IMAGES, SIDE, SIDE).transpose(2, 0, 3, 1, 4)
    frames = np.ascontiguousarray(frames.reshape(IMAGES, down * SIDE, across * SIDE), dtype=np.float32)
    residuals = np.zeros((1, IMAGES, IMAGES, 2), dtype=np.float32)
    residuals[0, :, :, 0] = np.eye(IMAGES)  # images are the frames
    rows = [NOISE, 0.0, NOISE**2, 1.0, 0.0, USUAL, leak, 0.0]  # measured curvature, of noise alone
    stream = FocalStream(
        (down * SIDE, across * SIDE, 1, SIDE, 1, 0, 1), np.float32([0.5, 0.25]), residuals,
        np.zeros((0, IMAGES, 2), np.float32), np.float32(weights), FORMS.astype(np.float32),
        np.repeat(np.float32(rows)[:, None], COUNT, axis=1), (1.0, PIXELS, 1.0, 0.1, low, COUNT - 1.0, 8.0),
    )  # fmt: skip
    gains = np.zeros((IMAGES, 6), dtype=np.float32)
    gains[:, 0] = 1.0
    stream.take(list(frames), gains, 0.0, np.inf, None)
    maps = np.empty((3, down, across), dtype=np.float32)
    stream.places(*maps)
    return tuple(maps)


def found(blocks: np.ndarray, leak: float, low: float = 0.0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Position, standard error and misfit of blocks; every other block is dark, so that none has a neighbour."""
    spread = np.zeros((2 * blocks.shape[0], 2 * blocks.shape[1], *blocks.shape[2:]))
    spread[::2, ::2] = blocks
    position, error, misfit = (each[::2, ::2].astype(float) for each in searched(spread, leak, low))
    return position, error, misfit


def variances(blocks: np.ndarray) -> np.ndarray:
    """Variance of noise in each block: the mean of its frames, where light, and that of reading, 1."""
    return np.asarray(np.maximum(blocks.mean(axis=(2, 3)), 0.0) + 1.0)


@pytest.fixture(scope="module")
def blocks() -> np.ndarray:
    return textures(2).astype(np.float32).astype(float)


def test_valleys_of_few_frequencies_are_told_apart_by_more_than_leak(blocks):
    products = np.einsum("yxkp,yxlp->yxkl", blocks, blocks) / SIDE**2 / variances(blocks)[..., None, None]
    energies = np.einsum("cp,yxp->yxc", FORMS, products[..., K, L]) - NOISE
    concentration = (products**2).sum((2, 3)) / np.trace(products, axis1=2, axis2=3) ** 2
    few = np.clip((concentration - USUAL - 0.15) / 0.4, 0.0, 1.0)
    position, error, misfit = found(blocks, 0.0)
    known, at = np.isfinite(error), np.rint(np.nan_to_num(position)).astype(int)
    assert known.mean() > 0.3
    here = np.take_along_axis(energies, at[..., None], 2)[..., 0]
    strength = energies[..., ROUGH].mean(2) - here + np.maximum(here, 0.0)
    # Other valleys: candidates beyond the crests on either side of the lowest.
    second = np.full(known.shape, np.inf)
    for y, x in zip(*np.nonzero(known), strict=True):
        rough, best = energies[y, x, ROUGH], int(energies[y, x, ROUGH].argmin())
        low = high = best
        while low > 0 and rough[low - 1] >= rough[low]:
            low -= 1
        while high + 1 < len(rough) and rough[high + 1] >= rough[high]:
            high += 1
        others = np.r_[energies[y, x, : max(4 * low - 1, 0)], energies[y, x, 4 * high + 2 :]]
        second[y, x] = others.min(initial=np.inf)
    worse = np.maximum(misfit, 1.0)
    noise = 6.0 * 2.0 * worse / PIXELS
    assert (second - here)[known].min() > 0.99 * noise[known].min()

    leaking, errors, _ = found(blocks, LEAK)
    excluded = second - here > noise + (5.0 + 50.0 * few) * LEAK * strength
    # The first variance is by_noise t^2 + shifting t, t = 1 / curvature; shifting: energy that shifts the minimum.
    known &= error > 0.0
    excess = np.clip(concentration - USUAL, 0.0, 0.95)
    odds, chance = excess / (1.0 - excess), NOISE * np.sqrt(2.0 / PIXELS)
    remains = 0.5 * (here + np.sqrt(here**2 + 2.546 * chance**2))
    shifting, by_noise = odds * np.maximum(here - chance, 0.0), (worse * NOISE) ** 2 / PIXELS
    square = np.where(known, error, np.nan) ** 2
    t = 2.0 * square / (shifting + np.sqrt(shifting**2 + 4.0 * by_noise * square))
    shifting_more = np.minimum(np.maximum(few * LEAK * strength, shifting), odds * remains)
    variance = square + (shifting_more - shifting) * t
    away = np.abs(ROUGH - position[..., None]) - 2.0
    alike = energies[..., ROUGH] - here[..., None] < ((1.3 + 10.0 * few) * LEAK * strength)[..., None]
    reach = np.where(alike, away, 0.0).max(axis=2)
    expected = np.sqrt(np.maximum(variance, (0.5 * np.maximum(reach, 0.0)) ** 2))
    sure = known & (misfit < 2.0) & (error < 0.5) & (np.abs(position - at) < 0.4)
    still = np.isfinite(errors)
    margin = np.abs(second - here - noise - (5.0 + 50.0 * few) * LEAK * strength) > 0.02 * strength
    narrow = reach < (1.0 - 0.6 * few) * 8.0
    assert (still == (known & excluded & narrow & (expected < 8.0)))[sure & margin].all()
    both = sure & still
    assert 0.1 < (known & ~still)[sure].mean() < 0.9
    np.testing.assert_allclose(errors[both], expected[both], rtol=0.02)
    np.testing.assert_array_equal(leaking[both], position[both])
    assert (expected > 1.5 * error)[both].mean() > 0.05


def test_positions_outside_of_the_range_are_not_known(blocks):
    position, error, _ = found(blocks, 0.0)
    _, within, _ = found(blocks, 0.0, low=20.0)
    np.testing.assert_array_equal(np.isfinite(within), np.isfinite(error) & (np.nan_to_num(position) >= 20.0))


def test_depth_beside_a_border_does_not_depend_on_the_opposite_one():
    draw, rejecting = np.random.default_rng(1), directions()[20]
    across = np.eye(IMAGES) - rejecting[:, None] * rejecting
    texture = across @ draw.standard_normal((40, 40, IMAGES, SIDE**2))
    noise = 0.03 * draw.standard_normal(texture.shape)
    texture[:, 35:] = 0.0
    errors = []
    for first in (0, 12):
        texture[:, :first] = 0.0
        errors.append(searched(texture + noise, 0.0, weights=(0.5, 0.25))[1][:, 20:])
    assert np.isfinite(errors[0]).mean() > 0.7
    np.testing.assert_array_equal(*errors)
