"""Frozen objects of parts that were checked before: to check them again costs more than a small answer."""

from __future__ import annotations

from typing import Any, TypeVar

_Thing = TypeVar("_Thing")


def made(kind: type[_Thing], **parts: Any) -> _Thing:
    """Return an object of this `kind` from all of its `parts`, by name."""
    thing = object.__new__(kind)
    vars(thing).update(parts)
    return thing


def changed(thing: _Thing, **parts: Any) -> _Thing:
    """Return a copy with some other `parts`. What is cached comes along: nothing of it may depend on these."""
    copy = object.__new__(type(thing))
    vars(copy).update(vars(thing), **parts)
    return copy
