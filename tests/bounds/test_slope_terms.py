"""Bounds on derivatives, term by term, from the formulas of the page about the certificate, section 12."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.core.answers import Samples, Slopes, Wanted
from lommel.core.engine import least_average
from lommel.methods import ChordalGauss, NonuniformFFT, derivatives, nonuniform_fft
from lommel.methods.averaging import averaging_filter, pixel_averages, slope_filter
from lommel.methods.derivative_names import Parts
from lommel.methods.derivatives import Piece, Slope
from lommel.optics.grid import Grid
from lommel.special import zernike

U = 2.0**-53
STORED = {np.float64: 6.0 * U, np.float32: 6.0 * U + 2.0**-24}
LEFT = 1e-9
PUPIL = lm.Pupil(
    lm.Wavefront([1.0, 2.0], 0.5, nonradial={(3, 1): 0.7, (2, -2): 0.3}, error=LEFT),
    obscuration=0.4,
    apodization=lm.Apodization([0.5], error=3e-10),
)
E = PUPIL.wavefront.left_out + 6e-10


def images(rng: np.random.Generator, kind: type, shape: tuple[int, ...] = (2, 4, 5)) -> Samples:
    """Made-up images, of which the second is brighter outside of the window."""
    values = rng.uniform(0.0, 1.0, shape).astype(kind)
    scale = np.full(len(values), 0.3)
    peak = np.array([values[0].max() / 0.3, 7.0])[: len(values)]
    made = Slopes(rng.normal(size=(3, *shape)).astype(kind), np.array([[1e-6, 2e-6], [3e-6, 4e-6], [5e-6, 1e-7]]))
    return Samples(values, scale, np.array([0.1, 0.2]), made, peak)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_a_sum_is_off_by_all_that_its_parts_are(kind):
    rng = np.random.default_rng(1)
    made = images(rng, kind)
    pieces = {
        key: Piece(rng.normal(size=(2, 4, 5)), rng.uniform(1e-7, 1e-6, 2))
        for key in ((3, 1), 1, "scaling", "obscuration")
    }
    pieces["unknown"] = Piece(np.zeros((1, 1, 1)), np.full(1, 3e-7))
    each = Parts({(3, 1): np.array([2.0, -3.0]), 1: 0.7}, -1.5, -0.4, 2.5, 0.9)
    found = derivatives._combine(each, made, pieces, kind)
    for i in range(2):
        factors = {(3, 1): (2.0, -3.0)[i], 1: 0.7, "scaling": -0.4, "obscuration": 2.5}
        parts = [-1.5 * made.values[i].astype(float)]
        parts += [factor * pieces[key].values[i] for key, factor in factors.items()]
        exact = np.sum(parts, axis=0)
        assert found.values[i] == pytest.approx(exact, rel=3e-7 if kind is np.float32 else 1e-14)
        top = (made.values[0].max(), 7.0 * 0.3)[i]
        bright = top / (1.0 + made.error[i])
        off = 1.5 * made.error[i] * top + 0.9 * 3e-7
        off += sum(abs(factor) * pieces[key].error[i] for key, factor in factors.items())
        off += (5 + 8) * U * sum(np.abs(part).max() for part in parts)
        off += STORED[kind] * np.abs(exact).max()
        assert found.error[i] * bright == pytest.approx(off, rel=1e-12, abs=0.0)
    # With no more than what rounding and storing add.
    alone = derivatives._combine(Parts({1: 0.7}), made, {1: Piece(pieces[1].values, np.zeros(2))}, kind)
    size = 0.7 * np.abs(pieces[1].values).max(axis=(1, 2))
    bright = derivatives._least_peak(made)
    assert alone.error * bright == pytest.approx((12.0 * U + STORED[kind]) * size, rel=1e-9, abs=0.0)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_a_multiple_is_off_by_as_much_more_and_by_what_storing_adds(kind):
    made = images(np.random.default_rng(2), kind)
    keys = ((3, 1), (1, 1), (2, 2))
    sums = [Parts({(3, 1): 1.0}), Parts({(1, 1): 2.0}), Parts({(2, 2): np.array([-0.3, 1.7])}), Parts({(3, 1): 1.0})]
    as_is, twice, times, again = derivatives._single_slopes(made, sums, keys)
    assert as_is.values.base is made.slopes.values
    assert np.array_equal(as_is.error, made.slopes.error[0])
    assert not np.shares_memory(again.values, as_is.values)
    assert np.array_equal(twice.values, 2.0 * made.slopes.values[1])
    assert twice.error == pytest.approx(2.0 * made.slopes.error[1], rel=1e-14, abs=0.0)
    bright = derivatives._least_peak(made)
    stored = STORED[kind] * np.abs(times.values).reshape(2, -1).max(axis=1).astype(float) / bright
    assert times.error == pytest.approx(np.array([0.3, 1.7]) * made.slopes.error[2] + stored, rel=1e-9, abs=0.0)


def test_what_is_brightest_is_less_by_its_error():
    made = images(np.random.default_rng(3), np.float64)
    expected = np.array([made.values[0].max() / 1.1, 2.1 / 1.2])
    assert derivatives._least_peak(made) == pytest.approx(expected, rel=1e-14, abs=0.0)
    alone = made._replace(peak=None)
    assert derivatives._least_peak(alone)[1] == pytest.approx(made.values[1].max() / 1.2, rel=1e-14, abs=0.0)


@pytest.fixture
def aims(monkeypatch):
    """Return the errors that filters of derivatives are asked for."""
    asked = []
    for name in ("averaging_filter", "slope_filter"):
        made = getattr(derivatives, name)
        monkeypatch.setattr(
            derivatives, name, lambda *of, made=made, **more: asked.append(of[1]) or made(*of, **more)
        )
    return asked


class Engine(ChordalGauss):
    """Answers with ones, and with the errors that it is told to."""

    def tightened(self, tol=None):
        assert tol == pytest.approx(0.1 * self.tol)
        return self

    def images(self, pupil, grid, wanted):
        values = np.ones((2, *grid.shape))
        made = Slopes(np.full((len(wanted.terms), *values.shape), 0.5), np.full((len(wanted.terms), 2), 1e-5))
        return Samples(values, np.ones(2), np.array([1e-7, 2e-7]), made, np.array([1.5, 2.0]))


@pytest.mark.parametrize("tol", [1e-6, 1e-11])
@pytest.mark.parametrize("integrate", [False, True])
def test_growth_is_off_by_what_tilts_and_finer_samples_are(integrate, tol, aims):
    grid = Grid((3, 5), 0.5, center=(0.5, 4.5), integrate=integrate)
    step, engine = 0.5 * math.pi, Engine(tol)
    off = np.array([[1e-15, 2e-15], [3e-15, 1e-15]])
    tilts = [(np.full((2, 3, 5), 0.25), off[0]), (np.full((2, 3, 5), -0.5), off[1])]
    _, found = derivatives.scaling_derivative(engine, PUPIL, grid, tilts)
    far = step * np.array([4.5, 1.5])
    expected = far[0] * (tilts[0][1] + 8 * U * 0.25) + far[1] * (tilts[1][1] + 8 * U * 0.5)
    if integrate:
        aim = max(1e-3 * tol * least_average(step), 1e-13)
        assert aims == pytest.approx([aim, aim], rel=1e-9, abs=0.0)
        plain, growing = averaging_filter(step, aim), averaging_filter(step, aim, by_pitch=True)
        bright = PUPIL.amplitude**2
        expected += 2.0 * (2.0 * plain.error + (1.0 + plain.error) * growing.error) * bright
        expected += math.sqrt(8.0) * step * E * (2.0 + E) * bright
        size = max(plain.weights.size, growing.weights.size)
        samples = np.array([1.5, 2.0]) * (np.array([1e-7, 2e-7]) + (4 * size + 16) * U)
        expected += 2.0 * plain.gain * growing.gain * samples
    assert found == pytest.approx(expected, rel=1e-9, abs=0.0)


@pytest.mark.parametrize("tol", [1e-6, 1e-11])
@pytest.mark.parametrize("integrate", [False, True])
def test_shifts_are_those_of_samples_and_off_by_what_filters_and_finer_samples_are(integrate, tol, aims):
    """Over three samples a pixel; over an even number one difference of samples would be exact."""
    grid, off, step = Grid((3, 5), 0.7, integrate=integrate), np.array([1e-15, 2e-15]), 0.7 * math.pi

    def ramps(method, pupil, fine, wanted):
        values = 9.0 + step / 0.7 * (0.2 * fine.x + 0.1 * fine.y[:, None]) + np.zeros((2, 1, 1))
        return Samples(values, np.ones(2), off, None, np.array([1.5, 2.0]))

    (across, of_across), (down, of_down) = derivatives.tilted(Engine(tol), PUPIL, grid, compute=ramps)
    assert across == pytest.approx(-0.2, abs=1e-3)
    assert down == pytest.approx(-0.1, abs=1e-3)
    aim = max(1e-3 * tol * (least_average(step) if integrate else 1.0), 1e-13)
    assert aims == pytest.approx([aim] * (1 + integrate), rel=1e-9, abs=0.0)
    slope, plain = slope_filter(step, aim, averages=integrate), averaging_filter(step, aim)
    error, gain, size = (plain.error, plain.gain, plain.weights.size) if integrate else (0.0, 1.0, 1)
    expected = (slope.error * (1.0 + error) + 2.0 * error) * PUPIL.amplitude**2
    rounding = (4 * max(slope.weights.size, size) + 16) * U
    expected += gain * slope.gain * np.array([1.5, 2.0]) * (off + rounding)
    assert of_across == pytest.approx(expected, rel=1e-9, abs=0.0)
    assert of_down == pytest.approx(expected, rel=1e-9, abs=0.0)


@pytest.mark.parametrize(("terms", "v", "error"), [
    ({}, 0.0, 1.0), ({}, 30.0, 1e-3), ({(3, 1): 2.0}, 7.0, 0.3), ({(4, 2): 9.0, (2, 0): 3.0}, 50.0, 1e-11),
    ({(5, 5): 40.0}, 0.0, 1e-15), ({(1, 1): 1e-3}, 1e-3, 2.0),
])  # fmt: skip
def test_nodes_of_the_rim_are_the_fewest_of_which_the_trapezoidal_rule_errs_by_no_more(terms, v, error):
    """Twice the largest integrand over e^(k b) - 1, on the displacements b that are tried."""
    curves = np.geomspace(1e-3, 8.0, 128)
    sizes = {key: w * abs(float(zernike.radial(*key, np.array(0.4)))) for key, w in terms.items()}

    def off(k):
        logs = [
            sum(size * math.sinh(m * b) for (_, m), size in sizes.items()) + 0.4 * v * math.sinh(b) for b in curves
        ]
        return min(
            2.0 * math.exp(min(g, 600.0)) / math.expm1(min(k * b, 700.0)) for g, b in zip(logs, curves, strict=True)
        )

    found = derivatives._nodes(terms, 0.4, v, error)
    assert off(found) <= error * (1.0 + 1e-9)
    assert found == 1 or off(found - 1) > error


@pytest.mark.parametrize(("first", "second", "asked"), [
    (1.0, -0.9, []), (1.0, 1.0, []), (1.0, -1.5, [1e-6 / 2.5]), (300.0, 300.0, [1e-6 / 321.0]),
])  # fmt: skip
def test_powers_that_cancel_are_asked_for_as_much_more(first, second, asked):
    found = []

    class Asked(Engine):
        def tightened(self, tol=None):
            found.append(tol)
            return self

        def images(self, pupil, grid, wanted):
            return super().images(pupil, grid, wanted._replace(terms=wanted.terms + wanted.powers))

    made = Samples(np.ones((2, 3, 3)), np.full(2, 0.3), np.full(2, 0.1), None, np.full(2, 4.0))
    sums = [Parts({1: 0.1}), Parts({1: first, 2: np.array([second, 0.1]), (3, 1): 9.0})]
    derivatives._sum_terms(Asked(1e-6), Asked(1e-6), PUPIL, Grid(3, 0.5), made, Wanted(0.3), sums)
    assert found == pytest.approx(asked, rel=1e-12)


def test_shifts_by_samples_leave_out_what_the_wavefront_does(monkeypatch):
    found = np.array([1e-6, 3e-6])
    monkeypatch.setattr(derivatives, "tilted", lambda *_: [(np.ones((2, 3, 3)), found)] * 2)
    made = Samples(np.ones((2, 3, 3)), np.full(2, 0.3), np.full(2, 0.1), None, np.full(2, 4.0))
    engine = lm.methods.NijboerZernike()
    sums = [Parts({(1, 1): 1.0})]
    pieces = derivatives._sum_terms(engine, engine, PUPIL, Grid(3, 0.5), made, Wanted(0.3), sums)
    assert pieces[1, 1].error == pytest.approx(0.3 * (found + 4.0 * E * PUPIL.amplitude**2), rel=1e-12, abs=0.0)


@pytest.mark.parametrize(("radial", "names", "kind"), [
    (True, ((2, 0), (4, 0)), None), (True, ((2, 0), (3, 1)), ChordalGauss), (True, ((2, 0), (2, 0)), None),
    (False, ((2, 0),), ChordalGauss), (True, ("defocus",), None), (True, ((10, 0),), ChordalGauss),
])  # fmt: skip
def test_terms_alone_are_differentiated_at_once_by_chords_unless_all_are_radial(radial, names, kind):
    pupil = lm.Pupil(lm.Wavefront(1.0, nonradial={} if radial else {(3, 1): 1.0}))
    found = derivatives._rule_of_terms(None, pupil, names, 1e-5)
    assert found == (None if kind is None else kind(1e-5))


def test_gradients_of_averages_are_off_by_what_their_filters_and_the_samples_are():
    grid, tol, off = Grid((3, 5), 0.7, integrate=True), 1e-6, np.array([3e-10, 4e-10])

    def sample(pupil, fine, tol, wanted):
        return Samples(np.ones((2, *fine.shape)), np.ones(2), off / [1.5, 2.0], None, np.array([1.5, 2.0]))

    found = pixel_averages(sample, PUPIL, grid, tol, Wanted(), gradients=True)
    assert found.values.shape == (3, 2, 3, 5)
    assert np.abs(found.values[1:]).max() < 1e-6
    step = grid.step(PUPIL)
    aim = 2e-3 * (tol - (1.0 + tol) * STORED[np.float64]) * least_average(step)
    plain, slope = averaging_filter(step, aim), slope_filter(step, 10.0 * aim, averages=True)
    size = max(plain.weights.size, slope.weights.size)
    expected = (slope.error * (1.0 + plain.error) + 2.0 * plain.error) * PUPIL.amplitude**2
    expected += plain.gain * slope.gain * (off + (4 * size + 16) * U * (np.array([1.5, 2.0]) + off))
    # Of the images themselves by what averages are, with a tenth of the tolerance for sums of dark samples.
    light, own = np.array([1.5, 2.0]) - off, tol - (1.0 + tol) * STORED[np.float64]
    added = (2 * size + 8) * U * plain.gain**2 + 1.01 * 0.1 * own * least_average(step)
    whole = plain.gain**2 * off + (2.0 + plain.error) * plain.error * PUPIL.amplitude**2 + added * light
    assert found.error[0] == pytest.approx(whole / found.peak, rel=1e-6, abs=0.0)
    assert found.error[1:] * found.peak == pytest.approx(np.array([expected, expected]), rel=1e-6, abs=0.0)


@pytest.mark.parametrize(("integrate", "error"), [(False, 1e-4), (True, 1e-4), (False, 1e-15), (True, 1e-12)])
def test_the_rim_is_off_by_what_both_fields_are(integrate, error, aims):
    grid = Grid((3, 4), 0.5, center=(1.0, 2.0), integrate=integrate)
    _, found = derivatives.obscuration_derivative(PUPIL, grid, error)
    a, eps = PUPIL.amplitude, 0.4
    light = 2.0 * eps * float(PUPIL.illumination.at(np.array(eps**2)))
    step, fine = 0.5 * math.pi, grid
    if integrate:
        aim = max(0.1 * error * least_average(step), 1e-13)
        taps = averaging_filter(step, aim)
        assert aims == pytest.approx([aim], rel=1e-9, abs=0.0)
        fine = derivatives.sample_grid(grid, taps)
        error = 0.3 * error
    aim = max(0.1 * error / (a + light), 1e-15)
    v = fine.step(PUPIL) / fine.pixel * math.hypot(np.abs(fine.x).max(), np.abs(fine.y).max())
    degree = derivatives.degree_needed(
        [(n, w) for (n, _), w in PUPIL.wavefront.amplitudes().items()], v, PUPIL.illumination, aim
    )
    nodes = PUPIL.rule(degree).weight.size
    terms = PUPIL.wavefront.terms
    phases = max(
        sum(abs(c) * (n * n + len(terms) + 10) for (n, _), c in zip(terms, edge, strict=True))
        for edge in PUPIL.wavefront.edge
    )
    left = E + U * (phases + 12.0 * v + 3 * 512 + nodes / 512 + 40)
    of_disk, of_rim = aim + left * a, aim + left * light
    expected = 2.0 * (a * of_rim + light * of_disk + of_disk * of_rim)
    if integrate:
        expected = taps.gain**2 * (expected + (2 * taps.weights.size + 8) * U * 2.0 * a * light)
        expected += (2.0 + taps.error) * taps.error * 2.0 * a * light
    assert found == pytest.approx(np.full(2, expected), rel=1e-9, abs=0.0)


def test_what_is_left_out_is_in_each_part():
    pupil = lm.Pupil(PUPIL.wavefront, obscuration=0.4, apodization=PUPIL.apodization, wavelength=5e-7, f_number=3.0)
    grid, engine = Grid(5, 1e-6), Engine(1e-6)
    made = Samples(np.ones((2, 5, 5)), np.full(2, 0.3), np.full(2, 0.1), None, np.full(2, 4.0))
    sums = [Parts({(3, 1): 1.0}, obscuration=1.0, unknown=1.0)]
    found = derivatives._sum_terms(engine, engine, pupil, grid, made, derivatives.Wanted(0.3), sums)
    left = E * pupil.amplitude**2
    assert found["unknown"].error == pytest.approx([0.3 * 2.0 * left], rel=1e-12, abs=0.0)
    assert found[3, 1].error == pytest.approx(0.3 * (1e-5 * np.array([1.5, 2.0]) + 4.0 * left), rel=1e-12, abs=0.0)
    # The rim is asked for a tenth of the tolerance of the faintest peak.
    _, bound = derivatives.obscuration_derivative(pupil, grid, 0.1 * 1e-6 * 4.0 / 1.1)
    assert found["obscuration"].error == pytest.approx(0.3 * bound, rel=1e-12, abs=0.0)
    white = lm.methods.Polychromatic([4e-7, 5e-7], [1, 3], ChordalGauss())
    parts = white.components(pupil)
    found = derivatives._sum_terms(white, engine, pupil, grid, made, derivatives.Wanted(0.3), [Parts({(3, 1): 1.0})])
    left = [(part.pupil.wavefront.left_out + 6e-10) * pupil.amplitude**2 for part in parts]
    expected = sum(
        0.3 * part.weight * part.stretch * (1e-5 * np.array([1.5, 2.0]) + 4.0 * off)
        for part, off in zip(parts, left, strict=True)
    )
    assert found[3, 1].error == pytest.approx(expected, rel=1e-12, abs=0.0)
    assert isinstance(derivatives._combine(Parts({(3, 1): 1.0}), made, found, np.float64), Slope)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_a_derivative_over_any_aperture_is_off_by_both_of_its_fields(kind, monkeypatch):
    """I' = 2 Re(conj(U) U'), where |U'| is at most the amplitude."""
    rng = np.random.default_rng(5)
    values, slopes = rng.uniform(0.0, 0.2, (1, 3, 4)), rng.normal(size=(2, 1, 3, 4))
    field, slope, pupil = 1e-5, np.array([[2e-5], [3e-7]]), lm.Pupil(spider=lm.Spider.equal(3, width=0.1))
    monkeypatch.setattr(nonuniform_fft, "_sums", lambda *_: (values, slopes, np.array([field]), slope))
    wanted = Wanted(0.7, kind, terms=((2, 2), (3, 1)))
    found = NonuniformFFT(1e-3).images(pupil, Grid((3, 4), 0.5, integrate=False), wanted)
    peak, amplitude = values.max(), pupil.amplitude
    root = math.sqrt(peak)
    whole = (2 * root * field + field**2) / (root - field) ** 2
    assert found.error == pytest.approx([whole + (1 + whole) * STORED[kind]], rel=1e-9)
    for k in range(2):
        off = 2 * (root * slope[k, 0] + amplitude * field + slope[k, 0] * field) / peak
        off += (np.abs(slopes[k]).max() / peak + off) * STORED[kind]
        assert found.slopes.error[k] == pytest.approx([off], rel=1e-9)
    assert found.slopes.values == pytest.approx(0.7 * slopes, rel=1e-6)
