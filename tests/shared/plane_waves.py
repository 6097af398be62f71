"""The light of a microscope as a plain sum of plane waves, s and p, over both dimensions of the pupil."""

from __future__ import annotations

import math

import numpy as np

import lommel as lm
from lommel.optics.layers.emitter import Absorbed
from objectives import phase, transmission

PIXEL = 6.5e-6
_TOGETHER = 512  # points at once, for the memory that they take
_LAST: dict[tuple[bytes, ...], np.ndarray] = {}


def nodes(objective: lm.Objective, rings: int) -> tuple[np.ndarray, np.ndarray]:
    """Radii in the pupil and their weights, by angles in the sample, imaginary ones beyond the critical angle."""
    x, w = np.polynomial.legendre.leggauss(rings)
    x, w = 0.5 * (1.0 + x), 0.5 * w
    end = objective.NA / objective.sample
    alpha = math.asin(min(1.0, end))
    rho, weight = np.sin(alpha * x) / end, alpha * w * np.cos(alpha * x) * np.sin(alpha * x) / end**2
    if end <= 1.0:
        return rho, weight
    beta = math.acosh(end)
    above = np.cosh(beta * x) / end, beta * w * np.cosh(beta * x) * np.sinh(beta * x) / end**2
    return np.append(rho, above[0]), np.append(weight, above[1])


def intensity(
    objective: lm.Objective, pupil: object, x: np.ndarray, y: np.ndarray, rings: int = 150, angles: int = 300
) -> np.ndarray:
    """Return the intensity on the camera, or of a beam in the sample, at points in metres of the camera.

    Shape (planes, points), not divided by what is collected.
    """
    if x.size > _TOGETHER:
        parts = [slice(start, start + _TOGETHER) for start in range(0, x.size, _TOGETHER)]
        return np.concatenate([intensity(objective, pupil, x[k], y[k], rings, angles) for k in parts], axis=1)
    rho, weight = nodes(objective, rings)
    theta = 2.0 * np.pi * (np.arange(angles) + 0.3) / angles
    wave = pupil.wavelength
    t_s, t_p = transmission(objective, rho, wave)
    sine = objective.NA * rho / objective.sample
    cosine = np.sqrt(1.0 - sine**2 + 0j)
    inside = np.sqrt(1.0 - (objective.NA * rho / objective.immersion) ** 2)
    around, cos, sin = np.ones((rho.size, 1)), np.cos(theta), np.sin(theta)
    p_pupil = np.stack(np.broadcast_arrays(around * cos, around * sin, 0.0 * around))
    s_wave = np.stack(np.broadcast_arrays(-around * sin, around * cos, 0.0 * around))
    p_wave = np.stack(np.broadcast_arrays(cosine[:, None] * cos, cosine[:, None] * sin, sine[:, None]))
    kx, ky = (2.0 * np.pi / wave * objective.NA * rho[:, None] * part for part in (cos, sin))
    kernel = _waves(x / objective.magnification, y / objective.magnification, kx, ky)
    amplitude = 2.0 * weight[:, None] * inside[:, None] ** -0.5 / angles

    def seen(field: np.ndarray) -> np.ndarray:
        return np.tensordot(kernel, amplitude * plane * field, axes=([1, 2], [0, 1]))

    def transmitted(along_p: np.ndarray, along_s: np.ndarray, p: np.ndarray, s: np.ndarray) -> list[np.ndarray]:
        return [seen(t_p[:, None] * along_p * p[c] + t_s[:, None] * along_s * s[c]) for c in range(3)]

    found = []
    for k in np.ndindex(pupil.shape):
        psi = phase(objective, rho, depth=float(pupil.depth[k]), focus=float(pupil.focus[k]), wavelength=wave)
        plane = np.exp(1j * psi)[:, None] * around
        if pupil.aberrations is not None:
            measured = pupil.aberrations[k] if pupil.aberrations.shape else pupil.aberrations
            plane = plane * np.exp(1j * measured.phase(rho[:, None], theta))
        found.append(
            sum(np.abs(part) ** 2 for part in _fields(pupil.emitter, p_pupil, s_wave, p_wave, transmitted, seen))
        )
    return np.array(found)


def _waves(x, y, kx, ky):
    """Return plane waves at points, those of the last call where they are the same."""
    asked = tuple(part.tobytes() for part in (x, y, kx, ky))
    if asked not in _LAST:
        _LAST.clear()
        _LAST[asked] = np.exp(-1j * (np.multiply.outer(x, kx) + np.multiply.outer(y, ky)))
    return _LAST[asked]


def _fields(emitter, p_pupil, s_wave, p_wave, transmitted, seen):
    if isinstance(emitter, lm.Scalar):
        return [seen(np.ones(p_wave.shape[1:]))]
    if isinstance(emitter, lm.Beam):
        if isinstance(emitter, Absorbed):
            beam = _fields(lm.Beam(emitter.polarization), p_pupil, s_wave, p_wave, transmitted, seen)
            return [math.sqrt(2.0) * np.tensordot(p, beam, 1) for p in moments(emitter.dipole)]
        if emitter.polarization in ("radial", "azimuthal"):
            share = float(emitter.polarization == "radial")
            return transmitted(share, 1.0 - share, p_wave, s_wave)
        names = {"x": (1, 0), "y": (0, 1), "circular": (1, 1j), "vortex": (1, 1j)}
        jones = names[emitter.polarization] if isinstance(emitter.polarization, str) else emitter.polarization
        a, b = np.array(jones) / np.linalg.norm(jones)
        turned = p_pupil[0] + 1j * p_pupil[1] if emitter.polarization == "vortex" else 1.0
        entering = [turned * (a * part[0] + b * part[1]) for part in (p_pupil, s_wave)]
        return transmitted(*entering, p_wave, s_wave)
    fields = []
    for p in moments(emitter):
        sent = [np.tensordot(p, part, 1) for part in (p_wave, s_wave)]
        fields += transmitted(*sent, p_pupil, s_wave)
    return fields


def moments(emitter):
    """Return dipoles whose light adds up to that of one that may wobble."""
    flat = math.sin(emitter.polar)
    moment = np.array([flat * math.cos(emitter.azimuth), flat * math.sin(emitter.azimuth), math.cos(emitter.polar)])
    dipoles = [math.sqrt(1.5 * (1.0 - emitter.wobble)) * moment]
    return dipoles + [math.sqrt(0.5 * emitter.wobble) * axis for axis in np.eye(3)]


def worst(objective, pupil, made, size, center=(None, None)):
    """Return the largest error of a PSF over the peak of each plane, from direct sums at its pixels."""
    y, x = (np.arange(size) - (size // 2 if c is None else c) for c in center)
    y, x = np.meshgrid(y * PIXEL, x * PIXEL, indexing="ij")
    exact = intensity(objective, pupil, x.ravel(), y.ravel(), 70, 128) / pupil.power[:, None]
    found = made.values.reshape(exact.shape) / np.asarray(made.scale).reshape(-1, 1)
    return (np.abs(found - exact).max(axis=1) / exact.max(axis=1)).max()
