"""The command ``lommel watch``: depth from defocus for video."""

from __future__ import annotations

import csv
import math
import os
import sys
import time
from collections import deque
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType
from typing import Annotated, ClassVar, Literal, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic, optional, validation
from lommel.base.encoding import from_light
from lommel.base.options import In, Options, Shown
from lommel.base.units import percent
from lommel.cli.command import OUTPUT, command
from lommel.cli.depth_commands import BETWEEN, PairCamera, each_lens, lens_facts, verdict_report
from lommel.cli.instruments import FrameNoise
from lommel.cli.messages import with_options
from lommel.cli.output import Steps, progress, require_folder, written
from lommel.cli.video_input import Coding, Stop, coding_of, equalize_rows
from lommel.imaging import LiveDepth
from lommel.imaging.defocus_verdict import DefocusVerdict
from lommel.imaging.focal_engine import BLOCK, Magnified
from lommel.io import videos
from lommel.report import Facts, Report, Wrapped, finite
from lommel.report.table import told
from lommel.show.estimates import DepthColours

Map = NDArray[np.float32]

_WHITE_PERCENTILE = 99.5  # percentile of the first all-in-focus image that is shown as white, for linear video
_MAX_PAIRS = 2**16  # number of the most recent pairs over which statistics are computed
_JUMP = 6.0  # change of the median depth from pair to pair that is reported, in standard errors of a block
_COMPRESSION_PAIRS = 25  # number of pairs after which strong compression is reported; for fewer pairs, at the end
_MAX_LEVEL = 65535  # largest level of lossless depth
_CURVE_LEVELS = 4096  # number of levels of linear light in the sRGB lookup table
_COLUMNS = ["time (s)", "known", "unfit", "depth (m)", "error (m)", "misfit", "frame time (s)", "dropped"]


class PairResult(NamedTuple):
    """The depth of a pair of frames.

    A block is known if it has a depth and a misfit up to the limit, and unfit if it has a depth and a larger misfit.
    """

    time: float  # time of the pair since the first pair, seconds
    depth: Map | None  # metres, NaN in blocks that are not known
    errors: Map | None  # standard errors of depth, metres, infinite in blocks that are not known
    image: Map | None  # all-in-focus image, electrons
    known: float  # fraction of the blocks that are known
    unfit: float  # fraction of the blocks that are unfit
    median: tuple[float, float, float]  # of known blocks: depth, standard error; of blocks with depth: misfit; or NaN
    duration: float  # time of the computation, seconds
    electrons: float  # mean electrons per pixel


@dataclass(frozen=True, kw_only=True)
class Files(Options):
    """Output files.

    Parameters
    ----------
    output
        Video of the depth in colours: .mkv or .mp4; without it a window opens where there is a display, which q or
        Esc closes.
    sharp
        Show the all-in-focus image beside the depth.
    depths
        Lossless video of the depth, .mkv: a pixel for each block of 4 x 4 pixels, in levels of the power of ten
        metres that the report states, 0 where it is not known; given a second time, its standard error.
    table
        Table with a row for each pair: .csv.
    """

    heading: ClassVar[str] = "Output"
    output: Annotated[Path | None, OUTPUT] = None
    sharp: bool = False
    depths: Annotated[tuple[Path, ...], Shown(("--depth",), metavar="FILE", writes=True)] = ()
    table: Annotated[Path | None, Shown(metavar="FILE", writes=True)] = None

    def require(self) -> None:
        """Raise ValueError or OSError if an output cannot be written, before any source is opened."""
        if self.output is not None:
            videos.find(self.output, "--output", holding="of uint8")
        if len(self.depths) > 2:
            raise ValueError(f"--depth takes depth and its standard error, got {len(self.depths)} files")
        for path in self.depths:
            videos.find(path, "--depth", holding="of uint16")
        if self.table is not None and self.table.suffix.lower() != ".csv":
            raise ValueError(f"--table must end in .csv, got {validation.shown(str(self.table))}")
        for path in self.all:
            require_folder(path)

    @property
    def all(self) -> list[Path]:
        """Paths of all output files."""
        return [path for path in (self.output, *self.depths, self.table) if path is not None]


@command
def watch(
    lens: Path,
    /,
    *,
    sources: Annotated[tuple[str, ...], Shown(("--source",), metavar="SOURCE")],
    between: Annotated[tuple[float, float], BETWEEN],
    alternating: bool = False,
    encoding: Literal["srgb", "linear"] | None = None,
    misfit: Annotated[float, In(least=1.0, infinite=True)] = 2.0,
    files: Files = Files(),
    cameras: PairCamera = PairCamera(),
    registration: Magnified = Magnified(),
    video_noise: FrameNoise = FrameNoise(),
) -> Report:
    """Estimate depth of video from frames with different focus.

    LENS is a lens file. The frames come from two cameras or files, or from one whose focus alternates. Depth and its
    standard error are computed for blocks of 4 x 4 pixels; colours are converted to grey. Ctrl-C, SIGTERM or a closed
    terminal ends the command and leaves complete files. Until then depth.mkv is depth.unfinished.mkv, which plays if
    the process is killed.

    Parameters
    ----------
    sources
        Number of a camera, a video file, an address such as rtsp://camera/stream, or numbered images: a folder or a
        pattern such as frames/%04d.tif. Given twice, frames of the same time are pairs.
    between
        Nearest and farthest distance to search, such as 1m 3m or 1m inf.
    alternating
        The frames of one source alternate between two focus settings.
    encoding
        Encoding of the values; by default grey of more than 8 bits and floats are linear, all else is sRGB.
    misfit
        Largest misfit of blocks whose depth counts as known: 1 where only noise is left; inf for all.

    Examples
    --------
      lommel watch phone.toml --source near.mkv --source far.mkv --focus 1.3m --focus 2m --between 1m 3m -o depth.mkv
      lommel watch phone.toml --source both.mp4 --alternating --focus 1.3m --focus 2m --between 1m 3m --table d.csv
    """
    with Stop().signals() as stop:
        _require_two(sources, alternating=alternating)
        instrument = cameras.instrument(lens)
        lenses = each_lens(instrument.lens, 2, cameras.foci, cameras.f_numbers, "frames")
        if lenses[0] == lenses[1]:
            raise ValueError(
                "--focus must be given for each of two frames, or --f-number: the frames must differ in one of these"
            )
        files.require()
        tally = Tally()
        with progress("opening the sources", endless=True) as status, ExitStack() as stack:
            pairs = stack.enter_context(videos.frame_pairs(*sources, tell=status.tell))
            coding = coding_of(pairs.levels, pairs.dtype, pairs.encoding, video_noise, instrument.camera, encoding)
            if coding.guess:
                status.tell(coding.guess)
            status("computing the filters of every distance")
            live = LiveDepth(
                lenses,
                instrument.side,
                between=between,
                noise=coding.noise,
                shape=pairs.shape,
                exposures="smooth",
                magnification=registration.magnification,
                saturation=coding.saturation,
                sharp=files.sharp,
            )
            estimator = Estimator(live, coding, misfit, sharp=files.sharp)
            outputs = stack.enter_context(Outputs(files, between, pairs, coding))
            end_reason = _estimate_all(pairs, estimator, outputs, tally, status, stop, alternating=alternating)
            status("finishing")
            bits, compression = coding.check_compression(pairs.bits, tally.electrons)
            if compression and tally.pairs < _COMPRESSION_PAIRS:
                status.tell(compression)
            if not tally.pairs:
                if stop.requested:
                    raise KeyboardInterrupt
                raise ValueError(f"no pair of frames came: {end_reason}; check that the times of the sources overlap")
        facts = {
            **coding.facts,
            **bits,
            "shape": list(pairs.shape),
            "pixel": instrument.side,
            **lens_facts(lenses),
            "between": [finite(distance) for distance in between],
            "magnification": registration.magnification,
            "design_error": live.design_error,
            **_counts(tally, pairs, end_reason),
            **tally.summary(),
            **outputs.facts,
        }
        notes = [text for text in (coding.guess, compression, tally.unknown(misfit)) if text]
        verdict = DefocusVerdict.of(math.nan) if tally.failed == tally.pairs else live.verdict()
        if math.isnan(verdict.misfit) and facts["misfit"] is not None:  # of earlier pairs: the last one has no depth
            verdict = DefocusVerdict.of(facts["misfit"])
        return (
            told(facts, succeeded=pairs.lost is None)
            + Report({}, [Wrapped(note) for note in notes])
            + verdict_report(verdict)
            + written(files.all)
        )


def _require_two(sources: tuple[str, ...], *, alternating: bool) -> None:
    """Raise ValueError unless there are two sources, or one source whose focus alternates."""
    if len(sources) != (1 if alternating else 2):
        also = " and --alternating" if alternating else ""
        raise ValueError(f"--source must be given twice, or once with --alternating; got {len(sources)}{also}")
    if len(set(sources)) < len(sources):
        raise ValueError(f"--source must be two cameras or files, or one with --alternating; got {sources[0]} twice")


def _estimate_all(
    pairs: videos.FramePairs,
    estimator: Estimator,
    outputs: Outputs,
    tally: Tally,
    status: Steps,
    stop: Stop,
    *,
    alternating: bool,
) -> str:
    """Estimate and write the depth of all pairs; return the reason why the pairs ended."""
    tally.start = time.perf_counter()
    closed = False
    while not closed and (pair := stop.next(pairs)) is not None:
        result, failure = estimator(pair)
        if failure and not tally.failed:
            status.tell(f"no depth at {result.time:.2f} s: {failure} (further pairs without depth are counted)")
        if alternating and not tally.jump_note and (jump := tally.jump(result)):
            status.tell(jump)
        tally.add(result, bool(failure))
        if tally.pairs == _COMPRESSION_PAIRS:
            _, compression = estimator.coding.check_compression(pairs.bits, tally.electrons)
            if compression:
                status.tell(compression)
        closed = outputs(result)
        if not closed:
            status(tally.progress(pairs.dropped))
    tally.stop = time.perf_counter()
    return "interrupted" if stop.requested else pairs.lost or ("the window was closed" if closed else "the end")


def _default_scale(far: float) -> float:
    """Return the smallest power of ten (metres per level) whose 65535 levels reach `far`; 1 mm for infinity."""
    return 1e-3 if math.isinf(far) else float(10.0 ** math.ceil(math.log10(far / _MAX_LEVEL)))


@dataclass
class Estimator:
    """Depth estimator for pairs of frames."""

    live: LiveDepth
    coding: Coding
    limit: float  # largest misfit of blocks whose depth is known
    sharp: bool  # True to compute all-in-focus images
    first_time: float = math.nan  # time of the first pair

    def __call__(self, pair: videos.FramePair) -> tuple[PairResult, str]:
        """Return (1) the depth of a pair and (2) "", or the reason why it has no depth (such as a black frame)."""
        self.first_time = pair.time if math.isnan(self.first_time) else self.first_time
        elapsed, start = pair.time - self.first_time, time.perf_counter()
        try:
            frames = self.coding.light(pair.first), self.coding.light(pair.second)
            estimate = self.live(*equalize_rows(*frames, self.coding))
        except ValueError as error:
            duration = time.perf_counter() - start
            failure = with_options(str(error))
            for k, name in enumerate(("the first frame", "the second frame")):
                failure = failure.replace(f"frames[{k}]", name)
            return PairResult(elapsed, None, None, None, 0.0, 0.0, (math.nan,) * 3, duration, math.nan), failure
        image = self.live.sharp() if self.sharp else None
        duration = time.perf_counter() - start
        depth, errors, misfit = estimate.depth, estimate.errors, estimate.misfit
        estimated = np.isfinite(errors)
        is_known = estimated & (misfit <= self.limit)
        median = _median(depth[is_known]), _median(errors[is_known]), _median(misfit[estimated])
        depth[~is_known], errors[~is_known] = np.nan, np.inf
        fraction, unfit = float(is_known.mean()), float((estimated & ~is_known).mean())
        return PairResult(elapsed, depth, errors, image, fraction, unfit, median, duration, estimate.light), ""


def _median(values: Map) -> float:
    return float(np.median(values)) if values.size else math.nan


@dataclass
class Tally:
    """Statistics of the pairs so far."""

    start: float = 0.0  # begin of the computation on the clock of time.perf_counter, seconds
    stop: float = 0.0  # end of the computation on the same clock
    pairs: int = 0
    failed: int = 0  # number of pairs without depth
    durations: deque[float] = field(default_factory=lambda: deque(maxlen=_MAX_PAIRS))  # seconds
    rows: deque[tuple[float, ...]] = field(default_factory=lambda: deque(maxlen=_MAX_PAIRS))  # known, unfit, *median
    electrons: float = math.nan  # mean electrons per pixel of the last pair with depth
    jump_note: str = ""  # sentence on a jump of depth, or ""

    def jump(self, result: PairResult) -> str:
        """Set and return `jump_note` if the median depth jumps, as it does after the loss of one frame."""
        depth, error = result.median[:2]
        before = self.rows[-1][2] if self.rows else math.nan
        if abs(depth - before) > _JUMP * error:
            self.jump_note = (
                f"Depth jumps at {result.time:.2f} s, from {before:.4g} to {depth:.4g} m: if nothing in the scene "
                "moved, a frame was lost, and near and far have been exchanged since then."
            )
        return self.jump_note

    def add(self, result: PairResult, failed: bool) -> None:
        """Count a pair."""
        self.pairs += 1
        self.failed += failed
        self.durations.append(result.duration)
        self.electrons = self.electrons if failed else result.electrons
        self.rows.append((result.known, result.unfit, *result.median))

    def progress(self, dropped: int) -> str:
        """Return the line of progress."""
        rate = self.pairs / (time.perf_counter() - self.start)
        known, _, depth, error, misfit = self.rows[-1]
        text = f"{self.pairs} pairs, {rate:.3g}/s, {1e3 * self.durations[-1]:.3g} ms; dropped {dropped}"
        if known:
            text += f"; {percent(known)} {depth:.4g} m +- {1e3 * error:.2g} mm, misfit {misfit:.2f}"
        return text

    def summary(self) -> Facts:
        """Return mean fractions, and the medians of depth, standard error and misfit."""
        rows = np.array(self.rows)
        known, unfit = rows[:, :2].mean(axis=0).tolist()
        medians = (_median(column[np.isfinite(column)]) for column in rows.T[2:])
        values = (None if math.isnan(value) else value for value in medians)
        named = dict(zip(("depth", "error", "misfit"), values, strict=True))
        return {"known": known, "unfit": unfit, "jump": self.jump_note or None} | named

    def unknown(self, limit: float) -> str:
        """Return a sentence on blocks that are not known, or on the lack of depth; "" if there is nothing to say."""
        known, unfit = np.array(self.rows)[:, :2].mean(axis=0).tolist()
        if unfit:
            return (
                f"not known for a misfit above {limit:g} (--misfit): {100.0 * unfit:.2g} % of the blocks; causes: "
                "motion from frame to frame, depth edges, different magnification (--magnification lens)"
            )
        if self.failed == self.pairs:
            return "no depth found: no pair could be used, for the reason given at the first pair"
        return "" if known else "no depth found: the frames have no texture, or all of it is out of range"


def _counts(tally: Tally, pairs: videos.FramePairs, ended: str) -> Facts:
    """Return computation times, and the numbers of frames and pairs that were not used."""
    seconds = tally.stop - tally.start
    median_time, slow_time = np.percentile(tally.durations, [50.0, 95.0]).tolist()
    return {
        "pairs": tally.pairs,
        "seconds": seconds,
        "pairs_per_second": tally.pairs / seconds,
        "frame_time": {"median": median_time, "95 %": slow_time},
        "interval": pairs.interval,
        "ended": ended,
        "frames_dropped": pairs.dropped,
        "frames_without_a_partner": pairs.alone,
        "frames_of_another_size": pairs.refused,
        "pairs_without_depth": tally.failed,
    }


class Outputs:
    """Outputs for each pair: a video in colours, lossless depth, a table and a window."""

    def __init__(self, files: Files, between: tuple[float, float], pairs: videos.FramePairs, coding: Coding) -> None:
        height, width = pairs.shape
        self._files, self._between, self._pairs = files, between, pairs
        self._blocks = height // BLOCK, width // BLOCK
        self._scale = _default_scale(between[1])  # metres per level
        self._shows = files.output is None and not no_window()
        coloured = files.output is not None or self._shows
        self._colours = DepthColours(between, (height, width), BLOCK, files.sharp) if coloured else None
        self._curve = from_light(np.linspace(0.0, 1.0, _CURVE_LEVELS, dtype=np.float32), "srgb", np.uint8)
        # Linear video may be far darker than its white: `_grey` then sets the white from the first image.
        self._white = coding.white if coding.encoding == "srgb" else math.nan
        self._stack, self._clipped = ExitStack(), 0  # _clipped: number of values above the largest level

    def __enter__(self) -> Self:
        files, interval = self._files, self._pairs.interval

        def open_writer(path: Path, title: str) -> videos.VideoWriter:
            writer: videos.VideoWriter = self._stack.enter_context(videos.find(path).write(path, interval, title))
            return writer

        level = f"metres per level {self._scale:g}, 0 where not known"
        self._colour_video = None if files.output is None else open_writer(files.output, "depth")
        titles = (f"depth: {level}", f"standard error of depth: {level}")
        self._lossless = [open_writer(*arguments) for arguments in zip(files.depths, titles, strict=False)]
        self._table = None if files.table is None else Table(files.table, self._stack)
        self._window = Window("lommel watch", self._stack) if self._shows else None
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._stack.__exit__(kind, error, trace)

    def __call__(self, result: PairResult) -> bool:
        """Write and show the result of a pair; return True if the window has been closed."""
        if self._table is not None:
            values = (result.known, result.unfit, *result.median)
            numbers = ["" if math.isnan(value) else f"{value:.6g}" for value in values]
            self._table([f"{result.time:.4f}", *numbers, f"{result.duration:.5f}", self._pairs.dropped])
        for writer, metres in zip(self._lossless, (result.depth, result.errors), strict=False):
            writer(self._levels(metres), result.time)
        if self._colours is None:
            return False
        unknown = np.full(self._blocks, np.nan, np.float32)
        image = None if result.image is None else self._grey(result.image)
        picture = self._colours(unknown if result.depth is None else result.depth, image)
        if self._colour_video is not None:
            self._colour_video(picture, result.time)
        return self._window is not None and self._window(picture, None if self._pairs.live else result.time)

    def _levels(self, metres: Map | None) -> NDArray[np.uint16]:
        """Return metres as levels, 1 to 65535 or 0 where not known; count the values above the largest level."""
        if metres is None:
            return np.zeros(self._blocks, np.uint16)
        is_known = np.isfinite(metres)
        levels = np.rint(np.where(is_known, metres, 0.0) / self._scale)
        self._clipped += int(np.count_nonzero(levels > _MAX_LEVEL))
        return np.where(is_known, np.clip(levels, 1, _MAX_LEVEL), 0).astype(np.uint16)

    def _grey(self, electrons: Map) -> NDArray[np.uint8]:
        """Return an all-in-focus image in sRGB; white is as in sRGB video, or set by the first linear image."""
        if math.isnan(self._white):
            self._white = max(float(np.percentile(electrons, _WHITE_PERCENTILE)), 1.0)
        levels = np.clip(electrons * ((_CURVE_LEVELS - 1) / self._white), 0.0, _CURVE_LEVELS - 1.0)
        return np.asarray(self._curve[levels.astype(np.uint16)])

    @property
    def facts(self) -> Facts:
        """Metres per level of lossless depth, and the number of values beyond the last level."""
        return {"depth_scale": self._scale, "beyond_scale": self._clipped} if self._files.depths else {}


class Table:
    """Table with a row for each pair: written row by row to NAME.unfinished.csv, which is renamed at the end."""

    def __init__(self, path: Path, stack: ExitStack) -> None:
        self._path, self._stack = path, stack
        self._recording: atomic.Recording | None = None

    def __call__(self, row: list[object]) -> None:
        """Write a row."""
        if self._recording is None:  # no file before the first row: it could be left empty
            self._recording = self._stack.enter_context(atomic.recording(self._path))
            place = self._recording.path
            line_buffered = atomic.closed(lambda: place.open("w", 1, encoding="utf-8", newline=""), self._path)
            self._rows = csv.writer(self._stack.enter_context(line_buffered))
            self._rows.writerow(_COLUMNS)
        with atomic.as_path_error(self._path):
            self._rows.writerow(row)
            self._recording.added()


class Window:
    """OpenCV window for pictures; q, Esc and the close button of the window close it."""

    def __init__(self, title: str, stack: ExitStack) -> None:
        self._cv2, self._title = optional.library("cv2", "a window needs", "video"), title
        self._start = math.nan
        stack.callback(self._cv2.destroyAllWindows)

    def __call__(self, picture: NDArray[np.uint8], end_time: float | None) -> bool:
        """Show a picture until `end_time`, seconds after the first picture; return True if the window was closed."""
        now = time.monotonic()
        if math.isnan(self._start):
            self._start = now
        delay = 0.0 if end_time is None else self._start + end_time - now
        self._cv2.imshow(self._title, picture[..., ::-1])
        key = self._cv2.waitKey(max(1, round(1e3 * delay))) & 0xFF
        return key in (27, ord("q")) or self._cv2.getWindowProperty(self._title, self._cv2.WND_PROP_VISIBLE) < 1.0


def no_window() -> str:
    """Return the reason why no window can be shown, or ""."""
    if sys.platform == "linux" and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        return "there is no display"
    try:
        cv2 = optional.library("cv2", "a window needs", "video")
    except ImportError as error:
        return str(error)
    if cv2.currentUIFramework():
        return ""
    return "this OpenCV has no windows: pip uninstall opencv-python-headless, then pip install opencv-python"
