"""Samples, spread and read: each part of the bound by what it is to cover."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel.blur import recorded
from lommel.blur.blurs import KOLMOGOROV
from lommel.blur.convolution import Gate, ends
from lommel.blur.recorded import Band, Gather, Request, summed
from lommel.optics.grid import Grid


def on_axis(ratio: float) -> float:
    """Return the long exposure in the middle, over the unaberrated peak."""
    x, w = np.polynomial.legendre.leggauss(400)
    u, w = 0.5 * (x + 1.0), 0.5 * w
    f, weight = u**3, w * 3.0 * u**5
    otf = 2.0 / np.pi * (np.arccos(f) - f * np.sqrt(1.0 - f * f))
    blurred = otf * np.exp(-KOLMOGOROV * (ratio * f) ** (5.0 / 3.0))
    return float(weight @ blurred / (weight @ otf))


@pytest.mark.parametrize("margin", [22.0, 40.0])
@pytest.mark.parametrize("ratio", [1.0, 3.0])
def test_light_beyond_a_lattice_that_is_too_small_is_counted(ratio, margin):
    asked = Request(None, 0, 1e-11, 1e-12, margin)
    made = summed(asked, lm.Pupil(), Grid(1, 0.5), (lm.Seeing(1.0 / ratio),))
    off = abs(float(made.values[0, 0, 0]) - on_axis(ratio))
    assert made.sample_error is not None
    assert off > 10.0 * float(made.sample_error[0] + made.response[0])
    assert off <= float(made.missing[0])


@pytest.mark.parametrize("margin", [20.0, 60.0])
@pytest.mark.parametrize("ratio", [8.0, 30.0])
def test_light_beyond_a_lattice_that_is_gathered_is_counted(ratio, margin):
    asked = Request(None, 0, 1e-11, 1e-13, margin)
    made = summed(asked, lm.Pupil(), Grid(1, 0.5), (lm.Seeing(1.0 / ratio),))
    off = on_axis(ratio) - float(made.values[0, 0, 0])
    assert off > 10.0 * float(made.sample_error[0] + made.response[0])
    assert off <= float(made.missing[0]) < 2000.0 * off


@pytest.mark.parametrize("error", [1e-4, 1e-7, 1e-10])
def test_light_is_gathered_so_that_waves_of_the_band_are_what_they_were(error):
    gate = Gate.of(0.8, error)
    made = Gather.of(0.17, -40, 90, gate)
    at = gate.h * (made.first + np.arange(made.matrix.shape[1]))
    w = np.linspace(-2.0, 2.0, 101)
    expected = np.exp(1j * np.outer(0.17 * np.arange(-40, 50), w))
    assert np.abs(made.matrix @ np.exp(1j * np.outer(at, w)) - expected).max() <= made.error < 4.0 * error
    # Samples far from a place are all that it lacks.
    beyond, cut = ends(gate)
    many = Gather.of(0.17, -4000, 8001, gate)
    place = -many.first
    far = np.abs(0.17 * np.arange(-4000, 4001)) > beyond
    assert 0.17 / gate.h * np.abs(many.matrix[far, place]).sum() <= cut
    assert 0.17 / gate.h * np.abs(many.matrix[:, place]).sum() <= many.sums


@pytest.mark.parametrize(
    "blur", [(lm.Seeing(1.0 / 8.0),), (lm.Jitter(1.5, 3.0),), (lm.Seeing(0.1, outer_scale=20.0), lm.Motion(4.0))]
)
@pytest.mark.parametrize("error", [1e-6, 1e-10])
def test_bounds_on_spectra_are_above_their_integrals(blur, error):
    pupil = lm.Pupil(obscuration=0.4)
    band = Band.of(pupil, blur, error)
    assert 0.0 < band.share < 0.8
    assert band.tail <= error * pupil.amplitude**2
    x, w = np.polynomial.legendre.leggauss(1200)
    angle = np.linspace(0.0, np.pi, 16, endpoint=False)

    def integral(low: float, high: float, seen: bool) -> float:
        f, weight = low + 0.5 * (high - low) * (x + 1.0), 0.5 * (high - low) * w
        size = np.abs(lm.otf(pupil, f)) if high <= 1.0 else 1.0
        mean = 1.0
        if seen:
            mean = np.mean(
                [np.prod([np.abs(b.transfer(f * np.cos(t), f * np.sin(t))) for b in blur], axis=0) for t in angle],
                axis=0,
            )
        return 8.0 * pupil.transmission * float(np.sum(weight * f * size * mean))

    assert integral(band.share, 3.0, True) <= band.tail
    assert integral(0.0, 1.0, True) <= band.blurred
    assert integral(0.0, band.share, False) <= band.clear


@pytest.fixture
def sampled(monkeypatch):
    """Return a list of the lattices that were sampled, and nothing kept of others."""
    lattices, sample = [], recorded._sampled
    monkeypatch.setattr(recorded, "_sampled", lambda *args: lattices.append(args[2]) or sample(*args))
    lm.clear_caches()
    return lattices


VANES = lm.Spider.equal(3, 0.04)


@pytest.mark.parametrize("wavefront", [lm.Wavefront(), lm.Wavefront(nonradial={(3, 1): 3.0})])
def test_samples_of_an_aperture_serve_other_seeing(sampled, wavefront):
    pupil, tol = lm.Pupil(wavefront, obscuration=0.2, spider=VANES), 1e-6
    for ratio, shape, center in [(20.0, 33, None), (19.2, 31, None), (20.3, 21, None), (18.8, (9, 7), (3.5, 5.2))]:
        made = lm.psf(pupil, shape, 4.0, center=center, blur=lm.Seeing(1.0 / ratio), tol=tol, dtype=np.float64)
        count = len(sampled)
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(recorded, "_cached_lattices", lambda *_: {})
            plain = lm.psf(pupil, shape, 4.0, center=center, blur=lm.Seeing(1.0 / ratio), tol=3e-8, dtype=np.float64)
        del sampled[count:]
        assert np.abs(made.values - plain.values).max() <= (made.error_bound + 3e-8) * plain.values.max()
        assert made.error_bound <= tol
        assert made.method == plain.method.with_tol(tol)
    assert len(sampled) == 1


def test_samples_that_are_kept_are_of_the_same_pupil_and_good_enough(sampled):
    def seen(pupil, shape=15, tol=1e-4, ratio=20.0):
        lm.psf(pupil, shape, 4.0, blur=lm.Seeing(1.0 / ratio), tol=tol)
        return len(sampled)

    pupil = lm.Pupil(spider=VANES)
    assert seen(pupil) == 1
    assert seen(pupil) == 1
    assert seen(lm.Pupil(spider=lm.Spider.equal(3, 0.05))) == 2
    assert seen(lm.Pupil(lm.Wavefront(1.0), spider=VANES)) == 3
    assert seen(lm.Pupil(spider=VANES), shape=9, tol=1e-3, ratio=19.9) == 4  # the first of three is no longer kept
    assert seen(pupil, tol=1e-6) == 5
    assert seen(pupil, tol=1e-5) == 5
    assert seen(pupil, ratio=6.0) == 6


def test_only_samples_of_the_tolerance_serve_again(sampled):
    pupil, lattice = lm.Pupil(spider=VANES), SimpleNamespace(step=1.0, first=(-6, -7), counts=(13, 15))
    least = 1.0
    for tol, count in [(1e-4, 1), (1e-4, 1), (1e-3, 1), (1e-6, 2), (1e-4, 2), (2e-7, 3)]:
        _, values, off = recorded._on_lattice(Request(None, 1, tol, 1e-9, 0.0), pupil, lattice)
        assert values.shape == (1, 13, 15)
        assert float(off[0]) <= tol * pupil.amplitude**2
        assert len(sampled) == count
        kept, least = recorded._cached_lattices(pupil.aperture, pupil.wavefront)[1.0].tol, min(least, tol)
        assert kept == pytest.approx(10.0 ** (math.floor(2.0 * math.log10(least)) / 2.0))
    part = SimpleNamespace(step=1.0, first=(-2, 3), counts=(4, 5))
    _, values, _ = recorded._on_lattice(Request(None, 1, 1e-6, 1e-9, 0.0), pupil, part)
    exact = lm.psf(pupil, (4, 5), 1.0 / np.pi, center=(2, -3), tol=1e-10, normalize="strehl", dtype=np.float64)
    np.testing.assert_allclose(values[0], exact.values * pupil.amplitude**2, atol=2e-7)
    assert len(sampled) == 3
    for first in [(-7, 0), (0, -8), (4, 0), (0, 4)]:
        known, count = recorded._cached_lattices(pupil.aperture, pupil.wavefront)[1.0], len(sampled)
        assert known.part(first, (4, 5)) is None
        beyond = SimpleNamespace(step=1.0, first=first, counts=(4, 5))
        assert recorded._on_lattice(Request(None, 1, 1e-6, 1e-9, 0.0), pupil, beyond)[1].shape == (1, 4, 5)
        assert len(sampled) == count + 1
        recorded._cached_lattices(pupil.aperture, pupil.wavefront)[1.0] = known


@pytest.mark.parametrize("ratio", [4.0, 9.0, 15.0, 33.0, 80.0])
@pytest.mark.parametrize("shared", [False, True])
def test_copies_of_the_band_of_the_intensity_begin_where_that_of_the_blur_ends(monkeypatch, ratio, shared):
    lattices, of = [], recorded._on_lattice
    monkeypatch.setattr(recorded, "_on_lattice", lambda *args: lattices.append(args[2]) or of(*args))
    asked = Request(None, 1, 1e-8, 1e-9, 60.0, shared)
    summed(asked, lm.Pupil(spider=VANES), Grid(3, 2.0), (lm.Seeing(1.0 / ratio),))
    (lattice,) = lattices
    share = lattice.h / lattice.step
    assert share < 1.0
    assert lattice.step * (1.0 + share) <= np.pi * (1.0 + 1e-14)
    assert lattice.h <= recorded.STEP


def test_what_few_lattices_do_not_reach_one_of_its_own_does(monkeypatch):
    pupil, shared = lm.Pupil(obscuration=0.2, spider=VANES), []
    of_stack = recorded._stack_images
    monkeypatch.setattr(
        recorded, "_stack_images", lambda asked, *args: shared.append(asked.shared) or of_stack(asked, *args)
    )
    monkeypatch.setattr(recorded, "_round_up", lambda count: 10**4)
    assert lm.psf(pupil, 9, 4.0, blur=lm.Seeing(0.05), tol=1e-4).error_bound <= 1e-4
    assert shared == [True, False]
