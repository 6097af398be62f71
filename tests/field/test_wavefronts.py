"""Wavefronts over the field: what is promised at, between and beyond the positions that they are known at."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm

METRIC = {"wavelength": 550e-9, "f_number": 2.8, "obscuration": 0.2}
SEIDEL = {"W020": 0.3, "W040": 0.4, "W131": 1.5, "W222": -0.8, "W220": 0.6, "W311": 0.7}
EDGE = 20e-3


@pytest.fixture(scope="module")
def seidel() -> lm.FieldMap:
    return lm.FieldMap.from_seidel(EDGE, **SEIDEL, **METRIC)


def some_wavefronts(shape: tuple[int, ...], seed: int = 1) -> lm.Wavefront:
    """Wavefronts whose every coefficient is arbitrary at every position."""
    draw = np.random.default_rng(seed).normal
    terms = {t: draw(size=shape) for t in [(1, 1), (2, -2), (3, 1), (3, -1), (3, 3), (5, -1)]}
    return lm.Wavefront(draw(size=shape), draw(size=shape), [draw(size=shape)], terms)


def symmetric_wavefronts(height: np.ndarray, azimuth: float, seed: int = 1) -> lm.Wavefront:
    """Wavefronts that are symmetric about an azimuth, and radially symmetric at height 0."""
    draw = np.random.default_rng(seed).normal
    terms = {}
    for n, m in [(1, 1), (2, 2), (3, 1), (3, 3), (5, 1)]:
        size = np.where(height > 0.0, draw(size=height.shape), 0.0)  # of cos m(theta - azimuth)
        terms[n, m], terms[n, -m] = size * math.cos(m * azimuth), size * math.sin(m * azimuth)
    return lm.Wavefront(draw(size=height.shape), draw(size=height.shape), [draw(size=height.shape)], terms)


def difference(one: lm.Wavefront, other: lm.Wavefront) -> float:
    """The largest difference between coefficients, radians."""
    rest = one - other
    parts = [rest.coefficients, *rest.nonradial.values()]
    return max(float(np.abs(part).max()) for part in parts)


def turned(wavefront: lm.Wavefront, angle: float, rho: np.ndarray, theta: np.ndarray) -> np.ndarray:
    """The phase of a wavefront that was turned by an angle."""
    return wavefront.phase(rho, theta - angle)


X, Y = np.array([-3.0, -1.0, 0.5, 2.0, 7.0]), np.array([-2.0, 0.0, 1.0, 5.0])
RHO, THETA = np.meshgrid(np.linspace(0.0, 1.0, 7), np.linspace(0.0, 6.0, 9))


@pytest.mark.parametrize(("columns", "rows"), [(5, 4), (2, 2), (3, 2), (2, 4)])
@pytest.mark.parametrize("scale", [1.0, 1e-3])
def test_a_map_on_a_grid_is_exact_at_its_positions(columns, rows, scale):
    wavefront = some_wavefronts((rows, columns))
    field = lm.FieldMap.on_grid(X[:columns] * scale, Y[:rows] * scale, wavefront)
    x, y = np.meshgrid(X[:columns] * scale, Y[:rows] * scale)
    assert difference(field.pupil(x, y).wavefront, wavefront) < 1e-12


@pytest.mark.parametrize("count", [3, 5, 6, 40])
@pytest.mark.parametrize("scale", [1.0, 1e-3])
def test_a_map_of_scattered_positions_is_exact_at_them(count, scale):
    x, y = np.random.default_rng(5).uniform(-scale, scale, (2, count))
    wavefront = some_wavefronts((count,))
    field = lm.FieldMap.scattered(x, y, wavefront)
    assert difference(field.pupil(x, y).wavefront, wavefront) < 1e-10


@pytest.mark.parametrize("count", [2, 3, 8])
@pytest.mark.parametrize("azimuth", [0.0, math.pi / 2, -2.0])
def test_a_radial_map_is_exact_at_its_positions(count, azimuth):
    height = np.linspace(0.0, 10e-3, count)
    wavefront = symmetric_wavefronts(height, azimuth)
    field = lm.FieldMap.radial(height, wavefront, azimuth=azimuth)
    found = field.pupil(height * math.cos(azimuth), height * math.sin(azimuth)).wavefront
    assert difference(found, wavefront) < 1e-12


@given(st.floats(-1, 1), st.floats(-1, 1))
def test_a_map_of_seidel_coefficients_is_from_seidel_at_every_position(x, y):
    if math.hypot(x, y) > 1.0:
        return
    field = lm.FieldMap.from_seidel(EDGE, **SEIDEL, **METRIC)
    expected = lm.Wavefront.from_seidel(**SEIDEL, field=(x, y))
    assert difference(field.pupil(x * EDGE, y * EDGE).wavefront, expected) < 1e-12


@given(st.floats(0, 2 * math.pi), st.floats(0, 1), st.floats(-math.pi, math.pi))
def test_a_radial_map_of_a_lens_of_third_order_is_exact_everywhere_from_three_heights(angle, height, azimuth):
    seidel = lm.FieldMap.from_seidel(EDGE, **SEIDEL, **METRIC)
    known = EDGE * np.array([0.0, 0.4, 1.0])
    wavefront = seidel.pupil(known * math.cos(azimuth), known * math.sin(azimuth)).wavefront
    field = lm.FieldMap.radial(known, wavefront, azimuth=azimuth, **METRIC)
    x, y = EDGE * height * math.cos(angle), EDGE * height * math.sin(angle)
    assert difference(field.pupil(x, y).wavefront, seidel.pupil(x, y).wavefront) < 1e-11


def test_grids_and_scattered_positions_follow_a_lens_of_third_order(seidel):
    x = np.linspace(-14e-3, 14e-3, 5)
    at = np.random.default_rng(2).uniform(-13e-3, 13e-3, (2, 50))
    expected = seidel.pupil(*at).wavefront
    across, down = np.meshgrid(x, x)
    wavefront = seidel.pupil(across, down).wavefront
    grid = lm.FieldMap.on_grid(x, x, wavefront, **METRIC)
    assert difference(grid.pupil(*at).wavefront, expected) < 1e-11
    scattered = lm.FieldMap.scattered(across.ravel(), down.ravel(), wavefront.flattened(), **METRIC)
    rest = scattered.pupil(*at).wavefront - expected
    for (n, m), c in rest.edge_terms().items():
        # The tilt of distortion is a cubic; all else is exact.
        assert np.abs(c).max() < (0.15 if n == 1 else 1e-11), (n, m)


@given(st.floats(-math.pi, math.pi), st.floats(0.01, 1), st.floats(-math.pi, math.pi))
def test_a_wavefront_turns_with_the_position(angle, height, azimuth):
    known = np.linspace(0.0, 1.0, 5)
    terms = symmetric_wavefronts(known, azimuth, 3).nonradial
    field = lm.FieldMap.radial(known, lm.Wavefront(known**2, 1.0 + known, (), terms), azimuth=azimuth)
    along = field.pupil(height * math.cos(azimuth), height * math.sin(azimuth)).wavefront
    away = field.pupil(height * math.cos(azimuth + angle), height * math.sin(azimuth + angle)).wavefront
    np.testing.assert_allclose(away.phase(RHO, THETA), turned(along, angle, RHO, THETA), atol=1e-11)


@pytest.mark.parametrize(
    ("terms", "azimuth", "why"),
    [
        ({(3, -1): 0.2}, 0.0, r'height 2 must be symmetric .* coma of 0\.2 waves across it; .* direction = "y"'),
        ({(3, 1): 0.2, (2, 2): 0.1}, math.pi / 2, r'coma of 0\.2 waves across it; .* direction = "x"'),
        ({(3, 1): 0.2, (2, -2): 0.1}, 0.0, r"astigmatism of 0\.1 waves across it; .* give positions x and y"),
    ],
)
def test_the_wavefronts_of_another_direction_than_that_of_the_heights_are_refused(terms, azimuth, why):
    stack = lm.Wavefront.zernike(
        {term: [0.0, 0.5 * c, c] for term, c in terms.items()}, unit="waves", normalization="edge"
    )
    with pytest.raises(ValueError, match=why):
        lm.FieldMap.radial([0.0, 1.0, 2.0], stack, azimuth=azimuth)


def test_a_wavefront_is_smooth_across_the_axis():
    known = np.linspace(0.0, 1.0, 4)
    field = lm.FieldMap.radial(known, lm.Wavefront(np.cos(known), 0.0, (), {(3, 1): np.sin(known), (2, 2): known**2}))
    x = np.linspace(-1e-3, 1e-3, 5)
    found = field.pupil(x, 0.0).wavefront
    # Odd and even functions with bounded curvature: no kink at 0.
    for c in (found.defocus, found.nonradial[2, 2], found.nonradial[3, 1]):
        assert np.abs(np.diff(c, 2)).max() < 1e-5


MAPS = {
    "grid": (lm.FieldMap.on_grid(X, Y, some_wavefronts((4, 5))), "x from -3 to 7 and y from -2 to 5 lambda*N"),
    "scattered": (
        lm.FieldMap.scattered([0, 4, 0, 1], [0, 0, 4, 1], some_wavefronts((4,))),
        "the convex hull of 4 positions with x from 0 to 4 and y from 0 to 4 lambda*N",
    ),
    "radial": (lm.FieldMap.radial([0, 1, 3], lm.Wavefront([0, 1, 2])), "which reaches 3 lambda*N from the axis"),
    "seidel": (lm.FieldMap.from_seidel(3.0, W131=1.0), "which reaches 3 lambda*N from the axis"),
}


@pytest.mark.parametrize(("field", "limits"), MAPS.values(), ids=MAPS)
@pytest.mark.parametrize("at", [(3.0, 3.0), (-3.1, 0.0), (0.0, 1e300), (2.5, -4.0)])
def test_a_position_beyond_the_map_is_refused_with_the_limits(field, limits, at):
    if field is MAPS["grid"][0] and at == (3.0, 3.0):
        at = (7.001, 3.0)
    for x, y in (at, ([0.5, at[0]], [0.5, at[1]])):
        with pytest.raises(ValueError, match="lies outside of the map") as caught:
            field.pupil(x, y)
        assert f"({at[0]:g}, {at[1]:g}) lambda*N" in str(caught.value)
        assert limits in str(caught.value)


@pytest.mark.parametrize(("field", "limits"), MAPS.values(), ids=MAPS)
def test_a_position_on_the_edge_but_for_rounding_is_in_the_map(field, limits):
    x, y = (7.0, 5.0) if field is MAPS["grid"][0] else (2.0, 2.0) if field is MAPS["scattered"][0] else (3.0, 0.0)
    grow = 1.0 + 1e-12
    assert difference(field.pupil(x * grow, y * grow).wavefront, field.pupil(x, y).wavefront) < 1e-9
