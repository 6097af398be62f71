"""A function applied to several items on several threads, and products of matrices in it."""

from __future__ import annotations

import ctypes
import math
import os
import threading
from collections import deque
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

import numpy as np

from lommel.base.arrays import Values

Given = TypeVar("Given")
Made = TypeVar("Made")


class _Left(BaseException):
    """Ends the tasks of other threads after an error in one."""


_ALONE = 1 << 18  # multiplications of a product up to which OpenBLAS uses one thread


def side_by_side(task: Callable[[Given], Made], each: Sequence[Given], threads: int = 0) -> list[Made]:
    """Return the results of `task` for `each` item, in order, on at most `threads` threads (0: one per processor)."""
    most = min(threads or os.cpu_count() or 1, len(each))
    if most <= 1:
        return [task(one) for one in each]
    left = deque(range(len(each)))
    made: dict[int, Made] = {}
    at_work: set[int] = set()
    lock = threading.Lock()

    def some() -> None:
        # Threads take items from one queue: a future for each would cost more than a short task.
        with lock:
            at_work.add(threading.get_ident())
        try:
            while True:
                try:
                    number = left.popleft()
                except IndexError:
                    return
                made[number] = task(each[number])
        finally:
            left.clear()  # after an error
            with lock:
                at_work.discard(threading.get_ident())

    with ThreadPoolExecutor(most - 1) as pool:
        others = [pool.submit(some) for _ in range(most - 1)]
        try:
            some()
            for other in others:
                other.result()
        except BaseException:
            # Ctrl-C reaches this thread only; the others may be in the middle of a long task.
            with lock:
                for thread in at_work:
                    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), ctypes.py_object(_Left))
            raise
    return [made[number] for number in range(len(each))]


def product(a: Values, b: Values) -> Values:
    """Return ``a @ b``, in blocks small enough that OpenBLAS computes each on the calling thread.

    In tasks of :func:`side_by_side` its own threads would wait actively for one another: on a processor with other
    work, twenty times as long as they compute.
    """
    made = np.empty((a.shape[0], b.shape[1]), np.result_type(a, b))
    columns = max(1, math.isqrt(_ALONE // a.shape[1]))
    for first in range(0, b.shape[1], columns):
        part = b[:, first : first + columns]
        rows = max(1, _ALONE // part.size)
        for top in range(0, a.shape[0], rows):
            np.matmul(a[top : top + rows], part, out=made[top : top + rows, first : first + columns])
    return made
