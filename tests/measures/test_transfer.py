"""Transfer functions, against closed forms, direct quadrature, and the images themselves."""

from __future__ import annotations

import math
from dataclasses import replace

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.special import jv

import lommel as lm
from lommel.measures.overlap import autocorrelation
from lommel.measures.transfer import disc_transfer
from lommel.methods import Hankel, NijboerZernike, Polychromatic, ToleranceError
from pupil_overlap import overlap
from window_transform import window_transform

COMA = lm.Wavefront([0.0, 3.0], 0.4, nonradial={(3, 1): 1.0, (2, -2): -1.1, (1, 1): 2.0})
FREQUENCIES = np.linspace(0.0, 1.2, 49)


def shared_area(a: mpmath.mpf, b: mpmath.mpf, d: mpmath.mpf) -> mpmath.mpf:
    """Return the area that discs of radii a >= b share, their centres d apart."""
    if d >= a + b:
        return mpmath.mpf(0)
    if d <= a - b:
        return mpmath.pi * b * b
    one, two = ((d * d + b * b - a * a) / (2 * d * b), (d * d + a * a - b * b) / (2 * d * a))
    root = mpmath.sqrt((a + b - d) * (d + b - a) * (d - b + a) * (d + a + b))
    return b * b * mpmath.acos(one) + a * a * mpmath.acos(two) - root / 2


def oneill(f: float, eps: float) -> float:
    """Return O'Neill's transfer function of an annulus, by the areas that its discs share."""
    with mpmath.workdps(40):
        rim, hole, d = mpmath.mpf(1), mpmath.mpf(eps), 2 * mpmath.mpf(f)
        shared = shared_area(rim, rim, d) - 2 * shared_area(rim, hole, d) + shared_area(hole, hole, d)
        return float(shared / (mpmath.pi * (1 - hole**2)))


def hopkins(f: float, defocus: float) -> float:
    """Return Hopkins' series for a defocused lens; his s is 2 f, his a is 8 C_d f."""
    a, beta = 8 * defocus * f, math.acos(f)
    n = np.arange(1, 80)
    even = beta * jv(1, a) + np.sum(
        (-1.0) ** (n + 1) * np.sin(2 * n * beta) / (2 * n) * (jv(2 * n - 1, a) - jv(2 * n + 1, a))
    )
    n = np.arange(0, 80)
    odd = np.sum((-1.0) ** n * np.sin((2 * n + 1) * beta) / (2 * n + 1) * (jv(2 * n, a) - jv(2 * n + 2, a)))
    return 4 / (math.pi * a) * (math.cos(a * f) * even - math.sin(a * f) * odd)


def brute(pupil: lm.Pupil, fx: float, fy: float, side: int) -> NDArray[np.complex128]:
    """Return the autocorrelation by the midpoint rule on a Cartesian grid, first order at the edges."""
    x = (np.arange(side) + 0.5) / side * 2 - 1
    grid = np.meshgrid(x, x)
    product = pupil.values(grid[0] - fx, grid[1] - fy) * pupil.values(grid[0] + fx, grid[1] + fy).conj()
    return product.sum(axis=(1, 2)) * (2 / side) ** 2 / (math.pi * pupil.transmission)


def test_the_mtf_of_a_perfect_lens_is_that_of_two_discs():
    s = np.minimum(FREQUENCIES, 1.0)
    expected = 2 / math.pi * (np.arccos(s) - s * np.sqrt(1 - s * s))
    np.testing.assert_allclose(lm.otf(lm.Pupil(), FREQUENCIES), expected, rtol=0, atol=1e-14)


@pytest.mark.parametrize("eps", [1e-3, 0.2, 1 / 3, 0.5, 0.8, 0.99])
def test_the_mtf_of_an_annulus_is_that_of_oneill(eps):
    # The arcs of the annuli begin to cross, or touch, at (1 - eps) / 2, eps, (1 + eps) / 2.
    special = np.array([(1 - eps) / 2, eps, (1 + eps) / 2])
    f = np.concatenate([FREQUENCIES[1:], special, special + 1e-9, special - 1e-9])
    expected = [oneill(one, eps) for one in f]
    np.testing.assert_allclose(lm.otf(lm.Pupil(obscuration=eps), f), expected, rtol=0, atol=5e-12)


@pytest.mark.parametrize("defocus", [0.01, 1.0, -4.0, 15.0])
def test_the_otf_of_a_defocused_lens_is_that_of_hopkins(defocus):
    f = np.array([0.02, 0.1, 0.35, 0.5, 0.77, 0.96])
    found = lm.otf(lm.Pupil(lm.Wavefront(defocus)), f)
    np.testing.assert_allclose(found, [hopkins(one, defocus) for one in f], rtol=0, atol=1e-12)


@pytest.mark.parametrize("f", [0.003, 0.4, 0.999])
def test_a_large_defocus_is_no_less_exact(f):
    a, end = 8 * 200.0 * f, math.acos(f)

    def line(t: mpmath.mpf) -> mpmath.mpf:
        return mpmath.cos(t) * 2 * mpmath.sin(a * (mpmath.cos(t) - f)) / a

    expected = 2 / mpmath.pi * mpmath.quad(line, mpmath.linspace(0, end, 40))
    found = lm.otf(lm.Pupil(lm.Wavefront(200.0)), f)
    assert complex(found) == pytest.approx(complex(expected), abs=2e-12)


@pytest.mark.parametrize(
    "pupil",
    [
        lm.Pupil(COMA),
        lm.Pupil(COMA, obscuration=0.35),
        lm.Pupil(COMA, obscuration=0.6, apodization=1.5),
        lm.Pupil(lm.Wavefront(2.0, 1.0), apodization=3.0),
    ],
)
def test_the_otf_is_the_autocorrelation_of_the_pupil(pupil):
    for fx, fy in [(-0.15, 0.3), (0.2, -0.6)]:
        found = lm.otf(pupil, fx, fy).reshape(-1)
        errors = [np.abs(brute(pupil, fx, fy, n) - found).max() for n in (100, 500)]
        assert errors[1] < 1e-3
        assert errors[1] < max(0.5 * errors[0], 1e-4)


@pytest.mark.parametrize("eps", [0.0, 0.3])
def test_every_tolerance_is_met(eps):
    pupil = lm.Pupil(lm.Wavefront([8.0, 0.0], [3.0, -20.0], nonradial={(3, -1): 4.0}), obscuration=eps)
    f = np.array([-0.95, -0.4, 0.2, 0.7])
    truth = lm.otf(pupil, f, 0.1, tol=1e-13)
    for tol in (*10.0 ** np.arange(-12, -1), 0.0999):
        assert np.abs(lm.otf(pupil, f, 0.1, tol=tol) - truth).max() <= tol


def test_pixels_that_average_carry_their_sinc_in_the_image_and_from_the_wavefront():
    pupil = lm.Pupil(lm.Wavefront(2.0), wavelength=500e-9, f_number=4.0)
    pixel = 0.4 * pupil.scale
    image = lm.psf(pupil, 301, pixel, integrate=True, method=NijboerZernike(1e-9))
    f = np.array([0.05, 0.2, 0.6, 0.95]) * pupil.cutoff
    expected = lm.otf(pupil, f, 0.3 * f, pixel=pixel)
    plain = lm.otf(pupil, f, 0.3 * f)
    np.testing.assert_allclose(expected / plain, np.sinc(f * pixel) * np.sinc(0.3 * f * pixel), rtol=1e-9)
    np.testing.assert_array_equal(image.otf(f, 0.3 * f), expected)
    np.testing.assert_array_equal(image.otf(f, 0.3 * f, of="optics"), plain)
    # Sampled at 1 / pixel, frequencies return: at most what the sinc of those leaves.
    sampled = window_transform(image, f, 0.3 * f)
    assert np.abs(sampled - expected).max() < (1 - image.energy) + 1e-3
    assert np.abs(sampled - plain).max() > 2 * np.abs(sampled - expected).max()


def test_at_the_nyquist_frequency_values_have_twice_the_contrast_of_their_image():
    pupil = lm.Pupil(wavelength=550e-9, f_number=1.8)
    psf = lm.psf(pupil, 513, 1.22e-6)
    twice = 2.0 * psf.otf(0.5 / 1.22e-6).real
    assert window_transform(psf, 0.5 / 1.22e-6).real == pytest.approx(twice, abs=2.0 * (1.0 - psf.energy))


COEFFICIENT = st.floats(-4, 4)


@pytest.mark.parametrize("obscuration", [0.0, 0.4])
@pytest.mark.parametrize("frequency", [5e-324, 2.2e-311, 1e-101, 1e-99, 1e-30])
def test_next_to_the_frequency_0_the_otf_is_1(frequency, obscuration):
    pupil = lm.Pupil(lm.Wavefront(1.0, nonradial={(3, 1): 2.0}), obscuration=obscuration)
    assert lm.otf(pupil, frequency, frequency) == pytest.approx(1.0, abs=1e-12)


@given(COEFFICIENT, COEFFICIENT, st.floats(-0.7, 0.7), st.floats(-0.7, 0.7))
def test_a_tilt_turns_the_phase_of_the_otf_and_nothing_else(a, b, fx, fy):
    wavefront = lm.Wavefront(1.0, nonradial={(3, -1): 1.5})
    tilted = wavefront + lm.Wavefront(nonradial={(1, 1): a, (1, -1): b})
    plain, moved = lm.otf(lm.Pupil(wavefront), fx, fy), lm.otf(lm.Pupil(tilted), fx, fy)
    # A tilt of pi radians at the edge moves the image by one lambda*N.
    assert moved == pytest.approx(plain * np.exp(-2j * (fx * a + fy * b)), abs=1e-9)


def test_the_phase_transfer_of_a_tilt_is_linear_and_zero_where_there_is_no_contrast():
    pupil = lm.Pupil(lm.Wavefront(nonradial={(1, 1): 0.5}))
    np.testing.assert_allclose(lm.ptf(pupil, [0.0, 0.5, 0.9, 1.0, 2.0]), [0, -0.5, -0.9, 0, 0], rtol=0, atol=1e-8)


def test_a_stack_gives_what_each_of_its_pupils_gives():
    stack = lm.Pupil(lm.Wavefront(np.array([[0.0, 3.0]]), nonradial={(2, 2): [[1.0], [2.0]]}), obscuration=0.1)
    f = np.linspace(-0.9, 0.9, 3)
    values = lm.otf(stack, f, f[:, None])
    widths = lm.mtf_frequency(stack)
    assert values.shape == (2, 2, 3, 3)
    assert widths.shape == (2, 2)
    for index in np.ndindex(2, 2):
        np.testing.assert_allclose(values[index], lm.otf(stack[index], f, f[:, None]), rtol=0, atol=1e-9)
        assert widths[index] == pytest.approx(lm.mtf_frequency(stack[index]), abs=1e-8)
    assert np.ndim(lm.otf(stack[0, 0], 0.1)) == 0


def test_a_spectrum_is_the_weighted_sum_and_what_its_images_hold():
    pupil = lm.Pupil(lm.Wavefront(2.0), wavelength=500e-9, f_number=4.0)
    spectrum = Polychromatic([450e-9, 500e-9, 600e-9], [1, 2, 1], NijboerZernike(1e-9))
    f = np.array([0.0, 0.1, 0.5, 0.95]) * pupil.cutoff
    found = lm.otf(pupil, f, spectrum=spectrum)
    parts = [
        lm.otf(lm.Pupil(lm.Wavefront(2.0 * 500e-9 / w), wavelength=w, f_number=4.0), f) for w in spectrum.wavelengths
    ]
    np.testing.assert_allclose(found, np.tensordot(spectrum.weights, parts, 1), rtol=0, atol=1e-10)
    image = lm.psf(pupil, 401, 0.2 * pupil.scale, method=spectrum)
    assert np.abs(window_transform(image, f) - found).max() <= (1 - image.values.sum()) + 1e-6
    np.testing.assert_array_equal(image.otf(f, of="optics"), found)
    with pytest.raises(ValueError, match="needs a pupil with a wavelength"):
        lm.otf(lm.Pupil(), 0.5, spectrum=spectrum)
    with pytest.raises(TypeError, match="spectrum must be a Polychromatic"):
        lm.otf(pupil, 0.5, spectrum=Hankel())


@pytest.mark.parametrize("angle", [0.0, 1.1])
@pytest.mark.parametrize("level", [0.1, 0.5, 0.9])
def test_the_frequency_of_a_contrast_has_that_contrast_and_is_the_first(level, angle):
    pupil = lm.Pupil(COMA, wavelength=500e-9, f_number=2.0)
    for one, found in zip((pupil[0], pupil[1]), lm.mtf_frequency(pupil, level, angle=angle), strict=True):
        assert lm.mtf(one, found * math.cos(angle), found * math.sin(angle)) == pytest.approx(level, abs=1e-8)
        before = np.linspace(0, 0.999 * found, 50)
        assert lm.mtf(one, before * math.cos(angle), before * math.sin(angle)).min() > level
    perfect = lm.mtf_frequency(lm.Pupil(), 0.5)
    assert perfect == pytest.approx(0.40397, abs=1e-5)


def test_what_is_impossible_is_refused_by_name():
    for measure in (lm.otf, lm.psf):  # tolerances end where those of images do
        with pytest.raises(ValueError, match=r"tol must be .* < 0.1, got 0.1"):
            measure(lm.Pupil(), 3, 0.5, tol=0.1)
    with pytest.raises(ValueError, match="tol must be"):
        lm.otf(lm.psf(lm.Pupil(), 9, 0.5), 0.3, tol=0.1)
    with pytest.raises(ValueError, match="pixel is in metres"):
        lm.mtf(lm.Pupil(wavelength=5e-7, f_number=2.0), 1e5, pixel=3.45)
    with pytest.raises(ToleranceError, match="needs more than 4096 nodes"):
        lm.otf(lm.Pupil(lm.Wavefront(1e5)), 0.5)


EDGES = {
    "vanes": {"obscuration": 0.3, "spider": lm.Spider.equal(4, 0.04, 0.2)},
    "one vane": {"spider": lm.Spider(0.2, (0.5,))},
    "cat's eye": {"vignetting": lm.CatEye(shift=(0.4, 0.2))},
    "ellipse": {"obscuration": 0.2, "vignetting": lm.Ellipse(0.9, 0.6, 0.4)},
}


@pytest.mark.parametrize("eps", [0.0, 0.3])
def test_where_edges_may_cross_the_way_round_gives_what_the_other_gives(eps):
    pupil, f = lm.Pupil(COMA, obscuration=eps), np.array([[0.1, 0.2], [0.5, -0.3], [-0.05, 0.02], [1.0, 0.1], [0, 0]])
    uncut = replace(pupil, vignetting=lm.CatEye(shift=(0.1, 0.0), radius=1.2))
    assert np.abs(autocorrelation(uncut, f, 1e-9) - autocorrelation(pupil, f, 1e-12)).max() < 1e-9


@pytest.mark.parametrize("edges", EDGES)
def test_any_edge_is_seen_by_the_transfer_function(edges):
    pupil = lm.Pupil(lm.Wavefront(2.0, 0.4, nonradial={(3, 1): 1.0}), **EDGES[edges])
    fine = lm.otf(pupil, 0.31, 0.2, tol=1e-8)
    assert abs(fine - lm.otf(pupil, 0.31, 0.2, tol=1e-4)) < 1e-4
    assert abs(fine - brute(pupil, 0.31, 0.2, 1500)[0]) < 4e-4
    assert lm.otf(pupil, 0.0) == 1.0
    assert lm.otf(pupil, -0.31, -0.2, tol=1e-8) == np.conj(fine)


def test_a_bar_along_the_frequency_hides_its_strip():
    half = 0.05
    bar = lm.Pupil(spider=lm.Spider(2 * half, (0.0, math.pi)))
    light = bar.transmission * math.pi
    for f in (0.2, 0.5):
        top = math.sqrt(1.0 - f * f)

        def disc(y: float, f: float = f) -> float:
            return math.asin(y) + y * math.sqrt(1.0 - y * y) - 2.0 * f * y

        assert lm.mtf(bar, f) == pytest.approx(2.0 * (disc(top) - disc(half)) / light, abs=1e-9)


def test_a_star_over_a_spider_has_the_transfer_function_of_its_image():
    pupil = lm.Pupil(lm.Wavefront(1.0), **EDGES["vanes"])
    image = lm.psf(pupil, 129, 0.4, dtype="float64")
    assert abs(image.otf(0.3, 0.1) - lm.otf(pupil, 0.3, 0.1, tol=1e-6)) <= 1.0 - image.energy + 1e-4


@pytest.mark.parametrize("aberrations", [None, {(3, 1): 0.4}, {(2, 2): 0.5, (4, 0): 0.3}], ids=str)
def test_the_tolerance_of_focus_ends_where_the_mtf_of_a_moved_sensor_falls_to_the_least(aberrations):
    waves = lm.Wavefront.zernike(aberrations) if aberrations else None
    lens = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9, aberrations=waves)
    ends = lm.focus_tolerance(lens.pupil(2.0), 72e3, least=0.35, pixel=3.45e-6)
    assert ends[0] < 0.0 < ends[1]

    def contrast(shift):
        moved = replace(lens, sensor_distance=lens.sensor_distance + shift)
        c = np.pi / (2.0 * 550e-9) * (1 / moved.sensor_distance - 1 / 50e-3 + 1 / 2.0) * (25e-3 / 2.8) ** 2
        terms = aberrations or {}

        def pupil(x, y):
            rho, theta = np.hypot(x, y), np.arctan2(y, x)
            phase = 2.0 * c * rho**2
            phase = phase + terms.get((3, 1), 0.0) * np.sqrt(8.0) * (3.0 * rho**3 - 2.0 * rho) * np.cos(theta)
            phase = phase + terms.get((2, 2), 0.0) * np.sqrt(6.0) * rho**2 * np.cos(2.0 * theta)
            phase = phase + terms.get((4, 0), 0.0) * np.sqrt(5.0) * (6.0 * rho**4 - 6.0 * rho**2 + 1.0)
            return np.where(rho <= 1.0, np.exp(1j * phase), 0.0)

        half = 72e3 / lens.pupil(2.0).cutoff
        return np.sinc(72e3 * 3.45e-6) * min(overlap(pupil, half, 0.0), overlap(pupil, 0.0, half))

    assert [contrast(end) for end in ends] == pytest.approx([0.35, 0.35], abs=3e-3)
    assert min(contrast(share * end) for end in ends for share in (0.25, 0.5, 0.75)) > 0.35


@pytest.mark.parametrize(
    ("pupil", "given", "message"),
    [
        (lm.Pupil(), {}, "a single one with a wavelength"),
        (lm.Pupil(lm.Wavefront([1.0, 2.0]), wavelength=550e-9, f_number=2.8), {}, "a single one with a wavelength"),
        (
            lm.Pupil(wavelength=550e-9, f_number=2.8),
            {"least": 0.9},
            "least must be at most the MTF without displacement, .*, got",
        ),
    ],
)
def test_a_tolerance_of_focus_that_there_is_not_is_refused(pupil, given, message):
    with pytest.raises(ValueError, match=message):
        lm.focus_tolerance(pupil, **{"frequency": 72e3} | given)


def test_transfer_function_of_a_disc_is_that_of_its_chords():
    f, (node, weight) = np.array([0.0, 1e-9, 0.1, 0.4, 1.3]), np.polynomial.legendre.leggauss(60)
    place = np.sin(0.5 * np.pi * node)  # the chord at this place is cos(pi node / 2) times the diameter
    chords = np.cos(np.pi * 3.0 * f[:, None] * place) @ (weight * np.cos(0.5 * np.pi * node) ** 2)
    np.testing.assert_allclose(disc_transfer(3.0, f), chords, atol=1e-12)


def test_frequencies_that_are_probably_per_millimetre_are_told():
    camera = lm.Pupil(lm.Wavefront(0.5), wavelength=550e-9, f_number=4.0)
    psf = lm.psf(camera, 3, 1e-6)
    for measure in (lambda f: lm.mtf(camera, f), lambda f: lm.otf(camera, 0.0, [0.0, f]), psf.mtf):
        with pytest.warns(UserWarning, match=r"cycles per metre: 50 is 0.0001 of the cutoff.*cycles/mm give 50e3"):
            measure(50)
        measure(50e3)  # warnings are errors
        measure(0.0)
    lm.mtf(camera, [50.0, 50e3])
    lm.mtf(camera, 50.0, blur=lm.Motion(8e-3))  # a blur of millimetres has such frequencies
    lm.mtf(lm.Pupil(), 1e-4)
