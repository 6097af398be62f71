"""Results of the compiled core and of the methods: fields, intensities, images; and their exceptions."""

# Annotations are not postponed: a NamedTuple compiles each that is text, which takes longer than all else here.

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base.arrays import Array, Values

DType = np.dtype[Any]  # the type of such values


class Declined(ValueError):  # noqa: N818 (no fault: another method is tried)
    """A pupil or window beyond the range of a method; the compiled core raises it too."""


Pixels = Values  # values of images as they are stored, float32 or float64


class ToleranceError(ArithmeticError):
    """A method cannot meet the requested tolerance; `bound` is the relative error that it proves, if known."""

    bound: float | None = None


def not_met(tol: float, bound: float, what: str, where: str = "in double precision") -> ToleranceError:
    """Return the error of a method whose proven bound on its error over `what` stays above `tol`."""
    size = f"{bound:.2g} of {what}" if bound < 1.0 else f"as large as {what}"
    # Two digits, with room for what grows with the tolerance.
    enough = _rounded_up(2.0 * bound) if 1e-300 < bound < 0.05 else 1.0
    advice = f"; give tol={enough:g}" if tol < enough < 1.0 else ""
    error = ToleranceError(
        f"tol={tol:g} cannot be met {where}: the error may be {size}, for all that is proven{advice}"
    )
    error.bound = bound
    return error


def _rounded_up(number: float) -> float:
    digit = 10.0 ** (math.floor(math.log10(number)) - 1)
    return float(f"{math.ceil(number / digit) * digit:.2g}")


class FieldValues(NamedTuple):
    """The field U at given radii, first axis the flattened stack of pupils."""

    values: NDArray[np.complex128]  # (n, radii)
    error: Array | None  # (n,), bounds on abs(U - U_exact); None where the method has none


class Intensities(NamedTuple):
    """Intensities, first axis the flattened stack of pupils."""

    values: Array  # (n, radii) or (n, height, width)
    error: Array | None  # (n,), bounds on max abs(I - I_exact) over the peak; None where there are none
    peak: Array | None = None  # (n,), what the error is related to


class Wanted(NamedTuple):
    """Request for images: their scale, type and place, derivatives and threads."""

    # Factor of I, for each image (n,) or all; None divides each by its largest value.
    scale: float | Array | None = 1.0
    dtype: DTypeLike = np.float64  # float32 or float64
    out: Pixels | None = None  # (n, height, width), where to write the values
    powers: tuple[int, ...] = ()  # k of each coefficient of t^k to differentiate by
    threads: int = 0  # at most so many, 0 for as many as there are processors
    terms: tuple[tuple[int, int], ...] = ()  # n and m of each Zernike term to differentiate by


class Slopes(NamedTuple):
    """Derivatives of images with respect to k coefficients of the phase."""

    values: Pixels  # (k, n, height, width)
    error: Array  # (k, n), bounds over the peak of the intensity


class Images(NamedTuple):
    """Finished images of a flattened stack."""

    values: Pixels  # (n, height, width)
    scale: Array  # (n,), what each intensity was multiplied by
    error: Array | None  # (n,), bounds over the peak; None where there are none
    slopes: Slopes | None = None
    peak: Array | None = None  # (n,), of the intensity itself, which errors relate to, in the window or outside of it

    @property
    def intensities(self) -> Intensities:
        """The values, errors and peaks alone."""
        return Intensities(self.values, self.error, self.peak)

    @property
    def bound(self) -> Array:
        """The error, of images that have one."""
        assert self.error is not None
        return self.error

    @property
    def brightest(self) -> Array:
        """The peak, of images that have one."""
        assert self.peak is not None
        return self.peak
