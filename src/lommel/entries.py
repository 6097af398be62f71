"""Kinds of entries that lens files are made of: sections, numbers, lengths and angles."""

from __future__ import annotations

import math
from typing import Annotated

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field

from lommel.units import parse_angle, parse_length


def _positive(value: float) -> float:
    if not value > 0:
        raise ValueError(f"must be positive, got {value:g} m")
    return value


def finite(value: float) -> float:
    """Return a number, or raise ValueError if it is not finite."""
    if not math.isfinite(value):
        raise ValueError(f"must be finite, got {value}")
    return value


Distance = Annotated[float, BeforeValidator(parse_length), AfterValidator(_positive)]
Length = Annotated[Distance, AfterValidator(finite)]
SignedLength = Annotated[float, BeforeValidator(parse_length), AfterValidator(finite)]
Number = Annotated[float, Field(strict=True), AfterValidator(finite)]
Angle = Annotated[float, BeforeValidator(parse_angle), AfterValidator(finite)]


class Section(BaseModel):
    """A section of a lens file: unknown keys are refused."""

    model_config = ConfigDict(extra="forbid", frozen=True)
