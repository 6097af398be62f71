"""Cat's eyes and shading over the field: closed forms, single places, and grids of them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy import special

import lommel as lm
from lommel.field.maps import Foreshortening, Shading, Vignetting
from lommel.optics.pupil import FieldPupil

EDGES = Vignetting([0.0, 10e-3, 20e-3], shift=[0.0, 0.2, 0.8], radius=[1.0, 1.0, 1.1])
PLAIN = lm.FieldMap.from_seidel(20e-3, W131=1.0, W222=0.5, wavelength=550e-9, f_number=2.8)
FIELD = PLAIN.seen_through(EDGES, Shading.cos4(50e-3))
SAMPLED = lm.methods.MatrixFourier(samples=64)


def lens(d: float) -> float:
    """Return what two discs of radius 1, d apart, share, over one of them."""
    return (2.0 * math.acos(0.5 * d) - 0.5 * d * math.sqrt(4.0 - d * d)) / math.pi


@pytest.mark.parametrize("angle", [0.0, 0.7, 2.5, -1.2])
@pytest.mark.parametrize("height", [0.0, 4e-3, 10e-3])
def test_two_circles_let_through_what_they_share(height, angle):
    x, y = height * math.cos(angle), height * math.sin(angle)
    expected = lens(20.0 * height) / (1.0 + (height / 50e-3) ** 2) ** 2
    assert float(FIELD.illumination(x, y)) == pytest.approx(expected, rel=1e-9)
    assert float(FIELD.working_f_number(x, y)) == pytest.approx(2.8 / math.sqrt(expected), rel=1e-9)


def test_a_cat_s_eye_moves_along_the_direction_of_its_place():
    eye = FIELD.pupil(0.0, 15e-3).vignetting
    assert eye.shift == pytest.approx((0.0, 0.5))
    assert eye.radius == pytest.approx(1.05)
    assert Vignetting([0.0, 1.0], [0.0, 0.1], 2.0).at(0.5, 0.5) is None


def test_measured_shading_is_linear_between_heights():
    field = PLAIN.seen_through(shading=Shading([0.0, 10e-3, 20e-3], [1.0, 0.9, 0.5]))
    assert field.illumination([0.0, 5e-3, 15e-3], 0.0) == pytest.approx([1.0, 0.95, 0.7])
    assert PLAIN.illumination(3e-3, 0.0) == 1.0


def test_a_grid_has_the_cat_s_eye_of_each_place(tmp_path):
    options = {"sensor": (20e-3, 20e-3), "shape": 7, "pixel": 2e-6, "method": SAMPLED}
    grid = FIELD.grid(2, 3, **options)
    assert isinstance(grid.psf.pupil, FieldPupil)
    for i, j in [(0, 0), (1, 1), (1, 2)]:
        alone = FIELD.psf(grid.x[j], grid.y[i], 7, 2e-6, method=SAMPLED)
        assert np.array_equal(grid[i, j].values, alone.values)
        assert grid[i, j].pupil == alone.pupil
        assert float(grid[i, j].energy) == pytest.approx(float(grid.psf.energy[i, j]))
    assert not np.allclose(grid.values, PLAIN.grid(2, 3, **options).values)
    grid.save(tmp_path / "grid.npz")
    back = lm.PSFGrid.load(tmp_path / "grid.npz")
    assert np.array_equal(back.values, grid.values)
    assert back.psf.pupil == grid.psf.pupil


def test_an_illuminated_grid_darkens_as_the_light_does():
    field = PLAIN.seen_through(shading=Shading.cos4(20e-3))
    options = {"sensor": (20e-3, 20e-3), "shape": 9, "pixel": 2e-6}
    plain, dark = field.grid(3, 3, **options), field.grid(3, 3, illuminated=True, **options)
    light = field.illumination(plain.x, plain.y[:, None])
    assert dark.values == pytest.approx(plain.values * light[..., None, None], rel=1e-6)
    # How much of its own light is in the window stays.
    assert dark.psf.energy == pytest.approx(plain.psf.energy)


@pytest.mark.parametrize(
    ("ask", "message"),
    [
        (lambda: Vignetting([0.0, 1.0], [0.1, 0.2]), "shift must have a value for each height"),
        (lambda: FIELD.pupil([0.0, 1e-3], 0.0), "psf accepts arrays"),
        (lambda: FIELD.illumination(21e-3, 0.0), "beyond the last height"),
    ],
)
def test_what_cannot_be_is_told(ask, message):
    with pytest.raises((TypeError, ValueError), match=message):
        ask()


def test_a_stack_of_different_apertures_is_a_pupil_of_psf_too():
    stack = FIELD.psf([0.0, 15e-3], [[1e-3], [-8e-3]], 7, 2e-6)
    assert stack.pupil.shape == (2, 2)
    place = np.empty((2, 2, 9, 9), np.float32)
    again = lm.Plan(9, 2e-6)(stack.pupil, out=place)
    assert again.values is place
    assert np.array_equal(again.values[1, 1], FIELD.psf(15e-3, -8e-3, 9, 2e-6).values)
    assert again.pupil == stack.pupil
    assert again.error_bound == max(lm.psf(one, 9, 2e-6).error_bound for one in stack.pupil.pupils)
    assert again.scale.shape == (2, 2)
    with pytest.raises(ValueError, match="derivatives need pupils of one aperture"):
        lm.psf(stack.pupil, 9, 2e-6, derivatives=["defocus"])
    with pytest.raises(ValueError, match="center must be one"):
        lm.psf(stack.pupil, 9, 2e-6, center=([4.0, 5.0], [4.0, 5.0]))


@pytest.mark.parametrize("obscuration", [0.0, 0.4])
def test_a_foreshortened_aperture_has_the_stretched_airy_pattern_and_the_light_of_its_area(obscuration):
    flat = lm.FieldMap.from_seidel(20e-3, wavelength=500e-9, f_number=4.0, obscuration=obscuration)
    field = flat.seen_through(Foreshortening([0.0, 20e-3], along=[1.0, 0.7], across=[1.0, 0.9]))
    angle, share = 0.8, 0.5**2  # of the squared height
    a, b = 1.0 - 0.3 * share, 1.0 - 0.1 * share
    place = 10e-3 * math.cos(angle), 10e-3 * math.sin(angle)
    assert field.pupil(*place).transmission == pytest.approx(a * b * (1.0 - obscuration**2), rel=1e-9)
    assert float(field.illumination(*place)) == pytest.approx(a * b, rel=1e-9)
    found = field.psf(*place, 15, 0.8e-6, integrate=False, dtype="float64")
    x, y = np.meshgrid(*2 * (np.pi * 0.4 * (np.arange(15) - 7) + 1e-9,))
    v = np.hypot(a * (x * math.cos(angle) + y * math.sin(angle)), b * (y * math.cos(angle) - x * math.sin(angle)))
    airy = (2.0 * special.j1(v) / v - obscuration * 2.0 * special.j1(obscuration * v) / v) ** 2
    np.testing.assert_allclose(found.values / found.values.max(), airy / airy.max(), rtol=0.0, atol=2e-6)
    assert found.error_bound < 1e-6
    assert field.pupil(0.0, 0.0) == flat.pupil(0.0, 0.0)


def test_foreshortening_of_bad_axes_or_of_an_aperture_with_parts_is_refused():
    seen = Foreshortening([0.0, 20e-3], [1.0, 0.8], [1.0, 0.9])
    with pytest.raises(ValueError, match="lies beyond the last height"):
        seen.at(0.0, 21e-3)
    vanes = lm.FieldMap.from_seidel(20e-3, aperture=lm.Pupil(spider=lm.Spider(0.02, [0.0, 2.0])))
    with pytest.raises(ValueError, match="must not be a Foreshortening unless the aperture is circular"):
        vanes.seen_through(seen)


MEASURES = {
    "energy": lambda psf: psf.energy,
    "strehl": lambda psf: psf.strehl,
    "peak_strehl": lambda psf: psf.peak_strehl,
    "centroid": lambda psf: psf.centroid,
    "encircled_energy": lambda psf: psf.encircled_energy([2e-6, 4e-6]),
    "ensquared_energy": lambda psf: psf.ensquared_energy(3e-6),
    "energy_diameter": lambda psf: psf.energy_diameter(0.5),
    "fwhm": lambda psf: psf.fwhm("x"),
    "otf": lambda psf: psf.otf([30e3, 60e3], [[0.0], [20e3]]),
    "mtf": lambda psf: psf.mtf(36e3),
    "lm.mtf": lambda psf: lm.mtf(psf, 36e3),
    "lm.mtf_frequency": lambda psf: lm.mtf_frequency(psf, 0.5),
}


@pytest.mark.parametrize("name", MEASURES)
@pytest.mark.parametrize("seen", [EDGES, Foreshortening([0.0, 20e-3], [1.0, 0.7], [1.0, 0.9])])
def test_measures_of_a_grid_of_different_apertures_are_those_of_its_psfs(seen, name):
    grid = PLAIN.seen_through(seen).grid(2, 2, sensor=(16e-3, 20e-3), shape=17, pixel=2e-6)
    measure = MEASURES[name]
    together = measure(grid)
    assert np.shape(together)[:2] == (2, 2)
    for place in np.ndindex(2, 2):
        np.testing.assert_array_equal(together[place], measure(grid[place]))
