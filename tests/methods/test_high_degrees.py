"""Radially symmetric terms of high degree, whose powers of rho cancel: certified like any others."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import eval_legendre, j0

import lommel as lm
from lommel.methods import ChordalGauss, Hankel, NijboerZernike

TERMS = [{(20, 0): 8.0}, {(60, 0): 8.0}, {(60, 0): -3.0, (58, 0): 2.0, (20, 0): 5.0, (2, 0): 30.0}]


def field(terms, obscuration: float, gaussian: float, v: np.ndarray, power: int = 0) -> np.ndarray:
    """Return the integral of t^power A exp(i Phi) J0 by quadrature in t, of SciPy's polynomials."""
    x, w = np.polynomial.legendre.leggauss(500)
    low = obscuration**2
    t, w = low + (1 - low) * 0.5 * (x + 1), 0.5 * (1 - low) * w
    phase = sum(c * eval_legendre(n // 2, 2 * t - 1) for (n, _), c in terms.items())
    return j0(np.sqrt(t) * v.ravel()[:, None]) @ (w * t**power * np.exp(1j * phase - gaussian * t))


def pupil_of(terms, obscuration: float = 0.0, gaussian: float = 0.0) -> lm.Pupil:
    wavefront = lm.Wavefront.zernike(terms, normalization="edge")
    assert wavefront.left_out == 0.0
    return lm.Pupil(wavefront, obscuration=obscuration, apodization=gaussian)


@pytest.mark.parametrize("terms", TERMS)
@pytest.mark.parametrize(("obscuration", "gaussian"), [(0.0, 0.0), (0.35, 0.0), (0.35, 1.5)])
@pytest.mark.parametrize("tol", [1e-6, 1e-10])
def test_samples_and_the_derivative_by_defocus(terms, obscuration, gaussian, tol):
    pupil = pupil_of(terms, obscuration, gaussian)
    method = NijboerZernike(tol)
    answer = lm.psf(
        pupil, 25, 0.6, method=method, dtype=np.float64, derivatives=("defocus",), normalize="strehl", integrate=False
    )
    v = np.pi * 0.6 * np.hypot(*(np.indices((25, 25)) - 12.0))
    u, slope = (field(terms, obscuration, gaussian, v, k).reshape(v.shape) for k in (0, 1))
    exact = float(answer.scale) * np.abs(u) ** 2
    assert np.abs(answer.values - exact).max() / exact.max() <= answer.error_bound + 1e-14
    assert answer.error_bound <= tol
    change = float(answer.scale) * 4 * (u.conj() * 1j * slope).real
    missed = np.abs(answer.derivatives["defocus"] - change).max() / exact.max()
    assert missed <= answer.derivative_bounds["defocus"] + 1e-13
    assert np.abs(change).max() > 1e3 * missed


@pytest.mark.parametrize("terms", TERMS)
@pytest.mark.parametrize("center", [None, (3.3, 2.1)])
def test_averages_over_pixels(terms, center):
    pupil, shape, pixel = pupil_of(terms, 0.35, 1.5), (7, 6), 0.9
    answer = lm.psf(pupil, shape, pixel, method=NijboerZernike(1e-9), dtype=np.float64, integrate=True, center=center)
    x, w = np.polynomial.legendre.leggauss(12)
    rows, columns = (
        part[..., None, None] - at for part, at in zip(np.indices(shape), answer.grid.center, strict=True)
    )
    v = np.pi * pixel * np.hypot(rows + 0.5 * x[:, None], columns + 0.5 * x)
    sampled = np.abs(field(terms, 0.35, 1.5, v).reshape(v.shape)) ** 2
    exact = float(answer.scale) * np.einsum("yxij,i,j->yx", sampled, 0.5 * w, 0.5 * w)
    assert np.abs(answer.values - exact).max() / exact.max() <= answer.error_bound <= 1e-9


@pytest.mark.parametrize("terms", TERMS)
def test_the_field_along_radii_has_the_phase_that_is_0_on_the_axis(terms):
    v = np.linspace(0.0, 80.0, 60)
    values, bound = NijboerZernike(1e-9).evaluate(pupil_of(terms, 0.35), v)
    exact = field(terms, 0.35, 0.0, v) * np.exp(-1j * sum(c * (-1) ** (n // 2) for (n, _), c in terms.items()))
    assert np.abs(values[0] - exact).max() <= bound[0]
    reference, estimate = Hankel(1e-10).evaluate(pupil_of(terms, 0.35), v)
    assert np.abs(values - reference).max() <= bound[0] + estimate[0]


@pytest.mark.parametrize("method", [NijboerZernike, ChordalGauss])
@pytest.mark.parametrize("terms", [{(20, 0): 8.0}, {(60, 0): 2.0}])
def test_terms_of_no_direction_beside_such_that_have_one(method, terms):
    """A term that is too small to matter takes them to the engines of the whole disk."""
    beside = pupil_of(terms | {(2, 2): 1e-14}, 0.35)
    assert not beside.radial
    asked = {"dtype": np.float64, "integrate": False, "normalize": "strehl"}
    one = lm.psf(beside, 17, 0.4, method=method(1e-9), **asked)
    other = lm.psf(pupil_of(terms, 0.35), 17, 0.4, method=NijboerZernike(1e-11), **asked)
    assert lm.peak_error(one, other) <= one.error_bound + other.error_bound
    assert one.error_bound <= 1e-9
