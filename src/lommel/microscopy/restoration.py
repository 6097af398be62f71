"""From the file of a microscope to a restored stack: metadata, noise, PSFs by depth, chunks, projections."""

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
"""Why a restoration ended that was interrupted (Ctrl-C): what was done until then is kept."""

MISFIT = "misfit"
"""Why a restoration ended whose rest is more than noise."""

_DIRECTIONS = ("auto", "up", "down")
_MEMORY = 2.0**31  # bytes
_OFF = 0.02  # largest relative difference of lengths of the file and of the objective
_BELOW = 0.02  # share of the voxels that are not below the offset by chance
_USUAL_STEPS = 60  # usual number of steps of a restoration
_EARLY = 0.3  # share of the work done after the steps in which a misfit may be found
_LEAST_PLANES = 8  # least margin in planes

Shown = Callable[[float, str], object]


@dataclass(frozen=True, eq=False, repr=False)
class RestoredChannel:
    """How one channel of a stack was restored.

    Attributes
    ----------
    discrepancy, before : float
        Poisson deviance per voxel of the result and of the recording itself; about 1 where PSF and noise fit.
    steps : int
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
        Values found from the stack itself, by name, and their standard errors: those of photons, and the change
        since half of the steps. They are inf where the stack does not determine a value.
    projections : Projections
        What :meth:`RestoredStack.plot` draws: the maxima of recording and result, and the residual, each along z and
        along y. NaN in chunks that were restored by an earlier call.
    background : float or ndarray of shape (height, width)
        Light of each voxel that is no part of the values, in the unit of the recording, without the offset.
    strength : float or None
        Weight of the total variation.
    findings : Findings
        What the checks of this channel found.
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
        Restored light in the unit of the recording, without the offset of the camera; shape (planes, height, width),
        or (channels, planes, height, width) of several channels and of `out`. In the order of the recording.
    channels : tuple of RestoredChannel
    recording : Recording
        With the voxel sizes and wavelengths that were used.
    notes : tuple of str
        What was taken from the file, estimated or assumed, in sentences.
    findings : Findings
        What the checks found, of all channels. Errors are "misfit" and "too_quiet"; doubts "psf_doubtful", where
        photons that were held out agree better with another PSF, "misfit" where none of those tried does,
        "hot_pixels", "not_settled" and "interrupted"; the others are notes. What follows from them is
        ``converged``, ``reliable`` and ``status``.
    summary : str
        Discrepancies and steps.
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
            As of all fits, and the shape and voxel sizes (metres). Channels have their name and wavelength, least and
            greatest depth, number of PSFs, and the mean of their background.
        """
        found = super().to_dict()
        told = zip(found["channels"], self.channels, self.recording.names, self.recording.emission, strict=False)
        for channel, each, name, wave in told:
            channel |= {"name": name, "wavelength": wave, "psfs": len(each.psf_depths)}
            channel["depths"] = [float(each.depths.min()), float(each.depths.max())]
            channel["background"] = float(np.mean(each.background))
        sizes = {"pixel_in_sample": self.recording.pixel, "step": self.recording.step}
        return {"shape": list(self.values.shape[-3:])} | sizes | found

    def plot(self) -> Figure:
        """Return a matplotlib figure of maximum projections before and after, and of the residual over its noise.

        Projections along z (xy), and below them along y (xz), with a scale bar. The residual is the sum over each
        projected line over the square root of its voxels: where PSF and noise are right it has no pattern, and hardly
        exceeds 3.

        Returns
        -------
        matplotlib Figure

        Raises
        ------
        ImportError
            If matplotlib is not installed.
        """
        several = len(self.channels) > 1
        drawn = [
            (f"{name}: " if several else "", each.projections)
            for name, each in zip(self.recording.names, self.channels, strict=False)
        ]
        assert self.recording.pixel is not None
        assert self.recording.step is not None
        said = "; ".join(
            f"{name}discrepancy {each.before:#.3g} before, {each.discrepancy:#.3g} after {each.steps} steps"
            for (name, _), each in zip(drawn, self.channels, strict=True)
        )
        return pictures.projections(drawn, (self.recording.step, self.recording.pixel), said)

    def save(self, *paths: str | PathLike[str]) -> None:
        """Write the stack with its voxel sizes, channels and wavelengths.

        Parameters
        ----------
        *paths : path
            OME-TIFF where a name ends in .tif or .tiff, OME-Zarr (0.4) where it ends in .zarr; written under another
            name and moved into place.

        Raises
        ------
        ValueError
            If a name ends otherwise, or is that of the recording.
        OSError, ImportError
            If it cannot be written, or tifffile or zarr is not installed.
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
    progress: Shown | None = None,
    threads: int | None = None,
) -> RestoredStack:
    """Deconvolve the stack of a microscope, from its file: voxel sizes, noise and PSFs by depth are found for it.

    Parameters
    ----------
    stack : path or array_like
        As of :func:`lommel.microscopy.open_recording`: OME-TIFF, TIFF of ImageJ, OME-Zarr; arrays of NumPy, dask or
        Zarr, of shape (planes, height, width) or (channels, planes, height, width), of any real type.
    objective : Objective or Microscope
        The objective; or the microscope of :func:`lommel.load_microscope`, whose depth, wavelength, pixel, step,
        emitter and aberrations are used where the file has none.
    depth : float, optional
        Depth below the cover glass that is in focus in plane ``planes // 2``, metres. By default that of the
        Microscope; else half of the stack, as if it began at the glass.
    wavelength : float or sequence of float, optional
        Of the emission, metres; one for each channel. By default that of the file.
    pixel, step : float, optional
        Pixel pitch on the camera, and distance of the stage between planes, metres. By default those of the file,
        whose pixels are in the sample.
    channel, time : int, optional
        Which to restore; by default all channels, and the only time point.
    axes : str, optional
        As of :func:`lommel.microscopy.open_recording`.
    noise : Noise, optional
        Of the camera, in the unit of the file; maps per pixel apply to each plane. By default
        :func:`lommel.microscopy.estimate_noise` of each channel.
    saturation : float, optional
        Value from which on voxels are saturated, and unknown. By default the largest value of 8, 10, 12, 14 or 16
        bits, if integers have it at several voxels. NaN, what is masked, and hot pixels are unknown, too.
    mask : array_like of bool, optional
        True for what is to be left out: of shape (height, width) for all planes, or of the stack. Masks of NumPy's
        arrays count, too.
    modality : {"widefield", "confocal", "spinning disc", "light sheet", "two-photon"}, default "widefield"
    excitation : float, optional
        Vacuum wavelength of the excitation, metres: for "confocal", "spinning disc" and "two-photon", where the file
        does not say.
    pinhole : float, default 1
        Diameter in Airy units, for "confocal" and "spinning disc".
    thickness : float, optional
        Full width at half maximum of the "light sheet", metres, which stays in the focal plane.
    direction : {"auto", "up", "down"}, default "auto"
        "up": the first plane is the nearest to the cover glass. "auto" tries both and takes the one that the data
        follow better; "up" where they do not tell.
    slabs : int, optional
        Number of PSFs over the depth of the stack, with linear weights between them; 1 for the same everywhere. By
        default each plane has its own; with aberrations that are not rotationally symmetric, as many as are needed
        for PSFs in between to be within 3 % of the light, up to 9.
    refine : sequence of {"depth", "sample", "spherical"}
        What is estimated from the stack by its likelihood first: the depth, the refractive index of the sample, or
        spherical aberration (waves rms).
    method : RichardsonLucy or TotalVariation, optional
        As of :func:`lommel.microscopy.deconvolve`: ``lm.imaging.RichardsonLucy(target=1.0)`` by default.
    background : "flat", "uneven" or float, default "flat"
        As of :func:`lommel.microscopy.deconvolve`. With `diagnosis` the flat one of up to 500000 voxels is found by
        photons that are held out, and then held; else it is estimated with the specimen, in the central chunk. Each
        chunk has its own uneven one, so that it is best used without chunks.
    psf_shape : (int, int), optional
        Planes and pixels of the PSFs, odd. By default those of the cone of light over half of the planes, up to 97.
    margin : (int, int), optional
        As of :func:`lommel.microscopy.deconvolve`.
    tile : int, optional
        Side of lateral chunks, pixels. By default the whole, or what `memory` holds. Chunks overlap by the PSF, and
        all take the steps of the central one, with its extrapolation: what differs from the whole is what some steps
        change. In a test the sum of differences was 3 % of the light after 5 steps and 17 % after 25, of which 2 %
        without extrapolation (``RichardsonLucy(accelerate=False)``).
    memory : float, default 2**31
        Bytes that may be used besides input and output.
    diagnosis : bool, default True
        Whether some photons are held out, to find the background and when to stop, and to compare PSFs of other
        indices of the sample in a part of the stack; and whether other PSFs are tried after a misfit. Stacks of
        20 x 40 x 40 voxels take two to four times as long with it, those of 41 x 96 x 96 two to three times.
    per_plane : bool, default False
        Whether restored values are the light that the objective collects in one plane, rather than in all planes of
        the window of the PSF; for "widefield" and "light sheet".
    out : path, optional
        A folder .zarr that values are written to, chunk by chunk, for stacks larger than memory; in place of a
        restored stack, not of anything else. If it is interrupted, the same call goes on where it ended: chunks of
        other values or arguments, and damaged ones, are computed again. Until then they are in a hidden folder
        beside it, ``.NAME.unfinished``, that one call at a time writes into.
    progress : callable, optional
        Called as ``progress(share, words)`` with the share that is done, 0 to 1.
    threads : int, optional
        By default as many as there are processors. The result does not depend on it.

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
    Depths are those of the brightest focus of an emitter, by :meth:`lommel.Objective.focus`: restored points stay in
    the plane in which they are brightest. Wide-field and light-sheet PSFs have all light that the objective collects
    in each of their planes: that beyond their window is blurred on a coarse grid, and light from outside of the field
    is estimated, one level for each plane. With `slabs` a stack is blurred as ``sum_s h_s * (w_s x)``, with PSFs h_s
    and weights w_s of each plane. Transposes are exact. After Ctrl-C the steps that are done are kept, as
    ``stopped="interrupted"``; with `out` it raises KeyboardInterrupt, and can be continued.
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
    """Arguments of :func:`restore` that say how a channel is restored."""

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
        for name in _listed("refine", self.refine):
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
    tell: Shown,
) -> list[RestoredChannel]:
    """Restore channels, those before an interruption; notes are those of the first."""
    made: list[RestoredChannel] = []
    for place, (number, model) in enumerate(zip(chosen, models, strict=True)):
        job = _Job(opened.stack(number), model, options, notes if place == 0 else [], target, place)
        share = _within(tell, place / len(chosen), (place + 1) / len(chosen))
        name = "" if len(chosen) == 1 else f"{opened.names[number]}: "

        def told(part: float, words: str, share: Shown = share, name: str = name) -> None:
            share(part, name + words)

        made.append(job.run(None if left is None else left[number], told))
        if made[-1].stopped == INTERRUPTED:
            break
    return made


def _mask_of(
    mask: ArrayLike | None, hidden: NDArray[np.bool_] | bool | None, shape: tuple[int, int, int, int]
) -> NDArray[np.bool_] | None:
    """Return what is to be left out of each channel, or None."""
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


def _listed(name: str, given: object) -> list[str]:
    if isinstance(given, str) or not isinstance(given, Sequence):
        raise TypeError(f'{name} must be a sequence of names, such as ("depth",), got {shown(given)}')
    return list(given)


class MicroscopeData(Protocol):
    """What :func:`lommel.load_microscope` returns: an objective, and how stacks are recorded with it."""

    objective: Objective
    wavelength: float
    depth: float
    pixel: float
    step: float
    emitter: Emitter
    aberrations: Wavefront | None


def _objective(given: Any) -> tuple[Objective, MicroscopeData | None]:
    """Return an objective, and the microscope that it is of, if it is of one."""
    if isinstance(given, Objective):
        return given, None
    if isinstance(getattr(given, "objective", None), Objective):
        return given.objective, given
    raise TypeError(
        f"objective must be an Objective, or a Microscope as lommel.load_microscope reads it, got {shown(given)}"
    )


class _Sizes:
    """Pixel on the camera and step of the stage, metres."""

    def __init__(
        self,
        opened: Recording,
        lens: Objective,
        given: MicroscopeData | None,
        pixel: float | None,
        step: float | None,
        notes: list[str],
    ) -> None:
        told = None if opened.pixel is None else opened.pixel * lens.magnification
        self.pixel = self._one("pixel", pixel, told, None if given is None else given.pixel, opened, notes)
        self.step = self._one(
            "step", step, opened.step, (None if given is None else abs(given.step)) or None, opened, notes
        )
        if pixel is not None:
            validation.pixel(self.pixel, metric=True)
        if not 0.0 < self.step < 1e-4:
            raise ValueError(f"step must be of the stage, in metres, above 0 and below 1e-4, got {self.step:g}")
        if opened.NA is not None and abs(opened.NA - lens.NA) > _OFF * lens.NA:
            notes.append(f"The file says NA {opened.NA:g}, the objective {lens.NA:g}, which was used.")

    def _one(
        self,
        name: str,
        asked: float | None,
        told: float | None,
        other: float | None,
        opened: Recording,
        notes: list[str],
    ) -> float:
        if asked is not None:
            value = validation.real(name, asked, above=0.0)
            if told is not None and abs(value - told) > _OFF * told:
                notes.append(f"Of the {name}, {name}={format_length(value)} was taken, not that of the file.")
            return value
        what = "an array" if opened.path is None else line(opened.path)
        if name in opened.unusable:
            where = "in the sample" if name == "pixel" else "between planes"
            raise ValueError(
                f"{what} says {opened.unusable[name]} {where}, which cannot be used: give {name}=, in metres"
                + (" on the camera" if name == "pixel" else "")
            )
        if told is None and other is None:
            raise ValueError(
                f"{what} does not say the voxel size: give pixel= (on the camera) and step= (of the stage), in metres"
            )
        if told is None:
            where = "on the camera" if name == "pixel" else "of the stage"
            notes.append(
                f"The stack does not say its {name}: that of the objective file was taken, "
                f"{format_length(float(other or 0.0))} {where}; {name}= states another."
            )
            return float(other or 0.0)
        if other is not None and abs(other - told) > _OFF * told:
            notes.append(
                f"The stack has a {name} of {format_length(told)}, the objective file {format_length(other)}: that "
                "of the stack was taken."
            )
        return told


def _wavelengths(
    opened: Recording,
    given: MicroscopeData | None,
    asked: float | Sequence[float] | None,
    chosen: range,
    notes: list[str],
) -> list[float]:
    if asked is not None:
        each = np.atleast_1d(validation.real_array("wavelength", asked)).tolist()
        if len(each) not in (1, len(chosen)):
            raise ValueError(f"wavelength must be one, or one for each of {len(chosen)} channels, got {len(each)}")
        return [validation.wavelength(float(wave)) for wave in (each * len(chosen) if len(each) == 1 else each)]
    found = []
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
        elif len(chosen) == 1 and given is not None and abs(wave - given.wavelength) > _OFF * wave:
            notes.append(
                f"The stack has an emission wavelength of {format_length(wave)}, the objective file "
                f"{format_length(given.wavelength)}: that of the stack was taken; wavelength= states another."
            )
        found.append(validation.wavelength(float(wave)))
    return found


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
    """Return the model of a channel, its arguments checked."""
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
        found: Values = self._stack[(len(self) - 1 - plane, *rest)]
        return found


Chunk = tuple[int, slice, slice, slice]
"""The place of a chunk: channel, planes, rows, columns."""


class _Target:
    """The destination of values: an array, or an OME-Zarr folder that gets its name when it is complete."""

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
        """Return whether a chunk of a request is done."""
        if self.begun is None or not self._same(request, at):
            return False
        self._kept.append((request, at))
        return True

    def _same(self, request: str, at: Chunk) -> bool:
        assert self.begun is not None
        with _damaged(self.begun):
            return self.begun.has(_name(at), request, np.asarray(self._array[at]))

    def put(self, request: str, at: Chunk, values: Values) -> None:
        """Write a chunk."""
        if self.begun is None:
            self._array[at] = values
            return
        self.begun.require_there()
        with _damaged(self.begun):
            self._array[at] = values
        self.begun.put(_name(at), request, values)
        self._kept.append((request, at))

    def finish(self, description: str, channels: int) -> Any:
        """Return all values."""
        if self.begun is None:
            values = self._array[:channels]
            return values[0] if self.shape[0] == 1 else values
        # Checked once more: chunks of an earlier call may have been replaced while this one wrote others.
        if not all(self._same(*each) for each in self._kept):
            raise ValueError(f"chunks in {line(self.begun.room)} were changed while it was written; call again")
        recordings.require_own(self.begun.place)
        with _damaged(self.begun):
            _opened(self.begun.new, "r+").attrs["lommel"] = {"description": description}
        self.begun.finish()
        return _opened(self.begun.place, "r")["0"]  # of four axes, as stored


@contextmanager
def _damaged(begun: Unfinished) -> Iterator[None]:
    """Turn errors of zarr into a sentence that names the folder."""
    try:
        with atomic.as_path_error(begun.place):
            yield
    except Exception as error:  # of any kind
        if isinstance(error, OSError | MemoryError) or "can't start new thread" in str(error):
            raise
        raise ValueError(f"{line(begun.room)} is damaged ({reading.reason(error)}); remove it") from None


def _name(at: Chunk) -> str:
    return f"{at[0]}.{at[2].start}.{at[3].start}"


@contextmanager
def _destination(out: str | PathLike[str] | None, shape: tuple[int, ...], recording: Recording) -> Iterator[_Target]:
    """Yield the destination of values of a shape."""
    if out is None:
        yield _Target(shape, None)
        return
    place = validation.path("out", out)
    if recordings.kind_of(place, recording.path) != "zarr":
        raise ValueError(f"out must end in .zarr, which is written chunk by chunk, got {shown(place.name)}")
    if not place.parent.is_dir():
        raise FileNotFoundError(2, "No such file or directory", str(place.parent))
    told = {name: getattr(recording, name) for name in ("pixel", "step", "names", "emission")}
    asked = {"software": f"lommel {version()}", "shape": shape} | told
    with atomic.unfinished_folder(
        place, asked, lambda folder: recordings.new_zarr(folder, shape, recording, place.stem)
    ) as begun:
        yield _Target(shape, begun)


def _opened(folder: Path, mode: Literal["r", "r+"]) -> Any:
    """Return a group of Zarr."""
    import zarr

    return zarr.open(str(folder), mode=mode)


def _hashed(stack: Stack) -> str:
    """Return the checksum of all values of a stack."""
    found = hashlib.sha256()
    for plane in range(len(stack)):
        found.update(np.asarray(stack[plane]).tobytes())
    return found.hexdigest()


@dataclass
class _Source:
    """A stack whose planes run into the sample, its noise, and the value from which on voxels are unknown."""

    stack: Stack
    camera: Noise
    limit: float
    turned: bool = False  # whether the planes are in the other order than in the recording


@dataclass
class _Outcome:
    """Sums over the voxels of chunks, and how the central one ended."""

    after: float = 0.0
    before: float = 0.0
    known: float = 0.0
    steps: int = 0
    stopped: str = STEPS
    strength: float | None = None
    background: float | Array = 0.0
    finding: Finding | None = None


class _Job:
    """The restoration of one channel; what was assumed is added to the notes."""

    def __init__(
        self, stack: Stack, model: DepthModel, options: _Options, notes: list[str], target: _Target, place: int
    ) -> None:
        self._stack, self._model, self._options, self._notes = stack, model, options, notes
        self._threads, self._target, self._place = options.threads or 0, target, place
        planes, height, width = stack.shape
        self._projecting = Projecting((planes, height, width))
        self._findings: list[Finding] = []
        self._steps = 0  # that agree best with photons that were held out

    def run(self, mask: NDArray[np.bool_] | None, tell: Shown) -> RestoredChannel:
        """Restore the channel, without the voxels that a mask hides."""
        options, notes = self._options, self._notes
        tell(0.0, "noise")
        source = self._recorded(mask)
        crop = select_crop(source.stack, self._model.window[1], source.limit)
        context = StackContext(source.stack, self._model, source.camera, source.limit, self._threads)
        background = background_of(options.background)
        estimate = background == Background(None)
        parts = _shares(context, crop, options.direction == "auto", len(options.refine), options.diagnosis)
        context = self._in_order(source, context, crop, _within(tell, 0.0, parts[0]))
        context, estimated, errors = self._refined(context, crop, _within(tell, *parts[:2]))
        level = self._held_out(context, estimate, _within(tell, *parts[1:]))
        background = background if level is None else Background(level)
        margin = self._margin()
        tell(parts[-1], "PSFs")
        psfs = self._model.psfs(margin[0], options.slabs)
        depths = psfs.planes[margin[0] : margin[0] + len(self._stack)]
        self._note_psfs(psfs, depths)
        specimens = 5.0 if isinstance(options.method, TotalVariation) else 4.0  # arrays as large as the specimen
        side = self._side(options.tile, margin, psfs, specimens)
        if options.margin is None and len(self._stack) < self._model.window[0] // 2:
            notes.append("The stack is thinner than its PSF: light from planes beyond it is not restored.")
        request = "" if self._target.begun is None else self._request(source, psfs, margin, side, background)
        reached = parts[-1]

        def told(share: float, words: str) -> None:
            nonlocal reached
            reached = parts[-1] + (1.0 - parts[-1]) * share
            tell(reached, words)

        found = self._by_chunks(source, psfs, margin, side, background, request, told)
        if estimate or background.level is None:
            low, high = float(np.min(found.background)), float(np.max(found.background))
            said = f"A flat background of {low:.4g}" if low == high else f"A background of {low:.4g} to {high:.4g}"
            notes.append(
                f"{said} counts per voxel was estimated, which is no part of the restored values; background= states "
                "another, 0 for none."
            )
        self._conclude(found, context, _within(tell, min(reached, 0.5), 1.0))
        turned = source.turned
        return RestoredChannel(
            found.after / found.known, found.before / found.known, found.steps, found.stopped, source.camera,
            "down" if turned else "up", depths[::-1] if turned else depths, psfs.depths, estimated, errors,
            self._projecting.made(turned=turned), found.background, found.strength, Findings(self._findings),
        )  # fmt: skip

    def _recorded(self, mask: NDArray[np.bool_] | None) -> _Source:
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
                f"The noise was estimated from the stack: {_gain(camera, error)} and an offset of "
                f"{float(camera.offset):.4g} counts; a read noise of {float(camera.read):g} electrons was assumed."
            )
        else:
            camera = given.require_shape(self._stack.shape)
            self._doubt(camera)
        return _Source(*self._without_hot(camera, limit))

    def _in_order(
        self, source: _Source, context: StackContext, crop: tuple[slice, slice], tell: Shown
    ) -> StackContext:
        """Turn the planes of a stack that run towards the cover glass."""
        direction = self._options.direction
        if direction == "auto":
            direction, words = estimate_z_direction(context, crop, tell)
            self._notes.append(words)
        source.turned = direction == "down"
        if source.turned:
            # Results are turned back at the end.
            source.stack = _ReversedStack(source.stack)
        return context._replace(stack=source.stack)

    def _refined(
        self, context: StackContext, crop: tuple[slice, slice], tell: Shown
    ) -> tuple[StackContext, dict[str, float], dict[str, float]]:
        """Estimate parameters of the PSF from the stack, and take them; return them and their standard errors."""
        if not self._options.refine:
            return context, {}, {}
        self._model, estimated, errors = refined(context, crop, self._options.refine, tell)
        for name, value in estimated.items():
            self._notes.append(
                f"Estimated from the stack: {PARAMETERS[name]} {_estimate(name, value, errors[name])}."
            )
        return context._replace(model=self._model), estimated, errors

    def _margin(self) -> tuple[int, int]:
        """Return the planes and pixels beyond the stack that are restored."""
        if self._options.margin is not None:
            planes, pixels = self._options.margin
            return int(planes), int(pixels)
        deep, side = self._model.window
        return min(deep // 2, max(_LEAST_PLANES, len(self._stack) // 4)), side // 2

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
            notes.append("Restored values are the light of one plane: a point of F counts in each plane has F.")
        elif model.spreads:
            notes.append(
                f"Restored values are the light of {model.window[0]} planes together: a point of F counts in each "
                f"plane has {model.window[0]} F; per_plane=True states F."
            )

    def _request(
        self, source: _Source, psfs: PSFs, margin: tuple[int, int], side: int, background: Background
    ) -> str:
        """Return the checksum of everything that restored values depend on."""
        model, options, stack = self._model, self._options, source.stack
        # The first and last PSF stand for the model: a change of the optics changes these.
        ends = [hashlib.sha256(model.psf(psfs.depths[at]).values.tobytes()).hexdigest() for at in (0, -1)]
        content = (
            _hashed(stack), stack.shape, str(stack.dtype), ends, model.pixel, model.step, model.depth,
            psfs.depths.tolist(), margin, side, source.turned, source.camera.to_dict(), options.method, source.limit,
            background, options.per_plane, options.background == FLAT, options.diagnosis,
        )  # fmt: skip
        return hashlib.sha256(repr(content).encode()).hexdigest()

    def _conclude(self, found: _Outcome, context: StackContext, tell: Shown) -> None:
        """Add the findings of the restoration, and of a misfit those PSFs that the stack follows better."""
        options, finding = self._options, found.finding
        if finding is not None:
            if finding.code == "misfit" and options.diagnosis and "hot_pixels" not in self._doubts():
                # The restoration ended before its time.
                finding = _explained(finding, rank_alternatives(context, tell, turned=options.direction != "auto"))
            self._findings.append(finding)
        if found.stopped == INTERRUPTED:
            self._findings.append(
                Finding("interrupted", "doubt", "it was interrupted: steps that were done are kept")
            )

    def _held_out(self, context: StackContext, estimate: bool, tell: Shown) -> float | None:
        """Compare PSFs by held-out photons, and return the level of the background if it is to be estimated."""
        if not self._options.diagnosis:
            return None
        held = HeldOut(context, tell)
        if held.plain:
            text = "a flat scene explains the brightest part of the stack: other PSFs were not compared"
            self._findings.append(Finding("untested", "note", text))
            return None
        own = held.best("the PSF as given", context.model)
        self._steps = own.steps
        if finding := held.finding(own):
            self._findings.append(finding)
        # A part has the blurred light of what is beside it as well: the background is that of the whole.
        if not estimate or math.prod(context.stack.shape) > WHOLE:
            return None
        side = max(context.stack.shape[1:])
        if side > SIDE:
            held = HeldOut(context, tell, side=side)
            own = held.best("background", context.model)
            self._steps = own.steps
        return held.level(own)

    def _doubts(self) -> tuple[str, ...]:
        """Return the codes of findings in doubt."""
        return tuple(each.code for each in self._findings if each.severity == "doubt")

    def _without_hot(self, camera: Noise, limit: float) -> tuple[Stack, Noise, float]:
        """Return the stack without hot pixels and voxels, its noise, and the value that marks unknown voxels."""
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
        known = LeftOut(stack, limit, voxels=hot)
        return known, camera, known.limit

    def _doubt(self, camera: Noise) -> None:
        """Note where the stated noise differs from that of the stack."""
        planes, lowest = len(self._stack), math.inf
        # Three standard deviations of reading; 0.3 counts for the rounding to integers.
        dark = camera.offset - 3.0 * np.hypot(camera.read / (1.0 if camera.white is None else camera.white), 0.3)
        below = 0
        for plane in range(planes):
            values = plane_of(self._stack, plane)
            below += int((values < dark).sum())
            lowest = min(lowest, float(np.nanpercentile(values, 1.0)))
        share = below / math.prod(self._stack.shape)
        if share > _BELOW:
            self._notes.append(
                f"{100.0 * share:.2g} % of the voxels are below the offset by more than the read noise explains, and "
                f"count as dark: is it right? The darkest of the stack have {lowest:.4g} counts."
            )
        elif words := contradiction(self._stack, camera):
            self._notes.append(words)

    def _limit(self, saturation: float | None) -> float:
        """Return the value from which on voxels are saturated."""
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
            whose = "the saturation that was stated" if saturation is not None else "the largest value of their type"
            share = 100.0 * count / math.prod(planes.shape)
            self._notes.append(f"{count} voxels ({share:.2g} %) have {whose}, {limit:g}, or more, and were left out.")
        return limit

    def _side(self, tile: int | None, margin: tuple[int, int], psfs: PSFs, specimens: float) -> int:
        """Return the side of the chunks."""
        _, height, width = self._stack.shape
        if tile is not None:
            return int(validation.integer("tile", tile, least=16, most=validation.MAX_SIDE))
        side, overlap = int(max(height, width)), self._model.window[1]
        # Chunks of equal size: one more along each side until they fit.
        while side > 64 and self._bytes(side, overlap, margin, psfs, specimens) > self._options.memory:
            pieces = math.ceil(max(height, width) / side) + 1
            side = math.ceil(max(height, width) / pieces)
        return side

    def _bytes(self, side: int, overlap: int, margin: tuple[int, int], psfs: PSFs, specimens: float) -> float:
        """Return the approximate memory of a chunk, with `specimens` arrays as large as the specimen."""
        planes, height, width = self._stack.shape
        given = math.prod(min(side + 2 * overlap, each) for each in (height, width))
        whole = math.prod(min(side + 2 * overlap, each) + 2 * margin[1] for each in (height, width))
        deep = planes + 2 * margin[0]
        transfers = 2.0 * len(psfs.depths) * (planes + self._model.window[0]) * whole / 4.0
        if psfs.radial is not None:
            transfers = float(len(psfs.radial.frequencies) * planes * deep)
        # With the transforms of all planes, and a tenth for the coarse grid.
        # Four bytes a value.
        return 4.4 * float(specimens * deep * whole + 3.0 * planes * given + transfers)

    def _by_chunks(
        self,
        source: _Source,
        psfs: PSFs,
        margin: tuple[int, int],
        side: int,
        background: Background,
        request: str,
        tell: Shown,
    ) -> _Outcome:
        """Restore chunk by chunk; the central one first, whose course the others follow."""
        planes, height, width = source.stack.shape
        method, blurs = self._options.method, dict[tuple[int, int, int], PlaneOperator]()
        sides = [math.ceil(each / math.ceil(each / side)) for each in (height, width)]
        tiles = sorted(
            tiles_of((height, width), sides, self._model.window[1]),
            key=lambda tile: _distance_from_middle(tile[0], height, width),
        )
        # All chunks start from the same light.
        level = None if len(tiles) == 1 else _level(source)
        course: list[StepSettings] | None = None
        per = np.float32(1.0 / self._model.window[0] if self._options.per_plane else 1.0)
        found = _Outcome(background=np.zeros((height, width)) if background.points > 1 else 0.0)
        for number, (place, around, within) in enumerate(tiles):
            at = np.s_[self._place, :, *place]
            if number and self._target.has(request, at):
                continue
            # The level is that of the whole stack where there are several chunks.
            counted = PoissonCounts(_loaded(source.stack, *around), source.camera.part(*around), source.limit)
            counted.level = counted.level if level is None else level
            size = (planes, *(part.stop - part.start for part in around))
            if size not in blurs:
                blurs.clear()  # one at a time is in memory
                blurs[size] = self._model.blur(size, margin, psfs, threads=self._threads)
            blur = blurs[size]
            if blur.outside is not None:
                blur.outside[...] = counted.level
            before = counted.mean(counted.discrepancies(blur, counted.scene(*margin)))
            iteration = self._iteration(blur, counted, course, background)
            told = _ChunkProgress(
                tell, number, len(tiles), method.steps if course is None else len(course), method.target > 0.0
            )
            count, why, each = self._solved(iteration, told, alone=level is None)
            if course is None:
                course, found.steps, found.strength = iteration.course, count, iteration.strength
                found.finding = self._central_finding(counted, why, count, counted.mean(each))
                is_misfit = found.finding is not None and found.finding.code == "misfit"
                found.stopped = MISFIT if is_misfit else why
            if isinstance(found.background, np.ndarray):
                found.background[place] = np.asarray(counted.background)[within]
            elif number == 0:
                found.background = counted.background
            voxels = float(counted.known.sum())
            found.after += counted.mean(each) * voxels
            found.before += before * voxels
            found.known += voxels
            kept = np.ascontiguousarray(iteration.inside(*margin)[:, *within])
            kept *= per
            corner = around[0].start, around[1].start
            self._projecting.add(*place, corner, blur, counted, iteration.guess, kept)
            # In the order of the recording.
            self._target.put(request, at, kept[::-1] if source.turned else kept)
        return found

    def _iteration(
        self, blur: PlaneOperator, counted: PoissonCounts, course: list[StepSettings] | None, background: Background
    ) -> Iteration:
        """Return the steps of a chunk, which end early where photons that were held out agree with it."""
        model, method = self._model, self._options.method
        aspect = model.pixel / model.objective.magnification / model.step
        made = iteration_of(
            method, blur, counted, course, background=background, aspect=aspect, threads=self._threads
        )
        made.enough = enough(method, self._steps, counted)
        return made

    def _solved(self, iteration: Iteration, tell: ProgressCallback, *, alone: bool) -> tuple[int, str, Array]:
        """Iterate; a single chunk in memory keeps what was done until Ctrl-C."""
        try:
            return iteration.solve(self._options.method, tell)
        except KeyboardInterrupt:
            if not alone or self._target.begun is not None or not iteration.course:
                raise
            return len(iteration.course) - 1, INTERRUPTED, iteration.discrepancies

    def _central_finding(self, counted: PoissonCounts, why: str, steps: int, discrepancy: float) -> Finding | None:
        """Return what is wrong with the central chunk."""
        finding = counted.finding(why, steps, discrepancy)
        is_settled = why != STEPS or self._options.method.target <= 0.0 or discrepancy <= 1.0 + counted.slack
        if finding is not None or is_settled:
            return finding
        text = f"more than noise is left after {steps} steps, with which the method ended"
        return Finding("not_settled", "doubt", text, {"discrepancy": discrepancy, "steps": steps})


class _ChunkProgress:
    """Reports the steps of a chunk as a share of all work."""

    def __init__(self, tell: Shown, number: int, count: int, steps: int, doubtful: bool) -> None:
        self._tell, self._number, self._count, self._steps = tell, number, count, steps
        self._doubtful = doubtful  # it may end as a misfit, after which other PSFs are tried
        self._begun = clock.monotonic()

    def __call__(self, step: int, discrepancy: float, left: float) -> None:
        words = f"step {step}, discrepancy {discrepancy:.3g}"
        share = min(step / max(self._steps, 1), 1.0)
        if self._count == 1:
            spent = clock.monotonic() - self._begun
            share = spent / (spent + left) if spent + left > 0.0 else 0.0
            if self._doubtful and step <= EARLIEST:
                share = min(share, _EARLY * step / EARLIEST)
        else:
            words = f"chunk {self._number + 1} of {self._count}, {words}"
        self._tell((self._number + share) / self._count, words)


def _within(tell: Shown, begin: float, end: float) -> Shown:
    """Return the function that reports shares of a part of the work."""
    return lambda share, words: tell(begin + (end - begin) * share, words)


def _explained(misfit: Finding, others: list[str]) -> Finding:
    """Return a misfit with the other PSFs that a stack follows better."""
    if not others:
        text = (
            "more than noise is left, but no other PSF fits better: points between voxels, or a gain that is off, "
            "leave as much"
        )
        return replace(misfit, severity="doubt", text=text)
    text = f"the stack follows PSFs of {others[0]} better"
    if len(others) > 1:
        likeliest = ", ".join(others)
        text = f"the stack follows other PSFs better; one of these may be wrong, the likeliest first: {likeliest}"
    return replace(misfit, text=text, numbers={**misfit.numbers, "others": others})


def _shares(
    context: StackContext, crop: tuple[slice, slice], direction: bool, refine: int, held_out: bool
) -> tuple[float, float, float]:
    """Return the share of the work done after the direction of z, after the PSF, and after the background."""
    height, width = context.stack.shape[1:]
    part = math.prod(at.stop - at.start for at in crop) / (height * width)
    first, second = (part * steps for steps in estimated_steps(direction, refine))
    third = estimated_held_out_steps(context.stack.shape) if held_out else 0.0
    whole = first + second + third + _USUAL_STEPS
    return first / whole, (first + second) / whole, (first + second + third) / whole


def _estimate(name: str, value: float, error: float) -> str:
    """Return a value and its standard error in words."""
    if not math.isfinite(error):
        return "is not determined by it"
    factor, unit = {"depth": (1e6, " um"), "spherical": (1.0, " waves rms")}.get(name, (1.0, ""))
    return " +- ".join(with_error(factor * value, factor * error)) + unit


def _gain(camera: Noise, error: float) -> str:
    """Return a measured gain in words."""
    gain = 1.0 if camera.white is None else float(camera.white)
    return " +- ".join(with_error(gain, gain * error)) + " electrons per count"


def between(low: float, high: float) -> str:
    """Return a range of depths in one unit, in words."""
    return f"{format_length(low, like=high, digits=3).split()[0]} to {format_length(high, digits=3)}"


def _level(source: _Source) -> float:
    """Return the mean light of a stack, from which all chunks start."""
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


def _loaded(source: Stack, rows: slice, columns: slice) -> Values:
    """Return part of all planes in memory, read by one thread, as files must be."""
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
        Recording less model over the noise, summed over the square root of the number of voxels: of unit variance
        where PSF and noise are right.
    """

    recorded: tuple[Values, Values]
    restored: tuple[Values, Values]
    residual: tuple[Values, Values]


def blank(shape: tuple[int, int, int]) -> Projections:
    """Return projections of which nothing is known, NaN."""
    planes, height, width = shape
    recorded, restored, residual = (
        (np.full((height, width), np.nan, np.float32), np.full((planes, width), np.nan, np.float32)) for _ in range(3)
    )
    return Projections(recorded, restored, residual)


class Projecting:
    """Projections of a stack whose chunks are restored one after another."""

    def __init__(self, shape: tuple[int, int, int]) -> None:
        self._made, self._known = blank(shape), np.zeros((shape[0], shape[2]), np.float32)

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
        """Add a chunk: these rows and columns of the stack, of which those of a blur begin at the corner."""
        down, across = (at.start - first for at, first in zip((rows, columns), corner, strict=True))
        height, width = rows.stop - rows.start, columns.stop - columns.start
        sums, known, most = (np.zeros((height, width), np.float32) for _ in range(3))
        along = np.zeros((3, len(restored), width), np.float32)
        lock = Lock()

        def compared(plane: int, y: slice, x: slice, model: Values) -> None:
            counts, off, share = counted.residuals(plane, y, x, model)
            top, left = y.start - down, x.start - across
            inner = np.s_[max(-top, 0) : max(height - top, 0), max(-left, 0) : max(width - left, 0)]
            counts, off, share = counts[inner], off[inner], share[inner]
            at = np.s_[max(top, 0) : max(top, 0) + len(off), max(left, 0) : max(left, 0) + off.shape[1]]
            with lock:
                sums[at] += off
                known[at] += share
                np.maximum(most[at], counts, out=most[at])
                part = along[:, plane, at[1]]
                part[0] += off.sum(axis=0)
                part[1] += share.sum(axis=0)
                np.maximum(part[2], counts.max(axis=0, initial=0.0), out=part[2])

        blur.forward(light, compared)
        recorded, after, residual = self._made
        recorded[0][rows, columns] = np.where(known > 0.0, most, np.float32(np.nan))
        after[0][rows, columns] = restored.max(axis=0)
        residual[0][rows, columns] = _over_root(sums, known)
        # Chunks above and below have a part of each voxel of the projection along y.
        before = self._known[:, columns]
        off = along[0] + np.nan_to_num(residual[1][:, columns]) * np.sqrt(before)
        self._known[:, columns] = before + along[1]
        residual[1][:, columns] = _over_root(off, self._known[:, columns])
        highest = np.where(along[1] > 0.0, along[2], np.float32(np.nan))
        for whole, part in ((recorded, highest), (after, restored.max(axis=1))):
            whole[1][:, columns] = np.fmax(whole[1][:, columns], part)

    def made(self, *, turned: bool) -> Projections:
        """Return the projections, in the order of the recording if the planes were turned."""
        if not turned:
            return self._made
        return Projections(*((each[0], each[1][::-1]) for each in self._made))


def _over_root(sums: Values, known: Values) -> Values:
    """Return sums over the root of the number of voxels, NaN where there are none."""
    return np.where(known > 0.0, sums / np.sqrt(np.maximum(known, 1.0)), np.float32(np.nan))
