"""Gradients of weighted sums over the pixels of microscope stacks, in reverse mode by the transpose of chords."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from types import MappingProxyType

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Declined, Wanted
from lommel.methods.derivative_names import SHIFTS, Name, Term, term_of
from lommel.methods.layers import chordal_debye, slopes
from lommel.methods.layers.chordal_debye import ChordalDebye
from lommel.methods.layers.stratified import By, Stratified
from lommel.methods.method import Method
from lommel.optics.grid import Grid
from lommel.optics.layers import projection
from lommel.optics.layers.objective_pupil import ObjectivePupil

_BY_SERIES = ("z", "depth")


def layered_gradient(
    method: Method,
    pupil: ObjectivePupil,
    grid: Grid,
    names: Sequence[Name],
    weights: Array,
    scale: Array,
    *,
    energy: bool,
    far: bool,
) -> dict[Name, Array]:
    """Return the derivatives of sums of `weights`, (n, height, width), times values, by checked names, each (n,).

    Values are `scale`, (n,), times the intensity, of all light (`energy`) or of that `far` from the glass. ValueError
    where there are no such derivatives.
    """
    found: dict[Name, Array] = {}
    by_term = any(name not in SHIFTS for name in _terms(tuple(names)))
    if isinstance(method, slopes.LAYERED) and (by_term or not isinstance(method, Stratified)):
        found = _by_chords(method, pupil, grid, names, weights, scale, energy=energy, far=far)
    if others := [name for name in names if name not in found]:
        wanted = Wanted(scale if far else float(scale[0]))
        each = slopes.layered_slopes(method, pupil, grid, others, wanted, energy=energy)[2]
        found |= {
            name: np.einsum("nij,nij->n", weights, slope.values) for name, slope in zip(others, each, strict=True)
        }
    return found


def _by_chords(
    method: Method,
    pupil: ObjectivePupil,
    grid: Grid,
    names: Sequence[Name],
    weights: Array,
    scale: Array,
    *,
    energy: bool,
    far: bool,
) -> dict[Name, Array]:
    """Return those that the transpose of ChordalDebye has; none where it declines and circles have them all."""
    terms = _terms(tuple(names))
    kinds: dict[Name, By] = {
        name: slopes.by_name(str(name), pupil, far=far, energy=energy) for name in names if name in _BY_SERIES
    }
    places = {term: k for k, term in enumerate(dict.fromkeys(terms.values()))}
    by = chordal_debye.By(tuple(one.which for one in kinds.values()), tuple(places))
    if not (terms or kinds):
        return {}
    try:
        sums = ChordalDebye(method.tol).gradient(pupil, grid, weights, by).T
    except Declined:
        if isinstance(method, ChordalDebye) or any(name not in SHIFTS for name in terms):
            raise ValueError(slopes.TERMS_BY_CHORDS) from None
        return {}
    steep = projection.steepest(pupil.layers, pupil.light.model)
    found: dict[Name, Array] = {}
    for (name, one), raw in zip(kinds.items(), sums[1:], strict=False):
        found[name] = scale * (one.factor * steep[one.which] * raw + one.own * sums[0])
    by_term = scale * sums[1 + len(kinds) :]
    found |= {name: by_term[places[term]] for name, term in terms.items()}
    for name in SHIFTS.keys() & terms.keys():
        found[name] = grid.step(pupil) * found[name]
    return found


@lru_cache(maxsize=64)
def _terms(names: tuple[Name, ...]) -> Mapping[Name, Term]:
    """Return the terms that some names are of, tilts for shifts."""
    each = {name: name if isinstance(name, tuple) else SHIFTS.get(name) or term_of(name) for name in names}
    return MappingProxyType({name: term for name, term in each.items() if term})
