"""What files of images say of their recording: lengths with units, channels, objective, camera.

A look-up has three outcomes: nothing is stated, a value is, or something is stated that cannot be used.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from lommel.base import reading, validation

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
# Cards of FITS headers, each with all names that are common.
_GAIN, _READ, _FULL = ("EGAIN",), ("RDNOISE", "READNOIS", "RON"), ("SATURATE", "SATLEVEL")
_MULTIPLIED = ("EMGAIN", "EMREALGN", "EMREALGAIN")
EXCESS = 2.0  # variance by that of Poisson's, of an electron-multiplying register
_NAMED = {
    "BAYERPAT": "a mosaic of colours, whose pixels are of several wavelengths: pass those of one",
    "PEDESTAL": "which was not subtracted: state it by the offset",
}
_UNSURE = "GAIN"  # electrons per count of observatories, a setting of amateurs' cameras


@dataclass(frozen=True)
class Unusable:
    """What a file states and what cannot be used, in the words of the file; it is not unknown."""

    words: str


Found = dict[str, Any]
"""What a file says, by name; values are numbers, Unusable, or absent."""


def length(value: Any, unit: Any, default: str = "") -> float | Unusable | None:
    """Return a length in metres, what the file says of it where that is none, or None where it says nothing."""
    if value is None or value == "":
        return None
    named = str(unit or default).strip()
    words = validation.brief(f"{value} {named}".strip(), 60)
    try:
        size = abs(float(value))
    except (TypeError, ValueError):
        return Unusable(words)
    if size == 1.0 and named in ("", "pixel", "pixels"):  # what is written of no scale
        return None
    scale = _UNITS.get(named) or (_UNITS.get(named.lower()) if len(named) > 3 else None)
    if not named:
        words += " without a unit"
    return size * scale if scale and math.isfinite(size) and size > 0.0 else Unusable(words)


def number(value: Any, *, least: float = 0.0) -> float | Unusable | None:
    """Return a number above `least`, what the file says where it is none, or None where it says nothing."""
    if value is None or value == "":
        return None
    try:
        found = float(value)
    except (TypeError, ValueError):
        found = math.nan
    return found if math.isfinite(found) and found > least else Unusable(validation.brief(str(value), 60))


def of_ome(file: Any, place: int) -> Found:
    """Return what the OME-XML of a TIFF file says of an image."""
    try:
        root = reading.xml(file.ome_metadata or "")
    except ValueError:
        return {}
    images = [one for one in root.findall("{*}Image") if one.find("{*}Pixels") is not None]
    if len(images) != len(file.series):  # tifffile leaves out those without pixels
        images = [one for one in images if one.get("Name") == file.series[place].name][:1] * (place + 1)
    if not images:
        return {}
    image = images[place]
    pixels = image.find("{*}Pixels")

    def side(letter: str) -> float | Unusable | None:
        name = f"PhysicalSize{letter}"
        return length(pixels.get(name), pixels.get(f"{name}Unit"), "µm")

    found: Found = {"pixel": side("X"), "down": side("Y"), "step": side("Z")}
    channels = pixels.findall("{*}Channel")
    found["names"] = [each.get("Name") for each in channels]
    for key, name in (("emission", "EmissionWavelength"), ("excitation", "ExcitationWavelength")):
        found[key] = [length(each.get(name), each.get(f"{name}Unit"), "nm") for each in channels]
    detectors = {each.get("ID"): each.get("Type") for each in root.findall(".//{*}Instrument/{*}Detector")}
    used_by = [each.get("ID") for each in image.findall(".//{*}DetectorSettings")]
    if any(detectors.get(name) == "EMCCD" for name in used_by or (list(detectors) if len(detectors) == 1 else [])):
        found["excess"] = EXCESS
    lenses = root.findall(".//{*}Instrument/{*}Objective")
    if (used := image.find("{*}ObjectiveSettings")) is not None:
        found["immersion"] = number(used.get("RefractiveIndex"))
        lenses = [lens for lens in lenses if lens.get("ID") == used.get("ID")]
    if len(lenses) == 1:
        found["NA"] = number(lenses[0].get("LensNA"))
        found["magnification"] = number(
            lenses[0].get("CalibratedMagnification") or lenses[0].get("NominalMagnification")
        )
    return found


def of_imagej(file: Any) -> Found:
    """Return what ImageJ says in a TIFF file."""
    said, page = file.imagej_metadata or {}, file.pages[0]
    unit = said.get("unit")  # of the others, too, unless they have their own
    found: Found = {"step": length(said.get("spacing"), said.get("zunit", unit))}
    for key, tag, own in (("pixel", "XResolution", unit), ("down", "YResolution", said.get("yunit", unit))):
        value = page.tags.get(tag)
        if value is not None and own:  # without a unit it is the resolution in print
            pixels, units = value.value
            found[key] = length(units / pixels if pixels else 0.0, own)
    return found


def of_zarr(said: Mapping[str, Any], scale: Mapping[str, float], units: Mapping[str, str | None]) -> Found:
    """Return what the attributes of an OME-Zarr say; sides of voxels and their units are by the letter of an axis."""
    sides = {letter: length(value, units.get(letter)) for letter, value in scale.items()}
    found: Found = {"pixel": sides.get("X"), "down": sides.get("Y"), "step": sides.get("Z")}
    listed = said.get("omero") or {}
    channels = listed.get("channels", []) if isinstance(listed, dict) else []
    channels = [each for each in channels if isinstance(each, dict)]
    found["names"] = [each.get("label") for each in channels]
    found["emission"] = [length(each.get("emission_wavelength"), "nm") for each in channels]
    return found


def of_fits(header: Mapping[str, Any]) -> Found:
    """Return what the header of a FITS image says of its camera: electrons per count, read noise, full pixels."""

    def first(names: tuple[str, ...], least: float = 0.0) -> float | Unusable | None:
        return next((number(header[name], least=least) for name in names if name in header), None)

    found: Found = {"gain": first(_GAIN), "read": first(_READ, -1e-300), "saturation": first(_FULL)}
    if isinstance(times := first(_MULTIPLIED), float) and times > 1.0:
        found |= {"excess": EXCESS, "em_gain": times}
    unit = str(header.get("BUNIT", "")).strip()
    if unit.lower().rstrip("s") in ("electron", "e", "e-"):
        found["gain"] = 1.0
    elif "electron" in unit.lower():
        found["gain"] = Unusable(f"in {validation.brief(unit, 60)}, not in electrons")
    elif found["gain"] is None and header.get(_UNSURE) not in (None, ""):
        found["unsure"] = f"{_UNSURE} = {validation.brief(str(header[_UNSURE]), 60)}"
    return found


def fits_notes(header: Mapping[str, Any]) -> list[str]:
    """Return what a FITS header states and what is not taken into account, in sentences."""
    said = {name: validation.brief(str(header[name]), 60) for name in _NAMED if header.get(name) not in (None, "", 0)}
    return [f"The header of the images states {name} = {value}, {_NAMED[name]}." for name, value in said.items()]


def of_all(said: Sequence[Found]) -> Found:
    """Return what several files say of their camera; where they contradict each other it cannot be used."""
    found = dict(said[0])
    for key in ("gain", "read", "saturation", "excess"):
        values = [each.get(key) for each in said]
        if any(value != values[0] for value in values):
            words = [
                value.words if isinstance(value, Unusable) else "none" if value is None else f"{value:g}"
                for value in values
            ]
            found[key] = Unusable(f"of {', '.join(dict.fromkeys(words))} in different files")
    return found
