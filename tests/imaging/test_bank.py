"""Windows of PSFs by depth: their light, their errors and their sizes."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm
from lommel.imaging.bank import Bank, build_bank
from lommel.imaging.sensor_light import (
    DefocusNodes,
    Parabola,
    SensorLight,
    cut,
    find_cuts,
    pixel_factors,
    ring_factors,
    sums_of_quarters,
)
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.methods.pixel_rule import octant, pixel_rule, sums_of_windows
from lommel.optics.wavefront import wavefront as of_wavefront

SCALE = {"wavelength": 550e-9, "f_number": 4.0}
GREEN = ((550e-9, 1.0),)
PIXEL = 4e-6
PUPILS = {
    "plain": lm.Pupil(**SCALE),
    "obscured": lm.Pupil(obscuration=0.4, **SCALE),
    "spherical": lm.Pupil(lm.Wavefront(0.0, 6.0), **SCALE),
}


def exact(pupil: lm.Pupil, defocus: float, side: int, wavelength: float = 550e-9) -> np.ndarray:
    """The window of one wavelength through the front door."""
    wave = (550e-9 / wavelength) * (lm.Wavefront(defocus) + pupil.wavefront)
    there = lm.Pupil(wave, obscuration=pupil.obscuration, wavelength=wavelength, f_number=4.0)
    answer = lm.psf(there, side, PIXEL, integrate=True, method=lm.methods.NijboerZernike(1e-9), dtype=np.float64)
    return np.asarray(answer.values)


def built(
    low, high, name="plain", *, spectrum=GREEN, pixel=PIXEL, tol=1e-3, energy=0.9, largest=60, dtype=np.float64
):
    """A bank of one of the pupils."""
    light = SensorLight(PUPILS[name], lm.Wavefront, spectrum, pixel)
    return build_bank(light, (low, high), tol=tol, energy=energy, largest=largest, dtype=dtype)


def off(windows: Bank, defocus: float, true: np.ndarray) -> float:
    """The largest error over the peak, of the pixels that are used whole; those in part are near what is left."""
    used, made = windows.pixel_weights(defocus), windows.window(defocus)
    inside, held = np.abs(used - 1.0) < 1e-9, (used * true).sum()
    made *= true[inside].sum() / made[inside].sum()
    assert made.sum() == pytest.approx(held, abs=1e-4)
    assert np.abs(made - used * true)[~inside].max(initial=0.0) <= 0.2 * true[~inside].max(initial=0.0)
    return float(np.abs(made - true)[inside].max() / true.max())


@pytest.fixture(scope="module", params=PUPILS)
def bank(request: pytest.FixtureRequest) -> tuple[lm.Pupil, Bank]:
    """A bank from behind the focus to before it."""
    pupil = PUPILS[request.param]
    made = built(-9.0, 14.0, request.param, tol=1e-4, energy=0.95)
    return pupil, made


@given(defocus=st.floats(-9.0, 14.0))
def test_interpolated_windows_err_by_less_than_the_tolerance_anywhere(bank, defocus):
    pupil, windows = bank
    true = exact(pupil, defocus, 2 * windows.half + 1)
    assert off(windows, defocus, true) <= 1e-4


@given(defocus=st.floats(-9.0, 14.0))
def test_windows_hold_the_light_that_was_asked_for_and_spread_what_they_do_not(bank, defocus):
    pupil, windows = bank
    held = (windows.pixel_weights(defocus) * exact(pupil, defocus, 2 * windows.half + 1)).sum()
    assert held >= 0.95 - 1e-3
    assert held >= 1.0 - windows.lost - 1e-3
    assert windows.lost <= 0.05
    assert windows.window(defocus).sum() == pytest.approx(1.0, abs=1e-12)


def test_a_bank_of_other_psfs_spreads_these_cut_alike(bank):
    _, windows = bank
    rows, columns = np.abs(np.indices((2 * windows.half + 1,) * 2) - windows.half)
    kernels = np.exp(-np.arange(windows.count)[:, None, None] / 50.0 - 0.1 * rows**2 - 0.3 * columns**2)
    other = windows.with_kernels(kernels)
    for index in range(1, windows.count - 1, 7):
        at = windows.start + index * windows.spacing
        kept = windows.pixel_weights(at) * kernels[index]
        np.testing.assert_allclose(other.window(at), kept / kept.sum(), rtol=1e-9, atol=1e-15)
    whole = windows.with_kernels(kernels, np.full(windows.count, float(windows.half)))
    np.testing.assert_allclose(whole.energies, kernels.sum(axis=(1, 2)), rtol=1e-12)


def test_a_pixel_that_holds_more_than_was_asked_for_holds_it_all():
    made = built(0.0, 4.0, pixel=40e-6, energy=0.6, largest=9, dtype=np.float32)
    assert made.half == 0
    assert made.window(1.3).item() == pytest.approx(1.0, abs=1e-6)
    assert made.lost == pytest.approx(1.0 - made.windows[:-1, 0, 0].min(), abs=1e-3)


@pytest.mark.parametrize("tol", [1e-2, 1e-4, 1e-6])
def test_the_tolerance_is_kept_and_a_smaller_one_takes_more_windows(tol):
    made = built(1.0, 8.0, tol=tol)
    coarse = built(1.0, 8.0, tol=10 * tol)
    for defocus in np.random.default_rng(0).uniform(1.0, 8.0, 12):
        assert off(made, defocus, exact(PUPILS["plain"], defocus, 2 * made.half + 1)) <= tol
    assert coarse.count < made.count


def test_a_spectrum_is_the_sum_of_its_wavelengths_at_equal_path_differences():
    spectrum = ((500e-9, 0.3), (620e-9, 0.7))
    pupil = PUPILS["spherical"]
    made = built(2.0, 6.0, "spherical", spectrum=spectrum, tol=1e-5, energy=0.95)
    for defocus in (2.0, 3.7, 6.0):
        true = sum(share * exact(pupil, defocus, 2 * made.half + 1, at) for at, share in spectrum)
        assert off(made, defocus, true) <= 1e-5


def test_windows_are_no_larger_than_the_blur_takes():
    made = built(0.0, 40.0, dtype=np.float32)
    assert made.windows.dtype == np.float32
    assert made.halves[1] < 3
    assert made.halves[-2] > 8
    assert made.half == np.ceil(made.halves.max())


@pytest.mark.parametrize("name", PUPILS)
def test_a_window_changes_little_where_the_defocus_does(name):
    """At each window of the bank, where the four that are mixed become others."""
    made = built(-9.0, 14.0, name, tol=1e-4, energy=0.98)
    knots = made.start + made.spacing * np.arange(1, made.count - 1)
    step = 1e-9
    for at in knots:
        before, after = made.window(at - step), made.window(at + step)
        assert np.abs(after - before).max() <= 1e-7 * after.max()


def test_one_distance_makes_a_bank_too():
    made = built(5.0, 5.0, tol=1e-6, energy=0.95)
    assert off(made, 5.0, exact(PUPILS["plain"], 5.0, 2 * made.half + 1)) <= 2e-6


@pytest.mark.parametrize("tol", [1e-3, 1e-5])
def test_windows_are_no_closer_than_the_error_asks_for(tol):
    """Twice as far apart they would err by sixteen times as much, or about."""
    made = built(-30.0, 36.0, tol=tol, dtype=np.float32)
    assert tol / 20.0 <= made.error <= tol


def octants(seed: int, count: int = 9, half: int = 8) -> np.ndarray:
    """Windows of noise that falls outwards at a rate of its own each, of the sum 1."""
    rng = np.random.default_rng(seed)
    column, row = octant(half)
    falls = rng.uniform(0.2, 1.5, (count, 1))
    values = rng.uniform(0.5, 1.5, (count, column.size)) * np.exp(-falls * np.hypot(column, row))
    return values / sums_of_windows(values, half)[:, -1:]


@given(st.integers(0, 2**32 - 1), st.floats(0.5, 0.999))
def test_every_window_holds_what_was_asked_for(seed, energy):
    values = octants(seed)
    cuts = find_cuts(values, 8, energy)
    assert np.all((cuts >= 0.0) & (cuts <= 8.0))
    assert np.all(sums_of_quarters(cut(values, cuts)) >= energy - 1e-12)


@given(st.integers(0, 2**32 - 1))
def test_a_window_alone_holds_just_that_much(seed):
    values = octants(seed, count=1)
    energy = max(0.9, float(values[0, 0]))
    held = sums_of_quarters(cut(values, find_cuts(values, 8, energy)))
    np.testing.assert_allclose(held, energy, rtol=1e-12)


def test_cuts_reach_as_far_as_those_of_the_neighbours():
    values = octants(3)
    alone = np.array([find_cuts(values[i : i + 1], 8, 0.9)[0] for i in range(len(values))])
    padded = np.pad(alone, 1, mode="edge")
    np.testing.assert_array_equal(find_cuts(values, 8, 0.9), np.max([padded[:-2], padded[1:-1], padded[2:]], axis=0))


def test_rings_count_as_the_cuts_of_three_windows_say():
    shares = ring_factors(np.array([2.0, 2.0, 3.5, 2.25]), 5)
    np.testing.assert_allclose(shares[0], [1.0, 1.0, 1.0, 0.0, 0.0, 0.0])
    np.testing.assert_allclose(shares[1], [1.0, 1.0, 1.0, 1.0 / 6.0, 0.5 / 6.0, 0.0])
    np.testing.assert_allclose(shares[2], [1.0, 1.0, 1.0, (4.0 + 0.25) / 6.0, 2.0 / 6.0, 0.0])
    np.testing.assert_array_equal(pixel_factors(np.array([1.5]), 2)[0], [[1, 1, 0.5], [1, 1, 0.5], [0.5, 0.5, 0.5]])


LENS = lm.Lens(focal_length=50e-3, f_number=1.4, focus_distance=1.0, wavelength=550e-9, model="aplanatic")
CASES = {
    "paraxial": (lm.Wavefront, lambda _: 2.0, 0.0),
    "spherical": (lambda c: lm.Wavefront(c) + lm.Wavefront(0.0, 9.0), lambda _: 2.0, 0.3),
    "aplanatic": (LENS.phase, LENS.phase_rate, 0.0),
}
STEP, HALF = 16.0, 14


def exact_of_defocus_nodes(phase, obscuration, defocus):
    rule = pixel_rule(HALF, STEP)
    pupil = lm.Pupil(phase(defocus), obscuration=obscuration)
    means = NijboerZernike(1e-8).means(pupil, STEP * rule.radii, rule.matrix, 1)
    return STEP**2 / (4.0 * np.pi * (1.0 - obscuration**2)) * means


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize(("low", "high"), [(-30.0, 50.0), (3.0, 3.15), (20.0, 55.0)])
def test_windows_are_exact_anywhere_beside_their_own_peaks(name, low, high):
    phase, rate, obscuration = CASES[name]
    ends = np.array([low, 0.5 * (low + high), high])
    parabola = Parabola.through(ends, exact_of_defocus_nodes(phase, obscuration, ends).max(axis=1))
    asked = []

    def windows(defocus):
        asked.append(defocus.size)
        return exact_of_defocus_nodes(phase, obscuration, defocus)

    nodes = DefocusNodes.of(windows, low, high, parabola, rate=rate, bound=STEP**2 / (4.0 * np.pi))
    defocus = np.append(np.random.default_rng(0).uniform(low, high, 60), [low, high])
    made, error = nodes(defocus)
    true = exact_of_defocus_nodes(phase, obscuration, defocus)
    assert error <= 1e-7
    assert (np.abs(made - true).max(axis=1) / true.max(axis=1)).max() <= error + 1e-8
    assert asked == [pytest.approx(high - low + 30.0, abs=25.0)]


@pytest.mark.parametrize("vergence", [0.02, 3.0, 15.0])
@pytest.mark.parametrize("sphere", [-20.0, 0.0, 20.0])
def test_phases_of_complex_defocus_differ_by_no_more_than_is_said(vergence, sphere):
    radius = 18e-3
    most = of_wavefront.growth(radius, sphere, vergence)
    angle = np.linspace(0.0, 2.0 * np.pi, 400)[1:-1]
    delta = vergence * np.concatenate([np.exp(1j * angle), 0.5 * np.exp(1j * angle)])
    delta = delta[np.abs(delta.imag) > 1e-9 * vergence]
    path = of_wavefront.path(np.linspace(0.0, 1.0, 101), radius, sphere, delta).imag / delta.imag[:, None]
    found = (path.max(axis=1) - path.min(axis=1)).max()
    assert found <= most * (1.0 + 1e-12)
    assert most <= 2.5 * found
