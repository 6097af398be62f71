"""What windows, methods and answers need to know of anything that light passes: its stack, its units, its light."""

from __future__ import annotations

import math
from abc import abstractmethod
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING, Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import display, validation
from lommel.base.arrays import Array
from lommel.base.cached import cached_property

if TYPE_CHECKING:
    from abc import ABC

    from matplotlib.axes import Axes
else:
    ABC = object  # to tell what is an instance of an ABC takes a tenth of the time of a small PSF


@dataclass(frozen=True)
class Geometry:
    """Distances that the Fresnel approximation reduces to C_d; Huygens' superposition needs them exactly.

    A paraxial lens is stigmatic (free of aberration) for the plane it is focused on, the conjugate of the sensor:
    ``1/focus_distance = 1/focal_length - 1/sensor_distance``.

    Attributes
    ----------
    aperture_radius, focal_length, sensor_distance : float
        Metres; the sensor distance is measured from the lens.
    object_distance : tuple of float
        Metres, one for each pupil of the (flattened) stack; may be infinite.
    model, corrected_for : str
        As of :class:`lommel.Lens`.
    """

    aperture_radius: float
    focal_length: float
    sensor_distance: float
    object_distance: tuple[float, ...]
    model: str = "paraxial"
    corrected_for: str = "object"

    @property
    def in_focus(self) -> float:
        """One over the distance in focus, 1/metres; negative for a point behind the lens."""
        return 1.0 / self.focal_length - 1.0 / self.sensor_distance

    @cached_property
    def distances(self) -> Array:
        """`object_distance` as an array: a long stack is indexed often."""
        return np.array(self.object_distance)

    @property
    def vergence(self) -> NDArray[np.float64]:
        """``1/s - 1/focus_distance`` for each object, 1/metres."""
        return np.asarray(1.0 / self.distances - self.in_focus)

    @property
    def sphere(self) -> float:
        """Curvature of an aplanatic lens's reference sphere, 1/metres.

        See :func:`lommel.optics.wavefront.aplanatic.path`.
        """
        return self.in_focus if self.corrected_for == "focus" else -1.0 / self.sensor_distance

    def focused(self) -> Geometry:
        """Return the same lens with one object, in focus: behind the lens where its distance is negative."""
        return replace(self, object_distance=(1.0 / self.in_focus if self.in_focus else math.inf,))

    def to_dict(self) -> dict[str, Any]:
        """Return everything in plain types, an infinite distance as None (JSON has no infinity)."""
        distances = [None if math.isinf(s) else s for s in self.object_distance]
        return asdict(self) | {"object_distance": distances}

    @classmethod
    def from_dict(cls, description: dict[str, Any]) -> Geometry:
        """Rebuild a geometry from :meth:`to_dict`."""
        distances = tuple(math.inf if s is None else float(s) for s in description["object_distance"])
        return cls(**{**description, "object_distance": distances})


class BasePupil(display.Shown, ABC):
    """A pupil, of a lens or of a microscope's objective, or a stack of them."""

    layered: ClassVar[bool] = False
    """Whether its light comes through plane layers: that of an objective."""

    if TYPE_CHECKING:  # fields here, properties there

        @property
        def wavelength(self) -> float | None:
            """Metres."""

        @property
        def f_number(self) -> float | None:
            """On the sensor."""

        @property
        def radial(self) -> bool:
            """Whether what it makes depends on the distance from the axis only."""

        @property
        def circular(self) -> bool:
            """Whether its aperture is a plain disc or annulus."""

        @property
        def aperture(self) -> tuple[Any, ...]:
            """All that decides how much light passes."""

    @property
    @abstractmethod
    def shape(self) -> tuple[int, ...]:
        """Shape of the stack; ``()`` for a single pupil."""

    @property
    @abstractmethod
    def amplitude(self) -> float:
        """Field at the peak without aberration."""

    @property
    @abstractmethod
    def transmission(self) -> float:
        """Light that passes, over that of the clear, unobscured aperture."""

    @property
    @abstractmethod
    def likely_peak(self) -> float:
        """Return a guess of the least peak of the stack, where searches for an accuracy begin."""

    @abstractmethod
    def geometric_radius(self) -> NDArray[np.float64]:
        """Return how far from the axis rays meet the sensor at most, a length there, of the shape of the stack."""

    def __len__(self) -> int:
        """Return how many pupils, or stacks of them, the first axis of a stack holds."""
        if self.shape == ():
            raise TypeError("a single pupil has no length")
        return self.shape[0]

    def __bool__(self) -> bool:
        """Return True, whether it has a length or not."""
        return True

    @abstractmethod
    def __getitem__(self, index: Any) -> Self:
        """Return part of a stack, as NumPy indexes arrays of its shape."""

    @abstractmethod
    def broadcast(self, shape: tuple[int, ...]) -> Self:
        """Return a stack of another `shape`, which this one is broadcast to."""

    @abstractmethod
    def in_light(self, wavelength: float) -> Self:
        """Return it in light of another `wavelength` (metres): distances and path differences stay."""

    @abstractmethod
    def to_dict(self) -> dict[str, Any]:
        """Return everything in plain types."""

    def plot(self, ax: Axes | None = None, *, what: str = "phase", unit: str = "waves") -> Any:
        """Draw the phase across the pupil, or the amplitude, on axes of matplotlib; a stack on one scale.

        See :func:`lommel.show.pupils.pupil`.
        """
        return display.plot(self, ax, what=what, unit=unit)

    @property
    def aberrated(self) -> bool:
        """Whether a measured wavefront is on top of what plane layers do."""
        return False

    @property
    def left_out(self) -> tuple[float, float]:
        """Largest phase that the wavefront does not hold, radians, and the share of the amplitude likewise."""
        return 0.0, 0.0

    @property
    def collected(self) -> NDArray[np.float64]:
        """Light that is collected over that of the emitter far from the glass; ValueError for a lens."""
        raise ValueError('normalize="emitted" is for the pupils of an Objective; for a lens use "energy"')

    @property
    def scale(self) -> float:
        """One lambda*N, in metres or 1; ``PSF.scale`` is something else, a factor of its values."""
        if self.wavelength is None or self.f_number is None:
            return 1.0
        return self.wavelength * self.f_number

    @property
    def unit(self) -> str:
        """Unit of lengths on the sensor: ``"m"`` or ``"lambda*N"``."""
        return "lambda*N" if self.wavelength is None else "m"

    @property
    def airy_radius(self) -> float:
        """Radius of the first dark ring of the unobscured, unaberrated lens: 1.2197 lambda*N."""
        return 3.8317059702075123 / math.pi * self.scale

    @property
    def cutoff(self) -> float:
        """Spatial frequency from which no contrast passes, ``1 / (lambda N)``: cycles per metre, or 1."""
        return 1.0 / self.scale

    def v(self, radius: ArrayLike) -> NDArray[np.float64]:
        """Return the optical coordinate ``v = pi radius / (lambda N)`` of each `radius` on the sensor.

        TypeError or ValueError if these are not real and finite.
        """
        at = validation.real_array("radius", radius)
        with np.errstate(over="ignore"):
            return validation.real_array("radius over lambda*N", math.pi / self.scale * at)


_WAYS = {
    "Lens": "a Lens; lens.pupil(object_distance) is its pupil",
    "Objective": "an Objective; objective.pupil(depth=..., wavelength=...) is its pupil",
    "Instrument": "an Instrument; instrument.pupil() is its pupil",
    "Wavefront": "a Wavefront; Pupil(wavefront) has a round aperture",
    "PSF": "a PSF; psf.pupil is its pupil, and psf.mtf(fx, fy) and psf.otf(fx, fy) are those of the image",
    "FieldMap": "a FieldMap; field.pupil(x, y) is that of a position",
    "Microscope": "a Microscope; microscope.pupil() is its pupil",
    "ObjectivePupil": "that of an Objective, which has no one wavefront; lommel.psf takes it, and measures its PSF",
}


def is_no_pupil(thing: Any) -> TypeError:
    """Return the error for what is not the pupil that is needed; of what makes or has one it says how."""
    return TypeError(f"pupil must be a Pupil, got {_WAYS.get(type(thing).__name__) or validation.shown(thing)}")


def imaged(pupil: Any) -> BasePupil:
    """Return `pupil` if it is one, of a lens or of an objective; TypeError otherwise."""
    if isinstance(pupil, BasePupil):
        return pupil
    raise is_no_pupil(pupil)


def object_distances(value: float | ArrayLike) -> float | NDArray[np.float64]:
    """Return distances of objects as floats, one as a float of Python, or raise TypeError or ValueError."""
    if isinstance(value, float) and value >= 1e-150:
        return float(value)
    distance = validation.array("object_distance", value)
    if distance.dtype.kind not in "iuf":
        raise TypeError(f"object_distance must be a number of metres, got {validation.shown(value)}")
    with np.errstate(over="ignore"):
        distance = np.array(distance, dtype=np.float64)
    if distance.size == 0:
        raise ValueError(f"object_distance must not be empty, got shape {distance.shape}")
    bad = ~(distance >= 1e-150)  # whose inverse is a number, and its square
    if bad.any():
        raise ValueError(f"object_distance must be > 0 metres, got {distance[bad].flat[0]}")
    return distance
