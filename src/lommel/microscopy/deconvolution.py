"""Deconvolution of microscope stacks: orient and prepare them, solve chunk by chunk, store and check the result."""

from __future__ import annotations

import hashlib
import itertools
import math
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from functools import partial
from os import PathLike
from typing import Annotated, Any, ClassVar, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.executors import Workers, called
from lommel.base.options import HIDDEN, In, Options, Shown, listed
from lommel.base.units import camera_pixel, format_length, percent
from lommel.deconvolve.algorithms import RichardsonLucy, TotalVariation, silent
from lommel.deconvolve.iterations import Background
from lommel.fit.findings import Finding, Findings, in_words
from lommel.measures.measured_psf import MeasuredPSF
from lommel.microscopy.chunks import Course, Outcome, chunk_side, restore_chunks
from lommel.microscopy.depth_model import MAX_RIM, DepthModel, GivenPSF, PSFs
from lommel.microscopy.held_out import HeldOut, estimated_held_out_steps
from lommel.microscopy.light_checks import Floor, plane_light_findings
from lommel.microscopy.preparation import Remarks, compare_held_out, oriented, prepared
from lommel.microscopy.refinement import DIRECTION_STEPS, StackContext, select_crop
from lommel.microscopy.restored_stack import INTERRUPTED, ProjectionBuilder, RestoredChannel, RestoredStack
from lommel.microscopy.sampling import Stated, sampled
from lommel.microscopy.store import Target, checksum, destination
from lommel.psf import PSF
from lommel.recorded.camera_noise import unrepeated
from lommel.recorded.copies import local_stacks
from lommel.recorded.counts import LARGEST, Counts
from lommel.recorded.frames import Frames, frames_of
from lommel.recorded.headers import Metadata, missing_findings, told_early, with_header, without_missing
from lommel.recorded.noise import Noise
from lommel.traced.namespaces import Placement

_BACKGROUNDS = {"flat": 1, "uneven": 3}  # points along each side of the field at which levels are estimated
_MEMORY = 2.0**31  # default memory limit, bytes
_MISSING = "then restored light is wrong there, and up to half of a PSF beyond"  # effect of missing chunks
_READ_SHARE = 0.125  # fraction of the memory limit in which chunks of the recording are read together
_USUAL_STEPS = 60  # typical number of steps of a restoration, for the progress display
_MIN_MARGIN = 8  # smallest default margin, planes, unless half of the PSF has fewer

Report = Callable[[float, str], object]


_METHOD = RichardsonLucy(target=1.0)


def _algorithm(name: str, value: RichardsonLucy | TotalVariation | None) -> RichardsonLucy | TotalVariation:
    """Return a method, the default one for None."""
    validation.optional(name, value, RichardsonLucy, TotalVariation)
    return _METHOD if value is None else value


def _wavelengths(name: str, value: ArrayLike) -> tuple[float, ...]:
    """Return emission wavelengths, of one number or a sequence."""
    waves = np.atleast_1d(validation.real_array(name, value, unit="metres"))
    if waves.ndim > 1:
        raise ValueError(f"{name} must be a number or a list of numbers, got the shape {waves.shape}")
    return tuple(validation.wavelength(float(wave), name) for wave in waves)


def _level(name: str, value: float | str) -> float | str:
    """Return a background: a known level, or one of _BACKGROUNDS."""
    if not isinstance(value, str):
        return validation.real(name, value, least=0.0, most=LARGEST)
    if value not in _BACKGROUNDS:
        raise ValueError(f'{name} must be "flat", "uneven", or the light of each voxel, 0 for none, got {value!r}')
    return value


def _level_or_text(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def _gigabytes(text: str) -> float:
    try:
        return 1e9 * float(text)
    except ValueError:
        raise ValueError(f"must be a number of gigabytes, such as 0.3, got {text!r}") from None


@dataclass(frozen=True, kw_only=True)
class DeconvolveOptions(Options):
    """Options of the deconvolution of a stack.

    Parameters
    ----------
    depth : float, optional
        Depth below the cover glass that is in focus in plane ``planes // 2``, counted from 0 in the order of the
        recording, metres. By default the depth of the Microscope; for an Objective ``planes // 2 * step``, as if the
        stack began at the glass.
    wavelength : float or sequence of float, optional
        Emission wavelength, metres; one value, or one for each channel. By default the wavelength in the file.
    pixel : float, optional
        Pixel pitch on the camera, metres. By default the pixel size in the file, which is that in the sample,
        multiplied by the magnification.
    step : float, optional
        Stage displacement between planes, metres. By default the value in the file.
    direction : {"auto", "up", "down"}, default "auto"
        "up": the first plane is the nearest to the cover glass. "auto" tries both directions and selects the more
        likely one, or "up" if the data do not determine the direction.
    method : RichardsonLucy or TotalVariation
        By default ``lm.imaging.RichardsonLucy(target=1.0)``: a lower target, as for photographs, would amplify noise
        where the PSF is much wider than a voxel. ``lm.imaging.TotalVariation(target=1.0)`` preserves edges, with
        gradients in three dimensions, all per pixel.
    background : "flat", "uneven" or float, default "flat"
        Light per voxel that is not from the specimen, in the unit of `stack` without the offset of its noise; the
        restored values exclude it. A number is a known level, 0 for none. Otherwise the background is estimated with
        the specimen: "flat" is one level for the whole stack, "uneven" a level at each of 3 x 3 points of the field,
        with linear interpolation between them. With `diagnosis`, and at most 500000 voxels, a flat background is
        estimated from held-out photons before; else from the central chunk. An uneven background is estimated in each
        chunk separately, and is best used without chunks.
    diagnosis : bool, default True
        Whether to hold out some photons, to estimate the background and the number of steps and to compare PSFs for
        other sample indices in a part of the stack; and whether to compare more PSFs after a misfit. The computing
        time increases by a factor of 1.1 to 1.3, or up to 1.5 after a misfit of a small stack.
    memory : float, optional
        Limit of the memory in addition to input and output, bytes; by default 2 GiB. Without `out`, input in chunks
        is in memory as a whole. A chunk larger than an eighth of the limit is nevertheless read as a whole.
    out : path, optional
        Folder NAME.zarr for stacks larger than memory; it may replace only an earlier restored stack. Values are
        written chunk by chunk to the hidden folder ``.NAME.zarr.unfinished`` beside `out`, which is renamed when
        complete. Only one call at a time may write to it. After an interruption the same call resumes, and computes
        only chunks that are missing, damaged, or of other data or arguments. Input in chunks (dask, Zarr, OME-Zarr,
        compressed TIFF) is read once, each chunk as a whole, to a temporary file of the uncompressed size in the
        folder of `out`.
    client : distributed.Client or concurrent.futures.Executor, optional
        Workers that restore the chunks, one at a time in each process, within `memory`; by default this process does.
        It needs `out`, whose folder, and files of the recording, workers must see under the same path. Values are the
        same, bit by bit; this process writes them. If the client ends, the call raises RuntimeError, and the same
        call with a new client resumes.
    progress : callable, optional
        Called as ``progress(fraction, message)`` with the fraction of the work that is done, 0 to 1.
    """

    heading: ClassVar[str] = "Restoration"

    depth: Annotated[float | None, In(least=0.0, most=1e-2, unit="metres"), Shown(length="um")] = None
    wavelength: Annotated[tuple[float, ...] | None, Shown(length="nm"), _wavelengths] = None
    pixel: Annotated[float | None, In(above=0.0, unit="metres"), Shown(length="um"), camera_pixel] = None
    step: Annotated[float | None, In(above=0.0, unit="metres"), Shown(length="nm")] = None
    direction: Literal["auto", "up", "down"] = "auto"
    method: Annotated[RichardsonLucy | TotalVariation, _algorithm, HIDDEN] = _METHOD
    background: Annotated[float | str, _level, Shown(metavar="flat|uneven|COUNTS", parse=_level_or_text)] = "flat"
    diagnosis: Annotated[bool, Shown(negative="--no-diagnosis")] = True
    memory: Annotated[float | None, In(least=2.0**24, unit="bytes"), Shown(metavar="GIGABYTES", parse=_gigabytes)] = (
        None
    )
    out: Annotated[str | PathLike[str] | None, HIDDEN] = None
    client: Annotated[Any, HIDDEN] = None
    progress: Annotated[Report | None, HIDDEN] = None


@listed(DeconvolveOptions)
def deconvolve(
    stack: str | PathLike[str] | ArrayLike | Frames | Counts,
    microscope: Any,
    *,
    noise: Noise | None = None,
    options: DeconvolveOptions | None = None,
    **given: Any,
) -> RestoredStack:
    """Deconvolve a microscope stack: read voxel sizes, estimate noise, compute depth-dependent PSFs.

    Parameters
    ----------
    stack : path, array_like, Frames or Counts
        Recording, as in :func:`lommel.recorded.open_frames`: OME-TIFF, TIFF of ImageJ, OME-Zarr; arrays of
        NumPy, dask or Zarr, of shape (planes, height, width) or (channels, planes, height, width), of any real type.
        Saturated voxels are ignored: by default those with the largest value of 8, 10, 12, 14 or 16 bits, if several
        voxels of an integer stack have it. NaN, masked voxels and hot pixels are ignored, too;
        :meth:`lommel.Counts.of` states masks and saturation. All time points of a series are restored, one after the
        other. The steps of Richardson-Lucy for an array of CuPy or PyTorch run on its device, where the result is.
    microscope : Objective, Microscope, PSF or MeasuredPSF
        Objective, or microscope from :func:`lommel.load_microscope`. A Microscope also sets modality, emitter and
        aberrations, the default depth, and the wavelength, pixel and step of files without these values. Or the PSF
        of the stack, as in :class:`lommel.microscopy.StackBlur`, the same at all depths, with the step, pixels and
        direction of z of the recording; or a measured one (:meth:`lommel.PSF.measured`), which is resampled to the
        voxels of the recording. A list has one PSF for each channel. Its planes and window must contain the cone of
        light: beyond them it is assumed to be dark.
    noise : Noise, optional
        Noise of the camera, in the unit of the file; maps per pixel apply to each plane. By default estimated from
        each channel by :func:`lommel.microscopy.estimate_noise`. Counts have their own.
    options : DeconvolveOptions, optional
        Options as an object, changed by the following ones.
    {options}

    Returns
    -------
    RestoredStack

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range; if the voxel sizes or the wavelength are unknown, or the
        stack is thinner than three planes; if another call writes to `out`. For unreadable files
        :class:`lommel.recorded.RecordingError`.
    OSError, ImportError
        If a file cannot be read or written, or a library for it is not installed.

    Notes
    -----
    Steps are as in :class:`lommel.imaging.RichardsonLucy`, on all processors. Total variation has a closed form for
    each voxel, and no step raises its objective (De Pierro 1995, doi:10.1109/42.370409). Where voxels are small
    enough, those of the specimen are B-splines of degree 2 or 3 instead of points: positive voxels then have the same
    image as a point anywhere between them (Magain et al. 1998, doi:10.1086/305187).

    Each plane has the PSF of its depth, or all have a single one if PSFs hardly differ. If aberrations are not
    rotationally symmetric, a stack x is blurred as ``sum_s h_s * (w_s x)`` with at most nine PSFs h_s and weights w_s
    for each plane, as many as keep the interpolation error below 3 % of the light. The transpose of the blur is
    exact. PSFs have ``2 planes - 1`` planes, between 17 and 129, and the width of the light cone in the outermost
    plane, between 17 and 97 pixels; light beyond is blurred on a coarse grid. Half of these planes (at most a quarter
    of those of the stack, or 8) and pixels are restored beyond each face of the stack, to account for light from
    outside, of which one level is estimated for each plane.

    A point is restored in the plane in which its image is brightest (:meth:`lommel.Objective.focus`). Each plane of a
    wide-field or light-sheet PSF contains all light that the objective collects: a point that sends F photons into
    each of N planes of the PSF has the value N F. With a given PSF it has ``F * psf.values.sum()``, its light in the
    window.

    Stacks are restored in lateral chunks, as large as `memory` allows, each with half of the PSF window beyond it on
    all sides. All repeat the steps and extrapolations of the central chunk, and have its flat background. The result
    therefore differs from that of a single chunk: in a test with a known background the sum of absolute differences
    was 2.2 % of the light, after 5 steps and after 15 without extrapolation (``RichardsonLucy(accelerate=False)``).
    The result does not depend on the number of processors.

    Time points of a series are read and restored one by one. Direction of z, noise, PSFs, and the comparisons of PSFs
    are those of the first one, and each has its own background.

    Without `out` and with a single chunk, Ctrl-C keeps the completed steps, as ``stopped="interrupted"``. Otherwise
    it raises KeyboardInterrupt, and with `out` the same call resumes.

    Examples
    --------
    A stack that saturates at 4000 counts:

    >>> counts = lm.Counts.of(stack, noise=noise, saturation=4000)  # doctest: +SKIP
    >>> found = lm.microscopy.deconvolve(counts, microscope, depth=6e-6)  # doctest: +SKIP
    """
    return run(stack, microscope, noise, DeconvolveOptions.of("deconvolve", options, given))


class Tuning(NamedTuple):
    """Settings that are otherwise chosen: for tests and measurements."""

    window: tuple[int, int] | None = None  # planes and pixels of PSFs, odd
    margin: tuple[int, int] | None = None  # planes and pixels restored beyond the stack
    slabs: int | None = None  # number of PSFs, interpolated in depth
    tile: int | None = None  # side of chunks, pixels
    threads: int = 0  # 0 for all processors


def run(
    stack: Any,
    microscope: Any,
    noise: Noise | None,
    options: DeconvolveOptions,
    tuning: Tuning | None = None,
    *,
    mask: ArrayLike | None = None,
    saturation: float | None = None,
) -> RestoredStack:
    """Deconvolve a stack: see :func:`deconvolve`; masked voxels are left out."""
    tuning = tuning or Tuning()
    if (home := Placement.of(stack)) is not None:
        _require_here(home, options)
        stack = home.to_numpy(stack)
    workers = None if options.client is None else Workers.of(options.client)
    if workers is not None and options.out is None:
        raise ValueError("client needs out=, a folder that this process and the workers see")
    header: Metadata = {}
    if isinstance(stack, Counts):
        if noise is not None:
            raise TypeError("noise must be omitted if stack are Counts, which have their own")
        header = stack.metadata
        stack, noise, mask, saturation = stack.values, stack.noise, stack.mask, stack.stated
    validation.optional("noise", noise, Noise)
    if isinstance(microscope, PSF | MeasuredPSF) and options.direction == "down":
        raise ValueError("direction needs an objective, from which PSFs are computed, got a PSF")
    stated = Stated(options.depth, options.wavelength, options.pixel, options.step)
    array_mask: NDArray[np.bool_] | bool | None = False
    if isinstance(stack, np.ma.MaskedArray):
        stack, array_mask = validation.parted("stack", stack, "counts")
    with frames_of("stack", stack) as frames, ExitStack() as cleanup:
        recording = replace(frames, metadata=header | frames.metadata).as_channels(series=True)
        series = recording.axes[0] == "T"
        moments = [recording.one_of("T", k) for k in range(recording.shape[0])] if series else [recording]
        if noise is not None and not header:  # counts are complete
            noise, saturation = with_header(noise, saturation, recording.metadata)
        notes = without_missing(recording.notes, recording.metadata)
        found = sampled(moments[0], microscope, stated, tuning.window, notes)
        doubts = told_early(found.findings) + (missing := missing_findings(recording.metadata, noise, _MISSING))
        used = replace(recording, metadata=found.recording.metadata)
        ignored = _mask_of(mask, array_mask, moments[0].shape)
        names = used.metadata["names"]
        target = cleanup.enter_context(destination(options.out, recording.shape, used))
        report = options.progress or silent
        report(0.0, "reading the stack")
        at_once = _READ_SHARE * (_MEMORY if options.memory is None else options.memory)
        results: list[RestoredChannel] = []
        shared = [_Shared(options.direction, noise) for _ in names]
        parts, total = itertools.product(range(len(moments)), range(len(names))), len(moments) * len(names)
        for k, (moment, number) in enumerate(parts):
            if number == 0:  # the channels of a time point are read together, and those of the last one released
                reading = cleanup.enter_context(ExitStack())
                copied = local_stacks(moments[moment], target.unfinished, at_once, shared=workers is not None)
                stacks = reading.enter_context(copied)
            model = found.models[number]
            remarks = Remarks(notes if k == 0 else [])  # only the first channel adds notes
            if isinstance(model, GivenPSF):
                remarks.findings += model.findings
            prepare = partial(prepared, saturation=saturation, threads=tuning.threads, complete=not missing)
            hidden = None if ignored is None else unrepeated(ignored[number])
            task = stacks[number], model, shared[number].noise, remarks, hidden
            # Variances and hot pixels of whole planes take the memory of a worker, not of the client.
            context, remarks = called(workers, prepare, *task)
            if k == 0:
                notes[:] = remarks.notes
                remarks.notes = notes
            label = f"time {moment}, " * series + (f"{names[number]}: " if len(names) > 1 else "")
            result = _restored(
                context,
                options,
                tuning,
                remarks,
                target,
                (moment, number) if series else (number,),
                found.pixel_doubt,
                shared[number],
                workers,
                home,
                _within(report, k / total, (k + 1) / total, label),
            )
            results.append(replace(result, projections=results[number].projections) if moment else result)
            if result.stopped == INTERRUPTED:
                break
            if number == len(names) - 1:
                del stacks, context
                reading.close()
        values = target.finish(" ".join(in_words(doubts) + notes), len(results))
        values = values if home is None else home.put(values)
    findings = doubts + [
        finding if len(names) == 1 else replace(finding, text=f"{name}: {finding.text}")
        for number, name in enumerate(names)
        for finding in _over_time(results[number :: len(names)])
    ]
    summary = _summary(results, len(names) if series else 0)
    return RestoredStack(values, tuple(results), used, tuple(notes), findings=Findings(findings), summary=summary)


def _require_here(home: Placement, options: DeconvolveOptions) -> None:
    """Raise ValueError for options that arrays on a device do not support."""
    name = home.namespace.name
    for option in ("out", "client"):
        if getattr(options, option) is not None:
            raise ValueError(f"{option} needs a file, or an array of NumPy, dask or Zarr; stack is one of {name}")
    if isinstance(options.method, TotalVariation):
        raise ValueError(
            f"method must be RichardsonLucy for arrays of {name}, got TotalVariation: give a NumPy array"
        )


@dataclass
class _Shared:
    """What is estimated once for all time points of a channel, at the first of them or at the first misfit."""

    direction: str
    noise: Noise | None
    psfs: PSFs | None = None
    steps: int | None = None  # after which the result agrees best with held-out photons
    alternatives: list[str] | None = None  # PSFs that fit better than one that does not


def _over_time(results: Sequence[RestoredChannel]) -> list[Finding]:
    """Return the findings of the time points of a channel: of each code the worst one, and how many there are."""
    if len(results) < 2:
        return [finding for result in results for finding in result.findings]
    by_code: dict[str, list[tuple[int, Finding]]] = {}
    for time, result in enumerate(results):
        for finding in result.findings:
            by_code.setdefault(finding.code, []).append((time, finding))
    findings = []
    for same in by_code.values():
        worst = Findings(finding for _, finding in same)[0]  # the first of those of the highest severity
        time, count = next(time for time, finding in same if finding is worst), len({time for time, _ in same})
        place = f"time {time}" + f" and {count - 1} other{'s' * (count > 2)}" * (count > 1)
        numbers = {**worst.numbers, "time": time, "times": count}
        findings.append(replace(worst, text=f"{place}: {worst.text}", numbers=numbers))
    return findings


def _summary(results: Sequence[RestoredChannel], channels: int) -> str:
    """Return discrepancy and steps of each channel, of a time series (with so many `channels`) the range."""
    if not channels:
        return ", ".join(f"discrepancy {result.discrepancy:.4g} after {result.steps} steps" for result in results)
    values = [result.discrepancy for result in results]
    steps = [result.steps for result in results]
    return (
        f"{math.ceil(len(results) / channels)} time points, discrepancy {min(values):.4g} to {max(values):.4g} (time "
        f"{int(np.argmax(values)) // channels}) after {min(steps)} to {max(steps)} steps"
    )


def _mask_of(
    mask: ArrayLike | None, array_mask: NDArray[np.bool_] | bool | None, shape: tuple[int, ...]
) -> NDArray[np.bool_] | None:
    """Return the voxels to ignore (True), in the given `shape` of four axes; None if there are none."""
    ignored = np.asarray(False if array_mask is None else array_mask)
    if mask is not None:
        user_mask = validation.array("mask", mask)
        if user_mask.dtype != bool or user_mask.shape not in (shape[2:], shape[1:], shape):
            raise ValueError(
                f"mask must be True or False for each pixel {shape[2:]} or voxel {shape[1:]}, got {user_mask.dtype} "
                f"of shape {user_mask.shape}"
            )
        ignored = ignored | user_mask
    return np.broadcast_to(ignored, shape) if np.any(ignored) else None


def _restored(
    context: StackContext,
    options: DeconvolveOptions,
    tuning: Tuning,
    remarks: Remarks,
    target: Target,
    place: tuple[int, ...],
    pixel_doubt: str,
    shared: _Shared,
    workers: Workers | None,
    home: Placement | None,
    report: Report,
) -> RestoredChannel:
    """Restore a prepared channel: orient, solve, check."""
    shape = context.stack.shape
    crop = called(workers, select_crop, context.stack, context.model.window[1], context.saturation)
    stages = _progress_parts(shape, crop, options, workers)
    context = oriented(context, crop, shared.direction, remarks.notes, _within(report, 0.0, stages[0]))
    model = context.model
    shared.direction, shared.noise = "down" if model.is_reversed else "up", context.camera
    margin = tuning.margin or (min(model.window[0] // 2, max(_MIN_MARGIN, shape[0] // 4)), model.window[1] // 2)
    background = _background(options.background)
    level, best_steps, comparison = None, 0, None
    if options.diagnosis:
        level, best_steps, comparison = compare_held_out(
            context,
            margin,
            remarks.findings,
            _within(report, *stages),
            flat=background == Background(None),
            pixel_doubt=pixel_doubt,
            steps=shared.steps,
        )
        shared.steps = best_steps
    report(stages[-1], "PSFs")
    psfs = shared.psfs = shared.psfs or called(workers, model.psfs, margin[0], tuning.slabs)
    depths = psfs.planes[margin[0] : margin[0] + shape[0]]
    remarks.notes += _psf_notes(model, psfs, depths)
    side = chunk_side(context, margin, psfs, options.method, tuning.tile, options.memory or _MEMORY)
    if tuning.margin is None and shape[0] < model.window[0] // 2:
        remarks.notes.append("The stack is thinner than its PSF: light from planes beyond it is not restored.")
    course = Course(
        options.method, background if level is None else Background(level), best_steps, margin, psfs, side, home
    )
    last_fraction = stages[-1]

    def report_chunks(fraction: float, message: str) -> None:
        nonlocal last_fraction
        last_fraction = stages[-1] + (1.0 - stages[-1]) * fraction
        report(last_fraction, message)

    projections, floor = ProjectionBuilder((shape[0], shape[1], shape[2])), Floor()
    request = ""
    if target.unfinished is not None:
        request = _request(context, course, options, called(workers, _image_checksums, model, psfs.depths))
    parts = projections, floor
    outcome = restore_chunks(context, course, target, place, request, parts, remarks.doubts, report_chunks, workers)
    if background.level is None:
        low, high = float(np.min(outcome.background)), float(np.max(outcome.background))
        text = f"A flat background of {low:.4g}" if low == high else f"A background of {low:.4g} to {high:.4g}"
        remarks.notes.append(
            f"{text} counts per voxel was estimated, which the restored values exclude; set background= for another "
            "level, 0 for none."
        )
    report = _within(report, min(last_fraction, 0.5), 1.0)
    _conclude(outcome, floor, context, options, remarks, shared, comparison, workers, report)
    return RestoredChannel(
        discrepancy=outcome.deviance_after / outcome.voxels,
        before=outcome.deviance_before / outcome.voxels,
        steps=outcome.steps,
        stopped=outcome.stopped,
        noise=context.camera,
        direction=shared.direction,
        depths=depths[::-1] if model.is_reversed else depths,
        psf_depths=psfs.depths,
        projections=projections.result(reverse=model.is_reversed),
        background=outcome.background,
        strength=outcome.strength,
        findings=Findings(remarks.findings),
    )


def _background(argument: float | str) -> Background:
    """Return the background: a known level, or the number of points at which it is estimated."""
    return Background(None, _BACKGROUNDS[argument]) if isinstance(argument, str) else Background(argument)


def _psf_notes(model: DepthModel | GivenPSF, psfs: PSFs, depths: Array) -> list[str]:
    """Return notes on the depths of the PSFs, and on the unit of a restored value."""
    notes: list[str] = []
    planes_above = int((depths <= 0.0).sum())
    if planes_above > 1:
        notes.append(
            f"{planes_above} of {len(depths)} planes are focused above the sample, in the cover glass or at its "
            f"surface, if the middle plane is focused at a depth of {format_length(model.depth, digits=3)}; set "
            "depth= if not."
        )
    if len(psfs.depths) > 1:
        placement = "interpolated in depth"
        if psfs.radial is not None:
            margins = len(psfs.depths) - len(depths)
            placement = f"one for each of {len(depths)} planes, and of {margins} restored above and below them"
        depth_range = format_depth_range(psfs.depths[0], psfs.depths[-1])
        notes.append(
            f"The PSF changes with depth: {len(psfs.depths)} were used, {placement}, at depths from {depth_range}."
        )
    planes, share = model.window[0], f"each plane (if it fades, into their mean) has the value {model.window[0]}"
    if not (model.spreads or model.keeps_light):
        light = model.point_image(psfs.depths[len(psfs.depths) // 2]).sum(axis=(1, 2))
        share = f"the plane in focus has the value {light.sum() / light.max():.3g}"
    where = f" of {model.window[1]} x {model.window[1]} pixels" if isinstance(model, GivenPSF) else ""
    notes.append(
        f"Restored values are the light of a voxel in all {planes} planes{where} of its PSF together: a point "
        f"that sends F counts into {share} F."
    )
    return notes


def _image_checksums(model: DepthModel | GivenPSF, depths: Array) -> list[str]:
    """Return the checksums of the first and last PSF, which represent the optics."""
    return [hashlib.sha256(model.point_image(depths[k]).tobytes()).hexdigest() for k in (0, -1)]


def _request(context: StackContext, course: Course, options: DeconvolveOptions, ends: list[str]) -> str:
    """Return the checksum of all inputs of the restored values."""
    model, stack = context.model, context.stack
    camera = {
        name: value if np.ndim(value) == 0 else checksum(value[np.newaxis])
        for name, value in vars(context.camera).items()
    }
    content = (
        checksum(stack), stack.shape, str(stack.dtype), ends, model.pixel, model.step, model.depth,
        course.psfs.depths.tolist(), course.margin, course.side, model.is_reversed, camera, options.method,
        context.saturation, course.background, options.background == "flat", options.diagnosis,
    )  # fmt: skip
    return hashlib.sha256(repr(content).encode()).hexdigest()


def _conclude(
    outcome: Outcome,
    floor: Floor,
    context: StackContext,
    options: DeconvolveOptions,
    remarks: Remarks,
    shared: _Shared,
    comparison: HeldOut | None,
    workers: Workers | None,
    report: Report,
) -> None:
    """Add the findings of the restoration. A misfit lists the alternative PSFs that fit the stack better."""
    finding, findings, model = outcome.finding, remarks.findings, context.model
    if finding is not None:
        can_try = isinstance(model, DepthModel) and options.diagnosis and "hot_pixels" not in remarks.doubts
        if finding.code == "misfit" and can_try:
            if shared.alternatives is None:
                comparison = comparison or HeldOut(context, report)
                shared.alternatives = comparison.alternatives(report, try_reversed=options.direction != "auto")
            finding = _explain_misfit(finding, shared.alternatives)
        if finding.code == "misfit" and isinstance(model, DepthModel):
            text = f"{finding.text}; next, measure the PSF with beads (--psf, lm.PSF.measured)"
            finding = replace(finding, text=text)
        findings.append(finding)
    if outcome.is_structured and (uneven := floor.finding(context.stack.shape, _background(options.background))):
        findings.append(uneven)
    if outcome.is_structured and model.keeps_light:
        background = float(np.mean(outcome.background))
        check = partial(plane_light_findings, reverse=model.is_reversed)
        findings += called(workers, check, context.stack, context.camera, background, context.saturation)
    if isinstance(model, GivenPSF) and not model.is_contained:
        rim = f"{percent(model.rim)} on its rim"
        side = model.window[1]
        text = (
            f"not tested: light beyond the window of the PSF, {side} x {side} pixels ({rim}): record a larger image, "
            "or beads farther apart"
        )
        findings.append(Finding("untested", "note", text, {"rim": model.rim, "most": MAX_RIM}))
    if outcome.stopped == INTERRUPTED:
        findings.append(Finding("interrupted", "error", "it was interrupted: the completed steps are kept"))


def _explain_misfit(misfit: Finding, alternatives: list[str]) -> Finding:
    """Return the misfit with the PSFs that fit the stack better; if there are none, with the severity "doubt"."""
    if not alternatives:
        text = (
            "the residual exceeds the noise, but no other PSF fits better: rows or planes may be displaced or of "
            "unequal light, points lie between voxels, or the gain is wrong: see residuals by row and plane, and "
            "check `white` and `read` of the noise"
        )
        return replace(misfit, severity="doubt", text=text)
    text = f"PSFs with {alternatives[0]} fit the stack better"
    if len(alternatives) > 1:
        likeliest = ", ".join(alternatives)
        text = f"other PSFs fit the stack better; one of these values may be wrong, the likeliest first: {likeliest}"
    return replace(misfit, text=text, numbers={**misfit.numbers, "others": alternatives})


def _within(report: Report, begin: float, end: float, name: str = "") -> Report:
    """Return a callback that maps the progress of one part, 0 to 1, to `begin` to `end` of the whole work."""
    return lambda fraction, message: report(begin + (end - begin) * fraction, name + message)


def _progress_parts(
    shape: tuple[int, ...], crop: tuple[slice, slice], options: DeconvolveOptions, workers: Workers | None
) -> tuple[float, float]:
    """Return the progress, 0 to 1, after each of the estimates, by this process: direction of z, held-out photons."""
    part = math.prod(pixels.stop - pixels.start for pixels in crop) / (shape[1] * shape[2])
    oriented = part * DIRECTION_STEPS if options.direction == "auto" else 0.0
    compared = estimated_held_out_steps(shape) if options.diagnosis else 0.0
    steps = options.method.steps if options.method.target == 0.0 else min(_USUAL_STEPS, options.method.steps)
    total = oriented + compared + steps / (1 if workers is None else workers.at_once)
    return oriented / total, (oriented + compared) / total


def format_depth_range(low: float, high: float) -> str:
    """Return a range of depths in one unit, in words."""
    return f"{format_length(low, like=high, digits=3).split()[0]} to {format_length(high, digits=3)}"
