"""Checks of a field fit: what the model of the stars lacks, and slopes of the background."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.base.units import with_error
from lommel.estimation.field_signs import monomials
from lommel.estimation.field_stars import Blocks, WholeField
from lommel.estimation.star_images import Unknowns, label, next_terms
from lommel.estimation.star_readout import OTHER_BLURS
from lommel.fit.findings import Finding
from lommel.fit.score_tests import Candidate, ScoreTest, other_explanation, score_tests, seen
from lommel.fit.scoring import covariance
from lommel.special import zernike

_TERM = 0.1  # radians rms: the size that a missing term may have
_DEGREE = 0.05  # the same of each polynomial of a higher degree
_WIDTH, _SHARE = 0.1, 0.3  # pixels^2 of a blur besides; of the light, behind a wider one
_SLOPE, _NONLINEAR = 1.0, 0.05  # electrons per pixel; share of electrons that is lost at 10^4
_SURE = 5.0  # standard deviations by which backgrounds of windows slope
_GAUSSIAN, _ELLIPSE, _WINGS, _HALO = "blur by a Gaussian besides", "blur in one direction", "wings", "halo"
_GRADIENT, _GAIN = "background gradient", "non-linear gain"
_BLURS = (_GAUSSIAN, _ELLIPSE, _WINGS, _HALO)
_WORDS = {
    _GAUSSIAN: ("variance of a Gaussian blur besides", " pixels^2"),
    _ELLIPSE: (
        "blur that is not the same in all directions, as of tracking or wind: (rows - columns) / 2, covariance",
        " pixels^2",
    ),
    _WINGS: ("another shape of blur: share of light that is blurred twice as far", ""),
    _HALO: ("another shape of blur: share of light that is blurred four times as far", ""),
    _GRADIENT: ("slope of the background by row, column", " electrons per pixel"),
    _GAIN: ("a gain that is not linear: share of electrons that is lost at 10^4", ""),
}


class Marginal(NamedTuple):
    """Steps of coefficients (k * m,) and their covariance, where what a model lacks is unknown within its prior."""

    shift: Array
    covariance: Array


def missing_tests(model: WholeField, x: Array, places: Array, degree: int) -> tuple[tuple[ScoreTest, ...], Marginal]:
    """Return score tests of what a fit at `x` may lack, the likeliest first, and coefficients that allow for it.

    Further terms, polynomials of the next degree in `places` (n, 2), other blurs, slopes of the background, and a
    gain that is not linear. Blurs and slopes that are too small to be seen move coefficients: they are marginalized.
    """
    stars, chosen, k, m = model.of, model.chosen, model.waves, model.basis.shape[1]
    columns, images = _columns(model, x)
    values, slopes = model.images(x)
    local = stars.likelihood(chosen, [values, *slopes], model.parts(x)[3], images)[1]
    widths = stars.exposures * stars.widths
    shared = k + widths + len(images)
    wider = monomials(places[chosen, 0], places[chosen, 1], degree + 1)
    blocks = Blocks.of_stars(local[:, :, :-1], wider, k, shared, np.zeros(0))
    matrix, inverse = blocks.damped(0.0)
    first = (inverse @ local[:, shared:, -1:])[:, :, 0]
    right = blocks.eliminated(blocks.gathered(local[:, :shared, -1]), first)
    every = wider.shape[1]
    at = k * every + widths
    estimated = [j * every + i for j in range(k) for i in range(m)] + list(range(k * every, at))
    candidates = [
        Candidate(f"{label(name)} of degree {degree + 1}", tuple(range(j * every + m, (j + 1) * every)), _DEGREE)
        for j, name in enumerate(stars.one.unknowns.terms)
    ]
    free, prior = list(estimated), [0.0] * len(estimated)
    for name, count, scale in columns:
        candidates.append(Candidate(name, tuple(range(at, at + count)), scale))
        if name == _GRADIENT or (name in _BLURS and stars.widths):  # a blur that is stated is as it is
            free += range(at, at + count)
            prior += [1.0 / scale**2] * count
        at += count
    wide = covariance(matrix[np.ix_(free, free)] + np.diag(prior))[: k * m]
    known = np.isfinite(np.diag(wide))
    shift = np.where(known, np.where(known[:, None], wide, 0.0) @ right[free], 0.0)
    return score_tests(matrix, right, estimated, candidates), Marginal(shift, wide[:, : k * m])


def missing_findings(tests: Sequence[ScoreTest]) -> list[Finding]:
    """Return the finding of what the stars favour."""
    likely = seen(tests)
    return [other_explanation(likely, [_in_words(test) for test in likely])] if likely else []


def negated(tests: Sequence[ScoreTest], unknowns: Unknowns) -> tuple[ScoreTest, ...]:
    """Return tests of the wavefront with the even part of its phase negated."""
    even = {label(term) for term in next_terms(unknowns.edge, ()) if term[0] % 2 == 0}
    return tuple(replace(test, size=-test.size) if test.name in even else test for test in tests)


def _in_words(test: ScoreTest) -> str:
    """Return what a test found: "noll 22 secondary spherical = 0.100 +- 0.006 rad (17 sigma)"."""
    what, unit = _WORDS.get(test.name, (test.name, " rad"))
    if test.name not in _WORDS and len(test.size) > 1:
        return f"{what} ({abs(test.sigmas):.2g} sigma)"
    each = zip(test.size, test.errors, strict=True)
    shown = ", ".join(" +- ".join(with_error(size, error)) for size, error in each)
    return f"{what} = {shown}{unit} ({abs(test.sigmas):.2g} sigma)"


def _columns(model: WholeField, x: Array) -> tuple[list[tuple[str, int, float]], list[Array]]:
    """Return names, numbers of columns and sizes of candidates, and derivatives of electrons by each column."""
    stars, r, e = model.of, len(model.chosen), model.of.exposures
    terms = next_terms(stars.one.unknowns.edge, ())
    parts = model.parts(x)
    light = parts[3]
    made = stars.with_further(terms).images(model.chosen, *parts, fast=True, slopes="others")
    values, by_term, blurred = made[0], made[1 : 1 + len(terms)], made[1 + len(terms) :]
    flux = light[:, 0].reshape(-1, 1, 1)
    columns, images = [], []

    def add(name: str, scale: float, *each: Array) -> None:
        """Add a candidate, of every exposure by itself."""
        alone = [one * (np.arange(r * e) % e == i)[:, None, None] for i in range(e) for one in each]
        columns.append((name, len(alone), scale))
        images.extend(alone)

    for term, image in zip(terms, by_term, strict=True):
        ratio = np.tile(stars.ratio, r)[:, None, None]
        columns.append((label(term), 1, _TERM))
        images.append(image * (flux * ratio * zernike.rms_factor(*term)))
    blurs = {name: flux * image for name, image in zip(OTHER_BLURS if blurred else (), blurred, strict=True)}
    if blurs:
        if "Gaussian" not in stars.shapes[0].names:
            add(_GAUSSIAN, _WIDTH, blurs["Gaussian"])
        add(_ELLIPSE, _WIDTH, blurs["along rows"], blurs["oblique"])
        add(_WINGS, _SHARE, blurs["wings"])
        add(_HALO, _SHARE, blurs["halo"])
    if not stars.sloped and not stars.cornered:
        add(_GRADIENT, _SLOPE, *stars.slants(r))
    mean = stars.expected(values, light).reshape(values.shape)
    columns.append((_GAIN, 1, _NONLINEAR))
    images.append(-(mean**2) / 1e4)
    return columns, images


def slope_findings(model: WholeField, x: Array) -> list[Finding]:
    """Return the finding of backgrounds of windows that slope more than noise lets them."""
    stars, chosen = model.of, model.chosen
    if stars.sloped or stars.cornered:
        return []
    values, slopes = model.images(x)
    r, e = len(chosen), stars.exposures
    others = [one * (np.arange(r * e) % e == i)[:, None, None] for i in range(e) for one in stars.slants(r)]
    local = stars.likelihood(chosen, [values, *slopes], model.parts(x)[3], others)[1]
    first = model.waves + e * stars.widths
    at, rest = np.arange(first, first + 2 * e), np.arange(first + 2 * e, local.shape[1] - 1)
    own, mixed = local[:, rest[:, None], rest], local[:, rest[:, None], at]
    carried = np.linalg.solve(own, np.concatenate([mixed, local[:, rest, -1:]], axis=2))
    left = local[:, at[:, None], np.append(at, -1)] - mixed.swapaxes(1, 2) @ carried
    size = np.linalg.solve(left[:, :, :-1], left[:, :, -1:])[:, :, 0]
    sigmas = (float((size * left[:, :, -1]).sum()) - size.size) / math.sqrt(2.0 * size.size)
    if sigmas < _SURE:
        return []
    steepest = float(np.abs(size).max())
    text = (
        f"backgrounds slope ({sigmas:.2g} sigma), by up to {steepest:.2g} electrons per pixel: the slope of each is "
        "estimated"
    )
    return [Finding("tilted_background", "note", text, {"sigmas": sigmas, "steepest": steepest})]
