"""Tables of a result, from its `to_dict()`: values with standard errors, one row for each image, lists of records."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from lommel.base.units import number, with_error
from lommel.report import Facts, Parts, table_of

if TYPE_CHECKING:
    from rich.table import Table

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
        if isinstance(values, Mapping) and values and name != "errors" and _is_number(*map(errors.get, values)):
            rows = [(titles.get(k, k), *with_error(v, errors[k]), units.get(k, "")) for k, v in values.items()]
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
        if name not in _APART and isinstance(records, list) and records and all(isinstance(r, dict) for r in records):
            found.append(records_of(name, records))
    parts: Parts = []
    for table in found:
        parts += ["", table] if parts else [table]
    return parts


def records_of(name: str, records: Sequence[Facts], keys: Iterable[str] = ()) -> Table:
    """Return the table of a list of dictionaries with the same keys: by default those of numbers and texts."""
    keys = [*keys] or [k for k, v in records[0].items() if isinstance(v, int | float | str) or v is None]
    rows = [(str(index), *(_cell(record.get(key)) for key in keys)) for index, record in enumerate(records)]
    return table_of((name, *(key.replace("_", " ") for key in keys)), rows)


def _is_number(*values: object) -> bool:
    return all(isinstance(value, float | int) and not isinstance(value, bool) for value in values)


def _with_error(value: Any, error: Any) -> str:
    return "-" if value is None else "+-".join(with_error(float(value), float(error)))


def _cell(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return "-" if value is None else number(value) if isinstance(value, float) else str(value)
