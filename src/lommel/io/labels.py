"""What files of other programs have fields for: the axes of a PSF, its light, and the angle of a pixel."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.measures.psf_like import PSFLike
from lommel.optics.colour.spectrum import Spectrum
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.pupil import Pupil

_ARCSEC = math.pi / 648000.0


class Axis(NamedTuple):
    """An axis of the values: its name, and where each entry is, if it is anywhere."""

    name: str
    places: Array | None = None
    unit: str = ""


def axes(psf: PSFLike, description: Mapping[str, Any]) -> list[Axis]:
    """Return the axes of the values in their order: those of the stack, y, x; the stage of a microscope is z.

    Those of a grid of PSFs are its places on the sensor, which its description has.
    """
    pupil, grid = psf.pupil, psf.grid
    if field := description.get("field"):
        stack = [Axis(f"field_{side}", np.array(field[side]), psf.unit) for side in "yx"]
    elif isinstance(pupil, ObjectivePupil) and len(pupil.shape) == 1:
        stack = [Axis("z", pupil.z, "m")]
    else:
        stack = [Axis(f"stack{k}" if k else "stack") for k in range(len(pupil.shape))]
    if grid.stack:
        return [*stack, Axis("y"), Axis("x")]
    return [*stack, Axis("y", grid.y, psf.unit), Axis("x", grid.x, psf.unit)]


def light(psf: PSFLike) -> tuple[Array, Array]:
    """Return the wavelengths in metres and the share of the light at each; none where lengths are in lambda*N."""
    if isinstance(psf.method, Spectrum):
        return np.array(psf.method.wavelengths), np.array(psf.method.weights)
    known = [] if psf.pupil.wavelength is None else [psf.pupil.wavelength]
    return np.array(known), np.ones(len(known))


def arcseconds(psf: PSFLike) -> float | None:
    """Return the angle of a square pixel seen from the lens, on the axis; None where the lens has no distances."""
    pupil = psf.pupil
    if not isinstance(pupil, Pupil) or pupil.geometry is None or not isinstance(psf.pixel, float):
        return None
    return math.atan(psf.pixel / pupil.geometry.sensor_distance) / _ARCSEC
