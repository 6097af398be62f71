"""Options shared by several functions, listed once with their defaults and documentation."""

from __future__ import annotations

import difflib
import inspect
import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar

from lommel.base.validation import shown

_Door = TypeVar("_Door", bound=Callable[..., object])


def shares(keywords: type, source: Callable[..., object], **defaults: object) -> Callable[[_Door], _Door]:
    """Return a decorator that lists the options of `keywords` in a signature and its docstring (``{options}``).

    `source` is a dataclass or function that has them; a subclass may restate the default and text of an option.
    """

    def show(door: _Door) -> _Door:
        made: Any = door.__init__ if isinstance(door, type) else door  # type: ignore[misc]
        found = inspect.signature(made)
        own = [p for p in found.parameters.values() if p.kind is not p.VAR_KEYWORD]
        shared = [
            p.replace(kind=p.KEYWORD_ONLY, default=defaults.get(p.name, p.default))
            for p in inspect.signature(source).parameters.values()
            if p.name in keywords.__annotations__
        ]
        made.__signature__ = found.replace(parameters=[*own, *shared])
        if door.__doc__:  # there is none with python -OO
            names = {p.name for p in shared}
            text = "\n".join(
                f"{head} : {said}" for head, said in _texts(source).items() if names & {*head.split(", ")}
            )
            door.__doc__ = inspect.cleandoc(door.__doc__).replace("{options}", text)
        return door

    return show


def sentence(source: Callable[..., object], name: str) -> str:
    """Return the description of one option from a docstring, in one line and without its type."""
    found = (said for head, said in _texts(source).items() if name in head.split(", "))
    return " ".join(next(found, "").partition("\n")[2].split())


def _texts(source: Callable[..., object]) -> dict[str, str]:
    """Return the entries of the section Parameters by their names, of base classes first: text from the type on."""
    found: dict[str, str] = {}
    for kind in reversed(getattr(source, "__mro__", (source,))):
        section = inspect.cleandoc(kind.__doc__ or "").partition("Parameters\n----------\n")[2]
        section = re.split(r"\n\n(?=\w+\n-+\n)", section)[0]
        found |= re.findall(r"^([\w, ]+) : (.*(?:\n(?!\w).*)*)", section.rstrip(), re.MULTILINE)
    return found


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
