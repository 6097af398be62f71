"""What is accepted, done again or given up, and the bounds that this rests on, a second time."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel.core.answers import Samples, Slopes, ToleranceError, Wanted
from lommel.estimation import bead_checks, bead_search, fisher
from lommel.fit.goodness_of_fit import largest_plausible_chi2
from lommel.imaging import defocus_verdict, field_blur
from lommel.imaging.defocus_verdict import _Minimum
from lommel.imaging.live import LiveDepth
from lommel.localize.checks import Checks
from lommel.methods import averaging
from lommel.methods.averaging import Averages
from lommel.methods.layers import slopes
from lommel.methods.layers.stratified import By
from lommel.methods.method import with_model_error
from lommel.microscopy import preparation
from lommel.optics.grid import Grid
from lommel.optics.layers import debye
from lommel.recorded.noise import Noise
from objectives import OIL

STORED = {np.float64: 6.0 * 2.0**-53, np.float32: 6.0 * 2.0**-53 + 2.0**-24}
RNG = np.random.default_rng(0)


def told(findings):
    return [(one.code, one.severity) for one in findings]


@pytest.mark.parametrize("stretch", [0.7, 1.6])
@pytest.mark.parametrize("normalized", [False, True])
def test_terms_that_are_left_out_are_off_by_the_field_that_they_may_make(stretch, normalized):
    """A phase error e changes U by at most e A, both more at shorter wavelengths; light counts twice."""
    phase, light, amplitude, tol = 2e-5, 3e-6, 0.8, 1e-3
    own = Slopes(np.ones((1, 2, 3, 3)), np.array([[1e-5, 2e-5]]))
    images = Samples(RNG.uniform(0.1, 0.6, (2, 3, 3)), np.array([0.5, 2.0]), np.array([1e-4, 2e-4]), own, None)
    method = SimpleNamespace(stretch=lambda _: stretch, keeps_tol=True, tol=tol)
    found = with_model_error(
        images, SimpleNamespace(left_out=(phase, light), amplitude=amplitude), method, normalized=normalized
    )
    for k in range(2):
        root = math.sqrt(images.values[k].max() / images.scale[k])
        e = max(1.0, stretch) * amplitude * (max(1.0, stretch) * phase + 2.0 * light)
        off = (2.0 * root * e + e * e) / (root - e) ** 2
        off = 2.0 * off / (1.0 - off) if normalized else off
        assert found.error[k] == pytest.approx(images.error[k] + off, rel=1e-9)
        # 2 |U U'| where both are off by e, and at most the amplitude.
        assert found.slopes.error[0, k] == pytest.approx(own.error[0, k] + 4.0 * e * amplitude / root**2, rel=1e-9)
    with pytest.raises(ToleranceError, match="terms of the wavefront leave"):
        with_model_error(images, SimpleNamespace(left_out=(1.0, 0.0), amplitude=0.3), method, normalized=False)
    exact = SimpleNamespace(left_out=(0.0, 0.0), amplitude=0.3)
    assert with_model_error(images, exact, method, normalized=False) is images


@pytest.mark.parametrize("own_peak", [False, True])
def test_far_pixels_take_the_share_of_the_tolerance_that_the_peak_allows(own_peak, monkeypatch):
    grid, tol, asked = Grid((9, 10), 1.0, center=(4.0, 5.0), integrate=True), 1e-3, []
    allowed = (0.4 if own_peak else 1.0) * (tol - (1.0 + tol) * STORED[np.float64])
    peak, near_error, wanted = 0.25, 1e-4, Wanted(None if own_peak else 1.0, np.float64)
    sizes = iter([0.6 * tol * peak / (0.4 if own_peak else 0.5), 0.3 * allowed * peak])
    used, worse = [], np.array([0.01, 1.0])

    def far(pupil, whole, limit, share, threads):
        asked.append(share)
        used.append(next(sizes))
        values, axes = np.full((2, 9, 10), 0.2 if own_peak else 0.01), np.array([[4.0, 5.0]] * 2)
        return SimpleNamespace(axes=axes, nearest=np.full(2, 2.0), values=values, error=used[-1] * worse)

    def near(sample, pupil, box, tol, wanted):
        assert (box.shape, *map(float, box.center)) == ((5, 5), 2.0, 2.0)
        return Averages(np.full((1, 2, 5, 5), 0.15), np.full((1, 2), near_error), np.full(2, peak))

    monkeypatch.setattr(averaging, "largest_far_start", lambda *_: 5.0)
    monkeypatch.setattr(averaging, "pixel_averages", near)
    found = averaging._near_and_far(None, far, lm.Pupil(lm.Wavefront([0.0, 1.0])), grid, tol, wanted)
    off = np.array(used) / peak
    whole = 2.0 * off / (1.0 - off) if own_peak else off
    whole = whole + (1.0 + whole) * STORED[np.float64]
    assert whole[0] > tol >= whole[1]
    assert asked == pytest.approx([0.7 * allowed, 0.7 * allowed * 0.8 * allowed / off[0]], rel=1e-9)
    assert found.error[0] == pytest.approx([near_error, max(near_error, whole[1])], rel=1e-9)
    assert found.peak == pytest.approx([peak, peak])
    assert np.count_nonzero(found.values == 0.15) == 50


def test_derivatives_by_chords_are_those_of_the_rule_times_their_factors():
    """d (f I) = f dI + f' I: both errors add up, and so does what storing rounds of the largest."""
    pupil = OIL.pupil(depth=0.5e-6, z=[0.0, 3e-7], wavelength=520e-9)
    values, bounds, largest = (RNG.uniform(0.1, 1.0, size) for size in ((2, 2, 3, 3), (2, 2), (2, 2)))
    bounds[1] *= 1e-14  # which rounding exceeds
    scale, error, peaks = np.array([0.5, 0.7]), np.array([0.1, 0.2]), np.array([1.5, 1.2])
    images = Samples(RNG.uniform(0.1, 1.0, (2, 3, 3)), scale, error, None, peaks)
    rule = SimpleNamespace(differentiated=lambda *_: (images, values.copy(), bounds, largest))
    image_factor = np.array([0.3, -0.8])
    pairs = [(By(0, image_factor), 2.0)]
    steepest = debye.steepest(pupil.layers, pupil.light.model)[0]
    found = slopes._by_chords(rule, pupil, Grid(3, 0.5), pairs, ((2, 2),), 1e-3, Wanted(0.5, np.float64))
    for k, (factor, offset) in enumerate(((steepest / 2.0, image_factor / 2.0), (1.0, np.zeros(2)))):
        for n in range(2):
            exact = factor * images.scale[n] * values[k, n] + offset[n] * images.values[n]
            assert found.slopes.values[k, n] == pytest.approx(exact, rel=1e-12)
            peak, bound = images.brightest[n], images.error[n]
            most = factor * largest[k, n] + abs(offset[n]) * (1.0 + 2.0 * bound) * peak
            off = factor * bounds[k, n] + abs(offset[n]) * (bound + 1e-12) * peak
            off += (STORED[np.float64] + 2.0**-48) * most
            assert found.slopes.error[k, n] == pytest.approx(off / peak, rel=1e-9)


class Spots:
    """Points whose light widens down the field, with a part that no window holds."""

    def windows(self, places, half):
        offsets = np.arange(-half, half + 1.0)
        radius = np.hypot(offsets[:, None], offsets)
        width = 1.0 + 0.3 * np.sin(2.0 * np.asarray(places)[:, :1, None]) ** 2
        return 0.98 * np.exp(-0.5 * (radius / width) ** 2) / (2.0 * math.pi * width**2)

    def half_widths(self, spans, energy, largest):
        return 3, 2


@pytest.mark.parametrize("tol", [1e-2, 1e-3])
def test_a_bank_of_windows_errs_by_less_than_its_splines_may_and_lacks_what_it_says(tol):
    asked = SimpleNamespace(energy=0.95, tol=tol, largest=12, dtype=np.float64)
    bank = field_blur.build_field_bank(Spots(), ((-1.0, 1.0), (0.0, 0.0), (0.0, 0.0)), (40, 40), asked)
    half = bank.coefficients.shape[-1] // 2
    nodes = np.array([[y, 0.0, 0.0] for y in (*bank.axes[0].places, *bank.axes[0].between)])
    light = Spots().windows(nodes, half).sum(axis=(1, 2))
    assert bank.lost == pytest.approx(1.0 - light.min(), rel=1e-9)
    assert light.min() >= 0.95 > Spots().windows(nodes, half - 1).sum(axis=(1, 2)).min()
    worst = 0.0
    for y in np.linspace(-1.0, 1.0, 301):
        exact = Spots().windows([[y, 0.0, 0.0]], half)[0]
        off = bank.window(y, 0.0) - exact / exact.sum()
        worst = max(worst, np.abs(off).sum() + abs(off.sum()))
    assert 0.3 * bank.error <= worst <= bank.error <= 0.97 * tol


def test_information_of_a_scene_is_the_sum_over_its_images():
    names, roots, errors = ("defocus", "photons"), RNG.normal(size=(2, 3, 4, 2)), RNG.uniform(1e-9, 1e-8, (2, 3, 2))
    roots = np.linalg.qr(roots.reshape(6, 4, 2), mode="r").reshape(2, 3, 2, 2)
    found = fisher._scene_information(names, roots, errors, (1,))
    for scene in range(2):
        total = np.zeros((4, 4))
        for image in range(3):
            places = [0, 1 + image]
            total[np.ix_(places, places)] += roots[scene, image].T @ roots[scene, image]
        assert found.matrix[scene] == pytest.approx(total, rel=1e-9, abs=1e-12)
        inverse = np.linalg.inv(total)
        for k, name in enumerate(("defocus", "photons[0]", "photons[1]", "photons[2]")):
            assert found.errors[name][scene] == pytest.approx(math.sqrt(inverse[k, k]), rel=1e-6)
            expected = inverse[k] / np.sqrt(np.diag(inverse) * inverse[k, k])
            assert found.correlation[scene, k] == pytest.approx(expected, rel=1e-6)
    none = fisher._correlation(np.array([[4.0, 0.0, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 1.0]]))
    assert none.tolist() == [[1.0, 0.0, 0.5], [0.0, 1.0, 0.0], [0.5, 0.0, 1.0]]


@pytest.mark.parametrize("share", [0.1, 0.2, 0.9])
def test_the_misfit_of_blocks_is_judged_where_slopes_explain_little_of_it(share, monkeypatch):
    side, block = 32, defocus_verdict.BLOCK
    misfit, curvature = RNG.uniform(0.8, 1.6, (side, side)), RNG.uniform(0.1, 1.0, (side, side))
    misfit[3], curvature[5] = np.nan, -1.0
    variation = np.where(RNG.uniform(size=(side, side)) < share, 0.1, 9.0) / np.abs(curvature)
    fine = np.repeat(np.repeat(variation, block, 0), block, 1) * RNG.choice([0.5, 1.5], (side * block,) * 2)
    monkeypatch.setattr(defocus_verdict, "_depth_variation", lambda *_: fine)
    filters = SimpleNamespace(minimum=lambda tile: (misfit, curvature))
    monkeypatch.setattr(defocus_verdict, "_Filters", lambda *_: filters)
    found, judged = [], 0
    for i in range(side):
        for j in range(side):
            mean = fine[i * block : (i + 1) * block, j * block : (j + 1) * block].mean()
            off = curvature[i, j] * mean if curvature[i, j] > 0.0 else math.inf
            if np.isfinite(misfit[i, j]):
                found.append((misfit[i, j], off))
                judged += off < 0.5
    kept = [m - o for m, o in found if o < 0.5]
    if judged / len(found) < 0.15:
        kept += [m for m, o in found if o >= 0.5]
    tile = SimpleNamespace(inside=(slice(None), slice(None)))
    vergence = np.ones((side * block, side * block))
    whole = defocus_verdict._judged_misfit(None, 0, [tile], vergence)
    assert whole == pytest.approx((np.median(kept), judged / len(found)), rel=1e-9)
    misfit[:] = np.nan
    misfit[0, :15] = 1.0  # of 1024 blocks less than 16
    assert defocus_verdict._judged_misfit(None, 0, [tile], vergence) is None


@pytest.mark.parametrize(("depth", "several"), [(0.061, True), (0.079, False)])
def test_scales_are_refined_where_the_misfit_has_a_valley_nearly_as_deep(depth, several, monkeypatch):
    """Valleys up to 0.02 and half of 0.1 above the least of 1.1 count; the search ends at 2.5 of it."""

    def misfit(k):
        return min(1.1 + depth + 0.02 * (k + 4) ** 2, 1.1 + 0.02 * (k - 6) ** 2)

    tried, refined = [], []

    def filters(engine, channel, scale, *, binned):
        assert binned
        tried.append(round(math.log(scale) / 0.04))
        return lambda tile: np.array([misfit(tried[-1]), np.nan])

    def refine(misfits, k):
        refined.append(k)
        return _Minimum(math.exp(0.04 * k), 0.1, misfit(k), k, 0.0)

    for name, made in (
        ("_Filters", filters), ("_refine_minimum", refine), ("_cells", lambda of: (of, np.ones(9))),
        ("_fits_equally", lambda *_: True),
    ):  # fmt: skip
        monkeypatch.setattr(defocus_verdict, name, made)
    tile = defocus_verdict._Tile((slice(0), slice(0)), np.ones(0), np.ones(4))
    found = defocus_verdict._scale_minima(None, 0, tile, [tile], 0.9)
    assert refined == [-4, 6] if several else refined == [6]
    assert [one.step for one in found] == refined[::-1]  # the best one first
    # Far from the valleys at the smallest scales the misfit is large, too: only larger ones are left out.
    # From the stated scale up, and down, each to where the misfit is large.
    assert tried[0] == 0
    assert tried == sorted(k for k in tried if k >= 0) + sorted((k for k in tried if k < 0), reverse=True)
    assert {-4, 6} < set(tried)


@pytest.mark.parametrize(("count", "mean", "spread", "expected"), [
    (100, 0.5, 1.0, True), (100, 0.5, 1.3, False), (100, 0.099, 0.01, False), (100, 0.101, 0.01, True),
    (9, 5.0, 0.1, False), (10, 5.0, 0.1, True),
])  # fmt: skip
def test_another_table_is_told_by_ten_of_likelihood_and_four_standard_errors(count, mean, spread, expected):
    gains = mean + spread * np.where(np.arange(count) % 2, 1.0, -1.0)
    other = SimpleNamespace(_gains=gains.tolist(), _changes=SimpleNamespace(gain=1.4 * mean))
    explained = SimpleNamespace(_gains=gains.tolist(), _changes=SimpleNamespace(gain=1.6 * mean))
    assert not list(Checks._rival_findings(explained))
    (found,) = Checks._rival_findings(other) if expected else (None,)
    assert expected or not list(Checks._rival_findings(other))
    if found:
        assert told([found]) == [("opposite_astigmatism", "error")]
        total, error = found.numbers["log_likelihood"], found.numbers["error"]
        assert (total, error) == pytest.approx((gains.sum(), math.sqrt(count * gains.var())), rel=1e-9)


@pytest.mark.parametrize("step", [0.99, 1.01])
@pytest.mark.parametrize(("chi2", "gain"), [(1.2, 12.0), (20.0, 12.0), (30.0, 12.0)])
def test_planes_are_reversed_where_that_fits_and_is_far_likelier(chi2, gain, step, monkeypatch):
    deviation, steps = 0.05, []
    limit = max(float(largest_plausible_chi2(deviation)), 1.0 + 0.25 * (chi2 - 1.0))
    made = {"quality": (limit * (2.0 - step), deviation), "log_posterior": 100.0 + gain * step}
    starts = []

    def climb(model, state, most, report):
        steps.append(most)
        starts.append(state.waves)
        return fit

    monkeypatch.setattr(bead_checks, "climb", climb)
    images = SimpleNamespace(estimated_terms=((2, 2), (3, -1)))
    for side in (0.9, 2.0 - step, 1.001):
        fit = SimpleNamespace(**made | {"quality": (limit * side, deviation)})
        model = bead_search.BeadModel.__new__(bead_search.BeadModel)
        monkeypatch.setattr(bead_checks, "replace", lambda one, **_: one)
        vars(model).update(stacks=(), depths=(), images=images)
        start = SimpleNamespace(setup=None, waves=np.array([0.1, 0.2]))
        found = bead_checks.reversed_findings(model, start, 100.0, chi2, None)
        assert told(found) == ([("reversed_z", "error")] if step > 1.0 > side else [])
    assert set(steps) == {20 if chi2 < 20.0 else 10}
    np.testing.assert_array_equal(starts, [[-0.1, 0.2]] * 3)  # even terms are those of the other side of the focus


@pytest.mark.parametrize(("posterior", "chi2", "settled", "same"), [
    (0.99, 2.0, False, True), (-0.99, 2.0, True, True), (1.01, 3.0, True, False), (50.0, 2.009, True, True),
    (50.0, 2.011, True, False), (50.0, 2.009, False, False),
])  # fmt: skip
def test_two_starts_end_at_one_maximum_or_fit_as_badly(posterior, chi2, settled, same):
    def ended(posterior, chi2):
        return SimpleNamespace(quality=(chi2, 0.01), log_posterior=posterior, settled=settled, fits=lambda _: False)

    assert bead_search._same_maximum(ended(7.0, 2.0), ended(7.0 + posterior, chi2)) == same


@pytest.mark.parametrize(("dark", "noted"), [(19, False), (21, True)])
def test_voxels_below_the_offset_are_told_of_where_read_noise_does_not_explain_them(dark, noted):
    floor, stack = 100.0 - 3.0 * math.hypot(2.0 / 0.5, 0.3), np.full((2, 20, 25), 130.0)
    stack.flat[: dark + 30] = np.concatenate([np.full(dark, floor - 0.01), np.full(30, floor + 0.01)])
    notes = []
    preparation._check_noise(stack, Noise(white=0.5, read=2.0, offset=100.0), notes)
    assert any("below the offset" in note for note in notes) == noted


def test_tables_of_live_depth_are_saved_with_the_noise_and_what_saturated_pixels_have(tmp_path):
    """Of floats, which have no largest value, it is the one that was stated."""
    engine = SimpleNamespace(tables=lambda *numbers: repr(numbers).encode())
    form = SimpleNamespace(channels=1, white=0.5, offset=100.0, saturation=lambda kind: {"f": 7.0}[kind.kind])
    made = SimpleNamespace(_levels=[SimpleNamespace(engine=engine)], _form=form, _smooth=False, _registered=False)
    LiveDepth.save(made, tmp_path / "a.lml")
    assert (tmp_path / "a.lml").read_bytes() == b"(0.5, 100.0, 7.0)"
