"""Periodic textures: depth is right within its standard errors, or not known."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

import lommel as lm
from scenes import POINTS, ThinLens, lommel_lens, plane, record, texture

SIDE, LIGHT, BETWEEN = 128, 5000.0, (0.4, 2.0)
LENSES = [ThinLens(6e-3, 2.4, focus, 540e-9, 2.2e-6) for focus in (0.5, 1.2)]


@pytest.fixture(scope="module")
def live() -> lm.imaging.LiveDepth:
    return lm.imaging.LiveDepth(
        [lommel_lens(lens) for lens in LENSES], 2.2e-6, between=BETWEEN, noise=lm.Noise(read=3.0, offset=100.0),
        shape=(SIDE, SIDE), light=LIGHT,
    )  # fmt: skip


def stripes(periods: int, across: int = 0) -> np.ndarray:
    """Stripes, or with `across` a weave of two, of whole numbers of periods."""
    at = np.arange(SIDE * POINTS) / (SIDE * POINTS)
    down, right = np.sin(2.0 * np.pi * periods * at)[:, None], np.sin(2.0 * np.pi * across * at + 0.3)
    return 1.0 + 0.6 * (down if not across else np.sign(down * right)) * np.ones((SIDE * POINTS, SIDE * POINTS))


def inner(live, points: np.ndarray, distance: float) -> tuple[np.ndarray, np.ndarray]:
    """Errors over standard errors of known blocks away from the border, and which are known."""
    found = live(*record(plane(points, LENSES, distance, LIGHT), seed=3))
    depth, errors = (np.array(each)[6:-6, 6:-6] for each in (found.depth, found.errors))
    known = np.isfinite(errors)
    return ((depth - distance) / errors)[known], known


@pytest.mark.parametrize(
    ("points", "distance"),
    [(stripes(39), 0.5), (stripes(39), 0.667), (stripes(39), 0.8), (stripes(20, 20), 0.571), (stripes(20, 20), 1.0)],
    ids=["stripes, 0.5 m", "stripes, 0.667 m", "stripes, 0.8 m", "weave, 0.571 m", "weave, 1 m"],
)
def test_periodic_textures_have_the_right_depth_or_none(live, points, distance):
    z, _ = inner(live, points, distance)
    assert z.size == 0 or np.mean(np.abs(z) > 3.0) < 0.1


def test_periods_of_nine_pixels_have_depth(live):
    z, known = inner(live, stripes(14, 14), 0.8)
    assert known.mean() > 0.9
    assert np.mean(np.abs(z) > 3.0) < 0.1


def test_what_few_frequencies_leave_at_the_minimum_widens_errors():
    light, at = 5.0 * LIGHT, np.arange(SIDE * POINTS) / (SIDE * POINTS)
    bars = np.where((16.0 * at[:, None] + 11.0 * at) % 1.0 < 0.21, 1.0, -1.0)
    points = 1.0 + 0.6 * bars + 0.5 * (texture("pink", SIDE) - 1.0)
    bright = lm.imaging.LiveDepth(
        [lommel_lens(lens) for lens in LENSES], 2.2e-6, between=BETWEEN, noise=lm.Noise(read=3.0, offset=100.0),
        shape=(SIDE, SIDE), light=light,
    )  # fmt: skip
    found = bright(*record(plane(points, LENSES, 1.277, light), seed=3))
    depth, errors = (np.array(each)[6:-6, 6:-6] for each in (found.depth, found.errors))
    assert np.isfinite(errors).mean() > 0.9
    assert np.mean(np.abs(depth - 1.277) > 3.0 * errors) < 0.1
    assert np.median(errors) < 0.01


def test_a_valley_of_one_frequency_that_is_too_wide_has_no_depth(live):
    _, known = inner(live, stripes(33), 1.0)
    assert known.mean() < 0.1


@pytest.mark.parametrize("distance", [0.447, 1.4])
def test_depths_that_noise_chose_among_unknown_ones_are_not_known(live, distance):
    down, right = 2.0 * np.pi * np.mgrid[: SIDE * POINTS, : SIDE * POINTS] / (SIDE * POINTS)
    waves = np.sin(3.0 * (down + right)) + np.sin(2.0 * (down + right) + 1.0)  # longer than a window
    assert inner(live, 1.0 + 0.42 * waves, distance)[1].mean() < 0.04  # of noise alone it would be a fifth


@pytest.mark.parametrize("kind", ["pink", "leaves"])
def test_textures_of_many_frequencies_have_depth(live, kind):
    z, known = inner(live, texture(kind, SIDE), 0.667)
    assert known.mean() > 0.97
    assert 0.5 < np.std(z) < 1.3


def test_a_texture_of_many_frequencies_is_not_concentrated_and_filters_leak_little(live):
    tables = live._levels[0].engine.channels[0]
    assert np.all(tables.concentration < 0.35)  # 1 for a single frequency, 1 / 7 at least
    assert tables.concentration.min() > 1.0 / tables.rank
    assert 1e-4 < tables.leak[0] < 0.01


# A window has 50 squares of 2 x 2 pixels: mean products of images differ from those of the spectrum.
def test_the_concentration_is_that_of_windows():
    lenses, side = [ThinLens(35e-3, 4.0, focus, 540e-9, 4e-6) for focus in (1.35, 1.8)], SIDE // 2
    tables = lm.imaging.LiveDepth(
        [lommel_lens(lens) for lens in lenses], 4e-6, between=(1.2, 2.0), noise=lm.Noise(read=3.0, offset=100.0),
        shape=(SIDE, SIDE), light=LIGHT,
    )._levels[0].engine.channels[0]  # fmt: skip
    assert tables.binning == 2
    for distance in (1.4, 1.7):
        pair = record(plane(texture("pink", SIDE), lenses, distance, LIGHT), seed=3)
        spectra = np.fft.fft2([frame.reshape(side, 2, side, 2).sum(axis=(1, 3)) for frame in pair])
        f = np.fft.fftfreq(side)
        terms = tables.taps.chebyshev(f[:, None], f, tables.degree)
        images = np.fft.ifft2(np.einsum("rim,myx,iyx->ryx", tables.basis, terms, spectra, optimize=True)).real
        products = np.array([[gaussian_filter(a * b, 2.0, mode="wrap") for b in images] for a in images])
        measured = (products**2).sum(axis=(0, 1)) / np.trace(products) ** 2
        expected = tables.concentration[np.abs(tables.vergence - 1.0 / distance).argmin()]
        assert expected == pytest.approx(measured.mean(), rel=0.1)
