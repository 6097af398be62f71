"""Displacement of light by the tilts of a field map, and its inverse."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.pupil import Pupil

Spectrum = float | Sequence[tuple[float, float]]

_STEPS = 50
_OFF = 1e-10  # of the size of the field: accuracy of the inverse


def spectrum_of(wavelength: Spectrum | None) -> tuple[tuple[float | None, float], ...]:
    """Return pairs of wavelength, None for that of the map, and weight, which sum to 1."""
    if wavelength is None:
        return ((None, 1.0),)
    if not isinstance(wavelength, Sequence | np.ndarray):
        return ((validation.wavelength(wavelength), 1.0),)
    values = validation.real_array("wavelength", wavelength, least=0.0)
    if values.ndim != 2 or values.shape[1] != 2 or not values[:, 1].sum() > 0.0:
        raise ValueError(
            f"wavelength must be a number, or pairs of wavelength and weight, got {validation.shown(wavelength)}"
        )
    total = values[:, 1].sum()
    return tuple((validation.wavelength(float(w)), float(share / total)) for w, share in values)


def shift_of(pupil: Pupil, spectrum: Sequence[tuple[float | None, float]]) -> tuple[Array, Array]:
    """Return the shift of the image by the tilt of a pupil along x and y, the mean over a spectrum.

    A phase of c rad at the edge, c rho cos(theta), moves the image by c lambda N / pi: the same at all wavelengths
    where path differences are.
    """
    found = np.zeros((2, *pupil.shape))
    for wavelength, weight in spectrum:
        seen = pupil if wavelength is None else pupil.in_light(wavelength)
        terms = seen.wavefront.edge_terms()
        for k, m in enumerate((1, -1)):
            found[k] += weight * seen.scale / math.pi * terms.get((1, m), np.zeros(()))
    return found[0], found[1]


def tilt_by(pupil: Pupil, dx: Array, dy: Array) -> dict[tuple[int, int], Array]:
    """Return the terms (radians at the edge) that move the image of a pupil by `dx` and `dy`."""
    return {(1, 1): math.pi / pupil.scale * dx, (1, -1): math.pi / pupil.scale * dy}


def inverse(
    x: Array,
    y: Array,
    displacement: Callable[[Array, Array], tuple[Array, Array]],
    contains: Callable[[Array, Array], NDArray[np.bool_]],
    middle: tuple[float, float],
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Return the positions that a displacement moves to (x, y), and which were found, by Broyden's method.

    The displacement is known on a convex set with `middle` in it: positions beyond are drawn back towards this.
    """
    size = max(float(np.hypot(x - middle[0], y - middle[1]).max(initial=0.0)), np.finfo(float).tiny)
    at = np.stack(_drawn_back(x, y, contains, middle), axis=-1)
    goal = np.stack([x, y], axis=-1)
    slope = np.broadcast_to(np.eye(2), (*x.shape, 2, 2)).copy()  # of positions by their images
    off = at + np.stack(displacement(at[..., 0], at[..., 1]), axis=-1) - goal
    for _ in range(_STEPS):
        if np.abs(off).max(initial=0.0) <= _OFF * size:
            break
        to = at - np.einsum("...ij,...j", slope, off)
        to = np.stack(_drawn_back(to[..., 0], to[..., 1], contains, middle), axis=-1)
        step, before = to - at, off
        at = to
        off = at + np.stack(displacement(at[..., 0], at[..., 1]), axis=-1) - goal
        along = np.einsum("...j,...ji", step, slope)
        moved = np.einsum("...ij,...j", slope, off - before)
        length = (step * moved).sum(axis=-1)
        known = np.abs(length) > 0.1 * (step * step).sum(axis=-1)  # else the update would be of rounding errors
        gain = np.divide(1.0, length, out=np.zeros(length.shape), where=known & (length != 0.0))
        slope += gain[..., None, None] * (step - moved)[..., :, None] * along[..., None, :]
    return at[..., 0], at[..., 1], np.asarray(np.abs(off).max(axis=-1) <= 10.0 * _OFF * size)


def _drawn_back(
    x: Array, y: Array, contains: Callable[[Array, Array], NDArray[np.bool_]], middle: tuple[float, float]
) -> tuple[Array, Array]:
    """Return positions, those outside moved to the edge on the line to `middle`."""
    outside = ~contains(x, y)
    if not outside.any():
        return x, y
    dx, dy = x[outside] - middle[0], y[outside] - middle[1]
    low, high = np.zeros(dx.shape), np.ones(dx.shape)
    for _ in range(50):
        share = 0.5 * (low + high)
        inside = contains(middle[0] + share * dx, middle[1] + share * dy)
        low, high = np.where(inside, share, low), np.where(inside, high, share)
    across, down = x.copy(), y.copy()
    across[outside], down[outside] = middle[0] + low * dx, middle[1] + low * dy
    return across, down
