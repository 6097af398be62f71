"""The brightest focus of a microscope on the axis, and its axial and lateral width."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.optics.layers import debye
from lommel.optics.layers.quadrature_bounds import Model
from lommel.optics.layers.stratified import Layers, cosines

_TOL = 1e-11
_STEPS = 16  # of the search, over the distance between the zeros beside an unaberrated focus, halved
_PLANES = 256
_DOUBLINGS = 6


class Axial(NamedTuple):
    """The main maximum on the axis: stage position (metres), intensity, full width at half maximum."""

    brightest: float
    intensity: float
    fwhm: float


class _Axis:
    """The field on the axis between two positions of the stage, at one depth."""

    def __init__(self, layers: Layers, depth: float, low: float, high: float) -> None:
        self.depth = np.array([depth])
        ends = np.array([low, high])
        self.rule = debye.rule(layers, Model(), np.full(2, depth), ends, 0.0, _TOL)

    def derivatives(self, focus: Array) -> tuple[Array, Array, Array]:
        """Return the intensity and its first two derivatives by the focus."""
        fixed, by_depth, by_focus = self.rule.rates
        light = self.rule.parts[0] * np.exp(1j * (fixed + self.depth * by_depth))
        rate = 1j * by_focus
        terms = np.stack([light, light * rate, light * rate**2], axis=1)
        found = np.concatenate(
            [np.exp(np.outer(part, rate)) @ terms for part in np.array_split(focus, -(-focus.size // _PLANES))]
        )
        field, first, second = found.T
        slope = 2.0 * (field.conj() * first).real
        return np.abs(field) ** 2, slope, 2.0 * (np.abs(first) ** 2 + (field.conj() * second).real)

    def at(self, focus: float) -> float:
        """Return the intensity in one plane."""
        return float(self.derivatives(np.array([focus]))[0][0])


def depth_of_focus(layers: Layers) -> float:
    """Return the distance from an unaberrated focus to the zeros beside it, metres of the stage."""
    n, sine = layers.immersion, layers.NA / layers.immersion
    return layers.wavelength / (n * sine**2 / (1.0 + math.sqrt((1.0 - sine) * (1.0 + sine))))


def ray_foci(layers: Layers, depth: float) -> Array:
    """Return where rays of rising aperture cross the axis, paraxial first, up to 0.98 of the critical angle."""
    rho = np.linspace(0.0, 0.98, 50) * min(1.0, layers.sample / layers.NA)
    length = np.zeros(rho.shape)
    for index, thickness in (*layers.paths, (layers.sample, depth)):
        length += thickness / (index * cosines(layers.NA, rho, index).real)
    return np.asarray(layers.immersion * cosines(layers.NA, rho, layers.immersion).real * length)


@lru_cache(maxsize=4096)
def brightest(layers: Layers, depth: float) -> Axial:
    """Return the main axial maximum by a search in steps of a 16th of the depth of focus, then Newton's method.

    The search spans the ray foci and two depths of focus beyond, or more until half of the maximum is reached.
    """
    from scipy.optimize import brentq

    rays = ray_foci(layers, depth)
    scale = depth_of_focus(layers)
    margin = 2.0 * scale + 4.0 * sum(thickness for _, thickness in layers.films)
    for doubling in range(_DOUBLINGS):
        low, high = rays.min() - margin * 2**doubling, rays.max() + margin * 2**doubling
        axis = _Axis(layers, depth, low, high)
        focus = np.linspace(low, high, math.ceil((high - low) / scale * _STEPS) + 1)
        values = axis.derivatives(focus)[0]
        best = int(values.argmax())
        dark = np.flatnonzero(values < 0.5 * values[best])
        before, after = dark[dark < best], dark[dark > best]
        if before.size and after.size:
            break
    else:
        raise ValueError(f"depth must leave a maximum on the axis that falls to its half, got {depth:g}")
    top = _maximum(axis, focus[best], focus[1] - focus[0])
    peak = axis.at(top)
    low, high = (
        brentq(lambda f: axis.at(f) - 0.5 * peak, focus[k], focus[best], xtol=1e-16, rtol=1e-12)
        for k in (before[-1], after[0])
    )
    return Axial(top, peak, float(high) - float(low))


def _maximum(axis: _Axis, start: float, step: float) -> float:
    """Return the maximum within a step of `start`, by Newton's method where the curve bends down."""
    at = start
    for _ in range(20):
        _, slope, bend = (float(part[0]) for part in axis.derivatives(np.array([at])))
        move = -slope / bend if bend < 0.0 else math.copysign(0.1 * step, slope)
        before, at = at, min(max(at + move, start - step), start + step)
        if abs(at - before) <= 1e-9 * step:
            break
    return at


def lateral_width(layers: Layers, depth: float, focus: float) -> float:
    """Return the lateral full width at half maximum of a freely rotating dipole, metres: the first crossing."""
    from scipy.optimize import brentq

    model, one = Model(), np.ones(1)
    unit = 2.0 * math.pi / _STEPS  # v of a step: k NA r
    for reach in (32, 256, 2048):
        v = np.asarray(np.arange(reach + 1) * unit)
        rule = debye.rule(layers, model, one * depth, one * focus, float(v[-1]), _TOL)

        def excess(at: Array, rule: debye.Rule = rule) -> Array:
            """Return the intensity less half of that on the axis."""
            parts = debye.fields(rule, model, one * depth, one * focus, np.append(0.0, at))
            first, second, third = (np.abs(part[0]) ** 2 for part in parts)
            values = first + 2.0 * second + third
            return np.asarray(values[1:] - 0.5 * values[0])

        dark = np.flatnonzero(excess(v) < 0.0)
        if dark.size:
            end = brentq(lambda x: float(excess(one * x)[0]), v[dark[0] - 1], v[dark[0]], xtol=1e-13)
            return float(2.0 * end / (layers.wavenumber * layers.NA))
    raise ValueError(f"depth must leave a maximum that falls to its half sideways, got {depth:g}")
