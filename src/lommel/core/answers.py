"""What the compiled core and the methods answer: fields, intensities, images, and what is raised in their stead."""

# Annotations are not postponed: a NamedTuple compiles each that is text, which takes longer than all else here.

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel import _core
from lommel.base.arrays import Array

Declined = _core.Declined
"""A ValueError for a pupil or window beyond what a method takes, where another method may serve."""


class ToleranceError(ArithmeticError):
    """A method cannot meet the tolerance it was given."""


def not_met(tol: float, bound: float, what: str) -> ToleranceError:
    """Return what a method with a proven bound on its error over `what` raises where that stays above `tol`."""
    size = f"bounded by {bound:.2g} of {what}" if bound < 1.0 else f"which may be larger than {what}"
    return ToleranceError(
        f"tol={tol:g} cannot be met in double precision: the error, {size}, is not proven to be smaller"
    )


class FieldValues(NamedTuple):
    """The field at given radii, first axis the flattened stack of pupils.

    Attributes
    ----------
    values : complex ndarray, shape (n, radii)
    error : ndarray, shape (n,), or None
        Bounds on ``|U - U_exact|``; None where the method has none.
    """

    values: NDArray[np.complex128]
    error: Array | None


class Intensities(NamedTuple):
    """Intensities, first axis the flattened stack of pupils.

    Attributes
    ----------
    values : ndarray, shape (n, radii) or (n, height, width)
    error : ndarray, shape (n,), or None
        Bounds on ``max|I - I_exact| / peak``; None where the method has none.
    peak : ndarray, shape (n,), or None
        What the error is related to, where there is one.
    """

    values: Array
    error: Array | None
    peak: Array | None = None


class Wanted(NamedTuple):
    """How images are wanted.

    Attributes
    ----------
    scale : float or None, or ndarray, shape (n,)
        What to multiply the intensity by, in an array each image by its own; None divides each by its largest value.
    dtype : float32 or float64
    out : ndarray, shape (n, height, width), optional
        Where to write the values.
    powers : tuple of int
        k of each derivative with respect to the coefficient of t^k that is wanted.
    threads : int
        At most so many, 0 for as many as there are processors. Methods that are not compiled use one.
    terms : tuple of (int, int)
        n and m of each Zernike term whose coefficient a derivative is wanted by.
    """

    scale: float | Array | None = 1.0
    dtype: DTypeLike = np.float64
    out: NDArray[Any] | None = None
    powers: tuple[int, ...] = ()
    threads: int = 0
    terms: tuple[tuple[int, int], ...] = ()


class Slopes(NamedTuple):
    """Derivatives of images with respect to k coefficients of the phase.

    Attributes
    ----------
    values : ndarray, shape (k, n, height, width)
    error : ndarray, shape (k, n)
        Bounds on their error over the peak of the intensity.
    """

    values: NDArray[Any]
    error: Array


class Images(NamedTuple):
    """Finished images of a flattened stack.

    Attributes
    ----------
    values : ndarray, shape (n, height, width)
    scale : ndarray, shape (n,)
        What each intensity was multiplied by.
    error : ndarray, shape (n,), or None
        Bounds on the error over the peak.
    slopes : Slopes or None
        Derivatives, if any were asked for.
    peak : ndarray, shape (n,), or None
        What the error is related to, of the intensity itself, in the window or outside of it, where that is known.
    """

    values: NDArray[Any]
    scale: Array
    error: Array | None
    slopes: Slopes | None = None
    peak: Array | None = None
