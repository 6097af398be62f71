"""Voxel sizes, wavelengths and PSF models of a stack, from arguments, the file of the stack and the microscope."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple, Protocol

from lommel.base import validation
from lommel.base.units import format_length
from lommel.base.validation import line, shown
from lommel.fit.findings import Finding
from lommel.measures.measured_psf import MeasuredPSF
from lommel.microscopy.depth_model import DepthModel, GivenPSF, usual_window
from lommel.optics.layers.emitter import Emitter, emitter_of
from lommel.optics.layers.modality import Modality
from lommel.optics.layers.objective import FocalSurface, Objective
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF
from lommel.recorded.frames import Frames
from lommel.recorded.headers import microscope_facts, size_findings, size_notes

_TOLERANCE = 0.02  # relative difference between values of the file and of the objective above which a note is added
_EMISSION = 0.05  # relative difference of the emission from that of the file above which the result is in doubt
_FINEST = 5e-9  # finest pixel in the sample times NA, metres: a twentieth of Nyquist sampling at 400 nm
_LEAST_PLANES = 3  # a single plane has no depth to restore


class MicroscopeData(Protocol):
    """Result of :func:`lommel.load_microscope`: an objective and its recording parameters (lengths in metres)."""

    objective: Objective
    wavelength: float
    depth: float
    pixel: float
    step: float
    emitter: Emitter
    aberrations: Wavefront | None
    modality: Modality
    focal_surface: FocalSurface | None


class Stated(NamedTuple):
    """What the arguments state, metres: see :class:`lommel.microscopy.DeconvolveOptions`."""

    depth: float | None
    wavelength: tuple[float, ...] | None
    pixel: float | None
    step: float | None


class Sampled(NamedTuple):
    """A recording with the voxel sizes and wavelengths that are used, and the PSF model of each channel."""

    recording: Frames
    models: list[DepthModel | GivenPSF]
    pixel_doubt: str  # note on a pixel of the stack that contradicts the file of the objective
    findings: list[Finding]  # on arguments that contradict the file of the stack


def sampled(
    recording: Frames,
    microscope: Any,
    stated: Stated,
    window: tuple[int, int] | None,
    notes: list[str],
) -> Sampled:
    """Return a recording with all that its file does not state; each assumption is added to the notes.

    `microscope` is an Objective, a Microscope, or the PSF of each channel; `window` are planes and pixels of PSFs.
    """
    psfs = microscope if isinstance(microscope, list | tuple) else [microscope]
    if psfs and all(isinstance(one, PSF | MeasuredPSF) and type(one) is type(psfs[0]) for one in psfs):
        return _with_psfs(recording, psfs, stated, notes)
    lens, device = _objective(microscope)
    _, planes, height, width = recording.shape
    if planes < _LEAST_PLANES:
        raise ValueError(
            f"stack must have 3 planes or more, got {planes}; for single images use lommel.imaging.restore"
        )
    words = recording.metadata["unusable"]
    places = {"pixel": ("in the sample", "on the camera"), "step": ("between planes", "of the stage")}
    if missing := [name for name in places if name in words and getattr(stated, name) is None]:
        stated_sizes = " and ".join(f"{words[name]} {places[name][0]}" for name in missing)
        names = " and ".join(f"{name}= ({places[name][1]})" for name in missing)
        raise ValueError(f"{_source(recording)} states {stated_sizes}, which cannot be used: give {names}, in metres")
    first_note = len(notes)
    pixel = _pixel(recording, lens, device, stated.pixel, notes)
    doubt = notes[-1] if len(notes) > first_note and "objective file states" in notes[-1] else ""
    of_device = None if device is None else abs(device.step) or None
    step = _length("step", recording, stated.step, recording.metadata["step"], of_device, notes)
    if not 0.0 < step < 1e-4:
        raise ValueError(f"step must be a stage displacement, above 0 and below 1e-4 metres, got {step:g}")
    kind = "widefield" if device is None else device.modality.kind
    notes += size_notes(recording.metadata, **microscope_facts(lens, None, kind)).values()
    waves = _wavelengths(recording, device, stated.wavelength, notes)
    findings = size_findings(
        recording.metadata, pixel=None if stated.pixel is None else pixel / lens.magnification, step=stated.step
    )
    for wave, of_file, name in zip(waves, recording.metadata["emission"], recording.metadata["names"], strict=True):
        of = f" of {name}" if len(waves) > 1 else ""
        findings += size_findings(
            {"emission": of_file}, of, most=_EMISSION, emission=wave if stated.wavelength else None
        )
    depth = stated.depth
    if depth is None:
        depth = planes // 2 * step if device is None else device.depth
    validation.real("depth", depth, least=0.0, most=1e-2, unit="metres")
    modality = Modality() if device is None else device.modality
    models: list[DepthModel | GivenPSF] = []
    for wave, laser in zip(waves, recording.metadata["excitation"], strict=True):
        excitation = modality.excitation or laser
        if modality.kind in ("confocal", "spinning disc", "two-photon") and excitation is None:
            raise ValueError(
                f"excitation must be given for a {modality.kind!r} microscope: its vacuum wavelength in metres"
            )
        models.append(
            DepthModel(
                lens,
                wave,
                pixel,
                step,
                depth,
                planes,
                window or usual_window(lens, wave, pixel, step, (planes, height, width)),
                replace(modality, excitation=excitation),
                emitter_of("isotropic") if device is None else device.emitter,
                None if device is None else device.aberrations,
            )
        )
    if stated.depth is None and device is None:
        notes.append(
            f"The middle plane was assumed to be focused at a depth of {format_length(depth, digits=3)}, as if the "
            "stack began at the cover glass; set depth= if not."
        )
    if device is not None and device.focal_surface is not None:
        notes.append("The focal surface of the microscope was not used: z counts from it, over the field.")
    sizes = {"pixel": pixel / lens.magnification, "step": step, "emission": tuple(waves)}
    used = replace(recording, metadata=recording.metadata | sizes)
    return Sampled(used, models, doubt, findings)


def _source(recording: Frames) -> str:
    return "an array" if recording.path is None else line(recording.path)


def require_of_psf(stated: Stated, *, measured: bool) -> None:
    """Raise ValueError for what must not be stated beside a PSF; the voxels of a `measured` one may be."""
    reasons = {"depth": "is the same at all depths", "wavelength": "has its own light"}
    for name, value in stated._asdict().items():
        if value is not None and not (measured and name in ("pixel", "step")):
            why = reasons.get(name, "has the sampling of the stack")
            raise ValueError(f"{name} must not be given with a PSF, which {why}")


def _with_psfs(recording: Frames, psfs: Sequence[PSF | MeasuredPSF], stated: Stated, notes: list[str]) -> Sampled:
    """Return a recording with the voxels of the PSFs of its channels; measured PSFs are resampled to its own."""
    measured = [psf for psf in psfs if isinstance(psf, MeasuredPSF)]
    require_of_psf(stated, measured=bool(measured))
    if len(psfs) != recording.shape[0]:
        names = ", ".join(recording.metadata["names"])
        raise ValueError(f"microscope must have one PSF for each channel of the stack, {names}, got {len(psfs)}")
    if measured:
        if min(len(psf.values) for psf in measured) == 1:
            raise ValueError("microscope must be the PSF of a stack, got that of a photograph, which has one plane")
        pixel, step = _measured_voxel(recording, measured[0], stated, notes)
        psfs = [psf.resampled(pixel, step) for psf in measured]
    models = [GivenPSF(psf, recording.shape[1]) for psf in psfs]
    waves = [model.wavelength or wave for model, wave in zip(models, recording.metadata["emission"], strict=True)]
    sizes = {"pixel": models[0].pixel, "step": models[0].step, "emission": tuple(waves)}
    findings = size_findings(recording.metadata, pixel=models[0].pixel, step=models[0].step)
    return Sampled(replace(recording, metadata=recording.metadata | sizes), list(models), "", findings)


def _measured_voxel(recording: Frames, psf: MeasuredPSF, stated: Stated, notes: list[str]) -> tuple[float, float]:
    """Return the pixel in the sample and the step of a stack: stated, of its file, or those of its PSF."""
    if stated.pixel is not None and psf.magnification is None:
        raise ValueError("pixel needs the magnification: give microscope= to lm.PSF.measured")
    in_sample = None if stated.pixel is None else stated.pixel / (psf.magnification or 1.0)
    found = []
    for name, value, of_psf in (("pixel", in_sample, psf.pixel), ("step", stated.step, psf.step)):
        if value is None and (value := recording.metadata[name]) is None:
            value = of_psf
            notes.append(f"The stack does not state its {name}: that of the PSF was used, {format_length(value)}.")
        found.append(value)
    return found[0], found[1]


def _objective(argument: Any) -> tuple[Objective, MicroscopeData | None]:
    """Return the objective, and the microscope, None for an Objective."""
    if isinstance(argument, Objective):
        return argument, None
    if isinstance(getattr(argument, "objective", None), Objective):
        return argument.objective, argument
    raise TypeError(
        "microscope must be an Objective, a Microscope from lommel.load_microscope, or the PSF of the stack, got "
        f"{shown(argument)}"
    )


def _pixel(
    recording: Frames, lens: Objective, device: MicroscopeData | None, argument: float | None, notes: list[str]
) -> float:
    """Return the pixel pitch on the camera, metres."""
    of_file = recording.metadata["pixel"]
    of_file = None if of_file is None else of_file * lens.magnification
    pixel = _length("pixel", recording, argument, of_file, None if device is None else device.pixel, notes)
    if argument is None:
        return pixel
    validation.pixel(pixel, metric=True)
    if pixel < _FINEST / lens.NA * lens.magnification:
        # The usual cause is a pixel size in the sample, instead of the pitch on the camera.
        value, camera, in_sample = map(format_length, (pixel, pixel * lens.magnification, pixel / lens.magnification))
        raise ValueError(
            f"pixel must be the pitch on the camera, got {value}, which is {in_sample} in the sample; for {value} in "
            f"the sample give pixel={camera}"
        )
    return pixel


def _length(
    name: str,
    recording: Frames,
    argument: float | None,
    of_file: float | None,
    of_microscope: float | None,
    notes: list[str],
) -> float:
    """Return the length in the argument, else in the file, else of the microscope; note what was assumed."""
    if argument is not None:
        return argument
    if of_file is not None:
        if of_microscope is not None and abs(of_microscope - of_file) > _TOLERANCE * of_file:
            text = f"The {name} of the stack, {format_length(of_file)}, was used; the objective file states "
            notes.append(f"{text}{format_length(of_microscope)}.")
        return of_file
    if of_microscope is None:
        raise ValueError(
            f"{_source(recording)} states no voxel size: give pixel= (on the camera) and step= (of the stage), in "
            "metres"
        )
    place = "on the camera" if name == "pixel" else "of the stage"
    notes.append(
        f"The stack does not state its {name}: the value of the objective file was used, "
        f"{format_length(of_microscope)} {place}; set {name}= if it differs."
    )
    return of_microscope


def _wavelengths(
    recording: Frames, device: MicroscopeData | None, stated: tuple[float, ...] | None, notes: list[str]
) -> list[float]:
    """Return the emission wavelength of each channel, from the argument, else the file, else the microscope."""
    count = recording.shape[0]
    if stated is not None:
        if len(stated) not in (1, count):
            raise ValueError(f"wavelength must be one, or one for each of {count} channels, got {len(stated)}")
        return list(stated) * (count if len(stated) == 1 else 1)
    waves = []
    for number, (name, wave) in enumerate(
        zip(recording.metadata["names"], recording.metadata["emission"], strict=True)
    ):
        if wave is None:
            if text := recording.metadata["unusable"].get(f"emission {number}"):
                raise ValueError(
                    f"the stack states that the emission wavelength of {name!r} is {text}, which cannot be used: "
                    "give wavelength=, in metres, such as 520e-9"
                )
            if device is None or count > 1:
                raise ValueError(
                    f"the stack does not state the emission wavelength of {name!r}: give wavelength=, in metres, "
                    "such as 520e-9"
                )
            wave = device.wavelength
            notes.append(f"The wavelength of the objective file, {format_length(wave)}, was used.")
        elif count == 1 and device is not None and abs(wave - device.wavelength) > _TOLERANCE * wave:
            notes.append(
                f"The emission wavelength of the stack, {format_length(wave)}, was used; the objective file "
                f"states {format_length(device.wavelength)}; set wavelength= if it differs."
            )
        waves.append(validation.wavelength(float(wave)))
    return waves
