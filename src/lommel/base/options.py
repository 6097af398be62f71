"""Options shared by several functions, listed once with their defaults and documentation."""

from __future__ import annotations

import difflib
import inspect
import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar

from lommel.base.validation import shown

_Callable = TypeVar("_Callable", bound=Callable[..., object])


def shares(keywords: type, source: Callable[..., object], **defaults: object) -> Callable[[_Callable], _Callable]:
    """Return a decorator that lists the options of `keywords` in a signature and its docstring (``{options}``).

    `source` is a dataclass or function with these options; a subclass may change defaults and descriptions.
    """

    def show(function: _Callable) -> _Callable:
        call: Any = function.__init__ if isinstance(function, type) else function  # type: ignore[misc]
        signature = inspect.signature(call)
        positional = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
        shared = [
            p.replace(kind=p.KEYWORD_ONLY, default=defaults.get(p.name, p.default))
            for p in inspect.signature(source).parameters.values()
            if p.name in keywords.__annotations__
        ]
        call.__signature__ = signature.replace(parameters=[*positional, *shared])
        if function.__doc__:  # there is none with python -OO
            names = {p.name for p in shared}
            text = "\n".join(
                f"{head} : {body}" for head, body in _texts(source).items() if names & {*head.split(", ")}
            )
            function.__doc__ = inspect.cleandoc(function.__doc__).replace("{options}", text)
        return function

    return show


def sentence(source: Callable[..., object], name: str) -> str:
    """Return the description of an option from the docstring of `source`, in one line and without its type."""
    texts = (body for head, body in _texts(source).items() if name in head.split(", "))
    return " ".join(next(texts, "").partition("\n")[2].split())


def _texts(source: Callable[..., object]) -> dict[str, str]:
    """Return the text (type and description) of each entry of the section Parameters; base classes come first."""
    texts: dict[str, str] = {}
    for kind in reversed(getattr(source, "__mro__", (source,))):
        section = inspect.cleandoc(kind.__doc__ or "").partition("Parameters\n----------\n")[2]
        section = re.split(r"\n\n(?=\w+\n-+\n)", section)[0]
        texts |= re.findall(r"^([\w, ]+) : (.*(?:\n(?!\w).*)*)", section.rstrip(), re.MULTILINE)
    return texts


def require_known(function: Callable[..., object], given: Mapping[str, object], keywords: type) -> None:
    """Raise TypeError for an option that `keywords` lacks; the message lists the options of `function`."""
    if unknown := [name for name in given if name not in keywords.__annotations__]:
        names = [p.name for p in inspect.signature(function).parameters.values() if p.kind is p.KEYWORD_ONLY]
        raise TypeError(f"{function.__qualname__}() has no option {shown(unknown[0])}; {near(unknown[0], names)}")


def near(name: str, known: Iterable[str]) -> str:
    """Return a suggestion for a misspelt name, or the list of all valid names."""
    names = {candidate.lower(): candidate for candidate in known}
    # The name is cut to 60 characters, since the time of difflib grows with the square of the length.
    matches = difflib.get_close_matches(name[:60].lower(), names, n=1)
    return f"did you mean {names[matches[0]]}?" if matches else f"known are {', '.join(names.values())}"
