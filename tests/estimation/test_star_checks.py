"""Score tests of the images of one star, which are made by other means than the fit."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
import searches
from lommel.core.answers import Declined
from lommel.estimation import star_checks
from lommel.fit.score_tests import Candidate, ScoreTest
from tests.world import air
from tests.world.camera import Camera, trailed
from tests.world.optics import Telescope

WAVES = ((4, 0.3), (5, -0.2), (8, 0.25))
TERMS = ["noll 4", "noll 5", "noll 8"]


def recorded(
    waves=WAVES, *, sigma=0.0, slope=0.0, longer=1.0, squeezed=1.0, blocked=0.2, dimmed=0.0, lost=0.0, seed=0,
    late=0.0, oval=0.0, changed=0.0, foci=(0.0, 3.0), **light,
):  # fmt: skip
    """Return images of a star at two foci; what is not in the model is said by the arguments."""
    telescope = Telescope(600e-9, 8.0 * squeezed, blocked, dimmed=dimmed, squeezed=oval, **light)
    draw, mean = np.random.default_rng(3), []
    for known, way in zip(foci, np.linspace(-1.0, 1.0, len(foci)), strict=True):
        moved = tuple((j, size + way * changed * (j == 8)) for j, size in waves)
        transfer = telescope.transfer(moved, defocus=2 * known * longer)
        transfer = transfer.times(air.gaussian(transfer.radius, sigma * 2.4e-6))
        image = 5e4 * transfer.image(29, 2.4e-6, *(14 + draw.uniform(-0.3, 0.3, 2))) + 20.0 + slope * np.arange(29.0)
        mean.append(image - lost * image**2 / 1e4)
    return Camera(gain=0.0, read=3.0).record(trailed(np.array(mean), late), seed)


def found(images, aperture=None, **more):
    pupil = lm.Pupil(obscuration=0.2, wavelength=600e-9, f_number=8.0, **(aperture or {}))
    options = {"defocus": [0.0, 3.0], "terms": TERMS, "tol": 1e-4, "threads": 1, "starts": 2} | more
    return searches.retrieve(images, pupil, pixel=2.4e-6, noise=lm.Noise(read=3.0), **options)


def seen(fit):
    told = fit.findings.get("other_explanation")
    return {} if told is None else told.numbers


@pytest.mark.parametrize("seed", range(3))
def test_nothing_is_seen_where_nothing_is_missing(seed):
    fit = found(recorded(seed=seed))
    assert fit.reliable
    assert not seen(fit)


@pytest.mark.parametrize(
    ("world", "name", "size"),
    [
        ({"slope": 0.3}, "background gradient", None),
        ({"dimmed": 0.1}, "apodization", 0.1),
        ({"slanted": 0.06}, "light that slopes across the pupil", 0.06),
        ({"off": 0.05}, "obscuration off the middle", 0.05),
        ({"oval": 0.04}, "aperture that is not round", 0.02),
        ({"late": 0.03}, "charge that arrives late in higher rows", 0.03),
        ({"lost": 0.3}, "non-linear gain", 0.3),
    ],
)
def test_what_is_missing_is_named_first_with_its_size(world, name, size):
    fit = found(recorded(**world))
    assert next(iter(seen(fit))) == name
    if size is not None:
        one = seen(fit)[name]
        assert abs(one["size"][0] - size) < 3 * one["errors"][0] + 0.15 * size  # one step of scoring
    # A small change of the terms is a note, a large or an open one a doubt; they allow for the effect.
    assert fit.reliable == (seen(fit)["move"] < 3.0 and seen(fit)["rest"] < 1.0)
    assert np.abs(pulls_of(fit)).max() < 4.0


@pytest.mark.parametrize(
    ("world", "name", "stated", "true"),
    [
        ({"waves": (*WAVES, (6, 0.06))}, "noll 6", 0.0, 0.06),
        ({"waves": (*WAVES, (22, 0.08))}, "noll 22", 0.0, 0.08),
        ({"longer": 1.05}, "defocus scale", 1.0, 1.05),
        ({"squeezed": 1.03}, "f_number", 8.0, 8.24),
        ({"blocked": 0.23}, "obscuration", 0.2, 0.23),
        ({"changed": 0.06}, "noll 8 coma x that changes over the images", 0.0, 0.06),
    ],
)
def test_what_is_missing_is_estimated_where_the_model_can(world, name, stated, true):
    fit = found(recorded(**world))
    (label, told), *others = fit.findings.get("estimated").numbers.items()
    # One wrong defocus of two explains the images as well as a scale, with another mean defocus.
    assert fit.reliable
    assert ([*dict(others)] == ["move"]) == (name != "defocus scale")
    assert (label.startswith(name), told["stated"]) == (True, stated)
    assert (told["value"], told["error"]) == pytest.approx((fit.coefficients[name], fit.errors[name]))
    if name == "defocus scale":
        assert {"defocus of image 1", "defocus of image 2"} < {*dict(others)}
        assert told["error"] > abs(told["value"] - stated)
        assert all(one["error"] > abs(one["value"] - one["stated"]) for name, one in others if name != "move")
        assert "noll 4 defocus differs" in fit.message
    assert fit.coefficients[name] == pytest.approx(true, abs=4 * fit.errors[name])
    assert np.abs(pulls_of(fit)).max() < 4.0
    assert f"(stated {stated:g}" in fit.message


PLACES = np.abs((np.arange(256) - 127.5) / 128.0)
OPEN = (np.minimum(PLACES[:, None], PLACES) > 0.02).astype(float)


@pytest.mark.parametrize("aperture", [{"spider": lm.Spider.equal(4, width=0.04)}, {"mask": lm.Mask(OPEN)}])
def test_a_wrong_f_number_is_estimated_behind_vanes(aperture):
    fit = found(recorded(squeezed=1.03, vanes=0.04), aperture)
    assert fit.coefficients["f_number"] == pytest.approx(8.24, abs=4 * fit.errors["f_number"])
    assert fit.errors["f_number"] < 0.03
    assert np.abs(pulls_of(fit)).max() < 4.0


STRIPS = lm.Polygon.strip((-1.2, 0.0), (1.2, 0.0), 0.04) | lm.Polygon.strip((0.0, -1.2), (0.0, 1.2), 0.04)


@pytest.mark.parametrize("world", [{"waves": (*WAVES, (22, 0.25))}, {"blocked": 0.3}])
def test_the_shape_of_blur_is_chosen_anew_once_its_cause_is_estimated(world):
    fit = found(recorded(sigma=0.6, seed=1, **world), blur=True)
    assert fit.reliable
    assert fit.findings.get("estimated")
    # Before, seeing stood for the ring of light besides.
    (first,), (second,) = fit.blurs
    for blur, (error,) in zip((first, second), fit.blur_errors, strict=True):
        assert isinstance(blur, lm.Jitter)
        assert blur.sigma == pytest.approx(0.6 * 2.4e-6, abs=4.0 * error)


def test_vanes_that_are_turned_are_named_first():
    turned = lm.Spider(0.06, tuple(np.radians(3.0) + np.arange(4) * np.pi / 2.0))
    fit = found(recorded(vanes=0.06), {"spider": turned})
    one = seen(fit)["vanes turned about the axis"]
    assert next(iter(seen(fit))) == "vanes turned about the axis"
    assert abs(one["size"][0] + 3.0) < 0.6 + 3.0 * one["errors"][0]
    assert "vanes turned about the axis, by a linear estimate = -" in fit.message


@pytest.mark.parametrize("aperture", [{"spider": lm.Spider.equal(4, width=0.04)}, {"stop": lm.Disc() - STRIPS}])
def test_a_wrong_obscuration_is_estimated_behind_vanes(aperture):
    fit = found(recorded(blocked=0.25, vanes=0.04), aperture)
    assert fit.reliable
    assert [*fit.findings.get("estimated").numbers] == ["obscuration", "move"]
    assert fit.coefficients["obscuration"] == pytest.approx(0.25, abs=4 * fit.errors["obscuration"])
    assert fit.errors["obscuration"] < 0.005
    assert np.abs(pulls_of(fit)).max() < 4.0


def test_an_obscuration_behind_vanes_is_estimated_where_that_is_asked():
    fit = found(recorded(blocked=0.25, vanes=0.04), {"stop": lm.Disc() - STRIPS}, also=("center", "obscuration"))
    assert fit.reliable
    assert fit.pupil.obscuration == fit.coefficients["obscuration"]
    assert fit.coefficients["obscuration"] == pytest.approx(0.25, abs=4 * fit.errors["obscuration"])


def test_a_wrong_obscuration_behind_a_mask_is_a_doubt():
    fit = found(recorded(blocked=0.25, vanes=0.04), {"mask": lm.Mask(OPEN)})
    assert not fit.reliable
    assert next(iter(seen(fit))) == "obscuration"


def test_blur_that_is_missing_is_estimated_of_each_image():
    fit = found(recorded(sigma=0.3))
    widths = [blur[0].sigma / 2.4e-6 for blur in fit.blurs]
    assert fit.reliable
    np.testing.assert_allclose(widths, 0.3, atol=0.05)
    assert [*fit.findings.get("estimated").numbers] == ["blur of image 1", "blur of image 2", "move"]
    assert np.abs(pulls_of(fit)).max() < 4.0


def test_what_is_estimated_besides_is_in_the_pupil_and_the_wavefront():
    fit = found(recorded(squeezed=1.03, waves=(*WAVES, (6, 0.1))))
    assert [*fit.coefficients] == [*TERMS, "noll 6", "f_number"]
    assert fit.pupil.f_number == fit.coefficients["f_number"]
    edge = fit.wavefront.edge_terms()[2, 2]
    assert edge == pytest.approx(fit.coefficients["noll 6"] * 6**0.5)
    assert fit.covariance.shape == (5, 5)
    assert (fit.units["f_number"], fit.units["noll 6"]) == ("", "rad")
    assert [*fit.in_unit("nm")[0]] == [*TERMS, "noll 6"]


def pulls_of(fit):
    true = dict(zip(TERMS, (0.3, -0.2, 0.25), strict=True))
    return np.array([(fit.coefficients[name] - true[name]) / fit.errors[name] for name in TERMS])


@pytest.mark.parametrize("vanes", [0.0, 0.06])
@pytest.mark.parametrize("blur", [False, True])
def test_errors_contain_a_misfit_that_nothing_explains(vanes, blur):
    telescope = Telescope(600e-9, 8.0, 0.2, vanes=vanes)
    images = [
        1e6 * telescope.transfer(WAVES, defocus=2 * known).image(29, 2.4e-6, 14.2, 13.9) for known in (0.0, 3.0)
    ]
    images = np.array(images)
    if not vanes:  # a ghost of the star
        images += 0.01 * np.roll(images, (3, -4), (1, 2))
    images = Camera(gain=0.0, read=3.0).record(images + 20.0, 0)
    fit = found(images, blur=blur)
    assert fit.status == "doubtful"
    missed = fit.findings.get("missed_light")
    assert 0.005 < missed.numbers["missed"] < 0.1
    assert f"misses {100 * missed.numbers['missed']:.2g} % of the light" in missed.text
    assert np.abs(pulls_of(fit)).max() < 3.5
    if not blur:
        plain = found(images, checks=False)
        assert plain.status == "misfit"
        assert np.abs(pulls_of(plain)).max() > 10.0


@pytest.mark.parametrize(("gain", "status"), [(1.0, "converged"), (0.5, "doubtful"), (3.0, "gain")])
def test_another_gain_than_the_stated_one_is_named(gain, status):
    telescope = Telescope(600e-9, 8.0, 0.2)
    images = [
        2e4 * telescope.transfer(WAVES, defocus=2 * known).image(29, 2.4e-6, 14.2, 13.9) for known in (0.0, 3.0)
    ]
    images = Camera(gain=1.0, offset=100.0, read=3.0).record(np.array(images) + 20.0, 0)
    fit = lm.retrieve(
        images, lm.Pupil(obscuration=0.2, wavelength=600e-9, f_number=8.0), pixel=2.4e-6, defocus=[0.0, 3.0],
        noise=lm.Noise(white=gain, read=3.0, offset=100.0), terms=TERMS,
    )  # fmt: skip
    assert fit.status == status
    found = fit.findings.get("gain")
    if gain != 1.0:
        assert found.numbers["factor"] == pytest.approx(gain, rel=0.1)
        assert found.text in fit.message.split("; ")[0]


def test_what_is_estimated_is_no_candidate():
    fit = found(recorded(squeezed=1.02), also=("center", "f_number"))
    assert not seen(fit)
    assert fit.coefficients["f_number"] == pytest.approx(8.16, abs=4 * fit.errors["f_number"])


def test_a_wrong_defocus_of_one_image_is_estimated():
    fit = found(recorded(foci=(-3.0, 0.15, 3.0)), defocus=[-3.0, 0.0, 3.0])
    assert [*fit.findings.get("estimated").numbers] == ["defocus of image 2", "move"]
    assert fit.coefficients["defocus of image 2"] == pytest.approx(0.15, abs=4 * fit.errors["defocus of image 2"])
    assert fit.units["defocus of image 2"] == "rad"
    assert fit.reliable
    right = found(recorded(foci=(-3.0, 0.0, 3.0)), defocus=[-3.0, 0.0, 3.0])
    assert right.reliable


def test_slopes_of_the_background_are_those_of_each_image():
    fit = found(recorded(slope=0.3))
    one = seen(fit)["background gradient"]
    assert len(one["size"]) == 4
    # Rows and columns of the first image, then of the second.
    assert np.abs(np.asarray(one["size"])[[0, 2]]).max() < 4 * np.asarray(one["errors"]).max()
    np.testing.assert_allclose(np.asarray(one["size"])[[1, 3]], 0.3, atol=5 * np.asarray(one["errors"]).max())


def test_blur_that_cannot_be_tested_is_said(monkeypatch):
    def declined(*_, **__):
        raise Declined("too fine")

    monkeypatch.setattr(star_checks, "cached_plan", lambda *_, **__: declined)
    fit = found(recorded(sigma=0.3))
    assert fit.findings.get("untested").text == "blur was not tested: too fine"
    assert fit.findings.get("untested").severity == "note"
    assert "blur by a Gaussian besides" not in seen(fit)


def test_of_one_focus_the_known_defocus_is_said_not_to_be_determined():
    one = found(recorded(foci=(3.0,)), defocus=[3.0]).findings.get("untested")
    assert one.severity == "note"
    assert one.numbers["known defocus"] == {"noll 4 defocus": pytest.approx(0.03 / 3**0.5)}
    assert "not determined: known defocus (1 % of it changes noll 4 defocus by 0.017 rad)" in one.text
    for images, options in (
        (recorded(), {}),
        (recorded(WAVES[1:], foci=(3.0,)), {"defocus": [3.0], "terms": ["noll 5", "noll 8"]}),
    ):
        told = found(images, **options).findings.get("untested")
        assert told is None or "known defocus" not in told.numbers


def test_what_the_images_favour_within_chance_is_allowed_for_whole():
    candidates = [Candidate(name, (k,), 0.2) for k, name in enumerate(("f_number", "noll 9 trefoil", "wings"))]

    def kept(log_bayes, *others):
        tests = [ScoreTest(one.name, np.zeros(1), np.ones(1), 0.0, log_bayes) for one in candidates]
        return {one.name: one.scale for one in star_checks.to_marginalize(candidates, tests, others)}

    assert kept(-0.1) == {"f_number": 0.1}
    assert kept(-0.1, "wings") == {"f_number": 0.1, "wings": 0.2}
    assert kept(0.1) == {"f_number": 0.2, "noll 9 trefoil": 0.2, "wings": 0.2}


@pytest.mark.parametrize("late", [0.004, 0.008])
def test_errors_hold_where_something_small_is_missing(late):
    pulls = []
    for seed in range(6):
        fit = found(recorded(late=late, seed=seed))
        if fit.reliable:
            true = dict(zip(TERMS, (0.3, -0.2, 0.25), strict=True))
            pulls += [(fit.coefficients[name] - true[name]) / fit.errors[name] for name in TERMS]
    assert np.sqrt(np.mean(np.square([*pulls, 0.0]))) < 1.5
    assert max(map(abs, [*pulls, 0.0])) < 4.0


def test_a_fraction_of_light_above_one_is_told_as_a_wider_blur():
    def said(size):
        test = ScoreTest("wings", np.array([size]), np.array([0.01]), 99.0, 5e3)
        return star_checks.missing_findings([test], None, ())[0].text

    assert "fraction of light in a blur of twice the width = 0.100 +- 0.010" in said(0.1)
    assert "a blur that is wider than that of the model" in said(1.7)
    assert "fraction" not in said(1.7)


def test_a_fit_that_misses_little_light_is_reliable():
    telescope = Telescope(600e-9, 8.0, 0.2)
    images = np.array([
        3e5 * telescope.transfer(WAVES, defocus=2 * known).image(29, 2.4e-6, 14.2, 13.9) for known in (0.0, 3.0)
    ])  # fmt: skip
    images += 0.02 * np.roll(images, (2, -2), (1, 2))  # a neighbour
    images = Camera(gain=0.0, read=3.0).record(images + 20.0, 0)
    fit = found(images)
    assert fit.reliable
    assert fit.chi2 > 1.3
    assert 0.01 < fit.findings.get("missed_light").numbers["missed"] < 0.03
    assert np.abs(pulls_of(fit)).max() < 3.0
    assert np.abs(pulls_of(found(images, checks=False))).max() > 4.0


def test_no_effect_is_named_where_none_explains_a_misfit():
    images = recorded()
    rows, columns = np.indices(images.shape[1:])
    shaded = np.where(np.hypot(rows - 16, columns - 12) < 2.6, 0.7 * images, images)  # dust on the sensor
    fit = found(shaded)
    assert not fit.reliable
    assert not {"other_explanation", "estimated", "pattern"} & {*fit.findings.codes}
    assert "pupil (vanes, f-number), pixel, noise" in fit.message
