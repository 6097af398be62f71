"""Direct quadrature over an aperture, which shares nothing with the engines."""

from __future__ import annotations

import math

import numpy as np

import lommel as lm


def _points(pupil: lm.Pupil, rings: int, angles: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return x, y and the weighted amplitude at Gauss nodes in rho^2 and equal angles, not the engine's."""
    x, w = np.polynomial.legendre.leggauss(rings)
    inside = pupil.obscuration**2
    t = inside + (1.0 - inside) * 0.5 * (1.0 + x)
    theta = 2.0 * np.pi * (np.arange(angles) + 0.2) / angles
    rho = np.sqrt(t)[:, None]
    px, py = (rho * np.cos(theta)).ravel(), (rho * np.sin(theta)).ravel()
    phase = pupil.wavefront.phase(np.broadcast_to(rho, (rings, angles)).ravel(), np.tile(theta, rings))
    weights = np.repeat(0.5 * (1.0 - inside) * w, angles) / angles
    return px, py, weights * np.exp(-pupil.apodization * (px**2 + py**2) + 1j * phase)


def exact_field(pupil: lm.Pupil, vx: np.ndarray, vy: np.ndarray) -> np.ndarray:
    """Direct sum at some points, shape (points,), over as many rings and angles as the phase turns take."""
    farthest, degrees = float(np.hypot(vx, vy).max()), np.abs(pupil.wavefront.indices).max(axis=1, initial=0)
    turns = farthest + float(degrees @ np.abs(pupil.wavefront.edge).ravel())
    rings, angles = min(120, math.ceil(0.6 * turns) + 40), min(480, math.ceil(turns + 12.0 * math.cbrt(turns)) + 40)
    px, py, source = _points(pupil, rings, angles)
    return np.exp(-1j * (np.multiply.outer(vx, px) + np.multiply.outer(vy, py))) @ source


def exact_lattice(pupil: lm.Pupil, vx: np.ndarray, vy: np.ndarray, rings: int = 40, angles: int = 160) -> np.ndarray:
    """Direct sums at all pairs of coordinates, shape (vy, vx): a product of matrices."""
    px, py, source = _points(pupil, rings, angles)
    return (np.exp(-1j * np.multiply.outer(vy, py)) * source) @ np.exp(-1j * np.multiply.outer(px, vx))


def exact_intensity(pupil: lm.Pupil, answer: lm.PSF, rows: np.ndarray, columns: np.ndarray) -> np.ndarray:
    step = answer.grid.step(pupil)
    field = exact_field(pupil, step * (columns - answer.grid.center[1]), step * (rows - answer.grid.center[0]))
    return float(answer.scale) * np.abs(field) ** 2
