"""Vignetting and shading over the field of a lens."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.aperture.obstructions import CatEye
from lommel.optics.pupil import Pupil


@dataclass(frozen=True, init=False)
class Vignetting:
    """Cat's-eye vignetting: a second circle that moves across the aperture with the field height.

    Light passes within both circles. The second moves along the direction of the position on the sensor, with linear
    interpolation of shift and radius between heights.

    Parameters
    ----------
    height : array_like, shape (n,)
        Distances from the axis on the sensor, increasing from 0, at least two.
    shift : array_like, shape (n,)
        Shift of the centre of the second circle, in radii of the aperture, 0 on the axis; positive towards the
        position, so that the opposite side of the pupil is blocked.
    radius : float or array_like, shape (n,)
        Radius of the second circle, in radii of the aperture.

    Raises
    ------
    TypeError, ValueError
        If a number is not finite, heights do not increase from 0, or no light passes at one of them.

    Examples
    --------
    >>> import lommel as lm
    >>> edges = lm.Vignetting([0.0, 20e-3], shift=[0.0, 0.6], radius=1.2)
    >>> edges.at(10e-3, 0.0)
    CatEye(shift=(0.3, 0.0), radius=1.2)
    """

    height: tuple[float, ...]
    shift: tuple[float, ...]
    radius: tuple[float, ...]

    def __init__(self, height: ArrayLike, shift: ArrayLike, radius: ArrayLike = 1.0) -> None:
        heights = _heights(height)
        moved = validation.real_array("shift", shift)
        radii = validation.real_array("radius", radius, least=1e-6)
        if moved.shape != heights.shape or moved[0] != 0.0:
            raise ValueError(f"shift must be one for each height, 0 for the first, got {validation.shown(shift)}")
        if radii.shape not in ((), heights.shape):
            raise ValueError(f"radius must be one number, or one for each height, got {validation.shown(radius)}")
        wide = np.broadcast_to(radii, heights.shape)
        vars(self).update(height=tuple(heights.tolist()), shift=tuple(moved.tolist()), radius=tuple(wide.tolist()))
        for far, size in zip(self.shift, self.radius, strict=True):
            CatEye((far, 0.0), size)

    def at(self, x: float, y: float) -> CatEye | None:
        """Return the vignetting at (`x`, `y`), None where there is none; ValueError beyond the last height."""
        r = _within(math.hypot(x, y), self.height[-1])
        far, size = (float(np.interp(r, self.height, part)) for part in (self.shift, self.radius))
        if abs(far) + 1.0 <= size:
            return None
        along = (x / r, y / r) if r > 0.0 else (1.0, 0.0)
        return CatEye((far * along[0], far * along[1]), size)


@dataclass(frozen=True, init=False)
class Shading:
    """Relative illumination off the axis apart from vignetting, such as cos^4.

    Parameters
    ----------
    height : array_like, shape (n,)
        Distances from the axis on the sensor, increasing from 0, at least two.
    light : array_like, shape (n,)
        Illumination relative to the axis, above 0; the first is 1. As measured with the lens stopped down, without
        vignetting. Interpolated linearly between heights.

    Raises
    ------
    TypeError, ValueError
        If a number is not finite, heights do not increase from 0, or the first `light` is not 1.
    """

    height: tuple[float, ...]
    light: tuple[float, ...]
    distance: float | None

    def __init__(self, height: ArrayLike, light: ArrayLike) -> None:
        heights, found = _heights(height), validation.real_array("light", light, least=1e-12)
        if found.shape != heights.shape or found[0] != 1.0:
            raise ValueError(f"light must be one for each height, 1 for the first, got {validation.shown(light)}")
        vars(self).update(height=tuple(heights.tolist()), light=tuple(found.tolist()), distance=None)

    @classmethod
    def cos4(cls, distance: float) -> Shading:
        """Return the shading ``cos(theta)^4``, ``tan(theta)`` the height over the `distance` of the exit pupil.

        Parameters
        ----------
        distance : float
            Distance from the exit pupil to the sensor, in the unit of heights: `sensor_distance` of a thin
            :class:`lommel.Lens`.

        Raises
        ------
        TypeError, ValueError
            If `distance` is not a number above 0.

        References
        ----------
        D. S. Goodman, "General principles of geometric optics", in Handbook of Optics, McGraw-Hill (1995), ch. 1.
        """
        made = cls([0.0, 1.0], [1.0, 1.0])
        vars(made).update(height=(), light=(), distance=validation.real("distance", distance, above=0.0))
        return made

    def at(self, x: Array, y: Array) -> Array:
        """Return the relative illumination at (`x`, `y`); ValueError beyond the last height."""
        r = np.hypot(x, y)
        if self.distance is not None:
            return np.asarray((1.0 + (r / self.distance) ** 2) ** -2.0)
        _within(float(r.max(initial=0.0)), self.height[-1])
        return np.asarray(np.interp(r, self.height, self.light))


def relative(bare: Pupil, vignetting: Vignetting | None, shading: Shading | None, x: Array, y: Array) -> Array:
    """Return the light at positions over that on the axis, for an aperture that is `bare` of these two."""
    light = np.ones(x.shape) if shading is None else shading.at(x, y)
    if vignetting is None:
        return light
    positions = [(0.0, 0.0), *zip(x.ravel().tolist(), y.ravel().tolist(), strict=True)]
    axis, *passing = (replace(bare, vignetting=vignetting.at(*xy)).transmission for xy in positions)
    return np.asarray(light * np.reshape(passing, x.shape) / axis)


def _heights(height: ArrayLike) -> Array:
    found = validation.real_array("height", height, least=0.0)
    if found.ndim != 1 or found.size < 2 or found[0] != 0.0 or not np.all(np.diff(found) > 0.0):
        raise ValueError(f"height must rise from 0, at least two, got {validation.shown(height)}")
    return found


def _within(r: float, most: float) -> float:
    if r > most * (1.0 + 1e-12):
        raise ValueError(f"the position {r:.6g} from the axis lies beyond the last height, {most:.6g}")
    return r


def positions(x: ArrayLike, y: ArrayLike) -> tuple[Array, Array]:
    """Return positions on the sensor as arrays of one shape."""
    across, down = validation.broadcast("x and y", validation.real_array("x", x), validation.real_array("y", y))
    return across, down
