"""Blur by depth that JAX and PyTorch can differentiate: windows as polynomials of defocus, of low rank."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.imaging.blur import require_lens
from lommel.imaging.sensor_light import SensorLight
from lommel.methods.pixels.rule import octant
from lommel.optics.lens import Lens
from lommel.traced import depth_blur
from lommel.traced.depth_blur import TracedBlur
from lommel.traced.namespaces import Namespace
from lommel.traced.plan_function import Distances

_MOST = 2000  # windows


def traced_blur(
    lens: Lens,
    reach: ArrayLike,
    pixel: float,
    xp: Any = None,
    *,
    device: Any = None,
    precision: str = "float32",
    tol: float = 1e-4,
    energy: float = 0.98,
    largest: int = 256,
) -> TracedBlur:
    r"""Return the blur of a lens as a differentiable function of an image and its depth, in JAX, PyTorch or NumPy.

    The PSF averaged over pixels is an entire function of C_d, so that on a range it is a sum of few Chebyshev
    polynomials times windows; of these, singular vectors leave fewer. All defocus has one window, and is divided by
    the light within it, so that nothing jumps: derivatives by depth are those of the image. See `Twins` in
    docs/certificate.md.

    Parameters
    ----------
    lens : Lens
        Paraxial, with a round aperture and radially symmetric aberrations.
    reach : array_like
        Distances, metres; those between the least and the largest are possible.
    pixel : float
        Pixel pitch, metres.
    xp, device
        As of :meth:`lommel.Plan.traced`.
    precision : {"float32", "float64"}, default "float32"
        Of the tables, and what is computed.
    tol : float, default 1e-4
        Largest error of a window over its peak.
    energy : float, default 0.98
        Share of the light that every window holds at least, before it is divided by that.
    largest : int, default 256
        Pixels from the middle of a window to its edge, at most.

    Returns
    -------
    TracedBlur

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or the blur exceeds `largest`.

    References
    ----------
    L. N. Trefethen, *Approximation Theory and Approximation Practice* (SIAM, 2013), Theorem 8.2.
    """
    require_lens(lens, "lens, reach, pixel")
    if lens.model != "paraxial" or not lens.aberrations.radial or lens.aberrations.shape:
        raise ValueError("lens must be paraxial, with one set of radially symmetric aberrations")
    if lens.spider or lens.vignetting or lens.mask:
        raise ValueError("lens must have a round aperture, without spider, vignetting and mask")
    pitch = validation.pixel(pixel, metric=True)
    share = validation.real("energy", energy, above=0.0, below=1.0)
    allowed = validation.real("tol", tol, least=1e-9, below=1e-1)
    ns = Namespace.of(xp)
    validation.choice("precision", precision, ("float32", "float64"))
    if precision == "float64" and not ns.has_double(device):
        raise ValueError(f'precision must be "float32" here: {ns.name} has no float64, or was not told to use it')
    found = lens.defocus(reach)
    low, high = float(found.min()), float(found.max())
    low, high = (low, high) if high - low > 0.2 else (low - 0.1, high + 0.1)
    light = SensorLight.of(lens, [(lens.wavelength, 1.0)], pitch)
    half, _ = light.enough((low, high), share, validation.integer("largest", largest, least=1, most=4096))
    return _made(ns, light, lens, (low, high, half), (precision, allowed, device))


def _made(
    ns: Namespace, light: SensorLight, lens: Lens, where: tuple[float, float, int], how: tuple[str, float, Any]
) -> TracedBlur:
    (low, high, half), (precision, tol, device) = where, how
    middle, reach = 0.5 * (low + high), 0.5 * (high - low)

    def windows(x: Any) -> Any:
        shares = light.shares(light.defocused(middle + reach * x), half)
        column, row = octant(half)
        alike = np.where(column == 0, 1.0, np.where((row == 0) | (row == column), 4.0, 8.0))
        return shares / (shares @ alike)[:, None]

    # |I| grows like exp(2 |Im C|): what is left out of a polynomial, but for that of the division by the light.
    rho = 1.0 + np.geomspace(1e-3, 20.0, 200)
    logarithm = reach * (rho - 1.0 / rho) + np.log(4.0 / (1e-9 * (rho - 1.0)))
    count = 8 + math.ceil(float((1.0 + logarithm / np.log(rho)).min()))
    if count > _MOST:
        raise ValueError(f"reach spans C_d from {low:.4g} to {high:.4g} rad, which takes {count} windows, too many")
    angle = (np.arange(count) + 0.5) * (math.pi / count)
    transform = np.cos(np.outer(np.arange(count), angle)) * (2.0 / count)
    transform[0] *= 0.5
    at_nodes = windows(np.cos(angle))
    between = np.cos(np.linspace(0.0, math.pi, 2 * count + 1))
    exact, polynomials = windows(between), np.cos(np.outer(np.arccos(between), np.arange(count)))
    coefficients, peak = transform @ at_nodes, exact.max(axis=1)
    # Degrees that no pixel has anything of are left out: windows at nodes are known to 1e-7 of their peaks.
    tail = np.cumsum(np.abs(coefficients).max(axis=1)[::-1])[::-1]
    degrees = max(2, int((tail > 1e-2 * tol * peak.min()).sum()))
    # As a whole picture adds these up, errors are to be small beside the faintest peak.
    weights, kept = depth_blur.factored(coefficients[:degrees], polynomials[:, :degrees], 0.4 * tol * peak.min())
    error = float((np.abs(polynomials[:, :degrees] @ weights @ kept - exact).max(axis=1) / peak).max())
    column, row = octant(half)
    cell = np.empty((half + 1, half + 1), dtype=np.int64)
    cell[row, column] = cell[column, row] = np.arange(row.size)
    away = np.abs(np.arange(-half, half + 1))
    waves = math.pi / (2.0 * lens.wavelength) * (0.5 * lens.aperture_diameter) ** 2
    distances = Distances(1.0 / lens.sensor_distance - 1.0 / lens.focal_length, waves)
    static = depth_blur.Blur(ns, distances, low, high, half, precision, error)
    return depth_blur.placed(static, weights, kept[:, cell[away[:, None], away]], device)
