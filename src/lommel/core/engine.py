"""The compiled core behind names, results and exceptions of Python; nothing else imports it.

Functions of arrays, so that others may stand in their place. Where the core says 0 for "divide by the largest value"
or "met", and a negative bound for "not met", these say None, and raise a ToleranceError.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel import _core
from lommel._core import (
    bessel_sequence,
    chebyshev_intensity,
    closed_form_field,
    collect,
    distinct_radii,
    gauss_error,
    gauss_legendre,
    huygens_sum,
    legendre_transforms,
    scatter,
    spread,
)
from lommel.base.arrays import Array
from lommel.core.answers import FieldValues, Images, Intensities, Slopes, not_met

__all__ = [
    "DiskStack",
    "PixelRadii",
    "RadialStack",
    "Window",
    "bessel_sequence",
    "chebyshev_intensity",
    "chordal_images",
    "closed_form_field",
    "collect",
    "distinct_radii",
    "gauss_error",
    "gauss_legendre",
    "huygens_sum",
    "legendre_transforms",
    "pixel_radii",
    "pixel_values",
    "radial_fields",
    "radial_images",
    "radial_means",
    "radial_profiles",
    "scatter",
    "series_images",
    "spread",
    "window_images",
]


class RadialStack(NamedTuple):
    """Radially symmetric pupils.

    Attributes
    ----------
    terms : ndarray, shape (n, k)
        Coefficients of R_2^0, R_4^0, ..., radians at the edge.
    obscuration : float
        Over the radius of the aperture.
    amplitude : ndarray
        g_0, g_1, ... of the amplitude ``exp(-(g_0 + g_1 rho^2 + ...))``.
    """

    terms: Array
    obscuration: float
    amplitude: Array


class DiskStack(NamedTuple):
    """Pupils of any wavefront.

    Attributes
    ----------
    terms : ndarray of int32, shape (k, 2)
        n and m of each Zernike term, m < 0 for sines.
    edge : ndarray, shape (n, k)
        Their coefficients, radians at the edge.
    obscuration, amplitude
        As of :class:`RadialStack`.
    """

    terms: NDArray[np.int32]
    edge: Array
    obscuration: float
    amplitude: Array


class Window(NamedTuple):
    """Pixels: (height, width), the pixel (row, column) that the axis is at, and their pitch in v."""

    shape: tuple[int, int]
    center: tuple[float, float]
    step: float


def _places(
    count: int, shape: tuple[int, int], scale: float | None, dtype: DTypeLike, out: NDArray[Any] | None
) -> tuple[NDArray[Any], Array, Array]:
    """Return where the core writes: images, what they are multiplied by, and bounds on their error."""
    scales = np.empty(count)
    scales.fill(0.0 if scale is None else scale)
    return np.empty((count, *shape), dtype) if out is None else out, scales, np.empty(count)


def _require(unmet: float, tol: float, over: str) -> None:
    if unmet:
        raise not_met(tol, unmet, over)


def radial_images(
    stack: RadialStack,
    window: Window,
    tol: float,
    scale: float | None,
    dtype: DTypeLike,
    *,
    out: NDArray[Any] | None = None,
    powers: tuple[int, ...] = (),
    threads: int = 0,
) -> Images:
    """Return samples around an axis in the middle of pixel ``(height // 2, width // 2)``.

    Parameters
    ----------
    stack, window
    tol : float
        Bound on the error over the peak of the PSF or, of values divided by their largest, over that.
    scale : float or None
        What to multiply the intensity by; None divides each image by its largest value.
    dtype, out
        Kind of the values, or where to write them, shape ``(n, height, width)``.
    powers : tuple of int
        k of each derivative by the coefficient of t^k that is wanted.
    threads : int
        At most so many; 0 for as many as there are processors.

    Raises
    ------
    ToleranceError
        If `tol` cannot be met.
    """
    places = _places(len(stack.terms), window.shape, scale, dtype, out)
    slopes = None
    if powers:
        slopes = _slopes(powers, places[0])
        wanted = np.array(powers, dtype=np.int64)
        unmet = _core.differentiate(*stack, window.step, tol, threads, *places, wanted, *slopes)
    else:
        unmet = _core.render(*stack, window.step, tol, threads, *places)
    _require(unmet, tol, "the peak")
    return Images(*places, slopes)


def window_images(
    stack: RadialStack,
    window: Window,
    tol: float,
    scale: float | None,
    dtype: DTypeLike,
    *,
    integrate: bool,
    out: NDArray[Any] | None = None,
    powers: tuple[int, ...] = (),
    threads: int = 0,
) -> Images:
    """Return averages over pixels, or samples around an axis anywhere; otherwise as :func:`radial_images`."""
    places, peaks = _places(len(stack.terms), window.shape, scale, dtype, out), np.empty(len(stack.terms))
    slopes, wanted = _slopes(powers, places[0]), np.array(powers, dtype=np.int64)
    given = (*stack, *window.center, window.step, integrate, tol, threads)
    unmet = _core.render_pixels(*given, *places, peaks, wanted, *slopes)
    _require(unmet, tol, "the largest value in the window" if scale is None else "the peak")
    return Images(*places, slopes if powers else None, peaks)


def _slopes(powers: tuple[int, ...], values: NDArray[Any]) -> Slopes:
    return Slopes(np.empty((len(powers), *values.shape), values.dtype), np.empty((len(powers), len(values))))


def series_images(
    stack: DiskStack,
    window: Window,
    tol: float,
    scale: float | None,
    dtype: DTypeLike,
    *,
    out: NDArray[Any] | None = None,
    threads: int = 0,
) -> Images:
    """Return samples of pupils that need not be radially symmetric by their series; as :func:`radial_images`."""
    places, peaks = _places(len(stack.edge), window.shape, scale, dtype, out), np.empty(len(stack.edge))
    unmet = _core.series_images(*stack, *window.center, window.step, tol, threads, *places, peaks)
    _require(unmet, tol, "the peak")
    return Images(*places, None, peaks)


def chordal_images(
    stack: DiskStack,
    window: Window,
    tol: float,
    scale: float | None,
    dtype: DTypeLike,
    *,
    out: NDArray[Any] | None = None,
    threads: int = 0,
) -> Images:
    """Return the same by the chordal rule, with errors over the largest value in the window."""
    places, peaks = _places(len(stack.edge), window.shape, scale, dtype, out), np.empty(len(stack.edge))
    unmet = _core.chordal_images(*stack, *window.center, window.step, tol, threads, *places, peaks)
    _require(unmet, tol, "the largest value in the window")
    return Images(*places, None, peaks)


def radial_fields(stack: RadialStack, v: Array, tol: float) -> FieldValues:
    """Return U at rising v, with errors that serve an intensity within `tol` of the peak, likely."""
    return FieldValues(*_core.field(*stack, v, tol))


def radial_profiles(stack: RadialStack, v: Array, tol: float) -> Intensities:
    """Return I at rising v, within `tol` of the peak.

    Raises
    ------
    ToleranceError
        If `tol` cannot be met.
    """
    values, bounds, peaks = _core.profile(*stack, v, tol)
    _require_all(bounds, tol)
    return Intensities(values, bounds, peaks)


def radial_means(stack: RadialStack, v: Array, tol: float, matrix: Array, threads: int = 0) -> Array:
    """Return ``I(v) @ matrix``, shape ``(n, sums)``, I as of :func:`radial_profiles`."""
    sums, bounds = _core.means(*stack, v, tol, matrix, threads)
    _require_all(bounds, tol)
    return sums


def _require_all(bounds: Array, tol: float) -> None:
    if bounds.min() < 0.0:
        raise not_met(tol, float(-bounds.min()), "the peak")


class PixelRadii(NamedTuple):
    """Radii at which I tells all pixels of a window, and what becomes of its errors; certificate, section 9."""

    v: Array
    error: float
    of_nodes: float
    of_grid: float
    rounding: float


def pixel_radii(window: Window, *, integrate: bool, level: int, threads: int = 0) -> PixelRadii:
    """Return the radii for errors of about ``10^-level``."""
    return PixelRadii(*_core.pixel_radii(*window.shape, *window.center, window.step, integrate, level, threads))


def pixel_values(
    window: Window, profiles: Array, *, integrate: bool, level: int, threads: int = 0
) -> tuple[Array, Array]:
    """Return the pixels from I at those radii, shape ``(n, height, width)``, and what their rounding is at most."""
    values = np.empty((len(profiles), *window.shape))
    penalties = _core.pixel_values(
        np.ascontiguousarray(profiles), *window.center, window.step, integrate, level, threads, values
    )
    return values, penalties
