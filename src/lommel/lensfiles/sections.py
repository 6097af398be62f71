"""Kinds of entries that lens files are made of: sections, numbers, lengths and angles."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Annotated, Any, TypeVar

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, PlainValidator

from lommel.base import validation
from lommel.base.units import parse_angle, parse_length
from lommel.base.validation import shown

_Read = TypeVar("_Read")


def _positive(value: float) -> float:
    if not value > 0:
        raise ValueError(f"must be positive, got {value:g} m")
    return value


def finite(value: float) -> float:
    """Return a number, or raise ValueError if it is not finite."""
    if not math.isfinite(value):
        raise ValueError(f"must be finite, got {value}")
    return value


def _shape(value: Any) -> tuple[int, int]:
    try:
        return validation.image_shape(value)
    except TypeError as error:
        raise ValueError(str(error)) from None


Distance = Annotated[float, BeforeValidator(parse_length), AfterValidator(_positive)]
Length = Annotated[Distance, AfterValidator(finite)]
SignedLength = Annotated[float, BeforeValidator(parse_length), AfterValidator(finite)]
Number = Annotated[float, Field(strict=True), AfterValidator(finite)]
Angle = Annotated[float, BeforeValidator(parse_angle), AfterValidator(finite)]


def read_beside(context: dict[str, Any] | None, name: Any, what: str, read: Callable[[Path], _Read]) -> _Read:
    """Return what is read from a file that a lens file names; ValueError if it cannot be, or may not be there."""
    if not isinstance(name, str):
        raise ValueError(f"must be {what}, got {shown(name)}")
    given = context or {}
    folder = Path(given.get("folder", Path()))
    path = folder / name
    if given.get("folder_only") and not path.resolve().is_relative_to(folder.resolve()):
        raise ValueError(f"must lie in the folder of the lens file, got {shown(name)}")
    try:
        return read(path)
    except OSError as error:
        raise ValueError(f"{name!r} cannot be read: {error.strerror or error}") from None


class Section(BaseModel):
    """A section of a lens file: unknown keys are refused."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class Sensor(Section):
    """The section [sensor]: its pixels, and how many of them a window has."""

    pixel: Annotated[Length, AfterValidator(partial(validation.pixel, metric=True))]
    shape: Annotated[tuple[int, int], BeforeValidator(_shape)] | None = None
    integrate: Annotated[bool, Field(strict=True)] | None = None


def _pitch(value: Any) -> float | tuple[float, float]:
    """Return the side of a pixel from a text, or height and width from a list of two."""
    sides = value if isinstance(value, list) else [value]
    lengths = [validation.pixel(finite(_positive(parse_length(side))), metric=True) for side in sides]
    return validation.pitch("pixel", lengths if isinstance(value, list) else lengths[0])


def _fill(value: Any) -> tuple[float, float]:
    try:
        return validation.fill("fill", value)
    except TypeError as error:
        raise ValueError(str(error)) from None


class PhotoSensor(Sensor):
    """That of a lens: pixels may have two sides, and an active part."""

    pixel: Annotated[float | tuple[float, float], PlainValidator(_pitch)]  # type: ignore[assignment]
    fill: Annotated[tuple[float, float], PlainValidator(_fill)] = (1.0, 1.0)
