r"""Few wavelengths for many: sums that stand for integrals over measured spectra, with a proven error.

The intensity at a point of the sensor is a sum over pairs of points of the pupil, whose optical paths to it differ
by L: of ``exp(2 pi i L / lambda) / lambda^2``, times what depends on no wavelength. So a sum over wavelengths in
place of the integral over a spectrum q is off, over the peak without aberration, by no more than the largest of

``E(L) = | sum_k u_k exp(2 pi i L s_k) - int q(s) exp(2 pi i L s) ds |``,  s = 1 / lambda,

over all paths that occur, where u and q hold the factor 1 / lambda^2 and q has the integral 1. The s_k are Gauss
nodes all over the spectrum; the u_k >= 0 are those of least squares over L.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.special.legendre import gauss_legendre

_MOST = 256  # wavelengths
_AT_ONCE = 2**20  # waves
_SLACK = 0.1  # of the tolerance: what |E| may be more between the paths that it is looked at


def few(wavelengths: Array, curves: Array, paths: float, tol: float) -> tuple[Array, Array, float]:
    """Return few wavelengths and weights that stand for spectra.

    Parameters
    ----------
    wavelengths : ndarray, shape (n,)
        Metres, rising, at least two.
    curves : ndarray, shape (channels, n)
        Light at each, >= 0, linear in between; none is all 0.
    paths : float
        Largest difference of optical paths in the pupil, metres.
    tol : float
        Bound on the error over the peak without aberration.

    Returns
    -------
    wavelengths : ndarray, shape (k,)
        Rising.
    weights : ndarray, shape (channels, k)
        Each row sums to 1.
    error : float
        What the largest error is at most.

    Raises
    ------
    ValueError
        If it takes more than 256 wavelengths.
    """
    lit = np.flatnonzero(curves.any(axis=0))
    first, last = max(lit[0] - 1, 0), min(lit[-1] + 1, wavelengths.size - 1)
    low, high = 1.0 / wavelengths[last], 1.0 / wavelengths[first]
    phase = math.pi * (high - low) * paths  # half of what it differs by over the spectrum
    count = max(1, int(0.5 * phase / math.pi))
    if 0.5 * count > _MOST:
        raise _too_many(paths, tol)
    at, light = _dense(wavelengths, curves, paths)
    path = np.linspace(0.0, paths, math.ceil(phase / (2.0 * math.sqrt(_SLACK * tol))) + 2)
    slack = (0.5 * phase / (path.size - 1)) ** 2
    middle = 0.5 * (low + high)
    bright = light / at**2
    bright /= bright.sum(axis=1, keepdims=True)
    blocks = np.array_split(path, math.ceil(path.size * at.size / _AT_ONCE))
    exact = np.concatenate([bright @ _waves(at, block, middle).T for block in blocks], axis=1)
    while count <= _MOST:
        nodes = 1.0 / (low + (high - low) * gauss_legendre(count, 0.0, 1.0)[0][::-1])
        waves = _waves(nodes, path, middle)
        weights = np.stack([_fitted(waves, one, nodes, row @ at**2) for one, row in zip(exact, bright, strict=True)])
        bright_nodes = weights / nodes**2 * (bright @ at**2)[:, None]
        error = float(np.abs(bright_nodes @ waves.T - exact).max()) + slack
        if error <= tol:
            used = np.flatnonzero(weights.any(axis=0))
            return nodes[used], weights[:, used], error
        count += max(1, count // 8)
    raise _too_many(paths, tol)


def _too_many(paths: float, tol: float) -> ValueError:
    return ValueError(
        f"tol={tol:g} takes more than {_MOST} wavelengths where paths differ by up to {paths:g} m; ask for a larger "
        "tol, or for less of the paths"
    )


def _dense(wavelengths: Array, curves: Array, paths: float) -> tuple[Array, Array]:
    """Return nodes of a quadrature over the curves, and the light at each times its weight, to about 1e-10."""
    nodes, weights = gauss_legendre(4, 0.0, 1.0)
    ends = [wavelengths[:1]]
    for a, b in pairwise(wavelengths):
        pieces = max(4, math.ceil(2.0 * math.pi * paths * (1.0 / a - 1.0 / b)))
        ends.append(a + (b - a) * np.arange(1, pieces + 1) / pieces)
    edges = np.concatenate(ends)
    step = np.diff(edges)
    at = (edges[:-1, None] + step[:, None] * nodes).ravel()
    light = np.stack([np.interp(at, wavelengths, curve) for curve in curves])
    return at, light * (step[:, None] * weights).ravel()


def _waves(wavelengths: Array, path: Array, middle: float) -> Array:
    """Return ``exp(2 pi i L (1 / lambda - middle))``, shape (paths, wavelengths)."""
    return np.asarray(np.exp(2j * math.pi * np.outer(path, 1.0 / wavelengths - middle)))


def _fitted(waves: Array, exact: Array, nodes: Array, mean: float) -> Array:
    """Return weights >= 0 that sum to 1, of the least squares of E.

    Those of light, of which ``u = weight / lambda^2 * mean`` is made; that they sum to 1 weighs as much as E(0) = 0.
    """
    from scipy.optimize import nnls

    thin = waves[:: max(1, len(waves) // (8 * nodes.size + 32))]
    goal = exact[:: max(1, len(waves) // (8 * nodes.size + 32))]
    scale = mean / nodes**2
    rows = np.concatenate([thin.real * scale, thin.imag * scale, math.sqrt(len(thin)) * np.ones((1, nodes.size))])
    try:
        found = np.asarray(nnls(rows, np.concatenate([goal.real, goal.imag, [math.sqrt(len(thin))]]))[0])
    except RuntimeError as error:  # of iterations without end
        raise ValueError(f"the weights of {nodes.size} wavelengths are not found: {error}") from None
    return np.asarray(found / found.sum())


def checked_paths(paths: float, tol: float) -> tuple[float, float]:
    """Return both, if they are what :func:`few` takes; TypeError or ValueError otherwise."""
    return (
        validation.real("paths", paths, above=0.0, below=1e-2, unit="metres"),
        validation.real("tol", tol, least=1e-6, below=0.5),
    )
