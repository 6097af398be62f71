r"""Cosine and sine of phases in turns.

JAX reduces the argument of its own cosine as if it were of any size, one value after another on a processor. Phases
are known in turns here, so that what is left of a turn is exact, ``cos 2 pi t = sin 2 pi z``, ``z = 1/4 - |t|``, and
the sine of so little is a polynomial: n terms of its series are off by less than the next one,
``(pi / 2)^(2n+1) / (2n+1)!``. Both are off by at most 5 u, but for the rounding of ``t - 1/4``, of which the sine is
the cosine: no more than that of ``2 pi t`` elsewhere.
"""

from __future__ import annotations

import math
from fractions import Fraction
from functools import cache
from typing import Any

from lommel.twins.namespaces import Namespace

_COUNT = {"float32": 7, "float64": 11}
_TURN = Fraction("6.28318530717958647692528676655900576839433879875")


def waves(ns: Namespace, turns: tuple[Any, ...]) -> tuple[Any, Any]:
    """Return cosine and sine of what :func:`lommel.twins.phases.turns` made."""
    if ns.name == "jax":
        return ns.apart(_of_jax(), *turns)  # type: ignore[no-any-return]
    total = turns[0]
    if len(turns) > 1:
        total = (total - ns.xp.round(total)) + turns[1]
    angle = total * math.tau
    return ns.xp.cos(angle), ns.xp.sin(angle)


@cache
def coefficients(kind: str) -> tuple[float, ...]:
    """Return those of ``sin(2 pi z) / z`` in powers of ``z^2``, for a type of numbers."""
    return tuple(float((-1) ** k * _TURN ** (2 * k + 1) / math.factorial(2 * k + 1)) for k in range(_COUNT[kind]))


@cache
def _of_jax() -> Any:
    import jax
    from jax import lax

    def without_whole(turns: Any) -> Any:
        return turns - lax.round(turns, lax.RoundingMethod.TO_NEAREST_EVEN)

    def cosine(turns: Any) -> Any:
        z = 0.25 - lax.abs(without_whole(turns))
        square = z * z
        total: Any
        *rest, total = coefficients(str(turns.dtype))
        for coefficient in reversed(rest):
            total = total * square + coefficient
        return z * total

    @jax.custom_jvp
    def both(turns: Any) -> tuple[Any, Any]:
        return cosine(turns), cosine(turns - 0.25)

    @both.defjvp
    def slopes(given: Any, tangents: Any) -> tuple[Any, Any]:
        cos, sin = both(*given)
        turned = tangents[0] * math.tau
        return (cos, sin), (-sin * turned, cos * turned)

    def of_parts(exact: Any, *rest: Any) -> tuple[Any, Any]:
        return both(without_whole(exact) + rest[0] if rest else exact)

    return of_parts
