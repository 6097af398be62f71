"""Distortion from known places: from images simulated apart from the package, and its standard errors."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
import searches
import simulated_fields as simulated
from lommel.estimation.distortion import Places, Sensor, displacement_at, fit_distortion
from lommel.estimation.field_signs import monomials
from lommel.lensfiles.tables import read_csv

NOISE = lm.Noise(read=2.0)
CHIP = Sensor((3000, 4000), 0.5)


def barrel(u, v):
    """Return displacements by rows and columns, pixels: third order about a point beside the middle."""
    r = u * u + v * v
    return np.stack([30.0 * v * r + 2.0 * u * v, 30.0 * u * r + u * u - 0.5 * v * v], axis=-1)


def grid(count, reach=0.9):
    """Return places of a grid on the sensor, and u and v there."""
    v, u = (part.ravel() for part in np.meshgrid(*2 * [np.linspace(-reach, reach, count)], indexing="ij"))
    return np.stack([(v + 1.0) * 1500.0, (u + 1.0) * 2000.0], axis=1) - 0.5, u, v


def turned(places, angle=0.3, scale=7e-3):
    """Return the places in another unit, from another origin, of a chart that is turned."""
    c, s = scale * np.cos(angle), scale * np.sin(angle)
    return (places - 500.0) @ np.array([[c, s], [-s, c]])


def ideal_error(found, given, ideal):
    """Return displacements less the true ones (n, 2), without what another alignment of the chart would change."""
    spots = found.ideal
    u, v = CHIP.relative(*CHIP.positions(spots))
    true_u, true_v = CHIP.relative(*CHIP.positions(ideal))
    return spots + displacement_at(found, u, v) - ideal - barrel(true_u, true_v)


def test_pinholes_at_known_places_tell_the_distortion_and_the_table_has_it(tmp_path):
    draw, scope = np.random.default_rng(5), simulated.Telescope(2, side=64)
    ideal, u, v = grid(4)
    true = ideal + barrel(u, v)
    places = np.rint(true)
    waves = np.stack([0.4 + 0.3 * u, 0.3 * v], axis=-1)
    light = [scope.image(w, at, 0.5, 15, 0.5, 1.5) for w, at in zip(waves, true - places, strict=True)]
    images = draw.poisson(2e4 * np.array(light) + 20.0) + draw.normal(size=(16, 15, 15)) * 2.0
    given = turned(ideal)
    given[5] = np.nan
    given[9] += 0.2
    lens = lm.Pupil(wavelength=500e-9, f_number=4.0)
    options = {"sensor": CHIP.shape, "noise": NOISE, "degree": 1, "terms": 2, "defocus": 1.5, "integrate": True}
    fit = searches.fit_field(images, places, lens, pixel=1e-6, ideal=given, distortion=2, **options)
    assert fit.converged, fit.message
    assert fit.distortion.degree == 2
    again = searches.fit_field(images, places, lens, pixel=1e-6, ideal=ideal, distortion=1, **options)
    assert again.distortion.degree == 1
    # The cubic part that these degrees do not have is scatter, and told.
    assert "places scatter by" in again.message
    assert again.distortion.scatter > 1.0
    x, y = (fit.distortion.ideal[0, ::-1] - [1999.5, 1499.5]) * 1e-6
    move, error = fit.distortion.at(x, y)
    seen = fit.distortion.ideal[0] + move - true[0]
    assert (np.abs(seen) < 4.0 * np.hypot(error, fit.distortion.scatter)).all()
    edge = fit.field.pupil(x, y).wavefront.edge_terms()
    np.testing.assert_allclose([edge[1, -1], edge[1, 1]], move * 0.5 * np.pi, rtol=1e-9)
    fit.save(tmp_path / "field.csv")
    made = read_csv(tmp_path / "field.csv", "noll").field_map(lens, unit="waves", normalization="rms", direction="x")
    for term, value in edge.items():
        assert abs(made.pupil(x, y).wavefront.edge_terms().get(term, 0.0) - value) < 1e-6
    assert "# standard errors of the distortion in the middle, pixels" in (tmp_path / "field.csv").read_text(
        encoding="utf-8"
    )


def simulate(draw, scatter, wrong=False):
    """Return a distortion from places whose errors are as stated, shared ones too, and the ideal places."""
    ideal, u, v = grid(6)
    n = len(ideal)
    root = draw.normal(size=(n, 2, 2)) * 0.01 + 0.02 * np.eye(2)
    noise = root @ root.swapaxes(1, 2)
    mixed = draw.normal(size=(n, 2, 3)) * 0.05
    shift = np.einsum("nij,nj->ni", root, draw.normal(size=(n, 2))) + mixed @ draw.normal(size=3)
    seen = ideal + barrel(u, v) + scatter * draw.normal(size=(n, 2))
    places = Places(seen + shift, noise, mixed, np.eye(3))
    given = turned(ideal)
    if wrong:
        given[7] = given[8]
    return fit_distortion(given, np.arange(n), places, degree=3, sensor=CHIP), given, ideal


@pytest.mark.parametrize("scatter", [0.0, 0.1])
def test_standard_errors_are_those_of_simulated_places(scatter):
    draw, total, ranks = np.random.default_rng(1), 0.0, 0
    for _ in range(30):
        found, given, ideal = simulate(draw, scatter)
        off = ideal_error(found, given, ideal)
        basis = np.linalg.pinv(monomials(*CHIP.relative(*CHIP.positions(found.ideal)), 3))
        error = (basis @ off).T.ravel()
        inverse = np.linalg.pinv(found.covariance, rcond=1e-9, hermitian=True)
        total += error @ inverse @ error
        ranks += np.linalg.matrix_rank(found.covariance, tol=1e-9 * np.abs(found.covariance).max())
    assert ranks == 30 * 16
    assert 0.8 < total / ranks < 1.35


def test_a_wrong_place_is_rejected():
    found, given, ideal = simulate(np.random.default_rng(4), 0.02, wrong=True)
    assert "rejected 1 of " in found.message
    assert np.flatnonzero(np.isnan(found.residuals[:, 0])).tolist() == [7]
    assert np.abs(np.delete(ideal_error(found, given, ideal), 7, axis=0)).max() < 0.5


def test_the_pose_leaves_no_magnification_over_the_sensor():
    found, _, _ = simulate(np.random.default_rng(6), 0.0)
    line = (np.arange(60) + 0.5) / 30.0 - 1.0
    u, v = np.meshgrid(line, line)
    move = displacement_at(found, u, v)
    down, across = v * 1500.0, u * 2000.0
    for moved in (move[..., 0], move[..., 1], move[..., 0] * down + move[..., 1] * across,
                  move[..., 0] * across - move[..., 1] * down):  # fmt: skip
        assert abs(moved.mean()) < 0.02 * np.abs(moved).mean()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"ideal": np.ones((16, 2))}, "not all on one line"),
        ({"ideal": grid(4)[0][:, ::-1]}, "places may be in another order, mirrored"),
    ],
)
def test_bad_places_are_told(change, message):
    windows, places = np.random.default_rng(1).poisson(100.0, (16, 9, 9)).astype(float), np.rint(grid(4)[0])
    with pytest.raises(ValueError, match=message):
        searches.fit_field(windows, places, lm.Pupil(), sensor=CHIP.shape, pixel=0.5, noise=NOISE, **change)
