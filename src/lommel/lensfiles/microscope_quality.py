"""Image quality of a microscope: sampling, wavefront, and the focus of an emitter at several depths."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from lommel.base.plain import plain
from lommel.lensfiles.image_quality import listed_terms
from lommel.optics.aperture.apodization import illumination
from lommel.show.labels import of_emitter

if TYPE_CHECKING:
    from lommel.lensfiles.microscope_files import Microscope

DEPTHS = (0.0, 1e-6, 5e-6, 20e-6, 50e-6)
"""Depths that are listed besides that of the file, metres."""

_OF_OBJECTIVE = ("NA", "magnification", "working_distance", "immersion")
_OF_FOCUS = ("paraxial", "brightest", "axial_fwhm", "lateral_fwhm", "peak")


def microscope_quality(microscope: Microscope, *, foci: bool = True) -> dict[str, Any]:
    """Return what is known of a microscope as plain data; with `foci`, also of a dipole at several depths.

    Lengths in metres: x and y in the sample, z of the stage, "pixel" on the camera. Angles in radians. "refused" has
    the reasons why depths are missing in "focus", where dipoles rotate freely.
    """
    objective, wavelength = microscope.objective, microscope.wavelength
    light, nyquist = illumination(objective.apodization), objective.nyquist(wavelength=wavelength)
    step = abs(microscope.step) if microscope.planes > 1 else None
    design, measured = objective.design, microscope.aberrations
    terms = [] if measured is None else listed_terms(measured.to_zernike(unit="waves"))
    as_designed = design.immersion == objective.immersion and design.coverslip == objective.coverslip
    coarse = {"pixel": microscope.pixel > nyquist.pixel, "step": step is not None and step > nyquist.axial}
    rows, refused = _foci(microscope) if foci else ([], [])
    return {
        "name": microscope.name,
        "source": microscope.source,
        **{name: getattr(objective, name) for name in _OF_OBJECTIVE},
        "apodization": list(light.powers),
        "rim_amplitude": float(light.value(1.0)),
        "coverslip": plain(objective.coverslip),
        "films": plain(objective.films),
        "design": None if as_designed else plain(design),
        "sample": objective.sample,
        "critical_angle": objective.critical_angle,
        "rim_angle": math.asin(objective.NA / objective.immersion),
        "wavelength": wavelength,
        "emitter": of_emitter(microscope.emitter),
        "rms_waves": math.hypot(*(term["waves_rms"] for term in terms)),
        "zernike": terms,
        "depth": microscope.depth,
        "planes": microscope.planes,
        "step": step,
        "origin": microscope.origin,
        "pixel": microscope.pixel,
        "camera": plain(microscope.camera),
        "pixel_in_sample": microscope.pixel / objective.magnification,
        "nyquist": plain(nyquist),
        "too_coarse": [name for name, exceeds in coarse.items() if exceeds],
        "focus": rows,
        "refused": refused,
    }


def _foci(microscope: Microscope) -> tuple[list[dict[str, float | None]], list[str]]:
    """Return the foci at several depths, and the reasons why other depths have none."""
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
        row |= {name: float(getattr(found, name)) for name in _OF_FOCUS}
        row["peak_of_surface"] = float(found.peak) / surface
        row["collected"] = float(objective.collected(depth, wavelength=wavelength))
        rows.append(row)
    return rows, list(refused)
