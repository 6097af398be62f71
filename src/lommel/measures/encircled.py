r"""Encircled energy about the axis for any pupil, exact whatever its symmetry.

An intensity is band-limited: its transform ends at the cutoff, one cycle per lambda*N. So its integral over a circle
does not change where the circle is replaced by any function with the same transform below the cutoff, and a sum over
pixels of the pitch h replaces the integral where the transform of that function ends at 1/h - 1. Between the two
limits it may fall as smoothly as one likes, here by an error function. The weights of the pixels are then 1 inside of
the circle and 0 outside, but for a seam a few lambda*N wide.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.core.answers import Images
from lommel.measures.answer import Answer
from lommel.measures.energy import energy_per_pixel, radial_energy
from lommel.methods.choice import candidates, first_proven, of_profiles
from lommel.methods.method import Method, widened
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil, checked
from lommel.special.legendre import gauss_legendre

_PITCH = 0.25
"""Of the pixels, in lambda*N; twice as fine as the cutoff asks for."""
_MIDDLE, _WIDTH = 2.0, 0.25
"""Where the weights fall in frequency: erfc(4) / 2 = 8e-9 is what they miss of 1 and of 0 at the limits 1 and 3."""
_SEAM = 6.0
"""Half the width of the seam in lambda*N: beyond, weights are below 1e-9."""
_OWN_ERROR = 3e-8
MAX_RADIUS = 250.0
"""Of circles about the image of a pupil that is not radial, in lambda*N."""


class Encircled(NamedTuple):
    """Fractions of all light within circles about the axis.

    Attributes
    ----------
    fraction : ndarray
        One for each radius.
    error : float or None
        Bound on their error; None where the method of the image has none.
    image : Answer or None
        What they were drawn from, pixels of a quarter of lambda*N; None where the profile tells.
    """

    fraction: NDArray[np.float64]
    error: float | None
    image: Answer | None


def encircled(pupil: Pupil, radius: ArrayLike, *, method: Method | None = None) -> Encircled:
    """Return the fraction of all light within circles about the axis, for any single pupil.

    Parameters
    ----------
    pupil : Pupil
        A single one.
    radius : array_like, shape (n,)
        Metres if the pupil has a wavelength, else units of lambda*N; 0 to 250 lambda*N unless the pupil is radial.
    method : Method, optional
        Of the image; by default that of :func:`lommel.psf`. Ignored where the pupil is radial.

    Returns
    -------
    Encircled
        The error bound is that of the image at every pixel of the circle, all of one sign, and 3e-8 for the weights:
        a few times 1e-4 at worst for 10 lambda*N and a tolerance of 1e-6, and mostly far from reached.

    Raises
    ------
    TypeError, ValueError
        If a radius is not finite or out of range, or the pupil is a stack.
    """
    at = np.atleast_1d(validation.real_array("radius", radius, least=0.0))
    if method is not None:
        validation.instance("method", method, Method)
    if checked(pupil).shape != ():
        raise ValueError(f"pupil must be a single one, got a stack of shape {pupil.shape}")
    if pupil.radial:
        # The profile is within the tolerance of the peak, which is at most the transmission.
        return Encircled(np.atleast_1d(radial_energy(of_profiles(), pupil, at)), None, None)
    reach = at / pupil.scale
    if reach.size and reach.max() > MAX_RADIUS:
        raise ValueError(
            f"radius must be at most {MAX_RADIUS:g} lambda*N for a pupil that is not radially symmetric, "
            f"got {reach.max():.6g} lambda*N"
        )
    side = 2 * math.ceil((float(reach.max(initial=0.0)) + _SEAM) / _PITCH) + 1
    image = _image(pupil, Grid(side, _PITCH * pupil.scale), method)
    share = energy_per_pixel(image)
    places = _PITCH * (np.arange(side) - side // 2)
    squares, where = np.unique(np.add.outer(places**2, places**2).ravel(), return_inverse=True)
    radial = np.bincount(where.ravel(), weights=share.ravel())
    count = np.bincount(where.ravel())
    distance = np.sqrt(squares)
    fraction, error = np.empty(reach.size), 0.0
    for i, r in enumerate(reach):
        weight = _weights(float(r), distance)
        fraction[i] = weight @ radial
        error = max(error, float(np.abs(weight) @ count))
    if image.error_bound is None:
        return Encircled(fraction, None, image)
    return Encircled(fraction, _OWN_ERROR + error * image.error_bound * float(share.max()), image)


def _image(pupil: Pupil, grid: Grid, method: Method | None) -> Answer:
    if method is not None:
        method.require(pupil)
    ways = candidates(pupil, grid) if method is None else (method,)

    def ask(way: Method) -> Images:
        return widened(way.images(pupil, grid, 1.0, np.float64), pupil, way, normalized=False)

    way, (values, scale, error, *_) = first_proven(ways, ask)
    bound = None if error is None else float(error.max())
    return Answer(values[0], grid, pupil, way, "strehl", bound, scale.reshape(()))


def _weights(radius: float, distance: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the weights of pixels at rising distances: the circle less its frequencies beyond the cutoff."""
    from scipy.interpolate import make_interp_spline
    from scipy.special import erfc, j0, j1

    weight = (distance < radius).astype(np.float64)
    if radius == 0.0:
        return np.zeros(distance.shape)
    low, high = max(0.0, radius - _SEAM), radius + _SEAM
    # Spline of degree 7 through 50 points per lambda*N of what has three cycles in one: better than 1e-9.
    at = np.linspace(low, high, math.ceil(50.0 * (high - low)) + 8)
    end = _MIDDLE + 4.5 * _WIDTH
    f, w = gauss_legendre(math.ceil(math.pi * end * (radius + high)) + 48, 0.0, end)
    taper = 0.5 * erfc((f - _MIDDLE) / _WIDTH)
    kernel = 2.0 * math.pi * radius * w * taper * j1(2.0 * math.pi * radius * f)
    table = np.array([kernel @ j0(2.0 * math.pi * f * r) for r in at])
    seam = (distance >= low) & (distance <= high)
    weight[seam] = make_interp_spline(at, table, k=7)(distance[seam])
    return weight


__all__ = ["MAX_RADIUS", "Encircled", "encircled"]
