"""Checks of a field fit: effects that the model of the stars lacks, and slopes of the background."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

import numpy as np

from lommel.base.arrays import Array
from lommel.estimation import star_checks
from lommel.estimation.favoured_effects import Fit
from lommel.estimation.field_signs import monomials
from lommel.estimation.field_stars import Blocks, WholeField
from lommel.estimation.sampled_pupil import changes_of
from lommel.estimation.star_checks import BLURS, MissingEffect
from lommel.estimation.star_images import label, pixel_coordinates
from lommel.estimation.star_readout import OTHER_BLURS
from lommel.fit.findings import Finding
from lommel.fit.score_tests import Candidate, Grade, ScoreTest, graded, score_tests, sigmas_of

_EXPECTED_SIZE = 0.05  # radians rms: expected size of a polynomial of higher degree, or of a deviation in a part
_DEGREES = 2  # number of tested degrees above the degree of the fit
_PART_RADIUS = 0.45  # radius of each of the 3 x 3 parts of the field, half fields (-1 to 1 across the sensor)
_ROWS, _COLUMNS = ("at the top", "in the middle", "at the bottom"), ("left", "", "right")
_PARTS = [f"{row} {column}".strip() for row in _ROWS for column in _COLUMNS]
# Middles of the parts, half fields.
_DOWN, _ACROSS = (np.array([-0.8, 0.0, 0.8])[index] for index in np.divmod(np.arange(9), 3))
_DRIFT = "motion within exposures (of the images, which widens the blur)"
_FREE = 1e3  # factor of the prior standard deviation of an effect that is estimated
_SURE = 5.0  # smallest significance of slopes (standard deviations) at which they are estimated


def missing_tests(
    places: Array, degree: int, fit: Fit[WholeField], freed: Collection[str] = (), rivals: Sequence[str] = ()
) -> tuple[tuple[ScoreTest, ...], Grade, list[Finding]]:
    """Return tests of effects that a fit lacks, a marginalized correction, and findings on untested constants.

    1. Score tests at the estimate, the most likely effect first. 2. Shift and covariance of the coefficients,
    marginalized over effects, with the grade of significant effects. 3. Findings on input constants (f-number,
    obscuration, defocus) that the stars do not test. `freed` constants are estimated, and effects
    named `rivals` are marginalized in full.

    Effects are further terms, polynomials of higher degrees in `places` (n, 2), deviations in parts of the field,
    uneven pupil illumination, charge transfer, other blurs, slopes of the background, and a nonlinear gain. Effects
    other than wavefronts are marginalized, because they bias the coefficients even if they are not significant.
    """
    model, x = fit.model, fit.x
    stars, chosen, k, m = model.stars, model.chosen, model.wave_count, model.basis.shape[1]
    values, derivatives = model.images(x)
    flux = model.parts(x)[2][:, 2].reshape(-1, 1, 1)
    effects = _missing_effects(model, x, places, (flux * derivative for derivative in derivatives))
    images = [image for effect in effects for image in effect.images]
    matrices = stars.likelihood(chosen, [values, *derivatives], model.parts(x)[2], images)[1]
    widths = stars.exposures * stars.width_count
    local_count = k + widths + len(images)
    u, v = places[chosen].T
    polynomials = monomials(u, v, max(_tested_degrees(degree)))
    # Polynomials, and deviations in one part of the field.
    part_weights = np.exp(-((u[:, None] - _ACROSS) ** 2 + (v[:, None] - _DOWN) ** 2) / _PART_RADIUS**2)
    basis = np.concatenate([polynomials, part_weights], axis=1)
    blocks = Blocks.of_stars(matrices[:, :, :-1], basis, k, local_count, np.zeros(0))
    matrix, inverse = blocks.eliminate_nuisance(0.0)
    nuisance_steps = (inverse @ matrices[:, local_count:, -1:])[:, :, 0]
    gradient = blocks.reduced_gradient(blocks.summed_gradient(matrices[:, :local_count, -1]), nuisance_steps)
    basis_count = basis.shape[1]
    first_column = k * basis_count + widths
    estimated = [j * basis_count + i for j in range(k) for i in range(m)] + list(range(k * basis_count, first_column))
    parts = [(f"of degree {d}", np.arange(d * (d + 1) // 2, (d + 1) * (d + 2) // 2)) for d in _tested_degrees(degree)]
    parts += [(f"more {part}", np.array([polynomials.shape[1] + i])) for i, part in enumerate(_PARTS)]
    candidates = [
        Candidate(f"{label(name)} {part}", tuple(j * basis_count + columns), _EXPECTED_SIZE)
        for j, name in enumerate(stars.first_star.unknowns.terms)
        for part, columns in parts
    ]
    effect_candidates = [
        replace(candidate, scale=_FREE * candidate.scale) if candidate.name in freed else candidate
        for candidate in star_checks.candidates_of(effects, first_column)
    ]
    tests = score_tests(matrix, gradient, estimated, [*candidates, *effect_candidates])
    # A known blur is assumed to be exact: other blurs are marginalized only if the blur is estimated.
    kept_names = (*freed, *rivals, *(BLURS if stars.width_count else ()))
    to_marginalize = star_checks.to_marginalize([*candidates, *effect_candidates], tests, kept_names)
    grade = graded(matrix, gradient, estimated, to_marginalize, k * m, tests, fit.quality)
    unknowns, solved = stars.first_star.unknowns, (matrix, estimated)
    constant_columns = [j * m for j in range(k)]
    # In a wide filter the mean wavelength differs from star to star, and images are polychromatic.
    spectrum = ("spectrum within the filter (of the stars)",) if stars.width_count and stars.pupil.wavelength else ()
    drift = (_DRIFT,) if stars.width_count and stars.target is None else ()
    never = (*star_checks.untestable(stars.first_star), *drift, *spectrum)
    untested = star_checks.untested_constants(
        stars.pupil, stars.defocus, effect_candidates, tests, solved, unknowns, constant_columns, never
    )
    return tests, grade, untested


def _tested_degrees(degree: int) -> range:
    """Return the degrees of polynomials that are tested."""
    return range(degree + 1, degree + 1 + _DEGREES)


def _missing_effects(model: WholeField, x: Array, places: Array, term_slopes: Iterable[Array]) -> list[MissingEffect]:
    """Return effects that the model of the stars lacks, except polynomials of higher degree."""
    stars, parts, e = model.stars, model.parts(x), model.stars.exposures
    names = tuple(itertools.chain(*star_checks.tested_names(stars.first_star)))
    images = stars.copy_with(extra_terms=names).images(model.chosen, *parts, fast=True, derivatives="others")
    flux = parts[2][:, 2].reshape(-1, 1, 1)
    image, *derivatives = [flux * psf for psf in images]
    first_blur = len(names) + sum(changes_of(stars.pupil).values())
    differences = dict[str, Array]()
    for name, (pupil, change) in star_checks.changed_pupils(stars.pupil).items():
        other = stars.copy_with(pupil=pupil).images(model.chosen, *parts, fast=True, derivatives="none")[0]
        differences[name] = flux * (other - images[0]) / change
    blurs = dict(zip(OTHER_BLURS, derivatives[first_blur:], strict=False))
    mean, is_sharp = stars.expected(images[0], parts[2]).reshape(images[0].shape), "Gaussian" not in stars.blur.names
    effects = star_checks.missing_effects(
        stars.first_star, image, mean, derivatives[: len(names)], term_slopes, derivatives[len(names) : first_blur],
        differences, blurs, e, gaussian=is_sharp, gradients=not stars.has_slopes and not stars.has_corners,
    )  # fmt: skip
    if blurs:
        effects.append(star_checks.uneven_blur(blurs["Gaussian"], np.repeat(places[model.chosen], e, axis=0), e))
    return effects


def slope_findings(model: WholeField, x: Array) -> list[Finding]:
    """Return the finding on significant slopes of the backgrounds."""
    stars, chosen = model.stars, model.chosen
    if stars.has_slopes or stars.has_corners:
        return []
    values, derivatives = model.images(x)
    r, e = len(chosen), stars.exposures
    gradients = star_checks.of_each_exposure(e, *pixel_coordinates(r * e, stars.shape))
    matrices = stars.likelihood(chosen, [values, *derivatives], model.parts(x)[2], gradients)[1]
    first_column = model.wave_count + e * stars.width_count
    slope_columns = np.arange(first_column, first_column + 2 * e)
    nuisance_columns = np.arange(first_column + 2 * e, matrices.shape[1] - 1)
    slope_rows, nuisance_rows = matrices[:, slope_columns], matrices[:, nuisance_columns]
    nuisance_block, mixed_block = nuisance_rows[:, :, nuisance_columns], nuisance_rows[:, :, slope_columns]
    solution = np.linalg.solve(nuisance_block, np.concatenate([mixed_block, nuisance_rows[:, :, -1:]], axis=2))
    # Schur complement: information on the slopes, with the nuisance parameters of each star eliminated.
    information = slope_rows[:, :, np.append(slope_columns, -1)] - mixed_block.swapaxes(1, 2) @ solution
    slopes = np.linalg.solve(information[:, :, :-1], information[:, :, -1:])[:, :, 0]
    sigmas = sigmas_of(float((slopes * information[:, :, -1]).sum()), slopes.size)
    if sigmas < _SURE:
        return []
    steepest = float(np.abs(slopes).max())
    text = (
        f"backgrounds slope ({sigmas:.2g} sigma), by up to {steepest:.2g} electrons per pixel: the slope of each "
        "background is estimated"
    )
    return [Finding("tilted_background", "note", text, {"sigmas": sigmas, "steepest": steepest})]
