"""Blurred images of pupils without symmetry, against quadrature over transfer functions computed in other ways."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.blur.blurs import KOLMOGOROV
from lommel.optics.aperture.shapes import Polygon

PLACES = [(4, 4), (2, 7), (0, 1)]


def graded(kinks: list[float], end: float) -> tuple[np.ndarray, np.ndarray]:
    """Return nodes and weights from 0 to `end`, in panels between kinks that shrink towards 0."""
    edges = np.unique([0.0, *(end * 0.5 ** np.arange(22.0)), *(k for k in kinks if k < end)])
    x, w = np.polynomial.legendre.leggauss(14)
    low, wide = edges[:-1, None], np.diff(edges)[:, None]
    return (low + 0.5 * wide * (x + 1.0)).ravel(), (0.5 * wide * w).ravel()


def kolmogorov(f: np.ndarray, ratio: float) -> np.ndarray:
    return np.asarray(np.exp(-KOLMOGOROV * (ratio * f) ** (5.0 / 3.0)))


def judged(answer: lm.PSF, expected: list[float], peak: float, tol: float) -> None:
    found = [float(answer.values[at]) for at in PLACES]
    worst = float(np.abs(np.subtract(found, expected)).max()) / peak
    assert answer.error_bound is not None
    assert worst <= answer.error_bound <= tol


SIDE, VANE = 0.6, 0.08


@pytest.mark.parametrize(
    ("ratio", "pixel", "tol"),
    [
        (2.0, 0.5, 1e-6),
        (12.0, 2.4, 1e-4),
        (12.0, 5.0, 1e-7),
        (20.0, 1.5, 3e-8),
        (50.0, 10.0, 1e-6),
        (60.0, 20.0, 1e-6),
    ],
)
@pytest.mark.parametrize("integrate", [False, True])
def test_a_square_mirror_behind_crossed_vanes_is_the_product_of_two_sides(ratio, pixel, tol, integrate):
    # P(x, y) = p(x) p(y), p being two intervals, so that the transfer function is a product of sums of triangles.
    square = Polygon(((-SIDE, -SIDE), (SIDE, -SIDE), (SIDE, SIDE), (-SIDE, SIDE)))
    pupil = lm.Pupil(stop=square, spider=lm.Spider.equal(4, VANE))
    answer = lm.psf(
        pupil,
        9,
        pixel,
        blur=lm.Seeing(1.0 / ratio),
        tol=tol,
        integrate=integrate,
        center=(4.0, 4.25),
        normalize="strehl",
        dtype="float64",
    )
    wide = SIDE - 0.5 * VANE  # of an interval, the other one being `apart` from it
    apart = SIDE + 0.5 * VANE
    end = min(SIDE, (42.0 / KOLMOGOROV) ** 0.6 / ratio)
    # Over the cutoff f is a shift by 2 f radii of the pupil.
    kinks = [0.5 * wide, 0.5 * (apart - wide), 0.5 * apart, 0.5 * (apart + wide)]
    f, weight = graded(kinks, end)

    def triangle(at: np.ndarray) -> np.ndarray:
        return np.asarray(np.maximum(1.0 - np.abs(at) / wide, 0.0))

    side = weight * (triangle(2.0 * f) + 0.5 * triangle(2.0 * f - apart) + 0.5 * triangle(2.0 * f + apart))
    side = side * (np.sinc(pixel * f) if integrate else 1.0)
    spectrum = side[:, None] * side * kolmogorov(np.hypot(f[:, None], f), ratio)

    def value(y: float, x: float) -> float:
        # The transfer function is 1 at 0, and its integral without blur the square of one interval.
        return float(np.cos(2.0 * np.pi * y * f) @ spectrum @ np.cos(2.0 * np.pi * x * f)) * 4.0 / wide**2

    judged(answer, [value(answer.grid.y[i], answer.grid.x[j]) for i, j in PLACES], value(0.0, 0.0), tol)


TERMS = {(2, 2): 0.5, (2, -2): -0.4, (3, 1): 0.6, (3, -1): 0.5, (3, 3): 0.3}


def phase(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return the sum of TERMS, by hand: radial polynomials that are 1 at the edge."""
    r, t = np.hypot(x, y), np.arctan2(y, x)
    coma = 3.0 * r**3 - 2.0 * r
    return np.asarray(
        TERMS[2, 2] * r**2 * np.cos(2.0 * t)
        + TERMS[2, -2] * r**2 * np.sin(2.0 * t)
        + TERMS[3, 1] * coma * np.cos(t)
        + TERMS[3, -1] * coma * np.sin(t)
        + TERMS[3, 3] * r**3 * np.cos(3.0 * t)
    )


def overlap(f: np.ndarray, angle: np.ndarray) -> np.ndarray:
    """Return ``int P(r - f) conj(P(r + f)) d^2 r`` of a disc, f over the cutoff: shape (angles, frequencies)."""
    s, w = np.polynomial.legendre.leggauss(20)
    out = np.empty((angle.size, f.size), complex)
    for k, at in enumerate(f):
        # Lines along the shift, of half length cos(t) - f, at the distance sin(t) from it.
        opening = math.acos(at)
        t = opening * s
        half = np.cos(t) - at
        along, across = np.multiply.outer(s, half), np.broadcast_to(np.sin(t), (s.size, t.size))
        weight = np.multiply.outer(w, w * opening * np.cos(t) * half)
        c, n = np.cos(angle)[:, None, None], np.sin(angle)[:, None, None]
        (x, y), (u, v) = ((c * (along + shift) - n * across, n * (along + shift) + c * across) for shift in (-at, at))
        out[:, k] = (np.exp(1j * (phase(x, y) - phase(u, v))) * weight).sum(axis=(1, 2))
    return out


@pytest.mark.parametrize(("ratio", "pixel"), [(6.0, 1.2), (12.0, 2.4), (40.0, 8.0)])
def test_an_aberrated_disc_is_the_transform_of_its_autocorrelation_through_air(ratio, pixel):
    x, w = np.polynomial.legendre.leggauss(48)
    end = min(1.0, (42.0 / KOLMOGOROV) ** 0.6 / ratio)
    u = 0.5 * (x + 1.0)
    f, weight = end * u**3, end**2 * 1.5 * u**5 * w
    angle = 2.0 * np.pi / 128 * np.arange(128)
    spectrum = overlap(f, angle) * weight * kolmogorov(f, ratio) * 2.0 * np.pi / 128
    fx, fy = np.multiply.outer(np.cos(angle), f), np.multiply.outer(np.sin(angle), f)

    def value(down: float, across: float) -> float:
        # Over the peak without aberration, whose autocorrelation has the integral pi^2 / 4 over frequencies.
        wave = np.exp(2j * np.pi * (across * fx + down * fy)) * np.sinc(pixel * fx) * np.sinc(pixel * fy)
        return float((spectrum * wave).sum().real) * 4.0 / np.pi**2

    pupil = lm.Pupil(lm.Wavefront(nonradial=TERMS))
    for tol in (1e-3, 1e-5, 1e-7):
        answer = lm.psf(
            pupil, 9, pixel, blur=lm.Seeing(1.0 / ratio), tol=tol, integrate=True, normalize="strehl", dtype="float64"
        )
        judged(answer, [value(answer.grid.y[i], answer.grid.x[j]) for i, j in PLACES], value(0.0, 0.0), tol)


@pytest.mark.parametrize("seed", range(20))
def test_next_to_no_astigmatism_changes_nothing_that_the_bounds_do_not_allow(seed):
    # The quadrature over transfer functions takes the radial pupil, the lattice the other.
    rng = np.random.default_rng(seed)
    ratio, pixel = (float(np.exp(rng.uniform(*np.log(ends)))) for ends in ((2.0, 60.0), (0.5, 20.0)))
    blur: list[lm.Seeing | lm.Jitter] = [lm.Seeing(1.0 / ratio, outer_scale=20.0 if seed % 4 == 1 else None)]
    if seed % 3 == 0:
        blur.append(lm.Jitter(float(rng.uniform(0.2, 6.0))))
    side, defocus, eps = int(rng.integers(3, 24)), float(rng.choice([0.0, 2.0])), float(rng.choice([0.0, 0.3]))
    options = {
        "blur": blur,
        "center": None if seed % 2 else tuple(rng.uniform(0.0, side - 1.0, 2)),
        "integrate": bool(seed % 5),
        "normalize": ("energy", "peak", "strehl")[seed % 3],
        "dtype": "float64",
    }
    tol = float(10.0 ** rng.uniform(-7.0, -3.0))
    radial, other = (
        lm.psf(lm.Pupil(lm.Wavefront(defocus, nonradial=terms), obscuration=eps), side, pixel, tol=each, **options)
        for terms, each in (({}, 1e-8), ({(2, 2): 1e-13}, tol))
    )
    off = np.abs(radial.values - other.values).max() / radial.values.max()
    assert off <= other.error_bound + radial.error_bound
    assert other.error_bound <= tol


@pytest.mark.parametrize(("sigma", "length", "tol"), [(4.0, 0.0, 1e-6), (6.0, 25.0, 1e-7), (2.0, 3.0, 1e-4)])
def test_wide_jitter_gathers_light_as_the_sum_of_fine_samples_does(sigma, length, tol):
    pupil = lm.Pupil(lm.Wavefront(nonradial=TERMS), spider=lm.Spider.equal(3, 0.1), obscuration=0.2)
    blur = [lm.Jitter(sigma, 1.2 * sigma, 0.3), lm.Motion(length, 0.8)]
    answer = lm.psf(pupil, 9, 2.0, blur=blur, tol=tol, integrate=False, normalize="strehl", dtype="float64")
    # Samples half of lambda*N apart hold all; those far out are beyond the Gaussian.
    step, half = 0.45, math.ceil((9.0 * sigma + 0.6 * length + 12.0) / 0.45)
    fine = lm.psf(pupil, 2 * half + 1, step, integrate=False, normalize="strehl", dtype="float64", tol=1e-10)
    x, w = np.polynomial.legendre.leggauss(40)
    (xx, xy), (_, yy) = blur[0].covariance
    inverse = np.linalg.inv([[xx, xy], [xy, yy]])

    def value(down: float, across: float) -> float:
        found = 0.0
        for shift, weight in zip(0.5 * length * x, 0.5 * w, strict=True):
            dx = across - shift * math.cos(0.8) - fine.grid.x
            dy = (down - shift * math.sin(0.8) - fine.grid.y)[:, None]
            square = inverse[0, 0] * dx * dx + 2.0 * inverse[0, 1] * dx * dy + inverse[1, 1] * dy * dy
            found += weight * float((fine.values * np.exp(-0.5 * square)).sum())
        return found * step**2 * math.sqrt(np.linalg.det(inverse)) / (2.0 * math.pi)

    expected = [value(answer.grid.y[i], answer.grid.x[j]) for i, j in PLACES]
    judged(answer, expected, float(answer.values.max()), tol)
