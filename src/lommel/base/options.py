"""Options shared by several functions, listed once with their defaults and documentation."""

from __future__ import annotations

import difflib
import inspect
import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar

from lommel.base.validation import shown

_Door = TypeVar("_Door", bound=Callable[..., object])


def shares(keywords: type, source: type, **defaults: object) -> Callable[[_Door], _Door]:
    """Return a decorator that lists the options of `keywords` in a signature and its docstring (``{options}``)."""

    def show(door: _Door) -> _Door:
        made: Any = door.__init__ if isinstance(door, type) else door  # type: ignore[misc]
        found = inspect.signature(made)
        own = [p for p in found.parameters.values() if p.kind is not p.VAR_KEYWORD]
        names = [name for name in source.__annotations__ if name in keywords.__annotations__]
        shared = [
            inspect.Parameter(
                name,
                inspect.Parameter.KEYWORD_ONLY,
                default=defaults.get(name, getattr(source, name)),
                annotation=source.__annotations__[name],
            )
            for name in names
        ]
        made.__signature__ = found.replace(parameters=[*own, *shared])
        # There is no docstring with python -OO.
        if door.__doc__:  # there is none with python -OO
            text = "\n".join(f"{head} : {said}" for head, said in _texts(source) if {*head.split(", ")} & {*names})
            door.__doc__ = inspect.cleandoc(door.__doc__).replace("{options}", text)
        return door

    return show


def sentence(source: type, name: str) -> str:
    """Return the description of one option from a class's docstring, in one line and without its type."""
    found = (said for head, said in _texts(source) if name in head.split(", "))
    return " ".join(next(found, "").partition("\n")[2].split())


def _texts(source: type) -> list[tuple[str, str]]:
    """Return the entries of the section Parameters of a docstring: names, and their text from the type on."""
    section = (inspect.getdoc(source) or "").partition("Parameters\n----------\n")[2]
    section = re.split(r"\n\n(?=\w+\n-+\n)", section)[0]
    return re.findall(r"^([\w, ]+) : (.*(?:\n(?!\w).*)*)", section.rstrip(), re.MULTILINE)


def require_known(door: Callable[..., object], given: Mapping[str, object], keywords: type) -> None:
    """Raise TypeError for an option that is not one of these keywords, naming all that `door` takes."""
    if stray := [name for name in given if name not in keywords.__annotations__]:
        known = [p.name for p in inspect.signature(door).parameters.values() if p.kind is p.KEYWORD_ONLY]
        raise TypeError(f"{door.__qualname__}() has no option {shown(stray[0])}; {near(stray[0], known)}")


def near(name: str, known: Iterable[str]) -> str:
    """Return a suggestion for a misspelt name, or the list of all valid ones."""
    each = {one.lower(): one for one in known}
    # Cut to 60 letters: difflib takes time in proportion to the square of the length.
    found = difflib.get_close_matches(name[:60].lower(), each, n=1)
    return f"did you mean {each[found[0]]}?" if found else f"known are {', '.join(each.values())}"
