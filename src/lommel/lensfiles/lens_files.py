"""Lens files in TOML: a lens with its object and sensor, or ranges of lens parameters for random lenses."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial, reduce
from operator import or_
from os import PathLike
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, TypeVar

import numpy as np
from pydantic import AfterValidator, BeforeValidator, Field, PlainValidator, ValidationInfo, field_validator

from lommel import telescopes
from lommel.base import optional, reading, validation
from lommel.base.arrays import Values
from lommel.base.encoding import to_light
from lommel.base.units import parse_length, parse_radius
from lommel.field.maps import FieldMap, Shading, Vignetting
from lommel.imaging.datasets import LensRanges
from lommel.io import fits_images
from lommel.io.photos import PhotoError, read_raster
from lommel.io.zernike_tables import ZernikeTable
from lommel.lensfiles import camera_files, tables, toml_files
from lommel.lensfiles.camera_files import PhotoSensor
from lommel.lensfiles.instrument import Calibration, Instrument, tell_wavelength
from lommel.lensfiles.tables import FieldTable, load_channels
from lommel.lensfiles.toml_files import (
    Angle,
    BuiltSection,
    Context,
    Distance,
    Length,
    LensFileError,
    Number,
    PartsError,
    Section,
    SignedLength,
    Toml,
    finite,
    read_beside,
)
from lommel.optics.aperture.apodization import Apodization
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
from lommel.optics.colour.dispersion import Colour
from lommel.optics.colour.spectrum import Channels
from lommel.optics.lens import Lens, aperture
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront

_FITS = (*fits_images.SUFFIXES, *fits_images.PACKED)
_Result = TypeVar("_Result")
_SUFFIXES = (".npy", ".png", ".tif", ".tiff", *_FITS)


class _Spider(Section):
    advice: ClassVar = {"angle": "first is the angle of the first vane, angles lists those of all vanes"}
    width: Length
    vanes: Annotated[int, Field(strict=True, ge=1, le=MAX_VANES)] | None = None
    first: Angle = 0.0
    angles: Annotated[list[Angle], Field(min_length=1, max_length=MAX_VANES)] | None = None

    @classmethod
    def fault(cls, entries: Toml) -> str | None:
        """Return the error message unless exactly one of `vanes` and `angles` is present."""
        if ("vanes" in entries) == ("angles" in entries):
            return "needs vanes (their number, at equal angles) or angles: exactly one of the two"
        return "first has no meaning with angles" if {"angles", "first"} <= set(entries) else None

    def spider(self, radius: float) -> Spider:
        """Return the spider in an aperture of this radius, metres."""
        if not self.width < 2.0 * radius:
            raise ValueError(f"must be below the diameter of the aperture, {2.0 * radius:g} m, got {self.width:g} m")
        width = self.width / radius
        if self.angles is not None:
            return Spider(width, tuple(self.angles))
        assert self.vanes is not None
        return Spider.equal(self.vanes, width, self.first)


class _Ellipse(BuiltSection):
    a: Annotated[Number, Field(gt=0, le=1000)]
    b: Annotated[Number, Field(gt=0, le=1000)]
    angle: Angle = 0.0

    def build(self) -> Ellipse:
        return Ellipse(**dict(self))


class _CatEye(BuiltSection):
    shift: tuple[Number, Number]
    radius: Annotated[Number, Field(gt=0, le=1000)] = 1.0

    def build(self) -> CatEye:
        return CatEye(self.shift, self.radius)


class _Mask(Section):
    holds: Literal["amplitude", "intensity"] = "amplitude"
    file: object  # validation replaces the file name by the mask, which depends on `holds`

    @field_validator("file")
    @classmethod
    def _file(cls, value: object, info: ValidationInfo) -> object:
        if "holds" not in info.data:
            return value  # the error of `holds` is reported
        entry = f"the name of a file, {', '.join(_SUFFIXES)}"
        mask = Mask(read_beside(info.context, value, entry, _read_transmission))
        if info.data["holds"] == "amplitude":
            return mask
        if mask.values.dtype.kind == "c":
            raise ValueError(
                'must hold real numbers with holds = "intensity", got complex numbers: amplitude and phase'
            )
        return Mask(np.sqrt(mask.values))


def _read_transmission(named: Path) -> Values:
    """Read transmissions from 0 to 1 from an array (.npy), a FITS image or a grey picture, whose white is 1."""
    path, part = reading.part_of(named)
    if not path.name.lower().endswith(_SUFFIXES):
        raise ValueError(f"must end in {', '.join(_SUFFIXES)}, got {validation.shown(path.name)}")
    if path.suffix.lower() == ".npy":
        if part is not None:
            raise ValueError(f"{path.name!r} holds one array: omit [{part}]")
        try:
            return reading.npy(reading.contents(path), MAX_SIDE**2)[0]
        except ValueError as error:
            raise ValueError(f"{path.name!r} is not an array: {reading.reason(error)}") from None
    if path.name.lower().endswith(_FITS):
        optional.library("astropy", "FITS files need", "fits")
        data = reading.contents(path)
        try:
            return fits_images.only(fits_images.read(data, MAX_SIDE**2), part).values
        except Exception as error:  # astropy raises various errors
            raise ValueError(f"{path.name!r} is not a FITS image: {reading.reason(error)}") from None
    try:
        values = read_raster(named)[0]
    except PhotoError as error:
        raise ValueError(f"{path.name!r} is not a picture: {reading.reason(error)}") from None
    if values.ndim != 2:
        raise ValueError(f"{path.name!r} must be a grey picture, got one in colour")
    return to_light(repr(path.name), values, "linear", np.float64)


class _Metres(float):
    """A length in metres, unlike a plain float, which is a length in units of the aperture's radius."""


def _extent(value: object) -> float:
    """Return a length from a text with a unit (`_Metres`), or from a number in units of the aperture's radius."""
    if isinstance(value, str):
        return _Metres(finite(parse_length(value, "50 mm")))
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise ValueError(f"must be a length with a unit or a number in aperture radii, got {validation.shown(value)}")
    return finite(float(value))


_Extent = Annotated[float, PlainValidator(_extent)]
_Point = tuple[_Extent, _Extent]


def _relative(extent: float, radius: float) -> float:
    """Return an extent in units of the aperture's radius (metres)."""
    return float(extent) / radius if isinstance(extent, _Metres) else extent


def _place(point: tuple[float, float], radius: float) -> tuple[float, float]:
    return _relative(point[0], radius), _relative(point[1], radius)


# Required and optional keys of each type of shape.
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
    def fault(cls, entries: Toml) -> str | None:
        """Return the error message for missing or superfluous keys of this type of shape."""
        kind = entries.get("type")
        if not isinstance(kind, str) or kind not in _KEYS:
            return None
        required, allowed = _KEYS[kind]
        if missing_keys := sorted(required - set(entries)):
            return f"a {kind} needs {', '.join(missing_keys)}"
        extra_keys = sorted((set(entries) & set(cls.model_fields)) - required - allowed - {"type"})
        return f"{', '.join(extra_keys)} has no meaning for a {kind}" if extra_keys else None

    def build(self, radius: float) -> Shape:
        """Return the shape in an aperture of this radius, metres."""
        size, center = _relative(self.radius, radius), _place(self.center, radius)
        if self.type == "disc":
            return Disc(size, center)
        if self.type == "hexagon":
            return Polygon.regular(6, size, center, self.angle)
        if self.type == "ellipse":
            return Ellipse(_relative(self.a, radius), _relative(self.b, radius), self.angle, center)
        if self.type == "strip":
            return Polygon.strip(_place(self.start, radius), _place(self.end, radius), _relative(self.width, radius))
        return Polygon(tuple(_place(corner, radius) for corner in self.corners))


class _Segments(Section):
    rings: Annotated[int, Field(strict=True, ge=1, le=32)] | None = None
    gap: _Extent = 0.0
    middle: Annotated[bool, Field(strict=True)] = False
    angle: Angle = 0.0
    piston: list[Number] | None = None
    tip: list[Number] | None = None
    tilt: list[Number] | None = None

    @classmethod
    def fault(cls, entries: Toml) -> str | None:
        """Return the error message for keys that have no meaning."""
        extra = sorted({"gap", "middle", "angle"} & set(entries))
        return f"{', '.join(extra)} has no meaning without rings" if extra and "rings" not in entries else None

    def phased(self, segments: Segments) -> Segments:
        """Return segments with the phases that the section states in waves."""
        phases = {name: part for name in _PHASES if (part := getattr(self, name)) is not None}
        for name, part in phases.items():
            if len(part) != len(segments.shapes):
                message = f"must have one number for each of {len(segments.shapes)} segments, got {len(part)}"
                raise PartsError([(("aperture", "segments", name), f"aperture.segments.{name}", message)])
        return segments.phased(*(phases.get(name, 0.0) for name in _PHASES), unit="waves")


_PHASES = ("piston", "tip", "tilt")


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
    def fault(cls, entries: Toml) -> str | None:
        """Return the error message for entries that exclude each other."""
        if {"ellipse", "cat_eye"} <= set(entries):
            return "must have at most one of ellipse and cat_eye, got both"
        segments, telescope = entries.get("segments"), entries.get("telescope")
        has_segments = telescope in ("elt", "jwst", "keck")
        if isinstance(segments, dict) and ("rings" not in segments) != has_segments:
            return "segments needs rings or a telescope with segments (elt, jwst, keck): exactly one of them"
        if telescope is not None and not has_segments and segments is not None:
            return f"takes one of segments and telescope, got telescope = {validation.shown(telescope)}"
        return None

    def shapes(self, radius: float) -> Toml:
        """Return arguments of :class:`lommel.Lens` that describe an aperture of this radius, metres.

        Raises PartsError with the errors of all parts.
        """
        faults = _ErrorCollector()
        spider, edge = self.spider, self.ellipse or self.cat_eye
        options = {"vignetting": edge and edge.build(), "mask": self.mask and self.mask.file}
        if spider is not None:
            options["spider"] = faults.attempt(("spider", "width"), "spider.width", lambda: spider.spider(radius))
        stop = self._telescope_stop(radius, faults)
        clear, blocked = (_union(name, getattr(self, name), radius, faults) for name in ("clear", "blocked"))
        faults.raise_errors()
        if clear is not None:
            stop = clear if stop is None else stop & clear
        # Blocked parts without clear parts are subtracted from the full disc.
        if blocked is not None:
            stop = (Disc() if stop is None else stop) - blocked
        options["stop"] = stop
        return {name: shape for name, shape in options.items() if shape is not None}

    def _telescope_stop(self, radius: float, faults: _ErrorCollector) -> Shape | Segments | None:
        """Return the stop of `telescope` or of the rings of `segments`, with the segments' phases; None without."""
        stop: Shape | Segments | None = None
        if self.telescope is not None:
            stop = getattr(telescopes, self.telescope)()
        segments = self.segments
        if segments is None:
            return stop
        if segments.rings is not None:
            rings, gap = segments.rings, _relative(segments.gap, radius)
            stop = faults.attempt(
                ("segments", "gap"),
                "segments",
                lambda: Segments.hexagonal(rings, gap, middle=segments.middle, angle=segments.angle),
            )
        return (
            faults.attempt(("segments",), "segments", lambda: segments.phased(stop))
            if isinstance(stop, Segments)
            else stop
        )


class _ErrorCollector:
    """List of errors of the parts of an aperture, which are raised together."""

    def __init__(self) -> None:
        self.faults: list[tuple[tuple[str, ...], str, str]] = []

    def attempt(self, keys: tuple[str, ...], name: str, compute: Callable[[], _Result]) -> _Result | None:
        """Return the result of `compute`; if it raises an error, collect the error and return None."""
        try:
            return compute()
        except PartsError as error:
            self.faults += error.faults
        except ValueError as error:
            self.faults.append((("aperture", *keys), f"aperture.{name}", str(error)))
        return None

    def raise_errors(self) -> None:
        """Raise PartsError with all collected errors, if there are any."""
        if self.faults:
            raise PartsError(self.faults)


def _union(name: str, parts: list[_Part] | None, radius: float, faults: _ErrorCollector) -> Shape | None:
    """Return the union of the shapes of `parts`, None if there are no valid parts."""

    def build(part: _Part) -> Shape:
        shape = part.build(radius)
        require_reach("it", shape)
        return shape

    shapes = [
        faults.attempt((name, str(k)), f"{name}, entry {k + 1}, {part.type}", partial(build, part))
        for k, part in enumerate(parts or [])
    ]
    valid_shapes = [shape for shape in shapes if shape is not None]
    return reduce(or_, valid_shapes) if valid_shapes else None


def _lengths(value: Any, info: ValidationInfo) -> Any:
    """Return a length in metres, or a tuple of lengths for a list."""
    example = {"focal_length": "50 mm", "focus_distance": "2 m"}.get(info.field_name or "", "3.45 um")
    if isinstance(value, list):
        return tuple(parse_length(text, example) for text in value)
    return parse_length(value, example)


def _numbers(value: object) -> Any:
    return tuple(value) if isinstance(value, list) else value


_Lengths = Annotated[float | tuple[float, float], BeforeValidator(_lengths)]
_Numbers = Annotated[Number | tuple[Number, Number], BeforeValidator(_numbers)]


class _LensRanges(Section):
    focal_length: _Lengths
    f_number: _Numbers
    focus_distance: _Lengths
    wavelength: Length = 540e-9


class _AberrationRanges(Section):
    spherical: _Numbers = 0.0


class _Sensor(Section):
    pixel: _Lengths
    shape: Any = None  # ignored: the window of PSFs in lens files


class _ObjectRange(Section):
    distance: Any = None  # ignored: the object distance in lens files


class _RangesFile(Section):
    name: str = ""
    source: str = ""
    lens: _LensRanges
    aberrations: _AberrationRanges = Field(default_factory=_AberrationRanges)
    object: _ObjectRange = Field(default_factory=_ObjectRange)
    sensor: _Sensor


def load_lens_ranges(path: str | PathLike[str]) -> LensRanges:
    """Read ranges of lens parameters from a file; LensFileError if it is invalid, OSError if it cannot be read.

    A range is one value or a list of two values. Keys: ``[lens]`` focal_length, f_number, focus_distance, wavelength
    (one value); ``[aberrations]`` spherical (C_s, radians); ``[sensor]`` pixel. Lengths are texts with a unit.
    """
    source = validation.path("path", path)
    text, entries = toml_files.parsed(source)

    def build(file: _RangesFile) -> LensRanges:
        ranges = file.lens.model_dump() | {"spherical": file.aberrations.spherical, "pixel": file.sensor.pixel}
        return LensRanges(**ranges)

    return toml_files.built(source, entries, text, _RangesFile, build)


def _radius(value: str | float) -> str | float:
    """Return a radius, stated as a length or an angle, unchanged if it is valid; ValueError otherwise."""
    if not 0.0 < parse_radius(value, 1.0) < math.inf:
        raise ValueError(f"must be a positive length or angle, got {validation.shown(value)}")
    return value


def _amplitude(value: Any) -> float | Apodization | str:
    """Return the apodization of a lens: a number, coefficients of powers of rho^2 (a list), or "aplanatic"."""
    if value == "aplanatic":
        return "aplanatic"
    powers = value if isinstance(value, list) else [value]
    numbers = not any(isinstance(g, bool) or not isinstance(g, int | float) for g in powers)
    if numbers and isinstance(value, list):
        return Apodization(tuple(value))
    if numbers and 0.0 <= value <= 100.0:
        return float(value)
    raise ValueError(f'must be a number from 0 to 100, a list, or "aplanatic", got {validation.shown(value)}')


class _Seidel(Section):
    W131: Number = 0.0
    W222: Number = 0.0
    W220: Number = 0.0
    W311: Number = 0.0


class _Lens(Section):
    focal_length: Length
    f_number: Annotated[Number, Field(gt=0)] | None = None
    aperture_diameter: Length | None = None
    focus_distance: Distance | None = None
    sensor_distance: Length | None = None
    wavelength: Annotated[Length, AfterValidator(validation.wavelength)]
    obscuration: Annotated[Number, Field(ge=0, lt=1)] = 0.0
    model: Literal["paraxial", "aplanatic"] = "paraxial"
    corrected_for: Literal["object", "focus"] = "object"
    apodization: Annotated[Any, BeforeValidator(_amplitude)] = 0.0

    @classmethod
    def fault(cls, entries: Toml) -> str | None:
        """Return the error message unless one key states the aperture and at most one key states the focus."""
        if ("f_number" in entries) == ("aperture_diameter" in entries):
            got = "both" if "f_number" in entries else "none"
            return f"give exactly one of f_number and aperture_diameter, got {got}"
        if {"focus_distance", "sensor_distance"} <= set(entries):
            return "give at most one of focus_distance and sensor_distance, got both"
        return None


class _Aberrations(_Seidel):
    defocus: Number = 0.0
    spherical: Number = 0.0
    W020: Number = 0.0
    W040: Number = 0.0
    W060: Number = 0.0
    W080: Number = 0.0
    spherical_rms: SignedLength = 0.0
    field: tuple[Number, Number] = (1.0, 0.0)
    zernike: Toml | None = None  # checked by `camera_files.read_zernike`


class VignettingSection(BuiltSection):
    """The section [field.vignetting]: a circle that shifts across the aperture with the image height."""

    height: Annotated[list[SignedLength], Field(min_length=2)]
    shift: list[Number]
    radius: Number | list[Number] = 1.0

    def build(self) -> Vignetting:
        """Return the object for a field map."""
        return Vignetting(self.height, self.shift, self.radius)


class ShadingSection(BuiltSection):
    """The section [field.shading]: relative illumination as a table, or by the cos^4 law."""

    distance: Length | None = None
    height: list[SignedLength] | None = None
    light: list[Number] | None = None

    @classmethod
    def fault(cls, entries: Toml) -> str | None:
        """Return the error message unless exactly `distance`, or exactly `height` and `light`, are present."""
        if {"distance", "height", "light"} & set(entries) in ({"distance"}, {"height", "light"}):
            return None
        return "needs distance (from the exit pupil to the sensor), or height and light: one of the two"

    def build(self) -> Shading:
        """Return the object for a field map."""
        if self.distance is not None:
            return Shading.cos4(self.distance)
        assert self.height is not None and self.light is not None  # noqa: PT018 (see `fault`)
        return Shading(self.height, self.light)


_Wave = Annotated[Length, AfterValidator(validation.wavelength)]
_CSV = "the name of a CSV file"


class ColourSection(BuiltSection):
    """The section [colour] of a lens file."""

    wavelengths: Annotated[list[_Wave], Field(min_length=2)]
    focus_shift: list[SignedLength] | None = None
    lateral: list[SignedLength] | list[list[SignedLength]] | None = None
    heights: Length | list[Length] | None = None

    def build(self) -> Colour:
        """Return the chromatic aberrations."""
        return Colour(**dict(self))


class ChannelsSection(BuiltSection):
    """The section [channels] of a lens file."""

    wavelengths: Annotated[list[_Wave], Field(min_length=1)] | None = None
    weights: dict[str, list[Number]] | None = None
    filters: list[str] = Field(default_factory=list)
    illuminant: str | None = None
    tol: Number = 1e-3
    paths: Length = 5e-6
    file: Any = None  # validation replaces the file name by the channels, which depend on the other keys

    @field_validator("file")
    @classmethod
    def _file(cls, value: object, info: ValidationInfo) -> Any:
        entries = info.data
        if value is None or not {"filters", "illuminant", "tol", "paths"} <= entries.keys():
            return value  # the other keys have errors, which are reported

        def path_of(name: str) -> Path:
            return read_beside(info.context, name, _CSV, lambda path: path)

        illuminant = entries["illuminant"] and path_of(entries["illuminant"])
        settings = {"illuminant": illuminant, "tol": entries["tol"], "paths": entries["paths"]}
        read_channels = partial(load_channels, filters=[path_of(name) for name in entries["filters"]], **settings)
        return read_beside(info.context, value, _CSV, read_channels)

    @classmethod
    def fault(cls, entries: Toml) -> str | None:
        """Return the error message unless exactly one of `file` and `wavelengths` is present, with its options."""
        if ("file" in entries) == ("wavelengths" in entries):
            return "needs file (a table of the sensor) or wavelengths: exactly one of the two"
        source, excluded = "file", {"weights"}
        if "wavelengths" in entries:
            source, excluded = "wavelengths", {"filters", "illuminant", "tol", "paths"}
        extra_keys = sorted(excluded & set(entries))
        return f"{', '.join(extra_keys)} has no meaning with {source}" if extra_keys else None

    def build(self) -> Channels:
        """Return the channels."""
        if isinstance(self.file, Channels):
            return self.file
        assert self.wavelengths is not None
        if self.weights is None:
            return Channels.of_wavelengths(self.wavelengths)
        counts = {len(row) for row in self.weights.values()}
        if counts != {len(self.wavelengths)}:
            raise ValueError(
                f"weights of each channel must be numbers, one for each of {len(self.wavelengths)} wavelengths, "
                f"got {' and '.join(map(str, sorted(counts)))} numbers"
            )
        return Channels(self.wavelengths, list(self.weights.values()), list(self.weights))


class _Object(Section):
    distance: Distance | None = None  # default: the focus distance


_SEIDEL = tuple(_Seidel.model_fields)


class _Field(_Seidel):
    sensor: tuple[Length, Length]
    edge: Length | None = None
    order: Literal["noll", "ansi", "fringe"] = "noll"
    unit: Literal["waves", "radians", "metres"] = "waves"
    normalization: Literal["rms", "edge"] | None = None
    direction: Literal["x", "y"] = "x"
    columns: Annotated[list[str], Field(min_length=1)] | None = None
    # Fields are validated in this order; `rows` and `file`, which need the fields above, are replaced by tables.
    rows: Any = None
    file: Any = None
    vignetting: VignettingSection | None = None
    shading: ShadingSection | None = None

    @field_validator("rows")
    @classmethod
    def _rows(cls, value: object, info: ValidationInfo) -> Any:
        if not isinstance(value, list) or not all(isinstance(row, list) for row in value):
            raise ValueError(f"must be a list of lists, one for each position, got {validation.shown(value)}")
        if not {"order", "columns"} <= info.data.keys():
            return value  # these keys have errors, which are reported
        if info.data["columns"] is None:
            raise ValueError('needs columns, such as columns = ["height", "Z4"]')
        return tables.read_rows(info.data["columns"], value, info.data["order"])

    @field_validator("file")
    @classmethod
    def _file(cls, value: object, info: ValidationInfo) -> Any:
        if "order" not in info.data:
            return value
        read = partial(tables.read_csv, order=info.data["order"])
        return read_beside(info.context, value, "the name of a CSV file", read)

    @classmethod
    def fault(cls, entries: Toml) -> str | None:
        """Return the error message unless the keys describe the field in exactly one way."""
        seidel, of_tables = ", ".join(_SEIDEL), {"order", "unit", "normalization", "direction"}
        # The descriptions of the field, and the keys that each description excludes.
        excluded_keys = {"rows": {"edge"}, "file": {"edge", "columns"}, seidel: {"columns", *of_tables}}
        sources = [source for source in excluded_keys if set(entries) & set(source.split(", "))]
        if len(sources) != 1:
            got = " and ".join(sources) or "none"
            return f"needs Seidel coefficients ({seidel}), rows, or file: one of them, got {got}"
        extra_keys = sorted(excluded_keys[sources[0]] & set(entries))
        if entries.get("order") == "fringe" and "normalization" not in entries and not extra_keys:
            return (
                'needs normalization with order = "fringe": "edge", as most lens design programs list them, or "rms"'
            )
        return f"{', '.join(extra_keys)} has no meaning with {sources[0]}" if extra_keys else None

    def map(self, pupil: Pupil) -> FieldMap:
        """Return the field map, with the aperture and the scale of `pupil`."""
        table: FieldTable | None = self.rows if self.rows is not None else self.file
        if table is not None:
            field_map = table.field_map(
                pupil, unit=self.unit, normalization=self.normalization, direction=self.direction
            )
        else:
            edge = 0.5 * math.hypot(*self.sensor) if self.edge is None else self.edge
            waves = self.model_dump(include=set(_SEIDEL))
            field_map = FieldMap.from_seidel(edge, **waves, aperture=pupil.unaberrated())
        vignetting = None if self.vignetting is None else self.vignetting.build()
        return field_map.seen_through(vignetting, None if self.shading is None else self.shading.build())


class _Report(Section):
    encircled_energy: list[Annotated[Any, BeforeValidator(_radius)]] = Field(default_factory=list)


_Positive = Annotated[Number, Field(gt=0)]


class _Calibration(BuiltSection):
    focus_distances: Annotated[list[Distance], Field(min_length=2)]
    f_numbers: Annotated[list[_Positive], Field(min_length=2)]
    f_number_scale: _Positive
    f_number_error: Annotated[Number, Field(ge=0, lt=0.5)]
    focus_error: Annotated[Number, Field(ge=0)]

    def build(self) -> Calibration:
        """Return the calibration."""
        if len(self.focus_distances) != len(self.f_numbers):
            raise ValueError(f"needs as many f_numbers as focus_distances, {len(self.focus_distances)}")
        foci, numbers = tuple(self.focus_distances), tuple(self.f_numbers)
        return Calibration(foci, numbers, self.f_number_scale, self.f_number_error, self.focus_error)


class _File(Section):
    name: str | None = None
    source: str = ""
    lens: _Lens
    aperture: ApertureSection = ApertureSection()
    aberrations: _Aberrations = _Aberrations()
    object: _Object = _Object()
    sensor: PhotoSensor
    field: _Field | None = None
    colour: ColourSection | None = None
    channels: ChannelsSection | None = None
    report: _Report = _Report()
    calibration: _Calibration | None = None


def load_instrument(path: str | PathLike[str], *, folder_only: bool = False) -> Instrument:
    """Read a lens file in TOML.

    Lengths are texts with a unit (``"50 mm"``, ``"inf"``). Angles are texts with a unit or numbers in radians. File
    names are relative to the folder of the lens file. The keys ``name`` (default: the file's name) and ``source``
    precede these sections:

    ``[lens]``: focal_length, f_number or aperture_diameter, focus_distance or sensor_distance, wavelength,
    obscuration, model ("paraxial" or "aplanatic"), corrected_for ("object" or "focus") and apodization (a number, a
    list as in :class:`lommel.Apodization`, or "aplanatic"). See :class:`lommel.Lens`.

    ``[aberrations]``: defocus and spherical (C_d and C_s, radians); W020, W040, W060, W080 (waves); spherical_rms (a
    length, the rms of balanced primary spherical aberration over the annulus); W131, W222, W220, W311 (waves at the
    edge of the field) with field, a pair [x, y] relative to the edge of the field. ``[aberrations.zernike]`` has
    either order, unit, normalization and terms as in :func:`lommel.load_zernike`, or file, the name of such a table.
    Its wavelength is by default the wavelength of the lens, but a file in waves or radians must state it. All
    aberrations are added.

    ``[object]``: distance (default: the focus distance). ``[sensor]``: either camera (the name of an example or of a
    file for :func:`lommel.load_camera`) or pixel (a length, or ``["4 um", "6 um"]`` for height and width); shape
    (default: a window with about 98 % of the light); integrate (default true: pixels average over their area); fill,
    the active fraction of a pixel's area or of height and width. ``[report]``: encircled_energy, a list of radii on
    the sensor, as lengths or angles.

    ``[aperture]``: its parts act together, at all field positions. ``[aperture.spider]`` has width and either vanes,
    the number of vanes at equal angles from the angle first, or angles, a list (``"45 deg"``, from x to y).
    ``[aperture.ellipse]`` (a, b, angle) and ``[aperture.cat_eye]`` (shift, a pair [x, y], and radius) are in units of
    the aperture's radius. ``[aperture.mask]`` has file, the name of a square array (.npy, .fits) or grey picture
    (.png, .tif), and holds, "amplitude" or "intensity". ``telescope`` is a name in ``lommel.telescopes``.
    ``[aperture.segments]`` has rings, gap, middle and angle of :meth:`lommel.Segments.hexagonal`, and the phases of
    the segments in waves at the wavelength of the lens: lists piston, tip and tilt (a tilt is the phase at one
    aperture radius from the segment's centre). Light passes through the union of the shapes in ``[[aperture.clear]]``
    (by default the whole aperture), except through the shapes in ``[[aperture.blocked]]``. A shape has the type
    "disc" (radius, center), "ellipse" (a, b, angle, center), "polygon" (corners; convex), "hexagon" (radius of its
    corners, center, angle) or "strip" (start, end, width); its lengths are texts with a unit, or numbers in units of
    the aperture's radius.

    ``[field]``: sensor, the height and width of the whole sensor, and one of three descriptions of field-dependent
    aberrations, which are added to the lens aberrations: Seidel coefficients W131, W222, W220, W311 in waves at the
    edge of the field (edge, by default half the diagonal); columns and rows, a table of Zernike coefficients
    (the columns height, or x and y, hold lengths, the others, such as Z4, numbers); or file, a CSV file with such a
    table. Options of tables are order ("noll", "ansi", "fringe"), unit ("waves", "radians", "metres"), normalization
    ("rms", "edge"; stated for Fringe) and direction ("x" or "y", the axis of image heights). ``[field.vignetting]``
    has height, shift and radius of :class:`~lommel.field.maps.Vignetting`. ``[field.shading]`` has either distance,
    from the exit pupil to the sensor, for the cos^4 law, or height and light, a table.

    ``[colour]``: lists wavelengths, focus_shift, lateral and heights of :class:`lommel.Colour`. ``[channels]``:
    either file, a CSV file for :func:`lommel.load_channels`, with its options filters, illuminant, tol and paths; or
    wavelengths, and weights by the name of each channel (``weights.red = [0.1, 0.9]``). Without weights each
    wavelength is a channel.

    ``[calibration]``, which :meth:`lommel.imaging.FocalCalibration.save` writes: lists focus_distances and f_numbers
    of photographs for depth from defocus, f_number_scale (true / engraved), f_number_error and focus_error (1/m).

    Parameters
    ----------
    path : path
        Lens file.
    folder_only : bool, default False
        Reject tables and masks outside the folder of the lens file. Error messages quote parts of such files, so that
        a service for untrusted lens files should set this option.

    Returns
    -------
    Instrument
        Lens, object and sensor.

    Raises
    ------
    LensFileError
        If the file is not valid TOML, or if entries are missing, unknown or invalid. All errors are reported
        together, with keys and line numbers.
    OSError
        If the file cannot be read.
    """
    source = validation.path("path", path)
    text, entries = toml_files.parsed(source)
    if "objective" in entries and "lens" not in entries:
        raise LensFileError(
            f"{validation.line(source)}: describes a microscope, [objective], not a lens: use lommel.load_microscope "
            "or one of the commands info, psf, beads and localize"
        )
    context: Context = {"folder": source.parent, "folder_only": validation.truth("folder_only", folder_only)}
    table, errors = camera_files.read_zernike(entries, text, context)
    build = partial(_instrument, table=table, stem=source.stem)
    return toml_files.built(source, entries, text, _File, build, context=context, earlier_errors=tuple(errors))


def _instrument(file: _File, *, table: ZernikeTable | None, stem: str) -> Instrument:
    """Return the instrument of a validated file; `stem` is its default name."""
    wavelength = file.lens.wavelength
    tell_wavelength(wavelength)
    terms = file.aberrations
    # Rms of balanced spherical aberration, converted from a path length to radians.
    rms = 2.0 * math.pi * terms.spherical_rms / wavelength
    seidel = terms.model_dump(exclude={"defocus", "spherical", "spherical_rms", "zernike"})
    aberrations = Wavefront(terms.defocus, terms.spherical) + Wavefront.from_seidel(**seidel)
    aberrations += Wavefront.balanced_spherical(rms, file.lens.obscuration)
    if table is not None:
        aberrations += camera_files.wavefront_of(table, wavelength)
    options: Toml = dict(file.lens) | {"colour": file.colour and file.colour.build()}
    # Lens() warns if an f-number is given with a focal length of several metres, but not if a diameter is given.
    diameter = aperture(file.lens.focal_length, options.pop("f_number"), options.pop("aperture_diameter"))
    options["aperture_diameter"] = diameter
    radius = 0.5 * Lens(**options).aperture_diameter
    shapes = file.aperture.shapes(radius)
    try:
        lens = Lens(**options, aberrations=aberrations, **shapes)
    except ValueError as error:
        raise ValueError(f"aperture: {error}" if shapes else str(error)) from None
    radii = {str(text): parse_radius(text, lens.focal_length) for text in file.report.encircled_energy}
    distance = lens.focus_distance if file.object.distance is None else file.object.distance
    if distance < 0.0:
        raise ValueError(
            "object.distance: must be given for a sensor closer than the focal length, since no object is in focus"
        )
    name, pixels = stem if file.name is None else file.name, dict(file.sensor)
    pixels["calibration"] = None if file.calibration is None else file.calibration.build()
    channels = None if file.channels is None else file.channels.build()
    instrument = Instrument(name, file.source, lens, distance, radii=radii, channels=channels, **pixels)
    if file.field is None:
        return instrument
    try:
        field_map = file.field.map(instrument.pupil())
        return replace(instrument, sensor=file.field.sensor, aberrations_of_field=field_map)
    except ValueError as error:
        raise ValueError(f"field: {error}") from None
