"""Coma of a defocused star, against pictures by the FFT of a sampled pupil, blurred and with noise."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import scipy

import lommel as lm
from lommel.estimation import collimation
from lommel.estimation.collimation import Vector, _binned, find_star, mean_coma, measure_collimation
from lommel.fit.findings import Finding, Findings

TELESCOPE = lm.Lens(focal_length=2.0, aperture_diameter=0.2, obscuration=0.35, wavelength=550e-9)
PIXEL = 7.6e-6


def donut(waves, x=0.0, y=0.0, astigmatism=0.0, *, side=72, seed=1, electrons=2e5, trail=0):
    """A star in counts (2 electrons per count, offset 200); terms in waves rms, coma along columns and rows.

    It moves by so many pixels along columns during the exposure.
    """
    # Samples of half a pixel: the pupil has a diameter of so many cells in a transform of `count`.
    count, n = 4 * side, 10.0
    cells = 0.5 * PIXEL * count / (550e-9 * n)
    axis = (np.arange(count) - count // 2) * 2.0 / cells
    v, u = np.meshgrid(axis, axis, indexing="ij")
    r2 = u**2 + v**2
    phase = (
        waves * r2
        + math.sqrt(8.0) * (3.0 * r2 - 2.0) * (x * u + y * v)
        + math.sqrt(6.0) * astigmatism * (u**2 - v**2)
    )
    field = np.exp(2j * np.pi * phase) * ((r2 < 1.0) & (r2 > 0.35**2))
    light = np.fft.fftshift(np.abs(np.fft.fft2(np.fft.ifftshift(field))) ** 2)
    light = scipy.ndimage.gaussian_filter(light / light.sum(), 2.0)
    light = scipy.ndimage.uniform_filter1d(light, 2 * trail + 1, axis=1, mode="wrap")
    # Pixels of 2 x 2 samples, centred on the axis.
    light = 0.25 * sum(np.roll(light, shift, (0, 1)) for shift in ((0, 0), (0, 1), (1, 0), (1, 1)))
    pixels = 4.0 * light[::2, ::2][side // 2 : side // 2 + side, side // 2 : side // 2 + side]
    draw = np.random.default_rng(seed)
    return (draw.poisson(electrons * pixels + 10.0) + 2.0 * draw.normal(size=pixels.shape)) / 2.0 + 200.0


@pytest.mark.parametrize("waves", [6.0, -6.0])
def test_coma_has_its_direction_on_both_sides_of_focus(waves):
    found = measure_collimation(donut(waves, 0.12, -0.16, 0.05), TELESCOPE, PIXEL, outside=waves < 0.0)
    assert found.fit.converged
    assert found.coma.size == pytest.approx(0.2, abs=4.0 * found.coma.error)
    assert found.coma.error < 0.01
    assert found.coma.angle == pytest.approx(math.atan2(-0.16, 0.12), abs=math.radians(2.0))
    # Inside focus the star is longer where the phase is larger, outside focus across.
    assert abs(math.sin(found.astigmatism.angle)) == pytest.approx(float(waves < 0.0), abs=0.2)
    assert found.waves == pytest.approx(waves, abs=0.2)
    # The side of focus is not needed for either direction.
    other = measure_collimation(donut(waves, 0.12, -0.16, 0.05), TELESCOPE, PIXEL, outside=waves > 0.0)
    assert other.coma.angle == pytest.approx(found.coma.angle, abs=0.01)
    assert abs(math.sin(other.astigmatism.angle)) == pytest.approx(float(waves < 0.0), abs=0.2)
    assert other.spherical[0] == pytest.approx(-found.spherical[0], abs=found.spherical[1])


def test_a_star_that_drifts_has_no_more_coma_or_astigmatism():
    found = measure_collimation(donut(6.0, 0.12, -0.16, 0.05, trail=10), TELESCOPE, PIXEL)
    (motion,) = (blur for blur in found.fit.blurs[0] if isinstance(blur, lm.Motion))
    assert motion.length == pytest.approx(10.5 * PIXEL, rel=0.1)
    assert abs(math.sin(motion.angle)) < 0.05
    assert found.coma.size == pytest.approx(0.2, abs=max(3.0 * found.coma.error, 0.01))  # 0.24 without the trail
    assert abs(math.sin(found.astigmatism.angle)) < 0.3


def test_a_misfit_names_its_causes_and_large_errors_are_in_doubt(monkeypatch):
    picture = donut(6.0, 0.12, -0.16)
    whole = collimation.fit_stars

    def changed(missed, *findings):
        def fit_stars(*args, **options):
            fit = fits[0] if fits else fits.append(whole(*args, **options)) or fits[0]
            errors = {name: missed * fit.errors[name] / 0.01 for name in fit.coefficients}
            return replace(fit, findings=Findings(findings), errors=fit.errors | errors)

        monkeypatch.setattr(collimation, "fit_stars", fit_stars)
        return measure_collimation(picture, TELESCOPE, PIXEL).fit

    fits = []
    doubt = Finding("missed_light", "doubt", "the model misses 9 % of the light")
    assert changed(0.01, doubt).reliable  # errors contain it
    assert not changed(9.0, doubt).reliable  # of phases in which images are not linear
    # Of 6 waves out of focus, a wave rms of coma changes the light by 17 / 6.
    (steady,) = (
        f for f in changed(0.01, replace(doubt, numbers={"missed": 0.085})).findings if f.severity == "doubt"
    )
    assert "each aberration by 0.03 waves" in steady.text
    assert changed(0.01, replace(doubt, numbers={"missed": 0.04})).reliable  # as of averaged turbulence
    scale = {"f_number": {"value": 6.4, "error": 0.06, "stated": 10.0}}
    (wrong,) = (f for f in changed(0.01, Finding("estimated", "note", "", scale)).findings if f.severity == "doubt")
    assert "f/6.4 +- 0.06, but f/10 is stated" in wrong.text
    scale["f_number"] |= {"value": 9.7}
    assert changed(0.01, Finding("estimated", "note", "", scale)).reliable
    misfit = changed(0.01, Finding("misfit", "error", "chi2 99"))
    assert not misfit.converged
    assert "turbulence that is not averaged" in misfit.message


def test_the_noise_of_a_dim_star_is_that_of_its_residuals(monkeypatch):
    whole, chi2 = collimation.fit_stars, []

    def fit_stars(counts, *args, **options):
        fit = whole(counts, *args, **options)
        chi2.append(fit.chi2)
        return fit

    monkeypatch.setattr(collimation, "fit_stars", fit_stars)
    # Noise that is found in one picture, by a fifth too large.
    monkeypatch.setattr(
        collimation,
        "measured_noise",
        lambda window, read: (lm.Noise(white=1.6, read=2.0, offset=200.0), None),
    )
    found = measure_collimation(donut(6.0, 0.12, -0.16, electrons=4e4), TELESCOPE, PIXEL)
    assert chi2[0] == pytest.approx(0.8, abs=0.08)
    assert chi2[1] == pytest.approx(1.0, abs=0.08)
    assert found.fit.converged
    assert found.coma.size == pytest.approx(0.2, abs=3.0 * found.coma.error)


def test_an_outline_includes_the_dim_side_and_the_hole():
    rows, columns = np.indices((120, 150))
    r = np.hypot(rows - 50.0, columns - 70.0)
    ring = np.where((r < 30.0) & (r > 10.0), 1000.0 * (1.0 + 0.8 * (columns - 70.0) / 30.0), 0.0)
    picture = 100.0 + ring + np.random.default_rng(0).normal(size=ring.shape)
    row, column, radius = find_star(picture)
    assert (row, column, radius) == pytest.approx((50.0, 70.0, 31.0), abs=1.5)
    saturated = np.where(picture > 1500.0, np.nan, picture)
    assert find_star(saturated).radius == pytest.approx(radius, abs=1.0)
    picture[5, 140] = picture[40, 70] = 1e6  # hot pixels
    assert find_star(picture) == pytest.approx((row, column, radius), abs=0.1)


def test_pixels_that_are_wrong_are_left_out_and_told():
    picture = donut(6.0, 0.12, -0.16)
    bad = np.minimum(picture, np.sort(picture.ravel())[-60])
    counts, step, found = _binned(bad, 18.0)
    assert step == 1
    assert (~counts.known).sum() == 60
    assert [finding.code for finding in found] == ["left_out"]
    assert (found[0].severity, "expose shorter" in found[0].text) == ("doubt", True)
    picture[::12, ::13] = 9e4 + np.arange(36).reshape(6, 6)
    counts, _, (hot,) = _binned(picture, 18.0)
    assert (hot.code, hot.numbers["pixels"]) == ("hot_pixels", 36)
    assert not counts.known[::12, ::13].any()


def test_a_stretched_picture_is_in_doubt():
    picture = donut(6.0)
    stretched = (np.maximum(picture - 200.0, 0.0) / np.ptp(picture)) ** (1.0 / 2.2)
    assert "values are stretched" in _binned(255.0 * stretched, 18.0)[2][0].text
    assert not _binned(picture, 18.0)[2]


@pytest.mark.parametrize(
    ("picture", "words"),
    [
        (np.random.default_rng(0).normal(size=(60, 60)), "none above the noise"),
        (np.pad(np.full((40, 40), 9.0), ((0, 60), (30, 30))), "at an edge"),
        (np.pad(np.full((3, 3), 9.0), 40), "defocus more"),
        (np.zeros((40, 40)), "none above the noise"),
        (np.pad(np.hypot(*(np.indices((40, 80)) % 40 - 19.5)[:, :, :]) < 20.0, 30) * 99.0, "another star touches it"),
    ],
)
def test_pictures_without_a_defocused_star_are_refused(picture, words):
    with pytest.raises(ValueError, match=words):
        find_star(picture)


def test_a_star_near_focus_is_refused():
    r = np.hypot(*(np.indices((80, 80)) - 40.0))
    with pytest.raises(ValueError, match=r"out of focus, got 0\.5"):
        measure_collimation(np.where(r < 10.0, 100.0, 0.0), TELESCOPE, 1.0e-6)


def test_a_telescope_that_makes_the_star_too_many_waves_out_of_focus_is_refused():
    picture = np.zeros((90, 90))
    picture[25:66, 25:66] = np.hypot(*np.mgrid[-20:21, -20:21]) < 20.0
    small = lm.Lens(focal_length=2.0, aperture_diameter=2.0, wavelength=550e-9)
    with pytest.raises(ValueError, match=r"got 7\d .* f/1 and wavelength: correct the aperture"):
        measure_collimation(picture, small, PIXEL)


def test_a_mean_allows_for_the_scatter():
    mean = mean_coma([0.3 + 0.1j, 0.3 + 0.1j], [0.01, 0.01])
    assert (mean.size, mean.error) == pytest.approx((math.hypot(0.3, 0.1), 0.01 / math.sqrt(2.0)))
    assert mean_coma([0.1 + 0.0j, 0.0j], [0.002, 0.002]).error > 0.03
    scattered = mean_coma([0.3 + 0.1j, 0.5 + 0.1j, 0.4 - 0.1j], [0.01] * 3)
    values = np.array([[0.3, 0.1], [0.5, 0.1], [0.4, -0.1]])
    assert scattered.error == pytest.approx(np.sqrt(values.var(axis=0, ddof=1).mean() / 3.0))
    assert Vector.of(0.02 + 0.0j, 0.01).angle is None


def test_a_mean_keeps_the_part_of_errors_that_pictures_share():
    alike = mean_coma([0.3 + 0.1j] * 4, [0.05] * 4, [0.03, 0.03, 0.03, 0.03])
    assert alike.error == pytest.approx(math.hypot(0.04 / 2.0, 0.03))
    assert mean_coma([0.3 + 0.1j] * 100, [0.0] * 100, [0.03]).error == pytest.approx(0.03)
