"""Progress bar on standard error: current step, fraction done and remaining time."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.progress import Progress


class Steps:
    """Progress of a command in `total` steps or as a fraction done; `bar` is None where there is no terminal."""

    def __init__(self, bar: Progress | None, description: str, total: int | None) -> None:
        self._bar, self._total = bar, total
        self._begun, self._shown = 0, 0.0
        self._task = None if bar is None else bar.add_task(description, total=total)

    def __call__(self, name: str, share: float | None = None) -> None:
        """Show the name of the next step, or of the current one with the fraction done, 0 to 1."""
        if self._bar is None or self._task is None:
            return
        if share is not None:
            self._shown = min(max(share, self._shown), 1.0)  # estimates of the remaining time may increase
            self._bar.update(self._task, description=name, total=1.0, completed=self._shown)
            return
        done = None if self._total is None else self._begun
        self._bar.update(self._task, description=name, completed=done)
        self._begun += 1


@contextmanager
def progress(description: str, total: int | None = None) -> Iterator[Steps]:
    """Show a bar on standard error if that is a terminal; yield the function that announces each step."""
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
