"""Wavefronts over the field: what a map promises at, between and beyond the positions it is given."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm

FFT = lm.Fraunhofer(samples=64, edge="grey")
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
    wavefront = some_wavefronts((count,))._each(np.array)
    axis = {t: np.where(height > 0, c, 0.0) for t, c in wavefront.nonradial.items()}
    wavefront = lm.Wavefront(wavefront.defocus, wavefront.spherical, wavefront.higher, axis)
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
    axis = np.where(known > 0, 1.0, 0.0)
    terms = {t: axis * c for t, c in some_wavefronts((5,), 3).nonradial.items()}
    field = lm.FieldMap.radial(known, lm.Wavefront(known**2, 1.0 + known, (), terms), azimuth=azimuth)
    along = field.pupil(height * math.cos(azimuth), height * math.sin(azimuth)).wavefront
    away = field.pupil(height * math.cos(azimuth + angle), height * math.sin(azimuth + angle)).wavefront
    np.testing.assert_allclose(away.phase(RHO, THETA), turned(along, angle, RHO, THETA), atol=1e-11)


def test_the_psf_at_an_azimuth_of_90_degrees_is_the_one_along_x_turned_from_columns_to_rows(seidel):
    right = seidel.psf(15e-3, 0.0, 31, 1e-6, method=FFT).values
    below = seidel.psf(0.0, 15e-3, 31, 1e-6, method=FFT).values
    np.testing.assert_allclose(below, right.T, atol=1e-6 * right.max())
    assert np.abs(right - right.T).max() > 0.1 * right.max()


def test_the_tail_of_positive_coma_points_away_from_the_axis():
    field = lm.FieldMap.from_seidel(10.0, W131=1.0)
    psf = field.psf(0.0, -8.0, 41, 0.5, method=FFT)  # above the axis
    rows = psf.values.sum(axis=1)
    centroid = rows @ np.arange(41) / rows.sum()
    assert centroid < np.argmax(rows) - 0.5


def test_a_wavefront_is_smooth_across_the_axis():
    known = np.linspace(0.0, 1.0, 4)
    field = lm.FieldMap.radial(known, lm.Wavefront(np.cos(known), 0.0, (), {(3, 1): np.sin(known), (2, 2): known**2}))
    x = np.linspace(-1e-3, 1e-3, 5)
    found = field.pupil(x, 0.0).wavefront
    # Odd and even functions with bounded curvature: no kink at 0.
    for c in (found.defocus, found.nonradial[2, 2], found.nonradial[3, 1]):
        assert np.abs(np.diff(c, 2)).max() < 1e-5


def test_a_grid_is_one_call_and_equals_single_ones(seidel):
    grid = seidel.grid(3, 5, sensor=(18e-3, 30e-3), shape=(9, 11), pixel=2e-6, method=FFT, normalize="strehl")
    assert isinstance(grid.psf, lm.PSF)
    assert grid.values.shape == (3, 5, 9, 11)
    np.testing.assert_allclose(grid.x, [-12e-3, -6e-3, 0.0, 6e-3, 12e-3], atol=1e-18)
    np.testing.assert_allclose(grid.y, [-6e-3, 0.0, 6e-3], atol=1e-18)
    assert grid.x[2] == grid.y[1] == 0.0
    for i, j in [(0, 0), (1, 2), (2, 4), (0, 3)]:
        single = seidel.psf(grid.x[j], grid.y[i], (9, 11), 2e-6, method=FFT, normalize="strehl")
        # The stack shares the sampling that its widest member needs.
        np.testing.assert_allclose(grid[i, j].values, single.values, atol=1e-6)
        assert difference(grid[i, j].pupil.wavefront, single.pupil.wavefront) < 1e-13


def test_positions_make_stacks_of_pupils_with_the_scale_of_the_map(seidel):
    pupil = seidel.pupil(np.zeros(3), np.zeros((2, 1)))
    assert pupil.shape == (2, 3)
    assert (pupil.wavelength, pupil.f_number, pupil.obscuration) == (550e-9, 2.8, 0.2)
    assert seidel.pupil(0.0, 0.0).shape == ()
    assert (seidel.unit, lm.FieldMap.from_seidel(1.0).unit) == ("m", "lambda*N")


def test_a_map_without_aberrations_of_the_field_is_the_same_everywhere():
    field = lm.FieldMap.from_seidel(1.0, W040=0.5)
    assert field.pupil([0.0, 0.5], 0.0).wavefront == lm.Wavefront.from_seidel(W040=[0.5, 0.5])


def test_what_is_added_to_a_map_is_added_everywhere(seidel):
    more = seidel + lm.Wavefront(2.0, nonradial={(2, 2): 1.0}) + lm.Wavefront(1.0)
    found = (more.pupil([0.0, 1e-2], 0.0).wavefront - seidel.pupil([0.0, 1e-2], 0.0).wavefront).nonradial
    np.testing.assert_allclose(more.pupil(0.0, 0.0).wavefront.defocus, math.pi * 0.3 + 3.0)
    np.testing.assert_allclose(found[2, 2], 1.0)
    with pytest.raises(ValueError, match=r"a single wavefront .* stack of shape \(2,\)"):
        seidel + lm.Wavefront([1.0, 2.0])
    with pytest.raises(TypeError):
        seidel + 1.0


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


MAP, ROUND, some = lm.FieldMap, MAPS["seidel"][0], some_wavefronts


@pytest.mark.parametrize(
    ("make", "error", "what"),
    [
        (lambda: MAP.on_grid([0, 1], [0], some((1, 2))), ValueError, r"y must be of shape \(n,\)"),
        (lambda: MAP.on_grid([0, 0], [0, 1], some((2, 2))), ValueError, "x must rise, got 0 foll"),
        (lambda: MAP.on_grid([0, 1, 2], [0, 1], some((3, 2))), ValueError,
         r"wavefront must have the shape \(len\(y\), len\(x\)\), \(2, 3\), got \(3, 2\)"),
        (lambda: MAP.on_grid([0, math.nan], [0, 1], some((2, 2))), ValueError, "x must be finite"),
        (lambda: MAP.on_grid([0, 1], [0, 1], 5), TypeError, "wavefront must be a Wavefront, got 5"),
        (lambda: MAP.scattered([0, 1], [0, 1], some((2,))), ValueError,
         "the number of positions must be from 3 to 4000, got 2"),
        (lambda: MAP.scattered([0, 1, 0], [2, 1, 2], some((3,))), ValueError,
         r"all be different, got \(0, 2\) twice"),
        (lambda: MAP.scattered([0, 1, 2], [0, 1, 2], some((3,))), ValueError, "not all lie on one"),
        (lambda: MAP.scattered([0, 1, 2], [0, 1], some((3,))), ValueError, r"\(3,\) and \(2,\)"),
        (lambda: MAP.scattered([0, 1, 2], [0, 1, 0], some((4,))), ValueError, r"\(3,\), got \(4,\)"),
        (lambda: MAP.radial([0.1, 1], some((2,))), ValueError, "must begin with 0, the axis, got 0.1"),
        (lambda: MAP.radial([0, 2, 1], some((3,))), ValueError, "height must rise, got 2 followed by 1"),
        (lambda: MAP.radial([0, 1], some((2,))), ValueError, "must not depend on the direction"),
        (lambda: MAP.radial([0, 1], lm.Wavefront([0, 1]), azimuth=math.inf), ValueError, "azimuth must be fini"),
        (lambda: MAP.from_seidel(0.0), ValueError, "edge must be > 0, got 0"),
        (lambda: MAP.from_seidel(1.0, W131=math.nan), ValueError, "W131 must be finite, got nan"),
        (lambda: MAP.from_seidel(1.0, W131=[1.0, 2.0]), TypeError, "W131 must be a real number"),
        (lambda: MAP.from_seidel(1.0, wavelength=1e-6), ValueError, "wavelength and f_number must be given tog"),
        (lambda: ROUND.pupil([0, 1], [0, 1, 2]), ValueError, "x and y must broadcast"),
        (lambda: ROUND.pupil([], 0), (TypeError, ValueError), "x and y must not be empty"),
        (lambda: ROUND.pupil(math.nan, 0), ValueError, "x must be finite, got nan"),
        (lambda: ROUND.grid(0, 2, sensor=(1, 1), shape=3, pixel=1), ValueError, "rows must be from 1 to 1000"),
        (lambda: ROUND.grid(2, 2, sensor=1, shape=3, pixel=1), TypeError, "sensor must be .height, width."),
        (lambda: ROUND.grid(2, 2, sensor=(1, 0), shape=3, pixel=1), ValueError, r"sensor\[1\] must be > 0"),
        (lambda: ROUND.grid(2, 2, sensor=(9, 9), shape=3, pixel=1), ValueError, "outside of the map"),
        (lambda: ROUND.psf(0, 0, 3, 1, method="fft"), TypeError, "method must be a Method"),
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_refused_by_name(make, error, what):
    with pytest.raises(error, match=what):
        make()
