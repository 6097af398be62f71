"""What vignetting and shading do to a lens over its field."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers
from lommel.field.vignetting import Shading, Vignetting, relative

if TYPE_CHECKING:
    from lommel.optics.pupil import Pupil


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
