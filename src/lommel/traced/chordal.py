"""Fields of pupils as matrix products: any Zernike terms by the chordal rule, or radially symmetric pupils.

The chordal rule is a quadrature rule on parallel chords of the pupil, at ``x_i = cos(phi_i)``, with nodes on each
chord, at ``y = eta_k sin(phi_i)``. The kernel exp(-i v.r) is a product of a factor along the chord, for the rows of a
window, and a factor across the chords, for its columns. Section 8 of the certificate contains the error bounds of
the sums over chords and over nodes: ``log abs(F) <= sum W_p sinh(n_p b) + R sinh b``. F is the integrand on the curve
with the parameter b, W_p the amplitude of the terms of equal degree n_p and abs(m), and R the largest distance in the
window (v). The bound is linear in W_p, and therefore a matrix product, too. A central obscuration adds a second set
of chords, with negative weights.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple, cast

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.core.answers import ToleranceError
from lommel.core.engine import DiskStack, Window, chordal_sums, chordal_sums_gradient
from lommel.methods import hankel
from lommel.methods.derivative_names import Name, Term
from lommel.optics.aperture.apodization import Apodization
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre
from lommel.traced.certificate import CURVES, Mean, even, exponential, fewest, infinite
from lommel.traced.namespaces import Namespace, Operand, Tables, Tensor

# Phases at quadrature nodes, their cosines and sines, in float64 or in float32 with full accuracy (certificate,
# "Differentiable PSFs", "Rounding"). A phase of 100 rad in float32 would have an error of 6e-6. Therefore each
# coefficient c is split into ``c = n / s + r`` with an integer n and the scale s. Each term B, converted to turns
# (1 turn = 2 pi rad), is split into ``B / (2 pi s) = B_1 + B_2``, where B_1 is a multiple of ``2^-q``. The products
# ``n B_1`` are multiples of ``2^-q``, and their sum is below ``2^(23 - q)``: products, sum, and sum modulo 1 are
# exact. Only the remainder ``n B_2 + r B / 2 pi``, a small part of a turn, is rounded. For d terms, the unit roundoff
# u and a remainder of at most ``delta``, the error of the phase is at most ``u (2 pi (2 d + 4) delta + 6 pi (1/2 +
# delta))``. The derivative of n by c is 0, the derivative of r by c is 1: derivatives of phases are exact.

UNIT = {"float64": 2.0**-53, "float32": 2.0**-24}
"""Unit roundoff of each precision."""
_MAX_ADDED = 4  # up to this number of terms, products are added one by one (compilers fuse them), not by matmul


class PhaseRule(NamedTuple):
    """Scale s of split coefficients (0 in float64), and the error bound of phases.

    The error of a phase is at most ``relative * S + absolute``; ``S = sum abs(c_j) max abs(B_j)`` is up to `limit`.
    Phases of n pupils have the shape ``(nodes, n)`` if `pupils_last`, else ``(n, nodes)``.
    """

    scale: float
    relative: float
    absolute: float
    limit: float
    pupils_last: bool

    @property
    def tables(self) -> tuple[str, ...]:
        """Names of the tables with a value for each term and node."""
        if not self.scale:
            return ("basis",)
        return ("coarse", "rest") if self.pupils_last else ("coarse", "fine", "basis")

    def multiplied(self, terms: int) -> bool:
        """Return whether the phases of this number of terms are computed as matrix products."""
        return self.pupils_last or terms > _MAX_ADDED


def phase_tables(
    basis: Array, degree: int, largest: float, precision: str, *, pupils_last: bool = False
) -> tuple[PhaseRule, dict[str, Array]]:
    """Return the PhaseRule and the tables for terms of up to `degree`, whose values at nodes are `basis`.

    `basis` has the shape (terms, nodes). `largest` is the largest ``sum abs(c_j) max abs(B_j)`` in the valid range.
    """
    count, size = len(basis), np.abs(basis).max(axis=1)
    relative = UNIT["float64"] * (count + 2.0 * degree + 9.0)
    if precision == "float64":
        table = basis / math.tau
        tables = {"size": size, "basis": np.ascontiguousarray(table.T) if pupils_last else table}
        return PhaseRule(0.0, relative, 0.0, math.inf, pupils_last), tables
    # The rule remains valid for phases slightly above the largest phase.
    limit = 1.25 * largest + 1.0
    # float32 has 24 bits: sums below 2^(23 - q) of multiples of 2^-q are exact.
    q = 23 - math.ceil(math.log2(limit / math.tau))
    least = float(size[size > 0.0].min()) if size.any() else 1.0
    scale = 2.0 ** max(0, round(0.5 * (q - math.log2(limit / least))))
    turns = basis / (math.tau * scale)
    coarse = np.round(turns * 2.0**q) * 2.0**-q
    delta = scale * (limit / least) * 2.0 ** (-q - 1) + float(size.sum()) / (2.0 * math.tau * scale)
    unit = UNIT["float32"]
    absolute = unit * (math.tau * (2.0 * count + 4.0) * delta + 3.0 * math.tau * (0.5 + delta))
    rule = PhaseRule(scale, relative, absolute, limit, pupils_last)
    if pupils_last:
        low_parts = np.concatenate([turns - coarse, basis / math.tau]).T
        return rule, {"size": size, "coarse": np.ascontiguousarray(coarse.T), "rest": np.ascontiguousarray(low_parts)}
    return rule, {"size": size, "coarse": coarse, "fine": turns - coarse, "basis": basis / math.tau}


def phase_turns(ns: Namespace, rule: PhaseRule, tables: Tables, c: Tensor) -> tuple[Tensor, ...]:
    """Return phases in turns from coefficients ``(n, terms)``: one array, or an exact part and a remainder."""
    xp, dtype = ns.xp, tables[rule.tables[0]].dtype
    if not rule.scale:
        return (_phase_sum(ns, rule, xp.astype(c, dtype), tables["basis"]),)
    integers = xp.round(ns.stop(c) * rule.scale)
    remainder = xp.astype(c - integers * (1.0 / rule.scale), dtype)
    integers = xp.astype(integers, dtype)
    exact = _phase_sum(ns, rule, integers, tables["coarse"])
    if rule.pupils_last:
        return exact, _phase_sum(ns, rule, xp.concat([integers, remainder], axis=-1), tables["rest"])
    return exact, _phase_sum(ns, rule, integers, tables["fine"]) + _phase_sum(ns, rule, remainder, tables["basis"])


def _phase_sum(ns: Namespace, rule: PhaseRule, c: Tensor, table: Tensor) -> Tensor:
    if rule.pupils_last:
        return ns.matmul(table, ns.xp.permute_dims(c, (1, 0)))
    if rule.multiplied(table.shape[0]):
        return ns.matmul(c, table)
    total = c[..., 0:1] * table[0, ...]
    for j in range(1, table.shape[0]):
        total = total + c[..., j : j + 1] * table[j, ...]
    return total


# On CPUs the cosine of JAX is slow, because it reduces arguments one by one. For phases t in turns, the removal of
# whole turns is exact, and then ``cos 2 pi t = sin 2 pi z`` with ``z = 1/4 - abs(t)``. For abs(z) <= 1/4, n terms of
# the series of the sine have an error below the next term, ``(pi / 2)^(2n+1) / (2n+1)!``. The sine of the phase is
# the cosine at ``t - 1/4``. The errors of cosine and sine are at most 5 u, plus the error due to rounding of
# ``t - 1/4``, which is not larger than the error due to rounding of ``2 pi t`` in other frameworks.

_SINE_TERMS = {"float32": 7, "float64": 11}  # number of terms of the series
_TURN = Fraction("6.28318530717958647692528676655900576839433879875")  # 2 pi


def waves(ns: Namespace, turns: tuple[Tensor, ...]) -> tuple[Tensor, Tensor]:
    """Return cosine and sine of phases from :func:`phase_turns`."""
    if ns.name == "jax":
        return ns.call_unfused(_waves_of_jax(), *turns)
    total = turns[0]
    if len(turns) > 1:
        # Whole turns are removed before the remainder is added: the sum is then rounded less.
        total = (total - ns.xp.round(total)) + turns[1]
    angle = total * math.tau
    return ns.xp.cos(angle), ns.xp.sin(angle)


@cache
def sine_coefficients(kind: str) -> tuple[float, ...]:
    """Return the coefficients of ``sin(2 pi z) / z`` in powers of ``z^2`` for the data type `kind`."""
    return tuple(
        float((-1) ** k * _TURN ** (2 * k + 1) / math.factorial(2 * k + 1)) for k in range(_SINE_TERMS[kind])
    )


@cache
def _waves_of_jax() -> Callable[..., tuple[Tensor, Tensor]]:
    import jax
    from jax import lax

    def remove_whole_turns(turns: Operand) -> Operand:
        return turns - lax.round(turns, lax.RoundingMethod.TO_NEAREST_EVEN)

    def cosine(turns: Operand) -> Operand:
        z = 0.25 - lax.abs(remove_whole_turns(turns))
        square = z * z
        total: Operand
        *lower, total = sine_coefficients(str(turns.dtype))
        for coefficient in reversed(lower):
            total = total * square + coefficient
        return z * total

    @jax.custom_jvp
    def cosine_sine(turns: Operand) -> tuple[Tensor, Tensor]:
        return cosine(turns), cosine(turns - 0.25)

    @cosine_sine.defjvp
    def derivative(primals: Operand, tangents: Operand) -> tuple[tuple[Tensor, Tensor], tuple[Tensor, Tensor]]:
        cos, sin = cosine_sine(*primals)
        angle_tangent = tangents[0] * math.tau
        return (cos, sin), (-sin * angle_tangent, cos * angle_tangent)

    def of_sum(exact: Operand, *remainder: Operand) -> tuple[Tensor, Tensor]:
        return cosine_sine(remove_whole_turns(exact) + remainder[0] if remainder else exact)

    return of_sum


class FieldError(NamedTuple):
    """Error bound of a field, without the error of quadrature.

    Attributes
    ----------
    unit : float
        Unit roundoff of the sums.
    sums : float
        Largest sum over nodes of the absolute factors that multiply cosines and sines.
    added : float
        Error due to rounding of sums, cosines, sines and tables, plus the error of omitted phases and amplitudes.
    products : float
        Number of roundings of operands in matrix products, for reduced precision such as TF32.
    """

    unit: float
    sums: float
    added: float
    products: float

    def total(
        self, ns: Namespace, rule: PhaseRule, tables: Tables, c: Tensor, quadrature_error: Tensor | float
    ) -> Tensor:
        """Return a bound on the error of the field; inf if a phase may exceed the limit of the phase rule."""
        xp = ns.xp
        operand_unit = ns.coarseness(self.unit)
        # The factor 1 + 1e-5 covers the rounding of this sum.
        size = xp.sum(xp.abs(c) * tables["size"], axis=-1) * (1.0 + 1e-5)
        # TF32 rounds each of the two operands of a product by 2^-11.
        relative = rule.relative + (2.5 * operand_unit if rule.multiplied(c.shape[-1]) else 0.0)
        error = quadrature_error + self.sums * (relative * size + rule.absolute + self.products * operand_unit)
        return xp.where(size <= rule.limit, error + self.added, infinite(ns, error))


_ETA = np.geomspace(2e-3, 4.0, 80)  # parameters eta of candidate Bernstein ellipses: semi-axes cosh(eta), sinh(eta)
_CHOSEN = 4  # number of ellipses used on the device: the best ellipse of the stack, and ellipses around it
_MAX_RADIAL_NODES = 4096  # largest number of nodes along the radius


# The field of a radially symmetric pupil, ``U(v) = int A exp(i Phi) J0(v sqrt t) dt`` over ``[eps^2, 1]`` in
# t = rho^2, is a matrix product by the Gauss-Legendre rule: cosines and sines of the phases at K nodes are multiplied
# by the table ``w_k A_k J0(v_r sqrt t_k)``. The number of nodes, and the error bound of each pupil, are computed from
# the integrand on Bernstein ellipses (lommel.methods.hankel).


class Radial(NamedTuple):
    """Field of a radially symmetric pupil at one wavelength; methods require its tables.

    The quadrature error follows from samples of the imaginary phase at `points` points on each of `curves` ellipses.
    If `curved` is 0, the largest sample is multiplied by `widening`. Otherwise the larger of two neighbouring samples
    is increased by `curved` times the largest sample.
    """

    phase: PhaseRule
    error: FieldError
    curves: int
    points: int
    widening: float
    curved: float

    def intensity(self, ns: Namespace, tables: Tables, c: Tensor) -> tuple[Tensor, Tensor]:
        """Return I at the radii of the table, shape ``(n, radii)``, and a bound on the error of the field."""
        cos, sin = waves(ns, phase_turns(ns, self.phase, tables, c))
        real, imaginary = ns.matmul(cos, tables["table"]), ns.matmul(sin, tables["table"])
        fixed_c = ns.stop(ns.xp.astype(c, tables["table"].dtype))
        error = self.error.total(ns, self.phase, tables, fixed_c, self._quadrature_error(ns, tables, fixed_c))
        return real * real + imaginary * imaginary, error

    def _quadrature_error(self, ns: Namespace, tables: Tables, c: Tensor) -> Tensor:
        """Return a bound on the error of quadrature along the radius, shape (n,)."""
        xp, unit = ns.xp, self.error.unit
        phase = xp.abs(ns.matmul(c, tables["imaginary"]))
        phase = xp.reshape(phase, (phase.shape[0], self.curves, self.points))
        if self.curved:
            pairs = xp.maximum(phase[..., 1:], phase[..., :-1]) + tables["kernel"]
            largest = xp.max(pairs, axis=-1) + self.curved * xp.max(phase, axis=-1)
        else:
            largest = xp.max(phase + tables["kernel"], axis=-1) * self.widening
        # Error due to rounding of the product for `phase`, and of the sums of logarithms.
        rounding = (c.shape[-1] + 8) * (unit + ns.coarseness(unit)) * ns.matmul(xp.abs(c), tables["most"])
        return exponential(ns, xp.min(largest + rounding + tables["constant"], axis=-1))


def columns(pupil: Pupil) -> tuple[tuple[Name, ...], Array]:
    """Return the names of the coefficients (powers of rho, or terms (n, m)), and their values (pupils, names)."""
    wavefront = pupil.wavefront
    if wavefront._powers is None or not pupil.radial:
        return wavefront.terms, wavefront.edge.reshape(-1, len(wavefront.terms))
    # Defocus is c (2 t - 1): c is half of the coefficient of t. The constant phase -c does not change images.
    powers = pupil.coefficients() * np.where(np.arange(wavefront.symmetric) == 0, 0.5, 1.0)
    return ("defocus", "spherical", *(f"rho^{2 * k + 2}" for k in range(2, wavefront.symmetric))), powers


def _basis(powers: bool, count: int, t: Values) -> Values:
    """Return powers of t plus constants, or Legendre polynomials, at real or complex t, ``(count,) + t.shape``."""
    if powers:
        return np.stack([2.0 * t - 1.0, *(t ** (k + 1) - 0.5 for k in range(1, count))])
    return np.moveaxis(np.polynomial.legendre.legvander(2.0 * t - 1.0, count)[..., 1:], -1, 0)


def make_radial(
    pupil: Pupil, stretch: float, v: Array, error: float, precision: str
) -> tuple[Radial, dict[str, Array]]:
    """Return the field at the radii v, with a quadrature error of at most `error`, and its tables.

    The error bound holds for all pupils in the box of a stack: each coefficient is between its extremes in the stack.
    `stretch` is (wavelength of the pupil) / (wavelength of the field). Raise ToleranceError for too many nodes.
    """
    low, light = pupil.obscuration**2, pupil.illumination
    terms, c = columns(pupil)
    c = c[:, [j for j, term in enumerate(terms) if isinstance(term, str) or term[1] == 0]]
    middle, half_range = 0.5 * (c.max(axis=0) + c.min(axis=0)), 0.5 * (c.max(axis=0) - c.min(axis=0))
    powers, degree, v_max = isinstance(terms[0], str), c.shape[1], float(v.max(initial=0.0))
    steps = max(32, 16 * degree) if low == 0.0 else max(64, 24 * degree)
    imaginary = stretch * _basis(powers, degree, hankel.ellipses(_ETA, low, steps)).imag
    kernel = v_max * hankel.rise(_ETA, low, steps)
    # Largest absolute imaginary phase in the box of the stack; phases are linear in the coefficients.
    size = np.abs(np.tensordot(middle, imaginary, 1)) + np.tensordot(half_range, np.abs(imaginary), 1)
    constant = light.growth(np.cosh(_ETA), low) + math.log(32.0 / 15.0 * (1.0 - low)) - np.log(-np.expm1(-2.0 * _ETA))
    node_counts = (hankel.between(size, kernel, degree, low) + constant - math.log(error)) / (2.0 * _ETA)
    best_ellipse, nodes = int(node_counts.argmin()), max(1, math.ceil(float(node_counts.min())))
    if nodes > _MAX_RADIAL_NODES:
        raise ToleranceError(f"phases and windows this large take {nodes} nodes, more than {_MAX_RADIAL_NODES}")
    # The best ellipse of a single pupil may be smaller or larger than the best ellipse of the stack.
    chosen = np.unique([best_ellipse, *np.clip(best_ellipse + np.arange(_CHOSEN) * 5 - 10, 0, len(_ETA) - 1)])
    # Bound by Ehlich and Zeller on maximum / (largest sample), as in lommel.methods.hankel.
    widening = 1.0 / math.cos(0.5 * degree * math.pi / steps)
    curved = 0.0 if low == 0.0 else (degree * math.pi / steps) ** 2 / 8.0 * widening
    t, weights = gauss_legendre(nodes, low, 1.0)
    table = (weights * light.at(t))[:, None] * scipy.special.j0(np.sqrt(t)[:, None] * v)
    basis = stretch * _basis(powers, degree, t)
    largest = float(np.abs(c).max(axis=0, initial=0.0) @ np.abs(basis).max(axis=1))
    phase, tables = phase_tables(basis, degree, largest, precision)
    unit, sums = UNIT[precision], float(np.abs(table).sum(axis=0).max())
    # Rounding of sums, cosines, sines and products: (K + 16) u (certificate, "Differentiable PSFs", "Rounding"). Then
    # weights, amplitude and J0(x), whose argument has a relative error of 3.5 u: x abs(J1(x)) < 0.83 sqrt(x).
    added = sums * (nodes + 16.0) * unit
    added += UNIT["float64"] * (12.0 + 3.0 * math.sqrt(v_max) + (3.0 * light.slope)) * float(weights @ light.at(t))
    omitted_phase, omitted_light = pupil.left_out
    added += (stretch * omitted_phase + 2.0 * omitted_light) * float(weights @ light.at(t))
    tables |= {
        "table": table,
        "imaginary": imaginary[:, chosen].reshape(degree, -1),
        "most": np.abs(imaginary[:, chosen]).max(axis=-1),
        "kernel": kernel[chosen],
        "constant": constant[chosen] - 2.0 * nodes * _ETA[chosen],
    }
    field_error = FieldError(unit, sums, added, 4.0)
    return Radial(phase, field_error, len(chosen), steps + 1, widening, curved), tables


# The values exp(i Phi) at the mirror images (+-x, +-y) of a node are split into parts that are even or odd in x and
# in y. For these parts the kernel is real: a cosine or sine of v_x x times a cosine or sine of v_y y. At the mirror
# images of a pixel the kernel differs only in sign. Pupils are the last axis: products of long rows are fast.

IMAGES = ((1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0))
"""Signs of x and y at the four mirror images of a node."""


class Axis(NamedTuple):
    """Positions of a window along one axis; for a symmetric window only positions >= 0 are stored.

    Attributes
    ----------
    first : int
        Index of the first stored position with a mirror image: 1 if the position 0 is stored, else 0.
    negative, positive : int
        Number of positions below 0, and number of the other positions. If the window is not symmetric, all positions
        are stored, and `negative` is 0.
    """

    first: int
    negative: int
    positive: int

    def unfold(self, ns: Namespace, mirrored: Tensor, stored: Tensor, axis: int) -> Tensor:
        """Return values at all positions along `axis`, from values at `mirrored` and at `stored` positions."""
        index = [slice(None)] * 3
        index[axis] = slice(0, self.positive)
        stored = stored[tuple(index)]
        if not self.negative:
            return stored
        index[axis] = slice(self.first, self.first + self.negative)
        return ns.xp.concat([ns.flip(mirrored[tuple(index)], axis), stored], axis=axis)


def axis_of(v: Array) -> tuple[Axis, Array]:
    """Return the Axis for the increasing positions `v`, and the stored positions."""
    # For a window that is symmetric about the optical axis, only positions >= 0 are stored.
    distances = np.unique(np.abs(v))
    first, negative = int(distances[0] == 0.0), int(np.sum(v < 0.0))
    positive = len(v) - negative
    if np.array_equal(v, np.concatenate([-distances[first : first + negative][::-1], distances[:positive]])):
        return Axis(first, negative, positive), distances
    return Axis(0, 0, len(v)), v


def folded_tables(x: Array, y: Array, weights: Array, columns: Array, rows: Array) -> dict[str, Array]:
    """Return the real kernels for chords at x and nodes at y ``(chords, nodes)``, multiplied by `weights`."""
    row_phase, column_phase = rows[:, None] * y[:, None, :], columns[:, None] * x
    return {
        "along even": np.cos(row_phase) * weights[:, None, :],
        "along odd": np.sin(row_phase) * weights[:, None, :],
        "across even": np.cos(column_phase),
        "across odd": np.sin(column_phase),
    }


def folded_intensity(
    ns: Namespace, kernels: Tables, waves: list[tuple[Tensor, Tensor]], axes: tuple[Axis, Axis]
) -> Tensor:
    """Return the squared absolute field, shape ``(n, columns * rows)``, column by column.

    `waves` are cosine and sine of the phase at each of :data:`IMAGES`, ``(nodes, n)``; `axes` are the Axis of the
    columns and the Axis of the rows.
    """
    part_keys = [(along, across) for across in ("across even", "across odd") for along in ("along even", "along odd")]
    # Parts are summed one after the other: intermediate results remain in the CPU cache.
    parts = [
        ns.call_unfused(_part(ns, *keys), *(kernels[name] for name in keys), *images)
        for images in zip(*waves, strict=True)
        for keys in part_keys
    ]
    image = ns.call_unfused(_assembled(ns, axes), *ns.call_unfused(_quadrants(axes), *parts))
    columns, rows, count = image.shape
    return ns.xp.permute_dims(ns.xp.reshape(image, (columns * rows, count)), (1, 0))


@cache
def _part(ns: Namespace, along: str, across: str) -> Callable[..., Tensor]:
    """Return a function that computes a part, even or odd in y (`along`) and x (`across`), from the four IMAGES."""

    def sum_part(rows: Tensor, columns: Tensor, a: Tensor, b: Tensor, c: Tensor, d: Tensor) -> Tensor:
        first_pair, second_pair = (a + b, c + d) if along == "along even" else (a - b, c - d)
        part = first_pair + second_pair if across == "across even" else first_pair - second_pair
        chords, row_count, nodes = rows.shape
        count = part.shape[-1]
        chord_sums = ns.matmul(rows, ns.xp.reshape(part, (chords, nodes, count)))
        total = ns.matmul(columns, ns.xp.reshape(chord_sums, (chords, row_count * count)))
        return ns.xp.reshape(total, (columns.shape[0], row_count, count))

    return sum_part


@cache
def _quadrants(axes: tuple[Axis, Axis]) -> Callable[..., tuple[Tensor, ...]]:
    """Return a function that computes intensities at mirror images of stored positions from parts of the field."""

    def quadrants(*parts: Tensor) -> tuple[Tensor, ...]:
        real, imaginary = parts[:4], parts[4:]
        same_signs = real[0] - real[3], imaginary[1] + imaginary[2], imaginary[0] - imaginary[3], real[1] + real[2]
        other_signs = real[0] + real[3], imaginary[2] - imaginary[1], imaginary[0] + imaginary[3], real[2] - real[1]
        # In the order of IMAGES: x and y have equal signs in the first and the last image.
        images = [(same_signs, True), *([(other_signs, True)] * down), *([(other_signs, False)] * across)]
        images += [(same_signs, False)] * (across and down)
        fields = [(a + b, c - d) if add else (a - b, c + d) for (a, b, c, d), add in images]
        return tuple(real * real + imaginary * imaginary for real, imaginary in fields)

    across, down = (axis.negative > 0 for axis in axes)
    return quadrants


@cache
def _assembled(ns: Namespace, axes: tuple[Axis, Axis]) -> Callable[..., Tensor]:
    """Return a function that assembles images ``(columns, rows, n)`` from their quadrants."""

    def assemble(*quadrants: Tensor) -> Tensor:
        across, down = axes
        step = 2 if down.negative else 1
        sides = [down.unfold(ns, quadrants[k + step - 1], quadrants[k], 1) for k in range(0, len(quadrants), step)]
        return across.unfold(ns, sides[-1], sides[0], 0)

    return assemble


# Each operation of PyTorch is a pass over memory, and products of small matrices alone take as long as the whole
# computation by the compiled core. The core therefore computes values and first gradients in float32, with the same
# chords and nodes. The rounding errors of the core are below the bound for the framework (docs/certificate.md).

_MAX_CORE_DEGREE = 30  # largest degree of terms for the core, whose rounding errors increase with the number of terms


class Sums(NamedTuple):
    """Arguments of the chordal sums in the compiled core; `stretch` multiplies coefficients and pixel pitch."""

    terms: tuple[Term, ...]
    stretch: float
    obscuration: float
    exponent: tuple[float, ...]
    shape: tuple[int, int]
    axis: tuple[float, float]
    step: float
    chords: int
    nodes: int

    def _arguments(self, c: Array) -> tuple[DiskStack, Window, tuple[int, int]]:
        edge = np.multiply(c, self.stretch, dtype=np.float64, order="C")
        terms, exponent = np.array(self.terms, dtype=np.int32), np.array(self.exponent)
        window = Window(self.shape, self.axis, self.stretch * self.step)
        return DiskStack(terms, edge, self.obscuration, exponent), window, (self.chords, self.nodes)

    def intensity(self, c: Array, threads: int) -> NDArray[np.float32]:
        """Return the intensity for coefficients `c`, shape ``(n, columns * rows)``, column by column."""
        return chordal_sums(*self._arguments(c), threads).reshape(len(c), -1)

    def gradient(self, c: Array, weights: Array, threads: int) -> Array:
        """Return the derivatives of ``sum(weights * intensity(c))`` with respect to `c`."""
        by_row = weights.reshape(len(c), *self.shape[::-1]).transpose(0, 2, 1)
        by_row = np.ascontiguousarray(by_row, dtype=np.float64)
        return self.stretch * chordal_sums_gradient(*self._arguments(c), by_row, threads)


def compiled_sums(
    pupil: Pupil, grid: Grid, stretch: float, terms: tuple[Term, ...], counts: tuple[int, int]
) -> Sums | None:
    """Return the compiled sums, with `counts` = (chords, nodes); None if the core does not support them."""
    if grid.integrate or not isinstance(grid.pixel, float) or not all(0 < n <= _MAX_CORE_DEGREE for n, _ in terms):
        return None
    exponent = tuple(pupil.illumination.exponent.tolist())
    return Sums(terms, stretch, pupil.obscuration, exponent, grid.shape, grid.axis, grid.step(pupil), *counts)


@cache
def _torch_function() -> Any:
    import torch

    ns = Namespace.of("torch")

    class CompiledSums(torch.autograd.Function):  # type: ignore[misc]
        """Sums and first gradient by the compiled core; higher derivatives by PyTorch."""

        @staticmethod
        def forward(ctx: Any, c: Operand, sums: Sums, in_torch: Callable[[Tensor], Tensor]) -> Tensor:
            ctx.save_for_backward(c)
            ctx.sums, ctx.in_torch = sums, in_torch
            return torch.from_numpy(sums.intensity(c.detach().numpy(), torch.get_num_threads()))  # type: ignore[no-any-return]

        @staticmethod
        def backward(ctx: Any, weights: Operand) -> tuple[Tensor, None, None]:
            (c,) = ctx.saved_tensors
            # With create_graph the gradient is differentiable; the compiled core does not support this.
            values = None if torch.is_grad_enabled() else ns.values_now(weights)
            if values is not None:
                gradient = ctx.sums.gradient(c.detach().numpy(), values, torch.get_num_threads())
                return torch.from_numpy(gradient).to(c.dtype), None, None
            with torch.enable_grad():
                intensity = ctx.in_torch(c)
            return *torch.autograd.grad(intensity, c, weights, create_graph=torch.is_grad_enabled()), None, None

    return CompiledSums


_B = np.geomspace(4e-3, 4.0, 64)  # parameters b of the candidate curves
_MAX_COUNT = 512  # largest number of chords, and largest number of nodes on a chord
_MAX_MEAN_DEGREE, _MAX_MEMBERS = 12, 64  # largest degree, and largest number of pupils, for bounds by means on curves


class Chordal(NamedTuple):
    """Field of any pupil at one wavelength; methods require its tables."""

    phase: PhaseRule
    error: FieldError
    axes: tuple[Axis, Axis]
    mean: Mean | None  # bound by means on curves; None for the bound by the maximum of the integrand
    sums: Sums | None  # sums in the compiled core; None if the core does not support them

    def intensity(self, ns: Namespace, tables: Tables, c: Tensor) -> tuple[Tensor, Tensor]:
        """Return I, shape ``(n, columns * rows)``, column by column, and a bound on the error of the field, (n,)."""

        def in_framework(c: Tensor) -> Tensor:
            image_tables = [{name: tables[name][k, ...] for name in self.phase.tables} for k in range(len(IMAGES))]
            cos_sin = [waves(ns, phase_turns(ns, self.phase, nodes, c)) for nodes in image_tables]
            return folded_intensity(ns, tables, cos_sin, self.axes)

        error = self._field_error(ns, tables, c)  # computed first: its memory is released before images are computed
        values = ns.values_now(c) if self.sums and c.shape[0] else None
        if self.sums is None or values is None:
            return in_framework(c), error
        if ns.name == "numpy":
            return self.sums.intensity(values, 0), error
        return _torch_function().apply(c, self.sums, in_framework), error

    def _field_error(self, ns: Namespace, tables: Tables, c: Tensor) -> Tensor:
        xp = ns.xp
        fixed_c = ns.stop(xp.astype(c, tables["size"].dtype))
        if self.mean is not None:
            parts = [exponential(ns, self.mean.logarithm(ns, tables, name, fixed_c)) for name in ("chords", "nodes")]
        else:
            rounding = 1.0 + 64.0 * (self.error.unit + ns.coarseness(self.error.unit))
            size = ns.matmul(xp.sqrt(ns.matmul(fixed_c * fixed_c, tables["pairs"])), tables["growth"]) * rounding
            parts = [exponential(ns, xp.min(size + tables[name], axis=-1)) for name in ("chords", "nodes")]
        total = parts[0] + parts[1]
        return self.error.total(ns, self.phase, tables, fixed_c, total)


def _constants(illumination: Apodization, b: Array) -> tuple[Array, Array]:
    """Return the logarithms of the constant factors of the bounds for chords and for nodes, without ``-2 N b``."""
    growth = illumination.growth(np.cosh(2.0 * b)) if not illumination.uniform else 0.0
    # With N >= 4 chords, 1 - exp(-2 (N + 1) b) is at least 1 - exp(-10 b).
    chords = np.log1p(np.exp(-4.0 * b)) - np.log(-np.expm1(-10.0 * b)) + growth
    return chords, math.log(32.0 / 15.0) - np.log(-np.expm1(-2.0 * b)) + growth


def make_chordal(
    pupil: Pupil, grid: Grid, stretch: float, window: tuple[Array, Array], error: float, precision: str
) -> tuple[Chordal, Tables]:
    """Return the field at the `window` (rows, columns) in v, with a quadrature error of at most `error`; and tables.

    The bound holds for the pupils of the stack. `stretch` is (wavelength of the pupil) / (wavelength of the field);
    `window` is in v at the wavelength of the field. Raise ToleranceError for too many chords or nodes.
    """
    y, x = window
    names, c = columns(pupil)
    terms = cast("tuple[Term, ...]", names)
    obscuration, illumination = pupil.obscuration, pupil.illumination
    v_max = math.hypot(np.abs(x).max(), np.abs(y).max()), float(np.abs(y).max())
    disks = [(1.0, illumination)] + ([(obscuration, illumination.scaled(obscuration))] if obscuration else [])
    degrees, by_means = [n for n, _ in terms], None
    if max(degrees) <= _MAX_MEAN_DEGREE:
        # Pupils with the largest sum of n abs(c): a term of degree n is of order exp(n b) on a curve.
        members = c[np.argsort(-np.abs(c) @ degrees, kind="stable")[:_MAX_MEMBERS]]
        # The weight of the inner disk is (area of the disk) / (area of the aperture), r^2.
        log_factors = [(r, np.stack(_constants(amplitude, CURVES)) + 2.0 * math.log(r)) for r, amplitude in disks]
        by_means = fewest((terms, stretch, window), members, log_factors, error, UNIT[precision])
    chords, nodes, mean, bounds = by_means or counts_by_largest(terms, c, stretch, disks, v_max, error)
    if max(chords, nodes) > _MAX_COUNT:
        raise ToleranceError(f"phases and windows this large take {max(chords, nodes)} chords, above {_MAX_COUNT}")
    px, py, weights = _rule(chords, nodes, disks, illumination)
    at_x, at_y = (np.stack([sign[k] * p for sign in IMAGES]) for k, p in ((0, px[:, None] + 0.0 * py), (1, py)))
    rho, theta = np.hypot(at_x, at_y), np.arctan2(at_y, at_x)
    basis = stretch * np.stack([zernike.polynomial(n, m, rho, theta).ravel() for n, m in terms])
    largest = 1.5 * float((np.abs(c) @ np.abs(basis).max(axis=1)).max(initial=0.0))
    phase, arrays = phase_tables(basis, max(degrees) ** 2, largest, precision, pupils_last=True)
    unit, sums = UNIT[precision], 4.0 * float(np.abs(weights).sum())
    # Rounding is (K + N + 32) u for K nodes and N chords; the tables contain K / 2 nodes and N / 2 chords.
    rounding = unit * sums * (2.0 * py.shape[1] + 2.0 * len(px) + 32.0)
    rounding += UNIT["float64"] * sums * (40.0 + 4.0 * sum(v_max) + 3.0 * illumination.slope)
    omitted_phase, omitted_light = pupil.left_out
    tables: Tables = {**arrays}
    tables |= {name: arrays[name].reshape(len(IMAGES), py.size, -1) for name in phase.tables}
    (column_axis, stored_columns), (row_axis, stored_rows) = axis_of(x), axis_of(y)
    tables |= folded_tables(px, py, weights, stored_columns, stored_rows) | bounds
    field_error = FieldError(unit, sums, rounding + (stretch * omitted_phase + 2.0 * omitted_light) * sums, 8.0)
    core = compiled_sums(pupil, grid, stretch, terms, (chords, nodes)) if precision == "float32" else None
    return Chordal(phase, field_error, (column_axis, row_axis), mean, core), tables


def counts_by_largest(
    terms: tuple[Term, ...],
    c: Array,
    stretch: float,
    disks: list[tuple[float, Apodization]],
    v_max: tuple[float, float],
    error: float,
) -> tuple[int, int, Mean | None, Tables]:
    """Return the numbers of chords and nodes, and tables of the bounds by the maximum of the integrand."""
    # All terms with the same degree n and abs(m) have one amplitude.
    kinds = sorted({(n, abs(m)) for n, m in terms})
    matrix = np.array([[float(kind == (n, abs(m))) for kind in kinds] for n, m in terms])
    # Arguments are limited to 300, because products with sinh of larger arguments would overflow.
    growth = stretch * np.sinh(np.minimum(np.outer([n for n, _ in kinds], _B), 300.0))
    size = (np.sqrt(c**2 @ matrix) @ growth).max(axis=0)
    # The integrand of the inner disk, whose weight is radius^2, is not larger, except for the amplitude.
    log_factors = [_constants(amplitude, _B) for _, amplitude in disks]
    inner_disks = sum(math.log1p(radius**2) for radius, _ in disks[1:])
    parts = [np.max([pair[k] for pair in log_factors], axis=0) + inner_disks + v_max[k] * np.sinh(_B) for k in (0, 1)]
    counts = [(part + size - math.log(0.5 * error)) / (2.0 * _B) for part in parts]
    chords, nodes = (even(float(at_b.min())) for at_b in counts)
    # Curves on both sides of the best curve of the stack: the best curve of a single pupil may differ.
    chosen = np.unique([np.clip(int(at_b.argmin()) + k, 0, 63) for at_b in counts for k in (-6, -3, 0, 3, 6)])
    bounds: Tables = {
        "pairs": matrix,
        "growth": growth[:, chosen],
        "chords": parts[0][chosen] - 2.0 * chords * _B[chosen],
        "nodes": parts[1][chosen] - 2.0 * nodes * _B[chosen],
    }
    return chords, nodes, None, bounds


def _rule(chords: int, nodes: int, disks: list[tuple[float, Apodization]], light: Apodization) -> tuple[Array, ...]:
    """Return x (chords,), y (chords, nodes) of nodes with x, y > 0, and weights * amplitude (chords, nodes)."""
    # Chebyshev's rule of the second kind across the chords. Nodes with negative x or y are mirror images.
    angle = np.arange(1, chords // 2 + 1) * (math.pi / (chords + 1))
    eta, gauss = (part[nodes // 2 :] for part in gauss_legendre(nodes, -1.0, 1.0))
    px = np.concatenate([radius * np.cos(angle) for radius, _ in disks])
    py = np.concatenate([radius * np.sin(angle)[:, None] * eta for radius, _ in disks])
    # U = U_1 - eps^2 U_2 for an obscuration eps: certificate, section 5.
    signs = [1.0 if radius == 1.0 else -(radius**2) for radius, _ in disks]
    w = np.concatenate([sign * np.sin(angle)[:, None] ** 2 * gauss / (chords + 1) for sign in signs])
    # Because of rounding, nodes may be slightly outside the pupil edge.
    return px, py, w * light.at(np.minimum(1.0, px[:, None] ** 2 + py * py))
