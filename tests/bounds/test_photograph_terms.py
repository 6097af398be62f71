"""Errors of blurred photographs, of depth and of its verdict, a second time, by sums over pixels."""

from __future__ import annotations

import math
from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import (
    bank,
    defocus_depth,
    defocus_verdict,
    field_blur,
    focal_engine,
    focal_tables,
    spline_nodes,
    traced_windows,
)
from lommel.imaging.defocus_verdict import DefocusVerdict, _Minimum
from lommel.imaging.spline_nodes import Nodes
from lommel.imaging.traced_blur import _WINDOW_SETS, _windows_by_size

RNG = np.random.default_rng(0)


def test_interpolation_is_checked_half_way_in_every_inner_gap():
    exact, middle = RNG.uniform(0.5, 1.0, (6, 7)), RNG.uniform(0.5, 1.0, (5, 7))
    worst = 0.0
    for k in range(1, 4):
        cubic = (9 * exact[k] + 9 * exact[k + 1] - exact[k - 1] - exact[k + 2]) / 16
        worst = max(worst, np.abs(cubic - middle[k]).max() / middle[k].max())
    assert bank._interpolation_error(exact.copy(), middle) == pytest.approx(worst, rel=1e-12)


class Lights:
    """Points whose light is a sum of two kernels, in proportions that change over the field."""

    def windows(self, places, half):
        offsets = np.arange(-half, half + 1.0)
        radius = np.hypot(offsets[:, None], offsets)
        near, far = np.exp(-(radius**2)), 0.02 / (1.0 + radius) ** 3 * np.ones((len(places), 1, 1))
        share = 1.0 + 0.3 * np.asarray(places)[:, :1, None]
        one = near + far * (1.0 + share * np.exp(-radius / 9.0))
        return one / (3.0 * one.sum(axis=(1, 2), keepdims=True)) * 2.9


def test_errors_between_nodes_count_the_light_that_a_window_lacks_twice():
    axes = (Nodes(-1.0, 1.0, 4, 3), Nodes(0.0, 0.0, 1, 3), Nodes(0.0, 0.0, 1, 3))
    source = Lights()
    places = np.array([[y, 0.0, 0.0] for y in axes[0].places])
    windows = source.windows(places, 3)
    exact = source.windows(np.array([[y, 0.0, 0.0] for y in axes[0].between]), 3)
    least = exact.sum(axis=(1, 2)).min()
    windows /= windows.sum(axis=(1, 2), keepdims=True)
    exact /= exact.sum(axis=(1, 2), keepdims=True)
    coefficients = axes[0].coefficients(windows.reshape(4, 1, 1, 7, 7), 0)
    found = field_blur._error_between(source, axes, coefficients)
    made = np.tensordot(axes[0].weights(axes[0].between), coefficients[:, 0, 0], axes=1)
    off = [np.abs(a - b).sum() + abs((a - b).sum()) for a, b in zip(made, exact, strict=True)]
    assert found == pytest.approx((spline_nodes.ERROR_RATIO * max(off), least), rel=1e-9)


@pytest.mark.parametrize(("degree", "tol"), [(3, 1e-3), (3, 1e-6), (5, 1e-7)])
def test_nodes_of_a_spline_are_few_and_enough(degree, tol):
    def sample(places):
        return np.cos(2.0 * np.asarray(places))[None, :, None, None] * np.ones((1, 1, 2, 2))

    nodes = spline_nodes.sufficient_nodes(sample, 0.0, 2.0, tol, degree)

    def off(made):
        wide = spline_nodes.interpolated(made, sample(made.places), made.between)
        return spline_nodes.ERROR_RATIO * np.abs(wide - sample(made.between)).sum(axis=(2, 3)).max()

    assert off(nodes) <= tol
    fewer = Nodes(0.0, 2.0, math.ceil(0.8 * nodes.count), degree)
    assert off(fewer) > tol
    flat = spline_nodes.sufficient_nodes(lambda at: np.ones((1, len(at), 2, 2)), 0.0, 2.0, tol, degree)
    assert flat.count == 1
    assert spline_nodes.sufficient_nodes(sample, 1.0, 1.0, tol, degree).count == 1
    assert spline_nodes.window_difference(np.full((2, 3, 3), 2.0), np.full((2, 3, 3), 1.5)) == pytest.approx(4.5)


@pytest.mark.parametrize("tol", [1e-2, 1e-5])
def test_a_layer_is_refused_where_its_series_has_not_ended_and_is_within_its_tolerance(tol):
    nodes = traced_windows._nodes(1.0, 3.0, 2.0)
    x, transform = traced_windows.chebyshev_nodes(len(nodes))
    assert nodes == pytest.approx(2.0 + x)
    assert len(nodes) == math.ceil(traced_windows._NODES[0] + traced_windows._NODES[1] * 4.0)

    def windows(c, rate):
        return 1.0 + 0.5 * np.cos(rate * c[:, None, None] + np.arange(9.0))

    for rate in (0.5, 6.0, 40.0):
        made = windows(nodes, rate)
        coefficients = np.abs(transform @ (made / made.max(axis=2).min(axis=0)[:, None]).reshape(len(nodes), -1))
        ends = coefficients.max(axis=1)[-2:].sum()
        layer = traced_windows._layer(1.0, 3.0, nodes, made, tol)
        assert (layer is None) == (ends > 0.2 * tol)
        if layer is not None:
            c = np.linspace(1.0, 3.0, 57)
            basis = traced_windows.chebyshev(c - 2.0, layer.weights.shape[1])
            found = np.einsum("cd,rd,rkp->ckp", basis, layer.weights, layer.windows)
            exact = windows(c, rate)
            assert np.abs(found - exact).max() <= tol * exact.max(axis=2).min()


@pytest.mark.parametrize("errors", [[0.1, 0.1, 0.25], [0.1, 0.19, 3.0]])
def test_depth_on_slopes_without_texture_is_as_uncertain_as_the_texture_is_far(errors, monkeypatch):
    steep, window, limit = 0.04, 2.0, 2.9
    monkeypatch.setattr(defocus_depth, "squared_slopes", lambda position, width: np.full(position.shape, steep))
    position, off = np.zeros((3, 40)), np.full((3, 40), np.inf)
    off[1, [14, 8, 2, 21]] = [*errors, 0.3]  # 6 and 7 pixels apart, where 6 is the reach
    before = off.copy()
    defocus_depth._add_slope_errors(position, off, window, limit)
    reach = defocus_depth._TEXTURE_REACH * window
    for row, column in np.ndindex(3, 40):
        if not np.isfinite(before[row, column]):
            assert np.isinf(off[row, column])
            continue
        near = before[
            max(0, row - round(reach)) : row + round(reach) + 1,
            max(0, column - round(reach)) : column + round(reach) + 1,
        ]
        borrowed = max(0.0, 1.0 - (2.0 * near.min() / before[row, column]) ** 2)
        expected = math.sqrt(before[row, column] ** 2 + 0.25 * reach**2 * borrowed * steep)
        if expected > limit:
            assert np.isnan(position[row, column])
            assert np.isinf(off[row, column])
        else:
            assert off[row, column] == pytest.approx(expected, rel=1e-9)
            assert position[row, column] == 0.0


@pytest.mark.parametrize("same", [False, True])
def test_errors_of_lenses_add_in_squares_and_frames_of_one_focus_share_theirs(same):
    lens = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.25, wavelength=540e-9)
    lenses = [lens, lens.focused(1.25 if same else 2.0), lens.focused(1.25)]
    slopes = np.array([[2.0, 3.0], [1.0, 0.5], [0.4, 0.2], [-0.3, 0.7]])
    task = SimpleNamespace(lenses=lenses)
    engine = SimpleNamespace(known=1.5, lens_derivatives=lambda at: slopes[:, : at.size], task=task)
    engine.lens_errors = partial(focal_engine.FocalEngine.lens_errors, engine)
    found = focal_engine.FocalEngine.scale_error(engine, 0.3, 0.5)
    estimate, errors, steps = np.array([0.7, 0.6, np.nan]), np.array([0.1, 1.2, np.inf]), np.array([1.0, 2.0, np.inf])
    defocus_depth._add_lens_errors(engine, (0.3, 0.5), estimate, errors, steps)
    expected = []
    for k, own in enumerate((0.1, 1.2)):
        first = slopes[1, k] + slopes[3, k] + (slopes[2, k] if same else 0.0)
        parts = [first] if same else [first, slopes[2, k]]
        expected.append(math.sqrt(own**2 + (0.3 * slopes[0, k]) ** 2 + 0.25 * sum(p * p for p in parts)))
    assert errors[0] == pytest.approx(expected[0], rel=1e-9)
    assert expected[1] > 1.4
    if expected[1] > 1.5:
        assert np.isnan(estimate[1])
        assert np.isinf(steps[1])
    assert found == (0.3 if same else pytest.approx(math.hypot(0.3, math.sqrt(2.0) * 0.5 / 0.3), rel=1e-9))
    # Of a lens that was not measured: 3 % of the f-number, 2 % of each focus distance. If one is stated, only this.
    (assumed,) = engine.lens_errors(np.ones(1), None, None)
    foci = [0.8, 0.8 if same else 0.5]
    parts = [0.02 * 0.8 * (0.7 + (0.4 if same else 0.0)), 0.0 if same else 0.02 * foci[1] * 0.4]
    assert assumed == pytest.approx(math.hypot(0.03 * 2.0, *parts), rel=1e-9)
    assert engine.lens_errors(np.ones(1), 0.3, None) == pytest.approx([0.6])


@pytest.mark.parametrize(
    ("misfit", "judged", "code", "severity"),
    [
        (0.69, 1.0, "too_quiet", "error"), (0.71, 1.0, None, None), (1.19, 1.0, None, None),
        (1.21, 1.0, "misfit", "doubt"), (1.79, 1.0, "misfit", "doubt"), (1.81, 1.0, "misfit", "error"),
        (1.81, 0.14, "left_out", "doubt"),
        (1.81, 0.16, "misfit", "error"), (math.nan, 1.0, "no_depth", "error"),
    ],
)  # fmt: skip
def test_a_misfit_is_judged_by_its_limits(misfit, judged, code, severity):
    found = [(one.code, one.severity) for one in DefocusVerdict.of(misfit, judged=judged).findings]
    assert [one for one in found if one[0] != "untested"] == ([(code, severity)] if code else [])


@pytest.mark.parametrize("stated", [0.0, 0.03])
@pytest.mark.parametrize(
    ("sigmas", "others", "severity"),
    [(1.4, (), None), (1.6, (), "doubt"), (2.4, (), "doubt"), (2.6, (), "error"), (2.6, (1.01,), None),
     (2.6, (1.9,), "error")],
)  # fmt: skip
@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_a_scale_is_judged_in_standard_errors(sigmas, others, severity, stated, sign):
    error = 0.04
    scale = 1.0 + sign * sigmas * math.hypot(error, stated)
    verdict = DefocusVerdict.of(1.0, scale, error, others, stated=stated)
    found = [one.severity for one in verdict.findings if one.code == "lens_scale"]
    assert found == ([severity] if severity else [])
    assert math.isnan(verdict.scale) == (others == (1.01,))
    if sigmas < 1.5 and not stated:
        agreed = f"blurs differ as the lenses state ({scale:.2f} +- 0.04 times that; f-numbers off by 6 %"
        assert agreed in verdict.summary  # one and a half standard errors
        assert "state within their stated errors (" in DefocusVerdict.of(1.0, 1.0, 0.02, stated=0.03).summary


def test_cells_are_means_of_the_blocks_that_all_scales_know_and_edges_have_no_weight():
    misfits = RNG.uniform(1.0, 2.0, (2, 1, 16, 16))
    misfits[0, 0, :8, :8] = np.nan
    misfits[0, 0, 0, :8] = misfits[0, 0, 1, :8] = 1.5  # 16 of 64 blocks: just enough
    misfits[1, 0, 8:, 8:14] = np.nan  # 16 left
    misfits[1, 0, 8, 14] = np.nan  # 15: too few
    means, shares = defocus_verdict._cells(misfits)
    assert shares.tolist() == [0.25, 1.0, 1.0]
    assert means[:, 0] == pytest.approx(misfits[:, 0, :2, :8].mean(axis=(1, 2)))
    assert means[:, 1] == pytest.approx(misfits[:, 0, :8, 8:].mean(axis=(1, 2)))
    cells = np.array([[1.0, 1.2, 1.1, 3.0], [1.3, 0.9, 1.2, 4.0]])
    least = np.maximum(cells.min(axis=0), 1.0)
    quartile = np.sort(least)[0] + 0.75 * (np.sort(least)[1] - np.sort(least)[0])
    weights = [s / m**2 if m <= 1.15 * quartile else 0.0 for s, m in zip((0.5, 1.0, 1.0, 1.0), least, strict=True)]
    found = defocus_verdict._weights(cells, np.array([0.5, 1.0, 1.0, 1.0]))
    assert found == pytest.approx(np.array(weights) / sum(weights))
    assert found[3] == 0.0
    known = np.full(100, np.nan)
    known[:2] = 1.0
    assert defocus_verdict._median(known) == math.inf
    known[2] = 4.0
    assert defocus_verdict._median(known) == 1.0


def valleys(scatter, start=1.1, at=0.3, count=16):
    """Return misfits by the step k: cubics with a minimum at `at`, which differ from cell to cell."""
    shifts = scatter * np.linspace(-1.0, 1.0, count)

    def misfits(k):
        x = k - at
        cells = start + 0.02 * x * x + 0.001 * x**3 + shifts * x
        return np.repeat(np.repeat(cells.reshape(1, 4, 4), 8, axis=1), 8, axis=2)

    return misfits, shifts


@pytest.mark.parametrize("scatter", [0.0, 0.01])
@pytest.mark.parametrize("first", [0, 5, -6])
def test_a_scale_and_its_error_are_those_of_the_mean_cubic_of_the_cells(scatter, first):
    misfits, shifts = valleys(scatter)
    found = defocus_verdict._refine_minimum(misfits, first)
    assert found.scale == pytest.approx(math.exp(0.04 * 0.3), rel=1e-3)
    k = found.step
    weights = defocus_verdict._weights(*defocus_verdict._cells(np.stack([misfits(k + j) for j in range(-2, 3)])))
    mean = float(shifts @ weights)
    x = (-0.02 + math.sqrt(0.02**2 - 3 * 0.001 * mean)) / 0.003  # from the minimum of the cubic
    assert found.scale == pytest.approx(math.exp(0.04 * (0.3 + x)), rel=1e-9)
    slopes = weights * (0.04 * x + 0.003 * x * x + shifts)
    curvature = 0.04 + 0.006 * x
    least = 1.1 + 0.02 * x * x + 0.001 * x**3 + mean * x
    error = math.hypot(math.sqrt((slopes**2).sum()), 0.04 * (least - 1.0)) * 0.04 / curvature
    assert found.misfit == pytest.approx(least, rel=1e-9)
    # Misfits are known within 0.0005 and a tenth of what is not noise.
    alike = 0.04 * math.sqrt(2.0 * (0.0005 + 0.1 * (least - 1.0)) / curvature)
    assert found.error == pytest.approx(found.scale * math.hypot(error, alike, 0.02), rel=1e-6)
    assert found.below == pytest.approx(misfits(k)[0].mean() - least if scatter == 0 else found.below, abs=1e-9)


@pytest.mark.parametrize(
    ("difference", "scatter", "equal"),
    [(0.009, 0.0, True), (0.012, 0.0, False), (0.05, 0.2, True), (0.05, 0.01, False)],
)
def test_two_scales_fit_equally_where_their_misfits_differ_by_noise_or_by_what_models_err(difference, scatter, equal):
    """By 2.5 standard errors of the mean over cells, or 0.0005 and a tenth of what the better misfit exceeds 1 by."""
    best, other = (_Minimum(scale, 0.02, misfit, k, 0.001 * k) for scale, misfit, k in ((1.0, 1.1, 0), (1.2, 1.1, 4)))
    cells = {0: np.full(16, 1.1), 4: 1.1 + 0.004 + difference + scatter * np.linspace(-1.0, 1.0, 16)}

    def misfits(k):
        return np.repeat(np.repeat(cells[k].reshape(1, 4, 4), 8, axis=1), 8, axis=2)

    assert defocus_verdict._fits_equally(other, best, misfits) == equal


class Band(SimpleNamespace):
    def places(self):
        return np.arange(9).reshape(3, 3)


def test_errors_of_depth_are_those_of_the_energies_of_filters():
    """Noise, bias and error of filtered frames for each candidate, by sums over frequencies."""
    count, frames, size = 9, 2, 9
    c = np.arange(count)[:, None, None]
    share = RNG.uniform(0.5, 1.0, size)
    band = Band(share=share, fx=RNG.uniform(0.0, 0.5, size), fy=RNG.uniform(0.0, 0.5, size))
    frequency = np.linspace(0.1, 1.0, size)
    transfer = np.stack([np.cos(0.05 * (c[..., 0] - k * 8.0) * frequency) for k in range(frames)], axis=1)
    white, texture = np.array([0.02, 0.03]), 1.0 / frequency
    noise = np.broadcast_to(white[:, None] * 1.1, (count, frames, size))
    filters = np.stack([transfer[:, 1], -transfer[:, 0]], axis=1)[:, None]
    model = SimpleNamespace(band=band, texture=texture, transfer=transfer, noise=noise, white=white)
    overlap = np.array([1.0, 0.5, 0.1])
    found = focal_tables._Statistics.of(model, filters, overlap)
    alone = [sum(share @ filters[k, 0, i] ** 2 * white[i] for i in range(frames)) for k in range(count)]
    assert found.noise == pytest.approx(alone, rel=1e-9)

    def energy(k, depth):
        scene = sum(filters[k, 0, i] * transfer[depth, i] for i in range(frames)) ** 2 @ (share * texture)
        return scene + sum(filters[k, 0, i] ** 2 @ (noise[depth, i] * share) for i in range(frames)) - alone[k]

    slope = np.gradient(filters, axis=0)
    for depth in range(count):
        start = max(0, depth - 6)
        energies = [energy(k, depth) for k in range(start, min(count, depth + 7))]
        k = min(max(int(np.argmin(energies)), 2), len(energies) - 3)
        quartic = np.poly1d(np.polyfit(range(-2, 3), energies[k - 2 : k + 3], 4))
        x = min(quartic.deriv().roots, key=abs).real
        assert found.bias[depth] == pytest.approx(start + k + x - depth, abs=1e-7)
        at = min(max(depth, 1), count - 2) - start
        curvature = 0.5 * (energies[at - 1] - 2.0 * energies[at] + energies[at + 1])
        g, s, h, n = filters[depth, 0], slope[depth, 0], transfer[depth], noise[depth]
        e, d_e = (g * h).sum(axis=0), (s * h).sum(axis=0)
        ee, dd, ed = (
            texture * x * y + (p * q * n).sum(axis=0)
            for x, y, p, q in ((e, e, g, g), (d_e, d_e, s, s), (e, d_e, g, s))
        )
        pixel = (ee * dd + ed * ed) @ share
        assert found.errors[depth] == pytest.approx(math.sqrt(pixel) / max(curvature, 1e-300), rel=1e-6)
    assert np.all(found.texture_ratio >= -1e-9)


def test_the_variance_of_a_window_is_a_sum_over_lags_of_products_of_covariances():
    band = Band(fx=RNG.uniform(0.0, 0.5, 9))
    band.places = lambda: np.arange(9).reshape(3, 3)
    overlap = np.array([1.0, 0.6, 0.2, 0.1])
    a, b = RNG.random((2, 2, 9))
    found = focal_tables._WindowVariance(band, overlap)(a, b)
    fx = band.fx[[2, 5, 8]]
    total = 0.0
    for p, q in zip(a.reshape(2, 3, 3), b.reshape(2, 3, 3), strict=True):
        for y in range(-2, 3):
            for x in range(-2, 3):
                waves = np.outer(np.cos(2 * math.pi * y * fx), np.cos(2 * math.pi * x * fx)) / 9
                total += overlap[abs(y)] * overlap[abs(x)] * (waves * p).sum() * (waves * q).sum()
    assert found == pytest.approx(total, rel=1e-9)


@pytest.mark.parametrize("tol", [1e-2, 1e-4, 1e-6])
def test_windows_are_computed_at_the_fewest_sizes_between_which_they_are_exact(tol):
    cells, low, high = np.arange(6.0), -1.0, 1.5

    def exact(nodes, log):
        return 0.02 * np.exp(-cells * math.exp(-log) * (1.0 + 0.1 * np.abs(nodes)[:, None]))[:, None]

    nodes = np.array([-2.0, 0.5, 3.0])
    windows, transform = _windows_by_size(exact, nodes, exact(nodes, 0.0), (low, high), tol)

    def off(count, places):
        x = np.cos(np.pi * (np.arange(count) + 0.5) / count)
        places = places(np.sort(x))
        logs = [0.5 * (low + high) + 0.5 * (high - low) * np.asarray(at) for at in (x, places)]
        known, wanted = (np.array([exact(nodes, log).ravel() for log in some]) for some in logs)
        series = np.polynomial.chebyshev.chebfit(x, known, count - 1)
        made = np.polynomial.chebyshev.chebval(places, series).T
        shape = (len(places), len(nodes), -1)
        return (np.abs(made - wanted).reshape(shape).max(2) / wanted.reshape(shape).max(2)).max()

    def between(x):
        return [-0.97, 0.5 * (x[0] + x[1]), 0.5 * (x[-1] + x[-2]), 0.5 * (x[len(x) // 2] + x[len(x) // 2 - 1])]

    count = len(windows)
    assert count == next(one for one in _WINDOW_SETS if off(one, between) <= 0.3 * tol)
    assert off(count, lambda _: np.linspace(-1.0, 1.0, 101)) <= tol
    assert transform.shape == (count, count)


def test_windows_of_a_field_may_err_by_what_their_bank_leaves_of_the_tolerance(monkeypatch):
    asked = []
    monkeypatch.setattr(field_blur, "WindowBlur", lambda *_, **given: asked.append(given["allowed"]))
    made = SimpleNamespace(y=0, x=0, defocus=0, threads=1, tol=1e-2)
    axes = (Nodes(0.0, 0.0, 1, 3),) * 3
    field_blur.FieldBlur._operator(
        made, SimpleNamespace(axes=axes, coefficients=np.ones((1, 1, 1, 3, 3)), error=4e-3)
    )
    assert asked == [pytest.approx(6e-3)]
