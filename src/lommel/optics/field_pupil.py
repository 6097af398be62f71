"""Pupils of one lens, each seen from another place of the sensor through an opening of its own."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.optics.aperture.apodization import Apodization
from lommel.optics.base_pupil import BasePupil
from lommel.optics.pupil import Pupil


@dataclass(frozen=True)
class FieldPupil(BasePupil):
    """A stack of pupils that share their scale, but not what narrows them; made by :meth:`lommel.FieldMap.psf`.

    Parameters
    ----------
    pupils : tuple of Pupil
        Single ones, in reading order.
    places : tuple of int
        The shape of the stack.

    Raises
    ------
    TypeError, ValueError
        If they are no single pupils of one scale, or not as many as the shape has places.
    """

    pupils: tuple[Pupil, ...]
    places: tuple[int, ...]

    def __post_init__(self) -> None:
        for pupil in self.pupils:
            validation.instance("pupils", pupil, Pupil)
        scales = {(pupil.shape, pupil.wavelength, pupil.f_number) for pupil in self.pupils}
        if len(self.pupils) != math.prod(self.places) or len(scales) != 1 or scales.pop()[0] != ():
            raise ValueError(f"pupils must be single ones of one scale for each place of {self.places}")

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the stack."""
        return self.places

    @property
    def wavelength(self) -> float | None:
        """Metres."""
        return self.pupils[0].wavelength

    @property
    def f_number(self) -> float | None:
        """On the sensor, of the whole aperture."""
        return self.pupils[0].f_number

    @property
    def radial(self) -> bool:
        """Never: what places see differs."""
        return False

    @property
    def circular(self) -> bool:
        """Whether nothing narrows any of them."""
        return all(pupil.circular for pupil in self.pupils)

    @property
    def illumination(self) -> Apodization:
        """The amplitude, which they share."""
        return self.pupils[0].illumination

    @property
    def aperture(self) -> tuple[Any, ...]:
        """None: ValueError."""
        raise ValueError("pupil must have one aperture, got one for each place; index the stack, or ask FieldMap.psf")

    @property
    def amplitude(self) -> float:
        """None: ValueError."""
        raise ValueError("each place has an aperture of its own: index the stack, and measure one after the other")

    @property
    def transmission(self) -> Any:
        """Light that passes, an array of the shape of the stack."""
        return np.reshape([pupil.transmission for pupil in self.pupils], self.shape)

    @property
    def likely_peak(self) -> float:
        """The least of theirs."""
        return min(pupil.likely_peak for pupil in self.pupils)

    def geometric_radius(self) -> NDArray[np.float64]:
        """Return how far from the axis rays meet the sensor at most, of the shape of the stack."""
        return np.reshape([float(pupil.geometric_radius()) for pupil in self.pupils], self.shape)

    def __getitem__(self, index: Any) -> Any:
        """Return a pupil, or part of the stack, as NumPy indexes arrays of its shape."""
        which = np.arange(len(self.pupils)).reshape(self.shape)[index]
        if which.ndim == 0:
            return self.pupils[int(which)]
        return FieldPupil(tuple(self.pupils[k] for k in which.ravel()), which.shape)

    def broadcast(self, shape: tuple[int, ...]) -> FieldPupil:
        """Return a stack of another `shape`, of at most 2^28; TypeError or ValueError if it is none for this."""
        shape = validation.stack_shape(shape, self.shape)
        which = np.broadcast_to(np.arange(len(self.pupils)).reshape(self.shape), shape)
        return FieldPupil(tuple(self.pupils[k] for k in which.ravel()), shape)

    def in_light(self, wavelength: float) -> FieldPupil:
        """Return them in light of another `wavelength`, metres."""
        return FieldPupil(tuple(pupil.in_light(wavelength) for pupil in self.pupils), self.shape)

    def to_dict(self) -> dict[str, Any]:
        """Return everything in plain types; :meth:`from_dict` is the inverse."""
        return {"shape": list(self.shape), "pupils": [pupil.to_dict() for pupil in self.pupils]}

    @classmethod
    def from_dict(cls, description: dict[str, Any]) -> FieldPupil:
        """Rebuild what a `description` by :meth:`to_dict` says."""
        return cls(tuple(Pupil.from_dict(part) for part in description["pupils"]), tuple(description["shape"]))
