"""From the error of U to that of I, a second time: docs/certificate.md 6 and the section on derivatives."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import j0

import lommel as lm
from core_tests import _core_tests
from lommel import _core
from lommel.methods import Hankel, NijboerZernike
from lommel.methods.method import annulus, normalized_error, relative_error
from lommel.special.legendre import gauss_legendre
from rendering import rendered

UNIT = 2.0**-53
few = settings(max_examples=15)
roots = st.floats(1e-6, 1.0)
shares = st.floats(1e-12, 2.0)
phases = st.lists(st.floats(-30, 30), min_size=1, max_size=3)
obscurations = st.one_of(st.just(0.0), st.floats(0.01, 0.95))
# g_0, g_1, ...: none, Gaussian, and one that rises and falls.
lights = st.one_of(st.just([0.0]), st.floats(0.01, 9.0).map(lambda g: [0.0, g]), st.just([0.3, -1.2, 1.2, 0.1]))


def over_peak(m: mp.mpf, e: mp.mpf) -> mp.mpf:
    return (2 * m * e + e * e) / (m - e) ** 2


@given(roots, shares)
def test_the_error_of_the_intensity_over_its_exact_peak(root, share):
    peak, e = root * root, root * share
    m = mp.sqrt(mp.mpf(peak))
    compiled = _core_tests.intensity_bounds(peak, e)
    ours = float(relative_error(np.array([[0.1 * peak, peak]]), np.array([e]))[0])
    if share < 0.999:
        expected = over_peak(m, mp.mpf(e))
        assert compiled["relative"] == pytest.approx(float(expected), rel=1e-9, abs=0.0)
        assert ours == pytest.approx(float(expected), rel=1e-9, abs=0.0)
    elif share > 1.001:
        # Nothing is known of the exact peak.
        assert compiled["relative"] >= 1e300
        assert ours == math.inf
    r = compiled["relative"]
    if r < 0.999:
        divided = 2 * mp.mpf(r) / (1 - mp.mpf(r))
        assert compiled["normalized"] == pytest.approx(float(divided), rel=1e-9, abs=0.0)
        assert float(normalized_error(np.array([r]))[0]) == pytest.approx(float(divided), rel=1e-9, abs=0.0)
    elif r >= 1.0:
        assert compiled["normalized"] >= 1e300
        assert float(normalized_error(np.array([r]))[0]) == math.inf


@given(st.floats(0.0, 0.5), st.booleans(), st.booleans())
def test_what_storing_adds(relative, single, twice):
    """Six roundings to double, and one to float, or two of values that are divided after they were stored."""
    rounding = 6 * mp.mpf(2) ** -53 + (mp.mpf(2) ** -24 * (2 if twice else 1) if single else 0)
    expected = mp.mpf(relative) + (1 + mp.mpf(relative)) * rounding
    assert _core_tests.stored_bound(relative, single, twice) == pytest.approx(float(expected), rel=1e-12, abs=0.0)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize("divided", [False, True])
def test_the_kind_of_an_image_is_counted(kind, divided):
    phase, bounds = np.array([[9.0, -4.0]]), []
    for dtype in (np.float64, kind):
        made = rendered(phase, 0.2, [0.0], (6, 9), 0.8, 1e-5, divided=divided, dtype=dtype)
        assert made.unmet == 0.0
        bounds.append(made.bounds[0])
    whole = [_core_tests.stored_bound(0.0, single, divided) for single in (False, kind == np.float32)]
    assert bounds[1] - bounds[0] == pytest.approx(whole[1] - whole[0], rel=1e-4, abs=0.0)


@given(st.floats(1e-9, 1e-3))
def test_a_field_that_is_wrong_by_that_much_everywhere_reaches_the_bounds(e):
    # Computed 1 where the field is 1 - e, and 1 - e where it is 1 - 2 e.
    bound = _core_tests.intensity_bounds(1.0, e)
    true = (1.0 - (1.0 - e) ** 2) / (1.0 - e) ** 2
    assert true <= bound["relative"] * (1 + 1e-6)
    assert bound["relative"] <= 1.01 * true
    # Two pixels as bright: one is divided by what the other was computed to be.
    r = bound["relative"]
    true = 1.0 - (1.0 - r) / (1.0 + r)
    assert true <= bound["normalized"] * (1 + 1e-6) <= 1.02 * true


def field(phase: list[float], light: list[float], obscuration: float, v: np.ndarray, power: int = 0) -> np.ndarray:
    """Return U by plain quadrature, good to about 1e-14 for phases of 100 rad; of P_1(2t - 1), P_2, ..."""
    t, weights = gauss_legendre(300, obscuration**2, 1.0)
    total = np.polynomial.legendre.legval(2 * t - 1, [0.0, *phase])
    return j0(np.asarray(v)[:, None] * np.sqrt(t)) @ (
        weights * t**power * np.exp(1j * total - np.polynomial.polynomial.polyval(t, light))
    )


@given(phases, lights, obscurations, st.sampled_from([1e-4, 1e-7]))
@few
def test_the_first_error_and_the_scan_for_the_peak(phase, light, obscuration, tol):
    found = _core_tests.peaks(np.array(phase), np.array(light), obscuration, tol)
    low = mp.mpf(obscuration) ** 2
    bright = mp.quad(lambda t: mp.exp(-sum(mp.mpf(g) * t**k for k, g in enumerate(light))), [low, 1])
    likely = bright / (4 * sum(map(abs, map(mp.mpf, phase))) + 1)
    assert found["likely"] == pytest.approx(float(likely), rel=1e-9, abs=0.0)
    assert found["first_error"] == pytest.approx(float(0.4 * mp.mpf(tol) * likely), rel=1e-9, abs=0.0)
    # Rays reach |dPhi / drho| <= sum 2 j (j + 1) |a_j|; 512 radii from the axis to there and 4 beyond.
    blur = 4 + 2 * sum(j * (j + 1) * abs(a) for j, a in enumerate(phase, 1))
    values = field(phase, light, obscuration, blur / 512 * np.arange(512))
    scanned = float((np.abs(values) ** 2).max())
    assert found["scanned"] == pytest.approx(scanned, abs=3 * found["first_error"] * math.sqrt(scanned))


def test_the_scan_finds_a_ring_of_light_that_the_window_misses():
    # The axis of a defocused lens is dark where 2 C_d is a whole number of turns.
    pupil = lm.Pupil(lm.Wavefront(20 * math.pi))
    blur = float(pupil.v(pupil.geometric_radius()))
    v = np.linspace(0.0, blur + 4.0, 4000)
    values = np.abs(Hankel().field(pupil, v)) ** 2
    assert values[0] < 1e-12
    assert v[values.argmax()] > 0.01 * (blur + 4.0)
    scanned = _core_tests.peaks(pupil.radial_terms()[0], np.zeros(1), 0.0, 1e-6)["scanned"]
    assert scanned == pytest.approx(values.max(), rel=0.02)
    answer = lm.psf(pupil, 1, 0.5, dtype=np.float64)
    assert answer.error_bound <= 1e-6 + UNIT


@few
@given(phases, lights, obscurations, st.sampled_from([1e-3, 1e-6, 1e-9]), st.booleans())
def test_the_bound_of_an_image_is_that_of_its_field(phase, light, obscuration, tol, divided):
    step = 0.8
    unmet, images, scales, bounds, *_ = rendered([phase], obscuration, light, (6, 9), step, tol, divided=divided)
    if unmet:
        assert unmet > tol
        return
    reach = math.sqrt(3**2 + 4**2) * step
    peak = 1.0 / scales[0] if divided else float(images.max())
    about = _core_tests.peaks(np.array(phase), np.array(light), obscuration, tol)
    error, expected = about["first_error"], []
    while error > 0.8 * UNIT:
        u = _core_tests.field_bound(np.array(phase), np.array(light), 0, obscuration, reach, error)
        inside = _core_tests.intensity_bounds(peak, u)
        expected.append(
            _core_tests.stored_bound(inside["normalized"] if divided else inside["relative"], False, divided)
        )
        error *= 0.1
    # The first that meets the tolerance, in the window or, failing that, over the peak wherever it is.
    if expected[0] <= tol or divided:
        first = next(e for e in expected if e <= tol)
        assert bounds[0] == pytest.approx(first, rel=1e-9, abs=0.0)
    else:
        assert bounds[0] <= tol


@pytest.mark.parametrize("tol", [1e-6, 1e-9, 1e-10])
def test_errors_are_tightened_as_far_as_rounding_allows(tol):
    # A thousandth of a turn from darkness on the axis, by which the window is divided.
    pupil = lm.Pupil(lm.Wavefront(3 * math.pi * 1.001))
    about = _core_tests.peaks(pupil.radial_terms()[0], np.zeros(1), 0.0, tol)
    exact = abs(2 * math.sin(3 * math.pi * 1.001) / (6 * math.pi * 1.001))
    assert 2 * about["first_error"] / exact > tol
    answer = lm.psf(pupil, 1, 0.5, method=NijboerZernike(tol), normalize="peak", dtype=np.float64)
    assert answer.error_bound <= tol + UNIT
    assert 1.0 / answer.scale == pytest.approx(exact**2, rel=tol)


def test_pupils_of_a_stack_whose_bound_is_too_weak_are_done_again():
    defocus = np.array([1.0, 3 * math.pi * 1.001, 2.0, 3 * math.pi * 1.0001])
    pupil, method = lm.Pupil(lm.Wavefront(defocus)), NijboerZernike(1e-7)
    answer = lm.psf(pupil, 1, 0.5, method=method, normalize="peak", dtype=np.float64)
    assert answer.error_bound <= 1e-7
    assert 1.0 / answer.scale == pytest.approx(np.sinc(defocus / math.pi) ** 2, rel=1e-7)


def test_what_rounding_does_not_allow_is_refused():
    with pytest.raises(lm.ToleranceError, match="tol=1e-12 cannot be met"):
        lm.psf(lm.Pupil(lm.Wavefront(400.0, 200.0)), 9, 0.5, method=NijboerZernike(1e-12))


@few
@given(phases, lights, obscurations, st.integers(1, 4), st.sampled_from([1e-4, 1e-8]))
def test_the_bound_of_a_derivative(phase, light, obscuration, power, tol):
    step = 0.6
    made = rendered([phase], obscuration, light, (5, 5), step, tol, powers=[power])
    images, slope_bounds = made.images, made.slope_bounds
    if made.unmet:
        return
    reach = math.sqrt(8) * step
    radii = step * np.sqrt([0, 1, 2, 4, 5, 8])
    largest = mp.mpf(float(np.abs(field(phase, light, obscuration, radii, power)).max()))
    peaks = {float(images.max()), _core_tests.peaks(np.array(phase), np.array(light), obscuration, tol)["scanned"]}
    error, expected = _core_tests.peaks(np.array(phase), np.array(light), obscuration, tol)["first_error"], []
    while error > 0.8 * UNIT:
        u = mp.mpf(_core_tests.field_bound(np.array(phase), np.array(light), 0, obscuration, reach, error))
        own = mp.mpf(_core_tests.field_bound(np.array(phase), np.array(light), power, obscuration, reach, error))
        for m in map(mp.sqrt, map(mp.mpf, peaks)):
            # Six roundings of what is stored.
            kept = m * largest * 6 * mp.mpf(UNIT)
            expected.append(float(2 * (m * own + largest * u + own * u + kept) / (m - u) ** 2))
        error *= 0.1
    assert any(slope_bounds[0, 0] == pytest.approx(e, rel=1e-6 if tol == 1e-4 else 1e-3, abs=0.0) for e in expected)


def test_the_derivative_by_defocus_is_twice_that_by_the_power_and_so_is_its_bound():
    pupil = lm.Pupil(lm.Wavefront(6.0, -4.0, (1.0,)))
    answer = lm.psf(
        pupil, 9, 0.5, derivatives=("defocus", "spherical", "rho^6"), dtype=np.float64, normalize="strehl"
    )
    made = rendered(pupil.radial_terms(), 0.0, [0.0], (9, 9), 0.5 * math.pi, 1e-6, powers=[1, 2, 3])
    slopes, slope_bounds = made.slopes, made.slope_bounds
    assert answer.derivative_bounds["defocus"] == pytest.approx(2.0 * slope_bounds[0, 0], rel=1e-12, abs=0.0)
    assert answer.derivative_bounds["spherical"] == pytest.approx(slope_bounds[1, 0], rel=1e-12, abs=0.0)
    assert np.allclose(answer.derivatives["defocus"], 2.0 * slopes[0, 0], rtol=1e-12, atol=0)


def test_the_bounds_of_two_disks_add_up_the_inner_one_by_its_area():
    def disk(coefficients, v):
        scale = float(np.abs(coefficients).max())
        return lm.methods.method.FieldValues(np.full((1, v.size), 0.5 + 0j), np.array([0.125 * scale]))

    pupil = lm.Pupil(lm.Wavefront(0.0, 8.0), obscuration=0.5)
    found = annulus(disk, pupil, np.linspace(0, 1, 3))
    # 8 t^2 at half the radius is 0.5 t^2; a quarter of the area.
    assert found.error[0] == pytest.approx(0.125 * 8.0 + 0.25 * 0.125 * 0.5, rel=1e-12, abs=0.0)
    assert np.allclose(found.values, 0.375)


@few
@given(phases, lights, obscurations, st.sampled_from([1e-4, 1e-7, 1e-11]))
def test_the_bound_of_a_field_counts_what_makes_its_phase_0_in_the_middle(phase, light, obscuration, tol):
    v = np.linspace(0.0, 20.0, 200)
    found = _core.field((np.array([phase]), obscuration, np.array(light)), v, tol)[1][0]
    error = _core_tests.peaks(np.array(phase), np.array(light), obscuration, tol)["first_error"]
    expanded = _core_tests.field_bound(np.array(phase), np.array(light), 0, obscuration, 20.0, error)
    turned = UNIT * (len(phase) * sum(abs(mp.mpf(c)) for c in phase) + 8)
    assert float(found) == pytest.approx(float(expanded + turned), rel=1e-12, abs=0.0)
