"""What the commands print and write: reports, tables, figures, and the progress of long ones."""

from __future__ import annotations

import errno
import json
import os
import re
import sys
import textwrap
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

import click

from lommel.base import atomic, optional
from lommel.base.arrays import Json
from lommel.base.units import percent
from lommel.base.validation import line, shown

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.console import Console, ConsoleOptions, RenderableType
    from rich.progress import Progress
    from rich.table import Table
    from rich.text import Text

_FIRST = 30.0  # seconds after which a log gets its first line
_LATER = 1.25  # times the time that has passed, at which it gets the next one, if not 30 seconds later


class Steps:
    """Progress of a command in `total` steps or as a fraction done; `bar` is None where there is no terminal."""

    def __init__(self, bar: Progress | None, description: str, total: int | None) -> None:
        self._bar, self._total = bar, total
        self._begun, self._shown = 0, 0.0
        self._task = None if bar is None else bar.add_task(description, total=total)
        self._start = time.monotonic()
        self._next = _FIRST

    def __call__(self, name: str, share: float | None = None) -> None:
        """Show the name of the next step, or of the current one with the fraction done, 0 to 1."""
        if share is not None:
            self._shown = min(max(share, self._shown), 1.0)  # estimates of the remaining time may increase
        elif self._total:
            self._shown = self._begun / self._total
        if self._bar is None or self._task is None:
            self._log(name)
        elif share is not None:
            self._bar.update(self._task, description=name, total=1.0, completed=self._shown)
        else:
            self._bar.update(self._task, description=name, completed=None if self._total is None else self._begun)
        self._begun += share is None

    def tell(self, sentence: str) -> None:
        """Print a sentence, above the bar."""
        from rich.console import Console

        console = Console(stderr=True) if self._bar is None else self._bar.console
        console.print(sentence, soft_wrap=self._bar is None, highlight=False, markup=False, emoji=False)

    def _log(self, name: str) -> None:
        """Write a line now and then."""
        spent = time.monotonic() - self._start
        if spent < self._next:
            return
        self._next = max(spent + _FIRST, _LATER * spent)
        left = ""
        if self._shown > 0.0:
            left = f", {percent(self._shown)}, about {_lasting(spent * (1.0 / self._shown - 1.0))} left"
        print(f"{_lasting(spent)}{left}: {name}", file=sys.stderr, flush=True)


def _lasting(seconds: float) -> str:
    """Return a time in words."""
    return f"{seconds:.0f} s" if seconds < 99.5 else f"{seconds / 60.0:.0f} min"


@contextmanager
def progress(description: str, total: int | None = None, *, endless: bool = False) -> Iterator[Steps]:
    """Show a bar on standard error if that is a terminal, else a line now and then; yield what announces steps.

    What is `endless`, as video, has no share that is done, and no bar.
    """
    from rich.console import Console

    console = Console(stderr=True)
    if not console.is_terminal:
        # Not even an end of line, which a bar that is disabled may leave.
        yield Steps(None, description, total)
        return
    from rich import progress as bars

    columns: list[bars.ProgressColumn] = [bars.SpinnerColumn(), bars.TextColumn("{task.description}")]
    if not endless:
        columns += [bars.BarColumn(), bars.TaskProgressColumn(text_format_no_percentage="")]
        columns += [bars.TimeElapsedColumn(), bars.TextColumn("[dim]left"), bars.TimeRemainingColumn()]
    with bars.Progress(*columns, console=console, transient=True) as bar:
        yield Steps(bar, description, total)


Parts: TypeAlias = "list[RenderableType]"
"""Lines and tables of a report."""

Facts: TypeAlias = Json
"""Plain data as JSON has it: texts, numbers, lists and dictionaries of these, None."""


@dataclass(frozen=True)
class Report:
    """What a command has found: the facts that ``--json`` prints, and lines and tables that say the same.

    The exit code is 3 where a result is not to be trusted or not whole: a fit that did not converge, a data set
    without some of its pictures.
    """

    facts: Facts
    parts: Sequence[RenderableType]
    converged: bool = True

    def __add__(self, other: Report) -> Report:
        both = self.converged and other.converged
        return Report(self.facts | other.facts, [*self.parts, *other.parts], both)

    def print(self, *, as_json: bool = False) -> None:
        """Print the facts as JSON, or the parts, on standard output."""
        if as_json:
            click.echo(json.dumps(self.facts, indent=2, allow_nan=False))
            return
        from rich.console import Console

        # A pipe has no width; tables are then as wide as they need to be. Brackets in names are no markup.
        width = None if sys.stdout.isatty() or "COLUMNS" in os.environ else 160
        console = Console(width=width, markup=False, emoji=False, highlight=False)
        with console.capture() as captured:
            for part in self.parts:
                if isinstance(part, str):
                    console.print(Wrapped(part), crop=False)  # paths stay whole
                else:
                    console.print(part)
        # Tables fill their columns with blanks.
        click.echo(re.sub(r" +$", "", captured.get(), flags=re.MULTILINE), nl=False)


@dataclass(frozen=True)
class Wrapped:
    """A line that is broken between words only, with the rest indented."""

    text: str
    style: str = ""

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> Iterator[Text]:
        from rich.text import Text

        lines = textwrap.wrap(
            self.text, options.max_width, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False
        )
        # Words longer than a line, as paths are, stay whole.
        yield from (Text(line, self.style, no_wrap=True, overflow="ignore") for line in lines or [""])


def written(paths: Iterable[Path | None], note: Callable[[Path], str] = lambda _: "") -> Report:
    """Return the report of the files that were written, each with a note."""
    files = [path for path in paths if path is not None]
    return Report({"files": [str(path) for path in files]}, [f"wrote {path}{note(path)}" for path in files])


def table_of(
    names: Iterable[str],
    rows: Iterable[Sequence[str]],
    left: int = 0,
    no_wrap: bool = False,
    title: str | None = None,
) -> Table:
    """Return a table with columns of these names, numbers but for the column at `left`, which holds words."""
    from rich.table import Column, Table

    columns = [
        Column(name, justify="left" if place == left else "right", no_wrap=no_wrap)
        for place, name in enumerate(names)
    ]
    table = Table(*columns, box=None, pad_edge=False, title=title, title_justify="left")
    for row in rows:
        table.add_row(*row)
    return table


def list_of(rows: Iterable[tuple[str, str | None]], title: str = "") -> Table:
    """Return a table of names and values, without the names that have no value."""
    from rich.table import Column, Table

    columns = Column(style="cyan"), Column()
    table = Table(*columns, box=None, pad_edge=False, title=title, title_justify="left", show_header=False)
    for name, value in rows:
        if value is not None:
            table.add_row(name, value)
    return table


def paragraphs(*parts: Iterable[RenderableType]) -> Parts:
    """Return parts with a blank line between those that hold something."""
    found: Parts = []
    for part in map(list, parts):
        found += ["", *part] if found and part else part
    return found


def refused(facts: Facts) -> Parts:
    """Return the reasons why some results are missing."""
    return [Wrapped(f"not computed: {reason}", "dim") for reason in facts["refused"]]


def figure_format(path: Path) -> str:
    """Return the format of a figure by its suffix; an error where it cannot be drawn or written."""
    suffix = path.suffix.lower().lstrip(".")
    if suffix not in ("png", "pdf", "svg"):
        raise ValueError(f"a figure must end in .png, .pdf or .svg, got {shown(str(path))}")
    optional.require("matplotlib", f"nothing was computed: the figure {shown(path.name)} needs", "plot")
    require_folder(path)
    return suffix


def require_folder(path: Path) -> None:
    """Raise FileNotFoundError if the folder of a file does not exist, before any file is written."""
    if not path.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(path))


def require_file(path: Path | None, suffix: str, option: str = "--output") -> None:
    """Raise ValueError if a file ends in another suffix, and FileNotFoundError if its folder does not exist."""
    if path is not None:
        if path.suffix.lower() != suffix:
            raise ValueError(f"{option} must end in {suffix}, got {line(path.name)}")
        require_folder(path)


def save_figure(figure: Figure, path: Path) -> None:
    """Write a figure."""
    atomic.write(path, atomic.contents(figure.savefig, format=figure_format(path), dpi=150))
