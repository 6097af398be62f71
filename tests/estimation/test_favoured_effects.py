"""Effects that images favour, which refits estimate besides what was asked for."""

from __future__ import annotations

from types import SimpleNamespace as Made

import numpy as np
import pytest

from lommel.core.answers import Declined
from lommel.estimation.favoured_effects import Estimate, estimated_findings, opened, rounds_of, unsure
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
    (told,) = estimated_findings([wobble, drift], {})
    assert [*told.numbers] == ["wobble", "move"]  # 0 is not what was stated
    assert estimated_findings([drift], {}) == []


def revision(loss):
    """Return a revision of fits, of deviance 0, that lose this lnL by the name of their effect."""
    return lambda fit, test, compared: Made(deviance=loss[test.name] if compared else 0.0)


@pytest.mark.parametrize(("loss", "name", "others"), [(1.0, "b", ["a"]), (9.0, "b", []), (-8.0, "a", [])])
def test_refits_are_compared_after_what_stood_for_their_effects_is_chosen_anew(loss, name, others):
    gains, fit = {"a": 50.0, "b": 51.0}, Made(stands_out=lambda _: True, deviance=0.0)
    tests = [[score("a", 60.0), score("b", 59.0)], []]
    last = chain(tests, gains, fit, revised=revision({"a": loss, "b": 0.0}))[-1]
    assert (last.names, [test.name for test, *_ in last.others]) == ((name,), others)
    assert (unsure([Made(names=(), rivals=()), last]), last.rivals) == ({name} if others else set(), (*others,))


def test_a_change_beyond_an_error_widens_it():
    assert opened(np.array([0.5, -3.0]), np.ones(2)).tolist() == [0.0, 9.0]


def test_an_error_contains_the_stated_value_where_another_effect_explains_the_images_as_well():
    ratio, scale = (
        Estimate("f_number", 7.9, 0.004, 8.0, unsure=True),
        Estimate("scale", 0.98, 0.001, 1.0, unsure=True),
    )
    moves = {"coma": 3.0, "spherical": 7.8}
    (told,) = estimated_findings([ratio], moves, ["scale", "drift"], [scale], {"coma": 0.4})
    assert abs(told.numbers["f_number"]["error"] - np.hypot(0.1, 0.004)) < 1e-9
    assert abs(told.numbers["scale"]["error"] - np.hypot(0.02, 0.001)) < 1e-9
    assert told.severity == "note"
    assert "or instead scale 0.9800 +- 0.0010 (stated 1) or drift, each if the others are as stated" in told.text
    assert "moves spherical by 7.8 standard errors" in told.text
    (told,) = estimated_findings([ratio], moves, ["scale"], [scale], {"coma": 0.1, "tilt": 1.4})
    assert told.severity == "note"
    assert "but tilt differs by 1.4 standard errors, which its error includes" in told.text
    (doubtful,) = estimated_findings([ratio], moves, ["scale"], [scale], {"coma": 0.1, "tilt": 2.4})
    assert doubtful.severity == "doubt"
    assert "but tilt differs by 2.4 standard errors" in doubtful.text
