"""Checks of pictures of edges: each fault that changes the response has a finding, and right pictures have none."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image
from scipy.ndimage import convolve, gaussian_filter

import lommel as lm
from lommel.imaging.edge_checks import require_one_colour
from slanted_edges import gaussian, picture

SIGMA = 0.6
LIGHT = 0.25 + 0.5 * picture(5.0, SIGMA, (80, 80), 8)  # 0.3 and 0.7
F = np.array([0.1, 0.2, 0.3, 0.4])


def noisy(light, electrons=1e5, seed=0):
    return np.random.default_rng(seed).poisson(np.maximum(light, 0.0) * electrons) / electrons


PHOTO = noisy(LIGHT)


def srgb(light):
    return np.where(light < 0.0031308, 12.92 * light, 1.055 * np.maximum(light, 0.0) ** (1 / 2.4) - 0.055)


def bytes_of(values):
    return np.clip(255.0 * values, 0.0, 255.0).round().astype(np.uint8)


def unsharp(image, amount=1.0):
    return image + amount * (image - gaussian_filter(image, 1.0))


def demosaiced(image):
    y, x = np.indices(image.shape)
    kernel = np.array([[0.0, 1.0, 0.0], [1.0, 4.0, 1.0], [0.0, 1.0, 0.0]]) / 4.0
    return convolve(np.where((x + y) % 2, image, 0.0), kernel, mode="mirror")


def jpeg(values, quality=60):
    data = io.BytesIO()
    Image.fromarray(bytes_of(values)).save(data, "JPEG", quality=quality)
    return np.asarray(Image.open(data))


def hot(image):
    image = image.copy()
    image[[30, 55], [42, 37]] = 6.0, 0.0
    return image


ACROSS = (np.arange(80) - 40.0) / 80.0
BENT = 0.25 + 0.5 * picture(5.0, SIGMA, (80, 80), 8, curvature=1.0 / 1600)
FAULTS = {
    "clipped": (np.minimum(noisy(2.0 * LIGHT), 1.0), "flat_top"),
    "clipped by a few levels": (np.minimum(bytes_of(noisy(LIGHT, 2000.0)), 160), "flat_top"),
    "clipped without noise": (np.minimum(2.0 * LIGHT, 1.0), "asymmetric"),
    "dark with light": (noisy(np.sqrt(picture(5.0, 1.2, (80, 80), 8)), 20000.0), "asymmetric"),
    "sharpened": (unsharp(PHOTO), "sharpened"),
    "demosaiced": (demosaiced(PHOTO), "correlated_noise"),
    "denoised": (gaussian_filter(PHOTO, 0.5), "correlated_noise"),
    "compressed": (jpeg(PHOTO), "compressed"),
    "hot pixels": (hot(PHOTO), "outliers"),
    "shaded across": (noisy(LIGHT * (1.0 + 0.4 * ACROSS)), "uneven_light"),
    "shaded along": (noisy(LIGHT * (1.0 + 0.2 * ACROSS[:, None])), "uneven_light"),
    "curved": (noisy(BENT), "curved_edge"),
    "rounded noise": (bytes_of(0.97 * noisy(LIGHT, 1e7)), "too_quiet"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_of_the_picture_has_a_finding(fault):
    image, code = FAULTS[fault]
    found = lm.sfr(image)
    assert code in found.findings.codes
    # What is corrected is a note, and right; the rest is in doubt.
    off = np.abs(found(F) - gaussian(F, found.angle, SIGMA)).max()
    assert not found.reliable or off < 0.02


def test_another_encoding_shows_in_the_symmetry_of_the_profile():
    image = noisy(0.05 + 0.85 * picture(5.0, 1.5, (80, 80), 8))
    assert lm.sfr(image).reliable
    assert lm.sfr(bytes_of(srgb(image)), encoding="srgb").reliable
    found = lm.sfr(srgb(image)).findings.get("asymmetric")
    assert found.severity == "doubt"
    assert found.numbers["power"] > 1.5
    assert found.numbers["encoding"] == "srgb"
    found = lm.sfr(bytes_of(image), encoding="srgb").findings.get("asymmetric")
    assert found.numbers["power"] < 0.7
    assert "values are linear, not sRGB: give encoding='linear'" in found.text


@pytest.mark.parametrize("seed", range(8))
def test_right_pictures_have_no_findings(seed):
    light = 0.05 + 0.85 * picture((3.0, -8.0)[seed % 2], (0.4, 0.8, 1.5)[seed % 3], (60, 70), 8)
    image = noisy(light, (3000.0, 30000.0)[seed // 4], seed)
    for found in (lm.sfr(image), lm.sfr(bytes_of(srgb(image)), encoding="srgb")):
        assert {*found.findings.codes} <= {"untested"}  # what one crop shows of sharpening


@pytest.mark.parametrize(
    ("black", "white", "status"),
    [(0.15, 2.0, "doubtful"), (0.105, 2.0, "doubtful"), (0.05, 2.0, "converged"), (0.0, 0.903, "doubtful")],
)
def test_noise_that_ends_at_one_value_is_clipped(black, white, status):
    # Levels 0.1 and 0.9 with noise of 0.01: a black level above the dark side, within its noise, and a white level.
    light = np.random.default_rng(2).normal(picture(5.0, 0.6, (80, 80), 8), 0.01)
    stored = np.rint(30000.0 * np.clip(light - black, 0.0, white)).astype(np.uint16)
    found = lm.sfr(stored, encoding="linear")
    assert found.status == status
    assert ("clipped" in found.findings.codes) == (status == "doubtful")


def test_clipped_noise_moves_a_side_by_the_stated_amount():
    light = np.random.default_rng(2).normal(picture(5.0, 0.6, (80, 80), 8), 0.05)
    (clipped,) = [f for f in lm.sfr(np.maximum(light - 0.1, 0.0)).findings if f.code == "clipped"]
    assert clipped.numbers["moved"] == pytest.approx(0.05 / np.sqrt(2.0 * np.pi) / 0.8, rel=0.1)


def test_the_size_of_the_values_moves_no_finding():
    light = np.random.default_rng(0).normal(picture(5.0, 0.6, (80, 80), 8), 0.01)
    for encoded in (light, light**2):  # in light, and a likely sRGB
        small, large = (lm.sfr(scale * encoded, encoding="linear").findings for scale in (1.0, 60000.0))
        assert small.codes == large.codes
        for one, other in zip(small, large, strict=True):
            sizes = [{k: v for k, v in f.numbers.items() if isinstance(v, float)} for f in (one, other)]
            assert sizes[0] == pytest.approx(sizes[1], rel=1e-6)


def test_a_flat_side_with_brighter_pixels_elsewhere_is_not_clipped():
    clipped = np.minimum(bytes_of(noisy(LIGHT, 2000.0)), 160)
    assert "flat_top" in lm.imaging.sfr_chart(clipped).findings.codes
    # Beside another edge, the same values are not the largest ones.
    light = np.concatenate([LIGHT, LIGHT * 1.2])
    image = bytes_of(noisy(light, 2000.0))
    image[:80] = np.minimum(image[:80], 160)
    found = lm.imaging.sfr_chart(image)
    assert len(found.edges) == 2
    assert "flat_top" not in found.findings.codes
    text = found.edges[0].response.findings.get("asymmetric").text
    assert "most pixels of the bright side have the value 160" in text


def test_jpeg_is_compression_and_its_errors_are_those_of_the_picture():
    light = 0.05 + 0.85 * picture(5.0, 0.5, (96, 96), 8)
    found = lm.sfr(jpeg(srgb(noisy(light, 20000.0))), encoding="srgb")
    assert {"compressed", "correlated_noise"} <= {*found.findings.codes}
    assert not {"sharpened", "flat_top"} & {*found.findings.codes}
    # Its flat areas have no noise at all; ripples beside the edge count.
    flat = lm.sfr(jpeg(srgb(light), 30), encoding="srgb")
    assert np.interp(0.3, flat.frequencies, flat.errors) > 5e-3


def test_a_step_of_the_light_beside_an_edge_is_uneven_light_and_no_sharpening():
    x = np.arange(80)
    found = lm.sfr(noisy((LIGHT - 0.2) * np.where(x >= 72, 1.08, 1.0), 20000.0))
    assert "sharpened" not in found.findings.codes
    assert "differs from its trend" in found.findings.get("uneven_light").text
    assert not found.reliable


def test_a_halo_that_a_subtracted_trend_of_the_light_hides_is_a_doubt():
    # The approach to the sides of a lens at f/16, 0.17 pixels / distance, and light that falls across the picture.
    y, x = np.indices((74, 74)) - 36.5
    d = (x - 0.06 * y) / np.hypot(1.0, 0.06)
    light = 24.0 + 36.0 * (0.5 + np.arctan(d / 0.53) / np.pi) - 0.03 * d
    image = np.random.default_rng(2).normal(light, 0.5)
    found = lm.sfr(image)
    (finding,) = (one for one in found.findings if one.code == "uneven_light")
    assert finding.severity == "doubt"
    assert "moves the response by up to 0.0" in finding.text
    f = np.array([0.05, 0.1, 0.15])
    off = found(f) - np.exp(-2.0 * np.pi * 0.53 * f)
    assert np.all(np.abs(off) < 2.0 * np.interp(f, found.frequencies, found.errors))
    # A sharper edge hides less.
    sharp = np.random.default_rng(2).normal(24.0 + 36.0 * picture(4.0, 0.5, (74, 74), 8) - 0.03 * d, 0.5)
    assert lm.sfr(sharp).reliable


def test_a_slope_of_the_light_is_no_mosaic():
    # In a narrow picture of a wide blur, most pixels lie in the slope of the edge.
    ramp = np.tile(np.linspace(0.05, 0.85, 40), (60, 1))
    for image in (ramp, ramp[:, ::-1], ramp.T):
        require_one_colour(image, np.ones(image.shape, bool))
    y, x = np.indices(ramp.shape)
    with pytest.raises(ValueError, match="got a mosaic"):
        require_one_colour(ramp * np.where((x + y) % 2, 1.0, 0.9), np.ones(ramp.shape, bool))
