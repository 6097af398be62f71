"""The tolerance of the default method is a contract: swept, searched, and judged by plain quadrature."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

import lommel as lm
from lommel import Pupil, ToleranceError, Wavefront
from lommel.methods import Hankel, NijboerZernike

PUPILS = {
    "in focus": Pupil(),
    "half a radian": Pupil(Wavefront(0.5)),
    "dark on axis": Pupil(Wavefront(math.pi)),
    "defocus 10": Pupil(Wavefront(10.0)),
    "defocus -50": Pupil(Wavefront(-50.0)),
    "defocus 200": Pupil(Wavefront(200.0)),
    "spherical 20": Pupil(Wavefront(0.0, 20.0)),
    "spherical 200": Pupil(Wavefront(0.0, 200.0)),
    "spherical -200": Pupil(Wavefront(0.0, -200.0)),
    "balanced 200": Pupil(Wavefront(-200.0, 200.0)),
    "balanced rms 3": Pupil(Wavefront.balanced_spherical(3.0)),
    "both 200": Pupil(Wavefront(200.0, 200.0)),
    "sixth order": Pupil(Wavefront(5.0, -20.0, [30.0])),
    "eighth order": Pupil(Wavefront(-5.0, 20.0, [-30.0, 30.0])),
    "obscured in focus": Pupil(obscuration=0.9),
    "obscured by a third": Pupil(Wavefront(20.0, 10.0), obscuration=0.33),
    "obscured by nine tenths": Pupil(Wavefront(30.0, -10.0), obscuration=0.9),
    "obscured and far out of focus": Pupil(Wavefront(200.0), obscuration=0.33),
}
GRIDS = {"large": ((96, 91), 0.3), "small": ((5, 6), 0.8)}
TOLERANCES = 10.0 ** -np.arange(3.0, 10.01, 0.125)


def _peak(pupil: Pupil, values: NDArray[np.float64]) -> float:
    """Return the largest intensity over the clear peak, in the window or anywhere in the geometric blur."""
    reach = float(pupil.v(pupil.geometric_radius())) + 4.0
    along = Hankel().profile(pupil, np.linspace(0.0, reach, 1001)).values.max() / pupil.area**2
    return max(float(values.max()), float(along))


@lru_cache
def _exact(name: str, grid: str) -> tuple[NDArray[np.float64], float]:
    shape, pixel = GRIDS[grid]
    values = lm.psf(PUPILS[name], shape, pixel, method=Hankel(), normalize="strehl").values
    return values, _peak(PUPILS[name], values)


def _may_refuse(pupil: Pupil, peak: float, tol: float) -> bool:
    """Say whether doubles may be too coarse: a phase Phi is rounded by Phi 2^-53, and U by as much over the peak."""
    phase = np.abs(pupil.coefficients()).sum() + 10.0
    return tol < 2.0**-48 * phase * (1.0 + pupil.obscuration**2) / (pupil.area * math.sqrt(peak))


@pytest.mark.parametrize("grid", GRIDS)
@pytest.mark.parametrize("name", PUPILS)
def test_every_tolerance_is_met_at_eight_a_decade(name: str, grid: str) -> None:
    shape, pixel = GRIDS[grid]
    exact, peak = _exact(name, grid)
    met = 0
    for tol in TOLERANCES:
        try:
            answer = lm.psf(
                PUPILS[name], shape, pixel, method=NijboerZernike(tol), normalize="strehl", dtype=np.float64
            )
        except ToleranceError:
            assert _may_refuse(PUPILS[name], peak, tol)
            continue
        met += 1
        assert answer.error_bound is not None
        assert np.abs(answer.values - exact).max() / peak <= answer.error_bound <= tol
    assert met >= 50


def test_only_phases_of_hundreds_of_radians_are_ever_refused_down_to_1e_10() -> None:
    refused = {n for n in PUPILS for g in GRIDS if _may_refuse(PUPILS[n], _exact(n, g)[1], TOLERANCES[-1])}
    assert refused <= {"defocus 200", "both 200", "obscured and far out of focus"}


amounts = st.one_of(st.floats(-200, 200), st.floats(-1, 1))


@given(
    wavefront=st.builds(Wavefront, amounts, amounts, st.lists(st.floats(-30, 30), max_size=2)),
    obscuration=st.one_of(st.just(0.0), st.floats(0.01, 0.97)),
    shape=st.tuples(st.integers(1, 70), st.integers(1, 70)),
    pixel=st.floats(0.01, 4.0),
    digits=st.floats(1.001, 10.0),
)
def test_any_tolerance_is_met_for_any_pupil_on_any_grid(
    wavefront: Wavefront, obscuration: float, shape: tuple[int, int], pixel: float, digits: float
) -> None:
    pupil, tol = Pupil(wavefront, obscuration=obscuration), 10**-digits
    exact = lm.psf(pupil, shape, pixel, method=Hankel(), normalize="strehl").values
    peak = _peak(pupil, exact)
    try:
        answer = lm.psf(pupil, shape, pixel, method=NijboerZernike(tol), normalize="strehl", dtype=np.float64)
    except ToleranceError:
        assert _may_refuse(pupil, peak, tol)
        return
    assert answer.error_bound is not None
    assert np.abs(answer.values - exact).max() / peak <= answer.error_bound <= tol


@pytest.mark.parametrize("shape", [1, 2, (1, 3)])
@pytest.mark.parametrize("defocus", [math.pi, -3 * math.pi, 20 * math.pi])
def test_a_window_on_the_dark_centre_alone_is_judged_by_the_peak_outside(
    defocus: float, shape: int | tuple[int, int]
) -> None:
    """On axis ``sin(C_d) / C_d`` is zero: no bound relative to the window's own values could hold."""
    pupil, pixel = Pupil(Wavefront(defocus)), 1e-4
    answer = lm.psf(pupil, shape, pixel, method=NijboerZernike(1e-9), normalize="strehl")
    exact = lm.psf(pupil, shape, pixel, method=Hankel(), normalize="strehl").values
    peak = _peak(pupil, exact)
    assert exact.max() < 1e-9 * peak
    assert answer.error_bound is not None
    assert np.abs(answer.values - exact).max() / peak <= answer.error_bound <= 1e-9


@pytest.mark.parametrize("tol", [1e-3, 1e-6, 2.5e-7])
@pytest.mark.parametrize("name", PUPILS)
def test_in_single_precision_the_bound_includes_the_rounding_of_the_values(name: str, tol: float) -> None:
    exact, peak = _exact(name, "large")
    answer = lm.psf(PUPILS[name], *GRIDS["large"], method=NijboerZernike(tol), normalize="strehl", dtype=np.float32)
    assert answer.values.dtype == np.float32
    assert answer.error_bound is not None
    assert np.abs(answer.values - exact).max() / peak <= answer.error_bound <= tol


@given(amounts, amounts, st.floats(0, 300, allow_subnormal=False), st.floats(3, 9))
def test_the_profile_at_one_radius_alone_meets_the_tolerance(
    defocus: float, spherical: float, v: float, digits: float
) -> None:
    pupil, at = Pupil(Wavefront(defocus, spherical)), np.array([v])
    intensity, bound = NijboerZernike(10**-digits).profile(pupil, at)[:2]
    assert bound is not None
    exact = Hankel().profile(pupil, at).values[0]
    assert np.abs(intensity[0] - exact).max() <= bound[0] * _peak(pupil, exact) <= 10**-digits * _peak(pupil, exact)


def test_a_tolerance_beyond_double_precision_is_refused_with_what_is_reached() -> None:
    with pytest.raises(ToleranceError, match=r"tol=1e-12 cannot be met in double precision: .* of the peak"):
        lm.psf(PUPILS["both 200"], 9, 0.5, method=NijboerZernike(1e-12))


def test_the_least_obscurations_count() -> None:
    # A two-hundredth of the radius takes 2.5e-5 of the field.
    pupil = lm.Pupil(lm.Wavefront(3.0), obscuration=5e-3)
    found, exact = (
        lm.psf(pupil, 33, 0.4, method=method, dtype=np.float64, normalize="strehl")
        for method in (lm.methods.NijboerZernike(1e-9), lm.methods.Hankel())
    )
    assert np.abs(found.values - exact.values).max() <= 1e-9 * exact.values.max()
