r"""Names of derivatives of images, and each of them as a sum of derivatives that the methods compute.

An image is ``scale I``, I at ``v = pi x / (lambda N)``. Every derivative is a sum of derivatives of I by coefficients
of the phase, of ``v . grad I`` (growth of the image around its axis) and of the derivative by the obscuration. A tilt
shifts the image, so that ``grad I`` is minus the derivatives by (1, 1) and (1, -1); a shift by a pixel is a tilt of
its pitch in v.
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
Name = str | Term  # a name, or n and m of a Zernike term

# k of rho^(2k), by name; the coefficient of the first is 2 C_d.
POWERS = {"defocus": 1, "spherical": 2, "rho^6": 3, "rho^8": 4}

# Tilt that shifts the axis along a direction; by one pixel, it is the pitch in v.
SHIFTS: dict[str, Term] = {"row": (1, -1), "column": (1, 1)}

LAYERED = ("z", "depth")  # for the pupils of an Objective: stage position and depth of the emitter

_INDEXED = re.compile(r"(noll|ansi|fringe) +([0-9]{1,4})")


Factor = float | Array  # one number for a stack, or one for each of its pupils


class Parts(NamedTuple):
    """A derivative of images as a sum of parts; each factor is a number, or one for each pupil."""

    # Factors of derivatives by the coefficient of rho^(2k), under k, or of a term, under (n, m).
    phases: Mapping[int | Term, Factor] = MappingProxyType({})
    own: Factor = 0.0  # factor of the image itself
    scaling: Factor = 0.0  # factor of scale v . grad I
    obscuration: float = 0.0  # factor of the derivative of I, times the scale, by the obscuration
    unknown: float = 0.0  # factor of the derivative by the part of the phase that the terms leave out, over its bound


def checked(
    names: Sequence[object], argument: str = "derivatives", texts: Sequence[str] | None = None
) -> tuple[Name, ...]:
    """Return checked names of derivatives; names without an index must be among `texts`, by default all."""
    if isinstance(names, str) or not isinstance(names, Sequence):
        raise TypeError(
            f"{argument} must be a sequence of names such as ('defocus', (3, 1)), got {validation.shown(names)}"
        )
    texts = _TEXTS if texts is None else texts
    # Gradients have hundreds of names: texts are checked once. Not numbers, since 1 == True, and only one is an
    # index.
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
    """Return a checked term; cached, since gradients have hundreds."""
    return zernike.term((n, m), "nm")


def term_of(name: Name) -> Term | None:
    """Return n and m of the Zernike term that a name stands for, None for other names."""
    return name if isinstance(name, tuple) else _indexed(name)


@lru_cache(maxsize=1024)
def _indexed(name: str) -> Term | None:
    """Return the term of a name with an index, such as "noll 8"; cached."""
    found = _INDEXED.fullmatch(name)
    return zernike.term(int(found[2]), found[1]) if found else None


def parts(name: Name, pupil: Pupil, step: float, *, energy: bool) -> Parts:
    """Return the derivative by a checked `name` as a sum of parts."""
    if (term := term_of(name)) is not None:
        return Parts({term: 1.0})
    assert isinstance(name, str)
    if name in POWERS:
        # The coefficient of rho^2 is 2 C_d, and the name "defocus" is C_d.
        return Parts({POWERS[name]: 2.0 if name == "defocus" else 1.0})
    if name in SHIFTS:
        return Parts({SHIFTS[name]: step})
    if name in LAYERED:
        raise ValueError(f"derivatives by {name!r} are of the pupils of an Objective")
    return _OTHERS[name](pupil, -2.0 if energy else 0.0)


# Arguments: pupil, and `squeeze`, d ln scale / d ln N.


def _f_number(pupil: Pupil, squeeze: float) -> Parts:
    # v = pi x / (lambda N) falls as 1 / N: the image grows, -v . grad I / N.
    n = _metric("f_number", pupil)[1]
    return Parts(own=squeeze / n, scaling=-1.0 / n)


def _wavelength(pupil: Pupil, squeeze: float) -> Parts:
    # Path differences are constant: phases fall in proportion to 1 / wavelength.
    wave, wavefront = _metric("wavelength", pupil)[0], pupil.wavefront
    edge = wavefront.edge.reshape(-1, len(wavefront.terms))
    phases: dict[int | Term, Factor] = {
        term: edge[:, j] / -wave for j, term in enumerate(wavefront.terms) if edge[:, j].any()
    }
    return Parts(phases, squeeze / wave, -1.0 / wave, unknown=1.0 / wave)


def _obscuration(pupil: Pupil, squeeze: float) -> Parts:
    eps = pupil.obscuration
    edge = float(pupil.illumination.at(np.array(eps * eps)))
    # Derivative of the normalisation: of all light or, relative to the unaberrated peak, of the squared amplitude.
    lost = 2.0 * eps * edge**2 / pupil.transmission if squeeze else 4.0 * eps * edge / pupil.amplitude
    return Parts(own=lost, obscuration=1.0 if eps else 0.0)


def _object_distance(pupil: Pupil, _: float) -> Parts:
    # dC_d / ds = -(dC_d / d(1/s)) / s^2, and the coefficient of rho^2 is 2 C_d.
    rate, lens = _lens("object_distance", pupil)
    return Parts({1: -2.0 * rate / np.square(lens.object_distance)})


def _focus_distance(pupil: Pupil, squeeze: float) -> Parts:
    rate, lens = _lens("focus_distance", pupil)
    nearer = -lens.sensor_distance * lens.in_focus**2  # d ln N / d focus_distance: the sensor moves towards the lens
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
    """Return wavelength and f-number of a pupil; ValueError if it has none."""
    if pupil.wavelength is None or pupil.f_number is None:
        raise ValueError(
            f"derivatives by {name!r} need a pupil with a wavelength and an f_number, in metres; "
            "give it both, as in Pupil(wavelength=550e-9, f_number=2.8)"
        )
    return pupil.wavelength, pupil.f_number


def _lens(name: str, pupil: Pupil) -> tuple[float, Geometry]:
    """Return dC_d / d(1/s) (radians times metres) and the distances of the lens of a pupil."""
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
