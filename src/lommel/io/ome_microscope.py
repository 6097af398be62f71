"""What OME-XML says of a microscope: how far planes are apart, its objective, its light, and its layers."""

from __future__ import annotations

from typing import Any

import numpy as np

from lommel.base.arrays import Array
from lommel.measures.psf_like import PSFLike
from lommel.optics.layers.emitter import Beam
from lommel.optics.layers.objective_pupil import ObjectivePupil

UNEVEN = "planes are not evenly spaced along z: pupil.z has the place of each, metres"

_EVEN = 1e-6  # of the step


def step(z: Array) -> float | None:
    """Return how far neighbours along the one axis of a stack are apart, metres; None where that is not even."""
    if z.ndim != 1 or z.size < 2:
        return None
    steps = np.diff(z)
    mean = float(steps.mean())
    return mean if mean and np.abs(steps - mean).max() <= _EVEN * abs(mean) else None


def note(pupil: ObjectivePupil) -> dict[str, str]:
    """Return what the description of a stack says of its planes, if OME-XML cannot."""
    return {"planes": UNEVEN} if pupil.z.size > 1 and step(pupil.z) is None else {}


def image(psf: PSFLike, pupil: ObjectivePupil) -> dict[str, Any]:
    """Return the attributes and elements of an image: lengths in the sample, and of the stage."""
    size, apart = 1e6 * psf.grid.side / pupil.magnification, step(pupil.z)
    nanometres = 1e9 * pupil.wavelength
    light = "ExcitationWavelength" if isinstance(pupil.emitter, Beam) else "EmissionWavelength"
    layers = pupil.layers
    told = {
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
        "MapAnnotation": {"Value": told},
    }
    if apart is not None:
        found |= {"PhysicalSizeZ": _digits(1e6 * abs(apart)), "PhysicalSizeZUnit": "µm"}
    return found


def with_objective(xml: str, pupil: ObjectivePupil) -> str:
    """Return OME-XML of one image with the objective that it was taken with, in the order of the schema."""
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
    """Return a length as it was meant: 0.1, not 0.09999999999999999."""
    return float(f"{value:.12g}")


def _span(metres: Array) -> str:
    return " to ".join(f"{end:.6g}" for end in dict.fromkeys((1e6 * metres.min(), 1e6 * metres.max())))
