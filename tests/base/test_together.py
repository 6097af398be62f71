import threading

import pytest

from lommel.base.threads import side_by_side


@pytest.mark.parametrize("threads", [0, 1, 2, 8])
def test_answers_are_in_the_order_of_what_was_given(threads):
    assert side_by_side(lambda x: x * x, range(9), threads) == [x * x for x in range(9)]


def test_nothing_makes_nothing():
    assert side_by_side(len, [], 3) == []


def test_one_thread_is_that_of_the_caller_and_two_work_at_once():
    me = threading.get_ident()
    assert side_by_side(lambda _: threading.get_ident(), [0, 1], 1) == [me, me]
    together = threading.Barrier(2, timeout=10.0)
    side_by_side(lambda _: together.wait(), [0, 1], 2)  # raises where one waits for the other to end


def test_what_a_task_raises_is_raised():
    with pytest.raises(ZeroDivisionError):
        side_by_side(lambda x: 1 / x, [1, 0, 2], 2)
