"""Averages over the aperture: rms, Marechal's estimate, Strehl ratio, centroid, rays."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.special import j1

import lommel as lm
from lommel.optics.aperture.mask import cell_centers

TERMS = [(1, 1), (1, -1), (2, 0), (2, -2), (3, 1), (4, 4), (5, -3), (8, 0), (11, 7), (20, -20)]
MIXED = lm.Wavefront(1.3, 0.4, nonradial={(5, 3): 0.7, (6, -4): 1.1, (2, 2): 0.3, (3, -1): -0.8, (1, 1): 0.5})


def cartesian(pupil: lm.Pupil, side: int = 600) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return midpoints (x, y) of a grid that lie in the aperture: a first-order rule of its own kind."""
    x = (np.arange(side) + 0.5) / side * 2 - 1
    across, down = np.meshgrid(x, x)
    rho = np.hypot(across, down)
    inside = (rho < 1) & (rho > pupil.obscuration)
    return across[inside], down[inside]


@pytest.mark.parametrize("term", TERMS)
def test_the_rms_of_a_zernike_term_is_its_coefficient(term):
    assert lm.rms(lm.Wavefront.zernike({term: -0.37})) == pytest.approx(0.37, rel=1e-13)


@pytest.mark.parametrize(("g", "eps"), [(0.3, 0.0), (5.0, 0.4), (100.0, 0.0), (100.0, 0.9)])
def test_a_gaussian_beam_weights_the_rms_by_its_amplitude(g, eps):
    pupil = lm.Pupil(lm.Wavefront(2.0), obscuration=eps, apodization=g)
    with mpmath.workdps(40):
        low = mpmath.mpf(eps) ** 2
        moments = [mpmath.quad(lambda t, k=k: t**k * mpmath.exp(-g * (t - low)), [low, low + 0.1 * (1 - low), 1])
                   for k in range(3)]  # fmt: skip
        expected = 4 * mpmath.sqrt(moments[2] / moments[0] - (moments[1] / moments[0]) ** 2)
    assert float(lm.rms(pupil)) == pytest.approx(float(expected), rel=1e-10)


@pytest.mark.parametrize("defocus", [0.0, 0.5, -7.3, 60.0, 800.0])
def test_the_strehl_ratio_of_defocus_is_a_sinc_squared(defocus):
    assert lm.strehl(lm.Pupil(lm.Wavefront(defocus))) == pytest.approx(np.sinc(defocus / math.pi) ** 2, abs=2e-12)


@pytest.mark.parametrize("m", [1, 2, 5])
@pytest.mark.parametrize("depth", [0.3, 4.0, 40.0])
def test_the_strehl_ratio_of_one_term_at_the_rim_is_an_integral_of_bessel(m, depth):
    """The average of ``exp(i a rho^m cos(m theta))`` over theta is ``J0(a rho^m)``."""
    with mpmath.workdps(20):
        mean = mpmath.quad(lambda t: mpmath.besselj(0, depth * t ** (mpmath.mpf(m) / 2)), mpmath.linspace(0, 1, 12))
    pupil = lm.Pupil(lm.Wavefront(nonradial={(m, -m): depth}))
    assert lm.strehl(pupil) == pytest.approx(float(mean) ** 2, abs=1e-11)


@pytest.mark.parametrize(("eps", "g"), [(0.0, 0.0), (0.45, 0.0), (0.2, 3.0)])
def test_the_strehl_ratio_and_the_rms_are_averages_over_the_aperture(eps, g):
    pupil = lm.Pupil(MIXED, obscuration=eps, apodization=g)
    x, y = cartesian(pupil)
    values = pupil.values(x, y)[0]
    assert lm.strehl(pupil) == pytest.approx(abs(values.mean()) ** 2 / np.abs(values).mean() ** 2, abs=2e-4)
    phase = MIXED.phase(np.hypot(x, y), np.arctan2(y, x))
    assert lm.rms(pupil) == pytest.approx(np.sqrt(np.cov(phase, aweights=np.abs(values), ddof=0)), rel=2e-3)


@given(st.lists(st.floats(-1, 1), min_size=3, max_size=3), st.sampled_from([0.0, 0.5]))
def test_marechals_estimate_is_the_strehl_ratio_to_second_order(coefficients, eps):
    wavefront = lm.Wavefront.zernike(dict(zip([(2, 2), (3, -1), (4, 0)], coefficients, strict=True)))
    for size in (0.1, 0.05):
        pupil = lm.Pupil(size * wavefront, obscuration=eps)
        # The third moment of the phase is the next: |error| <= |phase|^3 / 3 and more, all below 2 |c|.
        assert abs(lm.strehl(pupil) - lm.marechal(pupil)) <= 40 * (size * max(map(abs, coefficients))) ** 3 + 1e-12
    assert lm.strehl(lm.Pupil(wavefront, obscuration=eps)) <= 1 + 1e-12


def test_a_tilt_moves_the_centroid_by_its_phase_at_the_edge_over_pi():
    pupil = lm.Pupil(lm.Wavefront(2.0, nonradial={(1, 1): 3.0, (1, -1): -1.5}), wavelength=500e-9, f_number=4.0)
    assert lm.centroid(pupil) == pytest.approx(np.array([3.0, -1.5]) / math.pi * 2e-6, rel=1e-12)
    assert lm.spot_radius(pupil) == pytest.approx(lm.spot_radius(lm.Pupil(lm.Wavefront(2.0))) * 2e-6, rel=1e-12)


def test_the_tail_of_coma_takes_the_centroid_along_and_only_its_rim_matters():
    """By Gauss's theorem the mean gradient is that of the phase at the rim: 2 a for a term of m = 1."""
    for n in (3, 5, 9):
        found = lm.centroid(lm.Pupil(lm.Wavefront(4.0, nonradial={(n, 1): 0.9, (4, 2): 2.0})))
        assert found * math.pi == pytest.approx([2 * 0.9 * 0.5, 0.0], abs=1e-13)


@pytest.mark.parametrize(("eps", "g"), [(0.0, 0.0), (0.45, 0.0), (0.2, 3.0)])
def test_rays_meet_the_sensor_at_the_gradient_of_the_phase(eps, g):
    pupil = lm.Pupil(MIXED, obscuration=eps, apodization=g)
    x, y = cartesian(pupil)
    h = 1e-6

    def phase(dx, dy):
        return MIXED.phase(np.hypot(x + dx, y + dy), np.arctan2(y + dy, x + dx))

    slopes = np.stack([phase(h, 0) - phase(-h, 0), phase(0, h) - phase(0, -h)]) / (2 * h)
    weight = np.abs(pupil.values(x, y)[0]) ** 2
    middle = np.average(slopes, axis=1, weights=weight)
    assert lm.centroid(pupil) * math.pi == pytest.approx(middle, abs=1e-2)
    spread = np.average(((slopes - middle[:, None]) ** 2).sum(axis=0), weights=weight)
    assert lm.spot_radius(pupil) * math.pi == pytest.approx(math.sqrt(spread), rel=1e-3)


def test_a_stack_gives_what_each_of_its_pupils_gives():
    wavefront = lm.Wavefront(np.array([[0.0, 1.0, 5.0]]), nonradial={(3, 1): [[1.0], [2.0]]})
    pupils = lm.Pupil(wavefront, obscuration=0.1)
    for number in (lm.rms, lm.marechal, lm.strehl, lm.spot_radius, lm.centroid):
        whole = number(pupils)
        assert whole.shape[:2] == (2, 3)
        for index in np.ndindex(2, 3):
            assert whole[index] == pytest.approx(number(pupils[index]), rel=1e-12)
    assert np.ndim(lm.strehl(pupils[0, 0])) == np.ndim(lm.rms(pupils[0, 0])) == 0


@given(st.floats(0.01, 30.0), st.floats(-3, 3), st.sampled_from([0.0, 0.4]))
def test_the_strehl_ratio_of_a_tilt_is_the_airy_pattern_beside_its_middle(tilt, angle, eps):
    wavefront = lm.Wavefront(nonradial={(1, 1): tilt}).rotated(angle)
    airy = 2 * j1(tilt) / tilt - (2 * eps * j1(eps * tilt) / tilt if eps else 0.0)
    expected = (airy / (1 - eps**2)) ** 2
    assert lm.strehl(lm.Pupil(wavefront, obscuration=eps)) == pytest.approx(expected, abs=1e-9)


def test_a_small_aberration_of_any_kind_costs_its_variance():
    rng = np.random.default_rng(3)
    terms = {(n, m): 0.01 * rng.normal() for n in range(1, 7) for m in range(-n, n + 1, 2)}
    variance = sum(c**2 for c in terms.values())
    strehl = lm.strehl(lm.Pupil(lm.Wavefront.zernike(terms)))
    assert 1.0 - strehl == pytest.approx(variance, rel=0.01)


def test_a_phase_that_turns_too_often_is_told():
    pupil = lm.Pupil(lm.Wavefront(1e6, nonradial={(3, 1): 1.0}))
    with pytest.raises(lm.ToleranceError, match="needs more than"):
        lm.strehl(pupil)
    assert math.isfinite(lm.strehl(lm.Pupil(lm.Wavefront(200.0, nonradial={(3, 1): 1.0}))))


APERTURES = {
    "vanes": {"obscuration": 0.3, "spider": lm.Spider.equal(4, 0.2, 0.3)},
    "cat's eye": {"vignetting": lm.CatEye((0.5, 0.2)), "apodization": 0.7},
    "mask": {"mask": lm.Mask.sample(lambda x, y: 0.2 + 0.8 * (x > 0.25) + 0 * y, side=256)},
}


@pytest.mark.parametrize("name", APERTURES)
def test_what_narrows_an_aperture_counts_in_every_average(name):
    pupil = lm.Pupil(lm.Wavefront(0.4, nonradial={(3, 1): 0.9, (1, -1): 0.5}), **APERTURES[name])
    at = cell_centers(1024)
    field = pupil.values(at[None, :], at[:, None])[0]
    amplitude = np.abs(field)
    total = amplitude.sum()
    assert float(lm.strehl(pupil)) == pytest.approx(abs(field.sum() / total) ** 2, abs=2e-3)
    phase = pupil.wavefront.phase(np.hypot(at[None, :], at[:, None]), np.arctan2(at[:, None], at[None, :]))
    mean = (amplitude * phase).sum() / total
    rms = np.sqrt((amplitude * (phase - mean) ** 2).sum() / total)
    assert float(lm.rms(pupil)) == pytest.approx(rms, abs=2e-3)
    gradient = np.stack(np.gradient(phase, at, at), axis=-1)[..., ::-1]
    if pupil.mask is not None:
        # Cells of 4 x 4 points that the rim crosses have their mean, of which the light is the square.
        amplitude = np.kron(amplitude.reshape(256, 4, 256, 4).mean(axis=(1, 3)), np.ones((4, 4)))
    light = amplitude[..., None] ** 2
    np.testing.assert_allclose(lm.centroid(pupil), (light * gradient).sum((0, 1)) / light.sum() / np.pi, atol=2e-3)


def test_the_strehl_ratio_behind_vanes_is_the_value_on_the_axis():
    pupil = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 2.0}), **APERTURES["vanes"])
    image = lm.psf(pupil, 1, 0.1, method=lm.methods.NonuniformFFT(1e-11), normalize="strehl")
    assert float(lm.strehl(pupil)) == pytest.approx(float(image.values[0, 0]), rel=1e-9)


def test_segments_count_with_their_phases_in_every_average():
    rng = np.random.default_rng(3)
    shapes = lm.Segments.hexagonal(rings=1, gap=0.05, middle=True)
    stop = shapes.phased(*(rng.normal(scale=0.6, size=(3, 7))))
    pupil = lm.Pupil(lm.Wavefront(0.4, nonradial={(3, 1): 0.9}), stop=stop)
    at = cell_centers(1500)
    x, y = np.meshgrid(at, at)
    wave = pupil.wavefront.phase(np.hypot(x, y), np.arctan2(y, x))
    slopes = np.stack(np.gradient(wave, at, at)[::-1])
    clear = np.zeros(x.shape, dtype=bool)
    for hexagon, piston, tip, tilt in zip(stop.shapes, stop.piston, stop.tip, stop.tilt, strict=True):
        inside, (u, v) = hexagon.margin(x, y) > 0.0, hexagon.center
        clear |= inside
        wave += np.where(inside, piston + tip * (x - u) + tilt * (y - v), 0.0)
        slopes += np.where(inside, np.array([tip, tilt])[:, None, None], 0.0)
    phase, rays = wave[clear], slopes[:, clear]
    assert float(lm.strehl(pupil)) == pytest.approx(abs(np.exp(1j * phase).mean()) ** 2, abs=1e-3)
    assert float(lm.rms(pupil)) == pytest.approx(phase.std(), abs=2e-3)
    np.testing.assert_allclose(lm.centroid(pupil), rays.mean(axis=1) / np.pi, atol=1e-3)
    assert float(lm.spot_radius(pupil)) == pytest.approx(math.sqrt(rays.var(axis=1).sum()) / np.pi, rel=2e-3)
    assert float(pupil.geometric_radius()) == pytest.approx(np.hypot(*rays).max() / np.pi, rel=0.02)
    assert abs(pupil.values(x, y)[0] - clear * np.exp(1j * wave)).max() < 1e-9


def test_a_phase_screen_counts_in_the_strehl_ratio_and_has_no_rays():
    screen = lm.Mask.sample(lambda x, y: np.exp(1j * (0.8 * x * y + x)), side=256)
    pupil = lm.Pupil(mask=screen)
    smooth = lm.Pupil(lm.Wavefront(nonradial={(2, -2): 0.4, (1, 1): 1.0}))
    assert float(lm.strehl(pupil)) == pytest.approx(float(lm.strehl(smooth)), abs=2e-3)
    for measure in (lm.rms, lm.spot_radius, lm.marechal):
        with pytest.raises(ValueError, match="mask must be real"):
            measure(pupil)
