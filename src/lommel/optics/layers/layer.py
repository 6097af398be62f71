"""Plane layers as a user states them: a refractive index and a thickness."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from lommel.base import validation
from lommel.base.arrays import Array

INDEX_MOST = 4.0
DEPTH_MOST = 1e-2
_GLASS_MOST = 1e-2
_FILM_MOST = 2e-6


@dataclass(frozen=True)
class Layer:
    """A plane layer of one refractive index: a cover glass, or a film.

    Parameters
    ----------
    index : float
        Refractive index, 1 to 4, without absorption.
    thickness : float
        Metres, up to 0.01.

    Raises
    ------
    TypeError, ValueError
        On anything that is no number, not finite, or out of range.

    Examples
    --------
    >>> Layer(1.5255, 170e-6)
    Layer(index=1.5255, thickness=0.00017)
    """

    index: float
    thickness: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "index", refractive_index("index", self.index))
        object.__setattr__(self, "thickness", length("thickness", self.thickness, _GLASS_MOST))


@dataclass(frozen=True)
class Design:
    """What an objective was corrected for, where that is not what it is used with.

    Parameters
    ----------
    immersion : float
        Refractive index of the immersion medium.
    coverslip : Layer or None
        The cover glass; None for an objective that dips into the sample.

    Raises
    ------
    TypeError, ValueError
        On anything out of range.
    """

    immersion: float
    coverslip: Layer | None

    def __post_init__(self) -> None:
        object.__setattr__(self, "immersion", refractive_index("immersion", self.immersion))
        validation.optional("coverslip", self.coverslip, Layer)


def refractive_index(name: str, value: Any) -> float:
    """Return a refractive index; TypeError or ValueError if it is no number from 1 to 4."""
    index = validation.real(name, value)
    if not 1.0 <= index <= INDEX_MOST:
        raise ValueError(f"{name} must be a refractive index from 1 to {INDEX_MOST:g}, got {index:g}")
    return index


def length(name: str, value: Any, most: float, *, positive: bool = False) -> float:
    """Return metres from 0 to `most`; a number that was meant in um or mm is refused with a hint."""
    metres = validation.real(name, value)
    if not (0.0 <= metres <= most) or (positive and metres == 0.0):
        meant = metres > max(most, 1e-3)  # in another unit, as nothing of less is
        hint = f"; for {metres:g} um give {metres:g}e-6, for {metres:g} mm {metres:g}e-3" if meant else ""
        least = "above 0" if positive else "at least 0"
        raise ValueError(f"{name} is in metres and must be {least} and at most {most:g}, got {metres:g}{hint}")
    return metres


def film_stack(value: Any) -> tuple[Layer, ...]:
    """Return films as a tuple; TypeError or ValueError if they are no layers, or too thick."""
    if isinstance(value, Layer) or not isinstance(value, Iterable):
        raise TypeError(f"films must be a sequence of Layer, got {validation.shown(value)}")
    films = tuple(value)
    for k, film in enumerate(films):
        validation.instance(f"films[{k}]", film, Layer)
        length(f"films[{k}].thickness", film.thickness, _FILM_MOST)
    return films


def depths(value: Any) -> Array:
    """Return distances from the glass, metres; TypeError or ValueError where one is none from 0 to 0.01."""
    found = validation.real_array("depth", value)
    if not found.size:
        raise ValueError(f"depth must not be empty, got shape {found.shape}")
    for extreme in (found.min(), found.max()):
        length("depth", float(extreme), DEPTH_MOST)
    return found


def heights(value: Any) -> Array:
    """Return radii in the pupil; TypeError or ValueError where one is none from 0 to 1."""
    found = validation.real_array("rho", value, least=0.0)
    if found.size and found.max() > 1.0:
        raise ValueError(f"rho must be from 0 to 1, got {found.max():g}")
    return found
