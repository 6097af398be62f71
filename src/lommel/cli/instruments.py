"""Lens or microscope of a command: the file, the options that override it, and the camera with its noise."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.base import validation
from lommel.base.units import format_length
from lommel.cli.messages import flag_of
from lommel.recorded.noise import Noise
from lommel.report import Facts

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from lommel.base.arrays import Array, Values
    from lommel.lensfiles.instrument import Camera, Instrument
    from lommel.lensfiles.microscope_files import Microscope
    from lommel.recorded.frames import Metadata


def camera_map(text: str, name: str) -> float | Array:
    """Return the number in the option for the argument `name`, or the map in the file that the option names."""
    from lommel.recorded.frames import read_images

    flag = flag_of(name)
    try:
        return float(text)
    except ValueError:
        path = Path(text)
    if not path.suffix:
        raise ValueError(f"{flag} must be a number or the file of a map (.tif, .npy), got {validation.shown(text)}")
    images = read_images([path])[...]
    if len(images) != 1:
        raise ValueError(f"{flag} must be one image, got {len(images)} in {validation.line(path)}")
    values = np.asarray(images[0], np.float64)
    if (invalid := ~np.isfinite(values)).any():
        place = ", ".join(map(str, np.argwhere(invalid)[0]))
        defect = "; mark a defective pixel by a read noise of 1000 electrons" if name == "read" else ""
        raise ValueError(f"{flag} must be finite, got {values[invalid][0]} at ({place}) of {path}{defect}")
    return values


def mask_of(path: Path, images: Values) -> NDArray[np.bool_]:
    """Return a mask of the pixels to ignore, read from an image file."""
    from lommel.recorded.frames import read_images

    masks = read_images([path])[...]
    if masks.shape[1:] != images.shape[1:] or len(masks) not in (1, len(images)):
        raise ValueError(
            f"--mask must have the shape of the images, {images.shape[1]} x {images.shape[2]}, one or {len(images)}, "
            f"got {len(masks)} of {masks.shape[1]} x {masks.shape[2]}"
        )
    mask = np.asarray(masks != 0)  # NaN, too
    if mask.all():
        raise ValueError(f"--mask must be 0 where pixels are to be used, got no 0 in {path}")
    return mask[0] if len(mask) == 1 else mask


def instrument_of(lens: Path, **options: object) -> Instrument:
    """Return the instrument of a lens file, changed by the options of a command."""
    from lommel.lensfiles.lens_files import load_instrument

    changes = _changes(options)
    if "pixel" in changes:
        for side in changes["pixel"] if isinstance(changes["pixel"], tuple) else [changes["pixel"]]:
            validation.pixel(side, metric=True)
        changes["pixel"] = validation.pitch("pixel", changes["pixel"])
    lens_values = {name: changes.pop(name) for name in _LENS_OPTIONS if name in changes}
    base = load_instrument(lens)
    return dataclasses.replace(_with_lens_options(base, lens_values, lens) if lens_values else base, **changes)


_LENS_OPTIONS = "f_number", "wavelength", "focus_distance"


def _with_lens_options(instrument: Instrument, stated: Facts, path: Path) -> Instrument:
    """Return an instrument whose lens has the f-number, wavelength and focus that options state."""
    if instrument.aberrations_of_field is not None and (forbidden := stated.keys() - {"focus_distance"}):
        flags = ", ".join(flag_of(name) for name in _LENS_OPTIONS if name in forbidden)
        raise ValueError(
            f"{flags} cannot be combined with the section [field] of {path}, which states waves over its own "
            "aperture: edit a copy"
        )
    lens, focus = instrument.lens, instrument.lens.focus_distance
    in_focus = math.isclose(instrument.object_distance, focus, rel_tol=1e-9)
    if "f_number" in stated:
        lens = lens.stopped(stated["f_number"])
    if "wavelength" in stated:
        lens = lens.in_light(stated["wavelength"])
    if "focus_distance" in stated:
        lens = lens.focused(stated["focus_distance"])
    return dataclasses.replace(
        instrument, lens=lens, object_distance=lens.focus_distance if in_focus else instrument.object_distance
    )


def radial_instrument(lens: Path, user: str = "this command", **options: object) -> Instrument:
    """Return the instrument of a lens file; ValueError if its aberrations vary over the field."""
    instrument = instrument_of(lens, **options)
    if instrument.aberrations_of_field is not None:
        raise ValueError(f"{lens} has aberrations that vary over the field, which {user} does not support")
    return instrument


def _changes(options: Facts) -> Facts:
    """Return the options that were given; ValueError if the window is out of range."""
    changes = {name: value for name, value in options.items() if value is not None}
    if "camera" in changes:
        changes = {"pixel": changes["camera"].pixel} | changes
    return changes | ({"shape": validation.image_shape(changes["shape"])} if "shape" in changes else {})


_LENS_ONLY_OPTIONS = {
    "object_distance": "--depth sets the position of the emitter",
    "focus_distance": "--depth sets the position of the emitter",
    "f_number": "its aperture is the NA of the file",
    "field": "its PSF is the on-axis PSF",
    "mtf": "use PSF.mtf in Python for the MTF of a stack",
    "colour": "its emitter has one wavelength; use lommel.colour_psf with its pupil",
    "seeing": "there is no atmosphere before it",
    "jitter": "blur its images by lommel.Jitter in Python",
    "at": "its PSF is the on-axis PSF",
}


def microscope_of(lens: Path, **options: object) -> Microscope | None:
    """Return the microscope of a file, changed by the options of a command, or None for a lens file."""
    from lommel.lensfiles.microscope_files import describes_microscope, load_microscope, stage_step

    changes = _changes(options)
    if not describes_microscope(lens):
        for name in ("stack", "step", "depth"):
            if name in changes:
                raise ValueError(f"--{name} is for microscopes, files with a section [objective]; {lens} has none")
        return None
    for name, advice in _LENS_ONLY_OPTIONS.items():
        if name in changes:
            raise ValueError(f"{flag_of(name)} is for lenses, and {lens} describes a microscope: {advice}")
    microscope = load_microscope(lens)
    if isinstance(changes.get("pixel"), tuple):
        changes["pixel"] = changes["camera"].side  # raises ValueError: the pixels of the camera are not square
    if "pixel" in changes:
        validation.pixel(changes["pixel"], metric=True)
    if "stack" in changes:
        changes["planes"] = changes.pop("stack")
    if "step" in changes:
        stage_step(changes["step"])
    planes = changes.get("planes", microscope.planes)
    if planes > 1 and not changes.get("step", microscope.step):
        limit = format_length(microscope.objective.nyquist(wavelength=microscope.wavelength).axial, digits=3)
        raise ValueError(f"--stack needs --step, if the file has no stack; Nyquist sampling needs at most {limit}")
    if "step" in changes and planes == 1:
        raise ValueError("--step needs --stack, if the file has no stack")
    return dataclasses.replace(microscope, **changes)


def require_microscope(name: str, lens: Path, **options: object) -> Microscope:
    """Return the microscope of a file, changed by options; ValueError, which names the command, for other files."""
    microscope = microscope_of(lens, **options)
    if microscope is None:
        raise ValueError(f"lommel {name} needs a microscope, a file with a section [objective]; {lens} has none")
    return microscope


def require_order(order: str, images: Path, lens: Path) -> None:
    """Raise ValueError if a lens file is in the place of the images."""
    if images.suffix.lower() == ".toml" != lens.suffix.lower():
        line = validation.line
        raise ValueError(f"the order is {order}, got {line(images)} and then {line(lens)}")


_QUANTITIES = {"white": "the number of electrons at white", "read": "the read noise in electrons rms"}


def camera_facts(camera: Camera | None) -> Facts:
    """Return the noise parameters of a camera, None where it does not state one; {} without a camera."""
    if camera is None:
        return {}
    excess = camera.excess if camera.excess > 1.0 else None
    return {"white": camera.gain, "read": camera.read, "offset": camera.offset, "excess": excess}


def noise_of(options: Facts, camera: Camera | None, *, photographs: bool = False) -> Noise:
    """Return the noise that the options of a command state, completed by the values of the camera.

    Images are in counts. With `photographs` the value 1 is white, and the offset of the camera does not apply.
    """
    camera_values, values = camera_facts(camera), {}
    if photographs:
        camera_values |= {"white": camera and camera.full_well, "offset": None}
    for name in ("white", "read", "offset", "excess"):
        value = options.get(name)
        values[name] = camera_values.get(name) if value is None else value
        if values[name] is None and (name == "read" or (photographs and name == "white")):
            source = "or a camera that states it, by --camera"
            if camera is not None:
                source = f"which {camera.name} does not state"
            raise ValueError(f"--{name} is missing: {_QUANTITIES[name]}, {source}")
    return Noise(**{name: value for name, value in values.items() if value is not None})


_HEADER_VALUES = {
    "white": ("gain", "a gain of {:g} electrons per count"),
    "read": ("read", "a read noise of {:g} electrons"),
    "saturation": ("saturation", "saturation at {:g}"),
    "excess": ("excess", "an electron-multiplying camera, excess noise {:g}"),
}
_EXCESS_NOTE = "; gain and read noise must refer to electrons before multiplication, divided by the EM gain"
_TOLERANCE = 0.02  # relative difference up to which values count as equal


def take_header(options: Facts, header: Metadata, camera: Camera | None = None) -> list[str]:
    """Complete gain, read noise, saturation and excess in `options` by the header of images; return notes.

    Options have priority over the camera, and the camera over the header. Notes state header values that differ.
    """
    from lommel.recorded.frames import Unusable

    camera_values, notes = camera_facts(camera), []
    for name, (key, phrase) in _HEADER_VALUES.items():
        value = header.get(key)
        if isinstance(value, Unusable):
            if key != "saturation" and options.get(name) is None and camera_values.get(name) is None:
                raise ValueError(f"the header of the images states {key} {value.words}: state {name}=")
            notes.append(f"The header of the images states {key} {value.words}, which cannot be used.")
        if not isinstance(value, float):
            continue
        used_value = camera_values.get(name) if options.get(name) is None else options[name]
        if used_value is None:
            options[name] = value
            addition = _EXCESS_NOTE if name == "excess" else ""
            notes.append(f"Taken from the header of the images: {phrase.format(value)}{addition}.")
        elif isinstance(used_value, float | int) and abs(used_value - value) > _TOLERANCE * abs(value):
            notes.append(f"The header of the images states {phrase.format(value)}; {used_value:g} was used.")
    if "unsure" in header and options["white"] is None and camera_values.get("white") is None:
        notes.append(
            f"The header of the images states {header['unsure']}, which was not used: it may be electrons per count, "
            "or a setting of the camera; set the gain by its option."
        )
    return notes


def header_differences(header: Metadata, microscope: Microscope, step: float | None = None) -> dict[str, str]:
    """Return a note on each header value of images (pixel, emission, `step`) that differs from the value in use."""
    from lommel.recorded.frames import Unusable

    pixel, emission = header.get("pixel"), next(iter(header.get("emission") or ()), None)
    comparisons = {
        "pixel": ("pixels of {} in the sample", pixel, microscope.pixel / microscope.objective.magnification),
        "emission": ("an emission of {}", emission, microscope.wavelength),
        "step": ("planes {} apart", header.get("step"), step),
    }
    notes = dict[str, str]()
    for name, (phrase, value, in_use) in comparisons.items():
        if in_use is None or not isinstance(value, float | Unusable):
            continue
        text = value.words if isinstance(value, Unusable) else format_length(value, digits=4)
        if isinstance(value, Unusable) or abs(value - abs(in_use)) > _TOLERANCE * abs(in_use):
            notes[name] = f"The images state {phrase.format(text)}, but {format_length(in_use, digits=4)} was used."
    return notes


_UNITS = {
    "white": ("gain", " electrons per count", 1.0),
    "offset": ("offset", " counts", 0.0),
    "read": ("read noise", " electrons rms", 0.0),
    "excess": ("excess noise", "", 1.0),
}


def recorded_noise(
    options: Facts, by_file: bool, lens: Path, camera: Camera | None, noise: Noise
) -> tuple[Facts, str]:
    """Return gain, offset, read noise and excess of a fit with their sources, (1) as facts, (2) as text.

    `by_file` is True if the camera is that of the lens file.
    """
    camera_values, name = camera_facts(camera), camera and camera.name
    sources = {
        "option": "by the option",
        "camera": f"of {name}, {f'in {lens.name}' if by_file else 'by --camera'}",
        "header": "of the header of the images",
        "default": "the default, as neither an option nor a camera states it",
    }
    facts: Facts = {"camera": name}
    texts = []
    for key, (quantity, unit, default) in _UNITS.items():
        value: Any = getattr(noise, key)
        by_map, value = isinstance(value, np.ndarray), default if value is None else value
        source = "camera" if camera_values.get(key) is not None else "header"
        if options[key] is not None:
            source = "option"
        elif source == "header" and key != "read" and not by_map and value == default:
            source = "default"
        facts[quantity.replace(" ", "_")] = {"value": "a map" if by_map else value, "source": source}
        if key != "excess" or value != 1.0:
            texts.append(f"{quantity} {'by a map' if by_map else f'{value:g}{unit}'} ({sources[source]})")
    return facts, ", ".join(texts)
