"""Wavefronts are found behind images, with the scatter that noise makes, or it is said why not."""

from __future__ import annotations

import json
import math
import pickle
from functools import partial

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.stats import poisson

import lommel as lm
import searches
from lommel.core.engine import star_likelihood
from lommel.estimation import phase_retrieval
from lommel.estimation.star_images import StarImages, Unknowns, _point_symmetric, error_factors, uncertainty
from lommel.fit.scoring import covariance
from tests.world import air
from tests.world.optics import Telescope

NOISE = lm.Noise(read=2.0)
DEFOCUS = np.array([-4.0, 0.0, 4.0])
ASKED = {"pixel": 0.5, "noise": NOISE}
TRUE = lm.Wavefront.zernike({5: 0.4, 8: -0.3, 11: 0.2}, order="noll")


def stars(wavefront, *, photons=1e5, defocus=DEFOCUS, center=(16.0, 16.0), seed=1, side=33, **pupil):
    """Return images of a star, 5 electrons a pixel of background."""
    light = lm.Pupil(wavefront + lm.Wavefront(defocus=defocus), **pupil)
    pixel = 2e-6 if pupil.get("wavelength") else 0.5
    mean = photons * lm.psf(light, side, pixel, center=center, tol=1e-8).values + 5.0
    return NOISE.record(np.maximum(mean, 0.0), seed)


def random_wavefront(seed, rms, first=4):
    c = np.random.default_rng(seed).normal(size=15)
    c *= rms / np.linalg.norm(c)
    return lm.Wavefront.zernike(dict(enumerate(c, first)), order="noll"), c


def model(terms=15, also=("center",), pupil=None):
    """Return a model of three images, and a row of parameters for it."""
    pupil = pupil or lm.Pupil()
    pixel = 0.5 * pupil.scale
    valid = np.ones((3, 17, 17), dtype=bool)
    nothing, read = np.zeros(valid.shape), np.full(valid.shape, 4.0)
    plan = lm.Plan(17, pixel, tol=1e-9, integrate=False)
    made = StarImages(nothing, read, valid, pupil, DEFOCUS, Unknowns(terms, also), plan, pixel)
    light = [900.0, 1000.0, 1100.0, 5.0, 6.0, 7.0]
    return made, np.concatenate([np.random.default_rng(2).normal(0.0, 0.3, made.size - 6), light])[None]


@pytest.mark.parametrize(("rows", "columns"), [(3.14, 4.71), (3.5, 5.5), (-7.3, 10.2)])
def test_stripes_in_images_are_named_with_their_size_in_electrons(rows, columns):
    transfers = [Telescope().transfer(((5, 0.4), (8, -0.3), (11, 0.2)), defocus=2 * defocus) for defocus in DEFOCUS]
    plain = NOISE.record(np.array([1e5 * transfer.image(33, 0.5, 16, 16) + 5.0 for transfer in transfers]), seed=1)
    options = {"defocus": DEFOCUS, "integrate": True, **ASKED}
    y, x = np.mgrid[:33, :33] / 33
    added = 1.5 * np.cos(2.0 * np.pi * (rows * y + columns * x))  # pick-up, electrons
    found = searches.retrieve(plain + added, lm.Pupil(), **options).findings.get("pattern")
    assert found.numbers["period"] == pytest.approx(33 / math.hypot(rows, columns), rel=0.02)
    assert found.numbers["size"] == pytest.approx(1.5, rel=0.2)
    assert searches.retrieve(plain, lm.Pupil(), **options).findings.get("pattern") is None


def test_checks_that_were_omitted_give_the_same_result_later():
    images = stars(TRUE)
    quick = lm.retrieve(images, lm.Pupil(), defocus=DEFOCUS, checks=False, **ASKED)
    plain = quick.coefficients.copy()
    full = lm.retrieve(images, lm.Pupil(), defocus=DEFOCUS, **ASKED)
    assert pickle.loads(pickle.dumps(quick)).checked().to_dict() == quick.checked().to_dict() == full.to_dict()
    assert (quick.status, quick.coefficients) == ("doubtful", plain)
    assert full.reliable
    assert full.checked() is full
    errors = [quick.errors[name] for name in plain]
    assert_allclose(errors, np.sqrt(np.diag(quick.covariance)), rtol=1e-12)
    assert all(quick.errors[name] < full.errors[name] for name in plain)  # without effects that the model may lack


def test_one_hot_pixel_is_named_by_its_place_until_it_is_masked():
    images = stars(TRUE)
    images[1, 4, 27] += 200.0
    found = lm.retrieve(images, lm.Pupil(), defocus=DEFOCUS, **ASKED)
    named = found.findings.get("hot_pixels")
    assert named.numbers["place"] == (1, 4, 27)
    assert "pixel (row 4, column 27) of image 2 is " in named.text
    assert not found.reliable
    mask = np.zeros(images.shape, dtype=bool)
    mask[named.numbers["place"]] = True
    counts = lm.Counts.of(images, noise=NOISE, mask=mask)
    assert lm.retrieve(counts, lm.Pupil(), defocus=DEFOCUS, pixel=0.5).reliable


@pytest.mark.parametrize("photons", [1e4, 1e5])
def test_errors_are_those_that_the_noise_of_the_images_makes_unavoidable(photons):
    z, ratio, moved = [], [], []
    for seed in range(12):
        true, c = random_wavefront(seed, 1.0)
        centers = 16.0 + np.random.default_rng(seed).uniform(-0.5, 0.5, (2, 3))
        found = lm.retrieve(
            stars(true, photons=photons, center=tuple(centers), seed=seed), lm.Pupil(), defocus=DEFOCUS, **ASKED
        )
        assert found.reliable
        assert found.message.startswith("converged: chi2 ")
        spread = np.array([found.errors[name] for name in found.coefficients])
        error = np.array(list(found.coefficients.values())) - c
        z.append(error / spread)
        ratio.append((error @ error) / (spread @ spread))
        places = (found.center.T - centers) / [found.errors["row"], found.errors["column"]]
        moved.append(places)
        assert np.abs((found.flux - photons) / found.errors["flux"]).max() < 5.0
        assert np.abs((found.background - 5.0) / found.errors["background"]).max() < 5.0
        assert_allclose(np.sqrt(np.diag(found.covariance)), spread, rtol=1e-12)
    assert 0.85 < np.std(z) < 1.15
    assert 0.75 < np.std(moved) < 1.25
    assert 0.85 < np.sqrt(np.mean(ratio)) < 1.15


@pytest.mark.parametrize(
    ("terms", "also", "more"),
    [
        (7, ("center",), {}),
        (("defocus", "spherical", "rho^6", "noll 8"), ("row",), {"obscuration": 0.3}),
        (((2, 2), "ansi 7"), ("f_number", "wavelength", "obscuration", "column"),
         {"obscuration": 0.3, "wavelength": 1e-6, "f_number": 8.0}),
    ],
)  # fmt: skip
def test_slopes_and_information_are_those_of_the_likelihood(terms, also, more):
    made, x = model(terms, also, lm.Pupil(TRUE, **more))
    if made.unknowns.pupil:
        x[0, made.pupil_columns] = 8.4, 1.1e-6, 0.35
    draw = np.random.default_rng(5)
    psf, _ = made.images(x)
    made.counted[:] = draw.poisson(made.mean(x, psf.reshape(1, 3, -1))[0]).astype(float)
    there = made.scores(x)
    for k in range(made.size):
        h = 1e-4 * (abs(x[0, k]) if k in range(made.pupil_columns.start, made.pupil_columns.stop) else 1.0)
        up, down = x.copy(), x.copy()
        up[0, k] += h
        down[0, k] -= h
        slope = (made.scores(down).deviance[0] - made.scores(up).deviance[0]) / (2 * h)
        assert there.slope[0, k] == pytest.approx(slope, rel=2e-3, abs=2e-3 * np.sqrt(there.information[0, k, k])), k


@pytest.mark.parametrize("read", [0.0, 0.1, 0.5, 3.0])
@pytest.mark.parametrize("mean", [1e-3, 0.02, 0.3, 2.0, 40.0])
def test_the_expected_chi2_is_the_sum_over_all_counts(mean, read):
    """Moments of ((y - mu)^2 / v) by summing over counts, with those of a Gaussian on top of each."""
    recorded, light = np.full((3, 289), read**2), np.broadcast_to([[0.0], [mean]], (1, 2, 3)).copy()
    star = np.stack([0.0 * recorded, recorded, np.maximum(recorded, 0.05), np.ones((3, 289))])
    (_, total, spread), _ = star_likelihood([np.zeros((3, 17, 17))], light, star, 1)
    counts = np.arange(int(mean + 20.0 * np.sqrt(mean) + 30.0))
    chance, away = poisson.pmf(counts, mean), counts - mean
    second = chance @ (away**2 + read**2)
    fourth = chance @ (away**4 + 6.0 * away**2 * read**2 + 3.0 * read**4)
    variance = mean + max(read**2, 0.05)
    assert total[0] == pytest.approx(289 * second / variance, rel=1e-10)
    assert spread[0] == pytest.approx(289 * (fourth - second**2) / variance**2, rel=1e-9)


def test_values_below_the_offset_are_a_misfit_where_nothing_is_read_noisily():
    images = stars(TRUE) - 1e7
    found = searches.retrieve(
        images, lm.Pupil(), pixel=0.5, noise=lm.Noise(read=0.0), defocus=DEFOCUS, terms=3, starts=1
    )
    assert found.status == "misfit"
    assert np.isfinite(found.chi2)


def test_a_verdict_of_converged_means_that_standard_errors_hold():
    """Dim stars on a background, from hopeless to good; further cases in benchmarks/retrieval.py."""
    off, sure = [], []
    for photons, background, seeds in ((500.0, 5.0, 9), (1000.0, 20.0, 6), (3000.0, 5.0, 8), (1e4, 20.0, 8)):
        for seed in range(seeds):
            true, c = random_wavefront(seed, 0.7)
            light = lm.Pupil(true + lm.Wavefront(defocus=DEFOCUS))
            mean = photons * np.maximum(lm.psf(light, 25, 0.5, tol=1e-8).values, 0.0) + background
            found = lm.retrieve(NOISE.record(mean, seed), lm.Pupil(), defocus=DEFOCUS, **ASKED)
            assert (found.status == "converged") == found.reliable
            if found.converged:
                error = np.array(list(found.coefficients.values())) - c
                off.append(np.abs(error / [found.errors[name] for name in found.coefficients]).max() > 4.0)
                sure.append(found.reliable)
    off, sure = np.array(off), np.array(sure)
    assert off.sum() >= 4  # chi2 does not see these
    assert not (off & sure).any()
    assert sure[-16:].all()


@pytest.mark.quick
def test_in_focus_the_standard_error_of_defocus_is_named_as_doubtful():
    """The image does not change with defocus to first order there, and its phases are known to 0.2 rad."""
    light = {"wavelength": 550e-9, "f_number": 8.0}
    for seed, also in ((1, ("center",)), (2, ("center", "f_number"))):
        spot = stars(lm.Wavefront(0.0, 0.5), photons=1e4, defocus=0.0, seed=seed, **light)
        options = {"pixel": 2e-6, "noise": NOISE, "terms": ("defocus", "spherical"), "also": also}
        found = lm.retrieve(spot, lm.Pupil(lm.Wavefront(1.0), **light), **options)
        assert found.converged
        assert not found.reliable
        assert any("defocus" in name for name in found.findings.get("errors_change").numbers)
        bright = stars(lm.Wavefront(2.0, 0.5), photons=1e5, defocus=0.0, seed=seed, **light)
        assert lm.retrieve(bright, lm.Pupil(lm.Wavefront(1.0), **light), **options).reliable


@pytest.mark.parametrize("terms", [7, ("defocus", "spherical", "noll 8")])
def test_the_uncertainty_of_a_wavefront_is_that_of_draws_from_the_covariance(terms):
    made, x = model(terms)
    inverse = covariance(made.scores(x).information[0])
    error, axes = uncertainty(made, inverse)
    assert_allclose(axes.T @ axes, inverse, rtol=1e-8, atol=1e-12 * inverse.max())
    drawn = np.random.default_rng(1).multivariate_normal(np.zeros(made.size), inverse, 20_000)
    # Draws of the wavefront by itself, at random points of the pupil.
    draw = np.random.default_rng(2)
    points = np.sqrt(draw.random(400)), draw.uniform(0.0, 2.0 * np.pi, 400)
    basis = np.array([made.wavefront(row).phase(*points) for row in np.eye(made.size)[: made.common_count]])
    phases = drawn[:, : made.common_count] @ (basis - basis.mean(axis=1, keepdims=True))
    rows, columns = made.per_image(drawn)[:, :2].swapaxes(0, 1)
    slopes = points[0] * np.sin(points[1]), points[0] * np.cos(points[1])
    of_images = [phases + np.outer(rows[:, k], slopes[0]) + np.outer(columns[:, k], slopes[1]) for k in range(3)]
    assert error == pytest.approx(max(np.sqrt((each**2).mean()) for each in of_images), rel=0.08)


@pytest.mark.parametrize("smallest", [1e-3, 1e-9, 1e-14])
def test_a_covariance_is_the_inverse_whatever_the_scales_and_infinite_where_there_is_none(smallest):
    draw = np.random.default_rng(0)
    vectors, _ = np.linalg.qr(draw.normal(size=(30, 30)))
    sizes = np.append(np.ones(29), smallest)
    scales = 10.0 ** draw.uniform(-3.0, 3.0, 30)
    found = covariance((vectors * sizes) @ vectors.T * np.outer(scales, scales))
    if smallest < 1e-10:
        assert np.isinf(np.diag(found)).any()
        return
    assert_allclose(found * np.outer(scales, scales), (vectors / sizes) @ vectors.T, atol=2e-6 / smallest)
    assert_allclose(found, found.T, rtol=1e-12)


def test_a_parameter_of_infinite_variance_is_held():
    made, x = model(3)
    inverse = covariance(made.scores(x).information[0])
    inverse[1], inverse[:, 1] = 0.0, 0.0
    inverse[1, 1] = np.inf
    _, axes = uncertainty(made, inverse)
    assert not axes[:, 1].any()
    found = error_factors(made, x, inverse, axes)
    assert found[1] == 1.0
    assert (found[[0, 2]] > 1.0).all()


def test_wavefronts_of_three_radians_are_found_from_other_starts():
    found = [
        lm.retrieve(stars(random_wavefront(seed, 3.0)[0], seed=seed), lm.Pupil(), defocus=DEFOCUS, also=(), **ASKED)
        for seed in (0, 1, 2)
    ]
    assert max(each.starts for each in found) > 1
    for seed, each in enumerate(found):
        assert each.converged
        assert_allclose(list(each.coefficients.values()), random_wavefront(seed, 3.0)[1], atol=0.03)


FOCI = "the sign of the stated defocus"


def test_exchanged_foci_agree_as_well_and_the_result_says_so():
    telescope, terms = Telescope(), ["noll 5", "noll 8", "noll 11"]
    transfers = [telescope.transfer(((5, 0.4), (8, -0.3), (11, 0.2)), defocus=2 * defocus) for defocus in (-3.0, 3.0)]
    images = NOISE.record(np.array([1e5 * transfer.image(33, 0.5, 16, 16) for transfer in transfers]), seed=1)
    options = {"terms": terms, "integrate": True, **ASKED}
    right = searches.retrieve(images, lm.Pupil(), defocus=[-3.0, 3.0], **options)
    exchanged = searches.retrieve(images, lm.Pupil(), defocus=[3.0, -3.0], **options)
    for found in (right, exchanged):
        assert found.reliable
        assert FOCI in found.findings.get("untested").text
    signs = {"noll 5": -1.0, "noll 8": 1.0, "noll 11": -1.0}
    for name, sign in signs.items():
        assert exchanged.coefficients[name] == pytest.approx(sign * right.coefficients[name], abs=1e-3)
    # A fixed even term cannot have the other sign: exchanged foci do not fit.
    spherical = lm.Pupil(lm.Wavefront.zernike({11: 0.2}, order="noll"))
    fixed = searches.retrieve(images, spherical, defocus=[-3.0, 3.0], **options | {"terms": terms[:2]})
    assert fixed.converged
    assert FOCI not in fixed.message


def test_defoci_in_another_order_than_the_images_are_named():
    transfers = [Telescope().transfer(((8, -0.3), (11, 0.2)), defocus=2 * defocus) for defocus in (-4.0, 0.0, 5.0)]
    images = NOISE.record(np.array([1e5 * transfer.image(25, 0.5, 12, 12) + 5.0 for transfer in transfers]), seed=1)
    options = {"terms": ["noll 4", "noll 8", "noll 11"], "integrate": True, **ASKED}
    found = searches.retrieve(images, lm.Pupil(), defocus=[0.0, -4.0, 5.0], **options)
    assert found.findings.codes[0] == "exchanged"
    assert found.message.count("with the defocus of images 1 and 2 exchanged, chi2 is ") == 1
    assert found.findings.get("exchanged").numbers["chi2"] < 1.2
    right = searches.retrieve(images, lm.Pupil(), defocus=[-4.0, 0.0, 5.0], **options)
    assert right.findings.get("exchanged") is None
    assert right.chi2 < 1.2


def test_one_defocus_leaves_the_sign_of_even_terms_open_and_says_so():
    known = lm.retrieve(
        stars(TRUE, defocus=1.0), lm.Pupil(), terms=["noll 5", "noll 8", "noll 11"], defocus=1.0, **ASKED
    )
    assert known.converged
    assert "sign_open" not in known.findings.codes  # a defocus that is not solved for tells it
    assert known.coefficients["noll 5"] == pytest.approx(0.4, abs=5 * known.errors["noll 5"])
    assert FOCI in known.findings.get("untested").text
    image = stars(lm.Wavefront(defocus=-1.0) - TRUE, defocus=0.0)
    found = lm.retrieve(image, lm.Pupil(), terms=("defocus", "noll 5", "noll 8", "noll 11"), **ASKED)
    assert found.converged
    assert (found.status, found.reliable) == ("doubtful", False)
    assert found.findings.get("sign_open").severity == "doubt"
    one, twin = (each.edge_terms() for each in (found.wavefront, found.twin))
    assert twin[2, -2] == pytest.approx(-one[2, -2])
    assert twin[3, 1] == pytest.approx(one[3, 1])
    signs = {"defocus": 1.0, "noll 5": 0.4, "noll 8": 0.3, "noll 11": 0.2}
    for name, value in signs.items():
        assert found.coefficients[name] == pytest.approx(value, abs=6 * found.errors[name])
    other = lm.retrieve(
        image, lm.Pupil(lm.Wavefront(-0.5)), terms=("defocus", "noll 5", "noll 8", "noll 11"), **ASKED
    )
    assert other.coefficients["defocus"] == pytest.approx(-1.0, abs=6 * other.errors["defocus"])
    assert other.coefficients["noll 8"] == pytest.approx(0.3, abs=6 * other.errors["noll 8"])
    assert FOCI not in found.message
    two = lm.retrieve(stars(TRUE, defocus=[0.0, 2.0]), lm.Pupil(), terms=8, defocus=[0.0, 2.0], **ASKED)
    assert "sign_open" not in two.findings.codes
    assert FOCI in two.findings.get("untested").text
    assert two.twin is None
    assert two.reliable
    near = lm.retrieve(image, lm.Pupil(lm.Wavefront(0.9)), terms=("defocus", "noll 5", "noll 8", "noll 11"), **ASKED)
    assert near.findings.get("sign_open").severity == "note"  # the start is near, its twin is far


def test_a_negated_even_part_of_the_phase_has_the_same_images():
    made, x = model(terms=("defocus", "noll 5", "noll 8", "noll 11"))
    made.fixed_of_images[:, 0] = made.fixed_of_images[0, 0]
    assert made.sign_ambiguous
    same = made.even_part_negated(x)
    assert np.abs(same - x).max() > 0.1
    # A tilt of each image is odd, and stays.
    assert_allclose(made.images(same)[0], made.images(x)[0], atol=1e-8)


def test_a_spot_tells_its_f_number_and_place_too():
    light = {"wavelength": 550e-9, "f_number": 8.2}
    spot = stars(lm.Wavefront(2.0, 1.0), defocus=0.0, center=(16.3, 15.2), **light)
    found = lm.retrieve(
        spot, lm.Pupil(wavelength=550e-9, f_number=8.0), pixel=2e-6, noise=NOISE, terms=("defocus", "spherical"),
        also=("f_number", "center"),
    )  # fmt: skip
    assert found.converged
    expected = {"defocus": 2.0, "spherical": 1.0, "f_number": 8.2}
    assert list(found.coefficients) == list(expected)
    for name, value in expected.items():
        assert found.coefficients[name] == pytest.approx(value, abs=5 * found.errors[name])
    assert_allclose(found.center, [[16.3, 15.2]], atol=5 * max(found.errors["row"][0], found.errors["column"][0]))
    assert found.pupil.f_number == found.coefficients["f_number"]
    assert found.wavefront.defocus == pytest.approx(found.coefficients["defocus"])
    values, errors = found.in_unit("nm")
    assert values["defocus"] == pytest.approx(found.coefficients["defocus"] * 550 / np.pi)  # W020
    assert errors["spherical"] == pytest.approx(found.errors["spherical"] * 550 / (2 * np.pi))
    assert set(values) == {"defocus", "spherical"}


def test_the_wavefront_is_that_of_the_fit_where_the_images_do_not_determine_a_term():
    """In focus, the derivative by defocus vanishes."""
    coma = lm.Wavefront.zernike({8: 0.666}, order="noll")
    star = stars(coma, defocus=0.0)
    found = lm.retrieve(star, lm.Pupil(), terms=("noll 8", "noll 7", "noll 4"), **ASKED)
    model = lm.psf(found.pupil, 33, 0.5, center=tuple(found.center[0])).values * found.flux[0] + found.background[0]
    assert np.mean((star - model) ** 2 / (model + 4.0)) < 2.0
    assert abs(found.coefficients["noll 4"]) < 1.0


def test_terms_of_the_pupil_that_are_not_solved_for_stay():
    found = lm.retrieve(stars(TRUE), lm.Pupil(TRUE + lm.Wavefront(0.2)), terms=("defocus",), defocus=DEFOCUS, **ASKED)
    assert found.converged
    assert found.coefficients["defocus"] == pytest.approx(0.0, abs=5 * found.errors["defocus"])
    assert found.wavefront.to_zernike(order="noll")[8] == pytest.approx(-0.3)
    nothing = lm.retrieve(stars(TRUE), lm.Pupil(TRUE), terms=(), defocus=DEFOCUS, **ASKED)
    assert nothing.converged
    assert nothing.coefficients == {}
    assert_allclose(nothing.center, 16.0, atol=0.1)


def test_pixels_that_are_not_light_are_left_out():
    images = stars(TRUE)
    clean = lm.retrieve(images, lm.Pupil(), defocus=DEFOCUS, terms=8, **ASKED)
    assert clean.converged
    spoiled = images.copy()
    spoiled[0, 10:14, 10:14] = np.nan
    spoiled[1, 16, 16] = np.inf
    bad = np.zeros((33, 33), dtype=bool)
    bad[5] = True
    spoiled[:, 5] = 1e6
    ways = {
        "mask": (lm.Counts.of(spoiled, noise=NOISE, mask=bad), None),
        "saturation": (lm.Counts.of(spoiled, noise=NOISE, saturation=5e5), None),
        "masked": (np.ma.masked_greater(spoiled, 5e5), NOISE),
    }
    for recorded, noise in ways.values():
        found = lm.retrieve(recorded, lm.Pupil(), pixel=0.5, noise=noise, defocus=DEFOCUS, terms=8)
        assert found.converged
        assert np.isnan(found.residual).sum() == 16 + 1 + 3 * 33 - 0
        assert np.isnan(found.images[:, 5]).all()
        assert np.isfinite(found.model).all()
        for name, value in found.coefficients.items():
            assert value == pytest.approx(clean.coefficients[name], abs=3 * clean.errors[name])


def test_counts_of_a_camera_are_light_by_the_noise_that_is_stated():
    camera = lm.Noise(white=0.5, read=2.0, offset=100.0)
    counts = np.clip(camera.image(stars(TRUE)), 0, 2000).astype(np.uint16)
    recorded = lm.Counts.of(counts, noise=camera, saturation=2000)
    found = lm.retrieve(recorded, lm.Pupil(), pixel=0.5, defocus=DEFOCUS, terms=8)
    assert found.converged
    assert_allclose(found.flux, 1e5, rtol=0.03)
    assert_allclose(
        found.model,
        camera.image(found.flux[:, None, None] * found.psf.values + found.background[:, None, None]),
        rtol=1e-6,
    )
    full = np.where(counts > 900, 65535, counts).astype(np.uint16)  # the largest of its type
    again = lm.retrieve(full, lm.Pupil(), pixel=0.5, noise=camera, defocus=DEFOCUS, terms=8)
    assert np.isnan(again.images[counts > 900]).all()
    assert again.converged


def test_a_pixel_at_the_full_scale_of_a_camera_is_the_first_cause_of_a_misfit():
    images = stars(TRUE)
    remark = "1 pixel has the value 4095 = 2^12 - 1, the largest of 12 bits, and may be saturated: if so, state it"

    def found(scale, saturation=None):
        camera = lm.Noise(white=scale * images.max() / 3995.0, read=2.0, offset=100.0)
        counts = np.clip(camera.image(images).round(), 0, 4095).astype(np.uint16)
        assert (counts == 4095).sum() == 1
        recorded = lm.Counts.of(counts, noise=camera, saturation=saturation)
        return searches.retrieve(recorded, lm.Pupil(), pixel=0.5, defocus=DEFOCUS, terms=8, starts=2)

    within, clipped = found(1.0), found(0.7)
    assert within.reliable
    assert within.findings.get("flat_top").text.startswith(remark)
    assert clipped.status == "misfit"
    assert clipped.message.startswith(f"misfit: {remark} (saturation=4095); ")
    assert "chi2" in clipped.message
    stated = found(0.7, saturation=4095)
    assert stated.reliable
    assert "flat_top" not in stated.findings.codes


def test_what_does_not_fit_is_told():
    images = stars(TRUE)
    options = ASKED | {"defocus": DEFOCUS, "terms": 8, "starts": 2}
    wide = searches.retrieve(images, lm.Pupil(), **options | {"pixel": 0.6})
    assert wide.status == "doubtful"
    assert 0.05 < wide.findings.get("missed_light").numbers["missed"] < 0.2
    assert wide.chi2 > 2.0
    quiet = searches.retrieve(images, lm.Pupil(), **options | {"noise": lm.Noise(read=60.0)})
    assert quiet.findings.get("too_quiet").severity == "doubt"
    assert not quiet.reliable
    assert "pupil, pixel, noise, defocus or blur are wrong" in wide.message
    dark = searches.retrieve(NOISE.record(np.full((3, 33, 33), 5.0), 1), lm.Pupil(), **options)
    assert not dark.converged
    assert dark.status == "no_light"
    short = searches.retrieve(images, lm.Pupil(), **options | {"steps": 1, "starts": 1})
    assert not short.converged


def test_what_the_images_do_not_tell_has_no_deviation_but_infinity():
    both = {"wavelength": 550e-9, "f_number": 8.0}
    image = stars(lm.Wavefront(2.0), defocus=0.0, **both)
    pupil = lm.Pupil(lm.Wavefront(2.0), **both)
    found = lm.retrieve(image, pupil, pixel=2e-6, noise=NOISE, terms=("defocus",), also=("f_number", "wavelength"))
    assert np.isinf([found.errors["f_number"], found.errors["wavelength"]]).all()
    assert "do not determine" in found.message
    assert "wavelength" in found.message
    assert found.reliable  # of what else is solved for


def test_one_seed_makes_one_answer():
    images = stars(random_wavefront(1, 3.0)[0], seed=1)
    first, second = (
        searches.retrieve(images, lm.Pupil(), defocus=DEFOCUS, also=(), seed=4, starts=3, **ASKED) for _ in range(2)
    )
    assert first.coefficients == second.coefficients


def test_what_is_saved_comes_back(tmp_path):
    found = lm.retrieve(stars(TRUE), lm.Pupil(), defocus=DEFOCUS, terms=8, **ASKED)
    for suffix in ("json", "toml", "csv"):
        found.save(tmp_path / f"wave.{suffix}")
        again = lm.load_zernike(tmp_path / f"wave.{suffix}").wavefront()
        assert_allclose(again.phase(0.7, 0.3), found.wavefront.phase(0.7, 0.3), rtol=1e-12)
    assert json.loads((tmp_path / "wave.json").read_text())["order"] == "noll"
    with pytest.raises(ValueError, match=r"path must end in \.json"):
        found.save(tmp_path / "wave.txt")


def test_the_picture_shows_images_model_residual_and_terms():
    found = lm.retrieve(stars(TRUE), lm.Pupil(), defocus=DEFOCUS, terms=8, **ASKED)
    figure = found.plot()
    pictures = [axes for part in figure.subfigs for axes in part.axes if axes.images]
    assert_allclose(pictures[0].images[0].get_array(), found.images[0])
    assert_allclose(pictures[3].images[0].get_array(), found.model[0])
    assert_allclose(pictures[6].images[0].get_array(), found.residual[0])
    bars = figure.subfigs[1].axes[0]
    assert [bar.get_width() for bar in bars.containers[0]] == pytest.approx(list(found.coefficients.values()))
    assert [label.get_text() for label in bars.get_yticklabels()][4] == "noll 8 coma x"
    numbers = bars.texts[4].get_text().replace("\N{MINUS SIGN}", "-").split(" ± ")
    expected = list(found.coefficients.values())[4], list(found.errors.values())[4]
    assert [float(number) for number in numbers] == pytest.approx(expected, rel=0.06)
    assert "noll 8 coma x" in repr(found)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"defocus": [1.0, 2.0]}, r"defocus must be a number, or one for each of 3 images, got 2 numbers"),
        ({"terms": ("noll 4", (2, 0))}, "terms must be linearly independent"),
        ({"terms": ("noll 2",)}, r"terms must be without \(1, 1\) if the column"),
        ({"also": ("f_number",)}, "also must be without f_number where pupil has no wavelength"),
        ({"images": lm.Counts.of(np.ones((3, 33, 33)), noise=NOISE)}, "noise must be omitted if images are Counts"),
        ({"pupil": lm.Pupil(mask=lm.Mask(np.ones((64, 64)))), "also": "obscuration"}, "without \"obscuration\""),
    ],
)  # fmt: skip
def test_what_cannot_be_fitted_is_refused(change, said):
    options = ASKED | {"images": stars(TRUE), "pupil": lm.Pupil(), "defocus": DEFOCUS} | change
    images, pupil = options.pop("images"), options.pop("pupil")
    with pytest.raises((ValueError, TypeError), match=said):
        lm.retrieve(images, pupil, **options)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_an_aperture_without_point_symmetry_determines_the_sign_of_even_terms(sign):
    stop = lm.Disc() - (lm.Disc(0.3, (0.5, 0.2)) | lm.Polygon.strip((0.0, 0.0), (-2.0, 0.5), 0.2))
    truth = {(2, 2): 0.8 * sign, (2, 0): 0.5 * sign, (3, 1): 0.4}
    pupil = lm.Pupil(lm.Wavefront.zernike(truth), stop=stop)
    noise = lm.Noise(read=2.0)
    image = noise.record(1e5 * lm.psf(pupil, 33, 0.4).values, seed=1)
    found = lm.retrieve(image, lm.Pupil(stop=stop), pixel=0.4, noise=noise, terms=[(2, 2), (2, 0), (3, 1)], seed=3)
    assert found.converged
    assert "sign_open" not in found.findings.codes
    for term, value in truth.items():
        assert abs(found.coefficients[term] - value) < 5.0 * found.errors[term]


@pytest.mark.parametrize(
    ("aperture", "alike"),
    [
        ({}, True),
        ({"stop": lm.telescopes.vlt()}, True),
        ({"stop": lm.telescopes.jwst()}, False),  # three struts
        ({"stop": lm.telescopes.keck()}, True),
        ({"stop": lm.telescopes.hst()}, False),
        ({"spider": lm.Spider.equal(3, 0.02)}, False),
        ({"vignetting": lm.CatEye((0.2, 0.0))}, False),
        ({"mask": lm.Mask.sample(lambda x, y: np.exp(-(x**2)) + 0.0 * y, 16)}, True),
        ({"mask": lm.Mask.sample(lambda x, y: 0.5 + 0.2 * x + 0.0 * y, 16)}, False),
        ({"mask": lm.Mask.sample(lambda x, y: np.exp(1j * (x**2 + y)), 16)}, False),
    ],
)
def test_which_apertures_look_the_same_after_half_a_turn(aperture, alike):
    assert _point_symmetric(lm.Pupil(**aperture)) is alike


def through_air(seed, widths=(0.9, 1.1), side=25, *, defoci=(0.0, 3.0), pixel=0.5, photons=2e4, ratio=math.inf):
    """Return images of a star through turbulence of outer scale `ratio` r0, by pupils' transfer functions alone."""
    telescope, images = Telescope(), []
    for defocus, fwhm in zip(defoci, widths, strict=True):
        transfer = telescope.transfer(((5, 0.3), (8, -0.25), (11, 0.2)), defocus=2 * defocus)
        blur = air.kolmogorov if math.isinf(ratio) else partial(air.von_karman, ratio=ratio)
        transfer = transfer.times(blur(transfer.radius, fwhm))
        images.append(photons * transfer.image(side, pixel, side // 2 + 0.2, side // 2 - 0.3) + 10.0)
    return np.random.default_rng(seed).poisson(images) + np.random.default_rng(seed).normal(0.0, 3.0, (2, side, side))


def test_of_a_star_through_air_seeing_is_estimated_with_the_wavefront():
    z, of_images = [], []
    for seed in range(4):
        images = through_air(seed)
        terms = [f"noll {j}" for j in range(4, 12)]
        plain = {"pixel": 0.5, "noise": lm.Noise(read=3.0), "defocus": [0.0, 3.0], "terms": terms, "integrate": True}
        unstated = searches.retrieve(images, lm.Pupil(), starts=1, **plain)
        assert {"estimated", "missed_light", "misfit"} & {*unstated.findings.codes}
        found = searches.retrieve(images, lm.Pupil(), blur=True, **plain)
        assert found.converged
        assert found.findings.get("blur_shape").numbers["gain"] > 0.0
        truth = dict.fromkeys(terms, 0.0) | {"noll 5": 0.3, "noll 8": -0.25, "noll 11": 0.2}
        z += [(found.coefficients[name] - truth[name]) / found.errors[name] for name in truth]
        assert [type(one).__name__ for several in found.blurs for one in several] == ["Seeing", "Seeing"]
        assert_allclose(found.center, [[12.2, 11.7]] * 2, atol=0.1)
        of_images += [
            (found.center[:, k] - at) / found.errors[n] for k, n, at in ((0, "row", 12.2), (1, "column", 11.7))
        ]
        of_images += [(found.flux - 2e4) / found.errors["flux"], (found.background - 10) / found.errors["background"]]
        assert np.nanstd(found.residual) == pytest.approx(1.0, abs=0.1)
    wrong = searches.retrieve(images, lm.Pupil(obscuration=0.7), blur=True, **plain)
    assert not wrong.converged
    assert "degree is too low" not in wrong.message  # of a map, of which there is none
    # chi2 of 32 at 1e-3 and 1 - 1e-3
    assert 0.62 < np.sqrt(np.mean(np.square(z))) < 1.4
    assert 0.62 < np.sqrt(np.mean(np.square(of_images))) < 1.4


@pytest.mark.parametrize("ratio", [450.0, math.inf])
def test_the_error_of_r0_includes_the_outer_scale_that_is_not_known(ratio):
    widths, defoci = (2.6, 3.0), (-8.0, 8.0)
    for seed in range(2):
        images = through_air(seed, widths, 41, defoci=defoci, pixel=1.0, photons=1e6, ratio=ratio)
        found = searches.retrieve(
            images, lm.Pupil(), pixel=1.0, noise=lm.Noise(read=3.0), defocus=defoci, blur=True, integrate=True,
            terms=[f"noll {j}" for j in range(4, 12)],
        )  # fmt: skip
        assert found.converged
        for width, (seeing, *_), (error, *_) in zip(widths, found.blurs, found.blur_errors, strict=True):
            assert seeing.r0 == pytest.approx(air.WIDTH / width, abs=3.0 * error)
            # Next to an outer scale of 1000 r0, another fits nearly as well; noise alone leaves an error of 0.5 %.
            assert 0.01 < error / seeing.r0 < 0.05


def test_the_outer_scale_is_chosen_by_exact_images():
    # With the accuracy that a search needs, an outer scale of 1000 r0 seems more likely.
    images = through_air(2, (3.6, 4.1), 61, defoci=(-20.0, 20.0), pixel=1.367, photons=5e5)
    terms, noise = [f"noll {j}" for j in range(4, 12)], lm.Noise(read=3.0)
    found = searches.retrieve(
        images, lm.Pupil(), pixel=1.367, noise=noise, defocus=(-20.0, 20.0), blur=True, terms=terms, integrate=True
    )
    assert [blurs[0].outer_scale for blurs in found.blurs] == [None, None]


def test_starts_too_strong_to_be_computed_are_left_out(monkeypatch):
    images = NOISE.record(2e4 * lm.psf(lm.Pupil(lm.Wavefront([-4.0, 4.0])), 15, 0.5).values + 5.0, seed=1)
    monkeypatch.setattr(phase_retrieval, "_SCATTER", 2000.0)
    found = searches.retrieve(images, lm.Pupil(), pixel=0.5, noise=NOISE, defocus=[4, 6], terms=3, starts=5)
    assert not found.converged
    assert found.starts == 5
