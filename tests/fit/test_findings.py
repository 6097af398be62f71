"""Findings make the verdict: flags follow from severities, and everything is plain data."""

import json
import textwrap
from dataclasses import dataclass

import numpy as np
import pytest

from lommel.base.arrays import plain
from lommel.fit import Finding, Findings, FitReport
from lommel.fit.findings import untested_finding

NOTE = Finding("rare_chi2", "note", "noise alone exceeds this chi2 in 0.1 % of fits")
DOUBT = Finding("too_quiet", "doubt", "the images are less noisy than stated", {"chi2": np.float64(0.5)})
ERROR = Finding("misfit", "error", "noise alone keeps chi2 below 1.2", {"chi2": 3.1, "limit": 1.2})


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Fit(FitReport):
    coefficients: dict[object, float]


@pytest.mark.parametrize(
    ("findings", "converged", "reliable", "status"),
    [
        ((), True, True, "converged"),
        ((NOTE,), True, True, "converged"),
        ((NOTE, DOUBT), True, False, "doubtful"),
        ((NOTE, DOUBT, ERROR), False, False, "misfit"),
        ((ERROR,), False, False, "misfit"),
    ],
)
def test_the_verdict_follows_from_the_gravest_finding(findings, converged, reliable, status):
    made = Fit(findings=Findings(findings), summary="chi2 1.02", coefficients={})
    assert (made.converged, made.reliable, made.status) == (converged, reliable, status)
    assert (made.findings.converged, made.findings.reliable) == (converged, reliable)


def test_findings_are_sorted_by_severity_and_found_by_code():
    found = Findings([NOTE, DOUBT, ERROR])
    assert found.codes == ("misfit", "too_quiet", "rare_chi2")
    assert found.get("too_quiet") is DOUBT
    assert found.get("flat_top") is None


def message(*findings):
    return Fit(findings=Findings(findings), summary="chi2 3", coefficients={}).message


def test_pixels_that_may_be_saturated_are_the_first_cause_of_a_fit_that_is_not_reliable():
    flat = Finding("flat_top", "note", "1 pixel has the value 255")
    assert message(flat, DOUBT) == f"converged, but in doubt: {flat.text}; chi2 3; {DOUBT.text}"
    assert message(NOTE, flat) == f"converged: chi2 3; {NOTE.text}; {flat.text}"


def test_a_named_cause_is_printed_before_chi2_and_what_is_not_tested_last():
    cause = Finding("other_explanation", "doubt", "the data favour coma")
    estimated = Finding("estimated", "note", "estimated besides: coma")
    untested = untested_finding(["the sign"], {})
    assert message(untested, ERROR, cause) == f"misfit: {cause.text}; chi2 3; {ERROR.text}; not tested: the sign"
    assert message(untested, NOTE, estimated) == f"converged: {estimated.text}; chi2 3; {NOTE.text}; {untested.text}"
    harmless = Finding("other_explanation", "note", "perhaps coma")
    assert message(harmless) == f"converged: chi2 3; {harmless.text}"


def test_the_reason_of_a_doubt_is_printed_before_what_was_estimated_besides():
    estimated = Finding("estimated", "note", "estimated besides: coma")
    said = f"converged, but in doubt: {DOUBT.text}; {estimated.text}; chi2 3; {NOTE.text}"
    assert message(NOTE, estimated, DOUBT) == said


def test_a_message_has_twelve_lines_at_most():
    long = [Finding("pattern", "doubt", f"{k} " + "word " * 60) for k in range(9)]
    said = message(*long, ERROR)
    assert len(textwrap.wrap(said, 80)) <= 12
    assert said.startswith("misfit: 0 word")
    assert said.endswith(", misfit: see findings, --json")


@pytest.mark.parametrize(
    ("items", "text"),
    [
        (["the sign (reversed, the images agree)"], "not tested: the sign (reversed, the images agree)"),
        (["the sign (reversed, the images agree as well, and the even terms are negated)"], "not tested: the sign"),
        (["a (1)", "b", "c"], "not tested: a (1), b, c"),
        (["a long name of five", "another name of five words", "third one", "a fourth one"],
         "not tested: a long name of five, another name of five words and 2 more"),
        ([" ".join(["word"] * 20), "b"], f"not tested: {'word ' * 9}... and 1 more"),
    ],
)  # fmt: skip
def test_what_is_not_tested_is_told_in_fifteen_words(items, text):
    found = untested_finding(items, {"b": {"c": 1.0}})
    assert found.text == text
    assert len(text.split()) <= 15
    assert found.numbers == {"b": {"c": 1.0}, "what": items}


def test_what_was_tested_and_is_possible_is_not_called_untested():
    found = untested_finding(["a (±1)"], {}, "not excluded")
    assert (found.code, found.text) == ("untested", "not excluded: a (±1)")


def test_a_fit_is_plain_data():
    made = Fit(findings=Findings([DOUBT]), summary="chi2 1", coefficients={(2, 0): np.inf, "NA": np.float32(1.5)})
    facts = json.loads(json.dumps(made.to_dict(), allow_nan=False))
    assert facts["coefficients"] == {"2,0": None, "NA": 1.5}
    assert facts["findings"] == [
        {"code": "too_quiet", "severity": "doubt", "text": DOUBT.text, "numbers": {"chi2": 0.5}}
    ]
    assert (facts["status"], facts["converged"], facts["reliable"]) == ("doubtful", True, False)


def test_plain_data_of_arrays_and_nested_results():
    assert plain({"a": (np.arange(2), [np.nan]), "b": np.bool_(True)}) == {"a": [[0, 1], [None]], "b": True}


def test_a_result_is_shown_in_at_most_twelve_lines():
    made = Fit(findings=Findings(), summary="chi2 1.02", coefficients={})
    few, many = (made._shown([f"noll {k}" for k in range(count)]).splitlines() for count in (11, 30))
    assert [len(few), few[-1]] == [12, "  noll 10>"]
    assert [len(many), many[-1]] == [12, "  ... and 20 more: coefficients, errors>"]
