"""Options that commands share: lens and object, planes of a microscope, and the camera with its noise."""

from __future__ import annotations

import dataclasses
import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from lommel.base.options import In, Options, Shown
from lommel.base.validation import shown
from lommel.cli.command import length
from lommel.cli.instruments import (
    camera_map,
    instrument_of,
    mask_of,
    noise_of,
    recorded_noise,
    take_header,
)
from lommel.lensfiles.instrument import Camera, Instrument
from lommel.recorded.noise import Noise
from lommel.report import Facts

if TYPE_CHECKING:
    from lommel.recorded.frames import Metadata


def _camera(text: str) -> Camera:
    """Return the camera of a name, or of a file."""
    from lommel.lensfiles.camera_files import load_camera

    return load_camera(text)


def window(text: str) -> int | tuple[int, int]:
    """Return the side of a square in pixels, or height and width."""
    match = re.fullmatch(r"\s*(\d{1,9})(?:\s*[xX\s]\s*(\d{1,9}))?\s*", text, re.ASCII)
    if match is None:
        raise ValueError(f"{shown(text)} is not a size; write 65 or 64x128 (height x width)")
    return int(match[1]) if match[2] is None else (int(match[1]), int(match[2]))


def sides(text: str) -> float | tuple[float, ...]:
    """Return a length, or (height, width), in metres."""
    found = tuple(length("um", side) for side in re.split(r"\s*[xX]\s*", text))
    return found if len(found) > 1 else found[0]


CAMERA = Shown(("--camera",), metavar="NAME|FILE", parse=_camera)
WINDOW = Shown(metavar="PIXELS", parse=window)
PITCH = Shown(length="um")


@dataclass(frozen=True, kw_only=True)
class Optics(Options):
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
    camera
        Camera with the pixel pitch, and the noise where a command needs it: the name of an example, which `lommel
        examples --find camera` lists, or a file; overrides the file.
    pixel
        Pixel pitch, such as 3.45um, or height x width: 4umx3um; overrides the file and the camera.
    shape
        Window in pixels, such as 65 or 64x128 (height x width); overrides the file.
    """

    object_distance: Annotated[float | None, Shown(length="m")] = None
    focus_distance: Annotated[float | None, Shown(("--focus",), length="m")] = None
    f_number: float | None = None
    wavelength: Annotated[float | None, Shown(length="nm")] = None
    camera: Annotated[Camera | None, CAMERA] = None
    pixel: Annotated[Any, Shown(parse=sides, metavar="LENGTH")] = None
    shape: Annotated[Any, WINDOW] = None


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


@dataclass(frozen=True, kw_only=True)
class CameraNoise(Options):
    """Options for the camera, its noise, and the pixels to ignore.

    Parameters
    ----------
    camera
        Camera with the pixel pitch and the noise: the name of an example, which `lommel examples --find camera`
        lists, or a file; overrides the file.
    white
        Electrons per count; by default from the camera, or 1.
    read
        Read noise, rms electrons; 0 for none; by default from the camera.
    offset
        Black level, in the unit of the images; by default from the camera, or 0.
    saturation
        Value in the file at which pixels saturate, such as 60000; the largest integer always counts as saturated.
    masked
        Image that is not 0 at pixels to ignore; one for all images, or one for each.
    pixel
        Pixel pitch on the camera, such as 6.5um; overrides the file and the camera.
    """

    heading: ClassVar[str] = "Camera and noise"
    camera: Annotated[Camera | None, CAMERA] = None
    white: Annotated[float | None, Shown(("--gain",))] = None
    read: float | None = None
    offset: float | None = None
    saturation: float | None = None
    masked: Annotated[Path | None, Shown(("--mask",), metavar="FILE")] = None
    pixel: Annotated[float | None, PITCH] = None

    def __post_init__(self) -> None:
        super().__post_init__()
        values = {name: value for name, value in self.values().items() if isinstance(value, float)}
        Noise(**{"read": 0.0} | values)  # raises ValueError for a value out of range, before files are read

    def values(self) -> Facts:
        """Return gain, read noise and offset, None without an option."""
        return {name: getattr(self, name) for name in ("white", "read", "offset")} | {"excess": None}

    def instrument(self, lens: Path, **changes: object) -> Instrument:
        """Return the instrument of a lens file with this camera and pixel pitch."""
        return instrument_of(lens, camera=self.camera, pixel=self.pixel, **changes)

    def resolve(self, header: Metadata, camera: Camera | None) -> tuple[Noise, float | None, list[str]]:
        """Return (1) noise, (2) saturation, (3) notes; options override the camera, and the camera the header."""
        options = self.values() | {"saturation": self.saturation}
        notes = take_header(options, header, camera)
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
        return recorded_noise(self.values(), self.camera is None, lens, camera, noise)

    def mask(self, images: Any) -> Any:
        """Return a mask of the pixels of images to ignore, or None."""
        return None if self.masked is None else mask_of(self.masked, images)


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
    masked
        Image whose nonzero pixels mark the pixels of the photo to ignore.
    """

    masked: Annotated[Path | None, Shown(("--mask",), metavar="FILE")] = None


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


def _number_or_path(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


_MAP = Shown(metavar="NUMBER|FILE", parse=_number_or_path)


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
        return {name: camera_map(v, name) if isinstance(v, str) else v for name, v in values.items()}


def given(options: Options) -> Facts:
    """Return the fields of options by their names."""
    return {field.name: getattr(options, field.name) for field in dataclasses.fields(options)}
