"""Automatic choice of methods: the methods for a pupil and a window, in the order in which they are tried."""

# No `from __future__ import annotations`: NamedTuple would compile them, which takes longer than the other imports.

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
    from lommel.optics.layers.objective_pupil import ObjectivePupil

_COST_PUPILS = 8  # the cost of a stack is estimated from at most this number of its pupils
_Result = TypeVar("_Result")


class Rule(NamedTuple):
    """Methods for a class of pupils and windows."""

    pupils: str  # description of the class of pupils
    applies: Callable[[BasePupil, Grid], bool]
    import_methods: Callable[[], tuple[Callable[[float], Method], ...]]
    costs: str  # description of the computing time

    @property
    def methods(self) -> tuple[Callable[[float], Method], ...]:
        """Constructors of the methods, each with the tolerance as argument, in the order in which they are tried."""
        return self.import_methods()


# Functions import methods when they are called: most pupils are radially symmetric and need none of these methods.


def _disk_methods() -> tuple[Callable[[float], Method], ...]:
    from lommel.methods.chordal_gauss import ChordalGauss, ChordalIfCheaper

    return ChordalIfCheaper, NijboerZernike, ChordalGauss


def _cut_methods() -> tuple[Callable[[float], Method], ...]:
    from lommel.methods.chordal_gauss import ChordalIfCheaper
    from lommel.methods.nonuniform_fft import NonuniformFFT

    return ChordalIfCheaper, NonuniformFFT


def _general_methods() -> tuple[Callable[[float], Method], ...]:
    from lommel.methods.nonuniform_fft import NonuniformFFT

    return (NonuniformFFT,)


def _objective_methods() -> tuple[Callable[[float], Method], ...]:
    from lommel.methods.layers.stratified import Stratified

    return (Stratified,)


def _aberrated_methods() -> tuple[Callable[[float], Method], ...]:
    from lommel.methods.layers.chordal_debye import ChordalDebyeIfCheaper
    from lommel.methods.layers.debye_rings import DebyeRings

    return ChordalDebyeIfCheaper, DebyeRings


RULES = (
    Rule(
        "microscope objective with measured aberrations",
        lambda pupil, _: pupil.aberrated,
        _aberrated_methods,
        "two matrix products in small windows; or one per azimuthal order, FFTs on circles, a sparse product",
    ),
    Rule(
        "microscope objective",
        lambda pupil, _: pupil.layered,
        _objective_methods,
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
        _disk_methods,
        "two matrix products; or FFTs on circles, and interpolation for an eighth of the pixels",
    ),
    Rule(
        "annular, behind straight vanes, by whichever is likely to take less time",
        lambda pupil, _: getattr(pupil, "strips", None) is not None,
        _cut_methods,
        "two matrix products, and a filter along the vanes",
    ),
    Rule(
        "any other aperture",
        lambda *_: True,
        _general_methods,
        "non-uniform FFTs along the rows of the aperture and across them",
    ),
)
"""Rules of the choice; the first one that applies is used."""


def table() -> str:
    """Return the rules as a Markdown table for the documentation page on the choice of a method."""
    rows = [("pupil", "method", "cost"), ("---",) * 3]
    for rule in RULES:
        names = dict.fromkeys(type(method(Method.tol).reported).__name__ for method in rule.methods)
        rows.append((rule.pupils, ", ".join(f"`{name}`" for name in names), rule.costs))
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)


def candidates(pupil: BasePupil, grid: Grid, tol: float = Method.tol) -> tuple[Method, ...]:
    """Return the methods of the first of the :data:`RULES` that applies, in the order in which they are tried."""
    imaged(pupil)
    rule = next(rule for rule in RULES if rule.applies(pupil, grid))
    return _construct(rule, tol)


@lru_cache(maxsize=64)
def _construct(rule: Rule, tol: float) -> tuple[Method, ...]:
    return tuple(method(tol) for method in rule.methods)


def of_derivatives(pupil: "ObjectivePupil", methods: tuple[Method, ...]) -> tuple[Method, ...]:
    """Return methods for derivatives of an objective's images; only the last one has derivatives by Zernike terms."""
    from lommel.methods.layers.chordal_debye import ChordalDebye, ChordalDebyeIfCheaper

    tol = methods[0].tol
    # If the light depends on the azimuth, the chordal rule is tried first: the other methods need new tables over
    # circles for each further plane.
    chordal = () if pupil.aberrated or pupil.light.radial else (ChordalDebyeIfCheaper(tol),)
    return (*chordal, *methods, ChordalDebye(tol))


def first_within_tolerance(
    methods: tuple[Method, ...], compute: Callable[[Method], _Result]
) -> tuple[Method, _Result]:
    """Return the first method that computes a result within its tolerance, and the result."""
    # The chordal rule has a limited number of chords, and errors relative to the window: it fails for a dark window,
    # which NijboerZernike can compute. Errors of other types are defects, and are not caught.
    failure: ToleranceError | Declined | None = None
    for method in methods:
        try:
            return method, compute(method)
        except (ToleranceError, Declined) as error:
            # If all methods fail, the error to raise is preferably a ToleranceError, whose message states a possible
            # tolerance, else the reason of a method other than the last one, the chordal rule.
            if (
                failure is None
                or isinstance(error, ToleranceError)
                or (isinstance(failure, Declined) and method != methods[-1])
            ):
                # Drop the traceback, whose frames keep the arrays of the failed method alive.
                failure = error.with_traceback(None)
    assert failure is not None
    raise failure


def instead(pupil: BasePupil, grid: Grid) -> str:
    """Return a hint to use Fraunhofer, which has no error bound, if no other method computes the image, or ""."""
    from lommel.methods.matrix_fourier import samples_needed
    from lommel.methods.paper.fraunhofer import Fraunhofer
    from lommel.optics.pupil import checked

    try:
        lens = checked(pupil)
        if not lens.circular:
            return ""
        sampled = Fraunhofer(samples=max(256, samples_needed(lens, grid)[0]))
        sampled.require_fit(lens, grid)
    except (TypeError, ValueError):  # an objective, an axis for each pupil, or too many samples
        return ""
    return f"; method=lommel.paper.Fraunhofer(samples={sampled.samples}) computes them, without a bound on its error"


def fixed_order(methods: tuple[Method, ...], pupil: BasePupil, grid: Grid) -> tuple[Method, ...]:
    """Return the methods for a stack computed in parts, ordered such that all parts use the same method."""
    if len(methods) == 1:
        return methods
    # Different methods in different parts would cause steps (within the tolerance), visible in image differences.
    if pupil.layered:
        return methods[-1:]
    if not pupil.circular:
        return tuple(method.reported for method in methods)
    from lommel.core.engine import disk_costs
    from lommel.methods.averaging import samples_across
    from lommel.methods.nijboer_zernike import disk_stack, window_of
    from lommel.optics.pupil import checked

    lens, count = checked(pupil), math.prod(pupil.shape)
    indices = np.arange(0, count, -(-count // _COST_PUPILS))
    part = lens[np.unravel_index(indices, pupil.shape)] if pupil.shape else lens
    per_pixel = samples_across(grid.step(pupil)) if grid.integrate else 1
    height, width = (per_pixel * side for side in grid.shape)
    samples = Grid((height, width), grid.side / per_pixel)
    _, series, chords = methods
    try:
        # Estimated times of chords and of the series, from the compiled core.
        costs = disk_costs(disk_stack(part), window_of(part, samples), series.tol)
    except Declined:
        return series, chords
    return (chords, series) if costs[0] <= costs[1] else (series, chords)


def of_profiles(tol: float = Method.tol) -> NijboerZernike:
    """Return the method for radial profiles of radially symmetric pupils, and for integrals over profiles."""
    return NijboerZernike(tol)


def references(pupil: BasePupil) -> tuple[Method, ...]:
    """Return reference methods in the order in which they are tried: quadrature, else tolerances of 1e-9."""
    if pupil.layered:
        from lommel.methods.layers.debye_wolf import DebyeWolf

        return (_aberrated_methods()[-1](1e-9) if pupil.aberrated else DebyeWolf(tol=1e-9),)
    if pupil.radial:
        from lommel.methods.hankel import Hankel  # for reports, which are rare

        return (Hankel(),)
    if pupil.circular:
        from lommel.methods.chordal_gauss import ChordalGauss

        return NijboerZernike(tol=1e-9), ChordalGauss(tol=1e-9)
    from lommel.methods.nonuniform_fft import NonuniformFFT

    return (NonuniformFFT(tol=1e-9),)
