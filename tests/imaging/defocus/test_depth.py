"""Depth from photographs of different focus or aperture, of scenes that the PSFs of points make, with noise."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from planes import CAMERA, LENS, NOISE, PAIR, PIXEL, shoot, texture


def errors(found, distance, edge=8):
    inner = np.s_[edge:-edge, edge:-edge]
    return found.depth[inner] - distance, found.deviation[inner]


@pytest.mark.parametrize("distance", [1.4, 1.6])
def test_a_plane_is_found_as_well_as_can_be_with_the_deviation_told(distance):
    z, told = zip(
        *(
            errors(lm.imaging.depth_from_defocus(
                shoot(texture(seed=seed), distance, PAIR, seed=10 * seed), PAIR, PIXEL, **CAMERA
            ), distance)
            for seed in (3, 4)
        ),
        strict=True,
    )  # fmt: skip
    error, deviation = np.array(z), np.array(told)
    bound = lm.depth_precision(PAIR, distance, PIXEL, noise=NOISE, photons=5e3)
    assert np.sqrt((error**2).mean()) < 1.6 * bound
    assert abs(error.mean()) < 0.5 * bound  # of some fifty windows
    assert 0.6 < (error / deviation).std() < 1.5
    assert np.median(deviation) == pytest.approx(bound, rel=0.25)


def test_without_texture_there_is_no_depth():
    flat = np.full((112, 112), 0.5)
    found = lm.imaging.depth_from_defocus(shoot(flat, 1.5, PAIR), PAIR, PIXEL, **CAMERA)
    assert np.all(np.isinf(found.deviation))
    assert np.all(np.isnan(found.depth))
    assert found.known == 0.0
    with pytest.raises(ValueError, match="no depth is known"):
        _ = found.sharp
    # And beside texture there is none where there is none.
    scene = texture()
    scene[:, 56:] = 0.5
    found = lm.imaging.depth_from_defocus(shoot(scene, 1.5, PAIR), PAIR, PIXEL, **CAMERA)
    assert np.isfinite(found.deviation[:, :36]).mean() > 0.95
    assert np.isfinite(found.deviation[:, 60:]).mean() < 0.01


def test_what_is_beyond_the_range_is_not_said_to_be_within():
    images = shoot(texture(), 1.5, PAIR)
    for between in ((1.6, 2.2), (1.0, 1.4)):
        found = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, encoding="linear", noise=NOISE, between=between)
        assert found.known < 0.05


def test_dark_areas_beside_bright_texture_have_no_depth():
    fast = [lens.stopped(4.0) for lens in PAIR]
    known = []
    for seed in range(4):
        scene = texture(side=144, seed=seed)
        scene[:, 60:] = 0.1
        found = lm.imaging.depth_from_defocus(shoot(scene, 1.6, fast, seed=seed), fast, PIXEL, **CAMERA)
        known.append(np.isfinite(found.deviation[:, 70:]).mean())
    assert max(known) < 0.02


def test_the_deviation_grows_with_the_misfit():
    images = shoot(texture(), 1.5, PAIR)
    here = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, **CAMERA)
    moved = lm.imaging.depth_from_defocus([images[0], np.roll(images[1], 1, axis=1)], PAIR, PIXEL, **CAMERA)
    inner = np.s_[12:-12, 12:-12]
    ratio = np.median(moved.deviation[inner] / here.deviation[inner])
    assert np.median(moved.misfit[inner]) > 3.0
    assert ratio == pytest.approx(np.median(moved.misfit[inner]), rel=0.4)


def test_unknown_pixels_have_no_depth_and_spoil_none():
    images = shoot(texture(), 1.5, PAIR)
    whole = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, **CAMERA)
    images[0][30:50, 30:50] = np.nan
    images[1][10, 60] = 3.0
    found = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, saturation=2.0, **CAMERA)
    assert np.all(np.isinf(found.deviation[32:48, 32:48]))
    assert np.isnan(found.depth[40, 40])
    away = np.s_[60:, 8:-8]
    assert np.all(np.isfinite(found.deviation[away]))
    assert np.abs((found.depth - whole.depth)[away] / whole.deviation[away]).max() < 0.5
    assert np.isfinite(found.sharp).all()
    known = np.isfinite(found.deviation)
    assert np.abs((found.depth - 1.5) / found.deviation)[known].max() < 8.0


def test_light_that_unknown_pixels_may_have_spread_is_left_out():
    fast = [lens.stopped(2.8) for lens in PAIR]
    scene = texture()
    scene[56:60, 56:60] = 6.0  # a lamp, which is clipped
    images = [np.minimum(one, 1.8) for one in shoot(scene, 1.6, fast)]
    found = lm.imaging.depth_from_defocus(images, fast, PIXEL, saturation=1.7, **CAMERA)
    z = ((found.depth - 1.6) / found.deviation)[20:64, 20:64]
    known = np.isfinite(z)
    assert 0.1 < known.mean() < 0.9
    assert z[known].std() < 2.0


def test_three_photographs_of_three_foci_are_better_than_two():
    lenses = [*PAIR, LENS.focused(1.55)]
    images = shoot(texture(), 1.5, lenses)
    two = lm.imaging.depth_from_defocus(images[:2], lenses[:2], PIXEL, **CAMERA)
    three = lm.imaging.depth_from_defocus(images, lenses, PIXEL, **CAMERA)
    error, deviation = errors(three, 1.5)
    assert 0.6 < (error / deviation).std() < 1.5
    assert np.median(three.deviation) < np.median(two.deviation)
    bound = lm.depth_precision(lenses, 1.5, PIXEL, noise=NOISE, photons=5e3)
    assert error.std() < 1.6 * bound


def test_two_apertures_tell_depth_and_exposures_are_measured():
    lenses = [LENS.stopped(5.6), LENS.stopped(16.0)]
    light = (1.0, (5.6 / 16.0) ** 2)
    noise = lm.Noise(white=5e4, read=3.0)
    images = shoot(texture(), 1.6, lenses, exposures=light, noise=noise)
    camera = CAMERA | {"noise": noise, "between": (1.4, 2.0)}  # nearer than the focus there is another answer
    found = lm.imaging.depth_from_defocus(images, lenses, PIXEL, **camera)
    assert found.exposures == pytest.approx(light, rel=5e-3)
    error, deviation = errors(found, 1.6)
    assert 0.6 < (error / deviation).std() < 1.6
    assert np.median(deviation) < 0.02
    stated = lm.imaging.depth_from_defocus(images, lenses, PIXEL, exposures=light, **camera)
    assert stated.exposures == pytest.approx(light)
    assert np.abs(errors(stated, 1.6)[0] - error).max() < 3e-3


def test_colours_have_their_own_blur_and_one_depth():
    scene = np.stack([texture(seed=k) for k in range(3)], axis=2)
    images = [
        np.stack(
            [
                shoot(scene[..., k], 1.5, [lm.Lens(
                    focal_length=35e-3, f_number=8.0, focus_distance=lens.focus_distance, wavelength=wave
                )], seed=10 * k + j)[0]
                for k, wave in enumerate(lm.imaging.RED_GREEN_BLUE)
            ],
            axis=2,
        )
        for j, lens in enumerate(PAIR)
    ]  # fmt: skip
    found = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, **CAMERA)
    error, deviation = errors(found, 1.5)
    assert 0.6 < (error / deviation).std() < 1.5
    grey = lm.imaging.depth_from_defocus([one[..., 1] for one in images], PAIR, PIXEL, **CAMERA)
    assert np.median(deviation) == pytest.approx(np.median(grey.deviation) / np.sqrt(3.0), rel=0.2)
    assert found.sharp.shape == images[0].shape
    with pytest.raises(ValueError, match="drop the alpha"):
        lm.imaging.depth_from_defocus([np.dstack([one, one[..., :1]]) for one in images], PAIR, PIXEL, **CAMERA)


def test_the_sharp_image_is_nearer_to_the_scene_than_any_photograph():
    scene = texture()
    images = shoot(scene, 1.5, PAIR)
    found = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, **CAMERA)
    inner = np.s_[8:-8, 8:-8]
    truth = scene[16:-16, 16:-16]

    def off(image):
        return float((image - truth)[inner].std())

    assert off(found.sharp) < 0.6 * min(off(image) for image in images)
    assert found.sharp is found.sharp
    dim = lm.Noise(white=300.0, read=3.0)
    images = shoot(scene, 1.5, PAIR, noise=dim)
    noisy = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, **(CAMERA | {"noise": dim}))
    assert off(noisy.sharp) < min(off(image) for image in images)
    assert found.sharp.mean() == pytest.approx(truth.mean(), rel=5e-3)


def test_integers_in_srgb_are_what_their_light_is():
    from lommel.base.encoding import from_light

    images = [np.clip(one, 0.0, 1.0) for one in shoot(texture(mean=0.3), 1.5, PAIR)]
    stored = [from_light(one, "srgb", np.uint16) for one in images]
    linear = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, **CAMERA)
    found = lm.imaging.depth_from_defocus(stored, PAIR, PIXEL, **(CAMERA | {"encoding": "srgb"}))
    known = np.isfinite(linear.deviation) & np.isfinite(found.deviation)
    assert known.mean() > 0.9
    assert np.median(np.abs(found.depth - linear.depth)[known]) < 1e-4
    assert found.sharp.dtype == np.uint16


def test_lenses_that_breathe_are_brought_to_one_scale():
    scene = texture(side=144)
    images = shoot(scene, 1.5, PAIR)
    # Smaller, as the sensor stands nearer to the lens: about the middle by the ratio of their distances.
    from scipy.ndimage import affine_transform

    ratio = PAIR[0].sensor_distance / PAIR[1].sensor_distance
    middle = 0.5 * (images[1].shape[0] - 1)
    images[1] = affine_transform(images[1], ratio * np.eye(2), middle * (1.0 - ratio), order=5, mode="mirror")
    found = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, magnification="lens", **CAMERA)
    plain = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, **CAMERA)
    error, deviation = errors(found, 1.5)
    assert (error / deviation).std() < 1.6
    assert np.isfinite(deviation).all()
    corner = np.s_[8:24, 8:24]
    assert plain.misfit[corner].mean() > 2.0 > 1.4 > found.misfit[corner].mean()


def test_progress_and_files(tmp_path):
    images = shoot(texture(), 1.5, PAIR)
    seen = []
    found = lm.imaging.depth_from_defocus(
        images, PAIR, PIXEL, progress=lambda done, tiles: seen.append((done, tiles)), **CAMERA
    )
    assert seen == [(1, 1)]
    found.save(tmp_path / "depth.npy")
    assert np.array_equal(
        lm.imaging.read_depth(tmp_path / "depth.npy"), found.depth.astype(np.float32), equal_nan=True
    )


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"lenses": LENS}, "lenses must be a sequence of Lens"),
        ({"lenses": [LENS]}, "lenses must be two or more"),
        ({"photographs": [np.ones((40, 40))]}, "photographs must be as many as lenses, 2, got 1"),
        ({"photographs": [np.ones((40, 40)), np.ones((40, 41))]}, "photographs must be of one shape"),
        ({"photographs": [np.ones(40)] * 2}, r"photographs\[0\] must have the shape"),
        ({"photographs": [np.full((40, 40), np.nan)] * 2}, "no pixel that is known in all of them"),
        ({"photographs": [np.zeros((40, 40))] * 2}, "must hold light on average"),
        ({"pixel": 0.0}, "pixel must be"),
        ({"encoding": "log"}, "encoding must be"),
        ({"noise": 3.0}, "noise must be a Noise"),
        ({"between": 1.5}, "between must be the nearest and the farthest distance"),
        ({"between": (2.0, 1.2)}, "between must be the nearest and the farthest distance, got 2 and 1.2 m"),
        ({"between": (1.2, np.nan)}, "must be finite"),
        ({"window": 0.5}, "window must be >= 1"),
        ({"candidates": 8}, "candidates must be from 9"),
        ({"exposures": (1.0,)}, "exposures must be 2 numbers > 0"),
        ({"exposures": (1.0, -1.0)}, "exposures must be 2 numbers > 0"),
        ({"magnification": "zoom"}, "magnification must be"),
        ({"saturation": -1.0}, "saturation must be > 0"),
        ({"progress": 3}, "progress must be callable"),
        ({"wavelengths": (5e-7, 6e-7)}, "wavelengths must be one for each of the 1 channels"),
    ],
)
def test_what_is_out_of_range_is_told(change, message):
    given = {"photographs": [np.ones((40, 40))] * 2, "lenses": PAIR, "pixel": PIXEL} | CAMERA | change
    with pytest.raises((TypeError, ValueError), match=message):
        lm.imaging.depth_from_defocus(given.pop("photographs"), given.pop("lenses"), given.pop("pixel"), **given)


def test_lenses_must_be_round_and_candidates_near_enough():
    images = [np.ones((40, 40))] * 2
    comatic = lm.Lens(
        focal_length=35e-3, f_number=8.0, wavelength=540e-9, aberrations=lm.Wavefront(nonradial={(3, 1): 1.0})
    )
    with pytest.raises(ValueError, match=r"lenses\[1\] must .* symmetric .* got coma x: leave"):
        lm.imaging.depth_from_defocus(images, [LENS, comatic], PIXEL, **CAMERA)
    spiders = lm.Lens(focal_length=35e-3, f_number=8.0, wavelength=540e-9, spider=lm.Spider(0.02, angles=(0.0, 1.5)))
    with pytest.raises(ValueError, match=r"lenses\[0\] must have a round aperture"):
        lm.imaging.depth_from_defocus(images, [spiders, LENS], PIXEL, **CAMERA)
    fast = [lens.stopped(1.4) for lens in PAIR]
    with pytest.raises(ValueError, match="candidates must be from"):
        lm.imaging.depth_from_defocus(images, fast, PIXEL, candidates=61, **CAMERA)


def test_a_slope_is_found_with_a_deviation_that_knows_of_it():
    fast = [lens.stopped(2.8) for lens in PAIR]
    depth = np.broadcast_to(np.linspace(1.4, 1.7, 160), (112, 160))
    scene = np.hstack([texture(seed=2), texture(seed=3)[:, :48]])
    images = []
    for seed, lens in enumerate(fast):
        blur = lm.imaging.DepthBlur(depth, lens, PIXEL, energy=0.99, largest=60)
        images.append(NOISE.record(1e4 * np.maximum(blur.forward(scene), 0.0), seed=seed))
    found = lm.imaging.depth_from_defocus(images, fast, PIXEL, **CAMERA)
    error = (found.depth - depth)[12:-12, 12:-12]
    assert np.sqrt((error**2).mean()) < 6e-3
    assert 0.6 < (error / found.deviation[12:-12, 12:-12]).std() < 1.4
    # Nowhere better than a third of the window times the slope, 1.9 mm a pixel, about.
    assert np.percentile(found.deviation[12:-12, 12:-12], 5) > 2.5e-3
    assert abs(np.polyfit(depth[0, 12:-12], np.median(error, axis=0), 1)[0]) < 0.02


def test_the_slope_is_that_of_the_position_and_none_beside_what_is_not_known():
    from lommel.imaging.defocus_depth import _slope

    position = 0.2 * np.arange(30.0)[:, None] - 0.1 * np.arange(40.0)
    assert _slope(position, 4.0) == pytest.approx(np.hypot(0.2, 0.1))
    position[10, 20] = np.nan
    found = _slope(position, 4.0)
    assert np.isfinite(found).all()
    assert found[10, 16] == pytest.approx(0.2)  # of the other axis alone
