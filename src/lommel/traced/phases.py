r"""Phases at quadrature nodes and their cosines and sines, in float64, or in float32 at full accuracy.

In float32 a phase of 100 rad would be off by 6e-6. So coefficients are split,
``c = n / s + r`` with a whole number n, and terms in turns, ``B / (2 pi s) = B_1 + B_2`` with B_1 a multiple of
``2^-q``: as ``n B_1`` are multiples of it too, and their sum is less than ``2^(23 - q)``, products, sums and what is
left without whole turns are exact. ``n B_2 + r B / 2 pi`` is a small part of a turn, and only it is rounded. With u
the unit roundoff, d terms, and the small part at most ``delta``, the phase is off by at most

``u (2 pi (2 d + 4) delta + 6 pi (1/2 + delta)) .``

Rounding n to whole numbers has the derivative 0, and that of r by c is 1: derivatives are those of the phase.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.traced.namespaces import Namespace, Operand, Tables, Tensor

UNIT = {"float64": 2.0**-53, "float32": 2.0**-24}
_ADDED = 4  # terms up to which products of columns and rows are added, which compilers make one pass of


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


def make(
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
    limit = 1.25 * largest + 1.0
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


def turns(ns: Namespace, rule: PhaseRule, tables: Tables, c: Tensor) -> tuple[Tensor, ...]:
    """Return phases in turns from coefficients ``(n, terms)``: one array, or an exact one and a small rest."""
    xp, dtype = ns.xp, tables[rule.tables[0]].dtype
    if not rule.scale:
        return (_sum(ns, rule, xp.astype(c, dtype), tables["basis"]),)
    whole = xp.round(ns.stop(c) * rule.scale)
    rest = xp.astype(c - whole * (1.0 / rule.scale), dtype)
    whole = xp.astype(whole, dtype)
    exact = _sum(ns, rule, whole, tables["coarse"])
    if rule.pupils_last:
        return exact, _sum(ns, rule, xp.concat([whole, rest], axis=-1), tables["rest"])
    return exact, _sum(ns, rule, whole, tables["fine"]) + _sum(ns, rule, rest, tables["basis"])


def _sum(ns: Namespace, rule: PhaseRule, c: Tensor, table: Tensor) -> Tensor:
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

_COUNT = {"float32": 7, "float64": 11}
_TURN = Fraction("6.28318530717958647692528676655900576839433879875")


def waves(ns: Namespace, turns: tuple[Tensor, ...]) -> tuple[Tensor, Tensor]:
    """Return cosine and sine of phases in :func:`turns`."""
    if ns.name == "jax":
        return ns.apart(_of_jax(), *turns)
    total = turns[0]
    if len(turns) > 1:
        total = (total - ns.xp.round(total)) + turns[1]
    angle = total * math.tau
    return ns.xp.cos(angle), ns.xp.sin(angle)


@cache
def coefficients(kind: str) -> tuple[float, ...]:
    """Return the coefficients of ``sin(2 pi z) / z`` in powers of ``z^2`` for a type."""
    return tuple(float((-1) ** k * _TURN ** (2 * k + 1) / math.factorial(2 * k + 1)) for k in range(_COUNT[kind]))


@cache
def _of_jax() -> Callable[..., tuple[Tensor, Tensor]]:
    import jax
    from jax import lax

    def without_whole(turns: Operand) -> Operand:
        return turns - lax.round(turns, lax.RoundingMethod.TO_NEAREST_EVEN)

    def cosine(turns: Operand) -> Operand:
        z = 0.25 - lax.abs(without_whole(turns))
        square = z * z
        total: Operand
        *rest, total = coefficients(str(turns.dtype))
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
