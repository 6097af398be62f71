"""Microscopes from stacks of beads: how often, how exactly and how fast; which constant is named where one is wrong.

Random pupils of 17 Zernike terms (Noll 5 to 21), one bead of 0.1 um on the glass, NA 1.4 oil before water, 21 planes
over 2 um, 31 x 31 pixels, 20 electrons a pixel of background, read noise 1.6. Images are certified ones
(:class:`lommel.methods.Bead`), apart from what fits them. `python benchmarks/beads.py --help` has the options.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import lommel as lm
from benchmarks.report import Table
from benchmarks.settings import Settings

Array = NDArray[np.float64]

WAVE, PIXEL, SIDE, BACKGROUND = 600e-9, 6.5e-6, 31, 20.0
Z = np.linspace(-1e-6, 1e-6, 21)
NOISE = lm.Noise(read=1.6)
GLASS = lm.Layer(1.5255, 170e-6)
STATED = {"diameter": 0.1e-6, "depth": 0.05e-6}


def microscope(**changed: Any) -> lm.Objective:
    """Return the objective, with other numbers."""
    given: dict[str, Any] = {
        "NA": 1.4,
        "magnification": 63,
        "immersion": 1.518,
        "working_distance": 0.19e-3,
        "coverslip": GLASS,
        "sample": 1.33,
        "design": lm.Design(1.518, GLASS),
    }
    return lm.Objective(**given | changed)


class Case(NamedTuple):
    """Coefficients, radians rms, and a stack of a bead."""

    terms: Array
    images: Array
    place: tuple[float, float, float] = (0.0, 0.0, 0.0)  # row and column from the middle pixel, z

    @property
    def wavefront(self) -> lm.Wavefront:
        """The wavefront."""
        return lm.Wavefront.zernike(dict(enumerate(self.terms, 5)), order="noll")


def case(
    seed: int,
    waves: float,
    light: float,
    objective: lm.Objective,
    *,
    depth: float = 0.05e-6,
    diameter: float = 0.1e-6,
    pixel: float = PIXEL,
    z: Array = Z,
) -> Case:
    """Return a random case: so many waves rms, electrons a plane, a place of its own."""
    draw = np.random.default_rng(seed)
    terms = draw.normal(size=17)
    terms *= 2.0 * np.pi * waves / np.linalg.norm(terms)
    made = Case(terms, np.zeros(0))
    row, column = draw.uniform(-1.0, 1.0, 2)
    center, up = (SIDE // 2 + row, SIDE // 2 + column), draw.uniform(-0.1e-6, 0.1e-6)
    planes = {"depth": depth, "z": z - up, "wavelength": WAVE}
    pupil = objective.pupil(**planes, aberrations=made.wavefront)
    method = lm.methods.Bead(diameter, 1e-4)
    psf = lm.psf(pupil, SIDE, pixel, method=method, integrate=True, center=center)
    place = (float(row), float(column), float(up))
    return Case(terms, NOISE.record(light * psf.values.astype(np.float64) + BACKGROUND, draw), place)


def fitted(given: Case, objective: lm.Objective, **more: Any) -> tuple[lm.BeadFit, float]:
    """Return the fit from nothing, and seconds of CPU."""
    asked = {"z": Z, "wavelength": WAVE, "pixel": PIXEL, "noise": NOISE, "priors": {}, "threads": 1} | STATED
    begun = time.process_time()
    found = lm.fit_beads(given.images, objective, **asked | more)
    return found, time.process_time() - begun


class Recovery(NamedTuple):
    """How many random pupils are found, errors over standard errors, seconds, and the PSF 3 um deep."""

    found: int
    count: int
    told: int
    errors: Array
    seconds: float
    deep: list[float]


def recovered(count: int, waves: float, light: float) -> Recovery:
    """Return how well so many random pupils are found."""
    objective, errors, seconds, right, told, deep = microscope(), [], [], 0, 0, []
    for seed in range(count):
        given = case(seed, waves, light, objective)
        found, spent = fitted(given, objective)
        values, errors = (np.array([*of.values()])[:17] for of in (found.coefficients, found.errors))
        off = (values - given.terms) / errors
        seconds.append(spent)
        good = np.abs(off).max() < 6.0
        right += good
        told += found.converged and not good
        if good:
            errors.append(off)
            if light == 1e4 and seed < 10:
                planes = {"depth": 3e-6, "z": np.linspace(-0.6e-6, 0.6e-6, 5)}
                true = objective.pupil(**planes, wavelength=WAVE, aberrations=given.wavefront)
                pair = [lm.psf(one, SIDE, PIXEL, tol=1e-5).values for one in (true, found.pupil(**planes))]
                deep.append(100.0 * np.abs(pair[0] - pair[1]).max() / pair[0].max())
    every = np.abs(np.concatenate(errors)) if errors else np.array([np.nan])
    return Recovery(right, count, told, every, float(np.median(seconds)), deep)


def recovery(count: int, waves: float, light: float) -> str:
    """Return the same in words."""
    right, count, told, every, seconds, deep = recovered(count, waves, light)
    shares = ", ".join(f"{100.0 * np.mean(every < k):.1f}" for k in (1, 2, 3))
    row = (
        f"{waves:g} waves, {light:g} electrons: found {right} of {count}, wrong but converged {told}; errors over "
        f"standard errors {np.sqrt(np.mean(every**2)):.3f}; within 1, 2, 3: {shares} %; "
        f"CPU {seconds:.2f} s"
    )
    return row + (f"; PSF 3 um deep off by {np.median(deep):.2f} % of the peak (median)" if deep else "")


def averaged(count: int, light: float) -> tuple[float, float, float]:
    """Return errors over the peak (percent) of the mean of `count` beads: at their depth, 3 um deep; and of a fit.

    The mean is given the places, the background and the flux; planes and pixels between are by cubic splines. The fit
    is of the first bead alone, and its error is that 3 um deep.
    """
    objective, total = microscope(), np.zeros((len(Z), SIDE, SIDE))
    pupil = case(3, 0.1, light, objective)
    noise = np.random.default_rng(1)
    for _ in range(count):
        row, column, up = (noise.uniform(-1.0, 1.0, 3) * [1.0, 1.0, 0.1e-6]).tolist()
        made = objective.pupil(depth=0.05e-6, z=Z - up, wavelength=WAVE, aberrations=pupil.wavefront)
        center = (SIDE // 2 + row, SIDE // 2 + column)
        bead = lm.psf(made, SIDE, PIXEL, method=lm.methods.Bead(0.1e-6, 1e-4), integrate=True, center=center)
        images = NOISE.record(light * bead.values.astype(np.float64) + BACKGROUND, noise)
        shift = (-up / (Z[1] - Z[0]), -row, -column)
        total += ndimage.shift((images - BACKGROUND) / light, shift, order=3, mode="nearest") / count
    found, _ = fitted(pupil, objective)
    off = []
    for depth in (0.05e-6, 3e-6):
        planes = {"depth": depth, "z": Z, "wavelength": WAVE, "aberrations": pupil.wavefront}
        true = lm.psf(objective.pupil(**planes), SIDE, PIXEL, tol=1e-5).values
        inner = np.s_[3:-3]  # whose neighbours are known
        scale = float((true * total)[inner].sum() / (total * total)[inner].sum())
        off.append(100.0 * float(np.abs(scale * total - true)[inner].max() / true.max()))
        ours = lm.psf(found.pupil(depth=depth, z=Z), SIDE, PIXEL, tol=1e-5).values
    return off[0], off[1], 100.0 * float(np.abs(ours - true).max() / true.max())


def table(settings: Settings) -> Table:
    """Random pupils from beads, beside the mean of beads."""
    found = Table(
        "beads",
        "The PSF of a microscope from beads",
        "Stacks of one bead of 0.1 um on the glass, NA 1.4, oil, 21 planes of 31², seventeen Zernike terms from "
        "nothing, the constants held, one thread; images by `lm.methods.Bead`, apart from those of the fit. Seconds "
        "are of a processor. Means of beads are given their places, flux and background.",
        {"what": "text", "found": "text", "errors over standard errors": "number", "seconds": "number"},
    )
    count = 2 if settings.quick else 20
    for waves, light in ((0.15, 1e4), (0.15, 1e3), (0.3, 1e4)):
        settings.tick(f"{waves} waves")
        one = recovered(count, waves, light)
        rms = float(np.sqrt(np.mean(one.errors**2)))
        what = f"{waves} waves rms, {light:.0f} electrons a plane"
        found.add(what, f"{one.found} of {one.count}", rms, one.seconds)
    settings.tick("means")
    here, deep, ours = averaged(4, 1e4)
    found.notes.append(
        f"PSF 3 um deep, largest error over the peak: {ours:.2g} % of a fit of one bead, {deep:.2g} % of the mean of "
        f"four beads, which is off by {here:.2g} % at their own depth."
    )
    return found


def wrong(light: float) -> list[str]:
    """Return which constant is named for stacks of microscopes that differ in one from the one that is stated."""
    design = lm.Design(1.515, GLASS)
    rows: list[tuple[str, lm.Objective, dict[str, Any], lm.Objective, dict[str, Any]]] = [
        ("sample 1.38, 1.33", microscope(sample=1.38), {}, microscope(), {}),
        ("immersion 1.518, 1.515", microscope(design=design), {}, microscope(design=design, immersion=1.515), {}),
        ("NA 1.37, 1.40", microscope(NA=1.37), {}, microscope(), {}),
        ("depth 0.30, 0.05 um", microscope(), {"depth": 0.3e-6}, microscope(), {}),
        ("pixel 102, 100 %", microscope(), {"pixel": 1.02 * PIXEL}, microscope(), {}),
        ("bead 0.2, 0.1 um", microscope(), {"depth": 0.1e-6, "diameter": 0.2e-6}, microscope(), {"depth": 0.1e-6}),
        ("cover glass 180, 170 um", microscope(coverslip=lm.Layer(1.5255, 180e-6)), {}, microscope(), {}),
        ("step 3 % smaller", microscope(), {}, microscope(), {"z": 0.97 * Z}),
        ("reversed order", microscope(), {"z": -Z}, microscope(), {}),
        ("all right", microscope(), {}, microscope(), {}),
    ]
    found = []
    for name, true, made, stated, told in rows:
        given = case(3, 0.1, light, true, **made)
        found.append(f"{name}: {fitted(given, stated, **told)[0].message}")
    return found


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--count", type=int, default=100, help="pupils of each row")
    parser.add_argument("--rows", default="recovery,wrong", help="which tables")
    asked = parser.parse_args()
    if "recovery" in asked.rows:
        for waves, light in ((0.15, 1e4), (0.15, 1e3), (0.15, 1e5), (0.3, 1e4)):
            print(recovery(asked.count, waves, light), flush=True)
    if "wrong" in asked.rows:
        print("\n".join(wrong(1e4)))


if __name__ == "__main__":
    sys.exit(main())
