"""Wavefronts from three defocused images of a star: how often, how exactly and how fast, beside what is possible.

Random wavefronts of 15 Zernike terms; 33 x 33 pixels of lambda*N/2; defocus -4, 0, 4 radians; 5 electrons a pixel of
background, reading noise 2. Images are computed to 1e-9, apart from what fits them. A second table has dim stars on
several backgrounds, 25 x 25 pixels: how often standard errors hold where the verdict says so. `python
benchmarks/retrieval.py --help` has the options; with --peers, solvephase fits the very same images, in turns with
lommel.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import lommel as lm
import searches
from lommel.estimation.phase_retrieval import Retrieval

Array = NDArray[np.float64]

DEFOCUS = np.array([-4.0, 0.0, 4.0])
NOISE = lm.Noise(read=2.0)
SIDE, PIXEL, BACKGROUND, COUNT = 33, 0.5, 5.0, 15
WAVELENGTH = 1e-6  # of solvephase, whose wavefronts are path differences


class Case(NamedTuple):
    """A wavefront, radians rms by Noll's index from `first` on, and images of it."""

    terms: Array
    first: int
    images: Array

    @property
    def names(self) -> list[str]:
        """What to solve for."""
        return [f"noll {j}" for j in range(self.first, self.first + len(self.terms))]


def case(
    draw: np.random.Generator,
    rms: float,
    photons: float,
    first: int,
    *,
    side: int = SIDE,
    background: float = BACKGROUND,
) -> Case:
    """Return a random case; without tilts among its terms, each image has a place of its own."""
    terms = draw.normal(size=COUNT)
    terms *= rms / np.linalg.norm(terms)
    wavefront = lm.Wavefront.zernike(dict(enumerate(terms, first)), order="noll") + lm.Wavefront(defocus=DEFOCUS)
    shift = draw.uniform(-0.5, 0.5, (2, 3)) if first > 3 else np.zeros((2, 3))
    center = (side // 2 + shift[0], side // 2 + shift[1])
    mean = photons * lm.psf(lm.Pupil(wavefront), side, PIXEL, center=center, tol=1e-9).values + background
    return Case(terms, first, NOISE.record(np.maximum(mean, 0.0), draw))


def ours(one: Case) -> Retrieval:
    """Fit by lommel."""
    return searches.retrieve(
        one.images, lm.Pupil(), pixel=PIXEL, noise=NOISE, defocus=DEFOCUS, terms=one.names,
        also=("center",) if one.first > 3 else (), threads=1,
    )  # fmt: skip


class Statistics(NamedTuple):
    """Of many fits."""

    fits: int
    converged: int
    wrong: int
    reliable: int
    over_bound: float
    scatter: float
    median_ms: float
    mean_ms: float

    def line(self, name: str) -> str:
        """Return a row of a table in Markdown."""
        return (
            f"| {name} | {self.converged} of {self.fits} | {self.wrong} | {self.reliable} | {self.over_bound:.3f} | "
            f"{self.scatter:.3f} | {self.median_ms:.1f} | {self.mean_ms:.1f} |"
        )


HEAD = """| wavefronts | converged | of these wrong | reliable | error / bound | std of z | ms, median | mean |
|---|---|---|---|---|---|---|---|"""


def sweep(rms: float, photons: float, first: int, fits: int, seed: int = 0) -> Statistics:
    """Fit so many random wavefronts. The bound is that of the information at the truth, not at the answer."""
    draw = np.random.default_rng(seed)
    cases = [case(draw, rms, photons, first) for _ in range(fits)]
    ours(cases[0])
    errors, spreads, seconds, wrong, reliable = [], [], [], 0, 0
    for one in cases:
        start = time.process_time()
        found = ours(one)
        seconds.append(time.process_time() - start)
        reliable += found.reliable
        if not found.converged:
            continue
        error = np.array([found.coefficients[name] for name in one.names]) - one.terms
        spread = np.array([found.errors[name] for name in one.names])
        if np.abs(error / spread).max() > 8.0:
            wrong += 1
        errors.append(error)
        spreads.append(spread)
    e, s = np.array(errors), np.array(spreads)
    ratio = float(np.sqrt((e**2).sum() / (s**2).sum()))
    times = 1e3 * np.array(seconds)
    return Statistics(
        fits, len(errors), wrong, reliable, ratio, float(np.std(e / s)), float(np.median(times)), float(times.mean())
    )


class Dim(NamedTuple):
    """Of many fits to dim stars, half of 0.3 and half of 0.7 radians rms."""

    fits: int
    converged: int
    reliable: int
    off: int  # converged, with an error above four standard errors
    reliable_off: int
    chi2: float

    def line(self, name: str) -> str:
        """Return a row of a table in Markdown."""
        return (
            f"| {name} | {self.converged} of {self.fits} | {self.off} | {self.reliable} | {self.reliable_off} | "
            f"{self.chi2:.3f} |"
        )


DIM_HEAD = """| electrons an image, background | converged | beyond 4 sigma | reliable | beyond 4 sigma | mean chi2 |
|---|---|---|---|---|---|"""


def dim(photons: float, background: float, fits: int, seed: int = 0) -> Dim:
    """Fit so many dim stars."""
    draw = np.random.default_rng([seed, int(photons), int(background)])
    converged, off, chi2 = [], [], []
    for k in range(fits):
        one = case(draw, (0.3, 0.7)[k % 2], photons, 4, side=25, background=background)
        found = ours(one)
        if found.converged:
            error = np.array([found.coefficients[name] for name in one.names]) - one.terms
            spread = np.array([found.errors[name] for name in one.names])
            converged.append(found.reliable)
            off.append(np.abs(error / spread).max() > 4.0)
            chi2.append(found.chi2)
    sure, wrong = np.array(converged, dtype=bool), np.array(off, dtype=bool)
    mean = float(np.mean(chi2)) if chi2 else np.nan
    return Dim(fits, len(converged), int(sure.sum()), int(wrong.sum()), int((wrong & sure).sum()), mean)


class Duel(NamedTuple):
    """lommel and solvephase on the same images."""

    fits: int
    ours: float
    theirs: float
    our_ms: float
    their_ms: float
    times: float

    def line(self) -> str:
        """Return what came out, in a sentence."""
        return (
            f"{self.fits} fits: rms error {self.ours:.5f} rad by lommel, {self.theirs:.5f} rad by solvephase (method "
            f'"lm", 64 x 64 samples of the pupil), ratio {self.ours / self.theirs:.3f}; CPU time {self.our_ms:.1f} '
            f"and {self.their_ms:.1f} ms, {self.times:.1f} times as long (median of neighbouring turns)"
        )


def duel(rms: float, photons: float, fits: int, seed: int = 0) -> Duel:
    """Fit the same images by both: Noll's terms 2 to 16, which all images share."""
    import solvephase

    draw = np.random.default_rng(seed)
    pupil = solvephase.Pupil.circular(64)
    metres = WAVELENGTH / (2.0 * np.pi)
    y, x = (2.0 * part for part in pupil.coordinates())
    weight = np.asarray(pupil.amplitude) ** 2

    def theirs(one: Case) -> Any:
        return solvephase.retrieve(
            one.images, pupil, WAVELENGTH, sampling=1.0 / PIXEL, diversity=list(DEFOCUS / np.sqrt(3.0) * metres),
            basis=COUNT, method="lm", loss="poisson", read_noise=NOISE.read, precision="double",
        )  # fmt: skip

    def square(one: Case, phase: Array) -> float:
        """Return the mean square error over the samples of the pupil."""
        true = lm.Wavefront.zernike(dict(enumerate(one.terms, one.first)), order="noll")
        left = phase - true.phase(*points)
        mean = (weight * left).sum() / weight.sum()
        return float((weight * (left - mean) ** 2).sum() / weight.sum())

    points = np.hypot(x, y), np.arctan2(y, x)
    cases = [case(draw, rms, photons, 2) for _ in range(fits + 1)]
    squares, seconds = [], []
    for k, one in enumerate(cases):
        # Threads of the other's BLAS wait busily for a while after its call: lommel has one, whose time this is.
        begun = time.thread_time()
        mine = ours(one)
        taken, start = time.thread_time() - begun, time.process_time()
        other = theirs(one)
        end = time.process_time()
        if k:  # the first warms up
            phases = mine.wavefront.phase(*points), np.asarray(other.opd) / metres
            squares.append([square(one, phase) for phase in phases])
            seconds.append((taken, end - start))
    (a, b), t = np.sqrt(np.mean(squares, axis=0)), 1e3 * np.array(seconds)
    return Duel(
        fits, float(a), float(b), *(float(m) for m in np.median(t, axis=0)), float(np.median(t[:, 1] / t[:, 0]))
    )


def main() -> None:
    """Run all and print tables in Markdown."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--fits", type=int, default=100)
    parser.add_argument("--peers", type=Path, help="a folder with solvephase, such as .tools/peers")
    options = parser.parse_args()
    print(HEAD)
    for rms, first in ((1.0, 4), (1.0, 2), (3.0, 2), (2.0, 4), (3.0, 4)):
        for photons in (1e4, 1e5):
            own = "Noll 4 to 18, own places" if first > 3 else "Noll 2 to 16"
            print(sweep(rms, photons, first, options.fits).line(f"{own}, {rms:g} rad, {photons:.0e} e"), flush=True)
    print(f"\n{DIM_HEAD}")
    for photons in (500, 1000, 2000, 3000, 10_000, 100_000):
        for background in (0.0, 5.0, 20.0):
            print(dim(photons, background, options.fits).line(f"{photons}, {background:g}"), flush=True)
    if options.peers is not None:
        sys.path.append(str(options.peers))
        for photons in (1e4, 1e5):
            print(f"\n{photons:.0e} e: {duel(1.0, photons, min(options.fits, 40)).line()}", flush=True)


if __name__ == "__main__":
    main()
