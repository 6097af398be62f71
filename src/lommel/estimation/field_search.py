"""Search for a field map: fits of individual stars, signs of even terms, polynomials, rejection of outlying stars.

Positions are in half fields, -1 to 1 across the sensor. `own` is an array of the parameters of single star images:
tilts, flux and background. `squares` are squared widths of the blur, pixels^2. `progress` is a pair of fractions of
the whole search: the fraction done before a stage, and the fraction that the stage takes. lnL: log-likelihood.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.blur.mixtures import OUTER, Shape
from lommel.core.answers import Declined, ToleranceError
from lommel.estimation.field_checks import missing_tests, slope_findings
from lommel.estimation.field_signs import candidates, highest_degree, monomials, robust
from lommel.estimation.field_stars import FieldStars, Quality, SingleStars, WholeField
from lommel.fit import goodness_of_fit
from lommel.fit.findings import Finding, Findings
from lommel.fit.goodness_of_fit import SURE, chi2_findings
from lommel.fit.score_tests import Marginal, ScoreTest, causes_of_misfit
from lommel.fit.scoring import Scores, search_rows
from lommel.methods.derivative_names import term_of

_MAX_SINGLES = 60  # largest number of stars that are fitted individually
_MAX_STARTS = 5  # largest number of starts for each individual star
_MIN_STARTS = 3  # number of starts after which a star with a large chi2 is abandoned, if enough stars are sure
_STEPS = 14  # maximum number of scoring steps from each start
_SCATTER = 0.7, 0.25  # standard deviation (radians rms) of random starts: first three terms, other terms
_START_BLUR = 0.5  # width of the blur at the start, pixels
_MAX_BLUR = 0.15  # largest width of the blur of individual stars, as a fraction of a window's side
_SINGLE_TERMS = 3  # number of terms of the blur model for individual stars
_SHAPE_STEPS = 6  # maximum number of steps of a fit with another shape of blur
_OUTER_GAIN = 5.0  # the outer scale is searched if lnL of seeing exceeds lnL of a Gaussian by this
_MIN_GAIN = 1.0  # lnL by which another minimum or outer scale must be better to be preferred
_MIN_WIDTH_GAIN = 2.0  # lnL by which a blur of two widths must be better than one of a single width
_NARROW = 0.06  # squared width of blur, pixels^2, below which its shape does not matter
_SHIFTS = {(2, 0): (-2.0, -1.0, 0.0, 1.0, 2.0), (4, 0): (-1.2, 0.0, 1.2)}  # trial offsets of a term, radians rms
_RANKING_STARS, _FITTED_SHIFTS = 20, 2  # number of stars whose chi2 ranks the offsets; number of best offsets fitted
_GOOD_CHI2 = 1.08  # largest median chi2 of stars at which a candidate is accepted
_SAME_CHI2 = 0.02  # two fits of a star are at the same minimum if chi2 differs by less than this times (chi2 - 1)
_MIN_SURE = 0.75  # smallest fraction of sure stars (see `singles`) at which their chi2 is a reference for candidates
_MAX_CHI2_RATIO = 1.5  # a star whose chi2 exceeds the median chi2 by this factor is no single star (double, defect)
_EXCESS_RATIO = 1.1  # largest ratio of chi2 - 1 of an acceptable fit to chi2 - 1 of the reference fit
_OUTLIER = 5.0  # a star is an outlier if its chi2 exceeds the median by more than this many standard deviations
_ROUNDS = 4  # maximum number of rounds of rejection
_MAX_REJECTED = 0.4  # largest fraction of rejected stars
_MANY_REJECTED = 0.25  # fraction of rejected stars above which the fit did not converge
_HELD_OUT = 0.05  # largest chi2 - 1 of held-out stars in the absence of noise
_QUIET = 0.9  # chi2 below which the stated noise must be too large
_MIN_NEGATED = 0.05  # smallest even term (radians rms) for which a search with the negated term is run
_MAX_NEGATED = 3  # largest number of searches with a negated sign
_TRIAL_STEPS, _BEST_STEPS = 2, 5  # steps of each search with a negated sign; further steps of the best search
_RIVAL_STEPS = 12  # further steps of a search that ended at another minimum
_MAX_RIVAL_COST, _MIN_RIVAL_DISTANCE = 8.0, 3.0  # another minimum: largest loss of lnL; least distance, std. errors
_CAUSES = "pupil, pixel, noise, defocus or blur are wrong, the degree is too low, or terms are missing"

Report = Callable[[float, float], object]


@dataclass
class Solution:
    """A fit of a field: the model of the used stars, the parameters `x`, and the quality of the fit."""

    model: WholeField
    x: Array
    scores: Scores
    settled: bool

    def of_stars(self) -> Array:
        """Return the parameters of the images of r stars in e exposures, shape (r, own, e)."""
        return self.model.parts(self.x)[2].copy()

    def polynomials(self) -> Array:
        """Return the coefficients of the polynomials, shape (k, m): k wavefront terms, m monomials."""
        return self.model.polynomials(self.x).copy()

    def squares(self) -> Array:
        """Return the squared widths of the blur, shape (e, b): e exposures, b widths."""
        return np.array(self.model.squares(self.x)[0])


class Rival(NamedTuple):
    """Another minimum that fits nearly as well as the best one."""

    cost: float  # lnL of the best minimum minus lnL of this minimum
    sigmas: float  # largest distance between coefficients of the two minima, standard errors


@dataclass
class Outcome:
    """A fit of all stars that were not rejected, with the results of its tests."""

    found: Solution
    rejected: NDArray[np.intp]  # indices of the rejected stars
    held_out: tuple[float, float]  # chi2 of held-out stars, and its standard deviation
    bright: tuple[float, float]  # chi2 of pixels in which stars exceed the noise, and its standard deviation
    places: Array  # positions of the stars, half fields
    shapes: dict[str, float]  # -lnL of each shape of blur that was compared
    notes: list[Finding]  # findings on sloping backgrounds, and on input values that the images do not test
    tests: tuple[ScoreTest, ...]  # score tests of terms that the model lacks
    marginal: Marginal  # shift and covariance of the coefficients, marginalized over possible effects
    rival: Rival | None = None

    @property
    def findings(self) -> Findings:
        """Findings on the fit."""
        chi2, spread = float(self.found.scores.chi2[0]), float(self.found.scores.spread[0])
        causes = causes_of_misfit(_CAUSES, chi2, spread, self.tests)
        found = chi2_findings(chi2, spread, causes)
        causes = causes and f"; {causes}"
        bright, off = self.bright
        if not found and math.isfinite(bright) and bright >= (limit := float(goodness_of_fit.most(off))):
            where = "of the pixels in which stars exceed the noise"
            text = f"chi2 {bright:.4g} {where}, above {limit:.4g}, the limit for noise alone{causes}"
            found = [Finding("misfit", "error", text, {"bright_chi2": bright, "limit": limit})]
        held, off = self.held_out
        if held - 1.0 > (limit := _HELD_OUT + 4.0 * off):
            text = f"held-out stars do not follow the map that was fitted to the other stars{causes}"
            found.append(Finding("held_out", "error", text, {"held_out": held, "limit": 1.0 + limit}))
        count = len(self.rejected) + len(self.found.model.chosen)
        if len(self.rejected) > _MANY_REJECTED * count:
            text = f"many stars do not follow the map{causes}"
            found.append(Finding("many_rejected", "error", text, {"rejected": len(self.rejected), "of": count}))
        if self.rival is not None:
            text = (
                f"another wavefront, {self.rival.sigmas:.0f} standard errors away, fits as well (lnL "
                f"{-self.rival.cost:+.1f}): add exposures at other defoci, or give start"
            )
            found.append(Finding("another_minimum", "doubt", text, self.rival._asdict()))
        too_quiet = [replace(each, severity="error") for each in found if each.code == "too_quiet" and chi2 < _QUIET]
        # Above _QUIET, a low chi2 is often due to chance with few electrons, and is not reported.
        return Findings([*too_quiet, *(each for each in found if each.code != "too_quiet"), *self.notes])

    @property
    def cost(self) -> float:
        """Sum over stars of (chi2 - 1) / spread, from 0 to `_OUTLIER`; a rejected star contributes `_OUTLIER`."""
        each = self.found.model.each(self.found.x)
        # The upper limit prevents a single double star from deciding between two fits.
        off = np.clip((each.chi2 - 1.0) / each.spread, 0.0, _OUTLIER)
        return float(off.sum()) + _OUTLIER * len(self.rejected)


class Search:
    """The stages of a search; `places` (n, 2) are positions of stars, `part` (2,) is the size of a pixel in them."""

    def __init__(
        self, stars: FieldStars, places: Array, part: Array, degree: int, draw: np.random.Generator, report: Report
    ) -> None:
        self.stars, self.places, self.degree, self.draw, self.report = stars, places, degree, draw, report
        self.first = stars
        self.shapes: dict[str, float] = {}
        self.rival: Rival | None = None
        #: Indices of double stars and defects, which no wavefront fits: they are not fitted individually again.
        self.misfits = np.zeros(0, dtype=np.intp)
        self.part = part
        #: The stars with fewer terms of the blur model, for fits of individual stars.
        self.rough = stars.shaped(Shape.turbulent(terms=_SINGLE_TERMS)) if stars.widths == 2 else stars
        self.squares = np.full((stars.exposures, stars.widths), _START_BLUR**2 / max(stars.widths, 1))
        self.widest = (_MAX_BLUR * min(stars.shape)) ** 2
        directions = stars.one.directions
        self.metric = (directions * stars.one.mean_squares) @ directions.T

    def basis(self, chosen: NDArray[np.intp], degree: int | None = None) -> Array:
        """Return the monomials at the positions of stars, shape (n, m)."""
        u, v = self.places[chosen].T
        return monomials(u, v, self.degree if degree is None else degree)

    def model(self, chosen: NDArray[np.intp], *, held: bool = False) -> WholeField:
        """Return the model of the chosen stars; polynomials and blur are fixed if `held` is True."""
        return WholeField(self.stars, chosen, self.basis(chosen), held=held)

    def brightest(self) -> NDArray[np.intp]:
        """Return the indices of the brightest stars, which are fitted individually."""
        counted, _, _, valid = self.stars.star
        level = np.median(counted, axis=-1, keepdims=True)
        bright = (valid * (counted - level)).sum(axis=(1, 2))
        return np.sort(np.argsort(-bright, kind="stable")[:_MAX_SINGLES])

    def singles(
        self, chosen: NDArray[np.intp], progress: tuple[float, float] = (0.0, 0.4)
    ) -> tuple[Array, Array, NDArray[np.bool_]]:
        """Fit stars individually: return the best parameters (n, p), chi2, and a mask of sure stars.

        A star is sure if it fits, or if two starts ended at the same chi2: further starts are unlikely to help.
        """
        stars = self.stars
        best, chi2 = np.zeros((len(chosen), stars.size)), np.full(len(chosen), np.inf)
        sure = np.zeros(len(chosen), dtype=bool)
        undecided = np.arange(len(chosen))
        for turn in range(_MAX_STARTS):
            model = SingleStars(self.rough, chosen[undecided], self.widest)
            x = self._random_start(model, scatter=turn > 0 or stars.one.sign_ambiguous)

            def report(step: int, value: float, turn: int = turn) -> None:
                self.report(progress[0] + progress[1] * (turn + step / _STEPS) / _MAX_STARTS, value)

            with suppress(Declined, ToleranceError):
                x, scores, *_ = search_rows(model, x, _STEPS, report, fast=True)
                before = chi2[undecided]
                better = scores.chi2 < before
                best[undecided[better]], chi2[undecided[better]] = x[better], scores.chi2[better]
                fits = scores.chi2 < np.maximum(goodness_of_fit.most(scores.spread, SURE), 1.02)
                alike = np.abs(scores.chi2 - before) < _SAME_CHI2 * np.maximum(chi2[undecided] - 1.0, 0.0)
                sure[undecided[fits | alike]] = True
                undecided = undecided[~(fits | alike)]
            if turn + 1 >= _MIN_STARTS and sure.mean() >= _MIN_SURE:  # a large chi2 indicates a double star or defect
                undecided = undecided[chi2[undecided] <= _MAX_CHI2_RATIO * np.median(chi2)]
            if undecided.size == 0:
                break
        return best, chi2, sure

    def _random_start(self, model: SingleStars, *, scatter: bool) -> Array:
        stars = self.stars
        names = stars.one.unknowns.terms
        size = np.full(len(names), _SCATTER[1])
        size[: min(3, len(names))] = _SCATTER[0]
        waves = stars.start[model.chosen].copy()
        if scatter:
            waves += self.draw.normal(size=waves.shape) * size
        return model.row(waves, self.squares, self._centred(model.chosen, waves))

    def _centred(self, rows: NDArray[np.intp], waves: Array) -> Array:
        """Return initial parameters `own` for which the images of stars have the observed centroids."""
        one = self.stars.one
        edge = self.stars.base[rows] + (waves @ one.directions)[:, None]
        # The mean slope of the wavefront shifts the centroid: tilts correspond to the centroid minus this shift.
        return self.stars.start_values(rows, self._centroids[rows] - one.mean_slopes(edge).swapaxes(0, 1))

    @cached_property
    def _centroids(self) -> Array:
        return self.stars.centroids()

    def from_start(self) -> Solution | None:
        """Fit the brightest stars, starting at the initial wavefronts; return None if no fit is good enough."""
        chosen = self.brightest()
        polynomials, _ = robust(self.basis(chosen), self.stars.start[chosen], np.ones(len(chosen)), self.metric)
        squares, few = self.squares, chosen[:: max(1, len(chosen) // _RANKING_STARS)]
        starts = itertools.chain([polynomials], self._shifted(few, polynomials, squares))
        for turn, tried in enumerate(starts):
            found = self.refined(chosen, tried, squares, 10, (0.15 * turn, 0.15))
            if found is not None and np.median(found.model.each(found.x, fast=True).chi2) <= _GOOD_CHI2:
                return found
        return None

    def _shifted(self, chosen: NDArray[np.intp], polynomials: Array, squares: Array) -> Iterator[Array]:
        """Yield polynomials with trial defocus and spherical aberration added, in order of increasing chi2."""
        names = self.stars.one.unknowns.terms
        shifts = [_SHIFTS.get(term_of(name) or (0, 0), (0.0,)) for name in names]
        held, found = self.model(chosen, held=True), []
        for added in itertools.product(*shifts):
            if not any(added):
                continue
            tried = np.zeros((len(names), held.basis.shape[1]))
            tried[:, : polynomials.shape[1]] = polynomials
            tried[:, 0] += added
            with suppress(Declined, ToleranceError):
                x = held.row(tried, squares, self.placed(chosen, tried, squares))
                found.append((float(np.median(held.each(x, fast=True).chi2)), tried))
        yield from (tried for _, tried in sorted(found, key=lambda each: each[0])[:_FITTED_SHIFTS])

    def from_singles(self) -> Solution:
        """Fit the brightest stars jointly, starting at fits of the individual stars."""
        stars = self.stars
        chosen = self.brightest()
        x, chi2, sure = self.singles(chosen)
        if not np.isfinite(chi2).any():
            raise ToleranceError("no star could be fitted: aberrations are too strong for the tolerance; pass start")
        usable = np.isfinite(chi2)
        # Polynomials cannot fit better than individual wavefronts: a fit with nearly the same chi2 ends the search.
        floor = _EXCESS_RATIO * (float(np.median(chi2[usable])) - 1.0) if sure.mean() >= _MIN_SURE else 0.0
        accepted_chi2 = max(_GOOD_CHI2, 1.0 + floor)
        # Stars with a poor individual fit would distort the polynomials; `whole` adds stars that fit the map later.
        alike = usable & (chi2 <= _MAX_CHI2_RATIO * np.median(chi2[usable]))
        self.misfits = chosen[usable & ~alike]
        if alike.sum() >= max(_MIN_SURE * usable.sum(), 4):
            usable = alike
        chosen, x, chi2 = chosen[usable], x[usable], chi2[usable]
        quality = 1.0 / np.maximum(chi2 / max(float(np.median(chi2)), 1e-9), 1.0) ** 2
        waves, squares, _ = SingleStars(stars, chosen, self.widest).parts(x)
        good = chi2 <= _MAX_CHI2_RATIO * np.median(chi2)
        square = np.median(squares[good], axis=0)
        degree = highest_degree(self.degree, len(chosen))
        bases = [self.basis(chosen, d) for d in sorted({min(2, degree), degree})]
        if self.one_focus and (stars.one.even * stars.one.directions).any():
            whole = stars.base[chosen, 0] + waves @ stars.one.directions
            even = (whole * stars.one.even) * np.sqrt(stars.one.mean_squares)
            negated = partial(self.negated, chosen)
            tried = candidates(self.places[chosen], waves, even, negated, bases, quality, self.metric, self.draw)
        else:
            tried = iter([(robust(bases[-1], waves, quality, self.metric)[0], waves)])
        best: Solution | None = None
        lowest = np.inf
        for k, (polynomials, _) in enumerate(tried):
            found = self.refined(chosen, polynomials, square, 8, (0.4 + 0.05 * min(k, 5), 0.05))
            if found is None:
                continue
            median = float(np.median(found.model.each(found.x, fast=True).chi2))
            if median < lowest:
                best, lowest = found, median
            if median < accepted_chi2:
                break
        if best is None:
            raise ToleranceError("no field could be fitted: aberrations are too strong for the tolerance; pass start")
        return best

    def negated(self, chosen: NDArray[np.intp], waves: Array) -> Array:
        """Return the wavefronts `waves` of stars with the even part of the phase negated."""
        return self.stars.one.negated(waves, self.stars.base[chosen, 0])

    def refined(
        self,
        chosen: NDArray[np.intp],
        polynomials: Array,
        squares: Array,
        most: int,
        progress: tuple[float, float],
        own: Array | None = None,
        *,
        fast: bool = True,
    ) -> Solution | None:
        """Fit stars in at most `most` steps from polynomials (k, m); return None if images cannot be computed."""
        m = (self.degree + 1) * (self.degree + 2) // 2
        start = np.zeros((len(polynomials), m))
        start[:, : polynomials.shape[1]] = polynomials[:, :m]
        model = self.model(chosen)
        try:
            x = model.row(start, squares, self.placed(chosen, start, squares) if own is None else own)

            def report(step: int, value: float) -> None:
                self.report(progress[0] + progress[1] * step / (most + 1), value)

            x, scores, settled, _ = search_rows(model, x, most, report, fast=fast)
        except (Declined, ToleranceError):
            return None
        return Solution(model, x, scores, bool(settled[0]))

    def placed(self, chosen: NDArray[np.intp], polynomials: Array, squares: Array) -> Array:
        """Fit the image parameters `own` (r, own, e) of stars, with fixed wavefronts and blur."""
        model = self.model(chosen, held=True)
        own = self._centred(chosen, model.basis @ polynomials.T)
        if not self.stars.cornered:  # the start positions of corners are accurate to a pixel
            psf = model.images(model.row(polynomials, squares, own), fast=True)[0]
            own[:, :2] += self.stars.shifts(chosen, psf) * self.stars.one.tilt_of_pixel
        x, *_ = search_rows(model, model.row(polynomials, squares, own), 6, _no_progress, fast=True)
        return model.parts(x)[2]

    def cleaned(self, found: Solution, progress: tuple[float, float]) -> Solution:
        """Reject outlying stars and fit again, in at most `_ROUNDS` rounds."""
        first = len(found.model.chosen)
        for _ in range(_ROUNDS):
            good = ~outliers(found.model.each(found.x, fast=True))
            left = int(good.sum())
            if good.all() or left < (1.0 - _MAX_REJECTED) * first or left <= found.model.basis.shape[1]:
                break
            chosen, own = found.model.chosen[good], found.of_stars()[good]
            refit = self.refined(chosen, found.polynomials(), found.squares(), 10, progress, own)
            if refit is None:
                break
            found = refit
        return found

    def whole(self, found: Solution) -> tuple[Solution, NDArray[np.intp]]:
        """Fit all stars except outliers, from a fit of some stars; return the fit and the indices of outliers."""
        every = np.arange(self.stars.count)
        polynomials, squares = found.polynomials(), found.squares()
        others = np.setdiff1d(every, found.model.chosen)
        bad = np.zeros(len(every), dtype=bool)
        wide: Solution | None = None
        if len(others):
            own = np.empty((len(every), self.stars.own, self.stars.exposures))
            own[found.model.chosen], own[others] = found.of_stars(), self.placed(others, polynomials, squares)
            held = self.model(every, held=True)
            bad = outliers(held.each(held.row(polynomials, squares, own), fast=True))
            if bad.mean() > _MAX_REJECTED or (~bad).sum() <= held.basis.shape[1]:
                bad[:] = False
            if not np.array_equal(every[~bad], found.model.chosen):
                wide = self.refined(every[~bad], polynomials, squares, 10, (0.7, 0.15), own[~bad])
        found = self.regained(self.lowest(self.cleaned(wide or found, (0.85, 0.02))))
        own, chosen = found.of_stars(), found.model.chosen
        # Windows are centred on the light, which aberrations displace: correct the positions of stars.
        moved = own[:, :2].mean(axis=-1) / self.stars.one.tilt_of_pixel
        self.places = self.places.copy()
        self.places[chosen] += moved[:, ::-1] * self.part
        if self.stars.widths == 2:
            found = self.best_shape(found)
            own = found.of_stars()
        last = self.refined(chosen, found.polynomials(), found.squares(), 20, (0.9, 0.05), own, fast=False)
        return last or found, np.setdiff1d(every, chosen)

    @property
    def one_focus(self) -> bool:
        """Whether all exposures have the same defocus, such that signs of even terms are ambiguous."""
        one = self.stars.one
        return bool(np.ptp(one.base * one.even, axis=0).max() == 0.0)

    def lowest(self, found: Solution) -> Solution:
        """Repeat a fit from starts with other signs of even terms; return the most likely fit.

        With a single focus there are several minima, which differ in the signs of even terms.
        """
        self.rival = None
        if not self.one_focus or self.stars.cornered:
            return found
        for _ in range(2):
            ends = self._search_negated(found)
            best = min([found, *ends], key=lambda each: float(each.scores.deviance[0]))
            if best.scores.deviance[0] > found.scores.deviance[0] - _MIN_GAIN:
                break
            found = self._continue(best, _RIVAL_STEPS) or best
        for end in ends:
            if self._rival(found, end) and (settled := self._continue(end, _RIVAL_STEPS)) is not None:
                if settled.scores.deviance[0] < found.scores.deviance[0]:
                    found, settled = settled, found
                self.rival = self._rival(found, settled) or self.rival
        return found

    def _search_negated(self, found: Solution) -> list[Solution]:
        """Return a list with the best result (if any) of short searches that start at other signs of even terms."""
        one, polynomials, chosen = self.stars.one, found.polynomials(), found.model.chosen
        waves = found.model.basis @ polynomials.T
        size = np.sqrt((waves**2).mean(axis=0) * np.diag(self.metric))
        even = np.flatnonzero((np.abs(one.directions) @ ~one.even == 0.0) & (size > _MIN_NEGATED))
        even = even[np.argsort(-size[even], kind="stable")]
        starts = []
        if one.sign_ambiguous:
            # The image of a star does not change if the whole even part of its wavefront is negated. For each even
            # term, negate the even parts of some stars, such that the term has one sign all over the field.
            other = self.negated(chosen, waves)
            for j in even:
                below = waves[:, j] < 0.0
                if below.any() and not below.all():
                    through = np.where(below[:, None], other, waves)
                    starts.append(robust(found.model.basis, through, np.ones(len(chosen)), self.metric)[0])
        for j in even[: len(even) - (len(even) < 3)]:  # with two even terms, negating either yields the same images
            starts.append(polynomials.copy())
            starts[-1][j] *= -1.0
        ends = [self._continue(found, _TRIAL_STEPS, each) for each in starts[:_MAX_NEGATED]]
        near = [
            each
            for each in filter(None, ends)
            if abs(each.scores.deviance[0] - found.scores.deviance[0]) > _MIN_GAIN or self._rival(found, each)
        ]
        nearest = sorted(near, key=lambda each: float(each.scores.deviance[0]))[:1]
        return [self._continue(each, _BEST_STEPS) or each for each in nearest]

    def _continue(self, found: Solution, most: int, polynomials: Array | None = None) -> Solution | None:
        """Continue a fit by `most` steps, from `polynomials` if given; return None if images cannot be computed."""
        starts = found.polynomials() if polynomials is None else polynomials
        return self.refined(found.model.chosen, starts, found.squares(), most, (0.87, 0.0), found.of_stars())

    def _rival(self, best: Solution, other: Solution) -> Rival | None:
        """Return a Rival if the fit `other` is nearly as likely as `best` but distant from it; None otherwise."""
        cost = float(other.scores.deviance[0] - best.scores.deviance[0])
        one, k = self.stars.one, best.model.waves * best.model.basis.shape[1]
        errors = np.sqrt(np.diag(best.model.covariance(best.scores))[:k]).reshape(best.model.waves, -1)
        ends = [other.polynomials()]
        # The twin (all even parts negated) has the same images: use the smaller distance of `other` and its twin.
        if one.sign_ambiguous:
            ends.append(self.twin(ends[0])[0])
        sigmas = min(float((np.abs(end - best.polynomials()) / errors).max()) for end in ends)
        return Rival(cost, sigmas) if cost < _MAX_RIVAL_COST and sigmas > _MIN_RIVAL_DISTANCE else None

    def twin(self, polynomials: Array) -> tuple[Array, Array]:
        """Return polynomials (k, m) with all even parts negated, and the matrix (k, k) that negates them."""
        one = self.stars.one
        # The matrix 1 - flip negates the even part: flip is twice the projection onto the even part.
        flip = 2.0 * ((one.directions * one.even) @ one.inverse).T
        other = polynomials - flip @ polynomials
        other[:, 0] -= 2.0 * ((one.base[0] * one.even) @ one.inverse)
        return other, np.eye(len(flip)) - flip

    def best_shape(self, found: Solution) -> Solution:
        """Return the fit with the most likely shape of blur; a single width is preferred to two of similar lnL."""
        own, polynomials, squares = found.of_stars(), found.polynomials(), found.squares()

        def fit_shape(shape: Shape, widths: Array, most: int) -> Solution:
            self.stars = self.first.shaped(shape)
            refit = self.refined(found.model.chosen, polynomials, widths, most, (0.88, 0.01), own)
            return refit or replace(found, scores=found.scores._replace(deviance=np.full(1, np.inf)))

        both = fit_shape(Shape.turbulent(), squares, _SHAPE_STEPS)
        cost: dict[float | None, float] = {None: float(both.scores.deviance[0])}
        gaussian = fit_shape(Shape.gaussian(), squares.sum(axis=-1, keepdims=True), _SHAPE_STEPS)
        self.shapes = {"Gaussian": float(gaussian.scores.deviance[0])}
        outer: float | None = None
        best = both
        if self.shapes["Gaussian"] > cost[None] + _OUTER_GAIN:
            polynomials, own, squares = both.polynomials(), both.of_stars(), both.squares()
            for other in OUTER[1:]:
                tried = fit_shape(Shape.turbulent(other), squares, 2)
                cost[other] = float(tried.scores.deviance[0])
                if cost[other] < cost[outer] - _MIN_GAIN:
                    best, outer = tried, other
                else:
                    break
        alone = fit_shape(
            Shape.turbulent(outer, alone=True), best.squares().sum(axis=-1, keepdims=True), _SHAPE_STEPS
        )
        self.shapes |= {"seeing": float(alone.scores.deviance[0]), "both": cost[outer]}
        least = cost[outer] + _MIN_WIDTH_GAIN
        single = [each for each, name in ((gaussian, "Gaussian"), (alone, "seeing")) if self.shapes[name] < least]
        sharp = float(gaussian.squares().max()) < _NARROW
        if len(single) == 1 or (single and sharp):
            best = single[0]
        self.stars = best.model.of
        return best

    def regained(self, found: Solution) -> Solution:
        """Return a fit that includes rejected stars, if other polynomials fit them too; else the unchanged fit."""
        # A rejected star that fits individually is no double star: the polynomials are wrong at its position.
        every = np.arange(self.stars.count)
        for _ in range(_ROUNDS):
            rejected = np.setdiff1d(every, found.model.chosen)
            if (
                not rejected.size or self.stars.cornered
            ):  # the image of a single corner does not determine a wavefront
                break
            fits, waves = self._fit_individually(rejected, found)
            here = found.model.basis @ found.polynomials().T
            refit = self._refit_with(found, here, rejected[fits], waves[fits]) if fits.any() else None
            more = rejected[fits | ~np.isin(rejected, self.misfits)]
            if refit is None and more.size:
                refit = self._refit_with(found, here, more, self.basis(more) @ found.polynomials().T)
            if refit is None:
                break
            found = refit
        return found

    def _refit_with(self, found: Solution, waves: Array, more: NDArray[np.intp], others: Array) -> Solution | None:
        """Fit used stars from `waves` and the stars `more` from `others`; None unless more stars fit than before."""
        every = np.concatenate([found.model.chosen, more])
        wavefronts = np.concatenate([waves, others])
        polynomials, _ = robust(self.basis(every), wavefronts, np.ones(len(every)), self.metric)
        refit = self.refined(np.sort(every), polynomials, found.squares(), 20, (0.87, 0.02))
        if refit is None:
            return None
        refit = self.cleaned(refit, (0.89, 0.01))
        most = max(1.0 + _EXCESS_RATIO * (float(found.scores.chi2[0]) - 1.0), self._limit(refit))
        better = len(refit.model.chosen) > len(found.model.chosen) and refit.scores.chi2[0] <= most
        return refit if better else None

    def _fit_individually(self, rejected: NDArray[np.intp], found: Solution) -> tuple[NDArray[np.bool_], Array]:
        """Fit rejected stars individually; return a mask of stars that fit, and all wavefronts (r, k)."""
        stars, squares = self.stars, found.squares()
        model = self.basis(rejected) @ found.polynomials().T
        fits, waves, alone = (
            np.zeros(len(rejected), dtype=bool),
            model.copy(),
            SingleStars(stars, rejected, self.widest),
        )
        with suppress(Declined, ToleranceError):
            own = self.placed(rejected, found.polynomials(), squares)
            x, scores, *_ = search_rows(alone, alone.row(model, squares, own), _STEPS, _no_progress, fast=True)
            fits, waves = scores.chi2 < goodness_of_fit.most(scores.spread, SURE), alone.wavefronts(x)
        retried = ~fits & ~np.isin(rejected, self.misfits)
        if retried.any():
            x, chi2, sure = self.singles(rejected[retried], (0.87, 0.0))
            other = alone.wavefronts(x)
            if stars.one.sign_ambiguous:
                negated, near = self.negated(rejected[retried], other), model[retried]
                distances = [np.einsum("ni,ij,nj->n", w - near, self.metric, w - near) for w in (other, negated)]
                other = np.where((distances[1] < distances[0])[:, None], negated, other)
            fit = sure & (chi2 < 1.0 + 2.0 * (self._limit(found) - 1.0))
            self.misfits = np.union1d(self.misfits, rejected[retried][~fit])
            waves[retried], fits[retried] = other, fit
        return fits, waves

    @staticmethod
    def _limit(found: Solution) -> float:
        return float(goodness_of_fit.most(found.scores.spread[0], SURE))

    def outcome(self, found: Solution) -> Outcome:
        """Fit and test all stars, starting at a fit of some stars."""
        places = self.places
        found, rejected = self.whole(found)
        if slopes := slope_findings(found.model, found.x):
            self.places = places
            found, rejected = self.whole(self._with_slopes(found))
        tests, marginal, untested = missing_tests(found.model, found.x, self.places, self.degree)
        chosen, own = found.model.chosen, found.of_stars()
        psf = self.stars.images(chosen, *found.model.parts(found.x), fast=False, slopes="none")[0]
        unknown = found.model.shared + len(chosen) * self.stars.own * self.stars.exposures
        bright, held_out = self.stars.bright(chosen, psf, own, float(unknown)), self.held_out(found)
        tested = self.shapes, [*slopes, *untested], tests, marginal, self.rival
        return Outcome(found, rejected, held_out, bright, self.places, *tested)

    def _with_slopes(self, found: Solution) -> Solution:
        """Return the fit with a model that has a slope of each background, initially 0."""
        self.first, self.stars = self.first.on_slopes(), found.model.of.on_slopes()
        self.rough = self.rough.on_slopes()  # another search may follow, which starts with individual stars
        model, own = self.model(found.model.chosen), np.pad(found.of_stars(), ((0, 0), (0, 2), (0, 0)))
        return replace(found, model=model, x=model.row(found.polynomials(), found.squares(), own))

    def held_out(self, found: Solution) -> tuple[float, float]:
        """Return chi2 of a fifth of the stars with wavefronts predicted by the others, and its standard deviation."""
        chosen = found.model.chosen
        # Every fifth star in the order along an oblique direction: a reproducible choice all over the field.
        order = np.argsort(self.places[chosen] @ [1.0, 0.318], kind="stable")
        out = np.zeros(len(chosen), dtype=bool)
        out[order[2::5]] = True
        if (~out).sum() <= found.model.basis.shape[1] or not out.any():
            return math.nan, math.nan
        own = found.of_stars()
        rest = self.refined(chosen[~out], found.polynomials(), found.squares(), 6, (0.95, 0.03), own[~out])
        if rest is None:
            return math.nan, math.nan
        model = self.model(chosen[out], held=True)
        x = model.row(rest.polynomials(), rest.squares(), own[out])
        _, scores, *_ = search_rows(model, x, 6, _no_progress, fast=True)
        return float(scores.chi2[0]), float(scores.spread[0])


def _no_progress(step: int, chi2: float) -> None:
    """Report no progress, for short searches."""


def outliers(each: Quality) -> NDArray[np.bool_]:
    """Return a mask of stars whose chi2 is too large compared with the other stars."""
    median = float(np.median(each.chi2))
    # A slightly wrong model increases the scatter of chi2: use the larger of expected and robust standard deviation.
    spread = np.maximum(each.spread, 1.4826 * float(np.median(np.abs(each.chi2 - median))))
    return np.asarray(each.chi2 > median + _OUTLIER * spread)
