"""The fit of Moffat's profile: derivatives, bias and standard errors against simulated stars, and refusals."""

import math

import numpy as np
import pytest
from scipy import integrate

import lommel as lm
from lommel.estimation.moffat import _profile

NAMES = ("flux", "row", "column", "fwhm", "beta", "background")
TRUTH = np.array([2e4, 9.3, 10.8, 4.2, 2.7, 30.0])


def _model(p, shape):
    """Return the mean image and its derivatives by all parameters."""
    unit, slopes = _profile(p[1:5], shape)
    return p[0] * unit + p[5], np.stack([unit, *(p[0] * slopes), np.ones(unit.shape)])


def test_the_profile_has_the_flux_and_the_width_that_it_says():
    flux, fwhm, beta = 5.0, 3.0, 2.5
    alpha = 0.5 * fwhm / math.sqrt(2.0 ** (1.0 / beta) - 1.0)
    peak = flux * (beta - 1.0) / (math.pi * alpha**2)
    # The average over pixels against adaptive quadrature, beside the centre and far from it.
    image = _model(np.array([flux, 2.2, 3.1, fwhm, beta, 0.0]), (21, 21))[0]
    for row, column in ((2, 3), (4, 1), (20, 19)):
        value = integrate.dblquad(
            lambda x, y: peak * (1.0 + ((x - 3.1) ** 2 + (y - 2.2) ** 2) / alpha**2) ** -beta,
            row - 0.5, row + 0.5, column - 0.5, column + 0.5, epsabs=1e-13,
        )[0]  # fmt: skip
        assert image[row, column] == pytest.approx(value, rel=1e-6)
    # All light: beyond a square of half side 300 there is about peak alpha^(2 beta) int r^(-2 beta).
    wide = _model(np.array([flux, 300.0, 300.0, fwhm, beta, 0.0]), (601, 601))[0]
    assert wide.sum() == pytest.approx(flux, rel=3e-6)


@pytest.mark.parametrize("k", range(6))
def test_derivatives_are_the_limits_of_differences(k):
    step = 1e-5 * max(1.0, abs(TRUTH[k]))
    ahead, behind = (TRUTH + sign * step * np.eye(6)[k] for sign in (1.0, -1.0))
    slope = (_model(ahead, (21, 23))[0] - _model(behind, (21, 23))[0]) / (2.0 * step)
    np.testing.assert_allclose(_model(TRUTH, (21, 23))[1][k], slope, atol=1e-7 * np.abs(slope).max())


def test_fits_are_unbiased_and_their_errors_are_those_that_they_state():
    clean, rng = _model(TRUTH, (21, 23))[0], np.random.default_rng(3)
    pulls, chi = [], []
    for _ in range(120):
        fit = lm.fit_moffat(rng.poisson(clean) + rng.normal(0.0, 3.0, clean.shape), lm.Noise(read=3.0))
        pulls.append(
            [(getattr(fit, name) - truth) / fit.errors[name] for name, truth in zip(NAMES, TRUTH, strict=True)]
        )
        chi.append(fit.chi2)
    # Four standard errors of a mean and of a standard deviation of 120.
    assert np.abs(np.mean(pulls, axis=0)).max() < 4.0 / math.sqrt(120.0)
    assert np.abs(np.std(pulls, axis=0) - 1.0).max() < 4.0 / math.sqrt(240.0)
    assert np.mean(chi) == pytest.approx(1.0, abs=0.03)


def test_units_gain_and_missing_pixels():
    clean = _model(TRUTH, (21, 23))[0]
    noise = lm.Noise(white=0.5, read=2.0, offset=100.0)
    image = noise.image(clean)
    image[9, 10] = np.nan  # saturated, say
    fit = lm.fit_moffat(image, noise, pixel=0.26)
    assert fit.fwhm == pytest.approx(4.2 * 0.26, rel=1e-6)
    assert fit.flux == pytest.approx(2e4, rel=1e-6)
    assert fit.chi2 < 1e-6
    assert "fwhm=1.092 +-" in repr(fit)


def test_a_long_exposure_through_the_atmosphere_has_its_exponent_and_width():
    # Of Kolmogorov's turbulence the profile is close to a Moffat's of beta 4.765 (Trujillo et al. 2001).
    seeing = lm.Seeing(1.0 / 20.0)
    star = lm.psf(lm.Pupil(), 41, 2.0, integrate=True, blur=seeing, dtype=np.float64)
    fit = lm.fit_moffat(1e6 * star.values / star.values.sum(), lm.Noise(read=1.0))
    assert 4.0 < fit.beta < 5.2
    assert fit.fwhm * 2.0 == pytest.approx(float(star.fwhm()), rel=0.05)


@pytest.mark.parametrize(
    ("image", "wrong"),
    [
        (np.ones((4, 9)), "at least 5 x 5"),
        (np.full((9, 9), np.nan), "neither NaN, masked nor full"),
        (np.full((9, 9), np.inf), "neither NaN, masked nor full"),
        (np.full((9, 9), 7.0), "a star above its background"),
    ],
)
def test_images_without_a_star_are_refused(image, wrong):
    with pytest.raises(ValueError, match=wrong):
        lm.fit_moffat(image, lm.Noise(read=1.0))


def test_narrow_stars_have_unbiased_errors_too():
    # The mean over pixels by many points, of stars that a pixel hardly resolves.
    at = (np.arange(60) + 0.5) / 60 - 0.5
    for fwhm in (0.4, 1.0):
        alpha = 0.5 * fwhm / math.sqrt(2.0 ** (1.0 / 2.7) - 1.0)
        y, x = ((np.arange(21)[:, None] + at - middle).ravel() for middle in (9.3, 10.8))
        light = 1.7 / (math.pi * alpha**2) * (1.0 + (y[:, None] ** 2 + x**2) / alpha**2) ** -2.7
        image = light.reshape(21, 60, 21, 60).mean(axis=(1, 3))
        np.testing.assert_allclose(
            _model(np.array([1.0, 9.3, 10.8, fwhm, 2.7, 0.0]), (21, 21))[0], image, atol=2e-4 * image.max()
        )
        fit = lm.fit_moffat(1e6 * image + 30.0, lm.Noise(read=3.0))
        assert abs(fit.flux - 1e6) < fit.errors["flux"]
        assert abs(fit.fwhm - fwhm) < fit.errors["fwhm"]


def test_a_gaussian_ends_at_the_largest_exponent():
    y, x = np.mgrid[:25, :25]
    gaussian = 30.0 + 4e3 * np.exp(-((y - 12.2) ** 2 + (x - 12.4) ** 2) / (2.0 * 1.8**2))
    fit = lm.fit_moffat(gaussian, lm.Noise(read=3.0))
    assert fit.beta == 100.0
    assert fit.row == pytest.approx(12.2, abs=1e-4)


def test_a_gaussian_says_so():
    y, x = np.mgrid[:25, :25]
    gaussian = 30.0 + 4e3 * np.exp(-((y - 12.2) ** 2 + (x - 12.4) ** 2) / (2.0 * 1.8**2))
    fit = lm.fit_moffat(gaussian, lm.Noise(read=3.0))
    assert math.isinf(fit.errors["beta"])
    assert "beta=100 (a Gaussian)," in repr(fit)
    assert "beta=100 (held)," in repr(lm.fit_moffat(gaussian, lm.Noise(read=3.0), beta=100.0))


# Stars of which the window determines flux, exponent and background only together.
DIM = [((2e3, 16.3, 15.8, 11.0, 4.765, 50.0), 33), ((1e4, 16.3, 15.8, 14.0, 4.765, 500.0), 33)]
STARS = 16


@pytest.mark.parametrize(("truth", "side"), DIM)
def test_dim_stars_are_found_where_the_exponent_and_the_background_are_held(truth, side):
    clean, refused = _model(np.array(truth), (side, side))[0], []
    pulls = []
    for seed in range(STARS):
        image = lm.Noise(read=3.0).record(clean, seed=seed)
        try:
            lm.fit_moffat(image, lm.Noise(read=3.0))
        except ValueError as error:
            refused.append(str(error))
        fits = [lm.fit_moffat(image, lm.Noise(read=3.0), beta=4.765, background=truth[5])]
        fits.append(lm.fit_moffat(image, lm.Noise(read=3.0), beta=4.765))
        assert all(fit.beta == 4.765 and fit.errors["beta"] == 0.0 for fit in fits)
        assert fits[0].background == truth[5]
        assert fits[0].errors["background"] == 0.0 < fits[1].errors["background"]
        assert fits[0].errors["flux"] < fits[1].errors["flux"]
        names = [name for name in NAMES if fits[0].errors[name] > 0.0]
        pulls.append([(getattr(fits[0], n) - truth[NAMES.index(n)]) / fits[0].errors[n] for n in names])
    assert len(pulls[0]) == 4
    # Five standard errors: the logarithm of the width of dim stars is skewed.
    assert np.abs(np.mean(pulls, axis=0)).max() < 5.0 / math.sqrt(STARS)
    assert np.abs(np.std(pulls, axis=0) - 1.0).max() < 5.0 / math.sqrt(2 * STARS)
    # Others say what to hold.
    assert len(refused) > 1
    assert all(error.endswith("Give beta= (4.765 of seeing) or background= to hold it, or take a larger window")
               for error in refused)  # fmt: skip
    assert max(map(len, refused)) < 300


def test_refusals_advise_to_hold_what_is_not_held():
    flat, noise = np.full((9, 9), 7.0), lm.Noise(read=1.0)
    with pytest.raises(ValueError, match=r"electrons\. Give background= to hold it"):
        lm.fit_moffat(flat, noise, beta=3.0)
    with pytest.raises(ValueError, match=r"electrons$"):
        lm.fit_moffat(flat, noise, beta=3.0, background=7.0)


def test_missing_pixels_at_the_edge_do_not_count_as_a_background():
    clean = _model(TRUTH, (21, 23))[0] + 1e4
    seen = np.full(clean.shape, np.nan)
    seen[1:-1, 1:-1] = clean[1:-1, 1:-1]
    fit = lm.fit_moffat(seen, lm.Noise(read=3.0))
    assert fit.background == pytest.approx(1e4 + 30.0, rel=1e-6)
    assert fit.flux == pytest.approx(2e4, rel=1e-4)


@pytest.mark.parametrize(
    ("truth", "wrong"),
    [
        ((2e4, -3.0, 12.0, 4.0, 2.7, 30.0), "row at its limit -0.5"),
        ((2e5, 12.0, 26.0, 4.0, 2.7, 30.0), "column at its limit 24.5"),
    ],
)
def test_a_fit_that_ends_at_a_limit_is_refused(truth, wrong):
    with pytest.raises(ValueError, match=wrong):
        lm.fit_moffat(_model(np.array(truth), (25, 25))[0], lm.Noise(read=3.0))


def test_what_is_not_of_this_profile_is_a_misfit():
    y, x = np.mgrid[:25, :25]
    r = np.hypot(y - 12.0, x - 12.0)
    noise = lm.Noise(read=3.0)
    ring = lm.fit_moffat(noise.record(30.0 + 200.0 * ((r > 5.0) & (r < 9.0)), seed=0), noise)
    one = _model(TRUTH, (25, 25))[0]
    double = lm.fit_moffat(noise.record(one + np.roll(one, (4, 5), (0, 1)), seed=0), noise)
    for fit in (ring, double):
        assert (fit.status, fit.converged) == ("misfit", False)
        assert fit.to_dict()["findings"][0]["numbers"]["chi2"] == fit.chi2
    right = lm.fit_moffat(noise.record(one, seed=0), noise)
    assert right.converged
    assert right.reliable


def test_masked_and_saturated_pixels_do_not_count():
    noise = lm.Noise(read=3.0)
    seen = noise.record(_model(TRUTH, (21, 23))[0], seed=2)
    bad = np.zeros(seen.shape, bool)
    bad[8:10, 9:11] = True
    plain = lm.fit_moffat(np.where(bad, np.nan, seen), noise)
    masked = lm.fit_moffat(seen, noise, mask=bad)
    full = lm.fit_moffat(np.where(bad, 5e4, seen), noise, saturation=5e4)
    for fit in (masked, full):
        assert [getattr(fit, name) for name in NAMES] == [getattr(plain, name) for name in NAMES]
        assert fit.findings.get("left_out").numbers["pixels"] == 4


def test_other_arguments_are_checked():
    with pytest.raises(TypeError, match="real numbers"):
        lm.fit_moffat(np.ones((9, 9), complex), lm.Noise(read=1.0))
    with pytest.raises(TypeError, match="noise"):
        lm.fit_moffat(np.ones((9, 9)), 1.0)
    with pytest.raises(ValueError, match="pixel"):
        lm.fit_moffat(np.ones((9, 9)), lm.Noise(read=1.0), pixel=0.0)
    for name, value in (("beta", 1.0), ("beta", 101.0), ("background", math.nan)):
        with pytest.raises(ValueError, match=name):
            lm.fit_moffat(np.ones((9, 9)), lm.Noise(read=1.0), **{name: value})
    with pytest.raises(TypeError, match="beta"):
        lm.fit_moffat(np.ones((9, 9)), lm.Noise(read=1.0), beta="3")


def test_a_star_so_bright_that_sums_are_rounded_settles():
    air = lm.Seeing(1.0 / 50.0)
    star = lm.psf(lm.Pupil(), 31, 10.0, integrate=True, blur=air, normalize="energy").values
    fit = lm.fit_moffat(1e7 * star / star.sum() + 50.0, lm.Noise(read=3e4))
    assert "not_settled" not in fit.findings.codes
