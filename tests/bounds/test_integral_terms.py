"""Terms of the bounds of integrals over the pupil of a microscope, a second time: docs/certificate.md, 14 to 16."""

from __future__ import annotations

import math

import numpy as np
import pytest

from lommel.optics.layers import debye, projection
from lommel.optics.layers.debye import Model
from lommel.optics.layers.stratified import Layers
from objectives import FIVE, OIL

U, ETA = 2.0**-53, np.geomspace(4e-3, 2.5, 28)
LAYERS = Layers(1.45, 1.518, 1.5255, 1.33, (), (), 520e-9, (0.3, 0.2))
DEPTH, FOCUS = np.array([0.2e-6, 1e-6]), np.array([-0.3e-6, 1.5e-6])
KINDS = ("vectorial", "scalar", "radial", "azimuthal", "vortex")
SIZES = tuple(FIVE.amplitudes().items())


def largest(disc):
    return np.abs(disc.centre) + disc.radius


def sizes_on_discs(piece, model):
    """Return the logarithm of what bounds all parts on each disc."""
    points = piece.covered()
    t_s, t_p, _ = points.amplitudes
    c_i, c_s, g = points(LAYERS.immersion), points(LAYERS.sample), LAYERS.apodization(points.square)
    sine = np.sqrt(largest(points.square)) / LAYERS.sample
    parts = {
        "scalar": 2.0,
        "azimuthal": 2.0 * largest(t_s),
        "radial": 2.0 * np.maximum(largest(t_p * c_s), largest(t_p) * sine),
    }
    with np.errstate(all="ignore"):
        size = parts.get(model.kind, np.maximum(largest(t_s) + largest(t_p * c_s), largest(t_p) * sine))
        size = size * largest(piece.jacobian(points.x)) / np.sqrt(np.abs(c_i.centre) - c_i.radius)
        return np.log(size * np.exp(g.radius - g.centre.real))


@pytest.mark.parametrize("kind", KINDS)
def test_integrands_grow_on_each_ellipse_as_their_factors_do(kind):
    model, v, extra = Model(kind), 7.0, np.linspace(0.0, 1.0, 1024)
    for piece in debye.pieces(LAYERS, model):
        root = np.sqrt(piece.covered().square.centre) / LAYERS.NA
        radius = piece.covered().square.radius / LAYERS.NA**2
        if isinstance(piece, debye.Centre):
            height = np.abs(piece.covered().x.centre.imag) + piece.covered().x.radius
        else:
            height = np.minimum(np.hypot(root.imag, np.sqrt(radius)), np.abs(root.imag) + radius / np.abs(root))
        np.testing.assert_allclose(piece.covered().height, height, rtol=1e-6, atol=1e-12)
        rates, waves = piece.covered().rates, []
        for d, f in zip(DEPTH, FOCUS, strict=True):
            phase = sum(w * rate.centre.imag for w, rate in zip((1, d, f), rates, strict=True))
            waves.append(sum(abs(w) * rate.radius for w, rate in zip((1, d, f), rates, strict=True)) - phase)
        with np.errstate(all="ignore"):
            expected = (sizes_on_discs(piece, model) + np.max(waves, axis=0) + v * height + extra).max(axis=1)
        found, analytic = piece.growth(model, DEPTH, FOCUS, v, factor=extra), piece.covered().analytic
        assert analytic.any()
        assert np.isinf(found[~analytic]).all()
        assert found[analytic] == pytest.approx(expected[analytic] + 1e-9, abs=3e-10)


def test_rules_and_slopes_have_the_errors_of_their_nodes_and_of_rounding():
    model, v, tol, d, f = Model(), 12.0, 1e-6, DEPTH, FOCUS
    rule, sections = debye.rule(LAYERS, model, d, f, v, tol), debye.pieces(LAYERS, model)
    size, reach = max(np.abs(part).sum() for part in rule.parts), 1.33 * d.max() + 1.518 * np.abs(f).max()
    rounding = (4 * LAYERS.wavenumber * reach + 4 * v + 2 * math.sqrt(rule.rho.size) + 64) * U * size
    assert (rule.error - tol, rule.rounding) == pytest.approx((rounding, rounding), rel=1e-6, abs=0.0)
    found, expected, steep = debye.slope_errors(rule, LAYERS, model, d, f, v, tol), np.zeros(3), np.zeros(2)
    for piece, n in zip(sections, rule.counts, strict=True):
        growth, points = piece.growth_on_best(model, d, f, v, 0.5 * tol), piece.covered()
        rho = np.sqrt(largest(points.square)) / LAYERS.NA
        factors = [one.max(axis=1) for one in (*map(largest, points.rates[1:]), rho)]
        log = growth + np.log(64 / 15 * 0.5 * (piece.high - piece.low) / (1 - np.exp(-2 * ETA)))
        assert n == max(2, math.ceil(np.min((log - math.log(0.5 * tol)) / (2 * ETA))))
        log = log - 2 * n * ETA
        expected += [np.exp(np.min(log + np.log(one))) for one in factors]
        row = int(np.flatnonzero(points.analytic)[0])
        off = [
            largest(rate - least)[row].max()
            for rate, least in zip(points.rates[1:], LAYERS.middle_rates(), strict=True)
        ]
        steep = np.maximum(steep, off)
    most = [*(np.abs(rate).max() for rate in rule.rates[1:]), 1.0]
    assert found == pytest.approx(expected + rounding * np.array(most), rel=1e-9, abs=0.0)
    assert debye.steepest(LAYERS, model) == pytest.approx(steep, rel=1e-9, abs=0.0)


@pytest.mark.parametrize("error", [1e-3, 1e-8])
def test_orders_of_a_wavefront_are_the_fewest_that_are_proven_to_suffice(error):
    b = np.geomspace(1e-2, 6.0, 200)
    strip = sum(w * np.sinh(m * b) for (_, m), w in SIZES)
    left = [2 * np.exp(np.min(strip - (m + 1) * b - np.log(1 - np.exp(-b)))) for m in range(80)]
    most = next(m for m in range(80) if left[m] <= 0.5 * error)
    assert projection.orders(SIZES, error) == pytest.approx(
        (most, 2 * most + 2, left[most] + left[most + 1]), rel=1e-9
    )
    assert projection.orders(SIZES, 2.0 * left[most])[0] == most
    layers = OIL._layers(520e-9)
    rule = debye.rule(layers, Model(), DEPTH, FOCUS, 3.0, 1e-4)
    found, off = projection.components(FIVE, SIZES, rule, error)
    size = max(np.abs(part).sum() for part in rule.parts)
    fourier = projection.orders(SIZES, 0.01 * error / size)
    all_orders = np.abs(projection.samples(FIVE, rule.rho, fourier))[0]
    each = np.array([[(np.abs(part) * one).sum() for part in rule.parts] for one in all_orders]).max(axis=1)
    pairs = [each[fourier.most - m] + each[fourier.most + m] for m in range(fourier.most + 1)]
    most = next(m for m in range(fourier.most + 1) if sum(pairs[m + 1 :]) <= error)
    assert found.shape[1] == 2 * most + 1
    assert off == pytest.approx(sum(pairs[most + 1 :]) + fourier.error * size, rel=1e-9, abs=0.0)


def test_series_of_amplitudes_have_the_errors_of_all_integrals(monkeypatch):
    degree, asked, rule = 12, [], debye.rule
    pupil = OIL.pupil(depth=0.5e-6, z=[0.0, 3e-7], wavelength=520e-9, origin="coverslip")

    def recorded(*given):
        asked.append(given)
        return rule(*given)

    monkeypatch.setattr(debye, "rule", recorded)
    projection._integrals.cache_clear()
    made = projection.amplitudes(pupil, degree, 1e-5)
    tol = 2.0 ** math.floor(math.log2(1e-5 / (degree + 2)))
    layers, model, d, f, v, told, factor = asked[0]
    assert (v, told) == (0.0, tol)
    rounding = rule(layers, model, d, f, v, tol, factor).rounding
    assert made.error == pytest.approx((degree + 2) * tol + 4 * rounding, rel=1e-12, abs=0.0)
    for piece in debye.pieces(layers, model):
        z, r = piece.covered().square.centre / layers.NA**2, piece.covered().square.radius / layers.NA**2
        size, steep = np.abs(z) + np.abs(z - 1.0) + 2.0 * r, debye.steepest(layers, model)
        rates = zip(piece.covered().rates[1:], layers.middle_rates(), steep, strict=True)
        most = np.maximum(1.0, np.max([largest(rate - least) / top for rate, least, top in rates], axis=0))
        expected = np.log(most * (degree + 4)) + 0.5 * (degree + 3) * np.arccosh(np.maximum(size, 1.0))
        with np.errstate(all="ignore"):
            np.testing.assert_allclose(factor(piece), expected, rtol=1e-6)


def test_fields_of_an_objective_have_the_error_of_the_farthest_radius():
    given = {"depth": 0.5e-6, "focus": [0.0, 1e-6], "wavelength": 520e-9}
    made, layers = OIL.fields([0.0, 2e-6, 1e-7], tol=1e-6, **given), OIL._layers(520e-9)
    v, f = 2e-6 * layers.wavenumber * 1.4, np.array([0.0, 1e-6])
    assert made.error == debye.rule(layers, Model(), np.full(2, 0.5e-6), f, v, 1e-6).error
    light = np.abs(made.K0) ** 2 + 2.0 * np.abs(made.K1) ** 2 + np.abs(made.K2) ** 2
    assert made.intensity_error == pytest.approx(
        4 * made.error * np.sqrt(light) + 4 * made.error**2, rel=1e-9, abs=0.0
    )
    for tol, refused in ((1e-14, False), (0.99, False), (0.99e-14, True), (1.0, True)):
        if refused:
            with pytest.raises(ValueError, match="tol must be"):
                OIL.fields(0.0, tol=tol, **given)
        else:
            assert OIL.fields(0.0, tol=tol, **given).error >= tol
    assert OIL.fields(0.0, **given).error == pytest.approx(1e-10, rel=1e-3, abs=0.0)
    with pytest.raises(ValueError, match=r"at most 190 um, where .*, got 300 um"):
        OIL.fields(0.0, depth=0.0, focus=[3e-4, 0.0], wavelength=520e-9)
