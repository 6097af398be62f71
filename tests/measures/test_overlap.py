"""Overlap of shifted apertures: closed forms, segments, cells of masks, small shifts."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.measures import overlap
from lommel.measures.continuous_image import transfer
from lommel.optics.aperture.mask import cell_centers
from window_transform import window_transform

F = np.stack([np.linspace(0.003, 0.99, 40), np.zeros(40)], axis=-1)


@pytest.mark.parametrize("obscuration", [0.0, 0.35])
def test_the_closed_form_for_defocus_is_the_quadrature_of_the_phase(obscuration):
    defocus = np.array([0.3, 12.0, 70.0])
    alone = lm.Pupil(lm.Wavefront(defocus=defocus), obscuration=obscuration)
    # A spherical aberration of 1e-14 rad takes the general way and changes nothing else.
    general = lm.Pupil(lm.Wavefront(defocus=defocus, spherical=1e-14), obscuration=obscuration)
    found, expected = (overlap.autocorrelation(pupil, F, 1e-11) for pupil in (alone, general))
    np.testing.assert_allclose(found, expected, rtol=0, atol=2e-11)
    assert np.ptp(found.real) > 0.1


@pytest.mark.parametrize("apodization", [0.0, 0.7])
def test_pupils_that_differ_in_defocus_alone_have_the_functions_that_each_has_alone(apodization):
    defocus = np.array([-40.0, 0.3, 12.0])
    made = [
        lm.Pupil(lm.Wavefront(defocus=each, spherical=5.0), apodization=apodization) for each in (defocus, *defocus)
    ]
    together, *alone = (overlap.autocorrelation(pupil, F, 1e-11) for pupil in made)
    np.testing.assert_allclose(together, np.concatenate(alone), rtol=0, atol=2e-11)


SQUARE = lm.Polygon.regular(4, radius=1.0, angle=math.pi / 4)
HEXAGON = lm.Polygon.regular(6, radius=0.9, angle=0.1)
WHERE = [(0.1, 0.2), (0.3, -0.25), (0.02, 0.4), (0.4, 0.0), (1e-4, 0.0), (1e-9, 2e-9), (0.65, 0.1), (0.75, 0.6)]


def clipped(subject, clip):
    """The area that two convex polygons share, by cutting one along each side of the other."""
    for a, b in zip(clip, np.roll(clip, -1, axis=0), strict=True):
        side = [(b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) for p in subject]
        kept = []
        for k, p in enumerate(subject):
            q, here, there = subject[k - 1], side[k], side[k - 1]
            if (here >= 0) != (there >= 0):
                kept.append(q + (p - q) * there / (there - here))
            if here >= 0:
                kept.append(p)
        subject = kept
        if len(subject) < 3:
            return 0.0
    x, y = np.transpose(subject)
    return 0.5 * float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))


@pytest.mark.parametrize(("fx", "fy"), WHERE)
def test_a_square_has_triangles_as_its_transfer_function(fx, fy):
    side = math.sqrt(2.0)
    expected = max(0.0, 1.0 - 2.0 * abs(fx) / side) * max(0.0, 1.0 - 2.0 * abs(fy) / side)
    assert lm.otf(lm.Pupil(stop=SQUARE), fx, fy) == pytest.approx(expected, abs=1e-14)


@pytest.mark.parametrize(("fx", "fy"), WHERE)
def test_a_hexagon_has_its_geometric_autocorrelation(fx, fy):
    corners, f = np.array(HEXAGON.corners), np.array([fx, fy])
    expected = clipped(list(corners + f), corners - f) / clipped(list(corners), corners)
    assert lm.otf(lm.Pupil(stop=HEXAGON), fx, fy) == pytest.approx(expected, abs=1e-14)


def rectangle(x, y, width, height):
    return lm.Polygon(((x, y), (x + width, y), (x + width, y + height), (x, y + height)))


@pytest.mark.parametrize(("fx", "fy"), [(0.1, 0.05), (-0.2, 0.1), (0.05, -0.24), (0.3, 0.1)])
def test_segments_have_their_phases_in_every_pair(fx, fy):
    places, size = [(-0.6, -0.4), (-0.05, -0.45), (-0.3, 0.1)], (0.5, 0.4)
    phases = np.array([[0.7, 3.0, -2.0], [-1.1, 0.0, 4.0], [2.0, -1.0, 0.5]])
    stop = lm.Segments(tuple(rectangle(*place, *size) for place in places)).phased(*phases.T)
    total = 0.0
    for (x, y), (piston, tip, tilt) in zip(places, phases, strict=True):
        for (u, v), (other, ip, ilt) in zip(places, phases, strict=True):
            # exp(i ...) over what is common to [x + fx, x + fx + width] and [u - fx, u - fx + width].
            part = np.exp(1j * (piston - other))
            axes = ((x, u, size[0], fx, tip, ip), (y, v, size[1], fy, tilt, ilt))
            for here, there, width, f, slope, sope in axes:
                low, high = max(here + f, there - f), min(here + f, there - f) + width
                still = -slope * (here + 0.5 * width + f) + sope * (there + 0.5 * width - f)
                turn, middle, long = slope - sope, 0.5 * (low + high), max(0.0, high - low)
                part *= np.exp(1j * (still + turn * middle)) * long * np.sinc(turn * long / (2.0 * math.pi))
            total += part
    expected = total / (3 * size[0] * size[1])
    assert lm.otf(lm.Pupil(stop=stop), fx, fy) == pytest.approx(expected, abs=1e-12)
    assert abs(expected) > 1e-3


def test_a_tilt_of_all_segments_is_a_tilt_of_the_wavefront():
    whole = lm.Wavefront.zernike({(2, 0): 0.7, (3, 1): 0.5, (4, 0): 0.4, (6, 2): 0.2})
    tilted = lm.Wavefront(nonradial={(1, 1): 1.3, (1, -1): -0.4})
    segments = lm.Segments.hexagonal(rings=2, gap=0.02)
    centers = segments.centers
    own = segments.phased(centers @ [1.3, -0.4], 1.3, -0.4)
    for f in WHERE[:4]:
        expected = lm.otf(lm.Pupil(whole + tilted, stop=segments), *f)
        assert lm.otf(lm.Pupil(whole, stop=own), *f) == pytest.approx(expected, abs=2e-12)


@pytest.mark.parametrize("tol", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("light", [0.0, 1.5])
def test_the_error_stays_below_the_tolerance(tol, light):
    front = lm.Wavefront.zernike({(2, 0): 1.6, (3, 1): 0.9, (4, 0): 0.6, (5, -3): 0.4, (8, 0): 0.3})
    aperture = {"obscuration": 0.3, "spider": lm.Spider.equal(4, 0.03, 0.2), "apodization": light}
    pupil = lm.Pupil(front, **aperture)
    for f in WHERE[:4]:
        assert abs(lm.otf(pupil, *f, tol=tol) - lm.otf(pupil, *f, tol=1e-13)) < tol


SIDE = 24


def screen(*, squares: bool = False, side: int = SIDE) -> lm.Mask:
    """Return a mask of random phases and amplitudes."""
    rng = np.random.default_rng(5)
    values = rng.uniform(0.3, 1.0, (side, side)) * np.exp(1j * rng.uniform(-1.5, 1.5, (side, side)))
    return lm.Mask(values, squares=squares)


def field(pupil: lm.Pupil, wavefront: lm.Wavefront) -> np.ndarray:
    """Return the pupil function of each cell of an annulus, its clear part from 200 x 200 points."""
    at = cell_centers(SIDE)
    fine = cell_centers(SIDE * 200)
    rho = np.hypot(fine, fine[:, None])
    clear = ((rho <= 1.0) & (rho >= pupil.obscuration)).reshape(SIDE, 200, SIDE, 200).mean(axis=(1, 3))
    phase = wavefront.phase(np.hypot(at, at[:, None]), np.arctan2(at[:, None], np.broadcast_to(at, (SIDE, SIDE))))
    return clear * pupil.mask.values * np.exp(1j * phase.reshape(SIDE, SIDE))


def overlap_of_mask_overlap(cells: np.ndarray, x: int, y: int) -> complex:
    """Return the autocorrelation of an array at a shift, by a sum."""
    total = 0j
    for i in range(len(cells)):
        for j in range(len(cells)):
            if 0 <= i + y < len(cells) and 0 <= j + x < len(cells):
                total += cells[i, j] * np.conj(cells[i + y, j + x])
    return total / np.sum(np.abs(cells) ** 2)


@pytest.mark.parametrize("squares", [False, True])
def test_cells_of_a_mask_overlap_at_every_shift(squares, monkeypatch):
    wavefront = lm.Wavefront(1.0, nonradial={(3, 1): 0.7})
    pupil = lm.Pupil(wavefront, mask=screen(squares=squares), obscuration=0.3)
    cells = field(pupil, wavefront)
    # Thirds of a cell are whole shifts of cells a third as wide.
    finer = np.repeat(np.repeat(cells, 3, axis=0), 3, axis=1)
    shifts = [(1, 0), (0, -2), (7, 5), (-16, 3), (45, 2), (71, 0), (80, 0)]
    exact = np.array([overlap_of_mask_overlap(finer, *shift) for shift in shifts])
    fx, fy = np.transpose(shifts) / (3.0 * SIDE)
    found = lm.otf(pupil, fx, fy)
    # Parts of cells are those of points.
    np.testing.assert_allclose(found, exact, atol=2e-5)
    np.testing.assert_array_equal(lm.otf(lm.psf(pupil, 9, 0.25, dtype="float64"), fx, fy), found)
    assert lm.otf(pupil, 0.0) == pytest.approx(1.0, abs=1e-14)
    overlap.cells.cache_clear()
    monkeypatch.setattr(overlap, "_MAX_TABLE", 1)
    np.testing.assert_allclose(lm.otf(pupil, fx, fy), found, rtol=0.0, atol=1e-14)
    overlap.cells.cache_clear()


def test_at_whole_cells_it_is_the_transform_of_one_period_of_the_image():
    pupil = lm.Pupil(lm.Wavefront(0.5), mask=screen())
    # Below twice the cutoff a period of 96 samples is summed without error.
    image = lm.psf(pupil, 4 * SIDE, 0.25, dtype="float64", tol=1e-9, normalize="energy")
    shift = np.array([[1, 0], [2, 3], [-4, 9], [0, 20]]) / SIDE
    sums = window_transform(image, *shift.T)
    np.testing.assert_allclose(image.otf(*shift.T), sums, atol=1e-7)


def test_stacks_wavelengths_pixels_and_curves_of_a_mask():
    mask = lm.Mask.sample(lambda x, y: 1.0 - 0.5 * x**2, side=32)
    stack = lm.Pupil(lm.Wavefront([[0.0], [2.0]]), mask=mask, wavelength=500e-9, f_number=8.0)
    f = 0.1 * stack.cutoff
    found = lm.mtf(stack, f, pixel=2e-6)
    assert found.shape == (2, 1)
    assert found[1, 0] == pytest.approx(lm.mtf(stack[1, 0], f) * np.sinc(f * 2e-6), rel=1e-12)
    several = lm.methods.Polychromatic([500e-9, 600e-9], [1.0, 1.0])
    parts = [lm.mtf(stack[0, 0].in_light(w), f) for w in (500e-9, 600e-9)]
    both = lm.otf(stack[0, 0], f, spectrum=several)
    shares = np.array([part.share for part in several.components(stack[0, 0])])
    assert both.real == pytest.approx(shares @ parts, rel=1e-12)
    for thing in (stack[1, 0], lm.psf(stack[1, 0], 9, 1e-6)):
        at = lm.mtf_frequency(thing)
        assert lm.mtf(thing, at) == pytest.approx(0.5, abs=1e-7)


def test_the_centroid_of_a_phase_mask_is_that_of_its_image():
    screened = lm.Pupil(lm.Wavefront(nonradial={(1, 1): 0.7}), mask=screen())
    image = lm.psf(screened, (2 * SIDE, 512 * SIDE), (0.5, 1.0 / 512), dtype="float64", tol=1e-9)
    # A sum over x, which is not periodic, by the trapezoidal rule; over y without error.
    light, x = image.values.sum(axis=0), image.grid.x
    ends = np.append(light, light[0]), np.append(x, x[0] + SIDE)
    exact = np.trapezoid(ends[0] * ends[1], ends[1]) / np.trapezoid(*ends)
    assert image.centroid[0] == pytest.approx(exact, abs=1e-5)
    squares = lm.Pupil(mask=screen(squares=True))
    slope = -lm.otf(squares, [1e-4, 0.0], [0.0, 1e-4]).imag / (2.0 * math.pi * 1e-4)
    np.testing.assert_allclose(lm.psf(squares, 9, 0.25).centroid, slope, atol=1e-9)
    assert lm.psf(squares, 9, 0.25).encircled_energy(2.0, about="centroid") > 0.0
    tilt = lm.Mask.sample(lambda x, y: np.exp(1j * (0.8 * x * y + x)), side=256)
    np.testing.assert_allclose(math.pi * lm.centroid(lm.Pupil(mask=tilt)), [1.0, 0.0], atol=4e-4)


ABERRATED = lm.Wavefront(5.0, nonradial={(3, 1): 3.0, (1, -1): 4.0})
PUPILS = {
    "apodized": lm.Pupil(ABERRATED, obscuration=0.3, apodization=0.4),
    "vlt": lm.Pupil(stop=lm.telescopes.vlt()),
    "aberrated": lm.Pupil(ABERRATED, stop=lm.telescopes.vlt()),
    "phased": lm.Pupil(
        stop=lm.Segments.hexagonal(1, 0.05).phased([0.3, 0.5, 0, 0, 0, 0], [0, 4.0, 0, 0, 0, 0], unit="radians")
    ),
}


@pytest.mark.parametrize("end", [0.9, 0.05])
@pytest.mark.parametrize("name", PUPILS)
def test_shifts_by_parts_of_cells(name, end):
    rng = np.random.default_rng(3)
    f, angle = end * np.sqrt(rng.uniform(0.01, 1.0, 6)), rng.uniform(-np.pi, np.pi, 6)
    fx, fy = f * np.cos(angle), f * np.sin(angle)
    exact = lm.otf(PUPILS[name], fx, fy, tol=1e-7)
    # Shifts along gaps between segments open and close them within a cell.
    np.testing.assert_allclose(transfer(PUPILS[name], end, fx, fy), exact, atol=2e-4 if name == "phased" else 2e-5)
