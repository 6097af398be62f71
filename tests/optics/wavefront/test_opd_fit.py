"""Fits give back what they were made from, say what they leave, and refuse what does not determine them."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm
from lommel.optics.wavefront import opd_residual
from lommel.special import zernike

TERMS = [(n, m) for n in range(1, 9) for m in range(-n, n + 1, 2)]
number = st.floats(-5, 5)


def largest_difference(one: lm.Wavefront, two: lm.Wavefront) -> float:
    return max([0.0, *(float(np.abs(c).max()) for c in (one - two).to_zernike().values())])


def test_samples_on_the_rim_belong_to_the_pupil():
    """Of maps, and of fits to them."""
    wavefront = lm.Wavefront.zernike({(2, 2): 0.3, (3, 1): 0.2})
    opd = lm.opd_map(wavefront, 5, unit="radians", radius=2.0)
    rim = [(0, 2), (2, 0), (2, 4), (4, 2)]
    assert np.argwhere(np.isnan(opd)).tolist() == [
        [y, x] for y in range(5) for x in range(5) if math.hypot(y - 2, x - 2) > 2.0
    ]
    angles = np.array([math.atan2(y - 2, x - 2) for y, x in rim])
    assert opd[tuple(np.transpose(rim))] == pytest.approx(wavefront.phase(np.ones(4), angles), rel=1e-14)
    opd[0, 2] += 1.0
    assert lm.fit_opd(opd, degree=2, unit="radians", radius=2.0).rms > 0.2


@given(
    st.dictionaries(st.sampled_from(TERMS), number, max_size=10),
    st.sampled_from(["radians", "waves", "metres"]),
    number,
)
def test_a_map_gives_back_the_wavefront_it_was_made_from(terms, unit, piston):
    wavefront = lm.Wavefront.zernike(terms)
    options = {"unit": unit, "wavelength": 633e-9}
    opd = lm.opd_map(wavefront, 24, **options)
    size = 1e-7 if unit == "metres" else 1.0
    fit = lm.fit_opd(opd + piston * size, **options)
    assert largest_difference(fit.wavefront, wavefront) < 1e-10
    assert fit.rms < 1e-11 * size
    assert fit.peak_to_valley < 1e-10 * size
    assert fit.samples == np.isfinite(opd).sum()
    np.testing.assert_array_equal(np.isnan(fit.residual), np.isnan(opd))
    # The map is zero in the middle, where the terms fitted are not.
    middle = sum(
        c * zernike.rms_factor(n, m) * float(zernike.radial(n, m, np.zeros(1))[0]) for (n, m), c in terms.items()
    )
    radians = {"radians": 1.0, "waves": 2 * math.pi, "metres": 2 * math.pi / 633e-9}[unit]
    assert float(fit.piston) == pytest.approx(piston * size - middle / radians, abs=1e-9 * size)


def test_the_middle_of_a_map_is_where_center_says_and_its_edge_where_radius_says():
    wavefront = lm.Wavefront.zernike({(1, 1): 1.0, (3, -1): 0.3, (2, 0): -0.5})
    place = {"center": (19.3, 25.8), "radius": 16.4}
    opd = lm.opd_map(wavefront, (40, 50), unit="radians", **place)
    assert np.isfinite(opd).sum() == pytest.approx(math.pi * 16.4**2, rel=0.02)
    fit = lm.fit_opd(opd, unit="radians", **place)
    assert largest_difference(fit.wavefront, wavefront) < 1e-10
    row, column = np.array([19, 26])
    x, y = (column - 25.8) / 16.4, (row - 19.3) / 16.4
    assert opd[row, column] == pytest.approx(float(wavefront.phase(math.hypot(x, y), math.atan2(y, x))))


def test_x_rises_with_the_columns_of_a_map_and_y_with_its_rows():
    tilted = lm.opd_map(lm.Wavefront(nonradial={(1, 1): 1.0}), 9, unit="radians")
    np.testing.assert_allclose(np.diff(tilted[4]), 1 / 4.5)
    np.testing.assert_allclose(np.diff(tilted[1:8, 4]), 0.0, atol=1e-15)
    rows = np.arange(9.0)[:, None] * np.ones(9)
    found = lm.fit_opd(rows, unit="radians", degree=1).wavefront
    assert float(found.nonradial[1, -1]) == pytest.approx(4.5)
    assert float(found.nonradial[1, 1]) == pytest.approx(0.0, abs=1e-12)


def test_an_obscured_pupil_is_masked_and_fitted_all_the_same():
    wavefront = lm.Wavefront.zernike({(4, 0): 0.4, (2, 2): -0.3, (5, 1): 0.1})
    opd = lm.opd_map(wavefront, 64, unit="waves")
    x = (np.arange(64) - 31.5) / 32
    rho = np.hypot(x[:, None], x)
    mask = (rho >= 0.4) & (rho <= 1.0) & (np.abs(x) > 0.03)
    fit = lm.fit_opd(np.where(mask, opd, np.nan), unit="waves")
    same = lm.fit_opd(np.where(mask, opd, 1e6), unit="waves", mask=mask)
    assert largest_difference(fit.wavefront, wavefront) < 1e-10
    assert fit.wavefront == same.wavefront
    assert int(fit.samples) == mask.sum()
    assert fit.condition > lm.fit_opd(opd, unit="waves").condition >= 1.0


def test_a_stack_of_maps_is_a_stack_of_wavefronts_even_where_their_masks_differ():
    wavefronts = lm.Wavefront.zernike({(2, 0): np.arange(6.0).reshape(2, 3), (3, 1): np.array([1.0, 2.0, 3.0])})
    opd = lm.opd_map(wavefronts, 32, unit="radians")
    assert opd.shape == (2, 3, 32, 32)
    opd[0, 1, 16, 16] = np.nan
    fit = lm.fit_opd(opd, unit="radians")
    assert fit.wavefront.shape == fit.rms.shape == fit.samples.shape == (2, 3)
    assert fit.samples[0, 1] == fit.samples[1, 1] - 1
    assert largest_difference(fit.wavefront, wavefronts) < 1e-10
    assert fit.residual.shape == opd.shape
    single = lm.fit_opd(opd[1, 2], unit="radians").wavefront
    assert largest_difference(fit.wavefront[1, 2], single) < 1e-12


def test_what_the_terms_cannot_hold_is_the_residual():
    rng = np.random.default_rng(2)
    noise = rng.normal(size=(48, 48))
    fit = lm.fit_opd(noise, unit="radians", degree=4)
    left, inside = fit.residual, np.isfinite(fit.residual)
    assert float(fit.rms) == pytest.approx(math.sqrt(np.mean(left[inside] ** 2)))
    assert float(fit.peak_to_valley) == pytest.approx(float(np.ptp(left[inside])))
    model = lm.opd_map(fit.wavefront, 48, unit="radians")
    # The fitted phase and the residual are the measurement, but for the constants.
    rest = (noise - left - model)[inside]
    np.testing.assert_allclose(rest, rest[0], atol=1e-12)
    # Least squares: nothing that could be fitted is left, by an independent solution.
    x = (np.arange(48) - 23.5) / 24
    y, x = np.meshgrid(x, x, indexing="ij")
    powers = np.array([x[inside] ** i * y[inside] ** j for i in range(5) for j in range(5 - i)])
    reference = noise[inside] - powers.T @ np.linalg.lstsq(powers.T, noise[inside], rcond=None)[0]
    np.testing.assert_allclose(left[inside], reference, atol=1e-11)


GOOD = np.zeros((16, 16))


def holed(*places: tuple[int, int], value: float = math.nan) -> np.ndarray:
    opd = GOOD.copy()
    for place in places:
        opd[place] = value
    return opd


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"opd": holed((8, 8), value=math.inf)}, r"infinity at 1 pixels: \(8, 8\)"),
        ({"opd": holed((8, 8), (3, 9), (5, 5), (6, 6)), "mask": np.ones((16, 16), bool)}, r"at 4 pixels: \(3"),
        ({"mask": np.ones((16, 15), bool)}, r"mask must have the shape \(16, 16\) or that of opd, got \(16, 15\)"),
        ({"degree": 20}, "231 terms need at least as many samples, got 208; lower degree"),
        ({"degree": 18}, r"the 208 samples do not determine 190 terms over the pupil \(condition"),
    ],
)
def test_a_map_that_cannot_be_fitted_is_refused(arguments, message):
    with pytest.raises((ValueError, TypeError), match=message):
        lm.fit_opd(**{"opd": GOOD, "unit": "waves"} | arguments)


def test_nan_outside_of_the_mask_or_of_the_circle_is_normal():
    assert lm.fit_opd(holed((0, 0), (15, 15)), unit="waves", mask=np.ones((16, 16), bool)).samples == 208
    mask = np.ones((16, 16), bool)
    mask[8, 8] = False
    assert lm.fit_opd(holed((8, 8)), unit="waves", mask=mask).samples == 207


def random_annular(degree: int, seed: int) -> dict[tuple[int, int], float]:
    rng = np.random.default_rng(seed)
    return {(n, m): float(rng.normal()) for n in range(1, degree + 1) for m in range(-n, n + 1, 2)}


def grid(side: int) -> tuple[np.ndarray, np.ndarray]:
    return np.meshgrid((np.arange(side) - (side - 1) / 2) * 2 / side, (np.arange(side) - (side - 1) / 2) * 2 / side)


@pytest.mark.parametrize(("degree", "obscuration"), [(20, 0.61), (20, 0.3), (12, 0.8)])
def test_annular_terms_of_high_degrees_are_found(degree, obscuration):
    terms = random_annular(degree, degree)
    exact = lm.Wavefront.zernike(terms, obscuration=obscuration)
    values = lm.opd_map(exact, 160)
    hole = np.hypot(*grid(160)) < obscuration
    fit = lm.fit_opd(np.where(hole, 1e3, values), unit="radians", degree=degree, obscuration=obscuration)
    assert fit.condition < 2
    assert fit.samples == (np.isfinite(values) & ~hole).sum()
    found = fit.wavefront.to_zernike(obscuration=obscuration)
    assert found == pytest.approx(terms, abs=3e-8)
    assert fit.rms < 1e-7


def test_errors_of_samples_do_not_grow_over_an_annulus():
    clear = (np.hypot(*grid(128)) >= 0.61) & (np.hypot(*grid(128)) <= 1)
    noise = np.random.default_rng(0).normal(size=clear.shape)
    fit = lm.fit_opd(noise, unit="radians", degree=18, obscuration=0.61)
    # Of as many samples with errors of 1 the terms take each a variance of 1 over their number.
    left = math.sqrt(1 - 190 / clear.sum())
    assert fit.rms == pytest.approx(left, rel=0.03)
    coefficients = np.array(list(fit.wavefront.to_zernike(obscuration=0.61).values()))
    assert np.sqrt((coefficients**2).mean() * clear.sum()) == pytest.approx(1.0, abs=0.15)
    with pytest.raises(ValueError, match=r"do not determine 190 terms over the pupil .* state the obscuration"):
        lm.fit_opd(noise, unit="radians", degree=18, mask=clear)


def margined(shape: tuple[int, int], center: tuple[float, float], radius: float) -> np.ndarray:
    wavefront = lm.Wavefront.zernike({(2, 2): 0.06, (3, 1): 0.04, (4, 0): -0.035}, unit="waves")
    return lm.opd_map(wavefront, shape, unit="waves", center=center, radius=radius)


@pytest.mark.parametrize(
    ("shape", "center", "radius"),
    [((120, 120), (59.5, 59.5), 50.0), ((100, 140), (49.5, 90.0), 40.0), ((90, 90), (40.0, 44.5), 40.0)],
)
def test_a_map_with_a_margin_is_refused_with_the_circle_that_its_samples_fill(shape, center, radius):
    opd = margined(shape, center, radius)
    with pytest.raises(ValueError, match="by default half the smaller side") as caught:
        lm.fit_opd(opd, unit="waves")
    found = re.search(r"radius=([\d.]+) about center=\(([\d.]+), ([\d.]+)\)", str(caught.value))
    assert len(str(caught.value)) < 300
    size, row, column = map(float, found.groups())
    assert (size, row, column) == pytest.approx((radius, *center), abs=0.3)
    fit = lm.fit_opd(opd, unit="waves", radius=size, center=(row, column))
    assert lm.rms(lm.Pupil(fit.wavefront), unit="waves") == pytest.approx(
        math.sqrt(0.06**2 + 0.04**2 + 0.035**2), rel=0.02
    )
    # A mask, and a stack of maps, are seen likewise; a stated radius is taken as it is.
    with pytest.raises(ValueError, match="by default half the smaller side"):
        lm.fit_opd(np.zeros(shape), unit="waves", mask=np.isfinite(opd))
    with pytest.raises(ValueError, match="by default half the smaller side"):
        lm.fit_opd(np.stack([opd, opd]), unit="waves")
    assert lm.fit_opd(opd, unit="waves", radius=0.5 * min(shape), degree=2).samples > 0


def test_maps_that_nearly_fill_their_array_need_no_radius():
    for side, radius in ((100, 50.0), (100, 48.5), (9, 4.0), (400, 196.0)):
        lm.fit_opd(margined((side, side), (0.5 * (side - 1),) * 2, radius), unit="waves", degree=4)
    # A hexagon reaches the edge at its corners, and a vignetted pupil at the ends of its edge.
    x, y = grid(120)
    for shape in (lm.Polygon.regular(6, 1.0), lm.Disc() & lm.Disc(1.0, (0.4, 0.0))):
        lm.fit_opd(np.zeros((120, 120)), unit="waves", mask=shape.margin(x, y) >= 0.0, degree=3)


@pytest.mark.parametrize("obscuration", [0.0, 0.5])
def test_piston_terms_and_residual_add_up_to_the_map(obscuration):
    x, y = grid(80)
    clear = (np.hypot(x, y) <= 1.0) & (np.hypot(x, y) >= obscuration)
    opd = lm.opd_map(lm.Wavefront.zernike({(4, 0): 0.2, (2, 2): 0.1}, obscuration=obscuration), 80)
    opd += 3.0 + 0.1 * np.random.default_rng(0).normal(size=opd.shape)
    fit = lm.fit_opd(opd, unit="radians", degree=6, obscuration=obscuration)
    rho, theta = np.hypot(x, y)[clear], np.arctan2(y, x)[clear]
    total = fit.piston + fit.residual[clear]
    for (n, m), c in fit.wavefront.to_zernike().items():
        angle = np.sin(-m * theta) if m < 0 else np.cos(m * theta)
        total = total + c * zernike.rms_factor(n, m) * zernike.radial(n, abs(m), rho) * angle
    np.testing.assert_allclose(total, opd[clear], atol=1e-10)
    # The phase of the wavefront itself is 0 on the axis.
    assert float(fit.wavefront.phase(0.0)) == pytest.approx(0.0, abs=1e-12)


def annulus(side: int = 64, hole: float = 0.6, outside: float = 1.0) -> tuple[np.ndarray, np.ndarray]:
    """A map of 0.3 waves of coma and more over an annulus, and where it is measured."""
    x, y = grid(side)
    rho2 = x * x + y * y
    return 0.3 * (3.0 * rho2 - 2.0) * x + 0.2 * x * y, (rho2 >= hole * hole) & (rho2 <= outside * outside)


@pytest.mark.parametrize(
    ("hole", "outside", "value"), [(0.6, 1.0, 0.0), (0.0, 0.9, 0.0), (0.2, 1.0, -99.0), (0.3, 0.6, 0.0)]
)
def test_areas_of_one_value_are_refused_since_files_have_them_where_nothing_was_measured(hole, outside, value):
    values, there = annulus(hole=hole, outside=outside)
    filled = np.where(there, values, value)
    with pytest.raises(
        ValueError, match=rf"opd is {value:g} at \d+ neighbouring pixels .*pass mask=.*or obscuration="
    ):
        lm.fit_opd(filled, unit="waves", degree=3)
    with pytest.raises(ValueError, match="neighbouring"):  # in any map of a stack, and of an OPDMap
        lm.fit_opd(lm.OPDMap(np.stack([values, filled])), wavelength=1e-6, degree=3)
    radius = 32 * outside
    fit = lm.fit_opd(filled, unit="waves", degree=3, mask=filled != value, radius=radius)
    np.testing.assert_allclose(fit.rms, 0.0, atol=1e-12)
    lm.fit_opd(filled, unit="waves", degree=3, mask=np.ones_like(there))  # who says so may have it


def test_an_obscuration_leaves_out_the_middle_that_has_one_value():
    values, there = annulus()
    fit = lm.fit_opd(np.where(there, values, 0.0), unit="waves", degree=3, obscuration=0.6)
    np.testing.assert_allclose(fit.rms, 0.0, atol=1e-12)


@pytest.mark.parametrize("levels", [4, 16, 250])
@pytest.mark.parametrize("power", [2, 4, 8])
def test_maps_in_coarse_steps_are_measurements(levels, power):
    rho = np.hypot(*grid(80))
    lm.fit_opd(np.rint(levels * rho**power), unit="waves")
    lm.fit_opd(np.rint(levels * grid(80)[0]), unit="waves")


def test_a_map_of_one_value_alone_is_flat():
    assert lm.fit_opd(np.full((40, 40), 3.0), unit="waves").piston == pytest.approx(3.0)


def test_what_rounding_leaves_of_zeros_around_a_pupil_is_no_measurement():
    y, x = np.mgrid[-1.2:1.2:97j, -1.2:1.2:97j]
    inside = x * x + y * y <= 1.0
    rest = 1e-16 * np.random.default_rng(2).standard_normal(x.shape)
    opd = np.where(inside, 0.3 * (x * x - y * y), rest)
    for values, way in ((opd, r"such as abs\(opd\) > \de-10"), (np.where(inside, opd, 0.0), "such as opd != 0")):
        with pytest.raises(
            ValueError, match=rf"opd is 0 at .* as in files that mark missing pixels: pass mask=.*{way}"
        ):
            lm.fit_opd(values, unit="waves", radius=57.0, center=(48, 48))


@pytest.mark.parametrize(
    ("change", "status", "codes"),
    [
        (lambda x: 0.0 * x, "converged", ()),
        (lambda x: 3.0 * (x > 27), "doubtful", ("misfit",)),  # half a wave: no error of unwrapping
        (lambda x: 6.25 * (x > 27), "other_explanation", ("other_explanation",)),
        (lambda x: 0.5 * ((x == 20) & (x.T == 17)), "converged", ("outliers",)),
        (lambda x: 9.0 * ((x == 20) & (x.T == 17)), "doubtful", ("outliers",)),
    ],
)
def test_steps_of_a_wave_and_outliers_are_found_in_the_residual(change, status, codes):
    x = np.tile(np.arange(40), (40, 1))
    noise = np.random.default_rng(5).normal(scale=0.05, size=x.shape)
    for unit, size in (("radians", 1.0), ("waves", 0.5 / np.pi)):
        fit = lm.fit_opd(size * (noise + change(x)), unit=unit, degree=4, radius=20.0, center=(19.5, 19.5))
        assert (fit.status, fit.findings.codes) == (status, codes)


def sampled(
    shape: tuple[int, int], center: tuple[float, float], radius: float, size: float = 1.0
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """0.1 waves of coma and 0.15 waves of astigmatism (rms), NaN outside of the pupil, and x and y."""
    row, column = np.mgrid[: shape[0], : shape[1]]
    x, y = (column - center[1]) / radius, (row - center[0]) / radius
    rho2 = x * x + y * y
    waves = size * (0.1 * math.sqrt(8) * (3 * rho2 - 2) * x + 0.15 * math.sqrt(6) * (x * x - y * y))
    return np.where(rho2 <= 1 + 1e-12, waves, np.nan), x, y


TRUE = {(3, 1): 0.1, (2, 2): 0.15}


def coefficients_are_right(fit: lm.WavefrontFit, within: float = 1e-10) -> bool:
    found = np.array([value - TRUE.get(term, 0.0) for term, value in fit.coefficients.items()])
    return bool(np.abs(found).max() < within)


@pytest.mark.parametrize("vanes", [False, True])
@pytest.mark.parametrize(
    ("grid", "side"),
    [(grid, side) for grid in ("pixels", "zemax", "linspace", "zemax, mirrored") for side in (16, 64)]
    + [("pixels", 33), ("linspace", 33)],
)
def test_the_pupil_of_the_usual_grids_is_that_of_their_samples(grid, side, vanes):
    middle = (side - 1) / 2
    center, radius = {
        "pixels": ((middle, middle), side / 2),
        "zemax": ((side // 2, side // 2), side // 2 - 1),
        "linspace": ((middle, middle), middle),
        "zemax, mirrored": (((side - 1) // 2, side // 2), side // 2 - 1),
    }[grid]
    opd, x, y = sampled((side, side), center, radius)
    if vanes and side > 16:
        opd = np.where((np.hypot(x, y) < 0.3) | (np.abs(x) < 0.03), np.nan, opd)
    hole = 0.3 if vanes else 0.0
    fit = lm.fit_opd(opd, unit="waves", degree=4, obscuration=hole)
    assert coefficients_are_right(fit)
    assert fit.reliable
    assert fit.findings.codes == (() if grid == "pixels" else ("estimated",))
    if grid != "pixels":
        numbers = fit.findings[0].numbers
        assert (numbers["row"], numbers["column"], numbers["radius"]) == (*center, radius)
        other = lm.fit_opd(opd, unit="waves", degree=4, center=(middle, middle), radius=side / 2, obscuration=hole)
        other = other.coefficients
        assert numbers["moved"] == pytest.approx(max(abs(other[k] - fit.coefficients[k]) for k in other), rel=1e-6)


def test_a_circle_between_pixels_is_estimated_within_the_errors_of_the_terms():
    draw, ratios = np.random.default_rng(4), []
    for _ in range(12):
        center, radius = 30.5 + draw.uniform(-0.4, 0.4, 2), draw.uniform(29.3, 30.2)
        fit = lm.fit_opd(sampled((62, 62), center, radius)[0], unit="waves", degree=4)
        assert fit.reliable
        assert (
            np.abs(np.array([fit.findings.get("estimated").numbers[k] for k in ("row", "column")]) - center).max()
            < 0.1
        )
        ratios += [(fit.coefficients[term] - TRUE[term]) / fit.errors[term] for term in TRUE]
    assert 0.4 < math.sqrt(np.mean(np.square(ratios))) < 1.6


def test_masks_that_do_not_tell_the_circle_are_doubted_unless_it_is_stated():
    opd, x, y = sampled((65, 65), (32, 32), 32.0)
    hexagon = np.maximum(np.abs(y), np.abs(y) / 2 + np.abs(x) * math.sqrt(3) / 2) <= math.sqrt(3) / 2 + 1e-9
    for values in (np.where(hexagon, opd, np.nan), x * y + x):  # no outline: all pixels
        options = {"unit": "waves", "degree": 4, "mask": np.isfinite(values)}
        assert lm.fit_opd(values, **options).findings.get("undetermined").severity == "doubt"
        assert "undetermined" not in lm.fit_opd(values, **options, radius=32.0, center=(32, 32)).findings.codes
    # Corners of a hexagon beyond the circle of np.linspace exclude it.
    opd, x, y = sampled((64, 64), (31.5, 31.5), 32.0)
    hexagon = np.maximum(np.abs(y), np.abs(y) / 2 + np.abs(x) * math.sqrt(3) / 2) <= math.sqrt(3) / 2
    rectangle = (np.abs(x) < 0.75) & (np.abs(y) < 0.66)
    for shape in (hexagon, rectangle):
        fit = lm.fit_opd(opd, unit="waves", degree=4, mask=shape)
        assert coefficients_are_right(fit)
        # The rectangle lies in both circles.
        assert fit.findings.codes == (("left_out",) if shape is hexagon else ("undetermined", "left_out"))


def mtf(field: np.ndarray) -> np.ndarray:
    """Modulation by an autocorrelation of twice the side."""
    side = 2 * len(field)
    return np.abs(np.fft.ifft2(np.abs(np.fft.fft2(field, (side, side))) ** 2)) / (np.abs(field) ** 2).sum()


@pytest.mark.parametrize(
    ("part", "obscuration", "severity"),
    [
        (lambda x, y: np.hypot(x, y) >= 0.3, 0.3, "doubt"),
        (lambda x, y: np.hypot(x, y) >= 0.12, 0.12, "note"),
        (lambda x, y: x**2 + (y / 0.9) ** 2 <= 1, None, "doubt"),
        (lambda x, y: x**2 + (y - 0.3) ** 2 <= 1, None, "doubt"),
        (lambda x, y: np.abs(x - 0.4) > 0.02, None, None),
        (lambda x, y: np.random.default_rng(1).random(x.shape) > 0.06, None, None),
    ],
)
@pytest.mark.parametrize("size", [0.0, 0.6])
def test_areas_without_samples_are_named_with_the_strehl_ratio_and_mtf_that_they_change(
    part, obscuration, severity, size
):
    opd, x, y = sampled((96, 96), (47.5, 47.5), 48.0, size)
    seen = np.isfinite(opd) & part(x, y)
    options = {"unit": "waves", "degree": 4, "center": (47.5, 47.5), "radius": 48.0}
    finding = lm.fit_opd(np.where(seen, opd, np.nan), **options).findings.get("left_out")
    whole, left = (np.where(one, np.exp(2j * np.pi * np.nan_to_num(opd)), 0) for one in (np.isfinite(opd), seen))
    strehl = np.abs(left[seen].mean() / whole[np.isfinite(opd)].mean()) ** 2 - 1
    changed = np.abs(mtf(whole) - mtf(left)).max()
    if severity is None:
        assert finding is None
        assert abs(strehl) < 0.01
        return
    assert finding.severity == severity
    assert finding.numbers["strehl"] == pytest.approx(strehl, abs=1e-10)
    assert 0.8 * changed < finding.numbers["mtf"] < 2.5 * changed
    assert finding.numbers.get("obscuration") == (obscuration and pytest.approx(obscuration, abs=0.02))
    if obscuration:
        again = lm.fit_opd(np.where(seen, opd, np.nan), **options, obscuration=obscuration)
        assert "left_out" not in again.findings.codes


def test_a_mask_of_the_residual_has_the_strehl_ratio_of_the_map():
    opd, x, y = sampled((64, 64), (31.5, 31.5), 32.0, 0.6)
    seen = np.isfinite(opd) & (np.hypot(x, y) > 0.3)
    exact = opd + 0.06 * np.cos(2 * np.pi * 5 * x)
    fit = lm.fit_opd(np.where(seen, exact, np.nan), unit="waves", degree=4)
    phase = 2 * np.pi * np.nan_to_num(fit.residual)
    found = float(lm.strehl(lm.Pupil(fit.wavefront, mask=lm.Mask(np.where(seen, np.exp(1j * phase), 0.0)))))
    assert found == pytest.approx(abs(np.exp(2j * np.pi * exact[seen]).mean()) ** 2, rel=0.02)
    assert float(lm.strehl(lm.Pupil(fit.wavefront))) > 1.08 * found


def test_the_worst_of_maps_without_samples_in_areas_is_named():
    opd, x, y = sampled((48, 48), (23.5, 23.5), 24.0)
    stack = np.stack([np.where(np.hypot(x, y) < hole, np.nan, opd) for hole in (0.0, 0.3, 0.5, 0.4)])
    finding = lm.fit_opd(stack, unit="waves", degree=4, center=(23.5, 23.5), radius=24.0).findings.get("left_out")
    assert finding.numbers["obscuration"] == pytest.approx(0.5, abs=0.03)
    assert finding.text.endswith("pass obscuration=0.5")


def test_a_stated_centre_that_is_not_that_of_the_samples_is_doubted():
    opd, _, _ = sampled((64, 64), (29.0, 33.5), 29.0)
    assert coefficients_are_right(lm.fit_opd(opd, unit="waves", degree=4, center=(29.0, 33.5), radius=29.0))
    fit = lm.fit_opd(opd, unit="waves", degree=4, center=(33.5, 29.0), radius=29.0)
    assert fit.findings.get("contradiction").severity == "doubt"
    assert not coefficients_are_right(fit, 0.01)


@pytest.mark.parametrize("noise", [0.0, 0.02, 0.08])
def test_wrapped_maps_are_refused_by_their_jumps_and_unwrapped_ones_are_not(noise):
    opd, x, _ = sampled((48, 48), (23.5, 23.5), 24.0, 2.0)
    opd = opd + noise * np.random.default_rng(3).normal(size=opd.shape)
    for vane in (0.0, 0.06):
        seen = np.where(np.abs(x - 0.3) < vane, np.nan, opd)
        for unit, size in (("waves", 1.0), ("radians", 2 * np.pi)):
            wrapped = lm.fit_opd(size * (seen - np.rint(seen)), unit=unit, degree=4)
            assert wrapped.status == "other_explanation"
            assert "other_explanation" not in lm.fit_opd(size * seen, unit=unit, degree=4).findings.codes
        # A side behind a vane one wave higher, and one of 0.6 waves, which is no error of unwrapping.
        if vane:
            assert lm.fit_opd(seen + (x > 0.3), unit="waves").status == "other_explanation"
            assert "other_explanation" not in lm.fit_opd(seen + 0.6 * (x > 0.3), unit="waves").findings.codes


def test_steps_of_segments_and_steep_maps_are_no_errors_of_unwrapping():
    opd, x, y = sampled((48, 48), (23.5, 23.5), 24.0)
    segment = (np.floor(2 * x + 2) + 4 * np.floor(2 * y + 2)).astype(int).clip(0, 15)
    for seed in range(6):
        draw = np.random.default_rng(seed)
        values = opd + draw.normal(scale=0.7, size=16)[segment] + 0.02 * draw.normal(size=opd.shape)
        assert "other_explanation" not in lm.fit_opd(values, unit="waves", degree=4).findings.codes
    assert lm.fit_opd(opd + 30 * x, unit="waves", degree=4).findings == ()


def test_a_missing_degree_is_named_with_what_it_moves_and_no_pixel_is_an_outlier():
    opd, x, y = sampled((64, 64), (31.5, 31.5), 32.0)
    rho2 = x * x + y * y
    trefoil = math.sqrt(12) * (5 * rho2 - 4) * (x**3 - 3 * x * y * y)  # (5, 3), rms 1
    for size, severity in ((0.05, "doubt"), (0.005, "note")):
        fit = lm.fit_opd(opd + size * trefoil, unit="waves", degree=3)
        assert [(one.code, one.severity) for one in fit.findings] == [("misfit", severity)]
        assert fit.findings[0].numbers["degree"] == 5
        assert fit.findings[0].numbers["rms"] == pytest.approx(size, rel=0.02)
        assert fit.findings[0].numbers["strehl"] == pytest.approx(1 - math.exp(-((2 * np.pi * size) ** 2)), rel=0.05)
        assert lm.fit_opd(opd + size * trefoil, unit="waves", degree=5).findings == ()


@pytest.mark.parametrize("sides", [(1, 1), (2, 2), (3, 3), (2, 4)])
def test_groups_of_pixels_that_jump_are_outliers(sides):
    opd, _, _ = sampled((64, 64), (31.5, 31.5), 32.0)
    opd += 0.002 * np.random.default_rng(1).normal(size=opd.shape)
    opd[20 : 20 + sides[0], 30 : 30 + sides[1]] += (
        1.0 if sides <= (2, 2) else 0.7
    )  # longer jumps of a wave are an error
    finding = lm.fit_opd(opd, unit="waves").findings.get("outliers")
    assert finding.severity == "doubt"
    assert finding.numbers["pixels"] == math.prod(sides)


@pytest.mark.parametrize("digits", [5, 7])
def test_rounding_structure_and_edges_of_steps_are_no_outliers(digits):
    opd, x, y = sampled((64, 64), (32, 32), 31.0)
    rho2 = x * x + y * y
    spherical = np.where(
        rho2 <= 1, 0.05 * (2 * rho2 - 1) + 0.12 * (6 * rho2**2 - 6 * rho2 + 1), np.nan
    )  # values of several decades
    listing = np.array([float(f"{value:.{digits - 1}e}") for value in spherical.ravel()]).reshape(opd.shape)
    assert lm.fit_opd(listing, unit="waves").findings.codes == ("estimated",)
    noise = 0.002 * np.random.default_rng(1).normal(size=opd.shape)
    bump = 0.2 * np.exp(-((x - 0.1) ** 2 + (y - 0.2) ** 2) / 0.02)  # 7 pixels at half its height
    for change in (0.1 * np.cos(2 * np.pi * 5 * x), 0.4 * (x > 0.2), bump):
        assert "outliers" not in lm.fit_opd(opd + noise + change, unit="waves").findings.codes


def smoothed_noise(side: int, width: float, seed: int) -> np.ndarray:
    """Noise of rms 1 after circular convolution with a Gaussian of `width` pixels."""
    k = np.fft.fftfreq(side)
    transfer = np.exp(-2 * (np.pi * width) ** 2 * (k[:, None] ** 2 + k**2))
    noise = np.fft.ifft2(np.fft.fft2(np.random.default_rng(seed).normal(size=(side, side))) * transfer).real
    return noise / noise.std()


@pytest.mark.parametrize(("ripple", "noise"), [(0.06, 0.0), (0.06, 0.02), (0.02, 0.1), (0.3, 0.0)])
@pytest.mark.parametrize("turned", [False, True])
def test_structure_that_no_term_has_is_a_doubt_with_what_it_takes_from_the_strehl_ratio(ripple, noise, turned):
    opd, x, y = sampled((64, 64), (31.5, 31.5), 32.0, 0.6)
    exact = opd + ripple * np.cos(2 * np.pi * 5 * (y if turned else x))
    inside = np.isfinite(opd)
    strehl = [abs(np.exp(2j * np.pi * one[inside]).mean()) ** 2 for one in (opd, exact)]
    values = exact + noise * np.random.default_rng(2).normal(size=opd.shape)
    unit, size = ("radians", 2 * np.pi) if turned else ("waves", 1.0)
    finding = lm.fit_opd(size * values, unit=unit).findings.get("misfit")
    lost = 1 - strehl[1] / strehl[0]
    if lost < 0.01:
        assert finding is None
    else:
        assert finding.severity == "doubt"
        assert finding.numbers["strehl"] == pytest.approx(lost, rel=0.1)
        assert f"by about {100 * finding.numbers['strehl']:.1f} %" in finding.text


@pytest.mark.parametrize(
    ("side", "rms", "width"),
    [
        (16, 0.05, 0.0),
        (32, 0.2, 0.0),
        (64, 0.01, 0.0),
        (64, 0.1, 0.0),
        (64, 0.4, 0.0),
        (64, 0.01, 2.0),
        (64, 0.01, 4.0),
    ],
)
def test_noise_that_is_white_or_small_is_no_structure(side, rms, width):
    opd, _, _ = sampled((side, side), ((side - 1) / 2, (side - 1) / 2), side / 2)
    stack = np.stack([opd + rms * smoothed_noise(side, width, seed) for seed in range(4)])
    options = {"unit": "waves", "degree": 6, "radius": side / 2, "center": ((side - 1) / 2, (side - 1) / 2)}
    if rms < 0.3:  # more noise wraps
        assert lm.fit_opd(stack, **options).reliable
    lost = [opd_residual._structure(2 * np.pi * (one - opd)) for one in stack]
    assert max(lost) < 0.01
    assert (max(lost) > 0.0) == (width > 0.0)
    large = np.where(np.isfinite(opd), 5 * smoothed_noise(side, width, 0), np.nan)  # phases at random
    assert width or opd_residual._structure(large) == 0.0


def test_structure_needs_pairs_of_neighbours():
    phase = np.random.default_rng(1).normal(size=(40, 40))
    phase[1::2] = np.nan
    phase[:, 1::2] = np.nan
    assert opd_residual._structure(phase) == 0.0


@pytest.mark.parametrize(("smoothed", "lowest", "highest"), [(0.0, 0.85, 1.15), (2.0, 0.6, 1.1)])
def test_standard_errors_are_the_scatter_of_repeated_fits(smoothed, lowest, highest):
    opd, x, y = sampled((48, 48), (23.5, 23.5), 24.0)
    opd[np.hypot(x, y) < 0.3] = np.nan
    noise = np.random.default_rng(7).normal(size=(60, 48, 48))
    if smoothed:  # circular convolution with a Gaussian of 2 pixels
        k = np.fft.fftfreq(48)
        noise = np.fft.ifft2(
            np.fft.fft2(noise) * np.exp(-2 * (np.pi * smoothed) ** 2 * (k[:, None] ** 2 + k**2))
        ).real
    fit = lm.fit_opd(opd + 0.01 * noise, unit="waves", degree=6)
    scatter = np.array([values.std(ddof=1) for values in fit.coefficients.values()])
    errors = np.array([np.sqrt(np.mean(values**2)) for values in fit.errors.values()])
    assert lowest < math.sqrt(np.mean((scatter / errors) ** 2)) < highest
    variances = np.diagonal(fit.covariance, axis1=1, axis2=2)
    np.testing.assert_allclose(np.sqrt(variances).T, list(fit.errors.values()))
    whole = np.cov(np.array(list(fit.coefficients.values())))
    if not smoothed:  # a hole correlates defocus and spherical aberration
        a, b = (list(fit.coefficients).index(term) for term in ((2, 0), (4, 0)))
        assert fit.covariance[:, a, b].mean() == pytest.approx(whole[a, b], abs=0.4 * errors[a] * errors[b])
        assert abs(whole[a, b]) > 0.4 * errors[a] * errors[b]
