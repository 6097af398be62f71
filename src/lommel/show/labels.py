"""Labels of the members of a stack: distance, depth, the one coefficient that varies, or the index."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import TypeVar

import numpy as np

from lommel.base.arrays import Array
from lommel.base.units import format_length
from lommel.optics.base_pupil import BasePupil
from lommel.optics.layers.emitter import Dipole, Emitter, Scalar
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike

_Item = TypeVar("_Item")


def of_pupils(pupil: BasePupil) -> list[str]:
    """Return a word for each of the flattened stack: the distance of the object, of an objective depth and stage."""
    if isinstance(pupil, ObjectivePupil):
        places = {"depth": pupil.depth, "z": pupil.z}
        told = [_lengths(f"{name} ", at.ravel()) for name, at in places.items() if np.ptp(at)]
        if told:
            return [", ".join(parts) for parts in zip(*told, strict=True)]
    if isinstance(pupil, Pupil):
        distances = () if pupil.geometry is None else pupil.geometry.object_distance
        if len(set(distances)) > 1:
            return _lengths("object at ", np.array(distances))
        return of_wavefronts(pupil.wavefront)
    return _indices(pupil.shape)


def of_wavefronts(wavefront: Wavefront) -> list[str]:
    """Return a word for each of the flattened stack: the coefficient where one alone differs."""
    flat = wavefront.flattened()
    powers = flat.coefficients
    others = flat.edge[:, flat.symmetric :]
    radial, sideways = (np.flatnonzero(np.ptp(each, axis=0)) for each in (powers, others))
    if radial.size == 1 and not sideways.size and radial[0] < 2:
        name, values = (("defocus", flat.defocus), ("spherical", flat.spherical))[radial[0]]
    elif sideways.size == 1 and not radial.size:
        return _terms(flat, flat.symmetric + int(sideways[0]))
    else:
        varied = np.flatnonzero(np.ptp(flat.edge, axis=0))
        if varied.size != 1:
            return _indices(wavefront.shape)
        return _terms(flat, int(varied[0]))
    return [f"{name} {true_minus(f'{value + 0.0:.3g}')} rad" for value in values]


def _terms(flat: Wavefront, which: int) -> list[str]:
    n, m = flat.terms[which]
    waves = flat.edge[:, which] / (2.0 * math.pi * zernike.rms_factor(n, m)) + 0.0
    return [f"{zernike.name(n, m)} {true_minus(f'{each:.3g}')} waves rms" for each in waves]


def _lengths(what: str, at: Array) -> list[str]:
    finite = np.abs(at[np.isfinite(at)])
    like = float(finite.max()) if finite.size else None
    return [f"{what}{length_in_words(each + 0.0, like=like)}" for each in at.tolist()]


def length_in_words(metres: float, like: float | None = None) -> str:
    """Return a length as pictures have it, with the unit that suits it or another."""
    return true_minus(format_length(metres, like=like).replace(" um", " µm").replace("infinity", "∞"))


def of_emitter(emitter: Emitter) -> str:
    """Return a description of an emitter or of an excitation beam."""
    if isinstance(emitter, Dipole):
        if emitter.wobble == 1.0:
            return "freely rotating dipole"
        polar, azimuth = math.degrees(emitter.polar), math.degrees(emitter.azimuth)
        wobble = f", wobble {emitter.wobble:.4g}" if emitter.wobble else ""
        return f"dipole, {polar:.4g} deg from the axis, azimuth {azimuth:.4g} deg{wobble}"
    if isinstance(emitter, Scalar):
        return "scalar (Gibson-Lanni)"
    return f"beam focused into the sample, {emitter.polarization} polarization"


def true_minus(text: str) -> str:
    """Return a text of numbers with minus signs, as axes have them, in place of hyphens."""
    return text.replace("-", "−")


def name_in_words(name: str) -> str:
    """Return the name of a lens as pictures have it: with µm in place of the um of its file."""
    return re.sub(r"(?<=\d )um\b", "µm", name)


def _indices(shape: tuple[int, ...]) -> list[str]:
    return [", ".join(map(str, index)) for index in np.ndindex(shape)]


def few(items: Sequence[_Item], most: int) -> list[_Item]:
    """Return at most so many of some items, evenly spread, the first and the last among them."""
    if len(items) <= most:
        return list(items)
    return [items[round(k * (len(items) - 1) / (most - 1))] for k in range(most)]


def few_of(shape: tuple[int, ...], most: int) -> dict[int, tuple[int, ...]]:
    """Return a :func:`few` of a stack, at most so many: their places in it flattened, and their indices."""
    chosen = few(range(math.prod(shape)), most)
    return {place: tuple(int(i) for i in np.unravel_index(place, shape)) for place in chosen}
