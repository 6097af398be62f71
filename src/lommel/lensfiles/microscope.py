"""A microscope, an emitter in its sample and a stack of planes: what a file with a section [objective] describes."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.emitter import Emitter
from lommel.optics.layer import DEPTH_MOST
from lommel.optics.objective import Objective
from lommel.optics.objective_pupil import ObjectivePupil

PLANES_MOST = 4096
_LEAST_SIDE, _MOST_SIDE = 33, 513


def stage_step(value: float) -> float:
    """Return how far planes are apart, metres; ValueError where that is nothing, or no stage goes so far."""
    if not 0.0 < abs(value) < DEPTH_MOST:
        raise ValueError(f"step must be of the stage, not 0 and below 10 mm, got {value:g} m")
    return value


@dataclass(frozen=True)
class Microscope:
    """What a file with a section [objective] describes: an objective, what emits light, and planes on a camera.

    Attributes
    ----------
    name, source : str
        What it is, and where its figures come from.
    objective : Objective
    wavelength, depth : float
        Metres: in vacuum, and of the emitter from the cover glass.
    pixel : float
        Metres on the camera.
    emitter : Dipole, Beam or Scalar
    planes : int
        How many there are; a single one is no stack.
    step : float
        Metres of the stage between neighbours.
    origin : str
        Where z is 0, which plane ``planes // 2`` is at; see :meth:`lommel.Objective.pupil`.
    shape : tuple of int, or None
        Height and width of the window, in pixels, where the file names them; see :attr:`window`.
    integrate : bool or None
        Whether pixels average or sample, as of :func:`lommel.psf`; None where the file does not say.

    Raises
    ------
    TypeError, ValueError
        If planes are no number from 1 to 4096, or there are several without a step.
    """

    name: str
    source: str
    objective: Objective
    wavelength: float
    depth: float
    pixel: float
    emitter: Emitter
    planes: int = 1
    step: float = 0.0
    origin: str = "brightest"
    shape: tuple[int, int] | None = None
    integrate: bool | None = None

    def __post_init__(self) -> None:
        validation.integer("planes", self.planes, least=1, most=PLANES_MOST)
        if self.planes > 1:
            stage_step(validation.real("step", self.step))

    @property
    def z(self) -> Array:
        """Where the stage is in each plane, metres from the origin."""
        return np.asarray((np.arange(self.planes) - self.planes // 2) * self.step, np.float64)

    @property
    def window(self) -> tuple[int, int]:
        """Height and width of the window: `shape`, or a square about the rays and ten lambda*N more, 33 to 513."""
        if self.shape is not None:
            return self.shape
        pupil = self.pupil()
        half = math.ceil((float(pupil.geometric_radius().max()) + 10.0 * pupil.scale) / self.pixel)
        return (max(_LEAST_SIDE, min(2 * half + 1, _MOST_SIDE)),) * 2

    def pupil(self) -> ObjectivePupil:
        """Return the pupil of all planes, or of the only one.

        Returns
        -------
        ObjectivePupil

        Raises
        ------
        ValueError
            As :meth:`lommel.Objective.pupil`.
        """
        return self.objective.pupil(
            depth=self.depth,
            z=self.z if self.planes > 1 else 0.0,
            wavelength=self.wavelength,
            origin=self.origin,
            emitter=self.emitter,
        )
