r"""Names of derivatives of images, and the derivatives that methods compute of which each is a sum.

An image is ``scale I``, I at ``v = pi x / (lambda N)``. All names come down to derivatives of I by coefficients of
the phase, to how it changes as the image grows around its axis, ``v . grad I``, and to how it changes as the
obscuration grows. A tilt shifts the image, so that ``grad I`` is minus the derivatives by (1, 1) and (1, -1), and a
shift by a pixel is a tilt of its pitch in v.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.pupil import Pupil
from lommel.special import zernike

if TYPE_CHECKING:
    from lommel.optics.base_pupil import Geometry

Term = tuple[int, int]
Name = str | Term  # a text, or n and m of a Zernike term

# k of rho^(2k), by name; twice C_d is the coefficient of the first.
POWERS = {"defocus": 1, "spherical": 2, "rho^6": 3, "rho^8": 4}

# The tilt that moves the axis, by what it moves along; a pixel is its pitch in v.
SHIFTS: dict[str, Term] = {"row": (1, -1), "column": (1, 1)}

LAYERED = ("z", "depth")  # those of the pupils of an Objective: the stage, and the emitter

_INDEXED = re.compile(r"(noll|ansi|fringe) +([0-9]{1,4})")


Factor = float | Array  # one for all pupils of a stack, or one for each


class Parts(NamedTuple):
    """A derivative of images as a sum of parts; each factor is a number, or one for each pupil."""

    # Factors of derivatives by the coefficient of rho^(2k), under k, or of a term, under (n, m).
    phases: Mapping[int | Term, Factor] = MappingProxyType({})
    own: Factor = 0.0  # factor of the image itself
    scaling: Factor = 0.0  # factor of scale v . grad I
    obscuration: float = 0.0  # factor of the derivative of I, times the scale, by the obscuration
    unknown: float = 0.0  # factor of the derivative by the phase that the wavefront's terms leave out, over its bound


def checked(
    names: Sequence[object], argument: str = "derivatives", texts: Sequence[str] | None = None
) -> tuple[Name, ...]:
    """Return the names of derivatives; those without indices among `texts`, by default all."""
    if isinstance(names, str) or not isinstance(names, Sequence):
        raise TypeError(
            f"{argument} must be a sequence of names such as ('defocus', (3, 1)), got {validation.shown(names)}"
        )
    texts = _TEXTS if texts is None else texts
    # Gradients have hundreds of names; of numbers 1 and True are equal, and only one is an index.
    if all(type(name) is str for name in names):
        return _texts_checked(argument, tuple(names), tuple(texts))
    return tuple(_name(argument, name, texts) for name in names)


@lru_cache(maxsize=64)
def _texts_checked(argument: str, names: tuple[object, ...], texts: tuple[str, ...]) -> tuple[Name, ...]:
    return tuple(_name(argument, name, texts) for name in names)


def _name(argument: str, name: object, texts: Sequence[str]) -> Name:
    found: Name
    if isinstance(name, str) and (name in texts or _INDEXED.fullmatch(name)):
        found, term = str(name), term_of(name)
    elif isinstance(name, tuple | list) and len(name) == 2:
        try:
            found = term = _pair(*name) if type(name[0]) is int is type(name[1]) else zernike.term(name, "nm")
        except (TypeError, ValueError) as error:
            raise type(error)(f"{argument}: {error}") from None
    else:
        known = ", ".join(map(repr, texts))
        raise ValueError(
            f"{argument} must be one of {known}, or a Zernike term such as (3, 1), 'noll 8', 'ansi 8' or 'fringe 7', "
            f"got {validation.shown(name)}"
        )
    if term == (0, 0):
        raise ValueError(
            f"{argument} must not hold {validation.shown(name)}: no intensity depends on the constant phase"
        )
    return found


@lru_cache(maxsize=1024)
def _pair(n: int, m: int) -> Term:
    """Return a term, checked once: gradients name hundreds."""
    return zernike.term((n, m), "nm")


def term_of(name: Name) -> Term | None:
    """Return n and m of what names a Zernike term."""
    return name if isinstance(name, tuple) else _indexed(name)


@lru_cache(maxsize=1024)
def _indexed(name: str) -> Term | None:
    """Return the term of a text with an index, once for all calls."""
    found = _INDEXED.fullmatch(name)
    return zernike.term(int(found[2]), found[1]) if found else None


def parts(name: Name, pupil: Pupil, step: float, *, energy: bool) -> Parts:
    """Return what the derivative by a checked `name` is made of."""
    if (term := term_of(name)) is not None:
        return Parts({term: 1.0})
    assert isinstance(name, str)
    if name in POWERS:
        return Parts({POWERS[name]: 2.0 if name == "defocus" else 1.0})
    if name in SHIFTS:
        return Parts({SHIFTS[name]: step})
    if name in LAYERED:
        raise ValueError(f"derivatives by {name!r} are of the pupils of an Objective")
    return _OTHERS[name](pupil, -2.0 if energy else 0.0)


# Of a pupil, and of d ln scale / d ln N, which is `squeeze`.


def _f_number(pupil: Pupil, squeeze: float) -> Parts:
    n = _metric("f_number", pupil)[1]
    return Parts(own=squeeze / n, scaling=-1.0 / n)


def _wavelength(pupil: Pupil, squeeze: float) -> Parts:
    # Path differences stay, so that phases fall as the wavelength grows.
    wave, wavefront = _metric("wavelength", pupil)[0], pupil.wavefront
    edge = wavefront.edge.reshape(-1, len(wavefront.terms))
    phases: dict[int | Term, Factor] = {
        term: edge[:, j] / -wave for j, term in enumerate(wavefront.terms) if edge[:, j].any()
    }
    return Parts(phases, squeeze / wave, -1.0 / wave, unknown=1.0 / wave)


def _obscuration(pupil: Pupil, squeeze: float) -> Parts:
    eps = pupil.obscuration
    edge = float(pupil.illumination.at(np.array(eps * eps)))
    # Of what values are divided by: all light or, where values are relative to it, the peak without aberration.
    lost = 2.0 * eps * edge**2 / pupil.transmission if squeeze else 4.0 * eps * edge / pupil.amplitude
    return Parts(own=lost, obscuration=1.0 if eps else 0.0)


def _object_distance(pupil: Pupil, _: float) -> Parts:
    rate, lens = _lens("object_distance", pupil)
    return Parts({1: -2.0 * rate / np.square(lens.object_distance)})


def _focus_distance(pupil: Pupil, squeeze: float) -> Parts:
    rate, lens = _lens("focus_distance", pupil)
    nearer = -lens.sensor_distance * lens.in_focus**2  # d ln N, as the sensor moves
    return Parts({1: 2.0 * rate * lens.in_focus**2}, squeeze * nearer, -nearer)


_OTHERS: dict[str, Callable[[Pupil, float], Parts]] = {
    "wavelength": _wavelength,
    "f_number": _f_number,
    "obscuration": _obscuration,
    "object_distance": _object_distance,
    "focus_distance": _focus_distance,
}
_TEXTS = (*POWERS, *SHIFTS, *_OTHERS, *LAYERED)


def _metric(name: str, pupil: Pupil) -> tuple[float, float]:
    """Return the wavelength and the f-number of a pupil that has them."""
    if pupil.wavelength is None or pupil.f_number is None:
        raise ValueError(
            f"derivatives by {name!r} need a pupil with a wavelength and an f_number, in metres; "
            "give it both, as in Pupil(wavelength=550e-9, f_number=2.8)"
        )
    return pupil.wavelength, pupil.f_number


def _lens(name: str, pupil: Pupil) -> tuple[float, Geometry]:
    """Return dC_d / d(1/s), radians times metres, and the distances behind a pupil."""
    wave, _ = _metric(name, pupil)
    lens = pupil.geometry
    if lens is None:
        raise ValueError(
            f"derivatives by {name!r} need the distances of a lens behind the pupil; Lens.pupil makes such pupils"
        )
    if lens.model != "paraxial":
        raise ValueError(
            f"derivatives by {name!r} are of paraxial lenses, got model={lens.model!r}, all of whose terms "
            "change with a distance; take differences of the PSFs of Lens.pupil at two distances"
        )
    return math.pi * lens.aperture_radius**2 / (2.0 * wave), lens
