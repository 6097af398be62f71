r"""Error bounds of the fields and images of differentiable plans, computed on the device of the field.

Let e be the error of the field, and M the largest absolute field in the window. The error of the intensity, and the
error of its peak, are then at most ``2 M e + e^2`` (docs/certificate.md, section 6).

The chordal rule sums over parallel chords of the disk, and over nodes on each chord. The error of each of these sums
is bounded by the mean of the absolute integrand on a curve around the disk, in complex coordinates
(docs/certificate.md, "Differentiable PSFs", "Any terms"). The absolute integrand is ``exp(h + l)``: h is -Im(phase),
and l is the logarithm of the absolute kernel. This mean is far below the maximum, because different terms have their
maxima at different points. The mean is a convex function of the position in the window: it is largest at a corner.

At a corner, let m and s^2 be the mean and the variance of h, weighted by ``exp(l)`` and the weight of the curve. m is
linear and s^2 quadratic in the coefficients of the wavefront; tables contain the coefficients of these two forms. Let
H be the maximum of h. Bennett's inequality is ``mean(e^h) <= e^m (1 + k s^2)`` with ``k = (e^x - 1 - x) / x^2`` at
``x = H - m``. On the curve h is a trigonometric polynomial of two angles: H is at most the largest sample times a
factor slightly above 1. Half of the angles suffice, because h has opposite signs at conjugate points.
"""

from __future__ import annotations

import math
from functools import reduce
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.special.legendre import gauss_legendre
from lommel.traced.namespaces import Namespace, Tables, Tensor

_MAX_LOGARITHM = 60.0  # exponentials of larger numbers are replaced by infinity
_ROUND_UP = 1.001  # factor that multiplies bounds, to cover rounding in float32


def exponential(ns: Namespace, logarithm: Tensor) -> Tensor:
    """Return an upper bound on ``exp(logarithm)``; inf above `_MAX_LOGARITHM`."""
    xp = ns.xp
    overflows = logarithm > _MAX_LOGARITHM
    bound = xp.exp(xp.where(overflows, xp.zeros_like(logarithm), logarithm)) * _ROUND_UP
    return xp.where(overflows, infinite(ns, bound), bound)


def of_intensity(ns: Namespace, intensity: Tensor, error: Tensor, unit: float) -> Tensor:
    """Return a bound (n,) on the error of the intensity (n, pixels); `error` (n,) bounds the error of the field."""
    largest = ns.xp.max(intensity, axis=-1)
    # (M + e)^2 - M^2 = 2 M e + e^2, plus 4 u M^2 for rounding of the squares and their sum.
    return (2.0 * ns.xp.sqrt(largest) + error) * error + 4.0 * unit * largest


def over_peak(ns: Namespace, values: Tensor, error: Tensor, stored: float, *, divided: bool) -> Tensor:
    """Return a bound on the error of values relative to their exact peak, shape (n,); inf instead of NaN.

    `stored` is the relative error of storing a value. `divided`: values are divided by their computed peak.
    """
    xp = ns.xp
    peak = xp.max(values, axis=-1)
    least_peak = peak - error  # lower bound on the exact peak
    ratio = error / xp.where(least_peak > 0.0, least_peak, xp.ones_like(peak))
    ratio = xp.where(least_peak > 0.0, ratio, infinite(ns, ratio))
    if divided:
        # Values divided by their own computed peak: 2 r / (1 - r) (docs/certificate.md, section 6).
        bounded = ratio < 0.5
        ratio = xp.where(bounded, ratio, xp.zeros_like(ratio))
        ratio = xp.where(bounded, 2.0 * ratio / (1.0 - ratio), infinite(ns, ratio))
    bound = (ratio + (1.0 + ratio) * stored) * _ROUND_UP
    # NaN is replaced by infinity, because comparisons with NaN are False.
    return xp.where(bound >= 0.0, bound, infinite(ns, bound))


def infinite(ns: Namespace, like: Tensor) -> Tensor:
    """Return an array of infinities, for unknown bounds, in the shape and type of `like`."""
    return ns.xp.full_like(like, float("inf"))


# Certificate, "Differentiable PSFs", "Any terms": for the degree d, samples in steps of pi / (5 d), and M. Riesz's
# bound on the ratio of the maximum to the largest sample.
_STEPS_PER_DEGREE = 5  # number of samples in half a turn, divided by the degree
_SAMPLE_FACTOR = 1.0 / math.cos(0.5 * math.pi / _STEPS_PER_DEGREE) ** 2
CURVES = np.geomspace(0.04, 1.6, 24)
"""Parameters b of the candidate curves: on a curve, the angle has the imaginary part b."""
_MAX_LOG_MEAN = 40.0  # largest logarithm of the means on usable curves
_LOG_ROUNDING = 0.05  # added to logarithms of bounds, for the rounding of exponentials
_MIN_X, _MAX_X = 0.5, 60.0  # range of x = H - m in Bennett's inequality: k loses digits below, and overflows above
_NUMPY = Namespace.of(None)


class Mean(NamedTuple):
    """Error bound of the sum over chords or of the sum over nodes, from the means on one curve for each disk.

    `disks` is the number of disks: an obscured aperture has two, the aperture and the obscuration. `corners` is the
    number of distinct corners of the window, `unit` is the unit roundoff.
    """

    disks: int
    corners: int
    unit: float

    def logarithm(self, ns: Namespace, tables: Tables, name: str, c: Tensor) -> Tensor:
        """Return a bound on the logarithm of the error of the sum `name`, "chords" or "nodes", shape (n,).

        `c` (n, terms) are the coefficients of the wavefronts, `tables` the tables of :func:`mean_on_curve`.
        """
        return reduce(ns.xp.logaddexp, (self._of_disk(ns, tables, f"{name} {k}", c) for k in range(self.disks)))

    def _of_disk(self, ns: Namespace, tables: Tables, name: str, c: Tensor) -> Tensor:
        """Return the logarithm of the bound for one disk."""
        xp, terms = ns.xp, c.shape[-1]
        c = xp.permute_dims(c, (1, 0))
        samples, forms = ns.matmul(tables[f"{name} samples"], c), ns.matmul(tables[f"{name} forms"], c)
        size = ns.matmul(tables[f"{name} size"], xp.abs(c))
        rounding = ((terms + 10) * (self.unit + ns.coarseness(self.unit)) + 1e-6) * size[0, ...]
        maximum = _SAMPLE_FACTOR * xp.max(xp.abs(samples), axis=0) + rounding  # H
        mean = forms[: self.corners, :] + rounding
        roots = xp.reshape(forms[self.corners :, :], (self.corners, terms, c.shape[-1]))
        deviation = xp.sqrt(xp.sum(roots * roots, axis=1)) + rounding
        # Bennett's inequality, x = H - mu (certificate, "Any terms").
        x, variance = maximum - mean + 2.0 * rounding, deviation * deviation
        # k = (e^x - 1 - x) / x^2 increases with x: with x increased to _MIN_X the bound holds, without cancellation.
        clipped = xp.where(x < _MIN_X, xp.full_like(x, _MIN_X), x)
        clipped = xp.where(x > _MAX_X, xp.full_like(x, _MAX_X), clipped)
        log_factor = xp.log1p(variance * ((xp.exp(clipped) - 1.0 - clipped) / (clipped * clipped)))
        log_factor = xp.where(x > _MAX_X, x + xp.log1p(variance), log_factor)
        return xp.max(mean + log_factor + tables[f"{name} constant"], axis=0)


def fewest(
    geometry: tuple[tuple[tuple[int, int], ...], float, tuple[Array, Array]],
    c: Array,
    disks: list[tuple[float, Array]],
    error: float,
    unit: float,
) -> tuple[int, int, Mean, Tables] | None:
    """Return the smallest numbers of chords and of nodes with an error of at most `error`, the bound and its tables.

    The error is that of all wavefronts whose coefficients, of any sign, are at most as large as those of a member,
    `c` (members, terms). Return None if no curve has a usable bound. `geometry` is (terms, stretch, window), see
    :func:`mean_on_curve`. `disks` are pairs of a radius and an array (2, curves), which is added to the logarithms of
    the bounds for chords (row 0) and nodes (row 1).
    """
    counts, best_tables, allowed = [0], Tables(), 0.5 * error
    for kind, name in enumerate(("chords", "nodes")):
        best = None
        for j, b in enumerate(CURVES.tolist()):
            # The exponential of the kernel would overflow for this b, and for all larger b.
            if max(np.abs(positions).max() for positions in geometry[2]) * math.sinh(b) > _MAX_X:
                break
            tables = Tables()
            for k, (radius, constants) in enumerate(disks):
                mean, disk_tables = mean_on_curve(*geometry, name, b, counts[-1], (k, radius))
                constant = f"{name} {k} constant"
                disk_tables[constant] = disk_tables[constant] + (float(constants[kind, j]) + _LOG_ROUNDING)
                tables |= disk_tables
            mean = mean._replace(disks=len(disks), unit=unit)
            # The bound increases with mu, sigma and H: absolute tables and coefficients bound it for all signs.
            largest = {key: t if "constant" in key else np.abs(_NUMPY.to_numpy(t)) for key, t in tables.items()}
            with np.errstate(over="ignore", invalid="ignore"):
                log_error = float(np.max(_NUMPY.to_numpy(mean.logarithm(_NUMPY, largest, name, np.abs(c)))))
            # The error is proportional to exp(-2 count b), where count is the number of chords or nodes.
            count = even((log_error - math.log(allowed)) / (2.0 * b)) if log_error < _MAX_LOG_MEAN else 0
            if count and (best is None or (count, log_error - 2.0 * count * b) < best[:2]):
                best = count, log_error - 2.0 * count * b, tables
                for k in range(len(disks)):
                    tables[f"{name} {k} constant"] = tables[f"{name} {k} constant"] - 2.0 * count * b
        if best is None:
            return None
        counts.append(best[0])
        best_tables |= best[2]
        allowed = error - math.exp(best[1])  # for the nodes: more than half, because the number of chords is even
    return counts[1], counts[2], mean, best_tables  # all curves, chords and nodes have the same `mean`


def even(needed: float) -> int:
    """Return `needed` rounded up to an even number, at least four."""
    # Numbers of chords and nodes are even: nodes at (+-x, +-y) are summed together (lommel.traced.chordal).
    return max(4, 2 * math.ceil(0.5 * needed))


def mean_on_curve(
    terms: tuple[tuple[int, int], ...],
    stretch: float,
    window: tuple[Array, Array],
    name: str,
    b: float,
    chords: int,
    disk: tuple[int, float] = (0, 1.0),
) -> tuple[Mean, Tables]:
    """Return the bound of one sum on the curve with the parameter b, without constant factors; and its tables.

    `name` is "chords" for the sum over chords, "nodes" for the sum over nodes of each chord. `stretch` multiplies the
    phases of the Zernike `terms` (n, m), `window` is (rows, columns) in v, and `disk` is the index and the radius of
    the disk. `chords`, the number of chords, is used for "nodes" only.
    """
    (y, x), radius = window, disk[1]
    degrees = np.array([n for n, _ in terms], dtype=np.float64)
    steps = _STEPS_PER_DEGREE * max(2, int(degrees.max()))
    angle = np.arange(steps + 1.0) * (math.pi / steps)
    points = [radius * coordinate for coordinate in _curve(name, b, angle, np.cos(angle), angle)]
    samples = stretch * polynomials(terms, *points).imag
    # For a corner at the distance R, the absolute kernel on the curve is exp(R sinh b cos a) with an angle a. Its
    # Fourier coefficients decrease like exp(-k^2 / (2 R sinh b)).
    exponent = radius * math.hypot(np.abs(x).max(), np.abs(y).max()) * math.sinh(b)
    count = int(degrees.max()) + 9 + math.ceil(3.75 * math.sqrt(exponent))
    angles = (np.arange(float(count)) + 0.5) * (math.pi / count)
    if name == "chords":
        eta, gauss = gauss_legendre(count, -1.0, 1.0)
        curve = _curve(name, b, angles, eta, angles)
        weights = ((np.sin(angles) ** 2 + math.sinh(b) ** 2) / (count * math.cosh(2.0 * b)))[:, None] * gauss
    else:
        phi = np.arange(1.0, chords + 1.0) * (math.pi / (chords + 1))
        curve = _curve(name, b, phi, angles, angles)
        weights = (2.0 * np.sin(phi) ** 2 / (chords + 1))[:, None] / count + 0.0 * angles
    points = [radius * coordinate for coordinate in curve]
    h = stretch * polynomials(terms, *points).imag
    # The second half of the curve follows from the first: h changes its sign at conjugate points.
    h, weights = np.concatenate([-h, h], axis=1), 0.5 * np.concatenate([weights.ravel(), weights.ravel()])
    constants, means, forms = [], [], []
    corners = sorted({(v, u) for v in (float(y.min()), float(y.max())) for u in (float(x.min()), float(x.max()))})
    for v, u in corners:
        log_kernel = u * points[0].imag + v * points[1].imag
        weight = weights * np.exp(np.concatenate([log_kernel, -log_kernel]))
        total = float(weight.sum())
        mean = h @ (weight / total)
        deviation = h - mean[:, None]
        # A variance is the sum of squares of forms @ c. Forms are the symmetric root of the covariance matrix, whose
        # elements off the diagonal are small: absolute values bound the variance closely for all signs of c.
        eigenvalues, vectors = np.linalg.eigh((deviation * (weight / total)) @ deviation.T)
        constants.append(math.log(total))
        means.append(mean)
        forms.append((vectors * np.sqrt(np.maximum(eigenvalues, 0.0))) @ vectors.T)
    disk_tables: Tables = {
        "samples": np.ascontiguousarray(samples.T),
        "forms": np.concatenate([np.stack(means), *forms]),
        "size": stretch * np.sinh(degrees * b)[None, :],
        "constant": np.array(constants)[:, None],
    }
    return Mean(1, len(corners), 0.0), {f"{name} {disk[0]} {part}": table for part, table in disk_tables.items()}


def _curve(name: str, b: float, first: Array, eta: Array, second: Array) -> tuple[Values, Values]:
    """Return the complex coordinates x and y of all points on a curve, flattened.

    For the `name` "chords" the angle of the chord is complex, ``first + i b``, and `eta` is the real position on the
    chord. For "nodes" the angle `first` of the chord is real, and the angle of the node is complex, ``second + i b``.
    """
    if name == "chords":
        px, py = np.cos(first + 1j * b)[:, None] + 0.0 * eta, np.sin(first + 1j * b)[:, None] * eta
    else:
        px, py = np.cos(first)[:, None] + 0.0j * second, np.sin(first)[:, None] * np.cos(second + 1j * b)
    return px.ravel(), py.ravel()


def polynomials(terms: tuple[tuple[int, int], ...], x: Values, y: Values) -> NDArray[np.complex128]:
    """Return Zernike terms with amplitude 1 at the edge, at complex points, shape ``(terms,) + x.shape``."""
    # rho^m exp(+-i m theta) = (x +- i y)^m, also for complex x and y.
    argument, plus, minus = 2.0 * (x * x + y * y) - 1.0, x + 1j * y, x - 1j * y
    values = []
    for n, m in terms:
        order = abs(m)
        azimuthal = 0.5 * (plus**order + minus**order) if m >= 0 else -0.5j * (plus**order - minus**order)
        values.append(scipy.special.eval_jacobi((n - order) // 2, 0.0, float(order), argument + 0j) * azimuthal)
    return np.stack(values)
