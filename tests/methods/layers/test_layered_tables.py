"""Tables, disc means and random systems of layers."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import j0, j1, jv

import lommel as lm
from lommel.core.answers import Wanted
from lommel.core.engine import Window, layered_images
from lommel.methods import ChordalDebye, DebyeWolf, Stratified
from lommel.methods.layers.samples import disc_means
from lommel.methods.layers.stratified import layered
from objectives import OIL, OIL_60X, WATER_40X, oil
from plane_waves import intensity


def planes(**given):
    return OIL.pupil(depth=2e-6, z=[-0.6e-6, 0.1e-6], wavelength=520e-9, **given)


def corner(side, step):
    """How far the corner of a window is from its middle."""
    return float(np.hypot(side // 2, side // 2)) * step


def test_what_is_between_radii_is_off_by_no_more_than_is_said():
    # Of fields that are exact all error is that of polynomials.
    pupil, side, step = planes(), 65, 0.61
    asked = layered(pupil, corner(side, step), 1e-13)
    made = layered_images(asked, Window((side, side), (32.0, 32.0), step), 3e-2, Wanted(1.0, np.float64))
    line = DebyeWolf(1e-12).profile(pupil, step * np.arange(33.0)).values
    off = np.abs(made.values[:, 32, 32:] - line).max(axis=1)
    assert np.all(off <= made.error * made.peak)
    assert off.max() > 1e-8


def test_windows_of_two_pitches_do_not_share_what_is_between_their_radii():
    pupil = planes()
    for pixel in (6.5e-6, 6.49e-6, 6.5e-6):
        made = lm.psf(pupil, 65, pixel, integrate=False, normalize="strehl", dtype=np.float64)
        exact = DebyeWolf(1e-9).profile(pupil, pupil.v(pixel * np.arange(33.0))).values
        assert np.all(np.abs(made.values[:, 32, 32:] - exact).max(axis=1) <= 1e-6 * exact.max(axis=1))


def test_the_last_radius_is_in_the_last_piece_however_it_rounds():
    pupil, side = planes()[:1], 49
    steps = 0.55 + 0.0137 * np.arange(60)
    asked = layered(pupil, corner(side, steps[-1]), 1e-9)
    exact = DebyeWolf(1e-9).profile(pupil, np.array([corner(side, step) for step in steps])).values[0]
    for step, known in zip(steps, exact, strict=True):
        window = Window((side, side), (24.0, 24.0), float(step))
        made = layered_images(asked, window, 1e-9, Wanted(1.0, np.float64))
        assert abs(made.values[0, 0, 0] - known) <= 1e-8


def test_a_longer_table_of_bessel_functions_follows_a_shorter_one():
    pupil = planes()
    for far in (600.0, 1500.0):
        v = np.array([0.0, 0.9 * far, far])
        made, exact = (way(1e-9).profile(pupil, v).values for way in (Stratified, DebyeWolf))
        assert made == pytest.approx(exact, abs=1e-10)
        assert exact[:, 2].min() > 1e-9


V = np.array([0.0, 0.3, 1.7, 5.0, 17.3, 120.0])


@pytest.mark.parametrize("radius", [1e-3, 0.4, 3.8, 25.0])
@pytest.mark.parametrize("error", [1e-3, 1e-6, 1e-10])
@pytest.mark.parametrize("frequency", [2.0, 1.3, 0.0])
def test_means_of_a_wave_are_within_the_bound(radius, error, frequency):
    # (1 + J0(q v)) / 2 lies between 0 and 1; its mean over a disc is that times 2 J1(q a) / (q a).
    means = disc_means(V, radius, error)
    at = frequency * radius
    known = 0.5 * (1.0 + j0(frequency * V) * (2.0 * j1(at) / at if at else 1.0))
    found = 0.5 * (1.0 + j0(frequency * means.places)) @ means.weights[0]
    assert np.abs(found - known).max() <= means.error
    assert means.error <= 1.01 * error


@pytest.mark.parametrize("radius", [0.4, 3.8])
@pytest.mark.parametrize("error", [1e-3, 1e-10])
def test_means_of_orders_of_the_azimuth_are_within_the_bound(radius, error):
    # J_m(q r) cos(m phi), too, is a sum of waves of the frequency q, whose means over discs are alike.
    means = disc_means(V, radius, error, 4)
    orders = np.abs(np.arange(-4, 5))
    found = means.of(0.1 * jv(orders[:, None], 2.0 * means.places)[None])[0]
    known = 0.1 * jv(orders[:, None], 2.0 * V) * j1(2.0 * radius) / radius
    assert np.abs(found - known).max() <= means.error


def test_far_discs_take_no_values_elsewhere():
    assert disc_means(np.array([1e5]), 1.0, 1e-6).places.min() > 1e5 - 10.0


DRY = lm.Objective(
    NA=0.8, magnification=40, immersion=1.0, working_distance=0.5e-3, coverslip=lm.Layer(1.5255, 17e-5), sample=1.36
)
TIRF = lm.Objective(
    NA=1.49,
    magnification=100,
    immersion=1.518,
    working_distance=0.12e-3,
    coverslip=lm.Layer(1.5255, 17e-5),
    sample=1.33,
)
OBJECTIVES = [OIL, OIL_60X, WATER_40X, DRY, TIRF, oil(films=[lm.Layer(1.9, 8e-8)])]


def system(seed):
    """Return an objective, a pupil, and a wavefront that may be added to its aberrations."""
    rng = np.random.default_rng(seed)
    objective = OBJECTIVES[rng.integers(len(OBJECTIVES))]
    dipole = rng.uniform(0.0, np.pi), rng.uniform(-3.0, 3.0)
    jones = complex(rng.normal()), complex(rng.normal(), rng.normal())
    emitters = ["isotropic", lm.Dipole(*dipole), lm.Dipole(*dipole, wobble=rng.uniform()), lm.Scalar("aplanatic")]
    emitters += [lm.Beam(), lm.Beam(jones), lm.Beam("radial"), lm.Beam("azimuthal"), lm.Beam("vortex")]
    degree = int(rng.integers(2, 8))
    terms = {(n, m): rng.normal() for n in range(1, degree + 1) for m in range(-n, n + 1, 2) if rng.random() < 0.5}
    size = np.sqrt(sum(c * c for c in terms.values())) or 1.0
    rms = 2.0 * np.pi * rng.uniform(0.0, 0.25)
    wavefront = lm.Wavefront.zernike({term: c * rms / size for term, c in terms.items()})
    given = {"depth": 10.0 ** rng.uniform(-8.5, -5.3), "wavelength": rng.uniform(450e-9, 700e-9)}
    emitter = emitters[rng.integers(len(emitters))]
    pupil = objective.pupil(**given, z=rng.uniform(-8e-7, 8e-7), emitter=emitter, aberrations=wavefront)
    return rng, objective, pupil


@pytest.mark.parametrize("seed", range(48))
def test_samples_and_slopes_are_within_their_bounds(seed):
    rng, objective, pupil = system(seed)
    tol, pixel = 10.0 ** rng.uniform(-8.0, -2.0), rng.uniform(0.1, 0.8) * pupil.scale
    center = tuple(rng.uniform(-0.5, 3.5, 2))
    asked = {"center": center, "integrate": False, "dtype": np.float64, "method": ChordalDebye(tol)}
    made = lm.psf(pupil, (4, 3), pixel, derivatives=("row", "column"), **asked)
    y, x = (pixel * (np.arange(side) - at) for side, at in zip((4, 3), center, strict=True))

    def exact(down=0.0, across=0.0):
        places = np.meshgrid(y - down * pixel, x - across * pixel, indexing="ij")
        light = intensity(objective, pupil, places[1].ravel(), places[0].ravel(), 72, 128)
        return light.reshape(4, 3) / pupil.power[0] * made.scale

    known = exact()
    assert np.abs(made.values - known).max() <= (made.error_bound + 2e-10) * known.max()
    assert made.error_bound <= tol
    h = 1e-2
    for name in ("row", "column"):
        ends = [exact(s * h, 0.0) if name == "row" else exact(0.0, s * h) for s in (1, -1, 2, -2)]
        slope = (8.0 * (ends[0] - ends[1]) - (ends[2] - ends[3])) / (12.0 * h)
        off = np.abs(made.derivatives[name] - slope).max()
        assert (
            off <= made.derivative_bounds[name] * made.values.max() + 1e-7 * np.abs(slope).max() + 1e-8 * known.max()
        )
