"""The distances of a lens, its object and its sensor."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.cached import cached_property


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
