"""Score tests: sizes, errors and Bayes factors of what a linear model lacks, and how seldom they are wrong."""

import numpy as np
import pytest

from lommel.fit.score_tests import (
    Candidate,
    graded,
    graded_explanation,
    log_bayes_factor,
    other_explanation,
    score_tests,
    seen,
    untested,
)

DRAW = np.random.default_rng(4)
COLUMNS = DRAW.normal(size=(400, 9))
INFORMATION = COLUMNS.T @ COLUMNS
UNKNOWNS = (0, 1, 2)
CANDIDATES = [
    Candidate("one", (3,), 0.3),
    Candidate("two", (4,), 0.3),
    Candidate("pair", (5, 6), 0.3),
    Candidate("twin", (7,), 0.3),
]


def simulated(truth, seed=1, candidates=CANDIDATES, columns=COLUMNS):
    """Return the tests at the best fit of the unknowns alone to data of unit variance."""
    data = columns @ truth + np.random.default_rng(seed).normal(size=len(columns))
    best = np.linalg.lstsq(columns[:, UNKNOWNS], data, rcond=None)[0]
    residual = data - columns[:, UNKNOWNS] @ best
    return score_tests(columns.T @ columns, columns.T @ residual, UNKNOWNS, candidates), data


def test_sizes_and_errors_are_those_of_a_fit_with_the_candidate():
    tests, data = simulated(np.array([1.0, -2.0, 0.5, 0.4, 0, 0, 0, 0, 0]))
    for test, one in ((next(t for t in tests if t.name == c.name), c) for c in CANDIDATES):
        design = COLUMNS[:, [*UNKNOWNS, *one.columns]]
        both, covariance = np.linalg.lstsq(design, data, rcond=None)[0], np.linalg.inv(design.T @ design)
        np.testing.assert_allclose(test.size, both[3:], rtol=1e-6)
        np.testing.assert_allclose(test.errors, np.sqrt(np.diag(covariance)[3:]), rtol=1e-6)
    assert [test.name for test in seen(tests)] == ["one"]
    assert tests[0].sigmas == pytest.approx(tests[0].size[0] / tests[0].errors[0])
    assert str(tests[0]).startswith("one: 0.")


def test_the_bayes_factor_is_that_of_integrals_over_sizes():
    size, error, known, scale = 0.3, 0.1, 0.05, 0.4
    s = np.linspace(-4.0, 4.0, 200001)
    likelihood = np.exp(-0.5 * ((s - size) / error) ** 2)
    each = [
        np.trapezoid(likelihood * np.exp(-0.5 * (s / width) ** 2) / (width * np.sqrt(2 * np.pi)), s)
        for width in (scale, known)
    ]
    found = log_bayes_factor(np.array([size]), np.array([[error**2]]), known, scale)
    assert found == pytest.approx(np.log(each[0] / each[1]), rel=1e-6)


@pytest.mark.parametrize("size", [0.4, 0.1, -0.1, -0.4])
def test_an_effect_that_cannot_be_negative_has_half_the_prior(size):
    one = Candidate("one", (3,), 0.3, positive=True)
    (test,), _ = simulated(np.array([1.0, -2.0, 0.5, size, 0, 0, 0, 0, 0]), candidates=[one])
    s = np.linspace(0.0, 4.0, 200001)
    likelihood = np.exp(-0.5 * ((s - test.size[0]) ** 2 - test.size[0] ** 2) / test.errors[0] ** 2)
    factor = np.trapezoid(likelihood * 2.0 * np.exp(-0.5 * (s / 0.3) ** 2) / (0.3 * np.sqrt(2 * np.pi)), s)
    assert test.log_bayes == pytest.approx(np.log(factor), rel=1e-4)
    assert bool(seen([test])) == (size == 0.4)


def test_of_what_is_not_there_nothing_is_seen():
    alarms = sum(bool(seen(simulated(np.array([1.0, -2.0, 0.5, 0, 0, 0, 0, 0, 0]), seed)[0])) for seed in range(400))
    assert alarms <= 2


def test_candidates_that_the_data_cannot_tell_apart_are_rivals():
    columns = COLUMNS.copy()
    columns[:, 7] = columns[:, 3] + 0.02 * columns[:, 8]
    tests, _ = simulated(np.array([1.0, -2.0, 0.5, 0.4, 0, 0, 0, 0, 0]), columns=columns)
    rivals = seen(tests)
    assert {test.name for test in rivals} == {"one", "twin"}
    finding = other_explanation(rivals, ["one = 0.4", "twin = 0.4"])
    assert (finding.code, finding.severity) == ("other_explanation", "doubt")
    assert finding.text == "the data favour one = 0.4, or as well twin = 0.4, which they cannot tell apart"
    assert finding.numbers.keys() == {"one", "twin"}


def test_what_no_datum_tells_is_left_out():
    columns = COLUMNS.copy()
    columns[:, 3] = columns[:, 0]
    assert "one" not in {test.name for test in simulated(np.zeros(9), columns=columns)[0]}


def test_columns_that_are_multiples_of_each_other_are_left_out():
    truth = np.zeros(9)
    for seed in range(20):
        columns = COLUMNS.copy()
        columns[:, 6] = (0.1 + seed) * columns[:, 5]
        tests, _ = simulated(truth, seed, columns=columns)
        assert {test.name for test in tests} == {"one", "two", "twin"}


def test_a_prior_is_not_what_the_data_say():
    known, truth = 0.05, 0.4
    columns, data = COLUMNS[:, :2], COLUMNS[:, :2] @ [1.0, truth] + np.random.default_rng(2).normal(size=400)
    information = columns.T @ columns + np.diag([0.0, known**-2])
    best = np.linalg.solve(information, columns.T @ data)
    slope = columns.T @ (data - columns @ best) - np.array([0.0, best[1] / known**2])
    candidate = Candidate("constant", (1,), 3.0 * known, known, best[1])
    test = score_tests(information, slope, (0, 1), [candidate])[0]
    alone = np.linalg.lstsq(columns, data, rcond=None)[0]
    assert test.size[0] == pytest.approx(alone[1], rel=1e-6)
    assert test.sigmas == pytest.approx(alone[1] / np.hypot(test.errors[0], known), rel=1e-6)


def test_what_is_stated_and_not_tested_is_named_with_what_it_changes_most():
    columns = COLUMNS.copy()
    columns[:, 7] = columns[:, 1] + 0.02 * columns[:, 8]  # as the second unknown is
    stated = [Candidate("one", (3,), 0.3), Candidate("twin", (7,), 0.3)]
    tests, data = simulated(np.array([1.0, -2.0, 0.5, 0, 0, 0, 0, 0, 0]), candidates=stated, columns=columns)
    found = untested(columns.T @ columns, UNKNOWNS, {"a": 0, "b": 1, "c": 2}, stated, tests)
    assert [*found] == ["twin"]
    best = [np.linalg.lstsq(columns[:, UNKNOWNS], data + size * columns[:, 7], rcond=None)[0] for size in (0.0, 0.3)]
    name, change = found["twin"]
    assert name == "b"
    assert change == pytest.approx((best[1] - best[0])[1], rel=1e-6)
    # What no unknown feels changes nothing.
    assert untested(columns.T @ columns, UNKNOWNS, {"a": 0, "c": 2}, stated, tests) == {}


def grade_of(truth, columns, *, chi2=1.0, seed=1):
    """Return the tests, the grade, and the answers of least squares without and with each candidate."""
    tests, data = simulated(truth, seed, columns=columns)
    best = np.linalg.lstsq(columns[:, UNKNOWNS], data, rcond=None)[0]
    slope = columns.T @ (data - columns[:, UNKNOWNS] @ best)
    grade = graded(columns.T @ columns, slope, UNKNOWNS, CANDIDATES, 3, tests, (chi2, (2 / len(data)) ** 0.5))
    return tests, grade, best, data


def test_the_grade_tells_what_an_effect_moves_and_what_remains_open():
    columns = COLUMNS.copy()
    columns[:, 3] += 0.8 * columns[:, 1]
    tests, grade, best, data = grade_of(np.array([1.0, -2.0, 0.5, 0.5, 0, 0, 0, 0, 0]), columns, chi2=1.2)
    assert [test.name for test in seen(tests)] == ["one"]
    with_one = np.linalg.lstsq(columns[:, [*UNKNOWNS, 3]], data, rcond=None)[0]
    error = np.linalg.inv(columns[:, UNKNOWNS].T @ columns[:, UNKNOWNS])[1, 1] ** 0.5
    assert grade.move == pytest.approx(abs(with_one[1] - best[1]) / error, rel=0.15)
    assert grade.worst == 1
    assert grade.rest < 1.0
    np.testing.assert_allclose(best + grade.marginal.shift, with_one[:3], atol=0.03)
    # chi2 falls by that which the effect explains.
    residuals = [
        data - columns[:, c] @ np.linalg.lstsq(columns[:, c], data, rcond=None)[0] for c in (UNKNOWNS, [*UNKNOWNS, 3])
    ]
    gain = (residuals[0] @ residuals[0] - residuals[1] @ residuals[1]) / len(data)
    assert 1.2 - grade.left == pytest.approx(gain, rel=0.2)


def test_rivals_that_differ_in_the_answer_are_a_doubt_with_errors_that_contain_both():
    columns = COLUMNS.copy()
    columns[:, 7] = columns[:, 3] - columns[:, 1] + 0.02 * columns[:, 8]
    truth = np.array([1.0, -2.0, 0.5, 0.4, 0, 0, 0, 0, 0])
    tests, grade, best, data = grade_of(truth, columns)
    assert {test.name for test in seen(tests)} == {"one", "twin"}
    answers = [np.linalg.lstsq(columns[:, [*UNKNOWNS, j]], data, rcond=None)[0][1] for j in (3, 7)]
    error = grade.marginal.covariance[1, 1] ** 0.5
    assert np.abs(best[1] + grade.marginal.shift[1] - answers).max() < 2.0 * error
    assert abs(answers[1] - answers[0]) > error
    assert grade.severity == "doubt"


@pytest.mark.parametrize(("chi2", "severity"), [(1.0, "note"), (1.6, "error"), (0.5, "error")])
def test_an_effect_that_leaves_or_overshoots_chi2_is_an_error(chi2, severity):
    _, grade, _, _ = grade_of(np.array([1.0, -2.0, 0.5, 0.3, 0, 0, 0, 0, 0]), COLUMNS, chi2=chi2 + 0.09)
    assert (grade.severity, grade.explained) == (severity, severity == "note")


def test_no_negative_chi2_is_printed():
    tests, grade, _, _ = grade_of(np.array([1.0, -2.0, 0.5, 0.3, 0, 0, 0, 0, 0]), COLUMNS, chi2=0.05)
    assert grade.left < 0.0
    finding = graded_explanation(seen(tests), ["a halo"], grade, ["a", "b", "c"])
    assert (
        finding.text == "the data favour a halo: the misfit is too large for a linear correction, and so for its size"
    )
