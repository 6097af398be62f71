"""Every term of the bounds of tables of molecules, made a second time from docs/certificate.md, section 19."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel.localize.table import Table, Waves, pieces

OBJECTIVE = lm.Objective(NA=1.49, magnification=100, immersion=1.518, sample=1.33)
ASTIGMATISM = lm.Wavefront.zernike({6: 0.1}, order="noll", unit="waves")
K = 2.0 * math.pi / 600e-9
RATE = K * (1.518 - math.sqrt(1.518**2 - 1.49**2))
FADING = 2.0 * K * math.sqrt(1.49**2 - 1.33**2)
ETA = np.geomspace(0.02, 6.0, 300)
SMALL = 2.0**-24


class Watched(Table):
    """A table that remembers what its bounds were made of."""

    def _bound(self, sampling, *others):
        self.sampling, self.parts = sampling, (*sampling, *others)
        return super()._bound(sampling, *others)


@pytest.fixture(scope="module", params=["z", "depth"])
def made(request) -> Watched:
    span = (-0.2e-6, 0.25e-6) if request.param == "z" else (0.05e-6, 0.3e-6)
    pupil = OBJECTIVE.pupil(depth=0.2e-6, wavelength=600e-9, aberrations=ASTIGMATISM)
    return Watched(pupil, shape=(7, 9), pixel=9e-6, z=span, along=request.param, tol=1e-3)


def test_the_sum_is_that_of_the_page(made):
    _, taps, planes, step, per, delta, (largest, often), light = made.parts
    h, m, count, pieces = step / per, per, taps.taps.size, len(planes.matrix)
    assert step == pytest.approx(math.pi * 9e-6 / made.pupil.scale)
    a = 0.5 * (made.z[1] - made.z[0]) / pieces
    spread = (1.0 + taps.error) ** 2 - 1.0
    rho = (2 * count + 16) * SMALL * largest * taps.taps.gain
    samples = planes.error.value + planes.gain.value * delta
    g, t = taps.taps.gain, 0.5 * (1.0 + np.cos((np.arange(80) + 0.5) * math.pi / 80))
    times = np.array([1 + count, *range(1 + count, 2, -1)])
    rounded = (np.abs(taps.taps.at(t)) * times).sum(axis=1).max() / math.cos(math.pi / 10)
    value = spread + taps.gain**2 * samples + 1.001 * SMALL * g * (g * often + 2.0 * rounded * largest)
    side = (1.0 + taps.error) * taps.slope_error + 2.0 * h * taps.error + taps.gain * taps.slope_gain * samples
    side = m * (side + rho * taps.taps.slope_gain)
    steepest = RATE if made.along == "z" else K * 1.33 + 2.0 * FADING
    steep = steepest * spread + taps.gain**2 * (planes.error.slope + planes.gain.slope * delta)
    steep += 49.0 * rho * taps.taps.gain / a
    z = np.linspace(*made.z, 32 * pieces + 1)
    dimmest = float(made(3.0, 4.0, z).max(axis=(1, 2)).min()) / light
    peak = dimmest - value
    assert light == pytest.approx(step**2 / (4.0 * math.pi))
    assert made.error_bound == pytest.approx(value / peak, rel=1e-6)
    assert made.slope_bounds["row"] == made.slope_bounds["column"] == pytest.approx(side / peak, rel=1e-6)
    assert made.slope_bounds[made.along] == pytest.approx(steep / peak, rel=1e-6)


def test_taps_are_as_exact_as_they_are_said_to_be(made):
    _, taps, _, step, per, *_ = made.parts
    band = 2.0 * step / per
    theta = band * np.cos(np.linspace(0.0, math.pi, 3001))
    t = np.linspace(0.0, 1.0, 301)
    response = taps.filter[0] + 2.0 * np.cos(np.outer(theta, np.arange(1, len(taps.filter)))) @ taps.filter[1:]
    wanted = np.sinc(per * theta / (2.0 * math.pi))
    turned = np.exp(1j * np.outer(theta, taps.taps.places))
    for weights, factor, error, gain in (
        (taps.taps.at(t), 1.0, taps.error, taps.gain),
        (taps.taps.slopes(t), 1j * theta, taps.slope_error, taps.slope_gain),
    ):
        off = response[:, None] * (turned @ weights.T) - (factor * wanted)[:, None] * np.exp(1j * np.outer(theta, t))
        assert 0.4 * error <= np.abs(off).max() <= error
        whole = np.concatenate([taps.filter[:0:-1], taps.filter])
        sums = max(np.abs(np.convolve(row, whole)).sum() for row in weights)
        assert 0.6 * gain <= sums <= gain
    for weights, gain in ((taps.taps.at(t), taps.taps.gain), (taps.taps.slopes(t), taps.taps.slope_gain)):
        assert 0.9 * gain <= np.abs(weights).sum(axis=1).max() <= gain


def tails(most: np.ndarray, first: int) -> tuple[float, float]:
    """Sums over n >= first of 2 M exp(-n eta) and of n^2 times that, each the least over eta."""
    n = np.arange(first, first + 4000)[:, None]
    terms = 2.0 * np.exp(np.minimum(most - n * ETA, 600.0))
    return float(terms.sum(axis=0).min()), float((n**2 * terms).sum(axis=0).min())


def light(made: Watched, depth: np.ndarray) -> np.ndarray:
    """What is collected at depths, over that far from the glass."""
    if made.along == "z":
        return np.ones(depth.shape)
    far = OBJECTIVE.pupil(depth=depth, wavelength=600e-9, origin="coverslip")
    return np.asarray(far.collected)


def grown(made: Watched, low: float, high: float) -> np.ndarray:
    """The logarithm of M on each ellipse."""
    half, middle = 0.5 * (high - low), 0.5 * (high + low)
    if made.along == "z":
        return RATE * half * np.sinh(ETA)
    nearest = middle - half * np.cosh(ETA)
    steady = np.log(light(made, np.maximum(0.0, nearest)))
    return K * 1.33 * half * np.sinh(ETA) + steady + FADING * np.maximum(0.0, -nearest)


def test_series_along_z_are_as_exact_as_they_are_said_to_be(made):
    _, _, planes, *_ = made.parts
    low, high = made.z
    pieces = len(planes.matrix)
    a = 0.5 * (high - low) / pieces
    first = grown(made, low, low + 2.0 * a)
    if made.along == "depth":
        first = np.where(FADING * a * np.sinh(ETA) <= 0.5 * math.pi, first, np.inf)
    through = 2.0 * tails(grown(made, low, high), len(planes.places))[0]
    inner = 2.0 * through + tails(first, 24)[0]
    value, slope = tails(first, 8)
    assert planes.error.value == pytest.approx(8.0 * inner + value, rel=1e-6)
    assert planes.error.slope == pytest.approx((inner * 140.0 + slope) / a, rel=1e-6)


@pytest.mark.parametrize(
    ("along", "low", "high", "error", "least"), [("z", -1e-6, 2e-6, 1e-4, 2), ("depth", 0.1e-6, 0.9e-6, 1e-3, 2)]
)
def test_series_have_the_fewest_pieces_and_planes_of_their_errors(along, low, high, error, least):
    """Nine tenths of the error are for truncation, a twentieth for the values between planes."""
    pupil = OBJECTIVE.pupil(depth=0.2e-6, wavelength=600e-9)
    found, count, planes = pieces(Waves(pupil, along), low, high, error), 1, 8

    def first():
        a = 0.5 * (high - low) / count
        kept = (along == "z") | (FADING * a * np.sinh(ETA) <= 0.5 * math.pi)
        return np.where(kept, grown(SimpleNamespace(along=along), low, low + 2.0 * a), np.inf)

    def rest(most, first):  # the sum over n >= first of 2 M exp(-n eta)
        return float((2.0 * np.exp(np.minimum(most - first * ETA, 600.0)) / -np.expm1(-ETA)).min())

    while rest(first(), 8) > 0.9 * error:
        count += 1
    whole = grown(SimpleNamespace(along=along), low, high)
    while 32.0 * rest(whole, planes) > 0.05 * error:
        planes += 1
    assert (len(found.matrix), len(found.places)) == (count, planes)
    assert count >= least
    inner, a = 4.0 * rest(whole, planes) + rest(first(), 24), 0.5 * (high - low) / count
    value, slope = tails(first(), 8)
    assert found.error == pytest.approx((8.0 * inner + value, (inner * 140.0 + slope) / a), rel=1e-6, abs=0.0)


def test_planes_count_no_more_than_they_are_said_to(made):
    _, _, planes, *_ = made.parts
    a = 0.5 * (made.z[1] - made.z[0]) / len(planes.matrix)
    x = np.linspace(-1.0, 1.0, 1001)
    for order, gain in enumerate(planes.gain):
        basis = np.stack([np.polynomial.Chebyshev.basis(n).deriv(order)(x) for n in range(8)], axis=1)
        sums = np.abs(basis @ planes.matrix).sum(axis=2).max() / a**order
        assert 0.9 * gain <= sums <= gain


def test_the_largest_sums_of_coefficients_are_those_of_what_is_stored(made):
    *_, (largest, often), factor = made.parts
    pieces, rows, per, wide, *_ = made._parts["sizes"]
    stored = made._parts["coefficients"][: pieces * 8 * rows * per * wide].reshape(pieces, 8, -1)
    sizes = np.abs(stored.astype(float)) / factor
    assert sizes.sum(axis=1).max() == pytest.approx(largest, rel=1e-6)
    # The constant term is stored and added once; term n is stored, multiplied, and added with all that follow it.
    times = np.array([2, *(n + 4 for n in range(1, 8))])
    assert (times[:, None] * sizes).sum(axis=1).max() == pytest.approx(often, rel=1e-6)


def test_samples_are_as_exact_as_they_are_said_to_be(made):
    waves, _, planes, _, per, delta, *_ = made.parts
    middle = len(planes.places) // 2
    one = waves.at(planes.places[middle : middle + 1])
    shape, center = (31, 29), (14, 13)
    alone = made.sampling._replace(planes=planes._replace(places=planes.places[middle : middle + 1]))
    values, error = made._samples(alone, shape, center, delta)
    exact = lm.psf(
        one,
        shape,
        9e-6 / per,
        center=(14.0, 13.0),
        integrate=False,
        normalize="strehl",
        method=lm.methods.DebyeRings(1e-10),
        dtype=float,
    ).values
    assert np.abs(values - exact).max() <= error <= delta


def test_waves_of_the_depth_are_refused_where_light_could_vanish():
    waves = Waves(OBJECTIVE.pupil(depth=0.2e-6, wavelength=600e-9), "depth")
    most = waves.log_bound_of_quotients(0.0, 0.4e-6)
    turned = FADING * 0.2e-6 * np.sinh(ETA) <= 0.5 * math.pi
    np.testing.assert_array_equal(np.isfinite(most), turned)
    assert turned.any()
    assert not turned.all()
