"""Progress of commands on the terminal, and the files that they write."""

from __future__ import annotations

import errno
import os
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from datetime import timedelta
from pathlib import Path
from typing import TYPE_CHECKING

from lommel.base import atomic, optional
from lommel.base.validation import line, shown
from lommel.report import Report

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from rich.progress import Progress


_RECENT = 5.0  # seconds over which the share of the processor is measured
_LEAST_SHARE = 0.05  # of the processor, from which remaining time is in proportion to processor time
# Seconds of a step after which its remaining time is printed once where there is no bar, if it is longer than this.
_FIRST_TIME, _LONG = 10.0, 30.0
_FIRST_FRACTION, _MOST_LEFT = 0.02, 1e6  # fraction from which the remaining time is told; the longest time, seconds


class Steps:
    """Progress of a command in `total` steps, or as a fraction; `bar` is None if there is no terminal.

    With `elsewhere`, workers of a cluster do the work. A terminal or a reader of a pipe that is gone is no error: it
    must not end a recording.
    """

    def __init__(self, bar: Progress | None, description: str, total: int | None, *, elsewhere: bool = False) -> None:
        self._bar, self._total, self._elsewhere = bar, total, elsewhere
        self._count, self._fraction, self._begun = 0, 0.0, -1.0  # begun: where the current step begins, if known
        self._start, self._recent, self._load = self._clock(), self._clock(), 1.0
        self._is_told = False
        self._task = None if bar is None else bar.add_task(description, total=total, left=_in_time(None))

    @staticmethod
    def _clock() -> tuple[float, float]:
        """Return the time, and the processor time of this process, seconds."""
        return time.monotonic(), time.process_time()

    def left(self, fraction: float) -> float:
        """Return the remaining time, seconds, after a fraction of the work since the first fraction of this step.

        It is in proportion to processor time: other programs slow all work, now as in the last seconds.
        """
        now = self._clock()
        if now[0] - self._recent[0] > _RECENT or self._recent == self._start:
            self._load = (now[0] - self._recent[0]) / max(now[1] - self._recent[1], 1e-3)
        if now[0] - self._recent[0] > _RECENT:
            self._recent = now
        elapsed, used = now[0] - self._start[0], now[1] - self._start[1]
        here = used > _LEAST_SHARE * elapsed and not self._elsewhere  # else other processes do the work
        passed = used * self._load if here else elapsed
        return passed * (1.0 - fraction) / max(fraction - max(self._begun, 0.0), 1e-6)

    def __call__(self, name: str, fraction: float | None = None) -> None:
        """Show the name of the next step or, with the fraction done (0 to 1), of the current step."""
        self._count += fraction is None
        if fraction is not None:
            self._fraction = min(max(fraction, self._fraction), 1.0)  # estimates of the remaining time may increase
            if self._begun <= 0.0:  # what an earlier call did took no time, and preparations are not in proportion
                self._begun, self._start = fraction, self._clock()
                self._recent = self._start
        elif self._total:
            fraction = self._fraction = (self._count - 1) / self._total
        else:
            self._begun, self._start = -1.0, self._clock()
            self._recent = self._start
        left = None
        if fraction is not None and fraction - max(self._begun, 0.0) > _FIRST_FRACTION:
            left = self.left(fraction)
        elapsed = self._clock()[0] - self._start[0]
        if self._bar is None and not self._is_told and left is not None and left > _LONG and elapsed > _FIRST_TIME:
            self._is_told = True
            self.tell(f"{name}: about {_in_time(left)} left.")
        if self._bar is not None and self._task is not None:
            done = None if fraction is None else self._fraction
            self._bar.update(self._task, description=name, total=1.0, completed=done, left=_in_time(left))

    def tell(self, sentence: str) -> None:
        """Print a sentence, above the bar."""
        from rich.console import Console

        console = Console(stderr=True) if self._bar is None else self._bar.console
        with suppress(OSError):
            console.print(sentence, soft_wrap=self._bar is None, highlight=False, markup=False, emoji=False)


def _in_time(seconds: float | None) -> str:
    """Return a time as text, such as "0:01:30"."""
    return "-:--:--" if seconds is None else str(timedelta(seconds=round(min(seconds, _MOST_LEFT))))


@contextmanager
def progress(
    description: str, total: int | None = None, *, endless: bool = False, elsewhere: bool = False
) -> Iterator[Steps]:
    """Yield a function that reports steps on a bar, if standard error is a terminal, else one line of a long job.

    With `endless`, for video, no fraction is known, and the bar is omitted; `elsewhere` is that of :class:`Steps`.
    """
    from rich.console import Console

    console = Console(stderr=True)
    if not console.is_terminal:
        # Even a disabled bar may leave an end of line.
        yield Steps(None, description, total, elsewhere=elsewhere)
        return
    from rich import progress as bars

    columns: list[bars.ProgressColumn] = [bars.SpinnerColumn(), bars.TextColumn("{task.description}")]
    if not endless:
        columns += [bars.BarColumn(), bars.TaskProgressColumn(text_format_no_percentage="")]
        columns += [
            bars.TimeElapsedColumn(),
            bars.TextColumn("[dim]left"),
            bars.TextColumn("[cyan]{task.fields[left]}"),
        ]
    with bars.Progress(*columns, console=console, transient=True) as bar:
        yield Steps(bar, description, total, elsewhere=elsewhere)


def written(paths: Iterable[Path | None], note: Callable[[Path], str] = lambda _: "") -> Report:
    """Return the report of the files that were written, each with a note."""
    files = [path for path in paths if path is not None]
    return Report({"files": [str(path) for path in files]}, [f"wrote {path}{note(path)}" for path in files])


def figure_format(path: Path) -> str:
    """Return the format of a figure by its suffix; raise an error if it cannot be drawn or written."""
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


def save_figure(draw: Callable[[], Figure | Axes], path: Path | None) -> None:
    """Write what a function draws, if there is a path."""
    if path is not None:
        figure = draw().get_figure(root=True)
        assert figure is not None
        atomic.write(path, atomic.contents(figure.savefig, format=figure_format(path), dpi=150))
