"""Bounds of sections of a pupil, of orders, of closed forms, of traced images and of stacks, a second time."""

from __future__ import annotations

import itertools
import math
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.special import j0

import lommel as lm
from lommel.field.maps import Vignetting
from lommel.methods.paper import closed_form
from lommel.optics.layers import debye, projection
from lommel.optics.layers.debye import ETA, Model
from lommel.paper import Geometric
from lommel.special.disc_arithmetic import Disc
from lommel.traced import certificate
from lommel.traced.namespaces import Namespace
from objectives import OIL

NUMPY = Namespace.of(None)
PUPIL = OIL.pupil(depth=[0.3e-6, 1e-6], z=[0.0, 3e-7], wavelength=520e-9)
DEPTH, FOCUS = PUPIL.depth.ravel(), PUPIL.focus.ravel()
MODELS = [Model(), Model("radial"), Model("azimuthal"), Model("scalar"), Model(aplanatic=False)]


def sections(model):
    return debye.pieces(PUPIL.layers, model)


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.kind)
def test_integrands_on_ellipses_are_below_their_bounds_and_not_far(model):
    """Bounds of moduli, of heights and of waves on discs around arcs, at points of the arcs."""
    for piece in sections(model):
        chosen = (3, 8, 14)
        covered, log = debye.enclosed(piece, model, chosen)
        angles = (np.arange(covered.height.shape[-1]) + 0.5) * 2.0 * math.pi / covered.height.shape[-1]
        points = debye.Points(piece, piece._ellipses(ETA[list(chosen)], angles))
        rows = np.flatnonzero(covered.analytic)
        size = np.log(np.max([np.abs(part) for part in piece.parts(points, model)], axis=0))[rows]
        assert np.all(size <= log[rows] + 1e-9)
        assert np.quantile(log[rows] - size, 0.5) < 0.6
        height = np.abs(
            (points.x if isinstance(piece, debye.Centre) else np.sqrt(points.square) / PUPIL.layers.NA).imag
        )
        assert np.all(height[rows] <= covered.height[rows] * (1.0 + 1e-9))
        if not isinstance(piece, debye.Centre):
            square = covered.square * PUPIL.layers.NA**-2
            root = np.sqrt(square.centre)
            both = [np.hypot(root.imag, np.sqrt(square.radius)), np.abs(root.imag) + square.radius / np.abs(root)]
            assert covered.height == pytest.approx(np.minimum(*both), rel=1e-12)


@pytest.mark.parametrize("error", [1e-3, 1e-10])
def test_nodes_of_a_section_are_the_fewest_for_its_growth(error):
    for piece in sections(Model()):
        growth = piece.growth(Model(), DEPTH, FOCUS, 5.0)
        half = 0.5 * (piece.high - piece.low)
        logs = [
            g + math.log(64.0 / 15.0 * half / (1.0 - math.exp(-2.0 * e))) for g, e in zip(growth, ETA, strict=True)
        ]
        assert piece.constant() + growth == pytest.approx(logs, rel=1e-12)
        fewest = next(
            n for n in range(2, 2000) if min(g - 2 * n * e for g, e in zip(logs, ETA, strict=True)) <= math.log(error)
        )
        assert piece.nodes(growth, error) == fewest
        best = piece.growth_on_best(Model(), DEPTH, FOCUS, 5.0, error)
        finite = np.isfinite(best)
        assert np.allclose(best[finite], growth[finite])
        assert fewest <= piece.nodes(best, error) <= fewest + 2
        # With a factor, as it is on each disc.
        more = piece.growth(Model(), DEPTH, FOCUS, 5.0, factor=1.5)
        assert more[np.isfinite(more)] == pytest.approx(growth[np.isfinite(growth)] + 1.5, rel=1e-9)


def test_growth_is_that_of_moduli_waves_and_heights_on_the_worst_disc():
    for piece in sections(Model()):
        covered, log = debye.enclosed(piece, Model(), None)
        rates = covered.rates
        for row in np.flatnonzero(covered.analytic)[:5]:
            worst = -math.inf
            for k in range(covered.height.shape[-1]):
                wave = -math.inf
                for d, f in itertools.product(sorted(set(DEPTH.tolist())), (FOCUS.min(), FOCUS.max())):
                    if f not in [x for y, x in zip(DEPTH, FOCUS, strict=True) if y == d]:
                        continue
                    centre = rates[0].centre[row, k] + d * rates[1].centre[row, k] + f * rates[2].centre[row, k]
                    spread = rates[0].radius[row, k] + d * rates[1].radius[row, k] + abs(f) * rates[2].radius[row, k]
                    wave = max(wave, spread - centre.imag)
                worst = max(worst, log[row, k] + wave + 3.0 * covered.height[row, k])
            found = piece.growth(Model(), DEPTH, FOCUS, 3.0)[row]
            assert found >= worst
            assert found == pytest.approx(worst + 1e-9, abs=1e-6)


def test_errors_of_derivatives_are_those_of_the_rule_times_their_factors():
    model, tol = Model(), 1e-6
    rule = debye.rule(PUPIL.layers, model, DEPTH, FOCUS, 4.0, tol)
    found = debye.slope_errors(rule, PUPIL.layers, model, DEPTH, FOCUS, 4.0, tol)
    sums = np.zeros(3)
    for piece, n in zip(sections(model), rule.counts, strict=True):
        growth = piece.growth_on_best(model, DEPTH, FOCUS, 4.0, tol / len(rule.counts))
        rows = [int(row) for row in np.flatnonzero(np.isfinite(growth))]
        covered = debye.enclosed(piece, model, tuple(rows))[0]
        rho = np.sqrt(covered.square.largest) / PUPIL.layers.NA
        factors = covered.rates[1].largest, covered.rates[2].largest, rho
        for j, factor in enumerate(factors):
            sums[j] += min(
                math.exp(piece.constant()[row] - 2.0 * n * ETA[row] + growth[row]) * factor[k].max()
                for k, row in enumerate(rows)
            )
    largest = [np.abs(rule.rates[1]).max(), np.abs(rule.rates[2]).max(), 1.0]
    assert found == pytest.approx(sums + rule.rounding * np.array(largest), rel=1e-9)


@pytest.mark.parametrize("error", [1e-2, 1e-9])
@pytest.mark.parametrize("terms", [(((2, 2), 0.7),), (((3, 1), 2.0), ((4, -3), 0.3)), ()])
def test_orders_of_the_azimuth_are_the_fewest_whose_rest_is_small(terms, error):
    heights = projection._HEIGHTS.tolist()

    def rest(most):
        if not any(m for (_, m), _ in terms):
            return 0.0
        strip = [sum(w * math.sinh(abs(m) * b) for (_, m), w in terms) for b in heights]
        logs = (one - (most + 1) * b - math.log(1.0 - math.exp(-b)) for one, b in zip(strip, heights, strict=True))
        return 2.0 * math.exp(min(*logs, 700.0))

    found = projection.orders(tuple(((n, abs(m)), w) for (n, m), w in terms), error)
    most = next(m for m in range(999) if rest(m) <= 0.5 * error)
    assert (found.most, found.angles) == (most, 2 * most + 2)
    assert found.error == pytest.approx(rest(most) + rest(most + 1), rel=1e-9)


@pytest.mark.parametrize("error", [1e-3, 1e-8])
def test_orders_that_are_left_out_at_nodes_add_no_more_than_they_are_said_to(error):
    wavefront = lm.Wavefront.zernike({(2, 2): 0.4, (3, 1): [0.3, -0.5]})
    terms = tuple(((n, abs(m)), w) for (n, m), w in wavefront.amplitudes().items())
    rho, weights = np.polynomial.legendre.leggauss(20)
    rule = SimpleNamespace(rho=0.5 * (rho + 1.0), parts=(0.5 * weights, 0.3 * weights * rho))
    values, left = projection.components(wavefront, terms, rule, error)
    size = max(np.abs(part).sum() for part in rule.parts)
    fourier = projection.orders(terms, 0.01 * error / size)
    full = projection.samples(wavefront, rule.rho, fourier)
    middle, most = fourier.most, values.shape[1] // 2
    bounds = [
        max(
            (np.abs(full[n, middle + m]) + np.abs(full[n, middle - m])) @ np.abs(part) * (0.5 if m == 0 else 1.0)
            for n in range(2)
            for part in rule.parts
        )
        for m in range(middle + 1)
    ]
    rest = list(np.cumsum(np.append(bounds[1:], 0.0)[::-1])[::-1])
    assert most == next(m for m, one in enumerate(rest) if one <= error)
    assert left == pytest.approx(rest[most] + fourier.error * size, rel=0.3)
    assert left <= 1.02 * error
    assert np.array_equal(values, full[:, middle - most : middle + most + 1])


@pytest.mark.parametrize("error", [1e-2, 1e-5])
def test_quadratics_of_the_amplitude_are_as_close_as_their_ratio_is_said_to_make_them(error):
    """The amplitude of sqrt(x) is 0.00196 (ratio - 1)^3 off at most: half of the error, over the field of a disc."""
    coefficients, v = np.array([8.0, 0.0]), np.linspace(0.0, 60.0, 31)
    values, bound = closed_form._field(coefficients, v, error)
    delta = 0.5 * error * math.sqrt(10.0) / 1.1
    ratio = 1.0 + min(0.6, (delta / 0.0026) ** (1.0 / 3.0))
    starts, quadratics = closed_form._hankel_pieces(ratio, 60.0)
    assert starts == pytest.approx(10.0 * ratio ** np.arange(math.ceil(math.log(6.0) / math.log(ratio))))
    amplitude = 1.1 / math.sqrt(10.0) * 0.0026 * (ratio - 1.0) ** 3
    assert amplitude <= 0.5 * error * 1.0001
    assert amplitude == pytest.approx(0.5 * error, rel=1e-3) or ratio == 1.6
    pieces = 1 + starts.size
    fit = closed_form.fit_quadratics(coefficients[:1].tolist(), 1)
    assert bound == pytest.approx(amplitude + fit.bound + 4e-9 + 1e-10 * math.sqrt(pieces), rel=1e-9)
    t, weights = np.polynomial.legendre.leggauss(200)
    rho = 0.5 * (t + 1.0)
    phase = fit.alpha[0] * rho**2 + fit.beta[0] * rho + fit.gamma[0]
    exact = (j0(np.outer(v, rho)) * np.exp(1j * phase) * rho) @ weights
    off = np.abs(values - exact)
    assert off.max() <= bound or np.abs(values - exact.conj()).max() <= bound or off.max() <= 2.0 * bound
    for start, (a, b, c) in zip(starts, quadratics, strict=True):
        x = np.linspace(start, ratio * start, 50)
        fitted = np.real((a + b * x + c * x * x) * np.exp(1j * (x - 0.25 * math.pi))) / x
        assert np.abs(fitted - j0(x)).max() <= 1.1 * 0.0026 * (ratio - 1.0) ** 3 / math.sqrt(start) + 1e-8


@pytest.mark.parametrize("divided", [False, True])
def test_traced_bounds_are_those_of_a_square_over_the_least_peak(divided):
    intensity, error, unit = np.array([[0.2, 1.0], [0.5, 0.3], [0.1, 0.2]]), np.array([1e-3, 2e-3, 1.0]), 2.0**-24
    found = certificate.of_intensity(NUMPY, intensity, error, unit)
    peaks = [1.0, 0.5, 0.2]
    expected = [2 * math.sqrt(p) * e + e * e + 4 * unit * p for p, e in zip(peaks, error, strict=True)]
    assert found == pytest.approx(expected, rel=1e-12)
    over = certificate.over_peak(NUMPY, intensity, found, 1e-7, divided=divided)
    for k, (p, e) in enumerate(zip(peaks, expected, strict=True)):
        ratio = e / (p - e) if p > e else math.inf
        if divided:
            ratio = 2 * ratio / (1 - ratio) if ratio < 0.5 else math.inf
        assert over[k] == pytest.approx((ratio + (1 + ratio) * 1e-7) * 1.001, rel=1e-9)
    half = np.array([[1.0], [1.0]])
    near = certificate.over_peak(NUMPY, half, np.array([0.3332, 0.3335]), 1e-9, divided=True)
    assert np.isfinite(near).tolist() == [True, False]
    assert np.isinf(certificate.over_peak(NUMPY, half, np.array([1.0, math.nan]), 1e-9, divided=divided)).all()


@pytest.mark.parametrize("logarithm", [-3.0, 0.0, 59.9])
def test_an_exponential_is_rounded_up_by_a_thousandth(logarithm):
    found = certificate.exponential(NUMPY, np.array([logarithm, 60.1]))
    assert found.tolist() == [pytest.approx(1.001 * math.exp(logarithm), rel=1e-12), math.inf]


@pytest.mark.parametrize("bounds", [(1e-7, 3e-7), (1e-7, None)])
def test_a_stack_of_apertures_has_the_largest_bound_or_none(bounds, monkeypatch):
    field = lm.FieldMap.from_seidel(20e-3, W131=1.0, wavelength=550e-9, f_number=4.0)
    vignetted = field.seen_through(Vignetting([0.0, 20e-3], [0.0, 0.6], 1.1))
    monkeypatch.setattr(lm.Plan, "__call__", stacked(lm.Plan.__call__, iter(bounds)))
    found = vignetted.psf([0.0, 15e-3], 0.0, 5, 2e-6)
    assert found.error_bound == (None if None in bounds else max(bounds))


def stacked(call, bounds):
    """Give the PSF of each single pupil of a stack the next bound."""

    def bounded(self, pupil, **options):
        made = call(self, pupil, **options)
        if pupil.one_aperture:
            made.__dict__["error_bound"] = next(bounds)
        return made

    return bounded


def test_a_chunked_stack_has_the_largest_of_its_bounds_or_none(tmp_path):
    pupil = lm.Pupil(lm.Wavefront(np.array([0.0, 3.0])))
    stack = lm.psf_to(tmp_path / "a.zarr", pupil, 5, 0.5, chunk=1)
    each = np.asarray(stack.error_bound).ravel()
    assert stack[0:2].error_bound == each.max() > 1.5 * each.min()
    assert stack[1].error_bound == each[1]
    lens = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.25, wavelength=540e-9)
    far = lens.pupil(np.array([1.0, 2.0]))
    without = lm.psf_to(tmp_path / "b.zarr", far, 5, 4e-6, chunk=1, method=Geometric())
    assert (without[0:2].error_bound, without[0:2].pupil) == (None, far)


def test_discs_hold_the_products_quotients_and_roots_of_their_points():
    a, b = Disc(np.array([1.0 + 0.5j]), np.array([0.3])), Disc(np.array([2.0 - 0.2j]), np.array([0.4]))
    turn = np.exp(2j * math.pi * np.arange(12) / 12)
    for p, q in itertools.product(turn, turn):
        x, y = a.centre[0] + 0.3 * p, b.centre[0] + 0.4 * q
        for made, value in ((a * b, x * y), (a + b, x + y), (a - b, x - y), (a.sqrt(), np.sqrt(x))):
            assert abs(value - made.centre[0]) <= made.radius[0] * (1.0 + 1e-12)
    product = a * b
    assert product.radius[0] <= 1.01 * (abs(a.centre[0]) * 0.4 + abs(b.centre[0]) * 0.3 + 0.12)
    assert a.largest[0] == pytest.approx(abs(1.0 + 0.5j) + 0.3, rel=1e-9)
    assert a.least[0] == pytest.approx(abs(1.0 + 0.5j) - 0.3, rel=1e-9)
