"""The sections [field.vignetting] and [field.shading] of lens files: what light off the axis meets."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, model_validator

from lommel.field.vignetting import Shading, Vignetting
from lommel.lensfiles.sections import Length, Number, Section, SignedLength


class VignettingSection(Section):
    """A circle that moves across the aperture with the height, by a table."""

    height: Annotated[list[SignedLength], Field(min_length=2)]
    shift: list[Number]
    radius: Number | list[Number] = 1.0

    @model_validator(mode="after")
    def _possible(self) -> VignettingSection:
        self.made()
        return self

    def made(self) -> Vignetting:
        """Return it as the map of a field takes it."""
        return Vignetting(self.height, self.shift, self.radius)


class ShadingSection(Section):
    """How much less light comes, by a table or as the fourth power of a cosine."""

    distance: Length | None = None
    height: list[SignedLength] | None = None
    light: list[Number] | None = None

    @model_validator(mode="after")
    def _one_way(self) -> ShadingSection:
        if (self.distance is None) == (self.height is None) or (self.height is None) != (self.light is None):
            raise ValueError("needs distance, of the exit pupil from the sensor, or height and light: one of the two")
        self.made()
        return self

    def made(self) -> Shading:
        """Return it as the map of a field takes it."""
        if self.distance is not None:
            return Shading.cos4(self.distance)
        assert self.height is not None
        assert self.light is not None
        return Shading(self.height, self.light)
