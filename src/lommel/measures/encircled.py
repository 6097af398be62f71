"""Encircled energy about the axis for any pupil, with a bound on its error."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.measures.continuous_image import OWN_ERROR, SEAM_NORM, ImageModel, cartesian_images
from lommel.measures.energy import radial_energy
from lommel.methods.choice import candidates, of_profiles
from lommel.methods.method import Method
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil, checked

MAX_RADIUS = 250.0
"""Of circles about the image of a pupil that is not radial, in lambda*N."""


class Encircled(NamedTuple):
    """Fractions of all light within circles about the axis.

    Attributes
    ----------
    fraction : ndarray
        One for each radius.
    error : float or None
        Bound on their error; None where the method of the image has none, or the pupil is radially symmetric.
    """

    fraction: NDArray[np.float64]
    error: float | None


def encircled(pupil: Pupil, radius: ArrayLike, *, method: Method | None = None) -> Encircled:
    """Return the fraction of all light within circles about the axis, for any single pupil, of the optics alone.

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
        The error bound is that of the image at every point of the circle, all of one sign, and 2e-8: a few times
        1e-4 at worst for 10 lambda*N and a tolerance of 1e-6, and mostly far from reached.

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
        return Encircled(np.atleast_1d(radial_energy(of_profiles(), pupil, at)), None)
    reach = at / pupil.scale
    if reach.size and reach.max() > MAX_RADIUS:
        raise ValueError(
            f"radius must be at most {MAX_RADIUS:g} lambda*N for a pupil that is not radially symmetric, "
            f"got {reach.max():.6g} lambda*N"
        )
    if method is not None:
        method.require(pupil)
    (image,) = cartesian_images(optics(pupil, method), float(reach.max(initial=0.0)))
    area = math.pi * float(reach.max(initial=0.0)) ** 2
    error = None if image.error is None else OWN_ERROR + SEAM_NORM * area * image.error
    return Encircled(image.circles(reach), error)


def optics(pupil: Pupil, method: Method | None = None) -> ImageModel:
    """Return the model of the image of a pupil alone, by a method or by what serves it."""
    return ImageModel(pupil, method or candidates(pupil, Grid(3, 0.25 * pupil.scale))[0])


__all__ = ["MAX_RADIUS", "Encircled", "encircled", "optics"]
