"""The diameter and the sensor of a lens from whichever figures state them."""

from __future__ import annotations

import math

from lommel.base import validation


def aperture(focal_length: float, f_number: float | None, aperture_diameter: float | None) -> float:
    """Return the diameter of the aperture from exactly one of the f-number and the diameter; metres.

    Parameters
    ----------
    focal_length : float
        Metres.
    f_number, aperture_diameter : float or None
        As of :class:`lommel.Lens`.

    Returns
    -------
    float

    Raises
    ------
    TypeError, ValueError
        If there are none or both of them, or one that is no positive number.
    """
    if (f_number is None) == (aperture_diameter is None):
        raise ValueError(
            "give exactly one of f_number and aperture_diameter, "
            f"got f_number={f_number!r}, aperture_diameter={aperture_diameter!r}"
        )
    if f_number is not None:
        diameter = focal_length / validation.real("f_number", f_number, above=0.0)
    else:
        diameter = validation.real("aperture_diameter", aperture_diameter, above=0.0, unit="metres")
    name = "aperture_diameter, focal_length / f_number,"
    return validation.real(name, diameter, least=1e-12, below=1e6, unit="metres")


def sensor(focal_length: float, focus_distance: float | None, sensor_distance: float | None) -> float:
    """Return the distance of the sensor from at most one of it and the object distance in focus; metres.

    Parameters
    ----------
    focal_length : float
        Metres.
    focus_distance, sensor_distance : float or None
        As of :class:`lommel.Lens`.

    Returns
    -------
    float

    Raises
    ------
    TypeError, ValueError
        If both are given, or one that is no positive number, or a focus closer than the focal length.
    """
    if focus_distance is not None and sensor_distance is not None:
        raise ValueError(
            "give at most one of focus_distance and sensor_distance, "
            f"got focus_distance={focus_distance!r}, sensor_distance={sensor_distance!r}"
        )
    if sensor_distance is not None:
        return validation.real("sensor_distance", sensor_distance, above=0.0, unit="metres")
    s = math.inf if focus_distance is None else focus_distance
    s = validation.real("focus_distance", s, above=0.0, infinite=True, unit="metres")
    if s <= focal_length:
        raise ValueError(
            f"focus_distance must exceed the focal length {focal_length:g} m (no real image otherwise), got {s:g}"
        )
    return 1.0 / (1.0 / focal_length - 1.0 / s)
