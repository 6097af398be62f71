"""Names and arguments that are on their way out: a warning, a note in the docstring, and a debt that falls due."""

from __future__ import annotations

import functools
import inspect
import warnings
from collections.abc import Callable
from typing import Any, ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")

DEBTS: list[tuple[str, str]] = []
"""What is deprecated, and the version that no longer has it; a test fails once that version is reached."""


def reordered(*, since: str, until: str, was: Callable[[Any], bool]) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Mark the first two arguments of a function as having changed places: the old order is taken and warned of.

    Parameters
    ----------
    since, until : str
        The version that has the new order first, and the one that no longer takes the old one.
    was : callable
        Tells of a value given first that it is what now comes second.

    Returns
    -------
    callable
        What decorates the function.
    """

    def decorate(function: Callable[P, R]) -> Callable[P, R]:
        places = [name for name in inspect.signature(function).parameters if name != "self"]
        own = 1 if "self" in inspect.signature(function).parameters else 0
        first, second = places[:2]
        name = f"{function.__module__}.{function.__qualname__}".removesuffix(".__init__")
        what, order = f"{name}({second}, {first}, ...)", ", ".join(places[:3])
        message = f"{what} is deprecated since lommel {since} and goes in {until}; the order is {order}"
        DEBTS.append((what, until))

        @functools.wraps(function)
        def turned(*args: P.args, **kwargs: P.kwargs) -> R:
            given: list[Any] = list(args)
            if len(given) > own and was(given[own]):
                warnings.warn(message, DeprecationWarning, stacklevel=2)
                if len(given) > own + 1:
                    given[own : own + 2] = given[own + 1], given[own]
                else:
                    kwargs[second] = given.pop()
            return function(*given, **kwargs)

        return turned

    return decorate


def deprecate(
    *, since: str, until: str, use: str, argument: str | None = None, renamed: str | None = None
) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Mark a function, or one of its arguments, as on its way out.

    Parameters
    ----------
    since, until : str
        The version that warns first, and the one that no longer has it.
    use : str
        What to use instead, as the end of a sentence: "lommel.psf(..., tol=)".
    argument : str, optional
        The argument that goes; by default the function itself does. Its values are warned of however they are given.
    renamed : str, optional
        The argument that takes its values from now on; the old name, no longer among the parameters, is then still
        taken by keyword.

    Returns
    -------
    callable
        What decorates the function: calls that concern it raise a DeprecationWarning at the caller's line, and its
        docstring says so. TypeError where both names of a renamed argument are given.

    Raises
    ------
    ValueError
        If the function has no such arguments.
    """

    def decorate(function: Callable[P, R]) -> Callable[P, R]:
        places = list(inspect.signature(function).parameters)
        kept = renamed or argument
        if kept is not None and kept not in places:
            raise ValueError(f"{function.__qualname__} has no argument {kept}")
        name = f"{function.__module__}.{function.__qualname__}".removesuffix(".__init__")
        what = f"{argument}= of {name}" if argument else name
        message = f"{what} is deprecated since lommel {since} and goes in {until}; use {use}"
        DEBTS.append((what, until))

        @functools.wraps(function)
        def deprecated(*args: P.args, **kwargs: P.kwargs) -> R:
            given: dict[str, Any] = kwargs
            names = {*places[: len(args)], *given}
            if argument is None or argument in names:
                warnings.warn(message, DeprecationWarning, stacklevel=2)
            if renamed is not None and argument in given:
                if renamed in names:
                    raise TypeError(f"{name} got {renamed}= and, under its old name, {argument}=")
                given[renamed] = given.pop(argument)
            return function(*args, **kwargs)

        told = inspect.cleandoc(function.__doc__ or "")
        deprecated.__doc__ = f"{told}\n\n.. deprecated:: {since}\n    {message}.\n"
        return deprecated

    return decorate
