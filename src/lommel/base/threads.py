"""A function applied to several items on several threads."""

from __future__ import annotations

import os
from collections import deque
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
    left = deque(range(len(each)))
    made: dict[int, Made] = {}

    def some() -> None:
        # A future for each would cost more than a short task.
        while left:
            try:
                number = left.popleft()
            except IndexError:  # another thread was faster
                return
            made[number] = task(each[number])

    with ThreadPoolExecutor(most - 1) as pool:
        try:
            others = [pool.submit(some) for _ in range(most - 1)]
            some()
            for other in others:
                other.result()
        finally:
            left.clear()
    return [made[number] for number in range(len(each))]
