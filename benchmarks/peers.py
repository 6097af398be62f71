"""Other packages, where they are installed: each by its own means, judged by the same quadrature."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks import mixed
from benchmarks import peers_image as image
from benchmarks import peers_stack as stack
from benchmarks.engine import engine
from benchmarks.report import Table
from benchmarks.settings import Settings
from benchmarks.setups import Focus, Setup
from benchmarks.timing import Contender, race
from benchmarks.truth import Question, stack_error, truth

Adapter = Callable[[Any], Iterator[Setup]]


def _adapters() -> tuple[dict[str, tuple[str, Adapter]], dict[str, tuple[str, Adapter]]]:
    """Return the adapters of images and of stacks: name of the distribution to that of the module, and function."""
    images: dict[str, tuple[str, Adapter]] = {
        "prysm": ("prysm", image.prysm),
        "hcipy": ("hcipy", image.hcipy),
        "poppy": ("poppy", image.poppy),
        "dLux": ("dLux", image.dlux),
        "solvephase": ("solvephase", image.solvephase),
        "finufft": ("finufft", image.finufft),
        "ducc0": ("ducc0", image.ducc0),
    }
    stacks: dict[str, tuple[str, Adapter]] = {
        "psf-generator": ("psf_generator", stack.psf_generator),
        "psfmodels": ("psfmodels", stack.psfmodels),
        "MicroscPSF-Py": ("microscPSF", stack.microscpsf),
    }
    return images, stacks


def peer_versions() -> dict[str, str]:
    """Return the versions of the packages that are installed."""
    found = {}
    for group in _adapters():
        for name in group:
            try:
                found[name] = version(name)
            except PackageNotFoundError:
                continue
    return found


_COLUMNS = {"package": "text", "configuration": "text", "over lommel": "spread", "true error": "error", "": "text"}


def images(settings: Settings) -> Table:
    """One PSF of 512² by packages that propagate any pupil."""
    q = Question(10.0, 3.0)
    table = Table(
        "peers",
        "Other packages: one PSF",
        f"512², {q}, one thread. Each package is given the same pupil and, where it can, the same window; its grids, "
        "masks, plans and compiled code are there beforehand, so what is timed is the phase, the propagation and the "
        "squared modulus. The true error is against quadrature at the radii of the package's own pixels, its values "
        "multiplied by the one number that fits best, since the units of intensity differ. Of each package there is "
        "a usual configuration and the most exact one that still is reasonable. Values are samples: here a pixel in "
        "units of λN samples its centre, as poppy, prysm and hcipy do; one in metres averages over its area unless "
        "integrate=False is given.",
        _COLUMNS,
    )
    middle = (q.n - 1) / 2.0
    between = Question(q.defocus, q.spherical, center=(middle, middle))

    def error(one: Setup, values: NDArray[Any]) -> float:
        return truth(between if one.between else q).error(values, fit=True)

    return _run(settings, table, _adapters()[0], q, {False: engine(q)}, error)


def nonradial(settings: Settings) -> Table:
    """One PSF of 512² of a pupil that is not radially symmetric, by the same packages."""
    asked = [mixed.Mixed(pixel=pixel, directions=mixed.RANDOM[0]) for pixel in (0.25, 0.5, 1.0)]
    table = Table(
        "peers-nonradial",
        "Other packages: one PSF of a pupil that is not radially symmetric",
        f"512², coma, astigmatism, trefoil and defocus of {asked[1].reach:g} rad each, directions "
        f"{asked[1].degrees}, one thread, in the same way, but of packages that sample the pupil on a lattice their "
        "usual configuration at 0.5 λN only. An image turned by half a turn, as transforms of the other sign make "
        "it, is as good.",
        {"pixel": "text"} | _COLUMNS,
    )
    images = _adapters()[0]
    for q in asked[1:2] if settings.quick else asked:

        def error(one: Setup, values: NDArray[Any], q: mixed.Mixed = q) -> float:
            seen = replace(q, center=((q.n - 1) / 2.0, (q.n - 1) / 2.0)) if one.between else q
            return min(mixed.error(way, values, fit=True) for way in (seen, seen.turned()))

        most = {"prysm": 1, "hcipy": 1, "dLux": 1, "solvephase": 1, "ducc0": 2}
        adapters = {name: one for name, one in images.items() if q.pixel == 0.5 or name in ("finufft", "ducc0")}
        _run(settings, table, adapters, q, {False: engine(q)}, error, most, before=(f"{q.pixel:g} λN",))
    return table


def stacks(settings: Settings) -> Table:
    """64 planes through focus by packages for microscopes."""
    focus = Focus(planes=16 if settings.quick else 64, n=127 if settings.quick else 255)
    table = Table(
        "peers-stack",
        "Other packages: a stack through focus",
        f"{focus.planes} planes of {focus.n}², abs(C_d) ≤ {focus.reach:g}, pixels of {focus.pixels:g} λN, one "
        f"thread: a scalar microscope of NA {focus.aperture:g} with every refractive index {focus.index:g}, so that "
        "nothing but the defocus is left. The packages have it as k z √(n² − NA² ρ²), which lommel is given as its "
        "series to ρ²⁰. Errors as above, each plane over its own peak, one factor for the stack. A package that "
        "averages over pixels is judged by averages, and compared with `integrate=True`.",
        _COLUMNS,
    )
    mine = {
        averaged: Contender(
            "lommel",
            lambda pupils, averaged=averaged: lm.psf(pupils, focus.n, focus.pixels, threads=1, integrate=averaged),  # type: ignore[misc]
            fresh=focus.fresh,
            values=lambda answer: answer.values,
        )
        for averaged in (False, True)
    }
    known: dict[bool, NDArray[np.float64]] = {}

    def error(one: Setup, values: NDArray[Any]) -> float:
        if one.averaged not in known:
            known[one.averaged] = focus.exact(averaged=one.averaged)
        reference = known[one.averaged]
        got = np.asarray(values, dtype=np.float64).reshape(reference.shape)
        return stack_error(got * (np.vdot(got, reference) / np.vdot(got, got)), reference)

    return _run(settings, table, _adapters()[1], focus, mine, error)


def _run(
    settings: Settings,
    table: Table,
    adapters: dict[str, tuple[str, Adapter]],
    question: Any,
    mine: dict[bool, Contender],
    error: Callable[[Setup, NDArray[Any]], float],
    most: Mapping[str, int] | None = None,
    before: tuple[str, ...] = (),
) -> Table:
    """Measure each package; `most` limits how many of its configurations, `before` comes first in every row."""
    for name, (module, adapter) in adapters.items():
        if find_spec(module) is None:
            table.add(*before, name, None, None, None, "skipped: not installed")
            continue
        setup: Setup | None = None
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                for setup in islice(adapter(question), 1 if settings.quick else (most or {}).get(name)):
                    settings.tick(f"{name}, {setup.config}")
                    one = Contender(name, lambda _, call=setup.call: call())  # type: ignore[misc]
                    first = mine[setup.averaged]
                    result = race([first, one], settings.rounds, budget=0.5 if settings.quick else 2.0)
                    judged = error(setup, result.values[name]) if setup.judged else None
                    table.add(*before, name, setup.config, result.ratio(name, first.name), judged, None)
        except Exception as reason:  # whatever another package raises belongs in its row
            said = " ".join(str(reason).split())[:100]
            table.add(*before, name, setup.config if setup else None, None, None, f"{type(reason).__name__}: {said}")
    return table
