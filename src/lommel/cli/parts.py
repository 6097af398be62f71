"""What the commands share: lengths with units, one-line errors, JSON."""

from __future__ import annotations

import dataclasses
import errno
import functools
import json
import os
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

from lommel.base import optional
from lommel.base.units import parse_length, with_units
from lommel.base.validation import brief, line, shown
from lommel.methods import METHODS

if TYPE_CHECKING:
    from lommel.lensfiles.instrument import Instrument
    from lommel.psf import PSF

FILE: Any = click.Path(dir_okay=False, path_type=Path)
"""A file, which need not be there."""


class Length(click.ParamType[float]):
    """A length with a unit, in metres."""

    name = "length"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Return metres."""
        try:
            return parse_length(value)
        except ValueError as error:
            self.fail(str(error), param, ctx)


class Pitch(click.ParamType[Any]):
    """A length with a unit, or two with an x between them, in metres."""

    name = "length"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return metres, or a tuple of height and width."""
        if not isinstance(value, str):
            return value
        try:
            sides = tuple(parse_length(side) for side in re.split(r"\s*[xX]\s*", value))
            return sides if len(sides) > 1 else sides[0]
        except ValueError as error:
            self.fail(str(error), param, ctx)


class Shape(click.ParamType[Any]):
    """A number, or two with an x between them."""

    name = "pixels"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return an int or a tuple of them."""
        if not isinstance(value, str):
            return value
        found = re.fullmatch(r"\s*(\d{1,9})(?:\s*[xX\s]\s*(\d{1,9}))?\s*", value, re.ASCII)
        if found is None:
            self.fail(f"{shown(value)} is not a size; write 65 or 64x128 (height x width)", param, ctx)
        return int(found[1]) if found[2] is None else (int(found[1]), int(found[2]))


def one_line_errors(command: Callable[..., None]) -> Callable[..., None]:
    """Turn what a user can cause into one line on standard error and exit code 2, and what is a bug into exit code 1.

    With the environment variable LOMMEL_TRACEBACK set, Python's traceback is shown instead.
    """

    @functools.wraps(command)
    def guarded(*args: Any, **kwargs: Any) -> None:
        if sys.stdout is None:  # closed by who does not want to see it
            sys.stdout = Path(os.devnull).open("w")  # noqa: SIM115
        try:
            command(*args, **kwargs)
            sys.stdout.flush()  # now, where what fails can still be told
        except (click.ClickException, click.exceptions.Exit, click.Abort):
            raise
        except BrokenPipeError:
            # Who reads the output has seen enough; nothing is to be written when Python ends either.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            sys.exit(1)
        except Exception as error:
            if os.environ.get("LOMMEL_TRACEBACK"):
                raise
            click.echo(f"Error: {_told(error)}", err=True)
            sys.exit(2 if isinstance(error, _CAUSED) else 1)

    return guarded


_CAUSED = (ValueError, TypeError, ArithmeticError, OSError, ImportError, MemoryError)


def _told(error: Exception) -> str:
    if isinstance(error, OSError) and error.strerror:
        return f"{brief(line(error.filename), 240)}: {error.strerror}" if error.filename else error.strerror
    if isinstance(error, _CAUSED):
        return _with_options(str(error) or type(error).__name__)
    return (
        f"this is a fault of lommel, not yours: {type(error).__name__}: {brief(line(error), 200)}; please report it, "
        "with what LOMMEL_TRACEBACK=1 shows"
    )


# What the library calls otherwise than the command line does.
_CALLED = {"scale": "--depth-scale", "zero_is_unknown": "--zero-unknown"}
# A method with its options in brackets, which stays; then what only names look like: "`missing`", "largest=",
# "tol=1e-9", "f_number", but what was given as --set tol=1 or stands in quotes.
_NAMED = re.compile(r"[A-Z]\w*\([^()]*\)|`([a-z_]+)`|(?<!--set )(?<!')\b([a-z][a-z_]*)(=)?(?=([\w'\"(\[])?)")


def _with_options(message: str) -> str:
    """Return what the library says, with the options of the running command for its arguments and methods."""
    context = click.get_current_context(silent=True)
    options = {part.name: max(part.opts, key=len) for part in _options(context)}
    options |= {word: option for word, option in _CALLED.items() if option in options.values()}
    names = {kind.__name__: name for name, kind in METHODS.items()}
    of_methods = {item.name for kind in METHODS.values() for item in dataclasses.fields(kind)}  # type: ignore[arg-type]

    def told(found: re.Match[str]) -> str:
        quoted, name, equals, value = found.groups()
        word = quoted or name
        if word in options and (quoted or equals or "_" in word):
            return str(options[word]) + (" " if equals and value else "")
        if equals and value and word in of_methods and "settings" in options:
            return f"--set {found[0]}"
        return found[0]

    first = message.partition(" must ")[0]
    if context and first in options and context.get_parameter_source(first) is ParameterSource.COMMANDLINE:
        message = options[first] + message.removeprefix(first)
    message = _NAMED.sub(told, message)
    return re.sub(
        r"--method (\w+)\(.*?\)", lambda found: f"--method {names.get(found[1], found[1])}", with_units(message)
    )


def _options(context: click.Context | None) -> list[click.Option]:
    return [part for part in (context.command.params if context else ()) if isinstance(part, click.Option)]


def print_json(data: dict[str, Any]) -> None:
    """Print plain data as JSON on standard output."""
    click.echo(json.dumps(data, indent=2, allow_nan=False))


def instrument_of(lens: Path, **options: Any) -> Instrument:
    """Return what a lens file describes, but for what the options of a command say instead."""
    from lommel.base import validation
    from lommel.lensfiles.lens_files import load_instrument

    changes = {name: value for name, value in options.items() if value is not None}
    if "pixel" in changes:
        for side in changes["pixel"] if isinstance(changes["pixel"], tuple) else [changes["pixel"]]:
            validation.pixel(side, metric=True)
        changes["pixel"] = validation.pitch("pixel", changes["pixel"])
    if "shape" in changes:
        changes["shape"] = validation.image_shape(changes["shape"])
    return dataclasses.replace(load_instrument(lens), **changes)


def figure_format(path: Path) -> str:
    """Return the format of a figure by the suffix of its file; an error if there is none or it cannot be drawn."""
    suffix = path.suffix.lower().lstrip(".")
    if suffix not in ("png", "pdf", "svg"):
        raise ValueError(f"a figure must end in .png, .pdf or .svg, got {shown(str(path))}")
    optional.require("matplotlib", "plots need", "plot")
    require_folder(path)
    return suffix


def require_folder(path: Path) -> None:
    """Raise FileNotFoundError where there is no folder for a file, before any other is written."""
    if not path.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(path))


def save_figure(figure: Any, path: Path) -> None:
    """Write a figure through a temporary name."""
    from lommel.base import atomic

    atomic.write(path, atomic.contents(figure.savefig, format=figure_format(path), dpi=150))


def of_picture(psf: PSF, path: Path) -> str:
    """Return what to say of a file that a PSF was saved to, where that is a picture."""
    if path.suffix.lower() != ".png":
        return ""
    from lommel.io import psf_png

    scale = psf_png.scale(psf)
    height, width = (scale * side for side in psf.shape)
    each = f"{scale} x {scale} for each of the PSF, " if scale > 1 else ""
    return f": {width} x {height} pixels, {each}square root of the values, 16 bit"
