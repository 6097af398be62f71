"""Work in a thread of napari, with progress and a way to stop it."""

from __future__ import annotations

from collections.abc import Callable, Generator
from typing import Any


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
