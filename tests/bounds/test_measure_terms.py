"""Errors, tolerances and limits of measures and of interpolation, number by number."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel import methods
from lommel.blur import recorded
from lommel.core.answers import Samples, Wanted
from lommel.measures import continuous_image, energy, overlap, slanted_edge, spot, transfer
from lommel.measures.psf_like import ColourPSFLike
from lommel.optics.grid import Grid
from lommel.special import interpolation

RNG = np.random.default_rng(5)
COMA = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0}), obscuration=0.4)


class Asked(Exception):  # noqa: N818 (no error: it tells what was asked for)
    pass


def stop(*arguments, **options):
    raise Asked(arguments)


def test_bins_of_an_edge_have_the_variance_of_a_pixel_over_their_number_of_pixels(monkeypatch):
    pixels = []
    monkeypatch.setattr(slanted_edge, "_noise", lambda distance, *_: pixels.append(len(distance)) or 3.0)
    monkeypatch.setattr(slanted_edge, "_response", stop)
    column = np.arange(60.0) - 28.0 - 0.09 * np.arange(50.0)[:, None]
    with pytest.raises(Asked) as told:
        slanted_edge.sfr(np.clip(column + 0.5, 0.0, 1.0), pixel=1e-6)
    counts = 9.0 / told.value.args[0][2]
    assert np.abs(counts - np.rint(counts)).max() < 1e-9
    assert counts.sum() == pytest.approx(pixels[0])


@pytest.mark.parametrize(("error", "kind"), [(2e-7, True), (math.nan, True), (2e-7, False)])
def test_energies_are_off_by_the_errors_of_all_samples_within_the_circle_and_the_cut(error, kind, monkeypatch):
    image = continuous_image.CartesianImage(np.zeros((2, 2), complex), *np.eye(2), 1.0, error)
    other = SimpleNamespace(circles=lambda radii: radii, error=error)
    monkeypatch.setattr(energy, "energy_images", lambda *_: [image if kind else other])
    expected = 2e-8 + continuous_image.KERNEL_NORM * 9.0 * math.pi * 2e-7
    found = energy.encircled(COMA, [1.0, 3.0]).error
    assert found == (pytest.approx(expected, rel=1e-9, abs=0.0) if kind and error == 2e-7 else None)


@pytest.mark.parametrize(("bounds", "expected"), [((1e-3, 3e-3, 2e-3), 3e-3), ((1e-3, None, 2e-3), None)])
def test_the_bound_of_a_colour_image_is_the_largest_of_its_channels_if_all_have_one(bounds, expected):
    made = SimpleNamespace(psfs=[SimpleNamespace(error_bound=one) for one in bounds])
    assert ColourPSFLike.error_bound.fget(made) == expected


@pytest.mark.parametrize("white", [False, True])
def test_blurred_strehl_ratios_are_of_one_sample_to_the_default_tolerance(white, monkeypatch):
    """Or to that of the spectrum, which may be less than was asked for the image."""
    method = methods.Polychromatic([500e-9], [1.0], tol=1e-4) if white else methods.NijboerZernike(1e-3)
    pupil = lm.Pupil(wavelength=500e-9, f_number=4.0)
    psf = lm.psf(pupil, 3, 1e-6, method=method, blur=lm.Jitter(1e-6))
    monkeypatch.setattr(recorded, "recorded_images", stop)
    with pytest.raises(Asked) as told:
        spot.axis_strehl(psf)
    (used, tol, _, grid, blur, wanted), expected = told.value.args[0], (psf.method, 1e-4) if white else (None, 1e-6)
    assert ((used, tol), blur, wanted) == (expected, psf.blur, Wanted(1.0))
    assert (grid.shape, grid.pixel, grid.center) == ((1, 1), pupil.scale, Grid(1, 1.0).center)


@pytest.mark.parametrize(("lens", "period", "radius", "found"), [
    (False, math.inf, 630.0, True), (False, math.inf, 650.0, False), (True, math.inf, 2500.0, True),
    (True, math.inf, 2600.0, False), (True, 100.0, 49.0, True), (True, 100.0, 51.0, False),
])  # fmt: skip
def test_diameters_are_sought_up_to_a_quarter_of_the_widest_window_or_one_period(
    lens, period, radius, found, monkeypatch
):
    """From 10 lambda*N on the reach doubles while four times it is at most 1400, or 6000 in seeing."""
    single = SimpleNamespace(extent=10.0, pupil=None, method=SimpleNamespace(period=lambda _: period))
    model = SimpleNamespace(radial_method=None, single_models=[single])
    image = SimpleNamespace(circles=lambda r, center: 0.5 * r / radius)
    for name, made in (
        ("ImageModel", SimpleNamespace(of=lambda *_: model)), ("energy_centers", lambda *_: np.zeros((1, 2))),
        ("energy_images", lambda *_: [image]), ("is_radial_lens", lambda _: False),
        ("is_lens_in_seeing", lambda _: lens),
    ):  # fmt: skip
        monkeypatch.setattr(spot, name, made)
    psf = SimpleNamespace(pupil=lm.Pupil())
    if found:
        assert spot.energy_diameter(psf, 0.5) == pytest.approx(2.0 * radius, rel=1e-9, abs=0.0)
    else:
        with pytest.raises(ValueError, match="fraction must be reached within a diameter"):
            spot.energy_diameter(psf, 0.5)


def test_focus_is_tolerated_where_the_lower_contrast_of_both_directions_falls_to_the_least(monkeypatch):
    """With C_d = -pi z / (8 lambda N^2) for a displacement z of the sensor."""
    asked, _ = [], lm.mtf_frequency(lm.Pupil(), 0.9)

    def mtf(pupil, fx, fy, *, pixel, tol):
        c = pupil.radial_terms()[:, 0]
        asked.append((fx.tolist(), fy.tolist(), pixel, tol))
        values = np.stack([1.0 - 0.11 * np.abs(2.0 * c - 0.6), 1.0 - 0.09 * np.abs(2.0 * c + 0.8)], axis=-1)
        return values.reshape(*pupil.shape, 2)

    monkeypatch.setattr(transfer, "mtf", mtf)
    pupil = lm.Pupil(wavelength=500e-9, f_number=4.0)
    found = lm.focus_tolerance(pupil, 1e5, least=0.4, pixel=2e-6)
    ends = [(-(0.6 / 0.11) + 0.6) / 2.0, (0.6 / 0.09 - 0.8) / 2.0]
    assert sorted(found) == pytest.approx(sorted(-8.0 * 500e-9 * 16.0 / math.pi * c for c in ends), rel=1e-4, abs=0.0)
    assert set(map(str, asked)) == {str(([1e5, 0.0], [0.0, 1e5], 2e-6, 1e-8))}
    for least in (0.0, 1.0):
        with pytest.raises(ValueError, match="least must be"):
            lm.focus_tolerance(pupil, 1e5, least=least)
        with pytest.raises(ValueError, match="level must be"):
            lm.mtf_frequency(pupil, least)


@pytest.mark.parametrize(("tol", "share"), [(1e-6, None), (1e-15, 2e-15), (0.1, 0.05)])
def test_rules_over_an_overlap_have_45_hundredths_of_the_tolerance_that_pairs_of_segments_share(
    tol, share, monkeypatch
):
    asked, f = [], np.array([0.5, 0.0]) if share != 0.05 else np.array([0.98, 0.0])
    rule = SimpleNamespace(nodes=(np.zeros(0),) * 3)
    region = SimpleNamespace(rule=lambda *of: asked.append(of) or rule)
    mapped = type("Mapped", (), {"__and__": lambda *_: region})()
    regions = (SimpleNamespace(mapped=lambda *_: mapped),) * 2
    parts = overlap._ClearParts(regions, np.zeros((2, 3)), np.zeros((2, 2)), np.full(2, 2.0))
    monkeypatch.setattr(overlap, "degree_needed", lambda *of, **rest: asked.append((of[3], *rest.values())) or 7)
    overlap._general_otf(COMA, parts, f, f[0], tol)
    width = 1.0 - f[0]
    expected = share or 0.45 * tol * COMA.transmission / (width * math.sqrt(width * (1.0 + f[0])))
    assert asked[0] == pytest.approx((expected, 2.0, math.sqrt(1.0 + 0.5 * f[0] * width)), rel=1e-9, abs=0.0)
    assert asked[1:] == [(7, pytest.approx(expected / 4.0, rel=1e-9, abs=0.0))] * 4


@pytest.mark.parametrize("own", [1e-3, 1e-8])
def test_samples_of_a_continuous_image_are_as_exact_as_the_method_and_the_default(own, monkeypatch):
    monkeypatch.setattr(continuous_image, "candidates", stop)
    with pytest.raises(Asked) as told:
        continuous_image._sample(COMA, methods.ChordalGauss(own), Grid(3, 0.2), sum_spectrum=True)
    assert told.value.args[0][2] == min(own, 1e-6)
    monkeypatch.undo()
    left = replace(COMA, wavefront=lm.Wavefront(nonradial={(3, 1): 1.0}, error=2e-8))
    found = continuous_image._sample(left, methods.ChordalGauss(1e-6), Grid(9, 0.2), sum_spectrum=True)
    plain = continuous_image._sample(COMA, methods.ChordalGauss(1e-6), Grid(9, 0.2), sum_spectrum=True)
    e = 2e-8 * left.amplitude / math.sqrt(found.peak[0])
    assert found.error[0] - plain.error[0] == pytest.approx(2.0 * e, rel=1e-2, abs=0.0)


@pytest.mark.parametrize("off", [np.array([3e-4]), None])
def test_the_error_of_a_continuous_image_is_that_of_its_samples_per_light_and_area(off, monkeypatch):
    """The light of the plane is 4 pi times the transmission, an area of (lambda N)^2 is pi^2."""
    images = Samples(np.full((1, 1, 1), 0.2), np.ones(1), off, None, None)

    def sample(pupil, method, grid, **_):
        return images._replace(values=np.full((1, *grid.shape), 0.2))

    monkeypatch.setattr(continuous_image, "_sample", sample)
    model = continuous_image.ImageModel(COMA, methods.ChordalGauss())
    (found,) = continuous_image.cartesian_images(model, 3.0)
    assert (
        found.error == pytest.approx(math.pi / 4.0 / COMA.transmission * 3e-4 * 0.2, rel=1e-9, abs=0.0) or off is None
    )
    assert math.isnan(found.error) == (off is None)
    texts = [str(continuous_image._radius_error(COMA, 9.0, most)) for most in (None, 0.0, 2.0)]
    assert [text.partition("use a smaller distance")[2] for text in texts] == ["", "", " of at most 2 lambda*N"]


def test_interpolation_errs_by_its_largest_wave_at_points_and_what_polynomials_do_between_them():
    """At n points a polynomial of degree n / 2 is within sqrt(2) of its largest value, in t and in w."""
    made, t = interpolation.filtered_taps(1.2, 1e-4), 0.5 + 0.5 * np.cos((np.arange(80) + 0.5) * math.pi / 80)
    size, side = made.taps.size, made.filter.size - 1
    n = 2 * math.ceil(1.18 * (size + 2 * side) * 1.2 + 48)
    w = 1.2 * np.cos((np.arange(n) + 0.5) * math.pi / n)
    whole = np.concatenate([made.filter[:0:-1], made.filter])
    gains = np.real(np.exp(1j * np.outer(w, np.arange(-side, side + 1))) @ whole)
    for weights, factor, error, gain in (
        (made.taps.at(t), np.ones(n), made.error, made.gain),
        (made.taps.slopes(t), 1j * w, made.slope_error, made.slope_gain),
    ):
        waves = np.exp(1j * np.outer(w, made.taps.places)) @ weights.T
        off = np.abs(factor[:, None] * np.exp(1j * np.outer(w, t)) - gains[:, None] * waves).max()
        assert error == pytest.approx(2.0 * off, rel=1e-6, abs=0.0)
        sums = max(np.abs(np.convolve(row, whole)).sum() for row in weights)
        assert gain == pytest.approx(sums / math.cos(math.pi / 10.0), rel=1e-9, abs=0.0)
    around = interpolation.circular_taps(20, 64, 1e-5)
    for order in (0, 9, 20):
        turned = np.exp(1j * order * math.pi / 32.0 * around.taps.places) @ around.taps.at(t).T
        off = np.abs(np.exp(1j * order * math.pi / 32.0 * t) - around.gains[order] * turned).max()
        assert around.errors[order] == pytest.approx(math.sqrt(2.0) * off, rel=1e-6, abs=0.0)
    assert around.errors.max() <= 1e-5
    assert made.error <= 1e-4
