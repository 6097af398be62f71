"""Score tests of images of stars: what a model of them may lack, and how that is said."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.base.units import with_error
from lommel.blur.mixtures import Shape
from lommel.estimation.star_images import StarImages, label, next_terms
from lommel.estimation.star_readout import StarReadout
from lommel.fit.findings import Finding
from lommel.fit.score_tests import Candidate, ScoreTest, other_explanation, score_tests, seen
from lommel.methods.derivative_names import Term
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.psf import Plan
from lommel.special import zernike

_TERM = 0.1  # radians rms: the size that a missing term may have
_WIDTH, _SHARE = 0.1, 0.3  # pixels^2 of a blur besides; of the light, behind a wider one
_SLOPE, _NONLINEAR = 1.0, 0.05  # electrons per pixel; share of electrons that is lost at 10^4
_CONSTANT = 0.02, 0.05  # relative: of the f-number, and of known defoci
_SHARP = Shape(np.ones(1), np.empty((1, 0)), np.zeros(1))
_GAUSSIAN, _ELLIPSE, _WINGS, _HALO = "blur by a Gaussian besides", "blur in one direction", "wings", "halo"
BLURS = (_GAUSSIAN, _ELLIPSE, _WINGS, _HALO)
GRADIENT = "background gradient"
_GAIN, _F_NUMBER, _DEFOCI = "non-linear gain", "f_number", "defocus"
_WORDS = {
    _GAUSSIAN: ("variance of a Gaussian blur besides", " pixels^2"),
    _ELLIPSE: (
        "blur that is not the same in all directions, as of tracking or wind: (rows - columns) / 2, covariance",
        " pixels^2",
    ),
    _WINGS: ("another shape of blur: share of light that is blurred twice as far", ""),
    _HALO: ("another shape of blur: share of light that is blurred four times as far", ""),
    GRADIENT: ("backgrounds that slope", ""),
    _GAIN: ("a gain that is not linear: share of electrons that is lost at 10^4", ""),
    _F_NUMBER: ("an f-number larger than stated by", ""),
    _DEFOCI: ("known defoci larger than stated by a share of", ""),
}


class Lacking(NamedTuple):
    """What a model may lack: a name, the size that it may have, and derivatives of electrons by its columns."""

    name: str
    scale: float
    images: tuple[Array, ...]


def lacking_terms(terms: Sequence[Term], slopes: Sequence[Array]) -> Iterator[Lacking]:
    """Yield Zernike terms, of derivatives of electrons by their radians at the edge."""
    for term, image in zip(terms, slopes, strict=True):
        yield Lacking(label(term), _TERM, (image * zernike.rms_factor(*term),))


def lacking_blurs(blurs: Mapping[str, Array], exposures: int, *, gaussian: bool) -> Iterator[Lacking]:
    """Yield blurs of each exposure, of derivatives of electrons by these (r * e, height, width)."""
    if gaussian:
        yield Lacking(_GAUSSIAN, _WIDTH, _alone(exposures, blurs["Gaussian"]))
    yield Lacking(_ELLIPSE, _WIDTH, _alone(exposures, blurs["along rows"], blurs["oblique"]))
    yield Lacking(_WINGS, _SHARE, _alone(exposures, blurs["wings"]))
    yield Lacking(_HALO, _SHARE, _alone(exposures, blurs["halo"]))


def lacking_slopes(images: int, shape: tuple[int, int], exposures: int) -> Lacking:
    """Return backgrounds that slope, of each exposure, for so many images."""
    slants = np.meshgrid(*(np.arange(side) - side // 2.0 for side in shape), indexing="ij")
    return Lacking(GRADIENT, _SLOPE, _alone(exposures, *(np.broadcast_to(one, (images, *shape)) for one in slants)))


def lacking_gain(mean: Array) -> Lacking:
    """Return a gain that is not linear, of expected electrons."""
    return Lacking(_GAIN, _NONLINEAR, (-(mean**2) / 1e4,))


def _alone(exposures: int, *each: Array) -> tuple[Array, ...]:
    """Return images (r * e, height, width) that are 0 in all exposures but one, for each exposure."""
    of = np.arange(len(each[0])) % exposures
    return tuple(one * (of == i)[:, None, None] for i in range(exposures) for one in each)


def candidates_of(lacking: Sequence[Lacking], first: int) -> list[Candidate]:
    """Return candidates of which columns follow each other, from the first on."""
    found = []
    for one in lacking:
        found.append(Candidate(one.name, tuple(range(first, first + len(one.images))), one.scale))
        first += len(one.images)
    return found


def missing_findings(tests: Sequence[ScoreTest]) -> list[Finding]:
    """Return the finding of what the stars favour."""
    likely = seen(tests)
    return [other_explanation(likely, [_in_words(test) for test in likely])] if likely else []


def _in_words(test: ScoreTest) -> str:
    """Return what a test found: "noll 22 secondary spherical = 0.100 +- 0.006 rad (17 sigma)"."""
    what, unit = _WORDS.get(test.name, (test.name, " rad"))
    sigmas = f"({abs(test.sigmas):.2g} sigma)"
    if len(test.size) > (2 if test.name in _WORDS else 1):
        return f"{what} {sigmas}"
    each = zip(test.size, test.errors, strict=True)
    return f"{what} = {', '.join(' +- '.join(with_error(*one)) for one in each)}{unit} {sigmas}"


def star_tests(model: StarImages, x: Array) -> tuple[ScoreTest, ...]:
    """Return score tests of what the images of one star at `x` (1, p) may lack, the likeliest first."""
    pupil, unknowns, plan = model.pupils(x[0]), model.unknowns, model.plan
    light = model.per_image(x)[0]
    flux = light[-2][:, None, None]
    known = model.base[:, 0] - model.fixed[0]
    terms = next_terms(unknowns.edge, [(2, 0)] if isinstance(pupil, ObjectivePupil) else [])
    f_number = pupil.wavelength is not None and not {"f_number", "wavelength"} & {*unknowns.pupil}
    optics = (_F_NUMBER,) if f_number and not isinstance(pupil, ObjectivePupil) else ()
    defoci = ((2, 0),) if np.ptp(known) > 0.0 else ()
    values, slopes = model.images(x)
    _, further = model.images(x, fast=True, by=(*terms, *optics, *defoci))
    by = [flux * slope.values for slope in further]
    lacking = [*lacking_terms(terms, by[: len(terms)])]
    if optics:
        lacking.append(Lacking(_F_NUMBER, _CONSTANT[0] * float(pupil.f_number or 1.0), (by[len(terms)],)))
    if defoci:
        lacking.append(Lacking(_DEFOCI, _CONSTANT[1], (by[-1] * known[:, None, None],)))
    grid, scale = plan.grid(pupil), float(pupil.scale)
    reader = _reader(grid.shape, model.pixel / scale, grid.integrate)
    fine = Plan(reader.shape, reader.step * scale, tol=model.loosest, integrate=False, threads=plan.threads or None)
    blurs = reader.other_blurs(np.asarray(fine(pupil).values, np.float32), np.empty((1, 0)))
    lacking += lacking_blurs({name: flux * image for name, image in blurs.items()}, 1, gaussian=True)
    mean = flux * values + light[-1][:, None, None]
    lacking += [lacking_slopes(model.count, grid.shape, model.count), lacking_gain(mean)]
    _, products = model.products(x, values, slopes, [image for one in lacking for image in one.images])
    found = products[0]
    return score_tests(found[:-1, :-1], found[:-1, -1], range(model.size), candidates_of(lacking, model.size))


@lru_cache(maxsize=4)
def _reader(window: tuple[int, int], pixel: float, integrate: bool) -> StarReadout:
    """Return what reads images that are sharp, and their derivatives by blurs."""
    return StarReadout(window, pixel, 1.0, _SHARP, integrate=integrate)
