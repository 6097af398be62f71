"""Parameters from stacks: held-out photons, refinement, hot voxels, residuals."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.special import j1

import lommel as lm
from lommel.deconvolve.iterations import State
from lommel.microscopy import held_out
from lommel.microscopy.depth_model import DepthModel
from lommel.microscopy.held_out import Best, HeldOut
from lommel.microscopy.psf_scores import Score
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
    for module in ("held_out", "refinement"):
        monkeypatch.setattr(f"lommel.microscopy.{module}.NARROWEST", 15)


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
    comparison = HeldOut(StackContext(stack, RIGHT.changed(name, wrong), CAMERA, math.inf, 1), lambda *_: None)
    found = comparison.alternatives(lambda *_: None, try_reversed=False)
    assert any(each.startswith(said) for each in found)


def test_reversed_planes_that_explain_the_misfit_are_named_alone(stack, monkeypatch):
    monkeypatch.setattr(HeldOut, "score", lambda *_: pytest.fail("another PSF was tried"))
    comparison = HeldOut(StackContext(stack[::-1], RIGHT, CAMERA, math.inf, 1), lambda *_: None)
    assert comparison.alternatives(lambda *_: None, try_reversed=True) == ["planes in reverse order"]


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


@pytest.mark.parametrize(
    ("start", "change", "named"),
    [
        (1.33, 0.06, ["a larger index of the sample (about 1.39)"]),
        (1.33, -0.07, []),  # of no liquid
        (1.47, -0.18, []),  # far beyond a linear estimate
        (1.52, 0.1, []),
        (1.0, -0.02, []),
    ],
)
def test_only_indices_of_media_near_the_stated_one_are_named(monkeypatch, start, change, named):
    information = 1e6 / change**2
    monkeypatch.setattr(
        HeldOut, "score", lambda _, name: Score(information * change, information) if name == "sample" else None
    )
    comparison = held(flat(planes=3), Model(start))
    comparison._tests = SimpleNamespace(chi2=1.0)
    assert comparison.alternatives(lambda *_: None, try_reversed=False) == named


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

    def deconvolve_half(_, blur, told, *, background=None, start=None, steps=None):
        if start is None:
            return Best(99.0, 50, 14.7, State(np.full(1, 7.0, np.float32)), [])
        asked.append((background.level, float(start.light[0]), steps))
        loss = 0.5 * ((background.level - 15.0) / 0.05) ** 2
        return Best(loss, 0, background.level, State(), [])

    monkeypatch.setattr(held_out.Halves, "deconvolve_half", deconvolve_half)
    monkeypatch.setattr(HeldOut, "blur", lambda *_: None)
    level = held(flat()).level()
    assert level == pytest.approx(2.0 * 15.1, abs=0.06)
    assert len(asked) < 7
    for place, light, steps in asked:  # what the background gains the specimen loses
        assert place + light == pytest.approx(21.7)
        assert steps == held_out._SETTLE


def finding(monkeypatch, truth, stated, error):
    """Return the finding where lnL falls from the true index on as a parabola; `error` is that of the index."""
    score = Score((truth - stated) / error**2, error**-2)
    monkeypatch.setattr(HeldOut, "score", lambda *_: score)
    return held(flat(), Model(stated)).finding()


def test_another_index_is_told_where_held_out_photons_are_sure(monkeypatch):
    found = finding(monkeypatch, 1.33, 1.345, 0.001)
    assert (found.code, found.severity) == ("psf_doubtful", "doubt")
    assert found.numbers["preferred"] == pytest.approx(1.33)
    assert found.numbers["preferred_error"] == pytest.approx(0.002)
    # lnL at 0.010 off less that at 0.015 off
    assert found.numbers["lnL"] == pytest.approx(0.5 * (15.0**2 - 10.0**2))
    assert found.numbers["lnL_error"] == pytest.approx(5.0)
    assert "an index of the sample of 1.34 than of 1.345 (lnL by 62 +- 5)" in found.text
    assert "best with one near 1.33: " in found.text
    assert "another depth, spherical aberration, pixel or NA" in found.text


def test_the_right_index_is_compared_and_stays(monkeypatch):
    found = finding(monkeypatch, 1.33, 1.33, 0.002)
    assert (found.code, found.severity) == ("psf_compared", "note")
    assert "lnL changes by -3 +- 2 with 1.325 and -3 +- 2 with 1.335" in found.text
    assert "which excludes" not in found.text
    assert finding(monkeypatch, 1.33, 1.33, 0.0005).text.endswith("which excludes 1.325 and 1.335")


@pytest.mark.parametrize(
    ("truth", "error", "code"),
    [
        (1.3350, 0.00080, "psf_doubtful"),  # 3.1 errors more than half of the change
        (1.3350, 0.00085, "psf_compared"),  # 2.9
        (1.3360, 0.00100, "psf_doubtful"),
        (1.3320, 0.00001, "psf_compared"),  # within half of the change
    ],
)
def test_a_doubt_needs_three_errors(monkeypatch, truth, error, code):
    assert finding(monkeypatch, truth, 1.33, error).code == code


def test_an_index_that_is_not_possible_is_not_tried(monkeypatch):
    found = finding(monkeypatch, 1.33, 1.321, 0.001)
    assert found.code == "psf_doubtful"
    assert "1.316" not in finding(monkeypatch, 1.321, 1.321, 0.001).text


def test_of_a_flat_stack_nothing_is_compared():
    given = {"pixel": 6.5e-6, "step": 0.3e-6, "wavelength": 520e-9, "direction": "up", "noise": NOISE}
    found = deconvolved(flat(planes=6)[:, :16, :16], OIL_60X, window=(5, 9), **given)
    assert found.findings.codes == ("untested",)


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
