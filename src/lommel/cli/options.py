"""Commands, options and error messages shared by the commands of ``lommel``."""

from __future__ import annotations

import copy
import inspect
import re
import sys
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path
from typing import Any, ClassVar, Self, TypeAlias, TypeVar

import click
from click.core import ParameterSource

from lommel.base import options
from lommel.base.units import parse_length
from lommel.base.validation import shown
from lommel.cli import messages
from lommel.cli.messages import run_job
from lommel.cli.output import figure_format
from lommel.report import Facts, Report

finding_lines, flag_of = messages.finding_lines, messages.flag_of
report_findings, with_options = messages.report_findings, messages.with_options

Pitch: TypeAlias = float | tuple[float, ...]
Window: TypeAlias = int | tuple[int, int]
Value = TypeVar("Value")
Param = TypeVar("Param", bound=click.Parameter)

FILE = click.Path(dir_okay=False, path_type=Path)
"""Path of a file, which need not exist."""


class _OutputPath(click.Path):
    """Path of a file to write."""


OUTPUT = _OutputPath(dir_okay=False, path_type=Path)
"""Path of a file to write, which must differ from all files that are read."""

OUTPUT_PATH = _OutputPath(path_type=Path)
"""Path of a file or a folder to write, which must differ from all files that are read."""

PATH = click.Path(path_type=Path)
"""Path of a file or a folder, which need not exist."""


class Parsed(click.ParamType[Value]):
    """Parameter type whose values a function parses from a text; its ValueErrors are the error messages."""

    def __init__(self, name: str, parse: Callable[[str], Value]) -> None:
        self.name, self.parse = name, parse

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> Value:
        """Return the parsed value."""
        try:
            return self.parse(value)
        except ValueError as error:
            self.fail(str(error), param, ctx)


def _length(unit: str, text: str) -> float:
    """Return a length in metres; the error for a number without a unit suggests the number with `unit`."""
    number = text.strip()
    if re.fullmatch(_NUMBER, number) is None:
        number = _TYPICAL[unit]
    elif unit == "nm" and float(number) < _MIN_NANOMETRES:
        unit = "um"  # steps and wavelengths are as often written in micrometres
    return parse_length(text, f"{number} {unit}")


def _sides(text: str) -> Pitch:
    """Return a length, or (height, width), in metres."""
    sides = tuple(_length("um", side) for side in re.split(r"\s*[xX]\s*", text))
    return sides if len(sides) > 1 else sides[0]


def _lengths(text: str) -> tuple[float, ...]:
    return tuple(_length("nm", part.strip()) for part in text.split(","))


_NUMBER = r"\d+\.?\d*|\.\d+"
_MIN_NANOMETRES = 10.0  # smallest number without a unit that is taken for nanometres
_TYPICAL = {"m": "1.5", "mm": "50", "um": "3.45", "nm": "550"}
"""Examples of lengths in error messages, by unit."""


def _window(text: str) -> Window:
    """Return the side of a square in pixels, or height and width."""
    match = re.fullmatch(r"\s*(\d{1,9})(?:\s*[xX\s]\s*(\d{1,9}))?\s*", text, re.ASCII)
    if match is None:
        raise ValueError(f"{shown(text)} is not a size; write 65 or 64x128 (height x width)")
    return int(match[1]) if match[2] is None else (int(match[1]), int(match[2]))


SIDES = Parsed("length", _sides)
"""Type of a length with a unit, or of several lengths with an x between them; values are in metres."""

LENGTHS = Parsed("lengths", _lengths)
"""Type of lengths with units, separated by commas; values are in metres."""

WINDOW = Parsed("pixels", _window)
"""Type of a number of pixels, or of two numbers with an x between them."""


_UNNAMED = "--unnamed"


class Option(click.Option):
    """An option with the heading under which ``--help`` lists it; without flags it has the name of its argument.

    With `length`, a unit, values are lengths with a unit on the command line and in metres in the command; error
    messages suggest this unit.
    """

    def __init__(self, *flags: str, heading: str = "Options", length: str = "", **keywords: Any) -> None:
        self.heading = heading
        if length:
            keywords["type"] = Parsed("length", partial(_length, length))
        if keywords.get("default") is not None and not keywords.get("is_flag"):
            keywords.setdefault("show_default", True)
        super().__init__(flags or (_UNNAMED,), **keywords)


def documented(source: Callable[..., object], name: str, *flags: str, sentences: int = 1, **keywords: Any) -> Any:
    """Return the option for an argument of a function or class, with its default and the help from its docstring."""
    entry = options.sentence(source, name)
    text = re.sub(r":\w+:`(?:[^`<]*\.)?([^`]+)`|`{1,2}([^`]+)`{1,2}", r"\1\2", entry)
    help_text = " ".join(re.split(r"(?<=[.]) (?=[A-Z])", text)[:sentences])
    settings = {"default": inspect.signature(source).parameters[name].default} if "required" not in keywords else {}
    if settings.get("default") is inspect.Parameter.empty:
        settings = {"required": True}
    return Option(*(flags or (f"--{name.replace('_', '-')}",)), **{"help": help_text, **settings, **keywords})


def option(*flags: str, **keywords: Any) -> Any:
    """Return an option, as the default of an argument of a command or of an attribute of a :class:`Group`."""
    return Option(*flags, **keywords)


def argument(name: str, **keywords: Any) -> Any:
    """Return an argument of the command line, as the default of an argument of a command function."""
    return click.Argument([name], **keywords)


class Group:
    """Options that commands share, under a heading of ``--help``; each is declared by ``name: type = option(...)``.

    They follow the options of the base classes, which a subclass may replace. A group may contain other groups. An
    instance has the values of a call as attributes.
    """

    heading: ClassVar[str] = "Options"

    def __init_subclass__(cls, heading: str = "Options") -> None:
        cls.heading = heading

    def __init__(self, **values: Any) -> None:
        vars(self).update(values)

    @classmethod
    def _members(cls) -> dict[str, Option | Group]:
        members = {name: member for kind in reversed(cls.__mro__) for name, member in vars(kind).items()}
        return {name: member for name, member in members.items() if isinstance(member, Option | Group)}

    @classmethod
    def options(cls) -> list[Option]:
        """Return the options in their order."""
        options: list[Option] = []
        for name, member in cls._members().items():
            options += member.options() if isinstance(member, Group) else [_with_name(name, member, cls.heading)]
        return options

    @classmethod
    def of(cls, values: Facts) -> Self:
        """Return an instance with the values of its options, which are removed from `values`."""
        members = cls._members().items()
        return cls(**{name: m.of(values) if isinstance(m, Group) else values.pop(name) for name, m in members})


def _with_name(name: str, param: Param, heading: str | None = None) -> Param:
    """Return a copy of an option or argument, with the name of the argument of a function."""
    copied = copy.copy(param)
    copied.name = name
    if param.opts == [_UNNAMED]:
        copied.opts = [f"--{name.replace('_', '-')}"]
    if heading is not None and isinstance(copied, Option):
        copied.heading = heading
    return copied


class Command(click.Command):
    """A command whose ``--help`` lists its options under headings, the most common first."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Parse the command line; the error for too many files states which files are expected."""
        try:
            return super().parse_args(ctx, args)
        except click.UsageError as error:
            if not error.message.startswith("Got unexpected extra argument"):
                raise
            names = " ".join((param.name or "").upper() for param in self.params if isinstance(param, click.Argument))
            advice = f"give {names}, one each; save images of several files as one stack, such as a TIFF"
            raise click.UsageError(f"too many files: {advice}", ctx) from None

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the options."""
        rows: dict[str, list[tuple[str, str]]] = {}
        for part in self.get_params(ctx):
            if isinstance(part, click.Option) and (record := part.get_help_record(ctx)):
                rows.setdefault(getattr(part, "heading", "Options"), []).append(record)
        for heading, records in rows.items():
            with formatter.section(heading):
                formatter.write_dl(records)


def _require_distinct_files(params: Iterable[click.Parameter], given: Facts) -> None:
    """Raise ValueError if a file to write is also a file to read, or another file to write."""
    checked: list[tuple[str, Path]] = []
    for param in sorted(params, key=lambda p: isinstance(p.type, _OutputPath)):
        value = given.get(param.name or "")
        for item in value if isinstance(value, tuple) else (value,):
            if not isinstance(item, str | Path):
                continue
            path, name = Path(item), param.opts[-1] if param.opts[-1].startswith("-") else (param.name or "").upper()
            for earlier_name, earlier_path in checked if isinstance(param.type, _OutputPath) else ():
                if _same_file(path, earlier_path):
                    raise ValueError(f"{name} must be another file than {earlier_name}, got {item} for both")
            checked.append((name, path))


def _same_file(path: Path, other_path: Path) -> bool:
    try:
        return path.samefile(other_path)
    except (OSError, ValueError):  # a file does not exist, or a name is not a path
        return path == other_path


def command(
    *params: click.Parameter, kind: type[Command] = Command
) -> Callable[[Callable[..., Report | None]], Command]:
    """Return a decorator that converts a function to a command: its docstring is the help, its report is printed.

    The parameters of the command are the defaults of the arguments of the function (options or groups of options),
    and then `params`.

    Errors that a user can cause are printed in one line, with exit code 2; errors of the program have exit code 1. A
    fit that did not converge, or a data set without some of its pictures, has exit code 3, and a fit that converged,
    but is in doubt, exit code 4. With the environment
    variable LOMMEL_TRACEBACK set, Python's traceback is shown instead.
    """

    def decorate(function: Callable[..., Report | None]) -> Command:
        all_params, groups = _parameters_of(function)
        all_params += params

        def run(as_json: bool = False, **given: Any) -> None:
            context = click.get_current_context()
            flags = {
                part.name or "": max(part.opts, key=len) for part in all_params if isinstance(part, click.Option)
            }
            stated = {n for n in flags if context.get_parameter_source(n) is ParameterSource.COMMANDLINE}
            if code := run_job(lambda: job(given), flags, stated, as_json=as_json):
                sys.exit(code)

        def job(given: Facts) -> Report | None:
            if given.get("figure") is not None:  # before anything is computed
                figure_format(given["figure"])
            _require_distinct_files(all_params, given)
            for name, group in groups.items():
                given[name] = group.of(given)
            return function(**given)

        return kind(function.__name__, params=all_params, help=_help_of(function), callback=run)

    return decorate


def _parameters_of(function: Callable[..., object]) -> tuple[list[click.Parameter], dict[str, type[Group]]]:
    """Return the parameters in the defaults of the arguments of a function, and the groups among them by name."""
    params: list[click.Parameter] = []
    groups: dict[str, type[Group]] = {}
    for name, argument in inspect.signature(function).parameters.items():
        value = argument.default
        if isinstance(value, Group):
            groups[name] = type(value)
            params += groups[name].options()
        elif isinstance(value, click.Parameter):
            params.append(_with_name(name, value))
    return params, groups


def _help_of(function: Callable[..., object]) -> str:
    """Return the docstring of a command as its help."""
    # In help a heading has a colon instead of an underline; a line of \b keeps the line breaks of the examples.
    text = inspect.cleandoc(function.__doc__ or "").replace("Examples\n--------\n", "Examples:\n")
    text = text.replace("\n\nExample", "\n\n\b\nExample")
    return "\n".join(_continued(row) for row in text.split("\n"))


_WIDTH = 76  # largest width of lines in help, which Click indents by two


def _continued(row: str) -> str:
    """Return a line of an example; lines wider than the help at 80 columns are continued before an option."""
    if not row.startswith("  lommel ") or len(row) <= _WIDTH:
        return row
    rows, current = [], ""
    for word in re.split(r" (?=-[-a-zA-Z])", row):
        if current and len(f"{current} {word} \\") > _WIDTH:
            rows.append(f"{current} \\")
            current = f"      {word}"
        else:
            current = f"{current} {word}" if current else word
    return "\n".join([*rows, current])


JSON = Option("--json", "as_json", is_flag=True, help="Print the results as JSON.")


def plot_option(contents: str, flag: str = "--plot") -> Any:
    """Return the option for a figure."""
    return Option(flag, "figure", type=OUTPUT, help=f"{contents}: .png, .pdf or .svg.")
