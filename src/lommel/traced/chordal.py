"""The fields of pupils as products of matrices: any Zernike terms by the chordal rule, or radial symmetry.

Nodes ``x_i = cos(phi_i)``, ``y = eta_k sin(phi_i)``; along a chord the kernel is that of the rows of a window, across
chords that of its columns. The bounds of the two sums are in the certificate, section 8: with W_p the amplitude
of the terms of a degree n_p and |m|, ``log |F| <= sum W_p sinh(n_p b) + R sinh b`` on a curve b, linear in W_p, so
that the bound is a product too. An inner disk is more chords, of negative weights.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple, cast

import numpy as np
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

# Phases at quadrature nodes and their cosines and sines, in float64, or in float32 at full accuracy (certificate,
# "Differentiable PSFs", "Rounding"). In float32 a phase of 100 rad would be off by 6e-6. So coefficients are split,
# ``c = n / s + r`` with a whole number n, and terms in turns, ``B / (2 pi s) = B_1 + B_2`` with B_1 a multiple of
# ``2^-q``: as ``n B_1`` are multiples of it too, and their sum is less than ``2^(23 - q)``, products, sums and what
# is left without whole turns are exact. ``n B_2 + r B / 2 pi`` is a small part of a turn, and only it is rounded.
# With u the unit roundoff, d terms, and the small part at most ``delta``, the phase is off by at most ``u (2 pi (2 d
# + 4) delta + 6 pi (1/2 + delta))``.
#
# Rounding n to whole numbers has the derivative 0, and that of r by c is 1: derivatives are those of the phase.

UNIT = {"float64": 2.0**-53, "float32": 2.0**-24}
_ADDED = 4  # largest number of terms whose products are added one by one, which compilers fuse into one pass


class PhaseRule(NamedTuple):
    """Scale s of split coefficients (0 in float64), and the error bound of phases.

    Phases are off by at most `each` times ``S = sum abs(c_j) max abs(B_j)``, plus `fixed`, for S up to `limit`; they
    have the shape ``(nodes, n)`` where `pupils_last`, else ``(n, nodes)``.
    """

    scale: float
    each: float
    fixed: float
    limit: float
    pupils_last: bool

    @property
    def tables(self) -> tuple[str, ...]:
        """Names of the tables with a value for each term and node."""
        if not self.scale:
            return ("basis",)
        return ("coarse", "rest") if self.pupils_last else ("coarse", "fine", "basis")

    def multiplied(self, terms: int) -> bool:
        """Return whether phases of so many terms are matrix products."""
        return self.pupils_last or terms > _ADDED


def phase_tables(
    basis: Array, degree: int, largest: float, precision: str, *, pupils_last: bool = False
) -> tuple[PhaseRule, dict[str, Array]]:
    """Return the rule and the tables for terms at the nodes, `basis` (terms, nodes), of at most this degree.

    `largest` is the largest ``sum abs(c_j) max abs(B_j)`` in the valid range.
    """
    count, size = len(basis), np.abs(basis).max(axis=1)
    each = UNIT["float64"] * (count + 2.0 * degree + 9.0)
    if precision == "float64":
        table = basis / math.tau
        tables = {"size": size, "basis": np.ascontiguousarray(table.T) if pupils_last else table}
        return PhaseRule(0.0, each, 0.0, math.inf, pupils_last), tables
    # Some room beyond the valid range, in which the rule still holds.
    limit = 1.25 * largest + 1.0
    # float32 has 24 bits: sums below 2^(23 - q) of multiples of 2^-q are exact.
    q = 23 - math.ceil(math.log2(limit / math.tau))
    least = float(size[size > 0.0].min()) if size.any() else 1.0
    scale = 2.0 ** max(0, round(0.5 * (q - math.log2(limit / least))))
    turns = basis / (math.tau * scale)
    coarse = np.round(turns * 2.0**q) * 2.0**-q
    small = scale * (limit / least) * 2.0 ** (-q - 1) + float(size.sum()) / (2.0 * math.tau * scale)
    unit = UNIT["float32"]
    fixed = unit * (math.tau * (2.0 * count + 4.0) * small + 3.0 * math.tau * (0.5 + small))
    rule = PhaseRule(scale, each, fixed, limit, pupils_last)
    if pupils_last:
        rest = np.concatenate([turns - coarse, basis / math.tau]).T
        return rule, {"size": size, "coarse": np.ascontiguousarray(coarse.T), "rest": np.ascontiguousarray(rest)}
    return rule, {"size": size, "coarse": coarse, "fine": turns - coarse, "basis": basis / math.tau}


def phase_turns(ns: Namespace, rule: PhaseRule, tables: Tables, c: Tensor) -> tuple[Tensor, ...]:
    """Return phases in turns from coefficients ``(n, terms)``: one array, or an exact one and a small remainder."""
    xp, dtype = ns.xp, tables[rule.tables[0]].dtype
    if not rule.scale:
        return (_phase_sum(ns, rule, xp.astype(c, dtype), tables["basis"]),)
    whole = xp.round(ns.stop(c) * rule.scale)
    rest = xp.astype(c - whole * (1.0 / rule.scale), dtype)
    whole = xp.astype(whole, dtype)
    exact = _phase_sum(ns, rule, whole, tables["coarse"])
    if rule.pupils_last:
        return exact, _phase_sum(ns, rule, xp.concat([whole, rest], axis=-1), tables["rest"])
    return exact, _phase_sum(ns, rule, whole, tables["fine"]) + _phase_sum(ns, rule, rest, tables["basis"])


def _phase_sum(ns: Namespace, rule: PhaseRule, c: Tensor, table: Tensor) -> Tensor:
    if rule.pupils_last:
        return ns.matmul(table, ns.xp.permute_dims(c, (1, 0)))
    if rule.multiplied(table.shape[0]):
        return ns.matmul(c, table)
    total = c[..., 0:1] * table[0, ...]
    for j in range(1, table.shape[0]):
        total = total + c[..., j : j + 1] * table[j, ...]
    return total


# On a processor JAX reduces the argument of its cosine one value after another, whatever its size. Phases are known
# in turns here, so that the remainder of a turn is exact, ``cos 2 pi t = sin 2 pi z``, ``z = 1/4 - |t|``,
# and the sine of so little is a polynomial: n terms of its series are off by less than the next one, ``(pi /
# 2)^(2n+1) / (2n+1)!``. Both are off by at most 5 u, but for the rounding of ``t - 1/4``, of which the sine
# is the cosine: no more than that of ``2 pi t`` elsewhere.

_SINE_TERMS = {"float32": 7, "float64": 11}
_TURN = Fraction("6.28318530717958647692528676655900576839433879875")


def waves(ns: Namespace, turns: tuple[Tensor, ...]) -> tuple[Tensor, Tensor]:
    """Return cosine and sine of phases in :func:`phase_turns`."""
    if ns.name == "jax":
        return ns.apart(_waves_of_jax(), *turns)
    total = turns[0]
    if len(turns) > 1:
        # Whole turns are removed before the small part is added: both are then below one turn.
        total = (total - ns.xp.round(total)) + turns[1]
    angle = total * math.tau
    return ns.xp.cos(angle), ns.xp.sin(angle)


@cache
def sine_coefficients(kind: str) -> tuple[float, ...]:
    """Return the coefficients of ``sin(2 pi z) / z`` in powers of ``z^2`` for a type."""
    return tuple(
        float((-1) ** k * _TURN ** (2 * k + 1) / math.factorial(2 * k + 1)) for k in range(_SINE_TERMS[kind])
    )


@cache
def _waves_of_jax() -> Callable[..., tuple[Tensor, Tensor]]:
    import jax
    from jax import lax

    def without_whole(turns: Operand) -> Operand:
        return turns - lax.round(turns, lax.RoundingMethod.TO_NEAREST_EVEN)

    def cosine(turns: Operand) -> Operand:
        z = 0.25 - lax.abs(without_whole(turns))
        square = z * z
        total: Operand
        *rest, total = sine_coefficients(str(turns.dtype))
        for coefficient in reversed(rest):
            total = total * square + coefficient
        return z * total

    @jax.custom_jvp
    def both(turns: Operand) -> tuple[Tensor, Tensor]:
        return cosine(turns), cosine(turns - 0.25)

    @both.defjvp
    def slopes(given: Operand, tangents: Operand) -> tuple[tuple[Tensor, Tensor], tuple[Tensor, Tensor]]:
        cos, sin = both(*given)
        turned = tangents[0] * math.tau
        return (cos, sin), (-sin * turned, cos * turned)

    def of_parts(exact: Operand, *rest: Operand) -> tuple[Tensor, Tensor]:
        return both(without_whole(exact) + rest[0] if rest else exact)

    return of_parts


class FieldError(NamedTuple):
    """Errors of a field besides quadrature.

    Attributes
    ----------
    unit : float
        Unit roundoff of the sums.
    sums : float
        Largest sum over nodes of the factors of the waves.
    added : float
        Rounding of sums, waves and tables; phase and amplitude that the terms leave out.
    products : float
        Factor of `sums` for matrix products that round their operands.
    """

    unit: float
    sums: float
    added: float
    products: float

    def total(
        self, ns: Namespace, rule: PhaseRule, tables: Tables, c: Tensor, quadrature_error: Tensor | float
    ) -> Tensor:
        """Return a bound on the error of the field; inf where a phase is beyond the valid range of the rule."""
        xp = ns.xp
        coarse = ns.coarseness(self.unit)
        # Rounding of the sum itself.
        size = xp.sum(xp.abs(c) * tables["size"], axis=-1) * (1.0 + 1e-5)
        # TF32 rounds both operands of a product: 2^-11 each.
        each = rule.each + (2.5 * coarse if rule.multiplied(c.shape[-1]) else 0.0)
        error = quadrature_error + self.sums * (each * size + rule.fixed + self.products * coarse)
        return xp.where(size <= rule.limit, error + self.added, infinite(ns, error))


_ETA = np.geomspace(2e-3, 4.0, 80)  # tried ellipses: semi-axes cosh and sinh of these
_CHOSEN = 4  # ellipses kept on the device, around the best one for the stack
_MOST_NODES = 4096


# The field of radially symmetric pupils as a matrix product. ``U(v) = int A exp(i Phi) J0(v sqrt t) dt`` over
# ``[eps^2, 1]`` in t = rho^2, by Gauss and Legendre's rule: a phase at K nodes from a few coefficients, its cosine
# and sine, and their product with the table ``w_k A_k J0(v_r sqrt t_k)`` in double precision. The number of nodes and
# the error of each pupil follow from the integrand on Bernstein ellipses lommel.methods.hankel.


class Radial(NamedTuple):
    """Field of a radially symmetric pupil at one wavelength, without its tables.

    Its error of quadrature follows from samples of the phase at `points` on each of some ellipses (`curves`):
    `widening` multiplies the largest one; where `curved` is not 0, neighbours are joined, and it is added times the
    largest phase.
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
        still = ns.stop(ns.xp.astype(c, tables["table"].dtype))
        error = self.error.total(ns, self.phase, tables, still, self._quadrature_error(ns, tables, still))
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
        # Rounding of the products above, and of the sums of logarithms.
        lost = (c.shape[-1] + 8) * (unit + ns.coarseness(unit)) * ns.matmul(xp.abs(c), tables["most"])
        return exponential(ns, xp.min(largest + lost + tables["constant"], axis=-1))


def columns(pupil: Pupil) -> tuple[tuple[Name, ...], Array]:
    """Return the names of the coefficients, powers or terms (n, m), and their values for the flattened stack."""
    wavefront = pupil.wavefront
    if wavefront._powers is None or not pupil.radial:
        return wavefront.terms, wavefront.edge.reshape(-1, len(wavefront.terms))
    # Defocus is c (2 t - 1): c is half of the coefficient of t. Constant phases change no image.
    powers = pupil.coefficients() * np.where(np.arange(wavefront.symmetric) == 0, 0.5, 1.0)
    return ("defocus", "spherical", *(f"rho^{2 * k + 2}" for k in range(2, wavefront.symmetric))), powers


def _basis(powers: bool, count: int, t: Values) -> Values:
    """Return powers of t or Legendre terms at real or complex t, each up to a constant, ``(count,) + t.shape``."""
    if powers:
        return np.stack([2.0 * t - 1.0, *(t ** (k + 1) - 0.5 for k in range(1, count))])
    found, x, before, here = [], 2.0 * t - 1.0, np.zeros_like(t), np.ones_like(t)
    for j in range(1, count + 1):
        # The three-term recurrence of Legendre's polynomials.
        before, here = here, ((2 * j - 1) * x * here - (j - 1) * before) / j
        found.append(here)
    return np.stack(found)


def make_radial(
    pupil: Pupil, stretch: float, v: Array, error: float, precision: str
) -> tuple[Radial, dict[str, Array]]:
    """Return the field at radii v of all pupils in the box of a stack, and its tables, for an error of quadrature.

    `stretch` is the wavelength of the pupil over that of the field. ToleranceError if it takes too many nodes.
    """
    from scipy.special import j0

    low, light = pupil.obscuration**2, pupil.illumination
    terms, c = columns(pupil)
    c = c[:, [j for j, term in enumerate(terms) if isinstance(term, str) or term[1] == 0]]
    middle, spread = 0.5 * (c.max(axis=0) + c.min(axis=0)), 0.5 * (c.max(axis=0) - c.min(axis=0))
    powers, degree, far = isinstance(terms[0], str), c.shape[1], float(v.max(initial=0.0))
    steps = max(32, 16 * degree) if low == 0.0 else max(64, 24 * degree)
    imaginary = stretch * _basis(powers, degree, hankel.ellipses(_ETA, low, steps)).imag
    kernel = far * hankel.rise(_ETA, low, steps)
    # Phases are linear in the coefficients: their largest size in the box of the stack.
    size = np.abs(np.tensordot(middle, imaginary, 1)) + np.tensordot(spread, np.abs(imaginary), 1)
    constant = light.growth(np.cosh(_ETA), low) + math.log(32.0 / 15.0 * (1.0 - low)) - np.log(-np.expm1(-2.0 * _ETA))
    needed = (hankel.between(size, kernel, degree, low) + constant - math.log(error)) / (2.0 * _ETA)
    best, nodes = int(needed.argmin()), max(1, math.ceil(float(needed.min())))
    if nodes > _MOST_NODES:
        raise ToleranceError(f"phases and windows this large take {nodes} nodes, more than {_MOST_NODES}")
    # Pupils of the valid range may have their best ellipse on either side of that of the stack.
    chosen = np.unique([best, *np.clip(best + np.arange(_CHOSEN) * 5 - 10, 0, len(_ETA) - 1)])
    # Ehlich and Zeller, as in lommel.methods.hankel.
    widening = 1.0 / math.cos(0.5 * degree * math.pi / steps)
    curved = 0.0 if low == 0.0 else (degree * math.pi / steps) ** 2 / 8.0 * widening
    t, weights = gauss_legendre(nodes, low, 1.0)
    table = (weights * light.at(t))[:, None] * j0(np.sqrt(t)[:, None] * v)
    basis = stretch * _basis(powers, degree, t)
    largest = float(np.abs(c).max(axis=0, initial=0.0) @ np.abs(basis).max(axis=1))
    phase, tables = phase_tables(basis, degree, largest, precision)
    unit, sums = UNIT[precision], float(np.abs(table).sum(axis=0).max())
    # Sums, waves and products; weights and amplitude; J0, whose argument is off by 3.5 u: abs(J1(x)) x < 0.83 sqrt x.
    # Certificate, "Differentiable PSFs", "Rounding": (K + 16) u.
    added = sums * (nodes + 16.0) * unit
    added += UNIT["float64"] * (12.0 + 3.0 * math.sqrt(far) + (3.0 * light.slope)) * float(weights @ light.at(t))
    phase_left, light_left = pupil.left_out
    added += (stretch * phase_left + 2.0 * light_left) * float(weights @ light.at(t))
    tables |= {
        "table": table,
        "imaginary": imaginary[:, chosen].reshape(degree, -1),
        "most": np.abs(imaginary[:, chosen]).max(axis=-1),
        "kernel": kernel[chosen],
        "constant": constant[chosen] - 2.0 * nodes * _ETA[chosen],
    }
    left = FieldError(unit, sums, added, 4.0)
    return Radial(phase, left, len(chosen), steps + 1, widening, curved), tables


# At the four images (+-x, +-y) of a node the waves have parts that are even and odd in either coordinate. With these
# the kernel is a product of a cosine or sine of v_x x and one of v_y y, real, and the same at the images of a pixel
# but for signs. Pupils are the last axis throughout, so that all products are of small tables with long rows.

IMAGES = ((1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0))  # of a node: signs of x and y


class Axis(NamedTuple):
    """Positions of a window along one axis, by those on one side of its middle.

    Attributes
    ----------
    first : int
        The first of those with an image: 1 where the middle is a place itself.
    negative, positive : int
        Numbers of places on either side; none is negative where the window is not symmetric, and all are kept.
    """

    first: int
    negative: int
    positive: int

    def whole(self, ns: Namespace, below: Tensor, above: Tensor, axis: int) -> Tensor:
        """Return values at all positions along an axis, from those at images and at kept positions."""
        here = [slice(None)] * 3
        here[axis] = slice(0, self.positive)
        above = above[tuple(here)]
        if not self.negative:
            return above
        here[axis] = slice(self.first, self.first + self.negative)
        return ns.xp.concat([ns.flip(below[tuple(here)], axis), above], axis=axis)


def axis_of(v: Array) -> tuple[Axis, Array]:
    """Return the axis of increasing positions, and the positions that are kept."""
    # Windows that are symmetric about the axis need one half of their places.
    half = np.unique(np.abs(v))
    first, negative = int(half[0] == 0.0), int(np.sum(v < 0.0))
    positive = len(v) - negative
    if np.array_equal(v, np.concatenate([-half[first : first + negative][::-1], half[:positive]])):
        return Axis(first, negative, positive), half
    return Axis(0, 0, len(v)), v


def folded_tables(x: Array, y: Array, weights: Array, columns: Array, rows: Array) -> dict[str, Array]:
    """Return the real kernels of chords x and of nodes y on them, with their weights ``(chords, nodes)``."""
    down, over = rows[:, None] * y[:, None, :], columns[:, None] * x
    return {
        "along even": np.cos(down) * weights[:, None, :],
        "along odd": np.sin(down) * weights[:, None, :],
        "across even": np.cos(over),
        "across odd": np.sin(over),
    }


def folded_intensity(
    ns: Namespace, kernels: Tables, waves: list[tuple[Tensor, Tensor]], axes: tuple[Axis, Axis]
) -> Tensor:
    """Return the squared modulus of the sum, shape ``(n, columns * rows)``, columns one after another.

    `waves` are cosine and sine at each of :data:`IMAGES`, ``(nodes, n)``, `axes` those of columns and rows.
    """
    sides = [(along, across) for across in ("across even", "across odd") for along in ("along even", "along odd")]
    # One after the other: intermediate results then stay in the cache.
    parts = [
        ns.apart(_part(ns, *side), *(kernels[name] for name in side), *images)
        for images in zip(*waves, strict=True)
        for side in sides
    ]
    image = ns.apart(_assembled(ns, axes), *ns.apart(_quadrants(axes), *parts))
    across, down, count = image.shape
    return ns.xp.permute_dims(ns.xp.reshape(image, (across * down, count)), (1, 0))


@cache
def _part(ns: Namespace, along: str, across: str) -> Callable[..., Tensor]:
    """Return the function that sums the part, even or odd in y and x, of values at four images."""

    def made(rows: Tensor, columns: Tensor, a: Tensor, b: Tensor, c: Tensor, d: Tensor) -> Tensor:
        one, other = (a + b, c + d) if along == "along even" else (a - b, c - d)
        part = one + other if across == "across even" else one - other
        chords, places, nodes = rows.shape
        count = part.shape[-1]
        of_chords = ns.matmul(rows, ns.xp.reshape(part, (chords, nodes, count)))
        total = ns.matmul(columns, ns.xp.reshape(of_chords, (chords, places * count)))
        return ns.xp.reshape(total, (columns.shape[0], places, count))

    return made


@cache
def _quadrants(axes: tuple[Axis, Axis]) -> Callable[..., tuple[Tensor, ...]]:
    """Return the function from real and imaginary parts of a sum to intensities at images of the kept positions."""

    def made(*parts: Tensor) -> tuple[Tensor, ...]:
        real, imaginary = parts[:4], parts[4:]
        alike = real[0] - real[3], imaginary[1] + imaginary[2], imaginary[0] - imaginary[3], real[1] + real[2]
        other = real[0] + real[3], imaginary[2] - imaginary[1], imaginary[0] + imaginary[3], real[2] - real[1]
        # In the order of IMAGES: signs are alike in the first and the last.
        there = [(alike, True), *([(other, True)] * down), *([(other, False)] * across)]
        there += [(alike, False)] * (across and down)
        fields = [(a + b, c - d) if add else (a - b, c + d) for (a, b, c, d), add in there]
        return tuple(one * one + two * two for one, two in fields)

    across, down = (axis.negative > 0 for axis in axes)
    return made


@cache
def _assembled(ns: Namespace, axes: tuple[Axis, Axis]) -> Callable[..., Tensor]:
    """Return the function that joins quadrants to images ``(columns, rows, n)``."""

    def made(*quadrants: Tensor) -> Tensor:
        across, down = axes
        each = 2 if down.negative else 1
        sides = [down.whole(ns, quadrants[k + each - 1], quadrants[k], 1) for k in range(0, len(quadrants), each)]
        return across.whole(ns, sides[-1], sides[0], 0)

    return made


# Each step of PyTorch is a pass over the memory, and its products of small matrices alone take as long as the core.
# So for values and a first gradient the core sums over the same chords and nodes, in float32 only: its rounding is
# less than what the bound counts for the framework (docs/certificate.md).

_DEGREE = 30  # largest degree: rounding to parts of a turn grows with the number of terms


class Sums(NamedTuple):
    """Chordal sums of the compiled core, with `stretch` multiplying coefficients and pitch."""

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
        """Return I of pupils `c`, shape ``(n, columns * rows)``, columns one after another."""
        return chordal_sums(*self._arguments(c), threads).reshape(len(c), -1)

    def gradient(self, c: Array, weights: Array, threads: int) -> Array:
        """Return the derivatives by `c` of a weighted sum of :meth:`intensity`."""
        by_row = weights.reshape(len(c), *self.shape[::-1]).transpose(0, 2, 1)
        by_row = np.ascontiguousarray(by_row, dtype=np.float64)
        return self.stretch * chordal_sums_gradient(*self._arguments(c), by_row, threads)


def compiled_sums(
    pupil: Pupil, grid: Grid, stretch: float, terms: tuple[Term, ...], counts: tuple[int, int]
) -> Sums | None:
    """Return the sums for samples of square pixels by so many chords and nodes; None if the core has none."""
    if grid.integrate or not isinstance(grid.pixel, float) or not all(0 < n <= _DEGREE for n, _ in terms):
        return None
    light = tuple(pupil.illumination.exponent.tolist())
    return Sums(terms, stretch, pupil.obscuration, light, grid.shape, grid.axis, grid.step(pupil), *counts)


@cache
def _of_torch() -> Any:
    import torch

    ns = Namespace.of("torch")

    class Compiled(torch.autograd.Function):  # type: ignore[misc]
        """The sums with their gradient; higher derivatives are those of PyTorch."""

        @staticmethod
        def forward(ctx: Any, c: Operand, sums: Sums, followed: Callable[[Tensor], Tensor]) -> Tensor:
            ctx.save_for_backward(c)
            ctx.sums, ctx.followed = sums, followed
            return torch.from_numpy(sums.intensity(c.detach().numpy(), torch.get_num_threads()))  # type: ignore[no-any-return]

        @staticmethod
        def backward(ctx: Any, weights: Operand) -> tuple[Tensor, None, None]:
            (c,) = ctx.saved_tensors
            # Under create_graph the gradient is differentiated again, which the compiled core cannot do.
            given = None if torch.is_grad_enabled() else ns.values_now(weights)
            if given is not None:
                found = ctx.sums.gradient(c.detach().numpy(), given, torch.get_num_threads())
                return torch.from_numpy(found).to(c.dtype), None, None
            with torch.enable_grad():
                made = ctx.followed(c)
            return *torch.autograd.grad(made, c, weights, create_graph=torch.is_grad_enabled()), None, None

    return Compiled


_B = np.geomspace(4e-3, 4.0, 64)  # tried curves
_MOST = 512
_SAMPLED, _MEMBERS = 12, 64  # largest degree, and number of pupils, that means are sampled for


class Chordal(NamedTuple):
    """Field of any pupil at one wavelength, without its tables."""

    phase: PhaseRule
    error: FieldError
    axes: tuple[Axis, Axis]
    mean: Mean | None
    sums: Sums | None

    def intensity(self, ns: Namespace, tables: Tables, c: Tensor) -> tuple[Tensor, Tensor]:
        """Return I, shape ``(n, columns * rows)``, column by column, and a bound on the error of the field, (n,)."""

        def followed(c: Tensor) -> Tensor:
            of_image = [{name: tables[name][k, ...] for name in self.phase.tables} for k in range(len(IMAGES))]
            both = [waves(ns, phase_turns(ns, self.phase, one, c)) for one in of_image]
            return folded_intensity(ns, tables, both, self.axes)

        error = self._field_error(ns, tables, c)  # first: its memory is free again before the images
        values = ns.values_now(c) if self.sums and c.shape[0] else None
        if self.sums is None or values is None:
            return followed(c), error
        if ns.name == "numpy":
            return self.sums.intensity(values, 0), error
        return _of_torch().apply(c, self.sums, followed), error

    def _field_error(self, ns: Namespace, tables: Tables, c: Tensor) -> Tensor:
        xp = ns.xp
        still = ns.stop(xp.astype(c, tables["size"].dtype))
        if self.mean is not None:
            parts = [exponential(ns, self.mean.logarithm(ns, tables, name, still)) for name in ("chords", "nodes")]
        else:
            rounded = 1.0 + 64.0 * (self.error.unit + ns.coarseness(self.error.unit))
            size = ns.matmul(xp.sqrt(ns.matmul(still * still, tables["pairs"])), tables["growth"]) * rounded
            parts = [exponential(ns, xp.min(size + tables[name], axis=-1)) for name in ("chords", "nodes")]
        total = parts[0] + parts[1]
        return self.error.total(ns, self.phase, tables, still, total)


def _constants(light: Apodization, b: Array) -> tuple[Array, Array]:
    """Return the constants of the logarithms of both sums on the curves, without ``-2 N b``."""
    grown = light.growth(np.cosh(2.0 * b)) if not light.uniform else 0.0
    # With four chords or more, 1 - exp(-2 (N + 1) b) is more than 1 - exp(-10 b).
    chords = np.log1p(np.exp(-4.0 * b)) - np.log(-np.expm1(-10.0 * b)) + grown
    return chords, math.log(32.0 / 15.0) - np.log(-np.expm1(-2.0 * b)) + grown


def make_chordal(
    pupil: Pupil, grid: Grid, stretch: float, window: tuple[Array, Array], error: float, precision: str
) -> tuple[Chordal, Tables]:
    """Return the field at rows and columns in v of pupils no larger than a member of a stack, and its tables.

    `stretch` is the wavelength of the pupil over that of the field and of `window`. ToleranceError if it takes too
    many chords.
    """
    y, x = window
    names, c = columns(pupil)
    terms = cast("tuple[Term, ...]", names)
    low, light = pupil.obscuration, pupil.illumination
    reach = math.hypot(np.abs(x).max(), np.abs(y).max()), float(np.abs(y).max())
    disks = [(1.0, light)] + ([(low, light.scaled(low))] if low else [])
    degrees, by_means = [n for n, _ in terms], None
    if max(degrees) <= _SAMPLED:
        # Pupils with the largest phases, weighted by degree: a term of degree n grows with exp(n b) on a curve.
        members = c[np.argsort(-np.abs(c) @ degrees, kind="stable")[:_MEMBERS]]
        # The inner disk has the weight of its area.
        of_disks = [(radius, np.stack(_constants(one, CURVES)) + 2.0 * math.log(radius)) for radius, one in disks]
        # Half of the error for each of the two sums.
        by_means = fewest((terms, stretch, window), members, of_disks, 0.5 * error, UNIT[precision])
    chords, nodes, mean, bounds = by_means or counts_by_largest(terms, c, stretch, disks, reach, error)
    if max(chords, nodes) > _MOST:
        raise ToleranceError(f"phases and windows this large take {max(chords, nodes)} chords, more than {_MOST}")
    px, py, weights = _rule(chords, nodes, disks, light)
    at_x, at_y = (np.stack([sign[k] * p for sign in IMAGES]) for k, p in ((0, px[:, None] + 0.0 * py), (1, py)))
    rho, theta = np.hypot(at_x, at_y), np.arctan2(at_y, at_x)
    basis = stretch * np.stack([zernike.polynomial(n, m, rho, theta).ravel() for n, m in terms])
    largest = 1.5 * float((np.abs(c) @ np.abs(basis).max(axis=1)).max(initial=0.0))
    phase, arrays = phase_tables(basis, max(degrees) ** 2, largest, precision, pupils_last=True)
    unit, sums = UNIT[precision], 4.0 * float(np.abs(weights).sum())
    # (K + N + 32) u, K / 2 and N / 2 being the sizes of the tables.
    # Four images of each node.
    rounding = unit * sums * (2.0 * py.shape[1] + 2.0 * len(px) + 32.0)
    rounding += UNIT["float64"] * sums * (40.0 + 4.0 * sum(reach) + 3.0 * light.slope)
    phase_left, light_left = pupil.left_out
    tables: Tables = {**arrays}
    tables |= {name: arrays[name].reshape(len(IMAGES), py.size, -1) for name in phase.tables}
    (across, right), (down, below) = axis_of(x), axis_of(y)
    tables |= folded_tables(px, py, weights, right, below) | bounds
    left = FieldError(unit, sums, rounding + (stretch * phase_left + 2.0 * light_left) * sums, 8.0)
    core = compiled_sums(pupil, grid, stretch, terms, (chords, nodes)) if precision == "float32" else None
    return Chordal(phase, left, (across, down), mean, core), tables


def counts_by_largest(
    terms: tuple[Term, ...],
    c: Array,
    stretch: float,
    disks: list[tuple[float, Apodization]],
    reach: tuple[float, float],
    error: float,
) -> tuple[int, int, Mean | None, Tables]:
    """Return chords, nodes and their bounds by the largest value of the integrand."""
    # Terms that share a degree and abs(m) have one amplitude.
    kinds = sorted({(n, abs(m)) for n, m in terms})
    matrix = np.array([[float(kind == (n, abs(m))) for kind in kinds] for n, m in terms])
    # sinh of more than 300 would overflow in products.
    growth = stretch * np.sinh(np.minimum(np.outer([n for n, _ in kinds], _B), 300.0))
    size = (np.sqrt(c**2 @ matrix) @ growth).max(axis=0)
    # The integrand of the inner disk is no larger, but for its amplitude, and has the weight of its area.
    of_disks = [_constants(one, _B) for _, one in disks]
    added = sum(math.log1p(radius**2) for radius, _ in disks[1:])
    parts = [np.max([one[k] for one in of_disks], axis=0) + added + reach[k] * np.sinh(_B) for k in (0, 1)]
    needed = [(part + size - math.log(0.5 * error)) / (2.0 * _B) for part in parts]
    chords, nodes = (even(float(each.min())) for each in needed)
    # Some curves on either side of the best: pupils of the valid range have theirs there.
    chosen = np.unique([np.clip(int(each.argmin()) + k, 0, 63) for each in needed for k in (-6, -3, 0, 3, 6)])
    bounds: Tables = {
        "pairs": matrix,
        "growth": growth[:, chosen],
        "chords": parts[0][chosen] - 2.0 * chords * _B[chosen],
        "nodes": parts[1][chosen] - 2.0 * nodes * _B[chosen],
    }
    return chords, nodes, None, bounds


def _rule(chords: int, nodes: int, disks: list[tuple[float, Apodization]], light: Apodization) -> tuple[Array, ...]:
    """Return nodes of positive x and y, and weights with the amplitude: ``(chords,)``, ``(chords, nodes)`` twice."""
    # Chebyshev's rule of the second kind across the chords; nodes of one sign, as the others are images of these.
    angle = np.arange(1, chords // 2 + 1) * (math.pi / (chords + 1))
    eta, gauss = (part[nodes // 2 :] for part in gauss_legendre(nodes, -1.0, 1.0))
    px = np.concatenate([radius * np.cos(angle) for radius, _ in disks])
    py = np.concatenate([radius * np.sin(angle)[:, None] * eta for radius, _ in disks])
    # U = U_1 - eps^2 U_2: certificate, section 5.
    signs = [1.0 if radius == 1.0 else -(radius**2) for radius, _ in disks]
    w = np.concatenate([sign * np.sin(angle)[:, None] ** 2 * gauss / (chords + 1) for sign in signs])
    # Rounding may place nodes beyond the edge.
    return px, py, w * light.at(np.minimum(1.0, px[:, None] ** 2 + py * py))
