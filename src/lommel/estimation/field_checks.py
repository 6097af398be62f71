"""Checks of a field fit: what the model of the stars lacks, and slopes of the background."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.estimation import star_checks
from lommel.estimation.field_signs import monomials
from lommel.estimation.field_stars import Blocks, WholeField
from lommel.estimation.star_checks import BLURS, GRADIENT, Lacking
from lommel.estimation.star_images import Unknowns, label, next_terms
from lommel.estimation.star_readout import OTHER_BLURS
from lommel.fit.findings import Finding
from lommel.fit.score_tests import Candidate, ScoreTest, score_tests, sigmas_of
from lommel.fit.scoring import covariance

_DEGREE = 0.05  # radians rms: the size that polynomials of a higher degree may have
_SURE = 5.0  # standard deviations by which backgrounds of windows slope


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
    lacking = _lacking(model, x, places)
    images = [image for one in lacking for image in one.images]
    values, slopes = model.images(x)
    local = stars.likelihood(chosen, [values, *slopes], model.parts(x)[2], images)[1]
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
    for one in star_checks.candidates_of(lacking, at):
        candidates.append(one)
        if one.name == GRADIENT or (one.name in BLURS and stars.widths):  # a blur that is stated is as it is
            free += one.columns
            prior += [1.0 / one.scale**2] * len(one.columns)
    wide = covariance(matrix[np.ix_(free, free)] + np.diag(prior))[: k * m]
    known = np.isfinite(np.diag(wide))
    shift = np.where(known, np.where(known[:, None], wide, 0.0) @ right[free], 0.0)
    return score_tests(matrix, right, estimated, candidates), Marginal(shift, wide[:, : k * m])


def negated(tests: Sequence[ScoreTest], unknowns: Unknowns) -> tuple[ScoreTest, ...]:
    """Return tests of the wavefront with the even part of its phase negated."""
    even = {label(term) for term in next_terms(unknowns.edge, ()) if term[0] % 2 == 0}
    return tuple(replace(test, size=-test.size) if test.name in even else test for test in tests)


def _lacking(model: WholeField, x: Array, places: Array) -> list[Lacking]:
    """Return what stars of a field may lack, but for polynomials of a higher degree."""
    stars, parts, r, e = model.of, model.parts(x), len(model.chosen), model.of.exposures
    terms = next_terms(stars.one.unknowns.edge, ())
    constants = star_checks.lacking_constants(stars.one.pupil, stars.known, ())
    every = *terms, *constants
    made = stars.having(further=every).images(model.chosen, *parts, fast=True, slopes="others")
    flux = parts[2][:, 2].reshape(-1, 1, 1)
    by = [flux * image for image in made[1 : 1 + len(every)]]
    found = [*star_checks.lacking_phases(terms, constants, by, stars.one.pupil, stars.known)]
    if (pupil := star_checks.apodized(stars.lens)) is not None:
        other = stars.having(lens=pupil).images(model.chosen, *parts, fast=True, slopes="none")[0]
        found.append(star_checks.lacking_light(flux * made[0], flux * other))
    if blurred := made[1 + len(every) :]:
        blurs = {name: flux * image for name, image in zip(OTHER_BLURS, blurred, strict=True)}
        found += star_checks.lacking_blurs(blurs, e, gaussian="Gaussian" not in stars.blur.names)
        found.append(star_checks.uneven_blur(blurs["Gaussian"], np.repeat(places[model.chosen], e, axis=0), e))
    if not stars.sloped and not stars.cornered:
        found.append(star_checks.lacking_slopes(r * e, stars.shape, e))
    found.append(star_checks.lacking_gain(stars.expected(made[0], parts[2]).reshape(made[0].shape)))
    return found


def slope_findings(model: WholeField, x: Array) -> list[Finding]:
    """Return the finding of backgrounds of windows that slope more than noise lets them."""
    stars, chosen = model.of, model.chosen
    if stars.sloped or stars.cornered:
        return []
    values, slopes = model.images(x)
    r, e = len(chosen), stars.exposures
    others = star_checks.lacking_slopes(r * e, stars.shape, e).images
    local = stars.likelihood(chosen, [values, *slopes], model.parts(x)[2], others)[1]
    first = model.waves + e * stars.widths
    at, rest = np.arange(first, first + 2 * e), np.arange(first + 2 * e, local.shape[1] - 1)
    own, mixed = local[:, rest[:, None], rest], local[:, rest[:, None], at]
    carried = np.linalg.solve(own, np.concatenate([mixed, local[:, rest, -1:]], axis=2))
    left = local[:, at[:, None], np.append(at, -1)] - mixed.swapaxes(1, 2) @ carried
    size = np.linalg.solve(left[:, :, :-1], left[:, :, -1:])[:, :, 0]
    sigmas = sigmas_of(float((size * left[:, :, -1]).sum()), size.size)
    if sigmas < _SURE:
        return []
    steepest = float(np.abs(size).max())
    text = (
        f"backgrounds slope ({sigmas:.2g} sigma), by up to {steepest:.2g} electrons per pixel: the slope of each is "
        "estimated"
    )
    return [Finding("tilted_background", "note", text, {"sigmas": sigmas, "steepest": steepest})]
