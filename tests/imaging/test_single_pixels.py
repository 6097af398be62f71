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


def tiled(image, depth):
    return depth_of_field(image, depth, LENS, PIXEL, encoding="linear", tile=32).values


def supersampled(image, depth):
    """Return the photograph of scenes with four points in each pixel, all of the light of the pixel."""
    fine, walls = np.kron(image, np.ones((2, 2))), np.kron(depth, np.ones((2, 2)))
    return depth_of_field(fine, walls, LENS, PIXEL, encoding="linear", supersample=2).values


def data_set(folder, image, depth):
    lm.imaging.write_photo(folder / "photo.png", image, dtype=np.uint16)
    lm.imaging.write_depth(folder / "depth.tif", depth)
    lenses = LensRanges(focal_length=50e-3, f_number=4.0, focus_distance=2.0, pixel=PIXEL, wavelength=550e-9)
    (made,) = lm.imaging.render_dataset(
        [folder / "photo.png"], [folder / "depth.tif"], folder / "set", lenses, seed=1
    )
    return lm.imaging.read_photo(made.files[0]).light()


RENDERERS = {
    "DepthBlur": lambda image, depth: DepthBlur(depth, LENS, PIXEL).forward(image),
    "Occlusion": lambda image, depth: Occlusion(DepthBlur(depth, LENS, PIXEL)).forward(image),
    "depth_of_field": lambda image, depth: depth_of_field(image, depth, LENS, PIXEL, encoding="linear").values,
    "tiles": tiled,
    "supersample": supersampled,
    "FocusPlan": lambda image, depth: FocusPlan(image, depth, LENS, PIXEL, encoding="linear")().values,
    "TracedBlur": lambda image, depth: traced_blur(LENS, [1.9, 2.2], PIXEL)(image, depth, check=True),
    "TracedBlur, occlusion": lambda *scene: traced_blur(LENS, [1.9, 2.2], PIXEL)(*scene, occlusion=True),
}


def worst(found, spot):
    """Return the largest errors of the light and, relative to its peak, of the spots of all points."""
    light, off = [], []
    for row, column in np.argwhere(IMAGE):
        near = slice(row - HALF, row + HALF + 1), slice(column - HALF, column + HALF + 1)
        one, true = np.asarray(found[near], np.float64) / IMAGE[row, column], spot(row, column)
        light.append(abs(one.sum() - 1.0))
        # Windows hold a part of the light, stated as `lost`, and are divided by it.
        inside = true[one > 1e-6].sum()
        off.append(np.abs(one * inside - true).max() / true.max())
        assert inside > 0.975
    return max(light), max(off)


@pytest.mark.parametrize("name", [*RENDERERS, "data set"])
def test_single_pixels_keep_their_light_and_have_the_psf_of_their_distance(name, tmp_path):
    found = data_set(tmp_path, IMAGE, DEPTH) if name == "data set" else RENDERERS[name](IMAGE, DEPTH)
    points = 0.25 * np.array([-1, 1]) if name == "supersample" else [0.0]

    def spot(row, column):
        pupil, places = LENS.pupil(DEPTH[row, column]), [(HALF + i, HALF + j) for i in points for j in points]
        return np.mean(
            [lm.psf(pupil, 2 * HALF + 1, PIXEL, center=place, tol=1e-7).values for place in places], axis=0
        )

    light, off = worst(found, spot)
    assert light < 0.005
    assert off < 0.01


def test_single_pixels_keep_their_light_and_have_the_psf_of_their_place_in_the_field():
    pixel = 4e-6
    blur = FieldBlur(FIELD, SHAPE, pixel, center=(-200.0, -150.0), energy=0.98, largest=60)

    def spot(row, column):
        x, y = (column + 150.0) * pixel, (row + 200.0) * pixel
        return FIELD.psf(x, y, 2 * HALF + 1, pixel, integrate=True, tol=1e-7).values

    light, off = worst(blur.forward(IMAGE), spot)
    assert light < 0.005
    assert off < 0.01
