r"""The field of pupils with any Zernike terms, by the rule of chords: products of matrices.

Nodes ``x_i = cos(phi_i)``, ``y = eta_k sin(phi_i)``; over each chord the kernel is that of the rows of a window, over
the chords that of its columns. What is proven of the two sums is in docs/certificate.md, section 8: with W_p the
amplitude of the terms of a degree n_p and |m|, ``log |F| <= sum W_p sinh(n_p b) + R sinh b`` on a curve b, linear in
W_p, so that its bound is a product too. An inner disk is more chords, of negative weights.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import ToleranceError
from lommel.optics.apodization import Apodization
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre
from lommel.twins import compiled, folded, phases
from lommel.twins.certificate import FieldError, exponential
from lommel.twins.compiled import Sums
from lommel.twins.folded import Axis
from lommel.twins.means import CURVES, Mean, best, even
from lommel.twins.namespaces import Namespace
from lommel.twins.phases import UNIT, PhaseRule
from lommel.twins.radial import columns
from lommel.twins.waves import waves

_B = np.geomspace(4e-3, 4.0, 64)
_MOST = 512
_SAMPLED, _MEMBERS = 12, 64  # degrees and pupils that means are sampled for


class Chordal(NamedTuple):
    """The field of one wavelength: all that is no array."""

    phase: PhaseRule
    error: FieldError
    axes: tuple[Axis, Axis]
    means: tuple[Mean, Mean] | None
    sums: Sums | None

    def intensity(self, ns: Namespace, tables: dict[str, Any], c: Any) -> tuple[Any, Any]:
        """Return I, shape ``(n, columns * rows)``, column by column, and a bound on the error of the field, (n,)."""

        def followed(c: Any) -> Any:
            of_image = [{name: tables[name][k, ...] for name in self.phase.tables} for k in range(len(folded.IMAGES))]
            both = [waves(ns, phases.turns(ns, self.phase, one, c)) for one in of_image]
            return folded.intensity(ns, tables, both, self.axes)

        error = self._field_error(ns, tables, c)  # first, lest its room be beside that of images
        return compiled.intensity(ns, self.sums, c, followed), error

    def _field_error(self, ns: Namespace, tables: dict[str, Any], c: Any) -> Any:
        xp = ns.xp
        still = ns.stop(xp.astype(c, tables["size"].dtype))
        total = 0.0
        for name, mean in zip(("chords", "nodes"), self.means or (None, None), strict=True):
            if mean is not None:
                total = total + exponential(ns, mean.logarithm(ns, tables, name, still))
                continue
            amplitudes = xp.sqrt(ns.matmul(still * still, tables["pairs"]))
            size = ns.matmul(amplitudes, tables["growth"]) * (
                1.0 + 64.0 * (self.error.unit + ns.coarseness(self.error.unit))
            )
            total = total + exponential(ns, xp.min(size + tables[name], axis=-1))
        return self.error.total(ns, self.phase, tables, still, total)


def pairs(terms: tuple[Any, ...]) -> tuple[Array, Array]:
    """Return which terms share a degree and abs(m), shape ``(terms, pairs)``, and the degree of each pair."""
    kinds = sorted({(n, abs(m)) for n, m in terms})
    matrix = np.zeros((len(terms), len(kinds)))
    for j, (n, m) in enumerate(terms):
        matrix[j, kinds.index((n, abs(m)))] = 1.0
    return matrix, np.array([n for n, _ in kinds], dtype=np.float64)


def _constants(light: Apodization, b: Array) -> tuple[Array, Array]:
    """Return what is added to the logarithm of the integrand on curves, of both sums, but for ``-2 N b``."""
    grown = light.growth(np.cosh(2.0 * b)) if not light.uniform else 0.0
    # With four chords or more, 1 - exp(-2 (N + 1) b) is more than 1 - exp(-10 b).
    chords = np.log1p(np.exp(-4.0 * b)) - np.log(-np.expm1(-10.0 * b)) + grown
    return chords, math.log(32.0 / 15.0) - np.log(-np.expm1(-2.0 * b)) + grown


def make(
    pupil: Pupil, grid: Grid, stretch: float, window: tuple[Array, Array], error: float, precision: str
) -> tuple[Chordal, dict[str, Array]]:
    """Return the field of a stack at rows and columns in v, and of pupils no larger than a member, and its tables.

    Parameters
    ----------
    pupil : Pupil
        At its own wavelength.
    grid : Grid
    stretch : float
        That wavelength over the one of the field.
    window : (ndarray, ndarray)
        Rows and columns, at the wavelength of the field.
    error : float
        Of the quadrature.
    precision : str

    Raises
    ------
    ToleranceError
        If it takes too many chords.
    """
    y, x = window
    terms, c = columns(pupil)
    low, light = pupil.obscuration, pupil.illumination
    reach = math.hypot(np.abs(x).max(), np.abs(y).max()), float(np.abs(y).max())
    disks = [(1.0, light)] + ([(low, light.scaled(low))] if low else [])
    where = terms, stretch, window
    chords, nodes, means, bounds = _sampled(pupil, where, disks, error, UNIT[precision]) or _largest(
        pupil, stretch, disks, reach, error
    )
    if max(chords, nodes) > _MOST:
        raise ToleranceError(f"phases and windows this large take {max(chords, nodes)} chords, more than {_MOST}")
    px, py, weights = _rule(chords, nodes, disks, light)
    at_x, at_y = (
        np.stack([sign[k] * p for sign in folded.IMAGES]) for k, p in ((0, px[:, None] + 0.0 * py), (1, py))
    )
    rho, theta = np.hypot(at_x, at_y), np.arctan2(at_y, at_x)
    basis = stretch * np.stack([zernike.polynomial(n, m, rho, theta).ravel() for n, m in terms])
    degree = max(n for n, _ in terms)
    largest = 1.5 * float((np.abs(c) @ np.abs(basis).max(axis=1)).max(initial=0.0))
    phase, tables = phases.make(basis, degree**2, largest, precision, pupils_last=True)
    unit, sums = UNIT[precision], 4.0 * float(np.abs(weights).sum())
    rounding = unit * sums * (2.0 * py.shape[1] + 2.0 * len(px) + 32.0)
    rounding += UNIT["float64"] * sums * (40.0 + 4.0 * sum(reach) + 3.0 * light.slope)
    phase_left, light_left = pupil.left_out
    tables |= {name: tables[name].reshape(len(folded.IMAGES), py.size, -1) for name in phase.tables}
    (across, right), (down, below) = folded.axis_of(x), folded.axis_of(y)
    tables |= folded.tables(px, py, weights, right, below) | bounds
    left = FieldError(unit, sums, rounding, (stretch * phase_left + 2.0 * light_left) * sums, 8.0)
    core = compiled.of(pupil, grid, stretch, terms, (chords, nodes)) if precision == "float32" else None
    return Chordal(phase, left, (across, down), means, core), tables


def _sampled(
    pupil: Pupil, where: tuple[Any, ...], disks: list[tuple[float, Apodization]], error: float, unit: float
) -> Any:
    """Return chords, nodes and their bounds by means, of few terms at `where`, terms, stretch and window; or None."""
    terms, c = columns(pupil)
    if max(n for n, _ in terms) > _SAMPLED:
        return None
    members = c[np.argsort(-np.abs(c) @ [n for n, _ in terms], kind="stable")[:_MEMBERS]]
    # The inner disk counts by its area.
    of_disks = [(radius, np.stack(_constants(one, CURVES)) + 2.0 * math.log(radius)) for radius, one in disks]
    chords = best("chords", where, members, [(radius, of[0]) for radius, of in of_disks], 0.5 * error, 0, unit)
    if chords is None:
        return None
    parts = [(radius, of[1]) for radius, of in of_disks]
    nodes = best("nodes", where, members, parts, 0.5 * error, chords[0], unit)
    return None if nodes is None else (chords[0], nodes[0], (chords[1], nodes[1]), chords[2] | nodes[2])


def _largest(
    pupil: Pupil, stretch: float, disks: list[tuple[float, Apodization]], reach: tuple[float, float], error: float
) -> Any:
    """Return chords, nodes and their bounds by the largest values."""
    terms, c = columns(pupil)
    matrix, degrees = pairs(terms)
    growth = stretch * np.sinh(np.minimum(degrees[:, None] * _B, 300.0))
    size = (np.sqrt(c**2 @ matrix) @ growth).max(axis=0)
    # That of the inner disk is as large at most, but for its amplitude, and counts by its area.
    of_disks = [_constants(one, _B) for _, one in disks]
    added = math.log1p(pupil.obscuration**2)
    parts = [np.max([one[k] for one in of_disks], axis=0) + added + reach[k] * np.sinh(_B) for k in (0, 1)]
    needed = [(part + size - math.log(0.5 * error)) / (2.0 * _B) for part in parts]
    chords, nodes = (even(float(each.min())) for each in needed)
    chosen = np.unique([np.clip(int(each.argmin()) + k, 0, 63) for each in needed for k in (-6, -3, 0, 3, 6)])
    bounds = {
        "pairs": matrix,
        "growth": growth[:, chosen],
        "chords": parts[0][chosen] - 2.0 * chords * _B[chosen],
        "nodes": parts[1][chosen] - 2.0 * nodes * _B[chosen],
    }
    return chords, nodes, None, bounds


def _rule(chords: int, nodes: int, disks: list[tuple[float, Apodization]], light: Apodization) -> tuple[Array, ...]:
    """Return nodes of positive x and y, and weights with the amplitude: ``(chords,)``, ``(chords, nodes)`` twice."""
    angle = np.arange(1, chords // 2 + 1) * (math.pi / (chords + 1))
    eta, gauss = (part[nodes // 2 :] for part in gauss_legendre(nodes, -1.0, 1.0))
    x, y, weights = [], [], []
    for radius, _ in disks:
        x.append(radius * np.cos(angle))
        y.append(radius * np.sin(angle)[:, None] * eta)
        sign = 1.0 if radius == 1.0 else -(radius**2)
        weights.append(sign * np.sin(angle)[:, None] ** 2 * gauss / (chords + 1))
    px, py, w = (np.concatenate(part) for part in (x, y, weights))
    return px, py, w * light.at(np.minimum(1.0, px[:, None] ** 2 + py * py))
