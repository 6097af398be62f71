"""Mild sharpening shows in the noise of all edges of a picture together; smooth light is no denoising."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

import lommel as lm
from lommel.imaging import edge_noise
from lommel.imaging.slanted_edge import edge_response, image_counts
from slanted_edges import across, picture, squares

CHART = squares((160, 320), [(-80.0, 0.0), (80.0, 0.0)], 70.0, 0.8)
EDGE = 0.1 + 0.65 * across((np.arange(90) - 44.5) * 0.996 - 0.087 * (np.arange(120)[:, None] - 59.5), 0.7)


def noisy(light, electrons=10000.0, seed=0):
    return np.random.default_rng(seed).poisson(light * electrons) / electrons


def unsharp(image, amount, radius=1.0):
    return image + amount * (image - gaussian_filter(image, radius))


@pytest.mark.parametrize("seed", [0, 1])
def test_mild_sharpening_is_told_of_all_edges_though_of_none_alone(seed):
    image = noisy(CHART, seed=seed)
    assert lm.imaging.sfr_chart(image).reliable
    found = lm.imaging.sfr_chart(unsharp(image, 0.2))
    finding = found.findings.get("sharpened")
    assert not found.reliable
    assert finding.text.startswith("8 of 8 edges")
    assert -0.06 < finding.numbers["correlation"] < -0.01
    assert finding.numbers["strength"] < -4.0
    assert all("sharpened" in edge.response.findings.codes for edge in found.edges)


@pytest.mark.parametrize(("size", "told"), [(-0.008, True), (0.008, False)])
def test_equal_correlations_at_all_lags_are_wide_sharpening_if_negative_and_light_if_positive(size, told):
    evidence = edge_response(image_counts(noisy(EDGE)), None, "linear", None)[1][""]
    pairs = np.full_like(evidence.neighbours.pairs, 5e4)
    edge = replace(evidence, neighbours=replace(evidence.neighbours, products=size * pairs, pairs=pairs))
    assert (abs(edge_noise._correlation([edge]).strength) > 4.0) == told


@pytest.mark.parametrize(("amount", "radius"), [(0.3, 1.0), (0.5, 1.5), (0.3, 4.0)])
def test_a_crop_that_is_sharpened_is_told_alike_by_both_functions(amount, radius):
    image = unsharp(noisy(EDGE, seed=5), amount, radius)
    one, chart = lm.sfr(image), lm.imaging.sfr_chart(image)
    assert one.findings.codes == chart.findings.codes == ("sharpened",)
    assert np.array_equal(one.values, chart.edges[0].response.values)


@pytest.mark.parametrize("seed", range(3))
def test_light_that_falls_off_smoothly_is_no_fault(seed):
    y, x = (np.linspace(-1.0, 1.0, side) for side in EDGE.shape)
    found = lm.sfr(noisy(EDGE * (1.0 - 0.015 * x**2 - 0.015 * y[:, None] ** 2), seed=seed))
    assert found.reliable
    assert not {"sharpened", "correlated_noise"} & {*found.findings.codes}


def test_the_halo_of_a_blur_is_no_noise():
    light = 0.9 * picture(5.0, 0.6, (90, 90), 6) + 0.1 * picture(5.0, 9.0, (90, 90), 6)
    found = lm.sfr(noisy(light, 1e6))
    assert "correlated_noise" not in found.findings.codes


def test_sharpening_of_the_bright_side_alone_is_told_if_it_is_large():
    # The dark side is clipped at black.
    image = np.maximum(unsharp(EDGE, 1.0) - 0.15, 0.0)
    assert "sharpened" in lm.sfr(image).findings.codes


def test_a_crop_says_which_filters_and_encodings_it_does_not_exclude():
    image = noisy(EDGE, seed=3)
    numbers = [lm.sfr(part).findings.get("untested").numbers["filter"] for part in (image[30:90], image)]
    assert 0.05 < numbers[1] < 0.8 * numbers[0] < 0.4
    # The profile of a Gaussian blur to the power of 2.2 is nearly as symmetric.
    dim = noisy(0.25 + 0.5 * picture(5.0, 0.5, (80, 80), 8), 2000.0)
    assert lm.sfr(dim).findings.get("untested").numbers["encoding"] > 0.05


@pytest.mark.parametrize(("size", "code"), [(0.008, None), (0.03, "correlated_noise"), (-0.008, "sharpened")])
def test_a_small_correlation_that_light_may_leave_is_no_denoising(size, code, monkeypatch):
    found = edge_noise._Correlation(size, 5.0 if size > 0.0 else -5.0, 2.0, 0.01, 1e5)
    monkeypatch.setattr(edge_noise, "_correlation", lambda edges: found)
    codes = lm.sfr(noisy(EDGE)).findings.codes
    assert {"correlated_noise", "sharpened"} & {*codes} == ({code} if code else set())


def test_areas_that_were_denoised_beside_an_edge_that_was_not_are_told():
    image = noisy(EDGE, 3000.0, seed=2)
    smooth = gaussian_filter(image, 2.0)
    kept = np.clip(np.hypot(*np.gradient(smooth)) / 0.01, 0.0, 1.0)
    finding = lm.sfr((255.0 * (kept * image + (1.0 - kept) * smooth)).round().astype(np.uint8)).findings
    assert "correlated_noise" in finding.codes


def test_a_tone_curve_that_a_picture_does_not_exclude_is_stated_with_its_effect():
    light = noisy(0.05 + 0.7 * across((np.arange(90) - 44.5) * 0.996 - 0.087 * (np.arange(120)[:, None] - 59.5), 0.7))
    encoded = np.where(light < 0.0031308, 12.92 * light, 1.055 * np.maximum(light, 0.0) ** (1 / 2.4) - 0.055)
    curved = 0.5 * encoded + 0.5 * encoded**2 * (3.0 - 2.0 * encoded)
    right, wrong = (lm.sfr((255.0 * part).round().astype(np.uint8), encoding="srgb") for part in (encoded, curved))
    change = np.abs(right.values - wrong.values).max()
    assert change > 0.03
    for found in (right, wrong):
        finding = found.findings.get("untested")
        assert 0.7 * change < finding.numbers["curve"] < 2.0 * change
        assert finding.text.startswith(f"not excluded: tone curve (MTF ±{finding.numbers['curve']:.1g}), ")
        assert finding.numbers["encoding"] < 0.02
        assert "encoding" not in finding.text
    # Raw pictures have none.
    assert "tone curve" not in str(lm.sfr(light).findings.get("untested"))


@pytest.mark.parametrize(("strength", "electrons"), [(0.0, 3000.0), (0.5, 2e4)])
def test_a_tone_curve_shows_in_the_noise_of_areas_of_different_light(strength, electrons):
    light = noisy(CHART * np.where(np.arange(CHART.shape[1]) < 160, 1.05, 0.6), electrons)
    encoded = np.where(light < 0.0031308, 12.92 * light, 1.055 * np.maximum(light, 0.0) ** (1 / 2.4) - 0.055)
    curved = (1.0 - strength) * encoded + strength * encoded**2 * (3.0 - 2.0 * encoded)
    found = lm.imaging.sfr_chart((65535.0 * curved).round().astype(np.uint16), encoding="srgb")
    assert ("tone_curve" in found.findings.codes) == (strength > 0.0)
    assert found.reliable == (strength == 0.0)
    assert "tone curve (" not in str(found.findings.get("untested"))
    if strength:
        f = np.linspace(0.05, 0.4, 8)
        right = lm.imaging.sfr_chart(light).edges
        change = [a.response(f) - b.response(f) for a, b in zip(found.edges, right, strict=True)]
        expected = np.median(np.abs(change).max(axis=1))
        assert expected > 0.03
        assert found.findings.get("tone_curve").numbers["curve"] == pytest.approx(expected, rel=0.5)


def test_errors_contain_the_correlation_of_noise():
    # A filter of the picture changes response and noise alike.
    image = noisy(EDGE, 5000.0, seed=4)
    raw, filtered = lm.sfr(image), lm.sfr(gaussian_filter(image, 0.8))
    f = np.array([0.15, 0.25, 0.35])
    errors = [np.interp(f, one.frequencies, one.errors) for one in (raw, filtered)]
    np.testing.assert_allclose(errors[1] / errors[0], np.exp(-2.0 * (np.pi * 0.8 * f) ** 2), rtol=0.35)
    assert filtered.mtf50[1] < raw.mtf50[1]
