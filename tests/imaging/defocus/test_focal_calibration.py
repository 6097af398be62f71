"""Calibration of f-number and foci by planes at known distances, rendered without the PSFs of this package."""

from __future__ import annotations

import io
import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image
from scipy.ndimage import gaussian_filter

import lommel as lm
from lommel.fit.findings import Findings
from lommel.imaging.focal_calibration import _filled, _findings, _Search
from lommel.lensfiles.lens_files import load_instrument
from planes import NOISE, PIXEL, shoot, texture
from scenes import POINTS

TRUE = [lm.Lens(focal_length=35e-3, f_number=4.0, focus_distance=f, wavelength=540e-9) for f in (1.35, 1.8)]
STATED = [lm.Lens(focal_length=35e-3, f_number=4.32, focus_distance=f, wavelength=540e-9) for f in (1.3095, 1.746)]
CHANGES = [
    math.log(4.0 / 4.32),
    *(1.0 / a.focus_distance - 1.0 / b.focus_distance for a, b in zip(TRUE, STATED, strict=True)),
]
DISTANCES = [1.25, 1.5, 1.95]
OPTIONS = {"encoding": "linear", "noise": NOISE}
LENS_FILE = """# mine
[lens]
focal_length = "35 mm"
f_number = 4.32
focus_distance = "1.3 m"
wavelength = "540 nm"
[sensor]
pixel = "4 um"
"""


def plane(distance, lenses=TRUE):
    return shoot(texture(side=192, seed=int(100 * distance)), distance, lenses, seed=int(10 * distance))


@pytest.fixture(scope="module")
def pairs():
    return [plane(distance) for distance in DISTANCES]


@pytest.fixture(scope="module")
def found(pairs):
    return lm.imaging.calibrate_focus(pairs, DISTANCES, STATED, PIXEL, **OPTIONS, origin=0.0)


def depth(pair, lenses, **errors):
    more = {"between": (1.1, 2.2), **OPTIONS, **errors}
    got = lm.imaging.depth_from_defocus(pair, lenses, PIXEL, **more)
    known = np.isfinite(got.errors)
    return got.depth[known], got.errors[known]


def test_three_planes_tell_the_f_number_and_both_foci_within_their_errors(found):
    assert found.reliable
    assert found.findings.codes == ()
    estimate = [math.log(found.f_number_scale), *found.focus_shifts]
    errors = np.sqrt(np.diag(found.covariance))[:3]
    assert (errors < [0.01, 0.002, 0.002]).all()
    assert np.abs(np.subtract(estimate, CHANGES) / errors).max() < 3.0
    assert found.errors == {"f_number_error": errors[0], "focus_error": errors[1:].max()}
    assert [lens.f_number for lens in found.lenses] == pytest.approx([4.32 * found.f_number_scale] * 2)


def printed(seed, side=224):
    """Lines of words, four pixels high and six apart, on 8 x 8 points a pixel."""
    draw = np.random.default_rng(seed)
    page = np.full((side, side), 0.75)
    for row in range(0, side, 6):
        column = 0
        while column < side:
            width = int(draw.integers(1, 5))
            if draw.random() < 0.6:
                page[row : row + 4, column : column + width] = draw.uniform(0.1, 0.35)
            column += width + 1
    return np.kron(page, np.ones((POINTS, POINTS)))


def test_planes_of_printed_lines_tell_the_lens_within_their_errors():
    pairs = [shoot(printed(k), distance, TRUE, seed=k) for k, distance in enumerate(DISTANCES)]
    found = lm.imaging.calibrate_focus(pairs, DISTANCES, STATED, PIXEL, **OPTIONS, origin=0.0)
    assert found.reliable
    errors = np.sqrt(np.diag(found.covariance))[:3]
    estimate = [math.log(found.f_number_scale), *found.focus_shifts]
    assert np.abs(np.subtract(estimate, CHANGES) / errors).max() < 3.0


def test_a_border_of_unknown_pixels_changes_nothing(pairs):
    framed = [[np.pad(photo, 6, constant_values=np.nan) for photo in pair] for pair in pairs[:1]]
    a, b = (
        lm.imaging.calibrate_focus(some, DISTANCES[:1], STATED, PIXEL, **OPTIONS, origin=0.0)
        for some in (framed, pairs[:1])
    )
    np.testing.assert_allclose(a.focus_shifts, b.focus_shifts, rtol=1e-6)
    np.testing.assert_allclose(a.covariance, b.covariance, rtol=1e-6)


def test_frames_are_cropped_to_known_pixels_and_others_filled_by_the_nearest():
    images = np.arange(24.0, dtype=np.float32).reshape(1, 4, 6)
    valid = np.zeros((4, 6), dtype=bool)
    valid[1:, 2:] = True
    valid[2, 5] = False
    filled, known = _filled(images, valid)
    assert filled.tolist() == [[[8, 9, 10, 11], [14, 15, 16, filled[0, 1, 3]], [20, 21, 22, 23]]]
    assert filled[0, 1, 3] in (11, 16, 23)
    assert known.sum() == 11
    assert not known[1, 3]


def test_depth_at_another_distance_is_right_after_calibration(found):
    pair = plane(1.7)
    metres, errors = depth(pair, STATED)
    assert np.median((metres - 1.7) / errors) < -3.0
    metres, errors = depth(pair, found.lenses)
    assert abs(np.median((metres - 1.7) / errors)) < 0.6


def test_one_plane_tells_one_number_and_holds_the_f_number_with_its_error(pairs):
    found = lm.imaging.calibrate_focus(pairs[:1], DISTANCES[:1], STATED, PIXEL, encoding="linear", origin=0.0)
    assert found.f_number_scale == pytest.approx(1.0, abs=0.03)
    assert 0.02 < found.f_number_error < 0.03
    assert "f-number (+- 3 %)" in found.findings.get("stated").text
    assert found.planes[0].error == math.inf
    metres, errors = depth(pairs[0], found.lenses, **found.errors)
    assert np.median(metres) == pytest.approx(1.25, abs=0.01)
    metres, errors = depth(plane(1.7), found.lenses, **found.errors)
    assert abs(np.median((metres - 1.7) / errors)) < 3.0


@pytest.mark.parametrize("noise", [None, NOISE])
def test_one_plane_near_a_focus_does_not_put_the_focus_on_the_plane(noise):
    # There gradients by the focus vanish: at 1.4 m, f-number and foci are 5 % and 3 % off.
    true, stated = (
        [lm.Lens(focal_length=35e-3, f_number=number, focus_distance=f, wavelength=540e-9) for f in foci]
        for number, foci in ((5.88, (1.545, 2.134)), (5.6, (1.5, 2.2)))
    )
    pair = shoot(texture(side=192), 1.4, true, seed=0)
    found = lm.imaging.calibrate_focus([pair], [1.4], stated, PIXEL, encoding="linear", noise=noise, origin=0.0)
    assert found.reliable
    for lens, exact in zip(found.lenses, true, strict=True):
        assert abs(1.0 / lens.focus_distance - 1.0 / exact.focus_distance) < 2.0 * found.focus_error
        assert lens.focus_distance == pytest.approx(exact.focus_distance, rel=0.025)


def test_print_at_a_small_aperture_whose_diffraction_tells_the_f_number_is_not_refused():
    true, stated = (
        [lm.Lens(focal_length=35e-3, f_number=number, focus_distance=f, wavelength=540e-9) for f in foci]
        for number, foci in ((8.0, (1.35, 1.8)), (8.4, (1.323, 1.764)))
    )
    pair = shoot(printed(0, side=192), 1.2, true, seed=0)
    found = lm.imaging.calibrate_focus([pair], [1.2], stated, PIXEL, **OPTIONS, origin=0.0)
    assert found.reliable
    assert abs(math.log(found.f_number_scale * 8.4 / 8.0)) < 0.8 * math.log(8.4 / 8.0)
    for lens, exact in zip(found.lenses, true, strict=True):
        assert abs(1.0 / lens.focus_distance - 1.0 / exact.focus_distance) < 3.0 * found.focus_error


def test_one_plane_by_which_the_stated_foci_are_far_off_is_a_doubt_with_errors_that_contain_them(pairs):
    stated = [TRUE[0], TRUE[0].focused(1.55)]
    found = lm.imaging.calibrate_focus(pairs[:1], DISTANCES[:1], stated, PIXEL, **OPTIONS, origin=0.0)
    assert not found.reliable
    finding = found.findings.get("contradiction")
    assert finding.severity == "doubt"
    assert "standard errors contain both" in finding.text
    assert (np.abs(found.focus_shifts) < 2.0 * np.sqrt(np.diag(found.covariance))[1:3]).all()


def test_one_plane_at_a_focus_has_two_answers_and_errors_that_contain_both():
    # The sign of the defocus of the first photograph, of some four units, is not in the photographs.
    true = [lm.Lens(focal_length=35e-3, f_number=1.8, focus_distance=f, wavelength=540e-9) for f in (1.35, 1.5)]
    pair = shoot(texture(side=192), 1.375, true, seed=0)
    stated = [lens.focused(f) for lens, f in zip(true, (1.38, 1.49), strict=True)]
    found = lm.imaging.calibrate_focus([pair], [1.375], stated, PIXEL, **OPTIONS, origin=0.0)
    shift = 1.0 / 1.35 - 1.0 / 1.38
    assert abs(found.focus_shifts[0] - shift) < 3.0 * np.sqrt(found.covariance[1, 1])
    finding = found.findings.get("undetermined")
    assert finding.severity == "doubt"
    assert "two answers fit" in finding.text
    assert not found.reliable


def test_differences_of_many_times_the_stated_noise_are_a_doubt(pairs):
    quiet = lm.Noise(white=1e6, read=3.0)
    found = lm.imaging.calibrate_focus(pairs[:1], DISTANCES[:1], STATED, PIXEL, encoding="linear", noise=quiet)
    assert found.findings.get("misfit").severity == "doubt"


def test_an_origin_that_is_not_stated_is_estimated_with_an_error_below_2_cm(pairs):
    held, exact = (
        lm.imaging.calibrate_focus(pairs[:2], DISTANCES[:2], STATED, PIXEL, **OPTIONS, origin=origin)
        for origin in (None, 0.0)
    )
    errors = np.sqrt(np.diag(held.covariance))
    estimate = [math.log(held.f_number_scale), *held.focus_shifts, held.origin]
    assert np.abs(np.subtract(estimate, [*CHANGES, 0.0]) / errors).max() < 3.0
    assert (errors > 2.0 * np.sqrt(np.diag(exact.covariance))).all()
    assert 0.01 < held.origin_error < 0.02
    assert exact.origin_error == 0.0
    assert f"origin before the lens   {held.origin:.2f}" in str(held)
    assert "origin before the lens   0 m, as stated (taken as right within 1 mm)\n" in str(exact)
    assert "the origin of distances (+- 1" in held.findings.get("stated").text


def test_the_origin_that_is_stated_moves_the_planes(pairs):
    # From a sensor 6 cm behind the lens.
    here, there = (
        lm.imaging.calibrate_focus(pairs[:1], [1.25 - origin], STATED, PIXEL, **OPTIONS, origin=origin)
        for origin in (0.0, -0.06)
    )
    assert there.focus_shifts == pytest.approx(here.focus_shifts, rel=1e-6)
    assert (there.origin, there.planes[0].distance) == (-0.06, 1.31)


def test_distances_that_contradict_each_other_are_an_error(pairs):
    with pytest.raises(ValueError, match=r"distances contradict each other, and least without the plane at"):
        lm.imaging.calibrate_focus(pairs, [1.25, 1.65, 1.95], STATED, PIXEL, **OPTIONS)


def test_exchanged_photographs_are_an_error(pairs):
    found = lm.imaging.calibrate_focus([plane(1.4)[::-1]], [1.4], STATED, PIXEL, **OPTIONS)
    assert found.status == "exchanged"  # with another shift of the foci either order agrees
    found = lm.imaging.calibrate_focus([plane(1.55)[::-1]], [1.55], STATED, PIXEL, **OPTIONS)
    assert "the order of the photographs" in found.findings.get("untested").text  # about midway between the foci
    found = lm.imaging.calibrate_focus([pairs[0][::-1]], DISTANCES[:1], STATED, PIXEL, **OPTIONS)
    assert found.status == "exchanged"


def test_photographs_that_a_camera_sharpened_do_not_seem_exchanged():
    wide, quiet = replace(TRUE[0], aperture_diameter=35e-3 / 5.6), lm.Noise(white=1e6, read=3.0)
    lenses = [wide, wide.stopped(20.0)]
    pair = shoot(texture(side=192, seed=3), 1.6, lenses, noise=quiet)
    sharpened = [photo + 2.0 * (photo - gaussian_filter(photo, 2.0)) for photo in pair]
    found = lm.imaging.calibrate_focus([sharpened], [1.6], lenses, PIXEL, encoding="linear", noise=quiet, origin=0.0)
    assert found.findings.get("misfit").severity == "doubt"
    assert "exchanged" not in found.findings.codes
    with pytest.raises(ValueError, match="in the other order they agree"):
        lm.imaging.calibrate_focus([pair[::-1]], [1.6], lenses, PIXEL, encoding="linear", noise=quiet, origin=0.0)


def test_a_tilted_plane_is_a_doubt():
    # Strips of planes: 1.46 m on the left, 1.54 m on the right.
    distances, ends = (1.46, 1.48, 1.5, 1.52, 1.54), range(0, 161, 32)
    strips = [shoot(texture(side=192), distance, TRUE) for distance in distances]
    pair = [
        np.concatenate([strip[k][:, a : a + 32] for strip, a in zip(strips, ends, strict=False)], axis=1)
        for k in range(2)
    ]
    found = lm.imaging.calibrate_focus([pair], [1.5], TRUE, PIXEL, **OPTIONS)
    assert "not_flat" in found.findings.codes
    assert found.planes[0].tilt == pytest.approx(0.1 * math.sqrt(2.0), rel=0.4)


def test_a_plane_far_from_any_focus_near_the_stated_one_is_refused(pairs):
    with pytest.raises(ValueError, match=r"no lens with foci within 0\.17 dioptres"):
        lm.imaging.calibrate_focus(pairs[:1], [0.9], STATED, PIXEL, **OPTIONS)


def test_planes_compressed_as_jpeg_are_a_doubt():
    values = []
    for photograph in plane(1.25):
        file = io.BytesIO()
        light = np.clip(photograph, 0.0, 1.0)
        Image.fromarray(np.round(255.0 * light ** (1.0 / 2.2)).astype(np.uint8)).save(file, "JPEG", quality=90)
        values.append(np.asarray(Image.open(file)))
    found = lm.imaging.calibrate_focus([values], [1.25], STATED, PIXEL, encoding=2.2, origin=0.0)
    assert not found.reliable
    assert "use raw images or PNG" in found.findings.get("compressed").text


def test_three_planes_by_which_the_lens_is_another_one_are_a_doubt(found):
    kinds = [
        [(one.code, one.severity) for one in _findings({}, moved, found.planes, found.covariance, True)]
        for moved in (9.0, 11.0, 16.0)
    ]
    assert kinds == [[], [("contradiction", "doubt")], [("contradiction", "error")]]


def test_a_lens_that_contradicts_its_planes_is_not_written(found, tmp_path):
    source, target = tmp_path / "stated.toml", tmp_path / "calibrated.toml"
    source.write_text(LENS_FILE)
    wrong = replace(found, findings=Findings(_findings({}, 16.0, found.planes, found.covariance, True)))
    with pytest.raises(ValueError, match=r"is not written: .*16 standard errors from the stated one"):
        wrong.save(target, source)
    assert not target.exists()


def test_planes_without_texture_are_refused():
    flat = [NOISE.record(np.full((160, 160), 5e3), seed=seed) for seed in range(2)]
    with pytest.raises(ValueError, match=r"do not determine the focus|no lens with foci within"):
        lm.imaging.calibrate_focus([flat], [1.5], STATED, PIXEL, **OPTIONS)


def test_planes_that_would_determine_the_focus_are_beyond_the_foci_and_two_units_of_defocus():
    for unit, words in ((0.01, "1.2 m or 2.1 m"), (0.1, "1 m or 2.8 m"), (0.3, "730 mm,")):
        search = SimpleNamespace(foci=[1.0 / 1.35, 1.0 / 1.8], unit=unit, _origin=0.02)
        assert f"a plane at about {words}" in str(_Search._undetermined(search))


PAIR = [np.full((160, 160), 0.5)] * 2


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"lenses": [STATED[0]] * 2}, "lenses must be two that differ"),
        ({"lenses": [*STATED, STATED[0]]}, "lenses must be two"),
        ({"distances": [1.2, 1.4]}, "distances must be one for each of 1 pairs"),
        ({"distances": [0.03]}, "above its focal length"),
        ({"distances": [1.2], "origin": -1.19}, "above its focal length"),
        ({"photographs": [[np.full((64, 64), 0.5), np.full((64, 64), 0.4)]]}, "must have 8 tiles of 32 x 32"),
        ({"photographs": [PAIR[:1]]}, "as many as lenses"),
        ({"photographs": [PAIR]}, "must differ, got one twice"),
        ({"noise": 3.0}, "noise must be"),
    ],
)
def test_arguments_out_of_range_are_refused(changes, words):
    given = {"photographs": [PAIR], "distances": [1.5], "lenses": STATED, "pixel": PIXEL, "encoding": "linear"}
    with pytest.raises((TypeError, ValueError), match=words):
        lm.imaging.calibrate_focus(**given | changes)


def test_a_lens_file_hands_the_calibration_to_depth(found, tmp_path):
    source, target = tmp_path / "stated.toml", tmp_path / "calibrated.toml"
    source.write_text(LENS_FILE)
    found.save(target, source)
    assert target.read_text().startswith(LENS_FILE)
    read = load_instrument(target).calibration
    assert read.focus_distances == pytest.approx([lens.focus_distance for lens in found.lenses])
    assert read.f_numbers == pytest.approx((4.32, 4.32))
    assert read.f_number_scale == pytest.approx(found.f_number_scale)
    assert (read.f_number_error, read.focus_error) == pytest.approx(tuple(found.errors.values()), rel=0.01)
    with pytest.raises(ValueError, match=r"have no \[calibration\]"):
        found.save(tmp_path / "again.toml", target)
    assert len(str(found).splitlines()) <= 12
    assert found.to_dict()["lenses"][1]["focus_distance"] == found.lenses[1].focus_distance
