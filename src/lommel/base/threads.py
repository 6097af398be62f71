"""A function applied to several items on several threads."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

Given = TypeVar("Given")
Made = TypeVar("Made")


def side_by_side(task: Callable[[Given], Made], each: Sequence[Given], threads: int = 0) -> list[Made]:
    """Return what a `task` makes of each, in order, on at most so many `threads`, 0 for as many as processors."""
    most = min(threads or os.cpu_count() or 1, len(each))
    if most <= 1:
        return [task(one) for one in each]
    with ThreadPoolExecutor(most) as pool:
        return list(pool.map(task, each))
