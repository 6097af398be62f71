"""Blur over the field, against sums of exact PSFs."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import DepthBlur, FieldBlur
from point_sums import sum_over_points

SCALE = {"wavelength": 550e-9, "f_number": 4.0}
# As much changes over these 60 micrometres as over a sensor.
STEEP = lm.FieldMap.from_seidel(60e-6, W131=1.5, W222=1.0, W040=0.3, **SCALE)
SENSOR = lm.FieldMap.from_seidel(np.hypot(10e-3, 7e-3), W131=1.5, W222=1.0, **SCALE)
LENS = lm.Lens(focal_length=8e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
OF_LENS = lm.FieldMap.from_seidel(60e-6, W131=1.5, W222=1.0, aperture=LENS.pupil(2.0).unaberrated())
PIXEL = 2e-6
SHAPE = (24, 40)


def exact(field: lm.FieldMap, blur: FieldBlur, rows: np.ndarray, columns: np.ndarray, half: int) -> np.ndarray:
    """Return the share of light in each pixel of windows of points of an image in the middle of the field."""
    height, width = blur.shape
    y, x = PIXEL * (rows - (height - 1) / 2), PIXEL * (columns - (width - 1) / 2)
    return field.psf(x, y, 2 * half + 1, PIXEL, integrate=True, tol=1e-8, dtype=np.float64).values


def dot(blur: FieldBlur, seed: int = 0) -> tuple[float, float]:
    shape = blur.shape if blur.channels == 1 else (*blur.shape, blur.channels)
    a, b = np.random.default_rng(seed).random((2, *shape)).astype(blur.dtype)
    made, back = blur.forward(a), blur.adjoint(b)
    assert made.dtype == back.dtype == blur.dtype
    return float(np.vdot(made.astype(float), b)), float(np.vdot(a.astype(float), back.astype(float)))


def spread(windows: np.ndarray, image: np.ndarray) -> np.ndarray:
    return sum_over_points(image, lambda row, column: windows[row, column], windows.shape[-1])


def test_every_point_spreads_the_psf_of_its_own_place():
    """Copies of points beyond the edges spread the PSF of the point that they copy."""
    blur = FieldBlur(STEEP, SHAPE, PIXEL, dtype=np.float64, largest=30, tol=1e-4)
    half = blur.banks[0].half
    rows, columns = (side.ravel() for side in np.indices(SHAPE))
    windows = exact(STEEP, blur, rows, columns, half).reshape(*SHAPE, 2 * half + 1, 2 * half + 1)
    image = np.random.default_rng(0).random(SHAPE)
    off = blur.forward(image) - spread(windows / windows.sum(axis=(2, 3), keepdims=True), image)
    assert np.abs(off).sum() <= 1e-4 * image.sum()
    assert np.abs(off).max() <= 1e-4


@pytest.mark.parametrize("tol", [1e-2, 1e-3, 1e-4])
def test_windows_of_random_sources_err_by_less_than_is_said(tol):
    blur = FieldBlur(STEEP, SHAPE, PIXEL, dtype=np.float64, largest=30, tol=tol)
    half, rng = blur.banks[0].half, np.random.default_rng(3)
    rows, columns = rng.integers(0, SHAPE[0], 150), rng.integers(0, SHAPE[1], 150)
    made = np.stack([blur.window(row, column) for row, column in zip(rows, columns, strict=True)])
    assert np.abs(made.sum(axis=(1, 2)) - 1.0).max() < 1e-12
    whole = exact(STEEP, blur, rows, columns, half + 60)
    inside = whole[:, 60:-60, 60:-60]
    held = inside.sum(axis=(1, 2))
    assert 1.0 - held.min() <= blur.lost <= 0.02
    off = np.abs(made - inside / held[:, None, None]).sum(axis=(1, 2)).max()
    assert off <= blur.error <= tol
    # And against all light, also what is beyond the larger windows.
    apart = np.abs(np.pad(made, ((0, 0), (60, 60), (60, 60))) - whole).sum(axis=(1, 2)) + 1.0 - whole.sum(axis=(1, 2))
    assert apart.max() <= blur.error + 2.0 * blur.lost


def test_a_sensor_of_twenty_millimetres_takes_few_nodes():
    """Coma of 1.5 and astigmatism of 1 wave in the corner: with bilinear weights 33 x 23 nodes err by a hundredth."""
    blur = FieldBlur(SENSOR, (70, 100), PIXEL, sensor=(14e-3, 20e-3), largest=30)
    assert blur.error <= 1e-3
    assert blur.banks[0].count < 450
    rng = np.random.default_rng(1)
    y, x = rng.uniform(-7e-3, 7e-3, 100), rng.uniform(-10e-3, 10e-3, 100)
    y, x = (np.clip(part, at[0], at[-1]) for part, at in ((y, blur.y), (x, blur.x)))
    whole = SENSOR.psf(x, y, 2 * blur.banks[0].half + 1, PIXEL, dtype=np.float64).values
    whole /= whole.sum(axis=(1, 2), keepdims=True)
    made = np.stack([blur.banks[0].window(*place) for place in zip(y, x, strict=True)])
    assert np.abs(made - whole).sum(axis=(1, 2)).max() <= blur.error


@pytest.mark.parametrize(("dtype", "rel"), [(np.float32, 1e-6), (np.float64, 1e-12)])
@pytest.mark.parametrize("deep", [False, True])
def test_the_adjoint_is_the_transpose(dtype, rel, deep):
    more = {"depth": np.linspace(1.5, 2.3, 960).reshape(SHAPE), "lens": LENS} if deep else {}
    blur = FieldBlur(OF_LENS, SHAPE, PIXEL, dtype=dtype, largest=40, tol=1e-2, energy=0.9, **more)
    one, other = dot(blur)
    assert one == pytest.approx(other, rel=rel)


@pytest.mark.parametrize("channels", [None, (600e-9, [(500e-9, 1.0), (450e-9, 3.0)], 600e-9)])
def test_channels_have_their_own_light_and_the_same_paths(channels):
    blur = FieldBlur(STEEP, SHAPE, PIXEL, channels=channels, dtype=np.float64, largest=40, energy=0.95)
    one, other = dot(blur)
    assert one == pytest.approx(other, rel=1e-12)
    if channels is None:
        return
    assert blur.channels == 3
    assert blur.banks[0] is blur.banks[2]
    pupil = STEEP.pupil(blur.x[31], blur.y[4])
    half, total = blur.banks[1].half, 0.0
    for wavelength, weight in ((500e-9, 0.25), (450e-9, 0.75)):
        light = lm.Pupil((550e-9 / wavelength) * pupil.wavefront, wavelength=wavelength, f_number=4.0)
        total = total + weight * lm.psf(light, 2 * half + 1, PIXEL, dtype=np.float64).values
    assert np.abs(blur.window(4, 31, 1) - total / total.sum()).sum() <= blur.error


def test_every_point_spreads_the_psf_of_its_own_distance_at_its_own_place():
    rng = np.random.default_rng(0)
    depth = rng.uniform(1.4, 3.5, SHAPE)
    depth[0, 0] = np.inf
    blur = FieldBlur(OF_LENS, SHAPE, PIXEL, depth=depth, lens=LENS, dtype=np.float64, largest=40)
    half, image, rows, columns = blur.banks[0].half, np.zeros(SHAPE), rng.integers(0, 24, 60), rng.integers(0, 40, 60)
    rows[0] = columns[0] = 0
    windows = np.zeros((*SHAPE, 2 * half + 1, 2 * half + 1))
    for row, column in zip(rows, columns, strict=True):
        pupil = OF_LENS.pupil(PIXEL * (column - 19.5), PIXEL * (row - 11.5))
        there = lm.Pupil(
            pupil.wavefront + LENS.pupil(depth[row, column]).wavefront,
            wavelength=550e-9,
            f_number=LENS.working_f_number,
        )
        window = lm.psf(there, 2 * half + 1, PIXEL, dtype=np.float64).values
        window /= window.sum()
        assert np.abs(blur.window(row, column) - window).sum() <= blur.error <= 1e-3
        image[row, column], windows[row, column] = 1.0, window
    off = blur.forward(image) - spread(windows, image)
    assert np.abs(off).sum() <= 1e-3 * image.sum()


def test_a_lens_that_is_the_same_everywhere_blurs_as_by_depth_alone():
    """Soft apertures have no far light, which windows of two shapes would cut differently."""
    lens = lm.Lens(focal_length=8e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9, apodization=8.0)
    field = lm.FieldMap.from_seidel(1e-3, W040=0.0, aperture=lens.pupil(1.0).unaberrated())
    image, depth = np.random.default_rng(0).random(SHAPE), np.random.default_rng(1).uniform(1.0, 5.0, SHAPE)
    given = {"energy": 0.9999, "dtype": np.float64, "tol": 1e-5, "largest": 40}
    by_depth = DepthBlur(depth, lens, PIXEL, **given)
    blur = FieldBlur(field, SHAPE, PIXEL, depth=depth, lens=lens, **given)
    assert blur.banks[0].coefficients.shape[:2] == (1, 1)
    assert np.abs(blur.forward(image) - by_depth.forward(image)).max() < 3e-4
    assert np.abs(blur.adjoint(image) - by_depth.adjoint(image)).max() < 3e-4


def test_a_white_wall_stays_white_and_light_is_kept():
    same = lm.FieldMap.on_grid(
        [-1.0, 1.0], [-1.0, 1.0], lm.Wavefront.zernike({8: np.full((2, 2), 0.8)}, order="noll"), **SCALE
    )
    blur = FieldBlur(same, SHAPE, PIXEL, dtype=np.float64, largest=40)
    assert np.abs(blur.forward(np.ones(SHAPE)) - 1.0).max() < 1e-12
    # A part of a sensor over which the PSF hardly changes: tails of coma point beyond the edges, and are not missed.
    corner = FieldBlur(SENSOR, SHAPE, PIXEL, dtype=np.float64, largest=40, center=(3000.0, 4000.0))
    assert np.abs(corner.forward(np.ones(SHAPE)) - 1.0).max() < 2e-3
    star = np.zeros((60, 70))
    star[30, 35] = 1.0
    assert FieldBlur(SENSOR, (60, 70), PIXEL, dtype=np.float64).forward(star).sum() == pytest.approx(1.0, abs=1e-12)


def test_tails_of_coma_point_away_from_the_axis():
    field = lm.FieldMap.from_seidel(60e-6, W131=3.0, **SCALE)
    blur = FieldBlur(field, SHAPE, PIXEL, dtype=np.float64, largest=40, tol=1e-4)
    half = blur.banks[0].half
    away = np.arange(-half, half + 1)
    for row, column in ((0, 20), (23, 20), (12, 0), (12, 39)):
        window = blur.window(row, column)
        tail = np.array([window.sum(axis=1) @ away, window.sum(axis=0) @ away])
        assert tail @ [row - 11.5, column - 19.5] > 3.0


def test_light_that_distortion_moves_is_followed():
    field = lm.FieldMap.from_seidel(100e-6, W311=-2.0, **SCALE)
    blur = FieldBlur(field, (60, 80), PIXEL, tol=1e-2, dtype=np.float64)
    exact = lm.centroid(field.pupil(blur.x[70], blur.y[5])) / PIXEL  # x, y
    assert np.abs(exact).max() > 1.5
    window, half = blur.window(5, 70), blur.banks[0].half
    away = np.arange(-half, half + 1)
    made = np.array([window.sum(axis=0) @ away, window.sum(axis=1) @ away])
    assert np.abs(made - exact).max() < 0.1


def test_any_aperture_will_do_in_units_of_the_spot_too():
    aperture = {"vignetting": lm.CatEye((0.5, 0.2)), "spider": lm.Spider.equal(3, 0.1)}
    field = lm.FieldMap.from_seidel(30.0, W131=0.2, aperture=lm.Pupil(obscuration=0.2, **aperture))
    blur = FieldBlur(field, (20, 30), 1.0, tol=0.1, energy=0.7, largest=20, dtype=np.float64)
    half = blur.banks[0].half
    window = field.psf(blur.x[3], blur.y[17], 2 * half + 1, 1.0, integrate=True, dtype=np.float64).values
    assert np.abs(blur.window(17, 3) - window / window.sum()).sum() <= blur.error
    one, other = dot(blur)
    assert one == pytest.approx(other, rel=1e-12)


FLAT, BARE = np.full(SHAPE, 2.0), lm.FieldMap.from_seidel(30.0, W131=1.0)
ABERRATED = lm.Lens(
    focal_length=8e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9, aberrations=lm.Wavefront(1.0)
)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"shape": (24, 80)}, r"lies outside of the map, which reaches 6e-05 m .*use a smaller shape"),
        ({"depth": FLAT}, "lens is missing: depth= and lens= must"),
        ({"depth": FLAT, "lens": LENS.focused(0.1)}, "lens must have the working"),
        ({"depth": FLAT, "lens": ABERRATED}, "lens must have no aberrations: add them to the map"),
        ({"field_map": BARE, "pixel": 0.5, "channels": (550e-9,)}, "channels need a map with a wavelength"),
    ],
)
def test_what_makes_no_blur_is_refused_by_name(change, message):
    given = {"field_map": OF_LENS, "shape": SHAPE, "pixel": PIXEL, "largest": 40} | change
    with pytest.raises(ValueError, match=message):
        FieldBlur(**given)


@pytest.mark.parametrize("deep", [False, True])
def test_a_crop_is_a_part_of_the_image_with_the_same_windows(deep):
    depth = np.random.default_rng(0).uniform(1.6, 2.3, SHAPE)
    more = {"depth": depth, "lens": LENS} if deep else {}
    given = {"dtype": np.float64, "largest": 40, "energy": 0.9, "tol": 1e-2, "channels": (550e-9, 500e-9, 550e-9)}
    whole = FieldBlur(OF_LENS, SHAPE, PIXEL, **given, **more)
    top, left = 9, 16
    part = whole.crop((12, 20), center=(11.5 - top, 19.5 - left), depth=depth[9:21, 16:36] if deep else None)
    assert all(one is other for one, other in zip(part.banks, whole.banks, strict=True))
    assert part.error <= 1e-2
    assert np.abs(part.window(3, 4, 1) - whole.window(top + 3, left + 4, 1)).max() < 1e-12
    light, points = np.random.default_rng(1).random((12, 20, 3)), np.indices((12, 20)).reshape(2, -1).T
    for channel, operator in enumerate(part._operators):
        windows = np.stack([part.window(row, column, channel) for row, column in points])
        exact = spread(windows.reshape(12, 20, *windows.shape[1:]), light[..., channel])
        # By no more than the parabolas, where windows are small, also of mirror images.
        off = np.abs(part.forward(light)[..., channel] - exact)
        assert off.max() <= 1e-12 + operator.error * light.max()
    one, other = dot(part)
    assert one == pytest.approx(other, rel=1e-12)


def test_crops_that_go_beyond_the_whole_are_refused():
    depth = np.linspace(1.6, 2.3, 960).reshape(SHAPE)
    given = {"largest": 40, "energy": 0.9, "tol": 1e-2}
    whole = FieldBlur(OF_LENS, SHAPE, PIXEL, depth=depth, lens=LENS, **given)
    near = np.full((12, 20), 1.5)
    with pytest.raises(ValueError, match="its columns span"):
        whole.crop((12, 20), center=(5.5, 22.0), depth=near + 0.3)
    with pytest.raises(ValueError, match="its defocus span"):
        whole.crop((12, 20), center=(5.5, 9.5), depth=near)
    with pytest.raises(ValueError, match="crop needs a depth"):
        whole.crop((12, 20), center=(5.5, 9.5))
    with pytest.raises(ValueError, match="without sensor="):
        FieldBlur(SENSOR, (7, 10), PIXEL, sensor=(7e-4, 1e-3), largest=30).crop((3, 3), center=(1.0, 1.0))
