"""TOML files of optics: types of entries and their validation, with all errors of a file reported together."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from pathlib import Path
from types import UnionType
from typing import Annotated, Any, ClassVar, Self, TypeAlias, TypedDict, TypeVar, Union, get_args, get_origin

import numpy as np
from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    ModelWrapValidatorHandler,
    ValidationError,
    ValidationInfo,
    model_validator,
)
from pydantic_core import ErrorDetails, InitErrorDetails

from lommel.base import reading, validation
from lommel.base.arrays import Json
from lommel.base.options import near
from lommel.base.units import parse_angle, parse_length, with_units
from lommel.base.validation import shown
from lommel.io import photos, text_files

_Read = TypeVar("_Read")
_Model = TypeVar("_Model", bound="Section")
_Result = TypeVar("_Result")

Toml: TypeAlias = Json
"""The contents of a TOML file."""


class Context(TypedDict, total=False):
    """Folder of a lens file, to which the file names in it are relative, and whether these files must lie in it."""

    folder: Path
    folder_only: bool


def _positive(value: float) -> float:
    if not value > 0:
        raise ValueError(f"must be positive, got {value:g} m")
    return value


def finite(value: float) -> float:
    """Return a number if it is finite; ValueError otherwise."""
    if not math.isfinite(value):
        raise ValueError(f"must be finite, got {value}")
    return value


def checked_by(check: Callable[[Any], _Result]) -> Callable[[Any], _Result]:
    """Return `check` with TypeErrors converted to ValueErrors, which pydantic collects."""

    def checked(value: object) -> _Result:
        try:
            return check(value)
        except TypeError as error:
            raise ValueError(str(error)) from None

    return checked


# Example of a length in the error message for a key; "5 mm" for other keys.
_EXAMPLES = {"wavelength": "550 nm", "focal_length": "50 mm", "focus_distance": "2 m", "distance": "2 m"}
_EXAMPLES |= {
    "sensor_distance": "51 mm",
    "pixel": "3.45 um",
    "depth": "2 um",
    "step": "100 nm",
    "thickness": "170 um",
}


def _parsed_length(value: str | float, info: ValidationInfo) -> float:
    return parse_length(value, _EXAMPLES.get(info.field_name or "", "5 mm"))


Distance = Annotated[float, BeforeValidator(_parsed_length), AfterValidator(_positive)]
Length = Annotated[Distance, AfterValidator(finite)]
SignedLength = Annotated[float, BeforeValidator(_parsed_length), AfterValidator(finite)]
Number = Annotated[float, Field(strict=True), AfterValidator(finite)]
Angle = Annotated[
    float, BeforeValidator(parse_angle), AfterValidator(finite), AfterValidator(lambda x: math.fmod(x, 2.0 * math.pi))
]


def pitch(value: str | float | list[str | float]) -> float | tuple[float, float]:
    """Return the pixel pitch from a text or, for a list of two texts, (height, width), metres."""
    sides = value if isinstance(value, list) else [value]
    lengths = [validation.pixel(finite(_positive(parse_length(side, "3.45 um"))), metric=True) for side in sides]
    return validation.pitch("pixel", lengths if isinstance(value, list) else lengths[0])


def read_beside(context: Context | None, name: object, description: str, read: Callable[[Path], _Read]) -> _Read:
    """Read a file that a lens file names; ValueError if it cannot be read or is outside the allowed folder.

    `description`, such as "the name of a mask", is the valid entry in the error message for other types.
    """
    if not isinstance(name, str):
        raise ValueError(f"must be {description}, got {shown(name)}")
    options = context or {}
    folder = options.get("folder", Path())
    path = folder / name
    if options.get("folder_only") and not path.resolve().is_relative_to(folder.resolve()):
        raise ValueError(f"must lie in the folder of the lens file, got {shown(name)}")
    try:
        return read(path)
    except OSError as error:
        raise ValueError(f"{name!r} cannot be read: {error.strerror or error}") from None


class Section(BaseModel):
    """A section of a lens file; unknown keys are errors."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    advice: ClassVar[dict[str, str]] = {}  # text of the error message for a key that the section does not have

    @classmethod
    def fault(cls, entries: Toml) -> str | None:  # noqa: ARG003 (used by overriding methods)
        """Return the error message for a wrong combination of keys, None if the combination is valid."""
        return None

    @model_validator(mode="wrap")
    @classmethod
    def _with_fault(cls, raw: object, handler: ModelWrapValidatorHandler[Self]) -> Self:
        """Validate the section; report an error of :meth:`fault` together with errors of the values."""
        message = cls.fault(raw) if isinstance(raw, dict) else None
        faults = (
            [InitErrorDetails(type="value_error", loc=(), input=raw, ctx={"error": ValueError(message)})]
            if message
            else []
        )
        try:
            section = handler(raw)
        except ValidationError as error:
            if not faults:
                raise
            details = error.errors(include_url=False)
            faults = [
                InitErrorDetails(type=entry["type"], loc=entry["loc"], input=entry["input"], ctx=entry.get("ctx", {}))
                for entry in details
            ] + faults
        if faults:
            raise ValidationError.from_exception_data(cls.__name__, faults)
        return section


class BuiltSection(Section):
    """A section that builds its object also during validation, so that errors of the object name the section."""

    @model_validator(mode="after")
    def _validate_object(self) -> Self:
        self.build()
        return self

    def build(self) -> object:
        """Return the object that the section describes."""
        raise NotImplementedError


class LensFileError(ValueError):
    """Error in a lens file; the message states all errors, with keys and line numbers if they have any."""

    names_keys = True  # the command line replaces names of arguments by options in other messages


class PartsError(ValueError):
    """Errors of parts of a lens, each with the keys of the part in the file, the name of the part and a message."""

    def __init__(self, faults: Sequence[tuple[tuple[str, ...], str, str]]) -> None:
        super().__init__("; ".join(f"{name}: {message}" for _, name, message in faults))
        self.faults = faults


def _refuse_others(source: Path) -> None:
    """Raise LensFileError if a file is an image or a lens design, which users may confuse with a lens file."""
    if reading.start(source, 16).startswith((*photos.PNG, *photos.JPEG, *photos.TIFF, b"\x93NUMPY", b"SIMPLE  =")):
        raise LensFileError(f"{validation.line(source)} is an image, not a lens file, which is text (TOML)")
    if note := text_files.design_note(source):
        raise LensFileError(note)


def parsed(source: Path) -> tuple[str, Toml]:
    """Return the text of a TOML file and its contents."""
    _refuse_others(source)
    try:
        text = reading.decoded(reading.contents(source, reading.MAX_TOML))
        return text, reading.toml(text)
    except ValueError as error:
        raise LensFileError(f"{validation.line(source)}: not valid TOML: {reading.reason(error)}") from None


def built(
    source: Path,
    entries: Toml,
    text: str,
    model: type[_Model],
    build: Callable[[_Model], _Result],
    *,
    context: Context | None = None,
    earlier_errors: tuple[str, ...] = (),
) -> _Result:
    """Return the object ``build(validated file)``; LensFileError with all errors, including `earlier_errors`."""
    errors = list(earlier_errors)
    try:
        file = model.model_validate(entries, context=context)
        # Overflows due to numbers in the file are errors, not warnings.
        with np.errstate(over="raise", divide="raise", invalid="raise"):
            result = build(file)  # also after earlier errors, to report the errors of build(), too
        if not errors:
            return result
    except ValidationError as error:
        details = error.errors(include_url=False, include_context=False)
        count = len(details) + len(errors)
        errors = [_error_message(fault, text, model) for fault in details[: text_files.MAX_MESSAGES]] + errors
        raise LensFileError(text_files.joined_errors(source, errors, count)) from None
    except ArithmeticError as error:
        errors.append(f"its numbers lead to an overflow: {error}")
    except PartsError as error:
        for keys, name, message in error.faults:
            number = text_files.nearest_line(text, keys)
            errors.append(f"{name}{f' (line {number})' if number else ''}: {with_units(message)}")
    except ValueError as error:
        errors.append(with_units(str(error)))
    raise LensFileError(text_files.joined_errors(source, errors))


def _error_message(fault: ErrorDetails, text: str, model: type[Section]) -> str:
    """Return the message of a validation error, with the key and the line number."""
    place = [str(part) for part in fault["loc"]]
    keys = [str(part) for part in fault["loc"] if not isinstance(part, int) or len(fault["loc"]) == 1]
    message = with_units(fault["msg"].removeprefix("Value error, "))
    if fault["type"] == "extra_forbidden":
        section: Any = model
        for part in keys[:-1]:
            section = _section(section.model_fields[part].annotation)
        advice = section.advice.get(keys[-1]) or _section_hint(model, keys) or near(keys[-1], section.model_fields)
        message = f"unknown key; {advice}"
    elif fault["type"] == "missing":
        message = "is missing"
    elif fault["type"] in ("model_type", "dict_type"):
        message = f"must be a section, [{'.'.join(keys)}]"
    elif message.startswith("Input should be"):
        message += f", got {shown(fault['input'])}"
    if not keys:  # an error of the whole file
        return str(message)
    # Find the line by keys and indices (in arrays of tables), or else by the keys alone.
    line = text_files.line_of(text, place) or text_files.line_of(text, keys)
    return f"{'.'.join(map(validation.key, keys))}{f' (line {line})' if line else ''}: {message}"


def _section_hint(model: type[Section], keys: list[str]) -> str | None:
    """Return a text that names the other sections with a key of this name, None if there are none."""
    sections = {name: _section(part.annotation) for name, part in model.model_fields.items() if name != keys[0]}
    names = [f"[{name}]" for name, part in sections.items() if keys[-1] in getattr(part, "model_fields", ())]
    return f"it is in {' or '.join(names)}" if names else None


def _section(annotation: object) -> Any:
    """Return the model class in an annotation such as X | None or list[X]."""
    if get_origin(annotation) in (Union, UnionType, Annotated, list):
        parts = (part for part in get_args(annotation) if part is not type(None))
        return _section(next(parts))
    return annotation
