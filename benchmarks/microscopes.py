"""Stacks through the layers of a microscope: beside lommel's own stacks of a lens, psfmodels, and the reference."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from importlib.util import find_spec
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

import lommel as lm
import searches
from benchmarks.report import Table
from benchmarks.timing import Contender, Settings, race
from benchmarks.truth import intensity
from lommel.estimation.beads import BeadFit
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.stratified import Design

_WAVE, _NM = 520e-9, 1e-7  # the latter the pixel in the sample
_LENS, _COPY = "a lens's stack, samples", "psfmodels, vectorial, sf=1"
_SAMPLED = 'pyotf, vec_corr="none"'
_OBJECTIVE = lm.Objective(
    NA=1.4,
    magnification=63,
    immersion=1.518,
    working_distance=0.19e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.33,
)
_PIXEL = 63 * _NM


def microscopes(settings: Settings) -> Table:
    """Each beside the lens's stack of the same window, and beside psfmodels and pyotf where these are there."""
    table = Table(
        "microscopes",
        "Microscopes",
        "NA 1.4, oil, 2 um deep in water or at random depths up to 3 um, 520 nm, pixels of 0.1 um in the sample. "
        "Float32, tol 1e-6, one thread, each time a new stack of an objective that was seen before, unless said. "
        "Beside a stack of the same size of a lens, defocused by 20 rad at most, sampled. Beside psfmodels, "
        "whose values are interpolated linearly, or pyotf, of which scalar light in one medium is asked, a transform "
        "a plane: the least that it computes. True errors are over the peak of each plane, against the reference.",
        {
            "what": "text",
            "over a lens's": "spread",
            "psfmodels over it": "spread",
            "pyotf over it": "spread",
            "true error": "error",
        },
    )
    for side in (257, 64):
        planes = 64
        mine = _contender(f"{planes} planes of {side}²", side, lambda k: _focal(k, 64), integrate=False)
        one = _contender("averages over pixels", side, lambda k: _focal(k, 64), integrate=True)
        others = [mine, _lens(side, planes), *_psfmodels(side, planes)]
        _add(settings, table, mine, [*others, *_pyotf(side, planes)], _checked(mine, side, integrate=False))
        if side == 64:
            _add(settings, table, one, [one, *others[1:]], _checked(one, side, integrate=True))
    fresh = _contender("64 planes of 257², a new objective", 257, _new, integrate=False)
    _add(settings, table, fresh, [fresh, _lens(257, 64)], None)
    measured = _contender("64 planes of 257², five Zernike terms on top", 257, _measured, integrate=False)
    _add(settings, table, measured, [measured, _lens(257, 64, _FIVE)], None)
    centers = 12 + np.random.default_rng(7).uniform(-0.5, 0.5, (2, 1000))
    ways: list[tuple[str, dict[str, Any]]] = [
        ("1000 of 25², each at its own depth and stage", {"integrate": False}),
        ("the same, each around its own axis", {"integrate": False, "center": tuple(centers)}),
        ("the same, averages over pixels", {"integrate": True, "center": tuple(centers)}),
    ]
    for name, options in ways:
        mine = _contender(name, 25, _random, **options)
        _add(settings, table, mine, [mine, _lens(25, 1000)], _checked(mine, 25, **options))
    for name, options in ways[1:]:
        mine = _contender(f"{name}, with derivatives by z, row, column", 25, _random, _SLOPES, **options)
        _add(settings, table, mine, [mine, _lens(25, 1000)], None)
    return table


_FIVE = lm.Wavefront.zernike({5: 0.08, 6: -0.04, 7: 0.05, 8: 0.03, 11: -0.04}, order="noll", unit="waves")
_SLOPES = ("z", "row", "column")


def _add(settings: Settings, table: Table, mine: Contender, all_of: list[Contender], error: float | None) -> None:
    settings.tick(mine.name)
    result = race(all_of, settings.rounds)
    peers = [result.ratio(peer, mine.name) if peer in result.seconds else None for peer in (_COPY, _SAMPLED)]
    table.add(mine.name, result.ratio(mine.name, _LENS), *peers, error)


def _focal(k: int, planes: int) -> ObjectivePupil:
    """Return a stack through focus, none like another."""
    z = (np.arange(planes) - planes // 2) * 2e-7 + 1e-13 * k
    return _OBJECTIVE.pupil(depth=2e-6, z=z, wavelength=_WAVE)


def _measured(k: int) -> ObjectivePupil:
    """Return such a stack with a measured wavefront; the lens beside it has the same terms."""
    z = (np.arange(64) - 32) * 2e-7 + 1e-13 * k
    return _OBJECTIVE.pupil(depth=2e-6, z=z, wavelength=_WAVE, aberrations=_FIVE)


def _random(k: int) -> ObjectivePupil:
    random = np.random.default_rng(k)
    depth, z = random.uniform(0.0, 3e-6, 1000), random.uniform(-1e-6, 1e-6, 1000)
    return _OBJECTIVE.pupil(depth=depth, z=z, wavelength=_WAVE, origin="paraxial")


def _new(k: int) -> tuple[lm.Objective, int]:
    """Return an objective that has never been seen."""
    _new.seen += 1  # type: ignore[attr-defined]
    return replace(_OBJECTIVE, NA=1.4 - 1e-5 * _new.seen), k  # type: ignore[attr-defined]


_new.seen = 0  # type: ignore[attr-defined]


def _contender(
    name: str, side: int, stack: Callable[[int], Any], derivatives: Sequence[str] = (), **options: Any
) -> Contender:
    def call(given: Any) -> Any:
        if isinstance(given, tuple):
            z = (np.arange(64) - 32) * 2e-7
            given = given[0].pupil(depth=2e-6, z=z, wavelength=_WAVE)
        return lm.psf(given, side, _PIXEL, threads=1, derivatives=derivatives, **options)

    return Contender(name, call, fresh=lambda count: [stack(k) for k in range(count)], values=intensity)


def planes() -> Contender:
    """Return a stack of 64 planes of 64²."""
    return _contender("planes", 64, lambda k: _focal(k, 64))


def _lens(side: int, planes: int, more: lm.Wavefront | None = None) -> Contender:
    def fresh(count: int) -> list[lm.Pupil]:
        through = [lm.Wavefront(np.linspace(-20.0, 20.0, planes) + 1e-9 * k) for k in range(count)]
        return [lm.Pupil(each if more is None else each + more) for each in through]

    pixel = _NM * 2.0 * _OBJECTIVE.NA / _WAVE
    return Contender(_LENS, lambda pupil: lm.psf(pupil, side, pixel, threads=1), fresh=fresh, values=intensity)


def _psfmodels(side: int, planes: int) -> list[Contender]:
    if find_spec("psfmodels") is None:
        return []
    from psfmodels import make_psf

    z = list((np.arange(planes) - planes // 2) * 0.2)
    layers = {
        "NA": 1.4,
        "ni": 1.518,
        "ni0": 1.518,
        "ns": 1.33,
        "ng": 1.5255,
        "ng0": 1.5255,
        "tg": 170.0,
        "tg0": 170.0,
    }
    options: dict[str, Any] = layers | {"pz": 2.0, "wvl": 0.52, "model": "vectorial", "oversample_factor": 1}

    def call(_: Any) -> Any:
        return make_psf(z, side, dxy=0.1, normalize=False, **options)

    return [Contender(_COPY, call)]


def _pyotf(side: int, planes: int) -> list[Contender]:
    """Return pyotf where transforms suit it, as it is run again and again: of one object whose planes are set."""
    if side % 2 or find_spec("pyotf") is None:
        return []
    from pyotf.otf import HanserPSF

    made = HanserPSF(wl=520.0, na=1.4, ni=1.518, res=100.0, size=side, zres=200.0, zsize=planes, vec_corr="none")
    z = made.zrange

    def call(k: Any) -> Any:
        made.zrange = z + 1e-4 * k
        return made.PSFi

    return [Contender(_SAMPLED, call, fresh=range)]


def _checked(one: Contender, side: int, **options: Any) -> float:
    """Return the true error of some planes."""
    pupil, worst = one.fresh(1)[0], 0.0
    made = one.values(one.call(pupil))
    for k in range(0, len(made), max(1, len(made) // 4)):
        center = options.get("center")
        at = None if center is None else (float(center[0][k]), float(center[1][k]))
        way = lm.methods.DebyeWolf(1e-9)
        exact = intensity(lm.psf(pupil[k], side, _PIXEL, method=way, integrate=options["integrate"], center=at))
        worst = max(worst, float(np.abs(made[k] - exact).max() / exact.max()))
    return worst


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
        "design": Design(1.518, GLASS),
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


def fitted(given: Case, objective: lm.Objective, **more: Any) -> tuple[BeadFit, float]:
    """Return the fit from nothing, and seconds of CPU."""
    asked = {"z": Z, "noise": NOISE, "priors": {}, "threads": 1} | STATED | more
    microscope = lm.Microscope(objective, WAVE, asked.pop("pixel", PIXEL))
    begun = time.process_time()
    found = searches.fit_beads(given.images, microscope, **asked)
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
    objective, ratios, seconds, right, told, deep = microscope(), [], [], 0, 0, []
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
            ratios.append(off)
            if light == 1e4 and seed < 10:
                planes = {"depth": 3e-6, "z": np.linspace(-0.6e-6, 0.6e-6, 5)}
                true = objective.pupil(**planes, wavelength=WAVE, aberrations=given.wavefront)
                pair = [lm.psf(one, SIDE, PIXEL, tol=1e-5).values for one in (true, found.pupil(**planes))]
                deep.append(100.0 * np.abs(pair[0] - pair[1]).max() / pair[0].max())
    every = np.abs(np.concatenate(ratios)) if ratios else np.array([np.nan])
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


def beads(settings: Settings) -> Table:
    """Random pupils from beads, beside the mean of beads."""
    found = Table(
        "beads",
        "The PSF of a microscope from beads",
        "Stacks of one bead of 0.1 um on the glass, NA 1.4, oil, 21 planes of 31², seventeen Zernike terms from "
        "nothing, the constants held, one thread. Images by `lm.methods.Bead`, apart from those of the fit. Seconds "
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
        f"four beads. Their mean is off by {here:.2g} % at their own depth."
    )
    return found


def wrong(light: float) -> list[str]:
    """Return which constant is named for stacks of microscopes that differ in one from the one that is stated."""
    design = Design(1.515, GLASS)
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
