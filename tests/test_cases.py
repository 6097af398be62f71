"""Many cases in one test: all that fail are listed, and no other."""

from __future__ import annotations

import inspect

import pytest

from cases import each


def test_every_case_that_fails_is_listed():
    @each("number, text", [(1, "a"), (2, "b"), (3, "c"), (4, "d")])
    def test(number, text, limit):
        if number == 3:
            with pytest.raises(ValueError, match=text):
                int("3")
        assert number <= limit

    assert list(inspect.signature(test).parameters) == ["limit"]
    with pytest.raises(AssertionError, match="2 cases fail") as caught:
        test(limit=3)
    assert "\n3, 'c': Failed: DID NOT RAISE" in str(caught.value)
    assert "\n4, 'd': AssertionError" in str(caught.value)
