r"""Error bounds of the fields and images of traced plans, computed on the device of the field.

A field of error e with the largest modulus M in the window makes an intensity that is off by at most ``2 M e + e^2``,
over a peak that falls short of the computed one by at most as much: docs/certificate.md, section 6.

Of the chordal rule, the integrand off the disk is bounded by its mean on a curve. Terms do not reach their largest
values at one place, so the mean of ``|F| = exp(h + l)``, l that of the kernel, is far below its largest value. Over
the window it is convex, and largest at a corner. There, under the weight of the curve and ``exp(l)``, h has a mean m
and a variance s^2, a linear and a square form in the coefficients, whose tables are integrals. As ``(e^x - 1 - x) /
x^2`` rises with x and ``h <= H``, ``<e^h> <= e^m (1 + k s^2)``, k that of ``H - m``. On either curve h is a
trigonometric polynomial in two angles, so H is the largest of samples, a little widened. Conjugate points have
opposite h, so that half of the angles suffice.
"""

from __future__ import annotations

import math
from functools import reduce
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.special.legendre import gauss_legendre
from lommel.traced.namespaces import Namespace, Tables, Tensor

_MOST = 60.0  # largest logarithm that is exponentiated; larger ones count as infinite
_ROOM = 1.001  # room for rounding in float32


def exponential(ns: Namespace, logarithm: Tensor) -> Tensor:
    """Return e to a logarithm, rounded up; inf out of range."""
    xp = ns.xp
    big = logarithm > _MOST
    least = xp.exp(xp.where(big, xp.zeros_like(logarithm), logarithm)) * _ROOM
    return xp.where(big, infinite(ns, least), least)


def of_intensity(ns: Namespace, intensity: Tensor, error: Tensor, unit: float) -> Tensor:
    """Return a bound on the error of the squared modulus of a field, shape (n,)."""
    largest = ns.xp.max(intensity, axis=-1)
    # (M + e)^2 - M^2 = 2 M e + e^2, and 4 u M^2 for rounding of the squares and their sum.
    return (2.0 * ns.xp.sqrt(largest) + error) * error + 4.0 * unit * largest


def over_peak(ns: Namespace, values: Tensor, error: Tensor, stored: float, *, divided: bool) -> Tensor:
    """Return a bound on the error over the exact peak of stored values, or of values divided by it; never NaN."""
    xp = ns.xp
    peak = xp.max(values, axis=-1)
    room = peak - error
    ratio = error / xp.where(room > 0.0, room, xp.ones_like(peak))
    ratio = xp.where(room > 0.0, ratio, infinite(ns, ratio))
    if divided:
        # Values divided by their own computed peak: 2 r / (1 - r) (docs/certificate.md, section 6).
        small = ratio < 0.5
        ratio = xp.where(small, ratio, xp.zeros_like(ratio))
        ratio = xp.where(small, 2.0 * ratio / (1.0 - ratio), infinite(ns, ratio))
    bound = (ratio + (1.0 + ratio) * stored) * _ROOM
    # NaN compares as False.
    return xp.where(bound >= 0.0, bound, infinite(ns, bound))


def infinite(ns: Namespace, like: Tensor) -> Tensor:
    """Return infinities of an array's shape and type, where no bound is known."""
    return ns.xp.full_like(like, float("inf"))


# Certificate, "Differentiable PSFs", "Any terms": steps of pi / 5 d, and the widening that they take (M. Riesz).
_STEPS = 5  # of half a turn, for each degree
_WIDENED = 1.0 / math.cos(0.5 * math.pi / _STEPS) ** 2
CURVES = np.geomspace(0.04, 1.6, 24)
_MOST_OF_MEAN = 40.0  # largest logarithm of the means on usable curves
_ROUNDED = 0.05  # added to logarithms for the rounding of exponentials
_LEAST, _FAR = 0.5, 60.0  # least H - m that is used, and largest before its exponential overflows
_NUMPY = Namespace.of(None)


class Mean(NamedTuple):
    """The bound of one sum on a curve: numbers of disks and of corners of the window, and the unit roundoff."""

    disks: int
    corners: int
    unit: float

    def logarithm(self, ns: Namespace, tables: Tables, name: str, c: Tensor) -> Tensor:
        """Return a bound on the logarithm of the error of the sum, shape (n,)."""
        return reduce(ns.xp.logaddexp, (self._of_disk(ns, tables, f"{name} {k}", c) for k in range(self.disks)))

    def _of_disk(self, ns: Namespace, tables: Tables, name: str, c: Tensor) -> Tensor:
        xp, terms = ns.xp, c.shape[-1]
        c = xp.permute_dims(c, (1, 0))
        values, forms = ns.matmul(tables[f"{name} samples"], c), ns.matmul(tables[f"{name} forms"], c)
        size = ns.matmul(tables[f"{name} size"], xp.abs(c))
        lost = ((terms + 10) * (self.unit + ns.coarseness(self.unit)) + 1e-6) * size[0, ...]
        top = _WIDENED * xp.max(xp.abs(values), axis=0) + lost
        mean = forms[: self.corners, :] + lost
        square = xp.reshape(forms[self.corners :, :], (self.corners, terms, c.shape[-1]))
        spread = xp.sqrt(xp.sum(square * square, axis=1)) + lost
        # Bennett's inequality, x = H - mu (certificate, "Any terms").
        x, variance = top - mean + 2.0 * lost, spread * spread
        # (e^x - 1 - x) / x^2 rises with x: a larger x is safe, and a small one would cancel.
        near = xp.where(x < _LEAST, xp.full_like(x, _LEAST), x)
        near = xp.where(x > _FAR, xp.full_like(x, _FAR), near)
        tail = xp.log1p(variance * ((xp.exp(near) - 1.0 - near) / (near * near)))
        tail = xp.where(x > _FAR, x + xp.log1p(variance), tail)
        return xp.max(mean + tail + tables[f"{name} constant"], axis=0)


def fewest(
    where: tuple[tuple[tuple[int, int], ...], float, tuple[Array, Array]],
    c: Array,
    disks: list[tuple[float, Array]],
    error: float,
    unit: float,
) -> tuple[int, int, Mean, Tables] | None:
    """Return the fewest chords and nodes for an error of all members `c`, with their bound; None without a curve.

    `where` are terms, stretch and window, `disks` radii and the constants of the logarithms of both on the curves.
    """
    counts, every = [0], Tables()
    for kind, name in enumerate(("chords", "nodes")):
        found = None
        for j, b in enumerate(CURVES.tolist()):
            # The exponential of the kernel would overflow on this curve and all farther ones.
            if max(np.abs(places).max() for places in where[2]) * math.sinh(b) > _FAR:
                break
            tables = Tables()
            for k, (radius, constants) in enumerate(disks):
                mean, one = mean_on_curve(*where, name, b, counts[-1], (k, radius))
                one[f"{name} {k} constant"] = one[f"{name} {k} constant"] + (float(constants[kind, j]) + _ROUNDED)
                tables |= one
            mean = mean._replace(disks=len(disks), unit=unit)
            with np.errstate(over="ignore", invalid="ignore"):
                size = float(np.max(_NUMPY.to_numpy(mean.logarithm(_NUMPY, tables, name, c))))
            # The error goes with exp(-2 count b): solved for the count.
            count = even((size - math.log(error)) / (2.0 * b)) if size < _MOST_OF_MEAN else 0
            if count and (found is None or count < found[0]):
                for k in range(len(disks)):
                    tables[f"{name} {k} constant"] = tables[f"{name} {k} constant"] - 2.0 * count * b
                found = count, tables
        if found is None:
            return None
        counts.append(found[0])
        every |= found[1]
    return counts[1], counts[2], mean, every  # which is the same for all of them


def even(needed: float) -> int:
    """Return the next even number of chords or nodes, four or more."""
    # Even: images of nodes at (+-x, +-y) are folded (lommel.traced.chordal).
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
    """Return the bound of one sum on a curve b, over "chords" or over the "nodes" of each chord, and its tables.

    `window` is (rows, columns) in v, `disk` the number and the radius of the disk. Constants are left out.
    """
    (y, x), radius = window, disk[1]
    degrees = np.array([n for n, _ in terms], dtype=np.float64)
    steps = _STEPS * max(2, int(degrees.max()))
    angle = np.arange(steps + 1.0) * (math.pi / steps)
    at = [radius * places for places in _curve(name, b, angle, np.cos(angle), angle)]
    samples = stretch * polynomials(terms, *at).imag
    # The kernel is an exponential of R cos a, whose Fourier coefficients fall like exp(-k^2 / 2 R).
    # The kernel on the curve is at most exp(R sinh b).
    reach = radius * math.hypot(np.abs(x).max(), np.abs(y).max()) * math.sinh(b)
    count = int(degrees.max()) + 9 + math.ceil(3.75 * math.sqrt(reach))
    half = (np.arange(float(count)) + 0.5) * (math.pi / count)
    if name == "chords":
        eta, gauss = gauss_legendre(count, -1.0, 1.0)
        curve = _curve(name, b, half, eta, half)
        share = ((np.sin(half) ** 2 + math.sinh(b) ** 2) / (count * math.cosh(2.0 * b)))[:, None] * gauss
    else:
        phi = np.arange(1.0, chords + 1.0) * (math.pi / (chords + 1))
        curve = _curve(name, b, phi, half, half)
        share = (2.0 * np.sin(phi) ** 2 / (chords + 1))[:, None] / count + 0.0 * half
    at = [radius * places for places in curve]
    values = stretch * polynomials(terms, *at).imag
    values, share = np.concatenate([-values, values], axis=1), 0.5 * np.concatenate([share.ravel(), share.ravel()])
    constants, means, forms = [], [], []
    corners = sorted({(u, w) for u in (float(y.min()), float(y.max())) for w in (float(x.min()), float(x.max()))})
    for u, w in corners:
        lift = w * at[0].imag + u * at[1].imag
        weight = share * np.exp(np.concatenate([lift, -lift]))
        total = float(weight.sum())
        mean = values @ (weight / total)
        off = values - mean[:, None]
        # The variance as a sum of squares: one product with the coefficients on the device.
        size, vectors = np.linalg.eigh((off * (weight / total)) @ off.T)
        constants.append(math.log(total))
        means.append(mean)
        forms.append(np.sqrt(np.maximum(size, 0.0))[:, None] * vectors.T)
    of_disk: Tables = {
        "samples": np.ascontiguousarray(samples.T),
        "forms": np.concatenate([np.stack(means), *forms]),
        "size": stretch * np.sinh(degrees * b)[None, :],
        "constant": np.array(constants)[:, None],
    }
    return Mean(1, len(corners), 0.0), {f"{name} {disk[0]} {part}": table for part, table in of_disk.items()}


def _curve(name: str, b: float, first: Array, eta: Array, second: Array) -> tuple[Values, Values]:
    """Return flattened x and y on a curve: at angles `first` and, of chords, eta, or, of nodes, angles `second`."""
    if name == "chords":
        px, py = np.cos(first + 1j * b)[:, None] + 0.0 * eta, np.sin(first + 1j * b)[:, None] * eta
    else:
        px, py = np.cos(first)[:, None] + 0.0j * second, np.sin(first)[:, None] * np.cos(second + 1j * b)
    return px.ravel(), py.ravel()


def polynomials(terms: tuple[tuple[int, int], ...], x: Values, y: Values) -> NDArray[np.complex128]:
    """Return Zernike terms at complex points, shape ``(terms,) + x.shape``."""
    from scipy.special import eval_jacobi

    # rho^m exp(+-i m theta) = (x +- i y)^m at complex x and y.
    square, plus, minus = 2.0 * (x * x + y * y) - 1.0, x + 1j * y, x - 1j * y
    found = []
    for n, m in terms:
        order = abs(m)
        around = 0.5 * (plus**order + minus**order) if m >= 0 else -0.5j * (plus**order - minus**order)
        found.append(eval_jacobi((n - order) // 2, 0.0, float(order), square + 0j) * around)
    return np.stack(found)
