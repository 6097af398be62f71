"""Terms of the bounds of scanning microscopes, rings and derivatives, a second time: docs/certificate.md."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

import lommel as lm
from lommel.core import engine
from lommel.core.answers import Declined, Samples, Slopes, Wanted
from lommel.methods.layers import chordal_debye, debye_rings, debye_wolf, samples, scanning, slopes
from lommel.methods.layers.samples import SampledLight
from lommel.methods.layers.scanning import Orders
from lommel.methods.method import relative_error, stored
from lommel.optics.grid import Grid
from lommel.optics.layers import debye, projection
from lommel.special import interpolation
from objectives import FIVE, OIL

pytest.importorskip("scipy.sparse")  # takes longer to load than any test
U, EPS = 2.0**-53, 2.0**-50
PLAIN = OIL.pupil(depth=0.5e-6, z=[0.0, 3e-7], wavelength=520e-9, origin="coverslip")
BENT = replace(PLAIN, aberrations=FIVE)
BEAM = OIL.pupil(depth=0.5e-6, wavelength=488e-9, emitter=lm.Beam("circular"), origin="coverslip")
VORTEX = OIL.pupil(depth=0.5e-6, wavelength=592e-9, emitter=lm.Beam("vortex"), origin="coverslip")
OFF = np.array([1e-4, 3e-4])
KINDS = {
    "bead": scanning.Bead(4e-8),
    "confocal": scanning.Confocal(BEAM, pinhole=1.5),
    "two-photon": scanning.TwoPhoton(),
    "sted": scanning.Sted(BEAM, pinhole=1.5, depletion=VORTEX, saturation=3.0),
}


def off(pupil, v, accuracy, tol):
    """Return errors that tell what was asked for."""
    return OFF.repeat(pupil.depth.size // 2) + 0.1 * accuracy + 3.0 * tol + 1e-6 * v.max() * pupil.layers.wavelength


def flat_light(pupil, v, accuracy, tol):
    return Orders(np.full((pupil.depth.size, 1, v.size), 0.6), off(pupil, v, accuracy, tol))


def flat_samples(pupil, grid, fraction, threads=0):
    error = off(pupil, np.array(grid.shape), fraction, 0.0)
    return SampledLight(np.full((pupil.depth.size, *grid.shape), 0.6), error)


@pytest.mark.parametrize("name", KINDS)
def test_images_of_scanned_light_add_the_errors_of_their_factors(name, monkeypatch):
    way, v, target, grid = KINDS[name], np.array([0.0, 1.5]), 1e-2, Grid((3, 4), 1e-6)
    monkeypatch.setattr(scanning, "light", flat_light)
    monkeypatch.setattr(scanning, "light_samples", flat_samples)
    found, pixels = way._orders(PLAIN, v, target).error, way._pixels(BENT, grid, target, 0).error
    step, size = grid.step(PLAIN), 2e-8 * PLAIN.layers.wavenumber * 1.4
    if name == "two-photon":
        for made, e in ((found, off(PLAIN, v, target, 1e-6)), (pixels, flat_samples(PLAIN, grid, target).error)):
            assert made == pytest.approx(0.6 * e + e * (0.6 + e) + EPS * 0.36, rel=1e-9, abs=0.0)
        return
    if name == "bead":
        heights, stack, fractions, rule = way._planes(PLAIN, target)
        discs = [samples.disc_means(v, size * math.sqrt(1 - u * u), target) for u in heights]
        e = off(stack, np.concatenate([disc.places for disc in discs]), target, 1e-6).reshape(-1, 2)
        assert fractions.sum(axis=0) == pytest.approx(1.0)
        shares = zip(fractions, discs, e, strict=True)
        assert found == pytest.approx(
            rule + sum(s * (e * disc.gain + disc.error) for s, disc, e in shares), rel=1e-9, abs=0.0
        )
        expected = rule
        for u, share in zip(heights, fractions, strict=True):
            disc = samples.disc_filter(step, size * math.sqrt(1 - u * u), target)
            expected += share * disc.of(flat_samples(PLAIN, disc.samples(grid), target / disc.gain)).error
        assert pixels == pytest.approx(expected, rel=1e-9, abs=0.0)
        return
    area, part, sted = 0.25 * (scanning.AIRY * 1.5) ** 2, way._absorbed_fraction(PLAIN), name == "sted"
    beam, planes = way._absorbed_excitation(PLAIN), replace(PLAIN, layers=VORTEX.layers, emitter=VORTEX.emitter)
    kind, rate, ceiling = 1.0 + PLAIN.scale / BEAM.scale, 3.0 * math.log(2.0), max(1.0, area) * float(part.max())
    outer = samples.disc_means(kind * v, 0.0, 0.1 * target / ceiling)
    at = outer.places / kind if sted else v
    hole = samples.disc_means(at, scanning.AIRY * 1.5, target / area)
    detected = (off(PLAIN, hole.places, target, 1e-6) * hole.gain + hole.error) * area
    excited = off(beam, PLAIN.scale / BEAM.scale * at, target, 1e-6) * part
    both = excited * 0.6 * area + detected * (0.6 * part + excited) + EPS * 0.36 * part * area
    if sted:
        dark = samples.disc_means(PLAIN.scale / VORTEX.scale * v, 0.0, 0.1 * target / rate)
        lost = off(planes, dark.places, target / rate, 1e-6 / rate) * dark.gain + dark.error
        both = both * outer.gain + ceiling * outer.error
        both = both + 0.36 * part * area * (rate * lost + 2.0 * 0.02 * 1e-6)
    assert found == pytest.approx(both, rel=1e-9, abs=0.0)
    disc = samples.disc_filter(step, scanning.AIRY * 1.5, target / area)
    detected = disc.of(flat_samples(PLAIN, disc.samples(grid), target / area / disc.gain)).error * area
    excited = flat_samples(beam, grid, target).error * part
    both = excited * 0.6 * area + detected * (0.6 * part + excited) + EPS * 0.36 * part * area
    if sted:
        left, lost = 2.0 ** (-3.0 * 0.6), rate * flat_samples(planes, grid, target / rate).error
        light = 0.36 * part * area
        both = both * left + lost * (light + both) + EPS * light * left
    assert pixels == pytest.approx(both, rel=1e-6, abs=0.0)


class Stopped(Exception):  # noqa: N818
    pass


@pytest.mark.parametrize("name", ["confocal", "two-photon"])
def test_scanned_light_is_refined_from_a_part_of_what_is_allowed(name, monkeypatch):
    way, asked, grid = replace(KINDS[name], tol=1e-4), [], Grid((3, 4), 1e-6)
    ceiling, kind = way._ceiling(PLAIN), way.stretch(PLAIN)
    tables = []

    def refine(compute, target, *, start, floor, tol):
        asked.append((target, start, floor, tol, *compute(1e-3)))
        raise Stopped

    def orders(self, pupil, v, target):
        tables.append(v)
        return Orders(np.stack([0.5 + 0.0 * v, 0.1 * v])[:, None], target + OFF)

    monkeypatch.setattr(scanning, "refine_until", refine)
    monkeypatch.setattr(type(way), "_orders", orders)
    dark = SampledLight(np.array([[[-0.1, 2.0]], [[0.3, -0.2]]]), OFF)
    monkeypatch.setattr(type(way), "_pixels", lambda self, pupil, grid, target, threads: dark)
    with pytest.raises(Stopped):
        way.profile(PLAIN, np.array([1.0, 2.0]))
    assert asked[-1][:4] == pytest.approx((1e-4, 1e-5, 1e-13, 1e-4), rel=1e-12, abs=0.0)
    assert asked[-1][5] == pytest.approx(1e-3 + OFF, rel=1e-12, abs=0.0)
    for scale, dtype in ((None, np.float64), (1.0, np.float32)):
        wanted = Wanted(scale, np.dtype(dtype))
        allowed = (0.48 if scale is None else 1.0) * (1e-4 - 1.1 * (6 * U + (2.0**-24 if scale else 0.0)))
        with pytest.raises(Stopped):
            way._samples(PLAIN, grid, 1e-4, wanted)
        assert asked[-1][:4] == pytest.approx((allowed, 0.03 * allowed, 1e-13 * ceiling, 1e-4), rel=1e-9, abs=0.0)
        most = np.array([0.5, 0.1 * tables[-1].max()])
        growth = samples.growth() * (1e-3 + OFF + 8 * EPS * most) + 0.25e-3
        assert asked[-1][5] == pytest.approx(growth, rel=1e-9, abs=0.0)
        step = samples.table_step(0.25e-3 / ceiling) / kind
        far = grid._farthest * grid.step(PLAIN)
        assert tables[-1].max() == pytest.approx(max(step * (math.floor(far / step) + 6), 1.8412 if scale else 0.0))
        with pytest.raises(Stopped):
            way._samples(BENT, grid, 1e-4, wanted)
        assert asked[-1][:4] == pytest.approx((allowed, 0.1 * allowed, 1e-13, 1e-4), rel=1e-9, abs=0.0)
        assert asked[-1][4].tolist() == [[[0.0, 2.0]], [[0.3, 0.0]]]
        assert asked[-1][5] is OFF


def test_light_is_asked_for_a_twentieth_of_the_tolerance_and_rounded_by_its_orders(monkeypatch):
    pupil, asked, v = replace(PLAIN, emitter=lm.Dipole(1.2, -2.0)), [], np.array([0.0, 1.0, 2.0])
    made = np.random.default_rng(2).uniform(0.1, 1.0, (2, len(pupil.light.harmonics), 3))
    monkeypatch.setattr(scanning, "profiles", lambda pupil, v, tol: asked.append(tol) or (made, 1e-11 * OFF))
    for accuracy, tol in ((1e-3, 1e-3), (1e-5, 1e-3), (0.0, 1e-12)):
        found = scanning.light(pupil, v, accuracy, tol)
    assert asked == [1e-3, 5e-5, lm.methods.Stratified.least_tol]
    factors = [math.hypot(h.cosine, h.sine) for h in pupil.light.harmonics]
    size = sum(factor * one for factor, one in zip(factors, made.swapaxes(0, 1), strict=True))
    assert found.error == pytest.approx(1e-11 * OFF + EPS * size.max(axis=1), rel=1e-12, abs=0.0)
    monkeypatch.setattr(scanning, "profiles", lambda *_: None)
    monkeypatch.setattr(scanning, "harmonics", lambda pupil, v, tol: (made.swapaxes(0, 1), 2.0 * OFF))
    assert scanning.light(pupil, v, 0.0, 1e-6).values.tolist() == found.values.tolist()


@pytest.mark.parametrize("scale", [None, 0.7])
def test_rings_add_errors_of_fields_of_angles_of_radii_and_of_rounding(scale, monkeypatch):
    seen, images, pupil = [], debye_rings.ringed_images, replace(BENT, emitter=lm.Dipole(0.7, 0.4, wobble=0.3))

    def recorded(sums, *given):
        seen.append((sums, images(sums, *given)))
        return seen[-1][1]

    monkeypatch.setattr(debye_rings, "ringed_images", recorded)
    accuracy = debye_rings.Accuracy(1e-4, 1e-3, 1e-3)
    made = debye_rings.ringed(pupil, Grid((3, 4), 6.5e-6), accuracy, Wanted(scale, np.dtype(np.float64)))
    (sums, found), terms = seen[0], tuple(FIVE.amplitudes().items())
    radial = interpolation.filtered_taps(1.6, 1e-3)
    reach = 0.8 * (sums.bessel.shape[1] - 1)
    depth, focus, model = pupil.depth.ravel(), pupil.focus.ravel(), pupil.light.model
    rule = debye.rule(pupil.layers, model, depth, focus, reach, 1e-4, lambda piece: projection.growth(piece, terms))
    orders, omitted = projection.components(FIVE, terms, rule, 1e-5)
    most, rows = (
        orders.shape[1] // 2 + max(map(abs, pupil.light.waves.orders)),
        debye_rings.squares(pupil.light.waves.form),
    )
    angular = interpolation.circular_taps(2 * most, 2 * sums.angles, 1e-3)
    size = max(np.abs(part).sum() for part in rule.parts)
    field = rule.error + omitted + 64 * math.sqrt(sums.angles) * U * size
    error = 0.0
    for row, square in zip(rows, found.squares, strict=True):
        off = field * np.abs(row).sum() / np.sqrt(pupil.power)
        error = error + off * (2 * np.sqrt(square) / math.cos(math.pi * most / sums.angles) + off)
    sizes = found.sums + np.abs(radial.filter).sum() * found.top
    units = 64 * math.sqrt(2 * sums.angles) + 2 * radial.filter.size + 64
    between = found.aliases + units * U * angular.taps.gain * sizes
    pixels = radial.error + radial.gain * error + radial.taps.gain * between
    peak = np.maximum(found.top - error, found.pixel - pixels)
    assert made.peak == pytest.approx(peak, rel=1e-9, abs=0.0)
    relative = pixels / peak
    if scale is None:
        relative = stored(2 * relative / (1 - relative), np.float64)
    assert made.error == pytest.approx(stored(relative, np.float64), rel=1e-6, abs=0.0)
    monkeypatch.setattr(interpolation, "filtered_taps", lambda band, error: error)
    bands = [debye_rings._radial_taps.__wrapped__(error) for error in (1e-3, 5e-12, 4.9e-12, 1e-14)]
    assert bands == [(1.6, 1e-3), (1.6, 5e-12), (1.1, 4.9e-12), (1.1, 5e-13)]


def test_fields_by_chords_have_errors_of_both_sums_of_rounding_and_of_amplitudes(monkeypatch):
    grid, asked, amplitudes = Grid((4, 5), 6.5e-6), [], projection.amplitudes
    monkeypatch.setattr(projection, "amplitudes", lambda *given: asked.append(given[2]) or amplitudes(*given))
    weights = np.ones((2, 4, 5))
    made = chordal_debye.sums(BENT, grid, 1e-6, weights, 0, chordal_debye.By())
    assert asked == [0.05e-6]
    values, error, largest = chordal_debye.intensities(BENT, grid, 1e-6, 0)
    assert made[0][:, 0] == pytest.approx(values[0].sum(axis=(1, 2)), rel=1e-9, abs=0.0)
    assert made[1] == pytest.approx(largest[0], rel=1e-9, abs=0.0)
    assert made[2] == pytest.approx(error[0], rel=1e-6, abs=0.0)
    found, *_ = chordal_debye.ChordalDebye(1e-3)._refine(BENT, grid, 1e-3, Wanted(1.0), chordal_debye.By())
    assert found.peak == pytest.approx(found.values.max(axis=(1, 2)) - found.error * found.peak, rel=1e-6, abs=0.0)
    axes = Grid((4, 5), 6.5e-6, center=(np.array([1.5, 9.5]), np.array([2.0, 2.5])))
    images, by, errors, tops = chordal_debye.ChordalDebye(1e-3).differentiated(
        BENT, axes, 1e-3, Wanted(1.0), chordal_debye.By((1,))
    )
    assert np.all(np.abs(by).max(axis=(2, 3)) <= tops)
    assert np.all(errors < 0.1 * tops)
    assert np.all(images.bound <= 1e-3)
    assert images.scale.tolist() == [1.0, 1.0]
    assert images.brightest == pytest.approx(images.values.max(axis=(1, 2)), rel=1e-3)
    monkeypatch.setattr(chordal_debye, "error_of_light", lambda *_: np.ones(2))
    made = chordal_debye.sums(BENT, grid, 1e-6, weights, 0, chordal_debye.By())
    assert made[2] * BENT.power == pytest.approx([1.0 + 1e-12] * 2, rel=1e-13, abs=0.0)


class Known(chordal_debye.ChordalDebye):
    def differentiated(self, pupil, grid, tol, wanted, by):
        assert tol == 1e-5
        scale, error, peak = np.array([0.8, 0.9]), np.array([1e-3, 2e-3]), np.array([0.5, 0.6])
        made = Samples(np.full((2, 3, 4), 0.4), scale, error, None, peak)
        return made, np.full((3, 2, 3, 4), 0.2), 1e-12 * np.arange(1.0, 7.0).reshape(3, 2), np.full((3, 2), 0.7)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_derivatives_by_chords_are_divided_scaled_and_offset_with_their_errors(dtype):
    by, steep = slopes.By, debye.steepest(PLAIN.layers, PLAIN.light.model)
    pairs = [(by(0, image_factor=steep[0] * np.array([2.0, -3.0])), steep[0]), (by(1), steep[1] / 3.0)]
    wanted = Wanted(0.8, np.dtype(dtype))
    found = slopes._by_chords(Known(1e-5), PLAIN, Grid((3, 4), 1e-6), pairs, ((2, 2),), 1e-5, wanted)
    storing = 6 * U + (2.0**-24 if dtype is np.float32 else 0.0) + 2.0**-48
    for k, factor in enumerate((1.0, 3.0, 1.0)):
        offset = np.array([2.0, 3.0]) if k == 0 else np.zeros(2)
        e, top = factor * 1e-12 * np.array([2 * k + 1, 2 * k + 2]), factor * 0.7 + 0.0 * offset
        peak, bound = np.array([0.5, 0.6]), np.array([1e-3, 2e-3])
        e = e + offset * (bound + 1e-12) * peak
        top = top + offset * (1 + 2 * bound) * peak
        assert found.slopes.error[k] == pytest.approx((e + storing * top) / peak, rel=1e-13, abs=0.0)
    image = Samples(np.ones((2, 1, 1)), np.array([0.8, 0.9]), np.zeros(2), None, np.array([0.5, 0.6]))
    values = np.array([[[1.0, -3.0]], [[2.0, -0.5]]])
    one = slopes._stored(values, 1e-11 * OFF, image, wanted)
    assert one.error == pytest.approx((1e-11 * OFF + storing * np.array([3.0, 2.0])) / [0.5, 0.6], rel=1e-12, abs=0.0)


def test_the_engine_is_asked_for_larger_tolerances_until_it_answers(monkeypatch):
    grid, asked, made = Grid((3, 4), 1e-6), [], Samples(np.ones(1), np.ones(1), OFF, Slopes(np.ones(1), OFF))

    def differentiated(pupil, grid, by, tol, wanted):
        asked.append(tol)
        return made if tol > 0.9e-4 else None

    monkeypatch.setattr(slopes, "differentiated", differentiated)
    other = Samples(np.zeros(1), np.zeros(1), OFF)
    found = slopes.engine_slopes(PLAIN, grid, (), 1e-6, Wanted(), lambda: other)
    assert asked == pytest.approx([1e-6, 1e-5, 1e-4])
    assert found.values is other.values
    assert found.slopes is made.slopes
    assert slopes.engine_slopes(PLAIN, grid, (), 1e-4, Wanted(), lambda: other) is made
    assert slopes.engine_slopes(PLAIN, grid, (), 1e-6, Wanted(), None) is made
    assert slopes.engine_slopes(PLAIN, grid, (), 1e-8, Wanted(), None) is None
    asked.clear()
    slopes._by_engine(PLAIN, grid, [(slopes.By(engine.BY_FOCUS), 2.0)], 1e-3, Wanted())
    with pytest.raises(Declined):
        slopes._by_engine(PLAIN, grid, [(slopes.By(engine.BY_FOCUS), 2.0)], 1e-15, Wanted())
    assert asked == pytest.approx([1e-3, *(lm.methods.Stratified.least_tol * 10.0**k for k in range(4))])


@pytest.mark.parametrize("names", [("row",), ("z",)])
def test_what_a_wavefront_leaves_out_is_in_images_and_in_derivatives_by_the_axis(names):
    """Twice the field and its gradient, each at most 1, times what is left out."""
    made = []
    for left in (0.0, 1e-5):
        pupil = replace(PLAIN, aberrations=lm.Wavefront.zernike({(2, 2): 0.3}, error=left))
        way, grid = chordal_debye.ChordalDebye(1e-3), Grid((3, 4), 6.5e-6, integrate=False)
        _, images, found = slopes.layered_slopes(way, pupil, grid, names, Wanted(1.0))
        made.append((images, found[0].error))
    more = relative_error(made[0][0].values.reshape(2, -1).astype(float), 1e-5 + np.zeros(2))
    assert made[1][0].error - made[0][0].error == pytest.approx(more, rel=1e-3, abs=0.0)
    if names == ("row",):
        assert made[1][1] - made[0][1] == pytest.approx(
            4e-5 * grid.step(PLAIN) / made[0][0].brightest, rel=1e-3, abs=0.0
        )


def test_plain_quadrature_starts_at_a_fiftieth_and_errs_by_its_farthest_radius(monkeypatch):
    for v in (np.array([0.0, 5.0]), np.array([0.0, 0.3])):
        rule = debye.rule(PLAIN.layers, PLAIN.light.model, PLAIN.depth, PLAIN.focus, v[-1], 1e-4)
        fields = np.abs(debye.fields(rule, PLAIN.light.model, PLAIN.depth, PLAIN.focus, v)).max(axis=2)
        error = sum(debye_wolf._form_error(h, fields, rule.error) for h in PLAIN.light.harmonics) / PLAIN.power
        found = debye_wolf.harmonics(PLAIN, v, 1e-4)[1]
        assert found == pytest.approx(error * (1.0 + 1e-12) + 2.0**-50, rel=2e-13, abs=0.0)
    asked = []
    monkeypatch.setattr(debye_wolf, "_form_error", lambda *_: np.zeros(2))
    assert debye_wolf.harmonics(PLAIN, v, 1e-4)[1].tolist() == [2.0**-50] * 2
    made = np.array([[[1.0, 0.5], [0.7, 2.0]]]), np.zeros(2)
    monkeypatch.setattr(debye_wolf, "harmonics", lambda pupil, v, tol: asked.append(tol) or made)
    assert lm.methods.DebyeWolf(1e-5).profile(PLAIN, v[:1]).values.tolist() == [[1.0], [0.7]]
    assert asked == pytest.approx([2e-7], rel=1e-12, abs=0.0)
