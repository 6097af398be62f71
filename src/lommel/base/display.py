"""Dispatch of plotting, notebook display and saving of objects to functions that other modules register."""

from __future__ import annotations

from collections.abc import Callable
from functools import singledispatch
from typing import Any, TypeVar

_Function = TypeVar("_Function", bound=Callable[..., object])


def load(what: str) -> None:
    """Import all modules that register a `what`, "plot", "table" or "file"; the package replaces this function."""


@singledispatch
def plot(thing: object, *args: object, **options: object) -> Any:
    """Draw a PSF, a pupil or a wavefront on axes of matplotlib, and return the axes."""
    return _registered(plot.dispatch, thing, "plot")(thing, *args, **options)


@singledispatch
def save(thing: object, *args: object, **options: object) -> None:
    """Write a PSF or a wavefront to a file."""
    _registered(save.dispatch, thing, "file")(thing, *args, **options)


@singledispatch
def html(thing: object) -> str:
    """Return the HTML that a notebook shows: a picture beside a table of numbers."""
    text: str = _registered(html.dispatch, thing, "table")(thing)
    return text


def _registered(dispatch: Callable[[type], _Function], thing: object, what: str) -> _Function:
    load(what)
    # Without a registered function, dispatch returns the function for `object`, which has called this function.
    found = dispatch(type(thing))
    if found is dispatch(object):
        raise TypeError(f"there is no {what} of a {type(thing).__name__}")
    return found


_named: dict[str, Callable[..., Any]] = {}


def register(name: str) -> Callable[[_Function], _Function]:
    """Return a decorator that registers a function under a name, for :func:`named`."""

    def decorate(function: _Function) -> _Function:
        _named[name] = function
        return function

    return decorate


def named(name: str, what: str) -> Callable[..., Any]:
    """Return the function registered under a name; before, import the modules of the kind `what` if necessary."""
    if name not in _named:
        load(what)
    return _named[name]


class Shown:
    """Base of objects that notebooks show as a picture beside a table."""

    def _repr_html_(self) -> str:
        return html(self)
