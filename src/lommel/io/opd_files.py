"""Read and write maps of optical path differences (OPD): FITS, Zygo, Code V, NPY and CSV."""

from __future__ import annotations

import math
from array import array
from functools import partial
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import atomic, reading, validation
from lommel.base.arrays import Values
from lommel.base.quantities import LENGTHS
from lommel.base.units import parse_length
from lommel.io import fits_images, registry, text_files
from lommel.io.registry import Description, Format
from lommel.io.zernike_tables import UNIT_NAMES
from lommel.optics.wavefront.opd_fit import OPDMap
from lommel.optics.wavefront.wavefront import UNITS

_MAGIC = (0x881B036F, 0x881B0370, 0x881B0371)
_HEADER_SIZES = (834, 4096)  # possible sizes of the header, bytes
_HEADER = np.dtype(
    {
        "names": ["magic", "format", "size", "across", "down", "buckets", "width", "height", "bytes",
                  "scale", "wavelength", "obliquity", "spacing", "resolution"],
        "formats": [">u4", ">u2", ">u4", *[">u2"] * 5, ">u4", *[">f4"] * 4, ">u2"],
        "offsets": [0, 4, 6, 52, 54, 56, 68, 70, 72, 164, 168, 176, 184, 218],
        "itemsize": _HEADER_SIZES[0],
    }
)  # fmt: skip
_OFF_GRID = 0.05  # largest distance of positions from those of a grid, in steps
_INVALID = 2147483640  # phase from which on a point is not measured
_STEPS_PER_FRINGE = {0: 4096, 1: 32768, 2: 131072}  # phase steps per fringe for each code of the phase resolution


_MX_UNITS = {"microinches": 25.4e-9, "milliinches": 25.4e-6, "mils": 25.4e-6, "angstroms": 1e-10}  # metres


class Measured(NamedTuple):
    """Values of a map, and unit, spacing (metres) and wavelength (metres) if the file states them."""

    values: Values
    unit: str | None = None
    spacing: float | None = None
    wavelength: float | None = None


def read_dat(data: bytes) -> Measured:
    """Return the map in a file of MetroPro, which has big-endian numbers at fixed offsets."""
    head = np.frombuffer(data[: _HEADER_SIZES[0]].ljust(_HEADER_SIZES[0], b"\0"), _HEADER)[0].item()
    magic, _, size, columns, rows, buckets, width, height, _, scale, wavelength, obliquity, spacing, resolution = head
    if len(data) < _HEADER_SIZES[0] or magic not in _MAGIC:
        raise ValueError("it does not begin like a file of MetroPro")
    if size not in _HEADER_SIZES:
        raise ValueError(f"its header has {size} bytes; 834 and 4096 are supported")
    if resolution not in _STEPS_PER_FRINGE:
        raise ValueError(f"its phase has the resolution {resolution}; 0 to 2 are supported")
    reading.pixels(width, height)
    start = size + 2 * columns * rows * max(buckets, 1)  # the phases follow the intensities
    if start + 4 * width * height > len(data):
        raise ValueError(f"{width} x {height} values end beyond its {len(data)} bytes")
    for name, value in (("scale factor", scale), ("wavelength", wavelength), ("obliquity factor", obliquity)):
        validation.real(f"its {name}", value, above=0.0)
    validation.real("its lateral resolution", spacing, least=0.0)
    phase = np.frombuffer(data, ">i4", width * height, start).reshape(height, width)
    metres = phase * (scale * obliquity * wavelength / _STEPS_PER_FRINGE[resolution])
    values = np.where(phase >= _INVALID, np.nan, metres)
    return Measured(values, "m", _shortest_float(spacing) or None, _shortest_float(wavelength))


def read_datx(data: bytes, part: str | None = None) -> Measured:
    """Return a surface map in a file of Mx, in fringes or in a unit of length."""
    import h5py

    with reading.hdf5(data) as file:
        folder = file.get("Data/Surface", {})
        found = (file.get("Measurement/Surface"), *folder.values())
        surfaces = list(dict.fromkeys(item for item in found if isinstance(item, h5py.Dataset)))  # without links
        if not surfaces:
            raise ValueError("it holds no surface")
        names = [[str(item.name).rpartition("/")[2], str(item.name)] for item in surfaces]
        sizes = [" x ".join(map(str, item.shape)) for item in surfaces]
        surface = reading.only(surfaces, names, sizes, part, "file.datx")
        attrs = surface.attrs
        if surface.ndim != 2 or surface.dtype.kind not in "iuf" or surface.size > reading.MAX_PIXELS:
            raise ValueError(f"its surface holds {surface.dtype} of the shape {surface.shape}, not a map")
        values = np.asarray(reading.hdf5_values(surface), dtype=np.float64)
        if "No Data" in attrs:
            values[values >= _to_number(attrs["No Data"])] = np.nan
        wavelength = _to_number(attrs["Wavelength"]) if "Wavelength" in attrs else None
        unit = np.ravel(attrs["Unit"])[0] if "Unit" in attrs else ""
        name = unit.decode() if isinstance(unit, bytes) else str(unit)
        if name == "Fringes":
            factors = (
                _to_number(attrs[key]) for key in ("Interferometric Scale Factor", "Obliquity Factor") if key in attrs
            )
            values *= np.prod(list(factors))
            name = "waves"
        spacing = 0.0
        if "X Converter" in attrs:  # its parameter 1 is the spacing in metres
            spacing = validation.real("the spacing", float(np.ravel(attrs["X Converter"])[0][2][1]), least=0.0)
        if name.lower() in _MX_UNITS:
            values *= _MX_UNITS[name.lower()]
            name = "m"
        return Measured(values, _find_unit(name), spacing or None, wavelength)


def _to_number(attribute: ArrayLike) -> float:
    return validation.real("an attribute", float(np.ravel(attribute)[0]))


def _shortest_float(value: float) -> float:
    """Return a 32-bit number without rounding noise: 6.328e-07, not 6.328000176813395e-07."""
    return float(str(np.float32(value)))


class OPDFileError(ValueError):
    """A file that cannot be read as an OPD map; the message has the file name and the reason."""


def load_opd(
    path: str | PathLike[str],
    *,
    unit: str | None = None,
    spacing: float | None = None,
    wavelength: float | None = None,
) -> OPDMap:
    """Read a map of optical path differences (OPD), for :func:`lommel.fit_opd`.

    ``.fits``, ``.fit``, also ``.gz``: an image, in the unit of BUNIT, with the spacing of PUPLSCAL (metres, as
    POPPY and WebbPSF write it) or of CDELT1 and CUNIT1, and WAVELEN in metres. ``.dat``: MetroPro's binary files.
    ``.datx``: files of Zygo Mx. ``.int``: a wavefront grid of Code V (GRD). ``.npy``: an array. ``.csv``: rows of
    numbers, with empty cells for missing numbers, or x, y and a value in each row, on a square grid; lines such as
    ``# unit: nm``, ``# spacing: 0.1 mm`` and ``# wavelength: 632.8 nm`` may precede the rows.

    Values that a file marks as missing become NaN. Rows, columns and signs are not changed. A map of a surface holds
    its height: half of the path difference in reflection.

    Parameters
    ----------
    path : path
        ``file.fits[OPD]`` selects one of several images by its name or number, ``file.datx[NAME]`` a surface.
    unit : str, optional
        "waves", "radians", "metres" or another unit of length, for files that do not state it.
    spacing : float, optional
        Metres, for files that do not state it.
    wavelength : float, optional
        Metres, for files that do not state it; waves and radians need it.

    Returns
    -------
    OPDMap

    Raises
    ------
    OPDFileError
        If the file is damaged or of another kind, or contradicts the arguments.
    TypeError, ValueError
        If an argument is out of range, if the unit is not known, if the unit needs a wavelength that is not known, or
        if the suffix is unknown.
    ImportError
        If astropy (FITS) or h5py (``.datx``) is not installed.
    OSError
        If the file cannot be read.
    """
    source, part = reading.part_of(validation.path("path", path))
    form = find(source, verb="read")
    if unit is not None:
        validation.choice("unit", unit, UNITS)
    arguments = {
        "unit": unit,
        "spacing": None if spacing is None else validation.real("spacing", spacing, above=0.0, unit="metres"),
        "wavelength": None if wavelength is None else validation.wavelength(wavelength),
    }
    data = reading.contents(source, 8 * reading.MAX_PIXELS)
    with reading.refused_as(OPDFileError, source, f"cannot be read as {registry.KINDS['opd']}"):
        if part is not None and form.read not in (_read_fits, read_datx):
            raise ValueError(f"it holds one map: omit [{part}]")
        measured = form.read(data) if part is None else form.read(data, part)
        facts = {name: _merge_stated(name, value, getattr(measured, name)) for name, value in arguments.items()}
        opd = None if facts["unit"] is None else _to_metres(measured.values, **facts)
    if opd is None:
        raise ValueError(f"unit must be given, since {validation.line(source)} does not state it")
    return opd


def save_opd(path: str | PathLike[str], opd: OPDMap) -> None:
    """Write an OPD map, which :func:`load_opd` can read; the suffix chooses the format.

    ``.fits``, ``.fits.gz``: metres, NaN where not measured, with BUNIT, PUPLSCAL, CDELTn and WAVELEN. ``.csv``:
    metres, preceded by unit, spacing and wavelength. ``.npy``: metres only. The file is written under a temporary
    name and moved into place.

    Parameters
    ----------
    path : path
    opd : OPDMap
        A single map, except for ``.fits`` and ``.npy``.

    Raises
    ------
    TypeError, ValueError
        If `opd` is not an OPDMap, if the format cannot hold it, or if the suffix is unknown.
    ImportError
        If astropy is not installed, for FITS.
    OSError
        If the file cannot be written.
    """
    form = find(path)
    atomic.write(Path(path), form.write(validation.instance("opd", opd, OPDMap)))


def _merge_stated(name: str, argument: Any, file_value: Any) -> Any:
    if name == "unit" and file_value is not None and file_value not in UNITS:
        if argument is None:
            raise ValueError(f"it has the unknown unit {validation.shown(file_value)}; give `unit`")
        return argument
    if argument is None or file_value is None:
        return file_value if argument is None else argument
    is_equal = argument == file_value if name == "unit" else math.isclose(argument, file_value, rel_tol=1e-6)
    if not is_equal:
        raise ValueError(f"it states the {name} {file_value}, not {argument}")
    return file_value


def _to_metres(values: Values, unit: str, spacing: float | None, wavelength: float | None) -> OPDMap:
    metres = LENGTHS.get(unit, 1.0)
    if unit in ("waves", "radians"):
        if wavelength is None:
            raise ValueError(f"wavelength must be given, since its unit is {unit}")
        metres = wavelength if unit == "waves" else wavelength / (2.0 * math.pi)
    if values.dtype.kind not in "iuf":
        raise ValueError(f"it holds {values.dtype}, not real numbers")
    with np.errstate(over="ignore"):
        return OPDMap(metres * values.astype(np.float64), spacing, wavelength)


def _find_unit(text: object) -> str | None:
    """Return the unit that a file states, None if it is empty; a known unit has its name in this package."""
    unit = str(text).strip()
    if not unit:
        return None
    unit_name = unit if unit in UNITS else UNIT_NAMES.get(unit.lower(), unit.lower())
    return unit_name if unit_name in UNITS else unit


def _read_fits(data: bytes, part: str | None = None) -> Measured:
    image = fits_images.only(fits_images.read(data, reading.MAX_PIXELS), part)
    # An extension inherits the cards of a first unit without an image.
    values, header = image.values, image.header if image.primary.get("NAXIS") else {**image.primary, **image.header}

    def length(name: str, metres: float = 1.0) -> float | None:
        value = header.get(name)
        return None if value is None else validation.real(name, value, above=0.0) * metres

    spacings = {"PUPLSCAL": length("PUPLSCAL")}
    for name, unit in (("CDELT1", "CUNIT1"), ("CDELT2", "CUNIT2")):
        if text := str(header.get(unit, "")).strip():
            metres = LENGTHS.get(text)
            spacings[name] = length(name, metres or 1.0) if metres else None
            if metres is None:
                validation.tell(f"the file states {name} in {text}, which is no spacing and was not used")
    stated = {name: value for name, value in spacings.items() if value is not None}
    if stated and not math.isclose(min(stated.values()), max(stated.values()), rel_tol=1e-4):
        raise ValueError(f"it states the spacings {stated}, in metres, which differ: save it with one")
    spacing = next(iter(stated.values()), None)
    return Measured(values, _find_unit(header.get("BUNIT", "")), spacing, length("WAVELEN"))


def _write_fits(opd: OPDMap) -> bytes:
    cards: Description = {"CREATOR": "lommel", "BUNIT": ("m", "optical path; NaN where it was not measured")}
    if opd.spacing is not None:
        cards["PUPLSCAL"] = (opd.spacing, "[m/pixel] in the pupil")
        for k in "12":
            cards |= {f"CDELT{k}": opd.spacing, f"CUNIT{k}": "m"}
    if opd.wavelength is not None:
        cards["WAVELEN"] = (opd.wavelength, "[m] at which it was measured")
    return fits_images.write([(opd.values, cards)])


def _read_csv(data: bytes) -> Measured:
    text = reading.decoded(data)
    stated_values = {key: value for _, key, value in text_files.settings(text)}
    if unknown_keys := [key for key in stated_values if key not in ("unit", "spacing", "wavelength")]:
        raise ValueError(f"it states {', '.join(map(validation.shown, unknown_keys[:3]))}, which is unknown")
    values, width, fault, names = array("d"), 0, "", ""
    for place, row in text_files.rows(text):
        is_first = not width
        if not is_first and len(row) != width:
            fault = fault or f", got {len(row)} in line {place}, and {width} before"
        width = len(row)
        try:
            values.extend([math.nan if cell == "" else float(cell) for cell in row])
        except ValueError:
            told = f", got {validation.shown(', '.join(row[:3]))} in line {place}"
            names, fault = (told, "") if is_first else (names, fault or told)
    if width == 3 and not fault and _lists_positions(np.array(values).reshape(-1, 3)):
        grid = _on_grid(np.array(values).reshape(-1, 3))  # under the names of columns, or none
    elif names or fault or not width:
        raise ValueError(f"it must hold rows with the same number of values{names or fault}")
    else:
        grid = np.array(values).reshape(-1, width)
    lengths = {name: parse_length(stated_values[name]) for name in ("spacing", "wavelength") if name in stated_values}
    return Measured(grid, _find_unit(stated_values.get("unit", "")), **lengths)


def _lists_positions(rows: Values) -> bool:
    """Return whether rows of three numbers are x, y and a value: different positions, on a grid in part or whole."""
    if rows.shape[1:] != (3,) or len(rows) < 10:
        return False
    x, y = rows[:, 0], rows[:, 1]
    columns, lines = np.unique(x), np.unique(y)
    is_grid = min(columns.size, lines.size) > 2 and columns.size * lines.size <= 3 * len(rows)
    return bool(is_grid and len(np.unique(rows[:, :2], axis=0)) == len(rows))


def _on_grid(rows: Values) -> Values:
    """Return the map of a list of x, y and values on a square grid, NaN where there is none; ValueError otherwise."""
    places, steps = [], []
    for one in rows[:, :2].T:
        gaps = np.diff(np.unique(one))
        # Positions are rounded, and columns may be missing: a gap has the width of one or more steps.
        steps.append(float(np.ptp(one) / np.rint(gaps / np.median(gaps)).sum()))
        exact = (one - one.min()) / steps[-1]
        places.append(np.rint(exact).astype(np.int64))
        if np.abs(exact - places[-1]).max() > _OFF_GRID or abs(steps[-1] / steps[0] - 1.0) > _OFF_GRID:
            raise ValueError(
                f"it must hold rows of pixels, or x, y and a value on a square grid, got {len(rows)} on none: "
                "interpolate them to one (scipy.interpolate.griddata)"
            )
    width, height = (int(one.max()) + 1 for one in places)
    reading.pixels(width, height)
    values = np.full((height, width), np.nan)
    values[places[1], places[0]] = rows[:, 2]
    return values


def _write_csv(opd: OPDMap) -> bytes:
    if opd.values.ndim != 2:
        raise ValueError(f"a .csv holds a single map, got a stack of shape {opd.values.shape}")
    lengths = {"spacing": opd.spacing, "wavelength": opd.wavelength}
    head = ["# unit: m", *(f"# {name}: {value!r} m" for name, value in lengths.items() if value is not None)]
    rows = (",".join("" if math.isnan(c) else repr(c) for c in row) for row in opd.values.tolist())
    return "\n".join([*head, *rows, ""]).encode()


def _read_int(data: bytes) -> Measured:
    file = text_files.parse(data.decode("latin-1"))
    if file.kind != "GRD":
        raise ValueError("it holds coefficients; load_zernike reads them")
    values = np.where(file.missing, np.nan, file.values).reshape(file.size[::-1])
    return Measured(values, "waves", None, file.wavelength)


_form = partial(Format, "opd")
registry.register(
    _form(fits_images.SUFFIXES, _write_fits, _read_fits, library="astropy"),
    _form(fits_images.PACKED, fits_images.packed(_write_fits), _read_fits, library="astropy"),
    _form((".dat",), read=read_dat, what="MetroPro"),
    _form((".datx",), read=read_datx, library="h5py", what="Zygo Mx"),
    _form((".int",), read=_read_int, what="Code V, GRD"),
    _form(
        (".npy",),
        lambda opd: atomic.contents(np.save, opd.values, allow_pickle=False),
        lambda data: Measured(reading.npy(data, reading.MAX_PIXELS)[0]),
    ),
    _form((".csv",), _write_csv, _read_csv),
)
find = partial(registry.find, "opd")
