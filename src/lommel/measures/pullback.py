"""Gradients of a function of an image with respect to the parameters of the pupil, by the adjoint (pullback)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import Declined, Wanted
from lommel.measures.psf_like import PSFLike
from lommel.methods.chordal_gauss import ChordalGauss
from lommel.methods.derivative_names import SHIFTS, Name, Parts, Term, checked, parts, term_of
from lommel.methods.derivatives import differentiated, engines, single_light, translated
from lommel.methods.layers import chordal_debye, slopes
from lommel.methods.layers.chordal_debye import ChordalDebye
from lommel.methods.layers.stratified import By, Stratified
from lommel.methods.method import Method
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.methods.polychromatic import Polychromatic
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid
from lommel.optics.layers import projection
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.pupil import checked as lens_pupil

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
    by_term = any(name not in SHIFTS for name in _terms_of(tuple(names)))
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
    terms = _terms_of(tuple(names))
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
def _terms_of(names: tuple[Name, ...]) -> Mapping[Name, Term]:
    """Return the terms that some names are of, tilts for shifts."""
    each = {name: name if isinstance(name, tuple) else SHIFTS.get(name) or term_of(name) for name in names}
    return MappingProxyType({name: term for name, term in each.items() if term})


def pullback(psf: PSFLike, g: ArrayLike, of: Sequence[Name] | None = None) -> dict[Name, Array]:
    """Return the gradient ``sum g * derivative`` over pixels (reverse mode); see :meth:`lommel.PSF.pullback`.

    Derivatives by phase coefficients and shifts are computed in reverse mode, by a transform to the pupil, and so are
    those of an Objective with aberrations by the stage and the depth, in windows that :class:`lommel.ChordalDebye`
    takes; all others, and those of radially symmetric pupils, in forward mode.

    Parameters
    ----------
    psf : PSF
    g : array_like
        Of the shape of the values.
    of : sequence, optional
        By default the names of `psf.derivatives`, or the terms of the wavefront.

    Returns
    -------
    dict of name to ndarray
        Of the shape of the pupil.

    Raises
    ------
    TypeError, ValueError
        If `g` is not real and finite or of another shape, or where there are no such derivatives.
    ToleranceError
        If the tolerance of the method cannot be met.
    """
    if psf.blur or not psf.grid.square:
        raise ValueError("psf must have square pixels without fill and blur for its derivatives, got others")
    names = tuple(psf.derivatives) or _default_names(psf.pupil) if of is None else checked(of, "of")
    weights = validation.real_array("g", g)
    if weights.shape != psf.shape:
        raise ValueError(f"g must have the shape of the values, {psf.shape}, got {weights.shape}")
    energy, tol, scale = psf.normalize == "energy", psf.method.tol, float(psf.scale.flat[0])
    if psf.normalize == "peak":
        raise ValueError('of a PSF with normalize="peak" there are no derivatives, since it has kinks; use "energy"')
    weights = weights.reshape(-1, *psf.grid.shape)
    if isinstance(psf.pupil, ObjectivePupil):
        layers, scales, far = psf.pupil, np.asarray(psf.scale).ravel(), psf.normalize == "emitted"
        made = layered_gradient(psf.method, layers, psf.grid, names, weights, scales, energy=energy, far=far)
        shape = layers.shape
        return {name: made[name].reshape(shape) for name in names}
    pupil, grid = lens_pupil(psf.pupil), psf.grid
    sums = {name: parts(name, pupil, grid.step(pupil), energy=energy) for name in names}
    free = _unnamed(psf.method)
    way, engine = engines(free, pupil, names, list(sums.values()), tol)
    found: dict[Name, Array] = {}
    if isinstance(engine, ChordalGauss):
        factors = {name: translated(sums[name].phases, powers=False) for name in names if _by_phase(sums[name])}
        terms = tuple(dict.fromkeys(t for phases in factors.values() for t in phases if isinstance(t, tuple)))
        each = np.zeros((len(weights), len(terms)))
        for part in way.components(pupil) if terms else ():
            rate = scale * part.weight * part.stretch  # phases grow as the wavelength falls
            each += rate * engine.gradient(part.pupil, grid, weights, terms)
        for name, phases in factors.items():
            found[name] = np.sum([by * each[:, terms.index(term)] for term, by in phases.items()], axis=0)
    if others := [name for name in names if name not in found]:
        _, _, slopes = differentiated(free, pupil, grid, others, Wanted(scale), tol, energy=energy)
        for name, slope in zip(others, slopes, strict=True):
            found[name] = np.einsum("nij,nij->n", weights, slope.values)
    return {name: found[name].reshape(pupil.shape) for name in names}


def _default_names(pupil: BasePupil) -> tuple[Name, ...]:
    """Return the terms of the wavefront, which an objective has where it has aberrations."""
    measured = pupil.aberrations if isinstance(pupil, ObjectivePupil) else lens_pupil(pupil).wavefront
    return tuple(term for term in measured.terms if term != (0, 0)) if measured else ()


def _by_phase(each: Parts) -> bool:
    """Return whether a derivative is by coefficients of the phase alone."""
    return not (np.any(each.own) or np.any(each.scaling) or each.obscuration)


def _unnamed(method: Method) -> Method | None:
    """Return the method with its default choice for one wavelength, where others have more derivatives."""
    # The images are equal within the tolerance.
    if not isinstance(single_light(method), NijboerZernike | ChordalGauss):
        return method
    if isinstance(method, Polychromatic):
        return Polychromatic(method.wavelengths, method.weights, tol=method.tol)
    return None
