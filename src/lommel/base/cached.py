"""Cached properties without the lock of Python 3.11, copies that keep cached values, and equality by content."""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Generic, TypeVar

if TYPE_CHECKING or sys.version_info >= (3, 12):
    cached_property = functools.cached_property
else:

    class cached_property(functools.cached_property):  # noqa: N801 (the name in functools)
        """Property computed at the first access, without a lock: two threads may both compute it."""

        def __get__(self, instance: Any, owner: type | None = None) -> Any:
            """Return the value, computed at the first access."""
            if instance is None:
                return self
            value = instance.__dict__[self.attrname] = self.func(instance)
            return value


_Object = TypeVar("_Object")
# Speed matters: `Lens.pupil` takes only as long as 100 attribute look-ups, and `dict.update` would add a sixth.
_new, _set = object.__new__, object.__setattr__


def made(kind: type[_Object], parts: dict[str, object]) -> _Object:
    """Return an object of the class `kind` whose ``__dict__`` is `parts`, which the caller must have checked."""
    # Skip __init__ and the checks of frozen dataclasses, which take longer than the rest of a small computation.
    result = _new(kind)
    _set(result, "__dict__", parts)
    return result


def changed(original: _Object, **parts: object) -> _Object:
    """Return a copy with `parts` as changed attributes; unlike `replace`, check nothing and keep cached values."""
    copy = _new(type(original))
    _set(copy, "__dict__", original.__dict__ | parts)
    return copy


class Kept(Generic[_Object]):
    """A function whose latest `size` results are kept; copies and pickles compute them again."""

    def __init__(self, function: Callable[..., _Object], size: int) -> None:
        self._given = function, size
        self._call = functools.lru_cache(size)(function)

    def __call__(self, *given: Any) -> _Object:
        """Return the result for arguments."""
        return self._call(*given)

    def __reduce__(self) -> tuple[object, ...]:
        return Kept, self._given


class EqualByContent:
    """Base of objects that are equal if their class and content are equal."""

    def _content(self) -> object:
        """Return a hashable value that is equal for equal objects only."""
        raise NotImplementedError

    def __eq__(self, other: object) -> bool:
        return self._content() == other._content() if isinstance(other, type(self)) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._content())
