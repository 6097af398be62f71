"""Tables of a result, from its `to_dict()`: names and values, values with standard errors, lists of records."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from lommel.base.quantities import LENGTHS
from lommel.base.units import format_length, number, per_mm, percent, with_error
from lommel.report import Facts, Parts, Report, Wrapped, list_of, table_of

if TYPE_CHECKING:
    from rich.console import Console, ConsoleOptions, RenderableType
    from rich.table import Table

_FORMS: dict[str, Callable[[float], str]] = {
    "m": lambda value: format_length(value, digits=5) if value else "0",
    "rad": lambda value: f"{value:.4g} rad",
    "deg": lambda value: f"{math.degrees(value):.4g} deg",
    "1/m": per_mm,
    "share": lambda value: percent(value, 2),
    "peak": lambda value: f"{value:.2g} of the peak",
    "s": lambda value: f"{1e3 * value:.1f} ms" if value < 1.0 else f"{value:.3g} s",
}
_KEYS = {
    "m": "focal_length aperture_diameter focus_distance sensor_distance object_distance pixel pixel_in_object "
    "pixel_in_sample in_focus hyperfocal_distance near far blur airy_radius dark_ring_radius geometric_radius "
    "circle_of_confusion fwhm fwhm_with_pixel diameter_80 diameter_80_with_pixel diameter_80_about_centroid "
    "diameter_80_about_centroid_with_pixel radius focus_tolerance sensor x y z "
    "distance reach wavelength wavelengths working_distance thickness depth step lateral axial paraxial brightest "
    "axial_fwhm lateral_fwhm focus focus_in_the_middle focus_distances between standard_error depth_scale distances "
    "distance_errors",
    "rad": "defocus defocus_of_distances spherical higher",
    "deg": "critical_angle rim_angle angles angle",
    "1/m": "cutoff nyquist nyquist_y mtf50 mtf50_y frequency",
    "share": "energy clear_area fraction unaberrated clipped depth_unknown light_beyond_windows known unfit unknown",
    "peak": "error_bound peak_error of_spectra",
    "s": "seconds frame_time interval",
}
_FORM_OF = {key: _FORMS[unit] for unit, keys in _KEYS.items() for key in keys.split()}
_WORDS = {"fwhm": "FWHM", "mtf": "MTF", "mtf50": "MTF50", "marechal": "Marechal's estimate", "arcsec": "arcseconds"}
_WORDS |= {"seconds": "time", "dtype": "type"}
_LABELS = {"defocus": "defocus C_d", "defocus_of_distances": "C_d of distances", "spherical": "spherical C_s"}
_INFINITE = ("focus_distance", "object_distance", "far")  # None is infinity
_BLURS = (
    "fwhm",
    "fwhm_with_pixel",
    "diameter_80",
    "diameter_80_with_pixel",
    "diameter_80_about_centroid",
    "diameter_80_about_centroid_with_pixel",
    "circle_of_confusion",
    "geometric_radius",
)
_SIDES = ("shape", "pixel", "sensor")
_LONG = 4  # largest number of values that are printed one by one


def described(facts: Facts, meanings: Mapping[str, str] | None = None, first: Sequence[str] = ()) -> Parts:
    """Return the table of the names and values of facts, then the tables of lists of records in them.

    The names are those of JSON. Values that are missing are left out, and those along y if they are the same along x.
    Blurs are also in pixels and, where the facts have their scale, in arcseconds or in the object.

    Parameters
    ----------
    facts : dict
    meanings : mapping, optional
        Texts for values that are words, such as "center".
    first : sequence of str
        Keys of the most important values, which are a table of their own before the others.
    """
    rows: list[tuple[str, str]] = []
    head: list[tuple[str, str]] = []
    records: list[tuple[str, list[Facts]]] = []
    for key, value in facts.items():
        if key in ("name", "source", "refused", *_APART) or (key.endswith("_y") and value == facts.get(key[:-2])):
            continue
        if _is_records(value):
            records.append((key, value))
            continue
        if isinstance(value, dict):
            records += [(name, inner) for name, inner in value.items() if _is_records(inner)]
        if text := _text(key, value, meanings or {}):
            (head if key in first else rows).append((_label(key), text + _in_pixels(key, value, facts)))
    parts: Parts = [list_of(head), "", list_of(rows)] if head else [list_of(rows)]
    for key, found in records:
        parts += ["", records_of(_label(key), found)]
    return [*parts, *(Wrapped(f"not computed: {reason}", "dim") for reason in facts.get("refused", ()))]


def told(facts: Facts, meanings: Mapping[str, str] | None = None, succeeded: bool = True) -> Report:
    """Return the report of facts, with the table of their names and values."""
    return Report(facts, described(facts, meanings), succeeded)


def _in_pixels(key: str, blur: Any, facts: Facts) -> str:
    """Return a blur in pixels, and in arcseconds or in the object, in brackets; an empty text for other values."""
    if key not in _BLURS or not facts.get("pixel") or not isinstance(blur, float):
        return ""
    pixel = facts["pixel"][-1] if isinstance(facts["pixel"], list) else facts["pixel"]
    texts = [f"{number(blur / pixel)} pixels"]
    if facts.get("arcsec_per_pixel"):
        texts.append(f"{number(blur / pixel * facts['arcsec_per_pixel'])} arcsec")
    if facts.get("pixel_in_object"):
        texts.append(f"{format_length(blur / pixel * facts['pixel_in_object'])} in the object")
    return f" ({', '.join(texts)})"


def _label(key: str) -> str:
    return _LABELS.get(key) or " ".join(_WORDS.get(word, word) for word in key.split("_"))


def _text(key: str, value: Any, meanings: Mapping[str, str]) -> str:
    """Return a value as a text, empty if it is missing."""
    form = _FORM_OF.get(key, number)
    if value is None or isinstance(value, bool):
        return {True: "yes", False: "no", None: "infinity" if key in _INFINITE else ""}[value]
    if isinstance(value, float):
        return form(value)
    if isinstance(value, dict):
        forms = {name: name if name in _FORM_OF else key for name in value}
        texts = {name: _text(forms[name], inner, meanings) for name, inner in value.items() if not _is_records(inner)}
        return ", ".join(t if name == "name" else f"{_label(name)} {t}" for name, t in texts.items() if t)
    if isinstance(value, list | tuple):
        values = list(_flat(value))
        if len(values) > _LONG and key not in _SIDES and all(isinstance(v, float | int) for v in values):
            return " to ".join(dict.fromkeys(_text(key, end, meanings) for end in (min(values), max(values))))
        joint = " x " if key in _SIDES else " to " if key == "focus_tolerance" else ", "
        return joint.join(_text(key, v, meanings) for v in values)
    return meanings.get(str(value), str(value))


def _flat(values: Iterable[Any]) -> Iterable[Any]:
    for value in values:
        yield from _flat(value) if isinstance(value, list | tuple) else (value,)


def _is_records(value: object) -> bool:
    return isinstance(value, list) and bool(value) and all(isinstance(record, dict) for record in value)


_APART = ("findings", "notes", "files")  # sentences, which come after the tables


def tables(facts: Facts, titles: Mapping[str, str] | None = None, first: str = "image") -> Parts:
    """Return the tables of a result; what none shows, such as arrays, is left to JSON.

    Facts with numbers by name, each with a number of the same name in ``facts["errors"]`` and perhaps a unit in
    ``facts["units"]``, are a table of values. Lists with a list in ``facts["errors"]`` are the columns of a table
    with a row for each of ``facts["images"]``. Lists of dictionaries are tables of their numbers and texts.

    Parameters
    ----------
    facts : dict
    titles : mapping, optional
        Names of values in the table instead of their keys, such as "noll 8 coma x" for "3,1".
    first : str
        Heading of the column of the images.
    """
    errors, units, titles = facts.get("errors", {}), facts.get("units", {}), titles or {}
    found: list[Table] = []
    for name, values in facts.items():
        if (
            isinstance(values, Mapping)
            and values
            and name not in ("errors", "units")
            and all(k in errors and (errors[k] is None or _is_number(errors[k])) for k in values)
        ):
            rows = [(titles.get(k, k), *_estimate(v, errors[k], units.get(k, ""))) for k, v in values.items()]
            found.append(table_of((name, "value", "std. error", "unit"), rows))
    columns = {k: v for k, v in facts.items() if isinstance(v, list) and isinstance(errors.get(k), list)}
    if columns:
        names = facts.get("images") or [str(k) for k in range(len(next(iter(columns.values()))))]
        cells = [
            (name, *(_with_error(column[k], errors[key][k]) for key, column in columns.items()))
            for k, name in enumerate(names)
        ]
        found.append(table_of([first, *(f"{c} {units.get(c, '')}".rstrip() for c in columns)], cells))
    for name, records in facts.items():
        if name not in _APART and _is_records(records):
            found.append(records_of(name, records))
    parts: Parts = []
    for table in found:
        parts += ["", table] if parts else [table]
    return parts


def known_keys(records: Sequence[Facts]) -> list[str]:
    """Return the keys of a list of dictionaries that some have a number or a text of."""
    return [k for k in records[0] if any(_text(k, r.get(k), {}) and not _is_records(r.get(k)) for r in records)]


def records_of(name: str, records: Sequence[Facts], keys: Iterable[str] = ()) -> Table:
    """Return the table of a list of dictionaries: by default of all keys that some have a number or a text of."""
    keys = [*keys] or known_keys(records)
    rows = [[_text(key, record.get(key), {}) or "-" for key in keys] for record in records]
    words = [k for k, key in enumerate(keys) if k == 0 or any(isinstance(record.get(key), str) for record in records)]
    return table_of([_label(key) for key in keys], rows, words, name)


@dataclass(frozen=True)
class Continued:
    """A table of records that continues below, with its first columns again, where it is wider than the console."""

    name: str
    records: Sequence[Facts]
    first: Sequence[str]
    keys: Sequence[str]

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> Iterator[RenderableType]:
        name, rest, unlimited = self.name, [*self.keys], options.update(max_width=sys.maxsize)
        while rest:
            fitting = 1
            for count in range(2, len(rest) + 1):
                table = records_of(name, self.records, [*self.first, *rest[:count]])
                if console.measure(table, options=unlimited).maximum > options.max_width:
                    break
                fitting = count
            yield from () if name else ("",)
            yield records_of(name, self.records, [*self.first, *rest[:fitting]])
            name, rest = "", rest[fitting:]


def _estimate(value: float, error: float | None, unit: str) -> tuple[str, str, str]:
    """Return a value, its standard error ("-" without one) and their unit as texts; lengths in nm, um or mm."""
    factor = 1.0
    if unit == "m":
        unit = next((name for name in ("nm", "um", "mm") if abs(value) < 1e3 * LENGTHS[name]), unit)
        factor = LENGTHS.get(unit, 1.0)
    if error is None:
        return number(value / factor), "-", unit
    return (*with_error(value / factor, error / factor), unit)


def _is_number(*values: object) -> bool:
    return all(isinstance(value, float | int) and not isinstance(value, bool) for value in values)


def _with_error(value: Any, error: Any) -> str:
    if error is None and value is not None:
        return number(value)
    return "-" if value is None else "+-".join(with_error(float(value), float(error)))
