"""Methods by their names at the command line: ``lommel methods``, ``--method`` and ``--set``."""

from __future__ import annotations

import dataclasses
from typing import Any

import click

from lommel.base.validation import shown
from lommel.cli.parts import one_line_errors, print_json
from lommel.methods import ERFS, METHODS, Method


@click.command()
@click.option("--json", "as_json", is_flag=True, help="Print what the table shows as JSON.")
@one_line_errors
def methods(as_json: bool) -> None:
    """List the methods and their options, as -m and --set take them.

    \b
    Example:
      lommel methods
    """  # noqa: D301 (\b is meant)
    from lommel.cli import tables

    rows = [
        {
            "name": name,
            "what": (kind.__doc__ or "").partition("\n")[0].replace("``", "").rstrip("."),
            "options": {item.name: _shown(item) for item in dataclasses.fields(kind)},  # type: ignore[arg-type]
        }
        for name, kind in METHODS.items()
    ]
    if as_json:
        print_json({"methods": rows})
    else:
        tables.print_methods(rows)


def build_method(name: str, settings: tuple[str, ...] = ()) -> Method | None:
    """Return a method from its command-line name and ``NAME=VALUE`` settings; None, left to the pupil, for "auto"."""
    if name == "auto":
        if settings:
            raise ValueError(f"--set needs --method, whose option it is, got --set {settings[0]}")
        return None
    kind = METHODS[name]
    known = {item.name for item in dataclasses.fields(kind)}  # type: ignore[arg-type]
    options: dict[str, Any] = {}
    for setting in settings:
        key, equals, text = setting.partition("=")
        if not equals:
            raise ValueError(f"--set takes NAME=VALUE, got {shown(setting)}")
        if key == "erf":
            erf, colon, count = text.partition(":")
            if erf not in ERFS:
                raise ValueError(
                    f"--set erf must be one of {', '.join(ERFS)}, with a count after a colon, got {shown(text)}"
                )
            if colon and not dataclasses.fields(ERFS[erf]):
                raise ValueError(f"--set erf={erf} takes no count, got {shown(text)}")
            options[key] = ERFS[erf](*([_value(count)] if colon else []))
        elif key in options:
            raise ValueError(f"{key} is given twice")
        else:
            options[key] = _value(text)
    for key in options:
        if key not in known:
            allowed = f"its options are {', '.join(sorted(known))}" if known else "it has none"
            raise ValueError(f"{name} has no option {key!r}; {allowed}")
    try:
        return kind(**options)
    except (TypeError, ValueError) as error:
        raise type(error)(f"--set {error}") from None


def _value(text: str) -> Any:
    """Return the number, pair, truth value or word that a text stands for."""
    if "," in text:
        return tuple(_value(part) for part in text.split(","))
    words = {"none": None, "true": True, "false": False}
    if text.lower() in words:
        return words[text.lower()]
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            continue
    return text


def _shown(item: Any) -> str:
    """Return the default of an option as --set takes it."""
    default = item.default_factory() if item.default is dataclasses.MISSING else item.default
    return next((name for name, kind in ERFS.items() if isinstance(default, kind)), str(default).lower())
