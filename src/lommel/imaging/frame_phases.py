"""Shift, magnification and rotation of frames of different focus, from the phases of their cross-spectrum.

Symmetric blurs leave the phases 0 or pi; a shift makes them proportional to the frequency. The windows move a single
blurred edge by (their slope) * (difference of the variances of blur).
"""

from __future__ import annotations

import math

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values

_LEAST = 0.5  # pixels, rms over the frame: least displacement that is told
_CERTAIN = 7.0  # standard errors of a displacement that is told, as of independent frequencies, which windows mix
_COHERENT = 4.0  # standard deviations of the mean cosine of phases of noise, above which phases are of a displacement
_FREQUENCY, _SIDE = 0.12, 1024  # cycles per pixel, up to which phases are used, and side of the square for shifts
_LOWEST, _FIRST = 2.5, 8.0  # periods in a window: least, and most in the first step
_STEPS, _LEAST_SHARE = 4, 0.05
_UNKNOWN = 1e3  # pixels: standard error of displacements of noise
_MIN_WINDOW = 96  # pixels: least side of the four windows of a frame, from which its magnification follows


def frame_shift(frames: Values, valid: NDArray[np.bool_], blur: float) -> tuple[float, ...]:
    """Return the shift of a frame relative to frame 0, pixels; empty if none is certain and over half a pixel.

    `blur` is the largest blur radius, pixels.
    """
    middle = tuple(slice(max(0, side - _SIDE) // 2, (side + _SIDE) // 2) for side in valid.shape)
    for other in frames[1:]:
        shift, covariance = _displacement(frames[0][middle], other[middle], valid[middle], (_FREQUENCY,))
        size = float(np.hypot(*shift))
        error = math.sqrt(shift @ covariance @ shift) / max(size, 1e-12)
        if size > max(_LEAST + _edge_shift(valid[middle].shape, blur), _CERTAIN * error):
            return tuple(shift.tolist())
    return ()


def frame_scales(frames: Values, valid: NDArray[np.bool_], blur: float) -> tuple[float, ...]:
    """Return magnifications of frames relative to frame 0; empty if none is certain and moves half a pixel (rms)."""
    return tuple(scale for scale, _ in frame_magnifications(frames, valid, blur))


def frame_magnifications(frames: Values, valid: NDArray[np.bool_], blur: float) -> tuple[tuple[float, float], ...]:
    """Return the magnifications of `frame_scales`, each with its standard error."""
    if min(valid.shape) // 2 < _MIN_WINDOW:
        return ()
    scales = [(1.0, 0.0)]
    for other in frames[1:]:
        fit, covariance, _ = motion(frames[0], other, valid, blur, 2, turns=False)
        error = math.sqrt(covariance[2, 2])
        told = abs(fit[2]) > max(_CERTAIN * error, _LEAST * math.sqrt(12.0) / math.hypot(*valid.shape))
        scales.append((1.0 + float(fit[2]), error) if told else (1.0, 0.0))
    return tuple(scales) if set(scales) != {(1.0, 0.0)} else ()


def motion(
    first: Values, other: Values, valid: NDArray[np.bool_], blur: float, parts: int, *, turns: bool = True
) -> tuple[Array, Array, float]:
    """Return (1) shift and relative scale of a frame, and angle if it `turns`, (2) their covariance, (3) a misfit.

    They are fitted to displacements of `parts` x `parts` windows about the middle of the frame; of one window only
    the shift follows. An angle is positive from x to y. The misfit is the rms difference of displacements of windows
    from the fit, pixels.
    """
    shape = np.array(valid.shape)
    size = np.minimum(shape // parts, _SIDE)
    tops = [_FREQUENCY]
    while 0.5 * tops[0] * min(size) > (0.5 * _FIRST if parts == 1 else _FIRST):  # to find large shifts
        tops.insert(0, 0.5 * tops[0])
    steps = [0.5] if parts == 1 else np.linspace(0.0, 1.0, parts)
    firsts = [[round(step * (shape[k] - size[k])) for step in steps] for k in (0, 1)]
    corners = [(top, left) for top in firsts[0] for left in firsts[1]]
    windows = [
        tuple(slice(start, start + side) for start, side in zip(corner, size, strict=True)) for corner in corners
    ]
    moved = [_displacement(first[window], other[window], valid[window], tops) for window in windows]
    # Places of the windows' centres relative to the middle, and weighted least squares.
    places = np.array(corners) + 0.5 * (size - shape)
    columns = [[*np.eye(2), place, (place[1], -place[0])][: 2 if parts == 1 else 3 + turns] for place in places]
    terms = np.concatenate([np.column_stack(column) for column in columns])
    edges = _edge_shift(tuple(size), blur) ** 2 * np.eye(2)
    weight = np.linalg.inv(scipy.linalg.block_diag(*(covariance + edges for _, covariance in moved)))
    shifts, covariance = np.concatenate([shift for shift, _ in moved]), np.linalg.inv(terms.T @ weight @ terms)
    fit = covariance @ terms.T @ weight @ shifts
    left = shifts - terms @ fit
    covariance *= max(1.0, left @ weight @ left / max(1, len(left) - len(fit)))
    return fit, covariance, math.sqrt(np.average(left**2, weights=np.diag(weight)))


def _edge_shift(size: tuple[int, ...] | Array, blur: float) -> float:
    """Return the displacement of a blurred edge by a window, pixels."""
    return float(2.0 * math.pi / min(size) * (0.25 * blur) ** 2)


def _spectrum(values: Values, inside: NDArray[np.bool_]) -> NDArray[np.complex128]:
    """Return the spectrum of values less their mean, 0 where they are not `inside`, in a window."""
    window = np.outer(*(np.hanning(side) for side in inside.shape)) * inside
    known = np.where(inside, values, 0.0)
    return np.asarray(scipy.fft.rfft2((known - np.average(known, weights=inside)) * window))


def _frequencies(shape: tuple[int, ...]) -> Array:
    """Return the frequencies of `_spectrum` along rows and columns, cycles per pixel, (2, height, width)."""
    return np.array(np.broadcast_arrays(scipy.fft.fftfreq(shape[0])[:, None], scipy.fft.rfftfreq(shape[1])))


def _displacement(
    first: Values, other: Values, inside: NDArray[np.bool_], tops: list[float] | tuple[float, ...]
) -> tuple[Array, Array]:
    """Return the displacement of a frame in a window, pixels, and its covariance.

    Phases of frequencies up to `tops` are used, one after the other, each less those of the displacement before.
    Phases of noise ask for none: a step is divided by the share of the others, and `_STEPS` more follow by the last.
    """
    spectra, f = [_spectrum(one, inside) for one in (first, other)], _frequencies(inside.shape)
    radii, shift, covariance = np.hypot(*f), np.zeros(2), np.zeros((2, 2))
    for top in [*tops, *tops[-1:] * _STEPS]:
        used = (radii < top) & (radii * min(inside.shape) > _LOWEST)
        slopes = -2.0 * math.pi * f[:, used]
        cross = (spectra[1] * spectra[0].conj())[used]
        weighted = slopes * np.abs(cross)
        phases = 0.5 * np.angle((cross * np.exp(-1j * (shift @ slopes))) ** 2)
        inverse = np.linalg.pinv(weighted @ slopes.T)
        step = inverse @ weighted @ phases
        gradients = inverse @ (weighted * (phases - step @ slopes))
        weights, left = np.abs(cross), np.cos(2.0 * (phases - step @ slopes))
        share = max(_LEAST_SHARE, float(weights @ left) / max(float(weights.sum()), 1e-300))
        shift, covariance = shift + step / share, gradients @ gradients.T / share**2
    # Phases of noise alone are about as likely at all displacements; even frames have none.
    if weights @ left <= _COHERENT * math.sqrt(0.5 * float(weights @ weights)):
        covariance = covariance + _UNKNOWN**2 * np.eye(2)
    return shift, covariance
