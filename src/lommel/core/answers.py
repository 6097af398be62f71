"""Results and exceptions of the compiled core and of the methods: fields, intensities and images."""

# No `from __future__ import annotations`: compiling annotations that are text slows down the import of NamedTuples.

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base.arrays import Array, Values

DType = np.dtype[Any]  # type of the values of an image


class Declined(ValueError):  # noqa: N818 (not an error: another method is tried)
    """Exception for a pupil or window outside the range of a method; the compiled core raises it too.

    Where a method is named, users get it, as a ValueError whose message says what to do: :meth:`advised`.
    """

    def advised(self) -> "Declined":
        """Return the exception for a method that is named: another one may compute the images."""
        told = "leave method out" in str(self)
        return self if told else Declined(f"{self}; leave method out for a method without this limit")


Pixels = Values  # values of images as they are stored, float32 or float64


class ToleranceError(ArithmeticError):
    """Error of a method that cannot meet the tolerance; `bound` is its proven relative error bound, or None."""

    bound: float | None = None


def not_met(
    tol: float, bound: float, reference: str, conditions: str = "in double precision", other: str = ""
) -> ToleranceError:
    """Return the exception for a method whose error bound, relative to `reference`, exceeds `tol`.

    `other` names a method that may meet it.
    """
    error_size = f"{bound:.2g} of {reference}" if bound < 1.0 else f"as large as {reference}"
    # Suggest twice the bound, since the bound may increase with the tolerance.
    sufficient = _rounded_up(2.0 * bound) if 1e-300 < bound < 0.05 else 1.0
    advice = " or ".join([f"tol={sufficient:g}"] * (tol < sufficient < 1.0) + [f"method={other}"] * bool(other))
    reached = f"the proven error bound is {error_size}" + (f"; give {advice}" if advice else "")
    error = ToleranceError(f"tol={tol:g} cannot be met {conditions}: {reached}")
    error.bound = bound
    return error


def _rounded_up(number: float) -> float:
    """Return a number rounded up to two digits."""
    digit = 10.0 ** (math.floor(math.log10(number)) - 1)
    return float(f"{math.ceil(number / digit) * digit:.2g}")


class FieldValues(NamedTuple):
    """The field U of n pupils (a flattened stack) at given radii."""

    values: NDArray[np.complex128]  # (n, radii)
    error: Array | None  # (n,), bounds on abs(U - U_exact); None if the method has no bound


class Intensities(NamedTuple):
    """Intensities of n pupils (a flattened stack)."""

    values: Array  # (n, radii) or (n, height, width)
    error: Array | None  # (n,), bounds on max(abs(I - I_exact)) / peak; None if the method has no bound
    peak: Array | None = None  # (n,), intensity by which the errors are divided


class Wanted(NamedTuple):
    """Request for images: scale, type, output array, derivatives and threads."""

    # Factor of I: one number, or (n,) with one for each image; None to divide each image by its largest value.
    scale: float | Array | None = 1.0
    dtype: DTypeLike = np.float64  # float32 or float64
    out: Pixels | None = None  # (n, height, width), array for the values
    powers: tuple[int, ...] = ()  # exponents k; derivatives are with respect to the phase coefficients of rho^(2 k)
    threads: int = 0  # maximum number of threads; 0 for the number of processors
    terms: tuple[tuple[int, int], ...] = ()  # (n, m) of Zernike terms for derivatives with respect to coefficients


class Slopes(NamedTuple):
    """Derivatives of images with respect to k coefficients of the phase."""

    values: Pixels  # (k, n, height, width)
    error: Array  # (k, n), bounds on (error / peak of the intensity)


class Samples(NamedTuple):
    """Images of n pupils (a flattened stack), scaled and in their final type."""

    values: Pixels  # (n, height, width)
    scale: Array  # (n,), factors by which the intensities were multiplied
    error: Array | None  # (n,), bounds on (error / peak); None if the method has no bound
    slopes: Slopes | None = None
    peak: Array | None = None  # (n,), peaks of the unscaled intensity, which may lie outside the window

    @property
    def intensities(self) -> Intensities:
        """Values, error bounds and peaks, without scale and derivatives."""
        return Intensities(self.values, self.error, self.peak)

    @property
    def bound(self) -> Array:
        """Error bounds, for images that must have bounds."""
        assert self.error is not None
        return self.error

    @property
    def brightest(self) -> Array:
        """Peaks, for images that must have peaks."""
        assert self.peak is not None
        return self.peak
