"""What chi2 noise alone explains, beside draws of chi2 and of counts of few electrons.

And the score test of excess noise: right on a register's counts, silent where means or noise are otherwise wrong. And
of stripes: as rare as stated without them, and of the right kind, size, period and direction.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from lommel.fit import goodness_of_fit
from lommel.fit.score_tests import ScoreTest, causes_of_misfit
from lommel.recorded.noise import Noise

Y, X = np.mgrid[:21, :21] - 10.0
READ = 0.2


def test_limits_hold_for_counts_of_few_electrons():
    draw, mean, read, pixels = np.random.default_rng(1), 0.4, 0.25, 150
    counts = draw.poisson(mean, (100_000, pixels)) + np.sqrt(read) * draw.normal(size=(100_000, pixels))
    chi2 = ((counts - mean) ** 2).mean(axis=1) / (mean + read)
    spread = np.sqrt((mean + 2.0 * (mean + read) ** 2) / pixels) / (mean + read)
    for share in (1e-2, 1e-3):
        assert 0.4 < (chi2 > goodness_of_fit.largest_plausible_chi2(spread, share)).mean() / share < 2.5
    # So many standard deviations of a normal distribution would be passed several times as often.
    assert (chi2 > 1.0 + stats.norm.isf(1e-3) * spread).mean() > 4e-3


def spot(width: float, flux: float = 2000.0, background: float = 8.0) -> np.ndarray:
    return flux * np.exp(-0.5 * (X**2 + Y**2) / width**2) / (2.0 * np.pi * width**2) + background


def outcome(mean: np.ndarray, model: np.ndarray, noise: Noise, images: int = 40, seed: int = 1):
    seen = noise.electrons(noise.record(np.broadcast_to(mean, (images, *mean.shape)), seed))
    return goodness_of_fit.excess_test(seen - model, model, READ**2)


@pytest.mark.parametrize("seed", range(4))
def test_a_register_is_told_with_its_share(seed):
    found = outcome(spot(2.0), spot(2.0), Noise(read=READ, excess=2.0), seed=seed)
    assert found.share == pytest.approx(1.0, abs=0.06)
    assert found.found
    (said,) = found.findings(1.0)
    assert (said.code, said.severity) == ("excess_noise", "error")
    assert "state excess=2" in said.text
    assert said.numbers["factor"] == pytest.approx(2.0, abs=0.06)
    assert not found.findings(2.0)


def test_where_the_noise_is_right_the_share_is_0_within_its_error():
    sizes = np.array([outcome(spot(2.0), spot(2.0), Noise(read=READ), 4, seed).sigmas for seed in range(100)])
    assert 0.8 < sizes.std() < 1.2
    assert abs(sizes.mean()) < 0.4


@pytest.mark.parametrize("width", [1.7, 1.8, 2.3])
def test_a_wrong_mean_is_not_taken_for_it(width):
    found = outcome(spot(2.0), spot(width), Noise(read=READ))
    assert found.sigmas > 5.0
    assert not found.found
    assert not found.findings(1.0)


@pytest.mark.parametrize("excess", [1.3, 4.0])
def test_other_factors_are_not_called_a_register(excess):
    assert not outcome(spot(2.0), spot(2.0), Noise(read=READ, excess=excess)).found


@pytest.mark.parametrize("factor", [0.4, 0.6, 1.5, 3.0])
def test_a_gain_that_is_stated_too_large_or_too_small_is_named(factor):
    light, draw = spot(2.0), np.random.default_rng(3)
    seen = draw.poisson(light, (40, *light.shape)) + draw.normal(0.0, READ, (40, *light.shape))
    found = goodness_of_fit.excess_test(factor * (seen - light), factor * light, READ**2)
    assert found.gain == pytest.approx(factor, rel=0.06)
    (said,) = found.findings(1.0)
    assert f"{1.0 / found.gain:.2g} times the stated gain" in said.text
    if said.code == "gain":
        assert said.severity == ("error" if factor > 1.0 else "doubt")
    assert not found.findings(2.0)


def test_the_stated_gain_is_not_doubted():
    assert all(outcome(spot(2.0), spot(2.0), Noise(read=READ), 4, seed).gain == 1.0 for seed in range(20))


@pytest.mark.parametrize("width", [1.7, 2.3])
def test_a_wrong_mean_is_no_other_gain(width):
    assert outcome(spot(2.0), spot(width), Noise(read=READ)).gain == 1.0


def test_read_noise_says_nothing_of_it():
    found = goodness_of_fit.excess_test(np.random.default_rng(1).normal(0, 5.0, 1000), 0.5, 4.0)
    assert found.share > 1.0
    found = goodness_of_fit.excess_test(np.full(100, np.nan), 1.0, 1.0)
    assert (found.sigmas, found.found) == (0.0, False)


def test_causes_are_named_unless_what_the_data_favour_explains_more_than_half_of_the_misfit():
    spread = np.sqrt(2.0 / 1000.0)  # of 1000 degrees of freedom: chi2 of 1.2 is an excess of 200
    for sigmas, causes in ((14.0, ""), (-14.0, ""), (9.9, "pixel is wrong")):
        test = ScoreTest("blur", np.zeros(1), np.ones(1), sigmas, 9.0)
        assert causes_of_misfit("pixel is wrong", 1.2, spread, [test]) == causes
        found = goodness_of_fit.chi2_findings(1.2, spread, causes)[0]
        assert found.text == "noise alone keeps chi2 below 1.17" + (f"; {causes}" if causes else "")
    assert causes_of_misfit("pixel is wrong", 1.2, spread, []) == "pixel is wrong"


def residuals(images: int, seed: int, added: np.ndarray | float = 0.0, read: float = 2.0):
    """Noise of stars on a sky of 8 electrons, with something added, and its variance."""
    draw, mean = np.random.default_rng(seed), np.broadcast_to(spot(3.0), (images, *X.shape))
    return draw.poisson(mean) - mean + draw.normal(size=mean.shape) * read + added, mean + read**2


def test_noise_alone_has_stripes_as_seldom_as_is_stated():
    told = [goodness_of_fit.stripe_findings(*residuals(3, seed)) for seed in range(2000)]
    assert sum(map(bool, told)) <= 6  # of 2 that are expected
    # A threshold of 2 % instead is passed by as many: the chance is one.
    draws = [residuals(2, seed, read=0.0) for seed in range(300)]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(goodness_of_fit, "SURE", 0.1)
        share = np.mean([bool(goodness_of_fit.stripe_findings(*one)) for one in draws])
    assert 0.03 < share < 0.14


@pytest.mark.parametrize(("x", "y"), [(5.5, 3.5), (-0.2, 5.3), (9.7, -3.3), (3.0, -9.0)])
@pytest.mark.parametrize(("phase", "amplitude"), [(0.0, 1.5), (1.5, 1.5), (1.0, 40.0)])
def test_size_and_direction_are_right_between_the_wave_vectors_of_the_window(x, y, phase, amplitude):
    wave, told = amplitude * np.sin(2 * np.pi * (x * X + y * Y) / 21 + phase), []
    for seed in range(6):
        (found,) = goodness_of_fit.stripe_findings(*residuals(6, seed, wave))
        assert (found.code, found.severity) == ("pattern", "doubt")
        told.append([found.numbers[name] for name in ("size", "period", "angle")])
        assert found.numbers["chance"] < 1e-6
    size, period, angle = np.mean(told, axis=0)
    assert size == pytest.approx(amplitude, rel=0.1)
    assert period == pytest.approx(21 / np.hypot(x, y), rel=0.01)
    assert angle == pytest.approx(np.degrees(np.arctan(y / x)), abs=1.0)


def test_every_second_column_is_found_with_its_offset():
    noise, variance = (each[:, :, :20] for each in residuals(3, 5, (-1.0) ** X))
    (found,) = goodness_of_fit.stripe_findings(noise, variance)
    assert found.numbers["period"] == 2.0
    assert found.numbers["size"] == pytest.approx(1.0, rel=0.2)


@pytest.mark.parametrize(("axis", "kind"), [(2, "rows"), (1, "columns")])
@pytest.mark.parametrize("excess", [1.0, 2.0])
def test_offsets_of_rows_or_columns_are_found_with_their_size(axis, kind, excess):
    draw = np.random.default_rng(2)
    added = np.expand_dims(draw.normal(size=(40, 21)), axis)
    (found,) = goodness_of_fit.stripe_findings(*residuals(40, 5, added), excess)
    assert found.text.startswith(f"the residuals have a pattern: {kind} of pixels have offsets")
    assert found.numbers["size"] == pytest.approx(excess * added.std(), rel=0.15)


def test_slopes_unknown_pixels_and_small_windows_are_no_stripes():
    noise, variance = residuals(4, 9, 1.5 * np.sin(2 * np.pi * X / 21))
    assert goodness_of_fit.stripe_findings(noise, variance) == []
    noise, variance = residuals(4, 9, 3.0 * np.sin(2 * np.pi * X / 7))
    assert goodness_of_fit.stripe_findings(np.full(noise.shape, np.nan), variance) == []
    assert goodness_of_fit.stripe_findings(noise[:, :5], variance[:, :5]) == []
    noise[:, 4:9, 2:] = np.nan
    assert goodness_of_fit.stripe_findings(noise, variance)[0].numbers["size"] == pytest.approx(3.0, rel=0.15)


@pytest.mark.parametrize(
    ("chance", "freed", "severities"),
    [(2e-2, True, []), (5e-3, False, ["note"]), (5e-3, True, ["doubt"]), (5e-4, False, ["doubt"])],
)
def test_a_rare_chi2_is_a_doubt_where_effects_are_freed(chance, freed, severities):
    chi2 = float(goodness_of_fit.largest_plausible_chi2(0.02, chance))
    found = goodness_of_fit.chi2_findings(chi2, 0.02, "", freed=freed)
    assert [(one.code, one.severity) for one in found] == [("rare_chi2", severity) for severity in severities]


def test_a_pattern_that_explains_little_of_a_misfit_is_not_named():
    draw = np.random.default_rng(4)
    rows, columns = np.indices((33, 33))
    noise = draw.normal(size=(2, 33, 33))
    star = 10.0 * draw.normal(size=(2, 33, 33)) * (np.hypot(rows - 16, columns - 16) < 8)
    stripes = 3.0 * np.cos(2.0 * np.pi * columns / 5.0)
    (told,) = goodness_of_fit.stripe_findings(noise + stripes, np.ones_like(noise))
    assert told.numbers["period"] == pytest.approx(5.0, rel=0.02)
    smooth = 40.0 * np.exp(-0.5 * ((rows - 16) ** 2 + (columns - 16) ** 2) / 3.0**2)
    for misfit in (star, np.array([smooth, -smooth])):
        assert not goodness_of_fit.stripe_findings(noise + misfit, np.ones_like(noise))


def doubted(*spots, ring=0.0):
    """Return the findings on spots in residuals of two images of 31 x 31 pixels; light is a ring of radius 5."""
    y, x = np.mgrid[:31, :31] - 15.0

    def star(row, column):
        return 2e3 * np.exp(-0.5 * (np.hypot(y - row, x - column) - 5.0) ** 2)

    light = np.stack([star(0.0, 0.0)] * 2)
    variance = light + 20.0
    residual = np.random.default_rng(3).normal(size=light.shape) * np.sqrt(variance) + 0.05 * star(6.0, -8.0) * ring
    residual[0, 0, 0] = np.nan
    for k, row, column, sigmas in spots:
        residual[k, row, column] = sigmas * np.sqrt(variance[k, row, column])
    misfit = goodness_of_fit.Finding("misfit", "error", "chi2")
    return goodness_of_fit.spot_findings([misfit], residual, variance, light)


def test_single_pixels_that_carry_a_misfit_are_named_with_their_images():
    assert doubted() == doubted((0, 3, 4, 7.0)) == []
    (one,) = doubted((1, 3, 4, 90.0))
    assert (one.numbers["place"], one.numbers["pixels"]) == ((1, 3, 4), 1)
    (two,) = doubted((1, 3, 4, 90.0), (0, 20, 9, -60.0), (0, 20, 10, -55.0))  # two of them are adjacent
    assert (two.code, two.numbers["pixels"]) == ("hot_pixels", 3)
    assert "(row 3 column 4 of image 2, row 20 column 9 of image 1, row 20 column 10 of image 1)" in two.text
    blob = [(0, 10 + k // 3, 20 + k % 3, 60.0) for k in range(9)]  # no single pixel
    assert "hot_pixels" not in [one.code for one in doubted(*blob)]


def test_a_second_star_is_named_with_its_place_where_it_explains_most_of_a_misfit():
    (found,) = doubted(ring=1.0)
    assert (found.code, found.numbers["place"]) == ("other_explanation", (6, -8))
    assert abs(found.numbers["share"] - 0.05) < 0.005
    assert "+6 rows and -8 columns away" in found.text
    assert doubted(ring=-1.0) == []
