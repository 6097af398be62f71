"""Occlusion: what is hidden stays hidden, what hides nothing is as without, and white stays white."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import DepthBlur, Occlusion
from lommel.imaging.occlusion import MAX_LAYERS, Layering, _layering, _radii

LENS = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
DONUT = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9, obscuration=0.6)
PIXEL = 20e-6
HEIGHT, WIDTH = 30, 60
BAR = slice(22, 40)


def bar(front: float, back: float) -> np.ndarray:
    depth = np.full((HEIGHT, WIDTH), back)
    depth[:, BAR] = front
    return depth


def layered(blur: DepthBlur) -> tuple[Layering, np.ndarray, np.ndarray]:
    """Layers, the radius of blur at each point, and what stands for what it hides, or -1."""
    made = _layering(blur)
    radius = np.interp(blur.defocus, *_radii(blur, (blur.defocus.min(), blur.defocus.max())))
    return made, radius, np.full(blur.shape, -1) if made.behind is None else made.behind


def edge(blur: DepthBlur, distance: float) -> np.ndarray:
    """Coverage of the bar by its distance from either edge, from exact windows: ``a[d]`` for d pixels inside."""
    half = blur.banks[0].half
    window = lm.psf(LENS.pupil(distance), 2 * half + 1, PIXEL, integrate=True, dtype=np.float64).values
    window = blur.banks[0].pixel_weights(LENS.defocus(distance)) * window
    rising = np.cumsum(window.sum(axis=0) / window.sum())
    left = np.arange(WIDTH) - BAR.start + half
    right = np.arange(WIDTH) - BAR.stop + half
    return rising[np.clip(left, 0, 2 * half)] - np.where(right < 0, 0.0, rising[np.clip(right, 0, 2 * half)])


@pytest.mark.parametrize(("lens", "seed"), [(LENS, 0), (DONUT, 1), (DONUT, 2)])
def test_a_white_scene_stays_white_whatever_its_depth(lens, seed):
    rng = np.random.default_rng(seed)
    depth = bar(1.3, 4.0) + 0.3 * rng.random((HEIGHT, WIDTH)) ** (seed + 1)
    depth[5:9, 3:50] = np.inf
    blur = DepthBlur(depth, lens, PIXEL, dtype=np.float64, channels=(620e-9, 450e-9))
    assert np.abs(Occlusion(blur).forward(np.ones((HEIGHT, WIDTH, 2))) - 1.0).max() < 1e-12
    assert np.abs(blur.forward(np.ones((HEIGHT, WIDTH, 2))) - 1.0).max() > 0.1


def test_a_sharp_foreground_is_not_touched_by_the_highlights_behind_it():
    light = np.full((HEIGHT, WIDTH), 0.1)
    light[15, BAR.start - 2] = light[7, BAR.stop + 1] = 50.0
    light[:, BAR] = 0.4
    blur = DepthBlur(bar(2.0, 8.0), LENS, PIXEL, dtype=np.float64)
    own = (
        int(np.flatnonzero(blur.banks[0].pixel_weights(LENS.defocus(2.0))[blur.banks[0].half])[-1])
        - blur.banks[0].half
    )
    inside = slice(BAR.start + own, BAR.stop - own)
    assert own <= 2
    assert np.abs(Occlusion(blur).forward(light)[:, inside] - 0.4).max() < 1e-6
    assert np.abs(blur.forward(light)[:, inside] - 0.4).max() > 0.1


def test_a_uniform_background_is_not_darker_beside_a_sharp_foreground():
    light = np.full((HEIGHT, WIDTH), 0.7)
    light[:, BAR] = 0.1
    blur = DepthBlur(bar(2.0, 8.0), LENS, PIXEL, dtype=np.float64)
    seen = Occlusion(blur).forward(light)
    assert np.abs(seen[:, : BAR.start - 2] - 0.7).max() < 1e-6
    assert blur.forward(light)[:, BAR.start - 3].max() < 0.6


@pytest.mark.parametrize("front", [1.0, 1.3, 1.6])
def test_a_blurred_foreground_covers_a_sharp_background_by_the_part_of_the_aperture_that_it_fills(front):
    light = np.full((HEIGHT, WIDTH), 0.2)
    light[:, BAR] = 0.9
    blur = DepthBlur(bar(front, 2.0), LENS, PIXEL, dtype=np.float64, tol=1e-6)
    cover = edge(blur, front)
    assert 0.3 < cover[BAR.start] < 0.7
    # What diffraction brings from beyond the rim of the geometric blur is not extended: 2 % of the difference of 0.7.
    assert np.abs(Occlusion(blur).forward(light) - (0.2 + 0.7 * cover)).max() < 0.02 * 0.7


def test_a_surface_that_hides_nothing_is_as_without_occlusion():
    # Thirty layers deep; radii of blur change by at most 0.2 pixels a pixel.
    rng = np.random.default_rng(3)
    across = np.linspace(1.0 / 1.2, 1.0 / 6.0, 90)
    light = rng.random((40, 90)) + 20.0 * (rng.random((40, 90)) > 0.99)
    blur = DepthBlur(np.tile(1.0 / across, (40, 1)), LENS, PIXEL, dtype=np.float64)
    made, radius, _ = layered(blur)
    assert made.number > 30
    assert np.abs(np.diff(radius, axis=1)).max() < 0.2
    # Where the blur varies, the points around do not add up to white by themselves.
    white = blur.forward(np.ones((40, 90)))
    assert 0.02 < np.abs(white - 1.0).max() < 0.07
    added = blur.forward(light) / white
    seen = Occlusion(blur).forward(light)
    assert np.abs(seen - added).max() < 0.015 * added.max()
    assert seen.sum() == pytest.approx(added.sum(), rel=1e-3)


def test_a_slanted_foreground_is_not_transparent():
    depth = bar(1.0, 6.0)
    depth[:, BAR] = np.linspace(1.0, 1.25, BAR.stop - BAR.start)
    light = np.zeros((HEIGHT, WIDTH))
    light[:, : BAR.start] = light[:, BAR.stop :] = 1.0
    blur = DepthBlur(depth, LENS, PIXEL, dtype=np.float64)
    assert len(np.unique(_layering(blur).layers[:, BAR])) > 5
    middle = (BAR.start + BAR.stop) // 2
    assert Occlusion(blur).forward(light)[:, middle].max() < 0.05


def test_a_scene_without_edges_hides_nothing_and_layers_are_bounded():
    smooth = DepthBlur(np.tile(np.linspace(1.8, 2.2, 40), (9, 1)), LENS, PIXEL, largest=20)
    assert layered(smooth)[0].behind is None
    depth = np.r_[1.0 / np.linspace(1.0, 0.001, 400), np.inf]
    fine = DepthBlur(np.tile(depth, (4, 1)), LENS, 6e-6, largest=100, energy=0.6, tol=0.1)
    made, radius, _ = layered(fine)
    assert np.ptp(radius) > 0.5 * MAX_LAYERS
    assert made.number == MAX_LAYERS
    assert list(made.layers[0, [0, -1]]) == [0, MAX_LAYERS - 1]
