"""Depth of field: photographs, and notes of depth that cannot be meant."""

from __future__ import annotations

import warnings
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from scipy.signal import fftconvolve

import lommel as lm
from lommel import imaging
from lommel.imaging import RED_GREEN_BLUE, DepthBlur, FocusPlan, depth_of_field
from lommel.imaging.occlusion import Occlusion
from lommel.io.depth_maps import fill_missing

LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
PIXEL = 8e-6
SCENE = np.random.default_rng(0).random((50, 60))


def window(lens: lm.Lens, distance: float, blur: DepthBlur) -> np.ndarray:
    """The PSF of one distance through the front door, cut and divided as the bank does."""
    bank = blur.banks[0]
    answer = lm.psf(
        lens.pupil(distance),
        2 * bank.half + 1,
        PIXEL,
        integrate=True,
        method=lm.methods.NijboerZernike(1e-9),
        dtype=np.float64,
    )
    used = bank.pixel_weights(lens.defocus(distance)) * answer.values
    return np.asarray(used / used.sum())


@pytest.mark.parametrize("occlusion", [False, True])
@pytest.mark.parametrize("distance", [1.7, 2.0, 3.1, np.inf])
def test_a_plane_is_convolved_with_its_psf(distance, occlusion):
    depth = np.full(SCENE.shape, distance)
    blur = DepthBlur(depth, LENS, PIXEL, tol=1e-6, dtype=np.float64)
    kernel = window(LENS, distance, blur)
    exact = fftconvolve(np.pad(SCENE, len(kernel) // 2, mode="symmetric"), kernel, mode="valid")
    assert np.abs((Occlusion(blur) if occlusion else blur).forward(SCENE) - exact).max() <= 1e-6
    photograph = depth_of_field(SCENE, depth, LENS, PIXEL, encoding="linear", tol=1e-6)
    assert np.abs(photograph.values - exact).max() <= 2e-6


def test_light_is_held():
    rng = np.random.default_rng(1)
    image, depth = rng.random((60, 70)), rng.uniform(1.6, 2.8, (60, 70))
    blur = DepthBlur(depth, LENS, PIXEL, dtype=np.float64)
    assert blur.forward(image).sum() == pytest.approx(image.sum(), rel=1e-6)
    photograph = depth_of_field(image, depth, LENS, PIXEL, encoding="linear")
    assert photograph.window < 40
    assert (photograph.lost, photograph.error) == (blur.lost, blur.error)
    assert 0.0 < photograph.lost <= 0.02
    assert photograph.error <= 1e-4


def test_objects_at_infinity_are_the_limit_of_far_ones():
    depth = np.where(np.arange(60) < 30, 3.0, np.inf) * np.ones((50, 1))
    far = np.where(np.isinf(depth), 1e9, depth)
    a, b = (depth_of_field(SCENE, d, LENS, PIXEL, encoding="linear").values for d in (depth, far))
    assert np.abs(a - b).max() < 1e-6
    assert np.abs(a - SCENE).max() > 0.1


@pytest.mark.parametrize(
    ("kind", "step"), [(np.uint8, 1 / 255), (np.uint16, 1 / 65535), (np.float16, 1e-3), (np.float32, 1e-6)]
)
@pytest.mark.parametrize("encoding", ["srgb", "linear"])
def test_photographs_have_the_type_of_the_image(kind, step, encoding):
    most = np.iinfo(kind).max if np.dtype(kind).kind == "u" else 1.0
    image = (SCENE * most).astype(kind)
    depth = np.full(SCENE.shape, 1.8)
    told = []
    photograph = depth_of_field(image, depth, LENS, PIXEL, encoding=encoding, progress=lambda *at: told.append(at))
    values = photograph.values
    assert told[-1] == (SCENE.size, SCENE.size)
    silent = depth_of_field(image, depth, LENS, PIXEL, encoding=encoding)
    assert np.array_equal(silent.values, values)
    assert (photograph.photograph.encoding, photograph.photograph.values is values) == (encoding, True)
    assert np.array_equal(photograph, values)
    exact = depth_of_field(image.astype(float) / most, depth, LENS, PIXEL, encoding=encoding).values
    assert values.dtype == kind
    assert np.abs(values.astype(float) / most - exact).max() <= step


def test_in_focus_shorter_wavelengths_blur_less():
    point = np.zeros((41, 41, 3))
    point[20, 20] = 1.0
    slow = lm.Lens(focal_length=50e-3, f_number=22.0, focus_distance=2.0, wavelength=550e-9)
    values = depth_of_field(point, np.full((41, 41), 2.0), slow, 3e-6, encoding="linear", energy=0.9).values
    red, green, blue = values[20, 20]
    assert RED_GREEN_BLUE[0] > RED_GREEN_BLUE[1] > RED_GREEN_BLUE[2]
    assert red < green < blue
    # Peaks go with the inverse square of the wavelength, but for the pixel's size and the light beyond the windows.
    assert red / blue == pytest.approx((460 / 600) ** 2, rel=0.1)


def test_channels_are_those_of_their_wavelengths():
    colours = (480e-9, [(500e-9, 1.0), (640e-9, 3.0)])
    image, depth = np.stack([SCENE, SCENE[::-1]], axis=2), np.full(SCENE.shape, 1.8)
    both = Occlusion(DepthBlur(depth, LENS, PIXEL, channels=colours)).forward(image)
    for index, colour in enumerate(colours):
        one = Occlusion(DepthBlur(depth, LENS, PIXEL, channels=[colour])).forward(image[:, :, index])
        assert np.array_equal(both[:, :, index], one)
    rgb = np.stack([SCENE] * 3, axis=2)
    exact = Occlusion(DepthBlur(depth, LENS, PIXEL, channels=RED_GREEN_BLUE)).forward(rgb)
    assert np.array_equal(depth_of_field(rgb, depth, LENS, PIXEL, encoding="linear").values, exact)


def test_gaps_in_the_depth_are_filled_as_asked():
    depth = np.array([[1.0, np.nan, np.nan, 4.0], [1.0, 2.0, np.nan, 4.0]])
    assert np.array_equal(fill_missing(depth, "nearest")[:, [0, 3]], [[1.0, 4.0], [1.0, 4.0]])
    filled = fill_missing(depth, "nearest")
    assert filled[0, 1] in (1.0, 2.0)
    assert filled[0, 2] == 4.0
    assert filled[1, 2] in (2.0, 4.0)
    assert np.array_equal(fill_missing(depth, "infinity"), np.where(np.isnan(depth), np.inf, depth))
    assert fill_missing(depth, None) is depth
    with pytest.raises(ValueError, match="depth is unknown everywhere"):
        fill_missing(np.full((2, 2), np.nan), "nearest")


WAYS = [depth_of_field, FocusPlan, partial(depth_of_field, tile=32)]


@pytest.mark.parametrize("way", [*WAYS, lambda i, d, lens, p, **_: DepthBlur(d, lens, p)])
@pytest.mark.parametrize(
    "shape",
    [
        {"spider": lm.Spider.equal(4, 0.3)},
        {"vignetting": lm.Ellipse(0.5, 0.5)},
        {"vignetting": lm.CatEye((0.5, 0.0))},
        {"mask": lm.Mask(np.full((4, 4), 0.5))},
    ],
)
def test_what_narrows_the_aperture_is_refused_and_never_dropped(way, shape):
    with pytest.raises(ValueError, match=r"lens must have a round aperture.* leave these out, or blur by"):
        way(np.ones((61, 61)), np.full((61, 61), 4.0), replace(LENS, **shape), 8e-6, encoding="linear")


def test_a_photograph_has_the_focus_of_each_colour():
    colour = lm.Colour([450e-9, 550e-9, 650e-9], [60e-6, 0.0, 40e-6])
    lens = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9, colour=colour)
    image, depth, waves = np.zeros((41, 41, 3)), np.full((41, 41), 1.95), (640e-9, 550e-9, 460e-9)
    image[20, 20] = 1.0
    blur = DepthBlur(depth, lens, 6e-6, channels=waves, energy=0.97, dtype=np.float64)
    found = blur.forward(image)
    for k, wavelength in enumerate(waves):
        exact = lm.psf(lens.in_light(wavelength).pupil(1.95), 41, 6e-6, dtype=np.float64).values
        # What is beyond the windows is spread over what is within.
        assert found[20, 20, k] * (1.0 - blur.lost) == pytest.approx(exact[20, 20], rel=2e-3)
    # The blue is out of focus by more than any defocus that is the same path in all light.
    assert found[20, 20, 2] < 0.2 * found[20, 20, 1]


FAST = lm.Lens(focal_length=50e-3, f_number=2.0, focus_distance=2.0, wavelength=550e-9)
WIDE = 40e-6
FLAT = np.full((24, 32), 0.5)
NOISE = lm.Noise(white=5000, read=3.0)


DOORS = {
    "depth_of_field": lambda depth: imaging.depth_of_field(FLAT, depth, FAST, WIDE, encoding="linear"),
    "tiles": lambda depth: imaging.depth_of_field(FLAT, depth, FAST, WIDE, encoding="linear", tile=16),
    "plan": lambda depth: imaging.FocusPlan(FLAT, depth, FAST, WIDE, encoding="linear"),
    "blur": lambda depth: imaging.DepthBlur(depth, FAST, WIDE),
    "restore": lambda depth: imaging.restore(
        FLAT, depth, FAST, WIDE, encoding="linear", noise=NOISE, method=imaging.RichardsonLucy(steps=1)
    ),
}


@pytest.mark.parametrize("way", DOORS)
def test_integers_are_refused_with_the_way_out(way):
    for kind in (np.uint16, np.int64):
        with pytest.raises(TypeError, match=rf"floats, got {np.dtype(kind)}; .* millimetre, pass 0\.001 \* depth"):
            DOORS[way](np.full(FLAT.shape, 2000, kind))
    DOORS[way](0.001 * np.full(FLAT.shape, 2000, np.uint16))


@pytest.mark.parametrize("way", DOORS)
def test_depth_beyond_the_hyperfocal_distance_is_told(way):
    with pytest.warns(UserWarning, match=r"all of the depth, 1900 m to 2200 m, is beyond the hyperfocal .* 15\.68 m"):
        DOORS[way](np.linspace(1900.0, 2200.0, FLAT.size).reshape(FLAT.shape))


@pytest.mark.parametrize("tile", [None, 16])
def test_light_far_beyond_white_is_told(tile):
    depth = np.full(FLAT.shape, 2.0)
    for peak in (9.9, 10.1):
        scene = FLAT.copy()
        scene[3, 4] = peak
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            imaging.depth_of_field(scene, depth, FAST, WIDE, encoding="linear", tile=tile)
        words = [str(each.message) for each in told]
        assert words == ([] if peak < 10.0 else ["there is light of 10.1 times white, which is 1 in floats; divide "
                                                 "by the white level"])  # fmt: skip
