"""Lens descriptions in TOML, validated: every error at once, unknown keys refused."""

from __future__ import annotations

import difflib
import math
import re
import tomllib
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, ValidationError

from lommel import validation
from lommel.lens import Lens
from lommel.pupil import Pupil
from lommel.units import parse_length, parse_radius
from lommel.wavefront import Wavefront


class LensFileError(ValueError):
    """A lens file that cannot be used; the message names every fault with its key and line."""


@dataclass(frozen=True)
class Instrument:
    """What a lens file describes: a lens, the object it looks at, and its sensor.

    Attributes
    ----------
    name, source : str
        What it is, and where its figures come from.
    lens : Lens
    object_distance, pixel : float
        Metres.
    shape : tuple of int
        Height and width of the window, in pixels.
    radii : dict of str to float
        Radii of interest on the sensor (metres) by the text that named them; for encircled energies.
    """

    name: str
    source: str
    lens: Lens
    object_distance: float
    pixel: float
    shape: tuple[int, int]
    radii: dict[str, float]

    def pupil(self) -> Pupil:
        """Return the pupil for the object of the file."""
        return self.lens.pupil(self.object_distance)


def _positive(value: float) -> float:
    if not value > 0:
        raise ValueError(f"must be positive, got {value:g} m")
    return value


def _finite(value: float) -> float:
    if not math.isfinite(value):
        raise ValueError(f"must be finite, got {value}")
    return value


Distance = Annotated[float, BeforeValidator(parse_length), AfterValidator(_positive)]
Length = Annotated[Distance, AfterValidator(_finite)]
SignedLength = Annotated[float, BeforeValidator(parse_length), AfterValidator(_finite)]
Number = Annotated[float, Field(strict=True), AfterValidator(_finite)]


def _shape(value: Any) -> tuple[int, int]:
    try:
        return validation.image_shape(value)
    except TypeError as error:
        raise ValueError(str(error)) from None


def _pitch(value: float) -> float:
    return validation.pixel(value, metric=True)


def _radius(value: Any) -> str | float:
    """Return a length or an angle as it was written, if it is one."""
    if not 0.0 < parse_radius(value, 1.0) < math.inf:
        raise ValueError(f"must be a positive length or angle, got {value!r}")
    found: str | float = value
    return found


class _Section(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class _Lens(_Section):
    focal_length: Length
    f_number: Annotated[Number, Field(gt=0)] | None = None
    aperture_diameter: Length | None = None
    focus_distance: Distance | None = None
    sensor_distance: Length | None = None
    wavelength: Annotated[Length, AfterValidator(validation.wavelength)]
    obscuration: Annotated[Number, Field(ge=0, lt=1)] = 0.0


class _Aberrations(_Section):
    defocus: Number = 0.0
    spherical: Number = 0.0
    W020: Number = 0.0
    W040: Number = 0.0
    W060: Number = 0.0
    W080: Number = 0.0
    spherical_rms: SignedLength = 0.0


class _Object(_Section):
    distance: Distance = math.inf


class _Sensor(_Section):
    pixel: Annotated[Length, AfterValidator(_pitch)]
    shape: Annotated[tuple[int, int], BeforeValidator(_shape)]


class _Report(_Section):
    encircled_energy: list[Annotated[Any, BeforeValidator(_radius)]] = []


class _File(_Section):
    name: str
    source: str = ""
    lens: _Lens
    aberrations: _Aberrations = _Aberrations()
    object: _Object = _Object()
    sensor: _Sensor
    report: _Report = _Report()


def load_instrument(path: str | PathLike[str]) -> Instrument:
    """Read a lens file.

    Lengths are texts with a unit (``"50 mm"``, ``"inf"``) or numbers of metres. Sections and keys:
    ``name``, ``source``; ``[lens]`` focal_length, f_number or aperture_diameter, focus_distance or
    sensor_distance, wavelength, obscuration; ``[aberrations]`` defocus and spherical (C_d, C_s, radians),
    W020, W040, W060, W080 (waves), spherical_rms (a length: balanced primary spherical over the annulus), all
    of which add; ``[object]`` distance; ``[sensor]`` pixel, shape; ``[report]`` encircled_energy, a list of
    radii on the sensor or of angles.

    Raises
    ------
    LensFileError
        If the file is not valid TOML, or for every missing, unknown or impossible entry, with key and line.
    OSError
        If it cannot be read.
    """
    source = Path(path)
    try:
        text = source.read_text(encoding="utf-8-sig")
        raw = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, RecursionError) as error:
        raise LensFileError(f"{source}: not valid TOML: {error}") from None
    try:
        file = _File.model_validate(raw)
        return _instrument(file)
    except ValidationError as error:
        faults = [_describe(fault, text) for fault in error.errors(include_url=False)]
    except ValueError as error:
        faults = [str(error)]
    raise LensFileError(f"{source}: " + (faults[0] if len(faults) == 1 else "".join(f"\n  {f}" for f in faults)))


def _instrument(file: _File) -> Instrument:
    wavelength = file.lens.wavelength
    a = file.aberrations
    rms = 2.0 * math.pi * a.spherical_rms / wavelength
    aberrations = (
        Wavefront(a.defocus, a.spherical)
        + Wavefront.from_seidel(a.W020, a.W040, a.W060, a.W080)
        + Wavefront.balanced_spherical(rms, file.lens.obscuration)
    )
    lens = Lens(**file.lens.model_dump(), aberrations=aberrations)
    radii = {str(text): parse_radius(text, lens.focal_length) for text in file.report.encircled_energy}
    return Instrument(file.name, file.source, lens, file.object.distance, file.sensor.pixel, file.sensor.shape, radii)


def _describe(fault: Any, text: str) -> str:
    keys = [str(part) for part in fault["loc"] if not isinstance(part, int) or len(fault["loc"]) == 1]
    message = fault["msg"].removeprefix("Value error, ")
    if fault["type"] == "extra_forbidden":
        model: Any = _File
        for part in keys[:-1]:
            model = model.model_fields[part].annotation
        near = difflib.get_close_matches(keys[-1], model.model_fields, n=1)
        message = "unknown key" + (
            f"; did you mean {near[0]}?" if near else f"; known are {', '.join(model.model_fields)}"
        )
    elif fault["type"] == "missing":
        message = "is missing"
    elif fault["type"] == "model_type":
        message = f"must be a section, [{'.'.join(keys)}]"
    line = _line(text, keys)
    return f"{'.'.join(keys)}{f' (line {line})' if line else ''}: {message}"


def _line(text: str, keys: list[str]) -> int | None:
    """Return the number of the line that sets `keys`, where it is written in the plain way."""
    section: list[str] = []
    for number, line in enumerate(text.splitlines(), 1):
        if header := re.match(r"\s*\[\s*([\w.\"-]+)\s*\]", line):
            section = header[1].replace('"', "").split(".")
            if section == keys:
                return number
        elif (entry := re.match(r"\s*([\w\"-]+)\s*=", line)) and [*section, entry[1].strip('"')] == keys:
            return number
    return None
