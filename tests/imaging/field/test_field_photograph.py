"""Photographs through a field map: against sums of the PSFs of the map, tilts and all."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.field.maps import Foreshortening, Shading, Vignetting
from lommel.imaging import field_photograph
from lommel.imaging.photograph import points_of_light, positive, undistorted_positions

N, PIXEL, HEIGHT, WIDTH = 4.0, 1e-6, 60, 90  # pixels that resolve the PSF, so that sums over them are integrals
EDGE = 0.5 * PIXEL * np.hypot(HEIGHT, WIDTH) * 1.4
LATERAL = (-3e-6, 0.0, 4e-6)  # of red, green, blue at the edge of the map
COLOUR = lm.Colour([460e-9, 540e-9, 600e-9], lateral=LATERAL[::-1], heights=EDGE)
# Distortion of 16 pixels at the edge of the map, and lateral colour of 4 and 3.
LENS = lm.Lens(focal_length=8e-3, f_number=N, focus_distance=np.inf, wavelength=540e-9, colour=COLOUR)
WAVES = {"W131": 0.8, "W222": 0.5, "W311": -16 * PIXEL / (2 * 540e-9 * N)}
BENT = lm.FieldMap.from_seidel(EDGE, W311=WAVES["W311"], aperture=LENS.pupil(np.inf).unaberrated())
FIELD = lm.FieldMap.from_seidel(EDGE, **WAVES, aperture=LENS.pupil(np.inf).unaberrated())
CHANNELS = (600e-9, 540e-9, 460e-9)
SPOTS = [(29.0, 45.0), (14.0, 12.0), (46.0, 76.0)]


def coordinates(rows: np.ndarray, columns: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return x and y in the field of rows and columns."""
    return PIXEL * (columns - (WIDTH - 1) / 2), PIXEL * (rows - (HEIGHT - 1) / 2)


def spots(sigma: float = 2.0) -> np.ndarray:
    """Return Gaussian spots all over the picture, smooth enough for their sum over pixels to be an integral."""
    rows, columns = np.indices((HEIGHT, WIDTH))
    one = [np.exp(-0.5 * ((rows - r) ** 2 + (columns - c) ** 2) / sigma**2) for r, c in SPOTS]
    return np.repeat(np.sum(one, axis=0)[..., None], 3, axis=2)


def summed(image: np.ndarray, field: lm.FieldMap, wavelength: float, half: int = 30) -> np.ndarray:
    """Return the sum of the PSFs of all points, with their tilts in the windows."""
    total = np.zeros((HEIGHT + 2 * half, WIDTH + 2 * half))
    rows, columns = np.nonzero(image > 1e-6)
    x, y = coordinates(rows, columns)
    pupil = field.pupil(x, y).in_light(wavelength)
    windows = lm.psf(pupil, 2 * half + 1, PIXEL, integrate=True, tol=1e-6, dtype=np.float64).values
    for row, column, window in zip(rows, columns, windows, strict=True):
        total[row : row + 2 * half + 1, column : column + 2 * half + 1] += image[row, column] * window
    return total[half:-half, half:-half]


def stretch(field: lm.FieldMap, wavelength: float) -> np.ndarray:
    """Return how much larger the picture of an area of the scene is, at each pixel of the scene."""
    x, y = coordinates(*np.indices((HEIGHT, WIDTH)))
    dx, dy = field.displacement(x, y, wavelength)
    (xr, xc), (yr, yc) = np.gradient(x + dx, PIXEL), np.gradient(y + dy, PIXEL)
    return xc * yr - xr * yc


def test_spots_are_those_of_the_sum_of_all_psfs_in_every_colour():
    """Only the 2 % of the light that windows lack, and the spline, may differ."""
    image = spots()
    made = field_photograph(image, FIELD, PIXEL, encoding="linear")
    assert made.values.shape == image.shape
    for k, wavelength in enumerate(CHANNELS):
        # The sum conserves the light of points, the photograph the brightness of surfaces.
        true = summed(image[..., k] * stretch(FIELD, wavelength), FIELD, wavelength)
        assert np.abs(made.values[..., k] - true).max() < (made.error + 2.0 * made.lost) * image.max()
        for row, column in SPOTS:
            near = around(*landing(FIELD, row, column, wavelength))
            found, wanted = made.values[near][..., k], true[near]
            share = found.sum() / wanted.sum()
            assert 1.0 < share < 1.03
            assert np.abs(found / share - wanted).max() < 5e-3 * wanted.max()


def test_distortion_and_lateral_colour_move_spots_by_as_much_as_formulas_say():
    """Third-order distortion moves light by 2 N lambda W311 H^3, the lateral colour of this table by H times it."""
    made = field_photograph(spots(), BENT, PIXEL, encoding="linear").values.astype(float)
    for row, column in SPOTS:
        x, y = coordinates(row, column)
        h = np.hypot(x, y) / EDGE
        for k, lateral in enumerate(LATERAL):
            outwards = (-16 * PIXEL * h**3 + lateral * h) / PIXEL / np.hypot(x, y)
            to = np.array([row + outwards * y, column + outwards * x])
            near = around(*to)
            light = made[near][..., k]
            rows, columns = np.indices(made.shape[:2])
            found = [(part[near] * light).sum() / light.sum() for part in (rows, columns)]
            # The stretch changes over a spot, which moves its centroid by sigma^2 times its relative slope.
            np.testing.assert_allclose(found, to, atol=0.15)
            moved = outwards * np.hypot(x, y)
            assert abs(moved) < 0.3 or np.hypot(*(np.array(found) - [row, column])) > 0.5 * abs(moved)


def landing(field: lm.FieldMap, row: float, column: float, wavelength: float) -> np.ndarray:
    """Return the row and column where the light of a row and column arrives."""
    dx, dy = field.displacement(*coordinates(row, column), wavelength)
    return np.array([row + float(dy) / PIXEL, column + float(dx) / PIXEL])


def around(row: float, column: float) -> tuple[slice, slice]:
    """Return a window around a spot."""
    first = [max(0, round(part) - 8) for part in (row, column)]
    return slice(first[0], round(row) + 9), slice(first[1], round(column) + 9)


def test_a_map_without_tilts_gives_the_blur_of_the_field_and_its_shading():
    field = lm.FieldMap.from_seidel(EDGE, W222=0.4, W040=0.2, wavelength=550e-9, f_number=N)
    image = np.random.default_rng(0).random((40, 50), dtype=np.float32)
    blur = lm.imaging.FieldBlur(field, image.shape, PIXEL, channels=[550e-9], energy=0.9)
    lit = field.seen_through(None, Shading([0.0, EDGE], [1.0, 0.5]))
    for one in (field, lit):
        made = field_photograph(image, one, PIXEL, encoding="linear", energy=0.9)
        light = one.illumination(blur.x, blur.y[:, None])
        np.testing.assert_allclose(made.values, blur.forward(image) * light, rtol=1e-5)
        assert (made.lost, made.error, made.window) == (blur.lost, blur.error, blur.window(0, 0).shape[0])


def test_a_white_wall_stays_white_and_bytes_stay_bytes():
    white = np.full((70, 80, 3), 255, np.uint8)
    made = field_photograph(white, BENT, PIXEL, encoding="srgb", energy=0.9)
    assert made.values.dtype == np.uint8
    np.testing.assert_array_equal(made.values, white)


def drawn(image: np.ndarray, field: lm.FieldMap, pixel: float, sensor: tuple[float, float]) -> tuple[np.ndarray, ...]:
    """Return the sum of the PSFs of all points, moved by the tilts of the map, and the place and area of each.

    Tilts are left in the wavefront; the axis of each window is moved the other way, so that the window is small. The
    light is that of the area onto which the map stretches a pixel.
    """
    half, pitch, places = 12, np.array(sensor) / image.shape, np.argwhere(image)
    at = pitch * (places - 0.5 * (np.array(image.shape) - 1))

    def moved(step: np.ndarray) -> np.ndarray:
        return np.stack(field.displacement(*(at + pitch * step).T[::-1])[::-1], axis=1) + pitch * step

    (a, b), (c, d) = ((moved(step) - moved(-step)).T / 0.02 / pitch[:, None] for step in 0.01 * np.eye(2))
    to = places + moved(np.zeros(2)) / pitch
    corner = np.rint(to).astype(int)
    centre = tuple((half + to - corner - moved(np.zeros(2)) / pixel).T)
    windows = lm.psf(field.pupil(*at.T[::-1]), 25, pixel, center=centre, tol=1e-7, dtype=np.float64).values
    total = np.zeros([side + 2 * half for side in image.shape])
    for (row, column), light, window in zip(corner, (a * d - b * c) * image[image > 0], windows, strict=True):
        total[row : row + 25, column : column + 25] += light * window
    return total[half:-half, half:-half], corner, a * d - b * c


NARROW = lm.FieldMap.from_seidel(32e-3, W311=-1500.0, W131=1.5, W222=1.0, wavelength=540e-9, f_number=2.8)
COMATIC = lm.FieldMap.from_seidel(2e-3, W131=6.0, W222=4.0, wavelength=540e-9, f_number=2.8)
FIELDS = pytest.mark.parametrize(("field", "sensor"), [(NARROW, (24e-3, 36e-3)), (COMATIC, (2e-3, 3e-3))])


@FIELDS
@pytest.mark.parametrize("background", [0.0, 0.3])
def test_single_pixels_keep_their_light_and_their_spots_wherever_the_map_moves_them(field, sensor, background):
    image = np.zeros((80, 120))
    image[::15, ::15] = 1.0
    image[30, 46], image[46, 62] = 0.5, 0.2  # neighbours of other points
    sky = np.full_like(image, background)
    made = field_photograph(image + sky, field, 6e-6, encoding="linear", sensor=sensor, energy=0.97)
    values = np.asarray(made.values, np.float64)
    if background:
        values -= field_photograph(sky, field, 6e-6, encoding="linear", sensor=sensor, energy=0.97).values
    true, places, _ = drawn(image, field, 6e-6, sensor)
    for row, column in places:
        if 6 <= row < 74 and 6 <= column < 114:
            near = slice(row - 6, row + 7), slice(column - 6, column + 7)
            assert values[near].sum() == pytest.approx(true[near].sum(), rel=0.008)
            assert np.abs(values[near] - true[near]).max() < 0.012 * true[near].max()


@pytest.mark.parametrize("group", [np.ones((9, 9)), np.ones((1, 7)), np.eye(6), np.indices((8, 8)).sum(axis=0) % 2])
def test_light_of_sharp_groups_of_pixels_is_kept_and_nowhere_negative(group):
    image, (height, width) = np.zeros((80, 120)), group.shape
    for row, column in np.ndindex(3, 5):
        image[15 + 20 * row :, 15 + 20 * column :][:height, :width] = group
    made = field_photograph(image, NARROW, 6e-6, encoding="linear", sensor=(24e-3, 36e-3), energy=0.9)
    assert made.values.min() >= 0.0
    assert made.values.sum() == pytest.approx(drawn(image, NARROW, 6e-6, (24e-3, 36e-3))[2].sum(), rel=2e-3)


@pytest.mark.parametrize("distortion", [-900.0, 900.0])
def test_points_at_the_edge_are_not_mirrored_and_light_that_arrives_outside_is_lost(distortion):
    field = lm.FieldMap.from_seidel(30e-3, W311=distortion, wavelength=540e-9, f_number=2.8)
    image = np.zeros((80, 120))
    image[0, 30], image[-1, -1] = 1.0, 0.5
    made = field_photograph(image, field, 6e-6, encoding="linear", sensor=(24e-3, 36e-3), energy=0.9)
    light = drawn(image, field, 6e-6, (24e-3, 36e-3))[2] @ [1.0, 0.5] if distortion < 0.0 else 0.0
    assert made.values.sum() == pytest.approx(light, rel=2e-3)


@pytest.mark.parametrize("shape", [(9, 11), (30, 40, 3)])
def test_negative_light_is_taken_from_around_it(shape):
    light = np.random.default_rng(0).uniform(-0.2, 1.0, shape)
    made = positive(light)
    assert made.min() >= 0.0
    np.testing.assert_allclose(made.sum(axis=(0, 1)), light.sum(axis=(0, 1)), rtol=1e-12)
    far = np.zeros((20, 20))
    far[4, 4], far[4, 5], far[15, 15] = 1.0, -0.25, 2.0
    np.testing.assert_allclose(positive(far)[[4, 4, 15], [4, 5, 15]], [0.75, 0.0, 2.0])


def test_points_are_isolated_bright_pixels_and_nothing_smooth():
    draw = np.random.default_rng(0)
    image = np.full((60, 60), 0.2) + draw.normal(0.0, 0.002, (60, 60))
    places = [(0, 0), (59, 30), (20, 20), (40, 20), (40, 21), (20, 41), (22, 40), (21, 42)]
    image[tuple(np.transpose(places))] += 0.5
    found = points_of_light(image, 100)
    assert sorted(map(tuple, np.argwhere(found))) == sorted(places)
    assert np.abs(found[found > 0] - 0.5).max() < 0.012
    image[20, 20] += 0.1
    assert list(map(tuple, np.argwhere(points_of_light(image, 1)))) == [(20, 20)]
    rows, columns = np.indices((60, 60))
    gaussian, edge = np.exp(-0.5 * ((rows - 30.3) ** 2 + (columns - 29.6) ** 2)), 1.0 * (rows > columns)
    line = (rows == 20) * (columns > 2) * (columns < 57) + 0.1 * (rows == 20)
    for smooth in (gaussian, edge, (rows > 20) * (columns > 20) * 1.0, draw.random((60, 60)), line):
        assert np.count_nonzero(points_of_light(smooth, 100)) <= 2


def test_places_between_nodes_are_those_of_the_map():
    """The picture is that of a scene which is its own position, where nothing blurs it."""
    shape = (70, 80)
    y, x = (PIXEL * (np.arange(n) - 0.5 * (n - 1)) for n in shape)
    found = undistorted_positions(BENT, y, x, 460e-9, 1e-3 * PIXEL)
    np.testing.assert_allclose(found, BENT.undistorted(x, y[:, None], 460e-9)[::-1], atol=1e-3 * PIXEL)


def test_bad_questions_are_refused():
    image = np.zeros((20, 30))
    vignetted = BENT.seen_through(Vignetting([0.0, EDGE], shift=[0.0, 0.5], radius=1.0))
    with pytest.raises(ValueError, match="must have no vignetting"):
        field_photograph(image, vignetted, PIXEL, encoding="linear")
    ellipses = BENT.seen_through(Foreshortening([0.0, 2.0 * EDGE], [1.0, 0.8], [1.0, 0.9]))
    for ask in (field_photograph, lambda image, field, pixel, **_: lm.imaging.FieldBlur(field, image.shape, pixel)):
        with pytest.raises(ValueError, match="make the map with circular=True"):
            ask(image, ellipses, PIXEL, encoding="linear")
    with pytest.raises(ValueError, match=r"must be that of the map, field_map\.vignetting"):
        ellipses.seen_through(None)
    assert ellipses.seen_through(ellipses.vignetting, Shading.cos4(EDGE)).shading is not None
    with pytest.raises(ValueError, match="must come from within the map"):
        field_photograph(np.zeros((120, 180)), BENT, PIXEL, encoding="linear")
    bare = lm.FieldMap.from_seidel(100.0, W131=0.5)
    assert field_photograph(image, bare, 0.5, encoding="linear", energy=0.9).values.shape == image.shape
