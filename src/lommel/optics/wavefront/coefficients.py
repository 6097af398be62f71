"""Zernike and Seidel coefficients in every order, unit and normalization, and back."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.special import zernike

UNITS = ("radians", "waves", "metres")
NORMALIZATIONS = ("rms", "edge")
Term = tuple[int, int]
"""n and m of a Zernike polynomial; m > 0 is the cosine of m theta, m < 0 the sine."""
_FRAMEWORKS = {"jax": "JAX", "jaxlib": "JAX", "torch": "PyTorch", "cupy": "CuPy"}


def coefficients(name: str, value: ArrayLike) -> Array:
    """Return coefficients as an array; TypeError for a tensor, which would lose its gradients unnoticed."""
    framework = _FRAMEWORKS.get(type(value).__module__.partition(".")[0])
    if framework is not None:
        raise TypeError(
            f"{name} must be numbers or an array of NumPy, got one of {framework}, whose gradients would end here: "
            "lommel.Plan(...).traced(pupils, xp) makes PSFs of it within that framework; np.asarray(...) leaves it"
        )
    return validation.real_array(name, value)


def radians_per(unit: str, wavelength: float | None) -> float:
    """Return the radians of phase of one `unit`: of phase, of waves, or of metres of optical path."""
    validation.choice("unit", unit, UNITS)
    if wavelength is not None:
        wavelength = validation.wavelength(wavelength)
    if unit != "metres":
        return 1.0 if unit == "radians" else 2.0 * math.pi
    if wavelength is None:
        raise ValueError('unit="metres" needs the wavelength, in metres')
    return 2.0 * math.pi / wavelength


def edge_factor(term: Term, normalization: str) -> float:
    """Return the value at the edge of the pupil of a term with the coefficient 1."""
    return zernike.rms_factor(*term) if normalization == "rms" else 1.0


def from_zernike(
    terms: Mapping[Any, ArrayLike] | Iterable[tuple[Any, ArrayLike]], order: str, scale: float, normalization: str
) -> dict[Term, Array]:
    """Return Zernike coefficients as radians at the edge by (n, m); `scale` is the radians of their unit."""
    validation.choice("normalization", normalization, NORMALIZATIONS)
    try:
        pairs = [(index, value) for index, value in (terms.items() if isinstance(terms, Mapping) else terms)]
    except (TypeError, ValueError):
        raise TypeError(
            f"terms must map indices to coefficients, or be pairs of them, got {validation.shown(terms)}"
        ) from None
    found: dict[Term, Array] = {}
    for index, value in pairs:
        n, m = zernike.term(index, order)
        if (n, m) in found:
            raise ValueError(f"the Zernike term {index!r}, (n, m) = ({n}, {m}), comes twice")
        given = coefficients(f"the Zernike coefficient {index!r}", value)
        with np.errstate(over="ignore"):  # the wavefront refuses what is not finite
            found[n, m] = scale * edge_factor((n, m), normalization) * given
    return found


def from_seidel(
    waves: Mapping[str, ArrayLike], field: tuple[ArrayLike, ArrayLike]
) -> tuple[Array, Array, list[Array], dict[Term, Array]]:
    """Return C_d, C_s, the higher powers of rho and the nonradial Zernike terms of Seidel coefficients in waves."""
    with np.errstate(over="ignore"):  # what overflows in radians becomes infinite, and is refused
        radians = {name: 2 * math.pi * coefficients(name, value) for name, value in waves.items()}
    w = {name: validation.real_array(name, value) for name, value in radians.items()}
    if not isinstance(field, tuple | list) or len(field) != 2:
        raise TypeError(f"field must be a pair (x, y), got {validation.shown(field)}")
    x, y = validation.real_array("field[0]", field[0]), validation.real_array("field[1]", field[1])
    higher = [w["W060"], w["W080"]]
    while higher and not np.any(higher[-1]):
        higher.pop()
    try:
        shape = np.broadcast_shapes(x.shape, y.shape, *(c.shape for c in w.values()))
        square = x * x + y * y
        defocus = w["W020"] + (w["W220"] + 0.5 * w["W222"]) * square
        # rho^3 cos = (R_3^1 cos + 2 rho cos) / 3, and H^2 rho^2 cos^2 = H^2 rho^2 / 2 + H^2 rho^2 cos(2 phi) / 2.
        tilt = 2.0 / 3.0 * w["W131"] + w["W311"] * square
        terms = {
            (1, 1): tilt * x,
            (1, -1): tilt * y,
            (3, 1): w["W131"] / 3.0 * x,
            (3, -1): w["W131"] / 3.0 * y,
            (2, 2): 0.5 * w["W222"] * (x * x - y * y),
            (2, -2): w["W222"] * x * y,
        }
    except ValueError:
        shapes = {name: c.shape for name, c in (w | {"field[0]": x, "field[1]": y}).items() if c.shape}
        raise ValueError(f"the coefficients and field must broadcast, got shapes {shapes}") from None
    others = {term: c for term, c in terms.items() if np.any(c)}
    return np.broadcast_to(0.5 * defocus, shape), w["W040"], higher, others
