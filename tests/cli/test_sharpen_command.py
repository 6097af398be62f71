"""`lommel sharpen`, on video and photos that continuous scenes make, rendered without this package."""

from __future__ import annotations

import json
import os
import re
import signal
from functools import cache
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("av", reason="video needs PyAV: pip install av")

import lommel as lm
from lommel.base import encoding
from lommel.base.encoding import from_light
from lommel.cli import video_commands
from lommel.io import videos
from scenes import ThinLens, averaged, plane, record, texture
from video_files import frames_of, write_video

LENS = """
[lens]
focal_length = "35 mm"
f_number = 8.0
focus_distance = "1.8 m"
wavelength = "540 nm"
[sensor]
pixel = "4 um"
"""
SIDE, LIGHT, WHITE, AT = 96, 5000.0, 12_000.0, 1.5
DEEP = ["--white", 65535, "--read", 3]


@cache
def frames() -> list[np.ndarray]:
    """Frames of a plane, 1 electron a count."""
    (seen,) = plane(texture("leaves", SIDE, seed=7), [ThinLens(35e-3, 8.0, 1.8, 540e-9, 4e-6)], AT, LIGHT)
    return [record([seen], seed, offset=0.0)[0] for seed in range(3)]


def eight_bits(values: np.ndarray) -> np.ndarray:
    return from_light(np.minimum(values / WHITE, 1.0), "srgb", np.uint8)


def off(image: np.ndarray) -> float:
    """Rms difference from the scene, over its mean, away from the border."""
    scene, inner = averaged(texture("leaves", SIDE, seed=7)), slice(16, -16)
    return float(np.std((image / image.mean() - scene / scene.mean())[inner, inner]))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "lens.toml").write_text(LENS, encoding="utf-8")
    write_video(tmp_path / "clip.mkv", frames(), [5.0, 5.04, 5.16])
    return tmp_path


def test_sharp_video_is_nearer_to_the_scene_and_keeps_bits_times_and_light(folder, call_lommel):
    result = call_lommel("sharpen", "clip.mkv", "lens.toml", "--at", "1.5m", *DEEP, "-o", "o.mkv", folder=folder)
    assert result.returncode == 0, result.stderr
    assert re.search(r"frames +3\n", result.stdout)
    assert re.search(r"ended +the end\n", result.stdout)
    assert re.search(r"frames dropped +2\n", result.stdout)
    sharp, times = frames_of(folder / "o.mkv")
    assert sharp.dtype == np.uint16
    assert times == pytest.approx([0.0, 0.04, 0.16])
    for after, before in zip(sharp, frames(), strict=True):
        assert off(after) < 0.75 * off(before)
        assert after.mean() == pytest.approx(before.mean(), rel=0.01)


def test_colour_video_of_8_bits_is_sharpened_in_linear_light(folder, call_lommel):
    colours = [eight_bits(np.stack([share * one for share in (0.5, 1.0, 0.75)], axis=2)) for one in frames()]
    write_video(folder / "clip.mkv", colours, codec="libx264rgb", stored="rgb24", crf="0")
    result = call_lommel("sharpen", "clip.mkv", "lens.toml", "--at", "1.5m", "-o", "o.mp4", "--json", folder=folder)
    found = json.loads(result.stdout)
    assert (found["frames"], found["noise_is_a_guess"], found["assumed"]) == (3, True, ["--white", "--read"])
    assert found["notes"][0].startswith("The noise of 8-bit sRGB values is a guess")
    sharp, _ = frames_of(folder / "o.mp4", "rgb24")
    assert sharp.shape == (3, SIDE, SIDE, 3)
    green = encoding.to_light("o", np.ascontiguousarray(sharp[0, ..., 1]), "srgb", np.float64)
    assert off(green) < 0.9 * off(frames()[0].astype(float))


def test_photos_take_a_depth_map_of_blocks(folder, call_lommel):
    lm.imaging.write_photo(folder / "photo.tif", frames()[0] / 65535.0, encoding="linear", dtype=np.uint16)
    depth = np.full((SIDE // 4, SIDE // 4), AT)
    depth[:2] = np.nan
    lm.imaging.write_depth(folder / "depth.tif", depth)
    words = ["photo.tif", "lens.toml", "--depth", "depth.tif", "--encoding", "linear", *DEEP, "-o", "sharp.tif"]
    result = call_lommel("sharpen", *words, folder=folder)
    assert result.returncode == 0, result.stderr
    assert re.search(r"unknown +8.33 %\n", result.stdout)
    sharp = lm.imaging.read_photo(folder / "sharp.tif", encoding="linear").values
    assert off(sharp.astype(float)) < 0.75 * off(frames()[0].astype(float))


def test_a_file_that_breaks_off_is_told_with_exit_code_3(folder, call_lommel):
    write_video(folder / "clip.mkv", frames() * 20)
    data = (folder / "clip.mkv").read_bytes()
    (folder / "clip.mkv").write_bytes(data[: len(data) // 2])
    result = call_lommel("sharpen", "clip.mkv", "lens.toml", "--at", "1.5m", *DEEP, "-o", "o.mkv", folder=folder)
    assert result.returncode == 3
    assert "breaks off" in result.stderr
    assert 20 < len(frames_of(folder / "o.mkv")[0]) < 40


@pytest.mark.parametrize("sent", [signal.SIGTERM, signal.SIGHUP])
def test_a_signal_leaves_a_whole_file_or_none(sent, folder, call_lommel, monkeypatch):
    write_video(folder / "clip.mkv", frames() * 20)
    before = sorted(folder.iterdir())
    write = videos.VideoWriter.__call__
    words = ["sharpen", "clip.mkv", "lens.toml", "--at", "1.5m", *DEEP, "-o", "o.mkv"]
    with monkeypatch.context() as patch:
        patch.setattr(video_commands, "coding_of", lambda *_, **__: os.kill(os.getpid(), sent))
        assert call_lommel(*words, folder=folder).returncode == 1
    assert sorted(folder.iterdir()) == before

    def interrupted(self, *arguments):
        write(self, *arguments)
        if arguments[1] > 0.1:
            os.kill(os.getpid(), sent)

    monkeypatch.setattr(videos.VideoWriter, "__call__", interrupted)
    result = call_lommel(*words, folder=folder)
    assert result.returncode == 0
    assert re.search(r"frames +4\n", result.stdout)
    assert re.search(r"ended +interrupted\n", result.stdout)
    assert len(frames_of(folder / "o.mkv")[0]) == 4
    assert sorted(folder.iterdir()) == sorted([*before, folder / "o.mkv"])
