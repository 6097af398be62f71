"""Shift and magnification of frames from phases, in planes rendered without the PSFs of this package."""

from __future__ import annotations

import io
from functools import cache

import numpy as np
import pytest
from PIL import Image
from scipy.ndimage import affine_transform

import lommel as lm
from lommel.imaging.defocus_verdict import DefocusVerdict
from lommel.imaging.focal_engine import Magnified, Registration
from lommel.imaging.frame_phases import frame_scales, frame_shift
from lommel.imaging.pair_noise import EstimatedNoise
from lommel.recorded.noise import Noise

SIDE = 240
LENS = lm.Lens(focal_length=35e-3, f_number=4.0, focus_distance=1.35, wavelength=540e-9)


def blurred(values, radius):
    """Values with the blur of a disc of a radius in pixels."""
    y, x = np.mgrid[-15:16, -15:16]
    disc = np.clip(radius + 0.5 - np.hypot(x, y), 0.0, 1.0)
    spread = np.zeros(values.shape)
    spread[:31, :31] = disc / disc.sum()
    return np.fft.irfft2(np.fft.rfft2(values) * np.fft.rfft2(np.roll(spread, (-15, -15), (0, 1))), values.shape)


@cache
def frames(scale, quality=None, shift=(0.0, 0.0), radii=(2.0, 6.0)):
    """Two frames of "pink" texture, the second magnified and shifted, with other blur; as JPEG with a quality."""
    draw = np.random.default_rng(3)
    f = np.hypot(np.fft.fftfreq(SIDE)[:, None], np.fft.rfftfreq(SIDE))
    scene = np.fft.irfft2(np.fft.rfft2(draw.standard_normal((SIDE, SIDE))) / np.maximum(f, 0.01), (SIDE, SIDE))
    scene = 400.0 * (1.0 + 0.2 * scene / scene.std())
    middle = 0.5 * (SIDE - 1)
    offset = middle * (1.0 - 1.0 / scale) - np.divide(shift, scale)
    moved = affine_transform(scene, [1.0 / scale] * 2, offset, order=3, mode="grid-wrap")
    made = [draw.poisson(np.maximum(blurred(x, r), 0.0)) for x, r in zip((scene, moved), radii, strict=True)]
    if quality is None:
        return np.array(made, dtype=np.float32)
    seen = []
    for one in made:
        file = io.BytesIO()
        coded = np.clip(np.round(255.0 * (one / 800.0) ** (1.0 / 2.2)), 0, 255).astype(np.uint8)
        Image.fromarray(coded).save(file, "JPEG", quality=quality)
        seen.append((np.asarray(Image.open(file)) / 255.0) ** 2.2)
    return np.array(seen, dtype=np.float32)


ALL = np.ones((SIDE, SIDE), dtype=bool)


@pytest.mark.parametrize("quality", [None, 85])
@pytest.mark.parametrize("scale", [0.99, 1.02])
def test_the_magnification_of_a_frame_is_found(scale, quality):
    found = frame_scales(frames(scale, quality), ALL, 6.0)
    np.testing.assert_allclose(found, (1.0, scale), atol=2e-3)


@pytest.mark.parametrize("quality", [None, 85])
def test_frames_of_one_magnification_and_small_frames_have_none(quality):
    pair = frames(1.0, quality)
    assert frame_scales(pair, ALL, 6.0) == ()
    assert frame_shift(pair, ALL, 6.0) == ()
    assert frame_scales(frames(1.0, quality, (1.0, -2.0)), ALL, 6.0) == ()
    small = slice(24, -24)
    assert frame_scales(frames(0.98)[:, small, small], ALL[small, small], 6.0) != ()
    small = slice(26, -26)
    assert frame_scales(frames(0.98)[:, small, small], ALL[small, small], 6.0) == ()


def test_unknown_pixels_do_not_count():
    pair, known = frames(0.99).copy(), ALL.copy()
    known[80:90, 30:200] = False
    pair[:, ~known] = np.nan
    np.testing.assert_allclose(frame_scales(pair, known, 6.0), (1.0, 0.99), atol=2e-3)


def test_a_magnification_is_an_error_where_the_noise_is_estimated_or_the_frames_differ():
    estimated = DefocusVerdict.of(
        1.0, noise=EstimatedNoise(Noise(white=1e4, read=3.0)), magnifications=[(1.0, 0.0), (0.99, 1e-3)]
    )
    assert "magnified 0.9900 +- 0.0010 times the first" in estimated.findings.get("misfit").text
    assert estimated.status == "misfit"
    noise = EstimatedNoise(Noise(white=1e4, read=3.0))
    unsure = DefocusVerdict.of(1.0, noise=noise, excess=20.0, likely=[(1.0, 0.0), (0.984, 1e-3)]).findings.get(
        "misfit"
    )
    assert "by about 0.984 times the first" in unsure.text
    assert unsure.numbers["magnifications"] == (1.0, 0.984)
    assert DefocusVerdict.of(1.5, magnifications=[(1.0, 0.0), (0.99, 1e-3)]).status == "misfit"
    assert DefocusVerdict.of(1.0, magnifications=[(1.0, 0.0), (0.99, 1e-3)]).findings.get("misfit") is None


def test_a_number_is_the_magnification_of_the_second_frame():
    pair = frames(0.99)
    registered = Registration(Magnified(magnification=0.99).magnification, [LENS, LENS.focused(1.8)], ALL.shape, 1)
    assert registered.scales == (1.0, 0.99)
    seen = np.array(registered(list(pair), np.inf, ALL.view(np.uint8)))
    known = np.isfinite(seen).all(axis=0)
    assert frame_scales(np.nan_to_num(seen), known, 6.0) == ()


@pytest.mark.parametrize("wrong", ["lense", 0.7, 1.3, None, np.nan])
def test_other_magnifications_are_refused(wrong):
    with pytest.raises((TypeError, ValueError), match="magnification"):
        Magnified(magnification=wrong)
    with pytest.raises(ValueError, match="name for 3 images"):
        Registration(0.99, [LENS] * 3, (8, 8), 1)


def test_planes_that_are_magnified_or_shifted_are_refused_with_the_number():
    lenses, distances = [LENS, LENS.focused(1.8)], [1.5]
    for made, text in (
        (frames(0.99), r"magnified 0\.99\d\d times the first, .* state this magnification"),
        (frames(1.0, None, (0.0, 2.0)), r"plane at 1\.5 m is shifted by .* and [12]\.[09] right: align"),
    ):
        with pytest.raises(ValueError, match=text):
            lm.imaging.calibrate_focus([made / 1e3], distances, lenses, 4e-6, encoding="linear", origin=0.0)
