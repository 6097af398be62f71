"""What is believed of frames that differ in focus, and of blur over the field, a second time."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import (
    bank,
    defocus_depth,
    defocus_verdict,
    field_blur,
    focal_tables,
    live,
    sensor_light,
)
from lommel.imaging.defocus_verdict import _Filters, _Minimum
from lommel.imaging.field_blur import FieldBlur, MixedBlur
from lommel.imaging.live import LiveDepth
from lommel.imaging.spline_nodes import Nodes

RNG = np.random.default_rng(0)


@pytest.mark.parametrize(("scale", "error", "told"), [
    (1.1, 0.099, True), (1.1, 0.101, False), (1.5, 0.199, True), (1.5, 0.201, False), (0.5, 0.199, True),
    (0.5, 0.201, False),
])  # fmt: skip
@pytest.mark.parametrize("few", [False, True])
def test_a_scale_is_told_where_its_error_is_a_tenth_or_its_deviation_over_two_and_a_half(
    scale, error, told, few, monkeypatch
):
    errors, misfit = np.array([[0.5, np.inf], [1e-7, 0.1]]), np.array([[1.1, 9.0], [1.7, 1.2]])
    vergence, slopes = np.array([[1.0, 1.0], [2.0, 4.0]]), np.array([[8.0, -40.0, 5.0], [2.0, 3.0, 1.0]])
    engine = SimpleNamespace(
        lens_derivatives=lambda at: slopes, lens_errors=lambda at, *_: 0.3 * at**2, binning=1,
        task=SimpleNamespace(blur=1.0, scales=None, lenses=()),
    )  # fmt: skip
    minima = [_Minimum(scale, error, 1.0, 0, 0.0), _Minimum(1.9, 0.1, 1.0, 8, 0.0)]
    weights = []
    monkeypatch.setattr(
        defocus_verdict, "_tiles", lambda frames, valid, weight, *_: weights.append(weight) or iter(())
    )
    monkeypatch.setattr(defocus_verdict, "_judged_misfit", lambda *_: None if few else (1.25, 0.6))
    monkeypatch.setattr(defocus_verdict, "_scale_minima", lambda *_: minima)
    monkeypatch.setattr(defocus_verdict, "MIN_BLOCKS", 0)
    images = np.ones((1, 2, 2, 2))
    found = defocus_verdict.judge_frames(engine, images, errors < np.inf, errors, misfit, vergence)
    assert weights[0] == pytest.approx(np.array([[4.0, 0.0], [1e12, 100.0]]))
    assert (found.misfit, found.judged) == ((1.2, 1.0) if few else (1.25, 0.6))
    one = (
        (math.nan, math.inf, 1.1) if scale == 1.1 else (scale, error)
    )  # where one of two scales agrees, both are told
    expected = (*one, 1.9) if told else (math.nan, math.inf)
    assert (found.scale, found.scale_error, *found.others) == pytest.approx(expected, nan_ok=True)
    # Of 8 / 1, 40 / 4 and 5 / 16; and of 2 / 1, 3 / 4 and 1 / 16.
    assert found.changes == pytest.approx((0.08, -0.0075))
    # 5 and 95 % of the vergences 1, 2 and 4.
    assert found.lens_error["nearest"] == pytest.approx([1.0 / 3.8, 0.3])
    assert found.lens_error["farthest"] == pytest.approx([1.0 / 1.1, 0.3])


@pytest.mark.parametrize("steps", [1, 2])
@pytest.mark.parametrize("least", [4.3, 8.4])
def test_the_misfit_of_a_block_is_its_least_energy_over_that_of_noise(least, steps):
    """Filters of one factor g pass g^2 of the light: a parabola of the candidate."""
    squares, white, excess = 1.0 + 0.1 * (np.arange(10) - least) ** 2, 0.4, 0.07
    made = SimpleNamespace(
        _filters=np.sqrt(squares)[:, None, None, None, None] * np.ones((1, 1, 1, 3, 3)), _white=np.array([white]),
        _engine=SimpleNamespace(window_means=lambda blocks: blocks, mean_excess=lambda binning: excess * binning),
        _binning=1, _steps=steps,
    )  # fmt: skip
    light, variance = RNG.normal(size=(8, 8)), RNG.uniform(0.5, 1.0, (2, 2))
    spectra = defocus_verdict.scipy.fft.dctn(light, axes=(0, 1), norm="ortho")[None]
    misfit, curvature = _Filters.minimum(made, SimpleNamespace(variance=variance, spectra=spectra))
    power = (light**2).reshape(2, 4, 2, 4).mean(axis=(1, 3)) / variance - white
    inner = min(round(least), 7)
    lowest = np.where(power > 0.0, round(least), 0)
    for y, x in np.argwhere((lowest == inner) & (power > 0.0)):
        noise = white * squares[inner]
        assert misfit[y, x] == pytest.approx(1.0 + (power[y, x] + excess) / noise, rel=1e-9)
        assert curvature[y, x] == pytest.approx(steps**2 * 0.1 * power[y, x] / noise, rel=1e-6)
    assert np.isnan(misfit[lowest != inner]).all()
    assert (power > 0.0).any()


@pytest.mark.parametrize(("tol", "spans", "degree", "share"), [
    (2e-4, ((0, 1), (0, 0), (0, 0)), 5, 0.9), (4e-4, ((0, 1), (0, 0), (0, 0)), 3, 0.9),
    (4e-4, ((0, 1), (0, 2), (0, 0)), 3, 0.6), (4e-4, ((0, 1), (0, 2), (3, 4)), 5, 1.4 / 3),
    (4e-4, ((0, 0), (0, 0), (0, 0)), 3, 0.9),
])  # fmt: skip
def test_splines_along_each_axis_have_their_share_of_the_tolerance(tol, spans, degree, share, monkeypatch):
    asked = []
    monkeypatch.setattr(field_blur, "sufficient_nodes", lambda sample, *given: asked.append(given) or 1)
    field_blur._axes(None, spans, 3, tol)
    assert asked == [(*span, pytest.approx(share * tol), degree) for span in spans]


@pytest.mark.parametrize(("largest", "first"), [(None, 4), (9, 1)])
def test_a_bank_asks_for_denser_nodes_by_the_root_of_its_error_and_for_more_axes_where_that_fails(
    largest, first, monkeypatch
):
    axes, asked, tol = (Nodes(0.0, 1.0, first, 3), Nodes(0.0, 1.0, 1, 3), Nodes(0.0, 0.0, 1, 3)), [], 1e-2
    sizes = [0.05, 0.0451, 0.0449, 0.02, 0.00971, 0.0096]
    errors = iter([(size, 0.9) for size in sizes])
    source = SimpleNamespace(
        half_widths=lambda spans, energy, most: asked.append(most) or (3, 2),
        windows=lambda places, half: np.full((len(places), 7, 7), 0.95 / 49),
    )
    monkeypatch.setattr(field_blur, "_axes", lambda *given: asked.append(given[2:]) or axes)
    monkeypatch.setattr(field_blur, "_error_between", lambda *_: next(errors))
    monkeypatch.setattr(
        field_blur, "_finer", lambda now, factor, change_single: asked.append((factor, change_single)) or now
    )
    options = SimpleNamespace(energy=0.9, tol=tol, largest=largest, dtype=np.float64)
    made = field_blur.build_field_bank(source, ((0.0, 1.0), (0.0, 1.0), (0.0, 0.0)), (20, 31), options)
    assert asked[:2] == [largest or 10, (2, pytest.approx(0.97 * tol))]
    growth = [max(1.02, (size / (0.9 * 0.97 * tol)) ** 0.25) for size in sizes[:-1]]
    assert asked[2:] == [(pytest.approx(g), k in (1, 2) or (k, first) == (0, 1)) for k, g in enumerate(growth)]
    assert (made.error, made.lost) == pytest.approx((0.0096, 0.1))
    banks = [SimpleNamespace(error=0.2), SimpleNamespace(error=0.3)]
    whole = SimpleNamespace(banks=banks, _operators=[SimpleNamespace(error=0.4), SimpleNamespace(error=0.1)])
    assert FieldBlur.error.fget(whole) == pytest.approx(0.6)
    assert MixedBlur.error == 0.0
    monkeypatch.setattr(field_blur, "_MAX_VALUES", 49 * first - 1)
    with pytest.raises(ValueError, match="exceeds the limit"):
        field_blur.build_field_bank(source, ((0.0, 1.0), (0.0, 1.0), (0.0, 0.0)), (20, 31), options)


@pytest.mark.parametrize(("fraction", "per_row"), [(0.1, 0.0), (0.02, 0.0), (0.0, 0.02), (0.05, 0.01), (0.003, 0.1)])
def test_filters_have_the_lowest_rank_whose_error_is_below_either_limit(fraction, per_row):
    """In the metric over columns, with the weights of rows."""
    rows, root, weights = RNG.normal(size=(9, 6)) * 0.4 ** np.arange(6), RNG.normal(size=(6, 6)), np.linspace(1, 2, 9)
    metric = root @ root.T + np.eye(6)
    left, right = focal_tables._low_rank(rows, metric, weights, fraction, per_row)

    def norm(off):
        return math.sqrt((weights**2) @ np.einsum("rk,kl,rl->r", off, metric, off))

    _, values, _ = np.linalg.svd(weights[:, None] * (rows @ np.linalg.cholesky(metric)))
    most = max(fraction * norm(rows), per_row * 3.0)
    rank = next(k for k in range(7) if math.sqrt((values[k:] ** 2).sum()) < most)
    assert left.shape[1] == rank
    assert norm(left @ right - rows) == pytest.approx(math.sqrt((values[rank:] ** 2).sum()), rel=1e-6)


@pytest.mark.parametrize(("between", "focal", "ends"), [
    ((0.5, 2.0), 0.1, (0.38, 2.12)), ((0.5, 20.0), 0.1, (0.0, 2.156)), ((0.5, 2.0), 0.44, (0.38, 0.9 / 0.44)),
    ((0.5, 2.0), 0.48, (0.38, 2.0)),
])  # fmt: skip
def test_candidates_extend_by_eight_hundredths_up_to_infinity_and_nine_tenths_of_the_focal_length(
    between, focal, ends
):
    lenses = [SimpleNamespace(focal_length=focal), SimpleNamespace(focal_length=0.5 * focal)]
    assert focal_tables.candidates(between, 4, lenses) == pytest.approx(np.linspace(*ends, 4))


@pytest.mark.parametrize(("tol", "expected"), [(0.1, 1e-6), (1.1e-3, 1e-6), (0.9e-3, 0.9e-6), (1e-6, 1e-9)])
def test_psfs_over_the_field_have_a_thousandth_of_the_tolerance_or_a_millionth(tol, expected, monkeypatch):
    asked = []
    monkeypatch.setattr(field_blur, "build_field_bank", lambda source, *_: asked.append(source) or source)
    monkeypatch.setattr(FieldBlur, "_operator", lambda *_: None)
    field = lm.FieldMap.from_seidel(20e-3, W131=1.0, wavelength=550e-9, f_number=4.0)
    FieldBlur(field, 8, 5e-6, tol=tol)
    assert asked[0].tol == pytest.approx(expected, rel=1e-12)
    monkeypatch.setattr(field_blur, "psf", lambda *_, tol, **others: SimpleNamespace(values=asked.append(tol) or 2.0))
    assert (asked[0].windows(np.zeros((1, 3)), 1) == 2.0).all()
    assert asked[1:] == [asked[0].tol]


@pytest.mark.parametrize("wavelengths", [(550e-9,), (400e-9, 600e-9)])
def test_no_pixel_has_more_light_than_its_area_in_v_over_four_pi(wavelengths, monkeypatch):
    """The peak of I is at most 1 / (4 pi) of the light for a unit of v^2, at the shortest wavelength."""
    pupil, asked = lm.Pupil(wavelength=550e-9, f_number=4.0), {}
    monkeypatch.setattr(bank.DefocusNodes, "of", lambda *_, **given: asked.update(given) or 1 / 0)
    light = bank.SensorLight(pupil, lm.Wavefront, tuple((w, 1.0 / len(wavelengths)) for w in wavelengths), 3e-6)
    with pytest.raises(ZeroDivisionError):
        bank.build_bank(light, (1.0, 4.0), tol=1e-3, energy=0.9, largest=30)
    assert asked["bound"] == pytest.approx(
        (math.pi * 3e-6 / (min(wavelengths) * 4.0)) ** 2 / (4.0 * math.pi), rel=1e-9
    )


def test_a_parabola_through_peaks_is_theirs_where_they_differ():
    made = sensor_light.Parabola.through(
        np.array([1.0, 2.5, 4.0]), 1.0 / (0.3 * (np.array([1.0, 2.5, 4.0]) - 2.2) ** 2 + 2.0)
    )
    assert (made.curvature, made.middle, made.least) == pytest.approx((0.3, 2.2, 2.0))


def test_scales_are_searched_from_the_stated_one(monkeypatch):
    """Much less blur than stated may fit better than a little less; the search must not end there."""
    misfits = {0.5: 1.2, 0.6: 1.4, 0.8: 5.0, 0.95: 1.3, 1.0: 1.0, 1.1: 2.0, 1.3: 6.0, 2.0: 9.0}

    def filters(engine, channel, scale, **_):
        return lambda tile: float(np.interp(scale, [*misfits], [*misfits.values()]))

    monkeypatch.setattr(defocus_verdict, "_Filters", filters)
    monkeypatch.setattr(defocus_verdict, "_median", float)
    monkeypatch.setattr(defocus_verdict, "_cells", lambda _: (None, range(1000)))
    monkeypatch.setattr(
        defocus_verdict, "_refine_minimum", lambda misfits, k: _Minimum(math.exp(0.04 * k), 0.1, 1.0, k, 0.0)
    )
    tile = defocus_verdict._Tile((slice(0), slice(0)), np.ones(0), np.ones((2, 2)))
    found = defocus_verdict._scale_minima(None, 0, tile, [tile], 1.0)
    assert [minimum.scale for minimum in found] == [1.0]


@pytest.mark.parametrize("masked", [False, True])
def test_live_frames_are_judged_where_all_are_known_by_the_errors_of_vergence(masked, monkeypatch):
    given, rng, block = [], np.random.default_rng(5), live.BLOCK
    monkeypatch.setattr(live, "judge_frames", lambda *all_of_it, **_: given.extend(all_of_it))
    size = 2 * block + 1, 3 * block
    planes, gains = rng.uniform(10.0, 90.0, (2, *size)).astype(np.float32), rng.normal(size=(2, 6))
    planes[0, 0, 0], planes[1, 1, 0], planes[0, 2, 0] = np.nan, 90.0, np.inf
    mask = np.ones(size, np.uint8) if masked else None
    if masked:
        mask[3, 0] = 0
    depth, errors, misfit = rng.uniform(0.5, 3.0, (3, 2, 3))
    errors[0, 1] = np.nan
    call = live._Call(SimpleNamespace(engine="engine"), 0, 0, mask)
    made = SimpleNamespace(
        _last_call=lambda: call, _grey=lambda *_: (list(planes), 90.0),
        _form=SimpleNamespace(size=size), _offset=4.0, _gains=gains, _depth=depth, _errors=errors, _misfit=misfit,
        noise="estimated", _estimates=masked, _excess=1.0,
    )  # fmt: skip
    made._electrons = lambda: LiveDepth._electrons(made)
    LiveDepth.verdict(made, focus_error=0.1)
    assert given[6:] == [(None, 0.1), ("estimated", 0.0, pytest.approx(math.nan, nan_ok=True)) if masked else None]
    unknown = {(0, 0), (1, 0), (2, 0), *([(3, 0)] if masked else [])}
    assert {tuple(at) for at in np.argwhere(~given[2]).tolist()} == unknown
    for row, column in ((0, 0), (5, 7), (2 * block, 3 * block - 1), (1, block), (block, 0)):
        x, y = (2.0 * (at + 0.5) / side - 1.0 for at, side in ((column, 3 * block), (row, 2 * block + 1)))
        terms = np.array([1.0, x, x * x, y, x * y, y * y])
        light = [float(g @ terms) * (float(p[row, column]) - 4.0) for g, p in zip(gains, planes, strict=True)]
        known = (row, column) not in unknown
        assert given[1][0, :, row, column] == pytest.approx(light if known else [0.0, 0.0], rel=1e-6)
        at = min(row // block, 1), column // block
        error = math.inf if at == (0, 1) else errors[at] / depth[at] ** 2
        found = [one[row, column] for one in given[3:6]]
        assert found == pytest.approx([error, misfit[at], 1.0 / depth[at]])


@pytest.mark.parametrize("stated", [{}, {"f_number_error": 0.02}, {"focus_error": 0.1}])
def test_depth_and_its_error_follow_from_those_of_a_candidate(stated, monkeypatch):
    """Candidates are equal steps of v = 1 / z, so that dz = z^2 dv; frames have the exposure of the first."""
    lens = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.25, wavelength=540e-9)
    photos, seen, added = [np.full((64, 64), 0.2), np.full((64, 64), 0.3)], SimpleNamespace(), []
    position, errors = np.full((64, 64), 7.3, np.float32), np.full((64, 64), 0.4, np.float32)

    def engine(task, light):
        seen.task, seen.light = task, light
        return SimpleNamespace(known=0.15)

    def search(engine, images, valid, progress):
        seen.images = images.copy()
        return position.copy(), errors.copy(), np.ones((64, 64))

    def slopes(position, index_errors, window, limit):
        seen.window, seen.limit = window, limit

    monkeypatch.setattr(defocus_depth, "FocalEngine", engine)
    monkeypatch.setattr(defocus_depth, "_search", search)
    monkeypatch.setattr(defocus_depth, "_add_slope_errors", slopes)
    monkeypatch.setattr(defocus_depth, "_add_lens_errors", lambda engine, errors, *_: added.append(errors))
    monkeypatch.setattr(defocus_depth, "judge_frames", lambda *given, **_: given)
    noise, lenses = lm.Noise(white=1e4, read=3.0), [lens, lens.focused(2.0)]
    found = defocus_depth.depth_from_defocus(
        photos, lenses, 4e-6, encoding="linear", noise=noise, between=(0.8, 4.0), **stated
    )
    step = float(seen.task.vergence[1] - seen.task.vergence[0])
    z = 1.0 / (float(seen.task.vergence[0]) + step * float(position[0, 0]))
    assert (found.depth[1, 2], found.errors[1, 2]) == pytest.approx((z, z * z * step * 0.4), rel=1e-6)
    assert (seen.light.mean, *found.exposures) == pytest.approx((2000.0, 1.0, 1.5), rel=1e-6)
    assert seen.images.mean(axis=(0, 2, 3)) == pytest.approx([2000.0, 2000.0], rel=1e-5)
    assert (seen.window, seen.limit) == (defocus_depth.WINDOW, pytest.approx(0.15 / step))
    errors_of_lens = stated.get("f_number_error"), stated.get("focus_error")
    assert (found.verdict[-2:], added) == ((errors_of_lens, None), [errors_of_lens] if stated else [])
