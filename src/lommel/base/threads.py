"""Calls of a function for several items on several threads, and matrix products inside such a function."""

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

Item = TypeVar("Item")
Result = TypeVar("Result")


class _Cancelled(BaseException):
    """Exception that is raised in all other threads after an error in one thread."""


_SINGLE_THREAD_PRODUCTS = 1 << 18  # multiplications of real numbers up to which OpenBLAS uses one thread


def side_by_side(task: Callable[[Item], Result], items: Sequence[Item], threads: int = 0) -> list[Result]:
    """Return the results of `task` for `items`, in order, on at most `threads` threads (0: one per processor)."""
    count = min(threads or os.cpu_count() or 1, len(items))
    if count <= 1:
        return [task(item) for item in items]
    queue = deque(range(len(items)))
    results: dict[int, Result] = {}
    working_threads: set[int] = set()
    lock = threading.Lock()

    def run_tasks() -> None:
        # Threads take items from a common queue, since a future for each item would take longer than a short task.
        with lock:
            working_threads.add(threading.get_ident())
        try:
            while True:
                try:
                    number = queue.popleft()
                except IndexError:
                    return
                results[number] = task(items[number])
        finally:
            queue.clear()  # after an error, no thread begins another item
            with lock:
                working_threads.discard(threading.get_ident())

    with ThreadPoolExecutor(count - 1) as pool:
        futures = [pool.submit(run_tasks) for _ in range(count - 1)]
        try:
            run_tasks()
            for future in futures:
                future.result()
        except BaseException:
            # Ctrl-C interrupts this thread only, while the other threads may run long tasks.
            with lock:
                for thread in working_threads:
                    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), ctypes.py_object(_Cancelled))
            raise
    return [results[number] for number in range(len(items))]


def product(a: Values, b: Values) -> Values:
    """Return ``a @ b`` of matrices, or of stacks of them, in blocks for which OpenBLAS uses only the calling thread.

    Threads of OpenBLAS wait for one another in busy loops. In tasks of :func:`side_by_side`, on a computer that runs
    other programs, they would wait twenty times as long as they compute.
    """
    stacked = np.broadcast_shapes(a.shape[:-2], b.shape[:-2])
    result = np.empty((*stacked, a.shape[-2], b.shape[-1]), np.result_type(a, b))
    limit = _SINGLE_THREAD_PRODUCTS // (4 if np.iscomplexobj(result) else 1)
    # A block of one row or column would be a product with a vector, which uses all threads: blocks are about equal.
    for columns in _blocks(b.shape[-1], max(2, math.isqrt(limit // a.shape[-1]))):
        width = columns.stop - columns.start
        for rows in _blocks(a.shape[-2], max(2, limit // (a.shape[-1] * width))):
            np.matmul(a[..., rows, :], b[..., columns], out=result[..., rows, columns])
    return result


def _blocks(count: int, largest: int) -> list[slice]:
    """Return slices of about equal length, at most `largest`, that cover `count` items."""
    n = -(-count // largest)
    return [slice(count * i // n, count * (i + 1) // n) for i in range(n)]
