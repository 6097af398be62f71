"""Table of beads: Gaussians against noise of profiles that are none, heights, focal surface, pairs of channels."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest
import scipy

import bead_fields
import lommel as lm
from lommel.estimation.bead_table import (
    _lines,
    _rivals,
    chromatic_shifts,
    common_error,
    focal_surface,
    gaussian_fit,
    gaussian_widths,
    heights,
    middle_of,
    place_of,
    row_of,
    summary,
    with_shared,
)
from lommel.measures.spot import profile_width


def profile(center=9.3, width=3.1):
    """Return electrons along a line through an Airy-like image: no Gaussian, with rings and a background."""
    x = (np.arange(21) - center) / width
    return 900.0 * np.sinc(x) ** 2 * (1.0 + 0.3 * np.tanh(x)) + 20.0


def test_errors_of_a_gaussian_are_the_scatter_of_fits_to_profiles_that_are_none():
    truth, rng, found = gaussian_fit(profile(), profile())[0], np.random.default_rng(3), []
    for _ in range(60):
        p, covariance = gaussian_fit(rng.poisson(profile()).astype(float), profile())
        found.append((p - truth) / np.sqrt(np.diag(covariance)))
    rms = np.sqrt(np.mean(np.square(found), axis=0))
    assert np.all((rms > 0.75) & (rms < 1.25)), rms


def test_a_gaussian_is_itself_where_pixels_are_left_out():
    x = np.arange(15.0)
    y = 5.0 + 70.0 * np.exp(-0.5 * ((x - 6.2) / 1.7) ** 2)
    y[[5, 9]] = np.nan
    p, _ = gaussian_fit(y, np.ones(15))
    np.testing.assert_allclose(p, [5.0, 70.0, 6.2, 1.7], rtol=1e-6)


@pytest.mark.parametrize("values", [np.ones(15), np.arange(15.0), np.array([1.0, 2.0, 1.0])])
def test_a_profile_without_a_width_is_refused(values):
    with pytest.raises(ValueError, match="a profile"):
        gaussian_fit(values, np.ones(len(values)))


def test_errors_common_to_all_beads_cancel_in_heights():
    z = np.array([3e-8, 1e-8, 8e-8, 9e-8, 0.0])
    covariance = np.full((5, 5), 4e-16) + np.diag(np.full(5, 1e-18))
    covariance[4] = covariance[:, 4] = math.nan
    found, errors = heights(covariance, z, ["a", "a", "b", "b", "b"])
    np.testing.assert_allclose(found[:4], [1e-8, -1e-8, -5e-9, 5e-9], rtol=1e-9)
    np.testing.assert_allclose(errors[:4], 1e-9 * math.sqrt(0.5), rtol=1e-6)
    assert np.isnan([found[4], errors[4]]).all()


def test_tilt_and_curvature_of_the_focal_surface_are_found_whatever_the_heights_of_images():
    rng = np.random.default_rng(5)
    places, groups = rng.uniform(-6e-5, 6e-5, (24, 2)), ["a"] * 12 + ["b"] * 12
    x, y = places.T
    truth = {"tilt_x": 3e-3, "tilt_y": -1e-3, "curvature": 40.0}
    z = 3e-3 * x - 1e-3 * y + 20.0 * (x**2 + y**2) + np.repeat([0.0, 7e-7], 12)
    covariance, sizes, middle = np.full((24, 24), 4e-16) + np.diag(np.full(24, 1e-18)), [], (1e-4, 2e-4)

    def table(z):
        """Return rows with heights from the mean of each image."""
        pairs = zip(*heights(covariance, z, groups), places + middle, groups, strict=True)
        return [{"height": h, "height_error": e, "x": x, "y": y, "file": file} for h, e, (x, y), file in pairs]

    for _ in range(40):
        found = focal_surface(table(z + rng.normal(0.0, 1e-9, 24) + rng.normal(0.0, 2e-8)), middle)
        sizes.append([(found[name] - truth[name]) / found[f"{name}_error"] for name in truth])
    assert 0.75 < np.sqrt(np.mean(np.square(sizes))) < 1.15
    assert focal_surface(table(z)[:4], middle) is None
    np.testing.assert_allclose(middle_of(table(z)), places.mean(axis=0) + middle, rtol=1e-12)
    assert focal_surface([{"height": None, "x": None, "y": 0.0, "file": ""}], middle_of([])) is None


def test_beads_of_two_channels_are_paired_by_place_and_date():
    def row(wave, x, date="2026-12-01", focus=1e-7):
        return {
            "bead": f"{wave}", "date": date, "wavelength": wave, "x": x, "y": 2e-6, "focus": focus, "z": 1e-8,
            "x_psf": x + 1e-8, "x_psf_error": 3e-9, "x_psf_common": 1e-9, "z_error": None, "z_common": None,
        }  # fmt: skip

    green, far = row(5.2e-7, 1e-6), row(5.2e-7, 9e-6)
    red, other = row(6.1e-7, 1.02e-6, focus=3e-7), row(6.1e-7, 1.01e-6, "2026-12-02")
    (pair,) = chromatic_shifts([red, far, other, green])
    assert pair["wavelengths"] == (5.2e-7, 6.1e-7)
    found = [pair[f"shift_{name}"] for name in ("x", "z", "x_psf", "x_psf_error", "x_psf_common")]
    np.testing.assert_allclose(found, [2e-8, 2e-7, 2e-8, 4.24264e-9, 1.41421e-9], 1e-5)
    assert not {"shift_z_psf", "shift_y_psf", "shift_x_error"} & {*pair}


def test_errors_of_places_are_the_scatter_of_fits_and_shared_ones_stay_in_a_mean():
    rng, covariance, sizes = np.random.default_rng(4), np.full((5, 5), 4e-4) + np.diag(np.full(5, 1e-4)), []
    covariance[4] = covariance[:, 4] = math.nan
    assert common_error(covariance) == pytest.approx(0.02)
    assert common_error(covariance[3:, 3:]) == 0.0
    fit = SimpleNamespace(
        converged=True, row_covariance=covariance, column_covariance=covariance, z_covariance=1e-12 * covariance
    )
    for _ in range(40):
        places = rng.normal(0.0, 0.01, (4, 3)) + rng.normal(0.0, 0.02, 3)
        errors = {"row": math.sqrt(5e-4), "column": math.sqrt(5e-4), "z": math.sqrt(5e-16)}
        rows = [
            place_of(SimpleNamespace(row=8 + r, column=7 + c, z=1e-6 * z, errors=errors), fit, 1e-7, (10, 20))
            for r, c, z in places
        ]
        for name, truth in (("x_psf", 2.7e-6), ("y_psf", 1.8e-6), ("z", 0.0)):
            (one,) = summary(rows, [name])
            sizes.append(
                [(one["mean"] - truth) / one["mean_error"], (rows[0][name] - truth) / rows[0][f"{name}_error"]]
            )
    rms = np.sqrt(np.mean(np.square(sizes), axis=0))
    assert np.all((rms > 0.85) & (rms < 1.15)), rms
    fit.converged = False  # a misfit has no errors of places
    bead = SimpleNamespace(row=8.0, column=7.0, z=1e-6, errors={"row": 0.01, "column": 0.01, "z": math.nan})
    assert {name for name, value in place_of(bead, fit, 1e-7, (0, 0)).items() if value is not None} == {"z"}


def test_a_summary_has_the_spread_and_the_errors_of_known_values():
    rows = [{"strehl": 0.8, "strehl_error": 0.03}, {"strehl": 0.9, "strehl_error": 0.04}, {"strehl": None}]
    (found,) = summary(rows, ["strehl", "rms"])
    assert found["beads"] == 2
    np.testing.assert_allclose(
        [found["mean"], found["spread"], found["error"]], [0.85, 0.0707107, 0.0353553], rtol=1e-5
    )


def test_widths_and_strehl_ratio_of_a_fit_are_those_of_another_simulator():
    wave, terms, z = 520e-9, {"astigmatism": 0.3, "spherical": -0.25}, (np.arange(9) - 4) * 300e-9
    light = bead_fields.point(z, (8.2, 7.7), 17, terms, wave)
    noise = lm.Noise(read=1.6, offset=100, white=0.5)
    stack = noise.record(3e4 * light / light[4].sum() + 10.0, seed=2)
    objective = lm.Objective(NA=bead_fields.NA, magnification=60, immersion=1.333, sample=1.333)
    microscope = lm.Microscope(objective, wave, bead_fields.PIXEL)
    fit = lm.fit_beads(stack, microscope, z=z, noise=noise, terms=7, priors={})
    row = row_of(fit, noise, 300e-9, bead_fields.PIXEL / 60.0, (3, 5))
    zs, line = np.arange(-50, 51) * 20e-9, np.arange(-40, 41) * 10e-9
    axis, peaks = (bead_fields.intensity(zs, [0.0], [0.0], one, wave)[:, 0, 0] for one in (terms, {}))
    focus = [zs[axis.argmax()]]
    truth = {
        "fwhm_x": 10e-9 * profile_width(bead_fields.intensity(focus, [0.0], line, terms, wave)[0, 0]),
        "fwhm_y": 10e-9 * profile_width(bead_fields.intensity(focus, line, [0.0], terms, wave)[0, :, 0]),
        "fwhm_z": 20e-9 * profile_width(axis), "strehl": axis.max() / peaks.max(),
    }  # fmt: skip
    for name, value in truth.items():
        assert row[name] == pytest.approx(value, rel=0.01), name
        assert 0.0 < row[f"{name}_error"] < 0.01 * value
    assert row["x"] == pytest.approx(12.7 * 108.33e-9, abs=3.0 * row["x_error"] + 5e-9)
    assert row["rms"] == pytest.approx(math.hypot(0.3, 0.25), abs=4.0 * row["rms_error"] + 0.005)
    assert row["reason"] is None
    joint = with_shared(row, fit, fit.beads[0].depth)  # a single bead shares all of its errors
    for name in ("fwhm_x", "fwhm_z", "strehl", "rms"):
        assert joint[f"{name}_common"] == pytest.approx(row[f"{name}_error"], rel=0.5)
        assert joint[f"{name}_common"] >= row[f"{name}_error"]
    place, pitch = place_of(fit.beads[0], fit, bead_fields.PIXEL / 60.0, (3, 5)), bead_fields.PIXEL / 60.0
    for name, value in (("x_psf", 12.7 * pitch), ("y_psf", 11.2 * pitch)):
        assert place[name] == pytest.approx(value, abs=4.0 * place[f"{name}_error"])
        assert 0.0 < place[f"{name}_error"] < 1e-9
    for matrix, name in ((fit.row_covariance, "row"), (fit.column_covariance, "column")):
        assert math.sqrt(matrix[0, 0]) == pytest.approx(fit.beads[0].errors[name])


def test_widths_run_through_the_maximum_where_coma_and_astigmatism_move_it():
    wave, z = 520e-9, (np.arange(11) - 5) * 250e-9
    terms = {"astigmatism": 0.307, "oblique": 0.241, "coma": -0.678}
    light = bead_fields.point(z, (10.2, 9.7), 21, terms, wave)
    noise = lm.Noise(read=1.6, offset=100, white=0.5)
    objective = lm.Objective(NA=bead_fields.NA, magnification=60, immersion=1.333, sample=1.333)
    microscope = lm.Microscope(objective, wave, bead_fields.PIXEL)
    stack = noise.record(1e7 * light / light[5].sum() + 10.0, seed=2)
    fit = lm.fit_beads(stack, microscope, z=z, noise=noise, terms=4, priors={})

    def at(point):
        x, y, height = np.asarray(point) * 1e-7
        return bead_fields.intensity([height], [y], [x], terms, wave)[0, 0, 0]

    top = scipy.optimize.minimize(
        lambda point: -at(point), np.zeros(3), method="Nelder-Mead",
        options={"xatol": 1e-3, "fatol": 1e-9, "initial_simplex": np.vstack([np.zeros(3), np.eye(3)])},
    ).x * 1e-7  # fmt: skip
    line = np.arange(-60, 61)
    (x, y, height), steps = top, (10e-9, 10e-9, 25e-9)
    profiles = (
        bead_fields.intensity([height], [y], x + line * steps[0], terms, wave).ravel(),
        bead_fields.intensity([height], y + line * steps[1], [x], terms, wave).ravel(),
        bead_fields.intensity(height + line * steps[2], [y], [x], terms, wave).ravel(),
    )
    truth = [step * profile_width(profile) for step, profile in zip(steps, profiles, strict=True)]
    np.testing.assert_allclose(fit.fwhm(depth=0.0)[0], truth, rtol=1.5e-3)


def test_errors_of_gaussians_contain_which_of_two_voxels_is_brighter():
    noise, found = lm.Noise(read=1.6), []
    z, y, x = np.mgrid[-8:9, -10:11, -10:11].astype(float)
    tilt = x - 0.5 - 0.12 * z  # coma and astigmatism: lines through neighbours differ
    mean = 10.0 + 400.0 * np.exp(-0.5 * ((tilt / 1.6) ** 2 + (y / 1.5) ** 2 + (z / (2.5 + 0.3 * tilt)) ** 2))
    light = {"flux": np.full(17, 1e4), "flux_errors": np.full(17, 100.0)}
    clean = SimpleNamespace(images=mean, model=mean, **light)
    first = gaussian_widths(clean, noise)
    errors = first.fwhm_errors[0]
    (rival, share), *_ = _rivals(mean, mean + 2.56, np.full(17, 0.01), np.unravel_index(mean.argmax(), mean.shape))
    assert share > 0.1
    other = _lines(mean, mean + 2.56, rival)[0, 0]
    assert abs(other - first.fwhm[0]) > 0.02 * other
    assert errors > 0.3 * abs(other - first.fwhm[0])
    for seed in range(30):
        image = noise.record(mean, seed=seed)
        shifted = mean * (1.0 + 3e-3 * np.random.default_rng(seed).normal() * tilt / 1.6)
        one = gaussian_widths(SimpleNamespace(images=image, model=shifted, **light), noise)
        found.append((one.fwhm[0] - first.fwhm[0]) / one.fwhm_errors[0])
    assert np.sqrt(np.mean(np.square(found))) < 1.3
