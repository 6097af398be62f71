"""Cosmic rays in windows of stars are found, and nothing of the stars, in a world that is not the model's."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.estimation.cosmic_rays import cosmic_ray_mask, sharpness
from tests.world.camera import Camera
from tests.world.optics import Telescope, as_waves

CAMERA = Camera(gain=0.0, read=3.0)
PUPIL = lm.Pupil(obscuration=0.3)
TRACKS = {"single": ((4, 5), (0, 1), 1), "along a row": ((3, 3), (0, 1), 6), "across": ((2, 2), (1, 1), 8)}


def seen(waves=(), *, pixel=0.94, flux=2e4, row=12.2, column=11.9, side=25):
    transfer = Telescope(obscuration=0.3).transfer(as_waves(dict(waves)))
    return flux * transfer.image(side, pixel, row, column) + 50.0


def found(images, pixel=0.94, valid=None):
    known = np.isfinite(images) if valid is None else valid
    read = np.full(images.shape, 9.0)
    return cosmic_ray_mask(np.where(known, images, 0.0), read, known, sharpness(PUPIL, pixel, integrate=True))


def near(track):
    padded = np.pad(track, 1)
    return np.any([padded[1 + y : 26 + y, 1 + x : 26 + x] for y in (-1, 0, 1) for x in (-1, 0, 1)], axis=0)


def track(start, step, length):
    made = np.zeros((25, 25), dtype=bool)
    for k in range(length):
        made[start[0] + k * step[0], start[1] + k * step[1]] = True
    return made


@pytest.mark.parametrize("name", TRACKS)
@pytest.mark.parametrize("light", [400.0, 6000.0])
def test_tracks_beside_a_star_are_left_out_with_their_rims(name, light):
    ray = track(*TRACKS[name])
    image = CAMERA.record(seen({6: 0.4, 8: 0.5}), seed=1)
    image[ray] += light
    image[:, 9] = np.nan
    known = np.isfinite(image)
    left = found(image)
    assert left[ray & known].all()
    assert not (left & ~near(ray)).any()
    assert not left[~known].any()


@pytest.mark.parametrize("pixel", [0.5, 0.94, 3.0])
@pytest.mark.parametrize("waves", [{}, {4: 0.7, 8: 0.5}, {4: 3.0, 6: 1.0}])
def test_no_pixel_of_stars_is_left_out(pixel, waves):
    draw = np.random.default_rng(5)
    for flux in (3e3, 1e5, 3e6):
        row, column = 12 + draw.uniform(-0.5, 0.5, 2)
        image = CAMERA.record(seen(waves, pixel=pixel, flux=flux, row=row, column=column), seed=int(flux))
        assert not found(image, pixel).any()


def test_each_image_of_several_exposures_is_looked_at():
    images = CAMERA.record(np.broadcast_to(seen(), (3, 2, 25, 25)), seed=2)
    images[1, 1, 3, 20] += 3000.0
    left = found(images)
    assert left.shape == images.shape
    assert np.argwhere(left.any(axis=(2, 3))).tolist() == [[1, 1]]
    assert left[1, 1, 3, 20]


def test_windows_full_of_sharp_pixels_keep_them():
    image = CAMERA.record(seen(), seed=3)
    image[1::3, 1::3] += 3000.0
    assert not found(image).any()


def test_pixels_that_sample_are_compared_with_samples():
    one, other = (sharpness(lm.Pupil(), 0.5, integrate=integrate) for integrate in (False, True))
    assert 1.0 < other < one
