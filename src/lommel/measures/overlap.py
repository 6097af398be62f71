"""OTF as the autocorrelation of the pupil function P, an integral over the overlap of two shifted apertures.

With f in units of the cutoff frequency ``1 / (lambda N)`` and pupil coordinates in units of the aperture radius,

    OTF(f) = int P(rho - f) conj(P(rho + f)) d^2 rho / int abs(P)^2 d^2 rho .

Let u and y be the coordinates along and across f. The overlap of two discs extends over
``abs(u) <= cos(theta) - f`` at ``y = sin(theta)``. These limits are entire functions of theta, so that Gauss-Legendre
quadrature in theta and u converges spectrally. For annuli with an obscuration of radius eps, the range of y is split
at the heights at which circles of the two apertures intersect; for ``y < eps`` theta is defined by
``y = eps sin(theta)``.

Other apertures use quadrature rules with a proven error, and masks use sums over cells: docs/certificate.md,
section 18.

References
----------
H. H. Hopkins, "The frequency response of a defocused optical system", Proc. R. Soc. A 231, 91 (1955),
doi:10.1098/rspa.1955.0158. E. L. O'Neill, "Transfer function for an annular aperture", J. Opt. Soc. Am. 46, 285
(1956), doi:10.1364/JOSA.46.000285.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.base.cached import cached_property
from lommel.blur.transfer_integral import radial_product
from lommel.core.answers import ToleranceError
from lommel.methods.matrix_fourier import pupil_functions
from lommel.optics.aperture.mask import cell_centers
from lommel.optics.aperture.opening import Opening, degree_needed
from lommel.optics.aperture.shapes import Listed, listed
from lommel.optics.pupil import Pupil
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

# On each square cell of a mask the pupil function P_k is constant, with the wavefront at the centre of the cell. The
# overlap area of two cells is linear in each coordinate of their shift. The autocorrelation at any shift is therefore
# exactly the bilinear interpolation of ``A(d) = sum_k P_k conj(P_(k + d))`` between shifts d by whole cells.
#
# If the mask represents point samples instead of square cells, the image is one period of
# ``sum_d A(d) exp(2 pi i d.r / side)``. The Fourier coefficients of this image are also A(d).

_MAX_TABLE = 2048  # largest number of cells along a side for which A is tabulated at all shifts (270 MB)


class Cells:
    """Pupil function on the cells of a mask, normalised so that its autocorrelation is 1 at zero shift."""

    def __init__(self, field: NDArray[np.complex128]) -> None:
        self.field = field / np.linalg.norm(field)

    @cached_property
    def _table(self) -> NDArray[np.complex128]:
        # Zero padding to twice the side makes the correlation linear instead of circular.
        spectrum = scipy.fft.fft2(self.field, (2 * len(self.field), 2 * len(self.field)))
        return np.asarray(scipy.fft.ifft2(spectrum.real**2 + spectrum.imag**2).conj())

    def at(self, x_shift: NDArray[np.int64], y_shift: NDArray[np.int64]) -> NDArray[np.complex128]:
        """Return the autocorrelation at shifts by whole cells along columns and rows."""
        side = len(self.field)
        # At shifts by a whole side or more no cells overlap.
        x, y = (np.clip(shift, -side, side) for shift in (x_shift, y_shift))
        if side <= _MAX_TABLE:
            return np.asarray(self._table[y, x])
        # For a large mask each distinct shift is computed once, by a direct sum.
        shifts, index = np.unique(np.stack([x, y]), axis=1, return_inverse=True)
        return np.array([self._at_shift(*shift) for shift in shifts.T.tolist()])[index.reshape(-1)]

    def _at_shift(self, x: int, y: int) -> complex:
        """Return the autocorrelation at one shift, by a direct sum."""
        side = len(self.field)
        field, shifted = (
            self.field[max(b, 0) : side + min(b, 0), max(a, 0) : side + min(a, 0)] for a, b in ((x, y), (-x, -y))
        )
        return complex(np.einsum("yx,yx->", field.conj(), shifted))

    def between(self, shift: Array) -> NDArray[np.complex128]:
        """Return the autocorrelation at arbitrary shifts, shape (points, 2), in units of the side of a cell."""
        # Bilinear interpolation is exact (docs/certificate.md, "Masks").
        corner = np.floor(np.clip(shift, -len(self.field), len(self.field)))
        (x, y), (column, row) = (shift - corner).T, corner.T.astype(np.int64)
        x, y = (np.clip(part, 0.0, 1.0) for part in (x, y))
        value, next_value = ((1.0 - x) * self.at(column, j) + x * self.at(column + 1, j) for j in (row, row + 1))
        return np.asarray((1.0 - y) * value + y * next_value)

    def centroid(self, *, squares: bool) -> Array:
        """Return the centroid (x, y) of the image of square cells, or of one period for point samples, lambda*N."""
        side = len(self.field)
        # Square cells: derivative of the autocorrelation at 0. Point samples: integral of x times each wave, over one
        # period.
        d = np.arange(1, 2 if squares else side)
        weight = (np.ones(1) if squares else -((-1.0) ** d) * 2.0 / d) * (-0.5 * side / math.pi)
        # The light summed along y, which has the same centroid along x, depends on shifts along x only.
        zero = np.zeros_like(d)
        return np.array([weight @ self.at(d, zero).imag, weight @ self.at(zero, d).imag])


@lru_cache(maxsize=2)
def cells(pupil: Pupil) -> Cells:
    """Return the pupil function of a single pupil on the cells of its mask."""
    assert pupil.mask is not None
    side = pupil.mask.side
    (field,) = pupil_functions(pupil, cell_centers(side), 1.0 / side, "grey")
    return Cells(field)


def cells_of_stack(pupil: Pupil) -> list[Cells]:
    """Return :func:`cells` for each pupil of the flattened stack."""
    return [cells(pupil[index]) for index in np.ndindex(pupil.shape)] if pupil.shape else [cells(pupil)]


def mask_otf(pupil: Pupil, f: Array) -> NDArray[np.complex128]:
    """Return the OTF of a flattened stack of pupils with masks, at f (points, 2) in units of the cutoff frequency."""
    assert pupil.mask is not None
    return np.stack([single.between(pupil.mask.side * f) for single in cells_of_stack(pupil)])


_CHUNK = 2**20  # largest number of pupil values computed together, to limit the memory
_MAX_NODES = 4096  # largest number of nodes along a line


def autocorrelation(pupil: Pupil, f: Array, tol: float) -> NDArray[np.complex128]:
    """Return the OTF of a flattened stack to `tol`, at f (points, 2) in units of the cutoff frequency."""
    if pupil.mask is not None:
        return mask_otf(pupil, f)
    if pupil.circular and pupil.radial:
        # The OTF depends on the length of f only.
        canonical = np.stack([np.hypot(f[:, 0], f[:, 1]), np.zeros(len(f))], axis=-1)
        mirrored = np.zeros(len(f), dtype=bool)
    else:
        # Compute half of the plane only: images are real, so that OTF(-f) = conj(OTF(f)).
        mirrored = (f[:, 1] < 0) | ((f[:, 1] == 0) & (f[:, 0] < 0))
        canonical = np.where(mirrored[:, None], -f, f)
    # In lattices of frequencies many points have the same OTF: compute it once for each distinct point.
    points, index = np.unique(canonical, axis=0, return_inverse=True)
    shift = np.hypot(points[:, 0], points[:, 1])
    values = np.zeros((math.prod(pupil.shape), len(points)), dtype=np.complex128)
    # Up to `min_shift` the OTF is 1 up to rounding. It is not computed there, because quotients would overflow
    # and edges of shapes have rounding errors.
    min_shift = 1e-100 if pupil.circular else 1e-14
    values[:, shift <= min_shift] = 1.0
    indices = np.flatnonzero((shift > min_shift) & (shift < 1))
    if pupil.circular:
        blur = float(pupil.v(pupil.geometric_radius()).max())
        # Group frequencies of similar modulus, which need similar numbers of nodes.
        indices = indices[np.argsort(shift[indices])]
        for group in np.array_split(indices, math.ceil(len(indices) / 32)) if len(indices) else ():
            values[:, group] = _circular_otf(pupil, points[group], shift[group], blur, tol)
    else:
        parts = _clear_parts(pupil.opening)
        for k in indices:
            values[:, k] = _general_otf(pupil, parts, points[k], float(shift[k]), tol)
    values = values[:, index.reshape(-1)]
    return np.where(mirrored, values.conj(), values)


def _circular_otf(pupil: Pupil, f: Array, shift: Array, blur: float, tol: float) -> NDArray[np.complex128]:
    """Return the OTF of circular or annular apertures at a few frequencies."""
    # The number of nodes follows from an estimate of the phase change along a line of the overlap. If the estimate is
    # too low, _converged_integral() adds nodes.
    phase_change = 2.0 * blur * (1.0 - float(shift.min())) * min(1.0, 2.0 * float(shift.max()))
    nodes = 16 + math.ceil(0.25 * phase_change + 0.25 * pupil.illumination.slope)
    return _converged_integral(
        lambda nodes: _overlap_integral(pupil, f, shift, nodes), nodes, tol, tol + 1e-15 * blur
    )


def _converged_integral(
    integral: Callable[[int], NDArray[np.complex128]], nodes: int, tol: float, allowed: float
) -> NDArray[np.complex128]:
    """Return ``integral(nodes)``, with `nodes` increased until two successive values differ by at most `allowed`."""
    previous: NDArray[np.complex128] | None = None
    while nodes <= _MAX_NODES:
        value = integral(nodes)
        if previous is not None and np.abs(value - previous).max() <= allowed:
            return value
        previous, nodes = value, math.ceil(1.4 * nodes)
    raise ToleranceError(f"the OTF to tol={tol:g} needs more than {_MAX_NODES} nodes along a line")


def _overlap_integral(pupil: Pupil, f: Array, shift: Array, nodes: int) -> NDArray[np.complex128]:
    """Return the autocorrelation at f by `nodes` Gauss nodes along and across each part of the overlap."""
    x, w = gauss_legendre(nodes)
    frequency, y, low, width, weight = _lines(shift, pupil.obscuration, x, w)
    # For defocus alone the phase difference is linear in u, and integrals along u have a closed form.
    terms = pupil.radial_terms()
    if pupil.radial and pupil.illumination.uniform and not terms[:, 1:].any():
        lines = _defocused_lines(terms[:, :1] * shift[frequency], low, width) * weight
        return _sum_lines(lines, frequency, len(f)) / (math.pi * pupil.transmission)
    if pupil.radial and not pupil.obscuration and len(terms) > 1 and not np.ptp(terms[:, 1:], axis=0).any():
        return _defocused_stack(pupil, shift, x, w)
    if not pupil.radial:
        # Without radial symmetry the lines at -y are added, and all weights are halved.
        frequency, low, width, weight = (np.tile(part, 2) for part in (frequency, low, width, 0.5 * weight))
        y = np.concatenate([y, -y])
    otf = np.zeros((math.prod(pupil.shape), len(f)), dtype=np.complex128)
    block_size = max(1, _CHUNK // (len(otf) * nodes))
    for start in range(0, y.size, block_size):
        part = slice(start, start + block_size)
        index = frequency[part]
        u = low[part, None] + width[part, None] * x
        cos, sin = (f[index].T / shift[index])[:, :, None]
        px = u * cos - y[part, None] * sin
        py = u * sin + y[part, None] * cos
        fx, fy = f[index].T[:, :, None]
        if pupil.radial:
            product: Values = radial_product(pupil, (px - fx) ** 2 + (py - fy) ** 2, (px + fx) ** 2 + (py + fy) ** 2)
        else:
            product = pupil.values(px - fx, py - fy) * pupil.values(px + fx, py + fy).conj()
        np.add.at(otf.T, index, ((product @ w) * (width[part] * weight[part])).T)
    return otf / (math.pi * pupil.transmission)


def _defocused_stack(pupil: Pupil, shift: Array, x: Array, w: Array) -> NDArray[np.complex128]:
    """Return the autocorrelation of unobscured radial pupils that differ in defocus alone.

    At constant u the phase of the defocus is constant: the integral over y is the same for all pupils.
    """
    terms, f = pupil.radial_terms(), shift[:, None]
    # Where u = (1 - f) (1 - t^2), the limit of y has no root at the end of the overlap.
    u, width = (1.0 - f) * (1.0 - x**2), (1.0 - f) * 2.0 * x * w
    height = np.sqrt((1.0 - u - f) * (1.0 + u + f))
    s = (u - f)[..., None] ** 2 + (height[..., None] * x) ** 2
    t = s + (4.0 * u * f)[..., None]
    rest = np.concatenate([[0.0], terms[0, 1:]])
    phase = zernike.legendre_sum(rest, 2.0 * s - 1.0) - zernike.legendre_sum(rest, 2.0 * t - 1.0)
    light = 1.0 if pupil.illumination.uniform else pupil.illumination.at(s) * pupil.illumination.at(t)
    even, odd = ((light * wave(phase)) @ w * height * width for wave in (np.cos, np.sin))
    defocus = 8.0 * terms[:, :1, None] * (u * f)
    # The overlap is symmetric in u and y; the imaginary part, odd in u, integrates to 0.
    real = (np.cos(defocus) * even + np.sin(defocus) * odd).sum(axis=2)
    return np.asarray(4.0 * real / (math.pi * pupil.transmission), dtype=np.complex128)


def _defocused_lines(slope: Array, low: Array, width: Array) -> Array:
    """Return the integrals of ``cos(8 slope u)`` along lines from `low` to `low + width`, shape (n, lines)."""
    half_phase = 4.0 * slope * width + 1e-300  # avoids 0 / 0
    lines = np.cos(8.0 * slope * low + half_phase)
    lines *= np.sin(half_phase)
    lines /= half_phase
    lines *= width
    return lines


def _sum_lines(lines: Array, frequency: NDArray[np.intp], count: int) -> NDArray[np.complex128]:
    """Sum the integrals of lines for each frequency; `frequency` is the index (below `count`) for each line."""
    return np.array([np.bincount(frequency, values, count) for values in lines], dtype=np.complex128)


def _lines(shift: Array, eps: float, x: Array, w: Array) -> tuple[Values, ...]:
    """Return lines of constant y > 0 that cover the overlaps: frequency index, y, start in u, length, weight in y."""
    # Overlaps are symmetric in y, so that lines with y > 0 have twice the weight. Within each panel of y the ends of
    # the lines are analytic in theta.
    end = 2.0 * np.arcsin(np.sqrt(0.5 * (1.0 - shift)))  # arccos(shift), accurate near 1
    top = np.sqrt((1.0 - shift) * (1.0 + shift))
    panels = [_panel(np.arcsin(np.minimum(eps, top)), end, 1.0, shift, eps, x, w)]
    if eps > 0:
        # Angles theta, y = eps sin(theta), at which the rim of one aperture intersects the obscuration of the other
        # aperture, and at which both obscurations intersect.
        crossing = shift - (1.0 - eps**2) / (4.0 * shift)
        last = np.arcsin(np.minimum(1.0, top / eps))
        rim = np.arccos(np.minimum(1.0, np.abs(crossing) / eps))
        hole = np.arccos(np.minimum(1.0, shift / eps))
        edges = np.sort(np.minimum([np.zeros_like(last), rim, hole, last], last), axis=0)
        panels += [_panel(a, b, eps, shift, eps, x, w) for a, b in pairwise(edges)]
    frequency, y, low, width, weight = (np.concatenate(part) for part in zip(*panels, strict=True))
    nonempty = width * weight > 0
    frequency, y, low, width, weight = (part[nonempty] for part in (frequency, y, low, width, weight))
    return frequency, y, low, width, 2.0 * weight


def _panel(
    first: Array, last: Array, radius: float, shift: Array, eps: float, x: Array, w: Array
) -> tuple[Values, ...]:
    """Return lines, as :func:`_lines`, at ``y = radius sin(theta)`` with Gauss nodes theta from `first` to `last`."""
    theta = first[:, None] + (last - first)[:, None] * x
    y = radius * np.sin(theta)
    weight = (last - first)[:, None] * w * radius * np.cos(theta)
    f = shift[:, None]
    rim = np.sqrt((1.0 - y) * (1.0 + y))
    if radius == 1.0:  # above the obscurations each line is a single interval
        pieces = [(f - rim, rim - f)]
    else:
        hole = eps * np.cos(theta)
        right = [(f - rim, f - hole), (f + hole, f + rim)]
        left = [(-f - rim, -f - hole), (-f + hole, -f + rim)]
        # The overlap consists of intersections of the clear intervals of both apertures.
        pieces = [(np.maximum(a, c), np.minimum(b, d)) for a, b in right for c, d in left]
    frequency = np.broadcast_to(np.arange(shift.size)[:, None], y.shape).ravel()
    lines = (frequency, y.ravel(), weight.ravel())
    parts = [(*lines[:2], low.ravel(), np.maximum(high - low, 0.0).ravel(), lines[2]) for low, high in pieces]
    return tuple(np.concatenate(part) for part in zip(*parts, strict=True))


# All other apertures use the quadrature rules of lommel.core.engine.row_rule, with a proven error. The overlap lies
# in the ellipse with semi-axes ``1 - f`` along f and ``sqrt(1 - f^2)`` across f, which is mapped onto the unit disc.
# The difference of the two phases is a polynomial on this disc. degree_needed() computes from the amplitudes of its
# Zernike terms the degree up to which a rule must be exact. The ellipse shifted by f or -f lies in the disc of radius
# ``sqrt(1 + f (1 - f) / 2)``, on which the apodization is bounded. Each pair of overlapping segments has its own rule
# and its own phase difference.

_MIN_ERROR = 2e-15  # smallest error bound requested of a rule, several times the rounding error


class _ClearParts(NamedTuple):
    """Clear regions of an aperture (segments), their phases (constant, tilts), and a disc around each region."""

    regions: tuple[Listed, ...]
    phases: Array
    centers: Array
    radii: Array


@lru_cache(maxsize=8)
def _clear_parts(opening: Opening) -> _ClearParts:
    regions = tuple(listed(region) for region in opening.regions)
    if len(regions) == 1:
        return _ClearParts(regions, opening.phases, np.zeros((1, 2)), np.ones(1))
    edges = [np.concatenate(part.outline(256)) for part in opening.stop.shapes]  # type: ignore[union-attr]
    centers = np.array([0.5 * (edge.min(axis=0) + edge.max(axis=0)) for edge in edges])
    # Curved edges bulge between the 256 points of an outline by less than 1 % of the radius.
    radii = [1.01 * np.hypot(*(edge - center).T).max() for edge, center in zip(edges, centers, strict=True)]
    return _ClearParts(regions, opening.phases, centers, np.array(radii))


def _general_otf(pupil: Pupil, parts: _ClearParts, f: Array, shift: float, tol: float) -> NDArray[np.complex128]:
    """Return the OTF of an aperture of any shape at one frequency; its error is at most `tol` plus rounding."""
    axes = np.array([1.0 - shift, math.sqrt((1.0 - shift) * (1.0 + shift))])
    # `from_disc` maps the unit disc to the ellipse around the overlap, and `to_disc` is its inverse.
    cos, sin = f / shift
    from_disc = np.array([[cos, -sin], [sin, cos]]) * axes
    to_disc = np.array([[cos, sin], [-sin, cos]]) / axes[:, None]
    factor = float(axes[0] * axes[1]) / pupil.transmission
    # Segments can overlap only if their enclosing discs do.
    distances = np.hypot(*(parts.centers[:, None] - parts.centers + 2.0 * f).transpose(2, 0, 1))
    pairs = np.argwhere(distances < parts.radii[:, None] + parts.radii)
    first, second = parts.phases[pairs[:, 0]], parts.phases[pairs[:, 1]]
    tilts = first[:, 1:] - second[:, 1:]
    constants = first[:, 0] - second[:, 0] - (first[:, 1:] + second[:, 1:]) @ f
    # About half of the tolerance is for the polynomial approximation of the integrand, half for the rules.
    rule_tol = min(max(0.45 * tol / factor, _MIN_ERROR), 0.05)
    # A difference in tilt is linear in position, like the Fourier kernel: degree_needed() treats it as a distance v.
    steepest = float(np.hypot(*(tilts @ from_disc).T).max(initial=0.0))
    # Radius of the disc that contains the shifted ellipse: docs/certificate.md, section 18, "Transfer functions".
    rim = math.sqrt(1.0 + 0.5 * shift * (1.0 - shift))
    sizes = _amplitudes(pupil, from_disc, f)
    try:
        degree = degree_needed(sizes, steepest, pupil.illumination, rule_tol, power=2.0, radius=rim)
    except ValueError as fault:
        raise ToleranceError(f"the OTF to tol={tol:g} cannot be computed: {fault}") from None
    offset, total = to_disc @ f, np.zeros(math.prod(pupil.shape), dtype=np.complex128)
    mapped = {(i, sign): parts.regions[i].mapped(to_disc, sign * offset) for i, sign in _shifted_regions(pairs)}
    for (i, j), tilt, constant in zip(pairs, tilts, constants, strict=True):
        rule = (mapped[i, 1] & mapped[j, -1]).rule(degree, rule_tol / len(pairs))
        u, y, weight = rule.nodes
        block_size = max(1, _CHUNK // len(total))
        for start in range(0, u.size, block_size):
            part = slice(start, start + block_size)
            points = from_disc @ np.stack([u[part], y[part]])
            phase = _phase_difference(pupil, points, f) + (constant + tilt @ points)
            weights = weight[part]
            if not pupil.illumination.uniform:
                weights = weights * np.prod([pupil.illumination.at(r * r) for r in _radii(points, f)], axis=0)
            total += np.exp(1j * phase) @ weights
    return factor * total


def _shifted_regions(pairs: NDArray[np.intp]) -> set[tuple[int, int]]:
    """Return (region, sign) for each region that occurs in a pair, shifted by f (sign 1) or by -f (sign -1)."""
    return {(int(i), 1) for i in pairs[:, 0]} | {(int(j), -1) for j in pairs[:, 1]}


def _radii(points: Array, f: Array) -> list[Array]:
    """Return the distances of points from the axes of the two apertures, which are shifted by f and by -f."""
    return [np.hypot(points[0] - sign * f[0], points[1] - sign * f[1]) for sign in (1.0, -1.0)]


def _phase_difference(pupil: Pupil, points: Array, f: Array) -> Array:
    """Return ``Phi(rho - f) - Phi(rho + f)`` at points, shape (n, points)."""
    if not pupil.wavefront.terms:
        return np.zeros((math.prod(pupil.shape), points.shape[1]))
    radii = _radii(points, f)
    angles = [np.arctan2(points[1] - sign * f[1], points[0] - sign * f[0]) for sign in (1.0, -1.0)]
    phases = [pupil.wavefront.phase(rho, theta) for rho, theta in zip(radii, angles, strict=True)]
    return np.asarray((phases[0] - phases[1]).reshape(-1, points.shape[1]))


def _amplitudes(pupil: Pupil, from_disc: Array, f: Array) -> list[tuple[int, float]]:
    """Return (n, sum of the amplitudes of degree n) of the Zernike terms of the phase difference over the ellipse."""
    degree = max((n for n, _ in pupil.wavefront.amplitudes()), default=0) - 1  # the highest powers cancel
    if degree < 1:
        return []
    rho, theta, table = _projection(degree)
    points = np.stack([np.outer(rho, np.cos(theta)).ravel(), np.outer(rho, np.sin(theta)).ravel()])
    values = _phase_difference(pupil, from_disc @ points, f).reshape(-1, rho.size, theta.size)
    waves = np.fft.rfft(values, axis=2)[:, :, : degree + 1] / theta.size
    sizes = np.abs(np.einsum("mni,sim->snm", table, waves)).max(axis=0).sum(axis=1)
    # Amplitudes below 1e-15 of their sum are rounding errors.
    return [(n, float(size)) for n, size in enumerate(sizes) if n and size > 1e-15 * sizes.sum()]


@lru_cache(maxsize=8)
def _projection(degree: int) -> tuple[Values, Values, Values]:
    """Return the nodes (rho, theta) and weights [m, n, node] of integrals that compute Zernike coefficients."""
    t, weight = gauss_legendre(degree // 2 + 1, 0.0, 1.0)
    rho = np.sqrt(t)
    table = np.zeros((degree + 1, degree + 1, t.size))
    for m in range(degree + 1):
        for n in range(m, degree + 1, 2):
            table[m, n] = (n + 1) * (2.0 if m else 1.0) * weight * zernike.radial(n, m, rho)
    return np.asarray(rho), np.arange(2 * degree + 2) * (math.pi / (degree + 1)), table
