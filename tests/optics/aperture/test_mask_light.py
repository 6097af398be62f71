"""The light of masks: all of it is in the image, once."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import lommel as lm
from lommel import Mask, Pupil
from lommel.methods import MatrixFourier, NonuniformFFT, Polychromatic

SIDES = st.integers(3, 12)  # fewer samples are too coarse for these aberrations


@st.composite
def pupils(draw: st.DrawFn, *, squares: bool) -> Pupil:
    side, rng = draw(SIDES), np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    values = rng.uniform(size=(side, side)) ** draw(st.sampled_from([0.0, 1.0, 8.0]))
    if draw(st.booleans()):
        values = values * np.exp(2j * math.pi * rng.uniform(size=(side, side)))
    terms = {(2, 2): draw(st.floats(-0.5, 0.5)), (3, 1): draw(st.floats(-0.3, 0.3))}
    return Pupil(
        lm.Wavefront(nonradial=terms),
        mask=Mask(values, squares=squares),
        obscuration=draw(st.sampled_from([0.0, 0.3])),
        apodization=draw(st.sampled_from([0.0, 0.8])),
        vignetting=draw(st.sampled_from([None, lm.CatEye((0.4, 0.1))])),
    )


@settings(max_examples=25, deadline=None)
@given(pupils(squares=False), st.sampled_from([0, 1]))
def test_a_period_of_the_image_of_samples_holds_all_light(pupil, odd):
    side = pupil.mask.side
    count = 2 * side + odd
    whole = lm.psf(pupil, count, side / count, tol=1e-9, dtype="float64")
    # A sum over more than 2 side points along each axis is the integral over the period.
    assert whole.values.sum() == pytest.approx(1.0, abs=2e-8)
    if odd:
        assert float(whole.energy) == pytest.approx(1.0, abs=2e-7)
    share = np.asarray(whole.encircled_energy(side * np.linspace(0.1, 0.5, 5)))
    assert np.all(np.diff(share) > -1e-7)
    assert -1e-7 <= share[0] <= share[-1] <= 1.0 + 1e-7


@settings(max_examples=25, deadline=None)
@given(pupils(squares=True))
def test_the_image_of_squares_over_the_plane_holds_all_light(pupil):
    # sum over m of sinc^2(x + m) = 1: an infinite window is one period with the envelope summed over all periods.
    side = pupil.mask.side
    count = 2 * side + 1
    made = lm.psf(pupil, count, side / count, tol=1e-9, dtype="float64")
    envelope = np.sinc(made.grid.x / side) ** 2
    assert (made.values / (envelope[:, None] * envelope)).sum() == pytest.approx(1.0, abs=1e-7)


def test_the_light_of_squares_is_the_integral_over_ever_larger_windows():
    pupil = Pupil(mask=Mask(np.ones((8, 8)), squares=True))
    beyond = [1.0 - float(lm.psf(pupil, n, 1.0, integrate=True, dtype="float64").energy) for n in (129, 257, 513)]
    assert 0.0 < beyond[2] < 0.55 * beyond[1] < 0.55 * 0.55 * beyond[0] < 0.01


def test_the_normalisation_of_a_clear_mask_converges_to_that_of_the_disc():
    fractions = [float(lm.psf(Pupil(mask=Mask(np.ones((n, n)))), 17, 0.25).energy) for n in (64, 256, 1024)]
    off = np.abs(np.array(fractions) - float(lm.psf(Pupil(), 17, 0.25).energy))
    assert off[2] < 0.3 * off[1] < 0.3 * 0.3 * off[0] < 1e-3


ONES = Mask(np.ones((32, 32)))


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: lm.psf(Pupil(mask=ONES), 33, 1.0, integrate=True), "the window reaches 16.5 lambda"),
        (lambda: lm.psf(Pupil(mask=ONES), 5, 0.5, center=(2, -30.0)), "the window reaches 17 lambda"),
        (lambda: lm.psf(Pupil(mask=ONES), 33, 1.0).energy, "the window reaches 16.5 lambda"),
        (lambda: lm.psf(Pupil(mask=ONES), 9, 0.5).encircled_energy(16.1), "radius reaches 16.1 lambda"),
        (lambda: lm.psf(Pupil(mask=ONES), 9, 0.5).ensquared_energy(16.1), "half_width reaches 16.1 lambda"),
        (lambda: lm.psf(Pupil(mask=ONES), 9, 0.5).energy_diameter(0.99999), "fraction must be reached within"),
        (lambda: lm.psf(Pupil(), 9, 0.5, method=MatrixFourier(32)).encircled_energy(16.1), "radius reaches 16.1"),
        (lambda: lm.psf(Pupil(), 33, 1.0, method=MatrixFourier(32)).energy, "the window reaches 16.5"),
        (lambda: lm.psf(Pupil(mask=ONES), 9, 0.5, blur=lm.Jitter(1.0)).encircled_energy(16.1), "radius reaches"),
    ],
)
def test_light_of_a_repeated_image_is_not_counted(call, message):
    with pytest.raises(ValueError, match=rf"{message}"):
        call()


def test_in_other_light_the_period_is_in_proportion():
    pupil = Pupil(mask=ONES, wavelength=500e-9, f_number=4.0)
    white = lm.psf(pupil, 9, 1e-6, method=Polychromatic([400e-9, 500e-9]))
    assert white.encircled_energy(16 * 0.79 * 2e-6) < 1.0
    with pytest.raises(ValueError, match=r"repeats every 25\.6 lambda"):
        white.encircled_energy(16 * 0.81 * 2e-6)


def test_seeing_whose_halo_a_repetition_would_reach_is_refused():
    coarse, fine = (Pupil(mask=Mask(np.ones((n, n)))) for n in (32, 512))
    with pytest.raises(lm.ToleranceError, match=r"repeats the image every 32 lambda\*N, but this seeing"):
        lm.psf(coarse, 9, 0.5, blur=lm.Seeing(1.0), tol=1e-3)
    seen = lm.psf(fine, 9, 0.5, blur=lm.Seeing(1.0), tol=1e-3)
    exact = lm.psf(Pupil(), 9, 0.5, blur=lm.Seeing(1.0), tol=1e-3)
    np.testing.assert_allclose(seen.values, exact.values, rtol=1e-2)
    with pytest.raises(ValueError, match="radius with the halo of the seeing reaches"):
        seen.encircled_energy(230.0)


CORNERS = np.zeros((5, 5))
CORNERS[::4, ::4] = 1.0  # cells with centres beyond the rim, whose fringes are finer than the cutoff


@pytest.mark.parametrize("values", [np.random.default_rng(5).uniform(size=(6, 6)), CORNERS], ids=["any", "corners"])
def test_energies_of_a_coarse_mask_are_those_of_its_samples(values):
    # The light within a circle by direct quadrature of the sum over samples.
    pupil = Pupil(mask=Mask(values))
    t, w = np.polynomial.legendre.leggauss(40)
    r, theta = 1.2 * (t + 1.0), 2.0 * math.pi * np.arange(96) / 96
    x, y, weight = pupil.rule(0)
    across, down = np.outer(r, np.cos(theta)), np.outer(r, np.sin(theta))
    waves = np.exp(-1j * math.pi * (np.multiply.outer(across, x) + np.multiply.outer(down, y)))
    light = (np.abs(waves @ weight) ** 2).mean(axis=1)
    exact = 0.5 * math.pi**2 * 1.2 * float((light * r) @ w) / pupil.transmission
    found = lm.psf(pupil, 5, 0.5, method=NonuniformFFT(1e-9)).encircled_energy(2.4)
    assert float(found) == pytest.approx(exact, abs=2e-7)
