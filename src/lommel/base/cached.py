"""Properties that are computed once, without the lock that `functools` holds meanwhile in Python 3.11."""

from __future__ import annotations

import functools
import sys
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING or sys.version_info >= (3, 12):
    cached_property = functools.cached_property
else:

    class cached_property(functools.cached_property):  # noqa: N801 (as that one is called)
        """A child that is forked while another thread computes one would wait for its lock forever."""

        def __get__(self, instance: Any, owner: Any = None) -> Any:
            """Return the value, computed if it is not there; two threads at once may both compute it."""
            if instance is None:
                return self
            value = instance.__dict__[self.attrname] = self.func(instance)
            return value


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
