"""Motion during the exposure; scenes are filtered noise on a torus larger than the frame, without this package."""

from __future__ import annotations

import itertools
from functools import lru_cache

import numpy as np
import pytest
from scipy.special import j1

import lommel as lm
from lommel.imaging.blur_spectrum import FREQUENCIES
from lommel.imaging.motion import likeliest_motion

SIDE, WHITE, READ = 144, 6000.0, 3.0
NOISE = lm.Noise(white=WHITE, read=READ)
LENS = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)


def disc(f: np.ndarray, diameter: np.ndarray | float) -> np.ndarray:
    x = np.pi * f * diameter
    return 2.0 * j1(x) / x


DISCS = disc(FREQUENCIES, np.array([[0.1], [2.0], [3.0], [4.0], [5.5], [6.0], [7.5], [10.0]]))


@lru_cache
def photograph(blur: str, size: float, degrees: float = 30.0, seed: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """Return a photograph in electrons and its scene, blurred by motion, a disc, or soft along one direction."""
    draw, side = np.random.default_rng(seed), 3 * SIDE
    fy, fx = np.fft.fftfreq(side)[:, None], np.fft.rfftfreq(side)
    f = np.maximum(np.hypot(fy, fx), 0.5 / side)
    # Angles are counter-clockwise, rows are numbered downwards.
    along = fx * np.cos(np.radians(degrees)) - fy * np.sin(np.radians(degrees))
    h = np.ones_like(f)
    if blur == "motion":
        h = np.sinc(size * along)
    elif blur == "disc":
        h = disc(f, size)
    power = f**-1.3
    if blur == "fibres":
        power = np.hypot(along * size, f) ** -1.3
    spectrum = np.fft.rfft2(draw.normal(size=(side, side))) * power * np.sinc(fx) * np.sinc(fy)
    spectrum[0, 0] = 0.0
    scene, seen = (np.fft.irfft2(spectrum * gain, (side, side))[:SIDE, :SIDE] for gain in (1.0, h))
    level = 0.12 / scene.std()
    scene, seen = (np.clip(0.4 + level * x, 0.01, 1.0) for x in (scene, seen))
    return (draw.poisson(WHITE * seen) + draw.normal(0.0, READ, seen.shape)) / WHITE, scene


def found(*args, **options):
    light = photograph(*args, **options)[0]
    return likeliest_motion(DISCS, light, light / WHITE)


@pytest.mark.parametrize(("pixels", "degrees"), [(6.0, 30.0), (9.0, 100.0)])
def test_motion_is_told_with_length_and_angle(pixels, degrees):
    motion = found("motion", pixels, degrees)
    assert motion.likely
    assert motion.length == pytest.approx(pixels, rel=0.04)
    assert abs((180.0 - np.degrees(motion.angle) - degrees + 90.0) % 180.0 - 90.0) < 3.0
    assert f"at {round(180.0 - np.degrees(motion.angle))} degrees to the rows" in motion.words


@pytest.mark.parametrize(("blur", "size"), [("disc", 6.0), ("disc", 3.0), ("fibres", 6.0), ("sharp", 0.0)])
def test_other_blurs_and_scenes_with_a_direction_are_no_motion(blur, size):
    motion = found(blur, size)
    assert not motion.likely
    assert not motion.possible


@pytest.mark.parametrize(("moved", "likely"), [(1, False), (9, True)])
def test_equal_rectangles_are_no_motion_unless_their_edges_were_moved(moved, likely):
    """Windows of a facade, each of two panes of 9 pixels, moved along rows by running means."""
    draw, wall = np.random.default_rng(2), np.full((SIDE, SIDE + moved - 1), 0.6)
    for row, column in itertools.product(range(8, SIDE, 48), range(8, SIDE + moved, 38)):
        for pane in (column, column + 11):
            wall[row : row + 30, pane : pane + 9] = draw.uniform(0.02, 0.15)
    seen = np.lib.stride_tricks.sliding_window_view(wall, moved, axis=1).mean(axis=2)
    light = (draw.poisson(WHITE * seen) + draw.normal(0.0, READ, seen.shape)) / WHITE
    motion = likeliest_motion(DISCS, light, light / WHITE)
    assert motion._replace(steep=False).likely
    assert motion.likely == likely


def test_motion_of_equal_rectangles_at_an_angle_is_not_told():
    """Panes of 8 pixels have the zeros of a motion along rows, beside those of the true one."""
    draw, side = np.random.default_rng(5), 2 * SIDE
    wall = np.full((side, side), 0.6)
    for row, column in itertools.product(range(8, side - 30, 48), range(8, side - 20, 38)):
        for pane in (column, column + 11):
            wall[row : row + 30, pane : pane + 8] = draw.uniform(0.02, 0.15)
    fy, fx = np.fft.fftfreq(side)[:, None], np.fft.rfftfreq(side)
    moved = np.sinc(10.0 * (fx * np.cos(np.radians(25.0)) - fy * np.sin(np.radians(25.0))))
    seen = np.fft.irfft2(np.fft.rfft2(wall) * moved, (side, side))[:SIDE, :SIDE]
    light = (draw.poisson(WHITE * np.maximum(seen, 0.0)) + draw.normal(0.0, READ, seen.shape)) / WHITE
    motion = likeliest_motion(DISCS, light, light.clip(0.01) / WHITE)
    assert motion._replace(second=0.0).likely
    assert not motion.likely


@pytest.mark.parametrize("depth", ["unknown", 2.1])
def test_a_photograph_that_was_moved_is_a_doubt_and_is_restored_by_its_motion_if_that_is_accepted(depth):
    photo, scene = photograph("motion", 8.0)

    def loss(light: np.ndarray) -> float:
        return float(np.mean(np.square(light - scene)[16:-16, 16:-16]))

    given = {"encoding": "linear", "noise": NOISE}
    told = lm.imaging.restore(photo, depth, LENS, 4e-6, **given)
    doubt = told.findings.get("blur_doubtful")
    assert doubt.severity == "doubt"
    assert doubt.numbers["motion"] == pytest.approx(8.0, rel=0.05)
    assert "straight motion" in doubt.text
    assert not told.distances
    assert loss(told.light) < 1.01 * loss(photo)
    accepted = lm.imaging.restore(photo, depth, LENS, 4e-6, accept=True, **given)
    assert accepted.findings.get("estimated").numbers["motion"] == pytest.approx(8.0, rel=0.05)
    assert loss(accepted.light) < 0.7 * loss(photo)
