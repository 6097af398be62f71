"""Restoration of microscope stacks from their files: metadata, noise, depth-dependent PSFs, chunks, projections."""

from __future__ import annotations

import hashlib
import math
import time as clock
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field, replace
from os import PathLike
from pathlib import Path
from threading import Lock
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Protocol, cast

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import atomic, reading, validation
from lommel.base.arrays import Array, Json, Values
from lommel.base.atomic import Unfinished
from lommel.base.optional import version
from lommel.base.units import format_length, with_error
from lommel.base.validation import line, shown
from lommel.deconvolve.algorithms import EARLIEST, STEPS, ProgressCallback, RichardsonLucy, TotalVariation, silent
from lommel.deconvolve.iterations import Background, Iteration, StepSettings, iteration_of
from lommel.deconvolve.likelihood import PoissonLikelihood
from lommel.deconvolve.linear import PlaneOperator, tiles_of
from lommel.fit.findings import Finding, Findings, FitReport
from lommel.microscopy import depth_model
from lommel.microscopy.deconvolution import FLAT, Floor, background_of, margins_of, plane_light_findings
from lommel.microscopy.depth_model import MODALITIES, SPREADING, DepthModel, PSFs
from lommel.microscopy.held_out import MAX_VOXELS, SIDE, HeldOut, estimated_held_out_steps, stopping_rule
from lommel.microscopy.refinement import (
    PARAMETERS,
    StackContext,
    estimate_z_direction,
    estimated_steps,
    rank_alternatives,
    refined,
    select_crop,
)
from lommel.optics.layers.emitter import Emitter, emitter_of
from lommel.optics.layers.objective import Objective
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.recorded import stack_files
from lommel.recorded.camera_noise import (
    MAX_HOT_FRACTION,
    MaskedStack,
    contradiction,
    hot_pixel_findings,
    hot_pixels,
    hot_voxels,
    measured_noise,
    sharpness,
)
from lommel.recorded.copies import local_stacks
from lommel.recorded.counts import PlanePart, Stack, full_value, plane_of
from lommel.recorded.frames import Frames, frames_of
from lommel.recorded.noise import Noise
from lommel.show import estimates as pictures

if TYPE_CHECKING:
    from matplotlib.figure import Figure


INTERRUPTED = "interrupted"
"""Value of `stopped` after Ctrl-C: the result of the last complete step is kept."""

MISFIT = "misfit"
"""Value of `stopped` where the residual exceeds the noise and no longer decreases."""

_DIRECTIONS = ("auto", "up", "down")
_MEMORY = 2.0**31  # default memory limit, bytes
_READ_SHARE = 0.125  # fraction of the memory limit in which chunks of the recording are read together
_TOLERANCE = 0.02  # relative difference between values of the file and of the objective above which a note is added
_FINEST = 5e-9  # finest pixel in the sample times NA, metres: a twentieth of Nyquist sampling at 400 nm
_DARK_FRACTION = 0.02  # fraction of voxels darker than the offset above which a note is added
_USUAL_STEPS = 60  # typical number of steps of a restoration, for the progress display
_MISFIT_PROGRESS = 0.3  # progress shown after `EARLIEST` steps, when the restoration may end as a misfit
_MIN_MARGIN = 8  # smallest default margin, planes

Report = Callable[[float, str], object]


@dataclass(frozen=True, eq=False, repr=False)
class RestoredChannel:
    """Settings and quality of the restoration of one channel.

    Attributes
    ----------
    discrepancy, before : float
        Poisson deviance per voxel after the restoration, and before it, where the recording itself is the estimate of
        the specimen; about 1 if PSF and noise model are right.
    steps : int
        Number of steps of the central chunk.
    stopped : str
        "noise", "steps" or "misfit" as in :class:`lommel.imaging.Restoration`; "interrupted" after Ctrl-C.
    noise : Noise
    direction : str
        "up" if the planes run from the cover glass into the sample, else "down".
    depths : ndarray of float, shape (planes,)
        Depth below the cover glass that is in focus in each plane, in the order of the recording, metres.
    psf_depths : ndarray of float
        Depths of the PSFs that were used.
    refined, errors : dict of float
        Estimates and standard errors of the parameters of `refine`, by name. A standard error combines photon noise
        and the change of the estimate since half of the steps; inf if the stack does not determine the parameter.
    projections : Projections
        Maximum projections of recording and result, and projected residuals, along z and along y, as drawn by
        :meth:`RestoredStack.plot`. NaN in chunks that an earlier call restored.
    background : float or ndarray of shape (height, width)
        Background per voxel, in the unit of the recording, without the camera offset. Restored values exclude it.
    strength : float or None
        Weight of the total variation.
    findings : Findings
        Results of the checks of this channel.
    """

    discrepancy: float
    before: float
    steps: int
    stopped: str
    noise: Noise
    direction: str
    depths: Array = field(repr=False)
    psf_depths: Array = field(repr=False)
    refined: dict[str, float]
    errors: dict[str, float]
    projections: Projections = field(repr=False)
    background: float | Array = 0.0
    strength: float | None = None
    findings: Findings = field(default_factory=Findings)


@dataclass(frozen=True, eq=False, repr=False)
class RestoredStack(FitReport):
    """Result of :func:`lommel.microscopy.restore`; converts to an array of its values.

    Attributes
    ----------
    values : ndarray of float32, or array of Zarr
        Restored light in the unit of the recording, without the camera offset. Planes are in the order of the
        recording; the shape is (planes, height, width), or (channels, planes, height, width) for several channels and
        with `out`.
    channels : tuple of RestoredChannel
    recording : Frames
        The recording along C, Z, Y and X, with the voxel sizes and wavelengths that were used in its metadata.
    notes : tuple of str
        Sentences on the values that were taken from the file, estimated or assumed.
    findings : Findings
        Results of the checks of all channels. Errors: "misfit" and "too_quiet". Doubts: "psf_doubtful", where
        held-out photons agree better with another PSF; "misfit" where no other PSF fits better; "hot_pixels",
        "not_settled" and "interrupted". All other findings are notes. Findings set ``converged``, ``reliable`` and
        ``status``.
    summary : str
        Discrepancy and number of steps of each channel.
    """

    values: Any = field(repr=False)
    channels: tuple[RestoredChannel, ...]
    recording: Frames = field(repr=False)
    notes: tuple[str, ...]

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> Values:
        """Return the values."""
        return np.array(self.values[...], dtype=dtype, copy=copy)

    def __repr__(self) -> str:
        """Return the result in one line."""
        size = " x ".join(map(str, self.values.shape))
        first = self.channels[0]
        return (
            f"<RestoredStack, {size}: discrepancy {first.before:.3g} before, {first.discrepancy:.3g} after "
            f"{first.steps} steps, stopped by {first.stopped!r}>"
        )

    def to_dict(self) -> Json:
        """Return the result as data that can be written as JSON, without `values`.

        Returns
        -------
        dict
            The entries of ``FitReport.to_dict()``, the shape, and the voxel sizes (metres). Each channel has its
            name, wavelength, smallest and largest depth, number of PSFs, and mean background.
        """
        result = super().to_dict()
        stated = self.recording.metadata
        channels = zip(result["channels"], self.channels, stated["names"], stated["emission"], strict=False)
        for entry, channel, name, wave in channels:
            entry |= {"name": name, "wavelength": wave, "psfs": len(channel.psf_depths)}
            entry["depths"] = [float(channel.depths.min()), float(channel.depths.max())]
            entry["background"] = float(np.mean(channel.background))
        sizes = {"pixel_in_sample": stated["pixel"], "step": stated["step"]}
        return {"shape": list(self.values.shape[-3:])} | sizes | result

    def plot(self) -> Figure:
        """Return a matplotlib figure of maximum projections before and after, and of the normalized residual.

        Projections along z (xy) are above projections along y (xz), with a scale bar. The residual in units of the
        noise is summed along each projected line and divided by the square root of its number of voxels. If PSF and
        noise model are right, the residual has no pattern, and its modulus rarely exceeds 3.

        Returns
        -------
        matplotlib Figure

        Raises
        ------
        ImportError
            If matplotlib is not installed.
        """
        show_names = len(self.channels) > 1
        labelled = [
            (f"{name}: " if show_names else "", channel.projections)
            for name, channel in zip(self.recording.metadata["names"], self.channels, strict=False)
        ]
        caption = "; ".join(
            f"{name}discrepancy {channel.before:#.3g} before, {channel.discrepancy:#.3g} after {channel.steps} steps"
            for (name, _), channel in zip(labelled, self.channels, strict=True)
        )
        sides = self.recording.metadata["step"], self.recording.metadata["pixel"]
        return pictures.projections(labelled, sides, caption)

    def save(self, *paths: str | PathLike[str]) -> None:
        """Write the stack with its voxel sizes, channels and wavelengths.

        Parameters
        ----------
        *paths : path
            Files to write: OME-TIFF if the name ends in .tif or .tiff, OME-Zarr (0.4) if it ends in .zarr. Each file
            is written under a temporary name and then renamed.

        Raises
        ------
        ValueError
            If a name has another suffix, or is the name of the recording.
        OSError, ImportError
            If a file cannot be written, or tifffile or zarr is not installed.
        """
        places = [validation.path("paths", path) for path in paths]
        for place in places:
            stack_files.kind_of(place, self.recording.path)
        values = np.asarray(self.values[...], np.float32)
        values = values[np.newaxis] if values.ndim == 3 else values
        for place in places:
            stack_files.save_stack(place, values, self.recording, " ".join(self.notes))


def restore(
    stack: str | PathLike[str] | ArrayLike | Frames,
    objective: Any,
    *,
    depth: float | None = None,
    wavelength: float | Sequence[float] | None = None,
    pixel: float | None = None,
    step: float | None = None,
    channel: int | None = None,
    time: int | None = None,
    axes: str | None = None,
    noise: Noise | None = None,
    saturation: float | None = None,
    mask: ArrayLike | None = None,
    modality: str = "widefield",
    excitation: float | None = None,
    pinhole: float = 1.0,
    thickness: float | None = None,
    direction: str = "auto",
    slabs: int | None = None,
    refine: Sequence[str] = (),
    method: RichardsonLucy | TotalVariation | None = None,
    background: float | str = FLAT,
    psf_shape: tuple[int, int] | None = None,
    margin: tuple[int, int] | None = None,
    tile: int | None = None,
    memory: float = _MEMORY,
    diagnosis: bool = True,
    per_plane: bool = False,
    out: str | PathLike[str] | None = None,
    progress: Report | None = None,
    threads: int | None = None,
) -> RestoredStack:
    """Deconvolve a microscope stack from its file: read voxel sizes, estimate noise, compute depth-dependent PSFs.

    Parameters
    ----------
    stack : path or array_like
        Recording, as in :func:`lommel.recorded.open_frames`: OME-TIFF, TIFF of ImageJ, OME-Zarr; arrays of
        NumPy, dask or Zarr, of shape (planes, height, width) or (channels, planes, height, width), of any real type.
    objective : Objective or Microscope
        Objective, or microscope from :func:`lommel.load_microscope`. A Microscope also sets emitter and aberrations,
        the default depth, and the wavelength, pixel and step of files without these values.
    depth : float, optional
        Depth below the cover glass that is in focus in plane ``planes // 2``, counted from 0 in the order of the
        recording, metres. By default the depth of the Microscope; for an Objective ``planes // 2 * step``, as if the
        stack began at the glass.
    wavelength : float or sequence of float, optional
        Emission wavelength, metres; one value, or one for each channel. By default the wavelength in the file.
    pixel, step : float, optional
        Pixel pitch on the camera, and stage displacement between planes, metres. By default the values in the file;
        the file's pixel size in the sample is multiplied by the magnification.
    channel, time : int, optional
        Channel and time point to restore; by default all channels, and the only time point.
    axes : str, optional
        Axes of the stack, such as "ZYX" or "CZYX", if the file does not state them or states wrong letters.
    noise : Noise, optional
        Noise of the camera, in the unit of the file; maps per pixel apply to each plane. By default estimated from
        each channel by :func:`lommel.microscopy.estimate_noise`.
    saturation : float, optional
        Smallest value of saturated voxels, which are ignored. By default the largest value of 8, 10, 12, 14 or 16
        bits, if several voxels of an integer stack have it. NaN, masked voxels and hot pixels are ignored, too.
    mask : array_like of bool, optional
        True for voxels to ignore, in the shape (height, width) for all planes, or of the stack. The mask of a NumPy
        masked array applies, too.
    modality : {"widefield", "confocal", "spinning disc", "light sheet", "two-photon"}, default "widefield"
    excitation : float, optional
        Vacuum wavelength of the excitation, metres; needed for "confocal", "spinning disc" and "two-photon" if the
        file does not state it.
    pinhole : float, default 1
        Pinhole diameter in Airy units, for "confocal" and "spinning disc".
    thickness : float, optional
        Full width at half maximum of the "light sheet", metres; the sheet stays in the focal plane.
    direction : {"auto", "up", "down"}, default "auto"
        "up": the first plane is the nearest to the cover glass. "auto" tries both directions and selects the more
        likely one, or "up" if the data do not determine the direction.
    slabs : int, optional
        Number of PSFs over the depth of the stack, interpolated linearly in depth; 1 for a single PSF. By default one
        for each plane, or a single one if PSFs hardly differ. If aberrations are not rotationally symmetric, the
        default is the number that keeps the interpolation error below 3 % of the light, at most 9.
    refine : sequence of {"depth", "sample", "spherical"}
        Parameters estimated before the restoration, by maximum likelihood: the depth, the refractive index of the
        sample, or the spherical aberration (waves rms).
    method : RichardsonLucy or TotalVariation, optional
        Algorithm, as in :func:`lommel.microscopy.deconvolve`: by default ``lm.imaging.RichardsonLucy(target=1.0)``.
    background : "flat", "uneven" or float, default "flat"
        Background, as in :func:`lommel.microscopy.deconvolve`. A "flat" background is estimated together with the
        specimen of the central chunk, or, with `diagnosis` and at most 500000 voxels, before it from held-out
        photons. An "uneven" background is estimated in each chunk separately, and is best used without chunks.
    psf_shape : (int, int), optional
        Planes and pixels of the PSFs, odd. By default ``2 planes - 1`` planes, between 17 and 129, and the width of
        the light cone in the outermost plane, between 17 and 97 pixels.
    margin : (int, int), optional
        Planes and pixels restored beyond the stack, as in :func:`lommel.microscopy.deconvolve`.
    tile : int, optional
        Side of lateral chunks, pixels. By default as large as `memory` allows. Chunks overlap by the PSF window. All
        chunks repeat the steps and extrapolations of the central chunk, so the result differs from the result of a
        single chunk. In a test the sum of absolute differences was 3 % of the light after 5 steps and 17 % after 25
        steps, or 2 % without extrapolation (``RichardsonLucy(accelerate=False)``).
    memory : float, default 2**31
        Limit of the memory in addition to input and output, bytes. Without `out`, input in chunks (see `out`) is in
        memory as a whole. A chunk larger than an eighth of the limit is nevertheless read as a whole.
    diagnosis : bool, default True
        Whether to hold out some photons, to estimate the background and the number of steps and to compare PSFs for
        other sample indices in a part of the stack; and whether to try other PSFs after a misfit. The computing time
        increases by a factor of 2 to 4 for 20 x 40 x 40 voxels, and by a factor of 2 to 3 for 41 x 96 x 96 voxels.
    per_plane : bool, default False
        Whether a restored value is the light that the objective collects in a single plane, rather than the sum over
        all planes of the PSF window; for "widefield" and "light sheet".
    out : path, optional
        Folder NAME.zarr for stacks larger than memory; it may replace only an earlier restored stack. Values are
        written chunk by chunk to the hidden folder ``.NAME.zarr.unfinished`` beside `out`, which is renamed when
        complete. Only one call at a time may write to it. After an interruption the same call resumes, and computes
        only chunks that are missing, damaged, or of other data or arguments. Input in chunks (dask, Zarr, OME-Zarr,
        compressed TIFF) is read once, each chunk as a whole, to a temporary file of the uncompressed size in the
        folder of `out`.
    progress : callable, optional
        Called as ``progress(fraction, message)`` with the fraction of the work that is done, 0 to 1.
    threads : int, optional
        Number of threads, by default the number of processors. The result does not depend on it.

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
    A point is restored in the plane in which its image is brightest (:meth:`lommel.Objective.focus`). Each plane of a
    wide-field or light-sheet PSF contains all light that the objective collects. Light beyond the window of the PSF
    is blurred on a coarse grid, and light from outside of the field of view is estimated, with one level for each
    plane. With `slabs` a stack x is blurred as ``sum_s h_s * (w_s x)``, with PSFs h_s and weights w_s for each plane.
    The transpose of the blur is exact. Without `out` and with a single chunk, Ctrl-C keeps the completed steps, as
    ``stopped="interrupted"``. Otherwise it raises KeyboardInterrupt, and with `out` the same call resumes.
    """
    validation.choice("modality", modality, MODALITIES)
    if validation.truth("per_plane", per_plane) and modality not in SPREADING:
        raise ValueError(f"per_plane must be False for modality={modality!r}, which records only light in focus")
    algorithm = RichardsonLucy(target=1.0) if method is None else method
    options = _Options(
        noise, saturation, direction, slabs, refine, algorithm, background, margin, tile, memory, threads, per_plane,
        diagnosis,
    )  # fmt: skip
    validation.function("progress", progress, required=False)
    lens, microscope = _objective(objective)
    array_mask: NDArray[np.bool_] | bool | None = False
    if isinstance(stack, np.ma.MaskedArray):
        stack, array_mask = validation.parted("stack", stack)
    with frames_of("stack", stack) as frames, ExitStack() as cleanup:
        recording = frames.as_channels(time=time, axes=axes)
        numbers = range(recording.shape[0])
        if channel is not None:
            number = validation.integer("channel", channel, least=0, most=recording.shape[0] - 1)
            numbers = range(number, number + 1)
        notes = list(recording.notes)
        sizes = _Sizes(recording, lens, microscope, pixel, step, notes)
        waves = _wavelengths(recording, microscope, wavelength, numbers, notes)
        optics = depth, modality, excitation, pinhole, thickness, psf_shape
        models = [
            _model(recording, lens, microscope, sizes, wave, number, *optics)
            for number, wave in zip(numbers, waves, strict=True)
        ]
        if depth is None and microscope is None:
            notes.append(
                "The middle plane was assumed to be focused at a depth of "
                f"{format_length(models[0].depth, digits=3)}, as if the stack began at the cover glass; set depth= "
                "if not."
            )
        used = {"pixel": sizes.pixel / lens.magnification, "step": sizes.step, "emission": tuple(waves)}
        used |= {name: tuple(recording.metadata[name][k] for k in numbers) for name in ("names", "excitation")}
        used_recording = replace(recording, metadata=recording.metadata | used)
        ignored = _mask_of(mask, array_mask, recording.shape)
        target = cleanup.enter_context(_destination(out, (len(numbers), *recording.shape[1:]), used_recording))
        report = progress or silent
        report(0.0, "reading the stack")
        frames = replace(recording, numbers=recording.numbers[numbers.start : numbers.stop])
        place = None if target.unfinished is None else target.unfinished.place
        stacks = cleanup.enter_context(local_stacks(frames, place, options.memory * _READ_SHARE))
        results = _restore_channels(
            recording, stacks, numbers, models, options, ignored, target, notes, sizes.pixel_doubt, report
        )
        values = target.finish(" ".join(notes), len(results))
    findings = Findings(
        finding if len(numbers) == 1 else replace(finding, text=f"{name}: {finding.text}")
        for name, result in zip(used_recording.metadata["names"], results, strict=False)
        for finding in result.findings
    )
    summary = ", ".join(f"discrepancy {result.discrepancy:.4g} after {result.steps} steps" for result in results)
    return RestoredStack(values, tuple(results), used_recording, tuple(notes), findings=findings, summary=summary)


@dataclass(frozen=True)
class _Options:
    """Arguments of :func:`restore` that apply to the restoration of each channel."""

    noise: Noise | None
    saturation: float | None
    direction: str
    slabs: int | None
    refine: Sequence[str]
    method: RichardsonLucy | TotalVariation
    background: float | str
    margin: tuple[int, int] | None
    tile: int | None
    memory: float
    threads: int | None
    per_plane: bool
    diagnosis: bool

    def __post_init__(self) -> None:
        validation.choice("direction", self.direction, _DIRECTIONS)
        validation.optional("noise", self.noise, Noise)
        validation.optional("method", self.method, RichardsonLucy, TotalVariation)
        validation.truth("diagnosis", self.diagnosis)
        validation.real("memory", self.memory, least=2.0**24)
        for name in _list_of_names("refine", self.refine):
            validation.choice("refine", name, PARAMETERS)
        if self.threads is not None:
            validation.integer("threads", self.threads, least=1, most=1024)
        if self.margin is not None:
            margins_of(self.margin)
        background_of(self.background)


def _restore_channels(
    recording: Frames,
    stacks: Sequence[Stack],
    numbers: range,
    models: Sequence[DepthModel],
    options: _Options,
    ignored: NDArray[np.bool_] | None,
    target: _Target,
    notes: list[str],
    pixel_doubt: str,
    report: Report,
) -> list[RestoredChannel]:
    """Restore the channels until an interruption. Only the first channel adds notes."""
    results: list[RestoredChannel] = []
    for place, (number, model) in enumerate(zip(numbers, models, strict=True)):
        channel_notes = notes if place == 0 else []
        job = _ChannelRestoration(stacks[place], model, options, channel_notes, target, place, pixel_doubt)
        report_part = _within(report, place / len(numbers), (place + 1) / len(numbers))
        name = "" if len(numbers) == 1 else f"{recording.metadata['names'][number]}: "

        def report_named(part: float, message: str, report_part: Report = report_part, name: str = name) -> None:
            report_part(part, name + message)

        results.append(job.run(None if ignored is None else ignored[number], report_named))
        if results[-1].stopped == INTERRUPTED:
            break
    return results


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


def _list_of_names(name: str, names: object) -> list[str]:
    if isinstance(names, str) or not isinstance(names, Sequence):
        raise TypeError(f'{name} must be a sequence of names, such as ("depth",), got {shown(names)}')
    return list(names)


class MicroscopeData(Protocol):
    """Result of :func:`lommel.load_microscope`: an objective and its recording parameters (lengths in metres)."""

    objective: Objective
    wavelength: float
    depth: float
    pixel: float
    step: float
    emitter: Emitter
    aberrations: Wavefront | None


def _objective(argument: Any) -> tuple[Objective, MicroscopeData | None]:
    """Return the objective, and the microscope, None for an Objective."""
    if isinstance(argument, Objective):
        return argument, None
    if isinstance(getattr(argument, "objective", None), Objective):
        return argument.objective, argument
    raise TypeError(
        f"objective must be an Objective, or a Microscope from lommel.load_microscope, got {shown(argument)}"
    )


class _Sizes:
    """Pixel pitch on the camera and stage step between planes, metres, from arguments, file or microscope."""

    def __init__(
        self,
        recording: Frames,
        lens: Objective,
        microscope: MicroscopeData | None,
        pixel: float | None,
        step: float | None,
        notes: list[str],
    ) -> None:
        self.pixel_doubt = ""  # note on a pixel of the stack that contradicts the objective file
        stated = recording.metadata
        of_file = None if stated["pixel"] is None else stated["pixel"] * lens.magnification
        sizes = (None, None) if microscope is None else (microscope.pixel, abs(microscope.step) or None)
        self.pixel = self._length("pixel", pixel, of_file, sizes[0], recording, notes)
        self.step = self._length("step", step, stated["step"], sizes[1], recording, notes)
        if pixel is not None:
            validation.pixel(self.pixel, metric=True)
            if self.pixel < _FINEST / lens.NA * lens.magnification:
                # The usual cause is a pixel size in the sample, instead of the pitch on the camera.
                value, camera = format_length(self.pixel), format_length(self.pixel * lens.magnification)
                raise ValueError(
                    f"pixel must be the pitch on the camera, got {value}, which is"
                    f" {format_length(self.pixel / lens.magnification)} in the sample; for {value} in the sample give"
                    f" pixel={camera}"
                )
        if not 0.0 < self.step < 1e-4:
            raise ValueError(f"step must be a stage displacement, above 0 and below 1e-4 metres, got {self.step:g}")
        if stated["NA"] is not None and abs(stated["NA"] - lens.NA) > _TOLERANCE * lens.NA:
            notes.append(f"NA {lens.NA:g} of the objective was used; the file states NA {stated['NA']:g}.")

    def _length(
        self,
        name: str,
        argument: float | None,
        of_file: float | None,
        of_microscope: float | None,
        recording: Frames,
        notes: list[str],
    ) -> float:
        """Return the length in the argument, else in the file, else of the microscope; note differences."""
        if argument is not None:
            value = validation.real(name, argument, above=0.0)
            if of_file is not None and abs(value - of_file) > _TOLERANCE * of_file:
                notes.append(f"The argument {name}={format_length(value)} was used, not the value of the file.")
            return value
        source = "an array" if recording.path is None else line(recording.path)
        if words := recording.metadata["unusable"].get(name):
            place = "in the sample" if name == "pixel" else "between planes"
            raise ValueError(
                f"{source} states {words} {place}, which cannot be used: give {name}=, in metres"
                + (" on the camera" if name == "pixel" else "")
            )
        if of_file is None and of_microscope is None:
            raise ValueError(
                f"{source} states no voxel size: give pixel= (on the camera) and step= (of the stage), in metres"
            )
        if of_file is None:
            place = "on the camera" if name == "pixel" else "of the stage"
            notes.append(
                f"The stack does not state its {name}: the value of the objective file was used, "
                f"{format_length(float(of_microscope or 0.0))} {place}; set {name}= if it differs."
            )
            return float(of_microscope or 0.0)
        if of_microscope is not None and abs(of_microscope - of_file) > _TOLERANCE * of_file:
            text = f"The {name} of the stack, {format_length(of_file)}, was used; the objective file states "
            notes.append(f"{text}{format_length(of_microscope)}.")
            if name == "pixel":
                self.pixel_doubt = notes[-1]
        return of_file


def _wavelengths(
    recording: Frames,
    microscope: MicroscopeData | None,
    argument: float | Sequence[float] | None,
    numbers: range,
    notes: list[str],
) -> list[float]:
    """Return the emission wavelength of each channel, from the argument, else the file, else the microscope."""
    if argument is not None:
        stated = np.atleast_1d(validation.real_array("wavelength", argument))
        if stated.ndim > 1:
            raise ValueError(f"wavelength must be a number or a list of numbers, got the shape {stated.shape}")
        stated = stated.tolist()
        if len(stated) not in (1, len(numbers)):
            raise ValueError(f"wavelength must be one, or one for each of {len(numbers)} channels, got {len(stated)}")
        return [
            validation.wavelength(float(wave)) for wave in (stated * len(numbers) if len(stated) == 1 else stated)
        ]
    waves, names = [], recording.metadata["names"]
    for number in numbers:
        wave = recording.metadata["emission"][number]
        if wave is None:
            if text := recording.metadata["unusable"].get(f"emission {number}"):
                raise ValueError(
                    f"the stack states that the emission wavelength of {names[number]!r} is {text}, which "
                    "cannot be used: give wavelength=, in metres, such as 520e-9"
                )
            if microscope is None or len(numbers) > 1:
                raise ValueError(
                    f"the stack does not state the emission wavelength of {names[number]!r}: give "
                    "wavelength=, in metres, such as 520e-9"
                )
            wave = microscope.wavelength
            notes.append(f"The wavelength of the objective file, {format_length(wave)}, was used.")
        elif len(numbers) == 1 and microscope is not None and abs(wave - microscope.wavelength) > _TOLERANCE * wave:
            notes.append(
                f"The emission wavelength of the stack, {format_length(wave)}, was used; the objective file "
                f"states {format_length(microscope.wavelength)}; set wavelength= if it differs."
            )
        waves.append(validation.wavelength(float(wave)))
    return waves


def _model(
    recording: Frames,
    lens: Objective,
    microscope: MicroscopeData | None,
    sizes: _Sizes,
    wave: float,
    number: int,
    depth: float | None,
    modality: str,
    excitation: float | None,
    pinhole: float,
    thickness: float | None,
    psf_shape: tuple[int, int] | None,
) -> DepthModel:
    """Return the PSF model of a channel; ValueError if an argument is out of range."""
    planes, height, width = recording.shape[1:]
    if planes < 3:
        raise ValueError(
            f"stack must have 3 planes or more, got {planes}; for single images use lommel.imaging.restore_with"
        )
    laser = excitation if excitation is not None else recording.metadata["excitation"][number]
    if modality in ("confocal", "spinning disc", "two-photon") and laser is None:
        raise ValueError(f"excitation must be given for modality={modality!r}: its vacuum wavelength in metres")
    if modality == "light sheet" and thickness is None:
        raise ValueError('thickness must be given for modality="light sheet": its full width at half maximum, metres')
    if thickness is not None:
        validation.real("thickness", thickness, above=0.0)
    if psf_shape is None:
        size = depth_model.usual_window(lens, wave, sizes.pixel, sizes.step, (planes, height, width))
    else:
        if not isinstance(psf_shape, tuple | list) or len(psf_shape) != 2 or any(int(n) % 2 == 0 for n in psf_shape):
            raise ValueError(f"psf_shape must be (planes, pixels), both odd, got {shown(psf_shape)}")
        size = validation.integer("psf_shape", psf_shape[0], least=3, most=513), int(psf_shape[1])
        validation.integer("psf_shape", psf_shape[1], least=3, most=513)
        default_size = depth_model.usual_window(lens, wave, sizes.pixel, sizes.step, (planes, height, width))
        max_size = max(default_size[0], 2 * planes + 1), max(default_size[1], 2 * max(height, width) + 1)
        if size[0] > max_size[0] or size[1] > max_size[1]:
            raise ValueError(f"psf_shape must be at most {max_size}, which is enough for this stack, got {size}")
    middle = depth
    if middle is None:
        middle = planes // 2 * sizes.step if microscope is None else microscope.depth
    return DepthModel(
        lens,
        wave,
        sizes.pixel,
        sizes.step,
        validation.real("depth", middle, least=0.0, most=1e-2),
        planes,
        size,
        modality,
        None if laser is None else validation.wavelength(laser),
        validation.real("pinhole", pinhole, above=0.0),
        thickness,
        emitter_of("isotropic") if microscope is None else microscope.emitter,
        None if microscope is None else microscope.aberrations,
    )


class _ReversedStack:
    """A stack with its planes in reverse order."""

    def __init__(self, stack: Stack) -> None:
        self._stack = stack
        self.shape, self.dtype = stack.shape, stack.dtype

    def __len__(self) -> int:
        return int(self.shape[0])

    def __getitem__(self, index: PlanePart) -> Values:
        plane, *rows_columns = index if isinstance(index, tuple) else (index,)
        values: Values = self._stack[(len(self) - 1 - plane, *rows_columns)]
        return values


Chunk = tuple[int, slice, slice, slice]
"""The place of a chunk: channel, planes, rows, columns."""


class _Target:
    """Destination of restored values: an array, or an OME-Zarr folder that is renamed to `out` when complete."""

    def __init__(self, shape: tuple[int, ...], unfinished: Unfinished | None) -> None:
        self.shape, self.unfinished = shape, unfinished
        self._array: Any = np.zeros(shape, np.float32) if unfinished is None else None
        if unfinished is not None:
            with _zarr_errors(unfinished):
                self._array = _open_group(unfinished.new, "r+")["0"]
                if getattr(self._array, "shape", None) != shape:
                    raise ValueError("its array is missing or has another shape")
        self._complete_chunks: list[tuple[str, Chunk]] = []

    def has(self, request: str, chunk: Chunk) -> bool:
        """Return whether a chunk is unchanged since it was written for `request`, a checksum of its inputs."""
        if self.unfinished is None or not self._is_unchanged(request, chunk):
            return False
        self._complete_chunks.append((request, chunk))
        return True

    def _is_unchanged(self, request: str, chunk: Chunk) -> bool:
        assert self.unfinished is not None
        with _zarr_errors(self.unfinished):
            return self.unfinished.is_complete(_chunk_name(chunk), request, np.asarray(self._array[chunk]))

    def put(self, request: str, chunk: Chunk, values: Values) -> None:
        """Write a chunk, and record its request."""
        if self.unfinished is None:
            self._array[chunk] = values
            return
        self.unfinished.require_there()
        with _zarr_errors(self.unfinished):
            self._array[chunk] = values
        self.unfinished.record(_chunk_name(chunk), request, values)
        self._complete_chunks.append((request, chunk))

    def finish(self, description: str, channels: int) -> Any:
        """Return the values of the restored channels; a folder is renamed to its final name before."""
        if self.unfinished is None:
            values = self._array[:channels]
            return values[0] if self.shape[0] == 1 else values
        # Check again: another process may have replaced chunks since this call checked or wrote them.
        if not all(self._is_unchanged(*entry) for entry in self._complete_chunks):
            raise ValueError(f"chunks in {line(self.unfinished.scratch)} were changed by another process; call again")
        stack_files.require_own(self.unfinished.place)
        with _zarr_errors(self.unfinished):
            _open_group(self.unfinished.new, "r+").attrs["lommel"] = {"description": description}
        self.unfinished.finish()
        return _open_group(self.unfinished.place, "r")["0"]  # shape (channels, planes, height, width), as stored


@contextmanager
def _zarr_errors(unfinished: Unfinished) -> Iterator[None]:
    """Convert errors of zarr to a ValueError that names the hidden folder."""
    try:
        with atomic.as_path_error(unfinished.place):
            yield
    except Exception as error:  # zarr raises many types on damaged files
        if isinstance(error, OSError | MemoryError) or "can't start new thread" in str(error):
            raise
        raise ValueError(f"{line(unfinished.scratch)} is damaged ({reading.reason(error)}); remove it") from None


def _chunk_name(chunk: Chunk) -> str:
    return f"{chunk[0]}.{chunk[2].start}.{chunk[3].start}"


@contextmanager
def _destination(out: str | PathLike[str] | None, shape: tuple[int, ...], recording: Frames) -> Iterator[_Target]:
    """Yield the destination of values: an array, or with `out` a folder that an earlier call may have begun."""
    if out is None:
        yield _Target(shape, None)
        return
    place = validation.path("out", out)
    if stack_files.kind_of(place, recording.path) != "zarr":
        raise ValueError(f"out must end in .zarr, which is written chunk by chunk, got {shown(place.name)}")
    if not place.parent.is_dir():
        raise FileNotFoundError(2, "No such file or directory", str(place.parent))
    metadata = {name: recording.metadata[name] for name in ("pixel", "step", "names", "emission")}
    request = {"software": f"lommel {version()}", "shape": shape} | metadata
    with atomic.unfinished_folder(
        place, request, lambda folder: stack_files.new_zarr(folder, shape, recording, place.stem)
    ) as unfinished:
        yield _Target(shape, unfinished)


def _open_group(folder: Path, mode: Literal["r", "r+"]) -> Any:
    """Open the Zarr group in a folder."""
    import zarr

    return zarr.open(str(folder), mode=mode)


def _checksum(stack: Stack) -> str:
    """Return the checksum of all values of a stack, plane by plane."""
    digest = hashlib.sha256()
    for plane in range(len(stack)):
        digest.update(np.ascontiguousarray(stack[plane]).reshape(-1).data)
    return digest.hexdigest()


@dataclass
class _Source:
    """A stack, its noise, and the smallest value of ignored voxels."""

    stack: Stack  # from `_orient` on, the plane nearest to the cover glass is first
    camera: Noise
    limit: float
    is_reversed: bool = False  # whether the planes are in the reverse order of the recording


@dataclass
class _Outcome:
    """Sums of Poisson deviances over the voxels of all chunks, background, and results of the central chunk."""

    deviance_after: float = 0.0
    deviance_before: float = 0.0
    voxels: float = 0.0  # number of voxels that are not ignored
    is_structured: bool = False  # whether a uniform scene does not explain the chunk
    steps: int = 0
    stopped: str = STEPS
    strength: float | None = None
    background: float | Array = 0.0
    finding: Finding | None = None


class _ChannelRestoration:
    """The restoration of one channel; each assumption is added to the notes."""

    def __init__(
        self,
        stack: Stack,
        model: DepthModel,
        options: _Options,
        notes: list[str],
        target: _Target,
        place: int,
        pixel_doubt: str,
    ) -> None:
        self._pixel_doubt = pixel_doubt
        self._stack, self._model, self._options, self._notes = stack, model, options, notes
        self._threads, self._target, self._place = options.threads or 0, target, place
        planes, height, width = stack.shape
        self._projections, self._floor = ProjectionBuilder((planes, height, width)), Floor()
        self._findings: list[Finding] = []
        self._best_steps = 0  # number of steps after which the result agrees best with held-out photons

    def run(self, mask: NDArray[np.bool_] | None, report: Report) -> RestoredChannel:
        """Restore the channel, ignoring masked voxels."""
        options, notes = self._options, self._notes
        report(0.0, "noise")
        source = self._prepare(mask)
        crop = select_crop(source.stack, self._model.window[1], source.limit)
        context = StackContext(source.stack, self._model, source.camera, source.limit, self._threads)
        background = background_of(options.background)
        estimates_background = background == Background(None)
        parts = _progress_parts(context, crop, options.direction == "auto", len(options.refine), options.diagnosis)
        context = self._orient(source, context, crop, _within(report, 0.0, parts[0]))
        context, estimated, errors = self._refine(context, crop, _within(report, *parts[:2]))
        level = self._compare_held_out(context, estimates_background, _within(report, *parts[1:]))
        background = background if level is None else Background(level)
        margin = self._margin()
        report(parts[-1], "PSFs")
        psfs = self._model.psfs(margin[0], options.slabs)
        depths = psfs.planes[margin[0] : margin[0] + len(self._stack)]
        self._note_psfs(psfs, depths)
        specimens = 5.0 if isinstance(options.method, TotalVariation) else 4.0  # number of arrays of specimen size
        side = self._chunk_side(options.tile, margin, psfs, specimens)
        if options.margin is None and len(self._stack) < self._model.window[0] // 2:
            notes.append("The stack is thinner than its PSF: light from planes beyond it is not restored.")
        request = "" if self._target.unfinished is None else self._request(source, psfs, margin, side, background)
        last_fraction = parts[-1]

        def report_chunks(fraction: float, message: str) -> None:
            nonlocal last_fraction
            last_fraction = parts[-1] + (1.0 - parts[-1]) * fraction
            report(last_fraction, message)

        outcome = self._restore_chunks(source, psfs, margin, side, background, request, report_chunks)
        if estimates_background or background.level is None:
            low, high = float(np.min(outcome.background)), float(np.max(outcome.background))
            text = f"A flat background of {low:.4g}" if low == high else f"A background of {low:.4g} to {high:.4g}"
            notes.append(
                f"{text} counts per voxel was estimated, which the restored values exclude; set background= "
                "for another level, 0 for none."
            )
        self._conclude(outcome, source, context, _within(report, min(last_fraction, 0.5), 1.0))
        is_reversed = source.is_reversed
        return RestoredChannel(
            outcome.deviance_after / outcome.voxels, outcome.deviance_before / outcome.voxels, outcome.steps,
            outcome.stopped, source.camera, "down" if is_reversed else "up", depths[::-1] if is_reversed else depths,
            psfs.depths, estimated, errors, self._projections.result(reverse=is_reversed), outcome.background,
            outcome.strength,
            Findings(self._findings),
        )  # fmt: skip

    def _prepare(self, mask: NDArray[np.bool_] | None) -> _Source:
        """Return the stack without saturated, masked or hot voxels, and its noise."""
        noise = self._options.noise
        limit = self._saturation_limit(self._options.saturation)
        if mask is not None:
            masked = MaskedStack(self._stack, limit, mask=mask)
            self._stack, limit = masked, masked.limit
            count = int(mask.sum())
            self._notes.append(f"{count} voxels ({100.0 * count / mask.size:.2g} %) are masked, and were left out.")
        if noise is None:
            camera, error = measured_noise(self._stack)
            self._notes.append(
                f"The noise was estimated from the stack: {_format_gain(camera, error)} and an offset of "
                f"{float(camera.offset):.4g} counts; a read noise of {float(camera.read):g} electrons was assumed."
            )
        else:
            camera = noise.require_shape(self._stack.shape)
            self._check_noise(camera)
        return _Source(*self._exclude_hot(camera, limit))

    def _orient(
        self, source: _Source, context: StackContext, crop: tuple[slice, slice], report: Report
    ) -> StackContext:
        """Reverse the planes where the first one is the farthest from the cover glass."""
        direction = self._options.direction
        if direction == "auto":
            direction, note = estimate_z_direction(context, crop, report)
            self._notes.append(note)
        source.is_reversed = direction == "down"
        if source.is_reversed:
            # Results are reversed again at the end.
            source.stack = _ReversedStack(source.stack)
            self._model = replace(self._model, is_reversed=True)
        return context._replace(stack=source.stack, model=self._model)

    def _refine(
        self, context: StackContext, crop: tuple[slice, slice], report: Report
    ) -> tuple[StackContext, dict[str, float], dict[str, float]]:
        """Estimate the parameters in `refine`; return the context with the new model, values and standard errors."""
        if not self._options.refine:
            return context, {}, {}
        self._model, estimated, errors = refined(context, crop, self._options.refine, report)
        for name, value in estimated.items():
            self._notes.append(
                f"Estimated from the stack: {PARAMETERS[name]} {_format_estimate(name, value, errors[name])}."
            )
        return context._replace(model=self._model), estimated, errors

    def _margin(self) -> tuple[int, int]:
        """Return the margin restored beyond the stack on each side, in planes and in pixels."""
        if self._options.margin is not None:
            return margins_of(self._options.margin)
        window_planes, side = self._model.window
        return min(window_planes // 2, max(_MIN_MARGIN, len(self._stack) // 4)), side // 2

    def _note_psfs(self, psfs: PSFs, depths: Array) -> None:
        """Note the depths of the PSFs, and the unit of a restored value."""
        notes, model, psf_depths = self._notes, self._model, psfs.depths
        planes_above = int((depths <= 0.0).sum())
        if planes_above > 1:
            notes.append(
                f"{planes_above} of {len(depths)} planes are focused above the sample, in the cover glass or at its "
                f"surface, if the middle plane is focused at a depth of {format_length(model.depth, digits=3)}; set "
                "depth= if not."
            )
        if len(psf_depths) > 1:
            placement = "interpolated in depth"
            if psfs.radial is not None:
                margins = len(psf_depths) - len(depths)
                placement = f"one for each of {len(depths)} planes, and of {margins} restored above and below them"
            depth_range = format_depth_range(psf_depths[0], psf_depths[-1])
            notes.append(
                f"The PSF changes with depth: {len(psf_depths)} were used, {placement}, at depths from {depth_range}."
            )
        if model.spreads and self._options.per_plane:
            notes.append(
                "Restored values are light per plane: a point with F counts in each plane has the value F, or with F "
                "counts in the mean of the planes if it fades."
            )
        elif model.spreads:
            notes.append(
                f"Restored values are the light of a voxel in all {model.window[0]} planes of its PSF together: a "
                "point that sends F counts into each plane (if it fades, into their mean) has the value "
                f"{model.window[0]} F; per_plane=True returns F."
            )

    def _request(
        self, source: _Source, psfs: PSFs, margin: tuple[int, int], side: int, background: Background
    ) -> str:
        """Return the checksum of all inputs of the restored values."""
        model, options, stack = self._model, self._options, source.stack
        # The first and last PSF represent the optical model: a change of the optics changes them.
        ends = [hashlib.sha256(model.psf(psfs.depths[k]).values.tobytes()).hexdigest() for k in (0, -1)]
        camera = {
            name: value if np.ndim(value) == 0 else _checksum(value[np.newaxis])
            for name, value in vars(source.camera).items()
        }
        content = (
            _checksum(stack), stack.shape, str(stack.dtype), ends, model.pixel, model.step, model.depth,
            psfs.depths.tolist(), margin, side, source.is_reversed, camera, options.method,
            source.limit, background, options.per_plane, options.background == FLAT, options.diagnosis,
        )  # fmt: skip
        return hashlib.sha256(repr(content).encode()).hexdigest()

    def _conclude(self, outcome: _Outcome, source: _Source, context: StackContext, report: Report) -> None:
        """Add the findings of the restoration. A misfit lists the alternative PSFs that fit the stack better."""
        options, finding = self._options, outcome.finding
        if finding is not None:
            if finding.code == "misfit" and options.diagnosis and "hot_pixels" not in self._doubt_codes():
                finding = _explain_misfit(
                    finding, rank_alternatives(context, report, try_reversed=options.direction != "auto")
                )
            self._findings.append(finding)
        background = background_of(options.background)
        if outcome.is_structured and (uneven := self._floor.finding(self._stack.shape, background)):
            self._findings.append(uneven)
        if outcome.is_structured and self._model.modality == "widefield":
            self._findings += plane_light_findings(
                source.stack,
                source.camera,
                float(np.mean(outcome.background)),
                source.limit,
                reverse=source.is_reversed,
            )
        if outcome.stopped == INTERRUPTED:
            self._findings.append(Finding("interrupted", "doubt", "it was interrupted: the completed steps are kept"))

    def _compare_held_out(self, context: StackContext, estimates_background: bool, report: Report) -> float | None:
        """Compare PSFs by held-out photons; return the background level if it is estimated from them, else None."""
        if not self._options.diagnosis:
            return None
        comparison = HeldOut(context, report)
        if comparison.is_uniform:
            text = "a flat scene explains the brightest part of the stack: other PSFs were not compared"
            self._findings.append(Finding("untested", "note", text))
            return None
        reference = comparison.best("the PSF as given", context.model)
        self._best_steps = reference.steps
        if finding := comparison.finding(reference):
            if finding.code == "psf_doubtful" and self._pixel_doubt:
                finding = replace(finding, text=f"{finding.text} ({self._pixel_doubt.removesuffix('.')})")
            self._findings.append(finding)
        # Estimate the background from the whole stack: a part also contains light blurred into it from outside.
        if not estimates_background or math.prod(context.stack.shape) > MAX_VOXELS:
            return None
        side = max(context.stack.shape[1:])
        if side > SIDE:
            comparison = HeldOut(context, report, side=side)
            reference = comparison.best("background", context.model)
            self._best_steps = reference.steps
        return comparison.level(reference)

    def _doubt_codes(self) -> tuple[str, ...]:
        """Return the codes of the findings of severity "doubt"."""
        return tuple(finding.code for finding in self._findings if finding.severity == "doubt")

    def _exclude_hot(self, camera: Noise, limit: float) -> tuple[Stack, Noise, float]:
        """Return the stack without hot pixels and voxels, its noise, and the smallest value of ignored voxels."""
        sharpest, stack = sharpness(self._model.psf(0.0).values), self._stack
        pixels = hot_pixels(stack, camera, sharpest, limit)
        if found := hot_pixel_findings(pixels):
            self._findings += found
            stack = MaskedStack(stack, limit, mask=pixels)
            limit = stack.limit
        hot = hot_voxels(stack, camera, sharpest, limit)
        fraction = len(hot) / math.prod(stack.shape)
        subject = f"{len(hot)} voxels ({100.0 * fraction:.2g} %) exceed their neighbours by more than the PSF allows"
        numbers = {"voxels": len(hot), "share": fraction}
        if fraction > MAX_HOT_FRACTION:
            text = f"{subject}, in single planes: they were not left out; check pixel, wavelength and NA"
            self._findings.append(Finding("hot_pixels", "doubt", text, numbers))
        if not 0.0 < fraction <= MAX_HOT_FRACTION:
            return stack, camera, limit
        text = f"{subject}, in single planes: they were classified as cosmic rays or blinking pixels, and left out"
        self._findings.append(Finding("hot_pixels", "note", text, numbers))
        cleaned = MaskedStack(stack, limit, voxels=hot)
        return cleaned, camera, cleaned.limit

    def _check_noise(self, camera: Noise) -> None:
        """Add a note if the stack contradicts `camera`, the noise that the user stated."""
        planes, darkest_value = len(self._stack), math.inf
        # Three standard deviations of the read noise and of rounding to integers (about 0.3 counts).
        floor = camera.offset - 3.0 * np.hypot(camera.read / (1.0 if camera.white is None else camera.white), 0.3)
        dark_count = 0
        for plane in range(planes):
            values = plane_of(self._stack, plane)
            dark_count += int((values < floor).sum())
            darkest_value = min(darkest_value, float(np.nanpercentile(values, 1.0)))
        share = dark_count / math.prod(self._stack.shape)
        if share > _DARK_FRACTION:
            self._notes.append(
                f"{100.0 * share:.2g} % of the voxels are below the offset by more than the read noise explains, and "
                f"count as dark. Check the `offset` of the noise: the darkest voxels have {darkest_value:.4g} counts."
            )
        elif note := contradiction(self._stack, camera):
            self._notes.append(note)

    def _saturation_limit(self, saturation: float | None) -> float:
        """Return the smallest value of saturated voxels, infinity if there are none."""
        planes = self._stack
        if planes.dtype.kind not in "iu" and (
            nonfinite := sum(int((~np.isfinite(planes[plane])).sum()) for plane in range(len(planes)))
        ):
            self._notes.append(f"{nonfinite} voxels are NaN or infinite, and were left out.")
        limit, assumed = full_value(cast("Sequence[Values]", planes), saturation, name="voxels")
        count = sum(int((np.asarray(planes[plane]) >= limit).sum()) for plane in range(len(planes)))
        if assumed:
            self._notes.append(f"{assumed[0].upper()}{assumed[1:]}. Record with less light or a shorter exposure.")
        elif count:
            bound = "the saturation that was stated" if saturation is not None else "the maximum of their type"
            share = 100.0 * count / math.prod(planes.shape)
            self._notes.append(f"{count} voxels ({share:.2g} %) have {bound}, {limit:g}, or more, and were left out.")
        return limit

    def _chunk_side(self, tile: int | None, margin: tuple[int, int], psfs: PSFs, specimens: float) -> int:
        """Return the side of the chunks, pixels: `tile`, or the largest whose memory is within the limit."""
        _, height, width = self._stack.shape
        if tile is not None:
            return int(validation.integer("tile", tile, least=16, most=validation.MAX_SIDE))
        side, overlap = int(max(height, width)), self._model.window[1]
        # Chunks are of equal size: their number along each side is increased until one fits into memory.
        while side > 64 and self._chunk_memory(side, overlap, margin, psfs, specimens) > self._options.memory:
            pieces = math.ceil(max(height, width) / side) + 1
            side = math.ceil(max(height, width) / pieces)
        return side

    def _chunk_memory(self, side: int, overlap: int, margin: tuple[int, int], psfs: PSFs, specimens: float) -> float:
        """Return the approximate memory of a chunk, bytes, with `specimens` arrays as large as the specimen."""
        planes, height, width = self._stack.shape
        recorded_pixels = math.prod(min(side + 2 * overlap, length) for length in (height, width))
        restored_pixels = math.prod(min(side + 2 * overlap, length) + 2 * margin[1] for length in (height, width))
        restored_planes = planes + 2 * margin[0]
        transfers = 2.0 * len(psfs.depths) * (planes + self._model.window[0]) * restored_pixels / 4.0
        if psfs.radial is not None:
            transfers = float(len(psfs.radial.frequencies) * planes * restored_planes)
        # 4 bytes per value, and 10 % more for the coarse grid.
        return 4.4 * float(specimens * restored_planes * restored_pixels + 3.0 * planes * recorded_pixels + transfers)

    def _restore_chunks(
        self,
        source: _Source,
        psfs: PSFs,
        margin: tuple[int, int],
        side: int,
        background: Background,
        request: str,
        report: Report,
    ) -> _Outcome:
        """Restore all chunks: the central chunk, then the others, which repeat its step settings (`course`)."""
        planes, height, width = source.stack.shape
        method, blurs = self._options.method, dict[tuple[int, int, int], PlaneOperator]()
        sides = [math.ceil(pixels / math.ceil(pixels / side)) for pixels in (height, width)]
        tiles = sorted(
            tiles_of((height, width), sides, self._model.window[1]),
            key=lambda tile: _distance_from_middle(tile[0], height, width),
        )
        # With several chunks, all start from the mean light of the whole stack.
        mean_light = None if len(tiles) == 1 else _mean_light(source)
        course: list[StepSettings] | None = None
        factor = np.float32(1.0 / self._model.window[0] if self._options.per_plane else 1.0)
        outcome = _Outcome(background=np.zeros((height, width)) if background.points > 1 else 0.0)
        for number, (place, padded, inner) in enumerate(tiles):
            chunk = np.s_[self._place, :, *place]
            if number and self._target.has(request, chunk):
                continue
            counted = PoissonLikelihood(_load(source.stack, *padded), source.camera.part(*padded), source.limit)
            counted.level = counted.level if mean_light is None else mean_light
            size = (planes, *(part.stop - part.start for part in padded))
            if size not in blurs:
                blurs.clear()  # keep a single operator in memory
                blurs[size] = self._model.blur(size, margin, psfs, threads=self._threads)
            blur = blurs[size]
            if blur.outside is not None:
                blur.outside[...] = counted.level
            if number == 0:
                outcome.is_structured = counted.flat() > 1.0 + counted.slack
            before = counted.mean(counted.discrepancies(blur, counted.scene(*margin)))
            iteration = self._iteration(blur, counted, course, background)
            progress = _ChunkProgress(
                report, number, len(tiles), method.steps if course is None else len(course), method.target > 0.0
            )
            count, stopped, discrepancies = self._solve(iteration, progress, single=mean_light is None)
            after = counted.mean(discrepancies)
            if course is None:
                course, outcome.steps, outcome.strength = iteration.course, count, iteration.strength
                outcome.finding = self._central_finding(counted, stopped, count, after)
                is_misfit = outcome.finding is not None and outcome.finding.code == "misfit"
                outcome.stopped = MISFIT if is_misfit else stopped
            if isinstance(outcome.background, np.ndarray):
                outcome.background[place] = np.asarray(counted.background)[inner]
            elif number == 0:
                outcome.background = counted.background
            voxels = float(counted.known.sum())
            outcome.deviance_after += after * voxels
            outcome.deviance_before += before * voxels
            outcome.voxels += voxels
            restored = np.ascontiguousarray(iteration.inside(*margin)[:, *inner])
            restored *= factor
            corner = padded[0].start, padded[1].start
            self._floor.add(restored, *place)
            self._projections.add(*place, corner, blur, counted, iteration.guess, restored)
            # The target has the planes in the order of the recording.
            self._target.put(request, chunk, restored[::-1] if source.is_reversed else restored)
        return outcome

    def _iteration(
        self,
        blur: PlaneOperator,
        counted: PoissonLikelihood,
        course: list[StepSettings] | None,
        background: Background,
    ) -> Iteration:
        """Return the iteration of a chunk, which may end after the best number of steps for held-out photons."""
        model, method = self._model, self._options.method
        aspect = model.pixel / model.objective.magnification / model.step
        iteration = iteration_of(
            method, blur, counted, course, background=background, aspect=aspect, threads=self._threads
        )
        iteration.enough = stopping_rule(method, self._best_steps, counted)
        return iteration

    def _solve(self, iteration: Iteration, report: ProgressCallback, *, single: bool) -> tuple[int, str, Array]:
        """Iterate; return (1) number of steps, (2) why they ended, (3) discrepancies. Ctrl-C keeps a single chunk."""
        try:
            return iteration.solve(self._options.method, report)
        except KeyboardInterrupt:
            if not single or self._target.unfinished is not None or not iteration.course:
                raise
            return len(iteration.course) - 1, INTERRUPTED, iteration.discrepancies

    def _central_finding(
        self, counted: PoissonLikelihood, reason: str, steps: int, discrepancy: float
    ) -> Finding | None:
        """Return the finding on the convergence of the central chunk, None if there is none."""
        finding = counted.finding(reason, steps, discrepancy)
        is_settled = reason != STEPS or self._options.method.target <= 0.0 or discrepancy <= 1.0 + counted.slack
        if finding is not None or is_settled:
            return finding
        # More steps would fit a wrong PSF by artefacts.
        advice = "correct the PSF first" if "psf_doubtful" in self._doubt_codes() else "allow more steps"
        text = f"the residual exceeds the noise after the {steps} steps of the method; {advice}"
        return Finding("not_settled", "doubt", text, {"discrepancy": discrepancy, "steps": steps})


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


def _within(report: Report, begin: float, end: float) -> Report:
    """Return a callback that maps the progress of one part, 0 to 1, to `begin` to `end` of the whole work."""
    return lambda fraction, message: report(begin + (end - begin) * fraction, message)


def _explain_misfit(misfit: Finding, alternatives: list[str]) -> Finding:
    """Return the misfit with the PSFs that fit the stack better; if there are none, with the severity "doubt"."""
    if not alternatives:
        text = (
            "the residual exceeds the noise, but no other PSF fits better: the cause may be points between voxels or "
            "a wrong gain; check `white` and `read` of the noise"
        )
        return replace(misfit, severity="doubt", text=text)
    text = f"PSFs with {alternatives[0]} fit the stack better"
    if len(alternatives) > 1:
        likeliest = ", ".join(alternatives)
        text = f"other PSFs fit the stack better; one of these values may be wrong, the likeliest first: {likeliest}"
    return replace(misfit, text=text, numbers={**misfit.numbers, "others": alternatives})


def _progress_parts(
    context: StackContext, crop: tuple[slice, slice], direction: bool, refine: int, held_out: bool
) -> tuple[float, float, float]:
    """Return the progress, 0 to 1, after each of the estimates: direction of z, `refine`, held-out photons."""
    height, width = context.stack.shape[1:]
    part = math.prod(pixels.stop - pixels.start for pixels in crop) / (height * width)
    oriented, refined = (part * steps for steps in estimated_steps(direction, refine))
    compared = estimated_held_out_steps(context.stack.shape) if held_out else 0.0
    total = oriented + refined + compared + _USUAL_STEPS
    return oriented / total, (oriented + refined) / total, (oriented + refined + compared) / total


def _format_estimate(name: str, value: float, error: float) -> str:
    """Return a value and its standard error as text."""
    if not math.isfinite(error):
        return "is not determined"
    factor, unit = {"depth": (1e6, " um"), "spherical": (1.0, " waves rms")}.get(name, (1.0, ""))
    return " +- ".join(with_error(factor * value, factor * error)) + unit


def _format_gain(camera: Noise, error: float) -> str:
    """Return a measured gain in words."""
    gain = 1.0 if camera.white is None else float(camera.white)
    return " +- ".join(with_error(gain, gain * error)) + " electrons per count"


def format_depth_range(low: float, high: float) -> str:
    """Return a range of depths in one unit, in words."""
    return f"{format_length(low, like=high, digits=3).split()[0]} to {format_length(high, digits=3)}"


def _mean_light(source: _Source) -> float:
    """Return the mean light of a stack, weighted by the gain, without ignored voxels."""
    stack, camera, limit = source.stack, source.camera, source.limit
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


class Projections(NamedTuple):
    """Projections along z, shape (height, width), and along y, shape (planes, width), of float32.

    Attributes
    ----------
    recorded, restored : (ndarray, ndarray)
        Maxima, in the unit of the recording, without the camera offset.
    residual : (ndarray, ndarray)
        Recording minus model in units of the noise, summed along each projected line and divided by the square root
        of its number of voxels; the variance is 1 if PSF and noise model are right.
    """

    recorded: tuple[Values, Values]
    restored: tuple[Values, Values]
    residual: tuple[Values, Values]


def blank(shape: tuple[int, int, int]) -> Projections:
    """Return projections filled with NaN."""
    planes, height, width = shape
    recorded, restored, residual = (
        (np.full((height, width), np.nan, np.float32), np.full((planes, width), np.nan, np.float32)) for _ in range(3)
    )
    return Projections(recorded, restored, residual)


class ProjectionBuilder:
    """Builder of the projections of a stack, chunk by chunk."""

    def __init__(self, shape: tuple[int, int, int]) -> None:
        self._projections = blank(shape)
        self._voxels = np.zeros((shape[0], shape[2]), np.float32)  # numbers of voxels summed along y

    def add(
        self,
        rows: slice,
        columns: slice,
        corner: tuple[int, int],
        blur: PlaneOperator,
        counted: PoissonLikelihood,
        light: Values,
        restored: Values,
    ) -> None:
        """Add a chunk, `restored` at `rows` and `columns`; `corner`: first row and column of its blurred part."""
        y_offset, x_offset = (pixels.start - start for pixels, start in zip((rows, columns), corner, strict=True))
        height, width = rows.stop - rows.start, columns.stop - columns.start
        sums, voxels, maxima = (np.zeros((height, width), np.float32) for _ in range(3))
        along_y = np.zeros((3, len(restored), width), np.float32)  # sums, numbers of voxels, maxima
        lock = Lock()

        def compare(plane: int, y: slice, x: slice, model: Values) -> None:
            counts, residuals, weights = counted.residuals(plane, y, x, model)
            top, left = y.start - y_offset, x.start - x_offset
            inner = np.s_[max(-top, 0) : max(height - top, 0), max(-left, 0) : max(width - left, 0)]
            counts, residuals, weights = counts[inner], residuals[inner], weights[inner]
            rows_at = slice(max(top, 0), max(top, 0) + len(residuals))
            target = rows_at, slice(max(left, 0), max(left, 0) + residuals.shape[1])
            with lock:
                sums[target] += residuals
                voxels[target] += weights
                np.maximum(maxima[target], counts, out=maxima[target])
                part = along_y[:, plane, target[1]]
                part[0] += residuals.sum(axis=0)
                part[1] += weights.sum(axis=0)
                np.maximum(part[2], counts.max(axis=0, initial=0.0), out=part[2])

        blur.forward(light, compare)
        recorded, after, residual = self._projections
        recorded[0][rows, columns] = np.where(voxels > 0.0, maxima, np.float32(np.nan))
        after[0][rows, columns] = restored.max(axis=0)
        residual[0][rows, columns] = _divide_by_root(sums, voxels)
        # Chunks above and below contribute to the same voxels of the projection along y.
        before = self._voxels[:, columns]
        total = along_y[0] + np.nan_to_num(residual[1][:, columns]) * np.sqrt(before)
        self._voxels[:, columns] = before + along_y[1]
        residual[1][:, columns] = _divide_by_root(total, self._voxels[:, columns])
        highest = np.where(along_y[1] > 0.0, along_y[2], np.float32(np.nan))
        for projection, maximum in ((recorded, highest), (after, restored.max(axis=1))):
            projection[1][:, columns] = np.fmax(projection[1][:, columns], maximum)

    def result(self, *, reverse: bool) -> Projections:
        """Return the projections, with the planes in reverse order if `reverse`."""
        if not reverse:
            return self._projections
        return Projections(*((along_z, along_y[::-1]) for along_z, along_y in self._projections))


def _divide_by_root(sums: Values, voxels: Values) -> Values:
    """Return sums divided by the square root of the number of voxels, NaN where that number is 0."""
    return np.where(voxels > 0.0, sums / np.sqrt(np.maximum(voxels, 1.0)), np.float32(np.nan))
