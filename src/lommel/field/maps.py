"""Field maps: wavefronts over the sensor, from known positions or Seidel coefficients; vignetting and shading."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from os import PathLike
from typing import Any

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import atomic, validation
from lommel.base.arrays import Array, Json, Numbers, numbers
from lommel.base.cached import EqualByContent
from lommel.base.options import Options, listed
from lommel.base.units import format_length
from lommel.channel_psf import colour_psf
from lommel.field.psf_grid import PSFGrid, sides
from lommel.optics.aperture.shapes import CatEye, Disc, Ellipse
from lommel.optics.colour.spectrum import Channels
from lommel.optics.lens import Lens
from lommel.optics.pupil import FieldPupil, Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF, psf
from lommel.special import zernike

Spectrum = float | Sequence[tuple[float, float]]

_MAX_STEPS = 50  # maximum number of steps of Broyden's method
_INVERSE_ERROR = 1e-10  # error of inverted positions, relative to the largest distance from the middle of the map


def spectrum_of(wavelength: Spectrum | None) -> tuple[tuple[float | None, float], ...]:
    """Return (wavelength, weight) pairs with weights that sum to 1; None for a wavelength means that of the map."""
    if wavelength is None:
        return ((None, 1.0),)
    if not isinstance(wavelength, Sequence | np.ndarray):
        return ((validation.wavelength(wavelength), 1.0),)
    values = validation.real_array("wavelength", wavelength, least=0.0)
    if values.ndim != 2 or values.shape[1] != 2 or not values[:, 1].sum() > 0.0:
        raise ValueError(
            f"wavelength must be a number, or pairs (wavelength, weight), got {validation.shown(wavelength)}"
        )
    total = values[:, 1].sum()
    return tuple((validation.wavelength(float(w)), float(weight / total)) for w, weight in values)


def shift_of(pupil: Pupil, spectrum: Sequence[tuple[float | None, float]]) -> tuple[Array, Array]:
    """Return the image shift along x and y due to the tilt of a pupil, averaged over a spectrum.

    A phase c rho cos(theta), c radians at the pupil edge, shifts the image by c lambda N / pi. If the path difference
    of the tilt does not depend on the wavelength, neither does the shift.
    """
    shift = np.zeros((2, *pupil.shape))
    for wavelength, weight in spectrum:
        at_wavelength = pupil if wavelength is None else pupil.in_light(wavelength)
        terms = at_wavelength.wavefront.edge_terms()
        for k, m in enumerate((1, -1)):
            shift[k] += weight * at_wavelength.scale / math.pi * terms.get((1, m), np.zeros(()))
    return shift[0], shift[1]


def inverse(
    x: Array,
    y: Array,
    displacement: Callable[[Array, Array], tuple[Array, Array]],
    contains: Callable[[Array, Array], NDArray[np.bool_]],
    middle: tuple[float, float],
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Invert a displacement by Broyden's method: return the undisplaced positions of (x, y), and a convergence mask.

    The displacement is defined on a convex set that contains `middle`; `contains` is a mask of positions in the set.
    Iterates outside the set are moved to its edge.
    """
    size = max(float(np.hypot(x - middle[0], y - middle[1]).max(initial=0.0)), np.finfo(float).tiny)
    # Initial guess: no displacement.
    position = np.stack(_move_inside(x, y, contains, middle), axis=-1)
    target = np.stack([x, y], axis=-1)
    # Broyden's method updates an approximate inverse Jacobian without derivatives of the displacement. The identity
    # is a good initial approximation, because distortion is small.
    jacobian_inverse = np.broadcast_to(np.eye(2), (*x.shape, 2, 2)).copy()
    residual = position + np.stack(displacement(position[..., 0], position[..., 1]), axis=-1) - target
    for _ in range(_MAX_STEPS):
        if np.abs(residual).max(initial=0.0) <= _INVERSE_ERROR * size:
            break
        updated = position - np.einsum("...ij,...j", jacobian_inverse, residual)
        updated = np.stack(_move_inside(updated[..., 0], updated[..., 1], contains, middle), axis=-1)
        step, previous_residual = updated - position, residual
        position = updated
        residual = position + np.stack(displacement(position[..., 0], position[..., 1]), axis=-1) - target
        row = np.einsum("...j,...ji", step, jacobian_inverse)
        predicted_step = np.einsum("...ij,...j", jacobian_inverse, residual - previous_residual)
        product = (step * predicted_step).sum(axis=-1)
        updatable = np.abs(product) > 0.1 * (step * step).sum(axis=-1)  # smaller divisors amplify rounding errors
        gain = np.divide(1.0, product, out=np.zeros(product.shape), where=updatable & (product != 0.0))
        # Sherman-Morrison formula: the inverse of the Jacobian after Broyden's rank-1 update.
        jacobian_inverse += gain[..., None, None] * (step - predicted_step)[..., :, None] * row[..., None, :]
    converged = np.asarray(np.abs(residual).max(axis=-1) <= 10.0 * _INVERSE_ERROR * size)
    return position[..., 0], position[..., 1], converged


def _move_inside(
    x: Array, y: Array, contains: Callable[[Array, Array], NDArray[np.bool_]], middle: tuple[float, float]
) -> tuple[Array, Array]:
    """Move positions outside a convex set to its edge, along the line to `middle`; return all positions."""
    outside = ~contains(x, y)
    if not outside.any():
        return x, y
    dx, dy = x[outside] - middle[0], y[outside] - middle[1]
    # 50 bisections reach almost the precision of float64.
    low, high = np.zeros(dx.shape), np.ones(dx.shape)
    for _ in range(50):
        fraction = 0.5 * (low + high)
        inside = contains(middle[0] + fraction * dx, middle[1] + fraction * dy)
        low, high = np.where(inside, fraction, low), np.where(inside, high, fraction)
    new_x, new_y = x.copy(), y.copy()
    new_x[outside], new_y[outside] = middle[0] + low * dx, middle[1] + low * dy
    return new_x, new_y


@dataclass(frozen=True, init=False)
class Vignetting:
    """Cat's-eye vignetting: a second circular stop that shifts across the aperture with field height.

    The pupil is the intersection of the aperture and the second circle. This circle shifts along the direction from
    the optical axis to the position on the sensor; its shift and radius are interpolated linearly between heights.

    Parameters
    ----------
    height : array_like, shape (n,)
        Distances from the axis on the sensor, increasing from 0, at least two.
    shift : array_like, shape (n,)
        Shift of the centre of the second circle, in radii of the aperture; 0 on the axis. A positive shift points
        towards the position on the sensor: the opposite side of the pupil is blocked.
    radius : float or array_like, shape (n,)
        Radius of the second circle, in radii of the aperture.

    Raises
    ------
    TypeError, ValueError
        If a number is not finite, heights do not increase from 0, or the circles do not overlap at a height.

    Examples
    --------
    >>> import lommel as lm
    >>> from lommel.field.maps import Vignetting
    >>> edges = Vignetting([0.0, 20e-3], shift=[0.0, 0.6], radius=1.2)
    >>> edges.at(10e-3, 0.0)
    CatEye(shift=(0.3, 0.0), radius=1.2)
    """

    height: tuple[float, ...]
    shift: tuple[float, ...]
    radius: tuple[float, ...]

    def __init__(self, height: ArrayLike, shift: ArrayLike, radius: ArrayLike = 1.0) -> None:
        heights = _heights(height)
        shifts = validation.real_array("shift", shift)
        radii = validation.real_array("radius", radius, least=1e-6)
        if shifts.shape != heights.shape or shifts[0] != 0.0:
            raise ValueError(f"shift must have a value for each height, the first 0, got {validation.shown(shift)}")
        if radii.shape not in ((), heights.shape):
            raise ValueError(f"radius must be a number, or a value for each height, got {validation.shown(radius)}")
        radii = np.broadcast_to(radii, heights.shape)
        vars(self).update(height=tuple(heights.tolist()), shift=tuple(shifts.tolist()), radius=tuple(radii.tolist()))
        for offset, circle_radius in zip(self.shift, self.radius, strict=True):
            CatEye((offset, 0.0), circle_radius)  # raises ValueError if no light passes

    def applied(self, pupil: Pupil, x: float, y: float) -> Pupil:
        """Return `pupil` with the vignetting at (`x`, `y`); ValueError beyond the last height."""
        return replace(pupil, vignetting=self.at(x, y))

    def at(self, x: float, y: float) -> CatEye | None:
        """Return the vignetting at (`x`, `y`), None for an unvignetted pupil; ValueError beyond the last height."""
        r = _require_height(math.hypot(x, y), self.height[-1])
        offset, circle_radius = (float(np.interp(r, self.height, values)) for values in (self.shift, self.radius))
        if abs(offset) + 1.0 <= circle_radius:  # the second circle contains the whole aperture
            return None
        direction = (x / r, y / r) if r > 0.0 else (1.0, 0.0)
        return CatEye((offset * direction[0], offset * direction[1]), circle_radius)


_MIN_ELLIPTICITY = 1e-5  # pupils with a smaller ellipticity are treated as circles, which all methods support


@dataclass(frozen=True, init=False)
class Foreshortening:
    """Elliptical pupils off the axis, due to foreshortening of the aperture.

    An alternative to :class:`Vignetting`. The ellipse is centred on the pupil axis. The tangential semi-axis `along`
    has the direction from the optical axis to the position on the sensor; the sagittal semi-axis `across` is
    perpendicular to this direction. Semi-axes are interpolated linearly in the squared height.

    Parameters
    ----------
    height : array_like, shape (n,)
        Distances from the axis on the sensor, increasing from 0, at least two.
    along, across : array_like, shape (n,)
        Semi-axes, in radii of the aperture: at least 0.001, at most 1. For a distant stop in front of a thin lens and
        the field angle theta, they are about ``cos(theta)**3`` and ``cos(theta)``.

    Raises
    ------
    TypeError, ValueError
        If a number is out of range, or heights do not increase from 0.

    Examples
    --------
    >>> import lommel as lm
    >>> from lommel.field.maps import Foreshortening
    >>> pupils = Foreshortening([0.0, 20e-3], along=[1.0, 0.8], across=[1.0, 0.9])
    >>> pupils.at(10e-3, 0.0)
    Ellipse(a=0.95, b=0.975, angle=0.0, center=(0.0, 0.0))
    """

    height: tuple[float, ...]
    along: tuple[float, ...]
    across: tuple[float, ...]

    def __init__(self, height: ArrayLike, along: ArrayLike, across: ArrayLike) -> None:
        heights = _heights(height)
        for name, value in (("along", along), ("across", across)):
            semi_axes = validation.real_array(name, value, least=1e-3, most=1.0)
            if semi_axes.shape != heights.shape:
                raise ValueError(f"{name} must have a value for each height, got {validation.shown(value)}")
            vars(self)[name] = tuple(semi_axes.tolist())
        vars(self)["height"] = tuple(heights.tolist())

    def at(self, x: float, y: float) -> Ellipse | None:
        """Return the elliptical pupil at (`x`, `y`), None if circular; ValueError beyond the last height."""
        r = _require_height(math.hypot(x, y), self.height[-1])
        # Interpolation is linear in r^2, because the semi-axes of a symmetric lens are even functions of height.
        squared_heights = np.square(self.height)
        a, b = (float(np.interp(r * r, squared_heights, semi_axes)) for semi_axes in (self.along, self.across))
        return None if min(a, b) > 1.0 - _MIN_ELLIPTICITY else Ellipse(a, b, math.atan2(y, x))

    def applied(self, pupil: Pupil, x: float, y: float) -> Pupil:
        """Return `pupil` foreshortened at (`x`, `y`); ValueError beyond the last height."""
        ellipse = self.at(x, y)
        return pupil if ellipse is None else foreshortened(pupil, ellipse)


def foreshortened(pupil: Pupil, ellipse: Ellipse) -> Pupil:
    """Return a circular or annular pupil foreshortened to an ellipse; its obscuration shrinks by the same factors."""
    eps = pupil.obscuration
    if eps == 0.0:
        return replace(pupil, vignetting=ellipse)
    stop = Disc() - Ellipse(eps * ellipse.a, eps * ellipse.b, ellipse.angle)
    return replace(pupil, obscuration=0.0, vignetting=ellipse, stop=stop)


@dataclass(frozen=True, init=False)
class Shading:
    """Relative illumination off the axis due to causes other than vignetting, for example the cos^4 law.

    Parameters
    ----------
    height : array_like, shape (n,)
        Distances from the axis on the sensor, increasing from 0, at least two.
    light : array_like, shape (n,)
        Illumination relative to the axis, above 0; the first value is 1. Measure it with the lens stopped down,
        without vignetting. Values are interpolated linearly between heights.

    Raises
    ------
    TypeError, ValueError
        If a number is not finite, heights do not increase from 0, or the first `light` is not 1.
    """

    height: tuple[float, ...]
    light: tuple[float, ...]
    distance: float | None

    def __init__(self, height: ArrayLike, light: ArrayLike) -> None:
        heights, values = _heights(height), validation.real_array("light", light, least=1e-12)
        if values.shape != heights.shape or values[0] != 1.0:
            raise ValueError(f"light must have a value for each height, the first 1, got {validation.shown(light)}")
        vars(self).update(height=tuple(heights.tolist()), light=tuple(values.tolist()), distance=None)

    @classmethod
    def cos4(cls, distance: float) -> Shading:
        """Return the shading ``cos(theta)^4``, where ``tan(theta)`` is the height divided by `distance`.

        Parameters
        ----------
        distance : float
            Distance from the exit pupil to the sensor, in the unit of heights; for a thin :class:`lommel.Lens` it is
            `sensor_distance`.

        Raises
        ------
        TypeError, ValueError
            If `distance` is not a number above 0.

        References
        ----------
        D. S. Goodman, "General principles of geometric optics", in Handbook of Optics, McGraw-Hill (1995), ch. 1.
        """
        # A placeholder table that passes the checks; cos^4 is computed from the distance.
        shading = cls([0.0, 1.0], [1.0, 1.0])
        vars(shading).update(height=(), light=(), distance=validation.real("distance", distance, above=0.0))
        return shading

    def at(self, x: Array, y: Array) -> Array:
        """Return the relative illumination at (`x`, `y`); ValueError beyond the last height."""
        r = np.hypot(x, y)
        if self.distance is not None:
            return np.asarray((1.0 + (r / self.distance) ** 2) ** -2.0)
        _require_height(float(r.max(initial=0.0)), self.height[-1])
        return np.asarray(np.interp(r, self.height, self.light))


def _heights(height: ArrayLike) -> Array:
    heights = _increasing_array("height", height)
    if heights[0] != 0.0:
        raise ValueError(f"height must begin with 0, the axis, got {heights[0]:g}")
    return heights


def _require_height(r: float, last_height: float) -> float:
    # The distance r may exceed the last height by rounding errors.
    if r > last_height * (1.0 + 1e-12):
        raise ValueError(f"the position {r:.6g} from the axis lies beyond the last height, {last_height:.6g}")
    return r


def positions(x: ArrayLike, y: ArrayLike, unit: str) -> tuple[Array, Array]:
    """Return positions on the sensor as arrays, broadcast to the same shape."""
    x_values, y_values = (validation.real_array(name, part, unit=unit) for name, part in (("x", x), ("y", y)))
    x_values, y_values = validation.broadcast("x and y", x_values, y_values)
    return x_values, y_values


@dataclass(frozen=True, kw_only=True)
class ApertureOptions(Options):
    """Options that define the aperture.

    Parameters
    ----------
    aperture : Pupil, optional
        Pupil without wavefront error, such as ``lens.pupil(2.0).unaberrated()``. Its obscuration, spider, vignetting,
        mask, stop, apodization and scale apply to the whole field; its `geometry` is ignored.
    wavelength, f_number, obscuration : float, optional
        See :class:`lommel.Pupil`; required only if `aperture` does not define them.
    """

    aperture: Pupil | None = None
    wavelength: float | None = None
    f_number: float | None = None
    obscuration: float | None = None


def bare_pupil(constructor: str, given: Json) -> Pupil:
    """Return the pupil without wavefront that a constructor's options define; raise TypeError or ValueError."""
    o = ApertureOptions.of(f"FieldMap.{constructor}", None, given)
    named = {"wavelength": o.wavelength, "f_number": o.f_number, "obscuration": o.obscuration}
    numeric: Json = {name: value for name, value in named.items() if value is not None}
    if (aperture := o.aperture) is None:
        return Pupil(**numeric)
    if not validation.instance("aperture", aperture, Pupil).wavefront.flat:
        raise ValueError(
            "aperture must have a flat wavefront, because the map defines the wavefronts: pass "
            "aperture.unaberrated(), and add its wavefront to the map if required (field + wavefront)"
        )
    for name, value in numeric.items():
        if (pupil_value := getattr(aperture, name)) not in (None, value):
            raise ValueError(f"{name} must be that of the aperture, {pupil_value:g}, or left out, got {value!r}")
    return replace(aperture, geometry=None, **numeric)


@dataclass(frozen=True)
class FieldMap:
    """Wavefronts over the sensor, interpolated between known positions, without extrapolation.

    Constructors are :meth:`on_grid`, :meth:`scattered`, :meth:`radial` and :meth:`from_seidel`. All constructors have
    the same options for the aperture, and raise TypeError or ValueError if numbers are out of range, positions repeat
    or have a wrong shape, or the number of wavefronts differs from the number of positions. Positions (x, y) are
    measured from the optical axis, x along columns to the right and y along rows downwards, in metres if the map has
    a wavelength, else in units of lambda*N. The interpolated quantities are Zernike coefficients.

    ``field + wavefront`` adds a wavefront at every position, for example the defocus of an object.

    Attributes
    ----------
    pupil_without_wavefront : Pupil
        The pupil on the axis; it also applies off the axis if there is no vignetting.
    vignetting : Vignetting, Foreshortening or None
        Change of the aperture off the axis; see :meth:`seen_through`.
    shading : Shading or None
        Loss of light off the axis in addition to vignetting; it does not change PSFs.

    Notes
    -----
    The reference sphere of each wavefront is centred on the position of the wavefront on the sensor. A tilt therefore
    shifts the PSF away from this position.

    Examples
    --------
    >>> field = FieldMap.from_seidel(20e-3, W131=2.0, W222=1.0, wavelength=550e-9, f_number=2.8)
    >>> field.pupil(10e-3, 0.0).wavefront == Wavefront.from_seidel(W131=2.0, W222=1.0, field=(0.5, 0.0))
    True
    """

    pupil_hint = "a FieldMap; field.pupil(x, y) is the pupil at a position"

    pupil_without_wavefront: Pupil
    _wavefronts: WavefrontsOnSensor
    _added_wavefront: Wavefront
    vignetting: Vignetting | Foreshortening | None = None
    shading: Shading | None = None

    @classmethod
    @listed(ApertureOptions)
    def on_grid(cls, x: ArrayLike, y: ArrayLike, wavefront: Wavefront, **given: Any) -> FieldMap:
        """Build a map from wavefronts on a rectangular grid, by bicubic splines.

        Parameters
        ----------
        x, y : array_like, shapes (columns,) and (rows,)
            Positions, increasing, at least two along each axis. Splines are linear along an axis with two positions,
            quadratic along an axis with three.
        wavefront : Wavefront of shape (rows, columns)
            Wavefront at each position.
        {options}
        """
        return cls(bare_pupil("on_grid", given), OnGrid(x, y, wavefront), Wavefront())

    @classmethod
    @listed(ApertureOptions)
    def scattered(cls, x: ArrayLike, y: ArrayLike, wavefront: Wavefront, **given: Any) -> FieldMap:
        """Build a map from wavefronts at scattered positions, by cubic radial basis functions and a polynomial.

        The polynomial is quadratic if the positions determine its six coefficients, otherwise linear. A quadratic
        polynomial reproduces third-order field curvature, astigmatism and coma exactly. The map ends at the convex
        hull of the positions.

        Parameters
        ----------
        x, y : array_like, shape (n,)
            3 to 4000 distinct positions, not all on one line.
        wavefront : Wavefront of shape (n,)
            Wavefront at each position.
        {options}
        """
        return cls(bare_pupil("scattered", given), Scattered(x, y, wavefront), Wavefront())

    @classmethod
    @listed(ApertureOptions)
    def radial(cls, height: ArrayLike, wavefront: Wavefront, *, azimuth: float = 0.0, **given: Any) -> FieldMap:
        """Build a map of a rotationally symmetric lens from wavefronts along one direction of the field.

        Coefficients are cubic splines of the field height: even functions for even azimuthal order m and odd
        functions for odd m, as symmetry requires. Wavefronts at other azimuths are exact rotations. Three heights
        suffice to reproduce third-order aberrations exactly.

        Parameters
        ----------
        height : array_like, shape (n,)
            Distances from the axis, increasing from 0, at least two.
        wavefront : Wavefront of shape (n,)
            Wavefront at each height. The first, on the axis, must be radially symmetric (to 1e-6 rad), the others
            symmetric about the direction of the positions: only cosines along x, for example.
        azimuth : float, default 0
            Direction in radians from the axis to the positions: 0 along x, pi / 2 along y (downwards in an image).
        {options}
        """
        return cls(bare_pupil("radial", given), Radial(height, wavefront, azimuth), Wavefront())

    @classmethod
    @listed(ApertureOptions)
    def from_seidel(
        cls,
        edge: float,
        *,
        W020: float = 0.0,
        W040: float = 0.0,
        W060: float = 0.0,
        W080: float = 0.0,
        W131: float = 0.0,
        W222: float = 0.0,
        W220: float = 0.0,
        W311: float = 0.0,
        **given: Any,
    ) -> FieldMap:
        """Build a map from Seidel coefficients in waves at the edge of the field.

        Parameters
        ----------
        edge : float
            Field height to which the coefficients refer (relative height H = 1); the map ends there.
        W020, W040, W060, W080, W131, W222, W220, W311 : float
            See :meth:`lommel.Wavefront.from_seidel`, which is evaluated at each position.
        {options}
        """
        waves = {"W020": W020, "W040": W040, "W060": W060, "W080": W080}
        waves |= {"W131": W131, "W222": W222, "W220": W220, "W311": W311}
        return cls(bare_pupil("from_seidel", given), Seidel(edge, waves), Wavefront())

    @property
    def unit(self) -> str:
        """Unit of positions: ``"m"`` or ``"lambda*N"``."""
        return self.pupil_without_wavefront.unit

    @property
    def seidel(self) -> dict[str, float]:
        """Seidel coefficients (waves) at :attr:`reach`; empty unless the map was made by :meth:`from_seidel`."""
        return dict(self._wavefronts.waves) if isinstance(self._wavefronts, Seidel) else {}

    @property
    def reach(self) -> float:
        """Distance from the axis to the farthest position in the map."""
        return self._wavefronts.reach

    def __repr__(self) -> str:
        return f"<FieldMap, {self._wavefronts.limits(self.unit)}>"

    def __add__(self, wavefront: object) -> FieldMap:
        """Return the map with one wavefront added everywhere."""
        if not isinstance(wavefront, Wavefront):
            return NotImplemented
        if wavefront.shape != ():
            raise ValueError(f"a single wavefront can be added to a map, got a stack of shape {wavefront.shape}")
        return replace(self, _added_wavefront=self._added_wavefront + wavefront)

    def pupil(self, x: ArrayLike, y: ArrayLike) -> Pupil:
        """Return the pupil at the position (x, y) of the sensor, or a stack of pupils for arrays of positions.

        Parameters
        ----------
        x, y : array_like
            Positions, in :attr:`unit`, of broadcastable shapes.

        Returns
        -------
        Pupil
            Stack with the broadcast shape of the positions.

        Raises
        ------
        TypeError, ValueError
            If a position is not finite or lies outside the map; or for several positions of a map with vignetting.
        """
        x_values, y_values = positions(x, y, self.unit)
        if x_values.size == 0:
            raise ValueError(f"x and y must not be empty, got shape {x_values.shape}")
        outside = ~self._wavefronts.contains(x_values, y_values)
        if outside.any():
            position = f"({x_values[outside].flat[0]:.6g}, {y_values[outside].flat[0]:.6g}) {self.unit}"
            limits = self._wavefronts.limits(self.unit)
            raise ValueError(f"position (x, y) = {position} lies outside of the map, {limits}")
        wavefront = self._wavefronts.wavefront(x_values, y_values) + self._added_wavefront
        base = self.pupil_without_wavefront
        pupil = replace(base, wavefront=wavefront, colour=base.colour and base.colour.at(x_values, y_values))
        if self.vignetting is None:
            return pupil
        if x_values.shape != ():
            raise ValueError("x and y must be one position if vignetting changes the aperture; psf accepts arrays")
        return self.vignetting.applied(pupil, float(x_values), float(y_values))

    def displacement(self, x: ArrayLike, y: ArrayLike, wavelength: Spectrum | None = None) -> tuple[Array, Array]:
        """Return the image displacement due to wavefront tilt at positions (x, y): distortion and lateral colour.

        Parameters
        ----------
        x, y : array_like
            Positions without distortion, in :attr:`unit`, of broadcastable shapes.
        wavelength : float or sequence of (float, float), optional
            Wavelength (metres), or pairs of wavelength and weight for a weighted mean displacement; by default the
            wavelength of the map. Lateral colour is defined by the lens from which `aperture` was derived
            (:class:`lommel.Colour`).

        Returns
        -------
        dx, dy : ndarray
            Displacement in :attr:`unit`. The conversion from tilt is exact: a phase ``c rho cos(theta)`` shifts a PSF
            by ``c lambda N / pi`` and does not change the shape of the PSF.

        Raises
        ------
        TypeError, ValueError
            If a position lies outside the map, or a wavelength outside the range of the lens's colour data.

        Examples
        --------
        >>> field = lm.FieldMap.from_seidel(20e-3, W311=-400.0, wavelength=500e-9, f_number=4.0)  # barrel distortion
        >>> dx, dy = field.displacement(20e-3, 0.0)
        >>> round(1e3 * float(dx), 6)  # 2 W311 lambda N, -8 % of 20 mm
        -1.6
        """
        x_values, y_values = positions(x, y, self.unit)
        unvignetted = replace(self, vignetting=None)
        return shift_of(unvignetted.pupil(x_values, y_values), spectrum_of(wavelength))

    def undistorted(self, x: ArrayLike, y: ArrayLike, wavelength: Spectrum | None = None) -> tuple[Array, Array]:
        """Return the undistorted positions of the image points at (x, y): the inverse of `displacement`.

        Parameters
        ----------
        x, y : array_like
            Positions on the sensor, in :attr:`unit`, of broadcastable shapes.
        wavelength : float or sequence of (float, float), optional
            See :meth:`displacement`.

        Returns
        -------
        x, y : ndarray
            Undistorted positions. With the displacement added they agree with (x, y) within 1e-9 times the largest
            distance of (x, y) from the middle of the map.

        Raises
        ------
        TypeError, ValueError
            See :meth:`displacement`. Also if an undistorted position lies outside the map, or if the iteration does
            not converge because of strong distortion.

        Examples
        --------
        >>> field = lm.FieldMap.from_seidel(20e-3, W311=-400.0, wavelength=500e-9, f_number=4.0)
        >>> x, y = field.undistorted(18.4e-3, 0.0)
        >>> round(1e3 * float(x), 6)
        20.0
        """
        x_values, y_values = positions(x, y, self.unit)
        spectrum, unvignetted = spectrum_of(wavelength), replace(self, vignetting=None)

        def shift(x: Array, y: Array) -> tuple[Array, Array]:
            return shift_of(unvignetted.pupil(x, y), spectrum)

        points, wavefronts = [np.atleast_1d(values) for values in (x_values, y_values)], self._wavefronts
        x_map, y_map, converged = inverse(points[0], points[1], shift, wavefronts.contains, wavefronts.middle)
        if not converged.all():
            point = tuple(float(values[~converged].flat[0]) for values in points)
            raise ValueError(
                f"position (x, y) = ({point[0]:.6g}, {point[1]:.6g}) {self.unit} must come from within the map, "
                f"{wavefronts.limits(self.unit)}, and from one position only: distortion must not fold the image"
            )
        return x_map.reshape(x_values.shape), y_map.reshape(x_values.shape)

    def untilted(self, x: ArrayLike, y: ArrayLike, wavelength: Spectrum | None = None) -> Pupil:
        """Return the pupil of the image point at (x, y), without the tilt that displaces it.

        A PSF of this pupil, centred at (x, y), is equal to the PSF of the map centred at the undistorted position.

        Parameters
        ----------
        x, y, wavelength
            See :meth:`undistorted`.

        Returns
        -------
        Pupil
            Pupil at the wavelength of the map; a stack with the shape of the positions.

        Raises
        ------
        TypeError, ValueError
            See :meth:`undistorted` and :meth:`pupil`.
        """
        pupil = self.pupil(*self.undistorted(x, y, wavelength))
        dx, dy = (-math.pi / pupil.scale * shift for shift in shift_of(pupil, spectrum_of(wavelength)))
        return pupil.carrying(pupil.wavefront + Wavefront.from_edge({(1, 1): dx, (1, -1): dy}), None)

    def seen_through(
        self, vignetting: Vignetting | Foreshortening | None = None, shading: Shading | None = None
    ) -> FieldMap:
        """Return the map with other vignetting (or elliptical pupils) and shading off the axis.

        Parameters
        ----------
        vignetting : Vignetting or Foreshortening, optional
            Change of the pupil off the axis.
        shading : Shading, optional
            Relative illumination; it changes :meth:`illumination`, but no PSF.

        Raises
        ------
        TypeError, ValueError
            If an argument is of the wrong type, the aperture already has vignetting, or a Foreshortening is combined
            with an aperture that is not circular or annular. Also if `vignetting` is None and the map has a
            Foreshortening, because the wavefronts of the map are defined on ellipses.
        """
        validation.optional("shading", shading, Shading)
        if not isinstance(vignetting, Foreshortening):
            validation.optional("vignetting", vignetting, Vignetting)
        elif not self.pupil_without_wavefront.circular:
            raise ValueError(
                "vignetting must not be a Foreshortening unless the aperture is circular or annular: spiders, masks "
                "and stops would not be foreshortened"
            )
        if vignetting is None and isinstance(self.vignetting, Foreshortening):
            raise ValueError(
                "vignetting must be that of the map, field_map.vignetting, because the wavefronts of the map are "
                "defined on elliptical pupils; for circular pupils make the map with circular=True"
            )
        if vignetting is not None and self.pupil_without_wavefront.vignetting is not None:
            raise ValueError("vignetting must be left out, because the aperture already has vignetting of its own")
        return replace(self, vignetting=vignetting, shading=shading)

    def illumination(self, x: ArrayLike, y: ArrayLike) -> Numbers:
        """Return the relative illumination of a uniform scene at positions (x, y) of the sensor.

        Parameters
        ----------
        x, y : array_like
            Positions, in :attr:`unit`; they broadcast.

        Returns
        -------
        float or ndarray
            Pupil transmission divided by the transmission on the axis, times the shading.

        Raises
        ------
        TypeError, ValueError
            If a position is not finite, or lies beyond the last height of the vignetting or the shading.
        """
        x_values, y_values = positions(x, y, self.unit)
        illumination = np.ones(x_values.shape) if self.shading is None else self.shading.at(x_values, y_values)
        if self.vignetting is not None:
            points = [(0.0, 0.0), *zip(x_values.ravel().tolist(), y_values.ravel().tolist(), strict=True)]
            base, vignetting = self.pupil_without_wavefront, self.vignetting
            on_axis, *transmissions = (vignetting.applied(base, *point).transmission for point in points)
            illumination = illumination * np.reshape(transmissions, x_values.shape) / on_axis
        return numbers(illumination, x_values.shape)

    def working_f_number(self, x: ArrayLike, y: ArrayLike) -> Numbers:
        """Return the working f-number at positions (`x`, `y`): ``N / sqrt(illumination)``, N: f-number of the map.

        Raise the errors of :meth:`illumination`, and ValueError for a map without an f-number.
        """
        if (f_number := self.pupil_without_wavefront.f_number) is None:
            raise ValueError("f_number must be known for a working f-number: make the map with an f_number")
        return f_number / np.sqrt(self.illumination(x, y))

    def psf(
        self,
        x: ArrayLike,
        y: ArrayLike,
        shape: int | tuple[int, int],
        pixel: float | tuple[float, float],
        **options: Any,
    ) -> PSF:
        """Compute the PSF at a position of the sensor, or a stack of PSFs for arrays of positions.

        Parameters
        ----------
        x, y : array_like
            Positions, in :attr:`unit`, of broadcastable shapes. Each window is centred on its position.
        shape, pixel, options
            See :func:`lommel.psf`.

        Returns
        -------
        PSF

        Raises
        ------
        TypeError, ValueError
            See :meth:`pupil` and :func:`lommel.psf`.
        """
        x_values, y_values = positions(x, y, self.unit)
        if self.vignetting is None or x_values.shape == ():
            return psf(self.pupil(x, y), shape, pixel, **options)
        pupils = tuple(self.pupil(float(a), float(b)) for a, b in zip(x_values.flat, y_values.flat, strict=True))
        return psf(FieldPupil(pupils, x_values.shape), shape, pixel, **options)

    def grid(
        self,
        rows: int,
        columns: int,
        *,
        sensor: tuple[float, float],
        shape: int | tuple[int, int],
        pixel: float | tuple[float, float],
        illuminated: bool = False,
        channels: Channels | Sequence[float] | None = None,
        depths: ArrayLike | None = None,
        lens: Lens | None = None,
        **options: Any,
    ) -> PSFGrid:
        """Compute PSFs at the centres of rows x columns equal cells, optionally for several distances and channels.

        Parameters
        ----------
        rows, columns : int
            Numbers of cells, 1 to 1000 each.
        sensor : (float, float)
            Height and width of the sensor, centred on the axis, in the unit of positions.
        shape, pixel, options
            See :meth:`psf`.
        illuminated : bool, default False
            Multiply the values of each PSF by the :meth:`illumination` at its position.
        channels : Channels or sequence of float, optional
            See :func:`lommel.colour_psf`. The lens of `aperture` defines the lateral and axial colour.
        depths : array_like, shape (k,), optional
            Distances of the object from the lens, metres; may be infinite.
        lens : Lens, optional
            Lens that defines the defocus at the distances. It must have no aberrations, because the map defines them.

        Raises
        ------
        TypeError, ValueError
            See :meth:`psf` and :func:`lommel.colour_psf`; also if a centre lies outside the map, if only one of
            `depths` and `lens` is given, or if the wavelength of the lens is not that of the map.
        """
        if (depths is None) != (lens is None):
            name = "lens" if lens is None else "depths"
            raise ValueError(f"{name} is missing: pass depths and lens together, because the lens defines defocus")
        counts = [validation.integer(n, v, least=1, most=1000) for n, v in (("rows", rows), ("columns", columns))]
        height_width = sides(sensor, self.unit)
        # The positions are exactly symmetric: for an odd number of cells, the centre of one lies exactly on the axis.
        y, x = (np.asarray(s / n * (np.arange(n) - 0.5 * (n - 1))) for s, n in zip(height_width, counts, strict=True))
        weighted = validation.truth("illuminated", illuminated)
        stack_options = [name for name, value in (("channels", channels), ("depths", depths)) if value is not None]
        if stack_options and (self.vignetting is not None or weighted):
            raise ValueError(
                f"{' and '.join(stack_options)} must be left out if vignetting changes the aperture or illuminated "
                "is True; compute each channel separately, or multiply by illumination(x, y)"
            )
        if not stack_options:
            psfs = self.psf(x, y[:, None], shape, pixel, **options)
            if weighted:
                weight = np.asarray(self.illumination(x, y[:, None]))
                factor = weight[..., None, None].astype(psfs.values.dtype)
                derivatives = {name: derivative * factor for name, derivative in psfs.derivatives.items()}
                psfs = replace(psfs, values=psfs.values * factor, scale=psfs.scale * weight, derivatives=derivatives)
            return PSFGrid(psfs, x, y, height_width)
        pupil, distances = self.pupil(x, y[:, None]), None
        if depths is not None and lens is not None:
            pupil = at_depths(pupil, lens, depths)
            distances = np.atleast_1d(np.asarray(depths, dtype=np.float64))
        if channels is None:
            return PSFGrid(psf(pupil, shape, pixel, **options), x, y, height_width, distances)
        return PSFGrid(colour_psf(pupil, shape, pixel, channels, **options), x, y, height_width, distances)

    def save(self, path: str | PathLike[str]) -> None:
        """Write the wavefronts as a CSV table for ``[field] file =`` of a lens file.

        Parameters
        ----------
        path : path
            Path of the file, ending in .csv.

        Raises
        ------
        ValueError
            If `path` does not end in .csv, positions are not in metres, pupils are elliptical, or a wavefront without
            radial symmetry was added to a map of :meth:`radial` or :meth:`from_seidel`.
        OSError
            If the file cannot be written.

        Notes
        -----
        Coefficients are in waves rms, by Noll's index, at the positions from which the map is interpolated. A comment
        states wavelength and f-number, which the lens file has to state, with the rest of the aperture. Vignetting
        and shading are not written: ``[field.vignetting]`` and ``[field.shading]`` state them.

        Examples
        --------
        >>> field = FieldMap.from_seidel(20e-3, W131=2.0, W222=1.0, wavelength=550e-9, f_number=2.8)
        >>> field.save("field.csv")
        """
        base, wavefronts = self.pupil_without_wavefront, self._wavefronts
        if base.wavelength is None or base.f_number is None:
            raise ValueError("save requires positions in metres: make the map with a wavelength and an f_number")
        if isinstance(self.vignetting, Foreshortening):
            raise ValueError(
                "save requires circular pupils, because tables cannot hold ellipses: make the map with "
                "circular=True, which is less accurate off the axis"
            )
        nodes = wavefronts.nodes()
        if "height" in nodes and self._added_wavefront.nonradial:
            raise ValueError(
                "save requires a rotationally symmetric map, because its table has heights, but a wavefront without "
                "this symmetry was added: save the map without it, and state it in [aberrations] of the lens file"
            )
        x, *y = nodes.values()
        added = wavefronts.wavefront(x, *y or [np.zeros(x.shape)]) + self._added_wavefront
        comments = [f"wavelength {format_length(base.wavelength)}, working f-number {base.f_number:.9g}"]
        save_table(path, nodes, added, comments)


def save_table(
    path: str | PathLike[str],
    nodes: Mapping[str, Array],
    wavefront: Wavefront,
    comments: Iterable[str],
    indices: Iterable[int] | None = None,
) -> None:
    """Write a stack of wavefronts at `nodes`, coordinates in metres by name; by default the terms that are not 0."""
    target = validation.path("path", path)
    if target.suffix.lower() != ".csv":
        raise ValueError(f"path must end in .csv, got {validation.shown(str(path))}")
    waves = wavefront.to_zernike(order="noll", unit="waves")
    count = len(next(iter(nodes.values())))
    columns = {f"Z{j}": np.broadcast_to(waves.get(j, 0.0), count) for j in sorted(indices or waves or (4,))}
    lines = [*(f"# {comment}" for comment in comments), ",".join([*nodes, *columns])]
    for row in zip(*nodes.values(), *columns.values(), strict=True):
        places, values = row[: len(nodes)], row[len(nodes) :]
        lines.append(",".join([*(f"{place:.9g} m" for place in places), *(f"{value:.9g}" for value in values)]))
    atomic.write(target, "\n".join([*lines, ""]).encode())


def require_one_aperture(field_map: FieldMap) -> None:
    """Raise ValueError if the aperture changes over the field, which field-dependent blurs do not support."""
    if isinstance(field_map.vignetting, Foreshortening):
        raise ValueError(
            "field_map must have the same pupil over the field, because field-dependent blurs do not support "
            "elliptical pupils: make the map with circular=True, which is less accurate off the axis"
        )
    if field_map.vignetting is not None:
        raise ValueError(
            "field_map must have no vignetting, which a blur that varies over the field does not support: pass "
            "field_map.seen_through(None, shading), where shading is the whole relative illumination"
        )


def require_light(map_pupil: Pupil, lens: Lens) -> None:
    """Raise ValueError unless the lens has no aberrations and the wavelength, f-number and aperture of a map."""
    if not lens.aberrations.flat:
        raise ValueError("lens must have no aberrations: add them to the map, which defines all aberrations")
    lens_pupil = lens.pupil(1.0).unaberrated()
    for name, lens_value, map_value in (
        ("wavelength", lens_pupil.wavelength, map_pupil.wavelength),
        ("working f-number", lens_pupil.f_number, map_pupil.f_number),
        ("aperture", lens_pupil.aperture, map_pupil.aperture),
    ):
        if lens_value != map_value:
            raise ValueError(
                f"lens must have the {name} of the map, {map_value}, got {lens_value}; make the map with "
                "aperture=lens.pupil(1.0).unaberrated()"
            )


def at_depths(pupil: Pupil, lens: Lens, depths: ArrayLike) -> Pupil:
    """Return pupils with the defocus of a lens at k object distances; their shape is ``pupil.shape + (k,)``."""
    validation.instance("lens", lens, Lens)
    require_light(pupil, lens)
    distances = np.atleast_1d(np.asarray(depths))
    if distances.ndim != 1:
        raise ValueError(f"depths must be of shape (k,), got {distances.shape}")
    defocused, shape = lens.pupil(distances), (*pupil.shape, distances.size)
    pupils = pupil[(..., None)].broadcast(shape)
    geometry = defocused.geometry
    assert geometry is not None
    repeated_distances = tuple(np.broadcast_to(distances, shape).ravel().tolist())
    return replace(
        pupils,
        wavefront=pupils.wavefront + defocused.wavefront,
        geometry=replace(geometry, object_distance=repeated_distances),
        colour=pupils.colour or defocused.colour,
    )


MAX_SCATTERED = 4000
"""Maximum number of scattered positions: the interpolation solves a dense linear system of this size."""

_ROUNDING = 1e-9  # a position outside the map by less than this fraction of the map's size counts as inside
_AXIS = 1e-6  # on the axis, smaller coefficients (radians) of terms with m != 0 are treated as rounding errors


class WavefrontsOnSensor(EqualByContent, ABC):
    """Wavefronts as a function of position, within a convex part of the sensor."""

    reach: float
    """Distance of the farthest position from the axis."""

    middle: tuple[float, float] = (0.0, 0.0)
    """A position inside the map."""

    given: tuple[object, ...]
    """The arguments, hashable."""

    def _content(self) -> tuple[object, ...]:
        return self.given

    def contains(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """Return a mask of the positions inside the map; the default map is a disc around the axis."""
        return np.asarray(np.hypot(x, y) <= self.reach * (1.0 + _ROUNDING))

    def limits(self, unit: str) -> str:
        """Return the limits of the map as part of a message."""
        return f"which reaches {self.reach:.6g} {unit} from the axis"

    def nodes(self) -> dict[str, Array]:
        """Return coordinates of positions that determine the map, by name: height, or x and y."""
        return {"height": self.reach * np.linspace(0.0, 1.0, 9)}

    @abstractmethod
    def wavefront(self, x: Array, y: Array) -> Wavefront:
        """Return the wavefronts at positions inside the map, a stack of the shape of `x` and `y`."""


class OnGrid(WavefrontsOnSensor):
    """Bicubic splines through a rectangular grid (FITPACK, not-a-knot)."""

    def __init__(self, x: ArrayLike, y: ArrayLike, wavefront: Wavefront) -> None:
        self.x, self.y = _increasing_array("x", x), _increasing_array("y", y)
        values, self.terms = _coefficients_and_terms(wavefront, (self.y.size, self.x.size), "(len(y), len(x))")
        self.given = self.x.tobytes(), self.y.tobytes(), wavefront
        degrees = {"kx": min(3, self.y.size - 1), "ky": min(3, self.x.size - 1)}
        # Positions are scaled to 0 to 1, because FITPACK uses absolute tolerances.
        y_scaled, x_scaled = self._scaled(self.x, self.y)[::-1]
        tables = np.moveaxis(values, -1, 0)
        self.splines = [
            scipy.interpolate.RectBivariateSpline(y_scaled, x_scaled, table, **degrees, s=0) for table in tables
        ]
        self.reach = float(np.hypot(np.abs(self.x).max(), np.abs(self.y).max()))
        self.middle = float(self.x[[0, -1]].mean()), float(self.y[[0, -1]].mean())

    def _scaled(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Return positions divided by the extent of the grid, from 0 at the first to 1 at the last grid position."""
        pairs = ((x, self.x), (y, self.y))
        x_scaled, y_scaled = (np.clip((part - nodes[0]) / (nodes[-1] - nodes[0]), 0.0, 1.0) for part, nodes in pairs)
        return x_scaled, y_scaled

    def contains(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """Return a mask of positions inside the rectangle."""
        inside = np.ones(x.shape, dtype=np.bool_)
        for part, nodes in ((x, self.x), (y, self.y)):
            slack = _ROUNDING * (nodes[-1] - nodes[0])
            inside &= (part >= nodes[0] - slack) & (part <= nodes[-1] + slack)
        return inside

    def limits(self, unit: str) -> str:
        """Return the ranges of x and y of the rectangle, as part of a message."""
        return f"x from {_span(self.x)} and y from {_span(self.y)} {unit}"

    def nodes(self) -> dict[str, Array]:
        """Return the positions of the grid."""
        x, y = np.meshgrid(self.x, self.y)
        return {"x": x.ravel(), "y": y.ravel()}

    def wavefront(self, x: Array, y: Array) -> Wavefront:
        """Return the wavefronts, of the shape of x and y."""
        x_scaled, y_scaled = self._scaled(x, y)
        return Wavefront.trusted(self.terms, np.stack([s.ev(y_scaled, x_scaled) for s in self.splines], axis=-1))


class Scattered(WavefrontsOnSensor):
    """Cubic radial basis functions and a quadratic or linear polynomial, within the convex hull of the positions."""

    def __init__(self, x: ArrayLike, y: ArrayLike, wavefront: Wavefront) -> None:
        x_values, y_values = validation.real_array("x", x), validation.real_array("y", y)
        if x_values.ndim != 1 or x_values.shape != y_values.shape:
            raise ValueError(f"x and y must be of the same shape (n,), got {x_values.shape} and {y_values.shape}")
        count = validation.integer("the number of positions", x_values.size, least=3, most=MAX_SCATTERED)
        values, self.terms = _coefficients_and_terms(wavefront, (count,), "of x and y")
        self.given = x_values.tobytes(), y_values.tobytes(), wavefront
        order = np.lexsort((y_values, x_values))
        is_repeated = (np.diff(x_values[order]) == 0.0) & (np.diff(y_values[order]) == 0.0)
        if is_repeated.any():
            k = order[np.flatnonzero(is_repeated)[0]]
            raise ValueError(f"positions must all be different, got ({x_values[k]:.6g}, {y_values[k]:.6g}) twice")
        self.x, self.y = x_values, y_values
        self.middle = float(x_values.mean()), float(y_values.mean())
        self.size = float(max(np.ptp(x_values), np.ptp(y_values)))
        points = self._scaled(x_values, y_values)
        try:
            self.edges = scipy.spatial.ConvexHull(points).equations
        except scipy.spatial.QhullError:
            raise ValueError(f"positions must not all lie on one line, got {count} positions on a line") from None
        monomials = np.stack([np.ones(count), *points.T, *points.T**2, points[:, 0] * points[:, 1]], axis=1)
        # Positions on a conic do not determine a quadratic polynomial.
        degree = 2 if np.linalg.matrix_rank(monomials, tol=1e-6) == 6 else 1
        self.interpolate = scipy.interpolate.RBFInterpolator(points, values, kernel="cubic", degree=degree)
        self.reach = float(np.hypot(x_values, y_values).max())

    def _scaled(self, x: Array, y: Array) -> Array:
        # Division by the size of the map makes the interpolation matrix independent of the unit of length.
        return np.asarray((np.stack([x.ravel(), y.ravel()], axis=1) - self.middle) / self.size)

    def contains(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """Return a mask of positions inside the convex hull."""
        outward = self._scaled(x, y) @ self.edges[:, :2].T + self.edges[:, 2]
        return np.asarray((outward <= _ROUNDING).all(axis=1).reshape(x.shape))

    def limits(self, unit: str) -> str:
        """Return the ranges of x and y of the convex hull, as part of a message."""
        x, y = np.sort(self.x), np.sort(self.y)
        return f"the convex hull of {x.size} positions with x from {_span(x)} and y from {_span(y)} {unit}"

    def nodes(self) -> dict[str, Array]:
        """Return the positions."""
        return {"x": self.x, "y": self.y}

    def wavefront(self, x: Array, y: Array) -> Wavefront:
        """Return the wavefronts, of the shape of x and y."""
        values = self.interpolate(self._scaled(x, y))
        return Wavefront.trusted(self.terms, values.reshape(*x.shape, -1))


class Radial(WavefrontsOnSensor):
    """Field of a rotationally symmetric lens: cubic splines of the field height, rotated to the azimuth."""

    def __init__(self, height: ArrayLike, wavefront: Wavefront, azimuth: float) -> None:
        self.height, self.azimuth = _heights(height), validation.angle("azimuth", azimuth)
        values, self.terms = _coefficients_and_terms(wavefront, self.height.shape, "of height")
        self.given = self.height.tobytes(), self.azimuth, wavefront
        orders = np.array([m for _, m in self.terms])
        if np.any(np.abs(values[0, orders != 0]) > _AXIS):
            raise ValueError(
                "the wavefront at height 0 must be radially symmetric, as on the axis of a rotationally symmetric "
                "lens; for other lenses give the wavefronts at positions over the field (`fields` of the adapters)"
            )
        self._require_mirror_symmetry({term: values[..., k] for k, term in enumerate(self.terms)})
        # Rotation by 180 degrees changes the sign of the height, and multiplies a term by (-1)^m.
        parity = np.where(orders % 2, -1.0, 1.0)
        middle = np.where(orders == 0, values[:1], 0.0)
        mirrored = np.concatenate([parity * values[:0:-1], middle, values[1:]])
        self.reach = float(self.height[-1])
        scaled = self.height / self.reach
        self.spline = scipy.interpolate.CubicSpline(np.concatenate([-scaled[:0:-1], scaled]), mirrored)

    def _require_mirror_symmetry(self, terms: Mapping[tuple[int, int], Array]) -> None:
        """Raise ValueError unless a mirror image about the direction of the heights is the same, as a lens has it."""
        largest = max((np.abs(c).max() for c in terms.values()), default=0.0)

        def odd_terms(azimuth: float) -> dict[tuple[int, int], Array]:
            along = zernike.rotated(terms, np.asarray(-azimuth))
            return {t: c for t, c in along.items() if t[1] < 0 and np.abs(c).max() > max(_AXIS, _AXIS * largest)}

        if not (odd := odd_terms(self.azimuth)):
            return
        term, c = max(odd.items(), key=lambda item: float(np.abs(item[1]).max()))
        k, advice = int(np.argmax(np.abs(c))), "for lenses without this symmetry give positions x and y"
        if not odd_terms(self.azimuth + 0.5 * math.pi):
            along = "y" if abs(math.cos(self.azimuth)) > 0.5 else "x"
            advice = f'it is that of heights along {along}: direction = "{along}", or the azimuth of this direction'
        raise ValueError(
            f"the wavefront at height {self.height[k]:g} must be symmetric about the direction of the heights, got "
            f"{zernike.name(*term).rpartition(' ')[0]} of {abs(c[k]) / math.tau:.3g} waves across it; {advice}"
        )

    def nodes(self) -> dict[str, Array]:
        """Return the heights."""
        return {"height": self.height}

    def wavefront(self, x: Array, y: Array) -> Wavefront:
        """Return the wavefronts, of the shape of x and y."""
        coefficients = self.spline(np.minimum(np.hypot(x, y) / self.reach, 1.0))
        angle = np.arctan2(y, x) - self.azimuth
        rotated = zernike.rotated({term: coefficients[..., k] for k, term in enumerate(self.terms)}, angle)
        return Wavefront.from_edge(rotated)


class Seidel(WavefrontsOnSensor):
    """Seidel aberrations: polynomials of the field height and the pupil position."""

    def __init__(self, edge: float, waves: Mapping[str, float]) -> None:
        self.reach = validation.real("edge", edge, above=0.0, unit=validation.EITHER)
        self.waves = {name: validation.real(name, value) for name, value in waves.items()}
        self.given = self.reach, *self.waves.items()

    def wavefront(self, x: Array, y: Array) -> Wavefront:
        """Return the wavefronts, of the shape of x and y."""
        stack = Wavefront.from_seidel(**self.waves, field=(x / self.reach, y / self.reach))
        # If no term depends on the field, the result is a single wavefront.
        return stack if stack.shape == x.shape else Wavefront(np.zeros(x.shape)) + stack


def _increasing_array(name: str, value: ArrayLike) -> Array:
    array = validation.real_array(name, value, unit=validation.EITHER)
    if array.ndim != 1 or array.size < 2:
        raise ValueError(f"{name} must be of shape (n,) with n at least 2, got shape {array.shape}")
    steps = np.diff(array)
    if not np.all(steps > 0.0):
        k = int(np.argmin(steps > 0.0))
        raise ValueError(f"{name} must rise, got {array[k]:g} followed by {array[k + 1]:g}")
    return array


def _span(values: Array) -> str:
    return f"{values[0]:.6g} to {values[-1]:.6g}"


def _coefficients_and_terms(
    wavefront: Wavefront, shape: tuple[int, ...], shape_label: str
) -> tuple[Array, tuple[tuple[int, int], ...]]:
    """Return the coefficients at the pupil edge, shape ``shape + (k,)``, and the indices (n, m) of the k terms."""
    if validation.instance("wavefront", wavefront, Wavefront).shape != shape:
        raise ValueError(f"wavefront must have the shape {shape_label}, {shape}, got {wavefront.shape}")
    return wavefront.edge, wavefront.terms
