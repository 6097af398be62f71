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
from lommel.deconvolve.linear import Part, PlaneOperator, tiles_of
from lommel.deconvolve.poisson_counts import PoissonCounts
from lommel.fit.findings import Finding, Findings, FitReport
from lommel.microscopy import depth_model
from lommel.microscopy.deconvolution import FLAT, background_of
from lommel.microscopy.depth_model import MODALITIES, SPREADING, DepthModel, PSFs
from lommel.microscopy.held_out import SIDE, WHOLE, HeldOut, enough, estimated_held_out_steps
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
from lommel.recorded import recordings
from lommel.recorded.camera_noise import (
    MOST,
    LeftOut,
    contradiction,
    hot_pixels,
    hot_voxels,
    measured_noise,
    sharpness,
)
from lommel.recorded.counts import PlanePart, Stack, full_value, plane_of
from lommel.recorded.noise import Noise
from lommel.recorded.recordings import Recording
from lommel.show import estimates as pictures

if TYPE_CHECKING:
    from matplotlib.figure import Figure


INTERRUPTED = "interrupted"
"""Value of `stopped` after Ctrl-C: the result of the last complete step is kept."""

MISFIT = "misfit"
"""Value of `stopped` where the residual exceeds the noise and no longer decreases."""

_DIRECTIONS = ("auto", "up", "down")
_MEMORY = 2.0**31  # default memory limit, bytes
_TOLERANCE = 0.02  # relative difference between a value of the file and that of the objective that is not reported
_DARK_FRACTION = 0.02  # fraction of voxels darker than the offset above which the offset is doubted
_USUAL_STEPS = 60  # typical number of steps of a restoration, for the progress display
_MISFIT_PROGRESS = 0.3  # progress shown after `EARLIEST` steps, when the restoration may end as a misfit
_MIN_MARGIN = 8  # smallest default margin, planes

Report = Callable[[float, str], object]


@dataclass(frozen=True, eq=False, repr=False)
class RestoredChannel:
    """How one channel of a stack was restored.

    Attributes
    ----------
    discrepancy, before : float
        Poisson deviance per voxel after the restoration, and before it, with the recording itself as the estimate;
        about 1 where PSF and noise model fit.
    steps : int
        Number of steps, that of the central chunk.
    stopped : str
        "noise", "steps" or "misfit" as of :class:`lommel.imaging.Restoration`; "interrupted" after Ctrl-C.
    noise : Noise
    direction : str
        "up" if the planes run from the cover glass into the sample, else "down".
    depths : ndarray of float, shape (planes,)
        Depth below the cover glass that is in focus in each plane, in the order of the recording, metres.
    psf_depths : ndarray of float
        Depths of the PSFs that were used.
    refined, errors : dict of float
        Parameters of `refine` estimated from the stack, by name, and their standard errors, which combine photon
        noise and the change since half of the steps; inf where the stack does not determine a parameter.
    projections : Projections
        Projections that :meth:`RestoredStack.plot` draws: maxima of recording and result, and the residual, each
        along z and along y. NaN in chunks that were restored by an earlier call.
    background : float or ndarray of shape (height, width)
        Background per voxel, in the unit of the recording without the offset; the restored values exclude it.
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
        Restored light in the unit of the recording, without the offset of the camera, planes in the order of the
        recording; shape (planes, height, width), or (channels, planes, height, width) for several channels and with
        `out`.
    channels : tuple of RestoredChannel
    recording : Recording
        The recording, with the voxel sizes and wavelengths that were used.
    notes : tuple of str
        Sentences on the values that were taken from the file, estimated or assumed.
    findings : Findings
        Results of the checks of all channels. Errors: "misfit" and "too_quiet". Doubts: "psf_doubtful", where
        held-out photons agree better with another PSF; "misfit" where no other PSF fits better; "hot_pixels",
        "not_settled" and "interrupted". The rest are notes. They set ``converged``, ``reliable`` and ``status``.
    summary : str
        Discrepancy and number of steps of each channel.
    """

    values: Any = field(repr=False)
    channels: tuple[RestoredChannel, ...]
    recording: Recording = field(repr=False)
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
        """Return the result as plain data, as JSON has it, without values.

        Returns
        -------
        dict
            The entries of every fit, the shape and the voxel sizes (metres). Each channel has its name, wavelength,
            least and greatest depth, number of PSFs, and mean background.
        """
        result = super().to_dict()
        channels = zip(result["channels"], self.channels, self.recording.names, self.recording.emission, strict=False)
        for channel, each, name, wave in channels:
            channel |= {"name": name, "wavelength": wave, "psfs": len(each.psf_depths)}
            channel["depths"] = [float(each.depths.min()), float(each.depths.max())]
            channel["background"] = float(np.mean(each.background))
        sizes = {"pixel_in_sample": self.recording.pixel, "step": self.recording.step}
        return {"shape": list(self.values.shape[-3:])} | sizes | result

    def plot(self) -> Figure:
        """Return a matplotlib figure of maximum projections before and after, and of the normalized residual.

        Projections along z (xy) are above those along y (xz), with a scale bar. The residual is in units of the
        noise, summed along each projected line and divided by the square root of its number of voxels: where PSF and
        noise model are right it has no pattern, and hardly exceeds 3.

        Returns
        -------
        matplotlib Figure

        Raises
        ------
        ImportError
            If matplotlib is not installed.
        """
        several = len(self.channels) > 1
        labelled = [
            (f"{name}: " if several else "", each.projections)
            for name, each in zip(self.recording.names, self.channels, strict=False)
        ]
        assert self.recording.pixel is not None
        assert self.recording.step is not None
        caption = "; ".join(
            f"{name}discrepancy {each.before:#.3g} before, {each.discrepancy:#.3g} after {each.steps} steps"
            for (name, _), each in zip(labelled, self.channels, strict=True)
        )
        return pictures.projections(labelled, (self.recording.step, self.recording.pixel), caption)

    def save(self, *paths: str | PathLike[str]) -> None:
        """Write the stack with its voxel sizes, channels and wavelengths.

        Parameters
        ----------
        *paths : path
            Files to write: OME-TIFF if the name ends in .tif or .tiff, OME-Zarr (0.4) if it ends in .zarr. Each is
            written under a temporary name and moved into place.

        Raises
        ------
        ValueError
            If a name has another suffix, or is that of the recording.
        OSError, ImportError
            If a file cannot be written, or tifffile or zarr is not installed.
        """
        places = [validation.path("paths", path) for path in paths]
        for place in places:
            recordings.kind_of(place, self.recording.path)
        values = np.asarray(self.values[...], np.float32)
        values = values[np.newaxis] if values.ndim == 3 else values
        for place in places:
            recordings.save_stack(place, values, self.recording, " ".join(self.notes))


def restore(
    stack: str | PathLike[str] | ArrayLike | Recording,
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
        As of :func:`lommel.microscopy.open_recording`: OME-TIFF, TIFF of ImageJ, OME-Zarr; arrays of NumPy, dask or
        Zarr, of shape (planes, height, width) or (channels, planes, height, width), of any real type.
    objective : Objective or Microscope
        The objective; or the microscope of :func:`lommel.load_microscope`, whose emitter and aberrations are used,
        and whose depth, wavelength, pixel and step are the defaults where the file states none.
    depth : float, optional
        Depth below the cover glass that is in focus in plane ``planes // 2``, metres. By default that of the
        Microscope; without one, half of the stack, as if the stack began at the glass.
    wavelength : float or sequence of float, optional
        Emission wavelength, metres; one for all channels or one for each. By default that of the file.
    pixel, step : float, optional
        Pixel pitch on the camera, and stage displacement between planes, metres. By default those of the file, whose
        pixel size in the sample is multiplied by the magnification.
    channel, time : int, optional
        Channel and time point to restore; by default all channels, and the only time point.
    axes : str, optional
        As of :func:`lommel.microscopy.open_recording`.
    noise : Noise, optional
        Noise of the camera, in the unit of the file; maps per pixel apply to each plane. By default
        :func:`lommel.microscopy.estimate_noise` of each channel.
    saturation : float, optional
        Smallest value of saturated voxels, which are ignored. By default the largest value of 8, 10, 12, 14 or 16
        bits, if several integer voxels have it. NaN, masked voxels and hot pixels are ignored, too.
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
        "up": the first plane is the nearest to the cover glass. "auto" tries both directions and takes the one of
        greater likelihood, or "up" where the data do not decide.
    slabs : int, optional
        Number of PSFs over the depth of the stack, interpolated linearly in depth; 1 for a single PSF. By default
        each plane has its own; with aberrations that are not rotationally symmetric, as many as are needed for
        interpolated PSFs to be within 3 % of the light, up to 9.
    refine : sequence of {"depth", "sample", "spherical"}
        Parameters estimated first, by maximum likelihood: the depth, the refractive index of the sample, or the
        spherical aberration (waves rms).
    method : RichardsonLucy or TotalVariation, optional
        As of :func:`lommel.microscopy.deconvolve`: ``lm.imaging.RichardsonLucy(target=1.0)`` by default.
    background : "flat", "uneven" or float, default "flat"
        As of :func:`lommel.microscopy.deconvolve`. A "flat" background is estimated with the specimen, in the central
        chunk; with `diagnosis` and up to 500000 voxels, it is instead fixed in advance by held-out photons. An
        "uneven" background is estimated in each chunk separately, and is best used without chunks.
    psf_shape : (int, int), optional
        Planes and pixels of the PSFs, odd. By default the size of the light cone over half of the planes, up to 97.
    margin : (int, int), optional
        As of :func:`lommel.microscopy.deconvolve`.
    tile : int, optional
        Side of lateral chunks, pixels. By default one chunk, or as large as `memory` allows. Chunks overlap by the
        PSF, and all repeat the steps of the central chunk, with the same extrapolation; the result differs from that
        of one chunk. In a test the sum of absolute differences was 3 % of the light after 5 steps and 17 % after 25
        steps, or 2 % without extrapolation (``RichardsonLucy(accelerate=False)``).
    memory : float, default 2**31
        Memory limit besides input and output, bytes.
    diagnosis : bool, default True
        Whether some photons are held out, to estimate the background and the number of steps and to compare PSFs for
        other sample indices in a part of the stack; and whether other PSFs are tried after a misfit. Computing time
        increases by a factor of two to four at 20 x 40 x 40 voxels, of two to three at 41 x 96 x 96.
    per_plane : bool, default False
        Whether restored values are the light that the objective collects in one plane, rather than in all planes of
        the window of the PSF; for "widefield" and "light sheet".
    out : path, optional
        Folder NAME.zarr to which values are written chunk by chunk, for stacks larger than memory; it may replace
        only an earlier restored stack. After an interruption the same call continues: only chunks that are damaged,
        or of other data or arguments, are computed again. Until all are complete they lie in a hidden folder beside
        `out`, ``.NAME.zarr.unfinished``, into which one call at a time may write.
    progress : callable, optional
        Called as ``progress(fraction, message)`` with the fraction of the work that is done, 0 to 1.
    threads : int, optional
        Number of threads, by default that of processors. The result does not depend on it.

    Returns
    -------
    RestoredStack

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range; if the voxel sizes or the wavelength are unknown, or the
        stack is thinner than three planes; if another call writes to `out`;
        :class:`lommel.recorded.frames.RecordingError` for files.
    OSError, ImportError
        If a file cannot be read or written, or a library for it is not installed.

    Notes
    -----
    A point is restored in the plane in which it is brightest: its depth is that of its brightest focus, by
    :meth:`lommel.Objective.focus`. Each plane of a wide-field or light-sheet PSF has all light that the objective
    collects: light beyond the window of the PSF is blurred on a coarse grid, and light from outside of the field is
    estimated, one level for each plane. With `slabs` a stack x is blurred as ``sum_s h_s * (w_s x)``, with PSFs h_s
    and weights w_s for each plane. The transpose of the blur is exact. Ctrl-C keeps the completed steps of a stack
    restored in one chunk, as ``stopped="interrupted"``; otherwise it raises KeyboardInterrupt, and with `out` the
    same call continues.
    """
    validation.choice("modality", modality, MODALITIES)
    if validation.truth("per_plane", per_plane) and modality not in SPREADING:
        raise ValueError(f"per_plane must be False for modality={modality!r}, which records what is in focus alone")
    way = RichardsonLucy(target=1.0) if method is None else method
    options = _Options(
        noise, saturation, direction, slabs, refine, way, background, margin, tile, memory, threads, per_plane,
        diagnosis,
    )  # fmt: skip
    validation.function("progress", progress, required=False)
    lens, given = _objective(objective)
    hidden: NDArray[np.bool_] | bool | None = False
    if isinstance(stack, np.ma.MaskedArray):
        stack, hidden = validation.parted("stack", stack)
    with recordings.open_recording(stack, time=time, axes=axes) as opened, ExitStack() as held:
        chosen = range(opened.shape[0])
        if channel is not None:
            number = validation.integer("channel", channel, least=0, most=opened.shape[0] - 1)
            chosen = range(number, number + 1)
        notes = list(opened.notes)
        sizes = _Sizes(opened, lens, given, pixel, step, notes)
        waves = _wavelengths(opened, given, wavelength, chosen, notes)
        models = [
            _model(
                opened, lens, given, sizes, wave, number, depth, modality, excitation, pinhole, thickness, psf_shape
            )
            for number, wave in zip(chosen, waves, strict=True)
        ]
        if depth is None and given is None:
            notes.append(
                f"The depth in focus in the middle plane was taken to be {format_length(models[0].depth, digits=3)}, "
                "as if the stack began at the cover glass; depth= states another."
            )
        described = replace(
            opened,
            pixel=sizes.pixel / lens.magnification,
            step=sizes.step,
            names=tuple(opened.names[k] for k in chosen),
            emission=tuple(waves),
            excitation=tuple(opened.excitation[k] for k in chosen),
            path=opened.path,
        )
        left = _mask_of(mask, hidden, opened.shape)
        target = held.enter_context(_destination(out, (len(chosen), *opened.shape[1:]), described))
        made = _by_channel(opened, chosen, models, options, left, target, notes, progress or silent)
        values = target.finish(" ".join(notes), len(made))
    findings = Findings(
        each if len(chosen) == 1 else replace(each, text=f"{name}: {each.text}")
        for name, channel_made in zip(described.names, made, strict=False)
        for each in channel_made.findings
    )
    summary = ", ".join(f"discrepancy {each.discrepancy:.4g} after {each.steps} steps" for each in made)
    return RestoredStack(values, tuple(made), described, tuple(notes), findings=findings, summary=summary)


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
        if self.margin is not None and (not isinstance(self.margin, tuple | list) or len(self.margin) != 2):
            raise ValueError(f"margin must be (planes, pixels), got {shown(self.margin)}")
        background_of(self.background)


def _by_channel(
    opened: Recording,
    chosen: range,
    models: Sequence[DepthModel],
    options: _Options,
    left: NDArray[np.bool_] | None,
    target: _Target,
    notes: list[str],
    report: Report,
) -> list[RestoredChannel]:
    """Restore channels up to an interruption; only the first one adds to the notes."""
    made: list[RestoredChannel] = []
    for place, (number, model) in enumerate(zip(chosen, models, strict=True)):
        job = _ChannelRestoration(opened.stack(number), model, options, notes if place == 0 else [], target, place)
        share = _within(report, place / len(chosen), (place + 1) / len(chosen))
        name = "" if len(chosen) == 1 else f"{opened.names[number]}: "

        def report_named(part: float, message: str, share: Report = share, name: str = name) -> None:
            share(part, name + message)

        made.append(job.run(None if left is None else left[number], report_named))
        if made[-1].stopped == INTERRUPTED:
            break
    return made


def _mask_of(
    mask: ArrayLike | None, hidden: NDArray[np.bool_] | bool | None, shape: tuple[int, int, int, int]
) -> NDArray[np.bool_] | None:
    """Return the mask of voxels to ignore in each channel, or None."""
    out = np.asarray(False if hidden is None else hidden)
    if mask is not None:
        given = validation.array("mask", mask)
        if given.dtype != bool or given.shape not in (shape[2:], shape[1:], shape):
            raise ValueError(
                f"mask must be True or False for each pixel {shape[2:]} or voxel {shape[1:]}, got {given.dtype} of "
                f"{given.shape}"
            )
        out = out | given
    return np.broadcast_to(out, shape) if np.any(out) else None


def _list_of_names(name: str, given: object) -> list[str]:
    if isinstance(given, str) or not isinstance(given, Sequence):
        raise TypeError(f'{name} must be a sequence of names, such as ("depth",), got {shown(given)}')
    return list(given)


class MicroscopeData(Protocol):
    """Result of :func:`lommel.load_microscope`: an objective and its recording parameters (lengths in metres)."""

    objective: Objective
    wavelength: float
    depth: float
    pixel: float
    step: float
    emitter: Emitter
    aberrations: Wavefront | None


def _objective(given: Any) -> tuple[Objective, MicroscopeData | None]:
    """Return the objective, and the microscope if one was given."""
    if isinstance(given, Objective):
        return given, None
    if isinstance(getattr(given, "objective", None), Objective):
        return given.objective, given
    raise TypeError(
        f"objective must be an Objective, or a Microscope as lommel.load_microscope reads it, got {shown(given)}"
    )


class _Sizes:
    """Pixel pitch on the camera and stage step between planes, metres, by argument, file or microscope."""

    def __init__(
        self,
        opened: Recording,
        lens: Objective,
        given: MicroscopeData | None,
        pixel: float | None,
        step: float | None,
        notes: list[str],
    ) -> None:
        of_file = None if opened.pixel is None else opened.pixel * lens.magnification
        self.pixel = self._length("pixel", pixel, of_file, None if given is None else given.pixel, opened, notes)
        self.step = self._length(
            "step", step, opened.step, (None if given is None else abs(given.step)) or None, opened, notes
        )
        if pixel is not None:
            validation.pixel(self.pixel, metric=True)
        if not 0.0 < self.step < 1e-4:
            raise ValueError(f"step must be of the stage, in metres, above 0 and below 1e-4, got {self.step:g}")
        if opened.NA is not None and abs(opened.NA - lens.NA) > _TOLERANCE * lens.NA:
            notes.append(f"The file says NA {opened.NA:g}, the objective {lens.NA:g}, which was used.")

    def _length(
        self,
        name: str,
        argument: float | None,
        of_file: float | None,
        of_microscope: float | None,
        opened: Recording,
        notes: list[str],
    ) -> float:
        """Return the argument, else the length of the file, else that of the microscope; note a disagreement."""
        if argument is not None:
            value = validation.real(name, argument, above=0.0)
            if of_file is not None and abs(value - of_file) > _TOLERANCE * of_file:
                notes.append(f"The argument {name}={format_length(value)} was used, not the value of the file.")
            return value
        what = "an array" if opened.path is None else line(opened.path)
        if name in opened.unusable:
            where = "in the sample" if name == "pixel" else "between planes"
            raise ValueError(
                f"{what} says {opened.unusable[name]} {where}, which cannot be used: give {name}=, in metres"
                + (" on the camera" if name == "pixel" else "")
            )
        if of_file is None and of_microscope is None:
            raise ValueError(
                f"{what} does not say the voxel size: give pixel= (on the camera) and step= (of the stage), in metres"
            )
        if of_file is None:
            where = "on the camera" if name == "pixel" else "of the stage"
            notes.append(
                f"The stack does not say its {name}: that of the objective file was taken, "
                f"{format_length(float(of_microscope or 0.0))} {where}; {name}= states another."
            )
            return float(of_microscope or 0.0)
        if of_microscope is not None and abs(of_microscope - of_file) > _TOLERANCE * of_file:
            notes.append(
                f"The stack has a {name} of {format_length(of_file)}, the objective file "
                f"{format_length(of_microscope)}: that of the stack was taken."
            )
        return of_file


def _wavelengths(
    opened: Recording,
    given: MicroscopeData | None,
    argument: float | Sequence[float] | None,
    chosen: range,
    notes: list[str],
) -> list[float]:
    """Return the emission wavelength of each channel: the argument, else that of the file, else of the microscope."""
    if argument is not None:
        each = np.atleast_1d(validation.real_array("wavelength", argument)).tolist()
        if len(each) not in (1, len(chosen)):
            raise ValueError(f"wavelength must be one, or one for each of {len(chosen)} channels, got {len(each)}")
        return [validation.wavelength(float(wave)) for wave in (each * len(chosen) if len(each) == 1 else each)]
    waves = []
    for number in chosen:
        wave = opened.emission[number]
        if wave is None:
            if words := opened.unusable.get(f"emission {number}"):
                raise ValueError(
                    f"the stack says that the emission wavelength of {opened.names[number]!r} is {words}, which "
                    "cannot be used: give wavelength=, in metres, such as 520e-9"
                )
            if given is None or len(chosen) > 1:
                raise ValueError(
                    f"the stack does not say the emission wavelength of {opened.names[number]!r}: give wavelength=, "
                    "in metres, such as 520e-9"
                )
            wave = given.wavelength
            notes.append(f"The wavelength of the objective file, {format_length(wave)}, was taken.")
        elif len(chosen) == 1 and given is not None and abs(wave - given.wavelength) > _TOLERANCE * wave:
            notes.append(
                f"The stack has an emission wavelength of {format_length(wave)}, the objective file "
                f"{format_length(given.wavelength)}: that of the stack was taken; wavelength= states another."
            )
        waves.append(validation.wavelength(float(wave)))
    return waves


def _model(
    opened: Recording,
    lens: Objective,
    given: MicroscopeData | None,
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
    planes, height, width = opened.shape[1:]
    if planes < 3:
        raise ValueError(
            f"stack must have 3 planes or more, got {planes}: there is no depth to restore; for single images use "
            "lommel.imaging.restore_with"
        )
    laser = excitation if excitation is not None else opened.excitation[number]
    if modality in ("confocal", "spinning disc", "two-photon") and laser is None:
        raise ValueError(f"excitation must be given for modality={modality!r}: its wavelength in metres")
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
        usual = depth_model.usual_window(lens, wave, sizes.pixel, sizes.step, (planes, height, width))
        enough = max(usual[0], 2 * planes + 1), max(usual[1], 2 * max(height, width) + 1)
        if size[0] > enough[0] or size[1] > enough[1]:
            raise ValueError(f"psf_shape must be at most {enough}, which is enough for this stack, got {size}")
    middle = depth
    if middle is None:
        middle = planes // 2 * sizes.step if given is None else given.depth
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
        emitter_of("isotropic") if given is None else given.emitter,
        None if given is None else given.aberrations,
    )


class _ReversedStack:
    """A stack with its planes in reverse order."""

    def __init__(self, stack: Stack) -> None:
        self._stack = stack
        self.shape, self.dtype = stack.shape, stack.dtype

    def __len__(self) -> int:
        return int(self.shape[0])

    def __getitem__(self, at: PlanePart) -> Values:
        plane, *rest = at if isinstance(at, tuple) else (at,)
        values: Values = self._stack[(len(self) - 1 - plane, *rest)]
        return values


Chunk = tuple[int, slice, slice, slice]
"""The place of a chunk: channel, planes, rows, columns."""


class _Target:
    """Destination of restored values: an array, or an OME-Zarr folder that is renamed to `out` when complete."""

    def __init__(self, shape: tuple[int, ...], begun: Unfinished | None) -> None:
        self.shape, self.begun = shape, begun
        self._array: Any = np.zeros(shape, np.float32) if begun is None else None
        if begun is not None:
            with _damaged(begun):
                self._array = _opened(begun.new, "r+")["0"]
                if getattr(self._array, "shape", None) != shape:
                    raise ValueError("it lacks its array")
        self._kept: list[tuple[str, Chunk]] = []

    def has(self, request: str, at: Chunk) -> bool:
        """Return whether a chunk was written for a request (a checksum) and is unchanged."""
        if self.begun is None or not self._same(request, at):
            return False
        self._kept.append((request, at))
        return True

    def _same(self, request: str, at: Chunk) -> bool:
        assert self.begun is not None
        with _damaged(self.begun):
            return self.begun.has(_name(at), request, np.asarray(self._array[at]))

    def put(self, request: str, at: Chunk, values: Values) -> None:
        """Write a chunk, and record its request."""
        if self.begun is None:
            self._array[at] = values
            return
        self.begun.require_there()
        with _damaged(self.begun):
            self._array[at] = values
        self.begun.put(_name(at), request, values)
        self._kept.append((request, at))

    def finish(self, description: str, channels: int) -> Any:
        """Rename a folder to its final name, and return the values of the restored channels."""
        if self.begun is None:
            values = self._array[:channels]
            return values[0] if self.shape[0] == 1 else values
        # Checked once more: chunks of an earlier call may have been replaced while this one wrote others.
        if not all(self._same(*each) for each in self._kept):
            raise ValueError(f"chunks in {line(self.begun.room)} were changed by another process; call again")
        recordings.require_own(self.begun.place)
        with _damaged(self.begun):
            _opened(self.begun.new, "r+").attrs["lommel"] = {"description": description}
        self.begun.finish()
        return _opened(self.begun.place, "r")["0"]  # shape (channels, planes, height, width), as stored


@contextmanager
def _damaged(begun: Unfinished) -> Iterator[None]:
    """Convert errors of zarr to a ValueError that names the folder."""
    try:
        with atomic.as_path_error(begun.place):
            yield
    except Exception as error:  # zarr raises many types on damaged files
        if isinstance(error, OSError | MemoryError) or "can't start new thread" in str(error):
            raise
        raise ValueError(f"{line(begun.room)} is damaged ({reading.reason(error)}); remove it") from None


def _name(at: Chunk) -> str:
    return f"{at[0]}.{at[2].start}.{at[3].start}"


@contextmanager
def _destination(out: str | PathLike[str] | None, shape: tuple[int, ...], recording: Recording) -> Iterator[_Target]:
    """Yield the destination of values: an array, or with `out` a folder that an earlier call may have begun."""
    if out is None:
        yield _Target(shape, None)
        return
    place = validation.path("out", out)
    if recordings.kind_of(place, recording.path) != "zarr":
        raise ValueError(f"out must end in .zarr, which is written chunk by chunk, got {shown(place.name)}")
    if not place.parent.is_dir():
        raise FileNotFoundError(2, "No such file or directory", str(place.parent))
    described = {name: getattr(recording, name) for name in ("pixel", "step", "names", "emission")}
    request = {"software": f"lommel {version()}", "shape": shape} | described
    with atomic.unfinished_folder(
        place, request, lambda folder: recordings.new_zarr(folder, shape, recording, place.stem)
    ) as begun:
        yield _Target(shape, begun)


def _opened(folder: Path, mode: Literal["r", "r+"]) -> Any:
    """Open the Zarr group in a folder."""
    import zarr

    return zarr.open(str(folder), mode=mode)


def _checksum(stack: Stack) -> str:
    """Return the checksum of all values of a stack."""
    digest = hashlib.sha256()
    for plane in range(len(stack)):
        digest.update(np.asarray(stack[plane]).tobytes())
    return digest.hexdigest()


@dataclass
class _Source:
    """A stack, its noise, and the value from which on voxels are ignored."""

    stack: Stack  # from `_orient` on, the plane nearest to the cover glass is first
    camera: Noise
    limit: float
    turned: bool = False  # whether the order of the planes is reversed from that of the recording


@dataclass
class _Outcome:
    """Sums of Poisson deviances over the voxels of all chunks, and the end of the iteration of the central chunk."""

    after: float = 0.0
    before: float = 0.0
    voxels: float = 0.0  # number of voxels that are not ignored
    steps: int = 0
    stopped: str = STEPS
    strength: float | None = None
    background: float | Array = 0.0
    finding: Finding | None = None


class _ChannelRestoration:
    """The restoration of one channel; each assumption is added to the notes."""

    def __init__(
        self, stack: Stack, model: DepthModel, options: _Options, notes: list[str], target: _Target, place: int
    ) -> None:
        self._stack, self._model, self._options, self._notes = stack, model, options, notes
        self._threads, self._target, self._place = options.threads or 0, target, place
        planes, height, width = stack.shape
        self._projections = ProjectionBuilder((planes, height, width))
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
        estimate = background == Background(None)
        parts = _progress_parts(context, crop, options.direction == "auto", len(options.refine), options.diagnosis)
        context = self._orient(source, context, crop, _within(report, 0.0, parts[0]))
        context, estimated, errors = self._refine(context, crop, _within(report, *parts[:2]))
        level = self._compare_held_out(context, estimate, _within(report, *parts[1:]))
        background = background if level is None else Background(level)
        margin = self._margin()
        report(parts[-1], "PSFs")
        psfs = self._model.psfs(margin[0], options.slabs)
        depths = psfs.planes[margin[0] : margin[0] + len(self._stack)]
        self._note_psfs(psfs, depths)
        specimens = 5.0 if isinstance(options.method, TotalVariation) else 4.0  # number of arrays of specimen size
        side = self._side(options.tile, margin, psfs, specimens)
        if options.margin is None and len(self._stack) < self._model.window[0] // 2:
            notes.append("The stack is thinner than its PSF: light from planes beyond it is not restored.")
        request = "" if self._target.begun is None else self._request(source, psfs, margin, side, background)
        reached = parts[-1]

        def report_chunks(fraction: float, message: str) -> None:
            nonlocal reached
            reached = parts[-1] + (1.0 - parts[-1]) * fraction
            report(reached, message)

        outcome = self._restore_chunks(source, psfs, margin, side, background, request, report_chunks)
        if estimate or background.level is None:
            low, high = float(np.min(outcome.background)), float(np.max(outcome.background))
            found = f"A flat background of {low:.4g}" if low == high else f"A background of {low:.4g} to {high:.4g}"
            notes.append(
                f"{found} counts per voxel was estimated, which the restored values exclude; background= states "
                "another, 0 for none."
            )
        self._conclude(outcome, context, _within(report, min(reached, 0.5), 1.0))
        turned = source.turned
        return RestoredChannel(
            outcome.after / outcome.voxels, outcome.before / outcome.voxels, outcome.steps, outcome.stopped,
            source.camera, "down" if turned else "up", depths[::-1] if turned else depths, psfs.depths, estimated,
            errors, self._projections.result(turned=turned), outcome.background, outcome.strength,
            Findings(self._findings),
        )  # fmt: skip

    def _prepare(self, mask: NDArray[np.bool_] | None) -> _Source:
        """Return the stack without saturated, masked or hot voxels, and its noise."""
        given = self._options.noise
        limit = self._limit(self._options.saturation)
        if mask is not None:
            masked = LeftOut(self._stack, limit, mask=mask)
            self._stack, limit = masked, masked.limit
            count = int(mask.sum())
            self._notes.append(f"{count} voxels ({100.0 * count / mask.size:.2g} %) are masked, and were left out.")
        if given is None:
            camera, error = measured_noise(self._stack)
            self._notes.append(
                f"The noise was estimated from the stack: {_format_gain(camera, error)} and an offset of "
                f"{float(camera.offset):.4g} counts; a read noise of {float(camera.read):g} electrons was assumed."
            )
        else:
            camera = given.require_shape(self._stack.shape)
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
        source.turned = direction == "down"
        if source.turned:
            # Results are reversed again at the end.
            source.stack = _ReversedStack(source.stack)
        return context._replace(stack=source.stack)

    def _refine(
        self, context: StackContext, crop: tuple[slice, slice], report: Report
    ) -> tuple[StackContext, dict[str, float], dict[str, float]]:
        """Estimate the parameters in `refine` from the stack, and use them in the model; return values and errors."""
        if not self._options.refine:
            return context, {}, {}
        self._model, estimated, errors = refined(context, crop, self._options.refine, report)
        for name, value in estimated.items():
            self._notes.append(
                f"Estimated from the stack: {PARAMETERS[name]} {_format_estimate(name, value, errors[name])}."
            )
        return context._replace(model=self._model), estimated, errors

    def _margin(self) -> tuple[int, int]:
        """Return the margin beyond the stack that is restored, in planes and in pixels."""
        if self._options.margin is not None:
            planes, pixels = self._options.margin
            return int(planes), int(pixels)
        deep, side = self._model.window
        return min(deep // 2, max(_MIN_MARGIN, len(self._stack) // 4)), side // 2

    def _note_psfs(self, psfs: PSFs, depths: Array) -> None:
        """Note the depths of the PSFs, and the unit of a restored value."""
        notes, model, nodes = self._notes, self._model, psfs.depths
        above = int((depths <= 0.0).sum())
        if above > 1:
            notes.append(
                f"{above} of {len(depths)} planes are focused above the sample, in the cover glass or at it, if the "
                f"middle one is focused {format_length(model.depth, digits=3)} below it; depth= states another depth."
            )
        if len(nodes) > 1:
            each = "one for each plane and its margin" if psfs.radial is not None else "with weights between them"
            notes.append(f"{len(nodes)} PSFs were used, {each}, of depths from {between(nodes[0], nodes[-1])}.")
        if model.spreads and self._options.per_plane:
            notes.append("Restored values are light per plane: a point with F counts in each plane has the value F.")
        elif model.spreads:
            notes.append(
                f"Restored values are the light summed over {model.window[0]} planes: a point with F counts in each "
                f"plane has the value {model.window[0]} F; per_plane=True returns F."
            )

    def _request(
        self, source: _Source, psfs: PSFs, margin: tuple[int, int], side: int, background: Background
    ) -> str:
        """Return the checksum of all inputs of the restored values."""
        model, options, stack = self._model, self._options, source.stack
        # The first and last PSF represent the optical model: a change of the optics changes them.
        ends = [hashlib.sha256(model.psf(psfs.depths[at]).values.tobytes()).hexdigest() for at in (0, -1)]
        content = (
            _checksum(stack), stack.shape, str(stack.dtype), ends, model.pixel, model.step, model.depth,
            psfs.depths.tolist(), margin, side, source.turned, source.camera.to_dict(), options.method, source.limit,
            background, options.per_plane, options.background == FLAT, options.diagnosis,
        )  # fmt: skip
        return hashlib.sha256(repr(content).encode()).hexdigest()

    def _conclude(self, outcome: _Outcome, context: StackContext, report: Report) -> None:
        """Add the findings of the restoration; to a misfit, the alternative PSFs that fit the stack better."""
        options, finding = self._options, outcome.finding
        if finding is not None:
            if finding.code == "misfit" and options.diagnosis and "hot_pixels" not in self._doubt_codes():
                finding = _explain_misfit(
                    finding, rank_alternatives(context, report, turned=options.direction != "auto")
                )
            self._findings.append(finding)
        if outcome.stopped == INTERRUPTED:
            self._findings.append(Finding("interrupted", "doubt", "it was interrupted: the completed steps are kept"))

    def _compare_held_out(self, context: StackContext, estimate: bool, report: Report) -> float | None:
        """Compare PSFs by held-out photons; return the background level with `estimate` and a stack small enough."""
        if not self._options.diagnosis:
            return None
        held = HeldOut(context, report)
        if held.plain:
            text = "a flat scene explains the brightest part of the stack: other PSFs were not compared"
            self._findings.append(Finding("untested", "note", text))
            return None
        own = held.best("the PSF as given", context.model)
        self._best_steps = own.steps
        if finding := held.finding(own):
            self._findings.append(finding)
        # The background is estimated on the whole stack: a part also has blurred light from beside it.
        if not estimate or math.prod(context.stack.shape) > WHOLE:
            return None
        side = max(context.stack.shape[1:])
        if side > SIDE:
            held = HeldOut(context, report, side=side)
            own = held.best("background", context.model)
            self._best_steps = own.steps
        return held.level(own)

    def _doubt_codes(self) -> tuple[str, ...]:
        """Return the codes of the findings of severity "doubt"."""
        return tuple(each.code for each in self._findings if each.severity == "doubt")

    def _exclude_hot(self, camera: Noise, limit: float) -> tuple[Stack, Noise, float]:
        """Return the stack without hot pixels and voxels, its noise, and the value from which voxels are ignored."""
        sharpest, stack = sharpness(self._model.psf(0.0).values), self._stack
        pixels = hot_pixels(stack, camera, sharpest, limit)
        if count := int(pixels.sum()):
            share = count / pixels.size
            text = (
                f"{count} pixels ({100.0 * share:.2g} %) exceed their neighbours in most planes, whatever is "
                "in focus: they were taken as hot pixels, and left out"
            )
            self._findings.append(Finding("hot_pixels", "note", text, {"pixels": count, "share": share}))
            stack = LeftOut(stack, limit, mask=pixels)
            limit = stack.limit
        hot = hot_voxels(stack, camera, sharpest, limit)
        share = len(hot) / math.prod(stack.shape)
        which = f"{len(hot)} voxels ({100.0 * share:.2g} %) exceed their neighbours by more than the PSF lets a point"
        numbers = {"voxels": len(hot), "share": share}
        if share > MOST:
            text = f"{which}, in single planes: they were not left out; are pixel, wavelength and NA right?"
            self._findings.append(Finding("hot_pixels", "doubt", text, numbers))
        if not 0.0 < share <= MOST:
            return stack, camera, limit
        text = f"{which}, in single planes: they were taken as cosmic rays or blinking pixels, and left out"
        self._findings.append(Finding("hot_pixels", "note", text, numbers))
        cleaned = LeftOut(stack, limit, voxels=hot)
        return cleaned, camera, cleaned.limit

    def _check_noise(self, camera: Noise) -> None:
        """Add a note if the stack contradicts the stated noise."""
        planes, lowest = len(self._stack), math.inf
        # Three standard deviations of the read noise and of rounding to integers (about 0.3 counts).
        dark = camera.offset - 3.0 * np.hypot(camera.read / (1.0 if camera.white is None else camera.white), 0.3)
        below = 0
        for plane in range(planes):
            values = plane_of(self._stack, plane)
            below += int((values < dark).sum())
            lowest = min(lowest, float(np.nanpercentile(values, 1.0)))
        share = below / math.prod(self._stack.shape)
        if share > _DARK_FRACTION:
            self._notes.append(
                f"{100.0 * share:.2g} % of the voxels are below the offset by more than the read noise explains, and "
                f"count as dark. Check the offset of noise=: the darkest voxels have {lowest:.4g} counts."
            )
        elif note := contradiction(self._stack, camera):
            self._notes.append(note)

    def _limit(self, saturation: float | None) -> float:
        """Return the value from which on voxels are saturated, infinity for none."""
        planes = self._stack
        if planes.dtype.kind not in "iu" and (
            lost := sum(int((~np.isfinite(planes[plane])).sum()) for plane in range(len(planes)))
        ):
            self._notes.append(f"{lost} voxels are NaN or infinite: unknown, and left out.")
        limit, assumed = full_value(cast("Sequence[Values]", planes), saturation, name="voxels")
        count = sum(int((np.asarray(planes[plane]) >= limit).sum()) for plane in range(len(planes)))
        if assumed:
            self._notes.append(f"{assumed[0].upper()}{assumed[1:]}. Record with less light or time.")
        elif count:
            most = "the saturation that was stated" if saturation is not None else "the largest value of their type"
            share = 100.0 * count / math.prod(planes.shape)
            self._notes.append(f"{count} voxels ({share:.2g} %) have {most}, {limit:g}, or more, and were left out.")
        return limit

    def _side(self, tile: int | None, margin: tuple[int, int], psfs: PSFs, specimens: float) -> int:
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
        given = math.prod(min(side + 2 * overlap, each) for each in (height, width))
        whole = math.prod(min(side + 2 * overlap, each) + 2 * margin[1] for each in (height, width))
        deep = planes + 2 * margin[0]
        transfers = 2.0 * len(psfs.depths) * (planes + self._model.window[0]) * whole / 4.0
        if psfs.radial is not None:
            transfers = float(len(psfs.radial.frequencies) * planes * deep)
        # Four bytes a value, and a tenth for the coarse grid.
        return 4.4 * float(specimens * deep * whole + 3.0 * planes * given + transfers)

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
        """Restore chunk by chunk: the central one first; the others repeat its step settings (its course)."""
        planes, height, width = source.stack.shape
        method, blurs = self._options.method, dict[tuple[int, int, int], PlaneOperator]()
        sides = [math.ceil(each / math.ceil(each / side)) for each in (height, width)]
        tiles = sorted(
            tiles_of((height, width), sides, self._model.window[1]),
            key=lambda tile: _distance_from_middle(tile[0], height, width),
        )
        # With several chunks, all start from the mean light of the whole stack.
        level = None if len(tiles) == 1 else _mean_light(source)
        course: list[StepSettings] | None = None
        factor = np.float32(1.0 / self._model.window[0] if self._options.per_plane else 1.0)
        outcome = _Outcome(background=np.zeros((height, width)) if background.points > 1 else 0.0)
        for number, (place, around, within) in enumerate(tiles):
            at = np.s_[self._place, :, *place]
            if number and self._target.has(request, at):
                continue
            counted = PoissonCounts(_load(source.stack, *around), source.camera.part(*around), source.limit)
            counted.level = counted.level if level is None else level
            size = (planes, *(part.stop - part.start for part in around))
            if size not in blurs:
                blurs.clear()  # keep a single operator in memory
                blurs[size] = self._model.blur(size, margin, psfs, threads=self._threads)
            blur = blurs[size]
            if blur.outside is not None:
                blur.outside[...] = counted.level
            before = counted.mean(counted.discrepancies(blur, counted.scene(*margin)))
            iteration = self._iteration(blur, counted, course, background)
            progress = _ChunkProgress(
                report, number, len(tiles), method.steps if course is None else len(course), method.target > 0.0
            )
            count, stopped, discrepancies = self._solve(iteration, progress, alone=level is None)
            after = counted.mean(discrepancies)
            if course is None:
                course, outcome.steps, outcome.strength = iteration.course, count, iteration.strength
                outcome.finding = self._central_finding(counted, stopped, count, after)
                is_misfit = outcome.finding is not None and outcome.finding.code == "misfit"
                outcome.stopped = MISFIT if is_misfit else stopped
            if isinstance(outcome.background, np.ndarray):
                outcome.background[place] = np.asarray(counted.background)[within]
            elif number == 0:
                outcome.background = counted.background
            voxels = float(counted.known.sum())
            outcome.after += after * voxels
            outcome.before += before * voxels
            outcome.voxels += voxels
            restored = np.ascontiguousarray(iteration.inside(*margin)[:, *within])
            restored *= factor
            corner = around[0].start, around[1].start
            self._projections.add(*place, corner, blur, counted, iteration.guess, restored)
            # The target has the planes in the order of the recording.
            self._target.put(request, at, restored[::-1] if source.turned else restored)
        return outcome

    def _iteration(
        self, blur: PlaneOperator, counted: PoissonCounts, course: list[StepSettings] | None, background: Background
    ) -> Iteration:
        """Return the iteration of a chunk, which ends early after the best number of steps by held-out photons."""
        model, method = self._model, self._options.method
        aspect = model.pixel / model.objective.magnification / model.step
        iteration = iteration_of(
            method, blur, counted, course, background=background, aspect=aspect, threads=self._threads
        )
        iteration.enough = enough(method, self._best_steps, counted)
        return iteration

    def _solve(self, iteration: Iteration, report: ProgressCallback, *, alone: bool) -> tuple[int, str, Array]:
        """Iterate; return the number of steps, why they ended, and the discrepancies. Ctrl-C keeps a single chunk."""
        try:
            return iteration.solve(self._options.method, report)
        except KeyboardInterrupt:
            if not alone or self._target.begun is not None or not iteration.course:
                raise
            return len(iteration.course) - 1, INTERRUPTED, iteration.discrepancies

    def _central_finding(self, counted: PoissonCounts, why: str, steps: int, discrepancy: float) -> Finding | None:
        """Return the finding on the convergence of the central chunk, None if there is none."""
        finding = counted.finding(why, steps, discrepancy)
        is_settled = why != STEPS or self._options.method.target <= 0.0 or discrepancy <= 1.0 + counted.slack
        if finding is not None or is_settled:
            return finding
        text = f"the residual exceeds the noise after the {steps} steps of the method; allow more"
        return Finding("not_settled", "doubt", text, {"discrepancy": discrepancy, "steps": steps})


class _ChunkProgress:
    """Progress of a chunk, reported as a fraction of the work of all chunks."""

    def __init__(self, report: Report, number: int, count: int, steps: int, doubtful: bool) -> None:
        self._report, self._number, self._count, self._steps = report, number, count, steps
        self._doubtful = doubtful  # whether it may end as a misfit, after which other PSFs are tried
        self._begun = clock.monotonic()

    def __call__(self, step: int, discrepancy: float, left: float) -> None:
        message = f"step {step}, discrepancy {discrepancy:.3g}"
        fraction = min(step / max(self._steps, 1), 1.0)
        if self._count == 1:
            spent = clock.monotonic() - self._begun
            fraction = spent / (spent + left) if spent + left > 0.0 else 0.0
            if self._doubtful and step <= EARLIEST:
                fraction = min(fraction, _MISFIT_PROGRESS * step / EARLIEST)
        else:
            message = f"chunk {self._number + 1} of {self._count}, {message}"
        self._report((self._number + fraction) / self._count, message)


def _within(report: Report, begin: float, end: float) -> Report:
    """Return a callback that maps the progress of one part, 0 to 1, to `begin` to `end` of the whole work."""
    return lambda fraction, message: report(begin + (end - begin) * fraction, message)


def _explain_misfit(misfit: Finding, others: list[str]) -> Finding:
    """Return the misfit with the names of the PSFs that fit the stack better; a doubt if there are none."""
    if not others:
        text = (
            "the residual exceeds the noise, but no other PSF fits better: the cause may be points between voxels or "
            "a wrong gain; check noise="
        )
        return replace(misfit, severity="doubt", text=text)
    text = f"PSFs with {others[0]} fit the stack better"
    if len(others) > 1:
        likeliest = ", ".join(others)
        text = f"other PSFs fit the stack better; one of these may be wrong, the likeliest first: {likeliest}"
    return replace(misfit, text=text, numbers={**misfit.numbers, "others": others})


def _progress_parts(
    context: StackContext, crop: tuple[slice, slice], direction: bool, refine: int, held_out: bool
) -> tuple[float, float, float]:
    """Return the progress, 0 to 1, after estimating the direction of z, the PSF, and the background."""
    height, width = context.stack.shape[1:]
    part = math.prod(at.stop - at.start for at in crop) / (height * width)
    first, second = (part * steps for steps in estimated_steps(direction, refine))
    third = estimated_held_out_steps(context.stack.shape) if held_out else 0.0
    whole = first + second + third + _USUAL_STEPS
    return first / whole, (first + second) / whole, (first + second + third) / whole


def _format_estimate(name: str, value: float, error: float) -> str:
    """Return a value and its standard error in words."""
    if not math.isfinite(error):
        return "is not determined by it"
    factor, unit = {"depth": (1e6, " um"), "spherical": (1.0, " waves rms")}.get(name, (1.0, ""))
    return " +- ".join(with_error(factor * value, factor * error)) + unit


def _format_gain(camera: Noise, error: float) -> str:
    """Return a measured gain in words."""
    gain = 1.0 if camera.white is None else float(camera.white)
    return " +- ".join(with_error(gain, gain * error)) + " electrons per count"


def between(low: float, high: float) -> str:
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
    out = np.empty((source.shape[0], rows.stop - rows.start, columns.stop - columns.start), source.dtype)
    for plane in range(len(out)):
        out[plane] = source[plane, rows, columns]
    return out


class Projections(NamedTuple):
    """Projections along z, shape (height, width), and along y, shape (planes, width), of float32.

    Attributes
    ----------
    recorded, restored : (ndarray, ndarray)
        Maxima, in the unit of the recording without its offset.
    residual : (ndarray, ndarray)
        Differences of recording and model in units of the noise, summed along the line and divided by the square root
        of the number of voxels: of unit variance where PSF and noise model are right.
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
        counted: PoissonCounts,
        light: Part,
        restored: Values,
    ) -> None:
        """Add a chunk, `restored` at `rows` and `columns`; `corner` is the first (row, column) blurred."""
        down, across = (at.start - first for at, first in zip((rows, columns), corner, strict=True))
        height, width = rows.stop - rows.start, columns.stop - columns.start
        sums, voxels, maxima = (np.zeros((height, width), np.float32) for _ in range(3))
        along_y = np.zeros((3, len(restored), width), np.float32)  # sums, numbers of voxels, maxima
        lock = Lock()

        def compare(plane: int, y: slice, x: slice, model: Values) -> None:
            counts, residuals, weights = counted.residuals(plane, y, x, model)
            top, left = y.start - down, x.start - across
            inner = np.s_[max(-top, 0) : max(height - top, 0), max(-left, 0) : max(width - left, 0)]
            counts, residuals, weights = counts[inner], residuals[inner], weights[inner]
            rows_at = slice(max(top, 0), max(top, 0) + len(residuals))
            at = rows_at, slice(max(left, 0), max(left, 0) + residuals.shape[1])
            with lock:
                sums[at] += residuals
                voxels[at] += weights
                np.maximum(maxima[at], counts, out=maxima[at])
                part = along_y[:, plane, at[1]]
                part[0] += residuals.sum(axis=0)
                part[1] += weights.sum(axis=0)
                np.maximum(part[2], counts.max(axis=0, initial=0.0), out=part[2])

        blur.forward(light, compare)
        recorded, after, residual = self._projections
        recorded[0][rows, columns] = np.where(voxels > 0.0, maxima, np.float32(np.nan))
        after[0][rows, columns] = restored.max(axis=0)
        residual[0][rows, columns] = _over_root(sums, voxels)
        # Chunks above and below contribute to the same voxels of the projection along y.
        before = self._voxels[:, columns]
        total = along_y[0] + np.nan_to_num(residual[1][:, columns]) * np.sqrt(before)
        self._voxels[:, columns] = before + along_y[1]
        residual[1][:, columns] = _over_root(total, self._voxels[:, columns])
        highest = np.where(along_y[1] > 0.0, along_y[2], np.float32(np.nan))
        for whole, part in ((recorded, highest), (after, restored.max(axis=1))):
            whole[1][:, columns] = np.fmax(whole[1][:, columns], part)

    def result(self, *, turned: bool) -> Projections:
        """Return the projections, their planes reversed with `turned`."""
        if not turned:
            return self._projections
        return Projections(*((each[0], each[1][::-1]) for each in self._projections))


def _over_root(sums: Values, voxels: Values) -> Values:
    """Return sums divided by the square root of the number of voxels, NaN where there are none."""
    return np.where(voxels > 0.0, sums / np.sqrt(np.maximum(voxels, 1.0)), np.float32(np.nan))
