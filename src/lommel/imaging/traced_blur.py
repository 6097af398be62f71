"""Depth-dependent blur as a differentiable function: PSFs for all defocus as polynomials of low rank."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.estimation.pixel_transfer import require_round
from lommel.imaging.blur import require_lens
from lommel.imaging.sensor_light import SensorLight
from lommel.methods.pixels.rule import cells_alike, quarters
from lommel.optics.lens import Lens
from lommel.traced.namespaces import Namespace, Operand, Tensor
from lommel.traced.traced_psf import Distances

_MOST = 2000  # windows


class Blur(NamedTuple):
    """The part of a blur that holds no arrays: C_d from `low` to `high` (radians), and `half` the side of windows."""

    namespace: Namespace
    distances: Distances
    low: float
    high: float
    half: int
    error: float


class TracedBlur:
    """Depth-dependent blur as a differentiable function: ``out = blur(image, distance)``, linear in the image.

    ``out[q] = sum_p image[p] K(q - p; C_d(distance[p]))``, without light from beyond the edges and without occlusion.
    Made by :func:`lommel.imaging.traced_blur`. The derivative with respect to the image is the adjoint; that with
    respect to the distance exists everywhere in the valid range. Beyond it all values are NaN.

    Parameters
    ----------
    static : Blur
        All but the arrays.
    weights : array, shape (degrees, rank)
        Weights of Chebyshev polynomials of the defocus.
    windows : array, shape (rank, side, side)
        Convolution kernels.

    Attributes
    ----------
    rank : int
        Number of convolutions.
    half : int
        Half width of the windows, pixels.
    error : float
        Largest error of the tested windows, relative to their peaks.
    """

    def __init__(self, static: Blur, weights: Tensor, windows: Tensor) -> None:
        self._static, self._weights, self._windows = static, weights, windows

    rank = property(lambda self: self._weights.shape[-1])
    half = property(lambda self: self._static.half)
    error = property(lambda self: self._static.error)

    def defocus(self, distance: Operand) -> Any:
        """Return C_d in radians of objects at a `distance`, metres; differentiable."""
        there = self._static.distances
        return there.waves * (there.vergence + 1.0 / distance)

    def __call__(self, image: Operand, distance: Operand) -> Any:
        """Return the blurred image.

        Parameters
        ----------
        image, distance : array, shape (height, width)
            Linear light of one channel, and metres from the lens.

        Returns
        -------
        array, shape (height, width)

        Raises
        ------
        ValueError
            If they are not of one shape.
        """
        from scipy.fft import next_fast_len

        static = self._static
        ns, xp = static.namespace, static.namespace.xp
        if len(image.shape) != 2 or tuple(image.shape) != tuple(distance.shape):
            shapes = f"{tuple(image.shape)} and {tuple(distance.shape)}"
            raise ValueError(f"image and distance must be of one shape (height, width), got {shapes}")
        image, distance = (xp.astype(part, self._weights.dtype) for part in (image, distance))
        height, width = image.shape
        middle, radius = 0.5 * (static.low + static.high), 0.5 * (static.high - static.low)
        x = (self.defocus(distance) - middle) * (1.0 / radius)
        x = xp.where(xp.abs(x) <= 1.0 + 1e-5, x, xp.full_like(x, float("nan")))
        before, here = xp.ones_like(x), x
        powers = [before, here]
        for _ in range(self._weights.shape[0] - 2):
            before, here = here, 2.0 * x * here - before
            powers.append(here)
        factors = ns.matmul(xp.stack(powers, axis=-1), self._weights)
        parts = xp.permute_dims(factors, (2, 0, 1)) * image
        size = tuple(int(next_fast_len(side + 2 * static.half, real=True)) for side in (height, width))
        spectrum = xp.fft.rfftn(parts, s=size, axes=(-2, -1)) * xp.fft.rfftn(self._windows, s=size, axes=(-2, -1))
        whole = xp.fft.irfftn(xp.sum(spectrum, axis=0), s=size, axes=(-2, -1))
        return whole[static.half : static.half + height, static.half : static.half + width]


def traced_blur(
    lens: Lens,
    distances: ArrayLike,
    pixel: float,
    xp: object = None,
    *,
    device: object = None,
    precision: str = "float32",
    tol: float = 1e-4,
    energy: float = 0.98,
    largest: int = 256,
) -> TracedBlur:
    r"""Return the blur of a lens as a differentiable function of an image and its depth, in JAX, PyTorch or NumPy.

    The pixel-integrated PSF is an entire function of C_d: over a range it is a sum of few Chebyshev polynomials times
    windows, and by singular vectors of fewer still. All defocus has one size of window, and is divided by the light
    within it, so that derivatives by depth are those of the image. See docs/certificate.md.

    Parameters
    ----------
    lens : Lens
        Paraxial, with a round aperture and radially symmetric aberrations.
    distances : array_like
        Metres; the valid range is from the least to the largest.
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
    require_lens(lens, "lens, distances, pixel")
    require_round("lens", lens)
    if lens.model != "paraxial":
        raise ValueError(f'lens must be paraxial, with model="paraxial", got {lens.model!r}')
    pitch = validation.pixel(pixel, metric=True)
    share = validation.real("energy", energy, above=0.0, below=1.0)
    allowed = validation.real("tol", tol, least=1e-9, below=1e-1)
    ns = Namespace.of(xp)
    validation.choice("precision", precision, ("float32", "float64"))
    if precision == "float64" and not ns.has_double(device):
        raise ValueError(f'precision must be "float32" here: {ns.name} has no float64, or it is switched off')
    found = lens.defocus(distances)
    low, high = float(found.min()), float(found.max())
    low, high = (low, high) if high - low > 0.2 else (low - 0.1, high + 0.1)
    light = SensorLight.of(lens, [(lens.wavelength, 1.0)], pitch)
    half, _ = light.enough((low, high), share, validation.integer("largest", largest, least=1, most=4096))
    middle, radius = 0.5 * (low + high), 0.5 * (high - low)

    def windows(x: Array) -> Array:
        shares = light.shares(light.defocused(middle + radius * x), half)
        return shares / (shares @ cells_alike(half))[:, None]

    weights, kept, error = _low_rank(windows, radius, allowed)
    away = np.abs(np.arange(-half, half + 1))
    waves = math.pi / (2.0 * lens.wavelength) * (0.5 * lens.aperture_diameter) ** 2
    there = Distances(1.0 / lens.sensor_distance - 1.0 / lens.focal_length, waves)
    kind = getattr(ns.xp, precision)
    if ns.name == "jax":
        _register()
    kernels = quarters(kept, half)[:, away[:, None], away]
    static = Blur(ns, there, low, high, half, error)
    return TracedBlur(static, ns.put(weights, device, kind), ns.put(kernels, device, kind))


def _low_rank(windows: Callable[[Array], Array], radius: float, tol: float) -> tuple[Array, Array, float]:
    """Return weights of Chebyshev polynomials, (degrees, rank), windows, (rank, cells), and their largest error."""
    # |I| grows like exp(2 |Im C|), which bounds the truncation but for the division by the light.
    rho = 1.0 + np.geomspace(1e-3, 20.0, 200)
    logarithm = radius * (rho - 1.0 / rho) + np.log(4.0 / (1e-9 * (rho - 1.0)))
    count = 8 + math.ceil(float((1.0 + logarithm / np.log(rho)).min()))
    if count > _MOST:
        raise ValueError(f"distances span {2.0 * radius:.4g} rad of C_d and take {count} windows, more than {_MOST}")
    angle = (np.arange(count) + 0.5) * (math.pi / count)
    transform = np.cos(np.outer(np.arange(count), angle)) * (2.0 / count)
    transform[0] *= 0.5
    at_nodes = windows(np.cos(angle))
    between = np.cos(np.linspace(0.0, math.pi, 2 * count + 1))
    exact, polynomials = windows(between), np.cos(np.outer(np.arccos(between), np.arange(count)))
    coefficients, peak = transform @ at_nodes, exact.max(axis=1)
    # Negligible degrees are left out: windows at nodes have errors of 1e-7 of their peaks.
    tail = np.cumsum(np.abs(coefficients).max(axis=1)[::-1])[::-1]
    degrees = max(2, int((tail > 1e-2 * tol * peak.min()).sum()))
    polynomials, coefficients = polynomials[:, :degrees], coefficients[:degrees]
    truncated, (left, size, right) = polynomials @ coefficients, np.linalg.svd(coefficients, full_matrices=False)
    for rank in range(1, len(size) + 1):
        weights, kept = left[:, :rank] * size[:rank], right[:rank]
        # A picture sums over pixels at all depths, so errors have to be small beside the faintest peak.
        if np.abs(polynomials @ weights @ kept - truncated).max() <= 0.4 * tol * peak.min():
            break
    return weights, kept, float((np.abs(polynomials @ weights @ kept - exact).max(axis=1) / peak).max())


@cache
def _register() -> None:
    """Register the class with JAX as a tree of its tables."""
    import jax

    jax.tree_util.register_pytree_node(
        TracedBlur,
        lambda blur: ((blur._weights, blur._windows), blur._static),
        lambda static, parts: TracedBlur(static, *parts),
    )
