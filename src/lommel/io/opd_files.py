"""Maps of optical path differences from files and to them: FITS, Zygo's, Code V's, NPY and CSV."""

from __future__ import annotations

import io
import math
from array import array
from collections.abc import Mapping
from functools import partial
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic, reading, validation
from lommel.base.units import LENGTHS, parse_length
from lommel.io import cells, code_v, fits_images, opd_zygo, registry
from lommel.io.opd_zygo import Measured
from lommel.io.registry import Format
from lommel.io.zernike_tables import UNITS
from lommel.optics.opd import OPDMap

_NAMES = {"micron": "um", "microns": "um", "micrometer": "um", "micrometers": "um", "nanometer": "nm"}
_NAMES |= {"nanometers": "nm", "meter": "m", "meters": "m", "wave": "waves", "rad": "radians", "radian": "radians"}


class OPDFileError(ValueError):
    """A file that cannot be read as a map of path differences; the message names it and says why."""


def load_opd(
    path: str | PathLike[str],
    *,
    unit: str | None = None,
    spacing: float | None = None,
    wavelength: float | None = None,
) -> OPDMap:
    """Read a map of optical path differences, for :func:`lommel.fit_opd`.

    ``.fits``, ``.fit``, also ``.gz``: the first image, in the unit of BUNIT, with the spacing of PUPLSCAL (metres, as
    POPPY and WebbPSF write it) or of CDELT1 and CUNIT1, and WAVELEN in metres. ``.dat``: MetroPro's binary files.
    ``.datx``: Zygo Mx's. ``.int``: a grid of Code V (GRD) that is a wavefront. ``.npy``: an array. ``.csv``: rows of
    numbers, with empty cells where there is none; lines such as ``# unit: nm``, ``# spacing: 0.1 mm`` and
    ``# wavelength: 632.8 nm`` may stand above.

    NaN, and what a file marks as missing, is no measurement. Rows and columns are as they are stored, and so are
    signs: a map of a surface is its height, half of the path that it makes in reflection.

    Parameters
    ----------
    path : path
    unit : str, optional
        "waves", "radians", "metres" or another unit of length; for files that do not state it.
    spacing : float, optional
        Metres; the same.
    wavelength : float, optional
        Metres; the same. Waves and radians need one.

    Returns
    -------
    OPDMap

    Raises
    ------
    OPDFileError
        If the file is damaged or of another kind, or states something else than the arguments do.
    TypeError, ValueError
        If an argument is out of range, if nobody states the unit, or the wavelength where waves need it, or if the
        suffix is unknown.
    ImportError
        If astropy (FITS) or h5py (``.datx``) is not installed.
    OSError
        If it cannot be read.
    """
    form, source = find(path, verb="read"), Path(path)
    if unit is not None:
        validation.choice("unit", unit, UNITS)
    said = {
        "unit": unit,
        "spacing": None if spacing is None else validation.real("spacing", spacing, above=0.0, unit="metres"),
        "wavelength": None if wavelength is None else validation.wavelength(wavelength),
    }
    data = reading.contents(source, 8 * reading.MAX_PIXELS)
    try:
        found = form.read(data)
        known = {name: _agreed(name, value, getattr(found, name)) for name, value in said.items()}
        opd = None if known["unit"] is None else _in_metres(found.values, **known)
    except ImportError:
        raise
    except Exception as error:
        what = registry.KINDS["opd"]
        raise OPDFileError(f"{validation.line(source)} cannot be read as {what}: {reading.reason(error)}") from error
    if opd is None:
        raise ValueError(f"unit must be given, since {validation.line(source)} does not state it")
    return opd


def save_opd(path: str | PathLike[str], opd: OPDMap) -> None:
    """Write a map of optical path differences; the suffix chooses the format, and :func:`load_opd` reads it.

    ``.fits``, ``.fits.gz``: metres, NaN where there is no measurement, with BUNIT, PUPLSCAL, CDELTn and WAVELEN.
    ``.csv``: metres, with unit, spacing and wavelength above. ``.npy``: metres alone. ``.dat``: MetroPro's, whose
    steps are the wavelength over 65536. The file is written under a temporary name and moved into place.

    Parameters
    ----------
    path : path
    opd : OPDMap
        A single one, but for ``.fits`` and ``.npy``; with a wavelength for ``.dat``.

    Raises
    ------
    TypeError, ValueError
        If `opd` is none, or is one that the format does not hold, or if the suffix is unknown.
    ImportError
        If astropy is not installed, for FITS.
    OSError
        If the file cannot be written.
    """
    form = find(path)
    atomic.write(Path(path), form.write(validation.instance("opd", opd, OPDMap)))


def _agreed(name: str, given: Any, stated: Any) -> Any:
    if given is None or stated is None:
        return stated if given is None else given
    same = given == stated if name == "unit" else math.isclose(given, stated, rel_tol=1e-6)
    if not same:
        raise ValueError(f"it states the {name} {stated}, not {given}")
    return stated


def _in_metres(values: NDArray[Any], unit: str, spacing: float | None, wavelength: float | None) -> OPDMap:
    metres = LENGTHS.get(unit, 1.0)
    if unit in ("waves", "radians"):
        if wavelength is None:
            raise ValueError(f"wavelength must be given, since its unit is {unit}")
        metres = wavelength if unit == "waves" else wavelength / (2.0 * math.pi)
    if values.dtype.kind not in "iuf":
        raise ValueError(f"it holds {values.dtype}, no real numbers")
    with np.errstate(over="ignore"):
        return OPDMap(metres * values.astype(np.float64), spacing, wavelength)


def _unit(text: Any) -> str | None:
    """Return the unit that a file names, by the name that it has here; ValueError if it is another."""
    plain = str(text).strip()
    if not plain:
        return None
    name = _NAMES.get(plain.lower(), plain)
    if name not in UNITS:
        raise ValueError(f"it has the unknown unit {validation.shown(plain)}")
    return name


def _read_fits(data: bytes) -> Measured:
    values, header = fits_images.read(data, reading.MAX_PIXELS)[0]

    def length(name: str, metres: float = 1.0) -> float | None:
        value = header.get(name)
        return None if value is None else validation.real(name, value, above=0.0) * metres

    spacing = length("PUPLSCAL")
    if spacing is None and (per := LENGTHS.get(str(header.get("CUNIT1", "")).strip())):
        spacing = length("CDELT1", per)
    return Measured(values, _unit(header.get("BUNIT", "")), spacing, length("WAVELEN"))


def _write_fits(opd: OPDMap) -> bytes:
    cards: dict[str, Any] = {"CREATOR": "lommel", "BUNIT": ("m", "optical path; NaN where it was not measured")}
    if opd.spacing is not None:
        cards["PUPLSCAL"] = (opd.spacing, "[m/pixel] in the pupil")
        for k in "12":
            cards |= {f"CDELT{k}": opd.spacing, f"CUNIT{k}": "m"}
    if opd.wavelength is not None:
        cards["WAVELEN"] = (opd.wavelength, "[m] at which it was measured")
    return fits_images.write([(opd.values, cards)])


def _read_csv(data: bytes) -> Measured:
    text = reading.decoded(data)
    said = _settings(text)
    if others := [key for key in said if key not in ("unit", "spacing", "wavelength")]:
        raise ValueError(f"it states {', '.join(map(validation.shown, others[:3]))}, which is unknown")
    values, width, wrong = array("d"), 0, False
    for _, row in cells.rows(text):
        wrong |= bool(width) and len(row) != width
        width = len(row)
        try:
            values.extend(math.nan if cell == "" else float(cell) for cell in row)
        except ValueError:
            wrong = True
    if wrong or not width:
        raise ValueError("it must hold rows of equally many numbers")
    spacing, wavelength = (parse_length(said[name]) if name in said else None for name in ("spacing", "wavelength"))
    return Measured(np.array(values).reshape(-1, width), _unit(said.get("unit", "")), spacing, wavelength)


def _settings(text: str) -> Mapping[str, str]:
    lines = (line.lstrip()[1:].partition(":") for line in io.StringIO(text) if line.lstrip().startswith("#"))
    return {key.strip(): value.strip() for key, colon, value in lines if colon}


def _write_csv(opd: OPDMap) -> bytes:
    _single(opd, ".csv")
    known = {"spacing": opd.spacing, "wavelength": opd.wavelength}
    head = ["# unit: m", *(f"# {name}: {value!r} m" for name, value in known.items() if value is not None)]
    rows = (",".join("" if math.isnan(c) else repr(c) for c in row) for row in opd.values.tolist())
    return "\n".join([*head, *rows, ""]).encode()


def _read_int(data: bytes) -> Measured:
    held = code_v.parse(data.decode("latin-1"))
    if held.kind != "GRD":
        raise ValueError("it holds coefficients, no grid; load_zernike reads them")
    values = np.where(held.missing, np.nan, held.values).reshape(held.size[::-1])
    return Measured(values, "waves", None, held.wavelength)


def _write_dat(opd: OPDMap) -> bytes:
    return opd_zygo.write_dat(_single(opd, ".dat"))


def _single(opd: OPDMap, suffix: str) -> OPDMap:
    if opd.values.ndim != 2:
        raise ValueError(f"a {suffix} holds a single map, got a stack of shape {opd.values.shape}")
    return opd


_form, _fits = partial(Format, "opd"), partial(Format, "opd", library="astropy", extra="fits")
registry.register(
    _fits(fits_images.SUFFIXES, _write_fits, _read_fits),
    _fits(fits_images.PACKED, fits_images.packed(_write_fits), _read_fits),
    _form((".dat",), _write_dat, opd_zygo.read_dat),
    _form((".datx",), read=opd_zygo.read_datx, library="h5py", extra="hdf5"),
    _form((".int",), read=_read_int),
    _form(
        (".npy",),
        lambda opd: atomic.contents(np.save, opd.values, allow_pickle=False),
        lambda data: Measured(reading.npy(data, reading.MAX_PIXELS)[0]),
    ),
    _form((".csv",), _write_csv, _read_csv),
)
find = partial(registry.find, "opd")
