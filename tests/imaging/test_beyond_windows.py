"""The whole PSF: against sums of whole PSFs, mirrored by hand; what is conserved, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import (
    DepthBlur,
    Occlusion,
    depth_of_field,
)

PIXEL = 6e-6
HALF = 112  # of the windows of the truth; what is beyond is added evenly


def lens(f_number=8.0, **more):
    return lm.Lens(focal_length=35e-3, f_number=f_number, focus_distance=2.2, wavelength=540e-9, **more)


def scene(seed=0, shape=(10, 14)):
    rng = np.random.default_rng(seed)
    return rng.random(shape), rng.uniform(2.0, 5.0, shape)


def windows(optics, depth, spectrum, half=HALF):
    """PSFs of points at these depths, averaged over pixels, by the front door; shape (points, side, side)."""
    pupil, total = optics.pupil(np.ravel(depth)), 0.0
    for wavelength, share in spectrum:
        there = lm.Pupil(
            (optics.wavelength / wavelength) * pupil.wavefront,
            obscuration=optics.obscuration,
            wavelength=wavelength,
            f_number=optics.working_f_number,
            apodization=optics.illumination,
        )
        method = lm.methods.NijboerZernike(1e-8)
        answer = lm.psf(there, 2 * half + 1, PIXEL, integrate=True, method=method, dtype=np.float64)
        total = total + share * answer.values
    return total


def mirrored(rows, middle, count):
    """Rows of a window around `middle` of an image of `count` rows; those beyond its edges are added to them."""
    half = len(rows) // 2
    place = np.arange(middle - half, middle + half + 1) % (2 * count)
    out = np.zeros((count, rows.shape[1]))
    np.add.at(out, np.where(place < count, place, 2 * count - 1 - place), rows)
    return out


def summed(image, depth, optics, wavelength=540e-9):
    """The sum of the whole PSFs of all points between mirrors."""
    (height, width), total = image.shape, 0.0
    for y in range(height):
        for x, window in enumerate(windows(optics, depth[y], ((wavelength, 1.0),))):
            spread = mirrored(mirrored(window, y, height).T, x, width).T
            # Light so far away has been mirrored so often that it lies anywhere.
            total = total + image[y, x] * (spread + (1.0 - window.sum()) / image.size)
    return total


@pytest.mark.parametrize("f_number", [2.0, 4.0, 8.0])
def test_every_point_spreads_its_whole_psf_between_mirrors(f_number):
    image, depth = scene(int(f_number))
    truth = summed(image, depth, lens(f_number))
    for dtype in (np.float32, np.float64):
        blur = DepthBlur(depth, lens(f_number), PIXEL, energy=1.0, largest=40, dtype=dtype)
        off = np.abs(blur.forward(image.astype(dtype)) - truth).max()
        assert off <= 1e-5 * truth.max()
        assert off <= blur.error * image.max()
        assert blur.error < 4e-4
        assert blur.lost == 0.0
    cut = DepthBlur(depth, lens(f_number), PIXEL, largest=40, dtype=np.float64)
    assert np.abs(cut.forward(image) - truth).max() > 5e-3 * truth.max()


def test_colours_have_each_their_own_and_a_photograph_says_how_far_it_may_be_off():
    image, depth = scene(1, (8, 9))
    colour = np.stack([image, image[::-1], image[:, ::-1]], axis=2)
    photograph = depth_of_field(
        colour, depth, lens(4.0), PIXEL, encoding="linear", energy=1.0, occlusion=False, largest=40
    )
    for channel, wavelength in enumerate(lm.imaging.RED_GREEN_BLUE):
        truth = summed(colour[..., channel], depth, lens(4.0), wavelength)
        off = np.abs(photograph.values[..., channel] - truth).max()
        assert off <= min(photograph.error, 1e-5 * truth.max())
    assert photograph.lost == 0.0


@pytest.mark.parametrize(
    ("border", "mode"),
    [("zero", "constant"), ("extend", "edge")],
)
def test_other_borders_are_those_of_an_image_that_goes_on(border, mode):
    image, depth = scene(2)
    blur = DepthBlur(depth, lens(), PIXEL, energy=1.0, border=border, largest=40, dtype=np.float64)
    made = blur.forward(image)
    # Edges go on for half of the image, and are mirrored there; darkness goes on for ever.
    around = [(side // 2,) * 2 for side in image.shape] if border == "extend" else [(20, 20)] * 2
    inside = tuple(slice(before, -after) for before, after in around)
    if border == "extend":
        truth = summed(np.pad(image, around, mode=mode), np.pad(depth, around, mode="edge"), lens())
    else:
        size = 40
        truth = np.zeros([side + 2 * size for side in image.shape])
        for y in range(image.shape[0]):
            for x, window in enumerate(windows(lens(), depth[y], ((540e-9, 1.0),), size)):
                truth[y : y + 2 * size + 1, x : x + 2 * size + 1] += image[y, x] * window
        inside = (slice(size, -size),) * 2
    off = np.abs(made - truth[inside]).max()
    assert off <= 2e-5 * truth.max()
    assert off <= blur.error * image.max()


def rows_off(blur, depths, chosen, size):
    """The sums over all points of what the blur of an image in darkness is off, at some of its pixels."""
    known = windows(blur.lens, depths, ((blur.lens.wavelength, 1.0),), size - 1)
    row, column = np.mgrid[:size, :size]
    found = []
    for y, x in [(size // 2, size // 2), (0, 0), (size - 1, size // 3), (size // 4, 0)]:
        point = np.zeros((size, size))
        point[y, x] = 1.0
        true = known[chosen, y - row + size - 1, x - column + size - 1]
        found.append(np.abs(blur.adjoint(point) - true).sum())
    return max(found)


@pytest.mark.filterwarnings("ignore:with energy=1")
@pytest.mark.parametrize("tol", [1e-3, 1e-4, 1e-5])
@pytest.mark.parametrize(
    ("f_number", "between"), [(2.8, (2.0, 2.5)), (4.0, (1.8, 3.0)), (8.0, (2.1, 6.0)), (16.0, (1.0, 9.0))]
)
def test_the_error_bounds_what_the_worst_scene_is_off_and_is_no_ten_times_that(f_number, between, tol):
    size, rng = 24, np.random.default_rng(int(10 * f_number))
    depths = rng.uniform(*between, 5)
    chosen = rng.integers(len(depths), size=(size, size))
    given = {"energy": 1.0, "tol": tol, "border": "zero", "largest": 60, "dtype": np.float64}
    blur = DepthBlur(depths[chosen], lens(f_number), PIXEL, **given)
    off = rows_off(blur, depths, chosen, size)
    assert off <= blur.error <= 10.0 * off


def test_the_error_is_that_of_the_distances_of_the_scene():
    given = {"energy": 1.0, "tol": 1e-3, "largest": 60, "dtype": np.float64}
    blur = DepthBlur(np.array([[2.0, 6.0]] * 2), lens(), PIXEL, **given)
    every = blur.error
    blur.place(np.full((2, 2), 3.0))
    assert blur.error < every


@pytest.mark.parametrize(
    ("border", "dtype", "hint"), [("zero", np.float32, "dtype=float64"), ("reflect", np.float64, "energy=0.9999")]
)
def test_an_error_of_more_than_twice_the_tolerance_is_told_with_a_way_out(border, dtype, hint):
    depth = scene(3)[1]
    given = {"energy": 1.0, "border": border, "largest": 40, "dtype": dtype}
    with pytest.warns(UserWarning, match=f"the error of a pixel may reach .* twice tol=1e-07; .*{hint}"):
        assert DepthBlur(depth, lens(), PIXEL, tol=1e-7, **given).error > 2e-7
    assert DepthBlur(depth, lens(), PIXEL, tol=1e-3, **given).error <= 2e-3


SPECTRUM = ((480e-9, 0.4), (600e-9, 0.6))
KINDS = {
    "two wavelengths": (lens(4.0), SPECTRUM),
    "obscured": (lens(4.0, obscuration=0.3), ((540e-9, 1.0),)),
    "darker at the rim": (lens(4.0, apodization=0.8), ((540e-9, 1.0),)),
    "spherical": (lens(4.0, aberrations=lm.Wavefront(0.0, 1.2)), ((540e-9, 1.0),)),
    "fast and far": (lens(2.0), ((540e-9, 1.0),)),
}


@pytest.mark.parametrize("kind", KINDS)
def test_a_point_spreads_its_psf_to_within_the_error_in_the_sum_of_all_pixels(kind):
    optics, spectrum = KINDS[kind]
    depths = np.random.default_rng(5).uniform(1.6, 6.0, 6)
    side = 2 * HALF + 1
    blur = DepthBlur(
        np.append(depths, [1.6, 6.0]).reshape(1, -1),
        optics,
        PIXEL,
        energy=1.0,
        largest=60,
        dtype=np.float64,
        channels=[spectrum],
        border="zero",
    )
    point = np.zeros((side, side))
    point[HALF, HALF] = 1.0
    for depth, true in zip(depths, windows(optics, depths, spectrum), strict=True):
        blur.place(np.full((side, side), depth))
        made = blur.forward(point)
        # Signed, so that what is beyond the window counts by its sum.
        assert np.abs(made - true).sum() <= blur.error
        assert made[:, 0].sum() > 0.5 * true[:, 0].sum() > 0.0
    assert blur.error < 1e-3


@pytest.mark.parametrize("border", ["reflect", "extend", "zero"])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("weighted", [False, True])
@pytest.mark.parametrize("shape", [(10, 14), (9, 7), (1, 12)])
def test_the_adjoint_is_the_transpose(border, dtype, weighted, shape):
    rng = np.random.default_rng(1)
    _, depth = scene(1, shape)
    blur = DepthBlur(
        depth, lens(4.0), PIXEL, border=border, dtype=dtype, energy=1.0, largest=40, channels=(6e-7, 5e-7)
    )
    a, b = (rng.standard_normal((*shape, 2)).astype(dtype) for _ in range(2))
    weight = rng.random(shape) < 0.6 if weighted else None
    scale = float(np.linalg.norm(a) * np.linalg.norm(b))
    one, two = np.vdot(blur.forward(a, weight), b), np.vdot(a, blur.adjoint(b, weight))
    assert one == pytest.approx(two, abs=scale * (1e-13 if dtype == np.float64 else 1e-6))
    if weighted:
        assert np.all(blur.adjoint(b, weight)[~weight] == 0.0)
        left_out = np.where(weight[..., None], a, 0.0).astype(dtype)
        np.testing.assert_allclose(blur.forward(a, weight), blur.forward(left_out), atol=1e-6)
    if border != "zero":
        seen = Occlusion(blur)
        one, two = np.vdot(seen.forward(a), b), np.vdot(a, seen.adjoint(b))
        assert one == pytest.approx(two, abs=scale * (1e-13 if dtype == np.float64 else 1e-6))


@pytest.mark.parametrize("f_number", [2.0, 8.0])
def test_no_light_is_lost_between_mirrors_and_a_white_wall_stays_white(f_number):
    image, depth = scene(3, (23, 31))
    blur = DepthBlur(depth, lens(f_number), PIXEL, energy=1.0, dtype=np.float64, largest=40)
    assert blur.forward(image).sum() == pytest.approx(image.sum(), rel=1e-6)
    wall = DepthBlur(np.full((23, 31), 3.0), lens(f_number), PIXEL, energy=1.0, dtype=np.float64, largest=40)
    assert np.abs(wall.forward(np.ones((23, 31))) - 1.0).max() < 1e-12


def test_nothing_jumps_as_a_point_moves():
    blur = DepthBlur(np.array([[2.0, 5.0]]), lens(), PIXEL, energy=1.0, dtype=np.float64, largest=40, border="zero")
    bank = blur.banks[0]
    knots = bank.start + bank.spacing * np.arange(1, bank.count - 1)
    for at in knots:
        kernels = []
        for defocus in (at - 1e-9, at + 1e-9):
            values = np.tensordot(bank.remainder.factors(bank.positions(defocus)), bank.remainder.values(40), axes=1)
            away = np.abs(np.arange(-bank.half, bank.half + 1))
            kernels.append(values[away[:, None], away] + bank.window(defocus))
        assert np.abs(kernels[0] - kernels[1]).max() <= 1e-6 * kernels[0].max()


def near_and_far():
    depth = np.full((30, 40), 5.0)
    depth[:, :18] = 2.2
    return depth


def test_what_is_white_stays_white_where_near_points_hide_far_ones():
    for depth in (near_and_far(), scene(4, (30, 40))[1]):
        blur = DepthBlur(depth, lens(4.0), PIXEL, energy=1.0, dtype=np.float64)
        white = np.ones((30, 40))
        assert np.abs(Occlusion(blur).forward(white) - white).max() < 1e-12


def test_a_dark_object_in_focus_takes_but_the_halo_of_what_is_behind_it():
    depth = near_and_far()
    light = np.where(depth > 3.0, 1.0, 0.0)
    blur = DepthBlur(depth, lens(4.0), PIXEL, energy=1.0, dtype=np.float64)
    seen, added = Occlusion(blur).forward(light), blur.forward(light)
    # The window of a sharp object holds all but 1.5 % of its light, and that is no hole to see through.
    assert seen[15, 2] < 5e-3
    assert seen[15, 15] < 0.5 * added[15, 15]
    # As with windows of which almost nothing is cut.
    wide = DepthBlur(depth, lens(4.0), PIXEL, dtype=np.float64, energy=0.997, largest=60)
    assert np.abs(seen - Occlusion(wide).forward(light)).max() < 5e-3


def test_points_may_be_put_elsewhere():
    image, depth = scene(7, (24, 30))
    blur = DepthBlur(depth, lens(4.0), PIXEL, energy=1.0, dtype=np.float64)
    before = blur.forward(image)
    blur.place(depth[::-1])
    assert np.abs(blur.forward(image[::-1])[::-1] - before).max() < 1e-12
    assert np.abs(blur.forward(image) - before).max() > 1e-4


@pytest.mark.parametrize("threads", [2, 3])
def test_threads_do_not_change_a_bit(threads):
    image, depth = scene(8, (260, 270))
    light = np.stack([image, image[::-1]], axis=2).astype(np.float32)
    given = {"energy": 1.0, "tol": 1e-3, "channels": (6e-7, 5e-7)}
    one, more = (DepthBlur(depth, lens(), PIXEL, threads=count, **given) for count in (1, threads))
    assert one.forward(light).tobytes() == more.forward(light).tobytes()
    assert one.adjoint(light).tobytes() == more.adjoint(light).tobytes()


def test_tiles_and_chunks_refuse_what_reaches_all_of_the_image():
    image, depth = scene(10, (24, 30))
    message = "energy must be below 1 for tiles and chunks, .* give a smaller energy such as 0.99, or the whole"
    with pytest.raises(ValueError, match=message):
        depth_of_field(image, depth, lens(), PIXEL, encoding="linear", energy=1.0, tile=16)
    da = pytest.importorskip("dask.array")
    with pytest.raises(ValueError, match=message):
        depth_of_field(da.from_array(image), da.from_array(depth), lens(), PIXEL, encoding="linear", energy=1.0)
