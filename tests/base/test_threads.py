"""Functions applied on several threads."""

from __future__ import annotations

import threading
import time

import numpy as np
import pytest

from lommel.base.arrays import Values
from lommel.base.threads import product, side_by_side


@pytest.mark.parametrize("threads", [0, 1, 2, 7])
def test_answers_stand_in_the_order_of_what_was_given(threads: int) -> None:
    assert side_by_side(lambda one: one * one, range(300), threads) == [k * k for k in range(300)]
    assert side_by_side(str, [], threads) == []


def test_several_threads_share_the_tasks() -> None:
    assert side_by_side(lambda _: threading.get_ident(), range(2), 1) == 2 * [threading.get_ident()]
    both = threading.Barrier(2, timeout=20.0)
    names = side_by_side(lambda _: (both.wait(), threading.get_ident())[1], range(2), 2)
    assert len(set(names)) == 2


@pytest.mark.parametrize("error", [ValueError, IndexError, KeyboardInterrupt])
@pytest.mark.parametrize("threads", [1, 3])
def test_an_error_of_a_task_ends_the_others_soon(error: type[BaseException], threads: int) -> None:
    done: list[int] = []

    def task(one: int) -> None:
        if one == 5:
            raise error("five")
        time.sleep(1e-3)
        done.append(one)

    with pytest.raises(error, match="five"):
        side_by_side(task, range(2000), threads)
    assert len(done) < 1000


def test_an_error_does_not_wait_for_the_end_of_another_task() -> None:
    both = threading.Barrier(2, timeout=20.0)
    caller, ended = threading.get_ident(), []

    def task(_: int) -> None:
        both.wait()
        if threading.get_ident() == caller:
            raise KeyboardInterrupt("here")
        for _ in range(2000):
            time.sleep(0.01)
        ended.append("at the end")

    with pytest.raises(KeyboardInterrupt, match="here"):
        side_by_side(task, range(2), 2)
    assert not ended
    assert side_by_side(str, range(5), 2) == list("01234")


@pytest.mark.parametrize(("rows", "inner", "columns"), [(3, 5, 7), (700, 300, 41), (2, 300_000, 3), (1, 1, 1)])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_a_product_of_matrices_is_that_of_numpy(rows: int, inner: int, columns: int, dtype: type) -> None:
    rng = np.random.default_rng(rows)
    a: Values = rng.standard_normal((inner, rows)).astype(dtype).T
    b: Values = rng.standard_normal((inner, columns)).astype(dtype)
    made = product(a, b)
    assert made.dtype == dtype
    # Partial sums of n products are about sqrt(n), each rounded at random: the last is off by eps n / sqrt(8) where a
    # BLAS for old processors adds one after another.
    exact = a.astype(np.float64) @ b.astype(np.float64)
    np.testing.assert_allclose(made, exact, rtol=0.0, atol=2 * np.finfo(dtype).eps * (inner + 20))
