"""Encircled and ensquared energy."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import special

import lommel as lm
from lommel import Pupil, Wavefront
from lommel.measures.energy import encircled, radial_energy
from lommel.methods import Hankel, Method, NijboerZernike, NonuniformFFT
from lommel.paper import Fraunhofer, LommelSeries

PUPILS = {
    "in focus": Pupil(),
    "defocused": Pupil(Wavefront(6.0)),
    "spherical": Pupil(Wavefront(-4.0, 7.0)),
    "obscured": Pupil(Wavefront(3.0, 1.0), obscuration=0.4),
}


def _airy_energy(v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return Rayleigh's ``1 - J0^2 - J1^2``."""
    return 1 - special.j0(v) ** 2 - special.j1(v) ** 2


def _mean(method: Method, pupil: Pupil, shape: tuple[int, int], pixel: float, parts: int) -> float:
    """Return the light in the window as the sum over pixels cut into parts x parts."""
    fine = (shape[0] * parts, shape[1] * parts)
    return float(lm.psf(pupil, fine, pixel / parts, method=method, dtype=np.float64).values.sum())


@pytest.mark.parametrize("method", [NijboerZernike(), NijboerZernike(tol=1e-10), Hankel(), LommelSeries()])
def test_the_encircled_energy_of_the_airy_pattern_is_that_of_rayleigh(method: Method) -> None:
    radius = np.array([[0.0, 1e-6, 0.1], [1.22, 2.233, 40.0]])
    energy = lm.psf(Pupil(), 1, 0.3, method=method, dtype=np.float64).encircled_energy(radius)
    assert energy.shape == (2, 3)
    assert energy == pytest.approx(_airy_energy(math.pi * radius), rel=0, abs=max(method.tol, 1e-13))


def test_the_dark_rings_of_the_airy_pattern_hold_84_and_91_percent() -> None:
    answer = lm.psf(Pupil(wavelength=550e-9, f_number=2.8), 5, 1e-6)
    first = answer.pupil.airy_radius
    second = first * special.jn_zeros(1, 2)[1] / special.jn_zeros(1, 1)[0]
    assert answer.encircled_energy([first, second], of="optics") == pytest.approx([0.8378, 0.9099], abs=1e-4)


@pytest.mark.parametrize("name", PUPILS)
def test_the_encircled_energy_is_the_integral_of_the_profile(name: str) -> None:
    pupil, radii = PUPILS[name], np.array([0.2, 1.5, 4.0, 9.0])
    answer = lm.psf(pupil, 3, 0.5, method=NijboerZernike(tol=1e-9))
    x, w = np.polynomial.legendre.leggauss(80)
    for radius, energy in zip(radii, answer.encircled_energy(radii), strict=True):
        v = 0.5 * math.pi * radius * (1 + x)
        light = np.sum(0.5 * math.pi * radius * w * v * np.abs(Hankel().field(pupil, v)) ** 2) / (2 * pupil.area)
        assert energy == pytest.approx(light, rel=0, abs=1e-8)


def test_other_methods_have_the_encircled_energy_of_what_they_compute() -> None:
    pupil = Pupil(Wavefront(12.0))
    answer = lm.psf(pupil, 129, 0.35, method=Fraunhofer(samples=256, edge="grey"), dtype=np.float64)
    exact = lm.psf(pupil, 1, 1.0).encircled_energy([5.0, 10.0, 20.0])
    energy = answer.encircled_energy([5.0, 10.0, 20.0], of="optics")
    assert energy == pytest.approx(exact, abs=1e-3)
    assert answer.encircled_energy(0.0) == 0.0


@pytest.mark.parametrize("name", PUPILS)
def test_the_energy_of_a_window_tends_to_one_as_it_grows(name: str) -> None:
    """What is left outside falls like 1 / v: ``4 (1 + eps) / (pi v)`` of ``2 (1 - eps^2)`` beyond the circle v."""
    pupil = PUPILS[name]
    missing = []
    for side in (65, 129, 257, 513, 1025):
        answer = lm.psf(pupil, side, 0.5)
        missing.append(1 - float(answer.energy))
    missing = np.array(missing)
    assert np.all(missing > 0)
    # Over a square of half side a the mean of 1 / v is that of cos(angle) / a, which is 2 sqrt(2) / (pi a).
    half = 0.25 * math.pi * np.array([65, 129, 257, 513, 1025])
    tail = 2 * (1 + pupil.obscuration) / (math.pi * pupil.area) * 2 * math.sqrt(2) / (math.pi * half)
    assert missing[2:] == pytest.approx(tail[2:], rel=0.02)


@pytest.mark.parametrize(("shape", "pixel"), [((9, 9), 0.6), ((7, 11), 0.5), ((1, 1), 1.0), ((3, 33), 0.3)])
@pytest.mark.parametrize("name", PUPILS)
def test_the_energy_of_a_window_is_the_sum_over_ever_smaller_pixels(
    name: str, shape: tuple[int, int], pixel: float
) -> None:
    pupil = PUPILS[name]
    energy = float(lm.psf(pupil, shape, pixel, method=Hankel()).energy)
    # Odd parts keep the window where it is; the midpoint rule errs by h^2, so two of them give the limit.
    coarse, fine = (_mean(NijboerZernike(1e-10), pupil, shape, pixel, parts) for parts in (21, 63))
    limit = fine + (fine - coarse) / 8
    assert energy == pytest.approx(limit, rel=1e-6)
    assert abs(energy - fine) < abs(energy - coarse) / 8


@pytest.mark.parametrize("shape", [(8, 8), (7, 10), (2, 1)])
def test_the_window_of_an_even_image_reaches_half_a_pixel_further_up_and_left(shape: tuple[int, int]) -> None:
    """Its four quadrants are those of odd images, each a quarter of such a window."""
    pupil, pixel = PUPILS["spherical"], 0.45
    height, width = shape
    tall, flat = 2 * (height // 2) + 1, 2 * ((height - 1) // 2) + 1
    wide, slim = 2 * (width // 2) + 1, 2 * ((width - 1) // 2) + 1
    odd = [float(lm.psf(pupil, (h, w), pixel, method=Hankel()).energy) for h in (tall, flat) for w in (wide, slim)]
    assert float(lm.psf(pupil, shape, pixel, method=Hankel()).energy) == pytest.approx(sum(odd) / 4, rel=1e-12)


@pytest.mark.parametrize("pixel", [1e-4, 3e-3, 0.05])
def test_the_energy_of_a_long_thin_window_is_that_of_a_line(pixel: float) -> None:
    """One row of pixels: the pixel times the integral along it, where the pixel is small."""
    pupil, length = PUPILS["in focus"], 1001
    x, w = np.polynomial.legendre.leggauss(120)
    half = 0.5 * length * math.pi * pixel
    line = np.sum(half * w * np.abs(Hankel().field(pupil, np.abs(half * x))) ** 2)
    energy = float(lm.psf(pupil, (1, length), pixel, method=Hankel()).energy)
    assert energy == pytest.approx(line * math.pi * pixel / (4 * math.pi), rel=1e-7 + (math.pi * pixel) ** 2 / 24)


RADII = np.array([0.0, 0.3, 1.0, 2.5, 6.0, 15.0])


@pytest.mark.parametrize("eps", [0.0, 0.4])
@pytest.mark.parametrize("tol", [1e-5, 1e-8, 1e-10])
def test_weights_on_pixels_integrate_a_radial_image_within_the_bound(eps, tol):
    radial = lm.Pupil(lm.Wavefront(4.0, 2.0), obscuration=eps)
    # So little astigmatism that it changes nothing, but that the pupil goes the way of all others.
    nearly = lm.Pupil(radial.wavefront + lm.Wavefront(nonradial={(2, 2): 1e-14}), obscuration=eps)
    exact = radial_energy(Hankel(), radial, RADII)
    found = encircled(nearly, RADII, method=NijboerZernike(tol))
    assert np.abs(found.fraction - exact).max() <= found.error
    assert found.error < 3.1e-8 + 2e3 * tol
    assert found.fraction[0] == 0.0
    if tol == 1e-10:
        # What is claimed of the weights themselves.
        np.testing.assert_allclose(found.fraction, exact, atol=3e-8)


def test_a_tilted_airy_pattern_has_the_energy_of_a_circle_off_its_centre():
    shift, radius = 0.8, 1.5
    pupil = lm.Pupil(lm.Wavefront(nonradial={(1, 1): np.pi * shift}))
    found = encircled(pupil, [radius], method=NijboerZernike(1e-10))
    # In polar coordinates about the peak: the arc of each ring that the circle holds.
    x, w = np.polynomial.legendre.leggauss(400)
    low, high = radius - shift, radius + shift
    r = low + (high - low) * (0.5 - 0.5 * np.cos(0.5 * np.pi * (x + 1)))
    jacobian = 0.25 * np.pi * (high - low) * np.sin(0.5 * np.pi * (x + 1))
    arc = np.arccos(np.clip((r**2 + shift**2 - radius**2) / (2 * r * shift), -1, 1)) / np.pi
    intensity = Hankel().profile(lm.Pupil(), np.pi * np.sort(r)).values[0]
    ring = w * jacobian * 0.5 * np.pi**2 * r * intensity[np.argsort(np.argsort(r))]
    inner = float(radial_energy(Hankel(), lm.Pupil(), low))
    assert found.fraction[0] == pytest.approx(inner + float(ring @ arc), abs=1e-7)


def test_an_aperture_with_vanes_has_energies_with_a_bound():
    pupil = lm.Pupil(obscuration=0.3, spider=lm.Spider.equal(4, 0.1))
    found = encircled(pupil, [1.0, 3.0])
    tighter = encircled(pupil, [1.0, 3.0], method=NonuniformFFT(1e-10))
    assert np.abs(found.fraction - tighter.fraction).max() < found.error < 1e-4
    # The middle of pixels of a twentieth, summed as if each held its value all over it.
    image = lm.psf(pupil, 161, 0.05, method=NonuniformFFT(1e-8))
    within = np.hypot(*np.meshgrid(image.grid.x, image.grid.y)) < np.array([1.0, 3.0])[:, None, None]
    np.testing.assert_allclose(found.fraction, (image.values * within).sum(axis=(1, 2)), atol=1e-2)


def test_a_stack_is_refused():
    with pytest.raises(ValueError, match="pupil must be a single one"):
        encircled(lm.Pupil(lm.Wavefront([1.0, 2.0])), [1.0])
