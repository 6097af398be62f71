"""What is left out of a recording, or told of it, and what of a restoration is believed, a second time."""

from __future__ import annotations

import inspect
import math
from contextlib import nullcontext
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel import microscopy
from lommel.base.units import with_error
from lommel.core.answers import ToleranceError
from lommel.deconvolve.algorithms import MISFIT, STEPS, Restoration, RichardsonLucy, TotalVariation
from lommel.imaging import restoration
from lommel.imaging.defocus_depth import DefocusDepth, DefocusOptions
from lommel.imaging.field_blur import FieldPhotographOptions
from lommel.imaging.focal_engine import FocalEngine
from lommel.imaging.live import LiveDepth
from lommel.imaging.settings import TableOptions
from lommel.microscopy import chunks, light_checks, modalities, preparation, stack_blur
from lommel.recorded import camera_noise, counts
from lommel.recorded.camera_noise import StackView, hot_pixels, hot_voxels
from lommel.recorded.noise import Noise
from objectives import OIL

RNG = np.random.default_rng(0)
VORTEX = {"emitter": lm.Beam("vortex")}


@pytest.mark.parametrize(("ratio", "count", "told"), [
    (math.exp(0.299), 10**4, False), (math.exp(0.301), 10**4, True), (math.exp(-0.299), 10**4, False),
    (math.exp(-0.301), 10**4, True), (0.59, 400, False), (0.57, 400, True), (0.0, 10**4, True),
])  # fmt: skip
@pytest.mark.parametrize("kind", [np.uint16, np.float32])
def test_noise_contradicts_by_a_logarithm_of_three_tenths_or_four_standard_errors(
    ratio, count, told, kind, monkeypatch
):
    mean = np.linspace(5.0, 300.0, count)
    expected = np.maximum(mean - 10.0, 0.0) / 0.5 + 16.0 + (1.0 / 12.0 if kind == np.uint16 else 0.0)
    variances = mean, 0.4549 * ratio * expected, 1.0 if count > 400 else 0.25  # of 100 that are independent
    monkeypatch.setattr(camera_noise, "_local_variances", lambda _: variances)
    monkeypatch.setattr(camera_noise, "_fit_noise", lambda *_: (Noise(white=0.4, read=2.0, offset=3.0), 0.1))
    text = camera_noise.contradiction(np.zeros((1, 2, 2), kind), Noise(white=1.0, read=4.0, offset=10.0, excess=2))
    assert bool(text) == told
    assert not told or " +- ".join(with_error(0.8, 0.08)) in text


@pytest.mark.parametrize("beside", [60.0, 130.0, 700.0])
@pytest.mark.parametrize("white", [None, 0.5])
def test_a_hot_voxel_exceeds_its_neighbours_threefold_and_ten_standard_deviations(beside, white):
    """Twice the 1.5 that the PSF allows, over the median of 100."""
    gain, stack = white or 1.0, np.full((1, 7, 7), 100.0)
    stack[0, 3, 4] = beside
    values = np.arange(100.0, 5000.0, 0.1)
    least = 3.0 * max(beside - 100.0, 0.0) + 10.0 * np.sqrt(gain * (values - 10.0) + 9.0) / gain
    first = values[np.argmax(values - 100.0 > least)]
    for value, limit, hot in ((first, 1e9, 1), (first - 0.2, 1e9, 0), (first, first, 0), (first, first + 0.1, 1)):
        stack[0, 3, 3] = value
        found = hot_voxels(stack, Noise(white=white, read=3.0, offset=10.0), 1.5, limit)
        assert found.tolist() == [[0, 3, 3]] * hot


@pytest.mark.parametrize(("part", "limit", "hot"), [
    (1.01, math.inf, True), (0.99, math.inf, False), (1.01, 762.0, True), (1.01, 761.0, False),
])  # fmt: skip
def test_a_hot_pixel_steps_up_twice_as_steeply_as_a_point(part, limit, hot):
    """With a PSF that falls by half to its neighbours: by more than 2 8 / 7 of the step from there outwards."""
    stack = np.full((6, 9, 9), 100.0)
    for y, x in ((3, 4), (5, 4), (4, 3), (4, 5)):
        stack[:, y, x] = 300.0 - (y == 3)
    stack[:, 4, 4] = 300.0 + part * 2.0 * 8.0 / 7.0 * 200.0
    assert hot_pixels(stack, Noise(white=1.0, read=1.0), 2.0, limit)[4, 4] == hot


@pytest.mark.parametrize(("kind", "limit", "own", "unknown"), [
    (np.uint8, 99.5, 99.5, 100), (np.uint8, math.inf, 255.0, 255), (np.uint64, math.inf, 2.0**64, 2**64 - 1),
    (np.float32, 99.5, 99.5, None),
])  # fmt: skip
def test_unknown_voxels_of_integers_have_the_least_value_that_is_saturated(kind, limit, own, unknown):
    view = StackView(np.full((1, 2, 2), 7, kind), limit, voxels=np.array([[0, 1, 0]]))
    assert view.limit == own
    assert np.isnan(view[0][1, 0]) if unknown is None else int(view[0][1, 0]) == unknown


@pytest.mark.parametrize(
    ("stated", "limit"), [(1e15, math.inf), (0.9e15, 0.9e15), (-1e15, -1e15), (math.inf, math.inf)]
)
def test_a_stated_saturation_is_taken_up_to_what_is_beyond_any_camera(stated, limit):
    planes, full = [np.arange(64, dtype=np.uint16)], np.append(np.arange(9), [255] * 9)
    assert counts.full_value(planes, stated) == (limit, "")
    with pytest.raises(ValueError, match="saturation"):
        counts.full_value(planes, -1.1e15)
    assert counts.full_value([full.astype(np.uint8)], None) == (255.0, "")
    assert counts.full_value([full.astype(np.uint16)], None)[0] == 255.0
    assert counts.full_value([full.astype(np.uint16) + 1], None) == (65535.0, "")


@pytest.mark.parametrize("white", [None, 0.5])
def test_saturated_voxels_are_counted_and_have_no_part_in_the_mean_light(white):
    stack, notes = np.array([[[5, 9, 65535], [65535, 1, 65534]]] * 2, np.uint16), []
    assert preparation._saturation_limit(stack, None, notes) == 65535
    assert preparation._saturation_limit(stack, 9, notes) == 9
    assert notes[0].startswith("4 voxels (33 %) have the maximum of their type, 65535, or more")
    assert notes[1].startswith("8 voxels (67 %) have the saturation that was stated, 9, or more")
    values = stack.astype(np.float32)
    values[0, 1, 1] = np.nan
    context = SimpleNamespace(stack=values, camera=Noise(white=white, read=1.0, offset=0.5), saturation=9.0)
    assert chunks._mean_light(context) == pytest.approx((4.5 + 4.5 + 0.5) / 3.0)


@pytest.mark.parametrize(("size", "axes", "even"), [
    (0.9e-6, (1, 2), True), (1.1e-6, (1,), False), (1.1e-6, (2,), False), (1.1e-6, (), True),
])  # fmt: skip
def test_a_kernel_is_even_where_it_is_its_mirror_along_both_sides_within_a_millionth_of_its_peak(size, axes, even):
    kernel = 4.0 * np.exp(
        -np.add.outer(np.arange(-1.0, 1.0) ** 2, np.add.outer(np.arange(-2, 3) ** 2, np.arange(-2, 3) ** 2))
    )
    for axis in axes:
        place = [0, 2, 2]
        place[axis] = 1
        kernel[tuple(place)] += 4.0 * size
    assert stack_blur._mirror_symmetric(kernel) == even


@pytest.mark.parametrize(("after", "before", "overdone", "stopped", "method", "rejected"), [
    (1.21, 3.0, False, "settled", RichardsonLucy(), False), (1.23, 3.0, False, "settled", RichardsonLucy(), True),
    (1.23, 3.0, False, STEPS, RichardsonLucy(), False), (1.23, 3.0, False, STEPS, TotalVariation(), True),
    (1.21, 3.0, True, "settled", RichardsonLucy(), True), (1.049, 0.5, False, "settled", RichardsonLucy(), False),
    (1.051, 0.5, False, "settled", RichardsonLucy(), True),
])  # fmt: skip
def test_a_restoration_is_rejected_where_eight_hundredths_of_the_misfit_and_the_slack_are_left(
    after, before, overdone, stopped, method, rejected, monkeypatch
):
    monkeypatch.setattr(restoration, "_is_overdone", lambda *_: overdone)
    monkeypatch.setattr(restoration, "_best_share", lambda *_: 0.25)
    observed = SimpleNamespace(image=1, slack=0.05, mean=float, before=before)
    observed.discrepancies_of = {2: after}.get
    result = SimpleNamespace(light=2, stopped=stopped, steps=9, least_discrepancy=None)
    expected = (1.0, MISFIT) if rejected else (0.25 if before <= 1.0 else 0.0, stopped)
    assert restoration.check_result(observed, result, method) == expected


@pytest.mark.parametrize(("value", "limit", "fits"), [(0.5, 0.5, False), (0.5, 0.51, True), (1.5, math.inf, True)])
def test_a_photograph_has_light_below_saturation(value, limit, fits, recwarn):
    photo = np.full((4, 4), 20.0)
    photo[1, 2] = value
    with nullcontext() if fits else pytest.raises(ValueError, match="neither masked, NaN nor saturated"):
        restoration.recorded(photo, "linear", limit)
    assert bool(recwarn.list) == math.isfinite(limit)


def test_the_design_error_is_the_largest_bias_in_standard_errors_of_a_window():
    """Between the candidates of the range, of either channel and level."""
    bias, errors = np.array([[9.0, -0.3, 0.2, 0.1, 9.0], [0.0, 0.1, 0.2, -0.5, 0.0]]), np.array([[1, 2, 1, 1, 1]] * 2)
    channels = [SimpleNamespace(bias=b, errors=e, rank=1, binning=2) for b, e in zip(bias, errors, strict=True)]
    engine = SimpleNamespace(_low=1.2, _high=2.7, channels=channels, _pixels=49.0, binning=2)
    assert FocalEngine.design_error.fget(engine) == pytest.approx(0.5 * 7.0 / 2.0)
    levels = [SimpleNamespace(engine=SimpleNamespace(design_error=size)) for size in (0.2, 0.7, 0.4)]
    assert LiveDepth.design_error.fget(SimpleNamespace(_levels=levels)) == 0.7


def test_results_tell_in_plain_data_what_they_are_and_the_median_and_ends_of_their_depth():
    image = np.ones((2, 2))
    told = Restoration(image, image, 1.25, (1.25,), 3.0, 7, "settled").to_dict()
    assert told | {"discrepancy": 1.25, "by_channel": [1.25], "before": 3.0, "steps": 7, "reliable": True} == told
    assert not {"values", "light"} & set(told)
    depth, errors = np.linspace(1.0, 3.0, 201), np.linspace(0.1, 0.3, 201)
    depth, errors = np.append(depth, [np.nan] * 9)[None], np.append(errors, [np.inf] * 9)[None]
    made = SimpleNamespace(
        verdict=SimpleNamespace(to_dict=dict), errors=errors, depth=depth, candidates=np.ones(5), exposures=(1.0,),
        known=0.9, _sources="noise",
    )  # fmt: skip
    facts = DefocusDepth.to_dict(made)
    assert facts["depth"] == pytest.approx({"5 %": 1.1, "50 %": 2.0, "95 %": 2.9})
    assert (facts["error"], facts["error_of"]) == (pytest.approx(0.2), "noise")
    made.errors = np.full_like(errors, np.inf)
    assert (DefocusDepth.to_dict(made)["depth"], DefocusDepth.to_dict(made)["error"]) == (None, None)


def test_dark_planes_have_no_slope_and_dim_ones_may():
    ramp = (0.5 + np.linspace(-0.2, 0.2, 9))[:, None, None] * np.ones((1, 4, 4))
    assert light_checks.plane_light_findings(0.0 * ramp, Noise(read=1.0), 0.0) == []
    (found,) = light_checks.plane_light_findings(ramp, Noise(read=1.0), 0.0)
    assert found.numbers["change"] == pytest.approx(0.8)


def test_defaults_are_those_that_their_pages_state():
    kinds = (microscopy.confocal, microscopy.two_photon, microscopy.light_sheet, microscopy.bead, microscopy.sted)
    assert {inspect.signature(one).parameters["tol"].default for one in kinds} == {1e-6}
    assert (TableOptions().tol, FieldPhotographOptions().tol) == (1e-4, 1e-3)
    assert (DefocusOptions().f_number_error, DefocusOptions().focus_error) == (None, None)


def test_depletion_is_relative_to_the_crest_of_the_doughnut_and_a_sheet_needs_a_bound(monkeypatch):
    asked, given = [], SimpleNamespace(values=np.ones((1, 3, 3)), error_bound=None, method=1, scale=1.0)
    planes = {"depth": 5e-7, "wavelength": 520e-9}
    emission, beam, vortex = (OIL.pupil(**planes, **more) for more in ({}, {"emitter": lm.Beam()}, VORTEX))
    monkeypatch.setattr(modalities, "crest", lambda pupil: 0.25)
    monkeypatch.setattr(modalities, "psf", lambda *_, **how: asked.append(how.get("method", how.get("tol"))) or given)
    modalities.sted(beam, vortex, emission, 3, 6.5e-6, saturation=20.0)
    assert asked[-1].saturation == 80.0
    with pytest.raises(ToleranceError, match="has no bound"):
        modalities.light_sheet(emission, 1e-6, 3, 6.5e-6, tol=0.099)
    assert asked[-1] == pytest.approx(0.099 - 1.1 * (6.0 * 2.0**-53 + 2.0**-24), rel=1e-12)
    with pytest.raises(ValueError, match="tol"):
        modalities.light_sheet(emission, 1e-6, 3, 6.5e-6, tol=0.101)
