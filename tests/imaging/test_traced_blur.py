"""Blur by depth in frameworks: what each point spreads, the adjoint, derivatives by image, depth and the lens."""

from __future__ import annotations

import pickle
from contextlib import nullcontext
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import lommel as lm
from frameworks import THERE, hasty_programs
from point_sums import sum_over_points

LENS = lm.Lens(focal_length=16e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
PIXEL = 3.45e-6
DRAW = np.random.default_rng(0)
IMAGE, DEPTH = DRAW.random((12, 15)), DRAW.uniform(1.5, 4.0, (12, 15))


def spread(image, depth, half, lens=LENS, *, aberrations=None):
    """Return the sum of what points, and their copies beyond the edges, spread, by images of the core."""
    plan = lm.Plan(2 * half + 1, PIXEL, tol=1e-7)
    windows = plan((lens if aberrations is None else replace(lens, aberrations=aberrations)).pupil(depth)).values
    windows = windows / windows.sum(axis=(2, 3), keepdims=True)
    return sum_over_points(image, lambda row, column: windows[row, column], 2 * half + 1)


@pytest.mark.parametrize("framework", THERE)
def test_a_blur_is_the_sum_of_what_its_points_spread(framework):
    with framework.used() as xp, hasty_programs() if framework.module == "jax.numpy" else nullcontext():
        precision = "float64" if framework.double else "float32"
        blur = lm.imaging.traced_blur(LENS, [1.5, 4.0], PIXEL, xp, device=framework.place(xp), precision=precision)
        found = framework.to_numpy(blur(framework.array(xp, IMAGE), framework.array(xp, DEPTH)))
    exact = spread(IMAGE, DEPTH, blur.half)
    assert np.abs(found - exact).max() < 1e-4 * exact.max()
    assert blur.error <= 1e-4


def test_windows_of_several_layers_are_exact_at_any_depth():
    # 60 rad, windows of 31 pixels.
    lens = lm.Lens(focal_length=25e-3, f_number=2.0, focus_distance=2.0, wavelength=550e-9)
    blur = lm.imaging.traced_blur(lens, [1.0, 5.0], 6e-6)
    assert len(blur._static.ranks) > 1
    point, half = np.zeros((2 * blur.half + 1,) * 2), blur.half
    point[half, half] = 1.0
    for distance in (1.0, 1.31, 1.9, 2.0, 3.3, 5.0):
        exact = lm.psf(lens.pupil(distance), 2 * half + 1, 6e-6, tol=1e-8).values
        off = blur(point, np.full(point.shape, distance)) - exact / exact.sum()
        assert np.abs(off).max() <= 1e-4 * exact.max() / exact.sum()


def test_batches_and_channels_are_blurred_each_for_itself():
    blur = lm.imaging.traced_blur(LENS, [1.5, 4.0], PIXEL, wavelengths=lm.imaging.RED_GREEN_BLUE, precision="float64")
    images = DRAW.random((2, 2, 3, 12, 15))
    depths = DRAW.uniform(1.5, 4.0, (2, 1, 12, 15))
    found = blur(images, np.broadcast_to(depths, (2, 2, 12, 15)))
    assert found.shape == images.shape
    assert np.allclose(blur(images, depths), found, rtol=0.0, atol=1e-12)
    assert np.allclose(found[1, 0], blur(images[1, 0], depths[1, 0]), rtol=0.0, atol=1e-12)
    red = lm.imaging.traced_blur(LENS, [1.5, 4.0], PIXEL, wavelengths=[600e-9])
    assert np.abs(found[0, 0, 0] - red(images[0, 0, 0], depths[0, 0])).max() < 0.02
    one = images[0, 0, :1]
    assert np.array_equal(red(one, depths[0, 0])[0], red(one[0], depths[0, 0]))


@given(focus=st.floats(1.8, 2.2), stop=st.floats(4.0, 4.5), offset=st.floats(-1.0, 1.0))
@settings(max_examples=4, deadline=None)
def test_focus_and_stop_are_those_of_another_lens(learned, focus, stop, offset):
    lens = lm.Lens(focal_length=16e-3, f_number=stop, focus_distance=focus, wavelength=550e-9)
    found = learned(IMAGE, DEPTH, focus_distance=focus, f_number=stop)
    exact = spread(IMAGE, DEPTH, learned.half, lens)
    assert np.abs(found - exact).max() < 1e-4 * exact.max()
    # An offset of C_d is that of another distance.
    near, far = (learned.defocus(d, focus_distance=focus, f_number=stop) for d in (2.5, np.inf))
    other = 1.0 / (1.0 / 2.5 + offset / (near - far) / 2.5)
    options = {"focus_distance": focus, "f_number": stop}
    moved = learned(IMAGE, np.full_like(DEPTH, 2.5), defocus=offset, **options)
    assert np.allclose(moved, learned(IMAGE, np.full_like(DEPTH, other), **options), rtol=0.0, atol=1e-9)


@pytest.fixture(scope="module")
def learned():
    return lm.imaging.traced_blur(
        LENS, [1.5, 4.0], PIXEL, focus_distances=(1.8, 2.2), f_numbers=(4.0, 4.5), defocus=1.0, precision="float64"
    )


TERMS = {(2, 2): 1.0, (3, 1): 1.5, (3, -3): 0.5, (4, 0): 1.0}


@pytest.fixture(scope="module")
def aberrated():
    return lm.imaging.traced_blur(
        LENS, [1.5, 4.0], PIXEL, zernike=TERMS, focus_distances=(1.8, 2.2), precision="float64"
    )


def test_zernike_terms_are_those_of_the_wavefront(aberrated):
    values = np.array([0.7, -1.2, 0.4, 0.6])
    found = aberrated(IMAGE, DEPTH, zernike=values, focus_distance=1.9)
    wavefront = lm.Wavefront.zernike(dict(zip(TERMS, values.tolist(), strict=True)), normalization="edge")
    exact = spread(IMAGE, DEPTH, aberrated.half, LENS.focused(1.9), aberrations=wavefront)
    assert np.abs(found - exact).max() < 1e-4 * exact.max()
    none = aberrated(IMAGE, DEPTH, zernike=np.zeros(4))
    assert np.abs(none - aberrated(IMAGE, DEPTH)).max() < 1e-4 * none.max()


@pytest.mark.parametrize("framework", THERE)
def test_each_image_of_a_batch_has_its_own_lens(framework):
    terms = {(2, 2): 1.0, (4, 0): 1.0}
    image = np.stack([IMAGE, 1.0 - IMAGE, IMAGE[::-1]])[:, None]
    focus, values = np.array([1.8, 2.1, 2.0]), np.array([[0.3, 0.5], [-0.9, 0.1], [0.0, -0.7]])
    offset = np.array([0.2, -0.5, 0.0])[:, None, None]
    with framework.used() as xp, hasty_programs() if framework.module == "jax.numpy" else nullcontext():
        blur = lm.imaging.traced_blur(
            LENS,
            [1.5, 4.0],
            PIXEL,
            xp,
            device=framework.place(xp),
            zernike=terms,
            focus_distances=(1.8, 2.2),
            defocus=1.0,
        )

        def call(image, depth, **lens):
            arrays = {name: framework.array(xp, value.astype(np.float32)) for name, value in lens.items()}
            return framework.to_numpy(blur(framework.array(xp, image), framework.array(xp, depth), **arrays))

        found = call(image, DEPTH[None], focus_distance=focus, zernike=values, defocus=offset)
        for k in range(3):
            one = call(image[k], DEPTH, focus_distance=focus[k], zernike=values[k], defocus=offset[k])
            assert np.abs(found[k] - one).max() < 2e-6
        with pytest.raises(ValueError, match=r"or, one for each image, \(3, 2\) or, over the field.* got \(2, 2\)"):
            call(image, DEPTH[None], zernike=values[:2])
        with pytest.raises(ValueError, match=r"valid for focus_distance within .*, got 1\.9 to 2\.3; clamp"):
            call(image, np.full((1, 12, 15), 2.5), focus_distance=np.array([1.9, 2.3, 2.0]))
        with pytest.raises(ValueError, match="must be at most 1 rad"):
            call(image, DEPTH[None], zernike=np.where(values > 0.4, 1.5, values))


@pytest.mark.parametrize("framework", THERE)
def test_a_lens_over_its_field_mixes_the_psfs_of_its_nodes(framework):
    terms = {(2, 2): 1.0, (3, -1): 1.0}
    nodes = np.random.default_rng(4).uniform(-1.0, 1.0, (2, 3, 2))
    with framework.used() as xp, hasty_programs() if framework.module == "jax.numpy" else nullcontext():
        blur = lm.imaging.traced_blur(LENS, [1.5, 4.0], PIXEL, xp, device=framework.place(xp), zernike=terms)
        image, depth, given = (framework.array(xp, part.astype(np.float32)) for part in (IMAGE, DEPTH, nodes))
        found = framework.to_numpy(blur(image, depth, zernike=given))
        with pytest.raises(ValueError, match="occlusion needs constant aberrations"):
            blur(image, depth, zernike=given, occlusion=True)
        both = [np.stack([part, part]).astype(np.float32) for part in (IMAGE[None], DEPTH, nodes)]
        two, depths, lenses = (framework.array(xp, part) for part in both)
        again = blur(two, depths, zernike=lenses)
        assert np.abs(framework.to_numpy(again)[1, 0] - found).max() < 2e-6
    exact = np.zeros_like(IMAGE)
    down, across = (
        np.array([np.interp(np.arange(n), np.linspace(0, n - 1, k), row) for row in np.eye(k)])
        for n, k in ((12, 2), (15, 3))
    )
    for row, column in np.ndindex(2, 3):
        there = dict(zip(terms, nodes[row, column].tolist(), strict=True))
        wavefront = lm.Wavefront.zernike(there, normalization="edge")
        share = down[row][:, None] * across[column]
        exact += spread(IMAGE * share, DEPTH, blur.half, aberrations=wavefront)
    assert np.abs(found - exact).max() < 1e-4 * exact.max()


def test_its_derivatives_are_the_adjoint_and_those_by_depth_and_lens(learned):
    jax = pytest.importorskip("jax")
    jnp = jax.numpy
    with jax.enable_x64(True), hasty_programs():
        blur = lm.imaging.traced_blur(
            LENS, [1.5, 4.0], PIXEL, jnp, focus_distances=(1.8, 2.2), f_numbers=(4.0, 4.5), defocus=1.0,
            precision="float64",
        )  # fmt: skip
        place = {"image": IMAGE, "distance": DEPTH, "focus_distance": 1.95, "f_number": 4.2, "defocus": 0.3}
        place = {name: jnp.asarray(value) for name, value in place.items()}
        other, turn = jnp.asarray(IMAGE[::-1] - 0.5), jnp.asarray(DRAW.random((12, 15)) - 0.5)

        # Occlusion is added to the blur: the derivatives of both are those of the sum.
        def forward(blur, place):
            return jnp.sum(blur(**place, occlusion=True) * other)

        def plain(place):
            made = learned(**{name: np.asarray(part) for name, part in place.items()}, occlusion=True)
            return float(np.sum(made * np.asarray(other)))

        value, slopes = jax.jit(jax.value_and_grad(forward, argnums=1))(blur, place)
        assert float(value) == pytest.approx(plain(place), rel=1e-9)
        assert float(jnp.sum(slopes["image"] * place["image"])) == pytest.approx(float(value), rel=1e-9)
        for name, step in (("distance", turn), ("focus_distance", 1.0), ("f_number", 1.0), ("defocus", 1.0)):
            h = 1e-5
            ends = [plain(place | {name: place[name] + sign * h * step}) for sign in (1.0, -1.0)]
            slope = float(jnp.sum(slopes[name] * step))
            assert slope == pytest.approx((ends[0] - ends[1]) / (2.0 * h), rel=1e-4, abs=1e-6)


def test_the_gradient_by_zernike_terms_is_that_of_differences(aberrated):
    jax = pytest.importorskip("jax")
    with jax.enable_x64(True), hasty_programs():
        blur = lm.imaging.traced_blur(
            LENS, [1.5, 4.0], PIXEL, jax.numpy, zernike=TERMS, focus_distances=(1.8, 2.2), precision="float64"
        )
        place, turn = jax.numpy.asarray([0.3, 0.2, -0.1, 0.4]), jax.numpy.asarray([1.0, -1.0, 0.5, 0.7])

        def forward(values):
            return jax.numpy.sum(blur(jax.numpy.asarray(IMAGE), jax.numpy.asarray(DEPTH), zernike=values) ** 2)

        slope = float(jax.numpy.sum(jax.jit(jax.grad(forward))(place) * turn))
    image = [aberrated(IMAGE, DEPTH, zernike=np.asarray(place) + h * np.asarray(turn)) for h in (1e-5, -1e-5)]
    assert slope == pytest.approx(float((image[0] ** 2 - image[1] ** 2).sum()) / 2e-5, rel=1e-5)


def test_jax_maps_and_scans_it():
    jax = pytest.importorskip("jax")
    jnp = jax.numpy
    asked = LENS, [1.5, 4.0], PIXEL
    blur, plain = (lm.imaging.traced_blur(*asked, xp, focus_distances=(1.8, 2.2)) for xp in (jnp, None))
    images, depths = (np.stack([part, part[::-1]]) for part in (IMAGE, DEPTH))
    focus = np.array([1.9, 2.1])
    given = tuple(jnp.asarray(part, jnp.float32) for part in (images, depths, focus))
    with hasty_programs():
        mapped = jax.jit(jax.vmap(lambda a, d, f: blur(a, d, focus_distance=f)))(*given)
        _, scanned = jax.lax.scan(lambda n, s: (n, blur(s[0], s[1], focus_distance=s[2])), 0, given)
    for k in range(2):
        one = plain(images[k], depths[k], focus_distance=focus[k])
        assert np.allclose(mapped[k], one, atol=2e-6)
        assert np.allclose(scanned[k], one, atol=2e-6)


def test_occlusion_hides_what_is_behind_and_nothing_else():
    blur = lm.imaging.traced_blur(LENS, [0.7, 4.0], PIXEL)
    lens, height, width = LENS, 30, 40
    depth = np.where(np.arange(width) < 20, 0.8, 4.0) * np.ones((height, 1))
    image = np.where(np.arange(width) < 20, 0.0, 1.0) * np.ones((height, 1))
    with_, without = (blur(image, depth, occlusion=each) for each in (True, False))
    exact = lm.imaging.Occlusion(lm.imaging.DepthBlur(depth, lens, PIXEL)).forward(image)
    assert np.abs(with_ - exact).mean() < 0.5 * np.abs(without - exact).mean()
    white = np.ones_like(image)
    assert np.abs(blur(white, depth, occlusion=True) - 1.0).max() < 0.02
    assert np.abs(blur(white, depth) - 1.0).max() > 0.1
    flat = np.full_like(depth, 1.1)
    draw = DRAW.random(image.shape)
    assert np.abs(blur(draw, flat, occlusion=True) - blur(draw, flat)).max() < 1e-3


@pytest.mark.parametrize("framework", THERE)
def test_one_distance_is_that_of_all_points(framework):
    with framework.used() as xp, hasty_programs() if framework.module == "jax.numpy" else nullcontext():
        blur = lm.imaging.traced_blur(LENS, [1.5, 4.0], PIXEL, xp, device=framework.place(xp))

        def blurred(image, distance):
            made = blur(framework.array(xp, image), distance)
            return framework.to_numpy(made)

        whole = blurred(IMAGE, framework.array(xp, np.full_like(IMAGE, 3.0)))
        assert np.abs(blurred(IMAGE, 3) - whole).max() < 1e-6  # an integer, for a grey image without channels
        assert np.abs(blurred(IMAGE, framework.array(xp, 3.0)) - whole).max() < 1e-6
        channels = blurred(np.stack([IMAGE, 1.0 - IMAGE])[:, None], 3.0)
        assert np.abs(channels[0, 0] - whole).max() < 1e-6
        each = blurred(np.stack([IMAGE, IMAGE]), framework.array(xp, np.array([1.7, 3.0]).reshape(2, 1, 1)))
    assert np.abs(each[1] - whole).max() < 1e-6
    assert np.abs(each[0] - whole).max() > 0.01


def test_beyond_the_valid_range_is_an_error_or_nan_and_far_away_is_within():
    blur = lm.imaging.traced_blur(LENS, [1.5, np.inf], PIXEL)
    assert np.isfinite(blur(IMAGE, np.where(DEPTH > 2.0, np.inf, DEPTH))).all()
    with pytest.raises(ValueError, match="distance must be within"):
        blur(IMAGE, DEPTH - 1.0)
    assert np.isnan(blur(IMAGE, DEPTH - 1.0, check=False)).any()
    sharp = lm.imaging.traced_blur(LENS, 2.0, PIXEL)
    assert sharp(IMAGE, np.full_like(IMAGE, 2.0)).shape == IMAGE.shape


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        ({"image": (255 * IMAGE).astype(np.uint8)}, TypeError, "image must hold real floats"),
        ({"image": np.where(IMAGE > 0.9, np.nan, IMAGE)}, ValueError, "image must be finite"),
        ({"distance": DEPTH[1:]}, ValueError, "must have the shape"),
        ({"image": np.stack([IMAGE] * 3)}, ValueError, "must have the shape"),
        ({"distance": np.where(DEPTH > 3.0, np.nan, DEPTH)}, ValueError, "not be NaN, got NaN at 76 of 180 points"),
        ({"zernike": np.zeros(2)}, ValueError, "zernike is fixed"),
        ({"focus_distance": 3.0}, ValueError, "distance must be within|valid for focus_distance within"),
        ({"f_number": np.ones(3)}, ValueError, r"f_number must have the shape \(\), got \(3,\)"),
    ],
)
def test_bad_input_is_refused_in_one_sentence(learned, change, error, message):
    with pytest.raises(error, match=message) as found:
        learned(**{"image": IMAGE, "distance": DEPTH} | change)
    assert len(str(found.value)) < 300


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"lens": lm.Lens(focal_length=16e-3, f_number=4.0, wavelength=550e-9, model="aplanatic")}, "paraxial"),
        ({"lens": lm.Lens(focal_length=1e-2, f_number=4.0, wavelength=5e-7, spider=lm.Spider(0.1, [0.0]))}, "round"),
        ({"f_numbers": (1.0, 64.0)}, "f_numbers|windows of more than"),
    ],
)
def test_what_no_blur_can_be_made_of_is_refused(change, message):
    asked = {"lens": LENS, "distances": [1.5, 4.0], "pixel": PIXEL} | change
    with pytest.raises(ValueError, match=message):
        lm.imaging.traced_blur(**asked)


def test_a_module_of_torch_learns_compiles_and_is_pickled():
    torch = pytest.importorskip("torch")
    blur = lm.imaging.traced_blur(
        LENS, [1.5, 4.0], PIXEL, torch, wavelengths=lm.imaging.RED_GREEN_BLUE, focus_distances=(1.8, 2.2)
    )
    module = blur.torch_module(focus_distance=1.9)
    image = torch.tensor(DRAW.random((2, 3, 12, 15)), dtype=torch.float32)
    depth = torch.tensor(np.stack([DEPTH, DEPTH]), dtype=torch.float32)
    out = module(image, depth)
    (out**2).sum().backward()
    assert float(abs(module.focus_distance.grad)) > 0.0
    again = pickle.loads(pickle.dumps(module))
    assert torch.equal(again(image, depth), out)
    assert torch.equal(blur(image, depth, focus_distance=torch.tensor(1.9)), out)
    for occlusion in (False, True):
        compiled = torch.compile(module, backend="eager", fullgraph=True)
        assert torch.allclose(
            compiled(image, depth, occlusion=occlusion), module(image, depth, occlusion=occlusion), atol=1e-5
        )
    with pytest.raises(TypeError, match="learned parameters"):
        blur.torch_module(pixel=1.0)


class Blurred:
    """A data set of one picture, blurred by the worker."""

    def __init__(self, module):
        self.module = module

    def __len__(self):
        return 2

    def __getitem__(self, index):
        torch = pytest.importorskip("torch")
        with torch.no_grad():
            return self.module(torch.full((12, 15), 1.0 + index), torch.full((12, 15), 2.5))


@pytest.mark.filterwarnings("ignore:os.fork:RuntimeWarning")  # of JAX, where other tests have imported it
@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_workers_blur(start):
    torch = pytest.importorskip("torch")
    blur = lm.imaging.traced_blur(LENS, [1.5, 4.0], PIXEL, torch)
    loader = torch.utils.data.DataLoader(
        Blurred(blur.torch_module()), batch_size=2, num_workers=1, multiprocessing_context=start
    )
    (made,) = list(loader)
    assert torch.allclose(made[1], 2.0 * made[0], atol=1e-5)
