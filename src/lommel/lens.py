"""A physical lens: focal length, stop and focus (paper, Eq. 1-3)."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel import validation
from lommel.aperture import CatEye, Ellipse, Mask, Spider
from lommel.pupil import Geometry, Pupil
from lommel.wavefront import Wavefront


@dataclass(frozen=True, init=False)
class Lens:
    """A thin lens with its stop at the lens; metres everywhere, distances from the lens.

    Parameters
    ----------
    focal_length : float
        Metres, positive.
    f_number, aperture_diameter : float
        Exactly one: focal length over diameter, or the diameter in metres.
    focus_distance, sensor_distance : float
        At most one: the object distance in focus (default infinity; must exceed the focal length), or the
        distance of the sensor behind the lens.
    wavelength : float
        Metres.
    obscuration : float, default 0
        Central obscuration over aperture radius.
    aberrations : Wavefront, default none
        Added to the defocus of every object distance.
    spider, vignetting, mask : optional
        What narrows the aperture, as of :class:`lommel.Pupil`.

    Raises
    ------
    TypeError, ValueError
        On anything missing, contradictory, non-finite or out of range.

    Examples
    --------
    >>> lens = Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
    >>> round(float(lens.defocus(1.5)), 2)
    91.82
    """

    focal_length: float
    aperture_diameter: float
    sensor_distance: float
    wavelength: float
    obscuration: float
    aberrations: Wavefront = field(repr=False)
    spider: Spider | None
    vignetting: Ellipse | CatEye | None
    mask: Mask | None

    def __init__(
        self,
        *,
        focal_length: float,
        wavelength: float,
        f_number: float | None = None,
        aperture_diameter: float | None = None,
        focus_distance: float | None = None,
        sensor_distance: float | None = None,
        obscuration: float = 0.0,
        aberrations: Wavefront | None = None,
        spider: Spider | None = None,
        vignetting: Ellipse | CatEye | None = None,
        mask: Mask | None = None,
    ) -> None:
        f = validation.real("focal_length", focal_length, above=0.0, unit="metres")
        if (f_number is None) == (aperture_diameter is None):
            raise ValueError(
                "give exactly one of f_number and aperture_diameter, "
                f"got f_number={f_number!r}, aperture_diameter={aperture_diameter!r}"
            )
        if f_number is not None:
            diameter = f / validation.real("f_number", f_number, above=0.0)
        else:
            diameter = validation.real("aperture_diameter", aperture_diameter, above=0.0, unit="metres")
        validation.real(
            "aperture_diameter, focal_length / f_number,", diameter, least=1e-12, below=1e6, unit="metres"
        )
        if focus_distance is not None and sensor_distance is not None:
            raise ValueError(
                "give at most one of focus_distance and sensor_distance, "
                f"got focus_distance={focus_distance!r}, sensor_distance={sensor_distance!r}"
            )
        if sensor_distance is not None:
            d = validation.real("sensor_distance", sensor_distance, above=0.0, unit="metres")
        else:
            s = math.inf if focus_distance is None else focus_distance
            s = validation.real("focus_distance", s, above=0.0, infinite=True, unit="metres")
            if s <= f:
                raise ValueError(
                    f"focus_distance must exceed the focal length {f:g} m (no real image otherwise), got {s:g}"
                )
            d = 1.0 / (1.0 / f - 1.0 / s)
        aberrations = Wavefront() if aberrations is None else aberrations
        if not isinstance(aberrations, Wavefront):
            raise TypeError(f"aberrations must be a Wavefront, got {validation.shown(aberrations)}")
        values: dict[str, Any] = {
            "focal_length": f,
            "aperture_diameter": diameter,
            "sensor_distance": d,
            "wavelength": validation.wavelength(wavelength),
            "obscuration": validation.real("obscuration", obscuration, least=0.0, below=1.0),
            "aberrations": aberrations,
            "spider": spider,
            "vignetting": vignetting,
            "mask": mask,
        }
        # What is no such shape, or leaves nothing clear, is told now.
        Pupil(obscuration=values["obscuration"], spider=spider, vignetting=vignetting, mask=mask)
        for name, value in values.items():
            object.__setattr__(self, name, value)

    @property
    def f_number(self) -> float:
        """Focal length over aperture diameter, as engraved on the lens."""
        return self.focal_length / self.aperture_diameter

    @property
    def working_f_number(self) -> float:
        """Sensor distance over aperture diameter: the N of lambda*N."""
        return self.sensor_distance / self.aperture_diameter

    @property
    def focus_distance(self) -> float:
        """Object distance in focus, metres; infinite or negative where the sensor is at or inside the focal plane."""
        vergence = 1.0 / self.focal_length - 1.0 / self.sensor_distance
        return math.inf if abs(vergence) < 1e-15 / self.focal_length else 1.0 / vergence

    def defocus(self, object_distance: ArrayLike = math.inf) -> NDArray[np.float64]:
        """Return C_d in radians for objects at `object_distance` (metres from the lens, may be infinite).

        ``2 C_d = (pi / lambda) (1/d - 1/f + 1/s) R_max^2`` (paper, Eq. 3, with the 1/s of a finite object
        distance s). Positive where the sensor, at d, lies between the lens and the image of the object.
        The aberrations of the lens are not included.
        """
        s = _object_distance(object_distance)
        vergence = 1.0 / self.sensor_distance - 1.0 / self.focal_length + 1.0 / s
        return np.asarray(math.pi / (2.0 * self.wavelength) * vergence * (0.5 * self.aperture_diameter) ** 2)

    def pupil(self, object_distance: ArrayLike = math.inf) -> Pupil:
        """Return the pupil for an object at `object_distance` (metres); an array gives a stack of pupils."""
        s = _object_distance(object_distance)
        try:
            np.broadcast_shapes(s.shape, self.aberrations.shape)
        except ValueError:
            raise ValueError(
                "object_distance must broadcast with the aberrations, "
                f"got shapes {s.shape} and {self.aberrations.shape}"
            ) from None
        wavefront = Wavefront(self.defocus(s)) + self.aberrations
        geometry = Geometry(
            0.5 * self.aperture_diameter,
            self.focal_length,
            self.sensor_distance,
            tuple(np.broadcast_to(s, wavefront.shape).ravel().tolist()),
        )
        return Pupil(
            wavefront,
            obscuration=self.obscuration,
            wavelength=self.wavelength,
            f_number=self.working_f_number,
            geometry=geometry,
            spider=self.spider,
            vignetting=self.vignetting,
            mask=self.mask,
        )


def _object_distance(value: ArrayLike) -> NDArray[np.float64]:
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
