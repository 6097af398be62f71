"""The phase across the pupil."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel import validation
from lommel.descriptions import Descriptions
from lommel.special import zernike

_FAR = 1e3  # the pupil ends at 1; beyond this, powers of rho overflow
_MOST = 0.5 * float(np.finfo(np.float64).max)
MAX_HIGHER = 8
"""Most coefficients beyond rho^4."""


@dataclass(frozen=True, eq=False, init=False)
class Wavefront(Descriptions):
    r"""The phase across the pupil, radians: ``2 C_d rho^2 + C_s rho^4 + c_6 rho^6 + ...`` and Zernike terms.

    rho is the pupil radius over its maximum, 0 to 1; theta the angle from the direction of rising columns (x) to
    that of rising rows (y). A positive `defocus` means that the sensor lies between the lens and its focus. A
    positive `spherical` means that the rim of the pupil focuses beyond its middle. The pupil function is
    ``exp(+i phase)``, and a ray meets the sensor at the gradient of the phase: a positive tilt in x moves the image
    to higher columns, and the tail of positive coma in x points there.
    The constant phase is left out: no intensity depends on it. Wavefronts add, and can be multiplied by a number.

    Parameters
    ----------
    defocus : array_like, default 0
        C_d of the paper's Eq. (2), radians. An array describes a stack of wavefronts.
    spherical : array_like, default 0
        C_s of the paper's Eq. (15), radians.
    higher : sequence of array_like, default ()
        Coefficients of rho^6, rho^8, ..., radians; at most eight.
    nonradial : mapping of (n, m) to array_like, default {}
        Coefficients, radians at the edge, of ``R_n^m(rho) cos(m theta)`` for m > 0 and of
        ``R_n^|m|(rho) sin(|m| theta)`` for m < 0, with ``R(1) = 1``. m is not 0: such terms are radial. See
        :meth:`zernike` for other orders, units and normalisations.
    error : float, default 0
        Bound on what the terms leave out of the phase that they stand for, radians; the largest of a stack. It adds
        to the `error_bound` of a PSF.

    Attributes
    ----------
    shape : tuple of int
        Of the stack; ``()`` for a single wavefront.
    coefficients : ndarray, shape ``shape + (terms,)``
        Of t, t^2, t^3, ... with t = rho^2, radians: the radially symmetric part.

    Raises
    ------
    TypeError, ValueError
        If a coefficient is not real and finite, if there is no such term, or if the arrays do not broadcast.

    Examples
    --------
    >>> Wavefront(defocus=10.0) + Wavefront.from_seidel(W040=0.5)
    Wavefront(defocus=10.0, spherical=3.141592653589793)
    >>> Wavefront(defocus=1.0, nonradial={(3, 1): 2.0})
    Wavefront(defocus=1.0, spherical=0.0, nonradial={(3, 1): 2.0})
    """

    defocus: NDArray[np.float64]
    spherical: NDArray[np.float64]
    higher: tuple[NDArray[np.float64], ...] = field(default=())
    nonradial: Mapping[tuple[int, int], NDArray[np.float64]] = field(default_factory=dict)
    error: float = 0.0
    shape: tuple[int, ...] = field(init=False, repr=False)
    coefficients: NDArray[np.float64] = field(init=False, repr=False)

    def __init__(
        self,
        defocus: ArrayLike = 0.0,
        spherical: ArrayLike = 0.0,
        higher: Sequence[ArrayLike] = (),
        nonradial: Mapping[tuple[int, int], ArrayLike] | None = None,
        error: float = 0.0,
    ) -> None:
        if not isinstance(higher, Sequence) or isinstance(higher, str | bytes):
            raise TypeError(f"higher must be a sequence of coefficients, got {validation.shown(higher)}")
        if len(higher) > MAX_HIGHER:
            raise ValueError(f"higher must hold at most {MAX_HIGHER} coefficients, got {len(higher)}")
        object.__setattr__(self, "defocus", validation.real_array("defocus", defocus))
        if np.any(np.abs(self.defocus) > _MOST):
            raise ValueError(f"defocus must be finite, and so must its double be, got {validation.shown(defocus)}")
        object.__setattr__(self, "spherical", validation.real_array("spherical", spherical))
        rest = tuple(validation.real_array(f"higher[{i}]", c) for i, c in enumerate(higher))
        object.__setattr__(self, "higher", rest)
        others = {} if nonradial is None else _nonradial(nonradial)
        object.__setattr__(self, "nonradial", MappingProxyType(others))
        object.__setattr__(self, "error", validation.real("error", error, least=0.0))
        terms = (2.0 * self.defocus, self.spherical, *rest)
        try:
            together = np.broadcast_arrays(*terms, *others.values())
        except ValueError:
            shapes = [c.shape for c in (*terms, *others.values())]
            raise ValueError(
                f"defocus, spherical, higher and nonradial must broadcast, got shapes {shapes}"
            ) from None
        coefficients = np.stack(together[: len(terms)], axis=-1)
        coefficients.flags.writeable = False
        if coefficients.size == 0:
            raise ValueError(f"defocus, spherical and higher must not be empty, got shape {coefficients.shape[:-1]}")
        object.__setattr__(self, "shape", coefficients.shape[:-1])
        object.__setattr__(self, "coefficients", coefficients)

    @classmethod
    def _from_edge(cls, terms: Mapping[tuple[int, int], NDArray[np.float64]]) -> Self:
        """Build a wavefront from coefficients in radians at the edge, radial terms and the constant among them."""
        radial = {n // 2: c for (n, m), c in terms.items() if m == 0 and n > 0}
        count = max([2, *radial])
        if count > 2 + MAX_HIGHER:
            raise ValueError(
                f"the Zernike term (n, m) = ({2 * count}, 0) is beyond the limit of n = {2 * (2 + MAX_HIGHER)} for "
                "radially symmetric ones"
            )
        matrix = zernike.legendre_to_powers(count)
        # Zeros of the common shape, lest a stack whose terms are all constant lose its axes.
        zero = np.zeros(_common_shape(terms))
        powers = [sum((matrix[k, j - 1] * c for j, c in radial.items()), zero) for k in range(count)]
        others = {term: c for term, c in terms.items() if term[1] != 0}
        return cls(0.5 * powers[0], powers[1], powers[2:], others)

    def edge_terms(self) -> dict[tuple[int, int], NDArray[np.float64]]:
        """Return all Zernike coefficients, radians at the edge, by (n, m), without the constant."""
        matrix = zernike.powers_to_legendre(self.coefficients.shape[-1])[1:]
        legendre = (self.coefficients @ matrix.T).astype(np.float64)
        radial = {(2 * k + 2, 0): legendre[..., k] for k in range(legendre.shape[-1])}
        return radial | dict(self.nonradial)

    @property
    def radial(self) -> bool:
        """Whether the phase depends on rho only: no other term, or none but zeros."""
        return not self.nonradial or not any(np.any(c) for c in self.nonradial.values())

    @property
    def waves(self) -> dict[str, NDArray[np.float64]]:
        """Seidel coefficients W020, W040, W060, ... in waves: the radially symmetric part."""
        names = [f"W0{2 * k}0" for k in range(1, 1 + self.coefficients.shape[-1])]
        return {name: self.coefficients[..., k] / (2 * math.pi) for k, name in enumerate(names)}

    def __getitem__(self, index: Any) -> Wavefront:
        """Return part of a stack, as NumPy indexes arrays of its shape."""
        if self.shape == ():
            raise TypeError("a single wavefront cannot be indexed")

        def part(c: NDArray[np.float64]) -> Any:
            return np.broadcast_to(c, self.shape)[index]

        return self._each(part)

    def _each(self, change: Any, growth: float = 1.0) -> Wavefront:
        """Return the wavefront whose every coefficient went through `change`, its error `growth` times as large."""
        rest = tuple(change(c) for c in self.higher)
        others = {t: change(c) for t, c in self.nonradial.items()}
        return Wavefront(change(self.defocus), change(self.spherical), rest, others, growth * self.error)

    def flattened(self) -> Wavefront:
        """Return the same stack with the shape ``(n,)``; a single wavefront becomes a stack of one."""
        return self._each(lambda c: np.broadcast_to(c, self.shape).reshape(-1))

    def phase(self, rho: ArrayLike, theta: ArrayLike = 0.0) -> NDArray[np.float64]:
        """Return the phase in radians at pupil radii `rho` (0 to 1) and angles `theta`.

        Shape ``shape + s``, with s what `rho` and `theta` broadcast to.
        """
        r, angle = validation.real_array("rho", rho, least=0.0), validation.real_array("theta", theta)
        try:
            r, angle = np.broadcast_arrays(r, angle)
        except ValueError:
            raise ValueError(f"rho and theta must broadcast, got shapes {r.shape} and {angle.shape}") from None
        if r.size and r.max() > _FAR:
            raise ValueError(f"rho must be at most {_FAR:g}, got {r.max():g}")
        t = r**2
        dim = len(self.shape)
        coefficients = self.coefficients.reshape(self.shape + (-1,) + (1,) * t.ndim)
        total = np.zeros(self.shape + t.shape)
        for k in reversed(range(self.coefficients.shape[-1])):
            total = (total + np.take(coefficients, k, axis=dim)) * t
        for (n, m), c in self.nonradial.items():
            weight = np.broadcast_to(c, self.shape).reshape(self.shape + (1,) * t.ndim)
            total += weight * zernike.polynomial(n, m, r, angle)
        return total

    def rotated(self, angle: ArrayLike) -> Wavefront:
        """Return the wavefront turned by `angle`, radians from x towards y: clockwise in a picture.

        ``phase'(rho, theta) = phase(rho, theta - angle)``, and the image turns by the same angle. Exact but for
        rounding: each pair of terms (n, m) and (n, -m) turns in its plane by m times the angle. Arrays of angles
        broadcast with the stack.
        """
        turn = validation.real_array("angle", angle)
        try:
            shape = np.broadcast_shapes(self.shape, turn.shape)
        except ValueError:
            raise ValueError(f"angle must broadcast with the stack, got {turn.shape} and {self.shape}") from None
        zero = np.zeros(())
        turned: dict[tuple[int, int], NDArray[np.float64]] = {}
        for n, m in {(n, abs(m)) for n, m in self.nonradial}:
            a, b = self.nonradial.get((n, m), zero), self.nonradial.get((n, -m), zero)
            cosine, sine = np.cos(m * turn), np.sin(m * turn)
            turned[n, m], turned[n, -m] = a * cosine - b * sine, a * sine + b * cosine
        return Wavefront(np.broadcast_to(self.defocus, shape), self.spherical, self.higher, turned, self.error)

    def flipped(self, axis: str) -> Wavefront:
        """Return the mirror image: x changes its sign for "x" (left and right), y for "y" (up and down). Exact."""
        validation.choice("axis", axis, ("x", "y"))

        def sign(m: int) -> float:
            # theta -> -theta for "y", pi - theta for "x".
            return (1.0 if m > 0 else -1.0) * (-1.0 if axis == "x" and m % 2 else 1.0)

        terms = {(n, m): sign(m) * c for (n, m), c in self.nonradial.items()}
        return Wavefront(self.defocus, self.spherical, self.higher, terms, self.error)

    def scaled(self, radius: ArrayLike) -> Wavefront:
        """Return the wavefront across a smaller, concentric pupil: ``phase'(rho, theta) = phase(radius rho, theta)``.

        Exact but for rounding, and but for the constant. Arrays of radii broadcast with the stack.

        Parameters
        ----------
        radius : array_like
            Radius of the smaller pupil over that of this one, above 0 and at most 1.

        References
        ----------
        A. J. E. M. Janssen and P. Dirksen, "A concise formula for the Zernike coefficients of scaled pupils",
        J. Microlith. Microfab. Microsyst. 5, 030501 (2006).
        """
        eps = validation.real_array("radius", radius)
        if not np.all((eps > 0.0) & (eps <= 1.0)):
            bad = eps[~((eps > 0.0) & (eps <= 1.0))].flat[0]
            raise ValueError(f"radius must be > 0 and <= 1, got {bad:g}")
        terms: dict[tuple[int, int], Any] = {}
        try:
            powers = [c * eps ** (2 * k) for k, c in enumerate((self.defocus, self.spherical, *self.higher), 1)]
            for (n, m), c in self.nonradial.items():
                # R_n^m(eps rho) = sum_k (R_n^k(eps) - R_n^(k+2)(eps)) R_k^m(rho), with k = abs(m), ..., n.
                for k in range(abs(m), n + 1, 2):
                    weight = zernike.radial(n, k, eps) - (zernike.radial(n, k + 2, eps) if k < n else 0.0)
                    terms[k, m] = terms.get((k, m), 0.0) + weight * c
        except ValueError:
            raise ValueError(f"radius must broadcast with the stack, got {eps.shape} and {self.shape}") from None
        return Wavefront(powers[0], powers[1], powers[2:], terms, self.error)

    def __add__(self, other: object) -> Wavefront:
        """Return the sum of two wavefronts."""
        if not isinstance(other, Wavefront):
            return NotImplemented
        count = max(len(self.higher), len(other.higher))
        zero = np.zeros(())
        mine = self.higher + (zero,) * (count - len(self.higher))
        theirs = other.higher + (zero,) * (count - len(other.higher))
        terms = {**self.nonradial, **other.nonradial}
        return Wavefront(
            self.defocus + other.defocus,
            self.spherical + other.spherical,
            tuple(a + b for a, b in zip(mine, theirs, strict=True)),
            {t: self.nonradial.get(t, zero) + other.nonradial.get(t, zero) for t in terms},
            self.error + other.error,
        )

    def __mul__(self, factor: float) -> Wavefront:
        """Return the wavefront times a number."""
        f = validation.real("factor", factor)
        return self._each(lambda c: f * c, abs(f))

    __rmul__ = __mul__
    # NumPy is not to multiply each element of an array with a wavefront, but to leave that to __rmul__.
    __array_ufunc__ = None

    def __truediv__(self, divisor: float) -> Wavefront:
        """Return the wavefront divided by a number."""
        d = validation.real("divisor", divisor)
        if d == 0 or math.isinf(1.0 / d):
            raise ValueError(f"divisor must not be 0, nor so close to it, got {d:g}")
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
        """Two wavefronts are equal if their shapes, all their coefficients and their errors are."""
        if not isinstance(other, Wavefront):
            return NotImplemented
        if self.shape != other.shape or self.error != other.error:
            return False
        difference = self - other
        return not np.any(difference.coefficients) and not any(np.any(c) for c in difference.nonradial.values())

    def __reduce__(self) -> tuple[Any, ...]:
        # The read-only view of `nonradial` cannot be pickled.
        return Wavefront, (self.defocus, self.spherical, self.higher, dict(self.nonradial), self.error)

    def __hash__(self) -> int:
        """Hash what :meth:`__eq__` compares: no term that is zero throughout, no sign of a zero."""
        powers = np.moveaxis(self.coefficients, -1, 0) + 0.0
        radial = [(k, c.tobytes()) for k, c in enumerate(powers) if np.any(c)]
        others = [
            (t, (np.broadcast_to(c, self.shape) + 0.0).tobytes()) for t, c in self.nonradial.items() if np.any(c)
        ]
        return hash((self.shape, tuple(radial), tuple(others)))

    def __repr__(self) -> str:
        parts = {"defocus": self.defocus, "spherical": self.spherical}
        shown = [f"{name}={_short(value)}" for name, value in parts.items()]
        if self.higher:
            shown.append(f"higher=({', '.join(_short(c) for c in self.higher)},)")
        if self.nonradial:
            shown.append(f"nonradial={{{', '.join(f'{t}: {_short(c)}' for t, c in self.nonradial.items())}}}")
        if self.error:
            shown.append(f"error={self.error:.3g}")
        return f"Wavefront({', '.join(shown)})"

    def to_dict(self) -> dict[str, Any]:
        """Return the coefficients as plain lists and numbers; :meth:`from_dict` is the inverse."""
        plain: dict[str, Any] = {
            "defocus": self.defocus.tolist(),
            "spherical": self.spherical.tolist(),
            "higher": [c.tolist() for c in self.higher],
        }
        if self.nonradial:
            plain["nonradial"] = [[n, m, c.tolist()] for (n, m), c in self.nonradial.items()]
        if self.error:
            plain["error"] = self.error
        return plain

    @classmethod
    def from_dict(cls, description: Mapping[str, Any]) -> Wavefront:
        """Rebuild a wavefront from :meth:`to_dict`."""
        parts = dict(description)
        terms: dict[tuple[int, int], Any] = {}
        for n, m, value in parts.pop("nonradial", []):
            if (n, m) in terms:
                raise ValueError(f"nonradial holds the term (n, m) = ({n}, {m}) twice")
            terms[n, m] = value
        return cls(**parts, nonradial=terms)


def _nonradial(terms: Mapping[Any, ArrayLike]) -> Mapping[tuple[int, int], NDArray[np.float64]]:
    if not isinstance(terms, Mapping):
        raise TypeError(f"nonradial must map (n, m) to coefficients, got {validation.shown(terms)}")
    found: dict[tuple[int, int], NDArray[np.float64]] = {}
    for key in terms:
        n, m = zernike.term(key, "nm")
        if m == 0:
            raise ValueError(f"nonradial must hold terms with m != 0, got {(n, m)}; Wavefront.zernike takes all")
        found[n, m] = validation.real_array(f"nonradial[{n}, {m}]", terms[key])
    return dict(sorted(found.items()))


def _common_shape(terms: Mapping[tuple[int, int], NDArray[np.float64]]) -> tuple[int, ...]:
    try:
        return np.broadcast_shapes(*(c.shape for c in terms.values()))
    except ValueError:
        shapes = {term: c.shape for term, c in terms.items()}
        raise ValueError(f"the coefficients of the terms (n, m) must broadcast, got shapes {shapes}") from None


def _short(value: NDArray[np.float64]) -> str:
    if value.ndim == 0:
        return repr(float(value))
    return f"<array {value.shape} from {value.min():g} to {value.max():g}>"
