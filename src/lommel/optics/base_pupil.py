"""Base class of the pupils of lenses and microscope objectives, and object and sensor distances."""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING, Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import display, validation
from lommel.base.arrays import Array, Index, Json
from lommel.base.cached import cached_property

if TYPE_CHECKING:
    from matplotlib.axes import Axes


OfEach = Callable[[Any], Any]
"""Signature: array of a stack's shape, or stack of wavefronts -> a part of it, or the broadcast array or stack."""


@dataclass(frozen=True)
class Geometry:
    """Distances of a lens, an object and a sensor, metres; ``HuygensFresnel`` needs them in addition to C_d.

    A paraxial lens is stigmatic for the plane in focus, the conjugate of the sensor:
    ``1/focus_distance = 1/focal_length - 1/sensor_distance``. There is one object distance for each pupil of the
    flattened stack, infinity allowed. For `model` and `corrected_for` see :class:`lommel.Lens`.
    """

    aperture_radius: float
    focal_length: float
    sensor_distance: float
    object_distance: tuple[float, ...]
    model: str = "paraxial"
    corrected_for: str = "object"

    @property
    def in_focus(self) -> float:
        """Inverse of the distance in focus, 1/metres; negative for a point behind the lens."""
        return 1.0 / self.focal_length - 1.0 / self.sensor_distance

    @cached_property
    def distances(self) -> Array:
        """`object_distance` as an array, cached since long stacks are indexed often."""
        return np.array(self.object_distance)

    @property
    def vergence(self) -> NDArray[np.float64]:
        """``1/s - 1/focus_distance`` for each object, 1/metres."""
        return np.asarray(1.0 / self.distances - self.in_focus)

    @property
    def sphere(self) -> float:
        """Curvature of the reference sphere of an aplanatic lens, 1/metres."""
        return self.in_focus if self.corrected_for == "focus" else -1.0 / self.sensor_distance

    def focused(self) -> Geometry:
        """Return the geometry of one object in focus; its distance is negative if it is behind the lens."""
        return replace(self, object_distance=(1.0 / self.in_focus if self.in_focus else math.inf,))

    def to_dict(self) -> Json:
        """Return everything in plain types, an infinite distance as None (JSON has no infinity)."""
        distances = [None if math.isinf(s) else s for s in self.object_distance]
        return asdict(self) | {"object_distance": distances}

    @classmethod
    def from_dict(cls, description: Json) -> Geometry:
        """Rebuild a geometry from :meth:`to_dict`."""
        distances = tuple(math.inf if s is None else float(s) for s in description["object_distance"])
        return cls(**{**description, "object_distance": distances})


class BasePupil(display.Shown):
    """Base of a pupil, or a stack of pupils, of a lens or a microscope objective."""

    # Not an ABC: isinstance would take a tenth of the time of a small PSF; mypy checks abstract methods anyway.

    layered: ClassVar[bool] = False
    """True if the light comes through plane layers, as in a microscope."""

    one_aperture: ClassVar[bool] = True
    """True if all pupils of a stack have the same aperture."""

    if TYPE_CHECKING:  # fields of some subclasses, properties of others

        @property
        def wavelength(self) -> float | None:
            """Wavelength, metres."""

        @property
        def f_number(self) -> float | None:
            """Working f-number on the sensor."""

        @property
        def radial(self) -> bool:
            """True if the PSF is rotationally symmetric."""

        @property
        def circular(self) -> bool:
            """True if the aperture is circular or annular."""

        @property
        def aperture(self) -> tuple[object, ...]:
            """All parts of the pupil that limit or weight the light."""

    @property
    @abstractmethod
    def shape(self) -> tuple[int, ...]:
        """Shape of the stack; ``()`` for a single pupil."""

    @property
    @abstractmethod
    def amplitude(self) -> float:
        """Field at the peak without aberration."""

    @property
    def within_disc(self) -> bool:
        """True if the modulus of the pupil function is known to be at most 1 on the unit disk, and 0 beyond."""
        return False

    @property
    def likely_strehl(self) -> float:
        """Estimate of the lowest Strehl ratio of the stack."""
        return 1.0

    @property
    @abstractmethod
    def transmission(self) -> float:
        """Transmitted light, divided by the light through the clear, unobscured aperture."""

    @property
    @abstractmethod
    def likely_peak(self) -> float:
        """Estimate of the lowest peak of the stack, with which refinements to a tolerance start."""

    @abstractmethod
    def geometric_radius(self) -> NDArray[np.float64]:
        """Return the largest distance from the axis at which rays meet the sensor, of the shape of the stack."""

    def __len__(self) -> int:
        """Return the length of the first axis of a stack."""
        if self.shape == ():
            raise TypeError("a single pupil has no length")
        return self.shape[0]

    def __bool__(self) -> bool:
        """Return True, for a single pupil too."""
        return True

    def __getitem__(self, index: Index) -> Self:
        """Return part of a stack, indexed as an array of its shape."""
        return self._each(lambda part: part[index])

    def broadcast(self, shape: tuple[int, ...]) -> Self:
        """Return the stack broadcast to `shape`, at most 2^28 pupils; TypeError or ValueError if it is impossible."""
        if self.shape == shape:
            return self
        target = validation.stack_shape(shape, self.shape)

        return self._each(
            lambda part: (
                np.broadcast_to(part, target) if isinstance(part, np.ndarray | np.generic) else part.broadcast(target)
            )
        )

    @abstractmethod
    def _each(self, of: OfEach) -> Self:
        """Return the stack with `of` applied to each array and each stack of wavefronts that varies in the stack."""

    @abstractmethod
    def in_light(self, wavelength: float) -> Self:
        """Return the pupil at another `wavelength` (metres) with the same optical path differences."""

    @abstractmethod
    def to_dict(self) -> Json:
        """Return everything in plain types."""

    def plot(self, ax: Axes | None = None, *, what: str = "phase", unit: str = "waves") -> Axes | NDArray[np.object_]:
        """Draw the phase across the pupil, or the amplitude, on axes of matplotlib; a stack on one scale.

        See :func:`lommel.show.pupils.pupil`.
        """
        axes: Axes | NDArray[np.object_] = display.plot(self, ax, what=what, unit=unit)
        return axes

    @property
    def aberrated(self) -> bool:
        """True if a measured wavefront is added to the phase of plane layers."""
        return False

    @property
    def left_out(self) -> tuple[float, float]:
        """Bounds on the truncation errors of the expansions: phase (radians) and relative amplitude."""
        return 0.0, 0.0

    @property
    def collected(self) -> NDArray[np.float64]:
        """Collected light, divided by the light of an emitter far from the glass; ValueError for a lens."""
        raise ValueError('normalize="emitted" is for the pupils of an Objective; for a lens use "energy"')

    @property
    def scale(self) -> float:
        """lambda*N in metres, or 1; not ``PSF.scale``, which is a factor of the values."""
        if self.wavelength is None or self.f_number is None:
            return 1.0
        return self.wavelength * self.f_number

    @property
    def period(self) -> float:
        """Period of the image along x and y in units of lambda*N; infinite unless the pupil is a sum of samples."""
        return math.inf

    @property
    def unit(self) -> str:
        """Unit of lengths on the sensor: ``"m"`` or ``"lambda*N"``."""
        return "lambda*N" if self.wavelength is None else "m"

    @property
    def airy_radius(self) -> float:
        """Radius of the first dark ring of the unobscured, unaberrated lens: 1.2197 lambda*N."""
        # The first zero of J1.
        return 3.8317059702075123 / math.pi * self.scale

    @property
    def cutoff(self) -> float:
        """Spatial frequency above which the OTF is 0, ``1 / (lambda N)``: cycles per metre, or 1."""
        return 1.0 / self.scale

    def v(self, radius: ArrayLike) -> NDArray[np.float64]:
        """Return the optical coordinate ``v = pi radius / (lambda N)`` of each `radius` on the sensor.

        TypeError or ValueError if `radius` is not real and finite.
        """
        radii = validation.real_array("radius", radius, unit=self.unit)
        with np.errstate(over="ignore"):
            return validation.real_array("radius / (lambda*N)", math.pi / self.scale * radii)


def not_a_pupil(value: object) -> TypeError:
    """Return the exception for an argument that is not a pupil, with a hint of how to get a pupil from it."""
    # Lens, Objective and PSF have the text `pupil_hint`.
    hint = getattr(type(value), "pupil_hint", None) or validation.shown(value)
    if isinstance(value, list | tuple) and value and isinstance(value[0], BasePupil):
        hint += ": a stack is one Pupil of a Wavefront whose coefficients are arrays"
    return TypeError(f"pupil must be a Pupil, got {hint}")


def imaged(pupil: object) -> BasePupil:
    """Return `pupil` if it is the pupil of a lens or of an objective; TypeError otherwise."""
    if isinstance(pupil, BasePupil):
        return pupil
    raise not_a_pupil(pupil)


def object_distances(value: float | ArrayLike) -> float | NDArray[np.float64]:
    """Return checked object distances, an array or (from a float) a Python float; TypeError or ValueError."""
    if isinstance(value, float) and value >= 1e-150:
        return float(value)
    distance = validation.array("object_distance", value, "metres")
    if distance.dtype.kind not in "iuf":
        raise TypeError(f"object_distance must be a number of metres, got {validation.shown(value)}")
    with np.errstate(over="ignore"):
        distance = np.array(distance, dtype=np.float64)
    if distance.size == 0:
        raise ValueError(f"object_distance must not be empty, got shape {distance.shape}")
    invalid = ~(distance >= 1e-150)  # smaller distances have squared inverses that overflow
    if invalid.any():
        raise ValueError(f"object_distance must be > 0 metres, got {distance[invalid].flat[0]}")
    return distance
