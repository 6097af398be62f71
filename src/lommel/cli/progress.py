"""Progress of long commands on standard error: current step, fraction done and remaining time."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.progress import Progress

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

    def _log(self, name: str) -> None:
        """Write a line now and then."""
        spent = time.monotonic() - self._start
        if spent < self._next:
            return
        self._next = max(spent + _FIRST, _LATER * spent)
        left = ""
        if self._shown > 0.0:
            left = f", {100.0 * self._shown:.0f} %, about {_lasting(spent * (1.0 / self._shown - 1.0))} left"
        print(f"{_lasting(spent)}{left}: {name}", file=sys.stderr, flush=True)


def _lasting(seconds: float) -> str:
    """Return a time in words."""
    return f"{seconds:.0f} s" if seconds < 99.5 else f"{seconds / 60.0:.0f} min"


@contextmanager
def progress(description: str, total: int | None = None) -> Iterator[Steps]:
    """Show a bar on standard error if that is a terminal, else a line now and then; yield what announces steps."""
    from rich.console import Console

    console = Console(stderr=True)
    if not console.is_terminal:
        # Not even an end of line, which a bar that is disabled may leave.
        yield Steps(None, description, total)
        return
    from rich import progress as bars

    columns = (
        bars.SpinnerColumn(),
        bars.TextColumn("{task.description}"),
        bars.BarColumn(),
        bars.TaskProgressColumn(text_format_no_percentage=""),
        bars.TimeElapsedColumn(),
        bars.TextColumn("[dim]left"),
        bars.TimeRemainingColumn(),
    )
    with bars.Progress(*columns, console=console, transient=True) as bar:
        yield Steps(bar, description, total)
