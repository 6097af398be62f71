"""Photographs with a measured PSF: an asymmetric blur, drawn and convolved without this package."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter, zoom
from scipy.signal import fftconvolve

import lommel as lm
from lommel.fit.findings import Findings
from lommel.imaging import RichardsonLucy, restore
from lommel.imaging.measured_blur import MeasuredBlur
from lommel.measures.measured_psf import MeasuredPSF

SIDE, HALF, LIGHT, PIXEL = 120, 15, 5000.0, 4e-6
NOISE = lm.Noise(white=LIGHT, read=3.0)


def drawn(row: float = 0.0, column: float = 0.0) -> np.ndarray:
    """Return an ellipse that is brighter on one side, displaced by a part of a pixel."""
    y, x = np.mgrid[-HALF : HALF + 1, -HALF : HALF + 1] - np.array([row, column])[:, None, None]
    window = gaussian_filter(np.clip(3.0 - np.hypot(y, 1.6 * x), 0.0, 1.0) * (1.0 + 0.15 * y), 0.7)
    return window / window.sum()


def photograph(window: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    draw = np.random.default_rng(1)
    scene = np.where(gaussian_filter(draw.standard_normal((SIDE + 2 * HALF,) * 2), 3.0) > 0.0, 0.6, 0.2)
    seen = fftconvolve(scene, window, "valid")
    return (draw.poisson(seen * LIGHT) + draw.normal(0.0, 3.0, seen.shape)) / LIGHT, scene[HALF:-HALF, HALF:-HALF]


def point(window: np.ndarray) -> np.ndarray:
    draw = np.random.default_rng(2)
    return (draw.poisson(3e5 * window + 30.0) + draw.normal(0.0, 3.0, window.shape)) / LIGHT


def error(light: np.ndarray, scene: np.ndarray) -> float:
    return float(np.std((light - scene)[8:-8, 8:-8]))


def test_image_of_a_point_is_centred_and_normalised():
    """Its centroid comes to the middle pixel, and its background is subtracted."""
    found = lm.PSF.measured(point(drawn(0.4, -0.3)), PIXEL)
    assert found.values.shape == (1, 31, 31)
    assert found.values.sum() == pytest.approx(1.0)
    light, place = np.maximum(found.values[0], 0.0), np.arange(31) - 15
    assert [light.sum(1) @ place, light.sum(0) @ place] == pytest.approx([0.0, 0.0], abs=0.05)
    middle = drawn()
    assert 0.5 * np.abs(light - middle).sum() < 0.15
    assert "31 x 31 pixels, noise of" in found.findings[0].text


@pytest.mark.parametrize("method", [None, RichardsonLucy()])
def test_photograph_is_restored_by_the_image_of_a_point(method):
    photo, scene = photograph(drawn())
    found = restore(
        photo, None, lm.PSF.measured(point(drawn()), PIXEL), encoding="linear", noise=NOISE, method=method
    )
    assert found.reliable
    assert "measured_psf" in found.findings.codes
    assert error(found.light, scene) < 0.8 * error(photo, scene)


def test_psf_that_is_too_wide_is_a_doubt():
    """The result is not below the photograph, and ``accept=True`` restores by the narrower PSF."""
    photo, scene = photograph(drawn())
    wide = zoom(point(drawn()), 45 / 31, order=3)
    found, accepted = (
        restore(photo, None, lm.PSF.measured(wide, PIXEL), encoding="linear", noise=NOISE, accept=accept)
        for accept in (False, True)
    )
    doubt = found.findings.get("blur_doubtful")
    assert doubt.numbers["factor"] == pytest.approx(31 / 45, abs=0.06)
    assert error(found.light, scene) < 1.001 * error(photo, scene)
    assert accepted.reliable
    assert error(accepted.light, scene) < 0.8 * error(photo, scene)


def test_psf_of_another_photograph_is_a_misfit():
    photo, _ = photograph(drawn())
    wide = lm.PSF.measured(gaussian_filter(drawn(), 2.5), PIXEL, background=0.0)
    found = restore(photo, None, wide, encoding="linear", noise=NOISE)
    assert not found.converged
    np.testing.assert_allclose(found.light, photo, atol=1e-6)


def test_channels_have_their_own_psfs_and_pixels_may_differ():
    windows = [drawn(), drawn().T]
    blur = MeasuredBlur.of((60, 50, 2), [lm.PSF.measured(w, PIXEL, background=0.0) for w in windows], None)
    draw = np.random.default_rng(3)
    x, y = draw.standard_normal((2, 60, 50, 2)).astype(np.float32)
    forward = blur.forward(x)
    assert np.vdot(forward, y) == pytest.approx(np.vdot(x, blur.adjoint(y)), rel=1e-3)
    for channel, window in enumerate(windows):
        expected = fftconvolve(np.pad(x[..., channel], HALF, mode="symmetric"), window, "valid")
        assert np.std(forward[..., channel] - expected) < 0.15 * np.std(expected)
    finer = MeasuredBlur.of((60, 70), [lm.PSF.measured(windows[0], PIXEL, background=0.0)], 0.5 * PIXEL)
    assert len(finer.window(0, 0)) > 1.5 * len(blur.window(0, 0))


def test_refused():
    photo, image = np.full((60, 50, 3), 0.5), lm.PSF.measured(drawn(), PIXEL, background=0.0)
    stack = MeasuredPSF(np.ones((5, 9, 9)) / 405.0, PIXEL, PIXEL, 1, Findings([]))
    for lens, depth, message in (
        ([image, image], None, "one for each of 3 channels, got 2"),
        (stack, None, "got that of a stack of 5 planes"),
        (image, 2.0, "depth and pixel are for a Lens"),
    ):
        with pytest.raises(ValueError, match=message):
            restore(photo, depth, lens, encoding="linear", noise=NOISE)
    with pytest.raises(ValueError, match="more than the shorter side of the photograph"):
        restore(np.full((9, 60), 0.5), None, image, encoding="linear", noise=NOISE)
    with pytest.raises(ValueError, match="microscope is for a stack"):
        lm.PSF.measured(drawn(), PIXEL, microscope=1)
    with pytest.raises(ValueError, match="got that of a photograph, which has one plane"):
        lm.microscopy.deconvolve(np.ones((9, 40, 40)), image)
