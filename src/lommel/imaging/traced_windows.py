"""PSF windows (squares of pixels): differentiable functions of the lens, and interpolation in layers of C_d."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import scipy

from lommel.base.arrays import Array, Values
from lommel.methods.pixel_rule import averaging_error
from lommel.optics.lens import Lens
from lommel.special import zernike
from lommel.special.chebyshev import chebyshev, chebyshev_nodes
from lommel.special.legendre import gauss_legendre
from lommel.traced.chordal import counts_by_largest
from lommel.traced.namespaces import Namespace, Operand, Tables, Tensor

_NODES = 16, 1.1  # number of Chebyshev nodes of a layer: a constant, plus a number per radian of width
_MAX_LAYERS = 512  # largest number of layers


class DefocusLayer(NamedTuple):
    """A range of C_d, radians, with windows and weights for interpolation in this range.

    Attributes
    ----------
    low, high : float
    nodes : ndarray, shape (rank,)
        C_d of the windows.
    weights : ndarray, shape (rank, degrees)
        Chebyshev coefficients of the weight of each window, a polynomial in C_d mapped to -1 at `low`, 1 at `high`.
    windows : ndarray, shape (rank, parts, cells)
        Values of the windows in pixels (cells); parts are channels, PSF sizes and aberrations with equal weights.
    """

    low: float
    high: float
    nodes: Array
    weights: Array
    windows: Array


def defocus_layers(
    windows: Callable[[Array], Array], low: float, high: float, tol: float, width: float, rate: float, max_values: int
) -> list[DefocusLayer]:
    """Return the layers of a range of C_d, each at most about `width` radians wide at the shortest wavelength.

    ``windows(c)`` returns the windows at values of C_d, shape (n, parts, cells), about `max_values` values in a call;
    all parts have the same weights. The error of a cell is at most about `tol` times the peak of the window. `rate`
    is (C_d at the shortest wavelength) / C_d. ValueError if too many layers are needed.
    """
    count = max(1, math.ceil(rate * (high - low) / width))
    edges = np.linspace(low, high, count + 1)
    ranges = list(zip(edges[-2::-1].tolist(), edges[:0:-1].tolist(), strict=True))
    batch = max(1, max_values // len(_nodes(*ranges[-1], rate)))
    layers: list[DefocusLayer] = []
    while ranges:
        batch_ranges = ranges[: -batch - 1 : -1]
        nodes = [_nodes(*ends, rate) for ends in batch_ranges]
        values = np.split(windows(np.concatenate(nodes)), np.cumsum([len(c) for c in nodes])[:-1])
        pairs = zip(nodes, values, strict=True)
        candidates = [_layer(*ends, *pair, tol) for ends, pair in zip(batch_ranges, pairs, strict=True)]
        converged = next((k for k, layer in enumerate(candidates) if layer is None), len(candidates))
        layers += [layer for layer in candidates[:converged] if layer is not None]
        del ranges[len(ranges) - converged :]
        if converged < len(candidates):
            # Halve the range: each half needs about half of the nodes.
            begin, end = ranges.pop()
            middle = 0.5 * (begin + end)
            ranges += [(middle, end), (begin, middle)]
            if len(layers) + len(ranges) > _MAX_LAYERS:
                raise ValueError(
                    f"distances span {high - low:.4g} rad of C_d and take more than {_MAX_LAYERS} layers; choose a "
                    "smaller range, or a larger tol"
                )
    return layers


def _nodes(low: float, high: float, rate: float) -> Array:
    """Return the C_d of the nodes of a layer."""
    x, _ = chebyshev_nodes(math.ceil(_NODES[0] + _NODES[1] * rate * (high - low)))
    return 0.5 * (low + high) + 0.5 * (high - low) * x


# A polynomial through the windows at Chebyshev nodes converges, because windows are entire functions of C_d, except
# for the division by their sums. Fewer windows span almost the same space. They are selected by a pivoted QR
# decomposition (interpolative decomposition: H. Cheng, Z. Gimbutas, P. G. Martinsson, V. Rokhlin, SIAM J. Sci.
# Comput. 26, 1389 (2005), doi:10.1137/030602678). Their C_d are known: they can be recomputed for another lens.
def _layer(low: float, high: float, nodes: Array, windows: Array, tol: float) -> DefocusLayer | None:
    """Return one layer from its windows at nodes, or None if its polynomial does not converge."""
    count = len(nodes)
    _, transform = chebyshev_nodes(count)
    scaled = (windows / windows.max(axis=2).min(axis=0)[:, None]).reshape(count, -1)  # relative to the lowest peak
    coefficients = transform @ scaled
    # Sum of the coefficients from each degree on: a bound on the truncation error.
    tail = np.cumsum(np.abs(coefficients).max(axis=1)[::-1])[::-1]
    if tail[-2] > 0.2 * tol:
        return None
    degrees = max(2, int((tail > 0.1 * tol).sum()))
    # The test points lie between the nodes, at the nodes and at the ends.
    polynomials = chebyshev(np.cos(np.linspace(0.0, math.pi, 2 * count + 1)), degrees)
    exact = polynomials @ coefficients[:degrees]
    columns = scaled
    if scaled.shape[1] > 4 * count:
        # Random linear combinations of the cells: to find pivots, a few times `rank` columns are enough.
        columns = scaled @ np.random.default_rng(0).standard_normal((scaled.shape[1], 4 * count))
    triangular, order = scipy.linalg.qr(columns.T, mode="r", pivoting=True)
    diagonal = np.abs(np.diagonal(triangular))
    for rank in range(max(1, int((diagonal > tol * diagonal[0]).sum())), count + 1):
        # Every window is approximated by a linear combination of the selected windows.
        combination = np.empty((count, rank))
        combination[order] = scipy.linalg.solve_triangular(triangular[:rank, :rank], triangular[:rank]).T
        weights = transform[:degrees] @ combination
        if np.abs(polynomials @ weights @ scaled[order[:rank]] - exact).max() <= 0.5 * tol:
            break
    selected = order[:rank]
    return DefocusLayer(low, high, nodes[selected], np.ascontiguousarray(weights.T), windows[selected])


Term = tuple[int, int]
_MAX_SAMPLES = 32  # largest number of samples along a side of a pixel
_MAX_CHORDS = 512  # largest number of chords of the pupil, and of nodes on a chord
_SHARES = (0.3, 0.4, 0.5, 0.6, 0.7, 0.85)  # fractions of the proven numbers of nodes, in the order tried


class AberratedWindows(NamedTuple):
    """Windows computed by the chordal rule (lommel.traced.chordal): settings without the tables.

    Attributes
    ----------
    side, samples : int
        Number of pixels along a side of a window, and of samples along a side of a pixel.
    chords, nodes : int
        Number of chords, and of nodes on each chord.
    lights : tuple of tuple of (float, float)
        For each channel, pairs (stretch, weight); stretch = (wavelength of the lens) / (wavelength of the light).
    """

    side: int
    samples: int
    chords: int
    nodes: int
    lights: tuple[tuple[tuple[float, float], ...], ...]

    def __call__(self, ns: Namespace, tables: Tables, c: Operand, coefficients: Operand, scale: Operand) -> Tensor:
        """Return windows of sum 1, shape (n, channels, side, side).

        Parameters
        ----------
        ns, tables
            Namespace, and tables of :func:`build_windows` in this namespace.
        c : array, shape (n,)
            C_d, radians at the wavelength of the lens.
        coefficients : array, shape (k,)
            Zernike coefficients, radians at the pupil edge and the wavelength of the lens.
        scale : array, shape ()
            (Size of the PSF) / (size of the PSF of the given lens).
        """
        xp = ns.xp
        # These are phases at the wavelength of the lens; all phases scale as 1 / wavelength.
        aberrations = ns.matmul(xp.reshape(coefficients, (1, -1)), tables["zernike"]) + tables["fixed"]
        phase = xp.reshape(c, (-1, 1)) * tables["focus"] + aberrations
        channels = []
        for channel in self.lights:
            total: Operand = 0.0
            for stretch, weight in channel:
                total = total + weight * self._light(
                    ns, tables, stretch * phase, tables["lattice"] * (stretch / scale)
                )
            channels.append(total / xp.sum(total, axis=(-2, -1), keepdims=True))
        return xp.stack(channels, axis=1)

    def _light(self, ns: Namespace, tables: Tables, phase: Tensor, lattice: Tensor) -> Tensor:
        """Return the mean intensity of each pixel, (n, side, side), for phases (n, chords * nodes)."""
        xp = ns.xp
        count, points = phase.shape[0], self.side * self.samples
        shape = (count, self.chords, self.nodes)
        waves = [
            xp.permute_dims(xp.reshape(f(phase) * tables["weights"], shape), (1, 0, 2)) for f in (xp.cos, xp.sin)
        ]
        # The kernel is a product of a factor along the chords and a factor across them: two matrix products.
        phase_along = xp.reshape(tables["y"], (self.chords, self.nodes, 1)) * lattice
        cos, sin = xp.cos(phase_along), xp.sin(phase_along)
        # Complex products as real matrices: [[cos, sin], [-sin, cos]] multiplies real and imaginary parts.
        kernel = xp.concat([xp.concat([cos, sin], axis=-1), xp.concat([-sin, cos], axis=-1)], axis=1)
        rows = ns.matmul(xp.concat(waves, axis=-1), kernel)
        real, imaginary = (xp.reshape(rows[..., part], (self.chords, count * points)) for part in _halves(points))
        phase_across = xp.reshape(lattice, (-1, 1)) * xp.reshape(tables["x"], (1, -1))
        cos, sin = xp.cos(phase_across), xp.sin(phase_across)
        kernel = xp.concat([xp.concat([cos, -sin], axis=-1), xp.concat([sin, cos], axis=-1)], axis=0)
        field = ns.matmul(kernel, xp.concat([real, imaginary], axis=0))
        real, imaginary = field[:points, ...], field[points:, ...]
        intensity = real * real + imaginary * imaginary
        intensity = xp.reshape(intensity, (self.side, self.samples, count, self.side, self.samples)) * tables["share"]
        return xp.permute_dims(xp.sum(intensity, axis=(1, 4)), (1, 2, 0))


def _halves(count: int) -> tuple[slice, slice]:
    return slice(0, count), slice(count, 2 * count)


def build_windows(
    lens: Lens,
    terms: dict[Term, float],
    defocus_range: tuple[float, float],
    spectra: tuple[tuple[tuple[float, float], ...], ...],
    window: tuple[int, float],
    tol: float,
) -> tuple[AberratedWindows, dict[str, Values]]:
    """Return windows and their tables, for coefficients up to the values of `terms`, and C_d in `defocus_range`.

    `window` is (half width in pixels, pixel pitch in v for the smallest scale and the wavelength of the lens).
    ValueError if too many samples or chords are needed.
    """
    half, step = window
    lights = tuple(tuple((lens.wavelength / w, weight) for w, weight in channel) for channel in spectra)
    max_stretch = max(stretch for channel in lights for stretch, _ in channel)
    illumination, obscuration = lens.illumination, lens.obscuration
    fixed = dict(zip(lens.aberrations.terms, np.ravel(lens.aberrations.edge).tolist(), strict=True))
    names = tuple(dict.fromkeys([(2, 0), *terms, *fixed]))
    bounds = [abs(fixed.get(t, 0.0)) + terms.get(t, 0.0) for t in names]
    bounds[0] += max(map(abs, defocus_range))  # the first term is (2, 0), defocus
    for samples in range(2, _MAX_SAMPLES + 1):
        # Error of Gauss's rule for |U|^2 over a pixel (certificate, "Differentiable PSFs"): |U|^2 is of exponential
        # type 2 in v, and the bound is the smallest over ellipses with semi-axes cosh b and sinh b.
        if averaging_error(max_stretch * step, samples) <= 0.1 * tol / (2.0 * sum(bounds) + 1.0):
            break
    else:
        raise ValueError(
            f"pixel must be smaller with zernike=, got {max_stretch * step:.3g} in v at the shortest wavelength"
        )
    extent = max_stretch * step * (half + 0.5)
    disks = [(1.0, illumination)] + ([(obscuration, illumination.scaled(obscuration))] if obscuration else [])
    error = tol / (2.0 * sum(bounds) + 1.0)
    chords, chord_nodes, _, _ = counts_by_largest(
        names, np.array([bounds]), max_stretch, disks, (math.sqrt(2.0) * extent, extent), error
    )
    if max(chords, chord_nodes) > _MAX_CHORDS:
        raise ValueError(
            f"aberrations and windows this large take {max(chords, chord_nodes)} chords, more than {_MAX_CHORDS}; "
            "choose a smaller range of distances or coefficients"
        )

    def build(fraction: float) -> tuple[AberratedWindows, dict[str, Values]]:
        counts = [math.ceil(fraction * count) for count in (samples, chords, chord_nodes)]
        nodes, shares = gauss_legendre(counts[0], -0.5, 0.5)
        angle = np.arange(1, counts[1] + 1) * (math.pi / (counts[1] + 1))
        eta, gauss = gauss_legendre(counts[2], -1.0, 1.0)
        x = np.concatenate([radius * np.cos(angle) for radius, _ in disks])
        y = np.concatenate([radius * np.sin(angle)[:, None] * eta for radius, _ in disks])
        # A central obscuration is a smaller disk with a negative sign and the area obscuration^2.
        signs = [1.0 if radius == 1.0 else -(radius**2) for radius, _ in disks]
        # Across the chords: Gauss's rule for the weight sqrt(1 - x^2), half of the length of a chord. The weights of
        # this rule are proportional to sin(angle)^2.
        weights = np.concatenate([sign * np.sin(angle)[:, None] ** 2 * gauss for sign in signs])
        rho, theta = np.hypot(x[:, None], y).ravel(), np.arctan2(y, x[:, None] + 0.0 * y).ravel()
        phase = sum((value * zernike.polynomial(n, m, rho, theta) for (n, m), value in fixed.items()), 0.0 * rho)
        tables: dict[str, Values] = {
            "zernike": np.stack([zernike.polynomial(n, m, rho, theta) for n, m in terms]),
            "focus": (2.0 * rho * rho - 1.0)[None],
            "fixed": phase[None],
            # Rounding may place a node outside rho = 1, where illumination is not defined.
            "weights": weights.ravel() * illumination.at(np.minimum(1.0, rho * rho)),
            "x": x,
            "y": y.ravel(),
            # The minus sign is the sign in the kernel exp(-i v.rho).
            "lattice": -step * (np.arange(-half, half + 1.0)[:, None] + nodes).ravel(),
            "share": shares[:, None, None, None] * shares,
        }
        return AberratedWindows(2 * half + 1, counts[0], len(x), counts[2], lights), tables

    # The proven numbers hold for any phase of this size. Fewer nodes may be enough: this is tested at extreme
    # coefficients with alternating signs.
    numpy, signs = Namespace.of(None), np.where(np.arange(len(terms)) % 2, -1.0, 1.0)
    extremes = np.array(defocus_range), signs * np.array(list(terms.values()))

    def compute(rule: tuple[AberratedWindows, dict[str, Operand]]) -> Array:
        return numpy.to_numpy(rule[0](numpy, rule[1], *extremes, np.float64(1.0)))

    proven = build(1.0)
    exact = compute(proven)
    for share in _SHARES:
        reduced = build(share)
        if (np.abs(compute(reduced) - exact).max(axis=(-2, -1)) / exact.max(axis=(-2, -1))).max() <= 0.1 * tol:
            return reduced
    return proven
