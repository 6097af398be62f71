"""What the live page's menu of presets holds: the lens files of examples/lenses, as far as its controls say them."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import lommel as lm

LENSES = Path(__file__).resolve().parent.parent / "examples" / "lenses"
DIRECTED = {"coma": (3, 1), "astigmatism": (2, 2), "trefoil": (3, 3)}
TILT = {(1, 1), (1, -1)}


def presets() -> list[dict[str, Any]]:
    """Return each lens file as name, source, state of the page, and words about what the state leaves out."""
    return [preset(path) for path in sorted(LENSES.glob("*.toml"))]


def preset(path: Path) -> dict[str, Any]:
    """Return one lens file."""
    instrument = lm.load_instrument(path)
    pupil = instrument.pupil()
    waves = {term: float(c) / (2 * math.pi) for term, c in pupil.wavefront.edge_terms().items()}
    left_out = []
    # W020 and W040 of the Zernike terms of these powers, 2 rho^2 - 1 and 6 rho^4 - 6 rho^2 + 1.
    spherical = 6.0 * waves.pop((4, 0), 0.0)
    state = {"defocus": 2.0 * waves.pop((2, 0), 0.0) - spherical, "spherical": spherical}
    for name, (n, m) in DIRECTED.items():
        along, across = waves.pop((n, m), 0.0), waves.pop((n, -m), 0.0)
        state[name] = math.hypot(along, across)
        state[f"{name}_angle"] = math.degrees(math.atan2(across, along)) / m
    tilts = [waves.pop(term, 0.0) for term in TILT]
    if any(tilts):
        left_out.append("tilt, which moves the image")
    if rest := math.sqrt(sum(c * c for c in waves.values())):
        left_out.append(f"terms of higher order, {rest:.1g} waves")
    if pupil.spider is not None:
        left_out.append("the spider")
    if instrument.aberrations_of_field is not None:
        left_out.append("what changes over the field")
    state |= {
        "f_number": float(pupil.f_number),
        "obscuration": pupil.obscuration,
        "wavelength": pupil.wavelength * 1e9,
        "pixel": instrument.pixel * 1e6,
        "focal_length": instrument.lens.focal_length * 1e3,
    }
    return {
        "name": instrument.name,
        "source": instrument.source,
        "state": {key: float(f"{value:.6g}") for key, value in state.items() if value},
        "left_out": "; ".join(left_out),
    }
