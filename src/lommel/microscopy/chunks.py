"""Deconvolution of a stack in lateral chunks: the central one first, whose steps all others repeat."""

from __future__ import annotations

import itertools
import math
import secrets
import time as clock
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import closing, nullcontext
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from pathlib import Path
from threading import Lock
from typing import NamedTuple, TypeAlias

import numpy as np

from lommel.base import atomic, validation
from lommel.base.arrays import Array, Values
from lommel.base.executors import Shared, Workers, called, unseen
from lommel.deconvolve.algorithms import EARLIEST, STEPS, ProgressCallback, RichardsonLucy, TotalVariation, silent
from lommel.deconvolve.iterations import Background, Iteration, StepSettings, iteration_of
from lommel.deconvolve.likelihood import PoissonLikelihood
from lommel.deconvolve.linear import PlaneOperator, Window
from lommel.fit.findings import Finding
from lommel.microscopy.depth_model import DepthModel, GivenPSF, PSFs
from lommel.microscopy.device_iteration import DeviceIteration
from lommel.microscopy.held_out import stopping_rule
from lommel.microscopy.light_checks import Floor
from lommel.microscopy.refinement import StackContext
from lommel.microscopy.restored_stack import INTERRUPTED, MISFIT, Projected, ProjectionBuilder, projected
from lommel.microscopy.store import Target
from lommel.recorded.counts import Stack
from lommel.recorded.frames import RecordingError
from lommel.traced.namespaces import Placement

Report = Callable[[float, str], object]

_MOST_FITTED = 0.1  # decrease of the discrepancy below 1 from which the steps of a method fitted noise
_MISFIT_PROGRESS = 0.3  # progress shown after `EARLIEST` steps, when the restoration may end as a misfit


class Course(NamedTuple):
    """How a stack is restored."""

    method: RichardsonLucy | TotalVariation
    background: Background
    best_steps: int  # number of steps after which the result agrees best with held-out photons, 0 if it is not known
    margin: tuple[int, int]  # planes and pixels
    psfs: PSFs
    side: int  # of chunks, pixels
    place: Placement | None = None  # where the steps are computed, None for arrays of NumPy


@dataclass
class Outcome:
    """Sums of Poisson deviances over the voxels of all chunks, background, and results of the central chunk."""

    background: float | Array
    deviance_after: float = 0.0
    deviance_before: float = 0.0
    voxels: float = 0.0  # number of voxels that are not ignored
    is_structured: bool = False  # whether a uniform scene does not explain the chunk
    steps: int = 0
    stopped: str = STEPS
    strength: float | None = None
    finding: Finding | None = None


def chunk_side(
    context: StackContext, margin: tuple[int, int], psfs: PSFs, method: object, tile: int | None, memory: float
) -> int:
    """Return the side of the chunks, pixels: `tile`, or the largest whose memory is within the limit (bytes)."""
    if tile is not None:
        return int(validation.integer("tile", tile, least=16, most=validation.MAX_SIDE))
    planes, height, width = context.stack.shape
    restored_planes = planes + 2 * margin[0]
    specimens = 5.0 if isinstance(method, TotalVariation) else 4.0  # number of arrays of specimen size

    def chunk_memory(side: int) -> float:
        """Return the approximate memory of a chunk, bytes."""
        sides = [_parts(length, side, overlap_of(context.model))[0][1].stop for length in (height, width)]
        restored_pixels = math.prod(length + 2 * margin[1] for length in sides)
        transfers = 2.0 * len(psfs.depths) * (planes + context.model.window[0]) * restored_pixels / 4.0
        if psfs.radial is not None:
            transfers = float(len(psfs.radial.frequencies) * planes * restored_planes)
        # 4 bytes per value, and 10 % more for the coarse grid.
        voxels = specimens * restored_planes * restored_pixels + 3.0 * planes * math.prod(sides)
        return 4.4 * float(voxels + transfers)

    # Chunks are of equal size: their number along each side is increased until one fits into memory.
    side = int(max(height, width))
    while side > 64 and chunk_memory(side) > memory:
        pieces = math.ceil(max(height, width) / side) + 1
        side = math.ceil(max(height, width) / pieces)
    return side


def overlap_of(model: DepthModel | GivenPSF) -> int:
    """Return the pixels by which chunks exceed their values on each side: what a point of these illuminates."""
    return model.window[1] // 2


def _parts(length: int, side: int, overlap: int) -> list[tuple[slice, slice, slice]]:
    """Divide an axis into parts of about `side` pixels: each part, with overlap, and its place in that.

    All have equal lengths with overlap, so that they share a blur: those at the ends have more pixels of their own.
    """
    count = math.ceil(length / side)
    padded = min(length, math.ceil((length + 2 * overlap * (count - 1)) / count))
    starts = [k * (length - padded) // max(count - 1, 1) for k in range(count)]
    inner = [(first + second + padded) // 2 for first, second in pairwise(starts)]
    if padded == length:
        inner = [k * length // count for k in range(1, count)]
    return [
        (slice(low, high), slice(start, start + padded), slice(low - start, high - start))
        for start, low, high in zip(starts, [0, *inner], [*inner, length], strict=True)
    ]


_Tile: TypeAlias = tuple[int, Window, Window, Window]
"""Number of a chunk, its rows and columns, those with overlap, and its place in these."""


class _Restored(NamedTuple):
    """A restored chunk; `finding` and `stopped` are those of a chunk whose settings the others repeat."""

    values: Values
    projected: Projected
    deviances: tuple[float, float]  # means before and after
    voxels: float
    is_structured: bool
    background: float | Array
    settings: list[StepSettings]
    steps: int
    stopped: str
    strength: float | None
    finding: Finding | None


class _Job:
    """What all chunks of a channel have in common; a process restores one chunk at a time."""

    def __init__(
        self, context: StackContext, course: Course, mean_light: float | None, doubts: tuple[str, ...]
    ) -> None:
        self._given = context, course, mean_light, doubts
        self._blurs: dict[tuple[int, int, int], PlaneOperator] = {}
        self.lock = Lock()

    def __reduce__(self) -> tuple[object, ...]:
        return _Job, self._given

    def blur(self, padded: Window) -> PlaneOperator:
        """Return the blur of the rows and columns `padded`, which other chunks of this size share."""
        context, course, *_ = self._given
        size = (context.stack.shape[0], *(part.stop - part.start for part in padded))
        if size not in self._blurs:
            self._blurs.clear()  # keep a single operator in memory
            self._blurs[size] = context.model.blur(size, course.margin, course.psfs, threads=context.threads)
        return self._blurs[size]

    def restore(
        self,
        padded: Window,
        inner: Window,
        settings: list[StepSettings] | None,
        report: ProgressCallback,
        *,
        may_interrupt: bool = False,
    ) -> _Restored:
        """Restore the rows and columns `padded`, and return its part `inner`; None for the settings of the first."""
        context, course, mean_light, doubts = self._given
        stack, method = context.stack, course.method
        counted = PoissonLikelihood(_load(stack, *padded), context.camera.part(*padded), context.saturation)
        counted.level = counted.level if mean_light is None else mean_light
        blur = self.blur(padded)
        if blur.outside is not None:
            blur.outside[...] = counted.level
        is_structured = settings is None and counted.flat() > 1.0 + counted.slack
        before = counted.mean(counted.discrepancies(blur, counted.scene(*course.margin)))
        background = course.background
        if course.place is not None:
            iteration: Iteration = DeviceIteration(course.place, blur, counted, settings, background=background)
        else:
            iteration = iteration_of(
                method,
                blur,
                counted,
                settings,
                background=background,
                aspect=context.model.aspect,
                threads=context.threads,
            )
        iteration.enough = stopping_rule(method, course.best_steps, counted)
        count, stopped, discrepancies = _solve(iteration, method, report, may_interrupt=may_interrupt)
        after, finding = counted.mean(discrepancies), None
        if settings is None:
            finding = _finding(counted, stopped, count, before, after, doubts)
        light = counted.background
        return _Restored(
            np.ascontiguousarray(iteration.inside(*course.margin)[:, *inner]),
            projected(inner, blur, counted, iteration.guess),
            (before, after),
            float(counted.known.sum()),
            is_structured,
            np.asarray(light)[inner] if background.points > 1 else light,
            iteration.course,
            count,
            _reason(finding, stopped),
            iteration.strength,
            finding,
        )


def _prepared(job: Shared[_Job], padded: Window) -> None:
    """Compute what all chunks share in this process."""
    with job.value.lock:
        job.value.blur(padded)


def _restored_by_worker(
    job: Shared[_Job],
    settings: list[StepSettings] | None,
    folder: Path,
    number: int,
    _tile: Window,
    padded: Window,
    inner: Window,
) -> _Restored:
    """Restore a chunk where this is called, and write its values: a process has those of one chunk at a time."""
    if not folder.is_dir():
        raise RecordingError(unseen(folder.parents[1]))
    with job.value.lock:
        found = job.value.restore(padded, inner, settings, silent)
        path = folder / f"{number}-{secrets.token_hex(8)}.npy"
        with atomic.as_path_error(folder.parents[0]):
            np.save(path, found.values)
            path.replace(folder / f"{number}.npy")
        return found._replace(values=np.empty(0, np.float32))


def _taken(path: Path) -> Values:
    """Return the values of a chunk that a worker wrote, and remove the file."""
    values: Values = np.load(path)
    path.unlink()
    return values


def restore_chunks(
    context: StackContext,
    course: Course,
    target: Target,
    place: tuple[int, ...],
    request: str,
    sums: tuple[ProjectionBuilder, Floor],
    doubts: Sequence[str],
    report: Report,
    workers: Workers | None = None,
) -> Outcome:
    """Restore all chunks of a channel into `target` at `place`; add them to the projections and the floor.

    `request` is the checksum of all inputs; `doubts` are the codes of doubts about the stack. The central chunk is
    restored first; `workers` restore it, and then the others by its settings, which this process writes.
    """
    model, (_, height, width) = context.model, context.stack.shape
    parts = (_parts(length, course.side, overlap_of(model)) for length in (height, width))
    tiles = sorted(
        (tuple(zip(*pair, strict=True)) for pair in itertools.product(*parts)),
        key=lambda tile: _distance_from_middle(tile[0], height, width),
    )
    # With several chunks, all start from the mean light of the whole stack.
    mean_light = None if len(tiles) == 1 else called(workers, _mean_light, context)
    context = context if workers is None else context._replace(threads=workers.threads)
    job = _Job(context, course, mean_light, tuple(doubts))
    outcome = Outcome(np.zeros((height, width)) if course.background.points > 1 else 0.0)
    may_interrupt = len(tiles) == 1 and target.unfinished is None
    settings: list[StepSettings] | None = None

    todo = ((number, *tile) for number, tile in enumerate(tiles))
    unfinished = target.unfinished
    with nullcontext() if unfinished is None else atomic.scratch_folder(unfinished.scratch, "chunks") as folder:
        shared = Shared(job, folder)

        def restored(tasks: Iterator[_Tile]) -> Generator[tuple[_Tile, _Restored]]:
            if workers is not None and folder is not None:
                restore = partial(_restored_by_worker, shared, settings, folder)
                if settings is None and len(tiles) > 1:  # the other workers are idle up to the end of the first chunk
                    workers.begin(_prepared, (shared, tiles[0][1]), workers.at_once - 1)
                for task, found in workers.run(restore, tasks, ordered=True):
                    yield task, found._replace(values=_taken(folder / f"{task[0]}.npy"))
                return
            for number, tile, padded, inner in tasks:
                steps = course.method.steps if settings is None else len(settings)
                progress = _ChunkProgress(report, number, len(tiles), steps, course.method.target > 0.0)
                found = job.restore(padded, inner, settings, progress, may_interrupt=may_interrupt)
                yield (number, tile, padded, inner), found

        missing = (task for task in todo if not target.has(request, np.s_[*place, :, *task[1]]))
        for tasks in (iter([next(todo)]), missing):
            with closing(restored(tasks)) as results:
                for (number, tile, _, _), found in results:
                    if settings is None:
                        settings, outcome.steps, outcome.strength = found.settings, found.steps, found.strength
                        outcome.finding, outcome.stopped = found.finding, found.stopped
                        outcome.is_structured = found.is_structured
                        if course.background.points <= 1:
                            outcome.background = found.background
                    if isinstance(outcome.background, np.ndarray):
                        outcome.background[tile] = found.background
                    before, after = found.deviances
                    outcome.deviance_after += after * found.voxels
                    outcome.deviance_before += before * found.voxels
                    outcome.voxels += found.voxels
                    projections, floor = sums
                    floor.add(found.values, *tile)
                    projections.add(*tile, found.projected, found.values)
                    # The target has the planes in the order of the recording.
                    values = found.values[::-1] if model.is_reversed else found.values
                    target.put(request, np.s_[*place, :, *tile], values)
                    if workers is not None:
                        report((number + 1) / len(tiles), f"chunk {number + 1} of {len(tiles)}")
    return outcome


def _solve(
    iteration: Iteration, method: RichardsonLucy | TotalVariation, report: ProgressCallback, *, may_interrupt: bool
) -> tuple[int, str, Array]:
    """Iterate; return (1) number of steps, (2) why they ended, (3) discrepancies. Ctrl-C keeps a single chunk."""
    try:
        return iteration.solve(method, report)
    except KeyboardInterrupt:
        if not may_interrupt or not iteration.course:
            raise
        return len(iteration.course) - 1, INTERRUPTED, iteration.discrepancies


def _finding(
    counted: PoissonLikelihood,
    reason: str,
    steps: int,
    before: float,
    discrepancy: float,
    doubts: Sequence[str],
) -> Finding | None:
    """Return the finding on the convergence of the central chunk, None if there is none."""
    finding = counted.finding(reason, before, discrepancy)
    if finding is not None or reason != STEPS:
        return finding
    if counted.electrons >= 1.0 and discrepancy < 1.0 - _MOST_FITTED:
        text = f"the {steps} steps of the method fit the noise, which they amplify (discrepancy {discrepancy:.3g})"
        return Finding("not_settled", "doubt", f"{text}; take fewer", {"discrepancy": discrepancy, "steps": steps})
    if discrepancy <= 1.0 + counted.slack:
        return None
    # More steps would fit a wrong PSF by artefacts.
    advice = "correct the PSF first" if "psf_doubtful" in doubts else "allow more steps"
    text = f"the residual exceeds the noise after the {steps} steps of the method; {advice}"
    return Finding("not_settled", "error", text, {"discrepancy": discrepancy, "steps": steps})


def _reason(finding: Finding | None, stopped: str) -> str:
    """Return why the iterations of a chunk ended: what does not fit at the end is a misfit, too."""
    return MISFIT if finding is not None and finding.code == "misfit" else stopped


class _ChunkProgress:
    """Progress of a chunk, reported as a fraction of the work of all chunks."""

    def __init__(self, report: Report, number: int, count: int, steps: int, may_misfit: bool) -> None:
        self._report, self._number, self._count, self._steps = report, number, count, steps
        self._may_misfit = may_misfit  # whether the chunk may end as a misfit, after which other PSFs are tried
        self._begun = clock.monotonic()

    def __call__(self, step: int, discrepancy: float, remaining: float) -> None:
        message = f"step {step}, discrepancy {discrepancy:.3g}"
        fraction = min(step / max(self._steps, 1), 1.0)
        if self._count == 1:
            elapsed = clock.monotonic() - self._begun
            fraction = elapsed / (elapsed + remaining) if elapsed + remaining > 0.0 else 0.0
            if self._may_misfit and step <= EARLIEST:
                fraction = min(fraction, _MISFIT_PROGRESS * step / EARLIEST)
        else:
            message = f"chunk {self._number + 1} of {self._count}, {message}"
        self._report((self._number + fraction) / self._count, message)


def _mean_light(context: StackContext) -> float:
    """Return the mean light of a stack, weighted by the gain, without ignored voxels."""
    stack, camera, limit = context.stack, context.camera, context.saturation
    total = weights = 0.0
    for plane in range(len(stack)):
        values = np.asarray(stack[plane])
        gain = np.where(np.isfinite(values) & (values < limit), 1.0 if camera.white is None else camera.white, 0.0)
        light = np.maximum(np.nan_to_num(values.astype(np.float64)) - camera.offset, 0.0)
        total += float((gain * light).sum())
        weights += float(gain.sum())
    return total / max(weights, 1e-30)


def _distance_from_middle(part: tuple[slice, slice], height: int, width: int) -> float:
    return math.hypot(*(at.start + at.stop - side for at, side in zip(part, (height, width), strict=True)))


def _load(source: Stack, rows: slice, columns: slice) -> Values:
    """Read some rows and columns of all planes, in one thread, as files require."""
    values = np.empty((source.shape[0], rows.stop - rows.start, columns.stop - columns.start), source.dtype)
    for plane in range(len(values)):
        values[plane] = source[plane, rows, columns]
    return values
