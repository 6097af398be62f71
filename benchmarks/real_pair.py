"""Depth of a real pair of photographs before and after calibration on one plane: tables in Markdown.

``python benchmarks/real_pair.py FOLDER`` takes the folder with flat-0600-f4-l.png, flat-0600-f20-l.png,
flat-1500-f4-l.png and flat-1500-f20-l.png: textured planes at 0.600 and 1.500 m by a Canon RF 50 mm f/1.8 focused at
1 m, 768 x 512 pixels of 46.9 um, 8-bit sRGB (test data of https://github.com/LinYark/Sdirt, left views).
They are no part of this package.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import argparse
import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from PIL import Image

import lommel as lm

PIXEL, PUPIL = 36e-3 / 768, 22.5e-3  # metres: pixel pitch, and entrance pupil behind the first surface in the design
WIDE = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=1.0, wavelength=540e-9)
STATED = [WIDE, WIDE.stopped(20.0)]
BETWEEN = {0.6: (0.4, 0.95), 1.5: (1.02, 3.0)}  # one side of the focus each
OPTIONS = {"pixel": PIXEL, "encoding": "srgb"}


def row(
    label: str, distance: float, pair: list[np.ndarray], lenses: Sequence[lm.Lens], origin: float, **errors: float
):
    """Return a row of the table: depth of a plane, less the origin, beside its distance."""
    found = lm.imaging.depth_from_defocus(pair, lenses, between=BETWEEN[distance], **OPTIONS, **errors)
    known = np.isfinite(found.errors)
    metres, error = np.median(found.depth[known]) - origin, np.median(found.errors[known])
    off = metres - distance
    return (
        f"| {label} | {distance:g} m | {metres:.3f} ± {error:.3f} m | {100.0 * off / distance:+.1f} % | "
        f"{off / error:+.1f} | {100.0 * known.mean():.0f} % |"
    )


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    folder = parser.parse_args().folder
    planes = {
        distance: [
            np.asarray(Image.open(folder / f"flat-{1000 * distance:04.0f}-f{stop}-l.png").convert("L"))
            for stop in (4, 20)
        ]
        for distance in BETWEEN
    }
    print("| lens | plane | depth found | off | off / standard error | known |\n|---|---|---|---|---|---|")
    for distance, pair in planes.items():
        print(row("as engraved", distance, pair, STATED, 0.0), flush=True)
    for origin in (PUPIL, None):
        for distance, other in ((0.6, 1.5), (1.5, 0.6)):
            found = lm.imaging.calibrate_focus([planes[distance]], [distance], STATED, **OPTIONS, origin=origin)
            focus = found.lenses[0].focus_distance
            label = f"calibrated at {distance:g} m{'' if origin else ', origin not stated'}: focus {focus:.3f} ± "
            label += f"{found.focus_error * focus**2:.3f} m"
            print(row(label, other, planes[other], found.lenses, found.origin, **found.errors), flush=True)
    both = lm.imaging.calibrate_focus(list(planes.values()), list(planes), STATED, **OPTIONS, origin=PUPIL)
    print(f"\nBoth planes: f-number {both.f_number_scale:.4f} ± {both.f_number_error:.4f} times the stated one")
    print(
        f"focus {both.lenses[0].focus_distance:.4f} m; tilts", *(f"{math.ceil(1e3 * p.tilt)} mm" for p in both.planes)
    )


if __name__ == "__main__":
    main()
