"""What rooms above make of the things of rooms below: pictures, tables in notebooks, files.

No room imports from one above it, and a wavefront cannot know who draws it. The package as a whole, which stands
above all, says here as text where that is; it is imported when it is asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any

_PLACES: dict[str, str] = {}


def offer(places: Mapping[str, str]) -> None:
    """Say where views are, by class and name: ``{"Wavefront.plot": "lommel.show.pupils:wavefront"}``."""
    _PLACES.update(places)


def view(kind: type, name: str) -> Callable[..., Any]:
    """Return the function that is offered for a class, or for the first that it inherits from.

    Parameters
    ----------
    kind : type
    name : str
        Of the view, such as "plot".

    Returns
    -------
    callable

    Raises
    ------
    TypeError
        If there is none.
    """
    for each in kind.__mro__:
        if place := _PLACES.get(f"{each.__name__}.{name}"):
            module, _, function = place.partition(":")
            found: Callable[..., Any] = getattr(import_module(module), function)
            return found
    raise TypeError(f"there is no {name} of a {kind.__name__}")


class Shown:
    """What notebooks show as a table, with a picture."""

    def _repr_html_(self) -> str:
        text: str = view(type(self), "_repr_html_")(self)
        return text
