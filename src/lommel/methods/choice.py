"""Automatic choice of a method by pupil and window, and of the methods tried next."""

# Annotations are not postponed: a NamedTuple compiles each that is text, which takes longer than all else here.

import math
from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple, TypeVar

import numpy as np

from lommel.core.answers import Declined, ToleranceError
from lommel.methods.method import Method
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.optics.base_pupil import BasePupil, imaged
from lommel.optics.grid import Grid

if TYPE_CHECKING:
    from lommel.methods.hankel import Hankel
    from lommel.optics.layers.objective_pupil import ObjectivePupil

# A stack computed in parts uses one method for all parts; the cost is estimated from some of its pupils.
_LOOKS = 8  # number of pupils from which the cost of a stack is estimated
_Answer = TypeVar("_Answer")


class Rule(NamedTuple):
    """Methods for a class of pupils and windows, with a description."""

    pupils: str
    applies: Callable[[BasePupil, Grid], bool]
    imported: Callable[[], tuple[Callable[[float], Method], ...]]
    costs: str

    @property
    def methods(self) -> tuple[Callable[[float], Method], ...]:
        """Constructors of the methods, in the order in which they are tried."""
        return self.imported()


# Imported late: most pupils are radially symmetric and use none of these.


def _whichever_is_cheaper() -> tuple[Callable[[float], Method], ...]:
    from lommel.methods.chordal_gauss import ChordalGauss, ChordalIfCheaper

    return ChordalIfCheaper, NijboerZernike, ChordalGauss


def _nonuniform() -> tuple[Callable[[float], Method], ...]:
    from lommel.methods.nonuniform_fft import NonuniformFFT

    return (NonuniformFFT,)


def _stratified() -> tuple[Callable[[float], Method], ...]:
    from lommel.methods.layers.stratified import Stratified

    return (Stratified,)


def _chords_or_rings() -> tuple[Callable[[float], Method], ...]:
    from lommel.methods.layers.chordal_debye import ChordalDebyeIfCheaper
    from lommel.methods.layers.debye_rings import DebyeRings

    return ChordalDebyeIfCheaper, DebyeRings


RULES = (
    Rule(
        "microscope objective with measured aberrations",
        lambda pupil, _: pupil.aberrated,
        _chords_or_rings,
        "two matrix products in small windows; or one per azimuthal order, FFTs on circles, a sparse product",
    ),
    Rule(
        "microscope objective",
        lambda pupil, _: pupil.layered,
        _stratified,
        "one matrix product per stack, and writing the image",
    ),
    Rule(
        "radially symmetric",
        lambda pupil, _: pupil.radial,
        lambda: (NijboerZernike,),
        "little more than writing the image",
    ),
    Rule(
        "circular or annular, by whichever is likely to take less time",
        lambda pupil, _: pupil.circular,
        _whichever_is_cheaper,
        "two matrix products; or a sum over azimuthal orders for an eighth of the pixels",
    ),
    Rule(
        "any other aperture",
        lambda *_: True,
        _nonuniform,
        "non-uniform FFTs along the rows of the aperture and across them",
    ),
)
"""The first rule that applies is used."""


def table() -> str:
    """Return the rules as a Markdown table, for the page on the choice of a method."""
    rows = [("pupil", "method", "cost"), ("---",) * 3]
    for rule in RULES:
        names = dict.fromkeys(type(method(Method.tol).reported).__name__ for method in rule.methods)
        rows.append((rule.pupils, ", ".join(f"`{name}`" for name in names), rule.costs))
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)


def candidates(pupil: BasePupil, grid: Grid, tol: float = Method.tol) -> tuple[Method, ...]:
    """Return the methods for a pupil and a window, in the order in which they are tried, by :data:`RULES`."""
    imaged(pupil)
    rule = next(rule for rule in RULES if rule.applies(pupil, grid))
    return _made(rule, tol)


@lru_cache(maxsize=64)
def _made(rule: Rule, tol: float) -> tuple[Method, ...]:
    return tuple(method(tol) for method in rule.methods)


def of_derivatives(pupil: "ObjectivePupil", ways: tuple[Method, ...]) -> tuple[Method, ...]:
    """Return the methods for derivatives of an objective; the last one has those by Zernike terms."""
    from lommel.methods.layers.chordal_debye import ChordalDebye, ChordalDebyeIfCheaper

    tol = ways[0].tol
    # Light that depends on the azimuth needs new tables over circles for other planes: chords come first.
    first = () if pupil.aberrated or pupil.light.radial else (ChordalDebyeIfCheaper(tol),)
    return (*first, *ways, ChordalDebye(tol))


def first_within_tolerance(ways: tuple[Method, ...], ask: Callable[[Method], _Answer]) -> tuple[Method, _Answer]:
    """Return the first method that neither declines nor misses its tolerance, and its answer."""
    # The chordal rule judges errors by the window alone and takes a limited number of chords; a dark window is left
    # to the series. Errors of other types are faults, and are not caught.
    refused: ToleranceError | Declined | None = None
    for way in ways:
        try:
            return way, ask(way)
        except (ToleranceError, Declined) as error:
            # A missed tolerance says what is possible, so it is reported first; else the reason of the series, not of
            # chords.
            if (
                refused is None
                or isinstance(error, ToleranceError)
                or (isinstance(refused, Declined) and way != ways[-1])
            ):
                # Without its traceback, whose frames keep the arrays of the refused method alive.
                refused = error.with_traceback(None)
    assert refused is not None
    raise refused


def instead(pupil: BasePupil, grid: Grid) -> str:
    """Return a hint on a method without a bound for images that are beyond all methods of the choice, or ""."""
    from lommel.methods.matrix_fourier import samples_needed
    from lommel.methods.paper.fraunhofer import Fraunhofer
    from lommel.optics.pupil import checked

    try:
        lens = checked(pupil)
        if not lens.circular:
            return ""
        sampled = Fraunhofer(samples=max(256, samples_needed(lens, grid)[0]))
        sampled.require_fit(lens, grid)
    except (TypeError, ValueError):  # an objective, axes of their own, or too many samples
        return ""
    return f"; method=lommel.Fraunhofer(samples={sampled.samples}) computes them, without a bound on its error"


def fixed_order(ways: tuple[Method, ...], pupil: BasePupil, grid: Grid) -> tuple[Method, ...]:
    """Return the methods for a stack computed in parts, in an order in which one method serves all parts."""
    if len(ways) == 1:
        return ways
    # Alternating methods would change values between parts, within the tolerance but visibly in differences.
    if pupil.layered:
        return ways[-1:]
    from lommel.core.engine import disk_costs
    from lommel.methods.averaging import samples_across
    from lommel.methods.nijboer_zernike import disk_stack, window_of
    from lommel.optics.pupil import checked

    lens, count = checked(pupil), math.prod(pupil.shape)
    few = lens[np.unravel_index(np.arange(0, count, -(-count // _LOOKS)), pupil.shape)] if pupil.shape else lens
    across = samples_across(grid.step(pupil)) if grid.integrate else 1
    height, width = (across * side for side in grid.shape)
    samples = Grid((height, width), grid.side / across)
    _, series, chords = ways
    try:
        # Estimated times of chords and of the series, from the compiled core.
        costs = disk_costs(disk_stack(few), window_of(few, samples), series.tol)
    except Declined:
        return series, chords
    return (chords, series) if costs[0] <= costs[1] else (series, chords)


def of_profiles(tol: float = Method.tol) -> NijboerZernike:
    """Return the method for profiles of radial pupils and integrals over them."""
    return NijboerZernike(tol)


def of_large_phases(tol: float) -> "Hankel":
    """Return the method for many radial pupils with large phases at the same radii."""
    from lommel.methods.hankel import Hankel

    return Hankel(tol)


def reference(pupil: BasePupil) -> Method:
    """Return the reference method: quadrature, or the series at a small tolerance where that does not apply."""
    if pupil.layered:
        from lommel.methods.layers.debye_wolf import DebyeWolf

        return _chords_or_rings()[-1](1e-9) if pupil.aberrated else DebyeWolf(tol=1e-9)
    if pupil.radial:
        from lommel.methods.hankel import Hankel  # for reports, which are rare

        return Hankel()
    if pupil.circular:
        return NijboerZernike(tol=1e-9)
    from lommel.methods.nonuniform_fft import NonuniformFFT

    return NonuniformFFT(tol=1e-9)
