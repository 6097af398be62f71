"""Aberrations of an objective over the field, from fits of beads: polynomials, priors, scatter."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import lommel as lm
from lommel.fit import Finding, Findings

OIL = lm.Objective(NA=1.3, magnification=63, immersion=1.518, sample=1.33)
Z = np.linspace(-0.6e-6, 0.6e-6, 5)
CAMERA = lm.Noise(read=1.6)
SENSOR = (1000, 2000)
PRIOR = 0.003
MISFIT = Finding("misfit", "error", "the images do not fit")
PLACES = np.stack(np.meshgrid([50, 500, 950], [100, 700, 1300, 1900], indexing="ij"), axis=-1).reshape(-1, 2)


def terms(row, column):
    """Return astigmatism and coma, radians rms."""
    u, v = (2.0 * (np.asarray(part) + 0.5) / side - 1.0 for part, side in ((column, 2000), (row, 1000)))
    return np.stack([0.2 + 0.1 * u, 0.15 * v - 0.1 * u * v], axis=-1)


def fitted(row, column, seed, **options):
    fifth, seventh = terms(row, column)
    wave = lm.Wavefront.zernike({5: fifth, 7: seventh, 8: 0.1}, order="noll")
    truth = OIL.pupil(depth=0.0, z=Z, wavelength=600e-9, aberrations=wave)
    bead = CAMERA.record(2e4 * lm.psf(truth, 13, 6.5e-6, tol=1e-4).values + 10, seed=seed)
    chosen = {"z": Z, "wavelength": 600e-9, "pixel": 6.5e-6, "noise": CAMERA, "terms": ["noll 5", "noll 7"]}
    start = lm.Wavefront.zernike({8: 0.1}, order="noll")
    return lm.fit_beads(bead, OIL, **(chosen | {"priors": {"sample": PRIOR}, "aberrations": start} | options))


@cache
def one():
    return fitted(400, 700, 1)


def simulated(draw, scatter=0.0, places=PLACES):
    """Return fits whose images say what they state, of one sample, with the same prior in each, and the sample."""
    sample = 1.33 + PRIOR * draw.normal()
    made, fit = [], one()
    prior = np.diag([0.0, 0.0, PRIOR**-2])
    for row, column in places:
        root = np.diag([0.02, 0.015, 0.005]) @ (np.eye(3) + 0.4 * draw.normal(size=(3, 3)))
        information = np.linalg.inv(root @ root.T)
        true = np.append(terms(row, column) + scatter * draw.normal(size=2), sample)
        seen = true + root @ draw.normal(size=3)
        covariance = np.linalg.inv(information + prior)
        values = covariance @ (information @ seen + prior @ [0.0, 0.0, 1.33])
        coefficients = dict(zip(fit.coefficients, values.tolist(), strict=True))
        made.append(replace(fit, coefficients=coefficients, covariance=covariance, findings=Findings()))
    return made, sample


def error_of(found, sample):
    """Return coefficients and the sample less the true ones."""
    rows, columns = (part.ravel() for part in np.meshgrid(*(np.linspace(0, n - 1, 7) for n in SENSOR), indexing="ij"))
    off = found.at(rows, columns)[0] - terms(rows, columns)
    u, v = 2.0 * (columns + 0.5) / 2000 - 1.0, 2.0 * (rows + 0.5) / 1000 - 1.0
    basis = np.stack([np.ones_like(u), u, v, 1.5 * u * u - 0.5, u * v, 1.5 * v * v - 0.5], axis=-1)
    return np.append((np.linalg.pinv(basis) @ off).T.ravel(), found.constants["sample"] - sample)


@pytest.mark.parametrize("scatter", [0.0, 0.06])
def test_standard_errors_are_those_of_many_fields(scatter):
    draw, total, samples, squares = np.random.default_rng(1), [], [], []
    for _ in range(40):
        fits, sample = simulated(draw, scatter)
        found = lm.fit_objective_field(fits, PLACES, sensor=SENSOR, degree=2)
        error = error_of(found, sample)
        total.append(error @ np.linalg.solve(found.covariance, error) / error.size)
        squares.append(found.chi2)
        samples.append(error[-1] / np.sqrt(found.covariance[-1, -1]))
    assert 0.8 < np.mean(total) < (1.2 if scatter == 0.0 else 1.5)
    assert abs(np.mean(squares) - 1.0) < 0.15 or scatter > 0.0
    assert 0.75 < np.sqrt(np.mean(np.square(samples))) < 1.25


def test_images_of_beads_tell_the_terms_over_the_field():
    places = [(500, 100), (500, 400), (500, 700), (500, 1000), (500, 1300), (500, 1900), (100, 1000), (900, 1000)]
    fits = [fitted(row, column, k) for k, (row, column) in enumerate(places)]
    found = lm.fit_objective_field(fits, places, sensor=SENSOR, degree=1)
    assert found.degree == 1
    values, errors = found.at(500, 1000)
    assert (np.abs(values - terms(500, 1000)) < 4.0 * errors).all()
    assert found.scatter < 0.01
    assert (errors < [fits[0].errors[2, -2], fits[0].errors[3, -1]]).all()
    wave = found.aberrations(500, 1000).edge_terms()
    np.testing.assert_allclose(wave[2, -2], values[0] * np.sqrt(6.0), rtol=1e-12)
    np.testing.assert_allclose(wave[3, 1], 0.1 * np.sqrt(8.0), rtol=1e-6)  # held fixed
    pupil = found.pupil(500, 1000, depth=1e-6, z=Z)
    assert lm.psf(pupil, 9, 6.5e-6, tol=1e-4).values.shape == (5, 9, 9)


def test_scatter_and_a_wrong_fit_are_told():
    draw = np.random.default_rng(5)
    places = np.concatenate([PLACES, PLACES + 7])
    found = lm.fit_objective_field(simulated(draw, 0.1, places)[0], places, sensor=SENSOR, degree=2)
    assert 0.06 < found.scatter < 0.15
    assert found.findings.get("scatter").numbers["scatter"] == found.scatter
    exact = simulated(draw, 0.0, places)[0]
    shifted = {name: value + 2.0 for name, value in exact[4].coefficients.items()}
    wrong = [
        *exact[:4],
        replace(exact[4], coefficients=shifted),
        replace(exact[5], findings=Findings([MISFIT])),
        *exact[6:],
    ]
    found = lm.fit_objective_field(wrong, places, sensor=SENSOR, degree=2)
    assert np.flatnonzero(~found.used).tolist() == [4, 5]
    assert found.findings.text.endswith("1 far off rejected; 1 did not converge")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"fits": [1, 2]}, "fits must be a sequence of BeadFit"),
        ({"places": [(0, 0)]}, "places must be a row and a column for each of 12 fits"),
        ({"places": PLACES + 5000}, "places must be in the image of 1000 x 2000"),
        ({"count": 3}, "fits must be at least 4 that converged, got 3 of 3"),
        ({"other": {"wavelength": 650e-9}}, "fits must be of one objective, camera, wavelength and priors"),
        ({"other": {"priors": {"sample": 0.005}}}, "fits must be of one objective, camera, wavelength and priors"),
        ({"other": {"terms": ["noll 5"]}}, "fits must have the same terms and constants"),
        ({"degree": 9}, "degree must be from 0 to 4"),
    ],
)
def test_what_cannot_be_combined_is_told(change, message):
    fits = simulated(np.random.default_rng(2))[0][: change.get("count", 12)]
    if "other" in change:
        fits[3] = replace(fitted(400, 700, 1, **change["other"]), findings=Findings())
    fits = change.get("fits", fits)
    places = change.get("places", PLACES[: len(fits)])
    with pytest.raises((TypeError, ValueError), match=message):
        lm.fit_objective_field(fits, places, sensor=SENSOR, degree=change.get("degree", 2))
