"""Effects that images favour, which refits estimate besides what was asked for."""

from __future__ import annotations

from types import SimpleNamespace as Made

import numpy as np
import pytest

from lommel.core.answers import Declined
from lommel.estimation.favoured_effects import Estimate, estimated_findings, rounds_of
from lommel.fit.score_tests import ScoreTest

CALM = Made(stands_out=lambda _: True)


def score(name, log_bayes, sigmas=9.0):
    return ScoreTest(name, np.ones(1), np.full(1, 0.1), sigmas, log_bayes)


def chain(rounds, gains, fit=CALM, **more):
    """Return the rounds of fits with these score tests, and refits of these gains; None has no parameter."""
    left = iter(rounds)

    def refit(fit, test):
        gain = gains[test.name]
        if gain == "declined":
            raise Declined("too strong")
        return gain if gain is None else (fit, gain)

    return rounds_of(fit, lambda *_: (next(left), None, []), refit, **more)


@pytest.mark.parametrize(
    ("gains", "names", "rivals"),
    [
        ({"a": 12.0, "b": 11.0}, ("a",), ("b",)),
        ({"a": 12.0, "b": 12.4}, ("a",), ("b",)),
        ({"a": 12.0, "b": 12.6}, ("b",), ("a",)),
        ({"a": 4.9, "b": 5.1}, ("b",), ("a",)),  # half of the log Bayes factor must be gained
        ({"a": "declined", "b": 8.0}, ("b",), ("a",)),
        ({"a": None, "b": 12.0}, (), ()),
        ({"a": 8.0, "b": None}, ("a",), ("b",)),
        ({"a": 4.9, "b": 4.9}, (), ()),
    ],
)
def test_the_rival_that_gains_most_is_estimated_and_the_others_are_named(gains, names, rivals):
    last = chain([[score("a", 10.0), score("b", 9.9)], []], gains)[-1]
    assert (last.names, last.rivals) == (names, rivals)


def test_a_model_error_that_explains_as_much_leaves_weak_effects_alone():
    tests, gains, doubtful = [[score("a", 49.0)], []], {"a": 60.0}, Made(stands_out=lambda _: False)
    assert chain(tests, gains, doubtful)[-1].names == ()
    assert chain([[score("a", 51.0)], []], gains, doubtful)[-1].names == ("a",)


def test_at_most_two_effects_are_added_and_moved_ones_settle_before_the_next():
    tests = [[score("a", 20.0)], [score("b", 15.0), score("a", -1.0, 0.4)], [score("b", 15.0), score("a", -1.0, 0.2)]]
    tests += [[score("c", 12.0)]]
    rounds = chain(tests, {"a": 18.0, "b": 14.0, "c": 11.0})
    assert [one.names for one in rounds] == [(), ("a",), ("a",), ("a", "b")]
    assert rounds[2].rivals == ("b",)
    assert rounds[3].rivals == ()


def test_rivals_are_estimated_together_where_the_model_can():
    asked = []
    tests = [[score("a", 10.0), score("b", 9.0), score("c", 8.0)], []]
    rounds = chain(tests, {"a": 6.0, "b": 10.9, "c": 5.0}, jointly=lambda fit, names: asked.append(names) or fit)
    assert (asked, rounds[-1].names) == ([("b", "a")], ("b", "a"))
    assert [test.name for test, *_ in rounds[0].tried] == ["b", "a"]


def test_estimates_that_differ_from_nothing_by_less_than_their_error_are_left_out():
    wobble, drift = Estimate("wobble", 0.02, 0.05, 1.0), Estimate("drift", 0.02, 0.05, 0.0)
    (told,) = estimated_findings([wobble, drift], 1.0)
    assert [*told.numbers] == ["wobble", "move"]  # 0 is not what was stated
    assert estimated_findings([drift], 1.0) == []
