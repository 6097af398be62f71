"""Averages of stacks of apertures of any shape at nodes of a window, against sums of samples within each pixel."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from core_tests import _core_tests
from lommel.core.answers import Wanted
from lommel.core.engine import Window, aperture_averages, disk_averages
from lommel.methods import nonuniform_fft
from lommel.methods.nijboer_zernike import disk_stack, window_of
from lommel.methods.nonuniform_fft import averaged_apertures, transposed
from lommel.optics.grid import Grid
from lommel.special import zernike
from pixel_samples import averages_of_samples

VANES = lm.Spider.equal(4, 0.03, first=0.17)
SEGMENTS = lm.Segments.hexagonal(rings=1, gap=0.02)
PHASED = SEGMENTS.phased(0.1 * np.arange(6.0), unit="waves")


def pupils(rng, count, waves, **more):
    sizes = rng.normal(size=(count, 12)) * 2 * np.pi * waves / math.sqrt(12)
    return lm.Pupil(lm.Wavefront.zernike({j + 4: sizes[:, j] for j in range(12)}, order="noll"), **more)


def by_rows(pupil, grid, count):
    """Return averages of samples from rows of the aperture, for which one pupil at a time asks."""
    method = lm.methods.NonuniformFFT(1e-9)
    return np.concatenate([averages_of_samples(pupil[i : i + 1], grid, count, method)[0] for i in range(len(pupil))])


@pytest.fixture(autouse=True)
def every_stack(monkeypatch):
    monkeypatch.setattr(nonuniform_fft, "_RULE_COST", 0.0)


@pytest.mark.parametrize(
    ("more", "grid", "tol"),
    [
        ({"spider": VANES, "obscuration": 0.3}, Grid((5, 8), 1.3, center=(2.2, 3.6), integrate=True), 1e-4),
        ({"spider": VANES, "obscuration": 0.3, "apodization": 0.6}, Grid(6, 2.0, integrate=True), 1e-3),
        ({"stop": PHASED}, Grid((7, 4), 1.0, center=(6.5, 1.0), integrate=True), 1e-6),
    ],
)  # fmt: skip
def test_averages_are_within_their_bound(more, grid, tol, monkeypatch):
    asked = []
    of_core = nonuniform_fft.aperture_averages
    monkeypatch.setattr(nonuniform_fft, "aperture_averages", lambda *given: asked.append(given) or of_core(*given))
    rng = np.random.default_rng(4)
    for count in (5, 21):
        pupil = pupils(rng, count, 0.08, **more)
        made = lm.psf(
            pupil, grid.shape, grid.pixel, center=grid.center, integrate=True, normalize="strehl",
            dtype=np.float32 if tol > 1e-5 else np.float64, method=lm.methods.NonuniformFFT(tol),
        )  # fmt: skip
        assert asked
        exact = by_rows(pupil, grid, 7 + int(2.0 * grid.pixel))
        wide = lm.psf(pupil, 25, grid.pixel, integrate=True, tol=1e-4, normalize="strehl").values.max(axis=(1, 2))
        peak = np.maximum(wide, exact.max(axis=(1, 2)))
        off = np.abs(made.values - exact).max(axis=(1, 2))
        assert (off <= (np.asarray(made.error_bound) + 1e-8) * peak).all()
        assert np.max(made.error_bound) <= tol


@pytest.mark.parametrize("tol", [1e-9, 1e-3])
def test_sums_are_those_of_the_disk_where_weights_are(tol):
    """The rule of the whole disk, in either way of the axes, gives what the chordal rule does."""
    rng = np.random.default_rng(1)
    pupil, grid = pupils(rng, 3, 0.1), Grid((4, 7), 1.1, center=(1.7, 3.2), integrate=True)
    stack, window = disk_stack(pupil), window_of(pupil, grid)
    exact = disk_averages(stack, window, 1e-10, Wanted(threads=1), if_cheaper=False)
    size = 64
    _, w = np.polynomial.legendre.leggauss(size)
    angle = np.pi * np.arange(1, size // 2 + 1) / (size + 1)
    quadrant = np.outer(np.sin(angle) ** 2 / (size + 1), w[size // 2 :][::-1])
    weights, asked = np.zeros((size // 2, size // 2, 8)), []
    weights[:, :, ::2] = quadrant[:, :, None]

    def rule(*given):
        asked.append(given)
        return weights, 0.5 * given[2], given[3]

    for swap in (False, True):
        by = (transposed(stack), window._replace(shape=(7, 4), center=(3.2, 1.7))) if swap else (stack, window)
        made = aperture_averages(*by, 0.8, 1.0, tol, Wanted(threads=1), rule)
        values = made.values.swapaxes(1, 2) if swap else made.values
        np.testing.assert_allclose(values, exact.values, atol=1e-5 if tol > 1e-6 else 1e-9)
        np.testing.assert_allclose(made.peak, values.max(axis=(1, 2)), rtol=1e-12)
        down, across, _, single, rows, columns = asked[-1]
        assert single == (tol > 1e-6)
        # From the axis to nodes at the corners of the window.
        for reach, pixels in zip((across, down) if swap else (down, across), (2.2, 3.7), strict=True):
            assert 0.9 < reach / (1.1 * np.pi * pixels) <= 1.0
        assert (rows > columns) == swap
    assert aperture_averages(stack, window, 0.8, 1.0, tol, Wanted(threads=1), lambda *_: None) is None


def test_derivatives_are_those_of_samples():
    rng = np.random.default_rng(8)
    pupil = pupils(rng, 3, 0.08, spider=VANES, obscuration=0.3)
    more = {
        "center": (2.2, 3.6),
        "integrate": True,
        "normalize": "strehl",
        "derivatives": ["noll 5", "noll 8", "noll 12"],
    }
    made = lm.psf(pupil, (5, 8), 1.3, tol=1e-6, **more)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(nonuniform_fft, "_nodes_are_faster", lambda *_: False)
        exact = lm.psf(pupil, (5, 8), 1.3, tol=1e-9, **more)
    for name in more["derivatives"]:
        off = np.abs(made.derivatives[name] - exact.derivatives[name]).max(axis=(1, 2))
        peak = exact.values.max(axis=(1, 2))
        bound = np.asarray(made.derivative_bounds[name]) + np.asarray(exact.derivative_bounds[name])
        assert (off <= 2.0 * bound * peak).all()
        assert off.max() < 1e-6


def test_apertures_that_do_not_serve_have_none():
    rng = np.random.default_rng(2)
    wanted = Wanted(dtype=np.float64, threads=1)
    grid = Grid(5, 1.0, integrate=True)
    assert averaged_apertures(pupils(rng, 5, 0.1, spider=VANES), grid, 1e-4, wanted) is not None
    assert averaged_apertures(pupils(rng, 5, 0.1, spider=VANES), grid, 1e-4, wanted._replace(powers=(1,))) is None
    assert averaged_apertures(pupils(rng, 5, 0.1, spider=VANES), Grid(90, 4.0, integrate=True), 1e-4, wanted) is None


def test_a_rule_is_made_where_enough_pupils_take_it(monkeypatch):
    rng = np.random.default_rng(3)
    wanted, grid = Wanted(dtype=np.float64, threads=1), Grid(15, 2.0, integrate=True)
    monkeypatch.setattr(nonuniform_fft, "_RULE_COST", 1e5)
    assert averaged_apertures(pupils(rng, 5, 0.1, spider=VANES), grid, 1e-4, wanted) is None


def test_errors_of_fields_count_as_much_as_weights_and_fields_at_the_nodes():
    """By blocks of samples: at least as the sums over all nodes say, and less than twice that."""
    rng = np.random.default_rng(6)
    step, asked, size, off = 0.8 * np.pi, [], 48, 1e-4
    edge = rng.normal(size=(21, 3)) * 0.5
    stack = disk_stack(lm.Pupil(lm.Wavefront.zernike({j + 5: edge[:, j] for j in range(3)}, order="noll")))
    t, w = np.polynomial.legendre.leggauss(size)
    angle = np.pi * np.arange(1, size + 1) / (size + 1)
    weights = np.zeros((size // 2, size // 2, 8))
    weights[:, :, ::2] = np.outer(np.sin(angle[: size // 2]) ** 2 / (size + 1), w[size // 2 :][::-1])[:, :, None]

    def rule(*given):
        asked.append(given)
        return weights, off, given[3]

    window = Window((9, 9), (4.0, 4.0), step)
    made = aperture_averages(stack, window, 0.8, 1.0, 0.1, Wanted(threads=1), rule)
    assert len(asked) == 1
    nodes = next(n for n in (_core_tests.window_nodes(step, 9, e) for e in np.geomspace(1e-5, 1, 200))
                 if n is not None and len(n["places"]) == asked[0][4])  # fmt: skip
    v, c = np.array(nodes["places"]), np.abs(np.array(nodes["weights"]))
    x, y = np.cos(angle)[:, None] + 0 * t, np.sin(angle)[:, None] * t
    each = (np.sin(angle)[:, None] ** 2 / (size + 1) * w).ravel()
    phase = sum(
        stack.edge[:, [j]] * zernike.polynomial(n, m, np.hypot(x, y).ravel(), np.arctan2(y, x).ravel())
        for j, (n, m) in enumerate(stack.terms)
    )
    waves = [np.exp(-1j * np.outer(v, part.ravel())) for part in (y, x)]
    field = np.einsum("pn,vn,un->pvu", each * np.exp(1j * phase), *waves, optimize=True)
    moduli = np.einsum("jv,iu,pvu->pji", c, c, np.abs(field), optimize=True).max(axis=(1, 2))
    gain = nodes["gain"] ** 2
    own = (2 + nodes["error"]) * nodes["error"] + 24 * 2.0**-24 * gain
    lower, upper = (off * (2 * k * moduli + gain * off) / made.peak for k in (1.0, 2.0))
    assert (made.error >= lower).all()
    assert (made.error <= upper + own / made.peak).all()
