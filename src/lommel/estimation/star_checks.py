"""Checks of images of stars: what a model of them may lack, and whether standard errors hold."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from scipy import ndimage

from lommel.base.arrays import Array
from lommel.base.units import with_error
from lommel.blur.mixtures import Shape
from lommel.core.answers import Declined, ToleranceError
from lommel.estimation.sampled_pupil import (
    ASPECT,
    FOLDS,
    OBSCURATION,
    OVAL,
    SHIFT,
    SLANT,
    UnevenLight,
    changes_of,
)
from lommel.estimation.star_images import (
    StarImages,
    Unknowns,
    changes,
    label,
    next_terms,
    ripple_terms,
    slants,
    uncertainty,
)
from lommel.estimation.star_readout import StarReadout
from lommel.fit.findings import Finding
from lommel.fit.score_tests import (
    Candidate,
    Marginal,
    ScoreTest,
    favoured,
    marginalized,
    other_explanation,
    score_tests,
    seen,
    untested,
    untested_findings,
)
from lommel.methods.derivative_names import Name, Term
from lommel.optics.pupil import Pupil
from lommel.psf import Plan
from lommel.special import zernike

_TERM = 0.1  # radians rms: expected size of a missing term
_WIDTH, _SHARE = 0.1, 0.3  # expected sizes: pixels^2 of further blur; share of light behind a wider one
_VARIED = 0.3  # pixels^2: expected difference of blur from the middle to the edge of the field
_SLOPE, _NONLINEAR = 1.0, 0.05  # expected: electrons per pixel; share of electrons lost at 10^4
_CONSTANTS = {"f_number": 0.02, OBSCURATION: 0.03, "defocus": 0.05}  # relative, but for the obscuration
# Amplitude at the edge; radii; share of the scale.
_UNEVEN_LIGHT = {SLANT: 0.02, **dict.fromkeys(FOLDS, 0.01), SHIFT: 0.01, OVAL: 0.005, ASPECT: 0.003}
_TRAIL, _LATE, _REACH = 0.01, 2.0, 8  # share of the charge, pixels of its decay to 1/e, pixels computed
_KNOWN, _KEPT = 0.5, 0.25  # of expected sizes: how well constants are known, and how far charge is not late
_ONE = 0.01  # share of a stated number whose effect is reported
_CHANGED = 0.03  # radians rms: expected change of a term over the images
_RIPPLES, _POLISHED = 0.1, 0.2  # radians rms of all ripples together; the share of these that is there unseen
_CHANGES = " that changes over the images"
_DEFOCUS = 0.1  # radians: expected error of the defocus of one image
_MOST_FOCI = 9  # largest number of images whose defoci are tested one by one
# Radians rms: where phases are known less well, other minima of the likelihood are often as deep.
_CERTAIN = 0.25
# Factor by which a standard error may change within one standard deviation of the answer.
_STEADY = 1.125
APODIZED = 0.1  # exponent of the amplitude at the edge of the pupil, minus its logarithm
_SHARP = Shape(np.ones(1), np.empty((1, 0)), np.zeros(1))
_GAUSSIAN, _ELLIPSE, _WINGS, _HALO = "blur by a Gaussian besides", "blur in one direction", "wings", "halo"
_UNEVEN = "blur that varies over the field"
BLURS = (_GAUSSIAN, _ELLIPSE, _WINGS, _HALO)
GRADIENT = "background gradient"
_TRAILS = {
    name: f"charge that arrives late in {name}"
    for name in ("higher rows", "lower rows", "higher columns", "lower columns")
}
_ZONES, _FINE = "zones of the wavefront", "ripples of the wavefront"
NUISANCES = (*_UNEVEN_LIGHT, *_TRAILS.values(), GRADIENT)
"""What no fit estimates, and moves its answers unseen."""
_GAIN = "non-linear gain"
_WORDS = {
    _GAUSSIAN: ("variance of a Gaussian blur besides", " pixels^2"),
    _ELLIPSE: (
        "blur that is not the same in all directions, as of tracking or wind: (rows - columns) / 2, covariance",
        " pixels^2",
    ),
    _WINGS: ("wings of the blur: share of light that is blurred twice as far", ""),
    _HALO: ("a halo of the blur: share of light that is blurred four times as far", ""),
    _UNEVEN: ("blur that varies over the field: variance per half of it, columns and rows", " pixels^2"),
    GRADIENT: ("backgrounds that slope", ""),
    _ZONES: ("zones of the wavefront, as of polishing in rings", ""),
    _FINE: ("ripples of the wavefront, finer than the terms that are tested", ""),
    _GAIN: ("a gain that is not linear: share of electrons that is lost at 10^4", ""),
    SLANT: ("light that slopes across the pupil: by exp(-a y - b x), a, b", ""),
    SHIFT: ("an obscuration off the middle by (rows, columns)", " radii"),
    **{name: (f"{name}: amplitude at the edge by cosine and sine", "") for name in FOLDS},
    ASPECT: ("an image that is longer along y and shorter along x than stated, each by a share of", ""),
    OVAL: ("an aperture that is not round: radius longer by s cos 2t + u sin 2t, s, u", ""),
    **{name: (f"{name}: share", "") for name in _TRAILS.values()},
    "f_number": ("another f-number: its difference from the stated one", ""),
    OBSCURATION: ("another obscuration: its difference from the stated one", ""),
    "defocus": ("known defoci that are longer than stated: share of their length", ""),
    "apodization": ("an amplitude that falls towards the edge of the pupil, by exp(-g rho^2), g", ""),
}


class Lacking(NamedTuple):
    """What a model may lack: a name, the size that it may have, and derivatives of electrons by its columns."""

    name: str
    scale: float
    images: tuple[Array, ...]


def lacking_constants(pupil: Pupil, known: Array, estimated: Sequence[Name]) -> tuple[Name, ...]:
    """Return the constants that are tested by derivatives: the f-number, and (2, 0) for known defoci that differ."""
    scaled = pupil.circular and pupil.mask is None and pupil.wavelength is not None
    f_number = ("f_number",) if scaled and not {"f_number", "wavelength"} & {*estimated} else ()
    return (*f_number, *([(2, 0)] if np.ptp(known) > 0.0 else []))


def lacking_phases(
    terms: Sequence[Term], constants: Sequence[Name], slopes: Sequence[Array], pupil: Pupil, known: Array
) -> Iterator[Lacking]:
    """Yield Zernike terms and constants, of derivatives of electrons by radians at the edge, and by constants.

    That of the known defoci is by the defocus of images.
    """
    for term, slope in zip(terms, slopes, strict=False):
        yield Lacking(label(term), _TERM, (slope * zernike.rms_factor(*term),))
    for name, slope in zip(constants, slopes[len(terms) :], strict=True):
        if name != (2, 0):
            size = _CONSTANTS[str(name)] * (float(pupil.f_number or 1.0) if name == "f_number" else 1.0)
            yield Lacking(str(name), size, (slope,))
            continue
        each = np.tile(known, len(slope) // len(known))[:, None, None]
        yield Lacking("defocus", _CONSTANTS["defocus"], (slope * each,))
        if 2 < len(known) <= _MOST_FOCI:  # of two, either is what the other is
            for k, one in enumerate(_alone(len(known), slope)):
                yield Lacking(f"defocus of image {k + 1}", _DEFOCUS, (one,))


def lacking_ripples(terms: Sequence[Term], slopes: Sequence[Array]) -> Iterator[Lacking]:
    """Yield zones and other ripples of the wavefront, of derivatives of electrons by radians at the edge."""
    for name, round_ in ((_ZONES, True), (_FINE, False)):
        each = zip(terms, slopes, strict=True)
        images = tuple(slope * zernike.rms_factor(*term) for term, slope in each if (term[1] == 0) == round_)
        if images:
            yield Lacking(name, _RIPPLES / len(images) ** 0.5, images)


def lacking_changes(terms: Sequence[Term], slopes: Iterable[Array], exposures: int) -> Iterator[Lacking]:
    """Yield estimated terms that change over the images, of derivatives of electrons by terms of 1 at the edge.

    Sizes are half the difference of the last image from the first, radians rms.
    """
    if exposures > 1:
        for term, slope in zip(terms, slopes, strict=False):
            way = np.tile(np.linspace(-1.0, 1.0, exposures), len(slope) // exposures)[:, None, None]
            yield Lacking(label(term) + _CHANGES, _CHANGED, (slope * way * zernike.rms_factor(*term),))


def apodized(pupil: Pupil) -> Pupil | None:
    """Return a pupil whose amplitude falls towards the edge; None if that is not tested."""
    if pupil.circular and pupil.mask is None and isinstance(pupil.apodization, float):
        return replace(pupil, apodization=pupil.apodization + APODIZED)
    return None


def lacking_light(image: Array, other: Array) -> Lacking:
    """Return an amplitude that falls towards the edge, from electrons and those of the `apodized` pupil."""
    return Lacking("apodization", APODIZED, ((other - image) / APODIZED,))


def lacking_uneven_light(
    changes: Mapping[str, int], images: Iterable[Array], estimated: Sequence[Name] = ()
) -> Iterator[Lacking]:
    """Yield uneven light and other edges of the pupil, from derivatives of electrons by `changes_of`."""
    left, scales = iter(images), {**_UNEVEN_LIGHT, **_CONSTANTS}
    for name, count in changes.items():
        each = tuple(itertools.islice(left, count))
        if name not in estimated:
            yield Lacking(name, scales[name], each)


def lacking_charge(image: Array) -> Iterator[Lacking]:
    """Yield charge that arrives late along each axis, from electrons of stars alone (r * e, height, width)."""
    later = np.exp(-np.arange(_REACH) / _LATE)
    for name, axis, way in zip(_TRAILS.values(), (1, 1, 2, 2), (1, -1, 1, -1), strict=True):
        kernel = np.concatenate([np.zeros(_REACH + 1), later / later.sum()])[::way]
        # Charge leaves its own pixel for later ones: the sum stays.
        yield Lacking(name, _TRAIL, (ndimage.correlate1d(image, kernel[::-1], axis, mode="constant") - image,))


def lacking_blurs(blurs: Mapping[str, Array], exposures: int, *, gaussian: bool) -> Iterator[Lacking]:
    """Yield further blurs of each exposure, from derivatives of electrons by these (r * e, height, width)."""
    if gaussian:
        yield Lacking(_GAUSSIAN, _WIDTH, _alone(exposures, blurs["Gaussian"]))
    yield Lacking(_ELLIPSE, _WIDTH, _alone(exposures, blurs["along rows"], blurs["oblique"]))
    yield Lacking(_WINGS, _SHARE, _alone(exposures, blurs["wings"]))
    yield Lacking(_HALO, _SHARE, _alone(exposures, blurs["halo"]))


def uneven_blur(image: Array, places: Array, exposures: int) -> Lacking:
    """Return a blur that varies over the field, from derivatives of electrons by it, at places (r * e, 2)."""
    return Lacking(_UNEVEN, _VARIED, _alone(exposures, *(image * each[:, None, None] for each in places.T)))


def lacking_slopes(images: int, shape: tuple[int, int], exposures: int) -> Lacking:
    """Return sloping backgrounds of each exposure, for `images` images."""
    return Lacking(GRADIENT, _SLOPE, _alone(exposures, *slants(images, shape)))


def lacking_gain(mean: Array) -> Lacking:
    """Return a non-linear gain, from expected electrons."""
    # Counts lack the share s m / 10^4 of m electrons: the derivative by s.
    return Lacking(_GAIN, _NONLINEAR, (-(mean**2) / 1e4,))


def _alone(exposures: int, *each: Array) -> tuple[Array, ...]:
    """Return images (r * e, height, width) that are 0 except in one exposure, for each exposure."""
    of = np.arange(len(each[0])) % exposures
    return tuple(one * (of == i)[:, None, None] for i in range(exposures) for one in each)


def candidates_of(lacking: Sequence[Lacking], first: int) -> list[Candidate]:
    """Return candidates with consecutive columns, from `first` on."""
    found = []
    for one in lacking:
        found.append(Candidate(one.name, tuple(range(first, first + len(one.images))), one.scale))
        first += len(one.images)
    return found


def unseen(
    candidates: Sequence[Candidate], tests: Sequence[ScoreTest], others: Sequence[str] = ()
) -> list[Candidate]:
    """Return the candidates that are marginalized, with the sizes that they may have unseen.

    All that the data favour, though not beyond chance, have their whole size; of the others, what no fit estimates
    has a part of it.
    """
    parts = dict.fromkeys((*NUISANCES, *others), 1.0)
    parts |= (
        dict.fromkeys(_CONSTANTS, _KNOWN)
        | dict.fromkeys((_ZONES, _FINE), _POLISHED)
        | dict.fromkeys(_TRAILS.values(), _KEPT)
    )
    parts |= dict.fromkeys(favoured(tests), 1.0)
    return [replace(one, scale=parts[one.name] * one.scale) for one in candidates if one.name in parts]


def untested_constants(
    pupil: Pupil,
    known: Array,
    candidates: Sequence[Candidate],
    tests: Sequence[ScoreTest],
    fit: tuple[Array, Sequence[int]],
    waves: Unknowns,
    places: Sequence[int],
    never: Sequence[str] = (),
) -> list[Finding]:
    """Return the finding of stated numbers that the images do not test.

    `fit` has the information and the columns that are estimated, `places` those of the terms of `waves` among them;
    `never` is what no image tests.
    """
    names = [label(name) for name in waves.terms]
    scale = _ONE * float(pupil.f_number or 1.0)
    f_number = [replace(one, scale=scale) for one in candidates if one.name == "f_number"]
    found = untested(*fit, dict(zip(names, places, strict=True)), f_number, tests)
    if np.ptp(known) == 0.0 != known[0] and (2, 0) in waves.edge:
        # One focus shows the sum of what is known of the defocus and what is estimated.
        shares = waves.directions[:, waves.edge.index((2, 0))] / np.abs(waves.directions).sum(axis=1)
        j = int(shares.argmax())
        by = _ONE * abs(float(known[0])) / waves.directions[j, waves.edge.index((2, 0))]
        found["known defocus"] = names[j], float(by)
    return untested_findings(found, dict.fromkeys(found, f"{100.0 * _ONE:g} % of it"), never=never)


def missing_findings(tests: Sequence[ScoreTest]) -> list[Finding]:
    """Return the finding on what the stars favour."""
    likely = seen(tests)
    return [other_explanation(likely, [_in_words(test) for test in likely])] if likely else []


def _in_words(test: ScoreTest) -> str:
    """Return the result of a test in words: "noll 22 secondary spherical = 0.100 +- 0.006 rad (17 sigma)"."""
    what, unit = _WORDS.get(test.name, (test.name, " rad"))
    sigmas = f"({abs(test.sigmas):.2g} sigma)"
    if len(test.size) > (2 if test.name in _WORDS else 1):
        return f"{what} {sigmas}"
    each = zip(test.size, test.errors, strict=True)
    return f"{what} = {', '.join(' +- '.join(with_error(*one)) for one in each)}{unit} {sigmas}"


def star_tests(model: StarImages, x: Array) -> tuple[tuple[ScoreTest, ...], Marginal, list[Finding]]:
    """Return score tests of what the images of one star at `x` (1, p) may lack, the likeliest first.

    And shared parameters that allow for what is no wavefront and too small to be seen; and the findings of what is
    not tested.
    """
    pupil, unknowns, plan = model.pupils(x[0]), model.unknowns, model.plan
    light = model.per_image(x)[0]
    flux = light[-2][:, None, None]
    known = model.base[:, 0] - model.fixed[0]
    terms, ripples = next_terms(unknowns.edge, ()), ripple_terms(unknowns.edge)
    constants = lacking_constants(pupil, known, unknowns.pupil)
    values, slopes = model.images(x)
    _, further = model.images(x, fast=True, by=(*terms, *constants, *ripples))
    by = [flux * slope.values for slope in further]
    lacking = [*lacking_phases(terms, constants, by[: len(by) - len(ripples)], pupil, known)]
    lacking += lacking_ripples(ripples, by[len(by) - len(ripples) :])
    lacking += lacking_changes(unknowns.edge, (flux * slope.values for slope in slopes), model.count)
    changes, edge = changes_of(model.pupil), pupil.wavefront.edge_terms()
    if changes:
        phases = np.stack([np.broadcast_to(edge[term], model.count) for term in model.terms], axis=-1)
        uneven = UnevenLight(pupil[0], plan.grid(pupil), model.terms, phases).images()
        lacking += lacking_uneven_light(changes, [flux * image for image in uneven], unknowns.pupil)
    lacking += lacking_charge(flux * values)
    if (other := apodized(pupil)) is not None and plan.method is None:
        lacking.append(lacking_light(flux * values, flux * np.asarray(plan(other).values)))
    grid, scale = plan.grid(pupil), float(pupil.scale)
    reader = StarReadout(grid.shape, model.pixel / scale, 1.0, _SHARP, integrate=grid.integrate)
    fine = Plan(reader.shape, reader.step * scale, tol=model.loosest, integrate=False, threads=plan.threads or None)
    notes = []
    try:
        samples = np.asarray(fine(pupil).values, np.float32)
    except (Declined, ToleranceError) as error:  # on a finer lattice than that of the pixels
        notes.append(Finding("untested", "note", f"blur was not tested: {error}"))
    else:
        blurs = reader.other_blurs(samples, np.empty((1, 0)))
        lacking += lacking_blurs({name: flux * image for name, image in blurs.items()}, 1, gaussian=True)
    mean = flux * values + light[-1][:, None, None]
    lacking += [lacking_slopes(model.count, grid.shape, model.count), lacking_gain(mean)]
    _, products = model.products(x, values, slopes, [image for one in lacking for image in one.images])
    found = products[0]
    candidates, scores = candidates_of(lacking, model.size), (found[:-1, :-1], found[:-1, -1], range(model.size))
    tests = score_tests(*scores, candidates)
    marginal = marginalized(*scores, unseen(candidates, tests), model.shared)
    fit = found[:-1, :-1], range(model.size)
    notes += untested_constants(pupil[0], known, candidates, tests, fit, unknowns, range(len(unknowns.terms)))
    return tests, marginal, notes


def error_findings(model: StarImages, x: Array, inverse: Array) -> list[Finding]:
    """Return findings on standard errors at the answer `x` that do not hold."""
    error, axes = uncertainty(model, inverse)
    if error > _CERTAIN:
        text = (
            f"the standard errors are not to be trusted: together they make {error:.2g} rad rms of phase in an "
            "image, and other wavefronts may fit as well"
        )
        return [Finding("too_dim", "doubt", text, {"rms": error, "limit": _CERTAIN})]
    factors = changes(model, x, inverse, axes)
    worst = [k for k in np.argsort(-factors) if factors[k] > _STEADY]
    if not worst:
        return []
    names = ", ".join(label(model.names[k]) for k in worst[:3])
    more = f" and {len(worst) - 3} more" if len(worst) > 3 else ""
    text = (
        f"the standard errors of {names}{more} are not to be trusted: within one standard deviation of the answer "
        f"they change by a factor of up to {factors[worst[0]]:.3g}"
    )
    return [Finding("errors_change", "doubt", text, {label(model.names[k]): factors[k] for k in worst})]
