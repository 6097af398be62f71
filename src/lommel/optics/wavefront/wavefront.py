"""The phase across the pupil."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Never, Self

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.cached import cached_property, made
from lommel.optics.wavefront.descriptions import Descriptions
from lommel.optics.wavefront.terms import coefficients, symmetric_terms
from lommel.special import zernike

_FAR = 1e3  # the pupil ends at 1; beyond this, powers of rho overflow
_PARABOLA = symmetric_terms(2)
MAX_HIGHER = 8
"""Most coefficients beyond rho^4."""


@dataclass(frozen=True, eq=False, init=False, repr=False)
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

    def __init__(
        self,
        defocus: ArrayLike = 0.0,
        spherical: ArrayLike = 0.0,
        higher: Sequence[ArrayLike] = (),
        nonradial: Mapping[tuple[int, int], ArrayLike] | None = None,
        error: float = 0.0,
        **_unknown: Never,
    ) -> None:
        if _unknown:
            raise TypeError(
                f"Wavefront has no argument {next(iter(_unknown))!r}; other aberrations are made by "
                "Wavefront.zernike({(3, 1): ...}) or Wavefront.from_seidel(W131=...)"
            )
        if not isinstance(higher, Sequence) or isinstance(higher, str | bytes):
            raise TypeError(f"higher must be a sequence of coefficients, got {validation.shown(higher)}")
        if len(higher) > MAX_HIGHER:
            raise ValueError(f"higher must hold at most {MAX_HIGHER} coefficients, got {len(higher)}")
        with np.errstate(over="ignore"):
            double = 2.0 * coefficients("defocus", defocus)
        columns = [validation.real_array("twice the defocus", double), coefficients("spherical", spherical)]
        columns += [coefficients(f"higher[{i}]", c) for i, c in enumerate(higher)]
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
        self._set((*symmetric_terms(len(columns)), *others), edge, validation.real("error", error, least=0.0), powers)

    @classmethod
    def of_defocus(cls, defocus: float | Array) -> Self:
        """Build a wavefront from a checked C_d, `defocus`, radians."""
        if isinstance(defocus, float) and math.isfinite(2.0 * defocus):
            # As below, bit by bit, but without what arrays of two numbers cost.
            powers, edge = np.zeros(2), np.zeros(2)
            powers[0], edge[0] = 2.0 * defocus, defocus + 0.0
            powers.setflags(write=False)
            edge.setflags(write=False)
            parts = {"terms": _PARABOLA, "edge": edge, "error": 0.0, "_powers": powers, "shape": (), "symmetric": 2}
            return made(cls, parts)
        defocus = np.asarray(defocus)
        powers = np.zeros((*defocus.shape, 2))
        with np.errstate(over="ignore"):  # told, as all that is not finite
            powers[..., 0] = 2.0 * defocus
        return cls.trusted(symmetric_terms(2), np.empty_like(powers), 0.0, powers)

    @cached_property
    def defocus(self) -> Array:
        """C_d, radians."""
        half = np.asarray(0.5 * self.coefficients[..., 0])
        half.flags.writeable = False
        return half

    @property
    def spherical(self) -> Array:
        """C_s, radians."""
        return np.asarray(self.coefficients[..., 1])

    @property
    def higher(self) -> tuple[Array, ...]:
        """Coefficients of rho^6, rho^8, ..., radians."""
        return tuple(np.moveaxis(self.coefficients[..., 2:], -1, 0))

    @cached_property
    def nonradial(self) -> Mapping[tuple[int, int], Array]:
        """Coefficients of the other terms, radians at the edge, by (n, m)."""
        others = enumerate(self.terms[self.symmetric :], self.symmetric)
        return MappingProxyType({term: np.asarray(self.edge[..., j]) for j, term in others})

    @property
    def radial(self) -> bool:
        """Whether the phase depends on rho only: no other term, or none but zeros."""
        return self.symmetric == len(self.terms) or not self.edge[..., self.symmetric :].any()

    @property
    def waves(self) -> dict[str, Array]:
        """Seidel coefficients W020, W040, W060, ... in waves: the radially symmetric part."""
        names = [f"W0{2 * k}0" for k in range(1, 1 + self.coefficients.shape[-1])]
        return {name: self.coefficients[..., k] / (2 * math.pi) for k, name in enumerate(names)}

    def phase(self, rho: ArrayLike, theta: ArrayLike = 0.0) -> Array:
        """Return the phase at points of the pupil.

        Parameters
        ----------
        rho : array_like
            Pupil radius, 0 to 1.
        theta : array_like, default 0
            Angle, radians from x towards y.

        Returns
        -------
        ndarray, shape ``shape + s``
            Radians; s is what `rho` and `theta` broadcast to.

        Raises
        ------
        TypeError, ValueError
            If they are not real and finite, do not broadcast, or a radius is negative or above 1000.
        """
        points = validation.real_array("rho", rho, least=0.0), validation.real_array("theta", theta)
        r, angle = validation.broadcast("rho and theta", *points)
        if r.size and r.max() > _FAR:
            raise ValueError(f"rho must be at most {_FAR:g}, got {r.max():g}")
        at = (1,) * r.ndim
        total = zernike.legendre_sum(self.radial_terms, 2.0 * r * r - 1.0)
        for (n, m), c in self.nonradial.items():
            total += c.reshape(self.shape + at) * zernike.polynomial(n, m, r, angle)
        return total

    def _shape_with(self, name: str, each: Array) -> tuple[int, ...]:
        """Return the shape of the stack and of what each of it has a value of; ValueError if there is none."""
        try:
            return np.broadcast_shapes(self.shape, each.shape)
        except ValueError:
            raise ValueError(f"{name} must broadcast with the stack, got {each.shape} and {self.shape}") from None

    def rotated(self, angle: ArrayLike) -> Self:
        """Return the wavefront turned from x towards y: clockwise in a picture.

        ``phase'(rho, theta) = phase(rho, theta - angle)``, and the image turns by the same angle. Exact but for
        rounding: each pair of terms (n, m) and (n, -m) turns in its plane by m times the angle. Arrays of angles
        broadcast with the stack.

        Parameters
        ----------
        angle : array_like
            Radians.

        Returns
        -------
        Wavefront

        Raises
        ------
        TypeError, ValueError
            If an angle is not real and finite, or they do not broadcast.
        """
        turn = validation.real_array("angle", angle)
        shape = self._shape_with("angle", turn)
        powers = None if self._powers is None else _broadcast(self._powers, shape)
        edge = _broadcast(self.edge, shape)
        turned = zernike.rotated(dict(self.nonradial), turn)
        terms = (*self.terms[: self.symmetric], *sorted(turned))
        edge = np.stack([*np.moveaxis(edge, -1, 0)[: self.symmetric], *(turned[t] for t in sorted(turned))], axis=-1)
        return self.trusted(terms, edge, self.error, powers)

    def flipped(self, axis: str) -> Self:
        """Return the mirror image. Exact.

        Parameters
        ----------
        axis : {"x", "y"}
            What changes its sign: left and right, or up and down.

        Returns
        -------
        Wavefront

        Raises
        ------
        ValueError
            If it is neither.
        """
        validation.choice("axis", axis, ("x", "y"))

        def sign(m: int) -> float:
            # theta -> -theta for "y", pi - theta for "x".
            return (1.0 if m > 0 else -1.0) * (-1.0 if axis == "x" and m % 2 else 1.0)

        signs = np.array([sign(m) if m else 1.0 for _, m in self.terms])
        return self.trusted(self.terms, signs * self.edge, self.error, self._powers)

    def scaled(self, radius: ArrayLike) -> Self:
        """Return the wavefront across a smaller, concentric pupil: ``phase'(rho, theta) = phase(radius rho, theta)``.

        Exact but for rounding, and but for the constant. Arrays of radii broadcast with the stack.

        Parameters
        ----------
        radius : array_like
            Radius of the smaller pupil over that of this one, above 0 and at most 1.

        Returns
        -------
        Wavefront

        Raises
        ------
        TypeError, ValueError
            If a radius is out of range, or they do not broadcast.

        References
        ----------
        A. J. E. M. Janssen and P. Dirksen, "A concise formula for the Zernike coefficients of scaled pupils",
        J. Microlith. Microfab. Microsyst. 5, 030501 (2006).
        """
        eps = validation.real_array("radius", radius)
        if not np.all((eps > 0.0) & (eps <= 1.0)):
            bad = eps[~((eps > 0.0) & (eps <= 1.0))].flat[0]
            raise ValueError(f"radius must be > 0 and <= 1, got {bad:g}")
        shape = self._shape_with("radius", eps)
        found = zernike.scaled(self.edge_terms(), np.broadcast_to(eps, shape))
        terms = (*symmetric_terms(self.symmetric), *sorted(term for term in found if term[1]))
        edge = np.stack([np.broadcast_to(found[term], shape) for term in terms], axis=-1)
        powers = None
        if self._powers is not None:
            powers = self._powers * eps[..., None] ** (2.0 * np.arange(1, 1 + self.symmetric))
        return self.trusted(terms, edge, self.error, powers)

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
    def from_dict(cls, description: Mapping[str, Any]) -> Self:
        """Rebuild a wavefront from a `description` by :meth:`to_dict`; TypeError or ValueError if it is none."""
        parts = dict(description)
        if "terms" in parts:
            found = {zernike.check_term(n, m): c for (n, m), c in _once("terms", parts.pop("terms")).items()}
            checked = {(n, m): validation.real_array(f"terms[{n}, {m}]", c) for (n, m), c in found.items()}
            return cls.from_edge(checked, validation.real("error", parts.pop("error", 0.0), least=0.0), **parts)
        others = _once("nonradial", parts.pop("nonradial", []))
        return cls(**parts, nonradial=others)


def _once_or_all(value: Array) -> Any:
    return float(value.flat[0]) if value.min() == value.max() else value.tolist()


def _once(name: str, listed: Iterable[Sequence[Any]]) -> dict[tuple[int, int], Any]:
    terms: dict[tuple[int, int], Any] = {}
    for n, m, value in listed:
        if (n, m) in terms:
            raise ValueError(f"{name} holds the term (n, m) = ({n}, {m}) twice")
        terms[n, m] = value
    return terms


def _broadcast(columns: Array, shape: tuple[int, ...]) -> Array:
    return np.broadcast_to(columns, (*shape, columns.shape[-1])).copy()


def _nonradial(terms: Mapping[Any, ArrayLike]) -> Mapping[tuple[int, int], Array]:
    if not isinstance(terms, Mapping):
        raise TypeError(f"nonradial must map (n, m) to coefficients, got {validation.shown(terms)}")
    found: dict[tuple[int, int], Array] = {}
    for key in terms:
        n, m = zernike.term(key, "nm")
        if m == 0:
            raise ValueError(f"nonradial must hold terms with m != 0, got {(n, m)}; Wavefront.zernike takes all")
        found[n, m] = coefficients(f"nonradial[{n}, {m}]", terms[key])
    return dict(sorted(found.items()))


def _listed(terms: Mapping[tuple[int, int], Array]) -> str:
    return f"{{{', '.join(f'{t}: {_short(c)}' for t, c in terms.items())}}}"


def _short(value: Array, *, shape: bool = False) -> str:
    if value.ndim == 0 or (not shape and value.min() == value.max()):
        return repr(float(value.flat[0]))
    return f"<array {value.shape} from {value.min():g} to {value.max():g}>"


def same_path(wavefront: Wavefront, known: float, wavelength: float) -> Wavefront:
    """Return a wavefront known at one wavelength as it is at another.

    Phases are optical path differences, which stay: in radians they grow as the wavelength falls. Dispersion is left
    out.

    Parameters
    ----------
    wavefront : Wavefront
    known, wavelength : float
        Metres.

    Returns
    -------
    Wavefront
    """
    return known / wavelength * wavefront
