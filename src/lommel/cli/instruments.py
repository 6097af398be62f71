"""Lens or microscope of a command, its camera and noise: options that commands share, and what they state."""

from __future__ import annotations

import dataclasses
import math
import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

import numpy as np

from lommel.base import validation
from lommel.base.options import In, Options, Shown
from lommel.base.units import ARCSEC, camera_pixel, camera_wavelength, format_length
from lommel.cli.command import is_number, length
from lommel.cli.messages import flag_of
from lommel.io.photos import Exif, optics_of
from lommel.lensfiles.instrument import Camera, Instrument, tell_wavelength
from lommel.optics.lens import Lens
from lommel.recorded.noise import Noise
from lommel.report import Facts

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from lommel.base.arrays import Array, Values
    from lommel.lensfiles.microscope_files import Microscope
    from lommel.recorded.frames import Frames
    from lommel.recorded.headers import Metadata


def _camera(text: str) -> Camera:
    """Return the camera of a name, or of a file."""
    from lommel.lensfiles.camera_files import load_camera

    return load_camera(text)


def window(text: str) -> int | tuple[int, int]:
    """Return the side of a square in pixels, or height and width."""
    match = re.fullmatch(r"\s*(\d{1,9})(?:\s*[xX\s]\s*(\d{1,9}))?\s*", text, re.ASCII)
    if match is None:
        raise ValueError(f"{validation.shown(text)} is not a size; write 65 or 64x128 (height x width)")
    return int(match[1]) if match[2] is None else (int(match[1]), int(match[2]))


def sides(text: str) -> float | tuple[float, ...]:
    """Return a length, or (height, width), in metres."""
    found = tuple(length("um", side) for side in re.split(r"\s*[xX]\s*", text))
    return found if len(found) > 1 else found[0]


WINDOW = Shown(metavar="PIXELS", parse=window)
PLACE = Shown(("--at",), length="m", metavar="X Y")


@dataclass(frozen=True, kw_only=True)
class Sensor(Options):
    """Camera of a command.

    Parameters
    ----------
    camera
        Camera with the pixel pitch, and the noise where a command needs it: the name of an example, which `lommel
        examples --find camera` lists, or a file; overrides the file.
    pixel
        Pixel pitch on the camera, such as 6.5um; overrides the file and the camera.
    """

    heading: ClassVar[str] = "Camera"
    camera: Annotated[Camera | None, Shown(("--camera",), metavar="NAME|FILE", parse=_camera)] = None
    pixel: Annotated[float | None, Shown(length="um"), camera_pixel] = None

    def instrument(self, lens: Path, name: str) -> Instrument:
        """Return the instrument of a lens file for recorded images; ValueError, with `name`, for other light."""
        instrument = instrument_of(lens, camera=self.camera, pixel=self.pixel)
        camera_wavelength(f"{name}: wavelength", instrument.lens.wavelength)
        return instrument


@dataclass(frozen=True, kw_only=True)
class PhotoCamera(Sensor):
    """Lens and camera of a photograph, where no file states them.

    Parameters
    ----------
    focus_distance
        Focus distance, such as 1.5m or inf; overrides the lens file.
    f_number
        F-number; by default from the lens file or the EXIF.
    """

    focus_distance: Annotated[float | None, Shown(("--focus",), length="m")] = None
    f_number: float | None = None


@dataclass(frozen=True, kw_only=True)
class Optics(PhotoCamera):
    """Options for lens, object and sensor, which override the file.

    Parameters
    ----------
    object_distance
        Object distance, such as 1.5m or inf; overrides the file.
    focus_distance
        Focus distance, such as 1.5m or inf; overrides the file. An object that was in focus stays in focus.
    f_number
        F-number to which the lens is stopped, with the same sensor and aberrations; overrides the file.
    wavelength
        Wavelength, such as 450nm, with the path differences of the file; overrides the file.
    pixel
        Pixel pitch, such as 3.45um, or height x width: 4umx3um; overrides the file and the camera.
    shape
        Window in pixels, such as 65 or 64x128 (height x width); overrides the file.
    place
        Place on the sensor, from its middle right and down (in FITS pictures up), such as 1.5mm -2mm; needs a section
        [field]. By default the axis.
    """

    heading: ClassVar[str] = "Lens, object and sensor"
    object_distance: Annotated[float | None, Shown(length="m")] = None
    wavelength: Annotated[float | None, Shown(length="nm")] = None
    pixel: Annotated[Any, Shown(parse=sides, metavar="LENGTH"), camera_pixel] = None
    shape: Annotated[Any, WINDOW] = None
    place: Annotated[tuple[float, float] | None, PLACE] = None


@dataclass(frozen=True, kw_only=True)
class Planes(Options):
    """Options for the planes of a microscope, which override the file.

    Parameters
    ----------
    stack
        Number of planes along the optical axis; by default from the file.
    step
        Stage step between planes, such as 100nm; by default from the file.
    depth
        Depth of the emitter below the cover glass, such as 2um; by default from the file.
    """

    heading: ClassVar[str] = "Microscopes"
    stack: Annotated[int | None, In(least=1, most=4096), Shown(metavar="PLANES")] = None
    step: Annotated[float | None, Shown(length="nm")] = None
    depth: Annotated[float | None, Shown(length="um")] = None


def _camera_map(text: str, name: str) -> Array:
    """Return the map in the file that the option for the argument `name` states."""
    from lommel.recorded.frames import read_images

    flag, path = flag_of(name), Path(text)
    if not path.suffix:
        raise ValueError(f"{flag} must be a number or the file of a map (.tif, .npy), got {validation.shown(text)}")
    images = _noted(read_images([path]), flag)[...]
    if len(images) != 1:
        raise ValueError(f"{flag} must be one image, got {len(images)} in {validation.line(path)}")
    values = np.asarray(images[0], np.float64)
    if (invalid := ~np.isfinite(values)).any():
        place = ", ".join(map(str, np.argwhere(invalid)[0]))
        defect = "; mark a defective pixel by a read noise of 1000 electrons" if name == "read" else ""
        raise ValueError(f"{flag} must be finite, got {values[invalid][0]} at ({place}) of {path}{defect}")
    return values


def _noted(frames: Frames, flag: str) -> Frames:
    """Return images whose notes, such as on the choice of one of several, are told with the option of their file."""
    for note in frames.notes:
        validation.tell(f"{flag}: {note}")
    return frames


def mask_of(path: Path, images: Values) -> NDArray[np.bool_]:
    """Return a mask of the pixels to ignore, read from an image file."""
    from lommel.recorded.frames import read_images

    masks = _noted(read_images([path]), "--mask")[...]
    if masks.shape[1:] != images.shape[1:] or len(masks) not in (1, len(images)):
        raise ValueError(
            f"--mask must have the shape of the images, {images.shape[1]} x {images.shape[2]}, for all, or one "
            f"for each in one file of {len(images)}, got {len(masks)} of {masks.shape[1]} x {masks.shape[2]}"
        )
    mask = np.asarray(masks != 0)  # NaN, too
    if mask.all():
        raise ValueError(f"--mask must be 0 where pixels are to be used, got no 0 in {path}")
    return mask[0] if len(mask) == 1 else mask


_ROUNDED = 1.005  # lengths with three digits
_LENS_OPTIONS = {"f_number": Lens.stopped, "wavelength": Lens.in_light, "focus_distance": Lens.focused}


def instrument_of(path: Path, **options: object) -> Instrument:
    """Return the instrument of a lens file, changed by the options of a command."""
    from lommel.lensfiles.lens_files import load_instrument

    changes = _changes(options)
    if "pixel" in changes:
        for side in changes["pixel"] if isinstance(changes["pixel"], tuple) else [changes["pixel"]]:
            validation.pixel(side, metric=True)
        changes["pixel"] = validation.pitch("pixel", changes["pixel"])
    instrument = load_instrument(path)
    lens = instrument.lens
    stated = {name: changes.pop(name) for name in _LENS_OPTIONS if name in changes}
    if instrument.aberrations_of_field is not None and (forbidden := stated.keys() - {"focus_distance"}):
        flags = ", ".join(flag_of(name) for name in _LENS_OPTIONS if name in forbidden)
        raise ValueError(
            f"{flags} cannot be combined with the section [field] of {path}, which states waves over its own "
            "aperture: edit a copy"
        )
    if "wavelength" in stated:
        tell_wavelength(stated["wavelength"])
    for name, value in stated.items():
        lens = _LENS_OPTIONS[name](lens, value)
    if stated and math.isclose(instrument.object_distance, instrument.lens.focus_distance, rel_tol=1e-9):
        changes = {"object_distance": lens.focus_distance} | changes
    changed = dataclasses.replace(instrument, lens=lens, **changes)
    if changed.sensor is not None:
        height, width = changed.sensor
        if abs(changed.place[0]) > 0.5 * width * _ROUNDED or abs(changed.place[1]) > 0.5 * height * _ROUNDED:
            sides = f"{format_length(height)} x {format_length(width)} (height x width)"
            validation.tell(f"--at is {changed.place_in_words}, beyond the sensor of {sides}")
    return changed


def radial_instrument(lens: Path, **options: object) -> Instrument:
    """Return the instrument of a lens file; ValueError if its aberrations vary over the field."""
    instrument = instrument_of(lens, **options)
    if instrument.aberrations_of_field is not None:
        raise ValueError(f"{lens} has aberrations that vary over the field, which this command does not support")
    return instrument


def _changes(options: Facts) -> Facts:
    """Return the options that were given; ValueError if the window is out of range."""
    changes = {name: value for name, value in options.items() if value is not None}
    if "camera" in changes:
        changes = {"pixel": changes["camera"].pixel} | changes
    return changes | ({"shape": validation.image_shape(changes["shape"])} if "shape" in changes else {})


_LENS_ONLY = "object_distance", "focus_distance", "f_number", "field", "mtf", "colour", "seeing", "jitter", "place"


def microscope_of(lens: Path, **options: object) -> Microscope | None:
    """Return the microscope of a file, changed by the options of a command, or None for a lens file."""
    from lommel.lensfiles.microscope_files import describes_microscope, load_microscope

    changes = _changes(options)
    if not describes_microscope(lens):
        for name in ("stack", "step", "depth"):
            if name in changes:
                raise ValueError(f"--{name} is for microscopes, files with a section [objective]; {lens} has none")
        return None
    for name in _LENS_ONLY:
        if name in changes:
            raise ValueError(f"{flag_of(name)} is for lenses, and {lens} describes a microscope")
    microscope = load_microscope(lens)
    if isinstance(changes.get("pixel"), tuple):
        changes["pixel"] = changes["camera"].side  # raises ValueError: the pixels of the camera are not square
    if "pixel" in changes:
        validation.pixel(changes["pixel"], metric=True)
    if "stack" in changes:
        changes["planes"] = changes.pop("stack")
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


def states_noise(options: Facts, camera: Camera | None) -> bool:
    """Return False if neither the options nor the camera of a command state any noise of photographs or video."""
    stated = (*(options[name] for name in _QUANTITIES), *((camera.full_well, camera.read) if camera else ()))
    return bool(options["offset"]) or any(value is not None for value in stated)


_TOLERANCE = 0.02  # relative difference up to which values count as equal
_COARSE = 0.1  # the same of the subject distance of EXIF, in steps of the motor of a lens
_NOMINAL = 0.05  # the same of nominal values: f-numbers, plate scales and the data of EXIF


def optics_notes(source: str, stated: Facts, pixel: float | None, lens: Lens | None = None) -> list[str]:
    """Return a note on each number of the optics that a file states and that differs from the number in use."""
    from lommel.recorded.headers import OPTICS

    in_use: dict[str, float | None] = {"sensor_pixel": pixel}
    if lens is not None:
        in_use |= {"focal_length": lens.focal_length, "f_number": lens.f_number, "aperture": lens.aperture_diameter}
        in_use |= {"wavelength": lens.wavelength, "focus": lens.focus_distance, "zoom": 1.0}
        in_use |= {"plane_pixel": pixel, "scale": pixel and pixel / lens.focal_length}
    notes = []
    for key, used in in_use.items():
        values = stated.get(key) or ()
        is_exact = stated.get("format") == "FITS" and key in ("sensor_pixel", "focal_length", "plane_pixel")
        for value in values if isinstance(values, tuple) else (values,):
            rounding = 0.5e-3 if key == "focal_length" and math.isclose(1e3 * value, round(1e3 * value)) else 0.0
            limit = _COARSE if key == "focus" else _TOLERANCE if is_exact else _NOMINAL
            if used is None or value == used or abs(value - used) <= max(limit * used, rounding) < math.inf:
                continue
            unit = {"f_number": 1.0, "zoom": 1.0, "scale": ARCSEC}.get(key)
            texts = [format_length(v, digits=4) if unit is None else f"{v / unit:.3g}" for v in (value, used)]
            if key == "sensor_pixel" and used > value and not is_exact:
                texts[1] += f", right if the picture was reduced by {used / value:.3g},"
            notes.append(f"{source} states {OPTICS[key].format(texts[0])}; {texts[1]} was used.")
    return list(dict.fromkeys(notes))


def tell_optics(name: object, exif: Exif, pixel: float, lens: Lens) -> None:
    """Issue a note on each number in the EXIF of a photograph that contradicts the pixel or the lens in use."""
    for note in optics_notes(f"The EXIF of {validation.line(name)}", optics_of(exif), pixel, lens):
        validation.tell(note)


_UNITS = {
    "white": ("gain", " electrons per count", 1.0),
    "offset": ("offset", " counts", 0.0),
    "read": ("read noise", " electrons rms", 0.0),
    "excess": ("excess noise", "", 1.0),
}


@dataclass(frozen=True, kw_only=True)
class CameraNoise(Sensor):
    """Options for the camera, its noise, and the pixels to ignore.

    Parameters
    ----------
    white
        Electrons per count; by default from the camera, or 1.
    read
        Read noise, rms electrons; 0 for none; by default from the camera.
    offset
        Black level, in the unit of the images; by default from the camera, or 0.
    saturation
        Value in the file at which pixels saturate, such as 60000; the largest integer always counts as saturated.
    mask
        Image that is not 0 at pixels to ignore, for all images; or a stack (NPY, TIFF) of one for each.
    """

    heading: ClassVar[str] = "Camera and noise"
    white: Annotated[float | None, Shown(("--gain",))] = None
    read: float | None = None
    offset: float | None = None
    saturation: float | None = None
    mask: Annotated[Path | None, Shown(metavar="FILE")] = None

    def __post_init__(self) -> None:
        super().__post_init__()
        values = {name: value for name, value in self.values().items() if isinstance(value, float)}
        Noise(**{"read": 0.0} | values)  # raises ValueError for a value out of range, before files are read

    def values(self) -> Facts:
        """Return gain, read noise and offset, None without an option."""
        return {name: getattr(self, name) for name in ("white", "read", "offset")} | {"excess": None}

    def resolve(
        self, header: Metadata, camera: Camera | None, pixel: float | None = None, lens: Lens | None = None
    ) -> tuple[Noise, float | None, list[str]]:
        """Return (1) noise, (2) saturation, (3) notes; options override the camera, and the camera the header.

        Notes state an assumed gain, and the optics in the header that differ from the pixel (metres) and the lens.
        """
        from lommel.recorded.headers import assumed_gain, take_header

        options = self.values() | {"saturation": self.saturation}
        notes = take_header(options, header, camera_facts(camera))
        if options["white"] is None and (camera is None or camera.gain is None):
            notes.append(assumed_gain(header, flag_of("white")))
        notes += optics_notes("The header of the images", header, pixel, lens)
        noise = noise_of(options, camera)
        # The files of such cameras do not state whether the electron multiplication was on.
        if camera is not None and "EMCCD" in camera.name and noise.excess == 1.0:
            notes.append(
                f"{camera.name}: if its electron multiplication was on, copy its file, state excess = 2 and gain and "
                "read noise divided by the EM gain there, and give it by --camera."
            )
        return noise, options["saturation"], notes

    def recorded(self, lens: Path, camera: Camera | None, noise: Noise) -> tuple[Facts, str]:
        """Return gain, offset, read noise and excess of a fit with their sources, (1) as facts, (2) as text."""
        options, camera_values, name = self.values(), camera_facts(camera), camera and camera.name
        sources = {
            "option": "by the option",
            "camera": f"of {name}, {f'in {lens.name}' if self.camera is None else 'by --camera'}",
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

    def mask_of(self, images: Any) -> Any:
        """Return a mask of the pixels of images to ignore, or None."""
        return None if self.mask is None else mask_of(self.mask, images)


@dataclass(frozen=True, kw_only=True)
class PhotoNoise(Options):
    """Options for the noise of photographs.

    Parameters
    ----------
    white
        Number of electrons at white, such as 5000; by default the full well of the camera. White is the largest
        integer, or 1.0 in floats.
    read
        Read noise, rms electrons; 0 for none; by default from the camera.
    offset
        Black level, as a fraction of white.
    """

    heading: ClassVar[str] = "Noise"
    white: float | None = None
    read: float | None = None
    offset: float = 0.0


@dataclass(frozen=True, kw_only=True)
class MaskedPhotoNoise(PhotoNoise):
    """Options for the noise of photographs, and pixels to ignore.

    Parameters
    ----------
    mask
        Image whose nonzero pixels mark the pixels of the photo to ignore.
    """

    mask: Annotated[Path | None, Shown(metavar="FILE")] = None


@dataclass(frozen=True, kw_only=True)
class FrameNoise(PhotoNoise):
    """Options for the noise and the saturation of frames of video.

    Parameters
    ----------
    saturation
        Level at which pixels saturate: a fraction of white in linear light (after decoding sRGB), such as 0.95; the
        largest integer always counts as saturated.
    """

    saturation: float | None = None


_MAP = Shown(metavar="NUMBER|FILE", parse=lambda text: float(text) if is_number(text) else text)


@dataclass(frozen=True, kw_only=True)
class CameraMaps(CameraNoise):
    """Options for the camera, whose gain, read noise and offset may be maps in files.

    Parameters
    ----------
    white
        Electrons per count; by default from the camera, or 1. A file (.tif, .npy) is a map with a value for each
        pixel, also of --read and --offset.
    read
        Read noise, rms electrons; 0 for none; by default from the camera.
    offset
        Counts of a pixel without electrons, such as 100; by default from the camera, or 0.
    """

    heading: ClassVar[str] = "Camera"
    white: Annotated[Any, _MAP._replace(flags=("--gain",))] = None
    read: Annotated[Any, _MAP] = None
    offset: Annotated[Any, _MAP] = None

    def values(self) -> Facts:
        """Return gain, read noise and offset, None without an option; maps are read."""
        values = super().values()
        return {name: _camera_map(v, name) if isinstance(v, str) else v for name, v in values.items()}
