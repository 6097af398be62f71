"""The phase across the pupil."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel import validation

MAX_HIGHER = 8
"""Most coefficients beyond rho^4."""


@dataclass(frozen=True, eq=False, init=False)
class Wavefront:
    r"""A radially symmetric phase, ``2 C_d rho^2 + C_s rho^4 + c_6 rho^6 + ...`` in radians.

    rho is the pupil radius over its maximum, 0 to 1. A positive `defocus` means that the sensor lies between
    the lens and its focus. A positive `spherical` means that the rim of the pupil focuses beyond its middle.
    The constant phase is left out: no intensity depends on it. Wavefronts add, and can be multiplied by a number.

    Parameters
    ----------
    defocus : array_like, default 0
        C_d of the paper's Eq. (2), radians. An array describes a stack of wavefronts.
    spherical : array_like, default 0
        C_s of the paper's Eq. (15), radians.
    higher : sequence of array_like, default ()
        Coefficients of rho^6, rho^8, ..., radians; at most eight.

    Attributes
    ----------
    shape : tuple of int
        Of the stack; ``()`` for a single wavefront.
    coefficients : ndarray, shape ``shape + (terms,)``
        Of t, t^2, t^3, ... with t = rho^2, radians.

    Raises
    ------
    TypeError, ValueError
        If a coefficient is not real and finite, or if the arrays do not broadcast.

    Examples
    --------
    >>> Wavefront(defocus=10.0) + Wavefront.from_seidel(W040=0.5)
    Wavefront(defocus=10.0, spherical=3.141592653589793)
    """

    defocus: NDArray[np.float64]
    spherical: NDArray[np.float64]
    higher: tuple[NDArray[np.float64], ...] = field(default=())
    shape: tuple[int, ...] = field(init=False, repr=False)
    coefficients: NDArray[np.float64] = field(init=False, repr=False)

    def __init__(
        self, defocus: ArrayLike = 0.0, spherical: ArrayLike = 0.0, higher: Sequence[ArrayLike] = ()
    ) -> None:
        if not isinstance(higher, Sequence) or isinstance(higher, str | bytes):
            raise TypeError(f"higher must be a sequence of coefficients, got {higher!r}")
        if len(higher) > MAX_HIGHER:
            raise ValueError(f"higher must hold at most {MAX_HIGHER} coefficients, got {len(higher)}")
        object.__setattr__(self, "defocus", validation.real_array("defocus", defocus))
        object.__setattr__(self, "spherical", validation.real_array("spherical", spherical))
        rest = tuple(validation.real_array(f"higher[{i}]", c) for i, c in enumerate(higher))
        object.__setattr__(self, "higher", rest)
        terms = (2.0 * self.defocus, self.spherical, *rest)
        try:
            together = np.broadcast_arrays(*terms)
        except ValueError:
            shapes = [c.shape for c in terms]
            raise ValueError(f"defocus, spherical and higher must broadcast, got shapes {shapes}") from None
        coefficients = np.stack(together, axis=-1)
        coefficients.flags.writeable = False
        if coefficients.size == 0:
            raise ValueError(f"defocus, spherical and higher must not be empty, got shape {coefficients.shape[:-1]}")
        object.__setattr__(self, "shape", coefficients.shape[:-1])
        object.__setattr__(self, "coefficients", coefficients)

    @classmethod
    def from_seidel(
        cls, W020: ArrayLike = 0.0, W040: ArrayLike = 0.0, W060: ArrayLike = 0.0, W080: ArrayLike = 0.0
    ) -> Wavefront:
        """Build a wavefront from Seidel wavefront coefficients in waves at the edge of the pupil.

        ``C_d = pi W020`` and ``C_s = 2 pi W040``: W020 waves of defocus are ``2 pi W020 rho^2`` radians.
        """
        waves = {"W020": W020, "W040": W040, "W060": W060, "W080": W080}
        w = {name: 2 * math.pi * validation.real_array(name, value) for name, value in waves.items()}
        higher = [w["W060"], w["W080"]]
        while higher and not np.any(higher[-1]):
            higher.pop()
        return cls(0.5 * w["W020"], w["W040"], higher)

    @classmethod
    def balanced_spherical(cls, rms: ArrayLike, obscuration: float = 0.0) -> Wavefront:
        r"""Build primary spherical aberration of a given rms, balanced with the defocus of least variance.

        On the annulus ``eps <= rho <= 1`` this is the annular Zernike term
        ``C_s (rho^4 - (1 + eps^2) rho^2 + ...)`` with ``C_s = 6 sqrt(5) rms / (1 - eps^2)^2``.

        Parameters
        ----------
        rms : array_like
            Root mean square phase over the annulus, radians; its sign is that of C_s.
        obscuration : float
            eps, 0 to below 1.

        References
        ----------
        V. N. Mahajan, "Zernike annular polynomials for imaging systems with annular pupils",
        J. Opt. Soc. Am. 71, 75 (1981), doi:10.1364/JOSA.71.000075.
        """
        eps = validation.real("obscuration", obscuration, least=0.0, below=1.0)
        spherical = 6 * math.sqrt(5) * validation.real_array("rms", rms) / (1 - eps**2) ** 2
        return cls(-0.5 * (1 + eps**2) * spherical, spherical)

    @property
    def waves(self) -> dict[str, NDArray[np.float64]]:
        """Seidel coefficients W020, W040, W060, ... in waves."""
        names = [f"W0{2 * k}0" for k in range(1, 1 + self.coefficients.shape[-1])]
        return {name: self.coefficients[..., k] / (2 * math.pi) for k, name in enumerate(names)}

    def __getitem__(self, index: Any) -> Wavefront:
        """Return part of a stack, as NumPy indexes arrays of its shape."""
        if self.shape == ():
            raise TypeError("a single wavefront cannot be indexed")
        parts = [np.broadcast_to(c, self.shape)[index] for c in (self.defocus, self.spherical, *self.higher)]
        return Wavefront(parts[0], parts[1], parts[2:])

    def phase(self, rho: ArrayLike) -> NDArray[np.float64]:
        """Return the phase in radians at pupil radii `rho` (0 to 1); shape ``shape + rho.shape``."""
        t = validation.real_array("rho", rho, least=0.0) ** 2
        coefficients = self.coefficients.reshape(self.shape + (-1,) + (1,) * t.ndim)
        total = np.zeros(self.shape + t.shape)
        for k in reversed(range(self.coefficients.shape[-1])):
            total = (total + np.take(coefficients, k, axis=len(self.shape))) * t
        return total

    def __add__(self, other: object) -> Wavefront:
        """Return the sum of two wavefronts."""
        if not isinstance(other, Wavefront):
            return NotImplemented
        count = max(len(self.higher), len(other.higher))
        zero = np.zeros(())
        mine = self.higher + (zero,) * (count - len(self.higher))
        theirs = other.higher + (zero,) * (count - len(other.higher))
        return Wavefront(
            self.defocus + other.defocus,
            self.spherical + other.spherical,
            tuple(a + b for a, b in zip(mine, theirs, strict=True)),
        )

    def __mul__(self, factor: float) -> Wavefront:
        """Return the wavefront times a number."""
        f = validation.real("factor", factor)
        return Wavefront(f * self.defocus, f * self.spherical, tuple(f * c for c in self.higher))

    __rmul__ = __mul__
    # NumPy is not to multiply each element of an array with a wavefront, but to leave that to __rmul__.
    __array_ufunc__ = None

    def __truediv__(self, divisor: float) -> Wavefront:
        """Return the wavefront divided by a number."""
        d = validation.real("divisor", divisor)
        if d == 0:
            raise ValueError("divisor must not be 0")
        return self * (1.0 / d)

    def __neg__(self) -> Wavefront:
        """Return the conjugate wavefront."""
        return -1.0 * self

    def __sub__(self, other: object) -> Wavefront:
        """Return the difference of two wavefronts."""
        if not isinstance(other, Wavefront):
            return NotImplemented
        return self + -other

    def __eq__(self, other: object) -> bool:
        """Two wavefronts are equal if their shapes and all their coefficients are."""
        if not isinstance(other, Wavefront):
            return NotImplemented
        difference = self.coefficients if self.shape != other.shape else (self - other).coefficients
        return self.shape == other.shape and not np.any(difference)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        parts = {"defocus": self.defocus, "spherical": self.spherical}
        shown = [f"{name}={_short(value)}" for name, value in parts.items()]
        if self.higher:
            shown.append(f"higher=({', '.join(_short(c) for c in self.higher)},)")
        return f"Wavefront({', '.join(shown)})"

    def to_dict(self) -> dict[str, Any]:
        """Return the coefficients as plain lists and numbers; the inverse of ``Wavefront(**...)``."""
        return {
            "defocus": self.defocus.tolist(),
            "spherical": self.spherical.tolist(),
            "higher": [c.tolist() for c in self.higher],
        }


def _short(value: NDArray[np.float64]) -> str:
    if value.ndim == 0:
        return repr(float(value))
    return f"<array {value.shape} from {value.min():g} to {value.max():g}>"
