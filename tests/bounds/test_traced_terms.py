"""Terms of the bounds of differentiable PSFs, a second time: docs/certificate.md, "Differentiable PSFs"."""

from __future__ import annotations

import math
from contextlib import nullcontext

import numpy as np
import pytest
import scipy

import lommel as lm
from lommel.methods import hankel
from lommel.methods.paper.fraunhofer import Fraunhofer
from lommel.methods.paper.geometric import Geometric
from lommel.methods.pixel_rule import averaging_error
from lommel.optics.colour.spectrum import Component
from lommel.optics.grid import Grid
from lommel.traced import certificate, chordal, traced_psf
from lommel.traced.chordal import FieldError, PhaseRule
from lommel.traced.namespaces import Namespace
from lommel.traced.traced_psf import Pixels, TracedPSF

NS, U, SINGLE = Namespace.of(None), 2.0**-53, 2.0**-24
TERMS = ((1, 1), (2, 0), (3, 1), (3, -1), (4, 0))
EDGE = np.array([[0.3, 1.0, -0.6, 0.4, 0.5], [-0.2, -0.7, 0.8, 0.1, -0.3]])
MANY = lm.Wavefront.zernike(dict(zip(TERMS, EDGE.T, strict=True)), normalization="edge", error=1e-9)
LIGHT = lm.Apodization([0.5, 0.3], error=3e-10)
ANY = lm.Pupil(MANY, obscuration=0.4, apodization=LIGHT)
RADIAL = lm.Pupil(lm.Wavefront([1.0, -2.0], [0.5, 0.2], error=2e-9), obscuration=0.4, apodization=LIGHT)
BOTH = pytest.mark.parametrize("pupil", [RADIAL, ANY], ids=["radial", "any"])
POWERS = chordal.columns(RADIAL)[1]


class Coarse(Namespace):
    def coarseness(self, unit):
        return 2.0 * unit


COARSE = Coarse("numpy", NS.xp)


def test_errors_of_exponentials_of_intensities_and_of_values_over_their_peak():
    expected = [1.001 * math.exp(-3.0), 1.001 * math.exp(60.0), math.inf]
    assert certificate.exponential(NS, np.array([-3.0, 60.0, 60.1])) == pytest.approx(expected, rel=1e-12, abs=0.0)
    found = certificate.of_intensity(NS, np.array([[0.5, 0.04], [0.2, 0.3]]), np.array([0.1, 0.2]), 1e-3)
    expected = [2 * math.sqrt(m) * e + e * e + 4e-3 * m for m, e in ((0.5, 0.1), (0.3, 0.2))]
    assert found == pytest.approx(expected, rel=1e-12, abs=0.0)
    values, peaks = np.array([[0.2, 3.0], [0.8, 0.1], [0.5, 0.3]]), (3.0, 0.8, 0.5)
    # None; as large as the peak; about a third of it.
    for off, s in (([0.6, 0.05, 0.0], 0.0), ([3.0, 0.2666, 0.1667], 0.02), ([0.999, 0.2667, 0.1666], 0.02)):
        ratios = [e / (peak - e) if e < peak else math.inf for peak, e in zip(peaks, off, strict=True)]
        for divided in (False, True):
            ratios = [2 * r / (1 - r) if r < 0.5 else math.inf for r in ratios] if divided else ratios
            found = certificate.over_peak(NS, values, np.array(off), s, divided=divided)
            assert found == pytest.approx(
                [1.001 * (r + s * (1 + r)) if s else 1.001 * r for r in ratios], rel=1e-12, abs=0.0
            )


def test_averages_and_lattices_add_their_own_errors_and_roundings():
    values, error, rng = np.array([[0.7, 0.2], [0.1, 0.5]]), np.array([1e-3, 2e-3]), np.random.default_rng(1)
    _, found = Pixels(1, 2, True, 1.7, 0.02).means(NS, {"matrix": np.eye(2)}, values, error, 1e-2)
    assert found == pytest.approx(
        1.7 * (error + 4e-2 * values.max(axis=1)) + 0.02 * values.max(axis=1), rel=1e-12, abs=0.0
    )
    values, weights = rng.uniform(size=(2, 18)), rng.uniform(size=(3, 1, 3, 1))
    made, found = Pixels(1, 2, False, 1.0, 0.03, 3).means(NS, {"weights": weights}, values, error, 1e-2)
    means = np.einsum("niab,ab->ni", values.reshape(2, 2, 3, 3), weights[:, 0, :, 0])
    assert made == pytest.approx(means)
    assert found == pytest.approx(error + 0.03 + 18e-2 * means.max(axis=1), rel=1e-12, abs=0.0)


@pytest.mark.parametrize("largest", [0.4, 30.0])
def test_split_phases_are_exact_sums_and_their_rests_round(largest):
    basis, limit = np.array([[0.5, -2.0], [0.1, 0.3], [1.0, 1.5]]), 1.25 * largest + 1.0
    q = max(k for k in range(-9, 30) if limit / math.tau * 2.0**k <= 2.0**23)
    scale = 2.0 ** round(0.5 * math.log2(2.0**q / (limit / 0.3)))  # both parts of the rest are alike
    delta = 2.0 ** -(q + 1) * scale * limit / 0.3 + (2.0 + 0.3 + 1.5) / (2 * math.tau * scale)
    absolute = SINGLE * (math.tau * (2 * 3 + 4) * delta + 3 * math.tau * (0.5 + delta))
    rule, _ = chordal.phase_tables(basis, 4, largest, "float32")
    assert rule[:4] == pytest.approx((scale, U * (3 + 8 + 9), absolute, limit), rel=1e-12, abs=0.0)
    assert chordal.phase_tables(basis, 4, 1e9, "float32")[0].scale == 1.0
    c, size = np.array([[1.0, -2.0], [0.5, 0.1]]), np.array([0.7, 0.9])
    sums = (np.abs(c) @ size) * (1.0 + 1e-5)
    for most in (sums[0], np.nextafter(sums[0], 0.0)):
        rule = PhaseRule(1.0, 3e-3, 4e-3, most, True)
        found = FieldError(1e-3, 1.5, 0.02, 8.0).total(COARSE, rule, {"size": size}, c, np.array([0.1, 0.2]))
        expected = np.array([0.1, 0.2]) + 1.5 * ((3e-3 + 5e-3) * sums + 4e-3 + 16e-3) + 0.02
        assert found == pytest.approx([expected[0] if most == sums[0] else math.inf, expected[1]], rel=1e-12, abs=0.0)


@pytest.mark.parametrize("low", [0.0, 0.16])
def test_nodes_along_the_radius_are_the_fewest_for_the_box_of_a_stack(low):
    pupil, v, steps = lm.Pupil(RADIAL.wavefront, obscuration=low**0.5, apodization=LIGHT), np.linspace(0, 9, 4), 64
    field, tables = chordal.make_radial(pupil, 1.2, v, 1e-5, "float64")
    steps, eta = (64 if low else 32), np.geomspace(2e-3, 4.0, 80)
    t = hankel.ellipses(eta, low, steps)
    basis = 1.2 * np.stack([(2 * t - 1).imag, (t**2 - 0.5).imag])
    size = np.abs(np.einsum("k,kes->es", POWERS.mean(axis=0), basis))
    size += np.einsum("k,kes->es", np.ptp(POWERS, axis=0) / 2, np.abs(basis))
    logs = hankel.between(size, 9.0 * hankel.rise(eta, low, steps), 2, low) + LIGHT.growth(np.cosh(eta), low)
    nodes = min(
        math.ceil((g + math.log(32e5 / 15 * (1 - low) / (1 - math.exp(-2 * e)))) / (2 * e))
        for g, e in zip(logs, eta, strict=True)
    )
    t, w = np.polynomial.legendre.leggauss(nodes)
    t, w = low + 0.5 * (1 - low) * (1 + t), 0.5 * (1 - low) * w
    assert len(tables["table"]) == nodes
    sums = np.abs((w * LIGHT.at(t))[:, None] * scipy.special.j0(np.sqrt(t)[:, None] * v)).sum(axis=0).max()
    light = w @ LIGHT.at(t) * (U * (12 + 3 * 3.0 + 3 * LIGHT.slope) + 1.2 * 2e-9 + 6e-10)
    assert field.error == pytest.approx((U, sums, sums * (nodes + 16) * U + light, 4.0), rel=1e-9, abs=0.0)


def factors(kind, b):
    """Return what multiplies exp(-2 N b) times the integrand, for at least 4 chords."""
    return (1 + math.exp(-4 * b)) / (1 - math.exp(-10 * b)) if kind == "chords" else 32 / 15 / (1 - math.exp(-2 * b))


@pytest.mark.parametrize("error", [2.5e-6, 5e-6])
def test_chords_and_nodes_are_the_fewest_that_means_on_any_curve_allow(error, monkeypatch):
    curves = np.geomspace(0.04, 1.6, 7)
    monkeypatch.setattr(certificate, "CURVES", curves)
    monkeypatch.setattr(chordal, "CURVES", curves)
    window, expected = (np.linspace(-3, 2, 4), np.linspace(-4, 4, 5)), [0]
    disks = [(1.0, LIGHT), (0.4, LIGHT.scaled(0.4))]
    made, tables = chordal.make_chordal(ANY, Grid((4, 5), 0.5), 1.1, window, error, "float64")
    allowed = 0.5 * error
    for kind in ("chords", "nodes"):
        counts = []
        for b in curves.tolist():
            logs = []
            for radius, light in disks:
                mean, own = certificate.mean_on_curve(TERMS, 1.1, window, kind, b, expected[-1], (0, radius))
                # Of any sign: what is summed, and the coefficients, count by their sizes.
                own = {key: table if "constant" in key else np.abs(table) for key, table in own.items()}
                log = mean._replace(unit=U).logarithm(NS, own, kind, np.abs(EDGE))
                log = log + light.growth(np.array(math.cosh(2 * b)))
                logs.append(log + math.log(factors(kind, b) * radius**2) + 0.05)
            log = np.logaddexp(*logs).max()
            count = max(4, 2 * math.ceil((log - math.log(allowed)) / (4 * b))) if log < 40.0 else 999
            counts.append((count, log - 2 * count * b))
        expected.append(min(counts)[0])
        allowed = error - math.exp(min(counts)[1])  # the nodes have what the chords leave
    chords, nodes = expected[1:]
    assert tables["along even"].shape[::2] == (chords, nodes // 2)  # half of the chords of each of two disks
    sums, reach = 4 * np.abs(chordal._rule(chords, nodes, disks, LIGHT)[2]).sum(), math.hypot(3, 4) + 3
    rounding = U * (nodes + 2 * chords + 32 + 40 + 4 * reach + 3 * LIGHT.slope)
    assert made.error == pytest.approx(
        (U, sums, sums * (rounding + 1.1 * MANY.left_out + 6e-10), 8.0), rel=1e-9, abs=0.0
    )
    assert made.mean is not None


def test_without_means_the_largest_integrand_decides_and_makes_the_bound():
    disks, total, curves = [(1.0, LIGHT), (0.4, LIGHT.scaled(0.4))], 0.0, np.geomspace(4e-3, 4.0, 64)
    *counts, mean, tables = chordal.counts_by_largest(TERMS, EDGE, 1.1, disks, (5.0, 3.0), 1e-6)
    assert mean is None
    chosen = [k for k, b in enumerate(curves) if np.isclose(1.1 * math.sinh(b), tables["growth"][0]).any()]
    field = chordal.Chordal(PhaseRule(0.0, 0.0, 0.0, math.inf, True), FieldError(1e-4, 0.0, 0.0, 0.0), (), None, None)
    for kind, v, count in zip(("chords", "nodes"), (5.0, 3.0), counts, strict=True):
        logs, sizes = [], []
        for b in curves.tolist():
            light = max(float(one.growth(np.array(math.cosh(2 * b)))) for _, one in disks) + math.log(1.16)
            logs.append(light + math.log(factors(kind, b)) + v * math.sinh(b))
            # Terms of one degree and order together.
            pairs = zip((1, 2, 4, 3), (*np.abs(EDGE[:, [0, 1, 4]]).T, np.hypot(*EDGE[:, 2:4].T)), strict=True)
            sizes.append(1.1 * sum(w * math.sinh(n * b) for n, w in pairs))
        least = min((g + s.max() - math.log(0.5e-6)) / (2 * b) for g, s, b in zip(logs, sizes, curves, strict=True))
        assert count == max(4, 2 * math.ceil(0.5 * least))
        total += np.exp(np.min([logs[k] + 1.0192 * sizes[k] - 2 * count * curves[k] for k in chosen], axis=0))
    # The same sum, made on the device for the curves that were chosen, with its rounding.
    tables |= {"size": np.zeros(5)}
    assert field._field_error(COARSE, tables, EDGE) == pytest.approx(1.001 * total, rel=1e-9, abs=0.0)


@BOTH
@pytest.mark.parametrize(
    "bounds", [[(2e-4, 2e-4), (9e-5, 8.01e-5), (6.01e-5, 6.01e-5), (6e-5, 6e-5)], [(3e-4, 4e-4)] * 40]
)
def test_a_plan_is_traced_anew_with_a_tenth_of_the_error_until_its_bounds_suffice(pupil, bounds, monkeypatch):
    plan, asked, enough = lm.Plan(3, 0.5, tol=1e-4), [], bounds[-1][0] <= 1e-4
    made = plan.traced(pupil)
    parts = (made._static.lights, made._static.pixels, made.tables)
    monkeypatch.setattr(traced_psf, "_fields", lambda *given: asked.append(given[3]) or parts)
    monkeypatch.setattr(traced_psf, "_largest_bounds", lambda *_: bounds[len(asked) - 1])
    with nullcontext() if enough else pytest.raises(lm.ToleranceError, match=r"the bound is 0\.0003"):
        plan.traced(pupil)
    largest = np.abs(chordal.columns(pupil)[1]).sum(axis=1).max()
    expected = [1e-4 * pupil.amplitude * (0.04 / (2 * largest + 1) if pupil is RADIAL else 0.35)]
    goal = 0.6e-4 if pupil is RADIAL else 0.8e-4
    for _, worst in bounds[:-1]:
        if worst > goal and expected[-1] > 2.0**-52:
            less = 0.1 if pupil is RADIAL else max(0.1, 0.9 * goal / worst)
            expected.append(max(2.0**-52, less * expected[-1]))
    assert asked == pytest.approx(expected, rel=1e-9, abs=0.0)
    for member in (1e-4, 1.01e-4):
        monkeypatch.setattr(traced_psf, "_largest_bounds", lambda *_, member=member: (member, 1e-5))
        with nullcontext() if member == 1e-4 else pytest.raises(lm.ToleranceError):
            plan.traced(pupil)


@BOTH
def test_averages_and_colours_have_their_share_of_the_error(pupil, monkeypatch):
    monkeypatch.setattr(chordal, "_MAX_MEAN_DEGREE", 0)
    grid, components = (
        Grid((3, 4), 0.5, center=(0.0, 2.0), integrate=True),
        [Component(0.7, 1.0, pupil), Component(2.0, 1.3, pupil)],
    )
    width = 1.3 * grid.step(pupil)
    error = 1.01 * averaging_error(width, 6) / pupil.amplitude
    assert averaging_error(width, 5) > error / pupil.amplitude**0.1
    for factor, count in ((1.0, 6), (0.98, 7)):
        lights, image, tables = traced_psf._fields(pupil, grid, components, factor * error, "float64")
        assert (image.samples, image.added) == (count, averaging_error(width, count))
    assert traced_psf.on_lattice(grid, grid.step(pupil), 1.3, averaging_error(width, 6))[0].samples == 6
    terms, c = chordal.columns(pupil)
    for scale in (None, 3.0):
        static = traced_psf.Static(NS, terms, (), (), lights, image, scale, 1e-4, "float64", "float32", None)
        values, bound = TracedPSF(static, tables).evaluated(c)
        total, error = 0.0, 0.0
        for weight, (_, field), own in zip((0.7, 2.0 * 1.3**2), lights, tables, strict=True):
            light, off = field.intensity(NS, own, c)
            total, error = total + weight * light, error + weight * certificate.of_intensity(NS, light, off, U)
        total, error = image.means(NS, tables[0], total, error, U)
        assert values == pytest.approx(total / total.max(axis=1, keepdims=True) if scale is None else 3.0 * total)
        expected = certificate.over_peak(NS, total, error, 8 * U + SINGLE, divided=scale is None)
        assert bound == pytest.approx(expected, rel=1e-9, abs=0.0)


def test_an_image_whose_bound_is_the_tolerance_is_proven_and_none_beyond(monkeypatch):
    made = lm.Plan(3, 0.5, tol=1e-4).traced(RADIAL)
    bound = made.error(POWERS)
    worst, at = float(bound.max()), int(bound.argmax())
    assert np.isfinite(TracedPSF(made._static._replace(tol=worst), made.tables)(POWERS)).all()
    beyond = TracedPSF(made._static._replace(tol=float(np.nextafter(worst, 0.0))), made.tables)
    assert np.isfinite(beyond(POWERS, check=False)).all(axis=(1, 2)).tolist() == [at != 0, at != 1]
    with pytest.raises(
        lm.ToleranceError, match=rf"coefficients at \({at},\).*traced for -2 to 1\), spher.* 0.2 to 0.5"
    ):
        beyond(POWERS)
    for factor in (0.01, 3.0):
        monkeypatch.setattr(traced_psf, "_pupils_between", lambda c, boxed, factor=factor: factor * c)
        between = float(made.error(factor * POWERS).max())
        found = traced_psf._largest_bounds(made._static, made.tables, POWERS)
        assert found == pytest.approx((worst, max(worst, between)), rel=1e-9, abs=0.0)
        assert (between > worst) == (factor > 1)


def test_plans_are_traced_for_methods_that_keep_a_tolerance_at_points_of_a_round_aperture():
    m, pupil = lm.methods, lm.Pupil(lm.Wavefront(1.0), wavelength=5e-7, f_number=4.0)
    for method in (m.NijboerZernike(), m.ChordalGauss(), m.Polychromatic([5e-7], [1.0], m.ChordalGauss())):
        assert len(traced_psf._spectral_components(pupil, method)) == 1
    for method in (m.Hankel(), Geometric(), m.NonuniformFFT(), m.Polychromatic([5e-7], [1.0], Fraunhofer())):
        with pytest.raises(ValueError, match="method must be None"):
            traced_psf._spectral_components(pupil, method)
