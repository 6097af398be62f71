"""Caches that persist between calls, and how to clear them."""

from __future__ import annotations

import functools
import sys

from lommel.core import engine

_Kept = type(functools.lru_cache(maxsize=1)(len))


def clear_caches() -> None:
    """Free the memory that is kept between calls: tables of the compiled core, plans of :func:`lommel.psf`, the rest.

    The next call makes anew what it needs: it takes as long, and returns the same bits, as the first of a process.
    Calls that run meanwhile in other threads keep what they use until they return, and may leave it behind. Plans,
    PSFs and operators that you hold stay. How much is kept at most: :doc:`the guide </running>`.

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
