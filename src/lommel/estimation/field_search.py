"""The search for a field map: fits of single stars, signs of even terms, polynomials, rejection of outlying stars."""

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
_MIN_STARTS = 3  # starts after which stars with a large chi2 are given up, if most stars are sure
_STEPS = 14  # steps of each start
_SCATTER = 0.7, 0.25  # standard deviation (radians rms) of random starts: first three terms, other terms
_START_BLUR = 0.5  # width of the blur at the start, pixels
_MAX_BLUR = 0.15  # largest width of the blur of individual stars, as a fraction of a window's side
_SINGLE_TERMS = 3  # number of terms of the blur model for individual stars
_SHAPE_STEPS = 6  # steps of a fit with another shape of blur
_OUTER_GAIN = 5.0  # log-likelihood gain of seeing over a Gaussian, above which the outer scale is searched
_BETTER, _AS_LIKELY = 1.0, 2.0  # least log-likelihood gain of another minimum or outer scale; of one more width
_NARROW = 0.06  # squared width of blur, pixels^2, below which its shape does not matter
_SHIFTS = {(2, 0): (-2.0, -1.0, 0.0, 1.0, 2.0), (4, 0): (-1.2, 0.0, 1.2)}  # trial offsets of a term, radians rms
_FEW, _SCANNED = 20, 2  # number of stars that rank the trial offsets, and number of best offsets that are fitted
_GOOD = 1.08  # median chi2 of stars at which a candidate is accepted
_ALIKE = 0.02  # fraction of chi2 - 1: two starts of a star that end within it are at the same minimum
_SURELY = 0.75  # fraction of stars with a sure chi2, needed to compare the chi2 of a candidate with them
_FOLLOWS = 1.5  # largest chi2 of a star that follows the field, in units of the median chi2 of individual stars
_ENOUGH = 1.1  # chi2 - 1 of an acceptable fit, in units of chi2 - 1 of the fit that it is compared with
_OUTLIER = 5.0  # chi2 of an outlying star above the median, standard deviations
_ROUNDS = 4  # rounds of rejection
_MOST_LOST = 0.4  # largest fraction of rejected stars
_MANY_LOST = 0.25  # fraction of rejected stars above which the map is doubted
_HELD_OUT = 0.05  # largest chi2 - 1 of held-out stars, apart from noise
_QUIET = 0.9  # chi2 below which the noise cannot be as stated
_NEGATED = 0.05  # size (radians rms) of an even term, above which a search with its sign negated is run
_MAX_NEGATED = 3  # largest number of searches with a negated sign
_GLANCE, _LOOK, _MORE = 2, 5, 12  # steps of these searches: of each, of the best, of one at another minimum
_AS_WELL, _ELSEWHERE = 8.0, 3.0  # largest log-likelihood and smallest distance (standard errors) of a rival minimum
_CAUSES = "pupil, pixel, noise, defocus or blur are wrong, the degree is too low, or terms are missing"

Report = Callable[[float, float], object]


@dataclass
class Found:
    """A fit of a field: the model of the stars that are used, its parameters and their quality."""

    model: WholeField
    x: Array
    scores: Scores
    settled: bool

    def of_stars(self) -> Array:
        """Return the parameters of each star image: tilts, flux, background and angles, shape (r, own, e)."""
        return self.model.parts(self.x)[2].copy()

    def polynomials(self) -> Array:
        """Return the coefficients of the polynomials, shape (k, m): k wavefront terms, m monomials."""
        return self.model.polynomials(self.x).copy()

    def squares(self) -> Array:
        """Return the squared widths of the blur, shape (e, b): e exposures, b widths."""
        return np.array(self.model.squares(self.x)[0])


class Rival(NamedTuple):
    """Another minimum that fits nearly as well as the best one."""

    cost: float  # log-likelihood of the best minimum minus that of this one
    sigmas: float  # distance between the two minima, standard errors


@dataclass
class Outcome:
    """A fit of all stars, with rejected stars, tests, and the positions of stars in the field."""

    found: Found
    lost: NDArray[np.intp]  # indices of the rejected stars
    held_out: tuple[float, float]  # chi2 of held-out stars, and its standard deviation
    bright: tuple[float, float]  # chi2 of pixels in which stars exceed the noise, and its standard deviation
    places: Array  # positions of the stars, half fields
    shapes: dict[str, float]  # negative log-likelihood of each shape of blur that was compared
    notes: list[Finding]  # on sloping backgrounds and on given values that are not tested
    tests: tuple[ScoreTest, ...]  # score tests of terms that the model lacks
    marginal: Marginal
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
            text = f"chi2 {bright:.4g} {where}, noise alone stays below {limit:.4g}{causes}"
            found = [Finding("misfit", "error", text, {"bright_chi2": bright, "limit": limit})]
        held, off = self.held_out
        if held - 1.0 > (limit := _HELD_OUT + 4.0 * off):
            text = f"stars that were left out do not follow the map{causes}"
            found.append(Finding("held_out", "error", text, {"held_out": held, "limit": 1.0 + limit}))
        count = len(self.lost) + len(self.found.model.chosen)
        if len(self.lost) > _MANY_LOST * count:
            text = f"many stars do not follow the map{causes}"
            found.append(Finding("many_rejected", "error", text, {"rejected": len(self.lost), "of": count}))
        if self.rival is not None:
            text = (
                f"another wavefront, {self.rival.sigmas:.0f} standard errors away, fits as well (lnL "
                f"{-self.rival.cost:+.1f}): add exposures at other defoci, or give start"
            )
            found.append(Finding("another_minimum", "doubt", text, self.rival._asdict()))
        quiet = [replace(each, severity="error") for each in found if each.code == "too_quiet" and chi2 < _QUIET]
        # Above _QUIET, a low chi2 is often due to chance with few electrons, and is not reported.
        return Findings([*quiet, *(each for each in found if each.code != "too_quiet"), *self.notes])

    @property
    def cost(self) -> float:
        """Sum over stars of the excess of chi2 in standard deviations, each limited to the value of an outlier."""
        each = self.found.model.each(self.found.x)
        # Capped for each star, so that one double star does not decide between two fits.
        off = np.clip((each.chi2 - 1.0) / each.spread, 0.0, _OUTLIER)
        return float(off.sum()) + _OUTLIER * len(self.lost)


class Search:
    """The stages of a search, for stars at `places` (n, 2), and pixels of the size `part` (2,), in half fields."""

    def __init__(
        self, stars: FieldStars, places: Array, part: Array, degree: int, draw: np.random.Generator, report: Report
    ) -> None:
        self.stars, self.places, self.degree, self.draw, self.report = stars, places, degree, draw, report
        self.first = stars
        self.shapes: dict[str, float] = {}
        self.rival: Rival | None = None
        #: Stars that no wavefront fits, such as doubles and defects; they are not fitted individually a second time.
        self.unlike = np.zeros(0, dtype=np.intp)
        self.part = part
        #: The stars with a coarser model of the blur, for fits of individual stars.
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
        """Return the model of the chosen stars; `held` fixes its polynomials and blur."""
        return WholeField(self.stars, chosen, self.basis(chosen), held=held)

    def brightest(self) -> NDArray[np.intp]:
        """Return the indices of the brightest stars, which are fitted individually."""
        counted, _, _, valid = self.stars.star
        level = np.median(counted, axis=-1, keepdims=True)
        bright = (valid * (counted - level)).sum(axis=(1, 2))
        return np.sort(np.argsort(-bright, kind="stable")[:_MAX_SINGLES])

    def singles(
        self, chosen: NDArray[np.intp], share: tuple[float, float] = (0.0, 0.4)
    ) -> tuple[Array, Array, NDArray[np.bool_]]:
        """Return the best parameters (n, p) of individually fitted stars, their chi2, and which of them are sure.

        A star is sure if it fits, or if two starts ended at the same chi2: further starts would not improve it.
        """
        stars = self.stars
        best, chi2 = np.zeros((len(chosen), stars.size)), np.full(len(chosen), np.inf)
        sure = np.zeros(len(chosen), dtype=bool)
        open_ = np.arange(len(chosen))
        for turn in range(_MAX_STARTS):
            model = SingleStars(self.rough, chosen[open_], self.widest)
            x = self._random(model, scatter=turn > 0 or stars.one.sign_ambiguous)

            def report(step: int, value: float, turn: int = turn) -> None:
                self.report(share[0] + share[1] * (turn + step / _STEPS) / _MAX_STARTS, value)

            with suppress(Declined, ToleranceError):
                x, scores, *_ = search_rows(model, x, _STEPS, report, fast=True)
                before = chi2[open_]
                better = scores.chi2 < before
                best[open_[better]], chi2[open_[better]] = x[better], scores.chi2[better]
                fits = scores.chi2 < np.maximum(goodness_of_fit.most(scores.spread, SURE), 1.02)
                alike = np.abs(scores.chi2 - before) < _ALIKE * np.maximum(chi2[open_] - 1.0, 0.0)
                sure[open_[fits | alike]] = True
                open_ = open_[~(fits | alike)]
            if turn + 1 >= _MIN_STARTS and sure.mean() >= _SURELY:  # stars with a large chi2 are doubles or defects
                open_ = open_[chi2[open_] <= _FOLLOWS * np.median(chi2)]
            if open_.size == 0:
                break
        return best, chi2, sure

    def _random(self, model: SingleStars, *, scatter: bool) -> Array:
        stars = self.stars
        names = stars.one.unknowns.terms
        size = np.full(len(names), _SCATTER[1])
        size[: min(3, len(names))] = _SCATTER[0]
        waves = stars.start[model.chosen].copy()
        if scatter:
            waves += self.draw.normal(size=waves.shape) * size
        return model.row(waves, self.squares, self._centred(model.chosen, waves))

    def _centred(self, rows: NDArray[np.intp], waves: Array) -> Array:
        """Return tilts, flux, background and angles of stars, at which the images have the observed centroids."""
        one = self.stars.one
        edge = self.stars.base[rows] + (waves @ one.directions)[:, None]
        # The mean slope of a wavefront moves the centroid, so that it is subtracted from the observed centroid.
        return self.stars.begun(rows, self._centroids[rows] - one.mean_slopes(edge).swapaxes(0, 1))

    @cached_property
    def _centroids(self) -> Array:
        return self.stars.centroids()

    def from_start(self) -> Found | None:
        """Return the fit of the brightest stars from the given wavefronts; None if no such fit is good enough."""
        chosen = self.brightest()
        polynomials, _ = robust(self.basis(chosen), self.stars.start[chosen], np.ones(len(chosen)), self.metric)
        squares, few = self.squares, chosen[:: max(1, len(chosen) // _FEW)]
        begun = itertools.chain([polynomials], self._shifted(few, polynomials, squares))
        for turn, tried in enumerate(begun):
            found = self.refined(chosen, tried, squares, 10, (0.15 * turn, 0.15))
            if found is not None and np.median(found.model.each(found.x, fast=True).chi2) <= _GOOD:
                return found
        return None

    def _shifted(self, chosen: NDArray[np.intp], polynomials: Array, squares: Array) -> Iterator[Array]:
        """Yield polynomials with defocus and spherical aberration added to the whole field, the best fits first."""
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
        yield from (tried for _, tried in sorted(found, key=lambda each: each[0])[:_SCANNED])

    def from_singles(self) -> Found:
        """Return the fit of the brightest stars, started from fits of the individual stars."""
        stars = self.stars
        chosen = self.brightest()
        x, chi2, sure = self.singles(chosen)
        if not np.isfinite(chi2).any():
            raise ToleranceError("no star could be fitted: the images of all starts are beyond what can be computed")
        usable = np.isfinite(chi2)
        # Polynomials cannot fit better than individual wavefronts, so that a fit as good as these ends the search.
        floor = _ENOUGH * (float(np.median(chi2[usable])) - 1.0) if sure.mean() >= _SURELY else 0.0
        enough = max(_GOOD, 1.0 + floor)
        # Stars with a poor individual fit would distort the polynomials; `whole` includes them again if they fit.
        alike = usable & (chi2 <= _FOLLOWS * np.median(chi2[usable]))
        self.unlike = chosen[usable & ~alike]
        if alike.sum() >= max(_SURELY * usable.sum(), 4):
            usable = alike
        chosen, x, chi2 = chosen[usable], x[usable], chi2[usable]
        # Stars that fit badly weigh less.
        quality = 1.0 / np.maximum(chi2 / max(float(np.median(chi2)), 1e-9), 1.0) ** 2
        waves, squares, _ = SingleStars(stars, chosen, self.widest).parts(x)
        good = chi2 <= _FOLLOWS * np.median(chi2)
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
        best: Found | None = None
        lowest = np.inf
        for k, (polynomials, _) in enumerate(tried):
            found = self.refined(chosen, polynomials, square, 8, (0.4 + 0.05 * min(k, 5), 0.05))
            if found is None:
                continue
            median = float(np.median(found.model.each(found.x, fast=True).chi2))
            if median < lowest:
                best, lowest = found, median
            if median < enough:
                break
        if best is None:
            raise ToleranceError(
                "no field could be fitted: the wavefronts of all starts are beyond what can be computed"
            )
        return best

    def negated(self, chosen: NDArray[np.intp], waves: Array) -> Array:
        """Return wavefronts with the even part of the phase negated."""
        return self.stars.one.negated(waves, self.stars.base[chosen, 0])

    def refined(
        self,
        chosen: NDArray[np.intp],
        polynomials: Array,
        squares: Array,
        most: int,
        share: tuple[float, float],
        own: Array | None = None,
        *,
        fast: bool = True,
    ) -> Found | None:
        """Return the fit of stars started from polynomials (k, m); None if they are too strong to compute."""
        m = (self.degree + 1) * (self.degree + 2) // 2
        start = np.zeros((len(polynomials), m))
        start[:, : polynomials.shape[1]] = polynomials[:, :m]
        model = self.model(chosen)
        try:
            x = model.row(start, squares, self.placed(chosen, start, squares) if own is None else own)

            def report(step: int, value: float) -> None:
                self.report(share[0] + share[1] * step / (most + 1), value)

            x, scores, settled, _ = search_rows(model, x, most, report, fast=fast)
        except (Declined, ToleranceError):
            return None
        return Found(model, x, scores, bool(settled[0]))

    def placed(self, chosen: NDArray[np.intp], polynomials: Array, squares: Array) -> Array:
        """Return tilts, flux, background and angles (r, own, e) of stars, fitted with fixed wavefronts and blur."""
        model = self.model(chosen, held=True)
        own = self._centred(chosen, model.basis @ polynomials.T)
        if not self.stars.cornered:  # positions of corners are known to a pixel
            psf = model.images(model.row(polynomials, squares, own), fast=True)[0]
            own[:, :2] += self.stars.shifts(chosen, psf) * self.stars.one.tilt_of_pixel
        x, *_ = search_rows(model, model.row(polynomials, squares, own), 6, _silent, fast=True)
        return model.parts(x)[2]

    def cleaned(self, found: Found, share: tuple[float, float]) -> Found:
        """Return the fit after rejection of outlying stars, in several rounds."""
        first = len(found.model.chosen)
        for _ in range(_ROUNDS):
            good = ~outliers(found.model.each(found.x, fast=True))
            left = int(good.sum())
            if good.all() or left < (1.0 - _MOST_LOST) * first or left <= found.model.basis.shape[1]:
                break
            chosen, own = found.model.chosen[good], found.of_stars()[good]
            again = self.refined(chosen, found.polynomials(), found.squares(), 10, share, own)
            if again is None:
                break
            found = again
        return found

    def whole(self, found: Found) -> tuple[Found, NDArray[np.intp]]:
        """Return the fit of all stars but outliers, started from a fit of some, and the indices of the outliers."""
        every = np.arange(self.stars.count)
        polynomials, squares = found.polynomials(), found.squares()
        others = np.setdiff1d(every, found.model.chosen)
        bad = np.zeros(len(every), dtype=bool)
        wide: Found | None = None
        if len(others):
            own = np.empty((len(every), self.stars.own, self.stars.exposures))
            own[found.model.chosen], own[others] = found.of_stars(), self.placed(others, polynomials, squares)
            held = self.model(every, held=True)
            bad = outliers(held.each(held.row(polynomials, squares, own), fast=True))
            if bad.mean() > _MOST_LOST or (~bad).sum() <= held.basis.shape[1]:
                bad[:] = False
            if not np.array_equal(every[~bad], found.model.chosen):
                wide = self.refined(every[~bad], polynomials, squares, 10, (0.7, 0.15), own[~bad])
        found = self.regained(self.lowest(self.cleaned(wide or found, (0.85, 0.02))))
        own, chosen = found.of_stars(), found.model.chosen
        # Windows are centred on the light, which aberrations displace; polynomials need the positions without it.
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
        """Whether all exposures have the same focus, so that the signs of even terms are ambiguous."""
        one = self.stars.one
        return bool(np.ptp(one.base * one.even, axis=0).max() == 0.0)

    def lowest(self, found: Found) -> Found:
        """Return the best of a fit and of fits that start from it with other signs of even terms.

        With a single focus there are several minima, which differ in the signs of even terms in part of the field.
        """
        self.rival = None
        if not self.one_focus or self.stars.cornered:
            return found
        for _ in range(2):
            ends = self._negating(found)
            best = min([found, *ends], key=lambda each: float(each.scores.deviance[0]))
            if best.scores.deviance[0] > found.scores.deviance[0] - _BETTER:
                break
            found = self._on(best, _MORE) or best
        for end in ends:
            if self._rival(found, end) and (settled := self._on(end, _MORE)) is not None:
                if settled.scores.deviance[0] < found.scores.deviance[0]:
                    found, settled = settled, found
                self.rival = self._rival(found, settled) or self.rival
        return found

    def _negating(self, found: Found) -> list[Found]:
        """Return the best result of short searches that start from a fit with other signs of even terms."""
        one, polynomials, chosen = self.stars.one, found.polynomials(), found.model.chosen
        waves = found.model.basis @ polynomials.T
        size = np.sqrt((waves**2).mean(axis=0) * np.diag(self.metric))
        even = np.flatnonzero((np.abs(one.directions) @ ~one.even == 0.0) & (size > _NEGATED))
        even = even[np.argsort(-size[even], kind="stable")]
        begun = []
        if one.sign_ambiguous:
            # Negating the whole even part of a star's wavefront leaves its image unchanged. Stars are negated so that
            # one term has the same sign all over the field: another field with the same images.
            other = self.negated(chosen, waves)
            for j in even:
                below = waves[:, j] < 0.0
                if below.any() and not below.all():
                    through = np.where(below[:, None], other, waves)
                    begun.append(robust(found.model.basis, through, np.ones(len(chosen)), self.metric)[0])
        for j in even[: len(even) - (len(even) < 3)]:  # with two terms, negating one or the other gives twins
            begun.append(polynomials.copy())
            begun[-1][j] *= -1.0
        ends = [self._on(found, _GLANCE, each) for each in begun[:_MAX_NEGATED]]
        near = [
            each
            for each in filter(None, ends)
            if abs(each.scores.deviance[0] - found.scores.deviance[0]) > _BETTER or self._rival(found, each)
        ]
        nearest = sorted(near, key=lambda each: float(each.scores.deviance[0]))[:1]
        return [self._on(each, _LOOK) or each for each in nearest]

    def _on(self, found: Found, most: int, polynomials: Array | None = None) -> Found | None:
        """Return a fit continued by `most` steps, from its own or from other polynomials; None if it fails."""
        begun = found.polynomials() if polynomials is None else polynomials
        return self.refined(found.model.chosen, begun, found.squares(), most, (0.87, 0.0), found.of_stars())

    def _rival(self, best: Found, other: Found) -> Rival | None:
        """Return another fit as a rival of the best; None if it is the same minimum, or clearly worse."""
        cost = float(other.scores.deviance[0] - best.scores.deviance[0])
        one, k = self.stars.one, best.model.waves * best.model.basis.shape[1]
        errors = np.sqrt(np.diag(best.model.covariance(best.scores))[:k]).reshape(best.model.waves, -1)
        ends = [other.polynomials()]
        # The twin has the same images, so that the smaller of the two distances counts.
        if one.sign_ambiguous:
            ends.append(self.twin(ends[0])[0])
        sigmas = min(float((np.abs(end - best.polynomials()) / errors).max()) for end in ends)
        return Rival(cost, sigmas) if cost < _AS_WELL and sigmas > _ELSEWHERE else None

    def twin(self, polynomials: Array) -> tuple[Array, Array]:
        """Return polynomials (k, m) with all even parts negated, and the matrix (k, k) that negates them."""
        one = self.stars.one
        # 1 - 2 P, P the projection on the even part.
        flip = 2.0 * ((one.directions * one.even) @ one.inverse).T
        other = polynomials - flip @ polynomials
        other[:, 0] -= 2.0 * ((one.base[0] * one.even) @ one.inverse)
        return other, np.eye(len(flip)) - flip

    def best_shape(self, found: Found) -> Found:
        """Return the fit with the likeliest shape of blur; of equally likely shapes, that with fewest unknowns."""
        own, polynomials, squares = found.of_stars(), found.polynomials(), found.squares()

        def behind(shape: Shape, widths: Array, most: int) -> Found:
            self.stars = self.first.shaped(shape)
            again = self.refined(found.model.chosen, polynomials, widths, most, (0.88, 0.01), own)
            return again or replace(found, scores=found.scores._replace(deviance=np.full(1, np.inf)))

        both = behind(Shape.turbulent(), squares, _SHAPE_STEPS)
        cost: dict[float | None, float] = {None: float(both.scores.deviance[0])}
        gaussian = behind(Shape.gaussian(), squares.sum(axis=-1, keepdims=True), _SHAPE_STEPS)
        self.shapes = {"Gaussian": float(gaussian.scores.deviance[0])}
        outer: float | None = None
        best = both
        if self.shapes["Gaussian"] > cost[None] + _OUTER_GAIN:
            polynomials, own, squares = both.polynomials(), both.of_stars(), both.squares()
            for other in OUTER[1:]:
                tried = behind(Shape.turbulent(other), squares, 2)
                cost[other] = float(tried.scores.deviance[0])
                if cost[other] < cost[outer] - _BETTER:
                    best, outer = tried, other
                else:
                    break
        alone = behind(Shape.turbulent(outer, alone=True), best.squares().sum(axis=-1, keepdims=True), _SHAPE_STEPS)
        self.shapes |= {"seeing": float(alone.scores.deviance[0]), "both": cost[outer]}
        least = cost[outer] + _AS_LIKELY
        single = [each for each, name in ((gaussian, "Gaussian"), (alone, "seeing")) if self.shapes[name] < least]
        sharp = float(gaussian.squares().max()) < _NARROW
        if len(single) == 1 or (single and sharp):
            best = single[0]
        self.stars = best.model.of
        return best

    def regained(self, found: Found) -> Found:
        """Return the fit with rejected stars included again, if other polynomials fit them too."""
        # A star that fits individually is not a double: the polynomials are wrong at its position.
        every = np.arange(self.stars.count)
        for _ in range(_ROUNDS):
            lost = np.setdiff1d(every, found.model.chosen)
            if not lost.size or self.stars.cornered:  # a corner alone leaves its wavefront open
                break
            fits, waves = self._by_themselves(lost, found)
            here = found.model.basis @ found.polynomials().T
            again = self._through(found, here, lost[fits], waves[fits]) if fits.any() else None
            more = lost[fits | ~np.isin(lost, self.unlike)]
            if again is None and more.size:
                again = self._through(found, here, more, self.basis(more) @ found.polynomials().T)
            if again is None:
                break
            found = again
        return found

    def _through(self, found: Found, waves: Array, more: NDArray[np.intp], others: Array) -> Found | None:
        """Return the fit started from `waves` of its stars and `others` of more stars; None unless it keeps more."""
        every = np.concatenate([found.model.chosen, more])
        through = np.concatenate([waves, others])
        polynomials, _ = robust(self.basis(every), through, np.ones(len(every)), self.metric)
        again = self.refined(np.sort(every), polynomials, found.squares(), 20, (0.87, 0.02))
        if again is None:
            return None
        again = self.cleaned(again, (0.89, 0.01))
        most = max(1.0 + _ENOUGH * (float(found.scores.chi2[0]) - 1.0), self._limit(again))
        better = len(again.model.chosen) > len(found.model.chosen) and again.scores.chi2[0] <= most
        return again if better else None

    def _by_themselves(self, lost: NDArray[np.intp], found: Found) -> tuple[NDArray[np.bool_], Array]:
        """Return which stars fit individually, from wavefronts of the field or random ones, and wavefronts (r, k)."""
        stars, squares = self.stars, found.squares()
        model = self.basis(lost) @ found.polynomials().T
        fits, waves, alone = np.zeros(len(lost), dtype=bool), model.copy(), SingleStars(stars, lost, self.widest)
        with suppress(Declined, ToleranceError):
            own = self.placed(lost, found.polynomials(), squares)
            x, scores, *_ = search_rows(alone, alone.row(model, squares, own), _STEPS, _silent, fast=True)
            fits, waves = scores.chi2 < goodness_of_fit.most(scores.spread, SURE), alone.wavefronts(x)
        again = ~fits & ~np.isin(lost, self.unlike)
        if again.any():
            x, chi2, sure = self.singles(lost[again], (0.87, 0.0))
            other = alone.wavefronts(x)
            if stars.one.sign_ambiguous:
                turned, near = self.negated(lost[again], other), model[again]
                apart = [np.einsum("ni,ij,nj->n", w - near, self.metric, w - near) for w in (other, turned)]
                other = np.where((apart[1] < apart[0])[:, None], turned, other)
            fit = sure & (chi2 < 1.0 + 2.0 * (self._limit(found) - 1.0))
            self.unlike = np.union1d(self.unlike, lost[again][~fit])
            waves[again], fits[again] = other, fit
        return fits, waves

    @staticmethod
    def _limit(found: Found) -> float:
        return float(goodness_of_fit.most(found.scores.spread[0], SURE))

    def outcome(self, found: Found) -> Outcome:
        """Return the fit of all stars, started from a fit of some stars, with its tests."""
        places = self.places
        found, lost = self.whole(found)
        if slopes := slope_findings(found.model, found.x):
            self.places = places
            found, lost = self.whole(self._on_slopes(found))
        tests, marginal, untested = missing_tests(found.model, found.x, self.places, self.degree)
        chosen, own = found.model.chosen, found.of_stars()
        psf = self.stars.images(chosen, *found.model.parts(found.x), fast=False, slopes="none")[0]
        unknown = found.model.shared + len(chosen) * self.stars.own * self.stars.exposures
        bright, held_out = self.stars.bright(chosen, psf, own, float(unknown)), self.held_out(found)
        tested = self.shapes, [*slopes, *untested], tests, marginal, self.rival
        return Outcome(found, lost, held_out, bright, self.places, *tested)

    def _on_slopes(self, found: Found) -> Found:
        """Return a fit with the slope of each background free."""
        self.first, self.stars = self.first.on_slopes(), found.model.of.on_slopes()
        self.rough = self.rough.on_slopes()  # another search may begin with single stars
        model, own = self.model(found.model.chosen), np.pad(found.of_stars(), ((0, 0), (0, 2), (0, 0)))
        return replace(found, model=model, x=model.row(found.polynomials(), found.squares(), own))

    def held_out(self, found: Found) -> tuple[float, float]:
        """Return chi2 of a fifth of the stars, whose wavefronts are predicted by the others, and its deviation."""
        chosen = found.model.chosen
        # Sorted along one oblique direction and every fifth taken: spread over the field, without a random choice.
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
        _, scores, *_ = search_rows(model, x, 6, _silent, fast=True)
        return float(scores.chi2[0]), float(scores.spread[0])


def _silent(step: int, chi2: float) -> None:
    """Ignore the progress of a short search."""


def outliers(each: Quality) -> NDArray[np.bool_]:
    """Return which stars have too large a chi2 compared with the others."""
    middle = float(np.median(each.chi2))
    # With a model that is not quite right, chi2 scatters more than by noise: the larger of both widths counts.
    spread = np.maximum(each.spread, 1.4826 * float(np.median(np.abs(each.chi2 - middle))))
    return np.asarray(each.chi2 > middle + _OUTLIER * spread)
