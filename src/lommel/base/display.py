"""Dispatch of plotting, notebook display and saving of objects to functions that other modules register."""

from __future__ import annotations

from collections.abc import Callable
from functools import singledispatch
from typing import Any, TypeVar

_Function = TypeVar("_Function", bound=Callable[..., object])


def load(kind: str) -> None:
    """Import what registers functions of a `kind`, "plot", "table", "file" or "beads"; the package replaces this."""


@singledispatch
def plot(item: object, *args: object, **options: object) -> Any:
    """Draw a PSF, a pupil or a wavefront on axes of matplotlib, and return the axes."""
    return _registered(plot.dispatch, item, "plot")(item, *args, **options)


@singledispatch
def save(item: object, *args: object, **options: object) -> None:
    """Write a PSF or a wavefront to a file."""
    _registered(save.dispatch, item, "file")(item, *args, **options)


@singledispatch
def html(item: object) -> str:
    """Return the HTML that a notebook shows: a picture beside a table of numbers."""
    text: str = _registered(html.dispatch, item, "table")(item)
    return text


def _registered(dispatch: Callable[[type], _Function], item: object, kind: str) -> _Function:
    load(kind)
    # Without a registered function, dispatch returns the function for `object`, which has called this function.
    function = dispatch(type(item))
    if function is dispatch(object):
        raise TypeError(f"there is no {kind} of a {type(item).__name__}")
    return function


_functions: dict[str, Callable[..., Any]] = {}


def register(name: str) -> Callable[[_Function], _Function]:
    """Return a decorator that registers a function under a name, for :func:`named`."""

    def decorate(function: _Function) -> _Function:
        _functions[name] = function
        return function

    return decorate


def named(name: str, kind: str) -> Callable[..., Any]:
    """Return the function registered under a name; first, if necessary, import the modules that register a `kind`."""
    if name not in _functions:
        load(kind)
    return _functions[name]


class Shown:
    """Base of objects that notebooks show as a picture beside a table."""

    def _repr_html_(self) -> str:
        return html(self)
