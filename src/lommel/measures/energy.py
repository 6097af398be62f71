"""How much of all light falls inside a window, a circle, a square, and about which point."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers
from lommel.measures.answer import Answer, checked
from lommel.methods.method import RadialMethod
from lommel.optics.base_pupil import BasePupil
from lommel.special.disk import disk_overlap
from lommel.special.legendre import gauss_panels


def encircled_energy(answer: Answer, radius: ArrayLike, *, about: str = "axis") -> Numbers:
    """Return the fraction of all light within `radius` of the axis or of the centroid.

    Parameters
    ----------
    answer : PSF
    radius : array_like
        Metres if the pupil has a wavelength, else units of lambda*N; >= 0.
    about : {"axis", "centroid"}, default "axis"
        The centroid is that of the values in the window; of a radial PSF it is the axis.

    Returns
    -------
    float or ndarray, shape ``pupil.shape + radius.shape``
        Where pupil and method are radial, by quadrature of the profile, to the tolerance of the method, whatever the
        pixels. Else the sum over pixels, each by the exact part of its area inside: as if its value held all over
        it, which errs by about the square of the pixel over the width of the image, and limited to the window.

    Raises
    ------
    TypeError, ValueError
        If a radius is no number, negative or not finite, or `about` is neither.
    """
    checked(answer)
    at = validation.real_array("radius", radius, least=0.0)
    center = _center(answer, about)
    if answer.radial_method is not None:
        return radial_energy(answer.radial_method, answer.pupil, at)
    grid = answer.grid
    high, wide = (0.5 * side for side in grid.pitch)
    share = energy_per_pixel(answer).reshape(-1, *grid.shape)
    inside = np.empty((len(share), at.size))
    for i, ((x, y), across, down) in enumerate(zip(center, *answer.positions(), strict=True)):
        columns, rows = across - x, down[:, None] - y
        for j, r in enumerate(at.ravel()):
            covered = disk_overlap(r, columns - wide, columns + wide, rows - high, rows + high) / (4.0 * high * wide)
            inside[i, j] = np.sum(covered * share[i])
    return numbers(inside, answer.pupil.shape + at.shape)


def ensquared_energy(answer: Answer, half_width: ArrayLike, *, about: str = "axis") -> Numbers:
    """Return the fraction of all light within a square of sides ``2 half_width`` along rows and columns.

    Parameters
    ----------
    answer : PSF
    half_width : array_like
        Half of the side, in metres if the pupil has a wavelength, else units of lambda*N; >= 0.
    about : {"axis", "centroid"}, default "axis"
        As of :func:`lommel.measures.energy.encircled_energy`, whose error it has.

    Returns
    -------
    float or ndarray, shape ``pupil.shape + half_width.shape``

    Raises
    ------
    TypeError, ValueError
        If a width is no number, negative or not finite, or `about` is neither.
    """
    checked(answer)
    at = validation.real_array("half_width", half_width, least=0.0)
    center = _center(answer, about)
    pupil = answer.pupil
    if answer.radial_method is not None:
        radial_method = answer.radial_method
        sides = [float(a) for a in _within_reach(pupil, "half_width", at, radial_method.stretch(pupil))]
        energies = [_rectangles(radial_method, pupil, [(4.0, a, a)]) for a in sides]
        exact = np.stack(energies, axis=-1) if sides else np.zeros((math.prod(pupil.shape), 0))
        return numbers(exact, pupil.shape + at.shape)
    grid = answer.grid
    share = energy_per_pixel(answer).reshape(-1, *grid.shape)

    def covered(places: Array, side: float) -> Array:
        low, high = places - 0.5 * side, places + 0.5 * side
        a = at.ravel()[:, None]
        return np.asarray(np.maximum(np.minimum(high, a) - np.maximum(low, -a), 0.0) / side)

    height, width = grid.pitch

    inside = [
        np.einsum("ky,yx,kx->k", covered(down - y, height), one, covered(across - x, width), optimize=True)
        for one, (x, y), across, down in zip(share, center, *answer.positions(), strict=True)
    ]
    return numbers(inside, pupil.shape + at.shape)


def window_centroid(answer: Answer) -> Array:
    """Return the centroid of the values in the window, (x, y) from the axis.

    :func:`lommel.centroid` is that of all light, from the wavefront; the two differ by what lies outside the window,
    which falls with its size only slowly, like the reciprocal.

    Parameters
    ----------
    answer : PSF

    Returns
    -------
    ndarray, shape ``pupil.shape + (2,)``
        Metres or units of lambda*N.

    Raises
    ------
    ValueError
        If no light falls into the window.
    """
    checked(answer)
    share = energy_per_pixel(answer)
    total = share.sum(axis=(-2, -1))
    if not np.all(total > 0):
        raise ValueError("the centroid of no light is unknown: none falls into the window")
    x, y = (share.sum(axis=-2) * answer.grid.x).sum(axis=-1), (share.sum(axis=-1) * answer.grid.y).sum(axis=-1)
    return np.stack([x / total, y / total], axis=-1)


def _center(answer: Answer, about: str) -> Array:
    """Return the points (x, y) that `about` names, shape (n, 2)."""
    validation.choice("about", about, ("axis", "centroid"))
    if about == "axis" or answer.radial_method is not None:
        return np.zeros((math.prod(answer.pupil.shape), 2))
    return window_centroid(answer).reshape(-1, 2)


def require_radial(method: RadialMethod, pupil: BasePupil) -> None:
    """Raise ValueError if a pupil is not radially symmetric, or not supported."""
    method.require(pupil)
    if not pupil.radial:
        raise ValueError("pupil must be radially symmetric, got one with terms that depend on the direction")


def radial_energy(method: RadialMethod, pupil: BasePupil, radius: ArrayLike) -> Numbers:
    """Return the fraction of all light within `radius`, ``int_0^v I v dv / (2 (1 - eps^2))``, by quadrature.

    Parameters
    ----------
    method : RadialMethod
    pupil : Pupil
        A radial one.
    radius : array_like
        Metres if the pupil has a wavelength, else units of lambda*N; >= 0.

    Returns
    -------
    float or ndarray, shape ``pupil.shape + radius.shape``
        To the tolerance of the method.

    Raises
    ------
    TypeError, ValueError
        If the method is not radial or does not support the pupil, or a radius is negative or not finite.
    """
    validation.instance("method", method, RadialMethod)
    at = validation.real_array("radius", radius, least=0.0)
    method.require(pupil)
    if at.size == 0:
        return np.zeros(pupil.shape + at.shape)
    stretch = method.stretch(pupil)
    edges, where = np.unique(_within_reach(pupil, "radius", at, stretch), return_inverse=True)
    nodes, weights, counts = [np.zeros(1)], [np.zeros(1)], []
    for low, high in zip(np.append(0.0, edges), edges, strict=False):
        # I v is of exponential type 2 `stretch`, so half a node a unit of that, and some, is spectral accuracy.
        x, w = gauss_panels(math.ceil(0.6 * stretch * (high - low)) + 24, low, high)
        nodes.append(x)
        weights.append(w * x)
        counts.append(x.size)
    intensity = method.profile(pupil, np.concatenate(nodes)).values
    light = np.cumsum(intensity * np.concatenate(weights), axis=1)
    return numbers(light[:, np.cumsum(counts)[where]] / (2.0 * pupil.transmission), pupil.shape + at.shape)


def _within_reach(pupil: BasePupil, name: str, at: Array, stretch: float) -> Array:
    """Return `at` in v, flat, if that is no farther from the axis than there is light worth computing."""
    far = float(at.max(initial=0.0))
    validation.reach(f"{name}={far:g}", stretch * (math.pi / pupil.scale * far), pupil.scale / stretch, pupil.unit)
    return pupil.v(at).ravel()


def window_energy(answer: Answer) -> Numbers:
    """Return the fraction of all light inside the window, to the edges of its outer pixels.

    Parameters
    ----------
    answer : PSF

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
    """
    checked(answer)
    if answer.radial_method is None:
        return numbers(energy_per_pixel(answer).sum(axis=(-2, -1)), answer.pupil.shape)
    pupil, grid = answer.pupil, answer.grid
    if grid.stack:
        return numbers([window_energy(answer[index]) for index in np.ndindex(pupil.shape)], pupil.shape)
    step = math.pi / pupil.scale
    high, wide = (0.5 * side for side in grid.pitch)
    # Inclusion and exclusion of rectangles with one corner on the axis.
    corners = [
        (float(np.sign(a) * np.sign(b)), abs(a) * step, abs(b) * step)
        for a in (grid.x[-1] + wide, wide - grid.x[0])
        for b in (grid.y[-1] + high, high - grid.y[0])
    ]
    return numbers(_rectangles(answer.radial_method, pupil, corners), pupil.shape)


def _rectangles(method: RadialMethod, pupil: BasePupil, rectangles: list[tuple[float, float, float]]) -> Array:
    """Return the light in rectangles from the axis to (a, b) in v, each (weight, a, b), shape (n,)."""
    nodes, weights = [np.zeros(1)], [np.zeros(1)]
    for factor, a, b in rectangles:
        if a > 1e-150 and b > 1e-150:  # whose inverses are numbers
            v, w = _quadrant_rule(a, b, method.stretch(pupil))
            nodes.append(v)
            weights.append(factor * w)
    v, w = np.concatenate(nodes), np.concatenate(weights)
    order = np.argsort(v)
    intensity = method.profile(pupil, v[order]).values
    return np.asarray(intensity @ w[order] / (4.0 * math.pi * pupil.transmission))


def _quadrant_rule(a: float, b: float, stretch: float) -> tuple[Array, Array]:
    """Return nodes v and weights that integrate a radial function over the rectangle [0, a] x [0, b].

    The function is of exponential type ``2 stretch``.
    """
    near, far = min(a, b), max(a, b)
    pieces = [(0.0, near), (near, far), (far, math.hypot(a, b))]
    nodes, weights = [], []
    for low, high in pieces:
        # v = low + (high - low) s^2 smooths the square root with which the arcs begin to leave the rectangle.
        s, w = gauss_panels(math.ceil(1.2 * stretch * (high - low)) + 24)
        v = low + (high - low) * s * s
        arc = np.arcsin(np.minimum(1.0, b / v)) - np.arccos(np.minimum(1.0, a / v))
        nodes.append(v)
        weights.append(2.0 * (high - low) * s * w * v * np.maximum(arc, 0.0))
    return np.concatenate(nodes), np.concatenate(weights)


def energy_per_pixel(answer: Answer) -> Array:
    """Return the values as fractions of all light per pixel, whatever their normalisation."""
    factor = answer.grid.cell(answer.pupil) / (4.0 * math.pi * answer.pupil.transmission)
    return np.asarray(answer.values * (factor / answer.scale)[..., None, None], dtype=np.float64)
