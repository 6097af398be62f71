"""Dispatch of plots, notebook tables and files of objects to functions that other modules register."""

from __future__ import annotations

from collections.abc import Callable
from functools import singledispatch
from typing import Any


def load() -> None:
    """Import the modules that register functions; the package, which stands above them, replaces this."""


@singledispatch
def plot(thing: object, *args: object, **options: object) -> Any:
    """Draw a pupil or a wavefront on axes of matplotlib, and return these."""
    return _registered(plot.dispatch, thing, "plot")(thing, *args, **options)


@singledispatch
def save(thing: object, *args: object, **options: object) -> None:
    """Write a wavefront to a file."""
    _registered(save.dispatch, thing, "file")(thing, *args, **options)


@singledispatch
def html(thing: object) -> str:
    """Return what a notebook shows: a picture beside a table of numbers."""
    text: str = _registered(html.dispatch, thing, "table")(thing)
    return text


def _registered(dispatch: Callable[[type], Callable[..., Any]], thing: object, what: str) -> Callable[..., Any]:
    load()
    found = dispatch(type(thing))
    if found is dispatch(object):
        raise TypeError(f"there is no {what} of a {type(thing).__name__}")
    return found


class Shown:
    """A thing that notebooks show as a picture beside a table."""

    def _repr_html_(self) -> str:
        return html(self)
