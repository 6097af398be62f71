"""Sharp images of single frames of known depth, of continuous scenes that are rendered without this package."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from scenes import ThinLens, averaged, lommel_lens, plane, record, texture

SIDE, LIGHT = 128, 5000.0
LENS = ThinLens(35e-3, 8.0, 1.35, 540e-9, 4e-6)


def made(**options):
    given = {"between": (1.2, 2.0), "noise": lm.Noise(read=3.0, offset=100.0), "shape": (SIDE, SIDE)} | options
    return lm.imaging.LiveSharpen(lommel_lens(LENS), 4e-6, **given)


@pytest.fixture(scope="module")
def sharpen():
    return made()


@pytest.mark.parametrize("distance", [1.25, 1.6, 1.9])
def test_a_frame_is_nearer_to_the_scene(sharpen, distance):
    scene = texture("leaves", SIDE, seed=7)
    truth = LIGHT * averaged(scene)
    frame = record(plane(scene, [LENS], distance, LIGHT), seed=3)[0]
    found = sharpen(frame, distance)
    inner = np.s_[16:-16, 16:-16]
    assert (found - truth)[inner].std() < 0.85 * (frame - 100.0 - truth)[inner].std()
    assert found.mean() == pytest.approx(frame.mean() - 100.0, rel=1e-4)
    # A map of the same depth, of pixels or of blocks, and the other types tell the same.
    for depth in (np.full((SIDE, SIDE), distance), np.full((SIDE // 4, SIDE // 4), distance)):
        np.testing.assert_allclose(sharpen(frame, depth), found, rtol=2e-4)
    np.testing.assert_allclose(sharpen(frame.astype(float), distance), found, rtol=1e-6)
    out = np.empty((SIDE, SIDE), np.float32)
    assert sharpen(frame, distance, out) is out


def test_each_side_of_a_map_is_sharpened_by_its_own_depth(sharpen):
    scene = texture("leaves", SIDE, seed=7)
    frame = record(plane(scene, [LENS], 1.9, LIGHT), seed=3)[0]
    depth = np.full((SIDE, SIDE), 1.9)
    depth[:, 64:] = 1.35
    found = sharpen(frame, depth)
    np.testing.assert_allclose(found[:, :48], sharpen(frame, 1.9)[:, :48], rtol=1e-5)
    np.testing.assert_allclose(found[:, 80:], sharpen(frame, 1.35)[:, 80:], rtol=1e-5)


def test_colours_and_full_pixels_are_taken(sharpen):
    scene = texture("leaves", SIDE, seed=7)
    frame = record(plane(scene, [LENS], 1.7, LIGHT), seed=3)[0]
    colour = made(shape=(SIDE, SIDE, 3))(np.stack([frame] * 3, axis=2), 1.7)
    np.testing.assert_allclose(colour[..., 1], sharpen(frame, 1.7), rtol=1e-6)
    full = frame.copy()
    full[64, 64] = 65535
    found = sharpen(full, 1.7)
    assert np.abs(found - sharpen(frame, 1.7)).max() < 0.5 * LIGHT


def test_errors_of_filters_are_those_of_sums_over_the_bands_that_pixels_fold():
    from lommel.estimation.focal_model import FocalLight, FocalModel
    from lommel.imaging.focal_tables import SharpTables, Taps

    lens, share = lm.Lens(focal_length=25e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9), 0.4
    light = FocalLight(5e3, 3.0, (1.0,), 0.35)
    model = FocalModel.of([lens], np.array([0.5, 0.55]), ((550e-9, 1.0),), 4e-6, light)
    tables, band = SharpTables(model, Taps.of(5), 12), model.band
    draw = np.random.default_rng(0).uniform(0.0, 1.0, model.transfer.shape)
    for filters in (np.zeros(model.transfer.shape), draw):
        error = model.white[:, None] * filters[:, 0] ** 2
        for across in (-1.0, 0.0, 1.0):
            for down in (-1.0, 0.0, 1.0):
                x, y = band.fx - across, band.fy - down
                pixel, part = np.sinc(x) * np.sinc(y), share if across or down else 1.0
                seen = np.array(
                    [lm.otf(lens.pupil(1.0 / u), np.hypot(x, y) / 4e-6, tol=1e-8).real for u in (0.5, 0.55)]
                )
                texture, frame = light.power(np.hypot(x, y)), filters[:, 0] * seen * pixel
                # What aliases the image and the filtered frame share is of a part of the power; a frame has them all.
                error = error + texture * (part * (pixel**2 - 2.0 * pixel * frame) + frame**2)
        np.testing.assert_allclose(tables._errors(tables.pixel, filters), error @ band.share, rtol=2e-3)
