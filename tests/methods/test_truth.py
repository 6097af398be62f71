"""The exact methods against a table of fields computed with mpmath, and against each other."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from lommel import Pupil, Wavefront
from lommel.methods import Hankel, NijboerZernike
from lommel.paper import LommelSeries

TABLE = Path(__file__).resolve().parent.parent / "truth" / "field.csv"
Case = tuple[Pupil, NDArray[np.float64], NDArray[np.complex128]]


def _read() -> dict[str, Case]:
    """Return the table by pupil: the pupil, rising v, and U there."""
    rows: dict[tuple[float, ...], list[tuple[float, complex]]] = {}
    with TABLE.open(newline="") as lines:
        for row in csv.DictReader(lines):
            *parameters, v, real, imag = (float(x) for x in row.values())
            rows.setdefault(tuple(parameters), []).append((v, complex(real, imag)))
    cases = {}
    for (defocus, spherical, sixth, eighth, obscuration), points in rows.items():
        v, field = zip(*sorted(points), strict=True)
        pupil = Pupil(Wavefront(defocus, spherical, [sixth, eighth]), obscuration=obscuration)
        name = f"{defocus:g},{spherical:g},{sixth:g},{eighth:g},eps={obscuration:g}"
        # Two pupils of the table may look alike in six digits.
        while name in cases:
            name += "'"
        cases[name] = (pupil, np.array(v), np.array(field))
    return cases


CASES = _read()
ANY = [pytest.param(case, id=name) for name, case in CASES.items()]
DEFOCUSED = [
    pytest.param(case, id=name) for name, case in CASES.items() if LommelSeries().unsupported(case[0]) is None
]

amounts = st.floats(-200, 200)
obscurations = st.one_of(st.just(0.0), st.floats(0.001, 0.95))
radii = st.lists(st.floats(0, 800, allow_subnormal=False), min_size=1, max_size=8).map(np.unique)


def test_the_table_holds_every_kind_of_pupil() -> None:
    coefficients = np.array([np.pad(case[0].coefficients()[0], (0, 4))[:4] for case in CASES.values()])
    assert sum(case[1].size for case in CASES.values()) > 200
    assert len(DEFOCUSED) > 25
    assert np.all(np.abs(coefficients).max(axis=0) >= [400, 200, 30, 30])
    assert {0.0, 0.1, 0.33, 0.5, 0.9} == {case[0].obscuration for case in CASES.values()}


@pytest.mark.parametrize("case", ANY)
def test_hankel_agrees_with_the_table(case: Case) -> None:
    pupil, v, field = case
    assert Hankel().field(pupil, v) == pytest.approx(field, abs=1e-12, rel=0)


@pytest.mark.parametrize("case", ANY)
def test_nijboer_zernike_agrees_with_the_table(case: Case) -> None:
    pupil, v, field = case
    assert NijboerZernike(tol=1e-12).field(pupil, v) == pytest.approx(field, abs=1e-12, rel=0)


@pytest.mark.parametrize("case", DEFOCUSED)
def test_lommel_series_agrees_with_the_table(case: Case) -> None:
    pupil, v, field = case
    assert LommelSeries().field(pupil, v) == pytest.approx(field, abs=1e-12, rel=0)


@pytest.mark.parametrize("case", ANY)
def test_the_error_bound_of_the_field_holds(case: Case) -> None:
    pupil, v, field = case
    for method in (Hankel(), Hankel(tol=1e-6), NijboerZernike(tol=1e-12), NijboerZernike(tol=1e-4)):
        values, bound = method.evaluate(pupil, v)
        assert bound is not None
        # The table has 20 digits, of which a double keeps 53 bits.
        assert np.all(np.abs(values - field) <= bound[:, None] + 2.0**-53)


@pytest.mark.parametrize("case", ANY)
def test_nijboer_zernike_meets_1e_12_or_as_much_as_rounding_allows(case: Case) -> None:
    """A phase of Phi is rounded by Phi 2^-53, a radius of v by v 2^-53: the lower the peak, the more this weighs."""
    pupil, v, field = case
    reach = float(pupil.v(pupil.geometric_radius())) + 4.0
    peak = Hankel().profile(pupil, np.append(np.linspace(0.0, reach, 1001), v[-1])).values.max()
    peak = max(peak, np.abs(field).max() ** 2)
    rounding = (
        2.0**-48
        * (np.abs(pupil.coefficients()).sum() + 0.1 * v[-1] + 10.0)
        * (1.0 + pupil.obscuration**2)
        / peak**0.5
    )
    met = [tol for tol in (1e-12, 1e-11, 1e-10, 1e-9, 1e-8) if tol > rounding]
    assert met
    for tol in met:
        intensity, bound = NijboerZernike(tol=tol).profile(pupil, v)[:2]
        assert bound is not None
        assert np.abs(intensity - np.abs(field) ** 2).max() <= bound[0] * peak <= tol * peak


@given(amounts, amounts, st.floats(-30, 30), obscurations, radii)
def test_nijboer_zernike_and_hankel_agree_anywhere(
    defocus: float, spherical: float, sixth: float, obscuration: float, v: NDArray[np.float64]
) -> None:
    pupil = Pupil(Wavefront(defocus, spherical, [sixth]), obscuration=obscuration)
    series, quadrature = NijboerZernike(tol=1e-12).evaluate(pupil, v), Hankel().evaluate(pupil, v)
    assert series.error is not None
    assert quadrature.error is not None
    difference = np.abs(series.values - quadrature.values).max()
    assert difference <= 1e-12
    assert difference <= series.error[0] + quadrature.error[0]


@given(
    st.one_of(amounts, st.floats(-1e-3, 1e-3)),
    obscurations,
    radii,
    st.lists(st.floats(0.999, 1.001), max_size=3),
)
def test_lommel_series_and_hankel_agree_anywhere_and_at_the_shadow_edge(
    defocus: float, obscuration: float, v: NDArray[np.float64], near_edge: list[float]
) -> None:
    pupil = Pupil(Wavefront(defocus), obscuration=obscuration)
    edges = [4 * abs(defocus) * ratio * inner for ratio in [1.0, *near_edge] for inner in (1.0, obscuration)]
    at = np.unique(np.append(v, edges))
    assert np.abs(LommelSeries().field(pupil, at) - Hankel().field(pupil, at)).max() <= 1e-12


@given(amounts, amounts, obscurations, radii, st.floats(2.1, 14), st.floats(2, 12))
def test_the_error_bounds_hold_at_every_tolerance(
    defocus: float, spherical: float, obscuration: float, v: NDArray[np.float64], one: float, other: float
) -> None:
    pupil = Pupil(Wavefront(defocus, spherical), obscuration=obscuration)
    exact = Hankel(tol=1e-15).field(pupil, v)
    for method in (Hankel(tol=10**-one), NijboerZernike(tol=10**-other)):
        values, bound = method.evaluate(pupil, v)
        assert bound is not None
        # Hankel at 1e-15 has itself been found within 3e-15 of the table.
        assert np.abs(values[0] - exact).max() <= bound[0] + 1e-14
