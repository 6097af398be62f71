"""Stacks that microscopes recorded: OME-TIFF, TIFF of ImageJ and OME-Zarr, read lazily with their metadata."""

from __future__ import annotations

import errno
import math
import operator
import re
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from os import PathLike
from pathlib import Path
from typing import Any, Protocol, Self

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import atomic, optional, reading, validation
from lommel.base.arrays import Values
from lommel.base.units import format_length
from lommel.base.validation import line, shown
from lommel.io import zarr_chunks

_PREFIXES = {
    "yotta": ("Y", 24), "zetta": ("Z", 21), "exa": ("E", 18), "peta": ("P", 15), "tera": ("T", 12), "giga": ("G", 9),
    "mega": ("M", 6), "kilo": ("k", 3), "hecto": ("h", 2), "deca": ("da", 1), "": ("", 0), "deci": ("d", -1),
    "centi": ("c", -2), "milli": ("m", -3), "micro": ("µ", -6), "nano": ("n", -9), "pico": ("p", -12),
    "femto": ("f", -15), "atto": ("a", -18), "zepto": ("z", -21), "yocto": ("y", -24),
}  # fmt: skip
_OTHERS = {
    "um": 1e-6, "\u03bcm": 1e-6, "\\u00B5m": 1e-6, "micron": 1e-6, "microns": 1e-6, "Å": 1e-10, "\u212b": 1e-10,
    "angstrom": 1e-10, "thou": 2.54e-5, "li": 2.54e-2 / 12, "in": 2.54e-2, "inch": 2.54e-2, "inches": 2.54e-2,
    "ft": 0.3048, "foot": 0.3048, "yd": 0.9144, "yard": 0.9144, "mi": 1609.344, "mile": 1609.344, "pt": 2.54e-2 / 72,
    "ua": 149597870700.0, "ly": 9460730472580800.0, "pc": 3.0856775814913674e16, "parsec": 3.0856775814913674e16,
}  # fmt: skip
# Those of the OME schema (UnitsLength), of OME-Zarr and of ImageJ, metres; "Mm" is not "mm".
_UNITS = _OTHERS | {
    name: float(f"1e{power}")
    for prefix, (letter, power) in _PREFIXES.items()
    for name in (f"{letter}m", *(f"{prefix}{metre}{s}" for metre in ("meter", "metre") for s in ("", "s")))
}
_JSON = 2**24  # bytes of a description that are parsed
_DESCRIPTIONS = ("zarr.json", ".zattrs", ".zgroup", ".zarray", ".zmetadata")
_CHUNK = (32, 256, 256)  # of an OME-Zarr that is written
_AXES = "TCZYX"
_CHANNELS = 4096  # of an OME-Zarr
_SHARE = 1e-4  # of lengths that count as equal
_LENGTHS = {"pixel": "pixels of", "down": "pixels of a height of", "step": "planes apart by"}


class RecordingError(ValueError):
    """A file that cannot be read as a stack; the message names it and says what to do."""


@dataclass(frozen=True)
class Unusable:
    """A length that a file states and that cannot be used, in the words of the file; it is not unknown."""

    words: str


class Source(Protocol):
    """Values of shape (channels, planes, height, width), of which a plane at a time is read."""

    shape: tuple[int, int, int, int]
    dtype: np.dtype[Any]

    def plane(self, channel: int, plane: int) -> Values:
        """Return one plane."""


class _Channel:
    """One channel as a stack; ``[planes]`` and ``[planes, rows, columns]`` read it."""

    def __init__(self, source: Source, channel: int) -> None:
        self._source, self._channel = source, channel
        self.shape, self.dtype, self.ndim = source.shape[1:], source.dtype, 3

    def __len__(self) -> int:
        return self.shape[0]

    def __getitem__(self, at: Any) -> Values:
        plane, *part = at if isinstance(at, tuple) else (at,)
        if isinstance(plane, slice):
            numbers = range(*plane.indices(len(self)))
            whole = np.empty((len(numbers), *self.shape[1:]), self.dtype)[:, *part]
            for k, number in enumerate(numbers):
                whole[k] = self[number, *part]
            return whole
        number = operator.index(plane)
        if not -len(self) <= number < len(self):
            raise IndexError(f"plane must be from 0 to {len(self) - 1}, got {number}")
        found = self._source.plane(self._channel, number % len(self))
        return found[tuple(part)] if part else found

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Values:
        out = self[:]
        return out if dtype is None else out.astype(dtype)


class _Held:
    """An array of any package that NumPy can read parts of."""

    def __init__(self, values: Any) -> None:
        self._values = values
        self.shape: tuple[int, int, int, int] = (1,) * (4 - len(values.shape)) + tuple(values.shape)
        self.dtype = np.dtype(values.dtype)

    def plane(self, channel: int, plane: int) -> Values:
        """Return one plane."""
        at: tuple[int, ...] = (channel, plane)[2 - (len(self._values.shape) - 2) :]
        return validation.array("stack", self._values[at])  # of dask, masked or not is known now


class _Mapped:
    """Planes that lie in a file as one piece."""

    def __init__(self, values: Values, places: Values) -> None:
        self._values, self._places = values, places
        self.shape = (*places.shape, *values.shape[1:])
        self.dtype = values.dtype.newbyteorder("=")

    def plane(self, channel: int, plane: int) -> Values:
        """Return one plane."""
        return np.array(self._values[self._places[channel, plane]], self.dtype)


class _Pages:
    """Pages of a TIFF file."""

    def __init__(self, path: Path, pages: Any, places: Values, shape: tuple[int, int], dtype: Any) -> None:
        self._path, self._pages, self._places = path, pages, places
        self.shape = (*places.shape, *shape)
        self.dtype = np.dtype(dtype)
        self._lock = threading.Lock()  # pages share a handle

    def plane(self, channel: int, plane: int) -> Values:
        """Return one plane."""
        number = int(self._places[channel, plane])
        with _told_of(self._path, f"page {number}: "), self._lock:
            page = self._pages[number]
            if page is None:
                raise ValueError("it is missing: the file is cut off, or others of its OME-TIFF are not beside it")
            return reading.tiff_values(page, self.shape[2:], self.dtype)


@dataclass(frozen=True, eq=False, repr=False)
class Recording:
    """A stack that a microscope recorded, with what its file says of it; values stay on the disk until they are read.

    Made by :func:`lommel.microscopy.open_recording`.

    Attributes
    ----------
    shape : tuple of int
        Channels, planes, height, width.
    dtype : dtype
        Of the values as they are stored.
    pixel : float or None
        Side of a pixel in the sample, metres; None if the file does not say.
    step : float or None
        Distance between planes, metres of the stage, not negative; None if the file does not say.
    names : tuple of str
        Of the channels.
    emission, excitation : tuple of float or None
        Wavelength of each channel, metres.
    NA, magnification, immersion : float or None
        Of the objective, if the file says so.
    path : Path or None
    source, closed
        What reads planes, and what closes the file.
    notes : tuple of str
        What was taken from the file, and what it lacks, in sentences.
    unusable : dict
        Lengths that the file states but that cannot be used, such as 0, in its words; by "pixel", "step", or
        "emission" and "excitation" with the number of the channel, such as "emission 0".
    """

    source: Source
    pixel: float | None = None
    step: float | None = None
    names: tuple[str, ...] = ()
    emission: tuple[float | None, ...] = ()
    excitation: tuple[float | None, ...] = ()
    NA: float | None = None
    magnification: float | None = None
    immersion: float | None = None
    path: Path | None = None
    notes: tuple[str, ...] = ()
    unusable: dict[str, str] = field(default_factory=dict)
    closed: Any = field(default=None)

    @property
    def shape(self) -> tuple[int, int, int, int]:  # noqa: D102
        return self.source.shape

    @property
    def dtype(self) -> np.dtype[Any]:  # noqa: D102
        return self.source.dtype

    def __repr__(self) -> str:
        channels, planes, height, width = self.shape
        name = "array" if self.path is None else self.path.name
        sides = "without voxel sizes"
        if self.pixel is not None and self.step is not None:
            sides = f"pixels of {format_length(self.pixel)}, {format_length(self.step)} apart"
        many = f"{channels} channels of " if channels > 1 else ""
        return f"<Recording {name!r}: {many}{planes} planes of {height} x {width}, {self.dtype}, {sides}>"

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Close the file."""
        if self.closed is not None:
            self.closed()

    def stack(self, channel: int = 0) -> Any:
        """Return a channel as a stack of shape (planes, height, width); read by ``[plane]`` and NumPy.

        Parameters
        ----------
        channel : int, default 0

        Raises
        ------
        TypeError, ValueError
            If there is no such channel; RecordingError, when it is read, if the file is damaged.
        """
        number = validation.integer("channel", channel, least=0, most=self.shape[0] - 1)
        return _Channel(self.source, number)


def open_recording(
    path: str | PathLike[str] | ArrayLike | Recording,
    *,
    time: int | None = None,
    axes: str | None = None,
    image: int | None = None,
) -> Recording:
    """Open a stack that a microscope recorded, with its voxel sizes, channels and wavelengths.

    Parameters
    ----------
    path : path or array_like
        An OME-TIFF file, another TIFF file (ImageJ's voxel sizes are read), a folder of OME-Zarr (OME-NGFF 0.4 or
        0.5); or an array of NumPy, dask or Zarr, of shape (planes, height, width) or (channels, planes, height,
        width).
    time : int, optional
        Which time point, from 0; needed where the file holds several.
    axes : str, optional
        Letters of the axes, such as "ZYX" or "CZYX", where the file does not state them or is wrong.
    image : int, optional
        Which image of a TIFF file that holds several, from 0; by default that of the most values.

    Returns
    -------
    Recording

    Raises
    ------
    RecordingError
        If the file is damaged, holds colours (RGB), several time points without `time`, or axes that are unknown.
    TypeError, ValueError
        If an argument is out of range.
    OSError, ImportError
        If the file cannot be read, or tifffile or zarr is not installed.

    See Also
    --------
    lommel.microscopy.restore
    """
    if isinstance(path, Recording):
        return path
    if axes is not None and (not isinstance(axes, str) or not re.fullmatch(r"[TCZ]*YX", axes)):
        raise ValueError(f'axes must be letters of TCZYX that end in YX, such as "ZYX", got {shown(axes)}')
    if time is not None:
        validation.integer("time", time, least=0, most=validation.MAX_VALUES)
    if image is not None:
        validation.integer("image", image, least=0, most=validation.MAX_VALUES)
    if not isinstance(path, str | PathLike):
        values = path if hasattr(path, "shape") and hasattr(path, "dtype") else validation.array("stack", path)
        validation.refuse_masked("stack", values)
        return _of_array(values, axes)
    where = validation.path("path", path)
    if where.is_dir():
        with _told_of(where):
            return _zarr(where, time, axes)
    return _tiff(where, time, axes, image)


def _of_array(values: Any, axes: str | None) -> Recording:
    sides = len(values.shape)
    if axes in ("CZYX", "ZYX") and len(axes) != sides:
        raise ValueError(f"axes must have a letter for each of {sides} axes, got {shown(axes)}")
    if axes not in (None, "CZYX", "ZYX"):
        raise ValueError(f'axes of an array must be "ZYX" or "CZYX", got {shown(axes)}; index or transpose it first')
    _numbers("stack", values.dtype)
    if sides not in (3, 4):
        raise ValueError(
            f"stack must have the shape (planes, height, width) or (channels, planes, height, width), got "
            f"{tuple(values.shape)}"
        )
    if 0 in values.shape:
        raise ValueError(f"stack must have planes, rows and columns, got the shape {tuple(values.shape)}")
    count = values.shape[0] if sides == 4 else 1
    nothing = (None,) * count
    return Recording(_Held(values), names=_names([], count), emission=nothing, excitation=nothing)


def _numbers(name: str, dtype: Any) -> None:
    if np.dtype(dtype).kind not in "iufb":
        raise TypeError(f"{name} must hold real numbers, got {np.dtype(dtype)}")


def _names(given: Sequence[str | None], count: int) -> tuple[str, ...]:
    return tuple((given[k] if k < len(given) else None) or f"channel {k}" for k in range(count))


@contextmanager
def _told_of(path: Path, part: str = "") -> Iterator[None]:
    """Tell the errors of libraries, of any kind, in a sentence that names the file."""
    try:
        with reading.quietly():
            yield
    except RecordingError:
        raise
    except Exception as error:
        if isinstance(error, OSError) and error.filename is not None:
            raise
        raise RecordingError(f"{line(path)}: {part}{reading.reason(error)}") from None


def _tiff(path: Path, time: int | None, axes: str | None, image: int | None) -> Recording:
    optional.require("tifffile", "reading TIFF files needs", "images")
    with _told_of(path):
        file, errors = reading.tiff_on_disk(path)
        try:
            if errors:
                raise RecordingError(f"{line(path)}: it is cut off or damaged: {validation.brief(errors[0])}")
            return _tiff_recording(path, file, time, axes, image)
        except BaseException:
            file.close()
            raise


def _tiff_recording(path: Path, file: Any, time: int | None, axes: str | None, image: int | None) -> Recording:
    notes: list[str] = []
    number = max(range(len(file.series)), key=lambda k: math.prod(file.series[k].shape)) if image is None else image
    series = file.series[validation.integer("image", number, least=0, most=len(file.series) - 1)]
    if len(file.series) > 1 and image is None:
        sides = ", ".join(" x ".join(map(str, one.shape)) for one in file.series[:4])
        more = ", ..." if len(file.series) > 4 else ""
        notes.append(
            f"The file holds {len(file.series)} images ({sides}{more}); image {number}, counted from 0, was taken; "
            "image= takes another."
        )
    if words := reading.tiff_left_out(file):
        notes.append(f"The file holds {words}; the others were left out.")
    letters: str = series.axes
    lengths: tuple[int, ...] = tuple(series.shape)
    if "S" in letters:
        raise RecordingError(f"{line(path)}: it holds colours (RGB); save each channel in grey")
    plain: dict[str, int] = {}
    plain.update((letter, side) for letter, side in zip(letters, lengths, strict=True) if side != 1 or letter in "YX")
    if axes is not None:
        given = [side for side in lengths if side != 1 or len(lengths) == len(axes)]
        if len(given) != len(axes):
            raise RecordingError(f"{line(path)}: axes={axes!r} does not fit its shape {lengths}")
        plain = dict(zip(axes, given, strict=True))
        order = axes
    else:
        order = "".join(letter for letter in letters if letter in plain)
    unknown = [letter for letter in order if letter not in _AXES]
    if unknown:
        raise RecordingError(
            f"{line(path)}: what its axis of {plain[unknown[0]]} images is, the file does not say; "
            f'state it, such as axes="ZYX" for planes along z'
        )
    _numbers(line(path), series.dtype)
    if "T" in plain and "Z" not in plain and time is None:
        raise RecordingError(
            f"{line(path)}: it is a time series of {plain['T']} images without planes along z; if these are planes, "
            'state axes="ZYX"'
        )
    lead = [letter for letter in order if letter not in "YX"]
    mapped = reading.tiff_mapped(file, series, path, math.prod(plain[letter] for letter in lead))
    numbers = np.arange(math.prod(plain[letter] for letter in lead)).reshape([plain[letter] for letter in lead])
    numbers = _without_time(path, numbers, lead, time)
    lead = [letter for letter in lead if letter != "T"]
    for place, letter in enumerate("CZ"):
        if letter not in lead:
            numbers = np.expand_dims(numbers, place)
            lead.insert(place, letter)
    numbers = np.transpose(numbers, [lead.index("C"), lead.index("Z")])
    made = Recording(
        _Pages(path, series.pages, numbers, (plain["Y"], plain["X"]), series.dtype)
        if mapped is None
        else _Mapped(mapped, numbers)
    )
    found = _ome(file, number) if file.is_ome else _imagej(file) if file.is_imagej else {}
    told = "OME" if file.is_ome else "ImageJ"
    return _told(replace(made, path=path, closed=file.close), found, told, notes)


def _without_time(path: Path, numbers: Values, lead: list[str], time: int | None) -> Values:
    if "T" not in lead:
        return numbers
    axis = lead.index("T")
    count = numbers.shape[axis]
    if time is None:
        raise RecordingError(
            f"{line(path)}: it holds {count} time points; say which with time=, from 0 to {count - 1}, or restore "
            "each in turn"
        )
    return np.asarray(np.take(numbers, validation.integer("time", time, least=0, most=count - 1), axis=axis))


def _told(made: Recording, found: dict[str, Any], told: str, notes: list[str]) -> Recording:
    """Return a recording with what its file says, checked."""
    count, name = made.shape[0], line(made.path or "")
    unusable: dict[str, str] = {}

    def usable(key: str, words: str, value: float | Unusable | None) -> float | None:
        if isinstance(value, float) and not (1e-12 < value < 1e-3):
            value = Unusable(f"{value:g} m")
        if not isinstance(value, Unusable):
            return value
        unusable[key] = value.words
        notes.append(f"The file says {words} {value.words}, which cannot be used.")
        return None

    sides = {key: usable("pixel" if key == "down" else key, _LENGTHS[key], found.get(key)) for key in _LENGTHS}
    across, down = sides.pop("pixel"), sides.pop("down")
    if across and down and abs(across - down) > _SHARE * across:
        raise RecordingError(
            f"{name}: its pixels are {format_length(down)} high and {format_length(across)} wide; resample it to "
            "square ones"
        )
    others: dict[str, Any] = {key: found.get(key) for key in ("NA", "magnification", "immersion")}
    others |= {"pixel": None if "pixel" in unusable else across, "step": sides["step"]}
    words = (("pixel", "pixels"), ("step", "planes apart"))
    taken = [f"{format_length(others[key])} {of}" for key, of in words if others[key] is not None]
    if taken:
        notes.append(f"From the {told} metadata of the file: {', '.join(taken)}.")
    for key in ("emission", "excitation"):
        each = (list(found.get(key, [])) + [None] * count)[:count]
        others[key] = tuple(
            usable(f"{key} {k}", f"that the {key} of channel {k} is", wave) for k, wave in enumerate(each)
        )
    names = _names(found.get("names", []), count)
    return replace(made, **others, names=names, notes=tuple(notes), unusable=unusable)


def _length(value: Any, unit: Any, default: str = "") -> float | Unusable | None:
    """Return a length in metres, what the file says of it where that is none, or None where it says nothing."""
    if value is None or value == "":
        return None
    named = str(unit or default).strip()
    words = validation.brief(f"{value} {named}".strip(), 60)
    try:
        number = abs(float(value))
    except (TypeError, ValueError):
        return Unusable(words)
    if number == 1.0 and named in ("", "pixel", "pixels"):  # what is written of no scale
        return None
    scale = _UNITS.get(named) or (_UNITS.get(named.lower()) if len(named) > 3 else None)
    if not named:
        words += " without a unit"
    return number * scale if scale and math.isfinite(number) and number > 0.0 else Unusable(words)


def _number(value: Any) -> float | None:
    try:
        found = float(value)
    except (TypeError, ValueError):
        return None
    return found if math.isfinite(found) and found > 0.0 else None


def _ome(file: Any, number: int) -> dict[str, Any]:
    """Return what OME-XML says of an image."""
    try:
        root = reading.xml(file.ome_metadata or "")
    except ValueError:
        return {}
    images = [one for one in root.findall("{*}Image") if one.find("{*}Pixels") is not None]
    if len(images) != len(file.series):  # tifffile leaves out those without pixels
        images = [one for one in images if one.get("Name") == file.series[number].name][:1] * (number + 1)
    if not images:
        return {}
    image = images[number]
    pixels = image.find("{*}Pixels")

    def side(letter: str) -> float | Unusable | None:
        name = f"PhysicalSize{letter}"
        return _length(pixels.get(name), pixels.get(f"{name}Unit"), "µm")

    found: dict[str, Any] = {"pixel": side("X"), "down": side("Y"), "step": side("Z")}
    channels = pixels.findall("{*}Channel")
    found["names"] = [each.get("Name") for each in channels]
    for key, name in (("emission", "EmissionWavelength"), ("excitation", "ExcitationWavelength")):
        found[key] = [_length(each.get(name), each.get(f"{name}Unit"), "nm") for each in channels]
    lenses = root.findall(".//{*}Instrument/{*}Objective")
    if (used := image.find("{*}ObjectiveSettings")) is not None:
        found["immersion"] = _number(used.get("RefractiveIndex"))
        lenses = [lens for lens in lenses if lens.get("ID") == used.get("ID")] or lenses
    if lenses:
        found["NA"] = _number(lenses[0].get("LensNA"))
        found["magnification"] = _number(
            lenses[0].get("CalibratedMagnification") or lenses[0].get("NominalMagnification")
        )
    return found


def _imagej(file: Any) -> dict[str, Any]:
    """Return what ImageJ says."""
    told, page = file.imagej_metadata or {}, file.pages[0]
    unit = told.get("unit")  # of the others, too, unless they have their own
    found: dict[str, Any] = {"step": _length(told.get("spacing"), told.get("zunit", unit))}
    for key, tag, own in (("pixel", "XResolution", unit), ("down", "YResolution", told.get("yunit", unit))):
        value = page.tags.get(tag)
        if value is not None and own:  # without a unit it is the resolution in print
            pixels, units = value.value
            found[key] = _length(units / pixels if pixels else 0.0, own)
    return found


def _zarr(path: Path, time: int | None, axes: str | None) -> Recording:
    zarr = optional.library("zarr", "reading OME-Zarr needs", "zarr")
    try:
        _look(path, "")
        group = zarr.open(zarr_chunks.store(path), mode="r")
    except Exception as error:  # of any kind
        raise RecordingError(f"{line(path)}: no OME-Zarr: {reading.reason(error)}") from None
    if not hasattr(group, "attrs") or hasattr(group, "dtype"):
        raise RecordingError(f"{line(path)}: it is an array without OME metadata; pass zarr.open(...) and pixel=")
    attributes = dict(group.attrs)
    told = attributes.get("ome", attributes)
    try:
        scales = told["multiscales"][0]
        names = [axis["name"] if isinstance(axis, dict) else str(axis) for axis in scales["axes"]]
        units = [axis.get("unit") if isinstance(axis, dict) else None for axis in scales["axes"]]
        first = scales["datasets"][0]
        _look(path, f"{first['path']}/")
        array = group[first["path"]]
        moves = [*first.get("coordinateTransformations", []), *scales.get("coordinateTransformations", [])]
        scale = np.ones(len(names))
        for move in moves:
            if move.get("type") == "scale":
                scale = scale * np.asarray(move["scale"], float)
    except Exception as error:  # of any kind
        raise RecordingError(
            f"{line(path)}: its multiscales are not those of an OME-Zarr ({reading.reason(error)})"
        ) from None
    order = axes or "".join(names).upper()
    if not re.fullmatch(r"[TCZ]*YX", order) or len(order) != array.ndim or len(set(order)) != len(order):
        raise RecordingError(f"{line(path)}: its axes are {shown(order)}, not some of t, c, z, y, x in this order")
    _numbers(line(path), array.dtype)
    at: list[Any] = [slice(None)] * array.ndim
    if "T" in order:
        count = array.shape[order.index("T")]
        if count > 1 and time is None:
            raise RecordingError(f"{line(path)}: it holds {count} time points; say which with time=")
        at[order.index("T")] = validation.integer("time", time or 0, least=0, most=count - 1)
    sizes = {letter: _length(float(value), unit) for letter, value, unit in zip(order, scale, units, strict=False)}
    found: dict[str, Any] = {"pixel": sizes.get("X"), "down": sizes.get("Y"), "step": sizes.get("Z")}
    listed = told.get("omero", attributes.get("omero", {})) or {}
    channels = listed.get("channels", []) if isinstance(listed, dict) else []
    found["names"] = [each.get("label") for each in channels if isinstance(each, dict)]
    found["emission"] = [
        _length(each.get("emission_wavelength"), "nm") for each in channels if isinstance(each, dict)
    ]
    source = _Chunked(path, array, order, at)
    missing, total = source.chunks.missing()
    notes = []
    if missing:
        notes.append(
            f"{missing} of the {total} chunks of the folder are missing and count as {array.fill_value}: they were "
            "empty, or the copy is not complete."
        )
    return _told(Recording(source, path=path), found, "OME-Zarr", notes)


def _look(folder: Path, below: str) -> None:
    """Parse the descriptions in a folder of Zarr, as zarr will; ValueError or OSError if it would cost too much."""
    for name in _DESCRIPTIONS:
        if zarr_chunks.regular(folder, below + name) is not None:
            try:
                reading.json(reading.contents(folder / below / name, _JSON))
            except ValueError as error:
                raise ValueError(f"{name}: {reading.reason(error)}") from None


class _Chunked:
    """An array of Zarr, whose chunks are read once for a plane."""

    def __init__(self, path: Path, array: Any, order: str, at: list[Any]) -> None:
        self._path, self._array, self._order = path, array, order
        self._sides = list(zip(at, array.shape, strict=True))
        sides = dict(zip(order, array.shape, strict=True))
        self.shape = (sides.get("C", 1), sides.get("Z", 1), sides["Y"], sides["X"])
        self.dtype = np.dtype(array.dtype)
        if self.shape[0] > _CHANNELS:
            raise ValueError(f"it has {self.shape[0]} channels; the limit is {_CHANNELS}")
        reading.pixels(*self.shape[:1:-1])
        self.chunks = zarr_chunks.Chunks(path, array)
        self._deep: int = array.chunks[order.index("Z")] if "Z" in order else 1  # planes that are read at once
        self._block: tuple[int, int, Values] | None = None
        self._lock = threading.Lock()

    def plane(self, channel: int, plane: int) -> Values:
        """Return one plane."""
        with _told_of(self._path, f"plane {plane}: "), self._lock:  # each chunk is read once
            return self._read(channel, plane)

    def _read(self, channel: int, plane: int) -> Values:
        first = plane - plane % self._deep
        block = self._block
        if block is None or block[:2] != (channel, first):
            places = [range(side) if one == slice(None) else range(one, one + 1) for one, side in self._sides]
            for letter, chosen in (
                ("C", range(channel, channel + 1)),
                ("Z", range(first, min(first + self._deep, self.shape[1]))),
            ):
                if letter in self._order:
                    places[self._order.index(letter)] = chosen
            self._block = None
            memory, held = self.chunks.check(places)
            if self._deep > 1 and not reading.affords(memory, held):
                self._deep = 1
                return self._read(channel, plane)
            reading.afford(memory, held)
            part = self._array[tuple(slice(one.start, one.stop) for one in places)]
            self._block = block = channel, first, np.asarray(part).reshape(-1, *self.shape[2:])
        return np.array(block[2][plane - first])


def save_stack(path: Path, values: Values, recording: Recording, description: str = "") -> None:
    """Write a stack, of shape (channels, planes, height, width), with the metadata of its recording, atomically.

    As OME-TIFF where the name ends in .tif or .tiff, as OME-Zarr (0.4) where it ends in .zarr.
    """
    if kind_of(path) == "zarr":
        atomic.write_folder(path, lambda folder: _fill_zarr(folder, values, recording, path.stem, description))
    else:
        atomic.write_by(path, lambda target: _fill_tiff(target, values, recording, description))


def kind_of(path: Path, recording: str | Path | None = None) -> str:
    """Return the format of a stack that can be written, unless that would replace the recording it was made from.

    ValueError for these, and for other formats; FileExistsError for a folder of something else; ImportError without
    the library.
    """
    if recording is not None and path.resolve() == Path(recording).resolve():
        raise ValueError(f"the restored stack must not replace the recording, got {line(path)} for both")
    name = path.name.lower()
    if name.endswith(".zarr"):
        optional.require("zarr", "writing OME-Zarr needs", "zarr")
        require_own(path)
        return "zarr"
    if name.endswith((".tif", ".tiff")):
        optional.require("tifffile", "writing OME-TIFF needs", "images")
        return "tiff"
    raise ValueError(f"a stack must end in .ome.tif or .ome.zarr, got {shown(path.name)}")


def require_own(path: Path) -> None:
    """Raise FileExistsError if a path holds anything but a stack that was written here, which may be replaced."""
    own = not (path.exists() or path.is_symlink())
    if not own:
        with suppress(OSError, ValueError):
            own = "lommel" in reading.json(reading.contents(path / ".zattrs", _JSON))
    if not own:
        raise FileExistsError(errno.EEXIST, "holds no restored stack, and is not replaced", str(path))


def _fill_tiff(target: Path, values: Values, recording: Recording, description: str) -> None:
    import tifffile

    fields: dict[str, Any] = {"axes": "CZYX", "Description": description}
    for key, letters in (("pixel", "XY"), ("step", "Z")):
        if (value := getattr(recording, key)) is not None:
            for letter in letters:
                fields[f"PhysicalSize{letter}"] = float(f"{1e6 * value:.12g}")
                fields[f"PhysicalSize{letter}Unit"] = "µm"
    channel: dict[str, Any] = {"Name": list(recording.names)}
    for key, name in (("emission", "EmissionWavelength"), ("excitation", "ExcitationWavelength")):
        waves = getattr(recording, key)
        if waves and all(wave is not None for wave in waves):
            channel |= {name: [float(f"{1e9 * wave:.12g}") for wave in waves], f"{name}Unit": ["nm"] * len(waves)}
    fields["Channel"] = channel
    big = values.nbytes > 2**32 - 2**25
    tifffile.imwrite(target, values, ome=True, metadata=fields, photometric="minisblack", bigtiff=big)


def new_zarr(folder: Path, shape: tuple[int, ...], recording: Recording, name: str, description: str = "") -> Any:
    """Return the array of a new OME-Zarr (0.4) of float32, of shape (channels, planes, height, width)."""
    import zarr

    group = zarr.create_group(str(folder), zarr_format=2)
    sides = [1.0]
    known_sides = (recording.step, recording.pixel, recording.pixel)
    sides += [1.0 if value is None else float(f"{1e6 * value:.12g}") for value in known_sides]
    known = recording.pixel is not None and recording.step is not None
    space = [{"name": name, "type": "space"} | ({"unit": "micrometer"} if known else {}) for name in "zyx"]
    group.attrs["multiscales"] = [
        {
            "version": "0.4",
            "name": name,
            "axes": [{"name": "c", "type": "channel"}, *space],
            "datasets": [{"path": "0", "coordinateTransformations": [{"type": "scale", "scale": sides}]}],
        }
    ]
    channels: list[Any] = [{"label": name, "active": True, "color": "FFFFFF"} for name in recording.names]
    for each, wave in zip(channels, recording.emission, strict=False):
        if wave is not None:
            each["emission_wavelength"] = float(f"{1e9 * wave:.12g}")
    group.attrs["omero"] = {"channels": channels}
    group.attrs["lommel"] = {"description": description}
    chunks = (1, *(min(most, side) for most, side in zip(_CHUNK, shape[1:], strict=True)))
    return group.create_array(
        "0", shape=shape, dtype="float32", chunks=chunks, chunk_key_encoding={"name": "v2", "separator": "/"}
    )


def _fill_zarr(folder: Path, values: Values, recording: Recording, name: str, description: str) -> None:
    array = new_zarr(folder, values.shape, recording, name, description)
    for channel in range(values.shape[0]):
        for plane in range(0, values.shape[1], _CHUNK[0]):
            array[channel, plane : plane + _CHUNK[0]] = values[channel, plane : plane + _CHUNK[0]]
