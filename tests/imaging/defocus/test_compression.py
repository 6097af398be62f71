"""Photographs compressed as JPEG, and those by which nothing can be tested."""

from __future__ import annotations

import io

import numpy as np
import pytest
import scipy.ndimage
from PIL import Image

from lommel.cli.instruments import FrameNoise
from lommel.cli.video_coding import coding_of
from lommel.cli.video_faults import loss_note
from lommel.imaging.defocus_depth import depth_from_defocus
from lommel.imaging.defocus_verdict import DefocusVerdict
from lommel.imaging.frame_phases import frame_shift
from lommel.imaging.pair_noise import EstimatedNoise, is_compressed
from lommel.recorded.noise import Noise
from scenes import ThinLens, lommel_lens, plane, texture


@pytest.mark.parametrize("quality", [75, 95, None])
def test_blocks_of_jpeg_are_found_and_only_these(quality):
    rng = np.random.default_rng(3)
    scene = 120.0 + 60.0 * np.sin(np.arange(240) / 7.0)[:, None] * np.cos(np.arange(200) / 5.0)
    values = np.round(scene + rng.normal(0.0, 2.0, scene.shape)).astype(np.uint8)
    if quality is not None:
        file = io.BytesIO()
        Image.fromarray(values).save(file, "JPEG", quality=quality)
        values = np.asarray(Image.open(file))
    # Cropping moves the edges of blocks.
    assert is_compressed((values[3:, 5:] / 255.0) ** 2.2) == (quality is not None)


@pytest.mark.quick
def test_jpeg_finer_than_the_noise_is_found_and_a_screen_of_eight_pixels_is_none():
    rng = np.random.default_rng(5)
    values = np.clip(np.round(rng.normal(128.0, 5.0, (160, 160))), 0, 255).astype(np.uint8)
    file = io.BytesIO()
    Image.fromarray(values).save(file, "JPEG", quality=95)
    dots = 40.0 * np.kron(np.ones((20, 20)), np.pad(np.ones((3, 3)), (2, 3)))
    for seen, compressed in ((np.asarray(Image.open(file)), True), (values, False), (values + dots, False)):
        assert is_compressed(seen.astype(np.float32)) == compressed


@pytest.mark.parametrize("period", [4, 6, 12])
def test_printed_lines_are_not_compressed(period):
    rng = np.random.default_rng(5)
    ink = rng.uniform(0.0, 1.0, (240, 200)) * (np.arange(240) % period < 0.7 * period)[:, None]
    page = scipy.ndimage.gaussian_filter(1.0 - 0.7 * ink, 0.8)
    assert not is_compressed(page + rng.normal(0.0, 0.01, page.shape))


@pytest.mark.parametrize(("width", "sigma", "corner"), [(2.5, 0.8, (3, 5)), (4.0, 1.5, (4, 0))])
def test_a_screen_of_eight_pixels_is_not_compressed(width, sigma, corner):
    x = (np.arange(4 * 240) + 0.5) / 4
    row, column = ((x + start) % 8 < width for start in corner)
    points = scipy.ndimage.gaussian_filter(0.7 - 0.45 * (row[:, None] | column), 4 * sigma)
    light = points.reshape(240, 4, 240, 4).mean(axis=(1, 3))
    assert not is_compressed(np.random.default_rng(2).poisson(1e4 * light) / 1e4)


@pytest.mark.parametrize("contrast", [0.0, 0.2])
def test_depth_of_a_plain_area_in_jpeg_is_none(contrast):
    thin = [ThinLens(35e-3, 8.0, focus, 540e-9, 4e-6) for focus in (1.35, 1.8)]
    photos = []
    for seed, light in enumerate(plane(1.0 + contrast * (texture("pink", 160, 3) - 1.0) / 0.2, thin, 1.55, 1.0)):
        colours = np.random.default_rng(seed).poisson(2e3 * light[..., None], (160, 160, 3)) / 5e3
        file = io.BytesIO()
        Image.fromarray(np.round(255 * colours.clip(0, 1) ** (1 / 2.2)).astype(np.uint8)).save(
            file, "JPEG", quality=85
        )
        photos.append(np.asarray(Image.open(file)))
    found = depth_from_defocus(photos, [lommel_lens(lens) for lens in thin], 4e-6, encoding=2.2, between=(1.2, 2.0))
    assert (found.known > 0.5) == (contrast > 0.0)
    assert (found.verdict.status == "no_depth") == (contrast == 0.0)


def test_a_verdict_by_which_nothing_is_tested_is_not_reliable():
    noise = EstimatedNoise(Noise(white=5e3, read=2.0))
    verdict = DefocusVerdict.of(1.0, noise=noise, compressed=True)
    assert not verdict.reliable
    assert verdict.findings.get("undetermined").severity == "doubt"
    assert "use raw images or PNG" in verdict.findings.get("untested").numbers["what"][0]
    assert verdict.summary.startswith("compressed (JPEG)")
    assert "undetermined" not in DefocusVerdict.of(1.0, 1.0, 0.03, noise=noise).findings.codes


@pytest.mark.parametrize(("excess", "code"), [(25.0, "undetermined"), (40.0, "misfit")])
def test_a_difference_that_jpeg_explains_is_put_down_to_it(excess, code):
    verdict = DefocusVerdict.of(1.0, noise=EstimatedNoise(Noise(white=5e3, read=2.0)), excess=excess, compressed=True)
    assert {"undetermined", "misfit"} & set(verdict.findings.codes) == {code}
    assert ("JPEG" in verdict.findings.get(code).text) == (code == "undetermined")


# In right frames quality 75 leaves 8 to 25 times the noise of the finest details, in shifted ones 15 and more.
@pytest.mark.parametrize("shift", [(0, 0), (1, 0), (0, -1)])
def test_a_shift_is_told_in_jpeg(shift):
    thin, photos = [ThinLens(35e-3, 8.0, focus, 540e-9, 4e-6) for focus in (1.35, 1.8)], []
    draw = np.random.default_rng(4)
    for light, moved in zip(plane(texture("pink", 160), thin, 1.5, 600.0), ((0, 0), shift), strict=True):
        file = io.BytesIO()
        values = 255.0 * (np.roll(draw.poisson(light), moved, axis=(0, 1)) / 1200.0) ** (1.0 / 2.2)
        Image.fromarray(np.clip(np.round(values), 0, 255).astype(np.uint8)).save(file, "JPEG", quality=75)
        photos.append(np.asarray(Image.open(file)))
    found = depth_from_defocus(photos, [lommel_lens(lens) for lens in thin], 4e-6, encoding=2.2, between=(1.2, 2.0))
    told = found.verdict.findings.get("misfit")
    assert (told is not None) == any(shift)
    if told:
        assert told.severity == "error"
        np.testing.assert_allclose(told.numbers["shift"], shift, atol=0.1)


@pytest.mark.quick
def test_a_shift_of_fine_texture_in_noise_is_not_smaller():
    random = np.random.default_rng(0)
    scene = random.standard_normal((160, 160))
    near, far = (
        scipy.ndimage.gaussian_filter(scene, blur, mode="wrap") + 0.2 * random.standard_normal(scene.shape)
        for blur in (2.5, 3.2)
    )
    for rows in (0, 1):
        found = frame_shift(np.stack([near, np.roll(far, rows, axis=0)]), np.ones(scene.shape, dtype=bool), 5.0)
        np.testing.assert_allclose(found, (1.0, 0.0) if rows else (), atol=0.2)


def test_one_edge_that_is_blurred_more_in_one_frame_is_not_shifted():
    edge = np.where(np.arange(160 * 8) < 50 * 8, 0.5, 1.5) * np.ones((160 * 8, 1))
    thin = [ThinLens(35e-3, 4.0, focus, 540e-9, 4e-6) for focus in (1.35, 1.8)]
    frames = np.array(plane(edge, thin, 1.3, 5000.0), dtype=np.float32)
    assert frame_shift(frames, np.ones(frames.shape[1:], dtype=bool), 11.0) == ()
    assert frame_shift(
        np.stack([frames[0], np.roll(frames[0], 2, axis=1)]), np.ones(frames.shape[1:], dtype=bool), 11.0
    )


def test_a_doubt_is_not_called_a_contradiction():
    assert DefocusVerdict.of(1.5).summary == "what was tested is in doubt"
    assert DefocusVerdict.of(2.5).summary == "what was tested disagrees"


@pytest.mark.parametrize(("stated", "measured"), [(None, False), (0.04, True)])
def test_a_lens_whose_errors_are_stated_is_not_to_be_calibrated_again(stated, measured):
    verdict = DefocusVerdict.of(1.0, noise=EstimatedNoise(Noise(white=5e3, read=2.0)), stated=stated)
    assert ("calibrate" in verdict.message) != measured


@pytest.mark.parametrize(
    ("loss", "words", "finer"),
    [(1.4, "adds 1.8 times", False), (6.2, "adds 8 times", True), (np.inf, "cannot be read", True), (0.5, "", False)],
)
def test_less_compression_is_advised_only_where_there_is_less(loss, words, finer):
    given = FrameNoise(white=24e3, read=3.0)
    coding = coding_of(256, np.dtype(np.uint8), "srgb", given, None, None)
    note = loss_note(np.full((3, 4), loss / 255.0**2), coding)
    assert words in note
    assert bool(note) == bool(words)
    assert ("quality 1 (-q:v 1 -qmin 1" in note) == finer
