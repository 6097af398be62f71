r"""How large the integrand is on average on the curves that bound the rule of chords, from samples.

Terms do not reach their largest values at one place, so the mean of ``|F| = exp(h)`` over a curve is far below its
largest value. On either curve h is a trigonometric polynomial in two angles. Between samples at steps s it is at most
``C s^2 / 4`` above what is linear between them, ``C = sum n_j^2 |c_j| sinh(n_j b) + R sinh b``, and the mean is below
the sum of samples of ``exp(h)``, each with the mean of its hat: docs/certificate.md, section 8. Conjugate points have
opposite h, so half of the angles do; over the window the mean is convex, and largest at a corner.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.special.legendre import gauss_legendre
from lommel.twins.namespaces import Namespace

_STEPS = 5  # of half a turn, for each degree
CURVES = np.geomspace(0.04, 1.6, 24)
_MOST = 40.0  # of logarithms, lest what is exponentiated leave the range of float32
_ROUNDED = 0.05  # what exponentials and their sums may lose, with products rounded to bfloat16
_NUMPY = Namespace.of(None)


class Mean(NamedTuple):
    """The bound of one sum on one curve: what is no array.

    Attributes
    ----------
    bend : float
        ``s^2 / 4``.
    unit : float
        Unit roundoff of what it is computed in.
    """

    bend: float
    unit: float

    def logarithm(self, ns: Namespace, tables: dict[str, Any], name: str, c: Any) -> Any:
        """Bound the logarithm of the error of the sum, shape (n,)."""
        xp, size = ns.xp, ns.xp.abs(c)
        phase = ns.matmul(c, tables[f"{name} terms"])
        mean = ns.matmul(xp.exp(-phase), tables[f"{name} plus"]) + ns.matmul(xp.exp(phase), tables[f"{name} minus"])
        lost = (c.shape[-1] + 10) * (self.unit + ns.coarseness(self.unit))
        bent = self.bend * ns.matmul(size, tables[f"{name} bend"]) + lost * ns.matmul(size, tables[f"{name} size"])
        return xp.log(xp.max(mean, axis=-1)) + bent[..., 0] + tables[f"{name} constant"]


def best(
    name: str,
    where: tuple[tuple[Any, ...], float, tuple[Array, Array]],
    c: Array,
    rest: tuple[Array, float],
    chords: int,
    unit: float,
) -> tuple[int, Mean, dict[str, Array]] | None:
    """Return the fewest chords, or nodes, for an error of all members, with their bound; None if there is no curve.

    `where` are terms, stretch and window, `rest` what is added to logarithms on the curves, and the logarithm of the
    error.
    """
    found = None
    for b, constant in zip(CURVES.tolist(), rest[0].tolist(), strict=True):
        mean, tables = make(*where, name, b, chords)
        with np.errstate(over="ignore", invalid="ignore"):
            size = float(mean._replace(unit=unit).logarithm(_NUMPY, tables, name, c).max()) + constant + _ROUNDED
        if not size < _MOST:
            continue
        count = max(4, math.ceil((size - rest[1]) / (2.0 * b)))
        if found is None or count < found[0]:
            tables[f"{name} constant"] = tables[f"{name} constant"] + (constant + _ROUNDED - 2.0 * count * b)
            found = count, mean._replace(unit=unit), tables
    return found


def make(
    terms: tuple[tuple[int, int], ...], stretch: float, window: tuple[Array, Array], name: str, b: float, chords: int
) -> tuple[Mean, dict[str, Array]]:
    """Return the bound of the sum `name` on a curve b, but for what is added to its logarithm, and its tables.

    Parameters
    ----------
    terms : tuple of (n, m)
    stretch : float
        That coefficients are multiplied by.
    window : (ndarray, ndarray)
        Rows and columns, v.
    name : {"chords", "nodes"}
    b : float
    chords : int
        How many there are; of "nodes" only.
    """
    y, x = window
    degrees = np.array([n for n, _ in terms], dtype=np.float64)
    steps = _STEPS * max(2, int(degrees.max()))
    angle = np.arange(steps + 1) * (math.pi / steps)
    if name == "chords":
        turned = angle[:, None] + 1j * b
        px, py = np.cos(turned) + 0.0 * angle, np.sin(turned) * np.cos(angle)
        first = _hats(steps, lambda a: (np.sin(a) ** 2 + math.sinh(b) ** 2) / (0.5 * math.pi * math.cosh(2.0 * b)))
        second = _hats(steps, lambda a: 0.5 * np.sin(a))
    else:
        px, py = np.cos(angle)[:, None] + 0.0 * angle, np.sin(angle)[:, None] * np.cos(angle + 1j * b)
        phi = np.arange(1, chords + 1) * (math.pi / (chords + 1))
        hat = np.maximum(0.0, 1.0 - np.abs(phi - angle[:, None]) * (steps / math.pi))
        first = hat @ (2.0 * np.sin(phi) ** 2 / (chords + 1))
        second = _hats(steps, lambda a: np.full_like(a, 1.0 / math.pi))
    share = (first[:, None] * second).ravel()
    px, py = (part.ravel() for part in np.broadcast_arrays(px, py))
    corners = [(u, w) for u in (y.min(), y.max()) for w in (x.min(), x.max())]
    lift = np.stack([w * px.imag + u * py.imag for u, w in corners], axis=-1)
    sinh = stretch * np.sinh(degrees * b)
    reach = math.hypot(np.abs(x).max(), np.abs(y).max()) if name == "chords" else float(np.abs(y).max())
    bend = (math.pi / steps) ** 2 / 4.0
    tables = {
        f"{name} terms": stretch * polynomials(terms, px, py).imag,
        f"{name} plus": 0.5 * share[:, None] * np.exp(lift),
        f"{name} minus": 0.5 * share[:, None] * np.exp(-lift),
        f"{name} bend": (degrees**2 * sinh)[:, None],
        f"{name} size": sinh[:, None],
        f"{name} constant": np.array([bend * reach * math.sinh(b)]),
    }
    return Mean(bend, 0.0), tables


def _hats(steps: int, weight: Any) -> Array:
    """Return the integrals over half a turn of a weight times the hat functions around equal steps."""
    nodes, gauss = gauss_legendre(16)
    width = math.pi / steps
    values = weight(width * (np.arange(steps)[:, None] + nodes)) * (width * gauss)
    found = np.zeros(steps + 1)
    found[:-1] += values @ (1.0 - nodes)
    found[1:] += values @ nodes
    return found


def polynomials(terms: tuple[tuple[int, int], ...], x: NDArray[Any], y: NDArray[Any]) -> NDArray[np.complex128]:
    """Return Zernike terms at complex points, shape ``(terms,) + x.shape``."""
    from scipy.special import eval_jacobi

    square, plus, minus = 2.0 * (x * x + y * y) - 1.0, x + 1j * y, x - 1j * y
    found = []
    for n, m in terms:
        order = abs(m)
        around = 0.5 * (plus**order + minus**order) if m >= 0 else -0.5j * (plus**order - minus**order)
        found.append(eval_jacobi((n - order) // 2, 0.0, float(order), square + 0j) * around)
    return np.stack(found)
