r"""Stacks through the layers of a microscope, interpolated with a proven error bound: the default.

All planes share their angles and radii, so that their fields are products of matrices; tables that depend only on
the objective and the pixels are cached. The proof is in docs/certificate.md, section 15.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple, TypeVar

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Images, Intensities, Wanted
from lommel.core.engine import Layered, LayeredSlopes, Window, layered_images, layered_profiles
from lommel.methods.layers.debye_wolf import DebyeWolf, likely_peak
from lommel.optics.grid import Grid
from lommel.optics.layers import debye
from lommel.optics.layers.debye import Complex, Model, Rule, Turning
from lommel.optics.layers.emitter import Light
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.stratified import Layers

# Shares of the tolerance: fields over the root of the peak, and interpolation between radii over the peak.
_FIELD, _BETWEEN = 1.0 / 32.0, 1.0 / 8.0
_LEAST = 2.0**-52
_TURNS = 2  # highest order of the azimuth that the core supports

T = TypeVar("T")
_Question = tuple[Layers, Model, tuple[float, float], tuple[float, float], float, float]


@dataclass(frozen=True)
class Stratified(DebyeWolf):
    r"""Certified stacks through plane layers by matrix products: the default for an :class:`lommel.Objective`.

    Supports what :class:`lommel.DebyeWolf` does, with the same contract. Fields are summed over angles whose
    number is proven to suffice, at few radii; between these the intensity, which is of exponential type 2 in v, is
    interpolated with a proven error. For light that depends on the azimuth, samples are computed around any axis, and
    pixel integrals from them. Windows off the axis that reach beyond v = 110, and tolerances near the limit of
    rounding, are computed as by `DebyeWolf`.

    Parameters
    ----------
    tol : float, default 1e-6
        Tolerance relative to the peak of each plane.

    Raises
    ------
    TypeError, ValueError
        If `tol` is out of range.

    Notes
    -----
    Angles and Bessel functions are kept for stacks of the same objective, wavelength, emitter and pixels, with depths
    and foci in about the same range.

    References
    ----------
    B. Richards and E. Wolf, Proc. R. Soc. Lond. A 253, 358 (1959), doi:10.1098/rspa.1959.0200.
    P. Torok et al., J. Opt. Soc. Am. A 12, 325 (1995), doi:10.1364/JOSAA.12.000325.
    """

    def profile(self, pupil: ObjectivePupil, v: Array) -> Intensities:
        """Return I at rising v; its bound is checked against the peak that was found."""
        made = profiles(pupil, v, self.tol) if v.size else None
        if made is None:
            return super().profile(pupil, v)
        values, off = made
        peak = values[:, 0].max(axis=1) - off
        return Intensities(values[:, 0], off / peak, peak)

    def images(self, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see :meth:`lommel.Method.images`."""
        plain = not (wanted.terms or wanted.powers) and (pupil.radial or not grid.integrate)
        made = differentiated(pupil, grid, (), self.tol, wanted) if plain else None
        return super().images(pupil, grid, wanted) if made is None else made

    def _samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
        made = differentiated(pupil, grid, (), tol, wanted)
        return super()._samples(pupil, grid, tol, wanted) if made is None else made


class By(NamedTuple):
    """Derivative computed by the engine; see :class:`lommel.core.engine.LayeredSlopes`."""

    which: int
    factor: float = 1.0
    own: Array | float = 0.0  # factor of I itself in the derivative, for each plane


class _Accuracy(NamedTuple):
    """Errors of fields and of interpolation (in I)."""

    field: float
    between: float


def _settled(attempt: Callable[[_Accuracy], tuple[T | None, float]], pupil: ObjectivePupil, tol: float) -> T | None:
    """Return the first result with a bound of at most `tol`; None if there is none or an attempt returns none."""
    peak = likely_peak(pupil)
    while True:
        # Powers of two, so that angles and tables are shared by similar tolerances.
        field = max(_LEAST, 2.0 ** math.floor(math.log2(_FIELD * tol * math.sqrt(peak))))
        made, worst = attempt(_Accuracy(field, max(_LEAST, 2.0 ** math.floor(math.log2(_BETWEEN * tol * peak)))))
        if made is None or worst <= tol:
            return made
        if field <= _LEAST:
            return None
        # The next estimate of the peak, at most a quarter of the previous one.
        peak *= max(1e-6, min(0.25, 0.5 * tol / worst))


def profiles(pupil: ObjectivePupil, v: Array, tol: float) -> tuple[Array, Array] | None:
    """Return orders of the azimuth of I at rising v, and the error of their sum, proven to be `tol` of the peak."""

    def attempt(accuracy: _Accuracy) -> tuple[tuple[Array, Array], float]:
        values, off = layered_profiles(layered(pupil, float(v[-1]), accuracy.field), v)
        peak = values[:, 0].max(axis=1) - off
        relative = np.divide(off, peak, out=np.full(peak.shape, np.inf), where=peak > 0.0)
        return (values, off), float(relative.max())

    return _settled(attempt, pupil, tol) if pupil.light.model.orders[0] == 0 else None


def differentiated(pupil: ObjectivePupil, grid: Grid, by: Sequence[By], tol: float, wanted: Wanted) -> Images | None:
    """Return images accurate to `tol`, and their derivatives.

    None if the engine does not support such windows or this accuracy; see :func:`lommel.core.engine.layered_images`.
    """
    if not known(pupil.light):
        return None
    step, reach = grid.step(pupil), grid._farthest * grid.step(pupil)
    window = Window(grid.shape, np.stack(grid.center, axis=-1).reshape(-1, 2) if grid.stack else grid.center, step)

    def attempt(accuracy: _Accuracy) -> tuple[Images | None, float]:
        # Averages sum over more values of fields than samples do.
        field = accuracy.field / 2.0 if grid.integrate else accuracy.field
        slopes = None
        if by:
            errors, turned = _slopes(_question(pupil, reach, field))
            each = np.array([(one.which, one.factor) for one in by])
            own = np.stack([np.broadcast_to(one.own, pupil.power.shape) for one in by])
            slopes = LayeredSlopes(each, own, errors, *turned)
        asked = layered(pupil, reach, field)
        made = layered_images(asked, window, accuracy.between, wanted, integrate=grid.integrate, slopes=slopes)
        return made, 0.0 if made is None else float(made.bound.max())

    return _settled(attempt, pupil, tol)


def known(light: Light) -> bool:
    """Return whether the core supports such light: no vortices, and orders of the azimuth up to 2."""
    return light.model.orders[0] == 0 and max(h.order for h in light.harmonics) <= _TURNS


def layered(pupil: ObjectivePupil, reach: float, tol: float) -> Layered:
    """Return a flattened stack in the layout of the core, with fields accurate to `tol` up to `reach` in v."""
    # One rule serves all planes between two depths and two foci: certificate, section 15.
    found, parts, rates = _angles(_question(pupil, reach, tol))
    planes = np.stack([pupil.depth.ravel(), pupil.focus.ravel(), pupil.power])
    harmonics = pupil.light.harmonics
    turns = np.array([[h.order, h.cosine, h.sine] for h in harmonics], dtype=np.float64)
    return Layered(found.rho, parts, rates, found.error, planes, np.stack([h.form for h in harmonics]), turns)


def _question(pupil: ObjectivePupil, reach: float, tol: float) -> _Question:
    """Return the key of a rule for angles: a range of depths, and of foci counted from the paraxial ones."""
    depth, layers = pupil.depth.ravel(), pupil.layers
    # The parallelogram of section 15: the focus less that of paraxial rays.
    away = pupil.focus.ravel() - layers.immersion / layers.sample * depth
    return layers, pupil.light.model, _outwards(depth), _outwards(away), _above(reach), tol


def _outwards(values: Array) -> tuple[float, float]:
    """Return a range around values that others like them have too: multiples of an eighth of their width or less."""
    low, high = float(values.min()), float(values.max())
    unit = 2.0 ** math.floor(math.log2(max(high - low, 4e-7) / 8.0))
    return unit * math.floor(low / unit), unit * math.ceil(high / unit)


def _above(reach: float) -> float:
    """Return a reach that others like it have too, at most an eighth larger."""
    unit = 2.0 ** math.floor(math.log2(max(reach, 1.0) / 8.0))
    return unit * math.ceil(reach / unit)


def _corners(layers: Layers, depths: tuple[float, float], foci: tuple[float, float]) -> tuple[Array, Array]:
    depth = np.repeat(np.maximum(depths, 0.0), 2)
    return depth, layers.immersion / layers.sample * depth + np.tile(foci, 2)


@lru_cache(maxsize=32)
def _angles(asked: _Question) -> tuple[Rule, Complex, Complex]:
    layers, model, depths, foci, reach, tol = asked
    found = debye.rule(layers, model, *_corners(layers, depths, foci), reach, tol)
    return found, np.stack(found.parts), np.stack(found.rates)


@lru_cache(maxsize=32)
def _slopes(asked: _Question) -> tuple[Array, Turning]:
    """Return what derivatives of fields err by with these angles, and what these change by with the wavenumber."""
    (layers, model, depths, foci, reach, tol), (found, _, _) = asked, _angles(asked)
    errors = debye.slope_errors(found, layers, model, *_corners(layers, depths, foci), reach, tol)
    return np.array(errors), debye.turning(found, layers, model)
