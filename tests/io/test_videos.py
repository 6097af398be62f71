"""Video: bits, ranges and times are kept; pairs are of one moment; faults are told and reading continues."""

from __future__ import annotations

import re
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import tifffile
from PIL import Image
from scipy.ndimage import gaussian_filter

from lommel.io import videos
from lommel.io.videos import VideoError, VideoFrame, VideoFrames, frame_pairs, video_frames

av = pytest.importorskip("av", reason="video needs PyAV: pip install av")

from small_disk import small_disk  # noqa: E402
from video_files import frames_of, write_video  # noqa: E402


def noise(count: int, shape: tuple[int, ...] = (64, 97), top: int = 255, dtype: type = np.uint8) -> list[np.ndarray]:
    return list(np.random.default_rng(count).integers(0, top, (count, *shape), endpoint=True).astype(dtype))


def numbers(frames: list[np.ndarray], found: np.ndarray) -> int:
    return next(k for k, frame in enumerate(frames) if np.array_equal(frame, found))


@pytest.mark.parametrize("bits", [10, 12, 16])
def test_grey_video_keeps_its_bits_and_ends_at_the_largest_integer(bits, tmp_path):
    frames = noise(3, top=2**bits - 1, dtype=np.uint16)
    frames[0][0, :2] = 0, 2**bits - 1
    path = write_video(tmp_path / "a.mkv", frames, stored=f"gray{bits}le")
    with video_frames(path) as video:
        assert (video.shape, video.dtype, video.levels, video.encoding) == ((64, 97), np.uint16, 2**bits, "linear")
        found = [frame.values for frame in video]
    assert np.array_equal([one >> (16 - bits) for one in found], frames)
    assert found[0][0, :2].tolist() == [0, 65535 if bits != 12 else found[0][0, 1]]
    assert found[0][0, 1] >= 65519


@pytest.mark.parametrize(("codec", "stored"), [("ffv1", "yuv420p"), ("mjpeg", "yuvj420p")])
def test_limited_and_full_range_are_both_read_from_black_to_white(codec, stored, tmp_path):
    ramp = np.tile(np.arange(256, dtype=np.uint8), (64, 1))
    options = {"qmin": "1", "qmax": "1"} if codec == "mjpeg" else {}
    path = write_video(tmp_path / "a.mkv", [ramp], codec=codec, stored=stored, **options)
    with video_frames(path, grey=True) as video:
        assert (video.levels, video.encoding) == (256, "srgb")
        values = next(video).values
    assert np.abs(values.astype(int) - ramp).max() <= 2
    assert np.ptp(values) >= 253


def test_colours_are_as_they_are_or_the_luma_of_them(tmp_path):
    frames = noise(2, (64, 64, 3))
    path = write_video(tmp_path / "a.mkv", frames, stored="bgr0")
    with video_frames(path) as video:
        assert np.array_equal([frame.values for frame in video], frames)
    with video_frames(path, grey=True) as video:
        assert video.encoding == "srgb"
        luma = next(video).values
    assert np.abs(luma - frames[0] @ [0.299, 0.587, 0.114]).max() < 2.5


def test_times_of_frames_are_those_of_the_file_and_gaps_are_dropped_frames(tmp_path):
    times = np.delete(0.04 * np.arange(14) + 0.2, [5, 8, 9])
    path = write_video(tmp_path / "a.mkv", noise(11), times, rate=50)  # a rate that is not so
    with video_frames(path) as video:
        assert [frame.time for frame in video] == pytest.approx(times.tolist())
        assert video.dropped == 3
        assert video.interval == pytest.approx(0.04)


def test_frames_of_one_source_alternate_and_a_dropped_one_moves_no_other_to_the_wrong_lens(tmp_path):
    frames = noise(13)
    kept = [k for k in range(13) if k not in (4, 8)]
    path = write_video(tmp_path / "a.mkv", [frames[k] for k in kept], 0.04 * np.array(kept))
    said: list[str] = []
    with frame_pairs(path, tell=said.append) as pairs:
        found = [(numbers(frames, a), numbers(frames, b), seconds) for a, b, seconds in pairs]
        assert [each[:2] for each in found] == [(0, 1), (2, 3), (6, 7), (10, 11)]
        assert [each[2] for each in found] == pytest.approx([0.0, 0.08, 0.24, 0.4])
        assert (pairs.dropped, pairs.alone, pairs.lost) == (2, 3, None)
        assert pairs.interval == pytest.approx(0.08)
    assert said == [f"{path} ends inside a pair: its last frame was skipped"]


def test_a_lost_frame_that_the_times_hide_is_seen_by_the_sharpness_and_a_new_scene_is_not_one(tmp_path):
    def shot(number: int) -> np.ndarray:
        draw = np.random.default_rng(number // 10)  # another scene from frame 10 on
        fine = draw.uniform(500.0, 3500.0, (96, 128))
        soft = gaussian_filter(fine, 1.0)
        near_is_sharp = np.arange(128) < 64 if number < 10 else np.arange(96)[:, None] < 48
        seen = np.where(near_is_sharp == (number % 2 == 0), fine, soft)
        seen *= 1.0 + 0.2 * np.sin(2.4 * number + np.arange(96)[:, None] / 9.5)  # a lamp flickers in bands of rows
        return np.rint(np.random.default_rng(100 + number).normal(seen, np.sqrt(seen))).astype(np.uint16)

    kept = [number for number in range(22) if number not in (5, 16)]
    path, told = write_video(tmp_path / "both.mkv", [shot(number) for number in kept]), []
    with frame_pairs(path, tell=told.append) as pairs:
        found = list(pairs)
    shots = [shot(number) for number in range(22)]
    assert [(numbers(shots, pair.first), numbers(shots, pair.second)) for pair in found] == [
        (near, near + 1) for near in (0, 2, 6, 8, 10, 12, 14, 18, 20)
    ]
    assert (pairs.dropped, pairs.alone, len(told)) == (2, 2, 1)
    assert "lost a frame before 0.20 s, though its times do not show it" in told[0]


def test_frames_of_two_sources_are_paired_by_their_times(tmp_path):
    frames, steps = noise(12), 0.04 * np.arange(12)
    near = [k for k in range(12) if k not in (4, 8)]
    far = [k for k in range(10) if k != 6]
    jitter = np.random.default_rng(1).uniform(-0.01, 0.01, 12)
    a = write_video(tmp_path / "a.mkv", [frames[k] for k in near], steps[near])
    b = write_video(tmp_path / "b.mkv", [frames[k] for k in far], 0.012 + steps[far] + 0.5 * jitter[far])
    said: list[str] = []
    with frame_pairs(a, b, tell=said.append) as pairs:
        assert repr(pairs) == f"<FramePairs of {a} and {b}: 97 x 64, uint8>"
        found = [(numbers(frames, one), numbers(frames, other)) for one, other, _ in pairs]
        assert found == [(k, k) for k in (0, 1, 2, 3, 5, 7, 9)]
        assert pairs.dropped == 3
        assert pairs.alone == 4
    assert len(said) == 1
    assert said[0].startswith(f"{b} ends before {a}, whose frame at 0.400 s was skipped. Unless")


def test_sources_of_different_moments_have_no_pairs_and_that_is_told(tmp_path, monkeypatch):
    monkeypatch.setattr(videos, "_MAX_UNPAIRED", 5)
    a = write_video(tmp_path / "a.mkv", noise(12))
    b = write_video(tmp_path / "b.mkv", noise(12), 9.0 + 0.04 * np.arange(12))
    said: list[str] = []
    with frame_pairs(a, b, tell=said.append) as pairs:
        assert list(pairs) == []
    assert "are within 20 ms of each other, at 0.160 and 9.000 s" in said[0]


def test_frames_of_another_size_are_left_out_and_told_once(tmp_path):
    parts = [
        write_video(tmp_path / f"{k}.ts", frames, codec="mpeg4", stored="yuv420p", form="mpegts").read_bytes()
        for k, frames in enumerate((noise(4, (64, 96)), noise(3, (96, 64))))
    ]
    (tmp_path / "a.ts").write_bytes(parts[0] + parts[1] + parts[0])
    with video_frames(tmp_path / "a.ts", grey=True) as video:
        said = "a frame of 64 x 96 uint8 .* the first is of 96 x 64 uint8: such frames are skipped"
        with pytest.warns(RuntimeWarning, match=said):
            found = list(video)
        assert {frame.values.shape for frame in found} == {(64, 96)}
        assert video.refused == 3
    b = write_video(tmp_path / "b.mkv", noise(4, (96, 64)))
    with pytest.raises(VideoError, match="frames of one size and type, got 96 x 64 uint8 and 64 x 96 uint8"):
        frame_pairs(tmp_path / "0.ts", b)


def test_reading_goes_on_after_damaged_frames_which_are_dropped(tmp_path):
    data = bytearray(write_video(tmp_path / "a.mkv", noise(40, (64, 64))).read_bytes())
    data[len(data) // 3 : len(data) // 3 + 9000] = bytes(9000)
    (tmp_path / "a.mkv").write_bytes(data)
    with video_frames(tmp_path / "a.mkv", tell=pytest.fail) as video:
        count = sum(1 for _ in video)
        assert 20 <= count < 40
        assert (video.dropped, video.lost) == (40 - count, None)


def test_a_codec_that_finds_frames_damaged_is_told_of_once(tmp_path, monkeypatch):
    class Packet:
        size = 100

        def __init__(self, number: int) -> None:
            self.number = number

        def decode(self) -> list[av.VideoFrame]:
            if self.number % 2:
                raise av.error.InvalidDataError(1, "invalid data")
            frame = av.VideoFrame.from_ndarray(np.zeros((64, 64), np.uint8), format="gray")
            frame.pts, frame.time_base = 40 * self.number, Fraction(1, 1000)
            return [frame]

    path, said = write_video(tmp_path / "a.mkv", noise(2, (64, 64))), []
    monkeypatch.setattr(videos._PyavReader, "_packets", lambda self: map(Packet, range(12)), raising=True)
    with video_frames(path, tell=said.append) as video:
        assert len(list(video)) == 6
    assert said == [f"{path} is damaged after 1 frames (invalid data): reading continues"]


def test_the_loss_of_compression_is_read_from_its_quantization(tmp_path):
    frames = [gaussian_filter(frame.astype(float), 2.0).astype(np.uint8) for frame in noise(4, (64, 96))]
    found = {}
    for name, codec, options in (
        ("lossless", "ffv1", {}),
        ("i4", "libx264", {"stored": "yuv420p", "qp": "7", "g": "1"}),
        ("p4", "libx264", {"stored": "yuv420p", "qp": "7", "tune": "zerolatency"}),
        ("filtered", "libx264", {"stored": "yuv420p", "qp": "30"}),
        ("jpeg", "mjpeg", {"stored": "yuvj420p", "qmin": "2", "qmax": "2"}),
        ("unread", "mpeg4", {"stored": "yuv420p"}),
    ):
        with frame_pairs(write_video(tmp_path / f"{name}.mkv", frames, codec=codec, **options)) as pairs:
            assert len(list(pairs)) == 2
            found[name] = np.asarray(pairs.loss)
    assert found["lossless"] == 0.0
    assert found["unread"] == np.inf
    assert found["filtered"].shape == (4, 6)
    assert np.isinf(found["filtered"]).all()
    # x264 takes 3 less for intra frames. The step is 0.625 * 2^(qp / 6), of 219 levels: ITU-T H.264, 8.5.9.
    assert np.median(found["i4"]) == pytest.approx((0.625 * 2.0 ** (4 / 6) / 219.0) ** 2 / 12.0)
    assert np.median(found["p4"]) == pytest.approx(30.0 * (0.625 * 2.0 ** (7 / 6) / 219.0) ** 2 / 12.0)
    Image.fromarray(frames[0]).save(tmp_path / "1.jpg", quality=97)
    Image.fromarray(frames[0]).save(tmp_path / "2.jpg", quality=97)
    with Image.open(tmp_path / "1.jpg") as picture:
        step = np.mean(np.square(picture.quantization[0]))
    with frame_pairs(tmp_path / "%d.jpg") as pairs:
        next(pairs)
        assert pairs.loss == pytest.approx(step / 12.0 / 255.0**2)
    assert found["jpeg"] * 255.0**2 == pytest.approx(6.0, rel=0.1)


def test_a_file_that_is_cut_off_is_told_by_the_length_that_it_states(tmp_path):
    data = write_video(tmp_path / "a.mkv", noise(40, (64, 64))).read_bytes()
    (tmp_path / "a.mkv").write_bytes(data[: len(data) // 2])
    said: list[str] = []
    with video_frames(tmp_path / "a.mkv", tell=said.append) as video:
        assert 17 <= len(list(video)) <= 20
        assert re.fullmatch(r".*a\.mkv breaks off at 0\.\d+ s of 1\.60 s", video.lost)
    assert said == [video.lost]


def test_numbered_images_are_video_with_gaps_where_numbers_are_missing(tmp_path):
    frames = noise(4, (64, 66), top=65535, dtype=np.uint16)
    for number, frame in zip((1, 2, 10, 11), frames, strict=True):
        tifffile.imwrite(tmp_path / f"b2-{number}.tif", frame)
    (tmp_path / "b2-3.txt").write_text("no image")
    for source in (tmp_path, tmp_path / "b2-%04d.tif"):
        with video_frames(source) as video:
            assert np.array_equal([frame.values for frame in video], frames)
            assert (video.dropped, video.levels, video.encoding) == (7, 65536, "linear")
    colour = noise(1, (64, 66, 3))[0]
    Image.fromarray(colour).save(tmp_path / "c7.png")
    with video_frames(tmp_path / "c%d.png", grey=True) as video:
        assert np.abs(next(video).values - colour @ [0.299, 0.587, 0.114]).max() <= 0.5
        assert video.encoding == "srgb"


def test_a_damaged_image_is_left_out_and_told(tmp_path):
    colour = noise(1, (64, 66, 3))[0]
    for number in (1, 2, 3, 4, 5):
        Image.fromarray(colour).save(tmp_path / f"{number}.jpg", quality=50)
    for number in (3, 4):
        (tmp_path / f"{number}.jpg").write_bytes((tmp_path / "1.jpg").read_bytes()[:300])
    said: list[str] = []
    with video_frames(tmp_path, grey=True, tell=said.append) as video:
        assert len(list(video)) == 3
        assert video.dropped == 2
    (sentence,) = said
    assert "3.jpg is skipped: " in sentence


@pytest.mark.parametrize(
    ("source", "said"),
    [
        ("text.mkv", "text.mkv cannot be read as video"),
        ("empty.mkv", "empty.mkv cannot be read as video"),
        ("half.mp4", "half.mp4 cannot be read as video"),
        ("%04d.tif", "has no numbered images"),
        ("a%s.tif", "one number such as %04d and no other %"),
        ("%d%d.tif", "one number such as %04d"),
    ],
)
def test_what_is_no_video_is_told(source, said, tmp_path):
    (tmp_path / "text.mkv").write_text("hello " * 100)
    (tmp_path / "empty.mkv").touch()
    whole = write_video(tmp_path / "whole.mp4", noise(4, (64, 64)), codec="mpeg4", stored="yuv420p").read_bytes()
    (tmp_path / "half.mp4").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(ValueError, match=said):
        video_frames(tmp_path / source)


def test_arguments_out_of_range_are_told(tmp_path, monkeypatch):
    with pytest.raises(FileNotFoundError):
        video_frames(tmp_path / "none.mkv")
    with pytest.raises(ValueError, match=r"source must be of http, .*, got 'ftp://'"):
        video_frames("ftp://somewhere/a.mkv")
    with pytest.raises(VideoError, match=r"rtsp://127\.0\.0\.1:9/a cannot be read as video: Connection refused"):
        video_frames("rtsp://user:secret@127.0.0.1:9/a")
    path = write_video(tmp_path / "a.mkv", noise(2, (64, 64)))
    with pytest.raises(TypeError, match="tell"):
        frame_pairs(path, path, tell="aloud")
    monkeypatch.setattr(videos, "MAX_FRAME", 4000)
    with pytest.raises(VideoError, match="has frames of 64 x 64 pixels; the limit is 4000 pixels"):
        video_frames(path)


class Endless:
    """A live source of frames that count, as fast as they may come."""

    name, live, interval, levels, grey = "a camera", True, 0.01, 256, True

    def __init__(self, ends: int | None = None, stalls: bool = False) -> None:
        self.ends, self.stalls, self.closed = ends, stalls, False
        self.sent = 0
        self.go = threading.Event()

    def frames(self) -> Iterator[VideoFrame]:
        while self.ends is None or self.sent < self.ends:
            if self.sent > 6 and not self.go.wait(5.0):
                return
            yield VideoFrame(np.full((8, 8), self.sent, np.uint16), 0.01 * self.sent)
            self.sent += 1
            time.sleep(0.0005)
        if self.stalls:
            threading.Event().wait(0.3)
        raise VideoError("a camera gives no more frames")

    def close(self) -> None:
        self.closed = True


def waited(source: Endless, count: int) -> None:
    while source.sent < count:
        time.sleep(0.001)


def test_a_slow_reader_of_a_camera_gets_the_last_frames_and_pairs_that_are_pairs():
    source = Endless(400)
    source.go.set()
    with videos.FramePairs((VideoFrames(source, print),), print) as pairs:
        waited(source, 50)  # which come before anybody asks, and are not counted
        found = []
        for pair in pairs:
            found.append((int(pair.first[0, 0]), int(pair.second[0, 0])))
            time.sleep(0.01)
        assert found[0][0] >= 46
        assert all(b == a + 1 for a, b in found)
        assert len({a % 2 for a, _ in found}) == 1
        first, last = found[0][0], found[-1][1]
        assert 0 < pairs.dropped <= last - first + 1 - 2 * len(found) + 2
        assert pairs.lost == "a camera gives no more frames"
    assert source.closed


def test_a_camera_without_frames_is_not_waited_for_for_ever(monkeypatch):
    monkeypatch.setattr(videos, "_TIMEOUT", 0.05)
    source = Endless(9, stalls=True)
    source.go.set()
    said: list[str] = []
    with VideoFrames(source, said.append) as video:
        waited(source, 9)
        assert len(list(video)) == 0
        assert video.lost == "a camera has had no frame for 0.05 s"
    assert said == [video.lost]


def test_a_camera_is_read_by_opencv_until_it_is_unplugged(monkeypatch):
    class Capture:
        def __init__(self, number: int) -> None:
            self.left = 9 if number == 3 else 0

        def isOpened(self) -> bool:
            return self.left > 0

        def get(self, which: int) -> float:
            return 1196444237.0 if which == 6 else 0.0  # "MJPG"

        def grab(self) -> bool:
            self.left -= 1
            return self.left >= 0

        def retrieve(self) -> tuple[bool, np.ndarray]:
            return True, np.full((64, 64, 3), self.left, np.uint8)

        def release(self) -> None:
            self.left = -1

    module = SimpleNamespace(
        VideoCapture=Capture, CAP_PROP_FPS=5, CAP_PROP_FOURCC=6, COLOR_BGR2GRAY=6, COLOR_BGR2RGB=4,
        utils=SimpleNamespace(logging=SimpleNamespace(setLogLevel=lambda level: None)),
        cvtColor=lambda values, order: values[..., 0] if order == 6 else values[..., ::-1],
    )  # fmt: skip
    monkeypatch.setitem(sys.modules, "cv2", module)
    said: list[str] = []
    with video_frames("3", grey=True, tell=said.append) as video:
        assert (video.name, video.shape, video.encoding, video.live) == ("camera 3", (64, 64), "srgb", True)
        assert len(list(video)) <= 9
    lossy, end = said
    assert lossy.startswith("camera 3 compresses its frames with loss (Motion JPEG, H.264 or H.265)")
    assert end == "camera 3 gives no more frames: it was unplugged, or stopped"
    with pytest.raises(VideoError, match="camera 0 cannot be opened"):
        video_frames(0)


def test_grey_of_16_bits_is_written_without_loss_and_with_its_times(tmp_path):
    frames = noise(5, (40, 31), top=65535, dtype=np.uint16)
    times = [0.0, 0.04, 0.09, 0.5, 0.54]
    with videos.find(tmp_path / "a.mkv").write(tmp_path / "a.mkv", 0.04, "of depth") as write:
        for frame, seconds in zip(frames, times, strict=True):
            write(frame, seconds)
    found, seconds = frames_of(tmp_path / "a.mkv")
    assert np.array_equal(found, frames)
    assert seconds == pytest.approx(times)
    with av.open(str(tmp_path / "a.mkv")) as container:
        assert {name.lower(): text for name, text in container.metadata.items()}["comment"] == "of depth"


@pytest.mark.parametrize("suffix", [".mkv", ".mp4"])
def test_colours_are_written_for_players_with_even_sides(suffix, tmp_path):
    path = tmp_path / f"a{suffix}"
    with videos.find(path).write(path, 0.04) as write:
        for k in range(8):
            write(np.full((33, 65, 3), (20 * k, 100, 200), np.uint8), 0.04 * k)
    found, times = frames_of(path, "rgb24")
    assert found.shape == (8, 34, 66, 3)
    assert times == pytest.approx(0.04 * np.arange(8), abs=1e-3)
    assert np.abs(found[5, 8:24, 8:24].astype(int) - (100, 100, 200)).max() <= 6
    assert [path] == list(tmp_path.iterdir())


def frames_so_far(path: Path) -> list[float]:
    """Times of the frames of a file that is still being written."""
    times = []
    try:
        with av.open(str(path)) as container:
            for frame in container.decode(video=0):
                times.append(float(frame.time))  # noqa: PERF401 (those before the end of a file that is cut)
    except (av.error.EOFError, av.error.InvalidDataError):  # it has a header only, or is cut in a frame
        pass
    return times


CODECS = {"libx264": "h264", "mpeg4": "mpeg4"}  # decoders
KINDS = [
    (".mkv", np.uint16, (16, 24), "libx264"),
    (".mkv", np.uint8, (48, 64, 3), "libx264"),
    (".mp4", np.uint8, (48, 64, 3), "libx264"),
    (".mkv", np.uint8, (48, 64), "mpeg4"),
    (".mp4", np.uint8, (48, 64), "mpeg4"),
]


@pytest.mark.parametrize(("suffix", "dtype", "shape", "codec"), KINDS)
def test_each_frame_is_in_the_file_once_the_next_is_written(suffix, dtype, shape, codec, tmp_path, monkeypatch):
    monkeypatch.setattr(av, "codecs_available", av.codecs_available - ({"libx264"} - {codec}))
    target, unfinished = tmp_path / f"a{suffix}", tmp_path / f"a.unfinished{suffix}"
    times = [0.0, 0.04, 0.08, 0.12, 0.5, 3.0, 3.04]
    with videos.find(target).write(target, 0.04) as write:
        for k, frame in enumerate(noise(7, shape, top=np.iinfo(dtype).max, dtype=dtype)):
            write(frame, times[k])
            assert frames_so_far(unfinished) == pytest.approx(times[:k], abs=1e-3)
    assert [path.name for path in tmp_path.iterdir()] == [target.name]
    assert frames_so_far(target) == pytest.approx(times, abs=1e-3)
    with av.open(str(target)) as container:
        assert container.streams.video[0].codec_context.name == ("ffv1" if dtype == np.uint16 else CODECS[codec])
    if suffix == ".mp4":  # an ordinary file, without fragments
        assert boxes(target.read_bytes()) == [b"ftyp", b"free", b"mdat", b"moov"]


def boxes(data: bytes) -> list[bytes]:
    """Types of the boxes of an MP4 file."""
    found, place = [], 0
    while place < len(data):
        found.append(data[place + 4 : place + 8])
        size = int.from_bytes(data[place : place + 4], "big")
        place += size if size > 1 else int.from_bytes(data[place + 8 : place + 16], "big")
    return found


@pytest.mark.parametrize("end", ["disk full", "disk full at the end", "another error"])
@pytest.mark.parametrize("suffix", [".mkv", ".mp4"])
def test_an_error_keeps_the_frames_before_it(suffix, end, tmp_path):
    target, unfinished = tmp_path / f"a{suffix}", tmp_path / f"a.unfinished{suffix}"
    target.write_bytes(b"earlier video")
    written = []

    def record() -> None:
        with ExitStack() as stack, videos.find(target).write(target, 0.04) as write:
            if end == "disk full":
                stack.enter_context(small_disk(40_000))
            for k, frame in enumerate(noise(30, (48, 64))):
                write(frame, 0.04 * k)
                written.append(0.04 * k)
            if end == "another error":
                raise OSError(0, "enough", str(target))
            # The last frame takes 2000 bytes, the index of an MP4 file as many.
            stack.enter_context(small_disk(unfinished.stat().st_size + {".mkv": 100, ".mp4": 2500}[suffix]))

    with (
        pytest.warns(UserWarning, match=rf"a\.unfinished\{suffix} keeps what was recorded"),
        pytest.raises(OSError, match=rf"(File too large|enough): '[^']*/a\{suffix}'"),
    ):
        record()
    assert target.read_bytes() == b"earlier video"
    assert (len(written) < 30) is (end == "disk full")
    lost = len(written) - len(frames_so_far(unfinished))
    assert lost in ((0, 1) if end.startswith("disk") else (0,))


@pytest.mark.parametrize(
    ("interval", "rate"),
    [(1001 / 30000, Fraction(30000, 1001)), (25.0, Fraction(1, 10)), (1e-4, Fraction(1000)), (0.25, Fraction(4))],
)
def test_the_rate_of_a_written_video_is_a_fraction_of_a_tenth_to_a_thousand(interval, rate, tmp_path):
    assert videos.VideoWriter(tmp_path / "a.mkv", interval, form="matroska")._rate == rate
