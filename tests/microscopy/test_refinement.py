"""Parameters from stacks: held-out photons, refinement, hot voxels, residuals."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.special import j1

import lommel as lm
from lommel.deconvolve.iterations import State
from lommel.microscopy import held_out, refinement
from lommel.microscopy.depth_model import DepthModel
from lommel.microscopy.held_out import Best, HeldOut
from lommel.microscopy.refinement import StackContext
from lommel.recorded.camera_noise import StackView, hot_pixels, hot_voxels, sharpness
from objectives import OIL_60X
from restored_stacks import deconvolved

CAMERA = lm.Noise(white=0.5, read=1.5, offset=100.0)
RIGHT = DepthModel(OIL_60X, 520e-9, 6e-6, 0.3e-6, 8e-6, 8, (15, 15))
BEAD = 7, 8, 9  # between two planes, in planes of half a step


@pytest.fixture(autouse=True)
def one_psf(monkeypatch):
    """Take the PSF of the middle everywhere, in a small part."""
    psfs = DepthModel.psfs
    monkeypatch.setattr(DepthModel, "psfs", lambda model, margin, slabs=1: psfs(model, margin, slabs))
    for name, value in {"NARROWEST": 15, "_FIRST_SIDE": 18}.items():
        monkeypatch.setattr(refinement, name, value)


@pytest.fixture
def stack():
    """Return beads on planes and between them, of the right PSFs."""
    fine = DepthModel(OIL_60X, 520e-9, 6e-6, 0.15e-6, 8e-6, 16, (29, 15))
    truth = np.zeros((16, 18, 18), np.float32)
    truth[BEAD] = 4e6
    blur, image = fine.blur(truth.shape, (0, 0), threads=1), np.zeros(truth.shape)
    blur.outside[...] = 0.0
    blur.forward(truth, lambda p, r, c, v: image.__setitem__((p, r, c), v))
    return CAMERA.record(np.maximum(image[::2], 0.0) + 10.0, seed=3)


@pytest.mark.parametrize(
    ("name", "wrong", "said"),
    [
        ("sample", OIL_60X.sample + 0.02, "a smaller index of the sample"),
        ("NA", 0.94, "a larger NA"),
        ("depth", 9.5e-6, "a smaller depth"),
        ("step", 1.08, "a smaller step of z"),
        ("wavelength", 0.93, "a larger wavelength"),
    ],
)
def test_what_is_wrong_is_among_the_psfs_that_are_named(stack, name, wrong, said):
    context = refinement.StackContext(stack, RIGHT.changed(name, wrong), CAMERA, math.inf, 1)
    found = refinement.rank_alternatives(context, lambda *_: None, try_reversed=False)
    assert any(each.startswith(said) for each in found)


def test_a_line_is_followed_downhill_to_its_minimum_with_few_costs():
    asked = []

    def cost(value):
        asked.append(value)
        return 3.0 + (value - 0.61) ** 2 if value < 1.0 else math.inf

    place, found = refinement._line_search(cost, 0.0, 0.06, 3.0 + 0.61**2)
    assert place == pytest.approx(0.61)
    assert found == pytest.approx(3.0)
    assert len(asked) == 5
    assert refinement._line_search(cost, 0.0, -0.2, 3.0 + 0.61**2)[0] == 0.8  # 1.6 is out of range
    assert refinement._line_search(cost, 0.61, 0.1, 3.0) == (0.61, 3.0)


NOISE = lm.Noise(white=0.5, read=1.6, offset=100.0)


class Model:
    """A model whose only parameter is the index of the sample, from 1.32 on."""

    def __init__(self, sample):
        self.objective = SimpleNamespace(sample=sample)

    def changed(self, _, value):
        if value < 1.32:
            raise ValueError
        return Model(value)


def held(stack, model=None, limit=np.inf):
    return HeldOut(StackContext(stack, model or Model(1.33), NOISE, limit, 1), lambda *_: None)


def flat(light=40.0, planes=20):
    draw = np.random.default_rng(5)
    electrons = draw.poisson(light, (planes, 32, 32)) + draw.normal(0.0, 1.6, (planes, 32, 32))
    return np.rint(100.0 + electrons / 0.5).astype(np.uint16)


def test_halves_add_up_to_the_counts_and_are_independent():
    stack = flat()
    stack[3, 4, 5] = 4000
    one, other = held(stack, limit=4000)._halves.parts
    assert np.isnan(one[3, 4, 5])
    known = np.isfinite(one)
    assert known.sum() == stack.size - 1
    np.testing.assert_allclose((one + other)[known], stack[known] - 100.0, rtol=1e-5)
    assert abs(np.corrcoef(one[known], other[known])[0, 1]) < 0.03
    assert np.mean(one[known]) == pytest.approx(40.0, rel=0.01)  # 20 electrons


def test_the_background_is_the_highest_that_held_out_photons_allow(monkeypatch):
    asked = []

    def deconvolve_half(_, blur, told, *, background, start, steps):
        asked.append((background.level, float(start.light[0]), steps))
        loss = 0.5 * ((background.level - 15.0) / 0.05) ** 2
        return Best(loss, 0, np.zeros(1), np.zeros(1), background.level, State(), [])

    monkeypatch.setattr(held_out.Halves, "deconvolve_half", deconvolve_half)
    monkeypatch.setattr(HeldOut, "blur", lambda *_: None)
    free = Best(99.0, 50, np.zeros(1), np.zeros(1), 14.7, State(np.full(1, 7.0, np.float32)), [])
    level = held(flat()).level(free)
    assert level == pytest.approx(2.0 * 15.1, abs=0.06)
    assert len(asked) < 7
    for place, light, steps in asked:  # what the background gains the specimen loses
        assert place + light == pytest.approx(21.7)
        assert steps == held_out._SETTLE


def trial(monkeypatch, truth, stated, bend=2e5, noise=0.0):
    """Return a finding where lnL falls from the true index on as a parabola; `noise` is what a second half adds."""
    calls = []

    def best(_, words, model, fold=0, course=None):
        off = model.objective.sample - truth
        calls.append((round(model.objective.sample, 4), fold))
        electrons = np.full(1000, 30.0) * np.where(np.arange(1000) % 2, np.exp(3.0 * off), np.exp(-3.0 * off))
        losses = np.full(1000, (0.5 * bend * off**2 + (noise * off if fold else 0.0)) / 1000)
        return Best(float(losses.sum()), 40, losses, electrons, 15.0, State(), [])

    monkeypatch.setattr(HeldOut, "best", best)
    given = held(flat(), Model(stated))
    return given.finding(given.best("own", Model(stated))), calls


def test_another_index_is_told_where_held_out_photons_are_sure(monkeypatch):
    found, calls = trial(monkeypatch, 1.33, 1.345)
    assert (found.code, found.severity) == ("psf_doubtful", "doubt")
    assert found.numbers["preferred"] == pytest.approx(1.33, abs=1e-6)
    assert found.numbers["preferred_error"] == pytest.approx(2.0 / np.sqrt(2e5), rel=1e-3)
    assert found.numbers["lnL"] > held_out._SIGNIFICANT * found.numbers["lnL_error"]
    assert (1.33, 0) in calls  # it went on until lnL fell
    assert "best with one near 1.33: " in found.text  # a direction, not a measurement with an error
    assert "another depth, spherical aberration, pixel or NA" in found.text


def test_the_right_index_is_compared_and_stays(monkeypatch):
    found, calls = trial(monkeypatch, 1.33, 1.33)
    assert (found.code, found.severity) == ("psf_compared", "note")
    assert {at for at, _ in calls} == {1.325, 1.33, 1.335}
    assert "lnL changes by -5 +- 4 with 1.325 and -2 +- 3 with 1.335" in found.text
    assert "which excludes" not in found.text
    found, _ = trial(monkeypatch, 1.33, 1.33, bend=1.6e6)
    assert found.text.endswith("which excludes 1.325 and 1.335")


def test_a_difference_of_lnl_that_is_no_evidence_is_no_doubt(monkeypatch):
    found, _ = trial(monkeypatch, 1.332, 1.33, bend=3e5)  # lnL rises by 1
    assert found.code == "psf_compared", found.numbers


def test_of_a_flat_stack_nothing_is_compared():
    given = {"pixel": 6.5e-6, "step": 0.3e-6, "wavelength": 520e-9, "direction": "up", "noise": NOISE}
    found = deconvolved(flat(planes=6)[:, :16, :16], OIL_60X, window=(5, 9), **given)
    assert found.findings.codes == ("untested",)


def test_where_one_half_is_not_sure_the_other_one_decides_too(monkeypatch):
    for noise, code in ((0.0, "psf_doubtful"), (-1040.0, "psf_compared")):  # it is two standard errors in one half
        found, calls = trial(monkeypatch, 1.33, 1.335, bend=5e5, noise=noise)
        assert {(1.335, 1), (1.33, 1)} <= set(calls), found.numbers
        assert found.code == code, found.numbers


def test_an_index_that_is_not_possible_is_not_tried(monkeypatch):
    found, calls = trial(monkeypatch, 1.33, 1.321)
    assert 1.316 not in {at for at, _ in calls}
    assert found.code == "psf_doubtful"


def airy(v):
    v = np.maximum(v, 1e-9)
    return (2.0 * j1(v) / v) ** 2


def beads(step, peak):
    """Return counts of beads anywhere within a voxel, in planes of 32 x 32; step is that of v in Airy's pattern."""
    draw = np.random.default_rng(3)
    y, x = np.indices((32, 32))
    light = [
        peak * airy(step * np.hypot(y - 16 - draw.uniform(-0.5, 0.5), x - 16 - draw.uniform(-0.5, 0.5)))
        for _ in range(40)
    ]
    electrons = draw.poisson(20.0 + np.array(light)) + draw.normal(0.0, 1.6, (40, 32, 32))
    return np.clip(np.round(100.0 + electrons / 0.5), 0, 65535).astype(np.uint16)


@pytest.mark.parametrize("step", [0.6, 1.2, 2.5])
@pytest.mark.parametrize("peak", [30.0, 3e3, 2e4])
def test_points_of_light_are_not_hot_and_hot_pixels_are_found(step, peak):
    stack = beads(step, peak)
    y, x = np.indices((9, 9)) - 4
    sharpest = sharpness(airy(step * np.hypot(y, x))[None])
    assert sharpest == pytest.approx(1.0 / float(airy(step)))
    assert len(hot_voxels(stack, NOISE, sharpest)) == 0
    stack[7, 3, 5], stack[20, 0, 31] = 3000, 65535
    assert hot_voxels(stack, NOISE, sharpest).tolist() == [[7, 3, 5], [20, 0, 31]]


def in_depth(step, planes, column=False):
    """Return light of a bead that is in focus in the middle plane, or of a line along z, and 20 electrons."""
    y, x = np.indices((32, 32)) - 16
    wide = 1.0 + (0.0 if column else 1.0) * np.abs(np.arange(planes) - planes // 2)[:, None, None] / 3.0
    return 20.0 + 3e3 * airy(step * np.hypot(y, x) / wide) / wide**2


@pytest.mark.parametrize("excess", [25.0, 400.0, 2e4])
def test_hot_pixels_are_those_above_their_neighbours_in_most_planes(excess):
    planes, step = 24, 1.2
    y, x = np.indices((9, 9)) - 4
    sharpest = sharpness(airy(step * np.hypot(y, x))[None])
    places = [(3, 5), (3, 6), (0, 31), (20, 9), (28, 28)]  # two beside each other, one in a corner
    for light in (in_depth(step, planes), in_depth(step, planes, column=True)):
        clean = NOISE.record(light, seed=1)
        assert not hot_pixels(clean, NOISE, sharpest).any()
        for place in places:
            light[:, *place] += excess
        spoilt = NOISE.record(light, seed=1)
        found = hot_pixels(spoilt, NOISE, sharpest)
        assert [tuple(each) for each in np.argwhere(found)] == sorted(places)
        spoilt[:, 16, 17] = np.nan
        assert not hot_pixels(spoilt, NOISE, sharpest)[16, 17]
    assert not hot_pixels(spoilt[:4], NOISE, sharpest).any()  # too few planes tell nothing


@pytest.mark.parametrize("step", [0.35, 0.5, 0.7, 1.6, 2.5])  # in v, in which the FWHM is 3.2
def test_the_peak_of_a_bright_bead_is_no_hot_pixel(step):
    y, x = np.indices((9, 9)) - 4
    sharpest = sharpness(airy(step * np.hypot(y, x))[None])
    for planes in (5, 9, 24):
        bead = NOISE.record(30.0 * in_depth(step, planes), seed=2)
        assert not hot_pixels(bead, NOISE, sharpest)[12:21, 12:21].any()


def test_what_is_left_out_is_unknown():
    voxels = np.array([[1, 2, 3]])
    whole = StackView(np.full((2, 4, 5), 7, np.uint16), 4000.0, voxels=voxels)
    assert whole.limit == 4000.0
    assert whole[1, 1:3, 2:].tolist() == [[7, 7, 7], [7, 4000, 7]]
    assert (whole[0] == 7).all()
    assert StackView(whole, 4000.0, is_reversed=True)[0, 1:3, 2:].tolist() == [[7, 7, 7], [7, 4000, 7]]
    assert StackView(np.zeros((2, 4, 5), np.uint16), np.inf, voxels=voxels).limit == 65535
    assert np.isnan(StackView(np.zeros((2, 4, 5), np.float32), np.inf, voxels=voxels)[1][2, 3])
    mask = np.zeros((4, 5), bool)
    mask[2, 3] = True
    for given in (mask, np.stack([mask, mask])):
        assert np.argwhere(StackView(whole, 4000.0, mask=given)[0, 1:, 2:] == 4000).tolist() == [[1, 1]]


GIVEN = {"pixel": 6e-6, "step": 0.3e-6, "wavelength": 520e-9, "depth": 8e-6, "noise": CAMERA, "window": (9, 15)}


@pytest.fixture(scope="module")
def stack_of_projections():
    light = np.full((10, 28, 36), 20.0)
    light[3, 7:10, 9:12] = light[7, 19:22, 29:32] = 900.0
    return CAMERA.record(light, seed=1)


def restored(stack_of_projections, **more):
    way = lm.imaging.RichardsonLucy(steps=3, target=0.0)
    return deconvolved(
        stack_of_projections, OIL_60X, method=way, **(GIVEN | {"direction": "up", "diagnosis": False} | more)
    )


@pytest.mark.parametrize("more", [{}, {"direction": "down"}, {"tile": 18}], ids=str)
def test_projections_are_the_maxima_of_recording_and_result(stack_of_projections, more):
    found = restored(stack_of_projections, **more)
    recorded, after, _ = found.channels[0].projections
    light = np.maximum(stack_of_projections - 100.0, 0.0)
    for axis, before, later in zip((0, 1), recorded, after, strict=True):
        np.testing.assert_allclose(before, light.max(axis=axis), atol=0.01)
        np.testing.assert_array_equal(later, np.asarray(found).max(axis=axis))


def test_residuals_have_unit_variance_where_the_model_is_right_and_unknown_voxels_have_none():
    flat = CAMERA.record(np.full((12, 48, 48), 50.0), seed=2)
    flat[:, 5, :7] = np.nan
    found = restored(flat)
    for residual in found.channels[0].projections.residual:
        assert np.nanstd(residual) == pytest.approx(1.0, abs=0.12)
    assert np.isnan(found.channels[0].projections.residual[0][5, :7]).all()
    assert np.isfinite(found.channels[0].projections.residual[0][6]).all()
    np.testing.assert_array_equal(*(np.isnan(found.channels[0].projections[k][0]) for k in (0, 2)))


def test_a_wrong_psf_leaves_a_pattern_in_the_residual(stack_of_projections):
    (xy, xz) = (
        restored(stack_of_projections).channels[0].projections.residual
    )  # light in one plane is no image of a point
    assert np.abs(xy[6:11, 8:13]).max() > 10.0
    assert np.abs(xz[3, 8:13]).max() > 10.0
