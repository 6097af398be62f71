"""Averages over pixels wide against the rings: their bound, and that of the light left out with the rings."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from scipy.special import j0

import lommel as lm
from lommel import _core

# Panels of I along the radius, each 4 wide in v.
NODES = np.polynomial.chebyshev.chebpts1(26)


def profile(pupil: lm.Pupil, reach: float):
    """Return I by quadrature over the pupil, as a function of v up to a reach."""
    x, w = np.polynomial.legendre.leggauss(int(60 + 0.6 * reach + 2 * np.abs(pupil.coefficients()).sum()))
    low = pupil.obscuration
    rho, w = low + (1 - low) * 0.5 * (x + 1), 0.5 * (1 - low) * w
    t = rho * rho
    phase = sum(c * t ** (k + 1) for k, c in enumerate(pupil.coefficients()[0]))
    light = 2 * rho * w * np.exp(1j * phase - pupil.apodization * t)
    panels = int(reach / 4) + 1
    v = 4 * np.arange(panels)[:, None] + 2 + 2 * NODES
    at = np.array([np.abs(light @ j0(np.outer(rho, row))) ** 2 for row in v])
    series = np.linalg.solve(np.polynomial.chebyshev.chebvander(NODES, NODES.size - 1), at.T)

    def intensity(r: np.ndarray) -> np.ndarray:
        place = np.minimum(panels - 1, (r / 4).astype(int))
        x = r / 2 - 2 * place - 1
        return np.polynomial.chebyshev.chebval(x, series[:, place], tensor=False)

    return intensity


def question(seed: int):
    rng = np.random.default_rng(seed)
    c = rng.uniform(-1, 1, 3) * 10.0 ** rng.uniform(-1, 1.3)
    pupil = lm.Pupil(
        lm.Wavefront(c[0], c[1], [c[2]] if seed % 2 else ()),
        obscuration=(0.0, 0.3, 0.0, 0.7)[seed % 4],
        apodization=(0.0, 0.0, 1.2)[seed % 3],
    )
    step = 8.0 * 10.0 ** rng.uniform(0, 0.9)
    side = int(rng.integers(3, 14))
    centers = (None, (side / 2 - 0.5, side / 2), tuple(side / 2 + rng.uniform(-1, 1, 2)), (-1.3, side / 3))
    return pupil, side, step, centers[seed % 5 % 4], 10.0 ** rng.uniform(-9.5, -2)


@pytest.mark.parametrize("seed", range(40))
def test_averages_over_coarse_pixels_are_within_their_bound(seed):
    pupil, side, step, center, tol = question(seed)
    options = {"dtype": np.float64, "integrate": True, "normalize": "energy"}
    found = lm.psf(pupil, side, step / math.pi, center=center, method=lm.NijboerZernike(tol), **options)
    row, column = found.grid.center
    x, w = np.polynomial.legendre.leggauss(int(0.9 * step) + 14)
    intensity = profile(pupil, step * (math.hypot(side, side) + 4))

    def average(down: float, across: float) -> float:
        r = step * np.hypot(down + 0.5 * x[:, None], across + 0.5 * x)
        return float(0.25 * w @ intensity(r.ravel()).reshape(r.shape) @ w)

    rng = np.random.default_rng(seed)
    places = [(round(row), round(column)), (round(row), round(column) + 1), *rng.integers(0, side, (12, 2)).tolist()]
    inside = [(y, x) for y, x in places if 0 <= y < side and 0 <= x < side]
    exact = np.array([average(y - row, x - column) for y, x in inside]) * float(found.scale)
    peak = max(exact.max(), average(0.0, 0.0) * float(found.scale))
    got = np.array([found.values[place] for place in inside])
    assert np.abs(got - exact).max() <= found.error_bound * peak + 1e-13 * float(found.scale)
    assert found.error_bound <= tol


@pytest.mark.parametrize("gaussian", [0.0, 1.5])
@pytest.mark.parametrize("obscuration", [0.0, 0.2, 0.6])
@pytest.mark.parametrize("phase", [[0.3], [4.0, -1.5], [-2.0, 0.5, 0.8]])
def test_the_light_beyond_a_circle_is_its_mean_within_the_bound(phase, obscuration, gaussian):
    pupil = lm.Pupil(
        lm.Wavefront.zernike({(2 * j + 2, 0): c for j, c in enumerate(phase)}, unit="radians", normalization="edge"),
        obscuration=obscuration,
        apodization=gaussian,
    )
    low = mp.mpf(obscuration) ** 2
    light = float(mp.quad(lambda t: mp.exp(-2 * gaussian * t), [low, 1]))
    reach = 400.0
    intensity = profile(pupil, reach)
    x, w = np.polynomial.legendre.leggauss(20)
    panels = np.arange(int(reach / 2))[:, None] * 2.0 + 1.0 + x
    inside = np.cumsum((intensity(panels.ravel()).reshape(panels.shape) * panels) @ w)
    shares = []
    for r in np.geomspace(40, reach - 4, 60):
        k = int(r / 2)
        bound = _core.tail_bounds(np.array(phase), np.array([0.0, gaussian]), obscuration, 2.0 * k)
        left = abs(2 * light - inside[k - 1] - bound["mean"] / (2.0 * k))
        most = bound["rings"] + (2.0 * k) ** 2 * bound["curved"]
        assert left <= most + 1e-11
        shares.append(left / most)
    if gaussian == 0.0 and max(map(abs, phase)) < 1:
        assert max(shares) > 0.2


@pytest.mark.parametrize(
    ("phase", "obscuration", "gaussian"),
    [((0.0,), 0.0, 0.0), ((0.8, 0.5), 0.0, 1.5), ((0.8, 0.5), 0.3, 0.0), ((0.8, 0.5), 0.5, 1.5)],
)
def test_what_the_mean_leaves_out_of_the_light_without_its_rings(phase, obscuration, gaussian):
    """A smooth window, in which rings vanish, of I r^3."""
    pupil = lm.Pupil(
        lm.Wavefront.zernike({(2 * j + 2, 0): c for j, c in enumerate(phase)}, unit="radians", normalization="edge"),
        obscuration=obscuration,
        apodization=gaussian,
    )
    x = np.linspace(-1.0, 1.0, 4001)[1:-1]
    r, window = 160.0 + 100.0 * x, np.exp(-1.0 / (1.0 - x * x))
    bounds = [_core.tail_bounds(np.array(phase), np.array([0.0, gaussian]), obscuration, at) for at in r]
    left = window @ (profile(pupil, 261.0)(r) * r**3 - bounds[0]["mean"])
    assert left == pytest.approx(window @ (r**3 * [each["curved"] for each in bounds]), rel=0.01)


def test_coarse_pixels_hold_all_the_light():
    pupil = lm.Pupil(lm.Wavefront.from_seidel(W020=0.6), wavelength=550e-9, f_number=4)
    for pixel in (20e-6, 50e-6, 500e-6):
        found = lm.psf(pupil, 129, pixel, dtype=np.float64)
        # What is beyond a circle falls as its radius: 2 / pi^2 of the light beyond lambda N times r.
        outside = 2 / math.pi**2 * pupil.scale / pixel / 64.5
        assert 1 - 1.3 * outside < found.values.sum() < 1 - 0.8 * outside
