"""Terms of the bounds of microscope light, a second time: docs/certificate.md, sections 8 and 16."""

from __future__ import annotations

import itertools
import math
from contextlib import nullcontext
from dataclasses import replace

import numpy as np
import pytest
import scipy

import lommel as lm
from lommel.core.answers import Samples, Wanted
from lommel.methods import LAYERED, METHODS
from lommel.methods.layers import chordal_debye, debye_rings, debye_wolf, samples, scanning, stratified
from lommel.methods.layers.chordal_debye import Growth, Rule
from lommel.methods.layers.debye_wolf import refine_until
from lommel.methods.layers.samples import SampledLight
from lommel.methods.layers.scanning import Orders, Table
from lommel.methods.method import stored
from lommel.optics.grid import Grid
from lommel.optics.layers import projection
from lommel.optics.layers.emitter import Harmonic
from objectives import FIVE, OIL

U = 2.0**-53
ETAS = np.geomspace(0.02, 12.0, 96)
ETA = ETAS.tolist()
B = np.geomspace(0.03, 2.7, 64).tolist()
PUPIL = OIL.pupil(depth=0.5e-6, z=[0.0, 3e-7], wavelength=520e-9, aberrations=FIVE)


def least(terms):
    return min(terms, default=math.inf)


def gauss(growth, nodes):
    return least(
        4.0 * math.exp(g - (2 * nodes - 1) * e) / math.expm1(e) for g, e in zip(growth, ETA, strict=True) if g < 600
    )


def circle(radius, angles):
    logs = [(2.0 * radius * math.sinh(e), e) for e in ETA]
    return least(math.exp(g - angles * e) / (1.0 - math.exp(-angles * e)) for g, e in logs if g < 600)


@pytest.mark.parametrize("radius", [0.3, 4.0, 15.0])
@pytest.mark.parametrize("error", [1e-2, 1e-8])
def test_points_of_a_disc_are_the_fewest_for_half_of_the_error_each(radius, error):
    (x, y), w = samples._points(radius, error)
    angles = next(n for n in range(2, 999, 2) if circle(radius, n) <= 0.5 * error)
    growth = [2.0 * radius * math.sinh(0.5 * e) - math.log(2.0) for e in ETA]
    radii = next(n for n in range(1, 999) if gauss(growth, n) <= 0.5 * error)
    assert x.size == y.size == w.size == radii * angles // 2
    assert samples._points(radius, 2.0 * samples._circle_error(radius, 30))[0].shape[1] % 15 == 0
    assert samples._points(0.0, 2.0 * samples.gauss_error(0.0 * ETAS - math.log(2.0), 3))[0].shape == (2, 9)
    assert w.sum() == pytest.approx(1.0)
    assert samples.gauss_error(np.array(growth), radii) == pytest.approx(gauss(growth, radii), rel=1e-9, abs=0.0)
    assert samples._circle_error(radius, angles) == pytest.approx(circle(radius, angles), rel=1e-9, abs=0.0)
    # J1(2 R w) / (R w): the mean of exp(2 i w x) over the disc; halves of a disc have the cosine.
    for frequency in (0.7, 1.0):
        exact = 1.0 if radius == 0 else 2.0 * scipy.special.j1(2.0 * frequency * radius) / (2.0 * frequency * radius)
        assert abs((w * np.cos(2.0 * frequency * x)).sum() - exact) <= error


@pytest.mark.parametrize("error", [0.3, 1e-4, 1e-10])
def test_a_table_is_as_fine_as_its_error_asks(error):
    omega = math.prod((k + 0.5) ** 2 for k in range(6)) / math.factorial(12)
    step = samples.table_step(error)
    # cos(2 v) / 2 is the worst intensity: derivatives of order 12 of 2^11.
    assert step == 0.5 or omega * step**12 * 2.0**11 == pytest.approx(error, rel=1e-9, abs=0.0)
    x = step * (np.arange(40) - 3.0)
    start, weights = samples.between(np.linspace(10.0, 11.0, 41))
    found = (weights * (0.5 * np.cos(2.0 * x))[start[:, None] + np.arange(12)]).sum(axis=1)
    missed = np.abs(found - 0.5 * np.cos(2.0 * step * (np.linspace(10.0, 11.0, 41) - 3.0))).max()
    assert missed <= error
    assert samples.growth() == pytest.approx(np.abs(weights).sum(axis=1).max(), rel=1e-12, abs=0.0)


def test_means_over_discs_have_the_error_and_the_gain_of_their_rule():
    made = samples.disc_means(np.array([0.0, 2.0, 9.0]), 3.0, 1e-5, 1)
    assert made.error == 1e-5 + 2.0**-46
    step = samples.table_step(1e-5 / 3.0)
    (x, y), w = samples._points(3.0, 1e-5 / 1.5)
    gains = []
    for v in (0.0, 2.0, 9.0):
        weights = samples.between(np.hypot(v + x, y) / step)[1]
        gains.append(sum(a * np.abs(b).sum() for a, b in zip(w, weights, strict=True)))
    assert made.gain == pytest.approx(max(gains), rel=1e-12, abs=0.0)
    assert made.places == pytest.approx(step * np.rint(made.places / step))
    means = made.of(0.5 + 0.5 * np.cos(2.0 * made.places)[None, None])
    points = 0.5 + 0.5 * np.cos(2.0 * np.hypot(np.array([[0.0], [2.0], [9.0]]) + x, y))
    assert np.abs(means[0, 0] - points @ w).max() <= 1e-5


def test_products_of_light_add_their_errors_times_what_is_largest():
    a = SampledLight(np.array([[[1.0, -2.0]], [[0.5, 0.1]]]), np.array([1e-15, 2e-15]))
    b = SampledLight(np.array([[[3.0, 1.0]], [[0.2, 4.0]]]), np.array([2e-15, 3e-15]))
    eps = 2.0**-50
    expected = [1e-15 * 3 + 2e-15 * 2 + eps * 6, 2e-15 * 4 + 3e-15 * 0.5 + eps * 2]
    assert a.times(b).error == pytest.approx(expected, rel=1e-13, abs=0.0)
    assert a.times(b).values.tolist() == [[[3.0, -2.0]], [[0.1, 0.4]]]
    factor = np.array([-2.0, 3.0])
    assert a.times(factor).error == pytest.approx([2e-15, 6e-15], rel=1e-12, abs=0.0)
    assert a.times(factor).values[:, 0, 0].tolist() == [-2.0, 1.5]
    orders = [Orders(np.moveaxis(one.values, 1, 1), one.error) for one in (a, b)]
    assert scanning.product(*orders).error == pytest.approx(expected, rel=1e-13, abs=0.0)
    assert orders[0].largest.tolist() == [2.0, 0.5]
    assert orders[0].times(np.array([2.0, 3.0])).error == pytest.approx([2e-15, 6e-15], rel=1e-12, abs=0.0)
    three = Orders(np.array([[[1j], [2.0], [-1j]]]), np.array([1e-3]))
    assert three.largest.tolist() == [4.0]
    assert scanning.product(three, three).values[0, :, 0].tolist() == [-1.0, 4j, 6.0, -4j, -1.0]


def test_light_without_the_rest_of_a_wavefront_is_off_by_twice_its_field(monkeypatch):
    made = Samples(np.ones((2, 3, 3)), np.ones(2), np.array([1e-3, 2e-3]), None, np.array([0.5, 0.25]))
    asked = []
    monkeypatch.setattr(samples, "candidates", lambda pupil, grid, tol: asked.append(tol) or [tol])
    monkeypatch.setattr(samples, "first_within_tolerance", lambda methods, compute: (methods[0], made))
    pupil = replace(PUPIL, aberrations=lm.Wavefront.zernike({(2, 2): 0.3}, error=1e-3))
    left = pupil.left_out[0]
    assert left > 0.0
    bright = made.brightest
    expected = made.error * bright + left * (2.0 * np.sqrt(bright) + left)
    for tol in (1e-6, 0.0):
        assert samples.light_samples(pupil, Grid(3, 1e-7), tol).error == pytest.approx(expected, rel=1e-12, abs=0.0)
    assert asked == [1e-6, 1e-12]


@pytest.mark.parametrize("error", [1e-2, 1e-6, 0.0])
def test_a_filter_has_as_few_weights_as_are_within_the_error(error):
    side, response = 3, lambda w: np.sinc(0.7 / math.pi * w)
    while (fit := samples.fit_taps(response, np.cos, 0.5 * np.arange(side + 1)))[1] > error and side < 63:
        side += max(2, side // 16)
    weights, off, gain = samples._response(3, 0.5, error, 0.7, mean=True)
    assert (weights.size, off, gain) == (side + 1, *fit[1:])
    assert samples._response(3, 0.5, off, 0.7, mean=True)[0].size == weights.size or error == 0.0


@pytest.mark.parametrize(("step", "radius", "error"), [(0.6, 1.0, 1e-3), (1.4, 2.5, 1e-6)])
def test_a_filter_of_a_disc_sums_the_errors_of_its_chords(step, radius, error):
    made = samples.disc_filter(step, radius, error)
    chords = chordal_debye.chords_for(radius, 0.5 * error)
    assert len(made.parts) == chords // 2
    stride = made.taps.stride
    side, total, gain = max(0, stride // 2 + 2, math.ceil(radius * stride / step) + 2), 0.5 * error, 0.0
    for k in range(1, chords // 2 + 1):
        angle = math.pi * k / (chords + 1)
        weight = 4.0 / (chords + 1) * math.sin(angle) ** 2
        across = samples._response(side, step / stride, error / 8.0, radius * math.cos(angle), mean=False)
        down = samples._response(side, step / stride, error / 8.0, radius * math.sin(angle), mean=True)
        total += weight * ((1.0 + down[1]) * (1.0 + across[1]) - 1.0)
        gain += weight * across[2] * down[2]
        side = max(side, across[0].size, down[0].size)
    assert made.error == pytest.approx(total, rel=1e-9, abs=0.0)
    assert made.gain == pytest.approx(gain, rel=1e-12, abs=0.0)
    assert made.error <= error
    light = SampledLight(np.full((1, *(2 * [made.taps.weights.size + 4])), 0.5), np.array([1e-14]))
    rounding = (4.0 * made.taps.weights.size + len(made.parts) + 16.0) * U * 0.5
    assert made.of(light).error == pytest.approx([made.error], rel=1e-6)
    exact = made._replace(error=1e-14)
    assert exact.of(light).error == pytest.approx([1e-14 + made.gain * (1e-14 + rounding)], rel=1e-12, abs=0.0)
    assert made.of(light).values[0, 2, 2] == pytest.approx(0.5, abs=made.error)


def chord(radius, chords):
    total = []
    for b in np.geomspace(0.02, 6.0, 96):
        size = math.exp(min(2 * radius * math.sinh(b) - 2 * chords * b, 600.0))
        total.append((1 + math.exp(-4 * b)) * size / (1 - math.exp(-2 * (chords + 1) * b)))
    return min(total)


@pytest.mark.parametrize("radius", [0.2, 3.0, 9.0])
@pytest.mark.parametrize("error", [1e-2, 1e-9])
def test_chords_of_a_disc_are_the_fewest_even_number(radius, error):
    expected = next(n for n in range(2, 202, 2) if chord(radius, n) <= error)
    assert chordal_debye.chords_for(radius, error) == expected
    assert chordal_debye.chords_for(radius, chordal_debye.chord_error(radius, 40)) == 40
    assert chordal_debye.chord_error(radius, expected) == pytest.approx(chord(radius, expected), rel=1e-9, abs=0.0)


@pytest.mark.parametrize("shift", [-1e-3, 0.0, 1e-3])
def test_intensities_are_refined_until_the_error_over_the_least_peak_suffices(shift):
    """The last accuracy is the first at which e / (peak - e) is at most the target."""
    asked = []

    def compute(accuracy):
        asked.append(accuracy)
        return np.array([[0.2, 1.0], [0.5, 0.1]]), np.array([accuracy, 2.0 * accuracy])

    target = 2.0 * 1e-4 / (0.5 - 2.0 * 1e-4) * (1.0 + shift)
    made = refine_until(compute, target, start=1e-4, floor=1e-9, tol=1e-3)
    assert len(asked) == (1 if shift >= 0 else 2)
    if shift < 0:
        worst = 2e-4 / (0.5 - 2e-4)
        assert asked[1] == pytest.approx(1e-4 * max(1e-4, min(0.5, 0.5 * target / worst)), rel=1e-12, abs=0.0)
    error = np.array([1.0, 2.0]) * asked[-1]
    peak = np.array([1.0, 0.5]) - error
    assert made.peak == pytest.approx(peak, rel=1e-14, abs=0.0)
    assert made.error == pytest.approx(error / peak, rel=1e-14, abs=0.0)
    asked.clear()
    with pytest.raises(lm.ToleranceError):  # where the error is as large as the peak
        refine_until(
            lambda a: (np.ones((1, 1)), np.ones(1) + 0.0 * compute(a)[1][:1]), 1e-3, start=1e-2, floor=1e-9, tol=1
        )
    assert asked == pytest.approx([1e-2, 1e-6, 1e-9], rel=1e-12, abs=0.0)


def test_a_table_of_radii_reaches_beyond_all_pixels_and_grows_errors_as_between_does():
    radius = np.array([0.2, 3.0, 7.7])
    made = Table.for_pixels(radius, 1e-6, 1.5)
    assert made.step == pytest.approx(samples.table_step(1e-6) / 1.5)
    first, last = math.floor(0.2 / made.step), math.floor(7.7 / made.step)
    assert (made.positions[0], made.positions[-1]) == (first - 5, last + 6)
    orders = Orders(np.array([[[1.0, 3.0]]]), np.array([1e-14]))
    assert made.error(orders) == pytest.approx(
        [samples.growth() * (1e-14 + 8.0 * 2.0**-50 * 3.0)], rel=1e-12, abs=0.0
    )


@pytest.mark.parametrize("diameter", [1e-7, 6e-7])
def test_heights_of_a_bead_are_the_fewest_that_do(diameter):
    pupil = OIL.pupil(depth=1e-6, wavelength=520e-9)
    layers, radius = pupil.layers, 0.5 * diameter
    ratio = layers.NA / layers.sample
    cosine, kappa = 1.0 - math.sqrt(max(1.0 - ratio**2, 0.0)), math.sqrt(max(ratio**2 - 1.0, 0.0))
    k = layers.wavenumber
    growth = [
        radius * k * math.hypot(2.0 * layers.NA, layers.sample * cosine) * math.sinh(e)
        + 2.0 * radius * k * layers.sample * kappa * math.cosh(e)
        for e in ETA
    ]
    bead = scanning.Bead(diameter)
    assert bead._growth(pupil) == pytest.approx(growth, rel=1e-12, abs=0.0)
    for error in (1e-3, 1e-9):
        heights, weights, bound = scanning._height_rule(np.array(growth), error)
        count = next(n for n in range(2, 200) if 2.0 * gauss(growth, n) <= error)
        assert heights.size == count
        assert bound == pytest.approx(2.0 * gauss(growth, count), rel=1e-9, abs=0.0)
        assert scanning._height_rule(np.array(growth), bound)[0].size == count
        assert weights.sum() == pytest.approx(1.0)
        assert (weights * heights**2).sum() == pytest.approx(0.2)


@pytest.mark.parametrize("saturation", [0.5, 30.0])
@pytest.mark.parametrize("tol", [1e-3, 1e-7])
def test_the_degree_of_depletion_is_the_least_whose_rest_is_small(saturation, tol):
    beam = OIL.pupil(depth=0.5e-6, wavelength=640e-9, emitter=lm.Beam("circular"))
    vortex = OIL.pupil(depth=0.5e-6, wavelength=775e-9, emitter=lm.Beam("vortex"))
    way = scanning.Sted(beam, depletion=vortex, saturation=saturation, tol=tol)
    a = 0.5 * math.log(2.0) * saturation
    rest = [2.0 * sum(float(scipy.special.ive(k, a)) for k in range(n + 1, 400)) for n in range(80)]
    assert way._degree == next(n for n, one in enumerate(rest) if one <= 0.02 * tol)
    pupil = OIL.pupil(depth=0.5e-6, wavelength=680e-9)
    alone = super(scanning.Sted, way).stretch(pupil)
    assert way.stretch(pupil) == pytest.approx(alone + way._degree * pupil.scale / vortex.scale, rel=1e-12, abs=0.0)


def kernel(y, x):
    """Return the logarithms of the three means of abs(exp(-i v.r)) on the shifted paths, for each b."""
    disc, chords, nodes = [], [], []
    for b in B:
        sinh, weight = math.sinh(b), 1.0 + 1.0 / math.cosh(2.0 * b)
        s = max(math.hypot(y, x) * sinh, 1e-12)
        disc.append(s + math.log(-math.expm1(-2.0 * s) / (2.0 * s)))
        at = [max(sinh * math.hypot(x, y * t), 1e-12) for t in np.linspace(0.0, 1.0, 17)]
        scaled = [math.exp(e - s) * min(1.0, math.sqrt(math.pi / 8.0 / e)) for e in at]
        mean = sum(0.5 * (p + q) for p, q in itertools.pairwise(scaled)) / 16.0
        chords.append(s + min(0.0, math.log(weight * mean)))
        over = max(y * sinh, 1e-12)
        nodes.append(over + min(0.0, 0.5 * math.log(math.pi / 8.0 / over)))
    return disc, chords, nodes


@pytest.mark.parametrize(("y", "x"), [(0.0, 0.0), (3.0, 1.0), (0.5, 12.0)])
def test_means_of_the_kernel_on_shifted_paths(y, x):
    for found, expected in zip(chordal_debye.means_of_kernel(y, x), kernel(y, x), strict=True):
        assert found == pytest.approx(expected, rel=1e-10, abs=1e-12)


def test_growth_is_that_of_all_terms_and_of_the_window_beyond_the_tilt():
    wavefront = lm.Wavefront.zernike({(1, 1): 0.5, (1, -1): -0.2, (2, 2): 0.3, (3, 1): -0.4}, normalization="edge")
    low, high = np.array([-3.0, -2.0]), np.array([2.5, 4.0])
    y, x = (max(abs(a - t), abs(b - t)) for a, b, t in zip(low, high, (-0.2, 0.5), strict=True))
    sizes = {n: abs(w) for (n, _), w in wavefront.amplitudes().items() if n > 1}
    waves = [sum(w * math.sinh(n * b) for n, w in sizes.items()) for b in B]
    found = chordal_debye.growth(wavefront, low, high)
    for one, mean in zip(found, kernel(y, x), strict=True):
        assert one == pytest.approx(np.add(waves, mean), rel=1e-10, abs=0.0)
    for one, more in zip(found, found.times(3), strict=True):
        assert more - one == pytest.approx([math.log(math.cosh(3 * b)) for b in B], rel=1e-10, abs=0.0)
    assert found.times(0) is found


def tail(first, b):
    r = math.exp(-4.0 * b)
    return 0.5 * math.log((first + 1.0) / (1.0 - r) + 2.0 * r / (1.0 - r) ** 2) + math.log1p(math.exp(-2.0 * b))


def test_the_tail_of_a_series_of_radial_polynomials():
    for first in (3.0, 20.0):
        for b, found in zip(B, np.broadcast_to(chordal_debye._tail(first), 64), strict=True):
            n = first + 2.0 * np.arange(20_000)
            exact = math.sqrt(((n + 1.0) * np.exp(-2.0 * (n - first) * b)).sum()) * (1.0 + math.exp(-2.0 * b))
            assert found == pytest.approx(tail(first, b), rel=1e-10, abs=1e-12)
            assert found == pytest.approx(math.log(exact), abs=1e-9)


@pytest.mark.parametrize("error", [1e-2, 1e-10])
def test_the_degree_of_a_field_truncates_it_to_its_error(error):
    means = np.array(kernel(4.0, 5.0)[0])
    degree = chordal_debye.degree_for(means, 2.0, error)
    logs = [m + math.log(2.0 / error) for m in means]
    first = [max((g + tail(40.0, b)) / b, 1.0) for g, b in zip(logs, B, strict=True)]
    second = [max((g + tail(f, b)) / b, 1.0) for g, f, b in zip(logs, first, B, strict=True)]
    assert degree == math.ceil(min(second)) - 1
    cut = min(m + tail(degree + 1.0, b) - (degree + 1.0) * b for m, b in zip(means, B, strict=True))
    assert chordal_debye.truncation_error(means, degree) == pytest.approx(math.exp(cut), rel=1e-9, abs=0.0)
    assert 2.0 * math.exp(cut) <= 1.5 * error


@pytest.mark.parametrize(("chords", "nodes"), [(4, 6), (20, 12)])
def test_errors_of_chords_and_nodes_are_those_of_section_8(chords, nodes):
    means = Growth(*map(np.array, kernel(3.0, 2.0)))
    over_chords, over_nodes = chordal_debye.curves(means, Rule(chords, nodes, 10))
    for k, b in enumerate(B):
        c = (1 + math.exp(-4 * b)) * math.exp(-2 * chords * b) / (1 - math.exp(-2 * (chords + 1) * b))
        n = 32 / 15 * math.exp(-2 * nodes * b) / (1 - math.exp(-2 * b))
        assert over_chords[k] == pytest.approx(min(c * math.exp(means.chords[k]), math.exp(600)), rel=1e-9, abs=0.0)
        assert over_nodes[k] == pytest.approx(min(n * math.exp(means.nodes[k]), math.exp(600)), rel=1e-9, abs=0.0)


def test_the_error_of_light_is_that_of_each_field_and_of_rounding():
    errors, largest = np.array([[1e-3, 2e-3], [0.0, 1e-4]]), np.array([[1.0, 0.5], [2.0, 0.1]])
    expected = [
        sum(e * (2 * m + e) + 32 * U * m * m for e, m in zip(*rows, strict=True))
        for rows in zip(errors.tolist(), largest.tolist(), strict=True)
    ]
    assert chordal_debye.error_of_light(errors, largest) == pytest.approx(expected, rel=1e-12, abs=0.0)


def test_a_case_counts_rounding_truncation_and_nodes_for_its_share_of_the_error():
    window = chordal_debye.Window((5, 7), (2.0, 3.5), 0.8)
    by = chordal_debye.By((0, 1), ((2, 2), (3, 1)))
    error, waves = 1e-6, FIVE
    case = chordal_debye._case(PUPIL.layers, PUPIL.emitter, waves, window, by, error)
    axis = np.array([2.0, 3.5])
    base = chordal_debye.growth(waves, -axis * 0.8, (np.array([4.0, 6.0]) - axis) * 0.8)
    limit = base.times(3)
    norm = projection.norm(PUPIL.layers, PUPIL.emitter.light.model)
    assert case.degree == chordal_debye.degree_for(limit.projection, norm, 0.25 * error)
    plain = chordal_debye._case(PUPIL.layers, PUPIL.emitter, waves, window, chordal_debye.By(), error)
    assert plain.degree == chordal_debye.degree_for(base.projection, norm, 0.25 * error) < case.degree
    reach = 0.8 * math.hypot(2.0, 3.5)
    per_term = [3.0 * n * n + 16.0 + len(waves.terms) for n, _ in waves.terms]
    phase = max(sum(abs(c) * p for c, p in zip(edge, per_term, strict=True)) for edge in np.atleast_2d(waves.edge))
    rounding = 4.0 * case.degree + 64.0 + 9.0 * reach + phase
    factors = [0 if term < 0 else by.terms[term][0] for _, term, _ in case.sets.tolist()]
    assert case.rounding == pytest.approx([rounding + 6.0 * n * n for n in factors], rel=1e-12, abs=0.0)
    cut = [norm * float(chordal_debye.truncation_error(base.times(n).projection, case.degree)) for n in factors]
    assert case.truncation == pytest.approx(cut, rel=1e-9, abs=0.0)
    for row, (mean, factor, share) in zip(
        case.chosen,
        (
            (limit.chords, [1.0 + math.exp(-4 * b) for b in B], 0.3),
            (limit.nodes, [32 / 15 / (1 - math.exp(-2 * b)) for b in B], 0.3),
        ),
        strict=True,
    ):
        expected = [
            (m + math.log(f) - math.log(share * error)) / (4 * b) for m, f, b in zip(mean, factor, B, strict=True)
        ]
        assert row == pytest.approx(expected, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("scale", [None, 1.0])
@pytest.mark.parametrize("shares", [[0.9, 0.45, 0.2], [3.0, 1000.0, 1200.0, 0.1], [700.0] * 9])
def test_fields_are_computed_anew_until_the_light_is_within_the_tolerance(scale, shares):
    """The error over the least peak, doubled where values are divided by their own peak, and storing."""
    way, asked, tol, wanted = chordal_debye.ChordalDebye(1e-3), [], 1e-3, Wanted(scale, np.dtype(np.float64))

    def run(field_error):
        asked.append(field_error)
        return "made", np.array([0.5, 2.0]), 0.5 * tol * np.array([shares[len(asked) - 1], 0.1])

    off = [0.5 * tol * s / (0.5 - 0.5 * tol * s) if s < 1000 else math.inf for s in shares]
    off = [2.0 * one / (1.0 - one) if one < 1.0 else math.inf for one in off] if scale is None else off
    used = next((k for k, one in enumerate(off) if one + 6 * U <= tol), None)
    if used is None:
        with pytest.raises(lm.ToleranceError):
            way._prove(PUPIL, tol, wanted, run)
    else:
        made, peak, relative = way._prove(PUPIL, tol, wanted, run)
        assert (made, peak.tolist()) == ("made", [0.5, 2.0])
        assert relative[0] == pytest.approx(off[used], rel=1e-9, abs=0.0)
        assert len(asked) == used + 1
        exact = float(stored(relative, np.float64).max())
        same = 0.5 * tol * np.array([shares[used], 0.1])
        assert way._prove(PUPIL, exact, wanted, lambda error: (error, peak, same))[0] > 1e-15
    target, assumed = tol / (2.0 if scale is None else 1.0) - 12 * U, debye_wolf.likely_peak(PUPIL) / 4.0
    for k, one in enumerate(asked):
        assert one == max(1e-15, 2.0 ** math.floor(math.log2(target * math.sqrt(assumed) / 6.0)))
        target, assumed = target * max(1e-3, min(0.5, 0.5 * tol / off[k])), 0.25 * assumed
    assert used is not None or asked[-2] > asked[-1] == 1e-15


@pytest.mark.parametrize("worst", [[1e-6], [9e-6, 0.5e-6], [1.2e-6, 1.1e-6, 0.1e-6], [math.inf] * 9])
def test_stacks_are_refined_for_a_peak_that_is_assumed_lower_and_lower(worst, monkeypatch):
    """Fields have a 32nd of the tolerance of the root of the peak, what is interpolated an eighth of the peak's."""
    asked, peak = [], debye_wolf.likely_peak(PUPIL)
    made = stratified._refine(lambda one: asked.append(one) or ("made", worst[len(asked) - 1]), PUPIL, 1e-6)
    assert made == (None if worst[-1] > 1e-6 else "made")
    for (field, interpolation), one in zip(asked, worst, strict=False):
        assert field == max(2.0**-52, 2.0 ** math.floor(math.log2(1e-6 / 32 * math.sqrt(peak))))
        assert interpolation == max(2.0**-52, 2.0 ** math.floor(math.log2(1e-6 / 8 * peak)))
        peak *= max(1e-6, min(0.25, 0.5e-6 / one))
    assert len(asked) == len(worst) if made else asked[-2].field > asked[-1].field == 2.0**-52
    assert stratified._refine(lambda _: (None, 1.0), PUPIL, 1e-6) is None
    reach = []
    monkeypatch.setattr(stratified, "layered", lambda pupil, v, field: reach.append(v))
    values, error = np.array([[[0.3, 0.5]], [[0.7, 0.2]]]), np.array([1e-7, 1e-9])
    monkeypatch.setattr(stratified, "layered_profiles", lambda field, v: (values, error))
    found = lm.methods.Stratified(1e-6).profile(PUPIL, np.array([0.0, 1.0, 3.0]))
    assert found.peak == pytest.approx(np.array([0.5, 0.7]) - error, rel=1e-14, abs=0.0)
    assert found.error == pytest.approx(error / found.peak, rel=1e-14, abs=0.0)
    worst = error[0] / (0.5 - error[0])
    assert reach == [3.0]
    assert stratified.profiles(PUPIL, np.array([0.0, 1.0]), worst * (1 + 1e-9)) is not None
    assert stratified.profiles(PUPIL, np.array([0.0, 1.0]), worst * (1 - 1e-9)) is None


@pytest.mark.parametrize("scale", [None, 1.0])
@pytest.mark.parametrize("worst", [[1e-6], [9e-6, 0.5e-6], [1.2e-6, 1.1e-6, 0.1e-6], [math.inf] * 9])
def test_rings_are_computed_anew_for_less_error(scale, worst, monkeypatch):
    asked = []

    def ringed(pupil, grid, accuracy, wanted):
        asked.append(accuracy)
        return Samples(np.ones(2), np.ones(2), np.array([0.5, 1.0]) * worst[len(asked) - 1])

    monkeypatch.setattr(debye_rings, "ringed", ringed)
    way, wanted = debye_rings.DebyeRings(1e-6), Wanted(scale, np.dtype(np.float64))
    with nullcontext() if worst[-1] <= 1e-6 else pytest.raises(lm.ToleranceError):
        way._samples(PUPIL, None, 1e-6, wanted)
    peak, allowed = debye_wolf.likely_peak(PUPIL) / 4.0, 1e-6 / (2.0 if scale is None else 1.0) - 12 * U
    for found, one in zip(asked, worst, strict=False):
        expected = allowed * math.sqrt(peak) / 8, allowed * peak, allowed / 100
        assert found == tuple(2.0 ** math.floor(math.log2(part)) for part in expected)
        peak, allowed = peak / 4, allowed * max(1e-6, min(0.5, 0.5e-6 / one))
    assert len(asked) == len(worst) or asked[-2].field > 1e-15 >= asked[-1].field


@pytest.mark.parametrize(("name", "kind"), [*METHODS.items(), *LAYERED.items()])
def test_the_default_tolerance_is_that_of_the_reference(name, kind):
    told = {"hankel": 1e-14, "tuned-closed-form": 1e-4}.get(name, 1e-6)
    assert not hasattr(kind(), "tol") or kind().tol == told
    scanned = (lm.methods.Bead, lm.methods.Confocal, lm.methods.Sted, lm.methods.TwoPhoton)
    assert {one.tol for one in scanned} == {1e-6}


def test_the_error_of_an_intensity_is_that_of_every_product_of_its_fields():
    rng = np.random.default_rng(3)
    form, fields = rng.normal(size=(3, 3)) + 1j * rng.normal(size=(3, 3)), rng.uniform(0.1, 1.0, (3, 4))
    harmonic, error = Harmonic(2, form, 0.6, -1.1), 0.05
    found = debye_wolf._form_error(harmonic, fields, error)
    for n in range(4):
        total = 0.0
        for j, k in itertools.product(range(3), repeat=2):
            products = (fields[j, n] + error) * (fields[k, n] + error) - fields[j, n] * fields[k, n]
            total += abs(form[j, k]) * math.hypot(0.6, 1.1) * products
        assert found[n] == pytest.approx(total, rel=1e-9, abs=0.0)


def test_light_in_a_sheet_is_rounded_once_more_when_it_is_stored():
    pupil, small = OIL.pupil(depth=0.5e-6, z=[0.0, 3e-7], wavelength=520e-9), 6.0 * U + 2.0**-24
    made = lm.microscopy.light_sheet(pupil, 1e-6, 3, 6.5e-6, tol=1e-4)
    exact = lm.psf(pupil, 3, 6.5e-6, tol=1e-4 - 1.1 * small, normalize=made.normalize, dtype=np.float64)
    assert made.error_bound == pytest.approx(exact.error_bound + 1.01 * small, rel=1e-9, abs=0.0)
    assert made.error_bound <= 1e-4
