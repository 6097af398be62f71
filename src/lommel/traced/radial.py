r"""The field of radially symmetric pupils as a matrix product.

``U(v) = int A exp(i Phi) J0(v sqrt t) dt`` over ``[eps^2, 1]`` in t = rho^2, by Gauss and Legendre's rule: a phase at
K nodes from a few coefficients, its cosine and sine, and their product with the table ``w_k A_k J0(v_r sqrt t_k)``
in double precision. The number of nodes and the error of each pupil follow from the integrand on Bernstein ellipses:
:mod:`lommel.methods.bounds`.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import ToleranceError
from lommel.methods import bounds
from lommel.methods.derivative_names import Name
from lommel.optics.pupil import Pupil
from lommel.special.legendre import gauss_legendre
from lommel.traced import phases
from lommel.traced.certificate import FieldError, exponential
from lommel.traced.namespaces import Namespace, Tables, Tensor
from lommel.traced.phases import UNIT, PhaseRule, waves

_ETA = np.geomspace(2e-3, 4.0, 80)
_CHOSEN = 4  # ellipses on the device, around the best one for the stack
_MOST_NODES = 4096


class Radial(NamedTuple):
    """The field of a radially symmetric pupil at one wavelength, without its tables.

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
        cos, sin = waves(ns, phases.turns(ns, self.phase, tables, c))
        real, imaginary = ns.matmul(cos, tables["table"]), ns.matmul(sin, tables["table"])
        still = ns.stop(ns.xp.astype(c, tables["table"].dtype))
        error = self.error.total(ns, self.phase, tables, still, self._quadrature_error(ns, tables, still))
        return real * real + imaginary * imaginary, error

    def _quadrature_error(self, ns: Namespace, tables: Tables, c: Tensor) -> Tensor:
        """Return a bound on the error of quadrature on the radius, shape (n,)."""
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
    """Return the names of the coefficients, powers or terms (n, m), and those of the flattened stack."""
    wavefront = pupil.wavefront
    if wavefront._powers is None or not pupil.radial:
        return wavefront.terms, wavefront.edge.reshape(-1, len(wavefront.terms))
    powers = pupil.coefficients() * np.where(np.arange(wavefront.symmetric) == 0, 0.5, 1.0)
    return ("defocus", "spherical", *(f"rho^{2 * k + 2}" for k in range(2, wavefront.symmetric))), powers


def _basis(powers: bool, count: int, t: NDArray[Any]) -> NDArray[Any]:
    """Return powers of t or Legendre terms at real or complex t, each up to a constant, ``(count,) + t.shape``."""
    if powers:
        return np.stack([2.0 * t - 1.0, *(t ** (k + 1) - 0.5 for k in range(1, count))])
    found, x, before, here = [], 2.0 * t - 1.0, np.zeros_like(t), np.ones_like(t)
    for j in range(1, count + 1):
        before, here = here, ((2 * j - 1) * x * here - (j - 1) * before) / j
        found.append(here)
    return np.stack(found)


def make(pupil: Pupil, stretch: float, v: Array, error: float, precision: str) -> tuple[Radial, dict[str, Array]]:
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
    imaginary = stretch * _basis(powers, degree, bounds.ellipses(_ETA, low, steps)).imag
    kernel = far * bounds.rise(_ETA, low, steps)
    size = np.abs(np.tensordot(middle, imaginary, 1)) + np.tensordot(spread, np.abs(imaginary), 1)
    constant = light.growth(np.cosh(_ETA), low) + math.log(32.0 / 15.0 * (1.0 - low)) - np.log(-np.expm1(-2.0 * _ETA))
    needed = (bounds.between(size, kernel, degree, low) + constant - math.log(error)) / (2.0 * _ETA)
    best, nodes = int(needed.argmin()), max(1, math.ceil(float(needed.min())))
    if nodes > _MOST_NODES:
        raise ToleranceError(f"phases and windows this large take {nodes} nodes, more than {_MOST_NODES}")
    chosen = np.unique([best, *np.clip(best + np.arange(_CHOSEN) * 5 - 10, 0, len(_ETA) - 1)])
    widening = 1.0 / math.cos(0.5 * degree * math.pi / steps)
    curved = 0.0 if low == 0.0 else (degree * math.pi / steps) ** 2 / 8.0 * widening
    t, weights = gauss_legendre(nodes, low, 1.0)
    table = (weights * light.at(t))[:, None] * j0(np.sqrt(t)[:, None] * v)
    basis = stretch * _basis(powers, degree, t)
    largest = float(np.abs(c).max(axis=0, initial=0.0) @ np.abs(basis).max(axis=1))
    phase, tables = phases.make(basis, degree, largest, precision)
    unit, sums = UNIT[precision], float(np.abs(table).sum(axis=0).max())
    # Sums, waves and products; weights and amplitude; J0, whose argument is off by 3.5 u: abs(J1(x)) x < 0.83 sqrt x.
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
