"""The compiled core behind names, results and exceptions of Python; nothing else imports it.

Functions of arrays, so that others may stand in their place. Where the core says 0 for "divide by the largest value"
or "met", and a negative bound for "not met", these say None, and raise a ToleranceError.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel import _core
from lommel._core import (
    average_samples,
    bessel_sequence,
    chebyshev_intensity,
    closed_form_field,
    collect,
    distinct_radii,
    gauss_error,
    gauss_legendre,
    huygens_sum,
    legendre_transforms,
    product,
    scatter,
    spread,
)
from lommel.base.arrays import Array
from lommel.core.answers import FieldValues, Images, Intensities, Slopes, Wanted, not_met

__all__ = [
    "DiskStack",
    "PixelRadii",
    "RadialStack",
    "Window",
    "average_samples",
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
    "product",
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


def _places(count: int, shape: tuple[int, int], wanted: Wanted) -> tuple[NDArray[Any], Array, Array]:
    """Return where the core writes: images, what they are multiplied by, and bounds on their error."""
    scales = np.empty(count)
    scales.fill(0.0 if wanted.scale is None else wanted.scale)
    return np.empty((count, *shape), wanted.dtype) if wanted.out is None else wanted.out, scales, np.empty(count)


def _require(unmet: float, tol: float, over: str) -> None:
    if unmet:
        raise not_met(tol, unmet, over)


def radial_images(stack: RadialStack, window: Window, tol: float, wanted: Wanted) -> Images:
    """Return samples around an axis in the middle of pixel ``(height // 2, width // 2)``.

    Parameters
    ----------
    stack, window
    tol : float
        Bound on the error over the peak of the PSF or, of values divided by their largest, over that.
    wanted : Wanted

    Returns
    -------
    Images

    Raises
    ------
    ToleranceError
        If `tol` cannot be met.
    """
    places, threads = _places(len(stack.terms), window.shape, wanted), wanted.threads
    slopes = None
    if wanted.powers:
        powers, slopes = _slopes(wanted, places[0])
        unmet = _core.differentiate(*stack, window.step, tol, threads, *places, powers, *slopes)
    else:
        unmet = _core.render(*stack, window.step, tol, threads, *places)
    _require(unmet, tol, "the peak")
    return Images(*places, slopes)


def window_images(stack: RadialStack, window: Window, tol: float, wanted: Wanted, *, integrate: bool) -> Images:
    """Return averages over pixels, or samples around an axis anywhere; otherwise as :func:`radial_images`."""
    places, peaks = _places(len(stack.terms), window.shape, wanted), np.empty(len(stack.terms))
    powers, slopes = _slopes(wanted, places[0])
    given = (*stack, *window.center, window.step, integrate, tol, wanted.threads)
    unmet = _core.render_pixels(*given, *places, peaks, powers, *slopes)
    _require(unmet, tol, "the largest value in the window" if wanted.scale is None else "the peak")
    return Images(*places, slopes if wanted.powers else None, peaks)


def _slopes(wanted: Wanted, values: NDArray[Any]) -> tuple[NDArray[np.int64], Slopes]:
    """Return the powers that derivatives are wanted by, and where the core writes these."""
    powers = np.array(wanted.powers, dtype=np.int64)
    return powers, Slopes(np.empty((len(powers), *values.shape), values.dtype), np.empty((len(powers), len(values))))


def series_images(stack: DiskStack, window: Window, tol: float, wanted: Wanted) -> Images:
    """Return samples of pupils that need not be radially symmetric by their series; as :func:`radial_images`."""
    return _disk_images(_core.series_images, "the peak", stack, window, tol, wanted)


def chordal_images(stack: DiskStack, window: Window, tol: float, wanted: Wanted) -> Images:
    """Return the same by the chordal rule, with errors over the largest value in the window."""
    return _disk_images(_core.chordal_images, "the largest value in the window", stack, window, tol, wanted)


def _disk_images(
    compute: Callable[..., float], over: str, stack: DiskStack, window: Window, tol: float, wanted: Wanted
) -> Images:
    places, peaks = _places(len(stack.edge), window.shape, wanted), np.empty(len(stack.edge))
    unmet = compute(*stack, *window.center, window.step, tol, wanted.threads, *places, peaks)
    _require(unmet, tol, over)
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
