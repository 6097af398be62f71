"""Movies of molecules at known places, made by lommel.psf, with the noise and the offset of a camera."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

import lommel as lm
from objectives import OIL

PIXEL, MAGNIFICATION = 6.5e-6, 63.0
REACH = 10  # pixels around a molecule that its image fills
OBJECTIVE = OIL
ASTIGMATISM = lm.Wavefront.zernike({6: 0.15}, order="noll", unit="waves")


class Molecules(NamedTuple):
    """Frame, place in pixels (whole ones at the middles), stage position (m) and photons of each molecule."""

    frame: np.ndarray
    row: np.ndarray
    column: np.ndarray
    z: np.ndarray
    photons: np.ndarray


def pupil(
    z: np.ndarray | float = 0.0, depth: float = 1e-6, aberrations: lm.Wavefront = ASTIGMATISM
) -> lm.ObjectivePupil:
    """An oil objective with astigmatism, the molecules in water."""
    return OBJECTIVE.pupil(depth=depth, z=z, wavelength=600e-9, aberrations=aberrations)


def spread(frames: int, side: int, *, each: int, apart: float, seed: int, reach: float = 0.5e-6) -> Molecules:
    """Molecules at random places of a square frame that are some pixels apart, and from the border."""
    draw = np.random.default_rng(seed)
    places = []
    for frame in range(frames):
        here: list[np.ndarray] = []
        while len(here) < each:
            place = draw.uniform(REACH, side - 1 - REACH, 2)
            if all(abs(place - other).max() > apart for other in here):
                here.append(place)
        places += [(frame, *place) for place in here]
    frame, row, column = np.array(places).T
    z = draw.uniform(-reach, reach, frame.size)
    return Molecules(frame.astype(int), row, column, z, draw.uniform(1500.0, 3000.0, frame.size))


def light(molecules: Molecules, frames: int, side: int, background: float) -> np.ndarray:
    """Mean electrons of each pixel."""
    mean = np.full((frames, side, side), background)
    middle = np.rint(molecules.row).astype(int), np.rint(molecules.column).astype(int)
    centre = REACH + molecules.row - middle[0], REACH + molecules.column - middle[1]
    psf = lm.psf(pupil(molecules.z), 2 * REACH + 1, PIXEL, center=centre, dtype="float64")
    for k, image in enumerate(psf.values):
        down, across = (slice(at[k] - REACH, at[k] + REACH + 1) for at in middle)
        mean[molecules.frame[k], down, across] += molecules.photons[k] * image
    return mean


def recorded(mean: np.ndarray, noise: lm.Noise, seed: int) -> np.ndarray:
    """Counts of a camera, integers of 16 bits."""
    return np.clip(np.rint(noise.record(mean, seed)), 0, 65535).astype(np.uint16)
