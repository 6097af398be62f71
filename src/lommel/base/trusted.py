"""Frozen objects of parts that were checked before: to check them again costs more than a small answer."""

from __future__ import annotations

from typing import Any, TypeVar

_Thing = TypeVar("_Thing")
# By names of their own, for a small answer takes as long as some hundred look-ups.
_new, _set = object.__new__, object.__setattr__


def made(kind: type[_Thing], parts: dict[str, Any]) -> _Thing:
    """Return an object of this `kind` from all of its `parts`, by name; it takes these, and nobody else may."""
    thing = _new(kind)
    _set(thing, "__dict__", parts)
    return thing


def changed(thing: _Thing, **parts: Any) -> _Thing:
    """Return a copy with some other `parts`. What is cached comes along: nothing of it may depend on these."""
    copy = _new(type(thing))
    _set(copy, "__dict__", thing.__dict__ | parts)
    return copy
