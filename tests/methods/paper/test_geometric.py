"""Ray optics: uniform disks, caustics, and no light lost."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from numpy.typing import NDArray

import lommel as lm
from lommel import Pupil, Wavefront
from lommel.paper import Geometric


def _image(pupil: Pupil, shape: int | tuple[int, int], pixel: float, rings: int = 8) -> NDArray[np.float64]:
    method = Geometric(rings=rings)
    return lm.psf(pupil, shape, pixel, method=method, normalize="strehl", dtype=np.float64).values


def _radii(shape: tuple[int, int], pixel: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return v at the nearest and the farthest point of each pixel."""
    height, width = shape
    y = np.abs(np.arange(height) - height // 2)[:, None] * 1.0
    x = np.abs(np.arange(width) - width // 2) * 1.0
    nearest = np.hypot(np.maximum(y - 0.5, 0), np.maximum(x - 0.5, 0))
    return math.pi * pixel * nearest, math.pi * pixel * np.hypot(y + 0.5, x + 0.5)


@pytest.mark.parametrize("rings", [1, 8, 64])
@pytest.mark.parametrize("defocus", [2.0, -10.0, 60.0])
def test_defocus_makes_a_uniform_disk_with_the_light_of_the_aperture_spread_over_it(
    defocus: float, rings: int
) -> None:
    """``1 / (4 C_d^2)`` of the clear peak, within ``v = 4 |C_d|``, and nothing beyond."""
    edge = 4 * abs(defocus)
    pixel = edge / math.pi / 14.3
    image = _image(Pupil(Wavefront(defocus)), (41, 38), pixel, rings)
    nearest, farthest = _radii((41, 38), pixel)
    # The light of the last ring may be spread over the whole of it.
    ring = math.pi * pixel / rings
    inside, outside = farthest <= edge - ring, nearest >= edge + ring
    assert inside.sum() > 300
    assert outside.sum() > 300
    assert image[inside] * 4 * defocus**2 == pytest.approx(np.ones(inside.sum()), rel=1e-3)
    assert np.all(np.abs(image[outside]) <= 1e-15 * image.max())
    between = image[~inside & ~outside] * 4 * defocus**2
    assert np.all((between >= -1e-12) & (between <= 1.001))


@pytest.mark.parametrize("obscuration", [0.0, 0.3, 0.9])
@pytest.mark.parametrize(
    "wavefront",
    [
        Wavefront(10.0),
        Wavefront(-10.0, -5.0),
        Wavefront(-10.0, 10.0),
        Wavefront(20.0, -7.0),
        Wavefront(3, 2, [1, -2]),
    ],
)
@pytest.mark.parametrize(("pixels", "rings"), [(40, 8), (7, 3), (1.1, 1)])
def test_a_window_as_large_as_the_blur_holds_all_the_light(
    wavefront: Wavefront, obscuration: float, pixels: float, rings: int
) -> None:
    pupil = Pupil(wavefront, obscuration=obscuration)
    radius = float(pupil.geometric_radius())
    pixel, side = 2 * radius / pixels, 2 * math.ceil(pixels / 2) + 3
    method = Geometric(rings=rings)
    answer = lm.psf(pupil, (side, side + 1), pixel, method=method, dtype=np.float64)
    assert float(answer.energy) == pytest.approx(1.0, rel=0, abs=1e-12)
    assert float(answer.values.sum()) == pytest.approx(1.0, rel=0, abs=1e-12)
    single = lm.psf(pupil, (side, side + 1), pixel, method=method, dtype=np.float32)
    assert float(single.energy) == pytest.approx(1.0, rel=0, abs=1e-7)


amounts = st.floats(-50, 50, allow_subnormal=False)


@given(
    amounts,
    amounts,
    st.sampled_from([0.0, 0.33, 0.8]),
    st.floats(0.2, 5.0),
    st.tuples(st.integers(1, 30), st.integers(1, 30)),
)
def test_light_is_never_negative_nor_more_than_there_is(
    defocus: float, spherical: float, obscuration: float, pixel: float, shape: tuple[int, int]
) -> None:
    pupil = Pupil(Wavefront(defocus, spherical), obscuration=obscuration)
    answer = lm.psf(pupil, shape, pixel, method=Geometric(), dtype=np.float64)
    assert answer.values.min() >= 0.0
    assert 0.0 <= float(answer.energy) <= 1 + 1e-12
    assert answer.error_bound is None


@pytest.mark.parametrize("shape", [(11, 11), (4, 17), (1, 1)])
def test_a_window_inside_the_disk_holds_its_share(shape: tuple[int, int]) -> None:
    answer = lm.psf(Pupil(Wavefront(40.0)), shape, 1.0, method=Geometric(), dtype=np.float64)
    share = shape[0] * shape[1] * math.pi**2 / (math.pi * 160.0**2)
    assert float(answer.energy) == pytest.approx(share, rel=2e-4)


@pytest.mark.parametrize("obscuration", [0.0, 0.5])
@pytest.mark.parametrize("shape", [(1, 1), (5, 5), (4, 6)])
def test_in_focus_all_light_falls_into_the_central_pixel(shape: tuple[int, int], obscuration: float) -> None:
    values = lm.psf(Pupil(obscuration=obscuration), shape, 0.5, method=Geometric(), dtype=np.float64).values
    centre = shape[0] // 2, shape[1] // 2
    assert values[centre] == pytest.approx(1.0, rel=1e-14)
    values = values.copy()
    values[centre] = 0.0
    assert np.all(values == 0.0)


@pytest.mark.parametrize("tiny", [1e-300, 2e-313, 5e-324])
def test_an_aberration_next_to_nothing_is_none(tiny: float) -> None:
    in_focus = _image(Pupil(), 3, 0.5)
    for wavefront in (Wavefront(tiny), Wavefront(0.0, -tiny)):
        assert np.array_equal(_image(Pupil(wavefront), 3, 0.5), in_focus)


@pytest.mark.parametrize(("defocus", "obscuration"), [(20.0, 0.5), (-35.0, 0.33), (30.0, 0.9)])
def test_an_obscured_aperture_makes_a_ring_with_a_dark_centre(defocus: float, obscuration: float) -> None:
    edge = 4 * abs(defocus)
    pixel = edge / math.pi / 30
    image = _image(Pupil(Wavefront(defocus), obscuration=obscuration), 67, pixel)
    nearest, farthest = _radii((67, 67), pixel)
    ring = math.pi * pixel / 8
    dark = (farthest <= obscuration * edge - ring) | (nearest >= edge + ring)
    bright = (nearest >= obscuration * edge + ring) & (farthest <= edge - ring)
    assert dark[33, 33]
    assert np.all(np.abs(image[dark]) <= 1e-12 * image.max())
    # The Strehl normalisation divides by the square of the clear area.
    level = 1 / (4 * defocus**2 * (1 - obscuration**2) ** 2)
    assert np.all(np.abs(image[bright] / level - 1) <= 1e-3)
    assert bright.sum() > 100


@pytest.mark.parametrize(
    ("defocus", "spherical", "sixth"), [(10.0, 5.0, 0.0), (-20.0, -3.0, 0.0), (0.0, 12.0, 0.0), (5.0, 2.0, 3.0)]
)
def test_where_rays_do_not_cross_the_density_is_that_of_one_ray(
    defocus: float, spherical: float, sixth: float
) -> None:
    """``I(v) = 4 rho / (v dv/drho)`` for the ray with ``v = |dPhi/drho|``; light within v is ``rho^2``."""
    pupil = Pupil(Wavefront(defocus, spherical, [sixth]))
    edge = math.pi * float(pupil.geometric_radius())
    pixel, side = edge / math.pi / 60.2, 131
    image = _image(pupil, side, pixel, 16)
    rho = np.linspace(0.0, 1.0, 200_001)[1:]
    height = np.abs(4 * defocus * rho + 4 * spherical * rho**3 + 6 * sixth * rho**5)
    slope = np.abs(4 * defocus + 12 * spherical * rho**2 + 30 * sixth * rho**4)
    columns = np.arange(6, 58)
    v = math.pi * pixel * columns
    density = np.interp(v, height, 4 * rho / (height * slope))
    # The pixel averages over its square, of which the density is a smooth function.
    assert image[side // 2, side // 2 + columns] == pytest.approx(density, rel=0.01)
    answer = lm.psf(pupil, side, pixel, method=Geometric(rings=16), dtype=np.float64)
    for part in (0.25, 0.5, 0.8, 1.02):
        within = float(np.interp(part * edge, height, rho) ** 2)
        inside = np.hypot(answer.grid.x, answer.grid.y[:, None]) <= part * edge / math.pi
        assert float(answer.values[inside].sum()) == pytest.approx(within, abs=0.01)


@pytest.mark.parametrize("obscuration", [0.0, 0.2])
def test_where_rays_cross_their_densities_add_up_to_the_caustic(obscuration: float) -> None:
    """Balanced spherical aberration: up to three rays meet inside the caustic, one outside."""
    defocus, spherical = -30.0, 25.0
    pupil = Pupil(Wavefront(defocus, spherical), obscuration=obscuration)
    pixel, side = 0.2, 181
    image = _image(pupil, side, pixel, 16) * pupil.area**2
    rho = np.linspace(obscuration, 1.0, 400_001)
    height = 4 * defocus * rho + 4 * spherical * rho**3
    turn = math.sqrt(-defocus / (3 * spherical))
    caustic = abs(4 * defocus * turn + 4 * spherical * turn**3)
    rim = {float(abs(height[-1])), float(abs(height[0]))}
    checked = 0
    for column in range(5, 85):
        v = math.pi * pixel * column
        if min(abs(v - edge) for edge in (caustic, *rim)) < 6 * math.pi * pixel:
            continue
        expected = 0.0
        for target in (v, -v):
            for i in np.flatnonzero((height[:-1] - target) * (height[1:] - target) < 0):
                slope = 4 * defocus + 12 * spherical * rho[i] ** 2
                expected += 4 * rho[i] / (v * abs(slope))
        checked += 1
        assert image[side // 2, side // 2 + column] == pytest.approx(expected, rel=0.02, abs=1e-9)
    assert checked > 40


@given(amounts, amounts, st.sampled_from([0.0, 0.5]), st.floats(0.3, 3.0))
def test_small_pixels_hold_together_what_a_large_one_does(
    defocus: float, spherical: float, obscuration: float, pixel: float
) -> None:
    """Three by three pixels against one, with rings of the same width."""
    assume(abs(defocus) + abs(spherical) > 0.1)
    pupil = Pupil(Wavefront(defocus, spherical), obscuration=obscuration)
    coarse = _image(pupil, 9, pixel, 24)
    fine = _image(pupil, 27, pixel / 3, 8).reshape(9, 3, 9, 3).mean(axis=(1, 3))
    assert np.abs(fine - coarse).max() <= 1e-11 * coarse.max() + 1e-15


def test_rings_far_narrower_than_the_usual_cells_of_the_aperture_are_all_filled() -> None:
    """Eight thousand v of blur over rings of 0.3: the disk stays uniform to the last one."""
    image = _image(Pupil(Wavefront(2000.0)), (3, 300), 0.1, 1)
    assert image * 4 * 2000.0**2 == pytest.approx(np.ones_like(image), rel=0.05)
