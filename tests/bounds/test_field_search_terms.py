"""How the search for a field map judges its fits, a second time: by rules that are written out star by star."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from scipy import special

from lommel.core.answers import ToleranceError
from lommel.estimation import field_search
from lommel.estimation.field_search import Outcome, Search, outliers
from lommel.fit.goodness_of_fit import largest_plausible_chi2
from lommel.fit.scoring import Progress


def made(**parts):
    return SimpleNamespace(**{"report": Progress(None)} | parts)


def quality(chi2, spread=0.1):
    return made(chi2=np.array(chi2), spread=np.broadcast_to(spread, len(chi2)))


def solution(median, **more):
    """Return a fit whose stars have a median chi2 in images of the accuracy of a search."""

    def star_quality(x, *, fast):
        assert fast
        return quality([0.9 * median, median, 3.0 * median])

    return made(x=None, model=made(star_quality=star_quality), **more)


def test_stars_are_outliers_above_five_deviations_and_count_as_five():
    assert outliers(quality([1.0, 1.0, 1.0, 1.0, 1.625], 0.125)).tolist() == [False] * 5
    assert outliers(quality([1.0, 1.0, 1.0, 1.0, 1.6251], 0.125)).tolist() == [False] * 4 + [True]
    for side in (0.999, 1.001):  # the median deviation is 0.1
        chi2 = [0.8, 0.9, 0.9, 1.0, 1.1, 1.1, 1.0 + 5.0 * 0.14826 * side]
        assert outliers(quality(chi2, 0.01)).tolist() == [False] * 6 + [side > 1.0]
    fit = made(model=made(star_quality=lambda x: quality([0.5, 1.2, 9.0])), x=None)
    assert Outcome(fit, np.arange(3), *[None] * 7).cost == pytest.approx(0.0 + 2.0 + 5.0 + 3 * 5.0, rel=1e-9)
    limit = Search._chi2_limit(made(scores=made(spread=[0.1, 0.3])))
    assert special.chdtrc(200.0, 200.0 * limit) == pytest.approx(1e-3, rel=1e-6)


def test_a_search_begins_without_misfits():
    first = made(directions=np.ones((1, 2)), mean_squares=np.ones(2))
    stars = made(width_count=0, exposures=1, shape=(9, 9), first_star=first)
    assert Search(stars, np.zeros((3, 2)), np.ones(2), 0, None, None).misfits.tolist() == []


# For each star: the spread, chi2 of its starts, whether it is sure, its number of starts, and which of them is best.
STARTS = [
    (1e-3, [1.0199], True, 1, 0), (0.1, [1.32], True, 1, 0),  # good: below 1.02, or below what noise explains
    (1e-3, [3.0, 3.03], True, 2, 0),  # the same within 0.02 of (chi2 - 1)
    (1e-3, [3.0, 3.045, 3.0], True, 3, 0), (1e-3, [1.5, 1.515, 1.5], True, 3, 0),
    (1e-3, [51.0, 52.0, 60.0], False, 3, 0),  # above 1.5 times the median of 2.25
    (1e-3, [1.02, 1.02], True, 2, 0), (1e-3, [3.6, 3.375, 3.5, 3.7, 3.8], False, 5, 1),
]  # fmt: skip


def test_single_stars_have_starts_until_one_is_good_or_two_agree(monkeypatch):
    asked, chosen = [0] * len(STARTS), 10 + np.arange(len(STARTS))

    def search(model, x, *_, fast):
        found = [(spread, chi2[asked[k]]) for k, (spread, chi2, *_) in ((k, STARTS[k]) for k in model - 10)]
        starts = np.array([[asked[k]] for k in model - 10])
        for k in model - 10:
            asked[k] += 1
        spread, chi2 = np.array(found).T
        return starts, quality(chi2, spread)

    monkeypatch.setattr(field_search, "SingleStars", lambda stars, rows, widest: rows)
    monkeypatch.setattr(field_search, "search_rows", search)
    stars = made(size=1, first_star=made(sign_ambiguous=False))
    self = made(stars=stars, simplified_stars=stars, widest=1.0, _random_start=lambda model, scatter:
        None)  # fmt: skip
    x, chi2, sure = Search.fit_single_stars(self, chosen)
    assert sure.tolist() == [one[2] for one in STARTS]
    assert asked == [one[3] for one in STARTS]
    assert x[:, 0].tolist() == [one[4] for one in STARTS]
    assert chi2.tolist() == [min(one[1]) for one in STARTS]


def test_a_start_is_good_whose_median_star_is_and_trials_come_in_the_order_of_theirs(monkeypatch):
    monkeypatch.setattr(field_search, "robust", lambda *_: (None, None))
    fits = [None, solution(1.0801), solution(1.08), solution(1.0)]
    left = iter(fits)
    self = made(brightest=lambda: np.arange(9), basis=len, stars=made(start=np.zeros((9, 1))), metric=None,
        squared_widths=None, _trial_polynomials=lambda *_: [1, 2, 3], refine=lambda *_: next(left))  # fmt: skip
    assert Search.fit_from_start(self) is fits[2]
    held = made(basis=np.ones((1, 1)), row=lambda trial, *_: trial, star_quality=lambda x, *, fast: quality([abs(x[0,
        0] - 1.2)] if fast else [1.0]))  # fmt: skip
    self.model, self.fit_nuisance = lambda *_, held_=held, **__: held_, lambda *_: None
    self.stars.first_star = made(unknowns=made(terms=((2, 0),)))
    assert [trial[0, 0] for trial in Search._trial_polynomials(self, None, np.zeros((1, 1)), None)] == [1.0, 2.0]


INF = [np.inf] * 4
STARS = [1.0, 1.1, 1.2, 1.2, 1.3, 1.875, 9.0, 8.0, *INF]  # 1.5 times the median is 1.875


@pytest.mark.parametrize(("chi2", "sure", "medians", "best"), [(STARS, 9, [2.0, 1.2751, 1.2749, 1.0], 2), (STARS, 8,
    [2.0, 1.2749, 1.2749, 1.4], 1), (STARS, 8, [1.2, 1.0801, 1.0799, 1.0], 2), (STARS, 8, [1.08, 1.07, 1.0], 1),
    ([0.5, 0.5, 1.0, 1.5, 9.0], 5, [2.0], 0), ([1.0, 1.0, 1.0, 9.0], 4, [2.0], 0), ([1.0, 1.0, 1.0, 1.0, 1.5, 9.0,
    9.0], 7, [1.0], 0), (INF, 0, [], None)])  # fmt: skip
def test_a_joint_fit_begins_with_typical_stars_and_ends_where_it_fits_as_well(chi2, sure, medians, best, monkeypatch):
    asked, fits = [], [solution(median) for median in medians]
    left = iter(fits)
    chi2, count = np.array(chi2), len(chi2)
    first = made(one_focus=True, even=np.ones(1), directions=np.ones((1, 1)), mean_squares=np.ones(1))

    def starts(places, waves, even, negate, bases, quality, *_):
        asked.append(quality)
        return ((None, None) for _ in fits)

    def refine(chosen, polynomials, widths, steps):
        asked.append((chosen.tolist(), widths))
        return next(left)

    monkeypatch.setattr(field_search, "candidates", starts)
    single = made(parts=lambda x: (x, x[:, None] ** 2, None))
    monkeypatch.setattr(field_search, "SingleStars", lambda *_: single)
    self = made(stars=made(first_star=first, fixed_of_images=np.zeros((count, 1, 1))),
        brightest=lambda: np.arange(count), fit_single_stars=lambda _: (np.arange(count)[:, None] + 1.0, chi2,
        np.arange(count) < sure), degree=0, widest=1.0, basis=lambda *_: None, places=np.zeros((count, 2)),
        negated=len, metric=None, draw=None, refine=refine)  # fmt: skip
    if best is None:
        with pytest.raises(ToleranceError, match="no star could be fitted"):
            Search.fit_from_single_stars(self)
        return
    assert Search.fit_from_single_stars(self) is fits[best]
    known = [k for k in range(count) if np.isfinite(chi2[k])]
    typical = [k for k in known if chi2[k] <= 1.5 * np.median(chi2[known])]
    used = typical if len(typical) >= 0.75 * len(known) and len(typical) >= 4 else known
    assert self.misfits.tolist() == [k for k in known if k not in typical]
    median = np.median(chi2[used])
    assert asked[0] == pytest.approx([min((median / chi2[k]) ** 2, 1.0) for k in used], rel=1e-9)
    width = np.median([(k + 1.0) ** 2 for k in used if chi2[k] <= 1.5 * median])
    assert (asked[1][0], asked[1][1].item()) == (used, width)


@pytest.mark.parametrize(("costs", "width", "name"), [((100.0, 101.9, 200.0), 1.0, "Gaussian"), ((100.0, 102.0,
    200.0), 1.0, "both"), ((100.0, 200.0, 101.9), 1.0, "seeing"), ((100.0, 101.0, 101.0), 0.07, "both"), ((100.0,
    101.0, 101.0), 0.05, "Gaussian"), ((100.0, 98.0, 103.0), 1.0, "Gaussian")])  # fmt: skip
def test_blur_of_one_width_is_preferred_unless_two_gain_two(costs, width, name):
    def fit(kind, cost):
        scores = made(deviance=[cost])
        model = made(stars=made(kind=kind, with_blur_profile=profile), chosen=None)
        return made(kind=kind, scores=scores, polynomials=list, nuisance=list, model=model,
                    squared_widths=lambda: np.array([[width]]))  # fmt: skip

    def profile(one):
        return one.names[0] if len(one.names) == 1 else "both"

    fits = dict(zip(("both", "Gaussian", "seeing"), map(fit, ("both", "Gaussian", "seeing"), costs), strict=True))
    self = made(refits=0)
    self.refine = lambda *_, **__: fits[self.stars]
    assert Search.best_profile(self, fits["both"]).kind == name
    assert self.blur_costs == {"Gaussian": costs[1], "seeing": costs[2], "both": costs[0]}


@pytest.mark.parametrize(("before", "after", "used", "taken"), [(1.5, 1.549, 6, True), (1.5, 1.551, 6, False), (1.1,
    1.25, 6, True), (1.1, 1.2501, 6, False), (1.5, 1.2, 5, False)])  # fmt: skip
def test_rejected_stars_are_taken_back_where_more_fit_as_well(before, after, used, taken, monkeypatch):
    def fit(chi2, count):
        return made(scores=made(chi2=[chi2]), model=made(chosen=np.arange(count)), squared_widths=list,
            polynomials=lambda: np.zeros((1, 1)))  # fmt: skip

    monkeypatch.setattr(field_search, "robust", lambda *_: (None, None))
    refit, calls = fit(after, used), []
    self = made(basis=len, metric=None, refine=lambda *_: refit, reject_outliers=lambda one: one,
        _chi2_limit=lambda _: 1.25)  # fmt: skip
    one = np.zeros((1, 1))
    assert Search._refit_with(self, fit(before, 5), one, np.arange(1), one) is (refit if taken else None)
    self = made(stars=made(count=6, has_corners=False), misfits=np.array([4]), basis=lambda _: one,
        _fit_individually=lambda *_: (np.array([True, False, False]), np.zeros((3, 1))), _refit_with=lambda fit,
        waves, added, _: calls.append(added.tolist()))  # fmt: skip
    old = fit(before, 3)
    old.model.basis = one
    assert Search.readmit_stars(self, old) is old
    assert calls == [[3], [3, 5]]


def test_rejected_stars_fit_where_noise_explains_them_or_a_search_is_sure_of_nearly_as_good_a_fit(monkeypatch):
    limit = float(largest_plausible_chi2(0.1, 1e-3))
    rejected, found = np.arange(10, 17), quality([0.999 * limit, limit, 9.0, 9.0, 9.0, 9.0, 9.0])
    monkeypatch.setattr(field_search, "search_rows", lambda single, x, *_, fast: (x, found))
    single = made(row=lambda waves, *_: waves, wavefronts=lambda x: x)
    monkeypatch.setattr(field_search, "SingleStars", lambda *_: single)
    asked = []

    def again(stars):
        asked.extend(stars.tolist())
        return np.ones((5, 1)), np.array([1.1, 1.499, 1.5, 1.1, 9.0]), np.array([True, True, True, False, True])

    self = made(stars=made(first_star=made(sign_ambiguous=False)), basis=lambda stars: np.zeros((len(stars), 1)),
        widest=1.0, misfits=np.array([12]), fit_nuisance=lambda *_: None, fit_single_stars=again,
        _chi2_limit=lambda _: 1.25)  # fmt: skip
    fit = made(squared_widths=list, polynomials=lambda: np.zeros((1, 1)))
    good, _ = Search._fit_individually(self, rejected, fit)
    assert asked == [11, 13, 14, 15, 16]
    assert good.tolist() == [True, True, False, True, False, False, False]
    assert self.misfits.tolist() == [12, 14, 15, 16]
