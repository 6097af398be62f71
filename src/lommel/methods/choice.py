"""Automatic choice of a method by pupil and window, and of the methods tried next."""

# Annotations are not postponed: a NamedTuple compiles each that is text, which takes longer than all else here.

import math
from collections.abc import Callable
from contextlib import suppress
from functools import lru_cache
from typing import NamedTuple, TypeVar

from lommel.core.answers import Declined, ToleranceError
from lommel.methods.method import Method
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.optics.base_pupil import BasePupil, imaged
from lommel.optics.grid import Grid

_SMALL, _SMALL_OF_STACK, _STACK = 64, 128, 8  # samples a side, and from how many pupils on
_Answer = TypeVar("_Answer")


class Rule(NamedTuple):
    """The methods for some pupils and windows, in words and in code."""

    pupils: str
    applies: Callable[[BasePupil, Grid], bool]
    imported: Callable[[], tuple[Callable[[float], Method], ...]]
    costs: str

    @property
    def methods(self) -> tuple[Callable[[float], Method], ...]:
        """As they are tried, one by one."""
        return self.imported()


# Imported where they are needed, for radial pupils are most and take none of these.


def _chords_first() -> tuple[Callable[[float], Method], ...]:
    from lommel.methods.chordal_gauss import ChordalGauss

    return ChordalGauss, NijboerZernike


def _nonuniform() -> tuple[Callable[[float], Method], ...]:
    from lommel.methods.nonuniform_fft import NonuniformFFT

    return (NonuniformFFT,)


def _stratified() -> tuple[Callable[[float], Method], ...]:
    from lommel.methods.layers.stratified import Stratified

    return (Stratified,)


def _rings() -> tuple[Callable[[float], Method], ...]:
    from lommel.methods.layers.debye_rings import DebyeRings

    return (DebyeRings,)


def _small(pupil: BasePupil, grid: Grid) -> bool:
    if not pupil.circular:
        return False
    side = max(grid.shape)
    if grid.integrate:  # averages are made of finer samples
        from lommel.methods.pixels.averaging import samples_across

        side *= samples_across(grid.step(pupil))
    return side <= _SMALL or (side <= _SMALL_OF_STACK and math.prod(pupil.shape) >= _STACK)


RULES = (
    Rule(
        "microscope objective with measured aberrations",
        lambda pupil, _: pupil.aberrated,
        _rings,
        "a matrix product per azimuthal order, FFTs on circles, a sparse product",
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
        f"circular or annular, windows up to {_SMALL} samples a side ({_SMALL_OF_STACK} for {_STACK} pupils or more)",
        _small,
        _chords_first,
        "two matrix products; grows with the square of the number of chords",
    ),
    Rule(
        "circular or annular, larger windows",
        lambda pupil, _: pupil.circular,
        lambda: (NijboerZernike,),
        "a sum over azimuthal orders for an eighth of the pixels",
    ),
    Rule(
        "any other aperture",
        lambda *_: True,
        _nonuniform,
        "non-uniform FFTs along the rows of the aperture and across them",
    ),
)
"""The first that applies."""


def table() -> str:
    """Return the rules as a table in Markdown; the page on how to choose a method has it."""
    rows = [("pupil", "method", "cost"), ("---",) * 3]
    rows += [(r.pupils, ", else ".join(f"`{m.__name__}`" for m in r.methods), r.costs) for r in RULES]
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)


def candidates(pupil: BasePupil, grid: Grid, tol: float = Method.tol) -> tuple[Method, ...]:
    """Return the methods for a pupil and a window, in the order in which they are tried, by :data:`RULES`."""
    imaged(pupil)
    rule = next(rule for rule in RULES if rule.applies(pupil, grid))
    return _made(rule, tol)


@lru_cache(maxsize=64)
def _made(rule: Rule, tol: float) -> tuple[Method, ...]:
    return tuple(method(tol) for method in rule.methods)


def first_proven(ways: tuple[Method, ...], ask: Callable[[Method], _Answer]) -> tuple[Method, _Answer]:
    """Return the first of some methods that neither declines nor misses its tolerance, and its answer."""
    # The chordal rule judges errors by the window alone and takes a limited number of chords: a window that the light
    # misses is for the series. Other errors are faults, and are not hidden.
    for way in ways[:-1]:
        with suppress(ToleranceError, Declined):
            return way, ask(way)
    return ways[-1], ask(ways[-1])


def of_profiles(tol: float = Method.tol) -> NijboerZernike:
    """Return the method for profiles of radial pupils, and for integrals of these."""
    return NijboerZernike(tol)


def reference(pupil: BasePupil) -> Method:
    """Return the method that others are compared with: quadrature, or the series where that does not apply."""
    if pupil.layered:
        from lommel.methods.layers.debye_wolf import DebyeWolf

        return _rings()[0](1e-9) if pupil.aberrated else DebyeWolf(tol=1e-9)
    if pupil.radial:
        from lommel.methods.hankel import Hankel  # for reports, which are rare

        return Hankel()
    if pupil.circular:
        return NijboerZernike(tol=1e-9)
    from lommel.methods.nonuniform_fft import NonuniformFFT

    return NonuniformFFT(tol=1e-9)
