"""Deconvolution of a stack in lateral chunks: the central one first, whose steps all others repeat."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.deconvolve.algorithms import EARLIEST, STEPS, ProgressCallback, RichardsonLucy, TotalVariation
from lommel.deconvolve.iterations import Background, Iteration, StepSettings, iteration_of
from lommel.deconvolve.likelihood import PoissonLikelihood
from lommel.deconvolve.linear import PlaneOperator, tiles_of
from lommel.fit.findings import Finding
from lommel.microscopy.depth_model import PSFs
from lommel.microscopy.held_out import stopping_rule
from lommel.microscopy.light_checks import Floor
from lommel.microscopy.refinement import StackContext
from lommel.microscopy.restored_stack import INTERRUPTED, MISFIT, ProjectionBuilder
from lommel.microscopy.store import Target
from lommel.recorded.counts import Stack

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
    overlap, restored_planes = context.model.window[1], planes + 2 * margin[0]
    specimens = 5.0 if isinstance(method, TotalVariation) else 4.0  # number of arrays of specimen size

    def chunk_memory(side: int) -> float:
        """Return the approximate memory of a chunk, bytes."""
        sides = [min(side + 2 * overlap, length) for length in (height, width)]
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


def restore_chunks(
    context: StackContext,
    course: Course,
    target: Target,
    place: tuple[int, ...],
    request: str,
    parts: tuple[ProjectionBuilder, Floor],
    doubts: Sequence[str],
    report: Report,
) -> Outcome:
    """Restore all chunks of a channel into `target` at `place`; add them to the projections and the floor.

    `request` is the checksum of all inputs; `doubts` are the codes of doubts about the stack.
    """
    stack, model, method = context.stack, context.model, course.method
    planes, height, width = stack.shape
    blurs: dict[tuple[int, int, int], PlaneOperator] = {}
    sides = [math.ceil(pixels / math.ceil(pixels / course.side)) for pixels in (height, width)]
    tiles = sorted(
        tiles_of((height, width), sides, model.window[1]),
        key=lambda tile: _distance_from_middle(tile[0], height, width),
    )
    # With several chunks, all start from the mean light of the whole stack.
    mean_light = None if len(tiles) == 1 else _mean_light(context)
    settings: list[StepSettings] | None = None
    outcome = Outcome(np.zeros((height, width)) if course.background.points > 1 else 0.0)
    for number, (tile, padded, inner) in enumerate(tiles):
        chunk = np.s_[*place, :, *tile]
        if number and target.has(request, chunk):
            continue
        counted = PoissonLikelihood(_load(stack, *padded), context.camera.part(*padded), context.saturation)
        counted.level = counted.level if mean_light is None else mean_light
        size = (planes, *(part.stop - part.start for part in padded))
        if size not in blurs:
            blurs.clear()  # keep a single operator in memory
            blurs[size] = model.blur(size, course.margin, course.psfs, threads=context.threads)
        blur = blurs[size]
        if blur.outside is not None:
            blur.outside[...] = counted.level
        if number == 0:
            outcome.is_structured = counted.flat() > 1.0 + counted.slack
        before = counted.mean(counted.discrepancies(blur, counted.scene(*course.margin)))
        iteration = iteration_of(
            method,
            blur,
            counted,
            settings,
            background=course.background,
            aspect=model.aspect,
            threads=context.threads,
        )
        iteration.enough = stopping_rule(method, course.best_steps, counted)
        steps_at_most = method.steps if settings is None else len(settings)
        progress = _ChunkProgress(report, number, len(tiles), steps_at_most, method.target > 0.0)
        may_interrupt = len(tiles) == 1 and target.unfinished is None
        count, stopped, discrepancies = _solve(iteration, method, progress, may_interrupt=may_interrupt)
        after = counted.mean(discrepancies)
        if settings is None:
            settings, outcome.steps, outcome.strength = iteration.course, count, iteration.strength
            outcome.finding = _finding(counted, stopped, count, before, after, doubts)
            outcome.stopped = _reason(outcome.finding, stopped)
        if isinstance(outcome.background, np.ndarray):
            outcome.background[tile] = np.asarray(counted.background)[inner]
        elif number == 0:
            outcome.background = counted.background
        voxels = float(counted.known.sum())
        outcome.deviance_after += after * voxels
        outcome.deviance_before += before * voxels
        outcome.voxels += voxels
        restored = np.ascontiguousarray(iteration.inside(*course.margin)[:, *inner])
        projections, floor = parts
        floor.add(restored, *tile)
        projections.add(*tile, (padded[0].start, padded[1].start), blur, counted, iteration.guess, restored)
        # The target has the planes in the order of the recording.
        target.put(request, chunk, restored[::-1] if model.is_reversed else restored)
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
