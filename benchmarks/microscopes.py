"""Stacks through the layers of a microscope: beside lommel's own stacks of a lens, psfmodels, and the reference."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from importlib.util import find_spec
from typing import Any

import numpy as np

import lommel as lm
from benchmarks.report import Table
from benchmarks.settings import Settings
from benchmarks.timing import Contender, race
from benchmarks.truth import intensity
from lommel.optics.layers.objective_pupil import ObjectivePupil

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
        "NA 1.4, oil, 2 um deep in water or at random depths up to 3 um, 520 nm, pixels of 0.1 um in the sample; "
        "float32, tol 1e-6, one thread, each time a new stack of an objective that was seen before, unless said. "
        "Beside a stack of the same size of a lens, defocused by 20 rad at most, sampled; and beside psfmodels, "
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
        way = lm.DebyeWolf(1e-9)
        exact = intensity(lm.psf(pupil[k], side, _PIXEL, method=way, integrate=options["integrate"], center=at))
        worst = max(worst, float(np.abs(made[k] - exact).max() / exact.max()))
    return worst
