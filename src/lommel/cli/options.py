"""Commands, options and error messages shared by the commands of ``lommel``."""

from __future__ import annotations

import copy
import dataclasses
import errno
import functools
import inspect
import json
import os
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import click
from click.core import ParameterSource

from lommel.base import optional, options, validation
from lommel.base.units import format_length, parse_length, with_units
from lommel.base.validation import brief, line, shown
from lommel.methods import METHODS

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from lommel.lensfiles.instrument import Instrument
    from lommel.lensfiles.microscope_files import Microscope
    from lommel.psf import PSF

Facts: TypeAlias = dict[str, Any]
"""Plain data as JSON has it: texts, numbers, lists and dictionaries of these, None."""

Pitch: TypeAlias = float | tuple[float, ...]
Window: TypeAlias = int | tuple[int, int]

FILE = click.Path(dir_okay=False, path_type=Path)
"""Path of a file, which need not exist."""


class Length(click.ParamType[float]):
    """A length with a unit, in metres."""

    name = "length"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Return metres."""
        try:
            return parse_length(value)
        except ValueError as error:
            self.fail(str(error), param, ctx)


class Sides(click.ParamType[Pitch]):
    """A length with a unit, or several with an x between them, in metres."""

    name = "length"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Pitch:
        """Return metres, or height and width."""
        try:
            first, *others = (parse_length(side) for side in re.split(r"\s*[xX]\s*", value))
        except ValueError as error:
            self.fail(str(error), param, ctx)
        return (first, *others) if others else first


class Lengths(click.ParamType[tuple[float, ...]]):
    """Lengths with units, separated by commas, in metres."""

    name = "lengths"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[float, ...]:
        """Return metres."""
        return tuple(Length().convert(part.strip(), param, ctx) for part in value.split(","))


class Shape(click.ParamType[Window]):
    """A number of pixels, or two with an x between them."""

    name = "pixels"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Window:
        """Return the side of a square, or height and width."""
        found = re.fullmatch(r"\s*(\d{1,9})(?:\s*[xX\s]\s*(\d{1,9}))?\s*", value, re.ASCII)
        if found is None:
            self.fail(f"{shown(value)} is not a size; write 65 or 64x128 (height x width)", param, ctx)
        return int(found[1]) if found[2] is None else (int(found[1]), int(found[2]))


class Option(click.Option):
    """An option, and the heading under which ``--help`` lists it."""

    def __init__(self, *flags: str, heading: str = "Options", **more: Any) -> None:
        if more.get("default") is not None and not more.get("is_flag"):
            more.setdefault("show_default", True)
        super().__init__(flags, **more)
        self.heading = heading


def documented(source: Callable[..., object], name: str, *flags: str, sentences: int = 1, **more: Any) -> Option:
    """Return the option for an argument of a function or class, with its default and the help from its docstring."""
    entry = options.sentence(source, name)  # type: ignore[arg-type]
    plain = re.sub(r":\w+:`(?:[^`<]*\.)?([^`]+)`|`{1,2}([^`]+)`{1,2}", r"\1\2", entry)
    said = " ".join(re.split(r"(?<=[.]) (?=[A-Z])", plain)[:sentences])
    given = {"default": inspect.signature(source).parameters[name].default} if "required" not in more else {}
    if given.get("default") is inspect.Parameter.empty:
        given = {"required": True}
    return Option(*(flags or (f"--{name.replace('_', '-')}",)), **{"help": said, **given, **more})


def under(heading: str, *listed: Option) -> list[Option]:
    """Return copies of options that ``--help`` lists under a heading."""
    copies = [copy.copy(one) for one in listed]
    for one in copies:
        one.heading = heading
    return copies


class Command(click.Command):
    """A command whose ``--help`` lists its options under headings, the most common first."""

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the options."""
        rows: dict[str, list[tuple[str, str]]] = {}
        for part in self.get_params(ctx):
            if isinstance(part, click.Option) and (record := part.get_help_record(ctx)):
                rows.setdefault(getattr(part, "heading", "Options"), []).append(record)
        for heading, records in rows.items():
            with formatter.section(heading):
                formatter.write_dl(records)


def command(
    *params: click.Parameter, name: str | None = None, kind: type[Command] = Command
) -> Callable[[Callable[..., None]], Command]:
    """Return a decorator that makes a command of a function: its docstring is the help, its errors are one line."""

    def made(function: Callable[..., None]) -> Command:
        # Docstrings underline the heading, help has a colon; a line of \b keeps the lines of the examples.
        text = inspect.cleandoc(function.__doc__ or "").replace("Examples\n--------\n", "Examples:\n")
        text = text.replace("\n\nExample", "\n\n\b\nExample")
        called = name or function.__name__.replace("_", "-")
        return kind(called, params=list(params), help=text, callback=one_line_errors(function))

    return made


LENS = click.Argument(["lens"], type=FILE)
OBJECT_DISTANCE = Option(
    "--object-distance", type=Length(), help="Object distance, such as 1.5m or inf; overrides the file."
)
PIXEL = Option(
    "--pixel", type=Sides(), help="Pixel pitch, such as 3.45um, or height x width: 4umx3um; overrides the file."
)
SQUARE_PIXEL = Option("--pixel", type=Length(), help="Pixel pitch, such as 3.45um; overrides the file.")
SHAPE = Option(
    "--shape", type=Shape(), help="Window in pixels, such as 65 or 64x128 (height x width); overrides the file."
)
INTEGRATE = Option(
    "--integrate/--sample", default=None,
    help="Pixel-integrated values, as a sensor records them, or values at the pixel centres; overrides the file.",
)  # fmt: skip
JSON = Option("--json", "as_json", is_flag=True, help="Print the results as JSON.")


def plot_option(what: str, flag: str = "--plot") -> Option:
    """Return the option for a figure."""
    return Option(flag, "figure", type=FILE, help=f"{what}: .png, .pdf or .svg.")


def one_line_errors(function: Callable[..., None]) -> Callable[..., None]:
    """Print errors that a user can cause as one line, with exit code 2; errors of the program have exit code 1.

    With the environment variable LOMMEL_TRACEBACK set, Python's traceback is shown instead.
    """

    @functools.wraps(function)
    def guarded(*args: object, **kwargs: object) -> None:
        if sys.stdout is None:  # the caller has closed it
            sys.stdout = Path(os.devnull).open("w")  # noqa: SIM115
        try:
            function(*args, **kwargs)
            sys.stdout.flush()  # now, where a failure can still be reported
        except (click.ClickException, click.exceptions.Exit, click.Abort):
            raise
        except BrokenPipeError:
            # The reader of the pipe has left; Python must not write to it when it ends either.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            sys.exit(1)
        except Exception as error:
            if os.environ.get("LOMMEL_TRACEBACK"):
                raise
            click.echo(f"Error: {_message(error)}", err=True)
            sys.exit(2 if isinstance(error, _CAUSED) else 1)

    return guarded


_CAUSED = (ValueError, TypeError, ArithmeticError, OSError, ImportError, MemoryError)


def _message(error: Exception) -> str:
    if isinstance(error, OSError) and error.strerror:
        return f"{brief(line(error.filename), 240)}: {error.strerror}" if error.filename else error.strerror
    if isinstance(error, _CAUSED):
        return _with_options(str(error) or type(error).__name__)
    return (
        f"this is a bug in lommel, not in your input: {type(error).__name__}: {brief(line(error), 200)}; please "
        "report it with the traceback that LOMMEL_TRACEBACK=1 shows"
    )


# Arguments whose options have other names.
_CALLED = {"scale": "--depth-scale", "zero_is_unknown": "--zero-unknown"}
# A method with its options in brackets, which stays; then whatever looks like the name of an argument: "`missing`",
# "largest=", "tol=1e-9", "f_number", but not --set tol=1 or what stands in quotes.
_NAMED = re.compile(r"[A-Z]\w*\([^()]*\)|`([a-z_]+)`|(?<!--set )(?<!')\b([a-z][a-z_]*)(=)?(?=([\w'\"(\[])?)")


def _with_options(message: str) -> str:
    """Return a message of the library with the options of the running command for its arguments and methods."""
    context = click.get_current_context(silent=True)
    params = context.command.params if context else ()
    flags = {part.name: max(part.opts, key=len) for part in params if isinstance(part, click.Option)}
    flags |= {word: flag for word, flag in _CALLED.items() if flag in flags.values()}
    names = {kind.__name__: name for name, kind in METHODS.items()}
    of_methods = {item.name for kind in METHODS.values() for item in dataclasses.fields(kind)}  # type: ignore[arg-type]

    def renamed(found: re.Match[str]) -> str:
        quoted, name, equals, value = found.groups()
        word = quoted or name
        if word in flags and (quoted or equals or "_" in word):
            return flags[word] + (" " if equals and value else "")
        if equals and value and word in of_methods and "settings" in flags:
            return f"--set {found[0]}"
        return found[0]

    first = message.partition(" must ")[0]
    if context and first in flags and context.get_parameter_source(first) is ParameterSource.COMMANDLINE:
        message = flags[first] + message.removeprefix(first)
    message = _NAMED.sub(renamed, message)
    return re.sub(
        r"--method (\w+)\(.*?\)", lambda found: f"--method {names.get(found[1], found[1])}", with_units(message)
    )


def print_json(facts: Facts) -> None:
    """Print plain data as JSON on standard output."""
    click.echo(json.dumps(facts, indent=2, allow_nan=False))


def instrument_of(lens: Path, **given: object) -> Instrument:
    """Return the instrument of a lens file, changed by the options of a command."""
    from lommel.lensfiles.lens_files import load_instrument

    changes: Facts = {name: value for name, value in given.items() if value is not None}
    if "pixel" in changes:
        for side in changes["pixel"] if isinstance(changes["pixel"], tuple) else [changes["pixel"]]:
            validation.pixel(side, metric=True)
        changes["pixel"] = validation.pitch("pixel", changes["pixel"])
    if "shape" in changes:
        changes["shape"] = validation.image_shape(changes["shape"])
    return dataclasses.replace(load_instrument(lens), **changes)


def figure_format(path: Path) -> str:
    """Return the format of a figure by its suffix; an error where it cannot be drawn or written."""
    suffix = path.suffix.lower().lstrip(".")
    if suffix not in ("png", "pdf", "svg"):
        raise ValueError(f"a figure must end in .png, .pdf or .svg, got {shown(str(path))}")
    optional.require("matplotlib", "plots need", "plot")
    require_folder(path)
    return suffix


def require_folder(path: Path) -> None:
    """Raise FileNotFoundError if the folder of a file does not exist, before any file is written."""
    if not path.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(path))


def save_figure(figure: Figure, path: Path) -> None:
    """Write a figure."""
    from lommel.base import atomic

    atomic.write(path, atomic.contents(figure.savefig, format=figure_format(path), dpi=150))


def picture_size(psf: PSF, path: Path) -> str:
    """Return a note on the size of a PSF's picture, or an empty text for a file of another format."""
    if path.suffix.lower() != ".png":
        return ""
    from lommel.io.psf_formats import enlargement

    scale = enlargement(psf)
    height, width = (scale * side for side in psf.shape)
    each = f"{scale} x {scale} for each pixel of the PSF, " if scale > 1 else ""
    return f": {width} x {height} pixels, {each}square root of the values, 16 bit"


DEPTH = Option(
    "--depth",
    type=Length(),
    heading="Microscopes",
    help="Depth of the emitter below the cover glass, such as 2um; by default that of the file.",
)
STACK = under(
    "Microscopes",
    Option(
        "--stack",
        type=click.IntRange(1, 4096),
        metavar="PLANES",
        help="Number of planes along the optical axis; by default that of the file.",
    ),
    Option("--step", type=Length(), help="Stage step between planes, such as 100nm; by default that of the file."),
    DEPTH,
)

_OF_LENSES = {
    "object_distance": "--depth sets the position of the emitter",
    "field": "its PSF is the on-axis one",
    "mtf": "use PSF.mtf in Python for that of a stack",
    "colour": "its emitter has one wavelength; use lommel.colour_psf with its pupil",
}


def microscope_of(lens: Path, **given: object) -> Microscope | None:
    """Return the microscope of a file, changed by the options of a command, or None for a lens file."""
    from lommel.lensfiles.microscope_files import describes_microscope, load_microscope, stage_step

    changes: Facts = {name: value for name, value in given.items() if value is not None}
    if not describes_microscope(lens):
        for name in ("stack", "step", "depth"):
            if name in changes:
                raise ValueError(f"--{name} is for microscopes, files with a section [objective]; {lens} has none")
        return None
    for name, instead in _OF_LENSES.items():
        if name in changes:
            raise ValueError(
                f"--{name.replace('_', '-')} is for lenses, and {lens} describes a microscope: {instead}"
            )
    found = load_microscope(lens)
    if "pixel" in changes:
        validation.pixel(changes["pixel"], metric=True)
    if "shape" in changes:
        changes["shape"] = validation.image_shape(changes["shape"])
    if "stack" in changes:
        changes["planes"] = changes.pop("stack")
    if "step" in changes:
        stage_step(changes["step"])
    planes = changes.get("planes", found.planes)
    if planes > 1 and not changes.get("step", found.step):
        most = format_length(found.objective.nyquist(wavelength=found.wavelength).axial, digits=3)
        raise ValueError(f"--stack needs --step, where the file has no stack; Nyquist sampling needs at most {most}")
    if "step" in changes and planes == 1:
        raise ValueError("--step needs --stack, where the file has no stack")
    return dataclasses.replace(found, **changes)
