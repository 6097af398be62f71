"""What the commands share: lengths with units, one-line errors, progress on standard error, JSON."""

from __future__ import annotations

import functools
import json
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import click
from rich.console import Console
from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

from lommel.units import parse_length


class Length(click.ParamType[float]):
    """A length with a unit, in metres."""

    name = "length"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Return metres."""
        try:
            return parse_length(value)
        except ValueError as error:
            self.fail(str(error), param, ctx)


def one_line_errors(command: Callable[..., None]) -> Callable[..., None]:
    """Turn what a user can cause into one line on standard error and exit code 2."""

    @functools.wraps(command)
    def guarded(*args: Any, **kwargs: Any) -> None:
        try:
            command(*args, **kwargs)
        except (ValueError, TypeError, ArithmeticError, OSError, ImportError, MemoryError) as error:
            if isinstance(error, OSError) and error.strerror:
                message = f"{error.filename}: {error.strerror}" if error.filename else error.strerror
            else:
                message = str(error) or type(error).__name__
            click.echo(f"Error: {message}", err=True)
            sys.exit(2)

    return guarded


@contextmanager
def progress(description: str, total: int | None = None) -> Iterator[Callable[[str], None]]:
    """Show a bar on standard error, if that is a terminal; yields what announces each step."""
    columns = [SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn()]
    console = Console(stderr=True)
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as bar:
        task = bar.add_task(description, total=total)
        count = 0

        def started(name: str) -> None:
            nonlocal count
            bar.update(task, description=name, completed=count)
            count += 1

        yield started


def print_json(data: dict[str, Any]) -> None:
    """Print plain data as JSON on standard output."""
    click.echo(json.dumps(data, indent=2, allow_nan=False))
