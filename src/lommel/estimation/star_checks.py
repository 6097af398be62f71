"""Checks of fits to star images: score tests of effects missing from the model, and validity of standard errors."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any, NamedTuple, cast

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.base.units import with_error
from lommel.core.answers import Declined, ToleranceError
from lommel.estimation.favoured_effects import Fit
from lommel.estimation.sampled_pupil import ASPECT, FOLDS, OBSCURATION, OVAL, SHIFT, SLANT, changes_of
from lommel.estimation.star_images import (
    NO_WIDTHS,
    OF_PUPIL,
    Phase,
    StarImages,
    Unknowns,
    error_factors,
    label,
    next_terms,
    pixel_coordinates,
    ripple_terms,
    too_dim_findings,
    uncertainty,
)
from lommel.fit.findings import Finding
from lommel.fit.score_tests import (
    Candidate,
    Grade,
    ScoreTest,
    favoured,
    graded,
    graded_explanation,
    other_explanation,
    score_tests,
    seen,
    untested,
    untested_findings,
)
from lommel.methods.derivative_names import Name, Term
from lommel.optics.aperture.shapes import Polygon, Shape, Spider
from lommel.optics.pupil import Pupil
from lommel.psf import cached_plan
from lommel.special import zernike

# Prior standard deviations of the coefficients of effects that the model lacks.
_TERM = 0.1  # Zernike term, radians rms
_WIDTH, _WING_LIGHT = 0.1, 0.3  # variance of an additional blur, pixels^2; fraction of light in a wider blur
_WIDTH_CHANGE = 0.3  # change of the blur variance from the middle to the edge of the field, pixels^2
_SLOPE, _NONLINEAR = 1.0, 0.05  # background gradient, electrons per pixel; fraction of electrons lost at 10^4
_DEFOCI, _ONE_DEFOCUS = "defocus scale", "defocus of image "
_CONSTANTS = {"f_number": 0.02, OBSCURATION: 0.03, _DEFOCI: 0.05}  # relative; that of the obscuration is absolute
# Relative amplitude at the pupil edge (SLANT, FOLDS), pupil radii (SHIFT), relative lengths (OVAL, ASPECT).
_UNEVEN_LIGHT = {SLANT: 0.02, **dict.fromkeys(FOLDS, 0.01), SHIFT: 0.01, OVAL: 0.005, ASPECT: 0.003}
_VANE_ANGLE = 2.0  # degrees
_TRAIL = 0.01  # fraction of the charge that is deferred
_DRIFT = 0.03  # half the change of a Zernike term from the first to the last image, radians rms
_RIPPLES = 0.1  # all ripples of the wavefront together, radians rms
_DEFOCUS = 0.1  # defocus of one image, radians at the pupil edge
# Factors by which prior standard deviations are reduced for marginalization if the data do not favour the effect.
_CONSTANT_FACTOR, _TRAIL_FACTOR, _RIPPLE_FACTOR = 0.5, 0.25, 0.2
_TRAIL_DECAY, _TRAIL_LENGTH = 2.0, 8  # trail of deferred charge: decay to 1/e and length, pixels
_STATED_ERROR = 0.01  # relative error of a stated number for which the bias of the estimates is reported
VANES = "vanes turned about the axis"
_UNITS = {
    "f_number": "", OBSCURATION: "", "wavelength": "m", _DEFOCI: "", "apodization": "", VANES: "degrees",
    "blur": "pixels", "r0 of seeing": "m",
    "row": "pixels", "column": "pixels", "flux": "electrons", "background": "electrons/pixel",
}  # fmt: skip
DRIFTS = " that changes over the images"
_MAX_FOCI = 9  # largest number of images whose defoci are tested one by one
# Standard error of the phase, radians rms, above which the likelihood often has other maxima that are equally high.
_MAX_PHASE_ERROR = 0.25
# Largest factor by which a valid standard error may change within one standard deviation of the estimate.
_MAX_ERROR_CHANGE = 1.125
APODIZED = 0.1  # apodization coefficient g: the amplitude is exp(-g) at the pupil edge
_TURNED = 0.5  # angle of vanes in differences of images, degrees
_OBSCURED = 0.01  # change of an obscuration in differences of images, pupil radii
_GAUSSIAN, ELLIPSE, _WINGS, _HALO = "blur by a Gaussian besides", "blur in one direction", "wings", "halo"
_UNEVEN = "blur that varies over the field"
TRAIL = "trail"
BLURS = (_GAUSSIAN, ELLIPSE, _WINGS, _HALO)
GRADIENT = "background gradient"
#: Effects of a single star that only the model of fields estimates, and whether this requires blur.
OF_FIELDS = {**dict.fromkeys(BLURS, True), "apodization": False, GRADIENT: False}
_TRAILS = {
    name: f"charge that arrives late in {name}"
    for name in ("higher rows", "lower rows", "higher columns", "lower columns")
}
_ZONE_NAME, _RIPPLE_NAME = "zones of the wavefront", "ripples of the wavefront"
NUISANCES = (*_UNEVEN_LIGHT, *_TRAILS.values(), GRADIENT)
"""Effects that no fit estimates. They bias estimates even if they are too weak to be detected in the images."""
_GAIN = "non-linear gain"
_FOCI = (
    "the sign of the stated defocus (reversed, as by foci exchanged, the images agree as well, and even terms have "
    "the other sign)"
)
_DESCRIPTIONS = {
    _GAUSSIAN: ("variance of an additional Gaussian blur", " pixels^2"),
    ELLIPSE: (
        "elliptical blur, for example from tracking or wind: (variance along rows - along columns) / 2, covariance",
        " pixels^2",
    ),
    _WINGS: ("wings of the blur: fraction of light in a blur of twice the width", ""),
    _HALO: ("a halo of the blur: fraction of light in a blur of four times the width", ""),
    _UNEVEN: ("blur that varies over the field: change of variance over half the field, columns, rows", " pixels^2"),
    GRADIENT: ("background gradients", ""),
    _ZONE_NAME: ("zones of the wavefront, for example from polishing", ""),
    _RIPPLE_NAME: ("ripples of the wavefront, finer than the tested terms", ""),
    _GAIN: ("non-linear gain: fraction of electrons that is lost at 10^4", ""),
    SLANT: ("light that slopes across the pupil as exp(-a y - b x): a, b", ""),
    SHIFT: ("a decentred obscuration: rows, columns", " radii"),
    **{name: (f"{name}: amplitude at the edge by cosine and sine", "") for name in FOLDS},
    VANES: (f"{VANES}, by a linear estimate", " degrees"),
    ASPECT: ("an image that is longer along y and shorter along x than stated: relative change", ""),
    OVAL: ("an aperture that is not round, with the radius 1 + s cos 2t + u sin 2t: s, u", ""),
    **{name: (f"{name}: fraction", "") for name in _TRAILS.values()},
    "f_number": ("another f-number: its difference from the stated one", ""),
    OBSCURATION: ("another obscuration: its difference from the stated one", ""),
    _DEFOCI: ("known defoci of another scale than stated: relative change", ""),
    "apodization": ("an amplitude that falls towards the edge of the pupil, by exp(-g rho^2), g", ""),
}


class MissingEffect(NamedTuple):
    """An effect that the model may lack, in electrons.

    `scale` is the prior standard deviation of its coefficients; `images` are derivatives of the expected electrons
    with respect to each coefficient.
    """

    name: str
    scale: float
    images: tuple[Array, ...]


def _time(exposures: int) -> Array:
    """Return the times of exposures, -1 to 1."""
    return np.linspace(-1.0, 1.0, exposures)


def changed_pupils(pupil: Pupil) -> dict[str, tuple[Pupil, float]]:
    """Return pupils with more apodization or obscuration, and the changes, for effects tested by differences."""
    pupils = dict[str, tuple[Pupil, float]]()
    if isinstance(pupil.apodization, float):
        pupils["apodization"] = replace(pupil, apodization=pupil.apodization + APODIZED), APODIZED
    if pupil.obscuration and OBSCURATION not in changes_of(pupil):
        change = min(_OBSCURED, 0.5 * (1.0 - pupil.obscuration))
        pupils[OBSCURATION] = replace(pupil, obscuration=pupil.obscuration + change), change
    if pupil.strips is not None:
        pupils[VANES] = _turned(pupil, _TURNED), _TURNED
    return pupils


def _turned(pupil: Pupil, degrees: float) -> Pupil:
    """Return the pupil with its vanes turned about the axis."""
    angle, spider, stop = math.radians(degrees), pupil.spider, pupil.stop
    spider = spider and Spider(spider.width, tuple(a + angle for a in spider.angles))
    return replace(pupil, spider=spider, stop=stop.turned(angle) if isinstance(stop, Shape) else stop)


def _vane_angle(pupil: Pupil) -> float:
    """Return the direction of the first vane, degrees."""
    if pupil.spider is not None:
        return math.degrees(pupil.spider.angles[0])
    parts = pupil.stop.parts if isinstance(pupil.stop, Shape) else ()
    corners = next(part.corners for part in parts if isinstance(part, Polygon))
    return math.degrees(math.atan2(corners[-1][1], corners[-1][0]))


def tested_names(star: StarImages) -> tuple[tuple[Term, ...], tuple[Name, ...], tuple[Term, ...]]:
    """Return the terms, constants and ripples to test; the scale of known defoci that differ is named (2, 0)."""
    unknowns, pupil = star.unknowns, star.pupil
    constants: tuple[Name, ...] = ((2, 0),) if np.ptp(star.known_defoci) > 0.0 else ()
    if pupil.wavelength is not None and not {"f_number", "wavelength"} & {*unknowns.pupil}:
        constants = ("f_number", *constants)
    return next_terms(unknowns.stated, unknowns.edge), constants, ripple_terms(unknowns.stated)


def missing_effects(
    star: StarImages, electrons: Array, mean: Array, slopes: Sequence[Array], term_slopes: Iterable[Array],
    illumination: Iterable[Array], differences: Mapping[str, Array], blurs: Mapping[str, Array], blurred: int, *,
    gaussian: bool, gradients: bool = True,
) -> list[MissingEffect]:  # fmt: skip
    """Return the effects that the model of r stars in e exposures may lack; images have the shape (r * e, ...).

    `electrons` are those of the stars alone, and `mean` all expected electrons. `slopes` are derivatives of electrons
    by `tested_names`, `term_slopes` by the Zernike terms of the fit (both radians at the pupil edge),
    `illumination` by `changes_of` the pupil, and `blurs` by additional blurs of `blurred` groups of exposures.
    `differences` are derivatives from `changed_pupils`.
    """
    effects, unknowns, defoci, (terms, constants, ripples) = [], star.unknowns, star.known_defoci, tested_names(star)
    exposures, first_ripple = len(defoci), len(terms) + len(constants)

    def add(name: str, scale: float, *images: Array) -> None:
        effects.append(MissingEffect(name, scale, images))

    for term, slope in zip(terms, slopes, strict=False):
        add(label(term), _TERM, slope * zernike.rms_factor(*term))
    for name, slope in zip(constants, slopes[len(terms) : first_ripple], strict=True):
        if name == "f_number":
            add(name, _CONSTANTS[name] * float(star.pupil.f_number or 1.0), slope)
            continue
        # The scale of the known defoci; the derivative is by the defocus.
        add(_DEFOCI, _CONSTANTS[_DEFOCI], slope * np.tile(defoci, len(slope) // exposures)[:, None, None])
        # Of two images, the scale and single defoci differ only in the common defocus.
        if exposures <= _MAX_FOCI:
            for k, image in enumerate(of_each_exposure(exposures, slope)):
                add(f"{_ONE_DEFOCUS}{k + 1}", _DEFOCUS, image)
    for name, is_symmetric in ((_ZONE_NAME, True), (_RIPPLE_NAME, False)):
        pairs = zip(ripples, slopes[first_ripple:], strict=True)
        images = [slope * zernike.rms_factor(*term) for term, slope in pairs if (term[1] == 0) == is_symmetric]
        if images:
            add(name, _RIPPLES / len(images) ** 0.5, *images)
    if exposures > 1:  # the coefficient is half the difference between the last and the first image, radians rms
        time = np.tile(_time(exposures), len(electrons) // exposures)[:, None, None]
        for term, slope in zip(unknowns.edge, term_slopes, strict=False):
            if exposures == 2 and term == (2, 0) and (2, 0) in constants:
                continue  # the same images as those of another scale of the defoci
            add(label(term) + DRIFTS, _DRIFT, slope * time * zernike.rms_factor(*term))
    remaining, scales = (
        iter(illumination),
        {**_UNEVEN_LIGHT, **_CONSTANTS, "apodization": APODIZED, VANES: _VANE_ANGLE},
    )
    for name, count in changes_of(star.pupil).items():
        images = [*itertools.islice(remaining, count)]
        if name not in unknowns.pupil:
            add(name, scales[name], *images)
    trail = np.exp(-np.arange(_TRAIL_LENGTH) / _TRAIL_DECAY)
    for name, axis, step in zip(_TRAILS.values(), (1, 1, 2, 2), (1, -1, 1, -1), strict=True):
        kernel = np.concatenate([np.zeros(_TRAIL_LENGTH + 1), trail / trail.sum()])[::step]
        # The deferred charge moves to pixels read out later: the sum is conserved.
        add(name, _TRAIL, scipy.ndimage.correlate1d(electrons, kernel[::-1], axis, mode="constant") - electrons)
    for name, image in differences.items():
        add(name, scales[name], image)
    if blurs:
        if gaussian:
            add(_GAUSSIAN, _WIDTH, *of_each_exposure(blurred, blurs["Gaussian"]))
        add(ELLIPSE, _WIDTH, *of_each_exposure(blurred, blurs["along rows"], blurs["oblique"]))
        add(_WINGS, _WING_LIGHT, *of_each_exposure(blurred, blurs["wings"]))
        add(_HALO, _WING_LIGHT, *of_each_exposure(blurred, blurs["halo"]))
    if gradients:
        add(GRADIENT, _SLOPE, *of_each_exposure(exposures, *pixel_coordinates(len(mean), mean.shape[1:])))
    # A pixel of m electrons loses the fraction s m / 10^4; derivative with respect to s.
    add(_GAIN, _NONLINEAR, -(mean**2) / 1e4)
    return [effect for effect in effects if effect.name not in unknowns.phases]


def uneven_blur(image: Array, positions: Array, exposures: int) -> MissingEffect:
    """Return the effect of a blur that varies over the field, for positions (r * e, 2) in half fields.

    `image` is the derivative of electrons with respect to the variance of the blur.
    """
    along_axes = (image * coordinate[:, None, None] for coordinate in positions.T)
    return MissingEffect(_UNEVEN, _WIDTH_CHANGE, of_each_exposure(exposures, *along_axes))


def of_each_exposure(exposures: int, *images: Array) -> tuple[Array, ...]:
    """Return, for each exposure, the images (r * e, height, width) set to 0 in all other exposures."""
    exposure = np.arange(len(images[0])) % exposures
    return tuple(image * (exposure == i)[:, None, None] for i in range(exposures) for image in images)


def _foci(star: StarImages) -> dict[str, Phase]:
    """Return the errors of known defoci, their common scale first, as changes of phases."""
    rows = zip(np.eye(star.count), star.known_defoci.tolist(), strict=True)
    single = {f"{_ONE_DEFOCUS}{k}": Phase((2, 0), row, c_d) for k, (row, c_d) in enumerate(rows, 1)}
    return {_DEFOCI: Phase((2, 0), star.known_defoci, 1.0), **single}


def freed(model: StarImages, name: str) -> Unknowns | None:
    """Return the unknowns of `model` and the candidate `name`; None if the model cannot estimate it."""
    unknowns = model.unknowns
    terms: dict[str, Term] = {label(term): term for term in next_terms(unknowns.stated, unknowns.edge)}
    if name in terms or (name in OF_PUPIL and (name != OBSCURATION or changes_of(model.pupil))):
        return unknowns.freeing(terms.get(name, name))
    time, phases = _time(model.count), _foci(model) if (2, 0) in unknowns.stated else {}
    phases |= {label(t) + DRIFTS: Phase(t, time * zernike.rms_factor(*t), 0.0) for t in unknowns.stated}
    return None if name not in phases or model.one_focus else unknowns.freeing(name, phases[name])


def changed(model: StarImages, name: str, size: float) -> tuple[Unknowns, Pupil, Array] | None:
    """Return unknowns, pupil and known defoci in which the constant `name` is larger by `size`, or the term is free.

    None if `name` is another effect.
    """
    unknowns, pupil, defoci = model.unknowns, model.pupil, model.known_defoci
    with suppress(ValueError):  # a value that no pupil has
        if name in (*OF_PUPIL, "apodization"):
            return unknowns, replace(pupil, **cast("Any", {name: getattr(pupil, name) + size})), defoci
        if name == VANES:
            return unknowns, _turned(pupil, size), defoci
        if (focus := _foci(model).get(name)) is not None:
            return unknowns, pupil, defoci + size * focus.weights
        if not name.endswith(DRIFTS) and (free := freed(model, name)) is not None:
            return free, pupil, defoci
    return None


def value_of(model: StarImages, name: str, stated: StarImages) -> float:
    """Return the value of a constant that `changed` supports; the scale of defoci is relative to `stated`."""
    if name == VANES:
        return (_vane_angle(model.pupil) - _vane_angle(stated.pupil) + 180.0) % 360.0 - 180.0
    if (focus := _foci(stated).get(name)) is None:
        return float(getattr(model.pupil, name))
    change = (model.known_defoci - stated.known_defoci) @ focus.weights
    return float(focus.stated + change / (focus.weights @ focus.weights))


def unit_of(name: Name) -> str:
    """Return the unit of an estimate."""
    text = str(name).split(" of image")[0]
    return "pixels" if text.startswith(TRAIL) else _UNITS.get(text, "rad")


def candidates_of(effects: Sequence[MissingEffect], first_column: int) -> list[Candidate]:
    """Return candidates of score tests for effects, whose coefficients have the columns from `first_column` on."""
    ends = itertools.accumulate((len(effect.images) for effect in effects), initial=first_column)
    columns = (tuple(range(*pair)) for pair in itertools.pairwise(ends))
    return [
        Candidate(effect.name, indices, effect.scale, positive=effect.name in _TRAILS.values())
        for effect, indices in zip(effects, columns, strict=True)
    ]


def to_marginalize(
    candidates: Sequence[Candidate], tests: Sequence[ScoreTest], kept_names: Sequence[str] = ()
) -> list[Candidate]:
    """Return the candidates to marginalize, with the prior standard deviations to use.

    Candidates that the data favour (Bayes factor above 1), candidates in `kept_names`, illumination and background
    gradients keep their prior standard deviation. For other constants, ripples and deferred charge it is reduced. All
    other candidates are left out.
    """
    factors = dict.fromkeys((*NUISANCES, *kept_names), 1.0)
    factors |= (
        dict.fromkeys(_CONSTANTS, _CONSTANT_FACTOR)
        | dict.fromkeys((_ZONE_NAME, _RIPPLE_NAME), _RIPPLE_FACTOR)
        | dict.fromkeys(_TRAILS.values(), _TRAIL_FACTOR)
    )
    factors |= dict.fromkeys(favoured(tests), 1.0)
    chosen_candidates = (candidate for candidate in candidates if candidate.name in factors)
    return [replace(candidate, scale=factors[candidate.name] * candidate.scale) for candidate in chosen_candidates]


def untested_constants(
    pupil: Pupil,
    defoci: Array,
    candidates: Sequence[Candidate],
    tests: Sequence[ScoreTest],
    fit: tuple[Array, Sequence[int]],
    unknowns: Unknowns,
    columns: Sequence[int],
    never_tested: Sequence[str] = (),
) -> list[Finding]:
    """Return the finding on stated numbers whose errors bias the fit but cannot be detected in the images.

    `fit` is the information matrix and the indices of its estimated columns. `columns` are the positions of the terms
    of `unknowns` among the estimated columns. `never_tested` lists numbers that no image can test.
    """
    names = [label(name) for name in unknowns.terms]
    scale = _STATED_ERROR * float(pupil.f_number or 1.0)
    f_number_candidates = [
        replace(candidate, scale=scale) for candidate in candidates if candidate.name == "f_number"
    ]
    effects = untested(*fit, dict(zip(names, columns, strict=True)), f_number_candidates, tests)
    if np.ptp(defoci) == 0.0 != defoci[0] and (2, 0) in unknowns.edge:
        # Images at a single focus determine only the sum of the known defocus and the estimated one.
        defocus_part = unknowns.directions[:, unknowns.edge.index((2, 0))] / np.abs(unknowns.directions).sum(axis=1)
        j = int(defocus_part.argmax())
        bias = _STATED_ERROR * abs(float(defoci[0])) / unknowns.directions[j, unknowns.edge.index((2, 0))]
        effects["known defocus"] = names[j], float(bias)
    errors = dict.fromkeys(effects, f"{100.0 * _STATED_ERROR:g} % of it")
    return untested_findings(effects, errors, never=never_tested)


def untestable(model: StarImages) -> tuple[str, ...]:
    """Return what no images with the pupil and the defoci of `model` can test."""
    return (_FOCI,) if model.foci_exchangeable else ()


def missing_findings(tests: Sequence[ScoreTest], grade: Grade | None, names: Sequence[str]) -> list[Finding]:
    """Return the finding on missing effects that the images significantly favour; `names` are those of estimates.

    Without a `grade`, estimates do not allow for the effects, and the finding is a doubt.
    """
    significant = seen(tests)
    words = [_in_words(test) for test in significant]
    if significant and grade is None:
        return [other_explanation(significant, words)]
    return [graded_explanation(significant, words, grade, names)] if significant and grade else []


def _in_words(test: ScoreTest) -> str:
    """Return the result of a test in words: "noll 22 secondary spherical = 0.100 +- 0.006 rad (17 sigma)"."""
    name, unit = _DESCRIPTIONS.get(test.name, (test.name, " rad"))
    sigmas = f"({abs(test.sigmas):.2g} sigma)"
    if test.name in (_WINGS, _HALO) and test.size[0] > 1.0:  # more than all light: no fraction
        return f"a blur that is wider than that of the model, as of resampled pixels {sigmas}"
    if len(test.size) > (2 if test.name in _DESCRIPTIONS else 1):
        return f"{name} {sigmas}"
    pairs = zip(test.size, test.errors, strict=True)
    return f"{name} = {', '.join(' +- '.join(with_error(*pair)) for pair in pairs)}{unit} {sigmas}"


def star_tests(
    fit: Fit[StarImages], _freed: Sequence[str] = (), rivals: Sequence[str] = ()
) -> tuple[tuple[ScoreTest, ...], Grade, list[Finding]]:
    """Return tests of effects that the model of one star lacks, a marginalized correction, and findings.

    1. Score tests at the estimate, in the order of falling Bayes factors. 2. Shift and covariance of the
    common parameters, marginalized over effects, with the grade of significant effects. 3. Findings on effects that
    were not tested. Effects named `rivals` are marginalized in full.
    """
    model, x = fit.model, fit.x
    pupil, unknowns, plan = model.pupils(x[0]), model.unknowns, model.plan
    image_parameters = model.per_image(x)[0]
    flux = image_parameters[-2][:, None, None]
    names, (values, pixel_derivatives) = tested_names(model), model.images(x)
    _, extra_derivatives = model.images(x, fast=True, names=tuple(itertools.chain(*names)))
    differences = {
        name: flux * (np.asarray(plan(other).values) - values) / change
        for name, (other, change) in changed_pupils(pupil).items()
        if plan.method is None
    }
    illumination, (reader, grid) = list[Array](), model.sharp(pupil)
    if changes_of(model.pupil):
        illumination = reader.read(model.changes(pupil)[1].images(), NO_WIDTHS, derivatives=False)
    threads = plan.threads or None
    fine_plan = cached_plan(reader.shape, grid.pixel, tol=model.search_tol, integrate=False, threads=threads)
    notes, blurs = list[Finding](), dict[str, Array]()
    try:
        samples = np.asarray(fine_plan(pupil).values, np.float32)
    except (Declined, ToleranceError) as error:  # blur needs finer samples than pixels do, which may not be possible
        notes.append(Finding("untested", "note", f"blur was not tested: {error}"))
    else:
        blurs = reader.other_blurs(samples, np.empty((1, 0)))
    extra, of_terms, light, blurs = (
        [flux * slope.values for slope in extra_derivatives],
        (flux * slope.values for slope in pixel_derivatives),
        [flux * image for image in illumination],
        {name: flux * image for name, image in blurs.items()},
    )
    mean = flux * values + image_parameters[-1][:, None, None]
    effects = missing_effects(
        model, flux * values, mean, extra, of_terms, light, differences, blurs, 1, gaussian=True
    )
    # Products of all derivatives and the residuals: the information matrix, and in the last column the gradient.
    _, products = model.products(
        x, values, pixel_derivatives, [image for effect in effects for image in effect.images]
    )
    matrix = products[0]
    candidates, scores = candidates_of(effects, model.size), (matrix[:-1, :-1], matrix[:-1, -1], range(model.size))
    tests = score_tests(*scores, candidates)
    grade = graded(*scores, to_marginalize(candidates, tests, rivals), model.common_count, tests, fit.quality)
    defoci = model.known_defoci
    # A filter that is not narrow biases the f-number: images are sums over the spectrum of the star.
    is_spectral = model.pupil.wavelength is not None and {"f_number", "wavelength"} & set(unknowns.pupil)
    spectrum = ("spectrum within the filter (of the star)",) if is_spectral else ()
    columns, never = range(len(unknowns.terms)), (*untestable(model), *spectrum)
    notes += untested_constants(pupil[0], defoci, candidates, tests, (scores[0], scores[2]), unknowns, columns, never)
    return tests, grade, notes


def error_findings(model: StarImages, x: Array, covariance_matrix: Array) -> list[Finding]:
    """Return findings on standard errors that are not valid at the estimate `x`."""
    error, axes = uncertainty(model, covariance_matrix)
    if error > _MAX_PHASE_ERROR:
        return too_dim_findings(error, _MAX_PHASE_ERROR)
    factors = error_factors(model, x, covariance_matrix, axes)
    invalid_indices = [k for k in np.argsort(-factors) if factors[k] > _MAX_ERROR_CHANGE]
    if not invalid_indices:
        return []
    names = ", ".join(label(model.names[k]) for k in invalid_indices[:3])
    suffix = f" and {len(invalid_indices) - 3} more" if len(invalid_indices) > 3 else ""
    text = (
        f"the standard errors of {names}{suffix} are not to be trusted: within one standard deviation of the "
        f"estimate they change by a factor of up to {factors[invalid_indices[0]]:.3g}"
    )
    return [Finding("errors_change", "doubt", text, {label(model.names[k]): factors[k] for k in invalid_indices})]
