"""The Zernike terms that a wavefront is held in: one array of coefficients at the edge, which adds and stacks."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.cached import cached_property
from lommel.special import zernike


@dataclass(frozen=True, eq=False, init=False, repr=False)
class Terms:
    """What a :class:`lommel.Wavefront` holds, whose attributes these are; checked once, trusted since."""

    terms: tuple[tuple[int, int], ...]
    edge: Array
    error: float
    shape: tuple[int, ...]
    # How many of the terms, the first, are radially symmetric: those of n = 2, 4, ...
    symmetric: int = field(repr=False)
    # Coefficients of rho^2, rho^4, ... where the radial terms were given so: what is shown, and comes back as it was.
    _powers: Array | None = field(repr=False)

    def _set(
        self,
        terms: tuple[tuple[int, int], ...],
        edge: Array,
        error: float,
        powers: Array | None,
    ) -> None:
        """Take what was checked. Of powers that are given the radial terms are made, into `edge`."""
        if powers is not None:
            with np.errstate(over="ignore", invalid="ignore"):  # what is not finite then is told
                edge[..., : powers.shape[-1]] = zernike.edge_of_powers(powers)
        if edge.size == 0:
            what = "the coefficients of a wavefront (defocus, spherical and others)"
            raise ValueError(f"{what} must not be empty, got shape {edge.shape[:-1]}")
        if not np.isfinite(edge).all():
            raise ValueError("the coefficients of a wavefront must be finite, and so must their multiples and sums")
        edge.flags.writeable = False
        if powers is not None:
            powers.flags.writeable = False
        # As object.__setattr__ would, but all at once.
        shape, symmetric = edge.shape[:-1], _symmetric(terms)
        vars(self).update(terms=terms, edge=edge, error=error, _powers=powers, shape=shape, symmetric=symmetric)

    @classmethod
    def trusted(
        cls,
        terms: tuple[tuple[int, int], ...],
        edge: Array,
        error: float = 0.0,
        powers: Array | None = None,
    ) -> Self:
        """Return the wavefront of what was checked before: its `terms`, `edge` and `error`.

        `powers` are the coefficients of rho^2, rho^4, ... where the radial terms were given so; these are then
        written into `edge`. The arrays are taken: nobody else may write into them.
        """
        made = cls.__new__(cls)
        made._set(terms, edge, error, powers)
        return made

    @classmethod
    def from_edge(cls, given: Mapping[tuple[int, int], Array], error: float = 0.0) -> Self:
        """Build a wavefront from coefficients in radians at the edge, radial terms and the constant among them.

        `given` has them by (n, m), `error` is that of a wavefront. ValueError if the coefficients do not broadcast.
        """
        try:
            # With the constant, lest a stack whose terms are all constant lose its axes.
            shape = np.broadcast_shapes(*(c.shape for c in given.values()))
        except ValueError:
            shapes = {term: c.shape for term, c in given.items()}
            raise ValueError(f"the coefficients of the terms (n, m) must broadcast, got shapes {shapes}") from None
        count = max([2, *(n // 2 for (n, m), c in given.items() if m == 0 and np.any(c))])
        terms = (*symmetric_terms(count), *sorted(term for term in given if term[1]))
        edge = np.zeros((*shape, len(terms)))
        for j, term in enumerate(terms):
            edge[..., j] = given.get(term, 0.0)
        symmetric = any(np.any(c) for (n, m), c in given.items() if m == 0 and n > 0)
        return cls.trusted(terms, edge, error, None if symmetric else np.zeros((*shape, count)))

    @classmethod
    def radial_sum(cls, edge: Array, error: float = 0.0) -> Self:
        """Build a wavefront from checked coefficients of R_2^0, R_4^0, ..., two or more: the last axis of `edge`.

        `error` is that of a wavefront.
        """
        return cls.trusted(symmetric_terms(edge.shape[-1]), edge, error)

    @property
    def radial_terms(self) -> Array:
        """Coefficients of R_2^0, R_4^0, ..., shape ``shape + (terms,)``."""
        return self.edge if self.symmetric == len(self.terms) else self.edge[..., : self.symmetric].copy()

    @property
    def indices(self) -> NDArray[np.int32]:
        """The n and m of each term, shape ``(terms, 2)``."""
        return _indices(self.terms)

    @cached_property
    def coefficients(self) -> Array:
        """Coefficients of t, t^2, ... with t = rho^2, radians: the radially symmetric part."""
        if self._powers is not None:
            return self._powers
        powers = zernike.powers_of_edge(self.radial_terms)
        powers.flags.writeable = False
        return powers

    def edge_terms(self) -> dict[tuple[int, int], Array]:
        """Return all Zernike coefficients, radians at the edge, by (n, m), without the constant."""
        return dict(zip(self.terms, np.moveaxis(self.edge, -1, 0), strict=True))

    @cached_property
    def flat(self) -> bool:
        """Whether there is no phase at all, and no stack of it."""
        return not (self.edge.any() or self.error or self.shape)

    @property
    def left_out(self) -> float:
        """Bound on what the terms leave out of the phase: `error`, and what they lose where powers of rho cancel.

        A rounding of each term is not counted here: engines count it.
        """
        return self.error + (0.0 if self._powers is None or self.symmetric <= 2 else self._lost)

    @cached_property
    def _lost(self) -> float:
        lost = zernike.conversion_error(self.coefficients)
        rounded = 2.0**-53 * np.abs(self.radial_terms).sum(axis=-1)
        return float(lost.max()) if np.any(lost > rounded) else 0.0

    def __len__(self) -> int:
        """Return how many wavefronts, or stacks of them, the first axis of a stack holds."""
        if self.shape == ():
            raise TypeError("a single wavefront has no length")
        return self.shape[0]

    def __bool__(self) -> bool:
        """Return True, whether it has a length or not."""
        return True

    def __getitem__(self, index: Any) -> Self:
        """Return part of a stack, as NumPy indexes arrays of its shape."""
        if self.shape == ():
            raise TypeError("a single wavefront cannot be indexed")

        def part(columns: Array) -> Array:
            return np.stack([column[index] for column in np.moveaxis(columns, -1, 0)], axis=-1)

        return self._each(part)

    def broadcast(self, shape: tuple[int, ...]) -> Self:
        """Return a stack of another `shape`, of at most 2^28; TypeError or ValueError if it is none for this."""
        wanted = validation.stack_shape(shape, self.shape)
        return self._each(lambda c: np.broadcast_to(c, (*wanted, c.shape[-1])).copy())

    def _each(self, change: Callable[[Array], Array], growth: float = 1.0) -> Self:
        """Return the wavefront whose coefficients went through `change`, its error `growth` times as large."""
        powers = None if self._powers is None else change(self._powers)
        return self.trusted(self.terms, change(self.edge), growth * self.error, powers)

    def flattened(self) -> Self:
        """Return the same stack with the shape ``(n,)``; a single wavefront becomes a stack of one."""
        if self.edge.ndim == 2:
            return self
        return self._each(lambda c: c.reshape(-1, c.shape[-1]).copy())

    def __add__(self, other: object) -> Self:
        """Return the sum of two wavefronts."""
        if not isinstance(other, Terms):
            return NotImplemented
        try:
            shape = np.broadcast_shapes(self.shape, other.shape)
        except ValueError:
            raise ValueError(f"wavefronts must broadcast to add, got shapes {self.shape} and {other.shape}") from None
        terms = self.terms
        if other.terms != terms:
            others = {*terms[self.symmetric :], *other.terms[other.symmetric :]}
            terms = (*symmetric_terms(max(self.symmetric, other.symmetric)), *sorted(others))
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

    def __mul__(self, factor: float) -> Self:
        """Return the wavefront times a number."""
        f = validation.real("factor", factor)
        with np.errstate(over="ignore"):  # what is not finite then is told
            return self._each(lambda c: f * c, abs(f))

    __rmul__ = __mul__
    # NumPy is not to multiply each element of an array with a wavefront, but to leave that to __rmul__.
    __array_ufunc__ = None

    def __truediv__(self, divisor: float) -> Self:
        """Return the wavefront divided by a number."""
        d = validation.real("divisor", divisor)
        if d == 0 or math.isinf(1.0 / d):
            raise ValueError(f"divisor must not be 0, nor so close to it, got {d:g}")
        return self * (1.0 / d)

    def __neg__(self) -> Self:
        """Return the conjugate wavefront."""
        return -1.0 * self

    def __sub__(self, other: object) -> Self:
        """Return the difference of two wavefronts."""
        if not isinstance(other, Terms):
            return NotImplemented
        return self + -other

    def __eq__(self, other: object) -> bool:
        """Two wavefronts are equal if their shapes, all their coefficients and their errors are."""
        if not isinstance(other, Terms):
            return NotImplemented
        if self.shape != other.shape or self.error != other.error:
            return False
        return self._content() == other._content()

    def _content(self) -> tuple[Any, ...]:
        """Return what wavefronts that are equal share: no term that is zero throughout, no sign of a zero."""
        return self.shape, *((t, (c + 0.0).tobytes()) for t, c in self.edge_terms().items() if np.any(c))

    def __hash__(self) -> int:
        """Hash what :meth:`__eq__` compares."""
        return hash(self._content())

    def __reduce__(self) -> tuple[Any, ...]:
        # Without the views, of which that of `nonradial` cannot be pickled.
        powers = None if self._powers is None else self._powers.copy()
        return type(self).trusted, (self.terms, self.edge.copy(), self.error, powers)


@lru_cache(maxsize=64)
def _symmetric(terms: tuple[tuple[int, int], ...]) -> int:
    return sum(m == 0 for _, m in terms)


@lru_cache(maxsize=64)
def _indices(terms: tuple[tuple[int, int], ...]) -> NDArray[np.int32]:
    found = np.array(terms, dtype=np.int32)
    found.flags.writeable = False
    return found


@lru_cache(maxsize=64)
def symmetric_terms(count: int) -> tuple[tuple[int, int], ...]:
    """Return (2, 0), (4, 0), ..., so many."""
    return tuple((2 * k, 0) for k in range(1, count + 1))


_FRAMEWORKS = {"jax": "JAX", "jaxlib": "JAX", "torch": "PyTorch", "cupy": "CuPy"}


def coefficients(name: str, value: ArrayLike) -> Array:
    """Return a coefficient, or an array of them.

    Raises
    ------
    TypeError
        If it is a tensor, which a wavefront would silently take out of its framework, gradients and all.
    ValueError
        If it is not real and finite.
    """
    framework = _FRAMEWORKS.get(type(value).__module__.partition(".")[0])
    if framework is not None:
        raise TypeError(
            f"{name} must be numbers or an array of NumPy, got one of {framework}, whose gradients would end here: "
            "lommel.Plan(...).traced(pupils, xp) makes PSFs of it within that framework; np.asarray(...) leaves it"
        )
    return validation.real_array(name, value)
