"""Stars through the atmosphere, beside one FFT: every image new to the rules that are kept between calls."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from scipy.special import j0

import lommel as lm
from benchmarks.baselines import fft
from benchmarks.report import Table
from benchmarks.settings import Settings
from benchmarks.timing import Contender, race
from lommel.base.arrays import Array
from lommel.blur.blurs import KOLMOGOROV

_STARS = {50.0: (8.0, 600e-9, 0.0), 12.0: (2.4, 700e-9, 0.33)}
"""Diameter (metres), wavelength and obscuration for each D / r0."""


def seeing(settings: Settings) -> Table:
    """Each beside the FFT, with its true error and bound."""
    table = Table(
        "seeing",
        "Seeing",
        "33² samples of 0.1 arcsec, one thread, each image with another r0. Beside one FFT of 1024² complex128, "
        "though that does none of this. True errors: over the largest value, against quadrature of OTF times blur.",
        {"what": "text", "FFT alone over it": "spread", "true error": "error", "bound": "error"},
    )
    other = fft()
    for ratio, (diameter, wavelength, eps) in _STARS.items():
        for tol in (1e-4, 1e-6, 1e-9):
            name = f"D / r0 = {ratio:g}, tol {tol:g}"
            settings.tick(name)
            pixel, pupil = 0.1 * math.pi / 648000.0 / (wavelength / diameter), lm.Pupil(obscuration=eps)
            one = _star(name, pupil, pixel, tol, ratio)
            result = race([one, other], settings.rounds, budget=2.0)
            answer = one.call(ratio)
            radius = np.hypot(answer.grid.x, answer.grid.y[:, None])
            exact = _exact(radius, pupil, ratio)
            off = float(np.abs(answer.values - exact).max() / exact.max())
            table.add(name, result.ratio(other.name, one.name), off, float(answer.error_bound))
    return table


def _star(name: str, pupil: lm.Pupil, pixel: float, tol: float, ratio: float) -> Contender:
    def call(ratio: float) -> Any:
        air = lm.Seeing(1.0 / ratio)
        return lm.psf(pupil, 33, pixel, blur=air, tol=tol, threads=1, dtype=np.float64, normalize="strehl")

    def fresh(count: int) -> list[float]:
        return (ratio * (1.0 + 1e-4 * np.arange(count))).tolist()

    return Contender(name, call, f"psf(..., blur=Seeing(), tol={tol:g})", fresh, lambda answer: answer.values)


def _exact(radius: Array, pupil: lm.Pupil, ratio: float) -> Array:
    """Return the long exposure over the unaberrated peak at radii in lambda*N, with 600 nodes."""
    x, weight = np.polynomial.legendre.leggauss(600)
    end = math.cbrt(min(4.0 / ratio, 0.5 * (1.0 - pupil.obscuration)))
    u = 0.5 * end * (x + 1.0)
    f, weight = u**3, 0.5 * end * weight * 3.0 * u**5
    weight = weight * np.real(lm.otf(pupil, f, tol=1e-13)) * np.exp(-KOLMOGOROV * (ratio * f) ** (5.0 / 3.0))
    places, where = np.unique(radius, return_inverse=True)
    found = 8.0 * j0(2.0 * math.pi * np.multiply.outer(places, f)) @ weight
    return np.asarray(found[where.reshape(radius.shape)] * pupil.transmission / pupil.amplitude**2)
