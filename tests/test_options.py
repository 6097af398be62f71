"""Every option of psf() for every pupil, in metres and in lambda*N: what it says it is, by direct quadrature."""

from __future__ import annotations

import itertools
import math
from functools import lru_cache

import numpy as np
import pytest

import lommel as lm
from cases import check_each

WAVELENGTH, F_NUMBER = 500e-9, 2.0
RADIAL = lm.Wavefront(1.5, 0.7)
COMA = lm.Wavefront(0.8, nonradial={(3, 1): 0.7, (2, -2): 0.5})

APERTURES = {
    "disc": {},
    "annulus": {"obscuration": 0.33},
    "vanes": {"spider": lm.Spider.equal(3, width=0.15), "obscuration": 0.2},
    "cat's eye": {"vignetting": lm.CatEye((0.4, 0.1))},
    "ellipse": {"vignetting": lm.Ellipse(0.9, 0.6)},
    "mask": {"mask": lm.Mask(np.hypot(*np.mgrid[-1:1:64j, -0.9:1:64j]) < 0.8)},
}
PUPILS = {
    "radial": {"wavefront": RADIAL},
    "zernike": {"wavefront": COMA},
    "apodized": {"wavefront": RADIAL, "apodization": 1.0},
    # Darkest in a ring: 0.8 of its largest amplitude in the middle, 0.7, and 1 at the rim.
    "ringed": {"wavefront": RADIAL, "apodization": lm.Apodization([1.0, -1.6, 0.37])},
    "ringed zernike": {"wavefront": COMA, "apodization": lm.Apodization([1.0, -1.6, 0.37])},
}
SPECTRUM = lm.methods.Polychromatic([420e-9, 500e-9, 640e-9], [1, 2, 1])
PLACES = [(1, 2), (3, 0)]  # pixels looked at
SHAPE = (4, 3)


def drawn(apodization: float | lm.Apodization, t: np.ndarray) -> np.ndarray:
    """Return the amplitude by its definition: 1 where it is largest."""
    powers = [apodization] if isinstance(apodization, float) else apodization.powers
    ends = np.linspace(0.0, 1.0, 200_001)
    exponent, least = (np.polynomial.polynomial.polyval(at, [0.0, *powers]) for at in (t, ends))
    return np.exp(least.min() - exponent)


@lru_cache(maxsize=64)
def rule(aperture: str, pupil: str) -> tuple[np.ndarray, ...]:
    """Return x, y, weight times amplitude, and phase on the aperture: polar, or a lattice of a row and a column."""
    made = lm.Pupil(**PUPILS[pupil], **APERTURES[aperture])
    if made.circular:
        x, w = np.polynomial.legendre.leggauss(40)
        low = made.obscuration**2
        rho = np.sqrt(low + (1.0 - low) * 0.5 * (x + 1.0))
        theta = np.linspace(0.0, 2.0 * math.pi, 128, endpoint=False)
        px, py = np.outer(rho, np.cos(theta)), np.outer(rho, np.sin(theta))
        weight = np.repeat((1.0 - low) * 0.5 * w[:, None] / 128, 128, axis=1)
    else:
        across = (np.arange(256) + 0.5) / 128 - 1.0
        px, py = across, across[:, None]
        weight = (made.opening.margin(*np.meshgrid(across, across)) >= -1e-12) / (math.pi * 128**2)
        if made.mask is not None:
            weight = weight * made.mask.at(*np.meshgrid(across, across))
    rho = np.hypot(px, py)
    phase = PUPILS[pupil]["wavefront"].phase(rho, np.arctan2(py, px) + np.zeros(rho.shape))
    return px, py, weight * drawn(made.apodization, rho**2), phase


def expected(aperture: str, pupil: str, step: float, center: tuple[float, float], averages: bool, spectrum: bool):
    """Return I at, or averaged over, the places, by sums over the aperture."""
    px, py, weight, phase = rule(aperture, pupil)
    parts = [(1.0, 1.0)]
    if spectrum:
        parts = [
            (share * (WAVELENGTH / w) ** 2, WAVELENGTH / w)
            for w, share in zip(SPECTRUM.wavelengths, SPECTRUM.weights, strict=True)
        ]
    x, w = np.polynomial.legendre.leggauss(7) if averages else (np.zeros(1), np.array([2.0]))
    found = np.zeros(len(PLACES))
    for share, scale in parts:
        field = weight * np.exp(1j * scale * phase)
        for i, (row, column) in enumerate(PLACES):
            vy, vx = (scale * step * (at + 0.5 * x - c) for at, c in zip((row, column), center, strict=True))
            # exp(-i (vy y + vx x)) for all pairs: products of matrices.
            down, across = np.exp(-1j * np.outer(vy, py)), np.exp(-1j * np.outer(px, vx))
            u = down @ field @ across if px.ndim == 1 else (down * field.ravel()) @ across
            found[i] += share * 0.25 * w @ (u.real**2 + u.imag**2) @ w
    return found


CASES = [
    case
    for case in itertools.product(
        APERTURES, PUPILS, ("m", "lambda*N"), (None, True, False), (0.4, 2.5), (False, True)
    )
    if not (
        case[1] in ("apodized", "ringed", "ringed zernike")
        and case[0] in ("vanes", "cat's eye", "ellipse", "mask")
        and case[4] == 0.4
    )
    if not (case[5] and case[2] == "lambda*N")
]


@pytest.mark.parametrize("aperture", APERTURES)
def test_an_option_means_the_same_for_every_pupil_and_in_every_unit(aperture):
    cases = [case for case in CASES if case[0] == aperture]
    assert len(cases) > 50
    check_each(check, cases)


def check(aperture, pupil, unit, integrate, pixel, spectrum):
    # Options that do not multiply the cost take turns.
    turn = CASES.index((aperture, pupil, unit, integrate, pixel, spectrum))
    center = [None, (1.3, -0.6), (9.0, 2.5)][turn % 3]
    normalize = ["strehl", "energy", "peak"][turn % 3 - 1]
    dtype = ["float32", "float64"][turn % 2]
    metric = {"wavelength": WAVELENGTH, "f_number": F_NUMBER} if unit == "m" else {}
    made = lm.Pupil(**PUPILS[pupil], **APERTURES[aperture], **metric)
    stacked = turn % 5 == 0
    if stacked:
        wavefront = lm.Wavefront([0.0, 0.3]) + PUPILS[pupil]["wavefront"] + lm.Wavefront([0.0, -0.3])
        made = lm.Pupil(
            wavefront, **{k: v for k, v in PUPILS[pupil].items() if k != "wavefront"}, **APERTURES[aperture], **metric
        )
    out = np.empty((2, *SHAPE) if stacked else SHAPE, dtype) if turn % 4 == 0 else None
    plan = lm.Plan(
        SHAPE,
        pixel * made.scale,
        integrate=integrate,
        center=center,
        normalize=normalize,
        dtype=dtype,
        method=SPECTRUM if spectrum else None,
    )
    answer = plan(made, out=out)
    averages = unit == "m" if integrate is None else integrate
    assert answer.sampling == ("pixel" if averages else "center")
    assert answer.values.dtype == dtype
    assert (answer.values is out) == (out is not None)
    axis = (SHAPE[0] // 2, SHAPE[1] // 2) if center is None else center
    exact = expected(aperture, pupil, math.pi * pixel, axis, averages, spectrum)
    values = answer.values[-1] if stacked else answer.values
    scale = float(np.ravel(answer.scale)[-1])
    found = np.array([values[place] for place in PLACES]) / scale
    bright = float(made.amplitude**2)
    # The lattice of the reference has steps at the rim.
    tolerance = 2e-6 if made.circular else 8e-3
    assert found == pytest.approx(exact, abs=tolerance * bright)
    factor = {
        "strehl": 1.0 / answer.method.unaberrated_peak(made),
        "energy": (math.pi * pixel) ** 2 / (4.0 * math.pi * made.transmission),
        "peak": 1.0 / (values.max() / scale),
    }[normalize]
    assert scale == pytest.approx(factor, rel=1e-5)
    if answer.error_bound is not None:
        assert answer.error_bound <= 1e-6 + 2.0**-24
