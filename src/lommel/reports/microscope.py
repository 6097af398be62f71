"""What there is to say about a microscope and its stacks, as plain data."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lommel.lensfiles.microscope import Microscope
from lommel.optics.emitter import Dipole, Scalar
from lommel.optics.layer import Layer
from lommel.psf import PSF
from lommel.reports.report import how_made

DEPTHS = (0.0, 1e-6, 5e-6, 20e-6, 50e-6)
"""Told beside the depth of the file, metres."""


def describe_microscope(microscope: Microscope, *, foci: bool = True) -> dict[str, Any]:
    """Return what there is to say about a microscope without computing an image.

    Lengths in metres, angles in radians; x and y in the sample but for "pixel", which is on the camera, z of the
    stage. "focus" has a row for each depth: "paraxial" and "brightest" are how far the objective has been driven
    towards the sample since the surface of the cover glass was in focus, "ratio" the depth over the brightest (None
    at depth 0), "peak" the intensity there and "peak_of_surface" the same over that at depth 0, "collected" the
    light that the objective takes in over that of an emitter far from the glass. All of an emitter that turns
    freely, whatever the file has; without `foci`, which take longer than a stack, it is empty. "nyquist" has the
    coarsest steps that keep all of an image, and "too_coarse" the names of those that are exceeded, "pixel" or
    "step". Depths that cannot be reached are left out, for the reasons in "refused".
    """
    objective, wavelength = microscope.objective, microscope.wavelength
    nyquist, glass = objective.nyquist(wavelength=wavelength), objective.coverslip
    rows, refused = _foci(microscope) if foci else ([], [])
    step = abs(microscope.step) if microscope.planes > 1 else None
    coarse = {"pixel": microscope.pixel > nyquist.pixel, "step": step is not None and step > nyquist.axial}
    design = objective.design
    as_designed = design.immersion == objective.immersion and design.coverslip == glass
    return {
        "name": microscope.name,
        "source": microscope.source,
        "NA": objective.NA,
        "magnification": objective.magnification,
        "working_distance": objective.working_distance,
        "immersion": objective.immersion,
        "coverslip": _layer(glass),
        "films": [_layer(film) for film in objective.films],
        "design": None if as_designed else {"immersion": design.immersion, "coverslip": _layer(design.coverslip)},
        "sample": objective.sample,
        "critical_angle": objective.critical_angle,
        "rim_angle": math.asin(objective.NA / objective.immersion),
        "wavelength": wavelength,
        "emitter": emitter_in_words(microscope),
        "depth": microscope.depth,
        "planes": microscope.planes,
        "step": step,
        "origin": microscope.origin,
        "pixel": microscope.pixel,
        "pixel_in_sample": microscope.pixel / objective.magnification,
        "nyquist": {"lateral": nyquist.lateral, "axial": nyquist.axial, "pixel": nyquist.pixel},
        "too_coarse": [name for name, exceeds in coarse.items() if exceeds],
        "focus": rows,
        "refused": refused,
    }


def _foci(microscope: Microscope) -> tuple[list[dict[str, float | None]], list[str]]:
    """Return the foci of several depths, and why others have none."""
    objective, wavelength = microscope.objective, microscope.wavelength
    rows: list[dict[str, float | None]] = []
    refused: dict[str, None] = {}
    surface = float(objective.focus(0.0, wavelength=wavelength).peak)
    for depth in sorted({*DEPTHS, microscope.depth}):
        try:
            found = objective.focus(depth, wavelength=wavelength)
        except ValueError as reason:
            refused[f"{1e6 * depth:.4g} um deep: {reason}"] = None
            continue
        row: dict[str, float | None] = {"depth": depth, "ratio": float(found.ratio) if depth > 0.0 else None}
        names = ("paraxial", "brightest", "axial_fwhm", "lateral_fwhm", "peak")
        row |= {name: float(getattr(found, name)) for name in names}
        row["peak_of_surface"] = float(found.peak) / surface
        row["collected"] = float(objective.collected(depth, wavelength=wavelength))
        rows.append(row)
    return rows, list(refused)


def describe_stack(answer: PSF, seconds: float) -> dict[str, Any]:
    """Return what there is to say about a computed stack of planes, or about one plane.

    "z", "focus", "peak" and "energy" have a number for each plane, metres of the stage and shares of the light;
    "brightest" is the index of the plane with the largest value, None for a single plane.
    """
    pupil: Any = answer.pupil
    peaks = answer.values.max(axis=(-2, -1))
    return how_made(answer, seconds) | {
        "pixel_in_sample": answer.pixel / pupil.magnification,
        "z": pupil.z.tolist(),
        "focus": pupil.focus.tolist(),
        "energy": np.asarray(answer.energy).tolist(),
        "brightest": int(peaks.argmax()) if pupil.shape else None,
    }


def emitter_in_words(microscope: Microscope) -> str:
    """Return what sends light, or is focused into the sample."""
    emitter = microscope.emitter
    if isinstance(emitter, Dipole):
        if emitter.wobble == 1.0:
            return "turns freely"
        place = (
            f"{math.degrees(emitter.polar):.4g} deg from the axis, azimuth {math.degrees(emitter.azimuth):.4g} deg"
        )
        return f"dipole, {place}" + (f", wobble {emitter.wobble:.4g}" if emitter.wobble else "")
    if isinstance(emitter, Scalar):
        return "scalar, as of Gibson and Lanni"
    return f"a beam focused into the sample, {emitter.polarization} polarisation"


def _layer(layer: Layer | None) -> dict[str, float] | None:
    return None if layer is None else {"index": layer.index, "thickness": layer.thickness}
