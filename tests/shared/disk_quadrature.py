"""Direct quadrature over an aperture, which shares nothing with the engines."""

from __future__ import annotations

import numpy as np

import lommel as lm


def exact_field(pupil: lm.Pupil, vx: np.ndarray, vy: np.ndarray, rings: int = 120, angles: int = 480) -> np.ndarray:
    """Direct sum over a polar rule, shape (points,): Gauss nodes in rho^2 and equal angles, not the engine's."""
    x, w = np.polynomial.legendre.leggauss(rings)
    inside = pupil.obscuration**2
    t = inside + (1.0 - inside) * 0.5 * (1.0 + x)
    theta = 2.0 * np.pi * (np.arange(angles) + 0.2) / angles
    rho = np.sqrt(t)[:, None]
    px, py = (rho * np.cos(theta)).ravel(), (rho * np.sin(theta)).ravel()
    phase = pupil.wavefront.phase(np.broadcast_to(rho, (rings, angles)).ravel(), np.tile(theta, rings))
    weights = np.repeat(0.5 * (1.0 - inside) * w, angles) / angles
    source = weights * np.exp(-pupil.apodization * (px**2 + py**2) + 1j * phase)
    return np.exp(-1j * (np.multiply.outer(vx, px) + np.multiply.outer(vy, py))) @ source


def exact_intensity(pupil: lm.Pupil, answer: lm.PSF, rows: np.ndarray, columns: np.ndarray) -> np.ndarray:
    step = answer.grid.step(pupil)
    field = exact_field(pupil, step * (columns - answer.grid.center[1]), step * (rows - answer.grid.center[0]))
    return float(answer.scale) * np.abs(field) ** 2
