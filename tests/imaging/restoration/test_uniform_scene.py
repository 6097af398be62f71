"""Stated blurs that contradict their photograph, and unknown distances; scenes are rendered without this package."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

from lommel import Noise
from lommel.imaging import RichardsonLucy, restore
from scenes import POINTS, ThinLens, averaged, lommel_lens, plane, texture

SIDE, LIGHT, READ = 128, 3000.0, 3.0
LENS = ThinLens(35e-3, 2.8, 1.35, 540e-9, 4e-6)
NOISE = Noise(white=3.0 * LIGHT, read=READ)


def distance_of(pixels: float) -> float:
    """Return the distance, farther than the focus, at which the geometric blur has this diameter."""
    sensor = LENS.focal_length / (1.0 - LENS.focal_length / LENS.focus)
    return 1.0 / (1.0 / LENS.focus - pixels * LENS.pixel / (LENS.focal_length / LENS.f_number * sensor))


@lru_cache
def photograph(kind: str, pixels: float, spherical: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    lens = ThinLens(**{**vars(LENS), "spherical": spherical})
    scene = texture(kind, SIDE, 7)
    draw = np.random.default_rng(4)
    seen = plane(scene, [lens], distance_of(pixels), LIGHT)[0]
    return (draw.poisson(seen) + draw.normal(0.0, READ, seen.shape)) / (3.0 * LIGHT), averaged(scene) / 3.0


def restored(photo: np.ndarray, depth, **options):
    return restore(photo, depth, lommel_lens(LENS), LENS.pixel, encoding="linear", noise=NOISE, **options)


def decibels(light: np.ndarray, truth: np.ndarray) -> float:
    return float(-10.0 * np.log10(np.mean(np.square(light - truth)[12:-12, 12:-12])))


@pytest.mark.parametrize("kind", ["pink", "leaves"])
def test_stated_blur_is_compared(kind):
    photo, _ = photograph(kind, 5.0)
    found = restored(photo, distance_of(5.0))
    assert found.reliable
    assert "blur_compared" in found.findings.codes


@pytest.mark.parametrize("method", [None, RichardsonLucy(steps=5)])
def test_blur_that_is_stated_too_wide_is_a_doubt(method):
    photo, truth = photograph("pink", 5.0)
    found = restored(photo, distance_of(6.0), method=method)
    doubt = found.findings.get("blur_doubtful")
    assert doubt.severity == "doubt"
    assert doubt.numbers["factor"] == pytest.approx(5.0 / 6.0, abs=0.07)
    assert "accept=True" in doubt.text
    assert decibels(found.light, truth) > decibels(photo, truth) + 0.5  # a part of the photograph is mixed in
    accepted = restored(photo, distance_of(6.0), accept=True)
    assert accepted.reliable
    assert "estimated" in accepted.findings.codes
    assert decibels(accepted.light, truth) > decibels(found.light, truth) + 0.3


@pytest.mark.parametrize(("stated", "gain"), [(8.0, 5.0), (9.6, 0.0)])
def test_fine_pattern_is_restored_by_the_right_blur_alone(stated, gain):
    """Its contrast is near a zero of the transfer function: restoration changes it by far more than blur."""
    y, x = np.mgrid[: SIDE * POINTS, : SIDE * POINTS] / POINTS
    x, y = x * np.cos(0.1) + y * np.sin(0.1), y * np.cos(0.1) - x * np.sin(0.1)
    up = np.sin(2.0 * np.pi * y / 5.2) > 0.0
    fabric = 1.5 + np.where(up, 0.9 * np.sign(np.sin(2.0 * np.pi * x / 7.4)), -0.5)
    seen = plane(fabric, [LENS], distance_of(8.0), LIGHT)[0]
    draw = np.random.default_rng(4)
    photo = (draw.poisson(seen) + draw.normal(0.0, READ, seen.shape)) / (3.0 * LIGHT)
    found, truth = restored(photo, distance_of(stated)), averaged(fabric) / 3.0
    assert found.reliable == (gain > 0.0)
    assert decibels(found.light, truth) > decibels(photo, truth) + gain - 0.01


@pytest.mark.parametrize(("pixels", "stated"), [(0.5, 2.0), (0.5, 3.0)])
def test_nearly_sharp_photograph_is_returned(pixels, stated):
    """What the stated blur would leave has more fine detail than scenes: no share of the result is mixed in."""
    photo, _ = photograph("leaves", pixels)
    found = restored(photo, distance_of(stated))
    assert found.photograph == 1.0
    assert found.findings.get("blur_doubtful").severity == "doubt"
    np.testing.assert_allclose(found.light, photo, atol=1e-6)


def test_blur_that_is_stated_too_small_is_a_note():
    photo, truth = photograph("pink", 6.0)
    found = restored(photo, distance_of(5.0))
    assert found.reliable
    text = found.findings.get("blur_compared").text
    assert "softer than stated" in text
    assert "or more" not in text
    assert decibels(found.light, truth) > decibels(photo, truth)


@pytest.mark.parametrize(("kind", "factor"), [("pink", 4.0), ("leaves", 2.0)])
def test_noise_that_is_stated_too_low_is_a_doubt(kind, factor):
    photo, _ = photograph(kind, 5.0)
    noise = Noise(white=factor * NOISE.white, read=READ)
    found = restore(photo, distance_of(5.0), lommel_lens(LENS), LENS.pixel, encoding="linear", noise=noise)
    doubt = found.findings.get("misfit")
    assert doubt.severity == "doubt"
    assert doubt.numbers["noise"] == pytest.approx(factor, rel=0.3)
    assert "check white" in doubt.text


def test_spherical_aberration_that_is_not_stated_returns_the_photograph():
    photo, truth = photograph("leaves", 5.0, 0.7)
    found = restored(photo, distance_of(5.0))
    assert "blur_doubtful" in found.findings.codes
    assert decibels(found.light, truth) > decibels(photo, truth) - 0.5
    accepted = restored(photo, distance_of(5.0), accept=True)
    assert decibels(accepted.light, truth) > decibels(photo, truth) - 0.2


@pytest.mark.parametrize("pixels", [5.0, 8.0, 14.0])
def test_unknown_distance_is_estimated_with_its_error(pixels):
    photo, truth = photograph("leaves", pixels)
    found = restored(photo, "unknown")
    assert found.converged
    assert "distance_estimated" in found.findings.codes
    # Both sides of the focus have this blur.
    assert len(found.distances) == len(found.distance_errors) == 2
    k = int(np.argmin(np.abs(np.array(found.distances) - distance_of(pixels))))
    assert abs(found.distances[k] - distance_of(pixels)) < 3.0 * found.distance_errors[k]
    assert found.distance_errors[k] < 0.002 * pixels * distance_of(pixels)
    known = restored(photo, distance_of(pixels))
    assert decibels(found.light, truth) == pytest.approx(decibels(known.light, truth), abs=0.3)


@pytest.mark.parametrize("amount", [0.8, 1.5])
@pytest.mark.parametrize("depth", [None, "unknown"])
def test_sharpened_photograph_is_a_doubt(depth, amount):
    photo, _ = photograph("leaves", 5.0)
    sharpened = photo + amount * (photo - gaussian_filter(photo, 1.2))
    found = restored(sharpened, depth or distance_of(5.0))
    assert not found.reliable
    told = next(finding for finding in found.findings if "sharpened" in finding.text)
    assert told.severity == "doubt"
    assert len(told.text) <= 300


def test_bright_middle_has_the_noise_of_its_light():
    """A window sees the middle of the photograph, whose noise is not that of the mean light."""
    scene = texture("leaves", SIDE, 7).copy()
    ends = [(side // 3, 2 * side // 3) for side in scene.shape]
    scene *= 0.05
    scene[slice(*ends[0]), slice(*ends[1])] *= 20.0
    draw = np.random.default_rng(4)
    seen = plane(scene, [LENS], distance_of(5.0), LIGHT)[0]
    photo = (draw.poisson(seen) + draw.normal(0.0, READ, seen.shape)) / (3.0 * LIGHT)
    assert "sharpened" not in restored(photo, "unknown").findings.codes


def test_photograph_without_texture_has_no_distance():
    draw = np.random.default_rng(1)
    photo = draw.poisson(np.full((SIDE, SIDE), LIGHT)) / (3.0 * LIGHT)
    found = restored(photo, "unknown")
    assert not found.converged
    assert found.findings.codes == ("undetermined",)
    np.testing.assert_allclose(found.light, photo, atol=1e-6)


def planes_side_by_side(sizes: tuple[float, ...]) -> tuple[np.ndarray, np.ndarray]:
    """Return a photograph of planes with these blurs, each two periods of a texture high and wide."""
    scene = texture("leaves", SIDE, 7)
    seen = [np.tile(plane(scene, [LENS], distance_of(size), LIGHT)[0], (2, 2)) for size in sizes]
    draw, electrons = np.random.default_rng(4), np.hstack(seen)
    photo = (draw.poisson(electrons) + draw.normal(0.0, READ, electrons.shape)) / NOISE.white
    return photo, np.tile(averaged(scene), (2, 2 * len(sizes))) / 3.0


def test_unknown_distances_are_estimated_in_blocks():
    photo, truth = planes_side_by_side((5.0, 9.0))
    found = restored(photo, "unknown")
    assert found.converged
    assert "depth varies: distances estimated in" in found.findings.get("distance_estimated").text
    assert found.distances == ()
    # Four columns of blocks, of which two have one blur only.
    for block in found.blocks:
        outer = {96: 5.0, 416: 9.0}.get(block["column"])
        if outer is not None:
            z = (np.array(block["distances"]) - distance_of(outer)) / block["distance_errors"]
            assert np.abs(z).min() < 3.0
    assert {block["column"] for block in found.blocks} >= {96, 416}
    one = restored(photo, distance_of(5.0))
    assert decibels(found.light, truth) > max(decibels(photo, truth) + 2.0, decibels(one.light, truth) + 1.0)


def test_blocks_of_one_distance_are_restored_by_one_blur():
    photo, _ = planes_side_by_side((6.0,))
    found = restored(photo, "unknown")
    assert found.blocks == ()
    assert len(found.distances) == 2


def by_shape(shape: str, size: float) -> tuple[np.ndarray, np.ndarray]:
    """Return a photograph that is blurred by a disc of a diameter or a Gaussian of an rms width, drawn on points."""
    scene = texture("leaves", SIDE, 7, 0.4)
    if shape == "Gaussian":
        seen = gaussian_filter(scene, size * POINTS, mode="wrap")
    else:
        place = np.minimum(np.arange(len(scene)), len(scene) - np.arange(len(scene)))
        disc = np.clip(0.5 * size * POINTS + 0.5 - np.hypot(place[:, None], place), 0.0, 1.0)
        seen = np.fft.irfft2(np.fft.rfft2(scene) * np.fft.rfft2(disc / disc.sum()), scene.shape)
    draw = np.random.default_rng(4)
    electrons = LIGHT * averaged(seen)
    return (draw.poisson(electrons) + draw.normal(0.0, READ, electrons.shape)) / NOISE.white, averaged(scene) / 3.0


def test_without_a_lens_the_blur_is_a_disc():
    photo, truth = by_shape("disc", 7.0)
    found = restore(photo, "unknown", encoding="linear", noise=NOISE)
    numbers, text = found.findings.get("blur_shape").numbers, found.findings.get("blur_shape").text
    assert "a disc of" in text
    assert abs(numbers["blur"] - 7.0) < 2.0 * numbers["error"] < 2.1
    assert found.distances == ()
    assert decibels(found.light, truth) > decibels(photo, truth) + 2.5


@pytest.mark.parametrize(("shape", "size"), [("disc", 1.5), ("Gaussian", 0.3), ("Gaussian", 1.8)])
def test_photograph_without_a_disc_is_returned_without_a_lens(shape, size):
    photo, _ = by_shape(shape, size)
    found = restore(np.stack([photo] * 3, axis=2), "unknown", encoding="linear", noise=NOISE)
    assert found.findings.codes == ("undetermined",)
    assert "state lens and distance, or a measured PSF" in found.findings[0].text
    assert found.stopped.startswith("undetermined")
    np.testing.assert_allclose(found.light[..., 1], photo, atol=1e-6)


@pytest.mark.parametrize("width", [1.0, 2.0])
def test_soft_scene_does_not_determine_a_distance(width):
    """A texture that falls as a Gaussian, in focus."""
    scene = gaussian_filter(texture("pink", SIDE, 7), width * POINTS, mode="wrap")
    draw = np.random.default_rng(4)
    electrons = 3.0 * LIGHT * averaged(scene)
    found = restored((draw.poisson(electrons) + draw.normal(0.0, READ, electrons.shape)) / NOISE.white, "unknown")
    assert found.findings.codes == ("undetermined",)
    assert found.distances == ()


def test_pixel_pitch_without_a_lens_is_refused():
    with pytest.raises(ValueError, match="pixel is that of a Lens, which is missing"):
        restore(photograph("pink", 5.0)[0], "unknown", None, 4e-6, encoding="linear", noise=NOISE)


def test_other_words_are_no_distance():
    with pytest.raises(ValueError, match="depth must hold metres or be \"unknown\", got 'far'"):
        restored(photograph("pink", 5.0)[0], "far")
