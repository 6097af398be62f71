"""The autocorrelation of the pupil: for defocus alone, lines are integrated in closed form."""

import math

import numpy as np
import pytest

import lommel as lm
from lommel.measures import overlap

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


def test_defocus_alone_takes_no_quadrature_along_lines(monkeypatch):
    pupil = lm.Pupil(lm.Wavefront(defocus=180.0))
    monkeypatch.setattr(overlap, "_radial_product", None)
    assert overlap.autocorrelation(pupil, F, 1e-11).shape == (1, 40)


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
