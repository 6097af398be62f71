"""Functions of the compiled core that only tests call, in a module of their own that users do not compile."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import mpmath as mp

try:
    from lommel import _core_tests
except ImportError as missing:
    message = (
        "lommel._core_tests is not built: run `make test` once or, without make, "
        "`pip install --config-settings=cmake.define.LOMMEL_TESTS=ON --editable .`"
    )
    raise ImportError(message) from missing

__all__ = ["SPACING", "UNIT", "WIDER", "_core_tests", "instructions"]

UNIT = mp.mpf(2) ** -53
# At 1, of the numbers that tables are made with; where these are doubles, that is counted.
SPACING = mp.mpf(_core_tests.window_bounds(1, 1.0)["spacing"])
WIDER = SPACING < 2 * UNIT


@contextmanager
def instructions(level: str) -> Iterator[None]:
    """Limit the instructions; above those of the processor the limit does nothing."""
    _core_tests.limit_instructions(level)
    try:
        yield
    finally:
        _core_tests.limit_instructions("avx512")
