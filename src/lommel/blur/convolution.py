"""Convolution of sampled images with blur by FFT, with error bounds, and interpolation to pixels.

Positions are in v, angular frequencies w in radians per unit of v; the spectrum of the image ends at abs(w) = 2. The
lattice is the square grid of samples, with the step h. A gate G(w) is a smooth low-pass filter: 1 for abs(w) <= 2,
and 0 from 2 pi / h - 2 on, where the lattice would alias into abs(w) <= 2. T is the transfer function of the blur.

There are two kinds of kernels. Jitter, diffusion and motion (short blur) have a finite reach, outside which the
kernel is negligible: the response ``P(w) = sum_m (T G)(w + 2 pi m / h)`` multiplies the transform of the samples, and
the errors of wrap-around and truncation follow from the kernel outside the reach. Seeing has a wide halo, which falls
like r^(-11/3): its kernel is tabulated over the whole lattice, and the error is the light outside the lattice times
the kernel at that distance.

Pixels of any size and position are interpolated from the samples, along rows, then along columns. The gate along one
axis is a box from -m to m convolved with a Gaussian, and its transform is
``g(x) = sin(m x) / (pi x) exp(-(s x)^2 / 2)``. Therefore ``h sum_k g(x - k h) exp(i w k h) = exp(i w x)`` for
``abs(w) <= 2``, except for the error of the gate (Poisson's sum). Averaging g over a pixel yields pixel averages. The
error of truncating the sum is an exponential integral.

The kernel of seeing is ``c(r) = (1 / 2 pi) int T(w) G(w) J0(w r) w dw``. With ``w = u^3`` both ``w^(5/3)`` and von
Karman's structure function are entire in u: Gauss's rule from 0 converges geometrically.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.blur.blurs import Blur, Seeing
from lommel.core.engine import distinct_radii, product
from lommel.special.interpolation import filtered_taps
from lommel.special.legendre import gauss_legendre

if TYPE_CHECKING:
    from scipy.sparse import csr_array


class Readout(NamedTuple):
    """Interpolation along one axis, from samples to pixels."""

    matrix: csr_array  # (pixels, samples)
    first: int  # index of the first sample; sample 0 is on the axis
    error: float  # bound on the error for a wave exp(i w x) with abs(w) <= 2
    gain: float  # largest sum over a row of the absolute values of the matrix
    low: float  # lower edge of the first pixel, in v
    high: float  # upper edge of the last pixel, in v

    def ends(self, reach: float) -> tuple[float, float]:
        """Return the interval in v that contains the axis and all positions within `reach` of the pixels."""
        return min(self.low - reach, 0.0), max(self.high + reach, 0.0)

    @property
    def samples(self) -> int:
        """Number of samples."""
        return int(self.matrix.shape[1])


@lru_cache(maxsize=8)
def readout(places: tuple[float, ...], active: float, gate: Gate) -> Readout:
    """Return the weights for averages over `active` (v) around ascending `places` (v); for point values if 0."""
    centers = np.array(places)
    h, (truncation, cut_sum) = gate.h, ends(gate)
    # An odd number of taps, symmetric about the sample nearest to the centre of the pixel.
    taps = 2 * math.ceil((truncation + 0.5 * active) / h) + 1
    start = np.rint(centers / h).astype(np.int64) - taps // 2
    k = start[:, None] + np.arange(taps)
    weights = h * _averaged(centers[:, None] - h * k, active, gate)
    first = int(start.min())
    rows = np.repeat(np.arange(centers.size), taps)
    shape = centers.size, int(start.max()) + taps - first
    matrix = scipy.sparse.csr_array((weights.ravel(), (rows, (k - first).ravel())), shape=shape)
    low, high = float(centers.min()) - 0.5 * active, float(centers.max()) + 0.5 * active
    # Rounding of the weights and of sums of `taps` products: errors of random sign grow like sqrt(taps).
    rounding = 2.0**-50 * math.sqrt(taps)
    gain = float(np.abs(weights).sum(axis=1).max())
    return Readout(matrix, first, gate.error + cut_sum + rounding, gain, low, high)


@lru_cache(maxsize=16)
def ends(gate: Gate) -> tuple[float, float]:
    """Return a truncation distance in v, and a bound on h times the sum of abs(g) over the samples outside it."""
    # The sum of exp(-(s x)^2 / 2) / (pi x) outside this distance is about the error of the gate: E1(y) ~ exp(-y) / y.
    log_inverse_error = -math.log(gate.error)
    s = _gaussian_rate(gate)
    distance = math.sqrt(2.0 * (log_inverse_error - math.log(log_inverse_error + 1.0))) / s
    # The sum on each side is at most the integral that starts one step earlier; abs(g) <= exp(-(s x)^2 / 2) / (pi x).
    return distance + gate.h, float(scipy.special.exp1(0.5 * (s * distance) ** 2)) / math.pi


@lru_cache(maxsize=16)
def gained(gate: Gate) -> float:
    """Return a bound on h times the sum of abs(g) over all samples, for any position relative to the samples."""
    # 65 positions within one step; a margin of 2 % covers the positions between them.
    return 1.02 * readout(tuple(np.linspace(0.0, gate.h, 65)), 0.0, gate).gain


def _gaussian_rate(gate: Gate) -> float:
    """Return s of the factor exp(-(s x)^2 / 2) of g."""
    return gate.width / math.sqrt(2.0)


def _averaged(x: Array, active: float, gate: Gate) -> Array:
    """Return g averaged over an interval of width `active` around x."""
    if active == 0.0:
        return _gate_transform(x, gate)
    return np.asarray((_integral(x + 0.5 * active, gate) - _integral(x - 0.5 * active, gate)) / active)


def _integral(x: Array, gate: Gate) -> Array:
    """Return the integral of g from 0 to x."""
    # One Gauss node for every 2 radians of sin(m x), and 40 nodes for the Gaussian factor.
    limit = 9.0 / _gaussian_rate(gate)  # the Gaussian factor is below 1e-17 outside
    nodes, weights = gauss_legendre(math.ceil(0.5 * limit * gate.middle) + 40)
    flat = np.clip(x, -limit, limit).ravel()
    integral = np.empty(flat.size)
    # Blocks limit the memory of the outer product of positions and nodes.
    for start in range(0, flat.size, 2**14):
        part = flat[start : start + 2**14]
        integral[start : start + 2**14] = part * (_gate_transform(np.multiply.outer(part, nodes), gate) @ weights)
    return integral.reshape(x.shape)


def _gate_transform(x: Array, gate: Gate) -> Array:
    """Return g(x)."""
    rate = gate.middle / math.pi
    return np.asarray(rate * np.sinc(rate * x) * np.exp(-0.5 * (_gaussian_rate(gate) * x) ** 2))


_U = 2.0**-53  # unit roundoff of double precision


class Short(NamedTuple):
    """Blur of finite extent (jitter, diffusion, motion): Gaussian covariance in (x, y), and streaks (k, 2), in v."""

    covariance: Array
    streaks: Array

    @classmethod
    def of(cls, blurs: tuple[Blur, ...], scale: float) -> Short:
        """Return the total covariance and the streaks of several blurs; `scale` is one lambda*N in their unit."""
        to_v = math.pi / scale
        covariance = sum((blur.covariance for blur in blurs), np.zeros((2, 2)))
        streaks = [blur.streak for blur in blurs if blur.streak != (0.0, 0.0)]
        return cls(to_v**2 * covariance, to_v * np.array(streaks).reshape(-1, 2))

    @property
    def nothing(self) -> bool:
        """Whether the covariance is 0 and there are no streaks."""
        return not (self.covariance.any() or self.streaks.size)

    def reach(self, left: float) -> tuple[float, float]:
        """Return the distances along x and y that at most the fraction `left` of the light exceeds."""
        deviations = np.sqrt(np.diag(self.covariance))
        # Half of `left` for the tails of the Gaussian; a streak extends by half of its length to either side.
        quantile = math.sqrt(2.0) * float(scipy.special.erfcinv(min(0.5 * left, 1.0)))
        x, y = quantile * deviations + 0.5 * np.abs(self.streaks).sum(axis=0)
        return float(x), float(y)

    def response(self, x: Array, y: Array) -> Array:
        """Return the transfer function at w = (x, y)."""
        (xx, xy), (_, yy) = self.covariance
        transfer = np.exp(-0.5 * (xx * x * x + 2.0 * xy * x * y + yy * y * y))
        for dx, dy in self.streaks:
            # np.sinc(t) is sin(pi t) / (pi t), and w = 2 pi f.
            transfer *= np.sinc((dx * x + dy * y) / (2.0 * math.pi))
        return np.asarray(transfer)


class Spread(NamedTuple):
    """The response of blur on a lattice, shape (rows, columns // 2 + 1), with bounds on its errors."""

    response: NDArray[np.generic]
    size: tuple[int, ...]  # rows and columns of the padded lattice
    gain: float  # sum of the absolute values of the kernel
    norm: float  # square root of the sum of the squares of the kernel
    error: float  # bound on the error of the response for abs(w) <= 2
    missing: float  # bound on the kernel density, in v^-2, for light from outside the lattice
    off: float  # bound on the error of the kernel density, in v^-2
    core: float  # largest kernel density of a halo, in v^-2; 0 without halo
    outside_sum: float  # bound on the sum of the absolute values of the short kernel outside its reach

    def on(self, samples: Array, threads: int) -> Array:
        """Return the blurred samples, shape (n, rows, columns)."""
        workers = threads or -1
        blurred = np.empty(samples.shape)
        for image, target in zip(samples, blurred, strict=True):
            transform = scipy.fft.rfft2(image, self.size, workers=workers)
            transform *= self.response
            target[:] = scipy.fft.irfft2(transform, self.size, workers=workers)[: image.shape[0], : image.shape[1]]
        return blurred

    def rounding(self, samples: Array) -> float:
        """Return a bound on the rounding error of the transforms for any value of the blurred `samples`."""
        size = float(np.sqrt((samples**2).sum(axis=(1, 2)).max()))
        return 20.0 * math.log2(math.prod(self.size)) * _U * self.norm * size


def spread(short: Short, halo: Halo, least: tuple[int, int], margin: float, *, ended: bool) -> Spread:
    """Return the response on a lattice of at least `least` samples (rows, columns).

    `ended`: T is negligible for ``abs(w) > 2``. The lattice extends by `margin` (v) beyond the pixels if `ended`,
    otherwise beyond the samples that the pixels are interpolated from.
    """
    gate, has_seeing = halo.gate, bool(halo.several)
    # Lengths with small prime factors: transforms of other lengths take several times as long.
    size = tuple(scipy.fft.next_fast_len(side, real=True) for side in least)
    y = 2.0 * math.pi / gate.h * scipy.fft.fftfreq(size[0])[:, None]
    x = 2.0 * math.pi / gate.h * scipy.fft.rfftfreq(size[1])
    response: NDArray[np.generic] = np.ones((size[0], x.size))
    error = outside_sum = outside_density = density_error = core = 0.0
    gain = norm = 1.0
    if not short.nothing:
        response, error = _periodic(short, gate, x, y), 3.0 * gate.error
        # Twice: absolute sum of the short kernel outside its reach plus the truncation distance of the gate.
        outside_sum = 2.0 * gained(gate) * (gate.error * gained(gate) + 2.0 * ends(gate)[1])
        kernel = scipy.fft.irfft2(response, size)
        gain, norm = float(np.abs(kernel).sum()), float(np.sqrt((kernel**2).sum()))
    if has_seeing:
        # The table holds weights per sample, h^2 times the density in v^-2.
        tabulated, table_error = _kernel(halo, size)
        core = float(tabulated.max()) / gate.h**2
        # The short blur moves at most the fraction gate.error of the light farther than the reach of the blur.
        halo_density = halo.bound(margin) + (0.0 if short.nothing else gate.error * core)
        outside_density = halo_density if ended else gain * halo.gated_bound(margin) + outside_sum * core
        density_error = gain * table_error * core
        response = scipy.fft.rfft2(tabulated) * response
        kernel = scipy.fft.irfft2(response, size)
        error += gate.error
        gain, norm = float(np.abs(kernel).sum()), float(np.sqrt((kernel**2).sum()))
    return Spread(response, size, gain, norm, error, outside_density, density_error, core, outside_sum)


def _periodic(short: Short, gate: Gate, x: Array, y: Array) -> Array:
    """Return the response on the lattice: T G of the plane, G being a gate along each axis, with its copies."""
    # Sampling adds copies at multiples of 2 pi / h (Poisson). Only the nearest copies overlap nonzero gates.
    period = 2.0 * math.pi / gate.h
    response = np.zeros((y.size, x.size))
    for i in (-1.0, 0.0, 1.0):
        for j in (-1.0, 0.0, 1.0):
            wx, wy = x + i * period, y + j * period
            response += short.response(wx, wy) * _gated(wx, gate) * _gated(wy, gate)
    return response


def _gated(w: Array, gate: Gate) -> Array:
    erfc = scipy.special.erfc
    return np.asarray(0.5 * (erfc((w - gate.middle) / gate.width) - erfc((w + gate.middle) / gate.width)))


def _kernel(halo: Halo, size: tuple[int, ...]) -> tuple[Array, float]:
    """Return the kernel of a halo on a lattice, its centre at index (0, 0), and its error relative to its peak."""
    h, half = halo.gate.h, (size[0] // 2 + 1, size[1] // 2 + 1)
    # The error of the table is a tenth of the error of the gate, which is relative to 1, not to the peak of c.
    error = max(0.1 * halo.gate.error / float(halo.at(np.zeros(1))[0]), 1e-12)
    filtered, step, table_error = table(halo, h * math.hypot(*half), error)
    # By symmetry one octant contains all distances: it is computed once and mirrored to the whole lattice.
    squares, index = distinct_radii(half[0] - 1, half[1] - 1)
    quadrant = h * h * between(filtered, step, error, h * np.sqrt(squares))[index]
    # The kernel wraps around: index n - k is the distance k on the other side.
    rows, columns = (np.minimum(k := np.arange(n), n - k) for n in size)
    return quadrant[rows[:, None], columns], table_error


_BAND = 1.2  # step of a table in r times the largest w: phase of J0 between two entries, radians
_NODES, _PHASE = 40, 40.0  # Gauss nodes in a panel (an interval of u), and largest phase w r of J0 across it, radians
_NEGLIGIBLE = 1e-22  # value below which a transfer function counts as 0
_MAX_CACHED = 2**20  # largest number of cached values of J0


class Gate(NamedTuple):
    """A low-pass response: 1 up to ``w = 2`` and 0 from ``2 pi / h - 2`` on, each within `error`."""

    h: float  # step of samples, in v
    middle: float  # m: the response is 1/2 at w = m
    width: float  # scale of the error function, in w
    error: float

    @classmethod
    def of(cls, h: float, error: float) -> Gate:
        """Return the gate for samples with the step `h`, with the given `error`."""
        cutoff = 2.0 * math.pi / h - 2.0
        return cls(h, 0.5 * (2.0 + cutoff), 0.5 * (cutoff - 2.0) / float(scipy.special.erfcinv(0.5 * error)), error)

    def round(self, w: Array) -> Array:
        """Return a rotationally symmetric gate, a smooth function of w^2, at the modulus w of the frequency."""
        middle, half, fall = self._squared
        return np.asarray(0.5 * scipy.special.erfc((w * w - middle) / half * (fall / self.width)))

    @property
    def end(self) -> float:
        """Frequency w above which :meth:`round` is below 1e-30."""
        middle, half, fall = self._squared
        return math.sqrt(middle + 8.3 * half * self.width / fall)

    @property
    def _squared(self) -> tuple[float, float, float]:
        # Centre and half width of the transition in w^2, and its half width in w.
        cutoff = 2.0 * math.pi / self.h - 2.0
        return 0.5 * (4.0 + cutoff * cutoff), 0.5 * (cutoff * cutoff - 4.0), 0.5 * (cutoff - 2.0)


class Halo(NamedTuple):
    """Kernel of seeing, rotationally symmetric."""

    several: tuple[Seeing, ...]
    scale: float
    wavelength: float | None
    gate: Gate

    @classmethod
    def of(cls, blurs: tuple[Blur, ...], scale: float, wavelength: float | None, gate: Gate) -> Halo:
        """Return the kernel of all Seeing among several blurs, at one wavelength; `scale` is one lambda*N."""
        return cls(tuple(blur for blur in blurs if isinstance(blur, Seeing)), scale, wavelength, gate)

    def response(self, w: Array) -> Array:
        """Return the transfer function at w, without the gate."""
        transfer = np.ones(w.shape)
        for blur in self.several:
            transfer *= blur.transfer(w / (2.0 * self.scale), wavelength=self.wavelength)
        return transfer

    @property
    def finest(self) -> float:
        """Smallest interval of w over which the response varies."""
        smallest = 0.5
        for blur in self.several:
            outer = math.inf if blur.outer_scale is None else blur.outer_scale / (2.0 * math.pi * blur.r0)
            smallest = min(smallest, self.scale * blur.coherence(self.wavelength) * min(1.0, outer))
        return smallest

    def at(self, r: Array) -> Array:
        """Return the kernel at radii in v by quadrature, without a table."""
        w, weight = _rule(self, float(np.max(r, initial=1.0)))
        return _transformed(weight, w, r)

    def bound(self, radius: float) -> float:
        """Return a bound on the density b of image shifts (the kernel without gate) at radii above `radius`."""
        # b is a mixture of Gaussians and decreases with r. At the radius R, a Gaussian of variance t is at most
        # 1 / (1 - 2 s / R^2) times a Gaussian of variance t + s. The transform of T exp(-s w^2 / 2), times this
        # factor, therefore bounds b(R); the integrand is negligible above a small w.
        s = min(2.0, 0.02 * radius * radius)
        w, weight = _rule(self, radius, gated=False)
        soft = weight * np.exp(-0.5 * s * w * w)
        rounding = 2.0**-46 * float(np.abs(soft).sum())
        return (max(float(scipy.special.j0(radius * w) @ soft), 0.0) + rounding) / (1.0 - 2.0 * s / radius**2)

    def gated_bound(self, radius: float) -> float:
        """Return a bound on the absolute kernel, b convolved with the gate's transform, above `radius`."""
        inner_radius = radius - min(0.25 * radius, 45.0)
        gate_norm, gate_tail = _gate_norm(self.gate, radius - inner_radius)
        return gate_norm * self.bound(inner_radius) + gate_tail


@lru_cache(maxsize=8)
def _rule(halo: Halo, radius: float, *, gated: bool = True) -> tuple[Array, Array]:
    """Return nodes in w, and weights of ``(1 / 2 pi) T G w dw`` for waves up to this `radius`."""
    w, weight = _nodes(*_panels(halo, radius, gated=gated))
    weights = weight * halo.response(w)
    return w, weights * halo.gate.round(w) if gated else weights


def _panels(halo: Halo, radius: float, *, gated: bool = True) -> tuple[float, int]:
    """Return the upper limit of the rule in w and its number of panels, rounded to be the same for similar seeing."""
    end = halo.gate.end if gated else 11.0
    probe = np.linspace(0.0, end, 4097)
    negligible = np.flatnonzero(halo.response(probe) < _NEGLIGIBLE)
    end = min(end, 0.25 * math.ceil(4.0 * float(probe[negligible[0]]))) if negligible.size else end
    return end, 4 * math.ceil(0.25 * end / min(_PHASE / max(radius, 1.0), halo.finest))


@lru_cache(maxsize=8)
def _nodes(end: float, panels: int) -> tuple[Array, Array]:
    """Return nodes w up to `end`, and their weights, which include ``(1 / 2 pi) w dw``."""
    edges = np.cbrt(np.linspace(0.0, end, panels + 1))
    # The first panel is subdivided: the relative variation of w is largest in it.
    edges = np.concatenate([edges[:1], edges[1] * np.array([0.5, 0.75]), edges[1:]])
    x, weight = gauss_legendre(_NODES)
    widths = np.diff(edges)[:, None]
    u = (edges[:-1, None] + widths * x).ravel()
    return u**3, (widths * weight).ravel() * 3.0 * u**5 / (2.0 * math.pi)


@lru_cache(maxsize=4)
def _waves(end: float, panels: int, step: float, count: int) -> Array:
    """Return J0(w r) at `count` equally spaced r and all nodes w; cached for any seeing."""
    w, _ = _nodes(end, panels)
    return np.asarray(scipy.special.j0(np.multiply.outer(step * np.arange(float(count)), w)))


def _transformed(weight: Array, w: Array, r: Array) -> Array:
    values = np.empty(r.shape)
    block = max(1, 2**21 // w.size)
    for start in range(0, r.size, block):
        part = slice(start, start + block)
        values[part] = _weighted_sums(scipy.special.j0(np.multiply.outer(r[part], w)), weight)
    return values


def _weighted_sums(waves: Array, weight: Array) -> Array:
    # By the compiled core: for sums this short, the threads of BLAS spend most of the time waiting.
    return product(waves, weight[:, None], 1)[:, 0]


@lru_cache(maxsize=4)
def table(halo: Halo, radius: float, error: float) -> tuple[Array, float, float]:
    """Return (1) the kernel at equally spaced r, filtered for interpolation, (2) its step, (3) error / c(0)."""
    w, weight = _rule(halo, radius)
    step = _BAND / float(w.max())
    rule = filtered_taps(_BAND, error)
    padding = rule.filter.size - 1
    count = math.ceil(radius / step) + rule.taps.size + 1 + padding
    if count * w.size <= _MAX_CACHED:
        values = _weighted_sums(_waves(*_panels(halo, radius), step, count), weight)
    else:
        values = _transformed(weight, w, step * np.arange(float(count)))
    mirrored = np.concatenate([values[padding:0:-1], values])
    filtered = np.convolve(mirrored, np.concatenate([rule.filter[:0:-1], rule.filter]), "valid")
    return filtered, step, rule.error


def between(entries: Array, step: float, error: float, r: Array) -> Array:
    """Return the kernel at the radii `r`, interpolated in a :func:`table`."""
    taps = filtered_taps(_BAND, error).taps
    half = taps.size // 2
    mirrored = np.concatenate([entries[half:0:-1], entries])
    cell = np.minimum((r / step).astype(np.int64), entries.size - half - 1)
    values = np.zeros(r.shape)
    weights = taps.at((r / step - cell).ravel()).reshape(*r.shape, taps.size)
    for k in range(taps.size):
        values += weights[..., k] * mirrored[cell + k + 1]
    return values


@lru_cache(maxsize=16)
def _gate_norm(gate: Gate, radius: float) -> tuple[float, float]:
    """Return the integral of the absolute transform of a gate over the plane, and its maximum beyond a `radius`."""
    x, weight = gauss_legendre(400)
    w, weight = gate.end * x, gate.end * weight
    r: Array = np.linspace(0.0, 60.0, 4001)
    g = np.abs(_transformed(weight * w * gate.round(w) / (2.0 * math.pi), w, r))
    # The transform decreases faster than exponentially: the part beyond r = 60 is negligible.
    return 1.01 * float(2.0 * math.pi * np.trapezoid(g * r, r)), float(g[r >= min(radius, 45.0)].max())
