"""Video: read frames, or pairs of frames, from files, streams, cameras and numbered images; write videos."""

from __future__ import annotations

import math
import re
import threading
import time
import warnings
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from fractions import Fraction
from functools import partial
from itertools import chain, islice, pairwise
from os import PathLike, fspath
from pathlib import Path
from statistics import median
from types import TracebackType
from typing import TYPE_CHECKING, Any, NamedTuple, NoReturn, Self, TypeAlias

import numpy as np

from lommel.base import atomic, optional, reading, validation
from lommel.base.arrays import Values
from lommel.base.encoding import Encoding
from lommel.io import photos, registry
from lommel.io.registry import Format

if TYPE_CHECKING:
    import av
    from av import Packet, VideoStream
    from av.container import InputContainer, OutputContainer

__all__ = ["FramePair", "FramePairs", "VideoError", "VideoFrame", "VideoFrames", "frame_pairs", "video_frames"]

Source: TypeAlias = int | str | PathLike[str]
Report: TypeAlias = Callable[[str], object]

MAX_FRAME = 2**26
"""Maximum number of pixels of a frame."""

USUAL_RATE = 25.0
"""Frame rate (1/s) of sources that state neither times nor a rate, such as numbered images."""

_SCHEMES = ("http", "https", "rtmp", "rtp", "rtsp", "rtsps", "srt", "tcp", "udp")
_LOSSY = (b"MJPG", b"JPEG", b"H264", b"HEVC")  # FourCC codes of lossy compressions of cameras
_TIMEOUT = 10.0  # seconds without a frame after which a live source counts as ended
_MAX_UNREAD = 4  # maximum number of unread frames of a live source that are stored
_FIRST_FRAMES = 6  # number of frames from which the first estimate of the frame interval is computed
_MEDIAN_STEPS = 31  # number of latest time differences whose median is the frame interval
_MISSING_FRACTION = 0.02  # fraction of the stated duration of a file that may be missing without an error
_DELAY_FRAMES = 250  # number of latest frames of a stream whose smallest delay sets the origin of its times
_MAX_FAULTS = 100  # maximum number of consecutive damaged packets
# Options of the containers that write each frame to the file once the next one is there, not 5 s or all at the end.
_FLUSHED = {
    "matroska": {"flush_packets": "1", "cluster_time_limit": "0"},
    # Fragments play without an end; at the end they become one ordinary file.
    "mp4": {"flush_packets": "1", "movflags": "hybrid_fragmented+frag_every_frame"},
}
# Without zero latency 11 frames wait in the encoder. It takes more bits for a quality: 18 in place of 16.
_H264 = {"crf": "18", "preset": "veryfast", "tune": "zerolatency"}
_SHARPNESS_CELL = 16  # side, pixels, of the squares whose sharpness tells the focus of alternating frames
_FOCUS_FRAMES = 6  # number of latest frames with whose changes of sharpness the next one is compared
_CERTAIN_FOCUS = 4.0  # least ratio of the mean squared changes of sharpness between foci and within one
MACROBLOCK = 16  # side, pixels, of the squares with a quantization parameter of their own in H.264
_LAST_UNFILTERED = 15  # largest quantization parameter (8 bits) at which H.264 does not smooth edges of its blocks
_PREDICTED_LOSS = 30.0  # loss of predicted frames / that of quantization, as measured with one reference frame
_MAX_UNPAIRED = 100  # number of consecutive frames without a partner after which a message is issued


class VideoError(ValueError):
    """A source that cannot be read as video; the message has its name and the reason."""


class VideoFrame(NamedTuple):
    """One frame of a video.

    Parameters
    ----------
    values : ndarray of uint8, uint16 or float32, shape (height, width) or (height, width, 3)
        Grey or RGB.
    time : float
        Time of the frame, seconds.
    """

    values: Values
    time: float
    __eq__, __ne__, __hash__ = object.__eq__, object.__ne__, object.__hash__  # type: ignore[misc]


class FramePair(NamedTuple):
    """Two grey frames recorded at the same time.

    Parameters
    ----------
    first, second : ndarray of uint8, uint16 or float32, shape (height, width)
        Both have the same shape and type.
    time : float
        Time of the first frame, seconds.
    """

    first: Values
    second: Values
    time: float
    __eq__, __ne__, __hash__ = object.__eq__, object.__ne__, object.__hash__  # type: ignore[misc]


class _CodedFrame(VideoFrame):
    """A frame and the loss of its compression, as :attr:`VideoFrames.loss`."""

    loss: float | Values = 0.0

    @classmethod
    def of(cls, values: Values, seconds: float, loss: float | Values) -> Self:
        frame = cls(values, seconds)
        frame.loss = loss
        return frame


_NumberedFrame: TypeAlias = tuple[int, VideoFrame]


class _ClosingIterator:
    """An iterator that is closed at the end of a ``with`` block."""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __iter__(self) -> Self:
        return self

    def __reduce_ex__(self, _: object) -> NoReturn:
        raise TypeError(
            f"{type(self).__name__} cannot be copied or pickled, since they are read once: open the source again"
        )

    def close(self) -> None:
        """Close the source or the sources."""
        raise NotImplementedError


class VideoFrames(_ClosingIterator):
    """Frames of one source in the order of their times: an iterator of :class:`~lommel.io.VideoFrame`.

    :func:`video_frames` returns it; ``with`` or `close` closes it. For a camera or a stream it stores the latest
    four unread frames and drops older ones.

    Parameters
    ----------
    reader : object
        Reader of the source: of a file or stream, of a camera, or of numbered images.
    tell : callable
        Function that is called with a message for each error after which reading continues.

    Attributes
    ----------
    name : str
        Name of the source in messages, without user name and password.
    live : bool
        True for a camera or a stream.
    shape : tuple of int
        Height and width of the frames, and 3 for colour.
    dtype : dtype
        uint8; uint16 if the source has more than 8 bits (scaled to the maximum 65535); or float32.
    levels : int
        Number of levels that the source can store: 256 for 8 bits; 0 for floats.
    encoding : {"srgb", "linear"}, float or ToneCurves
        Encoding that numbered images state; otherwise linear for floats and for grey of more than 8 bits, else sRGB.
    exif : Exif
        Lens data of the first of numbered images.
    number : int
        Number of the latest frame, from 0; missing frames are counted.
    dropped : int
        Number of missing frames, estimated from the times of the frames that were read.
    refused : int
        Number of frames that were skipped since their size or type differs from the first frame.
    lost : str or None
        Reason why the frames ended early, or None.
    loss : float or ndarray
        Variance that compression adds to the values of the latest frame, as a fraction of the squared largest value:
        a number, or a map of squares of 16 pixels. 0 without compression; infinite where texture is lost or the
        quantization of the codec cannot be read. Of frames that H.264 predicts it is 30 times that of quantization,
        because differences from a frame of another focus that are below the quantization step vanish.

    Raises
    ------
    VideoError
        If the source contains no frame.
    """

    def __init__(self, reader: _PyavReader | _CameraReader | _ImageReader, tell: Report) -> None:
        self._reader, self._report = reader, tell
        self.name, self.live, self.levels = reader.name, reader.live, reader.levels
        self.dropped = self.refused = self.number = 0
        self.lost: str | None = None
        self.loss: float | Values = 0.0
        self._times: deque[float] = deque(maxlen=_MEDIAN_STEPS)
        self._frames = self._number_frames()
        self._last_number: int | None = None
        try:
            first = next(self._frames, None)
            if first is None:
                raise VideoError(f"{self.name} holds no frame")
        except BaseException:
            reader.close()
            raise
        self.shape, self.dtype = first[1].values.shape, first[1].values.dtype
        self._first: _NumberedFrame | None = first
        high_depth = reader.grey and reader.levels > 256
        assumed = "linear" if high_depth or self.dtype.kind == "f" else "srgb"
        self.encoding: Encoding = getattr(reader, "encoding", None) or assumed
        self.exif = getattr(reader, "exif", photos.Exif())
        self._latest = _LatestFrames(self._frames, self.name) if self.live else None

    def __repr__(self) -> str:
        height, width = self.shape[:2]
        return f"<VideoFrames of {self.name}: {width} x {height}, {self.dtype}>"

    @property
    def interval(self) -> float:
        """Seconds between frames: the median of the latest intervals, or the stated interval if there are under 3."""
        intervals = list(self._times)
        if len(intervals) > 2:
            return median(intervals)
        return self._reader.interval or min(intervals, default=1.0 / USUAL_RATE)

    def _number_frames(self) -> Iterator[_NumberedFrame]:
        """Yield frames with numbers, which increase by more than 1 if the times show missing frames."""
        frames = self._reader.frames()
        # Stated rates may be wrong and early frames may be missing: read several frames before numbering the first.
        queue, error = deque[VideoFrame](), None
        try:
            for frame in islice(frames, _FIRST_FRAMES):
                queue.append(frame)
        except VideoError as fault:
            error = fault
        self._times.extend(step for a, b in pairwise(queue) if (step := b.time - a.time) > 0.0)
        number, last_time = 0, math.nan
        early_frames = (queue.popleft() for _ in range(len(queue)))  # each frame is released when it is yielded
        for k, frame in enumerate(chain(early_frames, frames)):
            step = frame.time - last_time
            if k >= _FIRST_FRAMES and step > 0.0:
                self._times.append(step)
            if not math.isnan(last_time):
                number += max(1, round(step / self.interval))
            last_time = frame.time
            yield number, frame
        if error is not None:
            raise error

    def __next__(self) -> VideoFrame:
        """Return the next frame."""
        while True:
            self.number, frame = self._read()
            if frame.values.shape == self.shape and frame.values.dtype == self.dtype:
                break
            self.refused += 1
            if self.refused == 1:
                size, first_size = (" x ".join(map(str, s[1::-1])) for s in (frame.values.shape, self.shape))
                self._report(
                    f"{self.name} has a frame of {size} {frame.values.dtype} at {frame.time:.2f} s, where the first "
                    f"is of {first_size} {self.dtype}: such frames are skipped"
                )
        self.dropped += 0 if self._last_number is None else self.number - self._last_number - 1
        self._last_number = self.number
        self.loss = getattr(frame, "loss", 0.0)
        return frame

    def _read(self) -> _NumberedFrame:
        first, self._first = self._first, None
        if first is not None:
            if self._latest is None:
                return first
            self._latest.clear()  # drops frames that arrived before the first one was read
        try:
            return next(self._latest or self._frames)
        except VideoError as error:
            self.lost = str(error)
            self._report(self.lost)
            raise StopIteration from None

    def close(self) -> None:
        """Close the source."""
        if self._latest is None or self._latest.stop():
            self._reader.close()


class _LatestFrames:
    """Queue of the latest frames of a live source, which are read by a thread."""

    def __init__(self, frames: Iterator[_NumberedFrame], name: str) -> None:
        self._frames, self._name = frames, name
        self._unread: deque[_NumberedFrame] = deque(maxlen=_MAX_UNREAD)
        self._changed = threading.Condition()
        self._end: BaseException | None = None
        self._stopped = False
        self._thread = threading.Thread(target=self._collect, daemon=True, name=f"frames of {name}")
        self._thread.start()

    def _collect(self) -> None:
        end: BaseException = StopIteration()
        try:
            for frame in self._frames:
                with self._changed:
                    if self._stopped:
                        break
                    self._unread.append(frame)
                    self._changed.notify()
        except Exception as error:
            end = error
        with self._changed:
            self._end = end
            self._changed.notify()

    def clear(self) -> None:
        """Drop all unread frames."""
        with self._changed:
            self._unread.clear()

    def __iter__(self) -> Self:
        return self

    def __next__(self) -> _NumberedFrame:
        with self._changed:
            if not self._changed.wait_for(lambda: self._unread or self._end is not None, _TIMEOUT):
                raise VideoError(f"{self._name} has had no frame for {_TIMEOUT:g} s")
            if self._unread:
                return self._unread.popleft()
            assert self._end is not None
            raise self._end

    def stop(self) -> bool:
        """Stop the thread; return True if it ended within a few seconds."""
        self._stopped = True
        self._thread.join(timeout=3.0)
        return not self._thread.is_alive()


class _FocusOrder:
    """Recognition of the focus of alternating frames, from maps of their sharpness."""

    def __init__(self) -> None:
        self.exchanges = 0
        self._maps: dict[bool, Values] = {}  # latest map of each focus
        self._changes: deque[tuple[float, float]] = deque(maxlen=_FOCUS_FRAMES)

    def is_exchanged(self, frame: Values, is_far: bool) -> bool:
        """Add a frame that should be near or far; return True if it certainly has the other focus."""
        sharpness = self._sharpness(frame)
        exchanged = False
        if len(self._maps) == 2:
            # Squared changes from the latest frame that should have the same focus, and from the other.
            same, other = (float(np.sum((sharpness - self._maps[far]) ** 2)) for far in (is_far, not is_far))
            # The third largest and third smallest of the latest frames: a new scene changes two of these.
            history = np.sort(self._changes or [(other, same)], axis=0)
            largest_same, least_other = float(history[-3:, 0].min()), float(history[:3, 1].max())
            exchanged = (
                least_other > _CERTAIN_FOCUS * largest_same
                and other < 2.0 * largest_same  # so that a scene that changes is no exchange
                and same > 0.5 * least_other
            )
            if not exchanged:
                self._changes.append((same, other))
        self._maps[is_far != exchanged] = sharpness
        return exchanged

    @staticmethod
    def _sharpness(frame: Values) -> Values:
        """Return the logarithm of (squared differences of neighbours / squared mean) of squares of the frame."""
        height, width = (side // _SHARPNESS_CELL for side in frame.shape)
        # A quarter of the rows is enough.
        rows = frame[: height * _SHARPNESS_CELL : 4, : width * _SHARPNESS_CELL].astype(np.float32)
        steps = np.diff(rows, axis=1, append=rows[:, -1:]) ** 2
        shape = height, _SHARPNESS_CELL // 4, width, _SHARPNESS_CELL
        energy, mean = (np.nan_to_num(each).reshape(shape).mean(axis=(1, 3)) for each in (steps, rows))
        floor = 1e-9 * float(np.square(mean).sum()) + np.finfo(np.float32).tiny
        return np.asarray(np.log((energy + floor) / (mean**2 + floor)))


class FramePairs(_ClosingIterator):
    """Pairs of frames recorded at the same time: an iterator of :class:`~lommel.io.FramePair`.

    :func:`frame_pairs` returns it; ``with`` or `close` closes it. It stores only a few frames at a time.

    Parameters
    ----------
    sources : tuple of VideoFrames
        One source whose focus alternates, or two sources.
    tell : callable
        As for :class:`VideoFrames`.

    Attributes
    ----------
    shape, dtype, levels, encoding
        Attributes of the first source, a :class:`VideoFrames`; a second source has the same `shape` and `dtype`.
    alone : int
        Number of frames without a partner.
    loss : float or ndarray
        The larger loss of the two frames of the latest pair; see :class:`VideoFrames`.
    """

    def __init__(self, sources: tuple[VideoFrames, ...], tell: Report) -> None:
        self.sources, self._report = sources, tell
        first = sources[0]
        self.shape, self.dtype, self.levels, self.encoding = first.shape, first.dtype, first.levels, first.encoding
        self.alone = 0
        self.loss: float | Values = 0.0
        self._pairs = self._pair_alternating() if len(sources) == 1 else self._match_times()

    def __repr__(self) -> str:
        height, width = self.shape[:2]
        names = " and ".join(one.name for one in self.sources)
        return f"<FramePairs of {names}: {width} x {height}, {self.dtype}>"

    def __next__(self) -> FramePair:
        """Return the next pair."""
        return next(self._pairs)

    @property
    def dropped(self) -> int:
        """Number of missing frames of all sources, estimated from the times of the other frames."""
        return sum(one.dropped for one in self.sources)

    @property
    def refused(self) -> int:
        """Number of frames of all sources that were skipped since they have another size or type."""
        return sum(one.refused for one in self.sources)

    @property
    def lost(self) -> str | None:
        """Reason why a source ended early, or None."""
        return next((one.lost for one in self.sources if one.lost), None)

    @property
    def interval(self) -> float:
        """Seconds between pairs."""
        return (2.0 if len(self.sources) == 1 else 1.0) * max(one.interval for one in self.sources)

    @property
    def live(self) -> bool:
        """True if a source is a camera or a stream."""
        return any(one.live for one in self.sources)

    def close(self) -> None:
        """Close the sources."""
        for one in self.sources:
            one.close()

    def _pair_alternating(self) -> Iterator[FramePair]:
        """Yield each even-numbered frame with the next; dropped frames are counted, so that near remains first."""
        (source,) = self.sources
        near_frame: VideoFrame | None = None
        first_number = next_number = -1
        order = _FocusOrder()
        for frame in source:
            first_number = source.number if first_number < 0 else first_number
            is_far = bool((source.number - first_number) % 2)
            if order.is_exchanged(frame.values, is_far):
                is_far, first_number = not is_far, first_number + 1
                source.dropped += 1
                if not order.exchanges:
                    self._report(
                        f"{source.name} lost a frame before {frame.time:.2f} s, though its times do not show it: the "
                        "frame there has the other focus. Near and far are put right from there on (further ones are "
                        "counted)"
                    )
                order.exchanges += 1
            if is_far and near_frame is not None and source.number == next_number:
                self.loss = np.maximum(getattr(near_frame, "loss", 0.0), source.loss)
                yield FramePair(near_frame.values, frame.values, near_frame.time)
                near_frame = None
                continue
            self.alone += (near_frame is not None) + is_far
            near_frame, next_number = None if is_far else frame, source.number + 1
        if near_frame is not None:
            self.alone += 1
            if source.lost is None:
                self._report(f"{source.name} ends inside a pair: its last frame was skipped")

    def _match_times(self) -> Iterator[FramePair]:
        """Yield pairs of frames of two sources whose times differ by at most half the shorter frame interval."""
        first, second = self.sources
        unpaired = 0
        a, b = next(first, None), next(second, None)
        while a is not None and b is not None:
            gap = b.time - a.time
            max_gap = 0.5 * min(first.interval, second.interval)
            if abs(gap) <= max_gap:
                unpaired = 0
                self.loss = np.maximum(first.loss, second.loss)
                yield FramePair(a.values, b.values, a.time)
                a, b = next(first, None), next(second, None)
                continue
            self.alone += 1
            unpaired += 1
            if unpaired == _MAX_UNPAIRED:
                self._report(
                    f"no frames of {first.name} and {second.name} are within {1e3 * max_gap:.3g} ms of each other, "
                    f"at {a.time:.3f} and {b.time:.3f} s: they were not recorded together, or their clocks differ"
                )
            if gap > 0.0:
                a = next(first, None)
            else:
                b = next(second, None)
        for ended, other, frame in ((first, second, b), (second, first, a)):
            if frame is not None and not ended.live and self.lost is None:
                self.alone += 1
                self._report(
                    f"{ended.name} ends before {other.name}, whose frame at {frame.time:.3f} s was skipped. Unless "
                    "it was stopped first, it lost frames that its times do not show: from there on pairs are of "
                    "different times, and what moves has a misfit"
                )


def video_frames(source: Source, *, grey: bool = False, tell: Report | None = None) -> VideoFrames:
    """Open a video file, a stream, a camera or numbered images as frames with their times.

    Parameters
    ----------
    source : int or path
        The number of a camera; a file; an address such as ``rtsp://camera/stream``; a folder of numbered images of
        one size, or a pattern of their names such as ``frames/%04d.tif``.
    grey : bool, default False
        Convert colours to grey (luma).
    tell : callable, optional
        Function that is called with a message for each error after which reading continues; by default a
        RuntimeWarning is issued.

    Returns
    -------
    VideoFrames

    Raises
    ------
    VideoError
        If the camera does not exist, or the source contains no video, or frames of more than 2^26 pixels.
    TypeError, ValueError
        If an argument is of another type.
    OSError, ImportError
        If the source cannot be read, or PyAV (files, streams) or OpenCV (cameras) is not installed.

    Examples
    --------
    >>> with lm.io.video_frames("clip.mkv", grey=True, tell=print) as video:  # doctest: +SKIP
    ...     brightness = [frame.values.mean() for frame in video]
    """
    grey = validation.truth("grey", grey)
    report = _warner(tell)
    if isinstance(source, str) and re.fullmatch(r"\d{1,3}", source):
        source = int(source)
    if isinstance(source, int | np.integer):
        number = validation.integer("source", source, least=0, most=999)
        return VideoFrames(_CameraReader(number, grey, report), report)
    if isinstance(source, str) and (scheme := re.match(r"([a-z]\w*)://", source, re.IGNORECASE)):
        if scheme[1].lower() not in _SCHEMES:
            raise ValueError(f"source must be of {', '.join(_SCHEMES)}, got {validation.shown(scheme[0])}")
        name = validation.line(re.sub(r"//[^/@]*@", "//", source))  # removes user name and password
        return VideoFrames(_PyavReader(source, name, True, grey, report), report)
    path = validation.path("source", source)
    if path.is_dir() or "%" in path.name:
        return VideoFrames(_ImageReader(path, grey, report), report)
    reading.size(path)  # raises an error for a pipe, on which reading would wait
    return VideoFrames(_PyavReader(fspath(path), validation.line(path), False, grey, report), report)


def frame_pairs(a: Source, b: Source | None = None, *, tell: Report | None = None) -> FramePairs:
    """Open pairs of grey frames that differ in focus, from two sources or from one with alternating focus.

    Parameters
    ----------
    a : int or path
        A source, as for :func:`video_frames`. Without a second source its frames alternate between two focus
        settings, beginning with that of the first lens. If the times or the sharpness of the frames show that a
        frame was dropped, the other frame of its pair is skipped.
    b : int or path, optional
        A second source: frames whose times differ by at most half a frame interval are pairs. Files state the times
        of their frames. Camera frames have their arrival times; stream frames have arrival times without jitter.
    tell : callable, optional
        As for :func:`video_frames`.

    Returns
    -------
    FramePairs

    Raises
    ------
    VideoError
        As for :func:`video_frames`, or if the frames of the two sources differ in size or type.
    TypeError, ValueError
        If an argument is of another type.
    OSError, ImportError
        As for :func:`video_frames`.

    Examples
    --------
    A robot logs frames that its cameras lost:

    >>> with lm.io.frame_pairs(0, 1, tell=logging.warning) as pairs:  # doctest: +SKIP
    ...     for near, far, seconds in pairs:
    ...         found = live(near, far)

    Of one camera whose focus alternates, in a program that has a log:

    >>> pairs = lm.io.frame_pairs(0, tell=logging.getLogger("depth").warning)  # doctest: +SKIP
    """
    report = _warner(tell)
    with ExitStack() as stack:
        sources = tuple(stack.enter_context(video_frames(x, grey=True, tell=report)) for x in (a, b) if x is not None)
        first, second = sources[0], sources[-1]
        if (first.shape, first.dtype) != (second.shape, second.dtype):
            sizes = " and ".join(f"{source.shape[1]} x {source.shape[0]} {source.dtype}" for source in sources)
            raise VideoError(f"{first.name} and {second.name} must have frames of one size and type, got {sizes}")
        stack.pop_all()
        return FramePairs(sources, report)


def _warner(tell: Report | None) -> Report:
    validation.function("tell", tell, required=False)
    return tell or (lambda sentence: warnings.warn(sentence, RuntimeWarning, stacklevel=3))


def _require_frame_size(name: str, width: int, height: int) -> None:
    if width * height > MAX_FRAME:
        raise VideoError(f"{name} has frames of {width} x {height} pixels; the limit is {MAX_FRAME} pixels")


# Attributes of each reader class: `interval`, seconds between frames, 0 if unknown; `levels`, number of levels,
# 0 for floats; `grey`, True without colour.
class _PyavReader:
    """A video file or a stream, read by PyAV."""

    def __init__(self, source: str, name: str, live: bool, grey: bool, tell: Report) -> None:
        self._av = optional.library("av", "reading video needs", "video")
        self.name, self.live, self._grey, self._report = name, live, grey, tell
        # A file may be a playlist: refuse network addresses in it.
        options = {"protocol_whitelist": "file"}
        if live:
            options = {"rtsp_transport": "tcp"} if source.lower().startswith("rtsp") else {}
        try:
            self._container: InputContainer = self._av.open(source, options=options, timeout=_TIMEOUT)
        except (self._av.FFmpegError, ValueError) as error:
            is_mp4 = source.lower().endswith((".mp4", ".mov", ".m4v")) and Path(source).is_file()
            hint = "; a file of this kind is unreadable if its end is missing: record to .mkv" if is_mp4 else ""
            raise VideoError(f"{name} cannot be read as video: {_reason(error)}{hint}") from None
        try:
            self._open()
        except BaseException:
            self.close()
            raise

    def _open(self) -> None:
        if not self._container.streams.video:
            raise VideoError(f"{self.name} holds no video")
        self._stream = self._container.streams.video[0]
        codec = self._stream.codec_context
        if codec is None:
            raise VideoError(f"{self.name} has video in an unknown format, or is truncated")
        _require_frame_size(self.name, codec.width, codec.height)
        codec.options = {"max_pixels": str(MAX_FRAME), "export_side_data": "venc_params"}
        # Frame threading would delay live frames, and frames of Motion JPEG after the packets with their tables. For
        # H.264 it may export quantization parameters that are not written yet.
        codec.thread_type = "SLICE" if self.live or codec.name in ("mjpeg", "h264") else "AUTO"
        # Trust the stated duration only for these formats, and only without another stream, which may be longer.
        trusted = len(self._container.streams) == 1 and re.search("matroska|mp4", self._container.format.name)
        self._duration = 1e-6 * (self._container.duration or 0) if trusted and not self.live else 0.0
        rate = self._stream.guessed_rate or self._stream.average_rate
        self.interval = float(1 / rate) if rate else 0.0
        try:
            form = self._av.VideoFormat(codec.pix_fmt or "")
        except ValueError:
            raise VideoError(f"{self.name} has an unknown pixel format") from None
        self.levels = 2 ** min(16, max(8, form.components[0].bits))
        self.grey = len(form.components) == 1 and not form.has_palette and not form.name.startswith("bayer")
        high_depth, to_grey = self.levels > 256, self.grey or self._grey
        self._form = ("gray16le" if high_depth else "gray") if to_grey else "rgb48le" if high_depth else "rgb24"

    def frames(self) -> Iterator[VideoFrame]:
        """Yield all frames."""
        packets = self._packets()
        reported, faults, number, end_time = False, 0, 0, 0.0
        # Times of a stream have an arbitrary origin: add the smallest recent (arrival - time), since clocks drift.
        delays: deque[float] = deque([] if self.live else [0.0], maxlen=_DELAY_FRAMES)
        while True:
            try:
                packet = next(packets)
            except (StopIteration, EOFError):
                if self._duration - end_time > max(3.0 * self.interval, _MISSING_FRACTION * self._duration):
                    raise VideoError(
                        f"{self.name} breaks off at {end_time:.2f} s of {self._duration:.2f} s"
                    ) from None
                return
            except self._av.FFmpegError as error:
                raise VideoError(f"{self.name} breaks off after {number} frames: {_reason(error)}") from None
            try:
                decoded = packet.decode()
            except self._av.FFmpegError as error:
                faults += 1
                if not reported:
                    reported = True
                    self._report(
                        f"{self.name} is damaged after {number} frames ({_reason(error)}): reading continues"
                    )
                if faults > _MAX_FAULTS:
                    raise VideoError(f"{self.name} is damaged: {_reason(error)}") from None
                continue
            for frame in decoded:
                faults = 0
                seconds = number * (self.interval or 1.0 / USUAL_RATE) if frame.time is None else frame.time
                if self.live:
                    delays.append(time.monotonic() - seconds)
                number += 1
                end_time = max(end_time, seconds + self.interval)
                values = frame.to_ndarray(format=self._form)
                yield _CodedFrame.of(values, seconds + min(delays), self._loss(packet, frame))

    def _loss(self, packet: Packet[VideoStream], frame: av.VideoFrame) -> float | Values:
        """Return the loss of a frame of a packet; see :class:`VideoFrames`."""
        context = self._stream.codec_context
        if context.name == "mjpeg":
            return _jpeg_loss(bytes(packet))
        encoding: Any = frame.side_data.get("VIDEO_ENC_PARAMS")
        if encoding is None or context.name != "h264":
            return math.inf if context.codec.lossy else 0.0
        parameter = encoding.qp_map().astype(np.float64)
        parameter[parameter > _LAST_UNFILTERED + 6.0 * math.log2(self.levels / 256)] = np.inf
        # As if of limited range: at most 36 % too large.
        step = 0.625 * 2.0 ** (parameter / 6.0) / (219.0 / 255.0 * (self.levels - 1))
        return np.asarray(step**2 / 12.0 * (1.0 if frame.pict_type == 1 else _PREDICTED_LOSS))

    def _packets(self) -> Iterator[Packet[VideoStream]]:
        return self._container.demux(self._stream)

    def close(self) -> None:
        """Close the file or stream."""
        self._container.close()


def _jpeg_loss(data: bytes) -> float:
    """Return the loss by the first quantization table of a JPEG image, which is that of the luma."""
    start = data.find(b"\xff\xdb") + 5
    if start < 5 or len(data) < start + 128:
        return math.inf
    table = np.frombuffer(data, ">u2" if data[start - 1] >> 4 else "u1", 64, start)
    return float(np.square(table, dtype=np.float64).mean()) / 12.0 / 255.0**2


def _reason(error: Exception) -> str:
    return validation.brief(getattr(error, "strerror", None) or reading.reason(error))


class _CameraReader:
    """A camera, identified by its number and read by OpenCV."""

    live, levels, grey = True, 256, False

    def __init__(self, number: int, grey: bool, tell: Report) -> None:
        self._cv2 = optional.library("cv2", "cameras need", "video")
        self._cv2.utils.logging.setLogLevel(0)  # errors are raised as exceptions instead
        self.name, self._grey = f"camera {number}", grey
        self._capture = self._cv2.VideoCapture(number)
        if not self._capture.isOpened():
            raise VideoError(f"{self.name} cannot be opened: no camera has this number, or it is in use")
        rate = self._capture.get(self._cv2.CAP_PROP_FPS)
        self.interval = 1.0 / rate if 0.0 < rate < 1e4 else 0.0
        code = int(self._capture.get(self._cv2.CAP_PROP_FOURCC)) & 0xFFFFFFFF
        self._loss = math.inf if code.to_bytes(4, "little") in _LOSSY else 0.0
        if self._loss:
            tell(
                f"{self.name} compresses its frames with loss (Motion JPEG, H.264 or H.265): fine texture may be lost"
            )

    def frames(self) -> Iterator[VideoFrame]:
        """Yield all frames, with their times of arrival."""
        while self._capture.grab():
            arrival_time = time.monotonic()
            is_valid, values = self._capture.retrieve()
            if not is_valid:
                break
            _require_frame_size(self.name, *values.shape[1::-1])
            order = self._cv2.COLOR_BGR2GRAY if self._grey else self._cv2.COLOR_BGR2RGB
            values = values if values.ndim == 2 else self._cv2.cvtColor(values, order)
            yield _CodedFrame.of(values, arrival_time, self._loss)
        raise VideoError(f"{self.name} gives no more frames: it was unplugged, or stopped")

    def close(self) -> None:
        """Release the camera."""
        self._capture.release()


class _ImageReader:
    """Numbered images; the time of an image is its number times `interval`."""

    live, interval = False, 1.0 / USUAL_RATE

    def __init__(self, path: Path, grey: bool, tell: Report) -> None:
        self.name, self._grey, self._report = validation.line(path), grey, tell
        folder, pattern = (path, r".*?(\d+)\D*\.\w+") if path.is_dir() else (path.parent, _number_pattern(path.name))
        suffixes = {suffix for photo_format in registry.formats("photo") for suffix in photo_format.suffixes}
        images = (file for file in folder.iterdir() if file.suffix.lower() in suffixes)
        matches = ((re.fullmatch(pattern, file.name, re.ASCII), file) for file in images)
        self._files = sorted((int(match[1]), file) for match, file in matches if match)
        if not self._files:
            raise VideoError(f"{self.name} has no numbered images")
        first = photos.read_photo(self._files[0][1])
        self.exif = first.exif
        values, self.encoding = self._frame(self._files[0][1], first.values), first.encoding if first.stated else None
        self.levels = 0 if values.dtype.kind == "f" else 2 ** (8 * values.dtype.itemsize)
        self.grey = values.ndim == 2

    def _frame(self, path: Path, values: Values) -> Values:
        """Return the values of an image as those of a frame."""
        _require_frame_size(validation.line(path), *values.shape[1::-1])
        if self._grey and values.ndim == 3:
            luma = values @ np.array([0.299, 0.587, 0.114])
            values = (luma if values.dtype.kind == "f" else np.rint(luma)).astype(values.dtype)
        return values.astype(np.float32) if values.dtype.kind == "f" else values

    def frames(self) -> Iterator[VideoFrame]:
        """Yield all readable images; a message names the first image that cannot be read."""
        reported = False
        for number, path in self._files:
            try:
                values = self._frame(path, photos.read_raster(path)[0])
            except (OSError, ValueError) as error:
                if not reported:
                    reported = True
                    self._report(f"{validation.line(path)} is skipped: {_reason(error)}")
                continue
            loss = _jpeg_loss(path.read_bytes()) if path.suffix.lower() in (".jpg", ".jpeg") else 0.0
            yield _CodedFrame.of(values, number * self.interval, loss)

    def close(self) -> None:
        """Do nothing, since no file is kept open."""


def _number_pattern(name: str) -> str:
    """Return a regular expression for the file names of a pattern with one number, such as frames-%04d.tif."""
    parts = re.split(r"%0?\d?d", name)
    if len(parts) != 2 or "%" in "".join(parts):
        raise ValueError(f"source must have one number such as %04d and no other %, got {validation.shown(name)}")
    return r"(\d+)".join(map(re.escape, parts))


class VideoWriter:
    """Write frames with their times to NAME.unfinished.EXT, which is moved into place at the end.

    Each frame is in the file when the next one is written: if the process is killed, only the last one is lost. After
    an error the unfinished file is kept, unless it has no frame.

    Parameters
    ----------
    path : Path
    interval : float
        Approximate seconds between frames, from which the encoder sets its bit rate.
    comment : str, default ""
        Comment in the metadata.
    form : str
        Name of the container format.

    Notes
    -----
    uint8, grey or RGB: H.264 (MPEG-4 if PyAV lacks it), padded to even sides, without frames that the encoder holds
    back to look ahead. uint16, grey: FFV1, lossless.
    """

    def __init__(self, path: Path, interval: float, comment: str = "", *, form: str) -> None:
        self._path, self._form, self._comment = path, form, comment
        self._rate = Fraction(min(max(1.0 / interval, 0.1), 1000.0)).limit_denominator(1001)
        self._last_time = -1
        self._stack = ExitStack()
        self._container: OutputContainer | None = None

    def __enter__(self) -> Self:
        return self

    def __call__(self, values: Values, seconds: float) -> None:
        """Write a frame."""
        import av

        if self._container is None:
            self._open(values)
        assert self._container is not None
        grey = "gray16le" if values.dtype == np.uint16 else "gray"
        if values.dtype == np.uint8 and (padding := [side % 2 for side in values.shape[:2]]) != [0, 0]:
            values = np.pad(values, [(0, rows) for rows in padding] + [(0, 0)] * (values.ndim - 2), mode="edge")
        frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(values), format="rgb24" if values.ndim == 3 else grey)
        self._last_time = frame.pts = max(round(1e3 * seconds), self._last_time + 1)
        frame.time_base = Fraction(1, 1000)
        with atomic.as_path_error(self._path):
            self._container.mux(self._stream.encode(frame))
        self._recording.started = True

    def _open(self, values: Values) -> None:
        import av

        self._recording = self._stack.enter_context(atomic.recording(self._path))
        place, flushed = str(self._recording.path), _FLUSHED[self._form]
        container = self._stack.enter_context(
            atomic.closed(lambda: av.open(place, "w", format=self._form, container_options=flushed), self._path)
        )
        container.metadata["comment"] = self._comment
        is_16_bit = values.dtype == np.uint16
        lossy_codec = "libx264" if "libx264" in av.codecs_available else "mpeg4"
        options = _H264 if lossy_codec == "libx264" and not is_16_bit else {}
        stream = container.add_stream("ffv1" if is_16_bit else lossy_codec, rate=self._rate, options=options)
        assert isinstance(stream, av.VideoStream)
        height, width = values.shape[:2]
        stream.height, stream.width = (height, width) if is_16_bit else (height + height % 2, width + width % 2)
        stream.pix_fmt = "gray16le" if is_16_bit else "yuv420p"
        stream.codec_context.time_base = Fraction(1, 1000)
        if lossy_codec == "mpeg4" and not is_16_bit:
            stream.bit_rate = 8 * width * height
        self._container, self._stream = container, stream

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if kind is None and self._container is not None:
            try:
                with atomic.as_path_error(self._path):
                    self._container.mux(self._stream.encode(None))
            except BaseException as fault:
                self._stack.__exit__(type(fault), fault, fault.__traceback__)
                raise
        self._stack.__exit__(kind, error, trace)


_video = partial(Format, "video", library="av")
registry.register(
    _video(
        (".mkv",),
        partial(VideoWriter, form="matroska"),
        holds=("of uint8", "of uint16"),
        what="Matroska: H.264, or FFV1 of 16 bits",
    ),
    _video((".mp4",), partial(VideoWriter, form="mp4"), holds=("of uint8",), what="MPEG-4: H.264"),
)
find = partial(registry.find, "video")
