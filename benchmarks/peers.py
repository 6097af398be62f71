"""Other packages, where they are installed: each by its own means, judged by the same quadrature."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks import mixed
from benchmarks.engine import engine
from benchmarks.report import Table
from benchmarks.settings import Settings
from benchmarks.timing import Contender, race
from benchmarks.truth import Question, exact, exact_stack, stack_error, truth


@dataclass(frozen=True)
class Setup:
    """One configuration of a package.

    Attributes
    ----------
    config : str
    call : callable
        Computes the image or the stack; the grids, masks and plans that do not depend on the aberrations are there.
    between : bool
        Whether the axis of the window lies between its middle pixels.
    averaged : bool
        Whether pixels average the intensity over their area.
    judged : bool
        Whether what `call` returns is an intensity that can be judged.
    """

    config: str
    call: Callable[[], Any]
    between: bool = False
    averaged: bool = False
    judged: bool = True


@dataclass(frozen=True)
class Focus:
    """A stack through focus of a scalar microscope, all refractive indices alike.

    The phase ``k z sqrt(n^2 - NA^2 rho^2)`` is no paraxial one: its series in rho^2 to rho^20, which at this NA is
    exact to 1e-5 rad, is what lommel is given.
    """

    n: int = 255
    planes: int = 64
    aperture: float = 0.8
    index: float = 1.5
    wavelength: float = 0.55
    pixels: float = 0.5
    reach: float = 20.0

    @property
    def pixel(self) -> float:
        """Pixel pitch in micrometres."""
        return self.pixels * self.wavelength / (2.0 * self.aperture)

    @property
    def z(self) -> NDArray[np.float64]:
        """Defocus in micrometres, C_d = `reach` at the ends; whole nanometres, as one of the packages needs them."""
        far = 2.0 * self.reach * self.index * self.wavelength / (np.pi * self.aperture**2)
        return np.linspace(-1.0, 1.0, self.planes) * round(1000.0 * far) / 1000.0

    def pupil(self, share: float = 1.0) -> lm.Pupil:
        """Return the stack of pupils."""
        phase = 2.0 * np.pi / self.wavelength * self.index * share * self.z
        square, term, series = (self.aperture / self.index) ** 2, 1.0, []
        for k in range(1, 11):
            term *= -square * (1.5 - k) / k
            series.append(phase * term)
        return lm.Pupil(lm.Wavefront(0.5 * series[0], series[1], series[2:]))

    def fresh(self, count: int) -> list[lm.Pupil]:
        """Return that many new stacks."""
        return [self.pupil(1.0 - 1e-7 * k) for k in range(count)]

    def exact(self, *, averaged: bool) -> NDArray[np.float64]:
        """Return the exact stack, of samples or of averages over pixels (25 points each)."""
        if not averaged:
            return exact_stack(self.pupil(), self.n, self.pixels)
        x, w = np.polynomial.legendre.leggauss(5)
        # A quadrant, from the axis outwards, is enough.
        half = self.n // 2
        at = np.arange(half + 1)[:, None] + 0.5 * x
        total = np.zeros((self.planes, half + 1, half + 1))
        for j in range(x.size):
            for i in range(x.size):
                part = exact(self.pupil(), at[:, j, None], at[:, i], np.pi * self.pixels)
                total += 0.25 * w[j] * w[i] * part
        mirror = np.abs(np.arange(self.n) - half)
        return total[:, mirror[:, None], mirror]


Adapter = Callable[[Any], Iterator[Setup]]


def _adapters() -> tuple[dict[str, tuple[str, Adapter]], dict[str, tuple[str, Adapter]]]:
    """Return the adapters of images and of stacks: name of the distribution to that of the module, and function."""
    from benchmarks import peers_image as image
    from benchmarks import peers_stack as stack

    images: dict[str, tuple[str, Adapter]] = {
        "prysm": ("prysm", image.prysm),
        "hcipy": ("hcipy", image.hcipy),
        "poppy": ("poppy", image.poppy),
        "dLux": ("dLux", image.dlux),
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
        "a usual configuration and the most exact one that still is reasonable.",
        _COLUMNS,
    )
    middle = (q.n - 1) / 2.0
    between = Question(q.defocus, q.spherical, center=(middle, middle))

    def error(one: Setup, values: NDArray[Any]) -> float:
        return truth(between if one.between else q).error(values, fit=True)

    return _run(settings, table, _adapters()[0], q, {False: engine(q)}, error)


def nonradial(settings: Settings) -> Table:
    """One PSF of 512² of a pupil that is not radially symmetric, by the same packages."""
    q = mixed.Mixed(directions=mixed.RANDOM[0])
    table = Table(
        "peers-nonradial",
        "Other packages: one PSF of a pupil that is not radially symmetric",
        f"512², coma, astigmatism, trefoil and defocus of {q}, one thread, in the same way, but of packages "
        "that sample the pupil on a lattice their usual configuration only. An image turned by half a turn, as "
        "transforms of the other sign make it, is as good.",
        _COLUMNS,
    )

    def error(one: Setup, values: NDArray[Any]) -> float:
        seen = replace(q, center=((q.n - 1) / 2.0, (q.n - 1) / 2.0)) if one.between else q
        return min(mixed.error(way, values, fit=True) for way in (seen, seen.turned()))

    most = {"prysm": 1, "hcipy": 1, "dLux": 1}
    return _run(settings, table, _adapters()[0], q, {False: engine(q)}, error, most)


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
) -> Table:
    """Measure each package; `most` limits how many of its configurations."""
    for name, (module, adapter) in adapters.items():
        if find_spec(module) is None:
            table.add(name, None, None, None, "skipped: not installed")
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
                    table.add(name, setup.config, result.ratio(name, first.name), judged, None)
        except Exception as reason:  # whatever another package raises belongs in its row
            said = " ".join(str(reason).split())[:100]
            table.add(name, setup.config if setup else None, None, None, f"{type(reason).__name__}: {said}")
    return table
