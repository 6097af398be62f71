"""Averages over pixels wide against the rings: their bound, and that of the light left out with the rings."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from scipy.special import j0

import lommel as lm
from core_tests import _core_tests
from lommel import _core
from lommel.core.engine import filters_pay
from lommel.methods import NijboerZernike
from lommel.methods.nijboer_zernike import radial_stack, window_of
from lommel.optics.grid import Grid

# Panels of I along the radius, each 4 wide in v.
NODES = np.polynomial.chebyshev.chebpts1(26)


def profile(pupil: lm.Pupil, reach: float):
    """Return I by quadrature over the pupil, as a function of v up to a reach."""
    x, w = np.polynomial.legendre.leggauss(int(60 + 0.6 * reach + 2 * np.abs(pupil.coefficients()).sum()))
    low = pupil.obscuration
    rho, w = low + (1 - low) * 0.5 * (x + 1), 0.5 * (1 - low) * w
    t = rho * rho
    phase = sum(c * t ** (k + 1) for k, c in enumerate(pupil.coefficients()[0]))
    light = 2 * rho * w * np.exp(1j * phase - pupil.apodization * t)
    panels = int(reach / 4) + 1
    v = 4 * np.arange(panels)[:, None] + 2 + 2 * NODES
    at = np.array([np.abs(light @ j0(np.outer(rho, row))) ** 2 for row in v])
    series = np.linalg.solve(np.polynomial.chebyshev.chebvander(NODES, NODES.size - 1), at.T)

    def intensity(r: np.ndarray) -> np.ndarray:
        place = np.minimum(panels - 1, (r / 4).astype(int))
        x = r / 2 - 2 * place - 1
        return np.polynomial.chebyshev.chebval(x, series[:, place], tensor=False)

    return intensity


def question(seed: int):
    rng = np.random.default_rng(seed)
    c = rng.uniform(-1, 1, 3) * 10.0 ** rng.uniform(-1, 1.3)
    pupil = lm.Pupil(
        lm.Wavefront(c[0], c[1], [c[2]] if seed % 2 else ()),
        obscuration=(0.0, 0.3, 0.0, 0.7)[seed % 4],
        apodization=(0.0, 0.0, 1.2)[seed % 3],
    )
    step = 8.0 * 10.0 ** rng.uniform(0, 0.9)
    side = int(rng.integers(3, 14))
    centers = (None, (side / 2 - 0.5, side / 2), tuple(side / 2 + rng.uniform(-1, 1, 2)), (-1.3, side / 3))
    return pupil, side, step, centers[seed % 5 % 4], 10.0 ** rng.uniform(-9.5, -2)


def check(found: lm.PSF, pupil: lm.Pupil, step: float, places: list[tuple[int, int]]) -> None:
    """Compare pixels of an image, not divided by its peak, with averages by quadrature."""
    (row, column), (height, width) = found.grid.center, found.values.shape
    x, w = np.polynomial.legendre.leggauss(int(0.9 * step) + 14)
    far = math.hypot(max(row, height - row), max(column, width - column)) + 2.0
    intensity = profile(pupil, step * far)

    def average(down: float, across: float) -> float:
        r = step * np.hypot(down + 0.5 * x[:, None], across + 0.5 * x)
        return float(0.25 * w @ intensity(r.ravel()).reshape(r.shape) @ w)

    inside = [(y, x) for y, x in places if 0 <= y < height and 0 <= x < width]
    exact = np.array([average(y - row, x - column) for y, x in inside]) * float(found.scale)
    peak = max(exact.max(), average(0.0, 0.0) * float(found.scale))
    got = np.array([found.values[place] for place in inside])
    assert np.abs(got - exact).max() <= found.error_bound * peak + 1e-13 * float(found.scale)


OPTIONS = {"dtype": np.float64, "integrate": True, "normalize": "energy"}


@pytest.mark.parametrize("seed", range(40))
def test_averages_over_coarse_pixels_are_within_their_bound(seed):
    pupil, side, step, center, tol = question(seed)
    found = lm.psf(pupil, side, step / math.pi, center=center, method=NijboerZernike(tol), **OPTIONS)
    assert found.error_bound <= tol
    row, column = found.grid.center
    rng = np.random.default_rng(seed)
    beside = [(round(row), round(column)), (round(row), round(column) + 1)]
    check(found, pupil, step, beside + [tuple(place) for place in rng.integers(0, side, (12, 2)).tolist()])


@pytest.mark.parametrize(
    ("side", "step", "center", "defocus", "tol"),
    [
        (90, 8.0, (-180.3, 44.2), 5.0, 1e-6),  # all pixels without rings
        (90, 8.0, (40.3, 44.8), 5.0, 1e-6),
        (150, 8.0, (75.3, 74.8), 5.0, 1e-6),  # samples take less
        (90, 11.0, (-3.3, 44.8), 30.0, 1e-8),
        (80, 16.0, (40.3, 39.8), 5.0, 1e-7),
        (80, 5.0, (40.3, 39.8), 60.0, 1e-9),  # no weights are as exact
        (33, 6.0, (16.3, 15.8), 60.0, 1e-9),
        (33, 6.0, (16.3, 15.8), 5.0, 1e-11),
        (3, 90.0, (1.1, 0.9), 0.3, 1e-2),  # nor does the pixel with the axis have rings
    ],
)
def test_averages_of_many_pixels_are_within_their_bound_and_those_of_a_plan(side, step, center, defocus, tol):
    pupil = lm.Pupil(lm.Wavefront(defocus, -0.1 * defocus))
    options = {"center": center, "method": NijboerZernike(tol), **OPTIONS}
    found = lm.psf(pupil, side, step / math.pi, **options)
    assert found.error_bound <= tol
    places = np.random.default_rng(side).integers(0, side, (9, 2)).tolist()
    nearest = min(max(round(center[0]), 0), side - 1), min(max(round(center[1]), 0), side - 1)
    # Where rings lie along an edge they are averaged least.
    along = [(nearest[0], int(place[1])) for place in places[:4]]
    check(found, pupil, step, [nearest, *along, *(tuple(place) for place in places)])
    plan = lm.Plan(side, step / math.pi, **options)
    plan(lm.Pupil(lm.Wavefront(0.1)))
    assert np.array_equal(plan(pupil).values, found.values)


def test_derivatives_of_many_coarse_pixels_leave_the_values_and_are_those_of_few():
    pupil, options = lm.Pupil(lm.Wavefront(5.0, -0.5)), {"method": NijboerZernike(1e-7), **OPTIONS}
    peak = lm.psf(pupil, 9, 3.0, **options).values.max()  # which bounds are over, about
    for center in ((-30.3, 44.2), (40.3, 44.8)):
        plain = lm.psf(pupil, 80, 3.0, center=center, **options)
        many = lm.psf(pupil, 80, 3.0, center=center, derivatives=("defocus",), **options)
        assert np.array_equal(many.values, plain.values)
        corner = lm.psf(
            pupil, 30, 3.0, center=(center[0] - 10.0, center[1] - 30.0), derivatives=("defocus",), **options
        )
        off = (many.derivative_bounds["defocus"] + corner.derivative_bounds["defocus"]) * peak
        assert np.abs(many.derivatives["defocus"][10:40, 30:60] - corner.derivatives["defocus"]).max() <= off


def test_a_stack_makes_one_table_as_exact_as_its_faintest_image_needs():
    kept = []
    for defocus in (np.linspace(0.0, 50.0, 3), np.full(3, 50.0)):
        lm.clear_caches()
        lm.psf(lm.Pupil(lm.Wavefront(defocus)), 21, 1.5, center=(10.3, 9.8), threads=1, **OPTIONS)
        kept.append(_core.cached_bytes()[0])
    assert kept[0] <= 1.2 * kept[1]


def test_no_table_is_made_that_would_have_to_be_as_exact_as_it_can():
    lm.clear_caches()
    method = NijboerZernike(1e-9)
    lm.psf(lm.Pupil(lm.Wavefront(60.0)), 33, 6.0 / math.pi, center=(16.3, 15.8), method=method, threads=1, **OPTIONS)
    assert _core.cached_bytes()[0] < 1_000_000


@pytest.mark.parametrize(("count", "kept"), [(4, False), (12, True), (400, True)])
def test_a_stack_makes_weights_only_where_it_is_worth_it_and_then_uses_them(count, kept):
    """Weights for pixels of 10 v take eight times as long as the light across edges for some six pupils."""
    lm.clear_caches()
    lm.psf(lm.Pupil(lm.Wavefront(np.linspace(2.0, 6.0, count))), 33, 10.0 / math.pi, threads=1, **OPTIONS)
    assert (_core.cached_bytes()[0] > 250_000) == kept


@pytest.mark.parametrize(
    ("side", "center", "step", "tol", "samples"),
    [
        (300, (150.3, 149.8), 7.5, 1e-6, True),
        (300, (150.3, 149.8), 7.5, 1e-8, False),  # filters would be long
        (300, (150.3, 149.8), 12.0, 1e-6, False),  # samples of a pixel would be many
        (300, (-600.3, 149.8), 7.5, 1e-6, False),  # no pixel has rings
        (300, (150.3, 149.8), 7.0, 1e-6, True),
        (60, (30.3, 29.8), 5.0, 1e-6, False),  # weights for all axes serve
        (60, (30.3, 29.8), 8.0, 1e-6, False),
        (300, (150.5, 149.5), 7.0, 1e-6, False),  # one weight serves eight pixels
        (5, (-600.3, 2.2), 7.0, 1e-6, False),
    ],
)
def test_finer_samples_average_where_nothing_else_takes_less(side, center, step, tol, samples):
    pupil, grid = lm.Pupil(lm.Wavefront(5.0)), Grid(side, step / math.pi, integrate=True, center=center)
    stack, window = radial_stack(pupil), window_of(pupil, grid)
    assert filters_pay(stack, window, tol) == samples
    # Of the light that crosses edges, derivatives take samples where weights would be many.
    light = step > 7.4 and not samples
    assert filters_pay(stack, window, tol, derivatives=True) == (light and side > 70)


@pytest.mark.parametrize("gaussian", [0.0, 1.5])
@pytest.mark.parametrize("obscuration", [0.0, 0.2, 0.6])
@pytest.mark.parametrize("phase", [[0.3], [4.0, -1.5], [-2.0, 0.5, 0.8]])
def test_the_light_beyond_a_circle_is_its_mean_within_the_bound(phase, obscuration, gaussian):
    pupil = lm.Pupil(
        lm.Wavefront.zernike({(2 * j + 2, 0): c for j, c in enumerate(phase)}, unit="radians", normalization="edge"),
        obscuration=obscuration,
        apodization=gaussian,
    )
    low = mp.mpf(obscuration) ** 2
    light = float(mp.quad(lambda t: mp.exp(-2 * gaussian * t), [low, 1]))
    reach = 400.0
    intensity = profile(pupil, reach)
    x, w = np.polynomial.legendre.leggauss(20)
    panels = np.arange(int(reach / 2))[:, None] * 2.0 + 1.0 + x
    inside = np.cumsum((intensity(panels.ravel()).reshape(panels.shape) * panels) @ w)
    shares = []
    for r in np.geomspace(40, reach - 4, 60):
        k = int(r / 2)
        bound = _core_tests.tail_bounds(np.array(phase), np.array([0.0, gaussian]), obscuration, 2.0 * k)
        left = abs(2 * light - inside[k - 1] - bound["mean"] / (2.0 * k))
        most = bound["rings"] + (2.0 * k) ** 2 * bound["curved"]
        assert left <= most + 1e-11
        shares.append(left / most)
    if gaussian == 0.0 and max(map(abs, phase)) < 1:
        assert max(shares) > 0.6


@pytest.mark.parametrize(
    ("phase", "obscuration", "gaussian"),
    [((0.0,), 0.0, 0.0), ((0.8, 0.5), 0.0, 1.5), ((0.8, 0.5), 0.3, 0.0), ((0.8, 0.5), 0.5, 1.5)],
)
def test_what_the_mean_leaves_out_of_the_light_without_its_rings(phase, obscuration, gaussian):
    """A smooth window, in which rings vanish, of I r^3."""
    pupil = lm.Pupil(
        lm.Wavefront.zernike({(2 * j + 2, 0): c for j, c in enumerate(phase)}, unit="radians", normalization="edge"),
        obscuration=obscuration,
        apodization=gaussian,
    )
    x = np.linspace(-1.0, 1.0, 4001)[1:-1]
    r, window = 160.0 + 100.0 * x, np.exp(-1.0 / (1.0 - x * x))
    bounds = [_core_tests.tail_bounds(np.array(phase), np.array([0.0, gaussian]), obscuration, at) for at in r]
    left = window @ (profile(pupil, 261.0)(r) * r**3 - bounds[0]["mean"])
    assert left == pytest.approx(window @ (r**3 * [each["curved"] for each in bounds]), rel=0.01)


def test_coarse_pixels_hold_all_the_light():
    pupil = lm.Pupil(lm.Wavefront.from_seidel(W020=0.6), wavelength=550e-9, f_number=4)
    for pixel in (20e-6, 50e-6, 500e-6):
        found = lm.psf(pupil, 129, pixel, dtype=np.float64)
        # What is beyond a circle falls as its radius: 2 / pi^2 of the light beyond lambda N times r.
        outside = 2 / math.pi**2 * pupil.scale / pixel / 64.5
        assert 1 - 1.3 * outside < found.values.sum() < 1 - 0.8 * outside


@pytest.mark.parametrize(("pixel", "side"), [(1.3, 129), (1.6, 97), (2.0, 65), (2.33, 33)])
@pytest.mark.parametrize("tol", [1e-4, 1e-7])
def test_few_pupils_whose_weights_would_be_many_are_within_their_bound(pixel, side, tol):
    pupil = lm.Pupil(lm.Wavefront(3.0, -1.1), obscuration=0.25)
    found = lm.psf(pupil, side, pixel, center=(side / 2 + 0.3, side / 2 - 0.7), tol=tol, **OPTIONS)
    half = side // 2
    places = [(half, half - 1), (half + 2, half - 3), (half + 7, half + 9), (3, half), (side - 1, 0)]
    check(found, pupil, np.pi * pixel, places)
    assert found.error_bound <= tol


@pytest.mark.parametrize("order", [4, 9, 16, 40, 63])
def test_derivatives_of_the_intensity_are_at_most_what_the_places_in_the_pupil_allow(order):
    # The mean of abs(x)^j over the unit disk, and the sum of their products by Leibniz's rule.
    means = [mp.beta((j + 1) / mp.mpf(2), mp.mpf(3) / 2) * 2 / mp.pi for j in range(order + 1)]
    exact = sum(mp.binomial(order, j) * means[j] * means[order - j] for j in range(order + 1)) / 2**order
    bound = _core_tests.energy_error(order, 1e9)[2]
    assert exact <= bound <= 2.0 * exact
    assert _core_tests.energy_error(order, 1e-9)[2] == 1e-9  # by Bernstein's inequality


@pytest.mark.parametrize("points", [4, 5, 7, 10, 11])
@pytest.mark.parametrize("middle", [1.0, 3.0, 21.0])
def test_the_energy_of_an_interpolated_intensity_is_off_by_less_than_its_bound(points, middle):
    part, whole, _ = _core_tests.energy_error(points, 0.5)
    nodes, closest = np.polynomial.chebyshev.chebpts1(points), 0.0
    fine = np.polynomial.chebyshev.chebpts1(60)
    radii, weights = np.polynomial.legendre.leggauss(40)
    rho, w = 0.5 * (radii + 1), 0.5 * weights
    for phase in (0.0, 3.0, 8.0):
        light = 2.0 * rho * w * np.exp(1j * phase * rho**2)
        values = [np.abs(light @ j0(np.outer(rho, middle + x))) ** 2 for x in (nodes, fine)]
        short, long = (
            np.polynomial.Chebyshev(np.linalg.solve(np.polynomial.chebyshev.chebvander(x, len(x) - 1), v))
            for x, v in zip((nodes, fine), values, strict=True)
        )
        off = ((long - short) * np.polynomial.Chebyshev([middle, 1.0])).integ(lbnd=-1.0)
        largest, last = np.abs(off(np.linspace(-1.0, 1.0, 301))).max(), abs(off(1.0))
        assert largest <= part * (middle + 1.0) + 1e-15
        assert last <= whole * (middle + 1.0) + 1e-15
        closest = max(closest, largest / part)
    assert whole < part
    assert middle > 1.0 or closest > 0.01
