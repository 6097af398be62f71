"""The section [aperture] of lens files: vanes, vignetting, and masks from files."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, ValidationInfo, field_validator, model_validator

from lommel.base import optional, reading, validation
from lommel.base.encoding import to_light
from lommel.field.vignetting import Shading, Vignetting
from lommel.io import fits_images
from lommel.lensfiles.sections import Angle, Length, Number, Section, SignedLength, read_beside
from lommel.optics.aperture.obstructions import MAX_SIDE, MAX_VANES, CatEye, Ellipse, Mask, Spider

_FITS = (*fits_images.SUFFIXES, *fits_images.PACKED)
_SUFFIXES = (".npy", ".png", ".tif", ".tiff", *_FITS)


class _Spider(Section):
    width: Length
    vanes: Annotated[int, Field(strict=True, ge=1, le=MAX_VANES)] | None = None
    first: Angle = 0.0
    angles: Annotated[list[Angle], Field(min_length=1, max_length=MAX_VANES)] | None = None

    @model_validator(mode="after")
    def _one_way(self) -> _Spider:
        if (self.vanes is None) == (self.angles is None):
            raise ValueError("needs vanes, a number of them at equal angles, or angles: exactly one of the two")
        if self.angles is not None and "first" in self.model_fields_set:
            raise ValueError("first has no meaning with angles")
        return self

    def spider(self, radius: float) -> Spider:
        """Return the vanes of an aperture of this radius (metres)."""
        if not self.width < 2.0 * radius:
            raise ValueError(
                f"aperture.spider.width: must be below the diameter of the aperture, {2.0 * radius:g} m, "
                f"got {self.width:g} m"
            )
        width = self.width / radius
        if self.angles is not None:
            return Spider(width, tuple(self.angles))
        assert self.vanes is not None
        return Spider.equal(self.vanes, width, self.first)


class _Ellipse(Section):
    a: Annotated[Number, Field(gt=0, le=1)]
    b: Annotated[Number, Field(gt=0, le=1)]
    angle: Angle = 0.0


class _CatEye(Section):
    shift: tuple[Number, Number]
    radius: Annotated[Number, Field(gt=0, le=1000)] = 1.0

    @model_validator(mode="after")
    def _overlap(self) -> _CatEye:
        CatEye(self.shift, self.radius)
        return self


class _Mask(Section):
    holds: Literal["amplitude", "intensity"] = "amplitude"
    # Becomes the mask: read once what it holds is known.
    file: Any

    @field_validator("file")
    @classmethod
    def _file(cls, value: Any, info: ValidationInfo) -> Any:
        if "holds" not in info.data:
            return value  # its own fault is told
        wanted = f"the name of a file, {', '.join(_SUFFIXES)}"
        mask = Mask(read_beside(info.context, value, wanted, read_transmission))
        return mask if info.data["holds"] == "amplitude" else Mask(np.sqrt(mask.values))


class ApertureSection(Section):
    """What the section [aperture] of a lens file may hold."""

    spider: _Spider | None = None
    ellipse: _Ellipse | None = None
    cat_eye: _CatEye | None = None
    mask: _Mask | None = None

    @model_validator(mode="after")
    def _one_edge(self) -> ApertureSection:
        if self.ellipse is not None and self.cat_eye is not None:
            raise ValueError("takes one of ellipse and cat_eye, got both")
        return self

    def shapes(self, radius: float) -> dict[str, Any]:
        """Return what narrows an aperture of this radius (metres), by the names that :class:`lommel.Lens` has."""
        ellipse = self.ellipse and Ellipse(**dict(self.ellipse))
        eye = self.cat_eye and CatEye(**dict(self.cat_eye))
        spider = self.spider and self.spider.spider(radius)
        found = {"spider": spider, "vignetting": ellipse or eye, "mask": self.mask and self.mask.file}
        return {name: shape for name, shape in found.items() if shape is not None}


def read_transmission(path: Path) -> NDArray[Any]:
    """Read a square of transmissions from 0 to 1: an array (.npy), a FITS image, or a grey picture, white being 1.

    Rows rise downwards in a picture, as y does.

    Raises
    ------
    ValueError
        If the file is of another kind, or damaged, or a picture in colour.
    OSError
        If it cannot be read.
    """
    suffix = path.suffix.lower()
    if not path.name.lower().endswith(_SUFFIXES):
        raise ValueError(f"must end in {', '.join(_SUFFIXES)}, got {validation.shown(path.name)}")
    if suffix == ".npy":
        try:
            return reading.npy(reading.contents(path), MAX_SIDE**2)[0]
        except ValueError as error:
            raise ValueError(f"{path.name!r} is no array: {reading.reason(error)}") from None
    if path.name.lower().endswith(_FITS):
        optional.library("astropy", "FITS files need", "fits")
        data = reading.contents(path)
        try:
            return fits_images.read(data, MAX_SIDE**2)[0].values
        except Exception as error:  # of astropy
            raise ValueError(f"{path.name!r} is no FITS image: {reading.reason(error)}") from None
    from lommel.io.photos import PhotoError, read_raster

    try:
        values = read_raster(path)[0]
    except PhotoError as error:
        raise ValueError(f"{path.name!r} is no picture: {reading.reason(error)}") from None
    if values.ndim != 2:
        raise ValueError(f"{path.name!r} must be a grey picture, got one in colour")
    return to_light(repr(path.name), values, "linear", np.float64)


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
