"""A stack of beads under oil, by plain quadrature of the model of Gibson and Lanni, without lommel."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import tifffile
from scipy.special import j0

NA, OIL, WATER = 1.4, 1.518, 1.33


def _intensity(r, depth, focus, wavelength):
    """Return the intensity at distances from the axis, metres in the sample, unnormalised."""
    rho = (np.arange(400) + 0.5) / 400 * min(1.0, WATER / NA)
    k = 2.0 * np.pi / wavelength
    path = depth * np.sqrt(WATER**2 - (NA * rho) ** 2) - focus * np.sqrt(OIL**2 - (NA * rho) ** 2)
    waves = np.exp(1j * k * path) * rho
    return np.abs(j0(k * NA * np.outer(r, rho)) @ waves) ** 2


def bead_stack(planes=21, side=40, pixel=6.5e-6 / 63, step=0.25e-6, wavelength=520e-9, depth=6e-6, seed=0):
    """Return counts of three beads at one depth on a background, of a camera of 0.46 electrons a count."""
    z = (np.arange(planes) - planes // 2) * step
    focus = 1.22 * depth + z
    y, x = np.indices((side, side))
    mean = np.full((planes, side, side), 20.0)
    table = np.arange(0.0, 1.5 * side, 0.25)
    each = np.array([_intensity(table * pixel, depth, one, wavelength) for one in focus])
    for row, column, photons in ((12, 13, 3e3), (27, 20, 5e3), (18, 30, 2e3)):
        r = np.hypot(y - row, x - column)
        images = np.array([np.interp(r, table, one) for one in each])
        mean += photons * images / images.sum(axis=(1, 2)).mean()
    rng = np.random.default_rng(seed)
    return (
        np.round((rng.poisson(mean) + rng.normal(0.0, 1.6, mean.shape)) / 0.46 + 100.0)
        .clip(0, 65535)
        .astype(np.uint16)
    )


def write(path: Path, planes: int = 21) -> None:
    """Write it as OME-TIFF, with tifffile alone."""
    metadata = {
        "axes": "ZYX",
        "PhysicalSizeX": 6.5 / 63, "PhysicalSizeXUnit": "µm",
        "PhysicalSizeY": 6.5 / 63, "PhysicalSizeYUnit": "µm",
        "PhysicalSizeZ": 0.25, "PhysicalSizeZUnit": "µm",
        "Channel": {"Name": ["GFP"], "EmissionWavelength": [520], "EmissionWavelengthUnit": ["nm"]},
    }  # fmt: skip
    tifffile.imwrite(path, bead_stack(planes), ome=True, photometric="minisblack", metadata=metadata)
