"""The phase across the pupil."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel import validation
from lommel.special import zernike

MAX_HIGHER = 8
"""Most coefficients beyond rho^4."""


@dataclass(frozen=True, eq=False, init=False)
class Wavefront:
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
    shape: tuple[int, ...] = field(init=False, repr=False)
    coefficients: NDArray[np.float64] = field(init=False, repr=False)

    def __init__(
        self,
        defocus: ArrayLike = 0.0,
        spherical: ArrayLike = 0.0,
        higher: Sequence[ArrayLike] = (),
        nonradial: Mapping[tuple[int, int], ArrayLike] | None = None,
    ) -> None:
        if not isinstance(higher, Sequence) or isinstance(higher, str | bytes):
            raise TypeError(f"higher must be a sequence of coefficients, got {higher!r}")
        if len(higher) > MAX_HIGHER:
            raise ValueError(f"higher must hold at most {MAX_HIGHER} coefficients, got {len(higher)}")
        object.__setattr__(self, "defocus", validation.real_array("defocus", defocus))
        object.__setattr__(self, "spherical", validation.real_array("spherical", spherical))
        rest = tuple(validation.real_array(f"higher[{i}]", c) for i, c in enumerate(higher))
        object.__setattr__(self, "higher", rest)
        others = _nonradial(nonradial) if nonradial else {}
        object.__setattr__(self, "nonradial", others)
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
    def zernike(
        cls,
        terms: Mapping[Any, ArrayLike] | Iterable[tuple[Any, ArrayLike]],
        *,
        order: str = "nm",
        unit: str = "radians",
        normalization: str = "rms",
        wavelength: float | None = None,
    ) -> Wavefront:
        """Build a wavefront from Zernike coefficients.

        Parameters
        ----------
        terms : mapping, or iterable of pairs
            Coefficients by index: pairs (n, m) for the order "nm", else integers. Arrays describe a stack.
        order : {"nm", "noll", "ansi", "fringe"}, default "nm"
            Noll counts from 1, ANSI (OSA) from 0, Fringe (University of Arizona) from 1 to 37. m > 0 is the cosine
            of m theta, m < 0 the sine.
        unit : {"radians", "waves", "metres"}, default "radians"
            Of the coefficients; metres of optical path need `wavelength`.
        normalization : {"rms", "edge"}, default "rms"
            "rms": a coefficient is the root mean square of its term over the pupil (Noll, ANSI). "edge": it is the
            largest value, that at the edge (usual with Fringe).
        wavelength : float, optional
            Metres.

        Raises
        ------
        TypeError, ValueError
            If there is no such term or a term comes twice; the message names the term.

        References
        ----------
        R. J. Noll, J. Opt. Soc. Am. 66, 207 (1976), doi:10.1364/JOSA.66.000207.

        Examples
        --------
        >>> Wavefront.zernike({7: 0.1}, order="noll", unit="waves").nonradial[3, -1]
        array(1.77715318)
        """
        scale = _radians_per(unit, wavelength)
        validation.choice("normalization", normalization, ("rms", "edge"))
        pairs = terms.items() if isinstance(terms, Mapping) else terms
        found: dict[tuple[int, int], NDArray[np.float64]] = {}
        for index, value in pairs:
            n, m = zernike.term(index, order)
            if (n, m) in found:
                raise ValueError(f"the Zernike term {index!r}, (n, m) = ({n}, {m}), comes twice")
            factor = scale * (zernike.rms_factor(n, m) if normalization == "rms" else 1.0)
            found[n, m] = factor * validation.real_array(f"the Zernike coefficient {index!r}", value)
        return cls._from_edge(found)

    @classmethod
    def _from_edge(cls, terms: Mapping[tuple[int, int], NDArray[np.float64]]) -> Wavefront:
        """Build a wavefront from coefficients in radians at the edge, radial terms among them."""
        radial = {n // 2: c for (n, m), c in terms.items() if m == 0 and n > 0}
        count = max([2, *radial])
        if count > 2 + MAX_HIGHER:
            raise ValueError(
                f"the Zernike term (n, m) = ({2 * count}, 0) is beyond the limit of n = {2 * (2 + MAX_HIGHER)} for "
                "radially symmetric ones"
            )
        matrix = zernike.legendre_to_powers(count)
        zero = np.zeros(())
        powers = [sum((matrix[k, j - 1] * c for j, c in radial.items()), zero) for k in range(count)]
        others = {term: c for term, c in terms.items() if term[1] != 0}
        return cls(0.5 * powers[0], powers[1], powers[2:], others)

    def to_zernike(
        self,
        *,
        order: str = "nm",
        unit: str = "radians",
        normalization: str = "rms",
        wavelength: float | None = None,
    ) -> dict[Any, NDArray[np.float64]]:
        """Return the Zernike coefficients, by index; the inverse of :meth:`zernike`.

        Exact but for rounding; without the constant term (piston), which a wavefront does not hold. Terms that are
        zero throughout a stack are left out.

        Raises
        ------
        ValueError
            If a term has no index in `order` (Fringe ends with 37).
        """
        scale = _radians_per(unit, wavelength)
        validation.choice("normalization", normalization, ("rms", "edge"))
        found = {}
        for (n, m), c in self.edge_terms().items():
            if np.any(c):
                factor = scale * (zernike.rms_factor(n, m) if normalization == "rms" else 1.0)
                found[zernike.index_of(n, m, order)] = c / factor
        return found

    def edge_terms(self) -> dict[tuple[int, int], NDArray[np.float64]]:
        """Return all Zernike coefficients, radians at the edge, by (n, m), without the constant."""
        legendre = self.coefficients @ zernike.powers_to_legendre(self.coefficients.shape[-1])[1:].T
        radial = {(2 * k + 2, 0): legendre[..., k] for k in range(legendre.shape[-1])}
        return radial | dict(self.nonradial)

    @property
    def radial(self) -> bool:
        """Whether the phase depends on rho only."""
        return not self.nonradial

    @classmethod
    def from_seidel(
        cls,
        W020: ArrayLike = 0.0,
        W040: ArrayLike = 0.0,
        W060: ArrayLike = 0.0,
        W080: ArrayLike = 0.0,
        *,
        W131: ArrayLike = 0.0,
        W222: ArrayLike = 0.0,
        W220: ArrayLike = 0.0,
        W311: ArrayLike = 0.0,
        field: tuple[ArrayLike, ArrayLike] = (1.0, 0.0),
    ) -> Wavefront:
        """Build a wavefront from Seidel wavefront coefficients in waves at the edge of the pupil.

        ``W = W020 rho^2 + W040 rho^4 + W131 H rho^3 cos(phi) + W222 H^2 rho^2 cos^2(phi) + W220 H^2 rho^2
        + W311 H^3 rho cos(phi)``, with H the length of `field` and phi the angle from its direction.
        ``C_d = pi W020`` and ``C_s = 2 pi W040``: W020 waves of defocus are ``2 pi W020 rho^2`` radians.

        Parameters
        ----------
        W020, W040, W060, W080 : array_like
            Defocus and spherical aberration, waves.
        W131, W222, W220, W311 : array_like
            Coma, astigmatism, field curvature and distortion, waves at the edge of the field (H = 1).
        field : (array_like, array_like), default (1, 0)
            Position in the field as (x, y), columns and rows, over that of the edge. Arrays describe a stack.

        References
        ----------
        W. T. Welford, Aberrations of Optical Systems (1986), doi:10.1201/9780203755327, section 8.2.
        """
        waves = {"W020": W020, "W040": W040, "W060": W060, "W080": W080}
        waves |= {"W131": W131, "W222": W222, "W220": W220, "W311": W311}
        w = {name: 2 * math.pi * validation.real_array(name, value) for name, value in waves.items()}
        if not isinstance(field, tuple | list) or len(field) != 2:
            raise TypeError(f"field must be a pair (x, y), got {field!r}")
        x, y = validation.real_array("field[0]", field[0]), validation.real_array("field[1]", field[1])
        higher = [w["W060"], w["W080"]]
        while higher and not np.any(higher[-1]):
            higher.pop()
        try:
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
            raise ValueError(
                f"the coefficients and field must broadcast, got field of shapes {x.shape} and {y.shape}"
            ) from None
        return cls(0.5 * defocus, w["W040"], higher, {term: c for term, c in terms.items() if np.any(c)})

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

    def _each(self, change: Any) -> Wavefront:
        """Return the wavefront whose every coefficient went through `change`."""
        rest = tuple(change(c) for c in self.higher)
        return Wavefront(
            change(self.defocus), change(self.spherical), rest, {t: change(c) for t, c in self.nonradial.items()}
        )

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
        )

    def __mul__(self, factor: float) -> Wavefront:
        """Return the wavefront times a number."""
        f = validation.real("factor", factor)
        return self._each(lambda c: f * c)

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
        if self.shape != other.shape:
            return False
        difference = self - other
        return not np.any(difference.coefficients) and not any(np.any(c) for c in difference.nonradial.values())

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        parts = {"defocus": self.defocus, "spherical": self.spherical}
        shown = [f"{name}={_short(value)}" for name, value in parts.items()]
        if self.higher:
            shown.append(f"higher=({', '.join(_short(c) for c in self.higher)},)")
        if self.nonradial:
            shown.append(f"nonradial={{{', '.join(f'{t}: {_short(c)}' for t, c in self.nonradial.items())}}}")
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
        return plain

    @classmethod
    def from_dict(cls, description: Mapping[str, Any]) -> Wavefront:
        """Rebuild a wavefront from :meth:`to_dict`."""
        parts = dict(description)
        terms = {(n, m): value for n, m, value in parts.pop("nonradial", [])}
        return cls(**parts, nonradial=terms)


def _nonradial(terms: Mapping[Any, ArrayLike]) -> Mapping[tuple[int, int], NDArray[np.float64]]:
    if not isinstance(terms, Mapping):
        raise TypeError(f"nonradial must map (n, m) to coefficients, got {terms!r}")
    found: dict[tuple[int, int], NDArray[np.float64]] = {}
    for key in terms:
        n, m = zernike.term(key, "nm")
        if m == 0:
            raise ValueError(f"nonradial must hold terms with m != 0, got {(n, m)}; Wavefront.zernike takes all")
        found[n, m] = validation.real_array(f"nonradial[{n}, {m}]", terms[key])
    return dict(sorted(found.items()))


def _radians_per(unit: str, wavelength: float | None) -> float:
    validation.choice("unit", unit, ("radians", "waves", "metres"))
    if unit != "metres":
        return 1.0 if unit == "radians" else 2.0 * math.pi
    if wavelength is None:
        raise ValueError('unit="metres" needs the wavelength, in metres')
    return 2.0 * math.pi / validation.wavelength(wavelength)


def _short(value: NDArray[np.float64]) -> str:
    if value.ndim == 0:
        return repr(float(value))
    return f"<array {value.shape} from {value.min():g} to {value.max():g}>"
