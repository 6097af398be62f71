"""Signals that end a command, which leaves whole files."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Self, TypeVar

_HANGUP: signal.Signals | None = getattr(signal, "SIGHUP", None)  # None on Windows
Frame = TypeVar("Frame")


class Stop:
    """A request by a signal to end a loop over frames, once the frame in progress is written.

    The signals are SIGINT (Ctrl-C), SIGTERM and SIGHUP (the terminal was closed), unless SIGHUP is ignored (nohup).
    """

    def __init__(self) -> None:
        self.requested = False
        self._waiting = True  # no frame is being written, and no file is open before the first one

    @contextmanager
    def signals(self) -> Iterator[Self]:
        """Handle the signals within a ``with`` block; a second Ctrl-C interrupts without waiting for the frame."""

        def handle(number: int, _frame: FrameType | None) -> None:
            if number == _HANGUP:
                _leave_terminal()
            repeated, self.requested = self.requested, True
            # Systems repeat the other signals: a shell and the kernel both send SIGHUP.
            if self._waiting or (repeated and number == signal.SIGINT):
                self._waiting = False
                raise KeyboardInterrupt

        numbers = [signal.SIGINT, signal.SIGTERM]
        if _HANGUP is not None and signal.getsignal(_HANGUP) != signal.SIG_IGN:
            numbers.append(_HANGUP)
        handlers = {number: signal.signal(number, handle) for number in numbers}
        try:
            yield self
        finally:
            for number, handler in handlers.items():
                signal.signal(number, handler)

    def next(self, frames: Iterator[Frame]) -> Frame | None:
        """Return the next frame, or None at the end of the video or at a signal."""
        try:
            self._waiting = True
            return None if self.requested else next(frames, None)
        except KeyboardInterrupt:
            return None
        finally:
            self._waiting = False


def _leave_terminal() -> None:
    """Redirect output to the null device where the terminal is gone: writing the summary would fail."""
    for stream in (1, 2):
        try:
            os.write(stream, b"")
        except OSError:
            discard(stream)


def discard(stream: int) -> None:
    """Redirect a stream to the null device."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), stream)
