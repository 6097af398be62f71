"""TOML files that describe optics: read, held against a model of sections, and told what is wrong with them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import UnionType
from typing import Annotated, Any, TypeVar, Union, get_args, get_origin

import numpy as np
from pydantic import ValidationError

from lommel.base import reading, validation
from lommel.base.options import near
from lommel.base.units import with_units
from lommel.lensfiles import messages
from lommel.lensfiles.sections import Section

_Model = TypeVar("_Model", bound=Section)
_Made = TypeVar("_Made")


class LensFileError(ValueError):
    """A lens file that cannot be used; the message names every fault with its key and line."""


def parsed(source: Path) -> tuple[str, dict[str, Any]]:
    """Return the text of a TOML file, and what it holds; LensFileError if it is none."""
    try:
        text = reading.text(source, reading.MAX_TOML)
        return text, reading.toml(text)
    except ValueError as error:
        raise LensFileError(f"{validation.line(source)}: not valid TOML: {reading.reason(error)}") from None


def built(
    source: Path,
    raw: dict[str, Any],
    text: str,
    model: type[_Model],
    make: Callable[[_Model], _Made],
    *,
    context: dict[str, Any] | None = None,
    found: tuple[str, ...] = (),
) -> _Made:
    """Return what is made of a file that fits a model; LensFileError with every fault, those `found` before too."""
    faults = list(found)
    try:
        file = model.model_validate(raw, context=context)
        if not faults:
            with np.errstate(over="raise", divide="raise", invalid="raise"):
                return make(file)
    except ValidationError as error:
        every = error.errors(include_url=False, include_context=False, include_input=False)
        count = len(every) + len(faults)
        faults = [_described(fault, text, model) for fault in every[: messages.TOLD]] + faults
        raise LensFileError(messages.together(source, faults, count)) from None
    except ArithmeticError as error:
        faults.append(f"its numbers lead beyond the range of numbers: {error}")
    except ValueError as error:
        faults.append(with_units(str(error)))
    raise LensFileError(messages.together(source, faults))


def _described(fault: Any, text: str, model: type[Section]) -> str:
    place = [str(part) for part in fault["loc"]]
    keys = [str(part) for part in fault["loc"] if not isinstance(part, int) or len(fault["loc"]) == 1]
    message = with_units(fault["msg"].removeprefix("Value error, "))
    if fault["type"] == "extra_forbidden":
        section: Any = model
        for part in keys[:-1]:
            section = _section(section.model_fields[part].annotation)
        message = f"unknown key; {_elsewhere(model, keys) or near(keys[-1], section.model_fields)}"
    elif fault["type"] == "missing":
        message = "is missing"
    elif fault["type"] in ("model_type", "dict_type"):
        message = f"must be a section, [{'.'.join(keys)}]"
    if not keys:  # of the file as a whole
        return str(message)
    # A table of several has lines of its own, and a number to be told by.
    line = messages.line_of(text, place) or messages.line_of(text, keys)
    return f"{'.'.join(map(validation.key, keys))}{f' (line {line})' if line else ''}: {message}"


def _elsewhere(model: type[Section], keys: list[str]) -> str | None:
    """Return which other sections of a file have a key of this name, if any has."""
    sections = {name: _section(part.annotation) for name, part in model.model_fields.items() if name != keys[0]}
    homes = [f"[{name}]" for name, part in sections.items() if keys[-1] in getattr(part, "model_fields", ())]
    return f"it is in {' or '.join(homes)}" if homes else None


def _section(annotation: Any) -> Any:
    """Return the model in an annotation that may allow None, or a list of it."""
    if get_origin(annotation) in (Union, UnionType, Annotated, list):
        parts = (part for part in get_args(annotation) if part is not type(None))
        return _section(next(parts))
    return annotation
