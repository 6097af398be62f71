"""The commands on video: ``watch`` (depth from defocus) and ``sharpen`` (deblurring), also of photos."""

from __future__ import annotations

import csv
import math
import os
import sys
import time
from collections import Counter, deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel import imaging
from lommel.base import atomic, optional, validation
from lommel.base.arrays import Array, Values, plain
from lommel.base.encoding import Encoding, from_light, warn_if_bright
from lommel.base.options import In, Options, Shown, filled
from lommel.base.units import percent, with_error
from lommel.cli import video_faults
from lommel.cli.command import ENCODING, OUTPUT, command
from lommel.cli.instruments import FrameNoise, PhotoCamera, radial_instrument, states_noise, tell_optics
from lommel.cli.interrupts import Stop
from lommel.cli.messages import given_flags, with_options
from lommel.cli.output import Steps, progress, require_file, require_folder, written
from lommel.cli.photo_commands import (
    BETWEEN,
    PairCamera,
    depth_facts,
    each_lens,
    lens_facts,
    output_type,
    verdict_report,
    with_calibration,
)
from lommel.cli.video_coding import DEFAULT_READ, DEFAULT_WHITE, Coding, coding_of
from lommel.fit.findings import Findings
from lommel.imaging import LiveDepth, LiveSharpen
from lommel.imaging.blur import warn_of_depths
from lommel.imaging.defocus_verdict import MIN_BLOCKS, DefocusVerdict, noise_finding
from lommel.imaging.edge_chart import middle_edge, shared_findings
from lommel.imaging.focal_engine import BLOCK, MAX_KNOWN_ERROR
from lommel.imaging.live import LiveDepthMap
from lommel.imaging.pair_noise import without_rounding
from lommel.io import photos, videos
from lommel.io.depth_maps import fill_missing
from lommel.io.registry import formats, suffixes
from lommel.recorded.noise import Noise
from lommel.report import Facts, Report, Wrapped, finite
from lommel.report.table import told
from lommel.show.estimates import DepthColours

if TYPE_CHECKING:
    from lommel.optics.lens import Lens

Map = NDArray[np.float32]

_WHITE_PERCENTILE = 99.5  # percentile of the first all-in-focus image that is shown as white, for linear video
_MAX_PAIRS = 2**16  # number of the most recent pairs over which statistics are computed
_SAID_EVERY = 1.0  # seconds of video after which the sharpness is printed again
_MAX_LEVEL = 65535  # largest level of lossless depth
_CURVE_LEVELS = 4096  # number of levels of linear light in the sRGB lookup table
_COLUMNS = ["time (s)", "known", "unfit", "depth (m)", "error (m)", "misfit", "frame time (s)", "dropped"]

_DARK_ROW = 0.1  # fraction of the mean brightness of rows: darker rows are not equalized
_TEST_ROWS = 16  # number of pairs after which it is tested again whether equalized rows lower the misfit
_WORSE = 0.1  # increase of the mean logarithm of the misfit after which it is tested at once
_RANGE_MARGIN = 1e-3  # relative margin of the range of the filters beyond the distances
_MAX_NEAREST = 1e9  # metres: largest nearest distance of filters, practically infinity


class PairResult(NamedTuple):
    """The depth of a pair of frames, or the `failure`, the reason why it has none.

    A block is known if it has a depth and a misfit up to the limit, and unfit if it has a depth and a larger misfit.
    """

    time: float  # time of the pair since the first pair, seconds
    duration: float  # time of the computation, seconds
    failure: str = ""
    depth: Map | None = None  # metres, NaN in blocks that are not known
    errors: Map | None = None  # standard errors of depth, metres, infinite in blocks that are not known
    image: Map | None = None  # all-in-focus image, electrons
    # Fractions of known and of unfit blocks; medians of depth and error of known blocks, of the misfit; or NaN.
    numbers: tuple[float, float, float, float, float] = (0.0, 0.0, math.nan, math.nan, math.nan)
    unknown: Mapping[str, float] = MappingProxyType({})  # fractions of blocks that are not known, by cause


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
        require_file(self.table, ".csv", "--table")
        for path in filter(None, (self.output, *self.depths)):
            require_folder(path)


@command
def watch(
    lens: Path | None = None,
    /,
    *,
    sources: Annotated[tuple[str, ...], Shown(("--source",), metavar="SOURCE")],
    between: Annotated[tuple[float, float] | None, BETWEEN] = None,
    alternating: bool = False,
    sharpness: bool = False,
    encoding: Annotated[Encoding | None, ENCODING] = None,
    misfit: Annotated[float, In(least=1.0, infinite=True)] = 2.0,
    files: Files = Files(),
    cameras: PairCamera = PairCamera(),
    options: imaging.DefocusOptions = imaging.DefocusOptions(),
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
    sharpness
        Say MTF50 of the slanted edge nearest to the middle of each frame, for focusing, as `lommel sfr` measures it;
        of one source, without LENS. Only --encoding, --pixel and --table apply.
    encoding
        Encoding of the values; by default grey of more than 8 bits and floats are linear, all else is sRGB.
    f_number_error
        Common standard error of all f-numbers relative to them, such as 0.05 for 5 %, below 0.5, whose effect is
        stated beside the errors of depth.
    focus_error
        Standard error of each 1 / (focus distance), dioptres (1 / m), such as 0.02, whose effect is stated beside the
        errors of depth, which are of noise alone. By default both are those of the calibration in the lens file, or
        3 % of the f-number and 2 % of each focus distance.
    misfit
        Largest misfit of blocks whose depth counts as known: 1 where only noise is left; inf for all. Fine texture
        raises the misfit of binned pixels, and compression that of all: the limit rises by as much.
    white
        Number of electrons at white, such as 5000; by default the full well of the camera. Without --white, --read
        and a camera that states them, the noise is estimated from the first pair.

    Examples
    --------
      lommel watch phone.toml --source near.mkv --source far.mkv --focus 1.3m --focus 2m --between 1m 3m -o depth.mkv
      lommel watch phone.toml --source both.mp4 --alternating --focus 1.3m --focus 2m --between 1m 3m --table d.csv
      lommel watch --sharpness --source edge.mkv --table focus.csv
    """
    if sharpness:
        needless = given_flags().keys() - {"sharpness", "sources", "encoding", "pixel", "table", "as_json"}
        if needless or lens is not None or len(sources) != 1:
            names = [given_flags()[name] for name in sorted(needless)] or ["LENS" if lens else "a second --source"]
            raise ValueError(f"--sharpness is of one --source, got {', '.join(names)}")
        return _watch_sharpness(sources[0], encoding, cameras.pixel, files.table)
    if lens is None or between is None:
        raise ValueError(f"{'LENS' if lens is None else '--between'} is missing")
    with Stop().signals() as stop:
        _require_two(sources, alternating=alternating)
        instrument = radial_instrument(lens, camera=cameras.camera, pixel=cameras.pixel)
        lenses = each_lens(instrument, 2, cameras, "frames")
        if lenses[0] == lenses[1]:
            raise ValueError(
                "--focus must be given for each of two frames, or --f-number: the frames must differ in one of these"
            )
        files.require()
        tally = Tally()
        with progress("opening the sources", endless=True) as status, ExitStack() as stack:
            pairs = stack.enter_context(videos.frame_pairs(*sources, tell=status.tell))
            for source, used in zip(pairs.sources, lenses, strict=False):
                tell_optics(source.name, source.exif, instrument.side, used)
            stated = states_noise(vars(video_noise), instrument.camera)
            # Without a noise the tables wait for the first pair; until then the usual one of video.
            coded = video_noise if stated else replace(video_noise, white=DEFAULT_WHITE, read=DEFAULT_READ)
            coding = coding_of(pairs.levels, pairs.dtype, pairs.encoding, coded, instrument.camera, encoding)
            status("computing the filters of every distance")
            live = LiveDepth(
                lenses,
                instrument.side,
                between=between,
                noise=coding.noise if stated else None,
                shape=pairs.shape,
                exposures="smooth",
                magnification=options.magnification,
                saturation=coding.saturation,
                sharp=files.sharp,
            )
            largest_error = MAX_KNOWN_ERROR * (1.0 / between[0] - 1.0 / between[1])
            estimator = Estimator(live, coding, misfit, files.sharp, alternating, largest_error)
            outputs = Outputs(files, between, pairs, coding, stack)
            end_reason = _estimate_all(pairs, estimator, outputs, tally, status, stop)
            status("finishing")
            if not tally.pairs:
                if stop.requested:
                    raise KeyboardInterrupt
                raise ValueError(f"no pair of frames came: {end_reason}; check that the times of the sources overlap")
        guess, noise = coding.guess if stated else "", None
        if not stated and live.noise is not None:
            at_white = Noise(white=estimator.coding_in_use.white, read=live.noise.read)  # not in electrons per count
            noise = without_rounding(at_white, estimator.light, coding.levels, coding.encoding)
            coding.facts.update(white=noise.noise.white, read_noise=noise.noise.read, noise_is_a_guess=False)
        facts = {
            **coding.facts,
            "shape": list(pairs.shape),
            "pixel": instrument.side,
            **lens_facts(lenses),
            "between": [finite(distance) for distance in between],
            "magnification": options.magnification,
            "design_error": live.design_error,
            **tally.summary(pairs, end_reason),
            **outputs.facts,
        }
        compression = video_faults.loss_note(pairs.loss, estimator.coding_in_use)
        unknown = tally.unknown(estimator.limit, facts, options.magnification == "registered")
        notes = [text for text in (guess, compression, unknown) if text]
        o, verdict = with_calibration(options, instrument), DefocusVerdict.of(math.nan)
        if tally.failed < tally.pairs:
            verdict = live.verdict(f_number_error=o.f_number_error, focus_error=o.focus_error)
            if noise is not None:
                note = noise_finding(noise)
                findings = Findings(note if each.code == note.code else each for each in verdict.findings)
                verdict = replace(verdict, findings=findings)
        blocks = (facts["known"] + facts["unfit"]) * math.prod(side // BLOCK for side in pairs.shape)
        if math.isnan(verdict.misfit) and blocks >= MIN_BLOCKS:  # of earlier pairs: the last one has no depth
            verdict = DefocusVerdict.of(facts["misfit"], noise=noise, stated=o.f_number_error)
        return (
            told(facts, succeeded=pairs.lost is None)
            + Report({"notes": notes}, [Wrapped(note) for note in notes])
            + verdict_report(verdict)
            + written([files.output, *files.depths, files.table])
        )


class _Sharpness(NamedTuple):
    """MTF50 of the edge of a frame and its standard error, cycles per pixel; infinity above the Nyquist frequency."""

    time: float
    mtf50: float
    error: float
    nyquist: float
    findings: Findings

    @property
    def rank(self) -> tuple[bool, float]:
        """Order of sharpness: any MTF50 without a doubt is above those with one."""
        return self.findings.reliable, self.mtf50

    @property
    def above(self) -> float:
        """The Nyquist frequency if MTF50 is above it, else NaN."""
        return math.nan if math.isfinite(self.mtf50) else self.nyquist

    @property
    def text(self) -> str:
        """MTF50 as text, such as "> 0.5"."""
        return f"{self.mtf50:.3g}" if math.isfinite(self.mtf50) else f"> {self.nyquist:.4g}"


def _watch_sharpness(source: str, encoding: Encoding | None, pixel: float | None, table: Path | None) -> Report:
    """Say the MTF50 of the edge nearest to the middle of each frame, and report the sharpest frame."""
    require_file(table, ".csv", "--table")
    rows: list[_Sharpness] = []
    best: _Sharpness | None = None
    count, said = 0, -math.inf
    with Stop().signals() as stop, progress("opening the source", endless=True) as status, ExitStack() as stack:
        frames = stack.enter_context(videos.video_frames(source, tell=status.tell))
        used, first = encoding or frames.encoding, math.nan
        while (frame := stop.next(frames)) is not None:
            count += 1
            first = frame.time if math.isnan(first) else first
            try:
                image = frame.values if frame.values.ndim == 2 else frame.values[..., 1]
                found = middle_edge(image, None, encoding=used).response
            except ValueError as error:
                status(f"frame {count}: {with_options(str(error))}")
                continue
            row = _Sharpness(frame.time - first, *found.mtf50, float(found.frequencies[-1]), found.findings)
            rows.append(row)
            best = row if best is None or row.rank > best.rank else best
            value = " +- ".join(with_error(row.mtf50, row.error)) if math.isfinite(row.mtf50) else row.text
            doubt = "" if found.reliable else f"; {found.findings.printed[0].text}"
            text = f"MTF50 {value} cycles/pixel, best {best.text}{doubt}"
            status(text)
            if frame.time - said >= _SAID_EVERY:
                said = frame.time
                status.tell(f"{frame.time - first:.1f} s: {text}")
        lost = "interrupted" if stop.requested else frames.lost
    if best is None:
        raise ValueError(f"no frame has a slanted edge that can be measured, of {count}")
    if table is not None:
        lines = [f"{r.time:.6g},{r.mtf50:.6g},{r.error:.6g},{' '.join(r.findings.codes)}" for r in rows]
        atomic.write(table, "\n".join(["time (s),MTF50 (cycles/pixel),error,findings", *lines, ""]).encode())
    facts: Facts = {"frames": count, "measured": len(rows), "sharpest_at": best.time}
    facts |= plain({"mtf50_px": best.mtf50, "mtf50_px_error": best.error, "mtf50_px_above": best.above})
    facts |= plain({"last_px": rows[-1].mtf50, "last_px_above": rows[-1].above})
    facts |= {} if pixel is None else plain({"mtf50": best.mtf50 / pixel})
    findings = Findings(shared_findings([row.findings for row in rows], "frames"))
    if findings.reliable and not best.findings.reliable:  # all frames are in doubt, each few for another cause
        findings = best.findings
    verdict = {"reliable": findings.reliable, "findings": plain(findings)}
    notes = [Wrapped(with_options(finding.text)) for finding in findings.printed]
    report = told(facts | {"ended": lost or "the end"}, succeeded=frames.lost is None)
    return report + Report(verdict, notes, findings.converged) + written([table])


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
) -> str:
    """Estimate and write the depth of all pairs; return the reason why the pairs ended."""
    tally.start = time.perf_counter()
    closed = False
    while not closed and (pair := stop.next(pairs)) is not None:
        result = estimator(pair, pairs.loss)
        if result.failure and not tally.failed:
            status.tell(
                f"no depth at {result.time:.2f} s: {result.failure} (further pairs without depth are counted)"
            )
        tally.add(result)
        closed = outputs(result)
        if not closed:
            status(tally.progress(pairs.dropped))
    tally.stop = time.perf_counter()
    return "interrupted" if stop.requested else pairs.lost or ("the window was closed" if closed else "the end")


@dataclass
class Estimator:
    """Depth estimator for pairs of frames."""

    live: LiveDepth
    coding: Coding
    limit: float  # largest misfit of blocks whose depth is known, relative to that of right depth
    sharp: bool  # True to compute all-in-focus images
    alternating: bool = False  # True if the frames of a pair are not of the same time
    largest_error: float = math.inf  # largest standard error of 1 / depth where compression increases it, 1 / m
    first_time: float = math.nan  # time of the first pair
    evens: bool = True  # True if rows are equalized
    age: int = 0  # number of pairs
    score: float = math.inf  # mean logarithm of the misfit when it was last tested whether equalized rows lower it
    light: Values = field(default_factory=lambda: np.ones(1))  # frame by which noise was estimated, 1 for white
    far: Values | None = None  # second frame of the previous pair of alternating frames

    def __call__(self, pair: videos.FramePair, loss: float | Values = 0.0) -> PairResult:
        """Return the depth of a pair, or the reason why it has no depth, such as a black frame.

        `loss` is that of its compression; see :class:`lommel.io.videos.VideoFrames`.
        """
        self.first_time = pair.time if math.isnan(self.first_time) else self.first_time
        elapsed, start = pair.time - self.first_time, time.perf_counter()
        try:
            frames = self.coding.light(pair.first), self.coding.light(pair.second)
            estimate, equal = self._estimate(frames)
        except ValueError as error:
            failure = with_options(str(error))
            for k, name in enumerate(("the first frame", "the second frame")):
                failure = failure.replace(f"frames[{k}]", name)
            return PairResult(elapsed, time.perf_counter() - start, failure)
        coding = self.coding_in_use
        image = self.live.sharp() * np.float32(self.coding.white / coding.white) if self.sharp else None
        estimated, misfit = np.isfinite(estimate.errors), estimate.misfit
        relative = video_faults.relative_loss((pair.first, pair.second), loss, coding)
        # Each block has the first cause that applies.
        causes = self._faults(frames[1], estimate, relative, coding)
        median = _median(misfit[estimated])
        limit = self.limit * (1.0 + video_faults.MISFIT_OF_LOSS * relative)
        unfit = misfit > limit
        if max(self.live.binning, default=1) > 1 and (estimated & unfit).any():
            unfit = misfit > limit * (1.0 + self.live.aliases())
        causes |= {"misfit": estimated & unfit, "border": np.isnan(misfit), "known": estimated}
        causes["flat"] = video_faults.is_flat(equal, coding)
        cause = np.select(list(causes.values()), range(len(causes)), default=len(causes))
        shares = np.bincount(cause.ravel(), minlength=len(causes) + 1) / cause.size
        unknown = dict(zip([*causes, "ambiguous"], shares.tolist(), strict=True))
        is_known = cause == list(causes).index("known")
        depth, errors = np.where(is_known, estimate.depth, np.nan), np.where(is_known, estimate.errors, np.inf)
        medians = _median(depth[is_known]), _median(errors[is_known]), median
        # Blocks with a misfit take part in the verdict, which would otherwise test only those that passed.
        estimate.errors[~is_known & (cause != list(causes).index("misfit"))] = np.inf
        numbers = unknown.pop("known"), unknown["misfit"], *medians
        duration = time.perf_counter() - start
        return PairResult(elapsed, duration, "", depth, errors, image, numbers, unknown)

    @property
    def coding_in_use(self) -> Coding:
        """The coding with the estimated noise, in whose electrons the frames then are; or as stated."""
        coding, noise = self.coding, self.live.noise or self.coding.noise
        return coding._replace(noise=noise, white=coding.white * _white(noise) / _white(coding.noise))

    def _estimate(self, frames: tuple[Values, Values]) -> tuple[LiveDepthMap, Sequence[Values]]:
        """Return the depth of frames, and the frames, with rows equalized where this lowers the misfit.

        Rows of the scene, such as lines of text, differ in brightness as well where the frames differ in blur.
        """
        choices = frames, equalize_rows(frames[0], frames[1], self.coding)
        if self.live.noise is None:
            self.evens = bool(self.live.estimate_noise(*choices))
            self.light = frames[0] * np.float32(_white(self.coding.noise) / self.coding.white)
        estimate = self.live(*choices[self.evens])
        score = _mean_log(estimate.misfit)
        if self.age % _TEST_ROWS == 0 or score > self.score + _WORSE:
            other = _mean_log(self.live(*choices[not self.evens]).misfit)
            self.evens, self.score = self.evens ^ (other < score), min(score, other)
            estimate = self.live(*choices[self.evens])
        self.age += 1
        return estimate, choices[self.evens]

    def _faults(
        self, far: Values, estimate: LiveDepthMap, relative: Values, coding: Coding
    ) -> dict[str, NDArray[np.bool_]]:
        """Return the blocks of each fault of the video; compression increases the errors of the others.

        `relative` is the variance that compression adds, relative to noise.
        """
        estimate.errors[:] *= np.sqrt(1.0 + np.minimum(relative, video_faults.MAX_LOSS))
        too_large = estimate.errors > self.largest_error * estimate.depth**2
        faults = {"compressed": (relative > video_faults.MAX_LOSS) | too_large}
        if self.alternating and self.far is not None:
            change, faults["bands"] = video_faults.changes(self.far, far, coding)
            # From pair to pair there is twice the motion within a pair.
            faults["moved"] = change > (1.0 + 0.5 * (self.limit - 1.0)) * (1.0 + relative)
        self.far = far
        return faults


def _white(noise: Noise) -> float:
    """Return the electrons at 1."""
    return float(np.asarray(noise.white, np.float64))


def _mean_log(values: Map) -> float:
    return float(np.log(values[np.isfinite(values)]).sum()) / values.size


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
    causes: Counter[str] = field(default_factory=Counter)  # sums of fractions of blocks that are not known

    def add(self, result: PairResult) -> None:
        """Count a pair."""
        self.pairs += 1
        self.durations.append(result.duration)
        self.rows.append(result.numbers)
        self.causes.update(result.unknown)
        self.failed += bool(result.failure)

    def progress(self, dropped: int) -> str:
        """Return the line of progress."""
        rate = self.pairs / (time.perf_counter() - self.start)
        known, _, depth, error, misfit = self.rows[-1]
        text = f"{self.pairs} pairs, {rate:.3g}/s, {1e3 * self.durations[-1]:.3g} ms; dropped {dropped}"
        if known:
            text += f"; {percent(known)} {depth:.4g} m +- {1e3 * error:.2g} mm, misfit {misfit:.2f}"
        return text

    def summary(self, pairs: videos.FramePairs, ended: str) -> Facts:
        """Return times, numbers of frames and pairs that were not used, mean fractions and medians of the blocks."""
        seconds = self.stop - self.start
        times = np.percentile(self.durations, [50.0, 95.0]).tolist()
        columns = np.array(self.rows).T
        known, unfit = columns[:2].mean(axis=1).tolist()
        depth, error, misfit = plain([_median(column[np.isfinite(column)]) for column in columns[2:]])
        return {
            "pairs": self.pairs,
            "seconds": seconds,
            "pairs_per_second": self.pairs / seconds,
            "frame_time": dict(zip(("median", "95 %"), times, strict=True)),
            "interval": pairs.interval,
            "ended": ended,
            "frames_dropped": pairs.dropped,
            "frames_without_a_partner": pairs.alone,
            "frames_of_another_size": pairs.refused,
            "pairs_without_depth": self.failed,
            "known": known,
            "unfit": unfit,
            "unknown": {cause: total / self.pairs for cause, total in self.causes.most_common() if total},
            "depth": depth,
            "error": error,
            "misfit": misfit,
        }

    def unknown(self, limit: float, facts: Facts, registered: bool) -> str:
        """Return a sentence on blocks that are not known, or on the lack of depth; "" if there is nothing to say.

        `registered` is whether frames are taken to have one magnification.
        """
        if facts["unfit"]:
            return (
                f"not known for a misfit above {limit:g} (--misfit): {100.0 * facts['unfit']:.2g} % of the blocks; "
                "causes: motion, frames of different times, depth edges, compression"
                + (", different magnification (--magnification lens)" if registered else "")
            )
        if self.failed == self.pairs:
            return "no pair could be used, for the reason given at the first pair"
        return ""


class Outputs:
    """Outputs for each pair: a video in colours, lossless depth, a table and a window."""

    def __init__(
        self, files: Files, between: tuple[float, float], pairs: videos.FramePairs, coding: Coding, stack: ExitStack
    ) -> None:
        height, width = pairs.shape
        self._files, self._pairs = files, pairs
        self._blocks = height // BLOCK, width // BLOCK
        # Metres per level: the smallest power of ten whose levels reach the farthest distance; 1 mm for infinity.
        far = between[1]
        self._scale = 1e-3 if math.isinf(far) else float(10.0 ** math.ceil(math.log10(far / _MAX_LEVEL)))
        self._clipped = 0  # number of values above the largest level
        shows = files.output is None and has_windows()
        coloured = files.output is not None or shows
        self._colours = DepthColours(between, (height, width), BLOCK, files.sharp) if coloured else None
        self._curve = from_light(np.linspace(0.0, 1.0, _CURVE_LEVELS, dtype=np.float32), "srgb", np.uint8)
        # Linear video may be far darker than its white: `_grey` then sets the white from the first image.
        self._white = math.nan if coding.encoding == "linear" else coding.white

        def open_writer(path: Path, title: str) -> videos.VideoWriter:
            writer: videos.VideoWriter = stack.enter_context(videos.find(path).write(path, pairs.interval, title))
            return writer

        level = f"metres per level {self._scale:g}, 0 where not known"
        self._colour_video = None if files.output is None else open_writer(files.output, "depth")
        titles = (f"depth: {level}", f"standard error of depth: {level}")
        self._lossless = [open_writer(*arguments) for arguments in zip(files.depths, titles, strict=False)]
        self._table = None if files.table is None else Table(files.table, stack)
        self._window = Window("lommel watch", stack) if shows else None

    def __call__(self, result: PairResult) -> bool:
        """Write and show the result of a pair; return True if the window has been closed."""
        if self._table is not None:
            numbers = ["" if math.isnan(value) else f"{value:.6g}" for value in result.numbers]
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
        self._recording.started = True


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


def has_windows() -> bool:
    """Return True if there is a display, and an OpenCV with windows."""
    if sys.platform == "linux" and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        return False
    try:
        return bool(optional.library("cv2", "a window needs", "video").currentUIFramework())
    except ImportError:
        return False


class Clip(NamedTuple):
    """Frames to sharpen, and the function that writes the light of a frame (1 is white) at its time."""

    shape: tuple[int, ...]
    coding: Coding
    frames: Iterator[videos.VideoFrame]
    write: Callable[[Values, float], object]
    video: videos.VideoFrames | None
    exif: photos.Exif


@command
@filled(video=suffixes("video"), photo=suffixes("photo"))
def sharpen(
    clip: Path,
    lens: Path,
    /,
    *,
    output: Annotated[Path, OUTPUT],
    at: Annotated[float | None, Shown(length="m")] = None,
    map_: Annotated[Path | None, Shown(("--depth",), metavar="FILE")] = None,
    encoding: Annotated[Encoding | None, ENCODING] = None,
    clip_camera: PhotoCamera = PhotoCamera(),
    video_noise: FrameNoise = FrameNoise(),
    depth_map: imaging.DepthMapOptions = imaging.DepthMapOptions(missing="nearest"),
) -> Report:
    """Sharpen video or a photo of known depth.

    Wiener filters in one pass, at video rate. CLIP is a video file, numbered images (a folder or frames/%04d.tif)
    or a photo, in grey or colour. LENS is a lens file. Blur wider than about 40 pixels is removed only in part;
    `lommel restore --at` takes longer and removes more. Ctrl-C, SIGTERM or a closed terminal ends the command and
    leaves a complete file.

    Parameters
    ----------
    output
        Sharp video: {video}; of a photo: {photo}.
    at
        Distance of the whole scene, such as 1.5m.
    map_
        Depth map instead, of the size of the frames or of their blocks of 4 x 4 pixels.
    encoding
        Encoding of the values; by default grey of more than 8 bits and floats are linear, all else is sRGB.
    f_number
        F-number; overrides the lens file.

    Examples
    --------
      lommel sharpen clip.mp4 phone.toml --focus 2m --at 1.5m -o sharp.mp4
      lommel sharpen photo.png phone.toml --focus 1.5m --depth depth.tif --white 5000 --read 3 -o sharp.png
    """
    if (at is None) == (map_ is None):
        raise ValueError(f"give one of --at and --depth, got {'neither' if at is None else 'both'}")
    require_folder(output)
    instrument = radial_instrument(lens, **vars(clip_camera))
    lens_in_use = instrument.lens
    count = 0
    with Stop().signals() as stop, progress("reading", endless=True) as status, ExitStack() as stack:
        coder = partial(coding_of, video_noise=video_noise, camera=instrument.camera, encoding=encoding)
        shape, coding, frames, write, video, exif = _clip(clip, output, coder, encoding, status, stack)
        tell_optics(clip.name, exif, instrument.side, lens_in_use)
        metres = np.array([[at]]) if map_ is None else _map(map_, depth_map, shape[:2])
        distance: float | Array = fill_missing(metres, depth_map.missing or "nearest") if at is None else at
        if map_ is not None:
            warn_of_depths(lens_in_use, instrument.side, distance)
        status("computing the filters")
        live: LiveSharpen | None = None
        start = time.perf_counter()
        while (frame := stop.next(frames)) is not None:
            light = coding.light(frame.values)
            if live is None:
                live = _filters(lens_in_use, instrument.side, distance, coding, light)
                start, first_time = time.perf_counter(), frame.time
            write(live(light, distance) / np.float32(coding.white), frame.time - first_time)
            count += 1
            status(f"{count} frames, {count / (time.perf_counter() - start):.3g}/s")
        seconds = time.perf_counter() - start
        failure = None if video is None else video.lost
        end_reason = "interrupted" if stop.requested else failure or "the end"
        if not count:
            if stop.requested:
                raise KeyboardInterrupt
            raise ValueError(f"no frame was read: {end_reason}")
    ends = [float(np.min(distance)), float(np.max(distance))]
    blur = float(np.max(2.0 * lens_in_use.pupil(np.array(ends)).geometric_radius())) / instrument.side
    facts = {
        **coding.facts,
        "shape": list(shape),
        "pixel": instrument.side,
        "focus_distance": finite(lens_in_use.focus_distance),
        "f_number": lens_in_use.f_number,
        "focal_length": lens_in_use.focal_length,
        "between": [finite(end) for end in ends],
        "unknown": depth_facts(metres)["depth_unknown"],
        "blur": blur,
        "frames": count,
        "seconds": seconds,
        "ended": end_reason,
    }
    notes = [note for note in (coding.guess, video and video_faults.loss_note(video.loss, coding)) if note]
    if video is not None:
        facts |= {"frames_dropped": video.dropped, "frames_of_another_size": video.refused}
    lines = Report({"notes": notes}, [Wrapped(note) for note in notes])
    return told(facts, succeeded=failure is None) + lines + written([output])


def _map(path: Path, values: imaging.DepthMapOptions, shape: tuple[int, ...]) -> Array:
    """Return a depth map of the size of frames or, unless it is to be resampled, of their blocks."""
    depth_map = imaging.read_depth(
        path, shape=None if values.resample is None else shape, options=replace(values, missing=None)
    )
    sizes = shape, (shape[0] // BLOCK, shape[1] // BLOCK)
    if depth_map.shape not in sizes:
        raise ValueError(
            f"{validation.line(path)} must have the shape {sizes[0]} or {sizes[1]}, got {depth_map.shape}; "
            '`resample` "nearest" uses the nearest pixels of a map of the same aspect ratio'
        )
    return depth_map


def _filters(lens: Lens, pixel: float, distance: float | Array, coding: Coding, first_frame: Values) -> LiveSharpen:
    """Return the filters for a range of distances, and for the mean light of the first frame."""
    nearest, farthest = float(np.min(distance)), float(np.max(distance))
    return LiveSharpen(
        lens,
        pixel,
        between=(min(nearest, _MAX_NEAREST) * (1.0 - _RANGE_MARGIN), farthest * (1.0 + _RANGE_MARGIN)),
        noise=coding.noise,
        shape=first_frame.shape,
        light=max(1.0, float(coding.noise.electrons(float(np.nanmean(first_frame))))),
        saturation=coding.saturation,
    )


def _clip(
    clip: Path, output: Path, coder: Callable[..., Coding], encoding: Encoding | None, status: Steps, stack: ExitStack
) -> Clip:
    """Open a photo or a video, and its output."""
    if (
        clip.suffix.lower() in {suffix for form in formats("photo") for suffix in form.suffixes}
        and "%" not in clip.name
    ):
        photos.find(output, "--output")
        picture = imaging.read_photo(clip, encoding)
        values = picture.values
        if values.dtype.kind == "f":
            warn_if_bright(values)
        levels = 0 if values.dtype.kind == "f" else 2 ** (8 * values.dtype.itemsize)
        coding = coder(levels, values.dtype, picture.encoding, stated=picture.stated)
        dtype, stored_as = output_type(picture, output)

        def save(light: Values, _: float) -> None:
            imaging.write_photo(output, light, encoding=stored_as, dtype=dtype, like=picture)

        return Clip(values.shape, coding, iter([videos.VideoFrame(values, 0.0)]), save, None, picture.exif)
    form = videos.find(output, "--output")
    video = stack.enter_context(videos.video_frames(str(clip), tell=status.tell))
    coding = coder(video.levels, video.dtype, video.encoding)
    # Grey of more than 8 bits keeps its bits and its encoding, if the format can store them.
    is_16_bit = video.dtype != np.uint8 and len(video.shape) == 2 and "of uint16" in form.holds
    write = stack.enter_context(form.write(output, video.interval))

    def store(light: Values, seconds: float) -> None:
        stored = from_light(light, coding.encoding, np.uint16) if is_16_bit else from_light(light, "srgb", np.uint8)
        write(stored, seconds)

    return Clip(video.shape, coding, video, store, video, video.exif)


def equalize_rows(first: Values, second: Values, coding: Coding) -> list[Values]:
    """Return two frames, the rows of the second scaled to a uniform ratio of brightness; saturated pixels are NaN.

    A rolling shutter records a flickering lamp as bands of rows, which a smooth ratio of exposures cannot represent.
    """
    frames = [frame.astype(np.float32) - np.float32(coding.noise.offset) for frame in (first, second)]
    limit = math.inf if coding.saturation is None else coding.saturation - float(coding.noise.offset)
    valid = np.logical_and(*(frame < limit for frame in frames))
    if not valid.all():
        frames = [np.where(valid, frame, np.float32(np.nan)) for frame in frames]
    sums = [np.asarray(np.nansum(frame, axis=1, dtype=np.float64)) for frame in frames]
    rows = [video_faults.smooth_rows(row_sums) for row_sums in sums]
    equalized = np.minimum(*rows) > _DARK_ROW * max(rows[0].mean(), rows[1].mean())
    if equalized.any():
        ratio = np.ones(len(rows[0]))
        np.divide(rows[1], rows[0], out=ratio, where=equalized)
        ratio[equalized] *= rows[0][equalized].sum() / rows[1][equalized].sum()
        frames[1] *= (1.0 / np.clip(ratio, 0.5, 2.0)).astype(np.float32)[:, None]
    for frame in frames:
        frame += np.float32(coding.noise.offset)
    return frames
