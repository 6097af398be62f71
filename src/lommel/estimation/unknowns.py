"""What is solved for in images of stars: terms of the wavefront, numbers of the pupil, and each image's own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.methods.derivatives import POWERS, SHIFTS, Name, checked, parts
from lommel.methods.slopes import translated
from lommel.optics.pupil import Pupil
from lommel.special import zernike

OF_PUPIL = ("f_number", "wavelength", "obscuration")
OF_IMAGES = tuple(SHIFTS)
_FIRST = 4  # Noll's index of defocus, after piston and tilts


@dataclass(frozen=True)
class Unknowns:
    """What is solved for.

    Attributes
    ----------
    terms : tuple
        Of the wavefront, as they were asked for.
    edge : tuple of (n, m)
        The Zernike terms that these are made of.
    directions : ndarray, shape (terms, edge)
        How much of each, radians at the edge, a unit of a term is.
    pupil : tuple of str
        Of `OF_PUPIL`, the same in all images.
    places : tuple of str
        "row" and "column", of each image its own; so are its flux and its background, always.
    """

    terms: tuple[Name, ...]
    edge: tuple[tuple[int, int], ...]
    directions: Array
    pupil: tuple[str, ...]
    places: tuple[str, ...]

    @classmethod
    def of(cls, terms: Any, also: Any) -> Unknowns:
        """Return what `terms` and `also` of :func:`lommel.retrieve` ask for; TypeError or ValueError if nothing."""
        pupil, places = _also(also)
        names = _names(terms)
        made = [_made_of(name) for name in names]
        edge = tuple(dict.fromkeys(term for shares in made for term in shares))
        directions = np.zeros((len(names), len(edge)))
        for row, shares in zip(directions, made, strict=True):
            row[:] = [shares.get(term, 0.0) for term in edge]
        if names and np.linalg.matrix_rank(directions) < len(names):
            raise ValueError(f"terms must not say one thing twice, got {validation.shown(terms)}")
        for place in places:
            if SHIFTS[place] in edge:
                raise ValueError(
                    f"terms must be without {SHIFTS[place]} where the {place} of each image is solved along (also)"
                )
        return cls(names, edge, directions, pupil, places)

    @property
    def asked(self) -> tuple[Any, ...]:
        """By what derivatives of images are needed."""
        return (*self.edge, *(SHIFTS[place] for place in self.places), *self.pupil)

    @property
    def shared(self) -> tuple[Any, ...]:
        """What all images share, in the order of the parameters."""
        return (*self.terms, *self.pupil)


def _names(terms: Any) -> tuple[Name, ...]:
    if isinstance(terms, int | np.integer) and not isinstance(terms, bool):
        count = validation.integer("terms", terms, least=1, most=500)
        return tuple(zernike.term(_FIRST + k, "noll") for k in range(count))
    names = checked(terms, "terms")
    for name in names:
        if isinstance(name, str) and name not in POWERS and " " not in name:
            raise ValueError(
                f"terms must be those of a wavefront, got {name!r}; `also` is for what else is solved for"
            )
    if len(names) < len(terms):
        raise ValueError(f"terms must not say one thing twice, got {validation.shown(terms)}")
    return names


@lru_cache(maxsize=1024)
def _made_of(name: Name) -> dict[Any, float]:
    """Return the Zernike terms, radians at the edge, of a unit of a term: rms of Zernike terms, else of its power."""
    made = translated(parts(name, Pupil(), 1.0, energy=False).phases, powers=False)
    return made if name in POWERS else {(n, m): zernike.rms_factor(n, m) for n, m in made}  # type: ignore[misc]


def _also(also: Any) -> tuple[tuple[str, ...], tuple[str, ...]]:
    names = (also,) if isinstance(also, str) else also
    if not isinstance(names, Sequence):
        raise TypeError(f"also must be a sequence of names, got {validation.shown(also)}")
    for name in names:
        validation.choice("also", name, ("center", *OF_IMAGES, *OF_PUPIL))
    found = {*names} | ({*OF_IMAGES} if "center" in names else set())
    return tuple(n for n in OF_PUPIL if n in found), tuple(n for n in OF_IMAGES if n in found)
