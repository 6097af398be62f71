"""Properties that are computed once, without the lock that `functools` holds meanwhile in Python 3.11."""

from __future__ import annotations

import functools
import sys
from typing import TYPE_CHECKING, Any

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
