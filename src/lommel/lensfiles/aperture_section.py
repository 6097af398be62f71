"""The section [aperture] of lens files: vanes, vignetting, masks, shapes and segments."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial, reduce
from operator import or_
from pathlib import Path
from typing import Annotated, Any, Literal, TypeVar

import numpy as np
from pydantic import Field, PlainValidator, ValidationInfo, field_validator

from lommel import telescopes
from lommel.base import optional, reading, validation
from lommel.base.encoding import to_light
from lommel.base.units import parse_length
from lommel.io import fits_images
from lommel.io.photos import PhotoError, read_raster
from lommel.io.registry import Values
from lommel.lensfiles.toml_files import (
    Angle,
    Length,
    MadeSection,
    Number,
    PartsError,
    Section,
    Toml,
    finite,
    read_beside,
)
from lommel.optics.aperture.mask import MAX_SIDE, Mask
from lommel.optics.aperture.shapes import (
    MAX_VANES,
    CatEye,
    Disc,
    Ellipse,
    Polygon,
    Segments,
    Shape,
    Spider,
    require_reach,
)

_FITS = (*fits_images.SUFFIXES, *fits_images.PACKED)
_Made = TypeVar("_Made")
_SUFFIXES = (".npy", ".png", ".tif", ".tiff", *_FITS)


class _Spider(Section):
    width: Length
    vanes: Annotated[int, Field(strict=True, ge=1, le=MAX_VANES)] | None = None
    first: Angle = 0.0
    angles: Annotated[list[Angle], Field(min_length=1, max_length=MAX_VANES)] | None = None

    @classmethod
    def fault(cls, given: Toml) -> str | None:
        """Return what is wrong where the vanes are not given one way."""
        if ("vanes" in given) == ("angles" in given):
            return "needs vanes, a number of them at equal angles, or angles: exactly one of the two"
        return "first has no meaning with angles" if {"angles", "first"} <= set(given) else None

    def spider(self, radius: float) -> Spider:
        """Return the vanes of an aperture of this radius (metres)."""
        if not self.width < 2.0 * radius:
            raise ValueError(f"must be below the diameter of the aperture, {2.0 * radius:g} m, got {self.width:g} m")
        width = self.width / radius
        if self.angles is not None:
            return Spider(width, tuple(self.angles))
        assert self.vanes is not None
        return Spider.equal(self.vanes, width, self.first)


class _Ellipse(MadeSection):
    a: Annotated[Number, Field(gt=0, le=1000)]
    b: Annotated[Number, Field(gt=0, le=1000)]
    angle: Angle = 0.0

    def made(self) -> Ellipse:
        return Ellipse(**dict(self))


class _CatEye(MadeSection):
    shift: tuple[Number, Number]
    radius: Annotated[Number, Field(gt=0, le=1000)] = 1.0

    def made(self) -> CatEye:
        return CatEye(self.shift, self.radius)


class _Mask(Section):
    holds: Literal["amplitude", "intensity"] = "amplitude"
    # Becomes the mask, read once `holds` is known.
    file: Any

    @field_validator("file")
    @classmethod
    def _file(cls, value: Any, info: ValidationInfo) -> Any:
        if "holds" not in info.data:
            return value  # `holds` has an error of its own
        wanted = f"the name of a file, {', '.join(_SUFFIXES)}"
        mask = Mask(read_beside(info.context, value, wanted, _read_transmission))
        if info.data["holds"] == "amplitude":
            return mask
        if mask.values.dtype.kind == "c":
            raise ValueError('must hold real numbers with holds = "intensity", got complex ones: amplitude and phase')
        return Mask(np.sqrt(mask.values))


def _read_transmission(path: Path) -> Values:
    """Read a square of transmissions from 0 to 1: an array (.npy), a FITS image, or a grey picture with white = 1."""
    if not path.name.lower().endswith(_SUFFIXES):
        raise ValueError(f"must end in {', '.join(_SUFFIXES)}, got {validation.shown(path.name)}")
    if path.suffix.lower() == ".npy":
        try:
            return reading.npy(reading.contents(path), MAX_SIDE**2)[0]
        except ValueError as error:
            raise ValueError(f"{path.name!r} is not an array: {reading.reason(error)}") from None
    if path.name.lower().endswith(_FITS):
        optional.library("astropy", "FITS files need", "fits")
        data = reading.contents(path)
        try:
            return fits_images.read(data, MAX_SIDE**2)[0].values
        except Exception as error:  # of astropy
            raise ValueError(f"{path.name!r} is not a FITS image: {reading.reason(error)}") from None
    try:
        values = read_raster(path)[0]
    except PhotoError as error:
        raise ValueError(f"{path.name!r} is not a picture: {reading.reason(error)}") from None
    if values.ndim != 2:
        raise ValueError(f"{path.name!r} must be a grey picture, got one in colour")
    return to_light(repr(path.name), values, "linear", np.float64)


class _Metres(float):
    """A length in metres, where other numbers are over the radius of the aperture."""


def _extent(value: Any) -> float:
    """Return a length of a shape: a text with a unit, or a number over the radius of the aperture."""
    if isinstance(value, str):
        return _Metres(finite(parse_length(value, "50 mm")))
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise ValueError(
            f"must be a length with a unit or a number over the radius of the aperture, got {validation.shown(value)}"
        )
    return finite(float(value))


_Extent = Annotated[float, PlainValidator(_extent)]
_Point = tuple[_Extent, _Extent]


def _over(extent: float, radius: float) -> float:
    return float(extent) / radius if isinstance(extent, _Metres) else extent


def _place(point: tuple[float, float], radius: float) -> tuple[float, float]:
    return _over(point[0], radius), _over(point[1], radius)


# Of each type the keys that it needs, and those that it may have.
_KEYS: dict[str, tuple[set[str], set[str]]] = {
    "disc": ({"radius"}, {"center"}),
    "ellipse": ({"a", "b"}, {"angle", "center"}),
    "polygon": ({"corners"}, set()),
    "hexagon": ({"radius"}, {"angle", "center"}),
    "strip": ({"start", "end", "width"}, set()),
}


class _Part(Section):
    """One entry of [[aperture.clear]] or [[aperture.blocked]]."""

    type: Literal["disc", "ellipse", "polygon", "hexagon", "strip"]
    radius: _Extent = 0.0
    a: _Extent = 0.0
    b: _Extent = 0.0
    width: _Extent = 0.0
    angle: Angle = 0.0
    center: _Point = (0.0, 0.0)
    start: _Point = (0.0, 0.0)
    end: _Point = (0.0, 0.0)
    corners: list[_Point] = Field(default_factory=list)

    @classmethod
    def fault(cls, given: Toml) -> str | None:
        """Return which keys a shape of this type lacks or has beyond its own."""
        kind = given.get("type")
        if not isinstance(kind, str) or kind not in _KEYS:
            return None
        needed, allowed = _KEYS[kind]
        if missing := sorted(needed - set(given)):
            return f"a {kind} needs {', '.join(missing)}"
        stray = sorted((set(given) & set(cls.model_fields)) - needed - allowed - {"type"})
        return f"{', '.join(stray)} has no meaning for a {kind}" if stray else None

    def made(self, radius: float) -> Shape:
        """Return the shape in an aperture of this radius, metres."""
        size, center = _over(self.radius, radius), _place(self.center, radius)
        if self.type == "disc":
            return Disc(size, center)
        if self.type == "hexagon":
            return Polygon.regular(6, size, center, self.angle)
        if self.type == "ellipse":
            return Ellipse(_over(self.a, radius), _over(self.b, radius), self.angle, center)
        if self.type == "strip":
            return Polygon.strip(_place(self.start, radius), _place(self.end, radius), _over(self.width, radius))
        return Polygon(tuple(_place(corner, radius) for corner in self.corners))


class _Segments(Section):
    rings: Annotated[int, Field(strict=True, ge=1, le=32)] | None = None
    gap: _Extent = 0.0
    middle: Annotated[bool, Field(strict=True)] = False
    angle: Angle = 0.0
    piston: list[Number] | None = None
    tip: list[Number] | None = None
    tilt: list[Number] | None = None
    # Becomes the rows of the file.
    file: Any = None

    @field_validator("file")
    @classmethod
    def _file(cls, value: Any, info: ValidationInfo) -> Any:
        return None if value is None else read_beside(info.context, value, "the name of a text file", _read_phases)

    @classmethod
    def fault(cls, given: Toml) -> str | None:
        """Return which keys exclude each other."""
        if "file" in given and set(_PHASES) & set(given):
            return "takes file or the lists piston, tip and tilt, got both"
        stray = sorted({"gap", "middle", "angle"} & set(given))
        return f"{', '.join(stray)} has no meaning without rings" if stray and "rings" not in given else None

    def phased(self, segments: Segments) -> Segments:
        """Return segments with the phases of the file, in waves there."""
        rows = self.file
        given = (
            dict(zip(_PHASES, rows.T, strict=False))
            if rows is not None
            else {name: part for name in _PHASES if (part := getattr(self, name)) is not None}
        )
        for name, part in given.items():
            if len(part) != len(segments.shapes):
                what = "file" if rows is not None else name
                message = f"must have one row for each of {len(segments.shapes)} segments, got {len(part)}"
                raise PartsError([(("aperture", "segments", what), f"aperture.segments.{what}", message)])
        return segments.phased(*(given.get(name, 0.0) for name in _PHASES), unit="waves")


_PHASES = ("piston", "tip", "tilt")


def _read_phases(path: Path) -> Values:
    """Read rows of piston, or of piston, tip and tilt, in waves; commas or spaces between, # before a comment."""
    rows: list[list[float]] = []
    for number, line in enumerate(reading.decoded(reading.contents(path, reading.MAX_TOML)).splitlines(), 1):
        words = line.partition("#")[0].replace(",", " ").split()
        if not words:
            continue
        try:
            row = [float(word) for word in words]
        except ValueError:
            row = [math.nan]
        if len(row) not in (1, 3) or not all(map(math.isfinite, row)) or (rows and len(row) != len(rows[0])):
            raise ValueError(
                f"{path.name!r}, line {number}: must hold piston, or piston, tip and tilt, one number or "
                f"three in every line, got {validation.shown(line.strip())}"
            )
        rows.append(row)
    if not rows:
        raise ValueError(f"{path.name!r} holds no numbers")
    return np.array(rows)


class ApertureSection(Section):
    """The section [aperture] of a lens file."""

    spider: _Spider | None = None
    ellipse: _Ellipse | None = None
    cat_eye: _CatEye | None = None
    mask: _Mask | None = None
    telescope: Literal["elt", "hst", "jwst", "keck", "subaru", "vlt"] | None = None
    segments: _Segments | None = None
    clear: Annotated[list[_Part], Field(min_length=1)] | None = None
    blocked: Annotated[list[_Part], Field(min_length=1)] | None = None

    @classmethod
    def fault(cls, given: Toml) -> str | None:
        """Return which parts exclude each other."""
        if {"ellipse", "cat_eye"} <= set(given):
            return "takes one of ellipse and cat_eye, got both"
        segments, telescope = given.get("segments"), given.get("telescope")
        segmented = telescope in ("elt", "jwst", "keck")
        if isinstance(segments, dict) and ("rings" not in segments) != segmented:
            return "segments needs rings or a telescope with segments (elt, jwst, keck): exactly one of them"
        if telescope is not None and not segmented and segments is not None:
            return f"takes one of segments and telescope, got telescope = {validation.shown(telescope)}"
        return None

    def shapes(self, radius: float) -> Toml:
        """Return the aperture of a lens of this radius (metres), by the names in :class:`lommel.Lens`.

        PartsError, with all errors of its parts.
        """
        faults = _Collected()
        spider, edge = self.spider, self.ellipse or self.cat_eye
        found = {"vignetting": edge and edge.made(), "mask": self.mask and self.mask.file}
        if spider is not None:
            found["spider"] = faults.tried(("spider", "width"), "spider.width", lambda: spider.spider(radius))
        stop = self._mirror(radius, faults)
        clear, blocked = (_union(name, getattr(self, name), radius, faults) for name in ("clear", "blocked"))
        faults.refuse()
        if clear is not None:
            stop = clear if stop is None else stop & clear
        if blocked is not None:
            stop = (Disc() if stop is None else stop) - blocked
        found["stop"] = stop
        return {name: shape for name, shape in found.items() if shape is not None}

    def _mirror(self, radius: float, faults: _Collected) -> Shape | Segments | None:
        """Return the telescope or the segments, if there are any."""
        stop: Shape | Segments | None = None
        if self.telescope is not None:
            stop = getattr(telescopes, self.telescope)()
        one = self.segments
        if one is None:
            return stop
        if one.rings is not None:
            rings, gap = one.rings, _over(one.gap, radius)
            stop = faults.tried(
                ("segments", "gap"),
                "segments",
                lambda: Segments.hexagonal(rings, gap, middle=one.middle, angle=one.angle),
            )
        return (
            faults.tried(("segments",), "segments", lambda: one.phased(stop)) if isinstance(stop, Segments) else stop
        )


class _Collected:
    """Errors of the parts of an aperture."""

    def __init__(self) -> None:
        self.faults: list[tuple[tuple[str, ...], str, str]] = []

    def tried(self, keys: tuple[str, ...], name: str, make: Callable[[], _Made]) -> _Made | None:
        """Return what is made, or None and keep its error."""
        try:
            return make()
        except PartsError as error:
            self.faults += error.faults
        except ValueError as error:
            self.faults.append((("aperture", *keys), f"aperture.{name}", str(error)))
        return None

    def refuse(self) -> None:
        """Raise PartsError with all errors, if there are any."""
        if self.faults:
            raise PartsError(self.faults)


def _union(name: str, parts: list[_Part] | None, radius: float, faults: _Collected) -> Shape | None:
    """Return the union of parts, if there are any."""

    def made(part: _Part) -> Shape:
        shape = part.made(radius)
        require_reach("it", shape)
        return shape

    listed = [
        faults.tried((name, str(k)), f"{name}, entry {k + 1}, {part.type}", partial(made, part))
        for k, part in enumerate(parts or [])
    ]
    whole = [shape for shape in listed if shape is not None]
    return reduce(or_, whole) if whole else None
