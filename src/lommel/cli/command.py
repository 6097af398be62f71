"""Commands generated from functions, options classes and docstrings by cyclopts, which only this module imports.

A command is a function that returns a report::

    @command
    def depth(
        photos: list[Path],  # arguments before / are files, or other values without a flag
        lens: Path,
        /,
        *,
        options: DepthOptions = DepthOptions(),  # its fields are options, under the heading of the class
        output: Annotated[Path | None, OUTPUT] = None,  # other arguments are options of the command itself
    ) -> Report:
        '''Estimate depth from photographs at several foci.

        The text, the Parameters and the Examples are the help.

Parameters
----------
        output
            Depth map in metres: .tif or .npy.

Examples
--------
          lommel depth near.tif far.tif lens.toml --focus 1.5m --focus 1.8m
        '''

The annotations (:mod:`lommel.base.options`) give types, ranges, units and flags. The help of a field is its text in
the command's docstring or, where that has none, in the options class. A default that differs from that of the class
stands in the instance that is the default of the argument. A tuple of any length is an option that may be repeated;
numbers of such a tuple may also follow one flag. Values are checked by the options class, and errors of the library
name the flags of the command instead of its arguments.
"""

from __future__ import annotations

import dataclasses
import inspect
import io
import itertools
import re
import sys
from collections.abc import Callable, Iterable, Sequence
from functools import cache, partial
from pathlib import Path
from typing import Annotated, Any, TypeVar, get_args, get_origin, get_type_hints

from cyclopts import App, CoercionError, CycloptsError, Group, MissingArgumentError, Parameter, UnusedCliTokensError
from cyclopts.help import HelpPanel, PlainFormatter
from rich.console import Console, ConsoleOptions

from lommel.base.encoding import parsed
from lommel.base.options import Field, Options, Shown, fields_of, sentences
from lommel.base.units import format_length, parse_length
from lommel.base.validation import brief, line, shown
from lommel.cli import help_text
from lommel.cli.messages import run_job
from lommel.cli.output import figure_format
from lommel.report import Report

_Function = TypeVar("_Function", bound=Callable[..., object])

OUTPUT = Shown(("--output", "-o"), metavar="FILE", writes=True)
"""Form of the file that a command writes."""

CLIENT = Shown(metavar="ADDRESS")
"""Form of the address of the scheduler of a cluster."""

ENCODING = Shown(metavar="srgb|linear|GAMMA", parse=parsed)
"""Form of an encoding."""

PLOT = Shown(("--plot",), metavar="FILE", writes=True, figure=True)
"""Form of the file to which a command draws a figure: .png, .pdf or .svg."""


_JSON = Field.of("as_json", Annotated[bool, Shown(("--json",))], False)


class Command:
    """A command of ``lommel``: a function with the parameters of the command line."""

    def __init__(self, function: Callable[..., Report | None]) -> None:
        self.function = function
        hints = get_type_hints(function, include_extras=True)
        self.arguments: list[Field] = []
        self.options: list[tuple[str, Field]] = []  # with their headings
        self.groups: dict[str, Options] = {}
        self.own: list[str] = []
        for name, argument in inspect.signature(function).parameters.items():
            if argument.kind is argument.POSITIONAL_ONLY:
                self.arguments.append(Field.of(name, hints[name], argument.default))
            elif isinstance(argument.default, Options):
                self.groups[name] = argument.default
                heading = getattr(argument.default, "heading", "Options")
                fields = (
                    field._replace(default=getattr(argument.default, field.name))
                    for field in fields_of(type(argument.default))
                )
                self.options += [(heading, field) for field in fields if not field.shown.hidden]
            else:
                self.own.append(name)
                self.options.append(("Options", Field.of(name, hints[name], argument.default)))
        self.prints_json = hints.get("return") not in (None, type(None))

    @property
    def flags(self) -> dict[str, str]:
        """Flags in messages, by the names of arguments."""
        return {field.name: _flags(field)[0] for _, field in self.options}

    def usage(self, name: str) -> str:
        """Return how the command is called."""
        words = []
        for field in self.arguments:
            word = f"{_metavar(field)}{'...' if get_origin(field.kind) in (list, tuple) else ''}"
            words.append(word if field.default is inspect.Parameter.empty else f"[{word}]")
        return " ".join(["lommel", name, "[OPTIONS]", *words])

    def _do(self, given: dict[str, Any]) -> Report | None:
        """Do the job with the `given` values."""
        fields = [*self.arguments, *(field for _, field in self.options)]
        for field in fields:
            if field.shown.figure and given.get(field.name) is not None:  # before anything is computed
                figure_format(given[field.name])
        _require_distinct_files(fields, given)
        words = [given.get(field.name, field.default) for field in self.arguments]
        stated = {name: given[name] for name in self.own if name in given}
        for name, base in self.groups.items():
            own = {f.name: given[f.name] for f in fields_of(type(base)) if f.name in given}
            stated[name] = dataclasses.replace(base, **own) if own else base
        for _, field in self.options:
            if field.name in stated:
                stated[field.name] = field.check(stated[field.name])
        return self.function(*words, **stated)

    def add_to(self, app: App, name: str) -> None:
        """Add the command to an application."""
        text, _, examples = inspect.cleandoc(self.function.__doc__ or "").partition("\n\nExamples\n--------\n")
        text = text.partition("\n\nParameters\n----------\n")[0]
        kind = inspect.Parameter.POSITIONAL_ONLY
        parameters = [
            inspect.Parameter(field.name, kind, annotation=_argument(field), default=field.default)
            for field in self.arguments
        ]
        for heading, field in self.options:
            source = next((type(base) for base in self.groups.values() if hasattr(base, field.name)), self.function)
            own_text = sentences(self.function, field.name)
            parameters.append(_option(field, heading, own_text or sentences(source, field.name)))
        if self.prints_json:
            parameters.append(_option(_JSON, "Options", "Print the results as JSON."))

        def run(*words: Any, as_json: bool = False, **options: Any) -> int:
            given = dict(zip([field.name for field in self.arguments], words, strict=False)) | options
            return run_job(partial(self._do, given), self.flags, given.keys(), as_json=as_json)

        run.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
        run.__annotations__ = {p.name: p.annotation for p in parameters}
        run.__doc__ = "\n\n".join(" ".join(part.split()) for part in text.split("\n\n"))
        epilogue = help_text.examples(examples) if examples else None
        app.command(run, name=name, help_epilogue=epilogue, usage=f"Usage: {self.usage(name)}")

    def arranged(self, words: Sequence[str]) -> list[str]:
        """Return the words of a command line, files first; each of several numbers after a flag gets its own flag."""
        fields = {flag: field for _, field in self.options for flag in (*_flags(field), field.shown.negative)}
        options: list[str] = []
        files: list[str] = []
        rest = list(words)
        while rest:
            word = rest.pop(0)
            if word == "--":
                return [*options, word, *files, *rest]
            numbers = []
            if word in fields and _is_series(fields[word].kind):
                numbers = list(itertools.takewhile(lambda word: is_number(word.partition(",")[0]), rest))
                del rest[: len(numbers)]
            if numbers:
                options += [f"{word}={number}" for number in numbers]
            elif word in fields:
                count = _count(fields[word])
                options += [word, *rest[:count]]
                del rest[:count]
            else:
                (options if word.startswith("-") and not is_number(word) else files).append(word)
        return [*files, *options]


def command(function: Callable[..., Report | None]) -> Command:
    """Return the command of a function (a decorator)."""
    return Command(function)


class _Formatter(PlainFormatter):
    """Help as plain text: a heading, then options and their descriptions in two columns."""

    def __call__(self, console: Console, options: ConsoleOptions, panel: HelpPanel) -> None:
        """Print a list of options."""
        rows = []
        for entry in panel.entries:
            notes = [f"[{', '.join(entry.choices)}]"] if entry.choices else []
            notes += [] if entry.default is None else [f"[default: {entry.default}]"]
            text = " ".join(filter(None, [_plain(entry.description), *notes]))
            rows.append((", ".join(entry.display_labels_with_metavar), text))
        if rows:
            self._print_plain(console, help_text.section(str(panel.title), rows) + "\n")

    def render_description(self, console: Console, options: ConsoleOptions, description: Any) -> None:
        """Print the description, wrapped."""
        self._print_plain(console, help_text.paragraphs(_plain(description)) + "\n")


def _plain(part: Any) -> str:
    """Return what rich prints as text without line breaks of its own."""
    file = io.StringIO()
    Console(file=file, width=100_000, markup=False, emoji=False, highlight=False).print("" if part is None else part)
    return file.getvalue().strip()


def application() -> App:
    """Return an application without commands."""
    return App(
        name="lommel",
        help_flags=("--help", "-h"),
        version_flags=(),
        help_format="plaintext",
        result_action="return_value",
        help_formatter=_Formatter(),
    )


def call(app: App, words: Sequence[str]) -> int:
    """Parse words, run their command, and return the exit code: 2, with one line, for words that are wrong."""
    try:
        function, bound, _ = app.parse_args(words, exit_on_error=False, print_error=False)
    except CycloptsError as error:
        print(f"Error: {brief(_message(error), 240)}", file=sys.stderr)
        return 2
    return function(*bound.args, **bound.kwargs) or 0


def _message(error: CycloptsError) -> str:
    name = "" if error.argument is None else error.argument.name
    if isinstance(error, CoercionError) and error.msg and name:
        return f"{name}: {error.msg}"
    if isinstance(error, CoercionError) and error.token and name and error.target_type in (int, float):
        kind = "an integer" if error.target_type is int else "a number"
        given, advice = error.token.value, ""
        if "," in given:
            advice = f"; several numbers follow with blanks: {name} {given.replace(',', ' ')}"
        return f"{name} must be {kind}, got {shown(given)}{advice}"
    if isinstance(error, MissingArgumentError) and name:
        return f"{name} needs a value" if name.startswith("-") else f"{name} is missing"
    if isinstance(error, UnusedCliTokensError):
        advice = "save images of several files as one stack, such as a TIFF"
        return f"too many files, got {shown((error.unused_tokens or ['more'])[0])}; {advice}"
    return line(error)


_NUMBER = r"\d+\.?\d*|\.\d+"
_MIN_NANOMETRES = 10.0  # smallest number without a unit that is taken for nanometres
_TYPICAL = {"m": "1.5", "mm": "50", "um": "3.45", "nm": "550"}
"""Examples of lengths in error messages, by unit."""


def length(unit: str, text: str) -> float:
    """Return a length in metres; the error for a number without a unit suggests the number with `unit`."""
    number = text.strip()
    if re.fullmatch(_NUMBER, number) is None:
        number = _TYPICAL[unit]
    elif unit == "nm" and float(number) < _MIN_NANOMETRES:
        unit = "um"  # steps and wavelengths are as often written in micrometres
    return parse_length(text, f"{number} {unit}")


def _flags(field: Field) -> tuple[str, ...]:
    return field.shown.flags or (f"--{field.name.replace('_', '-')}",)


def is_number(word: str) -> bool:
    """Return True if a word of the command line is a number."""
    try:
        float(word)
    except ValueError:
        return False
    return True


@cache
def _group(heading: str) -> Group:
    return Group.create_ordered(heading)


def _is_series(kind: Any) -> bool:
    return get_origin(kind) is tuple and get_args(kind)[0] in (int, float) and get_args(kind)[1:] == (...,)


def _count(field: Field) -> int:
    """Return the number of words of a value."""
    if field.kind is bool:
        return 0
    several = get_origin(field.kind) is tuple and get_args(field.kind)[1:] != (...,)
    return len(get_args(field.kind)) if several else 1


def _metavar(field: Field) -> str:
    return field.shown.metavar or field.name.upper()


def _argument(field: Field) -> Any:
    """Return the annotation of an argument without a flag."""
    return Annotated[_hint(field), Parameter(show=False, metavar=_metavar(field), **_conversion(field))]


def _option(field: Field, heading: str, text: str) -> inspect.Parameter:
    """Return the parameter of an option, which is listed under a heading."""
    form, default = field.shown, field.default
    settings: dict[str, Any] = {"name": _flags(field), "help": text, "negative": form.negative or ()}
    if form.metavar or form.length or form.parse:
        settings["metavar"] = form.metavar or ("LENGTH" if form.length else "VALUE")
    show: Any = False
    if isinstance(default, float) and form.length:
        show = format_length
    elif isinstance(default, int | float | str) and not isinstance(default, bool) and default != "":
        show = True
    elif isinstance(default, tuple) and default:
        show = lambda values: " ".join(map(str, values))  # noqa: E731
    stated = Parameter(group=_group(heading), show_default=show, **settings, **_conversion(field))
    kind, hint = inspect.Parameter.KEYWORD_ONLY, Annotated[_hint(field), stated]
    return inspect.Parameter(field.name, kind, annotation=hint, default=default)


def _hint(field: Field) -> Any:
    kind = field.kind
    if field.shown.parse or field.shown.length:  # a converter makes the value, whatever its type
        kind = Any
        if get_origin(field.kind) is tuple:
            parts = get_args(field.kind)
            kind = tuple[(Any, ...) if parts[1:] == (...,) else (Any,) * len(parts)]  # type: ignore[misc]
    return kind | None if field.optional and kind is not Any else kind


def _conversion(field: Field) -> dict[str, Any]:
    """Return the settings of the conversion of words to a value."""
    form = field.shown
    parse = form.parse or (partial(length, form.length) if form.length else None)
    if parse is None:
        return {}
    several = get_origin(field.kind) is tuple

    def convert(_: Any, tokens: Sequence[Any]) -> Any:
        values = tuple(parse(token.value) for token in tokens)
        return values if several else values[0]

    return {"converter": convert, "n_tokens": _count(field), "allow_leading_hyphen": True}  # of negative lengths


def _require_distinct_files(fields: Iterable[Field], given: dict[str, Any]) -> None:
    """Raise ValueError if a file to write is also a file to read, or another file to write."""
    checked: list[tuple[str, Path]] = []
    for field in sorted(fields, key=lambda field: field.shown.writes):
        value = given.get(field.name)
        for item in value if isinstance(value, tuple | list) else (value,):
            if not isinstance(item, str | Path):
                continue
            path, name = (
                Path(item),
                _flags(field)[0] if field.shown.writes or field.shown.flags else field.name.upper(),
            )
            for earlier_name, earlier_path in checked if field.shown.writes else ():
                if _same_file(path, earlier_path):
                    raise ValueError(f"{name} must be another file than {earlier_name}, got {item} for both")
            checked.append((name, path))


def _same_file(path: Path, other_path: Path) -> bool:
    try:
        return path.samefile(other_path)
    except (OSError, ValueError):  # a file does not exist, or a name is not a path
        return path == other_path
