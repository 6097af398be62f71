r"""Stacks through the layers of a microscope by matrix products, with a proven error bound: the default method.

All planes share the angles of integration and the radii, so that their fields are matrix products. Tables that depend
only on the objective and the pixels are cached. The error bound is derived in docs/certificate.md, section 15.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple, TypeVar

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Intensities, Samples, Wanted
from lommel.core.engine import Layered, LayeredSlopes, Window, layered_images, layered_profiles
from lommel.methods.layers.debye_wolf import DebyeWolf, likely_peak
from lommel.optics.grid import Grid
from lommel.optics.layers import debye
from lommel.optics.layers.debye import Complex, Model, Rule
from lommel.optics.layers.emitter import Light
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.stratified import Layers

# Fractions of the tolerance: errors of fields / square root of the peak, errors of interpolation / peak.
_FIELD_SHARE, _INTERPOLATION_SHARE = 1.0 / 32.0, 1.0 / 8.0
_LEAST = 2.0**-52  # smallest requested error, a rounding error
_MAX_ORDER = 2  # highest azimuthal order that the core supports

T = TypeVar("T")
# Key of the cached angles: layers, model of the emitter, ranges of depths and of foci, largest v, error of fields.
_AnglesKey = tuple[Layers, Model, tuple[float, float], tuple[float, float], float, float]


@dataclass(frozen=True)
class Stratified(DebyeWolf):
    r"""Certified stacks through plane layers by matrix products: the default for an :class:`lommel.Objective`.

    Supports the same pupils as :class:`lommel.methods.DebyeWolf`, with the same error bound. Fields at few radii are
    sums over angles, whose number follows from a proven error bound. Between these radii the intensity, which is of
    exponential type 2 in v, is interpolated with a proven error. For images that depend on the azimuth, samples are
    computed around any axis, and pixel integrals are computed from samples. Windows off the axis that extend beyond
    v = 110, and tolerances near rounding, are computed by the method of `DebyeWolf`.

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
    Angles and Bessel functions are cached for stacks of the same objective, wavelength, emitter and pixels, with
    depths and foci in about the same range.

    References
    ----------
    B. Richards and E. Wolf, Proc. R. Soc. Lond. A 253, 358 (1959), doi:10.1098/rspa.1959.0200.
    P. Torok et al., J. Opt. Soc. Am. A 12, 325 (1995), doi:10.1364/JOSAA.12.000325.
    """

    def profile(self, pupil: ObjectivePupil, v: Array) -> Intensities:
        """Return I at ascending v, with errors relative to the computed peak."""
        result = profiles(pupil, v, self.tol) if v.size else None
        if result is None:
            return super().profile(pupil, v)
        values, error = result
        least_peak = values[:, 0].max(axis=1) - error
        return Intensities(values[:, 0], error / least_peak, least_peak)

    def images(self, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Samples:
        """Return the images of the flattened stack; see :meth:`lommel.methods.Method.images`."""
        direct = not (wanted.terms or wanted.powers) and (pupil.radial or not grid.integrate)
        images = differentiated(pupil, grid, (), self.tol, wanted) if direct else None
        return super().images(pupil, grid, wanted) if images is None else images

    def _samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Samples:
        """Return point samples at the centres of the pixels of `grid`, to `tol` of the peak."""
        images = differentiated(pupil, grid, (), tol, wanted)
        return super()._samples(pupil, grid, tol, wanted) if images is None else images


class By(NamedTuple):
    """Derivative computed by the engine; see :class:`lommel.core.engine.LayeredSlopes`."""

    variable: int  # parameter of the derivative: a constant of the engine
    image_factor: Array | float = 0.0  # factor of I itself in the derivative, for each plane
    factor: float = 1.0


class _Accuracy(NamedTuple):
    """Requested errors of fields, and of the interpolation of I between radii."""

    field: float
    interpolation: float


def _refine(attempt: Callable[[_Accuracy], tuple[T | None, float]], pupil: ObjectivePupil, tol: float) -> T | None:
    """Refine until the relative error bound is at most `tol`; None if rounding prevents it or `attempt` returns None.

    `attempt` returns a result, or None, and the largest error bound relative to the peak.
    """
    peak = likely_peak(pupil)
    while True:
        # Powers of two, so that similar tolerances share angles and tables.
        field = max(_LEAST, 2.0 ** math.floor(math.log2(_FIELD_SHARE * tol * math.sqrt(peak))))
        interpolation = max(_LEAST, 2.0 ** math.floor(math.log2(_INTERPOLATION_SHARE * tol * peak)))
        result, worst_error = attempt(_Accuracy(field, interpolation))
        if result is None or worst_error <= tol:
            return result
        if field <= _LEAST:
            return None
        # The bound was too large because the peak was estimated too high.
        peak *= max(1e-6, min(0.25, 0.5 * tol / worst_error))


def profiles(pupil: ObjectivePupil, v: Array, tol: float) -> tuple[Array, Array] | None:
    """Return the azimuthal orders of I (n, orders, radii) at ascending v, and the error bound of their sum (n,).

    The bound is at most `tol` of the peak. None if the core does not support the emitter or the tolerance.
    """

    def attempt(accuracy: _Accuracy) -> tuple[tuple[Array, Array], float]:
        values, error = layered_profiles(layered(pupil, float(v[-1]), accuracy.field), v)
        least_peak = values[:, 0].max(axis=1) - error
        relative = np.divide(error, least_peak, out=np.full(least_peak.shape, np.inf), where=least_peak > 0.0)
        return (values, error), float(relative.max())

    return _refine(attempt, pupil, tol) if pupil.light.model.orders[0] == 0 else None


def differentiated(pupil: ObjectivePupil, grid: Grid, by: Sequence[By], tol: float, wanted: Wanted) -> Samples | None:
    """Return images with errors of at most `tol` of the peak, and their derivatives `by`.

    None if the engine does not support the window or the tolerance; see :func:`lommel.core.engine.layered_images`.
    """
    if not is_supported(pupil.light):
        return None
    step, largest_v = grid.step(pupil), grid._farthest * grid.step(pupil)
    window = Window(grid.shape, grid.axes, step)

    def attempt(accuracy: _Accuracy) -> tuple[Samples | None, float]:
        # Pixel averages are sums over more values of fields than samples are.
        field = accuracy.field / 2.0 if grid.integrate else accuracy.field
        slopes = None
        if by:
            errors = _derivative_errors(_angles_key(pupil, largest_v, field))
            variables = np.array([(derivative.variable, derivative.factor) for derivative in by])
            factors = np.stack([np.broadcast_to(derivative.image_factor, pupil.power.shape) for derivative in by])
            slopes = LayeredSlopes(variables, factors, errors)
        stack = layered(pupil, largest_v, field)
        images = layered_images(
            stack, window, accuracy.interpolation, wanted, integrate=grid.integrate, slopes=slopes
        )
        return images, 0.0 if images is None else float(images.bound.max())

    return _refine(attempt, pupil, tol)


def is_supported(light: Light) -> bool:
    """Return whether the core supports the light of an emitter: no vortices, and azimuthal orders up to 2."""
    return light.model.orders[0] == 0 and max(h.order for h in light.harmonics) <= _MAX_ORDER


def layered(pupil: ObjectivePupil, largest_v: float, tol: float) -> Layered:
    """Return a flattened stack in the layout of the core, with errors of fields below `tol` up to `largest_v`."""
    # One quadrature rule serves all planes in a range of depths and foci: certificate, section 15.
    rule, parts, rates = _angles(_angles_key(pupil, largest_v, tol))
    planes = np.stack([pupil.depth.ravel(), pupil.focus.ravel(), pupil.power])
    harmonics = pupil.light.harmonics
    azimuthal = np.array([[h.order, h.cosine, h.sine] for h in harmonics], dtype=np.float64)
    return Layered(rule.rho, parts, rates, rule.error, planes, np.stack([h.form for h in harmonics]), azimuthal)


def _angles_key(pupil: ObjectivePupil, largest_v: float, tol: float) -> _AnglesKey:
    """Return the key of the cached angles, with the ranges of depth and of focus minus paraxial focus."""
    depth, layers = pupil.depth.ravel(), pupil.layers
    # Section 15: in depth and focus, the range is a parallelogram.
    defocus = pupil.focus.ravel() - layers.immersion / layers.sample * depth
    return layers, pupil.light.model, _rounded_range(depth), _rounded_range(defocus), _rounded_up(largest_v), tol


def _rounded_range(values: Array) -> tuple[float, float]:
    """Return a range that contains the values, rounded outward by at most an eighth of its width, for cache hits."""
    low, high = float(values.min()), float(values.max())
    unit = 2.0 ** math.floor(math.log2(max(high - low, 4e-7) / 8.0))
    return unit * math.floor(low / unit), unit * math.ceil(high / unit)


def _rounded_up(largest_v: float) -> float:
    """Return the largest v rounded up by at most an eighth, for cache hits."""
    unit = 2.0 ** math.floor(math.log2(max(largest_v, 1.0) / 8.0))
    return unit * math.ceil(largest_v / unit)


def _corners(layers: Layers, depths: tuple[float, float], foci: tuple[float, float]) -> tuple[Array, Array]:
    """Return depth and focus at the four corners of the parallelogram of section 15."""
    depth = np.repeat(np.maximum(depths, 0.0), 2)
    return depth, layers.immersion / layers.sample * depth + np.tile(foci, 2)


@lru_cache(maxsize=32)
def _angles(key: _AnglesKey) -> tuple[Rule, Complex, Complex]:
    """Return the quadrature rule over angles, and its parts and rates as arrays."""
    layers, model, depths, foci, largest_v, tol = key
    rule = debye.rule(layers, model, *_corners(layers, depths, foci), largest_v, tol)
    return rule, np.stack(rule.parts), np.stack(rule.rates)


@lru_cache(maxsize=32)
def _derivative_errors(key: _AnglesKey) -> Array:
    """Return the errors of derivatives of fields computed with these angles."""
    (layers, model, depths, foci, largest_v, tol), (rule, _, _) = key, _angles(key)
    return debye.slope_errors(rule, layers, model, *_corners(layers, depths, foci), largest_v, tol)
