"""From a plan and a stack of pupils to a twin: what the one door, :meth:`lommel.Plan.traced`, does."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import ToleranceError
from lommel.methods.method import Method
from lommel.methods.polychromatic import Polychromatic
from lommel.optics.colour.spectrum import Component
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil, checked
from lommel.traced import chordal, images, radial
from lommel.traced.namespaces import Namespace
from lommel.traced.phases import UNIT
from lommel.traced.plan_function import Distances, Static, Twin, placed

_FINER = 0.1  # of the error that quadrature is asked for, again and again
_LEAST = 2.0**-52
_MEMBERS, _BETWEEN = 128, 48  # of the reach, that a tolerance is tried with
_BLOCK = 2**21  # values that trials hold at once


def traced(
    pupil: Pupil,
    grid: Grid,
    method: Method | None,
    values: tuple[float, str, str],
    where: tuple[Any, Any, str],
) -> Twin:
    """Return a twin; `values` are tolerance, normalisation and type, `where` framework, device and precision.

    Raises
    ------
    TypeError, ValueError
        As :meth:`lommel.Plan.traced`.
    ToleranceError
        If the tolerance is not proven for a pupil of the stack.
    """
    tol, normalize, dtype = values
    ns, device = Namespace.of(where[0]), where[1]
    precision = _precision(ns, device, where[2])
    if precision == "float32" and dtype == "float64":
        raise ValueError(
            'dtype must be float32 where precision is "float32", got float64'
            + (_X64 if ns.name == "jax" else "; let the plan have a tolerance of 1e-6 or more")
        )
    checked(pupil)
    if not pupil.circular:
        raise ValueError("pupil must have a round aperture for a twin, without spider, vignetting and mask")
    if normalize == "emitted":
        raise ValueError('normalize must be "energy", "strehl" or "peak" for a twin, got "emitted"')
    lights = _components(pupil, method)
    validation.pixel_on(grid.side, pupil.scale, metric=pupil.wavelength is not None)
    grid.require_reach(pupil)
    columns = radial.columns(pupil)
    scale = _scale(pupil, grid, lights, normalize)
    # The peak of a defocused pupil falls about as its phase rises; that of small aberrations of all kinds does not.
    size = float(np.abs(columns[1]).sum(axis=1).max())
    error = tol * pupil.amplitude * (0.04 / (2.0 * size + 1.0) if pupil.radial else 0.15)
    while True:
        parts, pixels, tables = _fields(pupil, grid, lights, error, precision)
        static = Static(
            ns,
            columns[0],
            _kept(pupil, columns[0]),
            _reach(columns[1]),
            parts,
            pixels,
            scale,
            tol,
            precision,
            dtype,
            _distances(pupil),
        )
        worst, most = _tried(static, tables, columns[1])
        if most <= 0.6 * tol or error <= _LEAST:
            break
        error = max(_LEAST, _FINER * error)
    if not worst <= tol:
        raise ToleranceError(
            f"tol={tol:g} cannot be proven in {precision} for the stack that the plan was traced with: the bound is "
            f"{worst:.2g} of the largest value{_X64 if ns.name == 'jax' and precision == 'float32' else ''}"
        )
    return placed(static, tables, device)


_X64 = '; call jax.config.update("jax_enable_x64", True) first, or give the plan a tolerance that float32 can prove'


def _precision(ns: Namespace, device: Any, asked: str) -> str:
    validation.choice("precision", asked, ("auto", *UNIT))
    double = ns.has_double(device)
    if asked == "float64" and not double:
        raise ValueError(
            f'precision must be "float32" or "auto" here: {ns.name} has no float64'
            + (_X64 if ns.name == "jax" else "")
        )
    return asked if asked != "auto" else "float64" if double else "float32"


def _components(pupil: Pupil, method: Method | None) -> list[Component]:
    if isinstance(method, Polychromatic):
        method.require(pupil)
        parts, method = method.components(pupil), method.method
    else:
        parts = [Component(1.0, 1.0, pupil)]
    if method is not None and not (method.keeps_tol and method.sampling == "center" and not method.any_aperture):
        raise ValueError(
            "method must be None, NijboerZernike, ChordalGauss or a Polychromatic of these for a twin, got "
            f"{type(method).__name__}"
        )
    return parts


def _scale(pupil: Pupil, grid: Grid, lights: list[Component], normalize: str) -> float | None:
    if normalize == "energy":
        return float(grid.step(pupil) ** 2 / (4.0 * math.pi * pupil.transmission))
    if normalize == "strehl":
        return 1.0 / (pupil.amplitude**2 * sum(part.weight for part in lights))
    return None


def _kept(pupil: Pupil, terms: tuple[Any, ...]) -> tuple[int, ...]:
    radial_terms = [j for j, term in enumerate(terms) if isinstance(term, str) or term[1] == 0]
    return tuple(radial_terms) if pupil.radial else tuple(range(len(terms)))


def _reach(c: Array) -> tuple[tuple[float, float], ...]:
    return tuple(zip(c.min(axis=0).tolist(), c.max(axis=0).tolist(), strict=True))


def _distances(pupil: Pupil) -> Distances | None:
    there = pupil.geometry
    if there is None or there.model != "paraxial" or pupil.wavelength is None:
        return None
    return Distances(-there.in_focus, math.pi / (2.0 * pupil.wavelength) * there.aperture_radius**2)


def _fields(pupil: Pupil, grid: Grid, lights: list[Component], error: float, precision: str) -> Any:
    step, stretch = grid.step(pupil), max(part.stretch for part in lights)
    parts: list[Any] = []
    if pupil.radial:
        pixels, v, shared = images.of_radii(grid, step, stretch, error * pupil.amplitude)
        parts = [radial.make(pupil, part.stretch, part.stretch * v, error, precision) for part in lights]
    else:
        pixels, lattice, shared = images.of_lattice(grid, step, stretch, error * pupil.amplitude)
        for part in lights:
            window = (part.stretch * lattice[0], part.stretch * lattice[1])
            parts.append(chordal.make(pupil, grid, part.stretch, window, error, precision))
    weights = [part.weight for part in lights]
    tables = tuple(tables for _, tables in parts)
    tables[0].update(shared)
    return tuple((weight, field) for weight, (field, _) in zip(weights, parts, strict=True)), pixels, tables


def _tried(static: Static, tables: Any, c: Array) -> tuple[float, float]:
    """Return the largest bound of the stack, and that of it and of pupils between, within what is promised."""
    twin = Twin(static._replace(namespace=Namespace.of(None)), tables)
    boxed = isinstance(static.lights[0][1], radial.Radial)
    points = max(table.shape[-1] for table in tables[0].values())
    rows = max(1, _BLOCK // points)

    def largest(many: Array) -> float:
        found = [twin.evaluated(many[k : k + rows][:, static.kept])[1].max() for k in range(0, len(many), rows)]
        return float(np.asarray(found).max())

    worst = largest(_some(c))
    return worst, max(worst, largest(_between(c, boxed=boxed)))


def _some(c: Array) -> Array:
    """Return the members of a stack, or of many those with the largest phases and a few others."""
    order = np.argsort(-np.abs(c).sum(axis=1), kind="stable")
    return np.asarray(c[np.concatenate([order[:_MEMBERS], order[_MEMBERS :: max(1, len(c) // _MEMBERS)]])])


def _between(c: Array, *, boxed: bool) -> Array:
    """Return coefficients within the box of a stack, some of its corners among them, or between two members."""
    draw = np.random.default_rng(0)
    if not boxed:
        one, other = c[draw.integers(len(c), size=(2, _BETWEEN // 2))]
        part = draw.random((len(one), 1))
        return np.asarray(part * one + (1.0 - part) * other)
    low, high = c.min(axis=0), c.max(axis=0)
    inside = draw.random((_BETWEEN, c.shape[1]))
    inside[: _BETWEEN // 2] = np.round(inside[: _BETWEEN // 2])
    return np.asarray(low + inside * (high - low))
