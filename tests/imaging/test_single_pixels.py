"""Single pixels in every renderer: their light, and their spots, against the PSF of each point by itself.

Photographs over a field are in `field/test_field_photograph.py`.
"""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import DepthBlur, FieldBlur, FocusPlan, LensRanges, Occlusion, depth_of_field, traced_blur

LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
PIXEL, SHAPE, HALF = 8e-6, (72, 96), 11
DEPTH = np.broadcast_to(np.linspace(1.92, 2.16, SHAPE[1]), SHAPE)  # a slanted wall, in focus and out of it
IMAGE = np.zeros(SHAPE, np.float32)
IMAGE[12::24, 12::24] = np.linspace(0.2, 1.0, 12).reshape(3, 4)
FIELD = lm.FieldMap.from_seidel(2e-3, W131=6.0, W222=4.0, wavelength=540e-9, f_number=2.8)


def photograph(points=1, **given):
    """Return the photograph of a scene that is `points` times as fine, with all the light of each pixel."""
    image, depth = (np.kron(part, np.ones((points, points))) for part in (IMAGE, DEPTH))
    return depth_of_field(image, depth, LENS, PIXEL, encoding="linear", **given).values


def data_set(folder):
    lm.imaging.write_photo(folder / "photo.png", IMAGE, dtype=np.uint16)
    lm.imaging.write_depth(folder / "depth.tif", DEPTH)
    ranges = LensRanges(focal_length=50e-3, f_number=4.0, focus_distance=2.0, pixel=PIXEL, wavelength=550e-9)
    files = [[folder / name] for name in ("photo.png", "depth.tif")]
    return lm.imaging.read_photo(
        next(lm.imaging.render_dataset(*files, folder / "set", ranges, seed=1)).files[0]
    ).light()


RENDERERS = {
    "depth": lambda _: DepthBlur(DEPTH, LENS, PIXEL).forward(IMAGE),
    "occlusion": lambda _: Occlusion(DepthBlur(DEPTH, LENS, PIXEL)).forward(IMAGE),
    "photograph": lambda _: photograph(),
    "tiles": lambda _: photograph(tile=32),
    "supersample": lambda _: photograph(2, supersample=2),
    "plan": lambda _: FocusPlan(IMAGE, DEPTH, LENS, PIXEL, encoding="linear")().values,
    "traced": lambda _: traced_blur(LENS, [1.9, 2.2], PIXEL)(IMAGE, DEPTH),
    "traced, occlusion": lambda _: traced_blur(LENS, [1.9, 2.2], PIXEL)(IMAGE, DEPTH, occlusion=True),
    "data set": data_set,
    "field": lambda _: FieldBlur(FIELD, SHAPE, 4e-6, center=(-200.0, -150.0), energy=0.98).forward(IMAGE),
}


@pytest.mark.parametrize("name", RENDERERS)
def test_single_pixels_keep_their_light_and_have_the_psf_of_their_distance_or_place(name, tmp_path):
    found = RENDERERS[name](tmp_path).astype(np.float64)
    points = [-0.25, 0.25] if name == "supersample" else [0.0]
    for row, column in np.argwhere(IMAGE):
        pupil, pixel = LENS.pupil(DEPTH[row, column]), PIXEL
        if name == "field":
            pupil, pixel = FIELD.pupil((column + 150.0) * 4e-6, (row + 200.0) * 4e-6), 4e-6
        places = [(HALF + i, HALF + j) for i in points for j in points]
        true = np.mean(
            [lm.psf(pupil, 2 * HALF + 1, pixel, center=place, tol=1e-7).values for place in places], axis=0
        )
        spot = found[row - HALF : row + HALF + 1, column - HALF : column + HALF + 1] / IMAGE[row, column]
        assert spot.sum() == pytest.approx(1.0, abs=0.002)
        # Windows hold 98 % of the light, and are divided by what they hold.
        assert (inside := true[spot > 1e-6].sum()) > 0.975
        assert np.abs(spot * inside - true).max() < 0.006 * true.max()


def passing(mask, lens, near, far, row, column):
    """Return the part of the aperture that sees a point of the far plane, by rays through points of the aperture."""
    side = (np.arange(160) + 0.5) / 80 - 1
    y, x = (0.5 * lens.aperture_diameter * part for part in np.meshgrid(side, side, indexing="ij"))
    inside = np.hypot(y, x) < 0.5 * lens.aperture_diameter
    scale = (
        lens.sensor_distance / PIXEL
    )  # an object at X in the distance z is imaged -scale X / z pixels from the axis
    crossing = []
    for place, height in ((row, y), (column, x)):
        point = -place * far / scale
        crossing.append(np.rint(-scale / near * (point + (height - point) * (far - near) / far)).astype(int)[inside])
    return 1.0 - mask[tuple(np.clip(at, 0, side - 1) for at, side in zip(crossing, mask.shape, strict=True))].mean()


FRONTS = {
    "edge": lambda y, x: x < 48,
    "corner": lambda y, x: (x < 44) & (y > 30),
    "pole": lambda y, x: (x > 44) & (x < 49),
    "disc": lambda y, x: np.hypot(y - 36, x - 44) < 8,
}


@pytest.mark.parametrize("front", FRONTS)
@pytest.mark.parametrize("focus", [2.5, 6.0], ids="focus at {} m".format)
def test_points_of_light_beside_edges_have_the_light_that_passes_the_front(front, focus):
    lens, near, far = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=focus, wavelength=550e-9), 2.0, 3.0
    mask = FRONTS[front](*np.indices(SHAPE))
    depth, scene = np.where(mask, near, far), np.where(mask, 0.3, 0.05).astype(np.float32)
    without, kept = depth_of_field(scene, depth, lens, PIXEL, encoding="linear").values, []
    for column in (49, 50, 52, 55):  # of far points, 1 to 11 pixels from the edge
        scene[29, column] += 0.6
        image = depth_of_field(scene, depth, lens, PIXEL, encoding="linear").values
        scene[29, column] -= 0.6
        kept.append((image.astype(np.float64).sum() - without.sum(dtype=np.float64)) / 0.6)
    true = [passing(mask, lens, near, far, 29, column) for column in (49, 50, 52, 55)]
    np.testing.assert_allclose(kept, true, atol=0.005)


def test_points_of_light_beside_edges_are_the_same_in_tiles():
    draw = np.random.default_rng(2)
    depth = np.where(FRONTS["corner"](*np.indices(SHAPE)), 2.0, 3.0)
    scene = np.where(draw.random(SHAPE) < 0.01, 1.0, 0.1).astype(np.float32)
    tiles, whole = (depth_of_field(scene, depth, LENS, PIXEL, encoding="linear", tile=n).values for n in (32, None))
    np.testing.assert_allclose(tiles, whole, atol=1e-6)
