"""Terms of the bounds of blurred images, a second time, number by number: docs/certificate.md, section 17."""

from __future__ import annotations

import cmath
import math
from types import SimpleNamespace

import mpmath as mp
import numpy as np
import pytest
import scipy

import lommel as lm
from lommel import methods
from lommel.blur import convolution, recorded, transfer_integral
from lommel.blur.convolution import Gate, Halo, Short
from lommel.blur.recorded import Band, Request
from lommel.blur.transfer_integral import ETAS, Fading, Karman, Part, Slopes, Summed, TransferIntegral, parts
from lommel.core.answers import Samples, Wanted
from lommel.optics.colour.spectrum import Component
from lommel.optics.grid import Grid

ETA = ETAS.tolist()
U = 2.0**-53
ZERNIKE = lm.Pupil(lm.Wavefront([3.0, -2.0], 1.5), obscuration=0.3, apodization=0.7)
AIR = (lm.Seeing(0.2), lm.Seeing(0.3, outer_scale=2.0), lm.Jitter(0.4))


def fewest(log_size, allowed, etas=ETA):
    """Return the fewest Gauss nodes, two at least, with a small 4 M rho^(1 - 2 n) / (rho - 1) on some ellipse."""
    n = 2
    while min(
        math.log(4.0) + m + (1 - 2 * n) * e - math.log(math.expm1(e)) for m, e in zip(log_size, etas, strict=True)
    ) > math.log(allowed):
        n += 1
    return n


@pytest.mark.parametrize("allowed", [1e-2, 1e-9])
def test_gauss_nodes_are_the_fewest_whose_error_is_small(allowed):
    for rate in (0.1, 3.0, 40.0):
        log_size = rate * np.sinh(ETAS)
        assert transfer_integral.gauss_nodes(log_size, np.array(allowed)) == fewest(log_size, allowed)


def growths(distance, slopes):
    """Return bounds on gradient, second derivative and log amplitude of a phase sum of c_n P_n(2 r^2 - 1)."""
    t = distance * (2.0 + distance)
    power = np.polynomial.Polynomial(np.polynomial.legendre.leg2poly(slopes.terms))
    first, second = 2.0 * power.deriv()(1.0 + 2.0 * t), 4.0 * power.deriv(2)(1.0 + 2.0 * t)
    light = 0.0 if slopes.light.uniform else float(slopes.light.growth(np.array(1.0 + 2.0 * t)))
    return 2 * (1 + distance) * first, 2.0 * first + 4 * (1 + distance) ** 2 * second, light


@pytest.mark.parametrize("pupil", [ZERNIKE, lm.Pupil(lm.Wavefront(2.0, 1.0))])
@pytest.mark.parametrize("distance", [0.0, 0.3, 2.0])
def test_slopes_are_largest_at_the_end_of_an_ellipse(pupil, distance):
    found = [float(one) for one in Slopes.of(pupil).at(np.array(distance))]
    assert found == pytest.approx(growths(distance, Slopes.of(pupil)), rel=1e-12, abs=0.0)


@pytest.mark.parametrize(("x", "radius"), [(0.5, 0.0), (0.4 + 0.2j, 0.1), (0.9 + 0.1j, 0.02)])
def test_the_transfer_function_on_a_disc_is_below_its_bound_and_equal_in_the_middle(x, radius):
    fading, end = Fading.of(AIR[:1] + AIR[2:], 1.3, 550e-9), 0.4
    size = abs(x) + radius
    k, g = fading.kolmogorov, fading.gauss
    expected = -k * end ** (5 / 3) * ((x**5).real - (size**5 - abs(x) ** 5))
    expected -= g * end**2 * ((x**6).real - (size**6 - abs(x) ** 6))
    assert float(fading.log_bound(np.array(x), np.array(radius), end)) == pytest.approx(expected, rel=1e-12, abs=0.0)
    rim = [x + radius * cmath.exp(1j * angle) for angle in np.linspace(0, 2 * math.pi, 33)]
    assert max((-k * end ** (5 / 3) * at**5 - g * end**2 * at**6).real for at in rim) <= expected + 1e-12


@pytest.mark.parametrize(("z", "largest"), [(1.0, 1.0), (1.5 + 0.5j, 2.0), (3.0 + 1j, 4.0), (9.0 + 0.3j, 9.5)])
def test_karmans_function_on_a_disc_is_above_its_bound(z, largest):
    nu, size = mp.mpf(5) / 6, 0.7
    c = mp.pi / (2 * mp.sin(nu * mp.pi))
    limit = size * mp.gamma(nu) * 2 ** (nu - 1)

    def half(at):
        return limit - size * at**nu * mp.besselk(nu, at)

    def absolute(at):
        return size * c * at**nu * (mp.besseli(nu, at) + mp.besseli(-nu, at)) - size * c * 2**nu / mp.gamma(1 - nu)

    z, largest = mp.mpmathify(z), mp.mpf(largest)
    real = z.real - (largest - abs(z))
    candidates = [limit * (1 - (largest / real) ** nu)] if real > 0 else [-mp.inf]
    if largest <= 4:
        candidates.append(mp.re(half(z)) - (absolute(largest) - absolute(abs(z))))
    place, most = np.array(complex(z)), np.array(float(largest))
    found = float(Karman(size, 1.0).least(place, place ** (5 / 3), most))
    assert found == pytest.approx(float(max(candidates)), rel=1e-9, abs=0.0)
    rim = [z + (largest - abs(z)) * mp.expjpi(2 * mp.mpf(j) / 24) for j in range(24)]
    assert found <= min(mp.re(half(at)) for at in rim) + 1e-12


def test_what_remains_of_a_transfer_function_is_summed_from_the_left_ends_of_steps():
    fading = Fading.of(AIR, 1.0, 550e-9)
    steps = np.array([0.1, 0.2, 0.4, 0.5])
    at = fading.at(steps)
    boxes = [0.5 * at[k] * (steps[k + 1] ** 2 - steps[k] ** 2) for k in range(3)]
    sums = [sum(boxes[k:]) for k in range(4)]
    assert fading.remaining(steps) == pytest.approx(sums, rel=1e-12, abs=0.0)
    for k in range(4):
        assert fading.end(sums[k] * (1.0 + 1e-9), steps) == (steps[k], pytest.approx(sums[k]))
    assert fading.end(fading.remaining(steps)[2], steps)[0] == steps[2]
    first = transfer_integral._STEPS
    assert fading.light == pytest.approx(fading.remaining(first)[0] + 0.5 * first[0] ** 2)
    assert fading.light > scipy.integrate.quad(lambda f: float(fading.at(np.array([f]))[0]) * f, 0.0, 1.0)[0]


def lens_bound(part, slopes, last, distance):
    ratio = (last + distance) / part.radius
    if ratio >= 1.0:
        return math.inf
    root = (1.0 - ratio**2) ** -0.5
    d = root * distance / part.radius
    shift = math.hypot(math.cosh(d) * root + 1.0, math.cosh(d) * root)
    gradient, second, growth = growths((shift + 1.0) * distance, slopes)
    size = 4.0 * part.radius**2 * (math.pi / 2 + d) * math.cosh(d) * (math.cosh(d) + ratio)
    return math.log(size) + distance * (2 * (last + distance) * second * shift + 2 * gradient) + 2 * growth


@pytest.mark.parametrize(("last", "distance"), [(0.1, 0.05), (0.2, 0.0), (0.05, 0.3), (0.9, 0.2)])
def test_parts_of_the_autocorrelation_are_below_their_bounds(last, distance):
    slopes = Slopes.of(ZERNIKE)
    for part in parts(ZERNIKE):
        found = float(part.log_bound(slopes, np.array(last), np.array(distance)))
        if part.kind == "lens":
            expected = lens_bound(part, slopes, last, distance)
        else:
            gradient, _, growth = growths(2.0 * distance, slopes)
            expected = math.log(2.0 * math.pi * part.radius**2) + 2.0 * distance * gradient + growth
        assert found == pytest.approx(expected, rel=1e-12, abs=0.0)


@pytest.mark.parametrize(("low", "high"), [(0.0, 0.1), (0.1, 0.25), (0.2, 0.3)])
@pytest.mark.parametrize("allowed", [1e-3, 1e-8])
def test_nodes_of_parts_are_those_of_their_ellipses(low, high, allowed):
    slopes = Slopes.of(ZERNIKE)
    lens, disc, _ = parts(ZERNIKE)
    a, middle = 1.0, min(max(0.5, low), high)
    opening = math.acos(low / a)
    line, angle, radial, turned = [], [], [], []
    for e in ETA:
        _, second, growth = growths((a - low) * math.sinh(e), slopes)
        line.append(math.sinh(e) * 2.0 * middle * (a - middle) * second + 2.0 * growth)
        turn = 0.5 * opening * math.sinh(e)
        stretch = math.sqrt(math.cosh(2.0 * turn)) if turn < 300 else math.inf
        if math.isfinite(stretch):
            _, second, growth = growths(a * turn * stretch, slopes)
            log = math.log(math.cosh(turn) * (math.cosh(turn) + 1.0)) + turn * 2 * high * second * a * stretch
            angle.append(log + 2 * growth)
        eps, d = disc.radius, 0.5 * math.sinh(e)
        _, second, growth = growths(eps * d, slopes)
        radial.append(d * 2.0 * high * second * eps + 2.0 * growth + math.log1p(d))
        stretch = math.sqrt(math.cosh(2.0 * e))
        _, second, growth = growths(eps * e * stretch, slopes)
        turned.append(e * 2.0 * high * second * eps * stretch + 2.0 * growth)
    half = 0.5 * allowed
    expected = fewest(line, half / (2 * math.pi)), fewest(angle, half / (4.0 * opening), ETA[: len(angle)])
    assert lens.counts(slopes, low, high, allowed) == expected
    quarter = 0.25 * allowed / (2.0 * math.pi * eps**2)
    around = min(
        (math.log(2.0) + m - math.log(2.0 * min(quarter, 0.05)) + 0.1) / e for m, e in zip(turned, ETA, strict=True)
    )
    assert disc.counts(slopes, low, high, allowed) == (fewest(radial, quarter), 2 * max(1, math.ceil(0.5 * around)))


@pytest.mark.parametrize(
    ("part", "end"), [(Part("lens", 0.6, 0.6), 0.6), (Part("lens", 1.0, 1.0), 0.3), (Part("disc", 0.3, 0.35), 0.35)]
)
def test_panels_end_where_a_lens_is_small_and_halve_towards_its_branch_point(part, end):
    allowed, rate = 1e-6, 90.0
    edges, cut = transfer_integral._edges(part, end, rate, allowed)
    near = end > 0.7 * part.end and part.kind == "lens"
    least = 2.0 ** math.floor(0.4 * math.log2(allowed / 15.0 / part.radius**4)) if near else 0.0
    last = part.end * (1.0 - least) if near else end
    assert edges[-1] == pytest.approx(last, rel=1e-14, abs=0.0)
    assert cut == pytest.approx(32 * math.sqrt(2.0) / math.pi * part.radius**4 * least**2.5, rel=1e-12, abs=0.0)
    assert cut <= allowed
    # The integral that is left out: areas of lenses times (8 / pi) f df.
    f = np.linspace(last, part.end, 2001)
    area = 2.0 * part.radius**2 * np.arccos(np.minimum(f / part.radius, 1.0)) - 2.0 * f * np.sqrt(
        np.maximum(part.radius**2 - f * f, 0.0)
    )
    if near:
        assert np.trapezoid(8.0 / math.pi * area * f, f) <= cut
    even = set(np.linspace(0.0, last, max(2, math.ceil(2.0 * last * rate / 40.0)) + 1))
    halving = {part.end * (1.0 - 0.5**k) for k in range(60)} if near else set()
    assert set(edges) == even | {at for at in halving if 0.0 < at < last}


def test_nodes_over_frequencies_are_those_of_discs_around_ellipses():
    fading, slopes, part = Fading.of(AIR, 1.0, 550e-9), Slopes.of(ZERNIKE), parts(ZERNIKE)[0]
    edges, v, allowed = np.array([0.0, 0.1, 0.3]), 20.0, 1e-6
    made = list(transfer_integral._panels(fading, part, slopes, edges, v, allowed))
    etas = [e for e in ETA if 0.1 < e < 3.0]
    for k, (f, _, low, high) in enumerate(made):
        assert (low, high) == (edges[k], edges[k + 1])
        a, b = np.cbrt(edges[k : k + 2] / 0.3)
        logs = []
        for e in etas:
            angle = math.pi / 64 * (np.arange(64) + 0.5)
            x = 0.5 * (a + b) + 0.5 * (b - a) * np.cosh(e + 1j * angle)
            radius = 0.5 * (b - a) * math.cosh(e) * 0.5 * math.pi / 64
            at, change = 0.3 * x**3, 0.3 * ((abs(x) + radius) ** 3 - abs(x) ** 3)
            distance = abs(at - np.clip(at.real, 0.0, high)) + change
            log = fading.log_bound(x, np.full(64, radius), 0.3) + part.log_bound(slopes, np.array(high), distance)
            log += 2.0 * v * (abs(at.imag) + change) + np.log(24 / math.pi * 0.09 * (abs(x) + radius) ** 5)
            logs.append(float(np.where(np.isnan(log), np.inf, log).max()))
        usable = [(m, e) for m, e in zip(logs, etas, strict=True) if math.isfinite(m)]
        assert len(f) == fewest([m for m, _ in usable], allowed / 2 / (b - a), [e for _, e in usable])


def test_a_rule_divides_its_error_among_its_parts():
    fading, slopes, pieces = Fading.of((lm.Seeing(0.1),), 1.0, 550e-9), Slopes.of(ZERNIKE), tuple(parts(ZERNIKE))
    made = transfer_integral.rule(fading, pieces, slopes, 1e-7, 30.0, 1e-5)
    end, tail = fading.end(1e-7)
    assert (made.end, made.tail) == (end, tail)
    each = 1e-5 / 3
    cuts = [
        transfer_integral._edges(p, min(end, p.end), 30 + 2 * growths(0.0, slopes)[0], 0.1 * each) for p in pieces
    ]
    assert made.error == pytest.approx(0.9e-5 + sum(cut for _, cut in cuts), rel=1e-12, abs=0.0)
    node = 0.25 * each * math.pi / (8.0 * fading.light)
    counted = [(part, tuple(panel.counts)) for panel in made.panels for part in [panel.part]]
    expected = [
        (part, part.counts(slopes, low, high, node))
        for part, (edges, _) in zip(pieces, cuts, strict=True)
        for _, _, low, high in transfer_integral._panels(fading, part, slopes, edges, 30.0, 0.65 * each)
    ]
    assert counted == expected


def test_rounding_of_an_autocorrelation_and_of_its_sums():
    terms = np.abs(ZERNIKE.radial_terms())
    size, slope = terms.sum(axis=1).max(), float(ZERNIKE.illumination.slope)
    expected = U * (4.0 * (terms.shape[1] + 10) * size + 6.0 * slope + 123 + 60)
    assert transfer_integral.rounding(ZERNIKE, 123) == pytest.approx(expected, rel=1e-12, abs=0.0)
    summed = Summed(np.array([0.1, 0.4]), np.array([[1.0, -2.0], [0.5, 0.5]]), 9.0, 1.0, 0.0, 0.0, 1e-10)
    assert summed.size == 3.0
    assert summed.rounding(7.0) == pytest.approx(1e-10 + U * (2 + 60 + 4 * 0.4 * 7.0), rel=1e-12, abs=0.0)


@pytest.mark.parametrize(("tol", "errors"), [(1e-3, [4e-5, 4e-5]), (2e-4, [0.7, 3e-3, 1e-3, 5e-5])])
def test_an_image_by_quadrature_is_off_by_all_that_its_sum_is_and_is_tried_again(tol, errors, monkeypatch):
    pupil = lm.Pupil(lm.Wavefront(1.0, error=1e-6), obscuration=0.3, apodization=lm.Apodization([0.4], error=2e-6))
    way, asked = TransferIntegral(tol, (lm.Seeing(0.2),)), []

    def summed(self, pupil, fading, v_max, allowed):
        asked.append(allowed)
        return Summed(
            np.array([0.1, 0.2]),
            np.array([[0.5, 0.25], [0.9, 0.6]]),
            v_max,
            allowed,
            errors[len(asked) - 1],
            1e-6,
            3e-9,
        )

    monkeypatch.setattr(TransferIntegral, "_summed", summed)
    found = way.profile(pupil, np.array([0.0, 3.0]))
    left = pupil.left_out[0] + 2.0 * pupil.left_out[1]
    light = pupil.transmission
    v_max = float(pupil.v(pupil.geometric_radius()).max()) + 4.0
    rest = 8.0 * light * 1e-6 + 1.5 * (left * (2.0 + left) + 3e-9 + U * (2 + 60 + 0.8 * max(v_max, 3.0)))
    off = [(error + rest) / (0.75 - error - rest) for error in errors]
    used = next(k for k, one in enumerate(off) if one <= tol)
    assert len(asked) == used + 1
    assert found.error[0] == pytest.approx(off[used], rel=1e-9, abs=0.0)
    assert found.peak == pytest.approx([peak - errors[used] - rest for peak in (0.75, 1.5)], rel=1e-12, abs=0.0)
    fading = way.fading(pupil)
    likely = light / (light / pupil.likely_peak + 1.0 / (8.0 * fading.light))
    allowed = 0.12 * tol * likely
    for k, one in enumerate(asked):
        assert one == 2.0 ** math.floor(math.log2(allowed))
        allowed *= 0.5 * max(tol / off[k], 1e-4)
    assert way._allowed_tail(pupil) == pytest.approx(0.02 * tol * likely / (8 * light), rel=1e-12, abs=0.0)
    ceiling = (1 + 2 * tol) * min(pupil.amplitude**2, 8.0 * light * fading.light)
    assert way._ceiling(pupil) == pytest.approx(ceiling, rel=1e-12, abs=0.0)


GATE = Gate.of(0.8, 1e-7)


def test_a_gate_is_one_in_the_band_and_nothing_beyond_its_cutoff():
    cutoff = 2.0 * math.pi / GATE.h - 2.0
    w = np.array([0.0, 2.0, 0.5 * (2.0 + cutoff), cutoff, 9.0])
    found = 0.5 * scipy.special.erfc((w - GATE.middle) / GATE.width)
    assert found[1] == pytest.approx(1.0 - 0.25e-7, abs=1e-12)
    assert found[3] == pytest.approx(0.25e-7, rel=1e-3, abs=0.0)
    assert convolution._gated(w, GATE)[2] == pytest.approx(0.5)
    rounded = GATE.round(np.array([2.0, cutoff]))
    assert 1.0 - rounded[0] == pytest.approx(rounded[1], rel=1e-6, abs=0.0)
    assert 0.0 < rounded[1] <= GATE.error
    assert GATE.round(np.array([GATE.end]))[0] == pytest.approx(0.0, abs=1e-30)
    assert GATE.round(np.array([0.98 * GATE.end]))[0] > 1e-30


def test_samples_beyond_the_truncation_of_a_gate_sum_to_less_than_they_are_said_to():
    distance, cut = convolution.ends(GATE)
    s = GATE.width / math.sqrt(2.0)
    inner = distance - GATE.h
    log = -math.log(GATE.error)
    assert inner == pytest.approx(math.sqrt(2.0 * (log - math.log(log + 1.0))) / s, rel=1e-12, abs=0.0)
    assert cut == pytest.approx(float(mp.e1(0.5 * (s * inner) ** 2)) / math.pi, rel=1e-9, abs=0.0)
    for offset in (0.0, 0.3):
        x = distance + GATE.h * (np.arange(400) + offset)
        assert 2.0 * GATE.h * np.abs(convolution._gate_transform(x, GATE)).sum() <= cut


@pytest.mark.parametrize("active", [0.0, 0.9])
def test_a_readout_errs_by_gate_truncation_and_rounding(active):
    places = (0.1, 1.0, 2.3)
    made = convolution.readout(places, active, GATE)
    truncation, cut = convolution.ends(GATE)
    taps = 2 * math.ceil((truncation + 0.5 * active) / GATE.h) + 1
    assert made.error == pytest.approx(GATE.error + cut + 2.0**-50 * math.sqrt(taps), rel=1e-12, abs=0.0)
    assert made.gain == pytest.approx(np.abs(made.matrix.toarray()).sum(axis=1).max(), rel=1e-12, abs=0.0)
    assert (made.low, made.high) == pytest.approx((0.1 - active / 2, 2.3 + active / 2))
    assert made.ends(0.5) == pytest.approx((min(0.1 - active / 2 - 0.5, 0.0), 2.3 + active / 2 + 0.5))
    k = made.first + np.arange(made.samples)
    for w in np.linspace(0.0, 2.0, 21):
        wave = np.exp(1j * w * np.array(places)) * np.sinc(0.5 * w * active / math.pi)
        assert np.abs(made.matrix @ np.exp(1j * w * GATE.h * k) - wave).max() <= 1.0001 * made.error
    gained = convolution.gained(GATE)
    far = np.abs(convolution.readout(tuple(np.linspace(0.0, GATE.h, 400)), 0.0, GATE).matrix).sum(axis=1).max()
    assert far <= gained <= 1.03 * far


def test_short_blur_reaches_as_far_as_its_deviations_and_half_of_its_streaks():
    short = Short.of((lm.Jitter(0.5, 0.2), lm.Motion(3.0, 0.4)), 1.0)
    left = 1e-6
    quantile = float(mp.findroot(lambda q: mp.erfc(q / mp.sqrt(2)) - 0.5 * left, 5))
    streak = 0.5 * math.pi * 3.0 * np.abs([math.cos(0.4), math.sin(0.4)])
    assert short.reach(left) == pytest.approx(quantile * math.pi * np.array([0.5, 0.2]) + streak, rel=1e-9, abs=0.0)


def test_the_density_of_shifts_beyond_a_radius_is_below_its_bound():
    halo = Halo.of((lm.Seeing(0.3),), 1.0, 550e-9, GATE)
    for radius in (8.0, 30.0, 90.0):
        # b is the transform of T; it decreases.
        w = np.linspace(0.0, 12.0, 60_001)
        b = np.trapezoid(halo.response(w) * scipy.special.j0(radius * w) * w, w) / (2.0 * math.pi)
        assert b <= halo.bound(radius) <= 1.2 * b + 1e-12
    inner = 30.0 - 7.5
    norm, tail = convolution._gate_norm(GATE, 7.5)
    assert halo.gated_bound(30.0) == pytest.approx(norm * halo.bound(inner) + tail, rel=1e-12, abs=0.0)
    assert 1.0 < norm < 5.0


def test_a_spread_counts_what_its_table_and_its_reaches_leave_out():
    halo, none = Halo.of((lm.Seeing(0.3),), 1.0, 550e-9, GATE), Short.of((), 1.0)
    short = Short.of((lm.Jitter(0.4),), 1.0)
    error, gained, cut = GATE.error, convolution.gained(GATE), convolution.ends(GATE)[1]
    outside = 2.0 * gained * (error * gained + 2.0 * cut)
    for ended in (False, True):
        for one, wide in ((short, Halo.of((), 1.0, 550e-9, GATE)), (none, halo), (short, halo)):
            made = convolution.spread(one, wide, (60, 64), 20.0, ended=ended)
            sharp, still = one.nothing, not wide.several
            kernel = scipy.fft.irfft2(made.response, made.size)
            assert made.gain == pytest.approx(np.abs(kernel).sum(), rel=1e-9, abs=0.0)
            assert made.norm == pytest.approx(math.sqrt((kernel**2).sum()), rel=1e-9, abs=0.0)
            assert made.error == pytest.approx(
                (0.0 if sharp else 3.0 * error) + (0.0 if still else error), rel=1e-12, abs=0.0
            )
            assert made.outside_sum == (0.0 if sharp else pytest.approx(outside, rel=1e-12, abs=0.0))
            if still:
                assert made.missing == made.off == made.core == 0.0
                continue
            table, table_error = convolution._kernel(wide, made.size)
            core, first = table.max() / GATE.h**2, 1.0
            if not sharp:
                alone = convolution.spread(one, Halo.of((), 1.0, 550e-9, GATE), (60, 64), 20.0, ended=ended)
                first = alone.gain
            assert made.core == pytest.approx(core, rel=1e-12, abs=0.0)
            assert made.off == pytest.approx(first * table_error * core, rel=1e-9, abs=0.0)
            density = wide.bound(20.0) + (0.0 if sharp else error * core)
            if not ended:
                density = first * wide.gated_bound(20.0) + (0.0 if sharp else outside) * core
            assert made.missing == pytest.approx(density, rel=1e-9, abs=0.0)
            samples = np.ones((2, 5, 5))
            assert made.rounding(samples) == pytest.approx(20 * math.log2(math.prod(made.size)) * U * made.norm * 5.0)


def test_the_error_of_a_table_of_a_halo_is_a_tenth_of_that_of_the_gate():
    halo = Halo.of((lm.Seeing(0.3),), 1.0, 550e-9, GATE)
    peak = float(halo.at(np.zeros(1))[0])
    table, error = convolution._kernel(halo, (40, 36))
    assert error <= max(0.1 * GATE.error / peak, 1e-12)
    r = GATE.h * np.hypot(*np.ogrid[:15, :15])
    assert np.abs(table[:15, :15] / GATE.h**2 - halo.at(r.ravel()).reshape(r.shape)).max() <= 1.01 * error * peak


@pytest.mark.parametrize("shared", [False, True])
def test_a_band_ends_where_all_that_remains_is_small(shared):
    blurs, error, light = (lm.Seeing(0.05),), 1e-6, ZERNIKE.transmission
    fading = Fading.above(blurs, ZERNIKE.scale, None)
    share, tail = fading.end(error * ZERNIKE.amplitude**2 / (8.0 * light), transfer_integral.FURTHER)
    if shared:
        share = 2.0 ** (math.ceil(8.0 * math.log2(share)) / 8.0)
    found = Band.of(ZERNIKE, blurs, error, shared=shared)
    assert found == pytest.approx(
        (share, 8 * light * tail, 4 * light * share**2, 8 * light * fading.light), rel=1e-12
    )
    assert found.ended
    wide = Band.of(ZERNIKE, (lm.Jitter(0.01),), error, shared=shared)
    assert (wide.share, wide.tail, wide.ended) == (1.0, 0.0, False)


def test_blur_above_others_is_no_narrower_than_the_narrowest_direction():
    both = Fading.above((lm.Jitter(0.5, 0.2, 0.3), lm.Motion(2.0), lm.Jitter(0.1)), 1.0, None)
    assert both.gauss == pytest.approx(2.0 * math.pi**2 * (0.2**2 + 0.1**2), rel=1e-6, abs=0.0)
    assert both.gauss <= 2.0 * math.pi**2 * 0.05


def lattice(gate, kernel, **changes):
    gathers = (recorded.Gather(None, 0, 1e-4, 1.3, 1.2), recorded.Gather(None, 0, 3e-4, 1.1, 1.4))
    return recorded.Lattice(0.4, 0.5, (0, 0), (9, 8), gathers, 2e-5, gate, kernel)._replace(**changes)


@pytest.mark.parametrize("seeing", [False, True])
@pytest.mark.parametrize("ended", [False, True])
def test_a_blurred_image_is_off_by_the_budget_of_the_certificate(seeing, ended, monkeypatch):
    """Every part of the error of images on a lattice, with numbers that differ from each other."""
    rows, columns = (
        convolution.readout(places, 0.9, Gate.of(0.8, e)) for places, e in (((2.0, 3.0), 1e-3), ((2.0,), 1e-4))
    )
    spread = convolution.spread(
        Short.of((lm.Jitter(0.4),), 1.0),
        Halo.of((lm.Seeing(0.3),) if seeing else (), 1.0, 550e-9, GATE),
        (60, 64),
        20.0,
        ended=ended,
    )._replace(error=2e-4, missing=3e-6, off=4e-6, outside_sum=5e-5, gain=1.7)
    band = Band(0.4 if ended else 1.0, 6e-5, 0.3, 0.2)
    side = max(rows.samples, columns.samples) + 4
    samples = np.random.default_rng(0).random((2, side, side)) * 1e-3
    first = tuple(
        recorded.Gather(None, one.first - 2, *rest)
        for one, rest in ((rows, (1e-4, 1.3, 1.2)), (columns, (3e-4, 1.1, 1.4)))
    )
    made = lattice(GATE, spread, gathers=first, counts=(side, side))
    off = np.array([1e-6, 2e-6])
    monkeypatch.setattr(recorded, "_on_lattice", lambda *_: (methods.NijboerZernike(), samples, off))
    found = recorded._block_images(Request(None, 1, 1e-6, 1e-6, 0.0), ZERNIKE, band, made, (rows, columns))
    peak, light = ZERNIKE.amplitude**2, 4.0 * math.pi * ZERNIKE.transmission * band.share**2
    down, across = first
    by_light = seeing and ended
    unblurred, blurred = (band.clear, band.blurred) if by_light else (min(band.clear, peak), min(band.blurred, peak))
    gain, gather = rows.gain * columns.gain, down.gain * across.gain
    response = ((1 + rows.error) * (1 + columns.error) - 1) * blurred
    gathering = (1 + down.error) * (1 + across.error) - 1
    most = light * spread.core * gather if by_light else peak * down.sums * across.sums
    total = spread.error * unblurred + gathering * (band.blurred + spread.error * band.clear)
    total += (
        most * (spread.outside_sum + U * 2 * side * max(1.0, spread.gain)) + peak * made.outside_sum * spread.gain
    )
    response += gain * (total + light * gather * spread.off) + band.tail * (1 + gain * gather)
    coarse = made.gather(samples, 1)
    assert found.response == pytest.approx(
        np.full(2, 1.0001 * response + gain * spread.rounding(coarse)), rel=1e-9, abs=0.0
    )
    area = made.h**2 * side * side
    inside = made.h**2 * samples.sum(axis=(1, 2)) - area * off
    missing = spread.missing * np.clip(light - inside, 0.0, light)
    grown = 1.0 + 2.0 * area * response / light if by_light else gain * spread.gain * down.sums * across.sums
    assert found.missing == pytest.approx(missing if by_light else gain * missing, rel=1e-9, abs=0.0)
    assert found.sample_error == pytest.approx(grown * off, rel=1e-9, abs=0.0)


@pytest.mark.parametrize("shared", [False, True])
@pytest.mark.parametrize(("r0", "error"), [(0.05, 1e-6), (0.05, 3e-4), (30.0, 1e-6)])
def test_a_gate_errs_by_as_much_as_the_light_of_the_band_allows(shared, r0, error, monkeypatch):
    asked = []
    monkeypatch.setattr(recorded, "Gate", SimpleNamespace(of=lambda step, off: asked.append((step, off)) or 1 / 0))
    request = Request(None, 1, 1e-6, error, 10.0, shared)
    with pytest.raises(ZeroDivisionError):
        recorded._stack_images(request, Component(1.0, 1.0, ZERNIKE), Grid(5, 0.5), (lm.Seeing(r0),))
    band = Band.of(ZERNIKE, (lm.Seeing(r0),), error, shared=shared)
    expected = max(error, min(error * ZERNIKE.amplitude**2 / band.clear, 1e-4))
    assert asked == [
        (0.8, pytest.approx(2.0 ** math.floor(math.log2(expected)) if shared else expected, rel=1e-12, abs=0.0))
    ]


def test_sums_over_wavelengths_add_the_parts_of_each_error():
    pupil = lm.Pupil(wavelength=500e-9, f_number=4.0)
    white = methods.Polychromatic([450e-9, 600e-9], [1.0, 3.0])
    parts_of = white.components(pupil)
    made = [
        recorded.BlurredStack(np.full((1, 2, 2), k), *(np.array([k * e]) for e in (1e-3, 1e-4, 1e-5)), None)
        for k in (1.0, 2.0)
    ]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(recorded, "_stack_images", lambda *_: made.pop(0))
        found = recorded.summed(Request(white, 1, 1e-6, 1e-6, 0.0), pupil, Grid(2, 1e-6), (lm.Jitter(1e-6),))
    weight = parts_of[0].weight + 2.0 * parts_of[1].weight
    assert [float(np.ravel(part)[0]) for part in found[:4]] == pytest.approx(
        [weight, 1e-3 * weight, 1e-4 * weight, 1e-5 * weight]
    )


@pytest.mark.parametrize("excess", [0.9, 1.0, 1.1, 5.0, 1e9])
@pytest.mark.parametrize("part", ["sample_error", "response", "missing"])
@pytest.mark.parametrize("start", [1e-7, 1e-10])
def test_a_request_is_tightened_where_a_part_has_more_than_its_share(part, excess, start):
    allowed = np.array([2e-6, 1e-6])
    shares = {"sample_error": 0.4, "response": 0.2, "missing": 0.5}
    errors = {name: np.zeros(2) for name in shares} | {part: excess * shares[part] * allowed * [0.5, 1.0]}
    images = recorded.BlurredStack(np.ones((2, 1, 1)), **errors, method=None)
    request = Request(None, 1, 1e-5, start, 30.0)
    found = recorded._refined_request(request, images, allowed)
    tol, error, margin = 1e-5, start, 30.0
    if excess > 1.0 and part == "sample_error":
        tol *= max(0.5 / excess, 1e-4)
    if excess > 1.0 and part == "response":
        error = max(error * max(0.5 / excess, 1e-6), 1e-15)
    if excess > 1.0 and part == "missing":
        tol, margin = 0.5 * tol, margin * min(1.1 * excess ** (3 / 14), 3.0)
    assert (found.tol, found.error, found.margin) == pytest.approx((tol, error, margin), rel=1e-9, abs=0.0)


@pytest.mark.parametrize(
    ("own_peak", "left", "dtype"), [(True, 1.0, np.float64), (False, 1.0, np.float64), (False, 0.0, np.float32)]
)
def test_recorded_images_are_answered_once_their_relative_error_is_below_the_tolerance(
    own_peak, left, dtype, monkeypatch
):
    """An answer has the bound e / (peak - e), twice for its own peak."""
    tol, size, asked = 1e-4, [0.7, 0.3, 0.1], []

    def summed(request, pupil, grid, blurs):
        part = size[len(asked)] * tol
        asked.append(request)
        return recorded.BlurredStack(
            np.full((1, 3, 3), 2.0),
            np.array([part if left else np.nan]),
            np.array([part / 2]),
            np.array([part / 4]),
            methods.NijboerZernike(),
        )

    monkeypatch.setattr(recorded, "summed", summed)
    monkeypatch.setattr(recorded, "of_transfer", lambda *_: None)
    pupil, grid = lm.Pupil(lm.Wavefront(1.0)), Grid(3, 0.5)
    _, found = recorded.recorded_images(
        None, tol, pupil, grid, (lm.Jitter(1.0),), Wanted(None if own_peak else 0.5, dtype)
    )
    assert isinstance(found, Samples)
    small = U * 6 + (2.0**-24 if dtype is np.float32 else 0.0)

    def bound(share):
        whole = share * tol * (1.75 if left else 0.75) / 2.0
        whole /= 1.0 - whole
        whole = 2.0 * whole / (1.0 - whole) if own_peak else whole
        return whole + small * (1.0 + whole)

    used = next(k for k, share in enumerate(size) if bound(share) <= tol)
    assert len(asked) == used + 1
    if left:
        assert found.bound == pytest.approx([bound(size[used])], rel=2e-2 if dtype is np.float32 else 1e-6, abs=0.0)
    else:
        assert found.error is None
