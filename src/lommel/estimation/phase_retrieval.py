"""Phase retrieval: the wavefront of a lens from star images, with the standard errors of its coefficients."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from os import PathLike
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import ArrayLike

from lommel import show
from lommel.base import validation
from lommel.base.arrays import Array, Numbers
from lommel.base.options import listed
from lommel.base.quantities import in_unit
from lommel.blur.blurs import Blur, Jitter, Seeing
from lommel.core.answers import Declined, ToleranceError
from lommel.detection.targets import Targets
from lommel.estimation import EFFORT, Effort
from lommel.estimation.favoured_effects import Estimate, Fit, Round, estimated_findings, opened, rounds_of, unsure
from lommel.estimation.field_fit import FieldFit, fit_targets
from lommel.estimation.options import FieldFitOptions, RetrieveOptions
from lommel.estimation.star_checks import (
    OF_FIELDS,
    error_findings,
    freed,
    missing_findings,
    star_tests,
    unit_of,
)
from lommel.estimation.star_images import (
    MAX_LINEAR_ERROR,
    StarImages,
    Unknowns,
    centroids,
    known_defocus,
    label,
    single,
)
from lommel.fit import goodness_of_fit
from lommel.fit.findings import Finding, Findings, FitReport
from lommel.fit.goodness_of_fit import SURE, largest_plausible_chi2
from lommel.fit.model_error import ModelError, covered, with_errors_of_model, with_noise, with_shared_error
from lommel.fit.score_tests import Grade, Marginal, ScoreTest, causes_of_misfit, seen
from lommel.fit.scoring import Progress, Report, Scores, covariance, search_rows
from lommel.io import zernike_tables
from lommel.methods.derivative_names import POWERS, SHIFTS, Name, term_of
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront, radians_per
from lommel.psf import PSF, Plan, cached_plan
from lommel.recorded.counts import Counts, counts_of, recording_findings
from lommel.recorded.headers import tell_sizes
from lommel.recorded.noise import Noise, random_numbers
from lommel.special import zernike

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SCATTER = 1.5  # rms phase that is added to the initial wavefront in random starts, radians
_STACKED_STARTS = 2  # number of random starts that are computed in one stack
# Number of starts that must end at the lowest minimum to end the search: in 54 simulated sets of images (0.7 to
# 3 rad rms, 500 to 1e5 electrons) in which three of 19 starts agreed, no other start ended at a lower minimum.
# Of a misfit, which may be a local minimum, five: no better one followed in 32 searches with strong aberrations.
_MIN_AGREEING, _MIN_AGREEING_MISFITS = 3, 5
_MIN_SIGNIFICANCE = 5.0  # smallest (flux) / (standard error of the flux) of a visible star
_MIN_DISTANCE_RATIO = 2.0  # smallest ratio of the twins' distances from the initial wavefront that decides the sign
_MAX_SUM_ERROR = 0.05  # images whose sums differ from 1 by less count as normalized
_REFIT_STEPS = 30  # maximum number of steps of a refit that estimates another effect
_MOST_EXCHANGED = 4  # images: pairs of more take too long
_MOST_EXCESS = 0.5  # part of chi2 - 1 below which exchanged defoci explain a misfit
_GROSS_CHI2 = 100.0  # chi2 from which no effect is small
_CAUSES = (
    "pupil (vanes, f-number), pixel, noise or the defocus of an image (unit, order) are wrong, terms are missing, "
    "the images are blurred (blur=True), or all starts converged to local minima"
)


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Retrieval(FitReport):
    """Result of a phase retrieval by :func:`lommel.retrieve`.

    Attributes
    ----------
    wavefront : Wavefront
        Estimated terms and fixed terms of `pupil`, without tilts of images and known defoci.
    twin : Wavefront or None
        The wavefront with the even part of the phase negated, if its images are the same (see "sign_open").
    pupil : Pupil
        The pupil with the estimated wavefront, f-number, wavelength and obscuration.
    coefficients : dict of name to float
        Parameters common to all images: Zernike terms in radians rms, "defocus" and powers of rho in radians (at the
        given wavelength), "f_number", "obscuration", "wavelength" in metres. Also effects that were estimated because
        the images favour them, see the finding "estimated"; of those that only a model of fields estimates (blur,
        apodization, slopes), `pupil`, `blurs` and the finding have the values.
    errors : dict of name to float or ndarray
        Standard errors of `coefficients`; inf if the images do not determine a parameter. Also the standard
        errors, shape (n,), of "flux", "background" and, if estimated, "row" and "column".
    covariance : ndarray, shape (k, k)
        Covariance of `coefficients`, in the same order. Parameters of single images are nuisance parameters.
    units : dict of name to str
        Units of `coefficients` and `errors`.
    chi2 : float
        Pearson's chi2 per degree of freedom: about 1 if pupil, pixel and noise are right, even for few electrons.
    findings : lommel.fit.Findings
        Findings of the checks. Errors: "misfit", "excess_noise", "gain", "no_light", "not_settled". Doubts:
        "sign_open" (the even part of the phase may have the other sign, and neither `pupil` nor a known defocus
        decides); "too_dim" (the standard error of an image's phase exceeds 0.25 radians rms, with `blur` 0.22: other
        wavefronts may fit);
        "errors_change" (a standard error changes by more than an eighth within one standard deviation);
        "other_explanation"; "pattern" (residuals have stripes, or offsets of rows or columns); "hot_pixels" (a pixel
        explains most of a large chi2); "missed_light" (the model misses a part of the light: errors hold between
        exposures of the same instrument); "exchanged" (of up to four images that do not fit, those with two defoci
        exchanged fit better); "too_quiet" (the images are less noisy than `noise` states). Notes:
        "undetermined", pixels left out or perhaps saturated. "rare_chi2" is a doubt if noise alone causes so large a
        chi2 in fewer than one of 1000 fits, otherwise a note.
    summary : str
        Chi2, and the numbers of steps and starts.
    converged, reliable, status, message
        The verdict that follows from `findings`, see :class:`lommel.fit.FitReport`: `converged` if there is no error,
        `reliable` if there is neither an error nor a doubt.
    flux, background : ndarray, shape (n,)
        Electrons of the star in an infinite window, and background in electrons per pixel.
    center : ndarray, shape (n, 2)
        Row and column of the optical axis in each image, like `center` of :func:`lommel.psf`.
    psf : PSF
        PSFs of the images, a stack (n, height, width), without `blurs`; values are fractions of the total light.
    blurs : tuple of tuples of blurs
        Blurs of each image, as arguments of :func:`lommel.psf`; empty tuples without blur.
    blur_errors : tuple of tuples of float
        Standard error of r0 (the outer scale is unknown) or sigma of each blur; 0 for a known blur.
    images, model, residual : ndarray, shape (n, height, width)
        Images, NaN at pixels left out; the fitted model, in the unit of the images; the residual, in standard
        deviations of the noise.
    steps, starts : int
        Total number of steps, and number of starts.

    Notes
    -----
    The expectation of Pearson's sum is ``(1 - p / n) sum((mu + read^2) / v)`` for n pixels with mu expected electrons
    and p parameters, where v is ``mu + read^2``, with at least 0.05 electrons^2 for ``read^2``. In simulations with
    100 or more electrons per image, the mean of chi2 is 0.96 to 1.02.
    """

    wavefront: Wavefront = field(repr=False)
    twin: Wavefront | None = field(repr=False)
    pupil: Pupil = field(repr=False)
    coefficients: dict[Name, float]
    errors: dict[Name, Any]
    covariance: Array
    units: dict[Name, str]
    chi2: float
    flux: Array
    background: Array
    center: Array
    psf: PSF = field(repr=False)
    blurs: tuple[tuple[Blur, ...], ...]
    blur_errors: tuple[tuple[float, ...], ...]
    images: Array = field(repr=False)
    model: Array = field(repr=False)
    residual: Array = field(repr=False)
    steps: int = 0
    starts: int = 0
    _checked: Callable[[], Retrieval] | None = field(default=None, repr=False)

    def checked(self) -> Retrieval:
        """Return the fit with all checks, which ``checks=False`` omits: the result of ``checks=True``.

        Returns
        -------
        Retrieval
            The fit itself if it has been checked. Otherwise a new one, whose coefficients and standard errors allow
            for effects that the model lacks; those of this fit stay as they are.
        """
        return self if self._checked is None else self._checked()

    def in_unit(self, unit: str) -> tuple[dict[Name, float], dict[Name, float]]:
        """Return the coefficients of the wavefront and their standard errors in another unit.

        Parameters
        ----------
        unit : str
            "radians", "waves", "metres" or another length such as "nm". Lengths require the wavelength of the pupil.
            Zernike terms are rms values, as in `coefficients`. "defocus" is C_d in radians; in other units it is
            W020, the path difference 2 C_d between centre and edge, as "spherical" is W040.

        Returns
        -------
        coefficients, errors : dict of name to float

        Raises
        ------
        ValueError
            If `unit` is unknown, or the pupil has no wavelength.
        """
        factor = radians_per(unit, self.pupil.wavelength)
        terms = [name for name in self.coefficients if _is_term(name)]
        factors = {name: 2.0 / factor if name == "defocus" and unit != "radians" else 1.0 / factor for name in terms}
        errors = {name: self.errors[name] * factors[name] for name in terms}
        return {name: self.coefficients[name] * factors[name] for name in terms}, errors

    def save(self, path: str | PathLike[str]) -> None:
        """Write the wavefront as a table of Noll's terms, waves rms, with standard errors of the estimated terms.

        :func:`lommel.load_zernike` reads the file; see :func:`lommel.save_zernike`.

        Parameters
        ----------
        path : path
            Path of the file, ending in .json, .toml or .csv.

        Raises
        ------
        ValueError
            If the suffix is unknown.
        OSError
            If the file cannot be written.
        """
        table = zernike_tables.ZernikeTable.from_wavefront(self.wavefront, wavelength=self.pupil.wavelength)
        terms = {name: term for name in self.coefficients if (term := term_of(name)) is not None}
        errors = {
            int(zernike.index_of(*term, "noll")): self.errors[name] / (2.0 * np.pi) for name, term in terms.items()
        }
        zernike_tables.save_table(path, table, errors)

    def plot(self, *, unit: str = "radians", names: Sequence[str] | None = None) -> Figure:
        """Return a matplotlib figure of images, model, residual and coefficients with their standard errors.

        Parameters
        ----------
        unit : str
            Unit of the coefficients, see :meth:`in_unit`.
        names : sequence of str, optional
            Names of the images; by default their numbers.

        Returns
        -------
        matplotlib Figure

        Raises
        ------
        ValueError
            If `unit` is unknown, or the pupil has no wavelength.
        ImportError
            If matplotlib is not installed.
        """
        labels = [label(name) for name in self.coefficients if _is_term(name)]
        values, errors = (list(part.values()) for part in self.in_unit(unit))
        titles = [f"image {k}" for k in range(len(self.images))] if names is None else list(names)
        bars = labels, values, errors, unit
        return show.estimates.fit(self.images, self.model, self.residual, bars, f"chi2 = {self.chi2:.3g}", titles)

    def _repr_html_(self) -> str:
        rows = [("fit", self.message), ("chi2", f"{self.chi2:.4g} per degree of freedom")]
        return show.notebook.retrieval(self.images, self.model, rows + self._rows("±"))

    def __repr__(self) -> str:
        return self._shown([f"{name}: {value}".rstrip() for name, value in self._rows("+-")])

    def _rows(self, sign: str) -> list[tuple[str, str]]:
        values = self.coefficients.items()
        return [(label(n), f"{c:.4g} {sign} {self.errors[n]:.2g} {self.units[n]}") for n, c in values]


@listed(RetrieveOptions)
def retrieve(
    images: ArrayLike | Counts | Sequence[ArrayLike],
    pupil: Pupil,
    *,
    pixel: float,
    noise: Noise | None = None,
    options: RetrieveOptions | None = None,
    **given: Any,
) -> Retrieval:
    """Estimate the wavefront of a lens from star images (phase retrieval).

    Several images at known defoci have the same wavefront (phase diversity). The wavefront is estimated jointly with
    the flux and the background of each image. For the beads of a microscope, use :func:`lommel.fit_beads`.

    Parameters
    ----------
    images : array_like or Counts, shape (height, width) or (n, height, width), or a sequence of (height, width)
        Recorded images, linear in the light, with the gain and offset of `noise`. NaN, infinite and masked values are
        left out, and so are saturated pixels of integer images. :class:`lommel.Counts` state a mask and a saturation.
    pupil : Pupil
        Single pupil (no stack): aperture, scale and initial wavefront. Phases of segments and masks are fixed.
    pixel : float
        Pixel pitch, in metres if the pupil has a wavelength, else in units of lambda*N.
    noise : Noise, optional
        Gain, offset and read noise of arrays; :class:`lommel.Counts` have their own.
    options : RetrieveOptions, optional
        Options in one object; keywords change single ones.
    {options}

    Returns
    -------
    Retrieval
        The best fit; check `converged`, `reliable` and `message` before use.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, an image is constant, or too few pixels are valid.

    Notes
    -----
    Fisher scoring with the damping of Levenberg and Marquardt maximizes the likelihood of ``y + read^2 ~ Poisson(mu +
    read^2)`` for y recorded electrons (Snyder et al. 1993, doi:10.1364/JOSAA.10.001014); ``mu = flux h + background``
    are the expected electrons and h is the PSF. Random restarts end when the chi2 of a fit is so small that noise
    exceeds it in at least one of 1000 correct fits. They also end when noise exceeds it in at least one of 10^4
    correct fits and three starts have ended within the standard errors of the lowest minimum, or five starts whatever
    its chi2. The best fit of all
    starts is accepted below the second limit.

    Standard errors are the Cramér-Rao bound at the estimate, increased for undetected effects (below). They are valid
    if images are linear in the parameters within the standard errors. Images of dim stars on a background are not
    linear: other wavefronts may have the same chi2. In a test, 900 random wavefronts of 0.3 and 0.7 radians rms were
    estimated (15 terms; three images of 25 x 25 pixels at C_d -4, 0, 4; 500 to 10^5 electrons in each image; 0, 5 and
    20 electrons of background per pixel; read noise of 2 electrons). A parameter was in error by more than four
    standard errors in 4 of 633 reliable fits, and in 31 of 185 doubtful fits. With 10^4 electrons or more no fit was
    doubtful. For wavefronts of 3 radians rms a fit may converge to an entirely different wavefront.

    Images at one defocus, through an aperture with two-fold symmetry, do not change if the even part of the phase
    changes sign, ``Phi(x) -> -Phi(-x)``. Phase diversity (several known defoci) removes this ambiguity (Gonsalves
    1982, doi:10.1117/12.7972989; Paxman et al. 1992, doi:10.1364/JOSAA.9.001072). With a single defocus, the
    wavefront nearer to that of `pupil` is returned; at equal distances, the one whose first even term is positive.

    Score tests (Rao, doi:10.1017/S0305004100023987) search for effects that the model lacks: Zernike terms of the
    next two radial orders (rotationally symmetric terms: four); zones and ripples of higher orders; blur; slopes of
    the background; nonlinear gain; another f-number, obscuration or amplitude at the pupil edge; uneven pupil
    illumination (linear in x or y, or with two to four folds); decentred obscuration; non-circular edge; different
    scales along x and y; charge transfer delay; terms that differ between images; scale of the defoci; defocus of
    each image (for three or more images).

    Some effects are always marginalized: `coefficients` and `errors` allow for them, `model` does not. Their prior
    standard deviations are: slopes of the background (1 electron per pixel), uneven illumination (2 % of the
    amplitude at the edge if linear, 1 % otherwise), decentring of the obscuration (0.01 pupil radii), ellipticity of
    the edge (0.5 %), scales (0.3 %), delayed charge (0.25 %), zones and ripples (0.02 radians rms each), f-number
    (1 %), obscuration (0.015), scale of the defoci (2.5 %). Effects that the images favour but that are not
    significant (Bayes factors above 1) are marginalized with the uncertainty of the tests.

    A significant effect is estimated where a model can, in a second fit from the first one (at most two in turn): a
    Zernike term, f-number, obscuration, scale of the defoci, defocus of one image, change of a term over the images,
    blur, apodization or slopes of the background. The finding "estimated" states its value, error and the value that
    was stated; `errors` allow for effects that explain the images as well. Other significant effects are graded
    ("other_explanation"). Allowing for an effect changes coefficients by `move`; answers that allow for different
    effects differ by `rest` (both in standard errors); it leaves chi2 at `left`. The finding is a note if `rest` < 1,
    `move` < 3 and noise explains `left`. It is an error if noise does not, or `rest` > 3, otherwise a doubt; errors
    include `rest`. Stripes, and offsets of rows or columns, that noise alone causes in fewer than one of
    1000 fits are also doubts ("pattern"). If the images have a single defocus, or blur masks the f-number, the
    finding "untested" lists the coefficients that an error of the known defocus or f-number would change. A wrong
    sign of all known defoci negates the even terms and cannot be detected.

    Bright stars show errors of any model. Where no effect above explains a misfit, the residuals are modelled as a
    random process: in proportion to the light, smoothed by a few pixels, and correlated between adjacent pixels. Its
    size and correlation length are determined by restricted maximum likelihood, and `coefficients` and `errors` are
    those of generalized least squares, increased to the scatter of fits without one of eight sectors of each image
    or, if more than 5 % of the light is missed, to errors of the fit without this step. The misfit is then the doubt
    "missed_light". It remains an error if more than 30 % of the light is missed, if errors exceed 0.5 radians rms
    (with `blur`, 5 % of a known C_d above 10), or below ten pixels per parameter. It is a note, and so is
    "other_explanation", if less than 3 % of the light is missed, in proportion to the light (not as of a ghost beside
    the star). An error of the model that resembles a term is in no residual: the errors hold for changes between
    exposures of one instrument. Of stars 1.5 waves or more out of focus the doubt states by how much such an error
    may move each term in all exposures ("shared" of its numbers, radians rms): as much as changes the light by what
    is missed, missed C_d / 8.5. It is not part of `errors`.

    Examples
    --------
    >>> import lommel as lm
    >>> import numpy as np
    >>> noise = lm.Noise(read=2.0)
    >>> true = lm.Wavefront.zernike({5: 0.4, 8: -0.3}, order="noll")
    >>> defocused = lm.Pupil(true + lm.Wavefront(defocus=[-4.0, 0.0, 4.0]))
    >>> stars = noise.record(1e5 * lm.psf(defocused, shape=33, pixel=0.5).values + 5.0, seed=1)
    >>> fit = lm.retrieve(stars, lm.Pupil(), pixel=0.5, noise=noise, defocus=[-4, 0, 4], terms=["noll 5", "noll 8"])
    >>> fit.converged, abs(fit.coefficients["noll 5"] - 0.4) < 0.01
    (True, True)
    """
    return fit_stars(images, pupil, pixel=pixel, noise=noise, options=RetrieveOptions.of("retrieve", options, given))


def fit_stars(
    images: Any,
    pupil: Pupil,
    *,
    pixel: float,
    noise: Noise | None,
    options: RetrieveOptions,
    effort: Effort = EFFORT,
) -> Retrieval:
    """Return the wavefront of a lens from star images, see :func:`lommel.retrieve`.

    Where the model does not fit, two defoci after the others are exchanged.
    """

    def fitted(options: RetrieveOptions, effort: Effort) -> Retrieval:
        return _fit_in_order(images, pupil, pixel=pixel, noise=noise, options=options, effort=effort)

    result = fitted(options, effort)
    if not options.checks or result.reliable or (result.converged and "missed_light" not in result.findings.codes):
        return result
    excess, found = _MOST_EXCESS * (result.chi2 - 1.0), list[Finding]()
    for i, j, defoci in _exchanges(options.defocus, result.coefficients):
        with suppress(Declined, ToleranceError):
            given = replace(options, defocus=defoci, checks=False, progress=None)
            chi2 = fitted(given, effort._replace(starts=1)).chi2
            if chi2 - 1.0 < excess:
                text = (
                    f"with the defocus of images {i + 1} and {j + 1} exchanged, chi2 is {chi2:.3g} instead of "
                    f"{result.chi2:.3g}: state the defocus in the order of the images, as all terms are wrong"
                )
                excess, found = chi2 - 1.0, [Finding("exchanged", "doubt", text, {"chi2": chi2, "images": [i, j]})]
    return replace(result, findings=Findings([*found, *result.findings])) if found else result


def _exchanges(defoci: tuple[float, ...], names: Iterable[Name]) -> Iterator[tuple[int, int, tuple[float, ...]]]:
    """Yield two images and the defoci with theirs exchanged, unless that is a common change of sign.

    If `names` have the common defocus, it makes up for a difference.
    """
    is_free = any(name == "defocus" or term_of(name) == (2, 0) for name in names)
    for i, j in itertools.combinations(range(len(defoci)), 2) if len(defoci) <= _MOST_EXCHANGED else ():
        changed = list(defoci)
        changed[i], changed[j] = changed[j], changed[i]
        sums = np.add(defoci, changed)
        if defoci[i] != defoci[j] and np.any(sums != (sums[0] if is_free else 0.0)):
            yield i, j, tuple(changed)


def _fit_in_order(
    images: Any, pupil: Pupil, *, pixel: float, noise: Noise | None, options: RetrieveOptions, effort: Effort
) -> Retrieval:
    """Return the wavefront from star images with the defoci in the order that is stated."""
    unknowns = Unknowns(options.terms, options.also)
    counts = checked_images(images, noise)
    noise = counts.known_noise()
    values, valid = counts.filled(), counts.known
    start = _checked_pupil(pupil, unknowns)
    poisson = noise.poisson
    electrons, read = poisson.electrons(values), poisson.variance(np.zeros_like(values))
    defoci = known_defocus(options.defocus, len(values), "images")
    draw = random_numbers(options.seed)
    pixel = in_unit("pixel", pixel, pupil.unit)
    if pupil.wavelength is not None:
        tell_sizes(counts.metadata, pixel)
    plan = cached_plan(values.shape[1:], pixel, tol=effort.tol, integrate=effort.integrate, threads=effort.threads)
    fit_blurred = partial(_fit_blurred, counts, noise, plan, pixel, draw)
    has_fields = {*unknowns.places} == {*SHIFTS} and not unknowns.pupil
    if options.blur is not False:
        if not has_fields:
            raise ValueError(
                f"blur must be False with also={validation.shown(options.also)}: it is fitted with center alone"
            )
        return fit_blurred(options, effort, start, blur=options.blur)
    model = StarImages(electrons, read, valid, start, defoci, unknowns, plan, pixel)
    if model.degrees_of_freedom < 1:
        raise ValueError(
            f"images must have more pixels than there are unknowns, {model.size}, got {int(valid.sum())} valid pixels"
        )
    fit, extent = _search(model, draw, Progress(options.progress), effort)
    # Effects that only field fits estimate: from the answer, without restarts.
    blurred = partial(fit_blurred, replace(options, progress=None), effort._replace(starts=1)) if has_fields else None
    return _build_retrieval(fit, counts, noise, extent, checks=options.checks, blurred=blurred)


def _fit_blurred(
    counts: Counts, noise: Noise, plan: Plan, pixel: float, draw: np.random.Generator, options: RetrieveOptions,
    effort: Effort, pupil: Pupil, *, blur: Any,
) -> Retrieval:  # fmt: skip
    """Return the fit to images with the option `blur`: the field fit to a single star."""
    height, width = counts.values.shape[1:]
    given = {name: getattr(options, name) for name in ("terms", "defocus", "progress")}
    window = np.where(counts.known, counts.filled(), np.nan)[None]
    star = Targets(windows=window, places=[[height // 2, width // 2]], shape=(height, width), noise=noise)
    field_options = FieldFitOptions(degree=0, blur=blur, **given)
    field_fit = fit_targets(star, pupil, pixel=pixel, options=field_options, effort=effort, draw=draw)
    return _build_blurred_retrieval(field_fit, counts, noise, plan, pixel, pupil)


def _search(
    model: StarImages, draw: np.random.Generator, report: Report, effort: Effort
) -> tuple[_StarFit, tuple[int, int]]:
    """Return the best fit, and the numbers of steps and starts.

    The search ends when noise explains chi2, when three starts agree within the standard errors (five if noise does
    not explain chi2), or after the last start.
    """
    starts, steps = effort.starts, effort.steps
    centroid_starts = _centroid_starts(model)
    best_scores: Scores | None = None
    best_x, best_settled, end_points = centroid_starts[:1], False, centroid_starts[:0]
    tried_starts, step_count = 0, 0
    while tried_starts < starts:
        stack_size = 1 if tried_starts == 0 or model.unknowns.pupil else min(_STACKED_STARTS, starts - tried_starts)
        x = _random_starts(model, centroid_starts, draw, stack_size, tried_starts)

        try:
            x, scores, settled, steps_taken = search_rows(model, x, steps, report, fast=True)
        except (Declined, ToleranceError):  # a random start that is too strong to be computed
            if tried_starts == 0:
                raise
            tried_starts += stack_size
            continue
        # A start that has not settled is preferred only if its chi2 is less than half of the chi2 of settled starts.
        k = int(np.argmin(np.where(settled, scores.chi2, 2.0 * scores.chi2)))
        if best_scores is None or scores.chi2[k] < best_scores.chi2[0]:
            best_scores, best_x = Scores(*(part[[k]] for part in scores)), model.nearest(x[[k]])
            best_settled = bool(settled[k])
        tried_starts, step_count = tried_starts + stack_size, step_count + steps_taken
        if settled[k] and scores.chi2[k] < largest_plausible_chi2(scores.spread[k], SURE):
            break
        # Noise alone may cause a chi2 above the limit: the fit is accepted if starts agree within standard errors.
        end_points = np.concatenate([end_points, model.nearest(x[settled])])
        distances = end_points - best_x
        # Starts agree if their distance, in the metric of the information matrix, is less than one standard error.
        is_agreeing = np.einsum("si,ij,sj->s", distances, best_scores.information[0], distances) < 1.0
        is_plausible = best_scores.chi2[0] < largest_plausible_chi2(best_scores.spread[0])
        if best_settled and is_agreeing.sum() >= (_MIN_AGREEING if is_plausible else _MIN_AGREEING_MISFITS):
            break
    max_steps = steps if best_settled else 0
    best_x, best_scores, settled, last_steps = search_rows(model, best_x, max_steps, lambda *_: None, fast=False)
    fit = _StarFit(model, best_x, best_scores, best_settled and bool(settled[0]))
    return fit, (step_count + last_steps, tried_starts)


def _checked_pupil(pupil: Pupil, unknowns: Unknowns) -> Pupil:
    """Return the pupil if its wavefront can be retrieved; TypeError or ValueError otherwise."""
    if single(pupil, "shared by all images").mask is not None and "obscuration" in unknowns.pupil:
        raise ValueError(
            'also must be without "obscuration" for a pupil with a mask: derivatives are not available; measure the '
            "obscuration from an image out of focus"
        )
    if (pupil.segmented or pupil.phase_mask) and "wavelength" in unknowns.pupil:
        raise ValueError(
            'also must be without "wavelength" for a pupil with phases of segments or of a mask: derivatives are not '
            "available"
        )
    if pupil.wavelength is None and {"f_number", "wavelength"} & {*unknowns.pupil}:
        raise ValueError(f"also must be without {unknowns.pupil[0]} where pupil has no wavelength and f_number")
    return pupil


def checked_images(images: Any, noise: Noise | None) -> Counts:
    """Return the validated images of a star, with shape (n, height, width)."""
    counts = counts_of("images", images, noise, sides=(2, 3), shape="(height, width) or (n, height, width)")
    counts = counts if counts.values.ndim == 3 else counts[None]
    counts.require_known("images").require_light("images", "a star")
    return counts


def _centroid_starts(model: StarImages) -> Array:
    """Return two starts, (2, p): with the star of each image at its centroid, and in the middle of the window."""
    x = np.zeros((2, model.size))
    x[:, model.wave_columns] = model.start
    for column, name in enumerate(model.unknowns.pupil, model.pupil_columns.start):
        # The derivative by the obscuration vanishes at obscuration 0: the initial value is at least 0.1.
        x[:, column] = max(getattr(model.pupil, name), 0.1 if name == "obscuration" else 0.0)
    tilts = dict(zip(SHIFTS, model.tilt_of_pixel * centroids(model.pixel_data, model.shape).T, strict=True))
    for j, place in enumerate(model.unknowns.places):
        model.per_image(x)[0, j] = tilts[place]
    return x


def _random_starts(model: StarImages, rows: Array, draw: np.random.Generator, count: int, tried_starts: int) -> Array:
    """Return `count` starts: `rows` plus random terms; `tried_starts` is the number of earlier starts."""
    x = rows[(tried_starts + np.arange(count)) % len(rows)].copy()
    k = len(model.unknowns.terms)
    # With an ambiguous sign, derivatives by even terms vanish at even part 0: the first start must differ from it.
    if k and (tried_starts or model.sign_ambiguous):
        scatter = draw.normal(size=(count, k))
        step = np.zeros_like(x)
        step[:, model.wave_columns] = scatter
        # Scale each start to the same rms phase over the aperture for any set of terms.
        x[:, model.wave_columns] += (
            scatter * ((_SCATTER if tried_starts else 0.3 * _SCATTER) / model.rms(step))[:, None]
        )
    is_centred = (np.arange(count) + tried_starts) % len(rows) == 0
    edge = model.fixed_of_images + (x[is_centred, model.wave_columns] @ model.directions)[:, None]
    for j, shift in enumerate(model.mean_tilts(edge)):
        # Aberrations shift the centroid: subtract this shift from the tilts.
        model.per_image(x)[is_centred, j] -= shift
    return x


class _StarFit(Fit[StarImages]):
    """A fit of images of a star."""

    @cached_property
    def psf(self) -> PSF:
        """PSFs of the images."""
        return self.model.plan(self.model.pupils(self.x[0]))

    @cached_property
    def residual_parts(self) -> tuple[Array, Array, Array]:
        """Residual, variance and light of all pixels."""
        model, shape = self.model, self.psf.values.shape
        mean = model.mean(self.x, self.psf.values.reshape(1, model.count, -1))[0]
        residual, variance = np.where(model.valid > 0.0, model.counted - mean, np.nan), model.variance(mean)
        light = mean - model.per_image(self.x)[0, -1, :, None]
        return residual.reshape(shape), variance.reshape(shape), light.reshape(shape)


def _estimating(fit: _StarFit, test: ScoreTest) -> tuple[_StarFit, float] | None:
    """Return the fit that estimates the effect of `test`, and its gain of lnL; None if the model cannot."""
    if (unknowns := freed(fit.model, test.name)) is None:
        return None
    model, x = fit.model.with_unknowns(unknowns, fit.x)
    x, *_ = search_rows(model, x, _REFIT_STEPS, _no_report, fast=True)
    x, scores, ended, _ = search_rows(model, x, _REFIT_STEPS, _no_report, fast=False)
    refit = _StarFit(model, x, scores, settled=True)
    return refit, fit.deviance - refit.deviance if ended[0] else -math.inf


def _instead(rounds: Sequence[Round], count: int) -> tuple[list[Estimate], Array]:
    """Return estimates of the rivals of what was estimated, and the largest change of `count` parameters by them."""
    estimates, changes, first = list[Estimate](), np.zeros(count), rounds[0].fit.model
    for one in rounds:
        for test, other, _ in one.others:
            if test.name in rounds[-1].rivals:
                model, waves = other.model, first.wave_columns
                changes[waves] = np.maximum(changes[waves], np.abs(other.x[0, waves] - one.fit.x[0, waves]))
                column = [label(name) for name in model.names].index(test.name)
                name, pair = model.names[column], (float(other.x[0, column]), float(test.errors[0]))
                estimates.append(Estimate(test.name, *pair, model.stated[name], unit_of(name), unsure=True))
    return estimates, changes


def _no_report(step: int, chi2: float) -> None:
    """Report no progress, for short searches."""


def _is_term(name: Name) -> bool:
    """Return whether a coefficient is one of the wavefront."""
    return name in POWERS or term_of(name) is not None


def _build_retrieval(
    fit: _StarFit, counts: Counts, noise: Noise, effort: tuple[int, int], *, checks: bool,
    blurred: Callable[..., Retrieval] | None,
) -> Retrieval:  # fmt: skip
    """Return the Retrieval for a fit; `effort` are the numbers of steps and starts.

    `blurred` is the fit from a pupil by a model of fields, if the tests find what only that model estimates.

    Without `checks`, parameters are those of maximum likelihood, and errors the Cramer-Rao bound.
    """
    unchecked = Finding("unchecked", "doubt", "the fit was not checked: checked() tests it")
    rounds = rounds_of(fit, star_tests, _estimating) if checks else [Round(fit, ((), None, [unchecked]))]
    first, (last, (tests, grade, untested), *_) = fit, rounds[-1]
    model, x, inverse, common = last.model, last.x, covariance(last.scores.information[0]), last.model.common_count
    names, image_parameters, shape = model.names, model.per_image(x)[0], counts.values.shape
    light_findings = _light_findings(image_parameters[-2], np.sqrt(np.diag(inverse))[-2 * model.count : -model.count])
    findings, effect_findings, error = _fit_findings(last, tests, grade, noise)
    marginal = Marginal(np.zeros(common), inverse[:common, :common]) if grade is None else grade.marginal
    if error is not None:
        inverse = error.covariance
        marginal = Marginal(error.shift[:common], inverse[:common, :common])
    errors, common_errors = np.sqrt(np.diag(inverse)), np.sqrt(np.diag(marginal.covariance))
    shift = np.pad(marginal.shift, (0, model.size - common))[None]
    # The shift is linear in the parameters: it means nothing in a direction that the images do not determine.
    is_linear = error is not None or bool(model.rms(shift)[0] <= MAX_LINEAR_ERROR)
    corrected_x = model.within(x + shift, x) if is_linear else x
    pupil_parameters: dict[str, Any] = model.pupil_parameters(corrected_x)
    waves, doubted = first.model.wave_columns, unsure(rounds)
    moves = np.abs(corrected_x[0, waves] - first.x[0, waves])
    estimates = [
        Estimate(label(name), value, error_of_value, model.stated[name], unit_of(name), unsure=label(name) in doubted)
        for name, value, error_of_value in zip(names, corrected_x[0].tolist(), common_errors.tolist(), strict=False)
        if name not in first.model.names
    ]
    others, change = _instead(rounds, len(names))
    of_terms = [
        dict(zip(map(label, names), (part / common_errors[waves]).tolist(), strict=False))
        for part in (moves, change[waves])
    ]
    effect_findings += estimated_findings(estimates, of_terms[0], rounds[-1].rivals, others, of_terms[1])
    stated = np.array([model.stated[name] if label(name) in doubted else np.nan for name in names])
    change = np.where(np.isnan(stated), change, corrected_x[0, :common] - stated)
    common_covariance = marginal.covariance.copy()  # contains the answer with another effect, which may be the cause
    np.fill_diagonal(common_covariance, np.diag(common_covariance) + opened(change, common_errors))
    common_errors = np.sqrt(np.diag(common_covariance))
    residual, variance, light = last.residual_parts
    if checks:
        findings += goodness_of_fit.stripe_findings(residual, variance, noise.excess)
    findings = covered([*findings, *light_findings, *_sign_findings(model, x), *effect_findings, *untested])
    if not last.settled and error is None:
        text = f"the steps have not settled after {effort[0]}: estimate fewer terms, or start nearer to the wavefront"
        findings.append(Finding("not_settled", "error", text))
    sums = counts.filled().sum(axis=(1, 2))
    if not Findings(findings).converged and np.all(np.abs(sums - 1.0) < _MAX_SUM_ERROR):
        text = "the images sum to 1, as PSFs do and electrons do not: multiply them by the electrons, or pass white"
        findings.append(Finding("unit_sum", "note", text))
    # Errors that a model error determines do not follow from the information of photons.
    is_tested = checks and error is None and Findings(findings).converged
    findings += error_findings(model, x, inverse) if is_tested else []
    if not np.isfinite(errors).all():
        pairs = zip(names, errors, strict=False)
        undetermined = ", ".join(label(name) for name, error in pairs if not np.isfinite(error))
        text = f"the images do not determine {undetermined or 'all of their places, fluxes and backgrounds'}"
        findings.append(Finding("undetermined", "note", text))
    findings += recording_findings([counts[k] for k in range(model.count)], noise, "image")
    per_pixel = model.tilt_of_pixel
    if "f_number" in pupil_parameters:  # the shift due to a tilt is proportional to the f-number
        per_pixel /= pupil_parameters["f_number"] / cast("float", model.pupil.f_number)
    units = dict.fromkeys(model.unknowns.places, 1.0 / per_pixel) | dict.fromkeys(
        ("flux", "background"), noise.excess
    )
    standard_errors = errors[model.image_columns].reshape(-1, model.count)
    image_errors = {name: units[name] * row for name, row in zip(units, standard_errors, strict=True)}
    center = np.tile([float(side // 2) for side in shape[1:]], (model.count, 1))
    for j, _ in enumerate(model.unknowns.places):
        center[:, j] += image_parameters[j] / per_pixel
    wavefront, (steps, starts) = model.wavefront(corrected_x[0]), effort
    chi2 = last.quality[0]
    result = Retrieval(
        wavefront=wavefront,
        twin=model.wavefront(model.even_part_negated(corrected_x)[0]) if model.sign_ambiguous else None,
        pupil=replace(model.pupil.carrying(wavefront, None), **pupil_parameters),
        coefficients=dict(zip(names, corrected_x[0, :common].tolist(), strict=True)),
        errors=dict(zip(names, common_errors.tolist(), strict=True)) | image_errors,
        covariance=common_covariance,
        units={name: unit_of(name) for name in (*names, *image_errors)},
        chi2=chi2,
        findings=with_shared_error(findings, model.known_defoci),
        summary=f"chi2 {chi2:.3g} per degree of freedom after {steps} steps from {starts} start{'s' * (starts > 1)}",
        flux=noise.excess * image_parameters[-2],
        background=noise.excess * image_parameters[-1],
        center=center,
        psf=last.psf,
        blurs=((),) * model.count,
        blur_errors=((),) * model.count,
        images=np.where(counts.known, counts.values, np.nan),
        model=noise.poisson.image(light + image_parameters[-1][:, None, None]),
        residual=residual / np.sqrt(variance),
        steps=steps,
        starts=starts,
        _checked=None
        if checks
        else partial(_build_retrieval, fit, counts, noise, effort, checks=True, blurred=blurred),
    )
    named, is_reliable = next((test.name for test in seen(tests)), ""), error is None and result.reliable
    if blurred is None or is_reliable or last is not first or chi2 >= _GROSS_CHI2 or named not in OF_FIELDS:
        return result
    return _refit_by_fields(first, result, partial(blurred, blur=OF_FIELDS[named])) or result


def _fit_findings(
    fit: _StarFit, tests: Sequence[ScoreTest], grade: Grade | None, noise: Noise
) -> tuple[list[Finding], list[Finding], ModelError | None]:
    """Return findings on chi2 and on missing effects, and the model error if it explains a misfit.

    Without a `grade`, there are no tests, and no model error.
    """
    chi2, deviation = fit.quality
    causes = causes_of_misfit(_CAUSES, chi2, deviation, tests)
    findings = goodness_of_fit.chi2_findings(chi2, deviation, causes)
    effects = missing_findings(tests, grade, [label(name) for name in fit.model.names])
    if effects and grade is not None and grade.explained:
        findings = [finding for finding in findings if finding.code == "too_quiet"]
    elif causes and "misfit" in Findings(findings).codes:  # no effect explains half of it: none is named
        effects = []
    findings += goodness_of_fit.spot_findings(findings, *fit.residual_parts)
    read = fit.model.read.reshape(fit.residual_parts[0].shape)
    findings, effects = with_noise(findings, effects, fit.residual_parts, read, noise.excess)
    error = None if grade is None else fit.valid_model_error(Findings(findings).codes, tests)
    if error is None:
        return findings, effects, None
    named = [] if causes else missing_findings(tests, None, ())
    return with_errors_of_model(findings, *fit.residual_parts, causes), named, error


def _refit_by_fields(first: _StarFit, result: Retrieval, blurred: Callable[[Pupil], Retrieval]) -> Retrieval | None:
    """Return the fit by the model of fields, from `result`, if it explains more; the note of what it estimates."""
    refit = result
    with suppress(Declined, ToleranceError, ValueError):  # windows that are too small for the model of fields
        refit = blurred(result.pupil)
    if not refit.converged or refit.chi2 >= result.chi2:
        return None
    widths, pixel = list[Estimate](), first.model.pixel
    for k, image in enumerate(zip(refit.blurs, refit.blur_errors, strict=True), 1):
        for width, error in zip(*image, strict=True):
            if isinstance(width, Jitter) and error > 0.0:  # not NaN
                widths.append(Estimate(f"blur of image {k}", width.sigma / pixel, error / pixel, 0.0, "pixels"))
            elif isinstance(width, Seeing):
                widths.append(Estimate(f"r0 of seeing of image {k}", width.r0, error, np.inf, "m"))
    terms = zip(first.model.unknowns.terms, first.x[0].tolist(), strict=False)
    moves = {label(name): abs(refit.coefficients[name] - value) / refit.errors[name] for name, value in terms}
    return replace(refit, findings=Findings([*refit.findings, *estimated_findings(widths, moves)]))


def _build_blurred_retrieval(
    field_fit: FieldFit, counts: Counts, noise: Noise, plan: Plan, pixel: float, pupil: Pupil
) -> Retrieval:
    """Return the Retrieval for `field_fit`, a field fit to a single star with blurred images."""
    errors = np.sqrt(np.diag(field_fit.covariance))
    wavefront = field_fit.field.pupil(0.0, 0.0).wavefront
    star, mean = field_fit.stars, field_fit.model[0]
    center, (row_errors, column_errors) = star.centers[0], star.center_errors[0].T
    image_errors: dict[Name, Any] = {"row": row_errors, "column": column_errors}
    image_errors |= {"flux": star.flux_errors[0], "background": star.background_errors[0]}
    pupil = field_fit.field.pupil(0.0, 0.0).carrying(pupil.wavefront, None)  # with what the images favoured
    fitted_pupil, defocus = pupil.carrying(wavefront, None), np.array(field_fit._defocus)
    # Tilts shift the PSFs to the positions of the star.
    tilts = np.pi * pixel / pupil.scale * (center - np.array(counts.values.shape[1:]) // 2).T
    edge_tilts = dict(zip(SHIFTS.values(), tilts, strict=True))
    edge = fitted_pupil.wavefront + Wavefront.zernike(edge_tilts, normalization="edge")
    return Retrieval(
        wavefront=wavefront,
        twin=None if field_fit.twin is None else field_fit.twin.pupil(0.0, 0.0).wavefront,
        pupil=fitted_pupil,
        coefficients=dict(zip(field_fit.names, field_fit.coefficients[:, 0].tolist(), strict=True)),
        errors=dict(zip(field_fit.names, errors.tolist(), strict=True)) | image_errors,
        covariance=field_fit.covariance,
        units={name: unit_of(name) for name in (*field_fit.names, *image_errors)},
        chi2=field_fit.chi2,
        findings=with_shared_error(field_fit.findings, defocus),
        summary=f"chi2 {field_fit.chi2:.3g} per degree of freedom",
        flux=star.flux[0],
        background=star.background[0],
        center=center,
        psf=plan(pupil.carrying(edge + Wavefront(defocus=defocus), None)),
        blurs=field_fit.blurs,
        blur_errors=field_fit.blur_errors,
        images=np.where(counts.known, counts.values, np.nan),
        model=noise.image(mean),
        residual=(field_fit.images[0] - mean) / np.sqrt(np.maximum(noise.variance(np.maximum(mean, 0.0)), 1e-9)),
    )


def _light_findings(flux: Array, errors: Numbers) -> list[Finding]:
    """Return the finding on the image of lowest signal-to-noise ratio, if its flux is within the noise."""
    significance = flux / errors
    k = int(np.argmin(significance))
    text = f"the flux of image {k} is within the noise"
    return [] if significance[k] >= _MIN_SIGNIFICANCE else [Finding("no_light", "error", text, {"image": k})]


def _sign_findings(model: StarImages, x: Array) -> list[Finding]:
    """Return the finding that the images do not determine the sign of the even terms."""
    if not model.sign_ambiguous:
        return []
    start = np.pad(model.start, (0, model.size - len(model.start)))
    twins = x, model.even_part_negated(x)
    distance, other_distance = (float(model.rms(parameters - start)[0]) for parameters in twins)
    text = "images at a single defocus do not determine the common sign of the even terms"
    numbers = {"rms": distance, "rms_of_other": other_distance}
    if other_distance >= _MIN_DISTANCE_RATIO * distance:
        text += ": the wavefront nearer to the given wavefront and defocus was chosen"
        return [Finding("sign_open", "note", text, numbers)]
    return [
        Finding("sign_open", "doubt", f"{text}: add a second defocus, or a pupil with a similar wavefront", numbers)
    ]
