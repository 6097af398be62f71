"""Functions of the compiled core that only tests call, in a module of their own that users do not compile."""

from __future__ import annotations

try:
    from lommel import _core_tests
except ImportError as missing:
    message = (
        "lommel._core_tests is not built: run `make test` once or, without make, "
        "`pip install --config-settings=cmake.define.LOMMEL_TESTS=ON --editable .`"
    )
    raise ImportError(message) from missing

__all__ = ["_core_tests"]
