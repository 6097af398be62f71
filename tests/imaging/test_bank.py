"""Banks: windows between windows, the light they hold, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm
from lommel.imaging.bank import Bank, build_bank

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
    answer = lm.psf(there, side, PIXEL, integrate=True, method=lm.NijboerZernike(1e-9), dtype=np.float64)
    return np.asarray(answer.values)


@pytest.fixture(scope="module", params=PUPILS)
def bank(request: pytest.FixtureRequest) -> tuple[lm.Pupil, Bank]:
    """A bank from behind the focus to before it."""
    pupil = PUPILS[request.param]
    made = build_bank(
        pupil, lm.Wavefront, GREEN, PIXEL, (-9.0, 14.0), tol=1e-4, energy=0.95, largest=60, dtype=np.float64
    )
    return pupil, made


@given(defocus=st.floats(-9.0, 14.0))
def test_interpolated_windows_err_by_less_than_the_tolerance_anywhere(bank, defocus):
    pupil, windows = bank
    true = exact(pupil, defocus, 2 * windows.half + 1)
    kept = windows.used(defocus) * true
    assert np.abs(windows.window(defocus) - kept / kept.sum()).max() <= 1e-4 * kept.max() / kept.sum()


@given(defocus=st.floats(-9.0, 14.0))
def test_windows_hold_the_light_that_was_asked_for_and_spread_what_they_do_not(bank, defocus):
    pupil, windows = bank
    held = (windows.used(defocus) * exact(pupil, defocus, 2 * windows.half + 1)).sum()
    assert held >= 0.95 - 1e-3
    assert held >= 1.0 - windows.lost - 1e-3
    assert windows.lost <= 0.05
    assert windows.window(defocus).sum() == pytest.approx(1.0, abs=1e-12)


def test_the_range_lies_inside_the_bank_with_a_window_beyond_either_end(bank):
    _, windows = bank
    low, high = windows.positions([-9.0, 14.0])
    assert low >= 0.0
    assert high <= windows.count - 1
    assert windows.windows.shape[0] == windows.count + 1
    assert windows.halves.shape == (windows.count,)
    assert windows.error <= 1e-4


def test_energies_are_the_sums_of_the_windows(bank):
    _, windows = bank
    for index in range(0, windows.count, 5):
        for half in (0, windows.half // 2, windows.half):
            # Windows are stored from the middle row down and the middle column on.
            quarter = windows.windows[index, : half + 1, : half + 1]
            total = 4.0 * quarter.sum() - 2.0 * (quarter[0].sum() + quarter[:, 0].sum()) + quarter[0, 0]
            assert windows.energies[index, half] == pytest.approx(total, rel=1e-12)


@pytest.mark.parametrize("tol", [1e-2, 1e-4, 1e-6])
def test_the_tolerance_is_kept_and_a_smaller_one_takes_more_windows(tol):
    made = build_bank(
        PUPILS["plain"], lm.Wavefront, GREEN, PIXEL, (1.0, 8.0), tol=tol, energy=0.9, largest=60, dtype=np.float64
    )
    coarse = build_bank(
        PUPILS["plain"],
        lm.Wavefront,
        GREEN,
        PIXEL,
        (1.0, 8.0),
        tol=10 * tol,
        energy=0.9,
        largest=60,
        dtype=np.float64,
    )
    for defocus in np.random.default_rng(0).uniform(1.0, 8.0, 12):
        true = made.used(defocus) * exact(PUPILS["plain"], defocus, 2 * made.half + 1)
        assert np.abs(made.window(defocus) * true.sum() - true).max() <= tol * true.max()
    assert coarse.count < made.count


def test_a_spectrum_is_the_sum_of_its_wavelengths_at_equal_path_differences():
    spectrum = ((500e-9, 0.3), (620e-9, 0.7))
    pupil = PUPILS["spherical"]
    made = build_bank(
        pupil, lm.Wavefront, spectrum, PIXEL, (2.0, 6.0), tol=1e-5, energy=0.95, largest=60, dtype=np.float64
    )
    for defocus in (2.0, 3.7, 6.0):
        true = sum(share * exact(pupil, defocus, 2 * made.half + 1, at) for at, share in spectrum)
        true = made.used(defocus) * true
        assert np.abs(made.window(defocus) * true.sum() - true).max() <= 1e-5 * true.max()


def test_windows_are_no_larger_than_the_blur_takes():
    made = build_bank(PUPILS["plain"], lm.Wavefront, GREEN, PIXEL, (0.0, 40.0), tol=1e-3, energy=0.9, largest=60)
    assert made.windows.dtype == np.float32
    assert made.halves[1] < 3
    assert made.halves[-2] > 8
    assert made.half == np.ceil(made.halves.max())


@pytest.mark.parametrize("name", PUPILS)
def test_a_window_changes_little_where_the_defocus_does(name):
    """At each window of the bank, and wherever a new ring begins, the step is that of a smooth function."""
    made = build_bank(
        PUPILS[name], lm.Wavefront, GREEN, PIXEL, (-9.0, 14.0), tol=1e-4, energy=0.98, largest=60, dtype=np.float64
    )
    knots = made.start + made.spacing * np.arange(1, made.count - 1)
    whole = np.arange(1, made.half)
    rings = [
        np.interp(whole, made.halves[i : i + 2], made.start + made.spacing * np.array([i, i + 1.0]), np.nan, np.nan)
        for i in range(1, made.count - 2)
        if made.halves[i] < made.halves[i + 1]
    ]
    begins = np.concatenate([np.ravel(rings)[~np.isnan(np.ravel(rings))], knots])
    assert len(begins) > len(knots)
    step = 1e-9
    for at in begins:
        before, after = made.window(at - step), made.window(at + step)
        assert np.abs(after - before).max() <= 1e-7 * after.max()


def test_one_distance_makes_a_bank_too():
    made = build_bank(
        PUPILS["plain"], lm.Wavefront, GREEN, PIXEL, (5.0, 5.0), tol=1e-6, energy=0.95, largest=60, dtype=np.float64
    )
    true = made.used(5.0) * exact(PUPILS["plain"], 5.0, 2 * made.half + 1)
    assert np.abs(made.window(5.0) * true.sum() - true).max() <= 2e-6 * true.max()


def test_banks_that_would_be_too_large_are_refused_with_what_to_do(monkeypatch):
    with pytest.raises(ValueError, match=r"the blur takes windows of more than 21 pixels a side to hold 0.95 of"):
        build_bank(PUPILS["plain"], lm.Wavefront, GREEN, PIXEL, (0.0, 60.0), tol=1e-3, energy=0.95, largest=10)
    monkeypatch.setattr("lommel.imaging.bank._MAX_WINDOWS", 200)
    with pytest.raises(ValueError, match=r"exceeds the limits of 200 windows .* ask for a larger tol than 1e-07"):
        build_bank(PUPILS["plain"], lm.Wavefront, GREEN, PIXEL, (0.0, 20.0), tol=1e-7, energy=0.9, largest=60)


@pytest.mark.parametrize("tol", [1e-3, 1e-5])
def test_windows_are_no_closer_than_the_error_asks_for(tol):
    """Twice as far apart they would err by sixteen times as much, or about."""
    made = build_bank(PUPILS["plain"], lm.Wavefront, GREEN, PIXEL, (-30.0, 36.0), tol=tol, energy=0.9, largest=60)
    assert tol / 20.0 <= made.error <= tol
