"""What images that differ in focus tell of their lenses, in scenes that are rendered without this package."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

import lommel as lm
from lommel.imaging import defocus_verdict
from lommel.imaging.defocus_verdict import DefocusVerdict
from lommel.imaging.pair_noise import EstimatedNoise
from scenes import POINTS, ThinLens, before, lommel_lens, plane, record, texture

FOCI, PIXEL, LIGHT = (1.35, 1.8), 4e-6, 5000.0
NOISE = lm.Noise(read=3.0, offset=100.0)


def taken(spherical=0.0):
    """A plane at 1.4 m beside one at 1.7 m, by a lens of f/2.8."""
    made = [ThinLens(35e-3, 2.8, focus, 540e-9, PIXEL, spherical) for focus in FOCI]
    halves = [record(plane(texture("leaves", 128, 3), made, at, LIGHT), seed=int(10 * at)) for at in (1.4, 1.7)]
    return [np.concatenate(both, axis=1) for both in zip(*halves, strict=True)]


@pytest.fixture(scope="module")
def pair():
    return taken()


def lenses(f_number=2.8, foci=FOCI, spherical=0.0):
    return [lommel_lens(ThinLens(35e-3, f_number, focus, 540e-9, PIXEL, spherical)) for focus in foci]


def live(pair, stated, **more):
    made = lm.imaging.LiveDepth(
        stated, PIXEL, between=(1.2, 2.0), noise=NOISE, shape=pair[0].shape, light=LIGHT, **more
    )
    made(*pair)
    return made


def test_lenses_as_they_are_agree_with_frames(pair):
    found = live(pair, lenses()).verdict()
    assert found.agrees
    assert found.findings.codes == ("stated", "untested")
    assert found.misfit == pytest.approx(1.0, abs=0.1)
    assert abs(found.scale - 1.0) < 2.0 * found.scale_error < 0.1
    assert found.status == "converged"
    assert "blurs differ as the lenses state" in found.message
    assert found.to_dict()["findings"][1]["numbers"]["what"][0].startswith("which image is focused nearer")


@pytest.mark.parametrize(("f_number", "scale"), [(2.24, 0.8), (3.08, 1.1), (3.36, 1.2)])
def test_a_wrong_f_number_is_told_with_its_size(pair, f_number, scale):
    found = live(pair, lenses(f_number)).verdict()
    assert not found.agrees
    assert abs(found.scale - scale) < 2.5 * found.scale_error
    assert not found.converged
    assert found.findings.get("lens_scale").numbers == {"scale": found.scale, "error": found.scale_error}


def test_a_noise_that_is_estimated_four_times_too_large_does_not_change_the_size_of_blur(pair, monkeypatch):
    search, seen = defocus_verdict._scale_minima, []

    def both(engine, brightest, rough, tiles, level):
        overstated = [tile._replace(variance=4.0 * tile.variance) for tile in (rough, *tiles)]
        for one, many, of in ((rough, tiles, level), (overstated[0], overstated[1:], 0.25 * level)):
            seen.append(search(engine, brightest, one, many, of)[0])
        return seen[:1]

    monkeypatch.setattr(defocus_verdict, "_scale_minima", both)
    assert live(pair, lenses()).verdict().agrees
    assert seen[1].scale == pytest.approx(seen[0].scale, rel=1e-6)
    assert seen[1].error == pytest.approx(seen[0].error, rel=1e-6)


def test_misfits_below_0_as_of_one_period_tell_no_size_of_blur(pair, monkeypatch):
    minimum = defocus_verdict._Minimum(1.75, 0.05, -2.0, 56, 0.0)
    monkeypatch.setattr(defocus_verdict, "_refine_minimum", lambda misfits, k: minimum)
    found = live(pair, lenses()).verdict()
    assert "lens_scale" not in found.findings.codes
    assert np.isnan(found.scale)


def test_aliases_of_binned_pixels_do_not_change_the_size_of_blur():
    foci = (1.3325, 1.845)
    made = [ThinLens(35e-3, 5.88, focus, 540e-9, PIXEL) for focus in foci]
    images = record(plane(texture("text", 192, 3), made, 1.76, LIGHT), seed=3)
    stated = lm.imaging.LiveDepth(
        lenses(5.88, foci), PIXEL, between=(1.1, 2.2), noise=NOISE, shape=images[0].shape, light=LIGHT
    )
    assert stated.binning == (2,)
    stated(*images)
    found = stated.verdict()
    assert abs(found.scale - 1.0) < 0.02  # 0.94 +- 0.06 of binned pixels
    assert found.scale_error < 0.03


def test_lenses_whose_spherical_aberration_is_stated_tell_exchanged_foci():
    images = taken(spherical=0.5)
    found = live(images, lenses(spherical=0.5)).verdict()
    assert found.agrees
    assert abs(found.scale - 1.0) < 2.0 * found.scale_error < 0.1  # apertures that are larger, too, were looked at
    exchanged = live(images, lenses(foci=FOCI[::-1], spherical=0.5)).verdict()
    assert exchanged.misfit > 1.3 > 1.1 > found.misfit
    assert not exchanged.agrees


@pytest.mark.parametrize(("f_number", "foci", "distance"), [
    (4.0, (1.8, 2.4), 2.3),  # aliases of binned pixels: 1.6 by the filters of the depth map
    (4.0, (1.35, 1.8), 1.6),  # energies in whole steps: 1.9
    (2.8, (1.35, 1.8), 1.4),  # wide blur, whose transfer function oscillates between the frequencies of the tables
])  # fmt: skip
def test_the_misfit_of_exact_lenses_is_one_and_that_of_a_shift_is_not(f_number, foci, distance, monkeypatch):
    monkeypatch.setattr("lommel.imaging.defocus_verdict._scale_minima", lambda *_: [])
    thin = [ThinLens(35e-3, f_number, focus, 540e-9, PIXEL) for focus in foci]
    images = record(plane(texture("pink", 128, 5), thin, distance, LIGHT), seed=3)
    made = lm.imaging.LiveDepth(
        [lommel_lens(one) for one in thin], PIXEL, between=(0.85 * foci[0], 1.2 * foci[1]), noise=NOISE,
        shape=images[0].shape, light=LIGHT,
    )  # fmt: skip
    made(*images)
    exact = made.verdict()
    assert exact.misfit == pytest.approx(1.0, abs=0.1)
    assert exact.reliable
    made(images[0], np.roll(images[1], 1, axis=1))
    shifted = made.verdict()
    assert shifted.findings.get("misfit") is not None


def test_a_size_of_blur_that_frames_do_not_tell_is_named_with_what_it_costs(pair):
    one = live([each[:, :128] for each in pair], lenses()).verdict()  # a plane, on few pixels
    assert one.reliable
    assert one.findings.codes == ("stated", "untested")
    assert one.findings.get("untested").numbers["what"][0].startswith("the size of blur")
    told = one.findings.get("stated")
    # A shift of all foci shifts depth: by 0.01 z^2.
    assert one.changes[1] == pytest.approx(-0.01 * 1.4**2, rel=0.02)
    assert (told.numbers["by_f_number"], told.numbers["by_foci"]) == one.changes
    assert "1 % of the f-number changes the median depth by " in told.text
    assert "0.01 dioptre of all focus distances by 20 mm" in told.text


def test_edges_of_depth_are_left_out_of_the_misfit():
    made = [ThinLens(35e-3, 2.8, focus, 540e-9, PIXEL) for focus in FOCI]
    mask = np.zeros((160 * POINTS, 160 * POINTS))
    mask[:, : 64 * POINTS] = 1.0
    images = record(
        before(texture("leaves", 160, 3), mask, 1.4, texture("leaves", 160, 4), 1.7, made, 4.0 * LIGHT), seed=5
    )
    found = lm.imaging.depth_from_defocus(
        [one.astype(np.float64) for one in images], lenses(), PIXEL, encoding="linear",
        noise=lm.Noise(white=1.0, read=3.0, offset=100.0), between=(1.2, 2.0),
    )  # fmt: skip
    verdict = found.verdict
    assert np.nanmean(found.misfit[np.isfinite(found.errors)]) > 1.5
    assert verdict.misfit == pytest.approx(1.0, abs=0.15)
    assert 0.3 < verdict.judged < 0.9
    assert f"at the {100.0 * verdict.judged:.0f} % of pixels away from edges and slopes of depth" in verdict.message


def test_denoised_frames_frames_of_something_else_and_flat_ones_do_not_agree(pair):
    made = live([gaussian_filter(one.astype(np.float32), 1.0) for one in pair], lenses())
    assert made.verdict().status == "too_quiet"
    made(pair[0], np.roll(pair[1], 2, axis=0))
    assert made.verdict().status == "misfit"
    made(*(np.full_like(one, 5000) for one in pair))
    nothing = made.verdict()
    assert not nothing.agrees
    assert math.isnan(nothing.scale)
    assert nothing.status == "no_depth"
    assert nothing.findings.get("untested").numbers["what"][0] == "the size of blur"


@pytest.mark.parametrize(("excess", "severity"), [(4.0, None), (6.0, "doubt"), (12.0, "error")])
def test_estimated_noise_far_above_that_of_the_finest_details_is_told(excess, severity):
    verdict = DefocusVerdict.of(1.0, noise=EstimatedNoise(lm.Noise(white=900.0, read=3.0)), excess=excess)
    finding = verdict.findings.get("misfit")
    assert (finding and finding.severity) == severity
    if finding:
        assert (
            f"{excess:g} times the noise of their finest details: frames are shifted or magnified" in verdict.message
        )
        assert finding.numbers == {"excess": excess}


@pytest.mark.parametrize(("shift", "least", "most"), [((0, 0), 0.5, 3.0), ((2, 1), 10.0, 1e3)])
def test_a_shift_shows_in_the_noise_that_is_estimated(shift, least, most, monkeypatch):
    made = [ThinLens(35e-3, 8.0, focus, 540e-9, PIXEL) for focus in FOCI]
    near, far = record(plane(texture("leaves", 96, 3), made, 1.5, LIGHT), seed=3)
    found = lm.imaging.LiveDepth(
        [lommel_lens(one) for one in made], PIXEL, between=(1.2, 2.0), shape=near.shape, light=LIGHT
    )
    found(near, np.roll(far, shift, axis=(0, 1)))
    given = {}
    monkeypatch.setattr("lommel.imaging.live.judge_frames", lambda *_, **more: given.update(more))
    found.verdict()
    assert least < given["excess"] < most


@pytest.mark.parametrize(("spherical", "shift"), [(0.5, 0), (0.5, 1), (0.0, 0)])
def test_exchanged_foci_are_named_where_spherical_aberration_tells_them(spherical, shift, monkeypatch):
    monkeypatch.setattr("lommel.imaging.defocus_verdict._scale_minima", lambda *_: [])
    made = [ThinLens(35e-3, 4.0, focus, 540e-9, PIXEL, spherical) for focus in FOCI]
    near, far = record(plane(texture("leaves", 96, 3), made, 1.4, LIGHT), seed=14)
    found = live([near, np.roll(far, shift, axis=0)], lenses(4.0, FOCI[::-1], spherical)).verdict()
    named = found.findings.get("exchanged")
    assert (named is not None) == (spherical > 0.0 and not shift)  # frames that moved agree in no order
    assert found.agrees == (spherical == 0.0)
    if named:
        assert "in the other order the images agree" in found.message


@pytest.mark.parametrize(
    ("changed", "distance", "doubtful"),
    [(False, 1.4, True), (False, 1.6, True), (True, 1.6, False), (True, 1.45, False)],
)
def test_two_frames_of_one_focus_are_in_doubt(changed, distance, doubtful, monkeypatch):
    monkeypatch.setattr("lommel.imaging.defocus_verdict._scale_minima", lambda *_: [])
    made = [ThinLens(35e-3, 5.6, focus, 540e-9, PIXEL) for focus in (FOCI if changed else FOCI[:1] * 2)]
    found = live(record(plane(texture("leaves", 96, 3), made, distance, LIGHT), seed=5), lenses(5.6)).verdict()
    assert found.agrees != doubtful
    assert (found.findings.get("one_focus") is not None) == doubtful
    if doubtful:
        assert found.findings.get("misfit") is None  # noise tells nothing
        assert "as with two frames of one focus: check that the focus changed" in found.message


def test_depth_of_a_few_blocks_is_none():
    flat = [np.random.default_rng(seed).poisson(LIGHT, (128, 128)).astype(np.uint16) + 100 for seed in (1, 2)]
    made = live(flat, lenses(8.0))
    made._errors[:] = np.inf
    made._depth[:] = 1.5
    made._errors.flat[:15] = 0.01
    assert made.verdict().status == "no_depth"
