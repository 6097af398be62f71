"""Zygo's files of interferograms: MetroPro's binary .dat, and Mx's .datx, which is HDF5."""

from __future__ import annotations

import struct
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base import reading, validation
from lommel.optics.opd import OPDMap

_MAGIC = (0x881B036F, 0x881B0370, 0x881B0371)
_HEADERS = (834, 4096)  # bytes
_INVALID = 2147483640
_STEPS = {0: 4096, 1: 32768, 2: 131072}  # of a fringe, by the resolution of the phase
_SCALE = 0.5  # waves a fringe: light goes there and back
_LENGTHS = {"NanoMeters": "nm", "MicroMeters": "um", "MilliMeters": "mm", "Meters": "m", "Waves": "waves"}


class Measured(NamedTuple):
    """What a file says of a map: its values, and what it states of the unit, the spacing and the wavelength."""

    values: NDArray[Any]
    unit: str | None = None
    spacing: float | None = None
    wavelength: float | None = None


def read_dat(data: bytes) -> Measured:
    """Return the map in a file of MetroPro, whose numbers are big-endian and at fixed places."""

    def at(place: int, kind: str) -> Any:
        return struct.unpack_from(">" + kind, data, place)[0]

    if len(data) < _HEADERS[0] or at(0, "I") not in _MAGIC:
        raise ValueError("it does not begin as a file of MetroPro")
    size = at(6, "I")
    if size not in _HEADERS:
        raise ValueError(f"its header has {size} bytes; 834 or 4096 are known")
    intensity = 2 * at(52, "H") * at(54, "H") * max(at(56, "H"), 1)
    width, height, steps = at(68, "H"), at(70, "H"), _STEPS.get(at(218, "H"))
    if steps is None:
        raise ValueError(f"its phase has the resolution {at(218, 'H')}; 0 to 2 are known")
    reading.pixels(width, height)
    start = size + intensity
    if start + 4 * width * height > len(data):
        raise ValueError(f"{width} x {height} values end beyond its {len(data)} bytes")
    scale, wavelength, obliquity, spacing = (at(place, "f") for place in (164, 168, 176, 184))
    for name, value in (("scale factor", scale), ("wavelength", wavelength), ("obliquity factor", obliquity)):
        validation.real(f"its {name}", value, above=0.0)
    validation.real("its lateral resolution", spacing, least=0.0)
    phase = np.frombuffer(data, ">i4", width * height, start).reshape(height, width)
    metres = phase * (float(scale) * float(obliquity) * float(wavelength) / steps)
    return Measured(np.where(phase >= _INVALID, np.nan, metres), "m", _digits(spacing) or None, _digits(wavelength))


def write_dat(opd: OPDMap) -> bytes:
    """Return a file of MetroPro with a map that has a wavelength, and no intensities."""
    if opd.wavelength is None:
        raise ValueError("a .dat needs the wavelength of the map, in whose fringes it counts")
    height, width = opd.values.shape
    if max(height, width) > 65535:
        raise ValueError(f"a .dat has sides of at most 65535, got {height} x {width}")
    step = _SCALE * float(np.float32(opd.wavelength)) / _STEPS[1]
    levels = np.rint(opd.values / step)
    if np.nanmax(np.abs(levels)) >= _INVALID:
        raise ValueError(
            f"a .dat holds paths below {_INVALID * step:.3g} m, got {np.nanmax(np.abs(opd.values)):.3g} m"
        )
    head = bytearray(_HEADERS[0])
    for place, kind, value in (
        (0, "I", _MAGIC[0]),
        (4, "H", 1),
        (6, "I", _HEADERS[0]),
        (68, "H", width),
        (70, "H", height),
        (72, "I", 4 * width * height),
        (164, "f", _SCALE),
        (168, "f", opd.wavelength),
        (176, "f", 1.0),
        (184, "f", opd.spacing or 0.0),
        (218, "H", 1),
    ):
        struct.pack_into(">" + kind, head, place, value)
    return bytes(head) + np.where(np.isnan(levels), _INVALID, levels).astype(">i4").tobytes()


def read_datx(data: bytes) -> Measured:
    """Return the map in a file of Mx: the surface, in fringes or in a unit of length."""
    import h5py

    with reading.hdf5(data) as file:
        found = _surface(file, h5py)
        said = found.attrs
        if found.ndim != 2 or found.dtype.kind not in "iuf" or found.size > reading.MAX_PIXELS:
            raise ValueError(f"its surface holds {found.dtype} of the shape {found.shape}, which is no map")
        values = np.asarray(reading.hdf5_values(found, len(data)), dtype=np.float64)
        if "No Data" in said:
            values[values >= _number(said["No Data"])] = np.nan
        wavelength = _number(said["Wavelength"]) if "Wavelength" in said else None
        unit = np.ravel(said["Unit"])[0] if "Unit" in said else ""
        name = unit.decode() if isinstance(unit, bytes) else str(unit)
        if name == "Fringes":
            factors = (
                _number(said[key]) for key in ("Interferometric Scale Factor", "Obliquity Factor") if key in said
            )
            values *= np.prod(list(factors))
            name = "Waves"
        if name not in _LENGTHS:
            raise ValueError(f"it has the unknown unit {validation.shown(name)}")
        spacing = _spacing(said["X Converter"]) if "X Converter" in said else 0.0
        return Measured(values, _LENGTHS[name], spacing or None, wavelength)


def _surface(file: Any, h5py: Any) -> Any:
    """Return the dataset of the surface, reached by hard links only: others may lead to other files."""

    def below(group: Any, *names: str) -> Any:
        for name in names:
            if not isinstance(group, h5py.Group) or not isinstance(group.get(name, getlink=True), h5py.HardLink):
                return None
            group = group[name]
        return group

    folder = below(file, "Data", "Surface")
    first = next(iter(folder), "") if isinstance(folder, h5py.Group) else ""
    for found in (below(file, "Measurement", "Surface"), below(file, "Data", "Surface", first)):
        if isinstance(found, h5py.Dataset):
            return found
    raise ValueError("it holds no surface")


def _number(attribute: Any) -> float:
    return validation.real("an attribute", float(np.ravel(attribute)[0]))


def _spacing(converter: Any) -> float:
    """Return the metres from pixel to pixel: the second of the parameters of the converter of x."""
    parameters = np.ravel(converter)[0][2]
    return validation.real("the spacing", float(parameters[1]), least=0.0)


def _digits(value: float) -> float:
    """Return a number of 32 bits as it was meant: 6.328e-07, not 6.328000176813395e-07."""
    return float(str(np.float32(value)))
