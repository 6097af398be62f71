"""Caches that persist between calls, and how to clear them."""

from __future__ import annotations

import functools
import sys

from lommel.core import engine

_Kept = type(functools.lru_cache(maxsize=1)(len))


def clear_caches() -> None:
    """Free the memory kept between calls: tables of the compiled core, plans of :func:`lommel.psf` and others.

    The next call recomputes what it needs: it takes as long as the first call of a process, with identical results.
    Calls that are running in other threads keep what they use until they return. Plans, PSFs and operators that you
    hold stay valid. For the limits of the caches see :doc:`the guide </running>`.

    Examples
    --------
    >>> import lommel as lm
    >>> image = lm.psf(lm.Pupil(), 64, 0.25)
    >>> lm.clear_caches()
    """
    for name, module in tuple(sys.modules.items()):
        if name.startswith("lommel."):
            # Those without a limit hold what is made once a process: classes, what is registered elsewhere.
            for value in tuple(vars(module).values()):
                if isinstance(value, _Kept) and value.cache_parameters()["maxsize"] is not None:
                    value.cache_clear()
    engine.clear_tables()
