"""What narrows and darkens the light on its way to places off the axis."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers
from lommel.optics.aperture.obstructions import CatEye
from lommel.optics.pupil import Pupil

if TYPE_CHECKING:
    from lommel.optics.pupil import Pupil


@dataclass(frozen=True, init=False)
class Vignetting:
    """A second edge of the aperture, a circle that moves across it with the distance from the axis: cat's eyes.

    Light passes within both circles. The centre of the second moves along the direction of the place on the sensor.
    Between the heights that are given, shift and radius are linear.

    Parameters
    ----------
    height : array_like, shape (n,)
        Distances from the axis on the sensor, rising from 0, at least two.
    shift : array_like, shape (n,)
        Of the centre over the radius of the aperture, 0 on the axis; above 0 towards the place: it hides the side of
        the pupil that is opposite to the place.
    radius : float or array_like, shape (n,)
        Over the radius of the aperture.

    Raises
    ------
    TypeError, ValueError
        If these are no finite numbers, heights do not rise from 0, or no light passes at one of them.

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
        """Return what is seen from the place (`x`, `y`) of the sensor; None where the second circle hides nothing.

        ValueError beyond the last height.
        """
        r = _within(math.hypot(x, y), self.height[-1])
        far, size = (float(np.interp(r, self.height, part)) for part in (self.shift, self.radius))
        if abs(far) + 1.0 <= size:
            return None
        along = (x / r, y / r) if r > 0.0 else (1.0, 0.0)
        return CatEye((far * along[0], far * along[1]), size)


@dataclass(frozen=True, init=False)
class Shading:
    """How much less light a part of the pupil sends to places off the axis, beside what vignetting hides.

    Parameters
    ----------
    height : array_like, shape (n,)
        Distances from the axis on the sensor, rising from 0, at least two.
    light : array_like, shape (n,)
        Over that on the axis, above 0; the first is 1. As measured with the lens stopped down, where nothing else
        narrows it. Between heights it is linear.

    Raises
    ------
    TypeError, ValueError
        If these are no finite numbers, heights do not rise from 0, or the first is not 1.
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
        r"""Return the shading ``cos(theta)^4``, ``tan(theta)`` the height over the `distance` of the exit pupil.

        Parameters
        ----------
        distance : float
            From the exit pupil to the sensor, in the unit of heights; `sensor_distance` of :class:`lommel.Lens` of a
            thin lens that is its own stop.

        Returns
        -------
        Shading

        Raises
        ------
        TypeError, ValueError
            If it is no number above 0.

        References
        ----------
        D. S. Goodman, "General principles of geometric optics", in Handbook of Optics, McGraw-Hill (1995), ch. 1.
        """
        made = cls([0.0, 1.0], [1.0, 1.0])
        vars(made).update(height=(), light=(), distance=validation.real("distance", distance, above=0.0))
        return made

    def at(self, x: Array, y: Array) -> Array:
        """Return the light at places (`x`, `y`) over that on the axis; ValueError beyond the last height."""
        r = np.hypot(x, y)
        if self.distance is not None:
            return np.asarray((1.0 + (r / self.distance) ** 2) ** -2.0)
        _within(float(r.max(initial=0.0)), self.height[-1])
        return np.asarray(np.interp(r, self.height, self.light))


def relative(bare: Pupil, vignetting: Vignetting | None, shading: Shading | None, x: Array, y: Array) -> Array:
    """Return the light at places (x, y) over that on the axis, of an aperture that is `bare` of these two."""
    light = np.ones(x.shape) if shading is None else shading.at(x, y)
    if vignetting is None:
        return light
    places = [(0.0, 0.0), *zip(x.ravel().tolist(), y.ravel().tolist(), strict=True)]
    axis, *passing = (replace(bare, vignetting=vignetting.at(*place)).transmission for place in places)
    return np.asarray(light * np.reshape(passing, x.shape) / axis)


def _heights(height: ArrayLike) -> Array:
    found = validation.real_array("height", height, least=0.0)
    if found.ndim != 1 or found.size < 2 or found[0] != 0.0 or not np.all(np.diff(found) > 0.0):
        raise ValueError(f"height must rise from 0, at least two, got {validation.shown(height)}")
    return found


def _within(r: float, most: float) -> float:
    if r > most * (1.0 + 1e-12):
        raise ValueError(f"the place {r:.6g} from the axis lies beyond the last height, {most:.6g}")
    return r


class Shaded:
    """A field that is narrowed and shaded off the axis."""

    pupil_without_wavefront: Pupil
    vignetting: Vignetting | None
    shading: Shading | None

    def seen_through(self, vignetting: Vignetting | None = None, shading: Shading | None = None) -> Self:
        """Return the map of a lens that is narrowed and shaded off the axis.

        Parameters
        ----------
        vignetting : Vignetting, optional
        shading : Shading, optional
            Which changes no PSF, but :meth:`illumination`.

        Returns
        -------
        FieldMap

        Raises
        ------
        TypeError, ValueError
            If these are of other types, or the aperture is narrowed by an ellipse or a cat's eye already.
        """
        validation.optional("vignetting", vignetting, Vignetting)
        validation.optional("shading", shading, Shading)
        if vignetting is not None and self.pupil_without_wavefront.vignetting is not None:
            raise ValueError("vignetting must be left out for an aperture that has one of its own at all places")
        changed: Any = self
        made: Self = replace(changed, vignetting=vignetting, shading=shading)
        return made

    def illumination(self, x: ArrayLike, y: ArrayLike) -> Numbers:
        """Return the light at places (x, y) of the sensor over that on the axis, of an evenly bright scene.

        Parameters
        ----------
        x, y : array_like

        Returns
        -------
        float or ndarray
            The light that passes what narrows the aperture there over what passes on the axis, times the shading.

        Raises
        ------
        TypeError, ValueError
            If a position is not finite, or beyond the vignetting or the shading.
        """
        across, down = places(x, y)
        bare = self.pupil_without_wavefront
        return numbers(relative(bare, self.vignetting, self.shading, across, down), across.shape)

    def working_f_number(self, x: ArrayLike, y: ArrayLike) -> Numbers:
        """Return the f-number that on the axis makes as little light as arrives at places (`x`, `y`).

        ``N / sqrt(illumination)``; raises as :meth:`illumination`, and ValueError for a map without an f-number.
        """
        if (known := self.pupil_without_wavefront.f_number) is None:
            raise ValueError("f_number must be known for a working f-number, and this map is in units of lambda*N")
        return known / np.sqrt(self.illumination(x, y))


def places(x: ArrayLike, y: ArrayLike) -> tuple[Array, Array]:
    """Return positions as arrays of one shape."""
    across, down = validation.broadcast("x and y", validation.real_array("x", x), validation.real_array("y", y))
    return across, down
