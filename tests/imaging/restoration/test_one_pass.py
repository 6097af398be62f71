"""Deblurring in one pass, of continuous scenes that are rendered without this package."""

from __future__ import annotations

import numpy as np
import pytest

from lommel import Lens, Noise
from lommel.deconvolve.likelihood import PhotographLikelihood
from lommel.imaging import DepthBlur, Occlusion, OnePass, RichardsonLucy, restore
from scenes import ThinLens, averaged, before, lommel_lens, plane, texture

SIDE, LIGHT, READ = 128, 5000.0, 3.0
LENS = ThinLens(35e-3, 8.0, 1.35, 540e-9, 4e-6)
WHITE = 3.0 * LIGHT
NOISE = Noise(white=WHITE, read=READ)


def photograph(distance: float, kind: str = "leaves", light: float = LIGHT, seed: int = 3) -> tuple[np.ndarray, ...]:
    """Return a photograph of a plane, and its scene averaged by the pixels, white being three times the mean."""
    scene = texture(kind, SIDE, 7)
    draw = np.random.default_rng(seed)
    seen = plane(scene, [LENS], distance, light)[0]
    counts = draw.poisson(seen) + draw.normal(0.0, READ, seen.shape)
    return counts / (3.0 * light), averaged(scene) / 3.0


def decibels(light: np.ndarray, truth: np.ndarray) -> float:
    return float(-10.0 * np.log10(np.mean(np.square(light - truth)[16:-16, 16:-16])))


def restored(photo: np.ndarray, depth: np.ndarray, noise: Noise = NOISE, **options):
    return restore(photo, depth, lommel_lens(LENS), LENS.pixel, encoding="linear", noise=noise, **options)


@pytest.mark.parametrize(("distance", "kind"), [(1.25, "leaves"), (1.35, "pink"), (1.7, "leaves"), (1.9, "text")])
def test_planes_are_as_near_to_the_scene_as_by_iteration(distance, kind):
    photo, truth = photograph(distance, kind)
    depth = np.full((SIDE, SIDE), distance)
    quick, slow = (restored(photo, depth, method=method) for method in (OnePass(), RichardsonLucy()))
    assert quick.stopped == "one pass"
    assert quick.steps == 1
    assert decibels(quick.light, truth) > decibels(photo, truth) + 0.8
    assert decibels(quick.light, truth) > decibels(slow.light, truth) - 0.2
    assert quick.light.mean() == pytest.approx(photo.mean(), rel=1e-3)


def test_noise_is_what_the_photograph_shows():
    photo, truth = photograph(1.8, "pink", light=100.0)
    depth = np.full((SIDE, SIDE), 1.8)
    stated, understated = (
        restored(photo, depth, Noise(white=gain * 300.0, read=gain * READ), method=OnePass()) for gain in (1.0, 1.05)
    )
    assert decibels(stated.light, truth) > decibels(photo, truth) + 2.0
    assert decibels(understated.light, truth) == pytest.approx(decibels(stated.light, truth), abs=0.3)


def test_each_side_of_an_edge_is_filtered_by_its_own_depth():
    # Beside it other depths are noise to the filters, which therefore take little of them in.
    points = SIDE * 8
    mask = np.zeros((points, points))
    mask[points // 4 : 3 * points // 4, points // 4 : 3 * points // 4] = 1.0
    front, back = texture("leaves", SIDE, 1), texture("pink", SIDE, 2)
    seen = before(front, mask, 1.5, back, 1.9, [LENS], LIGHT)[0]
    draw = np.random.default_rng(1)
    photo = (draw.poisson(seen) + draw.normal(0.0, READ, seen.shape)) / WHITE
    inside = averaged(mask) > 0.5
    truth = averaged(front * mask + back * (1.0 - mask)) / 3.0
    blur = DepthBlur(np.where(inside, 1.5, 1.9), lommel_lens(LENS), LENS.pixel)
    found = OnePass().solve(PhotographLikelihood(blur, photo, NOISE), lambda *_: None)
    for part in (inside, ~inside):
        part = part[16:-16, 16:-16]
        errors = [np.square(image - truth)[16:-16, 16:-16][part].mean() for image in (found.light, photo)]
        assert errors[0] < 0.9 * errors[1]


def test_colours_and_unknown_pixels_are_taken():
    photo, truth = photograph(1.7)
    colour = np.stack([photo, 0.5 * photo], axis=2)
    colour[60:64, 60:64, 0] = np.nan
    blur = Occlusion(DepthBlur(np.full((SIDE, SIDE), 1.7), lommel_lens(LENS), LENS.pixel, channels=[540e-9] * 2))
    found = restore(colour, None, blur, encoding="linear", noise=NOISE, saturation=1.0, method=OnePass())
    alone = restored(photo, np.full((SIDE, SIDE), 1.7), method=OnePass())
    assert np.isfinite(found.light).all()
    assert found.unknown == pytest.approx(16 / colour.size)
    assert decibels(found.light[..., 0], truth) == pytest.approx(decibels(alone.light, truth), abs=0.3)


def test_blur_that_filters_do_not_reach_is_refused(monkeypatch):
    monkeypatch.setattr("lommel.imaging.one_pass._MAX_LOSS", 1e-3)
    wide = Lens(focal_length=35e-3, f_number=2.0, focus_distance=2.0, wavelength=540e-9)
    photo = 0.5 + 0.3 * texture("text", SIDE, 1)[::8, ::8]
    with pytest.raises(ValueError, match=r"method=OnePass\(\) loses .* dB at 1.4 m, because the blur is too wide"):
        restore(photo, None, DepthBlur(np.full((SIDE, SIDE), 1.4), wide, 4e-6, largest=513), encoding="linear",
                noise=Noise(white=1e5, read=3.0), method=OnePass())  # fmt: skip
