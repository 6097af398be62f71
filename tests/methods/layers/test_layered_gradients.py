"""Gradients of microscope images by their values: sums of derivatives over pixels, and of plane waves."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel import _core
from lommel.methods import ChordalDebye, DebyeRings, Stratified
from objectives import EMITTERS, FIVE, OIL
from plane_waves import PIXEL, intensity

WAVE = 520e-9
NAMES = ("z", "depth", "row", "column", (2, 2), "noll 7", (4, 0), "fringe 2")
OWN = lm.Wavefront.zernike({5: [[0.1], [0.2]], 8: [[0.0], [0.1]]}, order="noll", unit="waves")


def stack(emitter="isotropic", aberrations=FIVE, depth=((0.2e-6,), (2e-6,)), z=(-0.3e-6, 0.1e-6, 0.4e-6)):
    """Return two depths and three stages."""
    return OIL.pupil(depth=depth, z=z, wavelength=WAVE, emitter=emitter, aberrations=aberrations)


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize("normalize", ["energy", "emitted"])
@pytest.mark.parametrize("emitter", [EMITTERS[0], EMITTERS[2], EMITTERS[3], EMITTERS[7]], ids=repr)
def test_a_gradient_is_the_sum_over_pixels_of_derivatives(emitter, normalize, integrate):
    asked = {"normalize": normalize, "integrate": integrate, "dtype": np.float64, "tol": 1e-10}
    answer = lm.psf(stack(emitter), (7, 8), PIXEL, derivatives=NAMES, **asked)
    g = np.random.default_rng(1).normal(size=answer.shape)
    found = answer.pullback(g)
    assert list(found) == list(answer.derivatives)
    for name, slope in answer.derivatives.items():
        assert found[name].shape == (2, 3)
        size = np.abs(g * slope).sum(axis=(-2, -1)).max()
        allowed = 4.0 * answer.derivative_bounds[name] * (np.abs(g) * answer.values.max()).sum(axis=(-2, -1)).max()
        assert np.abs(found[name] - (g * slope).sum(axis=(-2, -1))).max() <= min(1e-8 * size, allowed + 1e-12 * size)
    some = answer.pullback(g, of=["row", (2, 2)])
    assert list(some) == ["row", (2, 2)]
    assert some["row"] == pytest.approx(found["row"], rel=1e-8, abs=1e-9 * np.abs(found["row"]).max())


@pytest.mark.parametrize("level", ["portable", "avx2", "avx512"])
def test_axes_and_wavefronts_of_their_own_with_all_instructions(level):
    center = np.array([[3.0, 3.4, 2.2], [3.1, 2.9, 3.3]]), np.array([3.0, 3.1, 4.0])
    asked = {"center": center, "dtype": np.float64, "tol": 1e-9, "threads": 2}
    _core.limit_instructions(level)
    try:
        answer = lm.psf(stack(aberrations=OWN), 7, PIXEL, derivatives=("z", "column", "noll 8"), **asked)
        g = np.random.default_rng(2).normal(size=answer.shape)
        found = answer.pullback(g)
    finally:
        _core.limit_instructions("avx512")
    for name, slope in answer.derivatives.items():
        exact = (g * slope).sum(axis=(-2, -1))
        assert np.abs(found[name] - exact).max() <= 1e-7 * np.abs(exact).max()


@pytest.mark.parametrize("emitter", [EMITTERS[0], EMITTERS[1], EMITTERS[5]], ids=repr)
def test_the_gradient_of_a_loss_is_that_of_plane_waves(emitter):
    terms = [(2, 2), (3, -1), (4, 0), (5, 3), (1, 1)]
    y, x = np.mgrid[-2:3, -3:4] * PIXEL
    g = np.random.default_rng(3).normal(size=(1, 5, 7))

    def pupil(z=0.3e-6, depth=0.5e-6, **by):
        edge = {terms[int(k[1:])]: c for k, c in by.items()} or {(2, 0): 0.0}
        more = lm.Wavefront.zernike(edge, normalization="edge")
        given = {"origin": "coverslip", "wavelength": WAVE, "emitter": emitter}
        return OIL.pupil(depth=[depth], z=0.6e-6 + z, aberrations=FIVE + more, **given)

    answer = lm.psf(pupil(), (5, 7), PIXEL, integrate=False, dtype=np.float64, tol=1e-9)
    found = answer.pullback(g, ["z", "depth", *terms])

    def loss(**by):
        at = pupil(**by)
        return (g.ravel() @ intensity(OIL, at, x.ravel(), y.ravel(), 70, 128)[0] / at.power[0]) * answer.scale[0]

    steps = {"z": ("z", 0.3e-6, 2e-9), "depth": ("depth", 0.5e-6, 2e-9)}
    steps |= {term: (f"c{k}", 0.0, 2e-3) for k, term in enumerate(terms)}
    for name, (argument, at, h) in steps.items():
        ends = [loss(**{argument: at + s * h}) for s in (1.0, -1.0, 2.0, -2.0)]
        exact = (8.0 * (ends[0] - ends[1]) - (ends[2] - ends[3])) / (12.0 * h)
        assert found[name][0] == pytest.approx(exact, rel=2e-8), name


def test_without_names_it_is_by_the_terms_of_the_aberrations():
    answer = lm.psf(stack(), 7, PIXEL)
    assert tuple(answer.pullback(answer.values)) == FIVE.terms
    plain = lm.psf(stack(aberrations=None), 7, PIXEL)
    assert plain.pullback(plain.values) == {}


def test_without_aberrations_terms_are_by_chords_and_all_else_by_rings():
    pupil = stack(aberrations=None)
    answer = lm.psf(pupil, 9, PIXEL, dtype=np.float64, tol=1e-9)
    g = np.random.default_rng(5).normal(size=answer.shape)
    found = answer.pullback(g, ["z", "row", (2, 2), "noll 7"])
    made = lm.psf(pupil, 9, PIXEL, dtype=np.float64, tol=1e-9, derivatives=tuple(found))
    assert isinstance(made.method, ChordalDebye)
    assert isinstance(answer.method, Stratified)
    alone = answer.pullback(g, ["z", "row"])
    for name, slope in made.derivatives.items():
        exact = (g * slope).sum(axis=(-2, -1))
        for one in (found, alone) if name in alone else (found,):
            assert np.abs(one[name] - exact).max() <= 1e-7 * np.abs(exact).max(), name


def test_circles_have_the_gradient_by_chords_and_by_the_axis_in_any_window():
    pupil = stack(depth=2e-6, z=[0.1e-6, 0.4e-6])
    answer = lm.psf(pupil, 9, PIXEL, method=DebyeRings(1e-7), dtype=np.float64)
    g = np.random.default_rng(4).normal(size=answer.shape)
    assert isinstance(lm.psf(pupil, 9, PIXEL).method, ChordalDebye)
    exact = lm.psf(pupil, 9, PIXEL, dtype=np.float64, tol=1e-9).pullback(g, ["z", (2, 2)])
    found = answer.pullback(g, ["z", (2, 2)])
    for name in exact:
        assert found[name] == pytest.approx(exact[name], rel=1e-5)
    large = lm.psf(pupil[0], 255, PIXEL, tol=1e-3)
    for name in ("z", (2, 2)):
        with pytest.raises(ValueError, match="use a smaller shape"):
            large.pullback(large.values, [name])
    ramp = large.values * np.arange(255)[:, None]
    by_sum = (ramp * lm.psf(pupil[0], 255, PIXEL, tol=1e-3, derivatives=("row",)).derivatives["row"]).sum()
    assert large.pullback(ramp, ["row"])["row"] == pytest.approx(by_sum, rel=1e-3)


def test_many_planes_have_derivatives_by_terms_too():
    pupil = stack(depth=2e-6, z=np.linspace(-1e-7, 1e-7, 40))
    assert isinstance(lm.psf(pupil, 25, PIXEL, tol=1e-3).method, DebyeRings)
    made = lm.psf(pupil, 25, PIXEL, tol=1e-3, derivatives=((2, 2),))
    found = made.pullback(made.values)[2, 2]
    exact = (made.values * made.derivatives[2, 2]).sum(axis=(1, 2))
    assert np.abs(found - exact).max() <= 1e-3 * np.abs(exact).max()
