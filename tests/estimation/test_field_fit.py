"""Field maps from stars simulated apart from the package: signs, blur, rejection, errors, tables, verdicts."""

from __future__ import annotations

import pickle
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import lommel as lm
import searches
import simulated_fields as simulated
from lommel.blur.mixtures import BlurProfile
from lommel.estimation import field_fit
from lommel.estimation.field_search import Search
from lommel.estimation.field_signs import monomials, robust
from lommel.estimation.star_readout import StarReadout
from lommel.lensfiles.tables import read_csv

NOISE = lm.Noise(read=2.0)
SENSOR = (4000, 4000)
EVEN = np.array([True, True, True, False, False])  # of Noll 4 to 8
TERMS, SIDE = 5, 21


@cache
def telescope():
    return simulated.Telescope(TERMS, side=96)


@cache
def case(seed=3, count=36, defocus=(0.0,), doubles=0):
    draw = np.random.default_rng(seed)
    waves = simulated.field(draw, TERMS, degree=2)
    return simulated.stars(
        draw, count, waves, telescope(), side=SIDE, defocus=defocus, doubles=doubles, snr=(60, 200)
    )


def fitted(images, places, pupil=None, **options):
    options = {
        "sensor": SENSOR,
        "pixel": 0.5,
        "noise": NOISE,
        "degree": 2,
        "terms": TERMS,
        "integrate": True,
    } | options
    return searches.fit_field(images, places, pupil or lm.Pupil(), **options)


@pytest.fixture
def searched_once(monkeypatch):
    """Without the further searches, from other random starts, that follow on a misfit."""
    monkeypatch.setattr(field_fit, "_MAX_SEARCHES", 1)


@cache
def one_focus():
    places, images, _ = case()
    return fitted(images[:, 0], places)


def lines(u, v):
    """Return defocus and astigmatism that are linear in the position."""
    return np.stack([0.6 + 0.5 * u, 0.4 * v, -0.3 + 0.2 * u - 0.3 * v], axis=-1)


def position(places, pixel=0.5):
    """Return x and y of rows and columns."""
    return (places[:, 1] - 1999.5) * pixel, (places[:, 0] - 1999.5) * pixel


def over_bound(fit, places, true, sign=1.0, even=TERMS):
    """Return the rms error of terms at the stars over their standard errors."""
    values, errors = fit.at(*position(places))
    return float(np.sqrt((((values - np.where(EVEN[:even], sign, 1.0) * true) / errors) ** 2).mean()))


def test_one_focus_gives_the_field_up_to_the_twin():
    places, _, true = case()
    fit = one_focus()
    assert fit.converged, fit.message
    assert "images at a single defocus do not determine the common sign of all even terms" in fit.message
    sign = 1.0 if over_bound(fit, places, true) < 5.0 else -1.0
    assert 0.5 < over_bound(fit, places, true, sign) < 1.6
    assert abs(fit.chi2 - 1.0) < 0.03
    assert abs(fit.held_out - 1.0) < 0.06
    assert not fit.reliable  # the images leave the sign open
    assert fit.status == "doubtful"
    (jitter,) = fit.blur
    assert abs(jitter.sigma - 0.6 * 0.5) < 5.0 * fit.blur_errors[0][0]
    assert "more likely than Kolmogorov" in fit.findings.get("blur_shape").text
    # Without a start the first even term is positive in the mean, and the twin has it negative.
    x, y = position(places)
    mine, other = (np.stack(list(each.pupil(x, y).wavefront.edge_terms().values())) for each in (fit.field, fit.twin))
    assert fit.at(x, y)[0][:, 0].mean() > 0.0
    assert not np.allclose(mine, other, atol=0.1)


def test_the_twin_has_the_same_images_and_the_map_is_what_at_says():
    fit = one_focus()
    x, y = np.array([-600.0, 300.0]), np.array([200.0, -800.0])
    first, second = (each.psf(x, y, 21, 0.5).values for each in (fit.field, fit.twin))
    np.testing.assert_allclose(first, second, atol=1e-5 * first.max())
    edge = fit.field.pupil(x, y).wavefront.edge_terms()
    np.testing.assert_allclose(edge[2, 0] / np.sqrt(3.0), fit.at(x, y)[0][:, 0], atol=1e-9)


def test_a_start_decides_the_sign():
    places, images, true = case()
    inside = np.abs(places - 1999.5).max(axis=1) < 1500.0
    x, y = position(places)
    corners = np.array([[-1000.0, 1000.0, -1000.0, 1000.0], [-1000.0, -1000.0, 1000.0, 1000.0]])
    mean = lm.Wavefront.zernike({4: np.append(true[:, 0], [true[:, 0].mean()] * 4)}, order="noll")
    design = lm.FieldMap.scattered(np.append(x, corners[0]), np.append(y, corners[1]), mean)
    for sign, start in ((1.0, design), (-1.0, negative(design, x, y, corners))):
        fit = fitted(images[inside, 0], places[inside], start)
        assert fit.converged, fit.message
        assert over_bound(fit, places[inside], true[inside], sign) < 1.6


def negative(design, x, y, corners):
    """Return a map of the negative of its defocus."""
    across, down = np.append(x, corners[0]), np.append(y, corners[1])
    return lm.FieldMap.scattered(across, down, design.pupil(across, down).wavefront * -1.0)


def test_two_foci_tell_the_sign():
    places, images, true = case(seed=4, count=25, defocus=(-2.5, 2.5))
    fit = fitted(images, places, defocus=[-2.5, 2.5])
    assert fit.converged, fit.message
    assert fit.twin is None
    assert 0.5 < over_bound(fit, places, true) < 1.6
    values, errors = fit.at(*position(places))
    off = np.abs((values - true) / errors)
    for reach, least, most in ((1.0, 0.45, 0.9), (2.0, 0.85, 1.0), (3.0, 0.97, 1.0)):
        assert least < (off < reach).mean() <= most
    np.testing.assert_allclose([jitter.sigma for (jitter,) in fit.blurs], 0.6 * 0.5, atol=0.01)
    assert fit.reliable, fit.message


@pytest.mark.quick
@pytest.mark.parametrize("defocus", [-4.0, 4.0])
def test_a_known_defocus_decides_the_sign(defocus):
    draw = np.random.default_rng(9)
    options = {"side": SIDE, "defocus": (defocus,), "snr": (60, 200)}
    places, images, true = simulated.stars(draw, 8, lines, simulated.Telescope(3, side=96), **options)
    fit = fitted(images, places, defocus=defocus, terms=3, degree=1)
    assert fit.converged, fit.message
    assert "the map nearer to the wavefront of pupil was chosen" in fit.message
    assert 0.4 < over_bound(fit, places, true, even=3) < 1.8


def test_a_field_with_much_spherical_aberration_is_found_from_two_foci_without_fits_of_single_stars(monkeypatch):
    monkeypatch.setattr(Search, "fit_from_single_stars", lambda _: pytest.fail("no shift of the start fits"))
    draw, known = np.random.default_rng(4), [-3.0, 3.0]

    def waves(u, v):
        made = np.zeros((*np.shape(u), 8))
        made[..., 0], made[..., 4], made[..., 7] = 1.8 + 0.3 * u, 0.2 * v, -1.3
        return made

    scope = simulated.Telescope(8, side=96)
    places, images, true = simulated.stars(draw, 12, waves, scope, side=33, defocus=known, snr=(100, 200))
    chosen = ["noll 4", "noll 7", "noll 8", "noll 11"]
    fit = fitted(images, places, defocus=known, terms=chosen, degree=1)
    assert fit.converged, fit.message
    values, errors = fit.at(*position(places))
    assert np.sqrt((((values - true[:, [0, 3, 4, 7]]) / errors) ** 2).mean()) < 1.8


def test_stars_without_blur_settle_at_none():
    draw = np.random.default_rng(8)
    scope = simulated.Telescope(3, side=96)
    options = {"side": SIDE, "defocus": (-2.0, 2.0), "sigma": 0.0, "snr": (60, 200)}
    places, images, true = simulated.stars(draw, 8, lines, scope, **options)
    fit = fitted(images, places, defocus=[-2.0, 2.0], terms=3, degree=1)
    assert fit.converged, fit.message
    widths, errors = (np.ravel(part) for part in ([[j.sigma for j in each] for each in fit.blurs], fit.blur_errors))
    assert (widths < 4.0 * errors).all()
    assert (widths == 0.0).any()
    assert (errors < 0.1).all()
    assert 0.4 < over_bound(fit, places, true, even=3) < 1.8


@pytest.mark.usefixtures("searched_once")
def test_corners_of_a_checkerboard_tell_the_field():
    draw = np.random.default_rng(3)
    options = {"side": 13, "pixel": 0.9, "sigma": 0.4, "pitch": 30.0}
    places, images, true = simulated.corners(draw, 2, 3, lines, simulated.Telescope(3, side=64), **options)
    more = {"pixel": 0.9, "kind": "crossing", "size": 27.0, "terms": 3, "degree": 1}
    fit = fitted(images, places, **more)
    assert fit.converged, fit.message
    values, errors = fit.at(*position(places, 0.9))
    off = min(np.sqrt((((values - sign * true) / errors) ** 2).mean()) for sign in (1.0, -1.0))
    assert 0.4 < off < 1.8
    assert abs(fit.blur[0].sigma - 0.4 * 0.9) < 5.0 * fit.blur_errors[0][0]
    np.testing.assert_allclose(fit.stars.flux, 4500.0, rtol=0.02)
    np.testing.assert_allclose(fit.stars.background, 2750.0, rtol=0.01)


def test_doubles_are_rejected_and_defects_left_out(monkeypatch):
    places, images, true = case(seed=5, doubles=4)
    spoiled = images[:, 0].copy()
    spoiled[10, 2, 8:12] += 2000.0
    singles, begun = Search.fit_single_stars, []
    monkeypatch.setattr(
        Search,
        "fit_single_stars",
        lambda search, chosen, *args: begun.append(len(chosen)) or singles(search, chosen, *args),
    )
    fit = fitted(spoiled, places)
    assert fit.converged, fit.message
    assert np.flatnonzero(~fit.stars.used).tolist() == [0, 1, 2, 3]
    assert (fit.stars.chi2[~fit.stars.used] > fit.stars.chi2[fit.stars.used].max()).all()
    assert "4 stars rejected" in fit.message
    assert begun == [36]  # no star is fitted by itself a second time
    left = np.isnan(fit.images[:, 0])
    assert left[10, 2, 8:12].all()
    assert left.sum() == left[10].sum() < 20
    assert fit.findings.get("left_out").numbers == {"pixels": left.sum(), "windows": 1}
    assert min(over_bound(fit, places, true, sign) for sign in (1.0, -1.0)) < 1.6


def test_stars_that_fit_by_themselves_are_taken_back(monkeypatch):
    places, images, true = case(seed=5, doubles=4)
    corner = np.argsort(places.sum(axis=1))[:8]
    regained = Search.readmit_stars

    def without_a_corner(search, found):
        keep = ~np.isin(found.model.chosen, corner)
        chosen, own = found.model.chosen[keep], found.nuisance()[keep]
        astray = found.polynomials()
        astray[:, 3:] += 0.1
        return regained(search, search.refine(chosen, astray, found.squared_widths(), 10, own))

    monkeypatch.setattr(Search, "readmit_stars", without_a_corner)
    fit = fitted(images[:, 0], places)
    assert fit.converged, fit.message
    assert np.flatnonzero(~fit.stars.used).tolist() == [0, 1, 2, 3]
    assert min(over_bound(fit, places, true, sign) for sign in (1.0, -1.0)) < 1.6


@pytest.mark.usefixtures("searched_once")
def test_a_degree_that_is_too_low_is_a_misfit_of_the_pixels_with_light():
    places, images, _ = case(seed=5, count=30, defocus=(-3.0, 3.0))
    right = fitted(images, places, degree=2, defocus=(-3.0, 3.0))
    assert right.converged
    fit = fitted(images, places, degree=1, defocus=(-3.0, 3.0))
    assert not fit.converged
    assert fit.message.startswith("misfit")


def test_other_random_starts_are_tried_where_the_map_does_not_hold(monkeypatch):
    places, images, _ = case()
    whole, outcomes = Search.outcome, []

    def first_one_doubted(search, found):
        made = whole(search, found)
        outcomes.append(made if outcomes else replace(made, held_out=(9.0, 0.01)))
        return outcomes[-1]

    monkeypatch.setattr(Search, "outcome", first_one_doubted)
    fit = fitted(images[:, 0], places)
    assert outcomes[0].findings.codes == ("held_out", "untested")
    assert len(outcomes) == 2
    assert fit.converged
    assert fit.held_out == outcomes[1].held_out[0]


@pytest.mark.usefixtures("searched_once")
def test_apertures_with_vanes():
    vanes = [(0.5, 0.1), (0.5 + 2.1, 0.1), (0.5 + 4.2, 0.1)]
    pupil = lm.Pupil(obscuration=0.3, spider=lm.Spider(angles=[angle for angle, _ in vanes], width=0.1))
    draw = np.random.default_rng(7)
    scope = simulated.Telescope(3, side=96, obscuration=0.3, vanes=vanes)

    places, images, true = simulated.stars(draw, 8, lines, scope, side=SIDE, defocus=(-2.5, 2.5), snr=(60, 120))
    fit = fitted(images, places, pupil, defocus=[-2.5, 2.5], terms=3, degree=1)
    assert fit.converged, fit.message
    assert 0.4 < over_bound(fit, places, true, even=3) < 1.8
    assert fitted(images, places, lm.Pupil(obscuration=0.3), defocus=[-2.5, 2.5], terms=3, degree=1).chi2 > fit.chi2


def test_the_table_is_read_by_lens_files_as_it_was_written(tmp_path):
    places, images, _ = case()
    wavelength, number = 550e-9, 8.0
    pixel = 0.5 * wavelength * number
    pupil = lm.Pupil(wavelength=wavelength, f_number=number)
    fit = fitted(images[:16, 0], places[:16], pupil, pixel=pixel, blur=0.6)
    assert fit.converged, fit.message
    fit = pickle.loads(pickle.dumps(fit))  # as another process has it
    fit.save(tmp_path / "field.csv")
    made = read_csv(tmp_path / "field.csv", "noll").field_map(pupil, unit="waves", normalization="rms", direction="x")
    x, y = position(places, pixel)
    for term, values in fit.field.pupil(x, y).wavefront.edge_terms().items():
        np.testing.assert_allclose(made.pupil(x, y).wavefront.edge_terms().get(term, 0.0), values, atol=1e-7)
    text = (tmp_path / "field.csv").read_text(encoding="utf-8")
    assert text.startswith("# converged, but in doubt: ")
    with pytest.raises(ValueError, match=r"path must end in \.csv"):
        fit.save(tmp_path / "field.txt")
    with pytest.raises(ValueError, match="save requires positions in metres"):
        one_focus().save(tmp_path / "field.csv")


def test_the_picture_has_a_panel_for_each_term_and_the_stars():
    figure = one_focus().plot()  # laid out, not drawn
    titles = [axes.get_title() for part in figure.subfigs for axes in part.axes]
    assert sum("±" in title for title in titles) == TERMS
    assert "stars, chi2" in titles


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            {"windows": np.full((5, 9, 9), 65535, np.uint16)},
            "must have at least 41 of 81 pixels that are neither masked, saturated nor NaN, got none",
        ),
        ({"places": np.full((5, 2), 5000.0)}, "places must be on the sensor of 4000 x 4000"),
        ({"places": np.arange(10.0).reshape(5, 2)}, "windows must not overlap"),
        ({"defocus": [1.0, 2.0]}, "defocus must be a number, or one for each of 1"),
    ],
)
def test_bad_input_is_told(change, message):
    count = change.pop("count", 5)
    draw = np.random.default_rng(1)
    options = {
        "windows": draw.poisson(100.0, (count, 9, 9)).astype(float),
        "places": np.arange(2.0 * count).reshape(count, 2) * 100.0,
        "pupil": lm.Pupil(),
        "sensor": SENSOR,
        "pixel": 0.5,
        "noise": NOISE,
    } | change
    with pytest.raises((TypeError, ValueError), match=message):
        searches.fit_field(options.pop("windows"), options.pop("places"), options.pop("pupil"), **options)


@pytest.mark.parametrize(("pixel", "sigma", "integrate"), [(0.5, 0.6, True), (2.2, 0.4, True), (0.5, 0.6, False)])
def test_pixels_read_from_samples_are_those_of_blurred_psfs(pixel, sigma, integrate):
    pupil = lm.Pupil(lm.Wavefront.zernike({4: 0.5, 7: 0.4, 9: 0.3}, order="noll"))
    exact = lm.psf(pupil, 15, pixel, integrate=integrate, blur=lm.Jitter(sigma * pixel)).values
    reader = StarReadout((15, 15), pixel, sigma, BlurProfile.gaussian(), integrate=integrate)
    samples = np.asarray(lm.psf(pupil, reader.shape, reader.step, integrate=False).values)
    read, slope = reader.read([samples[None]], np.full((1, 1, 1), sigma**2), derivatives=True)
    np.testing.assert_allclose(read[0], exact, atol=1e-5 * exact.max())
    step = 0.02
    one, other = (
        reader.read([samples[None]], np.full((1, 1, 1), sigma**2 + s * step), derivatives=False)[0] for s in (1, -1)
    )
    change = (one - other) / (2.0 * step)
    np.testing.assert_allclose(slope, change, atol=5e-3 * np.abs(change).max())


@pytest.mark.parametrize(("pixel", "sigma"), [(2.2, 1.1), (7.8, 1.3), (7.8, 0.4)])
def test_samples_behind_wide_blur_may_be_far_apart(pixel, sigma):
    pupil = lm.Pupil(lm.Wavefront.zernike({4: 0.5, 7: 0.4, 9: 0.3}, order="noll"), obscuration=0.3)
    exact = np.asarray(lm.psf(pupil, 11, pixel, integrate=True, blur=lm.Jitter(sigma * pixel)).values)
    narrowest = np.array([sigma**2])
    reader = StarReadout((11, 11), pixel, sigma, BlurProfile.gaussian(), integrate=True, smallest_variances=narrowest)
    assert 0.5 < reader.step < 1.0
    samples = np.asarray(lm.psf(pupil, reader.shape, reader.step, integrate=False).values)
    (read,) = reader.read([samples[None]], np.full((1, 1, 1), sigma**2), derivatives=False)
    np.testing.assert_allclose(read[0], exact, atol=1e-5 * exact.max())


@pytest.mark.parametrize("blurs", ["alike", "by exposure", "each"])
def test_images_that_are_read_together_are_those_read_one_by_one(blurs):
    draw, shape = np.random.default_rng(4), BlurProfile.turbulent(terms=3)
    reader = StarReadout((6, 9), 1.3, 0.8, shape, integrate=True)
    samples = [draw.normal(size=(14, *reader.shape)) for _ in range(2)]
    squares = draw.uniform(0.05, 0.2, (7, 2, 2))
    if blurs != "each":
        squares[:] = squares[0]
    if blurs == "alike":
        squares[:, 1] = squares[:, 0]
    found = reader.read(samples, squares, derivatives=True)
    assert [each.shape for each in found] == [(14, 6, 9)] * 4
    for k in range(14):
        alone = reader.read(
            [each[k : k + 1] for each in samples], squares[k // 2, k % 2][None, None], derivatives=True
        )
        for whole, one in zip(found, alone, strict=True):
            np.testing.assert_allclose(whole[k], one[0], atol=1e-5 * np.abs(one).max())


def test_robust_polynomials_ignore_a_few_wild_stars():
    draw = np.random.default_rng(2)
    u, v = draw.uniform(-1, 1, (2, 60))
    basis, true = monomials(u, v, 2), draw.normal(size=(3, 6))
    waves = basis @ true.T
    waves[:8] += draw.normal(size=(8, 3)) * 3.0
    found, distance = robust(basis, waves, np.ones(60), np.eye(3))
    np.testing.assert_allclose(found, true, atol=1e-2)
    assert (distance[8:] < distance[:8].min()).all()


def test_windows_that_are_cut_beside_their_stars_change_little():
    """Polynomials are those of where stars are, not of where windows were cut."""
    rng, side, noise = np.random.default_rng(5), 400, lm.Noise(read=2.0)
    grid = np.linspace(40, side - 41, 6).round()
    at = np.stack(np.meshgrid(grid, grid), axis=-1).reshape(-1, 2)
    sub = rng.uniform(-0.5, 0.5, at.shape)
    v, u = (2.0 * (at + sub + 0.5) / side - 1.0).T
    terms = {(2, 0): 0.3 + 0.4 * u * u, (2, 2): 0.5 * u + 0.3, (2, -2): 0.5 * v, (3, 1): 0.6 * u, (3, -1): 0.6 * v}
    stars = lm.psf(lm.Pupil(lm.Wavefront.zernike(terms)), 39, 0.5, center=(19 + sub[:, 0], 19 + sub[:, 1]))
    images = noise.record(1e5 * stars.values + 20.0, seed=5)
    found = []
    for off in (np.zeros(at.shape, dtype=int), np.stack([4 * np.sign(u), -3 * np.sign(v)], axis=1).astype(int)):
        cut = np.stack([image[4 + y : 35 + y, 4 + x : 35 + x] for image, (y, x) in zip(images, off, strict=True)])
        targets = lm.detection.Targets(windows=cut, places=at + off, shape=(side, side), noise=noise)
        found.append(lm.fit_field(targets, lm.Pupil(), pixel=0.5, degree=2, terms=5))
    errors = np.sqrt(np.diag(found[0].covariance)).reshape(found[0].coefficients.shape)
    assert all(fit.converged for fit in found)
    assert np.abs((found[1].coefficients - found[0].coefficients) / errors).max() < 1.0


@cache
def night(seeing, jitter=0.0, flux=5e4):
    """Return places and images of 12 stars through turbulence, FWHM in pixels of 0.94 lambda*N, and 3 terms."""
    pixel, side, terms = 0.9375, 25, np.array([0.3, 0.0, 0.4, 0.0, 0.5])
    draw, scope = np.random.default_rng(6), simulated.Telescope(5, side=128, obscuration=0.3)
    places = np.array([(60 + 110 * (k // 4), 60 + 110 * (k % 4)) for k in range(12)])
    images = np.empty((12, side, side))
    for k in range(12):
        seen = simulated.through_turbulence(scope, terms, draw.uniform(-0.5, 0.5, 2), pixel, side, seeing, jitter)
        images[k] = draw.poisson(flux * seen + 50.0) + draw.normal(size=(side, side)) * 3.0
    return places, images, terms


@pytest.mark.parametrize(
    ("seeing", "jitter", "flux", "kinds"),
    [(2.6, 0.0, 5e4, (lm.Seeing,)), (1.7, 0.0, 5e3, (lm.Seeing,)), (2.6, 0.6, 5e4, (lm.Seeing, lm.Jitter))],
)
def test_stars_through_turbulence_tell_the_family_of_their_blur(seeing, jitter, flux, kinds):
    places, images, true = night(seeing, jitter, flux)
    chip = {"sensor": (400, 500), "pixel": 0.9375, "noise": lm.Noise(read=3.0), "degree": 0, "tol": 1e-4}
    fit = fitted(images, places, lm.Pupil(obscuration=0.3), **chip)
    assert fit.converged, fit.message
    assert tuple(map(type, fit.blur)) == kinds
    found = fit.findings.get("blur_shape")
    assert "more likely than a Gaussian" in found.text
    assert found.numbers["gain"] > 5.0
    values, errors = fit.at(0.0, 0.0)
    off = min(np.abs((values - np.where(EVEN, sign, 1.0) * true) / errors).max() for sign in (1.0, -1.0))
    assert off < 4.0
    width = 0.9758634 / fit.blur[0].r0 / 0.9375
    assert abs(width - seeing) < 4.0 * width * fit.blur_errors[0][0] / fit.blur[0].r0 + 0.005 * seeing


def test_known_seeing_is_taken_as_it_is():
    places, images, true = night(2.6)
    chip = {"sensor": (400, 500), "pixel": 0.9375, "noise": lm.Noise(read=3.0), "degree": 0, "tol": 1e-4}
    air = lm.Seeing(0.9758634 / (2.6 * 0.9375))
    fit = fitted(images, places, lm.Pupil(obscuration=0.3), blur=air, **chip)
    assert fit.converged, fit.message
    assert fit.blur == (air,)
    assert fit.blur_errors == ((0.0,),)
    values, errors = fit.at(0.0, 0.0)
    assert min(np.abs((values - np.where(EVEN, s, 1.0) * true) / errors).max() for s in (1.0, -1.0)) < 4.0
    with pytest.raises(ValueError, match="blur must be isotropic"):
        fitted(images, places, lm.Pupil(obscuration=0.3), blur=lm.Motion(1.0), **chip)
