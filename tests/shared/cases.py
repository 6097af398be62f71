"""Many cases of one test under one name, which lists all that fail."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import pytest


def check_each(check: Callable[..., object], cases: Iterable[Sequence[Any]]) -> None:
    """Call a check with each case, and fail with the cases for which it failed."""
    faults, last = [], None
    for case in cases:
        try:
            check(*case)
        except (Exception, pytest.fail.Exception) as error:
            faults.append(f"{', '.join(repr(part)[:80] for part in case)}: {type(error).__name__}: {error}")
            last = error
    if last is not None:
        raise AssertionError(f"{len(faults)} cases fail:\n" + "\n".join(faults)) from last


def each(names: str | Sequence[str], cases: Iterable[Any]) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Do what `pytest.mark.parametrize` does, in one test: values of one name, or tuples of several."""
    names = [name.strip() for name in names.split(",")] if isinstance(names, str) else list(names)
    cases = [(case,) for case in cases] if len(names) == 1 else list(cases)

    def in_one(test: Callable[..., None]) -> Callable[..., None]:
        @functools.wraps(test)
        def all_of_them(**fixtures: Any) -> None:
            check_each(lambda *case: test(**dict(zip(names, case, strict=True)), **fixtures), cases)

        signature = inspect.signature(test)
        others = [parameter for name, parameter in signature.parameters.items() if name not in names]
        all_of_them.__signature__ = signature.replace(parameters=others)  # type: ignore[attr-defined]
        return all_of_them

    return in_one
