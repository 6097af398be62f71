"""Noise of a camera, counts, saturation and what images state."""

from __future__ import annotations

import math
import pickle

import numpy as np
import pytest

import lommel as lm
from lommel.fit import Findings
from lommel.recorded import camera_noise
from lommel.recorded.counts import counts_of, flat_top, flat_tops, full_value, recording_findings

MAP = np.linspace(1.0, 3.0, 12).reshape(3, 4)


@pytest.mark.parametrize(
    "noise", [lm.Noise(white=0.46, read=1.6, offset=100), lm.Noise(white=MAP, read=1, offset=MAP)]
)
def test_values_are_electrons_over_white_above_the_offset(noise):
    image = np.arange(24.0).reshape(2, 3, 4)
    assert noise.electrons(image) == pytest.approx((image - noise.offset) * noise.white, rel=1e-15)
    assert noise.image(noise.electrons(image)) == pytest.approx(image, abs=1e-12)


def test_without_white_and_offset_images_are_in_electrons():
    assert np.array_equal(lm.Noise(read=3).electrons(MAP), MAP)
    assert np.array_equal(lm.Noise(read=3).image(MAP), MAP)


def test_what_is_recorded_has_the_mean_and_the_variance_that_are_said():
    noise = lm.Noise(white=0.5, read=MAP, offset=7.0)
    mean = 20.0 * MAP
    images = noise.electrons(noise.record(np.broadcast_to(mean, (100_000, 3, 4)), seed=1))
    assert images.mean(axis=0) == pytest.approx(mean, rel=0.005)
    assert images.var(axis=0) == pytest.approx(noise.variance(mean), rel=0.02)
    assert noise.variance(mean) == pytest.approx(mean + MAP**2, rel=1e-15)


def test_one_seed_draws_one_noise():
    noise = lm.Noise(read=2.0)
    assert np.array_equal(noise.record(MAP, 5), noise.record(MAP, 5))
    assert not np.array_equal(noise.record(MAP, 5), noise.record(MAP, 6))


@pytest.mark.parametrize("noise", [lm.Noise(read=2), lm.Noise(white=5000, read=MAP, offset=-0.01)])
def test_noise_comes_back_from_plain_types_and_from_a_pickle(noise):
    for back in (lm.Noise(**noise.to_dict()), pickle.loads(pickle.dumps(noise))):
        assert back == noise
        assert hash(back) == hash(noise)
    assert noise != lm.Noise(read=2.5)
    assert noise != "noise"


def test_a_map_is_a_copy_that_cannot_be_changed():
    given = MAP.copy()
    noise = lm.Noise(read=given)
    given[:] = 0.0
    assert np.array_equal(noise.read, MAP)
    with pytest.raises(ValueError, match="read-only"):
        noise.read[0, 0] = 1.0


@pytest.mark.parametrize(
    ("options", "error", "said"),
    [
        ({}, TypeError, "read"),
        ({"read": -1.0}, ValueError, "read must be finite and >= 0, got -1.0"),
        ({"read": [1.0, 2.0]}, ValueError, r"read must be a number or have the shape .*, got shape \(2,\)"),
        ({"read": 1, "white": 0}, ValueError, "white must be > 0 electrons, got 0"),
        ({"read": 1, "white": np.zeros((0, 4))}, ValueError, r"white must be a number or .*, got shape \(0, 4\)"),
    ],
)
def test_what_is_no_noise_is_refused(options, error, said):
    with pytest.raises(error, match=said):
        lm.Noise(**options)


def test_images_that_do_not_fit_are_refused():
    noise = lm.Noise(white=2.0, read=MAP)
    with pytest.raises(ValueError, match=r"read, of shape \(3, 4\), must have a value for each pixel, got .*\(4"):
        noise.variance(MAP.T)
    with pytest.raises(ValueError, match="image must be finite, got nan"):
        noise.electrons(math.nan)
    with pytest.raises(ValueError, match=r"electrons must be finite and >= 0, got -1.0"):
        noise.record(-np.ones((3, 4)), 0)


def test_of_a_large_stack_fewer_points_do(monkeypatch):
    rng = np.random.default_rng(3)
    light = 50.0 + 950.0 * rng.random((8, 1, 1)) * np.linspace(0.1, 1.0, 90) * np.ones((90, 1))
    stack = lm.Noise(white=0.5, read=1.6, offset=100.0).record(light, seed=4)
    whole, error = camera_noise.measured_noise(stack)
    monkeypatch.setattr(camera_noise, "_POINTS", 9000)
    fewer, larger = camera_noise.measured_noise(stack)
    assert 1.5 * error < larger < 4.0 * error
    assert abs(float(fewer.white) - float(whole.white)) < 3.0 * larger * float(whole.white)


NOISE = lm.Noise(white=0.46, read=1.6, offset=100.0)
IMAGES = np.round(NOISE.record(np.full((3, 8, 9), 400.0), seed=1)).astype(np.uint16)


def counted(images, **options):
    return counts_of("images", images, sides=(2, 3), shape="(height, width) or (n, height, width)", **options)


def told(images):
    return Findings(recording_findings(images, NOISE, "image")).text


@pytest.mark.parametrize("kind", [np.uint16, np.int32, np.float32])
def test_pixels_are_known_full_or_hidden(kind):
    images = IMAGES.astype(kind)
    images[0, 2, 3] = images[1, 2, 4] = 2000
    mask = np.zeros((8, 9), dtype=bool)
    mask[2, 4] = True
    found = counted(images, saturation=2000, mask=mask)
    assert np.argwhere(found.full).tolist() == [[0, 2, 3]]
    assert np.argwhere(found.hidden).tolist() == [[0, 2, 4], [1, 2, 4], [2, 2, 4]]
    assert (~found.known).sum() == 4
    assert found.marked().dtype == (np.float64 if kind == np.int32 else np.float32)
    np.testing.assert_array_equal(np.isnan(found.marked()), ~found.known)
    np.testing.assert_array_equal(found.filled(), np.where(found.known, images, 0.0))
    assert counted(IMAGES).marked() is IMAGES
    assert "4 of 216 pixels left out (masked, saturated or NaN)" in told([found])
    assert told([counted(IMAGES)]) == ""


def test_infinities_are_left_out_and_the_largest_of_a_type_is_full():
    images = IMAGES.astype(np.float64)
    images[0, 0, :3] = np.nan, np.inf, -np.inf
    assert (~counted(images).known).sum() == 3
    images = IMAGES.copy()
    images[2, 1, 1] = 65535
    assert np.argwhere(counted(images).full).tolist() == [[2, 1, 1]]
    assert counted(images, saturation=np.inf).known.all()


def test_what_was_assumed_or_may_be_saturated_is_said_once():
    bright = np.clip(np.arange(216.0).reshape(3, 8, 9) * 10.0, 100, 1023)
    found = counted(bright.astype(np.uint16))
    assert found.saturation == 1023
    said = told([found[0], found[1], found[2]])
    assert said.count("that of 10 bits: they were taken as saturated; saturation= sets another limit") == 1
    other = counted(np.minimum(bright, 1000.0))
    said = told([other[k] for k in range(3)])
    assert "pixels of image 1 have exactly the largest value, 1000: if they are saturated, state it" in said


def test_images_without_light_or_known_pixels_are_refused():
    dark = IMAGES.copy()
    dark[1] = 7
    with pytest.raises(ValueError, match=r"images\[1\] must show a star, got the value 7 everywhere"):
        counted(dark).require_light("images", "a star")
    blind = np.where(np.arange(3)[:, None, None] == 2, np.nan, IMAGES)
    with pytest.raises(ValueError, match=r"images\[2\] must have pixels that are neither .*, got none"):
        counted(blind).require_known("images")
    half = np.where(np.arange(9) < 6, np.nan, IMAGES)
    counted(half).require_known("images", 0.3)
    with pytest.raises(ValueError, match=r"images\[0\] must have at least 36 of 72 pixels .*, got 24"):
        counted(half).require_known("images", 0.5)
    with pytest.raises(ValueError, match="images must have pixels"):
        counted(blind[2]).require_known("images")


AIRY = lm.psf(lm.Pupil(), 31, 0.5).values


def counts(flux, white, seed):
    """Return a stack of stars in counts and its noise."""
    noise = lm.Noise(white=white, read=1.6, offset=100.0)
    return noise.record(np.repeat(flux * AIRY[None] + 20.0, 8, axis=0), seed=seed).round(), noise


@pytest.mark.parametrize("share", [0.9, 0.5, 0.1])
@pytest.mark.parametrize("white", [0.1, 1.0, 5.0])
def test_a_flat_top_is_found_with_its_value(share, white):
    values, noise = counts(1e5, white, 1)
    limit = np.round(100.0 + share * (values.max() - 100.0))
    top, count = flat_top(np.minimum(values, limit), np.ones(values.shape, dtype=bool), noise)
    assert top == limit
    assert count == (values >= limit).sum()
    valid = values < limit
    assert flat_top(values, valid, noise)[1] == 0  # saturation that was stated


@pytest.mark.parametrize("white", [0.1, 1.0, 30.0])
def test_noise_alone_has_no_flat_top_even_if_few_counts_are_many_electrons(white):
    for flux in (0.0, 30.0, 300.0, 1e5):
        for seed in range(10):
            values, noise = counts(flux, white, seed)
            assert flat_top(values, np.ones(values.shape, dtype=bool), noise)[1] == 0


def test_full_is_what_is_stated_else_the_largest_of_the_type_or_of_the_bits_of_a_camera():
    values, _ = counts(1e5, 5.0, 3)
    stored = values.astype(np.uint16)
    for bits in (8, 10):
        for made in (np.minimum(stored, 2**bits - 1), np.minimum(values, 2**bits - 1)):
            limit, said = full_value(list(made), None)
            assert limit == 2**bits - 1
            assert said.startswith(
                f"{(made == limit).sum()} pixels have exactly the largest value, {limit:.10g}, that of"
            )
            assert full_value([made], 999.0) == (999.0, "")
            assert full_value([made], np.inf)[0] == np.inf
    assert full_value([stored], None) == (65535, "")
    assert full_value([values], None) == (np.inf, "")
    assert full_value([np.minimum(values, 4000.0)], None) == (np.inf, "")  # which flat_top asks about


@pytest.mark.parametrize("bits", [8, 10, 12, 14, 16])
def test_a_full_scale_is_remarked_where_it_is_the_largest_of_all_images_and_nothing_is_stated(bits):
    values, noise = counts(1e5, 5.0, 3)
    full = 2**bits - 1
    images = np.round(0.8 * full / values.max() * values)

    def remark(images, saturation=None):
        return flat_tops([counted(images=image, saturation=saturation) for image in images], noise, "image")

    assert remark(images) == ""
    images[1, 15, 15] = full
    assert remark(images).startswith(f"1 pixel has the value {full} = 2^{bits} - 1, the largest of {bits} bits")
    images[4, 15, 15] = full
    for integers in (images, images.astype(np.uint32)):
        assert remark(integers).startswith(
            f"2 pixels have the value {full} = 2^{bits} - 1, the largest of {bits} bits"
        )
        assert f"(saturation={full})" in remark(integers)
    assert remark(images, 1e6) == ""
    assert remark(images + 1.0) == ""
    assert remark(images + 0.25 * (images < 0.5 * full)) == ""  # not counts
    images[6, 15, 15] = full + 7
    assert remark(images) == ""


@pytest.mark.parametrize("white", [0.1, 1.0, 30.0])
def test_noise_that_ends_at_a_power_of_two_is_not_saturated(white):
    for flux in (30.0, 300.0, 1e5):
        for seed in range(5):
            values, _ = counts(flux, white, seed)
            for shift in (0, 1023 - values.max()):  # its largest value is that of ten bits
                assert full_value([values + shift], None)[0] == np.inf


@pytest.mark.parametrize("bits", [10, 12, 14])
def test_the_common_divisor_of_counts_and_images_of_0_to_1_are_named(bits):
    def found(images, **noise):
        noise = lm.Noise(read=1, **noise)
        return Findings(recording_findings([counted(images=images, noise=noise)], noise, "image"))

    values, factor = np.random.default_rng(0).poisson(50.0, (2, 8, 9)).astype(np.uint16), 2 ** (16 - bits)
    text = found(values * np.uint16(factor)).get("multiples").text
    assert text.startswith(f"all values are multiples of {factor}, as of {bits} bits stored in 16")
    assert not {"multiples", "no_counts"} & set(found(values).codes)
    text = found(values / 65535.0).get("no_counts").text
    assert text.startswith(f"the largest value is {values.max() / 65535:.3g}, of less than one electron: counts are")
    assert found(values / 65535.0, white=65535.0).get("no_counts") is None
