"""Live depth in C as a shell meets it: tables from a file, frames from a pipe, maps to another."""

from __future__ import annotations

import os
import shlex
import signal
import subprocess
from pathlib import Path

import numpy as np
import pytest

import lommel as lm
import programs
from scenes import ThinLens, lommel_lens, plane, record, texture

ROOT = Path(__file__).resolve().parents[2]
HEIGHT, WIDTH, LIGHT = 96, 128, 5000.0
LENSES = [ThinLens(35e-3, 8.0, focus, 540e-9, 4e-6) for focus in (1.35, 1.8)]
MAP = HEIGHT // 4, WIDTH // 4
FAILED, WRONG, INCOMPLETE = 1, 2, 3


@pytest.fixture(scope="module")
def program(tmp_path_factory) -> Path:
    """Compile the example by the commands of the page."""
    place = tmp_path_factory.mktemp("pipe")
    for folder in ("cpp", "examples"):
        (place / folder).symlink_to(ROOT / folder)
    page = (ROOT / "docs" / "live-depth.md").read_text(encoding="utf-8").splitlines()
    for compiler, variable in {"cc": "CC", "c++": "CXX"}.items():
        (line,) = (line for line in page if line.startswith(f"{compiler} "))
        command = [*shlex.split(os.environ.get(variable, compiler)), *shlex.split(line)[1:]]
        subprocess.run(command, cwd=place, check=True)
    return place / "live_depth"


@pytest.fixture(scope="module")
def live() -> lm.imaging.LiveDepth:
    return lm.imaging.LiveDepth(
        [lommel_lens(lens) for lens in LENSES], 4e-6, between=(1.2, 2.0), noise=lm.Noise(read=3.0, offset=100.0),
        shape=(HEIGHT, WIDTH), light=LIGHT, sharp=True,
    )  # fmt: skip


@pytest.fixture(scope="module")
def tables(live, tmp_path_factory) -> Path:
    live.save(tmp_path_factory.mktemp("tables") / "lens.lml")
    return tmp_path_factory.getbasetemp() / "tables0" / "lens.lml"


def pair(distance: float, light: float = LIGHT) -> list[np.ndarray]:
    electrons = plane(texture("leaves", WIDTH, seed=7), LENSES, distance, light)
    return [frame[:HEIGHT].copy() for frame in record(electrons, seed=int(1000 * distance))]


@pytest.fixture(scope="module")
def pairs() -> dict[float, list[np.ndarray]]:
    return {distance: pair(distance) for distance in (1.3, 1.5, 1.75)}


def stream(pairs) -> bytes:
    return b"".join(frame.tobytes() for pair in pairs for frame in pair)


def ran(program, tables, frames, *options, size=f"{WIDTH}x{HEIGHT}", code=0, **more):
    """Return what the program wrote, as float32, and what it said."""
    command = [program, tables, size, *options]
    done = subprocess.run(command, input=frames, capture_output=True, check=False, timeout=60, **more)
    said = done.stderr.decode()
    assert done.returncode == code, said
    return np.frombuffer(done.stdout, np.float32), said


def test_maps_are_those_of_the_package_and_as_far_off_as_is_told(program, tables, live, pairs):
    maps, said = ran(program, tables, stream(pairs.values()), "--write", "errors", "--threads", "2")
    maps = maps.reshape(3, 2, *MAP)
    assert said.startswith("3 maps of 32x24 from 6 frames of 128x96: ")
    assert "check" not in said
    z = []
    for (distance, frames), (depth, errors) in zip(pairs.items(), maps, strict=True):
        found = live(*frames)
        np.testing.assert_allclose(depth, found.depth, rtol=1e-4)
        np.testing.assert_allclose(errors, found.errors, rtol=1e-3)
        known = np.isfinite(errors)
        assert known[4:-4, 4:-4].mean() > 0.95
        z.append((depth[known] - distance) / errors[known])
        assert abs(np.median(z[-1])) < 0.5
    assert 0.7 < np.subtract(*np.percentile(np.concatenate(z), [75, 25])) / 1.349 < 1.3
    known, misfit = (float(said.split(mark)[0].split()[-1]) for mark in (" % known", "\n"))
    assert known == pytest.approx(100.0 * np.isfinite(maps[:, 1]).mean(), abs=0.06)
    assert misfit == pytest.approx(1.0, abs=0.1)


def test_a_lens_that_alternates_gives_a_map_for_each_frame(program, tables, live, pairs):
    (near, far), (near_again, far_again) = pairs[1.3], pairs[1.5]
    maps, _ = ran(program, tables, stream([[near, far, near_again, far_again]]), "--alternating")
    for each, frames in zip(
        maps.reshape(3, *MAP), ((near, far), (near_again, far), (near_again, far_again)), strict=True
    ):
        np.testing.assert_allclose(each, live(*frames).depth, rtol=1e-4)


def test_bytes_and_sharp_images(program, tables, live):
    frames = [np.minimum(frame, 255).astype(np.uint8) for frame in pair(1.5, 80.0)]
    depth, _ = ran(program, tables, stream([frames]), "--bits", "8")
    image, _ = ran(program, tables, stream([frames]), "--bits", "8", "--write", "sharp")
    np.testing.assert_allclose(depth.reshape(MAP), live(*frames).depth, rtol=1e-3)
    np.testing.assert_allclose(image.reshape(HEIGHT, WIDTH), live.sharp(), atol=1e-4 * image.mean())


def test_a_map_is_there_before_further_frames_are_and_frames_may_come_in_crumbs(program, tables, live, pairs):
    command = [program, tables, f"{WIDTH}x{HEIGHT}"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        for frames in pairs.values():
            data = stream([frames])
            for start in range(0, len(data), 5001):
                running.stdin.write(data[start : start + 5001])
                running.stdin.flush()
            there = np.frombuffer(running.stdout.read(4 * MAP[0] * MAP[1]), np.float32)
            np.testing.assert_allclose(there.reshape(MAP), live(*frames).depth, rtol=1e-4)
        running.stdin.close()
        assert running.wait(timeout=60) == 0


def test_a_black_frame_is_a_sentence_and_a_map_of_nan(program, tables, pairs):
    black = [np.zeros_like(pairs[1.5][0]), pairs[1.5][1]]
    maps, said = ran(program, tables, stream([pairs[1.3], black, pairs[1.75]]), code=INCOMPLETE)
    maps = maps.reshape(3, *MAP)
    assert said.startswith("map 1 is NaN: frames must hold light")
    assert np.isnan(maps[1]).all()
    assert [float(np.nanmedian(maps[k])) for k in (0, 2)] == pytest.approx([1.3, 1.75], abs=0.01)


@pytest.mark.parametrize(
    ("left", "sentences"),
    [
        (1000, ["frame 2 ends after 1000 of 24576 bytes: it is left out\n"]),
        (24576, ["3 frames: the last have no map, which takes 2\n"]),
        (24577, ["frame 3 ends after 1 of 24576 bytes", "3 frames: the last have no map, which takes 2\n"]),
    ],
)
def test_a_stream_that_ends_too_early_gives_the_maps_that_there_are(program, tables, pairs, left, sentences):
    whole = stream([pairs[1.3]])
    maps, said = ran(program, tables, whole + whole[:left], code=INCOMPLETE)
    assert maps.size == MAP[0] * MAP[1]
    assert all(sentence in said for sentence in sentences)


def test_frames_of_another_size_are_doubted(program, tables, pairs):
    _, said = ran(program, tables, stream(pairs.values()), size=f"{HEIGHT}x{WIDTH}")
    assert "check the size of the frames" in said
    assert ran(program, tables, b"", code=INCOMPLETE)[0].size == 0


def test_who_reads_no_further_ends_it_and_a_full_disk_is_a_failure(program, tables, pairs):
    command = [program, tables, f"{WIDTH}x{HEIGHT}"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        running.stdout.close()
        running.stdin.write(stream([pairs[1.3]]))
        running.stdin.close()
        assert running.wait(timeout=60) == 0
        assert running.stderr.read().startswith(b"writing maps: Broken pipe\n0 maps of 32x24 from 2 frames")
    full = Path("/dev/full")
    if full.exists():
        with full.open("wb") as out:
            done = subprocess.run(
                command, input=stream([pairs[1.3]]), stdout=out, stderr=subprocess.PIPE, check=False
            )
        assert done.returncode == FAILED
        assert done.stderr.startswith(b"writing maps: No space left")


@pytest.mark.parametrize(("number", "left"), [(signal.SIGINT, 0), (signal.SIGTERM, 5000)])
def test_a_signal_ends_it_between_frames_and_within_one(program, tables, pairs, number, left):
    command, frames = [program, tables, f"{WIDTH}x{HEIGHT}"], stream([pairs[1.3]])
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        running.stdin.write(frames + frames[:left])
        running.stdin.flush()
        assert len(running.stdout.read(4 * MAP[0] * MAP[1])) == 4 * MAP[0] * MAP[1]
        running.send_signal(number)
        assert running.wait(timeout=60) == 128 + number
        assert running.stderr.read().startswith(b"interrupted: ")


def test_damaged_tables_are_refused(program, tables, pairs, tmp_path):
    good, damaged = tables.read_bytes(), tmp_path / "damaged.lml"
    for data, sentence in (
        (good[:-1], "the tables end too early"),
        (b"PNG!" + good[4:], "these are no tables of live depth"),
        (good[:12] + b"\2" + good[13:], "the tables are damaged"),  # blocks of two pixels
        (good + bytes(4), "the tables go on after their end"),
        (good[:56] + b"\0\0\xc0\x7f" + good[60:], "the tables are damaged"),  # NaN
    ):
        damaged.write_bytes(data)
        assert ran(program, damaged, b"", code=WRONG)[1] == f"{damaged}: {sentence}\n"
    data = bytearray(good)
    kept, mixes = int.from_bytes(data[52:56], "little"), 4 * int.from_bytes(data[36:40], "little")
    images = 8 * (1 + int.from_bytes(data[44:48], "little"))
    data[52:56] = bytes(4)
    damaged.write_bytes(data[: len(data) - kept * (mixes + images)])
    _, said = ran(program, damaged, stream(pairs.values()), "--write", "sharp", code=WRONG)
    assert said.startswith(f"{damaged}: the tables have no sharp images: sharp=True\n0 maps of 128x96 from 2 frames")


@pytest.mark.parametrize("threads", ["1", "3"])
def test_no_memory_is_allocated_for_a_frame(program, tables, pairs, tmp_path, threads):
    environment, told = os.environ | programs.allocation_counter(tmp_path), []
    for times in (2, 12):
        options = "--threads", threads, "--write", "sharp"
        _, said = ran(program, tables, times * stream(pairs.values()), *options, env=environment)
        told.append(int(said.splitlines()[-1]))
    assert 0 < told[0] == told[1]
