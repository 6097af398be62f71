"""Files of lenses to be drawn at random: lens files in TOML with a pair in place of a number."""

from __future__ import annotations

from os import PathLike
from typing import Annotated, Any

from pydantic import BeforeValidator, Field, ValidationInfo

from lommel.base import validation
from lommel.base.units import parse_length
from lommel.imaging.datasets import LensRanges
from lommel.lensfiles import toml_files
from lommel.lensfiles.toml_files import Length, Number, Section


def _lengths(value: Any, info: ValidationInfo) -> Any:
    """Return a length in metres, or a pair of them."""
    example = {"focal_length": "50 mm", "focus_distance": "2 m"}.get(info.field_name or "", "3.45 um")
    if isinstance(value, list):
        return tuple(parse_length(each, example) for each in value)
    return parse_length(value, example)


def _numbers(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value


_Lengths = Annotated[float | tuple[float, float], BeforeValidator(_lengths)]
_Numbers = Annotated[Number | tuple[Number, Number], BeforeValidator(_numbers)]


class _Lens(Section):
    focal_length: _Lengths
    f_number: _Numbers
    focus_distance: _Lengths
    wavelength: Length = 540e-9


class _Aberrations(Section):
    spherical: _Numbers = 0.0


class _Sensor(Section):
    pixel: _Lengths
    shape: Any = None  # of PSFs, in lens files


class _Object(Section):
    distance: Any = None  # of lens files


class _File(Section):
    name: str = ""
    source: str = ""
    lens: _Lens
    aberrations: _Aberrations = Field(default_factory=_Aberrations)
    object: _Object = Field(default_factory=_Object)
    sensor: _Sensor


def load_lens_ranges(path: str | PathLike[str]) -> LensRanges:
    """Return the ranges of a file, each a value or a list of two; LensFileError or OSError if it cannot be used.

    Keys: ``[lens]`` focal_length, f_number, focus_distance, wavelength (one value); ``[aberrations]`` spherical (C_s,
    radians); ``[sensor]`` pixel. Lengths are texts with a unit.
    """
    source = validation.path("path", path)
    text, raw = toml_files.parsed(source)

    def made(file: _File) -> LensRanges:
        given = file.lens.model_dump() | {"spherical": file.aberrations.spherical, "pixel": file.sensor.pixel}
        return LensRanges(**given)

    return toml_files.built(source, raw, text, _File, made)
