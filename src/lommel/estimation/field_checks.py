"""Checks of a field fit: effects that the model of the stars lacks, and slopes of the background."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from lommel.base.arrays import Array
from lommel.estimation import star_checks
from lommel.estimation.field_signs import monomials
from lommel.estimation.field_stars import Blocks, WholeField
from lommel.estimation.sampled_pupil import FOLDS, SHIFT, SLANT, changes_of
from lommel.estimation.star_checks import BLURS, MissingEffect
from lommel.estimation.star_images import Unknowns, label, next_terms, ripple_terms
from lommel.estimation.star_readout import OTHER_BLURS
from lommel.fit.findings import Finding
from lommel.fit.score_tests import Candidate, Marginal, ScoreTest, marginalized, score_tests, sigmas_of

_EXPECTED_SIZE = 0.05  # of a polynomial of higher degree, or of a deviation in a part of the field, radians rms
_DEGREES = 2  # number of tested degrees above the degree of the fit
_PART_RADIUS = 0.45  # radius of each of the 3 x 3 parts of the field, half fields (-1 to 1 across the sensor)
_ROWS, _COLUMNS = ("at the top", "in the middle", "at the bottom"), ("left", "", "right")
_PARTS = [f"{row} {column}".strip() for row in _ROWS for column in _COLUMNS]
# Middles of the parts, half fields.
_DOWN, _ACROSS = (np.array([-0.8, 0.0, 0.8])[each] for each in np.divmod(np.arange(9), 3))
_SURE = 5.0  # smallest significance of slopes (standard deviations) at which they are estimated


def missing_tests(
    model: WholeField, x: Array, places: Array, degree: int
) -> tuple[tuple[ScoreTest, ...], Marginal, list[Finding]]:
    """Return score tests of effects that a fit at `x` lacks, the most likely first, and a marginalized correction.

    Also return the findings on input constants (f-number, obscuration, defocus) that the stars do not test.

    Effects are further terms, polynomials of higher degrees in `places` (n, 2), deviations in parts of the field,
    uneven pupil illumination, charge transfer, other blurs, slopes of the background, and a nonlinear gain. Effects
    other than wavefronts are marginalized, because they bias the coefficients even if they are not significant.
    """
    stars, chosen, k, m = model.of, model.chosen, model.waves, model.basis.shape[1]
    values, slopes = model.images(x)
    flux = model.parts(x)[2][:, 2].reshape(-1, 1, 1)
    edge = stars.one.unknowns.edge
    effects = [*star_checks.missing_drifts(edge, (flux * slope for slope in slopes), stars.exposures)]
    effects += _missing_effects(model, x, places)
    images = [image for one in effects for image in one.images]
    local = stars.likelihood(chosen, [values, *slopes], model.parts(x)[2], images)[1]
    widths = stars.exposures * stars.widths
    shared = k + widths + len(images)
    u, v = places[chosen].T
    higher = monomials(u, v, max(_higher(degree)))
    # Polynomials, and deviations in one part of the field.
    near = np.exp(-((u[:, None] - _ACROSS) ** 2 + (v[:, None] - _DOWN) ** 2) / _PART_RADIUS**2)
    wider = np.concatenate([higher, near], axis=1)
    blocks = Blocks.of_stars(local[:, :, :-1], wider, k, shared, np.zeros(0))
    matrix, inverse = blocks.damped(0.0)
    first = (inverse @ local[:, shared:, -1:])[:, :, 0]
    right = blocks.eliminated(blocks.gathered(local[:, :shared, -1]), first)
    every = wider.shape[1]
    at = k * every + widths
    estimated = [j * every + i for j in range(k) for i in range(m)] + list(range(k * every, at))
    parts = [(f"of degree {d}", np.arange(d * (d + 1) // 2, (d + 1) * (d + 2) // 2)) for d in _higher(degree)]
    parts += [(f"more {part}", np.array([higher.shape[1] + i])) for i, part in enumerate(_PARTS)]
    candidates = [
        Candidate(f"{label(name)} {part}", tuple(j * every + columns), _EXPECTED_SIZE)
        for j, name in enumerate(stars.one.unknowns.terms)
        for part, columns in parts
    ]
    missing = star_checks.candidates_of(effects, at)
    tests = score_tests(matrix, right, estimated, [*candidates, *missing])
    # A known blur is assumed to be exact: other blurs are marginalized only if the blur is estimated.
    unseen = star_checks.to_marginalize([*candidates, *missing], tests, BLURS if stars.widths else ())
    marginal = marginalized(matrix, right, estimated, unseen, k * m)
    waves, fit = stars.one.unknowns, (matrix, estimated)
    means = [j * m for j in range(k)]
    # In a wide filter the mean wavelength differs from star to star, and images are polychromatic.
    spectrum = ("spectrum of the stars within the filter",) if stars.widths and stars.lens.wavelength else ()
    untested = star_checks.untested_constants(stars.lens, stars.known, missing, tests, fit, waves, means, spectrum)
    return tests, marginal, untested


def _higher(degree: int) -> range:
    """Return the degrees of polynomials that are tested."""
    return range(degree + 1, degree + 1 + _DEGREES)


def negated(tests: Sequence[ScoreTest], unknowns: Unknowns) -> tuple[ScoreTest, ...]:
    """Return the tests for the wavefront with negated even part, whose pupil is rotated by 180 degrees."""
    even = {label(term) for term in (*unknowns.edge, *next_terms(unknowns.edge, ())) if term[0] % 2 == 0}
    odd = {SLANT, FOLDS[1], SHIFT}  # changes of the illumination that change sign by the rotation
    of_even = tuple(f"{name} " for name in even)
    return tuple(
        replace(test, size=-test.size) if test.name in even | odd or test.name.startswith(of_even) else test
        for test in tests
    )


def _missing_effects(model: WholeField, x: Array, places: Array) -> list[MissingEffect]:
    """Return effects that the model of the stars lacks, except polynomials of higher degree."""
    stars, parts, r, e = model.of, model.parts(x), len(model.chosen), model.of.exposures
    terms, fine = next_terms(stars.one.unknowns.edge, ()), ripple_terms(stars.one.unknowns.edge)
    constants = star_checks.constants_to_test(stars.one.pupil, stars.known, ())
    every = *terms, *constants, *fine
    made = stars.having(further=every).images(model.chosen, *parts, fast=True, slopes="others")
    flux = parts[2][:, 2].reshape(-1, 1, 1)
    image, *by = [flux * each for each in made]
    coarse = len(every) - len(fine)
    found = [*star_checks.missing_terms(terms, constants, by[:coarse], stars.one.pupil, stars.known)]
    found += star_checks.missing_ripples(fine, by[coarse : len(every)])
    changes = changes_of(stars.lens)
    blurred = by[len(every) + sum(changes.values()) :]
    found += star_checks.missing_illumination(changes, by[len(every) : len(by) - len(blurred)])
    found += star_checks.missing_charge_transfer(image)
    if (pupil := star_checks.apodized(stars.lens)) is not None:
        other = stars.having(lens=pupil).images(model.chosen, *parts, fast=True, slopes="none")[0]
        found.append(star_checks.missing_apodization(image, flux * other))
    if blurred:
        blurs = dict(zip(OTHER_BLURS, blurred, strict=True))
        found += star_checks.missing_blurs(blurs, e, gaussian="Gaussian" not in stars.blur.names)
        found.append(star_checks.uneven_blur(blurs["Gaussian"], np.repeat(places[model.chosen], e, axis=0), e))
    if not stars.sloped and not stars.cornered:
        found.append(star_checks.missing_gradients(r * e, stars.shape, e))
    found.append(star_checks.missing_nonlinearity(stars.expected(made[0], parts[2]).reshape(made[0].shape)))
    return found


def slope_findings(model: WholeField, x: Array) -> list[Finding]:
    """Return the finding on significant slopes of the backgrounds."""
    stars, chosen = model.of, model.chosen
    if stars.sloped or stars.cornered:
        return []
    values, slopes = model.images(x)
    r, e = len(chosen), stars.exposures
    others = star_checks.missing_gradients(r * e, stars.shape, e).images
    local = stars.likelihood(chosen, [values, *slopes], model.parts(x)[2], others)[1]
    first = model.waves + e * stars.widths
    at, rest = np.arange(first, first + 2 * e), np.arange(first + 2 * e, local.shape[1] - 1)
    own, mixed = local[:, rest[:, None], rest], local[:, rest[:, None], at]
    carried = np.linalg.solve(own, np.concatenate([mixed, local[:, rest, -1:]], axis=2))
    # Schur complement: information on the slopes with the own parameters of each star eliminated.
    left = local[:, at[:, None], np.append(at, -1)] - mixed.swapaxes(1, 2) @ carried
    size = np.linalg.solve(left[:, :, :-1], left[:, :, -1:])[:, :, 0]
    sigmas = sigmas_of(float((size * left[:, :, -1]).sum()), size.size)
    if sigmas < _SURE:
        return []
    steepest = float(np.abs(size).max())
    text = (
        f"backgrounds slope ({sigmas:.2g} sigma), by up to {steepest:.2g} electrons per pixel: the slope of each "
        "background is estimated"
    )
    return [Finding("tilted_background", "note", text, {"sigmas": sigmas, "steepest": steepest})]
