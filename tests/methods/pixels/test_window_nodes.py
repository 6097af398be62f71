"""Nodes of a window: their response against quadrature, and averages against sums of samples within each pixel."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from core_tests import _core_tests
from lommel.core.answers import Wanted
from lommel.core.engine import disk_averages
from lommel.methods import ChordalGauss, NijboerZernike, averaging
from lommel.methods.nijboer_zernike import disk_stack, window_of
from lommel.optics.grid import Grid
from pixel_samples import averages_of_samples

NOLL = {"noll 4": (2, 0), "noll 7": (3, -1), "noll 12": (4, 2)}


def window_nodes(step, pixels, error):
    """Return nodes as an object with attributes, or None."""
    made = _core_tests.window_nodes(step, pixels, error)
    return None if made is None else SimpleNamespace(**made | {"places": np.array(made["places"])})


def chords(w):
    """Return the autocorrelation of the disc, of area 1, summed along the other axis."""
    t, weight = np.polynomial.legendre.leggauss(400)
    low, high = w - 1.0, np.ones_like(w)
    s = 0.5 * (high - low)[:, None] * t + 0.5 * (high + low)[:, None]
    product = np.sqrt(np.maximum(1 - s * s, 0.0) * np.maximum(1 - (s - w[:, None]) ** 2, 0.0))
    return 4 / np.pi**2 * 0.5 * (high - low) * (product @ weight)


def test_windows_whose_weights_are_of_either_sign_have_nodes_yet():
    # No number of nodes that is tried has a smaller sum of moduli than 2.
    made = window_nodes(3.27, 56, 1.8e-6)
    assert made is not None
    assert 2.0 < made.gain < 5.0
    np.testing.assert_allclose(np.abs(made.weights).sum(axis=1).max(), made.gain, rtol=1e-12)


@pytest.mark.parametrize("pixels", [1, 2, 5, 9, 16])
@pytest.mark.parametrize("step", [2.0, math.pi, 8.3, 15.0])
@pytest.mark.parametrize("error", [1e-5, 1e-8])
def test_the_mean_error_of_the_response_is_at_most_what_is_stated(pixels, step, error):
    nodes = window_nodes(step, pixels, error)
    assert nodes.error <= error
    w = np.linspace(0.0, 2.0, 6001)
    middles = step * (np.arange(pixels) - 0.5 * (pixels - 1))
    response = np.exp(1j * np.outer(w, nodes.places)) @ nodes.weights.T
    off = np.abs(response - np.sinc(step * w / (2 * np.pi))[:, None] * np.exp(1j * np.outer(w, middles)))
    mean = 2.0 * np.trapezoid(off * chords(w)[:, None], w, axis=0)
    assert (mean <= nodes.error).all()
    assert mean.max() >= 0.05 * nodes.error  # no bound that anything would be below
    assert nodes.gain == pytest.approx(np.abs(nodes.weights).sum(axis=1).max(), rel=1e-12)
    assert (np.abs(nodes.places) <= 0.5 * step * pixels).all()
    assert (
        0
        <= nodes.places.size - 2 * step * pixels / np.pi
        <= 6 + 1.1 * math.log(step * pixels + 3) * -math.log10(error)
    )


def test_windows_that_are_too_large_or_too_fine_have_none():
    assert window_nodes(8.3, 65, 1e-6) is None
    assert window_nodes(0.5, 200, 1e-6) is None


def question(seed):
    rng = np.random.default_rng(seed)
    count = int(rng.integers(1, 6))
    sizes = rng.normal(size=(count, 12)) * 2 * np.pi * 10.0 ** rng.uniform(-1.7, -0.2) / math.sqrt(12)
    wavefront = lm.Wavefront.zernike({j + 4: sizes[:, j] for j in range(12)}, order="noll")
    pupil = lm.Pupil(wavefront, obscuration=(0.0, 0.35)[seed % 2], apodization=(0.0, 0.0, 0.7)[seed % 3])
    shape = tuple(int(n) for n in rng.integers(1, 8, 2))
    middle = [(n - 1) / 2 for n in shape]
    center = (
        tuple(n // 2 for n in shape),
        tuple(c + d for c, d in zip(middle, rng.uniform(-1.5, 1.5, 2), strict=True)),
        tuple(rng.uniform(c - 1, c + 1, count) for c in middle),
        (middle[0] + 4.3, middle[1] - 0.4),
    )[seed % 4]
    return (
        pupil,
        Grid(shape, 10.0 ** rng.uniform(-0.1, 0.6), center=center, integrate=True),
        10.0 ** rng.uniform(-8, -2),
    )


@pytest.mark.parametrize("seed", range(24))
def test_averages_at_nodes_are_within_their_bound(seed):
    pupil, grid, tol = question(seed)
    dtype = np.float32 if tol > 1e-5 else np.float64
    made = lm.psf(
        pupil, grid.shape, grid.pixel, center=grid.center, integrate=True, method=ChordalGauss(tol), dtype=dtype,
        normalize="strehl",
    )  # fmt: skip
    exact = averages_of_samples(pupil, grid, 8 + int(2.2 * np.pi * grid.pixel), NijboerZernike(5e-10))[0]
    # Bounds are over the largest average that there is, also beyond the window.
    wide = [41 + 2 * (n // 2) for n in grid.shape]
    middle = [(w - n) // 2 + np.asarray(c) for w, n, c in zip(wide, grid.shape, grid.center, strict=True)]
    around = lm.psf(pupil, tuple(wide), grid.pixel, center=tuple(middle), integrate=True, normalize="strehl")
    peak = np.maximum(exact.max(axis=(1, 2)), around.values.max(axis=(1, 2)))
    assert (np.abs(made.values - exact).max(axis=(1, 2)) <= np.asarray(made.error_bound) * peak + 5e-10).all()
    assert np.max(made.error_bound) <= tol


@pytest.mark.parametrize("count", [1, 40])
@pytest.mark.parametrize(("tol", "off"), [(1e-3, 1e-5), (1e-9, 3e-9)])
def test_sums_are_those_of_samples_in_either_precision(count, tol, off):
    rng = np.random.default_rng(8)
    wavefront = lm.Wavefront.zernike({j: rng.normal(size=count) for j in (4, 5, 8)}, order="noll")
    pupil, grid = lm.Pupil(wavefront), Grid((6, 11), 1.0, integrate=True)
    made = disk_averages(disk_stack(pupil), window_of(pupil, grid), tol, Wanted(threads=1), if_cheaper=False)
    # By filters, which take samples of a series.
    method = NijboerZernike(1e-9)
    exact = lm.psf(pupil, grid.shape, 1.0, integrate=True, method=method, normalize="strehl").values
    assert np.abs(made.values - exact).max() < off


def test_windows_that_have_nodes_take_no_filter(monkeypatch):
    monkeypatch.setattr(averaging, "pixel_averages", None)
    pupil = lm.Pupil(lm.Wavefront.zernike({8: np.ones(3)}, order="noll"))
    for tol in (1e-3, 1e-8):
        assert lm.psf(pupil, 9, 2.65, integrate=True, tol=tol).error_bound <= tol


@pytest.mark.parametrize("tol", [1e-3, 1e-7])
def test_the_bound_has_all_of_its_terms(tol):
    values = np.zeros((1, 5, 5))
    values[0, 2, 2] = 0.1
    numbers = np.array([0.2, 0.1, 0.1, 0.05])  # of samples, of averages, their sum, of slopes
    found = SimpleNamespace(**_core_tests.bounds_at_nodes(2.0 * math.pi, 5, tol, 1e-16, values, numbers, 0.9, 3.0))
    assert found.made
    assert found.single == (tol == 1e-3)
    gain, light = found.gain**2, 1.01 * found.spread**2 * 0.1  # less than all of the brightest sample
    assert light < 0.2 * gain
    rounding = (2 * found.nodes + 11) * 2.0**-53 + (24 * 2.0**-24 if found.single else 0.0)
    of_samples = 0.9 * found.wanted * (2 * math.sqrt(gain * light) + 0.9 * found.wanted * gain)
    missed = (2 + found.node_error) * found.node_error
    assert found.error == pytest.approx((of_samples + missed + rounding * light) / 0.1, rel=1e-6)
    slope = gain * (3 * found.wanted + rounding * 0.05) + 2 * missed
    assert found.slope_error == pytest.approx(slope / 0.1, rel=1e-6)


@pytest.mark.parametrize("seed", range(8))
def test_derivatives_at_nodes_are_within_their_bound(seed):
    pupil, grid, tol = question(seed)
    names = ["noll 4", "noll 7", "noll 12"]
    more = {"center": grid.center, "integrate": True, "normalize": "strehl"}
    dtype = np.float32 if tol > 1e-5 else np.float64
    made = lm.psf(pupil, grid.shape, grid.pixel, method=ChordalGauss(tol), dtype=dtype, derivatives=names, **more)
    wide = [41 + 2 * (n // 2) for n in grid.shape]
    middle = [(w - n) // 2 + np.asarray(c) for w, n, c in zip(wide, grid.shape, grid.center, strict=True)]
    around = lm.psf(pupil, tuple(wide), grid.pixel, **(more | {"center": tuple(middle)}))
    peak = around.values.max(axis=(1, 2))
    step = 0.03  # radians at the edge
    for name in names:
        differences = 0.0
        for far, share in ((1, 8 / 12), (2, -1 / 12)):
            for sign in (1, -1):
                moved = dict(zip(map(tuple, pupil.wavefront.indices.tolist()), pupil.wavefront.edge.T, strict=True))
                n, m = NOLL[name]
                moved[n, m] = moved[n, m] + sign * far * step
                changed = lm.Pupil(
                    lm.Wavefront.zernike(moved, normalization="edge"), obscuration=pupil.obscuration,
                    apodization=pupil.apodization,
                )  # fmt: skip
                values = lm.psf(changed, grid.shape, grid.pixel, method=NijboerZernike(3e-9), **more).values
                differences = differences + sign * share * values / step
        off = np.abs(made.derivatives[name] - differences).max(axis=(1, 2))
        assert (off <= np.asarray(made.derivative_bounds[name]) * peak * 1.05 + 4e-7).all()


def test_samples_weighed_by_moduli_are_below_what_averages_tell():
    rng = np.random.default_rng(2)
    for step, pixels in ((2.0, 3), (3.1, 12), (8.3, 5), (12.6, 9)):
        nodes = window_nodes(step, pixels, 1e-6)
        samples = rng.random((nodes.places.size,) * 2) ** 8
        averages = nodes.weights @ samples @ nodes.weights.T
        moduli = np.abs(nodes.weights) @ samples @ np.abs(nodes.weights).T
        assert moduli.max() <= nodes.spread**2 * averages.sum() * (1 + 1e-12)
        assert 1.0 <= nodes.spread < 1.3
