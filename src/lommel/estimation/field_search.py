"""Search for a field map: fits of individual stars, signs of even terms, polynomials, rejection of outlying stars.

Positions are in half fields, -1 to 1 across the sensor. Arrays `waves` (r, k) are coefficients of the wavefronts of r
stars, radians rms. Arrays `nuisance` (r, o, e) are the o parameters of each image in e exposures: tilts, flux and
background, the angles of a corner, and slopes of the background if estimated. `squared_widths` are those of the blur,
pixels^2. lnL is the log-likelihood.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.blur.mixtures import OUTER, BlurProfile
from lommel.core.answers import Declined, ToleranceError
from lommel.estimation.favoured_effects import Estimate, Fit, Round, estimated_findings, rounds_of, unsure
from lommel.estimation.field_checks import missing_tests, slope_findings
from lommel.estimation.field_signs import candidates, highest_degree, monomials, robust
from lommel.estimation.field_stars import FieldStars, Quality, SingleStars, WholeField
from lommel.estimation.star_checks import DRIFTS, ELLIPSE, TRAIL, changed, unit_of, value_of
from lommel.estimation.star_images import label
from lommel.estimation.star_readout import lines_of
from lommel.fit.findings import Finding, Findings
from lommel.fit.goodness_of_fit import SURE, chi2_findings, largest_plausible_chi2, spot_findings
from lommel.fit.model_error import ModelError, part_missed, with_errors_of_model, with_noise
from lommel.fit.score_tests import Grade, ScoreTest, causes_of_misfit, seen
from lommel.fit.scoring import Progress, search_rows
from lommel.methods.derivative_names import term_of

_MAX_SINGLES = 60  # largest number of stars that are fitted individually
_MAX_STARTS = 5  # largest number of starts for each individual star
_MIN_STARTS = 3  # number of starts after which a star with a large chi2 is abandoned, if enough stars are sure
_STEPS = 14  # maximum number of scoring steps from each start
_SCATTER = 0.7, 0.25  # standard deviation (radians rms) of random starts: first three terms, other terms
_START_BLUR = 0.5  # width of the blur at the start, pixels
_MAX_BLUR = 0.15  # largest width of the blur of individual stars, as a fraction of a window's side
_SINGLE_TERMS = 3  # number of terms of the blur model for individual stars
_TINY = 1e-9  # smallest squared width of seeing of which r0 is computed, pixels^2
_PROFILE_STEPS = 6  # maximum number of steps of a fit with another profile of blur
_OUTER_GAIN = 5.0  # the outer scale is searched if lnL of seeing exceeds lnL of a Gaussian by this
_MIN_GAIN = 1.0  # lnL by which another minimum or outer scale must be better to be preferred
_MIN_WIDTH_GAIN = 2.0  # lnL by which a blur of two widths must be better than one of a single width
_NARROW = 0.06  # squared width of blur, pixels^2, below which its profile does not matter
_SHIFTS = {(2, 0): (-2.0, -1.0, 0.0, 1.0, 2.0), (4, 0): (-1.2, 0.0, 1.2)}  # trial offsets of a term, radians rms
_RANKING_STARS, _FITTED_SHIFTS = 20, 2  # number of stars whose chi2 ranks the offsets; number of best offsets fitted
_GOOD_CHI2 = 1.08  # largest median chi2 of stars at which a candidate is accepted
_LINEAR = 0.05  # part of the known C_d of a donut, radians, within which images are linear in phases, radians rms
_TRAIL_SHARE = (
    0.3  # least log Bayes factor of a trail, divided by that of the likeliest effect, to be estimated first
)
_LITTLE = 0.2  # part of the light that a fit from the only start may miss: less than at other minima (0.3 to 0.7)
_SAME_CHI2 = 0.02  # two fits of a star are at the same minimum if chi2 differs by less than this times (chi2 - 1)
_MIN_SURE = 0.75  # smallest fraction of sure stars (see `fit_single_stars`) at which their chi2 is a reference
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
# Measured part of the remaining time that each phase takes, and its typical number of steps; the fraction of the time
# that has passed when the first refit with another effect begins. Before, none is expected.
_PHASES = {
    "first": (0.13, 6), "single stars": (0.16, 15), "starts": (0.05, 15), "joint": (0.16, 11), "signs": (0.27, 15),
    "profiles": (0.36, 18), "refit": (0.13, 10), "end": (0.9, 7),
}  # fmt: skip
_BEFORE_REFITS = 0.37
_TOO_STRONG = "aberrations are too strong for the tolerance; pass a design as pupil"
_CAUSES = "pupil, pixel, noise, defocus or blur are wrong, {}or terms are missing"


@dataclass
class Solution(Fit[WholeField]):
    """A fit of a field: the model of the used stars, the parameters `x`, and the quality of the fit."""

    @cached_property
    def residual_parts(self) -> tuple[Array, Array, Array]:
        """Residual, variance and light of all pixels of the used stars."""
        stars, nuisance, values = self.model.stars, self.nuisance(), self.model.images(self.x)[0]
        counted, _, read, valid = stars.pixel_data[:, self.model.chosen].reshape(4, *values.shape)
        mean = stars.expected(values, nuisance).reshape(values.shape)
        residual, light = np.where(valid > 0.0, counted - mean, np.nan), nuisance[:, 2].reshape(-1, 1, 1) * values
        return residual, np.maximum(mean + read, 0.25 * read), light

    @property
    def linear_range(self) -> float:
        """Phase, radians rms, within which images are linear: a part of a large defocus, which moves rays little."""
        return max(super().linear_range, _LINEAR * float(np.abs(self.model.stars.defocus).min()))

    @cached_property
    def model_error(self) -> ModelError | None:
        """The model error of a single star."""
        return super().model_error if len(self.model.chosen) == 1 else None

    def nuisance(self) -> Array:
        """Return the nuisance parameters of the images of r stars in e exposures, shape (r, o, e)."""
        return self.model.parts(self.x)[2].copy()

    def polynomials(self) -> Array:
        """Return the coefficients of the polynomials, shape (k, m): k wavefront terms, m monomials."""
        return self.model.polynomials(self.x).copy()

    def squared_widths(self) -> Array:
        """Return the squared widths of the blur, shape (e, b): e exposures, b widths."""
        return np.array(self.model.squared_widths(self.x)[0])


class Rival(NamedTuple):
    """Another minimum that fits nearly as well as the best one."""

    cost: float  # lnL of the best minimum minus lnL of this minimum
    sigmas: float  # largest distance between coefficients of the two minima, standard errors


@dataclass
class Outcome:
    """A fit of all stars that were not rejected, with the results of its tests."""

    fit: Solution
    rejected: NDArray[np.intp]  # indices of the rejected stars
    held_out: tuple[float, float]  # chi2 of held-out stars, and its standard deviation
    bright_chi2: tuple[float, float]  # chi2 of pixels in which stars exceed the noise, and its standard deviation
    places: Array  # positions of the stars, half fields
    blur_costs: dict[str, float]  # -lnL of each profile of blur that was compared
    notes: list[Finding]  # findings on sloping backgrounds, and on input values that the images do not test
    tests: tuple[ScoreTest, ...]  # score tests of terms that the model lacks
    grade: Grade  # of significant effects; shift and covariance of the coefficients, marginalized over effects
    rival: Rival | None = None
    model_error: ModelError | None = None  # of a single star
    rounds: Sequence[Round] = ()  # refits with effects that the stars favour
    of_noise: Sequence[Finding] = ()  # finding on noise that is not the stated one

    @property
    def unexplained(self) -> bool:
        """Whether no effect explains half of a misfit, such that none is named."""
        (chi2, spread), known = self.fit.quality, seen(self.tests) and self.grade.explained
        is_misfit = chi2 >= largest_plausible_chi2(spread)
        return not known and bool(is_misfit and causes_of_misfit(_CAUSES, chi2, spread, self.tests))

    @property
    def findings(self) -> Findings:
        """Findings on the fit."""
        chi2, deviation = self.fit.quality
        degree = "the degree is too low, " if len(self.places) > 1 else ""
        causes = causes_of_misfit(_CAUSES.format(degree), chi2, deviation, self.tests)
        findings = chi2_findings(chi2, deviation, causes)
        bright_chi2, bright_deviation = self.bright_chi2
        if seen(self.tests) and self.grade.explained:
            findings = [finding for finding in findings if finding.code == "too_quiet"]
            bright_chi2 -= self.grade.marginal.gain * bright_deviation**2
        causes = causes and f"; {causes}"
        limit = float(largest_plausible_chi2(bright_deviation))
        if not findings and math.isfinite(bright_chi2) and bright_chi2 >= limit:
            pixels = "of the pixels in which stars exceed the noise"
            text = f"chi2 {bright_chi2:.4g} {pixels}, above {limit:.4g}, the limit for noise alone{causes}"
            findings = [Finding("misfit", "error", text, {"bright_chi2": bright_chi2, "limit": limit})]
        if len(self.fit.model.chosen) == 1:
            findings += spot_findings(findings, *self.fit.residual_parts)
        if self.model_error is not None:
            findings = with_errors_of_model(findings, *self.fit.residual_parts, causes.removeprefix("; "))
        held_out, held_out_deviation = self.held_out
        if held_out - 1.0 > (limit := _HELD_OUT + 4.0 * held_out_deviation):
            text = f"held-out stars do not follow the map that was fitted to the other stars{causes}"
            findings.append(Finding("held_out", "error", text, {"held_out": held_out, "limit": 1.0 + limit}))
        count = len(self.rejected) + len(self.fit.model.chosen)
        if len(self.rejected) > _MANY_REJECTED * count:
            text = f"many stars do not follow the map{causes}"
            findings.append(Finding("many_rejected", "error", text, {"rejected": len(self.rejected), "of": count}))
        if self.rival is not None:
            text = (
                f"another wavefront, {self.rival.sigmas:.0f} standard errors away, fits as well (lnL "
                f"{-self.rival.cost:+.1f}): add exposures at other defoci, or pass a design as pupil"
            )
            findings.append(Finding("another_minimum", "doubt", text, self.rival._asdict()))
        # Above _QUIET, a low chi2 is often due to chance with few electrons, and is not reported.
        quiet_findings = [replace(r, severity="error") for r in findings if r.code == "too_quiet" and chi2 < _QUIET]
        others = (finding for finding in findings if finding.code != "too_quiet")
        return Findings([*self.of_noise, *quiet_findings, *others, *self.notes])

    @property
    def cost(self) -> float:
        """Sum over stars of (chi2 - 1) / (standard deviation), from 0 to `_OUTLIER`; `_OUTLIER` if rejected."""
        qualities = self.fit.model.star_quality(self.fit.x)
        # The upper limit prevents a single double star from deciding between two fits.
        excesses = np.clip((qualities.chi2 - 1.0) / qualities.spread, 0.0, _OUTLIER)
        return float(excesses.sum()) + _OUTLIER * len(self.rejected)


class Search:
    """The stages of a search; `places` (n, 2) are positions of stars, `pixel_size` (2,) is in half fields."""

    def __init__(
        self,
        stars: FieldStars,
        places: Array,
        pixel_size: Array,
        degree: int,
        draw: np.random.Generator,
        report: Progress,
        excess: float = 1.0,
    ) -> None:
        self.excess = excess  # of the noise of electron multiplication
        self.stars, self.places, self.degree, self.draw, self.report = stars, places, degree, draw, report
        self.initial_stars, stars.report = stars, report
        self.blur_costs: dict[str, float] = {}
        #: Whether the profile of the blur is to be chosen, and the finding on slopes of backgrounds, if estimated.
        self.is_blur_open, self.slope_notes = stars.width_count == 2, list[Finding]()
        self.refits = 0  # with effects that the stars favour
        self.rival: Rival | None = None
        #: Indices of double stars and defects, which no wavefront fits: they are not fitted individually again.
        self.misfits = np.zeros(0, dtype=np.intp)
        self.pixel_size = pixel_size
        #: The stars with fewer terms of the blur model, for fits of individual stars.
        self.simplified_stars = (
            stars.with_blur_profile(BlurProfile.turbulent(terms=_SINGLE_TERMS)) if stars.width_count == 2 else stars
        )
        self.squared_widths = np.full(
            (stars.exposures, stars.width_count), _START_BLUR**2 / max(stars.width_count, 1)
        )
        self.widest = (_MAX_BLUR * min(stars.shape)) ** 2

    @property
    def metric(self) -> Array:
        """Matrix (k, k) of the mean square of the phase as a function of the terms."""
        directions = self.stars.first_star.directions
        return np.asarray((directions * self.stars.first_star.mean_squares) @ directions.T)

    def basis(self, chosen: NDArray[np.intp], degree: int | None = None) -> Array:
        """Return the monomials at the positions of stars, shape (n, m)."""
        u, v = self.places[chosen].T
        return monomials(u, v, self.degree if degree is None else degree)

    def model(self, chosen: NDArray[np.intp], *, held: bool = False) -> WholeField:
        """Return the model of the chosen stars; polynomials and blur are fixed if `held` is True."""
        return WholeField(self.stars, chosen, self.basis(chosen), held=held)

    def brightest(self) -> NDArray[np.intp]:
        """Return the indices of the brightest stars, which are fitted individually."""
        counted, _, _, valid = self.stars.pixel_data
        level = np.median(counted, axis=-1, keepdims=True)
        brightness = (valid * (counted - level)).sum(axis=(1, 2))
        return np.sort(np.argsort(-brightness, kind="stable")[:_MAX_SINGLES])

    def fit_single_stars(self, chosen: NDArray[np.intp]) -> tuple[Array, Array, NDArray[np.bool_]]:
        """Fit stars individually: return the best parameters (n, p), chi2, and a mask of sure stars.

        A star is sure if it fits, or if two starts ended at the same chi2: further starts are unlikely to help.
        """
        stars = self.stars
        best_x, chi2 = np.zeros((len(chosen), stars.size)), np.full(len(chosen), np.inf)
        is_sure = np.zeros(len(chosen), dtype=bool)
        rows = np.arange(len(chosen))  # indices of stars for which another start is needed
        for attempt in range(_MAX_STARTS):
            self.report.begin(*_PHASES["starts" if attempt else "single stars"])
            model = SingleStars(self.simplified_stars, chosen[rows], self.widest)
            x = self._random_start(model, scatter=attempt > 0 or stars.first_star.sign_ambiguous)
            with suppress(Declined, ToleranceError):
                x, scores, *_ = search_rows(model, x, _STEPS, self.report, fast=True)
                previous = chi2[rows]
                is_better = scores.chi2 < previous
                best_x[rows[is_better]], chi2[rows[is_better]] = x[is_better], scores.chi2[is_better]
                is_good = scores.chi2 < np.maximum(largest_plausible_chi2(scores.spread, SURE), 1.02)
                is_same_chi2 = np.abs(scores.chi2 - previous) < _SAME_CHI2 * np.maximum(chi2[rows] - 1.0, 0.0)
                is_sure[rows[is_good | is_same_chi2]] = True
                rows = rows[~(is_good | is_same_chi2)]
            # A large chi2 indicates a double star or defect.
            if attempt + 1 >= _MIN_STARTS and is_sure.mean() >= _MIN_SURE:
                rows = rows[chi2[rows] <= _MAX_CHI2_RATIO * np.median(chi2)]
            if rows.size == 0:
                break
        return best_x, chi2, is_sure

    def _random_start(self, model: SingleStars, *, scatter: bool) -> Array:
        stars = self.stars
        terms = stars.first_star.unknowns.terms
        deviations = np.full(len(terms), _SCATTER[1])
        deviations[: min(3, len(terms))] = _SCATTER[0]
        waves = stars.start[model.chosen].copy()
        if scatter:
            waves += self.draw.normal(size=waves.shape) * deviations
        return model.row(waves, self.squared_widths, self._centred_nuisance(model.chosen, waves))

    def _centred_nuisance(self, rows: NDArray[np.intp], waves: Array) -> Array:
        """Return initial nuisance parameters for which the images of stars have the observed centroids."""
        first_star = self.stars.first_star
        edge = self.stars.fixed_of_images[rows] + (waves @ first_star.directions)[:, None]
        # The mean slope of the wavefront shifts the centroid: tilts correspond to the centroid minus this shift.
        return self.stars.start_values(rows, self._centroids[rows] - first_star.mean_tilts(edge).swapaxes(0, 1))

    @cached_property
    def _centroids(self) -> Array:
        return self.stars.centroids()

    def fit_from_start(self, *, alone: bool = False) -> Solution | None:
        """Fit the brightest stars, starting at the initial wavefronts; return None if no fit is good enough.

        `alone`: no other start follows, so a first fit that misses little of the light is good enough.
        """
        self.report.begin(*_PHASES["first"])
        chosen = self.brightest()
        polynomials, _ = robust(self.basis(chosen), self.stars.start[chosen], np.ones(len(chosen)), self.metric)
        squared_widths, ranking_stars = self.squared_widths, chosen[:: max(1, len(chosen) // _RANKING_STARS)]
        starts = itertools.chain([polynomials], self._trial_polynomials(ranking_stars, polynomials, squared_widths))
        for trial in starts:
            fit = self.refine(chosen, trial, squared_widths, 10)
            if fit is None:
                continue
            if alone and part_missed(*fit.residual_parts) < _LITTLE:
                return fit
            if np.median(fit.model.star_quality(fit.x, fast=True).chi2) <= _GOOD_CHI2:
                return fit
        return None

    def _trial_polynomials(
        self, chosen: NDArray[np.intp], polynomials: Array, squared_widths: Array
    ) -> Iterator[Array]:
        """Yield polynomials with trial defocus and spherical aberration added, in order of increasing chi2."""
        names = self.stars.first_star.unknowns.terms
        shifts = [_SHIFTS.get(term_of(name) or (0, 0), (0.0,)) for name in names]
        field_model, trials = self.model(chosen, held=True), []
        for offsets in itertools.product(*shifts):
            if not any(offsets):
                continue
            trial = np.zeros((len(names), field_model.basis.shape[1]))
            trial[:, : polynomials.shape[1]] = polynomials
            trial[:, 0] += offsets
            with suppress(Declined, ToleranceError):
                x = field_model.row(trial, squared_widths, self.fit_nuisance(chosen, trial, squared_widths))
                trials.append((float(np.median(field_model.star_quality(x, fast=True).chi2)), trial))
        yield from (trial for _, trial in sorted(trials, key=lambda pair: pair[0])[:_FITTED_SHIFTS])

    def fit_from_single_stars(self) -> Solution:
        """Fit the brightest stars jointly, starting at fits of the individual stars."""
        stars = self.stars
        chosen = self.brightest()
        x, chi2, is_sure = self.fit_single_stars(chosen)
        if not np.isfinite(chi2).any():
            raise ToleranceError(f"no star could be fitted: {_TOO_STRONG}")
        is_usable = np.isfinite(chi2)
        # Polynomials cannot fit better than individual wavefronts: a fit with nearly the same chi2 ends the search.
        excess = _EXCESS_RATIO * (float(np.median(chi2[is_usable])) - 1.0) if is_sure.mean() >= _MIN_SURE else 0.0
        accepted_chi2 = max(_GOOD_CHI2, 1.0 + excess)
        # Stars with a poor individual fit would distort the polynomials; `fit_all_stars` may add them later.
        has_typical_chi2 = is_usable & (chi2 <= _MAX_CHI2_RATIO * np.median(chi2[is_usable]))
        self.misfits = chosen[is_usable & ~has_typical_chi2]
        if has_typical_chi2.sum() >= max(_MIN_SURE * is_usable.sum(), 4):
            is_usable = has_typical_chi2
        chosen, x, chi2 = chosen[is_usable], x[is_usable], chi2[is_usable]
        quality = 1.0 / np.maximum(chi2 / max(float(np.median(chi2)), 1e-9), 1.0) ** 2
        waves, squared_widths, _ = SingleStars(stars, chosen, self.widest).parts(x)
        good_fits = chi2 <= _MAX_CHI2_RATIO * np.median(chi2)
        squared_width = np.median(squared_widths[good_fits], axis=0)
        degree = highest_degree(self.degree, len(chosen))
        bases = [self.basis(chosen, d) for d in sorted({min(2, degree), degree})]
        if stars.first_star.one_focus and (stars.first_star.even * stars.first_star.directions).any():
            wavefronts = stars.fixed_of_images[chosen, 0] + waves @ stars.first_star.directions
            even = (wavefronts * stars.first_star.even) * np.sqrt(stars.first_star.mean_squares)
            negate = partial(self.negated, chosen)
            starts = candidates(self.places[chosen], waves, even, negate, bases, quality, self.metric, self.draw)
        else:
            starts = iter([(robust(bases[-1], waves, quality, self.metric)[0], waves)])
        best_fit: Solution | None = None
        lowest_chi2 = np.inf
        self.report.begin(*_PHASES["joint"])
        for polynomials, _ in starts:
            fit = self.refine(chosen, polynomials, squared_width, 8)
            if fit is None:
                continue
            median = float(np.median(fit.model.star_quality(fit.x, fast=True).chi2))
            if median < lowest_chi2:
                best_fit, lowest_chi2 = fit, median
            if median < accepted_chi2:
                break
        if best_fit is None:
            raise ToleranceError(f"no field could be fitted: {_TOO_STRONG}")
        return best_fit

    def negated(self, chosen: NDArray[np.intp], waves: Array) -> Array:
        """Return the coefficients of the wavefronts of stars with the even part of the phase negated."""
        return self.stars.first_star.negated(waves, self.stars.fixed_of_images[chosen, 0])

    def refine(
        self,
        chosen: NDArray[np.intp],
        polynomials: Array,
        squared_widths: Array,
        max_steps: int,
        nuisance: Array | None = None,
        *,
        fast: bool = True,
    ) -> Solution | None:
        """Fit stars in at most `max_steps` steps, from polynomials (k, m); None if images cannot be computed."""
        m = (self.degree + 1) * (self.degree + 2) // 2
        start = np.zeros((len(polynomials), m))
        start[:, : polynomials.shape[1]] = polynomials[:, :m]
        model = self.model(chosen)
        try:
            nuisance = self.fit_nuisance(chosen, start, squared_widths) if nuisance is None else nuisance
            x = model.row(start, squared_widths, nuisance)
            x, scores, settled, _ = search_rows(model, x, max_steps, self.report, fast=fast)
        except (Declined, ToleranceError):
            return None
        return Solution(model, x, scores, bool(settled[0]))

    def fit_nuisance(self, chosen: NDArray[np.intp], polynomials: Array, squared_widths: Array) -> Array:
        """Fit the nuisance parameters (r, o, e) of star images, with fixed wavefronts and blur."""
        model = self.model(chosen, held=True)
        nuisance = self._centred_nuisance(chosen, model.basis @ polynomials.T)
        if not self.stars.has_corners:  # the start positions of corners are accurate to a pixel
            psf = model.images(model.row(polynomials, squared_widths, nuisance), fast=True)[0]
            nuisance[:, :2] += self.stars.shifts(chosen, psf) * self.stars.first_star.tilt_of_pixel
        x, *_ = search_rows(model, model.row(polynomials, squared_widths, nuisance), 6, _no_progress, fast=True)
        return model.parts(x)[2]

    def reject_outliers(self, fit: Solution) -> Solution:
        """Reject outlying stars and fit again, in at most `_ROUNDS` rounds."""
        initial_count = len(fit.model.chosen)
        for _ in range(_ROUNDS):
            is_inlier = ~outliers(fit.model.star_quality(fit.x, fast=True))
            inlier_count = int(is_inlier.sum())
            min_count = max((1.0 - _MAX_REJECTED) * initial_count, fit.model.basis.shape[1] + 1)
            if is_inlier.all() or inlier_count < min_count:
                break
            chosen, nuisance = fit.model.chosen[is_inlier], fit.nuisance()[is_inlier]
            refit = self.refine(chosen, fit.polynomials(), fit.squared_widths(), 10, nuisance)
            if refit is None:
                break
            fit = refit
        return fit

    def fit_all_stars(self, fit: Solution) -> tuple[Solution, NDArray[np.intp]]:
        """Fit all stars except outliers, from a fit of some stars; return the fit and the indices of outliers."""
        all_stars = np.arange(self.stars.count)
        polynomials, squared_widths = fit.polynomials(), fit.squared_widths()
        other_stars = np.setdiff1d(all_stars, fit.model.chosen)
        is_outlier = np.zeros(len(all_stars), dtype=bool)
        wider_fit: Solution | None = None
        if len(other_stars):
            nuisance = np.empty((len(all_stars), self.stars.parameters_per_image, self.stars.exposures))
            nuisance[fit.model.chosen] = fit.nuisance()
            nuisance[other_stars] = self.fit_nuisance(other_stars, polynomials, squared_widths)
            model = self.model(all_stars, held=True)
            is_outlier = outliers(model.star_quality(model.row(polynomials, squared_widths, nuisance), fast=True))
            if is_outlier.mean() > _MAX_REJECTED or (~is_outlier).sum() <= model.basis.shape[1]:
                is_outlier[:] = False
            used_stars = all_stars[~is_outlier]
            if not np.array_equal(used_stars, fit.model.chosen):
                wider_fit = self.refine(used_stars, polynomials, squared_widths, 10, nuisance[used_stars])
        fit = self.readmit_stars(self.lowest_minimum(self.reject_outliers(wider_fit or fit)))
        nuisance, chosen = fit.nuisance(), fit.model.chosen
        # Windows are centred on the light, which aberrations displace: correct the positions of stars.
        displacement = nuisance[:, :2].mean(axis=-1) / self.stars.first_star.tilt_of_pixel
        self.places = self.places.copy()
        self.places[chosen] += displacement[:, ::-1] * self.pixel_size
        if self.is_blur_open:
            fit = self.best_profile(fit)
            nuisance = fit.nuisance()
        squared_widths = fit.squared_widths()
        return self._settled(fit), np.setdiff1d(all_stars, chosen)

    def lowest_minimum(self, fit: Solution) -> Solution:
        """Repeat a fit from starts with other signs of even terms; return the most likely fit.

        With a single focus there are several minima, which differ in the signs of even terms, but not of one donut.
        """
        self.rival = None
        is_donut = self.stars.count == 1 and self.stars.is_donut
        if not self.stars.first_star.one_focus or self.stars.has_corners or is_donut:
            return fit
        self.report.begin(*_PHASES["signs"])
        for _ in range(2):
            refits = self._fit_other_signs(fit)
            best_fit = min([fit, *refits], key=lambda refit: float(refit.scores.deviance[0]))
            if best_fit.scores.deviance[0] > fit.scores.deviance[0] - _MIN_GAIN:
                break
            fit = self._continue(best_fit, _RIVAL_STEPS) or best_fit
        for refit in refits:
            if self._rival(fit, refit) and (continued_fit := self._continue(refit, _RIVAL_STEPS)) is not None:
                if continued_fit.scores.deviance[0] < fit.scores.deviance[0]:
                    fit, continued_fit = continued_fit, fit
                self.rival = self._rival(fit, continued_fit) or self.rival
        return fit

    def _fit_other_signs(self, fit: Solution) -> list[Solution]:
        """Return a list with the best result (if any) of short searches that start at other signs of even terms."""
        first_star, polynomials, chosen = self.stars.first_star, fit.polynomials(), fit.model.chosen
        waves = fit.model.basis @ polynomials.T
        rms = np.sqrt((waves**2).mean(axis=0) * np.diag(self.metric))
        even = np.flatnonzero((np.abs(first_star.directions) @ ~first_star.even == 0.0) & (rms > _MIN_NEGATED))
        even = even[np.argsort(-rms[even], kind="stable")]
        starts = []
        if first_star.sign_ambiguous:
            # The image of a star does not change if the whole even part of its wavefront is negated. For each even
            # term, negate the even parts of some stars, such that the term has one sign all over the field.
            negated_waves = self.negated(chosen, waves)
            for j in even:
                negative = waves[:, j] < 0.0
                if negative.any() and not negative.all():
                    one_sign = np.where(negative[:, None], negated_waves, waves)
                    starts.append(robust(fit.model.basis, one_sign, np.ones(len(chosen)), self.metric)[0])
        for j in even[: len(even) - (len(even) < 3)]:  # with two even terms, negating either yields the same images
            starts.append(polynomials.copy())
            starts[-1][j] *= -1.0
        refits = [self._continue(fit, _TRIAL_STEPS, start) for start in starts[:_MAX_NEGATED]]
        rivals = [
            refit
            for refit in filter(None, refits)
            if abs(refit.scores.deviance[0] - fit.scores.deviance[0]) > _MIN_GAIN or self._rival(fit, refit)
        ]
        best_rivals = sorted(rivals, key=lambda refit: float(refit.scores.deviance[0]))[:1]
        return [self._continue(refit, _BEST_STEPS) or refit for refit in best_rivals]

    def _continue(self, fit: Solution, max_steps: int, polynomials: Array | None = None) -> Solution | None:
        """Continue a fit by `max_steps` steps, from `polynomials` if given; None if images cannot be computed."""
        start = fit.polynomials() if polynomials is None else polynomials
        return self.refine(fit.model.chosen, start, fit.squared_widths(), max_steps, fit.nuisance())

    def _rival(self, best_fit: Solution, other_fit: Solution) -> Rival | None:
        """Return a Rival if `other_fit` is nearly as likely as `best_fit` but distant from it; None otherwise."""
        cost = float(other_fit.scores.deviance[0] - best_fit.scores.deviance[0])
        first_star, k = self.stars.first_star, best_fit.model.wave_count * best_fit.model.basis.shape[1]
        errors = np.sqrt(np.diag(best_fit.model.covariance(best_fit.scores))[:k]).reshape(
            best_fit.model.wave_count, -1
        )
        refits = [other_fit.polynomials()]
        # The twin (all even parts negated) has the same images: use the smaller distance of `other_fit` and its twin.
        if first_star.sign_ambiguous:
            refits.append(self.twin(refits[0]))
        sigmas = min(float((np.abs(refit - best_fit.polynomials()) / errors).max()) for refit in refits)
        return Rival(cost, sigmas) if cost < _MAX_RIVAL_COST and sigmas > _MIN_RIVAL_DISTANCE else None

    def twin(self, polynomials: Array) -> Array:
        """Return polynomials (k, m) with all even parts negated."""
        first_star = self.stars.first_star
        # The matrix 1 - flip negates the even part: flip is twice the projection onto the even part.
        flip = 2.0 * ((first_star.directions * first_star.even) @ first_star.inverse).T
        negated = polynomials - flip @ polynomials
        negated[:, 0] -= 2.0 * ((first_star.fixed_of_images[0] * first_star.even) @ first_star.inverse)
        return np.asarray(negated)

    def nearest_twin(self, fit: Solution) -> Solution:
        """Return a fit or its twin, whichever is nearer to the initial wavefronts."""
        star, basis, model = self.stars.first_star, fit.model.basis, fit.model
        if not star.sign_ambiguous:
            return fit
        polynomials, twin, start_waves = (
            fit.polynomials(),
            self.twin(fit.polynomials()),
            self.stars.start[model.chosen],
        )
        changes = (basis @ p.T - start_waves for p in (polynomials, twin))
        distance, other = (float(np.einsum("ni,ij,nj->", change, self.metric, change)) for change in changes)
        is_nearer = other < distance
        if math.isclose(distance, other, rel_tol=1e-6):  # choose the field whose first even term has the larger mean
            term = next(j for j, row in enumerate(star.directions) if row[star.even].any())
            is_nearer = bool((basis @ twin[term]).mean() > (basis @ polynomials[term]).mean())
        x = model.row(twin, fit.squared_widths(), fit.nuisance())
        return replace(fit, x=x, scores=model.scores(x)) if is_nearer else fit

    def best_profile(self, fit: Solution) -> Solution:
        """Return the fit with the most likely profile of blur; a single width is preferred to two of similar lnL."""
        nuisance, polynomials, squared_widths = fit.nuisance(), fit.polynomials(), fit.squared_widths()
        stars, (_, width_count) = fit.model.stars, squared_widths.shape
        squared_widths = np.repeat(squared_widths, 2 // width_count, axis=1) * (0.5 * width_count)
        self.report.begin(*_PHASES["refit" if self.refits else "profiles"])

        def fit_profile(profile: BlurProfile, widths: Array, max_steps: int) -> Solution:
            self.stars = stars.with_blur_profile(profile)
            # Errors of fast images change lnL by as much as profiles do.
            start = fit.model.chosen, polynomials, widths
            refit = self.refine(*start, max_steps, nuisance, fast=False)
            return refit or replace(fit, scores=fit.scores._replace(deviance=np.full(1, np.inf)))

        two_widths = fit_profile(BlurProfile.turbulent(), squared_widths, _PROFILE_STEPS)
        cost: dict[float | None, float] = {None: float(two_widths.scores.deviance[0])}
        gaussian = fit_profile(BlurProfile.gaussian(), squared_widths.sum(axis=-1, keepdims=True), _PROFILE_STEPS)
        self.blur_costs = {"Gaussian": float(gaussian.scores.deviance[0])}
        outer: float | None = None
        best_fit = two_widths
        if self.blur_costs["Gaussian"] > cost[None] + _OUTER_GAIN:
            polynomials, nuisance = two_widths.polynomials(), two_widths.nuisance()
            squared_widths = two_widths.squared_widths()
            for next_outer in OUTER[1:]:
                trial = fit_profile(BlurProfile.turbulent(next_outer), squared_widths, 2)
                cost[next_outer] = float(trial.scores.deviance[0])
                if cost[next_outer] < cost[outer] - _MIN_GAIN:
                    best_fit, outer = trial, next_outer
                else:
                    break
        seeing_width = best_fit.squared_widths().sum(axis=-1, keepdims=True)
        seeing = fit_profile(BlurProfile.turbulent(outer, alone=True), seeing_width, _PROFILE_STEPS)
        self.blur_costs |= {"seeing": float(seeing.scores.deviance[0]), "both": cost[outer]}
        limit = cost[outer] + _MIN_WIDTH_GAIN
        pairs = (gaussian, "Gaussian"), (seeing, "seeing")
        single_widths = [single for single, name in pairs if self.blur_costs[name] < limit]
        is_narrow = float(gaussian.squared_widths().max()) < _NARROW
        if len(single_widths) == 1 or (single_widths and is_narrow):
            best_fit = single_widths[0]
        self.stars = best_fit.model.stars
        return best_fit

    def outer_scale_errors(self, fit: Solution) -> Array:
        """Return the relative standard error of r0 of each exposure, (e,), that is due to the outer scale."""
        stars, profile, squared_widths = self.stars, self.stars.blur, fit.squared_widths()
        squares = np.zeros(len(squared_widths))
        if "seeing" not in profile.names:
            return squares
        seeing, i = profile.names.index("seeing"), OUTER.index(profile.outer)
        total, spacing = 1.0, squares
        for outer in (*OUTER[max(i - 1, 0) : i], *OUTER[i + 1 : i + 2]):
            self.stars = stars.with_blur_profile(BlurProfile.turbulent(outer, alone=len(profile.names) == 1))
            start = fit.model.chosen, fit.polynomials(), squared_widths
            refit = self.refine(*start, _PROFILE_STEPS, fit.nuisance(), fast=False)
            if refit is None:
                continue
            # r0 is proportional to the reciprocal width. Outer scales have equal prior probabilities.
            widths = (np.maximum(found.squared_widths()[:, seeing], _TINY) for found in (fit, refit))
            change = 0.5 * np.log(np.divide(*widths))
            probability = math.exp(min(float(fit.scores.deviance[0] - refit.scores.deviance[0]), 0.0))
            total, squares = total + probability, squares + probability * change**2
            spacing = np.maximum(spacing, change**2 / 12.0)  # the true outer scale may be between the compared ones
        self.stars = stars
        return np.asarray(np.sqrt(squares / total + spacing))

    def readmit_stars(self, fit: Solution) -> Solution:
        """Return a fit that includes rejected stars, if other polynomials fit them too; else the unchanged fit."""
        # A rejected star that fits individually is no double star: the polynomials are wrong at its position.
        all_stars = np.arange(self.stars.count)
        for _ in range(_ROUNDS):
            rejected = np.setdiff1d(all_stars, fit.model.chosen)
            # The image of a single corner does not determine a wavefront.
            if not rejected.size or self.stars.has_corners:
                break
            is_good, waves = self._fit_individually(rejected, fit)
            map_waves = fit.model.basis @ fit.polynomials().T
            refit = self._refit_with(fit, map_waves, rejected[is_good], waves[is_good]) if is_good.any() else None
            readmitted = rejected[is_good | ~np.isin(rejected, self.misfits)]
            if refit is None and readmitted.size:
                refit = self._refit_with(fit, map_waves, readmitted, self.basis(readmitted) @ fit.polynomials().T)
            if refit is None:
                break
            fit = refit
        return fit

    def _refit_with(
        self, fit: Solution, waves: Array, added_stars: NDArray[np.intp], added_waves: Array
    ) -> Solution | None:
        """Return a fit that includes `added_stars`; None unless more stars fit than before.

        The search starts at the wavefronts `waves` of the used stars and `added_waves` of the added stars.
        """
        used_stars = np.concatenate([fit.model.chosen, added_stars])
        wavefronts = np.concatenate([waves, added_waves])
        polynomials, _ = robust(self.basis(used_stars), wavefronts, np.ones(len(used_stars)), self.metric)
        refit = self.refine(np.sort(used_stars), polynomials, fit.squared_widths(), 20)
        if refit is None:
            return None
        refit = self.reject_outliers(refit)
        chi2_limit = max(1.0 + _EXCESS_RATIO * (float(fit.scores.chi2[0]) - 1.0), self._chi2_limit(refit))
        is_better = len(refit.model.chosen) > len(fit.model.chosen) and refit.scores.chi2[0] <= chi2_limit
        return refit if is_better else None

    def _fit_individually(self, rejected: NDArray[np.intp], fit: Solution) -> tuple[NDArray[np.bool_], Array]:
        """Fit rejected stars individually; return a mask of stars that fit, and all wavefronts (r, k)."""
        stars, squared_widths = self.stars, fit.squared_widths()
        map_waves = self.basis(rejected) @ fit.polynomials().T
        is_good, waves = np.zeros(len(rejected), dtype=bool), map_waves.copy()
        single_stars = SingleStars(stars, rejected, self.widest)
        with suppress(Declined, ToleranceError):
            nuisance = self.fit_nuisance(rejected, fit.polynomials(), squared_widths)
            x = single_stars.row(map_waves, squared_widths, nuisance)
            x, scores, *_ = search_rows(single_stars, x, _STEPS, _no_progress, fast=True)
            is_good, waves = scores.chi2 < largest_plausible_chi2(scores.spread, SURE), single_stars.wavefronts(x)
        is_retried = ~is_good & ~np.isin(rejected, self.misfits)
        if is_retried.any():
            x, chi2, sure = self.fit_single_stars(rejected[is_retried])
            new_waves = single_stars.wavefronts(x)
            if stars.first_star.sign_ambiguous:
                negated, map_waves_of_retried = self.negated(rejected[is_retried], new_waves), map_waves[is_retried]
                changes = new_waves - map_waves_of_retried, negated - map_waves_of_retried
                distances = [np.einsum("ni,ij,nj->n", change, self.metric, change) for change in changes]
                new_waves = np.where((distances[1] < distances[0])[:, None], negated, new_waves)
            is_good_refit = sure & (chi2 < 1.0 + 2.0 * (self._chi2_limit(fit) - 1.0))
            self.misfits = np.union1d(self.misfits, rejected[is_retried][~is_good_refit])
            waves[is_retried], is_good[is_retried] = new_waves, is_good_refit
        return is_good, waves

    @staticmethod
    def _chi2_limit(fit: Solution) -> float:
        return float(largest_plausible_chi2(fit.scores.spread[0], SURE))

    def outcome(self, fit: Solution) -> Outcome:
        """Fit and test all stars, starting at a fit of some stars."""
        places = self.places
        fit, rejected = self.fit_all_stars(fit)
        if found := slope_findings(fit.model, fit.x):
            self.places, self.slope_notes = places, found
            fit, rejected = self.fit_all_stars(self._with_background_slopes(fit, sloping=True))
        tested = partial(missing_tests, self.places, self.degree)
        revised = partial(self._revised, tested)
        rounds = rounds_of(self.nearest_twin(fit), tested, self._estimating, self._favoured, revised=revised)
        fit, (tests, grade, untested) = rounds[-1][:2]
        self.stars = fit.model.stars
        self.report.begin(*_PHASES["end"])
        chosen, nuisance = fit.model.chosen, fit.nuisance()
        psf = self.stars.images(chosen, *fit.model.parts(fit.x), fast=False, derivatives="none")[0]
        parameters = fit.model.common_count + len(chosen) * self.stars.parameters_per_image * self.stars.exposures
        bright_chi2 = self.stars.bright_pixel_chi2(chosen, psf, nuisance, float(parameters))
        held_out = self.held_out(fit)
        results = self.blur_costs, [*self.slope_notes, *untested], tests, grade, self.rival
        outcome = Outcome(fit, rejected, held_out, bright_chi2, self.places, *results, rounds=rounds)
        read = self.stars.pixel_data[2, chosen].reshape(psf.shape)
        found = with_noise(outcome.findings, [*seen(tests)], fit.residual_parts, read, self.excess)[0]
        outcome.of_noise = found[: len(found) - len(outcome.findings)]
        if len(chosen) == 1 and "misfit" in outcome.findings.codes:
            outcome.model_error = fit.valid_model_error(outcome.findings.codes, tests)
        return outcome

    def _favoured(self, tests: Sequence[ScoreTest]) -> list[ScoreTest]:
        """Return significant effects, of a donut that of a trail first: it resembles others that no model estimates.

        The model has no changes from image to image, which two foci resemble as well.
        """
        found = [test for test in seen(tests) if not test.name.endswith(DRIFTS)]
        if not found or self.stars.count > 1 or not self.stars.is_donut:
            return found
        trails = [t for t in tests if t.name == ELLIPSE and t.log_bayes > _TRAIL_SHARE * found[0].log_bayes]
        return [*trails, *(test for test in found if test.name != ELLIPSE)]

    def _estimating(self, fit: Solution, test: ScoreTest) -> tuple[Solution, float] | None:
        """Return a fit that estimates the effect of `test`, and its gain of lnL; None if the model cannot.

        Constants change by the estimate of their score test.
        """
        stars = fit.model.stars
        if test.name == ELLIPSE:
            freed_stars = stars.with_trails(stars.trails + test.size.reshape(-1, 2))
        else:
            optics = changed(stars.first_star, test.name, float(test.size[0]))
            freed_stars = optics and stars.with_optics(*optics)
        if freed_stars is None:
            return None
        self.stars = freed_stars
        nuisance, added_count = fit.nuisance(), len(freed_stars.first_star.directions) - fit.model.wave_count
        nuisance[:, :2] *= self.stars.first_star.tilt_of_pixel / stars.first_star.tilt_of_pixel
        polynomials = np.pad(fit.polynomials(), ((0, added_count), (0, 0)))
        if not self.refits:
            self.report.resume(_BEFORE_REFITS)
        self.refits += 1
        self.report.begin(*_PHASES["refit"])
        refit = self.refine(fit.model.chosen, polynomials, fit.squared_widths(), 20, nuisance, fast=False)
        return (fit, -math.inf) if refit is None else (refit, fit.deviance - refit.deviance)

    def _revised(
        self, tested: Callable[[Solution, Sequence[str]], tuple[Sequence[ScoreTest], object, object]], fit: Solution,
        test: ScoreTest, compared: bool,
    ) -> Solution:  # fmt: skip
        """Return a fit that estimates an effect, with the profile of blur and slopes of backgrounds chosen anew.

        Both may have stood for this effect while the model lacked it. A constant takes another step if fits are
        `compared`.
        """
        if self.slope_notes:
            fit = self._with_background_slopes(fit, sloping=False)
        fit = self._settled(self.best_profile(fit) if self.is_blur_open else fit)
        if found := slope_findings(fit.model, fit.x):
            self.slope_notes = found
            fit = self._settled(self._with_background_slopes(fit, sloping=True))
        moved = [one for one in tested(fit, (test.name,))[0] if one.name == test.name] if compared else []
        again = self._estimating(fit, moved[0]) if moved else None
        return again[0] if again and again[1] > 0.0 else fit

    def _settled(self, fit: Solution) -> Solution:
        """Return a fit after further steps with proven images; the fit itself if they cannot be computed."""
        self.stars = fit.model.stars
        start = fit.model.chosen, fit.polynomials(), fit.squared_widths(), 20, fit.nuisance()
        return self.refine(*start, fast=False) or fit

    def _with_background_slopes(self, fit: Solution, *, sloping: bool) -> Solution:
        """Return the fit with a model that has a slope of each background, initially 0, or that has none."""
        self.stars, self.initial_stars, self.simplified_stars = (  # all three, for a later search
            stars.with_background_slopes(sloping=sloping)
            for stars in (fit.model.stars, self.initial_stars, self.simplified_stars)
        )
        self.slope_notes = self.slope_notes if sloping else []
        nuisance = fit.nuisance()
        nuisance = np.pad(nuisance, ((0, 0), (0, 2), (0, 0))) if sloping else nuisance[:, :-2]
        model = self.model(fit.model.chosen)
        return replace(fit, model=model, x=model.row(fit.polynomials(), fit.squared_widths(), nuisance))

    def held_out(self, fit: Solution) -> tuple[float, float]:
        """Return chi2 of a fifth of the stars with wavefronts predicted by the others, and its standard deviation."""
        chosen = fit.model.chosen
        # Hold out every fifth star along an oblique direction: a reproducible choice all over the field.
        order = np.argsort(self.places[chosen] @ [1.0, 0.318], kind="stable")
        is_held_out = np.zeros(len(chosen), dtype=bool)
        is_held_out[order[2::5]] = True
        if (~is_held_out).sum() <= fit.model.basis.shape[1] or not is_held_out.any():
            return math.nan, math.nan
        nuisance = fit.nuisance()
        is_used, start = ~is_held_out, (fit.polynomials(), fit.squared_widths())
        refit = self.refine(chosen[is_used], *start, 6, nuisance[is_used])
        if refit is None:
            return math.nan, math.nan
        model = self.model(chosen[is_held_out], held=True)
        x = model.row(refit.polynomials(), refit.squared_widths(), nuisance[is_held_out])
        _, scores, *_ = search_rows(model, x, 6, _no_progress, fast=True)
        return float(scores.chi2[0]), float(scores.spread[0])


def trails_of(fit: Solution, tests: Sequence[ScoreTest]) -> tuple[Array, Array, Array]:
    """Return lengths of the lines that blur each exposure (pixels), their standard errors, and angles (radians)."""
    trails = fit.model.stars.trails
    size, errors = next(
        ((test.size, test.errors) for test in tests if test.name == ELLIPSE), (np.zeros(trails.size),) * 2
    )
    trails = trails + size.reshape(trails.shape)
    lengths, angles = lines_of(trails)
    # The length is sqrt(24 m) for m = hypot(trails), and its derivative by m is 12 / length.
    spread = np.hypot(*(trails * errors.reshape(trails.shape)).T) / np.maximum(np.hypot(*trails.T), 1e-12)
    return lengths, 12.0 * spread / np.maximum(lengths, np.sqrt(12.0 * spread)), angles


def estimated_effects(rounds: Sequence[Round], coefficients: Array, errors: Array) -> list[Finding]:
    """Return the finding on what the last fit estimates besides; `coefficients` (k, m) have the standard `errors`."""
    (first, *_), (fit, (tests, *_), names, rivals, *_), doubted = rounds[0], rounds[-1], unsure(rounds)
    star, first_star, before = fit.model.stars.first_star, first.model.stars.first_star, first.polynomials()
    terms = [*zip(star.unknowns.terms, zip(coefficients, errors, strict=True), strict=True)]
    estimates = [
        Estimate(label(term), float(row[0]), float(error[0]), 0.0, "rad", unsure=label(term) in doubted)
        for term, (row, error) in terms[len(before) :]
    ]
    if ELLIPSE in names:
        trails = enumerate(zip(*trails_of(fit, tests), strict=True), 1)
        estimates += [Estimate(f"{TRAIL} in exposure {i}", x, error, 0.0, "pixels") for i, (x, error, _) in trails]

    def constant(test: ScoreTest, changed: Solution, size: float = 0.0) -> Estimate:
        one, unit = changed.model.stars.first_star, unit_of(test.name)
        stated, value = (value_of(star, test.name, first_star) for star in (first_star, one))
        is_unsure = test.name in doubted or test.name in rivals
        # A step that the last refit would still take is not settled.
        error = math.hypot(float(test.errors[0]), size)
        return Estimate(test.name, value + size, error, stated, unit, unsure=is_unsure)

    estimates += [
        constant(test, fit, float(test.size[0])) for test in tests if test.name in names and test.name != ELLIPSE
    ]
    count, others = len(before), list[Estimate]()
    for one in rounds:
        for test, other, _ in one.others:
            freed = [label(term) for term in other.model.stars.first_star.unknowns.terms[count:]]
            if test.name in rivals and test.name in freed:
                value = float(other.polynomials()[count + freed.index(test.name), 0])
                others.append(Estimate(test.name, value, float(test.errors[0]), 0.0, "rad", unsure=True))
            elif test.name in rivals and test.name != ELLIPSE:
                others.append(constant(test, other))
    changes = (np.abs(fit.polynomials()[:count] - before), np.abs(differences(rounds)[:count]))
    labels = [label(term) for term in star.unknowns.terms[:count]]
    moves, open_moves = (
        dict(zip(labels, (change / errors[:count]).max(axis=1).tolist(), strict=True)) for change in changes
    )
    return estimated_findings(estimates, moves, rivals, others, open_moves)


def differences(rounds: Sequence[Round]) -> Array:
    """Return the largest change of each coefficient (k, m) if a rival is estimated instead of an effect."""
    (first, *_), last = rounds[0], rounds[-1]
    found, count = np.zeros(last.fit.polynomials().shape), len(first.polynomials())
    for one in rounds:
        for test, other, _ in one.others:
            if test.name in last.rivals:
                change = other.polynomials()[:count] - one.fit.polynomials()[:count]
                found[:count] = np.maximum(found[:count], np.abs(change))
    return found


def _no_progress(step: int, chi2: float) -> None:
    """Report no progress, for short searches."""


def outliers(qualities: Quality) -> NDArray[np.bool_]:
    """Return a mask of stars whose chi2 is too large compared with the other stars."""
    median = float(np.median(qualities.chi2))
    # A slightly wrong model increases the scatter of chi2: use the larger of expected and robust standard deviation.
    deviation = np.maximum(qualities.spread, 1.4826 * float(np.median(np.abs(qualities.chi2 - median))))
    return np.asarray(qualities.chi2 > median + _OUTLIER * deviation)
