"""What is solved for in images of stars: terms of the wavefront, numbers of the pupil, and each image's own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.special import zernike

POWERS = {"defocus": 1, "spherical": 2, "rho^6": 3, "rho^8": 4}
"""The terms that are named by a power of rho, and that of rho^2; "defocus" is C_d, half the coefficient of rho^2."""

OF_PUPIL = ("f_number", "wavelength", "obscuration")
OF_IMAGES = ("row", "column")
TILTS = {"row": (1, -1), "column": (1, 1)}
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

    terms: tuple[Any, ...]
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
        edge = tuple(dict.fromkeys(term for parts in made for term in parts))
        directions = np.zeros((len(names), len(edge)))
        for row, parts in zip(directions, made, strict=True):
            row[:] = [parts.get(term, 0.0) for term in edge]
        if names and np.linalg.matrix_rank(directions) < len(names):
            raise ValueError(f"terms must not say one thing twice, got {validation.shown(terms)}")
        for place in places:
            if TILTS[place] in edge:
                raise ValueError(
                    f"terms must be without {TILTS[place]} where the {place} of each image is solved along (also)"
                )
        return cls(names, edge, directions, pupil, places)

    @property
    def asked(self) -> tuple[Any, ...]:
        """By what derivatives of images are needed."""
        return (*self.edge, *(TILTS[place] for place in self.places), *self.pupil)

    @property
    def shared(self) -> tuple[Any, ...]:
        """What all images share, in the order of the parameters."""
        return (*self.terms, *self.pupil)


def _names(terms: Any) -> tuple[Any, ...]:
    if isinstance(terms, int | np.integer) and not isinstance(terms, bool):
        count = validation.integer("terms", terms, least=1, most=500)
        return tuple(zernike.term(_FIRST + k, "noll") for k in range(count))
    if isinstance(terms, str) or not isinstance(terms, Sequence):
        raise TypeError(f"terms must be a number of terms, or a sequence of them, got {validation.shown(terms)}")
    return tuple(tuple(name) if isinstance(name, list) else name for name in terms)


def _made_of(name: Any) -> dict[tuple[int, int], float]:
    """Return the Zernike terms, radians at the edge, of a unit of a term: rms of Zernike terms, else of its power."""
    if isinstance(name, str) and name in POWERS:
        k = POWERS[name]
        matrix = np.asarray(zernike.powers_to_legendre(k)[1:, k - 1], dtype=np.float64)
        return {(2 * j, 0): float(c) * (2.0 if name == "defocus" else 1.0) for j, c in enumerate(matrix, 1)}
    if isinstance(name, tuple):
        n, m = zernike.term(name, "nm")
    elif isinstance(name, str) and len(parts := name.split()) == 2 and parts[1].isdecimal():
        n, m = zernike.term(int(parts[1]), parts[0])
    else:
        listed = ", ".join(f'"{power}"' for power in POWERS)
        raise ValueError(
            f'terms must be (n, m), "noll 7", "ansi 7", "fringe 7", {listed}, got {validation.shown(name)}'
        )
    if n == 0:
        raise ValueError("terms must be without the constant, which no image depends on")
    return {(n, m): zernike.rms_factor(n, m)}


def _also(also: Any) -> tuple[tuple[str, ...], tuple[str, ...]]:
    names = (also,) if isinstance(also, str) else also
    if not isinstance(names, Sequence):
        raise TypeError(f"also must be a sequence of names, got {validation.shown(also)}")
    for name in names:
        validation.choice("also", name, ("center", *OF_IMAGES, *OF_PUPIL))
    found = {*names} | ({*OF_IMAGES} if "center" in names else set())
    return tuple(n for n in OF_PUPIL if n in found), tuple(n for n in OF_IMAGES if n in found)
