"""The response of slanted edges: against integrals of Gaussian blur, and the MTF of lenses that rendered them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from PIL import Image, ImageDraw
from scipy.optimize import brentq
from scipy.special import ndtr

import lommel as lm
from lommel.imaging.edge_profile import half
from slanted_edges import gaussian, picture

PIXEL = 4e-6


@pytest.mark.parametrize("degrees", [2.5, 5.0, 12.0, 15.0, 20.0, 35.0])  # 15, 20 and 35: near 4/15, 4/11 and 7/10
def test_the_response_is_that_of_blur_and_pixel(degrees):
    found = lm.sfr(picture(degrees), PIXEL)
    assert np.degrees(found.angle) == pytest.approx(degrees, abs=0.01)
    assert found.contrast == pytest.approx(0.8, abs=1e-4)
    assert found.frequencies[-1] == pytest.approx(0.5 / PIXEL)
    np.testing.assert_allclose(found.values, gaussian(found.frequencies * PIXEL, found.angle), atol=1e-3)
    assert found.errors.max() < 1e-4


@pytest.mark.parametrize("degrees", [3.0, 8.0, 31.0])  # 31: near 3/5, gaps of 0.17 pixels
@pytest.mark.parametrize("width", [0.3, 1.2])
def test_gaussian_edges_integrated_over_pixels_have_their_response(degrees, width):
    across, down = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    rows, columns = np.indices((90, 120)) - np.reshape([44.5, 59.3], (2, 1, 1))

    def twice(distance):
        """Integrate the normal distribution twice, which makes differences those of pixels."""
        u = distance / width
        return 0.5 * width**2 * ((u * u + 1.0) * ndtr(u) + u * np.exp(-0.5 * u * u) / math.sqrt(2.0 * np.pi))

    signs = (-1, 1)
    corners = [(a * b, 0.5 * (a * across + b * down)) for a in signs for b in signs]
    d = columns * across + rows * down
    found = lm.sfr(0.1 + 0.8 * sum(sign * twice(d + shift) for sign, shift in corners) / (across * down))
    f = found.frequencies
    expected = np.exp(-2.0 * (np.pi * width * f) ** 2) * np.sinc(f * across) * np.sinc(f * down)
    np.testing.assert_allclose(found.values, expected, atol=1e-3)


@pytest.mark.parametrize("degrees", [5.0, 17.0, 31.0, 44.0])
def test_edges_of_another_rasteriser_have_the_response_of_pixels(degrees):
    fine, (height, width) = 16, (90, 120)
    drawn = Image.new("L", (width * fine, height * fine), 20)
    middle, shift = 0.5 * width * fine + 3.7, 0.5 * height * fine * math.tan(math.radians(degrees))
    right, bottom = width * fine, height * fine
    ImageDraw.Draw(drawn).polygon(
        [(middle + shift, 0), (right, 0), (right, bottom), (middle - shift, bottom)], fill=200
    )
    found = lm.sfr(np.asarray(drawn, float).reshape(height, fine, width, fine).mean(axis=(1, 3)))
    f = found.frequencies
    expected = np.sinc(f * np.cos(found.angle)) * np.sinc(f * np.sin(found.angle))
    np.testing.assert_allclose(found.values, expected, atol=2e-3)


def test_edges_of_all_orientations_and_signs_have_one_response():
    image = picture(7.0, shape=(90, 90))
    expected = lm.sfr(image, PIXEL)
    for other in (image[::-1], image[:, ::-1], 1.0 - image, image.T, image.T[::-1], 300.0 * image):
        found = lm.sfr(other, PIXEL)
        np.testing.assert_allclose(found.values, expected.values, atol=2e-4)
        normal = np.abs([np.cos(found.angle), np.sin(found.angle)])
        level = other is not image and np.ptp(other.mean(axis=1)) > np.ptp(other.mean(axis=0))
        assert normal[int(level)] == pytest.approx(np.cos(np.radians(7.0)), abs=1e-3)


def test_the_angle_is_that_of_the_normal_with_its_sign():
    # A blur along (1, -tan(7)) alone: seen by the edge whose normal it is.
    for image in (picture(7.0), picture(7.0)[::-1]):
        angle = lm.sfr(image, PIXEL).angle
        rows, columns = np.indices(image.shape) - np.reshape([39.5, 59.5], (2, 1, 1))
        along = columns * np.cos(angle) + rows * np.sin(angle)
        assert image[along > 3.0].min() > 0.89 > 0.11 > image[along < -3.0].max()


def test_noise_moves_values_by_their_standard_errors():
    rng, image = np.random.default_rng(1), picture(5.0)
    found = [lm.sfr(image + rng.normal(0.0, 0.01, image.shape), PIXEL) for _ in range(60)]
    pulls = np.array(
        [(one.values - gaussian(one.frequencies * PIXEL, one.angle))[5:] / one.errors[5:] for one in found]
    )
    assert 0.85 < np.sqrt(np.mean(pulls**2)) < 1.15
    assert abs(pulls.mean()) < 0.3
    right = brentq(lambda f: gaussian(f, found[0].angle) - 0.5, 0.1, 0.4) / PIXEL
    assert 0.8 < np.sqrt(np.mean([((one.mtf50[0] - right) / one.mtf50[1]) ** 2 for one in found])) < 1.2


@pytest.mark.parametrize(("distance", "f_number"), [(2.0, 4.0), (1.95, 2.8)])
def test_an_edge_that_a_lens_renders_has_the_mtf_of_the_lens(distance, f_number):
    lens = lm.Lens(focal_length=50e-3, f_number=f_number, focus_distance=2.0, wavelength=550e-9)
    edge = lm.imaging.slanted_edge((96, 160), angle=5.0, supersample=8)
    photo = lm.imaging.depth_of_field(
        edge, np.full(edge.shape, distance), lens, PIXEL, encoding="linear", supersample=8, energy=0.995, tol=1e-2
    )
    found = lm.sfr(photo.values, PIXEL)
    across = found.frequencies * np.cos(found.angle), found.frequencies * np.sin(found.angle)
    expected = lm.mtf(lens.pupil(distance), *across, pixel=PIXEL) * np.sinc(found.frequencies * PIXEL / 8)
    np.testing.assert_allclose(found.values, expected, atol=6e-3)  # 0.005 of the light lies beyond the windows
    assert found(31250.0) == pytest.approx(np.interp(31250.0, found.frequencies, found.values))


EDGE = picture(5.0)


@pytest.mark.parametrize(
    ("image", "message"),
    [
        (np.full((40, 40), 0.5), "must show one edge"),
        (np.random.default_rng(0).random((40, 40)), "must show one edge"),
        (picture(0.5), "2 to 45 degrees"),
        (picture(45.0, shape=(60, 90)), "not a simple fraction"),
        (picture(np.degrees(np.arctan(1.0 / 3.0))), "not a simple fraction such as 1/3"),
        (picture(30.0, shape=(60, 40)), "must show the edge from end to end"),
        (EDGE[:10], "20 pixels or more"),
        (EDGE[..., None], "20 pixels or more"),
        (np.where(EDGE > 0.89, np.nan, EDGE), "image"),
        (np.full((40, 40), 65535, np.uint16), "overexposed"),
    ],
)
def test_pictures_without_a_slanted_edge_are_refused(image, message):
    with pytest.raises(ValueError, match=message):
        lm.sfr(image, PIXEL)


def test_frequencies_beyond_nyquist_are_refused():
    with pytest.raises(ValueError, match="frequency must be at most the Nyquist frequency, 125 cycles/mm"):
        lm.sfr(EDGE, PIXEL)(130e3)


def test_a_target_is_covered_by_the_share_of_the_light_side():
    edge = lm.imaging.slanted_edge((10, 30), angle=10.0, supersample=4)
    assert edge.shape == (40, 120)
    assert (edge.min(), edge.max()) == pytest.approx((0.1, 0.9))
    assert edge.mean() == pytest.approx(0.5, abs=1e-6)


COLOURS = np.stack([picture(5.0, sigma, (60, 60), 8) for sigma in (0.7, 0.5, 0.6)], axis=-1)


def test_without_a_pixel_frequencies_are_in_cycles_per_pixel():
    found = lm.sfr(COLOURS[..., 0])
    assert found.frequencies[-1] == 0.5
    frequency, error = found.mtf50
    assert found(frequency) == pytest.approx(0.5, abs=2e-3)
    assert error < 1e-3
    assert "cycles/pixel" in repr(found)
    with pytest.raises(ValueError, match=r"0\.5 cycles/pixel"):
        found(0.6)
    with pytest.raises(ValueError, match=r"pixel must be in metres and at most 0\.1, got 1; leave it out"):
        lm.sfr(EDGE, 1.0)


@pytest.mark.parametrize(("at", "most"), [(0.08, 0.02), (0.23, 0.05), (0.36, 0.04)])
def test_the_frequency_of_half_the_response_has_its_error_in_noise(at, most):
    rng, frequencies = np.random.default_rng(3), np.linspace(0.0, 0.5, 33)
    right = np.exp(-math.log(2.0) * np.square(frequencies / at))
    # Noise whose neighbours are alike, as those of a window are, and is 0 at frequency 0.
    k = np.arange(33)
    mixing = np.exp(-0.5 * np.square(k[:, None] - np.arange(-4, 37)) / 1.3**2) * most
    mixing *= np.minimum(frequencies / 0.1, 1.0)[:, None] / np.sqrt(np.square(mixing / most).sum(axis=1))[:, None]
    beyond = []
    for _ in range(150):
        found, error = half(right + mixing @ rng.standard_normal(41), mixing @ mixing.T)
        assert error / 64.0 < 0.9 * most
        beyond.append((found / 64.0 - at) * 64.0 / error)
    assert 0.85 < np.sqrt(np.mean(np.square(beyond))) < 1.15
    assert abs(np.mean(beyond)) < 0.25


@pytest.mark.parametrize("curve", [lambda x: 1.0 / (1.0 + x * x), lambda x: 1.0 - 0.5 * x, lambda x: 0.5**x])
def test_half_of_exact_responses_is_where_it_is(curve):
    for at in (4.3, 9.9, 21.2):
        values = np.maximum(curve(np.arange(30) / at), 0.0)
        assert half(values, np.zeros((30, 30)))[0] == pytest.approx(at, rel=6e-3)


def test_the_frequency_of_one_half_is_infinite_beyond_that_of_nyquist():
    assert lm.sfr(picture(5.0, 0.1, (40, 40), 8)).mtf50 == (np.inf, np.inf)


def test_each_colour_has_its_response_and_the_whole_that_of_green():
    found = lm.sfr(COLOURS)
    assert list(found.channels) == ["red", "green", "blue"]
    np.testing.assert_array_equal(found.values, found.channels["green"].values)
    for sigma, one in zip((0.7, 0.5, 0.6), found.channels.values(), strict=True):
        np.testing.assert_allclose(one.values, gaussian(one.frequencies, one.angle, sigma), atol=2e-3)


def test_each_colour_of_a_mosaic_has_the_nyquist_frequency_of_its_pixels():
    y, x = np.indices(COLOURS.shape[:2])
    mosaic = np.take_along_axis(COLOURS, (y % 2 + x % 2)[..., None], axis=-1)[..., 0] * np.where(
        (y + x) % 2, 1.0, 0.6
    )
    found = lm.sfr(mosaic, mosaic="RGGB")
    for sigma, limit, one in zip((0.7, 0.5, 0.6), (0.25, 0.5**1.5, 0.25), found.channels.values(), strict=True):
        assert one.frequencies[-1] == pytest.approx(limit)
        np.testing.assert_allclose(one.values, gaussian(one.frequencies, one.angle, sigma), atol=4e-3)
    with pytest.raises(ValueError, match=r"got a mosaic.*state the mosaic"):
        lm.sfr(mosaic)
    for other in ("RGB", "GGRB", 5):
        with pytest.raises(ValueError, match="mosaic must be RGGB, BGGR, GRBG or GBRG, of an image"):
            lm.sfr(mosaic, mosaic=other)


@pytest.mark.parametrize("measure", [lm.sfr, lm.imaging.sfr_chart])
def test_another_order_of_the_colours_of_a_mosaic_is_refused_with_those_that_fit(measure):
    y, x = np.indices(EDGE.shape)
    mosaic = EDGE * np.where((y + x) % 2, 1.0, np.where(y % 2, 0.7, 0.5))  # RGGB
    with pytest.raises(ValueError, match=r"got 'GRBG', whose green pixels .* those of RGGB and BGGR differ by 0"):
        measure(mosaic, mosaic="GRBG")
    assert measure(mosaic, mosaic="BGGR")


@pytest.mark.parametrize("measure", [lm.sfr, lm.imaging.sfr_chart])
def test_the_mosaic_of_a_grey_picture_is_refused_and_that_of_balanced_colours_is_not(measure):
    y, x = np.indices(EDGE.shape)
    gains = np.where((y + x) % 2, 1.0, 0.5)
    random = np.random.default_rng(3)
    for grey in (EDGE, random.poisson(10000 * EDGE) / 10000, random.poisson(240 * EDGE).astype(np.uint8)):
        with pytest.raises(ValueError, match=r"got 'RGGB' and pixels that are alike .*: leave the mosaic out"):
            measure(grey, mosaic="RGGB")
    assert measure(random.poisson(5000 * EDGE * gains) / (5000 * gains), mosaic="RGGB")


def test_frames_are_averaged_and_masked_pixels_left_out():
    frames = np.stack([COLOURS[..., 0] + 0.02 * shift for shift in (-1, 1)])
    expected = lm.sfr(COLOURS[..., 0])
    np.testing.assert_allclose(lm.sfr(frames).values, expected.values, atol=1e-6)
    hidden = np.zeros(frames.shape[1:], bool)
    hidden[20:23, 28:31] = True
    found = lm.sfr(np.ma.masked_array(np.where(hidden, 9.0, COLOURS[..., 0]), hidden))
    assert found.findings.codes == ("left_out",)
    np.testing.assert_allclose(found.values, expected.values, atol=2e-3)


def test_the_offset_of_counts_is_no_light():
    noise = lm.Noise(white=1.0, read=3.0, offset=100.0)
    counts = lm.Counts.of(1000.0 * COLOURS[..., 0] + 100.0, noise=noise)
    assert lm.sfr(counts).contrast == pytest.approx(0.8, abs=1e-3)


def test_results_are_plain_data_and_plots():
    found = lm.sfr(COLOURS, PIXEL)
    data = found.to_dict()
    assert data["converged"]
    assert data["channels"]["red"]["mtf50"] < data["mtf50"]
    axes = found.plot()
    assert [line.get_label() for line in axes.lines[:3]] == ["red", "green", "blue"]
    assert axes.get_xlabel() == "spatial frequency (cycles/mm)"


@pytest.mark.parametrize("side", [40, 80])
def test_the_light_beyond_the_picture_is_estimated(side):
    # The line spread function is Cauchy's, of the width of that of a lens at f/4 with pixels of 3.5 um.
    width, turn, fine = 0.13, np.radians(6.0), 8
    x = (np.arange(side * fine) + 0.5) / fine - 0.5 * side
    d = x * np.cos(turn) + x[:, None] * np.sin(turn)
    light = 0.5 + 0.8 * np.arctan(d / width) / np.pi
    found = lm.sfr(light.reshape(side, fine, side, fine).mean(axis=(1, 3)))
    f = np.array([0.05, 0.1, 0.2, 0.4])
    pixel = gaussian(f, found.angle, 0.0) / np.sinc(f / fine)  # of its points
    off = found(f) - np.exp(-2.0 * np.pi * width * f) * pixel
    errors = np.interp(f, found.frequencies, found.errors)
    assert np.all(np.abs(off) < np.minimum(errors, 1e-3))  # 0.004 and more without it
    assert np.all(errors < 0.01)
