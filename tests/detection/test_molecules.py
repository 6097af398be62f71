"""Spots above the background: how many of them are noise, where boxes are, and what is left out."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
import simulated_movies as simulated
from lommel.detection.molecules import _density, _heights, _moments, smoothed
from lommel.localize import find


@pytest.mark.parametrize(
    ("background", "read"), [(0.2, 0.0), (1.0, 0.0), (1.0, 1.5), (5.0, 0.0), (50.0, 2.0), (1000.0, 0.0)]
)
def test_no_more_spots_are_noise_than_stated(background, read):
    draw = np.random.default_rng(3)
    frames = draw.poisson(background, (20, 192, 192)) + draw.normal(0.0, read, (20, 192, 192))
    for threshold in (3.0, 3.5, 4.0):
        found = find(frames, 9, noise=lm.Noise(read=read), threshold=threshold, width=1.5)
        stated = 20 * found.false_spots
        inside = 1.0 - (184 / 192) ** 2
        told = len(found) + found.borders + found.overlapping
        assert told < stated + 4.0 * np.sqrt(stated)
        assert found.borders < 2.0 * inside * stated + 5.0
        if background >= 50.0:  # and of many electrons not many fewer: the statement is no wild one
            assert told > 0.6 * stated - 3.0 * np.sqrt(stated)


def test_thresholds_hold_for_pixels_of_unlike_read_noise():
    draw = np.random.default_rng(5)
    read = np.where(draw.random((128, 128)) < 0.05, 12.0, 1.2)
    frames = draw.poisson(3.0, (20, 128, 128)) + draw.normal(0.0, 1.0, (20, 128, 128)) * read
    told = find(frames, noise=lm.Noise(read=read), threshold=4.0)
    blind = find(frames, noise=lm.Noise(read=1.2), threshold=4.0)
    assert len(told) + told.borders + told.overlapping < 20 * told.false_spots + 5.0 * np.sqrt(20 * told.false_spots)
    assert len(blind) > 10 * len(told) + 10


@pytest.mark.parametrize("weight", [0.0, 0.84])
def test_the_sums_of_the_kernel_are_those_of_every_pixel_also_at_edges(weight):
    pixels = np.eye(23 * 31).reshape(-1, 23, 31)
    wide = np.stack([smoothed(one, 3.0) for one in pixels])
    wider = np.stack([smoothed(one, 3.0) for one in wide])
    # The response of each pixel to each pixel.
    kernel = np.stack([smoothed(one, 1.2) for one in pixels]) - (1.0 + weight) * wide + weight * wider
    squares, cubes = _moments(23, 31, 1.2, 3.0, weight)
    np.testing.assert_allclose(squares, (kernel**2).sum(axis=0), rtol=1e-12)
    np.testing.assert_allclose(cubes, (kernel**3).sum(axis=0), rtol=1e-10)


@pytest.mark.parametrize("width", [9.0, 13.0, 18.0])
def test_a_smooth_hump_of_background_has_no_spots(width):
    """A hump of 8 to 48 electrons, where a flat background on either side of spots finds 0.6 spots a frame."""
    row, column = np.mgrid[:64, :64]
    mean = 8.0 + 40.0 * np.exp(-((row - 29.0) ** 2 + (column - 38.0) ** 2) / (2.0 * width**2))
    assert len(find(np.random.default_rng(4).poisson(mean, (60, 64, 64)))) == 0


def test_a_bead_that_stays_is_found_in_every_frame():
    row, column = np.mgrid[:64, :64]
    bead = 2e3 * np.exp(-((row - 29.0) ** 2 + (column - 38.0) ** 2) / 8.0) / (8.0 * np.pi)
    found = find(np.random.default_rng(4).poisson(8.0 + bead, (12, 64, 64)))
    assert (found.row.tolist(), found.column.tolist()) == ([22] * 12, [31] * 12)


def test_heights_are_standard_deviations_where_there_are_many_electrons():
    draw = np.random.default_rng(6)
    frames = draw.poisson(400.0, (10, 128, 128)).astype(float) + draw.normal(0.0, 5.0, (10, 128, 128))
    background = np.stack([smoothed(one, 5.0) for one in frames])
    excess = np.stack([smoothed(one, 1.5) for one in frames]) - background
    heights = _heights(excess, background + 25.0, *_moments(128, 128, 1.5, 5.0))
    above = heights[heights > 0.0]
    assert np.sqrt((above**2).mean()) == pytest.approx(1.0, abs=0.03)
    assert above.size == pytest.approx(heights.size / 2, rel=0.03)


def test_the_density_of_maxima_is_that_of_asmoothed_normal_field():
    # Of one Gaussian the correlation is exp(-r^2 / (4 s^2)), whose curvature is 1 / (2 s^2).
    expected = 4.5 * np.exp(-(4.5**2) / 2.0) / (2.0 * np.pi) ** 1.5 / (2.0 * 1.5**2)
    assert _density(4.5, 1.5, 1e4) == pytest.approx(expected, rel=1e-6)


def test_every_molecule_is_found_in_the_middle_of_its_box():
    molecules = simulated.spread(8, 112, each=6, apart=20, seed=7)
    noise = lm.Noise(white=0.46, read=1.6, offset=100.0)
    counts = simulated.recorded(simulated.light(molecules, 8, 112, 8.0), noise, 8)
    found = find(counts, 15, noise=noise, first=100)
    assert found.borders == 0
    assert found.overlapping < 10  # parts of the longest images
    assert len(found) == molecules.frame.size
    assert set(found.frame) == set(range(100, 108))
    assert np.all(np.diff(found.frame) >= 0)
    off = np.abs(found.row[:, None] + 7 - molecules.row) + np.abs(found.column[:, None] + 7 - molecules.column)
    off[found.frame[:, None] - 100 != molecules.frame] = np.inf
    assert sorted(off.argmin(axis=1)) == list(range(molecules.frame.size))
    assert off.min(axis=1).max() < 3.5
    for k in (0, 17, 40):
        down, across = slice(found.row[k], found.row[k] + 15), slice(found.column[k], found.column[k] + 15)
        np.testing.assert_array_equal(found.images[k], counts[found.frame[k] - 100][down, across])
        np.testing.assert_array_equal(found.corners[k], (found.row[k], found.column[k]))
    assert found.images.dtype == np.uint16
    left = f"0 at borders and {found.overlapping} overlapping left out"
    assert repr(found) == f"<Spots: 48 in boxes of 15 x 15; {left}>"


@pytest.mark.parametrize("value", [0, 65535])
def test_molecules_beside_defects_are_found_and_fitted_as_without_them(value):
    """One in the image of a molecule and a cluster beside others, told by the map of the read noise."""
    molecules = simulated.spread(4, 64, each=4, apart=20, seed=3)
    counts = simulated.recorded(
        simulated.light(molecules, 4, 64, 8.0), lm.Noise(white=0.46, read=1.6, offset=100.0), 4
    )
    read = np.full((64, 64), 1.6)
    at = np.round([molecules.row[0], molecules.column[0]]).astype(int)
    read[at[0] + 1, at[1] - 1] = read[30:33, 30:33] = 1e3
    noise = lm.Noise(white=0.46, read=read, offset=100.0)
    whole, broken = find(counts, noise=noise), np.where(read < 1e3, counts, value).astype(np.uint16)
    found = find(broken, noise=noise)
    for name in ("frame", "row", "column", "score"):
        np.testing.assert_array_equal(getattr(found, name), getattr(whole, name))
    assert len(found) == molecules.frame.size
    table = lm.localize.Table(simulated.pupil(), shape=15, pixel=6.5e-6, z=(-0.7e-6, 0.7e-6), reach=3.0)
    fits = [lm.localize.fit(table, one.images, noise=noise, corners=one.corners) for one in (whole, found)]
    np.testing.assert_array_equal(fits[0].z, fits[1].z)
    assert np.abs(fits[1].discrepancy).max() < 5.0
    with pytest.raises(ValueError, match="read must be below 1000 electrons for pixels that are not defects"):
        find(broken, noise=lm.Noise(read=np.full((64, 64), 1e3)))


def test_maps_of_the_camera_are_used():
    draw = np.random.default_rng(9)
    shape = (40, 50)
    noise = lm.Noise(
        white=draw.uniform(0.4, 0.6, shape), read=draw.uniform(1.0, 3.0, shape), offset=draw.uniform(60, 140, shape)
    )
    mean = np.full(shape, 4.0)
    mean[18:21, 22:25] += 100.0
    found = find(noise.record(mean, 1), (11, 9), noise=noise)
    assert (len(found), found.images.shape) == (1, (1, 11, 9))
    down, across = slice(found.row[0], found.row[0] + 11), slice(found.column[0], found.column[0] + 9)
    assert (found.row[0] + 5, found.column[0] + 4) == (19, 23)
    whole = np.zeros(shape)
    whole[down, across] = found.images[0]
    assert noise.electrons(whole)[down, across].sum() == pytest.approx(mean[down, across].sum(), rel=0.1)
    blind = find(noise.record(mean, 1), (11, 9), noise=lm.Noise(white=0.5, read=2.0, offset=100.0))
    assert len(blind) + blind.overlapping + blind.borders > 5


def spots(*places: tuple[int, int, float], shape: tuple[int, int] = (60, 80)) -> np.ndarray:
    """A frame with squares of light around places, of some height above 2."""
    frame = np.full(shape, 2.0)
    for row, column, height in places:
        frame[row - 1 : row + 2, column - 1 : column + 2] += height
    return frame


@pytest.mark.parametrize(("apart", "beside"), [(14, True), (15, False)])
@pytest.mark.parametrize("along", ["rows", "columns"])
def test_of_boxes_that_overlap_the_brighter_is_kept(apart, beside, along):
    step = (apart, 0) if along == "rows" else (0, apart)
    frame = spots((20, 30, 50.0), (20 + step[0], 30 + step[1], 80.0))
    kept = find(frame)
    assert (len(kept), kept.overlapping) == ((1, 1) if beside else (2, 0))
    assert (kept.row[-1] + 7, kept.column[-1] + 7) == (20 + step[0], 30 + step[1])


def test_a_spot_beside_one_that_is_left_out_is_kept():
    frame = spots((30, 20, 80.0), (30, 32, 50.0), (30, 44, 30.0))
    found = find(frame)
    assert found.overlapping == 1
    assert list(found.column + 7) == [20, 44]


def test_spots_of_other_frames_do_not_overlap():
    frames = np.stack([spots((30, 30, 50.0)), spots((30, 32, 50.0)), spots((31, 31, 50.0))])
    found = find(frames)
    assert (list(found.frame), list(found.column + 7), found.overlapping) == ([0, 1, 2], [30, 32, 31], 0)


@pytest.mark.parametrize(
    ("place", "inside"),
    [
        ((7, 40), 1),
        ((6, 40), 0),
        ((52, 40), 1),
        ((53, 40), 0),
        ((30, 7), 1),
        ((30, 6), 0),
        ((30, 72), 1),
        ((30, 73), 0),
    ],
)
def test_boxes_beyond_the_frame_are_left_out_and_counted(place, inside):
    found = find(spots((*place, 60.0)))
    assert (len(found), found.borders) == ((1, 0) if inside else (0, 1))


def test_boxes_of_even_sides_have_their_centre_where_windows_have_it():
    found = find(spots((30, 40, 60.0)), (14, 12))
    assert (found.row[0] + 7, found.column[0] + 6) == (30, 40)
    assert found.images.shape == (1, 14, 12)
    assert np.unravel_index(found.images[0].argmax(), (14, 12)) in {(a, b) for a in (6, 7, 8) for b in (5, 6, 7)}


def test_empty_movies_and_dark_frames_have_no_spots():
    assert len(find(np.zeros((0, 20, 20)))) == 0
    found = find(np.zeros((2, 20, 20)))
    assert (len(found), found.images.shape, found.corners.shape) == (0, (0, 15, 15), (0, 2))
    assert len(find(np.full((2, 20, 20), -3.0), noise=lm.Noise(read=1.0))) == 0


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"noise": lm.Noise(read=np.ones((5, 5)))}, r"read, of shape \(5, 5\), must have a value for each pixel"),
        ({"noise": lm.Noise(read=1.0, offset=np.ones((5, 5)))}, r"offset, of shape \(5, 5\), must have a value"),
    ],
)  # fmt: skip
def test_bad_arguments_are_told(changes, message):
    with pytest.raises((TypeError, ValueError), match=message):
        find(**({"frames": np.zeros((20, 20))} | changes))


@pytest.mark.parametrize(("shape", "sigma"), [((70, 33), 2.0), ((5, 101), 8.3), ((64, 32), 0.7)])
def test_smoothing_in_single_precision_is_that_in_double_precision(shape, sigma):
    light = np.random.default_rng(4).poisson(200.0, shape).astype(np.float64)
    np.testing.assert_allclose(smoothed(light.astype(np.float32), sigma), smoothed(light, sigma), rtol=2e-6)
