"""`lommel watch`, on video that continuous scenes make, rendered without this package."""

from __future__ import annotations

import csv
import json
import math
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import Mock

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage

pytest.importorskip("av", reason="video needs PyAV: pip install av")

import lommel as lm
from lommel.base.encoding import from_light, to_light
from lommel.cli import video_coding, video_commands
from lommel.cli.instruments import FrameNoise
from lommel.io import videos
from scenes import ThinLens, lommel_lens, plane, record, texture
from slanted_edges import gaussian, picture
from video_files import frames_of, write_video

LENS = """
[lens]
focal_length = "35 mm"
f_number = 8.0
wavelength = "540 nm"
[sensor]
pixel = "4 um"
"""
SIDE, LIGHT, WHITE = 112, 5000.0, 12_000.0
PAIR = [ThinLens(35e-3, 8.0, focus, 540e-9, 4e-6) for focus in (1.35, 1.8)]
DISTANCES = [1.35, 1.5, 1.7]
SCENE = ["lens.toml", "--focus", "1.35 m", "--focus", "1.8 m", "--between", "1.2 m", "2 m"]
DEEP = ["--white", 65535, "--read", 3]
STATED = ["--white", WHITE, "--read", 3]


@cache
def recorded(distance: float) -> list[np.ndarray]:
    """A pair of frames, 1 electron a count."""
    return record(plane(texture("leaves", SIDE, seed=7), PAIR, distance, LIGHT), int(1e3 * distance), offset=0.0)


def shots() -> list[np.ndarray]:
    """Frames of one focus and the other in turn."""
    return [frame for distance in DISTANCES for frame in recorded(distance)]


def steady() -> list[np.ndarray]:
    """Frames of one focus and the other in turn, of scenes that are there for two pairs each."""
    return [frame for distance in DISTANCES for frame in recorded(distance) * 2]


def eight_bits(frames: list[np.ndarray]) -> list[np.ndarray]:
    return [from_light(np.minimum(frame / WHITE, 1.0), "srgb", np.uint8) for frame in frames]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "lens.toml").write_text(LENS, encoding="utf-8")
    write_video(tmp_path / "near.mkv", shots()[0::2])
    write_video(tmp_path / "far.mkv", shots()[1::2])
    return tmp_path


TWO = ["--source", "near.mkv", "--source", "far.mkv"]


class Kept(dict):
    """Tables that tests share."""

    def __call__(self, lenses: list[lm.Lens], pixel: float, **options: object) -> lm.imaging.LiveDepth:
        key = repr((lenses, pixel, sorted(options.items())))
        if key not in self:
            self[key] = lm.imaging.LiveDepth(lenses, pixel, light=LIGHT, **options)
        return self[key]


TABLES = Kept()


@pytest.fixture(autouse=True)
def tables(monkeypatch: pytest.MonkeyPatch) -> None:
    """Make the tables of one level of light, once, and open no window."""
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(video_commands, "LiveDepth", TABLES)


def rows(path: Path) -> list[dict[str, float]]:
    with path.open(encoding="utf-8") as file:
        return [{name: float(text or "nan") for name, text in row.items()} for row in csv.DictReader(file)]


def test_depth_of_video_is_within_its_standard_error_in_every_output(folder, call_lommel):
    result = call_lommel(
        "watch", *SCENE, *DEEP, *TWO, "--sharp", "-o", "out.mkv", "--depth", "depth.mkv", "--depth", "error.mkv",
        "--table", "found.csv", folder=folder,
    )  # fmt: skip
    assert result.returncode == 0, result.stderr
    lines = result.stdout.splitlines()
    assert lines[-4:] == [f"wrote {name}" for name in ("out.mkv", "depth.mkv", "error.mkv", "found.csv")]
    (depth, times), (errors, _) = frames_of(folder / "depth.mkv"), frames_of(folder / "error.mkv")
    assert depth.shape == (3, SIDE // 4, SIDE // 4)
    assert times == pytest.approx([0.0, 0.04, 0.08])
    known = depth > 0
    assert np.array_equal(known, errors > 0)
    for levels, seconds in lm.io.video_frames(str(folder / "depth.mkv")):  # as the page about it says
        assert np.array_equal(levels, depth[times.index(seconds)])
    table = rows(folder / "found.csv")
    for k, distance in enumerate(DISTANCES):
        metres, error = 1e-4 * depth[k][known[k]], 1e-4 * errors[k][known[k]]
        z = (metres - distance) / error
        assert abs(np.median(z)) < 0.6
        assert np.median(np.abs(z)) / 0.6745 == pytest.approx(1.0, abs=0.35)
        row = table[k]
        assert row["time (s)"] == pytest.approx(times[k])
        assert row["known"] == pytest.approx(known[k].mean(), abs=1e-4)
        assert row["depth (m)"] == pytest.approx(np.median(metres), abs=1e-4)
        assert row["error (m)"] == pytest.approx(np.median(error), abs=1e-4)
        assert row["misfit"] == pytest.approx(1.0, abs=0.2)
        assert row["frame time (s)"] > 0.0
        assert row["dropped"] == 0


def test_dropped_frames_of_alternating_video_are_counted_and_move_no_pair(folder, call_lommel):
    shown = recorded(1.5) * 6
    kept = [k for k in range(12) if k not in (5, 8)]
    write_video(folder / "both.mkv", [shown[k] for k in kept], 0.02 * np.array(kept), rate=50)
    options = ["--source", "both.mkv", "--alternating", "--table", "found.csv"]
    result = call_lommel("watch", *SCENE, *DEEP, *options, folder=folder)
    assert re.search(r"frames dropped +2\nframes without a partner +2\n", result.stdout)
    table = rows(folder / "found.csv")
    assert [row["depth (m)"] for row in table] == pytest.approx([1.5] * 4, abs=0.02)
    assert [row["dropped"] for row in table] == [0, 0, 1, 2]


@pytest.mark.parametrize("codec", ["ffv1", "libx264"])
def test_the_noise_of_8_bit_srgb_is_said_to_be_a_guess_and_what_is_stated_is_used(codec, folder, call_lommel):
    lossless = codec == "ffv1"
    options = {} if lossless else {"crf": "4"}
    write_video(
        folder / "both.mkv", eight_bits(steady()), codec=codec, stored="gray" if lossless else "yuv420p", **options
    )
    source = ["--source", "both.mkv", "--alternating"]
    result = call_lommel("watch", *SCENE, *STATED, *source, "--table", "found.csv", folder=folder)
    guess = "The noise of 8-bit sRGB values is a guess, because cameras denoise and compress them: 12000 electrons"
    told = " ".join(result.stdout.split())
    assert guess in told
    assert "read noise 3 electrons (as stated), and rounding." in told
    for row, distance in zip(rows(folder / "found.csv")[1::2], DISTANCES, strict=True):
        assert abs(row["depth (m)"] - distance) < (0.6 if lossless else 1.5) * row["error (m)"]
        assert row["misfit"] == pytest.approx(1.0, abs=0.15) if lossless else row["misfit"] < 1.5
    if lossless:
        found = json.loads(call_lommel("watch", *SCENE, *source, "--read", 2, "--json", folder=folder).stdout)
        assert (found["white"], found["read_noise"], found["assumed"]) == (5000.0, 2.0, ["--white"])


def test_depth_of_compressed_video_is_right_within_larger_errors_or_not_known(folder, call_lommel):
    options = ["--source", "both.mkv", "--alternating", "--json", "--depth", "d.mkv", "--depth", "s.mkv"]
    found = []
    for coded in ({"crf": "4"}, {"crf": "18"}, {"qmin": "1", "qmax": "1"}, {"qmin": "12", "qmax": "12"}):
        form = ("libx264", "yuv420p") if "crf" in coded else ("mjpeg", "yuvj420p")
        write_video(folder / "both.mkv", eight_bits(steady()), codec=form[0], stored=form[1], **coded)
        result = call_lommel("watch", *SCENE, *STATED, *options, folder=folder)
        found.append(json.loads(result.stdout))
        depth, errors = (1e-4 * frames_of(folder / name)[0] for name in ("d.mkv", "s.mkv"))
        if depth.any():
            z = (depth - np.repeat(DISTANCES, 2)[:, None, None]) / np.maximum(errors, 1e-6)
            assert (np.abs(z[depth > 0]) > 3.0).sum() <= 0.01 * depth.size
        assert (result.returncode == 3) is not depth.any()
    assert found[1]["unknown"]["compressed"] == found[3]["unknown"]["compressed"] == 1.0
    assert found[2]["known"] > 0.5  # quantization near the noise is a part of the noise
    assert "and removes fainter texture; above 32 times" in found[3]["notes"][1]


def test_the_limit_of_misfit_counts_what_compression_adds(tmp_path):
    for number, frame in enumerate(eight_bits(recorded(1.5)), start=1):
        Image.fromarray(frame).save(tmp_path / f"{number}.jpg", quality=90)
    coding = video_coding.coding_of(256, np.dtype(np.uint8), "srgb", FrameNoise(white=WHITE, read=3.0), None, None)
    given = {"noise": coding.noise, "saturation": coding.saturation, "shape": (SIDE, SIDE), "exposures": "smooth"}
    live = TABLES([lommel_lens(lens) for lens in PAIR], 4e-6, between=(1.2, 2.0), **given)
    estimator = video_commands.Estimator(live, coding, 1.1, sharp=False)
    with videos.frame_pairs(tmp_path / "%d.jpg") as pairs:
        pair = next(pairs)
        result = estimator(pair, pairs.loss)
        known = np.isfinite(result.depth)
        assert np.abs((result.depth - 1.5) / result.errors)[known].max() < 3.0
        without = estimator(pair)
    # The median misfit is 1.2, of a loss of 12 times the noise.
    assert result.unknown["misfit"] < 0.01
    assert without.unknown["misfit"] > 0.4


def test_what_moves_and_narrow_bands_have_no_depth_and_their_shares_are_stated(folder, call_lommel):
    lamps, moves = [], []
    for k, frame in enumerate(recorded(1.5) * 3):
        bands = 1.0 + 0.1 * np.sin(2.0 * np.pi * (np.arange(SIDE) / 14.0 + 0.37 * k))[:, None]
        lamps.append(np.rint(frame * bands).astype(np.uint16))
        moves.append(frame.copy())
        moves[-1][:, :56] = np.roll(frame, k, axis=1)[:, :56]  # a pixel a frame
    for frames, cause in ((lamps, "bands"), (moves, "moved")):
        write_video(folder / "both.mkv", frames)
        words = ["watch", *SCENE, *DEEP, "--source", "both.mkv", "--alternating", "--depth", "d.mkv"]
        result = call_lommel(*words, "--json", folder=folder)
        shares = json.loads(result.stdout)["unknown"]
        depth = frames_of(folder / "d.mkv")[0][1:]  # the first pair has no earlier frame
        if cause == "bands":
            assert not depth.any()
        else:
            assert not depth[:, :, :14].any()
            assert (depth[:, 3:-3, 18:-4] > 0).mean() > 0.8
        assert shares[cause] > 0.25
        assert set(shares) <= {"moved", "bands", "misfit", "border", "flat", "ambiguous"}
    assert re.search(r"\nunknown +.*moved [\d.]+ %", call_lommel(*words, folder=folder).stdout)


def test_blocks_that_do_not_fit_are_not_known_and_counted(folder, call_lommel):
    frames = [np.roll(frame, 2 * (k % 2), axis=1) for k, frame in enumerate(steady())]  # as of registration
    write_video(folder / "both.mkv", frames)
    words = ["watch", *SCENE, *DEEP, "--source", "both.mkv", "--alternating", "--depth", "d.mkv", "--table", "t.csv"]
    result = call_lommel(*words, folder=folder)
    assert "not known for a misfit above 2 (--misfit): " in result.stdout
    assert "(--magnification lens)" in result.stdout
    assert "the images differ by more than noise (misfit " in result.stdout
    known = [(values > 0).mean() for values in frames_of(folder / "d.mkv")[0]]
    table = rows(folder / "t.csv")
    assert [row["known"] for row in table] == pytest.approx(known, abs=1e-5)
    assert all(row["unfit"] > 0.2 and row["misfit"] > 4.0 for row in table[1::2])
    found = json.loads(call_lommel(*words, "--misfit", "inf", "--json", folder=folder).stdout)
    assert found["unfit"] == 0.0
    assert [row["known"] for row in rows(folder / "t.csv")[1::2]] == [row["unfit"] for row in table[1::2]]
    result = call_lommel(*words, "--magnification", "lens", "--json", folder=folder)
    assert json.loads(result.stdout)["magnification"] == "lens"
    assert "(--magnification lens)" not in result.stdout


def test_frames_shifted_by_a_pixel_fail_the_verdict_which_is_not_only_of_blocks_that_passed(folder, call_lommel):
    near, far = recorded(1.5)
    write_video(folder / "near.mkv", [near])
    write_video(folder / "far.mkv", [np.roll(far, 1, axis=0)])
    result = call_lommel("watch", *SCENE, *DEEP, *TWO, "--json", folder=folder)
    found = json.loads(result.stdout)
    assert result.returncode == 3
    assert found["unfit"] > 0.3
    assert next(finding for finding in found["findings"] if finding["code"] == "misfit")["numbers"]["misfit"] > 2.0


def test_brightness_that_rolls_over_the_frames_moves_no_depth(folder, call_lommel, monkeypatch):
    ramp = 1.0 + 0.04 * np.sin(np.linspace(0.0, 12.0, SIDE))[:, None]
    frames = [np.rint(frame * (ramp if k % 2 else ramp[::-1])).astype(np.uint16) for k, frame in enumerate(steady())]
    write_video(folder / "both.mkv", frames)
    words = ["watch", *SCENE, *DEEP, "--source", "both.mkv", "--alternating", "--depth", "d.mkv", "--depth", "s.mkv"]
    scatter = []
    for equalize, status in ((video_commands.equalize_rows, 0), (lambda *given: given[:2], 3)):
        monkeypatch.setattr(video_commands, "equalize_rows", equalize)
        assert call_lommel(*words, folder=folder).returncode == status
        depth, errors = (1e-4 * frames_of(folder / name)[0][1::2] for name in ("d.mkv", "s.mkv"))
        z = [
            (one - distance)[one > 0] / error[one > 0]
            for one, error, distance in zip(depth, errors, DISTANCES, strict=True)
        ]
        scatter.append(1.4826 * np.median(np.abs(np.concatenate(z))))
    assert scatter[0] < 1.15 < scatter[1]


def test_rows_of_text_stay_as_they_are_and_bands_of_light_are_made_even():
    page = np.where(np.arange(8 * SIDE)[:, None] // 8 % 14 < 8, texture("text", SIDE, seed=3), 1.3)
    options = {"noise": lm.Noise(white=1.0, read=3.0), "shape": (SIDE, SIDE), "exposures": "smooth"}
    live = TABLES([lommel_lens(lens) for lens in PAIR], 4e-6, between=(1.2, 2.0), **options)
    coding = video_coding.coding_of(
        65536, np.dtype(np.uint16), "linear", FrameNoise(white=65535.0, read=3.0), None, None
    )
    estimator = video_commands.Estimator(live, coding, math.inf, sharp=False)
    lamp = 1.0 + 0.1 * np.sin(np.arange(SIDE) / 9.0)[:, None]
    for distance, light, even in ((1.35, 1.0, False), (1.5, lamp, True), (1.5, lamp, True)):
        near, far = record(plane(page, PAIR, distance, LIGHT), 5, offset=0.0)
        second = np.rint(far * light).astype(np.uint16)
        result = estimator(SimpleNamespace(time=0.0, first=near, second=second))
        assert estimator.evens == even
        # Of the text, evened, depth is off by 4 standard errors.
        assert abs(np.nanmedian((result.depth - distance) / result.errors)) < (1.0 if even else 0.5)
    # Even rows of text are not those recorded, and their difference is no noise.
    near, far = record(plane(page, PAIR, 1.35, LIGHT), 5, offset=0.0)
    live = TABLES([lommel_lens(lens) for lens in PAIR], 4e-6, between=(1.2, 2.0), **options | {"noise": None})
    estimator = video_commands.Estimator(live, coding, math.inf, sharp=False)
    estimator(SimpleNamespace(time=0.0, first=near, second=far))
    assert not estimator.evens
    assert live.noise.white == pytest.approx(1.0, rel=0.2)


@pytest.mark.parametrize("kind", [np.uint16, np.float32])
def test_frames_are_made_even_in_brightness_row_by_row(kind):
    given = FrameNoise(white=65535.0, read=3.0, offset=100 / 65535)
    coding = video_coding.coding_of(65536 if kind == np.uint16 else 0, np.dtype(kind), "linear", given, None, None)
    scale = 1.0 if kind == np.uint16 else 65535.0
    draw = np.random.default_rng(0)
    first = draw.uniform(2000.0, 4000.0, (120, 200))
    second = first * (1.0 + 0.1 * np.sin(2.0 * np.pi / 60.0 * np.arange(120)))[:, None]  # mains flicker
    first[60, 50], second[30, 20] = 66_000.0, np.nan
    first[:10], second[:10] = 3.0, 1.0  # dark rows have no ratio
    frames = [((each + 100.0) / scale).clip(0, 65535 / scale) for each in (first, second)]
    if kind == np.uint16:
        frames = [np.nan_to_num(each, nan=65535.0) for each in frames]
    even = video_commands.equalize_rows(*(each.astype(kind) for each in frames), coding)
    light = [each * scale - 100.0 for each in even]
    assert np.isnan(light[1][60, 50]) if kind == np.uint16 else light[1][60, 50] > 1000.0
    assert np.isnan(light[0][30, 20])
    assert light[0][40, 0] == pytest.approx(first[40, 0], abs=1.0)
    ratio = (light[1] / light[0])[24:]
    assert np.nanstd(ratio) < 0.009 < 0.06 < np.nanstd((second / first)[24:])
    assert light[1][0] == pytest.approx(1.0, abs=0.6)


def test_a_block_is_known_up_to_the_largest_misfit_and_a_pixel_below_saturation(monkeypatch):
    depth, errors = np.array([[1.0, 2.0, 3.0, 4.0]]), np.array([[0.1, 0.2, 0.3, np.inf]])
    found = SimpleNamespace(depth=depth, errors=errors, misfit=np.array([[1.0, 2.0, 2.001, 1.0]]), light=9.0)
    noise = lm.Noise(white=1.0, read=0.0, offset=10.0)
    coding = video_coding.Coding("linear", 0, 1.0, noise, 110.0, "", {})
    frame = np.full((40, 3), 50.0)
    frame[20] = 109.9, 110.0, 10.0
    assert np.isnan(video_commands.equalize_rows(frame, frame, coding)[1][20]).tolist() == [False, True, False]
    live = Mock(return_value=found, noise=lm.Noise(white=2.0, read=0.0, offset=10.0), binning=(2, 1))
    live.aliases.return_value = np.zeros((1, 4))
    estimator = video_commands.Estimator(live, coding, 2.0, sharp=False)
    frame = np.full((4, 16), 50.0)
    result = estimator(SimpleNamespace(time=5.0, first=frame, second=frame))
    np.testing.assert_array_equal(result.depth, [[1.0, 2.0, np.nan, np.nan]])
    np.testing.assert_array_equal(result.errors, [[0.1, 0.2, np.inf, np.inf]])
    assert result.unknown == {"compressed": 0.0, "misfit": 0.25, "border": 0.0, "flat": 0.25, "ambiguous": 0.0}
    assert result.numbers == pytest.approx((0.5, 0.25, 1.5, 0.15, 2.0))
    # The verdict, which takes these arrays, is on blocks with a misfit as well.
    np.testing.assert_array_equal(found.errors, [[0.1, 0.2, 0.3, np.inf]])
    # The misfit that aliases of the binned pixels of a block add raises its limit.
    for added, known in (([0.0, 0.0, 0.01, 0.0], True), ([9.0, 9.0, 0.0, 9.0], False)):
        live.aliases.return_value = np.array([added])
        result = estimator(SimpleNamespace(time=5.0, first=frame, second=frame))
        assert np.isfinite(result.depth).tolist() == [[True, True, known, False]]


def test_pairs_are_summarised():
    def pair(depth, duration=0.0, known=0.5):
        return video_commands.PairResult(2.0, duration, numbers=(known, 0.25, depth, 0.01, 1.5))

    tally = video_commands.Tally(start=0.0, stop=2.0)
    tally.add(pair(2.0))
    for k in range(1, 41):
        tally.add(pair(2.0 + 0.01 * k, 0.1 * k))
    tally.add(pair(math.nan, 4.1, known=0.0))
    assert "misfit" not in tally.progress(0)
    tally.add(pair(2.5, 4.2, known=0.25))
    assert tally.progress(0).endswith("; 25 % 2.5 m +- 10 mm, misfit 1.50")
    counts = SimpleNamespace(interval=0.1, dropped=0, alone=0, refused=0)
    found = tally.summary(counts, "the end")
    assert found["frame_time"] == pytest.approx({"median": 2.1, "95 %": 3.99})
    assert (found["known"], found["unfit"]) == (pytest.approx((41 * 0.5 + 0.25) / 43), 0.25)
    assert (found["depth"], found["error"], found["misfit"]) == pytest.approx((2.205, 0.01, 1.5))


def test_pixels_at_white_are_full_in_srgb_too(folder, call_lommel):
    frames = eight_bits(shots())
    for frame in frames:
        frame[40:52, 40:52] = 255
    write_video(folder / "both.mkv", frames)
    words = ["watch", *SCENE, *STATED, "--source", "both.mkv", "--alternating", "--depth", "d.mkv"]
    assert call_lommel(*words, folder=folder).returncode == 0
    assert not frames_of(folder / "d.mkv")[0][:, 10:13, 10:13].any()


@pytest.mark.parametrize("encoding", ["srgb", "linear"])
@pytest.mark.parametrize("white", [2000.0, 40_000.0])
def test_noise_of_stored_levels_is_that_of_photons_read_noise_and_rounding(encoding, white):
    draw = np.random.default_rng(0)
    gain, read = video_coding.stored_noise(white, 5.0, 256, encoding)
    for light in (0.1, 0.3, 0.6):
        electrons = draw.poisson(white * np.linspace(light, 1.05 * light, 50_000)) + draw.normal(0.0, 5.0, 50_000)
        stored = from_light(electrons / white, encoding, np.uint8)
        found = to_light("values", stored, encoding, np.float64) - np.linspace(light, 1.05 * light, 50_000)
        assert (light * gain + read**2) / gain**2 == pytest.approx(found.var(), rel=0.12)
    assert video_coding.stored_noise(white, 5.0, 0, encoding) == (white, 5.0)


def test_a_black_frame_is_told_and_counted_and_the_stream_goes_on(folder, call_lommel):
    frames = shots()
    frames[3] = np.zeros_like(frames[3])
    write_video(folder / "far.mkv", frames[1::2])
    result = call_lommel(
        "watch", *SCENE, *DEEP, *TWO, "--table", "found.csv", "-o", "o.mkv", "--depth", "d.mkv", folder=folder
    )
    assert result.returncode == 0
    assert result.stderr.startswith("no depth at 0.04 s: the second frame must hold light, got a mean of 0 electrons")
    assert re.search(r"pairs without depth +1\n", result.stdout)
    table = rows(folder / "found.csv")
    assert [row["known"] > 0.7 for row in table] == [True, False, True]
    assert np.isnan(table[1]["depth (m)"])
    assert not frames_of(folder / "d.mkv")[0][1].any()
    assert np.abs(frames_of(folder / "o.mkv", "rgb24")[0][1, 8 : SIDE - 8, 8 : SIDE - 8].astype(int) - 128).max() < 5


SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]


@pytest.mark.parametrize("sent", SIGNALS)
def test_a_signal_while_a_frame_is_written_leaves_whole_files(sent, folder, call_lommel, monkeypatch):
    write_video(folder / "near.mkv", shots()[0::2] * 20)
    write_video(folder / "far.mkv", shots()[1::2] * 20)
    write, calls = video_commands.Outputs.__call__, []

    def interrupted(self, seen):
        calls.append(seen.time)
        if len(calls) == 4:
            for _ in range(1 if sent == signal.SIGINT else 2):  # a second Ctrl-C does not wait for the frame
                os.kill(os.getpid(), sent)
        return write(self, seen)

    monkeypatch.setattr(video_commands.Outputs, "__call__", interrupted)
    result = call_lommel("watch", *SCENE, *DEEP, *TWO, "-o", "out.mp4", "--table", "found.csv", folder=folder)
    assert result.returncode == 0
    assert re.search(r"ended +interrupted\n", result.stdout)
    assert len(frames_of(folder / "out.mp4")[0]) == len(rows(folder / "found.csv")) == 4
    assert [signal.getsignal(number) for number in SIGNALS] == [signal.default_int_handler, *[signal.SIG_DFL] * 2]


@pytest.mark.parametrize("sent", SIGNALS)
def test_a_signal_before_the_first_frame_leaves_no_file(sent, folder, call_lommel, monkeypatch):
    before = sorted(folder.iterdir())

    def interrupted(*_: object, **__: object) -> None:
        os.kill(os.getpid(), sent)
        raise AssertionError("the command goes on")

    monkeypatch.setattr(video_commands, "LiveDepth", interrupted)
    result = call_lommel("watch", *SCENE, *DEEP, *TWO, "-o", "out.mkv", "--table", "found.csv", folder=folder)
    assert (result.returncode, result.stderr.strip()) == (1, "Aborted!")
    monkeypatch.setattr(video_commands, "LiveDepth", TABLES)
    monkeypatch.setattr(videos.FramePairs, "__next__", interrupted)
    result = call_lommel("watch", *SCENE, *DEEP, *TWO, "-o", "out.mkv", "--table", "found.csv", folder=folder)
    assert (result.returncode, result.stderr.strip()) == (1, "Aborted!")
    assert sorted(folder.iterdir()) == before


def test_nohup_goes_on_when_the_terminal_is_closed(folder, call_lommel, monkeypatch):
    old = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        write = video_commands.Outputs.__call__

        def hung_up(self, seen):
            os.kill(os.getpid(), signal.SIGHUP)
            return write(self, seen)

        monkeypatch.setattr(video_commands.Outputs, "__call__", hung_up)
        result = call_lommel("watch", *SCENE, *DEEP, *TWO, "--table", "found.csv", folder=folder)
    finally:
        signal.signal(signal.SIGHUP, old)
    assert re.search(r"ended +the end\n", result.stdout)
    assert len(rows(folder / "found.csv")) == 3


def test_a_second_ctrl_c_ends_at_once_and_names_what_is_kept(folder, call_lommel, monkeypatch):
    write = video_commands.Outputs.__call__

    def interrupted(self, seen):
        closed = write(self, seen)
        for _ in range(2):
            os.kill(os.getpid(), signal.SIGINT)
        return closed

    monkeypatch.setattr(video_commands.Outputs, "__call__", interrupted)
    result = call_lommel("watch", *SCENE, *DEEP, *TWO, "-o", "out.mkv", "--table", "found.csv", folder=folder)
    assert result.returncode == 1
    kept = ["found.unfinished.csv", "out.unfinished.mkv"]
    assert result.stderr.split("\n") == [
        *(f"Note: {folder / name} keeps what was recorded" for name in kept), "Aborted!", ""
    ]  # fmt: skip
    assert sorted(path.name for path in folder.iterdir()) == ["far.mkv", kept[0], "lens.toml", "near.mkv", kept[1]]
    assert len(frames_of(folder / kept[1])[0]) == len(rows(folder / kept[0])) == 1


@contextmanager
def installed(folder: Path, output: int, terminal: int | None = None) -> Iterator[subprocess.Popen]:
    """The installed command, once it has written two rows; what it writes to the terminal is read."""
    write_video(folder / "both.mkv", eight_bits(shots()) * 700)
    words = [*SCENE, *STATED, "--source", "both.mkv", "--alternating", "-o", "out.mkv", "--depth", "depth.mkv"]
    command = [str(Path(sys.executable).with_name("lommel")), "watch", *map(str, words), "--table", "found.csv"]
    environment = os.environ | {"COLUMNS": "200"}
    process = subprocess.Popen(command, cwd=folder, stdout=output, stderr=output, text=True, env=environment)
    try:
        for _ in range(6000):
            table = folder / "found.unfinished.csv"
            if process.poll() is not None or (table.exists() and table.read_text().count("\n") > 2):
                break
            if terminal is not None:
                with suppress(BlockingIOError):
                    os.read(terminal, 4096)
            time.sleep(0.01)
        yield process
    finally:
        process.kill()


def whole_files(folder: Path) -> None:
    pictures, depths = frames_of(folder / "out.mkv")[0], frames_of(folder / "depth.mkv")[0]
    assert 2 <= len(pictures) == len(depths) == len(rows(folder / "found.csv")) < 2100
    names = sorted(path.name for path in folder.iterdir())
    assert names == ["both.mkv", "depth.mkv", "far.mkv", "found.csv", "lens.toml", "near.mkv", "out.mkv"]


def test_a_terminal_that_is_closed_leaves_files_that_play(folder):
    own, other = os.openpty()
    os.set_blocking(own, False)
    with installed(folder, other, own) as process:
        os.close(other)
        os.close(own)
        process.send_signal(signal.SIGHUP)  # as the kernel does for the process group of a terminal
        assert process.wait(60) == 0
    whole_files(folder)


def test_a_killed_process_leaves_all_rows_and_all_frames_but_the_last(folder):
    with installed(folder, subprocess.DEVNULL) as process:
        time.sleep(np.random.default_rng(0).uniform(0.0, 0.5))
        process.kill()
        assert process.wait(60) == -signal.SIGKILL
    text = (folder / "found.unfinished.csv").read_text(encoding="utf-8")
    assert text.endswith("\n")
    table = rows(folder / "found.unfinished.csv")
    assert len(table) >= 2
    for name in ("out", "depth"):
        with videos.video_frames(folder / f"{name}.unfinished.mkv") as video:
            times = [frame.time for frame in video]
        assert len(table) - len(times) in (1, 2)  # a row is written before the frames
        assert times == pytest.approx([row["time (s)"] for row in table[: len(times)]], abs=1e-3)
    assert not (folder / "out.mkv").exists()


def test_a_camera_that_is_unplugged_ends_with_what_was_written_and_exit_code_3(folder, call_lommel, monkeypatch):
    write, written = video_commands.Outputs.__call__, []

    class Camera:
        live, levels, grey, interval = True, 256, False, 0.005

        def __init__(self, number: int, grey: bool, tell: object) -> None:
            self.name, (self.frame,) = f"camera {number}", eight_bits([recorded(1.5)[number]])

        def frames(self):
            while len(written) < 3:
                yield videos.VideoFrame(self.frame, time.monotonic())
                time.sleep(0.005)
            raise videos.VideoError(f"{self.name} gives no more frames: it was unplugged, or stopped")

        def close(self) -> None:
            pass

    def counted(self, seen):
        written.append(seen)
        return write(self, seen)

    monkeypatch.setattr(video_commands.Outputs, "__call__", counted)
    monkeypatch.setattr(videos, "_CameraReader", Camera)
    result = call_lommel("watch", *SCENE, *STATED, "--source", 0, "--source", 1, "-o", "out.mkv", folder=folder)
    assert result.returncode == 3
    assert "gives no more frames: it was unplugged, or stopped" in result.stderr
    assert re.search(r"ended +camera . gives no more frames", result.stdout)
    assert len(frames_of(folder / "out.mkv")[0]) == len(written) >= 3


@pytest.mark.parametrize("linear", [False, True])
def test_the_noise_of_video_is_estimated_from_its_first_pair_and_told(linear, folder, call_lommel):
    write_video(
        folder / "both.mkv", steady() if linear else eight_bits(steady()), stored="gray16le" if linear else "gray"
    )
    source = ["--source", "both.mkv", "--alternating", "--table", "found.csv", "--json"]
    result = call_lommel("watch", *SCENE, *source, folder=folder)
    assert result.returncode == 0, result.stderr
    found = json.loads(result.stdout)
    assert (found["white"], found["noise_is_a_guess"]) == (pytest.approx(65535 if linear else WHITE, rel=0.15), False)
    (note,) = (finding for finding in found["findings"] if finding["code"] == "estimated_noise")
    assert (note["numbers"]["white"], note["numbers"]["read"]) == (found["white"], found["read_noise"])
    assert f"white {found['white']:.4g}, read noise {found['read_noise']:.3g} electrons" in note["text"]
    for row, distance in zip(rows(folder / "found.csv")[1::2], DISTANCES, strict=True):
        assert abs(row["depth (m)"] - distance) < 0.6 * row["error (m)"]
        assert row["misfit"] == pytest.approx(1.0, abs=0.15)


def test_sharpness_is_that_of_the_edge_in_the_middle_and_the_sharpest_frame_is_named(tmp_path, call_lommel):
    sigmas = [1.6, 1.1, 0.7, 1.0]
    rng = np.random.default_rng(3)
    frames = [25.0 + 200.0 * picture(6.0, sigma, (80, 96), 4) + rng.normal(0.0, 1.5, (80, 96)) for sigma in sigmas]
    write_video(tmp_path / "edge.mkv", [frame.round().astype(np.uint8) for frame in frames])
    result = call_lommel(
        "watch", "--sharpness", "--source", "edge.mkv", "--encoding", "linear", "--pixel", "4um", "--table", "f.csv",
        "--json", folder=tmp_path,
    )  # fmt: skip
    assert result.returncode == 0, result.stderr
    facts = json.loads(result.stdout)
    assert facts["frames"] == facts["measured"] == 4
    assert facts["sharpest_at"] == pytest.approx(2 / 25, abs=1e-3)
    f = np.linspace(0.05, 0.5, 200)
    halves = [np.interp(0.5, gaussian(f, np.radians(6.0), sigma)[::-1], f[::-1]) for sigma in sigmas]
    rows = np.loadtxt(tmp_path / "f.csv", delimiter=",", skiprows=1, usecols=(0, 1, 2))
    np.testing.assert_allclose(rows[:, 1], halves, rtol=0.03)
    assert facts["mtf50"] == pytest.approx(rows[2, 1] / 4e-6, rel=1e-4)
    assert "MTF50" in result.stderr


def test_sharpness_in_doubt_is_in_the_table_and_the_exit_status_and_not_the_best(tmp_path, call_lommel):
    # Without noise the response is in doubt, as that of a denoised picture.
    frames = [25.0 + 200.0 * picture(6.0, sigma, (80, 96), 4) for sigma in (1.6, 1.1, 0.7)]
    frames[0] += np.random.default_rng(3).normal(0.0, 1.5, frames[0].shape)
    write_video(tmp_path / "edge.mkv", [frame.round().astype(np.uint8) for frame in frames])
    result = call_lommel(
        "watch", "--sharpness", "--source", "edge.mkv", "--encoding", "linear", "--table", "f.csv", "--json",
        folder=tmp_path,
    )  # fmt: skip
    facts = json.loads(result.stdout)
    assert (result.returncode, facts["reliable"], facts["sharpest_at"]) == (4, False, 0.0), result.stdout
    (doubt,) = (finding for finding in facts["findings"] if finding["severity"] == "doubt")
    assert (doubt["code"], doubt["numbers"]["frames"], doubt["numbers"]["of"]) == ("too_quiet", 2, 3)
    codes = [line.split(",")[3] for line in (tmp_path / "f.csv").read_text().splitlines()[1:]]
    assert ["too_quiet" in each for each in codes] == [False, True, True]


def test_sharpness_is_in_doubt_if_each_frame_is_for_another_cause(tmp_path, call_lommel):
    quiet, noisy = (25.0 + 200.0 * picture(6.0, sigma, (80, 96), 4) for sigma in (1.6, 0.9))
    noisy += np.random.default_rng(3).normal(0.0, 1.5, noisy.shape)
    sharpened = (3.0 * noisy - 2.0 * ndimage.gaussian_filter(noisy, 1.0)).clip(0.0, 250.0)
    write_video(tmp_path / "edge.mkv", [frame.round().astype(np.uint8) for frame in (quiet, sharpened)])
    result = call_lommel(
        "watch", "--sharpness", "--source", "edge.mkv", "--encoding", "linear", "--json", folder=tmp_path
    )
    facts = json.loads(result.stdout)
    assert (result.returncode, facts["findings"][0]["severity"]) == (4, "doubt"), result.stdout


def test_sharpness_above_nyquist_is_the_best_and_its_limit_is_listed(tmp_path, call_lommel):
    rng = np.random.default_rng(4)
    frames = [
        25.0 + 200.0 * picture(6.0, sigma, (80, 96), 4) + rng.normal(0.0, 1.5, (80, 96)) for sigma in (0.9, 0.2)
    ]
    write_video(tmp_path / "edge.mkv", [frame.round().astype(np.uint8) for frame in frames])
    result = call_lommel(
        "watch", "--sharpness", "--source", "edge.mkv", "--encoding", "linear", "--json", folder=tmp_path
    )
    facts = json.loads(result.stdout)
    assert (facts["mtf50_px"], facts["mtf50_px_above"], facts["last_px_above"]) == (None, 0.5, 0.5), result.stdout
    assert facts["sharpest_at"] == pytest.approx(1 / 25, abs=1e-3)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--sharpness", "--source", "a", "--source", "b"], "--sharpness is of one --source, got a second --source"),
        (["--sharpness", "--source", "a", "--between", "1m", "2m"], "--sharpness is of one --source, got --between"),
        (["--source", "a", "--source", "b"], "LENS is missing"),
        (["lens.toml", "--source", "a", "--source", "b"], "--between is missing"),
    ],
)
def test_depth_and_sharpness_have_their_own_options(words, message, tmp_path, call_lommel):
    result = call_lommel("watch", *words, folder=tmp_path)
    assert result.returncode == 2
    assert message in result.stderr
