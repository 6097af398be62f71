"""Gradients by the values: sums over the pixels of derivatives, whichever way they are computed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import lommel as lm

LENS = lm.Lens(
    focal_length=50e-3,
    f_number=2.8,
    focus_distance=2.0,
    wavelength=5.5e-7,
    obscuration=0.3,
    aberrations=lm.Wavefront(0.0, 0.7, nonradial={(3, 1): 0.9, (2, -2): 0.4}),
)
BY_PHASE = ("defocus", "spherical", "rho^6", (3, 1), "noll 7", "row", "column", "object_distance")
OTHERS = ("wavelength", "f_number", "obscuration", "focus_distance")
WHITE = lm.methods.Polychromatic([5e-7, 6e-7], [1, 2])


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize("normalize", ["energy", "strehl"])
@pytest.mark.parametrize("method", [None, lm.methods.ChordalGauss(), WHITE])
def test_a_gradient_is_the_sum_over_pixels_of_derivatives(method, normalize, integrate):
    asked = {"method": method, "normalize": normalize, "integrate": integrate, "dtype": np.float64, "tol": 1e-11}
    answer = lm.psf(LENS.pupil([1.95, 2.1]), (7, 8), 1.5e-6, derivatives=BY_PHASE + OTHERS, **asked)
    g = np.random.default_rng(1).normal(size=answer.shape)
    found = answer.pullback(g)
    assert list(found) == list(answer.derivatives)
    for name, slope in answer.derivatives.items():
        assert found[name].shape == (2,)
        size = np.abs(g * slope).sum(axis=(1, 2))
        assert (np.abs(found[name] - (g * slope).sum(axis=(1, 2))) <= 1e-12 * size.max()).all(), name
    some = answer.pullback(g, of=["row", (3, 1)])
    assert list(some) == ["row", (3, 1)]
    assert some["row"] == pytest.approx(found["row"], rel=1e-12)


def test_radial_pupils_take_the_series_and_whatever_it_lacks_the_chordal_rule():
    answer = lm.psf(lm.Pupil(lm.Wavefront(3.0, 1.0)), 9, 0.5, dtype=np.float64, tol=1e-11)
    g = np.random.default_rng(2).normal(size=answer.shape)
    for names in (("defocus", (4, 0), "rho^8"), ("defocus", (3, 1), "row")):
        found = answer.pullback(g, names)
        expected = lm.psf(answer.pupil, 9, 0.5, dtype=np.float64, tol=1e-11, derivatives=names)
        for name, slope in expected.derivatives.items():
            assert found[name].shape == ()
            assert found[name] == pytest.approx((g * slope).sum(), abs=1e-12 * np.abs(g * slope).sum())


def test_it_is_the_gradient_of_a_misfit():
    def misfit(h: float) -> float:
        pupil = replace(LENS, aberrations=LENS.aberrations + lm.Wavefront(nonradial={(3, 1): h})).pupil(1.95)
        values = lm.psf(pupil, 9, 1.5e-6, tol=1e-11).values
        return float(((values - 1e-3) ** 2).sum())

    answer = lm.psf(LENS.pupil(1.95), 9, 1.5e-6, tol=1e-10)
    h = 1e-3
    exact = (8.0 * (misfit(h) - misfit(-h)) - misfit(2 * h) + misfit(-2 * h)) / (12.0 * h)
    found = answer.pullback(2.0 * (answer.values - 1e-3), [(3, 1)])[3, 1]
    assert found == pytest.approx(exact, rel=1e-7)


def test_a_gradient_of_another_shape_is_refused():
    with pytest.raises(ValueError, match=r"g must have the shape of the values, \(9, 9\), got \(3, 27\)"):
        lm.psf(lm.Pupil(), 9, 0.5).pullback(np.zeros((3, 27)))


def test_what_has_no_derivatives_has_no_gradient():
    for more, told in (
        ({"normalize": "peak"}, "kinks"),
        ({"method": lm.methods.Hankel()}, "derivatives are not available from Hankel"),
    ):
        answer = lm.psf(lm.Pupil(), 9, 0.5, **more)
        with pytest.raises(ValueError, match=told):
            answer.pullback(answer.values)
