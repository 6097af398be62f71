"""What both widgets share: the choice of an objective; buttons to start and stop, progress, and a line of text."""

from __future__ import annotations

from collections.abc import Callable, Generator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lommel.lensfiles.example_files import of_kind
from lommel.lensfiles.microscope_files import Microscope, load_microscope

if TYPE_CHECKING:
    from magicgui.widgets import Container


class Cancelled(Exception):  # noqa: N818 (no error)
    """The user has stopped the work."""


def start(
    work: Callable[[Callable[[float], None]], Any],
    *,
    done: Callable[[Any], object],
    failed: Callable[[Exception], object],
    progress: Callable[[float], object],
) -> Callable[[], None]:
    """Start work in a thread and return a function that asks it to stop.

    `work` is called with a function that takes the share done; that raises :class:`Cancelled` once asked to stop. The
    others are called in the thread of the windows: `done` with the result, or None where the work was stopped.
    """
    from napari.qt.threading import create_worker

    stop = False

    def shares() -> Generator[float, None, Any]:
        yield 0.0

        def tell(share: float) -> None:
            if stop:
                raise Cancelled
            worker.yielded.emit(share)

        try:
            return work(tell)
        except Cancelled:
            return None

    # Errors are told in the widget; raised again between windows they would end napari.
    worker = create_worker(shares, _start_thread=False, _ignore_errors=True)
    worker.yielded.connect(progress)
    worker.returned.connect(done)
    worker.errored.connect(failed)
    worker.start()

    def ask() -> None:
        nonlocal stop
        stop = True

    return ask


class ObjectiveFields:
    """Two fields: an objective of the examples, or the file of one."""

    def __init__(self) -> None:
        from magicgui.widgets import ComboBox, FileEdit

        self.name = ComboBox(label="objective", choices=list(of_kind("objective")), value="zeiss-63x-1.4-oil")
        self.file = FileEdit(label="or file", filter="*.toml", nullable=True, value=None)

    def chosen(self) -> Microscope:
        """Return the microscope of the file, or of the example where there is none."""
        own = self.file.value is not None and Path(self.file.value).is_file()
        return load_microscope(self.file.value if own else of_kind("objective")[self.name.value])

    def connect(self, fill: Callable[[], object]) -> None:
        """Call a function whenever another one is chosen."""
        self.name.changed.connect(fill)
        self.file.changed.connect(fill)


class Panel:
    """Fields of a widget, with a button that works on them in a thread, and one that stops it."""

    def __init__(self, fields: list[Any], label: str, begin: Callable[[], Callable[[Callable[[float], None]], Any]],
                 done: Callable[[Any], str]) -> None:  # fmt: skip
        from magicgui.widgets import Container, Label, ProgressBar, PushButton

        self.run, self.cancel = PushButton(text=label), PushButton(text="Cancel", enabled=False)
        self.bar, self.status = ProgressBar(min=0, max=100, value=0), Label(value="")
        buttons = Container(widgets=[self.run, self.cancel], layout="horizontal", labels=False)
        self.widget: Container[Any] = Container(widgets=[*fields, buttons, self.bar, self.status])
        self._begin, self._done = begin, done
        self._stop: Callable[[], None] = lambda: None
        self.run.clicked.connect(self.start)
        self.cancel.clicked.connect(self.stop)
        self.widget.panel = self  # keeps it as long as the widget, and lets tests find it

    def start(self) -> None:
        """Start the work of the fields."""
        try:
            job = self._begin()
        except Exception as error:
            self._say(error)
            return
        self._busy(True)
        self.status.value = "working"
        self._stop = start(job, done=self._finish, failed=self._say, progress=self._show)

    def stop(self) -> None:
        """Ask the work to stop."""
        self._stop()

    def _show(self, share: float) -> None:
        self.bar.value = round(100 * min(max(share, 0.0), 1.0))

    def _finish(self, result: Any) -> None:
        self._busy(False)
        self.status.value = "cancelled" if result is None else self._done(result)

    def _say(self, error: Exception) -> None:
        self._busy(False)
        self.status.value = str(error) or type(error).__name__

    def _busy(self, busy: bool) -> None:
        self.run.enabled, self.cancel.enabled = not busy, busy
        self.bar.value = 0
