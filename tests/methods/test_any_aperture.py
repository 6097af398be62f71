"""Every shape of aperture, by the methods that take any, against sums over nodes that have nothing in common."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.special import j1

import lommel as lm
from lommel import CatEye, Ellipse, Mask, Pupil, Spider, Wavefront
from lommel.methods import METHODS, Hankel, MatrixFourier, Method, NijboerZernike, NonuniformFFT
from lommel.paper import Fraunhofer

Array = NDArray[np.float64]
Nodes = tuple[Array, Array, Array]

W = Wavefront(3.0, 1.0, nonradial={(1, 1): 0.7, (2, -2): 1.5, (3, 1): 2.0, (5, -3): 0.4})
N = 90


def rectangle(low: Any, high: Any, n: int = N) -> tuple[Array, Array]:
    """Gauss-Legendre nodes and weights on [low, high], along a new last axis."""
    x, w = np.polynomial.legendre.leggauss(n)
    half = 0.5 * (np.asarray(high) - np.asarray(low))[..., None]
    return np.asarray(low)[..., None] + half * (x + 1.0), half * w


def chords(low: float, high: float, left: Any, right: Any, angle: float = 0.0) -> Nodes:
    """Nodes of ``left(u) < s < right(u)``, low < u < high; s runs in the direction `angle`, u across it."""
    phi, w = rectangle(-0.5 * math.pi, 0.5 * math.pi)
    # The sine takes the square roots at the ends of chords away.
    u = 0.5 * (low + high) + 0.5 * (high - low) * np.sin(phi)
    w = w * 0.5 * (high - low) * np.cos(phi)
    s, along = rectangle(left(u), right(u))
    c, d = math.cos(angle), math.sin(angle)
    return (s * c - u[:, None] * d).ravel(), (s * d + u[:, None] * c).ravel(), (along * w[:, None] / math.pi).ravel()


def disc(a: float = 1.0, b: float | None = None, angle: float = 0.0) -> Nodes:
    """A disc or an ellipse around the axis."""
    b = a if b is None else b

    def arc(u: Array) -> Array:
        return a * np.sqrt(np.maximum(1.0 - (u / b) ** 2, 0.0))

    return chords(-b, b, lambda u: -arc(u), arc, angle)


def cat_eye(shift: float, angle: float) -> Nodes:
    """Two unit circles, one of them shifted."""
    high = math.sqrt(1.0 - shift**2 / 4.0)
    return chords(-high, high, lambda u: shift - np.sqrt(1.0 - u**2), lambda u: np.sqrt(1.0 - u**2), angle)


def vanes(pupil: Pupil) -> list[Nodes]:
    """Each vane from the obscuration to the nearer of its ends, for vanes without a corner within their width."""
    assert pupil.spider is not None
    half, eps = 0.5 * pupil.spider.width, pupil.obscuration
    out = []
    for angle in pupil.spider.angles:
        d = np.array([math.cos(angle), math.sin(angle)])
        n = np.array([-d[1], d[0]])

        def end(u: Array, d: Array = d, n: Array = n) -> Array:
            ends = np.sqrt(1.0 - u**2)
            if isinstance(pupil.vignetting, CatEye):
                c, r = np.array(pupil.vignetting.shift), pupil.vignetting.radius
                ends = np.minimum(ends, d @ c + np.sqrt(r**2 - (u - n @ c) ** 2))
            if isinstance(pupil.vignetting, Ellipse):
                a, b, angle = pupil.vignetting.a, pupil.vignetting.b, pupil.vignetting.angle
                turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
                back = turn / np.array([[a], [b]])
                p, q = np.outer(back @ n, u), back @ d
                one, two = q @ p, q @ q
                ends = (-one + np.sqrt(one**2 - two * ((p**2).sum(axis=0) - 1.0))) / two
            return ends

        out.append(chords(-half, half, lambda u: np.sqrt(eps**2 - u**2) if eps else 0.0 * u, end, angle))
    return out


def dense(pupil: Pupil, v: Array, parts: list[tuple[float, Nodes]]) -> NDArray[np.complex128]:
    """U at points v of shape (2, ...) by a sum over all nodes, with a sign for each part."""
    total = np.zeros(v.shape[1:], dtype=np.complex128)
    for sign, (x, y, w) in parts:
        phase = pupil.wavefront.phase(np.hypot(x, y), np.arctan2(y, x))
        strengths = sign * w * np.exp(1j * phase - pupil.apodization * (x**2 + y**2))
        for at in np.ndindex(total.shape):
            total[at] += strengths @ np.exp(-1j * (v[(0, *at)] * x + v[(1, *at)] * y))
    return total


def parts_of(pupil: Pupil) -> list[tuple[float, Nodes]]:
    """The aperture as sums and differences of simple regions."""
    if isinstance(pupil.vignetting, CatEye):
        x, y = pupil.vignetting.shift
        whole = cat_eye(math.hypot(x, y), math.atan2(y, x))
    elif pupil.vignetting is not None:
        whole = disc(pupil.vignetting.a, pupil.vignetting.b, pupil.vignetting.angle)
    else:
        whole = disc()
    parts = [(1.0, whole)] + ([(-1.0, disc(pupil.obscuration))] if pupil.obscuration else [])
    return parts + ([(-1.0, part) for part in vanes(pupil)] if pupil.spider else [])


PUPILS = {
    "disc": Pupil(W),
    "annulus, apodized": Pupil(W, obscuration=0.4, apodization=0.8),
    "four vanes": Pupil(W, obscuration=0.3, spider=Spider.equal(4, 0.05, 0.3)),
    "a bar across": Pupil(W, spider=Spider((0.1), (0.4, 0.4 + math.pi)), apodization=0.5),
    "ellipse": Pupil(W, vignetting=Ellipse(0.9, 0.6, 0.5)),
    "ellipse, obscured": Pupil(W, obscuration=0.35, vignetting=Ellipse(0.5, 0.95, 0.5)),
    "ellipse, obscured, three vanes": Pupil(
        W, obscuration=0.3, vignetting=Ellipse(0.95, 0.6, -0.4), spider=Spider.equal(3, 0.06, 0.1)
    ),
    "cat's eye": Pupil(W, vignetting=CatEye((0.4, -0.3))),
    "narrow cat's eye": Pupil(W, vignetting=CatEye((-1.2, 0.9))),
    "cat's eye, obscured, three vanes": Pupil(
        W, obscuration=0.25, vignetting=CatEye((0.3, 0.2)), spider=Spider.equal(3, 0.03, 0.5), apodization=0.3
    ),
}
SHAPE, PIXEL, CENTER = (5, 8), 0.9, (2.3, 3.4)


def exact(pupil: Pupil) -> Array:
    y, x = np.mgrid[: SHAPE[0], : SHAPE[1]].astype(float)
    v = math.pi * PIXEL * np.stack([x - CENTER[1], y - CENTER[0]])
    parts = parts_of(pupil)
    amplitude = sum(s * (w @ np.exp(-pupil.apodization * (x**2 + y**2))) for s, (x, y, w) in parts)
    return np.asarray(np.abs(dense(pupil, v, parts) / amplitude) ** 2)


def image(pupil: Pupil, method: Method) -> Array:
    return lm.psf(pupil, SHAPE, PIXEL, method=method, center=CENTER, normalize="strehl", dtype=np.float64).values


@pytest.mark.parametrize("name", PUPILS)
def test_the_non_uniform_fft_agrees_with_a_dense_sum_to_every_tolerance(name: str) -> None:
    reference = exact(PUPILS[name])
    for tol in (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-11):
        error = np.abs(image(PUPILS[name], NonuniformFFT(tol)) - reference).max() / reference.max()
        assert error <= tol
    assert error <= 1e-11


@pytest.mark.parametrize("make", [MatrixFourier, lambda n: Fraunhofer(n, edge="grey", padding=1.5)])
@pytest.mark.parametrize("name", list(PUPILS)[2:])
def test_grey_lattices_converge_to_the_dense_sum_by_at_least_the_power_three_halves(name: str, make: Any) -> None:
    reference = exact(PUPILS[name])
    samples = np.array([64, 96, 128, 192, 256, 512])
    errors = [np.sqrt(np.mean((image(PUPILS[name], make(int(n))) - reference) ** 2)) for n in samples]
    assert np.polyfit(np.log(samples), np.log(errors), 1)[0] <= -1.5
    assert errors[-1] <= 4e-4 * reference.max()


def test_a_binary_lattice_converges_more_slowly_than_a_grey_one() -> None:
    pupil, samples = PUPILS["four vanes"], np.arange(70, 520, 50)
    reference = exact(pupil)
    orders = {}
    for edge in ("binary", "grey"):
        errors = [np.sqrt(np.mean((image(pupil, MatrixFourier(int(n), edge)) - reference) ** 2)) for n in samples]
        orders[edge] = np.polyfit(np.log(samples), np.log(errors), 1)[0]
        assert errors[-1] <= (5e-3 if edge == "binary" else 1e-4) * reference.max()
    assert orders["grey"] < orders["binary"] - 0.3
    assert orders["binary"] < -0.7


@pytest.mark.parametrize("eps", [0.0, 0.3])
@pytest.mark.parametrize(
    "options", [{}, {"center": (10.2, 13.7)}, {"integrate": True, "center": (11.0, 10.5)}], ids=repr
)
def test_on_radial_pupils_all_agree_with_the_hankel_transform(eps: float, options: dict[str, Any]) -> None:
    pupil = Pupil(Wavefront(12.0, -3.0, (1.0,)), obscuration=eps, apodization=0.4)

    def values(method: Method) -> Array:
        return lm.psf(pupil, (24, 21), 0.8, method=method, dtype=np.float64, **options).values

    reference = values(Hankel(1e-12))
    assert np.abs(values(NonuniformFFT(1e-9)) - reference).max() <= 1e-9 * reference.max()
    assert np.abs(values(NonuniformFFT()) - values(NijboerZernike())).max() <= 2e-6 * reference.max()
    assert np.abs(values(MatrixFourier(768)) - reference).max() <= 2e-3 * reference.max()


@given(
    st.floats(0.05, 1.0), st.floats(0.05, 1.0), st.floats(-4.0, 4.0), st.floats(-9.0, 9.0), st.floats(-9.0, 9.0)
)  # fmt: skip
def test_an_ellipse_without_aberration_is_a_scaled_airy_pattern(
    a: float, b: float, angle: float, row: float, column: float
) -> None:
    pupil = Pupil(vignetting=Ellipse(a, b, angle))
    assert pupil.area == pytest.approx(a * b, rel=1e-12)
    found = lm.psf(
        pupil, 5, 0.8, center=(row, column), normalize="strehl", method=NonuniformFFT(1e-7), dtype=np.float64
    )
    y, x = np.meshgrid(found.grid.y * math.pi, found.grid.x * math.pi, indexing="ij")
    s = np.hypot(a * (x * math.cos(angle) + y * math.sin(angle)), b * (y * math.cos(angle) - x * math.sin(angle)))
    expected = np.where(s < 1e-9, 1.0, 2.0 * j1(s) / np.maximum(s, 1e-9)) ** 2
    # Of U the error is at most an eighth of the tolerance, over the peak; of I that times 2 |U|.
    assert np.abs(found.values - expected).max() <= 0.25e-7 * math.sqrt(expected.max()) + 1e-14


def test_a_vane_takes_away_the_field_of_a_rectangle() -> None:
    # Its ends are arcs, which differ from straight ones by w^3 / 24 (1 + 1 / eps) in area.
    width, eps, angle = 0.02, 0.3, 0.7
    bare, held = Pupil(obscuration=eps), Pupil(obscuration=eps, spider=Spider(width, [angle]))
    v = np.stack(np.meshgrid(np.linspace(-20, 20, 7), np.linspace(-15, 25, 6)))
    along, across = v[0] * math.cos(angle) + v[1] * math.sin(angle), v[1] * math.cos(angle) - v[0] * math.sin(angle)
    length = 1.0 - eps
    strip = (
        width * length / math.pi * np.sinc(along * length / (2 * math.pi)) * np.sinc(across * width / (2 * math.pi))
    )
    strip = strip * np.exp(-0.5j * (1.0 + eps) * along)

    def field(pupil: Pupil) -> Any:
        return dense(pupil, v, [(1.0, pupil.rule(80))])

    assert np.abs(field(bare) - field(held) - strip).max() <= width**3 / 24 * (1 + 1 / eps) / math.pi


def test_light_that_vanes_stop_and_light_that_passes_make_up_the_whole_field() -> None:
    whole, held = PUPILS["annulus, apodized"], Pupil(W, obscuration=0.4, apodization=0.8, spider=Spider.equal(4, 0.1))
    v = np.stack(np.meshgrid(np.linspace(-9, 9, 5), np.linspace(-8, 7, 4)))
    stopped = dense(held, v, [(1.0, part) for part in vanes(held)])
    through = [dense(pupil, v, [(1.0, pupil.rule(120))]) for pupil in (whole, held)]
    assert np.abs(through[1] + stopped - through[0]).max() <= 1e-12


def test_all_light_of_a_mask_is_in_one_period_of_its_image() -> None:
    rng = np.random.default_rng(3)
    mask = Mask.sample(lambda x, y: rng.uniform(size=(20, 20)) * (np.hypot(x, y) < 0.8), side=20)
    pupil = Pupil(Wavefront(1.0, nonradial={(2, 2): 1.0}), mask=mask)
    for shape, method in ((41, NonuniformFFT(1e-9)), (40, MatrixFourier(20))):
        answer = lm.psf(pupil, shape, 20 / shape, method=method, dtype=np.float64)
        assert answer.values.sum() == pytest.approx(1.0, abs=1e-8)


@pytest.mark.parametrize("method", [NonuniformFFT(1e-9), MatrixFourier(32)], ids=repr)
def test_a_mask_of_a_rectangle_is_a_product_of_dirichlet_kernels(method: Method) -> None:
    # Columns 14 to 19 and rows 10 to 23 of 32, all within the rim.
    mask = np.zeros((32, 32))
    mask[10:24, 14:20] = 0.5
    answer = lm.psf(Pupil(mask=Mask(mask)), 15, 0.7, method=method, normalize="strehl", dtype=np.float64)

    def kernel(v: Array, count: int) -> Array:
        return np.where(v == 0, 1.0, np.sin(count * v / 32) / (count * np.where(v == 0, 1.0, np.sin(v / 32))))

    expected = np.outer(kernel(math.pi * answer.grid.y, 14), kernel(math.pi * answer.grid.x, 6)) ** 2
    assert np.abs(answer.values - expected).max() <= 1e-8


def test_a_mask_is_the_same_sum_by_either_method_whatever_else_narrows_the_aperture() -> None:
    mask = Mask.sample(lambda x, y: 0.5 + 0.5 * np.cos(3 * x + y), side=64)
    pupil = Pupil(
        W, mask=mask, obscuration=0.2, apodization=0.5, vignetting=CatEye((0.3, 0.1)), spider=Spider(0.1, [1])
    )
    a, b = (lm.psf(pupil, (9, 12), 0.8, method=m, dtype=np.float64) for m in (NonuniformFFT(1e-9), MatrixFourier(64)))
    assert lm.peak_error(a, b) <= 1e-9


@pytest.mark.parametrize("threads", [1, 2])
def test_threads_do_not_change_the_image(threads: int) -> None:
    pupil = PUPILS["four vanes"]
    one, more = (lm.psf(pupil, 700, 0.3, threads=k, dtype=np.float64) for k in (None, threads))
    assert lm.peak_error(one, more) <= 1e-8


def test_a_stack_has_the_images_of_its_pupils() -> None:
    stack = Pupil(Wavefront([[0.0, 9.0]], nonradial={(3, 1): [[1.0], [5.0]]}), spider=Spider.equal(4, 0.05))
    for method in (NonuniformFFT(1e-8), MatrixFourier(64), Fraunhofer(64)):
        images = lm.psf(stack, 9, 0.7, method=method, dtype=np.float64)
        assert images.shape == (2, 2, 9, 9)
        for i in np.ndindex(2, 2):
            assert lm.peak_error(images[i], lm.psf(stack[i], 9, 0.7, method=method, dtype=np.float64)) <= 1e-8


@pytest.mark.parametrize("name", [n for n, kind in METHODS.items() if not kind.any_aperture])
@pytest.mark.parametrize(
    "shape", [{"spider": Spider(0.1, [0.0, 0.1])}, {"vignetting": Ellipse(1, 0.5)}, {"mask": Mask([[1, 0]] * 2)}]
)
def test_methods_for_circles_refuse_other_apertures_and_say_what_takes_them(name: str, shape: dict[str, Any]) -> None:
    lens = lm.Lens(focal_length=0.05, f_number=8.0, wavelength=5e-7)
    pupil = Pupil(wavelength=5e-7, f_number=8.0, geometry=lens.pupil().geometry, **shape)
    with pytest.raises(
        ValueError, match=f"{METHODS[name].__name__} supports circular and annular apertures only; .*leave method out"
    ):
        lm.psf(pupil, 5, 1e-6, method=METHODS[name]())


def test_the_non_uniform_fft_has_a_bound_and_refuses_what_double_precision_does_not_hold() -> None:
    bound = lm.psf(PUPILS["cat's eye"], 5, 0.5).error_bound
    assert bound is not None
    assert bound <= 1e-6
    dim = Pupil(Wavefront(300.0), spider=Spider(0.1, [0.0]))
    with pytest.raises(lm.ToleranceError, match="tol=1e-11 cannot be met in double precision"):
        lm.psf(dim, 5, 0.5, method=NonuniformFFT(1e-11))
