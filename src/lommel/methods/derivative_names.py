r"""Names of derivatives of images, and each named derivative as a sum of derivatives that the methods compute.

An image is ``scale * I(v)``, with ``v = pi x / (lambda N)``. Every named derivative is a weighted sum of the image,
of derivatives of I by coefficients of the phase, of ``v . grad I`` (the derivative by a factor of v) and of the
derivative of I by the obscuration. A tilt shifts the image, so that ``grad I`` is minus the derivatives by the terms
(1, 1) and (1, -1). A tilt whose coefficient is the pixel pitch in v shifts the image by one pixel.
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
Name = str | Term  # a text such as "defocus", or n and m of a Zernike term

# Exponent k of rho^(2k), by name. For "defocus" the coefficient of rho^2 is 2 C_d.
POWERS = {"defocus": 1, "spherical": 2, "rho^6": 3, "rho^8": 4}

# Tilt terms that shift the image by rows or columns; the coefficient for one pixel is the pixel pitch in v.
SHIFTS: dict[str, Term] = {"row": (1, -1), "column": (1, 1)}

LAYERED = ("z", "depth")  # only for the pupils of an Objective: stage position, and depth of the emitter

_INDEXED = re.compile(r"(noll|ansi|fringe) +([0-9]{1,4})")  # name of a Zernike term with a single index


Factor = float | Array  # one number for a stack, or one number for each pupil


class Parts(NamedTuple):
    """A derivative of images as a sum of parts, each with a factor."""

    # Factors of derivatives by coefficients: of rho^(2k) under the key k, of a Zernike term under the key (n, m).
    phases: Mapping[int | Term, Factor] = MappingProxyType({})
    image: Factor = 0.0  # factor of the image itself
    scaling: Factor = 0.0  # factor of scale * (v . grad I)
    obscuration: float = 0.0  # factor of scale * (derivative of I by the obscuration)
    unknown: float = 0.0  # factor of the derivative by the phase outside of the terms, divided by a bound on it


def checked(
    names: Sequence[object], argument: str = "derivatives", texts: Sequence[str] | None = None
) -> tuple[Name, ...]:
    """Return checked names of derivatives; text names must be Zernike terms or among `texts`, by default all."""
    if isinstance(names, str) or not isinstance(names, Sequence):
        raise TypeError(
            f"{argument} must be a sequence of names such as ('defocus', (3, 1)), got {validation.shown(names)}"
        )
    texts = _TEXTS if texts is None else texts
    return tuple(_check_name(argument, name, texts) for name in names)


def _check_name(argument: str, name: object, texts: Sequence[str]) -> Name:
    checked_name: Name
    if isinstance(name, str) and (name in texts or _INDEXED.fullmatch(name)):
        checked_name, term = str(name), term_of(name)
    elif isinstance(name, tuple | list) and len(name) == 2:
        try:
            checked_name = term = _term(*name) if type(name[0]) is int is type(name[1]) else zernike.term(name, "nm")
        except (TypeError, ValueError) as error:
            raise type(error)(f"{argument}: {error}") from None
    else:
        choices = ", ".join(map(repr, texts))
        raise ValueError(
            f"{argument} must be one of {choices}, or a Zernike term such as (3, 1), 'noll 8', 'ansi 8', 'fringe 7', "
            f"got {validation.shown(name)}"
        )
    if term == (0, 0):
        raise ValueError(
            f"{argument} must not hold {validation.shown(name)}: no intensity depends on the constant phase"
        )
    return checked_name


@lru_cache(maxsize=1024)
def _term(n: int, m: int) -> Term:
    """Return a checked term; cached, since gradients have hundreds of terms."""
    return zernike.term((n, m), "nm")


def term_of(name: Name) -> Term | None:
    """Return n and m of the Zernike term with this name, or None for the names of other parameters."""
    return name if isinstance(name, tuple) else _parse_index(name)


@lru_cache(maxsize=1024)
def _parse_index(name: str) -> Term | None:
    """Return the term of a name with an index, such as "noll 8"; cached."""
    match = _INDEXED.fullmatch(name)
    return zernike.term(int(match[2]), match[1]) if match else None


def parts(name: Name, pupil: Pupil, step: float, *, energy: bool) -> Parts:
    """Return the derivative by a checked `name` as a sum of parts; `energy`: values are fractions of all light."""
    if (term := term_of(name)) is not None:
        return Parts({term: 1.0})
    assert isinstance(name, str)
    if name in POWERS:
        # The name "defocus" means C_d, and the coefficient of rho^2 is 2 C_d.
        return Parts({POWERS[name]: 2.0 if name == "defocus" else 1.0})
    if name in SHIFTS:
        return Parts({SHIFTS[name]: step})
    if name in LAYERED:
        raise ValueError(f"derivatives by {name!r} need the pupil of an Objective; use Objective.pupil")
    return _BY_NAME[name](pupil, -2.0 if energy else 0.0)


# Arguments of the following functions: a pupil, and `scale_rate`, the derivative d ln scale / d ln N.


def _f_number(pupil: Pupil, scale_rate: float) -> Parts:
    # v = pi x / (lambda N) falls as 1 / N: the image grows, -v . grad I / N.
    n = _metric("f_number", pupil)[1]
    return Parts(image=scale_rate / n, scaling=-1.0 / n)


def _wavelength(pupil: Pupil, scale_rate: float) -> Parts:
    # Path differences are constant, so that phases are proportional to 1 / wavelength.
    wave, wavefront = _metric("wavelength", pupil)[0], pupil.wavefront
    edge = wavefront.edge.reshape(-1, len(wavefront.terms))
    phases: dict[int | Term, Factor] = {
        term: edge[:, j] / -wave for j, term in enumerate(wavefront.terms) if edge[:, j].any()
    }
    return Parts(phases, scale_rate / wave, -1.0 / wave, unknown=1.0 / wave)


def _obscuration(pupil: Pupil, scale_rate: float) -> Parts:
    eps = pupil.obscuration
    edge = float(pupil.illumination.at(np.array(eps * eps)))
    # Relative decrease of the normalisation: of the transmission ("energy") or of the squared amplitude.
    decrease = 2.0 * eps * edge**2 / pupil.transmission if scale_rate else 4.0 * eps * edge / pupil.amplitude
    return Parts(image=decrease, obscuration=1.0 if eps else 0.0)


def _object_distance(pupil: Pupil, _: float) -> Parts:
    # dC_d / ds = -(dC_d / d(1/s)) / s^2, and the coefficient of rho^2 is 2 C_d.
    rate, lens = _lens("object_distance", pupil)
    return Parts({1: -2.0 * rate / np.square(lens.object_distance)})


def _focus_distance(pupil: Pupil, scale_rate: float) -> Parts:
    rate, lens = _lens("focus_distance", pupil)
    log_n_rate = -lens.sensor_distance * lens.in_focus**2  # d ln N / d focus_distance: the sensor moves inwards
    return Parts({1: 2.0 * rate * lens.in_focus**2}, scale_rate * log_n_rate, -log_n_rate)


_BY_NAME: dict[str, Callable[[Pupil, float], Parts]] = {
    "wavelength": _wavelength,
    "f_number": _f_number,
    "obscuration": _obscuration,
    "object_distance": _object_distance,
    "focus_distance": _focus_distance,
}
_TEXTS = (*POWERS, *SHIFTS, *_BY_NAME, *LAYERED)


def _metric(name: str, pupil: Pupil) -> tuple[float, float]:
    """Return wavelength and f-number of a pupil; ValueError if the pupil has none."""
    if pupil.wavelength is None or pupil.f_number is None:
        raise ValueError(
            f"derivatives by {name!r} need a pupil with a wavelength (metres) and an f_number; give it both, as in "
            "Pupil(wavelength=550e-9, f_number=2.8)"
        )
    return pupil.wavelength, pupil.f_number


def _lens(name: str, pupil: Pupil) -> tuple[float, Geometry]:
    """Return dC_d / d(1/s) (radians times metres) and the distances of the lens of a pupil."""
    wave, _ = _metric(name, pupil)
    lens = pupil.geometry
    if lens is None:
        raise ValueError(f"derivatives by {name!r} need a pupil with the distances of a lens; make it by Lens.pupil")
    if lens.model != "paraxial":
        raise ValueError(
            f"derivatives by {name!r} need a paraxial lens, got model={lens.model!r}, where the distance "
            "changes all terms; take differences of the PSFs of Lens.pupil at two distances"
        )
    return math.pi * lens.aperture_radius**2 / (2.0 * wave), lens
