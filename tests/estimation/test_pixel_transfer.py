"""Transfer functions of pixel-averaged PSFs, against those of the wavefront, folded."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.estimation.pixel_transfer import half_window, multiplicity, pixel_transfer, squared_frequency

PIXEL = 4e-6


def folded(lens, distance, shape, reach=3):
    """The transfer function of the wavefront times that of the pixel, at all frequencies that sampling folds."""
    down, across = (np.arange(side // 2 + 1)[:, None] / side for side in shape)
    across = across.T
    radius = np.linspace(0.0, 1.5 * (reach + 0.5), 3000)
    on_axis = lm.otf(lens.pupil(distance), radius / PIXEL, tol=1e-8).real
    total = 0.0
    for row in range(-reach, reach + 1):
        for column in range(-reach, reach + 1):
            fx, fy = across + column, down + row
            total = total + np.interp(np.hypot(fx, fy), radius, on_axis) * np.sinc(fx) * np.sinc(fy)
    return total


@pytest.mark.parametrize(
    ("f_number", "aberrations"), [(8.0, lm.Wavefront()), (4.0, lm.Wavefront(spherical=2.0)), (2.8, lm.Wavefront())]
)
def test_it_is_the_transfer_function_of_the_wavefront_and_of_the_pixel_folded(f_number, aberrations):
    lens = lm.Lens(
        focal_length=35e-3, f_number=f_number, focus_distance=1.35, wavelength=540e-9, aberrations=aberrations
    )
    distances = np.array([1.2, 1.35, 1.8])
    half = half_window([lens], distances, PIXEL)
    shape = (100, 96)
    found = pixel_transfer(lens, distances, [(540e-9, 1.0)], PIXEL, shape, half)
    assert found.shape == (3, 51, 49)
    assert found[:, 0, 0] == pytest.approx(1.0, abs=1e-6)  # no light is lost
    for k, distance in enumerate(distances):
        assert found[k] == pytest.approx(folded(lens, distance, shape), abs=2.5e-3)
        # Beyond the lowest frequencies, which see how light falls outside of the image, it is nearer.
        assert found[k][8:, 8:] == pytest.approx(folded(lens, distance, shape)[8:, 8:], abs=3e-4)


def test_a_spectrum_is_the_sum_of_its_colours():
    lens = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.35, wavelength=540e-9)
    distances = np.array([1.5])
    half = half_window([lens], distances, PIXEL)
    parts = [pixel_transfer(lens, distances, [(wave, 1.0)], PIXEL, (64, 64), half) for wave in (600e-9, 460e-9)]
    both = pixel_transfer(lens, distances, [(600e-9, 0.25), (460e-9, 0.75)], PIXEL, (64, 64), half)
    assert both == pytest.approx(0.25 * parts[0] + 0.75 * parts[1], abs=1e-6)
    assert np.abs(parts[0] - parts[1]).max() > 0.05


@pytest.mark.parametrize("shape", [(6, 8), (7, 5), (1, 4)])
def test_each_frequency_stands_for_itself_and_its_mirror_images(shape):
    down, across = np.fft.fftfreq(shape[0])[:, None], np.fft.fftfreq(shape[1])
    square = squared_frequency(shape)
    assert multiplicity(shape).sum() == pytest.approx(1.0)
    assert float((multiplicity(shape) * np.exp(square)).sum()) == pytest.approx(np.exp(down**2 + across**2).mean())
