"""The chordal Gauss rule keeps its tolerance for any wavefront, and its bound is never below the true error."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import lommel as lm
from disk_questions import disk_question
from lommel import _core
from lommel.core.engine import DiskStack
from lommel.methods import ChordalGauss, NijboerZernike
from lommel.optics.grid import Grid
from lommel.paper import Fraunhofer
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

TERMS = [zernike.term(j, "noll") for j in range(2, 46)]  # n from 1 to 8


def polar(pupil: lm.Pupil, grid: Grid, radii: int = 120, angles: int = 320) -> np.ndarray:
    """Return I of each pupil by Gauss-Legendre in the radius and the trapezoidal rule in the angle."""
    r, w = gauss_legendre(radii, pupil.obscuration, 1.0)
    theta = 2.0 * math.pi * (np.arange(angles) + 0.5) / angles
    x, y = np.outer(r, np.cos(theta)), np.outer(r, np.sin(theta))
    values = pupil.values(x, y) * (2.0 / angles * w * r)[:, None]
    across = np.exp(-1j * np.outer(x.ravel(), math.pi / pupil.scale * grid.x))
    down = np.exp(-1j * np.outer(y.ravel(), math.pi / pupil.scale * grid.y))
    field = np.stack([(one.reshape(-1, 1) * down).T @ across for one in values])
    return np.asarray(field.real**2 + field.imag**2).reshape(*pupil.shape, *field.shape[1:])


def random_wavefront(rng: np.random.Generator, rms: float, terms: list[tuple[int, int]] = TERMS) -> lm.Wavefront:
    chosen = [terms[i] for i in rng.choice(len(terms), size=min(len(terms), 12), replace=False)]
    c = rng.normal(size=len(chosen))
    return lm.Wavefront.zernike(dict(zip(chosen, rms * c / np.linalg.norm(c), strict=True)))


def intensity(answer: lm.PSF) -> np.ndarray:
    return np.asarray(answer.values / answer.scale[..., None, None])


def error(answer: lm.PSF, exact: np.ndarray) -> float:
    return float(np.abs(intensity(answer) - exact).max() / exact.max())


@settings(max_examples=30, deadline=None)
@example(0, 0.0, 0.0, 6.0, (1, 1), 1.0, (0.0, 6.0), 1e-9)
@given(
    seed=st.integers(0, 2**32 - 1),
    rms=st.floats(0.0, 3.0),
    obscuration=st.sampled_from([0.0, 0.2, 0.7]),
    apodization=st.sampled_from([0.0, 1.0, 6.0]),
    shape=st.tuples(st.integers(1, 14), st.integers(1, 14)),
    pixel=st.floats(0.1, 1.0),
    center=st.none() | st.tuples(st.floats(-3.0, 10.0), st.floats(-3.0, 10.0)),
    tol=st.sampled_from([1e-3, 1e-6, 1e-9]),
)
def test_random_wavefronts_agree_with_direct_quadrature(
    seed, rms, obscuration, apodization, shape, pixel, center, tol
):
    wavefront = random_wavefront(np.random.default_rng(seed), rms)
    pupil = lm.Pupil(wavefront, obscuration=obscuration, apodization=apodization)
    grid = Grid(shape, pixel, center=center)
    exact = polar(pupil, grid)
    options = {"method": ChordalGauss(tol), "center": center, "normalize": "strehl", "dtype": np.float64}
    try:
        answer = lm.psf(pupil, shape, pixel, **options)
    except lm.ToleranceError:
        # Roundings, over the largest value of a window that misses the light.
        assert tol == 1e-9
        assert exact.max() < 1e-3 * pupil.amplitude**2
        return
    assert error(answer, exact) <= answer.error_bound + 1e-12 / exact.max()
    assert answer.error_bound <= tol


@pytest.mark.parametrize("tol", [1e-2, 1e-3, 1e-4, 1e-5, 1e-6])
@pytest.mark.parametrize("obscuration", [0.0, 0.35])
def test_a_thousand_pupils_in_single_precision_agree_with_direct_quadrature(tol, obscuration):
    rng = np.random.default_rng(round(-math.log10(tol)) + (50 if obscuration else 0))
    for _ in range(5):
        terms = [TERMS[i] for i in rng.choice(len(TERMS), size=12, replace=False)]
        c = rng.normal(size=(20, 12)) * rng.uniform(0.1, 0.8, (20, 1))
        wavefront = lm.Wavefront.zernike(dict(zip(terms, c.T, strict=True)))
        pupil = lm.Pupil(wavefront, obscuration=obscuration, apodization=float(rng.choice([0.0, 1.5])))
        shape, pixel = tuple(map(int, rng.integers(4, 24, 2))), float(rng.uniform(0.2, 0.8))
        answer = lm.psf(pupil, shape, pixel, method=ChordalGauss(tol), threads=1)
        exact = polar(pupil, Grid(shape, pixel), 90, 240)
        for i in range(20):
            assert error(answer[i], exact[i]) <= np.ravel(answer.error_bound)[i if np.ndim(answer.error_bound) else 0]
        assert np.max(answer.error_bound) <= tol


def test_the_tolerance_is_kept_eight_times_a_decade_and_the_bound_is_never_below_the_error():
    rng = np.random.default_rng(3)
    pupil = lm.Pupil(random_wavefront(rng, 1.5), obscuration=0.3)
    exact = polar(pupil, Grid(13, 0.8), 120, 256)
    errors = []
    for tol in 10.0 ** -np.arange(3.0, 10.0 + 1e-9, 0.125):
        answer = lm.psf(pupil, 13, 0.8, method=ChordalGauss(tol), dtype=np.float64, threads=1)
        assert error(answer, exact) <= answer.error_bound <= tol
        errors.append(answer.error_bound)
    # A bound that stays where it is would mean that the tolerance is ignored.
    assert len(set(errors)) >= 8


def chordal_rule(chords: int, nodes: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    angle = math.pi * np.arange(1, chords + 1) / (chords + 1)
    eta, w = np.polynomial.legendre.leggauss(nodes)
    x = np.repeat(np.cos(angle)[:, None], nodes, 1)
    return x, np.sin(angle)[:, None] * eta, np.sin(angle)[:, None] ** 2 * w / (chords + 1)


@pytest.mark.parametrize("index", [641, 875, 1396])
def test_images_that_are_dimmer_than_was_guessed_are_computed_again_for_the_peak_that_was_found(index):
    pupil, grid, tol = disk_question(index)
    ask = lm.Plan(grid.shape, grid.side, center=grid.axis, method=ChordalGauss(tol), threads=1)
    found = ask(pupil, out=np.empty((*pupil.shape, *grid.shape), np.float32))
    double = lm.psf(pupil, grid.shape, grid.side, center=grid.axis, method=NijboerZernike(1e-9), dtype=float)
    exact, peaks = intensity(double), intensity(double).max(axis=(-1, -2))
    off = np.abs(intensity(found) - exact).max(axis=(-1, -2)) / peaks
    assert np.all(off <= found.error_bound + double.error_bound)
    assert np.max(found.error_bound) <= tol


@pytest.mark.theorem
@pytest.mark.parametrize("chords", [8, 20])
def test_the_rule_integrates_polynomials_up_to_its_degree_and_no_further(chords):
    x, y, weights = chordal_rule(chords, chords)
    assert weights.min() > 0
    for a in range(0, 2 * chords, 2):
        b = 2 * chords - 2 - a
        # The mean of x^a y^b over the disk.
        beta = math.gamma((a + 1) / 2) * math.gamma((b + 1) / 2) / math.gamma((a + b) / 2 + 2) / math.pi
        assert (weights * x**a * y**b).sum() == pytest.approx(beta, rel=2e-12)
    b = 2 * chords
    exact = math.gamma((b + 1) / 2) * math.gamma(0.5) / math.gamma(b / 2 + 2) / math.pi
    assert abs((weights * y**b).sum() / exact - 1) > 2e-11


@pytest.mark.parametrize("obscuration", [0.0, 0.45])
@pytest.mark.parametrize("apodization", [0.0, 2.5])
def test_radial_pupils_agree_with_the_hankel_transform(obscuration, apodization):
    wavefront = lm.Wavefront(np.array([0.0, 4.0, -12.0]), np.array([0.0, -3.0, 8.0]), (np.array([0.0, 1.0, 2.0]),))
    pupil = lm.Pupil(wavefront, obscuration=obscuration, apodization=apodization)
    exact = intensity(lm.psf(pupil, (20, 25), 0.4, method="hankel"))
    for other in (ChordalGauss(1e-9), NijboerZernike(1e-9)):
        found = intensity(lm.psf(pupil, (20, 25), 0.4, method=other))
        assert (np.abs(found - exact).max(axis=(1, 2)) <= 1e-9 * exact.max(axis=(1, 2))).all()


@pytest.mark.parametrize("shape", [(1, 1), (1, 8), (8, 1), (2, 3), (16, 16), (17, 5), (33, 34)])
@pytest.mark.parametrize("center", [None, "half", (2.25, -1.5), (0.0, 0.0)])
def test_every_window_shows_the_same_pattern(shape, center):
    place = ((shape[0] - 1) / 2, (shape[1] - 1) / 2) if center == "half" else center
    pupil = lm.Pupil(random_wavefront(np.random.default_rng(5), 1.0))
    grid = Grid(shape, 0.45, center=place)
    answer = lm.psf(pupil, shape, 0.45, method=ChordalGauss(1e-8), center=place, normalize="strehl")
    assert error(answer, polar(pupil, grid, 56, 136)) <= 1e-8


def test_threads_and_instructions_change_nothing_beyond_the_bound():
    rng = np.random.default_rng(8)
    c = rng.normal(size=(30, 4))
    pupil = lm.Pupil(lm.Wavefront.zernike({j + 5: c[:, j] for j in range(4)}, order="noll"), obscuration=0.2)
    one = lm.psf(pupil, 10, 0.5, method=ChordalGauss(1e-9), threads=1)
    for threads in (2, 5):
        again = lm.psf(pupil, 10, 0.5, method=ChordalGauss(1e-9), threads=threads)
        assert np.array_equal(again.values, one.values)
    try:
        for level in ("avx2", "portable"):
            _core.limit_instructions(level)
            other = lm.psf(pupil, 10, 0.5, method=ChordalGauss(1e-9), threads=1)
            assert np.abs(other.values - one.values).max() <= 2e-9 * one.values.max()
    finally:
        _core.limit_instructions("avx512")


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("level", ["portable", "avx2", "avx512"])
def test_a_few_pupils_have_the_values_they_have_among_many(level, dtype):
    # Up to half as many pupils as a vector has lanes are computed one by one, the others side by side.
    terms = dict(zip(TERMS[:20], np.random.default_rng(21).normal(size=20), strict=True))
    questions = [
        ((12, 13), None, 0.0),
        ((21, 34), (10.3, 16.5), 0.3),
        ((1, 2), (0.0, 5.0), 0.3),
        ((18, 16), (9.0, 0.25), 0.0),
    ]
    method = ChordalGauss(1e-5)
    try:
        _core.limit_instructions(level)
        for shape, center, obscuration in questions:
            few, many = (
                lm.psf(
                    lm.Pupil(
                        lm.Wavefront.zernike({term: np.full(count, c) for term, c in terms.items()}),
                        obscuration=obscuration,
                    ),
                    shape,
                    0.4,
                    center=center,
                    dtype=dtype,
                    method=method,
                )
                for count in (1, 40)
            )
            assert np.array_equal(few.values[0], many.values[0])
            assert few.error_bound == many.error_bound
    finally:
        _core.limit_instructions("avx512")


def test_the_strongest_pupil_of_a_stack_may_be_far_stronger_than_the_rest():
    strength = np.array([0.1, 30.0, 0.2, 0.0, 0.3, 0.1, 0.2, 0.1, 0.1, 0.4])
    pupil = lm.Pupil(lm.Wavefront(nonradial={(2, 2): strength, (3, 3): 0.5}))
    answer = lm.psf(pupil, 9, 0.7, method=ChordalGauss(1e-7), dtype=np.float64)
    assert error(answer[1], polar(pupil[1], answer.grid)) <= 1e-7
    assert error(answer[4], polar(pupil[4], answer.grid)) <= 1e-7


@pytest.mark.parametrize("engine", [_core.chordal_images, _core.series_images])
@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_an_image_is_written_where_it_is_to_be_even_if_other_arguments_are_converted(engine, kind):
    images, numbers = np.zeros((1, 3, 3), kind), np.zeros((3, 1))
    stack = DiskStack(np.array([[2, 2]], np.int32), np.ones((1, 1)), 0.0, np.zeros(1))
    window, request = ((3, 3), (1, 1), 0.5), (1e-3, 1, 1.0)  # whole numbers for the centre
    assert engine(stack, window, request, images, numbers) == 0.0
    assert images.min() > 0.1
    with pytest.raises(TypeError, match="incompatible function arguments"):
        engine(stack, window, request, images.astype(int), numbers)


def test_a_pupil_that_passes_less_light_than_rounding_makes_is_refused_and_not_tried_for_ever():
    wavefront = lm.Wavefront(nonradial={(3, -1): 0.7, (2, 2): 0.3})
    pupil = lm.Pupil(wavefront, obscuration=0.999, apodization=20.0)
    with pytest.raises(lm.ToleranceError, match="cannot be met in double precision"):
        lm.psf(pupil, 2, 0.6, center=(3.6, 2.5), method=ChordalGauss(1e-9))


def test_what_is_too_large_is_told_with_what_fits():
    def ask(phases: float, window: float) -> lm.PSF:
        wavefront = lm.Wavefront(600.0 * phases, 3.0 * phases, nonradial={(2, 2): 2.0 * phases, (3, 1): phases})
        pupil = lm.Pupil(wavefront, obscuration=0.6)
        return lm.psf(pupil, int(64 * window), 13.0, integrate=False, method=ChordalGauss(1e-3))

    number = r"(0\.\d+) times the size"
    with pytest.raises(
        ValueError, match=rf"; at most windows of {number}, or phases and windows of {number} fit"
    ) as caught:
        ask(1.0, 1.0)
    window, both = map(float, re.findall(number, str(caught.value)))
    assert 0.2 < window < both < 0.9
    assert ask(1.0, window).error_bound <= 1e-3
    assert ask(both, both).error_bound <= 1e-3


def test_what_no_certified_method_takes_is_told_with_one_that_computes_it():
    pupil = lm.Pupil(lm.Wavefront(750.0, nonradial={(2, 2): 2.0}))
    with pytest.raises(ValueError, match=r"; method=lommel\.paper\.Fraunhofer\(samples=(\d+)\) ") as caught:
        lm.psf(pupil, 64, 32.0)
    samples = int(re.findall(r"samples=(\d+)", str(caught.value))[0])
    assert lm.psf(pupil, 64, 32.0, method=Fraunhofer(samples=samples)).values.sum() == pytest.approx(1.0, abs=0.01)
    with pytest.raises(ValueError, match="more than the limit of 1600: less aberration or a smaller window"):
        lm.psf(pupil, 64, 32.0, method="nijboer-zernike")
