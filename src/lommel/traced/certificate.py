"""What twins prove of their field, computed where the field is, and what that makes of images.

A field of error e whose largest modulus in the window was found to be M makes an intensity that is off by at most
``2 M e + e^2``, over a peak that falls short of the one found by at most as much: docs/certificate.md, section 6.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from lommel.traced.namespaces import Namespace
from lommel.traced.phases import PhaseRule

_MOST = 60.0  # of a logarithm that is exponentiated: what is larger is as good as infinite
_ROOM = 1.001  # for what is computed in float32


class Exponents(NamedTuple):
    """How a bound on quadrature follows from coefficients; see :func:`quadrature`.

    Attributes
    ----------
    curves : int
        How many were chosen.
    points : int
        On each.
    widening, curved : float
        What the largest value on the points is multiplied by; 0 and what is added of that of the phase, where
        neighbours are joined.
    """

    curves: int
    points: int
    widening: float
    curved: float


def quadrature(ns: Namespace, rule: Exponents, tables: dict[str, Any], c: Any, unit: float) -> Any:
    """Bound the error of quadrature, shape (n,), by the tables imaginary, kernel, constant and most."""
    xp = ns.xp
    phase = xp.abs(ns.matmul(c, tables["imaginary"]))
    phase = xp.reshape(phase, (phase.shape[0], rule.curves, rule.points))
    if rule.curved:
        pairs = xp.maximum(phase[..., 1:], phase[..., :-1]) + tables["kernel"]
        largest = xp.max(pairs, axis=-1) + rule.curved * xp.max(phase, axis=-1)
    else:
        largest = xp.max(phase + tables["kernel"], axis=-1) * rule.widening
    # What the products above may have lost, and the sums of logarithms.
    lost = (c.shape[-1] + 8) * (unit + ns.coarseness(unit)) * ns.matmul(xp.abs(c), tables["most"])
    logarithm = xp.min(largest + lost + tables["constant"], axis=-1)
    return exponential(ns, logarithm)


def exponential(ns: Namespace, logarithm: Any) -> Any:
    """Return e to a logarithm and a little more; what would be out of range is infinite."""
    xp = ns.xp
    big = logarithm > _MOST
    least = xp.exp(xp.where(big, xp.zeros_like(logarithm), logarithm)) * _ROOM
    return xp.where(big, _infinite(xp, least), least)


class FieldError(NamedTuple):
    """What a field is off by, but for quadrature.

    Attributes
    ----------
    unit : float
        Unit roundoff of the sums.
    sums : float
        Largest sum over nodes of what is multiplied with waves.
    rounding : float
        Of sums, waves and tables.
    left_out : float
        What terms and amplitude do not hold of the pupil that is meant.
    products : float
        What `sums` is multiplied by where products round operands by a unit.
    """

    unit: float
    sums: float
    rounding: float
    left_out: float
    products: float

    def total(self, ns: Namespace, rule: PhaseRule, tables: dict[str, Any], c: Any, quadrature_error: Any) -> Any:
        """Bound the error of the field; infinite where a phase is larger than sums of terms were made for."""
        xp = ns.xp
        coarse = ns.coarseness(self.unit)
        size = xp.sum(xp.abs(c) * tables["size"], axis=-1) * (1.0 + 1e-5)
        each = rule.each + (2.5 * coarse if rule.multiplied(c.shape[-1]) else 0.0)
        error = quadrature_error + self.sums * (each * size + rule.fixed + self.products * coarse)
        error = error + (self.rounding + self.left_out)
        return xp.where(size <= rule.limit, error, _infinite(xp, error))


def of_intensity(ns: Namespace, intensity: Any, error: Any, unit: float) -> Any:
    """Bound the error of the squared modulus of a field, shape (n,), all of whose values are given."""
    largest = ns.xp.max(intensity, axis=-1)
    return (2.0 * ns.xp.sqrt(largest) + error) * error + 4.0 * unit * largest


def over_peak(ns: Namespace, values: Any, error: Any, stored: float, *, divided: bool) -> Any:
    """Bound the error over the exact peak of the values, once they are stored, or first divided by their peak.

    Infinite where there is none, NaN never.
    """
    xp = ns.xp
    peak = xp.max(values, axis=-1)
    room = peak - error
    ratio = error / xp.where(room > 0.0, room, xp.ones_like(peak))
    ratio = xp.where(room > 0.0, ratio, _infinite(xp, ratio))
    if divided:
        small = ratio < 0.5
        ratio = xp.where(small, ratio, xp.zeros_like(ratio))
        ratio = xp.where(small, 2.0 * ratio / (1.0 - ratio), _infinite(xp, ratio))
    bound = (ratio + (1.0 + ratio) * stored) * _ROOM
    # What is not a number compares as False.
    return xp.where(bound >= 0.0, bound, _infinite(xp, bound))


def _infinite(xp: Any, like: Any) -> Any:
    return xp.full_like(like, float("inf"))
