r"""How images change as the central obscuration grows.

``dU/d eps = -(eps / pi) A(eps) int_0^2pi P(eps, theta) exp(-i eps v cos(theta - psi)) d theta``, minus the field of
the rim, by the trapezoidal rule, which converges geometrically for a periodic entire integrand. U is that of the
product rule of the aperture, exact for polynomials up to a degree. Both are products of two matrices, one for rows
and one for columns.

References
----------
L. N. Trefethen and J. A. C. Weideman, "The exponentially convergent trapezoidal rule", SIAM Review 56, 385 (2014),
doi:10.1137/130932132: Theorem 3.2.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.methods.averaging import blocks, filtered_by, finer, least_average, weighed
from lommel.optics.grid import Grid
from lommel.optics.opening import degree_needed
from lommel.optics.pupil import Pupil
from lommel.special import zernike

_B = np.geomspace(1e-3, 8.0, 128)
_NODES = 512  # at once
_UNIT = 2.0**-53


def by_obscuration(pupil: Pupil, grid: Grid, error: float) -> tuple[Array, Array]:
    """Return the derivative of I by the obscuration, or its averages over pixels.

    Parameters
    ----------
    pupil : Pupil
        Round, with an obscuration above 0.
    grid : Grid
    error : float
        What is aimed at, absolute.

    Returns
    -------
    values : ndarray, shape (n, height, width)
    error : ndarray, shape (n,)
        Bound on its error, absolute.
    """
    count = math.prod(pupil.shape)
    if not grid.integrate:
        return _samples(pupil, grid, error)
    step = grid.step(pupil)
    taps = filtered_by(step, max(0.1 * error * least_average(step), 1e-13))
    total, off = np.empty((count, *grid.shape)), np.empty(count)
    # The transfer function of the product of two fields, the integral of whose magnitude is at most this.
    most = 2.0 * pupil.amplitude * _light(pupil)
    for part, one, pixels in blocks(pupil, grid, taps):
        values, wrong = _samples(one, finer(pixels, taps), 0.3 * error)
        total[part] = weighed(values, taps, taps)
        off[part] = taps.gain**2 * (wrong + (2 * taps.weights.size + 8) * _UNIT * most)
    return total, off + (2.0 + taps.error) * taps.error * most


def _light(pupil: Pupil) -> float:
    """Return the largest field of the rim, ``2 eps A(eps)``."""
    eps = pupil.obscuration
    return 2.0 * eps * float(pupil.illumination.at(np.array(eps * eps)))


def _samples(pupil: Pupil, grid: Grid, error: float) -> tuple[Array, Array]:
    amplitude, light, eps = pupil.amplitude, _light(pupil), pupil.obscuration
    across, down = (grid.step(pupil) / grid.side * part for part in grid.positions(pupil.shape))
    reach = float(np.hypot(np.abs(across).max(axis=1), np.abs(down).max(axis=1)).max())
    aim = max(0.1 * error / (amplitude + light), 1e-15)
    terms = _amplitudes(pupil)
    x, y, weight = pupil.rule(degree_needed([(n, w) for (n, _), w in terms.items()], reach, pupil.illumination, aim))
    disk = _fields(pupil, x, y, weight, across, down)
    nodes = _nodes(terms, eps, reach, aim / light)
    theta = (np.arange(nodes) + 0.5) * (2.0 * math.pi / nodes)
    rim = _fields(pupil, eps * np.cos(theta), eps * np.sin(theta), np.full(nodes, 2.0 * eps / nodes), across, down)
    # A phase or an amplitude off by e changes both fields by e of what they are at most; so do roundings.
    left = pupil.wavefront.left_out + 2.0 * pupil.illumination.error
    left += _rounding(pupil, reach, max(nodes, weight.size))
    of_disk, of_rim = aim + left * amplitude, aim + left * light
    off = np.full(len(across), 2.0 * (amplitude * of_rim + light * of_disk + of_rim * of_disk))
    return -2.0 * (disk.real * rim.real + disk.imag * rim.imag), off


def _amplitudes(pupil: Pupil) -> dict[tuple[int, int], float]:
    """Return the largest amplitude of cosine and sine of each (n, m) throughout the stack, m >= 0."""
    squares: dict[tuple[int, int], Any] = {}
    for (n, m), c in pupil.wavefront.edge_terms().items():
        squares[n, abs(m)] = squares.get((n, abs(m)), 0.0) + c**2
    return {term: math.sqrt(float(np.max(square))) for term, square in squares.items() if np.any(square)}


def _nodes(terms: dict[tuple[int, int], float], eps: float, reach: float, error: float) -> int:
    """Return how many equal angles integrate the field of the rim, over its largest, to this error.

    At ``theta + i b`` the integrand is at most ``exp(sum_j W_j |R_j(eps)| sinh(m_j b) + eps v sinh b)``; k nodes err
    by twice that over ``e^(k b) - 1``, for every b > 0.
    """
    size = eps * reach * np.sinh(_B)
    for (n, m), w in terms.items():
        size = size + w * abs(float(zernike.radial(n, m, np.array(eps)))) * np.sinh(np.minimum(m * _B, 700.0))
    return max(1, math.ceil(float(((size + math.log(2.0 / error + 1.0)) / _B).min())))


def _rounding(pupil: Pupil, reach: float, nodes: int) -> float:
    """Bound what rounding does to a field over the integral of its amplitude; certificate, section 8."""
    terms = np.array([n * n + 10.0 + len(pupil.wavefront.terms) for n, _ in pupil.wavefront.terms])
    phases = float((np.abs(pupil.wavefront.edge) @ terms).max())
    return _UNIT * (phases + 12.0 * reach + 3.0 * _NODES + nodes / _NODES + 40.0)


def _fields(pupil: Pupil, x: Array, y: Array, weight: Array, across: Array, down: Array) -> NDArray[np.complex128]:
    """Return ``sum weight P exp(-i (v_x x + v_y y))`` over nodes for each of the flattened stack."""
    rho, theta = np.hypot(x, y), np.arctan2(y, x)
    light = weight * pupil.illumination.at(rho * rho)
    wavefronts, shared = pupil.wavefront.flattened(), bool(np.all(across == across[0]) and np.all(down == down[0]))
    total = np.zeros((len(across), down.shape[1], across.shape[1]), dtype=np.complex128)
    for first in range(0, x.size, _NODES):
        part = slice(first, first + _NODES)
        for i in range(len(total)):
            if i == 0 or not shared:
                rows, columns = np.exp(-1j * np.outer(down[i], y[part])), np.exp(-1j * np.outer(x[part], across[i]))
            wave = light[part] * np.exp(1j * wavefronts[i].phase(rho[part], theta[part]))
            total[i] += (rows * wave) @ columns
    return total
