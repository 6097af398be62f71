"""Frames of one scene are moved to the place of the first, with an error that contains what is left, or refused.

Scenes are sums of Gaussian spots, each blurred by its own depth: their frames are computed exactly at any place.
"""

from __future__ import annotations

import json

import numpy as np
import pytest

from command_lines import lommel
from lommel.imaging import align, read_photo, write_photo

SHAPE = (256, 320)
HAND = {"shift": 6.3 - 7.4j, "scale": 1.01, "angle": np.deg2rad(-0.3)}  # x + iy, pixels


def frame(seed, blurs, shift=0j, scale=1.0, angle=0.0, noise=0.004, shape=SHAPE):
    """A frame moved from that of no shift: blurs are the rms widths of the near and the far half of the spots."""
    rng = np.random.default_rng(seed)
    places = (rng.uniform(-0.7, 0.7, (700, 2)) * [shape[1], shape[0]]) @ [1, 1j]
    widths, heights = rng.uniform(0.8, 5.0, 700), rng.normal(0.0, 1.0, 700)
    moved = scale * np.exp(1j * angle) * places + shift + 0.5 * complex(shape[1], shape[0])
    image = np.full(shape, 0.5)
    for k, (place, width, height) in enumerate(zip(moved, widths, heights, strict=True)):
        sigma = np.hypot(width * scale, blurs[k % 2])
        reach = int(5 * sigma) + 1
        rows = np.arange(max(0, int(place.imag) - reach), min(shape[0], int(place.imag) + reach + 2))
        columns = np.arange(max(0, int(place.real) - reach), min(shape[1], int(place.real) + reach + 2))
        if not (len(rows) and len(columns)):
            continue
        values = np.outer(*(np.exp(-0.5 * ((axis - at) / sigma) ** 2) for axis, at in
                            ((rows, place.imag), (columns, place.real))))  # fmt: skip
        image[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1] += 0.1 * height * (width / sigma) ** 2 * values
    return image + noise * np.random.default_rng(seed + int(abs(shift) * 1e3)).normal(size=shape)


def left_over(found, k=1, shift=0j, scale=1.0, angle=0.0):
    """What is left of a displacement, pixels, rms over the frame."""
    rows, columns = np.indices(SHAPE)
    z = columns - 0.5 * SHAPE[1] + 1j * (rows - 0.5 * SHAPE[0])
    estimate = found.scales[k] * np.exp(1j * found.angles[k]) * z + found.shifts[k] @ [1j, 1]
    return np.sqrt(np.mean(np.abs(estimate - (scale * np.exp(1j * angle) * z + shift)) ** 2))


@pytest.mark.quick
def test_a_hand_held_pair_of_two_foci_is_aligned_to_a_tenth_of_a_pixel():
    first = frame(1, (0.5, 1.5))
    found = align([first, frame(1, (1.5, 0.5), **HAND)])
    assert left_over(found, **HAND) < min(0.1, 3.0 * found.errors[1])
    assert found.errors[1] < 0.1
    assert not found.notes
    rows, columns = found.crop
    assert (rows.stop - rows.start, columns.stop - columns.start) == found.frames[0].shape == found.frames[1].shape
    assert np.array_equal(found.frames[0], first[found.crop])
    still = frame(1, (1.5, 0.5))[found.crop]
    assert np.sqrt(np.mean((found.frames[1] - still)[4:-4, 4:-4] ** 2)) < 0.009  # of noise 0.0057


def test_a_sharp_frame_and_a_blurred_one_are_aligned():
    found = align([frame(22, (0.25, 0.25)), frame(22, (4.0, 4.0), **HAND)])  # a blur radius of 8 pixels
    assert left_over(found, **HAND) < 3.0 * found.errors[1] < 0.06  # 0.14 with the blur as it is


def test_blurs_that_near_and_far_parts_exchange_leave_no_shift():
    found = align([frame(22, (0.25, 4.0)), frame(22, (4.0, 0.25), **HAND)])
    assert left_over(found, **HAND) < min(0.1, 3.0 * found.errors[1])
    assert found.reliable


def test_aligned_frames_keep_most_of_their_noise():
    first = frame(1, (0.5, 1.5))
    little, much = (align([first, frame(1, (1.5, 0.5), noise=noise, **HAND)]) for noise in (0.004, 0.02))
    noise = [found.frames[1][6:200, 6:260] for found in (little, much)]  # the same noise, of two sizes
    assert 0.9 < np.std(noise[1] - noise[0]) / 0.016 < 1.0  # cubic splines leave 0.875


@pytest.mark.parametrize("seed", range(10))
def test_errors_contain_what_is_left(seed):
    rng = np.random.default_rng(seed)
    hand = {
        "shift": complex(*rng.uniform(-10, 10, 2)),
        "scale": rng.uniform(0.99, 1.01),
        "angle": rng.normal(0.0, 3e-3),
    }
    found = align([frame(10 + seed, (0.5, 1.5)), frame(10 + seed, (1.5, 0.5), noise=0.02, **hand)])
    assert left_over(found, **hand) < 2.5 * found.errors[1]
    assert found.errors[1] < 0.2


def test_a_burst_in_colour_keeps_its_channels_and_is_cropped_to_what_all_show():
    hands = [{"shift": 3.0 + 4.0j}, {"shift": -5.0 - 2.0j}]
    frames = [
        np.stack([one, 2 * one, 3 * one], axis=-1)
        for one in (frame(2, (1, 1)), *(frame(2, (1, 1), **h) for h in hands))
    ]
    found = align(frames)
    assert found.frames[2].shape[2] == 3
    assert np.allclose(found.frames[2][..., 2], 3 * found.frames[2][..., 0])
    rows, columns = found.crop
    # The first moved by 3 to the right and 4 down, the second by 5 to the left and 2 up.
    assert 2 <= rows.start <= 4
    assert SHAPE[0] - 7 <= rows.stop <= SHAPE[0] - 4
    assert 5 <= columns.start <= 8
    assert SHAPE[1] - 6 <= columns.stop <= SHAPE[1] - 3
    assert found.to_dict()["crop"] == [[rows.start, rows.stop], [columns.start, columns.stop]]


def test_parallax_is_told():
    first, other = frame(3, (1, 1)), frame(3, (1, 1), shift=2.0 + 1.0j)
    other[:, : SHAPE[1] // 2] = frame(3, (1, 1), shift=4.0 + 1.0j)[:, : SHAPE[1] // 2]  # a near half
    found = align([first, other])
    assert not found.reliable
    assert found.to_dict()["reliable"] is False
    assert "frame 1 moved otherwise" in found.notes[0]
    other[:, : SHAPE[1] // 2] = frame(3, (1, 1), shift=2.5 + 1.0j)[:, : SHAPE[1] // 2]
    assert align([first, frame(3, (1, 1), shift=2.0 + 1.0j)]).misfits[1] < 0.1 < align([first, other]).misfits[1]


@pytest.mark.parametrize(
    ("frames", "message"),
    [
        (lambda: [frame(1, (1, 1)), frame(9, (1, 1))], r"frames\[1\] cannot be aligned with the first frame"),
        (lambda: [np.random.default_rng(k).normal(size=SHAPE) for k in (1, 2)], r"frames\[1\] (cannot be|shows)"),
        (lambda: [np.ones(SHAPE), np.ones(SHAPE)], r"frames\[1\] cannot be aligned"),
        (lambda: [np.ones((99, 200))] * 2, "at least 192 pixels a side"),
        (lambda: [np.ones(SHAPE)], "two or more of one shape"),
        (lambda: [np.ones(SHAPE), np.ones((299, 299))], "two or more of one shape"),
        (lambda: [np.ones(SHAPE), np.full(SHAPE, np.nan)], r"frames\[1\] must be finite"),
    ],
)
def test_what_cannot_be_aligned_is_refused(frames, message):
    with pytest.raises(ValueError, match=message):
        align(frames())


def test_the_command_writes_aligned_photos(tmp_path):
    hand = {"shift": 4.0 - 3.0j}
    for name, image in (("near", frame(4, (0.5, 1.5))), ("far", frame(4, (1.5, 0.5), **hand))):
        write_photo(tmp_path / f"{name}.png", np.clip(image, 0.0, 1.0), dtype=np.uint16)
    photos = [tmp_path / "near.png", tmp_path / "far.png"]
    outputs = ["-o", tmp_path / "a.png", "-o", tmp_path / "b.tif"]
    facts = json.loads(lommel("align", *photos, *outputs, "--json").stdout)
    assert facts["shifts"][1] == pytest.approx([-3.0, 4.0], abs=0.2)
    sides = [side[1] - side[0] for side in facts["crop"]]
    assert [list(read_photo(tmp_path / name).values.shape) for name in ("a.png", "b.tif")] == [sides, sides]
    assert "--output must be given for each of the 2 photos, got 1" in lommel("align", *photos, *outputs[:2]).stderr
