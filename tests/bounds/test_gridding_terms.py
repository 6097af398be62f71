"""Interpolation between circles, term by term: docs/certificate.md 11."""

from __future__ import annotations

from functools import cache

import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import quad

from core_tests import _core_tests, instructions

KERNELS = [
    (10, 3.0),
    (10, 2.0),
    (8, 3.0),
    (8, 2.0),
    (8, 1.5),
    (6, 3.0),
    (6, 1.5),
    (4, 3.0),
    (4, 1.5),
    (3, 3.0),
    (2, 3.0),
]
NONE = np.array([])


@pytest.fixture(params=["avx512", "avx2", "portable"])
def level(request):
    with instructions(request.param):
        yield


@pytest.mark.parametrize("length", [48, 64, 96, 128, 144, 192, 384, 432, 512, 768])
@pytest.mark.parametrize(
    ("transform", "kind"), [(_core_tests.row_fft, np.float64), (_core_tests.row_fft_single, np.float32)]
)
@pytest.mark.usefixtures("level")
def test_transforms_are_those_of_numpy_within_their_bound(transform, kind, length):
    rng = np.random.default_rng(length)
    rows = rng.normal(size=(8, length)) + 1j * rng.normal(size=(8, length))
    rows *= rng.uniform(0.0, 1.0, (8, length)) ** 8
    rows[:, length // 4 : -(length // 4)] = 0.0
    passed, bound = transform(np.stack([rows.T.real, rows.T.imag], axis=1).astype(kind))
    # The last pass, X_{q + k n/4} = sum_j y_{q + j n/4} i^{jk}.
    parts = (passed[:, 0] + 1j * passed[:, 1].astype(np.float64)).reshape(4, length // 4, 8)
    found = 4.0 * np.fft.ifft(parts, axis=0).reshape(length, 8).T
    exact = length * np.fft.ifft(rows, axis=1)
    sums = np.abs(rows).sum(axis=1, keepdims=True)
    error = np.abs(found - exact).max(axis=1, keepdims=True)
    assert (error <= bound * sums).all()
    # A bound that is far from what happens would hide faults.
    assert bound < 110.0 * np.finfo(kind).eps
    assert error.max() > 1e-3 * (bound * sums).max()


@cache  # Integrals at all frequencies take the same nodes.
def bessel(x):
    return mp.besseli(1, x)


def shape(x, taps, beta):
    y = 1 - (2 * mp.mpf(x) / taps) ** 2
    return mp.sqrt(y) * bessel(beta * mp.sqrt(y)) / bessel(beta) if y > 0 else mp.mpf(0)


def transform(omega, taps, beta):
    y = mp.sqrt(mp.mpc(mp.mpf(beta) ** 2 - (taps * mp.mpf(omega) / 2) ** 2))
    return (taps * beta / bessel(beta) * (mp.cosh(y) - mp.sinh(y) / y) / y**2).real


@pytest.mark.parametrize(("taps", "oversampling"), KERNELS)
def test_the_transform_of_a_kernel_is_its_integral(taps, oversampling):
    omegas = np.linspace(0.0, np.pi, 7)
    beta = _core_tests.gridding_bounds(taps, oversampling, 1.0, NONE, NONE)["beta"]
    found = _core_tests.gridding_bounds(taps, oversampling, 1.0, np.linspace(-0.6, 0.6, 9) * taps, omegas)
    assert found["values"] == pytest.approx([float(shape(x, taps, beta)) for x in np.linspace(-0.6, 0.6, 9) * taps])
    for omega, value in zip(omegas, found["transforms"], strict=True):
        cells = np.linspace(0, 0.5 * taps, 9).tolist()
        integral = 2 * mp.quad(lambda x: shape(x, taps, beta) * mp.cos(omega * x), cells)  # noqa: B023
        assert value == pytest.approx(float(integral), rel=1e-9, abs=1e-12)


@pytest.mark.parametrize(("taps", "oversampling"), KERNELS)
def test_the_bound_on_aliases_is_that_of_the_certificate(taps, oversampling):
    omegas = np.array([0.0, 0.7, np.pi / oversampling])
    found = _core_tests.gridding_bounds(taps, oversampling, 1.0, NONE, omegas)
    beta = mp.mpf(found["beta"])
    scale = taps * beta / bessel(beta)

    def most(omega):
        square = (taps * omega / 2) ** 2 - beta**2
        return (
            transform(omega, taps, beta)
            if square <= 0
            else scale * min(mp.mpf(1) / 3, mp.sqrt(1 + 1 / square) / square)
        )

    far = taps * mp.pi * mp.mpf("64.5")
    rest = 1 - (beta / far) ** 2
    tail = scale * 2 * mp.sqrt(1 + 1 / (far**2 - beta**2)) / rest / (64 * (taps * mp.pi) ** 2)
    for omega, bound in zip(omegas, found["aliases"], strict=True):
        counted = mp.fsum(most(2 * mp.pi * k - omega) + most(2 * mp.pi * k) for k in range(1, 65))
        assert bound == pytest.approx(float((counted + tail) / transform(omega, taps, beta)), rel=1e-9, abs=0.0)


@pytest.mark.parametrize(("taps", "oversampling"), KERNELS)
def test_aliases_sum_to_no_more_than_their_bound(taps, oversampling):
    omegas = np.array([0.0, 0.4, 1.0, np.pi / oversampling])
    step = np.pi / oversampling
    found = _core_tests.gridding_bounds(taps, oversampling, step, NONE, omegas)
    beta = found["beta"]
    for omega, bound in zip(omegas, found["aliases"], strict=True):
        total = mp.fsum(
            abs(transform(omega + 2 * mp.pi * k, taps, beta)) for k in range(-300, 301) if k != 0
        ) / transform(omega, taps, beta)
        # The bound knows no sines, which may be small together.
        assert total <= bound <= 6.0 * total

    def squares(s):
        aliases = _core_tests.gridding_bounds(taps, oversampling, step, NONE, np.array([step * abs(s)]))["aliases"][0]
        return 2.0 / np.pi * np.sqrt(1.0 - s * s) * aliases**2

    exact = np.sqrt(2.0 * quad(squares, 0.0, 1.0, limit=60)[0])
    assert exact <= found["aliasing"] <= 1.1 * exact


@pytest.mark.parametrize(("taps", "oversampling"), KERNELS)
def test_polynomials_are_the_kernel_and_taps_weigh_no_more_than_their_bounds(taps, oversampling):
    found = _core_tests.gridding_bounds(taps, oversampling, 1.0, NONE, NONE)
    beta = found["beta"]
    worst = dict.fromkeys([("taps", "tap_error"), *([("coarse_taps", "coarse_error")] if taps <= 4 else [])], 0.0)
    for t in np.linspace(0.0, 1.0, 23):
        exact = [float(shape(t + taps / 2 - 1 - i, taps, beta)) for i in range(taps)]
        for names, largest in worst.items():
            made = np.polynomial.polynomial.polyval(2.0 * t - 1.0, np.array(found[names[0]])[::-1])
            worst[names] = max(largest, float(np.abs(made - exact).sum()))
        assert sum(exact) <= found["weight"]
        assert sum((taps - i) * tap for i, tap in enumerate(exact)) <= found["chain"]
    for (_, error), largest in worst.items():
        assert largest <= found[error] <= 1e4 * max(largest, 1e-15)
