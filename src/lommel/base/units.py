"""Parse and format lengths, angles and numbers with units, for the command line and lens files."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable

from lommel.base.quantities import ANGLES, LENGTHS, POWERS
from lommel.base.validation import angle, real, shown

ARCSEC = math.pi / 648000.0
"""Radians of an arcsecond."""

_PITCHES = 1e-8, 5e-4  # metres: pixels in the sample, and of scans of prints or X-ray detectors
_WAVELENGTHS = 1e-8, 1e-4  # metres: of light that cameras record
_SYMBOLS = {"Å": "angstrom", "\u212b": "angstrom"}  # a letter, and the sign that looks like it
_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[+-]?inf(?:inity)?)\s*(\S*)\s*", re.ASCII)


def parse_length(text: str | float, example: str = "550 nm") -> float:
    """Return metres from text such as ``"3.45 um"`` or ``"50mm"``; a unit is required except for 0 and infinity.

    Units: km, m, cm, mm, um, nm, pm, angstrom (or Å), in. The result is correctly rounded, except for inches.

    Parameters
    ----------
    text : str or float
    example : str
        Example of a valid text in error messages.

    Returns
    -------
    float
        Metres.

    Raises
    ------
    ValueError
        If `text` is not a number with one of these units.
    """
    return _parse(text, LENGTHS, "length", example)


def parse_angle(text: str | float) -> float:
    """Return radians from ``"0.1 arcsec"``, or a number of radians. Units: rad, mrad, deg, arcmin, arcsec, mas.

    Parameters
    ----------
    text : str or float

    Returns
    -------
    float
        Radians.

    Raises
    ------
    ValueError
        If `text` is neither a number nor a number with one of these units.
    """
    if isinstance(text, int | float) and not isinstance(text, bool):
        return angle("an angle without a unit", text)
    return _parse(text, ANGLES, "angle", "0.1 arcsec")


def camera_pixel(name: str, value: float | tuple[float, ...]) -> float | tuple[float, ...]:
    """Return the pitch of pixels, metres, if a camera, a scanner or a microscope may have it: 10 nm to 0.5 mm."""
    for side in value if isinstance(value, tuple) else (value,):
        _require_likely(name, side, _PITCHES, 1e-6)
    return value


def camera_wavelength(name: str, value: float) -> float:
    """Return the wavelength of light, metres, if a camera may have recorded it: 10 nm to 0.1 mm."""
    _require_likely(name, value, _WAVELENGTHS, 1e-7)
    return value


def _require_likely(name: str, value: float, limits: tuple[float, float], least: float) -> None:
    """Raise ValueError for a length out of limits; it names that with these digits from `least` on, metres."""
    if not limits[0] <= value <= limits[1]:
        likely = real(name, value, above=0.0, unit="metres")
        while not least <= likely < 1e3 * least:
            likely *= 1e3 if likely < least else 1e-3
        raise ValueError(
            f"{name} must be from {format_length(limits[0])} to {format_length(limits[1])}, got "
            f"{format_length(value)}; did you mean {format_length(likely)}?"
        )


def parse_radius(text: str | float, focal_length: float) -> float:
    """Return metres on the sensor from a length, or from an angle on the sky times the focal length.

    Parameters
    ----------
    text : str or float
    focal_length : float
        Metres.

    Returns
    -------
    float
        Metres.

    Raises
    ------
    ValueError
        If `text` is neither a length nor an angle.
    """
    match = _QUANTITY.fullmatch(text) if isinstance(text, str) else None
    if match and match[2] in ANGLES:
        return parse_angle(match[0]) * real("focal_length", focal_length, above=0.0)
    return _parse(text, LENGTHS, "length", "5 um", others=ANGLES)


def format_length(metres: float, *, like: float | None = None, digits: int = 4) -> str:
    """Return a length as text with a suitable unit, such as ``"3.45 um"``.

    Parameters
    ----------
    metres : float
    like : float, optional
        Length that determines the unit, metres; by default `metres`.
    digits : int, default 4
        Number of significant digits.

    Returns
    -------
    str
    """
    metres = metres if isinstance(metres, float) else real("metres", metres, infinite=True)
    if math.isinf(metres):
        return "infinity" if metres > 0 else "-infinity"
    size = abs(metres if like is None else like)
    for name in ("m", "mm", "um", "nm"):
        # The limit is slightly below one unit, so that 0.99996 mm becomes "1 mm" and not "1000 um".
        if size >= 0.99995 * LENGTHS[name]:
            break
    else:
        name = "m" if size == 0 else "nm"
    number = float(f"{metres / LENGTHS[name]:.{digits}g}")
    return f"{number:.{max(digits, 3)}g} {name}"  # 370 um, not 3.7e+02 um


def with_error(value: float, error: float, *, most: int = 300) -> tuple[str, str]:
    """Return a value and its standard error as text, rounded to two digits of the error, at most `most` decimals."""
    if not 0.0 < error < math.inf:
        return f"{value:.6g}", f"{error:g}"
    places = min(max(0, 1 - math.floor(math.log10(error))), most)
    return f"{value:.{places}f}", f"{error:.{places}f}"


def number(value: float) -> str:
    """Return a number as text with four significant digits; a large number is not written with an exponent."""
    text = f"{value:.4g}"
    return f"{value:.0f}" if "e+" in text else text


def known(value: float | None, form: str) -> str:
    """Return a formatted number, or "-" for None."""
    return "-" if value is None else format(value, form)


def percent(share: float | None, digits: int = 0) -> str:
    """Return a fraction as text in percent with `digits` decimals, or "-" for None."""
    return "-" if share is None else f"{100.0 * share:.{digits}f} %"


def per_mm(frequency: float) -> str:
    """Return a spatial frequency, given in cycles per metre, as text in cycles per millimetre."""
    return f"{1e-3 * frequency:.4g} cycles/mm"


def pitch_in_words(pixel: float | tuple[float, ...]) -> str:
    """Return the pixel pitch as text with a unit; for a pixel that is not square, height x width."""
    return " x ".join(format_length(side) for side in ([pixel] if isinstance(pixel, float) else pixel))


def with_units(message: str) -> str:
    """Return a message of the library as on the command line: ``write "3.45 um"`` instead of ``give 3.45e-6``."""
    units = {"3": "mm", "6": "um", "9": "nm"}
    message = re.sub(r"\bgive math\.radians\(([^)]*)\)", r'write "\1 deg"', message)
    message = re.sub(r"\bfor ([\d.e+-]+ mm) [\d.e+-]+e-3\b", r'for \1 "\1"', message)
    return re.sub(r"\bgive ([\d.]+)e-([369])\b", lambda match: f'write "{match[1]} {units[match[2]]}"', message)


def _parse(text: object, units: dict[str, float], kind: str, example: str, others: Iterable[str] = ()) -> float:
    article = "an" if kind == "angle" else "a"
    if isinstance(text, bool) or not isinstance(text, str | int | float):
        raise ValueError(f"{article} {kind} is a number with a unit, a text such as {example!r}, got {shown(text)}")
    text = text if isinstance(text, str) else format(real(f"{article} {kind}", text, infinite=True), "g")
    match = _QUANTITY.fullmatch(text)
    if not match:
        if "," in text and _QUANTITY.fullmatch(pointed := text.replace(",", ".")):
            raise ValueError(f"{shown(text)} is not {article} {kind}; write {shown(pointed)}, with a decimal point")
        raise ValueError(f"{shown(text)} is not {article} {kind}; write for example {example!r}")
    number, unit = float(match[1]), _SYMBOLS.get(match[2], match[2])
    if unit and unit not in units:
        angles = f", an angle in {', '.join(others)}" if others else ""
        raise ValueError(
            f"{shown(text)} has the unknown unit {shown(unit)}; {article} {kind} is in {', '.join(units)}{angles}"
        )
    if not unit and number != 0.0 and not math.isinf(number):
        raise ValueError(f"{shown(text)} is {article} {kind} without a unit; write for example {example!r}")
    value = _scaled(match[1], unit) if unit in POWERS else number * units.get(unit, 1.0)
    if math.isinf(value) and not match[1].lstrip("+-").startswith("inf"):
        raise ValueError(f"{shown(text)} exceeds the range of numbers")
    return value


def _scaled(number: str, unit: str) -> float:
    """Return the float nearest to a decimal number times a power of ten."""
    # The exponents are added in decimal, since a product of two floats may not be the nearest float.
    digits, _, power = number.lower().partition("e")
    if digits.lstrip("+-").startswith("inf") or len(power) > 9:
        return float(number)
    return float(f"{digits}e{int(power or 0) + POWERS[unit]}")
