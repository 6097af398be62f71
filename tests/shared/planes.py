"""Photographs of textured planes, of continuous scenes and without the PSFs of this package, and their cameras."""

from __future__ import annotations

import numpy as np

import lommel as lm
from scenes import POINTS, ThinLens, plane
from scenes import texture as points_of

PIXEL = 4e-6
LENS = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.35, wavelength=540e-9)
PAIR = [LENS, LENS.focused(1.8)]
NOISE = lm.Noise(white=1e4, read=3.0)
CAMERA = {"encoding": "linear", "noise": NOISE, "between": (1.2, 2.0)}
_MARGIN = 16  # pixels beyond the photographs on each side


def texture(side=144, contrast=0.35, seed=0, mean=0.5):
    """Light on 8 x 8 points a pixel, whose power falls as the squared frequency."""
    return mean * points_of("pink", side, seed, contrast)


def pixels(rows, columns):
    """The points of pixels of the photographs, as slices of rows and columns."""
    return tuple(
        slice(*(None if end is None else (end + _MARGIN) * POINTS for end in (s.start, s.stop)))
        for s in (rows, columns)
    )


def shoot(scene, distance, lenses, seed=1, exposures=None, noise=NOISE, wavelength=None):
    """Photographs of a plane, 16 pixels less on each side."""
    out = []
    for k, lens in enumerate(lenses):
        thin = ThinLens(lens.focal_length, lens.f_number, lens.focus_distance, wavelength or lens.wavelength, PIXEL)
        light = plane(scene, [thin], distance, 1.0)[0][_MARGIN:-_MARGIN, _MARGIN:-_MARGIN]
        share = 1.0 if exposures is None else exposures[k]
        out.append(noise.record(noise.white * share * np.maximum(light, 0.0), seed=seed + k))
    return out
