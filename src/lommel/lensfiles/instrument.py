"""A lens, the object it looks at, and its sensor: what a lens file describes."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import Any

from lommel.base import validation
from lommel.field.maps import FieldMap
from lommel.optics.colour.spectrum import Channels
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront


@dataclass(frozen=True)
class Instrument:
    """What a lens file describes: a lens, the object it looks at, and its sensor.

    Attributes
    ----------
    name, source : str
        What it is, and where its figures come from.
    lens : Lens
    object_distance : float
        Metres.
    pixel : float or (float, float)
        Metres; height and width of pixels that are not square.
    shape : tuple of int, or None
        Height and width of the window, in pixels, where the file names them; see :attr:`window`.
    radii : dict of str to float
        Radii of interest on the sensor (metres) by the text that named them; for encircled energies.
    sensor : tuple of float, or None
        Height and width of the whole sensor, metres, where the file says what changes over the field.
    aberrations_of_field : FieldMap, or None
        What the field adds to the wavefront of the lens.
    integrate : bool or None
        Whether pixels average or sample, as of :func:`lommel.psf`; None where the file does not say.
    fill : (float, float)
        The parts of height and width of a pixel that are active.
    channels : Channels or None
        What the sensor records, where the file says it.
    """

    pupil_hint = "an Instrument; instrument.pupil() is its pupil"

    name: str
    source: str
    lens: Lens
    object_distance: float
    pixel: float | tuple[float, float]
    shape: tuple[int, int] | None
    radii: dict[str, float] = field(hash=False)
    sensor: tuple[float, float] | None = None
    aberrations_of_field: FieldMap | None = field(default=None, repr=False)
    integrate: bool | None = None
    fill: tuple[float, float] = (1.0, 1.0)

    @property
    def pitch(self) -> tuple[float, float]:
        """From row to row and from column to column, metres."""
        return (self.pixel, self.pixel) if isinstance(self.pixel, float) else self.pixel

    @property
    def side(self) -> float:
        """Pitch of square pixels all of which is active; ValueError for others, which few questions are about."""
        if not isinstance(self.pixel, float) or self.fill != (1.0, 1.0):
            raise ValueError(f"pixel must be square, and all of it active, got pixel={self.pixel}, fill={self.fill}")
        return self.pixel

    @property
    def sensor_options(self) -> dict[str, Any]:
        """What :func:`lommel.psf` is told of pixels beside their pitch."""
        return {"integrate": self.integrate, "fill": self.fill}

    channels: Channels | None = None

    @property
    def window(self) -> tuple[int, int]:
        """Height and width of the window: `shape`, or a square for about 98 % of the light, see `wide_enough`."""
        return self.shape or (max(33, min(wide_enough(self.pupil(), min(self.pitch)), 1025)),) * 2

    def pupil(self) -> Pupil:
        """Return the pupil for the object of the file.

        Returns
        -------
        Pupil

        Raises
        ------
        TypeError, ValueError
            As :meth:`lommel.Lens.pupil`.
        """
        return self.lens.pupil(self.object_distance)

    def field(self) -> FieldMap:
        """Return the map of the field for the object of the file: the aberrations of the field and of the lens.

        The aperture of the lens is that of all positions.

        Returns
        -------
        FieldMap

        Raises
        ------
        ValueError
            If the file has no section [field].
        """
        if self.aberrations_of_field is None:
            raise ValueError(f"the lens file of {self.name!r} must have a section [field] for PSFs over the field")
        pupil = self.pupil()
        aperture = pupil.carrying(Wavefront(), None)
        return replace(self.aberrations_of_field, pupil_without_wavefront=aperture) + pupil.wavefront


def wide_enough(pupil: Pupil, pixel: float) -> int:
    """Return the odd side, in pixels, of a square about the axis that holds some 98 % of the light.

    Beyond the rays diffraction spreads ``2 / pi^2`` of the light per lambda*N of distance from the edge of their
    blur, and more the longer the rim of the aperture is for its area.
    """
    tail = 10.0 * pupil.scale / (1.0 - pupil.obscuration)
    return 2 * min(math.ceil((float(pupil.geometric_radius()) + tail) / pixel), validation.MAX_SIDE // 2 - 1) + 1
