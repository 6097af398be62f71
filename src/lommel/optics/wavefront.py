"""The phase across the pupil."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from types import MappingProxyType
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.optics.descriptions import Descriptions
from lommel.special import zernike

_FAR = 1e3  # the pupil ends at 1; beyond this, powers of rho overflow
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
    terms : tuple of (n, m)
        The Zernike terms that the wavefront is held in: first (2, 0), (4, 0), ..., all up to the last, then those
        that depend on the direction, sorted.
    edge : ndarray, shape ``shape + (len(terms),)``
        Their coefficients, radians at the edge; read-only. What was given as powers of rho is kept beside them and
        comes back as it was.

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

    terms: tuple[tuple[int, int], ...]
    edge: NDArray[np.float64]
    error: float
    shape: tuple[int, ...]
    _powers: NDArray[np.float64] | None = field(repr=False)

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
        with np.errstate(over="ignore"):
            double = 2.0 * validation.real_array("defocus", defocus)
        columns = [validation.real_array("twice the defocus", double), validation.real_array("spherical", spherical)]
        columns += [validation.real_array(f"higher[{i}]", c) for i, c in enumerate(higher)]
        others = {} if nonradial is None else _nonradial(nonradial)
        shapes = [c.shape for c in (*columns, *others.values())]
        try:
            shape = np.broadcast_shapes(*shapes)
        except ValueError:
            raise ValueError(
                f"defocus, spherical, higher and nonradial must broadcast, got shapes {shapes}"
            ) from None
        powers, edge = np.empty((*shape, len(columns))), np.empty((*shape, len(shapes)))
        for k, c in enumerate(columns):
            powers[..., k] = c
        for j, c in enumerate(others.values(), len(columns)):
            edge[..., j] = c
        with np.errstate(over="ignore", invalid="ignore"):  # what is not finite then is told
            self._set((*_radial(len(columns)), *others), edge, validation.real("error", error, least=0.0), powers)

    def _set(
        self,
        terms: tuple[tuple[int, int], ...],
        edge: NDArray[np.float64],
        error: float,
        powers: NDArray[np.float64] | None,
    ) -> None:
        """Take what was checked. Of powers that are given the radial terms are made, into `edge`."""
        if powers is not None:
            edge[..., : powers.shape[-1]] = zernike.edge_of_powers(powers)
            powers.flags.writeable = False
        if edge.size == 0:
            raise ValueError(f"the coefficients of a wavefront must not be empty, got shape {edge.shape[:-1]}")
        if not np.isfinite(edge).all():
            raise ValueError("the coefficients of a wavefront must be finite, and so must their multiples and sums")
        edge.flags.writeable = False
        # As object.__setattr__ would, but all at once.
        vars(self).update(terms=terms, edge=edge, error=error, _powers=powers, shape=edge.shape[:-1])

    @classmethod
    def trusted(
        cls,
        terms: tuple[tuple[int, int], ...],
        edge: NDArray[np.float64],
        error: float = 0.0,
        powers: NDArray[np.float64] | None = None,
    ) -> Self:
        """Return the wavefront of what was checked before, and takes the arrays: nobody else may write into them."""
        made = cls.__new__(cls)
        made._set(terms, edge, error, powers)
        return made

    @classmethod
    def from_edge(cls, given: Mapping[tuple[int, int], NDArray[np.float64]], error: float = 0.0) -> Self:
        """Build a wavefront from coefficients in radians at the edge, radial terms and the constant among them."""
        try:
            # With the constant, lest a stack whose terms are all constant lose its axes.
            shape = np.broadcast_shapes(*(c.shape for c in given.values()))
        except ValueError:
            shapes = {term: c.shape for term, c in given.items()}
            raise ValueError(f"the coefficients of the terms (n, m) must broadcast, got shapes {shapes}") from None
        count = max([2, *(n // 2 for (n, m), c in given.items() if m == 0 and np.any(c))])
        terms = (*_radial(count), *sorted(term for term in given if term[1]))
        edge = np.zeros((*shape, len(terms)))
        for j, term in enumerate(terms):
            edge[..., j] = given.get(term, 0.0)
        symmetric = any(np.any(c) for (n, m), c in given.items() if m == 0 and n > 0)
        return cls.trusted(terms, edge, error, None if symmetric else np.zeros((*shape, count)))

    @classmethod
    def of_defocus(cls, defocus: NDArray[np.float64]) -> Self:
        """Build a wavefront from a checked C_d, radians."""
        powers = np.zeros((*defocus.shape, 2))
        powers[..., 0] = 2.0 * defocus
        return cls.trusted(_radial(2), np.empty_like(powers), 0.0, powers)

    @classmethod
    def radial_sum(cls, edge: NDArray[np.float64], error: float = 0.0) -> Self:
        """Build a wavefront from checked coefficients of R_2^0, R_4^0, ..., two or more, along the last axis."""
        return cls.trusted(_radial(edge.shape[-1]), edge, error)

    @cached_property
    def symmetric(self) -> int:
        """How many of the terms, the first, are radially symmetric: those of n = 2, 4, ..."""
        return sum(m == 0 for _, m in self.terms)

    @cached_property
    def radial_terms(self) -> NDArray[np.float64]:
        """Coefficients of R_2^0, R_4^0, ..., shape ``shape + (terms,)``."""
        return self.edge if self.symmetric == len(self.terms) else self.edge[..., : self.symmetric].copy()

    @cached_property
    def indices(self) -> NDArray[np.int32]:
        """The n and m of each term, shape ``(terms, 2)``."""
        found = np.array(self.terms, dtype=np.int32)
        found.flags.writeable = False
        return found

    @cached_property
    def coefficients(self) -> NDArray[np.float64]:
        """Coefficients of t, t^2, ... with t = rho^2, radians: the radially symmetric part."""
        if self._powers is not None:
            return self._powers
        powers = zernike.powers_of_edge(self.radial_terms)
        powers.flags.writeable = False
        return powers

    @cached_property
    def defocus(self) -> NDArray[np.float64]:
        """C_d, radians."""
        half = np.asarray(0.5 * self.coefficients[..., 0])
        half.flags.writeable = False
        return half

    @property
    def spherical(self) -> NDArray[np.float64]:
        """C_s, radians."""
        return np.asarray(self.coefficients[..., 1])

    @property
    def higher(self) -> tuple[NDArray[np.float64], ...]:
        """Coefficients of rho^6, rho^8, ..., radians."""
        return tuple(np.moveaxis(self.coefficients[..., 2:], -1, 0))

    @cached_property
    def nonradial(self) -> Mapping[tuple[int, int], NDArray[np.float64]]:
        """Coefficients of the other terms, radians at the edge, by (n, m)."""
        others = enumerate(self.terms[self.symmetric :], self.symmetric)
        return MappingProxyType({term: np.asarray(self.edge[..., j]) for j, term in others})

    def edge_terms(self) -> dict[tuple[int, int], NDArray[np.float64]]:
        """Return all Zernike coefficients, radians at the edge, by (n, m), without the constant."""
        return dict(zip(self.terms, np.moveaxis(self.edge, -1, 0), strict=True))

    @cached_property
    def flat(self) -> bool:
        """Whether there is no phase at all, and no stack of it."""
        return not (self.edge.any() or self.error or self.shape)

    @property
    def radial(self) -> bool:
        """Whether the phase depends on rho only: no other term, or none but zeros."""
        return not self.nonradial or not any(np.any(c) for c in self.nonradial.values())

    @property
    def waves(self) -> dict[str, NDArray[np.float64]]:
        """Seidel coefficients W020, W040, W060, ... in waves: the radially symmetric part."""
        names = [f"W0{2 * k}0" for k in range(1, 1 + self.coefficients.shape[-1])]
        return {name: self.coefficients[..., k] / (2 * math.pi) for k, name in enumerate(names)}

    @cached_property
    def left_out(self) -> float:
        """Bound on what the terms leave out of the phase: `error`, and what they lose where powers of rho cancel.

        A rounding of each term is not counted here: engines count it.
        """
        if self._powers is None or self.symmetric <= 2:
            return self.error
        lost = zernike.conversion_error(self._powers)
        rounded = 2.0**-53 * np.abs(self.radial_terms).sum(axis=-1)
        return self.error + (float(lost.max()) if np.any(lost > rounded) else 0.0)

    def __getitem__(self, index: Any) -> Wavefront:
        """Return part of a stack, as NumPy indexes arrays of its shape."""
        if self.shape == ():
            raise TypeError("a single wavefront cannot be indexed")

        def part(columns: NDArray[np.float64]) -> NDArray[np.float64]:
            return np.stack([column[index] for column in np.moveaxis(columns, -1, 0)], axis=-1)

        return self._each(part)

    def _each(self, change: Callable[[NDArray[np.float64]], NDArray[np.float64]], growth: float = 1.0) -> Wavefront:
        """Return the wavefront whose coefficients went through `change`, its error `growth` times as large."""
        powers = None if self._powers is None else change(self._powers)
        return self.trusted(self.terms, change(self.edge), growth * self.error, powers)

    def flattened(self) -> Wavefront:
        """Return the same stack with the shape ``(n,)``; a single wavefront becomes a stack of one."""
        if self.edge.ndim == 2:
            return self
        return self._each(lambda c: c.reshape(-1, c.shape[-1]).copy())

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
        at = (1,) * r.ndim
        total = zernike.legendre_sum(self.radial_terms, 2.0 * r * r - 1.0)
        for (n, m), c in self.nonradial.items():
            total += c.reshape(self.shape + at) * zernike.polynomial(n, m, r, angle)
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
        powers = None if self._powers is None else _broadcast(self._powers, shape)
        edge = _broadcast(self.edge, shape)
        turned = zernike.rotated(dict(self.nonradial), turn)
        terms = (*self.terms[: self.symmetric], *sorted(turned))
        edge = np.stack([*np.moveaxis(edge, -1, 0)[: self.symmetric], *(turned[t] for t in sorted(turned))], axis=-1)
        return self.trusted(terms, edge, self.error, powers)

    def flipped(self, axis: str) -> Wavefront:
        """Return the mirror image: x changes its sign for "x" (left and right), y for "y" (up and down). Exact."""
        validation.choice("axis", axis, ("x", "y"))

        def sign(m: int) -> float:
            # theta -> -theta for "y", pi - theta for "x".
            return (1.0 if m > 0 else -1.0) * (-1.0 if axis == "x" and m % 2 else 1.0)

        signs = np.array([sign(m) if m else 1.0 for _, m in self.terms])
        return self.trusted(self.terms, signs * self.edge, self.error, self._powers)

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
        try:
            shape = np.broadcast_shapes(self.shape, eps.shape)
        except ValueError:
            raise ValueError(f"radius must broadcast with the stack, got {eps.shape} and {self.shape}") from None
        found = zernike.scaled(self.edge_terms(), np.broadcast_to(eps, shape))
        terms = (*_radial(self.symmetric), *sorted(term for term in found if term[1]))
        edge = np.stack([np.broadcast_to(found[term], shape) for term in terms], axis=-1)
        powers = None
        if self._powers is not None:
            powers = self._powers * eps[..., None] ** (2.0 * np.arange(1, 1 + self.symmetric))
        return self.trusted(terms, edge, self.error, powers)

    def __add__(self, other: object) -> Wavefront:
        """Return the sum of two wavefronts."""
        if not isinstance(other, Wavefront):
            return NotImplemented
        try:
            shape = np.broadcast_shapes(self.shape, other.shape)
        except ValueError:
            raise ValueError(f"wavefronts must broadcast to add, got shapes {self.shape} and {other.shape}") from None
        terms = self.terms
        if other.terms != terms:
            others = {*terms[self.symmetric :], *other.terms[other.symmetric :]}
            terms = (*_radial(max(self.symmetric, other.symmetric)), *sorted(others))
        edge = np.zeros((*shape, len(terms)))
        powers = None
        if self._powers is not None and other._powers is not None:
            powers = np.zeros((*shape, max(self.symmetric, other.symmetric)))
        with np.errstate(over="ignore", invalid="ignore"):
            for each in (self, other):
                if each.terms == terms:
                    edge += each.edge
                else:
                    edge[..., [terms.index(term) for term in each.terms]] += each.edge
                if powers is not None and each._powers is not None:
                    powers[..., : each.symmetric] += each._powers
        return self.trusted(terms, edge, self.error + other.error, powers)

    def __mul__(self, factor: float) -> Wavefront:
        """Return the wavefront times a number."""
        f = validation.real("factor", factor)
        with np.errstate(over="ignore"):  # what is not finite then is told
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
        return self._content() == other._content()

    def _content(self) -> tuple[Any, ...]:
        """Return what wavefronts that are equal share: no term that is zero throughout, no sign of a zero."""
        return self.shape, *((t, (c + 0.0).tobytes()) for t, c in self.edge_terms().items() if np.any(c))

    def __reduce__(self) -> tuple[Any, ...]:
        # Without the views, of which that of `nonradial` cannot be pickled.
        powers = None if self._powers is None else self._powers.copy()
        return Wavefront.trusted, (self.terms, self.edge.copy(), self.error, powers)

    def __hash__(self) -> int:
        """Hash what :meth:`__eq__` compares."""
        return hash(self._content())

    def __repr__(self) -> str:
        if self._powers is None:
            terms = {t: c for t, c in self.edge_terms().items() if np.any(c)}
            error = f", error={self.error:.3g}" if self.error else ""
            return f'Wavefront.zernike({_listed(terms)}, normalization="edge"{error})'
        shown = [f"defocus={_short(self.defocus, shape=True)}", f"spherical={_short(self.spherical)}"]
        if self.higher:
            shown.append(f"higher=({', '.join(_short(c) for c in self.higher)},)")
        if self.nonradial:
            shown.append(f"nonradial={_listed(self.nonradial)}")
        if self.error:
            shown.append(f"error={self.error:.3g}")
        return f"Wavefront({', '.join(shown)})"

    def to_dict(self) -> dict[str, Any]:
        """Return the coefficients as plain lists and numbers; :meth:`from_dict` is the inverse."""
        if self._powers is None:
            plain: dict[str, Any] = {"terms": [[n, m, c.tolist()] for (n, m), c in self.edge_terms().items()]}
        else:
            # What is the same throughout the stack is said once; the defocus has its shape.
            plain = {
                "defocus": self.defocus.tolist(),
                "spherical": _once_or_all(self.spherical),
                "higher": [_once_or_all(c) for c in self.higher],
            }
            if self.nonradial:
                plain["nonradial"] = [[n, m, _once_or_all(c)] for (n, m), c in self.nonradial.items()]
        if self.error:
            plain["error"] = self.error
        return plain

    @classmethod
    def from_dict(cls, description: Mapping[str, Any]) -> Wavefront:
        """Rebuild a wavefront from :meth:`to_dict`."""
        parts = dict(description)
        if "terms" in parts:
            found = {zernike.check_term(n, m): c for (n, m), c in _once("terms", parts.pop("terms")).items()}
            checked = {(n, m): validation.real_array(f"terms[{n}, {m}]", c) for (n, m), c in found.items()}
            return cls.from_edge(checked, validation.real("error", parts.pop("error", 0.0), least=0.0), **parts)
        others = _once("nonradial", parts.pop("nonradial", []))
        return cls(**parts, nonradial=others)


def _once_or_all(value: NDArray[np.float64]) -> Any:
    return float(value.flat[0]) if value.min() == value.max() else value.tolist()


def _once(name: str, listed: Iterable[Sequence[Any]]) -> dict[tuple[int, int], Any]:
    terms: dict[tuple[int, int], Any] = {}
    for n, m, value in listed:
        if (n, m) in terms:
            raise ValueError(f"{name} holds the term (n, m) = ({n}, {m}) twice")
        terms[n, m] = value
    return terms


@lru_cache(maxsize=64)
def _radial(count: int) -> tuple[tuple[int, int], ...]:
    return tuple((2 * k, 0) for k in range(1, count + 1))


def _broadcast(columns: NDArray[np.float64], shape: tuple[int, ...]) -> NDArray[np.float64]:
    return np.broadcast_to(columns, (*shape, columns.shape[-1])).copy()


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


def _listed(terms: Mapping[tuple[int, int], NDArray[np.float64]]) -> str:
    return f"{{{', '.join(f'{t}: {_short(c)}' for t, c in terms.items())}}}"


def _short(value: NDArray[np.float64], *, shape: bool = False) -> str:
    if value.ndim == 0 or (not shape and value.min() == value.max()):
        return repr(float(value.flat[0]))
    return f"<array {value.shape} from {value.min():g} to {value.max():g}>"
