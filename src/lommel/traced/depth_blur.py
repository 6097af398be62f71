"""Blur that varies with depth, within a framework: convolutions whose factors are polynomials of defocus."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.traced.namespaces import Namespace
from lommel.traced.plan_function import Distances


class Blur(NamedTuple):
    """All of a blur that is no array.

    Attributes
    ----------
    namespace : Namespace
    distances : Distances
    low, high : float
        The reach, C_d in radians.
    half : int
        Pixels from the middle of windows to their edge.
    precision : str
    error : float
        Of windows over their peaks.
    """

    namespace: Namespace
    distances: Distances
    low: float
    high: float
    half: int
    precision: str
    error: float


class TracedBlur:
    """What a lens makes of an image and its depth: ``out = blur(image, distance)``, linear in the image.

    ``out[q] = sum_p image[p] K(q - p; C_d(distance[p]))``; from beyond the edges comes no light. A pure function,
    made by :func:`lommel.imaging.traced_blur`; its derivative by the image is the adjoint, and that by the distance
    exists everywhere within reach. Beyond it, everything is NaN.

    Parameters
    ----------
    static : Blur
        All that is no array.
    weights : array, shape (degrees, rank)
        Of Chebyshev polynomials of the defocus.
    windows : array, shape (rank, side, side)
        What these are convolved with.

    Attributes
    ----------
    rank : int
        How many convolutions it takes.
    half : int
        Pixels from the middle of windows to their edge.
    error : float
        Largest error of a window over its peak, of all that were looked at.
    """

    def __init__(self, static: Blur, weights: Any, windows: Any) -> None:
        self._static, self._weights, self._windows = static, weights, windows

    rank = property(lambda self: self._weights.shape[-1])
    half = property(lambda self: self._static.half)
    error = property(lambda self: self._static.error)

    def defocus(self, distance: Any) -> Any:
        """Return C_d in radians of objects at a `distance`, metres; differentiable."""
        there = self._static.distances
        return there.waves * (there.vergence + 1.0 / distance)

    def __call__(self, image: Any, distance: Any) -> Any:
        """Return the image that the lens makes.

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
        static = self._static
        ns, xp = static.namespace, static.namespace.xp
        if len(image.shape) != 2 or tuple(image.shape) != tuple(distance.shape):
            shapes = f"{tuple(image.shape)} and {tuple(distance.shape)}"
            raise ValueError(f"image and distance must be of one shape (height, width), got {shapes}")
        image, distance = (xp.astype(part, self._weights.dtype) for part in (image, distance))
        height, width = image.shape
        middle, reach = 0.5 * (static.low + static.high), 0.5 * (static.high - static.low)
        x = (self.defocus(distance) - middle) * (1.0 / reach)
        x = xp.where(xp.abs(x) <= 1.0 + 1e-5, x, xp.full_like(x, float("nan")))
        before, here = xp.ones_like(x), x
        powers = [before, here]
        for _ in range(self._weights.shape[0] - 2):
            before, here = here, 2.0 * x * here - before
            powers.append(here)
        factors = ns.matmul(xp.stack(powers, axis=-1), self._weights)
        parts = xp.permute_dims(factors, (2, 0, 1)) * image
        size = _fast(height + 2 * static.half), _fast(width + 2 * static.half)
        spectrum = xp.fft.rfftn(parts, s=size, axes=(-2, -1)) * xp.fft.rfftn(self._windows, s=size, axes=(-2, -1))
        whole = xp.fft.irfftn(xp.sum(spectrum, axis=0), s=size, axes=(-2, -1))
        return whole[static.half : static.half + height, static.half : static.half + width]


def _fast(side: int) -> int:
    from scipy.fft import next_fast_len

    return int(next_fast_len(side, real=True))


def factored(coefficients: Array, windows: Array, allowed: float) -> tuple[Array, Array]:
    """Return factors whose product is that of Chebyshev coefficients and windows, of the least rank for an error.

    Parameters
    ----------
    coefficients : ndarray, shape (degrees, pixels)
    windows : ndarray, shape (several, degrees)
        Chebyshev polynomials where errors are looked at.
    allowed : float
        Largest error of a pixel.
    """
    left, size, right = np.linalg.svd(coefficients, full_matrices=False)
    exact = windows @ coefficients
    for rank in range(1, len(size) + 1):
        if np.abs((windows @ (left[:, :rank] * size[:rank])) @ right[:rank] - exact).max() <= allowed:
            break
    return left[:, :rank] * size[:rank], right[:rank]


def placed(static: Blur, weights: Array, windows: Array, device: Any) -> TracedBlur:
    """Return a blur whose tables are put on a device."""
    ns = static.namespace
    if ns.name == "jax":
        _register()
    kind = getattr(ns.xp, static.precision)
    return TracedBlur(static, ns.put(weights, device, kind), ns.put(windows, device, kind))


def _register() -> None:
    import jax

    if getattr(TracedBlur, "_is_tree", False):
        return
    TracedBlur._is_tree = True  # type: ignore[attr-defined]
    jax.tree_util.register_pytree_node(
        TracedBlur,
        lambda blur: ((blur._weights, blur._windows), blur._static),
        lambda static, parts: TracedBlur(static, *parts),
    )
