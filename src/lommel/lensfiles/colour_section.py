"""The sections [colour] and [channels] of lens files: what a lens does to colours, and what its sensor records."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Annotated, Any

from pydantic import AfterValidator, Field, ValidationInfo, field_validator, model_validator

from lommel.base import validation
from lommel.lensfiles.channel_files import load_channels
from lommel.lensfiles.sections import Length, Number, Section, SignedLength, read_beside
from lommel.optics.channels import Channels
from lommel.optics.colour import Colour

_Wave = Annotated[Length, AfterValidator(validation.wavelength)]
_CSV = "the name of a CSV file"


class ColourSection(Section):
    """What the section [colour] of a lens file may hold."""

    wavelengths: Annotated[list[_Wave], Field(min_length=2)]
    focus_shift: list[SignedLength] | None = None
    lateral: list[SignedLength] | list[list[SignedLength]] | None = None
    heights: Length | list[Length] | None = None

    @model_validator(mode="after")
    def _table(self) -> ColourSection:
        self.colour()
        return self

    def colour(self) -> Colour:
        """Return the table."""
        return Colour(**dict(self))


class ChannelsSection(Section):
    """What the section [channels] of a lens file may hold."""

    wavelengths: Annotated[list[_Wave], Field(min_length=1)] | None = None
    weights: dict[str, list[Number]] | None = None
    filters: list[str] = Field(default_factory=list)
    illuminant: str | None = None
    tol: Number = 1e-3
    paths: Length = 5e-6
    # Becomes the channels: read once all else is known.
    file: Any = None

    @field_validator("file")
    @classmethod
    def _file(cls, value: Any, info: ValidationInfo) -> Any:
        given = info.data
        if value is None or not {"filters", "illuminant", "tol", "paths"} <= given.keys():
            return value  # their own faults are told

        def beside(name: str) -> Path:
            return read_beside(info.context, name, _CSV, lambda path: path)

        light = given["illuminant"] and beside(given["illuminant"])
        more = {"illuminant": light, "tol": given["tol"], "paths": given["paths"]}
        read = partial(load_channels, filters=[beside(name) for name in given["filters"]], **more)
        return read_beside(info.context, value, _CSV, read)

    @model_validator(mode="after")
    def _one_way(self) -> ChannelsSection:
        if (self.file is None) == (self.wavelengths is None):
            raise ValueError("needs file, a table of the sensor, or wavelengths: exactly one of the two")
        stray = {"weights"} if self.file is not None else {"filters", "illuminant", "tol", "paths"}
        if found := sorted(stray & self.model_fields_set):
            raise ValueError(
                f"{', '.join(found)} has no meaning with {'file' if self.file is not None else 'wavelengths'}"
            )
        self.channels()
        return self

    def channels(self) -> Channels:
        """Return the channels."""
        if self.file is not None:
            made: Channels = self.file
            return made
        assert self.wavelengths is not None
        if self.weights is None:
            return Channels.of_wavelengths(self.wavelengths)
        counts = {len(row) for row in self.weights.values()}
        if counts != {len(self.wavelengths)}:
            raise ValueError(f"weights must be one for each of {len(self.wavelengths)} wavelengths in every channel")
        return Channels(self.wavelengths, list(self.weights.values()), list(self.weights))
