"""Metadata for other programs: axes, wavelengths, angle per pixel, and OME-XML of a microscope."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.io.registry import Description
from lommel.measures.psf_like import PSFLike
from lommel.optics.colour.spectrum import Spectrum
from lommel.optics.layers.emitter import Beam
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.pupil import Pupil

_ARCSEC = math.pi / 648000.0


class Axis(NamedTuple):
    """An axis of the values: its name and coordinates, if it has any."""

    name: str
    places: Array | None = None
    unit: str = ""


def axes(psf: PSFLike, description: Description) -> list[Axis]:
    """Return the axes of the values in their order: the stack (z of a microscope, places of a grid), y, x."""
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
    """Return the wavelengths in metres and the fraction of the light at each; empty for lengths in lambda*N."""
    if isinstance(psf.method, Spectrum):
        return np.array(psf.method.wavelengths), np.array(psf.method.weights)
    known = [] if psf.pupil.wavelength is None else [psf.pupil.wavelength]
    return np.array(known), np.ones(len(known))


def arcseconds(psf: PSFLike) -> float | None:
    """Return the angle of a square pixel seen from the lens, or None without distances of the lens."""
    pupil = psf.pupil
    if not isinstance(pupil, Pupil) or pupil.geometry is None or not isinstance(psf.pixel, float):
        return None
    return math.atan(psf.pixel / pupil.geometry.sensor_distance) / _ARCSEC


_UNEVEN = "planes are not evenly spaced along z: pupil.z has the position of each, metres"
_EVEN = 1e-6  # of the step


def step(z: Array) -> float | None:
    """Return the step of evenly spaced planes in metres, or None."""
    if z.ndim != 1 or z.size < 2:
        return None
    steps = np.diff(z)
    mean = float(steps.mean())
    return mean if mean and np.abs(steps - mean).max() <= _EVEN * abs(mean) else None


def note(pupil: ObjectivePupil) -> dict[str, str]:
    """Return a note on unevenly spaced planes, which OME-XML cannot describe."""
    return {"planes": _UNEVEN} if pupil.z.size > 1 and step(pupil.z) is None else {}


def ome_image(psf: PSFLike, pupil: ObjectivePupil) -> Description:
    """Return the attributes and elements of an OME image, with lengths in the sample."""
    size, apart = 1e6 * psf.grid.side / pupil.magnification, step(pupil.z)
    nanometres = 1e9 * pupil.wavelength
    light = "ExcitationWavelength" if isinstance(pupil.emitter, Beam) else "EmissionWavelength"
    layers = pupil.layers
    annotations = {
        "refractive index of the immersion": layers.immersion,
        "refractive index of the cover glass": layers.glass,
        "refractive index of the sample": layers.sample,
        "depth of the emitter in um": _span(pupil.depth),
        "stage since the surface of the cover glass was in focus, in um": _span(pupil.focus),
        "emitter": repr(pupil.emitter),
    }
    found = {
        "PhysicalSizeX": _digits(size),
        "PhysicalSizeY": _digits(size),
        "Plane": {"PositionZ": [_digits(1e6 * z) for z in pupil.z.flat], "PositionZUnit": ["µm"] * pupil.z.size},
        "Channel": {"Name": f"{nanometres:.4g} nm", light: _digits(nanometres), f"{light}Unit": "nm"},
        "MapAnnotation": {"Value": annotations},
    }
    if apart is not None:
        found |= {"PhysicalSizeZ": _digits(1e6 * abs(apart)), "PhysicalSizeZUnit": "µm"}
    return found


def with_objective(xml: str, pupil: ObjectivePupil) -> str:
    """Return OME-XML of one image with its objective added, in the order of the schema."""
    instrument = (
        '<Instrument ID="Instrument:0"><Objective ID="Objective:0" '
        f'LensNA="{pupil.layers.NA}" NominalMagnification="{pupil.magnification}"/></Instrument>'
    )
    settings = (
        '<InstrumentRef ID="Instrument:0"/>'
        f'<ObjectiveSettings ID="Objective:0" RefractiveIndex="{pupil.layers.immersion}"/>'
    )
    return xml.replace("<Image ", f"{instrument}<Image ", 1).replace("<Pixels ", f"{settings}<Pixels ", 1)


def _digits(value: float) -> float:
    """Return a length without rounding noise: 0.1, not 0.09999999999999999."""
    return float(f"{value:.12g}")


def _span(metres: Array) -> str:
    return " to ".join(f"{end:.6g}" for end in dict.fromkeys((1e6 * metres.min(), 1e6 * metres.max())))
