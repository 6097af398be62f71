"""Images through seeing, jitter, motion and pixels of any sides: within their bound of plain quadrature."""

from __future__ import annotations

import itertools
import math
from functools import lru_cache

import numpy as np
import pytest
from scipy.special import j0, j1

import lommel as lm
from lommel.blur.blurs import KOLMOGOROV

PIXELS = [(4, 4), (3, 6), (1, 7)]


def airy(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    v = np.maximum(np.pi * np.hypot(x, y), 1e-9)
    return (2.0 * j1(v) / v) ** 2


def within(answer: lm.PSF, expected: list[float], places: list[tuple[int, int]] = PIXELS) -> None:
    """Hold values to others, given as over the unaberrated peak."""
    peak = float(answer.values.max())
    found = [answer.values[at] for at in places]
    worst = float(np.abs(np.subtract(found, expected)).max()) / peak
    assert answer.error_bound is not None
    assert worst <= answer.error_bound + 1e-13, (worst, answer.error_bound)


def hermite(count: int = 70) -> tuple[np.ndarray, np.ndarray]:
    x, w = np.polynomial.hermite_e.hermegauss(count)
    return x, w / w.sum()


@pytest.mark.parametrize("tol", [1e-3, 1e-5, 1e-7, 1e-9])
@pytest.mark.parametrize("center", [None, (3.3, 5.1)])
def test_jitter_is_the_mean_over_a_gaussian_of_shifts_to_every_tolerance(tol, center):
    jitter = lm.Jitter(0.9, 0.4, angle=0.5)
    answer = lm.psf(lm.Pupil(), 9, 0.45, blur=jitter, center=center, tol=tol, normalize="strehl", dtype="float64")
    (x, w), c, s = hermite(), math.cos(0.5), math.sin(0.5)
    along, across = 0.9 * x[:, None], 0.4 * x
    expected = [
        float(w @ airy(answer.grid.x[j] + c * along - s * across, answer.grid.y[i] + s * along + c * across) @ w)
        for i, j in PIXELS
    ]
    within(answer, expected)
    assert answer.error_bound <= tol


@pytest.mark.parametrize(("length", "tol"), [(3.0, 1e-3), (3.0, 1e-6), (3.0, 1e-9), (25.0, 1e-3), (40.0, 1e-6)])
def test_motion_is_the_mean_over_shifted_images(length, tol):
    pupil = lm.Pupil(lm.Wavefront(1.2, nonradial={(3, 1): 0.8, (2, -2): 0.3}))
    answer = lm.psf(pupil, 9, 0.5, blur=lm.Motion(length, 0.6), tol=tol, normalize="strehl", dtype="float64")
    x, w = np.polynomial.legendre.leggauss(24 + 4 * int(length))
    moved = [0.5 * length * x * math.cos(0.6), 0.5 * length * x * math.sin(0.6)]
    expected = []
    for i, j in PIXELS:
        # Each shift is an axis of its own.
        places = -(answer.grid.y[i] + moved[1]) / 0.5, -(answer.grid.x[j] + moved[0]) / 0.5
        shifted = lm.psf(pupil, 1, 0.5, center=places, tol=1e-10, normalize="strehl", dtype="float64")
        expected.append(float(shifted.values[:, 0, 0] @ w) / 2.0)
    within(answer, expected)
    assert answer.error_bound <= tol


@lru_cache(maxsize=4)
def nodes(eps: float = 0.0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return f, weights of 2 pi f df and the OTF of a pupil in focus, as fractions of all light."""
    x, w = np.polynomial.legendre.leggauss(600)
    # Around the kinks of the OTF of an annulus.
    edges = np.cbrt(np.unique([0.0, eps, (1.0 - eps) / 2.0, (1.0 + eps) / 2.0, 1.0]))
    u = np.concatenate([a + (b - a) * 0.5 * (x + 1.0) for a, b in itertools.pairwise(edges)])
    weight = np.concatenate([0.5 * (b - a) * w for a, b in itertools.pairwise(edges)])
    f = u**3
    otf = 2.0 / np.pi * (np.arccos(f) - f * np.sqrt(1.0 - f * f))
    if eps:
        otf = np.real(lm.otf(lm.Pupil(obscuration=eps), f, tol=1e-12))
    return f, 2.0 * np.pi * f * weight * 3.0 * u * u, otf


def through_air(radius: np.ndarray, ratio: float, eps: float = 0.0) -> np.ndarray:
    """Return the long exposure over the unaberrated peak, by its Hankel transform."""
    f, weight, otf = nodes(eps)
    blurred = otf * np.exp(-KOLMOGOROV * (ratio * f) ** (5.0 / 3.0))
    return j0(2.0 * np.pi * np.multiply.outer(radius, f)) @ (weight * blurred) / (weight @ otf)


@pytest.mark.parametrize(("ratio", "tol"), [(0.5, 1e-6), (2.0, 1e-4), (2.0, 1e-9), (5.0, 1e-6), (8.0, 1e-3)])
def test_seeing_is_the_transform_of_both_transfer_functions(ratio, tol):
    answer = lm.psf(
        lm.Pupil(), 9, 0.4 * ratio, blur=lm.Seeing(1.0 / ratio), tol=tol, normalize="strehl", dtype="float64"
    )
    radius = np.array([np.hypot(answer.grid.y[i], answer.grid.x[j]) for i, j in PIXELS])
    within(answer, list(through_air(radius, ratio)))
    assert answer.error_bound <= tol


def test_a_window_beside_the_axis_is_within_its_bound_over_the_peak():
    answer = lm.psf(
        lm.Pupil(), 9, 0.5, blur=lm.Seeing(1.0), tol=1e-6, center=(40, 40), normalize="strehl", dtype="float64"
    )
    peak = float(through_air(np.zeros(1), 1.0)[0])
    radius = np.array([np.hypot(answer.grid.y[i], answer.grid.x[j]) for i, j in PIXELS])
    off = np.abs([answer.values[at] for at in PIXELS] - through_air(radius, 1.0)).max() / peak
    assert off <= answer.error_bound <= 1e-6


def test_an_obscured_telescope_sees_through_the_air():
    answer = lm.psf(
        lm.Pupil(obscuration=0.4), 9, 1.0, blur=[lm.Seeing(0.3)], normalize="strehl", dtype="float64", integrate=False
    )
    radius = np.array([np.hypot(answer.grid.y[i], answer.grid.x[j]) for i, j in PIXELS])
    within(answer, list(through_air(radius, 1.0 / 0.3, 0.4)))


def test_factors_are_composed_in_any_order_and_in_metres():
    scale = 600e-9 * 8.0
    air = lm.Seeing(0.1, focal_length=2.0, wavelength=500e-9)
    pupil = lm.Pupil(lm.Wavefront(0.5), wavelength=600e-9, f_number=8.0)
    factors = [lm.Jitter(2e-6), air, lm.Motion(6e-6, 0.3)]
    one = lm.psf(pupil, 7, 3e-6, blur=factors, dtype="float64")
    other = lm.psf(pupil, 7, 3e-6, blur=factors[::-1], dtype="float64")
    assert one.values == pytest.approx(other.values, rel=1e-9)
    # The same in units of lambda*N: r0 over the diameter, longer in redder light.
    r0 = 0.1 * 1.2**1.2 / (2.0 / 8.0)
    plain = [lm.Jitter(2e-6 / scale), lm.Seeing(r0), lm.Motion(6e-6 / scale, 0.3)]
    bare = lm.psf(lm.Pupil(lm.Wavefront(0.5)), 7, 3e-6 / scale, blur=plain, integrate=True, dtype="float64")
    assert np.abs(one.values - bare.values).max() < 1e-9 * one.values.max()


@pytest.mark.parametrize("tol", [1e-4, 1e-6, 1e-9])
@pytest.mark.parametrize(("pixel", "fill"), [((0.5, 1.3), (1.0, 0.8)), (0.7, 0.5), ((2.0, 0.3), 1.0)])
def test_pixels_of_any_sides_average_over_what_is_active(pixel, fill, tol):
    answer = lm.psf(lm.Pupil(), 9, pixel, fill=fill, integrate=True, tol=tol, normalize="strehl", dtype="float64")
    x, w = np.polynomial.legendre.leggauss(40)
    down, across = pixel if isinstance(pixel, tuple) else (pixel, pixel)
    high, wide = fill if isinstance(fill, tuple) else (math.sqrt(fill), math.sqrt(fill))
    expected = []
    for i, j in PIXELS:
        columns, rows = answer.grid.x[j] + 0.5 * across * wide * x, answer.grid.y[i] + 0.5 * down * high * x
        expected.append(float(w @ airy(columns, rows[:, None]) @ w) / 4.0)
    within(answer, expected)
    assert answer.error_bound <= tol


def test_samples_of_oblong_pixels_are_at_their_centres():
    answer = lm.psf(lm.Pupil(), (5, 7), (0.4, 0.9), normalize="strehl", dtype="float64", center=(1.5, 2.25))
    assert not answer.grid.integrate
    expected = airy(answer.grid.x, answer.grid.y[:, None])
    assert np.abs(answer.values - expected).max() <= answer.error_bound * answer.values.max()


def test_square_pixels_without_blur_are_what_they_were():
    pupil = lm.Pupil(lm.Wavefront(2.0))
    plain = lm.psf(pupil, 33, 0.3)
    for same in (
        {"pixel": (0.3, 0.3)},
        {"pixel": 0.3, "fill": 1.0},
        {"pixel": 0.3, "blur": ()},
        {"pixel": 0.3, "fill": (1, 1)},
    ):
        answer = lm.psf(pupil, 33, **same)
        assert answer.grid == plain.grid
        assert np.array_equal(answer.values, plain.values)


def test_white_light_has_a_width_of_seeing_for_each_wavelength():
    pupil = lm.Pupil(lm.Wavefront(0.4), wavelength=550e-9, f_number=10.0)
    white = lm.methods.Polychromatic([450e-9, 650e-9], [1, 3])
    air = lm.Seeing(0.1, focal_length=3.0, wavelength=500e-9)
    answer = lm.psf(pupil, 9, 4e-6, blur=air, method=white, dtype="float64")
    parts = [lm.psf(part.pupil, 9, 4e-6, blur=air, dtype="float64") for part in white.components(pupil)]
    expected = 0.25 * parts[0].values + 0.75 * parts[1].values
    assert np.abs(answer.values - expected).max() <= 2.0 * answer.error_bound * answer.values.max()
    f = np.array([2e4, 5e4])
    whole = lm.otf(pupil, f, pixel=4e-6, blur=air, spectrum=white)
    both = [lm.otf(part.pupil, f, pixel=4e-6, blur=air) for part in white.components(pupil)]
    assert whole == pytest.approx(0.25 * both[0] + 0.75 * both[1], abs=1e-9)


def test_stacks_axes_and_types_are_those_of_other_images():
    stack = lm.Pupil(lm.Wavefront(np.array([0.0, 1.0, 2.0])))
    answer = lm.psf(stack, (4, 6), (0.5, 0.6), blur=lm.Jitter(0.3), center=(np.array([1.0, 2.0, 3.5]), 2.0))
    assert answer.values.shape == (3, 4, 6)
    assert answer.values.dtype == np.float32
    for k, row in enumerate((1.0, 2.0, 3.5)):
        alone = lm.psf(stack[k], (4, 6), (0.5, 0.6), blur=lm.Jitter(0.3), center=(row, 2.0))
        assert np.abs(alone.values - answer.values[k]).max() < 2e-6 * alone.values.max()
        assert np.array_equal(answer[k].values, answer.values[k])


@pytest.mark.parametrize("shape", ["vanes", "mask"])
def test_any_aperture_is_spread_within_the_bound(shape):
    parts = {
        "vanes": {"spider": lm.Spider.equal(3, width=0.1), "obscuration": 0.2},
        "mask": {"mask": lm.Mask(np.hypot(*np.mgrid[-1:1:64j, -0.9:1:64j]) < 0.8)},
    }
    pupil = lm.Pupil(**parts[shape])
    answer = lm.psf(pupil, 5, 0.5, blur=lm.Motion(2.0, 0.4), normalize="strehl", dtype="float64")
    x, w = np.polynomial.legendre.leggauss(16)
    mean = 0.0
    for at, share in zip(x, w, strict=True):
        center = 2.0 + at * math.sin(0.4) / 0.5, 2.0 + at * math.cos(0.4) / 0.5
        mean = mean + 0.5 * share * lm.psf(pupil, 5, 0.5, center=center, normalize="strehl", tol=1e-10).values
    assert np.abs(answer.values - mean).max() <= answer.error_bound * mean.max() <= 1e-6


def test_values_are_fractions_of_all_light_and_sum_to_it():
    wide = lm.psf(lm.Pupil(), 161, (0.5, 0.4), blur=lm.Jitter(1.0))
    assert float(wide.energy) == pytest.approx(1.0, abs=0.02)
    assert float(wide.values.sum()) == pytest.approx(float(wide.energy), abs=1e-5)
    assert float(wide.encircled_energy(10.0)) == pytest.approx(
        float(lm.psf(lm.Pupil(), 9, 0.5).encircled_energy(10.0)), abs=2e-3
    )


def test_the_strehl_ratio_is_that_on_the_axis_of_what_is_recorded():
    answer = lm.psf(lm.Pupil(), 5, 0.4, blur=lm.Seeing(0.5))
    assert float(answer.strehl) == pytest.approx(float(through_air(np.zeros(1), 2.0)[0]), rel=1e-5)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"blur": lm.Seeing(0.1, 2.0, 500e-9)}, "blur must fit the unit of the pupil"),
        ({"blur": lm.Jitter(2e-6)}, "lengths are in lambda\\*N here"),
        ({"pixel": (0.5, 0.6), "method": lm.paper.Geometric()}, "method must compute point values"),
        ({"fill": 0.5, "integrate": False}, "integrate must not be False"),
        ({"blur": [lm.Seeing(0.001), lm.Motion(1.0)], "tol": 1e-8}, "larger tol"),
    ],
)
def test_what_cannot_be_is_told(changes, message):
    options = {"shape": 5, "pixel": 0.5} | changes
    with pytest.raises((TypeError, ValueError, lm.ToleranceError), match=message):
        lm.psf(lm.Pupil(), **options)


def test_objectives_are_told_the_way_out():
    objective = lm.Objective(
        NA=0.8, magnification=40, immersion=1.0, working_distance=0.5e-3, coverslip=None, sample=1.0
    )
    with pytest.raises(ValueError, match="are for lenses"):
        lm.psf(objective.pupil(depth=0.0, wavelength=500e-9), 5, 5e-6, blur=lm.Jitter(1e-6))
