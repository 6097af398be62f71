"""Windows around stars and beads, and the reasons why others are refused."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.detection import find_crossings, find_spots
from lommel.localize import find as find_molecules

NOISE = lm.Noise(read=2.0)
AIRY = lm.psf(lm.Pupil(lm.Wavefront(1.5)), 61, 0.5).values.astype(np.float64)


def sky(stars, shape=(240, 300), background=20.0):
    """Return the mean electrons of stars (row, column, flux) of a lens a little out of focus."""
    wide = np.full((shape[0] + 60, shape[1] + 60), background)
    for row, column, flux in stars:
        wide[row : row + 61, column : column + 61] += flux * AIRY
    return wide[30:-30, 30:-30]


def found_in(stars, **options):
    return find_spots(NOISE.record(sky(stars), seed=1), noise=NOISE, window=options.pop("window", 21), **options)


def reasons(found):
    return {(each.row, each.column): each.reason for each in found.refused}


def test_isolated_stars_are_found_brightest_first_with_their_windows():
    stars = [(60, 60, 4e4), (60, 200, 1e5), (180, 120, 2e4)]
    image = NOISE.record(sky(stars), seed=1)
    found = find_spots(image, noise=NOISE, window=21)
    assert found.places.tolist() == [[60, 200], [60, 60], [180, 120]]
    assert found.refused == ()
    np.testing.assert_array_equal(found.windows[1], image[50:71, 50:71])
    np.testing.assert_allclose(found.centers, found.places, atol=0.1)
    np.testing.assert_allclose(found.flux, [1e5, 4e4, 2e4], rtol=0.2)
    assert np.all(np.diff(found.score) < 0.0)
    assert found.message == "3 spots found; refused: none"


def test_centers_follow_places_between_pixels():
    pupil = lm.Pupil(lm.Wavefront(1.5))
    image = np.full((80, 80), 10.0)
    image[20:61, 20:61] += 1e6 * lm.psf(pupil, 41, 0.5, center=(20.3, 19.6)).values
    found = find_spots(NOISE.record(image, seed=2), noise=NOISE, window=21)
    np.testing.assert_allclose(found.centers, [[40.3, 39.6]], atol=0.1)


def test_each_reason_of_refusal_is_told():
    stars = [(60, 60, 4e4), (60, 72, 3e4), (120, 5, 4e4), (180, 200, 6e6)]
    image = NOISE.record(sky(stars), seed=3)
    image[100, 250] += 3000.0  # a hot pixel
    found = find_spots(lm.Counts.of(image, noise=NOISE, saturation=5e5), window=21)
    told = reasons(found)
    assert told[60, 60] == told[60, 72] == "neighbor"
    assert told[120, 5] == "edge"
    assert told[180, 200] == "saturated"
    assert told[100, 250] == "defect"
    assert len(found) == 0
    assert found.message.startswith("0 spots found; refused: ")


@pytest.mark.parametrize(("beside", "kept"), [(8, False), (13, True)])
def test_a_hot_pixel_is_a_neighbor_in_the_window_alone(beside, kept):
    image = NOISE.record(sky([(60, 60, 4e4)]), seed=3)
    image[60, 60 + beside] += 30000.0
    found = find_spots(image, noise=NOISE, window=21)
    assert [60, 60] in found.places.tolist() or not kept
    assert (reasons(found).get((60, 60)) == "neighbor") != kept


def test_a_dim_neighbor_is_one_of_the_dim_star_alone():
    stars = [(60, 60, 1e6), (60, 78, 8e3)]
    image = NOISE.record(sky(stars), seed=1)
    found = find_spots(image, noise=NOISE, window=21)
    assert found.places.tolist() == [[60, 60]]
    assert reasons(found).get((60, 78)) == "neighbor"


@pytest.mark.parametrize(("distance", "count"), [(15, 0), (22, 2)])
def test_windows_of_spots_do_not_overlap(distance, count):
    assert len(found_in([(60, 60, 4e4), (60, 60 + distance, 4e4)])) == count


@pytest.mark.parametrize("plane", [0, 2])
def test_saturated_in_any_plane_is_a_reason(plane):
    stack = np.stack([sky([(60, 60, 3e4), (150, 200, 3e4)])] * 3).astype(np.uint16)
    stack[plane, 61, 61] = 2**16 - 1
    found = find_spots(stack, noise=NOISE, window=21)
    assert found.places.tolist() == [[150, 200]]
    assert found.windows.shape == (1, 3, 21, 21)
    assert found.windows.dtype == np.uint16
    np.testing.assert_array_equal(found.windows[0], stack[:, 140:161, 190:211])
    assert [each.reason for each in found.refused] == ["saturated"]


def test_rings_of_defocused_stars_are_one_spot_each():
    ring = lm.psf(lm.Pupil(lm.Wavefront(8.0), obscuration=0.3), 61, 0.5).values
    image = np.full((200, 300), 20.0)
    for row, column in ((100, 80), (100, 200)):
        image[row - 30 : row + 31, column - 30 : column + 31] += 3e6 * ring
    found = find_spots(NOISE.record(image, seed=4), noise=NOISE, window=61, width=10.0)
    assert sorted(found.places[:, 1].tolist()) == [80, 200]
    np.testing.assert_allclose(found.places[:, 0], 100, atol=1)


def test_at_most_so_many_are_kept():
    stars = [(60, 60, 4e4), (60, 200, 1e5), (180, 120, 2e4)]
    assert found_in(stars, most=2).places.tolist() == [[60, 200], [60, 60]]


def test_where_there_is_no_spot_the_highest_maximum_is_named():
    image = NOISE.record(sky([(60, 200, 1e4)]), seed=1)
    found = find_spots(image, noise=NOISE, window=21, threshold=500.0)
    assert (found.candidate.row, found.candidate.column) == (60, 200)
    (there,) = find_spots(image, noise=NOISE, window=21, threshold=found.candidate.score - 0.01).score
    assert there == found.candidate.score
    assert f"the highest maximum, at row 60, column 200, is {there:.3g} standard deviations high" in found.message


@pytest.mark.parametrize("kind", ["nan", "masked", "mask"])
def test_pixels_left_out_do_not_hide_stars_and_are_masked_in_their_windows(kind):
    image = NOISE.record(sky([(60, 60, 4e4), (60, 200, 1e5), (180, 120, 2e4)]), seed=1)
    out = np.zeros(image.shape, dtype=bool)
    out[60, 60] = out[64:67, 58:62] = out[150:200, 118:180] = out[0] = True
    given = image.copy()
    if kind == "nan":
        given[out] = np.nan
    elif kind == "masked":
        given = np.ma.MaskedArray(np.where(out, 1e9, image), mask=out)
    else:
        given[out] = 1e9
        given = lm.Counts.of(given, noise=NOISE, mask=out, saturation=1e8)
    found = find_spots(given, noise=None if kind == "mask" else NOISE, window=21)
    assert found.places.tolist() == [[60, 200], [60, 60]]
    assert [each.reason for each in found.refused] == ["masked"]
    np.testing.assert_array_equal(np.ma.getmaskarray(found.windows)[1], out[50:71, 50:71])
    assert found.left_out == out.sum()
    assert found.message == f"2 spots found; refused: 1 masked; {out.sum()} pixels left out (masked or NaN)"


SQUARES = 1.0 + np.sign(np.outer(*[np.arange(-20, 21)] * 2))


@pytest.mark.parametrize(("find", "default", "light"), [
    (lambda image, **of: find_spots(image, window=21, **of), 8.0, AIRY[9:-9, 9:-9] / AIRY.max()),
    (lambda image, **of: find_crossings(image, window=21, **of), 8.0, SQUARES),
    (lambda image, **of: find_molecules(image[None], 15, **of), 6.0, AIRY[9:-9, 9:-9] / AIRY.max()),
])  # fmt: skip
def test_thresholds_are_what_the_page_says_and_from_three_to_a_thousand(find, default, light):
    def count(size, **of):
        return len(find(20.0 + size * light, noise=lm.Noise(read=2.0), **of))

    low, high = 5.0, 500.0
    while high > 1.02 * low:
        middle = (low * high) ** 0.5
        low, high = (low, middle) if count(middle, threshold=default) else (middle, high)
    assert [count(size) for size in (0.98 * low, 1.02 * high)] == [0, 1]
    for threshold in (3.0, 1e3):
        count(high, threshold=threshold)
    for threshold in (2.99, 1001.0):
        with pytest.raises(ValueError, match="threshold must be"):
            count(high, threshold=threshold)


@pytest.mark.parametrize(("share", "count"), [(1.1, 4), (0.9, 3)])
def test_crossings_of_little_contrast_beside_that_of_the_third_quarter_are_none(share, count):
    """Of four the upper quartile is that of the brighter two."""
    contrasts = np.array([[1000.0, 1000.0], [600.0, share * 250.0]])
    image = 600.0 + np.kron(contrasts, np.pad(SQUARES - 1.0, 15)) / 2.0
    assert len(find_crossings(image, window=21, noise=lm.Noise(read=2.0))) == count


def test_strips_of_an_image_find_what_the_whole_image_does(monkeypatch):
    sky, y = np.full((2, 230, 40), 30.0), np.arange(230)[:, None]
    for row in (30, 63, 96, 131, 200):  # at the borders of strips of 32 rows, and between them
        sky += 900.0 * np.exp(-((y - row) ** 2 + (np.arange(40) - 20) ** 2) / 6.0)
    maps = lm.Noise(read=np.linspace(2.0, 4.0, 230 * 40).reshape(230, 40), offset=100.0)
    images = np.ma.masked_array(maps.record(sky, seed=1), False)
    images[0, 150:190] = np.ma.masked  # wider than the Gaussian that fills it
    whole = find_spots(images, noise=maps, window=11)
    monkeypatch.setattr("lommel.detection.targets._STRIP", 32)
    strips = find_spots(images, noise=maps, window=11)
    assert len(whole) == 5
    for name in ("centers", "score", "flux"):
        np.testing.assert_allclose(getattr(whole, name), getattr(strips, name), rtol=1e-12)
